# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gouges of tools thinner than a pixel are found, with their commands and depths."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from zbuffer_inputs import ConvexStock, toolpath

from vkworkbench.core import Cut, Stock, Tool, View
from vkworkbench.core.zbuffer import SeenModel, check_crashes, facts, simulate_job, thin_gouges
from vkworkbench.language import render

PLATE = Stock((0, 0, 0), (600, 400, 20))
MODEL = Stock((0, 0, 0), (600, 400, 18))  # The model ends 2 mm below the top of the plate.
TOOL = Tool("endmill", 0.2)


def cut(*points, tool=TOOL, allowed=0.0):
    return Cut(toolpath(np.array(points, float)), tool, 0.0, allowed)


def slot(y, z, end=130.0):
    return [(100, y, 25), (100, y, z), (end, y, z), (end, y, 25)]


def seen(model=MODEL, pixel=0.5):
    return SeenModel(model, View(width=int(600 / pixel), height=int(400 / pixel)).frame(PLATE))


def found(*cuts, model=MODEL, pixel=0.5, **given):
    return [
        (gouge.source.cut, gouge.source.command, gouge.last.command, round(gouge.depth, 2))
        for gouge in thin_gouges(cuts, PLATE, seen(model, pixel), **given).found
    ]


@pytest.mark.long
def test_slot_too_deep_is_a_gouge_from_first_to_last_command():
    path = [*slot(50.1, 18.0), *slot(80.1, 17.5), *slot(90.1, 17.95), *slot(110.1, 16.0)]
    assert found(cut(*path)) == [(0, 4, 5, 0.5), (0, 12, 13, 2.0)]
    assert found(cut(*path), tolerance=0.01) == [(0, 4, 5, 0.5), (0, 8, 9, 0.05), (0, 12, 13, 2.0)]
    assert found(cut(*path, allowed=0.5)) == [(0, 12, 13, 2.0)] and found(cut(*path, allowed=np.inf)) == []


@pytest.mark.long
def test_pocket_that_is_too_deep_is_one_gouge():
    """Rows, a rapid around them, and a slot that touches the first row are one gouge.

    A slot 1 mm away is a second gouge.
    """
    rows = [(x, 50.1 + 0.15 * k, 17.5) for k in range(8) for x in ((100, 105) if k % 2 == 0 else (105, 100))]
    pocket = [(100, 50.1, 25), *rows, (100, 51.15, 25)]
    assert found(cut(*pocket, *slot(49.95, 17.4, 105))) == [(0, 0, 19, 0.6)]
    assert found(cut(*pocket, *slot(49.0, 17.4, 105))) == [(0, 0, 15, 0.5), (0, 18, 19, 0.6)]


def test_carving_of_changing_width_is_one_gouge():
    """The distance of the rays is the width of the V-bit at its depth."""
    carving = cut((100, 50, 25), (100, 50, 17.8), (101, 50, 17.8), (102, 50, 17), (103, 50, 17), (104, 50, 17.7),
                  tool=Tool("vbit", 1.5, tip_angle=np.pi / 2, tip_diameter=0.1))  # fmt: skip
    ((_, first, last, depth),) = found(carving)
    assert (first, last) == (0, 4) and depth == pytest.approx(1.0, abs=0.02)


@pytest.mark.parametrize("aside, depth", [(0.0, None), (0.05, None), (0.3, 0.3)])
def test_gouge_in_a_wall_is_as_deep_as_its_sideways_offset(aside, depth):
    """The tool moves along the wall of a model that ends at Y = 100, 5 mm below its top."""
    wall = Stock((0, 0, 0), (600, 100, 18))
    gouges = found(cut(*slot(100.1 - aside, 13.0)), model=wall)
    assert gouges == ([] if depth is None else [(0, 0, 1, pytest.approx(depth, abs=0.05))])


def test_gouge_in_a_slope_is_measured_perpendicular_to_it():
    """On a slope of 45 degrees, 1 mm downwards is 0.71 mm perpendicular to the slope."""
    slope = ConvexStock(np.vstack((np.eye(3), -np.eye(3), [1, 0, 1])), np.array([600, 400, 20, 0, 0, 0, 130.0]))
    ((_, first, last, depth),) = found(cut((115, 50, 25), (115, 50, 14)), model=slope)
    assert (first, last) == (0, 0) and depth == pytest.approx(1 / np.sqrt(2), rel=0.15)


