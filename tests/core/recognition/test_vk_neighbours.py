# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find open strokes side by side, among drawn strokes with and without neighbours."""

from __future__ import annotations

import numpy as np
import programs
import pytest

from vkworkbench.core import linearize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.patterns.neighbours import find_neighbours
from vkworkbench.core.recognition.patterns.pieces import cut_pieces

TOOL = 4.0


def neighbours(strokes, tool=TOOL):
    moves = monotonous_areas(linearize(programs.program(strokes)))
    pieces = cut_pieces(moves)
    return find_neighbours(moves, pieces, np.arange(len(pieces)), tool)


def corner(offset, z=0.0):
    """Return a stroke along two walls, at an offset from the walls."""
    return [(offset, 60.0, z), (offset, offset, z), (80.0, offset, z)]


def line(y, x=0.0, length=50.0, z=0.0, slant=0.0):
    return [(x, y, z), (x + length, y + slant, z)]


def test_step_between_offsets_around_a_corner_is_their_distance():
    found = neighbours([corner(2.0 * k) for k in range(6)])
    assert (found.count, found.share, found.even, found.onward) == pytest.approx((6, 1, 1, 1))
    assert found.step == pytest.approx(2.0, abs=0.05)


def test_neighbours_cut_back_and_forth_have_opposite_directions():
    found = neighbours([corner(2.0 * k)[:: 1 - 2 * (k % 2)] for k in range(6)])
    assert (found.count, found.even, found.onward) == pytest.approx((6, 1, 0))


@pytest.mark.parametrize("lag", [1, 2, 3, 4])
def test_neighbour_of_a_stroke_is_one_of_the_last_three(lag):
    """The offsets of `lag` walls are cut alternately: one offset of each wall, then the next offset of each wall.

    The first stroke of the first wall is included, although no stroke was cut before this stroke.
    """
    found = neighbours([line(100.0 * wall + 2.0 * k) for k in range(5) for wall in range(lag)])
    if lag > 3:
        assert found is None
    else:
        assert found.count == 5 * lag - (lag - 1) and found.step == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("apart", "tool", "beside"), [(4.7, TOOL, True), (4.9, TOOL, False), (4.9, 0.0, True), (0.01, 0.0, False)]
)
def test_neighbours_are_within_the_reach_of_the_tool(apart, tool, beside):
    """Strokes on one line are not neighbours."""
    found = neighbours([line(apart * k, length=200.0) for k in range(5)], tool)
    assert (found is not None) == beside


def test_short_line_far_from_a_stroke_is_not_its_neighbour():
    assert neighbours([line(6.0 * k, length=9.0) for k in range(5)], 0.0) is None
    assert neighbours([line(6.0 * k, length=90.0) for k in range(5)], 0.0).count == 5


def test_stroke_at_another_height_is_not_a_neighbour():
    assert neighbours([line(2.0 * k, z=-1.0 * k) for k in range(5)]) is None
    falling = [[(0.0, 2.0 * k, 5.0 - k), (50.0, 2.0 * k, -k)] for k in range(5)]
    assert neighbours(falling).count == 5  # The heights of a sloped stroke are not compared.


def test_neighbours_lie_side_by_side_for_most_of_their_length():
    """In the first case, half of each stroke lies beside the next stroke; in the second case, three quarters."""
    for onward in (1, -1):
        assert neighbours([line(2.0 * k, x=onward * 25.0 * k) for k in range(5)]) is None
        assert neighbours([line(2.0 * k, x=onward * 12.0 * k) for k in range(5)]).count == 5


def test_direction_of_a_stroke_is_from_first_to_last_point():
    """Each stroke begins with a hook in the other direction. In the second case, every other stroke is reversed."""
    hooks = [[(20.0, 2.0 * k, 0.0), (12.0, 2.0 * k, 0.0), (70.0, 2.0 * k + 0.1, 0.0)] for k in range(6)]
    assert neighbours(hooks).onward == 1
    assert neighbours([hook[:: 1 - 2 * (k % 2)] for k, hook in enumerate(hooks)]).onward == 0


def test_passes_that_spread_like_a_fan_are_not_even():
    """The passes are 0.4 mm apart at one end and 3.6 mm at the other.

    The passes are not offsets, which would keep their distance.
    """
    found = neighbours([line(0.4 * k, slant=3.2 * k) for k in range(5)])
    assert found.even == 0 and found.onward == 1 and found.step == pytest.approx(2.0, rel=0.1)


@pytest.mark.parametrize("opens, even", [(0.6, 1), (0.9, 0)])
def test_distance_of_even_offsets_varies_by_at_most_30_percent(opens, even):
    """The mean distance between the offsets is 2 mm.

    The difference between the 10th and 90th percentile of the distance is 0.8 * `opens`.
    """
    found = neighbours([line((2.0 - opens / 2) * k, slant=opens * k) for k in range(5)])
    assert found.even == even and found.step == pytest.approx(2.0, rel=0.1)


def test_stroke_far_from_the_usual_step_is_not_a_neighbour():
    """Five rows are 2 mm apart, and a sixth row is 7 mm away from the last of the five rows."""
    strokes = [*(line(2.0 * k, length=200.0) for k in range(5)), line(15.0, length=200.0)]
    found = neighbours(strokes, 0.0)
    assert found.count == 5 and found.share == pytest.approx(5 / 6) and found.step == 2.0


def test_short_stroke_is_not_neighbour_of_far_long_stroke():
    """Every second stroke is 9 mm long, and 6 mm away from the strokes of 90 mm on both sides."""
    strokes = [line(6.0 * k, x=40.0 * (k % 2), length=9.0 if k % 2 else 90.0) for k in range(4)]
    assert neighbours(strokes, 0.0) is None


def test_three_strokes_side_by_side_are_neighbours():
    """Two of the three strokes have a neighbour that was cut before."""
    assert neighbours([line(2.0 * k) for k in range(3)]).count == 3


def test_fewer_than_three_strokes_have_no_neighbours():
    assert neighbours([line(0.0)]) is None and neighbours([line(0.0), line(2.0)]) is None
