# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sample of rays: the positions of the rays, the areas that they represent, and the estimated counts of dexels."""

from __future__ import annotations

import numpy as np
import pytest
from zbuffer_inputs import ConvexStock, toolpath

from vkworkbench.core import Stock, Tool, View
from vkworkbench.core.zbuffer.memory.counts import count
from vkworkbench.core.zbuffer.memory.sampling import _CELLS, _ORDER, Sample, sample
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.simulator.simulate import simulate
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts

STOCK, TOP = Stock((0, 0, 0), (40, 30, 10)), (0, 0, -1)
VIEW = View(TOP, 80, 60)
FLAT, WIDE = Tool("endmill", 6), Tool("endmill", 200)


def removal(points, tool=FLAT, view=VIEW):
    cuts = Cuts([Cut(toolpath(np.array(points, float)), tool)])
    return Removal(cuts, STOCK, view.frame(STOCK))


def drawn(*arguments, seed=1, **options):
    found = removal(*arguments, **options)
    return found, sample(found, np.random.default_rng(seed))


def test_error_of_a_total_uses_differences_of_neighbouring_rays():
    """The three rays contribute 2, 4 and 8 to the total, with differences of 2 and 4.

    The variance is half the sum of the squared differences, times 3 / 2.
    """
    rays = Sample(np.zeros(3), np.zeros(3), np.full(3, 2.0))
    assert rays.total(np.array([1, 2, 4])) == (14, pytest.approx(np.sqrt((4 + 16) / 2 * 3 / 2)))
    assert Sample(*np.ones((3, 1))).total(np.array([-3])) == (-3, 3)
    assert Sample(*np.ones((3, 2))).total(np.array([3, 5])) == (8, pytest.approx(2))
    assert Sample(*np.empty((3, 0))).total(np.empty(0)) == (0, 0)


@pytest.mark.parametrize(
    ("points", "width", "height"),
    [
        ([(20, 15, 5), (20, 15, 8)], 6.5, 6.5),
        ([(20, 15, 5), (20.4, 15.2, 5)], 6.9, 6.7),
        ([(38, 15, 5), (38, 15, 8)], 5.25, 6.5),
        ([(1, 15, 5), (1, 15, 8)], 4.25, 6.5),
        ([(20, 28, 5), (20, 28, 8)], 6.5, 5.25),
        ([(20, 1, 5), (20, 1, 8)], 6.5, 4.25),
        ([(10, 15, 5), (30, 15, 5)], 26.5, 6.5),
        ([(20, 10, 5), (20, 20, 5)], 6.5, 16.5),
    ],
)
def test_samples_represent_box_of_the_sweep_plus_half_a_pixel(points, width, height):
    found, rays = drawn(points)
    total, _ = rays.total(np.ones(len(rays.x)))
    # The bounding box of a long move is divided into parts that overlap.
    assert total == pytest.approx(width * height, rel=0.01 if max(width, height) > 10 else 1e-9)
    assert len(rays.x) == 450
    low, high = found.box[[0, 2], 0], found.box[[1, 3], 0]
    assert (rays.x >= low[0] - 0.5).all() and (rays.x <= high[0] + 0.5).all()
    assert (rays.y >= low[1] - 0.5).all() and (rays.y <= high[1] + 0.5).all()


def test_samples_of_a_partial_view_represent_the_image():
    _, rays = drawn([(20, 15, 5), (20, 15, 8)], view=View(TOP, 8, 6, pixel=0.5))
    assert rays.total(np.ones(len(rays.x)))[0] == pytest.approx(4 * 3)


@pytest.mark.parametrize(
    "holes",
    [
        # One hole is on the left of the image, the other hole on the right of the image.
        [(5, 15, 5), (5, 15, 20), (35, 15, 20), (35, 15, 5)],
        [(5, 15, 5), (5, 15, 8)],
        [(20, 5, 5), (20, 5, 8)],
    ],
)
def test_image_that_shows_no_cut_has_no_sampled_rays(holes):
    found, rays = drawn(holes, view=View(TOP, 8, 6, pixel=0.5))
    assert len(rays.x) == len(rays.y) == len(rays.area) == 0 and count(found).traces == 0


