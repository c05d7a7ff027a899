# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the points of a part at which a cut is so narrow that it passes between the rays of the simulation.

Engravings of a large part are examples of narrow cuts. Only a few rays meet an engraving, so a picture of the columns
of material would show the engraving as dots.
"""

from __future__ import annotations

from typing import NamedTuple
from weakref import WeakKeyDictionary

import numpy as np

from vkworkbench.core.zbuffer import Cuts, ZBuffer

# _STEP: distance between neighbouring sampled points of a path, in cells. _MOST: largest number of sampled points.
_STEP, _MOST = 0.5, 1_000_000
# Tools with a radius below this limit, in cells, are narrow: they can pass between four neighbouring rays.
_NARROW = 0.71
# Number of sampled points of a path, before and after a point with an uncut ray, that are also drawn, although their
# own rays happened to be cut.
_BESIDE = 2
# Difference between two heights, mm, above which the difference is not a rounding error.
_NOISE = 1e-3
# Cache of the points that `_sampled` returns, by job, because many moments of one job are drawn while the simulation is
# played.
_sampled_before: WeakKeyDictionary[Cuts, tuple[float, tuple[np.ndarray, ...]]] = WeakKeyDictionary()


class ThinCuts(NamedTuple):
    """Points on the surface of the part, directly above narrow cuts."""

    points: np.ndarray  # (k, 3): positions of the points, mm
    owner: np.ndarray  # (k,) int: trajectory that cuts at each point, ascending


def thin_cuts(zbuffer: ZBuffer, top: np.ndarray) -> ThinCuts:
    """Return the points of narrow cuts at which the tool's tip is below the surface and the nearest ray was not cut.

    Up to `_BESIDE` points before and after a returned point along the path are included, too. The z-buffer is the
    simulation from above, at the moment to show. `top` (rows, columns) is the height of the part's surface on each ray
    above the centre of the stock, mm; `EMPTY` on a ray without material.
    """
    frame = zbuffer.frame
    if _sampled_before.get(zbuffer.cuts, (0.0,))[0] != frame.pixel:
        _sampled_before[zbuffer.cuts] = frame.pixel, _sampled(zbuffer.cuts, frame.pixel)
    points, owner, tool = _sampled_before[zbuffer.cuts][1]
    end = int(np.searchsorted(owner, zbuffer.step))
    points, owner, tool = points[:end], owner[:end], tool[:end]
    place = (points[:, :2] - frame.centre[:2]) / frame.pixel + np.array([frame.width, frame.height]) / 2
    cell = np.floor(place).astype(np.int64)
    inside = ((cell >= 0) & (cell < (frame.width, frame.height))).all(axis=1)
    points, owner, tool, place, cell = (part[inside] for part in (points, owner, tool, place, cell))
    distance = frame.pixel * np.hypot(*(place - cell - 0.5).T)
    height = points[:, 2].copy()
    for number in np.unique(tool).tolist():
        own = tool == number
        height[own] += zbuffer.cuts.cuts[number].tool.height(distance[own])
    surface = top[cell[:, 1], cell[:, 0]] + frame.centre[2]
    uncut = (points[:, 2] + _NOISE < surface) & (surface < height - _NOISE)
    shown = uncut.copy()
    for step in range(1, _BESIDE + 1):
        shown[step:] |= uncut[:-step]
        shown[:-step] |= uncut[step:]
    # Do not draw points at which another cut removed all material above the narrow cut's floor.
    shown &= surface > points[:, 2] - _NOISE
    return ThinCuts(np.column_stack((points[shown, :2], surface[shown])), owner[shown])


def _sampled(cuts: Cuts, cell: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return points on the paths of narrow tools (k, 3), and the trajectory and the cut of each point (k,)."""
    narrow = np.array([tool.radius < _NARROW * cell or (tool.steepness > 0 and tool.tip < cell)
                       for tool in (cut.tool for cut in cuts.cuts)])  # fmt: skip
    moves = np.flatnonzero(narrow[cuts.cut])
    start, end = (ends[moves] for ends in cuts.ends)
    count = np.ceil(np.hypot(*(end - start)[:, :2].T) / (_STEP * cell)).astype(np.int64) + 1
    count = count[: int(np.searchsorted(np.cumsum(count), _MOST))]
    own = np.repeat(np.arange(len(count)), count)
    share = (np.arange(len(own)) - np.repeat(np.cumsum(count) - count, count)) / np.maximum(count - 1, 1)[own]
    return start[own] + share[:, None] * (end - start)[own], moves[own], cuts.cut[moves[own]]
