# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert commands into trajectories: resolve modal state, arcs and canned cycles into straight moves.

All steps process whole columns. A modal state has the value from the last row that sets the state, and a running
maximum of row numbers finds this row. Python loops are needed only to read the commands and to compute the heights of
canned cycles.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, List

import numpy as np

from vkworkbench.core.gcode.moves import arcs, cycles
from vkworkbench.core.gcode.moves.codes import (
    ABSOLUTE,
    ABSOLUTE_CENTRES,
    ARCS,
    CANCEL,
    CLOCKWISE,
    COMMENT,
    CYCLES,
    FEED,
    INVERSE_TIME,
    MACHINE,
    MACHINE_COORDINATES,
    MODAL,
    MOTIONS,
    PECKING,
    PER_MINUTE,
    PER_TURN,
    PLANES,
    PROBES,
    RAPID,
    RELATIVE,
    RELATIVE_CENTRES,
    STATES,
    TAPPING,
    TO_RETRACT_PLANE,
    TO_START,
    TOOL_CHANGE,
    UNKNOWN,
    name_of,
)
from vkworkbench.core.gcode.moves.unread import dwells, unread
from vkworkbench.core.gcode.moves.words import Words
from vkworkbench.core.toolpath import COORDINATE_LIMIT, PLANE_AXES, Problem, Toolpath
from vkworkbench.given import number, positive
from vkworkbench.language import Message, Unusable

MOST_TRAJECTORIES = 5_000_000  # needs 2 GB of memory
SLOWEST_FEED = 1e-6  # mm/s, eleven days for a millimetre; a lower feed is an error
_COARSEST_PITCH = 10.0  # mm; a larger F word of a tap is a feed rate, not a pitch

_MOST_NAMED = 10  # unknown codes with a message each; further codes are only counted
_ZERO_LENGTH = 1e-9  # mm; shorter trajectories are left out
_MOST_TURNS = 10_000  # turns of an arc (P)
_OFF_CIRCLE = 0.05  # mm; if an arc ends farther from its circle, its centre words were probably misread


def linearize(commands: Iterable[Any] | Words, *, tolerance: float = 0.01, infer_centres: bool = False) -> Toolpath:
    """Resolve the commands of one operation into straight trajectories.

    The paper assumes that "all the trajectories are linearized and defined by the Cartesian co-ordinates of
    their starting point and of their point of destination" (section 2.1); this function makes it true.

    Parameters
    ----------
    commands : iterable or Words
        ``(name, parameters)`` pairs, or objects with ``.Name`` and ``.Parameters``, in FreeCAD's units (mm, mm/s).
        Names may be ``G1``, ``G01``, ``(comment)``, or empty for a modal line. In a tap (G84, G74) with an S word
        (turns/min), an F word of at most 10 is the pitch, mm.
    tolerance : float
        Largest distance between an arc and its chords, mm.
    infer_centres : bool
        Whether the centre words of arcs may be read as coordinates if the commands contain neither G90.1 nor G91.1,
        because this is the default of some controls. Only the arcs count whose two readings differ: full circles fit
        both, and so do arcs with an R word. Coordinates are chosen if more than half of these arcs end off their circles
        with offsets, and if less than half as many do with coordinates.

    Returns
    -------
    Toolpath
        The trajectories; `problems` lists the parts of the commands that could not be used. The first word of an axis
        gives its start position, so the path does not begin with a move from the origin. In a move to a machine
        position (G28, G30, G53), the tool does not move in X and Y. In Z, the tool moves to its greatest height.

    Raises
    ------
    ValueError
        If `tolerance` is not a positive number.
    TypeError
        If `commands` has another type, for example a FreeCAD Path or the text of a program.
    Unusable
        If the commands need more than 5 million moves.
    """
    tolerance = number("tolerance", tolerance, "a positive number of mm", positive)
    words = commands if isinstance(commands, Words) else Words(commands)
    program = _Program(words, infer_centres)
    points, rapid, command, sweep, is_cycle = _moves(program, tolerance)

    moved = _moved(points)
    while not moved.all():  # repeat, because leaving out a short move may shorten the next move
        points = points[np.concatenate([[True], moved])]
        rapid, command, sweep, is_cycle = rapid[moved], command[moved], sweep[moved], is_cycle[moved]
        moved = _moved(points)
    points += 0.0  # -0.0 becomes 0.0
    feed = np.where(rapid, 0.0, program.feed[command])
    comments = np.flatnonzero(words.codes == COMMENT)
    before = np.searchsorted(command, comments).tolist()
    return Toolpath(
        points, rapid, command, feed, sweep, program.plane[command].astype(np.uint8), is_cycle,
        commands=len(words),
        tool_changes=np.searchsorted(command, np.flatnonzero(words.codes == TOOL_CHANGE)),
        comments=tuple((at, words.names[i].strip(" ()")) for at, i in zip(before, comments.tolist())),
        problems=tuple(program.problems),
        dwells=program.dwells,
    )  # fmt: skip


