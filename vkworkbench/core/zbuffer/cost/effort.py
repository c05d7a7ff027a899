# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the simulator has to do, from a few tiles of the image that it would cull.

How much culling drops differs from one toolpath to another by orders of magnitude; only culling tells. So some tiles
are culled as the simulator does it, level by level. Where the tiles of a level have more pairs than a few thousands,
some of them are drawn, as likely as their pairs take long, and stand for the others (sampling proportional to size,
Madow 1949). What would be drawn more than once is taken for certain, and stands for itself.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from zlib import crc32

import numpy as np

from vkworkbench.core.zbuffer.culling.tiles import PAIRS_AT_ONCE, TILE, Tiles, are_small, first_tiles, quartered
from vkworkbench.core.zbuffer.culling.tilted import Tilted
from vkworkbench.core.zbuffer.culling.upright import Upright
from vkworkbench.core.zbuffer.memory.counts import Counts
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.sweeps.trajectories import Kind

# Pairs of tile and trajectory that go on at each level, for each kind of trajectory: operations with different tools are
# in different places. As many more as there are trajectories, up to a number: where they crowd, a few tiles hold all that
# go on, and do not tell what the others take. And of the image's first tiles as many as are looked at.
_PAIRS = 12_000
_CROWDED = 40_000
_LOOKED_AT = 2_000_000
# No fewer of the first tiles.
_FEWEST = 24

# The same tiles every time.
_SEED = 2002

# Kinds of pairs: by the tool (flat, pointed, ball, bull-nose), of these level and sloped moves, of these seen from above
# or below and obliquely. What testing a pair takes, and cutting a pixel's ray by one, what more where the ray's removals
# have to be sorted, and a record from above and obliquely, in units of `Speed`; learned by benchmarks/learn_effort.py.
# Cutting rays by a bull nose obliquely takes as long level as sloped, but thrice as long where they pass it between the ends of
# its move as where they pass it at an end: these are the two kinds of such cells.
KINDS = 16
_AT_END, _BETWEEN = 13, 15
TESTS = np.array(
    [0.049, 0.179, 0.087, 0.366, 0.062, 1, 0.097, 0.763, 0.057, 0.212, 0.08, 0.427, 0.083, 0.706, 0.109, 0.525]
)
CELLS = np.array(
    [0.027, 0.042, 0.017, 0.068, 0.021, 0.397, 0.024, 0.378, 0.023, 0.079, 0.014, 0.088, 0.026, 0.454, 0.04, 1]
)
SORTED = 0.072
RECORDS = np.array([1, 3.193])
# Which tables these are: a `Speed` that was measured with others does not hold for them.
WORK_UNITS = f"{crc32(np.concatenate((TESTS, CELLS, [SORTED], RECORDS)).tobytes()):08x}"


@dataclass(frozen=True)
class Work:
    """Amounts of a simulation's work.

    Attributes
    ----------
    trajectories, pixels : float
        Of the toolpath and of the image.
    first : float
        Pairs of trajectory and tile of the size to begin with, whether they meet or not.
    pairs : tuple of (16,) tuple of float
        Pairs of tile and trajectory that are tested at each level, from the largest tiles down, by kind; see `KINDS`.
    cells : (16,) tuple of float
        Pairs of pixel and trajectory of which the ray is cut, by kind.
    unconnected : float
        Share of these whose ray's removals do not connect, so that they are sorted.
    records : (2,) tuple of float
        Dexels and elements of traces, from above or below and obliquely.
    bands : float
        Bands of `TILE` rows of the image, from the lowest to the highest that trajectories reach.
    kinds : float
        How many kinds of trajectory reach each of these on average: the pairs of each are worked on apart.
    """

    trajectories: float
    pixels: float
    first: float
    pairs: tuple[tuple[float, ...], ...]
    cells: tuple[float, ...]
    unconnected: float
    records: tuple[float, float]
    bands: float
    kinds: float

    def amounts(self, growth: float = 1.0) -> np.ndarray:
        """How often each constant of `Speed` is due, in an image of `growth` times as many pixels.

        How many pairs tiles of one size in mm have does not depend on the image: in a finer one the same levels follow
        each other, begun later and continued further.

        Returns
        -------
        (7,) float64
            Trajectories, pixels, first pairs, blocks of pairs of one kind worked on at once, tests, cells, records.
        """
        levels = np.array(self.pairs).reshape(-1, KINDS)
        pairs, tests = _finer(levels.sum(axis=1), growth), _finer(levels @ TESTS, growth)
        cells = np.array(self.cells) * self._cells_in(growth)
        bands = self.bands * np.sqrt(growth)
        each = np.maximum.accumulate(np.maximum(pairs / PAIRS_AT_ONCE, bands))
        blocks = self.kinds * (each.sum() + max(bands, cells.sum() / PAIRS_AT_ONCE))
        records = float(np.dot(self.records, RECORDS))
        return np.array([
            self.trajectories, self.pixels * growth, self.first * growth, blocks, 4 * tests.sum(),
            cells @ (CELLS + SORTED * self.unconnected), records * growth,
        ])  # fmt: skip

    def _cells_in(self, growth: float) -> float:
        """How many times as many cells there are.

        At each level as many as the pairs of the last tiles grew from those before them, and in the end as many as there
        are pixels, each of which as many trajectories cut: the mean of both, as ratios.
        """
        if not self.pairs or sum(self.cells) == 0:
            return growth
        side = TILE >> len(self.pairs)
        step = np.clip(sum(self.cells) / side**2 / sum(self.pairs[-1]), 1, 4)
        return float((4 * step) ** (np.log2(growth) / 4))


