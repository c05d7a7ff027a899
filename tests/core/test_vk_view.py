# SPDX-License-Identifier: LGPL-2.1-or-later
"""Views of a box, compared with values computed by hand."""

from __future__ import annotations

from math import inf, sqrt

import numpy as np
import pytest

from vkworkbench.core import Stock, View

BOX = Stock((1, 2, 3), (5, 10, 6))


@pytest.mark.parametrize(
    "direction, right, up",
    [
        ((0, 0, -5), (1, 0, 0), (0, 1, 0)),
        ((0, 0, 2), (1, 0, 0), (0, -1, 0)),
        ((1e-12, 0, -1), (1, 0, 0), (0, 1, 0)),
        ((0, -8.7e-8, 1), (1, 0, 0), (0, -1, 0)),
        ((0, 1, 0), (1, 0, 0), (0, 0, 1)),
        ((-1, 0, 0), (0, 1, 0), (0, 0, 1)),
        ((0, 3, -4), (1, 0, 0), (0, 0.8, 0.6)),
        ((3, 0, 4), (0, -1, 0), (-0.8, 0, 0.6)),
    ],
)
def test_axes_of_an_image_follow_the_direction(direction, right, up):
    frame = View(direction, pixel=0.5).frame(BOX)
    assert frame.right == pytest.approx(right, abs=1e-9) and frame.up == pytest.approx(up, abs=1e-9)
    along = np.array(direction) / np.linalg.norm(direction)
    assert frame.direction == pytest.approx(along, abs=1e-7) and frame.centre.tolist() == [3, 6, 4.5]
    assert (frame.pixel, frame.width, frame.height) == (0.5, 800, 600)


def test_smallest_pixel_fits_the_stock_in_the_image():
    """A stock of 4 x 8 x 3 mm is seen from above, from the front, and from 45 degrees above."""
    for direction, width, height, pixel in (
        ((0, 0, -1), 40, 40, 0.2), ((0, 0, -1), 10, 40, 0.4), ((0, 1, 0), 8, 100, 0.5), ((0, 1, 0), 100, 5, 0.6),
        ((0, 1, -1), 100, 10, 1.1 / sqrt(2)),
    ):  # fmt: skip
        assert View(direction, width, height).frame(BOX).pixel == pytest.approx(pixel)


def test_rays_of_an_image_start_at_pixel_centres():
    frame = View((0, 1, 0), 4, 2, pixel=0.5, offset=(10, 20)).frame(BOX)
    assert frame.centre.tolist() == [13, 6, 24.5]
    x, y = frame.pixel_centres([0, 3], [0, 1])
    assert x.tolist() == [-0.75, 0.75] and y.tolist() == [-0.25, 0.25]
    assert frame.origins(x, y).tolist() == [[12.25, 6, 24.25], [13.75, 6, 24.75]]


def test_impossible_views_raise_an_error():
    for direction in ((0, 0, 0), (0, 0, np.nan), (0, 1), (np.inf, 0, 0)):
        with pytest.raises(ValueError, match="direction must be three finite numbers"):
            View(direction)
    for width, height in ((0, 5), (5, 0)):
        with pytest.raises(ValueError, match=r"(width|height) must be a whole number of pixels, at least 1, not 0"):
            View(width=width, height=height)
    for pixel in (0, -1, inf, np.nan):
        with pytest.raises(ValueError, match="pixel must be a positive number of mm"):
            View(pixel=pixel)
    assert View(width=1, height=1).direction == (0, 0, -1)


def test_size_of_an_image_must_be_whole_pixels():
    assert View(width=np.int64(8)).width == 8
    for size in (160 / 0.5, "8", None):
        with pytest.raises(TypeError, match="height must be a whole number of pixels"):
            View(height=size)


@pytest.mark.parametrize(
    ("name", "given"),
    [
        ("width", {"width": 10**9}),
        ("height", {"width": 1, "height": 10**9}),
        ("width", {"width": 10**300}),
        (r"width \* height", {"width": 100_000, "height": 100_000}),
        ("pixel", {"pixel": 5e-324}),
        ("pixel", {"pixel": 1e308}),
        ("offset", {"offset": (0, -1e308)}),
    ],
)
def test_view_of_impossible_size_is_refused(name, given):
    with pytest.raises(ValueError, match=f"^{name} must be .*, not "):
        View(**given)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("given", [{}, {"pixel": 1e-12}, {"pixel": 1e10}, {"offset": (1e10, -1e10)}])
@pytest.mark.parametrize("length", [5e-324, 1e-300, 1.0, 1e308])
def test_direction_of_any_length_has_finite_axes(length, given):
    frame = View((length, 0.0, -length), 65_536, 65_536, **given).frame(BOX)
    assert frame.direction == pytest.approx([sqrt(0.5), 0.0, -sqrt(0.5)], rel=1e-15)
    assert np.isfinite([frame.centre, frame.right, frame.up]).all() and 0 < frame.pixel <= 1e10
