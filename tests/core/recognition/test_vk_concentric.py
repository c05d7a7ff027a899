# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures of concentric arcs with known lengths and distances, and toolpaths without concentric arcs."""

from __future__ import annotations

import numpy as np
import programs
import pytest

from vkworkbench.core import linearize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.patterns.concentric import find_arcs
from vkworkbench.core.recognition.patterns.pieces import cut_pieces

QUARTER, CHORDS = np.pi / 2, 60


def found(
    radii, *, way=lambda k: 1, climb=0.0, turned=0.0, centre=(33.0, -21.0), aside=(), chords=CHORDS, sector=QUARTER
):
    """Return the arcs that are found in a program of concentric sectors with the given radii, each of `chords` chords.

    `way(k)` returns the direction of sector k, 1 or -1. The radius grows by `climb` mm along a sector, and
    each sector begins `turned` rad after the previous sector. `aside` lists further points at the end of a sector, as
    radial distances from the end, mm.
    """
    commands = []
    for k, radius in enumerate(radii):
        share = np.linspace(0, 1, chords + 1)[:: way(k)]
        r, angle = radius + climb * share, sector * share - 0.3 + turned * k
        r, angle = np.append(r, r[-1] + np.array(aside)), np.append(angle, np.full(len(aside), angle[-1]))
        points = np.column_stack((centre[0] + r * np.cos(angle), centre[1] + r * np.sin(angle)))
        commands += [("G0", {"Z": 5.0}), ("G0", dict(zip("XY", points[0].tolist()))), ("G1", {"Z": -1.0, "F": 5.0})]
        commands += [("G1", {"X": x, "Y": y}) for x, y in points[1:].tolist()]
    moves = monotonous_areas(linearize(commands))
    pieces = cut_pieces(moves)
    return find_arcs(moves, pieces, np.arange(len(pieces)))


def test_lengths_and_steps_of_arcs_in_one_direction_are_measured():
    arcs = found([10, 12, 14, 16])
    assert (arcs.count, arcs.spiral, arcs.opposite) == (4, 0, 0)
    assert arcs.length == pytest.approx(QUARTER * 52, rel=1e-3)
    assert arcs.step == pytest.approx(2, rel=1e-3) and arcs.even == pytest.approx(1)
    # The measure adds the length of the shorter arc of each pair of neighbours.
    assert arcs.same == pytest.approx(QUARTER * 36, rel=1e-3)


def test_arcs_cut_back_and_forth_are_opposite_to_neighbours():
    arcs = found([10, 12, 14, 16], way=lambda k: 1 - 2 * (k % 2))
    assert arcs.opposite == pytest.approx(QUARTER * 36, rel=1e-3) and arcs.same == 0
    arcs = found([10, 12, 14, 16], way=lambda k: -1 if k == 3 else 1)
    assert (arcs.opposite, arcs.same) == pytest.approx((QUARTER * 14, QUARTER * 22), rel=1e-3)


def test_short_step_of_arcs_is_uneven_and_long_step_is_a_gap():
    uneven = found([10, 12, 14, 16, 16.2, 18.2])
    # The radii 16 and 16.2 mm count as one radius.
    assert uneven.step == pytest.approx(2, rel=1e-3) and uneven.count == 5
    assert uneven.even == pytest.approx((10 + 12 + 14 + 16.2) / (10 + 12 + 14 + 16 + 16.2), rel=1e-3)
    # The measure `even` does not depend on the size of the arcs.
    assert found([20, 24, 28, 32, 32.4, 36.4]).even == pytest.approx(uneven.even)
    apart = found([10, 12, 14, 40, 42])
    assert apart.same == pytest.approx(QUARTER * (10 + 12 + 40), rel=1e-3)
    assert apart.even == pytest.approx((10 + 12 + 40) / (10 + 12 + 14 + 40), rel=1e-3)


@pytest.mark.parametrize(("aside", "count"), [(0.5, 4), (0.7, 5)])
def test_arcs_of_similar_radii_count_as_one_arc(aside, count):
    assert found([10, 12, 14, 16, 16 + aside]).count == count


def test_arc_repeated_at_another_depth_adds_no_step():
    arcs = found([10, 10, 12, 12, 14, 14])
    assert arcs.count == 3 and arcs.same == pytest.approx(QUARTER * 22, rel=1e-3)
    assert found([10, 10, 10]) is None and found([10, 12]) is None


@pytest.mark.parametrize(("climb", "spirals"), [(0.1, False), (0.2, True), (-0.2, True)])
def test_arc_with_growing_radius_is_part_of_a_spiral(climb, spirals):
    """The radius grows by 0.1 or 0.2 mm per quarter turn, which is 0.4 or 0.8 mm per turn.

    Neighbouring arcs are 2 mm apart.
    """
    # The arcs are spread over the full circle, because arcs on one side would also fit circles around another centre.
    arcs = found([10, 12, 14, 16], climb=climb, turned=QUARTER)
    assert arcs.spiral == pytest.approx(arcs.length if spirals else 0)


@pytest.mark.parametrize(("climb", "spirals"), [(0.1, False), (0.3, True)])
def test_arcs_of_few_chords_with_growing_radius_are_a_spiral(climb, spirals):
    """Between the middles of the first and of the last chord, the radius grows by three quarters of `climb`.

    In a full turn of four quarter circles, the radius grows by 0.4 or 1.2 mm.
    """
    arcs = found([10, 12, 14, 16], climb=climb, turned=QUARTER, chords=4)
    assert arcs.spiral == pytest.approx(arcs.length if spirals else 0)


def test_detours_do_not_change_the_centre_of_arcs():
    """Each arc, 16 to 25 mm long, ends with a detour of 0.6 mm away from the centre and back, in small steps."""
    out = np.linspace(0, 0.6, 13)
    arcs = found([10, 12, 14, 16], aside=[*out[1:], *out[-2::-1]])
    assert (arcs.count, arcs.spiral, arcs.opposite) == (4, 0, 0)
    assert arcs.length == pytest.approx(QUARTER * 52 + 4 * 1.2, rel=1e-3) and arcs.step == pytest.approx(2, rel=1e-2)


@pytest.mark.parametrize("degrees", [0, 45, 90])
@pytest.mark.parametrize("lean", [0.0, 2.0])
def test_rows_have_no_common_centre(degrees, lean):
    """The test turns the rows by several angles. With `lean`, each row of 50 mm leans by 2 mm, to alternating sides."""
    rows = np.array(
        [(x, 6.0 * k + lean * (x > 0) * (-1) ** k) for k in range(8) for x in ((0, 50) if k % 2 == 0 else (50, 0))]
    )
    angle = np.radians(degrees)
    rows = rows @ [[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]]
    strokes = [[(*point, -1.0) for point in row] for row in rows.reshape(8, 2, 2).tolist()]
    moves = monotonous_areas(linearize(programs.program(strokes)))
    pieces = cut_pieces(moves)
    assert len(pieces) == 8 and find_arcs(moves, pieces, np.arange(len(pieces))) is None


@pytest.mark.parametrize(("degrees", "bent"), [(17, False), (24, True)])
def test_arc_of_less_than_twenty_degrees_counts_as_straight(degrees, bent):
    """The directions of an arc of 20 degrees scatter as much as the limit allows, a hundredth of the maximum."""
    arcs = found([60, 62, 64, 66], sector=np.radians(degrees))
    assert (arcs is not None) == bent
    assert arcs is None or arcs.step == pytest.approx(2, rel=1e-2)
