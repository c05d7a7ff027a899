# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimate how often the simulator executes each of its steps, by culling a sample of tiles.

Culling drops pairs of a tile and a trajectory that do not meet. The share of dropped pairs differs between toolpaths by
orders of magnitude, and only culling itself can find this share. Therefore some tiles are culled with the code of the
simulator, level by level; a level consists of all tiles of one size, and each level halves the side of the tiles. If
the tiles of a level have too many pairs, a sample of these tiles is drawn, with probabilities proportional to the time
for their pairs (sampling proportional to size, Madow 1949). A tile whose probability would exceed 1 is always drawn.
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

# Number of pairs of a tile and a trajectory that are drawn from all tiles of one size: `_PAIRS` for each kind of
# trajectory, plus one pair for each trajectory, but at most `_CROWDED` pairs. The number of pairs grows with the number
# of kinds of trajectories, because operations with different tools cut different tiles. The number of pairs also grows
# with the number of trajectories, because a few tiles with long lists would otherwise fill the sample. `_LOOKED_AT` is
# the approximate number of pairs that are tested for the tiles of the largest size.
_PAIRS = 12_000
_CROWDED = 40_000
_LOOKED_AT = 2_000_000
# Minimum number of tiles of the largest size in the sample.
_FEWEST = 24

# Seed of the random sample. A fixed seed gives equal estimates for equal arguments.
_SEED = 2002

# Number of kinds of pairs of a tile and a trajectory. The number of a kind is 4 * (0 flat, 1 pointed, 2 ball or 3
# bull-nose tool) + 2 * (1 if the move is sloped) + (1 if the view is oblique). benchmarks/learn_effort.py fits the
# costs below, as multiples of the times in `Speed`. TESTS is the cost of testing a pair of a tile and a trajectory.
# CELLS is the cost of a cell; a cell is the cutting of one pixel's ray by one trajectory. SORTED is the additional cost
# of a cell (cut ray) if the ray's removed intervals must be sorted. RECORDS is the cost of a record (dexel, trace
# element or gap) in a vertical view and in an oblique view. With a bull-nose in an oblique view, cutting a ray that
# meets the tool between the ends of the move takes about three times as long as cutting a ray that meets the tool at an
# end, whether the move is level or sloped. Therefore elements 13 and 15 of TESTS and CELLS stand for different kinds.
# In TESTS, elements 13 and 15 are the costs for level and for sloped moves of a bull-nose. In CELLS, elements 13 and 15
# are the costs for rays that meet a bull-nose at an end of the move and between the ends.
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
# Checksum of TESTS, CELLS, SORTED and RECORDS. A stored `Speed` that was measured with other values is not valid.
WORK_UNITS = f"{crc32(np.concatenate((TESTS, CELLS, [SORTED], RECORDS)).tobytes()):08x}"


