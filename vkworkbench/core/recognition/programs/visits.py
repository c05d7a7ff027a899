# SPDX-License-Identifier: LGPL-2.1-or-later
"""Visits: what a program cuts between two retracts to its top height, and which of them begin another operation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from vkworkbench.core.paper import TURN, Areas, monotonous_areas
from vkworkbench.core.recognition.programs.borders import MEASURES, TREES
from vkworkbench.core.recognition.thresholds import SAME, VISITS
from vkworkbench.core.recognition.verdict.forest import Forest
from vkworkbench.core.toolpath import Toolpath

FOREST = Forest(TREES, 2)


@dataclass(frozen=True)
class Visits:
    """What each of k visits to the part measures.

    Attributes
    ----------
    first, last : (k,) int
        First and last trajectory that cuts.
    blocks : (k,) int
        Number of monotonous areas and drilled holes.
    low, high : (k, 2) float
        Bounding box in the plane, mm.
    bottom, top, begin : (k,) float
        Lowest and highest cutting height, and that of the first block, mm.
    length : (k,) float
        Cutting length in the plane, mm.
    feed, fastest : (k,) float
        Mean feed by length, and the highest, mm/s.
    turn : (k,) float
        Mean net turn of a block, turns.
    chord, closed : (k,) float
        Distance from start to end of the blocks, and length of the closed ones, both over the length.
    axis : (k,) complex
        Sum of the directions at twice their angle, over the length: 1 where all moves keep to one axis.
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
    """What each of b blocks measures, areas and drilled holes in the order of cutting; a hole has no length.

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
        Mean feed by length, and the highest, mm/s.
    turned : (b,) float
        Net turn either way, rad.
    axis : (b,) complex
        Sum of the moves with twice their angle, mm.
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
    """Divide the cutting at the retracts to the program's top height; None where there is but one visit.

    Parameters
    ----------
    toolpath : Toolpath
    moves : Areas
        Of the whole toolpath.
    """
    if len(moves.start) + len(moves.holes) < 2:
        return None
    b = _blocks(toolpath, moves)
    # The height reached between the end of a block and the start of the next.
    z = toolpath.points[:, 2]
    between = np.column_stack([b.last[:-1] + 1, np.maximum(b.first[1:], b.last[:-1] + 1) + 1]).ravel()
    reached = np.maximum.reduceat(np.append(z, -np.inf), between)[::2]
    parted = reached >= reached.max() - SAME.HEIGHT
    if not parted.any():
        return None
    begin = np.flatnonzero(np.append(True, parted))
    end = np.append(begin[1:], len(b.first))
    low, high, add = np.minimum.reduceat, np.maximum.reduceat, np.add.reduceat
    length, count = add(b.length, begin), end - begin
    some, weight = np.maximum(length, 1e-9), np.maximum(b.length, 1e-6)
    return Visits(
        first=b.first[begin],
        last=b.last[end - 1],
        blocks=count,
        low=low(b.low, begin),
        high=high(b.high, begin),
        bottom=low(b.bottom, begin),
        top=high(b.top, begin),
        begin=b.top[begin],
        length=length,
        feed=add(b.feed * weight, begin) / add(weight, begin),
        fastest=high(b.fastest, begin),
        turn=add(b.turned, begin) / count / TURN,
        chord=add(b.gap, begin) / some,
        closed=add((b.gap < VISITS.CLOSED * b.length) * b.length, begin) / some,
        axis=add(b.axis, begin) / some,
    )


def _blocks(toolpath: Toolpath, m: Areas) -> _Blocks:
    """Measure every area and every hole."""
    hole, feed, none = toolpath.points[m.holes + 1], toolpath.feed[m.holes], np.zeros(len(m.holes))
    holes = _Blocks(
        first=m.holes,
        last=m.holes,
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
    if not len(m):
        return holes
    start, last = m.start, m.end - 1
    x, y = m.x[last] + m.dx[last], m.y[last] + m.dy[last]
    low, high, add = np.minimum.reduceat, np.maximum.reduceat, np.add.reduceat
    fed = toolpath.feed[m.index]
    axis = np.exp(2j * m.alpha)
    axis *= m.length
    areas = _Blocks(
        first=m.index[start],
        last=m.index[last],
        low=np.column_stack([np.minimum(low(m.x, start), x), np.minimum(low(m.y, start), y)]),
        high=np.column_stack([np.maximum(high(m.x, start), x), np.maximum(high(m.y, start), y)]),
        bottom=low(m.z, start),
        top=high(m.z, start),
        length=m.area_length,
        gap=np.hypot(x - m.x[start], y - m.y[start]),
        feed=add(fed * m.length, start) / m.area_length,
        fastest=high(fed, start),
        turned=np.abs(add(m.turning, start)),
        axis=add(axis, start),
    )
    both = [np.concatenate(pair) for pair in zip(areas, holes)]
    order = np.argsort(both[0], kind="stable")
    return _Blocks(*(values[order] for values in both))


def compared(v: Visits) -> np.ndarray:
    """Compare every visit with the next: (k-1, m), the measures of `MEASURES` with no unit of length in them."""
    a, b = slice(None, -1), slice(1, None)

    def differ(values: np.ndarray, least: float = 1e-6) -> np.ndarray:
        """Relative difference of what is not negative."""
        larger = np.maximum(values[a], values[b])
        result: np.ndarray = np.abs(values[b] - values[a]) / np.maximum(larger, least)
        return result

    def ratio(values: np.ndarray, least: float) -> np.ndarray:
        """Logarithm of the ratio of the larger to the smaller."""
        return np.minimum(np.abs(np.log((values[a] + least) / (values[b] + least))), 6.0)

    def same(values: np.ndarray) -> np.ndarray:
        result: np.ndarray = (np.abs(values[b] - values[a]) < SAME.HEIGHT).astype(float)
        return result

    def higher(values: np.ndarray) -> np.ndarray:
        return (values[b] > values[a] + SAME.HEIGHT).astype(float)

    size = np.maximum(np.hypot(*(v.high - v.low).T), VISITS.SMALL)
    moved = np.maximum(np.abs(v.low[b] - v.low[a]), np.abs(v.high[b] - v.high[a])).max(axis=1)
    shared, ground = _shared_ground(v, 1), _ground(v)
    fewer, more = np.minimum(v.blocks[a], v.blocks[b]), np.maximum(v.blocks[a], v.blocks[b])
    lowest, highest = v.bottom.min(), v.top.max()
    measures = {
        "feed": differ(v.feed),
        "same_feed": (differ(v.fastest) < VISITS.FEED).astype(float),
        "same_ground": (moved < VISITS.PLACE * np.maximum(size[a], size[b]) + SAME.GROUND).astype(float),
        "overlap": shared / (ground[a] + ground[b] - shared),
        "inside": shared / np.minimum(ground[a], ground[b]),
        "same_bottom": same(v.bottom),
        "higher_bottom": higher(v.bottom),
        "deeper": (v.bottom[b] - v.bottom[a]) / max(highest - lowest, SAME.HEIGHT),
        "same_top": same(v.top),
        "same_begin": same(v.begin),
        "higher_begin": higher(v.begin),
        "size": ratio(size, 0.0),
        "length": ratio(v.length, VISITS.SMALL),
        "block_length": ratio(v.length / v.blocks, VISITS.SMALL),
        "block_count": np.log(more / fewer),
        "fewer_blocks": np.log(fewer),
        "more_blocks": np.log(more),
        "turn": ratio(v.turn, 0.1),
        "chord": np.abs(v.chord[b] - v.chord[a]),
        "closed": np.abs(v.closed[b] - v.closed[a]),
        "axis": np.abs(v.axis[b] - v.axis[a]),
        "visits": np.full(len(v) - 1, np.log(len(v))),
    }  # fmt: skip
    measures["again"], measures["again_above"] = _cut_again(v)
    # What the pairs before and after show: a regular series goes on.
    for name in ("same_ground", "overlap", "same_top", "same_bottom", "same_feed"):
        values = measures[name]
        if len(values) > 1:
            values = np.concatenate([values[1:2], values, values[-2:-1]])
            measures["series_" + name] = (values[:-2] + values[2:]) / 2
        else:
            measures["series_" + name] = values
    return np.column_stack([measures[name] for name in MEASURES])


def _ground(v: Visits) -> np.ndarray:
    """Area of the box of each visit, (k,) mm2; a hole has a little."""
    area: np.ndarray = np.prod(v.high - v.low + VISITS.SMALL, axis=1)
    return area


def _shared_ground(v: Visits, back: int) -> np.ndarray:
    """Area that the box of each visit has in common with that of the one `back` visits before it, (k - back,) mm2."""
    sides = np.minimum(v.high[back:], v.high[:-back]) - np.maximum(v.low[back:], v.low[:-back]) + VISITS.SMALL
    area: np.ndarray = np.prod(np.maximum(sides, 0.0), axis=1)
    return area


def _cut_again(v: Visits) -> tuple[np.ndarray, np.ndarray]:
    """Return how much of each visit's ground but the first's one of the last visits covers, (k-1,) each.

    The first counts visits as deep or deeper, the second deeper ones: operations seldom cut what they have cut.
    """
    again = np.zeros((2, len(v) - 1))
    ground = _ground(v)
    for back in range(1, min(VISITS.EARLIER, len(v) - 1) + 1):
        share = _shared_ground(v, back) / ground[back:]
        higher = v.bottom[back:] - v.bottom[:-back]
        for of, deep in zip(again[:, back - 1 :], (higher > -SAME.HEIGHT, higher > SAME.HEIGHT)):
            np.maximum(of, share * deep, out=of)
    return again[0], again[1]


def begun(toolpath: Toolpath, moves: Areas) -> dict[int, float]:
    """Return the trajectories with which another operation may begin, told from the motion alone, and how likely it is.

    FreeCAD retracts within one operation and foreign programs do not mark theirs: a retract to the top height is a
    border only where what follows differs from what came before in feed, ground, depths or pattern as it does between
    operations. How such differences go together was learned (benchmarks/learn_borders.py). What lies between two
    borders and holds no other such retract is divided in turn at those to its own top height: a tool is changed higher than
    any operation retracts.
    """
    found, alone = _begun(toolpath, moves, VISITS.DOUBTFUL)
    for _ in range(VISITS.NESTED):
        within = [_begun(toolpath, monotonous_areas(toolpath, *visit), VISITS.BORDER) for visit in alone]
        found.update(dict.fromkeys((at for lower, _ in within for at in lower), VISITS.BORDER))
        alone = [visit for _, visits in within for visit in visits]
    return dict(sorted(found.items(), key=lambda of: -of[1])[: VISITS.MOST])


def _begun(toolpath: Toolpath, moves: Areas, least: float) -> tuple[dict[int, float], list[tuple[int, int]]]:
    """Return the same of the retracts to the top height, and the visits that stand alone and retract lower down."""
    visits = find_visits(toolpath, moves)
    if visits is None:
        return {}, []
    share = FOREST.shares(compared(visits))[:, 1]
    at = np.flatnonzero(share > least)
    # Before the way down to the next visit.
    z = toolpath.points[:, 2]
    gaps = zip(visits.last[at] + 1, visits.first[at + 1] + 1)
    found = {int(a + np.argmax(z[a:b])): float(s) for (a, b), s in zip(gaps, share[at])}
    begin = np.append(0, at + 1)
    alone = begin[np.diff(begin, append=len(visits)) == 1]
    alone = alone[visits.blocks[alone] > 1]
    return found, list(zip(visits.first[alone].tolist(), visits.last[alone].tolist()))
