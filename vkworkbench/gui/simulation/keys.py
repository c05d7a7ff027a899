# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keys of a widget that FreeCAD has as shortcuts of its own."""

from __future__ import annotations

from collections.abc import Callable

from vkworkbench.gui.qt.names import QEvent, QWidget


class KeyedWidget(QWidget):
    """A widget with keys: each calls its function while the widget, or one in it that ignores the key, has the focus.

    Attributes
    ----------
    keys : dict of int to callable
    """

    keys: dict[int, Callable[[], object]]

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.keys = {}

    def event(self, event) -> bool:
        if event.type() == QEvent.ShortcutOverride and event.key() in self.keys:
            event.accept()  # before FreeCAD takes the key for a command of its own
            return True
        return super().event(event)

    def keyPressEvent(self, event) -> None:
        if event.key() in self.keys:
            self.keys[event.key()]()
        else:
            super().keyPressEvent(event)
