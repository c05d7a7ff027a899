# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a simulated part has too much, and too little, against its model: both seen in one view."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from vkworkbench.core.solids import Frame
from vkworkbench.core.stocks import Solid
from vkworkbench.core.zbuffer.cuts import Source
from vkworkbench.core.zbuffer.moments import ZBuffer

_ROWS_AT_ONCE = 64
# Of the image's shorter side: worst places closer to each other hang together.
_APART = 0.02


@dataclass(frozen=True, eq=False)
class Deviations:
    """The surface that is seen against the model's.

    Attributes
    ----------
    depth : (pixels,) float32
        How far the part's surface lies above the model's, along the view, mm: material left where positive, gouges where
        negative; not a number where the model is not seen.
    left, gouged : (pixels,) float32
        How much of it is sure, mm, at least 0: what is left above all of the model around the pixel, and what is cut
        below all of it. A wall that passes through a pixel is neither.
    """

    depth: np.ndarray
    left: np.ndarray
    gouged: np.ndarray


@dataclass(frozen=True)
class Deviation:
    """A place where the part is gouged, or where material is left: the worst one of a cut, or of what hangs together.

    Attributes
    ----------
    trajectory : int or None
        What made the surface there, or removed the last of it; None for the stock's own.
    source : Source or None
        Its cut and command.
    place : (3,) tuple of float
        On the part's surface, mm.
    depth : float
        How deep it is, or how much is left, mm.
    area : float
        Of the image in which the same cut, or what hangs together, exceeds the tolerance, mm^2.
    """

    trajectory: int | None
    source: Source | None
    place: tuple[float, float, float]
    depth: float
    area: float


class SeenModel:
    """A model as an image sees it, with which the part is compared at any moment.

    Parameters
    ----------
    model : Solid
        In the same place as the stock.
    frame : Frame
    going_on : callable, optional
        Called with every strip of the image; what it raises ends the work.

    Attributes
    ----------
    frame : Frame
    near, far : (height, width) float32
        Where each ray enters the model and leaves it at last, mm; not a number where it misses.
    """

    def __init__(self, model: Solid, frame: Frame, going_on: Callable[[], None] = lambda: None) -> None:
        self.frame = frame
        size = frame.height, frame.width
        near, far = np.full((2, *size), np.nan, np.float32)
        for bottom in range(0, frame.height, _ROWS_AT_ONCE):
            going_on()
            rows = np.arange(bottom, min(bottom + _ROWS_AT_ONCE, frame.height))
            row, column = (index.ravel() for index in np.meshgrid(rows, np.arange(frame.width), indexing="ij"))
            spans = model.spans(frame, *frame.pixel_centres(column, row))
            met = spans.far > spans.near
            near[row[met], column[met]], far[row[met], column[met]] = spans.near[met], spans.far[met]
        self.near, self.far = near, far
        there = np.where(np.isnan(near), np.float32(np.inf), near)
        self._highest, self._lowest = _around(there, np.minimum), _around(there, np.maximum)

    def against(self, zbuffer: ZBuffer) -> Deviations:
        """Compare the part at its moment, simulated in the same image, with the model, pixel by pixel."""
        part = zbuffer.picture.depth.reshape(self.near.shape)
        seen = ~np.isnan(self.near)
        # Where all of the part is gone, its surface is behind the model.
        part = np.where(np.isnan(part) & seen, self.far, part)
        left = np.where(seen, np.maximum(self._highest - part, 0), 0)
        gouged = np.where(seen & np.isfinite(self._lowest), np.maximum(part - self._lowest, 0), 0)
        return Deviations(*(values.astype(np.float32).ravel() for values in (self.near - part, left, gouged)))


def deviations(zbuffer: ZBuffer, model: Solid) -> Deviations:
    """Compare the part at this moment with its model, pixel by pixel.

    Parameters
    ----------
    zbuffer : ZBuffer
    model : Solid
        In the same place as the stock.
    """
    return SeenModel(model, zbuffer.frame).against(zbuffer)


def gouges(zbuffer: ZBuffer, found: Deviations, tolerance: float) -> list[Deviation]:
    """Return the worst gouge of each cut, the deepest first.

    Parameters
    ----------
    zbuffer : ZBuffer
        What `found` is of.
    found : Deviations
    tolerance : float
        What is no gouge yet, mm.
    """
    return _worst(zbuffer, found.gouged, tolerance)


def material_left(zbuffer: ZBuffer, found: Deviations, tolerance: float) -> list[Deviation]:
    """Return where each cut leaves most above the model, the most first; the arguments are those of `gouges`."""
    return _worst(zbuffer, found.left, tolerance)


