# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert the words of an NC program into commands, in mm and mm/s.

The commands keep the modal state that `linearize` resolves: planes, G90/G91, the centres of arcs, canned cycles. This
module resolves units, feed rates and the order of words.
"""

from __future__ import annotations

import math
from array import array
from dataclasses import dataclass, replace
from typing import Callable, ClassVar, Dict

from vkworkbench.core.gcode import dialects, splines
from vkworkbench.core.gcode.blocks import LARGEST_NUMBER, whole
from vkworkbench.core.gcode.flow import calls_block
from vkworkbench.core.gcode.modes import GROUPS, Modes
from vkworkbench.core.gcode.moves import codes
from vkworkbench.core.gcode.moves.commands import Commands
from vkworkbench.core.gcode.moves.unread import ROTARY
from vkworkbench.core.gcode.origins import NUMBERED, Origins
from vkworkbench.core.gcode.place import Place
from vkworkbench.language import Message

_OUTPUTS = frozenset([67, 68])  # LinuxCNC's M-codes for analog outputs, for example to a laser, with E and Q words
_SETTINGS = frozenset([92, 201, 203, 204, 205, 206])  # Marlin's M-codes for steps/mm, speeds and accelerations
_OTHERS_M_CODE = 1000  # first number of the vendors' own M-codes, for example Snapmaker's M2000
_ORIENT = 19  # M19 turns the spindle to the angle in its R word
_SPINDLE = frozenset([3, 4, 5])
# M-codes at which the operator or the tool changer may move the tool.
_STOPS = frozenset([0, 1, 6, 60, 600])
_SAVE, _FORGET, _RESTORE, _SAVE_FOR_CALL = 70, 71, 72, 73  # LinuxCNC's M-codes for the modal state
_LATHE_CYCLE = frozenset("PQUWR")  # with these words, G70 to G72 are turning cycles, not units
_HOLE_PATTERN = frozenset("IJKL")  # with these words, G70 to G72 are patterns of holes on Haas and Yasnac
_AXES = frozenset("XYZIJKR")
_LENGTHS = frozenset("XYZIJKRQ")
_COORDINATES = {"X": "X", "Y": "Y", "Z": "Z"}  # letters of absolute coordinates, and their axes
_OF_CYCLES = {**_COORDINATES, "R": "Z"}
_OF_ARCS = {**_COORDINATES, "I": "X", "J": "Y", "K": "Z"}  # for arcs with absolute centres (G90.1)
_POLAR = "@^"  # LinuxCNC's polar coordinates: distance from the origin, and angle
_KNOWN = _LENGTHS | {"F", "S", "P", "L", "H", "D", *_POLAR}
_MOST_CODES, _MOST_REPEATS = 1000, 10_000


_Handler = Callable[["Interpreter", "_Line"], None]
_Shape = Callable[["Interpreter", "_Line", Dict[str, float]], None]


@dataclass
class _Line:
    """The words of a line, with the effects of its G-codes.

    Attributes
    ----------
    words : list of (str, float)
        The words in the order of the line.
    letters : set of str
        The letters of the words.
    motion : int or None
        The motion that the line selects, in tenths of its G-code; None if the line selects none.
    code : int
        The G-code that is processed, in tenths.
    once : int or None
        A code that moves the tool in this line only: a probe, a thread or a spline.
    apart : bool
        Whether the line's axis words are parameters of a code, not the target of a move.
    feeds : bool
        Whether an F word is a feed rate, not a parameter of a code.
    """

    words: list[tuple[str, float]]
    letters: set[str]
    motion: int | None = None
    code: int = -1
    once: int | None = None
    apart: bool = False
    feeds: bool = True

    def lengths(self, unit: float) -> dict[str, float]:
        """Return the X, Y and Z words, mm."""
        return {letter: unit * value for letter, value in self.words if letter in "XYZ"}


class Interpreter:
    """The commands of the lines read so far, and the state in which these lines leave the machine.

    Attributes
    ----------
    commands, lines, inverse_time
        As in `Program`.
    clues : Clues
        Signs of the machine for which the program was written.
    first_unit : float or None
        The program's first unit, mm: 25.4 for inches, 1 for mm; None before the first unit word.
    problems : dict of Message to list of int
        Messages on the parts of the program that were not read, with their lines.
    motion : int
        The motion in force, in tenths of its G-code; -1 before the first motion.
    ended : bool
        Whether M2 or M30 was read.
    call : float or None
        The M-code with which the last line calls a subprogram; None if the line calls none. The caller of `block` must
        run the subprogram.
    calls_blocks : bool
        Whether the program calls subprograms by block numbers (M97, or M98 with Q).

    Parameters
    ----------
    dialect : Dialect
        How this program differs from others.
    """

    def __init__(self, dialect: dialects.Dialect) -> None:
        self.dialect = dialect
        self.commands = Commands()
        self.lines = array("q")
        self.inverse_time: dict[int, float] = {}
        self.problems: dict[Message, list[int]] = {}
        self.clues = dialects.Clues()
        self.modes = Modes()
        # The modal state that M70 or M73 saved at each level of calls, and whether the return restores it (M73).
        self.saved: list[tuple[Modes | None, bool]] = [(None, False)]
        self.origins = Origins()
        self.place = Place(self.commands)
        self.first_unit: float | None = None
        self.motion = -1
        self.written = -1  # the motion of the last command that moves the tool
        self.moved = False
        self.length_changed = False  # whether the tool length offset changed since the last Z word
        self.y: float | None = None  # last absolute Y, mm
        # Lines of moves to machine positions since the last other move, with their messages. They are reported only if
        # another move follows.
        self.away: list[tuple[int, Message]] = []
        self.okuma = False  # whether work offsets are selected with G15 H
        self.spindle = 0.0  # spindle speed, turns/min
        self.stands = False  # whether the last move used G95 while the spindle speed was 0
        self.tool: int | None = None  # number in the last T word
        self.changes = False  # whether the program contains an M6; without M6, T words change the tool
        self.spindle_tool: int | None = None  # number of the tool after the last M6
        # Index of the last M6 since the last move, if no T word before the M6 names a new tool.
        self.unnamed: int | None = None
        self.seconds = 0.0  # duration of this line's move under G93, s; 0 under other feed modes
        self.later: dict[str, float] | None = None  # words of a canned cycle with L0, which drills no hole yet
        self.angles: dict[str, float] = {}  # last values of the rotary axes
        self.pole: dict[str, float] | None = None  # Heidenhain's centre for the next arcs, mm; None in other programs
        self.number = 0  # current line, counted from 1
        self.deleted = False  # whether this line has a block delete
        self.call: float | None = None
        self.calls_blocks = False
        self.ended = False

    def problem(self, what: Message, line: int | None = None) -> None:
        """Store a message on a part of the program that is not read, with its line or else the current line."""
        self.problems.setdefault(what, []).append(self.number if line is None else line)

    @property
    def moves(self) -> bool:
        """Whether any command moves the tool."""
        return any(
            (not name or name in codes.MOTION_NAMES) and not _AXES.isdisjoint(words) for name, words in self.commands
        )

    def with_tool_changes(self) -> Commands:
        """Return the commands; in a program without M6, each T word with a new number becomes a tool change."""
        if self.changes:
            return self.commands
        tool = None
        for at, name in enumerate(self.commands.names):
            if name[:1] == "T":
                number = int(name[1:])
                self.commands[at] = ("M6", {"T": number}) if number != tool else ("G94", {})
                tool = number
        return self.commands

    def block(self, number: int, words: list[tuple[str, float]], letters: set[str], *, deleted: bool) -> bool:
        """Read the words of one line.

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
            Whether the line ends the program or subprogram at once (M99). M2 and M30 set `ended` instead.
        """
        self.number, self.deleted, self.call = number, deleted, None
        line = _Line(words, letters)
        ended, last, change = False, False, False
        taken: frozenset[str] = frozenset()  # letters of words that belong to an M-code
        g_codes: list[int] = []
        parameters: dict[str, float] = {}
        for letter, value in words:
            if letter == "G":
                code = whole(10 * value, 10 * _MOST_CODES)
                g_codes.append(code)
                if code in codes.MOTIONS and line.motion not in (None, code) and self._knows(code):
                    self.problem(Message("two-motions"))
                self._g_code(code, line)
            elif letter == "M":
                change |= value == 6
                ended |= self._m_code(value, letters)
                taken |= _words_of(value, letters, first=not parameters and "G" not in letters)
                last |= value in (2, 30)
            elif letter == "S":
                self.spindle = value
            elif letter not in "NOT":
                if letter in parameters:
                    self.problem(Message("word-twice", letter=letter))
                parameters[letter] = value
        if taken:
            words = [(letter, value) for letter, value in words if letter not in taken]
            parameters = {letter: value for letter, value in parameters.items() if letter not in taken}
        tools = [value // 1 for letter, value in words if letter == "T"]  # T9.10 is tool 9 with offset 10
        self._take_tools([whole(tool, LARGEST_NUMBER) for tool in tools], change)
        if "S" in letters and self.modes.per_turn is not None:  # under G95, a new speed changes the feed rate
            parameters.setdefault("F", self.modes.per_turn)
        if g_codes or "F" in parameters:
            per_minute = self.modes.feed_mode == codes.PER_MINUTE
            feed = self.modes.feed_unit * parameters.get("F", 0.0) if per_minute else 0.0
            mode = self.motion if line.motion is None else line.motion
            self.clues.feed(g_codes, parameters, mode, feed, self.number)
        self._move(line, parameters)
        self.ended |= last
        return ended

    def enter_call(self) -> None:
        """Begin a subprogram, which saves and restores its own modal state (M70 to M73)."""
        self.saved.append((None, False))

    def leave_call(self) -> None:
        """Return from a subprogram, and restore the modal state that M73 saved in it."""
        modes, on_return = self.saved.pop()
        if on_return:
            self._restore(modes)

    def heidenhain(self, number: int, unit: int) -> bool:
        """Begin or end a program in Heidenhain's DIN/ISO, in which the centres of arcs are absolute coordinates.

        Parameters
        ----------
        number : int
            Line of the text, counted from 1.
        unit : int
            G-code of the unit, in tenths: 700 for inches, 710 for mm.

        Returns
        -------
        bool
            Whether the line ends the program.
        """
        if self.pole is not None:
            return True
        self.number, self.pole = number, {}
        self._measure_in(unit)
        self._add("G90.1", {})
        return False

    def _restore(self, saved: Modes | None) -> None:
        """Restore a saved modal state: the commands that follow get the codes and the feed rate that differ."""
        if saved is None:
            return
        for group in ("plane", "distance", "centres", "retract"):
            code = getattr(saved, group)
            if code != getattr(self.modes, group):
                self._add(codes.name_of(code), {})
        if saved.feed not in (None, self.modes.feed):
            self._add("G94", {"F": saved.feed})
        offset = self.modes.offset
        self.modes = replace(saved)
        self.modes.offset = offset
        self._select(saved.offset)

    def _shifted(self, mode: int, move: dict[str, float]) -> dict[str, float]:
        """Return a move with the origin in force added to its coordinates."""
        centres = self.modes.absolute_centres and mode in codes.ARCS
        if self.modes.relative:
            along = {"I": "X", "J": "Y", "K": "Z"} if centres else {}
        else:
            along = _OF_CYCLES if mode in codes.CYCLES else _OF_ARCS if centres else _COORDINATES
        return {
            letter: value + self.origins.of(along[letter]) if letter in along else value
            for letter, value in move.items()
        }

    def _knows(self, code: int) -> bool:
        """Return whether a G-code has its usual meaning in this program; in Heidenhain's DIN/ISO only some codes do."""
        return self.pole is None or code in codes.HEIDENHAIN

    def _g_code(self, code: int, line: _Line) -> None:
        """Process a G-code."""
        if not self._knows(code):
            if code not in codes.HEIDENHAIN_DATA:
                self._unknown(code, line.letters)
            line.apart, line.feeds = True, False
        elif code in codes.MOTIONS:
            line.motion = code
        elif code in codes.KEPT:
            self._state(code)
        else:
            line.code = code
            self._HANDLERS.get(code, Interpreter._other)(self, line)

    def _add(self, name: str, parameters: dict[str, float]) -> None:
        self.commands.append((name, parameters))
        self.lines.append(self.number)

    def _take_tools(self, tools: list[int], change: bool) -> None:
        """Process the T words of a line and its tool change, if `change`.

        The tool change loads the tool of the first T word; a second T word preselects the next tool.
        """
        for named in tools:
            self.clues.tool(named, self.number)
            self._add(f"T{named}", {})  # a tool change if the program contains no M6, see `with_tool_changes`
        # Fagor: M6 in one line and the T word in a later line. Move the tool change to the T word.
        if tools and not change and self.unnamed is not None:
            self.commands[self.unnamed] = "G94", {}
            change = True
        if change:
            self.changes = True
            tool = tools[0] if tools else self.tool
            self._add("M6", {} if tool is None else {"T": tool})
            self.unnamed = len(self.commands) - 1 if not tools and tool in (None, self.spindle_tool) else None
            self.spindle_tool = tool
        self.tool = tools[-1] if tools else self.tool

    def _measure_in(self, code: int) -> None:
        self.modes.measure_in(code, siemens=self.dialect.siemens)
        if self.first_unit is None:
            self.first_unit = self.modes.unit

    def _centred(self, mode: int, move: dict[str, float]) -> dict[str, float]:
        """Return a Heidenhain move with the centre of its arc, from this line or from an earlier one."""
        centre = {letter: move.pop(letter) for letter in "IJK" if letter in move}
        if centre and self.modes.relative:  # relative to the tool's position, which is not known here
            self.pole = {}
            for letter in centre:
                self.problem(Message("word-not-read", letter=letter))
        elif self.pole is not None:
            self.pole.update(centre)
        is_arc = mode in codes.ARCS and "R" not in move and not {"X", "Y", "Z"}.isdisjoint(move)
        return {**move, **(self.pole or {})} if is_arc else move

    def _m_code(self, value: float, letters: set[str]) -> bool:
        """Process an M-code; return whether it ends the program or subprogram at once (M99)."""
        self.clues.m_code(value, letters, self.number)
        if value in _STOPS and self.moved:
            self.place.lose("XYZ")
        elif value in (_SAVE, _FORGET, _SAVE_FOR_CALL):
            self.saved[-1] = None if value == _FORGET else replace(self.modes), value == _SAVE_FOR_CALL
        elif value == _RESTORE:
            self._restore(self.saved[-1][0])
        if self.pole is not None:  # Heidenhain's M97 to M99 have other meanings
            return False
        if value == 98 or (value in (97, 198) and "P" in letters):
            self.call = value
            self.calls_blocks |= calls_block(value, letters)
        if value == 99 and (self.deleted or "P" in letters):
            self.problem(Message("jumps-not-followed"))
            return False
        return value == 99

    def _select(self, offset: tuple[int, float]) -> None:
        """Select a work offset; report it if the program does not contain its origin."""
        if offset == self.modes.offset:
            return
        self.modes.offset = offset
        if not self.moved:
            self.origins.system = offset
        elif not self.origins.select(offset):
            self.problem(Message("coordinates-not-changed", name=codes.name_of(offset[0])))

    def _state(self, code: int) -> None:
        """Process a modal G-code that `linearize` resolves, and add it to the commands."""
        if code in GROUPS:
            setattr(self.modes, GROUPS[code], code)
        if code == codes.CANCEL:
            self.motion = self.written = code
        elif code == 180:
            self.clues.g_code(18, set(), self.number)
        self._add(codes.name_of(code), {})

    # Handlers of G-codes, see `_HANDLERS`: each gets the line with the words and the code.

    def _unit(self, line: _Line) -> None:
        before = self.modes.unit
        self._measure_in(line.code)
        if self.moved and self.modes.unit != before and "F" in line.letters:  # LinuxCNC: in the unit before
            self.problem(Message("feed-in-new-unit", name=codes.name_of(line.code)))

    def _pattern(self, line: _Line) -> None:
        """Process G70 to G72: turning cycles, patterns of holes, or units."""
        name = codes.name_of(line.code)
        if line.letters.isdisjoint(_LATHE_CYCLE) and not line.letters.isdisjoint(_HOLE_PATTERN):
            line.feeds = False
            self._leave_out(line, Message("hole-pattern-not-read", name=name))
        # Okuma: G71 Z sets the return level of canned cycles.
        elif line.code == 710 and [letter for letter, _ in line.words if letter != "N"] == ["G", "Z"]:
            self._leave_out(line, Message("unknown-code", name=repr(name)))
        elif line.code in codes.UNITS and line.letters.isdisjoint(_LATHE_CYCLE):
            self._measure_in(line.code)
        else:
            self._other(line)

    def _feed_mode(self, line: _Line) -> None:
        self.modes.feed_mode, self.modes.per_turn = line.code, None

    def _compensation(self, line: _Line) -> None:
        self.problem(Message("compensation-not-read", name=codes.name_of(line.code)))

    def _work_offset(self, line: _Line) -> None:
        # In a line with G43, the H word is the number of a tool length offset.
        if line.code == codes.OKUMA_OFFSET and "H" in line.letters and ("G", 43.0) not in line.words:
            self.okuma = True
        offset = _offset(line.code, line.words, self.okuma)
        if offset is not None:
            self._select(offset)

    def _tool_length(self, line: _Line) -> None:
        self.length_changed = self.moved
        line.apart |= line.code == 431 and "H" not in line.letters  # G43.1 with the length in Z
        self._other(line)

    def _shift(self, line: _Line) -> None:
        """Process G52, G92, G92.1, G92.2 and G92.3."""
        values = line.lengths(self.modes.unit)
        line.apart = True
        if line.code == codes.LOCAL:
            self.origins.shift_by(values)
            if not values:
                self._coordinates(line)
        elif line.code == codes.POSITION:
            self._name_place(values)
        elif line.code in (codes.END_SHIFT, codes.SUSPEND_SHIFT):
            self.origins.end_shift(keep=line.code == codes.SUSPEND_SHIFT)
        elif line.code == codes.RESUME_SHIFT:
            self.origins.resume_shift()

    def _name_place(self, values: dict[str, float]) -> None:
        """Shift the coordinates so that the tool's place gets new ones, along the axes where its place is known.

        Coordinates before the first move along their axis shift nothing. After a move to a place that is not in the
        program, the coordinates stay as they are.
        """
        place = self.place.now()
        if not self.place.lost.isdisjoint(values):
            self.problem(Message("coordinates-not-changed", name="G92"))
        for letter in values.keys() & place.keys():
            self.origins.shift_here(letter, place[letter], values[letter])

    def _data(self, line: _Line) -> None:
        """Process G10: L2 sets a work offset, L20 sets a work offset from the tool's place."""
        line.apart = True
        words = dict(line.words)
        kind, values = words.get("L"), line.lengths(self.modes.unit)
        if kind not in (2.0, 20.0):
            return
        system, place = NUMBERED.get(words.get("P", -1.0)), self.place.now()
        if words.get("R") or (kind == 2.0 and self.modes.relative and values):
            known = False
        elif system is None:
            known = not self.moved
        elif kind == 2.0:
            known = self.origins.set_machine(system, values, moved=self.moved)
        else:
            known = not self.moved or values.keys() <= place.keys()
            if self.moved and known:
                self.origins.set_here(system, place, values)
        if not known:
            self.problem(Message("coordinates-not-changed", name=codes.name_of(line.code)))

    def _machine_position(self, line: _Line) -> None:
        """Process a move to a machine position, which is not in the program.

        A move in Z becomes a command, a move in X and Y is stored in `away`.
        """
        line.apart = True
        axes = line.letters & set("XYZ") or (set() if line.code == codes.MACHINE_COORDINATES else set("XYZ"))
        if not self.moved:
            return
        if "Z" in axes:
            self._add(codes.name_of(line.code), {"Z": 0.0})
        self.place.lose(axes)
        if not axes.isdisjoint("XY"):
            self.away.append((self.number, Message("machine-position", name=codes.name_of(line.code))))

    def _dwell(self, line: _Line) -> None:
        line.feeds = not line.letters.isdisjoint("PXU")  # in G4 F2 of a Siemens, F is the time
        self._leave_out(line, Message("dwell-untimed"))

    def _macro_call(self, line: _Line) -> None:
        line.feeds = False
        self._leave_out(line, Message("subprogram-not-read"))

    def _coordinates(self, line: _Line) -> None:
        self._leave_out(line, Message("coordinates-not-changed", name=codes.name_of(line.code)))

    def _probe(self, line: _Line) -> None:
        if line.letters.isdisjoint("XYZ"):
            line.apart = True
        else:
            self.problem(Message("probing-as-rapid"))
            line.once = line.code

    def _thread(self, line: _Line) -> None:
        """Process G33 and G33.1, on a lathe the thread with the pitch in F."""
        if "K" not in line.letters or line.letters.isdisjoint("XYZ"):
            self._other(line)
            return
        self.problem(Message("thread-at-pitch", name=codes.name_of(line.code)))
        line.once = line.code

    def _spline(self, line: _Line) -> None:
        """Process G5 and G5.1; a spline without a word of its control points is read as a line."""
        if line.letters.isdisjoint("XYZ"):
            line.apart = True
            return
        if splines.is_complete(line.code, dict(line.words)) and {"X", "Y"} <= self.place.now().keys():
            self.problem(Message("spline-as-chords", name=codes.name_of(line.code)))
            line.once = line.code
        else:
            self.problem(Message("spline-as-line", name=codes.name_of(line.code)))
        line.motion = codes.FEED

    def _fine_boring(self, line: _Line) -> None:
        """Process G76, which is read as G86; on a lathe, the threading cycle G76 has other words."""
        if "R" in line.letters and ("Y" in line.letters or "P" not in line.letters):
            line.motion = codes.BORING
        else:
            self._other(line)

    def _other(self, line: _Line) -> None:
        """Process a G-line.code without a handler of its own."""
        of_a_lathe = self.clues.g_code(line.code // 10, line.letters, self.number)
        if line.code in codes.APART:
            line.apart = True
        elif line.code not in codes.HARMLESS:
            self._unknown(line.code, line.letters)
            line.apart, line.feeds = True, False
        elif of_a_lathe:
            line.apart, line.feeds = True, False

    def _leave_out(self, line: _Line, what: Message) -> None:
        """Report a code that is not read, with the axis words of its line."""
        self.problem(what)
        line.apart = True

    def _unknown(self, code: int, letters: set[str]) -> None:
        """Report an unknown G-code, and the line's axis words, which may be its parameters."""
        name, left_out = repr(codes.name_of(code)), ", ".join(sorted(letters & {"X", "Y", "Z"}))
        if left_out:
            self.problem(Message("unknown-code-with-words", name=name, letters=left_out))
        else:
            self.problem(Message("unknown-code", name=name))

    def _move(self, line: _Line, parameters: dict[str, float]) -> None:
        """Add the command of a line's motion, or of its feed rate alone."""
        motion, apart = line.motion, line.apart
        if motion is None and self.motion == codes.CANCEL:  # after G80, machines move at rapid
            motion = codes.RAPID if not _AXES.isdisjoint(parameters) and not apart and line.once is None else None
        if motion is not None:
            self.motion, self.later, self.written = motion, None, -1
        mode = self.motion
        feed = self._feed(parameters.get("F") if line.feeds else None)
        move = {} if apart else self._target(mode, parameters)
        if feed is not None:
            move["F"] = feed
        if apart or _AXES.isdisjoint(move):
            # The command needs a name, because a command without a name would repeat a canned cycle.
            if motion is not None or feed is not None:
                self._add("G94" if motion is None else codes.name_of(motion), {} if feed is None else {"F": feed})
                self.written = self.written if motion is None else motion
            return
        if self.away or self.ended or not self.moved:
            self._begin_move()
        self.unnamed = None
        if line.once is None:
            self._move_along(parameters, move)
        else:
            self._SHAPES[line.once](self, line, move)

    def _target(self, mode: int, parameters: dict[str, float]) -> dict[str, float]:
        """Return the lengths of a move in the coordinates of the toolpath, mm; report words that are not read."""
        if not parameters.keys().isdisjoint(_POLAR):
            parameters = self._cartesian(parameters)
        unit = self.modes.unit
        move = {letter: unit * value for letter, value in parameters.items() if letter in _LENGTHS}
        if self.origins.used:
            move = self._shifted(mode, move)
        if self.pole is not None:
            move = self._centred(mode, move)
        if not _KNOWN.issuperset(parameters):
            self.clues.axes(parameters, mode > 0, self.number)
            for letter in sorted(set(parameters) - _KNOWN):
                self._unread(letter, parameters[letter])
        return move

    def _begin_move(self) -> None:
        if not self.moved:
            self.origins.begin()
        self.moved = True
        for line, what in self.away:
            self.problem(what, line)
        self.away.clear()
        if self.ended:
            self.problem(Message("goes-on"))

    def _cartesian(self, parameters: dict[str, float]) -> dict[str, float]:
        """Return the words of a line with X and Y instead of LinuxCNC's polar coordinates @ and ^."""
        place, unit = self.place.now(), self.modes.unit
        if not {"X", "Y"} <= place.keys() and (self.modes.relative or not {*_POLAR} <= parameters.keys()):
            for letter in sorted({*_POLAR} & parameters.keys()):
                self.problem(Message("word-not-read", letter=letter))
            return parameters
        origin_x, origin_y = self.origins.of("X"), self.origins.of("Y")
        x, y = place.get("X", origin_x) - origin_x, place.get("Y", origin_y) - origin_y
        distance, angle = math.hypot(x, y), math.degrees(math.atan2(y, x))
        if self.modes.relative:
            distance += unit * parameters.get("@", 0.0)
            angle += parameters.get("^", 0.0)
        else:
            distance = unit * parameters["@"] if "@" in parameters else distance
            angle = parameters.get("^", angle)
        end_x, end_y = distance * math.cos(math.radians(angle)), distance * math.sin(math.radians(angle))
        if self.modes.relative:
            end_x, end_y = end_x - x, end_y - y
        rest = {letter: value for letter, value in parameters.items() if letter not in _POLAR}
        return {**rest, "X": end_x / unit, "Y": end_y / unit}

    def _probe_along(self, line: _Line, move: dict[str, float]) -> None:
        """Add a probing move as a rapid to its end, where the tool arrives only if it touches nothing."""
        self._write(codes.RAPID, move)
        self.place.lose(set("XYZ") & line.letters)

    def _thread_along(self, line: _Line, move: dict[str, float]) -> None:
        """Add a move at the pitch times the spindle speed; after a tap (G33.1), the tool returns in the same way."""
        pitch = self.modes.unit * dict(line.words)["K"]
        place, relative = dict(self.place.now()), self.modes.relative
        there = {letter: move[letter] for letter in "XYZ" if letter in move}
        back = {letter: -move[letter] if relative else place[letter] for letter in there if relative or letter in place}
        self._stand(stands=not self.spindle)
        self._write(codes.FEED, {**there, "F": pitch * self.spindle / 60})
        if line.once == codes.RIGID_TAP:
            self._write(codes.FEED, back)
        if self.modes.feed is not None:
            self._add("G94", {"F": self.modes.feed})

    def _spline_along(self, line: _Line, move: dict[str, float]) -> None:
        """Add the chords of a spline."""
        place, relative = self.place.now(), self.modes.relative
        axes = [letter for letter in "XYZ" if letter in place]
        start = [place[letter] for letter in axes]
        at_rest = dict.fromkeys(axes, 0.0) if relative else place
        offset = start if relative else [0.0] * len(axes)
        end = [move.get(letter, at_rest[letter]) + offset[i] for i, letter in enumerate(axes)]
        words = {letter: self.modes.unit * value for letter, value in line.words}
        points = splines.chords(line.once or 0, words, start, end)
        if relative:
            points[1:] -= points[:-1].copy()
            points[0] -= start
        feed = {"F": move["F"]} if "F" in move else {}
        for point in points.tolist():
            self._write(codes.FEED, {**dict(zip(axes, point)), **feed})

    def _move_along(self, parameters: dict[str, float], move: dict[str, float]) -> None:
        """Add the command of a line that contains axis words."""
        mode = self.motion
        self._note(mode, parameters, move)
        repeats = 1
        if mode in codes.CYCLES:
            repeats = self._repeats(mode, parameters, move)
            if repeats <= 0:
                self.later = move
                return
            if self.later is not None:
                move, self.later = {**self.later, **move}, None
                self.written = -1
        elif mode in codes.ARCS and parameters.get("P", 1.0) != 1:
            move["P"] = parameters["P"]
        if self.stands or self.modes.per_turn is not None:
            self._stand(stands=self.modes.per_turn is not None and not self.spindle and mode > 0)
        if self.seconds and mode > 0 and mode not in codes.CYCLES:
            self.inverse_time[len(self.commands)] = 1 / self.seconds
        for _ in range(repeats):
            self._write(mode, move)

    def _write(self, mode: int, move: dict[str, float]) -> None:
        """Add the command of a move; its name is empty if the motion is still in force."""
        self._add("" if mode == self.written else codes.name_of(mode), move)
        self.written = mode

    def _stand(self, *, stands: bool) -> None:
        """Begin or end moves at an unknown feed rate: per turn, while the spindle stands."""
        if stands != self.stands:
            self._add("G95" if stands else "G94", {})
            self.stands = stands

    def _note(self, mode: int, parameters: dict[str, float], move: dict[str, float]) -> None:
        """Note the signs of the machine in a move; report its parameters that are not read."""
        if "Y" in move:
            self._note_y(move["Y"])
        if mode in codes.ARCS:
            self.clues.arc(set(parameters), self.number)
        if "Z" in move:
            self.length_changed = False
        elif self.length_changed and mode > 0:
            self.problem(Message("length-before-height"))
            self.length_changed = False
        if mode in codes.CYCLES and parameters.get("P", 0.0) > 0:
            self.problem(Message("dwell-untimed"))

    def _note_y(self, y: float) -> None:
        if self.modes.relative:
            self.clues.y(y != 0)
        else:
            self.clues.y(self.y not in (None, y))
            self.y = y

    def _repeats(self, mode: int, parameters: dict[str, float], move: dict[str, float]) -> int:
        """Return the number of repeats of a canned cycle, and convert `move` to the words that `linearize` reads."""
        move.pop("K", None)
        pecks = [letter for letter in "IJK" if letter in parameters]
        letter = "L" if "L" in parameters else "K"
        drills_once = mode not in (*codes.PECKING, codes.BORING)
        if drills_once and {"Z", "I"} <= move.keys() and "R" not in move:
            # Fagor: Z is the level of the reference plane (R in other dialects), I the depth, K a dwell.
            move["R"], move["Z"] = move["Z"], move.pop("I")
            if "K" in parameters:
                self.problem(Message("dwell-untimed"))
            return self._limited(parameters.get("L", 1.0))
        if mode in codes.PECKING and ("I" in pecks or "J" in pecks or parameters.get("K", 1.0) % 1):
            # Haas and Yasnac: I is the first peck, J the reduction of each further peck, K the smallest peck.
            if "I" in pecks and "Q" not in move:
                move["Q"] = move["I"]
                pecks.remove("I")
            for one in pecks:
                self.problem(Message("word-not-read", letter=one))
            letter = "L"
        elif drills_once:
            for one in sorted({"I", "J"} & parameters.keys()):
                self.problem(Message("word-not-read", letter=one))
        return self._limited(parameters.get(letter, 1.0))

    def _limited(self, repeats: float) -> int:
        """Return the number of repeats of a canned cycle, not more than `_MOST_REPEATS`."""
        if repeats > _MOST_REPEATS:
            self.problem(Message("repeats-limited", most=_MOST_REPEATS))
        return whole(repeats, _MOST_REPEATS)

    def _unread(self, letter: str, value: float) -> None:
        """Report a word that is not read; a word of a rotary axis only if its value changes.

        A rotary axis is at 0 before its first word.
        """
        if letter not in ROTARY:
            self.problem(Message("word-not-read", letter=letter))
        elif value != self.angles.get(letter, 0.0):
            self.problem(Message("rotary-not-read", letter=letter))
            self.angles[letter] = value

    def _feed(self, value: float | None) -> float | None:
        """Return the feed rate of an F word, mm/s; None without F word and under G93.

        Under G93, an F word sets `seconds`, the duration of this line's move, instead.
        """
        modes, per_turn = self.modes, self.modes.feed_mode == codes.PER_TURN
        self.seconds = 60 / value if modes.feed_mode == codes.INVERSE_TIME and value and value > 0 else 0.0
        if value is None or modes.feed_mode == codes.INVERSE_TIME:
            return None
        modes.per_turn = value if per_turn else None
        modes.feed = value * modes.feed_unit * (self.spindle if per_turn else 1.0) / self.dialect.feed_time
        return modes.feed

    # The handlers of G-codes that are not motions, and the moves of codes for one line only.
    _HANDLERS: ClassVar[dict[int, _Handler]] = {
        **dict.fromkeys(codes.UNITS, _unit),
        **dict.fromkeys(codes.PATTERNS, _pattern),
        **dict.fromkeys(codes.FEED_MODES, _feed_mode),
        **dict.fromkeys(codes.COMPENSATION, _compensation),
        **dict.fromkeys([*codes.OFFSETS, codes.OKUMA_OFFSET], _work_offset),
        **dict.fromkeys(codes.CHANGES_COORDINATES, _coordinates),
        **dict.fromkeys([codes.LOCAL, codes.POSITION, codes.END_SHIFT, codes.SUSPEND_SHIFT, codes.RESUME_SHIFT],
                        _shift),
        **dict.fromkeys(codes.MACHINE, _machine_position),
        **dict.fromkeys(codes.MACRO_CALLS, _macro_call),
        **dict.fromkeys(codes.PROBES_OF_PROGRAMS, _probe),
        **dict.fromkeys([codes.THREAD, codes.RIGID_TAP], _thread),
        **dict.fromkeys(codes.SPLINES, _spline),
        **dict.fromkeys(codes.TOOL_LENGTH, _tool_length),
        760: _fine_boring,
        codes.DATA: _data,
        codes.DWELL: _dwell,
    }  # fmt: skip
    _SHAPES: ClassVar[dict[int, _Shape]] = {
        **dict.fromkeys(codes.PROBES_OF_PROGRAMS, _probe_along),
        **dict.fromkeys([codes.THREAD, codes.RIGID_TAP], _thread_along),
        **dict.fromkeys(codes.SPLINES, _spline_along),
    }


def _offset(code: int, words: list[tuple[str, float]], okuma: bool) -> tuple[int, float] | None:
    """Return the work offset that a G-code selects: its G-code in tenths and its number; None for other codes.

    The number is the P word of G54.1 and G154, the H word of Okuma's G15, and 0 for other codes.
    """
    if okuma:
        return (code, dict(words).get("H", 0.0)) if code == codes.OKUMA_OFFSET else None
    if code not in codes.OFFSETS:
        return None
    return code, dict(words).get("P", 0.0) if code in codes.NUMBERED_OFFSETS else 0.0


def _words_of(m_code: float, letters: set[str], *, first: bool) -> frozenset[str]:
    """Return the letters of the words that are parameters of an M-code, and must not be read as a move or a feed rate.

    Marlin's settings and the vendors' M-codes have parameters only if no G-code and no such word precedes the M-code
    (`first`): in G1 X5 M203, X5 is the target of the move.
    """
    if m_code in _OUTPUTS:
        return frozenset("EQ")
    if m_code == _ORIENT or (m_code in _SPINDLE and letters.isdisjoint("XYZ")):
        return frozenset("PQR")  # the angle of the spindle, not the R plane of a canned cycle
    if first and (m_code in _SETTINGS or m_code >= _OTHERS_M_CODE):
        return frozenset("ABCEFIJKPQRTUVWXYZ")
    return frozenset()
