# SPDX-License-Identifier: LGPL-2.1-or-later
"""Show texts again after the user has changed FreeCAD's language."""

from __future__ import annotations

from collections.abc import Callable

import FreeCADGui as Gui

from vkworkbench.gui.qt.names import QEvent, QWidget, single_shot


class LanguageChange(QWidget):
    """An invisible widget that calls a function after FreeCAD's language has changed.

    Qt tells only widgets of a change. The function is called once, although FreeCAD changes many translators, and it is
    not called if FreeCAD only loads the translations of another workbench.
    """

    def __init__(self, call: Callable[[], object], parent: QWidget) -> None:
        super().__init__(parent)
        self._call, self._language = call, Gui.getLocale()
        self._changed = single_shot(self._compare, self)
        self.hide()

    def _compare(self) -> None:
        former, self._language = self._language, Gui.getLocale()
        if self._language != former:
            self._call()

    def changeEvent(self, event) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.LanguageChange:
            self._changed.start()
