# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seen surface as points, drawn from another direction while the view is being turned.

A z-buffer belongs to one view; a new one takes a simulation. Until it is there the points of the old one, seen from the
new direction, show where one is.
"""

from __future__ import annotations

import numpy as np

from vkworkbench.core.rendering.camera import project
from vkworkbench.core.view import Frame


class Points:
    """The surface of a picture as points of the space.

    Parameters
    ----------
    depth : (height, width) float32
        Row 0 below; not a number where nothing is seen.
    image : (height, width, 3) uint8
        Its shaded picture, row 0 at the top.
    frame : Frame
        What it is seen with.
    most : int
        No more points than this.
    """

    def __init__(self, depth: np.ndarray, image: np.ndarray, frame: Frame, most: int = 60_000) -> None:
        every = max(1, int(np.ceil(np.sqrt(depth.size / most))))
        rows, columns = np.mgrid[0 : depth.shape[0] : every, 0 : depth.shape[1] : every]
        rows, columns = rows.ravel(), columns.ravel()
        seen = ~np.isnan(depth[rows, columns])
        rows, columns = rows[seen], columns[seen]
        self._points = frame.points(columns, rows, depth[rows, columns].astype(float))
        self._colors = image[::-1][rows, columns]
        self._side = every * frame.pixel

    def draw(self, frame: Frame, background: tuple[int, int, int]) -> np.ndarray:
        """Return the points' picture in another frame, (height, width, 3) uint8."""
        image = np.empty((frame.height, frame.width, 3), np.uint8)
        image[:] = background
        at = project(self._points, frame)
        size = 1 + int(np.ceil(self._side / frame.pixel))  # one more, as a slope that turns to the eye spreads them
        near = ((at[:, :2] >= -size) & (at[:, :2] < [frame.width + size, frame.height + size])).all(axis=1)
        at, colors = at[near], self._colors[near]  # zoomed in, each of the others would take as many pixels
        far_first = np.argsort(-at[:, 2])
        column, row = np.floor(at[far_first, :2]).astype(int).T[..., None, None]
        beside = np.arange(size) - size // 2
        column, row = np.broadcast_arrays(column + beside, row + beside[:, None])
        inside = (column >= 0) & (column < frame.width) & (row >= 0) & (row < frame.height)
        # Of several points in one pixel the last, the nearest, stays.
        image[row[inside], column[inside]] = colors[far_first[np.nonzero(inside)[0]]]
        return image
