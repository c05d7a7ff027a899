# SPDX-License-Identifier: LGPL-2.1-or-later
"""Times, rates and sizes of cuts with known volumes: slots 6 mm wide and 3 mm deep in a block."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from zbuffer_inputs import facts, toolpath

from vkworkbench.core import Cut, Stock, Tool, View
from vkworkbench.core.zbuffer import removed_volumes, simulate_job

BLOCK, MODEL = Stock((0, 0, 0), (40, 30, 10)), Stock((0, 0, 0), (40, 30, 8))
FLAT, VIEW = Tool("endmill", 6), View((0, 0, -1), 400, 300)  # The view has pixels of 0.1 mm.
SLOT, ROUND = 6 * 3, 9 * pi * 3  # Volumes removed per mm of a slot (mm^2), and by the tool's end (mm^3).


def path(points, feeds):
    """Return moves with their feeds, mm/s; a feed of 0 is a rapid."""
    moves = toolpath(np.array(points, float))
    feed = np.array(feeds, float)
    return replace(moves, rapid=feed == 0, feed=feed)


def simulated(*paths):
    return simulate_job([Cut(one, FLAT) for one in paths], stock=BLOCK, view=VIEW)


# The tool crosses the block at two feeds (3 and 1.5 s), rises (1 s), returns by rapid, and crosses the same slot (6 s).
THERE_AGAIN = path(
    [(-10, 15, 7), (20, 15, 7), (50, 15, 7), (50, 15, 12), (-10, 15, 12), (-10, 15, 7), (50, 15, 7)],
    [10, 20, 5, 0, 0, 10],
)
SECOND = 20 * SLOT - ROUND / 2
# The tool cuts a slot for half a second, crosses the whole block by rapid, and cuts another slot for 2 s.
CRASH = path(
    [(10, 15, 7), (15, 15, 7), (15, 15, 12), (-5, 5, 12), (-5, 5, 7), (45, 5, 7), (45, 5, 12), (10, 25, 12), (10, 25, 7),
     (30, 25, 7)],
    [10] + [0] * 7 + [10],
)  # fmt: skip


def test_peak_removal_rate_is_the_maximum_over_all_seconds():
    """Some moves take less than a second, and some take many seconds."""
    rng = np.random.default_rng(3)
    points = np.column_stack((rng.uniform(0, 40, 60), rng.uniform(0, 30, 60), rng.uniform(4, 11, 60)))
    z = simulated(path(points, rng.choice([0, 0.4, 7, 90, 400], 59)))
    seconds, volumes = z.cuts.seconds, np.where(z.cuts.seconds > 0, removed_volumes(z), 0)
    begin = np.arange(0.0, seconds.sum())
    ends, removed = np.append(0, seconds.cumsum()), np.append(0, volumes.cumsum())
    rates = 60 * (np.interp(begin + 1, ends, removed) - np.interp(begin, ends, removed))
    assert len(rates) > 200
    assert facts(z).job.peak_rate == pytest.approx(rates.max(), rel=1e-9)


def test_removal_rates_of_years_of_machining_need_no_memory():
    """A move of 1 mm takes eleven days, and the job takes 35 years.

    An array with one value per second would be too large.
    """
    found = facts(simulated(path([(-10, 15, 7), (50, 15, 7)], [1e-6]), path([(-10, 5, 7), (990, 5, 7)], [1e-6]))).job
    assert found.cutting_seconds == pytest.approx(1.06e9)
    assert found.peak_rate == pytest.approx(60e-6 * SLOT * 40 / 60, rel=0.01)  # Only 40 of the 60 mm are in the block.


def test_removal_rate_of_a_job_below_a_second_is_per_second():
    found = facts(simulated(path([(10, 15, 7), (15, 15, 7)], [10]))).job
    assert found.peak_rate == pytest.approx(60 * (5 * SLOT + ROUND), rel=5e-3)


def test_peak_removal_rate_may_lie_inside_one_move():
    """The tool moves half a second in the air, and 1.6 s across the block."""
    found = facts(simulated(path([(-10, 15, 7), (-5, 15, 7), (45, 15, 7)], [10, 50 / 1.6]))).job
    assert found.peak_rate == pytest.approx(60 * 40 * SLOT / 1.6, rel=5e-3)


def test_rapid_has_no_time_and_no_removal_rate():
    """The vertical rapids removed the material at the ends of the rapid and of the second slot."""
    short, slot = 5 * SLOT + ROUND, 20 * SLOT
    found = facts(simulated(CRASH)).job
    assert found.removed_volume == pytest.approx(short + 40 * SLOT + ROUND + slot, rel=5e-3)
    assert (found.mean_rate, found.peak_rate) == pytest.approx(
        (60 * (short + slot) / 2.5, 60 * (short + slot / 4)), rel=5e-3
    )
    assert (found.cutting_length, found.cutting_seconds, found.air_length) == pytest.approx((25, 2.5, 0))
    # The width of cut is the mean over the feed moves, without the rapid.
    assert found.width_of_cut == pytest.approx(6, rel=5e-3)


def test_lengths_and_times_are_divided_into_cuts_and_air():
    found = facts(simulated(THERE_AGAIN)).job
    assert (found.cutting_length, found.cutting_seconds) == pytest.approx((30 + 30 + 5 + 60, 3 + 1.5 + 1 + 6))
    assert (found.air_length, found.air_seconds) == pytest.approx((65, 7))
    assert (found.air_length_share, found.air_time_share) == pytest.approx((65 / 125, 7 / 11.5))
    assert found.mean_rate == pytest.approx(60 * 40 * SLOT / 11.5, rel=5e-3)
    assert found.peak_rate == pytest.approx(60 * SECOND / 1.5, rel=5e-3)


def test_width_of_cut_ignores_plunges():
    """After a plunge of 5 mm, a slot of 20 mm is 6 mm wide, and not 6 * 20 / 25 mm."""
    found = facts(simulated(path([(10, 15, 12), (10, 15, 7), (30, 15, 7)], [10, 10]))).job
    assert (found.depth_of_cut, found.width_of_cut) == pytest.approx((3, 6), rel=5e-3)


def test_width_of_a_narrow_cut_is_measured():
    """The second cut widens a slot by 0.5 mm."""
    found = facts(simulated(path([(-10, 15, 7), (50, 15, 7)], [10]), path([(-10, 15.5, 7), (50, 15.5, 7)], [10])))
    assert found.cuts[1].width_of_cut == pytest.approx(0.5 * 40 / 60)


def test_moves_without_a_cut_have_no_depth_width_or_rate():
    found = facts(simulated(path([(-10, 15, 12), (50, 15, 12)], [10]))).job
    assert (found.depth_of_cut, found.width_of_cut, found.mean_rate, found.peak_rate) == (0, 0, 0, 0)
    assert (found.air_length_share, found.air_time_share) == (1, 1)
    nothing = facts(simulated()).job
    assert (nothing.tool_diameter, nothing.mean_rate, nothing.depth_of_cut, nothing.cutting_length) == (0, 0, 0, 0)


def rows(heights, z):
    points = [(-5, heights[0], z)]
    points += [(x, y, z) for k, y in enumerate(heights) for x in ((-5, 45) if k % 2 == 0 else (45, -5))][1:]
    return path(points, [10] * (len(points) - 1))


def test_worst_place_is_found_per_cut_and_lack_of_stock_per_job():
    """Rows reach the model except in a strip 9 mm wide.

    A row in the strip is 0.5 mm too high. Two holes are 1 and 3 mm too deep.
    """
    ways = [
        rows([0, 5, 20, 25, 30], 8),
        rows([10], 8.5),
        *(path([(x, 24, 12), (x, 24, z)], [10]) for x, z in ((9, 7), (29, 5))),
    ]
    found = facts(simulated(*ways), model=MODEL)
    assert [[round(left.depth, 3) for left in one.left] for one in (*found.cuts, found.job)] == [
        [],
        [0.5],
        [],
        [],
        [2, 0.5],
    ]
    assert [left["command"] for left in found.job.as_dict()["left"]] == [None, 0]
    assert [[gouge.depth for gouge in one.gouges] for one in found.cuts] == [
        [],
        [],
        [pytest.approx(1)],
        [pytest.approx(3)],
    ]
    assert (found.job.cells()["deepest_gouge"], found.job.cells()["most_left"]) == pytest.approx((3, 2))


@pytest.mark.parametrize(("height", "told"), [(8.09, False), (8.15, True)])
def test_deviation_below_a_tenth_of_a_mm_is_ignored(height, told):
    found = facts(simulated(rows([0, 5, 10, 15, 20, 25, 30], height)), model=MODEL).job
    assert bool(found.left) is told


@pytest.mark.parametrize("tolerance", [-0.1, float("nan")])
def test_negative_tolerance_is_refused(tolerance):
    with pytest.raises(ValueError, match=f"tolerance must be a length of at least 0 mm, not {tolerance}"):
        facts(simulated(THERE_AGAIN), model=MODEL, tolerance=tolerance)
