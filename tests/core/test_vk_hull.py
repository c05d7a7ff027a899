# SPDX-License-Identifier: LGPL-2.1-or-later
"""The convex hull of points in the plane."""

from vkworkbench.core.hull import convex_hull


def test_a_convex_hull_has_the_corners_alone():
    """Not what lies on a side, inside, or on a corner once more; counter-clockwise."""
    corners = [[0, 0], [4, 0], [5, 2], [1, 3]]
    others = [[2, 0], [2, 1], [4, 0], [3, 2.5], [0, 0], [4.5, 1]]
    assert convex_hull(others + corners) == corners
