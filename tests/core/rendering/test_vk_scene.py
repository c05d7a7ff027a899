# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a simulation: colours by owner or by pixel, chips in front of the part, highlights."""

from __future__ import annotations

import numpy as np

from vkworkbench.core import Cut, Stock, Tool, View, linearize, simulate_job
from vkworkbench.core.rendering import (
    CUT,
    DEEPEST,
    GOUGED,
    LEFT,
    LIT,
    MET,
    NO_MODEL,
    difference_colors,
    palette,
    scene,
)

RED, GREEN = (255, 0, 0), (0, 255, 0)


def slot(direction=(0, 0, -1)):
    """A slot along the middle of a block, seen from above: trajectory 0 enters, 1 cuts."""
    toolpath = linearize([("G0", {"X": 5.0, "Y": 10.0, "Z": 5.0}), ("G1", {"Z": -2.0}), ("G1", {"X": 35.0})])
    stock = Stock((0, 0, -10), (40, 20, 0))
    return simulate_job([Cut(toolpath, Tool("endmill", 6))], stock=stock, view=View(direction, 80, 40))


def is_like(image, color):
    """Which pixels have this hue, whatever the light on them."""
    image, color = image.astype(float), np.array(color, float)
    return (np.abs(image - image.max(axis=-1, keepdims=True) * color / color.max()) < 8).all(axis=-1)


def test_pixels_have_the_colours_that_are_given_row_0_below():
    zbuffer = slot()
    colors = np.empty((40, 80, 3), np.uint8)
    colors[:20], colors[20:] = RED, GREEN
    image = scene(zbuffer, colors).image
    assert is_like(image[22:38, 4:-4], RED).all() and is_like(image[2:18, 4:-4], GREEN).all()
    assert (colors[:20] == RED).all()  # it is the caller's still


def test_chips_lie_before_the_part_in_their_own_colour():
    zbuffer = slot()
    colors = np.broadcast_to(np.uint8(RED), (40, 80, 3))
    before, chips = scene(zbuffer, colors), scene(zbuffer, colors, chips=(0, 2))
    higher = chips.depth < before.depth - 1
    assert 0.2 < higher.mean() < 0.4
    assert not is_like(chips.image[::-1][higher], RED).any() and is_like(before.image[::-1][higher], RED).mean() > 0.9
    alone = scene(zbuffer, colors, chips=(0, 2), part=False)
    assert (np.isnan(alone.depth) == ~higher).all()
    assert (
        alone.image[::-1][higher] == scene(zbuffer, palette(CUT), chips=(0, 2), part=False).image[::-1][higher]
    ).all()
    assert not is_like(alone.image[::-1][higher], RED).any()


def test_chips_behind_the_part_are_not_seen():
    zbuffer = slot((0, 0, 1))
    before, chips = (scene(zbuffer, palette(RED), chips=removed) for removed in (None, (0, 2)))
    assert (before.image == chips.image).all() and (before.depth == chips.depth).all()
    assert not np.isnan(scene(zbuffer, palette(RED), chips=(0, 2), part=False).depth).all()


def test_what_is_to_be_noticed_is_lit_on_either_kind_of_colours():
    zbuffer = slot()
    for colors in (palette(RED), np.broadcast_to(np.uint8(RED), (40, 80, 3))):
        shown = scene(zbuffer, colors, lit=(1, 2))
        lit = is_like(shown.image[::-1], LIT)
        assert lit[shown.owner == 1].mean() > 0.9 and not lit[shown.owner != 1].any()


def test_differences_are_coloured_up_to_ten_tolerances():
    left, gouged = np.array([0, 0.1, 0.11, 5.0, 0, 0, 0, 9.0]), np.array([0, 0, 0, 0, 0.11, 5.0, 0, 0])
    model = np.array([True] * 6 + [False] * 2)  # the last is left in a hole
    colors = difference_colors(left, gouged, model, 0.1)
    assert (colors[[0, 1]] == MET).all() and (colors[6] == NO_MODEL).all()
    assert (colors[[3, 7]] == LEFT[-1]).all() and (colors[5] == GOUGED[-1]).all()
    assert np.abs(colors[2].astype(int) - LEFT[0]).max() < 5 and np.abs(colors[4].astype(int) - GOUGED[0]).max() < 5
    assert (difference_colors(np.array([1.0, 0.9]), np.zeros(2), model[:2], 0.1)[0] == LEFT[-1]).all() and DEEPEST == 10
    middle = difference_colors(np.array([0.1 * (1 + DEEPEST) / 2]), np.zeros(1), np.array([True]), 0.1)
    assert np.abs(middle[0].astype(int) - LEFT[1]).max() < 3
