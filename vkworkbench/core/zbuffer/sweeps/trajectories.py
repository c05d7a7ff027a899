# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prepare the swept volumes of trajectories for the rays of one view."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np

from vkworkbench.core.solids import SMALLEST, Spans
from vkworkbench.core.stocks import Solid, spans_in
from vkworkbench.core.tool import Tool
from vkworkbench.core.view import Frame
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts
from vkworkbench.core.zbuffer.sweeps.intervals import headings, intervals, lowest

# Largest height difference between the ends of a level move, mm. With a smaller limit, level moves with rounding errors
# would count as sloped, and a sloped move takes ten times as long to simulate. With a larger limit, moves that really
# slope would be simulated as level.
_LEVEL = 1e-9
# Number of trajectories, or of pairs of a trajectory and a ray, in one batch. The arrays of a larger batch would not
# fit into the processor's cache, and in a smaller batch the overhead of numpy's calls would dominate.
AT_ONCE = 16_384
# Number of pairs of a trajectory and a rectangle of the image that are compared in one batch. With a larger number of
# pairs, each batch would need more memory.
_PAIRS_HELD = 1_000_000


class Kind(NamedTuple):
    """The tool of trajectories that are computed in one batch, and whether their moves are level."""

    tool: Tool
    level: bool


class Trajectories:
    """The swept volumes of the trajectories that can meet the stock.

    Parameters
    ----------
    cuts : Cuts
    stock : Solid
    frame : Frame
        The view, fitted to the stock.

    Attributes
    ----------
    index : (m,) int64
        The numbers of the trajectories that can meet the stock, ascending.
    kinds : tuple of Kind
        All different combinations of a tool with level moves or with sloped moves. A vertical move is replaced by its
        lowest point and counts as level.
    kind : (m,) int64
        Index in `kinds` of each trajectory's kind.
    tools : tuple of Tool
        The different tools.
    tool : (m,) int64
        Index in `tools` of each trajectory's tool.
    heading : (4, m) float64
        Direction in the xy plane (x, y), length in the xy plane and slope of each trajectory, see
        ``intervals.headings``.
    box : (4, m) float64
        Left, right, bottom and top of each trajectory's bounding box in the image, mm.
    strip : (4, m) float64
        The straight strip of the image that contains each swept volume, given by the strip's unit normal (x, y) and the
        signed distances, mm, from the image's centre to its two borders, the smaller distance first.
    """

    def __init__(self, cuts: Cuts, stock: Solid, frame: Frame) -> None:
        self.stock, self.frame = stock, frame
        self.sine = float(np.hypot(frame.direction[0], frame.direction[1]))
        self.cosine = float(-frame.direction[2])

        radius = np.array([cut.tool.radius for cut in cuts.cuts])
        met = [
            passes_over(start, end, radius[cut], stock) & (np.minimum(start[:, 2], end[:, 2]) < stock.upper[2])
            for cut, start, end in cuts.blocks(AT_ONCE)
        ]
        self.index = np.flatnonzero(np.concatenate((np.empty(0, bool), *met)))
        self.radius = radius[cuts.cut[self.index]]
        m = len(self.index)
        self.start, self.move = np.empty((2, 3, m))
        self.heading, self.box, self.strip = np.empty((3, 4, m))
        self.ceiling = float(stock.upper[2] - frame.centre[2])
        axes = np.array([frame.right, [-frame.right[1], frame.right[0], 0], [0, 0, 1]])
        filled = 0
        for (_, start, end), chosen in zip(cuts.blocks(AT_ONCE), met):
            start, end = as_cut(start[chosen], end[chosen])
            part = slice(filled, filled + len(start))
            self.start[:, part] = axes @ (start - frame.centre).T
            self.move[:, part] = axes @ (end - start).T
            self.heading[:, part] = headings(self.move[:, part])
            self.box[:, part] = self.boxes(np.arange(part.start, part.stop), 0.0, 1.0)
            self.strip[:, part] = self._strips(part)
            filled = part.stop
        self.kinds, self.kind = self._kinds(cuts)
        self.tools = tuple(dict.fromkeys(kind.tool for kind in self.kinds))
        self.tool = np.array([self.tools.index(kind.tool) for kind in self.kinds], np.int64)[self.kind]

    def _kinds(self, cuts: Cuts) -> tuple[tuple[Kind, ...], np.ndarray]:
        tools = list(dict.fromkeys(cut.tool for cut in cuts.cuts))
        of_cut = np.array([tools.index(cut.tool) for cut in cuts.cuts], np.int64)
        number = 2 * of_cut[cuts.cut[self.index]] + (self.move[2] == 0)
        # Use np.bincount, because sorting a million trajectories with np.unique would dominate the time of this
        # function.
        found = np.flatnonzero(np.bincount(number))
        place = np.zeros(2 * len(tools), np.int64)
        place[found] = np.arange(len(found))
        return tuple(Kind(tools[n // 2], bool(n % 2)) for n in found), place[number]

    @cached_property
    def spans(self) -> Callable[[np.ndarray, np.ndarray], Spans]:
        """The function that returns where rays at the image coordinates x (k,), y (k,) are inside the stock."""
        return spans_in(self.stock, self.frame)

    def by_kind(self, item: np.ndarray) -> Iterator[tuple[int, slice | np.ndarray]]:
        """Group the trajectories `item` (k,) by kind; yield each kind and the places of its trajectories in `item`."""
        return _divided(self.kind, len(self.kinds), item)

    def by_tool(self, item: np.ndarray) -> Iterator[tuple[Tool, slice | np.ndarray]]:
        """Group the trajectories `item` (k,) by tool; yield each tool and the places of its trajectories in `item`."""
        return ((self.tools[number], own) for number, own in _divided(self.tool, len(self.tools), item))

    def boxes(self, item: np.ndarray, begin: np.ndarray | float, end: np.ndarray | float) -> np.ndarray:
        """Return the bounding boxes, in the image, of parts of moves: left, right, bottom and top (4, k), mm.

        Parameters
        ----------
        item : (k,) ndarray of int
            Positions in `index`.
        begin, end : (k,) ndarray or float
            Positions on the move at which each part begins and ends, from 0 to 1.
        """
        start, move, reach = self.start.take(item, axis=1), self.move.take(item, axis=1), self.radius.take(item)
        first, last = start + begin * move, start + end * move
        low, high = np.minimum(first, last), np.maximum(first, last)
        a, b = self.cosine * low[1], self.cosine * high[1]
        return np.array(
            [
                low[0] - reach,
                high[0] + reach,
                np.minimum(a, b) - abs(self.cosine) * reach + self.sine * low[2],
                np.maximum(a, b) + abs(self.cosine) * reach + self.sine * self.ceiling,
            ]
        )

    def _strips(self, part: slice) -> np.ndarray:
        """Return the columns of `strip`, (4, k), for a range of positions in `index`."""
        start, move, radius = self.start[:, part], self.move[:, part], self.radius[part]
        across, along = move[0], self.cosine * move[1] + self.sine * move[2]
        length = np.hypot(across, along)
        moving = length > 0
        length = np.where(moving, length, 1)
        nx, ny = np.where(moving, -along / length, 1.0), across / length
        middle = nx * start[0] + ny * (self.cosine * start[1] + self.sine * start[2])
        reach = radius * np.hypot(nx, self.cosine * ny)
        depth = self.ceiling - start[2] - np.minimum(move[2], 0)
        rise = ny * self.sine * np.maximum(depth, 0)
        return np.array([nx, ny, middle - reach + np.minimum(rise, 0), middle + reach + np.maximum(rise, 0)])

    def meeting(
        self, left: np.ndarray, right: np.ndarray, bottom: np.ndarray, top: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the pairs of a rectangle (g,) and a trajectory (position in `index`) that can meet, by rectangle."""
        pairs = [(np.empty(0, np.int64), np.empty(0, np.int64))]
        few = max(1, _PAIRS_HELD // max(1, len(self.index)))
        for begin in range(0, len(left), few):
            some = slice(begin, begin + few)
            rectangle, item = self._meeting(left[some], right[some], bottom[some], top[some])
            pairs.append((rectangle + begin, item))
        rectangle, item = (np.concatenate(columns) for columns in zip(*pairs))
        return rectangle, item

    def _meeting(
        self, left: np.ndarray, right: np.ndarray, bottom: np.ndarray, top: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        box = self.box
        rectangle, item = np.nonzero(
            (box[0] <= right[:, None])
            & (box[1] >= left[:, None])
            & (box[2] <= top[:, None])
            & (box[3] >= bottom[:, None])
        )
        nx, ny, low, high = self.strip.take(item, axis=1)
        centre = nx * ((left + right) / 2)[rectangle] + ny * ((bottom + top) / 2)[rectangle]
        reach = np.abs(nx) * ((right - left) / 2)[rectangle] + np.abs(ny) * ((top - bottom) / 2)[rectangle]
        met = np.flatnonzero((centre + reach >= low) & (centre - reach <= high))
        return rectangle[met], item[met]

    def passing(self, x: np.ndarray, y: np.ndarray, item: np.ndarray) -> np.ndarray:
        """Return whether each ray at `x`, `y` is inside the bounding box and the strip of its trajectory."""
        left, right, bottom, top = self.box.take(item, axis=1)
        nx, ny, low, high = self.strip.take(item, axis=1)
        across = nx * x + ny * y
        return (left <= x) & (x <= right) & (bottom <= y) & (y <= top) & (low <= across) & (across <= high)

    def intervals(
        self, x: np.ndarray, y: np.ndarray, item: np.ndarray, tools: Sequence[tuple[Tool | None, float]] | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the depths at which rays enter and leave the swept volumes.

        Parameters
        ----------
        x, y : ndarray
            Image coordinates of the rays, mm. The shapes of both arrays broadcast with each other and with (k,).
        item : (k,) ndarray of int
            Positions in `index`.
        tools : sequence of (Tool or None, float), optional
            For each kind, a tool that replaces the kind's tool, and the height of the replacement's tip above the tip
            of the kind's tool, mm. If the replacement is None, no ray meets the swept volumes of this kind.

        Returns
        -------
        near, far : ndarray
            Depths, mm, some of which are infinite; ``near > far``, or NaN, for a ray that misses the swept volume.
        """
        if tools is None:
            tools = [(kind.tool, 0.0) for kind in self.kinds]
        near, far = np.empty((2, *np.broadcast(x, y).shape))
        for begin in range(0, len(item), AT_ONCE):
            part = slice(begin, begin + AT_ONCE)
            px, py, own_item, own_near, own_far = (
                x[..., part],
                y[..., part],
                item[part],
                near[..., part],
                far[..., part],
            )
            for number, own in self.by_kind(own_item):
                tool, raised = tools[number]
                if tool is None:
                    own_near[..., own], own_far[..., own] = np.inf, -np.inf
                    continue
                own_near[..., own], own_far[..., own] = self._of_tool(
                    tool, raised, px[..., own], py[..., own], own_item[own]
                )
        return near, far

    def _of_tool(
        self, tool: Tool, raised: float, x: np.ndarray, y: np.ndarray, item: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        start = self.start.take(item, axis=1)
        start[2] += raised
        if self.sine == 0:
            opened = -lowest(tool, start, self.heading.take(item, axis=1), x, self.cosine * y)[0]
            everywhere = np.full(opened.shape, np.inf)
            return (-everywhere, opened) if self.cosine > 0 else (-opened, everywhere)
        return intervals(
            tool, start, self.move.take(item, axis=1), (x, self.cosine * y, self.sine * y), self.sine, self.cosine
        )


def passes_over(start: np.ndarray, end: np.ndarray, radius: np.ndarray | float, solid: Solid) -> np.ndarray:
    """Return whether, seen from above, the bounding box of each move meets the bounding box of a solid, (k,) bool.

    The tools with the radii `radius` (k,) move from `start` to `end` (k, 3).
    """
    start, end, radius = start[:, :2], end[:, :2], np.reshape(radius, (-1, 1))
    low, high = np.minimum(start, end) - radius, np.maximum(start, end) + radius
    return ((low < solid.upper[:2]) & (high > solid.lower[:2])).all(axis=1)


def as_cut(start: np.ndarray, end: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the start and end points with which trajectories from `start` to `end` are simulated, (n, 3) mm."""
    # The tool is unbounded upwards, so a vertical move removes exactly what the tool removes at the move's lowest
    # point.
    vertical = np.hypot(*(end - start)[:, :2].T) < SMALLEST
    bottom = np.where((start[:, 2] < end[:, 2])[:, None], start, end)
    start, end = np.where(vertical[:, None], bottom, start), np.where(vertical[:, None], bottom, end)
    # Remove slopes that are rounding errors, because a level move takes a tenth of the time of a sloped move.
    end[:, 2] = np.where(np.abs(end[:, 2] - start[:, 2]) < _LEVEL, start[:, 2], end[:, 2])
    return start, end


def _divided(group: np.ndarray, groups: int, item: np.ndarray) -> Iterator[tuple[int, slice | np.ndarray]]:
    """Yield the number of each group that occurs among `item` (k,), and the positions in `item` of its elements."""
    if groups == 1:
        yield 0, slice(None)
        return
    group = group.take(item)
    counts = np.bincount(group, minlength=groups)
    for number in np.flatnonzero(counts).tolist():
        yield number, slice(None) if counts[number] == len(item) else np.flatnonzero(group == number)
