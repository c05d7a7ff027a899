# SPDX-License-Identifier: LGPL-2.1-or-later
"""The memory that a simulation takes at its peak, known before it starts, and its limit."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

from vkworkbench.core.stocks import Mesh, Solid, fitted
from vkworkbench.core.view import Frame, View, wider_pixel
from vkworkbench.core.zbuffer.memory.counts import Counts, count
from vkworkbench.core.zbuffer.memory.growth import growth_within, size_of
from vkworkbench.core.zbuffer.rays.records import PIXEL_BYTES, RECORD_BYTES, Records
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts
from vkworkbench.language import Message, Unusable

# What may be taken where nobody says otherwise, bytes.
BUDGET = 2e9
# Measured by benchmarks/zbuffer.py, other views as test_vk_zbuffer_memory.py does. Bytes of the work on one band of the
# image at a time: from above; obliquely, where rays pass all tools in closed form; and otherwise. Then of every
# trajectory as the simulation holds it, and of every record of a band while the band is put together.
_BAND_ABOVE, _BAND_CLOSED, _BAND = 14e6, 20e6, 42e6
# Views less steep than this cosine pass so many trajectories with each ray that the form does not matter.
_STEEP = 0.5
_TRAJECTORY = 460.0
_BAND_RECORD = 13.0
# Afterwards pictures at any moment are made: of every element of a trace, all of which may uncover what is seen then, of every
# pixel and trajectory, and of what is worked on at once; with numpy 2 most.
_SHOWN, _SHOWN_PIXEL, _SHOWN_TRAJECTORY, _SHOWING = 14.0, PIXEL_BYTES + 92.0, 100.0, 12e6
# A further process: itself, with Python and numpy; of every trajectory that it is told, and every record of a band, there and here.
_PROCESS = 50e6
_SENT_TRAJECTORY = 500.0
_SENT_RECORD = 26.0
# The records grow by an eighth when they are full.
_SPARE = 1 / 8
# Traces are estimated; so many standard errors are added.
_ERRORS = 2.0
# Of a budget: in another image other rays tell the records, 1.3 % more at most in 137 that were tried.
_SURE = 0.98


class OverBudget(Unusable):
    """A simulation would take more memory than it may; nothing was simulated.

    Attributes
    ----------
    what : Message
        For the user.
    needed, allowed : float
        Bytes.
    size : tuple of int or None
        Width and height of the finest image that may be simulated, pixels; None where none may.
    """

    def __init__(self, peak: Peak, allowed: float, counts: Counts, frame: Frame) -> None:
        self.needed, self.allowed = peak.bytes(), allowed
        growth = in_memory(peak, allowed)
        self.size = size_of(frame, growth) if growth else None
        instead = Message("fewer-operations")
        if self.size:
            width, height = self.size
            pixel = frame.pixel * wider_pixel(frame, width, height)
            instead = Message("image-fits", width=width, height=height, pixel=pixel)
        super().__init__(
            Message(
                "zbuffer-memory", memory=self.needed, allowed=allowed,
                traces=round(counts.traces), dexels=round(counts.dexels), instead=instead,
            )
        )  # fmt: skip


@dataclass(frozen=True)
class Peak:
    """What decides how much memory a simulation, and pictures of it, take at their peak.

    Attributes
    ----------
    records, traces : float
        Pieces of rays, and how many of them are removed, with their errors.
    stock : float
        Pieces of the rays of the uncut stock.
    band : float
        Records of the fullest band of the image.
    pixels : int
        Of the image.
    trajectories : int
        How many there are, those that miss the stock included.
    work : float
        What the work on one band takes, whatever its records, bytes.
    """

    records: float
    traces: float
    stock: float
    band: float
    pixels: int
    trajectories: int
    work: float

    def bytes(self, growth: float = 1.0) -> float:
        """Return that memory, bytes, in an image of `growth` times as many pixels."""
        shown = growth * (RECORD_BYTES * self.records + _SHOWN * self.traces + _SHOWN_PIXEL * self.pixels)
        shown += _SHOWN_TRAJECTORY * self.trajectories + _SHOWING
        return max(self.cutting(growth), shown)

    @property
    def uncut(self) -> Peak:
        """That of the stock where nothing cuts it."""
        return replace(self, records=self.stock, traces=0.0, band=0.0, trajectories=0)

    def cutting(self, growth: float = 1.0) -> float:
        """Return the part of it until all pieces are found."""
        held = RECORD_BYTES * self.records * (1 + _SPARE) + PIXEL_BYTES * self.pixels
        return growth * (held + _BAND_RECORD * self.band) + self.work + _TRAJECTORY * self.trajectories


def memory_needed(cuts: Iterable[Cut], *, stock: Solid, view: View) -> float:
    """Memory that `simulate_job`, and then a picture, takes at its peak for these arguments, bytes, from some hundred rays.

    Parameters
    ----------
    cuts : iterable of Cut
    stock : Solid
    view : View
    """
    numbered = Cuts(cuts)
    removal = Removal(numbered, stock, fitted(view, stock))
    return peak_bytes(count(removal), len(numbered), removal)


def check_memory(removal: Removal, trajectories: int, allowed: float) -> None:
    """Refuse a simulation that would take too much memory.

    Parameters
    ----------
    removal : Removal
        What would be simulated.
    trajectories : int
        How many there are, those that miss the stock included.
    allowed : float
        Bytes.

    Raises
    ------
    OverBudget
    """
    most = _most(removal)
    if _peak(most, most, 0.0, most, trajectories, removal).bytes() <= allowed:
        return  # whatever the rays say
    counts = count(removal)
    peak = peak_of(counts, trajectories, removal)
    if peak.bytes() > allowed:
        raise OverBudget(peak, allowed, counts, removal.frame)


def peak_bytes(counts: Counts, trajectories: int, removal: Removal) -> float:
    """Memory that a simulation and pictures of it take at their peak, beyond what the process took before it, bytes.

    The arguments are those of `peak_of`.
    """
    return peak_of(counts, trajectories, removal).bytes()


def peak_of(counts: Counts, trajectories: int, removal: Removal) -> Peak:
    """Return what decides the memory of a simulation and pictures of it.

    Parameters
    ----------
    counts : Counts
        Its records.
    trajectories : int
        How many there are, those that miss the stock included.
    removal : Removal
        What is simulated.
    """
    traces = counts.traces + _ERRORS * counts.traces_error
    records, stock = counts.records + _ERRORS * counts.traces_error, counts.stock + counts.gaps
    return _peak(records, traces, stock, counts.band, trajectories, removal)


def in_memory(peak: Peak, allowed: float) -> float:
    """Return how many times as many pixels surely take no more than that, bytes; 0 where not even a single one does."""
    return growth_within(peak.bytes, _SURE * allowed, 1 / peak.pixels)


def peak_that_was(records: Records, removal: Removal) -> Peak:
    """Return what decided the memory of a simulation that ended with these records, and of pictures of it."""
    traces = int(np.count_nonzero(records.cut))
    return _peak(len(records.far), traces, 0.0, 0.0, records.trajectories, removal)


def most_bytes_of(traces: float, pixels: int, trajectories: int) -> float:
    """Bound the memory of a simulation, and of pictures of it, that removes no more pieces than that, bytes."""
    records = traces + pixels
    return Peak(records, traces, 0.0, records, pixels, trajectories, _BAND).bytes()


def helpers_within(allowed: float, removal: Removal, trajectories: int) -> int:
    """How many further processes may cut bands of a simulation that takes no more memory than that, with them.

    Parameters
    ----------
    allowed : float
        Bytes.
    removal : Removal
        What is simulated.
    trajectories : int
        How many there are, those that miss the stock included.
    """
    counts = count(removal)
    each = _PROCESS + _band_work(removal) + _SENT_RECORD * counts.band + _SENT_TRAJECTORY * trajectories
    alone = peak_of(counts, trajectories, removal).cutting()
    return max(0, int((allowed - alone) // each))


def _most(removal: Removal) -> float:
    """No more records than this, from the trajectories' bounding boxes in the image; a mesh may have any number."""
    if isinstance(removal.stock, Mesh):
        return np.inf
    frame = removal.frame
    half = np.array([frame.width, frame.height]) / 2
    left, right, bottom, top = removal.box / frame.pixel
    across = np.minimum(right, half[0]) - np.maximum(left, -half[0]) + 1
    up = np.minimum(top, half[1]) - np.maximum(bottom, -half[1]) + 1
    passes = float((np.maximum(across, 0) * np.maximum(up, 0)).sum())
    # Within a ray an interval divides one piece into three at most.
    return (1 if removal.sine == 0 else 2) * passes + frame.width * frame.height


def _peak(records: float, traces: float, stock: float, band: float, trajectories: int, removal: Removal) -> Peak:
    pixels = removal.frame.width * removal.frame.height
    return Peak(records, traces, stock, band, pixels, trajectories, _band_work(removal))


def _band_work(removal: Removal) -> float:
    """Memory of the work on one band, whatever its records."""
    if removal.sine == 0 and removal.cosine > 0:
        return _BAND_ABOVE
    closed = all(t.rounding == t.radius or t.rounding == t.steepness == 0 for t in removal.tools)
    return _BAND_CLOSED if closed and abs(removal.cosine) > _STEEP else _BAND
