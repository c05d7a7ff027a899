# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the number of trace elements in closed form, with and without the strategy, for benchmarks/resources.py.

Neither formula uses the order of the trajectories. The formula with the strategy follows the paper (sections 1 and
2.1): strategy, stepover and tool determine how much new material each trajectory cuts.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.paper import directions
from vkworkbench.core.recognition import Recognition
from vkworkbench.core.stocks import Solid
from vkworkbench.core.strategy import Strategy
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.view import Frame, View
from vkworkbench.core.zbuffer.memory.silhouette import clip, polygon_area

# Horizontal moves whose heights differ by less than this, mm, count as moves at one height.
_LEVEL = 1e-3
# The moves in one direction at one height are rows if they have more than this share of the length at that height.
# Moves with a smaller share are links.
_FAMILY = 0.15
# Minimum distance between two rows, mm. Moves at a smaller distance belong to the same row.
_APART = 0.05
# Strategies whose area is computed from rows. Mixed operations are mostly rows with a contour around them.
_ROWS = {Strategy.ZIGZAG, Strategy.ONE_WAY, Strategy.MIXED}
_LOOPS = {Strategy.CONTOUR_PARALLEL, Strategy.SPIRAL, Strategy.ADAPTIVE}


@dataclass(frozen=True, eq=False)
class _Trajectories:
    """The trajectories below the top of the stock. Each array has one value for each trajectory.

    run : horizontal length, mm; rise : end height - start height, mm; low : lowest height, mm;
    share : share of the swept area that lies over the stock, 0 to 1; heading : direction, rad; turn : angle of the arc
    to which the chord belongs, rad, 0 for straight moves.
    """

    start: np.ndarray
    end: np.ndarray
    run: np.ndarray
    rise: np.ndarray
    low: np.ndarray
    share: np.ndarray
    heading: np.ndarray
    turn: np.ndarray


def _in_stock(toolpath: Toolpath, tool: Tool, stock: Solid) -> _Trajectories:
    start, end = toolpath.points[:-1], toolpath.points[1:]
    low = np.minimum(start[:, 2], end[:, 2])
    inside = np.flatnonzero(low < stock.upper[2] - _LEVEL)
    start, end = start[inside], end[inside]
    left, right = np.minimum(start, end)[:, :2] - tool.radius, np.maximum(start, end)[:, :2] + tool.radius
    over = np.minimum(right, stock.upper[:2]) - np.maximum(left, stock.lower[:2])
    share = np.prod(np.maximum(over / (right - left), 0), axis=1)
    move = end - start
    return _Trajectories(
        start,
        end,
        np.hypot(move[:, 0], move[:, 1]),
        move[:, 2],
        low[inside],
        share,
        directions(move[:, 0], move[:, 1]),
        toolpath.sweep[inside],
    )


def swept(toolpath: Toolpath, *, tool: Tool, stock: Solid, view: View) -> float:
    """Return the number of trace elements if every trajectory cut new material over the tool's whole width.

    Parameters
    ----------
    toolpath : Toolpath
    tool : Tool
    stock : Solid
    view : View
    """
    t = _in_stock(toolpath, tool, stock)
    # The tool's circle at the start of a move contains new material only in a plunge.
    area = np.where(t.run > 0, tool.diameter * t.run, np.pi * tool.radius**2)
    return float((area * t.share).sum() / view.frame(stock).pixel ** 2)


def closed_form(toolpath: Toolpath, recognition: Recognition, *, tool: Tool, stock: Solid, view: View) -> float:
    """Return the number of trace elements that is expected from strategy, stepover and tool.

    Parameters
    ----------
    toolpath : Toolpath
    recognition : Recognition
        Strategy, stepover, passes and depths are used. Without a stepover, the tool's diameter is used.
    tool : Tool
    stock : Solid
    view : View
    """
    frame = view.frame(stock)
    t = _in_stock(toolpath, tool, stock)
    if len(t.run) == 0:
        return 0.0
    stepover = recognition.stepover
    if stepover is None and recognition.strategy in _ROWS | _LOOPS:
        # For passes at one depth, the stepover is the area divided by the length of the passes.
        room, _ = _grown_hull(np.concatenate((t.start, t.end))[:, :2], tool.radius, stock)
        stepover = room / max(float((t.run * t.share).sum()), 1e-9)
    stepover = min(stepover or tool.diameter, tool.diameter)
    pointed = tool.rounding > tool.radius / 2 or tool.steepness > 0
    top = _recut(t, tool, stock, stepover) if pointed else _levels(t, recognition, tool, stock, stepover)
    cosine, sine, azimuth = _tilt(frame)
    return (cosine * top + sine * _walls(t, tool, stock, stepover, azimuth)) / frame.pixel**2


def _tilt(frame: Frame) -> tuple[float, float, float]:
    x, y, z = frame.direction
    return abs(float(z)), float(np.hypot(x, y)), float(np.arctan2(y, x))


