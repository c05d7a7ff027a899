# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find where another operation begins, among the retracts to the top height.

A visit is all cutting between two retracts to the top height.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from vkworkbench.core.paper import TURN, Areas, monotonous_areas
from vkworkbench.core.recognition.thresholds import ROUNDING, VISITS
from vkworkbench.core.recognition.verdict.model import Trees, read_trees
from vkworkbench.core.toolpath import Toolpath

FILE = Path(__file__).with_name("borders.npz")


@lru_cache(maxsize=1)
def shipped_trees() -> Trees:
    """Return the decision trees that vote whether another operation begins at a retract (class 1).

    The file with the trees is read when first needed.
    """
    with np.load(FILE, allow_pickle=False) as arrays:
        return read_trees(arrays, "borders")


@dataclass(frozen=True)
class Visits:
    """Measures of k visits (the cutting between two retracts to the top height).

    Attributes
    ----------
    first, last : (k,) int
        First and last cutting trajectory.
    blocks : (k,) int
        Number of blocks. A block of a visit is a monotonous area or a drilled hole.
    low, high : (k, 2) float
        Bounding box in the plane, mm.
    bottom, top, begin : (k,) float
        Lowest and highest cutting height of the visit, and highest cutting height of its first block, mm.
    length : (k,) float
        Cutting length in the plane, mm.
    feed, fastest : (k,) float
        Mean feed weighted by length, and highest feed, mm/s.
    turn : (k,) float
        Mean of the blocks' absolute net turns, in full turns.
    chord, closed : (k,) float
        Sum of the distances between the two ends of each block, and total length of the closed blocks, both divided by
        the visit's cutting length.
    axis : (k,) complex
        Sum of the moves as complex numbers with doubled angles, divided by the visit's cutting length. The magnitude is
        1 if all moves have one axis.
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
    """Divide all cutting into visits at the retracts to the top height; return None if there is only one visit.

    Parameters
    ----------
    toolpath : Toolpath
    moves : Areas
        Areas of the whole toolpath.
    """
    if len(moves.start) + len(moves.holes) < 2:
        return None
    low, high, add = np.minimum.reduceat, np.maximum.reduceat, np.add.reduceat
    # A visit (the cutting between two retracts) consists of blocks; a block is a monotonous area or a drilled hole. A
    # hole is treated as one move without length at the bottom of the hole.
    hole, none = toolpath.points[moves.holes + 1], np.zeros(len(moves.holes))
    index, begins = np.concatenate([moves.index, moves.holes]), np.ones(len(moves) + len(none), bool)
    begins[: len(moves)] = False
    begins[moves.start] = True
    order = np.argsort(index, kind="stable")
    index, start = index[order], np.flatnonzero(begins[order])
    last = np.append(start[1:], len(index)) - 1
    x, y, z, dx, dy, length, turning, axis = (
        np.concatenate([of_moves, of_holes])[order]
        for of_moves, of_holes in (
            (moves.x, hole[:, 0]), (moves.y, hole[:, 1]), (moves.z, hole[:, 2]), (moves.dx, none), (moves.dy, none),
            (moves.length, none), (moves.turning, none), (np.exp(2j * moves.alpha) * moves.length, none),
        )
    )  # fmt: skip
    end_x, end_y, fed, weight = x[last] + dx[last], y[last] + dy[last], toolpath.feed[index], np.maximum(length, 1e-9)
    first, end = index[start], index[last]
    # Find the tool's highest point between the end of each block and the start of the next block.
    height = toolpath.points[:, 2]
    between = np.column_stack([end[:-1] + 1, np.maximum(first[1:], end[:-1] + 1) + 1]).ravel()
    reached = np.maximum.reduceat(np.append(height, -np.inf), between)[::2]
    parted = reached >= reached.max() - ROUNDING.HEIGHT
    if not parted.any():
        return None
    begin = np.flatnonzero(np.append(True, parted))
    count = np.diff(begin, append=len(start))
    whole, gap = add(length, start), np.hypot(end_x - x[start], end_y - y[start])
    feed, share = add(fed * weight, start) / add(weight, start), np.maximum(whole, 1e-6)
    way = add(whole, begin)
    some = np.maximum(way, 1e-9)
    return Visits(
        first=first[begin],
        last=end[begin + count - 1],
        blocks=count,
        low=np.column_stack([low(np.minimum(low(v, start), e), begin) for v, e in ((x, end_x), (y, end_y))]),
        high=np.column_stack([high(np.maximum(high(v, start), e), begin) for v, e in ((x, end_x), (y, end_y))]),
        bottom=low(z, start[begin]),
        top=high(z, start[begin]),
        begin=high(z, start)[begin],
        length=way,
        feed=add(feed * share, begin) / add(share, begin),
        fastest=high(fed, start[begin]),
        turn=add(np.abs(add(turning, start)), begin) / count / TURN,
        chord=add(gap, begin) / some,
        closed=add((gap < VISITS.CLOSED * whole) * whole, begin) / some,
        axis=add(axis, start[begin]) / some,
    )


def compare_visits(visits: Visits) -> dict[str, np.ndarray]:
    """Compare every visit (the cutting between two retracts) with the next visit.

    Return the dimensionless measures of each pair of consecutive visits, (k-1,) each.
    """
    a, b = slice(None, -1), slice(1, None)

    def differ(values: np.ndarray, least: float = 1e-6) -> np.ndarray:
        """Return the relative difference of values that are not negative."""
        larger = np.maximum(values[a], values[b])
        return np.abs(values[b] - values[a]) / np.maximum(larger, least)

    def ratio(values: np.ndarray, least: float) -> np.ndarray:
        """Return the absolute logarithm of the ratio of two values."""
        return np.minimum(np.abs(np.log((values[a] + least) / (values[b] + least))), 6.0)

    def same(values: np.ndarray) -> np.ndarray:
        return (np.abs(values[b] - values[a]) < ROUNDING.HEIGHT).astype(float)

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
    # Average each measure over the previous and the next pair of visits. The averages show whether a pair of visits
    # belongs to a regular series of visits, as within one operation.
    for name in ("same_ground", "overlap", "same_top", "same_bottom", "same_feed"):
        values = measures[name]
        if len(values) > 1:
            values = np.concatenate([values[1:2], values, values[-2:-1]])
            measures["series_" + name] = (values[:-2] + values[2:]) / 2
        else:
            measures["series_" + name] = values
    return measures


def _ground(visits: Visits) -> np.ndarray:
    """Return the area of each visit's bounding box, (k,) mm2, which is small but positive for a drilled hole."""
    return np.prod(visits.high - visits.low + VISITS.SMALL, axis=1)


