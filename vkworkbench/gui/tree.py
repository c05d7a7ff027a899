# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Description column of FreeCAD's tree, where the marks are read."""

from __future__ import annotations

from contextlib import contextmanager

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import freecad
from vkworkbench.gui.qt import QDockWidget, QHeaderView, Qt, QTabWidget, QTreeView

DESCRIPTION = 1
_TREE_PREFERENCES = "User parameter:BaseApp/Preferences/TreeView"
_DOCK_WIDTH = 500  # px; with FreeCAD's 260 the column would be out of sight


def trees() -> list[QTreeView]:
    """Return FreeCAD's document trees."""
    views = Gui.getMainWindow().findChildren(QTreeView)
    return [view for view in views if view.metaObject().className() == "Gui::TreeWidget"]


def show_description() -> bool:
    """Make the Description column visible and wide enough to read; return whether it was hidden."""
    preferences = FreeCAD.ParamGet(_TREE_PREFERENCES)
    # Before 1.0 there was no such preference: the column was always visible.
    can_hide = freecad.version() >= freecad.DESCRIPTION_HIDDEN_SINCE
    was_hidden = can_hide and preferences.GetBool("HideColumn", True)
    if was_hidden:
        preferences.SetBool("HideColumn", False)
    for tree in trees():
        tree.setColumnHidden(DESCRIPTION, False)
        tree.header().setVisible(True)
    window = Gui.getMainWindow()
    for dock in window.findChildren(QDockWidget):
        if dock.objectName() in freecad.TREE_DOCKS and dock.isVisible() and dock.width() < _DOCK_WIDTH:
            window.resizeDocks([dock], [_DOCK_WIDTH], Qt.Horizontal)
    return was_hidden


def bring_to_view() -> None:
    """Bring a tree that a tab hides before it; a task that is being edited stays, and so does a closed dock."""
    if Gui.Control.activeDialog() or any(not tree.visibleRegion().isEmpty() for tree in trees()):
        return
    for dock in Gui.getMainWindow().findChildren(QDockWidget):
        for tree in trees():
            if dock.toggleViewAction().isChecked() and dock.isAncestorOf(tree):
                dock.raise_()
                for tabs in dock.findChildren(QTabWidget):
                    pages = [tabs.widget(i) for i in range(tabs.count()) if tabs.widget(i).isAncestorOf(tree)]
                    if pages:
                        tabs.setCurrentWidget(pages[0])


def fit_description() -> None:
    """Fit the columns of the trees to the visible rows; 1.x does that by itself."""
    for tree in trees():
        tree.header().setResizeContentsPrecision(0)
        for column in (0, DESCRIPTION):
            if tree.header().sectionResizeMode(column) != QHeaderView.ResizeToContents:
                tree.resizeColumnToContents(column)


@contextmanager
def steady_columns():
    """Keep the trees from a new layout after each changed text, which takes 1 s for 200 marks in 1.x."""
    views = trees()
    modes = [[view.header().sectionResizeMode(i) for i in range(view.header().count())] for view in views]
    uniform = [view.uniformRowHeights() for view in views]
    for view in views:
        view.header().setSectionResizeMode(QHeaderView.Fixed)
        view.setUniformRowHeights(True)
    try:
        yield
    finally:
        for view, sections, heights in zip(views, modes, uniform):
            view.setUniformRowHeights(heights)
            for i, mode in enumerate(sections):
                view.header().setSectionResizeMode(i, mode)
