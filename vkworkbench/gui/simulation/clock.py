# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine's time of a job: which trajectory is cut when."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.zbuffer import Cuts
from vkworkbench.document.simulation.job import SimulatedJob

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
    cuts : Cuts
        The job's, their trajectories numbered through.
    ends : (n + 1,) float64
        When that many trajectories have been cut, s; the first is 0.
    complete : bool
        Whether all speeds are known.
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
        self.ends = np.append(0.0, np.cumsum(seconds))
        self.complete = not unknown.any()

    @property
    def total(self) -> float:
        """Time of the whole job, s."""
        return float(self.ends[-1])

    def rates(self, volumes: np.ndarray) -> np.ndarray:
        """Return how fast each trajectory removes its volume, (n,) mm^3, in mm^3/min; 0 where it takes no time."""
        seconds = np.diff(self.ends)
        rates: np.ndarray = 60 * volumes / np.where(seconds > 0, seconds, np.inf)
        return rates

    def step(self, seconds: float) -> int:
        """Return how many trajectories have been cut by then."""
        return int(np.searchsorted(self.ends, seconds, side="right")) - 1

    def tool_tip(self, seconds: float) -> tuple[int, np.ndarray]:
        """Return which cut's tool is where at a moment: the cut's number, and its tip, (3,) mm."""
        trajectory = min(self.step(seconds), len(self.ends) - 2)
        begin, end = self.ends[trajectory], self.ends[trajectory + 1]
        share = min(max((seconds - begin) / (end - begin), 0.0), 1.0) if end > begin else 1.0
        source = self.cuts.source(trajectory)
        start, end = self.cuts.cuts[source.cut].toolpath.points[source.trajectory : source.trajectory + 2]
        return source.cut, start + share * (end - start)
