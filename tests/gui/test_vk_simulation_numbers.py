# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers that the simulation tab shows and saves, for jobs of a few moves; most tests need no window."""

from __future__ import annotations

import csv
from itertools import accumulate
from types import SimpleNamespace

import numpy as np
import pytest

from vkworkbench.core import Cut, Stock, Strategy, Tool, View, linearize, simulate_job
from vkworkbench.core.zbuffer import OverBudget, SeenModel, Speed, memory_needed
from vkworkbench.document.simulation.job import SimulatedJob, SimulatedOperation
from vkworkbench.document.simulation.simulate import simulate_read
from vkworkbench.gui.simulation import coloring, exports
from vkworkbench.gui.simulation.faults import Fault, KnownFaults, differences, judge
from vkworkbench.gui.simulation.moment import Clock
from vkworkbench.gui.simulation.pictures import Drawing
from vkworkbench.gui.simulation.refining import Budgets, Facts, Findings, Refined, Refining, holds
from vkworkbench.gui.simulation.time_line import TimeLine
from vkworkbench.language import Message

STOCK = Stock((0, 0, 0), (60, 40, 20))
# Two slots: one with a feed of 10 mm/s, one cut by a rapid move, whose speed is not given.
SLOT = [("G0", {"X": 5.0, "Y": 10.0, "Z": 30.0}), ("G1", {"Z": 15.0, "F": 5.0}), ("G1", {"X": 55.0, "F": 10.0})]
CRASH = [("G0", {"X": 5.0, "Y": 30.0, "Z": 30.0}), ("G0", {"Z": 15.0}), ("G0", {"X": 55.0})]


def job_of(*paths):
    operations = [SimulatedOperation("D", f"Op{k}", f"Op {k}", (50.0, 50.0), False, "") for k in range(len(paths))]
    cuts = [Cut(linearize(path), Tool("endmill", 6.0)) for path in paths]
    listings = [[name for name, _ in path] for path in paths]
    toolpaths = [cut.toolpath for cut in cuts]
    return SimulatedJob(tuple(operations), tuple(cuts), tuple(toolpaths), tuple(listings), STOCK, (), ())


def refined(job, view, known=None, memory=1e9):
    """Return all results of refining a view."""
    work = Refining(job, view, Budgets(memory, 1e3), Speed(), glance=False, compare=False, known=known)
    return list(work(lambda: None))


WHOLE = View((0, 0, -1), 240, 160)
PART = View((0, 0, -1), 240, 160, pixel=0.02, offset=(0.0, -10.0))


def test_picture_over_the_memory_budget_is_coarser():
    job, view = job_of(SLOT), View((0, 0, -1), 600, 400)
    allowed = memory_needed(job.cuts, stock=STOCK, view=view) / 1.5
    with pytest.raises(OverBudget) as refused:
        simulate_read(job, view, allowed)
    (*_, last) = (done for done in refined(job, view, memory=allowed) if isinstance(done, Refined))
    frame = last.simulation.zbuffer.frame
    assert (frame.width, frame.height) == refused.value.size and 300 < frame.width < 600


def test_removed_volumes_come_from_images_of_the_whole_stock():
    job = job_of(SLOT, CRASH)
    (*_, whole) = (done for done in refined(job, WHOLE) if isinstance(done, Findings))
    assert whole.facts.volumes.sum() == pytest.approx(2 * 5 * (6 * 50 + np.pi * 9), rel=0.03)
    assert [crash.source.cut for crash in whole.facts.crashes] == [1, 1] and not whole.facts.air.any()
    done = refined(job, PART, whole.facts)
    assert not any(one.facts for one in done if isinstance(one, Findings))
    (*_, last) = (one for one in done if isinstance(one, Refined))
    assert last.simulation.zbuffer.frame.pixel == 0.02  # the picture shows a part of the stock
    # If the whole stock was never simulated so finely, its facts come last, without a picture.
    for known in (None, whole.facts):
        coarse = known and Facts(
            8 * known.pixel, *[getattr(known, own) for own in ("volumes", "air", "crashes", "plunges")]
        )
        *before, own = refined(job, PART, coarse)
        assert (own.facts.volumes == whole.facts.volumes).all() and own.facts.pixel == whole.facts.pixel
        assert all(one.simulation.zbuffer.frame.pixel < 0.2 for one in before if isinstance(one, Refined))


@pytest.mark.parametrize("direction", [(0, 0, -1), (-1, 1, -1), (0, 1, 0), (0.3, -0.2, 0.9)])
def test_image_holds_the_stock_only_if_all_is_within(direction):
    whole = View(direction, 300, 200)
    pixel = whole.frame(STOCK).pixel
    assert holds(whole.frame(STOCK), STOCK)
    assert not holds(View(direction, 300, 200, pixel=0.99 * pixel).frame(STOCK), STOCK)
    assert holds(View(direction, 300, 200, pixel=2 * pixel, offset=(40 * pixel, 0)).frame(STOCK), STOCK)
    for offset in ((310 * pixel, 0), (0, 210 * pixel)):
        assert not holds(View(direction, 300, 200, pixel=2 * pixel, offset=offset).frame(STOCK), STOCK)


