# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inverse problem (paper, sections 1 and 4): the finest image that a memory or time budget allows."""

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

# Passes are told apart if at least this many pixels or cells lie between them.
_CELLS_PER_STEPOVER = 4


@dataclass(frozen=True)
class Resolution:
    """An image chosen for a budget.

    Attributes
    ----------
    view : View or None
        The finest image within the budget; None where none is.
    memory_bytes, seconds : float
        What the simulation takes with it, at its peak, with pictures of it; without a view, with a single pixel.
    why : Message
        What limits it, or what helps where no resolution does.
    """

    view: View | None
    memory_bytes: float
    seconds: float
    why: Message

    @property
    def explanation(self) -> str:
        """The same as an English sentence without a full stop."""
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
    """Choose the finest image with which operations are simulated within a budget.

    Dexels and trace elements grow with the number of pixels, and so does the memory but for that of the trajectories and of
    the work. The time grows slower, see `Work.amounts`; that of the trajectories themselves does not, and no image shortens it.

    Parameters
    ----------
    estimates : sequence of Estimate
        Of the operations, all for the same view.
    memory_bytes, seconds : float, optional
        The budget; at least one is given: `memory_bytes` as `simulate` takes it. Several operations share one z-buffer
        and are simulated one after another.
    stepover : float, optional
        Smallest distance between passes, mm: says whether the image tells the passes apart.
    labels : sequence of str, optional
        What the operations are called: the heaviest is named where no image helps.
    whole : Estimate, optional
        What they take together; without it the sum of theirs, the stock counted once.

    Returns
    -------
    Resolution

    Raises
    ------
    ValueError
        Without an estimate, without a budget, or with one that is not a positive number.
    TypeError
        Where an argument is something else.
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
    for one in estimates if whole is None else (*estimates, whole):
        of_kind("an estimate", one, Estimate, "the Estimate that estimate makes")
    view, pixel = estimates[0].view, estimates[0].pixel
    each, estimates = estimates, estimates if whole is None else [whole]
    peak = _together(estimates)
    fixed = sum(e.trajectory_seconds for e in estimates)
    pixels = view.width * view.height

    # How many times as many pixels each budget allows.
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


def _together(estimates: Sequence[Estimate]) -> Peak:
    """What decides the memory of all of them in one z-buffer, the stock counted once."""
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
    """Say whether cells or pixels of a size tell passes apart; None where it is not known how far apart they are."""
    apart = 0.0 if stepover is None else number("stepover", stepover, "a distance of at least 0 mm", not_negative)
    if not apart:
        return None
    finest = apart / _CELLS_PER_STEPOVER
    if size > finest:
        return Message("passes-need", step=apart, cell=finest)
    return Message("passes-seen", step=apart, cell=finest)


def heaviest(labels: Sequence[str], seconds: Sequence[float]) -> Message | None:
    """Name the operation that takes the longest; None where there is no other."""
    if len(labels) < 2:
        return None
    worst = max(range(len(labels)), key=seconds.__getitem__)
    return Message("heaviest", label=labels[worst], time=seconds[worst])
