# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the area of the image that the stock covers."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.hull import convex_hull
from vkworkbench.core.stocks import Mesh, Solid
from vkworkbench.core.view import Frame

# Number of rows of rays that sample the area of a mesh, and number of rays in each row.
_RAYS = 64


def seen_box(stock: Solid, frame: Frame) -> tuple[np.ndarray, np.ndarray]:
    """Return the lower and upper corner (2,) of the stock's bounding box in an image, mm.

    If ``lower > upper``, the stock is outside the image.
    """
    half = np.array([frame.width, frame.height]) * frame.pixel / 2
    axes = np.array([frame.right, frame.up])
    middle = axes @ ((stock.lower + stock.upper) / 2 - frame.centre)
    extent = np.abs(axes) @ (stock.upper - stock.lower) / 2
    return np.maximum(-half, middle - extent), np.minimum(half, middle + extent)


def seen_areas(stock: Solid, frame: Frame, rng: np.random.Generator) -> tuple[float, float]:
    """Return the area of an image that a stock covers, and the area in which rays cross gaps in the stock.

    Parameters
    ----------
    rng : numpy.random.Generator
        Random generator for the rays that sample a mesh. Only a stock that is a mesh needs the generator.

    Returns
    -------
    covered, gaps : float
        Area that the stock covers, and area of the gaps in the stock, mm^2. Where a ray crosses several parts of the
        stock or several gaps, each part and each gap is counted.
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
    """Return `seen_areas` for a mesh, estimated from one random ray in each cell of a grid.

    The rays are random, because a regular grid of rays could miss all ribs of a mesh with a regular structure.
    """
    low, high = seen_box(mesh, frame)
    if not (low < high).all():
        return 0.0, 0.0
    side = (high - low) / _RAYS
    # All rays in a row have the same y, because `Mesh.spans` processes rays row by row.
    y = low[1] + (np.arange(_RAYS) + rng.random(_RAYS)) * side[1]
    x = low[0] + (np.arange(_RAYS) + rng.random((_RAYS, _RAYS))) * side[0]
    spans = mesh.spans(frame, x.ravel(), np.repeat(y, _RAYS))
    gaps, area = len(spans.gaps.ray), float(side.prod())
    return (np.count_nonzero(spans.far > spans.near) + gaps) * area, gaps * area


def polygon_area(outline: list[list[float]]) -> float:
    """Return the area of a polygon (the shoelace formula), positive if its corners are counter-clockwise."""
    return sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(outline, outline[1:] + outline[:1])) / 2


def clip(outline: list[list[float]], axis: int, side: int, limit: float) -> list[list[float]]:
    """Return the part of a convex polygon with ``side * coordinate along axis <= limit``."""
    corners = []
    for p, q in zip(outline, outline[1:] + outline[:1]):
        here, there = limit - side * p[axis], limit - side * q[axis]
        if here >= 0:
            corners.append(p)
        if (here >= 0) != (there >= 0):
            share = here / (here - there)
            corners.append([a + share * (b - a) for a, b in zip(p, q)])
    return corners
