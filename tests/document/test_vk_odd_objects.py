# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Objects whose properties have another type than in FreeCAD, as in damaged files and files of other add-ons.

An odd object does not prevent the analysis of the other operations.
"""

from __future__ import annotations

import FreeCAD
import Path
import pytest

import vkworkbench
from vkworkbench.document.marks import marks, watcher

VALUES = {
    "App::PropertyString": "10 mm/s", "App::PropertyStringList": ["a", "b"], "App::PropertyBool": True,
    "App::PropertyInteger": -3, "App::PropertyFloat": float("nan"), "App::PropertyFloatList": [1.0, 2.0],
    "App::PropertyVector": FreeCAD.Vector(1, 2, 3), "App::PropertyPythonObject": {"a": [None]}, "App::PropertyLinkList": None,
    "App::PropertyLink": None, "App::PropertyMap": {"a": "b"},
}  # fmt: skip


class Odd:
    """Add a property of the given type and value to an object."""

    def __init__(self, obj, name, type_id, value):
        obj.addProperty(type_id, name, "Odd")
        if value is not None:
            setattr(obj, name, value)


def bare(small, name, type_name="Path::FeaturePython"):
    return small.document.addObject(type_name, name)


def operation(small, commands, controller, label="Odd"):
    """Return an operation with the given object as its tool controller."""
    op = small.add(label, commands, controller=None)
    op.ToolController = controller
    return op


def odd_rows(small, ops):
    """Analyse, mark, check and clear a sound and odd operations; return the rows of the odd operations."""
    report = vkworkbench.analyze(small.document)
    rows = {row.name: row for row in report.operations}
    (sound,) = (row for row in rows.values() if row.label == "Sound")
    assert sound.strategy == "zigzag" and sound.error is None
    vkworkbench.mark(report)
    watcher.check(small.document)
    assert not any(map(marks.is_outdated, ops))
    vkworkbench.clear(small.document)
    str(report)
    found = [rows[op.Name] for op in ops]
    for row in found:
        assert row.strategy == "zigzag" and "Please report" not in (row.error or ""), (row.label, row.error)
    return found


def test_comment_operation_needs_no_toolpath_remark(sound):
    """An operation that consists of a comment is complete; only an empty path has the remark "no-toolpath"."""
    comment = bare(sound, "Comment")
    comment.Path = Path.Path([Path.Command("(flip the part)")])
    sound.job.Operations.Group += [comment]
    rows = {row.name: row for row in vkworkbench.analyze(sound.job).operations}
    assert rows["Comment"].remarks == ()
    comment.Path = Path.Path()
    rows = {row.name: row for row in vkworkbench.analyze(sound.job).operations}
    assert [remark.code for remark in rows["Comment"].remarks] == ["no-toolpath"]


@pytest.fixture
def sound(small, zigzag_commands):
    small.add("Sound", zigzag_commands)
    return small


@pytest.mark.parametrize("name", ["Diameter", "ShapeName", "ShapeType", "CornerRadius", "TipAngle", "CuttingEdgeAngle"])
def test_odd_tool_property_affects_one_operation_only(sound, zigzag_commands, name):
    ops = []
    for type_id, value in VALUES.items():
        tool, controller = bare(sound, "Tool", "App::FeaturePython"), bare(sound, "Controller")
        Odd(tool, name, type_id, value)
        if name != "Diameter":
            tool.addProperty("App::PropertyLength", "Diameter").Diameter = 5
        controller.addProperty("App::PropertyLink", "Tool").Tool = tool
        for number in ("ToolNumber", "SpindleSpeed"):
            controller.addProperty("App::PropertyInteger", number)
        ops.append(operation(sound, zigzag_commands, controller, type_id))
    odd_rows(sound, ops)


@pytest.mark.parametrize("name", ["Tool", "HorizRapid", "VertRapid"])
def test_odd_tool_controller_has_an_error(sound, zigzag_commands, name):
    ops = []
    for type_id, value in VALUES.items():
        controller = bare(sound, "Controller")
        Odd(controller, name, type_id, value)
        ops.append(operation(sound, zigzag_commands, controller, type_id))
    for row in odd_rows(sound, ops):
        assert "no tool." in row.error or "no diameter" in row.error, row.label
        assert row.machining.left_out


@pytest.mark.parametrize("speed", [float("nan"), float("inf"), -5.0])
def test_invalid_rapid_speeds_are_ignored(sound, zigzag_commands, speed):
    controller = bare(sound, "Controller")
    controller.addProperty("App::PropertyLink", "Tool").Tool = sound.controller.Tool
    for name in ("HorizRapid", "VertRapid"):
        controller.addProperty("App::PropertyFloat", name)
        setattr(controller, name, speed)
    (row,) = odd_rows(sound, [operation(sound, zigzag_commands, controller)])
    assert row.error is None and row.machining.rapid_seconds is None


@pytest.mark.parametrize("name", ["ToolController", "Active", "Base", "Copies", "Gcode", "Group"])
def test_odd_operation_property_is_tolerated(sound, name):
    ops = []
    for type_id, value in VALUES.items():
        op = bare(sound, "Op")
        op.Label, op.Path = type_id, sound.document.getObject("Op").Path
        Odd(op, name, type_id, value)
        ops.append(op)
    sound.job.Operations.Group += ops
    sound.document.recompute()
    odd_rows(sound, ops)


@pytest.mark.parametrize("name", ["Operations", "Tools", "Stock", "Shape", "Model"])
def test_odd_job_property_is_tolerated(sound, zigzag_commands, name):
    ops = []
    for type_id, value in VALUES.items():
        job, stock = bare(sound, "OddJob"), bare(sound, "OddStock", "App::FeaturePython")
        group = sound.document.addObject("App::DocumentObjectGroup", "Group")
        ops.append(operation(sound, zigzag_commands, sound.controller, type_id))
        sound.job.Operations.Group = [sound.document.getObject("Op")]
        group.Group = [ops[-1]]
        for known, linked in (("Operations", group), ("Tools", group), ("Stock", stock)):
            if known != name:
                job.addProperty("App::PropertyLink", known)
                setattr(job, known, linked)
        Odd(stock if name == "Shape" else job, name, type_id, value)
    odd_rows(sound, ops)


def test_error_while_reading_affects_one_operation_only(sound, zigzag_commands, monkeypatch):
    """An unexpected error is a remark in the row of the operation."""
    from vkworkbench.document.job import reading

    sound.add("Odd", zigzag_commands)
    read = reading.rapid_feeds
    monkeypatch.setattr(reading, "rapid_feeds", lambda obj: read(obj) if obj.Label == "Sound" else 1 / 0)
    first, second = vkworkbench.analyze(sound.document).operations
    assert (first.label, first.error) == ("Sound", None)
    assert (
        second.label == "Odd"
        and "ZeroDivisionError" in second.error
        and second.recognition.strategy == "unknown"
        and second.confidence == 0
    )


@pytest.mark.parametrize("what", ["x", 5, b"x", ["x"], [None], [[5]], 1.5, object()])
def test_argument_that_is_not_a_document_is_refused(small, what):
    with pytest.raises(TypeError, match="only a document, a job or operations"):
        vkworkbench.clear(what)
    if not isinstance(what, str) and what != ["x"]:  # `analyze` reads texts as file names
        with pytest.raises(TypeError, match="only a document, a job or operations"):
            vkworkbench.analyze(what)


@pytest.mark.parametrize("do", ["analyze", "clear", "simulate"])
def test_deleted_object_is_refused_with_a_sentence(small, zigzag_commands, do):
    do = getattr(vkworkbench, do)
    deleted, op = small.add("Deleted", zigzag_commands), small.add("Zigzag", zigzag_commands)
    small.document.openTransaction("Delete")
    small.document.removeObject(deleted.Name)
    small.document.commitTransaction()
    for what in (deleted, [op, deleted]):
        with pytest.raises(ReferenceError, match="was deleted, or its document closed"):
            do(what)
    document, job = small.document, small.job
    FreeCAD.closeDocument(document.Name)
    for what in (document, job, op, [op]):
        with pytest.raises(ReferenceError, match="was deleted, or its document closed"):
            do(what)


@pytest.mark.parametrize("what", [None, "x", 5, []])
def test_mark_refuses_anything_but_a_report(small, what):
    with pytest.raises(TypeError, match="report is the Report that analyze returns"):
        vkworkbench.mark(what)


def test_clear_accepts_an_iterator_or_nested_list(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert vkworkbench.clear(iter([op])) == 2 and not marks.is_marked(op) and not marks.is_marked(small.job)
    vkworkbench.mark(vkworkbench.analyze([[op]]))
    assert vkworkbench.clear([[op]]) == 2


def test_rotary_axis_that_cuts_is_not_recognised(small):
    commands = [
        ("G0", {"X": 5.0, "Y": 5.0, "Z": 30.0}),
        ("G1", {"Z": 15.0, "F": 5.0}),
        ("G1", {"A": 360.0}),
        ("G0", {"Z": 30.0}),
    ]
    small.add("Turned", commands)
    (row,) = vkworkbench.analyze(small.document).operations
    assert row.strategy == "unknown" and "A rotary axis (A) turns while the tool cuts" in row.error
    assert "rotary axis" in row.reason


class AnalyzesWhileReading:
    """An observer that calls analyze, simulate and clear whenever FreeCAD creates an object while reading a file."""

    def __init__(self):
        self.answers = []

    def slotCreatedObject(self, obj):
        if obj.Document.Restoring:
            for work in (vkworkbench.analyze, vkworkbench.simulate, vkworkbench.clear):
                with pytest.raises(ValueError) as refused:
                    work(obj.Document)
                self.answers.append(str(refused.value))


def test_document_is_refused_while_freecad_reads_it(small, zigzag_commands, tmp_path):
    small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    small.document.saveCopy(str(tmp_path / "read.FCStd"))
    observer = AnalyzesWhileReading()
    FreeCAD.addDocumentObserver(observer)
    try:
        document = FreeCAD.openDocument(str(tmp_path / "read.FCStd"))
    finally:
        FreeCAD.removeDocumentObserver(observer)
    assert observer.answers and all("still reading" in answer for answer in observer.answers)
    (row,) = vkworkbench.analyze(document).operations
    assert row.strategy == "zigzag"
    FreeCAD.closeDocument(document.Name)
