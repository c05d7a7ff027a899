# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loops inside the areas: where the tool comes back to a point, and where phi passes another 2 pi."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.areas import TURN, Moves, wrap

CLOSE = 0.03  # mm; a path that comes back this close is closed
OFF_ROUND = 0.377  # of a cell: grid origin off the round coordinates programs are made of


def closed_loops(moves: Moves) -> tuple[np.ndarray, np.ndarray]:
    """Find the closed loops: stretches that return to their first point with a net turn of +-2 pi.

    Offset loops linked without a lift, and a contour before or after a zigzag in one cut, are one area to the
    splitting at rapids; phi then runs over loops and links alike. The points where the tool comes back
    separate them. Of two overlapping loops the one that begins first counts.

    Parameters
    ----------
    moves : Moves

    Returns
    -------
    first, end : (k,) int
        The loops are the moves first[i] .. end[i] - 1, in order and without overlap.
    """
    turned = np.maximum.reduceat(moves.phi, moves.start) - np.minimum.reduceat(moves.phi, moves.start)
    # A loop turns by 2 pi less its last corner, a zigzag by pi: most rasters need no search.
    winds = turned > 1.05 * np.pi
    if not winds.any():
        none = np.zeros(0, np.int64)
        return none, none
    vertices = _vertices(moves, np.flatnonzero(winds))
    first, end = _disjoint(*_returns(moves, *vertices, OFF_ROUND))
    if (end - first).sum() < 0.8 * len(vertices[0]):
        # The border of two cells may part the visits of one point: once more with the cells half a cell on.
        shifted = _returns(moves, *vertices, OFF_ROUND + 0.5)
        first, end = _disjoint(*np.concatenate([(first, end), shifted], axis=1))
    return first, end


def _returns(moves, x, y, area, shift, origin) -> tuple[np.ndarray, np.ndarray]:
    """Return the stretches from a visit of a cell to the next one that turn by +-2 pi."""
    column = ((x - x.min()) * (1 / CLOSE) + origin).astype(np.uint32)
    row = ((y - y.min()) * (1 / CLOSE) + origin).astype(np.uint32)
    # Hashing the cells is O(n); sorting all vertices would not be. The products wrap, their high bits are
    # the hash.
    bits = (4 * len(x)).bit_length()
    cell = column * np.uint32(2654435769)
    cell += row * np.uint32(2246822519)
    if len(shift) > 1:
        cell += area.astype(np.uint32) * np.uint32(3266489917)
    cell >>= np.uint32(32 - bits)
    cell = cell.astype(np.intp)
    size = 1 << bits
    order = np.arange(len(cell), dtype=np.int32)
    table = np.empty(size, np.int32)
    table[cell[::-1]] = order[::-1]
    earliest = table[cell]
    table[cell] = order
    latest = table[cell]
    again = np.flatnonzero(latest - earliest >= 3)
    # Most cells are visited twice, at the beginning and the end of a loop; only the others are sorted.
    between = again[(again != earliest[again]) & (again != latest[again])]
    if len(between):
        often = np.zeros(size, bool)
        often[cell[between]] = True
        crowded = often[cell[again]]
        many = again[crowded]
        # By the cells themselves: one that shares its hash would come between two visits of another.
        many = many[np.lexsort((row[many], column[many], area[many]))]
        twice = again[~crowded & (again == earliest[again])]
        one, two = np.append(many[:-1], twice), np.append(many[1:], latest[twice])
    else:
        one = again[again == earliest[again]]
        two = latest[one]
    near = (cell[one] == cell[two]) & (area[one] == area[two])
    near &= (np.abs(x[one] - x[two]) <= CLOSE) & (np.abs(y[one] - y[two]) <= CLOSE)
    one, two = one[near], two[near]
    first, end = one - shift[area[one]], two - shift[area[two]]
    net = moves.phi[end - 1] - moves.phi[first] + wrap(moves.alpha[first] - moves.alpha[end - 1])
    once = (np.abs(np.abs(net) - TURN) < 0.1) & (end > first + 1)
    return first[once], end[once]


def _vertices(moves: Moves, chosen: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return the vertices of some areas: the starts of their moves and the end of their last.

    Returns
    -------
    x, y : (v,) float
    area : (v,) int
        Index into `chosen`.
    shift : (a,) int
        Index of a vertex less the index of the move it begins, for each chosen area.
    """
    start, end = moves.start[chosen], np.append(moves.start[1:], len(moves))[chosen]
    size = end - start + 1
    begin = np.cumsum(size) - size
    shift = begin - start
    area = np.repeat(np.arange(len(chosen)), size)
    last = begin + size - 1
    if len(chosen) == 1:
        own = slice(start[0], end[0])
    else:
        own = np.arange(len(area)) - shift[area]
        own = np.delete(own, last)
    inner = np.ones(len(area), bool)
    inner[last] = False
    x, y = np.empty(len(area)), np.empty(len(area))
    x[inner], y[inner] = moves.x[own], moves.y[own]
    x[last], y[last] = moves.x[end - 1] + moves.dx[end - 1], moves.y[end - 1] + moves.dy[end - 1]
    return x, y, area, shift


def _disjoint(first: np.ndarray, end: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Keep from the left those intervals that begin after the end of the last one kept."""
    order = np.argsort(first * (end.max(initial=0) + 1) + end)
    first, end = first[order], end[order]
    if (end[:-1] <= first[1:]).all():
        return first, end
    following = np.searchsorted(first, end).tolist()
    kept, at, count = [], 0, len(following)
    while at < count:
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
