# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loops inside the areas: where the tool comes back to a point, and where phi passes another 2 pi."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.areas import TURN, Moves, wrap

CLOSE = 0.05  # mm; a path that comes back this close is closed
OFF_ROUND = 0.377  # of a cell: grid origin off the round coordinates programs are made of


def closed_loops(moves: Moves) -> tuple[np.ndarray, np.ndarray]:
    """Find the closed loops: stretches that return to their first point with a net turn of +-2 pi.

    Offset loops linked without a lift, and a contour before or after a zigzag in one cut, are one area to the
    splitting at rapids; phi then runs over loops and links alike. The points where the tool comes back separate
    them. Of two overlapping loops the one that begins first counts.

    Parameters
    ----------
    moves : Moves

    Returns
    -------
    first, end : (k,) int
        The loops are the moves first[i] .. end[i] - 1, in order and without overlap.
    """
    vertex_x, vertex_y, area = _vertices(moves)
    column = np.floor((vertex_x - vertex_x[0]) * (1 / CLOSE) + OFF_ROUND).astype(np.int64)
    row = np.floor((vertex_y - vertex_y[0]) * (1 / CLOSE) + OFF_ROUND).astype(np.int64)
    # Hashing the cells is O(n); sorting all vertices would not be. Only those of shared cells are sorted.
    size = 1 << (2 * len(vertex_x)).bit_length()
    cell = (column * 73856093 + row * 19349663 + area * 83492791) & (size - 1)
    order = np.arange(len(cell))
    table = np.empty(size, np.int64)
    table[cell] = order
    latest = table[cell]
    table[cell[::-1]] = order[::-1]
    visited = np.flatnonzero(latest - table[cell] >= 3)
    if not len(visited):
        return visited, visited
    visited = visited[np.argsort(cell[visited], kind="stable")]
    one, two = visited[:-1], visited[1:]
    near = (cell[one] == cell[two]) & (area[one] == area[two])
    near &= np.abs(vertex_x[one] - vertex_x[two]) <= CLOSE
    near &= np.abs(vertex_y[one] - vertex_y[two]) <= CLOSE
    one, two = one[near], two[near]
    first, end = one - area[one], two - area[two]
    net = moves.phi[end - 1] - moves.phi[first] + wrap(moves.alpha[first] - moves.alpha[end - 1])
    once = (np.abs(np.abs(net) - TURN) < 0.1) & (end > first + 1)
    return _disjoint(first[once], end[once])


def _vertices(moves: Moves) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return x, y and area of the vertices of all areas: the starts of their moves and the end of their last."""
    m, areas = len(moves), len(moves.start)
    ends = np.append(moves.start[1:], m)
    if areas == 1:
        x = np.append(moves.x, moves.x[-1] + moves.dx[-1])
        y = np.append(moves.y, moves.y[-1] + moves.dy[-1])
        return x, y, np.zeros(m + 1, np.int64)
    area = np.repeat(np.arange(areas), ends - moves.start + 1)
    last = ends + np.arange(areas)
    inner = np.ones(m + areas, bool)
    inner[last] = False
    x, y = np.empty(m + areas), np.empty(m + areas)
    x[inner], y[inner] = moves.x, moves.y
    x[last] = moves.x[ends - 1] + moves.dx[ends - 1]
    y[last] = moves.y[ends - 1] + moves.dy[ends - 1]
    return x, y, area


def _disjoint(first: np.ndarray, end: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Keep from the left those intervals that begin after the end of the last one kept."""
    order = np.lexsort((end, first))
    first, end = first[order], end[order]
    following = np.searchsorted(first, end).tolist()
    kept, at = [], 0
    while at < len(following):
        kept.append(at)
        at = following[at]
    return first[kept], end[kept]


def winding_turns(moves: Moves, start: np.ndarray, end: np.ndarray, sense: np.ndarray) -> np.ndarray:
    """Find where each further turn of the windings begins: where phi reaches the next multiple of 2 pi.

    Parameters
    ----------
    moves : Moves
    start, end : (w,) int
        The windings are the moves start[i] .. end[i] - 1.
    sense : (w,) float
        +1 where the winding goes counter-clockwise, -1 where clockwise.

    Returns
    -------
    (t,) int
        First move of every turn but the first. The level reached never falls, so that the way back out of a
        concave corner opens no new turn.
    """
    size = end - start
    of = np.repeat(np.arange(len(start)), size)
    own = np.arange(len(of)) + np.repeat(start - np.concatenate([[0], np.cumsum(size)[:-1]]), size)
    climb = (moves.phi[own] - moves.phi[start][of]) * sense[of]
    above = of * (np.ptp(climb) + TURN)  # lifts every winding above all before it
    level = np.floor((np.maximum.accumulate(climb + above) - above + 1e-6) * (1 / TURN))
    return own[np.flatnonzero((level[1:] > level[:-1]) & (of[1:] == of[:-1])) + 1]
