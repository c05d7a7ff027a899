# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counts in closed form: areas of drawn figures, worked out by hand, and the exact simulation.

Pixels are 1 mm wide where nothing else is said, so that a count is an area in mm^2.
"""

from __future__ import annotations

from math import asin, cos, pi, sin, sqrt

import numpy as np
import pytest
from zbuffer_inputs import toolpath as of_points

from vkworkbench.core import Stock, Strategy, Tool, View
from vkworkbench.core.gcode import linearize
from vkworkbench.core.recognition import Recognition
from vkworkbench.core.zbuffer.cost.closed_form import cauchy_crofton, closed_form, swept
from vkworkbench.language import Message

STOCK = Stock((0, 0, 0), (80, 60, 20))
FLAT, BALL = Tool("endmill", 6), Tool("ballend", 6)
VEE = Tool("vbit", 6, tip_angle=pi / 2)
ROUND = 9 * pi  # the foot of FLAT
TOP = (0.0, 0.0, -1.0)


def area(toolpath, strategy, *, tool=FLAT, stock=STOCK, direction=TOP, pixel=1.0, **known):
    found = Recognition(strategy, 1.0, Message("no-moves"), **known)
    return closed_form(toolpath, found, tool=tool, stock=stock, view=View(direction, pixel=pixel))


def path(points):
    return of_points(np.array(points, float))


def rows(*lines, z=15):
    """Rows from (x, y) to (x, y), the tool in the air between them."""
    points = []
    for (x0, y0), (x1, y1) in lines:
        points += [(x0, y0, 25), (x0, y0, z), (x1, y1, z), (x1, y1, 25)]
    return path(points)


def along_x(*heights, left=10, right=70, z=15):
    return rows(*(((left, y), (right, y)) for y in heights), z=z)


def rectangle(width, height, z=15):
    """A contour about the middle of the stock."""
    x, y = width / 2, height / 2
    return [(40 + u * x, 30 + v * y, z) for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))]


def stripe(step, radius=3.0):
    """Area of a circle between two lines `step` apart, about its middle."""
    return step * sqrt(radius**2 - step**2 / 4) + 2 * radius**2 * asin(step / (2 * radius))


# A circle of a ring's tool: what lies within `step` / 2 of the row, and the grown hull's rounded corners in 64 sides.
CORNERS = 64 * np.tan(pi / 64) * 9


@pytest.mark.parametrize(
    ("points", "expected"),
    [
        ([(10, 30, 25), (10, 30, 15), (50, 30, 15)], ROUND + 6 * 40),
        ([(-40, 30, 15), (40, 30, 15)], 6 * 80 / 2),
        ([(40, 60, 15), (120, 60, 15)], 6 * 80 / 4),
        ([(-40, 0, 15), (40, 0, 15)], 6 * 80 / 4),
        ([(10 + 0.5 * k, 30, 15) for k in range(9)], 6 * 4),
        ([(10, 30, 20), (50, 30, 20)], 0),
        ([(10, 90, 15), (50, 90, 15)], 0),
    ],
    ids=["plunge and row", "half beside", "upper corner", "lower corner", "short moves", "on the stock", "beside"],
)
def test_blind_to_the_strategy_every_move_cuts_its_width_where_stock_is(points, expected):
    assert swept(path(points), tool=FLAT, stock=STOCK, view=View(pixel=1.0)) == pytest.approx(expected)
    assert swept(path(points), tool=FLAT, stock=STOCK, view=View(pixel=0.5)) == pytest.approx(4 * expected)


@pytest.mark.parametrize(
    ("theta", "projected"), [(0.0, 30), (pi / 2, 40), (np.arctan2(4, 3), 50), (np.arctan2(-3, 4), 0)]
)
def test_cauchy_crofton_in_one_direction(theta, projected):
    there_and_back = path([(10, 10, 5), (40, 50, 5), (10, 10, 5)])
    found = cauchy_crofton(there_and_back, stock=STOCK, view=View(pixel=0.5), direction=theta)
    assert found == pytest.approx(2 * projected / 0.5)


def test_the_mean_of_all_directions_is_the_one_without():
    thetas = np.linspace(0, pi, 2000, endpoint=False)
    bent = path([(10, 10, 5), (40, 50, 5), (60, 20, 5)])
    one_each = [cauchy_crofton(bent, stock=STOCK, view=View(pixel=0.5), direction=theta) for theta in thetas]
    assert np.mean(one_each) == pytest.approx(cauchy_crofton(bent, stock=STOCK, view=View(pixel=0.5)), rel=1e-5)


def test_cauchy_crofton_is_the_projected_length_below_the_top_of_the_stock():
    view = View(pixel=0.5)
    below = [(10, 10, 5), (40, 50, 5)]
    assert cauchy_crofton(path(below), stock=STOCK, view=view) == pytest.approx(50 * 2 / pi / 0.5)
    on_top = [(70, 10, 20), (10, 10, 20), *below, (40, 50, 20), (70, 50, 20)]  # from above a plunge has no length
    assert cauchy_crofton(path(on_top), stock=STOCK, view=view) == pytest.approx(50 * 2 / pi / 0.5)
    for entered in ([(70, 10, 22), *below], [*below[::-1], (70, 10, 22)], [(70, 10, 22), *below, (40, 110, 22)]):
        length = np.hypot(*np.diff(np.array(entered)[:, :2], axis=0).T).sum()
        assert cauchy_crofton(path(entered), stock=STOCK, view=view) == pytest.approx(length * 2 / pi / 0.5)


def test_cauchy_crofton_from_the_front_sees_heights():
    there = path([(10, 10, 2), (22, 50, 18)])
    assert cauchy_crofton(there, stock=STOCK, view=View((0, 1, 0), pixel=1.0)) == pytest.approx(20 * 2 / pi)


def test_nothing_below_the_top_is_nothing():
    assert area(path([(10, 30, 25), (50, 30, 21)]), Strategy.ZIGZAG) == 0


def test_rows_beside_the_stock_are_nothing():
    beside = path([(100, 10, 15), (150, 10, 15), (150, 13, 15), (100, 13, 15)])
    assert area(beside, Strategy.ZIGZAG, stepover=3.0) == 0


def test_pixels_of_half_the_width_are_four_times_as_many():
    for direction in (TOP, (0, 1, -1)):
        found = [area(along_x(20, 24), Strategy.ZIGZAG, direction=direction, pixel=pixel) for pixel in (1.0, 0.5)]
        assert found[1] == pytest.approx(4 * found[0])


def test_where_the_part_lies_does_not_matter():
    """All of it moved aside, down, and to where X or Y are negative: rows, loops, holes and a ball's rows over an edge."""
    beside = np.array((30, 5, 0))
    for toolpath, strategy, tool in (
        (along_x(20, 24), Strategy.ZIGZAG, FLAT),
        (along_x(20, 22, 24), Strategy.ZIGZAG, BALL),
        (path(np.array(rectangle(60, 40)) + beside), Strategy.SPIRAL, FLAT),
        (path([(20, 20, 22), (20, 20, 14)]), Strategy.DRILLING, FLAT),
    ):
        there = area(toolpath, strategy, tool=tool)
        for by in ((-100, 50, -7), (30, -200, 40)):
            stock = Stock(np.array(STOCK.lower) + by, np.array(STOCK.upper) + by)
            assert area(path(toolpath.points + by), strategy, tool=tool, stock=stock) == pytest.approx(there), by


