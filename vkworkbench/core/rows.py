# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows: long parallel passes side by side, and whether their direction alternates or stays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.areas import Moves

BINS = 72  # of 2.5 degrees over half a turn
ALIGNED = 0.05  # rad; a move this close to the axis belongs to a row
SAME_LINE = 0.02  # mm; passes closer than this are on one line


@dataclass(frozen=True)
class Rows:
    """Parallel passes of one axis.

    Attributes
    ----------
    axis : float
        Direction of the rows, rad in [0, pi).
    length : float
        Length of all passes, mm.
    typical : float
        Length of a pass (median by length), mm.
    count : int
        Number of rows.
    opposite, same : float
        Length of the passes whose neighbour runs the other way, and the same way, mm.
    step : float
        Distance between rows cut one after the other (median by length), mm.
    pitch : float
        Distance between neighbouring rows in whatever order (median), mm.
    even : float
        Share of the steps that keep to the usual one.
    moves : (k,) int
        The moves the passes are made of.
    """

    axis: float
    length: float
    typical: float
    count: int
    opposite: float
    same: float
    step: float
    pitch: float
    even: float
    moves: np.ndarray


def find_rows(moves: Moves, chosen: np.ndarray) -> list[Rows]:
    """Find up to two families of parallel rows among the chosen moves.

    The axis is where the Gauss image of the moves, taken without sense, is densest: back-and-forth is two
    opposite points of the circle. Grids and crossed rasters have a second family.

    Parameters
    ----------
    moves : Moves
    chosen : (k,) int
        Moves to look at, ascending.
    """
    found: list[Rows] = []
    while len(chosen) and len(found) < 2:
        family = _densest(moves, chosen)
        if found and family.length < 0.1 * found[0].length:
            break
        found.append(family)
        left = np.zeros(len(moves), bool)
        left[chosen] = True
        left[family.moves] = False
        chosen = np.flatnonzero(left)
    return found


def weighted_median(values: np.ndarray, weights: np.ndarray) -> float:
    """Return the value at half the weight; values and weights (k,), k >= 1."""
    order = np.argsort(values)
    reached = np.cumsum(weights[order])
    return float(values[order[np.searchsorted(reached, reached[-1] / 2)]])


def _densest(moves: Moves, chosen: np.ndarray) -> Rows:
    """Return the rows along the densest direction."""
    length, alpha = moves.length[chosen], moves.alpha[chosen]
    bins = np.rint(alpha * (BINS / np.pi)).astype(np.int64) % BINS
    weight = np.bincount(bins, weights=length, minlength=BINS)
    peak = int(np.argmax(weight + 0.5 * (np.roll(weight, 1) + np.roll(weight, -1))))
    near = np.abs((bins - peak + BINS // 2) % BINS - BINS // 2) <= 1
    doubled = 2 * alpha[near]
    axis = 0.5 * np.arctan2((length[near] * np.sin(doubled)).sum(), (length[near] * np.cos(doubled)).sum())
    u, v = np.cos(axis), np.sin(axis)
    on = chosen[np.abs(moves.dy[chosen] * u - moves.dx[chosen] * v) <= ALIGNED * length]
    length = moves.length[on]
    across = moves.y[on] * u - moves.x[on] * v
    forward = moves.dx[on] * u + moves.dy[on] * v > 0
    fresh = np.zeros(len(moves), bool)
    fresh[moves.start] = True
    # A pass goes on while the sense stays, and over a lift while the line stays: spans of one line are one row.
    apart = (on[1:] > on[:-1] + 1) | fresh[on[1:]]
    new = (forward[1:] != forward[:-1]) | (apart & (np.abs(across[1:] - across[:-1]) > SAME_LINE))
    begin = np.flatnonzero(np.concatenate([[True], new]))
    passed = np.add.reduceat(length, begin)
    typical = weighted_median(passed, passed)
    # Links along the boundary run along the axis here and there: they are no rows.
    long = passed > 0.1 * typical
    begin, passed = begin[long], passed[long]
    q, sense, area = across[begin], forward[begin], np.cumsum(fresh)[on[begin]]
    lateral = np.abs(q[1:] - q[:-1])
    shorter = np.minimum(passed[1:], passed[:-1])
    aside = lateral > SAME_LINE
    axis, total = axis % np.pi, float(passed.sum())
    if not aside.any():
        return Rows(axis, total, typical, 1, 0.0, 0.0, 0.0, 0.0, 0.0, on)
    step = weighted_median(lateral[aside], shorter[aside])
    neighbour = aside & (lateral <= 1.6 * step)
    turned = sense[1:] != sense[:-1]
    # Two passes the same way without a lift between them are stairs of one stroke (sampled contours), not rows.
    onward = neighbour & ~turned & (area[1:] != area[:-1])
    gaps = np.diff(np.sort(q))
    gaps = gaps[gaps > SAME_LINE]
    return Rows(
        axis=axis,
        length=total,
        typical=typical,
        count=1 + int(aside.sum()),
        opposite=float(shorter[neighbour & turned].sum()),
        same=float(shorter[onward].sum()),
        step=step,
        pitch=float(np.median(gaps)) if len(gaps) else step,
        even=float(shorter[neighbour & (lateral >= 0.6 * step)].sum() / shorter[aside].sum()),
        moves=on,
    )