def _moved(points: np.ndarray) -> np.ndarray:
    """Return whether each trajectory is longer than `_ZERO_LENGTH` along an axis, (n - 1,) bool."""
    result: np.ndarray = np.abs(np.diff(points, axis=0)).max(axis=1, initial=0.0) > _ZERO_LENGTH
    return result


class _Problems(List[Problem]):
    """The problems found, one for each message."""

    def add(self, rows: np.ndarray, what: Message) -> None:
        if len(rows):
            self.append(Problem.at(rows, what))


class _Program:
    """The modal state at every command (motion, position, plane, modes and feed), and the problems found so far."""

    def __init__(self, words: Words, infer_centres: bool) -> None:
        self.words, self.problems = words, _Problems()
        codes = words.codes
        self._report_codes()

        # A command with an empty name continues the last motion, until G80 ends the motion.
        is_motion = np.isin(codes, MOTIONS)
        self.motion = np.where(is_motion, codes, -1)
        modal = np.flatnonzero(codes == MODAL)
        if len(modal):
            setter = _last(is_motion | (codes == CANCEL))[modal]
            inherited = np.where(setter >= 0, codes[setter], -1)
            self.motion[modal] = np.where(inherited == CANCEL, -1, inherited)
            self.problems.add(modal[self.motion[modal] < 0], Message("words-without-motion"))
        self.is_cycle = np.isin(self.motion, CYCLES)
        for rows, what in unread(words, self.motion):
            self.problems.add(rows, what)
        dwelling, seconds = dwells(words, self.motion)
        self.dwells = np.column_stack([dwelling, seconds])[~np.isnan(seconds)]

        self.plane = _mode(words, PLANES, 17)
        self.relative = _mode(words, {ABSOLUTE: 0, RELATIVE: 1}, 0) == 1
        self.to_machine, self.rises = self._moves_to_machine()
        self.relative[self.to_machine] = False
        self.motion[self.to_machine] = RAPID
        self.absolute_centre = _mode(words, {ABSOLUTE_CENTRES: 1, RELATIVE_CENTRES: 0}, 0) == 1
        self.infer_centres = infer_centres and not np.isin(codes, (ABSOLUTE_CENTRES, RELATIVE_CENTRES)).any()
        self.to_retract_plane = _mode(words, {TO_START: 0, TO_RETRACT_PLANE: 1}, 0) == 1
        self.feed = self._feed()
        count = np.count_nonzero(self.is_cycle)
        self.cycle_heights, self.cycle_peck, self.cycle_begins = (
            np.empty((count, 4)),
            np.empty(count),
            np.ones(count, bool),
        )
        self.drilled = np.array([PLANE_AXES[p][2] for p in range(17, 20)])[self.plane - 17]  # axis of canned cycles
        self.position, self.known = self._positions()

    def _report_codes(self) -> None:
        codes, names = self.words.codes, self.words.names
        known = np.concatenate([MOTIONS, STATES, PROBES, MACHINE])
        self.problems.add(self.words.two_codes, Message("two-codes"))
        by_name: dict[str, list[int]] = {}
        for row, code in zip(self.words.second_rows.tolist(), self.words.second_codes.tolist()):
            if code == UNKNOWN or (code >= 0 and code not in known):
                by_name.setdefault(name_of(code), []).append(row)
        for row in np.flatnonzero((codes == UNKNOWN) | ((codes >= 0) & ~np.isin(codes, known))).tolist():
            by_name.setdefault(names[row], []).append(row)
        unknown = list(by_name.items())
        for name, rows in unknown[:_MOST_NAMED]:
            self.problems.add(np.array(rows), Message("unknown-code", name=repr(name[:40])))
        rest = [row for _, rows in unknown[_MOST_NAMED:] for row in rows]
        if rest:
            self.problems.add(np.array(rest), Message("more-unknown-codes", count=len(unknown) - _MOST_NAMED))

    def _moves_to_machine(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the indices of all moves to machine positions, (m,) int, and of the moves that rise in Z, (r,) int.

        FreeCAD splits a line such as ``G53 G0 Z0`` or ``G28 G91 Z0`` into two commands.
        """
        codes = self.words.codes
        rows = np.flatnonzero(np.isin(codes, MACHINE))
        if not len(rows):
            return rows, rows
        along_x, along_y, along_z = (~np.isnan(self.words.column(letter)[0]) for letter in "XYZ")
        across = along_x | along_y
        alone = rows[~(across | along_z)[rows]]
        behind = np.minimum(alone[codes[alone] == MACHINE_COORDINATES] + 1, len(codes) - 1)
        behind = behind[np.isin(self.motion[behind], (RAPID, FEED))]
        moving = np.union1d(rows, behind)
        home = alone[codes[alone] != MACHINE_COORDINATES]
        after = np.minimum(home + 1, len(codes) - 1)  # the G91 of G28 G91 Z0, with the axes
        in_z = np.isin(codes[after], (ABSOLUTE, RELATIVE)) & along_z[after] & ~across[after]
        aside = np.union1d(moving[across[moving]], home[~in_z])
        aside = aside[aside < np.flatnonzero(self.motion >= 0).max(initial=0)]
        told_by = np.where(np.isin(aside, behind), MACHINE_COORDINATES, codes[aside])
        for code in MACHINE:
            self.problems.add(aside[told_by == code], Message("machine-position", name=name_of(code)))
        return moving, np.union1d(moving[along_z[moving]], home)

    def before(self, rows: np.ndarray) -> np.ndarray:
        """Return the position before each of the given commands, (m, 3) mm."""
        result: np.ndarray = self.position[np.maximum(rows - 1, 0)]
        return result

    def _feed(self) -> np.ndarray:
        values, unusable = self.words.column("F")
        unusable |= (values != 0) & (values < SLOWEST_FEED)
        self.problems.add(np.flatnonzero(unusable), Message("unusable-feed"))
        tapping = np.flatnonzero(np.isin(self.motion, TAPPING) & (values <= _COARSEST_PITCH))
        if len(tapping):  # a FreeCAD tap has the pitch in F and the speed in S; the feed rate is their product
            speed = self.words.column("S", tapping)[0]  # turns/min
            values[tapping] *= np.where(speed > 0, speed / 60, 1)
        setter = _last(values >= SLOWEST_FEED)
        per_minute = _mode(self.words, {INVERSE_TIME: 0, PER_MINUTE: 1, PER_TURN: 0}, 1) == 1
        return np.where((setter >= 0) & per_minute, values[setter], 0.0)

    def _positions(self) -> tuple[np.ndarray, np.ndarray]:
        moves = self.motion >= 0
        position = np.empty((len(moves), 3))
        known = np.empty((len(moves), 3), bool)
        for axis, letter in enumerate("XYZ"):
            values, unusable = self.words.column(letter)
            self.problems.add(np.flatnonzero(unusable & moves), Message("unusable-word", letter=letter))
            values[~moves] = np.nan
            values[self.to_machine] = np.nan
            drills = self.is_cycle & (self.drilled == axis)
            if letter == "Z":
                values[self.rises] = self._highest(values, drills)
            if drills.any():
                if letter != "Z":
                    self.problems.add(np.flatnonzero(drills), Message("cycle-outside-xy", letter=letter))
                values, relative = self._resolve_cycles(values, drills), np.zeros(len(moves), bool)
            else:
                relative = self.relative
            position[:, axis], known[:, axis] = _coordinate(values, relative)
        beyond = np.abs(position) > COORDINATE_LIMIT
        if beyond.any():  # the sum of relative words may exceed the limit
            self.problems.add(np.flatnonzero(beyond.any(axis=1)), Message("position-cut-off"))
            position = np.clip(position, -COORDINATE_LIMIT, COORDINATE_LIMIT)
        return position, known

    def _highest(self, z: np.ndarray, drills: np.ndarray) -> float:
        """Return the greatest height to which Z words lead, mm; NaN without Z words.

        In a canned cycle along Z (`drills`), the R word counts, because the Z word is the bottom of the hole. A cycle
        under G91 does not count.
        """
        if drills.any():
            z = np.where(drills, np.where(self.relative, np.nan, self.words.column("R")[0]), z)
        given = ~np.isnan(z)
        return float(_coordinate(z, self.relative)[0][given].max()) if given.any() else np.nan

    def _resolve_cycles(self, along: np.ndarray, drills: np.ndarray) -> np.ndarray:
        """Return the absolute coordinates along the axis of canned cycles, (n,) mm; NaN where a command sets none.

        Parameters
        ----------
        along : (n,) float64
            The words of the axis, mm; NaN where absent.
        drills : (n,) bool
            Whether each command is a cycle along this axis.
        """
        rows = np.flatnonzero(drills)
        own = {"Z": along[rows]}
        for letter in "RQ":
            own[letter], unusable = self.words.column(letter, rows)
            self.problems.add(rows[unusable], Message("unusable-word", letter=letter))
        self.problems.add(rows[np.isnan(_held(own["Z"]))], Message("cycle-without-depth"))
        self.problems.add(rows[np.isnan(_held(own["R"]))], Message("cycle-without-retract"))
        parted = ((self.motion >= 0) & ~drills) | (self.words.codes == CANCEL)
        along[rows] = np.nan
        series = np.cumsum(parted)[rows]
        along, heights = cycles.heights(
            along, self.relative, rows, series, own["R"], own["Z"], self.to_retract_plane[rows]
        )
        peck = _held(own["Q"])
        tiny = np.isin(self.motion[rows], PECKING) & cycles.has_tiny_pecks(heights, peck)
        self.problems.add(rows[tiny], Message("tiny-pecks", most=cycles.MOST_PECKS))
        among = np.searchsorted(np.flatnonzero(self.is_cycle), rows)
        self.cycle_heights[among], self.cycle_peck[among] = heights, peck
        self.cycle_begins[among] = np.diff(series, prepend=-1) != 0
        return along


def _moves(program: _Program, tolerance: float) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return points, rapid, command, sweep and cycle of all moves, including moves with zero length."""
    motion, position = program.motion, program.position
    is_arc = np.isin(motion, ARCS)
    counts = (motion >= 0).astype(np.int64)

    arc_rows = np.flatnonzero(is_arc)
    if len(arc_rows):
        axes = np.array([PLANE_AXES[p] for p in program.plane[arc_rows].tolist()])
        start, end = program.before(arc_rows), position[arc_rows]
        flat_start = np.take_along_axis(start, axes, 1)
        flat_end = np.take_along_axis(end, axes, 1)
        resolved = _resolve_arcs(program, arc_rows, axes, flat_start, flat_end)
        counts[arc_rows] = arcs.chord_counts(resolved, tolerance)
    cycle_rows = np.flatnonzero(program.is_cycle)
    if len(cycle_rows):
        code = program.motion[cycle_rows]
        counts[cycle_rows] = cycles.move_counts(code, program.cycle_heights, program.cycle_peck)

    total = int(counts.sum())
    if total > MOST_TRAJECTORIES:
        raise Unusable(Message("too-many-moves", moves=total, tolerance=tolerance))
    command = np.repeat(np.arange(len(motion)), counts)
    points = position[command]
    rapid = (motion == RAPID)[command]
    is_cycle = program.is_cycle[command]
    sweep = np.zeros(total)
    if len(arc_rows):
        chord_of = np.repeat(np.arange(len(arc_rows)), counts[arc_rows])
        flat = arcs.chords(resolved, counts[arc_rows], flat_start[:, :2], flat_end[:, :2],
                           flat_start[:, 2], flat_end[:, 2])  # fmt: skip
        on_arc = is_arc[command]
        in_space = np.empty_like(flat)
        np.put_along_axis(in_space, axes[chord_of], flat, 1)
        points[on_arc] = in_space
        sweep[on_arc] = (resolved.sweep / counts[arc_rows])[chord_of]
    if len(cycle_rows):
        points[is_cycle], rapid[is_cycle] = _expand_cycles(program, cycle_rows)
    start = position[:1] if total else np.empty((0, 3))
    return np.concatenate([start, points]), rapid, command, sweep, is_cycle


def _resolve_arcs(
    program: _Program, rows: np.ndarray, axes: np.ndarray, start: np.ndarray, end: np.ndarray
) -> arcs.Arcs:
    words, problems = program.words, program.problems
    columns, unusable = zip(*(words.column(letter, rows) for letter in "IJK"))
    problems.add(rows[np.any(unusable, axis=0)], Message("unusable-centre"))
    offset = np.take_along_axis(np.column_stack(columns), axes[:, :2], 1)
    radius, unusable = words.column("R", rows)
    problems.add(rows[unusable], Message("unusable-word", letter="R"))
    clockwise = program.motion[rows] == CLOCKWISE
    ends = start[:, :2], end[:, :2], clockwise, offset, radius
    resolved = arcs.resolve(*ends, program.absolute_centre[rows])
    if program.infer_centres:
        absolute = arcs.resolve(*ends, np.ones(len(rows), bool))
        differ = np.abs(resolved.centre - absolute.centre).max(axis=1) > _OFF_CIRCLE
        circles = differ & ~np.isnan(offset).any(axis=1) & (np.abs(resolved.sweep) > 2 * np.pi - 1e-9)
        fits, fits_absolute = resolved.gap <= _OFF_CIRCLE, absolute.gap <= _OFF_CIRCLE
        tells = differ & ~circles & (fits | fits_absolute)
        off, off_absolute = (np.count_nonzero(tells & ~fit) for fit in (fits, fits_absolute))
        if 2 * off > np.count_nonzero(tells) and 2 * off_absolute < off:
            resolved = absolute
            problems.add(rows[:1], Message("absolute-centres"))
        elif not tells.any() and not _repeats(offset[circles]):
            problems.add(rows[circles], Message("circles-alone"))

    known = np.take_along_axis(program.known[np.maximum(rows - 1, 0)] & (rows > 0)[:, None], axes[:, :2], 1)
    unknown_start = ~known.all(axis=1)
    problems.add(rows[unknown_start], Message("arc-before-start"))
    bad = resolved.degenerate & ~unknown_start
    problems.add(rows[bad], Message("arc-as-line"))
    uneven = (resolved.gap > np.maximum(0.1, 0.01 * resolved.radius[:, 0])) & (resolved.sweep != 0) & ~unknown_start
    problems.add(rows[uneven], Message("arc-of-changing-radius"))
    turns = np.nan_to_num(words.column("P", rows)[0], nan=1.0)
    usable = (turns <= _MOST_TURNS) & (turns % 1 == 0)
    problems.add(rows[~usable & (turns > 1)], Message("turns-not-read"))
    resolved.sweep[:] += np.sign(resolved.sweep) * np.where(usable & (turns > 1), turns - 1, 0) * 2 * np.pi
    resolved.sweep[unknown_start] = 0.0  # an unknown start equals the end, so the arc becomes a line with zero length
    return resolved


def _repeats(offset: np.ndarray) -> bool:
    """Return whether two neighbouring circles have equal centre words, (m, 2) mm, as circles in a helix have.

    Such words are offsets, because coordinates would rarely make two circles around one centre.
    """
    return bool((np.diff(offset, axis=0) == 0).all(axis=1).any())


def _expand_cycles(program: _Program, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the end points of the moves of all canned cycles, (k, 3) mm, and whether each move is a rapid, (k,) bool."""
    start = program.before(rows).copy()
    start[rows == 0] = program.position[0]
    axes = np.array([PLANE_AXES[p] for p in program.plane[rows].tolist()])
    start = np.take_along_axis(start, axes, 1)
    start[:, 2] = program.cycle_heights[:, 0]
    hole = np.take_along_axis(program.position[rows], axes[:, :2], 1)
    code, heights, peck = program.motion[rows], program.cycle_heights, program.cycle_peck
    flat, rapid = cycles.moves(code, start, hole, heights, peck, program.cycle_begins)
    points = np.empty_like(flat)
    np.put_along_axis(points, np.repeat(axes, cycles.move_counts(code, heights, peck), axis=0), flat, 1)
    return points, rapid


def _last(mask: np.ndarray) -> np.ndarray:
    """Return the index of the last True at or before each element, -1 if there is none, (n,) int."""
    return np.maximum.accumulate(np.where(mask, np.arange(len(mask)), -1))


def _held(values: np.ndarray) -> np.ndarray:
    """Fill each NaN with the last number before it."""
    last = _last(~np.isnan(values))
    return np.where(last >= 0, values[last], np.nan) if len(values) else values


def _mode(words: Words, states: dict[int, int], default: int) -> np.ndarray:
    """Return the state of a modal group at every command: the value for the group's last code, (n,) int."""
    codes = words.codes
    value, sets = np.full(len(codes), default, np.int64), np.zeros(len(codes), bool)
    for code, code_value in states.items():
        for own in (np.flatnonzero(codes == code), words.second_rows[words.second_codes == code]):
            value[own], sets[own] = code_value, True
    if not sets.any():
        return value
    setter = _last(sets)
    return np.where(setter >= 0, value[setter], default)


def _coordinate(values: np.ndarray, relative: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the position of one axis after every command, (n,) mm, and whether it is known, (n,) bool.

    The position is not known before the axis's first word, and is set to the value of this word if the word is
    absolute. Relative words before the first absolute word are added up from 0. The position of an axis without words
    is 0.
    """
    given = ~np.isnan(values)
    known = _last(given) >= 0
    travelled = np.cumsum(np.where(given & relative, values, 0.0))
    anchor = _last(given & ~relative)
    anchored = np.where(anchor >= 0, values[anchor] - travelled[anchor], 0.0)
    position = anchored + travelled
    if known.any() and not relative[given.argmax()]:
        position[~known] = values[given.argmax()]
    return position, known
