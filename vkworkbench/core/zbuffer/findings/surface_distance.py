# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the largest distance in space between two surfaces of an image, instead of the distance along the view."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from math import ceil, hypot

import numpy as np

# Relative error that is allowed in the result. A pixel is searched only if its distance along the view exceeds the
# largest distance found so far by more than this share, and by more than the side of a pixel.
_ALIKE = 0.02
# The pixels are searched in several passes, first only every 64th pixel in each direction, and finally all pixels. A
# few pixels of a coarse pass exclude many pixels of the later passes.
_GRIDS = (64, 16, 4, 1)
# _AT_ONCE: largest number of pixels that are searched in one batch. _PAIRS: largest number of pairs of a searched pixel
# and a pixel around it in one batch; each pair needs 50 bytes.
_AT_ONCE, _PAIRS = 256, 500_000
# Each of the three sparse searches examines pixels on circles around a pixel. A pair of numbers defines a search: the
# number of directions from the centre, and the ratio of consecutive radii. In the last sparse search, this ratio is
# close to 1, because pixels between two circles are skipped.
_SPARSE = ((8, 2.0), (16, 1.2), (16, 1 + _ALIKE))
_RADII_AT_ONCE = (8, 64, 256)  # radii, pixels, that divide the circles into batches
# Complete search around a pixel, ring by ring. _WIDTH: ratio of a ring's outer radius to its inner radius. _FINE: inner
# radius of a ring divided by the spacing of the pixels searched in the ring; the spacing is at least one pixel.
_WIDTH, _FINE = 1.05, 64


def farthest(
    front: np.ndarray, behind: np.ndarray, pixels: np.ndarray, pixel: float, floor: float
) -> tuple[int, float] | None:
    """Return the pixel at which two surfaces are farthest from each other in space, and the distance at this pixel.

    The distance at a pixel is the larger of two distances, as in the Hausdorff distance: the distance from the point on
    the rear surface to the space in front of the front surface, and the distance from the point on the front surface to
    the space behind the rear surface. For example, a wall that is cut 0.3 mm too far has a distance of 0.3 mm for any
    height of the wall, and a missing hole has its depth as the distance for any width of the hole. The distance is
    never larger than the distance along the view.

    Parameters
    ----------
    front, behind : (height, width) float32
        Depths of the front and rear surface along the view, mm. A ray without a surface has an infinite depth, so that
        the whole ray counts as the space in front of this surface.
    pixels : (k,) int
        Pixels to search, as indices row * width + column.
    pixel : float
        Side of a pixel, mm. The error of the distance is at most the side of a pixel or 2 % of the distance, whichever
        is larger.
    floor : float
        Lower bound, mm. Only distances above the lower bound are searched for.

    Returns
    -------
    tuple of int and float, or None
        Index row * width + column of the pixel, and distance, mm. The result is None if no distance exceeds `floor`.
    """
    row, column = np.divmod(pixels, front.shape[1])
    along = behind.ravel()[pixels] - front.ravel()[pixels]
    order = np.argsort(-along, kind="stable")
    unseen = np.zeros(front.shape, bool)
    unseen.ravel()[pixels[along > floor]] = True
    found = None
    for grid in (0, *_GRIDS):  # in pass 0, only the pixel with the largest distance along the view is searched
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
    """Exclude the pixels around a searched pixel at which the distance cannot exceed the largest distance found so far.

    A pixel is excluded if its points on both surfaces are at most `reach`, mm, away from the points of the searched
    pixel. Therefore the distance at an excluded pixel exceeds the distance at the searched pixel by at most `reach`.
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
    """Return the distance between the two surfaces at each of the pixels `pixels` (k,), mm.

    If the exact distance is below `floor`, the returned value is only known to be below `floor`.
    """
    height, width = front.shape
    row, column = np.divmod(pixels, width)
    ahead, beyond = front[row, column], behind[row, column]
    # Smallest distances found so far, in two rows: from the rear surface to the space in front of the front surface,
    # and from the front surface to the space behind the rear surface.
    least = np.repeat((beyond - ahead)[None].astype(float), 2, axis=0)
    for radius, steps in _around(ceil(hypot(height, width))):
        # The search around a pixel stops when pixels at a larger radius cannot reduce its distance, or when its
        # distance is below `floor`.
        (searched,) = np.nonzero(least.max(axis=0) > max(floor, radius * pixel))
        if not len(searched):
            break
        for some in np.array_split(steps, ceil(len(searched) * len(steps) / _PAIRS)):
            rows, columns = row[searched, None] + some[:, 0], column[searched, None] + some[:, 1]
            # A position outside the image is replaced by the nearest pixel of the border. The nearest pixel of the
            # border was already compared at its actual distance, which is smaller, so the replacement changes nothing.
            rows, columns = np.clip(rows, 0, height - 1), np.clip(columns, 0, width - 1)
            across = np.hypot(*some.T) * pixel
            to_front = beyond[searched, None] - front[rows, columns]
            to_behind = behind[rows, columns] - ahead[searched, None]
            for side, gap in enumerate((to_front, to_behind)):
                away = np.hypot(across, np.maximum(gap, 0)).min(axis=1)
                least[side, searched] = np.minimum(least[side, searched], away)
    return least.max(axis=0)


def _around(size: int) -> Iterator[tuple[float, np.ndarray]]:
    """Yield batches of steps (n, 2) from a pixel to pixels around it, in rows and columns, each with a radius, pixels.

    All steps that are shorter than the radius were yielded in earlier batches.
    """
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
    """Return the steps from a pixel to the pixels on circles around it, in batches with growing radii."""
    radii = [1.0]
    while radii[-1] * wider < size:
        radii.append(max(radii[-1] * wider, radii[-1] + 1))
    angle = 2 * np.pi * np.arange(directions) / directions
    steps = np.rint(np.multiply.outer(radii, np.stack((np.sin(angle), np.cos(angle)), axis=1))).astype(int)
    return [np.concatenate(some) for some in np.split(steps, np.searchsorted(radii, _RADII_AT_ONCE)) if len(some)]
