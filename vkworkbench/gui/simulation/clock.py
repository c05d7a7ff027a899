# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine's time of a job: which trajectory is cut when."""

from __future__ import annotations

import numpy as np

from vkworkbench.core import Toolpath
from vkworkbench.document.simulation import SimulatedJob

# Where no speed at all is known, mm/s: something has to move.
_USUAL_SPEED = 1000 / 60


class Clock:
    """When each trajectory of a job begins and ends.

    A move whose speed nobody told takes as long as one of its length at the middle of the known speeds.

    Parameters
    ----------
    job : SimulatedJob

    Attributes
    ----------
    ends : (n + 1,) float64
        When that many trajectories have been cut, s; the first is 0.
    complete : bool
        Whether all speeds are known.
    """

    def __init__(self, job: SimulatedJob) -> None:
        seconds = job.seconds.copy()
        lengths = np.concatenate([cut.toolpath.lengths for cut in job.cuts])
        unknown = np.isnan(seconds)
        if unknown.any():
            with np.errstate(divide="ignore", invalid="ignore"):
                speeds = (lengths / seconds)[~unknown]
            speed = float(np.median(speeds)) if len(speeds) else _USUAL_SPEED
            seconds[unknown] = lengths[unknown] / speed
        self.ends = np.append(0.0, np.cumsum(seconds))
        self.complete = not unknown.any()
        self._positions = [(cut.toolpath, first) for cut, first in zip(job.cuts, _firsts(job))]

    @property
    def total(self) -> float:
        """Time of the whole job, s."""
        return float(self.ends[-1])

    def step(self, seconds: float) -> int:
        """Return how many trajectories have been cut by then."""
        return int(np.searchsorted(self.ends, seconds, side="right")) - 1

    def tool_tip(self, seconds: float) -> tuple[int, np.ndarray]:
        """Return which cut's tool is where at a moment: the cut's number, and its tip, (3,) mm."""
        trajectory = min(self.step(seconds), len(self.ends) - 2)
        begin, end = self.ends[trajectory], self.ends[trajectory + 1]
        share = min(max((seconds - begin) / (end - begin), 0.0), 1.0) if end > begin else 1.0
        for number, (toolpath, first) in reversed(list(enumerate(self._positions))):
            if trajectory >= first:
                return number, _between(toolpath, trajectory - first, share)
        raise IndexError(trajectory)


def _firsts(job: SimulatedJob) -> np.ndarray:
    """Number of each cut's first trajectory."""
    return np.append(0, np.cumsum([len(cut.toolpath) for cut in job.cuts])[:-1])


def _between(toolpath: Toolpath, trajectory: int, share: float) -> np.ndarray:
    start, end = toolpath.points[trajectory : trajectory + 2]
    return start + share * (end - start)
