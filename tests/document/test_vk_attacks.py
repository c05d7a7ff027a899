# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents that only damaged files or macros can make: link loops, odd objects, damaged marks, invalid numbers."""

from __future__ import annotations

import json
import math
import sys
from contextlib import suppress
from itertools import product

import FreeCAD
import Part
import Path as CAM
import pytest
from cases import first_everywhere

import vkworkbench
from vkworkbench import preferences
from vkworkbench.document import upkeep
from vkworkbench.document.job.operations import find
from vkworkbench.document.marks import marks, watcher


def rows(what):
    """
    Analyse, mark, check and clear a document; return {label: row}.

    Assert that the document is unchanged afterwards.
    """
    document = what.Document if hasattr(what, "Document") else what
    before = {obj.Name: (obj.Label, obj.Label2, obj.PropertiesList) for obj in document.Objects}
    report = vkworkbench.analyze(what)
    str(report)
    json.dumps([row.as_dict() for row in report.operations])
    for row in report.operations:
        assert "Please report" not in (row.error or ""), row.error
    vkworkbench.mark(report)
    watcher.check(document)
    assert [obj.Label for obj in document.Objects if marks.is_outdated(obj)] == []
    vkworkbench.clear(document)
    assert {obj.Name: (obj.Label, obj.Label2, obj.PropertiesList) for obj in document.Objects} == before
    return {row.label: row for row in report.operations}


def dressed(op, bases, type_id="App::PropertyLink"):
    op.addProperty(type_id, "Base", "Path")
    op.Base = bases
    return op


# Tests of link loops, links and odd objects


@pytest.mark.parametrize("length", first_everywhere([1, 7]))
@pytest.mark.parametrize("type_id", ["App::PropertyLink", "App::PropertyLinkList", "App::PropertyLinkGlobal"])
@pytest.mark.parametrize("arrays", [False, True])
def test_loop_of_dress_ups_is_analyzed(small, zigzag_commands, length, type_id, arrays):
    ops = [small.add(f"Op {number}", zigzag_commands, controller=None) for number in range(length)]
    for op, base in zip(ops, [*ops[1:], ops[0]]):
        with suppress(ValueError, RuntimeError):  # some versions of FreeCAD refuse a link from an object to itself
            dressed(op, [base] if "List" in type_id else base, type_id)
        if arrays:
            op.addProperty("App::PropertyInteger", "Copies").Copies = 2
    found = rows(small.document)
    assert set(found) == {op.Label for op in ops}
    assert all("no tool" in row.error for row in found.values())
    assert [found[op.Label].called for op in ops] == [None] * length


def test_dress_up_is_analyzed_after_its_base_is_deleted(small, zigzag_commands):
    base, top = small.add("Base", zigzag_commands), small.add("Top", zigzag_commands, controller=None)
    dressed(top, base)
    small.document.openTransaction("Delete")
    small.document.removeObject(base.Name)
    small.document.commitTransaction()
    assert "no tool" in rows(small.document)["Top"].error
    for _ in range(3):  # undo clearing the mark, marking the operation, and deleting the base
        small.document.undo()
    assert rows(small.document)["Top"].error is None


