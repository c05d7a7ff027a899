# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows as they are measured, of rows that were drawn so."""

from __future__ import annotations

import numpy as np
import programs
import pytest

from vkworkbench.core import linearize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.rows import find_rows, weighted_median


def rows_of(commands):
    """The families of rows among all moves."""
    moves = monotonous_areas(linearize(commands))
    return find_rows(moves, np.arange(len(moves)))


def turned(commands, quarter):
    """The same, by a quarter about Z."""
    return [
        (name, {**p, "X": -p.get("Y", 0.0), "Y": p.get("X", 0.0)} if quarter and "X" in p else p)
        for name, p in commands
    ]


@pytest.mark.parametrize("quarter", [False, True])
def test_a_zigzag_is_one_family(quarter):
    (rows,) = rows_of(turned(programs.zigzag(10, 50.0, 3.0), quarter))
    assert rows.axis == pytest.approx(np.pi / 2 if quarter else 0.0)
    assert (rows.count, rows.lines, rows.step, rows.pitch, rows.period) == pytest.approx((10, 10, 3, 3, 3))
    assert (rows.length, rows.once, rows.typical) == pytest.approx((500, 500, 50))
    assert (rows.opposite, rows.same, rows.even) == pytest.approx((450, 0, 1))


def test_one_way_rows_have_neighbours_the_same_way():
    (rows,) = rows_of(programs.one_way(10, 50.0, 3.0))
    assert (rows.opposite, rows.same, rows.count) == pytest.approx((0, 450, 10))


def test_rows_that_come_again_deeper_are_on_the_same_lines():
    """The first of the second depth lies far from the last of the first: it has no neighbour."""
    (rows,) = rows_of(programs.one_way(10, 50.0, 3.0, depths=(0.0, -1.0)))
    assert (rows.count, rows.lines, rows.length, rows.once) == pytest.approx((20, 10, 1000, 1000))
    assert (rows.same, rows.step, rows.pitch) == pytest.approx((900, 3, 3))


def test_a_row_cut_at_two_depths_before_the_next_counts_once():
    ends = ((0.0, 50.0, 0.0), (50.0, 0.0, -1.0))  # back at the second depth
    strokes = [[(a, 3.0 * row, z), (b, 3.0 * row, z)] for row in range(6) for a, b, z in ends]
    (rows,) = rows_of(programs.program(strokes))
    assert (rows.count, rows.lines, rows.length, rows.once) == pytest.approx((6, 6, 600, 300))


def test_a_row_that_an_island_interrupts_is_one_row():
    strokes = [[(x, 3.0 * row, 0.0), (x + 20.0, 3.0 * row, 0.0)] for row in range(6) for x in (0.0, 30.0)]
    (rows,) = rows_of(programs.program(strokes))
    assert (rows.count, rows.typical, rows.length) == pytest.approx((6, 40, 240))


def test_rows_by_twos_have_a_period():
    """Two sets of lines 10 mm apart, 1 mm aside of one another."""
    strokes = [[(0.0, y, 0.0), (50.0, y, 0.0)] for k in range(8) for y in (10.0 * k, 10.0 * k + 1.0)]
    (rows,) = rows_of(programs.program(strokes))
    assert rows.period == pytest.approx(10.0) and rows.pitch in (1.0, 9.0)


def test_a_grid_has_two_families():
    across = [[(0.0, 3.0 * row, 0.0), (50.0, 3.0 * row, 0.0)] for row in range(12)]
    down = [[(4.0 * row, 0.0, 0.0), (4.0 * row, 33.0, 0.0)] for row in range(13)]
    first, second = rows_of(programs.program(across + down))
    assert (first.axis, second.axis) == pytest.approx((0.0, np.pi / 2))
    assert (first.step, second.step, first.count, second.count) == pytest.approx((3, 4, 12, 13))
    assert not set(first.moves) & set(second.moves)


def test_little_across_the_rows_is_no_family():
    """What is left is looked at only where it is worth it, and kept only where it is much."""
    across = [[(0.0, 3.0 * row, 0.0), (50.0, 3.0 * row, 0.0)] for row in range(12)]
    for count, families in ((0, 1), (1, 1), (2, 2), (13, 2)):
        down = [[(4.0 * row, 0.0, 0.0), (4.0 * row, 33.0, 0.0)] for row in range(count)]
        assert len(rows_of(programs.program(across + down))) == families


def test_two_passes_the_same_way_in_one_stroke_are_steps_and_no_rows():
    """A staircase: what a contour sampled on a grid looks like."""
    stairs = [(10.0 * (k // 2 + k % 2), 3.0 * (k // 2), 0.0) for k in range(20)]
    families = rows_of(programs.program([stairs]))
    assert families[0].same == 0 == families[0].opposite and families[0].count == 10


def test_a_single_row_has_no_step():
    (rows,) = rows_of(programs.program([[(0.0, 5.0, 0.0), (50.0, 5.0, 0.0)]]))
    assert (rows.count, rows.lines, rows.length, rows.once, rows.typical) == (1, 1, 50, 50, 50)
    assert (rows.step, rows.pitch, rows.period, rows.opposite, rows.same, rows.even) == (0,) * 6


def test_uneven_steps_are_told():
    """Steps of 4 mm, but for every third, of 1 mm: two thirds are about as long as the usual one."""
    y = np.cumsum([0, 4, 4, 1] * 4)
    (rows,) = rows_of(programs.program([[(0.0, float(v), 0.0), (50.0, float(v), 0.0)] for v in y]))
    steps = np.diff(y)
    assert rows.step == 4.0
    assert rows.even == pytest.approx((steps == 4).sum() / (steps > 0).sum())


def test_a_median_by_weight():
    values, weights = np.array([3.0, 1.0, 2.0, 9.0]), np.array([1.0, 1.0, 1.0, 5.0])
    assert weighted_median(values, weights) == 9.0
    assert weighted_median(values, np.ones(4)) == 2.0
    assert weighted_median(values[:1], weights[:1]) == 3.0


def test_steps_of_a_stroke_are_none_in_whatever_area_it_lies():
    before = [[(0.0, -80.0, 0.0), (1.0, -80.0, 0.0)]]
    stairs = [(10.0 * (k // 2 + k % 2), 3.0 * (k // 2), 0.0) for k in range(20)]
    families = rows_of(programs.program(before + [stairs]))
    assert families[0].same == 0
