# SPDX-License-Identifier: LGPL-2.1-or-later
"""The z-buffer cost of a job is the cost of simulating all operations in one z-buffer, and is the same everywhere."""

import json

import FreeCAD
import pytest

import vkworkbench
from vkworkbench import preferences
from vkworkbench.core import simulate_job
from vkworkbench.core.simulators import ZBUFFER
from vkworkbench.core.zbuffer import estimate_job
from vkworkbench.document import upkeep
from vkworkbench.document.computer import calibration
from vkworkbench.document.job import results
from vkworkbench.document.marks import marks
from vkworkbench.document.marks.properties import MARK
from vkworkbench.document.simulation.copy import read_job


@pytest.fixture
def shown():
    preferences.write(mark_simulator=ZBUFFER.name)
    yield
    preferences.write(mark_simulator=preferences.OWN)


@pytest.fixture
def twice(small, zigzag_commands, shown):
    """A job with two equal operations and a third operation that cuts deeper."""
    deeper = [
        (name, {**words, "Z": 12.0}) if words.get("Z") == 15.0 else (name, words) for name, words in zigzag_commands
    ]
    for label, commands in (("First", zigzag_commands), ("Second", zigzag_commands), ("Third", deeper)):
        small.add(label, commands)
    return small


def summed(report):
    return sum(o.estimate.seconds for o in report.operations if o.counted)


@pytest.mark.long
def test_total_is_the_cost_of_simulating_the_job(example):
    (total,) = vkworkbench.analyze(example).totals
    job, view = read_job(example), preferences.read().view
    expected = estimate_job(job.cuts, stock=job.stock, view=view, speed=calibration.measured_speed())
    assert (total.seconds, total.memory_bytes) == (expected.seconds, expected.memory_bytes)
    true = simulate_job(job.cuts, stock=job.stock, view=view)
    whole = total.costs[ZBUFFER.name]
    assert abs(whole.traces - true.traces) <= 2 * whole.traces_error
    assert total.memory_bytes == pytest.approx(true.peak.bytes(), rel=0.1)


def test_equal_cuts_of_two_operations_add_their_cost_once(twice):
    report = vkworkbench.analyze(twice.document)
    (total,) = report.totals
    first, second, third = (o.estimate for o in report.operations)
    assert second.traces == first.traces
    assert total.costs[ZBUFFER.name].traces == pytest.approx(first.traces + third.traces, rel=0.05)
    assert total.memory_bytes < first.memory_bytes + third.memory_bytes - third.stock_bytes + 0.05 * first.memory_bytes


def test_report_and_mark_contain_the_same_total(twice, tmp_path):
    report = vkworkbench.analyze(twice.document)
    vkworkbench.mark(report)
    (total,) = report.totals
    assert total.seconds < summed(report)
    assert marks.read(twice.job).cost(ZBUFFER.name) == total.cost(ZBUFFER.name)
    report.to_json(tmp_path / "report.json")
    (told,) = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))["totals"]
    assert (told["seconds"], told["memory_bytes"]) == total.cost(ZBUFFER.name)


def test_operations_marked_one_by_one_have_the_same_total(twice):
    report = vkworkbench.analyze(twice.document)
    for obj in twice.job.Operations.Group:
        vkworkbench.mark(vkworkbench.analyze(obj))
    assert marks.read(twice.job).cost(ZBUFFER.name) == report.totals[0].cost(ZBUFFER.name)


def test_marking_does_not_estimate_costs(twice, monkeypatch):
    asked = []

    def estimated(*what, **how):
        asked.append(what)
        return estimate_job(*what, **how)

    monkeypatch.setattr("vkworkbench.core.simulators.zbuffer.estimate_job", estimated)
    vkworkbench.mark(vkworkbench.analyze(twice.document))
    assert len(asked) == 1
    last = twice.job.Operations.Group[-1]
    last.Path = FreeCAD.ActiveDocument.getObject(twice.job.Operations.Group[0].Name).Path
    report = vkworkbench.analyze(last)
    assert len(asked) == 2
    vkworkbench.mark(report)
    assert len(asked) == 2 and marks.read(twice.job).cost(ZBUFFER.name)[0] < 3 * report.operations[0].estimate.seconds


