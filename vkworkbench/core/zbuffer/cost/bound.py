# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bounds for a simulation from a few operations for each trajectory, without rays."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.solids import Convex, Stock
from vkworkbench.core.stocks import Solid, fitted
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath, check_toolpath
from vkworkbench.core.view import Frame, View
from vkworkbench.core.zbuffer.memory.memory import most_bytes_of
from vkworkbench.given import number

# Depth below the stock's top up to which a cut is not certain, mm.
_SHALLOW = 1e-3


def cuts_surely(toolpath: Toolpath, stock: Solid) -> bool:
    """Return whether a point of the toolpath lies inside or below a box of stock, so that the tool cuts. False: it may still cut."""
    if not isinstance(stock, Stock):
        return False
    points = toolpath.points
    inside = points[:, 2] < stock.upper[2] - _SHALLOW
    for axis in (0, 1):
        inside &= (points[:, axis] > stock.lower[axis]) & (points[:, axis] < stock.upper[axis])
    return bool(inside.any())


def may_cut(toolpath: Toolpath, tool: Tool, stock: Solid) -> bool:
    """Return whether the bounding boxes of the swept volume and of the stock overlap. False: the tool cuts nothing."""
    points = toolpath.points
    if not len(points):
        return False
    lower, upper = points[:, :2].min(axis=0) - tool.radius, points[:, :2].max(axis=0) + tool.radius
    beside = (lower >= stock.upper[:2]).any() or (upper <= stock.lower[:2]).any()
    return not beside and bool(points[:, 2].min() < stock.upper[2])


def most_bytes(toolpath: Toolpath, *, tool: Tool, stock: Solid, view: View) -> float:
    """Return an upper bound of the simulation's peak memory, pictures included.

    A trajectory adds one record to each pixel that it passes, two in an oblique view. A convex outline of area A and perimeter P
    contains at most A + P / 2 + 1 points of a lattice with spacing 1 (Nosarzewska 1948). In a view from above, the outline is the
    outline of the tool moved along the trajectory. In an oblique view it is the bounding box. A flat end cuts a pixel at most once
    at each height.

    Parameters
    ----------
    toolpath : Toolpath
    tool : Tool
    stock : Solid
        For a mesh the bound is infinite, because its rays may begin with any number of dexels.
    view : View

    Returns
    -------
    float
        Bytes.
    """
    if not isinstance(stock, Convex):
        return np.inf
    frame = view.frame(stock)
    return most_bytes_of(_most_removed(toolpath, tool, stock, frame), frame.width * frame.height, len(toolpath))


def _most_removed(toolpath: Toolpath, tool: Tool, stock: Convex, frame: Frame) -> float:
    """Return an upper bound of the number of removed pieces."""
    points, top = toolpath.points, float(stock.upper[2])
    cuts = np.flatnonzero(np.minimum(points[:-1, 2], points[1:, 2]) < top) if len(toolpath) else np.empty(0, int)
    move = points[cuts + 1] - points[cuts]
    pixels, radius = frame.width * frame.height, tool.radius / frame.pixel
    if not any(frame.direction[:2]):
        run = np.sqrt(move[:, 0] ** 2 + move[:, 1] ** 2) / frame.pixel
        passed = (2 * radius + 1) * run + np.pi * radius * (radius + 1) + 1
        return _count_by_level(points[cuts], move, passed, tool, pixels)
    # In an oblique view, the tool is as wide as its diameter and ends at the stock's top.
    height = (top - np.minimum(points[cuts, 2], points[cuts + 1, 2])) / frame.pixel
    right, up = (
        sum(np.abs(move[:, axis] * direction[axis]) for axis in range(3)) / frame.pixel + 2 * radius
        for direction in (frame.right, frame.up)
    )
    up += height
    return 2 * float(np.minimum(right * up + right + up + 1, pixels).sum())


def _count_by_level(start: np.ndarray, move: np.ndarray, passed: np.ndarray, tool: Tool, pixels: int) -> float:
    """Return the number of pixels that trajectories pass, with pixels at one height counted once if the tool's end is flat."""
    if passed.sum() <= pixels or tool.rounding or tool.steepness:
        return float(np.minimum(passed, pixels).sum())
    flat = (move[:, 2] == 0) | ~move[:, :2].any(axis=1)
    low = start[flat, 2] + np.minimum(move[flat, 2], 0)
    _, level = np.unique(low, return_inverse=True)
    return float(np.minimum(np.bincount(level, passed[flat]), pixels).sum() + np.minimum(passed[~flat], pixels).sum())


def cauchy_crofton(toolpath: Toolpath, *, stock: Solid, view: View, direction: float | None = None) -> float:
    """Count the crossings of the toolpath with parallel lines, one pixel apart: M(epsilon, theta) in section 2.1 of the paper.

    M is the length of the toolpath's projection on a line of direction theta, divided by epsilon, the distance between
    the lines. The lines run in the direction theta + pi / 2 (Tricot 1995). The paper rejects this measure of the cost,
    because it depends neither on the tool's width nor on the sequence.

    Parameters
    ----------
    toolpath : Toolpath
        Trajectories that go below the top of the stock are counted with their whole length, also beside the stock.
    stock : Solid
    view : View
        The side of its pixels is epsilon.
    direction : float, optional
        Theta, rad, from the image's right upwards; 0 counts crossings with columns of pixels, pi / 2 with rows.

    Returns
    -------
    float
        Number of crossings. Without `direction`, the mean over all directions: 2 / pi of the length in the image, divided by
        epsilon.

    Raises
    ------
    ValueError, TypeError
        If an argument has another type, or the direction is not finite.
    """
    check_toolpath(toolpath)
    frame = fitted(view, stock)
    move = np.diff(toolpath.points, axis=0)
    move = move[np.minimum(toolpath.points[:-1, 2], toolpath.points[1:, 2]) < stock.upper[2]]
    right, up = move @ frame.right, move @ frame.up
    if direction is None:
        return float(np.hypot(right, up).sum() * 2 / np.pi / frame.pixel)
    direction = number("direction", direction, "an angle in rad, a finite number", np.isfinite)
    return float(np.abs(right * np.cos(direction) + up * np.sin(direction)).sum() / frame.pixel)
