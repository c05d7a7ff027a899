# SPDX-License-Identifier: LGPL-2.1-or-later
"""The records of the extended z-buffer: the pieces of all rays, 8 bytes each.

The pieces of a ray fill its chord of the stock. Each piece begins where the previous one ends, so only the first piece of a ray
needs a stored beginning.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

# Records as returned to callers. Depths are along the view's direction, relative to the centre of the stock, mm.
DEXEL = np.dtype([("near", np.float32), ("far", np.float32), ("pixel", np.uint32)])
TRACE = np.dtype([("near", np.float32), ("far", np.float32), ("trajectory", np.uint32)])
# Type of the first record of each pixel.
INDEX = np.dtype(np.uint32)
# Owner of a gap of the stock, which is empty from the start.
GAP = -1
# Memory of one piece and of one pixel, bytes.
RECORD_BYTES = 8
PIXEL_BYTES = 8
# Pieces in one step, which takes milliseconds. During most of numpy's functions no other thread runs.
_BLOCK = 1 << 17


@dataclass(frozen=True, eq=False)
class Records:
    """The pieces of all rays of an image, sorted by pixel (row * width + column, row 0 below) and depth.

    Attributes
    ----------
    trajectories : int
        Number of trajectories of the toolpath.
    index : (pixels + 1,) ndarray of INDEX
        First piece of each pixel.
    entry : (pixels,) float32
        Depth at which the ray of each pixel enters the stock, mm; 0 for a ray that misses.
    far : (p,) float32
        End of each piece, mm.
    owner : (p,) int32
        Trajectory that removes the piece; `trajectories` for a piece that is left, `GAP` for a gap of the stock.
    """

    trajectories: int
    index: np.ndarray
    entry: np.ndarray
    far: np.ndarray
    owner: np.ndarray

    @property
    def nbytes(self) -> int:
        """Memory of the arrays, bytes."""
        return self.index.nbytes + self.entry.nbytes + self.far.nbytes + self.owner.nbytes

    @property
    def cut(self) -> np.ndarray:
        """Which pieces a trajectory removes, (p,) bool."""
        result: np.ndarray = (self.owner != GAP) & (self.owner < self.trajectories)
        return result

    @cached_property
    def has_gaps(self) -> bool:
        """Whether a ray leaves the stock and enters it again."""
        return bool((self.owner == GAP).any())

    @cached_property
    def ends(self) -> np.ndarray:
        """Depth at which the ray of each pixel finally leaves the stock, (pixels,) float32 mm; NaN for a ray that misses."""
        ends = np.full(len(self.entry), np.nan, np.float32)
        met = np.flatnonzero(self.index[1:] > self.index[:-1])
        ends[met] = self.far[self.index[met + 1].astype(np.int64) - 1]
        return ends

    def blocks(self) -> Iterator[tuple[int, int, Records]]:
        """Yield parts of the image small enough for one step: first pixel, first piece, and the records as views."""
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
        """Total length that each trajectory removes from all rays, (trajectories,) float64 mm."""
        total = np.zeros(self.trajectories + 2)  # the first entry is for gaps, the last for pieces that are left
        for _, _, block in self.blocks():
            total += np.bincount(block.owner - GAP, block.far.astype(float) - block.near(), len(total))
        return total[1:-1]

    def pieces_of(self, owners: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the pieces that some trajectories remove, sorted by pixel and depth.

        Parameters
        ----------
        owners : (trajectories,) bool
            Which trajectories.

        Returns
        -------
        piece, pixel : (k,) int64
        near : (k,) float32
            Beginning of each piece, mm.
        """
        wanted = np.append(owners, [False, False])  # for pieces that are left, and gaps
        found = [(np.empty(0, np.int64), np.empty(0, np.int64), np.empty(0, np.float32))]
        for first_pixel, first_piece, block in self.blocks():
            own = np.flatnonzero(wanted[block.owner])
            if len(own):
                found.append((own + first_piece, block.pixel()[own] + np.int64(first_pixel), block.near()[own]))
        piece, pixel, near = (np.concatenate(parts) for parts in zip(*found))
        return piece, pixel, near

    def near(self) -> np.ndarray:
        """Return the beginning of each piece, (p,) float32 mm."""
        near = np.empty_like(self.far)
        near[1:] = self.far[:-1]
        met = np.flatnonzero(self.index[1:] > self.index[:-1])
        near[self.index[met]] = self.entry[met]
        return near

    def pixel(self) -> np.ndarray:
        """Return the pixel of each piece, (p,) uint32."""
        index: np.ndarray = self.index.astype(np.int64)
        return np.repeat(np.arange(len(self.entry), dtype=np.uint32), index[1:] - index[:-1])

    def dexels(self, step: int) -> np.ndarray:
        """Return the stock that is left after `step` trajectories: (d,) ndarray of DEXEL, sorted by pixel and depth."""
        left = self.owner >= step
        pixel = self.pixel()
        joined = np.zeros(len(left), bool)  # whether a piece continues the previous dexel
        joined[1:] = left[1:] & left[:-1] & (pixel[1:] == pixel[:-1])
        first = np.flatnonzero(left & ~joined)
        last = np.flatnonzero(left & ~np.append(joined[1:], False))
        dexels = np.empty(len(first), DEXEL)
        dexels["near"], dexels["far"], dexels["pixel"] = self.near()[first], self.far[last], pixel[first]
        return dexels

    def traces(self) -> np.ndarray:
        """Return the pieces that all trajectories remove: (m,) ndarray of TRACE, sorted by pixel and depth."""
        cut = np.flatnonzero(self.cut)
        traces = np.empty(len(cut), TRACE)
        traces["near"], traces["far"], traces["trajectory"] = self.near()[cut], self.far[cut], self.owner[cut]
        return traces

    def trace_index(self) -> np.ndarray:
        """Return the first element of each pixel in :meth:`traces`, (pixels + 1,) ndarray of INDEX."""
        before = np.append(0, np.cumsum(self.cut))
        result: np.ndarray = before[self.index].astype(INDEX)
        return result


