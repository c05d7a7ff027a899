# SPDX-License-Identifier: LGPL-2.1-or-later
"""Render messages as sentences in the reader's language, units and number format.

Each code has a template, which is a sentence with placeholders ``{name}`` or ``{name:quantity}`` for the message's
arguments. A placeholder without a quantity is for a text or for another message. The quantities are:

* ``n``: a count
* ``#``: the number of a line or command, counted from 1
* ``g``: a number
* ``mm``, ``mm³``, ``mm/min``: a length, a volume, a speed
* ``s``: a duration in s
* ``clock``: a duration in s, as minutes and seconds
* ``estimate``: an estimated duration in s
* ``bytes``: a memory size
* ``%``: a share of 1
* ``turns``: an angle in rad
* ``strategy``: a strategy, given by its value
* ``simulator``: a simulator, given by its name

The number of significant digits can follow ``g``, ``mm``, ``mm³`` and ``mm/min``, as in ``mm3``.

Durations and memory sizes are shown with few digits. If two different values in one sentence would look equal, both get
more digits, so that no sentence says "about 2.0 GB, which is over your 2.0 GB limit".
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from vkworkbench.language.marking import QT_TRANSLATE_NOOP
from vkworkbench.language.message import Argument, Message
from vkworkbench.language.numbers import ENGLISH, ROUGH, Reader
from vkworkbench.language.table import PLAIN, TABLE

_PLACE = re.compile(r"\{(\w+)(?::([^{}\d]+)(\d*))?\}")
_COMMA = QT_TRANSLATE_NOOP("Sentences", ", ")

_QUANTITIES: dict[str, Callable[[Reader, Any, int], str]] = {
    "n": lambda reader, value, digits: reader.count(value),
    "#": lambda reader, value, digits: f"{value:d}",
    "g": lambda reader, value, digits: reader.number(float(value), digits),
    "mm": lambda reader, value, digits: reader.measure(float(value), digits),
    "mm³": lambda reader, value, digits: reader.volume(float(value), digits),
    "mm/min": lambda reader, value, digits: f"{reader.measure(float(value), digits)}/min",
    "s": lambda reader, value, extra: reader.time(value, extra_digits=extra),
    "clock": lambda reader, value, digits: reader.clock(value),
    "estimate": lambda reader, value, extra: reader.time(value, ROUGH),
    "bytes": lambda reader, value, extra: reader.memory(value, extra),
    "%": lambda reader, value, digits: reader.share(value),
    "turns": lambda reader, value, digits: reader.turns(value),
    "simulator": lambda reader, value, digits: reader.simulator(value),
    "strategy": lambda reader, value, digits: reader.translate("Strategy", value),
}
_ROUNDED = ("s", "bytes")  # quantities that get extra digits if two rounded values in a sentence look equal
_DEFAULT_DIGITS = 6
_MOST_EXTRA_DIGITS = 6


def render(message: Message, reader: Reader = ENGLISH, *, plain: bool = False) -> str:
    """Return the sentence of a message.

    Parameters
    ----------
    plain : bool
        Whether to use a machinist's words instead of the paper's terms, if the table has such a sentence.

    Raises
    ------
    LookupError, TypeError, ValueError
        If the table has no sentence for the message, for example because another version of the add-on has written the
        message.
    """
    arguments = message.arguments
    template = _with_different_times(
        reader.translate("Sentences", _template(message, reader, plain)), arguments, reader
    )
    extra = {quantity: _extra_digits(template, arguments, quantity, reader) for quantity in _ROUNDED}

    def fill(place: re.Match[str]) -> str:
        name, quantity, digits = place.groups()
        return _text(arguments[name], quantity, extra.get(quantity, int(digits or _DEFAULT_DIGITS)), reader, plain)

    return _PLACE.sub(fill, template)


def _with_different_times(template: str, arguments: dict[str, Argument], reader: Reader) -> str:
    """Return the template; estimates are exact in it if two rounded times in the sentence would look equal."""
    places = [place for place in _PLACE.finditer(template) if place[2] in ("s", "estimate")]
    texts = {arguments[place[1]]: _QUANTITIES[place[2]](reader, arguments[place[1]], 0) for place in places}
    return template if len(set(texts.values())) == len(texts) else template.replace(":estimate}", ":s}")


def _extra_digits(template: str, arguments: dict[str, Argument], quantity: str, reader: Reader) -> int:
    """Return the number of extra digits with which all different numbers of a quantity look different."""
    numbers = {arguments[place[1]] for place in _PLACE.finditer(template) if place[2] == quantity}
    text = _QUANTITIES[quantity]
    enough = (
        extra for extra in range(_MOST_EXTRA_DIGITS) if len({text(reader, n, extra) for n in numbers}) == len(numbers)
    )
    return next(enough, _MOST_EXTRA_DIGITS)


def _template(message: Message, reader: Reader, plain: bool) -> str:
    """Return the template of a message: the singular or the plural template if the message has a count."""
    template = _plain_template(message) if plain else None
    template = template or TABLE[message.code]
    if isinstance(template, str):
        return template
    singular, plural = template
    count: Any = message.arguments["count"]
    return singular if reader.is_one(count) else plural


def _plain_template(message: Message) -> str | tuple[str, str] | None:
    seen = message.arguments.get("seen")
    key = f"{message.code} {seen.code}" if isinstance(seen, Message) else message.code
    return PLAIN.get(key) or PLAIN.get(message.code)


def _text(value: Argument, quantity: str | None, digits: int, reader: Reader, plain: bool) -> str:
    if isinstance(value, tuple):
        sentences = all(isinstance(one, Message) for one in value)
        separator = " " if sentences else reader.translate("Sentences", _COMMA)
        return separator.join(_text(one, quantity, digits, reader, plain) for one in value)
    if quantity:
        return _QUANTITIES[quantity](reader, value, digits)
    if isinstance(value, Message):
        return render(value, reader, plain=plain)
    return "" if value is None else str(value)


class Unusable(ValueError):
    """An input cannot be used. The exception's message contains the reason.

    Attributes
    ----------
    what : Message
    """

    def __init__(self, what: Message) -> None:
        super().__init__(what)
        self.what = what

    def __str__(self) -> str:
        return render(self.what)
