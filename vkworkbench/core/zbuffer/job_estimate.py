# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the simulation of a whole job in one z-buffer takes, from one sample of its rays."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from vkworkbench.core.solids import View
from vkworkbench.core.stocks import Solid
from vkworkbench.core.zbuffer.counts import count
from vkworkbench.core.zbuffer.cuts import Cut, Cuts
from vkworkbench.core.zbuffer.estimate import Speed, work
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
    records = counts.dexels + counts.traces
    # The rays tell how much work there is; whose it is, the trajectories that can meet the stock.
    shares = np.bincount(numbered.cut[removal.index], minlength=len(cuts)) + 1e-9
    amounts = [work(len(numbered), records, counts.passes, cut.tool, view) for cut in cuts]
    seconds = float(np.average(amounts, axis=0, weights=shares) @ speed.constants)
    return JobEstimate(seconds, speed.factor, counts.memory_bytes)
