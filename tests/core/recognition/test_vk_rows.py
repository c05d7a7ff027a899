# SPDX-License-Identifier: LGPL-2.1-or-later
"""The number, distances and directions of rows are measured in toolpaths with known rows."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import programs
import pytest
from counting import memory

from vkworkbench.core import linearize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.patterns.rows import Rows, filling, find_rows, weighted_median

ZIGZAG = [(x, 3.0 * row) for row in range(6) for x in ((0.0, 50.0), (50.0, 0.0))[row % 2]]


def rows_of(commands):
    """Return the families of rows (all rows along one axis) among all moves."""
    moves = monotonous_areas(linearize(commands))
    return find_rows(moves, np.arange(len(moves)))


def turned(commands, quarter):
    """Return the commands, rotated by 90 degrees about Z if `quarter`."""
    return [
        (name, {**p, "X": -p.get("Y", 0.0), "Y": p.get("X", 0.0)} if quarter and "X" in p else p)
        for name, p in commands
    ]


@pytest.mark.parametrize("quarter", [False, True])
def test_lines_of_a_zigzag_are_one_family_of_rows(quarter):
    (rows,) = rows_of(turned(programs.zigzag(10, 50.0, 3.0), quarter))
    assert rows.axis == pytest.approx(np.pi / 2 if quarter else 0.0)
    assert (rows.count, rows.lines, rows.step, rows.pitch, rows.period) == pytest.approx((10, 10, 3, 3, 3))
    assert (rows.length, rows.once, rows.typical) == pytest.approx((500, 500, 50))
    assert (rows.opposite, rows.same, rows.even) == pytest.approx((450, 0, 1))


@pytest.mark.parametrize("degrees", [0, 180, 360])
def test_rows_along_x_have_direction_zero(degrees):
    angle = math.radians(degrees)
    ways = [(x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle)) for x, y in ZIGZAG]
    (rows,) = rows_of([("G1", {"X": x, "Y": y, "Z": 0.0}) for x, y in ways])
    assert 0 <= rows.axis < 1e-9


def test_one_way_rows_have_neighbours_cut_in_the_same_direction():
    (rows,) = rows_of(programs.one_way(10, 50.0, 3.0))
    assert (rows.opposite, rows.same, rows.count) == pytest.approx((0, 450, 10))


def test_rows_repeated_at_a_second_depth_lie_on_the_same_lines():
    """The first row of the second depth is far from the last row of the first depth, so they are not neighbours."""
    (rows,) = rows_of(programs.one_way(10, 50.0, 3.0, depths=(0.0, -1.0)))
    assert (rows.count, rows.lines, rows.length, rows.once) == pytest.approx((20, 10, 1000, 1000))
    assert (rows.same, rows.step, rows.pitch) == pytest.approx((900, 3, 3))


def test_row_cut_back_at_a_second_depth_counts_once():
    ends = ((0.0, 50.0, 0.0), (50.0, 0.0, -1.0))  # The tool returns on the row at the second depth.
    strokes = [[(a, 3.0 * row, z), (b, 3.0 * row, z)] for row in range(6) for a, b, z in ends]
    (rows,) = rows_of(programs.program(strokes))
    assert (rows.count, rows.lines, rows.length, rows.once) == pytest.approx((6, 6, 600, 300))


def slanted(strokes, degrees):
    """Return the strokes, rotated about Z."""
    u, v = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [[(x * u - y * v, x * v + y * u, z) for x, y, z in stroke] for stroke in strokes]


@pytest.mark.parametrize("degrees", [0.0, 30.0, 60.0, 120.0])
def test_row_interrupted_by_an_island_is_one_row(degrees):
    strokes = [[(x, 3.0 * row, 0.0), (x + 20.0, 3.0 * row, 0.0)] for row in range(6) for x in (0.0, 30.0)]
    (rows,) = rows_of(programs.program(slanted(strokes, degrees)))
    assert (rows.count, rows.typical, rows.length) == pytest.approx((6, 40, 240))
    assert (rows.axis, rows.step) == pytest.approx((math.radians(degrees), 3))


def test_row_of_slightly_wavering_moves_is_one_row():
    """Moves that deviate by 0.1 mm over 10 mm count as parallel. Each row is a separate stroke."""
    strokes = [[(10.0 * k, 3.0 * row + 0.1 * (k % 2), 0.0) for k in range(6)] for row in range(8)]
    (rows,) = rows_of(programs.program(strokes))
    assert (rows.count, rows.lines) == (8, 8)
    assert (rows.typical, rows.step, rows.same) == pytest.approx((50, 3, 350), rel=1e-3)


def test_rows_of_short_moves_equal_rows_of_long_moves():
    ends = [(0.0, 50.0), (50.0, 0.0)]
    points = [(x, 3.0 * row, 0.0) for row in range(10) for x in np.linspace(*ends[row % 2], 101).tolist()]
    (rows,) = rows_of(programs.program([points]))
    assert (rows.count, rows.lines, rows.typical, rows.opposite) == pytest.approx((10, 10, 50, 450))


@pytest.mark.parametrize("degrees, aligned", [(2.0, True), (4.0, False)])
def test_line_within_three_degrees_of_the_rows_is_one_of_them(degrees, aligned):
    """0.05 rad are 2.9 degrees. Ten rows of 50 mm have one direction, and a row of 60 mm has another."""
    (askew,) = slanted([[(0.0, -30.0, 0.0), (60.0, -30.0, 0.0)]], degrees)
    families = rows_of([*programs.one_way(10, 50.0, 3.0), *programs.program([askew])])
    assert families[0].length == pytest.approx(560 if aligned else 500, rel=1e-3)


def test_period_of_rows_in_pairs_is_the_distance_of_the_pairs():
    """Two sets of lines 10 mm apart are shifted by 1 mm."""
    strokes = [[(0.0, y, 0.0), (50.0, y, 0.0)] for k in range(8) for y in (10.0 * k, 10.0 * k + 1.0)]
    (rows,) = rows_of(programs.program(strokes))
    assert rows.period == pytest.approx(10.0) and rows.pitch in (1.0, 9.0)


def test_grid_has_two_families_of_rows():
    across = [[(0.0, 3.0 * row, 0.0), (50.0, 3.0 * row, 0.0)] for row in range(12)]
    down = [[(4.0 * row, 0.0, 0.0), (4.0 * row, 33.0, 0.0)] for row in range(13)]
    first, second = rows_of(programs.program(across + down))
    assert (first.axis, second.axis) == pytest.approx((0.0, np.pi / 2))
    assert (first.step, second.step, first.count, second.count) == pytest.approx((3, 4, 12, 13))
    assert not set(first.moves) & set(second.moves)


@pytest.mark.parametrize("degrees", [30.0, 60.0])
def test_slanted_grid_has_two_families_of_rows(degrees):
    across, slant = ([[(0.0, 3.0 * row, 0.0), (50.0, 3.0 * row, 0.0)] for row in range(count)] for count in (12, 10))
    first, second = rows_of(programs.program(across + slanted(slant, degrees)))
    assert (first.axis, second.axis) == pytest.approx((0.0, math.radians(degrees)))
    assert (first.count, second.count) == (12, 10)


def test_rows_of_a_grid_may_lean_to_both_sides_of_the_axis():
    """One third of each row leans to the left by 2.5 degrees, and one third leans to the right by 2.5 degrees."""
    up = 20 * math.tan(math.radians(2.5))
    across = [[(0, y, 0), (20, y + up, 0), (40, y + up, 0), (60, y, 0)] for y in 3.0 * np.arange(30)]
    first, second = rows_of(programs.program(across + [[(x, 0, 0), (x, 57, 0)] for x in 3.0 * np.arange(20)]))
    assert (first.count, second.count) == (30, 20)
    assert (first.typical, second.typical) == pytest.approx((60, 57), rel=1e-2)


def test_few_moves_across_the_rows_are_not_a_family_of_rows():
    """A second family of rows is searched only if enough length remains, and kept only if its rows are long enough."""
    across = [[(0.0, 3.0 * row, 0.0), (50.0, 3.0 * row, 0.0)] for row in range(12)]
    for count, families in ((0, 1), (1, 1), (2, 2), (13, 2)):
        down = [[(4.0 * row, 0.0, 0.0), (4.0 * row, 33.0, 0.0)] for row in range(count)]
        assert len(rows_of(programs.program(across + down))) == families


def test_scattered_directions_are_not_a_second_family_of_rows():
    """Five lines of 20 mm in different directions have a sixth of the length of twelve rows of 50 mm."""
    across = [[(0.0, 3.0 * row, 0.0), (50.0, 3.0 * row, 0.0)] for row in range(12)]
    askew = [slanted([[(0.0, 0.0, 0.0), (20.0, 0.0, 0.0)]], 25.0 * k)[0] for k in range(1, 6)]
    assert [rows.length for rows in rows_of(programs.program(across + askew))] == pytest.approx([600])


@pytest.mark.parametrize(
    "lines, period",
    [
        ((0, 1, 10, 11), 10.0),
        ((0, 1, 10), 5.0),  # Three lines have no period, and the median of the distances is 5 mm.
        ((0, 3.0, 6.2, 9.6, 13.2, 17.0), 3.4),  # Lines with slowly growing distances do not form a repeating pattern.
        # The path is reflected at the walls. The lines are 3.9 mm apart, and have by chance a period of 31.2 mm.
        (np.cumsum([0, 1, 2, 1, 3, 3, 3, 5, 3, 4, 2, 1, 2, 1, 3, 2, 4, 5, 4, 3, 2, 1, 2, 1, 3]) * 1.3, 3.9),
        ((0, 0.7, 4, 4.7, 6.1, 8, 8.7, 10.1, 12, 12.7, 14.1, 18.1), 4.0),  # Three sets of lines have the same period.
    ],
)
def test_period_of_a_pattern_is_found_from_four_lines_on(lines, period):
    (rows,) = rows_of(programs.program([[(0.0, float(y), 0.0), (50.0, float(y), 0.0)] for y in lines]))
    assert rows.period == pytest.approx(period)


def test_steps_of_a_staircase_are_not_neighbouring_rows():
    """A contour that is sampled on a grid looks like a staircase."""
    stairs = [(10.0 * (k // 2 + k % 2), 3.0 * (k // 2), 0.0) for k in range(20)]
    families = rows_of(programs.program([stairs]))
    assert families[0].same == 0 == families[0].opposite and families[0].count == 10


def test_single_row_has_no_step():
    (rows,) = rows_of(programs.program([[(0.0, 5.0, 0.0), (50.0, 5.0, 0.0)]]))
    assert (rows.count, rows.lines, rows.length, rows.once, rows.typical) == (1, 1, 50, 50, 50)
    assert (rows.step, rows.pitch, rows.period, rows.opposite, rows.same, rows.even) == (0,) * 6


@pytest.mark.parametrize("apart, lines", [(0.015, 1), (0.03, 5)])
def test_rows_closer_than_0_02_mm_lie_on_one_line(apart, lines):
    strokes = [[(0.0, apart * k, 0.0), (50.0, apart * k, 0.0)] for k in range(5)]
    (rows,) = rows_of(programs.program(strokes))
    assert rows.lines == lines


@pytest.mark.parametrize("length, count", [(4.5, 10), (5.5, 11)])
def test_pass_shorter_than_a_tenth_is_not_a_row(length, count):
    (rows,) = rows_of([*programs.one_way(10, 50.0, 3.0), *programs.program([[(0.0, 30.0, 0.0), (length, 30.0, 0.0)]])])
    assert rows.count == count


def test_share_of_equal_steps_between_rows_is_measured():
    """Every third step is 1 mm, the other steps are 4 mm. Two thirds of the steps equal the usual step."""
    y = np.cumsum([0, 4, 4, 1] * 4)
    (rows,) = rows_of(programs.program([[(0.0, float(v), 0.0), (50.0, float(v), 0.0)] for v in y]))
    steps = np.diff(y)
    assert rows.step == 4.0
    assert rows.even == pytest.approx((steps == 4).sum() / (steps > 0).sum())


def test_weighted_median_is_the_value_at_half_of_the_weight():
    values, weights = np.array([3.0, 1.0, 2.0, 9.0]), np.array([1.0, 1.0, 1.0, 5.0])
    assert weighted_median(values, weights) == 9.0
    assert weighted_median(values, np.ones(4)) == 2.0
    assert weighted_median(values[:1], weights[:1]) == 3.0


def test_staircase_after_another_stroke_is_not_rows():
    before = [[(0.0, -80.0, 0.0), (10.0, -80.0, 0.0)]]
    stairs = [(10.0 * (k // 2 + k % 2), 3.0 * (k // 2), 0.0) for k in range(20)]
    families = rows_of(programs.program(before + [stairs]))
    assert families[0].same == 0


# The following tests check which families of rows fill an area, according to `filling`.

TOOL = 6.0
# Ten rows of 50 mm, 3 mm apart, are cut back and forth.
GOOD = Rows(
    axis=0.0, length=500.0, once=500.0, typical=50.0, count=10, lines=10, opposite=450.0, same=0.0, step=3.0, pitch=3.0,
    period=3.0, even=1.0, steep=False, lies=np.array([(3.0 * k, 0.0, 50.0) for k in range(10)]), moves=np.arange(10),
)  # fmt: skip


ACROSS = replace(GOOD, axis=1.5, lies=GOOD.lies * (-1.0, 1.0, 1.0))


def fills(tool=TOOL, contour=False, **changed):
    family = replace(GOOD, **changed)
    found = filling([family], tool, length=500.0, contour=contour)
    assert found in ([], [family])
    return bool(found)


@pytest.mark.parametrize("opposite, same, good", [(130, 0, True), (0, 130, True), (70, 60, True), (60, 60, False)])
def test_rows_fill_an_area_if_a_quarter_of_length_is_beside_rows(opposite, same, good):
    assert fills(opposite=opposite, same=same) is good


def test_repeats_of_rows_are_left_out_when_rows_fill_an_area():
    """The 120 mm beside other rows are over a quarter of 400 mm without repeats, and below a quarter of 500 mm."""
    assert fills(opposite=120, once=400.0) and not fills(opposite=120)


@pytest.mark.parametrize(
    "typical, lines, even, good",
    [(7.6, 9, 0.9, True), (7.4, 9, 0.9, False), (7.4, 10, 0.9, True), (7.4, 10, 0.7, False), (4.4, 10, 0.9, False)],
)
def test_rows_that_fill_an_area_have_a_minimum_length_in_steps(typical, lines, even, good):
    """With steps of 3 mm between the rows, the minimum lengths are 7.5 and 4.5 mm."""
    assert fills(typical=typical, lines=lines, even=even) is good


@pytest.mark.parametrize(
    "step, tool, good",
    [(0.17, 6, False), (0.19, 6, True), (0.17, 0, True), (3, 2.4, False), (3, 2.6, True), (3, 0, True)],
)
def test_rows_fill_an_area_only_if_their_step_fits_the_tool(step, tool, good):
    """With a step below 0.03 tool diameters, fewer than ten rows are one repeated pass.

    With a step above 1.2 tool diameters, stock remains between the rows.
    """
    assert fills(tool, step=step, lines=9) is good


def test_many_close_rows_fill_an_area_except_on_a_steep_wall():
    assert fills(step=0.01)
    assert not fills(step=0.01, steep=True)


@pytest.mark.parametrize("period, good", [(3.0, True), (7.1, True), (7.3, False)])
def test_rows_fill_an_area_if_only_their_step_exceeds_the_tool(period, good):
    assert fills(step=8.0, period=period) is good


@pytest.mark.parametrize(
    "count, even, tool, good",
    [
        (3, 0.6, 6, True),
        (3, 0.4, 6, False),
        (2, 0.4, 3.1, True),
        (2, 1.0, 2.9, False),
        (2, 1.0, 0, False),
        (1, 0.4, 6, False),
    ],
)
def test_area_is_filled_by_three_even_rows_or_two_that_overlap(count, even, tool, good):
    assert fills(tool, count=count, even=even, lines=count) is good


@pytest.mark.parametrize("period, walls", [(3.1, False), (3.2, True), (30.0, True)])
def test_walls_of_a_contour_are_not_rows(period, walls):
    assert fills(contour=True, period=period) is not walls
    assert fills(contour=False, period=period)


@pytest.mark.parametrize(
    "length, changed, grid",
    [
        (1150.0, {}, True),  # The total length of the rows is 1000 mm, which is more than 85 % of 1150 mm.
        (1200.0, {}, False),
        (1150.0, {"count": 5}, True),
        (1150.0, {"count": 4}, False),
        (1150.0, {"typical": 7.6}, True),
        (1150.0, {"typical": 7.4}, False),
    ],
)
def test_crossed_rows_are_a_grid_without_neighbours_cut_next(length, changed, grid):
    alone = {"opposite": 0.0}
    families = [replace(GOOD, **alone), replace(ACROSS, **alone, **changed)]
    assert filling(families, TOOL, length=length, contour=False) == (families if grid else [])
    assert filling(families[:1], TOOL, length=500.0, contour=False) == []


@pytest.mark.parametrize("tool, grid", [(0.0, True), (2.6, True), (2.4, False)])
def test_crossed_rows_farther_apart_than_the_tool_are_not_a_grid(tool, grid):
    """Outlines of small parts on a sheet have sides along two axes.

    1.2 tool diameters are 3.1 or 2.9 mm, and the rows are 3 mm apart.
    """
    alone = {"opposite": 0.0}
    families = [replace(GOOD, **alone), replace(ACROSS, **alone)]
    assert filling(families, tool, length=1000.0, contour=False) == (families if grid else [])


def test_only_the_family_of_rows_that_fills_an_area_is_returned():
    across = replace(ACROSS, opposite=0.0)
    assert filling([GOOD, across], TOOL, length=1000.0, contour=False) == [GOOD]


@pytest.mark.parametrize("lean", [0.0, 0.6, -0.6])
@pytest.mark.parametrize("turned", [0.0, 0.4, 2.0])
def test_grid_rows_cross_and_nested_contours_do_not(turned, lean):
    def families(strokes):
        c, s = np.cos(turned), np.sin(turned)
        leant = [[(x + lean * y, y) for x, y in stroke] for stroke in strokes]
        cut = [[(c * x - s * y + 500, s * x + c * y + 300, 0.0) for x, y in stroke] for stroke in leant]
        found = rows_of(programs.program(cut))
        return found, filling(found, TOOL, length=sum(f.length for f in found), contour=False)

    # The lines are ordered so that no line is followed by its neighbour.
    order = [3.0 * (7 * k % 20) for k in range(20)]
    grid = [[(0.0, at), (60.0, at)] for at in order] + [[(at, 0.0), (at, 60.0)] for at in order]
    found, rows = families(grid)
    assert len(found) == 2 and rows == found
    contours = [[(k, k), (80.0 - k, k), (80.0 - k, 70.0 - k), (k, 70.0 - k), (k, k + 0.5)] for k in 1.5 * np.arange(20)]
    found, rows = families(contours)
    assert len(found) == 2 and rows == []


@pytest.mark.parametrize("beyond, cross", [(0.035, False), (0.07, True)])
def test_passes_cross_if_they_continue_beyond_each_other(beyond, cross):
    """Each side of nested rectangles extends beyond its corners by 3.5 % or 7 % of its length.

    The tool cuts all sides along X first.
    """
    sides = [(1.5 * k, 80 - 3 * k, 70 - 3 * k) for k in range(20)]
    along = [[(k - beyond * w, y), (k + w + beyond * w, y)] for k, w, h in sides for y in (k, k + h)]
    up = [[(x, k - beyond * h), (x, k + h + beyond * h)] for k, w, h in sides for x in (k, k + w)]
    found = rows_of(programs.program([[(x, y, 0.0) for x, y in stroke] for stroke in along + up]))
    assert filling(found, TOOL, length=sum(f.length for f in found), contour=False) == (found if cross else [])


def test_period_of_distant_rows_needs_little_memory():
    places = [*np.arange(20) * 3.0, *(1e6 + np.arange(20) * 3.0)]
    commands = []
    for y in places:
        commands += [("G0", {"Z": 5}), ("G0", {"X": 0, "Y": y}), ("G1", {"Z": -1}), ("G1", {"X": 50})]
    (rows,), _, peak = memory(lambda: rows_of(commands))
    assert rows.period == pytest.approx(3, rel=1e-3)
    assert peak < 2e6
