# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the rings of an operation, closed loops and turns of windings, lie to one another."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.paper import TURN
from vkworkbench.core.recognition.pieces import WINDING, Pieces

LEVEL = 0.02  # mm; heights closer than this are one depth
ROUND = 0.93  # isoperimetric quotient 4 pi A / P^2 from which a ring is a circle (a square has 0.79)
LAGS = (1, 2, 3)  # rings are compared with the next three in the order of cutting: islands interleave


@dataclass(frozen=True)
class Rings:
    """Relations among k rings, each flag (k,) bool unless said otherwise.

    Attributes
    ----------
    index : (k,) int
        Piece of each ring.
    length : (k,) float
        mm.
    nested : array
        Another ring of the same depth lies beside it: all four sides of its box are moved in, or out, and
        the distance between the two is no more than a tool cuts.
    opposite : array
        The next such ring turns the other way.
    deeper : array
        A ring of another shape lies over or under it.
    repeated : array
        The same ring comes again at another depth.
    stacked : array
        It comes again next, with no other pattern between, as the turns of a helix do.
    moved : array
        A ring of about its size lies shifted beside it and overlaps it: trochoids.
    crossing : array
        A ring of another shape touches the same four sides: lattices of bouncing passes.
    alone : array
        None of these.
    winding, round, sloped : array
        A turn of a winding; a circle; descends or climbs steadily all along.
    back : (k,) float
        Turning that undid itself, rad.
    step : float
        Distance from a nested ring to the nearest other one (median), mm; nan where none are nested.
    growing : float
        Share of the steps that go outward; nan where none are nested.
    distinct, levels : int
        Number of different rings seen from above, and of depths.
    depth : float
        Range of the depths, mm.
    evenness : float
        Spread of the steps in the plane over their spread in depth: circles laid on a dome are even in the
        plane, waterlines of it in depth.
    """

    index: np.ndarray
    length: np.ndarray
    nested: np.ndarray
    opposite: np.ndarray
    deeper: np.ndarray
    repeated: np.ndarray
    stacked: np.ndarray
    moved: np.ndarray
    crossing: np.ndarray
    alone: np.ndarray
    winding: np.ndarray
    round: np.ndarray
    sloped: np.ndarray
    back: np.ndarray
    step: float
    growing: float
    distinct: int
    levels: int
    depth: float
    evenness: float

    def __len__(self) -> int:
        """Return the number of rings."""
        return len(self.index)


