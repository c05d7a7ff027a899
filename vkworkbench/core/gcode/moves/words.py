# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert a list of commands into arrays: the G-codes, and a column for each parameter."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from itertools import chain, islice
from typing import Any

import numpy as np

from vkworkbench.core.gcode.moves.codes import (
    CANCEL,
    DWELL,
    MACHINE,
    MODAL,
    MOTIONS,
    PROBES,
    STATES,
    TOOL_CHANGE,
    UNKNOWN,
    code_of,
)
from vkworkbench.core.gcode.moves.commands import Commands
from vkworkbench.core.toolpath import COORDINATE_LIMIT

_MOVES = (*MOTIONS, *PROBES, *MACHINE)
# Codes that do not move the tool; axis words in the same command are the target of a move.
_CARRIERS = frozenset(STATES) - {DWELL, 431, CANCEL}
_ABSENT = 1e300
_PIECE = 50_000  # Number of commands read at once; the parameters of each command need half a kB of memory.
# A name such as X10. FreeCAD's import makes the first word of a line the command's name, even if this word is a
# coordinate or a line number.
_WORD_NAME = re.compile(r"\s*([XYZIJKRFN])\s*([-+]?(?:\d+\.?\d*|\.\d+))\s*", re.IGNORECASE | re.ASCII)


