# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a field from any direction: light, colours by owner or by cell, edges, and highlights."""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce
from typing import NamedTuple

import numpy as np

from vkworkbench.core.rendering.field import EMPTY, Field, Layer
from vkworkbench.core.rendering.oblique import Walls, look
from vkworkbench.core.rendering.palettes import CUT, colors_of, palette
from vkworkbench.core.rendering.shading import BACKGROUND, EDGE, LIGHT, STEEPEST, light
from vkworkbench.core.view import Frame

# Colour of highlighted surfaces.
LIT = np.array((255, 170, 40), np.uint8)
# Cells around the top of a wall that determine its direction: offsets along x and y.
_AROUND = [(x, y) for x in range(-4, 5) for y in range(-4, 5) if 0 < x * x + y * y <= 17]
# Difference in depth between neighbouring pixels that is an edge, in pixels.
_JUMP = 8.0


@dataclass(frozen=True, eq=False)
class Scene:
    """A picture of a simulation.

    Attributes
    ----------
    depth : (height, width) float32
        mm, row 0 below; NaN where the image is empty.
    owner : (height, width) int32
        Trajectory that made the visible surface, or that cuts the visible chip; -1 for the raw stock.
    image : (height, width, 3) uint8
        Row 0 at the top.
    """

    depth: np.ndarray
    owner: np.ndarray
    image: np.ndarray


def scene(
    field: Field,
    frame: Frame,
    colors: np.ndarray,
    *,
    lit: tuple[int, int] | None = None,
    background: tuple[int, int, int] = BACKGROUND,
) -> Scene:
    """Return the picture of a field.

    Parameters
    ----------
    field : Field
    frame : Frame
        Frame of the picture, with any direction, pixel and centre.
    colors : (n + 1, 3) or (2, 3), or (rows, columns, 3) uint8
        Colours by owner, see `palette`; or the colour of every cell of the part from above, row 0 below.
    lit : tuple of int, optional
        Highlight the surfaces of the trajectories lit[0] .. lit[1] - 1.
    background : tuple of int
        Colour of empty pixels.
    """
    drawn = reduce(_nearest, (_draw(field, layer, frame, colors) for layer in field.layers))
    depth, owner, shown, brightness = drawn
    if lit is not None:
        shown[(owner >= lit[0]) & (owner < lit[1])] = LIT
    brightness[_edges(depth, frame.pixel)] *= 1 - EDGE
    empty, down = np.isnan(depth), frame.direction[2] <= 0
    image = np.empty((frame.height, frame.width, 3), np.uint8)
    for channel in range(3):
        bright = np.minimum(shown[..., channel] * brightness, 255).astype(np.uint8)
        bright[empty] = background[channel]
        image[..., channel] = bright.T[::-1] if down else bright.T
    upwards = slice(None, None, 1 if down else -1)
    return Scene(depth.T[upwards], owner.T[upwards], image)


class _Drawn(NamedTuple):
    """Depth, owner, colour and brightness of the surface in each pixel, (width, height); see `Seen`."""

    depth: np.ndarray
    owner: np.ndarray
    shown: np.ndarray
    brightness: np.ndarray


def _draw(field: Field, layer: Layer, frame: Frame, colors: np.ndarray) -> _Drawn:
    """Return what a layer alone shows."""
    below = frame.direction[2] > 0
    layer, towards = layer.upside_down if below else layer, _light_of(frame)
    seen = look(layer, field.frame, frame)
    owner = layer.owner.ravel().take(seen.cell)
    brightness = _light_tops(layer, towards).take(seen.cell)
    walls, steep = seen.walls, []
    if not layer.is_even:
        # Below the end of the column in front, a pixel sees the lower end of its column.
        below_front = walls.height < layer.bottom.ravel().take(walls.front)
        below_front &= layer.top.ravel().take(walls.front) > EMPTY
        lower, towards_lower = walls.chosen(below_front), towards * (1, 1, -1)
        under, walls = layer.upside_down, walls.chosen(~below_front)
        owner.ravel()[lower.pixel] = under.owner.ravel().take(lower.cell)
        brightness.ravel()[lower.pixel] = _light_tops(under, towards_lower).take(lower.cell)
        steep = [_paint_walls(under, lower, frame, towards_lower, brightness)]
    steep.append(_paint_walls(layer, walls, frame, towards, brightness))
    for those in steep if layer.is_part else ():
        owner.ravel()[those.pixel] = field.owner_of_wall(those.front, -those.height if below else those.height)
    if colors.ndim == 3 and layer.is_part and not below:
        return _Drawn(seen.depth, owner, _in_border(colors).take(seen.cell, axis=0), brightness)
    return _Drawn(seen.depth, owner, colors_of(owner, colors if colors.ndim == 2 else palette(CUT)), brightness)


