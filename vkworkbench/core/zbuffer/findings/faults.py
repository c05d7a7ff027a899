# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where trajectories remove what they should not: rapids that cut, plunges that are too fast."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, pi, sin

import numpy as np

from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.view import Frame
from vkworkbench.core.zbuffer.findings.facts import removed_volumes
from vkworkbench.core.zbuffer.simulator.moments import ZBuffer
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts, Source
from vkworkbench.core.zbuffer.sweeps.intervals import headings, lowest
from vkworkbench.core.zbuffer.sweeps.trajectories import as_cut

# A move steeper than 5 in 1 downwards is a plunge; one that removes half of what its tool displaces is in full material.
_PLUNGE, _FULL = 5.0, 0.5
# What a feed may exceed another by: FreeCAD rounds them.
_FASTER = 1.01
# A rapid that would cut nothing if it lay so much aside, mm, only touches what chords of arcs, or rounded coordinates, left
# of a wall or a flank. Chords of one arc are no farther from each other than it rises above them: twice that is enough.
_TOUCHES, _OF_RISE = 0.02, 2.0
_SIDES = np.arange(8) * pi / 4
# Under its tip any depth counts, but for rounding, mm, and for what chords of arcs in vertical planes left.
_ROUNDED = 1e-3
_PIECES_AT_ONCE = 1 << 14
# Rings of equal width by which the volume of a tool is summed up.
_RINGS = 64


@dataclass(frozen=True)
class Crash:
    """A rapid that cuts.

    Attributes
    ----------
    trajectory : int
        Its number.
    source : Source
        Its cut and command.
    place : (3,) tuple of float
        Where the piece that it removes is longest, mm.
    depth : float
        How long that piece is along the view, mm.
    volume : float
        What it removes, mm^3.
    """

    trajectory: int
    source: Source
    place: tuple[float, float, float]
    depth: float
    volume: float


def crashes(zbuffer: ZBuffer) -> list[Crash]:
    """Rapids that remove material, and do not only touch a wall or a flank with their side, in their order.

    Parameters
    ----------
    zbuffer : ZBuffer
    """
    records, frame = zbuffer.records, zbuffer.frame
    pieces, pixel, near = records.pieces_of(zbuffer.cuts.rapid)
    if len(pieces) == 0:
        return []
    owner, near, far = records.owner[pieces], near.astype(float), records.far[pieces].astype(float)
    upper, middle = _upper(frame, near, far), (near + far) / 2

    def place(piece: np.ndarray, depth: np.ndarray) -> np.ndarray:
        row, column = np.divmod(pixel[piece], frame.width)
        return frame.points(column, row, depth[piece])

    cuts, volumes = zbuffer.cuts, removed_volumes(zbuffer)
    rises = np.max([_rises(cut.toolpath) for cut in cuts.cuts], axis=0)
    touches = np.maximum((_TOUCHES, _ROUNDED), _OF_RISE * rises)
    # The longest pieces first: where a wall is only touched they are as high as the wall.
    order = np.argsort(near - far, kind="stable")
    longest = np.full(zbuffer.trajectories, -1)
    for first in range(0, len(order), _PIECES_AT_ONCE):
        some = order[first : first + _PIECES_AT_ONCE]
        some = some[longest[owner[some]] < 0]
        if len(some):
            upper_in, middle_in = (_inside(cuts, owner[some], place(some, depth), touches) for depth in (upper, middle))
            some = some[upper_in | middle_in]
            crashed, its_first = np.unique(owner[some], return_index=True)
            longest[crashed] = some[its_first]
    crashed = np.flatnonzero(longest >= 0)
    longest = longest[crashed]
    return [
        Crash(trajectory, cuts.source(trajectory), tuple(at), depth, float(volumes[trajectory]))
        for trajectory, at, depth in zip(
            crashed.tolist(), place(longest, middle).tolist(), (far - near)[longest].tolist()
        )
    ]


def _upper(frame: Frame, near: np.ndarray, far: np.ndarray) -> np.ndarray:
    """Which end of pieces of rays is the higher one."""
    return near if frame.direction[2] < 0 else far