def test_rows_are_as_wide_as_their_step_and_the_first_as_the_tool():
    """Rows of 60 mm, 4 mm apart: 60 by 6 + 4 n - 4 mm and at each end a stripe of the tool's circle."""
    assert area(along_x(20, 24), Strategy.ZIGZAG) == pytest.approx(60 * 10 + 2 * stripe(4))
    # In any direction, the whole of it over the stock.
    for angle in (0.4, 1.2, -0.5):
        along, across = np.array((cos(angle), sin(angle))) * 20, np.array((-sin(angle), cos(angle))) * 2
        slanted = rows(*(((40, 30) + k * across - along, (40, 30) + k * across + along) for k in (-1, 1)))
        assert area(slanted, Strategy.ZIGZAG) == pytest.approx(40 * 10 + 2 * stripe(4))
    # To and fro as well, and with half of it beside the stock.
    to_and_fro = [((10, 20), (70, 20)), ((70, 24), (10, 24)), ((10, 28), (70, 28))]
    assert area(rows(*to_and_fro), Strategy.ZIGZAG) == pytest.approx(60 * 14 + 3 * stripe(4))
    half = along_x(10, 14, 40, 44, left=-40, right=40)
    assert area(half, Strategy.ZIGZAG) == pytest.approx(40 * 16 + 4 * stripe(4) + 2 * 160 / 4)
    # As far apart as the tool is wide: side by side.
    assert area(along_x(20, 26), Strategy.ZIGZAG, stepover=3) == pytest.approx(60 * 12 + 2 * ROUND)
    assert area(along_x(20, 24, 28, 32), Strategy.ONE_WAY, stepover=5) == pytest.approx(60 * 18 + 4 * stripe(4))