def test_facts_of_a_fine_picture_outlive_coarser_pictures():
    job = job_of(SLOT)
    drawing = Drawing(job, Clock(job), None)
    fine, coarse, part, other = (
        SimpleNamespace(
            simulation=None, seen=None, facts=pixel and Facts(pixel, np.zeros(3), np.zeros(3, bool), [], [])
        )
        for pixel in (0.1, 0.8, None, 0.15)
    )
    for told, expected in ((coarse, coarse), (fine, fine), (coarse, fine), (part, fine), (other, other)):
        drawing.take(told)
        assert drawing.facts is expected.facts


def gouge(cut, depth, command=0):
    return Fault(cut, command, 0, (0.0, 0.0, 0.0), Message("cuts-model", depth=depth), True)


def test_gouges_outside_the_picture_are_kept(monkeypatch):
    """A picture beside the gouge keeps its depth; a picture of the whole stock may lower the depth."""
    facts = Facts(1.0, np.zeros(3), np.zeros(3, bool), [], [])
    seen = [gouge(0, 0.4), gouge(2, 0.2)]
    monkeypatch.setattr("vkworkbench.gui.simulation.faults._gouged", lambda told, tolerance: list(seen))
    before = [gouge(0, 0.3), gouge(1, 0.5), gouge(2, 0.6), gouge(3, 0.1)]
    depths = {}
    for name, of_image in (("part", None), ("whole", facts)):
        told = Findings(None, of_image, None, judged=True)
        depths[name] = [(f.cut, f.gouged) for f in judge(told, facts, 0.15, before, False).faults]
    assert depths == {"part": [(2, 0.6), (1, 0.5), (0, 0.4)], "whole": [(1, 0.5), (0, 0.3), (2, 0.2)]}


def test_missing_stock_is_not_a_gouge():
    """The stock is 3 mm too low, and a slot is 8 mm too deep."""
    job, model = job_of(SLOT), Stock((0, 0, 0), (60, 40, 23))
    zbuffer = simulate_job(job.cuts, stock=STOCK, view=WHOLE)
    uncut, finished = (
        Findings(SimpleNamespace(zbuffer=at), None, SeenModel(model, zbuffer.frame), judged=True)
        for at in (zbuffer.at(0), zbuffer)
    )
    judged, known = judge(finished, None, 0.1, [], compares=False), KnownFaults(job, Clock(job))
    lacks = "Stock: The stock is 3 mm too small for the model. Choose a larger stock, or move the model within it."
    assert [known.text(fault) for fault in differences(uncut, 0.1)] == [lacks]
    for found in (judged.faults, judged.proved):
        slot, stock = (known.text(fault) for fault in found)
        assert slot.startswith("Op 0, command ") and "The tool cuts 8 mm into the model." in slot and stock == lacks
    known.keep(judged.proved)
    assert [fault.gouged for fault in known.gouges] == [8.0, 3.0]  # for judging other views


def test_newest_crash_and_shallowest_gouge_are_kept():
    job = job_of(SLOT)
    known = KnownFaults(job, Clock(job))
    crashes = [Fault(0, 7, 0, (0.0, 0.0, 0.0), Message("rapid-cuts", volume=volume), True) for volume in (51.35, 50.69)]
    known.keep([crashes[0], gouge(0, 20.0), gouge(0, 0.3, command=2)])
    known.keep([crashes[1], gouge(0, 0.2), gouge(0, 0.6, command=2)])
    assert [(found.command, found.gouged) for found in known.gouges] == [(0, 0.2), (2, 0.3)]
    told = []
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr("vkworkbench.gui.simulation.faults.keep_faults", told.append)
        known.follow(True)
    ((_, wrong),) = told[0].items()
    assert wrong[0] == (7, crashes[1].what) and len(wrong) == 3


def test_equal_differences_have_different_places():
    job = job_of(SLOT)
    known = KnownFaults(job, Clock(job))
    left = [Fault(None, None, None, (x, 2.0, 19.25), Message("leaves-material", depth=1.0), False) for x in (1.5, 58.0)]
    assert [known.text_with_place(fault) for fault in left] == [
        "Stock: 1 mm of stock is left on the model. (X 1.5 Y 2 Z 19.25 mm)",
        "Stock: 1 mm of stock is left on the model. (X 58 Y 2 Z 19.25 mm)",
    ]


def test_saved_rates_are_volumes_per_minute(tmp_path):
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
    clock = Clock.__new__(Clock)  # without a job
    clock.ends, clock.cuts = np.array(ends), volumes
    job = coloring.Job(("Op",), (Strategy.UNKNOWN,), clock, np.array(volumes), None, False, 0.1)
    return make(None, job)


def test_scale_of_removal_rates_leaves_out_the_fastest_1_percent():
    # 69.5 mm³ in 60 s and 30 mm³ in 15 s; the fastest move removes half a percent of the total.
    found = colored(coloring.by_removal_rate, [69.5, 30.0, 0.5], [0.0, 60.0, 75.0, 75.01])
    assert [name for _, name in found.legend() if name] == ["0", "120 mm³/min"]


def test_scale_of_times_begins_with_the_first_end():
    last = colored(coloring.by_time, [1.0, 1.0], [0.0, 50.0, 100.0]).colors
    alone = colored(coloring.by_time, [1.0], [0.0, 100.0]).colors
    assert (last[2] == alone[1]).all() and not (last[1] == last[2]).all()  # the first colour is the stock's


def test_missing_feed_is_the_median_of_the_others():
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
