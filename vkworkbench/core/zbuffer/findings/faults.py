# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find faults of trajectories: rapids that cut, and plunges that are too fast."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, pi, sin

import numpy as np

from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.zbuffer.findings.facts import removed_volumes
from vkworkbench.core.zbuffer.findings.removed_pieces import RemovedPieces, pieces_of
from vkworkbench.core.zbuffer.simulator.moments import ZBuffer
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts, Source
from vkworkbench.core.zbuffer.sweeps.intervals import headings, lowest
from vkworkbench.core.zbuffer.sweeps.trajectories import as_cut

# Slope above which a downward move is a plunge, and the share of the displaced volume above which it plunges into full material.
_PLUNGE, _FULL = 5.0, 0.5
# Factor by which a feed may exceed the vertical feed, because FreeCAD rounds feeds.
_FASTER = 1.01
# Distance to the side, mm, below which a rapid only touches a wall or flank: chords of arcs and rounded coordinates leave
# material there. The chords of an arc deviate from each other by at most the arc's rise over a chord; the factor adds a margin.
_TOUCHES, _OF_RISE = 0.02, 2.0
_SIDES = np.arange(8) * pi / 4
# Depth under the tip that is a rounding error, mm. Chords of arcs in vertical planes add their own rise.
_ROUNDED = 1e-3
_PIECES_AT_ONCE = 1 << 14
# Number of rings of equal width for the volume of a tool.
_RINGS = 64


@dataclass(frozen=True)
class Crash:
    """A rapid that cuts.

    Attributes
    ----------
    trajectory : int
        Number of the trajectory.
    source : Source
        Cut and command of the trajectory.
    place : (3,) tuple of float
        Middle of the longest piece that the rapid removes, mm.
    depth : float
        Length of this piece along the view, mm.
    volume : float
        Volume that the rapid removes, mm^3.
    """

    trajectory: int
    source: Source
    place: tuple[float, float, float]
    depth: float
    volume: float


def crashes(zbuffer: ZBuffer) -> list[Crash]:
    """Return the rapids that remove material, except those that only touch a wall or flank with the tool's side.

    A rapid that removes less than a pixel may be missed; `check_crashes` finds it.

    Parameters
    ----------
    zbuffer : ZBuffer

    Returns
    -------
    list of Crash
        In the order of the trajectories.
    """
    return crashes_among(zbuffer.cuts, pieces_of(zbuffer, zbuffer.cuts.rapid), removed_volumes(zbuffer))


def crashes_among(cuts: Cuts, pieces: RemovedPieces, volumes: np.ndarray) -> list[Crash]:
    """Return the crashes among the pieces that rapids remove.

    Parameters
    ----------
    cuts : Cuts
    pieces : RemovedPieces
        Pieces of rapids only.
    volumes : (n,) ndarray
        Volume that each trajectory removes, mm^3.
    """
    if len(pieces.owner) == 0:
        return []
    owner, middle, length = pieces.owner, (pieces.near + pieces.far) / 2, pieces.far - pieces.near
    touches = touching(cuts)
    # Longest pieces first. A rapid that only touches a wall has long pieces too, as high as the wall, so all pieces are tried.
    order = np.argsort(-length, kind="stable")
    longest = np.full(len(cuts), -1)
    for first in range(0, len(order), _PIECES_AT_ONCE):
        some = order[first : first + _PIECES_AT_ONCE]
        some = some[longest[owner[some]] < 0]
        if len(some):
            ends = pieces.upper[some], middle[some]
            upper_in, middle_in = (_inside(cuts, owner[some], pieces.points(some, depth), touches) for depth in ends)
            some = some[upper_in | middle_in]
            crashed, position = np.unique(owner[some], return_index=True)
            longest[crashed] = some[position]
    crashed = np.flatnonzero(longest >= 0)
    longest = longest[crashed]
    places = pieces.points(longest, middle[longest])
    return [
        Crash(trajectory, cuts.source(trajectory), tuple(at), depth, float(volumes[trajectory]))
        for trajectory, at, depth in zip(crashed.tolist(), places.tolist(), length[longest].tolist())
    ]


def touching(cuts: Cuts) -> np.ndarray:
    """Return the distances, to the side and upwards, by which a rapid may enter material that it only touches, (2,) mm."""
    rises = np.max([_rises(cut.toolpath) for cut in cuts.cuts], axis=0, initial=0.0)
    result: np.ndarray = np.maximum((_TOUCHES, _ROUNDED), _OF_RISE * rises)
    return result


