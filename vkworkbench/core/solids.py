# SPDX-License-Identifier: LGPL-2.1-or-later
"""Raw material that planes bound, and where rays are inside of a solid."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, product
from math import pi, tan
from typing import NamedTuple

import numpy as np

from vkworkbench.core.tool import Tool, check_tool
from vkworkbench.core.toolpath import COORDINATE_LIMIT, Toolpath, check_toolpath
from vkworkbench.core.view import Frame
from vkworkbench.given import numbers
from vkworkbench.language import Message, Unusable

SMALLEST = 1e-6  # mm; no document keeps less


def point(name: str, given: object) -> np.ndarray:
    """Return a point that was given, (3,) float64 of its own; see `given.number`."""
    takes = "three numbers, the coordinates of a point in mm"
    return np.array(numbers(name, given, takes, lambda array: array.size == 3)).reshape(3)


class Gaps(NamedTuple):
    """Stretches of rays outside a solid, between parts of it.

    Attributes
    ----------
    ray : (g,) ndarray of int
        Ascending.
    enter, leave : (g,) ndarray
        Depths, mm, ascending within a ray.
    """

    ray: np.ndarray
    enter: np.ndarray
    leave: np.ndarray


class Spans(NamedTuple):
    """Where rays are inside a solid.

    Attributes
    ----------
    near, far : (k,) ndarray
        Depths at which each ray first enters and last leaves it, mm; ``near >= far`` where it misses.
    gaps : Gaps
        What lies outside in between.
    """

    near: np.ndarray
    far: np.ndarray
    gaps: Gaps


class Convex:
    """A convex solid as the common part of half-spaces; what the rays need of any stock."""

    normals: np.ndarray
    offsets: np.ndarray
    corners: np.ndarray
    lower: np.ndarray
    upper: np.ndarray

    def chords(self, origins: np.ndarray, direction: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Where rays enter and leave the solid.

        Parameters
        ----------
        origins : (k, 3) ndarray
            One point of each ray, mm.
        direction : (3,) ndarray
            Common unit direction.

        Returns
        -------
        near, far : (k,) ndarray
            Signed distances from the origins, mm; ``near >= far`` where a ray misses the solid.
        """
        near = np.full(len(origins), -np.inf)
        far = np.full(len(origins), np.inf)
        for normal, offset in zip(self.normals, self.offsets):
            along = np.flatnonzero(normal)
            if len(along) == 1:
                room = offset - origins[:, along[0]] * normal[along[0]]
            else:  # not a matrix product: BLAS would start threads for it, which takes longer than the sum
                room = offset - np.einsum("ij,j->i", origins, normal)
            slope = float(direction @ normal)
            if abs(slope) < 1e-12:
                far[room < 0] = -np.inf
            elif slope > 0:
                np.minimum(far, room / slope, out=far)
            else:
                np.maximum(near, room / slope, out=near)
        return near, far

    def spans(self, frame: Frame, x: np.ndarray, y: np.ndarray) -> Spans:
        """Where rays of a view are inside the solid.

        Parameters
        ----------
        frame : Frame
        x, y : (k,) ndarray
            Image coordinates of the rays, mm.
        """
        near, far = self.chords(frame.origins(x, y), frame.direction)
        return Spans(near, far, Gaps(np.empty(0, np.int64), np.empty(0), np.empty(0)))


class Stock(Convex):
    """A box of raw material.

    Parameters
    ----------
    lower, upper : (3,) array_like
        Its lowest and its highest corner, mm.

    Raises
    ------
    Unusable
        If a coordinate is not finite or beyond a kilometre, or the box has no volume.
    ValueError, TypeError
        If a corner is no three numbers.
    """

    def __init__(self, lower: Sequence[float] | np.ndarray, upper: Sequence[float] | np.ndarray) -> None:
        self.lower, self.upper = point("lower", lower), point("upper", upper)
        if not (np.abs([self.lower, self.upper]) <= COORDINATE_LIMIT).all():
            raise Unusable(Message("stock-not-finite"))
        if not (self.upper - self.lower >= SMALLEST).all():
            raise Unusable(Message("stock-without-volume"))
        self.normals = np.vstack((np.eye(3), -np.eye(3)))
        self.offsets = np.concatenate((self.upper, -self.lower))
        self.corners = np.array(list(product(*zip(self.lower, self.upper))))

    def __repr__(self) -> str:
        return f"Stock({self.lower.tolist()}, {self.upper.tolist()})"


