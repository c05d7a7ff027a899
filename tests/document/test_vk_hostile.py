# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Hostile documents: a broken object has an error in its own row of the report, and affects no other row.

Of a broken object, the add-on changes only the properties of its mark.
"""

import csv
import json
import locale
import os
import stat
import subprocess
import sys
from pathlib import Path

import FreeCAD
import Path as CAM
import pytest
from cases import first_everywhere
from counting import steps

import vkworkbench
from vkworkbench.document import upkeep
from vkworkbench.document.job.operations import find
from vkworkbench.document.marks import marks, watcher

LABELS = [
    "plain 'single' \"double\" `back`", "{0} {label} {{}} %s %d %(x)s", "🙂 👩‍🔧 𝕍ₖ", "<b>bold</b><img src='file:///etc/passwd'>",
    "עברית \u202eabc", "=1+1", "\t=cmd|' /C calc'!A0", "a\nb\r\nc", "⟦zigzag 98%⟧", "x" * 5000, "&amp; &lt;", "\\N{DIGIT ONE} \\0", "",
]  # fmt: skip


def outdated(document):
    return [obj.Label for obj in document.Objects if marks.is_outdated(obj)]


def analyze_mark_clear(what):
    """Analyse a document, write and clear its marks in the tree; return the report.

    Assert that the document is unchanged afterwards.
    """
    document = what.Document if hasattr(what, "Document") else what
    before = {obj.Name: (obj.Label, obj.Label2, obj.PropertiesList) for obj in document.Objects}
    report = vkworkbench.analyze(what)
    str(report)
    vkworkbench.mark(report)
    watcher.check(document)
    vkworkbench.clear(document)
    assert {obj.Name: (obj.Label, obj.Label2, obj.PropertiesList) for obj in document.Objects} == before
    return report


def test_operation_is_analyzed_after_its_model_is_deleted(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    op.addProperty("App::PropertyLinkSubList", "Base", "Path")
    op.Base = [(small.document.getObject("Block"), ("Face6",))]
    (before,) = analyze_mark_clear(small.document).operations
    small.document.removeObject("Block")
    (after,) = analyze_mark_clear(small.document).operations
    assert (after.strategy, after.trajectories, after.error) == (before.strategy, before.trajectories, None)


def test_dress_up_without_base_is_analyzed(small, zigzag_commands):
    base, dressup = small.add("Base", zigzag_commands), small.add("Dress-up", zigzag_commands)
    dressup.addProperty("App::PropertyLink", "Base", "Path").Base = base
    small.document.removeObject(base.Name)
    (row,) = analyze_mark_clear(small.document).operations
    assert row.strategy == "zigzag" and row.counted and row.error is None


def test_operations_that_are_each_others_base_have_results(small, zigzag_commands):
    first, second = small.add("First", zigzag_commands), small.add("Second", zigzag_commands)
    for op, other in ((first, second), (second, first)):
        op.addProperty(
            "App::PropertyLink", "Base", "Path"
        ).Base = other  # FreeCAD's window does not allow operations to be their own base, but a file can contain this
    rows = analyze_mark_clear(small.document).operations
    assert sorted(o.label for o in rows) == ["First", "Second"]
    assert [row.called for row in rows] == [None, None]


@pytest.mark.parametrize("lost, words", [
    ("controller", "no tool"), ("bit", "no tool"), ("stock", "no stock"), ("group", "no stock"), ("job", "no stock"),
])  # fmt: skip
def test_link_to_a_deleted_object_is_an_error(small, zigzag_commands, lost, words):
    op = small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    vkworkbench.clear(small.document)
    victim = {"controller": small.controller, "bit": small.controller.Tool, "stock": small.job.Stock,
              "group": small.job.Operations, "job": small.job}[lost]  # fmt: skip
    small.document.removeObject(victim.Name)
    names = {obj.Name for obj in small.document.Objects}
    if op.Name in names:  # false if FreeCAD has deleted the operation together with its job
        (row,) = analyze_mark_clear(small.document).operations
        assert row.strategy == "zigzag" and words in row.error
        assert (row.estimate is None) == (words == "no tool")
    else:
        assert analyze_mark_clear(small.document).operations == ()


def test_an_operation_in_two_groups_is_analyzed_once(small, zigzag_commands):
    op = small.add("Shared", zigzag_commands)
    part = small.document.addObject("App::Part", "Part")
    part.addObject(op)
    link_group = small.document.addObject("App::LinkGroup", "Links")
    link_group.ElementList = [op]
    other = small.document.copyObject(small.job, False)
    other.Operations = small.job.Operations
    report = vkworkbench.analyze(small.document)
    assert [o.name for o in report.operations] == [op.Name]
    assert sum(total.operations for total in report.totals) == 1
    assert [o.name for o in vkworkbench.analyze([op, part, other, small.job]).operations] == [op.Name]
    assert vkworkbench.mark(report) == 1 and outdated(small.document) == []
    watcher.check(small.document)
    assert outdated(small.document) == []
    vkworkbench.clear(small.document)
    assert not any(marks.is_marked(obj) for obj in small.document.Objects)


def test_missing_stock_is_replaced_by_a_box_around_the_cuts(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    small.job.Stock = None
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert op.Label2.startswith("⟦zigzag ") and "no stock" in op.Label2 and marks.read(op).costs
    assert "a box around the cuts" in op.Remarks


def test_operation_outside_the_stock_has_a_warning(small, zigzag_commands):
    small.job.Stock.Placement.Base.x += 5000
    small.document.recompute()
    op = small.add("Zigzag", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert "does not touch the stock" in op.Label2 and op.Strategy == "zigzag"


def test_job_with_an_unknown_cost_shows_a_lower_bound(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands, controller=None)
    small.add("Fine", zigzag_commands)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert "no tool" in op.Label2 and not marks.read(op).costs
    assert "≥" in small.job.Label2 and "Zigzag" in small.job.Remarks
    watcher.check(small.document)
    assert outdated(small.document) == []


def test_stock_larger_than_ten_metres_is_analyzed(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    stock = small.document.addObject("Part::Box", "Hall")
    stock.Length, stock.Width, stock.Height = 12_000, 11_000, 10_500
    small.document.recompute()
    small.job.Stock = stock
    (row,) = vkworkbench.analyze(op).operations
    assert row.error is None and row.strategy == "zigzag"
    assert 0 < row.estimate.seconds < 1e6 and 0 < row.estimate.memory_bytes < 1e12 and row.costs["legacy"].cells > 0


@pytest.mark.parametrize("diameter", [0, 1e-7, 1e6])
def test_invalid_tool_diameter_has_an_error(small, zigzag_commands, diameter):
    op = small.add("Zigzag", zigzag_commands)
    small.controller.Tool.Diameter = diameter
    (row,) = analyze_mark_clear(small.document).operations
    assert row.strategy in ("zigzag", "unknown")
    if diameter == 0:
        assert "diameter" in row.error and row.estimate is None
    else:
        assert row.estimate.seconds > 0 and row.estimate.memory_bytes > 0
        assert ("wider than the stock" in (row.error or "")) is (diameter > 1)
    assert op.Path.Size == len(zigzag_commands)


@pytest.mark.parametrize("label", first_everywhere(LABELS, 5), ids=range(len(LABELS)))
def test_odd_labels_are_shown_as_plain_text(small, zigzag_commands, label, tmp_path):
    op = small.add(label, zigzag_commands)
    own = label
    op.Label2 = own
    small.controller.Label = small.job.Label = label
    small.controller.Tool.Diameter = 0  # the diameter 0 causes a remark that contains the label of the tool controller
    kept = op.Label
    seen = []
    report = vkworkbench.analyze(small.document, progress=lambda done, count, text: seen.append(text))
    assert seen == [op.Label] and report.operations[0].label == op.Label
    table = str(report).splitlines()
    assert (len(table) == 5 and op.Label.split()[:1] == table[2].split()[:1]) or len(op.Label) > 60 or not op.Label
    report.to_csv(tmp_path / "r.csv")
    report.to_json(tmp_path / "r.json")
    with open(tmp_path / "r.csv", newline="", encoding="utf-8") as file:
        (row,) = csv.DictReader(file)
    assert row["label"].removeprefix("'") == op.Label and row["label"].lstrip()[:1] not in ("=", "+", "-", "@")
    assert json.loads((tmp_path / "r.json").read_text(encoding="utf-8"))["operations"][0]["label"] == op.Label
    FreeCAD.Console.PrintMessage(f"{report}\n")
    vkworkbench.mark(report)
    assert op.Label == kept and op.Label2.startswith(own)
    assert op.Label2.endswith("⟧") and "diameter" in op.Remarks
    path = str(tmp_path / "labels.FCStd")
    small.document.saveAs(path)
    FreeCAD.closeDocument(small.document.Name)
    document = FreeCAD.openDocument(path)
    try:
        again = document.getObject("Op")
        # Saving as XML can change line ends and tabs, but not the words.
        assert again.Label2.split() == f"{own} ⟦{marks.read(again).text}⟧".split()
        watcher.check(document)
        assert outdated(document) == []
        vkworkbench.clear(document)
        assert again.Label2.split() == own.split() and not marks.is_marked(again)
    finally:
        FreeCAD.closeDocument(document.Name)


def test_description_that_another_add_on_wrote_is_kept(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    small.document.UndoMode = 1
    vkworkbench.mark(vkworkbench.analyze(small.document))
    op.Label2 = "⟦feeds: 1200 mm/min⟧ another tool's"
    op.Path = CAM.Path(op.Path.Commands[:-3])
    small.document.recompute()
    assert op.Label2 == "⟦feeds: 1200 mm/min⟧ another tool's"
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert op.Label2.startswith("⟦feeds: 1200 mm/min⟧ another tool's ⟦zigzag ")
    vkworkbench.clear(small.document)
    assert op.Label2 == "⟦feeds: 1200 mm/min⟧ another tool's"


def test_read_only_file_is_analyzed_and_not_changed(small, zigzag_commands, tmp_path):
    small.add("Zigzag", zigzag_commands)
    path = tmp_path / "read-only.FCStd"
    small.document.saveAs(str(path))
    FreeCAD.closeDocument(small.document.Name)
    path.chmod(stat.S_IREAD)
    tmp_path.chmod(stat.S_IREAD | stat.S_IEXEC)
    content, folder = path.read_bytes(), sorted(os.listdir(tmp_path))
    document = FreeCAD.openDocument(str(path))
    try:
        (row,) = analyze_mark_clear(document).operations
        assert row.strategy == "zigzag" and row.error is None
        assert path.read_bytes() == content and sorted(os.listdir(tmp_path)) == folder
    finally:
        FreeCAD.closeDocument(document.Name)
        tmp_path.chmod(stat.S_IRWXU)


def test_error_of_an_unwritable_report_names_the_folder(small, zigzag_commands, tmp_path):
    small.add("Zigzag", zigzag_commands)
    report = vkworkbench.analyze(small.document)
    for write in (report.to_csv, report.to_json):
        with pytest.raises(OSError, match="missing"):
            write(tmp_path / "missing" / "report")


def test_closing_the_document_ends_the_analysis(small, zigzag_commands):
    for label in ("One", "Two", "Three"):
        small.add(label, zigzag_commands)
    name = small.document.Name

    def close(done, count, label):
        if done == 1:
            FreeCAD.closeDocument(name)

    report = vkworkbench.analyze(small.document, progress=close)
    assert [o.label for o in report.operations] == ["One"]
    assert vkworkbench.mark(report) == 0 and "One" in str(report)


@pytest.mark.parametrize("kept", [True, False])
def test_operation_deleted_during_the_analysis_has_no_row(small, zigzag_commands, kept):
    small.document.UndoMode = int(kept)  # with undo, the deleted object still exists, without a name
    small.document.openTransaction("Delete")
    names = [small.add(label, zigzag_commands).Name for label in ("One", "Two", "Three")]
    report = vkworkbench.analyze(small.job, progress=lambda done, *_: done or small.document.removeObject(names[1]))
    assert [o.label for o in report.operations] == ["One", "Three"]
    assert vkworkbench.mark(report) == 2
    small.document.commitTransaction()


def test_marks_of_two_documents_are_separate(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    other = FreeCAD.newDocument("Other")
    try:
        twin = other.copyObject(op, False)
        twin.Label = "Twin"
        assert twin.Name == op.Name
        FreeCAD.setActiveDocument(small.document.Name)
        assert [o.document for o in vkworkbench.analyze().operations] == [small.document.Name]
        report = vkworkbench.analyze([small.document, other])
        assert [(o.document, o.label) for o in report.operations] == [
            (small.document.Name, "Zigzag"),
            ("Other", "Twin"),
        ]
        vkworkbench.mark(report)
        assert op.Label2.startswith("⟦zigzag ") and "no stock" in twin.Label2
        twin.Path = CAM.Path(twin.Path.Commands[:-3])
        small.document.recompute()
        other.recompute()
        assert outdated(small.document) == [] and outdated(other) == ["Twin"]
        assert vkworkbench.clear(other) == 1 and marks.is_marked(op)
    finally:
        FreeCAD.closeDocument(other.Name)


def add_many(small, count, commands):
    """Add operations to one job in one step."""
    path = CAM.Path([CAM.Command(name, words) for name, words in commands])
    made = []
    for _ in range(count):
        op = small.document.addObject("Path::FeaturePython", "Op")
        op.addProperty("App::PropertyLink", "ToolController", "Path")
        op.ToolController = small.controller
        op.Path = path
        made.append(op)
    small.job.Operations.Group += made
    small.document.recompute()
    for op in made:
        op.purgeTouched()
    return made


@pytest.mark.long
def test_work_for_a_thousand_operations_is_linear(small, zigzag_commands):
    document = small.document
    operations = add_many(small, 100, zigzag_commands)
    few = [steps(lambda what=what: find(what)) for what in (operations, document, small.job)]
    operations += add_many(small, 900, zigzag_commands)
    many = [steps(lambda what=what: find(what)) for what in (operations, document, small.job)]
    assert max(b / a for a, b in zip(few, many)) < 12  # 10 if the work is linear in operations, 100 if quadratic
    assert [len(find(what)) for what in (operations, document, small.job)] == [1000] * 3
    report = vkworkbench.analyze(document)
    assert len(report.operations) == 1000 and report.totals[0].operations == 1000
    undo = document.UndoCount
    assert vkworkbench.mark(report) == 1000 and document.UndoCount == undo + 1
    assert small.job.Label2.startswith("⟦1000 operations")
    operations[500].Path = CAM.Path(operations[500].Path.Commands[:-3])
    document.recompute()
    assert outdated(document) == [small.job.Label, operations[500].Label]
    document.undo()
    assert not any(marks.is_marked(obj) for obj in document.Objects)


def test_marks_are_part_of_an_open_transaction(small, zigzag_commands):
    op = small.add("Zigzag", zigzag_commands)
    document = small.document
    report = vkworkbench.analyze(document)
    document.openTransaction("In the middle")
    vkworkbench.mark(report)
    op.Label = "Renamed"
    assert document.HasPendingTransaction and marks.is_marked(op)
    document.abortTransaction()
    assert op.Label == "Zigzag" and not marks.is_marked(op) and document.UndoCount == 0
    vkworkbench.mark(report)
    document.openTransaction("Again")
    op.Label = "Renamed"
    vkworkbench.clear(document)
    document.commitTransaction()
    assert document.UndoNames == ["Again", "Analyze Toolpaths"]
    document.undo()
    assert op.Label == "Zigzag" and marks.is_marked(op)
    document.undo()
    assert not marks.is_marked(op)


@pytest.mark.parametrize("undo_mode", [0, 1])
def test_marking_and_clearing_leave_no_open_transaction(small, zigzag_commands, undo_mode):
    op = small.add("Zigzag", zigzag_commands)
    small.document.UndoMode = undo_mode
    report = vkworkbench.analyze(small.document)
    for _ in range(2):  # call each function twice, because an undo step without changes could stay open
        vkworkbench.mark(report)
        assert FreeCAD.getActiveTransaction() is None and not small.document.HasPendingTransaction
    assert small.document.UndoCount == undo_mode and marks.is_marked(op)
    for _ in range(2):
        vkworkbench.clear(small.document)
        assert FreeCAD.getActiveTransaction() is None and not small.document.HasPendingTransaction
    assert small.document.UndoCount == 2 * undo_mode and not marks.is_marked(op)


@pytest.mark.parametrize("undo_mode", [0, 1])
def test_failed_marking_is_rolled_back(small, zigzag_commands, undo_mode, monkeypatch):
    first, second = small.add("First", zigzag_commands), small.add("Second", zigzag_commands)
    small.document.UndoMode = undo_mode
    report = vkworkbench.analyze(small.document)
    write = marks.write
    monkeypatch.setattr(marks, "write", lambda obj, *what, **how: write(obj, *what, **how) if obj is first else 1 / 0)
    with pytest.raises(ZeroDivisionError):
        vkworkbench.mark(report)
    assert FreeCAD.getActiveTransaction() is None and not small.document.HasPendingTransaction
    assert marks.is_marked(first) == (undo_mode == 0) and not marks.is_marked(second)


COMMA = """LC_NUMERIC
decimal_point ","
thousands_sep "."
grouping 3;3
END LC_NUMERIC
"""
CHARACTERS = "".join(f"<U{code:04X}> /x{code:02x} character\n" for code in range(128))
ASCII = f"<code_set_name> ASCII\n<comment_char> %\n<escape_char> /\nCHARMAP\n{CHARACTERS}END CHARMAP\n"


@pytest.fixture
def decimal_comma(tmp_path, monkeypatch):
    """Build a locale with a decimal comma, because test machines have none; return a function that switches to it."""
    (tmp_path / "comma.src").write_text(COMMA)
    (tmp_path / "ascii").write_text(ASCII)
    # localedef warns of undefined categories and returns an error code.
    subprocess.run(["localedef", "-c", "-i", "comma.src", "-f", "./ascii", "./comma"], cwd=tmp_path, check=False,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)  # fmt: skip
    monkeypatch.setenv("LOCPATH", str(tmp_path))
    before = locale.setlocale(locale.LC_NUMERIC)
    yield lambda: locale.setlocale(locale.LC_NUMERIC, "comma")
    locale.setlocale(locale.LC_NUMERIC, before)


def findings(report):
    return [{key: value for key, value in o.as_dict().items() if key != "document"} for o in report.operations]


def test_decimal_comma_in_the_locale_changes_no_result(example, decimal_comma, tmp_path):
    report = vkworkbench.analyze(example)
    before = findings(report), [o.fingerprint for o in report.operations]
    vkworkbench.mark(report)
    decimal_comma()
    assert locale.localeconv()["decimal_point"] == ","
    watcher.check(example)
    assert outdated(example) == []
    report = vkworkbench.analyze(example)
    assert (findings(report), [o.fingerprint for o in report.operations]) == before
    report.to_csv(tmp_path / "r.csv")
    with open(tmp_path / "r.csv", newline="", encoding="utf-8") as file:
        assert [float(row["length"]) for row in csv.DictReader(file)] == [o.length for o in report.operations]


def test_unit_system_of_the_user_changes_no_result(example):
    before = findings(vkworkbench.analyze(example))
    try:
        FreeCAD.Units.setSchema(2)  # a unit schema with inches
        assert findings(vkworkbench.analyze(example)) == before
    finally:
        FreeCAD.Units.setSchema(6)


class Audit:
    """While `on`, record started programs, network connections, and files opened for writing or deleted."""

    def __init__(self):
        self.on, self.seen = False, []
        sys.addaudithook(self.hook)  # audit hooks cannot be removed, so there is only one

    def hook(self, event, args):
        if not self.on:
            return
        if event == "open":
            path, mode, flags = args
            if (flags or 0) & (os.O_WRONLY | os.O_RDWR | os.O_CREAT) or set(mode or "") & set("wax+"):
                self.seen.append((event, str(path)))
        elif event.startswith(("socket.", "subprocess.", "shutil.", "os.system", "os.exec", "os.spawn", "os.fork",
                               "os.remove", "os.rename", "os.mkdir", "os.rmdir", "os.link", "os.symlink", "os.chmod",
                               "ftplib.", "smtplib.", "urllib.", "http.", "ctypes.", "winreg.")):  # fmt: skip
            self.seen.append((event, *map(str, args)))


def test_only_files_that_the_user_names_are_written(example, tmp_path):
    audit = Audit()
    monitored = sys.dont_write_bytecode
    sys.dont_write_bytecode = True
    audit.on = True
    try:
        report = vkworkbench.analyze(example)
        vkworkbench.mark(report)
        upkeep.watch()
        example.getObjectsByLabel("Pocket around island")[0].touch()
        example.recompute()
        vkworkbench.clear(example)
        assert audit.seen == []
        report.to_csv(tmp_path / "r.csv")
        report.to_json(tmp_path / "r.json")
    finally:
        audit.on = False
        sys.dont_write_bytecode = monitored
    assert [Path(path).name for _, path in audit.seen] == ["r.csv", "r.json"]
