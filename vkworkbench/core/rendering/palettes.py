# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of surfaces: distinct ones for operations, a scale for numbers."""

from __future__ import annotations

import colorsys

import numpy as np

# Red, green and blue from the least to the most, at equal distances: dark to bright, so that it reads without colour
# too. Stations of viridis (van der Walt and Smith 2015).
SCALE = np.array(
    [(68, 1, 84), (72, 40, 120), (62, 74, 137), (49, 104, 142), (38, 130, 142), (31, 158, 137), (53, 183, 121),
     (110, 206, 88), (181, 222, 43), (253, 231, 37)], np.uint8,
)  # fmt: skip
# A turn of the hue after which no two of many lie close together: the golden section.
_GOLDEN = 0.618033988749895


# The raw surface of the stock, and what a tool made of it.
RAW, CUT = (160, 146, 122), (176, 192, 208)


def palette(colors: np.ndarray) -> np.ndarray:
    """Return the colours of surfaces by who made them: the raw stock's first, then each trajectory's.

    Parameters
    ----------
    colors : (n, 3) or (3,) array_like
        Of the trajectories' surfaces, 0 to 255.

    Returns
    -------
    (n + 1, 3) or (2, 3) uint8
    """
    return np.vstack((RAW, np.atleast_2d(colors))).astype(np.uint8)


def colors_of(owner: np.ndarray, palette: np.ndarray) -> np.ndarray:
    """Return the colour of each pixel, the shape of `owner` and 3.

    Parameters
    ----------
    owner : (height, width) int32
        Trajectory that made the surface, -1 for the stock's own.
    palette : (n + 1, 3) or (2, 3) uint8
        See :func:`palette`; of two colours the second is that of all trajectories.
    """
    return palette.take(owner + 1, axis=0, mode="clip")


def distinct_colors(count: int) -> np.ndarray:
    """Return so many colours that neighbours in the list differ well, (count, 3) uint8."""
    hues = (0.58 + _GOLDEN * np.arange(count)) % 1
    colors = [[round(255 * part) for part in colorsys.hls_to_rgb(hue, 0.6, 0.55)] for hue in hues]
    return np.array(colors, np.uint8).reshape(-1, 3)


def scale_colors(values: np.ndarray) -> np.ndarray:
    """Return the colours of numbers on the scale.

    Parameters
    ----------
    values : (n,) ndarray
        0 for the least to 1 for the most; not a number counts as 0.

    Returns
    -------
    (n, 3) uint8
    """
    at = np.clip(np.nan_to_num(np.asarray(values, float)), 0, 1) * (len(SCALE) - 1)
    stations = np.arange(len(SCALE))
    return np.stack([np.interp(at, stations, SCALE[:, channel]) for channel in range(3)], axis=-1).astype(np.uint8)
