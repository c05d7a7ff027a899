# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tags: what holds a part in the stock. A contour that is lifted over them is one contour all the same."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from vkworkbench.core.paper import TURN, TURNS, Areas, closing_turns, directions, turned
from vkworkbench.core.recognition.thresholds import ENOUGH, SAME, TAGS


def joined_over_tags(moves: Areas) -> tuple[Areas, float]:
    """Join areas that follow one another around a closed contour.

    Between them the tool is lifted and goes on where it was, or ahead; the moves before such gaps are made longer to bridge
    them. What cuts over a tag is a part of the contour. Rows that are lifted over an island go on ahead, too, but around
    nothing.

    Parameters
    ----------
    moves : Areas
        At least one move.

    Returns
    -------
    Areas
        Each such contour is one.
    float
        Share of the length in these contours.
    """
    count = len(moves.start)
    if count < 2:
        return moves, 0.0
    area = np.arange(count)
    onward = _goes_on(moves, area[:-1], area[1:])
    if not onward.any():
        return moves, 0.0
    onward &= ~(moves.closed[:-1] | moves.closed[1:])
    first = np.flatnonzero(np.append(True, ~onward))
    last = np.append(first[1:], count) - 1
    behind = np.append(area[1:], 0)
    behind[last] = first
    gap_x, gap_y = _gap(moves, area, behind)
    bridged = np.add.reduceat(np.hypot(gap_x, gap_y), first) / np.add.reduceat(moves.area_length, first)
    turned_by = np.add.reduceat(
        moves.phi[moves.end - 1] + closing_turns(moves.alpha, moves.start[behind], moves.end), first
    )
    contour = (last > first) & (bridged < ENOUGH.SHARE) & (np.abs(turned_by) > TURN / 2) & _goes_on(moves, last, first)
    if not contour.any():
        return moves, 0.0
    of_contour = np.repeat(contour, last - first + 1)
    dx, dy, end = moves.dx.copy(), moves.dy.copy(), moves.end - 1
    ahead = of_contour & (dx[end] * gap_x + dy[end] * gap_y > 0)  # the others are as good as none
    dx[end[ahead]] += gap_x[ahead]
    dy[end[ahead]] += gap_y[ahead]
    begins = ~of_contour
    begins[first] = True
    start, alpha = moves.start[begins], directions(dx, dy)
    turning, phi = np.zeros(len(moves)), np.empty(len(moves))
    unsigned, reversals = turned(alpha, start, turning, phi)
    joined = replace(
        moves, dx=dx, dy=dy, length=np.hypot(dx, dy), alpha=alpha, turning=turning, phi=phi,
        start=start, unsigned=unsigned, reversals=reversals,
    )  # fmt: skip
    return joined, float(moves.area_length[of_contour].sum() / moves.length.sum())


def _gap(moves: Areas, one: np.ndarray, two: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the way from the ends of some areas to the starts of others, (k,) mm in x and in y."""
    end, start = moves.end[one] - 1, moves.start[two]
    return moves.x[start] - moves.x[end] - moves.dx[end], moves.y[start] - moves.y[end] - moves.dy[end]


def _goes_on(moves: Areas, one: np.ndarray, two: np.ndarray) -> np.ndarray:
    """Tell where areas `two` begin where areas `one` end, or ahead of it, and do not turn back, (k,) bool."""
    end, start = moves.end[one] - 1, moves.start[two]
    x, y = _gap(moves, one, two)
    gap = np.hypot(x, y)
    before = (moves.dx[end] * x + moves.dy[end] * y) / moves.length[end]
    after = (moves.dx[start] * x + moves.dy[start] * y) / moves.length[start]
    ahead = np.minimum(before, after) > TAGS.AHEAD * gap
    near = gap < np.maximum(moves.area_length[one], moves.area_length[two])
    back = np.abs(closing_turns(moves.alpha, start, end + 1)) > np.pi - TURNS.UNSIGNED
    result: np.ndarray = ((gap < SAME.PLACE) | (ahead & near)) & ~back
    return result