class ConvexStock(Convex):
    """Raw material bounded by planes.

    Parameters
    ----------
    normals : (m, 3) array_like
        Outward normals, of any length but zero.
    offsets : (m,) array_like
        The solid is ``normals @ point <= offsets``.

    Attributes
    ----------
    corners : (c, 3) ndarray
        Where three or more planes meet, mm.
    lower, upper : (3,) ndarray
        Corners of the bounding box, mm.

    Raises
    ------
    ValueError
        If the half-spaces enclose no bounded volume.
    """

    def __init__(self, normals: np.ndarray, offsets: np.ndarray) -> None:
        normals = np.array(normals, float).reshape(-1, 3)
        lengths = np.sqrt((normals**2).sum(axis=1))
        if not (lengths > 0).all():
            raise ValueError("a plane of the stock has no normal")
        self.normals = normals / lengths[:, None]
        self.offsets = np.array(offsets, float).reshape(len(normals)) / lengths
        self.corners = corners = self._corners()
        solid = len(corners) >= 4 and np.linalg.matrix_rank(corners - corners[0], tol=1e-9) == 3
        # Rays from the middle of a bounded solid leave it, whichever way they go.
        if not solid or not all(np.isfinite(self.chords(corners.mean(axis=0)[None], axis)).all() for axis in np.eye(3)):
            raise ValueError("the planes of the stock enclose no bounded volume")
        self.lower, self.upper = corners.min(axis=0), corners.max(axis=0)

    @classmethod
    def cylinder(cls, base: np.ndarray, radius: float, height: float, sides: int = 64) -> ConvexStock:
        """Return a vertical cylinder as a regular prism of the same cross-section.

        Parameters
        ----------
        base : (3,) array_like
            Centre of the lower face, mm.
        radius, height : float
            Size of the cylinder, mm; both positive.
        sides : int
            Number of the prism's side faces.
        """
        if not (radius > 0 and height > 0):
            raise ValueError("a cylinder of stock needs a positive radius and height")
        base = np.array(base, float).reshape(3)
        angles = 2 * pi * np.arange(sides) / sides
        walls = np.column_stack((np.cos(angles), np.sin(angles), np.zeros(sides)))
        # The regular polygon of equal area: sides * tan(pi/sides) * apothem**2 = pi * radius**2.
        apothem = radius * np.sqrt(pi / (sides * tan(pi / sides)))
        normals = np.vstack((walls, [[0, 0, 1], [0, 0, -1]]))
        offsets = np.concatenate((walls @ base + apothem, [base[2] + height, -base[2]]))
        return cls(normals, offsets)

    def _corners(self) -> np.ndarray:
        triples = np.array(list(combinations(range(len(self.normals)), 3)), int).reshape(-1, 3)
        matrices = self.normals[triples]
        proper = np.abs(np.linalg.det(matrices)) > 1e-9
        corners = np.linalg.solve(matrices[proper], self.offsets[triples[proper]][..., None])[..., 0]
        slack = 1e-9 * (1 + np.abs(self.offsets).max(initial=0))
        inside = (corners @ self.normals.T <= self.offsets + slack).all(axis=1)
        result: np.ndarray = corners[inside]
        return result


def stock_around(toolpath: Toolpath, tool: Tool) -> Stock:
    """Return the box around all cuts of a tool, up to the highest: a stand-in where the stock is unknown.

    Raises
    ------
    ValueError
        Where nothing cuts.
    TypeError
        Where toolpath or tool is something else.
    """
    check_toolpath(toolpath)
    check_tool(tool)
    cuts = ~toolpath.rapid
    if not cuts.any():
        raise ValueError("there is no box around the cuts of a toolpath without any")
    points = np.concatenate((toolpath.points[:-1][cuts], toolpath.points[1:][cuts]))
    lower, upper = points.min(axis=0) - tool.radius, points.max(axis=0) + tool.radius
    upper[2] = max(upper[2] - tool.radius, lower[2] + tool.diameter)
    lower = np.clip(lower, -COORDINATE_LIMIT, COORDINATE_LIMIT - 2 * SMALLEST)
    return Stock(lower, np.clip(upper, lower + 2 * SMALLEST, COORDINATE_LIMIT))
