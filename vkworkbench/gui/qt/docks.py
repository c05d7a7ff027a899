# SPDX-License-Identifier: LGPL-2.1-or-later
"""The add-on's docks at the bottom of the window, as tabs of what is there: side by side there is no room."""

from __future__ import annotations

import FreeCADGui as Gui

from vkworkbench.gui.qt import widgets
from vkworkbench.gui.qt.names import QDockWidget, Qt

RESULTS, GAUSS_MAP = "VkResults", "VkGaussMap"


def find(name: str) -> QDockWidget | None:
    """Return the dock of that name, None until it is first shown."""
    return next((dock for dock in widgets.docks() if dock.objectName() == name), None)


def add(dock: QDockWidget, height: int) -> None:
    """Put a new dock at the bottom, as a tab where another dock is there, and show it `height` px high.

    That is at most a third of the window, most of which is the 3D view's.
    """
    window = Gui.getMainWindow()
    others = _at_the_bottom(dock)
    window.addDockWidget(Qt.BottomDockWidgetArea, dock)
    _join(dock, others)
    for other in others:
        if other.objectName() in (RESULTS, GAUSS_MAP) and other.isHidden():  # once it is shown, it is a tab, too
            window.tabifyDockWidget(dock, other)
    show(dock)
    window.resizeDocks([dock], [min(height, window.height() // 3)], Qt.Vertical)


def show(dock: QDockWidget) -> None:
    """Show a dock in front of those it shares its place with; what was opened since it was closed is one of them."""
    window = Gui.getMainWindow()
    if dock.isHidden() and not dock.isFloating() and window.dockWidgetArea(dock) == Qt.BottomDockWidgetArea:
        _join(dock, _at_the_bottom(dock))
    dock.show()
    dock.raise_()


def _at_the_bottom(dock: QDockWidget) -> list[QDockWidget]:
    """Return the other docks at the bottom, hidden ones too."""
    window = Gui.getMainWindow()
    return [
        other for other in widgets.docks()
        if other is not dock and not other.isFloating() and window.dockWidgetArea(other) == Qt.BottomDockWidgetArea
    ]  # fmt: skip


def _join(dock: QDockWidget, others: list[QDockWidget]) -> None:
    """Make a dock a tab of one that is seen, of several that with the most room: FreeCAD's report view, for example."""
    seen = [other for other in others if not other.isHidden()]
    if seen and not set(seen) & set(Gui.getMainWindow().tabifiedDockWidgets(dock)):
        Gui.getMainWindow().tabifyDockWidget(max(seen, key=lambda other: other.width()), dock)


def is_seen(dock: QDockWidget) -> bool:
    """Whether the user sees the dock: it is neither closed nor behind another one."""
    return dock.isVisible() and not dock.visibleRegion().isEmpty()
