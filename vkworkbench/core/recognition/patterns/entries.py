# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find how the tool enters the material at the start of each monotonous area, and remove these entry moves."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.paper import TURN, Areas
from vkworkbench.core.recognition.patterns.spurs import some_moves
from vkworkbench.core.recognition.thresholds import ENTRY, MAJORITY, ROUNDING

LEVEL = 1e-6  # mm; a move is horizontal if its height changes by at most this value
ENTRIES = ("plunge", "ramp", "zigzag ramp", "helix")


def find_entry(moves: Areas) -> str | None:
    """Return the kind of entry that descends most of the depth, one of `ENTRIES`; None if the cut itself descends.

    An entry is the descent at the start of a monotonous area, before the first horizontal move. Some entries begin with
    a horizontal move, and then descend back along the line of this move. A descent that winds is a helix, a descent
    that goes back and forth is a zigzag ramp, and any other descent is a ramp. An area that begins with a horizontal
    move is entered by a plunge, unless the descent returns along the line of this move. If most of the length after the
    descents is not horizontal, the descent is the operation and not an entry, as in a helical bore or on a surface.

    Parameters
    ----------
    moves : Areas
        At least one move.
    """
    if not moves.climbs:
        return ENTRIES[0]
    begin, first = _ways_in(moves)
    after = np.arange(len(moves)) >= np.repeat(first, moves.end - moves.start)
    level = np.where(after & (np.abs(moves.dz) < LEVEL), moves.length, 0.0)
    following = np.where(after, moves.length, 0.0).sum()
    if level.sum() <= MAJORITY.SHARE * following:
        return None
    followed = np.add.reduceat(level, moves.start) > 0
    entry = followed & (first > begin)
    if not entry.any():
        return ENTRIES[0]
    begin, last = begin[entry], first[entry] - 1
    drop = moves.z[begin] - moves.dz[begin] - moves.z[last]
    if drop.max() < ROUNDING.HEIGHT:
        return ENTRIES[0]
    turned = np.abs(moves.phi[last])
    reversed_ = np.cumsum(np.bincount(moves.unsigned, minlength=len(moves)))
    to_and_fro = reversed_[last] > reversed_[begin]
    kind = np.where(turned > ENTRY.WINDS * TURN, 3, np.where(to_and_fro, 2, 1))
    return ENTRIES[int(np.argmax(np.bincount(kind, weights=drop, minlength=len(ENTRIES))))]


def without_entries(moves: Areas) -> tuple[Areas, float]:
    """Remove lead-ins and lead-outs: descents at the start and climbs at the end of monotonous areas.

    A lead is removed only if most of the remaining area is horizontal and extends well beyond the lead's bounding box.
    A helix that ends with one flat turn is the operation and not a lead, because the flat turn does not extend beyond
    the helix. A ramp along a contour is part of the contour and not a lead.

    Parameters
    ----------
    moves : Areas
        At least one move.

    Returns
    -------
    Areas
        The moves without the removed lead-ins and lead-outs. Every area keeps at least one move.
    float
        Share of the toolpath's length in helical lead-ins.
    """
    if not moves.climbs:
        return moves, 0.0
    down, up = _ways_in(moves)[1] - moves.start, _way_out(moves)
    chosen = np.flatnonzero(down + up > 0)
    if not len(chosen):
        return moves, 0.0
    start, end = moves.start[chosen], moves.end[chosen]
    first, last = start + down[chosen], end - up[chosen]
    way = np.append(0.0, np.cumsum(moves.length))
    level = np.append(0.0, np.cumsum(np.where(np.abs(moves.dz) < LEVEL, moves.length, 0.0)))
    mostly = level[last] - level[first] > MAJORITY.SHARE * (way[last] - way[first])
    pattern, gone = _boxes(moves, first, last), np.zeros(len(moves) + 1, np.int64)
    leads = []
    for begin, stop in ((start, first), (last, end)):
        some = np.flatnonzero(mostly & (stop > begin))
        box = _boxes(moves, begin[some], stop[some])
        beyond = (pattern[some] - box).max(axis=1, initial=-np.inf)
        some = some[beyond > ENTRY.LEADS * np.hypot(*(box[:, :2] + box[:, 2:]).T)]
        np.add.at(gone, begin[some], 1)
        np.add.at(gone, stop[some], -1)
        leads.append(some)
    into = leads[0]
    winds = np.abs(moves.phi[first[into] - 1]) > ENTRY.WINDS * TURN
    wound = float((way[first] - way[start])[into[winds]].sum() / way[-1])
    kept = np.cumsum(gone[:-1]) == 0
    return (moves if kept.all() else some_moves(moves, kept)), wound


def share_rising(moves: Areas) -> float:
    """Return the share of the length in climbs at the ends of monotonous areas, as V-carving climbs in corners.

    Parameters
    ----------
    moves : Areas
        At least one move.
    """
    if not moves.climbs:
        return 0.0
    way = np.append(0.0, np.cumsum(moves.length))
    return float((way[moves.end] - way[moves.end - _way_out(moves)]).sum() / way[-1])


def _ways_in(moves: Areas) -> tuple[np.ndarray, np.ndarray]:
    """Return the first move of the descent at the start of each area, and the move after the descent, (a,) each.

    Both returned moves are the area's first move if the area does not begin with a descent. Some descents begin with a
    horizontal move, and then return along the line of this move.
    """
    x, y, dx, dy, length = moves.x, moves.y, moves.dx, moves.dy, moves.length
    begin = _first(moves.start, moves.end, np.abs(moves.dz) >= LEVEL)
    end = _first(begin, moves.end, moves.dz >= -LEVEL)
    turns = np.minimum(begin, len(moves) - 1)
    ahead = dx[turns] * dx[turns - 1] + dy[turns] * dy[turns - 1]
    back = (begin > moves.start) & (end > begin) & (ahead < -ENTRY.BACK * length[turns] * length[turns - 1])
    gap_x, gap_y = x[end - 1] + dx[end - 1] - x[moves.start], y[end - 1] + dy[end - 1] - y[moves.start]
    back &= np.hypot(gap_x, gap_y) < ROUNDING.PLACE
    return np.where(back, begin, moves.start), np.where(back | (begin == moves.start), end, moves.start)


def _first(start: np.ndarray, end: np.ndarray, which: np.ndarray) -> np.ndarray:
    """Return the first chosen move from start[i] to end[i] - 1, or end[i] if no move is chosen, (a,) int."""
    at = np.append(np.flatnonzero(which), len(which))
    return np.minimum(at[np.searchsorted(at, start)], end)


def _way_out(moves: Areas) -> np.ndarray:
    """Return how many moves climb at the end of each monotonous area, (a,)."""
    at = np.append(-1, np.flatnonzero(moves.dz <= LEVEL))
    return moves.end - 1 - np.maximum(at[np.searchsorted(at, moves.end) - 1], moves.start - 1)


def _boxes(moves: Areas, first: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Return the bounding boxes of the moves from first[i] to end[i] - 1, (k, 4) mm.

    The columns are the negative lowest x and y, and the highest x and y.
    """
    between = np.column_stack([first, end]).ravel()
    reach = []
    for sign in (-1, 1):
        for at, step in ((moves.x, moves.dx), (moves.y, moves.dy)):
            farthest = np.maximum.reduceat(np.append(sign * at, -np.inf), between)[::2]
            reach.append(np.maximum(farthest, sign * (at[end - 1] + step[end - 1])))
    return np.column_stack(reach)
