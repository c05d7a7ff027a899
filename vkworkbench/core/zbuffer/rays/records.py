# SPDX-License-Identifier: LGPL-2.1-or-later
"""Store the segments of all rays (dexels, trace elements and gaps) as records of 8 bytes each: the extended z-buffer.

The segments of a ray fill the ray from the point where the ray enters the stock to the point where the ray leaves the
stock. Each segment begins where the previous segment ends, so the records store a beginning only for the first segment
of a ray.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

# Element types of the arrays of dexels and of trace elements that callers get. The depths `near` and `far` are measured
# along the view's direction from the centre of the stock, mm.
DEXEL = np.dtype([("near", np.float32), ("far", np.float32), ("pixel", np.uint32)])
TRACE = np.dtype([("near", np.float32), ("far", np.float32), ("trajectory", np.uint32)])
# Type of the array that holds the number of each pixel's first record (segment of a ray).
INDEX = np.dtype(np.uint32)
# Value of `owner` for a gap in the stock, which is a segment of a ray without material before the first trajectory.
GAP = -1
# Memory for one record (a segment of a ray) and for one pixel, bytes.
RECORD_BYTES = 8
PIXEL_BYTES = 8
# Number of segments of rays in one batch. Most numpy functions hold the GIL, so a larger batch would stop all other
# threads for more than a few milliseconds. In a smaller batch, the overhead of numpy's calls would dominate.
_BLOCK = 1 << 17


@dataclass(frozen=True, eq=False)
class Records:
    """The segments of all rays of an image, sorted by pixel and then by depth.

    A pixel has the number row * width + column; row 0 is at the bottom of the image.

    Attributes
    ----------
    trajectories : int
        Number of trajectories of the toolpath.
    index : (pixels + 1,) ndarray of INDEX
        Number of the first segment of each pixel; the last entry is the number of all segments.
    entry : (pixels,) float32
        Depth at which the ray of each pixel enters the stock, mm; 0 for a ray that misses the stock.
    far : (p,) float32
        Depth at which each segment ends, mm.
    owner : (p,) int32
        Trajectory that removes each segment; `trajectories` for a segment that no trajectory removes, and `GAP` for a
        gap in the stock.
    """

    trajectories: int
    index: np.ndarray
    entry: np.ndarray
    far: np.ndarray
    owner: np.ndarray

    @property
    def nbytes(self) -> int:
        """Memory for the arrays, bytes."""
        return self.index.nbytes + self.entry.nbytes + self.far.nbytes + self.owner.nbytes

    @property
    def cut(self) -> np.ndarray:
        """Whether a trajectory removes each segment, (p,) bool."""
        return (self.owner != GAP) & (self.owner < self.trajectories)

    @cached_property
    def has_gaps(self) -> bool:
        """Whether at least one ray leaves the stock and enters it again."""
        return bool((self.owner == GAP).any())

    @cached_property
    def ends(self) -> np.ndarray:
        """Depth at which each pixel's ray last leaves the stock, (pixels,) float32 mm; NaN if the ray misses it."""
        ends = np.full(len(self.entry), np.nan, np.float32)
        met = np.flatnonzero(self.index[1:] > self.index[:-1])
        ends[met] = self.far[self.index[met + 1].astype(np.int64) - 1]
        return ends

    def blocks(self) -> Iterator[tuple[int, int, Records]]:
        """Yield the image in batches: first pixel, first segment, and the records of the batch as views."""
        segments = np.arange(0, len(self.far), max(_BLOCK, self.trajectories // 4))
        pixels = np.unique(np.append(np.searchsorted(self.index[1:], segments, side="right"), len(self.entry)))
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
        total = np.zeros(self.trajectories + 2)  # the first total is for the gaps, the last for the uncut segments
        for _, _, block in self.blocks():
            total += np.bincount(block.owner - GAP, block.far.astype(float) - block.near(), len(total))
        return total[1:-1]

    def segments_of(self, owners: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the segments that the selected trajectories remove, sorted by pixel and then by depth.

        Parameters
        ----------
        owners : (trajectories,) bool
            Whether each trajectory is selected.

        Returns
        -------
        segment, pixel : (k,) int64
            Number and pixel of each segment.
        near : (k,) float32
            Depth at which each segment begins, mm.
        """
        wanted = np.append(owners, [False, False])  # segments that no trajectory removes, and gaps, are not selected
        found = [(np.empty(0, np.int64), np.empty(0, np.int64), np.empty(0, np.float32))]
        for first_pixel, first_segment, block in self.blocks():
            own = np.flatnonzero(wanted[block.owner])
            if len(own):
                found.append((own + first_segment, block.pixel()[own] + np.int64(first_pixel), block.near()[own]))
        segment, pixel, near = (np.concatenate(parts) for parts in zip(*found))
        return segment, pixel, near

    def near(self) -> np.ndarray:
        """Return the depth at which each segment begins, (p,) float32 mm."""
        near = np.empty_like(self.far)
        near[1:] = self.far[:-1]
        met = np.flatnonzero(self.index[1:] > self.index[:-1])
        near[self.index[met]] = self.entry[met]
        return near

    def pixel(self) -> np.ndarray:
        """Return the pixel of each segment, (p,) uint32."""
        index: np.ndarray = self.index.astype(np.int64)
        return np.repeat(np.arange(len(self.entry), dtype=np.uint32), index[1:] - index[:-1])

    def dexels(self, step: int) -> np.ndarray:
        """Return the dexels after `step` trajectories, sorted by pixel and depth, (d,) ndarray of DEXEL."""
        left = self.owner >= step
        pixel = self.pixel()
        joined = np.zeros(len(left), bool)  # whether a segment and the previous segment belong to one dexel
        joined[1:] = left[1:] & left[:-1] & (pixel[1:] == pixel[:-1])
        first = np.flatnonzero(left & ~joined)
        last = np.flatnonzero(left & ~np.append(joined[1:], False))
        dexels = np.empty(len(first), DEXEL)
        dexels["near"], dexels["far"], dexels["pixel"] = self.near()[first], self.far[last], pixel[first]
        return dexels

    def traces(self) -> np.ndarray:
        """Return the segments that all trajectories remove, sorted by pixel and depth, (m,) ndarray of TRACE."""
        cut = np.flatnonzero(self.cut)
        traces = np.empty(len(cut), TRACE)
        traces["near"], traces["far"], traces["trajectory"] = self.near()[cut], self.far[cut], self.owner[cut]
        return traces

    def trace_index(self) -> np.ndarray:
        """Return the position in :meth:`traces` of each pixel's first element, (pixels + 1,) ndarray of INDEX."""
        before = np.append(0, np.cumsum(self.cut))
        return before[self.index].astype(INDEX)


# Number of stretches of an array that `first_not_below` searches in one batch. The arrays of a larger batch would not
# fit into the processor's cache, and in a smaller batch the overhead of numpy's calls would dominate.
_STRETCHES_AT_ONCE = 1 << 14


def first_not_below(values: np.ndarray, first: np.ndarray, end: np.ndarray, sought: np.ndarray | float) -> np.ndarray:
    """Find a value in each of several ascending stretches ``values[first:end]``, by simultaneous binary searches.

    Parameters
    ----------
    values : (p,) ndarray
    first, end : (k,) int64
        Positions in `values` at which each stretch begins and ends.
    sought : (k,) ndarray or float
        Value to find in each stretch.

    Returns
    -------
    (k,) int64
        Position in `values` of the first value of each stretch that is not less than `sought`; `end` if all values are
        less.
    """
    low = first.copy()
    for begin in range(0, len(low), _STRETCHES_AT_ONCE):
        part = slice(begin, begin + _STRETCHES_AT_ONCE)
        own, own_end = low[part], end[part]
        own_sought = sought[part] if isinstance(sought, np.ndarray) else sought
        for bit in reversed(range(int((own_end - own).max(initial=0)).bit_length())):
            probe = own + (1 << bit)
            below = values[np.minimum(probe, len(values)) - 1] < own_sought
            below &= probe <= own_end
            own += below.astype(np.int64) << bit
    return low


def side_by_side(parts: Sequence[Records], height: int) -> Records:
    """Join the records (segments of rays) of parts of an image, from left to right.

    Every part of the image has `height` rows of pixels.
    """
    if len(parts) == 1:
        return parts[0]
    # For each part of the image: the first pixel of each row of pixels, and the first segment on the ray of this pixel.
    pixels = [np.arange(height + 1) * (len(part.entry) // height) for part in parts]
    segments = [part.index[own] for part, own in zip(parts, pixels)]

    def rows(arrays: list[np.ndarray], bounds: list[np.ndarray]) -> np.ndarray:
        both = list(zip(arrays, bounds))
        return np.concatenate([array[of[row] : of[row + 1]] for row in range(height) for array, of in both])

    counts = rows([np.diff(part.index) for part in parts], pixels)
    return Records(
        parts[0].trajectories,
        np.append(0, np.cumsum(counts)).astype(INDEX),
        rows([part.entry for part in parts], pixels),
        rows([part.far for part in parts], segments),
        rows([part.owner for part in parts], segments),
    )


class Writer:
    """Collects the records (segments of rays) of an image by bands of pixel rows, from the bottom of the image up."""

    def __init__(self, trajectories: int, pixels: int) -> None:
        self.trajectories = trajectories
        self.index = np.zeros(pixels + 1, INDEX)
        self.entry = np.zeros(pixels, np.float32)
        self.far, self.owner = np.empty(0, np.float32), np.empty(0, np.int32)
        self.pixels = self.segments = 0

    def append(self, band: Records) -> None:
        """Add the records of the next band of pixel rows, directly above the previous band."""
        pixels, segments = self.pixels + len(band.entry), self.segments + len(band.far)
        if segments > len(self.far):
            self._resize(segments + segments // 8)
        self.far[self.segments : segments], self.owner[self.segments : segments] = band.far, band.owner
        self.index[self.pixels + 1 : pixels + 1] = band.index[1:] + self.segments
        self.entry[self.pixels : pixels] = band.entry
        self.pixels, self.segments = pixels, segments

    def records(self) -> Records:
        """Return the records of all collected bands of pixel rows."""
        self._resize(self.segments)
        return Records(self.trajectories, self.index, self.entry, self.far, self.owner)

    def _resize(self, segments: int) -> None:
        # Resize in place, because the operating system can enlarge a large array without holding a second copy.
        self.far.resize(segments, refcheck=False)
        self.owner.resize(segments, refcheck=False)