def _levels(t: _Trajectories, recognition: Recognition, tool: Tool, stock: Solid, stepover: float) -> float:
    """Return the area that a flat tool cuts, mm^2: the area at each height, plus the tool's circle at each descent."""
    radius = tool.radius
    level = np.flatnonzero((np.abs(t.rise) < _LEVEL) & (t.run > 0))
    key = np.rint(t.low / _LEVEL).astype(np.int64)
    # If there are horizontal moves at the end height of a descent, the computed area at this height already includes
    # the descent. Every other descent also cuts the area of the tool's circle.
    between = ~np.isin(key, key[level])
    descents = _descents(t, tool) * t.share
    if recognition.strategy is Strategy.HELIX:
        descents *= _beside_last_helix(t, tool)
    total = float(descents[between].sum())
    passes = max(1.0, (recognition.passes or 1) / max(1, recognition.depths))
    for z in np.unique(key[level]):
        here = level[key[level] == z]
        weight = (t.run * t.share)[here]
        length = float(weight.sum())
        points = np.concatenate((t.start[here], t.end[here]))[:, :2]
        room, outline = _grown_hull(points, radius, stock)
        if room <= 0:
            continue  # the trajectories do not touch the stock
        if recognition.strategy in _ROWS:
            # The shares of the area that rows of different directions cover are assumed to be statistically
            # independent.
            shares = [_rows_area(t, rows, tool, stepover) / room for rows in _row_families(t, here)]
            area = room * (1 - np.prod(1 - np.minimum(shares, 1)))
        elif recognition.strategy in _LOOPS:
            area = stepover * length + (radius - stepover / 2) * outline
        else:
            area = stepover * length + (2 * radius - stepover) * length / passes
        total += min(area, room)
    return total


def _descents(t: _Trajectories, tool: Tool) -> np.ndarray:
    """Return the area that each descending trajectory of a flat tool cuts, mm^2, including the tool's circle."""
    down = np.flatnonzero(t.rise < -_LEVEL)
    # A plunge cuts new area only if it is deeper than all earlier plunges at the same place.
    place = np.rint(t.end[down, :2] / _LEVEL).astype(np.int64)
    _, group = np.unique(place, axis=0, return_inverse=True)
    group = group.ravel()
    order = np.argsort(group, kind="stable")
    depth = t.low[down][order]
    span = np.ptp(depth) + 1 if len(depth) else 1.0
    lowest = np.minimum.accumulate(depth - group[order] * span)
    deeper = np.ones(len(down), bool)
    deeper[1:] = lowest[1:] < lowest[:-1] - _LEVEL
    areas = np.zeros(len(t.run))
    reached = down[order[deeper]]
    areas[reached] = np.pi * tool.radius**2 + 2 * tool.radius * t.run[reached]
    return areas


def _beside_last_helix(t: _Trajectories, tool: Tool) -> np.ndarray:
    """Return the share of the tool's circle, 0 to 1, that the previous helix in the same hole has not cut."""
    arc = np.flatnonzero(t.turn)
    half = t.turn[arc] / 2
    chord = (t.end - t.start)[arc, :2]
    to_centre = np.column_stack((-chord[:, 1], chord[:, 0])) / (2 * np.tan(half))[:, None]
    hole = np.rint(((t.start + t.end)[arc, :2] / 2 + to_centre) / _APART).astype(np.int64)
    helix = np.rint(t.run[arc] / (2 * np.abs(np.sin(half))) / _APART).astype(np.int64)
    _, first, which = np.unique(np.column_stack((hole, helix)), axis=0, return_index=True, return_inverse=True)
    foot = np.pi * tool.radius**2
    part = np.ones(len(first))
    last: dict[tuple[int, ...], float] = {}
    for k in np.argsort(first):
        place, radius = tuple(hole[first[k]]), float(helix[first[k]] * _APART)
        if place in last:
            outer, inner = last[place] + tool.radius, max(last[place] - tool.radius, 0.0)
            in_ring = _common_area(tool.radius, outer, radius) - _common_area(tool.radius, inner, radius)
            part[k] = 1 - in_ring / foot
        last[place] = radius
    beside = np.ones(len(t.run))
    beside[arc] = part[which.ravel()]
    return beside


def _common_area(a: float, b: float, apart: float) -> float:
    """Return the overlap area of two circles with radii `a` and `b`, whose centres have the distance `apart`."""
    if apart >= a + b:
        return 0.0
    if apart <= abs(a - b):
        return np.pi * min(a, b) ** 2
    x = (apart**2 + a**2 - b**2) / (2 * apart)
    return float(a**2 * np.arccos(x / a) + b**2 * np.arccos((apart - x) / b) - apart * np.sqrt(a**2 - x**2))


