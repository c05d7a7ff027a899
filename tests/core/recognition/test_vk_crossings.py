# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures of neighbouring crossings on scan lines, for drawn passes with known measures."""

from __future__ import annotations

from math import log, log1p

import numpy as np
import programs
import pytest

from vkworkbench.core import linearize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.verdict.crossings import FROM_THE_MIDDLE, NAMES, Sample, _cross, measure_crossings

EXTENT = 60.0
ROWS, STEP = 10, 3.0
# Measures of ten rows, 3 mm apart, cut in their order.
SIDE_BY_SIDE = {
    "step": log(STEP / EXTENT), "monotonous": 1, "even": 1, "count": log1p(ROWS - 1), "tight": 0,
    "run": (ROWS - 2) / (ROWS - 1), "next": 1, "other": 0, "cover": 1,
}  # fmt: skip
TO_AND_FRO = {"keep": 0, "alternating": 1, "opposite": 1, "signed": 0}
ONE_WAY = {"keep": 1, "alternating": 0, "opposite": 0, "signed": 1}
NOTHING = dict.fromkeys(NAMES, -1)


def scanned(commands):
    moves = monotonous_areas(linearize(commands))
    return measure_crossings(moves, Sample.of(moves, np.arange(len(moves))), EXTENT)


def told(commands):
    """Return the crossings per scan line, the measures of neighbours at one depth, and the measures at all depths."""
    found = scanned(commands)
    names = {which: {name: found[f"{which}_{name}"] for name in NAMES} for which in ("level", "plan")}
    assert set(found) == {"crossings", *(f"{which}_{name}" for which in names for name in NAMES)}
    return np.expm1(found["crossings"]), names["level"], names["plan"]


def rows(heights, places, length=50.0):
    return programs.program([[(0.0, y, z), (length, y, z)] for y, z in zip(places, heights)])


@pytest.mark.parametrize(
    ("commands", "way"),
    [(programs.zigzag(ROWS, 50.0, STEP), TO_AND_FRO), (programs.one_way(ROWS, 50.0, STEP), ONE_WAY)],
    ids=["to and fro", "one way"],
)
def test_rows_side_by_side(commands, way):
    crossings, level, plan = told(commands)
    assert crossings == pytest.approx(ROWS)
    assert level == pytest.approx({**SIDE_BY_SIDE, **way}, abs=1e-6) and plan == level


def test_rows_at_two_depths_are_compared_at_each_depth():
    """Seen from above, every second crossing coincides with the previous crossing. Distances of 0 do not count."""
    crossings, level, plan = told(programs.one_way(ROWS, 50.0, STEP, depths=(0.0, -1.0)))
    assert crossings == pytest.approx(2 * ROWS)
    assert level == pytest.approx({**SIDE_BY_SIDE, **ONE_WAY, "count": log1p(2 * (ROWS - 1))}, abs=1e-6)
    assert (plan["run"], plan["keep"], plan["other"], plan["cover"]) == pytest.approx((0, 0, 0, 1))
    assert plan["count"] == pytest.approx(log1p(ROWS - 1)) and plan["step"] == pytest.approx(log(STEP / EXTENT))


def test_rows_cut_in_turns_from_both_sides():
    """In the order 0, 9, 1, 8, ..., only the two neighbouring rows in the middle are cut one after the other."""
    order = np.ravel(np.column_stack((np.arange(5), np.arange(9, 4, -1))))
    _, level, _ = told(rows(np.zeros(ROWS), STEP * order))
    assert level["next"] == pytest.approx(1 / 9)
    assert level["monotonous"] == pytest.approx(7 / 8)  # but where the sides meet
    backwards = told(rows(np.zeros(ROWS), STEP * np.arange(ROWS)[::-1]))[1]
    assert backwards == pytest.approx({**SIDE_BY_SIDE, **ONE_WAY}, abs=1e-6)


def test_distances_that_are_not_the_usual_one():
    """Distances 3, 3, 3, 3, 9, 3, 3, 3, 3 and, a tenth longer, one that is still the usual one."""
    gaps = np.array([3, 3, 3, 3, 9, 3, 3, 3, 3.3])
    _, level, _ = told(rows(np.zeros(ROWS), np.append(0.0, np.cumsum(gaps))))
    assert level["even"] == pytest.approx(8 / 9) and level["step"] == pytest.approx(log(3 / EXTENT))
    assert level["cover"] == pytest.approx((gaps.sum() - 9) / gaps.sum()) and level["run"] == pytest.approx(6 / 8)
    assert level["tight"] == pytest.approx(0) and level["count"] == pytest.approx(log1p(8))


def test_neighbours_that_are_not_parallel_are_not_passes():
    """Teeth of a saw, 20 degrees up and down, which only lines across them all cross more than once."""
    teeth = [(20.0 * k, (20.0 * np.tan(np.pi / 9) if k % 2 else 0.0), 0.0) for k in range(9)]
    strokes = [
        [(x, y + 5.0 * (k % 2), 0.0) for x, y, _ in (teeth if k % 2 else [(x, 7.3 - y, z) for x, y, z in teeth])]
        for k in range(2)
    ]
    _, level, _ = told(programs.program(strokes))
    assert level["other"] == 1 and level["step"] == level["even"] == level["run"] == -1
    assert level["signed"] == pytest.approx(1)


def test_stroke_met_once_has_no_neighbours():
    crossings, level, plan = told(rows([0.0], [5.0]))
    assert crossings == pytest.approx(1) and level["signed"] == 1 and level["other"] == 1
    assert {**level, "signed": -1, "other": -1} == NOTHING and plan == level


