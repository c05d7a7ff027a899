# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an operation's simulation in the extended z-buffer takes, without simulating it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.recognition import Recognition
from vkworkbench.core.solids import ConvexStock, Stock, Tool, View
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.zbuffer.dexels import UNCUT
from vkworkbench.core.zbuffer.removal import Removal
from vkworkbench.core.zbuffer.sampling import sample
from vkworkbench.core.zbuffer.silhouette import silhouette_area
from vkworkbench.core.zbuffer.simulate import DEXEL, INDEX, TRACE

# The same rays every time: a click and a macro give the same numbers.
_SEED = 2002
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
        Pairs of pixel and trajectory that the simulator examines, whether or not anything is left to cut.
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

    trajectory: float = 17e-6
    pixel: float = 0.46e-6
    candidate: float = 0.20e-6
    tilted_candidate: float = 0.67e-6
    record: float = 0.22e-6
    factor: float = 2.0

    @property
    def constants(self) -> np.ndarray:
        """(5,) float64 ndarray : what the units of :func:`work` cost, in its order."""
        return np.array([self.trajectory, self.pixel, self.candidate, self.tilted_candidate, self.record])


def estimate(
    toolpath: Toolpath,
    recognition: Recognition | None,
    *,
    tool: Tool,
    stock: Stock | ConvexStock,
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
    stock : Stock or ConvexStock
    view : View
    speed : Speed
        Of this computer.

    Returns
    -------
    Estimate
        The same for the same arguments.
    """
    frame = view.frame(stock)
    removal = Removal(toolpath, tool, stock, frame)
    rays = sample(removal, np.random.default_rng(_SEED))
    pieces, passes = removal.cut(rays.x, rays.y)
    cut = pieces.owner != UNCUT
    cuts = np.bincount(pieces.ray[cut], minlength=len(rays.x))
    parts = np.bincount(pieces.ray[~cut], minlength=len(rays.x))
    per_area = 1 / frame.pixel**2

    covered = silhouette_area(stock, frame)
    # Where a ray was cut through or through a wall: fewer or more dexels than the one it began with.
    more, _ = rays.total(parts - (cuts + parts > 0))
    more = max(more, -covered)  # where everything is cut away, rounding leaves less than nothing
    traces, error = rays.total(cuts)
    touched, _ = rays.total(cuts > 0)
    dexels, traces, error = (covered + more) * per_area, traces * per_area, error * per_area
    index_bytes = INDEX.itemsize * (frame.width * frame.height + 1)
    stock_bytes = DEXEL.itemsize * covered * per_area + index_bytes
    memory = stock_bytes + DEXEL.itemsize * more * per_area + TRACE.itemsize * traces
    candidates = rays.total(passes)[0] * per_area
    trajectory_seconds = speed.trajectory * len(toolpath)
    seconds = float(work(len(toolpath), dexels + traces, candidates, tool, view) @ speed.constants)
    return Estimate(
        dexels,
        traces,
        error,
        memory,
        seconds,
        _explain(recognition, traces, touched * per_area),
        view,
        frame.pixel,
        candidates,
        stock_bytes,
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
        Pairs of pixel and trajectory examined.
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
