# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define the toolpath: the linearised trajectories of one operation, and its problems."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from vkworkbench.given import number, numbers, of_kind
from vkworkbench.language import Message, render

# Largest coordinate, mm: no milling machine reaches farther than a kilometre, so a larger coordinate is an error, which
# could also cause overflows.
COORDINATE_LIMIT = 1e6
# Slowest speed, mm/s: with a lower speed, a millimetre would take more than eleven days, so a lower speed is an error.
SLOWEST = 1e-6

# The two axes and the normal of each working plane (G17, G18 and G19), a right-handed system.
PLANE_AXES = {17: (0, 1, 2), 18: (2, 0, 1), 19: (1, 2, 0)}

_OF_TIME = "dwell-untimed", "probing-untimed"
_TAKES_TIME = "rotary-cuts", "rotary-not-read"
_HIDES_CUTS = (
    "rotary-cuts", "read-up-to", "jumps-not-followed", "line-with-variables", "variables-not-read", "subprogram-not-read",
    "cycle-outside-xy",
)  # fmt: skip


def _are_points(given: np.ndarray) -> bool:
    return given.size % 3 == 0 and bool((np.abs(given) <= COORDINATE_LIMIT).all())


@dataclass(frozen=True)
class Problem:
    """A part of the commands that could not be used, such as an unknown code.

    Attributes
    ----------
    command : int
        Index of the first source command concerned.
    what : Message
        Message that names the part that could not be used, and says how it was treated.
    count : int
        Number of commands concerned.
    commands : (count,) int64
        Indices of all commands concerned if the problem affects the machining time or hides cuts; otherwise empty.
    """

    command: int
    what: Message
    count: int = 1
    commands: np.ndarray = field(default_factory=lambda: np.empty(0, np.int64), compare=False, repr=False)

    @classmethod
    def at(cls, commands: Sequence[int] | np.ndarray, what: Message) -> Problem:
        """Return the problem `what` that concerns one or more commands, given in ascending order."""
        problem = cls(int(commands[0]), what, len(commands))
        return replace(problem, commands=np.asarray(commands, np.int64)) if problem._is_divided else problem

    def within(self, first: float, end: float) -> Problem | None:
        """Return the problem for the commands from `first` to `end` - 1 only, or None if it does not concern them.

        Only a problem that affects the machining time or hides cuts is divided. Every other problem belongs to its
        first command.
        """
        if not self._is_divided:
            return self if first <= self.command < end else None
        commands = self.commands[(first <= self.commands) & (self.commands < end)]
        return Problem.at(commands, self.what) if len(commands) else None

    @property
    def message(self) -> str:
        """The problem in English, such as ``"the unknown code 'G999' is ignored"``, without a full stop."""
        return render(self.what)

    @property
    def of_time(self) -> bool:
        """Whether the problem affects only the machining time, not the tool's path."""
        return self.what.code in _OF_TIME

    @property
    def takes_time(self) -> bool:
        """Whether the problem affects the machining time."""
        return self.of_time or self.what.code in _TAKES_TIME

    @property
    def hides_cuts(self) -> bool:
        """Whether, because of the problem, cuts can be missing or in wrong places, so that the strategy is unknown."""
        return self.what.code in _HIDES_CUTS

    @property
    def _is_divided(self) -> bool:
        return self.takes_time or self.hides_cuts

    @property
    def remark(self) -> Message:
        """The problem as a message with its first command and the number of commands concerned."""
        return Message("in-commands", sentence=self.what, count=self.count, command=self.command + 1)

    def __str__(self) -> str:
        return render(self.remark)