def test_total_is_stored_in_the_file_or_replaced_by_a_sum(twice, tmp_path):
    report = vkworkbench.analyze(twice.document)
    vkworkbench.mark(report)
    total = report.totals[0].cost(ZBUFFER.name)
    file = str(tmp_path / "job.FCStd")
    twice.document.saveCopy(file)
    again = FreeCAD.openDocument(file)
    try:
        (job,) = [obj for obj in again.Objects if obj.Name == twice.job.Name]
        first = job.Operations.Group[0]
        assert results.latest_row(first, marks.read(first).fingerprint) is None
        assert marks.read_total(job).cost(ZBUFFER.name) == total
        vkworkbench.mark(vkworkbench.analyze(first))
        assert marks.read(job).cost(ZBUFFER.name)[0] == pytest.approx(summed(report))
        vkworkbench.mark(vkworkbench.analyze(again))
        assert marks.read(job).cost(ZBUFFER.name) == total
    finally:
        FreeCAD.closeDocument(again.Name)


def test_total_of_a_job_is_invalid_if_an_operation_is_removed(twice):
    vkworkbench.mark(vkworkbench.analyze(twice.document))
    assert marks.read_total(twice.job) is not None
    twice.document.removeObject(twice.job.Operations.Group[0].Name)
    assert marks.read_total(twice.job) is None


def test_operation_that_cuts_nothing_costs_nothing(twice):
    """An operation of rapids above the stock costs nothing in any simulator, and its total is complete."""
    twice.add("Away", [("G0", {"Z": 50.0}), ("G0", {"X": 0.0, "Y": 0.0}), ("G0", {"Z": 80.0})])
    report = vkworkbench.analyze(twice.job)
    (total,) = report.totals
    assert report.operations[-1].trajectories and not total.incomplete
    vkworkbench.mark(report)
    assert "sim ≥" not in twice.job.Label2 and "Away" not in twice.job.Label2


def test_results_of_a_closed_document_are_dropped(twice):
    vkworkbench.mark(vkworkbench.analyze(twice.document))
    name = twice.document.Name
    assert any(document == name for document, _ in results.latest_rows(()))
    FreeCAD.closeDocument(name)
    assert not any(document == name for document, _ in results.latest_rows(()))


@pytest.fixture
def linked(small, zigzag_commands):
    """An operation and a link to it in one job."""
    op = small.add("Zigzag", zigzag_commands)
    link = small.document.addObject("App::Link", "Link")
    link.LinkedObject, link.Label = op, "Once more"
    small.job.Operations.Group += [link]
    small.document.recompute()
    return op, link


def test_link_in_a_job_is_an_operation_of_the_total(small, linked):
    """FreeCAD also posts the path of a link in the job's group of operations."""
    op, link = linked
    report = vkworkbench.analyze(small.document)
    one, other = report.operations
    assert (one.name, other.name, other.label) == (op.Name, link.Name, "Once more")
    assert other.counted and other.strategy == "zigzag" and other.length == one.length and other.costs
    assert report.totals[0].operations == 2 and report.totals[0].length == 2 * one.length
    vkworkbench.mark(report)
    assert small.job.Label2.startswith("⟦2 operations · ")
    assert marks.read(small.job).length == pytest.approx(2 * one.length)
    assert link.Label2 == "" and MARK not in link.PropertiesList  # a link to a marked operation has no mark in the tree
    op.Active = False
    small.document.recompute()
    assert vkworkbench.analyze(small.document).totals[0].operations == 0
    assert vkworkbench.clear(small.document) == 2 and MARK not in op.PropertiesList


def test_link_outside_the_job_is_not_in_the_total_or_marked(small, linked):
    op, link = linked
    small.job.Operations.Group = [op]
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert small.job.Label2.startswith("⟦1 operation · ")
    before = op.Label2
    preferences.write(mark_simulator=ZBUFFER.name)
    try:
        upkeep.follow_preferences()
        assert op.Label2 != before and link.Label2 == ""
    finally:
        preferences.write(mark_simulator=preferences.OWN)


def test_link_to_a_job_is_not_a_job(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    link = small.document.addObject("App::Link", "Link")
    link.LinkedObject = small.job
    small.document.recompute()
    assert [row.name for row in vkworkbench.analyze(small.document).operations] == [op.Name]