def relate_rings(pieces: Pieces, index: np.ndarray, tool: float) -> Rings:
    """Compare every ring with the next three in the order of cutting: O(k).

    Parameters
    ----------
    pieces : Pieces
    index : (k,) int
        The pieces that are rings.
    tool : float
        Tool diameter, mm; 0 where unknown.
    """
    k = len(index)
    box, z, flat = pieces.box[index], pieces.z[index], pieces.flat[index]
    enclosed, length = np.abs(pieces.enclosed[index]), pieces.length[index]
    sense = np.sign(pieces.net[index])
    size = np.maximum(box[:, 2] - box[:, 0], box[:, 3] - box[:, 1])
    sides = np.ascontiguousarray((box * (1, 1, -1, -1)).T)
    winding = pieces.kind[index] == WINDING
    wavy = pieces.wavy[index] | (winding & (pieces.back[index] > 0.5 * TURN))
    slack = np.where(winding, 2.0, 1.0)
    # The narrower side of the rectangle of the same area and perimeter, however a ring is turned.
    width = slack * (length / 4 - np.sqrt(np.maximum((length / 4) ** 2 - enclosed, 0)))
    middle = (box[:, :2] + box[:, 2:]) / 2
    names = ("nested", "opposite", "deeper", "repeated", "moved", "crossing")
    flags = {name: np.zeros(k, bool) for name in names}
    inward = _Inward(sides, enclosed, length, slack)
    limit, next_step, next_drop = _reach(inward, size, z, flat, tool)
    steps, nearest = [], np.full(k, np.inf)  # the next but one is two steps away
    for lag in LAGS[: max(k - 1, 0)]:
        a, b = slice(None, -lag), slice(lag, None)
        low, high, mean, step = inward[lag]
        larger, smaller = np.maximum(size[a], size[b]), np.minimum(size[a], size[b])
        level = np.abs(z[a] - z[b]) < LEVEL
        # Rings on a sculptured surface have no depth of their own: nearness in the plane decides.
        beside = level | ~flat[a] | ~flat[b]
        same_box = np.maximum(-low, high) < np.minimum(0.05 + 0.002 * larger, max(0.25 * limit, 0.05))
        same_area = np.abs(enclosed[a] - enclosed[b]) < 0.05 * np.maximum(enclosed[a], enclosed[b])
        even = ~same_box & (step > 0.01) & (step <= limit)
        # Passes of a lattice that wind by chance are seldom even; offsets of a concave contour are exactly.
        even &= ~(wavy[a] & wavy[b]) | (high - low <= 0.1 * np.abs(mean) + 0.02)
        straddling = ~same_box & (low < 0) & (high > 0)
        # Trochoids bite into one another; ribs in a row, and the loops around them, stay apart.
        straddling &= np.hypot(*(middle[b] - middle[a]).T) < np.minimum(width[a], width[b])
        found = {
            "nested": even & beside,
            "deeper": ~same_box & ~beside & (low > -smaller),
            "repeated": same_box & same_area & ~level,
            "moved": beside & straddling & (np.abs(mean) < 0.35 * (high - low)) & (high - low < 1.2 * smaller)
            & (smaller > 0.65 * larger),
            "crossing": level & same_box & ~same_area,
        }  # fmt: skip
        if lag == 1:
            # The loops of one pattern keep their shape; a boundary and an island between its offsets do not.
            turns = even & (high - low <= 0.3 * np.abs(mean) + 0.02) & (sense[a] != sense[b])
            # And it goes on to a third: an outline and the hole in it are cut in opposite senses, too.
            onward = turns[1:] & turns[:-1] & (mean[1:] * mean[:-1] > 0)
            found["opposite"] = np.append(onward, False) | np.append(False, onward)
        steps.append(mean[even & beside])
        apart = np.where(even & beside, step, np.inf)
        nearest[a], nearest[b] = np.minimum(nearest[a], apart), np.minimum(nearest[b], apart)
        for name, flag in found.items():
            flags[name][a] |= flag
            flags[name][b] |= flag
        if flags["nested"].all():
            break
    levels = count_levels(z)
    again, distinct = _come_again(pieces, index) if levels > 1 else (np.zeros(k, bool), k)
    flags["stacked"] = flags["repeated"].copy()
    flags["repeated"] |= again
    flags["deeper"] &= ~again
    related = flags["nested"] | flags["deeper"] | flags["repeated"] | flags["moved"] | flags["crossing"]
    steps = np.concatenate(steps) if steps else np.zeros(0)
    return Rings(
        index=index,
        length=length,
        alone=~related,
        winding=winding,
        round=4 * np.pi * enclosed > ROUND * length**2,
        sloped=_sloped(pieces, index),
        back=pieces.back[index],
        step=_middle(nearest[flags["nested"]]) if len(steps) else np.nan,
        growing=float((steps < 0).mean()) if len(steps) else np.nan,
        distinct=distinct,
        levels=levels,
        depth=float(np.ptp(z)) if k else 0.0,
        evenness=_evenness(next_step, next_drop) if levels > 2 else 0.0,
        **flags,
    )


def _sloped(pieces: Pieces, index: np.ndarray) -> np.ndarray:
    """Say which pieces change their height steadily: the mean height lies in the middle of the drop.

    A contour that ramps in over its first moves and is level then does not.
    """
    drop = pieces.drop[index]
    middle = pieces.z[index] - pieces.last_z[index] + drop / 2
    return (np.abs(drop) > LEVEL) & (np.abs(middle) < 0.2 * np.abs(drop))


def count_levels(z: np.ndarray) -> int:
    """Return how many different heights there are."""
    if not len(z):
        return 0
    z = np.sort(z)
    return 1 + int((z[1:] - z[:-1] > LEVEL).sum())


def _middle(values: np.ndarray, part: int = 2) -> float:
    """Return the value at half the count, or at a quarter; O(n)."""
    at = len(values) // part
    return float(np.partition(values, at)[at])


class _Inward(dict):
    """By lag, how far the sides of a ring's box lie inside those `lag` rings before: least, most, mean, and the
    distance between the two rings, 0 where they are no offsets of one another.

    Two parallel curves lie 2 dA / (P1 + P2) apart, by the difference in area and the lengths (Steiner's
    formula), which does not depend on how they are turned. All four sides of an offset's box move the same
    way, the least of them by about that much; farther where a sharp corner touches the box. By less than the
    distance no side can move: where an island takes a part of the area, the box tells it.
    The turns of windings (slack 2) are open and enclose only about what a loop (slack 1) does.
    """

    def __init__(self, sides, enclosed, length, slack) -> None:
        self._of = sides, enclosed, length, slack

    def __missing__(self, lag: int) -> tuple[np.ndarray, ...]:
        sides, enclosed, length, slack = self._of
        moved = sides[:, lag:] - sides[:, :-lag]
        low, high, mean = moved.min(axis=0), moved.max(axis=0), moved.sum(axis=0) / 4
        step = 2 * np.abs(enclosed[lag:] - enclosed[:-lag]) / (length[lag:] + length[:-lag])
        near, loose = np.minimum(np.abs(low), np.abs(high)), slack[lag:]
        fits = (near > 0.5 * step / loose - 0.02) & (near < 1.5 * step * loose + 0.02)
        self[lag] = low, high, mean, np.where((low * high > 0) & fits, np.minimum(step, near), 0.0)
        return self[lag]


