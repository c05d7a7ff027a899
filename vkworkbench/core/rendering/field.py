# SPDX-License-Identifier: LGPL-2.1-or-later
"""Represent the simulated part as columns of material along the tool axis, which can be drawn from any direction.

Each vertical ray has one column of material, from the cut surface down to the lower end of the stock, because tools
remove material from the top. Only if the stock has undercuts can a ray have several columns. The first columns of all
rays form one layer, the second columns form the next layer, and so on.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from vkworkbench.core.rendering.shading import EMPTY, STEEPEST, shadow, slope
from vkworkbench.core.rendering.thin_cuts import ThinCuts, thin_cuts
from vkworkbench.core.zbuffer import STOCK, ZBuffer

# Offsets along x and y from the cell of a wall to the surrounding cells whose heights give the direction of the wall.
_AROUND = [(x, y) for x in range(-4, 5) for y in range(-4, 5) if 0 < x * x + y * y <= 17]


class Section(NamedTuple):
    """A plane through which the part is cut open in the picture.

    Attributes
    ----------
    axis : int
        Axis perpendicular to the plane: 0 for X, 1 for Y, 2 for Z.
    place : float
        Coordinate of the plane, mm.
    hides_above : bool
        If True, material whose coordinate is greater than `place` is hidden. If `hides_above` is False,
        material whose coordinate is smaller is hidden.
    """

    axis: int
    place: float
    hides_above: bool


@dataclass(frozen=True, eq=False)
class Layer:
    """A field's layer, with at most one column of material in each cell; a border of empty cells surrounds the layer."""

    # top, bottom (rows + 2, columns + 2) float32: heights of the upper and lower end of each column above the centre of
    # the stock, mm; `EMPTY` and ``-EMPTY`` in an empty cell.
    top: np.ndarray
    bottom: np.ndarray
    # (rows + 2, columns + 2) int32: trajectory that cut the top of each column; `STOCK` for a top that belongs to the
    # raw stock.
    owner: np.ndarray
    cell: float  # side of a cell, mm
    is_part: bool  # true if the columns belong to the part, False if they are chips
    # (rows + 2, columns + 2) bool: whether the cut face made by the plane of a `Section` is visible at each cell, on
    # the cell's own top or on the wall behind the cell.
    cut: np.ndarray | None = None

    @cached_property
    def upside_down(self) -> Layer:
        """The layer turned upside down, for views from below. The part's lower surface is treated as raw stock."""
        owner = np.full_like(self.owner, STOCK) if self.is_part else self.owner
        turned = Layer(-self.bottom, -self.top, owner, self.cell, self.is_part, self.cut)
        vars(turned)["upside_down"] = self
        return turned

    @cached_property
    def is_even(self) -> bool:
        """Whether the lower ends of all columns are at the same height."""
        ends = self.bottom[self.bottom < -EMPTY]
        return not len(ends) or float(np.ptp(ends)) < 1e-3 * self.cell

    @cached_property
    def extent(self) -> tuple[float, float]:
        """Lowest bottom and highest top of all columns, mm; (0, 0) if all cells are empty."""
        low, high = float(self.bottom.min()), float(self.top.max())
        return (low, high) if low <= high else (0.0, 0.0)

    @cached_property
    def normals(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Normals of the tops, as x, y and z of unit vectors.

        At a step in height, the smaller of a cell's two slopes is used.
        """
        x, y = slope(self.top, self.cell, 1), slope(self.top, self.cell, 0)
        upright = 1 / np.sqrt(1 + x * x + y * y)
        return -x * upright, -y * upright, upright

    @cached_property
    def shadow(self) -> np.ndarray:
        """Share of the light that reaches each top, less if higher material is around; 1 in empty cells."""
        result = shadow(np.maximum(self.top, self.extent[0]), self.cell)
        result[self.top <= EMPTY] = 1
        return result

    def wall_normals(self, cell: np.ndarray) -> np.ndarray:
        """Return the horizontal normals of the walls below the tops of cells (k,), pointing away from the material.

        The result (2, k) float32 has x and y of unit vectors; 0 for the walls of a pin, or of a rib between two slots,
        which face several directions.
        """
        known = self._wall_normals
        unknown = np.zeros(self.top.size, bool)
        unknown[cell[np.isnan(known[0][cell])]] = True
        walls = np.flatnonzero(unknown)
        if len(walls):
            top, width = self.top.ravel(), self.top.shape[1]
            height, step = top[walls], STEEPEST * np.float32(self.cell)
            normal = np.zeros((2, len(walls)), np.float32)
            for x, y in _AROUND:
                lower = np.clip(height - top.take(walls + (y * width + x), mode="clip"), 0, step)
                normal[0] += lower * np.float32(x / np.hypot(x, y))
                normal[1] += lower * np.float32(y / np.hypot(x, y))
            length = np.hypot(*normal)
            length[length < 1e-3 * step] = np.inf
            known[:, walls] = normal / length
        return known[:, cell]

    @cached_property
    def _wall_normals(self) -> np.ndarray:
        """Cache of the walls' normals by cell, (2, cells) float32; NaN if the normal is not computed yet."""
        return np.full((2, self.top.size), np.nan, np.float32)


class Field:
    """The columns of a simulated part, or of chips, after a given number of trajectories.

    Parameters
    ----------
    zbuffer : ZBuffer
        The simulation from above, at the moment to show.
    chips : tuple of int, optional
        If given, the field also contains the material (chips) that the trajectories from chips[0] to chips[1] - 1
        remove.
    part : bool
        Whether the part is shown.
    section : Section, optional
        Plane on one side of which all material is hidden.

    Attributes
    ----------
    frame : Frame
        Frame of the z-buffer.
    layers : list of Layer
        The layers of the part, followed by the layer of the chips.
    """

    def __init__(
        self,
        zbuffer: ZBuffer,
        chips: tuple[int, int] | None = None,
        part: bool = True,
        section: Section | None = None,
    ) -> None:
        self.frame, self._zbuffer = zbuffer.frame, zbuffer
        self.layers: list[Layer] = []
        if part:
            self.layers += [self._layer(*columns, is_part=True) for columns in _columns_of_part(zbuffer)]
        if chips is not None:
            self.layers.append(self._layer(*zbuffer.chips(*chips), is_part=False))
        if section is not None:
            self.layers = [self._cut(layer, section) for layer in self.layers]

    def owner_of_wall(self, cell: np.ndarray, height: np.ndarray) -> np.ndarray:
        """Return, for points on walls, the trajectories that removed the material in front of the wall, (k,) int32.

        Parameters
        ----------
        cell : (k,) int
            Index, in the flattened arrays of a layer of columns, of the cell in front of the wall.
        height : (k,) float32
            Height of each point on its wall above the centre of the stock, mm.
        """
        found, pixel = np.full(len(cell), STOCK, np.int32), self._pixel_of_cell[cell]
        inside = np.flatnonzero(pixel >= 0)
        found[inside] = self._zbuffer.removers(pixel[inside], -height[inside])
        return found

    def is_raw_wall(self, cell: np.ndarray, height: np.ndarray) -> np.ndarray:
        """Return whether walls belong to the raw stock, (k,) bool, in a field with one layer; see `owner_of_wall`."""
        pixel, records = self._pixel_of_cell[cell], self._zbuffer.records
        return ~((-height > records.entry[pixel]) & (-height <= records.ends[pixel])) | (pixel < 0)

    @cached_property
    def thin_cuts(self) -> ThinCuts | None:
        """The cuts in the part that are too narrow for the rays of the simulation; None if only chips are shown."""
        part = self.layers[0]
        return thin_cuts(self._zbuffer, part.top[1:-1, 1:-1]) if part.is_part else None

    @cached_property
    def _pixel_of_cell(self) -> np.ndarray:
        """The z-buffer's pixel at each cell of a layer of columns, (cells,) int64; -1 for border cells."""
        return self._in_border(np.arange(self.frame.width * self.frame.height), -1).ravel()

    def _cut(self, layer: Layer, section: Section) -> Layer:
        """Return a layer of columns without the material that the plane of a section hides."""
        place = section.place - float(self.frame.centre[section.axis])
        if section.axis == 2:
            beyond, kept = (layer.top, layer.bottom) if section.hides_above else (-layer.bottom, -layer.top)
            height = np.float32(place if section.hides_above else -place)
            cut = (beyond > height) & (kept < height)
            beyond, hidden = np.where(cut, height, beyond), kept >= height
            top, bottom = (beyond, kept) if section.hides_above else (-kept, -beyond)
        else:
            count = layer.top.shape[1 - section.axis]
            centres = (np.arange(count) + 0.5 - count / 2) * layer.cell
            hidden = centres > place if section.hides_above else centres < place
            hidden = np.broadcast_to(hidden if section.axis == 0 else hidden[:, None], layer.top.shape)
            top, bottom, cut = layer.top, layer.bottom, hidden
        top = np.where(hidden, np.float32(EMPTY), top)
        return replace(layer, top=top, bottom=np.where(hidden, np.float32(-EMPTY), bottom), cut=cut)

    def _layer(self, near: np.ndarray, far: np.ndarray, owner: np.ndarray, is_part: bool) -> Layer:
        """Return a layer of columns from `near` to `far` (pixels,), which are NaN on rays without a column."""
        return Layer(self._in_border(-near, EMPTY), self._in_border(-far, -EMPTY), self._in_border(owner, STOCK),
                     self.frame.pixel, is_part)  # fmt: skip

    def _in_border(self, values: np.ndarray, outside: float) -> np.ndarray:
        bordered = np.full((self.frame.height + 2, self.frame.width + 2), outside, values.dtype)
        inner = bordered[1:-1, 1:-1]
        inner[...] = values.reshape(inner.shape)
        if values.dtype.kind == "f":
            inner[np.isnan(inner)] = outside
        return bordered


def _columns_of_part(zbuffer: ZBuffer) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Yield near ends, far ends and trajectories of all rays' first columns, then of the second columns, and so on."""
    picture, records = zbuffer.picture, zbuffer.records
    if not records.has_gaps:
        yield picture.depth, np.where(np.isnan(picture.depth), np.float32(np.nan), records.ends), picture.owner
        return
    dexels = zbuffer.dexel_records
    pixel = dexels["pixel"].astype(np.int64)
    order = np.arange(len(pixel)) - np.searchsorted(pixel, pixel)  # number of each dexel on its ray, from 0
    for number in range(int(order.max(initial=0)) + 1):
        own = order == number
        near, far = np.full((2, len(picture.depth)), np.nan, np.float32)
        near[pixel[own]], far[pixel[own]] = dexels["near"][own], dexels["far"][own]
        # Only the highest column of a ray can have been cut, because tools remove material from the top.
        cut = near == picture.depth
        yield near, far, np.where(cut, picture.owner, np.int32(STOCK))
