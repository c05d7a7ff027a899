# SPDX-License-Identifier: LGPL-2.1-or-later
"""Visits: what a program cuts between two retracts to its top height, and which of them begin another operation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.paper import TURN, Areas, monotonous_areas
from vkworkbench.core.recognition.borders import MEASURES, TREES
from vkworkbench.core.recognition.forest import Forest
from vkworkbench.core.recognition.thresholds import SAME, VISITS
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


def find_visits(toolpath: Toolpath, moves: Areas) -> Visits | None:
    """Divide the cutting at the retracts to the program's top height; None where there is but one visit.

    Parameters
    ----------
    toolpath : Toolpath
    moves : Areas
        Of the whole toolpath.
    """
    areas = len(moves.start)
    size = areas + len(moves.holes)
    if size < 2:
        return None
    end = moves.end - 1 if areas else moves.start
    first = np.concatenate([moves.index[moves.start], moves.holes])
    last = np.concatenate([moves.index[end], moves.holes])
    order = np.argsort(first, kind="stable")
    first, last = first[order], last[order]
    # The height reached between the end of a block and the start of the next.
    z = toolpath.points[:, 2]
    between = np.column_stack([last[:-1] + 1, np.maximum(first[1:], last[:-1] + 1) + 1]).ravel()
    reached = np.maximum.reduceat(np.append(z, -np.inf), between)[::2]
    parted = reached >= reached.max() - SAME.HEIGHT
    if not parted.any():
        return None
    begin = np.flatnonzero(np.append(True, parted))
    measured = _blocks(toolpath, moves)
    low, high, bottom, top, length, gap, feed, fastest, turned, axis = (v[order] for v in measured)
    closed = (gap < VISITS.CLOSED * length) * length
    total = np.add.reduceat(length, begin)
    some = np.maximum(total, 1e-9)
    weight = np.maximum(length, 1e-6)
    count = np.diff(np.append(begin, size))
    return Visits(
        first=first[begin],
        last=last[np.append(begin[1:], size) - 1],
        blocks=count,
        low=np.minimum.reduceat(low, begin),
        high=np.maximum.reduceat(high, begin),
        bottom=np.minimum.reduceat(bottom, begin),
        top=np.maximum.reduceat(top, begin),
        begin=top[begin],
        length=total,
        feed=np.add.reduceat(feed * weight, begin) / np.add.reduceat(weight, begin),
        fastest=np.maximum.reduceat(fastest, begin),
        turn=np.add.reduceat(turned, begin) / count / TURN,
        chord=np.add.reduceat(gap, begin) / some,
        closed=np.add.reduceat(closed, begin) / some,
        axis=np.add.reduceat(axis, begin) / some,
    )


def _blocks(toolpath: Toolpath, m: Areas) -> tuple[np.ndarray, ...]:
    """Return the measures of every area, then of every hole; a hole has no length."""
    hole = toolpath.points[m.holes + 1]
    none = np.zeros(len(hole))
    feed = toolpath.feed[m.holes]
    of_holes = hole[:, :2], hole[:, :2], hole[:, 2], hole[:, 2], none, none, feed, feed, none, none
    if not len(m):
        return of_holes
    start, last = m.start, m.end - 1
    x, y = m.x[last] + m.dx[last], m.y[last] + m.dy[last]
    low, high, add = np.minimum.reduceat, np.maximum.reduceat, np.add.reduceat
    fed = toolpath.feed[m.index]
    axis = np.exp(2j * m.alpha)
    axis *= m.length
    of_areas = (
        np.column_stack([np.minimum(low(m.x, start), x), np.minimum(low(m.y, start), y)]),
        np.column_stack([np.maximum(high(m.x, start), x), np.maximum(high(m.y, start), y)]),
        low(m.z, start),
        high(m.z, start),
        m.area_length,
        np.hypot(x - m.x[start], y - m.y[start]),
        add(fed * m.length, start) / m.area_length,
        high(fed, start),
        np.abs(add(m.turning, start)),
        add(axis, start),
    )
    return tuple(np.concatenate(pair) for pair in zip(of_areas, of_holes))


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