def _reach(inward, size, z, flat, tool) -> tuple[float, np.ndarray, np.ndarray]:
    """Return how far apart nested rings may be, and the steps in the plane and in depth from ring to next
    ring.

    A little over the tool's diameter: farther apart nothing between them is cut and they are two contours.
    Where the tool is unknown, or at least four even steps say it is wrong, twice the usual step; but only
    where three rings at least lie inside one another, because contours of one part, as a washer has, are no
    pocket when one is inside the other, and come again at every depth.
    """
    steps = drops = np.zeros(0)
    found, chained = [], False
    for lag in LAGS[: max(len(z) - 1, 0)]:
        mean, step = inward[lag][2:]
        even = (step > 0.05) & (step <= 0.3 * np.maximum(size[lag:], size[:-lag]))
        drop = np.abs(z[lag:] - z[:-lag])
        if lag == 1:
            steps, drops = step[even], drop[even]
        signed = np.copysign(step, mean)
        chain = even[lag:] & even[:-lag] & (np.abs(signed[lag:] - signed[:-lag]) < 0.3 * step[lag:])
        # A wall that slopes a little moves the loops of the next depth by less than any step.
        found.append(step[even & ((drop < LEVEL) | ~flat[lag:] | ~flat[:-lag])])
        if chain.any():
            chained = True
            break  # the next ring of the nest is this neighbour
    every = np.concatenate(found) if any(map(len, found)) else steps
    if not len(every):
        return 1.2 * tool, steps, drops
    # Rings around islands interleave with those of the boundary; the smaller steps are between neighbours.
    usual = _middle(every, 4)
    regular = (np.abs(every - usual) < 0.3 * usual).mean()
    if not tool and (not chained or regular < 0.5 or usual > 0.2 * size.max()):
        return min(2 * usual, 0.05 * float(size.max())), steps, drops
    if not tool or (chained and len(steps) >= 4 and (np.abs(steps - usual) < 0.1 * usual).mean() > 0.6):
        return max(1.2 * tool, 2 * usual), steps, drops
    return 1.2 * tool, steps, drops


def _come_again(pieces: Pieces, index: np.ndarray) -> tuple[np.ndarray, int]:
    """Say which rings come again at another depth, and how many different ones there are seen from above."""
    if not len(index):
        return np.zeros(0, bool), 0
    group, distinct = footprints(pieces, index)
    z = pieces.z[index]
    lowest, highest = np.full(distinct, np.inf), np.full(distinct, -np.inf)
    np.minimum.at(lowest, group, z)
    np.maximum.at(highest, group, z)
    return (highest - lowest > LEVEL)[group], distinct


def footprints(pieces: Pieces, index: np.ndarray) -> tuple[np.ndarray, int]:
    """Group pieces that cover the same ground: equal boxes to 0.1 mm, equal lengths to 0.4 mm.

    Returns
    -------
    group : (k,) int
    groups : int
    """
    return same_ground(pieces.box[index], pieces.length[index])


def same_ground(box: np.ndarray, length: np.ndarray) -> tuple[np.ndarray, int]:
    """Group stretches by their boxes (k, 4), to 0.1 mm, and lengths (k,), to 0.4 mm; return as :func:`footprints`."""
    measures = np.column_stack([box, length / 4])
    key = np.floor(measures / 0.1 + 0.377).astype(np.int64)
    key = (key * (73856093, 19349663, 83492791, 49979687, 86028121)).sum(axis=1)
    unique, group = np.unique(key, return_inverse=True)
    return group.ravel(), len(unique)


def _evenness(steps: np.ndarray, drops: np.ndarray) -> float:
    """Return the relative spread of the steps in the plane over that in depth; 0 where there is no depth."""
    if len(steps) < 3 or drops.max() < LEVEL:
        return 0.0
    spread = [np.ptp(np.percentile(v, (10, 90))) / max(np.median(v), 1e-9) for v in (steps, drops)]
    return float((spread[0] + 0.01) / (spread[1] + 0.01))
