# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which trajectories can cut which pixels: hierarchical culling along time.

Greene, Kass and Miller (Hierarchical z-buffer visibility, 1993) drop what lies behind what covers a whole tile of the
image. Here "behind" is "later": a trajectory removes nothing from a tile that earlier ones opened as deep as it
reaches. The image is divided into tiles, these into quarters, down to a few pixels; a tile's trajectories are a list in
their order, and what is dropped from it is gone for all its quarters. Each step works on whole arrays of pairs of a
tile and a trajectory, sorted by tile and time. The cost grows with the trajectories and with what is cut, not with
their product.

Only pairs that remove nothing are dropped: what is left gives the same pieces of every ray.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np

from vkworkbench.core.zbuffer.rays.dexels import before_in_group
from vkworkbench.core.zbuffer.sweeps.trajectories import Trajectories

# Side of the tiles to begin with, pixels; a power of two.
TILE = 64
# Pairs of tile and trajectory worked on at once, so that they stay in the processor's cache.
PAIRS_AT_ONCE = 65536
# A reach that exceeds what is open by less than this, mm, is rounding noise.
NOISE = 1e-8


class Bounds(Protocol):
    """What one kind of view knows of a trajectory above a tile."""

    @property
    def slow(self) -> np.ndarray:
        """(m,) bool ndarray : the trajectories whose bounds take as long as the surface of what they sweep."""

    def quarters(
        self, column: np.ndarray, row: np.ndarray, tile: np.ndarray, item: np.ndarray, child: int
    ) -> Iterator[np.ndarray]:
        """Say for each quarter of the tiles which pairs may cut it.

        Parameters
        ----------
        column, row : (t,) ndarray of int
            The tiles' first pixels.
        tile, item : (p,) ndarray of int
            The pairs, sorted by tile and time.
        child : int
            Side of a quarter, pixels.

        Yields
        ------
        (k,) int64
            Positions of the pairs that stay; for the quarters in the order of `QUARTERS`.
        """

    def removals(self, tiles: Tiles, tile: np.ndarray, near: np.ndarray, far: np.ndarray) -> Removals:
        """Say what trajectories may remove from the rays of tiles that are fine enough.

        Parameters
        ----------
        tiles : Tiles
        tile : (p,) ndarray of int
            Tile of each pair.
        near, far : (side * side, t) ndarray
            Where the stock begins and ends on the rays of the tiles' pixels, row by row; ``near > far`` where nothing is
            to be cut.
        """


# Column and row of a tile's quarters, in quarters.
QUARTERS = ((0, 0), (1, 0), (0, 1), (1, 1))


class Removals(NamedTuple):
    """What may be removed from rays, sorted by ray and time.

    Attributes
    ----------
    hit : (k,) int64
        Positions in the matrix (pixels of a tile, pairs), row by row.
    enter, leave : (k,) ndarray
        Depths between which it is removed, within the ray, mm. Without `enter` all of it begins at the near end of its ray, and each
        reaches deeper than those before it.
    """

    hit: np.ndarray
    enter: np.ndarray | None
    leave: np.ndarray


@dataclass(frozen=True, eq=False)
class Tiles:
    """Square tiles of the image, each with the trajectories that may cut it.

    Attributes
    ----------
    side : int
        Pixels.
    column, row : (t,) int64
        Their first pixels.
    first : (t + 1,) int64
        Where each one's list begins.
    item : (p,) int64
        The lists: positions in `Trajectories.index`, ascending.
    """

    side: int
    column: np.ndarray
    row: np.ndarray
    first: np.ndarray
    item: np.ndarray

    def pixels(self) -> tuple[np.ndarray, np.ndarray]:
        """Columns and rows (side, t) of their pixels."""
        inner = np.arange(self.side)[:, None]
        return self.column + inner, self.row + inner

    def only(self, these: np.ndarray) -> Tiles:
        """Return those of `these` (t,) bool."""
        if these.all():
            return self
        count = np.diff(self.first)
        first = np.append(0, np.cumsum(count[these]))
        return Tiles(self.side, self.column[these], self.row[these], first, self.item[np.repeat(these, count)])

    def part(self, begin: int, end: int) -> Tiles:
        """Return the tiles from `begin` to before `end`."""
        first = self.first[begin : end + 1]
        return Tiles(
            self.side, self.column[begin:end], self.row[begin:end], first - first[0], self.item[first[0] : first[-1]]
        )

    def blocks(self, pairs: int) -> Iterator[Tiles]:
        """Divide them into parts of so many pairs, as far as whole tiles allow."""
        begin = 0
        while begin < len(self.column):
            end = int(np.searchsorted(self.first, self.first[begin] + pairs, side="right")) - 1
            end = max(begin + 1, end)
            yield self.part(begin, end)
            begin = end


