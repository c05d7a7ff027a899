# SPDX-License-Identifier: LGPL-2.1-or-later
"""What simulating an operation, or a job of several, in the extended z-buffer takes, without simulating it."""

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
    """What the simulation of one operation takes, or of several one after another in one z-buffer.

    Attributes
    ----------
    dexels : float
        Number of dexels at the end.
    traces : float
        Number of elements of the traces.
    traces_error : float
        One standard error of `traces`.
    memory_bytes : float
        At the simulation's peak, with pictures of it: where that is more than is allowed, it is refused.
    seconds : float
        Time of the whole simulation.
    explanation : str
        Why, in one sentence without a full stop.
    view : View
        The image.
    pixel : float
        Side of its pixels, mm.
    candidates : float
        Pairs of pixel and trajectory that passes it, whether or not anything is left to cut.
    stock_bytes : float
        The same of the uncut stock alone.
    trajectory_seconds : float
        The part of `seconds` that no smaller image saves.
    work : Work
        Of the whole simulation.
    speed : Speed
        Of the computer that `seconds` holds for.
    peak : Peak
        What decides that memory, in this image and in others.
    cuts : tuple of Cut
        What was estimated, so that it can be estimated together with others; it is not sent to another process.
    stock : Solid or None
        The uncut stock, likewise.
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
        """Return the time in an image of `growth` times as many pixels, s."""
        return self.speed.seconds(self.work, growth)

    @property
    def factor(self) -> float:
        """The true time is between the estimated one divided and multiplied by this."""
        return self.speed.factor


def estimate(
    toolpath: Toolpath,
    recognition: Recognition | None,
    *,
    tool: Tool,
    stock: Solid,
    view: View,
    speed: Speed = USUAL,
) -> Estimate:
    """Estimate what simulating an operation takes, from some hundred rays simulated exactly.

    The sequence of the trajectories decides how often a pixel is cut (paper, section 2.1); the rays see that
    sequence, the strategy explains it.

    Parameters
    ----------
    toolpath : Toolpath
    recognition : Recognition or None
        For the words of the explanation.
    tool : Tool
    stock : Solid
    view : View
    speed : Speed
        Of this computer.

    Returns
    -------
    Estimate
        The same for the same arguments.

    Raises
    ------
    TypeError
        Where an argument is something else.
    """
    of_kind("recognition", recognition, (Recognition, type(None)), "what recognize found, or None")
    words = "toolpath" if recognition is None else str(recognition.strategy)
    if recognition is not None and recognition.stepover is not None:
        words += f", stepover {recognition.stepover:.3g} mm"
    return _estimated(Cuts([Cut(toolpath, tool)]), stock, view, speed, words)


def estimate_job(cuts: Sequence[Cut], *, stock: Solid, view: View, speed: Speed = USUAL) -> Estimate:
    """Estimate what `simulate_job` takes, from some hundred rays cut by the whole job.

    What an operation takes is what it takes on the stock that those before it left.

    Parameters
    ----------
    cuts : sequence of Cut
        The operations in their order.
    stock : Solid
    view : View
    speed : Speed
        Of this computer.

    Returns
    -------
    Estimate
        The same for the same arguments.
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
