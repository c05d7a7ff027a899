# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define an NC program: its commands, its comments, and other contents of its text."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from vkworkbench.core.gcode.moves.commands import Commands
from vkworkbench.core.gcode.moves.linearize import linearize
from vkworkbench.core.toolpath import Problem, Toolpath, exact_lengths
from vkworkbench.language import Message


@dataclass(frozen=True, eq=False)
class Program:
    """An NC program that has been read.

    Attributes
    ----------
    commands : Commands
        Input for `linearize`, in mm and mm/s. Every tool change is an ``M6`` with the tool's number as parameter ``T``,
        if known. In a program with M6, a T word is also a command of its own, such as ``T1``, without parameters.
    lines : (n,) int64
        Line of the text for each command, counted from 1; for commands in a subprogram, the line of the call.
    comments : tuple of (int, int, str)
        For each comment, the index of the command that follows the comment, the line and the text. Two kinds of
        comments are left out: comments in a line with X, Y or Z words and without T, M and O words, and comments that
        only explain a code in their line.
    in_calls : frozenset of int
        Indices of the comments in subprograms.
    inverse_time : dict of int to float
        For each command under G93 (inverse time), the reciprocal of its duration, 1/s.
    inches : bool
        Whether the program's first unit is inches (G20). Lengths in the program's comments are in the program's first
        unit.
    unit_told : bool
        Whether the program contains a unit word (G20, G21); without a unit word, the program is read in mm.
    other : Message or None
        Message with the machine (for example a lathe) for which the program was written; None for a mill.
    rotary : tuple of int
        Lines in which a rotary axis turns while the tool cuts.
    problems : tuple of Problem
        The parts of the program that were not read; `command` is a line of the text.
    dwells : tuple of (int, float)
        Line and duration in s of each dwell.
    """

    commands: Commands
    lines: np.ndarray
    comments: tuple[tuple[int, int, str], ...]
    in_calls: frozenset[int]
    inverse_time: dict[int, float]
    inches: bool
    unit_told: bool
    other: Message | None
    rotary: tuple[int, ...]
    problems: tuple[Problem, ...]
    dwells: tuple[tuple[int, float], ...] = ()

    def toolpath(self, *, tolerance: float = 0.01) -> Toolpath:
        """Return the trajectories of the whole NC program, with its problems.

        `command` of the toolpath and of its problems contains program lines, not indices of commands. The toolpath's
        `commands` is the number of the last line + 1.

        Parameters
        ----------
        tolerance : float
            Largest distance between an arc and its chords, mm.

        Raises
        ------
        ValueError
            If `tolerance` is not a positive number.
        Unusable
            If the program needs more than 5 million moves.
        """
        path = linearize(self.commands, tolerance=tolerance, infer_centres=True)
        feed = path.feed
        if self.inverse_time:
            length = np.bincount(path.command, exact_lengths(path), len(self.commands))
            share = np.zeros(len(self.commands))
            share[list(self.inverse_time)] = list(self.inverse_time.values())
            feed = np.where(share[path.command] > 0, (length * share)[path.command], feed)
        problems = tuple(
            replace(problem, command=int(self.lines[problem.command]), commands=self.lines[problem.commands])
            for problem in path.problems
        )
        return replace(
            path,
            command=self.lines[path.command],
            commands=int(self.lines.max()) + 1,
            feed=feed,
            problems=self.problems + problems,
            dwells=np.array(self.dwells).reshape(-1, 2),
        )
