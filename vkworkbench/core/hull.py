# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the convex hull of points in the plane, for the outline of a convex stock or a tool in an image."""

from __future__ import annotations


def convex_hull(points: list[list[float]]) -> list[list[float]]:
    """Return the corners of the convex hull of points in the plane, counter-clockwise (Andrew 1979)."""
    points = sorted(points)
    hull: list[list[float]] = []
    for chain in (points, points[::-1]):
        begin = len(hull)
        for point in chain:
            while len(hull) - begin >= 2 and _turn(hull[-2], hull[-1], point) <= 0:
                hull.pop()
            hull.append(point)
        hull.pop()
    return hull


def _turn(a: list[float], b: list[float], c: list[float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
