# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a part deviates from its model: what hangs together, what made it, and what a pixel is compared with."""

from __future__ import annotations

import numpy as np
import pytest
from zbuffer_reference.paths import BOX, toolpath

from vkworkbench.core import Cut, Stock, Tool, View
from vkworkbench.core.zbuffer import SeenModel, deviations, gouges, material_left, simulate_job, worst_places
from vkworkbench.core.zbuffer.deviations import _around

FLAT = Tool("endmill", 6)
WIDTH, HEIGHT, PIXEL = 200, 150, 0.2
VIEW = View((0, 0, -1), WIDTH, HEIGHT)  # of the block, 40 by 30 by 10 mm


def path(*points):
    return toolpath(np.array(points, float))


def simulated(*paths):
    return simulate_job([Cut(one, FLAT) for one in paths], stock=BOX, view=VIEW)


UNCUT = simulated()


def amounts(**patches):
    """An image of nothing but rectangles of pixels: (first column, first row, columns, rows, mm)."""
    image = np.zeros((HEIGHT, WIDTH), np.float32)
    for column, row, columns, rows, amount in patches.values():
        image[row : row + rows, column : column + columns] = amount
    return image.ravel()


def middle(column, row):
    """The middle of a pixel, mm."""
    return pytest.approx((PIXEL * (column + 0.5), PIXEL * (row + 0.5)))


def test_an_extreme_is_that_of_a_pixel_and_its_eight_neighbours():
    values = np.arange(20.0).reshape(4, 5)
    assert _around(values, np.maximum).tolist() == [
        [6, 7, 8, 9, 9], [11, 12, 13, 14, 14], [16, 17, 18, 19, 19], [16, 17, 18, 19, 19]]  # fmt: skip
    assert _around(values, np.minimum).tolist() == [
        [0, 0, 1, 2, 3], [0, 0, 1, 2, 3], [5, 5, 6, 7, 8], [10, 10, 11, 12, 13]]  # fmt: skip


def test_the_worst_pixel_of_what_hangs_together_is_its_place():
    """Two rectangles, of which the second is deeper, with a deepest pixel in it."""
    image = amounts(one=(20, 30, 10, 4, 1.0), two=(150, 90, 6, 6, 2.0), deepest=(153, 94, 1, 1, 2.5))
    two, one = worst_places(UNCUT, image, 0.5)
    assert (one.depth, two.depth) == (1.0, 2.5)
    assert two.place[:2] == middle(153, 94) and one.place[:2] == middle(20, 30) and one.place[2] == pytest.approx(10)
    assert (one.area, two.area) == pytest.approx((40 * PIXEL**2, 36 * PIXEL**2))
    assert one.trajectory is None and one.source is None


@pytest.mark.parametrize(
    "other, places",
    [
        ((36, 30, 3, 3), 2),
        ((33, 30, 3, 3), 1),
        ((33, 33, 3, 3), 1),
        ((27, 27, 3, 3), 1),
        ((27, 33, 3, 3), 1),
        ((24, 30, 3, 3), 2),
        ((30, 36, 3, 3), 2),
        ((30, 24, 3, 3), 2),
    ],
)
def test_tiles_of_three_pixels_hang_together_where_they_touch(other, places):
    """A fiftieth of 150 pixels is the side of a tile; the first lies at 30, 30."""
    found = worst_places(UNCUT, amounts(one=(30, 30, 3, 3, 1.0), other=(*other, 1.0)), 0.5)
    assert len(found) == places
    assert sum(place.area for place in found) == pytest.approx(18 * PIXEL**2)


def test_a_long_winding_line_is_one_place():
    line = {f"step {k}": (12 + 3 * k, 12 + 3 * (k % 2), 3, 3, 1.0 + k / 100) for k in range(40)}
    (one,) = worst_places(UNCUT, amounts(**line), 0.5)
    assert one.depth == pytest.approx(1.39) and one.area == pytest.approx(360 * PIXEL**2)


def test_places_at_the_edges_of_the_image():
    corners = {name: (x, y, 1, 1, depth) for name, x, y, depth in
               (("a", 0, 0, 4.0), ("b", 199, 0, 3.0), ("c", 0, 149, 2.0), ("d", 199, 149, 1.0))}  # fmt: skip
    found = worst_places(UNCUT, amounts(**corners), 0.5)
    assert [place.depth for place in found] == [4, 3, 2, 1]
    assert [place.place[:2] for place in found] == [middle(0, 0), middle(199, 0), middle(0, 149), middle(199, 149)]
    assert len(worst_places(UNCUT, amounts(**corners), 0.5, most=3)) == 3
    assert len(worst_places(UNCUT, amounts(**corners), 2.0)) == 2  # what is no more than the tolerance is none


