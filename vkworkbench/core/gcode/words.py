# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of a program as arrays: G-code numbers and parameter columns of a command list."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

import numpy as np

# mm. No milling machine goes beyond a kilometre: such a word is an error, and would overflow later.
COORDINATE_LIMIT = 1e6

# G-codes are numbered in tenths (G90.1 is 901); what is not a G-code is negative.
COMMENT, OTHER, TOOL_CHANGE, MODAL, UNKNOWN = -1, -2, -3, -4, -5

_ABSENT = 1e300
_NAME = re.compile(r"([A-Z])0*(\d{1,9})(?:\.(\d))?", re.ASCII)
# A line that begins with a coordinate or a line number: FreeCAD takes that word for the command's name.
_WORD_NAME = re.compile(r"\s*([XYZIJKRFN])\s*([-+]?(?:\d+\.?\d*|\.\d+))\s*", re.IGNORECASE | re.ASCII)


def code_of(name: str) -> int:
    """Return the number of a command name: G-codes in tenths, else one of the negative kinds.

    ``G01`` and ``g1`` are the same; an empty name continues the last motion (a modal line).
    """
    name = name.strip().upper()
    if not name:
        return MODAL
    if name[0] in "(;%/":  # comments, program marks and disabled lines
        return COMMENT
    match = _NAME.fullmatch(name)
    if match is None:
        return UNKNOWN
    letter, number, tenth = match[1], int(match[2]), int(match[3] or 0)
    if letter == "G":
        return 10 * number + tenth if number < 1000 else UNKNOWN
    if letter == "M" and number == 6:
        return TOOL_CHANGE
    return OTHER if letter in "MTSNO" else UNKNOWN


class Words:
    """Names, codes and parameter columns of a list of commands.

    Parameters
    ----------
    commands : iterable
        ``(name, parameters)`` pairs, or objects with ``.Name`` and ``.Parameters`` as FreeCAD's.
    """

    def __init__(self, commands: Iterable) -> None:
        commands = commands if isinstance(commands, Sequence) else list(commands)
        if len(commands) and hasattr(commands[0], "Parameters"):
            self.names = [c.Name for c in commands]
            self._parameters = [c.Parameters for c in commands]
        else:
            self.names = [c[0] for c in commands]
            self._parameters = [c[1] for c in commands]
        word_names = {name for name in set(self.names) if name and name[0] in "XYZIJKRFNxyzijkrfn \t"}
        if word_names:
            self._read_word_names(word_names)
        table = {name: code_of(name) for name in set(self.names)}
        self.codes = np.fromiter(map(table.__getitem__, self.names), np.int64, len(self.names))

    def __len__(self) -> int:
        return len(self.names)

    def _read_word_names(self, word_names: set[str]) -> None:
        """Turn ``X10`` into a modal line with an X word, and ``N10`` with a G word into that G-code."""
        for i, name in enumerate(self.names):
            match = _WORD_NAME.fullmatch(name) if name in word_names else None
            if match is None:
                continue
            letter, value = match[1].upper(), float(match[2])
            parameters = dict(self._parameters[i] or {})
            code = _number(parameters, "G")
            parameters.pop("G", None)
            self.names[i] = "" if code == _ABSENT else f"G{code:g}"
            if letter != "N":
                parameters[letter] = value
            elif not parameters and not self.names[i]:
                self.names[i] = name
            self._parameters[i] = parameters

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
        parameters = self._parameters if rows is None else [self._parameters[i] for i in rows.tolist()]
        try:
            values = np.fromiter((p.get(letter, _ABSENT) for p in parameters), np.float64, len(parameters))
        except (TypeError, ValueError, OverflowError, AttributeError):
            values = np.array([_number(p, letter) for p in parameters], np.float64)
        usable = np.abs(values) <= COORDINATE_LIMIT
        unusable = ~usable & (values != _ABSENT)
        values[~usable] = np.nan
        return values, unusable


def _number(parameters, letter: str) -> float:
    try:
        return float(parameters.get(letter, _ABSENT)) if parameters else _ABSENT
    except (TypeError, ValueError, OverflowError):
        return np.nan
