# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results panel: its numbers, sorting, the selection it shares with FreeCAD, what it flags, and its exports."""

import csv
import json

import FreeCAD
import FreeCADGui as Gui
import pytest
from PySide import QtCore, QtGui

import vkworkbench
from vkworkbench import freecad
from vkworkbench.document import marks

OPENGL = freecad.version() >= (1, 0)


@pytest.fixture
def panel(opened, window):
    """The panel after a click on Analyze toolpaths."""
    window.click("Analyze toolpaths")
    window.wait(lambda: dock(window) is not None and dock(window).isVisible())
    window.dismiss()
    window.tree.expandAll()
    window.idle()
    yield dock(window)
    dock(window).table.sortByColumn(-1, QtCore.Qt.AscendingOrder)
    dock(window).hide()


def labelled(document, label):
    (obj,) = document.getObjectsByLabel(label)
    return obj


def dock(window):
    return window.main.findChild(QtGui.QDockWidget, "VkResults")


def titles(panel):
    model = panel.table.model()
    return [model.headerData(i, QtCore.Qt.Horizontal).replace("\n", " ") for i in range(model.columnCount())]


def column(panel, title):
    model, number = panel.table.model(), titles(panel).index(title)
    return [model.index(row, number).data() for row in range(model.rowCount())]


def click_row(window, panel, label):
    row = column(panel, "Operation").index(label)
    index = panel.table.model().index(row, 0)
    panel.table.scrollTo(index)
    window.click_at(panel.table.viewport(), panel.table.visualRect(index).center())
    window.idle()


