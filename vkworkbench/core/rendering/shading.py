# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shade a depth image: brightness is computed from the slope of the surface, and sharp bends and edges are dark."""

from __future__ import annotations

import numpy as np

BACKGROUND = (232, 235, 240)
# Direction to the light, with components to the right, upwards and towards the viewer. The light comes from the upper
# left, behind the viewer.
LIGHT = np.array([-0.35, 0.5, 0.79], np.float32)
_AMBIENT = np.float32(0.38)
# Brightness of a surface that faces the light. A surface that faces the viewer has the brightness 1.
BRIGHTEST = float(_AMBIENT + (1 - _AMBIENT) * np.linalg.norm(LIGHT) / LIGHT[2])
# EMPTY: height of the top of an empty cell, mm. The height is finite, because vertical views multiply it by 0.
# _TO_NOTHING: a slope above this value means that one of the two neighbouring cells is empty.
EMPTY, _TO_NOTHING = -1e9, np.float32(1e5)
# Slope above which a surface is drawn as a vertical wall.
STEEPEST = np.float32(3.0)
# Pockets are drawn with a soft shadow. _SHADOW: share of the light that the deepest pockets lose. _SHADOW_REACH: a
# height is compared with the mean height within this radius, a share of the shorter side of the map of heights.
# _SHADOW_CELLS: distance between the heights that are sampled for the mean height, in cells.
_SHADOW, _SHADOW_REACH, _SHADOW_CELLS = np.float32(0.45), 0.02, 2
# _CREASE: change of slope between neighbouring pixels above which a dark line is drawn along the bend. At twice the
# change _CREASE, the line is darkest, and loses the share _DARKEST of its light. With a smaller _CREASE, the scallops
# of a finished surface get dark lines. With a larger _CREASE, the steps of roughing get no lines.
_CREASE = np.float32(1.2)
_DARKEST = np.float32(0.45)
# Share of the light that a near surface loses along its edge in front of a far surface.
EDGE = np.float32(0.35)


def shade(depth: np.ndarray, pixel: float, colors: np.ndarray) -> np.ndarray:
    """Return a shaded picture of a surface.

    Parameters
    ----------
    depth : (height, width) float32
        Depth along the view at every pixel, mm, row 0 at the bottom; NaN where the image is empty.
    pixel : float
        Side of a pixel, mm.
    colors : (3,) or (height, width, 3) array of uint8
        Colour of the surface.

    Returns
    -------
    (height, width, 3) uint8
        The picture, row 0 at the top.
    """
    seen = ~np.isnan(depth)
    height = np.pad(np.where(seen, -depth, np.float32(EMPTY)), 1, constant_values=EMPTY)
    right, up = (slope(height, pixel, axis)[1:-1, 1:-1] for axis in (1, 0))
    bend = np.maximum(_bends(depth, pixel, 1), _bends(depth, pixel, 0))
    light = (LIGHT[2] - LIGHT[0] * right - LIGHT[1] * up) / np.sqrt(1 + right * right + up * up)
    light = _AMBIENT + (1 - _AMBIENT) * np.maximum(light, 0) / LIGHT[2]
    light *= 1 - _DARKEST * np.clip(bend / _CREASE - 1, 0, 1)
    light[~seen] = 0
    image = np.empty((*depth.shape, 3), np.uint8)
    colors = np.asarray(colors)
    for channel in range(3):
        image[..., channel] = np.minimum(light * colors[..., channel], 255)
        image[..., channel][~seen] = BACKGROUND[channel]
    return image[::-1]


def _bends(depth: np.ndarray, pixel: float, axis: int) -> np.ndarray:
    """Return the change of slope at each pixel along an axis; 0 outside the part."""
    before, after = _steps(depth, pixel, axis)
    return np.nan_to_num(np.abs(after - before))


def _steps(depth: np.ndarray, unit: float, axis: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the differences in depth from the previous pixel and to the next pixel, as multiples of `unit`.

    At the outline of the part, only one of the two differences exists, and it is returned twice.
    """
    around = [(1, 1) if side == axis else (0, 0) for side in (0, 1)]
    step = np.diff(np.pad(depth, around, constant_values=np.nan), axis=axis) / np.float32(unit)
    before, after = (step[:-1], step[1:]) if axis == 0 else (step[:, :-1], step[:, 1:])
    return np.where(np.isnan(before), after, before), np.where(np.isnan(after), before, after)


def slope(height: np.ndarray, cell: float, axis: int) -> np.ndarray:
    """Return the slope of a height field (n, m), mm, along an axis, (n, m) float32. `cell` is the side of a cell, mm.

    The slope of a cell is the smaller of the slopes to its two neighbours along the axis; between two empty cells it is
    0.
    """
    height = height.T if axis == 0 else height
    step = (height[:, 1:] - height[:, :-1]) * np.float32(1 / cell)
    size = np.abs(step)
    result = np.zeros_like(height)
    result[:, 1:-1] = np.where(size[:, :-1] < size[:, 1:], step[:, :-1], step[:, 1:])
    result[np.abs(result) > _TO_NOTHING] = 0
    np.clip(result, -STEEPEST, STEEPEST, out=result)
    return result.T if axis == 0 else result


def shadow(height: np.ndarray, cell: float) -> np.ndarray:
    """Return the share of the light that reaches each cell of a height field (n, m), mm, (n, m) float32.

    The share decreases with the cell's depth below the mean height of its surroundings. `cell` is the side of a cell,
    mm.
    """
    coarse = height[::_SHADOW_CELLS, ::_SHADOW_CELLS]
    around = coarse
    reach = max(1, round(_SHADOW_REACH * min(coarse.shape)))
    for _ in range(2):
        around = _mean_of_rows(around, reach).T
    around = around.repeat(_SHADOW_CELLS, axis=0).repeat(_SHADOW_CELLS, axis=1)[: height.shape[0], : height.shape[1]]
    deep = (around - height) * np.float32(1 / (_SHADOW_CELLS * cell * (2 * reach + 1)))
    return 1 - _SHADOW * np.clip(deep, 0, 1)


def _mean_of_rows(values: np.ndarray, reach: int) -> np.ndarray:
    """Return, for each value, the mean of the values in its row that are at most `reach` positions away.

    At both ends, each row is padded with its first and last value.
    """
    padded = np.pad(values, [(0, 0), (reach + 1, reach)], mode="edge")
    sums = np.cumsum(padded, axis=1, dtype=np.float64)
    length = 2 * reach + 1
    return ((sums[:, length:] - sums[:, :-length]) / length).astype(np.float32)


def light(normal: tuple[np.ndarray, ...], towards: np.ndarray) -> np.ndarray:
    """Return the brightness of surfaces from ambient light and Lambert's law; it is 1 if a surface faces the viewer.

    `normal` contains the components x, y and z of the unit normals of the surfaces, and `towards` (3,) the direction to
    the light, see `LIGHT`, in the coordinates of the normals.
    """
    x, y, z = normal
    toward_x, toward_y, toward_z = (np.float32(part) for part in towards)
    share = x * toward_x
    share += y * toward_y
    share += z * toward_z
    np.maximum(share, 0, out=share)
    share *= (1 - _AMBIENT) / LIGHT[2]
    share += _AMBIENT
    return share
