# SPDX-License-Identifier: LGPL-2.1-or-later
"""Properties of a simulation that follow from a few operations per trajectory, without a ray."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.solids import Convex, Stock
from vkworkbench.core.stocks import Solid, fitted
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath, check_toolpath
from vkworkbench.core.view import Frame, View
from vkworkbench.core.zbuffer.memory.memory import most_bytes_of
from vkworkbench.given import number

_SHALLOW = 1e-3  # mm


def cuts_surely(toolpath: Toolpath, stock: Solid) -> bool:
    """Whether the tip stands in a box of stock or below it at the end of some trajectory; else it may cut or not."""
    if not isinstance(stock, Stock):
        return False
    points = toolpath.points
    inside = points[:, 2] < stock.upper[2] - _SHALLOW
    for axis in (0, 1):
        inside &= (points[:, axis] > stock.lower[axis]) & (points[:, axis] < stock.upper[axis])
    return bool(inside.any())


def may_cut(toolpath: Toolpath, tool: Tool, stock: Solid) -> bool:
    """Whether the box around all that the tool passes reaches into the box around the stock; else it cuts nothing."""
    points = toolpath.points
    if not len(points):
        return False
    lower, upper = points[:, :2].min(axis=0) - tool.radius, points[:, :2].max(axis=0) + tool.radius
    beside = (lower >= stock.upper[:2]).any() or (upper <= stock.lower[:2]).any()
    return not beside and bool(points[:, 2].min() < stock.upper[2])


def most_bytes(toolpath: Toolpath, *, tool: Tool, stock: Solid, view: View) -> float:
    """No more bytes than this does a simulation take at its peak, with pictures of it.

    A trajectory adds one record to a pixel it passes, two in an oblique view. A convex outline of area A and perimeter P
    holds at most A + P / 2 + 1 points of a lattice of step 1 (Nosarzewska 1948). Seen from above it is that of the tool
    sent along the move, obliquely the box around it. What a flat end cuts at one height it cuts once.

    Parameters
    ----------
    toolpath : Toolpath
    tool : Tool
    stock : Solid
        Of a mesh, whose rays may begin with any number of dexels, there is no bound.
    view : View

    Returns
    -------
    float
        Bytes.
    """
    if not isinstance(stock, Convex):
        return np.inf
    frame = view.frame(stock)
    return most_bytes_of(_most_cut(toolpath, tool, stock, frame), frame.width * frame.height, len(toolpath))


def _most_cut(toolpath: Toolpath, tool: Tool, stock: Convex, frame: Frame) -> float:
    """No more pieces of rays than this are removed."""
    points, top = toolpath.points, float(stock.upper[2])
    cuts = np.flatnonzero(np.minimum(points[:-1, 2], points[1:, 2]) < top) if len(toolpath) else np.empty(0, int)
    move = points[cuts + 1] - points[cuts]
    pixels, radius = frame.width * frame.height, tool.radius / frame.pixel
    if not any(frame.direction[:2]):
        run = np.sqrt(move[:, 0] ** 2 + move[:, 1] ** 2) / frame.pixel
        passed = (2 * radius + 1) * run + np.pi * radius * (radius + 1) + 1
        return _on_levels(points[cuts], move, passed, tool, pixels)
    # The tool seen obliquely is no wider than its diameter, and reaches up to the stock's top.
    height = (top - np.minimum(points[cuts, 2], points[cuts + 1, 2])) / frame.pixel
    right, up = (
        sum(np.abs(move[:, axis] * direction[axis]) for axis in range(3)) / frame.pixel + 2 * radius
        for direction in (frame.right, frame.up)
    )
    up += height
    return 2 * float(np.minimum(right * up + right + up + 1, pixels).sum())


def _on_levels(start: np.ndarray, move: np.ndarray, passed: np.ndarray, tool: Tool, pixels: int) -> float:
    """Sum up the pixels that trajectories pass, those of one height no more than once if the tool's end is flat."""
    if passed.sum() <= pixels or tool.rounding or tool.steepness:
        return float(np.minimum(passed, pixels).sum())
    flat = (move[:, 2] == 0) | ~move[:, :2].any(axis=1)
    low = start[flat, 2] + np.minimum(move[flat, 2], 0)
    _, level = np.unique(low, return_inverse=True)
    return float(np.minimum(np.bincount(level, passed[flat]), pixels).sum() + np.minimum(passed[~flat], pixels).sum())


def cauchy_crofton(toolpath: Toolpath, *, stock: Solid, view: View, direction: float | None = None) -> float:
    """Count the crossings of the toolpath with parallel lines a pixel apart: M(epsilon, theta) of the paper's section 2.1.

    M is the length of the toolpath's projection on a line of direction theta, divided by epsilon, the distance between
    the lines. The lines run in the direction theta + pi / 2 (Tricot 1995). The paper rejects this measure of the cost,
    because it depends neither on the tool's width nor on the sequence.

    Parameters
    ----------
    toolpath : Toolpath
        Its trajectories that go below the top of the stock are counted, whole, also beside the stock.
    stock : Solid
    view : View
        Its pixel is epsilon.
    direction : float, optional
        Theta, rad from the image's right upwards; 0 counts crossings with the pixels' columns, pi / 2 with their rows.

    Returns
    -------
    float
        For that direction; without one the mean over all of them, 2 / pi of the length in the image by epsilon.

    Raises
    ------
    ValueError, TypeError
        Where an argument is something else.
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
