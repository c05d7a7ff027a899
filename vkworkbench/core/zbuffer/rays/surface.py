# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is seen of the part at any moment of the simulation, without sorting anything again.

What a ray meets first at moment k is its first piece from the eye that no trajectory before k removes. Only a piece
whose owner is greater than that of every piece before it on the ray can ever be that one. These prefix maxima ascend
along the ray, so a binary search finds the piece, for any k, forwards or backwards. The interval treap of Blasquez and
Poiraudeau (2000) answers the same.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from vkworkbench.core.zbuffer.rays.dexels import beginnings
from vkworkbench.core.zbuffer.rays.records import GAP, Records, first_not_below

# Owner of a surface that no trajectory made: the stock's own, or none.
STOCK = GAP


@dataclass(frozen=True, eq=False)
class Picture:
    """What is seen at one moment.

    Attributes
    ----------
    step : int
        The moment.
    depth : (pixels,) float32
        Depth of the surface along the view, mm; not a number where nothing is left.
    owner : (pixels,) int32
        Trajectory that made the surface, `STOCK` where none did.
    """

    step: int
    depth: np.ndarray
    owner: np.ndarray


# Maxima that are worked on at once: milliseconds, in which numpy may let no other thread run.
_AT_ONCE = 1 << 17


class Surface:
    """The pieces of an image that are seen at some moment.

    Parameters
    ----------
    records : Records
    """

    def __init__(self, records: Records) -> None:
        self.records = records
        self._latest: Picture | None = None

    def prepare(self) -> None:
        """Make what every moment needs: with many pieces it takes a while, which a window does not have."""
        self._by_owner  # noqa: B018 - kept from now on

    def picture(self, step: int) -> Picture:
        """Return what is seen at a moment: what has changed since the last one that was asked for is looked up."""
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
        """Return the pixels, ascending, whose picture may differ between two moments."""
        return np.unique(self._removed(step, other)).astype(np.int64)

    def _removed(self, step: int, other: int) -> np.ndarray:
        """Pixels of the pieces that go between two moments, some of them more than once."""
        first, pixels = self._by_owner
        result: np.ndarray = pixels[first[min(step, other)] : first[max(step, other)]]
        return result

    def _seen(self, step: int, pixels: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Depth and owner of the surface at some pixels: a binary search in each one's maxima, all at once."""
        records, (owners, pieces, first) = self.records, self._maxima
        end = first[pixels + 1]
        low = first_not_below(owners, first[pixels], end, step)
        seen = low < end
        depth = np.full(len(pixels), np.nan, np.float32)
        depth[seen] = records.entry[pixels[seen]]
        owner = np.full(len(pixels), STOCK, np.int32)
        piece = pieces[low[seen]].astype(np.int64)
        behind = piece > records.index[pixels[seen]]
        at, before = np.flatnonzero(seen)[behind], piece[behind] - 1
        depth[at], owner[at] = records.far[before], records.owner[before]
        return depth, owner

    @cached_property
    def _maxima(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The prefix maxima along the rays: their owners, their pieces, and each pixel's first one."""
        records = self.records
        first = np.zeros(len(records.entry) + 1, np.int64)
        owners, pieces = np.empty(len(records.far), np.int32), np.empty(len(records.far), np.uint32)
        for pixel, piece, block in records.blocks():
            keys = block.pixel().astype(np.int64)
            keys *= records.trajectories + 1
            keys += block.owner
            new = np.ones(len(keys), bool)
            new[1:] = keys[1:] > np.maximum.accumulate(keys)[:-1]
            own = np.flatnonzero(new)
            begin = first[pixel]
            first[pixel + 1 : pixel + len(block.index)] = begin + np.searchsorted(own, block.index[1:])
            owners[begin : begin + len(own)], pieces[begin : begin + len(own)] = block.owner[own], own + piece
        for array in (owners, pieces):
            array.resize(first[-1], refcheck=False)
        return owners, pieces, first

    @cached_property
    def _by_owner(self) -> tuple[np.ndarray, np.ndarray]:
        """Where each owner's maxima begin, and their pixels, by owner: a counting sort, part by part of the image."""
        owner, _, first = self._maxima
        count = np.zeros(self.records.trajectories + 1, np.int64)
        size = max(_AT_ONCE, len(count) // 4)
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
