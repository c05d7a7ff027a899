# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define stocks and models that are not boxes: upright cylinders, and closed meshes of triangles."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from math import pi
from typing import Union

import numpy as np

from vkworkbench.core.solids import Convex, Gaps, Spans, Stock, point
from vkworkbench.core.toolpath import COORDINATE_LIMIT
from vkworkbench.core.view import Frame, View
from vkworkbench.given import number, numbers, of_kind
from vkworkbench.language import Message, Unusable

# Grid to which corners of a mesh are rounded before equal corners are merged, mm.
_SAME = 1e-6
_AROUND = 64
# Number of different y coordinates of rays for each strip into which `_crossings` divides the rays.
_ROWS = 256


class Cylinder(Convex):
    """An upright cylinder.

    Parameters
    ----------
    base : (3,) array_like
        Centre of the lower face, mm.
    radius, height : float
        mm.

    Attributes
    ----------
    lower, upper : (3,) ndarray
        Corners of the bounding box, mm. `normals` and `offsets` also describe the bounding box.
    corners : (c, 3) ndarray
        Points on the circular edges of the lower and the upper face, mm.

    Raises
    ------
    Unusable
        If a number is not finite, a coordinate of the cylinder is larger than a kilometre, or the cylinder has no
        volume.
    ValueError, TypeError
        If `base` is not three numbers, or a length is not a number.
    """

    def __init__(self, base: np.ndarray, radius: float, height: float) -> None:
        base = point("base", base)
        radius, height = (
            number(name, given, "a number of mm") for name, given in (("radius", radius), ("height", height))
        )
        box = Stock(base - [radius, radius, 0], base + [radius, radius, height])
        self.base, self.radius, self.height = base, radius, height
        self.lower, self.upper, self.normals, self.offsets = box.lower, box.upper, box.normals, box.offsets
        angle = 2 * pi * np.arange(_AROUND) / _AROUND
        rim = base + radius * np.column_stack((np.cos(angle), np.sin(angle), np.zeros(_AROUND)))
        self.corners = np.concatenate((rim, rim + [0, 0, height]))

    def __repr__(self) -> str:
        return f"Cylinder({self.base.tolist()}, {self.radius:g}, {self.height:g})"

    def chords(self, origins: np.ndarray, direction: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """See `Convex.chords`."""
        x, y, z = (origins - self.base).T
        dx, dy, dz = direction.tolist()
        near, far = np.full(len(x), -np.inf), np.full(len(x), np.inf)
        if dz:
            a, b = -z / dz, (self.height - z) / dz
            near, far = np.minimum(a, b), np.maximum(a, b)
        else:
            far[(z < 0) | (z > self.height)] = -np.inf
        square = dx * dx + dy * dy
        if square < 1e-18:
            far[x * x + y * y > self.radius**2] = -np.inf
            return near, far
        middle = -(x * dx + y * dy) / square
        half2 = self.radius**2 - (x * dy - y * dx) ** 2 / square
        half = np.sqrt(np.maximum(half2, 0) / square)
        near, far = np.maximum(near, middle - half), np.minimum(far, middle + half)
        far[half2 < 0] = -np.inf
        return near, far


class Mesh:
    """A solid bounded by triangles; holes and undercuts are allowed.

    A point is inside if a ray to it has crossed an odd number of triangles (even-odd rule), so the order of a triangle's
    corners does not matter.

    Parameters
    ----------
    triangles : (t, 3, 3) array_like
        Corners of each triangle, mm; corners that are equal when rounded to 1e-6 mm are merged.

    Attributes
    ----------
    lower, upper : (3,) ndarray
        Corners of the bounding box, mm. `normals` and `offsets` also describe the bounding box.
    corners : (c, 3) ndarray
        Distinct corners of the triangles, mm.
    triangles : (t, 3) ndarray of int
        Indices of each triangle's corners in `corners`.

    Raises
    ------
    Unusable
        If a coordinate is larger than a kilometre, the triangles do not close, or every triangle is a line or a point.
    ValueError, TypeError
        If `triangles` is not an array of triples of points.
    """

    def __init__(self, triangles: np.ndarray) -> None:
        takes = "an array of (t, 3, 3) numbers, the coordinates of corners in mm"
        points = np.array(numbers("triangles", triangles, takes, lambda array: array.size % 9 == 0)).reshape(-1, 3)
        # Coordinates that are NaN are also refused, because comparisons with NaN are false.
        if not (np.abs(points) <= COORDINATE_LIMIT).all():
            raise Unusable(Message("stock-not-finite"))
        first, corner = _distinct(np.rint(points / _SAME).astype(np.int64))
        self.corners, corner = points[first], corner.reshape(-1, 3)
        proper = (corner[:, 0] != corner[:, 1]) & (corner[:, 1] != corner[:, 2]) & (corner[:, 2] != corner[:, 0])
        self.triangles = corner[proper]
        if len(self.triangles) == 0:
            raise Unusable(Message("stock-without-volume"))
        edges = np.sort(np.concatenate([self.triangles[:, [a, b]] for a, b in ((0, 1), (1, 2), (2, 0))]), axis=1)
        _, count = np.unique(edges[:, 0] * len(self.corners) + edges[:, 1], return_counts=True)
        if (count % 2).any():
            raise Unusable(Message("solid-not-closed"))
        self.lower, self.upper = self.corners.min(axis=0), self.corners.max(axis=0)
        self.normals = np.vstack((np.eye(3), -np.eye(3)))
        self.offsets = np.concatenate((self.upper, -self.lower))

    def spans(self, frame: Frame, x: np.ndarray, y: np.ndarray) -> Spans:
        """See `Convex.spans`."""
        return _SeenMesh(self, frame).spans(x, y)


def _distinct(rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the first position of each distinct row of integers, in sorted order, and each row's index in that order.

    `np.unique` with `axis=0` returns the same result, but takes several times as long.
    """
    order = np.lexsort(rows.T[::-1])
    new = np.ones(len(rows), bool)
    new[1:] = (np.diff(rows[order], axis=0) != 0).any(axis=1)
    number = np.empty(len(rows), np.int64)
    number[order] = np.cumsum(new) - 1
    return order[new], number


class _SeenMesh:
    """A mesh in the coordinates of an image.

    The corners of each triangle are sorted from the lowest to the highest in the image.

    Attributes
    ----------
    low, high : (3, t) ndarray
        Lower and upper corner of each triangle's bounding box: image coordinates and depth, mm.
    edges : (3, t, 3) ndarray
        The edges from the lowest to the highest, from the lowest to the middle, and from the middle to the highest
        corner; see `_edge`.
    corner : (3, t) ndarray
        The lowest corner of each triangle, mm.
    slope : (2, t) ndarray
        Slopes of the depth along x and y; 0 for a triangle that is parallel to the rays.
    """

    def __init__(self, mesh: Mesh, frame: Frame) -> None:
        axes = np.array([frame.right, frame.up, frame.direction])
        points = (mesh.corners - frame.centre) @ axes.T
        rank = np.empty(len(points), np.int64)
        rank[np.lexsort((points[:, 0], points[:, 1]))] = np.arange(len(points))
        triangles = np.take_along_axis(mesh.triangles, np.argsort(rank[mesh.triangles], axis=1), axis=1)
        a, b, c = (points[triangles[:, k]].T for k in range(3))
        self.low, self.high = np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)
        self.edges = np.stack([_edge(a, c), _edge(a, b), _edge(b, c)])
        self.corner = a
        normal = np.cross(b - a, c - a, axis=0)
        parallel = normal[2] == 0
        normal[2, parallel] = 1
        self.slope = -normal[:2] / normal[2]
        self.slope[:, parallel] = 0

    def spans(self, x: np.ndarray, y: np.ndarray) -> Spans:
        """See `Convex.spans`."""
        ray, depth = self._crossings(x, y)
        order = np.lexsort((depth, ray))
        ray, depth = ray[order], depth[order]
        near, far = np.zeros((2, len(x)))
        first = np.flatnonzero(np.diff(ray, prepend=-1))
        end = np.append(first[1:], len(ray))[: len(first)]
        near[ray[first]], far[ray[first]] = depth[first], depth[end - 1]
        # A ray is alternately inside and outside the solid, so every second stretch is outside.
        number = np.arange(len(ray)) - np.repeat(first, end - first)
        outside = np.flatnonzero((number[:-1] % 2 == 1) & (ray[1:] == ray[:-1]))
        return Spans(near, far, Gaps(ray[outside], depth[outside], depth[outside + 1]))

    def _crossings(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return rays and the depths at which they cross triangles, unordered.

        Rays with many different y coordinates are divided, by their x coordinates, into strips, because most triangles
        overlap only a few strips.
        """
        strips = 1 + len(np.unique(y)) // _ROWS
        if strips == 1:
            return self._crossings_by_row(x, y)
        rays, depths = [], []
        for strip in np.array_split(np.argsort(x), strips):
            ray, depth = self._crossings_by_row(x[strip], y[strip])
            rays.append(strip[ray])
            depths.append(depth)
        return np.concatenate(rays), np.concatenate(depths)

    def _crossings_by_row(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return rays and the depths at which they cross triangles, unordered.

        Rays are treated row by row: two edges of a triangle cross the row, and the rays between the two crossings cross
        the triangle. The crossing of an edge is computed in the same way for both triangles that share the edge, so
        that no ray passes between two triangles.
        """
        if len(x) == 0:
            return np.empty(0, np.int64), np.empty(0)
        order = np.lexsort((x, y))
        rows, first = np.unique(y[order], return_index=True)
        row_of_ray = np.repeat(np.arange(len(rows)), np.diff(first, append=len(y)))
        left, right = x.min(), x.max()
        met = (self.low[1] <= rows[-1]) & (self.high[1] > rows[0])
        # The range of the rays' x is extended by _SAME, because the x coordinates of crossings are rounded.
        met &= (self.low[0] <= right + _SAME) & (self.high[0] >= left - _SAME)
        met = np.flatnonzero(met)

        begin, end = np.searchsorted(rows, self.low[1, met]), np.searchsorted(rows, self.high[1, met])
        triangle = np.repeat(met, end - begin)
        row = np.arange(len(triangle)) - np.repeat(np.cumsum(end - begin) - end, end - begin)
        at = rows[row]
        there = _crossed(self.edges[0, triangle], at)
        here = _crossed(self.edges[np.where(at >= self.edges[2, triangle, 1], 2, 1), triangle], at)
        # All rows of rays are placed one after the other on one axis, so that one search finds the rays of all rows.
        left, right = left - 1, right + 1
        places = x[order] + row_of_ray * (right - left)
        low, high = np.clip(np.minimum(here, there), left, right), np.clip(np.maximum(here, there), left, right)
        begin = np.searchsorted(places, low + row * (right - left))
        end = np.searchsorted(places, high + row * (right - left))
        triangle = np.repeat(triangle, end - begin)
        ray = order[np.arange(len(triangle)) - np.repeat(np.cumsum(end - begin) - end, end - begin)]

        corner, slope = self.corner[:, triangle], self.slope[:, triangle]
        depth = corner[2] + slope[0] * (x[ray] - corner[0]) + slope[1] * (y[ray] - corner[1])
        # The depth in a triangle seen nearly edge-on is sensitive to rounding, so the depth is limited to the range of
        # the corners' depths.
        return ray, np.clip(depth, self.low[2, triangle], self.high[2, triangle])


def _edge(lower: np.ndarray, upper: np.ndarray) -> np.ndarray:
    """Return x and y of the lower ends of edges, mm, and the change of x for each mm of y, (t, 3)."""
    rise = upper[1] - lower[1]
    return np.column_stack((lower[0], lower[1], (upper[0] - lower[0]) / np.where(rise > 0, rise, 1)))


def _crossed(edges: np.ndarray, at: np.ndarray) -> np.ndarray:
    """Return the image coordinate x (k,) at which edges (k, 3), see `_edge`, cross the rows of rays `at` (k,)."""
    return edges[:, 0] + (at - edges[:, 1]) * edges[:, 2]


# All types of stocks and models.
Solid = Union[Convex, Mesh]


def fitted(view: View, stock: Solid) -> Frame:
    """Return the view fitted to the stock.

    A TypeError is raised if `view` is not a View, or `stock` is not a solid (for example a stock object of a document).
    """
    of_kind("view", view, View, "a View(direction, width, height, ...)")
    of_kind("stock", stock, (Convex, Mesh), "a solid: a Stock(lower, upper), a Cylinder or a Mesh")
    return view.frame(stock)


def spans_in(solid: Solid, frame: Frame) -> Callable[[np.ndarray, np.ndarray], Spans]:
    """Return a function like `solid.spans` for one frame.

    For a mesh, the triangles are sorted only once for all calls.
    """
    return _SeenMesh(solid, frame).spans if isinstance(solid, Mesh) else partial(solid.spans, frame)


def is_same(one: Solid, other: Solid) -> bool:
    """Return whether two solids have bit for bit the same data."""
    mine, others = vars(one), vars(other)
    return one is other or (type(one) is type(other) and all(np.array_equal(mine[name], others[name]) for name in mine))