def test_each_level_is_cut_once_and_a_hole_to_no_level_besides():
    one, two = along_x(20, 24), along_x(20, 24, z=12)
    both = path([*one.points, *two.points])
    assert area(both, Strategy.ZIGZAG) == pytest.approx(2 * area(one, Strategy.ZIGZAG))
    drilled = path([*one.points, (40, 40, 25), (40, 40, 13), (40, 40, 25)])
    assert area(drilled, Strategy.ZIGZAG) == pytest.approx(area(one, Strategy.ZIGZAG) + ROUND)


def test_the_step_is_that_of_the_rows_of_one_pocket():
    """Two pockets whose rows lie between each other's, and rows cut to and fro: 4 mm in both."""
    left, right = (along_x(*np.arange(5) * 4 + first, left=at, right=at + 20) for first, at in ((10, 10), (12, 50)))
    pockets = area(path([*left.points, *right.points]), Strategy.ZIGZAG)
    rows_apart = 4 * (20 * 10) + 10 * stripe(4) + 2 * 20 * 10 / 10
    assert pockets == pytest.approx(rows_apart)
    assert area(along_x(10, 30, 14, 34), Strategy.ZIGZAG) == pytest.approx(4 * 240 + 4 * stripe(4) + 2 * 240 / 4)


def test_rows_of_two_directions_cross_without_regard_to_each_other():
    lines = [((20, y), (60, y)) for y in (10, 20, 30, 40, 50)] + [((x, 10), (x, 50)) for x in (20, 30, 40, 50, 60)]
    one, room = 5 * (6 * 40 + ROUND), 40 * 40 + 4 * 40 * 3 + CORNERS
    expected = room * (1 - (1 - one / room) ** 2)
    assert area(rows(*lines), Strategy.ZIGZAG, stepover=6) == pytest.approx(expected, rel=1e-6)
    assert area(rows(*lines), Strategy.MIXED, stepover=9) == pytest.approx(expected, rel=1e-6)
    # Nearly what two combs of stadiums have in common is counted once.
    assert expected == pytest.approx(2 * one - 25 * 36, rel=0.03)


def test_rows_that_are_cut_twice_cover_no_more_than_there_is():
    lines = [((20, y), (60, y)) for y in range(10, 51, 4)] + [((x, 10), (x, 50)) for x in range(20, 61, 4)]
    room = 40 * 40 + 4 * 40 * 3 + CORNERS
    assert area(rows(*lines, *lines), Strategy.ZIGZAG, stepover=4) == pytest.approx(room)


def test_links_are_no_rows():
    """Links of 4 mm between rows of 60 mm, and 9 mm between rows of 40 mm: less and more than 15 % of the way."""
    linked = [(10, 20, 15), (70, 20, 15), (70, 24, 15), (10, 24, 15)]
    assert area(path(linked), Strategy.ZIGZAG) == pytest.approx(60 * 10 + 2 * stripe(4))
    with_two = path([(10, 20, 15), (20, 20, 15), (20, 24, 15), (10, 24, 15)])
    room = 10 * 4 + 2 * 14 * 3 + CORNERS
    shares = [(10 * 10 + 2 * stripe(4)) / room, (6 * 4 + ROUND) / room]
    expected = room * (1 - (1 - shares[0]) * (1 - shares[1]))
    assert area(with_two, Strategy.ZIGZAG, stepover=6) == pytest.approx(expected, rel=1e-6)