def _inside(cuts: Cuts, trajectory: np.ndarray, points: np.ndarray, touches: np.ndarray) -> np.ndarray:
    """Return which points (k, 3) are inside the sweeps of trajectories (k,) by a margin `touches`: to the side, and upwards, mm."""
    start, end = (ends.T for ends in as_cut(*(ends[trajectory] for ends in cuts.ends)))
    heading = headings(end - start)
    inside = np.ones(len(trajectory), bool)
    for number in np.unique(cuts.cut[trajectory]):
        tool = cuts.cuts[number].tool
        aside = min(touches[0], tool.radius / 2)
        for angle in _SIDES:  # measured from the direction of the move
            own = np.flatnonzero(inside & (cuts.cut[trajectory] == number))
            (ux, uy), (x, y, z) = heading[:2, own], points[own].T
            x = x + aside * (cos(angle) * ux - sin(angle) * uy)
            y = y + aside * (cos(angle) * uy + sin(angle) * ux)
            floor, _ = lowest(tool, start[:, own], heading[:, own], x, y)
            inside[own] = z > floor + touches[1]
    return inside


def _rises(toolpath: Toolpath) -> tuple[float, float]:
    """Return the largest rise of arcs over their chords, to the side and in height, mm."""
    chords = np.abs(np.diff(toolpath.points, axis=0))
    upright = toolpath.plane != 17
    run = np.hypot(*chords[:, :2].T)
    # The rise of an arc is perpendicular to its chord.
    aside, up = (
        np.where(upright, (chords[:, 2], run), (run, np.zeros_like(run))) / 2 * np.tan(np.abs(toolpath.sweep) / 4)
    )
    return float(aside.max(initial=0.0)), float(up.max(initial=0.0))


@dataclass(frozen=True)
class Plunge:
    """A plunge into full material, faster than the vertical feed of its tool.

    Attributes
    ----------
    trajectory : int
        Number of the trajectory.
    source : Source
        Cut and command of the trajectory.
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


def fast_plunges(zbuffer: ZBuffer) -> list[Plunge]:
    """Return the plunges into full material that are faster than the vertical feed of their tool.

    Parameters
    ----------
    zbuffer : ZBuffer

    Returns
    -------
    list of Plunge
        In the order of the trajectories.
    """
    cuts = zbuffer.cuts
    fast = too_fast(cuts) & (removed_volumes(zbuffer) > 0)
    return plunges_among(cuts, np.flatnonzero(fast), pieces_of(zbuffer, fast)) if fast.any() else []


def too_fast(cuts: Cuts) -> np.ndarray:
    """Return which trajectories plunge faster than the vertical feed of their tool, into material or not, (n,) bool."""
    start, end = cuts.ends
    run, fall = np.hypot(*(end - start)[:, :2].T), start[:, 2] - end[:, 2]
    allowed = _vertical_feeds(cuts)
    result: np.ndarray = ~cuts.rapid & (fall > _PLUNGE * run) & (allowed > 0) & (cuts.feed > _FASTER * allowed)
    return result


def plunges_among(cuts: Cuts, plunges: np.ndarray, pieces: RemovedPieces) -> list[Plunge]:
    """Return the plunges into full material among plunges (k,) that are too fast, from the pieces that they remove."""
    start, end = (ends[plunges] for ends in cuts.ends)
    # Depth of the tip below the highest removed point, at most the height of the plunge.
    depth = np.minimum(pieces.tops(len(cuts))[plunges], start[:, 2]) - end[:, 2]
    displaced = np.empty(len(plunges))
    of_cut = cuts.cut[plunges]
    for number in np.unique(of_cut):
        own = of_cut == number
        displaced[own] = _displaced_volume(cuts.cuts[number].tool, depth[own])
    volumes, allowed = pieces.volumes(len(cuts))[plunges], _vertical_feeds(cuts)[plunges]
    return [
        Plunge(int(plunges[i]), cuts.source(int(plunges[i])), tuple(end[i].tolist()),
               float(cuts.feed[plunges[i]]), float(allowed[i]))
        for i in np.flatnonzero((volumes > 0) & (volumes > _FULL * displaced))
    ]  # fmt: skip


def _vertical_feeds(cuts: Cuts) -> np.ndarray:
    """Return the vertical feed of each trajectory's tool, (n,) mm/s; 0 if unknown."""
    allowed: np.ndarray = np.array([own.vertical_feed for own in cuts.cuts])[cuts.cut]
    return allowed


def _displaced_volume(tool: Tool, depth: np.ndarray) -> np.ndarray:
    """Return the volume of a tool from its tip to each height `depth` above it, mm^3."""
    width = tool.radius / _RINGS
    volume = np.zeros_like(depth)
    for radius in (np.arange(_RINGS) + 0.5) * width:
        volume += 2 * np.pi * radius * width * np.maximum(depth - tool.height(radius), 0)
    return volume
