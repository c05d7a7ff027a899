# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an operation's simulation in the extended z-buffer takes, without simulating it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.closed_form import candidate_pixels
from vkworkbench.core.dexels import UNCUT
from vkworkbench.core.recognition import Recognition
from vkworkbench.core.removal import Removal
from vkworkbench.core.sampling import sample
from vkworkbench.core.silhouette import silhouette_area
from vkworkbench.core.solids import ConvexStock, Stock, Tool, View
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.zbuffer import DEXEL, INDEX, TRACE

# The same rays every time: a click and a macro give the same numbers.
_SEED = 2002


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
    stock_bytes : float
        The part of `memory_bytes` that the uncut stock takes.
    trajectory_seconds : float
        The part of `seconds` that no smaller image saves.
    """

    dexels: float
    traces: float
    traces_error: float
    memory_bytes: float
    seconds: float
    explanation: str
    view: View
    pixel: float
    stock_bytes: float
    trajectory_seconds: float


@dataclass(frozen=True)
class Speed:
    """What one unit of the simulator's work costs on one computer, s.

    The defaults are those of a Xeon core, fitted as benchmarks/resources.py fits them.

    Attributes
    ----------
    trajectory : float
        One trajectory, whether it meets the stock or not.
    pixel : float
        One pixel of the image.
    candidate : float
        One pixel a trajectory passes, looked at from above or below.
    tilted_candidate : float
        The same in any other direction.
    record : float
        One dexel or element of a trace.
    """

    trajectory: float = 10e-6
    pixel: float = 0.55e-6
    candidate: float = 0.35e-6
    tilted_candidate: float = 1.1e-6
    record: float = 0.5e-6


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
    pieces = removal.cut(rays.x, rays.y)
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
    pixels = frame.width * frame.height
    stock_bytes = DEXEL.itemsize * covered * per_area + INDEX.itemsize * (pixels + 1)
    memory = stock_bytes + DEXEL.itemsize * more * per_area + TRACE.itemsize * traces
    candidates = candidate_pixels(toolpath, tool=tool, stock=stock, view=view)
    per_candidate = speed.candidate if removal.sine == 0 else speed.tilted_candidate
    trajectory_seconds = speed.trajectory * len(toolpath)
    seconds = (
        trajectory_seconds
        + speed.pixel * pixels
        + per_candidate * candidates
        + speed.record * (dexels + traces)
    )
    return Estimate(
        dexels,
        traces,
        error,
        memory,
        seconds,
        _explain(recognition, traces, touched * per_area),
        view,
        frame.pixel,
        stock_bytes,
        trajectory_seconds,
    )


def _explain(recognition: Recognition | None, traces: float, touched: float) -> str:
    if touched == 0:
        return "no trajectory cuts the stock"
    words = "toolpath" if recognition is None else str(recognition.strategy)
    if recognition is not None and recognition.stepover is not None:
        words += f", stepover {recognition.stepover:.3g} mm"
    return f"{words}: each pixel is cut {traces / touched:.1f} times"
