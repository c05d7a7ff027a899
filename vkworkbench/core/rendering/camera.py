# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the direction of a view after turning, and the positions of points in its image."""

from __future__ import annotations

from math import atan2, cos, hypot, pi, sin

import numpy as np

from vkworkbench.core.view import VERTICAL, Frame

# Steepest elevation of the view that turning can reach, rad. In a vertical view, the Z axis of the part does not point
# up in the image, so turning could not continue from there.
_STEEPEST = pi / 2 - 1e-3


def turned(direction: tuple[float, float, float], across: float, up: float) -> tuple[float, float, float]:
    """Return the direction of the view after turning the part, as on a turntable.

    Parameters
    ----------
    direction : (3,) tuple of float
        Direction in which the viewer looks.
    across, up : float
        Angle by which the part turns to the right, and angle by which the front of the part turns upwards, rad.

    Returns
    -------
    (3,) tuple of float
        The new direction, as a unit vector.
    """
    x, y, z = direction
    level = hypot(x, y)
    # In a vertical view, the Y axis points up in the image.
    azimuth = atan2(y, x) if level > VERTICAL * abs(z) else pi / 2
    height = min(max(atan2(z, level) + up, -_STEEPEST), _STEEPEST)
    azimuth -= across
    return cos(height) * cos(azimuth), cos(height) * sin(azimuth), sin(height)


def direction_of(quaternion: tuple[float, float, float, float]) -> tuple[float, float, float]:
    """Return a camera's view direction from its rotation quaternion (x, y, z, w).

    An unrotated camera looks along -Z.
    """
    x, y, z, w = quaternion
    return -2 * (x * z + w * y), -2 * (y * z - w * x), -(1 - 2 * (x * x + y * y))


def project(points: np.ndarray, frame: Frame) -> np.ndarray:
    """Return the positions of points in the image.

    Parameters
    ----------
    points : (n, 3) ndarray
        Coordinates of the points, mm.
    frame : Frame

    Returns
    -------
    (n, 3) ndarray
        For each point, column and row in pixels from the image's upper left corner, and depth, mm.
    """
    from_centre = np.asarray(points, float) - frame.centre
    column, row, depth = (np.einsum("ij,j->i", from_centre, axis) for axis in (frame.right, frame.up, frame.direction))
    return np.column_stack((column / frame.pixel + frame.width / 2, frame.height / 2 - row / frame.pixel, depth))
