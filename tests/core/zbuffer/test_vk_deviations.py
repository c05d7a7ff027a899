# SPDX-License-Identifier: LGPL-2.1-or-later
"""Deviations of a part from its model: connected groups, responsible trajectories, and the model in each pixel."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from zbuffer_inputs import BOX, toolpath

from vkworkbench.core import Cut, Cylinder, Stock, Tool, View
from vkworkbench.core.solids import Convex, Gaps, Spans
from vkworkbench.core.zbuffer import (
    Deviations,
    SeenModel,
    deviations,
    gouges,
    material_left,
    simulate_job,
    worst_places,
)
from vkworkbench.core.zbuffer.findings.seen_model import _connected_to_edge, around

FLAT = Tool("endmill", 6)
WIDTH, HEIGHT, PIXEL = 200, 150, 0.2
VIEW = View((0, 0, -1), WIDTH, HEIGHT)  # The image shows the block of 40 x 30 x 10 mm.


def path(*points):
    return toolpath(np.array(points, float))


def simulated(*paths):
    return simulate_job([Cut(one, FLAT) for one in paths], stock=BOX, view=VIEW)


UNCUT = simulated()


def left(most=None, tolerance=0.5, **patches):
    """Return the places with the most leftover material.

    A patch of leftover is (first column, first row, number of columns, number of rows, mm).
    """
    image = np.zeros((HEIGHT, WIDTH), np.float32)
    for column, row, columns, rows, amount in patches.values():
        image[row : row + rows, column : column + columns] = amount
    part, nothing = UNCUT.picture.depth.reshape(image.shape), np.zeros(image.size, np.float32)
    model = SimpleNamespace(near=part, behind=part, surface=part + image, floor=part + image)
    found = Deviations(image.ravel(), nothing, part, model)
    gouged, places = worst_places(UNCUT, found, tolerance, *([] if most is None else [most]))
    assert gouged == []
    return places


def middle(column, row):
    """Return the X and Y of the middle of a pixel, mm."""
    return pytest.approx((PIXEL * (column + 0.5), PIXEL * (row + 0.5)))


def test_maximum_around_a_pixel_includes_its_eight_neighbours():
    values = np.arange(20.0).reshape(4, 5)
    assert around(values, np.maximum).tolist() == [
        [6, 7, 8, 9, 9], [11, 12, 13, 14, 14], [16, 17, 18, 19, 19], [16, 17, 18, 19, 19]]  # fmt: skip
    assert around(values, np.minimum).tolist() == [
        [0, 0, 1, 2, 3], [0, 0, 1, 2, 3], [5, 5, 6, 7, 8], [10, 10, 11, 12, 13]]  # fmt: skip


def test_place_of_leftover_is_the_deepest_connected_pixel():
    """Two rectangles of leftover material; the second rectangle is deeper, and contains the deepest pixel."""
    two, one = left(one=(20, 30, 10, 4, 1.0), two=(150, 90, 6, 6, 2.0), deepest=(153, 94, 1, 1, 2.5))
    assert (one.depth, two.depth) == (1.0, 2.5)
    assert two.place[:2] == middle(153, 94) and one.place[:2] == middle(20, 30) and one.place[2] == pytest.approx(10)
    assert (one.area, two.area) == pytest.approx((40 * PIXEL**2, 36 * PIXEL**2))
    assert one.trajectory is None and one.source is None


@pytest.mark.parametrize(
    "other, places",
    [
        ((36, 30, 3, 3), 2),
        ((33, 30, 3, 3), 1),
        ((35, 30, 3, 3), 1),
        ((33, 33, 3, 3), 1),
        ((27, 27, 3, 3), 1),
        ((27, 33, 3, 3), 1),
        ((24, 30, 3, 3), 2),
        ((30, 36, 3, 3), 2),
        ((30, 24, 3, 3), 2),
    ],
)
def test_touching_squares_of_leftover_are_one_place(other, places):
    """A square has a side of 3 pixels, which is a fiftieth of the image height of 150 pixels.

    The first square lies at column 30, row 30.
    """
    for depth in (0.9, 1.1):  # The deeper rectangle is processed first.
        found = left(one=(30, 30, 3, 3, 1.0), other=(*other, depth))
        assert len(found) == places
        assert sum(place.area for place in found) == pytest.approx(18 * PIXEL**2)


@pytest.mark.parametrize(("tolerance", "depths"), [(0.5, []), (0.1, [PIXEL])])
def test_displaced_wall_deviates_by_its_displacement(tolerance, depths):
    """A wall 3 mm high is displaced by one pixel. Along the view, this pixel lies 3 mm above the model."""
    part, model = (
        UNCUT.picture.depth.reshape(HEIGHT, WIDTH) + np.float32(3) * (np.arange(WIDTH) >= edge) for edge in (101, 100)
    )
    seen = SimpleNamespace(near=model, behind=model, surface=model, floor=model)
    found = Deviations((model - part).ravel(), np.zeros(part.size, np.float32), part, seen)
    told = [material_left(UNCUT, found, tolerance), worst_places(UNCUT, found, tolerance)[1]]
    assert [[one.depth for one in places] for places in told] == [pytest.approx(depths)] * 2


def test_long_winding_line_of_leftover_is_one_place():
    line = {f"step {k}": (12 + 3 * k, 12 + 3 * (k % 2), 3, 3, 1.0 + k / 100) for k in range(40)}
    (one,) = left(**line)
    assert one.depth == pytest.approx(1.39) and one.area == pytest.approx(360 * PIXEL**2)


def test_leftover_at_image_edges_is_found():
    corners = {name: (x, y, 1, 1, depth) for name, x, y, depth in
               (("a", 0, 0, 4.0), ("b", 199, 0, 3.0), ("c", 0, 149, 2.0), ("d", 199, 149, 1.0))}  # fmt: skip
    found = left(**corners)
    assert [place.depth for place in found] == [4, 3, 2, 1]
    assert [place.place[:2] for place in found] == [middle(0, 0), middle(199, 0), middle(0, 149), middle(199, 149)]
    assert len(left(most=3, **corners)) == 3
    assert len(left(tolerance=2.0, **corners)) == 2  # Leftover of at most the tolerance is ignored.


def test_leftover_at_the_image_corner_joins_its_neighbours():
    for other in ((3, 0, 3, 3), (0, 3, 3, 3), (3, 3, 3, 3)):
        for depth in (0.9, 1.1):
            assert len(left(one=(0, 0, 3, 3, 1.0), other=(*other, depth))) == 1


def test_slightly_shifted_wall_does_not_hide_deeper_gouge():
    """Along the view, the shifted wall deviates most, by 9 mm.

    If the deviation is measured in space, four places deviate more than the wall, so the wall is not in the first three
    places.
    """
    depth = UNCUT.picture.depth.reshape(HEIGHT, WIDTH)
    part, model = (depth + np.float32(9) * (np.arange(WIDTH) >= edge) for edge in (101, 100))
    for column, deep in ((10, 5.0), (30, 4.5), (50, 4.0), (70, 3.5)):
        model[60:70, column : column + 10] += np.float32(deep)
    seen = SimpleNamespace(near=model, behind=model, surface=model, floor=model)
    found = Deviations((model - part).ravel(), np.zeros(part.size, np.float32), part, seen)
    told = [[one.depth for one in worst_places(UNCUT, found, 0.1, most)[1]] for most in (2, 3, 4, 5)]
    assert told == [pytest.approx([5, 4.5, 4, 3.5, PIXEL][:most]) for most in (2, 3, 4, 5)]


def test_ten_deepest_leftover_places_are_reported():
    patches = {str(k): (15 * k, 60, 3, 3, 1.0 + k) for k in range(12)}
    assert [place.depth for place in left(**patches)] == [12.0 - k for k in range(10)]


def test_leftover_above_model_is_measured_by_pixel():
    """A model 8 mm high lies under the whole block of 10 mm. Depths are measured from the middle of the block."""
    seen = SeenModel(Stock((0, 0, 0), (40, 30, 8)), UNCUT.frame)
    assert seen.near.shape == seen.far.shape == (HEIGHT, WIDTH)
    assert seen.near == pytest.approx(np.full((HEIGHT, WIDTH), -3.0)) and seen.far == pytest.approx(5.0 + 0 * seen.far)
    found = seen.against(UNCUT)
    assert found.left == pytest.approx(np.full(WIDTH * HEIGHT, 2.0)) and not found.gouged.any()


def test_pixels_beside_the_model_have_no_deviations():
    """The model covers the left half of the image.

    Pixels next to the last column of the model miss the model, so the last column is not a gouge.
    """
    deep = simulated(path((-10, 15, 6), (50, 15, 6)))
    found = deviations(deep, Stock((0, 0, 0), (20, 30, 8)))
    gouged, left = (values.reshape(HEIGHT, WIDTH) for values in (found.gouged, found.left))
    assert gouged[75, :99] == pytest.approx(np.full(99, 2.0)) and not gouged[75, 99:].any()
    assert left[20, :100] == pytest.approx(np.full(100, 2.0)) and not left[:, 100:].any() and not gouged[20].any()


def test_model_calls_the_callback_after_every_64_pixel_rows():
    strips = []
    SeenModel(BOX, UNCUT.frame, lambda: strips.append(1))
    assert len(strips) == 3


def test_every_gouge_has_its_first_and_last_command():
    """The first cut makes slots 3 and 4 mm deep, and the second cut a slot 5 mm deep.

    All slots are 30 mm long and 6 mm wide.
    """
    one = path((5, 5, 7), (20, 5, 7), (35, 5, 7), (35, 5, 20), (5, 25, 20), (5, 25, 6), (35, 25, 6))
    two = path((5, 15, 5), (35, 15, 5))
    z = simulated(one, two)
    found = gouges(z, deviations(z, BOX), 0.1)
    assert [gouge.depth for gouge in found] == pytest.approx([5, 4, 3])
    commands = [(gouge.source.cut, gouge.source.command, gouge.last.command) for gouge in found]
    assert commands == [(1, 0, 0), (0, 4, 5), (0, 0, 1)] and [gouge.trajectory for gouge in found] == [6, 4, 0]
    assert [gouge.area for gouge in found] == pytest.approx([180 + 9 * np.pi] * 3, rel=0.05)
    assert material_left(z, deviations(z, BOX), 0.1) == []


def test_forty_holes_are_forty_gouges():
    places = [(4.5 * column + 2, 4.5 * row + 2) for row in range(5) for column in range(8)]
    z = simulate_job(
        [Cut(path(*((x, y, z) for x, y in places for z in (12, 9, 12))), Tool("endmill", 2))], stock=BOX, view=VIEW
    )
    found = gouges(z, deviations(z, BOX), 0.1)
    assert sorted(gouge.source.command for gouge in found) == [3 * k for k in range(40)]


def test_allowed_depth_of_a_cut_is_not_a_gouge():
    """The first engraved line is 0.3 mm deep, the second 0.8 mm.

    The allowed depth is infinite for a tool that replaces an unsupported shape, so this tool has no gouges.
    """
    lines = path((5, 5, 12), (5, 5, 9.7), (35, 5, 9.7), (35, 5, 12), (5, 25, 12), (5, 25, 9.2), (35, 25, 9.2))

    def depths(allowed):
        z = simulate_job([Cut(lines, FLAT, 0.0, allowed)], stock=BOX, view=VIEW)
        return [round(gouge.depth, 3) for gouge in gouges(z, deviations(z, BOX), 0.1)]

    assert depths(0.0) == [0.8, 0.3] and depths(0.3) == [0.8] and depths(0.8) == depths(np.inf) == []


def test_leftover_on_uncut_stock_has_no_trajectory():
    """The model is 2 mm below the stock's top. A slot 1 mm deep leaves 1 mm, and 2 mm are left around the slot."""
    z = simulated(path((5, 15, 9), (35, 15, 9)))
    whole, own = material_left(z, deviations(z, Stock((0, 0, 0), (40, 30, 8))), 0.1)
    assert (whole.depth, own.depth) == pytest.approx((2, 1))
    assert whole.trajectory is None and whole.source is None and (own.trajectory, own.source.cut) == (0, 0)
    assert whole.area + own.area == pytest.approx(40 * 30) and own.place[2] == pytest.approx(9)


