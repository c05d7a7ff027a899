# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a few operations for each trajectory tell of a simulation, without a ray."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.solids import Convex, Stock
from vkworkbench.core.stocks import Solid
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.view import Frame, View
from vkworkbench.core.zbuffer.memory.memory import most_bytes_of

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
