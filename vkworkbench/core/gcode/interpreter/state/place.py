# SPDX-License-Identifier: LGPL-2.1-or-later
"""Follow the place of the tool through the commands of a program, for the codes that depend on it (G92, G5, @)."""

from __future__ import annotations

from collections.abc import Iterable
from math import nan

from vkworkbench.core.gcode.moves import codes
from vkworkbench.core.gcode.moves.codes import code_of
from vkworkbench.core.gcode.moves.commands import Commands
from vkworkbench.core.gcode.moves.cycles import Heights

_DRILLED = {170: "Z", 180: "Y", 190: "X"}  # the axis of canned cycles in each plane


class Place:
    """The place of the tool after the commands that were added so far.

    The commands are followed only when the place is asked for, so that other programs cost no time.

    Parameters
    ----------
    commands : Commands
        The commands of the program, which may still grow.

    Attributes
    ----------
    lost : set of str
        Axes along which the tool moved to a place that the program does not contain; up to date after `now`.
    """

    def __init__(self, commands: Commands) -> None:
        self.lost: set[str] = set()
        self._commands, self._read = commands, 0
        self._losses: list[tuple[int, set[str]]] = []  # axes whose place was lost, with the number of commands before
        self._at: dict[str, float] = {}
        self._motion, self._plane = -1, 170
        self._relative = self._to_retract_plane = False
        self._heights = Heights()

    def lose(self, letters: Iterable[str]) -> None:
        """Forget the place along some axes, because the tool moved to a place that is not in the program."""
        self._losses.append((len(self._commands), set(letters)))

    def now(self) -> dict[str, float]:
        """Return the coordinates of the tool, mm, for the axes along which its place is known."""
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
        drilled = _DRILLED[self._plane] if motion in codes.CYCLES else ""
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
