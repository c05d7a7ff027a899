# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is seen of the part at any moment of the simulation, without sorting anything again.

What a ray meets first at moment k is its first piece from the eye that no trajectory before k removes. Only a piece whose
owner is greater than that of every piece before it on the ray can ever be that one. These prefix maxima are in the order
of ``pixel * (trajectories + 1) + owner`` already, so one binary search finds the piece of every pixel, for any k, forwards
or backwards. The interval treap of Blasquez and Poiraudeau (2000) answers the same for one ray at a time.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from vkworkbench.core.zbuffer.records import Records

# Owner of a surface that no trajectory made: the stock's own, or none.
STOCK = -1


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


class Surface:
    """The pieces of an image that are seen at some moment.

    Parameters
    ----------
    records : Records
    """

    def __init__(self, records: Records) -> None:
        self.records = records
        self._latest: Picture | None = None

    def picture(self, step: int) -> Picture:
        """Return what is seen at a moment: what has changed since the last one that was asked for is looked up."""
        latest = self._latest
        if latest is None or latest.step != step:
            pixels = everywhere = np.arange(len(self.records.entry))
            if latest is not None:
                pixels = self.changed(latest.step, step)
            if len(pixels) > len(everywhere) // 4:
                latest = Picture(step, *self._seen(step, everywhere))
            else:
                depth, owner = latest.depth.copy(), latest.owner.copy()
                depth[pixels], owner[pixels] = self._seen(step, pixels)
                latest = Picture(step, depth, owner)
            self._latest = latest
        return latest

    def changed(self, step: int, other: int) -> np.ndarray:
        """Return the pixels, ascending, whose picture may differ between two moments."""
        owners, pixels = self._by_owner
        first, last = np.searchsorted(owners, (min(step, other), max(step, other)))
        return np.unique(pixels[first:last]).astype(np.int64)

    def _seen(self, step: int, pixels: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        records, base = self.records, self.records.trajectories + 1
        keys, pieces = self._maxima
        at = np.searchsorted(keys, pixels * base + step)
        last = len(keys) - 1
        piece = pieces[np.minimum(at, last)].astype(np.int64) if last >= 0 else at
        first, end = records.index[pixels], records.index[pixels + 1]
        none = (at > last) | (piece >= end)
        behind = ~none & (piece > first)
        before = piece[behind] - 1
        depth = np.where(none, np.float32(np.nan), records.entry[pixels])
        owner = np.full(len(pixels), STOCK, np.int32)
        depth[behind], owner[behind] = records.far[before], records.owner[before]
        return depth, owner

    @cached_property
    def _maxima(self) -> tuple[np.ndarray, np.ndarray]:
        """The prefix maxima of the owners along the rays: their keys, ascending, and their pieces."""
        keys = self.records.pixel().astype(np.int64)
        keys *= self.records.trajectories + 1
        keys += self.records.owner
        new = np.ones(len(keys), bool)
        new[1:] = keys[1:] > np.maximum.accumulate(keys)[:-1]
        return keys[new], np.flatnonzero(new).astype(np.uint32)

    @cached_property
    def _by_owner(self) -> tuple[np.ndarray, np.ndarray]:
        """Owners of the pieces, ascending, and their pixels: a radix sort, 16 bits at a time."""
        keys, pieces = self._maxima
        owner = self.records.owner[pieces]
        order = np.argsort(owner.astype(np.uint16), kind="stable")
        if self.records.trajectories >> 16:
            order = order[np.argsort((owner >> 16).astype(np.uint16)[order], kind="stable")]
        return owner[order], (keys[order] // (self.records.trajectories + 1)).astype(np.uint32)
