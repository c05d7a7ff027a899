# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the segments that selected trajectories remove from closely spaced rays.

The rays are the pixels of an image of the whole stock. The image of the whole stock can have billions of pixels, so
only the tiles along the chosen trajectories are cut. Each tile is cut by all trajectories up to the last chosen
trajectory.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import ceil, cos, log2, sin

import numpy as np

from vkworkbench.core.stocks import Solid
from vkworkbench.core.tool import Tool
from vkworkbench.core.view import Frame, View
from vkworkbench.core.zbuffer.culling.tiles import TILE, Tiles, divided, first_tiles
from vkworkbench.core.zbuffer.culling.upright import Upright
from vkworkbench.core.zbuffer.findings.removed_segments import RemovedSegments, joined
from vkworkbench.core.zbuffer.rays.chains import cut_rays, gaps_of
from vkworkbench.core.zbuffer.rays.dexels import THINNEST, beginnings
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts
from vkworkbench.core.zbuffer.sweeps.trajectories import Trajectories

# Number of rays across the width of a tool at the height of the stock's top.
RAYS_ACROSS = 8
# _TOGETHER: largest total length of the moves in one batch, as a multiple of the tools' half widths. _MOVES: largest
# number of moves in one batch. With larger batches, a check exceeds its time limit by more, because the elapsed time is
# checked only between batches. With smaller batches, a check takes longer in total.
_TOGETHER, _MOVES = 4000.0, 256
_BLOCKS = 16  # number of batches of small tiles after which the removed segments of rays are yielded