def click_header(window, panel, title):
    header = panel.table.horizontalHeader()
    number = titles(panel).index(title)
    panel.table.scrollTo(panel.table.model().index(0, number))
    x = header.sectionViewportPosition(number) + header.sectionSize(number) // 2
    window.click_at(header.viewport(), QtCore.QPoint(x, header.height() // 2))
    window.idle(0.1)


def selected(panel):
    return [index.data() for index in panel.table.selectionModel().selectedRows()]


def test_one_row_for_each_operation_and_the_total_below(panel, opened, window):
    report = vkworkbench.analyze(opened)
    labels = column(panel, "Operation")
    assert labels[:-1] == [o.label for o in report.operations]
    assert labels[-1] == f"Job: {report.totals[0].operations} operations"
    assert column(panel, "Strategy")[:-1] == [o.strategy.value for o in report.operations]
    assert column(panel, "Trajectories")[:-1] == [f"{o.trajectories:,}" for o in report.operations]
    assert ("OpenGL time" in titles(panel)) == OPENGL
    sizes = [(o.resolution.view.width, o.resolution.view.height) for o in report.operations]
    assert column(panel, "Recommended image")[:-1] == [f"{width} × {height}" for width, height in sizes]
    for title in ("Z-buffer time", "Z-buffer memory", "Legacy time", "Legacy memory"):
        assert all(any(unit in cell for unit in ("ms", "s", "min", "MB", "kB")) for cell in column(panel, title)[:-1]), title


def test_light_and_dark(panel, window, theme):
    Gui.activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    click_row(window, panel, "Adaptive pocket")
    window.screenshot(f"panel-{theme}")
    assert window.main.width() <= 1280  # it asks for no more room than there is


def test_a_click_on_a_title_sorts_and_the_total_stays_below(panel, opened, window):
    operations = vkworkbench.analyze(opened).operations
    rising = [o.label for o in sorted(operations, key=lambda o: o.trajectories)]
    click_header(window, panel, "Trajectories")
    first = column(panel, "Operation")
    click_header(window, panel, "Trajectories")
    second = column(panel, "Operation")
    assert first[-1] == second[-1] and first[-1].startswith("Job:")
    assert {tuple(first[:-1]), tuple(second[:-1])} == {tuple(rising), tuple(reversed(rising))}
    click_header(window, panel, "Sure")
    assert column(panel, "Operation")[-1].startswith("Job:")


def test_a_click_on_a_row_selects_the_operation(panel, opened, window):
    click_row(window, panel, "Bore")
    assert Gui.Selection.getSelection() == [labelled(opened, "Bore")]
    tree_selected = [i.data() for i in window.tree.selectionModel().selectedIndexes() if i.column() == 0]
    assert tree_selected == ["Bore"]
    assert labelled(opened, "Bore").Reason in unescaped(panel.details)


def unescaped(label):
    return QtGui.QTextDocumentFragment.fromHtml(label.text()).toPlainText()


def test_selecting_in_freecad_moves_the_row(panel, opened, window):
    click_header(window, panel, "Length")
    for label in ("Drill holes", "Face"):
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(labelled(opened, label))
        window.wait(lambda label=label: selected(panel) == [label])
    Gui.Selection.clearSelection()
    window.wait(lambda: selected(panel) == [])
    assert Gui.Selection.getSelection() == []


def test_what_it_is_called_against_what_it_does(panel, opened, window):
    face, pocket = labelled(opened, "Face"), labelled(opened, "Pocket around island")
    assert not any("called" in remark for remark in column(panel, "Remarks"))
    face.Path, pocket.Path = pocket.Path, face.Path
    window.click("Analyze toolpaths")
    window.idle()
    remarks = dict(zip(column(panel, "Operation"), column(panel, "Remarks")))
    assert "called ZigZag, but its toolpath is contour-parallel" in remarks["Face"]
    assert "called Offset, but its toolpath is zigzag" in remarks["Pocket around island"]
    click_row(window, panel, "Face")
    assert "called ZigZag" in unescaped(panel.details)
    window.screenshot("panel-mismatch")


def test_what_is_wrong_is_said(panel, opened, window):
    bore = labelled(opened, "Bore")
    bore.ToolController = None
    window.click("Analyze toolpaths")
    window.idle()
    remarks = dict(zip(column(panel, "Operation"), column(panel, "Remarks")))
    assert "no tool" in remarks["Bore"]
    assert "lower bound" in next(text for label, text in remarks.items() if label.startswith("Job:"))


def test_rows_live_with_the_document(panel, opened, window):
    labelled(opened, "Face").Label = "Top"
    window.wait(lambda: "Top" in column(panel, "Operation"))
    top = labelled(opened, "Top")
    top.ToolpathMark = top.ToolpathMark.replace(marks.read(top).fingerprint, "of:another")
    from vkworkbench.document import watcher

    watcher.check(opened)
    window.wait(lambda: column(panel, "Remarks")[column(panel, "Operation").index("Top")].startswith("outdated"))
    opened.removeObject(top.Name)
    window.wait(lambda: "Top" not in column(panel, "Operation"))
    other = FreeCAD.newDocument("Other")
    window.wait(lambda: column(panel, "Operation") == [])
    assert "Analyze toolpaths" in panel.details.text() and not panel.csv.isEnabled()
    FreeCAD.closeDocument(other.Name)
    FreeCAD.setActiveDocument(opened.Name)
    window.wait(lambda: len(column(panel, "Operation")) > 3)


def test_one_operation_analyzed_again_keeps_the_others(panel, opened, window):
    count = len(column(panel, "Operation"))
    Gui.Selection.addSelection(labelled(opened, "Face"))
    window.click("Analyze toolpaths")
    window.idle()
    assert len(column(panel, "Operation")) == count


def save_as(window, button, path):
    """Click an export button and answer its dialog as a user does."""
    def answer():
        dialogs = [w for w in QtGui.QApplication.topLevelWidgets() if isinstance(w, QtGui.QFileDialog) and w.isVisible()]
        if not dialogs:
            QtCore.QTimer.singleShot(50, answer)
            return
        name = dialogs[0].findChild(QtGui.QLineEdit)
        name.setText(str(path))
        window.press(name, QtCore.Qt.Key_Return)

    QtCore.QTimer.singleShot(50, answer)
    window.click_on(button)
    window.idle()


def test_exports_hold_the_numbers(panel, opened, window, tmp_path):
    operations = vkworkbench.analyze(opened).operations
    save_as(window, panel.csv, tmp_path / "results.csv")
    save_as(window, panel.json, tmp_path / "results")
    with open(tmp_path / "results.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    data = json.loads((tmp_path / "results.json").read_text(encoding="utf-8"))
    assert [row["label"] for row in rows] == [o.label for o in operations]
    assert [o["seconds"] for o in data["operations"]] == [o.estimate.seconds for o in operations]


def test_an_export_that_fails_is_said(panel, window, tmp_path):
    said = []

    def look():
        said.extend(window.boxes())
        if not said:
            QtCore.QTimer.singleShot(100, look)
            return
        window.click_on(said[0].buttons()[0])

    folder = tmp_path / "results.csv"
    folder.mkdir()
    from vkworkbench.gui import panel as module

    name, module.QFileDialog.getSaveFileName = module.QFileDialog.getSaveFileName, lambda *what: (str(folder), "")
    try:
        QtCore.QTimer.singleShot(300, look)
        window.click_on(panel.csv)
        window.wait(lambda: said)
    finally:
        module.QFileDialog.getSaveFileName = name
    assert said


def test_copy_is_the_table_as_shown(panel, window):
    window.click_on(panel.copy)
    lines = [line.split("\t") for line in QtGui.QApplication.clipboard().text().splitlines()]
    assert lines[0] == titles(panel)
    assert [line[0] for line in lines[1:]] == column(panel, "Operation")
    assert all(len(line) == len(lines[0]) for line in lines)


def test_the_command_shows_and_hides_it(panel, window):
    window.click("Toolpath results")
    window.wait(lambda: not panel.isVisible())
    window.click("Toolpath results")
    window.wait(panel.isVisible)


def test_no_table_in_the_report_view(panel, window):
    view = window.main.findChild(QtGui.QTextEdit, "Report view") or window.main.findChild(QtGui.QTextEdit)
    assert "trajectories" not in view.toPlainText()
    assert marks.is_marked(FreeCAD.ActiveDocument.getObject("Job"))


def test_results_and_gauss_map_share_their_place(opened, window):
    window.click("Toolpath results")
    window.click("Gauss map")
    window.idle(0.5)
    results, gauss = (window.main.findChild(QtGui.QDockWidget, name) for name in ("VkResults", "VkGaussMap"))
    assert gauss in window.main.tabifiedDockWidgets(results)
    assert gauss.width() > 0.9 * window.main.width() and not gauss.visibleRegion().isEmpty()
    window.click("Toolpath results")  # from behind to the front
    window.idle()
    assert not results.visibleRegion().isEmpty() and gauss.visibleRegion().isEmpty()
    window.click("Toolpath results")
    window.click("Gauss map")
    window.idle()
    assert not results.isVisible()
    if not gauss.visibleRegion().isEmpty():
        window.click("Gauss map")
    assert not gauss.isVisible()