@pytest.mark.long
def test_thin_gouges_exclude_wide_tools_and_cuts_at_model_height():
    deep, level = slot(50.1, 17.0), slot(50.1, 18.0)
    assert thin_gouges([cut(*deep, tool=Tool("endmill", 6))], PLATE, seen()).cuts == ()
    assert thin_gouges([cut(*level)], PLATE, seen()).cuts == (0,)
    assert found(cut(*level)) == []


@pytest.mark.long
def test_moves_beyond_the_time_limit_are_reported_unchecked():
    cuts = [cut(*slot(50.1, 17.0))]
    thin = thin_gouges(cuts, PLATE, seen(), seconds=0)
    assert thin.found == () and [source.command for source in thin.unchecked] == [0, 1, 2]
    zbuffer = simulate_job(cuts, stock=PLATE, view=View(width=1200, height=800))
    assert facts(zbuffer, check_crashes(cuts, PLATE), thin=thin, model=MODEL).verdict.unchecked == thin.unchecked


@pytest.mark.long
def test_gouges_on_fine_rays_replace_gouges_of_the_image():
    wide = cut(*slot(200, 17.0), tool=Tool("endmill", 6))
    cuts = [cut(*slot(50.1, 17.5), *slot(80.1, 17.5)), wide]
    zbuffer = simulate_job(cuts, stock=PLATE, view=View(width=1200, height=800))
    thin = thin_gouges(cuts, PLATE, SeenModel(MODEL, zbuffer.frame))
    job = facts(zbuffer, check_crashes(cuts, PLATE), thin=thin, model=MODEL)
    assert [(one.source.cut, one.source.command) for one in job.job.gouges] == [(1, 0), (0, 0), (0, 4)]
    assert job.verdict.gouges == 3 and [len(one.gouges) for one in job.cuts] == [2, 1]
    replaced = facts(zbuffer, check_crashes(cuts, PLATE), thin=replace(thin, found=()), model=MODEL)
    assert [one.source.cut for one in replaced.job.gouges] == [1]


@pytest.mark.long
@pytest.mark.parametrize("aside, depth", [(0.0, None), (0.06, None), (0.3, 0.3), (0.7, 0.7)])
def test_wall_shaved_by_a_wide_tool_is_a_gouge(aside, depth):
    """A wide tool cuts the wall at Y = 100, and then a second time with a sideways offset. Pixels are 0.5 mm."""
    wall = Stock((0, 0, 0), (600, 100, 18))
    cuts = [cut(*slot(103, 13.0), *slot(103 - aside, 13.0), tool=Tool("endmill", 6))]
    zbuffer = simulate_job(cuts, stock=PLATE, view=View(width=1200, height=800))
    model = SeenModel(wall, zbuffer.frame)
    gouges = facts(zbuffer, check_crashes(cuts, PLATE), thin=thin_gouges(cuts, PLATE, model), model=model).job.gouges
    told = [(gouge.source.command, gouge.last.command, gouge.depth) for gouge in gouges]
    assert told == ([] if depth is None else [(4, 5, pytest.approx(depth, abs=0.07))])


def test_verdict_names_walls_beyond_the_time_limit():
    cuts, wall = [cut(*slot(103.1, 13.0), tool=Tool("endmill", 6))], Stock((0, 0, 0), (600, 100, 18))
    zbuffer = simulate_job(cuts, stock=PLATE, view=View(width=600, height=400))
    model, checked = SeenModel(wall, zbuffer.frame), check_crashes(cuts, PLATE)
    told = [
        facts(zbuffer, checked, thin=thin_gouges(cuts, PLATE, model, seconds=seconds), model=model).verdict
        for seconds in (np.inf, 0)
    ]
    assert [verdict.walls_checked for verdict in told] == [True, False]
    texts = [render(verdict.message(["Slot"])) for verdict in told]
    assert ["check all walls" in text for text in texts] == [False, True]
