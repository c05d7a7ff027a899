# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first marks in the tree are visible, even in a hidden, narrow or floating tree and in a small window."""

import FreeCAD
import FreeCADGui as Gui
import numpy as np
import pytest
from pictures import shows
from PySide import QtCore, QtGui

from vkworkbench import freecad
from vkworkbench.document.marks import marks
from vkworkbench.gui.qt import widgets
from vkworkbench.gui.tree import column as tree


@pytest.fixture
def untouched(opened, window):
    """The window before the first analysis, with a narrow tree and (in FreeCAD 1.x) a hidden Description column."""
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/VkWorkbench").RemBool("DescriptionShown")
    if freecad.version() >= freecad.DESCRIPTION_HIDDEN_SINCE:
        FreeCAD.ParamGet("User parameter:BaseApp/Preferences/TreeView").SetBool("HideColumn", True)
    (dock,) = [d for d in window.find(QtGui.QDockWidget) if d.isVisible() and d.isAncestorOf(window.tree)]
    window.main.resizeDocks([dock], [220], QtCore.Qt.Horizontal)
    window.settle()
    yield dock
    dock.setFloating(False)
    dock.show()
    dock.raise_()
    window.main.setGeometry(0, 0, 1280, 1000)
    window.settle()


def view_of_tree(window):
    """Return how many rows of the tree are visible."""
    return window.tree.viewport().height() / window.tree.visualRect(window.cell("Face")).height()


def assert_marks_are_seen(window, document, labels=("Face", "Adaptive pocket")):
    """Assert that the strategies and times of some operations are in the visible part of the tree."""
    view = window.tree
    assert not view.isColumnHidden(1)
    for label in labels:
        view.scrollTo(window.cell(label))
        window.settle()
        area = view.visualRect(window.cell(label)) & view.viewport().rect()
        image = view.viewport().grab(area).toImage()
        color = marks.read(document.getObjectsByLabel(label)[0]).strategy.color
        columns = np.flatnonzero(shows(image, color).any(axis=0))
        assert len(columns) > 20, label
        assert columns[-1] < image.width() - 30, label  # right of the pill, the column has room for the time


def test_first_marks_are_visible_in_a_narrow_dock(untouched, opened, window):
    assert untouched.width() < 300
    precision = window.tree.header().resizeContentsPrecision()
    window.analyze(opened)
    window.dismiss()
    # A precision of 0 (visible rows only) makes FreeCAD 1.0's tree lay itself out endlessly in a small window.
    assert window.tree.header().resizeContentsPrecision() == precision != 0
    window.tree.expandAll()
    assert_marks_are_seen(window, opened)
    window.screenshot("first-narrow-dock")


@pytest.mark.long
def test_first_marks_are_visible_in_a_large_font(untouched, opened, window):
    window.main.setGeometry(0, 0, 1700, 1000)  # px, with room for the tree beside the 3D view
    view, usual = window.tree, window.tree.font()
    large = QtGui.QFont(usual)
    large.setPointSizeF(1.5 * usual.pointSizeF())
    view.setFont(large)
    window.settle()
    try:
        window.analyze(opened)
        window.dismiss()
        view.expandAll()
        window.settle()
        for label in ("Face", "Adaptive pocket"):
            index = window.cell(label)
            needed = view.visualRect(index).left() + view.sizeHintForIndex(index).width()
            assert needed <= view.viewport().width(), label  # the whole text of the mark fits in the tree
        window.screenshot("first-large-letters")
    finally:
        view.setFont(usual)


def test_first_marks_are_visible_when_a_hidden_tree_is_shown(untouched, opened, window):
    untouched.hide()
    window.settle()
    window.analyze(opened)
    assert window.dismiss() == []  # the analysis shows no message although the tree is hidden
    untouched.show()
    untouched.raise_()  # raise the tree above the task panel, which can be a tab in the same place
    window.wait(lambda: untouched.width() > 300)
    window.dismiss()
    window.tree.expandAll()
    assert_marks_are_seen(window, opened)
    window.screenshot("first-hidden-combo-view")
    untouched.hide()  # showing the dock again must not change the width that the user chooses below
    window.main.resizeDocks([untouched], [250], QtCore.Qt.Horizontal)
    untouched.show()
    window.settle()
    assert window.boxes() == []


def test_first_marks_are_visible_in_a_floating_dock(untouched, opened, window):
    untouched.setFloating(True)
    untouched.resize(240, 400)
    window.settle()
    window.analyze(opened)
    window.dismiss()
    window.tree.expandAll()
    assert_marks_are_seen(window, opened)


def test_first_marks_are_visible_in_a_small_window(untouched, opened, window):
    report = window.first(QtGui.QDockWidget, "Report view")
    window.main.addDockWidget(QtCore.Qt.BottomDockWidgetArea, report)
    report.show()
    window.main.setGeometry(0, 0, 1024, 700)
    window.settle()
    try:
        window.analyze(opened)
        window.dismiss()
        window.tree.expandAll()
        assert_marks_are_seen(window, opened)
        assert window.main.width() <= 1024 and window.main.height() <= 700
        view = widgets.area_of_views()
        assert view.width() > 0.4 * window.main.width()  # the wider tree leaves enough room for the 3D view
        assert not any(one.isVisible() for one in window.find(QtGui.QDockWidget, "VkResults"))
        results, height = window.show_results(), view_of_tree(window)
        assert height >= 8
        # The results panel is a tab with the report view, even if it was closed when the report view was opened.
        assert results in window.main.tabifiedDockWidgets(report)
        window.screenshot("first-1024-results")
    finally:
        report.hide()


@pytest.mark.long
def test_marks_of_sixty_operations_are_seen_in_a_small_window(untouched, opened, window):
    pocket = opened.getObjectsByLabel("Pocket zigzag")[0]
    copies = [opened.addObject("Path::FeaturePython", "Copy") for _ in range(60)]
    for number, copy in enumerate(copies, 1):
        copy.Label, copy.Path = f"Pocket {number}", pocket.Path
        copy.addProperty("App::PropertyLink", "ToolController", "Path").ToolController = pocket.ToolController
    opened.Job.Operations.Group += copies
    window.main.setGeometry(0, 0, 1024, 700)
    window.settle()
    window.analyze(opened)
    window.dismiss()
    window.tree.expandAll()
    assert_marks_are_seen(window, opened, ("Face", "Pocket 1", "Pocket 30", "Pocket 60"))
    assert view_of_tree(window) >= 8 and window.main.height() <= 700
    window.screenshot("first-sixty")


@pytest.mark.long
def test_job_is_expanded_only_by_the_first_analysis(untouched, opened, window):
    window.tree.collapseAll()
    window.analyze(opened)
    window.dismiss()
    job = window.cell("Job")
    operations = window.cell("Face").parent()
    assert window.tree.isExpanded(job.sibling(job.row(), 0)) and window.tree.isExpanded(operations)
    window.tree.collapseAll()  # later analyses keep what the user has collapsed
    window.click("Analyze Toolpaths")
    window.settle()
    assert not window.tree.isExpanded(window.cell("Face").parent())


def test_tree_in_a_hidden_tab_is_brought_to_the_front(untouched, opened, window):
    tabs = [t for t in window.find(QtGui.QTabWidget) if t.isAncestorOf(window.tree)]
    if tabs:
        (tabs,) = tabs
        tabs.setCurrentIndex((tabs.currentIndex() + 1) % tabs.count())
        window.settle()
        assert not any(map(tree.is_seen, tree.trees()))
    window.analyze(opened)
    window.dismiss()
    assert any(map(tree.is_seen, tree.trees()))
    Gui.Selection.clearSelection()
