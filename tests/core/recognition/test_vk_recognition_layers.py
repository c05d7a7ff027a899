# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lead-in and lead-out are reported, but only the pattern between them decides the strategy."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import programs
import pytest
from drawings import winding

from vkworkbench.core import Strategy
from vkworkbench.core.gcode import linearize
from vkworkbench.core.paper import TURN, monotonous_areas
from vkworkbench.core.recognition.patterns.entries import _first, _way_out, find_entry, without_entries
from vkworkbench.core.recognition.programs.recognize import recognize

ABOVE = [("G0", {"X": 0.0, "Y": 0.0, "Z": 2.0})]
DEEP = -5.0


def helix(turns=10, radius=2.0):
    """Return the commands of a helix down from the part's top, which ends at (radius, 0)."""
    down = [("G3", {"X": radius, "Y": 0.0, "Z": DEEP * (k + 1) / turns, "I": -radius, "J": 0.0}) for k in range(turns)]
    return [*ABOVE, ("G1", {"X": radius, "Y": 0.0, "Z": 0.0, "F": 5.0}), *down]


def offsets(count=3, first=6.0, step=3.0):
    """Return the commands of linked square loops that grow."""
    loops = []
    for k in range(count):
        h = first + k * step
        corners = ((h, -h), (h, h), (-h, h), (-h, -h), (h, -h))
        loops += [("G1", {"X": x, "Y": y}) for x, y in corners]
    return loops