@pytest.mark.parametrize("x, y", [(20, 15), (40, 30), (0, 0)], ids=["inside", "last pixel", "first pixel"])
def test_gouge_through_part_is_attributed_to_first_remover(x, y):
    """The first cut is 6 mm deep. The second cut goes through the part, and its second plunge removes nothing."""
    z = simulated(path((x, y, 12), (x, y, 4)), path((x, y, 12), (x, y, -1), (x, y, 12), (x, y, -2)))
    (gouge,) = gouges(z, deviations(z, BOX), 0.1)
    assert gouge.depth == pytest.approx(10) and gouge.trajectory == 0 and gouge.source.cut == 0
    # The pocket does not reach a model that begins 7 mm below the top.
    (gouge,) = gouges(z, deviations(z, Stock((0, 0, 0), (40, 30, 3))), 0.1)
    assert gouge.depth == pytest.approx(3) and gouge.trajectory == 1 and gouge.source.cut == 1


class Milled(Convex):
    """A block minus boxes and cylinders, with exact rays.

    Simulate a milled solid in one process, because worker processes lack this class.
    """

    def __init__(self, block, *removed):
        self.block, self.removed = block, removed
        self.lower, self.upper = block.lower, block.upper

    def spans(self, frame, x, y):
        near, far, gaps = self.block.spans(frame, x, y)
        for _ in self.removed:  # subtract all solids repeatedly, because rays meet them in different orders
            for solid in self.removed:
                begin, end, _ = solid.spans(frame, x, y)
                near = np.where((begin <= near + 1e-9) & (end > near), end, near)
        return Spans(near, far, gaps)


