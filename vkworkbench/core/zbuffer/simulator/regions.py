# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut the rays in a region of the image, and assemble the region's records (dexels, trace elements and gaps)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from vkworkbench.core.zbuffer.culling.tiles import Bounds, Region, Tiles
from vkworkbench.core.zbuffer.rays.chains import cut_by_removing, cut_rays, gaps_of
from vkworkbench.core.zbuffer.rays.dexels import THINNEST, UNCUT, Segments
from vkworkbench.core.zbuffer.rays.opening import opened
from vkworkbench.core.zbuffer.rays.records import INDEX, Records
from vkworkbench.core.zbuffer.sweeps.trajectories import Trajectories


@dataclass(frozen=True, eq=False)
class _Part:
    """The segments of some rays after cutting.

    Attributes
    ----------
    ray : (k,) ndarray of int
        Numbers of the rays in the region.
    size : (k,) ndarray of int
        Number of segments of each ray.
    count : (k,) ndarray of int
        Number of segments of each ray that `end` and `owner` list. If no trajectory removes the last segment of a ray,
        this segment can be missing in both lists.
    end : (p,) float32
    owner : (p,) int32
        Depth at which each listed segment ends, mm, and the trajectory that removes each listed segment (its owner).
    """

    ray: np.ndarray
    size: np.ndarray
    count: np.ndarray
    end: np.ndarray
    owner: np.ndarray


def cut_region(
    trajectories: Trajectories, bounds: Bounds, blocks: Iterable[tuple[Tiles, int]], uncut: int, region: Region
) -> tuple[Records, int]:
    """Cut the rays in a region of the image.

    Parameters
    ----------
    bounds : Bounds
        Bounds of the swept volumes for the view in which the trajectories are prepared.
    blocks : iterable of (Tiles, int)
        Small tiles, each with the number of tests made to find it, as `tiles.small_tiles` yields them.
    uncut : int
        Number that is stored, instead of a trajectory, for segments that no trajectory removes.

    Returns
    -------
    records : Records
    tested : int
        How many times a trajectory was tested against a tile or a pixel.
    """
    rays = _Rays(trajectories, bounds, uncut, region)
    tested = 0
    for tiles, pairs in blocks:
        tested += pairs
        rays.cut(tiles)
    return rays.records(), tested


class _Rays:
    def __init__(self, trajectories: Trajectories, bounds: Bounds, uncut: int, region: Region) -> None:
        self.trajectories, self.bounds, self.uncut, self.region = trajectories, bounds, uncut, region
        frame, self.width = trajectories.frame, region.right - region.left
        row, column = np.divmod(np.arange(self.width * (region.top - region.bottom)), self.width)
        centres = frame.pixel_centres(region.left + column, region.bottom + row)
        self.near, self.far, self.gaps = trajectories.spans(*centres)
        self.inside = self.far - self.near > THINNEST
        # A gap in the stock is stored as a segment of the ray, even if no trajectory cuts the ray. Therefore each ray
        # with gaps is marked as pending until it is cut, and `records` adds the segments of the rays that are still
        # pending.
        self.pending = np.zeros(len(row), bool)
        self.pending[self.gaps.ray] = True
        self.parts: list[_Part] = []

    def cut(self, tiles: Tiles) -> None:
        """Cut the rays of each tile by the trajectories listed for this tile."""
        column, row = tiles.pixels()
        shape = tiles.side**2, len(tiles.column)
        ray = ((row[:, None] - self.region.bottom) * self.width + column - self.region.left).reshape(shape)
        outside = ((row[:, None] >= self.region.top) | (column >= self.region.right)).reshape(shape)
        ray[outside] = 0
        usable = self.inside[ray] & ~outside
        near, far = np.where(usable, self.near[ray], np.inf), np.where(usable, self.far[ray], -np.inf)
        tile = np.repeat(np.arange(len(tiles.column)), np.diff(tiles.first))
        hit, enter, leave = self.bounds.removals(tiles, tile, near, far)
        if len(hit) == 0:
            return
        # The rays are sorted by the position of their pixel in its tile, and then by tile.
        rows = np.arange(shape[0]) * len(tile)
        begin = np.searchsorted(hit, (rows[:, None] + tiles.first[:-1]).ravel())
        met = np.flatnonzero(np.diff(begin, append=len(hit)))
        start = begin[met]
        for first, own in zip(rows.tolist(), np.split(hit, begin[:: shape[1]][1:])):
            own -= first  # `own` now contains the numbers of pairs of a tile and a trajectory
        owner = self.trajectories.index.take(tiles.item).take(hit)
        ray, near, far = ray.ravel()[met], near.ravel()[met], far.ravel()[met]
        if enter is None and len(self.gaps.ray) == 0:
            count, rest, end, owner = opened(near, far, start, owner, leave)
            self._add(ray, count + rest, count, end, owner)
            return
        if enter is None:
            enter = np.full(len(hit), -np.inf)
        number = np.repeat(np.arange(len(start)), np.diff(start, append=len(hit)))
        if len(self.gaps.ray):
            self._put(ray, cut_rays(near, far, number, owner, enter, leave, gaps_of(self.gaps, ray)))
        else:
            self._put(ray, cut_by_removing(near, far, number, owner, enter, leave))

    def records(self) -> Records:
        """Return the records (dexels, trace elements and gaps) of all rays in the region."""
        ray = np.flatnonzero(self.pending & self.inside)
        if len(ray):
            nobody, nowhere, own = np.empty(0, np.int64), np.empty(0), gaps_of(self.gaps, ray)
            self._put(ray, cut_rays(self.near[ray], self.far[ray], nobody, nobody, nowhere, nowhere, own))
        size = self.inside.astype(np.int64)
        for part in self.parts:
            size[part.ray] = part.size
        index = np.append(0, np.cumsum(size))
        ends, owners = np.empty(index[-1], np.float32), np.full(index[-1], self.uncut, np.int32)
        ends[index[1:][self.inside] - 1] = self.far[self.inside]
        for part in self.parts:
            first = np.cumsum(part.count) - part.count
            at = np.repeat(index[part.ray] - first, part.count) + np.arange(len(part.end))
            ends[at], owners[at] = part.end, part.owner
        entry = np.where(self.inside, self.near, 0).astype(np.float32)
        return Records(self.uncut, index.astype(INDEX), entry, ends, owners)

    def _put(self, ray: np.ndarray, segments: Segments) -> None:
        """Store the segments of the rays `ray`; ``segments.ray`` contains positions in the array `ray`."""
        size = np.bincount(segments.ray, minlength=len(ray))
        self._add(ray, size, size, segments.far, np.where(segments.owner == UNCUT, self.uncut, segments.owner))
        self.pending[ray] = False

    def _add(self, ray: np.ndarray, size: np.ndarray, count: np.ndarray, end: np.ndarray, owner: np.ndarray) -> None:
        self.parts.append(_Part(ray, size, count, end.astype(np.float32), owner.astype(np.int32)))
