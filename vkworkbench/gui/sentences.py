# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the user reads: in FreeCAD's language and units, with the number format of its window.

Documents, CSV and JSON keep English sentences and millimetres, the same for every user of a file.
"""

from __future__ import annotations

from enum import Enum

import FreeCAD

from vkworkbench import freecad
from vkworkbench.gui.qt import QLocale
from vkworkbench.language import Message, Reader, render


class User(Reader):
    """Who sits before this FreeCAD, as its preferences are now."""

    def __init__(self) -> None:
        locale = QLocale()
        self.decimal, self.thousands = locale.decimalPoint(), locale.groupSeparator()

    def translate(self, context: str, text: str) -> str:
        return FreeCAD.Qt.translate(context, text)

    def simulator(self, name: str) -> str:
        """Return what this FreeCAD's menu calls a simulator; the words of documents where it has none."""
        return freecad.simulator_title(name) or super().simulator(name)

    def length_unit(self, millimetres: float) -> tuple[float, str]:
        _, factor, unit = _quantity(millimetres).getUserPreferred()
        return factor, unit

    def length(self, millimetres: float) -> str:
        """Return a length with the decimals of FreeCAD's preferences, e.g. ``"12.50 mm"`` or ``"0.49 in"``."""
        return _quantity(millimetres).UserString


def user() -> User:
    """Return the reader of all that is shown."""
    return User()


def said(message: Message) -> str:
    """Return the sentence of a message as the user reads it."""
    return render(message, user())


def strategy_name(strategy: Enum) -> str:
    """Return the name of a member of `Strategy` in the user's language; loads no numpy, as its table would."""
    return user().translate("Strategy", strategy.label)


def _quantity(millimetres: float):
    return FreeCAD.Units.Quantity(float(millimetres), FreeCAD.Units.Length)