def test_a_single_row_is_as_wide_as_the_tool():
    assert area(along_x(20), Strategy.ZIGZAG) == pytest.approx(6 * 60 + ROUND)


def test_loops_are_as_wide_as_their_stepover_and_the_outermost_as_the_tool():
    """Contours of 60 by 40 and 52 by 32 mm: 4 mm for each, and 1 mm more around the first."""
    toolpath = path([*rectangle(60, 40), *rectangle(52, 32)])
    for strategy in (Strategy.CONTOUR_PARALLEL, Strategy.SPIRAL, Strategy.ADAPTIVE):
        found = area(toolpath, strategy, stepover=4)
        link = sqrt(4**2 + 4**2)
        assert found == pytest.approx(4 * (200 + 168 + link) + (3 - 2) * 200, rel=1e-3)


def test_loops_without_a_stepover_fill_the_room_around_them():
    """The hull grown by the tool, cut to the stock: 60 by 40 mm and 3 mm more on each side; 80 by 50 where it is less."""
    four = path([corner for inset in (0, 8, 16, 24) for corner in rectangle(60 - inset, 40 - inset)])
    assert area(four, Strategy.SPIRAL) == pytest.approx(60 * 40 + 2 * (60 + 40) * 3 + CORNERS)
    wide = path([corner for inset in range(0, 32, 4) for corner in rectangle(90 - inset, 44 - inset)])
    assert area(wide, Strategy.SPIRAL, stepover=6) == pytest.approx(80 * 50)


def test_a_stepover_wider_than_the_tool_is_the_tool():
    once = path(rectangle(60, 40))
    assert area(once, Strategy.SPIRAL, stepover=20) == pytest.approx(6 * 200)


def test_passes_side_by_side_are_one_tool_and_their_steps_on_each_level():
    """Two contours 2 mm apart on each of two levels: the second adds its 2 mm."""
    level = [*rectangle(60, 40), *rectangle(56, 36)]
    link = sqrt(2**2 + 2**2)
    points = [*level, (*level[-1][:2], 25), (*level[0][:2], 25), *((x, y, 12) for x, y, _ in level)]
    length = 200 + 184 + link
    found = area(path(points), Strategy.PROFILE, stepover=2, passes=4, depths=2)
    assert found == pytest.approx(2 * (2 * length + 4 * length / 2))
    assert area(path(rectangle(60, 40)), Strategy.PROFILE) == pytest.approx(6 * 200)
    # One pass where nobody says how many.
    assert area(path(rectangle(60, 40)), Strategy.PROFILE, stepover=2) == pytest.approx(6 * 200)
    two = path([*rectangle(60, 40), *rectangle(56, 36)])
    assert area(two, Strategy.PROFILE, stepover=2, passes=2, depths=1) == pytest.approx(2 * length + 4 * length / 2)
    half_beside = path([(-40, 30, 15), (40, 30, 15)])
    assert area(half_beside, Strategy.PROFILE) == pytest.approx(6 * 80 / 2)


def test_a_contour_of_short_moves_is_that_of_long_ones():
    """A circle of 126 chords of half a millimetre."""
    angle = 2 * pi * np.arange(127) / 126
    circle = path(np.column_stack((40 + 10 * np.cos(angle), 30 + 10 * np.sin(angle), np.full(127, 15))))
    assert area(circle, Strategy.PROFILE) == pytest.approx(6 * 20 * pi, rel=1e-3)


def test_a_hole_is_cut_anew_where_it_is_deeper():
    pecked = [(20, 20, 22), (20, 20, 14), (20, 20, 21), (20, 20, 14), (20, 20, 21), (20, 20, 9), (20, 20, 22)]
    other = [(60, 20, 22), (60, 20, 10), (60, 20, 22), (20, 20, 22), (20, 20, 12), (20, 20, 22)]
    assert area(path(pecked), Strategy.DRILLING) == pytest.approx(2 * ROUND)
    assert area(path([*pecked, *other]), Strategy.DRILLING) == pytest.approx(3 * ROUND)
    at_the_edge = path([(80, 20, 22), (80, 20, 14)])
    assert area(at_the_edge, Strategy.DRILLING) == pytest.approx(ROUND / 2)
    dwelling = path([(20, 20, 22), (20, 20, 14), (20, 20, 14), (20, 20, 22)])
    assert area(dwelling, Strategy.DRILLING) == pytest.approx(ROUND)


