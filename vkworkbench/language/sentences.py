# SPDX-License-Identifier: LGPL-2.1-or-later
"""Messages in words: the sentence of a code in the reader's language, filled with the arguments as he reads them.

A place of a template is ``{name}`` or ``{name:quantity}``. Without a quantity stands there a text as it is, or another
message. A quantity says what a number is: ``n`` how many, ``#`` the number of a line or command, counted from 1, ``g`` a number,
``mm`` a length, ``mm³`` a volume, ``mm/min`` a speed (these with the significant digits behind them, e.g. ``mm3``), ``s`` a duration in s, ``bytes``,
``%`` a share of 1, ``turns`` an angle in rad, ``strategy`` a strategy and ``simulator`` a simulator by its name.

Durations and sizes have few digits, and where two of a sentence would read the same though they are not, more of them:
"more than the 2.0 GB allowed" is not said of 2.0 GB.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from vkworkbench.language.marking import QT_TRANSLATE_NOOP
from vkworkbench.language.message import Argument, Message
from vkworkbench.language.numbers import ENGLISH, Reader
from vkworkbench.language.table import PLAIN, TABLE

_PLACE = re.compile(r"\{(\w+)(?::([^{}\d]+)(\d*))?\}")
_BETWEEN = QT_TRANSLATE_NOOP("Sentences", ", ")

_QUANTITIES: dict[str, Callable[[Reader, Any, int], str]] = {
    "n": lambda reader, value, digits: reader.count(value),
    "#": lambda reader, value, digits: f"{value:d}",
    "g": lambda reader, value, digits: reader.number(float(value), digits),
    "mm": lambda reader, value, digits: reader.measure(float(value), digits),
    "mm³": lambda reader, value, digits: reader.volume(float(value), digits),
    "mm/min": lambda reader, value, digits: f"{reader.measure(float(value), digits)}/min",
    "s": lambda reader, value, finer: reader.time(value, finer=finer),
    "bytes": lambda reader, value, finer: reader.memory(value, finer),
    "%": lambda reader, value, digits: reader.share(value),
    "turns": lambda reader, value, digits: reader.turns(value),
    "simulator": lambda reader, value, digits: reader.simulator(value),
    "strategy": lambda reader, value, digits: reader.translate("Strategy", value),
}
_ROUNDED = ("s", "bytes")  # they take how many digits more than usual are read
_FINEST = 6


def render(message: Message, reader: Reader = ENGLISH, *, plain: bool = False) -> str:
    """Return the sentence of a message, without a full stop unless it is several.

    Parameters
    ----------
    message : Message
    reader : Reader
    plain : bool
        Whether a machinist's words are taken where the table has them, instead of the paper's.

    Raises
    ------
    LookupError, TypeError, ValueError
        If the table has no such message: another version may have written it.
    """
    arguments = message.arguments
    template = reader.translate("Sentences", _template(message, reader, plain))
    finer = {quantity: _told_apart(template, arguments, quantity, reader) for quantity in _ROUNDED}

    def filled(place: re.Match[str]) -> str:
        name, quantity, digits = place.groups()
        return _shown(arguments[name], quantity, finer.get(quantity, int(digits or 6)), reader, plain)

    return _PLACE.sub(filled, template)


def _told_apart(template: str, arguments: dict[str, Argument], quantity: str, reader: Reader) -> int:
    """With how many digits more than usual no two different numbers of this quantity read the same."""
    numbers = {arguments[place[1]] for place in _PLACE.finditer(template) if place[2] == quantity}
    read = _QUANTITIES[quantity]
    enough = (finer for finer in range(_FINEST) if len({read(reader, one, finer) for one in numbers}) == len(numbers))
    return next(enough, _FINEST)


def _template(message: Message, reader: Reader, plain: bool) -> str:
    """The text of the table: of one or of more where it tells them apart."""
    known = _plain_words(message) if plain else None
    known = known or TABLE[message.code]
    if isinstance(known, str):
        return known
    one, more = known
    count: Any = message.arguments["count"]
    return one if reader.is_one(count) else more


def _plain_words(message: Message) -> str | tuple[str, str] | None:
    seen = message.arguments.get("seen")
    together = f"{message.code} {seen.code}" if isinstance(seen, Message) else message.code
    return PLAIN.get(together) or PLAIN.get(message.code)


def _shown(value: Argument, quantity: str | None, digits: int, reader: Reader, plain: bool) -> str:
    if isinstance(value, tuple):
        between = reader.translate("Sentences", _BETWEEN)
        return between.join(_shown(one, quantity, digits, reader, plain) for one in value)
    if quantity:
        return _QUANTITIES[quantity](reader, value, digits)
    if isinstance(value, Message):
        return render(value, reader, plain=plain)
    return "" if value is None else str(value)
