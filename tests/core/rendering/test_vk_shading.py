# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shaded pictures of depth images: light, lines at steps, and background."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core.rendering import BACKGROUND, shade

GREY = (200, 200, 200)


def plane(right=0.0, up=0.0, size=(40, 60)):
    """Return the depth image of a plane with pixels of 0.5 mm.

    `right` and `up` are the slopes of the plane; with positive slopes, the plane comes nearer to the right and upwards.
    """
    row, column = np.mgrid[: size[0], : size[1]]
    return (100 - 0.5 * (right * column + up * row)).astype(np.float32)


def brightness(depth):
    image = shade(depth, 0.5, GREY)
    return float(image[5:-5, 5:-5].mean())


def test_plane_is_lit_from_above_left():
    assert np.ptp(shade(plane(0.3, -0.2), 0.5, GREY).reshape(-1, 3), axis=0).max() <= 1
    assert brightness(plane(up=-1)) > brightness(plane()) > brightness(plane(up=1))
    assert brightness(plane(right=0.5)) > brightness(plane()) > brightness(plane(right=-0.5)) - 60
    assert brightness(plane(right=1)) > brightness(plane(right=-1))


@pytest.mark.parametrize("right, up", [(0.5, -0.3), (-0.2, 0.4), (1.5, -1.5)])
def test_brightness_follows_lamberts_law(right, up):
    """The brightness is ambient light plus Lambert's law. A level plane has exactly its own colour."""
    normal = np.array((-right, -up, 1)) / np.sqrt(1 + right**2 + up**2)
    share = normal @ (-0.35, 0.5, 0.79) / 0.79
    assert brightness(plane(right, up)) == pytest.approx(min(200 * (0.38 + 0.62 * share), 255), abs=1)


def test_empty_pixels_have_the_background_colour():
    depth = plane()
    depth[:10] = np.nan  # The lowest rows of pixels are empty.
    image = shade(depth, 0.5, GREY)
    assert (image[-10:] == BACKGROUND).all()
    assert (image[:-10] == image[0, 0]).all()


def test_step_in_depth_has_a_dark_line_and_no_other_effect():
    depth = plane()
    depth[:, 30:] -= 5
    image = shade(depth, 0.5, GREY)
    line = image[20, 29:31].astype(int)
    # The smaller slope of the two sides of the step is used, so the line is the darkened colour of the flat surface.
    assert np.abs(line - 0.55 * 200).max() <= 1 and (image[20, 10] == 200).all()
    assert (np.delete(image, (29, 30), axis=1) == image[20, 10]).all()


def test_picture_of_a_finished_surface_has_no_dark_lines():
    x = np.arange(60) * 0.5
    depth = np.tile(100 + 0.05 * np.cos(2 * np.pi * x / 3), (40, 1)).astype(np.float32)
    image = shade(depth, 0.5, GREY)
    assert image.min() > 0.8 * image.max()


@pytest.mark.parametrize("turned", [False, True], ids=["across", "up"])
@pytest.mark.parametrize(
    ("change", "dark"), [(1.1, 0.0), (1.8, 0.45 / 2), (2.4, 0.45), (4.0, 0.45)], ids=["none", "half", "full", "no more"]
)
def test_sharper_edges_are_darker_up_to_a_limit(change, dark, turned):
    depth = plane(size=(60, 60))
    depth[:, 30:] -= 0.5 * change * np.arange(30, dtype=np.float32)
    image = shade(depth.T if turned else depth, 0.5, GREY)[::-1]
    # The surface is level on the left of the edge, or below the edge if the image is transposed.
    edge, level = (image[30, 20], image[10, 20]) if turned else (image[20, 30], image[20, 10])
    assert (level == 200).all() and edge == pytest.approx(200 * (1 - dark), abs=1)


def test_faces_away_from_light_have_ambient_light():
    assert brightness(plane(right=-3, up=3)) == pytest.approx(0.38 * 200, abs=1)


def test_brightness_is_limited_to_white():
    white = shade(plane(right=0.4, up=-0.6), 0.5, (255, 255, 255))
    assert (white == 255).all()


@pytest.mark.parametrize("size", [(1, 1), (1, 7), (5, 1), (2, 2)])
def test_images_of_any_size_are_shaded(size):
    image = shade(np.zeros(size, np.float32), 1.0, GREY)
    assert image.shape == (*size, 3) and (image == GREY).all()


def test_single_pixel_is_shaded_as_level():
    depth = np.full((5, 5), np.nan, np.float32)
    depth[2, 2] = 7
    assert (shade(depth, 1.0, GREY)[2, 2] == GREY).all()


def test_first_row_of_colours_is_the_lowest_row_of_the_image():
    colors = np.zeros((40, 60, 3), np.uint8)
    colors[0] = 255, 0, 0
    image = shade(plane(), 0.5, colors)
    assert image[-1, 5, 0] > 150 and (image[-1, 5, 1:] == 0).all() and (image[0] == 0).all()
