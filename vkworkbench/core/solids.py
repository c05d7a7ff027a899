# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define stocks (raw material): convex solids, the box, and the stretches of rays inside a solid."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

import numpy as np

from vkworkbench.core.tool import Tool, check_tool
from vkworkbench.core.toolpath import COORDINATE_LIMIT, Toolpath, check_toolpath
from vkworkbench.core.view import Frame
from vkworkbench.given import numbers
from vkworkbench.language import Message, Unusable

SMALLEST = 1e-6  # smallest side of a stock, mm, because documents store six decimals


def point(name: str, given: object) -> np.ndarray:
    """Return a copy of a given point, (3,) float64; see `given.number` for the errors."""
    takes = "three numbers, the coordinates of a point in mm"
    return np.array(numbers(name, given, takes, lambda array: array.size == 3)).reshape(3)


class Gaps(NamedTuple):
    """Stretches of rays that are outside a solid, but between two stretches inside the solid."""

    ray: np.ndarray  # (g,) int: index of the ray of each gap, ascending
    # enter, leave (g,): depths at which each gap begins and ends, mm, ascending within a ray.
    enter: np.ndarray
    leave: np.ndarray


class Spans(NamedTuple):
    """The stretches of rays inside a solid."""

    # near, far (k,): depths at which each ray first enters and last leaves the solid, mm; ``near >= far`` if the ray
    # misses the solid.
    near: np.ndarray
    far: np.ndarray
    gaps: Gaps  # stretches outside the solid between `near` and `far`


class Convex:
    """A convex solid: all points with ``normals @ point <= offsets``.

    `Convex` is the base class of all convex stocks.
    """

    normals: np.ndarray
    offsets: np.ndarray
    corners: np.ndarray
    lower: np.ndarray
    upper: np.ndarray

    def chords(self, origins: np.ndarray, direction: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return where rays enter and leave the solid, (k,) each.

        The results are signed distances from `origins`, one point (k, 3) of each ray, mm, along the common unit
        direction; ``near >= far`` if a ray misses the solid.
        """
        raise NotImplementedError

    def spans(self, frame: Frame, x: np.ndarray, y: np.ndarray) -> Spans:
        """Return the stretches inside the solid of the rays at the image coordinates `x`, `y` (k,), mm."""
        near, far = self.chords(frame.origins(x, y), frame.direction)
        return Spans(near, far, Gaps(np.empty(0, np.int64), np.empty(0), np.empty(0)))


class Stock(Convex):
    """A box of raw material.

    Parameters
    ----------
    lower, upper : (3,) array_like
        Lowest and highest corner, mm.

    Raises
    ------
    Unusable
        If a coordinate is not finite, or is larger than a kilometre, or the box has no volume.
    ValueError, TypeError
        If a corner is not three numbers.
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

    def chords(self, origins: np.ndarray, direction: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """See `Convex.chords`."""
        near = np.full(len(origins), -np.inf)
        far = np.full(len(origins), np.inf)
        for normal, offset in zip(self.normals, self.offsets):
            axis = np.flatnonzero(normal)[0]
            room = offset - origins[:, axis] * normal[axis]
            slope = float(direction @ normal)
            if abs(slope) < 1e-12:
                far[room < 0] = -np.inf
            elif slope > 0:
                np.minimum(far, room / slope, out=far)
            else:
                np.maximum(near, room / slope, out=near)
        return near, far


def stock_around(toolpath: Toolpath, tool: Tool) -> Stock:
    """Return the box around all cuts of a tool, up to the height of the highest cut.

    The box replaces a stock that is unknown.

    Raises
    ------
    ValueError
        If the toolpath contains no cuts.
    TypeError
        If `toolpath` is not a Toolpath or `tool` not a Tool.
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
