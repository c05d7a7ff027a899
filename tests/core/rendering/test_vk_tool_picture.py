# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool in a picture: its silhouette, and the surfaces that hide it."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from vkworkbench.core import Stock, Tool, View
from vkworkbench.core.rendering import Scene, draw_tool

STOCK = Stock((0, 0, 0), (80, 60, 10))
GREY = np.uint32(0xFF808080)


def silhouette(tool, direction, depth=np.nan):
    """Return which pixels a tool with its tip at (40, 30, 5) covers, upper row first, and the frame of the image."""
    frame = View(direction, 800, 600, 0.2).frame(STOCK)
    size = frame.height, frame.width
    owner = np.full(size, -1, np.int32)
    scene = Scene(np.full(size, depth, np.float32), np.full(size, GREY, np.uint32), lambda: owner)
    draw_tool(scene, tool, (40, 30, 5), frame)
    return scene.pixels != GREY, frame


SIZES = {"cutting_edge_height": 18.0, "shank_diameter": 6.0, "length": 30.0}


@pytest.mark.parametrize("tool, tip_area", [
    (Tool("endmill", 6, **SIZES), 0.0),
    (Tool("ballend", 6, **SIZES), 18 - pi * 9 / 2),
    (Tool("vbit", 6, tip_angle=pi / 2, **SIZES), 9.0),
    (Tool("vbit", 6, tip_angle=pi / 2, tip_diameter=2, **SIZES), 4.0),
    (Tool("bullnose", 6, 1.0, **SIZES), 2 * (1 - pi / 4)),
])  # fmt: skip
def test_side_view_of_a_tool_has_its_profile(tool, tip_area):
    covered, frame = silhouette(tool, (0, 1, 0))
    assert covered.sum() * frame.pixel**2 == pytest.approx(6 * 30 - tip_area, rel=0.01)
    row, column = np.nonzero(covered)
    # The tip is at half the height of the picture.
    assert (row.max() + 1 - frame.height / 2) * frame.pixel == pytest.approx(0, abs=0.3)
    assert (column.min() + column.max() + 1) / 2 == pytest.approx(frame.width / 2, abs=1)


def test_tool_from_above_and_below_is_round():
    for direction in ((0, 0, -1), (0, 0, 1)):
        covered, frame = silhouette(Tool("drill", 6, **SIZES), direction)
        assert covered.sum() * frame.pixel**2 == pytest.approx(pi * 9, rel=0.03)


def test_oblique_tool_has_no_holes():
    covered, _ = silhouette(Tool("ballend", 6, **SIZES), (1, 1, -1))
    for line in (*covered, *covered.T):
        assert np.count_nonzero(np.diff(line.astype(int))) <= 2


def test_holder_is_wider_than_the_shank():
    with_holder = Tool("endmill", 6, holder_diameter=20, holder_length=15, **SIZES)
    covered, frame = silhouette(with_holder, (0, 1, 0))
    assert covered.sum() * frame.pixel**2 == pytest.approx(6 * 30 + 20 * 15, rel=0.01)


def test_walls_in_front_of_the_tool_hide_the_tool():
    tool = Tool("endmill", 6, **SIZES)
    assert not silhouette(tool, (0, 1, 0), depth=-3.5)[0].any()
    assert silhouette(tool, (0, 1, 0), depth=3.5)[0].any()
