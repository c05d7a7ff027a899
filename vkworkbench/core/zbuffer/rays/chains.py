# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pieces of rays whose removals connect: no depths need sorting.

Trajectories that follow each other mostly touch what is open already. As long as every interval of a ray meets the one
gap that those before it made, the gap only grows, at its near end, its far end or both, and each growth is a piece. All
pieces of all such rays follow from two running extremes. The other rays go the general way, `dexels.first_cuts`.
"""

from __future__ import annotations

import numpy as np

from vkworkbench.core.solids import Gaps
from vkworkbench.core.zbuffer.rays.dexels import (
    NO_DEEPER,
    THINNEST,
    UNCUT,
    Pieces,
    before_in_group,
    beginnings,
    first_cuts,
    without_thin,
)
from vkworkbench.core.zbuffer.rays.records import GAP


def cut_rays(
    near: np.ndarray,
    far: np.ndarray,
    ray: np.ndarray,
    trajectory: np.ndarray,
    enter: np.ndarray,
    leave: np.ndarray,
    gaps: Gaps | None = None,
) -> Pieces:
    """Cut rays by a sequence of intervals.

    Parameters
    ----------
    near, far : (k,) ndarray
        Ends of each ray's chord of the stock, mm; all rays with ``far - near > THINNEST``.
    ray : (m,) ndarray of int
        Ray of each interval, ascending.
    trajectory : (m,) ndarray of int
        Its place in the sequence, ascending within a ray.
    enter, leave : (m,) ndarray
        Its ends, mm.
    gaps : Gaps, optional
        What is open from the start; its pieces belong to `GAP`.

    Returns
    -------
    Pieces
        Those of rays that nothing cuts included.
    """
    if gaps is not None and len(gaps.ray):
        ray, trajectory, enter, leave = _behind(gaps, ray, trajectory, enter, leave)
    enter, leave = enter[None], leave[None]
    kept = removing(ray, enter, leave, near[None], far[None])
    return cut_new(near, far, ray[kept], trajectory[kept], enter[0, kept], leave[0, kept])


def removing(group: np.ndarray, enter: np.ndarray, leave: np.ndarray, near: np.ndarray, far: np.ndarray) -> np.ndarray:
    """Positions, row by row, of intervals that reach deeper than those before them opened their rays from the near end.

    Most trajectories that pass a ray do not.

    Parameters
    ----------
    group : (p,) ndarray of int
        Ascending; in each group are the intervals of one ray of every row, in their order.
    enter, leave : (q, p) ndarray
        The intervals, mm; they are cut to their rays. Not a number, or ``enter > leave``, where there is none.
    near, far : (q, g) ndarray
        Ends of the groups' rays, mm; ``near > far`` where nothing is to be cut.
    """
    nearest, farthest = near.min(initial=0, where=near < far), far.max(initial=0, where=near < far)
    first = np.where(near < far, near, farthest).take(group, axis=1)
    np.maximum(enter, first, out=enter)
    np.minimum(leave, far.take(group, axis=1), out=leave)
    met = leave - enter > THINNEST
    opened = np.where(met & (enter <= first), leave, first)
    # So far apart that a running extreme starts anew in each group.
    offset = group * (farthest - nearest + 1)
    opened += offset
    before = np.maximum.accumulate(opened, axis=1, out=opened)
    before += NO_DEEPER
    met[:, 1:] &= leave[:, 1:] + offset[1:] > before[:, :-1]
    return np.flatnonzero(met)


def cut_new(
    near: np.ndarray, far: np.ndarray, ray: np.ndarray, trajectory: np.ndarray, enter: np.ndarray, leave: np.ndarray
) -> Pieces:
    """`cut_rays` by intervals that are longer than THINNEST and within their rays, best only those that are `removing`."""
    if not (enter > near.take(ray)).any():
        return _deepened(near, far, ray, trajectory, leave)
    offset = ray * (far.max() - near.min() + 1)
    start = beginnings(ray)
    # The gap before each interval; the interval itself where it is a ray's first.
    rising, falling = leave + offset, enter - offset
    open_far = before_in_group(np.maximum.accumulate(rising), start, rising[start])
    open_near = before_in_group(np.minimum.accumulate(falling), start, falling[start])
    nearer, farther = falling < open_near, rising > open_far
    apart = (enter + offset > open_far) | (leave - offset < open_near)
    first = _marked(len(ray), start)
    if not apart.any():
        return _grown(near, far, ray, trajectory, enter, leave, first, nearer, farther)
    scattered = np.zeros(len(near), bool)
    scattered[ray[apart]] = True
    loose = scattered[ray]
    tight = np.flatnonzero(~loose)
    # What is within the interval before it cuts nothing: sorting takes long.
    loose[1:] &= (enter[1:] < enter[:-1]) | (leave[1:] > leave[:-1]) | first[1:]
    loose = np.flatnonzero(loose)
    rest, these = np.flatnonzero(~scattered), np.flatnonzero(scattered)
    new = np.cumsum(~scattered) - 1
    connected = _grown(
        near[rest],
        far[rest],
        new[ray[tight]],
        trajectory[tight],
        enter[tight],
        leave[tight],
        first[tight],
        nearer[tight],
        farther[tight],
    )
    new = np.cumsum(scattered) - 1
    sorted_ = first_cuts(near[these], far[these], new[ray[loose]], trajectory[loose], enter[loose], leave[loose])
    rays = np.concatenate((rest[connected.ray], these[sorted_.ray]))
    order = np.argsort(rays, kind="stable")
    columns = (
        np.concatenate((getattr(connected, name), getattr(sorted_, name)))[order] for name in ("owner", "near", "far")
    )
    return Pieces(rays[order], *columns)


def among(gaps: Gaps, rays: np.ndarray) -> Gaps:
    """Return the gaps of some rays, their rays counted as they are listed in `rays` (k,)."""
    if len(gaps.ray) == 0:
        return gaps
    first, end = np.searchsorted(gaps.ray, rays), np.searchsorted(gaps.ray, rays, side="right")
    listed = np.repeat(np.arange(len(rays)), end - first)
    at = np.arange(len(listed)) - np.repeat(np.cumsum(end - first) - end, end - first)
    return Gaps(listed, gaps.enter[at], gaps.leave[at])


def _behind(gaps: Gaps, ray: np.ndarray, *others: np.ndarray) -> list[np.ndarray]:
    """The intervals of rays with their gaps before them."""
    rays = np.concatenate((gaps.ray, ray))
    order = np.argsort(rays, kind="stable")
    columns = (np.full(len(gaps.ray), GAP), gaps.enter, gaps.leave)
    return [rays[order], *(np.concatenate(both)[order] for both in zip(columns, others))]


def _deepened(near: np.ndarray, far: np.ndarray, ray: np.ndarray, trajectory: np.ndarray, leave: np.ndarray) -> Pieces:
    """Pieces of rays that are cut from their near end on, by each interval to a greater depth."""
    end = near.copy()
    end[ray] = leave  # the last one's
    whole = end < far
    size = np.bincount(ray, minlength=len(near)) + whole
    base = np.append(0, np.cumsum(size))
    pieces = Pieces(
        np.repeat(np.arange(len(near)), size),
        np.full(base[-1], UNCUT, np.int32),
        np.empty(base[-1]),
        np.empty(base[-1]),
    )
    # The pieces before an interval's own are those of the intervals before it and what is left of the rays before.
    at = np.arange(len(ray)) + (np.cumsum(whole) - whole).take(ray)
    pieces.owner[at], pieces.far[at] = trajectory, leave
    pieces.far[base[1:][whole] - 1] = far[whole]
    pieces.near[1:] = pieces.far[:-1]
    cut = size > 0
    pieces.near[base[:-1][cut]] = near[cut]
    return without_thin(pieces, near, far)


def _grown(
    near: np.ndarray,
    far: np.ndarray,
    ray: np.ndarray,
    trajectory: np.ndarray,
    enter: np.ndarray,
    leave: np.ndarray,
    start: np.ndarray,
    nearer: np.ndarray,
    farther: np.ndarray,
) -> Pieces:
    """Pieces of rays with one gap each, that grows from the interval at `start`, `nearer` the eye and `farther`."""
    rays = len(near)
    # Each growth begins where the one before it, or the first interval, ended.
    inner, outer = np.flatnonzero(nearer | start), np.flatnonzero(farther | start)
    growth = np.flatnonzero(nearer[inner])
    nearer, gap_near = inner[growth], enter[inner[growth - 1]]
    growth = np.flatnonzero(farther[outer])
    farther, gap_far = outer[growth], leave[outer[growth - 1]]
    begins = np.flatnonzero(start)

    before = np.bincount(ray[nearer], minlength=rays)
    behind = np.bincount(ray[farther], minlength=rays)
    cut = np.zeros(rays, bool)
    cut[ray[begins]] = True
    last_near, last_far = near.copy(), near.copy()
    last_near[ray[inner]] = enter[inner]
    last_far[ray[outer]] = leave[outer]
    whole_before, whole_behind = cut & (near < last_near), last_far < far
    size = whole_before + before + cut + behind + whole_behind
    base = np.append(0, np.cumsum(size))
    core = base[:-1] + whole_before + before

    pieces = Pieces(
        np.repeat(np.arange(rays), size),
        np.empty(base[-1], np.int32),
        np.empty(base[-1]),
        np.empty(base[-1]),
    )

    def put(at: np.ndarray, owner: np.ndarray | int, begin: np.ndarray, end: np.ndarray) -> None:
        pieces.owner[at], pieces.near[at], pieces.far[at] = owner, begin, end

    put(core[ray[begins]], trajectory[begins], enter[begins], leave[begins])
    rank = np.arange(len(nearer)) - (np.cumsum(before) - before)[ray[nearer]]
    put(core[ray[nearer]] - 1 - rank, trajectory[nearer], enter[nearer], gap_near)
    rank = np.arange(len(farther)) - (np.cumsum(behind) - behind)[ray[farther]]
    put(core[ray[farther]] + 1 + rank, trajectory[farther], gap_far, leave[farther])
    first = np.flatnonzero(whole_before)
    put(base[first], UNCUT, near[first], last_near[first])
    last = np.flatnonzero(whole_behind)
    put(base[last + 1] - 1, UNCUT, last_far[last], far[last])
    return without_thin(pieces, near, far)


def _marked(size: int, positions: np.ndarray) -> np.ndarray:
    marks = np.zeros(size, bool)
    marks[positions] = True
    return marks
