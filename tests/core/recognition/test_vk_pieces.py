# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut moves into pieces (loops, turns of windings, zigzags and strokes), and measure them, for drawn toolpaths."""

from __future__ import annotations

import math

import numpy as np
import programs
import pytest
from drawings import polygon

from vkworkbench.core import linearize
from vkworkbench.core.paper import TURN, monotonous_areas
from vkworkbench.core.recognition.patterns.pieces import LOOP, STROKE, WINDING, ZIGZAG, cut_pieces


def pieces_of(*strokes):
    return cut_pieces(monotonous_areas(linearize(programs.program(strokes))))


def zigzag(rows, length=40.0, step=3.0, z=0.0):
    ends = [(0.0, length), (length, 0.0)]
    return [(x, step * row, z) for row in range(rows) for x in ends[row % 2]]


def test_loop_zigzag_and_stroke_are_three_kinds_of_pieces():
    pieces = pieces_of(polygon(20), zigzag(7), [(0, 0, 0), (30, 0, 0), (30, 10, 0)])
    assert pieces.kind.tolist() == [LOOP, ZIGZAG, STROKE] and pieces.area.tolist() == [0, 1, 2]
    assert pieces.length == pytest.approx([80, 7 * 40 + 6 * 3, 40])
    assert np.abs(pieces.net) == pytest.approx([TURN, 0, TURN / 4])
    assert pieces.back == pytest.approx([0, 12 * TURN / 4, 0], abs=1e-9)
    assert np.abs(pieces.enclosed[[0, 2]]) == pytest.approx([400, 150])
    assert pieces.passes.tolist() == [1, 7, 1] and pieces.wavy.tolist() == [False, False, False]
    assert pieces.box[1].tolist() == [0, 0, 40, 18] and pieces.box[2].tolist() == [0, 0, 30, 10]
    assert pieces.start.tolist() == [0, pieces.end[0], pieces.end[1]]
    assert pieces.flat.all()


def to_and_fro(xy, times=5, down=1.0):
    """Return a pass along the points, repeated back and forth without a lift, while the tool goes down."""
    points = [point for k in range(times) for point in list(xy)[:: (-1) ** k][k > 0 :]]
    return [(x, y, -down * times * k / (len(points) - 1)) for k, (x, y) in enumerate(points)]


def wave(turns=1.0, count=60):
    return [(100 * t, 15 * math.sin(turns * TURN * t)) for t in np.linspace(0, 1, count)]


@pytest.mark.parametrize("xy", [[(0, 0), (60, 0), (60, 40)], wave(), wave(3.0)], ids=["corner", "s", "waves"])
def test_each_repetition_of_a_bent_ramp_pass_is_a_piece(xy):
    """A bent pass that is cut back and forth turns like a zigzag, but is not a zigzag."""
    pieces = pieces_of(to_and_fro(xy))
    assert pieces.kind.tolist() == [STROKE] * 5 and pieces.area.tolist() == [0] * 5
    assert pieces.length == pytest.approx([pieces.length[0]] * 5) and not pieces.wavy.any()
    assert pieces.box == pytest.approx(np.tile(pieces.box[0], (5, 1)))


@pytest.mark.parametrize("aside", [0.0, 0.01])
def test_straight_ramp_back_and_forth_is_one_piece(aside):
    """A straight pass back and forth may be an entry ramp, and rounding may move its points off the line."""
    assert len(pieces_of([(0, 0, 0), (60, 0, -1), (0, aside, -2), (60, 0, -3), (0, 0, -4)])) == 1


def test_bent_pass_that_ends_elsewhere_is_not_a_separate_piece():
    there = [(0, 0, 0), (60, 0, 0), (60, 40, 0)]
    assert len(pieces_of([*there, (60, -10, 0), (0, -10, 0)])) == 1


def test_loop_with_a_tail_is_two_pieces_of_one_area():
    square = [(0, 0, 0), (20, 0, 0), (20, 20, 0), (0, 20, 0), (0, 0, 0)]
    pieces = pieces_of([*square, (-15, -5, 0), (-30, 0, 0)])
    assert pieces.kind.tolist() == [LOOP, STROKE] and pieces.area.tolist() == [0, 0]
    assert pieces.start.tolist() == [0, 4] and pieces.end.tolist() == [4, 6]


