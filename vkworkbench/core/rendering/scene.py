# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw a simulated part (a field of columns) from any direction, with light, colours, edges and highlights."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, reduce
from typing import NamedTuple

import numpy as np

from vkworkbench.core.rendering.camera import project
from vkworkbench.core.rendering.field import Field, Layer
from vkworkbench.core.rendering.oblique import Walls, look
from vkworkbench.core.rendering.palettes import CUT, palette
from vkworkbench.core.rendering.shading import BACKGROUND, BRIGHTEST, EDGE, EMPTY, LIGHT, STEEPEST, light
from vkworkbench.core.view import Frame
from vkworkbench.core.zbuffer import STOCK

# SECTION: colour of the cut face where a plane (`Section`) cuts the part open. CUT_OPEN: number that is stored, instead
# of a trajectory, for this cut face, which no trajectory cut.
SECTION, CUT_OPEN = np.array((206, 128, 96), np.uint8), -2
# Colour of highlighted surfaces.
LIT = np.array((255, 170, 40), np.uint8)
# Difference in depth between neighbouring pixels above which a dark edge is drawn, as a multiple of a pixel's side.
# With a smaller value, steep slopes get dark edges. With a larger value, small steps of the part get no edges.
_JUMP = 8.0
# Brightness of the lines that are drawn for cuts narrower than the distance between the simulated rays.
_THIN = 0.65
# A narrow cut is drawn if it is deeper than the visible surface by less than an allowed difference, which grows as the
# view becomes more horizontal. The allowed difference is divided by the sine of the view's elevation, but at least by
# this number.
_FLATTEST = 0.1


