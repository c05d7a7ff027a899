# SPDX-License-Identifier: LGPL-2.1-or-later
"""The working plane of a toolpath: XY, or a vertical plane that contains all cuts."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core.paper.plane import XY, YZ, ZX, plane_of_points, plane_of_toolpath


def waves(count, along=0):
    """Return cuts up and down along X (0) or Y (1), 7 mm away from this axis."""
    points = np.full((count + 1, 3), 7.0)
    points[:, along] = 3.0 * np.arange(count + 1)
    points[:, 2] = 2.0 * (np.arange(count + 1) % 2) - 4
    return points


def plane(points, rapid=()):
    fast = np.zeros(len(points) - 1, bool)
    fast[list(rapid)] = True
    return plane_of_toolpath(np.asarray(points, float), fast)


@pytest.mark.parametrize("count", [1, 2, 49, 50, 51, 200])
@pytest.mark.parametrize(("along", "found"), [(0, ZX), (1, YZ)])
def test_slopes_in_a_vertical_plane_have_this_plane(along, found, count):
    assert plane(waves(count, along)) == found


def test_slot_with_plunges_lies_in_horizontal_plane():
    assert plane([(0, 7, 0), (0, 7, -1), (40, 7, -1), (40, 7, -2), (0, 7, -2)]) == XY
    # Moves that are horizontal or vertical except for rounding do not change the plane.
    assert plane([(0, 7, 0), (0.001, 7, -1), (40, 7, -1.001), (40, 7, -2), (0, 7, -2)]) == XY


def test_one_slope_defines_a_vertical_plane():
    assert plane([(0, 7, 0), (40, 7, 0), (50, 7, -5), (90, 7, -5)]) == ZX


def test_rapids_do_not_affect_the_plane():
    points = np.vstack([[(0, 50, 30), (0, 7, 30)], waves(200), [(600, 7, 30), (600, 50, 30)]])
    assert plane(points, rapid=(0, 1, 202, 203)) == ZX
    assert plane(waves(30), rapid=range(30)) == XY


@pytest.mark.parametrize("place", [0, 1, 99, 100, 200])
def test_point_outside_a_vertical_plane_makes_the_plane_xy(place):
    """For a long path, a sample of the moves is tested first.

    A point outside the plane, between the samples or at an end, is also found.
    """
    points = waves(200)
    points[place, 1] += 1
    assert plane(points) == XY


def test_polyline_in_a_vertical_plane_has_this_plane():
    wave = waves(5)
    assert (plane_of_points(wave), plane_of_points(waves(5, 1))) == (ZX, YZ)
    assert plane_of_points(wave[:, :2]) == plane_of_points(wave[:0]) == XY
    level = wave * (1, 1, 0)
    assert plane_of_points(level) == XY and plane_of_points(wave * (0, 0, 1)) == XY
    assert plane_of_points(wave + np.arange(6)[:, None] * (0, 1, 0)) == XY


def test_polyline_with_a_slight_fall_is_in_the_xy_plane():
    assert plane([(0, 7, 0), (100, 7, -1), (0, 7, -2)]) == XY == plane([(7, 0, 0), (7, 100, -1), (7, 0, -2)])
    assert plane([(0, 7, 0), (1, 7, -100), (2, 7, 0)]) == XY


@pytest.mark.parametrize(("fall", "found"), [(4, XY), (7, ZX)])
def test_fall_by_more_than_a_twentieth_is_a_slope(fall, found):
    assert plane([(0, 7, 0), (100, 7, -fall)]) == found
    assert plane([(0, 7, 0), (fall, 7, -100)]) == found
