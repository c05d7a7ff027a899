# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each job has one deliberate fault, which is found with its place and command. A sound job has no faults."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from zbuffer_inputs import facts, toolpath

from vkworkbench.core import Cut, Stock, Tool, View
from vkworkbench.core.zbuffer import (
    SeenModel,
    cuts_air,
    deviations,
    engagement,
    gouges,
    removed_volumes,
    simulate_job,
    worst_places,
)

STOCK, MODEL = Stock((-1, -1, 0), (41, 31, 10)), Stock((0, 0, 0), (40, 30, 8))
FLAT = Tool("endmill", 6)
VIEW = View((0, 0, -1), 210, 160)
FEED, PLUNGE = 10.0, 2.0  # mm/s


def path(points, rapid=(), feed=FEED):
    moves = toolpath(np.array(points, float))
    fast = np.zeros(len(moves), bool)
    fast[list(rapid)] = True
    fall = np.diff(moves.points[:, 2]) < 0
    return replace(moves, rapid=fast, feed=np.where(fast, 0.0, np.where(fall, PLUNGE, feed)))


def facing(rows, height=8.0):
    """Return rows over the whole block. The first and the last move are vertical, above the block."""
    points = [(-5, rows[0], 12), (-5, rows[0], height)]
    points += [(x, y, height) for k, y in enumerate(rows) for x in ((-5, 45) if k % 2 == 0 else (45, -5))]
    points = [points[0], *(q for p, q in zip(points, points[1:]) if p != q)]
    return [*points, (*points[-1][:2], 12)]


ROWS = [0, 5, 10, 15, 20, 25, 30]
SOUND = path(facing(ROWS), rapid=[len(facing(ROWS)) - 2])


def told(*paths, model=MODEL, view=VIEW):
    cuts = [Cut(one, FLAT, PLUNGE) for one in paths]
    return facts(simulate_job(cuts, stock=STOCK, view=view), model=model)


def faults(found):
    return {name for name in ("crashes", "fast_plunges", "gouges", "left") if getattr(found, name)}


def test_the_sound_job_has_no_fault():
    found = told(SOUND)
    assert faults(found.job) == set() and found.cuts == (found.job,)
    assert found.job.air_length_share < 0.25  # The turns from row to row are in the air beside the block.
    assert found.job.removed_volume == pytest.approx(42 * 32 * 2, rel=0.01)


def test_crash_is_found_with_its_command_depth_and_place():
    crash = path([(-5, 15, 12), (-5, 15, 5), (45, 15, 5), (45, 15, 12)], rapid=[1])
    found = told(SOUND, crash)
    assert faults(found.cuts[0]) == set() and faults(found.cuts[1]) == {"crashes", "gouges"}
    (one,) = found.job.crashes
    assert (one.source.cut, one.source.command) == (1, 1)
    assert one.depth == pytest.approx(3) and one.volume == pytest.approx(42 * 6 * 3, rel=0.02)
    assert abs(one.place[1] - 15) < 3 and one.place[2] == pytest.approx(6.5)


@pytest.mark.parametrize("direction", [(0, 0, -1), (0, 0, 1), (0, 1, -1), (0, 1, 0)])
def test_crash_is_found_from_any_direction_of_the_view(direction):
    crash = path([(-5, 15, 12), (-5, 15, 5), (45, 15, 5), (45, 15, 12)], rapid=[1])
    (one,) = told(SOUND, crash, model=None, view=View(direction, 210, 160)).job.crashes
    assert one.trajectory == len(SOUND) + 1 and abs(one.place[1] - 15) < 3 and 5 < one.place[2] < 8


def test_a_crash_of_a_single_pixel_is_found():
    """The pixel has 4 mm, and the tool of 3 mm is in the middle of the pixel."""
    drilled = Cut(path([(18, 13, 12), (18, 13, 4)], rapid=[0]), Tool("endmill", 3))
    (one,) = facts(simulate_job([drilled], stock=STOCK, view=View((0, 0, -1), 10, 8, pixel=4.0))).job.crashes
    assert (one.depth, one.volume) == pytest.approx((6, 6 * 4**2))


