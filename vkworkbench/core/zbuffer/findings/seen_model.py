# SPDX-License-Identifier: LGPL-2.1-or-later
"""A model as an image sees it, and how a simulated part differs from it, pixel by pixel."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from vkworkbench.core.stocks import Solid, spans_in
from vkworkbench.core.view import Frame
from vkworkbench.core.zbuffer.simulator.moments import ZBuffer

_ROWS_AT_ONCE = 64
# So many pixels beside the wall of a hole through the model belong to it; the next one may be cut by a rounded wall.
_BESIDE = 3


@dataclass(frozen=True, eq=False)
class Deviations:
    """The surface that is seen against the model's.

    Attributes
    ----------
    left, gouged : (pixels,) float32
        How much is left above all of the model around the pixel, and how much is cut below all of it, along the view, mm,
        at least 0. A wall that passes through a pixel is neither.
    part : (height, width) float32
        Depth of the part's surface, mm; where all of it is gone that of the model's end, infinite where there was no model.
    model : SeenModel
        What the part was compared with.
    """

    left: np.ndarray
    gouged: np.ndarray
    part: np.ndarray
    model: SeenModel


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
    seen : (height, width) bool
        Where a ray meets the model.
    near, far : (height, width) float32
        Where each ray enters the model and leaves it at last, mm; not a number where it misses.
    behind : (height, width) float32
        Where each ray leaves the model first.
    surface : (height, width) float32
        Where each ray enters the model, mm; infinite where it misses.
    floor : (height, width) float32
        The same, but beside the walls of holes through the model where it ends: material before it is left. In the middle of
        a hole that was cut out lies what falls out of it. Obliquely, where what falls out hides the walls, holes are not
        compared.
    """

    def __init__(self, model: Solid, frame: Frame, going_on: Callable[[], None] = lambda: None) -> None:
        self.frame = frame
        size = frame.height, frame.width
        near, far, behind = np.full((3, *size), np.nan, np.float32)
        spans_of = spans_in(model, frame)
        for bottom in range(0, frame.height, _ROWS_AT_ONCE):
            going_on()
            rows = np.arange(bottom, min(bottom + _ROWS_AT_ONCE, frame.height))
            row, column = (index.ravel() for index in np.meshgrid(rows, np.arange(frame.width), indexing="ij"))
            spans = spans_of(*frame.pixel_centres(column, row))
            met = spans.far > spans.near
            near[row[met], column[met]], far[row[met], column[met]] = spans.near[met], spans.far[met]
            behind[row[met], column[met]] = spans.far[met]
            ray, gap = np.unique(spans.gaps.ray, return_index=True)
            behind[row[ray], column[ray]] = spans.gaps.enter[gap]
        self.near, self.far, self.behind = near, far, behind
        self.surface = np.where(np.isnan(near), np.float32(np.inf), near)
        highest, self._lowest = around(self.surface, np.minimum), around(self.surface, np.maximum)
        self.seen = ~np.isnan(near)
        upright = not frame.direction[:2].any()
        self._walls, self._beside = _beside_walls(~self.seen & ~_open(~self.seen) & upright)
        end = np.where(self.seen, far, np.float32(-np.inf))
        for _ in range(_BESIDE):
            end = around(end, np.maximum)
        self.floor = np.where(self._walls | self._beside, end, self.surface)
        self._highest = np.where(self._beside, end, highest)

    def against(self, zbuffer: ZBuffer) -> Deviations:
        """Compare the part at its moment, simulated in the same image, with the model, pixel by pixel."""
        part = zbuffer.picture.depth.reshape(self.near.shape)
        # Where all of the part is gone, its surface is behind the model.
        part = np.where(np.isnan(part) & self.seen, self.far, part)
        left = np.where(self.seen | (self._beside & ~self._loose(part)), np.fmax(self._highest - part, 0), 0)
        gouged = np.where(self.seen & np.isfinite(self._lowest), np.maximum(part - self._lowest, 0), 0)
        return Deviations(
            left.astype(np.float32).ravel(),
            gouged.astype(np.float32).ravel(),
            np.where(np.isnan(part), np.float32(np.inf), part),
            self,
        )

    def _loose(self, part: np.ndarray) -> np.ndarray:
        """Where nothing is left between what is in a hole and its wall, which may be a slot narrower than `_BESIDE` pixels."""
        loose: np.ndarray = self._walls & (np.fmin(part, np.inf) >= self.floor)
        if loose.any():  # mostly there are no holes
            for _ in range(_BESIDE - 1):
                loose = around(loose, np.maximum)
        return loose


def deviations(zbuffer: ZBuffer, model: Solid) -> Deviations:
    """Compare the part at this moment with its model, pixel by pixel.

    Parameters
    ----------
    zbuffer : ZBuffer
    model : Solid
        In the same place as the stock.
    """
    return SeenModel(model, zbuffer.frame).against(zbuffer)


def _beside_walls(holes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Which pixels of holes lie at their walls, and which two pixels and up to `_BESIDE` from them."""
    within = around(holes, np.minimum)
    far_from = within
    for _ in range(_BESIDE - 1):
        far_from = around(far_from, np.minimum)
    return holes & ~within, within & ~far_from


def _open(free: np.ndarray) -> np.ndarray:
    """Which of the free pixels hang together, along rows and columns, with the edge of the image."""
    found = free.copy()
    found[1:-1, 1:-1] = False
    while True:
        more = _along_rows(free, _along_rows(free.T, found.T).T)
        if np.array_equal(more, found):
            return found
        found = more


def _along_rows(free: np.ndarray, found: np.ndarray) -> np.ndarray:
    """All free pixels of the runs in which some are found: those at the edge of the image are found anyway."""
    # A run has one number; one that goes on in the next row passes the edge.
    run = np.cumsum(~free).reshape(free.shape)
    reached = np.bincount(run[found], minlength=int(run.max(initial=0)) + 1) > 0
    extended: np.ndarray = free & reached[run]
    return extended


def around(values: np.ndarray, extreme: np.ufunc) -> np.ndarray:
    """The extreme of every pixel and its eight neighbours; beside the image it goes on as its edge."""
    for axis in (0, 1):
        length = values.shape[axis]
        padded = np.pad(values, [(1, 1) if own == axis else (0, 0) for own in (0, 1)], mode="edge")
        shifted = [np.take(padded, np.arange(k, k + length), axis) for k in range(3)]
        values = extreme.reduce(shifted)
    return values
