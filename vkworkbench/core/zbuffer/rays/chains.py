# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut rays whose removed intervals are connected, without sorting the depths.

Each trajectory removes an interval of a ray. Consecutive trajectories usually touch material that is already removed,
so on most rays every interval touches or overlaps the gap that earlier intervals have cut. On a ray with connected
intervals, the gap only grows, at its near end, at its far end or at both ends. The stretch by which a trajectory makes
the gap longer at one end is called a growth; each growth is a segment. The running minimum of the entry depths and the
running maximum of the exit depths give all segments of a ray with one gap. Rays with several separate gaps are cut by
`dexels.first_cuts`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from vkworkbench.core.solids import Gaps
from vkworkbench.core.zbuffer.rays.dexels import (
    NO_DEEPER,
    THINNEST,
    UNCUT,
    Segments,
    before_in_group,
    beginnings,
    first_cuts,
    without_thin,
)
from vkworkbench.core.zbuffer.rays.records import GAP


class _Intervals(NamedTuple):
    """Intervals that trajectories remove from rays, (m,) each; the ends `enter` and `leave` are depths, mm."""

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
) -> Segments:
    """Divide rays into segments by the intervals that a sequence of trajectories removes.

    Parameters
    ----------
    near, far : (k,) ndarray
        Depths at which each ray enters and leaves the stock, mm. Each ray must have ``far - near > THINNEST``.
    ray : (m,) ndarray of int
        Ray of each interval, ascending.
    trajectory : (m,) ndarray of int
        Trajectory of each interval, ascending within a ray.
    enter, leave : (m,) ndarray
        Depths at which each interval begins and ends, mm.
    gaps : Gaps, optional
        Stretches of the rays between two parts of the stock; they are returned as segments with the owner `GAP`.

    Returns
    -------
    Segments
        The segments of all rays, including the rays that no trajectory cuts.
    """
    if gaps is not None and len(gaps.ray):
        ray, trajectory, enter, leave = _with_gaps_first(gaps, ray, trajectory, enter, leave)
    enter, leave = enter[None], leave[None]
    kept = removing_intervals(ray, enter, leave, near[None], far[None])
    return cut_by_removing(near, far, ray[kept], trajectory[kept], enter[0, kept], leave[0, kept])


def removing_intervals(
    group: np.ndarray, enter: np.ndarray, leave: np.ndarray, near: np.ndarray, far: np.ndarray
) -> np.ndarray:
    """Return the intervals that end deeper than the gap that earlier intervals have cut from the ray's near end.

    The result contains positions in the matrix `enter`, counted row by row. Most intervals are excluded, because
    earlier trajectories have already removed their material.

    Parameters
    ----------
    group : (p,) ndarray of int
        Group of each interval, ascending. In each row of the arrays, a group contains the intervals of one ray, in the
        order in which their trajectories are cut.
    enter, leave : (q, p) ndarray
        Ends of the intervals, mm. The function overwrites the arrays with the ends clipped to the stock. NaN, or
        ``enter > leave``, means that the trajectory misses the ray.
    near, far : (q, g) ndarray
        Depths at which each group's rays enter and leave the stock, mm; ``near > far`` for rays that miss the stock.
    """
    nearest, farthest = near.min(initial=0, where=near < far), far.max(initial=0, where=near < far)
    first = np.where(near < far, near, farthest).take(group, axis=1)
    np.maximum(enter, first, out=enter)
    np.minimum(leave, far.take(group, axis=1), out=leave)
    met = leave - enter > THINNEST
    opened = np.where(met & (enter <= first), leave, first)
    # The depths of each group are shifted above the depths of all earlier groups, so that one running maximum over all
    # intervals starts anew in each group.
    offset = group * (farthest - nearest + 1)
    opened += offset
    before = np.maximum.accumulate(opened, axis=1, out=opened)
    before += NO_DEEPER
    met[:, 1:] &= leave[:, 1:] + offset[1:] > before[:, :-1]
    return np.flatnonzero(met)


def cut_by_removing(
    near: np.ndarray, far: np.ndarray, ray: np.ndarray, trajectory: np.ndarray, enter: np.ndarray, leave: np.ndarray
) -> Segments:
    """Cut rays by intervals that are inside the stock and longer than THINNEST.

    The function is faster if `removing_intervals` has selected the intervals.
    """
    if not (enter > near.take(ray)).any():
        return _segments_from_near_end(near, far, ray, trajectory, leave)
    offset = ray * (far.max() - near.min() + 1)
    start = beginnings(ray)
    # For each interval, `open_near` and `open_far` are the ends of the gap that the ray's earlier intervals have cut.
    # For the first interval of a ray, `open_near` and `open_far` are the ends of this interval.
    rising, falling = leave + offset, enter - offset
    open_far = before_in_group(np.maximum.accumulate(rising), start, rising[start])
    open_near = before_in_group(np.minimum.accumulate(falling), start, falling[start])
    nearer, farther = falling < open_near, rising > open_far
    apart = (enter + offset > open_far) | (leave - offset < open_near)
    first = _marked(len(ray), start)
    if not apart.any():
        return _segments_of_growing_gaps(near, far, _Intervals(ray, trajectory, enter, leave), first, nearer, farther)
    scattered = np.zeros(len(near), bool)
    scattered[ray[apart]] = True
    loose = scattered[ray]
    tight = np.flatnonzero(~loose)
    # An interval inside the ray's previous interval removes nothing. Intervals that remove nothing are left out,
    # because sorting takes long.
    loose[1:] &= (enter[1:] < enter[:-1]) | (leave[1:] > leave[:-1]) | first[1:]
    loose = np.flatnonzero(loose)
    rest, these = np.flatnonzero(~scattered), np.flatnonzero(scattered)
    new = np.cumsum(~scattered) - 1
    own = _Intervals(new[ray[tight]], trajectory[tight], enter[tight], leave[tight])
    connected = _segments_of_growing_gaps(near[rest], far[rest], own, first[tight], nearer[tight], farther[tight])
    new = np.cumsum(scattered) - 1
    sorted_ = first_cuts(near[these], far[these], new[ray[loose]], trajectory[loose], enter[loose], leave[loose])
    rays = np.concatenate((rest[connected.ray], these[sorted_.ray]))
    order = np.argsort(rays, kind="stable")
    columns = (
        np.concatenate((getattr(connected, name), getattr(sorted_, name)))[order] for name in ("owner", "near", "far")
    )
    return Segments(rays[order], *columns)


