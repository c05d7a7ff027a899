# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find trajectories with faults, which are rapids that cut and plunges that are too fast."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, pi, sin

import numpy as np

from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.zbuffer.findings.facts import removed_volumes
from vkworkbench.core.zbuffer.findings.fine_rays import half_widths
from vkworkbench.core.zbuffer.findings.removed_segments import RemovedSegments, segments_of
from vkworkbench.core.zbuffer.simulator.moments import ZBuffer
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts, Source
from vkworkbench.core.zbuffer.sweeps.intervals import headings, lowest
from vkworkbench.core.zbuffer.sweeps.trajectories import as_cut
from vkworkbench.language import Message

# _PLUNGE: slope (descent divided by horizontal length) above which a downward move is a plunge. _FULL: a plunge is into
# full material if it removes more than this share of the volume that the tool displaces.
_PLUNGE, _FULL = 5.0, 0.5
# Largest allowed ratio of a plunge's feed to the vertical feed. The ratio is slightly above 1, because FreeCAD rounds
# feeds.
_FASTER = 1.01
# _TOUCHES: horizontal depth, mm, up to which a rapid in a wall or flank only touches the material and is not a crash.
# At heights where a pointed tool is narrow, the limit is half of the tool's half width, but at least `_ROUNDED_ASIDE`.
# Smaller limits report crashes because of rounded coordinates; larger limits hide scratches of rapids.
_TOUCHES, _ROUNDED_ASIDE = 0.02, 0.002
# Material up to this height, mm, above the tool's lower surface counts as a rounding error.
ROUNDED = 1e-3
# The chords that replace arcs leave material about as thick as the largest distance between an arc and its chord (the
# arc's rise). Where arcs were cut, the limits for touching are at least `_OF_RISE` times the rise.
_OF_RISE = 2.0
_CELLS = 256  # number of cells along each side of the rectangle in which the rises of the arcs are stored
_SIDES = np.arange(8) * pi / 4
_SEGMENTS_AT_ONCE = 1 << 14
# Number of concentric rings with equal widths into which a tool is divided to compute its volume.
_RINGS = 64


@dataclass(frozen=True)
class Crash:
    """A rapid that cuts.

    Attributes
    ----------
    trajectory : int
        Number of the trajectory.
    source : Source
        Operation and command of the trajectory.
    place : (3,) tuple of float
        Middle of the longest segment of a ray that the rapid removes, mm.
    depth : float
        Length of the longest removed segment along the view, mm.
    volume : float
        Volume that the rapid removes, mm^3.
    """

    trajectory: int
    source: Source
    place: tuple[float, float, float]
    depth: float
    volume: float

    @property
    def what(self) -> Message:
        """A message that describes the crash."""
        return Message("rapid-cuts", volume=self.volume)


def crashes(zbuffer: ZBuffer) -> list[Crash]:
    """Return the rapids that remove material.

    A rapid that only touches a wall or flank with the tool's side is not returned.

    A rapid is not found if the removed material is narrower than a pixel and no ray meets it; `check_crashes` finds
    such rapids, too.

    Returns
    -------
    list of Crash
        The crashes, sorted by trajectory.
    """
    segments = segments_of(zbuffer, zbuffer.cuts.rapid)
    return crashes_among(zbuffer.cuts, segments, removed_volumes(zbuffer), ArcRises(zbuffer.cuts))


def crashes_among(cuts: Cuts, segments: RemovedSegments, volumes: np.ndarray, rises: ArcRises) -> list[Crash]:
    """Return the rapids that remove material and do not only touch it.

    Parameters
    ----------
    segments : RemovedSegments
        Segments of rays that rapids remove, without segments that other moves remove.
    volumes : (n,) ndarray
        Volume that each trajectory removes, mm^3.
    rises : ArcRises
        Distances between the arcs of the job and their chords.
    """
    if len(segments.owner) == 0:
        return []
    owner, middle, length = segments.owner, (segments.near + segments.far) / 2, segments.far - segments.near
    # The longest segments that each rapid removes are examined first. A rapid that only touches a wall can also remove
    # long segments, as high as the wall. Therefore the segments of each rapid are examined until one segment is inside
    # the rapid's swept volume by more than the depth that counts as touching.
    order = np.argsort(-length, kind="stable")
    longest = np.full(len(cuts), -1)
    for first in range(0, len(order), _SEGMENTS_AT_ONCE):
        some = order[first : first + _SEGMENTS_AT_ONCE]
        some = some[longest[owner[some]] < 0]
        if len(some):
            ends = segments.upper[some], middle[some]
            points = (segments.points(some, depth) for depth in ends)
            upper_in, middle_in = (_inside(cuts, owner[some], at, rises.at(at)) for at in points)
            some = some[upper_in | middle_in]
            crashed, position = np.unique(owner[some], return_index=True)
            longest[crashed] = some[position]
    crashed = np.flatnonzero(longest >= 0)
    longest = longest[crashed]
    places = segments.points(longest, middle[longest])
    return [
        Crash(trajectory, cuts.source(trajectory), tuple(at), depth, float(volumes[trajectory]))
        for trajectory, at, depth in zip(crashed.tolist(), places.tolist(), length[longest].tolist())
    ]


