# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut rays by connected intervals, without sorting depths.

Consecutive trajectories usually touch the material that is removed already. While every interval of a ray meets the one gap that
earlier intervals have made, the gap only grows, at its near end, its far end or both, and each growth is a piece. Two running
extremes give all pieces of all such rays. Other rays are cut by `dexels.first_cuts`.
"""

from __future__ import annotations

from typing import NamedTuple

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


class _Intervals(NamedTuple):
    """Intervals of rays, (m,) each: ray, trajectory, and the ends, mm."""

    ray: np.ndarray
    trajectory: np.ndarray
    enter: np.ndarray
    leave: np.ndarray


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
        Trajectory of each interval, ascending within a ray.
    enter, leave : (m,) ndarray
        Ends of each interval, mm.
    gaps : Gaps, optional
        Gaps of the stock; their owner is `GAP`.

    Returns
    -------
    Pieces
        Including the pieces of rays that nothing cuts.
    """
    if gaps is not None and len(gaps.ray):
        ray, trajectory, enter, leave = _with_gaps_first(gaps, ray, trajectory, enter, leave)
    enter, leave = enter[None], leave[None]
    kept = removing_intervals(ray, enter, leave, near[None], far[None])
    return cut_by_removing(near, far, ray[kept], trajectory[kept], enter[0, kept], leave[0, kept])


def removing_intervals(
    group: np.ndarray, enter: np.ndarray, leave: np.ndarray, near: np.ndarray, far: np.ndarray
) -> np.ndarray:
    """Return the positions, row by row, of intervals that reach deeper than earlier ones have opened the ray from its near end.

    This excludes most trajectories that pass a ray.

    Parameters
    ----------
    group : (p,) ndarray of int
        Group of each interval, ascending. A group has the intervals of one ray of every row, in the order of the sequence.
    enter, leave : (q, p) ndarray
        The intervals, mm; clipped to their rays in place. NaN, or ``enter > leave``, for no interval.
    near, far : (q, g) ndarray
        Ends of the groups' rays, mm; ``near > far`` for rays that miss the stock.
    """
    nearest, farthest = near.min(initial=0, where=near < far), far.max(initial=0, where=near < far)
    first = np.where(near < far, near, farthest).take(group, axis=1)
    np.maximum(enter, first, out=enter)
    np.minimum(leave, far.take(group, axis=1), out=leave)
    met = leave - enter > THINNEST
    opened = np.where(met & (enter <= first), leave, first)
    # The offset of each group is large enough that a running maximum starts again in each group.
    offset = group * (farthest - nearest + 1)
    opened += offset
    before = np.maximum.accumulate(opened, axis=1, out=opened)
    before += NO_DEEPER
    met[:, 1:] &= leave[:, 1:] + offset[1:] > before[:, :-1]
    return np.flatnonzero(met)


