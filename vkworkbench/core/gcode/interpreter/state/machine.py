# SPDX-License-Identifier: LGPL-2.1-or-later
"""Store the commands of the program lines read so far, and the state of the machine after these lines."""

from __future__ import annotations

from array import array
from typing import Callable

from vkworkbench.core.gcode.dialects import Clues, Dialect, Drilling
from vkworkbench.core.gcode.interpreter.state.line import Line
from vkworkbench.core.gcode.interpreter.state.maps import Map, Maps
from vkworkbench.core.gcode.interpreter.state.modes import Modes
from vkworkbench.core.gcode.interpreter.state.offset_path import Compensation, Corner
from vkworkbench.core.gcode.interpreter.state.origins import Origins
from vkworkbench.core.gcode.interpreter.state.place import Place
from vkworkbench.core.gcode.moves import codes
from vkworkbench.core.gcode.moves.commands import Commands
from vkworkbench.language import Message

NO_LENGTH = (490, None)  # value of `Machine.tool_length` under G49, without a tool length offset


class Machine:
    """The commands of the program lines read so far, and the state of the machine after these lines.

    `modes` contains the state that a program can save and restore, so saving copies only a few numbers.

    Attributes
    ----------
    commands, lines, inverse_time
        See the attributes with the same names in `Program`.
    problems : dict of Message to list of int
        Messages on the parts of the program that were not read, with the lines of these parts.
    clues : Clues
        Signs of the machine for which the program was written.
    number, deleted
        The current line, counted from 1, and whether it has a block delete.
    modes : Modes
        The modal state, without the motion.
    saved : list of (Modes or None, bool)
        For the main program and each nested call: the modal state that M70 or M73 saved, and whether the return from
        the subprogram restores this state (M73).
    origins : Origins
        The origins of the coordinates.
    maps : Maps
        The mirrors, scales and rotations of the coordinates.
    place : Place
        The position of the tool.
    compensation : Compensation or None
        The cutter compensation in force; None if no compensation is followed.
    corner : Corner or None
        The corner after the last move; None if the last move's line has no corner word that can be read.
    radii : dict
        The radii of tool offsets that the program contains, mm, by the L and P words of G10; NaN if unknown.
    first_unit : float or None
        The program's first unit, mm: 25.4 for inches, 1 for mm; None before the first unit word.
    motion : int
        The G-code of the motion in force, as ten times its number (10 for G1); -1 before the first motion.
    before_cycles : int
        The motion before the last series of canned cycles.
    written : int
        The motion of the last command that moves the tool.
    moved : bool
        Whether any line has moved the tool.
    away : list of (int, Message)
        Lines of moves to machine positions since the last other move, with messages. The messages about machine
        positions are reported only if another move follows in the program.
    ended : bool
        Whether the lines read so far contain M2 or M30.
    call : float or None
        The M-code with which the last line calls a subprogram; None if the line calls none. The caller of the method
        `block` must read the subprogram's lines.
    calls_blocks : bool
        Whether the program calls subprograms by block numbers (M97, or M98 with Q).
    tool_length : tuple
        The G-code of the tool length offset in force, as ten times its number (430 for G43), and the number of the
        offset or its length.
    length_changed : bool
        Whether the tool length offset changed since the last Z word.
    stopped : bool
        Whether the operator or the tool changer had the opportunity to move the tool since the last Z word.
    last_y : float or None
        The last absolute Y, mm.
    okuma : bool
        Whether work offsets are selected with G15 H.
    spindle : float
        Spindle speed, turns/min.
    stands : bool
        Whether the last move used G95 while the spindle speed was 0.
    tool, spindle_tool : int or None
        Number in the last T word, and number of the tool after the last M6.
    changes : bool
        Whether the program contains an M6; without M6, T words change the tool.
    unnamed : int or None
        Index of the last M6 since the last move, if no T word before the M6 names a new tool.
    seconds : float
        Duration of this line's move under G93, s; 0 under other feed modes.
    dwells : list of (int, float)
        Line and duration in s of each dwell.
    pause : float
        Dwell in each hole of the canned cycle in force, s.
    later : dict or None
        Words of a canned cycle with L0, which drills no hole until a later line contains axis words; otherwise None.
    angles : dict
        Last value of each rotary axis, by its letter.
    polar : bool
        Whether X words are distances from the origin, and Y words are angles (G16).
    pole : dict
        The centre that is in force for later arcs, mm; empty unless `Dialect.has_pole`.
    drilling : Drilling or None
        The cycle of a Siemens control that drills a hole after each move in X and Y (MCALL); None without a cycle.

    Parameters
    ----------
    dialect : Dialect
        The dialect of the program.
    is_fanuc : callable
        Returns whether the program is written for a Fanuc control.
    """

    def __init__(self, dialect: Dialect, is_fanuc: Callable[[], bool]) -> None:
        self.dialect, self.is_fanuc = dialect, is_fanuc
        self.commands = Commands()
        self.lines = array("q")
        self.inverse_time: dict[int, float] = {}
        self.dwells: list[tuple[int, float]] = []
        self.pause = 0.0
        self.problems: dict[Message, list[int]] = {}
        self.clues = Clues()
        self.number = 0
        self.deleted = False
        self.modes = Modes()
        self.saved: list[tuple[Modes | None, bool]] = [(None, False)]
        self.origins = Origins()
        self.maps = Maps()
        self.compensation: Compensation | None = None
        self.corner: Corner | None = None
        self.radii: dict[tuple[float, float], float] = {}
        self.place = Place(self.commands)
        self.first_unit: float | None = None
        self.motion = self.before_cycles = self.written = -1
        self.moved = self.ended = False
        self.away: list[tuple[int, Message]] = []
        self.call: float | None = None
        self.calls_blocks = False
        self.tool_length: tuple[int, float | None] = NO_LENGTH
        self.length_changed = self.stopped = False
        self.last_y: float | None = None
        self.okuma = False
        self.spindle = 0.0
        self.stands = False
        self.tool: int | None = None
        self.spindle_tool: int | None = None
        self.changes = False
        self.unnamed: int | None = None
        self.seconds = 0.0
        self.later: dict[str, float] | None = None
        self.angles: dict[str, float] = {}
        self.polar = False
        self.pole: dict[str, float] = {}
        self.drilling: Drilling | None = None

    def problem(self, what: Message, line: int | None = None) -> None:
        """Store a message on a part of the program that is not read, with its line (by default the current line)."""
        self.problems.setdefault(what, []).append(self.number if line is None else line)

    @property
    def moves_plainly(self) -> bool:
        """bool : Whether the commands of moves depend only on the units, on G90 or G91, and on the motion.

        While this property is True, `plain_lines` reads many lines at once, without the handlers of this package. The
        property must be False if another state of the machine changes the commands of moves, or leads to messages.
        """
        return (
            self.moved
            and self.motion == self.written
            and self.motion in (codes.RAPID, codes.FEED, *codes.ARCS)
            and self.modes.feed_mode == codes.PER_MINUTE
            and not (self.ended or self.away or self.length_changed or self.stands)
            and not (self.origins.used or self.is_mapped or self.polar)
            and self.compensation is None
            and self.corner is None
            and self.drilling is None
            and self.unnamed is None
            and self.later is None
            and self.dialect.codes is None
            and not (self.dialect.has_pole or self.clues.notes_feeds)
        )

    def add(self, name: str, parameters: dict[str, float]) -> None:
        """Add a command of the current line."""
        self.commands.append((name, parameters))
        self.lines.append(self.number)

    def write(self, mode: int, move: dict[str, float]) -> None:
        """Add the command of a move; the name is empty if the motion is still in force."""
        self.add("" if mode == self.written else codes.name_of(mode), move)
        self.written = mode

    def move_end(self, command: int, end: complex, way: complex, *, relative: bool) -> None:
        """Change the end of the last move in the XY plane by the vector `way` to the point `end`, mm."""
        name, words = self.commands[command]
        if relative:
            end = complex(words.get("X", 0.0), words.get("Y", 0.0)) + way
        words["X"], words["Y"] = end.real, end.imag
        self.commands[command] = name, words
        self.place.move_end(command, way)

    def stand(self, *, stands: bool) -> None:
        """Begin or end moves at an unknown feed rate, which is a feed per turn while the spindle does not turn."""
        if stands != self.stands:
            self.add("G95" if stands else "G94", {})
            self.stands = stands

    def leave_out(self, line: Line, what: Message) -> None:
        """Report a code that is not read. The axis words in the code's line are not the target of a move."""
        self.problem(what)
        line.apart = True

    def unknown(self, code: int, line: Line) -> None:
        """Report an unknown G-code, and the axis words in the line, because they can be the G-code's parameters."""
        name, left_out = repr(codes.name_of(code)), ", ".join(sorted(line.letters & {"X", "Y", "Z"}))
        if left_out:
            self.problem(Message("unknown-code-with-words", name=name, letters=left_out))
        else:
            self.problem(Message("unknown-code", name=name))
        line.apart, line.feeds = True, False

    def other(self, line: Line) -> None:
        """Process a G-code without a handler of its own."""
        of_a_lathe = self.clues.g_code(line.code // 10, line.letters, self.number)
        moves = line.code in codes.STORED_POSITIONS
        moves |= line.code in codes.MOVES_ALONE and codes.MOTION_WORDS.isdisjoint(line.words)
        mirrors = line.code == codes.END_DATA and not self.is_fanuc()
        if of_a_lathe or mirrors or (moves and not line.letters.isdisjoint("XYZ")) or line.code not in codes.HARMLESS:
            self.unknown(line.code, line)

    @property
    def is_mapped(self) -> bool:
        """bool : Whether coordinates are mirrored, scaled or rotated; False in most programs."""
        return self.maps.fixes_origin or self.origins.system in self.maps.angles

    def map(self) -> Map:
        """Return the map of the XY plane in force, from points of the program to points of the toolpath."""
        of, shift = self.origins.of, self.origins.shift
        origin = complex(of("X"), of("Y"))
        of_system = origin - complex(shift.get("X", 0.0), shift.get("Y", 0.0))
        return self.maps.xy(self.origins.system, of_system, origin)

    def here(self) -> dict[str, float]:
        """Return the known coordinates of the tool, mm, before the maps in force are applied."""
        place = self.place.now()
        if not self.is_mapped or "X" not in place or "Y" not in place:
            return place
        before = self.map().back(complex(place["X"], place["Y"]))
        height = self.maps.height_before(place["Z"], self.origins.of("Z")) if "Z" in place else None
        return {**place, "X": before.real, "Y": before.imag, **({} if height is None else {"Z": height})}

    def coordinates(self) -> dict[str, float]:
        """Return the known coordinates of the tool as a program writes them, in the program's unit.

        The coordinates are rounded, because a conversion to inches and back would change comparisons in the program.
        """
        here, beside = dict(self.here()), self.compensation
        if beside is not None:
            here.update(X=beside.programmed.real, Y=beside.programmed.imag)
        return {axis: round((value - self.origins.of(axis)) / self.modes.unit, 9) for axis, value in here.items()}

    def stop(self) -> None:
        """Note a program stop or tool change."""
        self.stopped = True
        self.away = [(line, what) for line, what in self.away if what.code != "machine-height"]

    def measure_in(self, code: int) -> None:
        """Set the unit of lengths and feed rates by a G-code, given as ten times its number (200 for G20)."""
        self.modes.measure_in(code, self.dialect.feeds_in_mm)
        if self.first_unit is None:
            self.first_unit = self.modes.unit


Handler = Callable[[Machine, Line], None]  # a function that processes one G-code of a program line
