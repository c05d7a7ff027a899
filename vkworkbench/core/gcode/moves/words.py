# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of a program as arrays: G-codes and parameter columns of a command list."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from itertools import chain, islice
from typing import Any

import numpy as np

from vkworkbench.core.gcode.moves.codes import code_of
from vkworkbench.core.toolpath import COORDINATE_LIMIT

_ABSENT = 1e300
_PIECE = 50_000  # commands read at once: their parameters take half a kB each
# A line that begins with a coordinate or a line number: FreeCAD takes that word for the command's name.
_WORD_NAME = re.compile(r"\s*([XYZIJKRFN])\s*([-+]?(?:\d+\.?\d*|\.\d+))\s*", re.IGNORECASE | re.ASCII)


class Words:
    """Names, codes and parameter columns of a list of commands.

    Parameters
    ----------
    commands : iterable
        ``(name, parameters)`` pairs, or objects with ``.Name`` and ``.Parameters`` as FreeCAD's.

    Raises
    ------
    TypeError
        If it is something else.
    """

    def __init__(self, commands: Iterable[Any]) -> None:
        self.names: list[str] = []
        known: dict[str, str] = {}
        tables: list[tuple[np.ndarray, str, np.ndarray]] = []
        if not isinstance(commands, Iterable) or isinstance(commands, str):
            raise _no_commands(commands)
        source = iter(commands)
        while (piece := list(islice(source, _PIECE))) or not tables:
            names, parameters = _columns(piece)
            _read_word_names(names, parameters)
            self.names += [known.setdefault(name, name) for name in names]
            tables.append(_table_of(parameters))
        counts, letters, values = zip(*tables)
        count, self._values = np.concatenate(counts), np.concatenate(values)
        table = {name: code_of(name) for name in known}
        self.codes = np.fromiter(map(table.__getitem__, self.names), np.int64, len(self.names))
        # Small letters are the same words; FreeCAD's own are all large.
        self._letters = np.frombuffer("".join(letters).encode("ascii", "replace").upper(), np.uint8)
        self._rows = np.repeat(np.arange(len(count), dtype=np.int32), count)

    def __len__(self) -> int:
        return len(self.names)

    @property
    def letters(self) -> set[str]:
        """set of str : the letters of all parameters."""
        return {chr(letter) for letter in np.flatnonzero(np.bincount(self._letters)).tolist()}

    def column(self, letter: str, rows: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
        """Return the values of one parameter and which of them cannot be used.

        Parameters
        ----------
        letter : str
            Name of the parameter, e.g. ``"X"``.
        rows : (m,) int, optional
            Only these commands.

        Returns
        -------
        values : (m,) float64
            NaN where the parameter is absent or unusable.
        unusable : (m,) bool
            True where the word is there but is no finite number below `COORDINATE_LIMIT`.
        """
        given = np.flatnonzero(self._letters == ord(letter))
        row, value = self._rows.take(given), self._values.take(given)
        usable = np.abs(value) <= COORDINATE_LIMIT
        values, unusable = np.full(len(self), np.nan), np.zeros(len(self), bool)
        values[row] = np.where(usable, value, np.nan)
        unusable[row] = ~usable
        return (values, unusable) if rows is None else (values[rows], unusable[rows])


def _columns(piece: list[Any]) -> tuple[list[str], list[Any]]:
    """Return the names and the parameters of commands."""
    if piece and isinstance(piece[0], str):  # a line of a program: its letters would be taken for a name and parameters
        raise _no_commands(piece)
    try:
        if piece and hasattr(piece[0], "Parameters"):
            names, parameters = [c.Name for c in piece], [c.Parameters for c in piece]
        else:
            names, parameters = [c[0] for c in piece], [c[1] for c in piece]
        different = set(names)
    except (AttributeError, IndexError, KeyError, TypeError):
        raise _no_commands(piece) from None
    if not all(isinstance(name, str) for name in different):
        raise _no_commands(piece)
    return names, parameters


def _no_commands(given: Any) -> TypeError:
    """Return the error that says what commands are, and what was given."""
    first = given[0] if isinstance(given, list) else given
    return TypeError(
        "commands are (name, parameters) pairs, or objects with Name and Parameters as in a Path's Commands, "
        f"not {first!r:.60}"
    )


def used_up(commands: list[Any]) -> Iterator[Any]:
    """Yield the commands of a list, which is empty then: FreeCAD's keep a copy of their parameters once they were asked."""
    commands.reverse()
    while commands:
        yield commands.pop()


def _read_word_names(names: list[str], all_parameters: list[dict[str, Any] | None]) -> None:
    """Turn ``X10`` into a modal line with an X word, and ``N10`` with a G word into that G-code."""
    word_names = {name for name in set(names) if name and name[0] in "XYZIJKRFNxyzijkrfn \t"}
    if not word_names:
        return
    for i, name in enumerate(names):
        match = _WORD_NAME.fullmatch(name) if name in word_names else None
        if match is None:
            continue
        letter, value = match[1].upper(), float(match[2])
        parameters = dict(all_parameters[i] or {})
        code = _number(parameters.get("G", _ABSENT))
        parameters.pop("G", None)
        names[i] = "" if code == _ABSENT else f"G{code:g}"
        if letter != "N":
            parameters[letter] = value
        elif not parameters and not names[i]:
            names[i] = name
        all_parameters[i] = parameters


def _table_of(parameters: list[Any]) -> tuple[np.ndarray, str, np.ndarray]:
    """Return the table of parameters of whatever kind."""
    try:
        return _table(parameters)
    except (TypeError, ValueError, OverflowError):
        return _table([_numbers(p) for p in parameters])


def _table(parameters: list[dict[str, Any]]) -> tuple[np.ndarray, str, np.ndarray]:
    """Return how many parameters each command has, and of all of them the letters and the values.

    No Python loop: each of the three passes runs inside of an iterator.
    """
    count = np.fromiter(map(len, parameters), np.int64, len(parameters))
    names = ",".join(chain.from_iterable(parameters))
    letters, total = names[::2], int(count.sum())
    if len(letters) != total or names[1::2] != "," * (total - 1):
        raise ValueError("a parameter's name is no single letter")
    return count, letters, np.fromiter(chain.from_iterable(map(dict.values, parameters)), np.float64, total)


def _numbers(parameters: Mapping[Any, Any] | None) -> dict[str, float]:
    """Return the parameters that a letter names, NaN where they are no number."""
    if parameters is not None and not isinstance(parameters, Mapping):
        raise _no_commands(parameters)
    words = parameters.items() if parameters else ()
    return {letter: _number(value) for letter, value in words if isinstance(letter, str) and len(letter) == 1}


def _number(value: Any) -> float:
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        return np.nan