def cut_by_removing(
    near: np.ndarray, far: np.ndarray, ray: np.ndarray, trajectory: np.ndarray, enter: np.ndarray, leave: np.ndarray
) -> Pieces:
    """Cut rays by intervals that are longer than THINNEST and inside their rays, preferably filtered by `removing_intervals`."""
    if not (enter > near.take(ray)).any():
        return _pieces_from_near_end(near, far, ray, trajectory, leave)
    offset = ray * (far.max() - near.min() + 1)
    start = beginnings(ray)
    # The gap before each interval; for the first interval of a ray, the interval itself.
    rising, falling = leave + offset, enter - offset
    open_far = before_in_group(np.maximum.accumulate(rising), start, rising[start])
    open_near = before_in_group(np.minimum.accumulate(falling), start, falling[start])
    nearer, farther = falling < open_near, rising > open_far
    apart = (enter + offset > open_far) | (leave - offset < open_near)
    first = _marked(len(ray), start)
    if not apart.any():
        return _pieces_of_growing_gaps(near, far, _Intervals(ray, trajectory, enter, leave), first, nearer, farther)
    scattered = np.zeros(len(near), bool)
    scattered[ray[apart]] = True
    loose = scattered[ray]
    tight = np.flatnonzero(~loose)
    # Drop intervals inside the interval before them, which cut nothing, because sorting takes long.
    loose[1:] &= (enter[1:] < enter[:-1]) | (leave[1:] > leave[:-1]) | first[1:]
    loose = np.flatnonzero(loose)
    rest, these = np.flatnonzero(~scattered), np.flatnonzero(scattered)
    new = np.cumsum(~scattered) - 1
    own = _Intervals(new[ray[tight]], trajectory[tight], enter[tight], leave[tight])
    connected = _pieces_of_growing_gaps(near[rest], far[rest], own, first[tight], nearer[tight], farther[tight])
    new = np.cumsum(scattered) - 1
    sorted_ = first_cuts(near[these], far[these], new[ray[loose]], trajectory[loose], enter[loose], leave[loose])
    rays = np.concatenate((rest[connected.ray], these[sorted_.ray]))
    order = np.argsort(rays, kind="stable")
    columns = (
        np.concatenate((getattr(connected, name), getattr(sorted_, name)))[order] for name in ("owner", "near", "far")
    )
    return Pieces(rays[order], *columns)


def gaps_of(gaps: Gaps, rays: np.ndarray) -> Gaps:
    """Return the gaps of some rays `rays` (k,), with rays renumbered by their position in `rays`."""
    if len(gaps.ray) == 0:
        return gaps
    first, end = np.searchsorted(gaps.ray, rays), np.searchsorted(gaps.ray, rays, side="right")
    listed = np.repeat(np.arange(len(rays)), end - first)
    at = np.arange(len(listed)) - np.repeat(np.cumsum(end - first) - end, end - first)
    return Gaps(listed, gaps.enter[at], gaps.leave[at])


def _with_gaps_first(gaps: Gaps, ray: np.ndarray, *others: np.ndarray) -> list[np.ndarray]:
    """Return the intervals of rays, preceded by the gaps of the rays."""
    rays = np.concatenate((gaps.ray, ray))
    order = np.argsort(rays, kind="stable")
    columns = (np.full(len(gaps.ray), GAP), gaps.enter, gaps.leave)
    return [rays[order], *(np.concatenate(both)[order] for both in zip(columns, others))]


def _pieces_from_near_end(
    near: np.ndarray, far: np.ndarray, ray: np.ndarray, trajectory: np.ndarray, leave: np.ndarray
) -> Pieces:
    """Return the pieces of rays that are cut from their near end, by each interval to a greater depth."""
    end = near.copy()
    end[ray] = leave  # the last interval of each ray
    whole = end < far
    size = np.bincount(ray, minlength=len(near)) + whole
    base = np.append(0, np.cumsum(size))
    pieces = Pieces(
        np.repeat(np.arange(len(near)), size),
        np.full(base[-1], UNCUT, np.int32),
        np.empty(base[-1]),
        np.empty(base[-1]),
    )
    # Number of pieces before an interval's piece: earlier intervals, and the uncut ends of earlier rays.
    at = np.arange(len(ray)) + (np.cumsum(whole) - whole).take(ray)
    pieces.owner[at], pieces.far[at] = trajectory, leave
    pieces.far[base[1:][whole] - 1] = far[whole]
    pieces.near[1:] = pieces.far[:-1]
    cut = size > 0
    pieces.near[base[:-1][cut]] = near[cut]
    return without_thin(pieces, near, far)


def _pieces_of_growing_gaps(
    near: np.ndarray,
    far: np.ndarray,
    intervals: _Intervals,
    start: np.ndarray,
    nearer: np.ndarray,
    farther: np.ndarray,
) -> Pieces:
    """Return the pieces of rays with one gap each. The gap begins with the interval at `start` and grows `nearer` and `farther`."""
    ray, trajectory, enter, leave = intervals
    rays = len(near)
    # Each growth begins at the end of the previous growth, or of the first interval.
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
