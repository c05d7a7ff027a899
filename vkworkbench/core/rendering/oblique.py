# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the column of material that each pixel of a parallel view sees, by the floating-horizon algorithm.

In parallel projection with the elevation angle e, a point that is 1 mm farther away horizontally appears sin(e) mm
higher on the screen, and a point that is 1 mm higher appears cos(e) mm higher on the screen. For each column of pixels,
the columns of material that can appear there are visited from front to rear. The horizon is the greatest screen height
of the rear edges of the tops visited so far. A pixel of the picture shows the first column of material with which the
horizon reaches the pixel's height. If the pixel is below the front edge of the column's top, it sees the column's wall;
otherwise it sees the top. A second horizon is the smallest screen height of the lower ends of the columns visited so
far.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from vkworkbench.core.rendering.field import Layer
from vkworkbench.core.rendering.shading import EMPTY
from vkworkbench.core.view import Frame

# The tops of columns are invisible if the sine of the view's elevation angle is smaller than this limit. The walls of
# columns are invisible if the cosine of the elevation angle is smaller than this limit.
_LEVEL = 1e-6
_FRACTION = 16  # number of binary digits after the point in fixed-point positions of cells


@dataclass(frozen=True, eq=False)
class Seen:
    """The surfaces that the pixels of an image see. Pixels in which no surface is visible are not included."""

    pixel: np.ndarray  # (k,) int64: indices of the pixels, counted row by row from the lowest row
    cell: np.ndarray  # (k,) int64: cell of the layer that each pixel sees
    depth: np.ndarray  # (k,) float32: depth of the visible point along the view, mm
    walls: Walls  # the pixels that see the wall of a column instead of its top


class Walls(NamedTuple):
    """Pixels that see walls."""

    number: np.ndarray  # (k,) int64: position of each pixel in the arrays of `Seen`
    # cell, front (k,) int64: cell whose wall is visible, and the cell in front of this cell.
    cell: np.ndarray
    front: np.ndarray
    height: np.ndarray  # (k,) float32: height of the visible point in the coordinates of the layer, mm

    def chosen(self, which: np.ndarray) -> Walls:
        """Return the pixels that the mask `which` (k,) bool selects."""
        number = np.flatnonzero(which)
        return Walls(*(part[number] for part in self))


# Arrays are indexed with brackets and int64, because `take` and 32-bit indices are several times slower.
def look(layer: Layer, of_layer: Frame, frame: Frame) -> Seen:
    """Return the surfaces of a layer of columns that the pixels of an image see.

    Parameters
    ----------
    layer : Layer
        The layer to draw. For a view from below, the layer is turned upside down.
    of_layer : Frame
        Frame in which the layer was simulated, from above.
    frame : Frame
        Frame of the image. For a view from below, the rows of the result are counted from the top.
    """
    sine, cosine = abs(float(frame.direction[2])), float(np.hypot(*frame.direction[:2]))
    turned = _Turned(layer, of_layer, frame, sine, cosine)
    scale, width = np.float32(cosine / frame.pixel), frame.width
    tops, bottoms, cells = layer.top.ravel(), layer.bottom.ravel(), turned.cell.ravel()
    back = tops[turned.cell]
    back *= scale
    back += turned.rise[:, None] + np.float32(turned.step * sine / frame.pixel)
    row = np.arange(0.5, frame.height, dtype=np.float32)[:, None]  # centres of the pixel rows above the lower edge
    if layer.is_even or cosine < _LEVEL:
        step = _first_above(back, frame.height)
    else:
        low = bottoms[turned.cell] * scale + turned.rise[:, None]
        step = _first_between(low, back, np.repeat(row, width))
    # Quantities are computed for all pixels of the image, because selecting the needed pixels would take longer.
    seen = cells[step * np.int64(width) + np.arange(width)]
    top, rise = tops[seen], turned.rise[step]
    lower = np.float32(layer.extent[0]) if layer.is_even else bottoms[seen]
    solid = top > EMPTY
    solid &= lower * scale + rise <= row
    is_wall = top * scale + rise > row
    row -= np.float32(frame.height / 2)
    # The sine or cosine is nearly 0 only for tops in horizontal views and for walls in vertical views, which are
    # invisible.
    top += np.float32(turned.lift)
    top *= np.float32(-1 / max(sine, _LEVEL))
    top += row * np.float32(frame.pixel * cosine / max(sine, _LEVEL))
    pixel = np.flatnonzero(solid)
    cell, depth = seen.ravel()[pixel], top.ravel()[pixel]
    number = np.flatnonzero(is_wall.ravel()[pixel])
    of_row, of_column = np.divmod(pixel[number], width)
    height, step = row[of_row, 0] * np.float32(frame.pixel), step[of_row, of_column].astype(np.int64)
    of_walls = (turned.first + turned.step * np.arange(len(turned.rise))).astype(np.float32)[step]
    of_walls -= height * np.float32(sine)
    of_walls *= np.float32(1 / max(cosine, _LEVEL))
    depth[number] = of_walls
    front = cells[np.maximum(step - 1, 0) * width + of_column]
    front[step == 0] = 0  # an empty cell of the border, because there is no cell in front of the first cell
    walls = Walls(number, cell[number], front,
                  height * np.float32(cosine) - of_walls * np.float32(sine) - np.float32(turned.lift))  # fmt: skip
    return Seen(pixel, cell, depth, walls)


