# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the tool into a picture, as a shaded solid with flutes, shank and holder, hidden where the part is in front."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from vkworkbench.core.rendering.camera import project
from vkworkbench.core.rendering.scene import Scene
from vkworkbench.core.rendering.shading import LIGHT, light
from vkworkbench.core.tool import Tool
from vkworkbench.core.view import Frame

# _FLUTES, _SHANK: drawn lengths of flutes and shank if their lengths are unknown, in tool diameters. _RINGS: number of
# rings with which a rounded tip is drawn.
_FLUTES, _SHANK, _RINGS = 3.0, 2.0, 7
# Colours and opacities of cutter, shank and holder. The holder is translucent, so that the part behind it stays
# visible.
_CUTTER, _SHAFT, _HOLDER = ((236, 196, 92), 0.9), ((176, 182, 192), 0.9), ((112, 120, 138), 0.5)
# _NUMBER: number of drawn flutes. _PITCH: pitch of the flutes, in tool diameters. _SHARE: share of the cutter's surface
# that flutes cover. _DARKER: share of the light that flutes lose.
_NUMBER, _PITCH, _SHARE, _DARKER = 3, 3.0, 0.35, 0.35


class _Ring(NamedTuple):
    """A circle around the axis of the tool, given by its radius and its height above the tip, mm."""

    radius: float
    height: float


class _Hits(NamedTuple):
    """Points where the rays of pixels hit a part of the tool.

    The arrays `column`, `row` and `depth` are (k,). `normal`, and `place` relative to the tip, are (k, 3).
    """

    column: np.ndarray
    row: np.ndarray
    depth: np.ndarray
    normal: np.ndarray
    place: np.ndarray


def draw_tool(scene: Scene, tool: Tool, tip: np.ndarray, frame: Frame) -> None:
    """Draw a tool into a picture.

    Parameters
    ----------
    scene : Scene
        The function changes the scene's pixels.
    tool : Tool
    tip : (3,) array_like
        Position of the tip, mm.
    frame : Frame
        Frame of the picture.
    """
    towards = LIGHT @ np.array([frame.right, frame.up, -frame.direction])
    nearest = np.where(np.isnan(scene.depth), np.float32(np.inf), scene.depth)
    part = scene.pixels.copy()
    for one, other, (color, opacity), is_fluted in _pieces(tool):
        hits = _meet(one, other, np.asarray(tip, float), frame)
        near = hits.depth < nearest[hits.row, hits.column]
        column, row, depth, normal, place = (values[near] for values in hits)
        nearest[row, column] = depth
        brightness = light((normal[:, 0], normal[:, 1], normal[:, 2]), towards)
        if is_fluted:
            turns = _NUMBER * (
                np.arctan2(place[:, 1], place[:, 0]) / (2 * np.pi) + place[:, 2] / (_PITCH * tool.diameter)
            )
            brightness *= 1 - _DARKER * (turns % 1 < _SHARE)
        top_row = frame.height - 1 - row
        behind = part[top_row, column]
        mixed = np.full(len(row), 0xFF, np.uint32)
        for channel, shift in zip(color, (16, 8, 0)):
            under = (behind >> np.uint32(shift)) & np.uint32(0xFF)
            shown = opacity * np.minimum(channel * brightness, 255) + (1 - opacity) * under
            mixed = mixed << np.uint32(8) | shown.astype(np.uint32)
        scene.pixels[top_row, column] = mixed