def _light_tops(layer: Layer, towards: np.ndarray) -> np.ndarray:
    """Return the brightness of the top of each cell, (cells,) float32."""
    slope_x, slope_y = layer.slopes
    upright = 1 / np.sqrt(1 + slope_x * slope_x + slope_y * slope_y)
    brightness = light((-slope_x * upright, -slope_y * upright, upright), towards)
    brightness *= layer.shadow
    return brightness.ravel()


def _paint_walls(layer: Layer, walls: Walls, frame: Frame, towards: np.ndarray, brightness: np.ndarray) -> Walls:
    """Light the walls that are steeper than a slope, and return them."""
    top, shadow = layer.top.ravel(), layer.shadow.ravel()
    steep = walls.chosen(top.take(walls.cell) - top.take(walls.front) > STEEPEST * layer.cell)
    lit = light((*_wall_normals(layer, steep.cell, frame), np.zeros(1, np.float32)), towards)
    brightness.ravel()[steep.pixel] = lit * np.sqrt(shadow.take(steep.front) * shadow.take(steep.cell))
    return steep


def _nearest(one: _Drawn, other: _Drawn) -> _Drawn:
    """Return the nearer of two surfaces in each pixel."""
    nearer = (other.depth < one.depth) | np.isnan(one.depth)
    for mine, its in zip(one, other):
        mine[nearer] = its[nearer]
    return one


def _light_of(frame: Frame) -> np.ndarray:
    """Return the direction to the light in the coordinates of a layer, which is upside down in views from below."""
    mirror = np.array([1.0, 1.0, -1.0 if frame.direction[2] > 0 else 1.0])
    towards: np.ndarray = mirror * (LIGHT @ np.array([frame.right, frame.up, -frame.direction]))
    return towards


def _wall_normals(layer: Layer, cell: np.ndarray, frame: Frame) -> tuple[np.ndarray, np.ndarray]:
    """Return the level normals of walls, (k,) float32 each: away from the material around the top of the wall."""
    top, width = layer.top.ravel(), layer.top.shape[1]
    is_wall = np.zeros(len(top), bool)
    is_wall[cell] = True
    walls = np.flatnonzero(is_wall)
    height, step = top[walls], STEEPEST * np.float32(layer.cell)
    normal = np.zeros((2, len(walls)), np.float32)
    for x, y in _AROUND:
        lower = np.clip(height - top.take(walls + (y * width + x), mode="clip"), 0, step)
        normal[0] += lower * np.float32(x / np.hypot(x, y))
        normal[1] += lower * np.float32(y / np.hypot(x, y))
    length = np.hypot(*normal)
    lone = length < 1e-3 * step  # a pin, or a wall between two slots: as if it faced the eye
    normal[:, lone] = np.array([[frame.right[1]], [-frame.right[0]]])
    normal[:, ~lone] /= length[~lone]
    of_cell = np.zeros((2, len(top)), np.float32)
    of_cell[:, walls] = normal
    return of_cell[0].take(cell), of_cell[1].take(cell)


def _in_border(colors: np.ndarray) -> np.ndarray:
    """Return the colours of a layer's cells (cells, 3) from the colours of the field (rows, columns, 3)."""
    return np.pad(colors, [(1, 1), (1, 1), (0, 0)]).reshape(-1, 3)


def _edges(depth: np.ndarray, pixel: float) -> np.ndarray:
    """Return the pixels in front of a jump in depth."""
    edges, jump = np.zeros(depth.shape, bool), np.float32(_JUMP * pixel)
    for one, other, mark, beyond in (
        (depth[:-1], depth[1:], edges[:-1], edges[1:]), (depth[:, :-1], depth[:, 1:], edges[:, :-1], edges[:, 1:]),
    ):  # fmt: skip
        step = other - one
        mark |= step > jump
        beyond |= step < -jump
    return edges
