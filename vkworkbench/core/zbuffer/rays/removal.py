# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut single rays, spread over the image, by a whole job; estimates use these rays."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from vkworkbench.core.zbuffer.rays.chains import cut_rays, gaps_of
from vkworkbench.core.zbuffer.rays.dexels import THINNEST, Segments
from vkworkbench.core.zbuffer.sweeps.trajectories import Trajectories

# Number of neighbouring rays in a group, whose common rectangle is compared with the bounding boxes of trajectories.
# Smaller groups of rays would need more comparisons. With larger groups, more trajectories would meet a rectangle but
# miss all rays in the rectangle.
GROUP = 16
# `_PAIRS_HELD` is the largest number of pairs of a ray and a trajectory that are in memory at one time.
# `_PAIRS_AT_ONCE` is the number of pairs of a ray and a trajectory in one batch, whose arrays fit into the processor's
# cache.
_PAIRS_HELD = 1_000_000
_PAIRS_AT_ONCE = 16_384


class Removal(Trajectories):
    """Trajectories that are prepared to cut single rays, spread over the image."""

    def cut(self, x: np.ndarray, y: np.ndarray) -> tuple[Segments, np.ndarray]:
        """Divide rays into segments at the ends of the intervals that trajectories remove.

        The method is fastest if consecutive rays are neighbouring rays in the image.

        Parameters
        ----------
        x, y : (k,) ndarray
            Image coordinates of the rays, mm.

        Returns
        -------
        segments : Segments
            The segments of the rays. The owner of a segment is the number of the trajectory that removes the segment,
            `UNCUT` or `GAP`.
        passes : (k,) int64
            Number of trajectories whose swept volume was intersected with each ray.
        """
        near, far, gaps = self.spans(x, y)
        # Rays that miss the stock have no segments.
        inside = np.flatnonzero(far - near > THINNEST)
        passes = np.zeros(len(x), np.int64)
        x, y, near, far, gaps = x[inside], y[inside], near[inside], far[inside], gaps_of(gaps, inside)
        parts = [(np.empty(0, np.int64), np.empty(0, np.int32), np.empty(0), np.empty(0))]
        for first, last, group, item in self._meetings(x, y):
            ray, item = self._pairs(group, item, x[first:last], y[first:last])
            passes[inside[first:last]] = np.bincount(ray, minlength=last - first)
            enter, leave = self.intervals(x[first:last][ray], y[first:last][ray], item)
            own = gaps_of(gaps, np.arange(first, last))
            segments = cut_rays(near[first:last], far[first:last], ray, self.index[item], enter, leave, own)
            parts.append((inside[segments.ray + first], segments.owner, segments.near, segments.far))
        return Segments(*(np.concatenate(columns) for columns in zip(*parts))), passes

    def _meetings(self, x: np.ndarray, y: np.ndarray) -> Iterator[tuple[int, int, np.ndarray, np.ndarray]]:
        """Yield ranges of rays (first, end), and the pairs of a group of rays and a trajectory that can meet.

        Each range contains as many rays as `_PAIRS_HELD` allows.
        """
        groups = -(-len(x) // GROUP)
        # The last group of rays is padded with copies of the last ray.
        padded = np.minimum(np.arange(groups * GROUP), len(x) - 1).reshape(-1, GROUP)
        gx, gy = x[padded], y[padded]
        group, item = self.meeting(gx.min(axis=1), gx.max(axis=1), gy.min(axis=1), gy.max(axis=1))
        bounds = np.append(0, np.bincount(group, minlength=groups).cumsum())
        begin = 0
        while begin < groups:
            end = int(np.searchsorted(bounds, bounds[begin] + _PAIRS_HELD // GROUP, side="right")) - 1
            end = max(begin + 1, end)
            part = slice(bounds[begin], bounds[end])
            yield begin * GROUP, min(end * GROUP, len(x)), group[part] - begin, item[part]
            begin = end

    def _pairs(
        self, group: np.ndarray, item: np.ndarray, x: np.ndarray, y: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the pairs of a ray and a trajectory that can meet, sorted by ray and then by trajectory."""
        # Each group of rays has one column, so that numpy's inner loops run along the pairs of a group and a
        # trajectory. The last group of rays is padded with NaN.
        gx, gy = np.full((2, -(-len(x) // GROUP) * GROUP), np.nan)
        gx[: len(x)], gy[: len(x)] = x, y
        gx, gy = gx.reshape(-1, GROUP).T, gy.reshape(-1, GROUP).T
        rays, hits = [np.empty(0, np.int64)], [np.empty(0, np.int64)]
        for begin in range(0, len(group), _PAIRS_AT_ONCE // GROUP):
            groups = group[begin : begin + _PAIRS_AT_ONCE // GROUP]
            items = item[begin : begin + _PAIRS_AT_ONCE // GROUP]
            rx, ry = gx.take(groups, axis=1), gy.take(groups, axis=1)
            met = self.passing(rx, ry, items)
            member = np.repeat(np.arange(GROUP), np.count_nonzero(met, axis=1))
            pair = np.flatnonzero(met) - member * len(items)
            rays.append(groups[pair] * GROUP + member)
            hits.append(items[pair])
        ray, hit = np.concatenate(rays), np.concatenate(hits)
        order = np.argsort(ray, kind="stable")
        return ray[order], hit[order]
