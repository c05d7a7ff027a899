# SPDX-License-Identifier: LGPL-2.1-or-later
"""The signature and the measures of an area do not depend on its position in the program or on other areas."""

from __future__ import annotations

import numpy as np
import programs
import pytest

from vkworkbench.core import Strategy, linearize, signature
from vkworkbench.core.paper import monotonous_areas, paper_verdict

# The path goes back and forth on one line, so its half-turns are neither turns to the left nor to the right.
SLOT = [(0.0, 0.0), (30.0, 0.0), (0.0, 0.0), (30.0, 0.0), (30.0, 5.0)]
# The square is closed except for a gap of 0.4 mm, like a contour after a lead-in.
SQUARE = [(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0), (0.0, 0.4)]
ROW = [
    (0.0, 0.0),
    (20.0, 0.0),
    (20.0, 0.4),
    (0.0, 0.4),
]  # This path has the same gap of 0.4 mm, but encloses only a tiny area.


def areas_of(*strokes):
    return monotonous_areas(linearize(programs.program([[(*point, 0.0) for point in stroke] for stroke in strokes])))


def at(stroke, x, y):
    return [(x + dx, y + dy) for dx, dy in stroke]


@pytest.mark.parametrize("strokes", [(SLOT, SLOT), (SQUARE, SLOT), (ROW, SQUARE, SLOT)])
def test_signature_of_an_area_does_not_depend_on_earlier_areas(strokes):
    alone, last = areas_of(SLOT).signature(0), areas_of(*strokes).signature(len(strokes) - 1)
    assert last.unsigned.tolist() == alone.unsigned.tolist() == [0, 1]
    assert last.reversals.tolist() == alone.reversals.tolist()
    assert last.phi.tolist() == alone.phi.tolist() and last.turning.tolist() == alone.turning.tolist()
    assert last.closed == alone.closed and last.total_turning == alone.total_turning


@pytest.mark.parametrize("sense", [1, -1])
def test_sense_of_a_reversal_does_not_depend_on_earlier_areas(sense):
    """The area turns by a quarter, continues straight, and reverses.

    The contour that is cut before this area makes more turns, in either sense.
    """
    late = [(0, 0), (30, 0), (30, 30 * sense), (30, 60 * sense), (30, 30 * sense), (30, 0)]
    for before in (SQUARE, SQUARE[::-1]):
        phi = areas_of(before, late).signature(1).phi / np.pi
        assert phi == pytest.approx(sense * np.array([0, 0.5, 0.5, -0.5, -0.5]))


@pytest.mark.parametrize("x, y", [(0, 0), (500, -300), (-200, 700)])
def test_closed_areas_do_not_depend_on_position(x, y):
    strokes = at(SQUARE, x, y), at(ROW, x, y), at(SQUARE, 2 * x, y), at(SLOT, x, 2 * y)
    areas = areas_of(*strokes)
    assert areas.closed.tolist() == [True, False, True, False]
    assert areas.total_turning[[0, 2]] == pytest.approx(2 * np.pi)
    assert areas_of(*strokes[::-1]).closed.tolist() == [False, True, False, True]


IN_AND_OUT = [(0, 0), (9, 0), (0, 0), (9, 0), (0, 0)]
CORNERS = [(20, 20), (-20, 20), (-20, -20), (20, -20)]
RELIEVED = [(20, 0), *((f * x, f * y) for x, y in CORNERS for f in (1.0, 1.1, 1.0)), (20, 0)]
AROUND = [(20, 0), (20, 20), (-20, 20), (-20, -20), (20, -20), (20, 0)]


@pytest.mark.long
@pytest.mark.parametrize("degrees", range(0, 360, 15))
@pytest.mark.parametrize(
    ("stroke", "turns"),
    [
        (IN_AND_OUT, 0),
        (IN_AND_OUT[:3], 0),
        ([(30, 0), *AROUND, (30, 0)], 1),  # The lead-in and the lead-out are one line outside of the loop.
        ([(10, 0), *AROUND, (10, 0)], 1),  # The lead-in and the lead-out are one line inside the loop.
        ([(10, 0), *AROUND, *AROUND[1:], (10, 0)], 2),
        ([(30, 0), *RELIEVED, (30, 0)], 1),
    ],
)
def test_closing_half_turn_is_not_added_to_the_total(stroke, turns, degrees):
    """The total turning is the same in all directions of the path, for the path alone and among other paths."""
    angle = np.radians(degrees)
    turned = np.array(stroke, float) @ [[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]]
    for path, sense in ((turned, 1), (turned[::-1], -1)):
        assert signature(path).total_turning == pytest.approx(sense * turns * 2 * np.pi, abs=1e-9)
        if len(path) > 3:
            areas = areas_of(SLOT, path.tolist(), SQUARE, path.tolist())
            assert areas.total_turning[[1, 3]] == pytest.approx(sense * turns * 2 * np.pi, abs=1e-9)