class ArcRises:
    """The largest distances between the arcs of a job and their chords, by place.

    The rectangle that contains all arcs, seen from above, is divided into `_CELLS` by `_CELLS` cells. For each cell, the
    largest horizontal and the largest vertical rise of the arcs that reach the cell are stored.
    """

    def __init__(self, cuts: Cuts) -> None:
        rises = np.concatenate([np.empty((2, 0)), *(_rises(cut.toolpath) for cut in cuts.cuts)], axis=1)
        chords = np.flatnonzero((_OF_RISE * rises > [[_ROUNDED_ASIDE], [ROUNDED]]).any(axis=0))
        self._rises = np.zeros((2, _CELLS, _CELLS))
        self._lower, self._cell = np.zeros(2), np.ones(2)
        if len(chords) == 0:
            return
        start, end = (ends[chords, :2] for ends in cuts.ends)
        radius = np.array([cut.tool.radius for cut in cuts.cuts])[cuts.cut[chords]][:, None]
        # All chords of one arc are joined, because they have the same command.
        first = np.flatnonzero(np.diff(cuts.command[chords], prepend=-1) | (np.diff(chords, prepend=-1) > 1))
        lower = np.minimum.reduceat(np.minimum(start, end) - radius, first)
        upper = np.maximum.reduceat(np.maximum(start, end) + radius, first)
        self._lower, self._cell = lower.min(axis=0), (upper.max(axis=0) - lower.min(axis=0)) / _CELLS
        begin, last = (((at - self._lower) / self._cell).astype(np.int64) for at in (lower, upper))
        for (x, y), (right, top), rise in zip(begin, last + 1, np.maximum.reduceat(rises[:, chords], first, axis=1).T):
            reached = self._rises[:, x:right, y:top]
            np.maximum(reached, rise[:, None, None], out=reached)

    def at(self, points: np.ndarray) -> np.ndarray:
        """Return the horizontal and the vertical rise of the arcs at the points (k, 3), (2, k) mm."""
        x, y = np.floor((points[:, :2] - self._lower) / self._cell).astype(np.int64).T
        inside = (x >= 0) & (x < _CELLS) & (y >= 0) & (y < _CELLS)
        return np.where(inside, self._rises[:, np.where(inside, x, 0), np.where(inside, y, 0)], 0.0)


def _inside(cuts: Cuts, trajectory: np.ndarray, points: np.ndarray, rises: np.ndarray) -> np.ndarray:
    """Return whether each point (k, 3) is inside the swept volume of its trajectory (k,) by more than touching it.

    `rises` (2, k) contains the horizontal and the vertical rise of the arcs at each point, mm.
    """
    start, end = (ends.T for ends in as_cut(*(ends[trajectory] for ends in cuts.ends)))
    heading = headings(end - start)
    inside = np.ones(len(trajectory), bool)
    up = np.maximum(ROUNDED, _OF_RISE * rises[1])
    for number in np.unique(cuts.cut[trajectory]):
        tool, of_cut = cuts.cuts[number].tool, cuts.cut[trajectory] == number
        width = half_widths(tool, points[:, 2] - np.minimum(start[2], end[2]))
        aside = np.maximum(np.clip(width / 2, _ROUNDED_ASIDE, _TOUCHES), _OF_RISE * rises[0])
        aside = np.minimum(aside, tool.radius / 2)
        for angle in _SIDES:  # angle between the move and the direction in which the points are shifted
            own = np.flatnonzero(inside & of_cut)
            (ux, uy), (x, y, z) = heading[:2, own], points[own].T
            x = x + aside[own] * (cos(angle) * ux - sin(angle) * uy)
            y = y + aside[own] * (cos(angle) * uy + sin(angle) * ux)
            floor, _ = lowest(tool, start[:, own], heading[:, own], x, y)
            inside[own] = z > floor + up[own]
    return inside


