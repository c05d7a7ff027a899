# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Description column of FreeCAD's tree, where the marks are read."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import contextmanager

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import freecad
from vkworkbench.gui.qt import widgets
from vkworkbench.gui.qt.names import QEvent, QHeaderView, QObject, Qt, QTabWidget, QTimer, QTreeView, single_shot

DESCRIPTION = 1
_TREE_PREFERENCES = "User parameter:BaseApp/Preferences/TreeView"
_DOCK_WIDTH = 36  # lines of the tree's letters, 500 px of the usual ones; in FreeCAD's 260 the column is out of sight
_NAMES_WIDTH = 18  # lines, half of it
_BOUND = "VkNamesBound"  # the property of a tree whose first column follows its contents no longer
_MOST_OF_WINDOW = 0.45  # the rest is the 3D view's

_trees: list[QTreeView] = []  # kept, and with them what they were asked for


def trees() -> list[QTreeView]:
    """Return FreeCAD's document trees."""
    _trees[:] = [view for view in widgets.find(QTreeView) if view.metaObject().className() == "Gui::TreeWidget"]
    return list(_trees)


class _Sight(QObject):
    """Waits until one of the trees is painted, and does then what it was asked to, once."""

    def __init__(self, work: Callable[[], object]) -> None:
        super().__init__(Gui.getMainWindow())
        self._work = work
        self._seen = single_shot(self._do, self)  # its dock has its size then
        for view in trees():
            view.viewport().installEventFilter(self)

    def eventFilter(self, viewport, event) -> bool:
        if event.type() == QEvent.Paint:  # one that is shown behind a tab is not painted
            self._seen.start()
        return False

    def _do(self) -> None:
        for view in trees():
            view.viewport().removeEventFilter(self)
        self.deleteLater()
        self._work()


def is_seen(view: QTreeView) -> bool:
    """Whether the user sees a tree: it is in no closed dock and behind no tab."""
    return view.isVisible() and not view.visibleRegion().isEmpty()


def when_seen(work: Callable[[], object]) -> None:
    """Do something as soon as a tree is seen: after this event, or where all are hidden when one is shown."""
    if any(map(is_seen, trees())):
        QTimer.singleShot(0, work)
    else:
        _Sight(work)


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
    line = max((tree.fontMetrics().lineSpacing() for tree in trees()), default=0)
    width = min(_DOCK_WIDTH * line, int(_MOST_OF_WINDOW * window.width()))
    for dock in widgets.docks():
        if dock.objectName() in freecad.TREE_DOCKS and dock.isVisible() and dock.width() < width:
            if dock.isFloating():
                dock.resize(width, dock.height())
            else:
                window.resizeDocks([dock], [width], Qt.Horizontal)
    return was_hidden


def bring_to_view() -> None:
    """Bring a tree that a tab hides before it; a task that is being edited stays, and so does a closed dock."""
    if Gui.Control.activeDialog() or any(map(is_seen, trees())):
        return
    for dock in widgets.docks():
        for tree in trees():
            if dock.toggleViewAction().isChecked() and dock.isAncestorOf(tree):
                dock.raise_()
                for tabs in widgets.find(QTabWidget):
                    pages = [tabs.widget(i) for i in range(tabs.count()) if tabs.widget(i).isAncestorOf(tree)]
                    if pages:
                        tabs.setCurrentWidget(pages[0])


def fit_description(least: int) -> None:
    """Fit the columns of the trees to the visible rows, the Description to at least so many px; 1.x does it by itself.

    A very long name gives way: FreeCAD makes the first column as wide as it, and the marks would be out of sight.
    """
    for tree in trees():
        header = tree.header()
        precision = header.resizeContentsPrecision()
        for column in (0, DESCRIPTION):
            if header.sectionResizeMode(column) != QHeaderView.ResizeToContents:
                # Only for now: columns that follow their contents would follow the visible rows then, which change with the
                # scroll bar that they need or not, without end.
                header.setResizeContentsPrecision(0)
                tree.resizeColumnToContents(column)
                header.setResizeContentsPrecision(precision)
                if column == DESCRIPTION and tree.columnWidth(column) < least:
                    tree.setColumnWidth(column, least)
        _bound_names(tree, least)


def _bound_names(tree: QTreeView, least: int) -> None:
    """Leave the Description so many px of a tree, as long as there is room for names as usual; wider the user may make it."""
    header, line = tree.header(), tree.fontMetrics().lineSpacing()
    most = max(tree.viewport().width() - least, _NAMES_WIDTH * line)
    if tree.sizeHintForColumn(0) > most:
        if header.sectionResizeMode(0) == QHeaderView.ResizeToContents:
            header.setSectionResizeMode(0, QHeaderView.Interactive)
            tree.setProperty(_BOUND, True)
        tree.setColumnWidth(0, most)
    elif tree.property(_BOUND):
        header.setSectionResizeMode(0, QHeaderView.ResizeToContents)
        tree.setProperty(_BOUND, False)


def expand(label: str, document: str) -> None:
    """Open the branch of a job in a document, by their labels, and that of its operations, which is the first in it."""
    for view in trees():
        model = view.model()
        for index in model.match(model.index(0, 0), Qt.DisplayRole, label, -1, Qt.MatchExactly | Qt.MatchRecursive):
            above = [index]
            while above[-1].parent().isValid():
                above.append(above[-1].parent())
            if any(one.data() == document for one in above):
                for one in (*reversed(above), model.index(0, 0, index)):
                    view.expand(one)


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
