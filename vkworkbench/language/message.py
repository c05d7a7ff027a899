# SPDX-License-Identifier: LGPL-2.1-or-later
"""Messages: codes with arguments, which programs can compare and the module `sentences` renders as text."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from math import isfinite
from numbers import Integral, Real
from typing import Any, Tuple, Union

Argument = Union[int, float, str, None, "Message", Tuple[Any, ...]]


@dataclass(frozen=True, init=False, repr=False)
class Message:
    """The code of a sentence in the table of sentences, with values for the sentence's placeholders.

    Parameters
    ----------
    code : str
    **arguments : int, float, str, None, Message, or sequence of these
        Values for the sentence's placeholders. Numbers are in mm, s, rad, bytes or shares of 1. Labels and other names
        are texts, which are not translated. A placeholder is replaced by another sentence if its value is a message,
        and by nothing if its value is None. Members of an enum, such as strategies, are stored as their values.
    """

    code: str
    _items: tuple[tuple[str, Argument], ...]

    def __init__(self, code: str, /, **arguments: Any) -> None:
        items = tuple((name, _plain(value)) for name, value in sorted(arguments.items()))
        object.__setattr__(self, "code", code)
        object.__setattr__(self, "_items", items)

    @property
    def arguments(self) -> dict[str, Argument]:
        """The arguments by name."""
        return dict(self._items)

    @property
    def codes(self) -> tuple[str, ...]:
        """The message's own code, then the codes of the messages in its arguments, sorted by the arguments' names."""
        return (self.code, *(code for _, value in self._items for code in _codes_of(value)))

    def __repr__(self) -> str:
        return f"Message({', '.join([repr(self.code), *(f'{name}={value!r}' for name, value in self._items)])})"

    def as_data(self) -> dict[str, Any]:
        """Return the message as plain data for JSON: ``{"code": ..., "arguments": {...}}``."""
        return {"code": self.code, "arguments": {name: _data_of(value) for name, value in self._items}}

    @classmethod
    def from_data(cls, data: Any) -> Message:
        """Return the message that `as_data` has converted to `data`.

        Raises
        ------
        ValueError
            If `data` does not describe a message.
        """
        if isinstance(data, dict) and set(data) == {"code", "arguments"}:
            code, arguments = data["code"], data["arguments"]
            if isinstance(code, str) and isinstance(arguments, dict):
                return cls(code, **{name: _of_data(value) for name, value in arguments.items()})
        raise ValueError(f"not a message: {data!r}")


def _plain(value: Any) -> Argument:
    """Return an argument in a form that can be compared and written as JSON. Numpy numbers become Python numbers."""
    if value is None or isinstance(value, Message):
        return value
    if isinstance(value, Enum):
        return _plain(value.value)
    if isinstance(value, str):
        return value
    if isinstance(value, Integral):
        return int(value)
    if isinstance(value, Real):
        # Infinity and NaN are stored as text, because JSON does not have them, and because a NaN does not equal itself.
        return float(value) if isfinite(value) else str(float(value))
    if isinstance(value, (list, tuple)):
        return tuple(map(_plain, value))
    raise TypeError(f"a message cannot hold {value!r}")


def _codes_of(value: Argument) -> tuple[str, ...]:
    if isinstance(value, Message):
        return value.codes
    return tuple(code for one in value for code in _codes_of(one)) if isinstance(value, tuple) else ()


def _data_of(value: Argument) -> Any:
    if isinstance(value, Message):
        return value.as_data()
    return [_data_of(one) for one in value] if isinstance(value, tuple) else value


def _of_data(data: Any) -> Argument:
    if isinstance(data, dict):
        return Message.from_data(data)
    return tuple(map(_of_data, data)) if isinstance(data, list) else data
