# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nesting: how far a ring lies inside another, and how far apart the rings of one pocket may lie."""

from __future__ import annotations

from typing import Dict, Tuple

import numpy as np

from vkworkbench.core.recognition.thresholds import MAJORITY, NESTS, ROUNDING, WATERLINES


class Inward(Dict[int, Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]]):
    """How far each ring lies inside the one that was cut `lag` rings before it: inward[lag], each (k - lag,).

    Four arrays in mm: the least and the most that one of the four sides of the bounding box lies inside, their
    mean (negative where the later ring is the outer one), and the distance between the two rings, 0 where
    neither is an offset of the other.

    Two parallel curves lie 2 dA / (P1 + P2) apart, with the difference of their areas and their lengths
    (Steiner's formula), however they are turned. All four sides of an offset's box move the same way, the
    least of them by about that distance, or by more where a sharp corner touches the box. A box that moved by
    much less or more than the distance tells that an island takes a part of the area. The offsets in a pocket that is open
    at a straight side share that side, and one beside it at most: these do not move, and only the others tell the distance.

    Parameters
    ----------
    sides : (4, k) float
        Lowest x and y, highest x and y with their signs changed, mm.
    enclosed, length : (k,) float
        mm2, mm.
    slack : (k,) float
        1 for closed loops; 2 for turns of windings, which are open and enclose only about as much.
    """

    def __init__(self, sides: np.ndarray, enclosed: np.ndarray, length: np.ndarray, slack: np.ndarray) -> None:
        self._of = sides, enclosed, length, slack

    def __missing__(self, lag: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        sides, enclosed, length, slack = self._of
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
        step = 2 * np.abs(enclosed[lag:] - enclosed[:-lag]) / around
        fits = near > NESTS.SIDE_AT_LEAST * step / loose - ROUNDING.PLACE
        fits &= near < NESTS.SIDE_AT_MOST * step * loose + ROUNDING.PLACE
        self[lag] = low, high, mean, np.where(one_way & fits, np.minimum(step, near), 0.0)
        return self[lag]


def _beside_shared_sides(moved: np.ndarray, sides: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Measure pairs of closed rings whose boxes share a side or two, by how far their sides moved, and the sums of both boxes' sides.

    Parameters
    ----------
    moved, sides : (4, k) float
        mm.

    Returns
    -------
    shares : (s,) int
        Which of the pairs do.
    alike : (s,) bool
        Whether their other sides moved the same way, none much farther than another.
    least : (s,) float
        By how much the other sides moved at least, mm.
    along : (s,) float
        How long both rings run along the sides that they share, mm.
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


def reach(
    inward: Inward, size: np.ndarray, z: np.ndarray, flat: np.ndarray, tool: float, area: np.ndarray
) -> tuple[float, np.ndarray, np.ndarray]:
    """Tell how far apart the rings of one nest may lie.

    A little over the tool's diameter: farther apart nothing between them is cut and they are two contours.
    Twice the usual step, where the tool is unknown; but only where at least three rings lie inside one another, or most are
    linked at their depth without a lift. Two contours of one part, as a washer has them, are no pocket when one lies
    inside the other and both come again at every depth; the way from one to the other would cut into the part.

    Parameters
    ----------
    inward : Inward
    size, z : (k,) float
        Longer side of the box and mean height of each ring, mm.
    flat : (k,) bool
    tool : float
        Tool diameter, mm; 0 where unknown.
    area : (k,) int
        The monotonous area that each ring lies in.

    Returns
    -------
    limit : float
        mm.
    steps, drops : (s,) float
        Distance in the plane and in height from each ring to the next one, where they are even, mm.
    """
    steps = drops = np.zeros(0)
    found, chained, joined = [], False, False
    for lag in range(1, min(NESTS.NEXT, len(z) - 1) + 1):
        mean, step = inward[lag][2:]
        even = (step > ROUNDING.RING) & (step <= NESTS.LARGEST_STEP * np.maximum(size[lag:], size[:-lag]))
        drop = np.abs(z[lag:] - z[:-lag])
        if lag == 1:
            steps, drops = step[even], drop[even]
            pair = even & (drop < ROUNDING.HEIGHT) & (area[1:] == area[:-1])
            linked = np.append(pair, False) | np.append(False, pair)
            joined = bool(linked.mean() > MAJORITY.SHARE)
        signed = np.copysign(step, mean)
        chain = even[lag:] & even[:-lag] & (np.abs(signed[lag:] - signed[:-lag]) < NESTS.SIMILAR_STEP * step[lag:])
        # At another depth a wall that slopes a little moves the ring by less than any step.
        true = even & ((drop < ROUNDING.HEIGHT) | ~flat[lag:] | ~flat[:-lag])
        if chain.any():
            chained = True
            # The next ring of the nest is the one `lag` rings on. The step from a way in, or to a wall, is another.
            of_chain = np.zeros(len(step), bool)
            of_chain[lag:] = chain
            of_chain[:-lag] |= chain
            found.append(step[true & of_chain])
            break
        found.append(step[true])
    every = np.concatenate(found) if any(map(len, found)) else steps
    if tool or not len(every):
        return NESTS.REACH * tool, steps, drops
    # Where the rings around islands are cut between those of the boundary, the smaller steps are the true ones.
    usual = middle(every, 4)
    regular = np.count_nonzero(np.abs(every - usual) < NESTS.SIMILAR_STEP * usual) / len(every)
    too_large = usual > NESTS.TOO_LARGE * size.max()
    if not joined and (not chained or regular < MAJORITY.SHARE or too_large):
        return min(NESTS.STEPS * usual, NESTS.REACH_OF_SIZE * float(size.max())), steps, drops
    return NESTS.STEPS * usual, steps, drops


def evenness(steps: np.ndarray, drops: np.ndarray) -> float:
    """Compare how regular the steps in the plane and in depth are.

    Returns
    -------
    float
        Relative spread of the steps in the plane over that in depth: under 1 where the plane is divided more
        evenly; 0 where there is no depth.
    """
    if len(steps) < 3 or drops.max() < ROUNDING.HEIGHT:
        return 0.0
    spread = [np.ptp(np.percentile(v, (10, 90))) / max(np.median(v), 1e-9) for v in (steps, drops)]
    return float((spread[0] + WATERLINES.ROUNDING) / (spread[1] + WATERLINES.ROUNDING))


def middle(values: np.ndarray, part: int = 2) -> float:
    """Return the value at half the count, or at a quarter (part 4); O(n)."""
    at = len(values) // part
    return float(np.partition(values, at)[at])
