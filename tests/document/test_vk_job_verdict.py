# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verdict of a simulation in the job's mark in the tree: what makes the verdict outdated or unsure."""

import FreeCAD
import Part
import Path
import pytest
from cases import first_everywhere

import vkworkbench
from vkworkbench.core.zbuffer import Verdict
from vkworkbench.document.job.clamps import set_clamps
from vkworkbench.document.marks import marks, watcher
from vkworkbench.document.simulation.copy import read_job
from vkworkbench.document.simulation.faults import keep_verdict, read_with_faults
from vkworkbench.language import render

pytestmark = pytest.mark.usefixtures("checked_coarsely")

SLOT = [("G0", {"X": -10, "Y": 20, "Z": 25}), ("G0", {"Z": 20.5}), ("G1", {"X": 70, "F": 5}), ("G0", {"Z": 25})]
SQUARE = "G0 X{x} Y5\nG1 Z18 F2\nG1 X{to} F10\nG1 Y20\nG1 X{x}\nG1 Y5\nG0 Z25\n"


@pytest.fixture
def slot(small):
    return small.add("Slot", SLOT)


def simulated_and_marked(small):
    facts = vkworkbench.simulate(small.job).facts()
    vkworkbench.mark(vkworkbench.analyze(small.job).with_facts(facts))
    return facts


def verdict(small):
    watcher.check(small.document)
    return marks.read(small.job).verdict


def test_verdict_on_a_job_is_in_the_mark_of_the_job(small, slot):
    undo = small.document.UndoCount
    facts = simulated_and_marked(small)
    assert small.document.UndoCount == undo + 1
    told = verdict(small)
    assert told.what == facts.sentence and told.is_sound and "No collision" in small.job.Remarks
    small.document.undo()
    assert marks.read(small.job) is None and marks.read(slot) is None


def test_verdict_on_a_job_stays_when_it_is_analyzed_again(small, slot):
    simulated_and_marked(small)
    report = vkworkbench.analyze(small.job)
    assert [str(one) for one in report.verdicts.values()] == [str(verdict(small))]
    vkworkbench.mark(report)
    assert verdict(small).is_sound


def change_path(small, slot):
    slot.Path = Path.Path(slot.Path.Commands[:-1])


def change_tool(small, slot):
    small.controller.Tool.Diameter = 4


def change_stock(small, slot):
    small.job.Stock.ExtZpos = 3


def change_clamps(small, slot):
    set_clamps(small.job, [small.document.getObject("Vice")])


def move_clamp(small, slot):
    small.document.getObject("Old").Placement.Base = FreeCAD.Vector(0, -300, 0)


@pytest.mark.parametrize(
    "change", first_everywhere([change_path, change_tool, change_stock, change_clamps, move_clamp], 2)
)
def test_verdict_on_a_job_is_outdated_after_a_change(small, slot, change):
    for name, y in (("Vice", -90), ("Old", -150)):
        clamp = small.document.addObject("Part::Feature", name)
        clamp.Shape = Part.makeBox(20, 20, 20, FreeCAD.Vector(0, y, 0))
    set_clamps(small.job, [small.document.getObject("Old")])
    simulated_and_marked(small)
    assert verdict(small).is_sound
    small.document.openTransaction("change")
    change(small, slot)
    small.document.recompute()
    small.document.commitTransaction()
    assert verdict(small).outdated and "outdated" in small.job.Remarks
    vkworkbench.mark(vkworkbench.analyze(small.job))
    assert verdict(small).outdated  # a new analysis is not enough: the changed job has to be simulated, too
    simulated_and_marked(small)
    assert verdict(small).is_sound


def test_undoing_a_change_restores_the_verdict_on_the_job(small, slot):
    simulated_and_marked(small)
    small.document.openTransaction("change")
    slot.Path = Path.Path(slot.Path.Commands[:-1])
    small.document.commitTransaction()
    assert verdict(small).outdated
    small.document.undo()
    assert verdict(small).is_sound


def test_simulation_with_other_clamps_gives_the_job_no_verdict(small, slot):
    vice = small.document.addObject("Part::Feature", "Vice")
    vice.Shape = Part.makeBox(20, 20, 20, FreeCAD.Vector(0, -90, 0))
    facts = vkworkbench.simulate(small.job, clamps=[vice]).facts()
    report = vkworkbench.analyze(small.job).with_facts(facts)
    assert "1 clamp was checked" in str(report)
    vkworkbench.mark(report)
    assert verdict(small) is None


