# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distance in space between two surfaces of an image, instead of the distance along the view."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from math import ceil, hypot

import numpy as np

# Accuracy: a distance larger by less than this share, or by less than a pixel, is not searched for.
_ALIKE = 0.02
# Spacing of the searched grids, pixels. A few pixels of a coarse grid exclude many pixels of the finer grids.
_GRIDS = (64, 16, 4, 1)
# Largest number of pixels searched at once, and of pairs with pixels around them, 50 bytes each.
_AT_ONCE, _PAIRS = 256, 500_000
# Sparse searches around a pixel: number of directions, and ratio of consecutive radii. The ratio of the last search is close to 1,
# so that it does not step over a pixel near enough to exclude the searched pixel.
_SPARSE = ((8, 2.0), (16, 1.2), (16, 1 + _ALIKE))
_RADII_AT_ONCE = (8, 64, 256)  # circles up to each of these radii, pixels, are searched in one step
# Complete search, ring by ring: ratio of consecutive radii, and radius at which the spacing of the searched pixels becomes 1 pixel.
_WIDTH, _FINE = 1.05, 64


def farthest(
    front: np.ndarray, behind: np.ndarray, pixels: np.ndarray, pixel: float, floor: float
) -> tuple[int, float] | None:
    """Return the pixel at which two surfaces are farthest from each other, and their distance there.

    The distance at a pixel is the larger of two: from the point of the rear surface to the space before the front surface, and
    from the point of the front surface to the space behind the rear surface (Hausdorff). So a wall cut 0.3 mm too far has a
    distance of 0.3 mm, whatever its height, and a missing hole has its depth, whatever its width. The distance is never larger
    than the distance along the view.

    Parameters
    ----------
    front, behind : (height, width) float32
        Depths of the two surfaces along the view, mm; infinite without a surface, so that the whole ray is before it.
    pixels : (k,) int
        Pixels to search, numbers in the flat image.
    pixel : float
        Side of a pixel, mm. The error of the distance is at most one pixel or 2 %.
    floor : float
        Only distances larger than this are searched for, mm.

    Returns
    -------
    tuple of int and float, or None
        Number of the pixel, and distance, mm. None if no distance exceeds `floor`.
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
                _exclude_around(unseen, front, behind, int(row[some[i]]), int(column[some[i]]), float(reach[i]), pixel)
    return found


def _exclude_around(
    unseen: np.ndarray, front: np.ndarray, behind: np.ndarray, row: int, column: int, reach: float, pixel: float
) -> None:
    """Exclude the pixels whose points on both surfaces are within `reach`, mm, of the points of one pixel.

    The distances of such pixels differ by at most `reach`.
    """
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
    """Return the distances at pixels (k,), mm. For a distance below the floor, the result is any value below the floor."""
    height, width = front.shape
    row, column = np.divmod(pixels, width)
    ahead, beyond = front[row, column], behind[row, column]
    # Smallest distances so far: to the space before the front surface, and to the space behind the rear surface.
    least = np.repeat((beyond - ahead)[None].astype(float), 2, axis=0)
    for radius, steps in _around(ceil(hypot(height, width))):
        # Stop at a pixel if pixels farther away cannot be nearer in space, or if its distance is below the floor.
        (searched,) = np.nonzero(least.max(axis=0) > max(floor, radius * pixel))
        if not len(searched):
            break
        for some in np.array_split(steps, ceil(len(searched) * len(steps) / _PAIRS)):
            rows, columns = row[searched, None] + some[:, 0], column[searched, None] + some[:, 1]
            # Outside the image, use the nearest pixel of the border. The border is closer, so an earlier step has already included it.
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
    """Yield steps (n, 2) to rows and columns around a pixel, pixels, and the radius inside which every pixel was yielded."""
    for directions, wider in _SPARSE:
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


@lru_cache(maxsize=len(_SPARSE))
def _circles(size: int, directions: int, wider: float) -> list[np.ndarray]:
    """Return the steps of circles, in groups of radii: small circles may end the search before the large ones."""
    radii = [1.0]
    while radii[-1] * wider < size:
        radii.append(max(radii[-1] * wider, radii[-1] + 1))
    angle = 2 * np.pi * np.arange(directions) / directions
    steps = np.rint(np.multiply.outer(radii, np.stack((np.sin(angle), np.cos(angle)), axis=1))).astype(int)
    return [np.concatenate(some) for some in np.split(steps, np.searchsorted(radii, _RADII_AT_ONCE)) if len(some)]
