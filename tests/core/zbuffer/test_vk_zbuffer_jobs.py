# SPDX-License-Identifier: LGPL-2.1-or-later
"""Operations with different tools are simulated one after the other in one z-buffer."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from zbuffer_inputs import BOX, toolpath

from vkworkbench.core import Stock, Tool, View
from vkworkbench.core.zbuffer.cost.estimate import estimate, estimate_job
from vkworkbench.core.zbuffer.cost.speed import Speed
from vkworkbench.core.zbuffer.findings.facts import removed_volumes
from vkworkbench.core.zbuffer.memory.memory import OverBudget, memory_needed
from vkworkbench.core.zbuffer.simulator.simulate import simulate, simulate_job
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts, Source


def slot(*heights, y):
    """Return passes between x = 8 and 32 mm, back and forth, one at each height."""
    x = np.tile([8.0, 32.0, 32.0, 8.0], len(heights))[: 2 * len(heights)]
    return toolpath(np.column_stack((x, np.full(len(x), y), np.repeat(heights, 2))))


FLAT, WIDE = Tool("endmill", 6), Tool("endmill", 14)


@pytest.fixture(scope="module")
def job():
    view = View((0, 0, -1), 160, 120)
    cuts = [Cut(slot(8, 6, y=6.0), FLAT), Cut(slot(7, y=20.0), WIDE), Cut(slot(9, 6, 3, y=6.0), FLAT)]
    return simulate_job(cuts, stock=BOX, view=view)


def test_moment_after_a_cut_equals_a_job_of_this_cut_alone(job):
    first, _, _ = job.cuts.cuts
    alone = simulate(first.toolpath, tool=FLAT, stock=BOX, view=View((0, 0, -1), 160, 120))
    assert np.array_equal(job.at(job.cuts.first[1]).dexel_records, alone.dexel_records)
    assert job.at(int(job.cuts.first[1])).traces == alone.traces


def test_later_cut_removes_only_remaining_material(job):
    # The slots down to 9 and 6 mm are already cut. The last operation only removes the material from 6 to 3 mm.
    small, wide = 24 * 6 + 9 * pi, 24 * 14 + 49 * pi
    expected = [2 * small, 2 * 9 * pi, 2 * (small - 9 * pi), 3 * wide, 0, 0, 0, 3 * 9 * pi, 3 * (small - 9 * pi)]
    assert removed_volumes(job) == pytest.approx(expected, rel=0.02)


def test_trajectories_of_a_job_are_numbered_together(job):
    assert [job.cuts.source(k) for k in (0, 2, 3, 4, 8)] == [
        Source(0, 0, 0), Source(0, 2, 2), Source(1, 0, 0), Source(2, 0, 0), Source(2, 4, 4)
    ]  # fmt: skip
    assert job.cuts.cut.tolist() == [0, 0, 0, 1, 2, 2, 2, 2, 2]
    for wrong in (-1, 9):
        with pytest.raises(IndexError):
            job.cuts.source(wrong)


def test_cuts_without_trajectories_change_nothing(job):
    nothing = Cut(replace(toolpath(np.zeros((1, 3))), points=np.empty((0, 3))), WIDE)
    cuts = [nothing, *(cut for own in job.cuts.cuts for cut in (own, nothing))]
    again = simulate_job(cuts, stock=BOX, view=View((0, 0, -1), 160, 120))
    assert np.array_equal(again.trace_records, job.trace_records)
    assert again.cuts.source(3) == Source(3, 0, 0)
    empty = simulate_job([], stock=BOX, view=View((0, 0, -1), 16, 12))
    assert (empty.traces, empty.dexels, empty.trajectories) == (0, 16 * 12, 0)
    assert len(Cuts([]).lengths) == 0


def test_job_memory_counts_the_stock_once(job):
    view, cuts = View((0, 0, -1), 1600, 1200), list(job.cuts.cuts)
    alone = [memory_needed([cut], stock=BOX, view=view) for cut in cuts]
    together = memory_needed(cuts, stock=BOX, view=view)
    assert max(alone) < together < sum(alone) - 2 * 16 * 1600 * 1200
    with pytest.raises(OverBudget):
        simulate_job(cuts, stock=BOX, view=view, memory_budget=0.9 * together)


def test_progress_rises_until_the_end(job):
    shares = []
    simulate_job(job.cuts.cuts, stock=BOX, view=View((1, 1, -1), 160, 200), going_on=shares.append)
    assert shares == sorted(shares) and shares[0] >= 0 and 0.5 < shares[-1] <= 1

    class Stopped(Exception):
        pass

    def stop(share):
        raise Stopped

    with pytest.raises(Stopped):
        simulate_job(job.cuts.cuts, stock=BOX, view=View((1, 1, -1), 160, 200), going_on=stop)


@pytest.mark.parametrize("direction", [(0, 0, -1), (1, 1, -1)])
def test_cost_of_a_job_is_less_than_the_sum_of_its_operations(direction):
    cuts = [Cut(slot(7, 5, y=8), FLAT), Cut(slot(6, y=20), WIDE)]
    view = View(direction, 200, 150)
    expected = estimate_job(cuts, stock=BOX, view=view, speed=Speed())
    z = simulate_job(cuts, stock=BOX, view=view)
    assert expected.memory_bytes == pytest.approx(z.peak.bytes(), rel=0.1)
    alone = [estimate(cut.toolpath, None, tool=cut.tool, stock=BOX, view=view).seconds for cut in cuts]
    assert max(alone) < expected.seconds < sum(alone) * 1.1 and expected.factor == Speed().factor
    one, job = estimate(cuts[0].toolpath, None, tool=FLAT, stock=BOX, view=view), [cuts[0]]
    of_one = estimate_job(job, stock=BOX, view=view, speed=Speed())
    assert (of_one.seconds, of_one.memory_bytes) == (one.seconds, one.memory_bytes)
    assert estimate_job(cuts, stock=Stock((500, 0, 0), (510, 10, 10)), view=view, speed=Speed()).seconds > 0