# The faced block has a pocket of 12 x 20 x 5 mm, a blind hole, and a through hole.
PART = Milled(
    Stock((0, 0, 0), (40, 30, 8)),
    Stock((5, 5, 3), (17, 25, 20)),
    Cylinder((30, 21, 2), 3, 20),
    Cylinder((24, 8, -5), 3, 30),
)
FACING = path(*((x, y, 8) for k, y in enumerate(range(0, 31, 5)) for x in ((-5, 45) if k % 2 == 0 else (45, -5))))
POCKET = path(
    (8, 8, 12), *((x, y, 3) for k, x in enumerate((8, 10, 12, 14)) for y in ((8, 22) if k % 2 == 0 else (22, 8)))
)
DRILLING = path((30, 21, 12), (30, 21, 2), (30, 21, 12), (24, 8, 12), (24, 8, -5))
# A rapid over the pocket and both holes, 3 mm deep.
CRASH = path((-5, 15, 12), (-5, 15, 5), (12, 15, 5), (24.5, 9, 5), (29.3, 20, 5), (45, 22, 5))
VIEWS = [(0, 0, -1), (1, 1, -1), (0, 1, -1), (-1, 0.5, -1), (0.3, -1, -0.4)]


ROUGH = Stock((-1, -1, 0), (41, 31, 10))
# Image centre and pixel size, mm. The images show the whole part, the edge of the pocket, and the edges of both holes.
IMAGES = [((0, 0), 0.4), ((-3, 0), 0.04), ((4, -5), 0.08), ((10, 4), 0.08)]


