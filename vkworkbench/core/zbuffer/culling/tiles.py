# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the trajectories that can cut each pixel, by hierarchical culling in the order of cutting.

Greene, Kass and Miller (Hierarchical z-buffer visibility, 1993) drop each object that is hidden by a nearer object
covering a whole tile of the image. This module drops each trajectory that comes too late: a trajectory removes nothing
from a tile if earlier trajectories have removed all material of the tile down to the depth that the trajectory reaches.
The image is divided into tiles, and the tiles are divided into quarters repeatedly, down to a few pixels. Each tile has
a list of the trajectories that can cut it, in the order in which they are cut. A trajectory that is dropped from a tile
is also dropped from the tile's quarters. Each step computes with arrays of pairs of a tile and a trajectory, sorted by
tile and then by trajectory. The computing time grows with the sum, not with the product, of the number of trajectories
and the number of segments that are removed from rays.

A trajectory opens a ray to a depth if the trajectory removes the stock from the ray's near end to this depth. A
trajectory opens a tile to a depth if the trajectory opens all rays of the tile to this depth. The culling drops only
trajectories that remove nothing from the tile, so the segments of all rays stay the same.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np

from vkworkbench.core.zbuffer.rays.dexels import before_in_group
from vkworkbench.core.zbuffer.sweeps.trajectories import Trajectories

# Side of the largest tiles, pixels. The side must be a power of two, because tiles are halved.
TILE = 64
# Number of pairs of a tile and a trajectory in one batch. The arrays of a larger batch would not fit into the
# processor's cache, and in a smaller batch the overhead of numpy's calls would dominate.
PAIRS_AT_ONCE = 65536
# A trajectory stays in a tile's list only if it reaches deeper, by more than this length, mm, than earlier trajectories
# have cut all rays of the tile. With a smaller length, trajectories that cut nothing would stay because of rounding
# errors. With a larger length, trajectories that remove only a thin layer would be dropped.
NOISE = 1e-8


class Bounds(Protocol):
    """Upper and lower bounds of the depths to which trajectories cut tiles, for vertical views or for oblique views."""

    @property
    def slow(self) -> np.ndarray:
        """Whether computing the bounds of each trajectory takes as long as computing its swept surface, (m,) bool."""

    def quarters(
        self, column: np.ndarray, row: np.ndarray, tile: np.ndarray, item: np.ndarray, child: int
    ) -> Iterator[np.ndarray]:
        """Find, for each quarter of the tiles, the pairs of a tile and a trajectory that can cut this quarter.

        Parameters
        ----------
        column, row : (t,) ndarray of int
            Column and row of each tile's first pixel.
        tile, item : (p,) ndarray of int
            The number of the tile, and the trajectory's position in `Trajectories.index`, of each pair of a tile and a
            trajectory. The pairs are sorted by tile and then by trajectory.
        child : int
            Side of a quarter, pixels.

        Yields
        ------
        (k,) int64
            Positions, in `tile` and `item`, of the pairs whose trajectory can cut the quarter. The quarters have the
            order of `QUARTERS`.
        """

    def removals(self, tiles: Tiles, tile: np.ndarray, near: np.ndarray, far: np.ndarray) -> Removals:
        """Find the intervals that trajectories can remove from the rays of small tiles.

        Parameters
        ----------
        tile : (p,) ndarray of int
            For each pair of a tile and a trajectory, the number of the tile in `tiles`.
        near, far : (side * side, t) ndarray
            Depths at which the rays of the tiles' pixels enter and leave the stock, row by row; ``near > far`` for rays
            that miss the stock.
        """


# Column and row of each quarter of a tile, in units of the quarter's side.
QUARTERS = ((0, 0), (1, 0), (0, 1), (1, 1))


