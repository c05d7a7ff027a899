# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which column of a field each pixel of a parallel view sees.

In parallel projection, a step away from the eye rises sin(e) on the screen and a step up rises cos(e), where e is the elevation of
the eye. Along one column of pixels, from the front to the back, the running maximum of the screen heights of the back edges of
columns is the horizon: a pixel sees the first column whose horizon reaches it (the floating-horizon algorithm). Below the front edge
of its top it sees the wall. The running minimum of the lower ends of the columns is a second, lower horizon.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from vkworkbench.core.rendering.field import EMPTY, Layer
from vkworkbench.core.view import Frame

# Sine and cosine of the elevation below which tops, or walls, are not seen.
_LEVEL = 1e-6
_FRACTION = 16  # bits of the fraction in positions of cells


@dataclass(frozen=True, eq=False)
class Seen:
    """The surface in each pixel of an image. All arrays have one row for each column of pixels, from the lowest pixel up.

    Attributes
    ----------
    cell : (width, height) int32
        Cell of the layer; a cell of the border for the background.
    depth : (width, height) float32
        Depth along the view, mm; NaN for the background.
    walls : Walls
        The pixels that see the wall of the column, not its top.
    """

    cell: np.ndarray
    depth: np.ndarray
    walls: Walls


class Walls(NamedTuple):
    """Pixels that see walls.

    Attributes
    ----------
    pixel : (k,) int64
        Pixels, counted over the flat image.
    cell, front : (k,) int32
        Cell of the column, and the cell in front of it.
    height : (k,) float32
        Height of the seen place in the coordinates of the layer, mm.
    """

    pixel: np.ndarray
    cell: np.ndarray
    front: np.ndarray
    height: np.ndarray

    def chosen(self, which: np.ndarray) -> Walls:
        """Return some of the pixels, `which` (k,) bool."""
        number = np.flatnonzero(which)
        return Walls(*(part[number] for part in self))


def look(layer: Layer, of_layer: Frame, frame: Frame) -> Seen:
    """Return what the pixels of an image see.

    Parameters
    ----------
    layer : Layer
        For a view from below, the layer upside down.
    of_layer : Frame
        Frame in which the layer was simulated, from above.
    frame : Frame
        Frame of the image. For a view from below, its rows count downwards.
    """
    sine, cosine = abs(float(frame.direction[2])), float(np.hypot(*frame.direction[:2]))
    turned = _Turned(layer, of_layer, frame, sine, cosine)
    scale = np.float32(cosine / frame.pixel)
    back = layer.top.ravel().take(turned.cell)
    back *= scale
    back += turned.rise + np.float32(turned.step * sine / frame.pixel)
    row = np.arange(0.5, frame.height, dtype=np.float32)
    first = _first_above(np.maximum.accumulate(back, axis=1), frame.height)
    if not layer.is_even and cosine > _LEVEL:
        low = layer.bottom.ravel().take(turned.cell) * scale + turned.rise
        first = _past_lower_ends(first, low, back, row)
    cell = turned.cell.ravel().take(first)
    place = first - np.arange(0, turned.cell.size, turned.cell.shape[1], dtype=np.int32)[:, None]
    rise, top = turned.rise.take(place), layer.top.ravel().take(cell)
    wall = top * scale + rise > row
    empty = (top <= EMPTY) | (layer.bottom.ravel().take(cell) * scale + rise > row)
    height = (row - np.float32(frame.height / 2)) * np.float32(frame.pixel)  # on the screen, mm
    # Division by nearly 0 occurs only for the kind of surface that such a view does not see.
    depth = (height * np.float32(cosine) - np.float32(turned.lift) - top) / np.float32(max(sine, _LEVEL))
    pixel = np.flatnonzero(wall & ~empty)
    along = np.float32(turned.first) + place.ravel()[pixel] * np.float32(turned.step)
    height = height[pixel % frame.height]
    depth.ravel()[pixel] = of_walls = (along - height * np.float32(sine)) / np.float32(max(cosine, _LEVEL))
    depth[empty] = np.nan
    cell[empty] = 0
    walls = Walls(pixel, cell.ravel()[pixel], turned.cell.ravel()[np.maximum(first.ravel()[pixel] - 1, 0)],
                  height * np.float32(cosine) - of_walls * np.float32(sine) - np.float32(turned.lift))  # fmt: skip
    return Seen(cell, depth, walls)