@dataclass(frozen=True, eq=False)
class Scene:
    """A picture of a simulation.

    Attributes
    ----------
    depth : (height, width) float32
        Depth of the visible surface, mm, row 0 at the bottom; NaN where the image is empty. In an averaged picture, the
        depths are finer than the colours.
    pixels : (height, width) uint32
        Colours as 0xffRRGGBB, row 0 at the top.
    find_owner : callable
        Function that computes the attribute `owner` at its first use.
    """

    depth: np.ndarray
    pixels: np.ndarray
    find_owner: Callable[[], np.ndarray]

    @cached_property
    def owner(self) -> np.ndarray:
        """Trajectory that cut each visible surface, or that cuts the chip, (height, width) int32, row 0 at the bottom.

        The value is -1 for the raw stock, and `CUT_OPEN` for the cut face of a section. The trajectories are computed
        at the first use, because most pictures are shown without this attribute.
        """
        return self.find_owner()

    @property
    def image(self) -> np.ndarray:
        """The colours, (height, width, 3) uint8, row 0 at the top."""
        return (self.pixels[..., None] >> np.array((16, 8, 0), np.uint32)).astype(np.uint8)

    def averaged(self, factor: int) -> Scene:
        """Return a smaller picture, in which each colour is the mean of `factor` times `factor` pixels.

        Depths and owners keep the resolution of the larger picture, because their mean is meaningless at an edge.
        """
        height, width = (side // factor for side in self.pixels.shape)
        parts = np.ascontiguousarray(self.pixels).view(np.uint8).reshape(height, factor, width, factor, 4)
        total = np.zeros((height, width, 4), np.uint16)
        for row in range(factor):
            for column in range(factor):
                total += parts[:, row, :, column]
        total //= factor**2
        pixels = total.astype(np.uint8).view(np.uint32).reshape(height, width)
        return Scene(self.depth, pixels, lambda: self.owner)


def scene(
    field: Field,
    frame: Frame,
    colors: np.ndarray,
    *,
    lit: tuple[int, int] | None = None,
    background: tuple[int, int, int] = BACKGROUND,
) -> Scene:
    """Return the picture of a field (columns of material).

    Parameters
    ----------
    field : Field
    frame : Frame
        Frame of the picture, with any direction, pixel size and centre.
    colors : (n + 1, 3) or (2, 3), or (rows, columns, 3) uint8
        Either the colours of the trajectories' surfaces, see `palette`; or the colour of every cell of the part as seen
        from above, row 0 at the bottom.
    lit : tuple of int, optional
        If given, the surfaces that the trajectories from lit[0] to lit[1] - 1 have cut are highlighted.
    background : tuple of int
        Colour of empty pixels.
    """
    with_owners = lit is not None or (colors.ndim == 2 and len(colors) > 2) or len(field.layers) > 1
    walls: list[_PartWalls] = []
    drawn = reduce(
        _nearest, (_draw(field, layer, frame, colors, None if with_owners else walls) for layer in field.layers)
    )
    size = frame.height, frame.width
    depth, owner = np.full(size, np.nan, np.float32), np.full(size, STOCK, np.int32)
    depth.ravel()[drawn.pixel], owner.ravel()[drawn.pixel] = drawn.depth, drawn.owner
    if lit is not None:
        drawn.color[(drawn.owner >= lit[0]) & (drawn.owner < lit[1])] = _packed(LIT, BRIGHTEST)
    drawn.brightness[_edges(depth, frame.pixel).ravel()[drawn.pixel]] *= 1 - EDGE
    pixels = np.full(size, _packed(np.array(background)), np.uint32)
    pixels.ravel()[drawn.pixel] = _shaded(drawn.color, drawn.brightness)
    thin = _draw_thin_cuts(field, frame, colors, lit, depth, pixels)
    upwards = slice(None, None, 1 if frame.direction[2] <= 0 else -1)

    def find_owner() -> np.ndarray:
        for part in walls:
            part = part.chosen(owner.ravel()[part.pixel] != CUT_OPEN)
            owner.ravel()[part.pixel] = field.owner_of_wall(part.front, part.height)
        owner[thin.row, thin.column] = thin.owner
        return owner[upwards]

    return Scene(depth[upwards], pixels[upwards][::-1], find_owner)


class _PartWalls(NamedTuple):
    """Pixels that see walls of the part, with the cell in front of each wall and the height of the point, (k,) each."""

    pixel: np.ndarray
    front: np.ndarray
    height: np.ndarray

    def chosen(self, which: np.ndarray) -> _PartWalls:
        return _PartWalls(*(part[which] for part in self))


class _Lines(NamedTuple):
    """Pixels that show narrow cuts, row 0 at the bottom, and the trajectories that cut there, (k,) each."""

    row: np.ndarray
    column: np.ndarray
    owner: np.ndarray


def _draw_thin_cuts(
    field: Field, frame: Frame, colors: np.ndarray, lit: tuple[int, int] | None, depth: np.ndarray, pixels: np.ndarray
) -> _Lines:
    """Draw cuts narrower than the rays' distance as dark lines; in the picture, row 0 is at the bottom.

    The function returns the drawn lines.
    """
    thin = field.thin_cuts if frame.direction[2] < 0 else None
    if thin is None or not len(thin.owner):
        return _Lines(*np.empty((3, 0), np.int64))
    column, row, away = project(thin.points, frame).T
    column, row = np.floor(column).astype(np.int64), frame.height - 1 - np.floor(row).astype(np.int64)
    inside = (column >= 0) & (column < frame.width) & (row >= 0) & (row < frame.height)
    column, row, away, owner = (part[inside] for part in (column, row, away, thin.owner))
    # The depth of a pixel is the depth of the surface at the pixel's centre, which can be beside the point of the
    # narrow cut. Therefore the point is drawn if it is deeper than the pixel's depth by at most `beside`.
    beside = (frame.pixel + field.frame.pixel) / max(-float(frame.direction[2]), _FLATTEST)
    seen = away < depth[row, column] + beside
    column, row, owner = column[seen], row[seen], owner[seen]
    if colors.ndim == 3 or len(colors) == 2:
        color = np.full(len(owner), _packed(palette(CUT)[1] if colors.ndim == 3 else colors[1], BRIGHTEST))
    else:
        color = _packed(colors, BRIGHTEST)[owner + 1]
    if lit is not None:
        color[(owner >= lit[0]) & (owner < lit[1])] = _packed(LIT, BRIGHTEST)
    pixels[row, column] = _shaded(color, np.full(len(owner), _THIN, np.float32))
    return _Lines(row, column, owner)


def _packed(colors: np.ndarray, factor: float = 1.0) -> np.ndarray:
    """Return the colours `colors` (..., 3), multiplied by a factor, as numbers 0xffRRGGBB, (...) uint32."""
    red, green, blue = np.minimum(factor * np.moveaxis(colors, -1, 0), 255).astype(np.uint32)
    return 0xFF000000 | red << np.uint32(16) | green << np.uint32(8) | blue


def _shaded(color: np.ndarray, brightness: np.ndarray) -> np.ndarray:
    """Convert colours 0xffRRGGBB, which have the brightness `BRIGHTEST`, to another brightness.

    Red and blue are multiplied in one operation, because the number has eight free bits above red and above blue.
    """
    share = (brightness * np.float32(256 / BRIGHTEST)).astype(np.uint32)
    green = (color >> np.uint32(8)) & np.uint32(0xFF)
    green *= share
    green &= np.uint32(0xFF00)
    green |= np.uint32(0xFF000000)
    rest = color & np.uint32(0xFF00FF)
    rest *= share
    rest >>= np.uint32(8)
    rest &= np.uint32(0xFF00FF)
    rest |= green
    return rest


class _Drawn(NamedTuple):
    """Pixels that see a surface (see `Seen`), and the surface's trajectory (`owner`), brightness and colour, (k,) each.

    The colour is 0xffRRGGBB at the brightness `BRIGHTEST`.
    """

    pixel: np.ndarray
    depth: np.ndarray
    owner: np.ndarray
    brightness: np.ndarray
    color: np.ndarray


def _draw(field: Field, layer: Layer, frame: Frame, colors: np.ndarray, part_walls: list[_PartWalls] | None) -> _Drawn:
    """Draw one layer (at most one column of material in each cell) of a field.

    If `part_walls` is a list, the walls of the part are appended to it. If `part_walls` is given, the result shows
    whether a wall belongs to the raw stock or was cut, but not which trajectory cut the wall.
    """
    below = frame.direction[2] > 0
    layer, towards = layer.upside_down if below else layer, _light_of(frame)
    seen = look(layer, field.frame, frame)
    owner = layer.owner.ravel()[seen.cell]
    brightness = _light_tops(layer, seen.cell, towards)
    walls, steep = seen.walls, []
    if not layer.is_even:
        # A pixel whose ray passes below the front column meets the lower face of the column behind.
        below_front = walls.height < layer.bottom.ravel()[walls.front]
        below_front &= layer.top.ravel()[walls.front] > EMPTY
        lower, towards_lower = walls.chosen(below_front), towards * (1, 1, -1)
        under, walls = layer.upside_down, walls.chosen(~below_front)
        owner[lower.number] = under.owner.ravel()[lower.cell]
        brightness[lower.number] = _light_tops(under, lower.cell, towards_lower)
        steep = [_paint_walls(under, lower, frame, towards_lower, brightness)]
    steep.append(_paint_walls(layer, walls, frame, towards, brightness))
    for those in steep if layer.is_part else ():
        height = -those.height if below else those.height
        if part_walls is None:
            owner[those.number] = field.owner_of_wall(those.front, height)
        else:
            owner[those.number] = np.where(field.is_raw_wall(those.front, height), STOCK, 0)
            part_walls.append(_PartWalls(seen.pixel[those.number], those.front, height))
    number = owner + np.int64(1)
    if colors.ndim == 3 and layer.is_part and not below:
        number, colors = seen.cell, _in_border(colors)
    elif colors.ndim == 3 or len(colors) == 2:  # all trajectories in the picture have one colour
        np.minimum(number, 1, out=number)
        colors = palette(CUT) if colors.ndim == 3 else colors
    color = _packed(colors, BRIGHTEST)[number]
    if layer.cut is not None:
        is_face = layer.cut.ravel()[seen.cell]
        is_face[seen.walls.number] = layer.cut.ravel()[seen.walls.front]
        owner[is_face] = CUT_OPEN
        color[is_face] = _packed(SECTION, BRIGHTEST)
    return _Drawn(seen.pixel, seen.depth, owner, brightness, color)


def _light_tops(layer: Layer, cell: np.ndarray, towards: np.ndarray) -> np.ndarray:
    """Return the brightness of the tops of the cells `cell`, (k,) float32."""
    brightness = light(layer.normals, towards)
    brightness *= layer.shadow
    return brightness.ravel()[cell]


def _paint_walls(layer: Layer, walls: Walls, frame: Frame, towards: np.ndarray, brightness: np.ndarray) -> Walls:
    """Compute the brightness of the walls with a slope above `STEEPEST`, and return these walls."""
    top, shadow = layer.top.ravel(), layer.shadow.ravel()
    steep = walls.chosen(top[walls.cell] - top[walls.front] > STEEPEST * layer.cell)
    x, y = layer.wall_normals(steep.cell)
    lone = (x == 0) & (y == 0)  # walls that face several directions are lit as if they faced the viewer
    x[lone], y[lone] = frame.right[1], -frame.right[0]
    lit = light((x, y, np.zeros(1, np.float32)), towards)
    brightness[steep.number] = lit * np.sqrt(shadow[steep.front] * shadow[steep.cell])
    return steep


def _nearest(one: _Drawn, other: _Drawn) -> _Drawn:
    """Return, for each pixel, the one of two surfaces that is nearer to the viewer."""
    depth = np.full(1 + max(drawn.pixel.max(initial=0) for drawn in (one, other)), np.nan, np.float32)
    depth[one.pixel] = one.depth
    its = ~(depth[other.pixel] <= other.depth)
    depth[other.pixel[its]] = np.nan
    mine = ~np.isnan(depth[one.pixel])
    return _Drawn(*(np.concatenate((first[mine], second[its])) for first, second in zip(one, other)))


def _light_of(frame: Frame) -> np.ndarray:
    """Return the direction to the light in a layer's coordinates, which are upside down in views from below."""
    mirror = np.array([1.0, 1.0, -1.0 if frame.direction[2] > 0 else 1.0])
    return mirror * (LIGHT @ np.array([frame.right, frame.up, -frame.direction]))


def _in_border(colors: np.ndarray) -> np.ndarray:
    """Return the colours (rows, columns, 3) of a layer with a border of cells around them, flattened (cells, 3)."""
    return np.pad(colors, [(1, 1), (1, 1), (0, 0)]).reshape(-1, 3)


def _edges(depth: np.ndarray, pixel: float) -> np.ndarray:
    """Return whether each pixel is on the nearer side of a large step in depth, (height, width) bool."""
    edges, jump = np.zeros(depth.shape, bool), np.float32(_JUMP * pixel)
    for one, other, mark, beyond in (
        (depth[:-1], depth[1:], edges[:-1], edges[1:]), (depth[:, :-1], depth[:, 1:], edges[:, :-1], edges[:, 1:]),
    ):  # fmt: skip
        step = other - one
        mark |= step > jump
        beyond |= step < -jump
    return edges
