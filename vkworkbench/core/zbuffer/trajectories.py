# SPDX-License-Identifier: LGPL-2.1-or-later
"""A toolpath as the volumes it sweeps, made ready for the rays of one view."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.solids import ConvexStock, Frame, Stock, Tool
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.zbuffer.sweeps import headings, intervals, lowest

# Pairs of ray and trajectory worked on at once, so that they stay in the processor's cache.
_PAIRS_AT_ONCE = 16_384


class Trajectories:
    """The swept volumes of a toolpath that can meet the stock.

    Parameters
    ----------
    toolpath : Toolpath
    tool : Tool
    stock : Stock or ConvexStock
    frame : Frame
        The view of this stock.

    Attributes
    ----------
    index : (m,) int64
        The trajectories that can meet the stock, in order; the others are above it or beside it.
    heading : (4, m) float64
        Direction in the plane, length in the plane and slope of each one, see ``sweeps.headings``.
    box : (4, m) float64
        Left, right, bottom and top of each one's bounding box in the image, mm.
    strip : (4, m) float64
        The strip along each one's image that holds it: its unit normal (x, y) and its two distances from the
        image's centre, mm.
    """

    def __init__(self, toolpath: Toolpath, tool: Tool, stock: Stock | ConvexStock, frame: Frame) -> None:
        self.tool, self.stock, self.frame = tool, stock, frame
        self.sine = float(np.hypot(frame.direction[0], frame.direction[1]))
        self.cosine = float(-frame.direction[2])

        ends = np.asarray(toolpath.points, float)
        start, end = ends[:-1], ends[1:]
        low, high = np.minimum(start, end), np.maximum(start, end)
        reach = np.array([tool.radius, tool.radius, 0])
        self.index = np.flatnonzero(
            (low - reach < stock.upper).all(axis=1)
            & (high[:, :2] + tool.radius > stock.lower[:2]).all(axis=1)
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
        self.heading = headings(self.move)
        self.box = self.boxes(self.start, self.start + self.move)
        self.strip = self._strips()

    def boxes(self, first: np.ndarray, last: np.ndarray) -> np.ndarray:
        """Bounds in the image of what moves from `first` to `last` (3, k) sweep: left, right, bottom, top (4, k), mm."""
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

    def passing(self, x: np.ndarray, y: np.ndarray, item: np.ndarray) -> np.ndarray:
        """Where a ray of `x`, `y` (k,) lies within its trajectory's bounding box and strip, bool of their shape."""
        left, right, bottom, top = self.box.take(item, axis=1)
        nx, ny, low, high = self.strip.take(item, axis=1)
        across = nx * x + ny * y
        return (left <= x) & (x <= right) & (bottom <= y) & (y <= top) & (low <= across) & (across <= high)

    def intervals(self, x: np.ndarray, y: np.ndarray, item: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Depths at which rays enter and leave the volumes swept, one ray and one position in `index` each.

        Parameters
        ----------
        x, y : (k,) ndarray
            Image coordinates of the rays, mm.
        item : (k,) ndarray of int

        Returns
        -------
        near, far : (k,) ndarray
            Depths, mm, unbounded where they are; ``near > far`` where a ray misses.
        """
        near, far = np.empty(len(item)), np.empty(len(item))
        for begin in range(0, len(item), _PAIRS_AT_ONCE):
            part = slice(begin, begin + _PAIRS_AT_ONCE)
            near[part], far[part] = self._intervals(x[part], y[part], item[part])
        return near, far

    def _intervals(self, x: np.ndarray, y: np.ndarray, item: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        start = self.start.take(item, axis=1)
        if self.sine == 0:
            height = lowest(self.tool, start, self.heading.take(item, axis=1), x, self.cosine * y)
            everywhere = np.full(len(x), np.inf)
            return (-everywhere, -height) if self.cosine > 0 else (height, everywhere)
        move = self.move.take(item, axis=1)
        ray = np.array([x, self.cosine * y, self.sine * y])
        return intervals(self.tool, start, move, ray, self.sine, self.cosine)
