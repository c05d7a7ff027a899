# SPDX-License-Identifier: LGPL-2.1-or-later
"""`analyze`: the operations that it finds, their order, the totals, and the errors for bad input."""

import csv
import json
import re
import sys
import time
from dataclasses import replace
from pathlib import PurePath
from threading import Event
from types import SimpleNamespace

import FreeCAD
import Part
import Path
import pytest

import vkworkbench
from vkworkbench import core, freecad, preferences
from vkworkbench.core.zbuffer import estimate_job
from vkworkbench.document import analysis
from vkworkbench.document.job import reading
from vkworkbench.document.job.results import RESULTS
from vkworkbench.document.job.setting import read_tool
from vkworkbench.document.marks import marking
from vkworkbench.language import Message, render
from vkworkbench.report import cells_of

STRATEGIES = {
    "Face": "zigzag", "Pocket zigzag": "zigzag", "Pocket around island": "contour-parallel",
    "Adaptive pocket": "adaptive", "Bore": "helix", "Drill holes": "drilling", "Dish": "zigzag",
    "Cut out with tags": "profile", "Cut out": "profile",
}  # fmt: skip


@pytest.fixture(scope="module")
def report(example_path):
    document = FreeCAD.openDocument(str(example_path))
    report = vkworkbench.analyze(document)
    FreeCAD.closeDocument(document.Name)
    return report


def test_strategies_of_the_example_are_recognised(report):
    found = {o.label: o.strategy.value for o in report.operations}
    assert found == {label: STRATEGIES[label] for label in found}
    assert len(found) >= 8 and all(o.confidence >= 0.6 for o in report.operations)


def test_every_operation_of_the_example_has_its_costs(report):
    for o in report.operations:
        assert o.error is None, o.error
        assert o.trajectories > 10 and o.length > 100
        assert o.estimate.seconds > 0 and o.estimate.memory_bytes > 1e6 and o.costs["legacy"].fast_forward_seconds > 0.3
        assert o.machining.seconds > 1
        assert len(o.reason) > 20


def test_operation_below_a_dress_up_is_not_in_the_total(report):
    counted = {o.label: o.counted for o in report.operations}
    assert counted.pop("Cut out") is False and all(counted.values())
    (total,) = report.totals
    assert total.operations == len(counted) and not total.incomplete
    assert total.seconds < sum(o.estimate.seconds for o in report.operations if o.counted)
    assert total.length == pytest.approx(sum(o.length for o in report.operations if o.counted))


def test_table_names_every_operation_and_the_total(report):
    lines = [
        line for line in str(report).splitlines() if not line.startswith(("Rows in brackets", "Job: Less", "Job: More"))
    ]
    assert len(lines) == len(report.operations) + 4
    # The table and the results panel have the same column titles.
    assert lines[0].split()[:4] == ["operation", "strategy", "confidence", "moves"]
    for o in report.operations:
        (line,) = [line for line in lines if line.split("  ")[0].strip("()") == o.label]
        assert o.strategy.value in line and f"{o.trajectories:,}" in line


def test_table_and_marks_show_the_same_times(example_path):
    document = FreeCAD.openDocument(str(example_path))
    report = vkworkbench.analyze(document)
    vkworkbench.mark(report)
    header, _, *lines = [
        line for line in str(report).splitlines() if not line.startswith(("Rows in brackets", "Job: Less", "Job: More"))
    ]
    assert f"{report.simulator} time" in header and report.simulator == preferences.read().simulator
    for o in report.operations:
        (line,) = [line for line in lines if line.split("  ")[0].strip("()") == o.label]
        (said,) = re.findall("sim (about )?([0-9.,]+ [a-z]+)", document.getObject(o.name).Label2)
        assert f" {''.join(said)} " in f"{line} "
    job = document.getObject(report.operations[0].job)
    (said,) = re.findall("sim (about )?([0-9.,]+ [a-z]+)", job.Label2)
    assert f" {''.join(said)} " in f"{lines[-1]} "
    FreeCAD.closeDocument(document.Name)


