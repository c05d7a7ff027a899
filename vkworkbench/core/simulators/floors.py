# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute coarse maps of the places where a toolpath leaves material at the stock's lower face."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.simulators.heightmap import grid_shape, motions_done
from vkworkbench.core.stocks import Solid
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath

# Number of cells along the stock's longer side, and limit for the number of rows of cells that all moves together
# cross. If the moves would cross more rows, the cells are made larger, so that the time stays bounded.
_CELLS = 500
_MOST_ROWS = 300_000


def floors(
    toolpath: Toolpath, *, tool: Tool, stock: Solid, thickness: float, parts: int = 1
) -> tuple[list[np.ndarray], float]:
    """Map where the toolpath leaves material at the lower face of the stock's bounding box.

    Only the moves that cut through the stock count. Each of these moves sweeps a disc along a line and covers one
    interval in each row of cells. This takes less time than a map of the heights, so the cells can be smaller.

    Parameters
    ----------
    toolpath, tool, stock, parts
        As in :func:`~vkworkbench.core.simulators.heightmap.heightmaps`.
    thickness : float
        Maximum thickness of material that counts as cut through, mm.

    Returns
    -------
    kept : list of (nx, ny) bool
        Cells where material is left after each part.
    size : float
        Edge of a cell, mm.
    """
    lower, upper = np.asarray(stock.lower, float), np.asarray(stock.upper, float)
    level, points = lower[2] + thickness, toolpath.points
    lowest = np.minimum(points[:-1, 2], points[1:, 2])
    through = np.flatnonzero(lowest <= level)
    begin, end = points[through], points[through + 1]
    width = np.linspace(0, tool.radius, 65)
    radius = width[np.searchsorted(tool.height(width), level - lowest[through], side="right") - 1]
    # Shorten each move to the piece on which the tip is below the level.
    rise = end[:, 2] - begin[:, 2]
    crossing = (level - begin[:, 2]) / np.where(rise == 0, 1, rise)
    first, last = np.where(begin[:, 2] > level, crossing, 0), np.where(end[:, 2] > level, crossing, 1)
    begin, end = (begin[:, :2] + part[:, None] * (end - begin)[:, :2] - lower[:2] for part in (first, last))

    across = np.abs(end - begin)[:, 1] + 2 * radius
    size = float(max((upper - lower)[:2].max() / _CELLS, across.sum() / _MOST_ROWS))
    columns, rows = grid_shape(stock, size)
    of, row, left, right = _swept_rows(begin, end, radius, size, columns, rows)
    part = np.searchsorted(motions_done(toolpath, parts)[1:], through[of], side="right")
    kept, all_kept = np.ones((rows, columns), bool), []
    for k in range(parts):
        here = part == k
        if here.any():
            edges = np.zeros(rows * (columns + 1), int)
            for column, step in ((left, 1), (right, -1)):
                edges += step * np.bincount((row * (columns + 1) + column)[here], minlength=len(edges))
            covered = np.cumsum(edges).reshape(rows, -1)[:, :-1] > 0
            kept = kept & ~covered
        all_kept.append(kept.T)
    return all_kept, size


def _swept_rows(
    begin: np.ndarray, end: np.ndarray, radius: np.ndarray, size: float, columns: int, rows: int
) -> tuple[np.ndarray, ...]:
    """Return the cells under discs swept along lines, row by row.

    Returns
    -------
    of, row, first, after : (k,) int64
        Index of the line, row, first column, and the column after the last.
    """
    lowest = np.ceil((np.minimum(begin, end)[:, 1] - radius) / size - 0.5).clip(0, rows).astype(int)
    above = (np.floor((np.maximum(begin, end)[:, 1] + radius) / size - 0.5) + 1).clip(0, rows).astype(int)
    counts = np.maximum(above - lowest, 0)
    of = np.repeat(np.arange(len(counts)), counts)
    row = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts) + lowest[of]
    y = (row + 0.5) * size

    line = end - begin
    side = np.stack((-line[:, 1], line[:, 0]), axis=1) * (radius / np.maximum(np.hypot(*line.T), 1e-12))[:, None]
    left, right = np.full(len(of), np.inf), np.full(len(of), -np.inf)
    for centre in (begin[of], end[of]):
        half = radius[of] ** 2 - (y - centre[:, 1]) ** 2
        reach = np.where(half >= 0, np.sqrt(np.maximum(half, 0)), -np.inf)
        left, right = np.minimum(left, centre[:, 0] - reach), np.maximum(right, centre[:, 0] + reach)
    for corner in (begin[of] + side[of], begin[of] - side[of]):
        along = (y - corner[:, 1]) / np.where(line[of, 1] == 0, np.inf, line[of, 1])
        x = corner[:, 0] + along * line[of, 0]
        crosses = (along > 0) & (along < 1)
        left, right = np.where(crosses, np.minimum(left, x), left), np.where(crosses, np.maximum(right, x), right)
    first = np.ceil(left / size - 0.5).clip(0, columns).astype(int)
    after = (np.floor(right / size - 0.5) + 1).clip(0, columns).astype(int)
    filled = first < after
    return of[filled], row[filled], first[filled], after[filled]
