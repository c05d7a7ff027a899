# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimate a simulation's number of dexels, trace elements and gaps, its memory and its time without running it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from vkworkbench.core.recognition import Recognition
from vkworkbench.core.stocks import Solid, fitted
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.view import View
from vkworkbench.core.zbuffer.cost.effort import Work, work_of
from vkworkbench.core.zbuffer.cost.speed import USUAL, Speed
from vkworkbench.core.zbuffer.memory.counts import count
from vkworkbench.core.zbuffer.memory.memory import Peak, peak_of
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts
from vkworkbench.given import of_kind


@dataclass(frozen=True)
class Estimate:
    """Estimated cost of simulating one operation, or several operations in one z-buffer.

    Attributes
    ----------
    dexels : float
        Number of dexels at the end of the simulation.
    traces : float
        Number of trace elements: segments of rays that trajectories remove.
    traces_error : float
        Standard error of `traces`.
    memory_bytes : float
        Peak memory of the simulation, pictures included. `simulate` refuses a simulation whose peak exceeds the memory
        budget.
    seconds : float
        Time of the whole simulation, s.
    explanation : str
        The reason for the cost, in English, as one phrase without a full stop.
    view : View
        The view whose image is simulated.
    pixel : float
        Side of the pixels, mm.
    candidates : float
        Number of pairs of a pixel and a trajectory whose swept volume the pixel's ray meets, including trajectories
        that remove nothing from the ray.
    stock_bytes : float
        Peak memory of a simulation of the uncut stock without any trajectory, bytes.
    trajectory_seconds : float
        Part of `seconds` that depends only on the number of trajectories, s.
    work : Work
        How often each step of the simulation is executed.
    speed : Speed
        Speed of the computer for which `seconds` is estimated.
    peak : Peak
        The quantities from which `memory_bytes` is computed, for this image size and for other sizes.
    cuts : tuple of Cut
        The estimated operations, which are needed for an estimate together with other operations. `cuts` is empty after
        pickling.
    stock : Solid or None
        The uncut stock. `stock` is None after pickling.
    """

    dexels: float
    traces: float
    traces_error: float
    memory_bytes: float
    seconds: float
    explanation: str
    view: View
    pixel: float
    candidates: float
    stock_bytes: float
    trajectory_seconds: float
    work: Work
    speed: Speed
    peak: Peak
    cuts: tuple[Cut, ...] = field(default=(), compare=False, repr=False)
    stock: Solid | None = field(default=None, compare=False, repr=False)

    def __getstate__(self) -> dict[str, Any]:
        return {**vars(self), "cuts": (), "stock": None}

    def seconds_in(self, growth: float) -> float:
        """Return the time for an image with `growth` times as many pixels, s."""
        return self.speed.seconds(self.work, growth)

    @property
    def factor(self) -> float:
        """Uncertainty of `seconds`: the actual time is probably from ``seconds / factor`` to ``seconds * factor``."""
        return self.speed.factor


def estimate(
    toolpath: Toolpath, recognition: Recognition | None, *, tool: Tool, stock: Solid, view: View, speed: Speed = USUAL
) -> Estimate:
    """Estimate the cost of simulating an operation from a few hundred rays that are simulated exactly.

    The order of the trajectories determines how often a pixel is cut (paper, section 2.1). Therefore the sampled rays
    are cut in the order of the NC program. The recognised strategy does not change the cost, only its explanation.

    Parameters
    ----------
    recognition : Recognition or None
        The recognised strategy, which the result's explanation names.
    speed : Speed
        Speed of this computer; see `measure_speed`.

    Returns
    -------
    Estimate
        Equal arguments give equal estimates.

    Raises
    ------
    TypeError
        If an argument has a wrong type.
    """
    of_kind("recognition", recognition, (Recognition, type(None)), "what recognize found, or None")
    words = "toolpath" if recognition is None else str(recognition.strategy)
    if recognition is not None and recognition.stepover is not None:
        words += f", stepover {recognition.stepover:.3g} mm"
    return _estimated(Cuts([Cut(toolpath, tool)]), stock, view, speed, words)


def estimate_job(cuts: Sequence[Cut], *, stock: Solid, view: View, speed: Speed = USUAL) -> Estimate:
    """Estimate the cost of `simulate_job` from a few hundred sampled rays that are cut by all operations of the job.

    Each operation cuts the stock that the earlier operations left.

    Parameters
    ----------
    cuts : sequence of Cut
        The operations in machining order.
    speed : Speed
        Speed of this computer; see `measure_speed`.

    Returns
    -------
    Estimate
        Equal arguments give equal estimates.
    """
    return _estimated(Cuts(cuts), stock, view, speed, "job")


def _estimated(numbered: Cuts, stock: Solid, view: View, speed: Speed, words: str) -> Estimate:
    of_kind("speed", speed, Speed, "the Speed that measure_speed finds")
    frame = fitted(view, stock)
    removal = Removal(numbered, stock, frame)
    counts = count(removal)
    work, peak = work_of(removal, len(numbered), counts), peak_of(counts, len(numbered), removal)
    return Estimate(
        counts.dexels,
        counts.traces,
        counts.traces_error,
        peak.bytes(),
        speed.seconds(work),
        _explain(words, counts.traces, counts.touched),
        view,
        frame.pixel,
        counts.passes,
        peak.uncut.bytes(),
        speed.trajectory * len(numbered),
        work,
        speed,
        peak,
        numbered.cuts,
        stock,
    )


def _explain(words: str, traces: float, touched: float) -> str:
    if touched == 0:
        return "no trajectory cuts the stock"
    return f"{words}: each pixel is cut {traces / touched:.1f} times"
