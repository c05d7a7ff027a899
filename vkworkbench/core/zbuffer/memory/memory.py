# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimate the peak memory of a simulation before it starts, and refuse simulations that exceed the memory limit."""

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

# Default memory budget, bytes.
BUDGET = 2e9
# Memory for the temporary arrays of one band (`TILE` rows of pixels) of the image, bytes. _BAND_ABOVE: memory for a
# band in a view from above. _BAND_CLOSED: memory for a band in an oblique view if the swept volumes of all tools are
# computed by closed forms. _BAND: memory for a band in all other cases. benchmarks/zbuffer.py measures the memory in
# views from above, test_vk_zbuffer_memory.py in other views.
_BAND_ABOVE, _BAND_CLOSED, _BAND = 14e6, 20e6, 42e6
# `_BAND_CLOSED` is used only if the cosine of the angle between the view and the vertical is at least this value. In
# views with a smaller cosine, which are more from the side, each ray meets so many trajectories that closed forms save
# no memory.
_STEEP = 0.5
# Memory for each trajectory (_TRAJECTORY), and for each record (segment of a ray) while the records of its band are
# assembled (_BAND_RECORD), bytes.
_TRAJECTORY = 460.0
_BAND_RECORD = 13.0
# Memory for drawing pictures of the finished simulation, bytes: for each trace element (_SHOWN), for each pixel
# (_SHOWN_PIXEL), for each trajectory (_SHOWN_TRAJECTORY), and for temporary arrays (_SHOWING, the largest value among
# the numpy versions).
_SHOWN, _SHOWN_PIXEL, _SHOWN_TRAJECTORY, _SHOWING = 14.0, PIXEL_BYTES + 92.0, 100.0, 12e6
# Memory for each additional process, bytes: for Python and numpy (_PROCESS), for each trajectory that is sent to the
# process (_SENT_TRAJECTORY), and for each record of a band, which both processes store (_SENT_RECORD).
_PROCESS = 45e6
_MOST_HELPERS = 10**9  # more processes than any computer runs; an infinite limit allows as many
_SENT_TRAJECTORY = 500.0
_SENT_RECORD = 26.0
# A full array of dexels, trace elements and gaps is enlarged by this share of the array's length.
_SPARE = 1 / 8
# The estimated number of trace elements is increased by this multiple of its standard error to get an upper bound.
_ERRORS = 2.0
# Share of the memory budget that a proposed image size uses. The rest of the budget is a margin, because an estimate
# for the proposed size samples other rays and gives a slightly different result.
_SURE = 0.98


