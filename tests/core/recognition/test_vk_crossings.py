# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures of passes that cross a scan line next to each other, for drawn passes with known measures."""

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
# Measures of ten rows, 3 mm apart, cut in order.
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
    """Return the number of crossings per scan line, and the measures of neighbours at one depth and at all depths."""
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
def test_measures_of_rows_side_by_side_match_expected_values(commands, way):
    crossings, level, plan = told(commands)
    assert crossings == pytest.approx(ROWS)
    assert level == pytest.approx({**SIDE_BY_SIDE, **way}, abs=1e-6) and plan == level


def test_rows_at_two_depths_are_compared_at_each_depth():
    """Seen from above, every second crossing of a scan line coincides with the previous crossing.

    Distances of 0 between crossings are left out.
    """
    crossings, level, plan = told(programs.one_way(ROWS, 50.0, STEP, depths=(0.0, -1.0)))
    assert crossings == pytest.approx(2 * ROWS)
    assert level == pytest.approx({**SIDE_BY_SIDE, **ONE_WAY, "count": log1p(2 * (ROWS - 1))}, abs=1e-6)
    assert (plan["run"], plan["keep"], plan["other"], plan["cover"]) == pytest.approx((0, 0, 0, 1))
    assert plan["count"] == pytest.approx(log1p(ROWS - 1)) and plan["step"] == pytest.approx(log(STEP / EXTENT))


def test_rows_cut_in_turn_from_both_sides_are_not_consecutive():
    """In the order 0, 9, 1, 8, ..., only the two neighbouring rows in the middle are cut one after the other."""
    order = np.ravel(np.column_stack((np.arange(5), np.arange(9, 4, -1))))
    _, level, _ = told(rows(np.zeros(ROWS), STEP * order))
    assert level["next"] == pytest.approx(1 / 9)
    # Only in the middle, where the rows of both sides meet, is the order of the rows not monotonous.
    assert level["monotonous"] == pytest.approx(7 / 8)
    backwards = told(rows(np.zeros(ROWS), STEP * np.arange(ROWS)[::-1]))[1]
    assert backwards == pytest.approx({**SIDE_BY_SIDE, **ONE_WAY}, abs=1e-6)


def test_one_larger_distance_makes_rows_less_even():
    """The distances between the rows are 3, 3, 3, 3, 9, 3, 3, 3 and 3.3 mm.

    The last distance, 3.3 mm, equals 3 mm within the tolerance.
    """
    gaps = np.array([3, 3, 3, 3, 9, 3, 3, 3, 3.3])
    _, level, _ = told(rows(np.zeros(ROWS), np.append(0.0, np.cumsum(gaps))))
    assert level["even"] == pytest.approx(8 / 9) and level["step"] == pytest.approx(log(3 / EXTENT))
    assert level["cover"] == pytest.approx((gaps.sum() - 9) / gaps.sum()) and level["run"] == pytest.approx(6 / 8)
    assert level["tight"] == pytest.approx(0) and level["count"] == pytest.approx(log1p(8))


def test_neighbours_that_are_not_parallel_are_not_passes():
    """Only scan lines across the saw teeth, which rise and fall by 20 degrees, cross the teeth more than once."""
    teeth = [(20.0 * k, (20.0 * np.tan(np.pi / 9) if k % 2 else 0.0), 0.0) for k in range(9)]
    strokes = [
        [(x, y + 5.0 * (k % 2), 0.0) for x, y, _ in (teeth if k % 2 else [(x, 7.3 - y, z) for x, y, z in teeth])]
        for k in range(2)
    ]
    _, level, _ = told(programs.program(strokes))
    assert level["other"] == 1 and level["step"] == level["even"] == level["run"] == -1
    assert level["signed"] == pytest.approx(1)


def test_single_stroke_crossed_by_a_scan_line_has_no_neighbours():
    crossings, level, plan = told(rows([0.0], [5.0]))
    assert crossings == pytest.approx(1) and level["signed"] == 1 and level["other"] == 1
    assert {**level, "signed": -1, "other": -1} == NOTHING and plan == level


def test_strokes_that_no_scan_line_crosses_have_no_measures():
    """The two strokes are 0.1 mm long and 100 mm apart."""
    crossings, level, plan = told(programs.program([[(x, 0.0, 0.0), (x + 0.1, 0.0, 0.0)] for x in (0.0, 100.0)]))
    assert crossings == 0 and level == plan == NOTHING


