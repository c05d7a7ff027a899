# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the trajectories that can cut each pixel, by hierarchical culling along time.

Greene, Kass and Miller (Hierarchical z-buffer visibility, 1993) drop objects behind an object that covers a whole tile of the
image. Here "behind" becomes "later": a trajectory removes nothing from a tile that earlier trajectories have opened as deep as it
reaches. The image is divided into tiles, and tiles into quarters, down to a few pixels. Each tile has a list of trajectories in the
order of the sequence; a trajectory that is dropped from a tile is also dropped from its quarters. Each step works on whole arrays of
pairs of tile and trajectory, sorted by tile and time. The cost grows with the number of trajectories plus the number of cuts, and
not with their product.

Only pairs that remove nothing are dropped, so the pieces of all rays stay the same.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np

from vkworkbench.core.zbuffer.rays.dexels import before_in_group
from vkworkbench.core.zbuffer.sweeps.trajectories import Trajectories

# Side of the largest tiles, pixels; a power of two.
TILE = 64
# Number of pairs of tile and trajectory in one step, so that they fit into the processor's cache.
PAIRS_AT_ONCE = 65536
# Smallest excess of a reach over the opened depth, mm. A smaller excess is a rounding error.
NOISE = 1e-8


class Bounds(Protocol):
    """Bounds of the depth that a trajectory cuts in a tile, for one kind of view."""

    @property
    def slow(self) -> np.ndarray:
        """(m,) bool ndarray : trajectories for which a bound is as slow as the swept surface itself."""

    def quarters(
        self, column: np.ndarray, row: np.ndarray, tile: np.ndarray, item: np.ndarray, child: int
    ) -> Iterator[np.ndarray]:
        """Find the pairs that may cut each quarter of the tiles.

        Parameters
        ----------
        column, row : (t,) ndarray of int
            First pixel of each tile.
        tile, item : (p,) ndarray of int
            The pairs, sorted by tile and time.
        child : int
            Side of a quarter, pixels.

        Yields
        ------
        (k,) int64
            Positions of the remaining pairs, for each quarter in the order of `QUARTERS`.
        """

    def removals(self, tiles: Tiles, tile: np.ndarray, near: np.ndarray, far: np.ndarray) -> Removals:
        """Find the intervals that trajectories may remove from the rays of small tiles.

        Parameters
        ----------
        tiles : Tiles
        tile : (p,) ndarray of int
            Tile of each pair.
        near, far : (side * side, t) ndarray
            Beginning and end of the stock on the rays of the tiles' pixels, row by row; ``near > far`` for rays that miss
            the stock.
        """


# Column and row of the quarters of a tile.
QUARTERS = ((0, 0), (1, 0), (0, 1), (1, 1))


class Removals(NamedTuple):
    """Intervals that may be removed from rays, sorted by ray and time.

    Attributes
    ----------
    hit : (k,) int64
        Positions in the matrix (pixels of a tile, pairs), row by row.
    enter, leave : (k,) ndarray
        Ends of the intervals, inside the rays, mm. If `enter` is None, all intervals begin at the near end of their rays, and
        each is deeper than the previous ones.
    """

    hit: np.ndarray
    enter: np.ndarray | None
    leave: np.ndarray


