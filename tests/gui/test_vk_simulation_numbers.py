# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers that the simulation tab shows and saves, for jobs of a few moves; most tests need no window."""

from __future__ import annotations

import csv
from itertools import accumulate
from types import SimpleNamespace

import numpy as np
import pytest

from vkworkbench.core import Cut, Stock, Strategy, Tool, View, linearize, simulate_job
from vkworkbench.core.zbuffer import (
    PENDING,
    TOLERANCE,
    Collisions,
    CrashCheck,
    OverBudget,
    SeenModel,
    Speed,
    estimate_job,
    memory_needed,
)  # fmt: skip
from vkworkbench.document.simulation.along_axis import AlongAxis
from vkworkbench.document.simulation.job import SimulatedJob, SimulatedOperation
from vkworkbench.document.simulation.simulate import simulate_read
from vkworkbench.gui.simulation import coloring, exports
from vkworkbench.gui.simulation.faults import Fault, KnownFaults, differences, judge
from vkworkbench.gui.simulation.moment import Clock
from vkworkbench.gui.simulation.part_view import round_length
from vkworkbench.gui.simulation.simulating import Findings, Simulating
from vkworkbench.gui.simulation.time_line import TimeLine
from vkworkbench.language import Message, Unusable

STOCK = Stock((0, 0, 0), (60, 40, 20))
# SLOT cuts a slot at a feed of 10 mm/s. CRASH moves through the stock with a rapid, whose speed is not given.
SLOT = [("G0", {"X": 5.0, "Y": 10.0, "Z": 30.0}), ("G1", {"Z": 15.0, "F": 5.0}), ("G1", {"X": 55.0, "F": 10.0})]
CRASH = [("G0", {"X": 5.0, "Y": 30.0, "Z": 30.0}), ("G0", {"Z": 15.0}), ("G0", {"X": 55.0})]


def job_of(*paths):
    operations = [SimulatedOperation("D", f"Op{k}", f"Op {k}", (50.0, 50.0), False, "") for k in range(len(paths))]
    cuts = [Cut(linearize(path), Tool("endmill", 6.0)) for path in paths]
    listings = [[name for name, _ in path] for path in paths]
    toolpaths = [cut.toolpath for cut in cuts]
    return SimulatedJob(tuple(operations), tuple(cuts), tuple(toolpaths), tuple(listings), STOCK, (), ())


def simulated(job, rays=240 * 160, memory=1e9, seconds=1e3):
    """Return all results of simulating a job, and the error at the end."""
    found = []
    try:
        found.extend(Simulating(job, rays, memory, seconds, Speed())(lambda: None))
    except Unusable as error:
        return found, error
    return found, None


WHOLE = View((0, 0, -1), 240, 160)


def test_simulations_are_coarse_first_and_of_the_whole_stock():
    job = job_of(SLOT, CRASH)
    (coarse, fine, findings), error = simulated(job)
    assert error is None and not coarse.is_finest and fine.is_finest
    frames = [done.simulation.zbuffer.frame for done in (coarse, fine)]
    assert [(f.width, f.height) for f in frames] == [(55, 37), (240, 160)]
    assert all((f.direction == (0, 0, -1)).all() and f.width * f.pixel >= 60 - 1e-9 for f in frames)
    for done in (fine, findings):
        assert done.volumes.sum() == pytest.approx(2 * 5 * (6 * 50 + np.pi * 9), rel=0.03) and not done.air.any()
    assert coarse.volumes.sum() == pytest.approx(fine.volumes.sum(), rel=0.2)
    assert findings.volumes.sum() == pytest.approx(findings.facts.job.removed_volume)
    assert [crash.source.cut for crash in findings.facts.job.crashes] == [1, 1]
    assert findings.facts.verdict.crashes == 2


def test_simulation_over_the_memory_budget_is_coarser():
    job, view = job_of(SLOT), View((0, 0, -1), 600, 400)
    allowed = memory_needed(job.cuts, stock=STOCK, view=view) / 1.5
    with pytest.raises(OverBudget) as refused:
        simulate_read(job, view, allowed)
    found, _ = simulated(job, 600 * 400, memory=allowed)
    frame = found[1].simulation.zbuffer.frame
    assert (frame.width, frame.height) == refused.value.size and 300 < frame.width < 600


@pytest.mark.long
def test_simulation_over_time_budget_is_coarser():
    job = job_of(*[SLOT] * 20)
    whole = estimate_job(job.cuts, stock=STOCK, view=View((0, 0, -1), 1200, 800)).seconds
    found, error = simulated(job, 1200 * 800, seconds=0.7 * whole)
    assert error.what.code == "picture-in-time" and error.what.arguments["allowed"] == 0.7 * whole
    assert 300 < found[1].simulation.zbuffer.frame.width < 1200 and found[1].is_finest


def gouge(cut, depth, command=0):
    return Fault(cut, command, 0, (0.0, 0.0, 0.0), Message("cuts-model", depth=depth), True)


def test_missing_stock_is_not_a_gouge():
    """The top of the stock is 3 mm below the model's top, and the slot is 8 mm too deep."""
    job, model = job_of(SLOT), Stock((0, 0, 0), (60, 40, 23))
    vars(job)["model"] = model
    known, zbuffer = KnownFaults(job, Clock(job)), simulate_job(job.cuts, stock=STOCK, view=WHOLE)
    along_axis = [
        AlongAxis(job, at, CrashCheck(), Collisions((), 0.0, (), (), 0), None, SeenModel(model, at.frame))
        for at in (zbuffer.at(0), zbuffer)
    ]
    uncut, finished = (Findings(axis, axis.facts(TOLERANCE), None, None) for axis in along_axis)
    judged = judge(finished, TOLERANCE, compares=False)
    lacks = "Stock: The stock is 3 mm too small for the model. Choose a larger stock, or move the model within it."
    assert [known.text(fault) for fault in differences(uncut, 0.1)] == [lacks]
    for found in (judged.faults, judged.proved, judge(finished, 0.2, compares=False).faults):
        slot, stock = (known.text(fault) for fault in found)
        assert slot.startswith("Op 0, command ") and "The tool cuts 8 mm into the model." in slot and stock == lacks
    assert judge(finished, 9.0, compares=False).faults == []