@pytest.mark.parametrize("under, crashed", [(0.0005, False), (0.005, True)])
def test_rapid_below_a_cut_floor_is_a_crash_beyond_rounding(under, crashed):
    across = path([(-5, 15, 12), (-5, 15, 8 - under), (45, 15, 8 - under), (45, 15, 12)], rapid=[1])
    assert bool(told(SOUND, across, model=None).job.crashes) == crashed


def test_crash_of_descending_rapid_is_at_deepest_place():
    """The rapid starts 1 mm above the faced block and ends 4 mm below.

    At the block's edge, the tip of the tool is at the height 4.1 mm.
    """
    (one,) = told(SOUND, path([(-5, 15, 9), (45, 15, 4), (45, 15, 12)], rapid=[0])).job.crashes
    assert one.depth == pytest.approx(8 - 4.1, abs=0.02)
    assert one.place[:2] == pytest.approx((41, 15), abs=0.6) and one.place[2] == pytest.approx((8 + 4.1) / 2, abs=0.02)


def test_simulation_facts_convert_to_plain_data():
    crash = path([(-5, 15, 12), (-5, 15, 5), (45, 15, 5), (45, 15, 12)], rapid=[1])
    found = told(SOUND, crash).job
    data, cells = found.as_dict(), found.cells()
    (one,) = data["crashes"]
    assert (one["command"], one["depth"], one["volume"]) == (1, found.crashes[0].depth, found.crashes[0].volume)
    assert one["place"] == list(found.crashes[0].place) and data["fast_plunges"] == []
    assert [gouge["depth"] for gouge in data["gouges"]] == [gouge.depth for gouge in found.gouges]
    assert data["gouges"][0]["command"] == 1 and data["left"] == []
    assert (cells["crashes"], cells["first_crash_command"], cells["fast_plunges"]) == (1, 1, 0)
    assert cells["deepest_gouge"] == pytest.approx(3) and cells["most_left"] == 0
    assert cells["removed_volume"] == data["removed_volume"] == found.removed_volume
    without = told(SOUND).job.cells()
    assert (without["crashes"], without["first_crash_command"], without["deepest_gouge"]) == (0, None, 0)


def test_job_facts_combine_depth_width_and_tool_of_cuts():
    """Two slots are 6 and 4 mm wide, and 3 and 2 mm deep.

    Each move of 50 mm crosses 42 mm of block. Rapids have no width.
    """
    slots = [(Tool("endmill", 6), 10, 7.0), (Tool("endmill", 4), 20, 8.0)]
    cuts = [Cut(path([(-5, y, z), (45, y, z), (45, y, 20), (-5, y, 20)], rapid=[1, 2]), tool) for tool, y, z in slots]
    found = facts(simulate_job(cuts, stock=STOCK, view=View((0, 0, -1), 420, 320)))
    assert [one.depth_of_cut for one in (*found.cuts, found.job)] == pytest.approx([3, 2, 3])
    assert [one.width_of_cut for one in (*found.cuts, found.job)] == pytest.approx([5.04, 3.36, 4.2], rel=0.02)
    assert [one.tool_diameter for one in (*found.cuts, found.job)] == [6, 4, 6]
    assert [one.cutting_length for one in (*found.cuts, found.job)] == [50, 50, 100]
    # The feed moves are 100 mm long, at 10 mm/s.
    assert found.job.mean_rate == pytest.approx(60 * found.job.removed_volume / 10)
    assert (told().job.air_length_share, told().job.air_time_share) == (0, 0)


def test_gouge_is_found_with_its_depth_area_and_place():
    deep = path([(10, 15, 12), (10, 15, 6.5), (30, 15, 6.5), (30, 15, 12)], rapid=[2])
    found = told(SOUND, deep)
    assert faults(found.job) == {"gouges"}
    (one,) = found.job.gouges
    assert one.source.cut == 1 and one.depth == pytest.approx(1.5)
    assert one.area == pytest.approx(20 * 6 + 9 * pi, rel=0.03)
    assert abs(one.place[1] - 15) <= 3 and one.place[2] == pytest.approx(6.5)


@pytest.mark.parametrize("direction", [(0, 0, -1), (0, 0, 1)])
def test_gouge_through_part_is_at_the_model_surface(direction):
    """A part that is cut through has no surface at the gouge, so the place is at the model's surface."""
    through = path([(10, 15, 12), (10, 15, -1), (30, 15, -1), (30, 15, 12)], rapid=[2])
    (one,) = told(SOUND, through, view=View(direction, 210, 160)).job.gouges
    assert one.source.cut == 1 and abs(one.place[1] - 15) <= 3
    assert one.place[2] == pytest.approx(0 if direction[2] < 0 else 8)