def test_csv_and_json_contain_the_same_numbers(report, tmp_path):
    report.to_csv(tmp_path / "report.csv")
    report.to_json(tmp_path / "report.json")
    with open(tmp_path / "report.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    data = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    assert len(rows) == len(data["operations"]) == len(report.operations)
    for row, entry, o in zip(rows, data["operations"], report.operations):
        assert row["label"] == entry["label"] == o.label
        assert row["strategy"] == entry["strategy"] == o.strategy.value
        assert float(row["length"]) == entry["length"] == o.length
        assert float(row["seconds"]) == entry["seconds"] == o.estimate.seconds
    assert data["totals"][0]["seconds"] == report.totals[0].seconds


def test_command_numbers_of_spans_start_at_0(small, zigzag_commands, tmp_path):
    op = small.add("Rows", zigzag_commands)
    report = vkworkbench.analyze(small.document)
    (span,) = report.operations[0].spans
    first, last = (op.Path.Commands[index] for index in (span.first_command, span.last_command))
    assert first.Name == "G1" and "Z" in first.Parameters and last.Name == "G1" and last is not first
    report.to_csv(tmp_path / "report.csv")
    (row,) = csv.DictReader((tmp_path / "report.csv").open(newline="", encoding="utf-8"))
    assert row["spans"] == f"zigzag {span.first_command}-{span.last_command}"
    assert "from 0" in cells_of.__doc__


def test_table_of_two_documents_names_the_documents(small, example):
    # If only one job has operations, the table has no column with the names of documents and jobs.
    assert str(vkworkbench.analyze([small.document, example])).startswith("operation ")
    small.add("Face", [("G0", {"X": 1.0, "Y": 1.0, "Z": 30.0}), ("G1", {"Z": 15.0, "F": 5.0})])
    report = vkworkbench.analyze([small.document, example])
    table = [
        line
        for line in str(report).splitlines()
        if not line.startswith("Rows in brackets") and " than the sum" not in line
    ]
    header, _, *rows, _, own, other = table
    assert header.split()[:2] == ["document", "operation"]
    assert [row.split()[0] for row in rows] == [o.document for o in report.operations]
    assert own.split()[:2] == [small.name, f"{small.job.Label}:"] and other.split()[:2] == [example.Name, "Job:"]


def test_formula_in_a_label_is_exported_as_text(small, zigzag_commands, tmp_path):
    small.add("=HYPERLINK(0)", zigzag_commands)
    vkworkbench.analyze(small.document).to_csv(tmp_path / "report.csv")
    with open(tmp_path / "report.csv", newline="", encoding="utf-8") as file:
        assert [row["label"] for row in csv.DictReader(file)] == ["'=HYPERLINK(0)"]


def test_analyze_does_not_change_the_document(example):
    example.UndoMode = 1
    before = [(obj.Name, obj.Label2, sorted(obj.PropertiesList), list(obj.State)) for obj in example.Objects]
    vkworkbench.analyze(example)
    assert [(obj.Name, obj.Label2, sorted(obj.PropertiesList), list(obj.State)) for obj in example.Objects] == before
    assert example.UndoCount == 0 and example.recompute() == 0


def test_documents_jobs_and_operations_can_be_analyzed(small, zigzag_commands):
    first, second = small.add("First", zigzag_commands), small.add("Second", zigzag_commands)

    def labels(what=None):
        return [o.label for o in vkworkbench.analyze(what).operations]

    assert (
        labels() == labels(small.document) == labels(small.job) == labels(small.job.Operations) == ["First", "Second"]
    )
    assert labels(second) == ["Second"] and labels([second, first, second]) == ["Second", "First"]
    assert labels([small.job, small.document]) == ["First", "Second"]
    assert labels(small.job.Model.Group[0]) == labels([]) == []
    with pytest.raises(TypeError, match="document, a job or operations"):
        vkworkbench.analyze(7)
    with pytest.raises(TypeError, match="not str"):
        vkworkbench.analyze([second, "Job"])
    (missing,) = vkworkbench.analyze("Job").operations  # `analyze` reads a text as the name of a G-code file
    assert missing.error == "The file cannot be read: No such file or directory."


def test_analysis_without_a_document_is_refused(small):
    FreeCAD.closeDocument(small.document.Name)
    for call in (vkworkbench.analyze, vkworkbench.clear):
        with pytest.raises(ValueError, match="no document is open"):
            call()


def test_document_without_operations_has_an_empty_report(small):
    empty = vkworkbench.analyze(small.document)
    assert empty.operations == () and "No operations" in str(empty)


def test_imported_toolpath_without_a_job_is_recognised(small):
    small.document.addObject("Path::Feature", "Imported").Path = Path.Path(
        "G0 X0 Y0 Z5\nG1 Z-1\nG1 X50\nG1 Y2\nG1 X0\nG1 Y4\nG1 X50\nG1 Y6\nG1 X0\nG1 Y8\nG1 X50"
    )
    (imported,) = vkworkbench.analyze(small.document).operations
    assert imported.strategy == "zigzag" and imported.job is None and imported.estimate is None
    assert "no tool" in imported.error and "no stock" in imported.error


def test_common_base_of_dress_up_and_array_is_not_in_the_total(small, zigzag_commands):
    base = small.add("Base", zigzag_commands)
    dressup = small.add("Dress-up", zigzag_commands)
    dressup.addProperty("App::PropertyLink", "Base", "Path").Base = base
    array = small.add("Array", zigzag_commands)
    array.addProperty("App::PropertyLinkList", "Base", "Path").Base = [base]
    array.addProperty("App::PropertyInteger", "Copies", "Path")
    counted = {o.label: o.counted for o in vkworkbench.analyze(small.job).operations}
    assert counted == {"Base": False, "Dress-up": True, "Array": True}
    small.job.Operations.Group = [
        dressup,
        array,
    ]  # without the dress-up's base, as in FreeCAD's window
    counted = {o.label: o.counted for o in vkworkbench.analyze(small.document).operations}
    assert counted == {"Dress-up": True, "Base": False, "Array": True}
    assert vkworkbench.analyze(base).operations[0].job == small.job.Name
    base.Active = False
    assert not any(o.counted for o in vkworkbench.analyze(small.job).operations)


def array_of(small, commands, *bases):
    array = small.add("Array", commands)
    array.addProperty("App::PropertyLinkList", "Base", "Path").Base = list(bases)
    array.addProperty("App::PropertyInteger", "Copies", "Path")
    return array


def counted(what):
    return {o.label for o in vkworkbench.analyze(what).operations if o.counted}


def test_array_base_outside_the_job_is_not_in_the_total(small, zigzag_commands):
    """In FreeCAD 1.1, making an array removes the array's base from the job."""
    base = small.add("Base", zigzag_commands)
    array = array_of(small, zigzag_commands, base)
    assert counted(small.document) == {"Base", "Array"}
    small.job.Operations.Group = [array]
    assert counted(small.document) == counted(small.job) == {"Array"} and counted(base) == set()
    (total,) = vkworkbench.analyze(small.document).totals
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert total.operations == 1 and small.job.Label2.startswith("⟦1 operation ")
    assert [o.label for o in vkworkbench.simulate(small.document).job.operations] == ["Array"]


def test_toolpath_without_a_job_has_the_flag_counted(small, zigzag_commands):
    alone = small.add("Alone", zigzag_commands, job=False)
    assert counted(alone) == counted(small.document) == {"Alone"}


def test_array_base_still_belongs_to_the_job(small, zigzag_commands):
    """In FreeCAD 1.1 the job does not list the base of an array; clearing the job also clears the base's mark."""
    base = small.add("Base", zigzag_commands)
    small.job.Operations.Group = [array_of(small, zigzag_commands, base)]
    report = vkworkbench.analyze(small.job)
    assert {row.label: row.counted for row in report.operations} == {"Array": True, "Base": False}
    vkworkbench.mark(report)
    assert base.Label2
    vkworkbench.clear(small.job)
    assert not base.Label2


def test_copy_of_an_operation_and_original_are_in_the_total(small, zigzag_commands, monkeypatch):
    base, copy = small.add("Base", zigzag_commands), small.add("Copy", zigzag_commands)
    copy.addProperty("App::PropertyLink", "Base", "Path").Base = base
    assert [row.counted for row in vkworkbench.analyze(small.job).operations] == [
        False,
        True,
    ]  # without its class ObjectPathCopy, the copy counts as a dress-up, whose base is not posted
    copy.Proxy = type("ObjectPathCopy", (), {"__module__": "Path.Op.Gui.Copy"})()
    assert [row.counted for row in vkworkbench.analyze(small.job).operations] == [True, True]


def test_array_counts_in_the_total_if_one_of_its_bases_is_on(small, zigzag_commands):
    first, second = small.add("First", zigzag_commands), small.add("Second", zigzag_commands)
    array_of(small, zigzag_commands, first, second)
    first.Active = False
    assert counted(small.job) == {"Second", "Array"}
    second.Active = False
    assert counted(small.job) == set()


def test_base_of_a_dressed_up_array_is_in_the_total(small, zigzag_commands):
    array = array_of(small, zigzag_commands, small.add("Base", zigzag_commands))
    dressup = small.add("Dress-up", zigzag_commands)
    dressup.addProperty("App::PropertyLink", "Base", "Path").Base = array
    assert counted(small.job) == {"Base", "Dress-up"}


def test_array_of_custom_operation_has_feeds_of_its_base(small, zigzag_commands):
    """The feeds of a custom operation, and of an array of it, may be in mm/min."""
    base = small.add("Base", [(n, {**w, "F": 600.0} if "F" in w else w) for n, w in zigzag_commands])
    array = array_of(small, zigzag_commands, base)
    array.Path, array.Proxy = base.Path, object()
    one, copy = vkworkbench.analyze(small.job).operations
    assert copy.machining_seconds == pytest.approx(one.machining_seconds) and copy.error == one.error
    array.Base = []
    assert vkworkbench.analyze(array).operations[0].machining_seconds < 0.1 * one.machining_seconds


def test_operations_in_folders_and_parts_are_analyzed(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    for kind in ("App::DocumentObjectGroup", "App::Part"):
        folder = small.document.addObject(kind, "Folder")
        folder.addObject(small.job)
        assert [o.label for o in vkworkbench.analyze(folder).operations] == ["Zigzag"]
        vkworkbench.mark(vkworkbench.analyze(folder))
        assert op.Label2 and small.job.Label2
        assert vkworkbench.clear(folder) == 2 and not op.Label2 and not small.job.Label2
        small.document.removeObject(folder.Name)


def test_inactive_operation_is_shown_as_switched_off(small, zigzag_commands):
    op = small.add("Off", [("(inactive operation)", {})])
    op.Active = False
    (off,) = vkworkbench.analyze(small.document).operations
    assert off.strategy == "empty" and not off.counted and off.error.startswith("The operation is switched off.")
    # Scripts compare the code of a remark, because it is the same in every language.
    assert off.remarks[0].code == "inactive"
    report = vkworkbench.analyze(small.document)
    assert small.document.getObject(off.name) is op and report.totals[0].operations == 0
    row = str(report).splitlines()[2]
    assert "switched off" in row and not re.search(r"\b0 s", row) and "?" not in row
    vkworkbench.mark(report)
    assert op.Label2 == "⟦switched off⟧"  # not a warning: the user switched the operation off
    op.Label2 = "mine ⟦switched off⟧"
    vkworkbench.clear(op)
    assert op.Label2 == "mine"


def test_stop_without_a_tool_has_no_error(small):
    stop = small.add("Stop", [("(Stop)", {}), ("M1", {})])
    stop.removeProperty("ToolController")  # FreeCAD's own stops and comments have no tool controller
    (stop,) = vkworkbench.analyze(small.document).operations
    assert stop.strategy == "empty" and stop.error is None
    row = str(vkworkbench.analyze(small.document)).splitlines()[2]
    assert not re.search(r"\b0 s", row) and "?" not in row
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert small.document.getObject(stop.name).Label2 == "⟦empty⟧"


def test_operation_without_cutting_moves_has_an_error(small):
    small.add("Drill", [("(Drill)", {}), ("G90", {}), ("G80", {})])
    (drill,) = vkworkbench.analyze(small.document).operations
    assert drill.strategy == "empty" and drill.error == "The toolpath has no cutting move."
    assert not re.search(r"\b0 s", str(vkworkbench.analyze(small.document)).splitlines()[2])


BAD_PATHS = {
    "Empty": ([], "no toolpath"),
    "Rapids": ([("G0", {"X": 1.0, "Y": 1.0, "Z": 1.0}), ("G0", {"X": 9.0})], "no cutting move"),
    "NaN": ([*[("G0", {"X": 0.0, "Y": 0.0, "Z": 1.0}), ("G1", {"X": 9.0}), ("G1", {"X": float("nan"), "Y": 4.0})]],
            "Command 3: X words that are not usable numbers are ignored."),
    "Unknown": ([("G0", {"X": 0.0, "Y": 0.0, "Z": 1.0}), ("G1", {"X": 9.0}), ("G123", {"X": 5.0})],
                "The unknown code 'G123' is ignored."),
    "No centre": ([("G0", {"X": 0.0, "Y": 0.0, "Z": 1.0}), ("G1", {"X": 9.0}), ("G2", {"X": 5.0, "Y": 4.0})],
                  "arc without a usable center"),
}  # fmt: skip


def test_bad_path_has_an_error_and_other_paths_are_analyzed(small, zigzag_commands):
    good = small.add("Good", zigzag_commands)
    for label, (commands, _) in BAD_PATHS.items():
        small.add(label, commands)
    report = vkworkbench.analyze(small.document)
    rows = {o.label: o for o in report.operations}
    assert rows["Good"].strategy == "zigzag" and rows["Good"].error is None
    for label, (_, message) in BAD_PATHS.items():
        assert message in rows[label].error
    vkworkbench.mark(report)
    assert "unknown code" in small.document.getObject(rows["Unknown"].name).Label2
    assert "no cutting move" in small.document.getObject(rows["Rapids"].name).Label2
    assert good.Remarks == ""


def test_missing_or_invalid_tool_or_stock_has_an_error(small, zigzag_commands):
    small.add("No tool", zigzag_commands, controller=None)
    small.add("Fine", zigzag_commands)
    rows = {o.label: o for o in vkworkbench.analyze(small.document).operations}
    assert "no tool" in rows["No tool"].error and rows["No tool"].estimate is None
    assert rows["No tool"].strategy == rows["Fine"].strategy == "zigzag"
    assert rows["Fine"].estimate is not None

    small.controller.Tool.Diameter = 0
    (fine,) = vkworkbench.analyze(small.document.getObject(rows["Fine"].name)).operations
    assert "diameter" in fine.error and small.controller.Label in fine.error and fine.strategy == "zigzag"
    small.controller.Tool.Diameter = 5

    small.job.Stock = None
    report = vkworkbench.analyze(small.job)
    rows = {o.label: o for o in report.operations}
    assert "no stock" in rows["Fine"].error and rows["Fine"].strategy == "zigzag"
    assert report.totals[0].incomplete and ">=" in str(report)


@pytest.mark.parametrize("label", ["T; U", "a: {label} {}", "x (command 3)", "50% %n"])
def test_labels_in_remarks_are_arguments_of_their_codes(small, zigzag_commands, label, tmp_path):
    small.add("Two things", [*zigzag_commands, ("G123", {"X": 5.0})])
    small.controller.Label, small.controller.Tool.Diameter = label, 0
    report = vkworkbench.analyze(small.document)
    (row,) = report.operations
    label = small.controller.Label
    assert row.remarks == (
        Message("of", label=label, sentence=Message("tool-diameter", diameter=0.0)),
        Message(
            "in-commands", sentence=Message("unknown-code", name="'G123'"), count=1, command=len(zigzag_commands) + 1
        ),
    )
    assert row.error == (
        f"{label}: The tool's diameter must be a positive number of at most a kilometer, not 0 mm. "
        f"Command {len(zigzag_commands) + 1}: The unknown code 'G123' is ignored."
    )
    report.to_csv(tmp_path / "r.csv")
    report.to_json(tmp_path / "r.json")
    with open(tmp_path / "r.csv", newline="", encoding="utf-8") as file:
        (cells,) = csv.DictReader(file)
    assert "of tool-diameter; in-commands unknown-code" in cells["codes"] and "messages" not in cells
    (entry,) = json.loads((tmp_path / "r.json").read_text(encoding="utf-8"))["operations"]
    assert tuple(map(Message.from_data, entry["messages"]["remarks"])) == row.remarks
    assert entry["error"] == row.error


def test_json_contains_every_message_as_data(report):
    for o in report.operations:
        messages = o.as_dict()["messages"]
        assert [Message.from_data(data) for data in messages["cautions"]] == [caution.what for caution in o.cautions]
        assert render(Message.from_data(messages["resolution"])) == o.resolution.explanation
    assert Message.from_data(report.totals[0].as_dict()["messages"]["resolution"]).code == "image"


def test_tool_with_text_as_diameter_is_refused():
    class Bit:
        Diameter = "6 mm"

    class Controller:
        Tool, Label = Bit, "Odd"

    class Operation:
        Name, ToolController = "Op", Controller

    with pytest.raises(ValueError, match="The tool in Odd has no diameter"):
        read_tool(Operation)


def test_placement_of_an_operation_moves_its_toolpath(small, zigzag_commands):
    op = small.add("Moved", zigzag_commands)
    (inside,) = vkworkbench.analyze(op).operations
    op.Placement.Base = FreeCAD.Vector(1000, 0, 0)
    (outside,) = vkworkbench.analyze(op).operations
    assert outside.estimate.traces == 0 < inside.estimate.traces
    assert [remark.code for remark in outside.remarks] == ["not-touching"] and inside.remarks == ()


def test_stock_equal_to_finished_part_has_a_remark(small, zigzag_commands):
    op = small.add("Beside", zigzag_commands)
    op.Placement.Base = FreeCAD.Vector(1000, 0, 0)
    finished = small.document.addObject("Part::Feature", "Finished")
    finished.Shape = small.job.Model.Group[0].Shape.copy()
    small.job.Stock = finished
    (report,) = vkworkbench.analyze(op).operations
    assert [remark.code for remark in report.remarks] == ["stock-is-model"]
    finished.Shape = Part.makeBox(61, 40, 20)
    (report,) = vkworkbench.analyze(op).operations
    assert [remark.code for remark in report.remarks] == ["not-touching"]


def test_analysis_reports_progress_and_can_be_cancelled(small, zigzag_commands):
    for label in ("One", "Two", "Three"):
        small.add(label, zigzag_commands)
    seen = []
    vkworkbench.analyze(small.job, progress=lambda done, count, label: seen.append((done, count, label)))
    assert seen == [(0, 3, "One"), (1, 3, "Two"), (2, 3, "Three")]
    answers = iter([False, False, True])
    with pytest.raises(vkworkbench.Cancelled):
        vkworkbench.analyze(small.job, cancelled=lambda: next(answers))
    assert all(not obj.Label2 for obj in small.document.Objects)


def rows_of_a_failure(report):
    """Return the rows of First, whose analysis fails, and of Second, which must be complete."""
    rows = report.operations
    assert [row.strategy.value for row in rows] == ["unknown", "zigzag"]
    line = next(line for line in str(report).splitlines() if line.startswith("First"))
    assert line.split()[4:6] == ["?", "?"], line  # the operation First has neither length nor time
    return rows


def test_bug_in_the_analysis_affects_one_operation_only(small, zigzag_commands, monkeypatch):
    small.add("First", zigzag_commands)
    small.add("Second", zigzag_commands[:-4])
    recognized = analysis.recognize_operation

    def broken(toolpath, *rest):
        if len(toolpath) == len(first):
            raise ZeroDivisionError("a bug")
        return recognized(toolpath, *rest)

    first = core.linearize(zigzag_commands)
    monkeypatch.setattr(analysis, "recognize_operation", broken)
    report = vkworkbench.analyze(small.document)
    rows = rows_of_a_failure(report)
    assert "Please report" in rows[0].error and rows[1].error is None


def test_memory_error_affects_only_its_own_mark(small, zigzag_commands, monkeypatch):
    first, second = small.add("First", zigzag_commands), small.add("Second", zigzag_commands[:-4])
    text_of, path_fingerprint = analysis.text_of, marking.path_fingerprint

    def text(path, *rest):
        if path.Size == first.Path.Size:
            raise MemoryError("no memory")
        return text_of(path, *rest)

    def fingerprint(obj):
        if obj.Name == first.Name:
            raise MemoryError("no memory")
        return path_fingerprint(obj)

    monkeypatch.setattr(analysis, "text_of", text)
    monkeypatch.setattr(marking, "path_fingerprint", fingerprint)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert "MemoryError" in first.Label2 and "zigzag" in second.Label2


def test_analysis_reads_each_input_once(small, zigzag_commands):
    """One analysis reads the commands, the tool and the stock of an operation once."""
    # An operation with an arc, so that the analysis also computes cautions for arcs.
    arc = ("G2", {"X": 30.0, "Y": 20.0, "I": -5.0, "J": 0.0})
    small.add("Rows", [*zigzag_commands, ("G1", {"X": 40.0, "Y": 20.0, "Z": 15.0}), arc])
    vkworkbench.analyze(small.document)  # let the first analysis measure the speed of the computer
    RESULTS.clear()
    counted = dict.fromkeys(["words.__init__", "motions.motions", "setting.read_tool", "setting.read_stock"], 0)

    def count(frame, event, argument):
        name = f"{PurePath(frame.f_code.co_filename).stem}.{frame.f_code.co_name}"
        if event == "call" and name in counted:
            counted[name] += 1

    sys.setprofile(count)
    try:
        report = vkworkbench.analyze(small.document)
    finally:
        sys.setprofile(None)
    (found,) = report.operations
    assert "legacy" in found.costs and ("OpenGL" in found.costs) == (freecad.version() >= (1, 0))
    assert counted == dict.fromkeys(counted, 1)


def test_analysis_stops_if_the_cancelled_function_raises(small, zigzag_commands, monkeypatch):
    small.add("Zigzag", zigzag_commands)
    begun, asked, ended = Event(), Event(), []

    def work(*arguments):
        begun.set()
        asked.wait(120)
        try:
            arguments[-1]()
        except vkworkbench.Cancelled:
            ended.append(True)
            raise

    def cancelled():
        if begun.is_set():
            raise KeyboardInterrupt
        return False

    monkeypatch.setattr(analysis, "_analysed_or_known", work)
    with pytest.raises(KeyboardInterrupt):
        vkworkbench.analyze(small.document, cancelled=cancelled)
    asked.set()
    for _ in range(2000):
        if ended:
            break
        time.sleep(0.05)
    assert ended


def test_machining_time_without_rapids_is_incomplete(small, zigzag_commands):
    small.add("Zigzag", zigzag_commands)
    report = vkworkbench.analyze(small.document)
    (row,), (total,) = report.operations, report.totals
    assert not row.machining.complete and not total.machining_complete
    assert row.as_dict()["machining_complete"] is False and total.as_dict()["machining_complete"] is False
    sheet = small.job.SetupSheet
    sheet.HorizRapid = sheet.VertRapid = "50 mm/s"
    small.document.recompute()
    report = vkworkbench.analyze(small.document)
    (row,), (total,) = report.operations, report.totals
    assert row.machining.left_out == () and row.machining.complete and total.machining_complete


def test_missing_tool_controller_is_named_as_cause(small, zigzag_commands):
    small.add("With", zigzag_commands)
    small.add("Without", zigzag_commands, controller=None)
    told = {o.label: o.machining.notes for o in vkworkbench.analyze(small.document).operations}
    assert "tool controller's VertRapid is 0" in told["With"][0]
    assert "has no tool controller. Choose your machine" in told["Without"][0] and "VertRapid" not in told["Without"][0]


@pytest.mark.parametrize("fixtures, count", [(["G54"], 1), (["G54", "G55", "G59"], 3), ([], 1)])
def test_machining_time_is_multiplied_by_the_fixtures(small, zigzag_commands, fixtures, count):
    small.add("Zigzag", zigzag_commands)
    small.job.Fixtures = fixtures
    report = vkworkbench.analyze(small.document)
    (row,), (total,) = report.operations, report.totals
    assert total.fixtures == count and total.length == row.length
    assert total.machining_seconds == pytest.approx(count * row.machining.seconds)
    assert total.as_dict()["fixtures"] == count


@pytest.mark.parametrize("diameter, told", [(50.0, False), (65.0, True)])
def test_tool_wider_than_longer_side_of_stock_has_a_remark(small, zigzag_commands, diameter, told):
    """The stock has 60 by 40 mm; its position does not matter."""
    place = FreeCAD.Vector(100, -300, 0)
    stock = small.document.addObject("Part::Feature", "Elsewhere")
    stock.Shape = Part.makeBox(60, 40, 20, place)
    small.job.Stock, small.controller.Tool.Diameter = stock, diameter
    op = small.add("Rows", zigzag_commands)
    op.Placement.Base = place
    (row,) = vkworkbench.analyze(op).operations
    assert ("tool-wider-than-stock" in [remark.code for remark in row.remarks]) is told


def test_cancelled_analysis_does_not_wait_for_its_thread(small, zigzag_commands, monkeypatch):
    small.add("Rows", zigzag_commands)
    vkworkbench.analyze(small.document)  # let the first analysis measure the speed of the computer
    RESULTS.clear()
    begun, go_on, ended = Event(), Event(), Event()

    def slow(*_):
        begun.set()
        go_on.wait(120)
        ended.set()

    monkeypatch.setattr(analysis, "_row", slow)
    with pytest.raises(vkworkbench.Cancelled):
        vkworkbench.analyze(small.document, cancelled=begun.is_set)
    assert not ended.is_set()
    go_on.set()


def test_analysis_computes_the_costs_that_the_panel_shows(small, zigzag_commands, monkeypatch):
    """If the panel had to compute the costs, FreeCAD's window would be blocked meanwhile."""
    small.add("First", zigzag_commands)
    small.add("Second", zigzag_commands[:-4])
    chosen = replace(preferences.read(), mark_simulator=core.simulators.ZBUFFER.name)
    monkeypatch.setattr(analysis, "preferences", SimpleNamespace(read=lambda: chosen))
    estimated = []
    monkeypatch.setattr(
        "vkworkbench.core.simulators.zbuffer.estimate_job",
        lambda *cuts, **of: estimated.append(1) or estimate_job(*cuts, **of),
    )
    report = vkworkbench.analyze(small.document)
    assert estimated == [1]
    (total,) = report.totals
    assert total.cost(chosen.simulator)[0] > 0 and estimated == [1]


def test_unreadable_operation_affects_no_other_operation(small, zigzag_commands, monkeypatch):
    first, _ = small.add("First", zigzag_commands), small.add("Second", zigzag_commands)

    def read(obj):
        if obj.Name == first.Name:
            raise ZeroDivisionError("a bug")
        return read_tool(obj)

    monkeypatch.setattr(reading, "read_tool", read)
    report = vkworkbench.analyze(small.document)
    rows = rows_of_a_failure(report)
    assert "ZeroDivisionError: a bug" in rows[0].error and rows[1].error is None
