# SPDX-License-Identifier: LGPL-2.1-or-later
"""The convex hull of points in the plane."""

import numpy as np
import pytest

from vkworkbench.core.hull import convex_hull


def test_convex_hull_contains_only_corners():
    """Points on a side, inside points and duplicates are left out. The corners are in counter-clockwise order."""
    corners = [[0, 0], [4, 0], [5, 2], [1, 3]]
    others = [[2, 0], [2, 1], [4, 0], [3, 2.5], [0, 0], [4.5, 1]]
    assert convex_hull(others + corners) == corners


@pytest.mark.parametrize("seed", range(20))
def test_all_points_lie_left_of_every_side_of_the_hull(seed):
    points = np.random.default_rng(seed).integers(-5, 5, (12, 2)).tolist()
    hull = np.array(convex_hull(points))
    (x, y), (along, up) = hull.T, (np.roll(hull, -1, axis=0) - hull).T
    left = [along * (v - y) - up * (u - x) for u, v in points]
    assert (np.array(left) >= 0).all() and all(corner in points for corner in hull.tolist())
