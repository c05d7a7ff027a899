# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solids of a simulation, tool and stock, and the parallel view of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations, product
from math import isfinite, pi, tan
from operator import index
from typing import NamedTuple, Protocol

import numpy as np

from vkworkbench.core.toolpath import Toolpath
from vkworkbench.language import Message, Unusable

SHAPES = ("endmill", "ballend", "bullnose", "vbit", "drill")
LARGEST, SMALLEST = 1e6, 1e-6  # mm; no machine has more, no document keeps less
# A view tilted by less than this, rad, is vertical: it shows nothing else, a camera's rounding would tell which side of the
# image is up, and rays so steep pass the walls of tools where rounding decides.
VERTICAL = 1e-5
_DEFAULT_TIP_ANGLE = {"vbit": pi / 3, "drill": 118 * pi / 180}


@dataclass(frozen=True)
class Tool:
    """A milling tool or drill: a convex solid of revolution, upright, its tip at the programmed point.

    The shank above the cutting edge cuts like the edge: the solid is unbounded upwards.

    Parameters
    ----------
    shape : {"endmill", "ballend", "bullnose", "vbit", "drill"}
        Form of the tip.
    diameter : float
        Cutting diameter, mm.
    corner_radius : float
        Radius of a bull-nose mill's corner, mm; 0 makes it flat, half the diameter makes it a ball.
    tip_angle : float, optional
        Included angle of a V-bit's or a drill's tip, rad; 60 and 118 degrees where not given.
    tip_diameter : float
        Diameter of the flat end of a V-bit's cone, mm: chamfer mills and engravers have one.

    Raises
    ------
    Unusable
        For a diameter that is not a positive number of at most a kilometre, a corner radius above half the diameter,
        a tip angle outside ]0, pi], or a tip that is wider than the tool.
    ValueError
        For an unknown shape, or a text that is no number.
    TypeError
        Where a size is nothing like a number. (FreeCAD's quantities are numbers, in mm.)
    """

    shape: str
    diameter: float
    corner_radius: float = 0.0
    tip_angle: float | None = None
    tip_diameter: float = 0.0

    def __post_init__(self) -> None:
        if self.shape not in SHAPES:
            raise ValueError(f"unknown tool shape {self.shape!r}; known are {', '.join(SHAPES)}")
        for name in ("diameter", "corner_radius", "tip_angle", "tip_diameter"):
            given = getattr(self, name)
            if given is not None or name != "tip_angle":
                object.__setattr__(self, name, float(given))  # a quantity of FreeCAD's cannot be reckoned with
        if not 0 < self.diameter <= LARGEST:
            raise Unusable(Message("tool-diameter", diameter=self.diameter))
        if self.shape == "bullnose" and not 0 <= self.corner_radius <= self.radius:
            raise Unusable(Message("corner-radius", radius=self.radius, corner=self.corner_radius))
        if self.tip_angle is not None and not 0 < self.tip_angle <= pi:
            raise Unusable(Message("tip-angle", angle=self.tip_angle))
        if not 0 <= self.tip_diameter <= self.diameter:
            raise Unusable(Message("tip-diameter", diameter=self.diameter, tip=self.tip_diameter))

    @property
    def radius(self) -> float:
        """Cutting radius, mm."""
        return self.diameter / 2

    @property
    def rounding(self) -> float:
        """Radius of the rounded corner, mm: the whole radius for a ball end, 0 where there is none."""
        return {"ballend": self.radius, "bullnose": self.corner_radius}.get(self.shape, 0.0)

    @property
    def steepness(self) -> float:
        """Rise of the conical tip per mm of radius; 0 where there is no cone."""
        if self.shape not in _DEFAULT_TIP_ANGLE:
            return 0.0
        angle = self.tip_angle if self.tip_angle is not None else _DEFAULT_TIP_ANGLE[self.shape]
        return 1 / tan(angle / 2) if angle < pi else 0.0  # of which rounding would leave a cone

    @property
    def tip(self) -> float:
        """Radius within which a conical tip is flat, mm; 0 where there is no cone."""
        return self.tip_diameter / 2 if self.steepness else 0.0

    def height(self, r: np.ndarray | float) -> np.ndarray:
        """Height of the tool's lower surface above its tip.

        Parameters
        ----------
        r : array_like
            Distance from the tool's axis, mm.

        Returns
        -------
        ndarray
            Heights of the shape of `r`, mm; infinite outside the tool.
        """
        r = np.asarray(r, float)
        return np.where(r <= self.radius, self.profile(r), np.inf)

    def profile(self, r: np.ndarray) -> np.ndarray:
        """`height` at distances of which rounding may have made more than the radius: there it is that of the rim."""
        corner = self.rounding
        flat, width = (self.radius - corner, corner) if corner else (self.tip, self.radius - self.tip)
        beyond_flat = np.minimum(np.maximum(r - flat, 0.0), width)
        rise: np.ndarray = corner - np.sqrt(corner**2 - beyond_flat**2) if corner else self.steepness * beyond_flat
        return rise


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
    """

    def __init__(self, lower: Sequence[float] | np.ndarray, upper: Sequence[float] | np.ndarray) -> None:
        self.lower = np.array(lower, float).reshape(3)
        self.upper = np.array(upper, float).reshape(3)
        if not (np.abs([self.lower, self.upper]) <= LARGEST).all():
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


class Bounded(Protocol):
    """A solid with a bounding box, `lower` and `upper` (3,) mm."""

    lower: np.ndarray
    upper: np.ndarray


@dataclass(frozen=True)
class View:
    """A parallel projection on an image of rays.

    Parameters
    ----------
    direction : (3,) tuple of float
        Where the eye looks, of any length but zero; the default looks down from above.
    width, height : int
        Size of the image, pixels. The default is the paper's image (section 1).
    pixel : float, optional
        Side of a pixel, mm; by default the smallest with which the image holds the whole stock.
    offset : (2,) tuple of float
        Where the image's centre lies from that of the stock, mm to the right and up.

    Raises
    ------
    ValueError
        If the direction has no length, the image no pixels or a pixel no side.
    TypeError
        If width or height is no whole number, as ``160 / 0.5`` is none.
    """

    direction: tuple[float, float, float] = (0.0, 0.0, -1.0)
    width: int = 800
    height: int = 600
    pixel: float | None = None
    offset: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        direction = np.array(self.direction, float)
        if direction.shape != (3,) or not np.isfinite(direction).all() or not direction.any():
            raise ValueError("the view's direction must be three finite numbers, not all zero")
        object.__setattr__(self, "direction", tuple(float(x) for x in direction))
        for name in ("width", "height"):
            try:
                object.__setattr__(self, name, index(getattr(self, name)))
            except TypeError:
                raise TypeError(
                    f"the image's {name} is a whole number of pixels, not {getattr(self, name)!r}"
                ) from None
        if self.width < 1 or self.height < 1:
            raise ValueError("the image needs at least one pixel each way")
        if self.pixel is not None and not (isfinite(self.pixel) and self.pixel > 0):
            raise ValueError(f"the side of a pixel must be a positive number, not {self.pixel:g} mm")

    def frame(self, stock: Bounded) -> Frame:
        """Return the image's axes, centre and pixel for this stock."""
        direction = np.array(self.direction) / np.linalg.norm(self.direction)
        sine = np.hypot(direction[0], direction[1])
        if sine < VERTICAL:
            direction = np.array([0.0, 0.0, np.sign(direction[2])])
            right = np.array([1.0, 0.0, 0.0])
        else:
            right = np.array([direction[1], -direction[0], 0.0]) / sine
        (rx, ry, _), (dx, dy, dz) = right, direction
        up = np.array([ry * dz, -rx * dz, rx * dy - ry * dx])  # right x direction
        half = (stock.upper - stock.lower) / 2
        pixel = self.pixel
        if pixel is None:
            extent = 2 * np.array([np.abs(right) @ half, np.abs(up) @ half])
            pixel = float(max(extent[0] / self.width, extent[1] / self.height))
        centre = (stock.lower + stock.upper) / 2 + self.offset[0] * right + self.offset[1] * up
        return Frame(centre, right, up, direction, pixel, self.width, self.height)


