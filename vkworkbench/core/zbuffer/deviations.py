# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a simulated part has too much, and too little, against its model: both seen in one view."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.stocks import Solid
from vkworkbench.core.zbuffer.cuts import Source
from vkworkbench.core.zbuffer.moments import ZBuffer

_ROWS_AT_ONCE = 64


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
    """The worst place of one cut's gouges, or of the material left.

    Attributes
    ----------
    trajectory : int or None
        What made the surface there; None for the stock's own.
    source : Source or None
        Its cut and command.
    place : (3,) tuple of float
        On the part's surface, mm.
    depth : float
        How deep it is, or how much is left, mm.
    area : float
        Of the image in which the same cut exceeds the tolerance, mm^2.
    """

    trajectory: int | None
    source: Source | None
    place: tuple[float, float, float]
    depth: float
    area: float


def deviations(zbuffer: ZBuffer, model: Solid) -> Deviations:
    """Compare the part at this moment with its model, pixel by pixel.

    Parameters
    ----------
    zbuffer : ZBuffer
    model : Solid
        In the same place as the stock.
    """
    frame = zbuffer.frame
    size = frame.height, frame.width
    near, far = np.full((2, *size), np.nan, np.float32)
    for bottom in range(0, frame.height, _ROWS_AT_ONCE):
        rows = np.arange(bottom, min(bottom + _ROWS_AT_ONCE, frame.height))
        row, column = (index.ravel() for index in np.meshgrid(rows, np.arange(frame.width), indexing="ij"))
        spans = model.spans(frame, *frame.pixel_centres(column, row))
        met = spans.far > spans.near
        near[row[met], column[met]], far[row[met], column[met]] = spans.near[met], spans.far[met]
    part = zbuffer.picture.depth.reshape(size)
    # Where all of the part is gone, its surface is behind the model.
    part = np.where(np.isnan(part), np.where(np.isnan(near), np.nan, far), part)
    depth = near - part
    highest = _around(np.where(np.isnan(near), np.inf, near), np.minimum)
    lowest = _around(np.where(np.isnan(near), np.inf, near), np.maximum)
    seen = ~np.isnan(near)
    left = np.where(seen, np.maximum(highest - part, 0), 0)
    gouged = np.where(seen & np.isfinite(lowest), np.maximum(part - lowest, 0), 0)
    return Deviations(*(values.astype(np.float32).ravel() for values in (depth, left, gouged)))


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


def _worst(zbuffer: ZBuffer, amount: np.ndarray, tolerance: float) -> list[Deviation]:
    pixels = np.flatnonzero(amount > tolerance)
    cuts, frame, picture = zbuffer.cuts, zbuffer.frame, zbuffer.picture
    owner = picture.owner[pixels]
    if len(cuts) == 0:
        owner = np.full(len(pixels), -1)
    cut = np.where(owner >= 0, np.append(cuts.cut, -1)[owner], -1)
    worst = []
    for own in np.unique(cut):
        its = pixels[cut == own]
        pixel = int(its[np.argmax(amount[its])])
        row, column = divmod(pixel, frame.width)
        x, y = frame.pixel_centres(np.array([column]), np.array([row]))
        at = float(np.nan_to_num(picture.depth[pixel]))
        place = (frame.origins(x, y)[0] + at * frame.direction).tolist()
        trajectory = int(picture.owner[pixel]) if own >= 0 else None
        source = None if trajectory is None else cuts.source(trajectory)
        worst.append(Deviation(trajectory, source, tuple(place), float(amount[pixel]), len(its) * frame.pixel**2))
    return sorted(worst, key=lambda one: -one.depth)


def _around(values: np.ndarray, extreme: np.ufunc) -> np.ndarray:
    """The extreme of every pixel and its eight neighbours; beside the image it goes on as its edge."""
    for axis in (0, 1):
        length = values.shape[axis]
        padded = np.pad(values, [(1, 1) if own == axis else (0, 0) for own in (0, 1)], mode="edge")
        shifted = [np.take(padded, np.arange(k, k + length), axis) for k in range(3)]
        values = extreme.reduce(shifted)
    return values