@pytest.mark.parametrize(
    ("offset", "width", "height"),
    [
        ((0, 0), 40.5, 30.5),
        ((30, 0), 10.25, 30),
        ((-30, 0), 10.25, 30),
        ((0, -20), 40, 10.25),
        ((30, 20), 10.25, 10.25),
    ],
)
def test_samples_represent_the_stock_inside_the_image(offset, width, height):
    """A tool far wider than the stock passes all of the stock. The image is 40 x 30 mm, or larger than the stock."""
    moves = [(0, 15, 5), (40, 15, 5)]
    found = View(TOP, 80, 60, pixel=0.5, offset=offset) if any(offset) else View(TOP, 120, 100, pixel=0.5)
    _, rays = drawn(moves, WIDE, found)
    assert rays.total(np.ones(len(rays.x)))[0] == pytest.approx(width * height)


@pytest.mark.parametrize("direction", [TOP, (1, 1, -1), (0, 1, 0)])
@pytest.mark.parametrize("offset", [(0, 0), (25, 18), (-30, 0), (0, -12)])
def test_traces_of_a_panned_view_are_its_visible_traces(direction, offset):
    moves = [(x, y, 5) for k, y in enumerate(range(0, 31, 5)) for x in ((-5, 45) if k % 2 == 0 else (45, -5))]
    path, view = toolpath(np.array(moves, float)), View(direction, 240, 180, pixel=0.2, offset=offset)
    told, true = count(removal(moves, view=view)), simulate(path, tool=FLAT, stock=STOCK, view=view)
    assert abs(told.traces - true.traces) < 3 * told.traces_error + 0.01 * true.traces
    assert told.dexels == pytest.approx(true.dexels, rel=0.02) and true.traces > 1000


def test_sampled_rays_go_through_pixel_centres():
    _, rays = drawn([(10, 15, 5), (30, 15, 5)])
    column, row = rays.x / 0.5 + 40 - 0.5, rays.y / 0.5 + 30 - 0.5
    assert np.allclose(column, np.rint(column)) and np.allclose(row, np.rint(row))
    # Each sixth of the slot's box (26.5 x 6.5 mm) contains at least half of the mean number of rays.
    for place, extent in ((rays.x, 26.5), (rays.y, 6.5)):
        assert np.histogram(place - place.mean(), 6, (-extent / 2, extent / 2))[0].min() > 450 / 6 / 2


def test_no_ray_is_drawn_where_no_trajectory_passes():
    for points in ([(0, 0, 20), (10, 0, 20)], [(100, 100, 5), (120, 100, 5)]):
        assert len(drawn(points)[1].x) == 0
    _, rays = drawn([(2, 2, 5), (4, 2, 5), (4, 2, 20), (36, 28, 20), (36, 28, 5), (38, 28, 5)])
    assert (np.abs(rays.x) > 12).all() and (np.abs(rays.y) > 7).all()
    # The tolerance is 0.3, because whole cells of the sampling grid represent the area.
    assert rays.total(np.ones(len(rays.x)))[0] == pytest.approx(2 * 7.25 * 5.25, rel=0.3)


def test_crowded_area_has_more_rays_with_smaller_areas():
    """One slot is on the left, and sixteen overlapping slots are on the right, with four times as many rays."""
    often = np.array([(25, 15, 5), (35, 15, 5)] * 9)[:17].astype(float)
    cuts = Cuts([Cut(toolpath(points), FLAT) for points in (often[:2] - (20, 0, 0), often)])
    rays = sample(Removal(cuts, STOCK, View(TOP, 80, 60).frame(STOCK)), np.random.default_rng(1))
    left, right = rays.x < 0, rays.x > 0
    assert left.sum() + right.sum() == len(rays.x) and right.sum() / left.sum() == pytest.approx(4, rel=0.05)
    assert np.median(rays.area[left]) / np.median(rays.area[right]) == pytest.approx(4, rel=0.05)
    assert rays.total(left)[0] == pytest.approx(rays.total(right)[0], rel=0.05)