@dataclass(frozen=True)
class Work:
    """How often the simulator executes each of its steps in one simulation.

    Attributes
    ----------
    trajectories, pixels : float
        Number of trajectories and of pixels.
    first : float
        Number of pairs of a trajectory and a tile of the largest size, whether or not the two meet.
    pairs : tuple of (16,) tuple of float
        Number of tested pairs of a tile and a trajectory, by level (the level with the largest tiles first) and by
        kind; see `KINDS`.
    cells : (16,) tuple of float
        Number of cells, which are pairs of a trajectory and a pixel whose ray the trajectory cuts, by kind.
    unconnected : float
        Share of `cells` on rays whose removed intervals are not connected. The simulator sorts the removed intervals
        only on these rays.
    records : (2,) tuple of float
        Number of records (dexels, trace elements and gaps) in a vertical view, and in an oblique view; one of the two
        is 0.
    bands : float
        Number of bands (`TILE` rows of pixels), from the lowest to the highest band that trajectories reach.
    kinds : float
        Mean number of kinds of trajectories (shape of the tool, level or sloped move) that reach a band. The simulator
        processes the pairs of a tile and a trajectory of each kind separately.
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
        """Return how often each step timed by `Speed` is executed for an image with `growth` times as many pixels.

        The number of pairs of a tile and a trajectory, for tiles with a given side in mm, does not depend on the image.
        In an image with smaller pixels, tiles with a given side in pixels are smaller in mm.

        Returns
        -------
        (7,) float64
            Numbers of trajectories, pixels, pairs of a trajectory and a tile of the largest size, batches of pairs of
            one kind, tests of pairs, cells (rays that a trajectory cuts) and records (dexels, trace elements and gaps).
            Tests, cells and records are multiplied by their costs in TESTS, CELLS, SORTED and RECORDS.
        """
        levels = np.array(self.pairs).reshape(-1, KINDS)
        pairs, tests = _shift_levels(levels.sum(axis=1), growth), _shift_levels(levels @ TESTS, growth)
        cells = np.array(self.cells) * self._cell_growth(growth)
        bands = self.bands * np.sqrt(growth)
        each = np.maximum.accumulate(np.maximum(pairs / PAIRS_AT_ONCE, bands))
        blocks = self.kinds * (each.sum() + max(bands, cells.sum() / PAIRS_AT_ONCE))
        records = float(np.dot(self.records, RECORDS))
        return np.array([
            self.trajectories, self.pixels * growth, self.first * growth, blocks, 4 * tests.sum(),
            cells @ (CELLS + SORTED * self.unconnected), records * growth,
        ])  # fmt: skip

    def _cell_growth(self, growth: float) -> float:
        """Return the factor by which the number of cut rays (cells) grows if the number of pixels grows by `growth`.

        The result is the geometric mean of the factors from two models. In the first model, each halving of the tiles'
        side multiplies the number of pairs of a tile and a trajectory by the same factor as the last halving whose
        factor is known. In the second model, the number of cells is proportional to the number of pixels.
        """
        if not self.pairs or sum(self.cells) == 0:
            return growth
        side = TILE >> len(self.pairs)
        step = np.clip(sum(self.cells) / side**2 / sum(self.pairs[-1]), 1, 4)
        return float((4 * step) ** (np.log2(growth) / 4))


def _shift_levels(levels: np.ndarray, growth: float) -> np.ndarray:
    """Return the amounts of work, one for each size of tiles, for an image with `growth` times as many pixels.

    The amounts of work are interpolated between sizes of tiles on a logarithmic scale.
    """
    if growth == 1 or len(levels) < 2 or levels.min() <= 0:
        return levels * growth
    place = np.arange(len(levels)) + np.log2(growth) / 2
    whole = np.clip(np.floor(place).astype(int), 0, len(levels) - 2)
    known = np.log2(levels)
    steps = np.clip(np.diff(known), 0, 2)
    return 2 ** (known[whole] + steps[whole] * (place - whole))


def work_of(removal: Removal, trajectories: int, counts: Counts) -> Work:
    """Estimate how often each step of a simulation is executed.

    Parameters
    ----------
    removal : Removal
        The prepared trajectories of the simulation.
    trajectories : int
        Number of trajectories of the whole toolpath.
    counts : Counts
        Estimated numbers of records at the end of the simulation.

    Returns
    -------
    Work
        Equal arguments give equal work.
    """
    rng = np.random.default_rng(_SEED)
    frame, upright = removal.frame, removal.sine == 0
    bounds = Upright(removal) if upright else Tilted(removal)
    kind = np.array([_kind_number(kind, upright) for kind in removal.kinds], int)[removal.kind]
    cell_kind, between = _cell_kinds(removal, kind)
    tiles, weight, all_tiles = _draw_first_tiles(removal, rng)
    pairs = _PAIRS * len(removal.kinds) + min(len(removal.index), _CROWDED)
    levels = []
    cells: np.ndarray = np.zeros(KINDS)
    while len(tiles.item):
        fine = are_small(tiles, bounds.slow)
        represented = tiles.side**2 * np.repeat(weight[fine], np.diff(tiles.first)[fine])
        item = tiles.selected(fine).item
        cells += np.bincount(cell_kind[item], represented * (1 - between[item]), KINDS)
        cells[_BETWEEN] += represented @ between[item]
        tiles, weight = tiles.selected(~fine), weight[~fine]
        if not len(tiles.item):
            break
        levels.append(tuple(_count_pairs(tiles, weight, kind).tolist()))
        tiles, weight = _draw_tiles(tiles, weight, TESTS[kind[tiles.item]], pairs, rng)
        smaller = quartered(removal, bounds, tiles)
        tiles, weight = smaller, weight[_parents(tiles, smaller)]
    pixels, first = frame.width * frame.height, all_tiles * len(removal.index)
    kept = (counts.records, 0.0) if upright else (0.0, counts.records)
    return Work(
        trajectories,
        pixels,
        first,
        tuple(levels),
        tuple(cells.tolist()),
        counts.unconnected,
        kept,
        *_count_bands(removal),
    )


def _count_bands(removal: Removal) -> tuple[float, float]:
    """Return `Work.bands` and `Work.kinds`."""
    frame = removal.frame
    band, most, half = TILE * frame.pixel, -(-frame.height // TILE), frame.height * frame.pixel / 2
    bottom, top = np.clip(removal.box[2:], -half, half)
    own = [removal.kind == number for number in range(len(removal.kinds))]
    # A band is a strip of `TILE` rows of pixels. A band that trajectories reach only partly counts as a whole band,
    # which adds one band on average.
    each = [min((top[kind].max() - bottom[kind].min()) / band + 1, most) for kind in own]
    if not each:
        return 0.0, 1.0
    together = min((top.max() - bottom.min()) / band + 1, most)
    return together, sum(each) / together


def _cell_kinds(removal: Removal, kind: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the kind of each trajectory, and the share of its cells between the ends of the move, two arrays (m,).

    A cell is a ray that the trajectory cuts. For a bull-nose, the share is estimated as run / (run + pi / 2 * radius):
    the area of the rectangle between the discs at both ends of the move, divided by the whole swept area. For tools
    other than bull-noses, the share of cells between the ends is 0.
    """
    rounded = (kind == _AT_END) | (kind == _BETWEEN)
    run = removal.heading[2]
    between = np.where(rounded, run / (run + pi / 2 * removal.radius), 0.0)
    return np.where(rounded, _AT_END, kind), between


