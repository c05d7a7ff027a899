# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw a stratified random sample of the pixels that swept volumes reach, and estimate totals from this sample."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.zbuffer.memory.silhouette import seen_box
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.sweeps.trajectories import AT_ONCE

_CELLS = 32  # number of cells in a row and in a column; the Morton order requires a power of 2
_CORNERS = _CELLS + 1  # number of cell corners in a row
# Upper and lower limit of the number of rays in the sample. Between both limits, the number of rays is chosen so that
# about `_MEETINGS` pairs of a sampled ray and a trajectory meet.
_RAYS = 450
_FEWEST = 100
_MEETINGS = 150_000


@dataclass(frozen=True, eq=False)
class Sample:
    """Sampled rays, sorted by stratum, with the area of the image that each ray represents.

    Attributes
    ----------
    x, y : (k,) float64
        Image coordinates of the rays, mm. Each ray runs through the centre of a pixel.
    area : (k,) float64
        Area of the image that each ray represents, mm^2. The sum of a quantity times `area` over all rays estimates the
        quantity's integral over the image.
    """

    x: np.ndarray
    y: np.ndarray
    area: np.ndarray

    def total(self, values: np.ndarray) -> tuple[float, float]:
        """Return the integral of a quantity over the image, and its standard error.

        The variance is estimated from differences between neighbouring strata, because each stratum contains only one
        ray. The returned error tends to be too large, because the means of neighbouring strata differ too.

        Parameters
        ----------
        values : (k,) ndarray
            The quantity on each ray.

        Returns
        -------
        total, error : float
            The integral and its standard error, both in mm^2 times the unit of the values.
        """
        shares = values * self.area
        k = len(shares)
        if k < 2:
            return float(shares.sum()), float(np.abs(shares).sum())
        return float(shares.sum()), float(np.sqrt((np.diff(shares) ** 2).sum() / 2 * k / (k - 1)))


def _morton_order() -> np.ndarray:
    """Return the cells' indices row * _CELLS + column, sorted by Morton key (interleaved bits of row and column)."""
    row, column = np.divmod(np.arange(_CELLS**2), _CELLS)
    key = np.zeros(_CELLS**2, np.int64)
    for bit in range(_CELLS.bit_length() - 1):
        key |= ((column >> bit) & 1) << (2 * bit) | ((row >> bit) & 1) << (2 * bit + 1)
    return np.argsort(key)


_ORDER = _morton_order()
_NOWHERE = Sample(*np.empty((3, 0)))


def sample(removal: Removal, rng: np.random.Generator) -> Sample:
    """Draw up to `_RAYS` rays in the part of the image that swept volumes reach, one ray in each stratum.

    The part of the image that swept volumes reach is divided into cells. The weight of a cell is the square root of the
    number of trajectories whose bounding boxes touch the cell, because the number of dexels and trace elements varies
    more in cells with more trajectories. The strata are stretches of equal weight along a Morton curve (Morton 1966), a
    path through all cells on which neighbouring cells are close to each other. In each stratum, one random point is
    drawn, and the pixel that contains the point gives the ray. Therefore a slot narrower than a pixel has the same
    probability to be hit as in the simulated image.

    Returns
    -------
    Sample
        The sample is empty if no swept volume reaches the image.
    """
    frame = removal.frame
    if len(removal.index) == 0:
        return _NOWHERE
    half = np.array([frame.width, frame.height]) * frame.pixel / 2
    margin = frame.pixel / 2  # a swept volume that reaches a pixel's centre counts as reaching the whole pixel
    low, high = seen_box(removal.stock, frame)
    low = np.maximum(-half, np.maximum(low, removal.box[::2].min(axis=1)) - margin)
    high = np.minimum(half, np.minimum(high, removal.box[1::2].max(axis=1)) + margin)
    if not (low < high).all():
        return _NOWHERE
    side = (high - low) / _CELLS
    passes = _count_passes(removal, low, side).ravel()
    weight = np.sqrt(passes)
    if not weight.any():
        return _NOWHERE
    running = np.cumsum(weight[_ORDER])
    rays = int(np.clip(_MEETINGS * running[-1] / (weight @ passes), _FEWEST, _RAYS))
    at = (np.arange(rays) + rng.random(rays)) / rays * running[-1]
    cell = _ORDER[np.searchsorted(running[:-1], at, side="right")]
    row, column = np.divmod(cell, _CELLS)
    x = low[0] + (column + rng.random(rays)) * side[0]
    y = low[1] + (row + rng.random(rays)) * side[1]
    x, y = frame.pixel_centres(
        np.floor(x / frame.pixel + frame.width / 2), np.floor(y / frame.pixel + frame.height / 2)
    )
    area = side.prod() * running[-1] / (rays * weight[cell])
    return Sample(x, y, area)


def _count_passes(removal: Removal, low: np.ndarray, side: np.ndarray) -> np.ndarray:
    """Return how many bounding boxes of trajectories touch each cell of the image, (rows, columns).

    Each box is enlarged by half a pixel. Long trajectories are divided into parts, and each part has its own box.
    """
    total = len(removal.index)
    counts = np.zeros(_CORNERS**2)
    for begin in range(0, total, AT_ONCE):
        corner, sign = _corners(removal, np.arange(begin, min(begin + AT_ONCE, total)), low[:, None], side[:, None])
        counts += np.bincount(corner, sign, _CORNERS**2)
    return np.rint(counts.reshape(_CORNERS, _CORNERS).cumsum(axis=0).cumsum(axis=1)[:-1, :-1])


def _corners(removal: Removal, item: np.ndarray, low: np.ndarray, side: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the corners of the trajectories' bounding boxes, as indices of cell corners, and +1 or -1 for each corner.

    The sum of the numbers at all corners to the left of a cell and below it is the number of boxes that touch the cell.
    """
    move = removal.move.take(item, axis=1)
    seen = np.array((move[0], removal.cosine * move[1] + removal.sine * move[2]))
    parts = np.ceil((np.abs(seen) / side).max(axis=0) / 4).astype(np.int64)
    parts = np.minimum(np.maximum(parts, 1), _CELLS)
    place = np.arange(parts.sum()) - np.repeat(np.cumsum(parts) - parts, parts)
    item, parts = np.repeat(item, parts), np.repeat(parts, parts)
    box = removal.boxes(item, place / parts, (place + 1) / parts)
    lower, upper = box[::2] - removal.frame.pixel / 2, box[1::2] + removal.frame.pixel / 2
    first, last = np.floor((lower - low) / side), np.floor((upper - low) / side)
    # In a view from the side, a part of a move above the stock has an empty box, whose last cell has a lower index than
    # its first cell.
    inside = ((last >= np.maximum(first, 0)) & (first < _CELLS)).all(axis=0)
    c0, r0 = np.maximum(first[:, inside], 0).astype(np.int64)
    c1, r1 = np.minimum(last[:, inside], _CELLS - 1).astype(np.int64) + 1
    # The caller sums the numbers +1 and -1 along rows and columns to get the number of boxes that touch each cell.
    corner = np.concatenate((r0 * _CORNERS + c0, r1 * _CORNERS + c1, r0 * _CORNERS + c1, r1 * _CORNERS + c0))
    return corner, np.repeat([1.0, 1.0, -1.0, -1.0], len(c0))
