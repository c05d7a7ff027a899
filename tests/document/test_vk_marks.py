# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks: what they say, and that they change nothing else: no recompute, no G-code, no word of the user's."""

import os
import subprocess

import FreeCAD
import pytest

import vkworkbench
from vkworkbench import freecad
from vkworkbench.document import marks
from vkworkbench.language import Message, render


def marked(document):
    return [obj for obj in document.Objects if marks.is_marked(obj)]


def test_mark_text_and_data(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    report = vkworkbench.analyze(small.document)
    assert vkworkbench.mark(report) == 1
    (o,) = report.operations
    assert op.Label2.startswith("⟦zigzag ") and op.Label2.endswith("⟧") and op.Label2.count(" · ") == 2
    assert (op.ToolpathStrategy, op.ToolpathTrajectories) == ("zigzag", o.trajectories)
    assert op.ToolpathSeconds == o.estimate.seconds and op.ToolpathMemory == o.estimate.memory_bytes
    assert op.ToolpathReason == o.reason and op.getGroupOfProperty("ToolpathReason") == "Toolpath analysis"
    assert set(op.getEditorMode("ToolpathStrategy")) == {"ReadOnly"}
    assert small.job.Label2.startswith("⟦1 operation · ")
    assert small.job.ToolpathLength == pytest.approx(o.length)


def told(op):
    return marks.reason_of(op), marks.remarks_of(op)


@pytest.mark.parametrize("label", ["T; U", "{label} {}", "a: b, c", "⟦x⟧ 50% \"q\" \\", "Ж 🙂"])
def test_codes_of_a_mark(small, zigzag_commands, label):
    op = small.add("Zigzag", [*zigzag_commands, ("G123", {"X": 5.0})])
    small.controller.Label, small.controller.Tool.Diameter = label, 0
    report = vkworkbench.analyze(small.document)
    vkworkbench.mark(report)
    (o,) = report.operations
    assert told(op) == ((o.recognition.why,), o.remarks)
    assert op.ToolpathRemark == o.error and small.controller.Label in op.ToolpathRemark
    assert set(op.getEditorMode("ToolpathMessages")) == {"ReadOnly", "Hidden"} and "Touched" not in op.State
    assert marks.remarks_of(small.job) == (Message("cost-unknown", labels=["Zigzag"]),)
    assert small.job.ToolpathRemark == "cost unknown for Zigzag" and marks.reason_of(small.job) == ()


def test_codes_survive_a_file(small, zigzag_commands, tmp_path):
    op = small.add("Zigzag", zigzag_commands, controller=None)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    before = told(op)
    assert before[1] == (Message("no-tool"),)
    small.document.saveAs(str(tmp_path / "small.FCStd"))
    FreeCAD.closeDocument(small.name)
    document = FreeCAD.openDocument(str(tmp_path / "small.FCStd"))
    assert told(document.getObject(op_name(document))) == before
    FreeCAD.closeDocument(document.Name)


def op_name(document):
    return next(obj.Name for obj in document.Objects if hasattr(obj, "ToolpathReason"))


def test_a_mark_of_the_version_before_shows_its_english_and_is_cleared(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands, controller=None)
    before = sorted(op.PropertiesList), op.Label2
    vkworkbench.mark(vkworkbench.analyze(small.document))
    for obj in (op, small.job):
        obj.removeProperty("ToolpathMessages")
    assert told(op) == tuple((Message("verbatim", text=text),) for text in (op.ToolpathReason, op.ToolpathRemark))
    assert render(marks.reason_of(op)[0]) == op.ToolpathReason
    # Marked again it has codes; cleared by that version it leaves them behind, which is a mark yet.
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert marks.remarks_of(op) == (Message("no-tool"),)
    for name in set(marks._PROPERTIES) - {"ToolpathMessages"}:
        if hasattr(op, name):
            op.removeProperty(name)
    op.Label2 = ""
    assert marks.is_marked(op) and told(op) == ((), ())
    vkworkbench.clear(small.document)
    assert (sorted(op.PropertiesList), op.Label2) == before


@pytest.mark.parametrize("written", [
    "", "{", "null", "[]", "5", "NaN", '"x"', "{}", '{"reason": null, "remarks": 7}', '{"reason": [null]}',
    '{"reason": [{"code": "no-moves"}], "remarks": [{"code": 1, "arguments": {}}]}',
    '{"reason": [{"code": "nobody-knows", "arguments": {}}], "remarks": [{"code": "image", "arguments": {}}]}',
    '{"reason": [{"code": "rows", "arguments": {"low": "x", "high": null, "count": "y", "spread": {}}}]}',
    '{"reason": [{"code": "apart", "arguments": {"step": 1' + 400 * "0" + "}}]}",
    '{"reason": ' + 100_000 * "[" + 100_000 * "]" + "}",
    '{"reason": ' + 500 * '[{"code": "of", "arguments": {"label": ' + '"x"' + 500 * "}}]" + "}",
    # Sound, but of another text: a version without codes has marked again since.
    '{"reason": [{"code": "no-moves", "arguments": {}}], "remarks": [{"code": "no-tool", "arguments": {}}]}',
])  # fmt: skip
def test_damaged_codes_show_the_english_text(small, zigzag_commands, written):
    op = small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    op.ToolpathRemark, op.ToolpathMessages = "as it is; {label}", written
    assert told(op) == tuple((Message("verbatim", text=text),) for text in (op.ToolpathReason, op.ToolpathRemark))
    assert render(marks.remarks_of(op)[0]) == "as it is; {label}"
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert marks.reason_of(op)[0].code == "rows" and op.ToolpathRemark == ""


def test_one_undo_step_and_clear_leave_no_trace(example):
    example.UndoMode = 1
    job = example.getObject("Job")
    job.Label2 = "the user's own words"
    before = {obj.Name: (obj.Label2, sorted(obj.PropertiesList)) for obj in example.Objects}

    def state():
        return {obj.Name: (obj.Label2, sorted(obj.PropertiesList)) for obj in example.Objects}

    count = example.UndoCount
    vkworkbench.mark(vkworkbench.analyze(example))
    after = state()
    assert example.UndoNames[0] == "Analyze toolpaths" and example.UndoCount == count + 1
    assert job.Label2.startswith("the user's own words ⟦")
    example.undo()
    assert state() == before
    example.redo()
    assert state() == after
    assert vkworkbench.clear(example) == len(after) - sum(after[name] == before[name] for name in after)
    assert state() == before and example.UndoNames[0] == "Clear analysis"
    example.undo()
    assert state() == after


@pytest.mark.parametrize("own", ["note", "note ", " x", "a ⟦b", "b⟧ c", "⟦of another tool⟧", "<b>bold</b> {0} \"'", "Ж 🙂 ‏עברית"])
def test_the_users_words_stay(small, zigzag_commands, own):
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


def posted(job):
    """The job's linuxcnc G-code, but for the line with the time of day."""
    if freecad.version() < (1, 0):
        from PathScripts.PathPostProcessor import PostProcessor

        processor = PostProcessor.load("linuxcnc")
        text = processor.export(job.Operations.Group, "-", "--no-show-editor")
    else:
        from Path.Post.Processor import PostProcessorFactory

        text = "".join(code for _, code in PostProcessorFactory.get_post_processor(job, "linuxcnc").export())
    return [line for line in text.splitlines() if "Output Time" not in line]


def test_nothing_is_recomputed_and_the_gcode_stays(example):
    before = posted(example.getObject("Job"))
    assert len(before) > 1000
    vkworkbench.mark(vkworkbench.analyze(example))
    assert [obj.Name for obj in example.Objects if "Touched" in obj.State or obj.MustExecute] == []
    assert example.recompute() == 0
    assert posted(example.getObject("Job")) == before


def test_marking_again_changes_nothing(small, zigzag_commands):
    small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    count = small.document.UndoCount
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert small.document.UndoCount == count


def test_total_of_the_job_counts_nothing_twice(example):
    report = vkworkbench.analyze(example)
    vkworkbench.mark(report)
    job = example.getObject("Job")
    (total,) = report.totals
    assert job.ToolpathSeconds == pytest.approx(total.seconds)
    assert job.ToolpathTrajectories == total.trajectories


def test_a_job_gets_its_total_when_all_its_operations_are_marked(small, zigzag_commands):
    first, second = small.add("First", zigzag_commands), small.add("Second", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(first))
    assert marked(small.document) == [first]
    vkworkbench.mark(vkworkbench.analyze(second))
    assert small.job.Label2.startswith("⟦2 operations")
    vkworkbench.clear(first)
    assert marked(small.document) == [second]


def test_clear_reaches_a_job_without_operations(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    small.document.removeObject(op.Name)
    assert vkworkbench.clear(small.job) == 1 and marked(small.document) == []


def test_marks_of_an_operation_that_is_gone_are_passed_over(small, zigzag_commands):
    first, second = small.add("First", zigzag_commands), small.add("Second", zigzag_commands)
    report = vkworkbench.analyze(small.document)
    small.document.removeObject(first.Name)
    assert vkworkbench.mark(report) == 1 and marks.is_marked(second)
    FreeCAD.closeDocument(small.document.Name)
    assert vkworkbench.mark(report) == 0


def test_two_documents_have_an_undo_step_each(small, zigzag_commands):
    small.add("Zigzag", zigzag_commands)
    other = FreeCAD.newDocument("Other")
    try:
        other.UndoMode = 1
        other.copyObject(small.document.getObject("Op"), False)
        vkworkbench.mark(vkworkbench.analyze([small.document, other]))
        assert small.document.UndoNames[0] == other.UndoNames[0] == "Analyze toolpaths"
        small.document.undo()
        assert not marked(small.document) and len(marked(other)) == 1
    finally:
        FreeCAD.closeDocument(other.Name)


def test_a_transaction_that_is_open_is_joined(small, zigzag_commands):
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
        print(obj.Label2, getattr(obj, "ToolpathStrategy", ""), file=file)
    print("vkworkbench" in sys.modules, document.recompute(), file=file)
"""


def open_without_addon(path, folder):
    """Open a file in a FreeCAD of its own without the add-on; return what it shows and what it printed."""
    script, out, home = folder / "open.py", folder / "out.txt", folder / "home"
    home.mkdir()
    script.write_text(WITHOUT_ADDON.format(path=str(path), out=str(out)))
    environment = {**os.environ, "HOME": str(home), "PYTHONPATH": ""}
    log = subprocess.run(["freecadcmd", str(script)], env=environment, stdin=subprocess.DEVNULL, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120).stdout  # fmt: skip
    return out.read_text(encoding="utf-8").splitlines(), log.replace(str(folder), "")


def test_a_marked_file_opens_without_the_addon(example, tmp_path):
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