def _count_pairs(tiles: Tiles, weight: np.ndarray, kind: np.ndarray) -> np.ndarray:
    """Return the estimated number of pairs of each kind, (KINDS,).

    Each pair is counted with its tile's weight, the number of tiles that a drawn tile represents.
    """
    return np.bincount(kind[tiles.item], np.repeat(weight, np.diff(tiles.first)), KINDS)


def _kind_number(kind: Kind, upright: bool) -> int:
    """Return the number of a kind of pairs of a tile and a trajectory; see `KINDS`."""
    tool = kind.tool
    rounded = 2 if tool.rounding == tool.radius else 3
    shape = rounded if tool.rounding else int(tool.steepness > 0)
    return 4 * shape + 2 * (not kind.level) + (not upright)


def _draw_first_tiles(removal: Removal, rng: np.random.Generator) -> tuple[Tiles, np.ndarray, int]:
    """Return a sample of the largest tiles, and the number of all largest tiles.

    The second array of the result contains each drawn tile's weight, the number of tiles that the tile represents.
    """
    frame = removal.frame
    columns, rows = -(-frame.width // TILE), -(-frame.height // TILE)
    every = columns * rows
    count = min(every, max(_FEWEST, _LOOKED_AT // (len(removal.index) + 1)))
    chosen = np.arange(every)
    if count < every:
        chosen = ((np.arange(count) + rng.random(count)) * (every / count)).astype(np.int64)
    row, column = np.divmod(chosen, columns)
    tiles = first_tiles(removal, TILE, TILE * column, TILE * row)
    return tiles, np.full(count, every / count), every


def _draw_tiles(
    tiles: Tiles, weight: np.ndarray, cost: np.ndarray, pairs: int, rng: np.random.Generator
) -> tuple[Tiles, np.ndarray]:
    """Return a sample of tiles, and the number of tiles that each drawn tile represents (its weight).

    All tiles are returned if they have at most `pairs` pairs of a tile and a trajectory. The probability of drawing a
    tile is proportional to its weight times the cost of its pairs. `cost` (p,) is the cost of each pair of a tile and a
    trajectory.
    """
    size = np.diff(tiles.first)
    if size.sum() <= pairs:
        return tiles, weight
    likely = weight * np.diff(np.append(0.0, np.cumsum(cost)).take(tiles.first))
    usual = float((likely * size).sum()) / likely.sum()  # mean number of trajectories in a drawn tile
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
    """Return the probability of drawing each tile if `count` are drawn: proportional to `likely` (t,), at most 1."""
    sure = np.zeros(len(likely), bool)
    while True:
        left = likely[~sure].sum()
        chances = np.where(sure, 1.0, likely * ((count - sure.sum()) / left))
        more = chances > 1
        if not more.any():
            return chances
        sure |= more


def _parents(tiles: Tiles, smaller: Tiles) -> np.ndarray:
    """Return, for each of the `smaller` tiles, the index of the tile in `tiles` that contains it."""
    width = 1 << 20
    place = (tiles.row // tiles.side) * width + tiles.column // tiles.side
    order = np.argsort(place)
    inside = (smaller.row // tiles.side) * width + smaller.column // tiles.side
    return order[np.searchsorted(place[order], inside)]
