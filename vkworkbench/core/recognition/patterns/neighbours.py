# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find open strokes side by side, such as offsets of an open wall or adaptive clearing between two walls."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.paper import Areas
from vkworkbench.core.recognition.patterns.pieces import Pieces
from vkworkbench.core.recognition.thresholds import NEIGHBOURS, NESTS, ROUNDING, ROWS


@dataclass(frozen=True)
class Neighbours:
    """Strokes with a neighbouring stroke at most three places earlier or later in the order of cutting.

    Attributes
    ----------
    count : int
        Number of strokes with a neighbour.
    share : float
        Share of all strokes' length in strokes with a neighbour.
    even : float
        Share of the neighbouring strokes' length with a constant distance to the neighbour, as offsets have.
    onward : float
        Share of the neighbouring strokes' length in the same direction as the neighbour.
    step : float
        Median distance between neighbouring strokes, mm.
    """

    count: int
    share: float
    even: float
    onward: float
    step: float


def find_neighbours(moves: Areas, pieces: Pieces, index: np.ndarray, tool: float) -> Neighbours | None:
    """Find the neighbours of every stroke among the next three strokes at its height.

    Two strokes are neighbours if the perpendiculars from most points of one stroke meet the other stroke. Neighbouring
    offsets have a constant distance. Passes with constant engagement run from wall to wall with a changing distance.

    Parameters
    ----------
    moves : Areas
    pieces : Pieces
    index : (k,) int
        Indices of the open strokes. Only the first thousand strokes are compared.
    tool : float
        Tool diameter, mm; 0 if unknown.

    Returns
    -------
    Neighbours or None
        None if fewer than two strokes have a neighbour.
    """
    index = index[: ROWS.SAMPLE]
    k = len(index)
    if k < 2:
        return None
    x, y = _sampled(moves, pieces, index)
    length, z, flat = pieces.length[index], pieces.z[index], pieces.flat[index]
    step, spread = np.full(k, np.inf), np.zeros(k)
    same = np.zeros(k, bool)
    for lag in range(1, min(NESTS.NEXT, k - 1) + 1):
        a, b = slice(None, -lag), slice(lag, None)
        distance, on = _distances(x[a], y[a], x[b], y[b])
        enough = on.mean(axis=1) > NEIGHBOURS.FACING
        enough &= (np.abs(z[a] - z[b]) < ROUNDING.HEIGHT) | ~flat[a] | ~flat[b]
        low, middle, high = spans = np.zeros((3, len(enough)))
        spans[:, enough] = _percentiles(distance[enough], on[enough], (10, 50, 90))
        enough &= (middle > ROUNDING.RING) & (high < np.minimum(length[a], length[b]) / ROWS.MIN_LENGTH)
        if tool:
            enough &= high < NESTS.REACH * tool
        nearer = enough & (middle < step[b])
        at = np.flatnonzero(nearer) + lag
        step[at], spread[at] = middle[nearer], (high - low)[nearer]
        along = (x[a, -1] - x[a, 0]) * (x[b, -1] - x[b, 0]) + (y[a, -1] - y[a, 0]) * (y[b, -1] - y[b, 0])
        same[at] = along[nearer] > 0
    beside = np.isfinite(step)
    if beside.sum() < 2:
        return None
    usual = float(np.median(step[beside]))
    beside &= step < NEIGHBOURS.MAX_DISTANCE * usual
    total = length[beside].sum()
    even = beside & (spread < NEIGHBOURS.EVEN * step)
    # The first stroke in a series of neighbouring strokes is included, although only the next stroke is its neighbour.
    first = np.append(~beside[:-1] & beside[1:], False)
    return Neighbours(
        count=int((beside | first).sum()),
        share=float(length[beside | first].sum() / pieces.length[index].sum()),
        even=float(length[even].sum() / total),
        onward=float(length[beside & same].sum() / total),
        step=usual,
    )


def _sampled(moves: Areas, pieces: Pieces, index: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return points at equal distances along each stroke, x and y (k, POINTS), ends included."""
    walked = np.append(0.0, np.cumsum(moves.length))
    at = walked[pieces.start[index], None] + pieces.length[index, None] * np.linspace(0, 1, NEIGHBOURS.POINTS)
    first, last = pieces.start[index, None], pieces.end[index, None] - 1
    move = np.clip(np.searchsorted(walked, at, side="right") - 1, first, last)
    along = np.clip((at - walked[move]) / moves.length[move], 0, 1)
    return moves.x[move] + along * moves.dx[move], moves.y[move] + along * moves.dy[move]


def _percentiles(values: np.ndarray, of: np.ndarray, percent: tuple[float, ...]) -> np.ndarray:
    """Return percentiles, (p, n), in each row of the array of values (n, k); `of` (n, k) selects the values to use.

    At least one value in each row is selected. numpy's `nanpercentile` processes the rows of an array one by one. This
    function is faster, because it processes all rows with the same number of selected values at once.
    """
    ascending, count = np.sort(np.where(of, values, np.inf), axis=1), of.sum(axis=1)
    found = np.empty((len(percent), len(values)))
    for some in np.unique(count).tolist():
        found[:, count == some] = np.percentile(ascending[count == some, :some], percent, axis=1)
    return found


def _distances(ax: np.ndarray, ay: np.ndarray, bx: np.ndarray, by: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the distance of each point of b from polyline a, and whether the perpendicular meets a, (k, points)."""
    dx, dy = np.diff(ax)[:, None], np.diff(ay)[:, None]
    px, py = bx[:, :, None] - ax[:, None, :-1], by[:, :, None] - ay[:, None, :-1]
    t = (px * dx + py * dy) / np.maximum(dx * dx + dy * dy, 1e-12)
    foot = np.clip(t, 0, 1)
    squared = (px - foot * dx) ** 2 + (py - foot * dy) ** 2
    nearest = squared.argmin(axis=2)[:, :, None]
    t = np.take_along_axis(t, nearest, 2)[:, :, 0]
    nearest = nearest[:, :, 0]
    beyond = ((nearest == 0) & (t < 0)) | ((nearest == dx.shape[2] - 1) & (t > 1))
    return np.sqrt(squared.min(axis=2)), ~beyond
