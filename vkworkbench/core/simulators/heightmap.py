# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute coarse maps of the stock's heights after several parts of a toolpath."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.stocks import Solid
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath

# _CELLS: number of cells along the stock's longer side. _CELLS_PER_RADIUS: maximum number of cells along the tool's
# radius.
_CELLS = 100
_CELLS_PER_RADIUS = 16
# Approximate maximum number of points at which a toolpath is sampled.
_MOST_SAMPLES = 300_000
# Number of sampled points that are processed at once. The arrays for a larger number of points would not fit into the
# processor's cache.
_SAMPLES_AT_ONCE = 16_384


def heightmaps(toolpath: Toolpath, *, tool: Tool, stock: Solid, parts: int = 1) -> tuple[list[np.ndarray], float]:
    """Compute the heights of the stock after each part of the toolpath.

    The stock is replaced by its bounding box, and rapids cut, too. First, the lowest height that the tool's tip reaches
    over each cell is found, in a time of O(n) for n trajectories. Then, over each cell, the shape of the tool at its
    lowest height is subtracted from the stock, in a time that does not depend on the number of trajectories.

    Parameters
    ----------
    toolpath : Toolpath
        The trajectories.
    tool : Tool
        Only the radius and the shape of the tip are used.
    stock : Solid
        Only the ``lower`` and ``upper`` corners are used, mm.
    parts : int
        Number of height maps. The commands with moves are divided into this number of parts with equally many commands.
        Each map shows the stock after one more part.

    Returns
    -------
    maps : list of (nx, ny) float64
        Height of the stock's surface in every cell, mm. Cells where the toolpath cuts through have the height of the
        stock's lower face. The last height map shows the finished part.
    size : float
        Edge of a cell, mm, which is the larger of 1/100 of the stock's longer side and 1/16 of the tool's radius.
    """
    lower, upper = np.asarray(stock.lower, float), np.asarray(stock.upper, float)
    size = float(max((upper - lower)[:2].max() / _CELLS, tool.radius / _CELLS_PER_RADIUS))
    shape = grid_shape(stock, size)
    margin = int(tool.radius / size)
    origin, spacing = lower[:2] - margin * size, max(size, tool.radius / 3)
    offset = np.arange(-margin, margin + 1) * size
    rise = tool.height(np.hypot(offset[:, None], offset))
    disc = [(dx, dy, rise[dx, dy]) for dx, dy in np.argwhere(np.isfinite(rise)).tolist()]

    heights = np.full(shape, upper[2])
    maps = []
    done = motions_done(toolpath, parts)
    for begin, end in zip(done[:-1], done[1:]):
        tips = np.full(shape + 2 * margin, upper[2])
        _stamp(tips, toolpath.points[begin : end + 1], origin, size, spacing)
        lowered = np.argwhere(tips < upper[2])
        if len(lowered):
            first = np.maximum(lowered.min(axis=0) - 2 * margin, 0)
            last = np.minimum(lowered.max(axis=0) + 1, shape)
            window = heights[first[0] : last[0], first[1] : last[1]]
            for dx, dy, height in disc:
                there = tips[first[0] + dx : last[0] + dx, first[1] + dy : last[1] + dy]
                np.minimum(window, there + height, out=window)
        maps.append(np.maximum(heights, lower[2]))
    return maps, size


def _stamp(tips: np.ndarray, points: np.ndarray, origin: np.ndarray, size: float, spacing: float) -> None:
    """Lower each cell under a polyline to the polyline's height there, at sampled points about `spacing` mm apart."""
    if len(points) == 0:
        return
    moves = np.diff(points, axis=0)
    lengths = np.abs(moves[:, :2]).max(axis=1)
    # If the limit of samples requires a wider spacing, there are still samples in every cell, because such a long
    # toolpath crosses most cells many times.
    spacing = max(spacing, float(lengths.sum()) / _MOST_SAMPLES)
    _lower(tips, points[:1].T, origin, size)
    low = np.flatnonzero(np.minimum(points[:-1, 2], points[1:, 2]) < tips.max())
    start, move = points[low].T, moves[low].T
    counts = (np.ceil(lengths[low] / spacing) + 1).astype(int)
    ends = np.cumsum(counts)
    begin = 0
    while begin < len(low):
        before = ends[begin] - counts[begin]
        end = max(begin + 1, int(np.searchsorted(ends, before + _SAMPLES_AT_ONCE, side="right")))
        part = counts[begin:end]
        step = np.arange(1, ends[end - 1] - before + 1) - np.repeat(ends[begin:end] - part - before, part)
        step = step / np.repeat(part, part)
        sampled = np.repeat(start[:, begin:end], part, axis=1) + step * np.repeat(move[:, begin:end], part, axis=1)
        _lower(tips, sampled, origin, size)
        begin = end


def _lower(tips: np.ndarray, points: np.ndarray, origin: np.ndarray, size: float) -> None:
    """Lower the cells that contain the points `points` (3, k) to the heights of these points."""
    x, y, z = points
    column, row = np.floor((x - origin[0]) / size), np.floor((y - origin[1]) / size)
    inside = np.flatnonzero((column >= 0) & (column < tips.shape[0]) & (row >= 0) & (row < tips.shape[1]))
    if not len(inside):
        return
    # The height maps have fewer than 2^16 cells, so that a cell's index has 16 bits. Numpy sorts 16-bit integers
    # especially fast (radix sort).
    cell = (column[inside] * tips.shape[1] + row[inside]).astype(np.uint16)
    order = np.argsort(cell, kind="stable")
    cell = cell[order]
    first = np.flatnonzero(np.append(True, cell[1:] != cell[:-1]))
    lowest, flat = np.minimum.reduceat(z[inside][order], first), tips.reshape(-1)
    flat[cell[first]] = np.minimum(flat[cell[first]], lowest)


def grid_shape(stock: Solid, size: float) -> np.ndarray:
    """Return the numbers of cells of `size` mm that cover the stock's bounding box in X and Y, (2,) int."""
    side = np.asarray(stock.upper, float)[:2] - np.asarray(stock.lower, float)[:2]
    return np.maximum(np.ceil(side / size - 1e-9), 1).astype(int)


def motions_done(toolpath: Toolpath, parts: int) -> np.ndarray:
    """Return where each of `parts` equal parts of the commands begins, and the end, (parts + 1,) trajectories."""
    moving = np.unique(toolpath.command)
    ends = np.append(moving, toolpath.commands)[np.arange(parts + 1) * len(moving) // parts]
    return np.searchsorted(toolpath.command, ends)
