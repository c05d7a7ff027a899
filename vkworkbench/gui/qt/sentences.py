# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the user reads: in FreeCAD's language and units, with the number format of its window.

Documents, CSV and JSON keep English sentences and millimetres, the same for every user of a file.
"""

from __future__ import annotations

import re
from enum import Enum

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import freecad
from vkworkbench.gui.qt.names import QLocale
from vkworkbench.language import Message, Reader, render

# The English sentences keep to ASCII, for files and terminals; a window shows what every translation has.
_TYPESET = (("phi ", "φ "), ("} x {", "} × {"))


class User(Reader):
    """Who sits before this FreeCAD, as its preferences are now."""

    def __init__(self) -> None:
        locale = QLocale()
        self.decimal, self.thousands = locale.decimalPoint(), locale.groupSeparator()

    def translate(self, context: str, text: str) -> str:
        told = FreeCAD.Qt.translate(context, text)
        if context == "Sentences" and told == text:
            for ascii_text, letter in _TYPESET:
                told = told.replace(ascii_text, letter)
        return told

    def simulator(self, name: str) -> str:
        """Return what this FreeCAD's menu calls a simulator; the words of documents where it has none."""
        return freecad.simulator_title(name) or super().simulator(name)

    def length_unit(self, millimetres: float) -> tuple[float, str]:
        _, factor, unit = _quantity(millimetres).getUserPreferred()
        return factor, unit

    def length(self, millimetres: float) -> str:
        """Return a length with the decimals of FreeCAD's preferences, e.g. ``"12.50 mm"`` or ``"0.49 in"``; m from 10 m on."""
        if millimetres >= 10_000 and self.length_unit(millimetres)[1] == "mm":
            return super().length(millimetres)
        text = _quantity(millimetres).UserString  # without separators of thousands
        return re.sub(r"^-?\d{4,}", lambda number: self.count(int(number.group())), text)

    def is_one(self, count: int) -> bool:
        return count in (0, 1) if Gui.getLocale().startswith(("fr", "French")) else count == 1


def user() -> User:
    """Return the reader of all that is shown."""
    return User()


def said(message: Message) -> str:
    """Return the sentence of a message as the user reads it."""
    return render(message, user())


def plainly(message: Message) -> str:
    """Return the sentence of a message as the user reads it, in a machinist's words where it has such."""
    return render(message, user(), plain=True)


def as_sentence(text: str) -> str:
    """Return what is told with a capital and a full stop; several sentences have both already."""
    full_stop = "。" if is_chinese(text[-1:]) else "."
    return f"{text[:1].upper()}{text[1:]}" + ("" if text.endswith((".", "。")) else full_stop)


def is_chinese(text: str) -> bool:
    """Whether it is one Chinese character, beside which there are no spaces."""
    return "\u4e00" <= text <= "\u9fff"


def plural(one: str, more: str, count: int) -> str:
    """Return the text for one or that for more, with the count in its place ``{count}``."""
    reader = user()
    return (one if reader.is_one(count) else more).format(count=reader.count(count))


def strategy_name(strategy: Enum) -> str:
    """Return the name of a member of `Strategy` in the user's language; loads no numpy, as its table would."""
    return user().translate("Strategy", strategy.label)


def _quantity(millimetres: float):
    return FreeCAD.Units.Quantity(float(millimetres), FreeCAD.Units.Length)
