# SPDX-License-Identifier: LGPL-2.1-or-later
"""Spurs: detours that go out and back on the same line, which reliefs in corners add to a contour."""

from __future__ import annotations

import numpy as np
import programs
import pytest

from vkworkbench.core import linearize
from vkworkbench.core.paper import TURN, monotonous_areas
from vkworkbench.core.recognition.patterns.spurs import some_moves, without_spurs


def areas(*strokes):
    return monotonous_areas(linearize(programs.program(strokes)))


def square(out=None, side=40.0, z=0.0, closed=True, turned=0.0):
    """Return a square that begins in the middle of a side.

    `out` is the length of a detour out and back from one corner.
    """
    half = side / 2
    points = [(0.0, 0.0, z), (half, 0.0, z)]
    if out:
        points += [(half + out, -out, z + turned), (half, 0.0, z)]
    points += [(half, side, z), (-half, side, z), (-half, 0.0, z)]
    return points + [(0.0, 0.0, z)] * closed


def test_removing_a_spur_keeps_the_corner_turn():
    plain, spurred = areas(square()), areas(square(2.0))
    kept = without_spurs(spurred)
    assert len(spurred) == len(plain) + 2 and len(kept) == len(plain)
    for name in ("dx", "dy", "length", "turning", "phi", "alpha"):
        assert getattr(kept, name) == pytest.approx(getattr(plain, name), abs=1e-9)
    assert not len(kept.reversals) and len(spurred.reversals) == 1
    assert kept.phi[-1] == pytest.approx(TURN)


def test_phi_of_each_area_starts_at_its_own_first_move():
    moves = areas(square(2.0), square(2.0, side=60.0, z=-1.0), square())
    kept = without_spurs(moves)
    assert np.diff(kept.start, append=len(kept)).tolist() == [5, 5, 5]
    assert kept.phi[kept.start].tolist() == [0, 0, 0] and kept.phi[kept.end - 1] == pytest.approx([TURN] * 3)


@pytest.mark.parametrize(
    "stroke",
    [square(2.0, closed=False)[:-1], square(17.0), square(2.0, turned=1.0), square()],
    ids=["open", "long", "down", "none"],
)
def test_detours_that_are_not_corner_reliefs_are_kept(stroke):
    """A detour is not a corner relief in an open stroke, with a fifth of the length, or if it goes down."""
    moves = areas(stroke)
    assert without_spurs(moves) is moves


@pytest.mark.parametrize("near", [(1.0, 20.0), (20.0, 1.0)], ids=["before", "behind"])
def test_long_detour_is_not_a_corner_relief(near):
    """The detour of 2.8 mm is longer than one of the corner's sides, which has a point 1 mm away from the corner."""
    before, behind = near
    points = [(0, 0, 0), (20 - before, 0, 0), (20, 0, 0), (22, -2, 0), (20, 0, 0), (20, behind, 0), (20, 40, 0)]
    moves = areas([*points, (-20, 40, 0), (-20, 0, 0), (0, 0, 0)])
    assert without_spurs(moves) is moves
    longer = areas([(0, 0, 0), (17, 0, 0), *points[2:5], (20, 3, 0), (20, 40, 0), (-20, 40, 0), (-20, 0, 0), (0, 0, 0)])
    assert len(without_spurs(longer)) == len(longer) - 2


@pytest.mark.parametrize("ahead", [True, False], ids=["along the side before", "along the side behind"])
def test_removing_a_spur_along_a_side_leaves_no_reversal(ahead):
    """The detour continues a side, returns on the same line, and the path leaves the corner by a quarter turn."""
    tip = (23, 0, 0) if ahead else (20, 3, 0)
    moves = areas([(0, 0, 0), (20, 0, 0), tip, (20, 0, 0), (20, 40, 0), (-20, 40, 0), (-20, 0, 0), (0, 0, 0)])
    kept = without_spurs(moves)
    assert len(kept) == len(moves) - 2 and not len(kept.reversals) and not len(kept.unsigned)
    assert kept.turning[1] == pytest.approx(TURN / 4) and kept.phi[-1] == pytest.approx(TURN)


def test_reversals_outside_of_corner_reliefs_are_kept():
    """The toolpath is a contour with a relief move, and then a zigzag on one line."""
    moves = areas(square(2.0), [(0, -80, 0), (30, -80, 0), (0, -80, 0), (30, -80, 0)])
    kept = without_spurs(moves)
    assert len(moves.reversals) == 3 and kept.reversals.tolist() == (moves.reversals[1:] - 2).tolist()


@pytest.mark.parametrize("off, there", [(0.01, False), (0.05, True)])
def test_detour_that_misses_its_start_is_not_a_corner_relief(off, there):
    """The move back misses the start of the detour by less or more than the tolerance for one line."""
    points = [(0, 0, 0), (20, 0, 0), (24, -3, 0), (20 - 0.8 * off, 0.6 * off, 0), (20, 40, 0), (-20, 40, 0)]
    moves = areas([*points, (-20, 0, 0), (0, 0, 0)])
    assert len(moves.reversals) == 1 and len(without_spurs(moves)) == len(moves) - (0 if there else 2)


@pytest.mark.parametrize("deep, there", [(0.005, False), (0.015, True)])
def test_detour_that_goes_down_is_not_a_corner_relief(deep, there):
    """A detour down and up again moves by twice its depth in Z.

    Heights that differ by up to 0.02 mm count as one depth.
    """
    moves = areas(square(2.0, turned=-deep))
    assert len(without_spurs(moves)) == len(moves) - (0 if there else 2)


@pytest.mark.parametrize("out, there", [(13.9, False), (14.5, True)])
def test_corner_reliefs_have_less_than_a_fifth_of_a_contour(out, there):
    """The detour has 39.3 of 199.3 mm, or 41 of 201 mm. Each side of the path is longer than the detour's way out."""
    corners = [(20, 0), (20 + out, -out), (20, 0), (20, 40), (-20, 40), (-20, 0)]
    moves = areas([(-20, 0, 0), *((x, y, 0) for x, y in corners)])
    assert len(without_spurs(moves)) == len(moves) - (0 if there else 2)


def test_consecutive_detours_are_not_corner_reliefs():
    """Repeated moves on one line are a separate stroke. Only the first move out and back could be a relief."""
    there, half = (21.0, -1.0, 0.0), (20.0, 0.0, 0.0)
    stroke = square()
    moves = areas([*stroke[:2], there, half, there, half, *stroke[2:]])
    assert len(without_spurs(moves)) >= len(moves) - 2


def test_phi_restarts_after_removed_first_moves():
    moves = areas(square(), square(side=60.0))
    kept = np.ones(len(moves), bool)
    kept[[0, 1]] = False
    left = some_moves(moves, kept)
    assert left.start.tolist() == [0, 3] and left.phi[0] == 0 == left.turning[0]
    assert left.phi[:3] == pytest.approx([0, TURN / 4, TURN / 2]) and left.phi[3:] == pytest.approx(moves.phi[5:])
    assert left.length.tolist() == moves.length[kept].tolist()
