# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random access to the G-code lines of a path. FreeCAD can only return all commands of a path together."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

# FreeCAD writes every number with six decimals.
_NUMBER = re.compile(r"([A-Z])(-?\d+\.\d+)")


class Listing:
    """The G-code of a path (`text`), one line for each command number.

    If comments contain line breaks, the lines are made from the commands, not from the text.
    """

    def __init__(self, text: str, commands: Sequence = ()) -> None:
        self.in_minutes = False  # whether feeds are in mm/min, as in NC programs; FreeCAD's own feeds are in mm/s
        self._set(text)
        if len(self) != len(commands):
            self._set("".join(command.toGCode().replace("\n", " ") + "\n" for command in commands))

    def _set(self, text: str) -> None:
        self._text = text.encode(errors="replace")
        self._ends = np.flatnonzero(np.frombuffer(self._text, np.uint8) == ord("\n"))

    def __len__(self) -> int:
        return len(self._ends)

    def __getitem__(self, command: int) -> str:
        """Return the G-code of a command as in a program: feeds in mm/min, at most three decimals."""
        begin = self._ends[command - 1] + 1 if command else 0
        code = self._text[begin : self._ends[command]].decode()
        return code if code.startswith("(") else _NUMBER.sub(self._word, code)

    def _word(self, found: re.Match[str]) -> str:
        letter, number = found[1], float(found[2])
        if letter == "F" and not self.in_minutes:
            number *= 60
        shown = f"{number:.3f}".rstrip("0").rstrip(".")
        return letter + ("0" if shown == "-0" else shown)
