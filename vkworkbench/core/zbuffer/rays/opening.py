# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rays that are opened from one end: what reaches deeper than all before it is a piece.

So it is from above and from below, where a tool removes all that is above its tip's surface.
"""

from __future__ import annotations

import numpy as np

from vkworkbench.core.zbuffer.rays.dexels import NO_DEEPER, THINNEST


def opening(depth: np.ndarray, tile: np.ndarray, start: np.ndarray, near: np.ndarray, far: np.ndarray) -> np.ndarray:
    """Positions, row by row, of the pairs that open their ray deeper than those before them.

    Parameters
    ----------
    depth : (q, p) ndarray
        To which a trajectory opens a ray, mm; not a number where it does not. A row for each of the q pixels of a tile.
    tile : (p,) ndarray of int
        Ascending; within a tile in the order of time.
    start : (t,) ndarray of int
        Where each tile's pairs begin.
    near, far : (q, t) ndarray
        Ends of the rays, mm; ``near > far`` where nothing is to be cut.
    """
    deepest = float(np.fmax.reduce(depth, axis=None, initial=0.0))
    highest = float(near.min(initial=deepest))
    # So far apart that a running extreme starts anew in each tile.
    offset = tile * (deepest - highest + 1)
    first = np.where(near < far, near, deepest) + (THINNEST - NO_DEEPER) + offset[start]
    moved = depth + offset
    begun = moved[:, start] > first + NO_DEEPER
    moved[:, start] = np.fmax(moved[:, start], first)
    deeper = np.empty(depth.shape, bool)
    before = np.fmax.accumulate(moved, axis=1)
    before += NO_DEEPER
    np.greater(moved[:, 1:], before[:, :-1], out=deeper[:, 1:])
    deeper[:, start] = begun
    return np.flatnonzero(deeper)


def opened(
    near: np.ndarray, far: np.ndarray, start: np.ndarray, owner: np.ndarray, leave: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Pieces that are removed from rays, each ray from its near end on, by each trajectory to a greater depth.

    Parameters
    ----------
    near, far : (k,) ndarray
        Ends of the rays, mm; each is cut.
    start : (k,) ndarray of int
        Where each ray's trajectories begin.
    owner : (m,) ndarray of int
        The trajectories.
    leave : (m,) ndarray
        Depth to which each one opens the ray, mm; may be overwritten.

    Returns
    -------
    count : (k,) int64
        How many pieces of each ray are removed.
    rest : (k,) bool
        Whether something is left behind them.
    end : (r,) ndarray
        Where the removed pieces end, mm.
    owner : (r,) ndarray of int
    """
    count = np.diff(start, append=len(leave))
    last = start + count - 1
    deepest = leave[last]
    if (deepest > far).any():
        leave = np.minimum(leave, np.repeat(far, count))
        deepest = leave[last]
    thick = np.empty(len(leave), bool)
    np.greater(leave[1:] - leave[:-1], THINNEST, out=thick[1:])
    thick[start] = leave[start] - near > THINNEST
    if not thick.all():
        # What is too thin goes to the piece before it, which ends where the next one begins.
        kept = np.flatnonzero(thick)
        count = np.add.reduceat(thick, start, dtype=np.int64)
        last = np.cumsum(count) - 1
        owner, leave = owner[kept], leave[np.append(kept[1:], 0) - 1]
    rest = far - deepest > THINNEST
    leave[last] = np.where(rest, deepest, far)
    return count, rest, leave, owner
