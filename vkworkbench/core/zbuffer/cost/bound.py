# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute bounds for a simulation quickly, from the trajectories alone and without sampled rays."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.solids import Convex, Stock
from vkworkbench.core.stocks import Solid, fitted
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath, check_toolpath
from vkworkbench.core.view import Frame, View
from vkworkbench.core.zbuffer.memory.memory import most_bytes_of
from vkworkbench.given import number

# Depth below the stock's top, mm. A point of the toolpath at a smaller depth does not count as a certain cut.
_SHALLOW = 1e-3


def cuts_surely(toolpath: Toolpath, stock: Solid) -> bool:
    """Return whether the tool certainly cuts, because a point of the toolpath is inside or below a box-shaped stock.

    If the result is False, the tool possibly still cuts.
    """
    if not isinstance(stock, Stock):
        return False
    points = toolpath.points
    inside = points[:, 2] < stock.upper[2] - _SHALLOW
    for axis in (0, 1):
        inside &= (points[:, axis] > stock.lower[axis]) & (points[:, axis] < stock.upper[axis])
    return bool(inside.any())


def may_cut(toolpath: Toolpath, tool: Tool, stock: Solid) -> bool:
    """Return whether the swept volume possibly meets the stock, from their bounding boxes.

    If the result is False, the tool cuts nothing.
    """
    points = toolpath.points
    if not len(points):
        return False
    lower, upper = points[:, :2].min(axis=0) - tool.radius, points[:, :2].max(axis=0) + tool.radius
    beside = (lower >= stock.upper[:2]).any() or (upper <= stock.lower[:2]).any()
    return not beside and bool(points[:, 2].min() < stock.upper[2])


def most_bytes(toolpath: Toolpath, *, tool: Tool, stock: Solid, view: View) -> float:
    """Return an upper bound of the simulation's peak memory, pictures included.

    A trajectory adds at most one record to each pixel that it passes in a view from above, and at most two in an
    oblique view. A convex outline with area A and perimeter P contains at most A + P / 2 + 1 points of a lattice with
    spacing 1 (Nosarzewska 1948). In a view from above, this outline is the outline of the swept volume. In an oblique
    view, this outline is the bounding box of the swept volume in the image. A tool with a flat end cuts each pixel at
    most once at each height.

    Parameters
    ----------
    toolpath : Toolpath
    tool : Tool
    stock : Solid
        The bound is infinite for a mesh, because the number of dexels on its rays is unknown.
    view : View

    Returns
    -------
    float
        Upper bound, bytes.
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
    # In an oblique view, the tool is replaced by a cylinder with its diameter, from its tip to the stock's top.
    height = (top - np.minimum(points[cuts, 2], points[cuts + 1, 2])) / frame.pixel
    right, up = (
        sum(np.abs(move[:, axis] * direction[axis]) for axis in range(3)) / frame.pixel + 2 * radius
        for direction in (frame.right, frame.up)
    )
    up += height
    return 2 * float(np.minimum(right * up + right + up + 1, pixels).sum())


def _count_by_level(start: np.ndarray, move: np.ndarray, passed: np.ndarray, tool: Tool, pixels: int) -> float:
    """Return an upper bound of the number of removed pieces in a view from above.

    `passed` contains the number of pixels that each trajectory passes. If the tool's end is flat, each pixel counts at
    most once at each height.
    """
    if passed.sum() <= pixels or tool.rounding or tool.steepness:
        return float(np.minimum(passed, pixels).sum())
    flat = (move[:, 2] == 0) | ~move[:, :2].any(axis=1)
    low = start[flat, 2] + np.minimum(move[flat, 2], 0)
    _, level = np.unique(low, return_inverse=True)
    return float(np.minimum(np.bincount(level, passed[flat]), pixels).sum() + np.minimum(passed[~flat], pixels).sum())


def cauchy_crofton(toolpath: Toolpath, *, stock: Solid, view: View, direction: float | None = None) -> float:
    """Count the crossings of the toolpath with parallel lines that are one pixel apart.

    The count is M(epsilon, theta) in section 2.1 of the paper: the length of the toolpath's projection onto a line in
    the direction theta, divided by the distance epsilon between the lines. The lines are perpendicular to the direction
    theta (Tricot 1995). The paper rejects M as a measure of the cost, because M depends neither on the tool's width nor
    on the order of the moves.

    Parameters
    ----------
    toolpath : Toolpath
        Each trajectory that goes below the top of the stock counts with its whole length, even beside the stock.
    stock : Solid
    view : View
        Epsilon is the side of the view's pixels.
    direction : float, optional
        Theta, rad, measured from the image's right axis towards its up axis. The angle 0 counts crossings with columns
        of pixels, the angle pi / 2 counts crossings with rows.

    Returns
    -------
    float
        Number of crossings. Without `direction`, the mean number over all directions is returned: 2 / pi times the
        toolpath's length in the image, divided by epsilon.

    Raises
    ------
    ValueError, TypeError
        If an argument has a wrong type, or the direction is not finite.
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