class Words:
    """Names, codes and parameter columns of a list of commands.

    Parameters
    ----------
    commands : iterable
        ``(name, parameters)`` pairs, or objects with ``.Name`` and ``.Parameters`` such as FreeCAD's commands.

    Raises
    ------
    TypeError
        If `commands` has another type.

    Attributes
    ----------
    names : list of str
        Name of each command.
    codes : (n,) int64
        Code of each command (see `codes.code_of`). For a command with two codes, the code that moves the tool.
    second_rows, second_codes : (m,) int64
        Indices of the commands with a second code, and the second codes.
    """

    def __init__(self, commands: Iterable[Any]) -> None:
        if isinstance(commands, Commands):
            self.names = commands.names
            count, letters, self._values = commands.table()
        else:
            self.names, count, letters, self._values = _read(commands)
        table = {name: code_of(name) for name in set(self.names)}
        self.codes = np.fromiter(map(table.__getitem__, self.names), np.int64, len(self.names))
        # Lower-case letters are also valid. FreeCAD writes upper-case letters.
        self._letters = np.frombuffer(letters.encode("ascii", "replace").upper(), np.uint8)
        self._rows = np.repeat(np.arange(len(count), dtype=np.int32), count)
        self.second_rows, self.second_codes = self._second_codes(_CARRIERS.intersection(table.values()))

    def _second_codes(self, states: frozenset[int]) -> tuple[np.ndarray, np.ndarray]:
        """Set the code of each command to its motion; return the indices and the values of all other codes, (m,) int.

        FreeCAD stores ``G90 G1 X45`` as G90 with the parameters G and X, and ``G90 X45`` as G90 with the parameter X.
        Post processors write the words of ``G90 X45`` unchanged, so the machine moves the tool to X45. In the command
        after a G28 without words, the axis words belong to the G28.

        Parameters
        ----------
        states : frozenset of int
            The codes in `_CARRIERS` that the commands contain.
        """
        rows = self.two_codes
        if not (len(rows) or states):
            return rows, rows
        first, second = self.codes[rows], _codes_of(self._values[self._letters == ord("G")])
        moves = np.isin(second, _MOVES) & ~np.isin(first, (*MACHINE, TOOL_CHANGE))
        self.codes[rows[moves]] = second[moves]
        rest = np.where(moves, first, second)
        carries = np.zeros(len(self), bool)
        for state in states:
            carries |= self.codes == state
        if not carries.any():
            return rows, rest
        carries[1:] &= ~np.isin(self.codes[:-1], MACHINE)
        axes = (self._letters >= ord("X")) & (self._letters <= ord("Z"))
        modal = np.unique(self._rows[axes & carries[self._rows]]).astype(np.int64)
        rows, rest = np.concatenate([rows, modal]), np.concatenate([rest, self.codes[modal]])
        self.codes[modal] = MODAL
        return rows, rest

    def __len__(self) -> int:
        return len(self.names)

    @property
    def letters(self) -> set[str]:
        """set of str : The letters of all parameters."""
        return {chr(letter) for letter in np.flatnonzero(np.bincount(self._letters)).tolist()}

    @property
    def two_codes(self) -> np.ndarray:
        """(m,) int : Rows of the commands with a parameter G (a second code), which some post processors leave out."""
        return self._rows[self._letters == ord("G")].astype(np.int64)

    def rows_of(self, code: int) -> np.ndarray:
        """Return the rows of the commands with a code, also as one of two codes, (m,) int."""
        return np.union1d(np.flatnonzero(self.codes == code), self.second_rows[self.second_codes == code])

    def column(self, letter: str, rows: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
        """Return the values of one parameter, and whether each value is unusable.

        Parameters
        ----------
        letter : str
            Name of the parameter, such as ``"X"``.
        rows : (m,) int, optional
            Indices of the commands; all commands if not given.

        Returns
        -------
        values : (m,) float64
            NaN where the parameter is absent or unusable.
        unusable : (m,) bool
            True where the parameter is present but is not a finite number within ±`COORDINATE_LIMIT`.
        """
        given = np.flatnonzero(self._letters == ord(letter))
        row, value = self._rows.take(given), self._values.take(given)
        usable = np.abs(value) <= COORDINATE_LIMIT
        values, unusable = np.full(len(self), np.nan), np.zeros(len(self), bool)
        values[row] = np.where(usable, value, np.nan)
        unusable[row] = ~usable
        return (values, unusable) if rows is None else (values[rows], unusable[rows])


def _codes_of(numbers: np.ndarray) -> np.ndarray:
    """Return G-codes as ten times their numbers, (m,) int; UNKNOWN for numbers that are not G-codes."""
    usable = (numbers >= 0) & (numbers < 1000)
    tenths = np.rint(10 * np.where(usable, numbers, 0.0))
    return np.where(usable, tenths, UNKNOWN).astype(np.int64)


def _read(commands: Iterable[Any]) -> tuple[list[str], np.ndarray, str, np.ndarray]:
    """Return the names of commands, and the table of their parameters as `Commands.table` does."""
    if not isinstance(commands, Iterable) or isinstance(commands, str):
        raise _no_commands(commands)
    names: list[str] = []
    known: dict[str, str] = {}
    tables: list[tuple[np.ndarray, str, np.ndarray]] = []
    source = iter(commands)
    while (piece := list(islice(source, _PIECE))) or not tables:
        names_of_piece, parameters = _columns(piece)
        _read_word_names(names_of_piece, parameters)
        names += [known.setdefault(name, name) for name in names_of_piece]
        tables.append(_table_of(parameters))
    counts, letters, values = zip(*tables)
    return names, np.concatenate(counts), "".join(letters), np.concatenate(values)


def _columns(piece: list[Any]) -> tuple[list[str], list[Any]]:
    """Return the names and the parameters of commands."""
    # the commands are a list of texts, so that c[0] and c[1] below would be the first letters of a text
    if piece and isinstance(piece[0], str):
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
    """Return the error for an argument that is not a list of commands."""
    first = given[0] if isinstance(given, list) else given
    return TypeError(
        "commands are (name, parameters) pairs, or objects with Name and Parameters as in a Path's Commands, "
        f"not {first!r:.60}"
    )


def used_up(commands: list[Any]) -> Iterator[Any]:
    """Yield the commands of a list and remove them from the list.

    Removal frees memory, because a FreeCAD command keeps a copy of its parameters after the first access.
    """
    commands.reverse()
    while commands:
        yield commands.pop()


def _read_word_names(names: list[str], all_parameters: list[dict[str, Any] | None]) -> None:
    """Replace the name ``X10`` by an empty name and an X parameter, and ``N10`` with a G parameter by the G-code."""
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
    """Return the table of the parameters as `_table` does; values that are not numbers are replaced by NaN."""
    try:
        return _table(parameters)
    except (TypeError, ValueError, OverflowError):
        return _table([_numbers(p) for p in parameters])


def _table(parameters: list[dict[str, Any]]) -> tuple[np.ndarray, str, np.ndarray]:
    """Return the number of parameters of each command, and the letters and the values of all parameters.

    The parameters are read three times with iterators, which are faster than one Python loop.
    """
    count = np.fromiter(map(len, parameters), np.int64, len(parameters))
    names = ",".join(chain.from_iterable(parameters))
    letters, total = names[::2], int(count.sum())
    if len(letters) != total or names[1::2] != "," * (total - 1):
        raise ValueError("a parameter's name is no single letter")
    return count, letters, np.fromiter(chain.from_iterable(map(dict.values, parameters)), np.float64, total)


def _numbers(parameters: Mapping[Any, Any] | None) -> dict[str, float]:
    """Return the parameters with single-letter names; values that are not numbers are replaced by NaN."""
    if parameters is not None and not isinstance(parameters, Mapping):
        raise _no_commands(parameters)
    words = parameters.items() if parameters else ()
    return {letter: _number(value) for letter, value in words if isinstance(letter, str) and len(letter) == 1}


def _number(value: Any) -> float:
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        return np.nan
