# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert the words of an NC program into commands, in mm and mm/s.

This package converts units and feed rates to mm and mm/s, and puts the words of each line in the order of execution.
Planes, G90 and G91, the centres of arcs, and canned cycles are still in the commands, and `linearize` interprets them.
Each module contains a table of handlers for the G-codes of one subject.
"""

from __future__ import annotations

from vkworkbench.core.gcode.blocks import whole
from vkworkbench.core.gcode.dialects import HEIDENHAIN, Drilling
from vkworkbench.core.gcode.interpreter import (
    compensation,
    cycles,
    heidenhain,
    m_codes,
    mapping,
    offsets,
    single_moves,
    tools,
    units,
)
from vkworkbench.core.gcode.interpreter.motion import AXES, move_of
from vkworkbench.core.gcode.interpreter.state.line import Line
from vkworkbench.core.gcode.interpreter.state.machine import Handler, Machine
from vkworkbench.core.gcode.moves import codes
from vkworkbench.core.gcode.moves.commands import Commands
from vkworkbench.language import Message

_MOST_CODES = 1000
_DEEP = "CYCLE83"  # Siemens' cycle that drills a hole in several pecks
# Words that controls process before the other words of a line: units, modes, planes and work offsets.
_FIRST = frozenset(("G", code / 10) for code in codes.UNITS | codes.KEPT | codes.OFFSETS)
_HANDLERS: dict[int, Handler] = {
    **units.HANDLERS, **offsets.HANDLERS, **compensation.HANDLERS, **cycles.HANDLERS, **mapping.HANDLERS, **single_moves.HANDLERS,
}  # fmt: skip


class Interpreter(Machine):
    """A machine that reads the lines of a program one after the other, and stores their commands."""

    @property
    def moves(self) -> bool:
        """Whether any command of the lines read so far moves the tool."""
        return any(
            (not name or name in codes.MOTION_NAMES) and not AXES.isdisjoint(words) for name, words in self.commands
        )

    def with_tool_changes(self) -> Commands:
        """Return the commands; in a program without M6, each T word with a new number is a tool change."""
        return tools.with_changes(self)

    def block(self, number: int, words: list[tuple[str, float]], letters: set[str], *, deleted: bool) -> bool:
        """Process the words of one program line.

        Parameters
        ----------
        number : int
            Line of the text, counted from 1.
        words : list of (str, float)
            The words in the order of the line.
        letters : set of str
            The letters of the words.
        deleted : bool
            Whether the line has a block delete.

        Returns
        -------
        bool
            Whether the line ends the program or subprogram at once (M99). The result is False for M2 and M30, which set
            `ended` instead.
        """
        self.number, self.deleted, self.call = number, deleted, None
        if self.dialect.modes_in_line:
            words = heidenhain.cartesian(self, self._in_one_distance_mode(words))
            letters = {letter for letter, _ in words}
        line = Line(words, letters, {})
        returns = self._take_words(line)
        if "S" in letters and self.modes.per_turn is not None:  # under G95, a new spindle speed changes the feed rate
            line.parameters.setdefault("F", self.modes.per_turn)
        if line.codes or "F" in line.parameters:
            self._note_feed(line)
        both = codes.ABSOLUTE in line.codes and codes.RELATIVE in line.codes and not self.dialect.modes_in_line
        if both and not (line.apart or letters.isdisjoint("XYZ")):
            self.problem(Message("two-motions"))
        move_of(self, line)
        if self.drilling is not None and not (line.apart or letters.isdisjoint("XY")):
            self._drill(self.drilling)
        self.ended |= ("M", 2.0) in words or ("M", 30.0) in words
        return returns

    def drill(self, number: int, cycle: Drilling) -> None:
        """Drill a hole with a cycle of a Siemens control, or begin or end a modal cycle."""
        self.number = number
        if cycle.name == _DEEP:
            self.problem(Message("pecks-not-read", name=cycle.name))
        if cycle.modal:
            self.drilling = cycle if cycle.name else None
        else:
            self._drill(cycle)

    def _drill(self, cycle: Drilling) -> None:
        """Add the moves of a Siemens control's cycle, which leaves the modal state unchanged."""
        motion, distance = self.motion, self.modes.distance
        for mode, height in zip((codes.RAPID, codes.FEED, codes.RAPID), cycle.heights):
            words = [("G", mode / 10), ("G", codes.ABSOLUTE / 10), ("Z", height)]
            self.block(self.number, words, {"G", "Z"}, deleted=self.deleted)
        self.block(self.number, [("G", distance / 10)], {"G"}, deleted=self.deleted)
        self.motion = motion

    def _in_one_distance_mode(self, words: list[tuple[str, float]]) -> list[tuple[str, float]]:
        """Return the words of a line, with all coordinates converted to the distance mode at the line's end."""
        absolute, incremental = ("G", codes.ABSOLUTE / 10), ("G", codes.RELATIVE / 10)
        modes = [word for word in words if word in (absolute, incremental)]
        if not modes:
            return words
        relative, here, result = self.modes.relative, self.coordinates(), []
        for letter, value in words:
            if (letter, value) in modes:
                relative = (letter, value) == incremental
            elif letter in "XYZ" and relative != (modes[-1] == incremental):
                if letter not in here:
                    self.problem(Message("word-not-read", letter=letter))
                    continue
                value += here[letter] if relative else -here[letter]
            result.append((letter, value))
        return result

    def _take_words(self, line: Line) -> bool:
        """Process the codes and the tools of a line, and store the parameters of its motion.

        Returns
        -------
        bool
            Whether the line ends the program or subprogram at once (M99).
        """
        parameters, letters = line.parameters, line.letters
        returns = change = False
        taken: frozenset[str] = frozenset()  # letters of the words that are parameters of an M-code
        for letter, value in sorted(line.words, key=lambda word: word not in _FIRST):
            if letter == "G":
                self._g_code(whole(10 * value, 10 * _MOST_CODES), line)
            elif letter == "M":
                change |= value == 6
                if value in self.dialect.to_machine:
                    axes = letters & set("XYZ")
                    offsets.leave_program(self, line, axes, codes.MACHINE_COORDINATES, f"M{value:.0f}")
                returns |= m_codes.process(self, value, letters)
                taken |= m_codes.words_of(value, letters, first=not parameters and "G" not in letters)
            elif letter == "S":
                self.spindle = value
            elif letter not in "NOT":
                if letter in parameters:
                    self.problem(Message("word-twice", letter=letter))
                parameters[letter] = value
        for letter in taken:
            parameters.pop(letter, None)
        if change or ("T" in letters and "T" not in taken):
            tools.take(self, line, change=change)
        return returns

    def _note_feed(self, line: Line) -> None:
        per_minute = self.modes.feed_mode == codes.PER_MINUTE
        feed = self.modes.feed_unit * line.parameters.get("F", 0.0) if per_minute else 0.0
        mode = self.motion if line.motion is None else line.motion
        self.clues.feed(line.codes, line.parameters, mode, feed, self.number)

    def enter_call(self) -> None:
        """Begin a subprogram. Each subprogram can save and restore its own modal state (M70 to M73)."""
        self.saved.append((None, False))

    def leave_call(self) -> None:
        """Return from a subprogram, and restore the modal state that an M73 in the subprogram saved."""
        modes, on_return = self.saved.pop()
        if on_return:
            m_codes.restore(self, modes)

    def heidenhain(self, number: int, unit: int) -> bool:
        """Begin or end a program in Heidenhain's DIN/ISO, in which the centres of arcs are absolute coordinates.

        Parameters
        ----------
        number : int
            Line of the text, counted from 1.
        unit : int
            Ten times the G-code of the unit: 700 (G70) for inches, 710 (G71) for mm.

        Returns
        -------
        bool
            Whether the line ends the program.
        """
        if self.dialect is HEIDENHAIN:
            return True
        self.number, self.dialect = number, HEIDENHAIN
        self.measure_in(unit)
        self.add("G90.1", {})
        return False

    def _knows(self, code: int) -> bool:
        """Return whether a G-code has its usual meaning in the program's dialect."""
        return self.dialect.codes is None or code in self.dialect.codes

    def _g_code(self, code: int, line: Line) -> None:
        """Process a G-code."""
        if code in codes.MOTIONS and line.motion not in (None, code) and self._knows(code):
            self.problem(Message("two-motions"))
        line.codes.append(code)
        if self.dialect is HEIDENHAIN and code in heidenhain.HANDLERS:
            heidenhain.HANDLERS[code](self, line)
        elif not self._knows(code):
            if code not in self.dialect.data:
                self.unknown(code, line)
            line.apart, line.feeds = True, False
        elif code in codes.MOTIONS:
            line.motion = code
        else:
            handler = _HANDLERS.get(code)
            if handler is None:
                self.other(line)
            else:
                handler(self, line)
