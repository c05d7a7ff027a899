# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define colours of surfaces: distinct colours for operations, a colour scale for numbers, colours for deviations."""

from __future__ import annotations

import colorsys

import numpy as np

# Colours of gouges and of excess stock. The first colour is used for a deviation as large as the tolerance, the last
# for DEEPEST times the tolerance.
GOUGED = np.array([(244, 166, 154), (214, 39, 40), (120, 0, 20)], np.uint8)
LEFT = np.array([(158, 202, 241), (49, 110, 214), (10, 30, 120)], np.uint8)
# MET: colour of surfaces within the tolerance. NO_MODEL: colour of pixels that do not show the model.
MET, NO_MODEL = (214, 219, 208), (150, 146, 138)
# Deviations of at least this multiple of the tolerance get the darkest colour.
DEEPEST = 10.0

# Colours of the scale at equal distances, from the smallest to the largest number. The colours are samples of viridis
# (van der Walt and Smith 2015). Each colour is brighter than the one before, so the scale is readable without colour
# vision.
SCALE = np.array(
    [(68, 1, 84), (72, 40, 120), (62, 74, 137), (49, 104, 142), (38, 130, 142), (31, 158, 137), (53, 183, 121),
     (110, 206, 88), (181, 222, 43), (253, 231, 37)], np.uint8,
)  # fmt: skip
# Difference between the hues of successive operations, as a share of the colour wheel. With the golden section, even
# many hues differ clearly from each other.
_GOLDEN = 0.618033988749895


# RAW: colour of the raw surface of the stock. CUT: colour of surfaces that a tool cut.
RAW, CUT = (160, 146, 122), (176, 192, 208)


def palette(colors: np.ndarray | tuple[int, int, int]) -> np.ndarray:
    """Return the table of colours: first the colour of the raw stock, then the colour of each trajectory's surfaces.

    Parameters
    ----------
    colors : (n, 3) or (3,) array_like
        Colours of the surfaces that the trajectories cut, 0 to 255.

    Returns
    -------
    (n + 1, 3) or (2, 3) uint8
    """
    return np.vstack((RAW, np.atleast_2d(colors))).astype(np.uint8)


def colors_of(owner: np.ndarray, palette: np.ndarray) -> np.ndarray:
    """Return the colour of each pixel, (height, width, 3) uint8.

    Parameters
    ----------
    owner : (height, width) int32
        Trajectory that cut the surface in each pixel; -1 for the raw stock.
    palette : (n + 1, 3) or (2, 3) uint8
        Colours from :func:`palette`. If there are two colours, all trajectories have the second colour.
    """
    return palette.take(owner + 1, axis=0, mode="clip")


def distinct_colors(count: int) -> np.ndarray:
    """Return `count` colours, (count, 3) uint8. Successive colours are clearly different."""
    hues = 0.58 + _GOLDEN * np.arange(count)  # hues as shares of the colour wheel
    colors = [[round(255 * part) for part in colorsys.hls_to_rgb(hue, 0.6, 0.55)] for hue in hues]
    return np.array(colors, np.uint8).reshape(-1, 3)


def scale_colors(values: np.ndarray) -> np.ndarray:
    """Return the colours that stand for numbers on the colour scale.

    Parameters
    ----------
    values : (n,) ndarray
        Numbers from 0, for the first colour of the scale, to 1, for the last colour. NaN gets the colour of 0.

    Returns
    -------
    (n, 3) uint8
    """
    return _between(SCALE, np.nan_to_num(np.asarray(values, float)))


def difference_colors(left: np.ndarray, gouged: np.ndarray, model: np.ndarray, tolerance: float) -> np.ndarray:
    """Return the colours of a surface by its distance from the model, uint8 with the shape of `left` and 3.

    Parameters
    ----------
    left, gouged : ndarray
        Height of the excess stock above the model, and depth of the gouge below the model, mm, at least 0.
    model : ndarray of bool
        Whether each pixel shows the model. At pixels that do not show the model, `left` is the excess stock in the
        model's through holes.
    tolerance : float
        Largest height that does not count as a deviation, mm. A deviation of `DEEPEST` times the tolerance has the
        darkest colour.
    """
    colors = np.where(model[..., None], np.array(MET, np.uint8), np.array(NO_MODEL, np.uint8))
    for amount, stations in ((left, LEFT), (gouged, GOUGED)):
        where = amount > tolerance
        colors[where] = _between(stations, (amount[where] / tolerance - 1) / (DEEPEST - 1))
    return colors


def _between(stations: np.ndarray, shares: np.ndarray) -> np.ndarray:
    """Interpolate between the colours `stations` at shares of the scale, 0 to 1.

    Shares below 0 get the first colour, and shares above 1 get the last colour.
    """
    at, numbers = shares * (len(stations) - 1), np.arange(len(stations))
    return np.stack([np.interp(at, numbers, stations[:, channel]) for channel in range(3)], axis=-1).astype(np.uint8)
