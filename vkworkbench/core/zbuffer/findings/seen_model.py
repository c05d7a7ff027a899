# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare a model with a simulated part in an image, pixel by pixel."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from vkworkbench.core.stocks import Solid, spans_in
from vkworkbench.core.view import Frame
from vkworkbench.core.zbuffer.simulator.moments import ZBuffer

_ROWS_AT_ONCE = 64
# Width, pixels, of the strip along the wall of a through hole in which the part is compared with the model. The strip
# begins at the second pixel from the wall, because a round wall can run through the first pixel.
_BESIDE = 3


@dataclass(frozen=True, eq=False)
class Deviations:
    """Deviations of the simulated part's visible surface from the model.

    Attributes
    ----------
    left, gouged : (pixels,) float32
        Thickness of the leftover material, and depth of the gouge, at each pixel, measured along the view, mm, at least
        0. Leftover material is measured from the highest point of the model in the pixel and its eight neighbours. A
        gouge is measured from the lowest point of the model in the pixel and its eight neighbours. Therefore a wall
        that runs through a pixel is neither leftover material nor a gouge.
    part : (height, width) float32
        Depth of the part's surface, mm. If no material is left on a ray, `part` is the depth of the model's far side,
        or infinite if the ray misses the model.
    model : SeenModel
        The compared model.
    """

    left: np.ndarray
    gouged: np.ndarray
    part: np.ndarray
    model: SeenModel


class SeenModel:
    """The model in an image, for comparison with the simulated part after any number of trajectories.

    Parameters
    ----------
    model : Solid
        The model in the coordinates of the stock.
    frame : Frame
    going_on : callable, optional
        Called for every strip of the image. An exception raised by `going_on` stops the preparation.

    Attributes
    ----------
    model : Solid
    frame : Frame
    seen : (height, width) bool
        Whether each ray meets the model.
    near, far : (height, width) float32
        Depths at which each ray first enters and finally leaves the model, mm; NaN for rays that miss the model.
    behind : (height, width) float32
        Depth at which each ray leaves the model for the first time (before a gap in the model), mm; NaN for rays that
        miss the model.
    surface : (height, width) float32
        Depth at which each ray first enters the model, mm; infinite for rays that miss the model.
    floor : (height, width) float32
        Depth above which material of the part counts as leftover, mm. This depth is `surface`, except in a strip along
        the walls of through holes, where it is the depth of the model's far side. The middle of a through hole is not
        compared, because a piece that is cut free there falls out. In oblique views, through holes are not compared at
        all, because a piece that is cut free in a hole hides the walls.
    """

    def __init__(self, model: Solid, frame: Frame, going_on: Callable[[], None] = lambda: None) -> None:
        self.model, self.frame = model, frame
        near, far, behind = np.full((3, frame.height * frame.width), np.nan, np.float32)
        spans_of = spans_in(model, frame)
        for bottom in range(0, frame.height, _ROWS_AT_ONCE):
            going_on()
            rows = np.arange(bottom, min(bottom + _ROWS_AT_ONCE, frame.height))
            first = bottom * frame.width  # number of the first pixel in the rows
            spans = spans_of(*frame.pixel_centres(np.tile(np.arange(frame.width), len(rows)), rows.repeat(frame.width)))
            met = np.flatnonzero(spans.far > spans.near)
            near[first + met], far[first + met] = spans.near[met], spans.far[met]
            behind[first + met] = spans.far[met]
            ray, gap = np.unique(spans.gaps.ray, return_index=True)
            behind[first + ray] = spans.gaps.enter[gap]
        near, far, behind = (depths.reshape(frame.height, frame.width) for depths in (near, far, behind))
        self.near, self.far, self.behind = near, far, behind
        self.surface = np.where(np.isnan(near), np.float32(np.inf), near)
        highest, self._lowest = around(self.surface, np.minimum), around(self.surface, np.maximum)
        self.seen = ~np.isnan(near)
        upright = not frame.direction[:2].any()
        self._walls, self._beside = _beside_walls(~self.seen & ~_connected_to_edge(~self.seen) & upright)
        end = np.where(self.seen, far, np.float32(-np.inf))
        for _ in range(_BESIDE):
            end = around(end, np.maximum)
        self.floor = np.where(self._walls | self._beside, end, self.surface)
        self._highest = np.where(self._beside, end, highest)

    def against(self, zbuffer: ZBuffer) -> Deviations:
        """Compare the part, at the moment that the z-buffer shows, with the model, pixel by pixel.

        The z-buffer must have the same image (`frame`) as the model.
        """
        part = zbuffer.picture.depth.reshape(self.near.shape)
        # If no material is left on a ray, use the depth of the model's far side.
        part = np.where(np.isnan(part) & self.seen, self.far, part)
        left = np.where(self.seen | (self._beside & ~self._loose(part)), np.fmax(self._highest - part, 0), 0)
        gouged = np.where(self.seen & np.isfinite(self._lowest), np.maximum(part - self._lowest, 0), 0)
        return Deviations(
            left.astype(np.float32).ravel(),
            gouged.astype(np.float32).ravel(),
            np.where(np.isnan(part), np.float32(np.inf), part),
            self,
        )

    def walls(self, height: float) -> np.ndarray:
        """Return the pixels near walls of the model.

        A wall is where the depths of neighbouring pixels differ by more than `height`, mm.
        """
        with np.errstate(invalid="ignore"):
            steep: np.ndarray = self.seen & (self._lowest - self._highest > height)
        return around(steep, np.maximum)

    def _loose(self, part: np.ndarray) -> np.ndarray:
        """Return the pixels in through holes where a slot separates the material in the hole from the wall.

        The slot can be narrower than `_BESIDE` pixels.
        """
        loose: np.ndarray = self._walls & (np.fmin(part, np.inf) >= self.floor)
        if loose.any():  # most parts have no through holes
            for _ in range(_BESIDE - 1):
                loose = around(loose, np.maximum)
        return loose


