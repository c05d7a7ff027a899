# SPDX-License-Identifier: LGPL-2.1-or-later
"""Store a list of commands in a tenth of the memory that names and dictionaries would need."""

from __future__ import annotations

from array import array
from collections.abc import Iterator, Mapping

import numpy as np


class Commands:
    """A list of (name, parameters) pairs.

    An index returns a new pair, so changing the pair's parameters does not change the list.

    Attributes
    ----------
    names : list of str
        Name of each command.
    """

    def __init__(self) -> None:
        self.names: list[str] = []
        self._letters: list[str] = []
        self._known: dict[str, str] = {}  # each name and each sequence of letters is stored only once
        self._first, self._values = array("q"), array("d")

    def append(self, command: tuple[str, Mapping[str, float]]) -> None:
        """Add a command; the names of its parameters are single letters."""
        name, parameters = command
        letters = "".join(parameters)
        self.names.append(self._known.setdefault(name, name))
        self._letters.append(self._known.setdefault(letters, letters))
        self._first.append(len(self._values))
        self._values.extend(parameters.values())

    def extend(self, names: list[str], letters: list[str], counts: np.ndarray, values: np.ndarray) -> None:
        """Add commands.

        Parameters
        ----------
        names, letters : list of str
            For each command, its name and the letters of its parameters.
        counts : (n,) int64
            Number of parameters of each command.
        values : (m,) float64
            The values of all parameters, command after command.
        """
        first = len(self._values) + np.cumsum(counts) - counts
        self.names += names
        self._letters += letters
        self._first.frombytes(first.tobytes())
        self._values.frombytes(values.tobytes())

    def __setitem__(self, index: int, command: tuple[str, Mapping[str, float]]) -> None:
        self.append(command)
        self.names[index] = self.names.pop()
        self._letters[index] = self._letters.pop()
        self._first[index] = self._first.pop()

    def table(self) -> tuple[np.ndarray, str, np.ndarray]:
        """Return the number of parameters of each command, and the letters and the values of all parameters."""
        counts = np.fromiter(map(len, self._letters), np.int64, len(self))
        values, first = np.array(self._values), np.array(self._first)
        behind = first - (np.cumsum(counts) - counts)  # skip the values of replaced commands
        if behind.any() or len(values) > counts.sum():
            values = values[np.repeat(behind, counts) + np.arange(counts.sum())]
        return counts, "".join(self._letters), values

    def __len__(self) -> int:
        return len(self.names)

    def __getitem__(self, index: int) -> tuple[str, dict[str, float]]:
        letters, first = self._letters[index], self._first[index]
        return self.names[index], dict(zip(letters, self._values[first : first + len(letters)]))

    def __iter__(self) -> Iterator[tuple[str, dict[str, float]]]:
        return map(self.__getitem__, range(len(self)))
