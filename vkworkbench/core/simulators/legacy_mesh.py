# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimate the number of triangles in the legacy simulator's mesh from coarse maps of the part."""

from __future__ import annotations

import numpy as np

# A height difference between two neighbouring cells of the height map is a wall if its ratio to the edge of a cell is
# at least this value. A smaller height difference is also a wall if it is more than twice each neighbouring height
# difference; otherwise the height difference is a slope. With a lower value, steep slopes count as walls. With a higher
# value, walls beside slopes count as slopes. With a wrong value, the estimated number of triangles is wrong.
_WALL = 1.8
# Number of triangles per corner of a wall (_CORNER), per cell along a wall (_ALONG), per rectangle on a slope
# (_RECTANGLE), and in the mesh of an uncut box (BOX). The numbers were fitted to FreeCAD's meshes
# (benchmarks/simulators.py).
_CORNER, _ALONG, _RECTANGLE, BOX = 3.6, 0.26, 3.65, 12.0
# Maximum ratio of length to width of FreeCAD's rectangles (VolSim.cpp).
_LONGEST = 5


def mesh_facets(heights: np.ndarray, size: float, resolution: float, *, lower: float) -> float:
    """Estimate the number of triangles of the mesh that the legacy simulator makes from its grid of heights.

    The simulator covers the stock with rectangles of cells whose heights differ by less than the edge of a cell. On a
    slope with the gradients gx and gy, a rectangle has 1/gx by 1/gy cells, so there are gx times gy rectangles per
    cell. Rectangles are at most five times as long as wide. A flat floor of the part is covered by a few rectangles,
    and each corner of a wall adds a few rectangles. If the stock is cut through, its lower face is divided into many
    rectangles, whose number increases with the number of cells; see :func:`bottom_rectangles`.

    Parameters
    ----------
    heights : (nx, ny) float64
        Coarse map of the heights of the stock's surface, mm.
    size : float
        Edge of a cell of the map, mm.
    resolution : float
        Edge of a cell of the simulator, mm.
    lower : float
        Height of the stock's lower face, mm.

    Returns
    -------
    float
        Number of triangles of the inner and the outer mesh together.
    """
    step_x, step_y = np.abs(np.diff(heights, axis=0)), np.abs(np.diff(heights, axis=1))
    wall_x = _may_be_walls(step_x, size) & (step_x > resolution)
    wall_y = _may_be_walls(step_y.T, size).T & (step_y > resolution)
    cells = wall_x.sum() + wall_y.sum()
    straight = (wall_x[:, 1:] & wall_x[:, :-1]).sum() + (wall_y[1:] & wall_y[:-1]).sum()
    slope_x, slope_y = np.zeros(heights.shape), np.zeros(heights.shape)
    slope_x[:-1] = np.where(wall_x, 0, step_x) / size
    slope_y[:, :-1] = np.where(wall_y, 0, step_y) / size
    across = np.minimum(np.maximum(slope_x, slope_y / _LONGEST), 1)
    along = np.minimum(np.maximum(slope_y, slope_x / _LONGEST), 1)
    kept = heights > lower + resolution  # stock thinner than the edge of a cell counts as cut through
    pieces = 1 if kept.all() else bottom_rectangles(kept)
    finer = size / resolution
    return float(
        BOX
        + finer * (_CORNER * (cells - straight) + _ALONG * cells)
        + finer**2 * (_RECTANGLE * (across * along).sum() + 2 * max(pieces - 1, 0))
    )


def bottom_rectangles(kept: np.ndarray) -> int:
    """Count the rectangles into which the legacy simulator divides the lower face (``TesselBot`` in VolSim.cpp).

    `kept` (nx, ny) is False for the cells in which the stock is cut through. From the first free cell, a rectangle
    grows alternately to the right and upwards. If the rectangle is more than five times as long as wide, FreeCAD,
    because of an error, covers only a single cell, at a distance of five widths, and starts again. Beside a curved
    outline, nearly all rectangles are too long, so the face is divided into pieces of about one by five cells.
    """
    # Each row of cells is stored as one integer, with one bit for each cell. A set bit means a free cell, which has
    # material and belongs to no rectangle yet.
    rows = [int.from_bytes(np.packbits(line, bitorder="little").tobytes(), "little") for line in kept.T]
    count = 0
    for y in range(len(rows)):
        while rows[y]:
            x = (rows[y] & -rows[y]).bit_length() - 1
            width, height = _grown(rows, x, y)
            first = y
            if height // width > _LONGEST:
                first, width, height = y + _LONGEST * width, 1, 1
            elif width // height > _LONGEST:
                x, width, height = x + _LONGEST * height, 1, 1
            for k in range(first, first + height):
                rows[k] &= ~_mask(x, width)
            count += 1
    return count


def _grown(rows: list[int], x: int, y: int) -> tuple[int, int]:
    """Grow a rectangle from the first free cell of a row, and return the rectangle's width and height.

    All cells of the row to the left of the first free cell are covered already, so the rectangle grows only to the
    right and upwards.
    """
    width = height = 1
    right = up = True
    while right or up:
        right = right and all(row >> (x + width) & 1 for row in rows[y : y + height])
        width += right
        mask = _mask(x, width)
        up = up and y + height < len(rows) and rows[y + height] & mask == mask
        height += up
    return width, height


def _mask(x: int, width: int) -> int:
    """Return an integer in which the bits of `width` cells from column `x` on are set."""
    return ((1 << width) - 1) << x


def _may_be_walls(step: np.ndarray, size: float) -> np.ndarray:
    """Return whether each height difference along the first axis can be a wall, bool.

    The caller checks the second condition: a wall is higher than the edge of a cell of the simulator.
    """
    around = np.pad(step, ((1, 1), (0, 0)))
    alone = (around[:-2] < step / 2) & (around[2:] < step / 2)
    return alone | (step >= _WALL * size)