def test_each_full_turn_of_a_spiral_is_a_piece():
    """After a spiral of three turns, a zigzag remains a piece of its own kind."""
    angles = np.linspace(0, 3 * TURN, 145)
    radius = 30 - 6 * angles / TURN
    spiral = np.column_stack((radius * np.cos(angles), radius * np.sin(angles), np.zeros(145))).tolist()
    pieces = pieces_of(spiral, zigzag(6))
    assert pieces.kind.tolist() == [WINDING] * (len(pieces) - 1) + [ZIGZAG] and len(pieces) == 4
    assert pieces.area.tolist() == [0, 0, 0, 1] and not pieces.wavy.any()
    assert pieces.net[:2] == pytest.approx([TURN, TURN], rel=0.1) and pieces.passes[-1] == 6
    assert (np.diff(pieces.length[:3]) < 0).all()


@pytest.mark.parametrize("corners", [4, 48])
@pytest.mark.parametrize("turned", [0.25, 12.25])
def test_bounding_box_of_a_piece_contains_the_whole_piece(corners, turned):
    """Bounding boxes of few and of many points are computed differently.

    The piece begins at its right side or at its top.
    """
    drawn = polygon(20, x=100, y=50, corners=corners, turned=turned)
    low, high = np.min(drawn, axis=0)[:2], np.max(drawn, axis=0)[:2]
    (box,) = pieces_of(drawn).box
    assert box == pytest.approx([*low, *high])


def test_rise_and_drop_of_a_climbing_piece_are_measured():
    """The path is level for 10 mm, rises by 6 mm over 20 mm, and is level for 10 mm."""
    pieces = pieces_of([(0, 0, 0), (10, 0, 0), (10, 20, 6), (20, 20, 6)], polygon(10, z=-1.0))
    assert pieces.z == pytest.approx([(0 + 3 * 20 + 6 * 10) / 40, -1])
    assert (pieces.last_z[0], pieces.rise[0], pieces.drop[0]) == pytest.approx((6, 6, 6))
    assert (pieces.last_z[1], pieces.rise[1], pieces.drop[1]) == pytest.approx((-1, 0, 0))
    assert pieces.flat.tolist() == [False, True]
    falling = pieces_of([(0, 0, 3), (10, 0, 3), (10, 20, -3), (20, 20, -3)])
    assert (falling.rise[0], falling.drop[0]) == pytest.approx((6, -6))
    # The drop of a piece of the toolpath is measured from the piece's first point.
    at_once = pieces_of([(0, 0, 5), (10, 0, 2), (10, 20, 2), (20, 20, 3)])
    assert (at_once.rise[0], at_once.drop[0], at_once.last_z[0]) == pytest.approx((3, -2, 3))


def test_zigzag_that_ends_at_its_start_is_a_wavy_loop():
    closed = [*zigzag(6), (-5, 15, 0), (-5, 0, 0), (0, 0, 0)]
    pieces = pieces_of(closed)
    assert pieces.kind.tolist() == [LOOP] and pieces.wavy.tolist() == [True]


@pytest.mark.parametrize(("rows", "kind"), [(2, STROKE), (3, ZIGZAG), (6, ZIGZAG)])
def test_two_rows_are_not_a_zigzag(rows, kind):
    """In three rows, only the middle row has neighbours on both sides. A third of the length is enough for a zigzag."""
    pieces = pieces_of(zigzag(rows))
    assert pieces.kind.tolist() == [kind] and pieces.passes.tolist() == [rows]
    assert not pieces.wavy.any()


def test_short_zigzags_between_large_loops_are_links():
    """Zigzags below a thousandth of the total length are not searched."""
    large = [polygon(400 - 10 * k) for k in range(8)]
    small = zigzag(6, length=1.0, step=0.2)
    assert pieces_of(*large, small).kind.tolist() == [LOOP] * 8 + [STROKE]
    assert pieces_of(*large, zigzag(40)).kind.tolist() == [LOOP] * 8 + [ZIGZAG]


def slanted(stroke, degrees):
    """Return the stroke, rotated about Z."""
    u, v = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [(x * u - y * v, x * v + y * u, z) for x, y, z in stroke]


