# SPDX-License-Identifier: LGPL-2.1-or-later
"""Group pieces of the toolpath by their footprints, which are their bounding boxes and lengths in the plane.

Two pieces with equal footprints cover the same ground, seen from above, at any depth.
"""

from __future__ import annotations

import numpy as np

from vkworkbench.core.paper import OFF_ROUND
from vkworkbench.core.recognition.patterns.pieces import Pieces
from vkworkbench.core.recognition.thresholds import ROUNDING

_PRIMES = (73856093, 19349663, 83492791, 49979687, 86028121)


def footprints(pieces: Pieces, index: np.ndarray) -> tuple[np.ndarray, int]:
    """Group the pieces that have equal bounding boxes and equal lengths, and so cover the same ground.

    Boxes and lengths are rounded to a grid, and the rounded numbers are hashed, so that no two pieces need be compared
    with each other.

    Parameters
    ----------
    pieces : Pieces
    index : (k,) int
        Indices of the pieces to group.

    Returns
    -------
    group : (k,) int
    groups : int
        Number of different footprints.
    """
    # The sides of a piece's box, and a quarter of its length, are rounded to the same grid. A quarter of a square's
    # perimeter is as long as the square's side, so the rounding suits both.
    measures = np.column_stack([pieces.box[index], pieces.length[index] / 4])
    key = np.floor(measures / ROUNDING.GROUND + OFF_ROUND).astype(np.int64)
    key = (key * _PRIMES).sum(axis=1)
    unique, group = np.unique(key, return_inverse=True)
    return group.ravel(), len(unique)


def come_again(pieces: Pieces, index: np.ndarray) -> tuple[np.ndarray, int]:
    """Return whether each piece is repeated at another depth, and the number of different footprints."""
    if not len(index):
        return np.zeros(0, bool), 0
    group, distinct = footprints(pieces, index)
    z = pieces.z[index]
    lowest, highest = np.full(distinct, np.inf), np.full(distinct, -np.inf)
    np.minimum.at(lowest, group, z)
    np.maximum.at(highest, group, z)
    return (highest - lowest > ROUNDING.HEIGHT)[group], distinct


def count_depths(z: np.ndarray) -> int:
    """Count the different heights in the array z (k,), mm."""
    if not len(z):
        return 0
    if np.ptp(z) <= ROUNDING.HEIGHT:
        return 1
    z = np.sort(z)
    return 1 + int((z[1:] - z[:-1] > ROUNDING.HEIGHT).sum())


def number_depths(z: np.ndarray) -> np.ndarray:
    """Return the index of the depth for each height in the array z (k,), mm, where 0 is the lowest depth, (k,) int."""
    order = np.argsort(z)
    number = np.zeros(len(z), np.int64)
    number[order[1:]] = np.cumsum(z[order][1:] - z[order][:-1] > ROUNDING.HEIGHT)
    return number
