# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find out quickly whether a tool cuts, and compute bounds of a simulation's cost, from the trajectories alone."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.solids import Stock
from vkworkbench.core.stocks import Solid, fitted
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath, check_toolpath
from vkworkbench.core.view import View
from vkworkbench.core.zbuffer.memory.memory import most_bytes_of
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts
from vkworkbench.given import number

# Minimum depth below the stock's top, mm, of a toolpath point that proves that the tool cuts.
_SHALLOW = 1e-3


def cuts_surely(toolpath: Toolpath, stock: Solid) -> bool:
    """Return whether the tool certainly cuts, because a point of the toolpath is inside or below a box-shaped stock.

    The result False proves nothing: the tool can still cut.
    """
    if not isinstance(stock, Stock):
        return False
    points = toolpath.points
    inside = points[:, 2] < stock.upper[2] - _SHALLOW
    for axis in (0, 1):
        inside &= (points[:, axis] > stock.lower[axis]) & (points[:, axis] < stock.upper[axis])
    return bool(inside.any())


def may_cut(toolpath: Toolpath, tool: Tool, stock: Solid) -> bool:
    """Return whether the bounding boxes of the swept volume and of the stock overlap.

    If the result is False, the tool certainly cuts nothing.
    """
    points = toolpath.points
    if not len(points):
        return False
    lower, upper = points[:, :2].min(axis=0) - tool.radius, points[:, :2].max(axis=0) + tool.radius
    beside = (lower >= stock.upper[:2]).any() or (upper <= stock.lower[:2]).any()
    return not beside and bool(points[:, 2].min() < stock.upper[2])


def most_bytes(toolpath: Toolpath, *, tool: Tool, stock: Solid, view: View) -> float:
    """Return an upper bound of a simulation's peak memory with pictures, bytes; infinite if the stock is a mesh."""
    cuts = Cuts([Cut(toolpath, tool)])
    return most_bytes_of(Removal(cuts, stock, view.frame(stock)), len(cuts))


def cauchy_crofton(toolpath: Toolpath, *, stock: Solid, view: View, direction: float | None = None) -> float:
    """Count the crossings of the toolpath with parallel lines that are one pixel apart.

    The count is M(epsilon, theta) in section 2.1 of the paper: the length of the toolpath's projection onto a line in
    the direction theta, divided by the distance epsilon between the lines. The lines are perpendicular to the direction
    theta (Tricot 1995). The paper rejects M as a measure of the simulation's cost, because M depends neither on the
    tool's width nor on the order of the moves.

    Parameters
    ----------
    toolpath : Toolpath
        The whole length of each trajectory that goes below the top of the stock is included, even where the trajectory
        is outside the stock.
    view : View
        Epsilon is the side of the view's pixels.
    direction : float, optional
        Theta, rad, measured from the image's right axis towards its up axis. With theta = 0, crossings with the columns
        of pixels are counted; with theta = pi / 2, crossings with the rows of pixels.

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