@dataclass(frozen=True, eq=False)
class Tiles:
    """Square tiles of the image, each with a list of trajectories that may cut it.

    Attributes
    ----------
    side : int
        Side of the tiles, pixels.
    column, row : (t,) int64
        First pixel of each tile.
    first : (t + 1,) int64
        Beginning of each tile's list.
    item : (p,) int64
        The lists: positions in `Trajectories.index`, ascending.
    """

    side: int
    column: np.ndarray
    row: np.ndarray
    first: np.ndarray
    item: np.ndarray

    def pixels(self) -> tuple[np.ndarray, np.ndarray]:
        """Return columns and rows (side, t) of the tiles' pixels."""
        inner = np.arange(self.side)[:, None]
        return self.column + inner, self.row + inner

    def selected(self, chosen: np.ndarray) -> Tiles:
        """Return the tiles selected by a mask (t,) bool."""
        if chosen.all():
            return self
        count = np.diff(self.first)
        first = np.append(0, np.cumsum(count[chosen]))
        return Tiles(self.side, self.column[chosen], self.row[chosen], first, self.item[np.repeat(chosen, count)])

    def part(self, begin: int, end: int) -> Tiles:
        """Return the tiles begin .. end - 1."""
        first = self.first[begin : end + 1]
        return Tiles(
            self.side, self.column[begin:end], self.row[begin:end], first - first[0], self.item[first[0] : first[-1]]
        )

    def blocks(self, pairs: int) -> Iterator[Tiles]:
        """Yield parts with at most `pairs` pairs, or a single tile."""
        begin = 0
        while begin < len(self.column):
            end = int(np.searchsorted(self.first, self.first[begin] + pairs, side="right")) - 1
            end = max(begin + 1, end)
            yield self.part(begin, end)
            begin = end


class Region(NamedTuple):
    """A part of the image, `TILE` rows high, made of tiles of the largest size (cut at the image's border).

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
    """Yield the small tiles of a part of the image, with the trajectories that may cut them.

    Parameters
    ----------
    trajectories : Trajectories
    bounds : Bounds
        Bounds of the same view.
    region : Region

    Yields
    ------
    tiles : Tiles
        Small tiles, each once; tiles that nothing cuts are left out.
    tested : int
        Number of pairs of a tile or pixel and a trajectory that were tested for these tiles.
    """
    left = np.arange(region.left, region.right, TILE)
    return divided(trajectories, bounds, first_tiles(trajectories, left, np.full(len(left), region.bottom)))


def divided(
    trajectories: Trajectories, bounds: Bounds, tiles: Tiles, needed: Callable[[Tiles], Tiles] = lambda tiles: tiles
) -> Iterator[tuple[Tiles, int]]:
    """Divide tiles, which may lie anywhere in the image, and yield the small tiles as `small_tiles` does.

    Parameters
    ----------
    trajectories : Trajectories
    bounds : Bounds
        Bounds of the same view.
    tiles : Tiles
    needed : callable, optional
        Returns the needed part of tiles: some of the tiles, each with the first trajectories of its list. Called at each level.
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
    """Return whether cutting the pixels of each tile (t,) is faster than dividing the tile, see `Bounds.slow`."""
    if tiles.side != 4:
        return np.full(len(tiles.column), tiles.side < 4)
    running = np.append(0, np.cumsum(slow.take(tiles.item)))
    result: np.ndarray = 2 * np.diff(running.take(tiles.first)) > np.diff(tiles.first)
    return result


def first_tiles(trajectories: Trajectories, left: np.ndarray, bottom: np.ndarray) -> Tiles:
    """Return the largest tiles with first pixels at `left`, `bottom` (t,), and all trajectories that pass through them."""
    frame = trajectories.frame
    x0, y0 = frame.pixel_centres(left, bottom)
    x1, y1 = frame.pixel_centres(np.minimum(left + TILE, frame.width) - 1, np.minimum(bottom + TILE, frame.height) - 1)
    tile, item = trajectories.meeting(x0, x1, y0, y1)
    return Tiles(TILE, left, bottom, np.searchsorted(tile, np.arange(len(left) + 1)), item)


def quartered(trajectories: Trajectories, bounds: Bounds, tiles: Tiles) -> Tiles:
    """Return the quarters of tiles, with the trajectories that may cut them, without quarters that nothing cuts."""
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
    """Return the positions of pairs that reach deeper than earlier pairs have opened their tile.

    Parameters
    ----------
    tile : (p,) ndarray of int
        Tile of each pair, ascending.
    start : (t,) ndarray of int
        First pair of each tile.
    reach, opens : (p,) ndarray
        Largest depth that the trajectory reaches, and the depth to which it opens all rays of the tile from their near
        end; -inf or NaN if it does not. Both are overwritten.
    near, far : float
        Smallest beginning and largest end of the tiles' rays.
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
