# SPDX-License-Identifier: LGPL-2.1-or-later
"""The direction of the view, positions of points in the image, and colours."""

from __future__ import annotations

import colorsys
import struct
import zlib
from math import pi, sqrt

import numpy as np
import pytest

from vkworkbench.core import Stock, View
from vkworkbench.core.rendering import (
    RAW,
    colors_of,
    direction_of,
    distinct_colors,
    palette,
    png,
    project,
    scale_colors,
    turned,
)  # fmt: skip

STOCK = Stock((0, 0, 0), (80, 60, 20))
ISOMETRIC = (-1, 1, -1)


def test_rotating_the_view_back_restores_it():
    there = turned(ISOMETRIC, 0.4, 0.2)
    assert turned(there, -0.4, -0.2) == pytest.approx(np.array(ISOMETRIC) / sqrt(3))
    assert turned(ISOMETRIC, pi, 0)[:2] == pytest.approx(np.array((1, -1)) / sqrt(3))


def test_part_follows_the_drag_of_the_mouse():
    """A point in front of the axis moves right when the view is dragged to the right, and up when dragged up."""
    front = np.array([[40.0, 0.0, 10.0]])
    before = project(front, View((0, 1, 0)).frame(STOCK))[0]
    right = project(front, View(turned((0, 1, 0), 0.1, 0)).frame(STOCK))[0]
    up = project(front, View(turned((0, 1, 0), 0, 0.1)).frame(STOCK))[0]
    assert right[0] > before[0] and up[1] < before[1]


def test_image_stays_upright_near_the_vertical_view():
    a, b = View((0, 0, -1)).frame(STOCK), View(turned((0, 0, -1), 0, 0)).frame(STOCK)
    assert b.right == pytest.approx(a.right, abs=2e-3) and b.up == pytest.approx(a.up, abs=2e-3)
    # The direction has the rounding error of a direction from a camera.
    assert turned(direction_of((3e-8, -4e-8, 0, 1)), 0, 0) == pytest.approx(turned((0, 0, -1), 0, 0))
    steep = turned((0, 0, -1), 0, -9.0)
    assert steep[2] > -1 and np.isfinite(View(steep).frame(STOCK).right).all()
    over = turned((0, 1, -1), 0, -9.0)  # The rotation stops before the part would be upside down.
    assert over[1:] == pytest.approx((1e-3, -1), abs=1e-5)


def test_directions_of_freecad_cameras_are_computed():
    assert direction_of((0, 0, 0, 1)) == (0, 0, -1)
    assert direction_of((sqrt(0.5), 0, 0, sqrt(0.5))) == pytest.approx((0, 1, 0), abs=1e-12)  # front view
    assert direction_of((0.424708, 0.17592, 0.339851, 0.820473)) == pytest.approx(
        np.array(ISOMETRIC) / sqrt(3), abs=1e-5
    )


def test_points_are_projected_to_their_pixels():
    frame = View(ISOMETRIC, 200, 150).frame(STOCK)
    columns, rows = np.array([0, 17, 199]), np.array([0, 149, 60])
    places = frame.origins(*frame.pixel_centres(columns, rows)) + np.array([3, 4, 5])[:, None] * frame.direction
    assert project(places, frame) == pytest.approx(np.column_stack((columns + 0.5, 149.5 - rows, [3, 4, 5])))


def test_png_contains_the_image():
    image = np.random.default_rng(1).integers(0, 256, (5, 7, 3)).astype(np.uint8)
    data = png(image)
    assert data[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">II", data[16:24]) == (7, 5)
    # The PNG header declares 8 bits for each of red, green and blue, standard filters, and no interlacing.
    assert data[12:16] == b"IHDR" and data[24:29] == bytes([8, 2, 0, 0, 0])
    start = data.index(b"IDAT")
    (length,) = struct.unpack(">I", data[start - 4 : start])
    rows = np.frombuffer(zlib.decompress(data[start + 4 : start + 4 + length]), np.uint8).reshape(5, 22)
    assert (rows[:, 0] == 0).all() and (rows[:, 1:].reshape(5, 7, 3) == image).all()


def test_operation_colours_have_equal_lightness_and_spread_hues():
    hue, lightness, saturation = np.array([colorsys.rgb_to_hls(*color / 255) for color in distinct_colors(40)]).T
    assert lightness == pytest.approx(0.6, abs=0.005) and saturation == pytest.approx(0.55, abs=0.01)
    assert np.diff(hue) % 1 == pytest.approx((sqrt(5) - 1) / 2, abs=0.01) and hue[0] == pytest.approx(0.58, abs=0.01)
    assert distinct_colors(0).shape == (0, 3)


def test_colours_of_operations_and_of_a_scale_are_assigned():
    colors = distinct_colors(12).astype(int)
    assert min(np.abs(a - b).sum() for i, a in enumerate(colors) for b in colors[:i]) > 20
    scale = scale_colors(np.array([0, 0.5, 1, 2, np.nan])).astype(int)
    assert (np.diff(scale[:3].sum(axis=1)) > 0).all() and (scale[3] == scale[2]).all() and (scale[4] == scale[0]).all()
    owners = np.array([[-1, 0], [5, 2]])
    assert (colors_of(owners, palette((1, 2, 3))) == [[RAW, (1, 2, 3)], [(1, 2, 3), (1, 2, 3)]]).all()