@pytest.mark.parametrize("degrees", [0, 30, 60, 90, 150])
def test_zigzag_has_one_pass_per_row_in_any_direction(degrees):
    pieces = pieces_of(slanted(zigzag(7), degrees))
    assert pieces.kind.tolist() == [ZIGZAG] and pieces.passes.tolist() == [7]


def test_links_that_extend_into_the_rows_are_not_passes():
    """Each link extends 1 mm into the rows and back, and leads 3 mm aside to the next row."""
    ends, stroke = (0.0, 40.0), []
    for row in range(7):
        x = ends[(row + 1) % 2]
        bulge = x - 1.0 if x else 1.0
        stroke += [(40.0 - x, 3.0 * row, 0), (x, 3.0 * row, 0), (bulge, 3.0 * row + 1.5, 0)]
    pieces = pieces_of(stroke[:-1])
    assert pieces.kind.tolist() == [ZIGZAG] and pieces.passes.tolist() == [7]


def test_piece_of_two_opposite_moves_has_one_pass():
    """A piece of two opposite moves counts as one pass; only longer pieces are divided into passes."""
    hairpin = [(0, 0, 0), (30, 0, 0), (0, 1, 0)]
    pieces = pieces_of(hairpin, zigzag(2), hairpin)
    assert pieces.kind.tolist() == [STROKE] * 3 and pieces.passes.tolist() == [1, 2, 1]


@pytest.mark.parametrize("middle, kind", [(20.0, ZIGZAG), (10.0, STROKE)])
def test_alternating_half_turns_are_a_zigzag_if_long_enough(middle, kind):
    """The row between two rows of 20 mm has 20 of the stroke's 62 mm, or 10 of 52 mm. The links are 1 mm long."""
    stroke = [(0, 0, 0), (20, 0, 0), (20, 1, 0), (20 - middle, 1, 0), (20 - middle, 2, 0), (40 - middle, 2, 0)]
    assert pieces_of(stroke).kind.tolist() == [kind]


@pytest.mark.parametrize("rows, kind", [(4, STROKE), (6, ZIGZAG)])
def test_stroke_mostly_back_and_forth_is_a_zigzag(rows, kind):
    """After the rows, the stroke continues around the rows.

    The two half-turns at the ends of a pass have opposite signs if there are three or five passes, and equal signs if
    there are two.
    """
    top = 3.0 * (rows - 1)
    around = [(0, top + 3), (40, top + 3), (40, -10), (0, -10), (0, top + 6), (40, top + 6)]
    assert pieces_of(zigzag(rows) + [(x, y, 0) for x, y in around]).kind.tolist() == [kind]


LETTERS = {
    "N": [(0, 0), (0, 10), (6, 0), (6, 10)],
    "W": [(0, 10), (1.5, 0), (3, 8), (4.5, 0), (6, 10)],
    "Z": [(0, 10), (9, 10), (0, 0), (9, 0)],
}


@pytest.mark.parametrize("letter", LETTERS.values(), ids=LETTERS)
def test_slanted_letters_are_not_rows(letter):
    assert pieces_of([(x, y, 0) for x, y in letter]).kind.tolist() == [STROKE]


def test_few_rows_must_be_parallel_but_many_rows_may_lean():
    """Three parallel rows with links of 3 mm are a zigzag.

    Four rows that lean like the strokes of a W are not a zigzag. Five leaning rows are a zigzag.
    """
    assert pieces_of([(0, 0, 0), (0, 30, 0), (3, 30, 0), (3, 0, 0), (6, 0, 0), (6, 30, 0)]).kind.tolist() == [ZIGZAG]
    for passes, kind in ((4, STROKE), (5, ZIGZAG)):
        assert pieces_of([(1.5 * k, 10 * (k % 2), 0) for k in range(passes + 1)]).kind.tolist() == [kind]


@pytest.mark.parametrize("turns, kind", [(1.1, STROKE), (1.3, WINDING)])
def test_spiral_makes_more_than_1_2_full_turns(turns, kind):
    """The radius of the arc grows along the arc, so the arc does not meet itself."""
    angles = np.linspace(0, turns * TURN, 49)
    pieces = pieces_of([(70 + (20 + a) * math.cos(a), (20 + a) * math.sin(a), 0) for a in angles])
    assert set(pieces.kind.tolist()) == {kind}
