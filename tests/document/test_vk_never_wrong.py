# SPDX-License-Identifier: LGPL-2.1-or-later
"""No mark in the tree is wrong: if an operation has changed since its analysis, its mark is removed or outdated."""

import FreeCAD
import Part
import Path
import pytest

import vkworkbench
from vkworkbench import preferences
from vkworkbench.document import upkeep
from vkworkbench.document.job.fingerprint import path_fingerprint, text_fingerprint
from vkworkbench.document.marks import marks, watcher


@pytest.fixture
def marked(small, zigzag_commands):
    small.op = small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    return small


@pytest.fixture
def other():
    document = FreeCAD.newDocument("Other")
    yield document
    FreeCAD.closeDocument(document.Name)


def outdated(document):
    return [obj.Label for obj in document.Objects if marks.is_outdated(obj)]


@pytest.mark.parametrize("how", ["copy", "copy as one step", "move"])
def test_mark_copied_to_another_document_is_outdated(marked, other, how):
    if how == "move":
        there = other.moveObject(marked.op)
    else:
        other.UndoMode = 1
        other.openTransaction("Paste")
        there = other.copyObject(marked.op, False)
        other.commitTransaction()
    if how != "copy as one step":
        other.recompute()
    assert marks.is_marked(there) and outdated(other) == [there.Label]
    assert outdated(marked.document) == ([] if how != "move" else outdated(marked.document))


def test_copied_mark_is_outdated_before_saving(marked, other, tmp_path):
    other.copyObject(marked.op, False)
    other.saveAs(str(tmp_path / "other.FCStd"))
    assert outdated(other) == ["Zigzag"]


def test_marks_copied_with_their_job_are_current(marked, other):
    other.copyObject(marked.job, True)
    other.recompute()
    assert sum(map(marks.is_marked, other.Objects)) == 2 and outdated(other) == []


def test_mark_moved_to_another_job_is_outdated(marked):
    document = marked.document
    job = document.addObject("Path::FeaturePython", "Second")
    job.addProperty("App::PropertyLink", "Operations").Operations = document.addObject(
        "App::DocumentObjectGroup", "Ops"
    )
    for name in ("Stock", "Tools"):
        job.addProperty("App::PropertyLink", name)
    job.Tools, job.Stock = marked.job.Tools, document.addObject("Part::Box", "Larger")
    job.Stock.Length = 200
    document.recompute()
    assert outdated(document) == []
    marked.job.Operations.Group = []
    job.Operations.Group = [marked.op]
    document.recompute()
    assert "Zigzag" in outdated(document)


@pytest.mark.parametrize("what", ["path", "tool", "stock"])
def test_change_during_an_analysis_outdates_the_mark(small, zigzag_commands, what):
    first, second = small.add("First", zigzag_commands), small.add("Second", zigzag_commands)

    def meanwhile(done, *_):
        if done == 1 and what == "path":
            first.Path = Path.Path(first.Path.Commands[:-3])
        elif done == 1 and what == "tool":
            small.controller.Tool.Diameter = 7
        elif done == 1:
            small.job.Stock = small.document.addObject("Part::Box", "Another")
            small.document.recompute()

    vkworkbench.mark(vkworkbench.analyze(small.document, progress=meanwhile))
    assert outdated(small.document) == [small.job.Label, "First"] and not marks.is_outdated(second)


def test_mark_of_an_older_report_is_outdated(marked):
    before = vkworkbench.analyze(marked.document)
    marked.op.Path = Path.Path(marked.op.Path.Commands[:-3])
    after = vkworkbench.analyze(marked.document)
    vkworkbench.mark(before)
    assert "Zigzag" in outdated(marked.document)
    vkworkbench.mark(after)
    assert outdated(marked.document) == []


def test_fingerprint_follows_each_path_change(marked):
    """After every change, the cached fingerprint is the fingerprint of the current path."""
    document, op = marked.document, marked.op

    def is_true():
        assert path_fingerprint(op) == text_fingerprint(op.Path.toGCode(), op.Placement)

    is_true()
    for change in (
        lambda: setattr(op, "Path", Path.Path(op.Path.Commands[:-1])),
        lambda: setattr(op, "Placement", FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation())),
        lambda: setattr(op.Placement, "Base", FreeCAD.Vector(3, 2, 1)),
    ):
        for end in (document.abortTransaction, document.commitTransaction):
            document.openTransaction("Change")
            change()
            is_true()
            end()
            is_true()
        document.undo()
        is_true()
        document.redo()
        is_true()
    name = op.Name
    document.removeObject(name)
    op = document.addObject("Path::Feature", name)
    assert op.Name == name
    is_true()


def test_report_of_a_closed_document_marks_no_other_document(small, zigzag_commands):
    small.add("Zigzag", zigzag_commands)
    report, name = vkworkbench.analyze(small.document), small.name
    FreeCAD.closeDocument(name)
    another = FreeCAD.newDocument(name)
    assert another.Name == name
    another.addObject("Path::Feature", report.operations[0].name)
    assert another.Objects[0].Name == report.operations[0].name
    assert vkworkbench.mark(report) == 0
    assert not any(map(marks.is_marked, another.Objects))