def _shared_ground(visits: Visits, back: int) -> np.ndarray:
    """Return the overlap of each visit's box with the box of the visit cut `back` visits earlier, (k - back,) mm2."""
    sides = (
        np.minimum(visits.high[back:], visits.high[:-back])
        - np.maximum(visits.low[back:], visits.low[:-back])
        + VISITS.SMALL
    )
    return np.prod(np.maximum(sides, 0.0), axis=1)


def _cut_again(visits: Visits) -> tuple[np.ndarray, np.ndarray]:
    """Return the share of each visit's bounding box that one of the previous visits covers, two arrays (k-1,).

    The first array compares each visit with previous visits at the same depth or deeper, the second array only with
    deeper visits. Within an operation, the same ground is rarely cut twice at the same height.
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
    """Return the trajectories at which another operation can begin, with probabilities computed from the motion alone.

    Programs do not mark their operations, and there are also retracts within an operation. Another operation begins at
    a retract to the top height only if feed, ground, depths or pattern change as between operations. A model learned
    from programs estimates the probability (benchmarks/learn_borders.py). If another operation begins both before and
    after a visit, the visit is searched again, at retracts to its own top height, because retracts for a tool change
    are higher than retracts within an operation.
    """
    found, alone = _retracts_to_top(toolpath, moves, VISITS.DOUBTFUL)
    for visit in alone:
        lower, _ = _retracts_to_top(toolpath, monotonous_areas(toolpath, *visit), VISITS.BORDER)
        found.update(dict.fromkeys(lower, VISITS.BORDER))
    return dict(sorted(found.items(), key=lambda of: -of[1])[: VISITS.MOST])


def _retracts_to_top(toolpath: Toolpath, moves: Areas, least: float) -> tuple[dict[int, float], list[tuple[int, int]]]:
    """Return {trajectory: probability} for retracts to the top height, and the visits that must be searched again."""
    visits = find_visits(toolpath, moves)
    if visits is None:
        return {}, []
    share = shipped_trees().shares(np.column_stack(list(compare_visits(visits).values())))[:, 1]
    at = np.flatnonzero(share > least)
    # Another operation begins at the highest point between two visits, before the descent to the second visit.
    z = toolpath.points[:, 2]
    gaps = zip(visits.last[at] + 1, visits.first[at + 1] + 1)
    found = {int(a + np.argmax(z[a:b])): float(s) for (a, b), s in zip(gaps, share[at])}
    begin = np.append(0, at + 1)
    alone = begin[np.diff(begin, append=len(visits)) == 1]
    alone = alone[visits.blocks[alone] > 1]
    return found, list(zip(visits.first[alone].tolist(), visits.last[alone].tolist()))
