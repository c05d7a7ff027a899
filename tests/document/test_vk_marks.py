# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks in the tree. Marking an operation causes no recompute and changes neither the G-code nor the user's text."""

import json
import os
import subprocess
from dataclasses import replace
from functools import partial
from itertools import product

import FreeCAD
import Path
import pytest
from posting import posted

import vkworkbench
from vkworkbench import freecad, preferences
from vkworkbench.core import Strategy
from vkworkbench.core.simulators import Caution
from vkworkbench.document.job import fingerprint
from vkworkbench.document.marks import marking, marks, watcher
from vkworkbench.document.marks import properties as mark_properties
from vkworkbench.document.marks import text as mark_text
from vkworkbench.language import ENGLISH, Message

refresh = partial(marks.refresh, path_changed=True, setting_changed=True)


def marked(document):
    return [obj for obj in document.Objects if marks.is_marked(obj)]


def test_mark_contains_the_results_of_the_analysis(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    report = vkworkbench.analyze(small.document)
    assert vkworkbench.mark(report) == 1
    (o,) = report.operations
    cost, own = o.costs[freecad.own_simulator()], marks.read(op)
    time = ENGLISH.estimated_time(cost.seconds, cost.factor)
    assert op.Label2 == f"⟦zigzag · ≥ {ENGLISH.clock(o.machining_seconds)} · sim {time}⟧"
    assert (op.Strategy, op.Confidence, op.Reason, op.Remarks) == ("zigzag", round(100 * o.confidence), o.reason, "")
    assert op.CuttingLength.getValueAs("mm") == pytest.approx(o.length)
    if freecad.version() >= (1, 0):
        assert op.SimulationTime.getValueAs("s") == pytest.approx(cost.seconds)
        assert op.MachiningTime.getValueAs("s") == pytest.approx(o.machining.seconds)
    else:
        assert (op.SimulationTime, op.MachiningTime) == (ENGLISH.time(cost.seconds), ENGLISH.time(o.machining.seconds))
    assert {op.getGroupOfProperty(name) for name in mark_properties.ours(op)} == {"Toolpath analysis"}
    assert set(op.getEditorMode("Strategy")) == {"ReadOnly"}
    assert set(op.getEditorMode("VkWorkbenchMark")) == {"ReadOnly", "Hidden"} and "Touched" not in op.State
    assert (own.strategy, own.trajectories, own.fingerprint) == (o.strategy, o.trajectories, o.fingerprint)
    assert own.costs["legacy"].seconds == o.costs["legacy"].seconds
    assert small.job.Label2.startswith(f"⟦1 operation · ≥ {ENGLISH.clock(o.machining_seconds)} · sim ") and not hasattr(
        small.job, "Strategy"
    )
    assert small.job.CuttingLength.getValueAs("mm") == pytest.approx(o.length)


def test_low_confidence_is_shown_in_the_mark(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    report = vkworkbench.analyze(small.document)
    (o,) = report.operations
    for confidence, expected in ((0.79, "zigzag 79% · "), (0.81, "zigzag · ")):
        unsure = replace(o, recognition=replace(o.recognition, confidence=confidence))
        vkworkbench.mark(replace(report, operations=(unsure,)))
        assert op.Label2.startswith(f"⟦{expected}")


def told(op):
    return marks.read(op).reason, marks.read(op).remarks


@pytest.mark.parametrize("label", ["T; U", "{label} {}", "a: b, c", '⟦x⟧ 50% "q" \\', "Ж 🙂"])
def test_mark_stores_reason_and_remarks_as_codes(small, zigzag_commands, label):
    op = small.add("Zigzag", [*zigzag_commands, ("G123", {"X": 5.0})])
    small.controller.Label, small.controller.Tool.Diameter = label, 0
    report = vkworkbench.analyze(small.document)
    vkworkbench.mark(report)
    (o,) = report.operations
    assert told(op) == ((o.recognition.why,), o.remarks)
    assert op.Remarks.startswith(o.error) and small.controller.Label in op.Remarks
    assert "⚠" in op.Label2 and op.Label2.count("⟦") == op.Label2.count("⟧") == 1
    assert marks.read(small.job).remarks == (Message("cost-unknown", labels=["Zigzag"]),)
    assert small.job.Remarks == "The simulation cost of Zigzag is unknown." and marks.read(small.job).reason == ()


def test_remarks_of_a_mark_are_kept_in_a_file(small, zigzag_commands, tmp_path):
    op = small.add("Zigzag", zigzag_commands, controller=None)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    before = marks.read(op)
    assert before.remarks == (Message("no-tool"),)
    small.document.saveAs(str(tmp_path / "small.FCStd"))
    FreeCAD.closeDocument(small.name)
    document = FreeCAD.openDocument(str(tmp_path / "small.FCStd"))
    (op,) = document.getObjectsByLabel("Zigzag")
    assert marks.read(op) == before
    FreeCAD.closeDocument(document.Name)


DAMAGED = [
    "", "{", "null", "[]", "5", "NaN", '"x"', "{}", '{"shown": 5}', '{"shown": [[]]}', '{"strategy": "sculpting"}',
    '{"reason": ' + 100_000 * "[" + 100_000 * "]" + "}",
    '{"reason": ' + 500 * '[{"code": "of", "arguments": {"label": ' + '"x"' + 500 * "}}]" + "}",
]  # fmt: skip
CHANGES = {
    "strategy": ["sculpting", 5, [], {}], "confidence": [-1, "x", None, 10**400, "NaN"], "reason": [5, [None], [{"code": "x"}]],
    "remarks": [[{"code": "nobody-knows", "arguments": {}}], [{"code": "image", "arguments": {}}], None],
    "cautions": [[5], [{"code": 1, "what": None, "command": "x"}]], "operations": [[], 1e999], "trajectories": ["many"],
    "costs": [5, {"legacy": {}}, {"OpenGL": {"play_seconds": {}}}, {"legacy": None}], "length": [None, -5, "5"],
}  # fmt: skip


def test_damaged_mark_is_replaced(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    for written in (*DAMAGED, *((name, value) for name, values in CHANGES.items() for value in values)):
        vkworkbench.mark(vkworkbench.analyze(small.document))
        text, whole = op.Label2, json.loads(op.VkWorkbenchMark)
        op.VkWorkbenchMark = written if isinstance(written, str) else json.dumps({**whole, written[0]: written[1]})
        assert marks.read(op) is None and marks.is_marked(op) and not marks.is_outdated(op), written
        watcher.check(small.document)
        vkworkbench.mark(vkworkbench.analyze(small.document))
        assert op.Label2 == text and marks.read(op).reason[0].code == "rows", written
        op.VkWorkbenchMark = written if isinstance(written, str) else "{}"
        vkworkbench.clear(small.document)
        assert op.Label2 == "" and marked(small.document) == [], written


def test_deleted_or_retyped_property_is_created_again(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    before = sorted(op.PropertiesList)
    for name, kind in product(mark_properties._TYPES, (None, "Integer", "String", "Link", "StringList", "Bool")):
        vkworkbench.mark(vkworkbench.analyze(small.document))
        expected = {name: str(getattr(op, name)) for name in op.PropertiesList if name not in before}
        op.removeProperty(name)
        if kind:
            op.addProperty(f"App::Property{kind}", name, "" if name == mark_properties.MARK else "Toolpath analysis")
        watcher.check(small.document)
        marks.is_outdated(op), marks.is_marked(op), marks.words_of(op), marks.read(op)
        vkworkbench.mark(vkworkbench.analyze(small.document))
        found = {name: str(getattr(op, name)) for name in op.PropertiesList if name not in before}
        assert found == expected, (name, kind)
        assert set(op.getEditorMode("Strategy")) == {"ReadOnly"} and op.Label2.count("⟦") == 1, (name, kind)
        vkworkbench.clear(small.document)
        assert (sorted(op.PropertiesList), op.Label2) == (before, ""), (name, kind)


def test_property_of_the_operation_with_the_same_name_is_kept(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    op.addProperty("App::PropertyInteger", "Strategy", "Own")
    op.Strategy = 7
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert op.Strategy == 7 and op.Reason and marks.read(op).strategy is Strategy.ZIGZAG
    vkworkbench.clear(small.document)
    assert op.Strategy == 7 and not hasattr(op, "Reason")


def test_locked_properties_of_a_mark_are_unlocked(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    op.setPropertyStatus("Strategy", "LockDynamic")
    op.setPropertyStatus("Reason", "Immutable")
    op.setExpression("Remarks", "<<driven>>")
    op.setPropertyStatus("VkWorkbenchMark", "-Output")
    vkworkbench.mark(vkworkbench.analyze(small.document))
    small.document.recompute()
    assert op.Remarks == "" and "Output" in op.getTypeOfProperty("VkWorkbenchMark")
    vkworkbench.clear(small.document)
    assert marked(small.document) == []


@pytest.mark.parametrize("how", ["driven", "locked"])
def test_locked_or_driven_description_is_not_changed(small, zigzag_commands, how):
    op = small.add("Zigzag", zigzag_commands)
    op.Label2 = "mine"
    if how == "driven":
        op.setExpression("Label2", "<<mine>>")
    else:
        op.setPropertyStatus("Label2", "Immutable")
    vkworkbench.mark(vkworkbench.analyze(small.document))
    small.document.recompute()
    assert op.Label2 == "mine" and marks.read(op).strategy is Strategy.ZIGZAG and marks.words_of(op) == "mine"
    vkworkbench.clear(small.document)
    assert op.Label2 == "mine" and marked(small.document) == []


@pytest.mark.parametrize("other", [
    "⟦sculpting · ▶ 3 s⟧", "⟦sculpting · 1:18 · sim 3 s⟧", "⟦Zickzack 97 % · 5 s · 9 MB⟧", "⟦3D scallop 40%⟧", "⟦zigzag⟧", "⟦2 operations · 5 s⟧",
    "⟦empty · inactive: switch it on · outdated⟧",
])  # fmt: skip
def test_mark_text_of_another_version_is_replaced_and_cleared(small, zigzag_commands, other):
    op = small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(op))
    mine = op.Label2
    for beside in (other, f"{other} {mine}", f"{mine} {other}"):
        op.Label2 = f"a {beside} b"
        vkworkbench.mark(vkworkbench.analyze(op))
        assert op.Label2 == f"a {mine} b"
    op.Label2 = f"a {other} b"
    vkworkbench.clear(op)
    assert op.Label2 == "a b"


def test_mark_text_of_a_newer_version_is_replaced(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    op.addProperty("App::PropertyString", "ToolpathMark")
    op.ToolpathMark = json.dumps({"format": 9, "text": "whatever it says", "shown": ["Reason"], "more": {}})
    op.addProperty("App::PropertyFloat", "Reason")
    op.Label2 = "mine ⟦whatever it says⟧"
    assert marks.read(op) is None and marks.words_of(op) == "mine"
    vkworkbench.mark(vkworkbench.analyze(op))
    assert op.Label2.startswith("mine ⟦zigzag · ") and op.Label2.count("⟦") == 1 and isinstance(op.Reason, str)
    vkworkbench.clear(op)
    assert op.Label2 == "mine" and marked(small.document) == []


@pytest.mark.parametrize("type_id, value", [
    ("App::PropertyString", "my own words"), ("App::PropertyString", '{"text": 5}'), ("App::PropertyString", "[" * 2000),
    ("App::PropertyFloat", 1.5), ("App::PropertyStringList", ["a"]), ("App::PropertyBool", True),
])  # fmt: skip
def test_property_of_the_user_is_kept(small, zigzag_commands, type_id, value):
    """The user's property has the name under which an earlier version stored the mark."""
    op = small.add("Zigzag", zigzag_commands)
    for obj in (op, small.job):
        obj.addProperty(type_id, "ToolpathMark", "Mine").ToolpathMark = value
    assert marked(small.document) == [] and not marks.mark_properties.may_have_mark(op)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert marks.read(op).strategy.value == "zigzag" and op.ToolpathMark == small.job.ToolpathMark == value
    watcher.check(small.document)
    vkworkbench.clear(small.document)
    assert op.ToolpathMark == small.job.ToolpathMark == value and "VkWorkbenchMark" not in op.PropertiesList
    assert op.getTypeIdOfProperty("ToolpathMark") == type_id and op.Label2 == ""


@pytest.fixture
def earlier(small, zigzag_commands):
    """An operation whose mark is stored under the name that an earlier version used, and the record of the mark."""
    op = small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    made = marks.read(op)
    for obj in (op, small.job):
        data = obj.VkWorkbenchMark
        obj.removeProperty("VkWorkbenchMark")
        obj.addProperty("App::PropertyString", "ToolpathMark", "Toolpath analysis", "", 13).ToolpathMark = data
    return op, made


def test_mark_under_the_earlier_name_is_read_and_cleared(small, earlier):
    op, made = earlier
    assert marks.read(op) == made and marks.is_shown(op) and marks.words_of(op) == ""
    vkworkbench.clear(small.document)
    assert op.Label2 == "" and marked(small.document) == []
    assert not {"ToolpathMark", "Strategy"} & set(op.PropertiesList + small.job.PropertiesList)


def test_mark_under_the_earlier_name_can_be_outdated(small, earlier, zigzag_commands):
    op, made = earlier
    watcher.check(small.document)
    # The watcher does not write the mark of an unchanged operation again.
    assert marks.read(op) == made and "ToolpathMark" in op.PropertiesList
    op.Path = Path.Path([Path.Command(name, words) for name, words in zigzag_commands[:-4]])
    watcher.check(small.document)
    assert marks.is_outdated(op) and marks.is_outdated(small.job) and op.Label2.count("⟦") == 1
    assert "ToolpathMark" not in op.PropertiesList
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert marks.read(op).strategy is made.strategy and not marks.is_outdated(small.job)


def test_undo_and_clear_remove_a_mark_completely(example):
    example.UndoMode = 1
    job = example.getObject("Job")
    job.Label2 = "the user's own words"
    before = {obj.Name: (obj.Label2, sorted(obj.PropertiesList)) for obj in example.Objects}

    def state():
        return {obj.Name: (obj.Label2, sorted(obj.PropertiesList)) for obj in example.Objects}

    count = example.UndoCount
    vkworkbench.mark(vkworkbench.analyze(example))
    after = state()
    assert example.UndoNames[0] == "Analyze Toolpaths" and example.UndoCount == count + 1
    assert job.Label2.startswith("the user's own words ⟦")
    example.undo()
    assert state() == before
    example.redo()
    assert state() == after
    assert vkworkbench.clear(example) == len(after) - sum(after[name] == before[name] for name in after)
    assert state() == before and example.UndoNames[0] == "Clear Analysis"
    example.undo()
    assert state() == after


@pytest.mark.parametrize(
    "own",
    [
        "note",
        "note ",
        " x",
        "a ⟦b",
        "b⟧ c",
        "⟦of another tool⟧",
        "⟦3 operations foo⟧",
        "⟦zigzag tomorrow⟧",
        "zigzag 97% ⟦later⟧",
        "<b>bold</b> {0} \"'",
        "Ж 🙂 \u200fעברית",
    ],
)
def test_words_of_the_user_are_kept(small, zigzag_commands, own):
    op = small.add("Zigzag", zigzag_commands)
    op.Label2 = own
    for _ in range(2):
        vkworkbench.mark(vkworkbench.analyze(op))
        assert op.Label2.startswith(own)
    op.Label2 += " and more"
    vkworkbench.mark(vkworkbench.analyze(op))
    assert op.Label2.startswith(own) and op.Label2.endswith("⟧ and more")
    vkworkbench.clear(op)
    assert op.Label2 == own + " and more"


def test_marking_causes_no_recompute_and_keeps_the_gcode(example):
    before = posted(example.getObject("Job"))
    assert len(before) > 1000
    vkworkbench.mark(vkworkbench.analyze(example))
    assert [obj.Name for obj in example.Objects if "Touched" in obj.State or obj.MustExecute] == []
    assert example.recompute() == 0
    assert posted(example.getObject("Job")) == before


def test_second_marking_adds_no_undo_step(small, zigzag_commands):
    small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    count = small.document.UndoCount
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert small.document.UndoCount == count


def test_mark_of_the_job_equals_the_total_of_the_report(example):
    report = vkworkbench.analyze(example)
    vkworkbench.mark(report)
    job = example.getObject("Job")
    (total,) = report.totals
    for simulator in freecad.own_simulators():
        assert marks.read(job).cost(simulator) == total.cost(simulator)
    assert marks.read(job).trajectories == total.trajectories and "≥" not in job.Label2


def test_total_is_the_same_if_operations_are_marked_singly(small, zigzag_commands):
    ops = [small.add("First", zigzag_commands), small.add("Second", zigzag_commands)]
    report = vkworkbench.analyze(small.document)
    vkworkbench.mark(report)
    whole, text = marks.read(small.job), small.job.Label2
    vkworkbench.clear(small.document)
    for op in ops:
        vkworkbench.mark(vkworkbench.analyze(op))
    assert small.job.Label2 == text and marks.read(small.job).costs == whole.costs


def test_job_is_marked_if_all_its_operations_are_marked(small, zigzag_commands):
    first, second = small.add("First", zigzag_commands), small.add("Second", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(first))
    assert marked(small.document) == [first]
    vkworkbench.mark(vkworkbench.analyze(second))
    assert small.job.Label2.startswith("⟦2 operations")
    vkworkbench.clear(first)
    assert marked(small.document) == [second]


def test_clear_removes_the_mark_of_an_empty_job(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    small.document.removeObject(op.Name)
    assert vkworkbench.clear(small.job) == 1 and marked(small.document) == []


def test_deleted_operation_is_skipped_when_marking(small, zigzag_commands):
    first, second = small.add("First", zigzag_commands), small.add("Second", zigzag_commands)
    report = vkworkbench.analyze(small.document)
    small.document.removeObject(first.Name)
    assert vkworkbench.mark(report) == 1 and marks.is_marked(second)
    FreeCAD.closeDocument(small.document.Name)
    assert vkworkbench.mark(report) == 0


def test_marking_two_documents_adds_one_undo_step_each(small, zigzag_commands):
    small.add("Zigzag", zigzag_commands)
    other = FreeCAD.newDocument("Other")
    try:
        other.UndoMode = 1
        other.copyObject(small.document.getObject("Op"), False)
        vkworkbench.mark(vkworkbench.analyze([small.document, other]))
        assert small.document.UndoNames[0] == other.UndoNames[0] == "Analyze Toolpaths"
        small.document.undo()
        assert not marked(small.document) and len(marked(other)) == 1
    finally:
        FreeCAD.closeDocument(other.Name)


@pytest.mark.parametrize("changed", ["path", "tool", None])
def test_mark_of_a_report_older_than_a_change_is_outdated(small, zigzag_commands, changed):
    op = small.add("Zigzag", zigzag_commands)
    report = vkworkbench.analyze(op)
    if changed == "path":
        op.Path = Path.Path(op.Path.Commands[:-3])
    elif changed == "tool":
        small.controller.Tool.Diameter = 9
    vkworkbench.mark(report)
    assert marks.is_outdated(op) == (changed is not None)


def test_transaction_of_another_document_stays_open(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    other = FreeCAD.newDocument("Other")
    try:
        other.UndoMode = 1
        other.openTransaction("Edit")
        vkworkbench.mark(vkworkbench.analyze(op))
        assert marks.is_marked(op) and FreeCAD.getActiveTransaction()[0] == "Edit"
        other.addObject("App::FeaturePython", "Of the step")
        FreeCAD.closeActiveTransaction()
        assert [name.endswith("Edit") for name in other.UndoNames] == [True]
    finally:
        FreeCAD.closeActiveTransaction(True)
        FreeCAD.closeDocument(other.Name)


def test_marking_joins_an_open_transaction(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    small.document.openTransaction("Macro")
    op.Label = "Renamed"
    vkworkbench.mark(vkworkbench.analyze(op))
    small.document.commitTransaction()
    assert small.document.UndoNames[0] == "Macro"
    small.document.undo()
    assert op.Label == "Zigzag" and not marks.is_marked(op)


WITHOUT_ADDON = """
import sys, FreeCAD
document = FreeCAD.openDocument({path!r})
job = document.getObject("Job")
with open({out!r}, "w", encoding="utf-8") as file:
    for obj in [job, *job.Operations.Group]:
        print(obj.Label2, getattr(obj, "Strategy", ""), file=file)
    print("vkworkbench" in sys.modules, document.recompute(), file=file)
"""


def open_without_addon(path, folder):
    """Open a file in a new FreeCAD process without the add-on; return the texts in the tree and FreeCAD's output."""
    script, out, home = folder / "open.py", folder / "out.txt", folder / "home"
    home.mkdir()
    script.write_text(WITHOUT_ADDON.format(path=str(path), out=str(out)))
    environment = {**os.environ, "HOME": str(home), "PYTHONPATH": ""}
    log = subprocess.run(["freecadcmd", str(script)], env=environment, stdin=subprocess.DEVNULL, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300).stdout  # fmt: skip
    return out.read_text(encoding="utf-8").splitlines(), log.replace(str(folder), "")


def test_marked_file_opens_without_the_addon(example, tmp_path):
    plain, with_marks = tmp_path / "plain", tmp_path / "marked"
    for folder in (plain, with_marks):
        folder.mkdir()
    example.saveCopy(str(plain / "job.FCStd"))
    vkworkbench.mark(vkworkbench.analyze(example))
    example.saveCopy(str(with_marks / "job.FCStd"))
    shown, log = open_without_addon(with_marks / "job.FCStd", with_marks)
    _, plain_log = open_without_addon(plain / "job.FCStd", plain)
    assert shown[-1] == "False 0"
    assert all("⟦" in line for line in shown[:-1]) and "zigzag" in shown[1]
    assert log == plain_log


def test_pill_is_hidden_if_the_user_replaces_the_marks_text(small, zigzag_commands):
    """A pill in the tree covers the text of the mark; without this text, only an expression has a pill."""
    op = small.add("Zigzag", zigzag_commands)
    assert not marks.is_shown(op)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert marks.is_shown(op)
    op.Label2 = "own words"
    assert not marks.is_shown(op) and marks.is_marked(op)
    op.setExpression("Label2", "<<kept>>")
    small.document.recompute()
    assert marks.is_shown(op)


def test_second_marking_restores_a_removed_text(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    report = vkworkbench.analyze(small.document)
    vkworkbench.mark(report)
    texts = op.Label2, small.job.Label2
    op.Label2 = small.job.Label2 = ""
    # An automatic update does not write again the mark's text that the user has removed; only a new analysis does.
    refresh(op, lambda _: ())
    assert (op.Label2, small.job.Label2) == ("", "")
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert (op.Label2, small.job.Label2) == texts


def test_refresh_returns_whether_the_mark_has_changed(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    assert not refresh(op, lambda _: ())  # the update changes nothing, because there is no mark yet
    vkworkbench.mark(vkworkbench.analyze(small.document))
    _, setting = fingerprint.path_and_setting(marks.read(op).fingerprint)
    assert not refresh(op, lambda _: (setting,))
    assert refresh(op, lambda _: ("another",)) and marks.is_outdated(op)
    assert not refresh(op, lambda _: ("another",))
    assert refresh(op, lambda _: (setting,), path_changed=False, setting_changed=False)
    assert not marks.is_outdated(op)


def test_total_is_outdated_while_one_operation_is_outdated(small, zigzag_commands):
    one, other = small.add("One", zigzag_commands), small.add("Other", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert not marks.is_outdated(small.job)
    _, setting = fingerprint.path_and_setting(marks.read(one).fingerprint)
    refresh(one, lambda _: ("another",))
    marks.refresh_total(small.job)
    assert marks.is_outdated(small.job) and "outdated" in small.job.Label2
    refresh(one, lambda _: (setting,))
    marks.refresh_total(small.job)
    assert not marks.is_outdated(small.job)
    # A total that is computed from marks is outdated if one of the marks is outdated.
    refresh(other, lambda _: ("another",))
    marks.write_total(small.job, preferences.read())
    assert marks.is_outdated(small.job)
    small.job.Operations.Group = [one]
    marks.write_total(small.job, preferences.read())
    assert not marks.is_outdated(small.job) and small.job.Label2.startswith("⟦1 operation")
    marks.erase(one)
    marks.write_total(small.job, preferences.read())
    assert not marks.is_marked(small.job)


@pytest.mark.parametrize(
    "changed, warned",
    [
        ({}, False),
        ({"remarks": (Message("moves-nothing"),)}, True),
        ({"seconds": 61.0}, True),
        ({"seconds": 59.0}, False),
        ({"hangs": "legacy"}, True),
        (
            {"hangs": "OpenGL"},
            False,
        ),  # the mark's time is the legacy simulator's
    ],
)
def test_warning_sign_belongs_to_the_started_simulator(small, zigzag_commands, changed, warned):
    op = small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    chosen = replace(preferences.read(), mark_simulator="legacy", time_budget=60.0)
    known = marks.read(op)
    cost = replace(known.costs["legacy"], fast_forward_seconds=changed.get("seconds", 5.0))
    hangs = Message("legacy-hangs", simulator=changed.get("hangs", ""), command=3)
    known = replace(
        known, costs={"legacy": cost}, remarks=changed.get("remarks", ()),
        cautions=(Caution("legacy-hangs", hangs),) if "hangs" in changed else (),
    )  # fmt: skip
    assert mark_text.is_warned(known, chosen) is warned


def test_clear_without_argument_clears_the_active_document(small, zigzag_commands):
    small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    FreeCAD.setActiveDocument(small.name)
    assert vkworkbench.clear() == 2 and marked(small.document) == []


def test_failed_transaction_is_rolled_back(small, zigzag_commands):
    op = small.add("Before", zigzag_commands)
    count = small.document.UndoCount

    def fail():
        with marking.transaction(small.document, "Step"):
            op.Label = "After"
            raise ValueError("a bug")

    with pytest.raises(ValueError, match="a bug"):
        fail()
    assert op.Label == "Before" and small.document.UndoCount == count


def test_new_words_of_the_user_come_before_the_mark(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    assert marks.with_words(op, " mine ") == "mine"
    vkworkbench.mark(vkworkbench.analyze(op))
    mark = op.Label2
    op.Label2 = f"before {mark}"
    assert marks.with_words(op, "mine ") == f"mine {mark}" and marks.with_words(op, "") == mark
    op.Label2 = f"⟦zigzag⟧ {mark}"  # the text in the first brackets is a mark as an earlier version wrote it
    assert marks.with_words(op, "mine") == f"mine {mark}"


def test_brackets_that_the_user_adds_to_a_mark_are_kept(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    op.Label2 = "mine"
    vkworkbench.mark(vkworkbench.analyze(op))
    op.Label2 += " ⟦of another tool⟧"
    vkworkbench.clear(op)
    assert op.Label2 == "mine ⟦of another tool⟧"


def test_clearing_a_group_clears_a_job_without_operations(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    group = small.document.addObject("App::DocumentObjectGroup", "Group")
    group.addObject(small.job)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    small.document.removeObject(op.Name)
    assert marks.is_marked(small.job)
    assert vkworkbench.clear(group) == 1 and not marks.is_marked(small.job)
