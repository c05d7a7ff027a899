# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results panel: its tree, columns, filter, details and exports, and the selection, shared with FreeCAD."""

import csv
import json
import re
import time
import traceback

import FreeCAD
import FreeCADGui as Gui
import numpy as np
import pytest
from pictures import contrast, counted, pixels
from PySide import QtCore, QtGui

try:
    from PySide2.QtTest import QTest
except ImportError:
    from PySide6.QtTest import QTest

import vkworkbench
from vkworkbench import freecad, preferences
from vkworkbench.document.marks import marks
from vkworkbench.document.marks.slow_simulation import too_long
from vkworkbench.document.marks.text import Burden, burden, is_warned, time_of
from vkworkbench.gui.qt import colors
from vkworkbench.gui.qt.colors import readable
from vkworkbench.gui.qt.saving import with_suffix
from vkworkbench.gui.qt.sentences import user
from vkworkbench.gui.results import findings
from vkworkbench.gui.results.columns import Column
from vkworkbench.gui.tree.explanation import explanation
from vkworkbench.language import ROUGH, render

OPENGL = freecad.version() >= (1, 0)


@pytest.fixture
def panel(marked, window):
    """The panel of the example job, high enough for its column titles whatever earlier tests did to its height."""
    panel = window.show_results()
    window.main.resizeDocks([panel], [300], QtCore.Qt.Vertical)
    window.settle()
    yield panel
    dock(window).tree.sortByColumn(-1, QtCore.Qt.AscendingOrder)
    dock(window).filter.words.clear()
    dock(window).filter.strategies.setCurrentIndex(0)
    dock(window).filter.warnings.setChecked(False)


def labelled(document, label):
    (obj,) = document.getObjectsByLabel(label)
    return obj


def dock(window):
    return window.first(QtGui.QDockWidget, "VkResults")


def titles(panel):
    model = panel.tree.model()
    return [model.headerData(i, QtCore.Qt.Horizontal).replace("\n", " ") for i in range(model.columnCount())]


def shown(panel):
    return [title for number, title in enumerate(titles(panel)) if not panel.tree.isColumnHidden(number)]


def indexes(panel):
    """Return the indexes of the first column, from top to bottom."""
    model = panel.tree.model()

    def below(parent):
        for number in range(model.rowCount(parent)):
            index = model.index(number, 0, parent)
            yield index
            yield from below(index)

    return list(below(QtCore.QModelIndex()))


def column(panel, title):
    """Return {label: text in the column} for operations and jobs."""
    number = titles(panel).index(title)
    return {index.data(): index.sibling(index.row(), number).data() for index in indexes(panel)}


def labels(panel):
    return [index.data() for index in indexes(panel)]


def click_row(window, panel, label, modifier=QtCore.Qt.NoModifier):
    index = next(index for index in indexes(panel) if index.data() == label)
    panel.tree.scrollTo(index)
    QTest.mouseClick(panel.tree.viewport(), QtCore.Qt.LeftButton, modifier, panel.tree.visualRect(index).center())
    window.settle()


