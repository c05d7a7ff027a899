# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rays cut by a whole toolpath: the exact work that the simulator and the estimate share."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from zbuffer_reference.dexels import THINNEST, Pieces, cuts_from_the_eye, first_cuts
from zbuffer_reference.sweeps import intervals, lowest

from vkworkbench.core import Stock, Tool, Toolpath

# Neighbouring rays are tested against a trajectory's bounding box together.
GROUP = 16
# Pairs of ray and trajectory held at once, and worked on at once (so that they stay in the processor's
# cache).
_PAIRS_HELD = 1_000_000
_PAIRS_AT_ONCE = 16_384


class Removal:
    """A toolpath made ready to cut the rays of one view.

    Parameters
    ----------
    toolpath : Toolpath
    tool : Tool
    stock : Stock
    frame : Frame
        The view of this stock.

    Attributes
    ----------
    index : (m,) int64
        The trajectories that can meet the stock, in order; the others are above it or beside it.
    box : (4, m) float64
        Left, right, bottom and top of each one's bounding box in the image, mm.
    strip : (4, m) float64
        The strip along each one's image that holds it: its unit normal (x, y) and its two distances from the
        image's centre, mm.
    """

    def __init__(self, toolpath: Toolpath, tool: Tool, stock: Stock, frame) -> None:
        self.tool, self.stock, self.frame = tool, stock, frame
        self.sine = float(np.hypot(frame.direction[0], frame.direction[1]))
        self.cosine = float(-frame.direction[2])

        ends = np.asarray(toolpath.points, float)
        start, end = ends[:-1], ends[1:]
        low, high = np.minimum(start, end), np.maximum(start, end)
        reach = np.array([tool.radius, tool.radius, 0])
        self.index = np.flatnonzero(
            (low - reach < stock.upper).all(axis=1) & (high[:, :2] + tool.radius > stock.lower[:2]).all(axis=1)
        )
        start, end = start[self.index], end[self.index]
        # The tool is unbounded upwards: a vertical move removes what it removes at its lowest point.
        vertical = np.hypot(*(end - start)[:, :2].T) < 1e-6
        bottom = np.where((start[:, 2] < end[:, 2])[:, None], start, end)
        start, end = np.where(vertical[:, None], bottom, start), np.where(vertical[:, None], bottom, end)
        axes = np.array([frame.right, [-frame.right[1], frame.right[0], 0], [0, 0, 1]])
        self.start = axes @ (start - frame.centre).T
        self.move = axes @ (end - start).T
        self.ceiling = float(stock.upper[2] - frame.centre[2])
        self.box = self._boxes()
        self.strip = self._strips()

    def _boxes(self) -> np.ndarray:
        first, last = self.start, self.start + self.move
        low, high = np.minimum(first, last), np.maximum(first, last)
        a, b = self.cosine * low[1], self.cosine * high[1]
        reach = self.tool.radius
        return np.array(
            [
                low[0] - reach,
                high[0] + reach,
                np.minimum(a, b) - abs(self.cosine) * reach + self.sine * low[2],
                np.maximum(a, b) + abs(self.cosine) * reach + self.sine * self.ceiling,
            ]
        )

    def _strips(self) -> np.ndarray:
        across, along = self.move[0], self.cosine * self.move[1] + self.sine * self.move[2]
        length = np.hypot(across, along)
        moving = length > 0
        length = np.where(moving, length, 1)
        nx, ny = np.where(moving, -along / length, 1.0), across / length
        middle = nx * self.start[0] + ny * (self.cosine * self.start[1] + self.sine * self.start[2])
        reach = self.tool.radius * np.hypot(nx, self.cosine * ny)
        depth = self.ceiling - self.start[2] - np.minimum(self.move[2], 0)
        rise = ny * self.sine * np.maximum(depth, 0)
        return np.array([nx, ny, middle - reach + np.minimum(rise, 0), middle + reach + np.maximum(rise, 0)])

    def cut(self, x: np.ndarray, y: np.ndarray, selection: np.ndarray | None = None) -> tuple[Pieces, np.ndarray]:
        """Return the pieces of rays; quickest where rays that follow each other are neighbours in the image.

        Parameters
        ----------
        x, y : (k,) ndarray
            Image coordinates of the rays, mm.
        selection : ndarray of int, optional
            The positions in `index` to cut with, ascending; all by default.

        Returns
        -------
        pieces : Pieces
            Their owners are indices of the toolpath's trajectories.
        passes : (k,) int64
            How many trajectories each ray was examined with.
        """
        near, far = self.stock.chords(self.frame.origins(x, y), self.frame.direction)
        # Beside the stock there is nothing to cut.
        inside = np.flatnonzero(far - near > THINNEST)
        passes = np.zeros(len(x), np.int64)
        x, y, near, far = x[inside], y[inside], near[inside], far[inside]
        parts = [(np.empty(0, np.int64), np.empty(0, np.int32), np.empty(0), np.empty(0))]
        for first, last, group, item in self._meetings(x, y, selection):
            ray, item = self._pairs(group, item, x[first:last], y[first:last])
            passes[inside[first:last]] = np.bincount(ray, minlength=last - first)
            pieces = self._cut_pairs(ray, item, x[first:last], y[first:last], near[first:last], far[first:last])
            parts.append((inside[pieces.ray + first], pieces.owner, pieces.near, pieces.far))
        return Pieces(*(np.concatenate(columns) for columns in zip(*parts))), passes

    def meeting(
        self,
        left: np.ndarray,
        right: np.ndarray,
        bottom: np.ndarray,
        top: np.ndarray,
        selection: np.ndarray | None = None,
    ) -> tuple[np.ndarray, np.ndarray]:
        """Pairs of a rectangle of the image (g,) and a position in `index` that may meet, by rectangle."""
        box = self.box if selection is None else self.box[:, selection]
        rectangle, item = np.nonzero(
            (box[0] <= right[:, None])
            & (box[1] >= left[:, None])
            & (box[2] <= top[:, None])
            & (box[3] >= bottom[:, None])
        )
        if selection is not None:
            item = selection[item]
        nx, ny, low, high = self.strip.take(item, axis=1)
        centre = nx * ((left + right) / 2)[rectangle] + ny * ((bottom + top) / 2)[rectangle]
        reach = np.abs(nx) * ((right - left) / 2)[rectangle] + np.abs(ny) * ((top - bottom) / 2)[rectangle]
        met = np.flatnonzero((centre + reach >= low) & (centre - reach <= high))
        return rectangle[met], item[met]

    def _meetings(
        self, x: np.ndarray, y: np.ndarray, selection: np.ndarray | None
    ) -> Iterator[tuple[int, int, np.ndarray, np.ndarray]]:
        """Ranges of rays with the groups in them and the trajectories they meet, as many as memory allows."""
        groups = -(-len(x) // GROUP)
        # The last group is filled up with copies of the last ray.
        padded = np.minimum(np.arange(groups * GROUP), len(x) - 1).reshape(-1, GROUP)
        gx, gy = x[padded], y[padded]
        group, item = self.meeting(gx.min(axis=1), gx.max(axis=1), gy.min(axis=1), gy.max(axis=1), selection)
        bounds = np.searchsorted(group, np.arange(groups + 1))
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
        rays, hits = [], []
        for begin in range(0, len(group), _PAIRS_AT_ONCE // GROUP):
            groups = group[begin : begin + _PAIRS_AT_ONCE // GROUP]
            items = item[begin : begin + _PAIRS_AT_ONCE // GROUP]
            rx, ry = gx.take(groups, axis=1), gy.take(groups, axis=1)
            left, right, bottom, top = self.box.take(items, axis=1)
            nx, ny, low, high = self.strip.take(items, axis=1)
            across = nx * rx + ny * ry
            met = (left <= rx) & (rx <= right) & (bottom <= ry) & (ry <= top) & (low <= across) & (across <= high)
            member = np.repeat(np.arange(GROUP), np.count_nonzero(met, axis=1))
            pair = np.flatnonzero(met) - member * len(items)
            rays.append(groups[pair] * GROUP + member)
            hits.append(items[pair])
        if not rays:
            return np.empty(0, np.int64), np.empty(0, np.int64)
        ray, hit = np.concatenate(rays), np.concatenate(hits)
        # Radix sort, while there are few rays.
        order = np.argsort(ray.astype(np.uint16) if len(x) < 1 << 16 else ray, kind="stable")
        return ray[order], hit[order]

    def _cut_pairs(
        self,
        ray: np.ndarray,
        item: np.ndarray,
        x: np.ndarray,
        y: np.ndarray,
        near: np.ndarray,
        far: np.ndarray,
    ) -> Pieces:
        enter, leave = np.empty(len(ray)), np.empty(len(ray))
        for begin in range(0, len(ray), _PAIRS_AT_ONCE):
            part = slice(begin, begin + _PAIRS_AT_ONCE)
            enter[part], leave[part] = self._intervals(x[ray[part]], y[ray[part]], item[part])
        enter, leave = np.maximum(enter, near[ray]), np.minimum(leave, far[ray])
        hit = np.flatnonzero(leave - enter > THINNEST)
        hit = hit[_not_yet_open(ray[hit], enter[hit], leave[hit], near, far)]
        ray, trajectory, enter, leave = ray[hit], self.index[item[hit]], enter[hit], leave[hit]
        if self.sine == 0 and self.cosine > 0:
            return cuts_from_the_eye(near, far, ray, trajectory, leave)
        return first_cuts(near, far, ray, trajectory, enter, leave)

    def _intervals(self, x: np.ndarray, y: np.ndarray, item: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        start, move = self.start.take(item, axis=1), self.move.take(item, axis=1)
        if self.sine == 0:
            height = lowest(self.tool, start, move, x, self.cosine * y)
            everywhere = np.full(len(x), np.inf)
            return (-everywhere, -height) if self.cosine > 0 else (height, everywhere)
        ray = np.array([x, self.cosine * y, self.sine * y])
        return intervals(self.tool, start, move, ray, self.sine, self.cosine)


def _not_yet_open(
    ray: np.ndarray, enter: np.ndarray, leave: np.ndarray, near: np.ndarray, far: np.ndarray
) -> np.ndarray:
    """Positions of the intervals that reach deeper than earlier ones opened the ray from its near end.

    Most passes over a pixel cut nothing new; this finds the greater part of them at the price of a running
    maximum.
    """
    if len(ray) == 0:
        return np.empty(0, np.int64)
    bounded = far > near
    stretch = far[bounded].max() - near[bounded].min() + 1
    opened = np.where(enter <= near[ray], leave, near[ray]) + ray * stretch
    before = np.maximum.accumulate(opened)
    deeper = np.ones(len(ray), bool)
    deeper[1:] = (ray[1:] != ray[:-1]) | (leave[1:] + ray[1:] * stretch > before[:-1] + 1e-7)
    return np.flatnonzero(deeper)
