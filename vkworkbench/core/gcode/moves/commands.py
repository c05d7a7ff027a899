# SPDX-License-Identifier: LGPL-2.1-or-later
"""A list of commands that needs a tenth of the memory of a list of names and dictionaries."""

from __future__ import annotations

from array import array
from collections.abc import Iterator, Mapping


class Commands:
    """A list of (name, parameters) pairs.

    Indexing creates a new pair, so a change in the parameters of the pair does not change the list.

    Attributes
    ----------
    names : list of str
        Name of each command.
    """

    def __init__(self) -> None:
        self.names: list[str] = []
        self._letters: list[str] = []
        self._known: dict[str, str] = {}  # each different name or sequence of letters is stored once
        self._first, self._values = array("q"), array("d")

    def append(self, command: tuple[str, Mapping[str, float]]) -> None:
        """Add a command; the names of its parameters are single letters."""
        name, parameters = command
        letters = "".join(parameters)
        self.names.append(self._known.setdefault(name, name))
        self._letters.append(self._known.setdefault(letters, letters))
        self._first.append(len(self._values))
        self._values.extend(parameters.values())

    def __setitem__(self, index: int, command: tuple[str, Mapping[str, float]]) -> None:
        self.append(command)
        self.names[index] = self.names.pop()
        self._letters[index] = self._letters.pop()
        self._first[index] = self._first.pop()

    def __len__(self) -> int:
        return len(self.names)

    def __getitem__(self, index: int) -> tuple[str, dict[str, float]]:
        letters, first = self._letters[index], self._first[index]
        return self.names[index], dict(zip(letters, self._values[first : first + len(letters)]))

    def __iter__(self) -> Iterator[tuple[str, dict[str, float]]]:
        return map(self.__getitem__, range(len(self)))