def deviations(zbuffer: ZBuffer, model: Solid) -> Deviations:
    """Compare the part, at the moment that the z-buffer shows, with its model, pixel by pixel.

    Parameters
    ----------
    model : Solid
        The model in the coordinates of the stock.
    """
    return SeenModel(model, zbuffer.frame).against(zbuffer)


def _beside_walls(holes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the pixels of holes next to a wall, and the pixels that are second to `_BESIDE`-th from a wall."""
    within = around(holes, np.minimum)
    far_from = within
    for _ in range(_BESIDE - 1):
        far_from = around(far_from, np.minimum)
    return holes & ~within, within & ~far_from


def _connected_to_edge(free: np.ndarray) -> np.ndarray:
    """Return the pixels of `free` from which a path within `free`, by rows and columns, leads to the image's edge."""
    found = free.copy()
    found[1:-1, 1:-1] = False
    while True:
        more = _extend_along_rows(free, _extend_along_rows(free.T, found.T).T)
        if np.array_equal(more, found):
            return found
        found = more


def _extend_along_rows(free: np.ndarray, found: np.ndarray) -> np.ndarray:
    """Return the pixels of `free` in the same run along a row as a pixel of `found`; a run has no gap in `free`."""
    # The runs of all rows are numbered in one sequence, so a run at the right edge can continue at the left edge of the
    # next row. All pixels of such a run are connected with the image's edge, so joining two runs is harmless.
    run = np.cumsum(~free).reshape(free.shape)
    reached = np.bincount(run[found], minlength=int(run.max(initial=0)) + 1) > 0
    return free & reached[run]


def around(values: np.ndarray, extreme: np.ufunc) -> np.ndarray:
    """Return, for each pixel, the extreme value (minimum or maximum) among the pixel and its eight neighbours.

    Outside the image, the values of the pixels at the edge are repeated.
    """
    for axis in (0, 1):
        length = values.shape[axis]
        padded = np.pad(values, [(1, 1) if own == axis else (0, 0) for own in (0, 1)], mode="edge")
        shifted = [np.take(padded, np.arange(begin, begin + length), axis) for begin in range(3)]
        values = extreme.reduce(shifted)
    return values
