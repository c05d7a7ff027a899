# SPDX-License-Identifier: LGPL-2.1-or-later
"""The records of the extended z-buffer: the pieces of all rays, 8 bytes each.

The pieces of a ray fill its chord of the stock, so each begins where the one before it ends, and only the first needs a
beginning of its own.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

# Records as callers read them. Depths are along the view's direction, from the middle of the stock, mm.
DEXEL = np.dtype([("near", np.float32), ("far", np.float32), ("pixel", np.uint32)])
TRACE = np.dtype([("near", np.float32), ("far", np.float32), ("trajectory", np.uint32)])
# One entry for each pixel: where its records begin.
INDEX = np.dtype(np.uint32)
# Owner of a piece in which nothing was from the start: of a gap of the stock.
GAP = -1
# What one piece and one pixel take as they are held.
RECORD_BYTES = 8
PIXEL_BYTES = 8
# Pieces that are worked on at once: milliseconds. Much of numpy lets no other thread run until it is through.
_BLOCK = 1 << 17


@dataclass(frozen=True, eq=False)
class Records:
    """The pieces of all rays of an image, sorted by pixel (row * width + column, row 0 below) and depth.

    Attributes
    ----------
    trajectories : int
        How many trajectories the toolpath has.
    index : (pixels + 1,) ndarray of INDEX
        Each pixel's first piece.
    entry : (pixels,) float32
        Depth at which each pixel's ray enters the stock, mm; 0 where it misses.
    far : (p,) float32
        Depth at which each piece ends, mm.
    owner : (p,) int32
        Trajectory that removes it; `trajectories` where none does, `GAP` where nothing was from the start.
    """

    trajectories: int
    index: np.ndarray
    entry: np.ndarray
    far: np.ndarray
    owner: np.ndarray

    @property
    def nbytes(self) -> int:
        """Bytes held."""
        return self.index.nbytes + self.entry.nbytes + self.far.nbytes + self.owner.nbytes

    @property
    def cut(self) -> np.ndarray:
        """Which pieces a trajectory removes, (p,) bool."""
        result: np.ndarray = (self.owner != GAP) & (self.owner < self.trajectories)
        return result

    def blocks(self) -> Iterator[tuple[int, int, Records]]:
        """Yield the image in parts, all their pieces being worked on at once: first pixel, first piece, views of both."""
        pieces = np.arange(0, len(self.far), max(_BLOCK, self.trajectories // 4))
        pixels = np.unique(np.append(np.searchsorted(self.index[1:], pieces, side="right"), len(self.entry)))
        for pixel, end in zip(pixels[:-1].tolist(), pixels[1:].tolist()):
            index = self.index[pixel : end + 1]
            own = slice(int(index[0]), int(index[-1]))
            yield (
                pixel,
                own.start,
                Records(self.trajectories, index - index[0], self.entry[pixel:end], self.far[own], self.owner[own]),
            )

    @cached_property
    def lengths(self) -> np.ndarray:
        """Length that each trajectory removes from all rays together, (trajectories,) float64 mm."""
        total = np.zeros(self.trajectories + 2)  # gaps come first, what stays last
        for _, _, block in self.blocks():
            total += np.bincount(block.owner - GAP, block.far.astype(float) - block.near(), len(total))
        return total[1:-1]

    def pieces_of(self, owners: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the pieces that some trajectories remove, by pixel and depth.

        Parameters
        ----------
        owners : (trajectories,) bool
            Which ones.

        Returns
        -------
        piece, pixel : (k,) int64
        near : (k,) float32
            Depth at which each begins, mm.
        """
        wanted = np.append(owners, [False, False])  # what stays, and gaps
        found = [(np.empty(0, np.int64), np.empty(0, np.int64), np.empty(0, np.float32))]
        for first_pixel, first_piece, block in self.blocks():
            own = np.flatnonzero(wanted[block.owner])
            if len(own):
                found.append((own + first_piece, block.pixel()[own] + np.int64(first_pixel), block.near()[own]))
        piece, pixel, near = (np.concatenate(parts) for parts in zip(*found))
        return piece, pixel, near

    def near(self) -> np.ndarray:
        """Depth at which each piece begins, (p,) float32 mm."""
        near = np.empty_like(self.far)
        near[1:] = self.far[:-1]
        met = np.flatnonzero(self.index[1:] > self.index[:-1])
        near[self.index[met]] = self.entry[met]
        return near

    def pixel(self) -> np.ndarray:
        """Pixel of each piece, (p,) uint32."""
        index: np.ndarray = self.index.astype(np.int64)
        return np.repeat(np.arange(len(self.entry), dtype=np.uint32), index[1:] - index[:-1])

    def dexels(self, step: int) -> np.ndarray:
        """Return what `step` trajectories leave of the stock: (d,) ndarray of DEXEL, by pixel and depth."""
        left = self.owner >= step
        pixel = self.pixel()
        joined = np.zeros(len(left), bool)  # with the piece before it
        joined[1:] = left[1:] & left[:-1] & (pixel[1:] == pixel[:-1])
        first = np.flatnonzero(left & ~joined)
        last = np.flatnonzero(left & ~np.append(joined[1:], False))
        dexels = np.empty(len(first), DEXEL)
        dexels["near"], dexels["far"], dexels["pixel"] = self.near()[first], self.far[last], pixel[first]
        return dexels

    def traces(self) -> np.ndarray:
        """Return what all trajectories remove: (m,) ndarray of TRACE, by pixel and depth."""
        cut = np.flatnonzero(self.cut)
        traces = np.empty(len(cut), TRACE)
        traces["near"], traces["far"], traces["trajectory"] = self.near()[cut], self.far[cut], self.owner[cut]
        return traces

    def trace_index(self) -> np.ndarray:
        """Return each pixel's first element in :meth:`traces`, (pixels + 1,) ndarray of INDEX."""
        before = np.append(0, np.cumsum(self.cut))
        result: np.ndarray = before[self.index].astype(INDEX)
        return result


