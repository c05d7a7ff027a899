# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much of an image a stock covers."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.solids import ConvexStock, Frame, Stock


def silhouette_area(stock: Stock | ConvexStock, frame: Frame) -> float:
    """Area of the image a convex stock covers, mm^2.

    Parameters
    ----------
    stock : Stock or ConvexStock
    frame : Frame
    """
    points = (stock.corners - frame.centre) @ np.array([frame.right, frame.up]).T
    outline = _convex_hull(points)
    half = np.array([frame.width, frame.height]) * frame.pixel / 2
    for axis in (0, 1):
        for side in (-1, 1):
            outline = _clip(outline, half[axis] - side * outline[:, axis])
    x, y = outline.T
    return float(abs(np.roll(x, -1) @ y - x @ np.roll(y, -1)) / 2)


def _convex_hull(points: np.ndarray) -> np.ndarray:
    """Corners of the convex hull (m, 2), counter-clockwise (Andrew's monotone chain)."""
    ordered = sorted(map(tuple, points))
    hull: list[tuple[float, float]] = []
    for chain in (ordered, ordered[::-1]):
        begin = len(hull)
        for p in chain:
            while len(hull) - begin >= 2 and _turn(hull[-2], hull[-1], p) <= 0:
                hull.pop()
            hull.append(p)
        hull.pop()
    return np.array(hull)


def _turn(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _clip(outline: np.ndarray, inside: np.ndarray) -> np.ndarray:
    """The part of a convex polygon (m, 2) where `inside`, linear over the plane and given at its corners, is >= 0."""
    following, inside_following = np.roll(outline, -1, axis=0), np.roll(inside, -1)
    corners = []
    for p, q, i, j in zip(outline, following, inside, inside_following):
        if i >= 0:
            corners.append(p)
        if (i >= 0) != (j >= 0):
            corners.append(p + (q - p) * i / (i - j))
    return np.array(corners).reshape(-1, 2)
