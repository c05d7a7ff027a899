# SPDX-License-Identifier: LGPL-2.1-or-later
"""A coarse map of the heights a path leaves, and the size of the legacy simulator's mesh of it."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.solids import Stock, Tool
from vkworkbench.core.toolpath import Toolpath

_CELLS = 100
_CELLS_PER_RADIUS = 16
_MOST_SAMPLES = 300_000

# A step between two cells of the map that is no slope: higher than this many cells, or alone among flat ones.
_WALL = 1.8
# Triangles per corner of a wall, per cell of wall, per rectangle on a slope, of a plain box; per cell of a
# bottom that is cut through, for each corner of its outline beyond a few, at most where it only has holes (in
# up to a share of its cells), and at most. Fitted to FreeCAD's meshes, see benchmarks/simulators.py.
_CORNER, _ALONG, _RECTANGLE, _BOX = 3.6, 0.26, 3.65, 12.0
_PER_CORNER, _FEW_CORNERS, _HOLED, _HOLES, _PIECES = 0.002, 8, 0.04, 0.05, 0.5
# FreeCAD's rectangles are no longer than this many times their width (VolSim.cpp).
_LONGEST = 5.0


def heightmap(toolpath: Toolpath, *, tool: Tool, stock: Stock) -> tuple[np.ndarray, float]:
    """Heights the tool leaves on the stock's bounding box, cut as the legacy simulator does: rapids cut too.

    The lowest height of the tip over each cell is spread over the tool's disc, so the cost is O(n) for the
    path and independent of it for the map.

    Parameters
    ----------
    toolpath : Toolpath
        The trajectories.
    tool : Tool
        Its radius and the form of its tip.
    stock : Stock
        Anything with ``lower`` and ``upper`` corners, mm.

    Returns
    -------
    heights : (nx, ny) float64
        Height of the stock's surface in every cell, mm; at the stock's bottom where the path cuts through.
    size : float
        Edge of a cell, mm: a hundredth of the longer side, or a sixteenth of the tool's radius if that is
        more.
    """
    lower, upper = np.asarray(stock.lower, float), np.asarray(stock.upper, float)
    size = float(max((upper - lower)[:2].max() / _CELLS, tool.radius / _CELLS_PER_RADIUS))
    shape = np.maximum(np.ceil((upper - lower)[:2] / size - 1e-9), 1).astype(int)
    margin = int(tool.radius / size)
    tips = np.full(shape + 2 * margin, upper[2])
    _stamp(tips, toolpath.points, lower[:2] - margin * size, size, max(size, tool.radius / 3))

    heights = np.full(shape, upper[2])
    offset = np.arange(-margin, margin + 1) * size
    rise = tool.height(np.hypot(offset[:, None], offset))
    for dx, dy in np.argwhere(np.isfinite(rise)).tolist():
        lowered = tips[dx : dx + shape[0], dy : dy + shape[1]] + rise[dx, dy]
        np.minimum(heights, lowered, out=heights)
    return np.maximum(heights, lower[2]), size


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


def mesh_facets(heights: np.ndarray, size: float, bottom: float, resolution: float) -> float:
    """Triangles of the mesh that the legacy simulator makes of a stock.

    It covers the stock with rectangles whose cells differ by less than one cell's edge. On a slope of (gx,
    gy) such a rectangle spans 1/gx by 1/gy cells and at most 5:1, so a cell has gx gy of them; a floor has a
    few and each wall a few per corner. A bottom that is cut through falls to pieces of one cell, because a
    rectangle longer than 5:1 is not found again there (a slip in ``TesselBot``, VolSim.cpp): the more, the
    more corners its outline has.

    Parameters
    ----------
    heights : (nx, ny) float64
        Map of the heights, mm.
    size : float
        Edge of a cell of the map, mm.
    bottom : float
        Height of the stock's lower face, mm.
    resolution : float
        Edge of a cell of the simulator, mm.

    Returns
    -------
    float
        Number of triangles, inner and outer mesh together.
    """
    finer = size / resolution
    step_x, step_y = np.abs(np.diff(heights, axis=0)), np.abs(np.diff(heights, axis=1))
    wall_x, wall_y = _walls(step_x, size, resolution), _walls(step_y.T, size, resolution).T
    cells = wall_x.sum() + wall_y.sum()
    straight = (wall_x[:, 1:] & wall_x[:, :-1]).sum() + (wall_y[1:] & wall_y[:-1]).sum()

    slope_x, slope_y = np.zeros(heights.shape), np.zeros(heights.shape)
    slope_x[:-1] = np.where(wall_x, 0, step_x) / size
    slope_y[:, :-1] = np.where(wall_y, 0, step_y) / size
    across = np.minimum(np.maximum(slope_x, slope_y / _LONGEST), 1)
    along = np.minimum(np.maximum(slope_y, slope_x / _LONGEST), 1)

    return float(_BOX + finer * (_CORNER * (cells - straight) + _ALONG * cells)
                 + finer**2 * (_RECTANGLE * (across * along).sum() + _bottom(heights > bottom + resolution))
    )  # fmt: skip


def _bottom(kept: np.ndarray) -> float:
    """Triangles of the lower face for each cell of the simulator in a cell of the map."""
    whole = kept.astype(np.int8)
    corners = int(((whole[1:, 1:] + whole[1:, :-1] + whole[:-1, 1:] + whole[:-1, :-1]) % 2).sum())
    # A hole spoils the rectangles beside it only.
    most = _HOLED if kept.mean() > 1 - _HOLES and _border(kept).all() else _PIECES
    return min(_PER_CORNER * max(corners - _FEW_CORNERS, 0), most) * float(kept.sum())


def _border(cells: np.ndarray) -> np.ndarray:
    return np.concatenate((cells[0], cells[-1], cells[:, 0], cells[:, -1]))


def _walls(step: np.ndarray, size: float, resolution: float) -> np.ndarray:
    """Which steps along the first axis are walls."""
    around = np.pad(step, ((1, 1), (0, 0)))
    alone = (around[:-2] < step / 2) & (around[2:] < step / 2)
    return (step > resolution) & (alone | (step >= _WALL * size))
