# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Description column of FreeCAD's tree, which shows the marks."""

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
# Width of the tree's dock, and maximum width of the column with names, as multiples of the line height in the tree. 36
# line heights are about 500 px; in FreeCAD's default width of 260 px the Description column is not visible.
_DOCK_WIDTH = 36
_NAMES_WIDTH = 18
_LIMITED = "VkNamesBound"  # Qt property of a tree whose first column has a fixed width instead of an automatic width
_MAX_SHARE = (
    0.45  # maximum width of the dock, as a share of the window's width; a wider dock leaves the 3D view too little
)

_trees: list[QTreeView] = []  # references that keep the Python wrappers of the trees' children alive


def trees() -> list[QTreeView]:
    """Return FreeCAD's document trees."""
    _trees[:] = [view for view in widgets.find(QTreeView) if view.metaObject().className() == "Gui::TreeWidget"]
    return list(_trees)


class _Sight(QObject):
    """Calls a function once, as soon as one of the trees is painted."""

    def __init__(self, work: Callable[[], object]) -> None:
        super().__init__(Gui.getMainWindow())
        self._work = work
        self._seen = single_shot(self._do, self)  # delayed until the dock of the tree has its final size
        for view in trees():
            view.viewport().installEventFilter(self)

    def eventFilter(self, viewport, event) -> bool:
        if event.type() == QEvent.Paint:  # a tree behind another tab is not painted
            self._seen.start()
        return False

    def _do(self) -> None:
        for view in trees():
            view.viewport().removeEventFilter(self)
        self.deleteLater()
        self._work()


def is_seen(view: QTreeView) -> bool:
    """Return whether a tree is visible: neither in a closed dock nor behind a tab."""
    return view.isVisible() and not view.visibleRegion().isEmpty()


def when_seen(work: Callable[[], object]) -> None:
    """Call a function after this event if a tree is visible, otherwise as soon as one becomes visible."""
    if any(map(is_seen, trees())):
        QTimer.singleShot(0, work)
    else:
        _Sight(work)


def show_description() -> None:
    """Show the Description column, and widen the dock of the tree so that the column can be read."""
    preferences = FreeCAD.ParamGet(_TREE_PREFERENCES)
    # FreeCAD before 1.0 has no such preference and always shows the column.
    if freecad.version() >= freecad.DESCRIPTION_HIDDEN_SINCE and preferences.GetBool("HideColumn", True):
        preferences.SetBool("HideColumn", False)
    for tree in trees():
        tree.setColumnHidden(DESCRIPTION, False)
        tree.header().setVisible(True)
    window = Gui.getMainWindow()
    line = max((tree.fontMetrics().lineSpacing() for tree in trees()), default=0)
    width = min(_DOCK_WIDTH * line, int(_MAX_SHARE * window.width()))
    for dock in widgets.docks():
        if dock.objectName() in freecad.TREE_DOCKS and dock.isVisible() and dock.width() < width:
            if dock.isFloating():
                dock.resize(width, dock.height())
            else:
                window.resizeDocks([dock], [width], Qt.Horizontal)


def bring_to_view() -> None:
    """Bring FreeCAD's tree in front of other tabs, unless a task dialog is open or the tree's dock is closed."""
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
    """Fit the columns of the trees to the visible rows; the Description column gets at least `least` px.

    FreeCAD 1.x fits columns automatically. FreeCAD 1.x also makes the first column as wide as the longest name, which
    would hide the marks; therefore the first column is limited.
    """
    for tree in trees():
        header = tree.header()
        precision = header.resizeContentsPrecision()
        for column in (0, DESCRIPTION):
            if header.sectionResizeMode(column) != QHeaderView.ResizeToContents:
                # Let Qt measure only the visible rows (precision 0), but only during this call. With precision 0
                # always, a column with an automatic width would follow the visible rows, which change with the scroll
                # bar, in an endless loop.
                header.setResizeContentsPrecision(0)
                tree.resizeColumnToContents(column)
                header.setResizeContentsPrecision(precision)
                if column == DESCRIPTION and tree.columnWidth(column) < least:
                    tree.setColumnWidth(column, least)
        _limit_names(tree, least)


def _limit_names(tree: QTreeView, least: int) -> None:
    """Limit the width of the column with names so that the Description column gets `least` px.

    The column with names keeps at least the width `_NAMES_WIDTH`, if the names need it.
    """
    header, line = tree.header(), tree.fontMetrics().lineSpacing()
    most = max(tree.viewport().width() - least, _NAMES_WIDTH * line)
    if tree.sizeHintForColumn(0) > most:
        if header.sectionResizeMode(0) == QHeaderView.ResizeToContents:
            header.setSectionResizeMode(0, QHeaderView.Interactive)
            tree.setProperty(_LIMITED, True)
        tree.setColumnWidth(0, most)
    elif tree.property(_LIMITED):
        header.setSectionResizeMode(0, QHeaderView.ResizeToContents)
        tree.setProperty(_LIMITED, False)


def expand(label: str, document: str) -> None:
    """Expand the job with this label in a document, and the first branch of the job, its operations."""
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
    """Context in which FreeCAD does not lay out its trees again after each changed text.

    Without this context, changing 200 marks takes 1 s longer in FreeCAD 1.x.
    """
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