class Region(NamedTuple):
    """A part of the image, of whole tiles of the largest size as far as the image goes, `TILE` rows high.

    Attributes
    ----------
    left, right : int
        Its first column and the one behind its last.
    bottom, top : int
        Its first row and the one behind its last.
    """

    left: int
    right: int
    bottom: int
    top: int


def culled(trajectories: Trajectories, bounds: Bounds, region: Region) -> Iterator[tuple[Tiles, int]]:
    """Go down from tiles to pixels, over a part of the image.

    Parameters
    ----------
    trajectories : Trajectories
    bounds : Bounds
        Of the same view.
    region : Region

    Yields
    ------
    tiles : Tiles
        Fine enough, with the trajectories that may cut them; each one once, those that nothing cuts left out.
    tested : int
        Pairs of a tile or pixel and a trajectory that were tested for it.
    """
    left = np.arange(region.left, region.right, TILE)
    pending = [first_tiles(trajectories, left, np.full(len(left), region.bottom))]
    tested = 0
    while pending:
        for block in pending.pop().blocks(PAIRS_AT_ONCE):
            fine = fine_enough(block, bounds.slow)
            if not fine.all():
                coarse = block.only(~fine)
                tested += 4 * len(coarse.item)
                pending.append(quartered(trajectories, bounds, coarse))
            pixels = block.side**2
            for small in block.only(fine).blocks(PAIRS_AT_ONCE // pixels):
                yield small, tested + pixels * len(small.item)
                tested = 0


def fine_enough(tiles: Tiles, slow: np.ndarray) -> np.ndarray:
    """Say of which tiles (t,) cutting the pixels one by one is quicker than dividing them further: see `Bounds.slow`."""
    if tiles.side != 4:
        return np.full(len(tiles.column), tiles.side < 4)
    running = np.append(0, np.cumsum(slow.take(tiles.item)))
    result: np.ndarray = 2 * np.diff(running.take(tiles.first)) > np.diff(tiles.first)
    return result


def first_tiles(trajectories: Trajectories, left: np.ndarray, bottom: np.ndarray) -> Tiles:
    """Return the largest tiles whose first pixels are at `left`, `bottom` (t,), with all trajectories that pass them."""
    frame = trajectories.frame
    x0, y0 = frame.pixel_centres(left, bottom)
    x1, y1 = frame.pixel_centres(np.minimum(left + TILE, frame.width) - 1, np.minimum(bottom + TILE, frame.height) - 1)
    tile, item = trajectories.meeting(x0, x1, y0, y1)
    return Tiles(TILE, left, bottom, np.searchsorted(tile, np.arange(len(left) + 1)), item)


def quartered(trajectories: Trajectories, bounds: Bounds, tiles: Tiles) -> Tiles:
    """Return the quarters of tiles that something may cut, each with the trajectories that may cut it."""
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


def deeper(
    tile: np.ndarray, start: np.ndarray, reach: np.ndarray, opens: np.ndarray, near: float, far: float
) -> np.ndarray:
    """Positions of the pairs that reach deeper than the pairs of their tile before them opened it.

    Parameters
    ----------
    tile : (p,) ndarray of int
        Ascending.
    start : (t,) ndarray of int
        Where each tile's pairs begin.
    reach, opens : (p,) ndarray
        How deep the trajectory reaches at most, and the depth to which it opens all of the tile's rays from their near
        end; -inf or not a number where it does not. Both are overwritten.
    near, far : float
        Where the tiles' rays begin and end, at least and at most.
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
