# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boxes of stock, compared with values computed by hand."""

from __future__ import annotations

from dataclasses import replace
from math import hypot, sqrt

import numpy as np
import programs
import pytest

from vkworkbench.core import COORDINATE_LIMIT, Stock, Tool, View, linearize
from vkworkbench.core.solids import SMALLEST, stock_around
from vkworkbench.language import Unusable


def box():
    return Stock((1, 2, 3), (5, 10, 6))


def test_box_has_its_corners_and_limits():
    stock = box()
    assert stock.lower.tolist() == [1, 2, 3] and stock.upper.tolist() == [5, 10, 6]
    assert repr(stock) == "Stock([1.0, 2.0, 3.0], [5.0, 10.0, 6.0])"
    corners = {tuple(corner) for corner in stock.corners.tolist()}
    assert corners == {(x, y, z) for x in (1, 5) for y in (2, 10) for z in (3, 6)}
    assert Stock((-COORDINATE_LIMIT,) * 3, (COORDINATE_LIMIT,) * 3).upper[0] == COORDINATE_LIMIT
    assert Stock((0, 0, 0), (SMALLEST, 1, 1)).upper[0] == SMALLEST
    for lower, upper, code in (
        ((0, 0, 0), (1, 1, 1.001 * COORDINATE_LIMIT), "stock-not-finite"),
        ((0, -1.001 * COORDINATE_LIMIT, 0), (1, 1, 1), "stock-not-finite"),
        ((0, 0, 0), (1, np.nan, 1), "stock-not-finite"),
        ((0, 0, 0), (1, 1, SMALLEST / 2), "stock-without-volume"),
        ((0, 2, 0), (1, 1, 1), "stock-without-volume"),
    ):
        with pytest.raises(Unusable) as refused:
            Stock(lower, upper)
        assert refused.value.what.code == code


def chord(solid, origin, direction):
    direction = np.array(direction, float) / np.linalg.norm(direction)
    (near,), (far,) = solid.chords(np.array([origin], float), direction)
    return near, far


@pytest.mark.parametrize(
    "origin, direction, near, far",
    [
        ((2, 3, 16), (0, 0, -1), 10, 13),
        ((2, 3, 0), (0, 0, 1), 3, 6),
        ((2, 4, 4), (0, 1, 0), -2, 6),
        ((0, 3, 4), (1, 0, 0), 1, 5),
        ((0, 1, 4), (1, 1, 0), sqrt(2), 5 * sqrt(2)),
        ((5, 2, 0), (0, 0.6, 0.8), 3.75, 7.5),  # The ray goes along a side of the box.
        ((2, 2, 7), (1, 1, -1), sqrt(3), 3 * sqrt(3)),
    ],
)
def test_rays_enter_and_leave_a_box_at_known_depths(origin, direction, near, far):
    stock = box()
    assert chord(stock, origin, direction) == pytest.approx((near, far))


@pytest.mark.parametrize(
    "origin, direction",
    [((0, 3, 0), (0, 0, 1)), ((2, 3, 7), (1, 0, 0)), ((2, 11, 4), (1, 1, 0)), ((5.1, 3, 4), (1, 1, 1))],
)
def test_rays_beside_a_box_miss_the_box(origin, direction):
    near, far = chord(box(), origin, direction)
    assert near >= far or far <= 0


def test_rays_of_a_view_through_a_box_have_known_depths():
    """Seen from above, the image's centre is (3, 6), and depths are measured from z = 4.5. A box has no gaps."""
    frame = View(pixel=1).frame(box())
    near, far, gaps = box().spans(frame, np.array([0.0, 1.9, 2.1]), np.array([0.0, -3.9, 0.0]))
    assert near[:2].tolist() == [-1.5, -1.5] and far[:2].tolist() == [1.5, 1.5] and near[2] >= far[2]
    assert len(gaps.ray) == len(gaps.enter) == len(gaps.leave) == 0


def test_stock_around_cuts_adds_the_tools_radius():
    """Rapids do not change the stock.

    The stock extends half the tool's diameter around and below the cuts, and up to the highest cut.
    """
    path = linearize(programs.program([[(0.0, 0.0, -2.0), (30.0, 0.0, -9.0), (30.0, 20.0, -9.0)]]))
    cuts = np.flatnonzero(~path.rapid)
    top = path.points[cuts[0], 2]
    box = stock_around(path, Tool("endmill", 6))
    assert box.lower == pytest.approx([-3, -3, -12]) and box.upper == pytest.approx([33, 23, max(top, -6)])
    level = replace(path, points=path.points * (1, 1, 0))
    flat = stock_around(level, Tool("endmill", 6))
    assert flat.lower[2] == -3 and flat.upper[2] == 3  # The height of the stock is at least the tool's diameter.


def test_stock_around_cuts_is_limited_to_allowed_sizes():
    path = linearize(programs.program([[(0.0, 0.0, -2.0), (30.0, 0.0, -2.0)]]))
    for move in (4 * COORDINATE_LIMIT, -4 * COORDINATE_LIMIT):
        box = stock_around(replace(path, points=path.points + move), Tool("endmill", 6))
        assert np.abs([box.lower, box.upper]).max() <= COORDINATE_LIMIT and (box.upper - box.lower >= SMALLEST).all()
    assert hypot(*stock_around(path, Tool("endmill", 6)).lower[:2]) == pytest.approx(hypot(3, 3))


def test_toolpath_without_cuts_has_no_stock_around():
    for commands in ([], [("G0", {"X": 0}), ("G0", {"X": 5})]):
        with pytest.raises(ValueError, match="a toolpath without any"):
            stock_around(linearize(commands), Tool("endmill", 6))