@dataclass(frozen=True, eq=False)
class Toolpath:
    """Trajectories of one operation: straight moves from ``points[i]`` to ``points[i + 1]``.

    Each trajectory begins at the end of the previous trajectory, and no trajectory has zero length. The paper's
    "trajectory" v_i (section 3.1) is ``points[i + 1] - points[i]``.

    Attributes
    ----------
    points : (n+1, 3) float64
        Positions of the tool tip, mm; the shape is (0, 3) if the NC program contains no position.
    rapid : (n,) bool
        Whether each trajectory is a positioning move (G0, or a rapid part of a canned cycle).
    command : (n,) int64
        Index of the source command of each trajectory.
    feed : (n,) float64
        Feed rate in mm/s; 0 for rapids, and for cuts without a feed rate in the NC program.
    sweep : (n,) float64
        Exact angle of the part of an arc that the trajectory replaces as a chord, rad; 0 for a straight move. Angles
        are positive if they are counter-clockwise around the plane's normal (right-hand rule).
    plane : (n,) uint8
        Working plane in force at each trajectory: 17 (XY), 18 (ZX) or 19 (YZ).
    cycle : (n,) bool
        Whether each trajectory is part of a canned drilling cycle.
    commands : int
        Number of source commands, comments included.
    tool_changes : (m,) int64
        Index of the trajectory after each tool change (M6), 0 to n.
    comments : tuple of (int, str)
        Comments of the NC program, as (index of the next trajectory, text without parentheses).
    problems : tuple of Problem
        Parts of the NC program that could not be used.
    dwells : (m, 2) float64
        Index of the source command and duration in s of each dwell (G4, and the P word of canned cycles).
    """

    points: np.ndarray
    rapid: np.ndarray
    command: np.ndarray
    feed: np.ndarray
    sweep: np.ndarray
    plane: np.ndarray
    cycle: np.ndarray
    commands: int = 0
    tool_changes: np.ndarray = field(default_factory=lambda: np.empty(0, np.int64))
    comments: tuple[tuple[int, str], ...] = ()
    problems: tuple[Problem, ...] = ()
    dwells: np.ndarray = field(default_factory=lambda: np.empty((0, 2)))

    @classmethod
    def through(cls, points: Sequence[Sequence[float]] | np.ndarray, *, feed: float = 10.0) -> Toolpath:
        """Return the toolpath that cuts straight from point to point; each trajectory has its own command.

        Parameters
        ----------
        points : (n+1, 3) array_like
            Points, mm; each point differs from the point before it.
        feed : float
            Feed rate, mm/s.

        Raises
        ------
        ValueError, TypeError
            If `points` is not an array of (n+1, 3) numbers within a kilometre of the origin, or `feed` is not a number.
        """
        takes = "an array of (n+1, 3) numbers of mm within a kilometer"
        points = np.array(numbers("points", points, takes, _are_points)).reshape(-1, 3)
        feed = number("feed", feed, "a number of mm/s")
        count = max(len(points) - 1, 0)
        return cls(
            points,
            rapid=np.zeros(count, bool),
            command=np.arange(count),
            feed=np.full(count, feed),
            sweep=np.zeros(count),
            plane=np.full(count, 17, np.uint8),
            cycle=np.zeros(count, bool),
            commands=count,
        )

    def __len__(self) -> int:
        """Return the number of trajectories."""
        return len(self.rapid)

    @property
    def hidden_cuts(self) -> Problem | None:
        """The first problem that hides cuts; None if no problem does."""
        return next((problem for problem in self.problems if problem.hides_cuts), None)

    def part(self, first: int, end: int) -> Toolpath:
        """Return the toolpath of the trajectories from `first` to `end` - 1.

        The returned toolpath contains the tool changes and comments between its trajectories, but no problems and no
        dwells.
        """
        inside = (self.tool_changes > first) & (self.tool_changes < end)
        return Toolpath(
            points=self.points[first : end + 1],
            rapid=self.rapid[first:end],
            command=self.command[first:end],
            feed=self.feed[first:end],
            sweep=self.sweep[first:end],
            plane=self.plane[first:end],
            cycle=self.cycle[first:end],
            commands=self.commands,
            tool_changes=self.tool_changes[inside] - first,
            comments=tuple((at - first, text) for at, text in self.comments if first < at < end),
        )

    @property
    def lengths(self) -> np.ndarray:
        """Chord length of every trajectory, (n,) mm."""
        return np.sqrt((np.diff(self.points, axis=0) ** 2).sum(axis=1))


def check_toolpath(given: object) -> None:
    """Raise a TypeError that explains how to make a toolpath, unless a Toolpath is given."""
    of_kind("a toolpath", given, Toolpath, "the Toolpath that linearize makes of commands")


def exact_lengths(toolpath: Toolpath) -> np.ndarray:
    """Return the length of every trajectory; for a chord of an arc or helix, the length along the curve.

    A chord with length c in the working plane and sweep s belongs to an arc with radius r = c / (2 sin(s/2)). If the
    chord rises by h along the plane's normal, its part of the helix is sqrt((r s)^2 + h^2) long.

    Parameters
    ----------
    toolpath : Toolpath
        n trajectories.

    Returns
    -------
    (n,) float64
        Lengths, mm.

    Raises
    ------
    TypeError
        If `toolpath` is not a Toolpath.
    """
    check_toolpath(toolpath)
    moves = np.diff(toolpath.points, axis=0)
    if not len(moves):
        return np.zeros(0)
    lengths: np.ndarray = np.sqrt((moves**2).sum(axis=1))
    arc = np.flatnonzero(toolpath.sweep)
    if len(arc):
        squares = moves[arc] ** 2
        normal = np.zeros(len(arc), dtype=int)
        for plane, (_, _, axis) in PLANE_AXES.items():
            normal[toolpath.plane[arc] == plane] = axis
        rise2 = squares[np.arange(len(arc)), normal]
        half = np.abs(toolpath.sweep[arc]) / 2
        lengths[arc] = np.sqrt((squares.sum(axis=1) - rise2) * (half / np.sin(half)) ** 2 + rise2)
    return lengths
