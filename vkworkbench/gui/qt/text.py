# SPDX-License-Identifier: LGPL-2.1-or-later
"""Translation of what the user reads, under the name that Qt's lupdate looks for; and widgets without a text of their own."""

from __future__ import annotations

from typing import TYPE_CHECKING

import FreeCAD

if TYPE_CHECKING:
    from vkworkbench.gui.qt.names import QWidget

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP  # for texts that FreeCAD translates itself


def explain(widget: QWidget, text: str) -> None:
    """Say what a widget without a text of its own is for: by its tool tip, and to screen readers, which take no name from that."""
    widget.setToolTip(text)
    widget.setAccessibleName(text)