def test_a_ramp_cuts_its_foot_and_its_way():
    assert area(path([(20, 20, 19), (50, 20, 10)]), Strategy.UNKNOWN) == pytest.approx(ROUND + 6 * 30)


def helices(*radii, at=(40.0,) * 5):
    commands = []
    for radius, x in zip(radii, at):
        commands += [("G0", {"Z": 25.0}), ("G0", {"X": x + radius, "Y": 30.0}), ("G0", {"Z": 20.0})]
        for half in range(1, 5):
            side = radius * (-1) ** half
            commands.append(("G3", {"X": x + side, "Y": 30.0, "Z": 20.0 - half, "I": side, "J": 0.0}))
    return linearize(commands)


def beside_ring(radius, ring):
    """Share of a tool's circle, its middle `radius` from the hole's, that lies within no more than 3 mm of a ring."""
    x, y = np.mgrid[-3:3:601j, -3:3:601j]
    foot = x**2 + y**2 < 9
    return float((np.abs(np.hypot(x + radius, y) - ring)[foot] >= 3).mean())


@pytest.mark.parametrize(
    ("first", "second"), [(8.0, 11.0), (8.0, 4.0), (2.0, 4.0), (2.0, 1.5), (2.0, 9.0), (4.0, 0.7), (5.0, 5.2)]
)
def test_a_helix_cuts_beside_the_ring_of_the_one_before(first, second):
    toolpath = helices(first, second)
    move = np.diff(toolpath.points, axis=0)
    down = (move[:, 2] < 0) & (toolpath.sweep != 0)
    each = ROUND + 6 * np.hypot(move[:, 0], move[:, 1])
    share = np.where(np.arange(len(move)) > np.flatnonzero(toolpath.rapid)[-1], beside_ring(second, first), 1.0)
    assert area(toolpath, Strategy.HELIX) == pytest.approx((each * share)[down].sum(), rel=2e-3)


def test_a_helix_in_another_hole_finds_nothing_cut():
    one, two = helices(5.0), helices(5.0, 4.0, at=(36.0, 44.0))
    alone = area(helices(4.0), Strategy.HELIX)
    assert area(two, Strategy.HELIX) == pytest.approx(area(one, Strategy.HELIX) + alone)


@pytest.mark.parametrize(
    ("direction", "points", "expected"),
    [
        ((0, 1, 0), [(10, 30, 15), (50, 30, 15)], 5 * (40 + 6)),
        ((1, 0, 0), [(10, 30, 15), (50, 30, 15)], 5 * 6),
        ((1, 0, 0), [(40, 10, 15), (40, 40, 15)], 5 * (30 + 6)),
        ((0, 1, 0), [(-40, 30, 15), (40, 30, 15)], 5 * (80 + 6) / 2),
        ((0, -1, 0), [(10, 30, 15), (50, 30, 15), (50, 30, 12), (10, 30, 12)], 5 * 46 + 3 * (46 + 6)),
        ((1, 1, 0), [(10, 30, 15), (50, 30, 15)], 5 * (40 * sqrt(0.5) + 6)),
        ((1, 1, 0), [(10, 10, 15), (40, 40, 15)], 5 * 6),
        ((1, 1, 0), [(10, 40, 15), (40, 10, 15)], 5 * (30 * sqrt(2) + 6)),
    ],
)
def test_from_the_side_walls_are_seen_as_high_as_their_level_is_below_the_one_above(direction, points, expected):
    assert area(path(points), Strategy.PROFILE, direction=direction) == pytest.approx(expected)


def test_with_a_stepover_less_of_a_wall_is_seen():
    """Half of the tool engaged: a quarter of its rim cuts, whose mean width all around is half of the tool's."""
    row = path([(10, 30, 15), (50, 30, 15)])
    assert area(row, Strategy.PROFILE, stepover=3, direction=(0, 1, 0)) == pytest.approx(5 * (40 + 3))


def test_obliquely_floors_and_walls_are_seen():
    row = path([(10, 30, 15), (50, 30, 15)])
    for down in (-1, 1):
        found = area(row, Strategy.PROFILE, direction=(0, sin(0.5), down * cos(0.5)))
        assert found == pytest.approx(6 * 40 * cos(0.5) + 5 * 46 * sin(0.5))


