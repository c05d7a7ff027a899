# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the visible surface of the part at any moment of the simulation, without sorting the segments again.

At moment k (before trajectory k is simulated), the visible segment of a ray is the segment nearest to the eye that no
trajectory before k removes. The owner of a segment is the number of the trajectory that removes the segment. A segment
can become visible only if the segment is removed later than all segments between the eye and the segment. Owners that
are greater than all owners nearer to the eye (the prefix maxima) ascend along the ray, so a binary search finds the
visible segment for any k, whether the simulation runs forwards or backwards. Blasquez and Poiraudeau (2000) solve the
same problem with an interval treap.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from vkworkbench.core.zbuffer.rays.dexels import beginnings
from vkworkbench.core.zbuffer.rays.records import GAP, Records, first_not_below

# Value of `owner` for a surface of the raw stock, and for a ray that meets no material.
STOCK = GAP


@dataclass(frozen=True, eq=False)
class Picture:
    """The visible surface of the part after a given number of simulated trajectories.

    Attributes
    ----------
    step : int
        Number of simulated trajectories.
    depth : (pixels,) float32
        Depth of the surface along the view's direction, mm; NaN for a ray that meets no material.
    owner : (pixels,) int32
        Trajectory that cut the surface, or `STOCK`.
    """

    step: int
    depth: np.ndarray
    owner: np.ndarray


# Smallest number of prefix maxima (segments of rays that are removed later than all segments nearer to the eye) that
# are processed in one batch. Numpy holds the GIL for most of a batch, so a larger batch would stop all other threads
# for more than a few milliseconds. In a smaller batch, the overhead of numpy's calls would dominate.
_BATCH = 1 << 17


class Surface:
    """The visible surfaces of the part after any number of simulated trajectories.

    Parameters
    ----------
    records : Records
    """

    def __init__(self, records: Records) -> None:
        self.records = records
        self._latest: Picture | None = None

    def prepare(self) -> None:
        """Compute the tables of the segments that can become visible, which are needed to show the part at any moment.

        With many segments, the computation takes so long that it must not run in the thread of the user interface.
        """
        self._by_owner  # noqa: B018 - cached

    def picture(self, step: int) -> Picture:
        """Return the visible surface after `step` trajectories.

        Only the pixels that can differ from the previous call are computed. If more than a quarter of the pixels can
        differ, all pixels are computed.
        """
        latest = self._latest
        if latest is not None and latest.step == step:
            return latest
        everywhere = np.arange(len(self.records.entry))
        if latest is None or len(self._removed(latest.step, step)) > len(everywhere) // 4:
            latest = Picture(step, *self._seen(step, everywhere))
        else:
            pixels = self.changed(latest.step, step)
            depth, owner = latest.depth.copy(), latest.owner.copy()
            depth[pixels], owner[pixels] = self._seen(step, pixels)
            latest = Picture(step, depth, owner)
        self._latest = latest
        return latest

    def changed(self, step: int, other: int) -> np.ndarray:
        """Return the pixels, ascending, whose visible surfaces can differ between the moments `step` and `other`."""
        return np.unique(self._removed(step, other)).astype(np.int64)

    def _removed(self, step: int, other: int) -> np.ndarray:
        """Return the pixels in which trajectories from `step` to `other` remove a visible segment, with repetitions."""
        first, pixels = self._by_owner
        return pixels[first[min(step, other)] : first[max(step, other)]]

    def _seen(self, step: int, pixels: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the visible surface's depth, and the trajectory that cut it, at some pixels, by binary searches."""
        records, (owners, segments, first) = self.records, self._maxima
        end = first[pixels + 1]
        low = first_not_below(owners, first[pixels], end, step)
        seen = low < end
        depth = np.full(len(pixels), np.nan, np.float32)
        depth[seen] = records.entry[pixels[seen]]
        owner = np.full(len(pixels), STOCK, np.int32)
        segment = segments[low[seen]].astype(np.int64)
        behind = segment > records.index[pixels[seen]]
        at, before = np.flatnonzero(seen)[behind], segment[behind] - 1
        depth[at], owner[at] = records.far[before], records.owner[before]
        return depth, owner

    @cached_property
    def _maxima(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The prefix maxima: segments that can become visible, their trajectories, and each pixel's first maximum.

        The result contains the trajectories, the segments, and the position of each pixel's first prefix maximum.
        """
        records = self.records
        first = np.zeros(len(records.entry) + 1, np.int64)
        owners, segments = np.empty(len(records.far), np.int32), np.empty(len(records.far), np.uint32)
        for pixel, segment, block in records.blocks():
            keys = block.pixel().astype(np.int64)
            keys *= records.trajectories + 1
            keys += block.owner
            new = np.ones(len(keys), bool)
            new[1:] = keys[1:] > np.maximum.accumulate(keys)[:-1]
            own = np.flatnonzero(new)
            begin = first[pixel]
            first[pixel + 1 : pixel + len(block.index)] = begin + np.searchsorted(own, block.index[1:])
            owners[begin : begin + len(own)], segments[begin : begin + len(own)] = block.owner[own], own + segment
        for array in (owners, segments):
            array.resize(first[-1], refcheck=False)
        return owners, segments, first

    @cached_property
    def _by_owner(self) -> tuple[np.ndarray, np.ndarray]:
        """The pixels of all segments that can become visible, sorted by the trajectory that removes the segment.

        The first array contains the position at which each trajectory's pixels begin, and the second array the pixels.
        The pixels are sorted by a counting sort in batches.
        """
        owner, _, first = self._maxima
        count = np.zeros(self.records.trajectories + 1, np.int64)
        size = max(_BATCH, len(count) // 4)
        for begin in range(0, len(owner), size):
            count += np.bincount(owner[begin : begin + size], minlength=len(count))
        start = np.append(0, np.cumsum(count))
        free, pixels = start.copy(), np.empty(len(owner), np.uint32)
        parts = np.searchsorted(first, np.arange(0, len(owner), size), side="right") - 1
        parts = np.unique(np.append(parts, len(self.records.entry)))
        for begin, end in zip(parts[:-1].tolist(), parts[1:].tolist()):
            own = owner[first[begin] : first[end]]
            pixel = np.repeat(np.arange(begin, end, dtype=np.uint32), np.diff(first[begin : end + 1]))
            order = np.argsort(own, kind="stable")
            sorted_ = own[order]
            new = beginnings(sorted_)
            sizes, owners = np.diff(new, append=len(own)), sorted_[new]
            pixels[np.arange(len(own)) + np.repeat(free[owners] - new, sizes)] = pixel[order]
            free[owners] += sizes
        return start, pixels
