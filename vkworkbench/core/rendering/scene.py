# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw a field from any direction, with light, colours by owner or by cell, edges, and highlights."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from typing import NamedTuple

import numpy as np

from vkworkbench.core.rendering.field import Field, Layer
from vkworkbench.core.rendering.oblique import Walls, look
from vkworkbench.core.rendering.palettes import CUT, palette
from vkworkbench.core.rendering.shading import BACKGROUND, EDGE, EMPTY, LIGHT, STEEPEST, light
from vkworkbench.core.view import Frame
from vkworkbench.core.zbuffer import STOCK

# Colour of the cut face of a section, and the number that stands for its owner instead of a trajectory.
SECTION, CUT_OPEN = np.array((206, 128, 96), np.uint8), -2
# Colour of highlighted surfaces.
LIT = np.array((255, 170, 40), np.uint8)
# Difference in depth between neighbouring pixels above which a dark edge is drawn, in sides of a pixel. Lower: steep
# slopes get edges. Higher: small steps of the part get none.
_JUMP = 8.0


@dataclass(frozen=True, eq=False)
class Scene:
    """A picture of a simulation.

    Attributes
    ----------
    depth : (height, width) float32
        mm, row 0 below; NaN where the image is empty.
    owner : (height, width) int32
        Trajectory that made the visible surface, or that cuts the visible chip. -1: raw stock. `CUT_OPEN`: the cut face
        of a section.
    pixels : (height, width) uint32
        Colours as 0xffRRGGBB, row 0 at the top.
    """

    depth: np.ndarray
    owner: np.ndarray
    pixels: np.ndarray

    @property
    def image(self) -> np.ndarray:
        """The colours, (height, width, 3) uint8, row 0 at the top."""
        result: np.ndarray = (self.pixels[..., None] >> np.array((16, 8, 0), np.uint32)).astype(np.uint8)
        return result

    def averaged(self, factor: int) -> Scene:
        """Return a smaller picture, in which each colour is the mean of `factor` times `factor` pixels."""
        height, width = (side // factor for side in self.pixels.shape)
        parts = np.ascontiguousarray(self.pixels).view(np.uint8).reshape(height, factor, width, factor, 4)
        total = np.zeros((height, width, 4), np.uint16)
        for row in range(factor):
            for column in range(factor):
                total += parts[:, row, :, column]
        total //= factor**2
        every = slice(None, None, factor)
        pixels = total.astype(np.uint8).view(np.uint32).reshape(height, width)
        return Scene(self.depth[every, every], self.owner[every, every], pixels)


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
        Frame of the picture. It may have any direction, pixel size and centre.
    colors : (n + 1, 3) or (2, 3), or (rows, columns, 3) uint8
        Colours by owner, see `palette`; or the colour of every cell of the part as seen from above, row 0 at the
        bottom.
    lit : tuple of int, optional
        Highlight the surfaces that the trajectories lit[0] .. lit[1] - 1 have made.
    background : tuple of int
        Colour of empty pixels.
    """
    drawn = reduce(_nearest, (_draw(field, layer, frame, colors) for layer in field.layers))
    size = frame.height, frame.width
    depth, owner = np.full(size, np.nan, np.float32), np.full(size, STOCK, np.int32)
    depth.ravel()[drawn.pixel], owner.ravel()[drawn.pixel] = drawn.depth, drawn.owner
    channels = drawn.red, drawn.green, drawn.blue
    if lit is not None:
        is_lit = np.flatnonzero((drawn.owner >= lit[0]) & (drawn.owner < lit[1]))
        for channel, value in zip(channels, LIT):
            channel[is_lit] = value
    drawn.brightness[_edges(depth, frame.pixel).ravel()[drawn.pixel]] *= 1 - EDGE
    pixels = np.full(size, _packed([np.array(part) for part in background]), np.uint32)
    pixels.ravel()[drawn.pixel] = _packed([np.minimum(channel * drawn.brightness, 255) for channel in channels])
    upwards = slice(None, None, 1 if frame.direction[2] <= 0 else -1)
    return Scene(depth[upwards], owner[upwards], pixels[upwards][::-1])


def _packed(channels: Sequence[np.ndarray]) -> np.ndarray:
    """Return colours as 0xffRRGGBB."""
    packed = np.asarray(0xFF, np.uint32)
    for channel in channels:
        packed = packed << np.uint32(8) | channel.astype(np.uint32)
    return packed


class _Drawn(NamedTuple):
    """Pixels that see a surface, as in `Seen`, with the surface's owner, brightness and colour, (k,) each."""

    pixel: np.ndarray
    depth: np.ndarray
    owner: np.ndarray
    brightness: np.ndarray
    red: np.ndarray
    green: np.ndarray
    blue: np.ndarray


def _draw(field: Field, layer: Layer, frame: Frame, colors: np.ndarray) -> _Drawn:
    """Return the picture of one layer."""
    below = frame.direction[2] > 0
    layer, towards = layer.upside_down if below else layer, _light_of(frame)
    seen = look(layer, field.frame, frame)
    owner = layer.owner.ravel()[seen.cell]
    brightness = _light_tops(layer, seen.cell, towards)
    walls, steep = seen.walls, []
    if not layer.is_even:
        # A pixel that looks under the lower end of the column in front sees the lower face of its own column.
        below_front = walls.height < layer.bottom.ravel()[walls.front]
        below_front &= layer.top.ravel()[walls.front] > EMPTY
        lower, towards_lower = walls.chosen(below_front), towards * (1, 1, -1)
        under, walls = layer.upside_down, walls.chosen(~below_front)
        owner[lower.number] = under.owner.ravel()[lower.cell]
        brightness[lower.number] = _light_tops(under, lower.cell, towards_lower)
        steep = [_paint_walls(under, lower, frame, towards_lower, brightness)]
    steep.append(_paint_walls(layer, walls, frame, towards, brightness))
    for those in steep if layer.is_part else ():
        owner[those.number] = field.owner_of_wall(those.front, -those.height if below else those.height)
    number = owner + np.int64(1)
    if colors.ndim == 3 and layer.is_part and not below:
        number, colors = seen.cell, _in_border(colors)
    elif colors.ndim == 3 or len(colors) == 2:  # all trajectories have one colour
        np.minimum(number, 1, out=number)
        colors = palette(CUT) if colors.ndim == 3 else colors
    channels = [channel[number] for channel in colors.T.astype(np.float32)]
    if layer.cut is not None:
        is_face = layer.cut.ravel()[seen.cell]
        is_face[seen.walls.number] = layer.cut.ravel()[seen.walls.front]
        owner[is_face] = CUT_OPEN
        for channel, value in zip(channels, SECTION):
            channel[is_face] = value
    return _Drawn(seen.pixel, seen.depth, owner, brightness, *channels)


def _light_tops(layer: Layer, cell: np.ndarray, towards: np.ndarray) -> np.ndarray:
    """Return the brightness of the tops of cells, (k,) float32."""
    slope_x, slope_y = (slopes.ravel()[cell] for slopes in layer.slopes)
    upright = 1 / np.sqrt(1 + slope_x * slope_x + slope_y * slope_y)
    brightness = light((-slope_x * upright, -slope_y * upright, upright), towards)
    brightness *= layer.shadow.ravel()[cell]
    return brightness


def _paint_walls(layer: Layer, walls: Walls, frame: Frame, towards: np.ndarray, brightness: np.ndarray) -> Walls:
    """Light the walls with a slope above `STEEPEST`, and return these walls."""
    top, shadow = layer.top.ravel(), layer.shadow.ravel()
    steep = walls.chosen(top[walls.cell] - top[walls.front] > STEEPEST * layer.cell)
    x, y = layer.wall_normals(steep.cell)
    lone = (x == 0) & (y == 0)  # walls without a direction are lit as if they faced the eye
    x[lone], y[lone] = frame.right[1], -frame.right[0]
    lit = light((x, y, np.zeros(1, np.float32)), towards)
    brightness[steep.number] = lit * np.sqrt(shadow[steep.front] * shadow[steep.cell])
    return steep


def _nearest(one: _Drawn, other: _Drawn) -> _Drawn:
    """Return the surface nearer to the eye in each pixel."""
    depth = np.full(1 + max(drawn.pixel.max(initial=0) for drawn in (one, other)), np.nan, np.float32)
    depth[one.pixel] = one.depth
    its = ~(depth[other.pixel] <= other.depth)
    depth[other.pixel[its]] = np.nan
    mine = ~np.isnan(depth[one.pixel])
    return _Drawn(*(np.concatenate((first[mine], second[its])) for first, second in zip(one, other)))


def _light_of(frame: Frame) -> np.ndarray:
    """Return the direction to the light in a layer's coordinates. In views from below, the layer is upside down."""
    mirror = np.array([1.0, 1.0, -1.0 if frame.direction[2] > 0 else 1.0])
    towards: np.ndarray = mirror * (LIGHT @ np.array([frame.right, frame.up, -frame.direction]))
    return towards


def _in_border(colors: np.ndarray) -> np.ndarray:
    """Return the colours of a layer's cells (cells, 3) from the colours of the field (rows, columns, 3)."""
    return np.pad(colors, [(1, 1), (1, 1), (0, 0)]).reshape(-1, 3)


def _edges(depth: np.ndarray, pixel: float) -> np.ndarray:
    """Return the pixels on the near side of a jump in depth, (height, width) bool."""
    edges, jump = np.zeros(depth.shape, bool), np.float32(_JUMP * pixel)
    for one, other, mark, beyond in (
        (depth[:-1], depth[1:], edges[:-1], edges[1:]), (depth[:, :-1], depth[:, 1:], edges[:, :-1], edges[:, 1:]),
    ):  # fmt: skip
        step = other - one
        mark |= step > jump
        beyond |= step < -jump
    return edges