def _finer(levels: np.ndarray, growth: float) -> np.ndarray:
    """Amounts of each level in an image of `growth` times as many pixels: powers of two between those known."""
    if growth == 1 or len(levels) < 2 or levels.min() <= 0:
        return levels * growth
    place = np.arange(len(levels)) + np.log2(growth) / 2
    whole = np.clip(np.floor(place).astype(int), 0, len(levels) - 2)
    known = np.log2(levels)
    steps = np.clip(np.diff(known), 0, 2)
    finer: np.ndarray = 2 ** (known[whole] + steps[whole] * (place - whole))
    return finer


def work_of(removal: Removal, trajectories: int, counts: Counts) -> Work:
    """Estimate a simulation's work.

    Parameters
    ----------
    removal : Removal
        What is to be simulated.
    trajectories : int
        Of the whole toolpath.
    counts : Counts
        What the simulation ends with.

    Returns
    -------
    Work
        The same for the same arguments.
    """
    rng = np.random.default_rng(_SEED)
    frame, upright = removal.frame, removal.sine == 0
    bounds = Upright(removal) if upright else Tilted(removal)
    kind = np.array([_kind(kind, upright) for kind in removal.kinds], int)[removal.kind]
    cell_kind, between = _of_cells(removal, kind)
    tiles, weight, all_tiles = _first(removal, rng)
    pairs = _PAIRS * len(removal.kinds) + min(len(removal.index), _CROWDED)
    levels = []
    cells: np.ndarray = np.zeros(KINDS)
    while len(tiles.item):
        fine = are_small(tiles, bounds.slow)
        these = tiles.side**2 * np.repeat(weight[fine], np.diff(tiles.first)[fine])
        item = tiles.selected(fine).item
        cells += np.bincount(cell_kind[item], these * (1 - between[item]), KINDS)
        cells[_BETWEEN] += these @ between[item]
        tiles, weight = tiles.selected(~fine), weight[~fine]
        if not len(tiles.item):
            break
        levels.append(tuple(_pairs(tiles, weight, kind).tolist()))
        tiles, weight = _drawn(tiles, weight, TESTS[kind[tiles.item]], pairs, rng)
        smaller = quartered(removal, bounds, tiles)
        tiles, weight = smaller, weight[_parents(tiles, smaller)]
    pixels, first = frame.width * frame.height, all_tiles * len(removal.index)
    kept = (counts.records, 0.0) if upright else (0.0, counts.records)
    return Work(
        trajectories, pixels, first, tuple(levels), tuple(cells.tolist()), counts.unconnected, kept, *_bands(removal)
    )