@dataclass(frozen=True, eq=False)
class Frame:
    """A view fitted to a stock: image coordinates x, y in mm about its centre, depth along the view.

    Attributes
    ----------
    centre, right, up, direction : (3,) ndarray
        Centre of the image, as deep as that of the stock's bounding box, and the image's orthonormal axes.
    pixel : float
        Side of a pixel, mm.
    width, height : int
        Pixels.
    """

    centre: np.ndarray
    right: np.ndarray
    up: np.ndarray
    direction: np.ndarray
    pixel: float
    width: int
    height: int

    def origins(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Return the points (k, 3) of the image plane at image coordinates `x`, `y` (k,)."""
        result: np.ndarray = self.centre + np.multiply.outer(x, self.right) + np.multiply.outer(y, self.up)
        return result

    def pixel_centres(self, columns: np.ndarray, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the image coordinates of pixel centres; column 0 is left, row 0 is the bottom."""
        x = (np.asarray(columns) + 0.5 - self.width / 2) * self.pixel
        y = (np.asarray(rows) + 0.5 - self.height / 2) * self.pixel
        return x, y

    def points(self, columns: np.ndarray, rows: np.ndarray, depth: np.ndarray) -> np.ndarray:
        """Return the points (k, 3) at a depth (k,) along the ray of each pixel."""
        centres = self.origins(*self.pixel_centres(columns, rows))
        result: np.ndarray = centres + np.multiply.outer(depth, self.direction)
        return result


def stock_around(toolpath: Toolpath, tool: Tool) -> Stock:
    """Return the box around all cuts of a tool, up to the highest: a stand-in where the stock is unknown.

    Raises
    ------
    ValueError
        Where nothing cuts.
    """
    cuts = ~toolpath.rapid
    if not cuts.any():
        raise ValueError("there is no box around the cuts of a toolpath without any")
    points = np.concatenate((toolpath.points[:-1][cuts], toolpath.points[1:][cuts]))
    lower, upper = points.min(axis=0) - tool.radius, points.max(axis=0) + tool.radius
    upper[2] = max(upper[2] - tool.radius, lower[2] + tool.diameter)
    lower = np.clip(lower, -LARGEST, LARGEST - 2 * SMALLEST)
    return Stock(lower, np.clip(upper, lower + 2 * SMALLEST, LARGEST))