def gaps_of(gaps: Gaps, rays: np.ndarray) -> Gaps:
    """Return the gaps in the stock on the rays `rays` (k,). The result numbers each ray by its position in `rays`."""
    if len(gaps.ray) == 0:
        return gaps
    first, end = np.searchsorted(gaps.ray, rays), np.searchsorted(gaps.ray, rays, side="right")
    listed = np.repeat(np.arange(len(rays)), end - first)
    at = np.arange(len(listed)) - np.repeat(np.cumsum(end - first) - end, end - first)
    return Gaps(listed, gaps.enter[at], gaps.leave[at])


def _with_gaps_first(gaps: Gaps, ray: np.ndarray, *others: np.ndarray) -> list[np.ndarray]:
    """Return the arrays of the intervals, with the stock's gaps on each ray inserted before the ray's intervals."""
    rays = np.concatenate((gaps.ray, ray))
    order = np.argsort(rays, kind="stable")
    columns = (np.full(len(gaps.ray), GAP), gaps.enter, gaps.leave)
    return [rays[order], *(np.concatenate(both)[order] for both in zip(columns, others))]


def _segments_from_near_end(
    near: np.ndarray, far: np.ndarray, ray: np.ndarray, trajectory: np.ndarray, leave: np.ndarray
) -> Segments:
    """Return the segments of rays whose intervals all begin at the near end and end at increasing depths."""
    end = near.copy()
    end[ray] = leave  # each ray gets the end of its last interval, because numpy keeps the last value
    whole = end < far
    size = np.bincount(ray, minlength=len(near)) + whole
    base = np.append(0, np.cumsum(size))
    segments = Segments(
        np.repeat(np.arange(len(near)), size),
        np.full(base[-1], UNCUT, np.int32),
        np.empty(base[-1]),
        np.empty(base[-1]),
    )
    # Each interval gives one segment of its ray, and each ray whose far end is not cut gives one more segment.
    # Therefore the index of an interval's segment is the number of earlier intervals plus the number of earlier rays
    # whose far end is not cut.
    at = np.arange(len(ray)) + (np.cumsum(whole) - whole).take(ray)
    segments.owner[at], segments.far[at] = trajectory, leave
    segments.far[base[1:][whole] - 1] = far[whole]
    segments.near[1:] = segments.far[:-1]
    cut = size > 0
    segments.near[base[:-1][cut]] = near[cut]
    return without_thin(segments, near, far)


def _segments_of_growing_gaps(
    near: np.ndarray,
    far: np.ndarray,
    intervals: _Intervals,
    start: np.ndarray,
    nearer: np.ndarray,
    farther: np.ndarray,
) -> Segments:
    """Return the segments of rays that each have a single gap, which grows at one or both ends.

    The mask `start` (m,) selects the first interval of each ray. The masks `nearer` and `farther` (m,) select the
    intervals by which the gap grows at its near end and at its far end.
    """
    ray, trajectory, enter, leave = intervals
    rays = len(near)
    # A growth (the stretch by which an interval makes the gap longer at one end) begins where the previous growth at
    # this end stopped, or at the end of the ray's first interval.
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

    segments = Segments(
        np.repeat(np.arange(rays), size),
        np.empty(base[-1], np.int32),
        np.empty(base[-1]),
        np.empty(base[-1]),
    )

    def put(at: np.ndarray, owner: np.ndarray | int, begin: np.ndarray, end: np.ndarray) -> None:
        segments.owner[at], segments.near[at], segments.far[at] = owner, begin, end

    put(core[ray[begins]], trajectory[begins], enter[begins], leave[begins])
    rank = np.arange(len(nearer)) - (np.cumsum(before) - before)[ray[nearer]]
    put(core[ray[nearer]] - 1 - rank, trajectory[nearer], enter[nearer], gap_near)
    rank = np.arange(len(farther)) - (np.cumsum(behind) - behind)[ray[farther]]
    put(core[ray[farther]] + 1 + rank, trajectory[farther], gap_far, leave[farther])
    first = np.flatnonzero(whole_before)
    put(base[first], UNCUT, near[first], last_near[first])
    last = np.flatnonzero(whole_behind)
    put(base[last + 1] - 1, UNCUT, last_far[last], far[last])
    return without_thin(segments, near, far)


def _marked(size: int, positions: np.ndarray) -> np.ndarray:
    marks = np.zeros(size, bool)
    marks[positions] = True
    return marks
