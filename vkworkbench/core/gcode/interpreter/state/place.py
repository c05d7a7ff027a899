# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the tool's position from an NC program's commands, for codes that depend on this position (G92, G5, @)."""

from __future__ import annotations

from collections.abc import Iterable
from math import nan

from vkworkbench.core.gcode.moves import codes
from vkworkbench.core.gcode.moves.codes import code_of
from vkworkbench.core.gcode.moves.commands import Commands
from vkworkbench.core.gcode.moves.cycles import Heights


class Place:
    """The position of the tool after the commands that were added so far.

    The position is computed only when `now` is called, so programs that do not need the position are not slowed down.

    Parameters
    ----------
    commands : Commands
        The commands of the program; commands can be added later.

    Attributes
    ----------
    lost : set of str
        Axes along which the tool moved to a position that the program does not contain. The method `now` updates this
        set of axes.
    """

    def __init__(self, commands: Commands) -> None:
        self.lost: set[str] = set()
        self._commands, self._read = commands, 0
        # For each call of `lose`: the number of commands before the call, and the axes whose position was lost.
        self._losses: list[tuple[int, set[str]]] = []
        self._at: dict[str, float] = {}
        self._motion, self._plane = -1, codes.XY_PLANE
        self._relative = self._to_retract_plane = False
        self._heights = Heights()

    def lose(self, letters: Iterable[str]) -> None:
        """Forget the position along some axes, because the tool moved to a position that is not in the program."""
        self._losses.append((len(self._commands), set(letters)))

    def move_end(self, command: int, way: complex) -> None:
        """Move the position by a vector in the XY plane, mm, after a change of the end point of the last move."""
        if command < self._read:
            self._at["X"], self._at["Y"] = self._at["X"] + way.real, self._at["Y"] + way.imag

    def now(self) -> dict[str, float]:
        """Return the coordinates of the tool, mm, for the axes along which its position is known."""
        for count, letters in [*self._losses, (len(self._commands), set())]:
            for index in range(self._read, count):
                name, words = self._commands[index]
                self._follow(code_of(name) if name else self._motion, words)
            self._read = count
            self.lost |= letters
            for letter in letters:
                self._at.pop(letter, None)
        self._losses.clear()
        return self._at

    def _follow(self, code: int, words: dict[str, float]) -> None:
        if code in (codes.ABSOLUTE, codes.RELATIVE):
            self._relative = code == codes.RELATIVE
        elif code in (codes.TO_START, codes.TO_RETRACT_PLANE):
            self._to_retract_plane = code == codes.TO_RETRACT_PLANE
        elif code in codes.PLANES:
            self._plane = code
        elif code in codes.MACHINE:
            self._at.pop("Z", None)
            self.lost.add("Z")
        elif code in codes.MOTIONS or code == codes.CANCEL:
            if code not in codes.CYCLES:
                self._heights.part()
            self._motion = code
            self._move(code, words)

    def _move(self, motion: int, words: dict[str, float]) -> None:
        drilled = codes.DRILLED[self._plane] if motion in codes.CYCLES else ""
        for letter in "XYZ":
            if letter == drilled:
                r, bottom = words.get("R", nan), words.get(letter, nan)
                height = self._heights.drill(self._at.get(letter), r, bottom, relative=self._relative,
                                             to_retract_plane=self._to_retract_plane)[3]  # fmt: skip
                if letter not in self.lost:
                    self._at[letter] = height
            elif letter in words and (letter not in self.lost or not self._relative):
                self._at[letter] = words[letter] + (self._at.get(letter, 0.0) if self._relative else 0.0)
                self.lost.discard(letter)
