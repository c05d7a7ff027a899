# SPDX-License-Identifier: LGPL-2.1-or-later
"""The way in and the way out are told beside the pattern, and the pattern decides."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from vkworkbench.core import Strategy
from vkworkbench.core.gcode import linearize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.entries import without_entries
from vkworkbench.core.recognition.recognize import recognize

ABOVE = [("G0", {"X": 0.0, "Y": 0.0, "Z": 2.0})]
DEEP = -5.0


def helix(turns=10, radius=2.0):
    """Commands of a helix down from the part's top, which ends at (radius, 0)."""
    down = [("G3", {"X": radius, "Y": 0.0, "Z": DEEP * (k + 1) / turns, "I": -radius, "J": 0.0}) for k in range(turns)]
    return [*ABOVE, ("G1", {"X": radius, "Y": 0.0, "Z": 0.0, "F": 5.0}), *down]


def offsets(count=3, first=6.0, step=3.0):
    """Commands of linked square loops that grow."""
    loops = []
    for k in range(count):
        h = first + k * step
        corners = ((h, -h), (h, h), (-h, h), (-h, -h), (h, -h))
        loops += [("G1", {"X": x, "Y": y}) for x, y in corners]
    return loops


def rows(count=12, length=40.0, step=2.0):
    """Commands of a zigzag that begins at the origin."""
    ends = [(0.0, length)[(k + 1) // 2 % 2] for k in range(2 * count)]
    return [("G1", {"X": x, "Y": step * (k // 2)}) for k, x in enumerate(ends)]


def ramp(passes=10, length=10.0):
    """Commands of a ramp to and fro along X, which ends at the origin."""
    down = [("G1", {"X": length * (1 - k % 2), "Z": DEEP * (k + 1) / passes}) for k in range(passes)]
    return [*ABOVE, ("G1", {"Z": 0.0, "F": 5.0}), *down]


CASES = [
    (helix() + offsets(), Strategy.CONTOUR_PARALLEL, "helix"),
    (ramp() + offsets(), Strategy.CONTOUR_PARALLEL, "zigzag ramp"),
    (ramp() + rows(), Strategy.ZIGZAG, "zigzag ramp"),
    (helix() + rows(), Strategy.ZIGZAG, "helix"),
]
NAMES = [f"{strategy.value} after a {entry}" for _, strategy, entry in CASES]


@pytest.mark.parametrize("commands, strategy, entry", CASES, ids=NAMES)
def test_the_pattern_decides_and_the_entry_is_told_beside_it(commands, strategy, entry):
    found = recognize(linearize(commands), tool_diameter=4.0)
    assert (found.strategy, found.entry) == (strategy, entry), found.reason
    assert f", entered by a {entry.replace('zigzag ramp', 'ramp to and fro')}" in found.reason


@pytest.mark.parametrize("commands, strategy, entry", CASES, ids=NAMES)
def test_a_way_out_counts_as_little_as_a_way_in(commands, strategy, entry):
    path = linearize(commands)
    cutting = slice(1, None)  # the rapid to the start stays the first
    points = np.vstack([path.points[:1], path.points[cutting][::-1]])
    back = replace(path, points=points)
    assert recognize(back, tool_diameter=4.0).strategy is strategy


def test_a_helix_that_is_the_operation_is_a_helix():
    level = [("G3", {"X": 2.0, "Y": 0.0, "I": -2.0, "J": 0.0})]
    found = recognize(linearize(helix() + level), tool_diameter=4.0)
    assert found.strategy is Strategy.HELIX and found.entry is None


def test_the_ramp_along_a_contour_is_a_part_of_it():
    corners = [(40.0, 0.0), (40.0, 30.0), (0.0, 30.0), (0.0, 0.0)]
    down = [("G1", {"X": x, "Y": y, "Z": -0.5 * (k + 1)}) for k, (x, y) in enumerate(corners)]
    path = linearize([*ABOVE, ("G1", {"Z": 0.0, "F": 5.0}), *down, *(("G1", {"X": x, "Y": y}) for x, y in corners)])
    moves = monotonous_areas(path)
    assert without_entries(moves)[0] is moves
    assert recognize(path).strategy is Strategy.PROFILE


def test_areas_without_entries_begin_to_turn_anew():
    moves = monotonous_areas(linearize(helix() + rows() + [("G0", {"Z": 2.0})] + ramp() + rows()))
    pattern, wound = without_entries(moves)
    assert 0 < wound < 1 and len(pattern) < len(moves) and len(pattern.start) == len(moves.start)
    assert not pattern.dz.any()
    assert not pattern.phi[pattern.start].any() and not pattern.turning[pattern.start].any()
    assert np.allclose(np.diff(pattern.phi)[: pattern.end[0] - 1], pattern.turning[1 : pattern.end[0]])
    assert np.isin(pattern.index[pattern.reversals], moves.index[moves.reversals]).all()
    assert set(moves.index) - set(pattern.index) == set(moves.index[np.abs(moves.dz) > 0])


@pytest.mark.parametrize("last", [False, True])
def test_a_contour_around_the_rows_is_their_finishing_pass(last):
    corners = ((-1.0, -1.0), (41.0, -1.0), (41.0, 23.0), (-1.0, 23.0), (-1.0, -1.0))
    contour = [("G0", {"Z": 2.0}), ("G0", {"X": -1.0, "Y": -1.0}), ("G1", {"Z": DEEP})]
    contour += [("G1", {"X": x, "Y": y}) for x, y in corners]
    inside = [("G0", {"Z": 2.0}), ("G0", {"X": 0.0, "Y": 0.0}), ("G1", {"Z": DEEP, "F": 5.0}), *rows()]
    found = recognize(linearize(inside + contour if last else contour + inside), tool_diameter=3.0)
    assert found.strategy is Strategy.ZIGZAG and found.finishing
    assert found.reason.endswith(", finished by a contour around the rows")
    alone = recognize(linearize(inside), tool_diameter=3.0)
    assert alone.strategy is Strategy.ZIGZAG and not alone.finishing