@pytest.mark.long
@pytest.mark.parametrize("aside", [0, 1, -1])
def test_missing_stock_is_not_a_gouge_of_cuts_behind_it(aside):
    """The stock is 2 mm too low. In the oblique view, a slot is visible through the missing upper edge of the model."""
    low = Stock((-12, -1, 0), (41, 31, 6))
    slot = path([(-4, -5, 12), (-4, -5, 1), (-4, 35, 1), (-4, 35, 12)], rapid=[2])
    view = View((-1, aside, -1), 210, 160)
    found = facts(simulate_job([Cut(slot, FLAT)], stock=low, view=view), model=MODEL)
    (one,) = found.job.gouges
    assert one.source is None and one.depth == pytest.approx(2, abs=0.3)
    deep = path([(2, -5, 12), (2, -5, 1), (2, 35, 1), (2, 35, 12)], rapid=[2])
    found = facts(simulate_job([Cut(slot, FLAT), Cut(deep, FLAT)], stock=low, view=view), model=MODEL)
    assert {one.source and one.source.cut for one in found.job.gouges} == {None, 1}


def test_leftover_is_found_with_its_depth_area_and_place():
    found = told(path(facing([y for y in ROWS if y not in (10, 15)])))
    assert faults(found.job) == {"left"}
    (one,) = found.job.left
    assert one.trajectory is None and one.depth == pytest.approx(2)
    assert one.area == pytest.approx(40 * 9, rel=0.03) and 8 <= one.place[1] <= 17
    (one,) = told(path(facing(ROWS, 8.3))).job.left
    assert one.source.cut == 0 and one.depth == pytest.approx(0.3)


def test_plunge_that_is_too_fast_is_found():
    points = [(20, 15, 12), (20, 15, 9), (20, 15, 12), (20, 15, 9), (21, 15, 9)]
    fast = replace(path(points, rapid=[1]), feed=np.array([6.0, 0.0, 6.0, FEED]))
    (one,) = told(fast, model=None).job.fast_plunges  # The second plunge is in the hole of the first plunge.
    assert (one.source.command, one.feed, one.allowed) == (0, 6.0, PLUNGE)
    assert one.place == (20, 15, 9)
    assert told(replace(fast, feed=np.array([PLUNGE, 0, 6.0, FEED])), model=None).job.fast_plunges == ()
    # Without a vertical feed, no plunge is too fast.
    assert facts(simulate_job([Cut(fast, FLAT)], stock=STOCK, view=VIEW)).job.fast_plunges == ()


@pytest.mark.parametrize(
    "tool, drilled, fast",
    [(FLAT, 4.2, True), (FLAT, 4.28, False), (Tool("drill", 6), 1, True), (Tool("ballend", 6), 3.2, True),
     (Tool("ballend", 6), 4, False)],
)  # fmt: skip
def test_full_material_is_half_of_the_displaced_volume(tool, drilled, fast):
    """A tool of 6 mm plunges into drilled holes, 3 mm deep.

    A hole of 4.2 or 4.28 mm leaves 0.51 or 0.49 of the volume that a flat end displaces.
    A hole of 3.2 mm leaves (1 - 0.28)^1.5 = 0.61 of half a ball, and a hole of 4 mm leaves (1 - 0.44)^1.5 = 0.41.
    """
    hole, plunge = path([(20, 15, 12), (20, 15, 7)]), path([(20, 15, 12), (20, 15, 7)])
    cuts = [Cut(hole, Tool("endmill", drilled), PLUNGE), Cut(replace(plunge, feed=np.array([6.0])), tool, PLUNGE)]
    found = facts(simulate_job(cuts, stock=STOCK, view=View((0, 0, -1), 420, 320))).job.fast_plunges
    assert [one.source.cut for one in found] == [1] * fast


def test_second_pass_over_the_same_rows_is_air():
    found = told(SOUND, SOUND)
    assert found.cuts[0].air_length_share < 0.25 and found.cuts[1].air_length_share == 1
    assert found.cuts[1].air_seconds == pytest.approx(found.cuts[1].cutting_seconds) == found.cuts[0].cutting_seconds
    assert found.job.air_length == pytest.approx(found.cuts[0].air_length + found.cuts[1].cutting_length)


