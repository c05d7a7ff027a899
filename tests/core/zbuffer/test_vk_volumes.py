# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured volumes are within their stated error for tools and sheets of all sizes."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from zbuffer_inputs import toolpath

from vkworkbench.core import Cut, Cylinder, Stock, Tool, View
from vkworkbench.core.zbuffer import CrashCheck, Volumes, cuts_air, facts, measure_volumes, simulate_job

SHEET = Stock((0, 0, 0), (600, 400, 2))


def path(*points, rapid=()):
    moves = toolpath(np.array(points, float))
    return replace(moves, rapid=np.isin(np.arange(len(moves)), rapid))


def slots(diameter, depth, slope):
    """Return a cut of five slots 300 mm long, and its exact volume."""
    points = [
        point
        for y in 40.3 + 71.7 * np.arange(5)
        for point in ((100, y, 9), (100, y, 2 - depth), (400, y + 300 * slope, 2 - depth), (400, y + 300 * slope, 9))
    ]
    cut = Cut(path(*points, rapid=range(3, 19, 4)), Tool("endmill", diameter))
    return cut, 5 * depth * (300 * np.hypot(1, slope) * diameter + pi / 4 * diameter**2)


@pytest.mark.long
@pytest.mark.parametrize("diameter", [0.1, 3.0, 20.0])
@pytest.mark.parametrize("slope", [0.0, 0.01, 0.06])
def test_volume_of_slots_in_a_sheet_is_within_its_error(diameter, slope):
    cut, exact = slots(diameter, 1.5, slope)
    measured = measure_volumes([cut], SHEET)
    error = measured.error(range(1))
    assert abs(measured.each.sum() - exact) <= error <= 0.01 * exact
    assert measured.depths[[1, 5]] == pytest.approx(1.5) and measured.depths[3] == 0


@pytest.mark.long
def test_slope_mostly_beside_the_stock_is_measured_finely():
    """Only the first 7 mm of a slope that is 352 mm long are in the stock. The exact volume is from an image of 0.01 mm."""
    stock = Stock((0, 0, 0), (55.5, 276.7, 3.13558877))
    slope = path((0.785063, 122.320424, 8), (0.785063, 122.320424, 1.512902), (-338.219062, 219.931914, 0.313559))
    cut = Cut(slope, Tool("endmill", 11.97761577755422))
    measured = measure_volumes([cut], stock)
    fine = View(width=800, height=3000, pixel=0.01, offset=(4 - 55.5 / 2, 127 - 276.7 / 2))
    exact = simulate_job([cut], stock=stock, view=fine).records.lengths.sum() * 0.01**2
    assert abs(measured.each.sum() - exact) <= measured.error(range(1)) <= 0.001 * exact


@pytest.mark.parametrize("aside", [0.0, 4.0])
def test_peak_rate_uses_only_the_part_of_a_move_in_material(aside):
    """A move of 400 mm takes 40 s. For 50 mm, the tool cuts the plate 6 mm wide and 1 mm deep, at 10 mm/s."""
    plate = Stock((0, 0, 0), (50, 40, 2))
    one = path((-300, 20 - aside, 1), (100, 20 + aside, 1))
    cut = Cut(replace(one, feed=np.full(1, 10.0)), Tool("endmill", 6))
    zbuffer = simulate_job([cut], stock=plate, view=View(width=500, height=400))
    measured = measure_volumes([cut], plate)
    assert measured.of_parts.sum() == pytest.approx(measured.each.sum())
    found = facts(zbuffer, CrashCheck(), measured).job
    assert found.peak_rate == pytest.approx(60 * 6 * 10, rel=0.02)
    assert found.mean_rate == pytest.approx(60 * 6 * 50 / 40, rel=0.02)


def test_error_of_a_volume_is_at_least_the_volume_of_one_ray():
    """Four images that agree by chance do not reduce the error to zero."""
    alone, parts = np.array([900.0]), np.array([0, 1])
    agreeing = Volumes(alone, np.array([1.0]), np.full((4, 1), 900.0), parts, alone, np.array([1.2]))
    assert agreeing.error(range(1)) == 1.2


@pytest.mark.long
def test_volume_errors_hold_in_38_of_40_jobs():
    """Random slots in all directions, cut by flat tools, have exact volumes."""
    rng, inside = np.random.default_rng(2), 0
    for _ in range(40):
        diameter, depth = np.exp(rng.uniform(np.log(0.2), np.log(10))), rng.uniform(0.2, 2)
        angle, length = rng.uniform(0, pi), rng.uniform(1, 150)
        end = (300 + length * np.cos(angle), 200 + length * np.sin(angle), 2 - depth)
        cut = Cut(path((300, 200, 9), (300, 200, 2 - depth), end), Tool("endmill", diameter))
        measured = measure_volumes([cut], SHEET)
        inside += abs(measured.each.sum() - depth * (length * diameter + pi / 4 * diameter**2)) <= measured.error(
            range(1)
        )
    assert inside >= 38


def test_volume_of_two_cuts_in_a_cylinder_is_measured():
    stock = Cylinder((0, 0, 0), 30, 10)
    face = [(x, y, 7) for k, y in enumerate(range(-35, 40, 5)) for x in ((-40, 40) if k % 2 == 0 else (40, -40))]
    cuts = [Cut(path(*face), Tool("endmill", 8)), Cut(path((0, 0, 12), (0, 0, 2)), Tool("endmill", 12))]
    measured = measure_volumes(cuts, stock)
    exact = np.array([900 * pi * 3, 36 * pi * 5])
    assert measured.images.mean(axis=0) == pytest.approx(exact, rel=2e-3)
    assert abs(measured.each.sum() - exact.sum()) <= measured.error(range(2)) <= 0.01 * exact.sum()


def test_measured_moves_of_thin_tools_are_not_air():
    cut, exact = slots(0.1, 1.5, 0.0)
    zbuffer = simulate_job([cut], stock=SHEET, view=View(width=60, height=40))
    measured = measure_volumes([cut], SHEET)
    assert cuts_air(zbuffer).any() and not cuts_air(zbuffer, measured)[1::4].any()
    job = facts(zbuffer, CrashCheck(), measured).job
    assert job.removed_volume == pytest.approx(exact, rel=0.01) and job.depth_of_cut == pytest.approx(1.5)
    assert job.removed_volume_error == measured.error(range(1)) and job.width_of_cut == pytest.approx(0.1, rel=0.01)
    assert facts(zbuffer, CrashCheck()).job.removed_volume_error is None and job.pixel == 10


def test_volumes_are_none_without_time_and_zero_without_moves():
    cut, _ = slots(3.0, 1.5, 0.0)
    assert measure_volumes([cut], SHEET, seconds=0) is None
    assert measure_volumes([Cut(path((0, 0, 9), (600, 400, 9)), Tool("endmill", 3))], SHEET).each.tolist() == [0]
    assert measure_volumes([], SHEET).error(range(0)) == 0