def _row_families(t: _Trajectories, here: np.ndarray) -> list[np.ndarray]:
    """Return arrays with the trajectories at one height in each frequent direction."""
    bins = np.rint(t.heading[here] / np.pi * 36).astype(np.int64) % 36
    length = np.bincount(bins, t.run[here], minlength=36)
    return [here[bins == b] for b in np.flatnonzero(length > _FAMILY * length.sum())]


def _rows_area(t: _Trajectories, rows: np.ndarray, tool: Tool, stepover: float) -> float:
    """Return the area of parallel rows with round ends, mm^2.

    The first row has the width of the tool, and each further row adds its stepover.
    """
    heading = float(np.angle((t.run[rows] * np.exp(2j * t.heading[rows])).sum()) / 2)
    offset = t.start[rows, 1] * np.cos(heading) - t.start[rows, 0] * np.sin(heading)
    in_order, sorted_ = np.abs(np.diff(offset)), np.diff(np.sort(offset))
    passes = np.count_nonzero(in_order > _APART) + 1
    # If the rows are sorted by position, the rows of several pockets mix. If the rows are in the order of cutting,
    # successive rows can be far apart. Both errors make the computed step too small, so the larger of the two steps is
    # used.
    steps = [s.mean() for s in (x[(x > _APART) & (x <= tool.diameter + _APART)] for x in (in_order, sorted_)) if len(s)]
    step = min(float(max(steps)), tool.diameter) if steps else stepover
    along = float((t.run * t.share)[rows].sum())
    # Area of the tool's circle within the row's own strip, |y| < step / 2.
    ends = step * np.sqrt(tool.radius**2 - step**2 / 4) + 2 * tool.radius**2 * np.arcsin(step / tool.diameter)
    return float(step * along + passes * ends + (tool.diameter - step) * along / passes)


def _grown_hull(points: np.ndarray, radius: float, stock: Solid) -> tuple[float, float]:
    """Return the area of the points' convex hull, enlarged by a radius and clipped to the stock, and its perimeter.

    The perimeter is the perimeter of the hull before it is enlarged.
    """
    angles = 2 * np.pi * np.arange(64) / 64
    normals = np.column_stack((np.cos(angles), np.sin(angles)))
    reach = (points @ normals.T).max(axis=0)
    step = angles[1]
    # Each corner of the hull is the intersection of the support lines k and k + 1. The perimeter is the mean width
    # times pi (Cauchy).
    grown = reach + radius
    along = (np.roll(grown, -1) - grown * np.cos(step)) / np.sin(step)
    tangents = np.column_stack((-normals[:, 1], normals[:, 0]))
    outline = (grown[:, None] * normals + along[:, None] * tangents).tolist()
    for axis in (0, 1):
        outline = clip(outline, axis, 1, float(stock.upper[axis]))
        outline = clip(outline, axis, -1, -float(stock.lower[axis]))
    return polygon_area(outline), float(reach.mean() * 2 * np.pi)


def _recut(t: _Trajectories, tool: Tool, stock: Solid, stepover: float) -> float:
    """Return the area that a ball or a cone cuts, mm^2, including pixels that are cut several times.

    Until the tool's axis has passed a pixel, each trajectory cuts the pixel again, if the tool there is lower than the
    surface that the previous pass has left.
    """
    depth = stock.upper[2] - t.low
    if tool.steepness > 0:
        reach = np.minimum(tool.radius, depth / tool.steepness)
    else:
        reach = np.where(depth < tool.radius, np.sqrt(np.maximum(2 * tool.radius * depth - depth**2, 0)), tool.radius)
    side = np.minimum(reach, stepover / 2)
    y = -side + np.linspace(0, 1, 33)[:, None] * (reach + side)
    ahead = np.sqrt(np.maximum(np.minimum(reach, np.abs(y + stepover)) ** 2 - y**2, 0))
    front = (ahead[:-1] + ahead[1:]).sum(axis=0) / 2 * (reach + side) / 32
    steep = np.sin(np.arctan2(t.rise, np.maximum(t.run, 1e-9)))
    new = np.maximum(1 - steep, 0) * front + (reach + side) * t.run
    return float((new * t.share).sum())


def _walls(t: _Trajectories, tool: Tool, stock: Solid, stepover: float, azimuth: float) -> float:
    """Return the area of the walls that the trajectories cut, as seen from the side, mm^2."""
    key = np.rint(t.low / _LEVEL).astype(np.int64)
    levels, which = np.unique(key, return_inverse=True)
    ceiling = np.append(levels[1:] * _LEVEL, stock.upper[2])
    depth = (ceiling - levels * _LEVEL)[which.ravel()]
    engaged = np.arccos(1 - stepover / tool.radius)
    front = tool.radius * engaged * 2 / np.pi
    seen = depth * (front + t.run * np.abs(np.sin(t.heading - azimuth)))
    return float((seen * t.share).sum())
