# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut rays in views from above or below, where each trajectory removes all material of a ray up to one depth.

In views from above and below, a tool removes all material above the tool's lower surface, so every removed interval
begins at the same end of the ray. "A trajectory opens a ray to a depth" means that it removes the ray's material from
the end at which all removed intervals begin to the depth. A trajectory removes a segment only if it opens the ray
deeper than all earlier trajectories.
"""

from __future__ import annotations

import numpy as np

from vkworkbench.core.zbuffer.rays.dexels import NO_DEEPER, THINNEST


def opening(depth: np.ndarray, tile: np.ndarray, start: np.ndarray, near: np.ndarray, far: np.ndarray) -> np.ndarray:
    """Return the positions in `depth`, row by row, at which a ray is cut deeper than by all earlier trajectories.

    Parameters
    ----------
    depth : (q, p) ndarray
        Depth to which a trajectory opens a ray, mm; NaN if the trajectory misses the ray. Each row belongs to one of
        the q pixels of a tile, each column to one of p pairs of a tile and a trajectory.
    tile : (p,) ndarray of int
        Tile of each pair of a tile and a trajectory, ascending. Within one tile, the trajectories are in the order of
        cutting.
    start : (t,) ndarray of int
        Position of each tile's first pair of a tile and a trajectory.
    near, far : (q, t) ndarray
        Depths at which the rays enter and leave the stock, mm; ``near > far`` for rays that miss the stock.
    """
    deepest = float(np.fmax.reduce(depth, axis=None, initial=0.0))
    highest = float(near.min(initial=deepest))
    # The depths of each tile are shifted above the depths of all earlier tiles, so that one running maximum over all
    # pairs of a tile and a trajectory starts anew in each tile.
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
    """Return the removed segments of rays that each trajectory cuts deeper than the previous trajectory.

    Parameters
    ----------
    near, far : (k,) ndarray
        Depths at which the rays enter and leave the stock, mm. At least one trajectory must cut each ray.
    start : (k,) ndarray of int
        Position in `owner` at which the trajectories that cut each ray begin.
    owner : (m,) ndarray of int
        The trajectories that cut the rays, sorted by ray.
    leave : (m,) ndarray
        Depth to which each trajectory cuts its ray, mm. The function can overwrite `leave`.

    Returns
    -------
    count : (k,) int64
        Number of removed segments of each ray.
    rest : (k,) bool
        Whether material is left on the ray deeper than the removed segments.
    end : (r,) ndarray
        Depths at which the removed segments end, mm.
    owner : (r,) ndarray of int
        Trajectories that remove the segments.
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
        # A segment of a ray no longer than THINNEST is joined to the previous segment, which then ends where the next
        # longer segment begins.
        kept = np.flatnonzero(thick)
        count = np.add.reduceat(thick, start, dtype=np.int64)
        last = np.cumsum(count) - 1
        owner, leave = owner[kept], leave[np.append(kept[1:], 0) - 1]
    rest = far - deepest > THINNEST
    leave[last] = np.where(rest, deepest, far)
    return count, rest, leave, owner