def test_corner_reliefs_do_not_change_the_total_turning():
    """A dogbone is a detour out and back, so the corner turns by a quarter, like without the dogbone."""
    for path, sense in ((RELIEVED, 1), (RELIEVED[::-1], -1)):
        assert signature(path).total_turning == pytest.approx(sense * 2 * np.pi)
        areas = areas_of(SLOT, path, RELIEVED)
        assert areas.total_turning[1:] == pytest.approx([sense * 2 * np.pi, 2 * np.pi])
        corners = areas.signature(1).phi[[0, 3, 6, 9, 12]]
        assert corners == pytest.approx(sense * np.pi / 2 * np.arange(5))


@pytest.mark.parametrize("before", [-150, 0, 150])
@pytest.mark.parametrize("behind", [-150, 0, 150])
@pytest.mark.parametrize("sense", [1, -1])
def test_detour_out_and_back_adds_no_turn(before, behind, sense):
    """The path turns by 120 degrees, returns on the same line, and turns by 60 degrees back to its old direction."""
    heading = sense * np.radians(np.cumsum([0, before, 120, 180, 60, behind]))
    path = np.cumsum(np.vstack(([0, 0], 10 * np.column_stack((np.cos(heading), np.sin(heading))))), axis=0)
    areas = areas_of(SLOT, path.tolist())
    assert areas.signature(1).phi[-1] == pytest.approx(sense * np.radians(before + behind))


@pytest.mark.parametrize("links", [1, -1])
def test_phi_of_rows_cut_back_and_forth_has_a_range_of_pi(links):
    rows = [(x, 3 * links * i) for i in range(12) for x in (0, 40, 0)]
    areas = areas_of(rows)
    assert len(areas.unsigned) == 12 and areas.top_level == 0
    assert [np.ptp(areas.phi_range), np.ptp(signature(rows).phi_range)] == pytest.approx([np.pi, np.pi])
    assert paper_verdict(areas).strategy is Strategy.ZIGZAG


@pytest.mark.parametrize("x", [50, 900, -900])
def test_gap_is_compared_with_enclosed_area_at_any_position(x):
    # A contour is closed if the gap is at most 3 % of the side of a square of equal area: 0.6 mm for 20 mm.
    for gap, closed in ((0.5, True), (0.65, False)):
        assert areas_of(at([*SQUARE[:-1], (0.0, gap)], x, -30), at(ROW, 0, 0)).closed.tolist() == [closed, False]


@pytest.mark.parametrize("gap, closed", [(0.02, True), (0.045, False)])
def test_tiny_contour_with_a_gap_of_five_percent_is_open(gap, closed):
    small = [(0.0, 0.0), (0.9, 0.0), (0.9, 0.9), (0.0, 0.9), (0.0, gap)]
    assert areas_of(small).closed.tolist() == [closed]


@pytest.mark.parametrize("turned", [0.0, 0.008])
def test_phi_of_rows_that_fan_out_is_their_direction(turned):
    """Each row is slightly rotated against the previous row. The deviations of the half-turns from pi add up."""
    angle = np.arange(400) * turned + np.pi * (np.arange(400) % 2)
    fan = [(50 * np.cos(a), 50 * np.sin(a)) for a in angle.tolist()]
    signature = areas_of(fan).signature(0)
    assert np.sin(signature.alpha - signature.alpha[0] - signature.phi) == pytest.approx(0, abs=1e-9)
    assert abs(signature.phi[-1]) == pytest.approx(398 * turned, abs=np.pi + 1e-9)


def test_loop_after_a_zigzag_does_not_close_the_zigzag():
    """A loop follows the zigzag and returns to the last point of the rows.

    The zigzag does not become a closed contour.
    """
    rows = [(x, 3.0 * k) for k in range(12) for x in ((0.0, 40.0) if k % 2 == 0 else (40.0, 0.0))]
    loop = [(0.0, 36.0), (5.0, 36.0), (5.0, 40.0), (0.0, 40.0), (0.0, 36.0)]
    areas = areas_of([*rows, *loop])
    assert len(areas.loops[0]) and np.abs(areas.phi_ranges).max() < 2 * np.pi - 0.1


def test_areas_with_a_cut_that_changes_height_are_climbing():
    level, ramp = ([(0.0, 0.0, -1.0), (20.0, 0.0, -1.0), (20.0, 9.0, z)] for z in (-1.0, -1.5))
    for strokes, climbs in (([level, level], False), ([level, ramp], True)):
        assert monotonous_areas(linearize(programs.program(strokes))).climbs is climbs


def test_toolpath_without_cuts_has_no_areas():
    areas = areas_of()
    assert len(areas) == 0 and areas.phi_range == (0.0, 0.0) and areas.phi_ranges.shape == (0, 2)
