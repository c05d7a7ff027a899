# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows: long parallel passes side by side, and whether their direction alternates or stays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.paper import Areas, axis_of

BINS = 64  # of 2.8 degrees over half a turn; a power of two, so that & wraps
SAMPLE = 1000  # values that are enough for a median
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
    lines : int
        Number of different lines they lie on, counted up to a thousand rows.
    opposite, same : float
        Length of the passes whose neighbour runs the other way, and the same way, mm.
    step : float
        Distance between rows cut one after the other (median by length), mm.
    pitch : float
        Distance between neighbouring rows in whatever order (median), mm.
    period : float
        Distance after which rows come again, mm: the passes of a lattice that bounce off the boundary lie on
        two sets of lines, each as far apart as the stepover, and between one another at will.
    even : float
        Share of the steps that keep to the usual one.
    moves : (k,) int
        The moves the passes are made of.
    """

    axis: float
    length: float
    typical: float
    count: int
    lines: int
    opposite: float
    same: float
    step: float
    pitch: float
    period: float
    even: float
    moves: np.ndarray


def find_rows(moves: Areas, chosen: np.ndarray) -> list[Rows]:
    """Find up to two families of parallel rows among the chosen moves.

    The axis is where the Gauss image of the moves, taken without sense, is densest: back-and-forth is two
    opposite points of the circle. Grids and crossed rasters have a second family.

    Parameters
    ----------
    moves : Areas
    chosen : (k,) int
        Moves to look at, ascending.
    """
    found: list[Rows] = []
    total = moves.length.take(chosen).sum()
    while len(chosen):
        family = _densest(moves, chosen)
        if family is None:
            break
        found.append(family)
        total -= moves.length.take(family.moves).sum()
        # What is left when nearly all is in rows are the links between them.
        if len(found) == 2 or total < 0.1 * found[0].length:
            break
        left = np.zeros(len(moves), bool)
        left[chosen] = True
        left[family.moves] = False
        chosen = np.flatnonzero(left)
    if len(found) == 2 and found[1].length < 0.1 * found[0].length:
        found.pop()
    return found


def weighted_median(values: np.ndarray, weights: np.ndarray) -> float:
    """Return the value at half the weight; values and weights (k,), k >= 1; of many values an even sample."""
    every = len(values) // SAMPLE + 1
    values, weights = values[::every], weights[::every]
    order = np.argsort(values)
    reached = np.cumsum(weights[order])
    return float(values[order[np.searchsorted(reached, reached[-1] / 2)]])


def _aligned(dx, dy, length, axis) -> tuple[np.ndarray, np.ndarray]:
    """Return how far the moves go along an axis, mm, and which of them keep to it."""
    along = dx * np.cos(axis)
    along += dy * np.sin(axis)
    return along, np.flatnonzero(np.abs(along) >= np.cos(ALIGNED) * length)


def _densest(moves: Areas, chosen: np.ndarray) -> Rows | None:
    """Return the rows along the densest direction; None where no move keeps to it."""
    dx, dy, length = moves.dx, moves.dy, moves.length
    if len(chosen) < len(moves):
        dx, dy, length = dx[chosen], dy[chosen], length[chosen]
    cos = dx / length
    axis = axis_of(cos @ dx, cos @ dy, length.sum())
    along, aligned = _aligned(dx, dy, length, axis)
    kept = length.take(aligned).sum() / length.sum()
    if kept < 0.8:
        # Not one axis alone: take the densest of 64 directions and its neighbours.
        bins = np.rint(moves.alpha[chosen] * (BINS / np.pi)).astype(np.int64) & (BINS - 1)
        weight = np.bincount(bins, weights=length, minlength=BINS)
        around = np.roll(weight, 1) + np.roll(weight, -1)
        peak = int(np.argmax(weight + 0.5 * around))
        aligned = np.flatnonzero(np.isin(np.arange(BINS), (np.array([-1, 0, 1]) + peak) % BINS)[bins])
    if kept < 0.98:
        # Once more without the links: along a slanting boundary they turn the axis.
        near = cos.take(aligned)
        axis = axis_of(near @ dx.take(aligned), near @ dy.take(aligned), length.take(aligned).sum())
        along, aligned = _aligned(dx, dy, length, axis)
    u, v = np.cos(axis), np.sin(axis)
    on, forward, length = chosen.take(aligned), along.take(aligned) > 0, length.take(aligned)
    if not len(on):
        return None
    area = (
        np.searchsorted(moves.start, on, side="right")
        if len(moves.start) > 1
        else np.zeros(len(on), np.int64)
    )
    # A pass goes on while the sense stays, and over a lift while the line stays: spans of one line are one
    # row.
    new = forward[1:] != forward[:-1]
    apart = np.flatnonzero(((on[1:] > on[:-1] + 1) | (area[1:] > area[:-1])) & ~new)
    before, after = on[apart], on[apart + 1]
    shift = (moves.y[after] - moves.y[before]) * u - (moves.x[after] - moves.x[before]) * v
    new[apart] = np.abs(shift) > SAME_LINE
    begin = np.flatnonzero(np.concatenate([[True], new]))
    passed = np.add.reduceat(length, begin)
    typical = weighted_median(passed, passed)
    # Links along the boundary run along the axis here and there: they are no rows.
    long = passed > 0.1 * typical
    begin, passed = begin[long], passed[long]
    first = on[begin]
    q, sense, area = moves.y[first] * u - moves.x[first] * v, forward[begin], area[begin]
    lateral = np.abs(q[1:] - q[:-1])
    shorter = np.minimum(passed[1:], passed[:-1])
    aside = lateral > SAME_LINE
    axis, total = axis % np.pi, float(passed.sum())
    if not aside.any():
        return Rows(axis, total, typical, 1, 1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, on)
    step = weighted_median(lateral[aside], shorter[aside])
    neighbour = aside & (lateral <= 1.6 * step)
    turned = sense[1:] != sense[:-1]
    # Two passes the same way without a lift between them are stairs of one stroke (sampled contours), not
    # rows.
    onward = neighbour & ~turned & (area[1:] != area[:-1])
    q = np.sort(q[:SAMPLE])
    gaps = np.diff(q[np.append(True, q[1:] - q[:-1] > SAME_LINE)])
    pitch = period = float(np.median(gaps)) if len(gaps) else step
    if len(gaps) > 2 and np.median(np.abs(gaps[1:] - gaps[:-1])) > 0.1 * pitch:
        period = float(np.median(gaps[1:] + gaps[:-1]))
    return Rows(
        axis=axis,
        length=total,
        typical=typical,
        count=1 + int(aside.sum()),
        lines=1 + len(gaps),
        opposite=float(shorter[neighbour & turned].sum()),
        same=float(shorter[onward].sum()),
        step=step,
        pitch=pitch,
        period=period,
        even=float(shorter[neighbour & (lateral >= 0.6 * step)].sum() / shorter[aside].sum()),
        moves=on,
    )
