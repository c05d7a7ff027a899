# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the visits that begin another operation. A visit is the cutting between two retracts to the top height."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

import numpy as np

from vkworkbench.core.paper import TURN, Areas, monotonous_areas
from vkworkbench.core.recognition.thresholds import ROUNDING, VISITS
from vkworkbench.core.recognition.verdict.model import Trees, read_trees
from vkworkbench.core.toolpath import Toolpath

FILE = Path(__file__).with_name("borders.npz")


@lru_cache(maxsize=1)
def shipped_trees() -> Trees:
    """Return the trees that vote whether a retract is a border (class 1). The file is read when first needed."""
    with np.load(FILE, allow_pickle=False) as arrays:
        return read_trees(arrays, "borders")


@dataclass(frozen=True)
class Visits:
    """Measures of k visits.

    Attributes
    ----------
    first, last : (k,) int
        First and last cutting trajectory.
    blocks : (k,) int
        Number of monotonous areas and drilled holes.
    low, high : (k, 2) float
        Bounding box in the plane, mm.
    bottom, top, begin : (k,) float
        Lowest and highest cutting height, and the height of the first block, mm.
    length : (k,) float
        Cutting length in the plane, mm.
    feed, fastest : (k,) float
        Mean feed weighted by length, and highest feed, mm/s.
    turn : (k,) float
        Mean net turn of a block, turns.
    chord, closed : (k,) float
        Sum of the distances from start to end of the blocks, and length of the closed blocks, both divided by the
        length.
    axis : (k,) complex
        Sum of the moves with doubled angles, divided by the length. The magnitude is 1 if all moves have one axis.
    """

    first: np.ndarray
    last: np.ndarray
    blocks: np.ndarray
    low: np.ndarray
    high: np.ndarray
    bottom: np.ndarray
    top: np.ndarray
    begin: np.ndarray
    length: np.ndarray
    feed: np.ndarray
    fastest: np.ndarray
    turn: np.ndarray
    chord: np.ndarray
    closed: np.ndarray
    axis: np.ndarray

    def __len__(self) -> int:
        """Return the number of visits."""
        return len(self.first)


class _Blocks(NamedTuple):
    """Measures of b blocks (areas and drilled holes) in the order of cutting. The length of a hole is 0.

    Attributes
    ----------
    first, last : (b,) int
        First and last trajectory.
    low, high : (b, 2) float
        Bounding box in the plane, mm.
    bottom, top : (b,) float
        Lowest and highest cutting height, mm.
    length, gap : (b,) float
        Length in the plane, and distance from start to end, mm.
    feed, fastest : (b,) float
        Mean feed weighted by length, and highest feed, mm/s.
    turned : (b,) float
        Absolute net turn, rad.
    axis : (b,) complex
        Sum of the moves with doubled angles, mm.
    """

    first: np.ndarray
    last: np.ndarray
    low: np.ndarray
    high: np.ndarray
    bottom: np.ndarray
    top: np.ndarray
    length: np.ndarray
    gap: np.ndarray
    feed: np.ndarray
    fastest: np.ndarray
    turned: np.ndarray
    axis: np.ndarray


def find_visits(toolpath: Toolpath, moves: Areas) -> Visits | None:
    """Divide the cutting at retracts to the program's top height; None if there is only one visit.

    Parameters
    ----------
    toolpath : Toolpath
    moves : Areas
        Areas of the whole toolpath.
    """
    if len(moves.start) + len(moves.holes) < 2:
        return None
    blocks = _blocks(toolpath, moves)
    # The highest point between the end of each block and the start of the next block.
    z = toolpath.points[:, 2]
    between = np.column_stack([blocks.last[:-1] + 1, np.maximum(blocks.first[1:], blocks.last[:-1] + 1) + 1]).ravel()
    reached = np.maximum.reduceat(np.append(z, -np.inf), between)[::2]
    parted = reached >= reached.max() - ROUNDING.HEIGHT
    if not parted.any():
        return None
    begin = np.flatnonzero(np.append(True, parted))
    end = np.append(begin[1:], len(blocks.first))
    low, high, add = np.minimum.reduceat, np.maximum.reduceat, np.add.reduceat
    length, count = add(blocks.length, begin), end - begin
    some, weight = np.maximum(length, 1e-9), np.maximum(blocks.length, 1e-6)
    return Visits(
        first=blocks.first[begin],
        last=blocks.last[end - 1],
        blocks=count,
        low=low(blocks.low, begin),
        high=high(blocks.high, begin),
        bottom=low(blocks.bottom, begin),
        top=high(blocks.top, begin),
        begin=blocks.top[begin],
        length=length,
        feed=add(blocks.feed * weight, begin) / add(weight, begin),
        fastest=high(blocks.fastest, begin),
        turn=add(blocks.turned, begin) / count / TURN,
        chord=add(blocks.gap, begin) / some,
        closed=add((blocks.gap < VISITS.CLOSED * blocks.length) * blocks.length, begin) / some,
        axis=add(blocks.axis, begin) / some,
    )


