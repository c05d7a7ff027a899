# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far two surfaces that an image sees are from each other, in space and not only along the view."""

from __future__ import annotations

from collections.abc import Iterator
from math import ceil, hypot

import numpy as np

# Pixels that are searched around at once, at most: the first one tells which of the others need no search.
_AT_ONCE = 256
# Of these with pixels around them at once: 50 bytes each.
_PAIRS = 500_000
# The first look around a pixel: so many directions, and the next circle so many times as large.
_DIRECTIONS, _WIDER = 16, 1.2
# Then all around it, ring by ring.
_RING = 1.05


def farthest(
    front: np.ndarray, behind: np.ndarray, pixels: np.ndarray, pixel: float, floor: float
) -> tuple[int, float] | None:
    """Return at which pixel two surfaces, of which one lies behind the other, are farthest from each other, and how far.

    Their distance is the larger of two: from the surface behind to what lies before the other, and from the other to what
    lies behind the surface behind (Hausdorff). So a wall that is cut 0.3 mm too far has 0.3 mm, however high it is; a hole
    that is missing has its depth, however narrow it is. It is never more than along the view.

    Parameters
    ----------
    front, behind : (height, width) float32
        Depths along the view, mm; infinite where there is no surface, so that all is before it.
    pixels : (k,) int
        Where to look, numbers in the flat image.
    pixel : float
        Side of a pixel, mm; the distance is exact to within one.
    floor : float
        mm; what is no farther is not looked for.

    Returns
    -------
    tuple of int and float, or None
        Its number, and mm. None where they are nowhere farther than `floor`.
    """
    along = behind.ravel()[pixels] - front.ravel()[pixels]
    order = np.argsort(-along, kind="stable")
    found = None
    first, count = 0, 1
    while first < len(order) and along[order[first]] > floor:
        some = order[first : first + count]
        first, count = first + count, min(2 * count, _AT_ONCE)
        distances = _distances(front, behind, pixels[some], pixel, floor)
        most = int(distances.argmax())
        if distances[most] > floor:
            # What exceeds it by less than a tenth of a pixel is not told apart.
            floor = float(distances[most]) + pixel / 10
            found = int(pixels[some[most]]), float(distances[most])
    return found


def _distances(front: np.ndarray, behind: np.ndarray, pixels: np.ndarray, pixel: float, floor: float) -> np.ndarray:
    """Distances at pixels (k,), mm; where one is no more than the floor, something that is not, either."""
    height, width = front.shape
    row, column = np.divmod(pixels, width)
    ahead, beyond = front[row, column], behind[row, column]
    # To what lies before the front, and to what lies behind the surface behind.
    least = np.repeat((beyond - ahead)[None], 2, axis=0)
    for radius, steps in _around(ceil(hypot(height, width))):
        # Nothing that is farther away is nearer, and what is near enough is not looked for.
        (searched,) = np.nonzero(least.max(axis=0) > max(floor, radius * pixel))
        if not len(searched):
            break
        for some in np.array_split(steps, ceil(len(searched) * len(steps) / _PAIRS)):
            rows, columns = row[searched, None] + some[:, 0], column[searched, None] + some[:, 1]
            beside = (rows < 0) | (rows >= height) | (columns < 0) | (columns >= width)
            rows, columns = np.clip(rows, 0, height - 1), np.clip(columns, 0, width - 1)
            across = np.where(beside, np.inf, np.hypot(*some.T) * pixel)
            to_front = beyond[searched, None] - front[rows, columns]
            to_behind = behind[rows, columns] - ahead[searched, None]
            for side, gap in enumerate((to_front, to_behind)):
                away = np.hypot(across, np.maximum(gap, 0)).min(axis=1)
                least[side, searched] = np.minimum(least[side, searched], away)
    distances: np.ndarray = least.max(axis=0)
    return distances


def _around(size: int) -> Iterator[tuple[float, np.ndarray]]:
    """Steps (n, 2) in pixels to rows and columns around a pixel, and the radius up to which all were taken before."""
    angle = 2 * np.pi * np.arange(_DIRECTIONS) / _DIRECTIONS
    directions = np.stack((np.sin(angle), np.cos(angle)), axis=1)
    radius = 1.0
    while radius < size:
        yield 0.0, np.unique(np.rint(radius * directions).astype(int), axis=0)
        radius *= _WIDER
    inner = 0
    while inner < size:
        outer = ceil(inner * _RING) + 1
        reach = np.arange(-outer, outer + 1)
        away = np.hypot(reach[:, None], reach)
        yield float(inner), np.argwhere((away > inner) & (away <= outer)) - outer
        inner = outer