# Stretches that are searched at once.
_BLOCK = 1 << 14


def first_not_below(values: np.ndarray, first: np.ndarray, end: np.ndarray, sought: np.ndarray | float) -> np.ndarray:
    """Search ascending stretches ``values[first:end]`` of an array, by simultaneous binary searches.

    Parameters
    ----------
    values : (p,) ndarray
    first, end : (k,) int64
        Beginning and end of each stretch.
    sought : (k,) ndarray or float

    Returns
    -------
    (k,) int64
        Position of the first value in each stretch that is not below `sought`; `end` without one.
    """
    low = first.copy()
    for begin in range(0, len(low), _BLOCK):  # blocks that fit into the cache of a processor
        part = slice(begin, begin + _BLOCK)
        own, own_end = low[part], end[part]
        own_sought = sought[part] if isinstance(sought, np.ndarray) else sought
        for bit in reversed(range(int((own_end - own).max(initial=0)).bit_length())):
            probe = own + (1 << bit)
            below = values[np.minimum(probe, len(values)) - 1] < own_sought
            below &= probe <= own_end
            own += below.astype(np.int64) << bit
    return low


def side_by_side(parts: Sequence[Records], height: int) -> Records:
    """Join the records of an image's parts, from left to right; all parts have `height` rows."""
    if len(parts) == 1:
        return parts[0]
    # First pixel of each row in each part, and its first piece.
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
    """Collects records band by band, from the bottom of the image."""

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
        """Return the collected records."""
        self._resize(self.pieces)
        return Records(self.trajectories, self.index, self.entry, self.far, self.owner)

    def _resize(self, pieces: int) -> None:
        # In place, because the system can move large arrays without a second copy.
        self.far.resize(pieces, refcheck=False)
        self.owner.resize(pieces, refcheck=False)
