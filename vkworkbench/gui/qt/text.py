# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions for translations, with the names that Qt's lupdate searches, and for describing widgets without text."""

from __future__ import annotations

from typing import TYPE_CHECKING

import FreeCAD

if TYPE_CHECKING:
    from vkworkbench.gui.qt.names import QWidget

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP  # labels a text that FreeCAD translates later, when it is shown


def explain(widget: QWidget, text: str) -> None:
    """Describe a widget without a text by a tooltip and, for screen readers, which do not read tooltips, by a name."""
    widget.setToolTip(text)
    widget.setAccessibleName(text)