def ball_row(stepover):
    """Ahead of a ball of 3 mm: what the row before did not cut, by numeric integration, and the width it widens."""
    side = min(3.0, stepover / 2)
    y = np.linspace(-side, 3, 20001)
    ahead = np.sqrt(np.maximum(np.minimum(3.0, np.abs(y + stepover)) ** 2 - y**2, 0))
    return float(((ahead[1:] + ahead[:-1]) / 2).sum() * (y[1] - y[0])), side + 3


@pytest.mark.parametrize(
    ("points", "slowed"),
    [
        ([(10, 30, 15), (50, 30, 15)], 1.0),
        ([(10, 30, 5), (40, 30, 15)], 1 - 1 / sqrt(10)),
        ([(40, 30, 15), (10, 30, 5)], 1 + 1 / sqrt(10)),
        ([(40, 30, 15), (40, 30, 5)], 2.0),
    ],
    ids=["level", "up", "down", "plunge"],
)
@pytest.mark.parametrize("stepover", [2.0, 6.0])
def test_a_ball_cuts_ahead_of_itself_as_much_as_it_descends(points, slowed, stepover):
    front, width = ball_row(stepover)
    run = np.hypot(*(np.array(points[1]) - points[0])[:2])
    found = area(path(points), Strategy.ZIGZAG, tool=BALL, stepover=stepover, passes=1)
    assert found == pytest.approx(slowed * front + width * run, rel=6e-3)


@pytest.mark.parametrize(
    ("left", "room", "way"),
    [(10, 60 * 15 + 2 * (60 + 15) * 3 + CORNERS, 6 * 60 + 5 * 3), (-30, 33 * 21 - (36 - CORNERS) / 2, 6 * 30 + 3 * 3)],
    ids=["over the stock", "half beside"],
)
def test_where_nobody_tells_the_step_of_a_balls_rows_it_is_their_room_by_their_length(left, room, way):
    """Six rows of 60 mm, 3 mm apart, cut to and fro; what of both is over the stock."""
    ends = (left, left + 60)
    cut = path([(x, 20 + 3 * k, 15) for k in range(6) for x in ends[:: 1 - 2 * (k % 2)]])
    expected = area(cut, Strategy.ZIGZAG, tool=BALL, stepover=room / way)
    assert area(cut, Strategy.ZIGZAG, tool=BALL) == pytest.approx(expected, rel=1e-6)


def test_a_ball_that_plunges_once_cuts_its_circle():
    assert area(path([(40, 30, 22), (40, 30, 5)]), Strategy.DRILLING, tool=BALL) == pytest.approx(9 * pi, rel=0.01)


@pytest.mark.parametrize(
    ("tool", "z", "reach"),
    [
        (BALL, 19, sqrt(5)),
        (BALL, 19.9, sqrt(0.59)),
        (BALL, 18.5, sqrt(6.75)),
        (VEE, 18, 2.0),
        (VEE, 15, 3.0),
        (Tool("vbit", 8, tip_angle=2 * np.arctan(0.5)), 16, 2.0),
        (Tool("vbit", 8, tip_angle=2 * np.arctan(2)), 19, 2.0),
        (Tool("bullnose", 6, corner_radius=2.0), 10, 3.0),
    ],
)
def test_a_pointed_tool_is_as_wide_as_where_it_leaves_the_stock(tool, z, reach):
    """Alone in its row: half of its circle ahead of it, and its width along the row; half of that beside the stock."""
    for x0, share in ((10, 1.0), (-20, None)):
        row = path([(x0, 30, z), (x0 + 40, 30, z)])
        part = share or (20 + tool.radius) / (40 + tool.diameter)
        found = area(row, Strategy.ENGRAVING, tool=tool)
        assert found == pytest.approx((pi * reach**2 / 2 + 2 * reach * 40) * part, rel=4e-3)


def test_a_slightly_rounded_tool_is_a_flat_one():
    row = path([(10, 30, 15), (50, 30, 15)])
    assert area(row, Strategy.PROFILE, tool=Tool("bullnose", 6, corner_radius=1.4)) == pytest.approx(6 * 40)