class Removals(NamedTuple):
    """Intervals that trajectories can remove from rays, sorted by ray and then by trajectory.

    Attributes
    ----------
    hit : (k,) int64
        Positions of the intervals, counted row by row, in a matrix in which each row is a pixel of a tile and each
        column is a pair of a tile and a trajectory.
    enter, leave : (k,) ndarray
        Ends of the intervals, clipped to the stock, mm. If `enter` is None, all intervals begin at the near end of
        their rays, and each interval ends deeper than all earlier intervals of its ray.
    """

    hit: np.ndarray
    enter: np.ndarray | None
    leave: np.ndarray


@dataclass(frozen=True, eq=False)
class Tiles:
    """Square tiles of the image, each with a list of the trajectories that can cut the tile.

    Attributes
    ----------
    side : int
        Side of the tiles, pixels.
    column, row : (t,) int64
        Column and row of each tile's first pixel.
    first : (t + 1,) int64
        Position in `item` at which each tile's list begins; the last entry is the end of the last list.
    item : (p,) int64
        The lists of all tiles, one after the other: positions in `Trajectories.index`, ascending within a list.
    """

    side: int
    column: np.ndarray
    row: np.ndarray
    first: np.ndarray
    item: np.ndarray

    def pixels(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the columns (side, t) and the rows (side, t) of the tiles' pixels."""
        inner = np.arange(self.side)[:, None]
        return self.column + inner, self.row + inner

    def selected(self, chosen: np.ndarray) -> Tiles:
        """Return the tiles that the mask `chosen` (t,) bool selects."""
        if chosen.all():
            return self
        count = np.diff(self.first)
        first = np.append(0, np.cumsum(count[chosen]))
        return Tiles(self.side, self.column[chosen], self.row[chosen], first, self.item[np.repeat(chosen, count)])

    def part(self, begin: int, end: int) -> Tiles:
        """Return the tiles with the numbers `begin` to `end` - 1."""
        first = self.first[begin : end + 1]
        return Tiles(
            self.side, self.column[begin:end], self.row[begin:end], first - first[0], self.item[first[0] : first[-1]]
        )

    def blocks(self, pairs: int) -> Iterator[Tiles]:
        """Yield batches of tiles: at most `pairs` pairs of a tile and a trajectory, or one tile with more pairs."""
        begin = 0
        while begin < len(self.column):
            end = int(np.searchsorted(self.first, self.first[begin] + pairs, side="right")) - 1
            end = max(begin + 1, end)
            yield self.part(begin, end)
            begin = end


class Region(NamedTuple):
    """A part of the image, `TILE` rows high, that consists of tiles of the largest size, cut off at the image's border.

    Attributes
    ----------
    left, right : int
        First column, and last column + 1.
    bottom, top : int
        First row, and last row + 1.
    """

    left: int
    right: int
    bottom: int
    top: int


def small_tiles(trajectories: Trajectories, bounds: Bounds, region: Region) -> Iterator[tuple[Tiles, int]]:
    """Yield the small tiles of a part of the image, with the trajectories that can cut each tile.

    Parameters
    ----------
    bounds : Bounds
        Bounds for the view of `trajectories`.

    Yields
    ------
    tiles : Tiles
        Small tiles; each small tile of the region is yielded once. Tiles that no trajectory can cut are not yielded.
    tested : int
        How many times a trajectory was tested against a tile or a pixel to find `tiles`.
    """
    left = np.arange(region.left, region.right, TILE)
    return divided(trajectories, bounds, first_tiles(trajectories, TILE, left, np.full(len(left), region.bottom)))


def divided(
    trajectories: Trajectories, bounds: Bounds, tiles: Tiles, needed: Callable[[Tiles], Tiles] = lambda tiles: tiles
) -> Iterator[tuple[Tiles, int]]:
    """Divide the given tiles, which can be anywhere in the image, and yield small tiles as `small_tiles` does.

    Parameters
    ----------
    bounds : Bounds
        Bounds for the view of `trajectories`.
    needed : callable, optional
        Function that receives tiles of one size and returns the tiles that the caller needs; it can shorten a tile's
        list of trajectories at its end. The function `needed` is called for every size of tiles.
    """
    pending = [tiles]
    tested = 0
    while pending:
        for block in pending.pop().blocks(PAIRS_AT_ONCE):
            block = needed(block)
            fine = are_small(block, bounds.slow)
            if not fine.all():
                coarse = block.selected(~fine)
                tested += 4 * len(coarse.item)
                pending.append(quartered(trajectories, bounds, coarse))
            pixels = block.side**2
            for small in block.selected(fine).blocks(PAIRS_AT_ONCE // pixels):
                yield small, tested + pixels * len(small.item)
                tested = 0


def are_small(tiles: Tiles, slow: np.ndarray) -> np.ndarray:
    """Return whether cutting each tile's pixels is faster than dividing the tile (see `Bounds.slow`), (t,) bool."""
    if tiles.side != 4:
        return np.full(len(tiles.column), tiles.side < 4)
    running = np.append(0, np.cumsum(slow.take(tiles.item)))
    return 2 * np.diff(running.take(tiles.first)) > np.diff(tiles.first)


def first_tiles(trajectories: Trajectories, side: int, left: np.ndarray, bottom: np.ndarray) -> Tiles:
    """Return tiles with the first pixels `left`, `bottom` (t,), and the trajectories that can meet each tile."""
    frame = trajectories.frame
    x0, y0 = frame.pixel_centres(left, bottom)
    x1, y1 = frame.pixel_centres(np.minimum(left + side, frame.width) - 1, np.minimum(bottom + side, frame.height) - 1)
    tile, item = trajectories.meeting(x0, x1, y0, y1)
    return Tiles(side, left, bottom, np.searchsorted(tile, np.arange(len(left) + 1)), item)


def quartered(trajectories: Trajectories, bounds: Bounds, tiles: Tiles) -> Tiles:
    """Return the quarters of tiles that at least one trajectory can cut, each with the trajectories that can cut it."""
    frame, side = trajectories.frame, tiles.side // 2
    tile = np.repeat(np.arange(len(tiles.column)), np.diff(tiles.first))
    columns, rows, counts, items = [], [], [], []
    for (across, up), kept in zip(QUARTERS, bounds.quarters(tiles.column, tiles.row, tile, tiles.item, side)):
        column, row = tiles.column + across * side, tiles.row + up * side
        outside = (column >= frame.width) | (row >= frame.height)
        if outside.any():
            kept = kept[~outside[tile[kept]]]
        count = np.bincount(tile[kept], minlength=len(tiles.column))
        used = np.flatnonzero(count)
        columns.append(column[used])
        rows.append(row[used])
        counts.append(count[used])
        items.append(tiles.item[kept])
    first = np.append(0, np.cumsum(np.concatenate(counts)))
    return Tiles(side, np.concatenate(columns), np.concatenate(rows), first, np.concatenate(items))


def deeper_pairs(
    tile: np.ndarray, start: np.ndarray, reach: np.ndarray, opens: np.ndarray, near: float, far: float
) -> np.ndarray:
    """Return the pairs whose trajectory reaches deeper than earlier trajectories have cut the whole tile.

    Parameters
    ----------
    tile : (p,) ndarray of int
        Tile of each pair of a tile and a trajectory, ascending.
    start : (t,) ndarray of int
        Position of each tile's first pair of a tile and a trajectory.
    reach, opens : (p,) ndarray
        Largest depth that each pair's trajectory reaches in its tile, and the depth to which the trajectory opens all
        rays of the tile from their near end. A `reach` of -inf or NaN means that the trajectory does not meet the tile,
        and an `opens` of -inf or NaN means that the trajectory does not open the tile. The function overwrites `reach`
        and `opens`.
    near, far : float
        Smallest depth at which a ray of the tiles enters the stock, and largest depth at which a ray leaves it, mm.
    """
    stretch = far - near + 1
    np.minimum(np.fmax(opens, near, out=opens), far, out=opens)
    np.minimum(reach, far, out=reach)
    offset = tile * stretch
    opens += offset
    reach -= NOISE
    reach += offset
    before = before_in_group(np.maximum.accumulate(opens), start, offset[start] + near)
    return np.flatnonzero(reach > before)
