# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bounds of the depths that a move cuts in a square seen from above, compared with many positions of the tool.

A bound that is too deep costs time, and a bound that is too shallow loses a cut. The tests find bounds that are too
deep and bounds that are too shallow.
"""

from __future__ import annotations

import numpy as np
import pytest
from zbuffer_inputs import BOX, FORMS, PATHS, toolpath

from vkworkbench.core import Cut, Stock, Tool, View, simulate
from vkworkbench.core.zbuffer.culling.tiles import QUARTERS
from vkworkbench.core.zbuffer.culling.upright import Slopes, Squares, Upright, bounds
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts
from vkworkbench.core.zbuffer.sweeps.trajectories import Trajectories

SLOPES = [0.0, 0.3, -0.3, 1.2, -1.2]
DEPTH = 2.0
PLACES, STEP = 1001, 5  # Number of positions of the tool on a move, and number of points on a side of a square.


def bounded(tool, slope, along, aside, extent, half_run):
    """Return the largest depth that a move can cut in a square, and the depth to which it cuts the whole square.

    The first depth is -inf if the move does not meet the square, the second if the move does not cover the square.
    """
    slopes = Slopes(np.array([slope])) if slope else None
    reaches, opens = bounds(
        tool, slopes, Squares(*(np.array([float(v)]) for v in (along, aside, extent, half_run, DEPTH)))
    )
    return tuple(-np.inf if np.isnan(depth) else float(depth) for (depth,) in (reaches, opens))


def opened(tool, slope, along, aside, extent, half_run):
    """Return the depths that the tool cuts at points of a square, (k,).

    The depth is -inf at points outside the sweep of the tool.
    """
    side = np.linspace(-extent, extent, STEP)
    x, y = (values.ravel() for values in np.meshgrid(along + side, aside + side))
    t = np.linspace(-half_run, half_run, PLACES)[:, None]
    return DEPTH - (slope * t + tool.height(np.hypot(x - t, y))).min(axis=0)


@pytest.mark.long
@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("tool", FORMS, ids=str)
def test_depth_bounds_of_a_square_hold_for_all_its_points(tool, slope):
    """Squares lie beside moves, across the ends and the edges of sweeps, inside long moves, and around short moves."""
    rng = np.random.default_rng([FORMS.index(tool), SLOPES.index(slope)])
    inside = 0
    for _ in range(40):
        half_run, extent = rng.choice([0.2, 2.0, 8.0]), rng.choice([0.05, 0.4, 1.5])
        along, aside = rng.uniform(-half_run - 4, half_run + 4), rng.uniform(-4, 4)
        reaches, opens = bounded(tool, slope, along, aside, extent, half_run)
        depths = opened(tool, slope, along, aside, extent, half_run)
        assert depths.max() <= reaches + 1e-9
        # On a slope, the tool may cut a little deeper between two of the compared positions.
        assert opens <= depths.min() + 0.02 * (1 + 3 * abs(slope))
        inside += np.isfinite(opens)
    assert inside > 3


# On slopes, the bounds are exact only for tools of one shape: flat, ball, or a cone steeper than the slope. The shapes
# of other tools have several parts, or a tip blunter than the slope.
SIMPLE = [
    (tool, slope)
    for tool in FORMS
    for slope in SLOPES
    if not slope or (tool.rounding in (0, tool.radius) and not tool.tip and not 0 < tool.steepness <= abs(slope))
]


@pytest.mark.parametrize("slope", [0.3, -0.3, 1.2, -1.2])
@pytest.mark.parametrize("half_run", [2.0, 8.0])
@pytest.mark.parametrize("along", [0.0, 1.5, -2.5, 6.0])
def test_flat_end_depth_bounds_are_exact_on_slopes(along, half_run, slope):
    """Squares of 0.8 mm lie on the axis of the move: inside the move, at its end, and beyond its end."""
    square = FORMS[0], slope, along, 0.0, 0.4, half_run
    reaches, deepest = bounded(*square)[0], opened(*square).max()
    assert reaches == (pytest.approx(deepest, abs=0.05) if np.isfinite(deepest) else deepest)


@pytest.mark.parametrize("tool, slope", SIMPLE, ids=str)
def test_depth_bounds_of_a_point_are_the_depth_cut_there(tool, slope):
    """The square is a thousandth of a mm wide, in the middle of a long move.

    Positions of the tool are 0.04 mm apart.
    """
    for aside in (0.0, 0.4, -1.4, 2.1):
        point = tool, slope, 0.7, aside, 1e-3, 20.0
        expected = pytest.approx([opened(*point).max()] * 2, abs=0.02 + 0.05 * abs(slope))
        assert bounded(*point) == expected, aside


@pytest.mark.parametrize("slope", SLOPES)
@pytest.mark.parametrize("tool", FORMS, ids=str)
def test_depth_cut_in_a_whole_square_beside_the_axis_is_exact(tool, slope):
    """The moves go up and down."""
    for aside in (0.0, 0.4, -1.4):
        point = tool, slope, 0.7, aside, 1e-3, 20.0
        expected = pytest.approx(opened(*point).max(), abs=0.03 + 0.06 * abs(slope))
        assert bounded(*point)[1] == expected, aside


@pytest.mark.parametrize("tool", FORMS, ids=str)
@pytest.mark.parametrize(
    "along, aside, near, far",
    [
        (0.0, 0.0, 0.0, 0.5),  # The square is around the middle of the move.
        (2.0, 1.0, 0.5, 1.5),  # The square is beside the move.
        (6.5, 0.0, 1.0, 4.25**0.5),  # The square is 2 mm past the end of the move, on the move's line.
        (-6.5, 1.5, 2**0.5, 8**0.5),  # The square is past the end of the move, and 1.5 mm beside the move's line.
    ],
)
def test_bounds_of_level_moves_are_at_nearest_and_farthest_point(tool, along, aside, near, far):
    """Squares of 1 mm near a move of 10 mm, with the distances of their nearest and farthest points from the move."""
    reaches, opens = bounded(tool, 0.0, along, aside, 0.5, 5.0)
    # The bounds of a ball allow 1e-9 mm2 for rounding.
    assert reaches == pytest.approx(DEPTH - tool.height(near), abs=1e-9)
    assert opens == (pytest.approx(DEPTH - tool.height(far), abs=1e-9) if far < tool.radius else -np.inf)


@pytest.mark.parametrize("slope", SLOPES)
def test_square_beside_a_sweep_is_not_cut_or_not_wholly_cut(slope):
    flat = FORMS[0]
    assert bounded(flat, slope, 0.0, 3.6, 0.5, 5.0) == (-np.inf, -np.inf)
    assert bounded(flat, slope, 8.6, 0.0, 0.5, 5.0) == (-np.inf, -np.inf)
    for along, aside in ((0.0, 3.4), (0.0, 2.6), (8.4, 0.0), (7.6, 0.0)):
        reaches, opens = bounded(flat, slope, along, aside, 0.5, 5.0)
        assert np.isfinite(reaches) and opens == -np.inf


@pytest.mark.parametrize("direction", [(0, 0, -1), (0, 0, 1)])
@pytest.mark.parametrize("ends", [((12, 17), (25, 17)), ((25, 17), (12, 17)), ((14, 9), (14, 21)), ((14, 21), (14, 9))])
@pytest.mark.parametrize("side", [4, 8, 32])
def test_quarters_of_a_tile_that_a_level_move_meets_are_kept(side, ends, direction):
    """A quarter of a tile is kept if one of its pixel centres is closer than 3 mm to the move of a flat end of 6 mm."""
    frame = View(direction, 160, 120, pixel=0.25).frame(BOX)
    cuts = Cuts([Cut(toolpath(np.array([(*end, 4.0) for end in ends])), Tool("endmill", 6))])
    row, column = (of.ravel() for of in np.mgrid[0:120:side, 0:160:side])
    tile, child = np.arange(len(row)), side // 2
    low, high = np.sort(np.array(ends, float), axis=0)
    stay = list(Upright(Trajectories(cuts, BOX, frame)).quarters(column, row, tile, 0 * tile, child))
    for (across, up), found in zip(QUARTERS, stay):
        x, y = (first[:, None] + np.arange(child) for first in (column + across * child, row + up * child))
        points = [
            frame.pixel_centres(x, y)[0] + 20,
            frame.pixel_centres(x, y)[1] * (1 if direction[2] < 0 else -1) + 15,
        ]
        dx, dy = (np.maximum(np.maximum(a - p, p - b), 0).min(axis=1) for p, a, b in zip(points, low, high))
        assert found.tolist() == np.flatnonzero(np.hypot(dx, dy) < 3).tolist()
    assert 0 < sum(map(len, stay)) < 4 * len(tile)


@pytest.mark.parametrize("direction", [(0, 0, -1), (0, 0, 1)])
@pytest.mark.parametrize("height, deeper, stay", [(9.9, 9.9, [0]), (-0.1, -2.0, [0]), (0.1, -2.0, [0, 1])])
def test_move_no_deeper_than_the_opened_quarter_is_dropped(height, deeper, stay, direction):
    """A tool wider than the block of 10 mm moves back and forth at two heights. The move down is beside the block."""
    frame = View(direction, 160, 120, pixel=0.25).frame(BOX)
    points = [(-60, 15, height), (100, 15, height), (100, 15, deeper), (-60, 15, deeper)]
    cuts = Cuts([Cut(toolpath(np.array(points)), Tool("endmill", 80))])
    upright, few = Upright(Trajectories(cuts, BOX, frame)), np.zeros(2, int)
    for found in upright.quarters(few + 64, few + 32, few, np.arange(2), 16):
        assert found.tolist() == stay


@pytest.mark.parametrize("direction", [(0, 0, -1), (0, 0, 1)])
def test_ramp_meets_no_quarter_of_a_tile_while_above_the_block(direction):
    """A ramp falls by 1 in 4 from 14 mm. The lowest tool height is about 12 mm at x = 5, and 5 mm at x = 33."""
    frame = View(direction, 160, 120, pixel=0.25).frame(BOX)
    cuts = Cuts([Cut(toolpath(np.array([(0.0, 15.0, 14.0), (40.0, 15.0, 4.0)])), Tool("endmill", 6))])
    upright, tile = Upright(Trajectories(cuts, BOX, frame)), np.arange(2)
    for found in upright.quarters(np.array([16, 128]), np.array([58, 58]), tile, 0 * tile, 4):
        assert found.tolist() == [1]


def test_only_rays_at_the_edge_of_a_sweep_are_tested_again(monkeypatch):
    """The edge of the sweep lies on the pixel centres of a row of 160 pixels.

    Testing all 24 rows of the slot would take far longer.
    """
    asked, passing = [], Trajectories.passing

    def counted(self, x, y, item):
        asked.append(len(item))
        return passing(self, x, y, item)

    monkeypatch.setattr(Trajectories, "passing", counted)
    slot = toolpath(np.array([(-10, 15.125, 6), (50, 15.125, 6)]))
    view = View((0, 0, -1), 160, 120, pixel=0.25)
    found = simulate(slot, tool=Tool("endmill", 6), stock=BOX, view=view, processes=1)
    assert found.traces >= 23 * 160 and 0 < sum(asked) <= 2 * 160


@pytest.mark.parametrize("direction", [(0, 0, -1), (0, 0, 1)])
@pytest.mark.parametrize("tool", FORMS[:2], ids=str)
def test_simulation_does_not_depend_on_the_height_of_the_stock(tool, direction):
    points, view = PATHS[0](np.random.default_rng(4), 40), View(direction, 80, 60)
    here = simulate(toolpath(points), tool=tool, stock=BOX, view=view)
    for by in (-37.0, 25.0):
        stock = Stock(BOX.lower + (0, 0, by), BOX.upper + (0, 0, by))
        there = simulate(toolpath(points + (0, 0, by)), tool=tool, stock=stock, view=view)
        assert there.dexels == here.dexels and there.traces == pytest.approx(here.traces, rel=1e-3)
        assert np.allclose(there.picture.depth, here.picture.depth, atol=1e-5, equal_nan=True)
