# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert the words of an NC program into commands, in mm and mm/s.

The commands keep the modal state that `linearize` resolves: planes, G90/G91, the centres of arcs, canned cycles. This
module resolves units, feed rates and the order of words.
"""

from __future__ import annotations

from array import array

from vkworkbench.core.gcode import dialects
from vkworkbench.core.gcode.blocks import LARGEST_NUMBER, whole
from vkworkbench.core.gcode.moves import codes
from vkworkbench.core.gcode.moves.commands import Commands
from vkworkbench.core.gcode.moves.units import INCH
from vkworkbench.core.gcode.moves.unread import ROTARY
from vkworkbench.core.gcode.subprograms import calls_block
from vkworkbench.language import Message

_ORIGINS = (2, 20)  # L words with which G10 sets a work offset
_OUTPUTS = frozenset([67, 68])  # LinuxCNC's M-codes for analog outputs, for example to a laser, with E and Q words
_SETTINGS = frozenset([92, 201, 203, 204, 205, 206])  # Marlin's M-codes for steps/mm, speeds and accelerations
_OTHERS_M_CODE = 1000  # first number of the vendors' own M-codes, for example Snapmaker's M2000
_LATHE_CYCLE = frozenset("PQUWR")  # with these words, G70 to G72 are turning cycles, not units
_HOLE_PATTERN = frozenset("IJKL")  # with these words, G70 to G72 are patterns of holes on Haas and Yasnac
_AXES = frozenset("XYZIJKR")
_LENGTHS = frozenset("XYZIJKRQ")
_COORDINATES = {"X": "X", "Y": "Y", "Z": "Z"}  # letters of absolute coordinates, and their axes
_OF_CYCLES = {**_COORDINATES, "R": "Z"}
_OF_ARCS = {**_COORDINATES, "I": "X", "J": "Y", "K": "Z"}  # for arcs with absolute centres (G90.1)
_KNOWN = _LENGTHS | {"F", "S", "P", "L", "H", "D"}
_MOST_CODES, _MOST_REPEATS = 1000, 10_000


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
    """

    def __init__(self) -> None:
        self.commands = Commands()
        self.lines = array("q")
        self.inverse_time: dict[int, float] = {}
        self.problems: dict[Message, list[int]] = {}
        self.clues = dialects.Clues()
        self.unit = 1.0
        self.first_unit: float | None = None
        self.motion = -1
        self.moved = False
        self.y: float | None = None  # last absolute Y, mm
        # Lines of moves to machine positions since the last other move, with their messages. They are reported only if
        # another move follows.
        self.away: list[tuple[int, Message]] = []
        self.offset = 540, 0.0  # work offset in force: its G-code in tenths, and its P or H word
        self.okuma = False  # whether work offsets are selected with G15 H
        self.relative = False
        self.absolute_centres = False  # whether the centre words of arcs are absolute coordinates (G90.1)
        self.shift: dict[str, float] = {}  # G52 shift along each axis, mm
        self.feed_mode = codes.PER_MINUTE
        self.spindle = 0.0  # spindle speed, turns/min
        self.per_turn: float | None = None  # the F word under G95
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
        motion, apart, ended, last, change = None, False, False, False, False
        taken: frozenset[str] = frozenset()  # letters of words that belong to an M-code
        g_codes: list[int] = []
        parameters: dict[str, float] = {}
        for letter, value in words:
            if letter == "G":
                code = whole(10 * value, 10 * _MOST_CODES)
                g_codes.append(code)
                if code in codes.MOTIONS and motion not in (None, code) and self._knows(code):
                    self.problem(Message("two-motions"))
                read_as, own = self._g_code(code, words, letters)
                motion = motion if read_as is None else read_as
                apart |= own
            elif letter == "M":
                change |= value == 6
                ended |= self._m_code(value, letters)
                taken |= _words_of(value, first=not parameters and "G" not in letters)
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
        if "S" in letters and self.per_turn is not None:  # under G95, a new spindle speed changes the feed rate
            parameters.setdefault("F", self.per_turn)
        if g_codes or "F" in parameters:
            feed = self.unit * parameters.get("F", 0.0) if self.feed_mode == codes.PER_MINUTE else 0.0
            self.clues.feed(g_codes, parameters, self.motion if motion is None else motion, feed, self.number)
        self._move(motion, parameters, apart)
        self.ended |= last
        return ended

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

    def _shifted(self, mode: int, move: dict[str, float]) -> dict[str, float]:
        """Return a move with the G52 shift added to its coordinates."""
        along = (
            _OF_CYCLES
            if mode in codes.CYCLES
            else _OF_ARCS
            if self.absolute_centres and mode in codes.ARCS
            else _COORDINATES
        )
        return {letter: value + self.shift.get(along.get(letter, ""), 0.0) for letter, value in move.items()}

    def _knows(self, code: int) -> bool:
        """Return whether a G-code has its usual meaning in this program; in Heidenhain's DIN/ISO only some codes do."""
        return self.pole is None or code in codes.HEIDENHAIN

    def _g_code(self, code: int, words: list[tuple[str, float]], letters: set[str]) -> tuple[int | None, bool]:
        """Process a G-code.

        Returns
        -------
        motion : int or None
            The motion that the code selects, in tenths of its G-code; None if the code does not select a motion.
        own : bool
            Whether the line's axis words are parameters of this code, not the target of a move.
        """
        if not self._knows(code):
            if code not in codes.HEIDENHAIN_DATA:
                self._unknown(code, letters)
            return None, True
        if code in codes.MOTIONS:
            return code, False
        if code in codes.KEPT:
            self._state(code)
            return None, False
        self._displaced(code, words, letters)
        if code in codes.PROBES_OF_PROGRAMS and not letters.isdisjoint("XYZ"):
            self.problem(Message("probing-untimed"))
        read_as = self._read_as(code, letters)
        return read_as, read_as is None and (code in codes.APART or self._other(code, words))

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
        self.unit = INCH if code in codes.INCHES else 1.0
        if self.first_unit is None:
            self.first_unit = self.unit

    def _centred(self, mode: int, move: dict[str, float]) -> dict[str, float]:
        """Return a Heidenhain move with the centre of its arc, from this line or from an earlier one."""
        centre = {letter: move.pop(letter) for letter in "IJK" if letter in move}
        if centre and self.relative:  # relative to the tool's position, which is not known here
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
        if self.pole is not None:  # Heidenhain's M97 to M99 have other meanings
            return False
        if value == 98 or (value in (97, 198) and "P" in letters):
            self.call = value
            self.calls_blocks |= calls_block(value, letters)
        if value == 99 and (self.deleted or "P" in letters):
            self.problem(Message("jumps-not-followed"))
            return False
        return value == 99

    def _displaced(self, code: int, words: list[tuple[str, float]], letters: set[str]) -> None:
        """Report a change of the work offset, or a move to a machine position, after the first move.

        The position of the new origin, or of the machine position, is not in the program. A move to a machine position
        in Z becomes a command, a move in X and Y is stored in `away`.
        """
        # In a line with G43, the H word is the number of a tool length offset.
        if code == codes.OKUMA_OFFSET and "H" in letters and ("G", 43.0) not in words:
            self.okuma = True
        offset, before = _offset(code, words, self.okuma), self.offset
        self.offset = offset or before
        if not self.moved:
            return
        if (code == codes.DATA and dict(words).get("L") in _ORIGINS) or offset not in (None, before):
            self.problem(Message("coordinates-not-changed", name=codes.name_of(code)))
        elif code in codes.MACHINE:
            if "Z" in letters or (code != codes.MACHINE_COORDINATES and letters.isdisjoint("XYZ")):
                self._add(codes.name_of(code), {"Z": 0.0})
            if not letters.isdisjoint("XY"):
                self.away.append((self.number, Message("machine-position", name=codes.name_of(code))))

    def _state(self, code: int) -> None:
        """Process a modal G-code that `linearize` resolves, and add it to the commands."""
        if code in (codes.ABSOLUTE, codes.RELATIVE):
            self.relative = code == codes.RELATIVE
        elif code in codes.CENTRES:
            self.absolute_centres = code == codes.ABSOLUTE_CENTRES
        elif code == codes.CANCEL:
            self.motion = code
        elif code == 180:
            self.clues.g_code(18, set(), self.number)
        self._add(codes.name_of(code), {})

    def _read_as(self, code: int, letters: set[str]) -> int | None:
        """Return the motion that replaces a G-code which `linearize` does not read; None for other codes.

        A spline is replaced by a line, the fine boring cycle G76 by G86.
        """
        if code in codes.SPLINES and not letters.isdisjoint("XYZ"):
            self.problem(Message("spline-as-line", name=codes.name_of(code)))
            return codes.FEED
        if code == 760 and "R" in letters and ("Y" in letters or "P" not in letters):
            return codes.BORING  # G76 on a lathe, a threading cycle, has other words
        return None

    def _other(self, code: int, words: list[tuple[str, float]]) -> bool:
        """Process a G-code that is not a motion; return whether the line's axis words are parameters of the code."""
        letters = {letter for letter, _ in words}
        if self._takes_words(code, words, letters):
            return True
        turning = code in codes.PATTERNS and not letters.isdisjoint(_LATHE_CYCLE)
        if code in codes.UNITS and not turning:
            self._measure_in(code)
        elif code in codes.FEED_MODES:
            self.feed_mode, self.per_turn = code, None
        elif code in codes.COMPENSATION:
            self.problem(Message("compensation-not-read", name=codes.name_of(code)))
        else:
            of_a_lathe = self.clues.g_code(code // 10, letters, self.number)
            if code not in codes.HARMLESS:
                self._unknown(code, letters)
            return of_a_lathe or code not in codes.HARMLESS
        return False

    def _takes_words(self, code: int, words: list[tuple[str, float]], letters: set[str]) -> bool:
        """Process a G-code if the line's axis words are its parameters; return whether they are."""
        if code == codes.LOCAL and not letters.isdisjoint("XYZ"):
            self.shift.update((letter, self.unit * value) for letter, value in words if letter in "XYZ")
            return True
        message = self._unread_code(code, words, letters)
        if message is not None:
            self.problem(message)
            return True
        tool_length = code == 431 and "H" not in letters
        # A spline with X, Y or Z words does not get here, because `_read_as` replaces it by a line.
        return tool_length or code in codes.SPLINES or code in codes.CHANGES_COORDINATES

    def _unread_code(self, code: int, words: list[tuple[str, float]], letters: set[str]) -> Message | None:
        """Return the message about a G-code whose parameters are not read; None for other codes."""
        name = codes.name_of(code)
        if code in codes.PATTERNS and letters.isdisjoint(_LATHE_CYCLE) and not letters.isdisjoint(_HOLE_PATTERN):
            return Message("hole-pattern-not-read", name=name)
        # Okuma: G71 Z sets the return level of canned cycles.
        if code == 710 and [letter for letter, _ in words if letter != "N"] == ["G", "Z"]:
            return Message("unknown-code", name=repr(name))
        if code == codes.DWELL:
            return Message("dwell-untimed")
        if code in codes.MACRO_CALLS:
            return Message("subprogram-not-read")
        sets_position = code == 920  # G92 before the first move does not shift any move
        if code in codes.CHANGES_COORDINATES and (not sets_position or (self.moved and not letters.isdisjoint("XYZ"))):
            return Message("coordinates-not-changed", name=name)
        return None

    def _unknown(self, code: int, letters: set[str]) -> None:
        """Report an unknown G-code, and the line's axis words, which may be its parameters."""
        name, left_out = repr(codes.name_of(code)), ", ".join(sorted(letters & {"X", "Y", "Z"}))
        if left_out:
            self.problem(Message("unknown-code-with-words", name=name, letters=left_out))
        else:
            self.problem(Message("unknown-code", name=name))

    def _move(self, motion: int | None, parameters: dict[str, float], apart: bool) -> None:
        """Add the command of a line's motion, or of its feed rate alone."""
        if motion is None and self.motion == codes.CANCEL:  # after G80, machines move at rapid
            motion = codes.RAPID if not _AXES.isdisjoint(parameters) and not apart else None
        if motion is not None:
            self.motion, self.later = motion, None
        mode = self.motion
        feed = self._feed(None if apart else parameters.get("F"))
        move = {letter: self.unit * value for letter, value in parameters.items() if letter in _LENGTHS}
        if self.shift and not self.relative and not apart:
            move = self._shifted(mode, move)
        if self.pole is not None and not apart:
            move = self._centred(mode, move)
        if not apart and not _KNOWN.issuperset(parameters):
            self.clues.axes(parameters, mode > 0, self.number)
            for letter in sorted(set(parameters) - _KNOWN):
                self._unread(letter, parameters[letter])
        if feed is not None:
            move["F"] = feed
        if apart or _AXES.isdisjoint(move):
            # The command needs a name, because a command without a name would repeat a canned cycle.
            if motion is not None or feed is not None:
                self._add("G94" if motion is None else codes.name_of(motion), {} if feed is None else {"F": feed})
            return
        self._move_along(motion, parameters, move)

    def _move_along(self, motion: int | None, parameters: dict[str, float], move: dict[str, float]) -> None:
        """Add the command of a line that contains axis words."""
        mode = self.motion
        self.moved, self.unnamed = True, None
        for line, what in self.away:
            self.problem(what, line)
        self.away.clear()
        if self.ended:
            self.problem(Message("goes-on"))
        self._note(mode, parameters, move)
        name = "" if motion is None else codes.name_of(motion)
        repeats = 1
        if mode in codes.CYCLES:
            repeats = self._repeats(mode, parameters, move)
            if repeats <= 0:
                self.later = move
                return
            if self.later is not None:
                name, move, self.later = codes.name_of(mode), {**self.later, **move}, None
        elif self.seconds and mode > 0:
            self.inverse_time[len(self.commands)] = 1 / self.seconds
        stands = self.per_turn is not None and not self.spindle  # G95 at spindle speed 0: the feed rate is unknown
        if mode > 0 and stands != self.stands:
            self._add("G95" if stands else "G94", {})
            self.stands = stands
        for _ in range(repeats if self.relative else 1):
            self._add(name, move)

    def _note(self, mode: int, parameters: dict[str, float], move: dict[str, float]) -> None:
        """Note the signs of the machine in a move; report its parameters that are not read."""
        if "Y" in move:
            self._note_y(move["Y"])
        if mode in codes.ARCS:
            self.clues.arc(set(parameters), self.number)
            if parameters.get("P", 1.0) > 1:
                self.problem(Message("turns-not-read"))
        if mode in codes.CYCLES and parameters.get("P", 0.0) > 0:
            self.problem(Message("dwell-untimed"))

    def _note_y(self, y: float) -> None:
        if self.relative:
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
            return whole(parameters.get("L", 1.0), _MOST_REPEATS)
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
        repeats = whole(parameters.get(letter, 1.0), _MOST_REPEATS)
        if repeats > 1 and not self.relative:
            self.problem(Message("repeats-not-read", letter=letter))
        return repeats

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
        self.seconds = 60 / value if self.feed_mode == codes.INVERSE_TIME and value and value > 0 else 0.0
        if value is None or self.feed_mode == codes.INVERSE_TIME:
            return None
        self.per_turn = value if self.feed_mode == codes.PER_TURN else None
        return value * self.unit * (self.spindle if self.feed_mode == codes.PER_TURN else 1.0) / 60


def _offset(code: int, words: list[tuple[str, float]], okuma: bool) -> tuple[int, float] | None:
    """Return the work offset that a G-code selects: its G-code in tenths and its number; None for other codes.

    The number is the P word of G54.1 and G154, the H word of Okuma's G15, and 0 for other codes.
    """
    if okuma:
        return (code, dict(words).get("H", 0.0)) if code == codes.OKUMA_OFFSET else None
    if code not in codes.OFFSETS:
        return None
    return code, dict(words).get("P", 0.0) if code in codes.NUMBERED_OFFSETS else 0.0


def _words_of(m_code: float, *, first: bool) -> frozenset[str]:
    """Return the letters of the words that are parameters of an M-code, and must not be read as a move or a feed rate.

    Marlin's settings and the vendors' M-codes have parameters only if no G-code and no such word precedes the M-code
    (`first`): in G1 X5 M203, X5 is the target of the move.
    """
    if m_code in _OUTPUTS:
        return frozenset("EQ")
    if first and (m_code in _SETTINGS or m_code >= _OTHERS_M_CODE):
        return frozenset("ABCEFIJKPQRTUVWXYZ")
    return frozenset()