def test_crossings_are_sampled_from_the_middle_rows():
    """Two scan lines take their 600 crossings from the middle 600 of 2,000 rows.

    The middle rows are cut in one direction, all rows before and after them back and forth.
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
    # The number of scan lines is 2 for all rows, and for a sample of every second row.
    for rows in (np.arange(2000), np.arange(0, 2000, 2)):
        assert np.unique(_cross(moves, Sample.of(moves, rows)).line).tolist() == [0, 1]
    few = monotonous_areas(linearize(programs.zigzag(ROWS, 50.0, STEP)))
    assert np.unique(_cross(few, Sample.of(few, np.arange(len(few)))).line).tolist() == list(range(12))


@pytest.mark.parametrize("wider, usual, even", [(1.05, 1.05**0.5, 1), (1.2, 1.2**0.5, 1), (1.45, 1, 0.5)])
def test_two_row_distances_within_the_tolerance_count_as_equal(wider, usual, even):
    _, level, _ = told(rows(np.zeros(3), [0.0, STEP, STEP + wider * STEP]))
    assert level["even"] == even and level["step"] == pytest.approx(log(usual * STEP / EXTENT))
    assert level["tight"] == pytest.approx(np.median(np.abs(np.array([1, wider][: int(2 * even)]) / usual - 1)))


def test_scan_lines_cross_the_part_with_most_of_the_cutting():
    """No scan line crosses the long lead beside the rows."""
    lead = [[(-400.0, 0.0, 0.0), (-401.0, 0.0, 0.0)]]
    crossings, level, _ = told([*programs.program(lead), *programs.one_way(ROWS, 50.0, STEP)])
    assert crossings == pytest.approx(ROWS) and level == pytest.approx({**SIDE_BY_SIDE, **ONE_WAY}, abs=1e-6)


def test_scan_lines_are_evenly_spaced_from_the_middle():
    assert np.sort(FROM_THE_MIDDLE) == pytest.approx((np.arange(12) + 0.5) / 12)
    assert (np.diff(np.abs(FROM_THE_MIDDLE - 0.5)) >= -1e-9).all()


@pytest.mark.parametrize("length, beside", [(18.0, True), (25.0, False)])
def test_lead_of_four_percent_of_the_length_is_not_scanned(length, beside):
    """A lead lies 400 mm beside ten rows of 50 mm.

    Above 21 mm of lead, some scan lines lie between the lead and the rows.
    """
    lead = [[(-400.0, 0.0, 0.0), (-400.0 - length, 0.0, 0.0)]]
    crossings, _, _ = told([*programs.program(lead), *programs.one_way(ROWS, 50.0, STEP)])
    assert crossings == pytest.approx(ROWS) if beside else crossings < ROWS / 2


@pytest.mark.parametrize("sine, crosses", [(0.25, False), (0.4, True)])
def test_stroke_parallel_to_the_scan_lines_is_not_crossed(sine, crosses):
    length = 20.0
    along = [[(25.0, 50.0, 0.0), (25.0 + sine * length, 50.0 + np.sqrt(1 - sine**2) * length, 0.0)]]
    crossings, _, _ = told([*programs.one_way(ROWS, 50.0, STEP), *programs.program(along)])
    assert (crossings > ROWS + 0.1) == crosses


@pytest.mark.parametrize("deeper, apart", [(0.04, True), (0.02, False)])
def test_heights_that_clearly_differ_are_two_depths(deeper, apart):
    """Heights that differ by more than 0.025 mm are two depths.

    If the two depths counted as one depth, their rows would coincide.
    """
    _, level, _ = told(programs.one_way(ROWS, 50.0, STEP, depths=(0.0, -deeper)))
    assert level["run"] == pytest.approx((ROWS - 2) / (ROWS - 1) if apart else 0)


@pytest.mark.parametrize("angle", [0.3, 1.0, 2.0])
def test_rotated_rows_have_the_same_crossings(angle):
    cos, sin = np.cos(angle), np.sin(angle)
    turned = [(name, {**p, "X": p["X"] * cos - p["Y"] * sin, "Y": p["X"] * sin + p["Y"] * cos} if "X" in p else p)
              for name, p in programs.zigzag(ROWS, 50.0, STEP)]  # fmt: skip
    assert told(turned)[1] == pytest.approx({**SIDE_BY_SIDE, **TO_AND_FRO}, abs=1e-6)


def test_descending_neighbour_passes_are_compared_at_one_depth():
    strokes = [[(0.0, STEP * k, 0.0), (50.0, STEP * k, -10.0)][:: 1 - 2 * (k % 2)] for k in range(ROWS)]
    _, level, plan = told(programs.program(strokes))
    assert level == pytest.approx({**SIDE_BY_SIDE, **TO_AND_FRO}, abs=1e-6)
    assert plan == pytest.approx(level)
