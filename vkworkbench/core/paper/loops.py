# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find closed loops (the tool returns to a point after a net turn of +-2 pi), and the turns of spirals and helices."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.paper.directions import TURN, wrap
from vkworkbench.core.paper.moves import Moves
from vkworkbench.core.paper.thresholds import LOOPS, TURNS

OFF_ROUND = 0.377  # share of a cell; shifts the grid, so that round coordinates are not on borders between cells


def closing_turns(alpha: np.ndarray, first: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Return the turn from the last move of each stretch into its first, (k,) rad.

    A closed contour of n moves has n corners, but only n - 1 turns between successive moves. The closing turn is the
    missing corner (section 3.2: phi is 2 pi at the end of the traversal).

    Parameters
    ----------
    alpha : (m,) float64
        Directions, rad.
    first, end : (k,) int
        Stretch i consists of the moves from first[i] to end[i] - 1.
    """
    return wrap(alpha[first] - alpha[end - 1])


def is_closed(gap: np.ndarray, enclosed: np.ndarray, moves: np.ndarray) -> np.ndarray:
    """Return whether each stretch ends at its start, (k,) bool.

    A stretch is closed if the gap between its end and its start is small compared with the area that the stretch
    encloses. Lead-ins and rounding leave small gaps in closed contours. Two passes of a narrow zigzag enclose a small
    area, so they are not closed.

    Parameters
    ----------
    gap : (k,) float
        Distance from the end of each stretch to its start, mm.
    enclosed : (k,) float
        Area between each stretch and the straight line from its end to its start, mm2.
    moves : (k,) int
        Number of moves in each stretch.
    """
    return (gap <= np.maximum(LOOPS.CLOSE, LOOPS.GAP * np.sqrt(np.abs(enclosed)))) & (moves > 2)


def may_be_closed(gap: np.ndarray, length: np.ndarray) -> np.ndarray:
    """Return whether stretches with these gaps between their ends count as closed, (k,) bool; see :func:`is_closed`.

    A stretch encloses at most the area of a circle whose circumference is the length of the stretch.
    """
    return gap <= np.maximum(LOOPS.CLOSE, LOOPS.GAP * length / np.sqrt(4 * np.pi))


def is_one_turn(net: np.ndarray) -> np.ndarray:
    """Return whether each net turn (k,), without its sign, is a full turn plus or minus a quarter turn, (k,) bool."""
    return np.abs(np.rint(net / np.pi)) == 2


def closed_loops(moves: Moves) -> tuple[np.ndarray, np.ndarray]:
    """Find the closed loops: stretches that return to their first point with a net turn of +-2 pi.

    A monotonous area can contain offset loops that are linked without a lift, or a contour that is cut together with a
    zigzag. Phi then adds up over loops and links, so phi alone does not show where a loop ends; a loop is found by the
    point to which the tool returns. If two loops overlap, only the first loop is returned, unless the first loop turns
    back and forth much more than the second. For example, a zigzag can return to its own start before the tool cuts the
    contour around the zigzag; only the contour is then a loop.

    Returns
    -------
    first, end : (k,) int
        Loop i consists of the moves from first[i] to end[i] - 1. The loops are in order and do not overlap.
    """
    # In a loop, phi changes by 2 pi minus the turn from the last move into the first; in a zigzag, phi changes by only
    # pi. Monotonous areas in which phi changes by less are not searched for loops, which saves time for most rasters.
    winds = moves.phi_extent > LOOPS.HALF_TURNS * np.pi
    if not winds.any():
        none = np.zeros(0, np.int64)
        return none, none
    vertices = _vertices(moves, winds)
    first, end = _disjoint(moves, *_returns(moves, *vertices, 1, OFF_ROUND))
    if (end - first).sum() < LOOPS.FOUND * len(vertices[0]):
        # If a short move was dropped (MOVES.NOISE), the start and the end of a loop can be in different grid cells. In
        # at least one of three wider grids, each shifted by a third of a cell, the start and the end are in the same
        # cell.
        wider = [_returns(moves, *vertices, 2, OFF_ROUND + third / 3) for third in range(3)]
        first, end = _disjoint(moves, *np.concatenate([(first, end), *wider], axis=1))
    return first, end


def _vertices(moves: Moves, winds: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return the vertices of the areas that `winds` selects: first the start of every move, then the end of every area.

    The result consists of four arrays (v,): x and y in units of LOOPS.CLOSE, at least 0; the index of the move that
    begins at the vertex, or for the end of an area, the index after its last move; and the number of the vertex's area
    among the selected areas, which is an empty array if only one area is selected.
    """
    end = np.append(moves.start[1:], len(moves))
    size = end - moves.start
    every = winds.all()
    begun = np.arange(len(moves)) if every else np.flatnonzero(np.repeat(winds, size))
    end = end[winds]
    area = np.zeros(0, np.uint32)
    if len(end) > 1:
        area = np.arange(len(end), dtype=np.uint32)
        area = np.append(np.repeat(area, size[winds]), area)

    def scaled(v: np.ndarray, dv: np.ndarray) -> np.ndarray:
        w = np.append(v if every else v.take(begun), v[end - 1] + dv[end - 1])
        w -= w.min()
        w *= 1 / LOOPS.CLOSE
        return w

    return scaled(moves.x, moves.dx), scaled(moves.y, moves.dy), np.append(begun, end), area


def _returns(
    moves: Moves, x: np.ndarray, y: np.ndarray, at: np.ndarray, area: np.ndarray, width: float, origin: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return the stretches that turn by +-2 pi and begin and end in one grid cell, `width` * LOOPS.CLOSE wide.

    Vertices are sorted by grid cell, and each vertex is compared with the next vertex in this order.
    """
    column, row = ((v * (1 / width) + origin).astype(np.uint64) for v in (x, y))
    cell = column << np.uint64(32) | row
    order = np.lexsort((cell, area)) if len(area) else np.argsort(cell, kind="stable")
    one, two = order[:-1], order[1:]
    near = np.maximum(np.abs(x[one] - x[two]), np.abs(y[one] - y[two])) <= 1
    if len(area):
        near &= area[one] == area[two]
    first, end = at[one[near]], at[two[near]]
    long = end - first > 2
    first, end = first[long], end[long]
    closing = closing_turns(moves.alpha, first, end)
    # The turn from the last move of a stretch into its first has no sign if it is half a turn. If a stretch begins at
    # the tip of a lead-in, both one loop and two loops could then have a net turn of 2 pi, so stretches whose last move
    # turns into the first by half a turn are not loops.
    once = is_one_turn(moves.phi[end - 1] - moves.phi[first] + closing) & (np.abs(closing) < np.pi - TURNS.UNSIGNED)
    return first[once], end[once]


def _disjoint(moves: Moves, first: np.ndarray, end: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Keep, in ascending order, each interval that does not begin before the end of the last interval kept.

    An interval that turns back and forth (LOOPS.WAVY) is replaced by the first interval that begins inside it, ends
    after its end, and turns back and forth much less (LOOPS.SMOOTHER).
    """
    if not (first[1:] > first[:-1]).all():
        order = np.lexsort((end, first))
        first, end = first[order], end[order]
    if (end[:-1] <= first[1:]).all():
        return first, end
    turned = np.append(0.0, np.cumsum(np.abs(moves.turning)))
    turned = turned[end] - turned[first + 1]
    following = np.searchsorted(first, end).tolist()
    wavy = (turned > LOOPS.WAVY * TURN).tolist()
    kept, at, count = [], 0, len(following)
    while at < count:
        if wavy[at]:
            inside = slice(at + 1, following[at])
            tighter = (turned[inside] - TURN < LOOPS.SMOOTHER * (turned[at] - TURN)) & (end[inside] > end[at])
            if tighter.any():
                at += 1 + int(np.argmax(tighter))
                continue
        kept.append(at)
        at = following[at]
    return first[kept], end[kept]


def winding_turns(moves: Moves, start: np.ndarray, end: np.ndarray, sense: np.ndarray) -> np.ndarray:
    """Return the moves at which a winding, such as a spiral, begins its next full turn: phi reaches a multiple of 2 pi.

    Parameters
    ----------
    start, end : (w,) int
        Winding i consists of the moves from start[i] to end[i] - 1.
    sense : (w,) float
        +1 for a counter-clockwise winding, -1 for a clockwise one.

    Returns
    -------
    (t,) int
        First move of every turn, except for the first turn of each winding. If phi falls and rises again at a concave
        corner, it reaches the same multiple of 2 pi twice, but only the first time is the beginning of a turn.
    """
    size = end - start
    of = np.repeat(np.arange(len(start)), size)
    own = np.arange(len(of)) + np.repeat(start - np.concatenate([[0], np.cumsum(size)[:-1]]), size)
    climb = (moves.phi[own] - moves.phi[start][of]) * sense[of]
    # Each winding is shifted above all earlier windings, so that one running maximum starts anew in each winding.
    above = of * (np.ptp(climb) + TURN)
    level = np.floor((np.maximum.accumulate(climb + above) - above + TURNS.EXACT) * (1 / TURN))
    return own[np.flatnonzero((level[1:] > level[:-1]) & (of[1:] == of[:-1])) + 1]