def _inside(cuts: Cuts, trajectory: np.ndarray, points: np.ndarray, touches: np.ndarray) -> np.ndarray:
    """Which points (k, 3) trajectories (k,) remove, and would remove as well if they lay so much, mm, to any side and higher."""
    start, end = (ends.T for ends in as_cut(*(ends[trajectory] for ends in cuts.ends)))
    heading = headings(end - start)
    inside = np.ones(len(trajectory), bool)
    for number in np.unique(cuts.cut[trajectory]):
        tool = cuts.cuts[number].tool
        aside = min(touches[0], tool.radius / 2)
        for angle in _SIDES:  # from the direction of the move
            own = np.flatnonzero(inside & (cuts.cut[trajectory] == number))
            (ux, uy), (x, y, z) = heading[:2, own], points[own].T
            x = x + aside * (cos(angle) * ux - sin(angle) * uy)
            y = y + aside * (cos(angle) * uy + sin(angle) * ux)
            floor, _ = lowest(tool, start[:, own], heading[:, own], x, y)
            inside[own] = z > floor + touches[1]
    return inside


def _rises(toolpath: Toolpath) -> tuple[float, float]:
    """How far arcs rise at most above the chords that stand for them, aside and in height, mm."""
    chords = np.abs(np.diff(toolpath.points, axis=0))
    upright = toolpath.plane != 17
    run = np.hypot(*chords[:, :2].T)
    # An arc rises at right angles to its chord.
    aside, up = (
        np.where(upright, (chords[:, 2], run), (run, np.zeros_like(run))) / 2 * np.tan(np.abs(toolpath.sweep) / 4)
    )
    return float(aside.max(initial=0.0)), float(up.max(initial=0.0))


@dataclass(frozen=True)
class Plunge:
    """A plunge into full material that is faster than the tool may plunge.

    Attributes
    ----------
    trajectory : int
        Its number.
    source : Source
        Its cut and command.
    place : (3,) tuple of float
        Where it ends, mm.
    feed, allowed : float
        mm/s.
    """

    trajectory: int
    source: Source
    place: tuple[float, float, float]
    feed: float
    allowed: float


def fast_plunges(zbuffer: ZBuffer) -> list[Plunge]:
    """Plunges into full material above the vertical feed of their tool, in their order.

    Parameters
    ----------
    zbuffer : ZBuffer
    """
    cuts = zbuffer.cuts
    start, end = cuts.ends
    run, fall = np.hypot(*(end - start)[:, :2].T), start[:, 2] - end[:, 2]
    allowed = np.array([own.vertical_feed for own in cuts.cuts])[cuts.cut]
    volumes = removed_volumes(zbuffer)
    fast = ~cuts.rapid & (fall > _PLUNGE * run) & (allowed > 0) & (cuts.feed > _FASTER * allowed) & (volumes > 0)
    if not fast.any():
        return []
    plunges = np.flatnonzero(fast)
    # How deep the tip is in the material, or falls in it.
    depth = np.minimum(_tops(zbuffer, fast) - end[:, 2], fall)[plunges]
    displaced = np.empty(len(plunges))
    for number in np.unique(cuts.cut[plunges]):
        own = cuts.cut[plunges] == number
        displaced[own] = _displaced(cuts.cuts[number].tool, depth[own])
    return [
        Plunge(int(i), cuts.source(int(i)), tuple(end[i].tolist()), float(cuts.feed[i]), float(allowed[i]))
        for i in plunges[volumes[plunges] > _FULL * displaced]
    ]


def _tops(zbuffer: ZBuffer, owners: np.ndarray) -> np.ndarray:
    """Height of the highest point that each of some trajectories (n,) bool removes, (n,) mm; -inf where nothing."""
    records, frame = zbuffer.records, zbuffer.frame
    pieces, pixel, near = records.pieces_of(owners)
    row, column = np.divmod(pixel, frame.width)
    height = frame.points(column, row, _upper(frame, near, records.far[pieces]))[:, 2]
    tops = np.full(zbuffer.trajectories, -np.inf)
    np.maximum.at(tops, records.owner[pieces], height)
    return tops


def _displaced(tool: Tool, depth: np.ndarray) -> np.ndarray:
    """Volume of a tool up to so high above its tip, of the shape of `depth`, mm^3."""
    width = tool.radius / _RINGS
    volume = np.zeros_like(depth)
    for r in (np.arange(_RINGS) + 0.5) * width:
        volume += 2 * np.pi * r * width * np.maximum(depth - tool.height(r), 0)
    return volume
