# SPDX-License-Identifier: LGPL-2.1-or-later
"""The extended z-buffer with traces, every trajectory tried on every ray it passes: what the package had before.

Every pixel's ray holds the dexels of the part and the elements of the traces, the pieces the trajectories
removed. Traces glue the chips back on the part, so every moment of the simulation can be had again.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from zbuffer_reference.dexels import UNCUT, Pieces, with_uncut
from zbuffer_reference.removal import Removal

from vkworkbench.core import Stock, Tool, Toolpath, View

# The records of the z-buffer. Depths are along the view's direction, from the middle of the stock, mm.
DEXEL = np.dtype([("near", np.float32), ("far", np.float32), ("pixel", np.uint32)])
TRACE = np.dtype([("near", np.float32), ("far", np.float32), ("trajectory", np.uint32)])
# One entry for each pixel: where its elements of the traces begin.
INDEX = np.dtype(np.uint32)

_TILE = 64
# Side of a block of neighbouring pixels: the square root of removal.GROUP.
_BLOCK = 4
# Pairs of pixel and trajectory to which a tile is cut down.
_PAIRS = 4_000_000


@dataclass(frozen=True, eq=False)
class ZBuffer:
    """An image of rays cut by a toolpath, at one moment of the simulation.

    Attributes
    ----------
    frame : Frame
        Axes, centre and pixel of the image.
    trajectories : int
        How many trajectories the toolpath has.
    step : int
        The moment: that many trajectories have been simulated.
    part_records : (p,) ndarray of DEXEL
        What the whole toolpath leaves of the stock, sorted by pixel (row * width + column, row 0 below) and
        depth.
    trace_records : (m,) ndarray of TRACE
        What the whole toolpath removes, sorted by pixel and depth.
    trace_index : (pixels + 1,) ndarray of INDEX
        First element of each pixel in `trace_records`.
    candidates : int
        Pairs of pixel and trajectory the simulation examined.
    """

    frame: object
    trajectories: int
    step: int
    part_records: np.ndarray
    trace_records: np.ndarray
    trace_index: np.ndarray
    candidates: int

    @cached_property
    def dexel_records(self) -> np.ndarray:
        """The dexels at this moment: those of the part and the chips that have not been cut yet, joined."""
        if self.step == self.trajectories:
            return self.part_records
        chip_pixel = np.repeat(np.arange(len(self.trace_index) - 1), np.diff(self.trace_index.astype(np.int64)))
        pixel = np.concatenate((self.part_records["pixel"], chip_pixel)).astype(np.int64)
        near, far = (np.concatenate((self.part_records[end], self.trace_records[end])) for end in ("near", "far"))
        owner = np.concatenate((np.full(len(self.part_records), UNCUT), self.trace_records["trajectory"]))
        order = np.lexsort((near, pixel))
        pieces = Pieces(pixel[order], owner[order], near[order], far[order])
        return _dexels(with_uncut(pieces, self.step))

    @property
    def dexels(self) -> int:
        """Number of dexels at this moment."""
        return len(self.dexel_records)

    @property
    def traces(self) -> int:
        """Number of trace elements at this moment."""
        return int(np.count_nonzero(self.trace_records["trajectory"] < self.step))

    @property
    def memory_bytes(self) -> int:
        """Bytes of the records and of the index, the traces of later moments included."""
        return self.dexel_records.nbytes + self.trace_records.nbytes + self.trace_index.nbytes

    @property
    def part_volume(self) -> float:
        """Volume of what is left at this moment, mm^3."""
        return _length(self.dexel_records) * self.frame.pixel**2

    @property
    def chip_volume(self) -> float:
        """Volume removed until this moment, mm^3."""
        return _length(self.trace_records[self.trace_records["trajectory"] < self.step]) * self.frame.pixel**2

    def at(self, step: int) -> ZBuffer:
        """Return the simulation at another moment.

        Parameters
        ----------
        step : int
            Number of trajectories simulated, from 0 (the stock) to `trajectories` (the part).

        Raises
        ------
        ValueError
            Where there is no such moment.
        """
        if not 0 <= step <= self.trajectories:
            raise ValueError(f"the simulation has the moments 0 to {self.trajectories}, not {step}")
        return replace(self, step=step)


def simulate(toolpath: Toolpath, *, tool: Tool, stock: Stock, view: View) -> ZBuffer:
    """Cut the stock by all trajectories, rapids included, and count exactly.

    An element of a trace is one piece a trajectory removes from one pixel's ray. Pieces up to 1e-4 mm are
    rounding noise and go to their neighbour. A trajectory is the straight sweep of the tool between two
    points of the toolpath.

    Parameters
    ----------
    toolpath : Toolpath
    tool : Tool
    stock : Stock
    view : View

    Returns
    -------
    ZBuffer
        At its last moment.
    """
    frame = view.frame(stock)
    removal = Removal(toolpath, tool, stock, frame)
    dexels, traces, cut_pixels, candidates = [], [], [], 0
    # Tiles are quarters of quarters, so that a trajectory is looked for only where it passes.
    side = _TILE << max(0, (max(frame.width, frame.height) - 1) // _TILE).bit_length()
    pending = [(0, 0, side, np.arange(len(removal.index)))]
    while pending:
        left, bottom, side, selection = pending.pop()
        right, top = min(left + side, frame.width), min(bottom + side, frame.height)
        x, y = frame.pixel_centres(np.array([left, right - 1]), np.array([bottom, top - 1]))
        selection = removal.meeting(x[:1], x[1:], y[:1], y[1:], selection)[1]
        if side > _TILE or (side > _BLOCK and len(selection) * (right - left) * (top - bottom) > _PAIRS):
            pending += [
                (c, r, side // 2, selection)
                for c in (left, left + side // 2)
                for r in (bottom, bottom + side // 2)
                if c < right and r < top
            ]
            continue
        column, row = _blockwise(left, bottom, right, top)
        pieces, passes = removal.cut(*frame.pixel_centres(column, row), selection)
        candidates += int(passes.sum())
        pixel = (row * frame.width + column)[pieces.ray]
        pieces = Pieces(pixel, pieces.owner, pieces.near, pieces.far)
        dexels.append(_dexels(pieces))
        traces.append(_traces(pieces))
        cut_pixels.append(pixel[pieces.owner != UNCUT])
    image = frame.width * frame.height
    part, _ = _by_pixel(dexels, [d["pixel"] for d in dexels], image)
    chips, index = _by_pixel(traces, cut_pixels, image)
    return ZBuffer(frame, len(toolpath), len(toolpath), part, chips, index, candidates)


def _blockwise(left: int, bottom: int, right: int, top: int) -> tuple[np.ndarray, np.ndarray]:
    """Columns and rows of a tile's pixels, in blocks of neighbours as `Removal.cut` likes them."""
    column, row = (v.ravel() for v in np.meshgrid(np.arange(left, right), np.arange(bottom, top)))
    order = np.lexsort(((column - left) // _BLOCK, (row - bottom) // _BLOCK))
    return column[order], row[order]


def _by_pixel(records: list[np.ndarray], pixels: list[np.ndarray], image: int) -> tuple[np.ndarray, np.ndarray]:
    """Put the tiles' records in the order of their pixels; also the first record of each pixel.

    A pixel's records follow each other within their tile, so nothing has to be sorted.
    """
    index = np.zeros(image + 1, INDEX)
    runs = []
    for pixel in pixels:
        start = np.flatnonzero(np.diff(pixel, prepend=-1))
        length = np.diff(start, append=len(pixel))
        index[pixel[start] + 1] = length
        runs.append((start, length))
    np.cumsum(index, out=index)
    ordered = np.empty(index[-1], records[0].dtype)
    for part, pixel, (start, length) in zip(records, pixels, runs):
        ordered[np.repeat(index[pixel[start]] - start, length) + np.arange(len(pixel))] = part
    return ordered, index


def _traces(pieces: Pieces) -> np.ndarray:
    cut = pieces.owner != UNCUT
    traces = np.empty(np.count_nonzero(cut), TRACE)
    traces["near"], traces["far"], traces["trajectory"] = pieces.near[cut], pieces.far[cut], pieces.owner[cut]
    return traces


def _dexels(pieces: Pieces) -> np.ndarray:
    left = pieces.owner == UNCUT
    dexels = np.empty(np.count_nonzero(left), DEXEL)
    dexels["near"], dexels["far"], dexels["pixel"] = pieces.near[left], pieces.far[left], pieces.ray[left]
    return dexels


def _length(records: np.ndarray) -> float:
    return float((records["far"].astype(float) - records["near"]).sum())