def test_marks_in_the_tree_show_the_latest_faults():
    job = job_of(SLOT)
    known = KnownFaults(job, Clock(job))
    crash = Fault(0, 7, 0, (0.0, 0.0, 0.0), Message("rapid-cuts", volume=50.69), True)
    told = []
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr("vkworkbench.gui.simulation.faults.keep_faults", lambda faults: bool(told.append(faults)))
        known.follow(True)
        assert not told  # no mark in the tree gets a fault before the part was compared with the model
        known.keep([gouge(0, 20.0, command=2)], PENDING)
        known.keep([crash, gouge(0, 0.3)], PENDING)
        known.follow(False)
    *_, last = told
    ((_, wrong),) = last.items()
    assert wrong == [(7, crash.what), (0, gouge(0, 0.3).what)] and len(told) == 2


def test_equal_differences_are_listed_with_their_places():
    job = job_of(SLOT)
    known = KnownFaults(job, Clock(job))
    left = [Fault(None, None, None, (x, 2.0, 19.25), Message("leaves-material", depth=1.0), False) for x in (1.5, 58.0)]
    assert [known.text_with_place(fault) for fault in left] == [
        "Stock: 1 mm of stock is left on the model. (X 1.5 Y 2 Z 19.25 mm)",
        "Stock: 1 mm of stock is left on the model. (X 58 Y 2 Z 19.25 mm)",
    ]


def test_saved_removal_rates_are_volumes_per_minute(tmp_path):
    job = job_of(SLOT, CRASH)
    clock = Clock(job)
    volumes = np.arange(1.0, len(clock.cuts) + 1)
    player = SimpleNamespace(job=job, clock=clock, volumes=volumes)
    exports.write_rates(player, tmp_path / "rates.csv")
    rows = list(csv.DictReader((tmp_path / "rates.csv").open(encoding="utf-8")))
    assert [row["operation"] for row in rows] == ["Op 0"] * 2 + ["Op 1"] * 2
    # 15 mm at 5 mm/s, 50 mm at 10 mm/s, then rapids at 50 mm/s.
    seconds = [3.0, 5.0, 0.3, 1.0]
    ends = list(accumulate(seconds))
    for row, volume, time, begin, end in zip(rows, volumes, seconds, [0.0, *ends], ends):
        numbers = [float(row[name]) for name in ("begin_s", "end_s", "volume_mm3", "rate_mm3_per_min")]
        assert numbers == pytest.approx([begin, end, volume, 60 * volume / time], rel=1e-5)


def colored(make, volumes, ends):
    clock = Clock.__new__(Clock)  # do not call __init__, which needs a job
    clock.ends, clock.cuts = np.array(ends), volumes
    job = coloring.Job(("Op",), (Strategy.UNKNOWN,), clock, np.array(volumes), None, False, 0.1)
    return make(None, job)


def test_scale_of_removal_rates_leaves_out_the_fastest_1_percent():
    # The moves remove 69.5 mm³ in 60 s, 30 mm³ in 15 s, and half a percent of the total in the last 0.01 s.
    found = colored(coloring.by_removal_rate, [69.5, 30.0, 0.5], [0.0, 60.0, 75.0, 75.01])
    assert [name for _, name in found.legend() if name] == ["0", "120 mm³/min"]


def test_colour_of_the_last_move_does_not_depend_on_other_moves():
    last = colored(coloring.by_time, [1.0, 1.0], [0.0, 50.0, 100.0]).colors
    alone = colored(coloring.by_time, [1.0], [0.0, 100.0]).colors
    assert (last[2] == alone[1]).all() and not (last[1] == last[2]).all()  # colour 0 belongs to the stock


def test_missing_feed_is_the_median_of_the_other_feeds():
    words = [
        {"X": 0.0, "Y": 0.0, "Z": 15.0},
        {"X": 10.0},
        *({"X": 10.0 * k, "F": f} for k, f in ((2, 1), (3, 2), (4, 50))),
    ]
    clock = Clock(job_of([("G1", own) for own in words]))
    assert np.diff(clock.ends).tolist() == pytest.approx([5.0, 10.0, 5.0, 0.2]) and not clock.complete


def test_time_line_shows_air_cuts():
    line = TimeLine()
    line.show_job((), 4.0)
    line.show_facts(np.array([0.0, 1.0, 2.0, 4.0]), np.array([3.0, 0.0, 5.0]), np.array([False, True, False]), ())
    removed, air = line._by_column(4)
    assert removed.tolist() == pytest.approx([3.0, 0.0, 2.5, 2.5])
    assert air.tolist() == pytest.approx([0.0, 1.0, 0.0, 0.0])
    line.deleteLater()


@pytest.mark.parametrize(
    ("most", "expected"), [(34.9, 20), (1.0, 1), (0.99, 0.5), (5.0, 5), (0.0023, 0.002), (7e4, 5e4)]
)
def test_scale_bar_has_a_round_length(most, expected):
    assert round_length(most) == pytest.approx(expected)