def rows(count=12, length=40.0, step=2.0):
    """Return the commands of a zigzag that begins at the origin."""
    ends = [(0.0, length)[(k + 1) // 2 % 2] for k in range(2 * count)]
    return [("G1", {"X": x, "Y": step * (k // 2)}) for k, x in enumerate(ends)]


def ramp(passes=10, length=10.0):
    """Return the commands of a ramp back and forth along X, which ends at the origin."""
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
def test_pattern_decides_and_entry_is_reported(commands, strategy, entry):
    found = recognize(linearize(commands), tool_diameter=4.0)
    assert (found.strategy, found.entry) == (strategy, entry), found.reason
    assert f" The tool enters on a {entry.replace('zigzag ramp', 'ramp that goes back and forth')}." in found.reason


@pytest.mark.parametrize("commands, strategy, entry", CASES, ids=NAMES)
def test_lead_out_does_not_change_the_strategy(commands, strategy, entry):
    path = linearize(commands)
    cutting = slice(1, None)  # The rapid to the start remains the first move.
    points = np.vstack([path.points[:1], path.points[cutting][::-1]])
    back = replace(path, points=points)
    assert recognize(back, tool_diameter=4.0).strategy is strategy


def test_helix_without_another_pattern_is_a_helix():
    level = [("G3", {"X": 2.0, "Y": 0.0, "I": -2.0, "J": 0.0})]
    found = recognize(linearize(helix() + level), tool_diameter=4.0)
    assert found.strategy is Strategy.HELIX and found.entry is None


def test_ramp_along_a_contour_is_part_of_the_contour():
    corners = [(40.0, 0.0), (40.0, 30.0), (0.0, 30.0), (0.0, 0.0)]
    down = [("G1", {"X": x, "Y": y, "Z": -0.5 * (k + 1)}) for k, (x, y) in enumerate(corners)]
    path = linearize([*ABOVE, ("G1", {"Z": 0.0, "F": 5.0}), *down, *(("G1", {"X": x, "Y": y}) for x, y in corners)])
    moves = monotonous_areas(path)
    assert without_entries(moves)[0] is moves
    assert recognize(path).strategy is Strategy.PROFILE


def test_phi_starts_at_0_in_each_area_after_its_entry_is_removed():
    moves = monotonous_areas(linearize(helix() + rows() + [("G0", {"Z": 2.0})] + ramp() + rows()))
    pattern, wound = without_entries(moves)
    assert 0 < wound < 1 and len(pattern) < len(moves) and len(pattern.start) == len(moves.start)
    assert not pattern.dz.any()
    assert not pattern.phi[pattern.start].any() and not pattern.turning[pattern.start].any()
    assert np.allclose(np.diff(pattern.phi)[: pattern.end[0] - 1], pattern.turning[1 : pattern.end[0]])
    assert np.isin(pattern.index[pattern.reversals], moves.index[moves.reversals]).all()
    assert set(moves.index) - set(pattern.index) == set(moves.index[np.abs(moves.dz) > 0])


@pytest.mark.parametrize("last", [False, True])
def test_contour_around_the_rows_is_their_finishing_pass(last):
    corners = ((-1.0, -1.0), (41.0, -1.0), (41.0, 23.0), (-1.0, 23.0), (-1.0, -1.0))
    contour = [("G0", {"Z": 2.0}), ("G0", {"X": -1.0, "Y": -1.0}), ("G1", {"Z": DEEP})]
    contour += [("G1", {"X": x, "Y": y}) for x, y in corners]
    inside = [("G0", {"Z": 2.0}), ("G0", {"X": 0.0, "Y": 0.0}), ("G1", {"Z": DEEP, "F": 5.0}), *rows()]
    found = recognize(linearize(inside + contour if last else contour + inside), tool_diameter=3.0)
    assert found.strategy is Strategy.ZIGZAG and found.finishing
    assert found.reason.endswith(" A contour around the rows finishes the area.")
    alone = recognize(linearize(inside), tool_diameter=3.0)
    assert alone.strategy is Strategy.ZIGZAG and not alone.finishing


def box(left, bottom, right, top):
    """Return a closed stroke along a rectangle, 4 mm deep."""
    corners = ((left, bottom), (right, bottom), (right, top), (left, top), (left, bottom))
    return [(x, y, -4.0) for x, y in corners]


def between(left, right, bottom, top):
    """Return rows cut back and forth, 3 mm apart, in one stroke."""
    ends = ((left, right), (right, left))
    return [(x, y, -4.0) for row, y in enumerate(np.arange(bottom, top + 0.1, 3.0)) for x in ends[row % 2]]


ROUND_ISLANDS = [box(14, 8, 26, 20), box(14, 30, 26, 42)]
PARTS = [
    between(0, 40, 0, 6),
    between(0, 12, 8, 42),
    between(28, 40, 8, 42),
    between(14, 26, 22, 28),
    between(0, 40, 44, 50),
]


@pytest.mark.parametrize(
    "strokes",
    [
        [*PARTS, box(-1, -1, 41, 51), *ROUND_ISLANDS],
        [*PARTS, *ROUND_ISLANDS, box(-1, -1, 41, 51)],
        [*ROUND_ISLANDS, *PARTS],
    ],
    ids=["wall first", "islands first", "islands alone"],
)
def test_contours_around_islands_finish_the_rows(strokes):
    found = recognize(linearize(programs.program(strokes)), tool_diameter=3.0)
    assert found.strategy is Strategy.ZIGZAG and found.finishing, found.reason


def areas(*strokes):
    return monotonous_areas(linearize(programs.program(strokes)))


def way_down(*points, x=0.0):
    """Return a stroke down along some points, and then around a rectangle of 60 x 40 mm at the last height."""
    b, z = points[-1][1:]
    corners = ((60, 0), (60, 40), (0, 40), (0, 0), (60, 0))
    return [*((x + a, b, z) for a, b, z in points), *((x + a, b + c, z) for a, c in corners)]


SINGLE = [(0, 0, 0), (20, 0, -3)]
RAMP = [(0, 0, 0), (20, 0, -1), (40, 0, -4)]
CORNER = [(0, 0, 0), (20, 0, -1), (20, 20, -3)]  # A quarter turn is not a winding.
TO_AND_FRO = [(0, 0, 0), (20, 0, -1), (0, 0, -2), (20, 0, -3)]
HELIX = [(4 * np.cos(a), 4 * np.sin(a) - 4, -5 * a / TURN) for a in np.linspace(0, TURN, 25)]
DOWN_ALL_ALONG = [(200 + x, y, 2 * z) for x, y, z in HELIX]


@pytest.mark.parametrize(
    "strokes, entry",
    [
        ([way_down((0, 0, -1))], "plunge"),
        ([way_down(*SINGLE)], "ramp"),
        ([way_down(*CORNER)], "ramp"),
        ([way_down(*TO_AND_FRO)], "zigzag ramp"),
        ([way_down(*HELIX)], "helix"),
        ([way_down(*RAMP), way_down(*TO_AND_FRO, x=100)], "ramp"),  # The ramp is 4 mm deep, and the zigzag ramp 3 mm.
        ([way_down(*TO_AND_FRO, x=100), way_down(*RAMP)], "ramp"),
        # The two ramps descend by 6 mm in total, and the helix descends by 5 mm.
        ([way_down(*SINGLE), way_down(*SINGLE, x=100), way_down(*HELIX, x=200)], "ramp"),
        ([way_down(*SINGLE), way_down(*TO_AND_FRO, x=100), way_down(*HELIX, x=200)], "helix"),
        ([way_down((0, 0, 0), (20, 0, -0.01)), way_down(*SINGLE, x=100)], "ramp"),
        ([way_down(*RAMP), DOWN_ALL_ALONG], "ramp"),  # No level move follows the helix.
        ([DOWN_ALL_ALONG], None),
        ([[*way_down((0, 0, -1)), (50, 0, -1.5)]], "plunge"),  # A level move comes first.
        ([way_down((0, 0, 0), (20, 0, -0.01))], "plunge"),  # A descent of 0.01 mm does not count as a ramp.
        (
            [[(0, 0, 0), (20, 0, -1), (60, 0, -1), (60, 20, -2), (0, 20, -3)]],
            None,
        ),  # Only 40 mm of the path's 120 mm are level.
        (
            [[(0, 0, 0), (20, 0, -1), (20, 90, -1), (60, 90, -2), (60, 70, -3)]],
            "ramp",
        ),  # 90 mm of the path's 150 mm are level.
    ],
)
def test_kind_of_entry_with_most_of_the_descent_is_reported(strokes, entry):
    assert find_entry(areas(*strokes)) == entry


WAYS_IN = [SINGLE, RAMP, CORNER, TO_AND_FRO, HELIX]


@pytest.mark.parametrize("points", WAYS_IN, ids=["one move", "ramp", "around a corner", "to and fro", "helix"])
def test_entry_is_not_part_of_pattern_unless_it_winds(points):
    """Without the entry, the rectangle remains. Only an entry by a helix of one turn counts as winding."""
    moves = areas(way_down(*points))
    pattern, wound = without_entries(moves)
    assert len(pattern) == len(moves) - (len(points) - 1) and not pattern.dz.any()
    way_in = moves.length[: len(points) - 1].sum()
    assert wound == pytest.approx(way_in / moves.length.sum() if points is HELIX else 0.0)


def test_sharp_turns_after_straight_entry_are_not_winding():
    """Two turns of 150 degrees are more than three quarters of a full turn, but neither is part of the ramp."""
    turned = np.cumsum(np.radians([150, 150, 30, 30]))
    steps = 20 * np.column_stack((np.cos(turned), np.sin(turned), np.zeros(4)))
    moves = areas([(0, 0, 0), (20, 0, -1), *(np.array((20, 0, -1)) + np.cumsum(steps, axis=0)).tolist()])
    pattern, wound = without_entries(moves)
    assert len(pattern) == len(moves) - 1 and wound == 0.0


@pytest.mark.parametrize("wider, leads", [(2.0, False), (4.0, True)])
def test_helix_is_an_entry_if_the_path_leads_farther_out(wider, leads):
    """The helix has a radius of 4 mm, so the diagonal of its bounding box is 11.3 mm.

    A spiral follows at its lower end.
    """
    moves = areas(winding(4, 4, 2, drop=2) + winding(4, 4 + wider, 3, z=-2)[1:])
    pattern, wound = without_entries(moves)
    assert len(moves) - len(pattern) == (72 if leads else 0) and bool(wound) is leads


def test_entries_and_exits_are_removed_from_each_area():
    strokes = [way_down((0, 0, -1)), way_down(*HELIX, x=100), [*way_down(*SINGLE, x=200), (240, 0, 0)]]
    moves = areas(*strokes)
    pattern, wound = without_entries(moves)
    assert np.diff(pattern.start, append=len(pattern)).tolist() == [5, 5, 5]
    assert wound == pytest.approx(8 * np.pi / moves.length.sum(), rel=0.01)


@pytest.mark.parametrize(
    "other, before, after",
    [
        ("--x x- ----", [2, 0, 4], [0, 1, 4]),
        ("x-x -- --x-", [0, 2, 2], [0, 2, 1]),
        ("--- -- ----", [3, 2, 4], [3, 2, 4]),
        ("xxx xx xxxx", [0, 0, 0], [0, 0, 0]),
        ("-x- -x x---", [1, 1, 0], [1, 0, 3]),
    ],
)
def test_moves_before_and_after_the_level_moves_are_counted(other, before, after):
    level = [[one == "x" for one in area] for area in other.split()]
    moves = areas(*([(10.0 * k, 5.0 * (k % 2), k - sum(area[:k])) for k in range(len(area) + 1)] for area in level))
    assert (_first(moves.start, moves.end, np.concatenate(level)) - moves.start).tolist() == before
    assert _way_out(moves).tolist() == after


def out_and(*points, at=0.0):
    """Return a path of two level moves, then through the points, and 40 mm along -Y at the last height."""
    x, y, z = points[-1]
    stroke = [(0, 0, 0), (6, 0, 0), (6, 8, 0), *points, (x, y - 40, z), (x + 5, y - 40, z)]
    return areas([(at + x, y - at, z) for x, y, z in stroke])


@pytest.mark.parametrize("at", [0.0, 70.0])
@pytest.mark.parametrize(
    ("points", "entry", "left"),
    [
        ([(6, 0, -1), (0, 0, -2)], "ramp", 2),  # The ramp ends at the start of the path.
        ([(6, 0, -1), (1, 0, -2)], "plunge", 6),  # The ramp does not reach the start of the path.
        ([(0, 0, -2)], "plunge", 5),  # The way back is on another line.
        ([(6, 0, 0), (0, 0, 0)], "plunge", 6),  # The way back is level.
    ],
)
def test_ramp_back_on_the_line_of_a_level_move_is_an_entry(points, entry, left, at):
    moves = out_and(*points, at=at)
    assert find_entry(moves) == entry
    assert len(without_entries(moves)[0]) == left


def test_removing_the_ramp_of_one_area_keeps_the_other_areas():
    first = [(100, 0, -1), (140, 0, -1), (140, 5, -1)]
    out = [(0, 0, 0), (20, 0, 0), (0, 0, -1), (0, 40, -1), (5, 40, -1)]
    pattern, _ = without_entries(areas(first, out, first))
    assert np.diff(pattern.start, append=len(pattern)).tolist() == [2, 2, 2]