@pytest.mark.long
@pytest.mark.parametrize("direction", VIEWS)
@pytest.mark.parametrize("offset, pixel", IMAGES)
def test_correct_part_has_no_gouges(direction, offset, pixel):
    cuts = [Cut(one, FLAT) for one in (FACING, POCKET, DRILLING)]
    z = simulate_job(cuts, stock=ROUGH, view=View(direction, 150, 120, pixel, offset))
    assert gouges(z, deviations(z, PART), 0.1) == []


@pytest.mark.long
@pytest.mark.parametrize("direction", VIEWS)
@pytest.mark.parametrize("offset, pixel", IMAGES)
def test_only_cuts_into_the_model_are_gouges(direction, offset, pixel):
    """The rapid exposes walls that other operations cut correctly. Exposed walls are not gouges."""
    # The operation with the rapid is the first or the last, alternating over the images and the views.
    guilty = 3 * ((VIEWS.index(direction) + IMAGES.index((offset, pixel))) % 2)
    jobs = [FACING, POCKET, DRILLING]
    jobs.insert(guilty, CRASH)
    z = simulate_job([Cut(one, FLAT) for one in jobs], stock=ROUGH, view=View(direction, 150, 120, pixel, offset))
    found = deviations(z, PART)
    told = [*gouges(z, found, 0.1), *worst_places(z, found, 0.1)[0]]
    assert len(told) > 1 and {one.source and one.source.cut for one in told} == {guilty}
    sure = sum(one.area for one in gouges(z, found, 0.1)) / pixel**2
    assert sure == pytest.approx(np.count_nonzero(found.gouged > 0.1), rel=0.05)