def test_report_can_mark_a_reopened_document(small, zigzag_commands, tmp_path):
    small.add("Zigzag", zigzag_commands)
    small.document.saveAs(str(tmp_path / "again.FCStd"))
    report = vkworkbench.analyze(small.document)
    FreeCAD.closeDocument(small.document.Name)
    document = FreeCAD.openDocument(str(tmp_path / "again.FCStd"))
    assert vkworkbench.mark(report) == (1 if document.Name == report.operations[0].document else 0)
    assert outdated(document) == []
    FreeCAD.closeDocument(document.Name)


def test_marks_of_a_job_without_stock_are_current_when_opened(small, zigzag_commands, tmp_path):
    stock = small.job.Stock
    small.job.Stock = None
    small.document.removeObject(stock.Name)
    small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    small.document.saveAs(str(tmp_path / "bare.FCStd"))
    FreeCAD.closeDocument(small.document.Name)
    document = FreeCAD.openDocument(str(tmp_path / "bare.FCStd"))
    try:
        job = next(obj for obj in document.Objects if hasattr(obj, "Operations"))
        assert job.Stock is not None, "FreeCAD gives it one"
        for _ in watcher.comparing(document, opened=True):
            pass
        assert outdated(document) == [] and sum(map(marks.is_marked, document.Objects)) == 2
        job.Stock = document.addObject("Part::Box", "MyOwn")
        document.recompute()
        assert "Zigzag" in outdated(document)
    finally:
        FreeCAD.closeDocument(document.Name)


@pytest.fixture
def analyzed_again():
    before = preferences.read().analyze_after_recompute
    preferences.write(analyze_after_recompute=True)
    upkeep.watch()
    yield
    preferences.write(analyze_after_recompute=before)


def test_analysis_after_recompute_adds_no_undo_step(marked, analyzed_again):
    document, op = marked.document, marked.op
    before = op.Path
    document.openTransaction("Edit")
    op.Path = Path.Path(op.Path.Commands[:-3])
    document.commitTransaction()
    steps = list(document.UndoNames)
    document.recompute()
    assert outdated(document) == [] and document.UndoNames == steps
    document.undo()
    document.recompute()
    assert outdated(document) == [] and op.Path.toGCode() == before.toGCode()
    assert document.RedoNames == ["Edit"]
    document.redo()
    document.recompute()
    assert outdated(document) == [] and op.Path.Size == before.Size - 3 and document.UndoNames == steps


@pytest.mark.parametrize("what", ["tool", "stock"])
def test_mark_restored_by_redo_is_outdated_without_its_tool(small, zigzag_commands, what):
    """The tool is deleted after marking and before the undo, outside any transaction."""
    op = small.add("Zigzag", zigzag_commands)
    upkeep.watch()
    vkworkbench.mark(vkworkbench.analyze(small.document))
    gone = small.controller.Tool if what == "tool" else small.job.Stock
    small.document.removeObject(gone.Name)
    small.document.undo()
    assert not marks.is_marked(op)
    small.document.redo()
    assert marks.is_outdated(op)


STOCKS = {
    "box": lambda: Part.makeBox(60, 60, 20),
    "cylinder": lambda: Part.makeCylinder(30, 20, FreeCAD.Vector(30, 30, 0)),
    "tube": lambda: Part.makeCylinder(30, 20, FreeCAD.Vector(30, 30, 0)).cut(
        Part.makeCylinder(10, 20, FreeCAD.Vector(30, 30, 0))),
    "box with a pocket": lambda: Part.makeBox(60, 60, 20).cut(Part.makeBox(10, 10, 10, FreeCAD.Vector(20, 20, 10))),
    "box with its pocket elsewhere": lambda: Part.makeBox(60, 60, 20).cut(
        Part.makeBox(10, 10, 10, FreeCAD.Vector(30, 20, 10))),
    "open": lambda: Part.makeBox(60, 60, 20).Shells[0],
}  # fmt: skip


def test_stock_of_another_form_in_the_same_box_outdates_marks(marked):
    document, found = marked.document, {}
    solid = document.addObject("Part::Feature", "Solid")
    marked.job.Stock = solid
    for name, make in STOCKS.items():
        solid.Shape = make()
        document.recompute()
        assert "Zigzag" in outdated(document), name
        vkworkbench.mark(vkworkbench.analyze(document))
        assert outdated(document) == []
        found[name] = marks.read(marked.op).fingerprint
        solid.Shape.tessellate(0.5)
        watcher.check(document)
        assert outdated(document) == [], name
    assert len(set(found.values())) == len(STOCKS)
    for name in ("box", "cylinder", "tube"):
        solid.Shape = STOCKS[name]()
        vkworkbench.mark(vkworkbench.analyze(document))
        # Analysing an equal shape again gives the fingerprint of the first analysis.
        assert marks.read(marked.op).fingerprint == found[name]


def test_new_shape_does_not_get_results_of_a_deleted_one(marked):
    """A new shape at the memory address of a deleted shape does not get the results of the deleted shape."""
    solid = marked.document.addObject("Part::Feature", "Solid")
    marked.job.Stock = solid
    seen = set()
    for number in range(60):
        solid.Shape = (STOCKS["cylinder"] if number % 2 else STOCKS["box"])()
        vkworkbench.mark(vkworkbench.analyze(marked.op))
        seen.add((number % 2, marks.read(marked.op).fingerprint))
        solid.Shape = Part.Shape()
    assert len(seen) == 2