def test_strokes_between_scan_lines_measure_nothing():
    """Two strokes of a tenth of a millimetre, a hundred apart."""
    crossings, level, plan = told(programs.program([[(x, 0.0, 0.0), (x + 0.1, 0.0, 0.0)] for x in (0.0, 100.0)]))
    assert crossings == 0 and level == plan == NOTHING


def test_middle_crossings_are_sampled():
    """Two scan lines take their 600 crossings from the middle 600 of 2,000 rows.

    The middle rows are cut one way; the rows before and after are cut back and forth.
    """
    strokes = []
    for k in range(2000):
        ends = [(0.0, 0.5 * k, 0.0), (500.0, 0.5 * k, 0.0)]
        strokes.append(ends[::-1] if k % 2 and not 700 <= k < 1300 else ends)
    commands = programs.program(strokes)
    crossings, level, _ = told(commands)
    assert crossings == pytest.approx(600) and level["count"] == pytest.approx(log1p(599))
    assert (level["opposite"], level["signed"], level["keep"]) == pytest.approx((0, 1, 1))
    moves = monotonous_areas(linearize(commands))
    for rows in (np.arange(2000), np.arange(0, 2000, 2)):  # a sample of half of the rows is enough
        assert np.unique(_cross(moves, Sample.of(moves, rows)).line).tolist() == [0, 1]
    few = monotonous_areas(linearize(programs.zigzag(ROWS, 50.0, STEP)))
    assert np.unique(_cross(few, Sample.of(few, np.arange(len(few)))).line).tolist() == list(range(12))


@pytest.mark.parametrize("wider, usual, even", [(1.05, 1.05**0.5, 1), (1.2, 1.2**0.5, 1), (1.45, 1, 0.5)])
def test_two_distances_are_one_where_they_are_nearly_alike(wider, usual, even):
    _, level, _ = told(rows(np.zeros(3), [0.0, STEP, STEP + wider * STEP]))
    assert level["even"] == even and level["step"] == pytest.approx(log(usual * STEP / EXTENT))
    assert level["tight"] == pytest.approx(np.median(np.abs(np.array([1, wider][: int(2 * even)]) / usual - 1)))


def test_lines_lie_where_the_cutting_is():
    """A long lead beside the rows is crossed by no line."""
    lead = [[(-400.0, 0.0, 0.0), (-401.0, 0.0, 0.0)]]
    crossings, level, _ = told([*programs.program(lead), *programs.one_way(ROWS, 50.0, STEP)])
    assert crossings == pytest.approx(ROWS) and level == pytest.approx({**SIDE_BY_SIDE, **ONE_WAY}, abs=1e-6)


def test_scan_lines_are_even_from_the_middle():
    assert np.sort(FROM_THE_MIDDLE) == pytest.approx((np.arange(12) + 0.5) / 12)
    assert (np.diff(np.abs(FROM_THE_MIDDLE - 0.5)) >= -1e-9).all()


@pytest.mark.parametrize("length, beside", [(18.0, True), (25.0, False)])
def test_a_twenty_fifth_of_the_length_may_lie_beside_all_lines(length, beside):
    """A lead 400 mm aside of ten rows of 50 mm: less than 21 mm, or the lines lie between it and the rows, too."""
    lead = [[(-400.0, 0.0, 0.0), (-400.0 - length, 0.0, 0.0)]]
    crossings, _, _ = told([*programs.program(lead), *programs.one_way(ROWS, 50.0, STEP)])
    assert crossings == pytest.approx(ROWS) if beside else crossings < ROWS / 2


@pytest.mark.parametrize("sine, crosses", [(0.25, False), (0.4, True)])
def test_stroke_along_the_scan_lines_is_not_crossed(sine, crosses):
    length = 20.0
    along = [[(25.0, 50.0, 0.0), (25.0 + sine * length, 50.0 + np.sqrt(1 - sine**2) * length, 0.0)]]
    crossings, _, _ = told([*programs.one_way(ROWS, 50.0, STEP), *programs.program(along)])
    assert (crossings > ROWS + 0.1) == crosses


@pytest.mark.parametrize("deeper, apart", [(0.04, True), (0.02, False)])
def test_clearly_different_heights_are_two_depths(deeper, apart):
    """Heights that differ by more than 0.025 mm are two depths. On one depth, equal rows would lie on one another."""
    _, level, _ = told(programs.one_way(ROWS, 50.0, STEP, depths=(0.0, -deeper)))
    assert level["run"] == pytest.approx((ROWS - 2) / (ROWS - 1) if apart else 0)


@pytest.mark.parametrize("angle", [0.3, 1.0, 2.0])
def test_turned_rows_have_equal_measures(angle):
    cos, sin = np.cos(angle), np.sin(angle)
    turned = [(name, {**p, "X": p["X"] * cos - p["Y"] * sin, "Y": p["X"] * sin + p["Y"] * cos} if "X" in p else p)
              for name, p in programs.zigzag(ROWS, 50.0, STEP)]  # fmt: skip
    assert told(turned)[1] == pytest.approx({**SIDE_BY_SIDE, **TO_AND_FRO}, abs=1e-6)


def test_descending_passes_have_one_depth_at_a_line():
    strokes = [[(0.0, STEP * k, 0.0), (50.0, STEP * k, -10.0)][:: 1 - 2 * (k % 2)] for k in range(ROWS)]
    _, level, plan = told(programs.program(strokes))
    assert level == pytest.approx({**SIDE_BY_SIDE, **TO_AND_FRO}, abs=1e-6)
    assert plan == pytest.approx(level)