def test_cut_within_tolerance_is_not_a_gouge():
    """A pocket is 0.05 mm too deep, which is within the tolerance. Inside the pocket, another cut is 2 mm too deep."""
    z = simulated(path((5, 15, 7.95), (35, 15, 7.95)), path((10, 15, 6), (30, 15, 6)))
    (gouge,) = gouges(z, deviations(z, Stock((0, 0, 0), (40, 30, 8))), 0.1)
    assert gouge.source.cut == 1 and gouge.depth == pytest.approx(2)


def test_gouge_under_a_cavity_in_the_stock_has_its_source():
    """The stock has a cavity from 4 to 9 mm.

    A slot down to 2 mm gouges the 8 mm high model; a slot in the lid does not.
    """
    solid = Stock((0, 0, 0), (40, 30, 10))
    hollow = Milled(solid)
    hollow.spans = lambda frame, x, y: Spans(
        *solid.spans(frame, x, y)[:2], Gaps(np.arange(len(x)), np.full(len(x), -4.0), np.full(len(x), 1.0))
    )
    lid, deep = path((5, 15, 8.5), (35, 15, 8.5)), path((10, 15, 2), (30, 15, 2))
    cuts = [Cut(lid, FLAT), Cut(deep, FLAT)]
    model = Stock((0, 0, 0), (40, 30, 8))
    frame = VIEW.frame(solid)
    z = simulate_job(cuts, stock=hollow, view=VIEW, processes=1)
    assert z.frame.pixel == frame.pixel
    by_none, by_deep = sorted(gouges(z, deviations(z, model), 0.1), key=lambda one: one.depth)
    assert by_none.depth == pytest.approx(4) and by_none.trajectory is None
    assert by_deep.depth == pytest.approx(6) and by_deep.source.cut == 1
    # Before the deep cut, no trajectory is responsible for the gouge.
    (early,) = gouges(z.at(1), deviations(z.at(1), model), 0.1)
    assert early.depth == pytest.approx(4) and early.trajectory is None


@pytest.mark.long
@pytest.mark.parametrize("direction, seen", list(zip(VIEWS, (1, 1, 1, 0.7, 1))))
def test_depth_of_a_wall_gouge_is_its_distance_not_its_height(direction, seen):
    """The wall of a step of 8 mm is cut 1 mm too far.

    From the rear, the edge of the step is missing, and only the width of the missing edge is visible.
    """
    step = Milled(Stock((0, 0, 0), (40, 30, 10)), Stock((-1, -1, 2), (20, 31, 20)))
    z = simulate_job([Cut(path((18, -5, 2), (18, 35, 2)), FLAT)], stock=BOX, view=View(direction, 400, 300))
    (gouge,) = gouges(z, deviations(z, step), 0.1)
    assert gouge.depth == pytest.approx(seen, abs=z.frame.pixel)


