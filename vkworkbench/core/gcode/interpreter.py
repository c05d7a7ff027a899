# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of an NC program's lines become commands, in mm and mm/s.

Modal state that `linearize` knows stays in the commands: planes, G90/G91, the centres of arcs, canned cycles. Units, feed
rates and the order of words are resolved here.
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

_ORIGINS = (2, 20)  # L words of G10 that set the origin of the program's coordinates
_OUTPUTS = frozenset([67, 68])  # LinuxCNC's M-codes whose E and Q words are an analog output, as of a laser
_SETTINGS = frozenset([92, 201, 203, 204, 205, 206])  # of Marlin: its steps, speeds and accelerations are no targets
_OTHERS_M_CODE = 1000  # from here on they are a vendor's own, as Snapmaker's M2000
_LATHE_CYCLE = frozenset("PQUWR")  # words that make G70 and G71 cycles of a lathe, not units
_HOLE_PATTERN = frozenset("IJKL")  # or patterns of holes on Haas and Yasnac
_AXES = frozenset("XYZIJKR")
_LENGTHS = frozenset("XYZIJKRQ")
_COORDINATES = {"X": "X", "Y": "Y", "Z": "Z"}  # what a word tells, and along which axis
_OF_CYCLES = {**_COORDINATES, "R": "Z"}
_OF_ARCS = {**_COORDINATES, "I": "X", "J": "Y", "K": "Z"}  # whose centres are coordinates
_KNOWN = _LENGTHS | {"F", "S", "P", "L", "H", "D"}
_MOST_CODES, _MOST_REPEATS = 1000, 10_000


