# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find widgets of FreeCAD without keeping them alive.

PySide keeps every widget that `findChild` returns until the parent is deleted, and the main window is never deleted. A
simulator's panel that was found by `findChild` would be kept after it is closed. PySide would take a later widget at
the same address for the panel, and FreeCAD could not open its simulator again. Therefore `findChild` is used only for
widgets that live as long as the window, and no widget of FreeCAD is asked for its parent. The function `find` searches
all widgets of the application instead.

Conversely, PySide deletes the Python wrapper of a child when the wrapper of its parent is deleted. Therefore a module
that uses a child keeps a reference to the parent.
"""

from __future__ import annotations

import FreeCADGui as Gui

from vkworkbench.gui.qt.names import QApplication, QDockWidget, QMdiArea, QWidget


def find(kind: type[QWidget], name: str | None = None) -> list:
    """Return all widgets of a class, or only the widgets with this object name."""
    return [
        widget
        for widget in QApplication.allWidgets()
        if isinstance(widget, kind) and (name is None or widget.objectName() == name)
    ]


def docks() -> list[QDockWidget]:
    """Return the docks of FreeCAD's window, which live as long as the window."""
    return Gui.getMainWindow().findChildren(QDockWidget)


def area_of_views() -> QMdiArea:
    """Return the area in which FreeCAD shows its 3D views."""
    return Gui.getMainWindow().findChild(QMdiArea)
