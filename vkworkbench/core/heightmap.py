# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coarse maps of what a path leaves of the stock while it is cut: its heights, and its lower face."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.solids import Stock, Tool
from vkworkbench.core.toolpath import Toolpath

_CELLS = 100
_CELLS_PER_RADIUS = 16
_MOST_SAMPLES = 300_000
# The lower face: cells along the longer side, and rows of cells that the tool may pass over in all; more make them wider.
_FLOOR_CELLS = 500
_MOST_ROWS = 300_000


def heightmaps(toolpath: Toolpath, *, tool: Tool, stock: Stock, parts: int = 1) -> tuple[list[np.ndarray], float]:
    """Heights the tool leaves on the stock's bounding box, cut as the legacy simulator does: rapids cut too.

    The lowest height of the tip over each cell is spread over the tool's disc, so the cost is O(n) for the
    path and independent of it for the maps.

    Parameters
    ----------
    toolpath : Toolpath
        The trajectories.
    tool : Tool
        Its radius and the form of its tip.
    stock : Stock
        Anything with ``lower`` and ``upper`` corners, mm.
    parts : int
        How often to look: after every one of so many equal parts of the commands that move.

    Returns
    -------
    maps : list of (nx, ny) float64
        Height of the stock's surface in every cell, mm; at the stock's bottom where the path cuts through.
        The last is that of the whole path.
    size : float
        Edge of a cell, mm: a hundredth of the longer side, or a sixteenth of the tool's radius if that is
        more.
    """
    lower, upper = np.asarray(stock.lower, float), np.asarray(stock.upper, float)
    size = float(max((upper - lower)[:2].max() / _CELLS, tool.radius / _CELLS_PER_RADIUS))
    shape = np.maximum(np.ceil((upper - lower)[:2] / size - 1e-9), 1).astype(int)
    margin = int(tool.radius / size)
    origin, spacing = lower[:2] - margin * size, max(size, tool.radius / 3)
    offset = np.arange(-margin, margin + 1) * size
    rise = tool.height(np.hypot(offset[:, None], offset))
    disc = [(dx, dy, rise[dx, dy]) for dx, dy in np.argwhere(np.isfinite(rise)).tolist()]

    heights = np.full(shape, upper[2])
    maps = []
    done = _parts(toolpath, parts)
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


def floors(
    toolpath: Toolpath, *, tool: Tool, stock: Stock, thickness: float, parts: int = 1
) -> tuple[list[np.ndarray], float]:
    """Where the path leaves the lower face of the stock's bounding box.

    Finer than :func:`heightmaps`: only what cuts through counts, a disc swept along a line, and a row of cells lies in
    one interval of it.

    Parameters
    ----------
    toolpath, tool, stock, parts
        As in :func:`heightmaps`.
    thickness : float
        What is left is no more than this where it counts as cut through, mm.

    Returns
    -------
    kept : list of (nx, ny) bool
        For each part.
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
    # Only as far as the tip is below the level.
    rise = end[:, 2] - begin[:, 2]
    crossing = (level - begin[:, 2]) / np.where(rise == 0, 1, rise)
    first, last = np.where(begin[:, 2] > level, crossing, 0), np.where(end[:, 2] > level, crossing, 1)
    begin, end = (begin[:, :2] + part[:, None] * (end - begin)[:, :2] - lower[:2] for part in (first, last))

    across = np.abs(end - begin)[:, 1] + 2 * radius
    size = float(max((upper - lower)[:2].max() / _FLOOR_CELLS, across.sum() / _MOST_ROWS))
    columns, rows = np.maximum(np.ceil((upper - lower)[:2] / size - 1e-9), 1).astype(int)
    of, row, left, right = _swept_rows(begin, end, radius, size, columns, rows)
    part = np.searchsorted(_parts(toolpath, parts)[1:], through[of], side="right")
    kept, all_kept = np.ones((rows, columns), bool), []
    for k in range(parts):
        here = part == k
        if here.any():
            edges = np.zeros(rows * (columns + 1), int)
            for column, step in ((left, 1), (right, -1)):
                edges += step * np.bincount((row * (columns + 1) + column)[here], minlength=len(edges))
            kept = kept & (np.cumsum(edges).reshape(rows, -1)[:, :-1] == 0)
        all_kept.append(kept.T)
    return all_kept, size


def _swept_rows(begin, end, radius, size, columns, rows) -> tuple[np.ndarray, ...]:
    """Cells under discs swept along lines: index of the line, row, first column and the one after the last."""
    lowest = np.ceil((np.minimum(begin, end)[:, 1] - radius) / size - 0.5).clip(0, rows).astype(int)
    highest = np.floor((np.maximum(begin, end)[:, 1] + radius) / size - 0.5).clip(-1, rows - 1).astype(int)
    counts = np.maximum(highest - lowest + 1, 0)
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


def _parts(toolpath: Toolpath, parts: int) -> np.ndarray:
    """Motions done before and after each of so many equal parts of the commands that move."""
    moving = np.unique(toolpath.command)
    ends = np.append(moving, toolpath.commands)[np.arange(parts + 1) * len(moving) // parts]
    return np.searchsorted(toolpath.command, ends)


def _stamp(tips: np.ndarray, points: np.ndarray, origin: np.ndarray, size: float, spacing: float) -> None:
    """Lower the cells that a polyline passes over to its height there, sampled at most `spacing` apart."""
    if len(points) == 0:
        return
    moves = np.diff(points, axis=0)
    lengths = np.abs(moves[:, :2]).max(axis=1, initial=0)
    # A path so long that it needs more passes over every cell many times.
    spacing = max(spacing, float(lengths.sum()) / _MOST_SAMPLES)
    samples = np.ceil(lengths / spacing) + 1
    counts = samples.astype(int)
    of = np.repeat(np.arange(len(moves)), counts)
    step = (np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts) + 1) / counts[of]
    position = np.concatenate((points[:1], points[of] + step[:, None] * moves[of]))
    cell = np.floor((position[:, :2] - origin) / size).astype(int)
    inside = ((cell >= 0) & (cell < tips.shape)).all(axis=1)
    np.minimum.at(tips, tuple(cell[inside].T), position[inside, 2])
