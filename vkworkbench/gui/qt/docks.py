# SPDX-License-Identifier: LGPL-2.1-or-later
"""The add-on's docks at the bottom of FreeCAD's window. The docks are tabs, because they do not fit side by side."""

from __future__ import annotations

import FreeCADGui as Gui

from vkworkbench import freecad
from vkworkbench.gui.qt import widgets
from vkworkbench.gui.qt.names import QDockWidget, Qt

RESULTS, GAUSS_MAP = "VkResults", "VkGaussMap"


def find(name: str) -> QDockWidget | None:
    """Return the dock with this Qt object name; None if it was never shown."""
    return next((dock for dock in widgets.docks() if dock.objectName() == name), None)


def add(dock: QDockWidget, height: int) -> None:
    """Show a new dock at the bottom of the window, as a tab if another dock is there; see `show`."""
    window = Gui.getMainWindow()
    others = _at_the_bottom(dock)
    window.addDockWidget(Qt.BottomDockWidgetArea, dock)
    _join(dock, others)
    for other in others:
        if other.objectName() in (RESULTS, GAUSS_MAP) and other.isHidden():  # a dock opened later must be a tab, too
            window.tabifyDockWidget(dock, other)
    show(dock, height)


def make_room(height: int) -> None:
    """Make the add-on's docks as low as possible if the 3D view and other tabs are lower than `height` px."""
    window = Gui.getMainWindow()
    bottom = [
        dock for dock in map(find, (RESULTS, GAUSS_MAP))
        if dock is not None and not dock.isHidden() and not dock.isFloating()
        and window.dockWidgetArea(dock) == Qt.BottomDockWidgetArea
    ]  # fmt: skip
    if bottom and widgets.area_of_views().height() < height:
        window.resizeDocks(bottom, [1] * len(bottom), Qt.Vertical)


def show(dock: QDockWidget, height: int) -> None:
    """Show a dock in front of all tabs, even if another dock was opened at its place while it was closed.

    A dock at the bottom becomes `height` px high if it was lower, but at most a third of the window's height, to leave
    room for the 3D view. A simulation tab may have made the dock lower.
    """
    window = Gui.getMainWindow()
    _keep_tree_high()
    if dock.isHidden() and not dock.isFloating() and window.dockWidgetArea(dock) == Qt.BottomDockWidgetArea:
        _join(dock, _at_the_bottom(dock))
    dock.show()
    dock.raise_()
    height = min(height, window.height() // 3)
    if dock.height() < height and not dock.isFloating() and window.dockWidgetArea(dock) == Qt.BottomDockWidgetArea:
        window.resizeDocks([dock], [height], Qt.Vertical)


def _keep_tree_high() -> None:
    """Give the dock of the tree the whole height of the window, so that docks at the bottom do not extend below it."""
    window = Gui.getMainWindow()
    corners = {Qt.LeftDockWidgetArea: Qt.BottomLeftCorner, Qt.RightDockWidgetArea: Qt.BottomRightCorner}
    for dock in widgets.docks():
        area = window.dockWidgetArea(dock)
        if dock.objectName() in freecad.TREE_DOCKS and area in corners and not dock.isFloating():
            window.setCorner(corners[area], area)


def _at_the_bottom(dock: QDockWidget) -> list[QDockWidget]:
    """Return the docks at the bottom of the window, including hidden docks but without this dock."""
    window = Gui.getMainWindow()
    return [
        other for other in widgets.docks()
        if other is not dock and not other.isFloating() and window.dockWidgetArea(other) == Qt.BottomDockWidgetArea
    ]  # fmt: skip


def _join(dock: QDockWidget, others: list[QDockWidget]) -> None:
    """Make a dock a tab of the widest visible dock, for example FreeCAD's report view."""
    seen = [other for other in others if not other.isHidden()]
    if seen and not set(seen) & set(Gui.getMainWindow().tabifiedDockWidgets(dock)):
        Gui.getMainWindow().tabifyDockWidget(max(seen, key=lambda other: other.width()), dock)


def has_focus(dock: QDockWidget | None) -> bool:
    """Return whether a dock is visible and contains the widget with the keyboard focus."""
    if dock is None or not dock.isVisible():
        return False
    focus = dock.window().focusWidget()
    return focus is not None and dock.isAncestorOf(focus)
