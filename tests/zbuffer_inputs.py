# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tools, views, stocks and toolpaths for the tests of the z-buffer, and a comparison of whole arrays."""

from __future__ import annotations

from itertools import combinations
from math import pi, tan

import numpy as np

from vkworkbench.core import Stock, Tool, Toolpath
from vkworkbench.core import zbuffer as room
from vkworkbench.core.zbuffer import CrashCheck


def close(one, other, absolute, relative=0.0):
    """Return whether two arrays agree in shape, and everywhere within a tolerance.

    Whole arrays are compared, because pytest.approx would be slow.
    """
    return one.shape == other.shape and bool(
        (np.abs(one - other) <= np.maximum(absolute, relative * np.abs(other))).all()
    )


def facts(zbuffer, **arguments):
    """Return the facts (such as gouges) that the image shows, without a check of rapids on finer rays."""
    return room.facts(zbuffer, CrashCheck(), **arguments)


class ConvexStock(Stock):
    """A bounded solid with ``normals @ point <= offsets``: outward normals (m, 3) of any length, and offsets (m,)."""

    def __init__(self, normals: np.ndarray, offsets: np.ndarray) -> None:
        lengths = np.linalg.norm(normals, axis=1)
        planes = np.array(normals, float) / lengths[:, None], np.array(offsets, float) / lengths
        corners = _corners(*planes)
        super().__init__(corners.min(axis=0), corners.max(axis=0))
        self.normals, self.offsets = planes
        self.corners = corners

    @classmethod
    def cylinder(cls, base: np.ndarray, radius: float, height: float, sides: int = 64) -> ConvexStock:
        """Return a regular prism with the cross-section area of a vertical cylinder."""
        base = np.array(base, float)
        angles = 2 * pi * np.arange(sides) / sides
        walls = np.column_stack((np.cos(angles), np.sin(angles), np.zeros(sides)))
        # For a regular polygon of equal area, sides * tan(pi/sides) * apothem**2 = pi * radius**2.
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
    """Return the points of intersection of three planes that no other plane cuts off."""
    triples = np.array(list(combinations(range(len(normals)), 3)))
    matrices = normals[triples]
    proper = np.abs(np.linalg.det(matrices)) > 1e-9
    corners = np.linalg.solve(matrices[proper], offsets[triples[proper]][..., None])[..., 0]
    return corners[(corners @ normals.T <= offsets + 1e-9 * (1 + np.abs(offsets).max())).all(axis=1)]


def box(lower, upper):
    """Return the twelve triangles of a box."""
    corner = np.array([[(lower, upper)[bits >> axis & 1][axis] for axis in range(3)] for bits in range(8)], float)
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return np.array([corner[[a, b, c]] for a, b, c, d in faces for a, b, c in ((a, b, c), (a, c, d))])


def ball(middle, radius, parts=12):
    """Return the triangles of a polyhedron inscribed in a ball."""
    phi, theta = np.meshgrid(0.1 + np.linspace(0, 2 * pi, 2 * parts + 1), np.linspace(0, pi, parts + 1))
    at = np.stack((np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)), axis=-1) * radius + middle
    a, b, c, d = at[:-1, :-1], at[:-1, 1:], at[1:, :-1], at[1:, 1:]
    return np.concatenate((np.stack((a, b, c), 2).reshape(-1, 3, 3), np.stack((b, d, c), 2).reshape(-1, 3, 3)))


# A block of 25 x 30 x 10 mm with a cavity of 15 x 10 x 4 mm, and a second block at a distance of 5 mm.
HOLLOW = np.concatenate((box((0, 0, 0), (25, 30, 10)), box((5, 10, 3), (20, 20, 7)), box((30, 0, 0), (40, 30, 10))))


TOOLS = [
    Tool("endmill", 6),
    Tool("endmill", 14),
    Tool("ballend", 6),
    Tool("bullnose", 6, corner_radius=1),
    Tool("bullnose", 6, corner_radius=2.5),
    Tool("vbit", 6, tip_angle=pi / 2),
    Tool("vbit", 4, tip_angle=0.6),
    Tool("drill", 5),
]
# Cones with a flat tip, like chamfer mills and engravers.
CHAMFERS = [
    Tool("vbit", 6, tip_angle=pi / 2, tip_diameter=2),
    Tool("vbit", 5, tip_angle=0.7, tip_diameter=0.4),
    Tool("vbit", 6, tip_angle=2.6, tip_diameter=5.5),
]
# At least one tool of each shape; bull-nose tools with two corner radii, V-bits with and without a flat tip.
FORMS = [
    Tool("endmill", 6),
    Tool("ballend", 6),
    Tool("bullnose", 6, corner_radius=1),
    Tool("bullnose", 6, corner_radius=2.5),
    Tool("vbit", 6, tip_angle=pi / 2),
    Tool("vbit", 6, tip_angle=pi / 2, tip_diameter=2),
    Tool("drill", 5),
]
DIRECTIONS = [
    (0, 0, -1),
    (0, 0, 1),
    (0, 1, -1),
    (1, 1, -1),
    (0.1, 0.1, -1),
    (1, 0.5, -0.3),
    (1, -2, 1.5),
    (-0.4, 1, 0),
    (1, 0, 0),
]
BOX = Stock((0, 0, 0), (40, 30, 10))
ROUND = ConvexStock.cylinder((20, 15, 0), radius=15, height=9, sides=24)


toolpath = Toolpath.through


def free(rng, n):
    """Return random points in and around the stock."""
    return rng.uniform((-3, -3, 1), (43, 33, 12), (n + 1, 3))


def level(rng, n):
    """Return pairs of points at one height, with a plunge or a retract between the pairs."""
    points = free(rng, n)
    points[:, 2] = np.repeat(rng.uniform(2, 9, n), 2)[: n + 1]
    return points


def one_level(rng, n):
    """Return points in the plane of depth 0, at half the height of the stock."""
    points = free(rng, n)
    points[:, 2] = 5
    return points


def grid(rng, n):
    """Return points on even coordinates, where rays graze walls and floors."""
    points = np.round(free(rng, n) / 2) * 2
    return points[np.append(True, (np.diff(points, axis=0) != 0).any(axis=1))]


def plunges(rng, n):
    """Return random points in which every other move is vertical."""
    points = free(rng, n)
    points[1::2, :2] = points[:-1:2, :2][: len(points[1::2])]
    return points


def helix(rng, n):
    """Return a helix down through the stock."""
    angle = np.linspace(0, n / 6, n + 1)
    return np.column_stack((20 + 6 * np.cos(angle), 15 + 6 * np.sin(angle), np.linspace(11, 3, n + 1)))


def surface(rng, n):
    """Return a zigzag over a wavy surface."""
    rows = max(2, int(np.sqrt(n)))
    x, y = np.linspace(0, 40, rows), np.linspace(0, 30, rows)
    x = np.concatenate([x[:: 1 if k % 2 == 0 else -1] for k in range(rows)])
    y = np.repeat(y, rows)
    return np.column_stack((x, y, 7 + 3 * np.sin(x / 12) * np.cos(y / 15)))


def zigzag(rng, n):
    """Return a zigzag at one height."""
    y = np.repeat(np.linspace(0, 30, n // 2), 2)
    x = np.tile([5.0, 35.0, 35.0, 5.0], len(y))[: len(y)]
    return np.column_stack((x, y, np.full(len(y), rng.uniform(2, 8))))


PATHS = [free, level, one_level, grid, plunges, helix, surface, zigzag]