def _pieces(tool: Tool) -> Iterator[tuple[_Ring, _Ring, tuple[tuple[int, int, int], float], bool]]:
    """Yield each piece of the tool's surface: circles at both ends, colour and opacity, whether it has flutes."""
    share = np.sin(np.linspace(0, np.pi / 2, _RINGS)) if tool.rounding else np.array([0.0, 1.0])
    radii = np.union1d(tool.radius * share, (tool.tip, tool.radius - tool.rounding))
    rings = [_Ring(*pair) for pair in zip(radii.tolist(), tool.height(radii).tolist())]
    end = max(tool.cutting_edge_height or tool.rim + _FLUTES * tool.diameter, tool.rim)
    rings.append(_Ring(tool.radius, end))
    kinds = [_CUTTER] * (len(rings) - 1)
    shank = (tool.shank_diameter or tool.diameter) / 2
    top = max(tool.length or end + _SHANK * tool.diameter, end)
    rings += [_Ring(shank, end), _Ring(shank, top)]
    kinds += [_SHAFT] * 2
    if tool.holder_diameter and tool.holder_length:
        rings += [_Ring(tool.holder_diameter / 2, top), _Ring(tool.holder_diameter / 2, top + tool.holder_length)]
        kinds += [_HOLDER] * 2
    rings.append(_Ring(0.0, rings[-1].height))
    kinds.append(kinds[-1])
    for one, other, kind in zip(rings, rings[1:], kinds):
        if one != other:
            yield one, other, kind, kind is _CUTTER


def _meet(one: _Ring, other: _Ring, tip: np.ndarray, frame: Frame) -> _Hits:
    """Return where rays hit the cone between two circles, or the disc if both circles have the same height."""
    column, row = _around(one, other, tip, frame)
    origin = frame.origins(*frame.pixel_centres(column, row)) - tip
    direction = frame.direction
    depths: list[np.ndarray] = []
    if one.height == other.height:
        slope, bounds = np.inf, sorted((one.radius, other.radius))
        if direction[2]:  # rays perpendicular to the axis see the disc edge-on
            depths = [(one.height - origin[:, 2]) / direction[2]]
    else:
        slope, bounds = (other.radius - one.radius) / (other.height - one.height), sorted((one.height, other.height))
        radius = one.radius + slope * (origin[:, 2] - one.height)
        a = direction[:2] @ direction[:2] - (slope * direction[2]) ** 2
        b = origin[:, :2] @ direction[:2] - slope * direction[2] * radius
        c = (origin[:, :2] ** 2).sum(axis=1) - radius**2
        if a:  # if the coefficient a is 0, the rays are parallel to a straight line on the surface
            root = np.sqrt(np.where(b * b < a * c, np.nan, b * b - a * c))
            depths = [(-b - root) / a, (-b + root) / a]
    best = np.full(len(column), np.inf)
    for depth in depths:
        place = origin + depth[:, None] * direction
        within = np.hypot(place[:, 0], place[:, 1]) if np.isinf(slope) else place[:, 2]
        best = np.where((within >= bounds[0]) & (within <= bounds[1]) & (depth < best), depth, best)
    hit = np.flatnonzero(np.isfinite(best))
    depth, place = best[hit], origin[hit] + best[hit, None] * direction
    normal = np.zeros_like(place)
    if np.isinf(slope):
        normal[:, 2] = -np.sign(direction[2])
    else:
        normal[:, :2] = place[:, :2] / np.maximum(np.hypot(place[:, 0], place[:, 1]), 1e-9)[:, None]
        normal[:, 2] = -slope
        normal /= np.hypot(1, slope)
    return _Hits(column[hit], row[hit], depth.astype(np.float32), normal.astype(np.float32), place)


def _around(one: _Ring, other: _Ring, tip: np.ndarray, frame: Frame) -> tuple[np.ndarray, np.ndarray]:
    """Return columns and rows, row 0 at the bottom, of the pixels in the rectangle around two circles of the tool."""
    centres = project(tip + np.array([(0, 0, one.height), (0, 0, other.height)]), frame)[:, :2]
    reach = np.array([one.radius, other.radius])[:, None] / frame.pixel * (1, abs(frame.direction[2]))
    low, high = (centres - reach).min(axis=0), (centres + reach).max(axis=0)
    size = np.array([frame.width, frame.height])
    first, end = np.clip(np.floor(low), 0, size).astype(int), np.clip(np.ceil(high) + 1, 0, size).astype(int)
    row, column = np.mgrid[first[1] : end[1], first[0] : end[0]]
    return column.ravel(), frame.height - 1 - row.ravel()