class _Turned:
    """The cells of a layer, turned so that each column of pixels has a row of cells from the front to the back.

    Attributes
    ----------
    cell : (width, n) int32
        Cells of the layer. The last one in each row belongs to the border.
    step, first : float
        Length of a cell away from the eye, and distance of the front edge of the first one from the image's centre, mm.
    lift : float
        Height of the layer's height 0 above the image's centre, mm.
    rise : (n,) float32
        Height on the screen of the front edge of each cell at the height 0 of the layer, pixels from the lower edge.
    """

    def __init__(self, layer: Layer, of_layer: Frame, frame: Frame, sine: float, cosine: float) -> None:
        right, away = frame.right[:2], np.array([-frame.right[1], frame.right[0]])
        upwards = 1.0 if frame.direction[2] <= 0 else -1.0
        from_centre = of_layer.centre - frame.centre
        self.lift = lift = upwards * float(from_centre[2])
        half = np.array([of_layer.width, of_layer.height]) * of_layer.pixel / 2
        middle, reach = float(from_centre[:2] @ away), float(np.abs(away) @ half)
        nearest, farthest = middle - reach, middle + reach
        if sine > _LEVEL:  # only what the image can show
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
        # Sums of fixed-point numbers instead of a rotation of each cell.
        side = layer.top.shape[1]
        index = [
            _sums(across * right[axis], (edges + self.step / 2) * away[axis], of_layer.pixel,
                  half[axis] - from_centre[axis], layer.top.shape[1 - axis])
            for axis in (0, 1)
        ]  # fmt: skip
        self.cell = index[1] * np.int32(side) + index[0]
        self.cell[:, -1] = 0


def _sums(across: np.ndarray, along: np.ndarray, cell: float, offset: float, count: int) -> np.ndarray:
    """Return the row or column of a layer at each sum of two coordinates, (len(across), len(along)) int32."""
    one = 1 << _FRACTION
    fixed = [np.rint(part / cell * one).astype(np.int64) for part in (across + offset + cell, along)]
    limit = 1 << 29
    one_, other = (np.clip(part, -limit, limit).astype(np.int32) for part in fixed)
    sums = one_[:, None] + other
    sums >>= _FRACTION
    return np.clip(sums, 0, count - 1, out=sums)


def _first_above(horizon: np.ndarray, height: int) -> np.ndarray:
    """Return the first cell whose horizon reaches each pixel, (width, height) int32, counted over all rows of cells."""
    covered = np.clip(np.floor(horizon + np.float32(0.5)), 0, height).astype(np.int32)
    covered[:, -1] = height
    return _repeated(np.diff(covered, axis=1, prepend=0), height)


def _repeated(counts: np.ndarray, height: int) -> np.ndarray:
    width, length = counts.shape
    return np.repeat(np.arange(width * length, dtype=np.int32), counts.ravel()).reshape(width, height)


def _past_lower_ends(first: np.ndarray, low: np.ndarray, back: np.ndarray, row: np.ndarray) -> np.ndarray:
    """Return the first column that each pixel sees if columns end at different heights.

    Parameters
    ----------
    first : (width, height) int32
        First column that reaches up to each pixel.
    low, back : (width, n) float32
        Heights on the screen of the lower end of each column, and of the back edge of its top, pixels.
    row : (height,) float32
        Centres of the pixels.
    """
    height, length = len(row), low.shape[1]
    below = np.clip(np.ceil(np.minimum.accumulate(low, axis=1) - np.float32(0.5)), 0, height).astype(np.int32)
    below[:, -1] = 0
    first = np.maximum(first, _repeated(-np.diff(below, axis=1, prepend=height), height)[:, ::-1])
    low, back = low.ravel(), back.ravel()
    at, seen = np.broadcast_to(row, first.shape).ravel(), first.ravel()
    pending = np.flatnonzero((low.take(seen) > at) | (back.take(seen) < at))
    # Rays that pass below one column and above another: look on, column by column.
    last = (pending // height + 1) * length - 1
    for _ in range(length):
        on = seen[pending] < last
        pending, last = pending[on], last[on]
        if not len(pending):
            break
        seen[pending] += 1
        on = (low.take(seen[pending]) > at[pending]) | (back.take(seen[pending]) < at[pending])
        pending, last = pending[on], last[on]
    return seen.reshape(first.shape)
