# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts for the user, in FreeCAD's language and units, with the number format of the window.

In contrast, documents, CSV and JSON have English sentences and millimetres, so that a file is the same for every user.
"""

from __future__ import annotations

import re
from enum import Enum

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import freecad
from vkworkbench.gui.qt.names import QLocale
from vkworkbench.language import Message, Reader, render

# ASCII texts in the English sentences, which are made for files and terminals, and the characters that a window shows
# instead.
_TYPESET = (("Phi ", "φ "), ("} x {", "} × {"))


class User(Reader):
    """The `Reader` with the language, units and number format of this FreeCAD."""

    def __init__(self) -> None:
        locale = QLocale()
        self.decimal, self.thousands = locale.decimalPoint(), locale.groupSeparator()

    def translate(self, context: str, text: str) -> str:
        translated = FreeCAD.Qt.translate(context, text)
        if context == "Sentences" and translated == text:
            for ascii_text, letter in _TYPESET:
                translated = translated.replace(ascii_text, letter)
        return translated

    def simulator(self, name: str) -> str:
        """Return the name of a simulator in this FreeCAD's menu; the name used in documents if the menu has no name."""
        return freecad.simulator_title(name) or super().simulator(name)

    def length_unit(self, millimetres: float) -> tuple[float, str]:
        _, factor, unit = _quantity(millimetres).getUserPreferred()
        return factor, unit

    def length(self, millimetres: float) -> str:
        """Return a length with FreeCAD's chosen decimals, e.g. ``"12.50 mm"`` or ``"0.49 in"``; in metres from 10 m."""
        if millimetres >= 10_000 and self.length_unit(millimetres)[1] == "mm":
            return super().length(millimetres)
        text = _quantity(millimetres).UserString  # FreeCAD writes this text without separators of thousands
        return re.sub(r"^-?\d{4,}", lambda number: self.count(int(number.group())), text)

    def is_one(self, count: int) -> bool:
        return count in (0, 1) if Gui.getLocale().startswith(("fr", "French")) else count == 1


def user() -> User:
    """Return the reader for all texts of the window."""
    return User()


def sentence(message: Message) -> str:
    """Return the sentence of a message for the user."""
    return render(message, user())


def plain_sentence(message: Message) -> str:
    """Return the sentence of a message for the user, in a machinist's words if the message has them."""
    text = render(message, user(), plain=True)
    return text[:1].upper() + text[1:]  # a message can be composed of parts that begin with a small letter


def is_chinese(text: str) -> bool:
    """Return whether a text is one Chinese character, which is written without spaces."""
    return "\u4e00" <= text <= "\u9fff"


def plural(one: str, more: str, count: int) -> str:
    """Return the singular or plural text, with the count in place of ``{count}``."""
    reader = user()
    return (one if reader.is_one(count) else more).format(count=reader.count(count))


def strategy_name(strategy: Enum) -> str:
    """Return the name of a member of `Strategy` in the user's language, without importing numpy."""
    return user().translate("Strategy", strategy.label)


def _quantity(millimetres: float):
    return FreeCAD.Units.Quantity(float(millimetres), FreeCAD.Units.Length)