def first_not_below(values: np.ndarray, first: np.ndarray, end: np.ndarray, sought: np.ndarray | float) -> np.ndarray:
    """Search stretches of an array, ``values[first:end]``, that ascend: binary searches, all at once.

    Parameters
    ----------
    values : (p,) ndarray
    first, end : (k,) int64
        Where each stretch begins and ends.
    sought : (k,) ndarray or float

    Returns
    -------
    (k,) int64
        Where the first value of each stretch is that is not below `sought`; `end` where none is.
    """
    low, high = first, end
    for _ in range(int((end - first).max(initial=0)).bit_length()):
        middle = (low + high) // 2
        below = (low < high) & (values.take(middle, mode="clip") < sought)
        low, high = np.where(below, middle + 1, low), np.where(below, high, middle)
    return low


def side_by_side(parts: Sequence[Records], height: int) -> Records:
    """Return the records of an image from those of its parts from left to right, each of so many rows."""
    if len(parts) == 1:
        return parts[0]
    # Each part's first pixel of each row, and there its first piece.
    pixels = [np.arange(height + 1) * (len(part.entry) // height) for part in parts]
    pieces = [part.index[own] for part, own in zip(parts, pixels)]

    def rows(arrays: list[np.ndarray], bounds: list[np.ndarray]) -> np.ndarray:
        both = list(zip(arrays, bounds))
        return np.concatenate([array[of[row] : of[row + 1]] for row in range(height) for array, of in both])

    counts = rows([np.diff(part.index) for part in parts], pixels)
    return Records(
        parts[0].trajectories,
        np.append(0, np.cumsum(counts)).astype(INDEX),
        rows([part.entry for part in parts], pixels),
        rows([part.far for part in parts], pieces),
        rows([part.owner for part in parts], pieces),
    )


class Writer:
    """Records that grow by bands of the image, from below."""

    def __init__(self, trajectories: int, pixels: int) -> None:
        self.trajectories = trajectories
        self.index = np.zeros(pixels + 1, INDEX)
        self.entry = np.zeros(pixels, np.float32)
        self.far, self.owner = np.empty(0, np.float32), np.empty(0, np.int32)
        self.pixels = self.pieces = 0

    def append(self, band: Records) -> None:
        """Add the pixels of the next band."""
        pixels, pieces = self.pixels + len(band.entry), self.pieces + len(band.far)
        if pieces > len(self.far):
            self._resize(pieces + pieces // 8)
        self.far[self.pieces : pieces], self.owner[self.pieces : pieces] = band.far, band.owner
        self.index[self.pixels + 1 : pixels + 1] = band.index[1:] + self.pieces
        self.entry[self.pixels : pixels] = band.entry
        self.pixels, self.pieces = pixels, pieces

    def records(self) -> Records:
        """Return what was written."""
        self._resize(self.pieces)
        return Records(self.trajectories, self.index, self.entry, self.far, self.owner)

    def _resize(self, pieces: int) -> None:
        # In place: the system moves large arrays without a second copy of them.
        self.far.resize(pieces, refcheck=False)
        self.owner.resize(pieces, refcheck=False)
