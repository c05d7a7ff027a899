# SPDX-License-Identifier: LGPL-2.1-or-later
"""Join the strokes of a contour that is lifted over tags, which hold the part in the stock."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from vkworkbench.core.paper import TURN, TURNS, Areas, closing_turns, directions, turned
from vkworkbench.core.recognition.thresholds import MAJORITY, ROUNDING, TAGS


def joined_over_tags(moves: Areas) -> tuple[Areas, float]:
    """Join the areas (cuts between two lifts) that together form one closed contour.

    Between two areas of one contour, the tool is lifted, and continues at the same place or farther ahead in the same
    direction. The move before each gap is extended to bridge the gap. Cuts over a tag are part of the contour. Rows
    that are lifted over an island also continue ahead, but are not joined, because they do not close. If the tool cuts
    each part between two tags down to the full depth before the next part, the joined contour goes around once for each
    depth.

    Parameters
    ----------
    moves : Areas
        At least one move.

    Returns
    -------
    Areas
        The areas, in which each interrupted contour is one area.
    float
        Share of the toolpath's length in the joined contours.
    """
    count = len(moves.start)
    if count < 2:
        return moves, 0.0
    strokes, moves = moves, _pass_by_pass(moves)
    area = np.arange(count)
    onward = _goes_on(moves, area[:-1], area[1:])
    if not onward.any():
        return strokes, 0.0
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
    contour = (
        (last > first) & (bridged < MAJORITY.SHARE) & (np.abs(turned_by) > TURN / 2) & _goes_on(moves, last, first)
    )
    if not contour.any():
        return strokes, 0.0
    of_contour = np.repeat(contour, last - first + 1)
    dx, dy, end = moves.dx.copy(), moves.dy.copy(), moves.end - 1
    ahead = of_contour & (dx[end] * gap_x + dy[end] * gap_y > 0)  # gaps against the last move are rounding errors
    dx[end[ahead]] += gap_x[ahead]
    dy[end[ahead]] += gap_y[ahead]
    begins = ~of_contour
    begins[first] = True
    joined = _measured(moves, dx=dx, dy=dy, start=moves.start[begins])
    return joined, float(moves.area_length[of_contour].sum() / moves.length.sum())


def _pass_by_pass(moves: Areas) -> Areas:
    """Return the areas in their order around the contour, if each stroke is cut to full depth before the next stroke.

    Parts that are cut back and forth, at one depth after the other, are all turned into one direction.
    """
    count, first, last = len(moves.start), moves.start, moves.end - 1
    end_x, end_y = moves.x[last] + moves.dx[last], moves.y[last] + moves.dy[last]
    ends = np.array([moves.x[first], moves.y[first], end_x, end_y])
    there = (np.abs(ends[:, 1:] - ends[:, :-1]) < ROUNDING.PLACE).all(axis=0)
    back = (np.abs(ends[:, 1:] - ends[[2, 3, 0, 1], :-1]) < ROUNDING.PLACE).all(axis=0)
    again = (there | back) & ~moves.closed[1:]
    again &= np.abs(np.diff(moves.area_length)) < ROUNDING.PLACE
    stroke = np.flatnonzero(np.append(True, ~again))
    passes = np.diff(stroke, append=count)
    onward = (passes[1:] == passes[:-1]) & (passes[1:] > 1) & _goes_on(moves, stroke[:-1], stroke[1:])
    if not onward.any():
        return moves
    contour = np.cumsum(np.append(True, ~onward))
    of_stroke = np.repeat(np.arange(len(stroke)), passes)
    turn = np.arange(count) - stroke[of_stroke]
    order = np.lexsort((of_stroke, turn, contour[of_stroke]))
    backward = np.append(0, np.cumsum(back & again))
    backward = (backward - backward[stroke[of_stroke]]) % 2 == 1
    return _rearranged(moves, order, backward[order])


def _rearranged(moves: Areas, order: np.ndarray, backward: np.ndarray) -> Areas:
    """Return the areas in another order, with the areas selected by `backward` reversed."""
    size = (moves.end - moves.start)[order]
    start = np.cumsum(size) - size
    place = np.arange(len(moves)) - np.repeat(start, size)
    back, first, last = (np.repeat(of, size) for of in (backward, moves.start[order], moves.end[order] - 1))
    at = np.where(back, last - place, first + place)
    dx, dy, dz = moves.dx[at], moves.dy[at], moves.dz[at]
    x, y, z = moves.x[at] + back * dx, moves.y[at] + back * dy, moves.z[at] - back * dz
    way = np.where(back, -1.0, 1.0)
    return _measured(moves, x=x, y=y, z=z, dx=way * dx, dy=way * dy, dz=way * dz, start=start)


def _measured(moves: Areas, **changed: np.ndarray) -> Areas:
    """Return the areas with changed moves, and measure the moves again."""
    moves = replace(moves, **changed)
    alpha = directions(moves.dx, moves.dy)
    turning, phi, unsigned, reversals = turned(alpha, moves.start)
    return replace(
        moves, length=np.hypot(moves.dx, moves.dy), alpha=alpha, turning=turning, phi=phi, unsigned=unsigned,
        reversals=reversals
    )  # fmt: skip


def _gap(moves: Areas, one: np.ndarray, two: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the distances from the ends of areas `one` to the starts of areas `two`, (k,) mm in x and in y."""
    end, start = moves.end[one] - 1, moves.start[two]
    return moves.x[start] - moves.x[end] - moves.dx[end], moves.y[start] - moves.y[end] - moves.dy[end]


def _goes_on(moves: Areas, one: np.ndarray, two: np.ndarray) -> np.ndarray:
    """Return whether areas `two` begin at the end of areas `one`, or ahead of it, without a reversal, (k,) bool."""
    end, start = moves.end[one] - 1, moves.start[two]
    x, y = _gap(moves, one, two)
    gap = np.hypot(x, y)
    before = (moves.dx[end] * x + moves.dy[end] * y) / moves.length[end]
    after = (moves.dx[start] * x + moves.dy[start] * y) / moves.length[start]
    ahead = np.minimum(before, after) > TAGS.AHEAD * gap
    near = gap < np.maximum(moves.area_length[one], moves.area_length[two])
    back = np.abs(closing_turns(moves.alpha, start, end + 1)) > np.pi - TURNS.UNSIGNED
    return ((gap < ROUNDING.PLACE) | (ahead & near)) & ~back
