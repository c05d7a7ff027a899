# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faults found by a simulation are remarks of the operation while its toolpath is unchanged."""

from dataclasses import replace

import vkworkbench
from vkworkbench.document.simulation.copy import read_job
from vkworkbench.document.simulation.faults import keep_faults, read_with_faults, with_faults
from vkworkbench.language import Message

CRASH = Message("rapid-cuts", volume=22.0)


def slot(y):
    return [("G0", {"X": 5.0, "Y": y, "Z": 30.0}), ("G0", {"Z": 15.0}), ("G1", {"X": 55.0, "F": 10.0})]


def told(small):
    """Analyse the document; return {label: arguments of the remarks on simulated faults}."""
    return {row.label: [remark.arguments for remark in row.remarks if remark.code == "simulated"]
            for row in vkworkbench.analyze(small.document).operations}  # fmt: skip


def simulated(small):
    """Add two slots, and keep two faults of the second slot, as a simulation does."""
    small.add("First", slot(10.0))
    small.add("Second", slot(20.0))
    first, second = read_job(small.job).operations
    keep_faults({first: [], second: [(1, CRASH), (2, CRASH)]})


def test_fault_is_kept_with_its_operation(small):
    simulated(small)
    expected = {"count": 2, "command": 2, "fault": CRASH}
    assert told(small) == {"First": [], "Second": [expected]} == told(small)
    (row,) = vkworkbench.analyze(small.document.getObjectsByLabel("Second")[0]).operations
    assert (
        "The simulation shows faults at 2 commands, for example at command 2: A rapid move removes 22 mm³." in row.error
    )


def test_fault_is_dropped_after_a_toolpath_change(small):
    for label in ("Second", "First"):
        simulated(small)
        assert told(small)["Second"]
        op = small.document.getObjectsByLabel(label)[0]
        before = op.Path
        op.Path = type(before)(before.Commands[:-1])
        assert told(small)["Second"] == []
        op.Path = before  # even with the former path, the dropped fault is only found by a new simulation
        assert told(small)["Second"] == []
        for obj in small.document.getObjectsByLabel("First") + small.document.getObjectsByLabel("Second"):
            small.document.removeObject(obj.Name)


def test_fault_is_dropped_after_reordering(small):
    simulated(small)
    small.job.Operations.Group = small.job.Operations.Group[::-1]
    assert told(small)["Second"] == []


def test_new_simulation_replaces_the_faults(small):
    simulated(small)
    first, second = read_job(small.job).operations
    keep_faults({first: [], second: []})
    assert told(small)["Second"] == []


def test_fault_is_shown_with_a_mark_but_not_stored_in_it(small):
    small.add("First", slot(10.0))
    small.add("Second", slot(20.0))
    second = small.document.getObjectsByLabel("Second")[0]
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert not [remark for remark in read_with_faults(second).remarks if remark.code == "simulated"]
    keep_faults(dict(zip(read_job(small.job).operations, ([], [(1, CRASH)]))))
    assert [remark.code for remark in read_with_faults(second).remarks][-1] == "simulated"
    vkworkbench.mark(vkworkbench.analyze(small.document))
    first = small.document.getObjectsByLabel("First")[0]
    # A change of the first operation changes the part into which the second operation cuts.
    first.Path = type(first.Path)(first.Path.Commands[:-1])
    assert not [remark for remark in read_with_faults(second).remarks if remark.code == "simulated"]


def test_keep_faults_returns_whether_the_faults_are_new(small):
    small.add("First", slot(10.0))
    small.add("Second", slot(20.0))
    first, second = read_job(small.job).operations
    crash, other = [(1, CRASH)], [(2, CRASH)]
    assert not keep_faults({first: [], second: []})
    assert keep_faults({first: crash, second: []})  # the result is true, because the first operation has a new fault
    assert not keep_faults({first: crash, second: []})
    assert keep_faults({first: crash, second: other}) and keep_faults({first: other, second: other})
    assert keep_faults({first: [], second: other}) and not keep_faults({second: other})


def test_simulated_remark_is_not_shown_for_another_toolpath(small):
    simulated(small)
    (row,) = vkworkbench.analyze(small.document.getObjectsByLabel("Second")[0]).operations
    of_before = with_faults(replace(row, fingerprint="of:before"), row.document, row.name)
    assert [remark.code for remark in row.remarks][-1] == "simulated"
    assert "simulated" not in [remark.code for remark in of_before.remarks]
