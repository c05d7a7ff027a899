# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widgets of FreeCAD, found without keeping them.

What PySide finds among a widget's children it keeps until that widget is gone, and the main window never goes: the panel
of a simulator found there would be kept after it is closed, what Qt makes at its address later would be taken for it,
and FreeCAD could not open its simulator any more. So only what lives as long as the window is looked for among its
children, and nothing of FreeCAD's is asked for its parent. All widgets are some hundreds: to go through them takes 1 ms.

The other way round, what a widget was asked for is gone for Python when Python lets go of the widget: keep it meanwhile.
"""

from __future__ import annotations

import FreeCADGui as Gui

from vkworkbench.gui.qt.names import QApplication, QDockWidget, QMdiArea, QWidget


def find(kind: type[QWidget], name: str | None = None) -> list:
    """Return the widgets of a kind that there are, of this object name if one is given."""
    return [
        widget
        for widget in QApplication.allWidgets()
        if isinstance(widget, kind) and (name is None or widget.objectName() == name)
    ]


def docks() -> list[QDockWidget]:
    """Return the docks of FreeCAD's window, which live as long."""
    return Gui.getMainWindow().findChildren(QDockWidget)


def area_of_views() -> QMdiArea:
    """Return what FreeCAD shows its 3D views in."""
    return Gui.getMainWindow().findChild(QMdiArea)
