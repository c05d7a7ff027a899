# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the eye looks, and where points of the space lie in its image."""

from __future__ import annotations

from math import atan2, cos, hypot, pi, sin

import numpy as np

from vkworkbench.core.view import VERTICAL, Frame

# As near to the vertical as turning comes: there the image would have no upright.
_STEEPEST = pi / 2 - 1e-3


def turned(direction: tuple[float, float, float], across: float, up: float) -> tuple[float, float, float]:
    """Turn the view about the vertical and towards it, as a turntable.

    Parameters
    ----------
    direction : (3,) tuple of float
        Where the eye looks.
    across, up : float
        Angles, rad: the part turns to the right, and its front up.

    Returns
    -------
    (3,) tuple of float
        Unit vector.
    """
    x, y, z = direction
    level = hypot(x, y)
    # From straight above or below the image stands upright with Y up: the eye looks along Y.
    azimuth = atan2(y, x) if level > VERTICAL * abs(z) else pi / 2
    height = min(max(atan2(z, level) + up, -_STEEPEST), _STEEPEST)
    azimuth -= across
    return cos(height) * cos(azimuth), cos(height) * sin(azimuth), sin(height)


def direction_of(quaternion: tuple[float, float, float, float]) -> tuple[float, float, float]:
    """Return where a camera looks that is turned by a quaternion (x, y, z, w): unturned it looks down."""
    x, y, z, w = quaternion
    return -2 * (x * z + w * y), -2 * (y * z - w * x), -(1 - 2 * (x * x + y * y))


def project(points: np.ndarray, frame: Frame) -> np.ndarray:
    """Return where points lie in the image.

    Parameters
    ----------
    points : (n, 3) ndarray
        mm.
    frame : Frame

    Returns
    -------
    (n, 3) ndarray
        Column and row in pixels from the image's upper left corner, and depth, mm.
    """
    from_centre = np.asarray(points, float) - frame.centre
    column, row, depth = (np.einsum("ij,j->i", from_centre, axis) for axis in (frame.right, frame.up, frame.direction))
    return np.column_stack((column / frame.pixel + frame.width / 2, frame.height / 2 - row / frame.pixel, depth))
