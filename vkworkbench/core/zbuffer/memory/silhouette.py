# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much of an image a stock covers."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.hull import convex_hull
from vkworkbench.core.stocks import Mesh, Solid
from vkworkbench.core.view import Frame

# Rows of rays by which the area of a mesh is counted, and rays of each.
_RAYS = 64


def seen_box(stock: Solid, frame: Frame) -> tuple[np.ndarray, np.ndarray]:
    """Lower and upper corner, (2,) mm, of where an image shows the box around a stock; they cross where it does not."""
    half = np.array([frame.width, frame.height]) * frame.pixel / 2
    axes = np.array([frame.right, frame.up])
    middle = axes @ ((stock.lower + stock.upper) / 2 - frame.centre)
    extent = np.abs(axes) @ (stock.upper - stock.lower) / 2
    return np.maximum(-half, middle - extent), np.minimum(half, middle + extent)


def seen_areas(stock: Solid, frame: Frame, rng: np.random.Generator) -> tuple[float, float]:
    """How much of an image a stock covers.

    Parameters
    ----------
    stock : Solid
    frame : Frame
    rng : numpy.random.Generator
        For the rays by which a mesh is counted; others are known without.

    Returns
    -------
    covered, gaps : float
        Area of the image that its parts cover, and the gaps between these, mm^2: where several lie behind each other, as
        often.
    """
    if isinstance(stock, Mesh):
        return _mesh_areas(stock, frame, rng)
    points = (stock.corners - frame.centre) @ np.array([frame.right, frame.up]).T
    outline = convex_hull(points.tolist())
    for axis, pixels in enumerate((frame.width, frame.height)):
        for side in (-1, 1):
            outline = clip(outline, axis, side, pixels * frame.pixel / 2)
    return polygon_area(outline), 0.0


def _mesh_areas(mesh: Mesh, frame: Frame, rng: np.random.Generator) -> tuple[float, float]:
    """`seen_areas` of a mesh, from a ray in each of many cells: random ones, which no ribs of a mesh are in step with."""
    low, high = seen_box(mesh, frame)
    if not (low < high).all():
        return 0.0, 0.0
    side = (high - low) / _RAYS
    # In rows: a mesh is crossed row by row.
    y = low[1] + (np.arange(_RAYS) + rng.random(_RAYS)) * side[1]
    x = low[0] + (np.arange(_RAYS) + rng.random((_RAYS, _RAYS))) * side[0]
    spans = mesh.spans(frame, x.ravel(), np.repeat(y, _RAYS))
    gaps, area = len(spans.gaps.ray), float(side.prod())
    return (np.count_nonzero(spans.far > spans.near) + gaps) * area, gaps * area


def polygon_area(outline: list[list[float]]) -> float:
    """Area of a polygon given by its corners, positive counter-clockwise (the shoelace formula)."""
    return sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(outline, outline[1:] + outline[:1])) / 2


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
