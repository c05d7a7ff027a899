# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tools, views, stocks and random toolpaths for the tests of the z-buffer."""

from __future__ import annotations

from math import pi

import numpy as np
from zbuffer_reference.convex import ConvexStock

from vkworkbench.core import Stock, Tool, Toolpath

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
# One of each form, and of rims and tips, of a size.
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
    return rng.uniform((-3, -3, 1), (43, 33, 12), (n + 1, 3))


def level(rng, n):
    points = free(rng, n)
    points[:, 2] = np.repeat(rng.uniform(2, 9, n), 2)[: n + 1]
    return points


def one_level(rng, n):
    """At half the height of the stock, where depths are 0."""
    points = free(rng, n)
    points[:, 2] = 5
    return points


def grid(rng, n):
    """On round numbers, where rays graze walls and floors."""
    points = np.round(free(rng, n) / 2) * 2
    return points[np.append(True, (np.diff(points, axis=0) != 0).any(axis=1))]


def plunges(rng, n):
    points = free(rng, n)
    points[1::2, :2] = points[:-1:2, :2][: len(points[1::2])]
    return points


def helix(rng, n):
    angle = np.linspace(0, n / 6, n + 1)
    return np.column_stack((20 + 6 * np.cos(angle), 15 + 6 * np.sin(angle), np.linspace(11, 3, n + 1)))


def surface(rng, n):
    rows = max(2, int(np.sqrt(n)))
    x, y = np.linspace(0, 40, rows), np.linspace(0, 30, rows)
    x = np.concatenate([x[:: 1 if k % 2 == 0 else -1] for k in range(rows)])
    y = np.repeat(y, rows)
    return np.column_stack((x, y, 7 + 3 * np.sin(x / 12) * np.cos(y / 15)))


def zigzag(rng, n):
    y = np.repeat(np.linspace(0, 30, n // 2), 2)
    x = np.tile([5.0, 35.0, 35.0, 5.0], len(y))[: len(y)]
    return np.column_stack((x, y, np.full(len(y), rng.uniform(2, 8))))


PATHS = [free, level, one_level, grid, plunges, helix, surface, zigzag]
