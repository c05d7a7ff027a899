# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much of an image a stock covers."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.solids import Frame
from vkworkbench.core.stocks import Mesh, Solid


def silhouette_area(stock: Solid, frame: Frame) -> float:
    """Area of the image a stock covers, mm^2; where a mesh covers it several times, as often.

    Parameters
    ----------
    stock : Solid
    frame : Frame
        Whose image holds a mesh as a whole.
    """
    if isinstance(stock, Mesh):
        return stock.seen_area(frame)
    points = (stock.corners - frame.centre) @ np.array([frame.right, frame.up]).T
    outline = _convex_hull(points.tolist())
    for axis, pixels in enumerate((frame.width, frame.height)):
        for side in (-1, 1):
            outline = clip(outline, axis, side, pixels * frame.pixel / 2)
    return polygon_area(outline)


def polygon_area(outline: list[list[float]]) -> float:
    """Area of a polygon given by its corners, positive counter-clockwise (the shoelace formula)."""
    return sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(outline, outline[1:] + outline[:1])) / 2


def _convex_hull(points: list[list[float]]) -> list[list[float]]:
    """Corners of the convex hull, counter-clockwise (Andrew's monotone chain)."""
    points = sorted(points)
    hull: list[list[float]] = []
    for chain in (points, points[::-1]):
        begin = len(hull)
        for p in chain:
            while len(hull) - begin >= 2 and _turn(hull[-2], hull[-1], p) <= 0:
                hull.pop()
            hull.append(p)
        hull.pop()
    return hull


def _turn(a: list[float], b: list[float], c: list[float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def clip(outline: list[list[float]], axis: int, side: int, limit: float) -> list[list[float]]:
    """The part of a convex polygon where ``side * coordinate <= limit``."""
    corners = []
    for p, q in zip(outline, outline[1:] + outline[:1]):
        here, there = limit - side * p[axis], limit - side * q[axis]
        if here >= 0:
            corners.append(p)
        if (here >= 0) != (there >= 0):
            share = here / (here - there)
            corners.append([a + share * (b - a) for a, b in zip(p, q)])
    return corners
