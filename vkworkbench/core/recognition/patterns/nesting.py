# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the distances between rings inside one another, and find the largest distance in one pocket."""

from __future__ import annotations

from typing import Dict, NamedTuple

import numpy as np

from vkworkbench.core.recognition.thresholds import MAJORITY, NESTS, ROUNDING, WATERLINES


class Shapes(NamedTuple):
    """The measures by which k rings are compared.

    Attributes
    ----------
    sides : (4, k) float
        Lowest x, lowest y, negative highest x and negative highest y, mm.
    size, z : (k,) float
        Longer side of the box, and mean height, mm.
    flat : (k,) bool
        Whether the ring stays at one height.
    enclosed, length : (k,) float
        Enclosed area, mm2, and length, mm.
    sense : (k,) float
        +1 for a counter-clockwise ring, -1 for a clockwise one.
    wavy : (k,) bool
        Whether the ring is possibly a pass of a lattice (a pattern that bounces from wall to wall). The bounding boxes
        of two passes of a lattice do not show the distance between the passes.
    slack : (k,) float
        Tolerance factor: 1 for closed loops; 2 for turns of spirals and other windings, which are open and have
        approximate areas.
    turn, rest : (k,) bool
        Whether the ring is a full horizontal turn of a winding such as a spiral; whether the ring is the rest of a
        winding after its last full turn.
    """

    sides: np.ndarray
    size: np.ndarray
    z: np.ndarray
    flat: np.ndarray
    enclosed: np.ndarray
    length: np.ndarray
    sense: np.ndarray
    wavy: np.ndarray
    slack: np.ndarray
    turn: np.ndarray
    rest: np.ndarray


class Shift(NamedTuple):
    """How far each ring lies inside the ring that was cut `lag` rings earlier, (k - lag,) mm each.

    Attributes
    ----------
    low, high, mean : array
        Smallest, largest and mean inward shift of the bounding box's four sides; negative where the later ring is the
        outer ring.
    step : array
        Distance between the two rings; 0 if neither ring is an offset of the other ring.
    """

    low: np.ndarray
    high: np.ndarray
    mean: np.ndarray
    step: np.ndarray


class Inward(Dict[int, Shift]):
    """How far each ring lies inside an earlier ring; the key is the `lag`, which is 1 for the previous ring.

    Each shift is computed at its first use.

    The distance between two parallel curves is 2 dA / (P1 + P2), where dA is the difference of their areas and P1 and
    P2 are their lengths (Steiner's formula). Steiner's formula is valid for curves in any orientation. An inner
    offset's bounding box is shifted inwards at all four sides. The smallest of the four shifts is about the distance
    between the curves, or more if a sharp corner touches the box. If the smallest shift is much less or much more than
    the distance by Steiner's formula, a part of the area between the two curves is an island. If a pocket is open at a
    straight side, the boxes of all offsets share this side, and at most one adjacent side. The shared sides of the
    boxes are not shifted, so that only the other sides show the distance.

    Parameters
    ----------
    shapes : Shapes
        The k rings in the order of cutting.
    """

    def __init__(self, shapes: Shapes) -> None:
        self.shapes = shapes

    def __missing__(self, lag: int) -> Shift:
        sides, length, slack, wavy = self.shapes.sides, self.shapes.length, self.shapes.slack, self.shapes.wavy
        moved = sides[:, lag:] - sides[:, :-lag]
        low, high, mean = moved.min(axis=0), moved.max(axis=0), moved.sum(axis=0) / 4
        around, one_way = length[lag:] + length[:-lag], low * high > 0
        near, loose = np.minimum(np.abs(low), np.abs(high)), slack[lag:]
        some = np.flatnonzero((near < ROUNDING.PLACE) & (slack[lag:] == 1) & (slack[:-lag] == 1))
        if len(some):
            shares, alike, least, shared = _beside_shared_sides(moved[:, some], sides[:, some + lag] + sides[:, some])
            some = some[shares]
            one_way[some], near[some] = alike, least
            around[some] = np.maximum(around[some] - shared, ROUNDING.PLACE)
        step = 2 * np.abs(self.shapes.enclosed[lag:] - self.shapes.enclosed[:-lag]) / around
        fits = near > NESTS.SIDE_AT_LEAST * step / loose - ROUNDING.PLACE
        fits &= near < NESTS.SIDE_AT_MOST * step * loose + ROUNDING.PLACE
        # An offset that also runs around an island is longer than the next outer ring, but all four sides of its box
        # are shifted by the same distance.
        longer = (length[lag:] - length[:-lag]) * mean > 0
        alike = (high - low <= NESTS.EQUAL_SIDES * np.abs(mean)) & longer & ~(wavy[lag:] | wavy[:-lag])
        step = np.where(alike & ~fits, near, np.minimum(step, near))
        self[lag] = found = Shift(low, high, mean, np.where(one_way & (fits | alike), step, 0.0))
        return found

    def is_step(self, lag: int) -> np.ndarray:
        """Return whether the distance to the ring `lag` rings later is a stepover between offsets, (k - lag,) bool.

        A stepover is larger than rounding errors, and small compared with the rings.
        """
        size, step = self.shapes.size, self[lag].step
        return (step > ROUNDING.RING) & (step <= NESTS.LARGEST_STEP * np.maximum(size[lag:], size[:-lag]))

    def drop(self, lag: int) -> np.ndarray:
        """Return the difference in height to the ring `lag` rings later, (k - lag,) mm."""
        return np.abs(self.shapes.z[lag:] - self.shapes.z[:-lag])


