# SPDX-License-Identifier: LGPL-2.1-or-later
"""Determine the modal state at every command: motion, position, plane, modes and feed rate.

The value of a modal state comes from the last command that sets the state. A running maximum over the indices of the
commands that set the state finds the last of these commands.
"""

from __future__ import annotations

from typing import List

import numpy as np

from vkworkbench.core.gcode.moves import codes, cycles
from vkworkbench.core.gcode.moves.unread import dwells, unread
from vkworkbench.core.gcode.moves.words import Words
from vkworkbench.core.toolpath import COORDINATE_LIMIT, PLANE_AXES, SLOWEST, Problem
from vkworkbench.language import Message

_COARSEST_PITCH = 10.0  # mm; a larger F word of a tap is a feed rate, not a pitch.
_MOST_NAMED = 10  # Largest number of unknown codes that are named in messages; further unknown codes are only counted.


class Problems(List[Problem]):
    """The problems found so far; each problem has one message."""

    def add(self, rows: np.ndarray, what: Message) -> None:
        """Add a message on the commands with the indices `rows`; without indices, add nothing."""
        if len(rows):
            self.append(Problem.at(rows, what))


class ModalState:
    """The modal state at every command (motion, position, plane, modes and feed), and the problems found so far."""

    def __init__(self, words: Words, infer_centres: bool) -> None:
        self.words, self.problems = words, Problems()
        code = words.codes
        self._report_codes()

        # A command with an empty name continues the last motion, until G80 ends the motion.
        is_motion = np.isin(code, codes.MOTIONS)
        self.motion = np.where(is_motion, code, -1)
        modal = np.flatnonzero(code == codes.MODAL)
        if len(modal):
            setter = _last(is_motion | (code == codes.CANCEL))[modal]
            inherited = np.where(setter >= 0, code[setter], -1)
            self.motion[modal] = np.where(inherited == codes.CANCEL, -1, inherited)
            self.problems.add(modal[self.motion[modal] < 0], Message("words-without-motion"))
        self.is_cycle = np.isin(self.motion, codes.CYCLES)
        for rows, what in unread(words, self.motion):
            self.problems.add(rows, what)
        dwelling, seconds = dwells(words, self.motion)
        self.dwells = np.column_stack([dwelling, seconds])[~np.isnan(seconds)]

        self.plane = _mode(words, codes.PLANES, 17)
        self.relative = _mode(words, {codes.ABSOLUTE: 0, codes.RELATIVE: 1}, 0) == 1
        self.to_machine, self.rises = self._moves_to_machine()
        self.relative[self.to_machine] = False
        self.motion[self.to_machine] = codes.RAPID
        self.absolute_centre = _mode(words, {codes.ABSOLUTE_CENTRES: 1, codes.RELATIVE_CENTRES: 0}, 0) == 1
        self.infer_centres = infer_centres and not np.isin(code, (codes.ABSOLUTE_CENTRES, codes.RELATIVE_CENTRES)).any()
        retract = _mode(words, {codes.TO_START: 0, codes.TO_RETRACT_PLANE: 1, codes.RAPID_TO_START: 2}, 0)
        self.to_retract_plane, self.rapid_to_start = retract == 1, retract == 2
        self.feed = self._feed()
        count = np.count_nonzero(self.is_cycle)
        self.cycle_heights, self.cycle_peck = np.empty((count, 4)), np.empty(count)
        self.cycle_rises = np.zeros(count, bool)
        # The axis of canned cycles.
        self.drilled = np.array([PLANE_AXES[p][2] for p in range(17, 20)], np.int8)[self.plane - 17]
        self.position, self.known = self._positions()

    def _report_codes(self) -> None:
        code, names = self.words.codes, self.words.names
        known = np.concatenate([codes.MOTIONS, codes.STATES, codes.PROBES, codes.MACHINE])
        self.problems.add(self.words.two_codes, Message("two-codes"))
        by_name: dict[str, list[int]] = {}
        for row, second in zip(self.words.second_rows.tolist(), self.words.second_codes.tolist()):
            if second == codes.UNKNOWN or (second >= 0 and second not in known):
                by_name.setdefault(codes.name_of(second), []).append(row)
        for row in np.flatnonzero((code == codes.UNKNOWN) | ((code >= 0) & ~np.isin(code, known))).tolist():
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
        code = self.words.codes
        rows = np.flatnonzero(np.isin(code, codes.MACHINE))
        if not len(rows):
            return rows, rows
        along_x, along_y, along_z = (~np.isnan(self.words.column(letter)[0]) for letter in "XYZ")
        across = along_x | along_y
        alone = rows[~(across | along_z)[rows]]
        behind = np.minimum(alone[code[alone] == codes.MACHINE_COORDINATES] + 1, len(code) - 1)
        behind = behind[np.isin(self.motion[behind], (codes.RAPID, codes.FEED))]
        moving = np.union1d(rows, behind)
        home = alone[code[alone] != codes.MACHINE_COORDINATES]
        after = np.minimum(home + 1, len(code) - 1)  # G28 G91 Z0 is split into G28 and G91 Z0
        in_z = np.isin(code[after], (codes.ABSOLUTE, codes.RELATIVE)) & along_z[after] & ~across[after]
        aside = np.union1d(moving[across[moving]], home[~in_z])
        aside = aside[aside < np.flatnonzero(self.motion >= 0).max(initial=0)]
        told_by = np.where(np.isin(aside, behind), codes.MACHINE_COORDINATES, code[aside])
        for machine in codes.MACHINE:
            self.problems.add(aside[told_by == machine], Message("machine-position", name=codes.name_of(machine)))
        return moving, np.union1d(moving[along_z[moving]], home)

    def before(self, rows: np.ndarray) -> np.ndarray:
        """Return the position before each of the given commands, (m, 3) mm."""
        return self.position[np.maximum(rows - 1, 0)]

    def _feed(self) -> np.ndarray:
        values, unusable = self.words.column("F")
        unusable |= (values != 0) & (values < SLOWEST)
        self.problems.add(np.flatnonzero(unusable), Message("unusable-feed"))
        tapping = np.flatnonzero(np.isin(self.motion, codes.TAPPING) & (values <= _COARSEST_PITCH))
        if len(tapping):  # A FreeCAD tap has the pitch in F and the speed in S; the feed rate is their product.
            speed = self.words.column("S", tapping)[0]  # Speed in turns/min.
            values[tapping] *= np.where(speed > 0, speed / 60, 1)
        setter = _last(values >= SLOWEST)
        per_minute = _mode(self.words, {codes.INVERSE_TIME: 0, codes.PER_MINUTE: 1, codes.PER_TURN: 0}, 1) == 1
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
        if beyond.any():  # the sum of relative words can exceed the limit, although each word is below it
            self.problems.add(np.flatnonzero(beyond.any(axis=1)), Message("position-cut-off"))
            position = np.clip(position, -COORDINATE_LIMIT, COORDINATE_LIMIT)
        return position, known

    def _highest(self, z: np.ndarray, drills: np.ndarray) -> float:
        """Return the greatest height that Z words give, mm; NaN without Z words.

        In a canned cycle along Z (`drills`), the R word is used, because the Z word is the bottom of the hole. Cycles
        under G91 are ignored.
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
        parted = ((self.motion >= 0) & ~drills) | (self.words.codes == codes.CANCEL)
        along[rows] = np.nan
        series = np.cumsum(parted)[rows]
        along, heights, rises = cycles.heights(
            along, self.relative, rows, series, own["R"], own["Z"], self.to_retract_plane[rows]
        )
        peck = _held(own["Q"])
        tiny = np.isin(self.motion[rows], codes.PECKING) & cycles.has_tiny_pecks(heights, peck)
        self.problems.add(rows[tiny], Message("tiny-pecks", most=cycles.MOST_PECKS))
        among = np.searchsorted(np.flatnonzero(self.is_cycle), rows)
        self.cycle_heights[among], self.cycle_peck[among], self.cycle_rises[among] = heights, peck, rises
        return along


def _last(mask: np.ndarray) -> np.ndarray:
    """Return the index of the last True at or before each element, -1 if there is none, (n,) int."""
    return np.maximum.accumulate(np.where(mask, np.arange(len(mask)), -1))


def _held(values: np.ndarray) -> np.ndarray:
    """Replace each NaN by the last number before the NaN."""
    last = _last(~np.isnan(values))
    return np.where(last >= 0, values[last], np.nan) if len(values) else values


def _mode(words: Words, states: dict[int, int], default: int) -> np.ndarray:
    """Return the state of a modal group at every command: the value for the group's last code, (n,) int."""
    value, sets = np.full(len(words), default, np.int8), np.zeros(len(words), bool)
    for state, state_value in states.items():
        own = words.rows_of(state)
        value[own], sets[own] = state_value, True
    if not sets.any():
        return value
    setter = _last(sets)
    return np.where(setter >= 0, value[setter], default)


def _coordinate(values: np.ndarray, relative: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the position of one axis after every command, (n,) mm, and whether the position is known, (n,) bool.

    The position before the axis's first word is not known. If the axis's first word is absolute, its value also
    replaces the unknown position before the word. Relative words before the first absolute word are added up from 0.
    The position of an axis without words is 0.
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