def _rises(toolpath: Toolpath) -> np.ndarray:
    """Return the horizontal and the vertical distance between each chord and its arc, (2, n) mm."""
    chords = np.abs(np.diff(toolpath.points, axis=0))
    upright = toolpath.plane != 17
    run = np.hypot(*chords[:, :2].T)
    # The largest distance between an arc and its chord (the rise) is perpendicular to the chord. For an arc in a
    # vertical plane, the horizontal rise grows with the chord's height, and the vertical rise grows with the chord's
    # horizontal length.
    lengths = np.where(upright, (chords[:, 2], run), (run, np.zeros_like(run)))
    return lengths / 2 * np.tan(np.abs(toolpath.sweep) / 4)


@dataclass(frozen=True)
class Plunge:
    """A plunge into full material, faster than the vertical feed of its tool.

    Attributes
    ----------
    trajectory : int
        Number of the trajectory.
    source : Source
        Operation and command of the trajectory.
    place : (3,) tuple of float
        End of the plunge, mm.
    feed, allowed : float
        Feed of the plunge, and vertical feed of the tool, mm/s.
    """

    trajectory: int
    source: Source
    place: tuple[float, float, float]
    feed: float
    allowed: float

    @property
    def what(self) -> Message:
        """A message that describes the plunge."""
        return Message("plunges-fast", feed=60 * self.feed, allowed=60 * self.allowed)


def fast_plunges(zbuffer: ZBuffer) -> list[Plunge]:
    """Return the plunges into full material that are faster than the vertical feed of their tool.

    Returns
    -------
    list of Plunge
        The plunges, sorted by trajectory.
    """
    cuts = zbuffer.cuts
    fast = too_fast(cuts) & (removed_volumes(zbuffer) > 0)
    return plunges_among(cuts, np.flatnonzero(fast), segments_of(zbuffer, fast)) if fast.any() else []


def too_fast(cuts: Cuts) -> np.ndarray:
    """Return whether each trajectory plunges faster than its tool's vertical feed, (n,) bool, even through air."""
    start, end = cuts.ends
    run, fall = np.hypot(*(end - start)[:, :2].T), start[:, 2] - end[:, 2]
    allowed = _vertical_feeds(cuts)
    return ~cuts.rapid & (fall > _PLUNGE * run) & (allowed > 0) & (cuts.feed > _FASTER * allowed)


def plunges_among(cuts: Cuts, plunges: np.ndarray, segments: RemovedSegments) -> list[Plunge]:
    """Return the fast plunges that go into full material.

    `plunges` (k,) are the trajectories of all fast plunges, and `segments` are the segments that these plunges remove.
    """
    start, end = (ends[plunges] for ends in cuts.ends)
    # Depth of the plunge's end below the highest point that the plunge removes, but at most the height of the plunge.
    depth = np.minimum(segments.tops(len(cuts))[plunges], start[:, 2]) - end[:, 2]
    displaced = np.empty(len(plunges))
    of_cut = cuts.cut[plunges]
    for number in np.unique(of_cut):
        own = of_cut == number
        displaced[own] = _displaced_volume(cuts.cuts[number].tool, depth[own])
    volumes, allowed = segments.volumes(len(cuts))[plunges], _vertical_feeds(cuts)[plunges]
    return [
        Plunge(int(plunges[i]), cuts.source(int(plunges[i])), tuple(end[i].tolist()),
               float(cuts.feed[plunges[i]]), float(allowed[i]))
        for i in np.flatnonzero((volumes > 0) & (volumes > _FULL * displaced))
    ]  # fmt: skip


def _vertical_feeds(cuts: Cuts) -> np.ndarray:
    """Return the vertical feed of each trajectory's tool, (n,) mm/s; 0 if the feed is unknown."""
    return np.array([own.vertical_feed for own in cuts.cuts])[cuts.cut]


def _displaced_volume(tool: Tool, depth: np.ndarray) -> np.ndarray:
    """Return the volume of a tool from its tip to each height `depth` above the tip, mm^3."""
    width = tool.radius / _RINGS
    volume = np.zeros_like(depth)
    for radius in (np.arange(_RINGS) + 0.5) * width:
        volume += 2 * np.pi * radius * width * np.maximum(depth - tool.height(radius), 0)
    return volume
