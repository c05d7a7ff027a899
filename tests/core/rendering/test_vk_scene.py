# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a simulation: colours by trajectory or by pixel, chips in front of the part, and highlights."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core import Cut, Stock, Tool, View, linearize, simulate_job
from vkworkbench.core.rendering import (
    DEEPEST,
    GOUGED,
    LEFT,
    MET,
    NO_MODEL,
    Field,
    Scene,
    difference_colors,
    palette,
    scene,
)

STOCK = Stock((0, 0, -10), (40, 20, 0))
RED, GREEN = (255, 0, 0), (0, 255, 0)


def slot():
    """Return a simulated slot along the middle of a block: trajectory 0 plunges, trajectory 1 cuts."""
    toolpath = linearize([("G0", {"X": 5.0, "Y": 10.0, "Z": 5.0}), ("G1", {"Z": -2.0}), ("G1", {"X": 35.0})])
    return simulate_job([Cut(toolpath, Tool("endmill", 6))], stock=STOCK, view=View(width=80, height=40))


def drawn(colors, direction=(0, 0, -1), chips=None, part=True, **choices):
    return scene(Field(slot(), chips, part), View(direction, 80, 40).frame(STOCK), colors, **choices)


def is_like(image, color):
    """Return the pixels with this hue, at any brightness."""
    image, color = image.astype(float), np.array(color, float)
    return (np.abs(image - image.max(axis=-1, keepdims=True) * color / color.max()) < 8).all(axis=-1)


def test_first_row_of_cell_colours_is_the_lowest_row():
    colors = np.empty((40, 80, 3), np.uint8)
    colors[:20], colors[20:] = RED, GREEN
    image = drawn(colors).image
    assert is_like(image[22:38, 4:-4], RED).all() and is_like(image[2:18, 4:-4], GREEN).all()
    assert (colors[:20] == RED).all()  # Drawing does not change the array of the caller.
    oblique = drawn(colors, (0, 1, -1)).image
    assert is_like(oblique[-3:, 20:60], RED).all() and is_like(oblique[:3, 20:60], GREEN).all()


def test_chips_in_front_of_the_part_have_their_own_colour():
    colors = np.broadcast_to(np.uint8(RED), (40, 80, 3))
    before, chips = drawn(colors), drawn(colors, chips=(0, 2))
    higher = chips.depth < before.depth - 1
    assert 0.2 < higher.mean() < 0.4
    assert not is_like(chips.image[::-1][higher], RED).any() and is_like(before.image[::-1][higher], RED).mean() > 0.9
    alone = drawn(colors, chips=(0, 2), part=False)
    assert (np.isnan(alone.depth) == ~higher).all()
    assert not is_like(alone.image[::-1][higher], RED).any()


def test_chips_shown_alone_are_as_thick_as_the_cut():
    front = drawn(palette(RED), (0, 1, 0), chips=(0, 2), part=False)
    rows = np.flatnonzero(~np.isnan(front.depth).all(axis=1))
    assert len(rows) * View((0, 1, 0), 80, 40).frame(STOCK).pixel == pytest.approx(2, abs=0.5)


def test_chips_behind_the_part_are_hidden():
    before, chips = (drawn(palette(RED), (0, 0, 1), chips=removed) for removed in (None, (0, 2)))
    assert (before.image == chips.image).all() and (before.depth == chips.depth).all()
    assert not np.isnan(drawn(palette(RED), (0, 0, 1), chips=(0, 2), part=False).depth).all()


@pytest.mark.parametrize("direction", [(0, 0, -1), (0, 1, -1)])
def test_highlighted_surfaces_have_the_highlight_colour(direction):
    for colors in (palette(RED), np.broadcast_to(np.uint8(RED), (40, 80, 3))):
        shown, before = drawn(colors, direction, lit=(1, 2)), drawn(colors, direction)
        marked = shown.owner[::-1] == 1
        differs = (shown.image != before.image).any(axis=-1)
        assert differs[marked].all() and not differs[~marked].any()
        image = shown.image.astype(int)
        # The highlight colour LIT has more green than the colour RED.
        assert (image[marked][:, 1] > 0.6 * image[marked][:, 0]).all()


def test_floor_of_a_pocket_is_in_shadow_beside_its_walls():
    image = drawn(palette(RED)).image[..., 0].astype(int)
    assert image[25, 40] < image[20, 40] == image[19, 40]


def test_deviations_are_coloured_up_to_ten_tolerances():
    left, gouged = np.array([0, 0.1, 0.11, 5.0, 0, 0, 0, 9.0]), np.array([0, 0, 0, 0, 0.11, 5.0, 0, 0])
    # The last value is leftover material in a hole, where the model has no surface.
    model = np.array([True] * 6 + [False] * 2)
    colors = difference_colors(left, gouged, model, 0.1)
    assert (colors[[0, 1]] == MET).all() and (colors[6] == NO_MODEL).all()
    assert (colors[[3, 7]] == LEFT[-1]).all() and (colors[5] == GOUGED[-1]).all()
    assert np.abs(colors[2].astype(int) - LEFT[0]).max() < 5 and np.abs(colors[4].astype(int) - GOUGED[0]).max() < 5
    assert (difference_colors(np.array([1.0, 0.9]), np.zeros(2), model[:2], 0.1)[0] == LEFT[-1]).all() and DEEPEST == 10
    middle = difference_colors(np.array([0.1 * (1 + DEEPEST) / 2]), np.zeros(1), np.array([True]), 0.1)
    assert np.abs(middle[0].astype(int) - LEFT[1]).max() < 3


def test_averaged_picture_has_mean_colours():
    depth = np.arange(24, dtype=np.float32).reshape(4, 6)
    colors = np.array([[0x10, 0x30], [0x20, 0x40]], np.uint32)
    pixels = np.tile(0xFF000000 | colors << 16 | colors, (2, 3)).astype(np.uint32)
    small = Scene(depth, pixels, lambda: depth.astype(np.int32)).averaged(2)
    assert (small.image == (0x28, 0, 0x28)).all() and small.image.shape == (2, 3, 3)
    assert (small.depth == depth).all() and (small.owner == depth).all()
