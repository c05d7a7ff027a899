# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimate the number of triangles in the legacy simulator's mesh from coarse maps of the part."""

from __future__ import annotations

import numpy as np

# A height difference between two cells of the map is a wall if it is at least this number of cell edges, or if it is
# more than twice the height differences beside it. Other height differences are slopes. Lower: steep slopes count as
# walls. Higher: walls beside slopes count as slopes. Both give a wrong number of triangles.
_WALL = 1.8
# Number of triangles per corner of a wall, per cell of a wall, per rectangle on a slope, and in the mesh of an uncut
# box. The numbers were fitted to FreeCAD's meshes (benchmarks/simulators.py).
_CORNER, _ALONG, _RECTANGLE, BOX = 3.6, 0.26, 3.65, 12.0
# Maximum ratio of length to width of FreeCAD's rectangles (VolSim.cpp).
_LONGEST = 5
# Correction factor for the number of rectangles of a lower face. The simulator's grid is finer than the map and follows
# curved outlines more closely. The factor was fitted to FreeCAD's meshes of round holes, discs and slanted cuts.
_FINER = 1.05


def mesh_facets(heights: np.ndarray, size: float, resolution: float, *, floor: np.ndarray, floor_size: float) -> float:
    """Estimate the number of triangles of the mesh that the legacy simulator makes of a stock.

    The simulator covers the stock with rectangles of cells whose heights differ by less than the edge of a cell. On a
    slope with the gradients gx and gy, a rectangle has 1/gx by 1/gy cells, so there are gx gy rectangles per cell.
    Rectangles are at most five times as long as wide. A flat floor has a few rectangles, and a wall has a few per
    corner. A lower face that is cut through is divided into many rectangles, see :func:`bottom_rectangles`. The number
    of these rectangles increases with the number of cells.

    Parameters
    ----------
    heights : (nx, ny) float64
        Map of the heights, mm.
    size : float
        Edge of a cell of the map, mm.
    resolution : float
        Edge of a cell of the simulator, mm.
    floor : (mx, my) bool
        Cells of the lower face where material is left.
    floor_size : float
        Edge of a cell of `floor`, mm.

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
    pieces = 1 if floor.all() else bottom_rectangles(floor)
    finer = size / resolution
    return float(
        BOX
        + finer * (_CORNER * (cells - straight) + _ALONG * cells)
        + finer**2 * _RECTANGLE * (across * along).sum()
        + (floor_size / resolution) ** 2 * 2 * _FINER * max(pieces - 1, 0)
    )


def bottom_rectangles(kept: np.ndarray) -> int:
    """Count the rectangles into which the legacy simulator divides the lower face (``TesselBot`` in VolSim.cpp).

    From the first free cell, a rectangle grows alternately to the right and upwards. If the rectangle becomes more than
    five times as long as wide, FreeCAD by mistake uses a single cell at a distance of five widths instead, and starts
    again. Beside a curved outline, nearly all rectangles are too long, so the face is divided into pieces of about one
    by five cells.

    Parameters
    ----------
    kept : (nx, ny) bool
        Cells where the stock is not cut through.

    Returns
    -------
    int
    """
    # Each row and each column is one integer. Set bits stand for free cells, which have material but no rectangle yet.
    columns, rows = _bits(kept), _bits(kept.T)
    count = 0
    for y in range(len(rows)):
        while rows[y]:
            x = (rows[y] & -rows[y]).bit_length() - 1
            width, height = _grown(columns, rows, x, y)
            corner = x, y
            if height // width > _LONGEST:
                corner, width, height = (x, y + _LONGEST * width), 1, 1
            elif width // height > _LONGEST:
                corner, width, height = (x + _LONGEST * height, y), 1, 1
            _clear(rows, corner[1], height, corner[0], width)
            _clear(columns, corner[0], width, corner[1], height)
            count += 1
    return count


def _grown(columns: list[int], rows: list[int], x: int, y: int) -> tuple[int, int]:
    """Grow a rectangle from the first free cell of a row, and return the rectangle's width and height.

    The row has no free cell to the left of the first free cell, so the rectangle grows only to the right and upwards.
    """
    width = height = 1
    right = up = True
    while up and right:
        side = ((1 << height) - 1) << y
        right = x + width < len(columns) and columns[x + width] & side == side
        width += right
        top = ((1 << width) - 1) << x
        up = y + height < len(rows) and rows[y + height] & top == top
        height += up
    if up:  # the rectangle grows upwards until a column is not free
        height += _ones(_common(columns[x : x + width]) >> (y + height))
    elif right:
        width += _ones(_common(rows[y : y + height]) >> (x + width))
    return width, height


def _bits(cells: np.ndarray) -> list[int]:
    return [int.from_bytes(np.packbits(line, bitorder="little").tobytes(), "little") for line in cells]


def _common(lines: list[int]) -> int:
    bits = -1
    for line in lines:
        bits &= line
    return bits


def _ones(bits: int) -> int:
    """Return the number of consecutive set bits, counted from the lowest bit."""
    return (~bits & (bits + 1)).bit_length() - 1


def _clear(lines: list[int], first: int, count: int, begin: int, length: int) -> None:
    kept = ~(((1 << length) - 1) << begin)
    for k in range(first, first + count):
        lines[k] &= kept


def _may_be_walls(step: np.ndarray, size: float) -> np.ndarray:
    """Return which height differences along the first axis may be walls, bool.

    A wall must also be higher than a cell of the simulator, which this function does not check.
    """
    around = np.pad(step, ((1, 1), (0, 0)))
    alone = (around[:-2] < step / 2) & (around[2:] < step / 2)
    return alone | (step >= _WALL * size)