class _Turned:
    """The cells of a layer, resampled so that each column of pixels has a sequence of cells from front to rear.

    Attributes
    ----------
    cell : (n, width) int64
        Cell of the layer at each step from front to rear, in each column of pixels. The cells of the last step belong
        to the border of empty cells around the layer.
    step, first : float
        Distance between successive cells in the direction away from the viewer, and position of the first cell's front
        edge relative to the image's centre, mm.
    lift : float
        Height of the stock's centre, which is the origin of heights in the layer, above the image's centre, mm.
    rise : (n,) float32
        Screen height of the front edge of each step's cells if their tops were at height 0, in pixels from the image's
        lower edge.
    """

    def __init__(self, layer: Layer, of_layer: Frame, frame: Frame, sine: float, cosine: float) -> None:
        right, away = frame.right[:2], np.array([-frame.right[1], frame.right[0]])
        upwards = 1.0 if frame.direction[2] <= 0 else -1.0
        from_centre = of_layer.centre - frame.centre
        self.lift = lift = upwards * float(from_centre[2])
        half = np.array([of_layer.width, of_layer.height]) * of_layer.pixel / 2
        middle, reach = float(from_centre[:2] @ away), float(np.abs(away) @ half)
        nearest, farthest = middle - reach, middle + reach
        if sine > _LEVEL:  # keep only the range of distances in which cells can appear in the image
            low, high = (lift + height for height in layer.extent)
            edge = frame.height * frame.pixel / 2
            nearest = max(nearest, (-edge - high * cosine) / sine)
            farthest = min(farthest, (edge - low * cosine) / sine)
        self.step = max(of_layer.pixel, frame.pixel)
        self.first = nearest
        count = max(int(np.ceil((farthest - nearest) / self.step)), 0) + 1
        edges = self.first + self.step * np.arange(count)
        self.rise = ((edges * sine + lift * cosine) / frame.pixel + frame.height / 2).astype(np.float32)
        across = (np.arange(frame.width) + 0.5 - frame.width / 2) * frame.pixel
        # Row and column of a cell are computed as sums of two fixed-point numbers, which is faster than rotating the
        # position of each cell.
        side = layer.top.shape[1]
        index = [
            _sums((edges + self.step / 2) * away[axis], across * right[axis], of_layer.pixel,
                  half[axis] - from_centre[axis], layer.top.shape[1 - axis])
            for axis in (0, 1)
        ]  # fmt: skip
        index[1] *= np.int32(side)
        index[1] += index[0]
        self.cell = index[1].astype(np.int64)
        self.cell[-1] = 0


def _sums(along: np.ndarray, across: np.ndarray, cell: float, offset: float, count: int) -> np.ndarray:
    """Return the layer's row or column at the sum of each pair of coordinates, mm, (len(along), len(across)) int32."""
    one = 1 << _FRACTION
    fixed = [np.rint(part / cell * one).astype(np.int64) for part in (along, across + offset + cell)]
    limit = 1 << 29
    one_, other = (np.clip(part, -limit, limit).astype(np.int32) for part in fixed)
    sums = one_[:, None] + other
    sums >>= _FRACTION
    return np.clip(sums, 0, count - 1, out=sums)


def _first_above(back: np.ndarray, height: int) -> np.ndarray:
    """Return the first step, from front to rear, at which the horizon covers each pixel, (height, width) int32.

    For pixels that the horizon never reaches, the result is the number of the last step. `back` (n, width) contains the
    screen heights of the rear edges of the tops, pixels.
    """
    steps, width = back.shape
    covered = np.empty((steps, width), np.int32)  # number of pixels below the horizon before each step
    covered[0] = 0
    horizon = np.zeros(width, np.float32)
    for step in range(steps - 1):  # number of pixels below the horizon before each step from front to rear
        np.maximum(horizon, back[step], out=horizon)
        covered[step + 1] = horizon + np.float32(0.5)
    np.minimum(covered, height, out=covered)
    covered *= np.int32(width)
    covered += np.arange(width, dtype=np.int32)
    found = np.zeros((height + 1, width), np.int32)
    # A step visits one cell in each column of pixels, from front to rear. If several successive steps begin with the
    # same horizon, only the last step of the series raises the horizon. numpy assigns the numbers of the series in their
    # order, so `found` keeps the number of the last step.
    found.ravel()[covered.astype(np.int64)] = np.arange(steps, dtype=np.int32)[:, None]
    for below, row in zip(found, found[1:-1]):
        np.maximum(below, row, out=row)
    return found[:-1]


def _first_between(low: np.ndarray, back: np.ndarray, row: np.ndarray) -> np.ndarray:
    """Return the first step, front to rear, at which each pixel sees a column of material, (height, width) int32.

    The lower ends of the columns of material can be at different heights. `low` and `back` (n, width) contain the
    screen heights of the lower end of each column, and of the rear edge of its top, pixels. `row` (pixels,) contains
    the screen height of the centre of each pixel, pixels.
    """
    steps, width = low.shape
    height = len(row) // width
    first = np.maximum(_first_above(back, height), _first_above(np.float32(height) - low, height)[::-1])
    low, back = low.ravel(), back.ravel()
    index = (first * np.int64(width) + np.arange(width)).ravel()
    pending = np.flatnonzero((low[index] > row) | (back[index] < row))
    # A ray that passes below one column of material and above another sees neither, so the search for its visible
    # column continues with the next cell to the rear.
    last = (steps - 1) * width
    for _ in range(steps):
        pending = pending[index[pending] < last]
        if not len(pending):
            break
        index[pending] += width
        at, where = row[pending], index[pending]
        pending = pending[(low[where] > at) | (back[where] < at)]
    return (index // width).reshape(height, width)
