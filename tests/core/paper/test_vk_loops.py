# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed loops in a path, and the full turns of a spiral or helix."""

from __future__ import annotations

import numpy as np
import programs
import pytest
from drawings import polygon, winding

from vkworkbench.core import linearize
from vkworkbench.core.paper import monotonous_areas, winding_turns
from vkworkbench.core.paper.loops import is_closed, may_be_closed


def areas_of(*strokes):
    return monotonous_areas(linearize(programs.program(strokes)))


def loops_of(*strokes):
    """Return (number of moves before the loop, number of moves in the loop) for each loop."""
    first, end = areas_of(*strokes).loops
    return list(zip(first.tolist(), (end - first).tolist()))


def linked(*rings):
    return [point for ring in rings for point in ring]


def test_each_of_linked_offsets_is_a_loop():
    sides = 40, 36, 32, 28
    assert loops_of(linked(*(polygon(side) for side in sides))) == [(0, 4), (5, 4), (10, 4), (15, 4)]
    assert loops_of(linked(*(polygon(side, clockwise=True) for side in sides))) == [(0, 4), (5, 4), (10, 4), (15, 4)]


def test_loops_with_a_lift_between_them_are_found_separately():
    assert loops_of(polygon(40), polygon(36), polygon(40)) == [(0, 4), (4, 4), (8, 4)]
    # A loop that is cut again later counts as a second loop and does not make the first loop longer.
    assert loops_of(polygon(40), [(0, 0, 0), (9, 0, 0)], polygon(40)) == [(0, 4), (5, 4)]


@pytest.mark.parametrize("times", [2, 3, 4])
def test_contour_repeated_in_one_stroke_is_several_loops(times):
    assert loops_of(polygon(40) + (times - 1) * polygon(40)[1:]) == [(4 * k, 4) for k in range(times)]


def test_loops_around_repeated_contour_are_found_in_order():
    path = linked(polygon(40, x=-100), polygon(40) + 2 * polygon(40)[1:], polygon(40, x=100), polygon(40, x=200))
    assert loops_of(path) == [(0, 4), (5, 4), (9, 4), (13, 4), (18, 4), (23, 4)]


@pytest.mark.parametrize(("gap", "is_one"), [(0.01, True), (0.02, True), (0.028, True), (0.035, False), (0.05, False)])
def test_nearly_closed_loop_is_found_anywhere_in_the_path(gap, is_one):
    """The loop is found if it is the last possible loop of the path, and if other areas follow."""
    for right in np.arange(0, 0.13, 0.005):
        around = polygon(40, x=100 + right)
        left = (around[-1][0] - gap, *around[-1][1:])
        path = linked(polygon(40), [*around[:-1], left])
        assert loops_of(path) == [(0, 4), (5, 4)][: 1 + is_one]
        assert loops_of(path, polygon(40, x=-200)) == [(0, 4), *([(5, 4)] if is_one else []), (9, 4)]


@pytest.mark.parametrize("degrees", range(0, 360, 15))
@pytest.mark.parametrize("tip", [30, 10])
def test_lead_in_and_out_does_not_change_loop_count(tip, degrees):
    """The path begins and ends at the tip of the lead, where the direction reverses.

    The number of loops must not depend on the sign of this half-turn.
    """
    around = [(20, 20), (-20, 20), (-20, -20), (20, -20), (20, 0)]
    path = np.array([(tip, 0), (20, 0), *around, *around, (tip, 0)])
    angle = np.radians(degrees)
    path = path @ [[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]]
    assert loops_of([(x, y, 0.0) for x, y in path.tolist()]) == [(1, 5), (6, 5)]


def test_return_to_the_start_without_full_turn_is_not_a_loop():
    eight = [
        (0, 0, 0),
        (10, 10, 0),
        (20, 0, 0),
        (10, -10, 0),
        (0, 0, 0),
        (-10, 10, 0),
        (-20, 0, 0),
        (-10, -10, 0),
        (0, 0, 0),
    ]
    assert loops_of([(20 * (k % 2), 0.0, 0.0) for k in range(12)]) == []
    assert loops_of(eight) == [(0, 4), (4, 4)]
    assert loops_of([*eight[:5], *reversed(eight[:4])]) == [(0, 4), (4, 4)]  # The path has one loop in each direction.


def contoured(count, notches=0):
    """Return rows with a contour through their start, and the numbers of moves in the rows and in the contour.

    The contour has notches on its right side.
    """
    top = 3.0 * (count - 1)
    rows = [(x, 3.0 * k, 0.0) for k in range(count) for x in ((0.0, 40.0) if k % 2 == 0 else (40.0, 0.0))]
    steps = [(x, 2.0 + 2 * k + y, 0.0) for k in range(notches) for x, y in ((45.0, 0), (44.0, 0), (44.0, 1), (45.0, 1))]
    around = [(-5.0, top, 0.0), (-5.0, 0.0, 0.0), (0.0, 0.0, 0.0), (45.0, 0.0, 0.0), *steps, (45.0, top, 0.0),
              (-5.0, top, 0.0)]  # fmt: skip
    return rows + around, len(rows), 5 + len(steps)


