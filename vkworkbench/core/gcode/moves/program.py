# SPDX-License-Identifier: LGPL-2.1-or-later
"""An NC program as commands, with what else its text says."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from vkworkbench.core.gcode.moves.commands import Commands
from vkworkbench.core.gcode.moves.linearize import linearize
from vkworkbench.core.machining import exact_lengths
from vkworkbench.core.toolpath import Problem, Toolpath
from vkworkbench.language import Message


@dataclass(frozen=True, eq=False)
class Program:
    """An NC program.

    Attributes
    ----------
    commands : Commands
        What `linearize` takes, in mm and mm/s; every tool change is an ``M6`` with its number as ``T``. Where there are
        M6 words, a tool that is named is a ``T1`` without words.
    lines : (n,) int64
        Line of the text in which each command stands, counted from 1; of a subprogram the line of its call.
    comments : tuple of (int, int, str)
        For each comment with a line of its own (or that of a tool change, a stop or the program's number) the
        command before which it stands, its line and its text.
    in_calls : frozenset of int
        Which of the comments stand in subprograms.
    inverse_time : dict of int to float
        For each command under G93 (inverse time) the share of its move that is done in one second, 1/s.
    inches : bool
        Whether the program's first unit word is G20; lengths in its comments are in that unit.
    unit_told : bool
        Whether there is a unit word (G20, G21) at all; without one it is read in mm.
    other : Message or None
        For which machine it is, where that is no mill.
    rotary : tuple of int
        Lines in which a rotary axis turns while the tool cuts.
    problems : tuple of Problem
        What is not read; `command` is a line of the text.
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

    def toolpath(self, *, tolerance: float = 0.01) -> Toolpath:
        """Return the whole program's trajectories, with its problems; `command` is a line of the text in all of them.

        Their `commands` are as many as these numbers need.

        Raises
        ------
        ValueError
            As `linearize`.
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
        )
