# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the simulation of a whole job in one z-buffer takes, from one sample of its rays."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from vkworkbench.core.solids import View
from vkworkbench.core.stocks import Solid
from vkworkbench.core.zbuffer.counts import count
from vkworkbench.core.zbuffer.cuts import Cut, Cuts
from vkworkbench.core.zbuffer.effort import work_of
from vkworkbench.core.zbuffer.estimate import Speed
from vkworkbench.core.zbuffer.removal import Removal


@dataclass(frozen=True)
class JobEstimate:
    """What a job's simulation takes.

    Attributes
    ----------
    seconds : float
        Time of the whole simulation.
    factor : float
        The true time is between this one divided and multiplied by it.
    memory_bytes : float
        Of the z-buffer's records and index.
    """

    seconds: float
    factor: float
    memory_bytes: float


def estimate_job(cuts: Sequence[Cut], *, stock: Solid, view: View, speed: Speed) -> JobEstimate:
    """Estimate what `simulate_job` takes, from some hundred rays cut by the whole job.

    Parameters
    ----------
    cuts : sequence of Cut
    stock : Solid
    view : View
    speed : Speed
        Of this computer.
    """
    numbered = Cuts(cuts)
    removal = Removal(numbered, stock, view.frame(stock))
    counts = count(removal)
    seconds = speed.seconds(work_of(removal, len(numbered), counts.dexels + counts.traces))
    return JobEstimate(seconds, speed.factor, counts.memory_bytes)
