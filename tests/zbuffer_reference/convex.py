# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stocks of any planes: wedges and prisms, whose volumes, silhouettes and chords are worked out by hand."""

from __future__ import annotations

from itertools import combinations
from math import pi, tan

import numpy as np

from vkworkbench.core import Stock


class ConvexStock(Stock):
    """A bounded solid, where ``normals @ point <= offsets``: outward normals (m, 3) of any length, and (m,) numbers."""

    def __init__(self, normals: np.ndarray, offsets: np.ndarray) -> None:
        lengths = np.linalg.norm(normals, axis=1)
        planes = np.array(normals, float) / lengths[:, None], np.array(offsets, float) / lengths
        corners = _corners(*planes)
        super().__init__(corners.min(axis=0), corners.max(axis=0))
        self.normals, self.offsets = planes
        self.corners = corners

    @classmethod
    def cylinder(cls, base: np.ndarray, radius: float, height: float, sides: int = 64) -> ConvexStock:
        """Return a vertical cylinder as a regular prism of the same cross-section."""
        base = np.array(base, float)
        angles = 2 * pi * np.arange(sides) / sides
        walls = np.column_stack((np.cos(angles), np.sin(angles), np.zeros(sides)))
        # The regular polygon of equal area: sides * tan(pi/sides) * apothem**2 = pi * radius**2.
        apothem = radius * np.sqrt(pi / (sides * tan(pi / sides)))
        normals = np.vstack((walls, [[0, 0, 1], [0, 0, -1]]))
        return cls(normals, np.concatenate((walls @ base + apothem, [base[2] + height, -base[2]])))

    def chords(self, origins: np.ndarray, direction: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """See `Stock.chords`."""
        near, far = np.full(len(origins), -np.inf), np.full(len(origins), np.inf)
        for normal, offset in zip(self.normals, self.offsets):
            room, slope = offset - origins @ normal, float(direction @ normal)
            if abs(slope) < 1e-12:
                far[room < 0] = -np.inf
            elif slope > 0:
                far = np.minimum(far, room / slope)
            else:
                near = np.maximum(near, room / slope)
        return near, far


def _corners(normals: np.ndarray, offsets: np.ndarray) -> np.ndarray:
    """Where three planes meet, none of the others being before it."""
    triples = np.array(list(combinations(range(len(normals)), 3)))
    matrices = normals[triples]
    proper = np.abs(np.linalg.det(matrices)) > 1e-9
    corners = np.linalg.solve(matrices[proper], offsets[triples[proper]][..., None])[..., 0]
    return corners[(corners @ normals.T <= offsets + 1e-9 * (1 + np.abs(offsets).max())).all(axis=1)]
