# SPDX-License-Identifier: LGPL-2.1-or-later
"""A depth image as a shaded part: light by the surface's slope, dark lines where depth jumps."""

from __future__ import annotations

import numpy as np

BACKGROUND = (232, 235, 240)
# The light comes over the eye's left shoulder: right, up, towards the eye.
_LIGHT = np.array([-0.35, 0.5, 0.79], np.float32)
_AMBIENT = np.float32(0.38)
# A line is drawn where the slope changes by more than this from one pixel to the next, and is darkest at twice that:
# scallops and cusps of a finished surface stay below, the steps of roughing above.
_CREASE = np.float32(1.2)
_DARKEST = np.float32(0.45)


def shade(
    depth: np.ndarray, pixel: float, colors: np.ndarray, background: tuple[int, int, int] = BACKGROUND
) -> np.ndarray:
    """Return a shaded picture of a surface.

    Parameters
    ----------
    depth : (height, width) float32
        Depth along the view at every pixel, mm, row 0 below; not a number where nothing is seen.
    pixel : float
        Side of a pixel, mm.
    colors : (3,) or (height, width, 3) array of uint8
        The surface's own colour.
    background : tuple of int
        Red, green and blue, 0 to 255, where nothing is seen.

    Returns
    -------
    (height, width, 3) uint8
        Row 0 at the top, as pictures have it.
    """
    seen = ~np.isnan(depth)
    # Beside the part the surface goes on as it is: its outline has the light of its edge.
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
    """Rise of the surface towards the eye along an axis of the image; the smaller of the two sides' at a jump."""
    before, after = _steps(depth, -pixel, axis)
    return np.nan_to_num(np.where(np.abs(before) < np.abs(after), before, after))


def _bends(depth: np.ndarray, pixel: float, axis: int) -> np.ndarray:
    """How much the slope changes at each pixel; nothing beside the part."""
    before, after = _steps(depth, pixel, axis)
    result: np.ndarray = np.nan_to_num(np.abs(after - before))
    return result


def _steps(depth: np.ndarray, unit: float, axis: int) -> tuple[np.ndarray, np.ndarray]:
    """The differences to the pixel before and after each, in `unit`; at the outline the only one counts as both."""
    around = [(1, 1) if side == axis else (0, 0) for side in (0, 1)]
    step = np.diff(np.pad(depth, around, constant_values=np.nan), axis=axis) / np.float32(unit)
    before, after = (step[:-1], step[1:]) if axis == 0 else (step[:, :-1], step[:, 1:])
    return np.where(np.isnan(before), after, before), np.where(np.isnan(after), before, after)
