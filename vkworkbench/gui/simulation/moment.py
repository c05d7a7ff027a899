# SPDX-License-Identifier: LGPL-2.1-or-later
"""The moment of a job that is shown: chosen, stepped to, or played."""

from __future__ import annotations

import time
from functools import cached_property

import numpy as np

from vkworkbench.gui.qt.names import QObject, Signal
from vkworkbench.gui.simulation.clock import Clock


class Moment(QObject):
    """A moment of the machine's time.

    Parameters
    ----------
    clock : Clock

    Attributes
    ----------
    changed : Signal
        The moment is another one, or a play began or ended.
    seconds, done : float, int
        The machine's time, s, and how many trajectories have been cut by then.
    noticed : int or None
        The trajectory that the user is to notice: the one that he chose, or the last one that was cut.
    """

    changed = Signal()

    def __init__(self, clock: Clock, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.clock = clock
        self.seconds, self.done = clock.total, len(clock.cuts)  # the finished part
        self.noticed: int | None = None
        self._played: float | None = None  # when the last picture of a play was due

    @property
    def plays(self) -> bool:
        return self._played is not None

    @property
    def last(self) -> int:
        """The last trajectory that has been cut, or the first where none has."""
        return max(self.done - 1, 0)

    def go_to(self, seconds: float, trajectory: int | None = None) -> None:
        """Go to a moment; where several trajectories end then, right after this one, which is to be noticed."""
        self._played = None
        self.noticed = trajectory
        self._set(seconds, trajectory)
        if trajectory is None and 0 < self.done < len(self.clock.cuts):
            self.noticed = self.done - 1
        self.changed.emit()

    def after(self, trajectory: int) -> None:
        """Go to when a trajectory has been cut, which is to be noticed."""
        self.go_to(float(self.clock.ends[trajectory + 1]), trajectory)

    def choose(self, seconds: float) -> None:
        """Go to the end of the trajectory that is being cut at a moment, which is to be noticed."""
        self.after(min(self.clock.step(seconds), len(self.clock.cuts) - 1))

    def step(self, by: int) -> None:
        """Step by a trajectory (1), a command (2) or an operation (3), back where negative."""
        starts = self.starts[abs(by)]
        if by > 0:
            at = np.searchsorted(starts, self.done, side="right")
            target = int(starts[min(at, len(starts) - 1)])
        else:
            target = int(starts[max(np.searchsorted(starts, self.done, side="left") - 1, 0)])
        if target:
            self.after(target - 1)
        else:
            self.go_to(0.0)

    @cached_property
    def starts(self) -> dict[int, np.ndarray]:
        """Moments, in trajectories, to which steps go: of trajectories, commands and operations."""
        cuts = self.clock.cuts
        commands = [first + np.flatnonzero(np.diff(cut.toolpath.command, prepend=-1))
                    for first, cut in zip(cuts.first, cuts.cuts)]  # fmt: skip
        count = len(cuts)
        return {1: np.arange(count + 1), 2: np.append(np.concatenate(commands), count), 3: cuts.first}

    def of_command(self, trajectory: int) -> tuple[int, int]:
        """Return the first trajectory of the command that a trajectory belongs to, and the one behind its last."""
        source = self.clock.cuts.source(trajectory)
        command = self.clock.cuts.cuts[source.cut].toolpath.command
        first = trajectory - source.trajectory
        same = np.flatnonzero(command == source.command)
        return int(first + same[0]), int(first + same[-1]) + 1

    def play(self) -> None:
        """Play from here, or from the beginning where it is over; pause a play."""
        if self.plays:
            self._played = None
        else:
            if self.seconds >= self.clock.total:
                self._set(0.0)
            self.noticed = None
            self._played = time.perf_counter()
        self.changed.emit()

    def go_on(self, speed: float) -> None:
        """Go on with a play, so many times as fast as the machine."""
        if self._played is None:
            return
        now = time.perf_counter()
        self._set(min(self.seconds + speed * (now - self._played), self.clock.total))
        self._played = now if self.seconds < self.clock.total else None
        self.changed.emit()

    def _set(self, seconds: float, trajectory: int | None = None) -> None:
        self.seconds = seconds
        self.done = self.clock.step(seconds) if trajectory is None else trajectory + 1

    def tool_tip(self) -> tuple[int, np.ndarray]:
        """Return which cut's tool is where: the cut's number, and its tip, (3,) mm."""
        if self.plays:
            return self.clock.tool_tip(self.seconds)
        source = self.clock.cuts.source(self.last)
        points = self.clock.cuts.cuts[source.cut].toolpath.points
        return source.cut, points[source.trajectory + (1 if self.done else 0)]