class OverBudget(Unusable):
    """Error that is raised instead of starting a simulation that would need more memory than allowed.

    Attributes
    ----------
    what : Message
        Message that the user reads.
    needed, allowed : float
        Estimated peak memory of the simulation, and the memory limit, bytes.
    size : tuple of int or None
        Width and height, pixels, of the largest image within the limit; None if even an image with one pixel exceeds
        the limit.
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
    """The quantities that determine the peak memory of a simulation and of its pictures.

    Attributes
    ----------
    records, traces : float
        Upper bound of the number of all segments of rays, and upper bound of the number of removed segments.
    stock : float
        Number of segments on all rays through the uncut stock.
    band : float
        Number of dexels, trace elements and gaps in the fullest band (`TILE` rows of pixels) of the image.
    pixels : int
        Number of pixels of the image.
    trajectories : int
        Number of trajectories, including trajectories that miss the stock.
    work : float
        Memory for the temporary arrays of one band (`TILE` rows of pixels), bytes.
    """

    records: float
    traces: float
    stock: float
    band: float
    pixels: int
    trajectories: int
    work: float

    def bytes(self, growth: float = 1.0) -> float:
        """Return the peak memory of cutting and pictures for an image with `growth` times as many pixels, bytes."""
        shown = growth * (RECORD_BYTES * self.records + _SHOWN * self.traces + _SHOWN_PIXEL * self.pixels)
        shown += _SHOWN_TRAJECTORY * self.trajectories + _SHOWING
        return max(self.cutting(growth), shown)

    @property
    def uncut(self) -> Peak:
        """The quantities that determine the peak memory if the uncut stock is simulated without any trajectory."""
        return replace(self, records=self.stock, traces=0.0, band=0.0, trajectories=0)

    def cutting(self, growth: float = 1.0) -> float:
        """Return the peak memory of cutting without pictures, for `growth` times as many pixels, bytes."""
        held = RECORD_BYTES * self.records * (1 + _SPARE) + PIXEL_BYTES * self.pixels
        return growth * (held + _BAND_RECORD * self.band) + self.work + _TRAJECTORY * self.trajectories


def memory_needed(cuts: Iterable[Cut], *, stock: Solid, view: View) -> float:
    """Estimate the peak memory of `simulate_job` and of one picture of its result, from a few hundred sampled rays.

    Parameters
    ----------
    cuts : iterable of Cut
        The operations in machining order.

    Returns
    -------
    float
        Peak memory, bytes.

    Raises
    ------
    TypeError
        If an item of `cuts` is not a Cut.
    """
    numbered = Cuts(cuts)
    removal = Removal(numbered, stock, fitted(view, stock))
    return peak_of(count(removal), len(numbered), removal).bytes()


def check_memory(removal: Removal, trajectories: int, allowed: float) -> None:
    """Raise an error if a simulation would need more memory than allowed.

    Parameters
    ----------
    removal : Removal
        The prepared trajectories of the simulation.
    trajectories : int
        Number of trajectories, including trajectories that miss the stock.
    allowed : float
        Memory limit: largest allowed peak memory, bytes.

    Raises
    ------
    OverBudget
        If the estimated peak is larger than allowed.
    """
    if most_bytes_of(removal, trajectories) <= allowed:
        return  # even the upper bound of the memory is within the limit, so no rays are sampled
    counts = count(removal)
    peak = peak_of(counts, trajectories, removal)
    if peak.bytes() > allowed:
        raise OverBudget(peak, allowed, counts, removal.frame)


def peak_of(counts: Counts, trajectories: int, removal: Removal) -> Peak:
    """Return the quantities that determine the peak memory of a simulation.

    Parameters
    ----------
    counts : Counts
        Estimated numbers of records in the simulation.
    trajectories : int
        Number of trajectories, including trajectories that miss the stock.
    removal : Removal
        The prepared trajectories of the simulation.
    """
    traces = counts.traces + _ERRORS * counts.traces_error
    records, stock = counts.records + _ERRORS * counts.traces_error, counts.stock + counts.gaps
    return _peak(records, traces, stock, counts.band, trajectories, removal)


def in_memory(peak: Peak, allowed: float) -> float:
    """Return the largest factor for the number of pixels (growth) that stays within a memory limit.

    `allowed` is the limit, bytes. The result is 0 if even an image with one pixel exceeds the limit.
    """
    return growth_within(peak.bytes, _SURE * allowed, 1 / peak.pixels)


def peak_that_was(records: Records, removal: Removal) -> Peak:
    """Return the quantities that determined the peak memory of a finished simulation, computed from its records."""
    traces = int(np.count_nonzero(records.cut))
    return _peak(len(records.far), traces, 0.0, 0.0, records.trajectories, removal)


def most_bytes_of(removal: Removal, trajectories: int) -> float:
    """Return an upper bound of a simulation's peak memory, bytes; infinite if the stock is a mesh.

    The bound is computed without sampling rays.
    """
    most = _most_records(removal)
    return _peak(most, most, 0.0, most, trajectories, removal).bytes()


def helpers_within(allowed: float, removal: Removal, trajectories: int) -> int:
    """Return the number of additional processes that a memory limit allows for a simulation.

    Parameters
    ----------
    allowed : float
        Largest peak memory of all processes together, bytes.
    removal : Removal
        The prepared trajectories of the simulation.
    trajectories : int
        Number of trajectories, including trajectories that miss the stock.
    """
    counts = count(removal)
    each = _PROCESS + _band_work(removal) + _SENT_RECORD * counts.band + _SENT_TRAJECTORY * trajectories
    alone = peak_of(counts, trajectories, removal).cutting()
    return int(np.clip((allowed - alone) / each, 0, _MOST_HELPERS))


def _most_records(removal: Removal) -> float:
    """Return an upper bound of the number of dexels, trace elements and gaps; infinite if the stock is a mesh.

    The upper bound is computed from the number of pixels in the bounding box of each trajectory in the image.
    """
    if isinstance(removal.stock, Mesh):
        return np.inf
    frame = removal.frame
    half = np.array([frame.width, frame.height]) / 2
    left, right, bottom, top = removal.box / frame.pixel
    across = np.minimum(right, half[0]) - np.maximum(left, -half[0]) + 1
    up = np.minimum(top, half[1]) - np.maximum(bottom, -half[1]) + 1
    passes = float((np.maximum(across, 0) * np.maximum(up, 0)).sum())
    # An interval that is removed from inside a segment turns one segment into three, so the interval adds two records
    # (segments of rays). In a vertical view, each interval reaches one end of the ray, so the interval adds one record.
    return (1 if removal.sine == 0 else 2) * passes + frame.width * frame.height


def _peak(records: float, traces: float, stock: float, band: float, trajectories: int, removal: Removal) -> Peak:
    pixels = removal.frame.width * removal.frame.height
    return Peak(records, traces, stock, band, pixels, trajectories, _band_work(removal))


def _band_work(removal: Removal) -> float:
    """Return the memory for the temporary arrays of one band (`TILE` rows of pixels), bytes."""
    if removal.sine == 0 and removal.cosine > 0:
        return _BAND_ABOVE
    closed = all(t.rounding == t.radius or t.rounding == t.steepness == 0 for t in removal.tools)
    return _BAND_CLOSED if closed and abs(removal.cosine) > _STEEP else _BAND
