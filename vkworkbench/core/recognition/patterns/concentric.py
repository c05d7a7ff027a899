# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find concentric arcs, such as circles interrupted at the boundary of the part, or rows bent into arcs."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.paper import TURN, Areas
from vkworkbench.core.recognition.patterns.pieces import Pieces
from vkworkbench.core.recognition.patterns.rows import dot, steps_between
from vkworkbench.core.recognition.thresholds import ARCS


@dataclass(frozen=True)
class ConcentricArcs:
    """Open strokes that are arcs around one common centre.

    Attributes
    ----------
    count : int
        Number of different radii. An open contour made of arcs has few radii, even if it is cut at many depths.
    length : float
        Length of all arcs, mm.
    opposite, same : float
        Length of the arcs that run opposite to their neighbour, and length of the arcs that run in their neighbour's
        direction, mm.
    spiral : float
        Length of the arcs whose radius changes steadily, mm.
    step : float
        Median distance between arcs that are cut one after the other, weighted by length, mm.
    even : float
        Share of the distances between consecutive arcs that are close to the median distance.
    """

    count: int
    length: float
    opposite: float
    same: float
    spiral: float
    step: float
    even: float


def find_arcs(moves: Areas, pieces: Pieces, index: np.ndarray) -> ConcentricArcs | None:
    """Find the arcs around a common centre.

    Each move d on a circle around c is perpendicular to the ray from c to the move's midpoint m. The centre is the
    point c that minimises the sum of the squared dot products d (m - c). Straight rows have no centre.

    Parameters
    ----------
    moves : Areas
    pieces : Pieces
    index : (k,) int
        Indices of the pieces (strokes of the toolpath) among which to find arcs.

    Returns
    -------
    ConcentricArcs or None
        None if fewer than three arcs have a common centre.
    """
    chosen = np.zeros(len(pieces), bool)
    chosen[index] = True
    on = np.repeat(chosen, pieces.end - pieces.start)
    of = np.repeat(np.arange(len(pieces)), pieces.end - pieces.start)[on]
    dx, dy, length = moves.dx[on], moves.dy[on], moves.length[on]
    rays = _rays(moves.x[on] + dx / 2, moves.y[on] + dy / 2, dx, dy, length)
    if rays is None:
        return None
    rx, ry, r, square = rays
    begin = np.flatnonzero(np.concatenate([[True], of[1:] != of[:-1]]))
    whole = np.add.reduceat(length, begin)
    arc = np.add.reduceat(length * square, begin) > ARCS.ARC * whole
    radius = (np.add.reduceat(length * r, begin) / whole)[arc]
    angle = np.add.reduceat((rx * dy - ry * dx) / np.maximum(r * r, 1e-12), begin)[arc]
    last = np.append(begin[1:], len(of)) - 1
    climbed = (r[last] - r[begin])[arc]
    whole = whole[arc]
    steps = steps_between(radius, whole)
    if steps is None or steps.aside.sum() < 2:
        return None
    turned = angle[1:] * angle[:-1] < 0
    pitch = np.abs(climbed) * TURN / np.maximum(np.abs(angle), 1e-9)
    return ConcentricArcs(
        count=1 + int((np.diff(np.sort(radius)) > ARCS.RADIUS * steps.usual).sum()),
        length=float(whole.sum()),
        opposite=float(steps.shorter[steps.neighbour & turned].sum()),
        same=float(steps.shorter[steps.neighbour & ~turned].sum()),
        spiral=float(whole[pitch > ARCS.DRIFT * steps.usual].sum()),
        step=steps.usual,
        even=steps.even,
    )


def _rays(
    x: np.ndarray, y: np.ndarray, dx: np.ndarray, dy: np.ndarray, length: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray] | None:
    """Return the rays from the common centre to the moves' midpoints, and which moves are perpendicular to their rays.

    The rays are returned as x, y and length, (k,) mm each. Return None if the moves have no common centre.
    """
    weight = 1 / length
    for _ in range(3):  # find the centre again without the moves that are not on a circle around it
        xx, xy, yy = dot(weight * dx, dx), dot(weight * dx, dy), dot(weight * dy, dy)
        if xx * yy - xy * xy < ARCS.STRAIGHT_ROWS * (xx + yy) ** 2:
            return None
        along = weight * (dx * x + dy * y)
        bx, by = dot(along, dx), dot(along, dy)
        cx, cy = (yy * bx - xy * by) / (xx * yy - xy * xy), (xx * by - xy * bx) / (xx * yy - xy * xy)
        rx, ry = x - cx, y - cy
        r = np.hypot(rx, ry)
        square = np.abs(dx * rx + dy * ry) < ARCS.SQUARE * length * r
        weight = np.where(square, 1 / length, 0.0)
        if not square.any():
            return None
    return rx, ry, r, square