def test_ten_places_are_told():
    patches = {str(k): (15 * k, 60, 3, 3, 1.0 + k) for k in range(12)}
    assert [place.depth for place in worst_places(UNCUT, amounts(**patches), 0.5)] == [12.0 - k for k in range(10)]


def test_what_is_left_above_a_model_is_told_by_pixel():
    """A model of 8 mm under all of the block of 10 mm; depths count from the middle of the block."""
    seen = SeenModel(Stock((0, 0, 0), (40, 30, 8)), UNCUT.frame)
    assert seen.near.shape == seen.far.shape == (HEIGHT, WIDTH)
    assert seen.near == pytest.approx(np.full((HEIGHT, WIDTH), -3.0)) and seen.far == pytest.approx(5.0 + 0 * seen.far)
    found = seen.against(UNCUT)
    assert found.depth == pytest.approx(np.full(WIDTH * HEIGHT, 2.0)) and found.left == pytest.approx(found.depth)
    assert not found.gouged.any()


def test_beside_a_model_there_is_nothing_to_compare():
    """It covers the left half: its last column has neighbours without it, and can be no gouge."""
    deep = simulated(path((-10, 15, 6), (50, 15, 6)))
    found = deviations(deep, Stock((0, 0, 0), (20, 30, 8)))
    depth, gouged, left = (values.reshape(HEIGHT, WIDTH) for values in (found.depth, found.gouged, found.left))
    assert np.isnan(depth[:, 100:]).all() and not np.isnan(depth[:, :100]).any()
    assert depth[75, :100] == pytest.approx(np.full(100, -2.0)) and depth[20, :100] == pytest.approx(np.full(100, 2.0))
    assert gouged[75, :99] == pytest.approx(np.full(99, 2.0)) and not gouged[75, 99:].any()
    assert left[20, :100] == pytest.approx(np.full(100, 2.0)) and not left[:, 100:].any() and not gouged[20].any()


def test_every_strip_of_64_rows_of_a_model_may_end_the_work():
    strips = []
    SeenModel(BOX, UNCUT.frame, lambda: strips.append(1))
    assert len(strips) == 3


def test_each_cut_has_one_worst_gouge_and_all_of_its_area():
    """A slot of 3 mm and one of 4 mm by the first cut, one of 5 mm by the second, 30 mm long and 6 mm wide."""
    one = path((5, 5, 7), (35, 5, 7), (35, 5, 20), (5, 25, 20), (5, 25, 6), (35, 25, 6))
    two = path((5, 15, 5), (35, 15, 5))
    z = simulated(one, two)
    found = gouges(z, deviations(z, BOX), 0.1)
    assert [gouge.depth for gouge in found] == pytest.approx([5, 4]) and [gouge.source.cut for gouge in found] == [1, 0]
    assert [gouge.trajectory for gouge in found] == [len(one), 3]  # the plunge into the deeper slot comes first
    assert [gouge.area for gouge in found] == pytest.approx([180 + 9 * np.pi, 2 * (180 + 9 * np.pi)], rel=0.05)
    assert material_left(z, deviations(z, BOX), 0.1) == []


def test_the_stocks_own_surface_was_made_by_no_cut():
    """A slot 1 mm deep in a block that ought to be 2 mm lower: 1 mm is left by the cut, and 2 mm by nobody."""
    z = simulated(path((5, 15, 9), (35, 15, 9)))
    whole, own = material_left(z, deviations(z, Stock((0, 0, 0), (40, 30, 8))), 0.1)
    assert (whole.depth, own.depth) == pytest.approx((2, 1))
    assert whole.trajectory is None and whole.source is None and (own.trajectory, own.source.cut) == (0, 0)
    assert whole.area + own.area == pytest.approx(40 * 30) and own.place[2] == pytest.approx(9)


@pytest.mark.parametrize("x, y", [(20, 15), (40, 30), (0, 0)], ids=["inside", "last pixel", "first pixel"])
def test_where_nothing_is_left_the_last_that_removed_something_made_it(x, y):
    """A pocket of 6 mm, then through all of it, and once more without anything to remove."""
    z = simulated(path((x, y, 12), (x, y, 4)), path((x, y, 12), (x, y, -1), (x, y, 12), (x, y, -2)))
    (gouge,) = gouges(z, deviations(z, BOX), 0.1)
    assert gouge.depth == pytest.approx(10) and gouge.trajectory == 1 and gouge.source.cut == 1
