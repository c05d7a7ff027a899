# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scattered rays cut by a whole toolpath, as the estimate needs them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from vkworkbench.core.zbuffer.rays.chains import among, cut_rays
from vkworkbench.core.zbuffer.rays.dexels import THINNEST, Pieces
from vkworkbench.core.zbuffer.sweeps.trajectories import Trajectories

# Neighbouring rays are tested against a trajectory's bounding box together.
GROUP = 16
# Pairs of ray and trajectory held at once, and worked on at once (so that they stay in the processor's
# cache).
_PAIRS_HELD = 1_000_000
_PAIRS_AT_ONCE = 16_384


class Removal(Trajectories):
    """Toolpaths ready to cut scattered rays, as the estimate does."""

    def cut(self, x: np.ndarray, y: np.ndarray) -> tuple[Pieces, np.ndarray]:
        """Return the pieces of rays; quickest where rays that follow each other are neighbours in the image.

        Parameters
        ----------
        x, y : (k,) ndarray
            Image coordinates of the rays, mm.

        Returns
        -------
        pieces : Pieces
            Their owners are numbers of trajectories, `GAP` where nothing was from the start.
        passes : (k,) int64
            How many trajectories each ray was examined with.
        """
        near, far, gaps = self.spans(x, y)
        # Beside the stock there is nothing to cut.
        inside = np.flatnonzero(far - near > THINNEST)
        passes = np.zeros(len(x), np.int64)
        x, y, near, far, gaps = x[inside], y[inside], near[inside], far[inside], among(gaps, inside)
        parts = [(np.empty(0, np.int64), np.empty(0, np.int32), np.empty(0), np.empty(0))]
        for first, last, group, item in self._meetings(x, y):
            ray, item = self._pairs(group, item, x[first:last], y[first:last])
            passes[inside[first:last]] = np.bincount(ray, minlength=last - first)
            enter, leave = self.intervals(x[first:last][ray], y[first:last][ray], item)
            own = among(gaps, np.arange(first, last))
            pieces = cut_rays(near[first:last], far[first:last], ray, self.index[item], enter, leave, own)
            parts.append((inside[pieces.ray + first], pieces.owner, pieces.near, pieces.far))
        return Pieces(*(np.concatenate(columns) for columns in zip(*parts))), passes

    def _meetings(self, x: np.ndarray, y: np.ndarray) -> Iterator[tuple[int, int, np.ndarray, np.ndarray]]:
        """Ranges of rays with the groups in them and the trajectories they meet, as many as memory allows."""
        groups = -(-len(x) // GROUP)
        # The last group is filled up with copies of the last ray.
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
        """Rays and trajectories that may meet, sorted by ray, then by trajectory."""
        # One column a group, so that numpy's inner loops run along the pairs; places without a ray meet nothing.
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