@pytest.mark.long
def test_leftover_in_a_square_corner_is_measured():
    """In a square corner 8 mm deep, a tool of 6 mm leaves (sqrt(2) - 1) times its radius."""
    square = Milled(Stock((0, 0, 0), (40, 30, 10)), Stock((16, 11, 2), (24, 19, 20)))
    around = [(19, 14), (21, 14), (21, 16), (19, 16), (19, 14)]
    cut = Cut(path((19, 14, 12), *((x, y, 2) for x, y in around)), FLAT)
    z = simulate_job([cut], stock=BOX, view=View((0, 0, -1), 400, 400, pixel=0.025))
    found = deviations(z, square)
    (left,) = material_left(z, found, 0.1)
    assert left.depth == pytest.approx(3 * (np.sqrt(2) - 1), abs=0.1) and gouges(z, found, 0.1) == []
    corners = worst_places(z, found, 0.1)[1]
    assert [one.depth for one in corners] == pytest.approx([left.depth] * 4, abs=0.05)


def test_missing_rib_and_hole_have_full_depth():
    """A rib 2 mm wide and 5 mm high was cut away. A hole of 4 mm, 6 mm deep, was not drilled."""
    ribbed = Milled(Stock((0, 0, 0), (40, 30, 10)), Stock((-1, -1, 5), (19, 31, 20)), Stock((21, -1, 5), (41, 31, 20)))
    rows = [(x, y, 5) for k, x in enumerate(range(0, 41, 5)) for y in ((-5, 35) if k % 2 == 0 else (35, -5))]
    z = simulated(path(*rows))
    assert [gouge.depth for gouge in gouges(z, deviations(z, ribbed), 0.1)] == pytest.approx([5])
    drilled = Milled(BOX, Cylinder((20, 15, 4), 2, 20))
    assert [left.depth for left in material_left(UNCUT, deviations(UNCUT, drilled), 0.1)] == pytest.approx([6])


THROUGH = Milled(BOX, Cylinder((20, 15, -1), 4, 20))
DRILL = Tool("endmill", 8)


@pytest.mark.long
@pytest.mark.parametrize("direction", VIEWS)
@pytest.mark.parametrize("forgotten", [True, False])
def test_through_hole_that_was_not_drilled_is_leftover(direction, forgotten):
    drilled = [] if forgotten else [Cut(path((20, 15, 12), (20, 15, -1)), DRILL)]
    z = simulate_job(drilled, stock=BOX, view=View(direction, 300, 240))
    found = deviations(z, THROUGH)
    assert bool(material_left(z, found, 0.1)) == forgotten and gouges(z, found, 0.1) == []
    if forgotten and direction == (0, 0, -1):
        assert worst_places(z, found, 0.1)[1][0].depth == pytest.approx(10)


def test_leftover_in_through_holes_and_windows_is_measured():
    def left(*cuts, stock=BOX, model=THROUGH):
        z = simulate_job(cuts, stock=stock, view=View((0, 0, -1), 300, 225))
        found = deviations(z, model)
        assert gouges(z, found, 0.1) == []
        return [one.depth for one in worst_places(z, found, 0.1)[1]]

    # One drilling is 2 mm too short, and one has a drill of 7 mm instead of 8 mm.
    assert left(Cut(path((20, 15, 12), (20, 15, 2)), DRILL)) == pytest.approx([2])
    assert left(Cut(path((20, 15, 12), (20, 15, -1)), Tool("endmill", 7))) == pytest.approx([0.5], abs=0.15)
    # The drill goes through the model and into the stock below the model.
    spare = Stock((0, 0, -3), (40, 30, 10))
    assert left(Cut(path((20, 15, 12), (20, 15, -1)), DRILL), stock=spare) == []
    # A tool cuts along the wall of a window, and the inner piece falls out. An opening in the part's side is not
    # treated as a window.
    window = Milled(BOX, Stock((10, 8, -1), (30, 22, 20)))
    around = Cut(
        path((11, 9, 12), *((x, y, -1) for x, y in ((11, 9), (29, 9), (29, 21), (11, 21), (11, 9)))), Tool("endmill", 2)
    )
    assert max(left(around, model=window), default=0) < 0.45  # Only leftover in the corners of the window remains.
    assert left(model=window) == pytest.approx([10])
    assert left(model=Milled(BOX, Stock((10, 8, -1), (30, 40, 20)))) == []