@pytest.mark.parametrize("count", [4, 10])
def test_contour_through_zigzag_start_is_the_loop(count):
    path, rows, around = contoured(count)
    assert loops_of(path) == [(rows, around)]
    # A separate loop before the path does not change which loop is found in the path.
    assert loops_of(polygon(40), path) == [(0, 4), (4 + rows, around)]


def test_small_loops_inside_a_zigzag_do_not_hide_the_contour():
    path, rows, around = contoured(10)

    def little(x, y, up):
        return [(x, y, 0.0), (x + 4, y, 0.0), (x + 4, y + up, 0.0), (x, y + up, 0.0), (x, y, 0.0)]

    # Two rows in the +X direction get one loop to the left and one to the right, so the sum of the turns is unchanged.
    first, second = ([*little(20.0, y, 1.0), *little(30.0, y, -1.0)] for y in (6.0, 12.0))
    assert loops_of([*path[:5], *first, *path[5:9], *second, *path[9:]]) == [(rows + 20, around)]


def test_two_rows_and_the_return_are_one_loop():
    path, rows, _ = contoured(2)
    assert loops_of(path) == [(0, rows + 2)]


@pytest.mark.parametrize("notches, is_the_loop", [(1, True), (3, False)])
def test_rows_stay_rows_if_a_wavy_contour_follows_them(notches, is_the_loop):
    """Ten rows turn by four turns more than a loop, and each notch of the contour adds one turn."""
    path, rows, around = contoured(10, notches)
    assert (loops_of(path)[0] == (rows, around)) is is_the_loop


@pytest.mark.parametrize("first, last, sense", [(10, 10, 1), (2, 26, 1), (26, 2, -1)])
def test_turns_of_a_spiral_or_helix_begin_at_full_turns_of_phi(first, last, sense):
    points = winding(first, last, 5, drop=3.0)
    areas = areas_of([(x, sense * y, z) for x, y, z in points])
    turns = winding_turns(areas, np.array([0]), np.array([len(areas)]), np.array([float(sense)]))
    assert turns[:4].tolist() == pytest.approx([36, 72, 108, 144], abs=3)
    # The last move of a spiral can be the first move of a further turn.
    round_again = 2 * np.pi * np.arange(1, len(turns) + 1)
    assert (sense * areas.phi[turns] >= round_again - 1e-6).all() and (sense * areas.phi[turns - 1] < round_again).all()


@pytest.mark.parametrize("first, second", [(3, 4), (4, 3)])
def test_full_turns_of_two_spirals_are_counted_separately(first, second):
    up, down = winding(10, 10, first, drop=2.0), [(x, -y, z) for x, y, z in winding(8, 8, second, drop=2.0)]
    areas = areas_of([(0, 0, 0), (50, 0, 0), (50, 5, 0), (0, 5, 0)], up, down)
    turns = winding_turns(areas, areas.start[1:], areas.end[1:], np.array([1.0, -1.0]))
    assert len(turns) == first - 1 + second - 1
    of_first, of_second = turns[: first - 1], turns[first - 1 :]
    assert (
        (areas.start[1] < of_first).all() and (of_first < areas.start[2]).all() and (of_second > areas.start[2]).all()
    )


def test_turn_of_a_wavy_spiral_is_counted_once():
    """A wavy spiral has the same direction at several places of each turn."""
    angles = np.arange(0, 4 * 2 * np.pi, 0.1)
    radius = 20 + 3 * np.cos(7 * angles) + angles
    areas = areas_of(list(zip(radius * np.cos(angles), radius * np.sin(angles), np.zeros(len(angles)))))
    turns = winding_turns(areas, areas.start, areas.end, np.ones(1))
    assert len(turns) in (3, 4) and (np.diff(turns) > 40).all()


def test_triangle_is_a_loop_but_move_there_and_back_is_not():
    assert is_closed(np.zeros(2), np.full(2, 100.0), np.array([3, 2])).tolist() == [True, False]
    assert loops_of(polygon(40, corners=3)) == [(0, 3)]


@pytest.mark.parametrize("length", [3.0, 100.0, 4000.0])
def test_enclosed_area_is_at_most_that_of_a_circle(length):
    gap = np.geomspace(1e-3, length, 200)
    circle = np.full(200, length**2 / (4 * np.pi))
    assert may_be_closed(gap, np.full(200, length)).tolist() == is_closed(gap, circle, np.full(200, 99)).tolist()
