# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divide rays into segments; each segment is removed by one trajectory, or by no trajectory.

Each trajectory of a sequence removes an interval of a ray. The ends of all removed intervals divide the part of the ray
inside the stock into segments. A removed segment belongs to the trace of the trajectory that removes it; a segment that
no trajectory removes is a dexel. Each point of the ray is removed by the first trajectory whose interval contains the
point. Therefore sorting the ends of all intervals once gives all segments of all rays, without a loop over the
trajectories.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

# Largest length of a segment of a ray that is joined to a neighbouring segment, mm. A smaller length would turn
# rounding errors into segments of rays, and a larger length would attribute thin layers of material to the wrong
# trajectory.
THINNEST = 1e-4
# Length, mm, by which a trajectory must reach deeper than earlier trajectories to cut a ray. A smaller length would
# count rounding errors as cuts, and a larger length would ignore real cuts.
NO_DEEPER = 1e-7
# Value of `owner` for a segment that no trajectory removes.
UNCUT = np.iinfo(np.int32).max


@dataclass(frozen=True, eq=False)
class Segments:
    """Consecutive segments of rays, sorted by ray and depth.

    Attributes
    ----------
    ray : (p,) int64
        Index of the ray.
    owner : (p,) int32
        Trajectory that removes the segment, or `UNCUT` if no trajectory removes it.
    near, far : (p,) float64
        Depths of the segment's ends along the ray, mm.
    """

    ray: np.ndarray
    owner: np.ndarray
    near: np.ndarray
    far: np.ndarray


def first_cuts(
    near: np.ndarray,
    far: np.ndarray,
    ray: np.ndarray,
    trajectory: np.ndarray,
    enter: np.ndarray,
    leave: np.ndarray,
) -> Segments:
    """Divide rays into segments by sorting the ends of the intervals that trajectories remove.

    Parameters
    ----------
    near, far : (k,) ndarray
        Depths at which each ray enters and leaves the stock, mm. Rays with ``far - near <= THINNEST`` have no segments.
    ray : (m,) ndarray of int
        Ray of each interval.
    trajectory : (m,) ndarray of int
        Trajectory of each interval.
    enter, leave : (m,) ndarray
        Depths at which each interval begins and ends, mm.
    """
    stock = np.flatnonzero(far - near > THINNEST)
    enter, leave = np.maximum(enter, near[ray]), np.minimum(leave, far[ray])
    met = np.flatnonzero((leave - enter > THINNEST) & (far[ray] - near[ray] > THINNEST))
    ray, trajectory, enter, leave = ray[met], trajectory[met], enter[met], leave[met]

    # Each ray gets its own stretch of one common axis, so that one sort orders the ends of all intervals of all rays.
    base = near.min(initial=np.inf, where=far > near)
    stretch = (far.max(initial=-np.inf, where=far > near) - base) * 1.25 + 1 if len(stock) else 1.0
    place = np.concatenate(
        (
            near[stock] + stock * stretch,
            enter + ray * stretch,
            leave + ray * stretch,
            far[stock] + stock * stretch,
        )
    )
    order = np.argsort(place, kind="stable")
    rank = np.empty(len(order), np.int64)
    rank[order] = np.arange(len(order))
    k, m = len(stock), len(ray)
    owner = _lowest_cover(len(order), rank[k : k + m], rank[k + m : k + 2 * m], trajectory)

    depth = np.concatenate((near[stock], enter, leave, far[stock]))[order]
    slot_ray = np.concatenate((stock, ray, ray, stock))[order]
    same_ray = slot_ray[1:] == slot_ray[:-1]
    slots = np.flatnonzero(same_ray & (depth[1:] > depth[:-1]))
    return without_thin(merged(Segments(slot_ray[slots], owner[slots], depth[slots], depth[slots + 1])), near, far)


