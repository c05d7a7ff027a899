# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find signs of the machine for which an NC program was written, for example a lathe, in the program's words."""

from __future__ import annotations

from vkworkbench.core.gcode.moves.codes import CYCLES
from vkworkbench.language import Message

_TURNING = frozenset([32])
_TURNING_MODES = frozenset([7, 8, 96])
_TURNING_CYCLES = frozenset([70, 71, 72, 76])
_PRINTER = frozenset([104, 109, 140, 190])
_SLOWEST_MILLING = 2.0  # mm/min; a lower feed rate is probably a feed per turn (G99) of a lathe.
_EXTRUSIONS = 10  # Largest number of moves whose E words count as typing errors; more are a sign of a 3D printer.


class Clues:
    """Signs, found in the words of an NC program, of the machine for which the program was written.

    Attributes
    ----------
    rotary : list of int
        Lines in which a rotary axis turns while the tool cuts.
    """

    def __init__(self) -> None:
        self.rotary: list[int] = []
        self._turns: dict[str, float] = {}
        self._turning: tuple[str, int] | None = None
        self._mode: tuple[str, int] | None = None
        self._incremental: tuple[str, int] | None = None
        self._plane: tuple[str, int] | None = None
        self._turret: tuple[str, int] | None = None
        self._changer = False
        self._mills = False
        self._per_turn: int | None = None  # line of the last G99 outside of canned cycles; None after G98
        self._slow: tuple[str, int] | None = None
        self._printer: tuple[str, int] | None = None
        self._extrusions: list[int] = []
        self._wire: list[int] = []
        self._names_y = self._along_y = False

    def g_code(self, number: int, letters: set[str], line: int) -> bool:
        """Note a G-code that indicates the machine; return whether the G-code's line is a cut on a lathe."""
        cycle = number in _TURNING_CYCLES and not letters.isdisjoint("PQUW") and "Y" not in letters
        mode = number in _TURNING_MODES and "P" not in letters  # on Fanuc controls, G08 P1 turns on look-ahead
        if self._turning is None and (number in _TURNING or cycle):
            self._turning = f"G{number}", line
        if self._mode is None and mode:
            self._mode = f"G{number}", line
        if number == 18 and self._plane is None:
            self._plane = "G18", line
        self._mills |= number == 43 and "H" in letters
        return number in _TURNING or cycle

    def m_code(self, value: float, letters: set[str], line: int) -> None:
        """Note an M-code that indicates the machine.

        The codes M104, M109, M140 and M190 indicate a 3D printer only with an S or R word (the temperature), because
        these codes have various meanings on mills.
        """
        if value in _PRINTER and self._printer is None and not letters.isdisjoint("SR"):
            self._printer = f"M{value:g}", line
        self._changer |= value == 6

    def tool(self, number: int, line: int) -> None:
        """Note a tool number that indicates a lathe.

        A number such as T0101 (tool 1 with offset 1) indicates the turret of a lathe.
        """
        if self._turret is None and 0 < number < 10_000 and number % 101 == 0:
            self._turret = f"T{number:04}", line

    def feed(self, codes: list[int], parameters: dict[str, float], mode: int, feed: float, line: int) -> None:
        """Note a feed rate that indicates a lathe. Lathes use G99 for feed per turn, and G98 for feed per minute.

        A feed rate below `_SLOWEST_MILLING` is too slow for milling, and is probably a feed per turn.

        Parameters
        ----------
        codes : list of int
            The line's G-codes, as ten times their numbers (200 for G20).
        parameters : dict
            The line's words, without G, M, S, T, N and O words.
        mode : int
            The G-code of the motion in force, as ten times its number (10 for G1).
        feed : float
            The line's feed rate, mm/min; 0 without an F word, and under G93 and G95.
        line : int
            Line of the text, counted from 1.
        """
        if mode in CYCLES:  # in canned cycles of mills, G98 and G99 select the height after the cycle
            return
        if 980 in codes or 990 in codes:
            self._per_turn = line if 990 in codes else None
        if self._slow is None and 0 < feed < _SLOWEST_MILLING:
            # On lathes, G90 with X and Z words is a turning cycle.
            if codes == [900] and "X" in parameters and "Z" in parameters:
                self._slow = "G90", line
            elif self._per_turn is not None and mode > 0:
                self._slow = "G99", self._per_turn

    @property
    def notes_feeds(self) -> bool:
        """bool : Whether the feed rate of a move can indicate the machine."""
        return self._per_turn is not None

    def axes(self, parameters: dict[str, float], cuts: bool, line: int) -> None:
        """Note words for axes other than X, Y and Z, which can indicate another machine than a mill."""
        for letter in "ABC":
            value = parameters.get(letter)
            if value is not None and value != self._turns.get(letter):
                if cuts and (value or letter in self._turns):  # an axis is at 0 until its first word
                    self.rotary.append(line)
                self._turns[letter] = value
        if self._incremental is None and not {"U", "W"}.isdisjoint(parameters):
            self._incremental = "U, W", line
        if "E" in parameters and ("X" in parameters or "Y" in parameters):
            self._extrusions.append(line)
        if cuts and "U" in parameters and "V" in parameters:
            self._wire.append(line)

    def arc(self, letters: set[str], line: int) -> None:
        """Note an arc in X and Z without a previous G18: a sign of a lathe, whose only plane is XZ."""
        if self._plane is None and "Z" in letters and letters.isdisjoint("YJ"):
            if "K" in letters:
                self._plane = "K", line
            elif {"X", "R"} <= letters:
                self._plane = "R", line

    def y(self, moves: bool) -> None:
        """Note a Y word, and whether the Y word moves the tool.

        A program for a lathe does not move the tool along Y, but can contain Y0 if the lathe can also mill.
        """
        self._names_y = True
        self._along_y |= moves

    def other_machine(self) -> Message | None:
        """Return a message with the program's machine and the word that indicates the machine; None for a mill."""
        heats = None if self._mills or self._changer else self._printer
        if heats or len(self._extrusions) > _EXTRUSIONS:
            name, line = heats or ("E", self._extrusions[0])
            return Message("printing", name=name, line=line)
        if self._wire:
            return Message("wire", name="U, V", line=self._wire[0])
        plane = None if self._names_y else self._plane
        turret = None if self._changer else self._turret
        weak = None if self._mills else self._mode or plane or self._slow or turret
        turned = self._turning or weak or self._incremental
        if not self._along_y and turned:
            name, line = turned
            return Message("lathe", name=name, line=line)
        return None