def click_header(window, panel, title):
    header = panel.tree.header()
    number = titles(panel).index(title)
    x = header.sectionViewportPosition(number) + header.sectionSize(number) // 2
    window.click_at(header.viewport(), QtCore.QPoint(x, header.height() // 2))
    window.settle()


def selected(panel):
    return [index.data() for index in panel.tree.selectionModel().selectedRows()]


def text_of(panel):
    return panel.details.toPlainText()


FIRST = [
    "Operation",
    "Strategy",
    "Machining Time",
    "Simulation Time",
    "Warnings",
    "Notes",
]  # the column "State" is shown only if a mark in the tree is outdated


def test_panel_shows_the_total_of_a_job_above_its_operations(panel, opened, window):
    report = vkworkbench.analyze(opened)
    assert labels(panel) == ["Job", *(o.label for o in report.operations)]
    (job,) = [index for index in indexes(panel) if not index.parent().isValid()]
    assert panel.tree.isExpanded(job)
    strategies = column(panel, "Strategy")
    assert strategies.pop("Job") == f"{report.totals[0].operations} operations"
    assert list(strategies.values()) == [o.strategy.value for o in report.operations]
    moves = column(panel, "Moves")
    assert moves["Job"] == f"{report.totals[0].trajectories:,}"
    assert [moves[o.label] for o in report.operations] == [f"{o.trajectories:,}" for o in report.operations]


def test_columns_of_the_panel_are_chosen_in_a_menu(panel, opened, window):
    assert shown(panel) == FIRST
    named = ["Simulate Toolpaths", *(user().simulator(name) for name in ("legacy", *(["OpenGL"] if OPENGL else [])))]
    assert titles(panel)[:7] == [*FIRST[:4], "State", "Warnings", "Notes"]
    assert titles(panel)[7:] == [
        "In Plain Words", "Simulation Time at Most", "Confidence", "Moves", "Length",
        *(f"{name} {what}" for name in named for what in ("Time", "Memory")),
        "Recommended Image",
    ]  # fmt: skip
    own = user().simulator(freecad.own_simulator())
    assert column(panel, "Simulation Time") == column(panel, f"{own} Time")
    assert all(column(panel, "Simulation Time").values())
    costs = [o.costs[freecad.own_simulator()] for o in vkworkbench.analyze(opened).operations]
    at_most = list(column(panel, "Simulation Time at Most").values())[1:]
    assert at_most == [user().time(cost.seconds * cost.factor, ROUGH) for cost in costs]
    sizes = [(o.resolution.view.width, o.resolution.view.height) for o in vkworkbench.analyze(opened).operations]
    assert list(column(panel, "Recommended Image").values())[1:] == [
        f"{width:,} × {height:,}" for width, height in sizes
    ]
    length = next(action for action in panel.columns.actions() if action.text() == "Length")
    state = next(action for action in panel.columns.actions() if action.text() == "State")
    try:
        length.trigger()
        state.trigger()
        assert shown(panel) == [*FIRST[:4], "Warnings", "Notes", "Length"]
        assert preferences.read().result_columns == "state,length"
    finally:
        length.trigger()
        state.trigger()
    assert shown(panel) == FIRST and preferences.read().result_columns == ""


def test_costs_of_hidden_columns_are_not_computed(panel):
    """Computing the z-buffer cost of a long toolpath would block the window."""
    (total,) = [row for _, row in panel._indexes() if row.is_total]
    assert preferences.read().simulator in total.found.costs.computed()
    assert "z-buffer" not in total.found.costs.computed()
    (number,) = [n for n, column in enumerate(panel.model.columns) if column.key == "z-buffer time"]
    panel.tree.setColumnHidden(number, False)
    panel._fit_columns()
    assert "z-buffer" in total.found.costs.computed()
    panel.tree.setColumnHidden(number, True)


def test_name_column_stays_visible_when_scrolling(panel, opened, window):
    chosen = [action for action in panel.columns.actions() if action.isCheckable() and not action.isChecked()]
    try:
        for action in chosen:
            action.trigger()
        window.settle()
        bar, frozen = panel.tree.horizontalScrollBar(), panel.tree.findChild(QtGui.QTreeView, "frozen")
        assert bar.maximum() > 0 and not frozen.isVisible()
        bar.setValue(bar.maximum())
        window.settle()
        assert frozen.isVisible() and frozen.width() == panel.tree.columnWidth(0)
        for index in indexes(panel)[:4]:
            assert frozen.visualRect(index).top() == panel.tree.visualRect(index).top()
        where = frozen.visualRect(indexes(panel)[2]).center()
        window.click_at(frozen.viewport(), where)
        window.settle()
        assert selected(panel) == [indexes(panel)[2].data()] and bar.value() == bar.maximum()
        window.screenshot("panel-all-columns")
        bar.setValue(0)
        assert not frozen.isVisible()
    finally:
        for action in chosen:
            action.trigger()


def test_frozen_name_column_is_opaque(panel, shipped, window):
    chosen = [action for action in panel.columns.actions() if action.isCheckable() and not action.isChecked()]
    try:
        for action in chosen:
            action.trigger()
        window.settle()  # let Qt lay out the columns
        bar, frozen = panel.tree.horizontalScrollBar(), panel.tree.findChild(QtGui.QTreeView, "frozen")

        def picture(value):
            bar.setValue(value)
            window.settle()
            # Take the picture from the main window, because in FreeCAD 1.1 the view's own background is transparent.
            place = QtCore.QRect(frozen.viewport().mapTo(window.main, QtCore.QPoint(0, 0)), frozen.viewport().size())
            return window.main.grab(place).toImage()

        def is_same(one, other):
            """Compare pictures up to the rounding of Qt's smoothing, a few of 255 levels; text would differ by far more."""
            return (np.abs(pixels(one).astype(int) - pixels(other)) < 8).all()

        # Wait, because FreeCAD applies a theme with a delay.
        window.wait(lambda: is_same(picture(bar.maximum() // 2), picture(bar.maximum())))
        window.screenshot(f"panel-frozen-{shipped.replace(' ', '-')}")
        seen, above = (view.mapToGlobal(view.rect().topLeft()) for view in (panel.tree.viewport(), frozen.viewport()))
        assert above == seen and frozen.viewport().width() == panel.tree.columnWidth(0)
    finally:
        bar.setValue(0)
        for action in chosen:
            action.trigger()


def test_arrow_of_a_menu_is_beside_its_text(panel, shipped, window):
    def columns(one, other):
        """Return the columns of pixels in which two pictures differ."""
        return np.flatnonzero((pixels(one) != pixels(other)).any(axis=(0, 2)))

    buttons = [b for b in panel.filter.findChildren(QtGui.QToolButton) if b.isVisible() and b.menu() is not None]
    assert len(buttons) == 2
    for button in buttons:
        menu, text, whole = button.menu(), button.text(), button.grab().toImage()
        button.setMenu(None)
        bare = button.grab().toImage()
        button.setText("")
        empty = button.grab().toImage()
        button.setText(text)
        button.setMenu(menu)
        assert max(columns(bare, empty)) < min(columns(whole, bare))


def test_panel_does_not_widen_the_window_in_any_theme(panel, window, theme):
    Gui.activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    click_row(window, panel, "Adaptive pocket")
    window.screenshot(f"panel-{theme}")
    assert window.main.width() <= 1280  # the panel does not make the main window wider


def test_panel_is_readable_in_freecads_themes(panel, window, shipped):
    click_row(window, panel, "Bore")
    window.settle()
    window.screenshot(f"panel-{shipped.replace(' ', '-')}")
    (background, _), *others = counted(panel.details.viewport().grab().toImage()).most_common()
    link = readable(QtGui.QColor(colors.LINK), QtGui.QColor(background))
    assert contrast(background, link) > 4.5
    assert any(contrast(color, link) < 1.05 for color, _ in others)
    assert max(contrast(background, color) for color, _ in others) > 4.5


def test_panel_has_a_small_minimum_height(panel):
    """The themes of the tests above must not have changed the minimum height."""
    panel.filter.updateGeometry()
    least = panel.filter.minimumSizeHint().height() + 4 * panel.fontMetrics().height()
    assert panel.widget().layout().totalMinimumSize().height() <= least


def test_low_panel_shows_rows_instead_of_titles(panel, opened, window):
    panel.setFloating(True)
    try:
        panel.resize(600, panel.minimumSizeHint().height())
        window.settle()
        top = panel.tree.model().index(0, 0)
        panel.tree.scrollTo(top)
        seen = panel.tree.viewport()
        assert seen.rect().contains(panel.tree.visualRect(top).adjusted(0, 0, -panel.tree.columnWidth(0) + 1, 0))
        panel.tree.horizontalScrollBar().setValue(100)  # scroll sideways, under the frozen first column
        window.settle()
        window.screenshot("panel-low")
        panel.resize(600, 400)
        window.settle()
        assert panel.tree.header().isVisible() and seen.height() > 6 * panel.tree.visualRect(top).height()
    finally:
        panel.tree.horizontalScrollBar().setValue(0)
        panel.setFloating(False)
        window.settle()


def test_click_on_a_title_sorts_within_the_job(panel, opened, window):
    operations = vkworkbench.analyze(opened).operations
    rising = [o.label for o in sorted(operations, key=lambda o: o.machining.seconds)]
    click_header(window, panel, "Machining Time")
    first = labels(panel)
    click_header(window, panel, "Machining Time")
    second = labels(panel)
    assert first[0] == second[0] == "Job"
    assert {tuple(first[1:]), tuple(second[1:])} == {tuple(rising), tuple(reversed(rising))}
    posted = next(action for action in panel.columns.actions() if "Posted" in action.text())
    posted.trigger()
    assert labels(panel)[1:] == [o.label for o in operations]


def test_filter_finds_rows_by_words_strategy_and_warnings(panel, opened, window):
    strategies = {o.label: o.strategy.value for o in vkworkbench.analyze(opened).operations}
    panel.filter.words.setFocus()
    window.type(panel.filter.words, "POCKET")
    window.settle()
    assert labels(panel) == ["Job", *(label for label in strategies if "pocket" in label.lower())]
    panel.filter.words.clear()
    number = panel.filter.strategies.findText("zigzag")
    panel.filter.strategies.setCurrentIndex(number)
    assert labels(panel) == ["Job", *(label for label, strategy in strategies.items() if strategy == "zigzag")]
    window.screenshot("panel-filter")
    panel.filter.strategies.setCurrentIndex(0)
    panel.filter.warnings.setChecked(True)
    signs = {
        obj.Label for obj in opened.Objects if marks.is_marked(obj) and is_warned(marks.read(obj), preferences.read())
    }
    assert set(labels(panel)) == signs
    panel.filter.warnings.setChecked(False)
    assert labels(panel) == ["Job", *strategies]
    assert text_of(panel) == "Select an operation to read what it does and why."
    window.type(panel.filter.words, "not in the job")
    assert not labels(panel) and text_of(panel) == "No operation matches the filter."


def test_click_on_a_row_selects_the_operation(panel, opened, window):
    click_row(window, panel, "Bore")
    assert Gui.Selection.getSelection() == [labelled(opened, "Bore")]
    tree_selected = [i.data() for i in window.tree.selectionModel().selectedIndexes() if i.column() == 0]
    assert tree_selected == ["Bore"]


@pytest.mark.long
def test_details_show_phi_only_after_a_click_on_why(panel, opened, window):
    click_row(window, panel, "Bore")
    (found,) = [o for o in vkworkbench.analyze(opened).operations if o.label == "Bore"]
    assert ("φ" not in text_of(panel) and "going down" in text_of(panel).lower()) or "descending" in text_of(panel)
    panel.details.anchorClicked.emit(QtCore.QUrl("why"))
    assert found.reason.replace("Phi", "φ") in text_of(panel)
    assert "Recommended" not in text_of(panel)
    panel.details.anchorClicked.emit(QtCore.QUrl("numbers"))
    # The details show the text of the clicked column.
    assert re.search(r"Recommended image: [\d,]+ × [\d,]+ pixels", text_of(panel))
    length = user().length(found.length)
    assert f"Cutting Length {length}" in text_of(panel).replace("\n", " ") and text_of(panel).count(length) == 1
    shortest = user().measure(found.machining.shortest, 3)
    assert f"Shortest Move at Feed {shortest}" in text_of(panel).replace("\n", " ")
    window.see_all()
    window.screenshot("panel-why")
    panel.details.anchorClicked.emit(QtCore.QUrl("why"))
    panel.details.anchorClicked.emit(QtCore.QUrl("numbers"))
    assert "φ" not in text_of(panel)


def test_details_keep_numbers_and_units_together(panel, window):
    click_row(window, panel, "Bore")
    block, told = panel.details.document().begin(), []
    while block.isValid():
        told.append(block.text())
        block = block.next()
    assert not [text for text in told if re.search(r"\d (?:ms|s|min|h|mm)\b", text)], told
    assert any(re.search("\\d\u00a0mm", text) for text in told)


@pytest.mark.long
def test_several_selected_rows_show_their_total(panel, opened, window):
    click_row(window, panel, "Bore")
    click_row(window, panel, "Face", QtCore.Qt.ControlModifier)
    posted = vkworkbench.analyze(opened).totals[0].operations
    assert {obj.Label for obj in Gui.Selection.getSelection()} == {"Bore", "Face"}
    assert text_of(panel).startswith(f"Selection in Job: 2 of {posted} operations")


def test_keys_move_the_selection_copy_rows_and_open_a_row(panel, opened, window):
    click_row(window, panel, "Face")
    window.press(panel.tree, QtCore.Qt.Key_Down)
    window.settle()
    below = labels(panel)[labels(panel).index("Face") + 1]
    assert selected(panel) == [below] and [obj.Label for obj in Gui.Selection.getSelection()] == [below]
    QTest.keyClick(panel.tree, QtCore.Qt.Key_C, QtCore.Qt.ControlModifier)
    window.settle()
    assert QtGui.QApplication.activeModalWidget() is None
    lines = QtGui.QApplication.clipboard().text().splitlines()
    assert lines[0].split("\t") == FIRST and [line.split("\t")[0] for line in lines[1:]] == [below]
    asked = []
    panel._look_at, before = (lambda: asked.append(1)), panel._look_at
    panel.tree._enter, enter = (lambda: asked.append(1)), panel.tree._enter
    window.press(panel.tree, QtCore.Qt.Key_Return)
    panel._look_at, panel.tree._enter = before, enter
    assert asked


def test_selection_in_freecad_selects_the_row_in_the_panel(panel, opened, window):
    click_header(window, panel, "Machining Time")
    for label in ("Drill holes", "Face"):
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(labelled(opened, label))
        window.wait(lambda label=label: selected(panel) == [label])
    Gui.Selection.clearSelection()
    window.wait(lambda: selected(panel) == [])
    assert Gui.Selection.getSelection() == []


def test_row_of_a_job_is_not_the_row_of_its_first_operation(panel, opened, window):
    """The job and its first operation are both row 0, of different parents."""
    first = next(iter(labels(panel)[1:]))
    for label in ("Job", first, "Job"):
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(labelled(opened, label))
        window.wait(lambda label=label: selected(panel) == [label])
        assert text_of(panel).startswith(f"{label}:")


def test_exported_files_contain_the_numbers_of_the_report(panel, opened, window, tmp_path):
    operations = vkworkbench.analyze(opened).operations
    window.answer_file_dialog(tmp_path / "results.csv", panel.csv.trigger)
    window.answer_file_dialog(tmp_path / "results", panel.json.trigger)
    with open(tmp_path / "results.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    data = json.loads((tmp_path / "results.json").read_text(encoding="utf-8"))
    assert [row["label"] for row in rows] == [o.label for o in operations]
    assert [o["seconds"] for o in data["operations"]] == [o.estimate.seconds for o in operations]


def test_failed_export_shows_a_message(panel, window, tmp_path):
    said = []

    def look():
        said.extend(window.boxes())
        if not said:
            QtCore.QTimer.singleShot(100, look)
            return
        window.click_on(said[0].buttons()[0])

    folder = tmp_path / "results.csv"
    folder.mkdir()
    from vkworkbench.gui.qt import saving as module

    name, module.QFileDialog.getSaveFileName = module.QFileDialog.getSaveFileName, lambda *what: (str(folder), "")
    try:
        QtCore.QTimer.singleShot(300, look)
        panel.csv.trigger()
        window.wait(lambda: said)
    finally:
        module.QFileDialog.getSaveFileName = name
    assert said


def test_copied_table_has_the_shown_columns_and_rows(panel, window):
    Gui.Selection.clearSelection()
    window.settle()
    panel.copy.trigger()
    lines = [line.split("\t") for line in QtGui.QApplication.clipboard().text().splitlines()]
    assert lines[0] == FIRST
    assert [line[0] for line in lines[1:]] == labels(panel)
    assert all(len(line) == len(lines[0]) for line in lines)


def test_results_command_hides_the_panel_only_if_it_has_focus(panel, window):
    window.tree.setFocus()
    window.click("Toolpath Results")  # if the focus is elsewhere, the panel stays visible and gets the focus
    window.wait(lambda: window.main.focusWidget() is panel.tree)
    assert panel.isVisible()
    window.click("Toolpath Results")
    window.wait(lambda: not panel.isVisible())
    window.click("Toolpath Results")
    window.wait(panel.isVisible)
    window.wait(lambda: window.main.focusWidget() is panel.tree)


def test_analysis_writes_no_table_into_the_report_view(panel, window):
    view = window.first(QtGui.QTextEdit, "Report view") or window.first(QtGui.QTextEdit)
    assert "trajectories" not in view.toPlainText()
    assert marks.is_marked(FreeCAD.ActiveDocument.getObject("Job"))


@pytest.mark.long
def test_simulation_time_in_the_panel_is_the_time_in_the_marks(panel, opened, window):
    """The panel shows the time of the simulator in the preferences, for jobs as in the tree."""
    try:
        for name in ("legacy", *(["OpenGL"] if OPENGL else []), "z-buffer"):
            preferences.write(mark_simulator=name)
            title = f"{'Simulate Toolpaths' if name == 'z-buffer' else user().simulator(name)} Time"
            # The column is updated by a later event, which may be slow on a busy computer.
            window.wait(lambda title=title: column(panel, "Simulation Time") == column(panel, title))
            shown = column(panel, "Simulation Time")
            if name == "z-buffer" and marks.read(opened.getObject("Job")).cost(name) is None:
                continue
            for obj in filter(marks.is_marked, opened.Objects):
                assert shown[obj.Label] == time_of(marks.read(obj), preferences.read(), user())
    finally:
        preferences.write(mark_simulator="own")
        window.settle()


def test_texts_show_inches_if_freecad_shows_inches(panel, opened, window):
    """Mark, tooltip and details show no millimetres if FreeCAD shows inches."""
    schema, units = FreeCAD.Units.getSchema(), FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units")
    FreeCAD.Units.setSchema(3)
    links = ("why", "numbers")
    try:
        click_row(window, panel, "Face")
        for link in links:
            panel.details.anchorClicked.emit(QtCore.QUrl(link))
        shown = explanation(marks.read(labelled(opened, "Face")), preferences.read()) + text_of(panel)
        window.screenshot("panel-inches")
        assert re.search(r"\d in\b", shown) and not re.search(r"\d mm\b", shown), shown
    finally:
        FreeCAD.Units.setSchema(schema)
        units.SetInt("UserSchema", schema)
        for link in links:
            panel.details.anchorClicked.emit(QtCore.QUrl(link))


def sign(panel, label):
    """Return the warning icon next to a label in the panel, or None."""
    (index,) = [index for index in indexes(panel) if index.data() == label]
    return index.data(QtCore.Qt.DecorationRole)


@pytest.mark.long
def test_warning_signs_in_the_panel_equal_signs_in_the_tree(panel, opened, window):
    """A row with a time over the budget has the sign ⚠ and a faster way; the tree has the sign in the same rows."""
    harmless = [label for label, text in column(panel, "Notes").items() if text and not sign(panel, label)]
    try:
        preferences.write(time_budget=0.1, mark_simulator="legacy")
        window.wait(lambda: "0.1 s limit" in (column(panel, "Warnings")["Job"] or ""))
        window.settle()
        for obj in filter(marks.is_marked, opened.Objects):
            assert ("⚠" in obj.Label2) == bool(sign(panel, obj.Label)), obj.Label
            told = column(panel, "Warnings")[obj.Label]
            if burden(marks.read(obj), preferences.read()) is Burden.OVER:
                assert ", which is over your 0.1 s limit. Simulate Toolpaths shows" in told
                assert told.split(". ")[0] in explanation(marks.read(obj), preferences.read())
        panel.filter.warnings.setChecked(True)
        assert sign(panel, "Job") and "Job" in labels(panel)
        window.screenshot("panel-over-the-budget")
        panel.filter.warnings.setChecked(False)
        preferences.write(time_budget=1e6)
        window.wait(lambda: not sign(panel, "Job"))
        for label in harmless:
            assert not sign(panel, label)
    finally:
        preferences.write(time_budget=600.0, mark_simulator="own")
        window.settle()


def test_only_rows_over_the_budget_have_a_warning(panel, opened, window):
    one = marks.read(labelled(opened, "Adaptive pocket")).cost("legacy")[0]
    total = marks.read(opened.getObject("Job")).cost("legacy")[0]
    assert one < total
    try:
        preferences.write(time_budget=(one + total) / 2, mark_simulator="legacy")
        window.wait(lambda: sign(panel, "Job"))
        panel.filter.warnings.setChecked(True)
        assert labels(panel) == ["Job"]
    finally:
        preferences.write(time_budget=600.0, mark_simulator="own")
        window.settle()


@pytest.mark.long
def test_operation_with_another_strategy_has_a_remark(panel, opened, window):
    face, pocket = labelled(opened, "Face"), labelled(opened, "Pocket around island")
    assert not any("called" in remark for remark in column(panel, "Warnings").values())
    face.Path, pocket.Path = pocket.Path, face.Path
    window.click("Analyze Toolpaths")
    window.settle()
    remarks = column(panel, "Warnings")
    assert "called ZigZag, but its toolpath is contour-parallel" in remarks["Face"]
    assert "called Offset, but its toolpath is zigzag" in remarks["Pocket around island"]
    (index,) = [index for index in indexes(panel) if index.data() == "Face"]
    assert "called ZigZag" in index.data(QtCore.Qt.AccessibleTextRole)
    click_row(window, panel, "Face")
    assert "called ZigZag" in text_of(panel)
    window.see_all()
    window.screenshot("panel-mismatch")


@pytest.mark.long
def test_faulty_operations_have_a_remark(panel, opened, window):
    bore = labelled(opened, "Bore")
    bore.ToolController = None
    labelled(opened, "Face").Active = False
    window.click("Analyze Toolpaths")
    window.settle()
    remarks = column(panel, "Warnings")
    assert "The operation has no tool." in remarks["Bore"]
    remarks = column(panel, "Notes")
    assert remarks["Face"].endswith("This operation is not included in the total, because it is switched off.")
    cautions, _, rest = remarks["Cut out"].partition(
        "This operation is not included in the total, because its dress-up is."
    )
    assert rest == ""
    # The costs depend on the computer: a slow simulator has a caution.
    assert cautions == "" or " takes about " in cautions or " slows to about " in cautions
    # Only the beginning of the tooltip is compared, because the rest depends on the computer's speed.
    assert column(panel, "Warnings")["Job"].startswith("The simulation cost of Bore is unknown.")


@pytest.mark.long
def test_operation_switched_off_is_updated_without_analysis(panel, opened, window):
    window.analyze(opened)
    window.dismiss()
    face, text = labelled(opened, "Face"), text_of(panel)
    before, total, on = face.Label2, opened.getObject("Job").Label2, column(panel, "Strategy")
    face.Active = False
    opened.recompute()
    window.wait(lambda: face.Label2 == "⟦switched off⟧")
    window.wait(lambda: column(panel, "Strategy")["Face"] == "switched off")
    assert not column(panel, "Machining Time")["Face"] and not sign(panel, "Face")
    assert column(panel, "State").get("Face", "") == "" and opened.getObject("Job").Label2 != total
    window.screenshot("panel-switched-off-later")
    face.Active = True
    opened.recompute()
    window.wait(lambda: face.Label2 == before and opened.getObject("Job").Label2 == total)
    window.wait(lambda: column(panel, "Strategy") == on and text_of(panel) == text)


def test_panel_opens_high_after_it_was_made_low(panel, window):
    """A simulation tab makes the panel as low as possible."""
    panel.hide()
    panel.show()
    window.main.resizeDocks([panel], [1], QtCore.Qt.Vertical)
    window.wait(lambda: panel.height() < 200)
    panel.hide()
    window.show_results()
    window.wait(lambda: panel.height() >= 290)


@pytest.mark.long
def test_switched_off_operation_is_not_an_error(panel, opened, window):
    face = labelled(opened, "Face")
    face.Active = False
    opened.recompute()
    window.click("Analyze Toolpaths")
    window.wait(lambda: column(panel, "Strategy")["Face"] == "switched off")
    assert not column(panel, "Machining Time")["Face"] and not sign(panel, "Face")
    assert (
        column(panel, "Notes")["Face"].startswith("The operation is switched off. ")
        and "total" not in column(panel, "Notes")["Face"]
    )
    assert not re.search(r"\d marks have warnings", window.main.statusBar().currentMessage())
    assert "empty" not in [panel.filter.strategies.itemText(i) for i in range(panel.filter.strategies.count())]
    click_row(window, panel, "Face")
    assert "Why?" not in text_of(panel) and not re.search(r"\b0 s", text_of(panel)) and "0.00" not in text_of(panel)
    text = explanation(marks.read(face), preferences.read())
    assert "switched off" in text and "⚠" not in text and "Machining time" not in text and "empty" not in text
    window.screenshot("panel-switched-off")
    face.Active = True
    opened.recompute()
    window.click("Analyze Toolpaths")
    window.wait(lambda: column(panel, "Strategy")["Face"] == "zigzag")


@pytest.mark.long
def test_analysis_fills_the_panel_once_in_its_own_event(panel, opened, window, monkeypatch):
    """If the analysis also filled the panel, the window would be blocked for both."""
    find, events = findings.read_findings, []

    def finds(document):
        events.append([frame.name for frame in traceback.extract_stack()])
        return find(document)

    monkeypatch.setattr(findings, "read_findings", finds)
    window.click("Analyze Toolpaths")
    window.wait(lambda: events)
    window.settle()
    assert len(events) == 1 and "Activated" not in events[0]
    assert column(panel, "Strategy")["Face"] == "zigzag"


def test_rows_of_the_panel_follow_changes_of_the_document(panel, opened, window):
    labelled(opened, "Face").Label = "Top"
    window.wait(lambda: "Top" in labels(panel))
    top = labelled(opened, "Top")
    top.VkWorkbenchMark = top.VkWorkbenchMark.replace(marks.read(top).fingerprint, "of:another")
    from vkworkbench.document.marks import watcher

    watcher.check(opened)
    assert shown(panel) == FIRST
    window.wait(lambda: column(panel, "State")["Top"] == "outdated" == column(panel, "State")["Job"])
    assert shown(panel) == [*FIRST[:4], "State", "Warnings", "Notes"]
    click_row(window, panel, "Top")
    assert "outdated" in text_of(panel)
    opened.removeObject(top.Name)
    window.wait(lambda: "Top" not in labels(panel))
    other = FreeCAD.newDocument("Other")
    window.wait(lambda: labels(panel) == [])
    assert "Analyze Toolpaths" in text_of(panel) and not panel.csv.isEnabled()
    FreeCAD.closeDocument(other.Name)
    FreeCAD.setActiveDocument(opened.Name)
    window.wait(lambda: len(labels(panel)) > 3)


@pytest.mark.long
def test_row_of_a_job_agrees_with_its_mark(panel, opened, window):
    job, chosen = opened.getObject("Job"), preferences.read()

    def said(operations, state):
        mark = marks.read(job)
        time = column(panel, titles(panel)[3])["Job"]
        return (
            column(panel, "Strategy")["Job"].startswith(f"{operations} ")
            and mark.operations == operations
            and time == time_of(mark, chosen, user())
            and (column(panel, "State")["Job"] == "outdated") == mark.outdated == state
        )

    count = marks.read(job).operations
    opened.openTransaction("Delete")
    opened.removeObject(labelled(opened, "Face").Name)
    opened.commitTransaction()
    window.wait(lambda: said(count - 1, False))
    opened.undo()
    window.wait(lambda: said(count, False))
    copy = opened.copyObject(labelled(opened, "Face"), False)
    vkworkbench.clear(copy)
    job.Operations.Group += [copy]
    opened.recompute()
    window.wait(lambda: said(count, True))


def test_note_explains_a_different_cycle_time_of_freecad(panel, opened, window):
    job = opened.getObject("Job")
    before, (ours,) = job.CycleTime, vkworkbench.analyze(opened).totals
    for factor, noted in ((1.2, False), (3.0, True), (1 / 3, True)):
        job.CycleTime = time.strftime("%H:%M:%S", time.gmtime(factor * ours.machining_seconds / ours.fixtures))
        window.click("Analyze Toolpaths")
        window.wait(lambda noted=noted: ("CycleTime" in column(panel, "Notes")["Job"]) == noted)
    job.CycleTime = before


@pytest.mark.long
def test_other_table_rows_stay_when_one_is_analyzed_again(panel, opened, window):
    count = len(labels(panel))
    Gui.Selection.addSelection(labelled(opened, "Face"))
    window.click("Analyze Toolpaths")
    window.settle()
    assert len(labels(panel)) == count


@pytest.mark.long
def test_note_says_that_a_total_covers_only_a_selection(opened, window):
    posted = vkworkbench.analyze(opened).totals[0].operations
    Gui.Selection.addSelection(labelled(opened, "Face"))
    window.click("Analyze Toolpaths")
    window.wait(lambda: marks.is_marked(labelled(opened, "Face")))
    window.show_results()
    assert column(dock(window), "Strategy")["Job"] == f"1 of {posted} operations"
    assert "This total covers the analyzed operations only." in column(dock(window), "Notes")["Job"]


@pytest.mark.parametrize(
    "chosen, saved",
    [
        ("job", "job.csv"),
        ("job.csv", "job.csv"),
        ("job.TXT", "job.TXT"),
        ("Bracket V1.2", "Bracket V1.2.csv"),
        ("", ""),
    ],
)
def test_file_name_without_a_suffix_gets_one(chosen, saved):
    assert with_suffix(chosen, ".csv") == saved


def test_panel_is_a_tab_beside_the_report_view(opened, window):
    view = window.first(QtGui.QDockWidget, "Report view")
    existing = dock(window)
    if existing is not None:  # remove the panel, so that the command makes a new one, as after a start of FreeCAD
        Gui.Selection.removeObserver(existing)
        FreeCAD.removeDocumentObserver(existing)
        existing.setObjectName("")
        existing.hide()
        existing.deleteLater()
    window.main.addDockWidget(QtCore.Qt.BottomDockWidgetArea, view)
    view.show()
    window.main.setGeometry(0, 0, 1024, 700)
    window.settle()
    try:
        window.click("Analyze Toolpaths")
        window.wait(lambda: marks.is_marked(opened.Job))
        panel = window.show_results()
        assert view in window.main.tabifiedDockWidgets(panel) and not panel.visibleRegion().isEmpty()
        line = window.tree.visualRect(window.cell("Face")).height()
        assert window.tree.viewport().height() > 8 * line and panel.width() > 0.45 * window.main.width()
        assert window.main.width() <= 1024 and window.main.height() <= 700
        click_row(window, panel, "Face")
        window.screenshot("panel-1024-report-view")
    finally:
        view.hide()
        window.main.setGeometry(0, 0, 1280, 1000)
        window.settle()


def test_results_and_gauss_map_are_tabs_of_one_dock(opened, window):
    window.click("Toolpath Results")
    window.click("Gauss Map")
    window.settle()
    results, gauss = (window.first(QtGui.QDockWidget, name) for name in ("VkResults", "VkGaussMap"))
    assert gauss in window.main.tabifiedDockWidgets(results)
    assert gauss.width() > 0.5 * window.main.width() and not gauss.visibleRegion().isEmpty()
    window.click("Toolpath Results")  # bring the results in front of the Gauss map
    window.settle()
    assert not results.visibleRegion().isEmpty() and gauss.visibleRegion().isEmpty()
    window.click("Toolpath Results")
    window.settle()
    assert not results.isVisible()
    window.click("Gauss Map")
    window.click("Gauss Map")
    window.settle()
    assert not gauss.isVisible()


def test_document_opened_with_marks_fills_the_panel(panel, opened, window, tmp_path):
    """After reopening, columns and details are as before; numbers that a mark does not store need a new analysis."""
    before = {title: column(panel, title) for title in FIRST}
    label = "Pocket zigzag"
    click_row(window, panel, label)
    page = text_of(panel)
    opened.saveCopy(str(tmp_path / "again.FCStd"))
    again = FreeCAD.openDocument(str(tmp_path / "again.FCStd"))
    try:
        window.wait(lambda: len(labels(panel)) == len(before["Operation"]))
        window.settle()
        assert {title: column(panel, title) for title in FIRST} == before
        click_row(window, panel, label)
        # Compare only the text before "Cutting Length", because marks store no cutting lengths.
        assert text_of(panel).split("Cutting Length")[0] == page.split("Cutting Length")[0]
        window.screenshot("panel-from-marks")
        assert "Rapid Length" not in text_of(panel)
        window.click("Analyze Toolpaths")  # analyse the selected operation, to get the numbers that no mark stores
        window.wait(lambda: "Rapid Length" in text_of(panel), 10)
        window.answer_file_dialog(tmp_path / "results.csv", panel.csv.trigger)
        with open(tmp_path / "results.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        assert [row["label"] for row in rows] == [o.label for o in vkworkbench.analyze(again).operations]
    finally:
        FreeCAD.closeDocument(again.Name)
        FreeCAD.setActiveDocument(opened.Name)


@pytest.mark.long
def test_z_buffer_total_is_the_same_everywhere(opened, window, tmp_path):
    """Report, mark, panel and details show the same z-buffer total, also after reopening the document."""
    results, again = None, None
    preferences.write(mark_simulator="z-buffer")
    try:
        window.click("Analyze Toolpaths")
        window.wait(lambda: marks.is_marked(opened.Job))
        results = window.show_results()
        report = vkworkbench.analyze(opened)
        (total,) = report.totals
        told = user().estimated_time(total.seconds, total.factor("z-buffer"))
        assert total.seconds < sum(o.estimate.seconds for o in report.operations if o.counted)
        assert marks.read(opened.getObject("Job")).cost("z-buffer") == total.cost("z-buffer")
        click_row(window, results, "Job")
        title = "Simulate Toolpaths Memory"
        memory = column(results, title)["Job"]
        assert column(results, "Simulation Time")["Job"] == told and told in text_of(results)
        assert memory == user().memory(total.memory_bytes)
        again = tmp_path / "again.FCStd"
        opened.saveCopy(str(again))
        again = FreeCAD.openDocument(str(again))
        window.wait(lambda: FreeCAD.ActiveDocument.Name == again.Name and len(labels(results)) > 3)
        window.settle()
        assert column(results, "Simulation Time")["Job"] == told
        assert column(results, title)["Job"] == memory
    finally:
        preferences.write(mark_simulator="own")
        if again is not None:
            FreeCAD.closeDocument(again.Name)
            FreeCAD.setActiveDocument(opened.Name)
        if results is not None:
            results.hide()
        window.settle()


@pytest.mark.long
def test_cleared_results_are_not_shown(panel, opened, window):
    window.click("Clear Analysis")
    window.wait(lambda: labels(panel) == [])
    Gui.runCommand("Std_Undo")
    window.wait(lambda: len(labels(panel)) > 3)


def test_length_above_ten_metres_is_shown_in_metres():
    assert (user().length(9_999.0), user().length(318_629.67)) == ("9,999.00 mm", "319 m")


@pytest.mark.parametrize(("title", "name"), [("Machi-\nning\nTime", "Machining Time"), ("加工\n时间", "加工时间")])
def test_name_of_a_column_is_its_title_without_line_breaks(title, name):
    assert Column("key", title, "", None).name == name


def test_details_without_a_document_show_a_hint(window):
    assert not FreeCAD.listDocuments()
    document = FreeCAD.newDocument("Empty")
    window.activate("VkWorkbench")
    window.click("Toolpath Results")
    window.wait(lambda: dock(window) is not None and dock(window).isVisible())
    window.wait(lambda: text_of(dock(window)).startswith("Nothing is analyzed in this document yet"))
    FreeCAD.closeDocument(document.Name)
    window.wait(lambda: text_of(dock(window)).startswith("No document is open."))
    dock(window).hide()


@pytest.mark.long
def test_machining_and_simulation_times_agree_everywhere(panel, opened, window, tmp_path):
    """Mark, tooltip, list, details, warning, table and CSV show the same times, rounded in the same way."""
    report, chosen = vkworkbench.analyze(opened), preferences.read()
    window.answer_file_dialog(tmp_path / "results.csv", panel.csv.trigger)
    rows = {row["label"]: row for row in csv.DictReader(open(tmp_path / "results.csv", encoding="utf-8"))}
    machining, simulating = column(panel, "Machining Time"), column(panel, "Simulation Time")
    for o in [*report.operations, *report.totals]:
        record = marks.read(labelled(opened, o.label))
        cost, factor = record.cost(chosen.simulator)[0], record.factor(chosen.simulator)
        time, estimate = user().clock(record.machining_seconds), user().estimated_time(cost, factor)
        click_row(window, panel, o.label)
        told = [o.label, record.text, explanation(record, chosen), text_of(panel), str(report)]
        assert all(time in text for text in told[1:]) and machining[o.label].split()[-1] == time, o.label
        assert all(estimate in text for text in told[1:]) and simulating[o.label] == estimate, o.label
        longer = too_long(record, chosen)
        assert longer is None or estimate in render(longer)
        if o.label in rows:
            assert user().clock(float(rows[o.label]["machining_seconds"])) == time
            assert (
                user().estimated_time(float(rows[o.label][f"{chosen.simulator.lower()}_seconds"]), factor) == estimate
            )