def _blocks(toolpath: Toolpath, areas: Areas) -> _Blocks:
    """Measure every area and every hole."""
    hole, feed, none = toolpath.points[areas.holes + 1], toolpath.feed[areas.holes], np.zeros(len(areas.holes))
    holes = _Blocks(
        first=areas.holes,
        last=areas.holes,
        low=hole[:, :2],
        high=hole[:, :2],
        bottom=hole[:, 2],
        top=hole[:, 2],
        length=none,
        gap=none,
        feed=feed,
        fastest=feed,
        turned=none,
        axis=none,
    )
    if not len(areas):
        return holes
    start, last = areas.start, areas.end - 1
    x, y = areas.x[last] + areas.dx[last], areas.y[last] + areas.dy[last]
    low, high, add = np.minimum.reduceat, np.maximum.reduceat, np.add.reduceat
    fed = toolpath.feed[areas.index]
    axis = np.exp(2j * areas.alpha)
    axis *= areas.length
    milled = _Blocks(
        first=areas.index[start],
        last=areas.index[last],
        low=np.column_stack([np.minimum(low(areas.x, start), x), np.minimum(low(areas.y, start), y)]),
        high=np.column_stack([np.maximum(high(areas.x, start), x), np.maximum(high(areas.y, start), y)]),
        bottom=low(areas.z, start),
        top=high(areas.z, start),
        length=areas.area_length,
        gap=np.hypot(x - areas.x[start], y - areas.y[start]),
        feed=add(fed * areas.length, start) / areas.area_length,
        fastest=high(fed, start),
        turned=np.abs(add(areas.turning, start)),
        axis=add(axis, start),
    )
    both = [np.concatenate(pair) for pair in zip(milled, holes)]
    order = np.argsort(both[0], kind="stable")
    return _Blocks(*(values[order] for values in both))


def compare_visits(visits: Visits) -> dict[str, np.ndarray]:
    """Compare every visit with the next visit. Return the dimensionless measures of the pairs, (k-1,) each."""
    a, b = slice(None, -1), slice(1, None)

    def differ(values: np.ndarray, least: float = 1e-6) -> np.ndarray:
        """Return the relative difference of values that are not negative."""
        larger = np.maximum(values[a], values[b])
        result: np.ndarray = np.abs(values[b] - values[a]) / np.maximum(larger, least)
        return result

    def ratio(values: np.ndarray, least: float) -> np.ndarray:
        """Return the logarithm of the ratio of the larger to the smaller value."""
        return np.minimum(np.abs(np.log((values[a] + least) / (values[b] + least))), 6.0)

    def same(values: np.ndarray) -> np.ndarray:
        result: np.ndarray = (np.abs(values[b] - values[a]) < ROUNDING.HEIGHT).astype(float)
        return result

    def higher(values: np.ndarray) -> np.ndarray:
        return (values[b] > values[a] + ROUNDING.HEIGHT).astype(float)

    size = np.maximum(np.hypot(*(visits.high - visits.low).T), VISITS.SMALL)
    moved = np.maximum(np.abs(visits.low[b] - visits.low[a]), np.abs(visits.high[b] - visits.high[a])).max(axis=1)
    shared, ground = _shared_ground(visits, 1), _ground(visits)
    fewer, more = np.minimum(visits.blocks[a], visits.blocks[b]), np.maximum(visits.blocks[a], visits.blocks[b])
    lowest, highest = visits.bottom.min(), visits.top.max()
    measures = {
        "feed": differ(visits.feed),
        "same_feed": (differ(visits.fastest) < VISITS.FEED).astype(float),
        "same_ground": (moved < VISITS.PLACE * np.maximum(size[a], size[b]) + ROUNDING.GROUND).astype(float),
        "overlap": shared / (ground[a] + ground[b] - shared),
        "inside": shared / np.minimum(ground[a], ground[b]),
        "same_bottom": same(visits.bottom),
        "higher_bottom": higher(visits.bottom),
        "deeper": (visits.bottom[b] - visits.bottom[a]) / max(highest - lowest, ROUNDING.HEIGHT),
        "same_top": same(visits.top),
        "same_begin": same(visits.begin),
        "higher_begin": higher(visits.begin),
        "size": ratio(size, 0.0),
        "length": ratio(visits.length, VISITS.SMALL),
        "block_length": ratio(visits.length / visits.blocks, VISITS.SMALL),
        "block_count": np.log(more / fewer),
        "fewer_blocks": np.log(fewer),
        "more_blocks": np.log(more),
        "turn": ratio(visits.turn, 0.1),
        "chord": np.abs(visits.chord[b] - visits.chord[a]),
        "closed": np.abs(visits.closed[b] - visits.closed[a]),
        "axis": np.abs(visits.axis[b] - visits.axis[a]),
        "visits": np.full(len(visits) - 1, np.log(len(visits))),
    }  # fmt: skip
    measures["again"], measures["again_above"] = _cut_again(visits)
    # Average the measures of the pairs before and after, which show whether the visits form a regular series.
    for name in ("same_ground", "overlap", "same_top", "same_bottom", "same_feed"):
        values = measures[name]
        if len(values) > 1:
            values = np.concatenate([values[1:2], values, values[-2:-1]])
            measures["series_" + name] = (values[:-2] + values[2:]) / 2
        else:
            measures["series_" + name] = values
    return measures