def _bands(removal: Removal) -> tuple[float, float]:
    """See `Work.bands` and `Work.kinds`."""
    frame = removal.frame
    band, most, half = TILE * frame.pixel, -(-frame.height // TILE), frame.height * frame.pixel / 2
    bottom, top = np.clip(removal.box[2:], -half, half)
    own = [removal.kind == number for number in range(len(removal.kinds))]
    # A part of a band is a band, too: one more on average.
    each = [min((top[of].max() - bottom[of].min()) / band + 1, most) for of in own]
    if not each:
        return 0.0, 1.0
    together = min((top.max() - bottom.min()) / band + 1, most)
    return together, sum(each) / together


def _of_cells(removal: Removal, kind: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Kinds (m,) of pairs of a pixel and a trajectory, and what share of those of a bull-nose is between the ends of its moves.

    A disc that moves covers so much more than one that stands.
    """
    rounded = (kind == _AT_END) | (kind == _BETWEEN)
    run = removal.heading[2]
    between = np.where(rounded, run / (run + pi / 2 * removal.radius), 0.0)
    return np.where(rounded, _AT_END, kind), between


def _pairs(tiles: Tiles, weight: np.ndarray, kind: np.ndarray) -> np.ndarray:
    """How many pairs of each kind tiles have that stand for so many."""
    return np.bincount(kind[tiles.item], np.repeat(weight, np.diff(tiles.first)), KINDS)


def _kind(kind: Kind, upright: bool) -> int:
    tool = kind.tool
    rounded = 2 if tool.rounding == tool.radius else 3
    shape = rounded if tool.rounding else int(tool.steepness > 0)
    return 4 * shape + 2 * (not kind.level) + (not upright)


def _first(removal: Removal, rng: np.random.Generator) -> tuple[Tiles, np.ndarray, int]:
    """Some of the image's first tiles with their trajectories, for how many each stands, and how many there are."""
    frame = removal.frame
    columns, rows = -(-frame.width // TILE), -(-frame.height // TILE)
    every = columns * rows
    count = min(every, max(_FEWEST, _LOOKED_AT // (len(removal.index) + 1)))
    chosen = np.arange(every)
    if count < every:
        chosen = ((np.arange(count) + rng.random(count)) * (every / count)).astype(np.int64)
    row, column = np.divmod(chosen, columns)
    tiles = first_tiles(removal, TILE * column, TILE * row)
    return tiles, np.full(count, every / count), every


def _drawn(
    tiles: Tiles, weight: np.ndarray, cost: np.ndarray, pairs: int, rng: np.random.Generator
) -> tuple[Tiles, np.ndarray]:
    """Draw some of the tiles where they have too many pairs, as likely as these take long, each its `cost` (p,)."""
    size = np.diff(tiles.first)
    if size.sum() <= pairs:
        return tiles, weight
    likely = weight * np.diff(np.append(0.0, np.cumsum(cost)).take(tiles.first))
    usual = float((likely * size).sum()) / likely.sum()  # size of a tile so drawn
    count = max(1, int(pairs / usual))
    if count >= len(size):
        return tiles, weight
    chances = _chances(likely, count)
    at = np.arange(count) + rng.random()
    chosen = np.unique(np.searchsorted(np.cumsum(chances)[:-1], at, side="right"))
    item = [tiles.item[tiles.first[tile] : tiles.first[tile + 1]] for tile in chosen]
    first = np.append(0, np.cumsum(size[chosen]))
    drawn = Tiles(tiles.side, tiles.column[chosen], tiles.row[chosen], first, np.concatenate(item))
    return drawn, weight[chosen] / chances[chosen]


def _chances(likely: np.ndarray, count: int) -> np.ndarray:
    """Chances of tiles to be among the `count` that are drawn: proportional to `likely` (t,), 1 at most."""
    sure = np.zeros(len(likely), bool)
    while True:
        left = likely[~sure].sum()
        chances = np.where(sure, 1.0, likely * ((count - sure.sum()) / left))
        more = chances > 1
        if not more.any():
            return chances
        sure |= more


def _parents(tiles: Tiles, made: Tiles) -> np.ndarray:
    """Which of the tiles each of the smaller ones is in."""
    width = 1 << 20
    place = (tiles.row // tiles.side) * width + tiles.column // tiles.side
    order = np.argsort(place)
    inside = (made.row // tiles.side) * width + made.column // tiles.side
    found: np.ndarray = order[np.searchsorted(place[order], inside)]
    return found
