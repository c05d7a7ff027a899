# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an operation's simulation in the extended z-buffer takes, without simulating it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.recognition import Recognition
from vkworkbench.core.solids import Tool, View
from vkworkbench.core.stocks import Solid
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.zbuffer.counts import count
from vkworkbench.core.zbuffer.cuts import Cut, Cuts
from vkworkbench.core.zbuffer.removal import Removal

# Work on a pair of ray and trajectory for rounded tools, a flat end's or a cone's taken as 1: seen from above
# or below, and tilted. A bull-nose needs bisection.
_BALL_WORK = (1.15, 1.45)
_BULLNOSE_WORK = (1.5, 5.0)


@dataclass(frozen=True)
class Estimate:
    """What the simulation of one operation takes.

    Attributes
    ----------
    dexels : float
        Number of dexels at the end.
    traces : float
        Number of elements of the traces.
    traces_error : float
        One standard error of `traces`.
    memory_bytes : float
        Of the z-buffer's records and index.
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
        The part of `memory_bytes` that the uncut stock takes.
    trajectory_seconds : float
        The part of `seconds` that no smaller image saves.
    speed : Speed
        Of the computer that `seconds` holds for.
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
    speed: Speed

    @property
    def factor(self) -> float:
        """The true time is between the estimated one divided and multiplied by this."""
        return self.speed.factor


@dataclass(frozen=True)
class Speed:
    """What one unit of the simulator's work costs on one computer, s.

    The defaults are those of a Xeon core; ``speed.measure_speed`` measures this computer's.

    Attributes
    ----------
    trajectory : float
        One trajectory, whether it meets the stock or not.
    pixel : float
        One pixel of the image.
    candidate : float
        One pixel a flat end or a cone passes, looked at from above or below.
    tilted_candidate : float
        The same in any other direction.
    record : float
        One dexel or element of a trace.
    factor : float
        The true time is between the estimated one divided and multiplied by this.
    """

    trajectory: float = 1.5e-6
    pixel: float = 0.03e-6
    candidate: float = 0.003e-6
    tilted_candidate: float = 0.17e-6
    record: float = 0.18e-6
    factor: float = 3.0

    @property
    def constants(self) -> np.ndarray:
        """(5,) float64 ndarray : what the units of :func:`work` cost, in its order."""
        return np.array([self.trajectory, self.pixel, self.candidate, self.tilted_candidate, self.record])


def estimate(
    toolpath: Toolpath,
    recognition: Recognition | None,
    *,
    tool: Tool,
    stock: Solid,
    view: View,
    speed: Speed = Speed(),
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
    """
    frame = view.frame(stock)
    counts = count(Removal(Cuts([Cut(toolpath, tool)]), stock, frame))
    trajectory_seconds = speed.trajectory * len(toolpath)
    records = counts.dexels + counts.traces
    seconds = float(work(len(toolpath), records, counts.passes, tool, view) @ speed.constants)
    return Estimate(
        counts.dexels,
        counts.traces,
        counts.traces_error,
        counts.memory_bytes,
        seconds,
        _explain(recognition, counts.traces, counts.touched),
        view,
        frame.pixel,
        counts.passes,
        counts.stock_bytes,
        trajectory_seconds,
        speed,
    )


def work(trajectories: int, records: float, candidates: float, tool: Tool, view: View) -> np.ndarray:
    """How often each constant of `Speed` is due.

    Parameters
    ----------
    trajectories : int
    records : float
        Number of dexels and elements of traces.
    candidates : float
        Pairs of pixel and trajectory that passes it.
    tool : Tool
    view : View

    Returns
    -------
    (5,) float64
    """
    if tool.rounding == 0:
        untilted, tilted = 1.0, 1.0
    else:
        untilted, tilted = _BALL_WORK if tool.rounding == tool.radius else _BULLNOSE_WORK
    vertical = not any(view.direction[:2])
    return np.array(
        [
            trajectories,
            view.width * view.height,
            candidates * untilted * vertical,
            candidates * tilted * (not vertical),
            records,
        ]
    )


def _explain(recognition: Recognition | None, traces: float, touched: float) -> str:
    if touched == 0:
        return "no trajectory cuts the stock"
    words = "toolpath" if recognition is None else str(recognition.strategy)
    if recognition is not None and recognition.stepover is not None:
        words += f", stepover {recognition.stepover:.3g} mm"
    return f"{words}: each pixel is cut {traces / touched:.1f} times"
