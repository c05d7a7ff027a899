# SPDX-License-Identifier: LGPL-2.1-or-later
"""The add-on's docks at the bottom of the window, as tabs: there is no room for them side by side."""

from __future__ import annotations

import FreeCADGui as Gui

from vkworkbench.gui.qt import QDockWidget, Qt

RESULTS, GAUSS_MAP = "VkResults", "VkGaussMap"


def find(name: str) -> QDockWidget | None:
    """Return the dock of that name, None until it is first shown."""
    return Gui.getMainWindow().findChild(QDockWidget, name)


def add(dock: QDockWidget, height: int) -> None:
    """Put a new dock at the bottom, as a tab where another of ours is there, and show it `height` px high."""
    window = Gui.getMainWindow()
    others = [other for other in map(find, (RESULTS, GAUSS_MAP)) if other is not None and other is not dock]
    window.addDockWidget(Qt.BottomDockWidgetArea, dock)
    for other in others:
        if window.dockWidgetArea(other) == Qt.BottomDockWidgetArea and not other.isFloating():
            window.tabifyDockWidget(other, dock)
    show(dock)
    window.resizeDocks([dock], [height], Qt.Vertical)


def show(dock: QDockWidget) -> None:
    """Show a dock in front of those it shares its place with."""
    dock.show()
    dock.raise_()


def is_seen(dock: QDockWidget) -> bool:
    """Whether the user sees the dock: it is neither closed nor behind another one."""
    return dock.isVisible() and not dock.visibleRegion().isEmpty()
