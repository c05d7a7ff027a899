# SPDX-License-Identifier: LGPL-2.1-or-later
"""A button that opens a menu."""

from __future__ import annotations

from vkworkbench.gui.qt.names import QMenu, QSize, QStyle, QToolButton


class MenuButton(QToolButton):
    """Opens its menu at a click, and has room for the arrow: Qt leaves none, FreeCAD 1.1's theme draws it over the text."""

    def __init__(self, text: str, menu: QMenu | None = None) -> None:
        super().__init__()
        self.setText(text)
        self.setPopupMode(QToolButton.InstantPopup)
        self.setMenu(menu or QMenu(self))

    def sizeHint(self) -> QSize:
        arrow = self.style().pixelMetric(QStyle.PM_MenuButtonIndicator)  # of this widget the theme's style sheet says 0
        return super().sizeHint() + QSize(arrow, 0)