def test_sample_has_fewer_rays_if_each_ray_is_passed_often():
    """Every move passes the whole image. The sample has 450 rays, or the number of rays that meet 150,000 moves in total.

    The sample never has fewer than 100 rays.
    """
    for many, rays in ((100, 450), (1000, 150), (3000, 100)):
        assert len(drawn([(20, 15, 5), (20.1, 15, 5)] * (many // 2), WIDE)[1].x) == pytest.approx(rays, abs=1)


def test_estimated_counts_of_an_image_cut_once_are_close():
    """A tool wider than the stock leaves a dexel and a trace in each pixel. A band has 64 rows."""
    counts = count(removal([(0, 15, 5), (40, 15, 5)], WIDE, View(TOP, 320, 240)))
    assert (counts.stock, counts.pixels) == (pytest.approx(320 * 240), 320 * 240)
    assert (counts.dexels, counts.traces, counts.touched, counts.passes) == pytest.approx((320 * 240,) * 4, rel=0.02)
    assert counts.band == pytest.approx(2 * 320 * 64, rel=0.2)
    assert counts.traces_error < 0.1 * counts.traces


def test_counts_are_close_if_the_whole_image_is_cut_through():
    counts = count(removal([(0, 15, -1), (40, 15, -1)], WIDE))
    assert counts.dexels == pytest.approx(0, abs=1e-6 * 4800) and counts.traces == pytest.approx(4800, rel=0.05)


def test_pixels_count_as_cut_once_if_only_the_first_pass_cuts():
    counts = count(removal([(0, 15, 5), (40, 15, 5)] * 3, WIDE))
    assert counts.traces == counts.touched == pytest.approx(4800, rel=0.05)
    assert counts.passes == pytest.approx(5 * counts.traces)


def test_ray_across_a_slot_has_a_dexel_for_each_wall():
    """In a front view of a slot along x, rays in 34 x 5 mm have a dexel before the slot and a dexel behind it."""
    counts = count(removal([(6, 15, 5), (34, 15, 5)], view=View((0, 1, 0), 200, 150)))
    per_area = 1 / 0.2**2
    assert counts.stock == pytest.approx(40 * 10 * per_area)
    assert counts.dexels - counts.stock == pytest.approx(34 * 5 * per_area, rel=0.05)
    assert counts.traces == pytest.approx(34 * 5 * per_area, rel=0.05)


def test_pixels_of_the_bounding_box_beside_the_slot_are_not_cut():
    """The slot covers 26 x 6 mm of its bounding box, without the four corners outside the round ends."""
    counts = count(removal([(10, 15, 5), (30, 15, 5)]))
    assert counts.touched == counts.traces == pytest.approx((6 * 20 + 9 * np.pi) * 4, rel=0.03)
    assert abs(counts.traces - (6 * 20 + 9 * np.pi) * 4) < 3 * counts.traces_error < 0.15 * counts.traces


def test_rays_beside_a_round_stock_have_no_dexel():
    stock, path = ConvexStock.cylinder((0, 0, 0), 20, 10, sides=24), toolpath(np.array([(-20.0, 18, 5), (20, 18, 5)]))
    view = View(TOP, 160, 160)
    counts = count(Removal(Cuts([Cut(path, FLAT)]), stock, view.frame(stock)))
    exact = simulate(path, tool=FLAT, stock=stock, view=view)
    assert counts.dexels == pytest.approx(exact.dexels, rel=2e-3) == pytest.approx(counts.stock, rel=2e-3)
    assert counts.traces == pytest.approx(exact.traces, rel=0.05)


@pytest.mark.parametrize("side", [2, 4, 8, 16])
def test_morton_curve_fills_one_square_after_another(side):
    """The sampling grid is numbered along the curve, so consecutive cells are neighbours."""
    row, column = (of.reshape(-1, side**2) for of in np.divmod(_ORDER, _CELLS))
    assert (np.ptp(row, axis=1) == side - 1).all() and (np.ptp(column, axis=1) == side - 1).all()
    assert sorted(_ORDER.tolist()) == list(range(_CELLS**2))