def test_job_in_its_own_list_of_operations_is_analyzed(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    group = small.document.addObject("App::DocumentObjectGroup", "Folder")
    small.job.Operations.Group = [group]
    group.Group = [op, small.job]
    for what in (small.document, small.job, small.job.Operations):
        assert [o.object.Name for o in find(what)] == [op.Name]
    assert rows(small.document)["Zigzag"].strategy == "zigzag"


def test_job_that_is_its_own_group_is_analyzed(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    with suppress(ValueError, RuntimeError):
        small.job.Operations = small.job
    assert rows(small.document)["Zigzag"].strategy == "zigzag"
    assert marks.read(op) is None


@pytest.mark.parametrize("container", ["App::Part", "App::DocumentObjectGroup", "App::LinkGroup", "PartDesign::Body"])
def test_operation_in_a_container_is_analyzed(small, zigzag_commands, container):
    op = small.add("Zigzag", zigzag_commands)
    holder = small.document.addObject(container, "Holder")
    small.document.recompute()
    with suppress(TypeError, ValueError, RuntimeError):  # raised by a container that accepts no toolpath, as a body
        if container == "App::LinkGroup":
            holder.ElementList = [op, small.job]
        else:
            holder.addObject(op)
            holder.addObject(small.job)
    found = rows(small.document)
    assert list(found) == ["Zigzag"] and found["Zigzag"].strategy == "zigzag"


def test_links_to_operations_and_jobs_are_skipped(small, zigzag_commands):
    """`analyze` skips links, within one document and from another document."""
    op = small.add("Zigzag", zigzag_commands)
    other = FreeCAD.newDocument("Linking")
    try:
        for document, target in ((small.document, op), (small.document, small.job), (other, op), (other, small.job)):
            with suppress(RuntimeError, ValueError):  # FreeCAD links only to documents with a file
                document.addObject("App::Link", "Link").LinkedObject = target
        assert list(rows(small.document)) == ["Zigzag"]
        assert rows(other) == {}
        link = next(obj for obj in small.document.Objects if obj.TypeId == "App::Link")
        with suppress(TypeError):
            assert [o.object.Name for o in find(link)] in ([], [op.Name])
    finally:
        FreeCAD.closeDocument(other.Name)


def test_partly_loaded_document_can_be_marked(small, zigzag_commands, tmp_path):
    """FreeCAD loads only the needed objects of a linked file, so an operation may not have a path yet."""
    op = small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    first, second = str(tmp_path / "first.FCStd"), str(tmp_path / "second.FCStd")
    small.document.saveAs(first)
    other = FreeCAD.newDocument("Linking")
    other.saveAs(second)
    other.addObject("App::Link", "Link").LinkedObject = op
    other.save()
    for name in (other.Name, small.document.Name):
        FreeCAD.closeDocument(name)
    opened = FreeCAD.openDocument(second)
    try:
        for document in list(FreeCAD.listDocuments().values()):
            vkworkbench.mark(vkworkbench.analyze(document))
            watcher.check(document)
            assert [obj.Label for obj in document.Objects if marks.is_outdated(obj)] == []
            vkworkbench.clear(document)
        assert rows(opened) == {}
    finally:
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)


def test_job_deleted_during_the_analysis_is_tolerated(small, zigzag_commands):
    """Operations that remain without the job have rows without a job."""
    names = [small.add(label, zigzag_commands).Name for label in ("One", "Two", "Three")]

    def delete(done, *_):
        if done == 1:
            small.job.Operations.Group = []
            small.job.Proxy = None  # with its proxy, FreeCAD would delete the operations together with the job
            small.document.removeObject(small.job.Name)

    report = vkworkbench.analyze(small.document, progress=delete)
    assert [row.label for row in report.operations if row.job] == ["One"]
    without = [row for row in report.operations if not row.job]
    assert {row.name for row in without} <= set(names) and all("no stock" in row.error for row in without)
    str(report)
    vkworkbench.mark(report)


def test_job_without_tools_and_stock_is_analyzed(small):
    """The job has no tools, operations, stock or model."""
    for name in ("Tools", "Stock", "Model", "Operations"):
        with suppress(ValueError, RuntimeError):
            setattr(small.job, name, None)
    assert rows(small.document) == {}
    assert rows(small.job) == {} and vkworkbench.mark(vkworkbench.analyze(small.job)) == 0


# Tests of odd paths, placements, tools and stocks.

ODD = [float("nan"), float("inf"), -float("inf"), 1e300, -1e300, 1e-300]
PATHS = {
    "none": [], "one rapid": [("G0", {"X": 1.0})], "one cut": [("G1", {"X": 1.0, "F": 1.0})],
    "two points": [("G0", {"Z": 15.0}), ("G1", {"X": 30.0, "F": 1.0})], "only comments": [("(a comment)", {}), ("(b)", {})],
    "a comment of 10,000 letters": [(f"({'x' * 10_000})", {}), ("G1", {"X": 5.0})],
    "marks in a comment": [("(⟦zigzag 98%⟧ <b>\u202e)", {}), ("G1", {"X": 5.0})],
    "no name": [("", {"X": 1.0})], "the same point": [("G1", {"X": 1.0, "Y": 1.0, "Z": 1.0})] * 50,
    "unknown": [("T1", {}), ("M6", {}), ("O1000", {}), ("%", {}), ("G999.9", {"X": 1.0})],
    "arcs without a center": [("G1", {"X": 5.0}), ("G2", {"X": 1.0}), ("G3", {"I": 0.0, "J": 0.0})],
    "a drill without depth": [("G81", {"X": 1.0, "R": 3.0}), ("G80", {})],
    **{f"{value} in {word}": [("G0", {"Z": 30.0}), ("G1", {"X": 5.0, "F": 5.0}), ("G1", {word: value}), ("G1", {"X": 9.0})]
       for value in ODD for word in "XZF"},
    **{f"an arc of {value}": [("G0", {"Z": 9.0}), ("G2", {"X": 5.0, "I": value, "J": 1.0})] for value in ODD},
}  # fmt: skip


def test_odd_path_does_not_affect_the_other_operation(small, zigzag_commands):
    for name, commands in PATHS.items():
        op = small.add(name, [])
        with suppress(TypeError, ValueError):  # if FreeCAD refuses the odd path, the operation keeps its empty path
            op.Path = CAM.Path([CAM.Command(*command) for command in commands])
    small.add("Sound", zigzag_commands)
    found = rows(small.document)
    assert found["Sound"].strategy == "zigzag" and found["Sound"].error is None
    for name in PATHS:
        row = found[name]
        assert row.trajectories >= 0 and math.isfinite(row.length), name
        assert row.machining_seconds is None or math.isfinite(row.machining_seconds), name


@pytest.mark.parametrize("placement", [(float("nan"), 0, 0), (1e300, 0, 0), (0, 0, float("inf")), (1e9, 1e9, 1e9)])
def test_placement_too_far_away_is_an_error(small, zigzag_commands, placement):
    op = small.add("Odd", zigzag_commands)
    op.Placement.Base = FreeCAD.Vector(*placement)
    small.add("Sound", zigzag_commands)
    small.document.recompute()
    found = rows(small.document)
    assert found["Sound"].error is None and "within a kilometer" in found["Odd"].error


def test_too_many_moves_are_an_error(small, zigzag_commands, monkeypatch):
    monkeypatch.setattr(sys.modules["vkworkbench.core.gcode.moves.linearize"], "MOST_TRAJECTORIES", 100)
    small.add(
        "Arcs", [("G0", {"X": 0.0, "Y": 0.0, "Z": 9.0}), ("G2", {"X": 0.0, "Y": 0.0, "I": 50.0, "J": 0.0, "Z": 0.0})]
    )
    small.add("Sound", zigzag_commands)
    found = rows(small.document)
    assert "Choose a larger tolerance" in found["Arcs"].error and found["Sound"].error is None


@pytest.mark.parametrize("diameter", [1e300, 1e-300, 1e6, -5, float("nan"), float("inf")])
def test_odd_tool_has_an_error_or_a_cost_in_every_view(small, zigzag_commands, diameter):
    small.add("Odd", zigzag_commands)
    tool = small.document.addObject("App::FeaturePython", "Tool")
    tool.addProperty("App::PropertyFloat", "Diameter").Diameter = diameter
    small.controller.Tool = tool
    group = FreeCAD.ParamGet(preferences.GROUP)
    try:
        for view in ("Front", "Top", "Isometric", "Right", "Bottom"):
            group.SetString(preferences.entry("view_direction"), view)
            row = rows(small.document)["Odd"]
            assert row.error or row.cost("z-buffer")[0] > 0
    finally:
        group.Clear()


@pytest.mark.parametrize("view", first_everywhere(["Front", "Isometric", "Top"]))
@pytest.mark.parametrize("above", [-0.001, 1.0])
def test_tool_much_wider_than_the_stock_has_a_remark(small, zigzag_commands, view, above):
    """The tool is much wider than the stock, so only moves above the stock do not touch the stock."""
    small.add("Wide", zigzag_commands)
    small.controller.Tool.Diameter = 1e6
    stock = small.document.addObject("Part::Box", "Tiny")
    stock.Length = stock.Width = 0.01
    stock.Placement.Base = FreeCAD.Vector(30, 20, 15 - above - stock.Height.Value)
    small.document.recompute()
    small.job.Stock = stock
    group = FreeCAD.ParamGet(preferences.GROUP)
    try:
        group.SetString(preferences.entry("view_direction"), view)
        error = rows(small.document)["Wide"].error
    finally:
        group.Clear()
    assert ("does not touch the stock" in error) is (above > 0)
    assert ("tool is wider than the stock" in error) is (above < 0)


@pytest.mark.parametrize("make", [
    lambda: Part.makeBox(1e-5, 1e-5, 1e-5), lambda: Part.makeBox(1e5, 1e-3, 1e-3), lambda: Part.makeBox(1e7, 1e7, 1e7),
    lambda: Part.makeCompound([]), lambda: Part.makeCompound([Part.makeBox(60, 40, 20), Part.makeLine((0, 0, 0), (99, 0, 0))]),
    lambda: Part.makeBox(60, 40, 20).reversed(), lambda: Part.makeHelix(1, 9, 9), lambda: Part.Vertex(1, 2, 3),
], ids=["tiny", "needle", "huge", "empty", "with a wire", "inside out", "helix", "vertex"])  # fmt: skip
def test_operation_with_an_odd_stock_is_recognised(small, zigzag_commands, make):
    small.add("Zigzag", zigzag_commands)
    stock = small.document.addObject("Part::Feature", "Odd")
    stock.Shape = make()
    small.job.Stock = stock
    assert rows(small.document)["Zigzag"].strategy == "zigzag"


# Tests of odd labels and descriptions.

TEXTS = ["<script>alert(1)</script>", "\x01\x02\x1b[31m", "\u202eabc\u2066def\u2069", "x" * 10_000, "a\0b", "{}{0}%n",
         "⟦⟧", "⟦1 operation⟧⟦zigzag⟧", "\u0085\u2028\u2029", "\u202e\u2066\u2067", "=HYPERLINK(1)", " \t\n ", "ﷺ" * 200, "Ｚｉｇｚａｇ"]  # fmt: skip


def test_odd_labels_do_not_change_the_result(small, zigzag_commands, tmp_path):
    small.add("Zigzag", zigzag_commands)
    sound, tool = rows(small.document)["Zigzag"], small.controller.Tool
    for text in TEXTS:
        for obj in (small.job, small.controller, tool, small.job.Stock, small.job.Operations):
            with suppress(UnicodeEncodeError, ValueError, TypeError):
                obj.Label = text
                obj.Label2 = text
        report = vkworkbench.analyze(small.document)
        report.to_csv(tmp_path / "r.csv")
        report.to_json(tmp_path / "r.json")
        row = rows(small.document)["Zigzag"]
        assert (row.strategy, row.error, row.fingerprint) == (sound.strategy, None, sound.fingerprint), text
        small.controller.Tool = None
        assert "no tool" in rows(small.document)["Zigzag"].error, text
        small.controller.Tool = tool


def test_operations_with_equal_labels_have_separate_marks(small, zigzag_commands):
    """A preference of FreeCAD allows several objects with the same label."""
    group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Document")
    group.SetBool("DuplicateLabels", True)
    try:
        ops = [small.add("Same", zigzag_commands) for _ in range(3)]
        assert {op.Label for op in ops} == {"Same"}
        small.job.Label = "Same"
        report = vkworkbench.analyze(small.document)
        assert [row.label for row in report.operations] == ["Same"] * 3 and len(
            {r.name for r in report.operations}
        ) == 3
        assert vkworkbench.mark(report) == 3 and all(op.Label2 for op in ops)
        assert report.totals[0].operations == 3
        str(report)
    finally:
        group.RemBool("DuplicateLabels")


# Tests of damaged marks in the tree.

DAMAGES = [
    "", "null", "[]", "{}", '"x"', "1e999", "[" * 5000, '{"format": 99}', '{"text": [], "own": {}, "shown": 5}',
    '{"text": "x", "own": [[]], "shown": [null, {}, "Strategy"]}', "\x00", "NaN",
]  # fmt: skip


def test_damaged_mark_is_replaced_and_cleared(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    op.Label2 = "own ⟦words⟧"
    for damage, obj in product(DAMAGES, (op, small.job)):
        vkworkbench.mark(vkworkbench.analyze(small.document))
        whole = op.Label2
        with suppress(ValueError):
            obj.VkWorkbenchMark = damage
        watcher.check(small.document)
        vkworkbench.mark(vkworkbench.analyze(small.document))
        assert op.Label2 == whole, (damage, obj.Name)
        with suppress(ValueError):
            obj.VkWorkbenchMark = damage
        vkworkbench.clear(small.document)
        assert op.Label2 == "own ⟦words⟧" and small.job.Label2 == "", (damage, obj.Name)
        assert not any(marks.is_marked(one) for one in small.document.Objects), (damage, obj.Name)


DAMAGED_ENTRIES = [
    ("operations", 1e300), ("operations", -1), ("confidence", "NaN"), ("confidence", 1e308), ("length", {}), ("costs", []),
    ("costs", {"legacy": None}), ("costs", {"z-buffer": {"seconds": 1e300, "memory_bytes": "x"}}), ("strategy", 5),
    ("reason", "x"), ("reason", [{"code": "nowhere"}]), ("remarks", [[["x"]]]), ("cautions", [{"code": 1}]), ("fingerprint", None),
    ("remarks", [{"code": "not-analysed", "arguments": {"error": "\ud83d"}}]), ("text", "\udc00"), ("own", ["\udc00"]),
    ("outdated", "no"), ("called", {"a": 1}), ("trajectories", True), ("machining", "1"), ("text", 5), ("own", 7),
]  # fmt: skip


def test_mark_with_a_damaged_entry_is_replaced_and_cleared(small, zigzag_commands):
    """Marking replaces unreadable marks, and clearing removes them."""
    op = small.add("Zigzag", zigzag_commands)
    for name, value in DAMAGED_ENTRIES:
        vkworkbench.mark(vkworkbench.analyze(small.document))
        whole = op.Label2, small.job.Label2
        for obj in (op, small.job):
            obj.VkWorkbenchMark = json.dumps({**json.loads(obj.VkWorkbenchMark), name: value})
        watcher.check(small.document)
        op.Path = CAM.Path(op.Path.Commands[:-1])
        small.document.recompute()
        upkeep.follow_preferences()
        op.Path = CAM.Path([CAM.Command(*command) for command in zigzag_commands])
        vkworkbench.mark(vkworkbench.analyze(small.document))
        assert (op.Label2, small.job.Label2) == whole, (name, value)
        vkworkbench.clear(small.document)
        assert (op.Label2, small.job.Label2) == ("", ""), (name, value)


RETYPED = ["App::PropertyLinkSub", "App::PropertyEnumeration", "App::PropertyColor", "App::PropertyMaterialList", "App::PropertyFile",
           "App::PropertyUUID", "App::PropertyBoolList", "App::PropertyPlacement", "App::PropertyFloatConstraint"]  # fmt: skip


@pytest.mark.parametrize("type_id", first_everywhere(RETYPED))
def test_mark_properties_of_other_types_are_replaced(small, zigzag_commands, type_id):
    op = small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    for name in ("VkWorkbenchMark", "Strategy", "Confidence", "MachiningTime", "SimulationTime", "Remarks"):
        for obj in (op, small.job):
            if hasattr(obj, name):
                obj.removeProperty(name)
            with suppress(TypeError, RuntimeError, NameError, ValueError):
                obj.addProperty(type_id, name, "Toolpath analysis")
                obj.setPropertyStatus(name, ["LockDynamic", "Immutable"])
    watcher.check(small.document)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert op.Strategy == "zigzag" and op.Label2.startswith("⟦zigzag ")
    watcher.check(small.document)
    vkworkbench.clear(small.document)
    assert op.Label2 == "" and not marks.is_marked(op)


def test_expressions_on_mark_properties_are_tolerated(small, zigzag_commands):
    """An expression can read a property of a mark; marking overwrites a property that an expression sets."""
    op = small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    block = small.document.getObject("Block")
    block.setExpression("Length", f"60 + 0 * {op.Name}.CuttingLength")
    small.document.recompute()
    op.setExpression("CuttingLength", "5 mm")
    small.document.recompute()
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert op.CuttingLength.Value > 100 and block.Length.Value == 60
    vkworkbench.clear(small.document)
    assert not marks.is_marked(op)
