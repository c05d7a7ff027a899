# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the image with the smallest pixels that a memory or time budget allows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

from vkworkbench.core.view import View, wider_pixel
from vkworkbench.core.zbuffer.cost.estimate import Estimate
from vkworkbench.core.zbuffer.memory.growth import growth_within, size_of
from vkworkbench.core.zbuffer.memory.memory import Peak, in_memory
from vkworkbench.given import not_negative, number, of_kind, positive
from vkworkbench.language import Message, render

# Smallest distance between neighbouring passes, as a number of pixels or cells, at which an image shows the passes
# separately.
_CELLS_PER_STEPOVER = 4


@dataclass(frozen=True)
class Resolution:
    """An image chosen for a budget.

    Attributes
    ----------
    view : View or None
        The image with the smallest pixels within the budget; None if even an image with one pixel exceeds the budget.
    memory_bytes, seconds : float
        Peak memory, bytes, and time, s, of the simulation with this image; if `view` is None, with an image of one
        pixel.
    why : Message
        Message that names the budget that limits the resolution, or advice if no image is within the budget.
    """

    view: View | None
    memory_bytes: float
    seconds: float
    why: Message

    @property
    def explanation(self) -> str:
        """The message `why` as an English sentence without a full stop."""
        return render(self.why)


def best_resolution(
    estimates: Sequence[Estimate],
    *,
    memory_bytes: float | None = None,
    seconds: float | None = None,
    stepover: float | None = None,
    labels: Sequence[str] = (),
    whole: Estimate | None = None,
) -> Resolution:
    """Choose the image with the smallest pixels for which a simulation stays within a budget.

    The number of dexels and trace elements, and the memory for them, is proportional to the number of pixels. The
    memory for trajectories and temporary arrays does not depend on the number of pixels. The time has a constant part
    and grows more slowly than the number of pixels; see `Work.amounts`.

    Parameters
    ----------
    estimates : sequence of Estimate
        Estimate of each operation. All estimates are for the same view.
    memory_bytes, seconds : float, optional
        Memory budget, bytes, and time budget, s. At least one budget is required. Several operations share one z-buffer
        and are simulated one after the other.
    stepover : float, optional
        Smallest distance between passes, mm. `Resolution.why` compares the stepover with the pixel.
    labels : sequence of str, optional
        Names of the operations. If no image is within the time budget, `Resolution.why` names the operation that takes
        longest.
    whole : Estimate, optional
        Estimate of all operations in one z-buffer. The default is the sum of `estimates`, with the stock counted once.

    Raises
    ------
    ValueError
        If there is no estimate or no budget, or the budget is not positive.
    TypeError
        If an argument has a wrong type.
    """
    if memory_bytes is None and seconds is None:
        raise ValueError("a budget is a positive number: give memory_bytes, seconds, or both")
    if memory_bytes is not None:
        memory_bytes = number("memory_bytes", memory_bytes, "a positive number of bytes", positive)
    if seconds is not None:
        seconds = number("seconds", seconds, "a positive number of s", positive)
    of_kind("estimates", estimates, Sequence, "several Estimate")
    if not estimates:
        raise ValueError("there is no operation to choose an image for")
    for estimate in estimates if whole is None else (*estimates, whole):
        of_kind("an estimate", estimate, Estimate, "the Estimate that estimate makes")
    view, pixel = estimates[0].view, estimates[0].pixel
    each, estimates = estimates, estimates if whole is None else [whole]
    peak = _peak_together(estimates)
    fixed = sum(e.trajectory_seconds for e in estimates)
    pixels = view.width * view.height

    # For each budget, the largest factor by which the number of pixels can grow.
    limits = {}
    if memory_bytes is not None:
        limits["memory"] = in_memory(peak, memory_bytes)
    if seconds is not None:
        limits["time"] = growth_within(partial(_seconds, estimates), seconds, 1 / pixels)
    limit = min(limits, key=limits.__getitem__)
    growth = limits[limit]
    if growth * pixels < 1:
        why = Message("no-image")
        if limit == "time":
            named = heaviest(labels, [e.seconds for e in each])
            why = Message("no-image-in-time", time=fixed, heaviest=named)
        return Resolution(None, peak.bytes(1 / pixels), _seconds(estimates, 1 / pixels), why)
    width, height = size_of(view, growth)
    pixel *= wider_pixel(view, width, height)
    growth = width * height / pixels
    why = Message(
        "image", width=width, height=height, pixel=pixel,
        limit=Message("limit-memory") if limit == "memory" else Message("limit-time"),
        passes=passes_apart(pixel, stepover),
    )  # fmt: skip
    return Resolution(view.of_size(width, height), peak.bytes(growth), _seconds(estimates, growth), why)


def _seconds(estimates: Sequence[Estimate], growth: float) -> float:
    return sum(e.seconds_in(growth) for e in estimates)


def _peak_together(estimates: Sequence[Estimate]) -> Peak:
    """Return the quantities that determine the peak memory of all operations in one z-buffer.

    The stock is counted only once for all operations.
    """
    peaks = [e.peak for e in estimates]
    stocks = [p.stock for p in peaks]
    return Peak(
        records=sum(p.records for p in peaks) - (sum(stocks) - max(stocks)),
        traces=sum(p.traces for p in peaks),
        stock=max(stocks),
        band=sum(p.band for p in peaks),
        pixels=peaks[0].pixels,
        trajectories=sum(p.trajectories for p in peaks),
        work=max(p.work for p in peaks),
    )


def passes_apart(size: float, stepover: float | None) -> Message | None:
    """Return a message that says whether pixels or cells with the side `size`, mm, show neighbouring passes separately.

    The result is None if the stepover is unknown.
    """
    distance = 0.0 if stepover is None else number("stepover", stepover, "a distance of at least 0 mm", not_negative)
    if not distance:
        return None
    finest = distance / _CELLS_PER_STEPOVER
    if size > finest:
        return Message("passes-need", step=distance, cell=finest)
    return Message("passes-seen", step=distance, cell=finest)


def heaviest(labels: Sequence[str], seconds: Sequence[float]) -> Message | None:
    """Return a message that names the operation that takes longest; None if there is only one operation."""
    if len(labels) < 2:
        return None
    worst = max(range(len(labels)), key=seconds.__getitem__)
    return Message("heaviest", label=labels[worst], time=seconds[worst])
