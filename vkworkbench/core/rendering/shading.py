# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shading of a depth image: light by the slope of the surface, dark lines at jumps in depth."""

from __future__ import annotations

import numpy as np

BACKGROUND = (232, 235, 240)
# Direction to the light (right, up, towards the eye): over the left shoulder of the viewer.
_LIGHT = np.array([-0.35, 0.5, 0.79], np.float32)
_AMBIENT = np.float32(0.38)
# Change of slope from one pixel to the next at which a dark line begins; at twice the change it is darkest. Scallops of a
# finished surface are below the limit, the steps of roughing above it.
_CREASE = np.float32(1.2)
_DARKEST = np.float32(0.45)


def shade(
    depth: np.ndarray, pixel: float, colors: np.ndarray, background: tuple[int, int, int] = BACKGROUND
) -> np.ndarray:
    """Return a shaded picture of a surface.

    Parameters
    ----------
    depth : (height, width) float32
        Depth along the view at every pixel, mm, row 0 below; NaN where the image is empty.
    pixel : float
        Side of a pixel, mm.
    colors : (3,) or (height, width, 3) array of uint8
        Colour of the surface.
    background : tuple of int
        Red, green and blue, 0 to 255, of empty pixels.

    Returns
    -------
    (height, width, 3) uint8
        The picture, row 0 at the top.
    """
    seen = ~np.isnan(depth)
    # The slope at the outline is that of the one neighbour inside the part.
    right, up = _slopes(depth, pixel, 1), _slopes(depth, pixel, 0)
    bend = np.maximum(_bends(depth, pixel, 1), _bends(depth, pixel, 0))
    light = (_LIGHT[2] - _LIGHT[0] * right - _LIGHT[1] * up) / np.sqrt(1 + right * right + up * up)
    light = _AMBIENT + (1 - _AMBIENT) * np.maximum(light, 0) / _LIGHT[2]
    light *= 1 - _DARKEST * np.clip(bend / _CREASE - 1, 0, 1)
    light[~seen] = 0
    image = np.empty((*depth.shape, 3), np.uint8)
    colors = np.asarray(colors)
    for channel in range(3):
        image[..., channel] = np.minimum(light * colors[..., channel], 255)
        image[..., channel][~seen] = background[channel]
    return image[::-1]


def _slopes(depth: np.ndarray, pixel: float, axis: int) -> np.ndarray:
    """Return the slope of the surface towards the eye along an image axis; at a jump, the smaller slope of the two sides."""
    before, after = _steps(depth, -pixel, axis)
    return np.nan_to_num(np.where(np.abs(before) < np.abs(after), before, after))


def _bends(depth: np.ndarray, pixel: float, axis: int) -> np.ndarray:
    """Return the change of slope at each pixel; 0 outside the part."""
    before, after = _steps(depth, pixel, axis)
    result: np.ndarray = np.nan_to_num(np.abs(after - before))
    return result


def _steps(depth: np.ndarray, unit: float, axis: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the differences to the pixel before and after each, in `unit`; at the outline, both are the existing one."""
    around = [(1, 1) if side == axis else (0, 0) for side in (0, 1)]
    step = np.diff(np.pad(depth, around, constant_values=np.nan), axis=axis) / np.float32(unit)
    before, after = (step[:-1], step[1:]) if axis == 0 else (step[:, :-1], step[:, 1:])
    return np.where(np.isnan(before), after, before), np.where(np.isnan(after), before, after)