def test_short_moves_between_rays_are_not_air():
    row = [(x, 15.0, 8.0) for x in np.arange(-6, -2, 0.001)]
    z = simulate_job([Cut(path(row), FLAT)], stock=STOCK, view=VIEW)
    cutting = np.array([-3.9 < x < -2.2 for x, _, _ in row[:-1]])
    assert (removed_volumes(z)[cutting] == 0).mean() > 0.2
    assert not cuts_air(z)[cutting].any()
    assert cuts_air(z)[[0, 1000]].all()


@pytest.mark.parametrize("direction", [(0, 0, -1), (0, 0, 1), (1, 1, -1)])
def test_depth_and_width_of_cut_do_not_depend_on_the_view(direction):
    slot, half = [(-5, 10, 7), (45, 10, 7)], [(45, 13, 7), (-5, 13, 7)]
    z = simulate_job([Cut(path(slot), FLAT), Cut(path(half), FLAT)], stock=STOCK, view=View(direction, 480, 360))
    depth, width = engagement(z)
    assert depth == pytest.approx([3, 3], abs=0.02)
    assert width == pytest.approx([6 * 42 / 50, 3 * 42 / 50], rel=0.03)


def test_peak_and_mean_removal_rates_of_rows_are_measured():
    z = simulate_job([Cut(SOUND, FLAT)], stock=STOCK, view=VIEW)
    found = facts(z).job
    # The rows are 5 mm wide and 2 mm deep at 10 mm/s. Each row has 50 mm, of which 42 mm are on the block.
    assert found.peak_rate == pytest.approx(60 * 10 * 5 * 2 * 42 / 50, rel=0.05)
    assert found.mean_rate == pytest.approx(60 * z.chip_volume / found.cutting_seconds)


def test_wall_through_a_pixel_is_not_a_deviation():
    z = simulate_job([Cut(SOUND, FLAT)], stock=STOCK, view=View((0, 0, -1), 111, 87))
    moved = Stock((0.03, 0.02, 0), (39.98, 30.04, 8))
    found = deviations(z, moved)
    assert found.gouged.max() < 1e-5 and found.left.max() < 1e-5
    beside = np.isnan(SeenModel(moved, z.frame).near).mean()
    assert beside == pytest.approx(1 - 40 * 30 / (z.frame.pixel**2 * 111 * 87), abs=0.03)


def test_worst_places_are_separate_and_name_their_trajectory():
    """The model of 8 mm has no holes.

    A blind hole and a through hole are drilled, and the deeper hole is listed first.
    """
    drilled = path([(10, 15, 12), (10, 15, 5), (10, 15, 12), (30, 15, 12), (30, 15, -1), (30, 15, 12)])
    z = simulate_job([Cut(SOUND, FLAT), Cut(drilled, FLAT)], stock=STOCK, view=View((0, 0, -1), 200, 150))
    found = deviations(z, MODEL)
    (through, blind), _ = worst_places(z, found, 0.1)
    own = len(SOUND)
    assert (through.trajectory, blind.trajectory) == (own + 3, own)
    assert (through.depth, blind.depth) == pytest.approx((8, 3), abs=1e-4)
    assert through.place[:2] == pytest.approx((30, 15), abs=3) and blind.place[:2] == pytest.approx((10, 15), abs=3)
    assert {gouge.source.cut for gouge in gouges(z, found, 0.1)} == {1}
    assert [place.depth for place in worst_places(z, found, 0.1, most=1)[0]] == [through.depth]
    assert worst_places(z, found, 9.0)[0] == []


def test_deviations_from_the_model_are_found_at_any_moment():
    z = simulate_job([Cut(SOUND, FLAT)], stock=STOCK, view=VIEW)
    seen = SeenModel(MODEL, z.frame)
    assert np.nanmax(seen.against(z.at(0)).left) == pytest.approx(2) and seen.against(z).left.max() < 1e-5
    assert (seen.against(z).gouged == deviations(z, MODEL).gouged).all()


def test_job_without_cuts_has_only_leftover():
    found = told()
    assert found.cuts == () and found.job.removed_volume == 0 and found.job.peak_rate == 0
    assert faults(found.job) == {"left"}
