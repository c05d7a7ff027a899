# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far two surfaces that an image sees are from each other, in space and not only along the view."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from math import ceil, hypot

import numpy as np

# What is farther by less than this share, or than a pixel, is not told apart.
_ALIKE = 0.02
# Pixels are looked at on ever finer grids, pixels: few of the coarse ones tell which of the others need no search.
_GRIDS = (64, 16, 4, 1)
# So many at once, at most, with so many pairs of these and of pixels around them: 50 bytes each.
_AT_ONCE, _PAIRS = 256, 500_000
# The first looks around a pixel: in so many directions, the next circle so many times as large. The last look does not step
# over what tells that a pixel is not farther than what was found.
_LOOKS = ((8, 2.0), (16, 1.2), (16, 1 + _ALIKE))
_TOGETHER = (8, 64, 256)  # circles up to these radii are looked at together
# Then all around it, ring by ring, each so much wider; one pixel in so many of the radius is enough.
_WIDTH, _FINE = 1.05, 64


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
        Side of a pixel, mm; the distance is exact to within one, or a fiftieth.
    floor : float
        mm; what is no farther is not looked for.

    Returns
    -------
    tuple of int and float, or None
        Its number, and mm. None where they are nowhere farther than `floor`.
    """
    row, column = np.divmod(pixels, front.shape[1])
    along = behind.ravel()[pixels] - front.ravel()[pixels]
    order = np.argsort(-along, kind="stable")
    unseen = np.zeros(front.shape, bool)
    unseen.ravel()[pixels[along > floor]] = True
    found = None
    for grid in (0, *_GRIDS):  # first the pixel that is farthest along the view
        on_grid = order[(row[order] % grid == 0) & (column[order] % grid == 0)] if grid else order[:1]
        for first in range(0, len(on_grid), _AT_ONCE):
            some = on_grid[first : first + _AT_ONCE]
            some = some[unseen[row[some], column[some]] & (along[some] > floor)]
            if not len(some):
                continue
            distances = _distances(front, behind, pixels[some], pixel, floor)
            most = int(distances.argmax())
            if distances[most] > floor:
                found = int(pixels[some[most]]), float(distances[most])
                floor = found[1] + max(pixel, _ALIKE * found[1])
            unseen[row[some], column[some]] = False
            reach = floor - distances
            for i in np.flatnonzero(reach >= 2 * pixel):
                _leave_out(unseen, front, behind, int(row[some[i]]), int(column[some[i]]), float(reach[i]), pixel)
    return found


def _leave_out(
    unseen: np.ndarray, front: np.ndarray, behind: np.ndarray, row: int, column: int, reach: float, pixel: float
) -> None:
    """Leave out the pixels whose surfaces lie within the reach, mm, of those of one: so much their distances differ at most."""
    size = int(reach / pixel)
    rows = slice(max(row - size, 0), min(row + size + 1, len(front)))
    columns = slice(max(column - size, 0), min(column + size + 1, front.shape[1]))
    away_row, away_column = np.ogrid[rows, columns]
    across = pixel**2 * ((away_row - row) ** 2 + (away_column - column) ** 2)
    near = np.ones(across.shape, bool)
    for surface in (front, behind):
        near &= across + (surface[rows, columns] - surface[row, column]) ** 2 <= reach**2
    unseen[rows, columns] &= ~near


def _distances(front: np.ndarray, behind: np.ndarray, pixels: np.ndarray, pixel: float, floor: float) -> np.ndarray:
    """Distances at pixels (k,), mm; where one is no more than the floor, something that is not, either."""
    height, width = front.shape
    row, column = np.divmod(pixels, width)
    ahead, beyond = front[row, column], behind[row, column]
    # To what lies before the front, and to what lies behind the surface behind.
    least = np.repeat((beyond - ahead)[None].astype(float), 2, axis=0)
    for radius, steps in _around(ceil(hypot(height, width))):
        # Nothing that is farther away is nearer, and what is near enough is not looked for.
        (searched,) = np.nonzero(least.max(axis=0) > max(floor, radius * pixel))
        if not len(searched):
            break
        for some in np.array_split(steps, ceil(len(searched) * len(steps) / _PAIRS)):
            rows, columns = row[searched, None] + some[:, 0], column[searched, None] + some[:, 1]
            # Outside the image a pixel of its border stands in, which lies nearer than that and is looked at before.
            rows, columns = np.clip(rows, 0, height - 1), np.clip(columns, 0, width - 1)
            across = np.hypot(*some.T) * pixel
            to_front = beyond[searched, None] - front[rows, columns]
            to_behind = behind[rows, columns] - ahead[searched, None]
            for side, gap in enumerate((to_front, to_behind)):
                away = np.hypot(across, np.maximum(gap, 0)).min(axis=1)
                least[side, searched] = np.minimum(least[side, searched], away)
    distances: np.ndarray = least.max(axis=0)
    return distances


def _around(size: int) -> Iterator[tuple[float, np.ndarray]]:
    """Steps (n, 2) in pixels to rows and columns around a pixel, and the radius up to which all were taken before."""
    for directions, wider in _LOOKS:
        for circles in _circles(size, directions, wider):
            yield 0.0, circles
    inner = 0
    while inner < size:
        step = max(1, inner // _FINE)
        outer = step * (ceil(inner * _WIDTH / step) + 1)
        reach = np.arange(-outer, outer + 1, step)
        away = np.hypot(reach[:, None], reach)
        yield float(inner), step * np.argwhere((away > inner) & (away <= outer)) - outer
        inner = outer


@lru_cache(maxsize=len(_LOOKS))
def _circles(size: int, directions: int, wider: float) -> list[np.ndarray]:
    """Steps of circles, some circles at once: near ones spare what is near the far ones."""
    radii = [1.0]
    while radii[-1] * wider < size:
        radii.append(max(radii[-1] * wider, radii[-1] + 1))
    angle = 2 * np.pi * np.arange(directions) / directions
    steps = np.rint(np.multiply.outer(radii, np.stack((np.sin(angle), np.cos(angle)), axis=1))).astype(int)
    return [np.concatenate(some) for some in np.split(steps, np.searchsorted(radii, _TOGETHER)) if len(some)]
