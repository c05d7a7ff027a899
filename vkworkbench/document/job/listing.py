# SPDX-License-Identifier: LGPL-2.1-or-later
"""The G-code of a toolpath, any line of it at once: FreeCAD gives a path's commands only all together."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

# FreeCAD writes six decimals of every number.
_NUMBER = re.compile(r"([A-Z])(-?\d+\.\d+)")


class Listing:
    """The G-code of a path's commands, by their numbers.

    Parameters
    ----------
    text : str
        A line for each command.
    commands : sequence of Command
        For a path in whose comments there are ends of lines.

    Attributes
    ----------
    in_minutes : bool
        Whether its feeds are mm/min, as programs have them; those of FreeCAD's own operations are mm/s.
    """

    def __init__(self, text: str, commands: Sequence = ()) -> None:
        self.in_minutes = False
        self._set(text)
        if len(self) != len(commands):
            self._set("".join(command.toGCode().replace("\n", " ") + "\n" for command in commands))

    def _set(self, text: str) -> None:
        self._text = text.encode(errors="replace")
        self._ends = np.flatnonzero(np.frombuffer(self._text, np.uint8) == ord("\n"))

    def __len__(self) -> int:
        return len(self._ends)

    def __getitem__(self, command: int) -> str:
        """The G-code of a command as programs have it: feeds in mm/min, three decimals at most.

        Raises
        ------
        IndexError
            Where there is none with this number.
        """
        begin = self._ends[command - 1] + 1 if command else 0
        code = self._text[begin : self._ends[command]].decode()
        return code if code.startswith("(") else _NUMBER.sub(self._word, code)

    def _word(self, found: re.Match[str]) -> str:
        letter, number = found[1], float(found[2])
        if letter == "F" and not self.in_minutes:
            number *= 60
        shown = f"{number:.3f}".rstrip("0").rstrip(".")
        return letter + ("0" if shown == "-0" else shown)