def _beside_shared_sides(moved: np.ndarray, sides: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Measure the pairs of closed rings whose bounding boxes share one or two sides.

    Parameters
    ----------
    moved, sides : (4, k) float
        Shift of each side from one box to the other box, and sum of the two boxes' coordinates of this side, mm.

    Returns
    -------
    shares : (s,) int
        Indices of the pairs of rings whose bounding boxes share sides.
    alike : (s,) bool
        Whether the unshared sides are all shifted inwards, or all outwards, by similar distances.
    least : (s,) float
        Smallest shift of the unshared sides, mm.
    along : (s,) float
        Length of both rings along the shared sides, mm.
    """
    still = np.abs(moved) < ROUNDING.PLACE
    count = np.count_nonzero(still, axis=0)
    shares = np.flatnonzero((count > 0) & (count <= NESTS.SHARED))
    moved, still = moved[:, shares], still[:, shares]
    low, high = np.where(still, np.inf, moved).min(axis=0), np.where(still, -np.inf, moved).max(axis=0)
    least, most = np.sort(np.abs([low, high]), axis=0)
    wide, tall = -(sides[:2] + sides[2:])[:, shares]
    along = still[1::2].sum(axis=0) * wide + still[::2].sum(axis=0) * tall
    return shares, (low * high > 0) & (most <= NESTS.SIDE_AT_MOST * least), least, along


def reach(inward: Inward, tool: float, area: np.ndarray) -> float:
    """Return the largest distance between neighbouring rings of one pocket (one nest), mm.

    If the tool's diameter is known, the largest distance is slightly more than the diameter. Rings at a larger distance
    leave uncut ground between them and are separate contours. If the tool is unknown, the largest distance is twice the
    usual distance between rings. If the tool is unknown, the distance must also be below a share of the largest ring's
    size, unless three rings are nested at equal distances or most rings are linked to the next ring without a lift.
    Because of this second limit, the inner and the outer contour of a washer are separate, even if both are repeated at
    every depth. Linked rings belong to one pocket, because a link between two contours of a part would cut into the
    part.

    Parameters
    ----------
    inward : Inward
    tool : float
        Tool diameter, mm; 0 if unknown.
    area : (k,) int
        Monotonous area of each ring.
    """
    if tool:
        return NESTS.REACH * tool
    steps, chained = _steps_in_nests(inward)
    if not len(steps):
        return 0.0
    # Use the lower quartile of the distances between rings: if rings around islands are cut between boundary rings,
    # only the smaller distances are the stepover.
    usual, largest = middle(steps, 4), float(inward.shapes.size.max())
    regular = np.count_nonzero(np.abs(steps - usual) < NESTS.SIMILAR_STEP * usual) / len(steps)
    is_nest = chained and regular >= MAJORITY.SHARE and usual <= NESTS.TOO_LARGE * largest
    if is_nest or _are_linked(inward, area):
        return NESTS.STEPS * usual
    return min(NESTS.STEPS * usual, NESTS.REACH_OF_SIZE * largest)


def _steps_in_nests(inward: Inward) -> tuple[np.ndarray, bool]:
    """Return the distances between nested rings of one depth, (s,) mm, and whether three rings have equal distances."""
    flat, found, chained = inward.shapes.flat, [], False
    for lag in range(1, min(NESTS.NEXT, len(flat) - 1) + 1):
        step, even = inward[lag].step, inward.is_step(lag)
        signed = np.copysign(step, inward[lag].mean)
        chain = even[lag:] & even[:-lag] & (np.abs(signed[lag:] - signed[:-lag]) < NESTS.SIMILAR_STEP * step[lag:])
        # Compare only rings of one depth, because a slightly sloped wall shifts a ring by less than the stepover.
        true = even & ((inward.drop(lag) < ROUNDING.HEIGHT) | ~flat[lag:] | ~flat[:-lag])
        chained = bool(chain.any())
        if chained:
            # In a chain of three rings at equal distances, the second offset is `lag` rings after the first offset.
            # Ignore the distances to a lead-in or to a wall, which are not the stepover.
            of_chain = np.zeros(len(step), bool)
            of_chain[lag:] = chain
            of_chain[:-lag] |= chain
            true &= of_chain
        found.append(step[true])
        if chained:
            break
    if any(map(len, found)):
        return np.concatenate(found), chained
    return next_steps(inward)[0], chained


def _are_linked(inward: Inward, area: np.ndarray) -> bool:
    """Return whether most rings are linked to the next or previous ring at their depth, without a lift."""
    pair = inward.is_step(1) & (inward.drop(1) < ROUNDING.HEIGHT) & (area[1:] == area[:-1])
    return bool((np.append(pair, False) | np.append(False, pair)).mean() > MAJORITY.SHARE)


def next_steps(inward: Inward) -> tuple[np.ndarray, np.ndarray]:
    """Return the horizontal and the vertical distance from each ring to the ring that is cut next, (s,) mm each."""
    if len(inward.shapes.z) < 2:
        return np.zeros(0), np.zeros(0)
    even = inward.is_step(1)
    return inward[1].step[even], inward.drop(1)[even]


def evenness(steps: np.ndarray, drops: np.ndarray) -> float:
    """Compare how regular the rings' distances are in the plane and in height.

    Returns
    -------
    float
        Relative spread of the horizontal distances, divided by the relative spread of the vertical distances. A ratio
        below 1 means that the horizontal distances are more regular; rings of a single depth have the ratio 0.
    """
    if len(steps) < 3 or drops.max() < ROUNDING.HEIGHT:
        return 0.0
    spread = [np.ptp(np.percentile(v, (10, 90))) / max(np.median(v), 1e-9) for v in (steps, drops)]
    return float((spread[0] + WATERLINES.ROUNDING) / (spread[1] + WATERLINES.ROUNDING))


def middle(values: np.ndarray, part: int = 2) -> float:
    """Return the median of the values, or their lower quartile if `part` is 4, in linear time."""
    at = len(values) // part
    return float(np.partition(values, at)[at])