def beginnings(group: np.ndarray) -> np.ndarray:
    """Return the positions in `group` (k,) at which runs of equal values begin."""
    new = np.empty(len(group), bool)
    new[:1] = True
    np.not_equal(group[1:], group[:-1], out=new[1:])
    return np.flatnonzero(new)


def before_in_group(values: np.ndarray, start: np.ndarray, first: np.ndarray | float) -> np.ndarray:
    """Return, for each element, the value of the element before it in its group.

    The groups begin at the positions `start` in `values`. The result for the first element of each group is `first`.
    """
    before = np.empty_like(values)
    before[1:] = values[:-1]
    before[start] = first
    return before


def _lowest_cover(slots: int, first: np.ndarray, last: np.ndarray, value: np.ndarray) -> np.ndarray:
    """Return, for each slot (an index of the result), the lowest value of the ranges that contain the slot, (slots,).

    A range contains a slot if ``first <= slot < last``. Each range is covered by two shorter ranges, which can overlap;
    the length of both is the largest power of two that is not longer than the range. There is a table for each power of
    two; both shorter ranges store the value in the table for their length. Then, from the largest power of two down,
    the value of a range moves to the table for half the length, once for each half. The method is a sparse table for
    range minimum queries, used in reverse.
    """
    cover = np.full(slots, UNCUT, np.int32)
    if len(first) == 0:
        return cover
    level = np.frexp(last - first)[1] - 1
    # The ranges for one power of two are sorted by descending value: if several ranges are written to one element of
    # `cover`, the lowest value is written last.
    order = np.lexsort((-value, level))
    bounds = np.searchsorted(level[order], np.arange(level.max() + 2))
    for power in range(level.max(), -1, -1):
        size = 1 << power
        items = order[bounds[power] : bounds[power + 1]]
        for start in (first[items], last[items] - size):
            _enter_lowest(cover, start, value[items])
        if power:
            lower = cover.copy()
            np.minimum(lower[size // 2 :], cover[: -(size // 2)], out=lower[size // 2 :])
            cover = lower
    return cover


def _enter_lowest(target: np.ndarray, index: np.ndarray, value: np.ndarray) -> None:
    """Lower ``target[index]`` to `value` where `value` is lower; if an index is repeated, its lowest value is kept."""
    while len(index):
        lower = np.flatnonzero(value < target[index])
        index, value = index[lower], value[lower]
        target[index] = value


def merged(segments: Segments) -> Segments:
    """Return the segments, with neighbouring segments of a ray joined if the same trajectory removes them."""
    new = np.ones(len(segments.ray), bool)
    new[1:] = (segments.ray[1:] != segments.ray[:-1]) | (segments.owner[1:] != segments.owner[:-1])
    start = np.flatnonzero(new)
    end = np.append(start, len(new))[1:] - 1
    return Segments(segments.ray[start], segments.owner[start], segments.near[start], segments.far[end])


def without_thin(segments: Segments, near: np.ndarray, far: np.ndarray) -> Segments:
    """Return the segments, with each segment that is at most THINNEST long joined to a neighbouring segment.

    The segments still fill each ray from `near` to `far`.
    """
    thick = np.flatnonzero(segments.far - segments.near > THINNEST)
    if len(thick) == len(segments.ray):
        return segments
    kept = Segments(segments.ray[thick], segments.owner[thick], segments.near[thick], segments.far[thick])
    return merged(_without_gaps(kept, near, far))


def _without_gaps(segments: Segments, near: np.ndarray, far: np.ndarray) -> Segments:
    """Extend each segment to the beginning of the next segment, so that each ray is filled from `near` to `far`."""
    start, end = segments.near.copy(), segments.far.copy()
    if len(start):
        new = np.append(True, segments.ray[1:] != segments.ray[:-1])
        start[new] = near[segments.ray[new]]
        end[:-1] = np.where(new[1:], far[segments.ray[:-1]], start[1:])
        end[-1] = far[segments.ray[-1]]
    return Segments(segments.ray, segments.owner, start, end)
