# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the path of the tool over a picture, as a line that is one pixel wide."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.rendering.camera import project
from vkworkbench.core.view import Frame

# Maximum number of pixels that are drawn of a path. Drawing more pixels would take longer than computing the picture.
_MOST = 1_000_000


def draw_path(pixels: np.ndarray, points: np.ndarray, frame: Frame, color: tuple[int, int, int]) -> None:
    """Draw a path over a picture, beginning with the path's first point and ending after about a million pixels.

    Parameters
    ----------
    pixels : (height, width) uint32
        Colours as 0xffRRGGBB, row 0 at the top. The function changes `pixels`.
    points : (n, 3) ndarray
        Corners of the path, mm.
    frame : Frame
        Frame of the picture.
    color : tuple of int
    """
    corners = project(points, frame)[:, :2]
    start, move = corners[:-1], np.diff(corners, axis=0)
    first, last = _inside(start, move, np.array([frame.width, frame.height], float))
    count = np.ceil(np.abs(move).max(axis=1, initial=0) * np.maximum(last - first, 0)).astype(np.int64) + (
        first <= last
    )
    count = count[: int(np.searchsorted(np.cumsum(count), _MOST)) + 1]
    number = np.repeat(np.arange(len(count)), count)
    own = np.arange(len(number)) - np.repeat(np.cumsum(count) - count, count)
    share = first[number] + (last - first)[number] * (own / np.maximum(count - 1, 1)[number])
    column, row = (start[number] + share[:, None] * move[number]).astype(np.int64).T
    seen = (column >= 0) & (column < frame.width) & (row >= 0) & (row < frame.height)
    red, green, blue = color
    pixels[row[seen], column[seen]] = 0xFF000000 | red << 16 | green << 8 | blue


def _inside(start: np.ndarray, move: np.ndarray, size: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the positions on each move, from 0 to 1, at which the move enters and leaves an image, (n,) each.

    For a move outside the image, the first position is greater than the second.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        one, other = -start / move, (size - start) / move
    still = move == 0
    beside = still & ((start < 0) | (start >= size))
    enter, leave = np.where(still, -np.inf, np.minimum(one, other)), np.where(still, np.inf, np.maximum(one, other))
    first, last = np.maximum(enter.max(axis=1), 0), np.minimum(leave.min(axis=1), 1)
    return np.where(beside.any(axis=1), 2.0, first), last