class Interpreter:
    """The commands of the lines read so far, and the state in which these lines leave the machine.

    Attributes
    ----------
    commands, lines, inverse_time, clues, first_unit
        As a `Program` is made of them.
    problems : dict of Message to list of int
        What is not read, and in which lines.
    motion : int
        The one in force, -1 before the first.
    ended : bool
        Whether M2 or M30 was read.
    call : float or None
        The M-code by which the last line calls a subprogram, which whoever has the text runs; None where it calls none.
    calls_blocks : bool
        Whether what stands behind the end is called from within, by its blocks' numbers.
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
        self.y: float | None = None  # the last absolute one
        self.away: list[tuple[int, Message]] = []  # machine positions since the last move, which matter if one follows
        self.offset = 540, 0.0
        self.okuma = False
        self.relative = False
        self.absolute_centres = False  # of arcs
        self.shift: dict[str, float] = {}  # of the coordinates along each axis, by G52
        self.feed_mode = codes.PER_MINUTE
        self.spindle = 0.0
        self.per_turn: float | None = None  # the F word under G95
        self.stands = False  # whether the last move was fed per turn of a spindle that nobody had told to turn
        self.tool: int | None = None
        self.changes = False  # whether there is an M6; where there is none, T changes the tool
        self.spindle_tool: int | None = None
        self.unnamed: int | None = None  # the last M6 since the last move, where no T before it names a new tool
        self.seconds = 0.0  # that this line's move takes, where G93 says so
        self.later: dict[str, float] | None = None  # words of a cycle that drills nowhere yet (L0)
        self.angles: dict[str, float] = {}  # of the rotary axes
        self.pole: dict[str, float] | None = None  # Heidenhain's centre of the arcs to come
        self.number = 0  # of the line
        self.deleted = False  # whether this line has a block delete
        self.call: float | None = None
        self.calls_blocks = False
        self.ended = False

    def problem(self, what: Message, line: int | None = None) -> None:
        """Note what is not read, in the line that is being read where no other one is told."""
        self.problems.setdefault(what, []).append(self.number if line is None else line)

    @property
    def moves(self) -> bool:
        """Whether any command moves the tool."""
        return any(
            (not name or name in codes.MOTION_NAMES) and not _AXES.isdisjoint(words) for name, words in self.commands
        )

    def with_tool_changes(self) -> Commands:
        """Return the commands; where there is no M6, each T word that names another tool becomes a tool change in them."""
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
        """Read the words of one line, which may have a block delete; return whether they end the program."""
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
        if "S" in letters and self.per_turn is not None:  # another speed is another feed
            parameters.setdefault("F", self.per_turn)
        if g_codes or "F" in parameters:
            feed = self.unit * parameters.get("F", 0.0) if self.feed_mode == codes.PER_MINUTE else 0.0
            self.clues.feed(g_codes, parameters, self.motion if motion is None else motion, feed, self.number)
        self._move(motion, parameters, apart)
        self.ended |= last
        return ended

    def heidenhain(self, number: int, unit: int) -> bool:
        """Begin to read Heidenhain's DIN/ISO, whose centres of arcs are coordinates; return whether it ends here."""
        if self.pole is not None:
            return True
        self.number, self.pole = number, {}
        self._measure_in(unit)
        self._add("G90.1", {})
        return False

    def _shifted(self, mode: int, move: dict[str, float]) -> dict[str, float]:
        """Return a move from one point to another with its coordinates where G52 leaves them."""
        along = (
            _OF_CYCLES
            if mode in codes.CYCLES
            else _OF_ARCS
            if self.absolute_centres and mode in codes.ARCS
            else _COORDINATES
        )
        return {letter: value + self.shift.get(along.get(letter, ""), 0.0) for letter, value in move.items()}

    def _knows(self, code: int) -> bool:
        """Whether a G-code means in this program what it means elsewhere."""
        return self.pole is None or code in codes.HEIDENHAIN

    def _g_code(self, code: int, words: list[tuple[str, float]], letters: set[str]) -> tuple[int | None, bool]:
        """Take a G-code; return the motion that it is, None for none, and whether the line's axis words belong to it."""
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
        """Take the tools that a line names; the change is of the first, a second one it gets ready."""
        for named in tools:
            self.clues.tool(named, self.number)
            self._add(f"T{named}", {})  # where there is no M6 at all it changes the tool
        if tools and not change and self.unnamed is not None:  # M6, and in a line of its own what to: as for a Fagor
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
        """Return a move of Heidenhain's with the centre of its arc, which stands in this line or an earlier one."""
        centre = {letter: move.pop(letter) for letter in "IJK" if letter in move}
        if centre and self.relative:  # it would count from the tool
            self.pole = {}
            for letter in centre:
                self.problem(Message("word-not-read", letter=letter))
        elif self.pole is not None:
            self.pole.update(centre)
        is_arc = mode in codes.ARCS and "R" not in move and not {"X", "Y", "Z"}.isdisjoint(move)
        return {**move, **(self.pole or {})} if is_arc else move

    def _m_code(self, value: float, letters: set[str]) -> bool:
        """Take an M-code; return whether it ends the program at once."""
        self.clues.m_code(value, letters, self.number)
        if self.pole is not None:  # where M97 to M99 are others
            return False
        if value == 98 or (value in (97, 198) and "P" in letters):
            self.call = value
            self.calls_blocks |= calls_block(value, letters)
        if value == 99 and (self.deleted or "P" in letters):
            self.problem(Message("jumps-not-followed"))
            return False
        return value == 99

    def _displaced(self, code: int, words: list[tuple[str, float]], letters: set[str]) -> None:
        """Tell where a G-code leaves the coordinates of the moves before: nothing in the program tells how far."""
        if code == codes.OKUMA_OFFSET and "H" in letters and ("G", 43.0) not in words:  # whose H would be a length
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
        """Take a G-code that `linearize` knows."""
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
        """Return the motion as which a G-code is read that `linearize` does not know; None where there is none."""
        if code in codes.SPLINES and not letters.isdisjoint("XYZ"):
            self.problem(Message("spline-as-line", name=codes.name_of(code)))
            return codes.FEED
        if code == 760 and "R" in letters and ("Y" in letters or "P" not in letters):
            return codes.BORING  # a lathe's G76, which cuts threads, has other words
        return None

    def _other(self, code: int, words: list[tuple[str, float]]) -> bool:
        """Take a G-code that `linearize` need not know; return whether the line's axis words belong to it."""
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
        """Take a G-code whose parameters are the line's axis words; return whether it is one."""
        if code == codes.LOCAL and not letters.isdisjoint("XYZ"):
            self.shift.update((letter, self.unit * value) for letter, value in words if letter in "XYZ")
            return True
        message = self._unread_code(code, words, letters)
        if message is not None:
            self.problem(message)
            return True
        tool_length = code == 431 and "H" not in letters
        return tool_length or code in codes.SPLINES or code in codes.CHANGES_COORDINATES  # splines here have no target

    def _unread_code(self, code: int, words: list[tuple[str, float]], letters: set[str]) -> Message | None:
        """Return the message about a G-code whose parameters are not read; None for other codes."""
        name = codes.name_of(code)
        if code in codes.PATTERNS and letters.isdisjoint(_LATHE_CYCLE) and not letters.isdisjoint(_HOLE_PATTERN):
            return Message("hole-pattern-not-read", name=name)
        if code == 710 and [letter for letter, _ in words if letter != "N"] == ["G", "Z"]:  # Okuma's return level
            return Message("unknown-code", name=repr(name))
        if code == codes.DWELL:
            return Message("dwell-untimed")
        if code in codes.MACRO_CALLS:
            return Message("subprogram-not-read")
        sets_position = code == 920  # before any move, that changes nothing
        if code in codes.CHANGES_COORDINATES and (not sets_position or (self.moved and not letters.isdisjoint("XYZ"))):
            return Message("coordinates-not-changed", name=name)
        return None

    def _unknown(self, code: int, letters: set[str]) -> None:
        """Tell of a G-code that is not known, and of the line's axis words, which may be its parameters."""
        name, left_out = repr(codes.name_of(code)), ", ".join(sorted(letters & {"X", "Y", "Z"}))
        if left_out:
            self.problem(Message("unknown-code-with-words", name=name, letters=left_out))
        else:
            self.problem(Message("unknown-code", name=name))

    def _move(self, motion: int | None, parameters: dict[str, float], apart: bool) -> None:
        """Add the command of a line's motion, or of its feed rate alone."""
        if motion is None and self.motion == codes.CANCEL:  # behind G80 machines go on as with G0
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
            if motion is not None or feed is not None:  # not a line without a name: that would repeat a cycle
                self._add("G94" if motion is None else codes.name_of(motion), {} if feed is None else {"F": feed})
            return
        self._move_along(motion, parameters, move)

    def _move_along(self, motion: int | None, parameters: dict[str, float], move: dict[str, float]) -> None:
        """Add the command of a line's motion, which leads somewhere."""
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
        stands = self.per_turn is not None and not self.spindle  # the feed per turn is none, and the one before is over
        if mode > 0 and stands != self.stands:
            self._add("G95" if stands else "G94", {})
            self.stands = stands
        for _ in range(repeats if self.relative else 1):
            self._add(name, move)

    def _note(self, mode: int, parameters: dict[str, float], move: dict[str, float]) -> None:
        """Collect the clues of a move to its dialect; report its parameters that are not read."""
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
        """Return how often a cycle is made, and leave to `move` the words that tell its holes."""
        move.pop("K", None)
        pecks = [letter for letter in "IJK" if letter in parameters]
        letter = "L" if "L" in parameters else "K"
        drills_once = mode not in (*codes.PECKING, codes.BORING)
        if drills_once and {"Z", "I"} <= move.keys() and "R" not in move:
            # Fagor: Z is the level before the hole, I its depth, K a dwell.
            move["R"], move["Z"] = move["Z"], move.pop("I")
            if "K" in parameters:
                self.problem(Message("dwell-untimed"))
            return whole(parameters.get("L", 1.0), _MOST_REPEATS)
        if mode in codes.PECKING and ("I" in pecks or "J" in pecks or parameters.get("K", 1.0) % 1):
            # Haas and Yasnac: I first peck, J less with each, K at least.
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
        """Tell of a word that is none of a mill's three axes; a rotary axis stands at 0 before its first word."""
        if letter not in ROTARY:
            self.problem(Message("word-not-read", letter=letter))
        elif value != self.angles.get(letter, 0.0):
            self.problem(Message("rotary-not-read", letter=letter))
            self.angles[letter] = value

    def _feed(self, value: float | None) -> float | None:
        """Return a feed rate in mm/s, None where there is none; G93 gives the seconds of this line instead."""
        self.seconds = 60 / value if self.feed_mode == codes.INVERSE_TIME and value and value > 0 else 0.0
        if value is None or self.feed_mode == codes.INVERSE_TIME:
            return None
        self.per_turn = value if self.feed_mode == codes.PER_TURN else None
        return value * self.unit * (self.spindle if self.feed_mode == codes.PER_TURN else 1.0) / 60


def _offset(code: int, words: list[tuple[str, float]], okuma: bool) -> tuple[int, float] | None:
    """Return which work offset a G-code names, None where it names none; G54.1 and G154 have its number in P."""
    if okuma:
        return (code, dict(words).get("H", 0.0)) if code == codes.OKUMA_OFFSET else None
    if code not in codes.OFFSETS:
        return None
    return code, dict(words).get("P", 0.0) if code in codes.NUMBERED_OFFSETS else 0.0


def _words_of(m_code: float, *, first: bool) -> frozenset[str]:
    """Return the letters of the words that belong to an M-code, as far as they would be others without it.

    In a line that moves, as G1 X5 M203, a machine's own M-code has none: these are Marlin's where they come first.
    """
    if m_code in _OUTPUTS:
        return frozenset("EQ")
    if first and (m_code in _SETTINGS or m_code >= _OTHERS_M_CODE):
        return frozenset("ABCEFIJKPQRTUVWXYZ")
    return frozenset()