def test_verdict_of_the_simulation_tab_is_shown_until_a_change(small, slot):
    """The simulation window does not write into the document; the next analysis writes the verdict into the mark."""
    vkworkbench.mark(vkworkbench.analyze(small.job))
    job, undo = read_job(small.job), small.document.UndoCount
    sound = Verdict(pixel=0.1)
    assert keep_verdict(job, sound) and not keep_verdict(job, sound)
    assert read_with_faults(small.job).verdict.is_sound and verdict(small) is None
    assert small.document.UndoCount == undo
    vkworkbench.mark(vkworkbench.analyze(small.job))
    assert verdict(small).is_sound
    keep_verdict(job, Verdict(pixel=0.1, crashes=1))
    assert not read_with_faults(small.job).verdict.is_sound
    slot.Path = Path.Path(slot.Path.Commands[:-1])
    assert verdict(small).outdated and read_with_faults(small.job).verdict == verdict(small)


def test_simulation_of_one_operation_gives_the_job_no_verdict(small, slot):
    small.add("Second", SLOT)
    facts = vkworkbench.simulate(slot).facts()
    assert vkworkbench.analyze(small.job).with_facts(facts).verdicts == {} and facts.valid_for == ""


def test_operation_without_tool_makes_the_verdict_unsure(small, slot):
    small.add("Second", SLOT, controller=None)
    facts = simulated_and_marked(small)
    assert [str(one) for one in facts.as_dict()["remarks"]] == [
        "Second: The operation has no tool. Give it a tool controller."
    ]
    assert not facts.verdict.is_sound and "Not everything could be checked: Second" in str(verdict(small))
    assert not verdict(small).is_sound


def test_stop_and_comment_without_tool_have_no_remark(small, slot):
    for name, text in (("Comment", "(check the clamps)"), ("Stop", "M1"), ("Fixture", "G54")):
        other = small.document.addObject("Path::FeaturePython", name)
        other.Path = Path.Path(text)
        small.job.Operations.Group = [other, *small.job.Operations.Group]
    facts = vkworkbench.simulate(small.job).facts()
    assert facts.remarks == () and facts.verdict.is_sound


def test_change_of_the_work_offset_has_a_remark(small, slot):
    """A work offset that changes after the first move has an unknown origin: between two operations or within one."""
    fixture = small.document.addObject("Path::FeaturePython", "Fixture")
    fixture.Path = Path.Path("G55")
    small.job.Operations.Group = [*small.job.Operations.Group, fixture]
    second = small.add("Second", SLOT)
    facts = vkworkbench.simulate(small.job).facts()
    (remark,) = facts.remarks
    assert render(remark).startswith("Second: G55 is ignored")
    assert not facts.verdict.is_sound
    second.Path = Path.Path("G0 Z25\n" + SQUARE.format(x=5, to=20) + "G55\n" + SQUARE.format(x=5, to=20))
    (row,) = vkworkbench.analyze(second)
    assert "Command 9: G55 is ignored" in row.error


def test_first_work_offset_has_no_remark(small):
    small.add("Slot", [("G55", {}), *SLOT])
    small.job.Fixtures = ["G55", "G56"]
    assert vkworkbench.simulate(small.job).facts().remarks == ()
    assert "x2 " in str(vkworkbench.analyze(small.job))


def test_toolpath_of_a_lathe_has_a_remark(small):
    passes = [("G0", {"X": 20, "Y": 0, "Z": 65})]
    for x in (15, 14, 13, 12):
        passes += [("G0", {"X": x}), ("G1", {"Z": 30, "F": 3}), ("G0", {"X": 20}), ("G0", {"Z": 65})]
    small.add("Turn", passes)
    facts = vkworkbench.simulate(small.job).facts()
    assert [remark.arguments["sentence"].code for remark in facts.remarks] == ["turned"]
    assert not facts.verdict.is_sound


def test_drilled_row_is_not_taken_for_a_lathe_toolpath(small):
    holes = [("G0", {"X": 5, "Y": 0, "Z": 25})]
    for x in (5, 15, 25, 35):
        holes += [("G0", {"X": x}), ("G1", {"Z": 10, "F": 3}), ("G0", {"Z": 25})]
    small.add("Drill", holes)
    assert vkworkbench.simulate(small.job).facts().remarks == ()


def test_clamp_without_closed_surface_is_left_out_with_a_remark(small, slot):
    clamp = small.document.addObject("Part::Feature", "Clamp")
    clamp.Shape = Part.makeBox(20, 20, 20, FreeCAD.Vector(0, -90, 0))
    set_clamps(small.job, [clamp])
    clamp.Shape = clamp.Shape.Faces[0]
    facts = vkworkbench.simulate(small.job).facts()
    assert [remark.code for remark in facts.remarks] == ["clamp-left-out"] and not facts.verdict.is_sound
