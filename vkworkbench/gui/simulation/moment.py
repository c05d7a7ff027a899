# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machining time of a job, and the shown moment of the job, which the user chooses by clicks, steps or playback."""

from __future__ import annotations

import time
from functools import cached_property

import numpy as np

from vkworkbench.core.zbuffer import Cuts
from vkworkbench.document.simulation.job import SimulatedJob
from vkworkbench.gui.qt.names import QObject, Signal

# Assumed speed of all moves if no speed in the job is known, mm/s.
_USUAL_SPEED = 1000 / 60


class Clock:
    """The times at which the trajectories of a job begin and end.

    A move with an unknown speed gets the median of the known speeds.
    """

    def __init__(self, job: SimulatedJob) -> None:
        seconds = job.seconds.copy()
        self.cuts = Cuts(job.cuts)
        lengths = self.cuts.lengths
        unknown = np.isnan(seconds)
        if unknown.any():
            with np.errstate(divide="ignore", invalid="ignore"):
                speeds = (lengths / seconds)[~unknown]
            speed = float(np.median(speeds)) if len(speeds) else _USUAL_SPEED
            seconds[unknown] = lengths[unknown] / speed
        self.ends = np.append(0.0, np.cumsum(seconds))  # ends[k] is the time after k trajectories, s
        self.complete = not unknown.any()  # whether all speeds are known

    @property
    def total(self) -> float:
        """Time of the whole job, s."""
        return float(self.ends[-1])

    def rates(self, volumes: np.ndarray) -> np.ndarray:
        """Return the removal rate of each trajectory, (n,) mm^3/min, from its removed volume, mm^3.

        The rate is 0 for a trajectory that takes no time.
        """
        seconds = np.diff(self.ends)
        return 60 * volumes / np.where(seconds > 0, seconds, np.inf)

    def step(self, seconds: float) -> int:
        """Return how many trajectories are finished after `seconds` of machining."""
        return int(np.searchsorted(self.ends, seconds, side="right")) - 1

    def tool_tip(self, seconds: float) -> tuple[int, np.ndarray]:
        """Return the number of the operation that runs after `seconds` of machining, and its tool's tip, (3,) mm."""
        trajectory = min(self.step(seconds), len(self.ends) - 2)
        begin, end = self.ends[trajectory], self.ends[trajectory + 1]
        share = min(max((seconds - begin) / (end - begin), 0.0), 1.0) if end > begin else 1.0
        source = self.cuts.source(trajectory)
        start, end = self.cuts.cuts[source.cut].toolpath.points[source.trajectory : source.trajectory + 2]
        return source.cut, start + share * (end - start)


class Moment(QObject):
    """The shown moment in the machining time of a job."""

    changed = Signal()  # the moment has changed, or the playback has begun or ended

    def __init__(self, clock: Clock, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.clock = clock
        self.seconds, self.done = clock.total, len(clock.cuts)  # a new simulation shows the finished part
        # The trajectory to highlight: the trajectory that the user chose, or the last finished trajectory.
        self.noticed: int | None = None
        self._played: float | None = None  # computer's time of the last picture, s; None while the playback is paused

    @property
    def plays(self) -> bool:
        return self._played is not None

    @property
    def last(self) -> int:
        """The last finished trajectory; the first trajectory if none is finished."""
        return max(self.done - 1, 0)

    def go_to(self, seconds: float, trajectory: int | None = None) -> None:
        """Go to a machining time, s. If `trajectory` is given, go to the end of this trajectory and highlight it."""
        self._played = None
        self.noticed = trajectory
        self._set(seconds, trajectory)
        if trajectory is None and 0 < self.done < len(self.clock.cuts):
            self.noticed = self.done - 1
        self.changed.emit()

    def after(self, trajectory: int) -> None:
        """Go to the end of a trajectory and highlight it."""
        self.go_to(float(self.clock.ends[trajectory + 1]), trajectory)

    def choose(self, seconds: float) -> None:
        """Go to the end of the trajectory that the tool cuts after `seconds` of machining, and highlight it."""
        self.after(min(self.clock.step(seconds), len(self.clock.cuts) - 1))

    def step(self, by: int) -> None:
        """Step by a trajectory (1), a command (2) or an operation (3); backwards if negative."""
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
        """The moments to which each kind of step (1, 2, 3; see `step`) goes, as numbers of finished trajectories."""
        cuts = self.clock.cuts
        commands = [first + np.flatnonzero(np.diff(cut.toolpath.command, prepend=-1))
                    for first, cut in zip(cuts.first, cuts.cuts)]  # fmt: skip
        count = len(cuts)
        return {1: np.arange(count + 1), 2: np.append(np.concatenate(commands), count), 3: cuts.first}

    def of_command(self, trajectory: int) -> tuple[int, int]:
        """Return the first and the last + 1 of all trajectories that belong to the same command as `trajectory`."""
        source = self.clock.cuts.source(trajectory)
        command = self.clock.cuts.cuts[source.cut].toolpath.command
        first = trajectory - source.trajectory
        same = np.flatnonzero(command == source.command)
        return int(first + same[0]), int(first + same[-1]) + 1

    def play(self) -> None:
        """Pause the playback, or start it: from the shown moment, or at the end of the job from the beginning."""
        if self.plays:
            self._played = None
        else:
            if self.seconds >= self.clock.total:
                self._set(0.0)
            self.noticed = None
            self._played = time.perf_counter()
        self.changed.emit()

    def go_on(self, speed: float) -> None:
        """Advance the playback by the time since the last picture, at `speed` times the machine's speed."""
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
        """Return the number of the operation at the shown moment, and the tip of its tool, (3,) mm."""
        if self.plays:
            return self.clock.tool_tip(self.seconds)
        source = self.clock.cuts.source(self.last)
        points = self.clock.cuts.cuts[source.cut].toolpath.points
        return source.cut, points[source.trajectory + (1 if self.done else 0)]