def _ground(visits: Visits) -> np.ndarray:
    """Return the area of the bounding box of each visit, (k,) mm2; small but positive for a hole."""
    area: np.ndarray = np.prod(visits.high - visits.low + VISITS.SMALL, axis=1)
    return area


def _shared_ground(visits: Visits, back: int) -> np.ndarray:
    """Return the common area of the boxes of each visit and the visit cut `back` visits earlier, (k - back,) mm2."""
    sides = (
        np.minimum(visits.high[back:], visits.high[:-back])
        - np.maximum(visits.low[back:], visits.low[:-back])
        + VISITS.SMALL
    )
    area: np.ndarray = np.prod(np.maximum(sides, 0.0), axis=1)
    return area


def _cut_again(visits: Visits) -> tuple[np.ndarray, np.ndarray]:
    """Return the share of each visit's ground that one of the previous visits covers, two arrays (k-1,).

    The first array counts previous visits at the same depth or deeper; the second array counts only deeper visits. An
    operation rarely cuts the same ground again.
    """
    again = np.zeros((2, len(visits) - 1))
    ground = _ground(visits)
    for back in range(1, min(VISITS.EARLIER, len(visits) - 1) + 1):
        share = _shared_ground(visits, back) / ground[back:]
        higher = visits.bottom[back:] - visits.bottom[:-back]
        for of, deep in zip(again[:, back - 1 :], (higher > -ROUNDING.HEIGHT, higher > ROUNDING.HEIGHT)):
            np.maximum(of, share * deep, out=of)
    return again[0], again[1]


def find_retracts(toolpath: Toolpath, moves: Areas) -> dict[int, float]:
    """Return the trajectories at which another operation can begin, with probabilities, from the motion alone.

    Programs do not mark their operations, and there are also retracts within an operation. A retract to the top height
    is a border only if feed, ground, depths or pattern change as between operations. A model learned from programs
    estimates the probability (benchmarks/learn_borders.py). A visit that lies alone between two borders is divided
    further, at retracts to its own top height, because tools are changed at a greater height than operations retract
    to.
    """
    found, alone = _retracts_to_top(toolpath, moves, VISITS.DOUBTFUL)
    for _ in range(VISITS.NESTED):
        within = [_retracts_to_top(toolpath, monotonous_areas(toolpath, *visit), VISITS.BORDER) for visit in alone]
        found.update(dict.fromkeys((at for lower, _ in within for at in lower), VISITS.BORDER))
        alone = [visit for _, visits in within for visit in visits]
    return dict(sorted(found.items(), key=lambda of: -of[1])[: VISITS.MOST])


def _retracts_to_top(toolpath: Toolpath, moves: Areas, least: float) -> tuple[dict[int, float], list[tuple[int, int]]]:
    """Return {trajectory: probability} for retracts to the top height, and the visits that can be divided further."""
    visits = find_visits(toolpath, moves)
    if visits is None:
        return {}, []
    share = shipped_trees().shares(np.column_stack(list(compare_visits(visits).values())))[:, 1]
    at = np.flatnonzero(share > least)
    # A border is at the highest point between two visits, before the descent to the next visit.
    z = toolpath.points[:, 2]
    gaps = zip(visits.last[at] + 1, visits.first[at + 1] + 1)
    found = {int(a + np.argmax(z[a:b])): float(s) for (a, b), s in zip(gaps, share[at])}
    begin = np.append(0, at + 1)
    alone = begin[np.diff(begin, append=len(visits)) == 1]
    alone = alone[visits.blocks[alone] > 1]
    return found, list(zip(visits.first[alone].tolist(), visits.last[alone].tolist()))