class FineRays:
    """Closely spaced vertical rays through a stock.

    Parameters
    ----------
    cuts : Cuts
    stock : Solid
    pixel : float
        Distance between neighbouring rays, mm.
    turn : float
        Angle between the rows of rays and the X axis, rad.
    """

    def __init__(self, cuts: Cuts, stock: Solid, pixel: float, turn: float = 0.0) -> None:
        above = View((0.0, 0.0, -1.0), 1, 1, pixel).frame(stock)
        right, up = np.array([cos(turn), sin(turn), 0.0]), np.array([-sin(turn), cos(turn), 0.0])
        extent = stock.upper - stock.lower
        width, height = (ceil(float(np.abs(axis) @ extent) / pixel) for axis in (right, up))
        frame = Frame(above.centre, right, up, above.direction, pixel, width, height)
        self.trajectories = Trajectories(cuts, stock, frame)
        self._bounds = Upright(self.trajectories)
        self._wanted = np.zeros(len(self.trajectories.index), bool)

    def removed_by(
        self, chosen: np.ndarray, half_width: np.ndarray, going_on: Callable[[], None]
    ) -> Iterator[RemovedSegments]:
        """Yield the segments that the chosen trajectories remove.

        Parameters
        ----------
        chosen : (k,) ndarray of int
            Numbers of the chosen trajectories, ascending.
        half_width : (k,) ndarray
            Half the width, mm, of the strip along each chosen trajectory in which rays are cut.
        going_on : callable
            Called many times a second. An exception raised by `going_on` ends the work.
        """
        trajectories = self.trajectories
        item = np.searchsorted(trajectories.index, chosen)
        item[item == len(trajectories.index)] = 0
        met = trajectories.index[item] == chosen if len(trajectories.index) else np.zeros(len(chosen), bool)
        if not met.any():
            return
        self._wanted[:] = False
        self._wanted[item[met]] = True
        yield from self._removed_in(self._tiles_along(item[met], half_width[met]), self._needed, going_on)

    def removed_near(
        self, marked: np.ndarray, frame: Frame, chosen: np.ndarray, going_on: Callable[[], None]
    ) -> Iterator[RemovedSegments]:
        """Yield the segments that the chosen trajectories remove in the marked pixels of an image with larger pixels.

        Parameters
        ----------
        marked : (height, width) bool
            Whether each pixel of the image with larger pixels is marked.
        frame : Frame
            Axes, centre and pixel of the image with larger pixels, which is a view from above.
        chosen : (n,) bool
            Whether each trajectory is chosen.
        going_on : callable
            Called many times a second. An exception raised by `going_on` ends the work.
        """
        self._wanted[:] = chosen[self.trajectories.index]
        own = self.trajectories.frame
        is_marked = _Marked(marked, frame, own)
        columns, rows = (np.arange(0, size, TILE) for size in (own.width, own.height))
        column, row = np.tile(columns, len(rows)), np.repeat(rows, len(columns))
        used = is_marked(column, row, TILE)
        tiles = first_tiles(self.trajectories, TILE, column[used], row[used])

        def needed(tiles: Tiles) -> Tiles:
            return self._needed(tiles.selected(is_marked(tiles.column, tiles.row, tiles.side)))

        yield from self._removed_in(tiles, needed, going_on)

    def _removed_in(
        self, tiles: Tiles, needed: Callable[[Tiles], Tiles], going_on: Callable[[], None]
    ) -> Iterator[RemovedSegments]:
        found = []
        for small, _ in divided(self.trajectories, self._bounds, tiles, needed):
            going_on()
            found.append(self._cut(small))
            if len(found) == _BLOCKS:
                yield joined(found)
                found = []
        if found:
            yield joined(found)

    def forget(self, trajectories: np.ndarray) -> None:
        """Stop yielding the segments that the given trajectories (k,) remove."""
        self._wanted[np.searchsorted(self.trajectories.index, trajectories)] = False

    def _tiles_along(self, item: np.ndarray, half_width: np.ndarray) -> Tiles:
        """Return the tiles on the strips along the moves `item` (k,), with the trajectories that can meet each tile."""
        frame = self.trajectories.frame
        # The side of a tile is at least eight times the half width of the strip along the move. Therefore the tiles at
        # the four corners of a square around a point of the move are all tiles that the strip meets near this point.
        side = max(TILE, 2 ** ceil(log2(8 * half_width.max() / frame.pixel)))
        start, move = self.trajectories.start[:, item], self.trajectories.move[:, item]
        size = side * frame.pixel
        steps = np.ceil(2 * np.hypot(move[0], move[1]) / size).astype(np.int64) + 1
        own = np.repeat(np.arange(len(item)), steps)
        share = np.arange(len(own)) - np.repeat(np.cumsum(steps) - steps, steps)
        share = share / np.maximum(steps[own] - 1, 1)
        reach = half_width[own] + size / 4
        corners = []
        for across in (-reach, reach):
            for up in (-reach, reach):
                x, y = start[0, own] + share * move[0, own] + across, start[1, own] + share * move[1, own] + up
                corners.append(
                    (np.floor(x / size + frame.width / side / 2), np.floor(y / size + frame.height / side / 2))
                )
        column, row = (np.concatenate(one) for one in zip(*corners))
        columns, rows = -(-frame.width // side), -(-frame.height // side)
        inside = (column >= 0) & (column < columns) & (row >= 0) & (row < rows)
        number = np.unique(row[inside].astype(np.int64) * columns + column[inside].astype(np.int64))
        row, column = np.divmod(number, columns)
        return first_tiles(self.trajectories, side, column * side, row * side)

    def _needed(self, tiles: Tiles) -> Tiles:
        """Return the tiles that a trajectory whose segments are still to be yielded (a wanted trajectory) can cut.

        From the list of each tile, the trajectories after the last wanted trajectory are dropped.
        """
        at = np.flatnonzero(self._wanted[tiles.item])
        end = tiles.first[:-1].copy()
        end[np.searchsorted(tiles.first, at, side="right") - 1] = at + 1
        count, used = end - tiles.first[:-1], end > tiles.first[:-1]
        kept = np.arange(len(tiles.item)) < np.repeat(end, np.diff(tiles.first))
        first = np.append(0, np.cumsum(count[used]))
        return Tiles(tiles.side, tiles.column[used], tiles.row[used], first, tiles.item[kept])

    def _cut(self, tiles: Tiles) -> RemovedSegments:
        """Cut the rays of small tiles; return the segments that the wanted trajectories remove."""
        trajectories, frame = self.trajectories, self.trajectories.frame
        shape = tiles.side, tiles.side, len(tiles.column)
        column, row = tiles.pixels()
        x, y = frame.pixel_centres(column, row)
        x, y = np.broadcast_to(x, shape).ravel(), np.broadcast_to(y[:, None], shape).ravel()
        near, far, gaps = trajectories.spans(x, y)
        inside, rays = far - near > THINNEST, (tiles.side**2, len(tiles.column))
        first, end = np.where(inside, near, np.inf).reshape(rays), np.where(inside, far, -np.inf).reshape(rays)
        tile = np.repeat(np.arange(len(tiles.column)), np.diff(tiles.first))
        hit, enter, leave = self._bounds.removals(tiles, tile, first, end)
        pixel, pair = np.divmod(hit, max(len(tile), 1))
        number = pixel * len(tiles.column) + tile[pair]
        begin = beginnings(number)
        met = number[begin]
        ray = np.repeat(np.arange(len(begin)), np.diff(begin, append=len(number)))
        if enter is None:
            enter = np.full(len(hit), -np.inf)
        segments = cut_rays(near[met], far[met], ray, tiles.item[pair], enter, leave, gaps_of(gaps, met))
        # Skip gaps in the stock and segments that no trajectory removes.
        cut = np.flatnonzero((segments.owner >= 0) & (segments.owner < len(self._wanted)))
        cut = cut[self._wanted[segments.owner[cut]]]
        own = met[segments.ray[cut]]
        return RemovedSegments(
            frame, trajectories.index[segments.owner[cut]], x[own], y[own], segments.near[cut], segments.far[cut]
        )


def half_widths(tool: Tool, height: np.ndarray) -> np.ndarray:
    """Return half the width of a tool at each height (k,) above its tip, mm."""
    corner = tool.rounding
    if corner:
        below = np.maximum(corner - height, 0.0)
        wide = tool.radius - corner + np.sqrt(corner**2 - np.minimum(below, corner) ** 2)
    elif tool.steepness:
        wide = tool.tip + np.maximum(height, 0.0) / tool.steepness
    else:
        wide = np.full(len(height), tool.radius)
    return np.minimum(wide, tool.radius)


class _Marked:
    """The marked pixels of a coarse image, looked up for tiles of a fine image with the same axes."""

    def __init__(self, marked: np.ndarray, coarse: Frame, fine: Frame) -> None:
        self._coarse, self._fine = coarse, fine
        self._before = np.zeros((coarse.height + 1, coarse.width + 1), np.int64)
        self._before[1:, 1:] = marked.cumsum(axis=0).cumsum(axis=1)
        self._shift = (fine.centre - coarse.centre) @ np.array([coarse.right, coarse.up]).T

    def __call__(self, column: np.ndarray, row: np.ndarray, side: int) -> np.ndarray:
        """Return whether each tile (t,) of the fine image overlaps a marked pixel of the coarse image."""
        fine, coarse = self._fine, self._coarse
        left, right = (self._pixel(column + end, fine.width, coarse.width, self._shift[0]) for end in (0, side))
        bottom, top = (self._pixel(row + end, fine.height, coarse.height, self._shift[1]) for end in (0, side))
        before, right, top = self._before, right + 1, top + 1
        return before[top, right] - before[bottom, right] - before[top, left] + before[bottom, left] > 0

    def _pixel(self, position: np.ndarray, fine: int, coarse: int, shift: float) -> np.ndarray:
        """Return the coarse image's column or row that contains each position (a column or row) of the fine image."""
        away = (position - fine / 2) * self._fine.pixel + shift
        return np.clip(np.floor(away / self._coarse.pixel + coarse / 2), 0, coarse - 1).astype(np.int64)


def parts_of(lengths: np.ndarray) -> Iterator[slice]:
    """Yield batches of consecutive moves with about equal total lengths."""
    first = 0
    ends = np.cumsum(lengths + 1)
    while first < len(lengths):
        before = ends[first - 1] if first else 0.0
        end = int(np.searchsorted(ends, before + _TOGETHER, side="right"))
        end = min(max(end, first + 1), first + _MOVES)
        yield slice(first, end)
        first = end