def test_leftover_begins_two_pixels_from_a_through_hole():
    """A window of 20 x 14 mm covers columns 50 to 149 and rows 40 to 109.

    The left half of the window, up to column 99, is cut out.
    """
    half = Milled(BOX, Stock((10, 8, -1), (20, 22, 20)))
    z = simulate_job([], stock=half, view=VIEW, processes=1)
    found = deviations(z, Milled(BOX, Stock((10, 8, -1), (30, 22, 20)))).left.reshape(HEIGHT, WIDTH)
    assert np.flatnonzero(found[41]).tolist() == np.flatnonzero(found[108]).tolist() == list(range(102, 149))
    assert (found[41, 102:149] == 10).all() and not found[43:107, 50:147].any()


@pytest.mark.long
@pytest.mark.parametrize("pixels", [225, 300, 450])
@pytest.mark.parametrize("diameter", [1.5, 3.175])
def test_piece_that_falls_out_of_a_sheet_is_not_leftover(diameter, pixels):
    """The slot around the piece is as wide as a pixel or wider. The pixels are 1.33, 1 or 0.67 mm."""
    sheet, low, high = Stock((0, 0, 0), (300, 200, 6)), (50.13, 40.27), (250.13, 160.27)
    (left, front), (right, back) = np.array(low) + diameter / 2, np.array(high) - diameter / 2
    corners = (left, front), (right, front), (right, back), (left, back), (left, front)
    slot = Cut(path((left, front, 12), *((x, y, -1) for x, y in corners)), Tool("endmill", diameter))
    z = simulate_job([slot], stock=sheet, view=View((0, 0, -1), pixels, pixels * 2 // 3))
    assert material_left(z, deviations(z, Milled(sheet, Stock((*low, -1), (*high, 20)))), 0.1) == []


def test_piece_that_falls_out_is_ignored_in_oblique_view():
    """In this view, the piece that falls out is visible through the slot, in front of the lower end of the far wall."""
    sheet = Stock((0, 0, 0), (120, 80, 6))
    corners = (23, 23), (97, 23), (97, 57), (23, 57), (23, 23)
    slot = Cut(path((23, 23, 12), *((x, y, -1) for x, y in corners)), Tool("endmill", 6))
    z = simulate_job([slot], stock=sheet, view=View((0, 1, -1), 450, 300))
    window = Milled(sheet, Stock((20, 20, -1), (100, 60, 20)))
    assert max(one.depth for one in material_left(z, deviations(z, window), 0.1)) < 2


def test_pixels_connected_to_the_image_edge_are_found():
    """A flood fill, pixel by pixel, finds the expected pixels."""
    for seed in range(20):
        rng = np.random.default_rng(seed)
        free = rng.random(rng.integers(3, 30, 2)) < 0.6
        reached = {
            (r, c) for r, c in np.argwhere(free).tolist() if r in (0, len(free) - 1) or c in (0, free.shape[1] - 1)
        }
        pending = list(reached)
        while pending:
            r, c = pending.pop()
            for place in ((r + 1, c), (r - 1, c), (r, c + 1), (r, c - 1)):
                inside = 0 <= place[0] < free.shape[0] and 0 <= place[1] < free.shape[1]
                if inside and free[place] and place not in reached:
                    reached.add(place)
                    pending.append(place)
        assert set(map(tuple, np.argwhere(_connected_to_edge(free)).tolist())) == reached, seed


def test_one_edge_pixel_connects_its_whole_region():
    free = np.zeros((7, 9), bool)
    free[3, :5] = free[1:6, 4] = True
    assert (_connected_to_edge(free) == free).all()
    free[3, 0] = False
    assert not _connected_to_edge(free).any()