def worst_places(zbuffer: ZBuffer, amount: np.ndarray, tolerance: float, most: int = 10) -> list[Deviation]:
    """Return the places where most is gouged, or left, the worst first; what hangs together is one.

    Parameters
    ----------
    zbuffer : ZBuffer
        What `amount` is of.
    amount : (pixels,) float32
        `gouged` or `left` of its deviations, mm.
    tolerance : float
        What is no deviation yet, mm.
    most : int
        How many are returned at most.
    """
    frame = zbuffer.frame
    side = max(1, round(_APART * min(frame.height, frame.width)))
    rows, columns = -(-frame.height // side), -(-frame.width // side)
    too_much = np.zeros((rows * side, columns * side), np.float32)
    too_much[: frame.height, : frame.width] = amount.reshape(frame.height, frame.width)
    too_much[too_much <= tolerance] = 0
    tiles = too_much.reshape(rows, side, columns, side).swapaxes(1, 2)
    worst, counts = tiles.max(axis=(2, 3)), np.count_nonzero(tiles, axis=(2, 3))
    places: list[Deviation] = []
    while len(places) < most and worst.any():
        row, column = (int(at) for at in np.unravel_index(int(worst.argmax()), worst.shape))
        own_row, own_column = np.unravel_index(int(tiles[row, column].argmax()), (side, side))
        pixel = (row * side + int(own_row)) * frame.width + column * side + int(own_column)
        places.append(_place(zbuffer, amount, pixel, _take(worst, counts, row, column)))
    return places


def _take(worst: np.ndarray, counts: np.ndarray, row: int, column: int) -> int:
    """Clear all tiles that hang together with one; return how many pixels of theirs deviate."""
    pending, total = [(row, column)], 0
    worst[row, column] = 0
    while pending:
        row, column = pending.pop()
        total += int(counts[row, column])
        top, left = max(row - 1, 0), max(column - 1, 0)
        around = np.argwhere(worst[top : row + 2, left : column + 2] > 0) + (top, left)
        worst[around[:, 0], around[:, 1]] = 0
        pending += map(tuple, around.tolist())
    return total


def _worst(zbuffer: ZBuffer, amount: np.ndarray, tolerance: float) -> list[Deviation]:
    pixels = np.flatnonzero(amount > tolerance)
    owner = _makers(zbuffer, pixels)
    cut = np.full(len(pixels), -1)
    cut[owner >= 0] = zbuffer.cuts.cut[owner[owner >= 0]]
    worst = []
    for own in np.unique(cut):
        its = pixels[cut == own]
        worst.append(_place(zbuffer, amount, int(its[np.argmax(amount[its])]), len(its)))
    return sorted(worst, key=lambda one: -one.depth)


def _makers(zbuffer: ZBuffer, pixels: np.ndarray) -> np.ndarray:
    """What made the surface at pixels, -1 for the stock's own; where nothing is left, what removed the last of it."""
    picture, records = zbuffer.picture, zbuffer.records
    makers = picture.owner[pixels].astype(np.int64)
    gone = np.isnan(picture.depth[pixels]) & (records.index[pixels + 1] > records.index[pixels])
    if gone.any():
        bounds = np.column_stack((records.index[pixels[gone]], records.index[pixels[gone] + 1])).ravel()
        if bounds[-1] == len(records.owner):  # which reduceat takes for granted
            bounds = bounds[:-1]
        makers[gone] = np.maximum.reduceat(records.owner, bounds.astype(np.int64))[::2]
    return np.asarray(makers)


def _place(zbuffer: ZBuffer, amount: np.ndarray, pixel: int, count: int) -> Deviation:
    """What deviates at a pixel, and at so many in all."""
    frame, picture = zbuffer.frame, zbuffer.picture
    row, column = divmod(pixel, frame.width)
    x, y = frame.pixel_centres(np.array([column]), np.array([row]))
    at = float(np.nan_to_num(picture.depth[pixel]))
    place = (frame.origins(x, y)[0] + at * frame.direction).tolist()
    maker = int(_makers(zbuffer, np.array([pixel]))[0])
    trajectory = maker if maker >= 0 else None
    source = None if trajectory is None else zbuffer.cuts.source(trajectory)
    return Deviation(trajectory, source, tuple(place), float(amount[pixel]), count * frame.pixel**2)


def _around(values: np.ndarray, extreme: np.ufunc) -> np.ndarray:
    """The extreme of every pixel and its eight neighbours; beside the image it goes on as its edge."""
    for axis in (0, 1):
        length = values.shape[axis]
        padded = np.pad(values, [(1, 1) if own == axis else (0, 0) for own in (0, 1)], mode="edge")
        shifted = [np.take(padded, np.arange(k, k + length), axis) for k in range(3)]
        values = extreme.reduce(shifted)
    return values
