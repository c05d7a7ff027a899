# SPDX-License-Identifier: LGPL-2.1-or-later
"""The work of a simulation, in this image and in finer images, and the speed of this computer, computed by hand."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest
from zbuffer_inputs import BOX, toolpath

from vkworkbench.core import Cut, Stock, Tool, View
from vkworkbench.core.zbuffer.cost import effort
from vkworkbench.core.zbuffer.cost.effort import CELLS, KINDS, RECORDS, SORTED, TESTS, Work
from vkworkbench.core.zbuffer.cost.speed import Speed, _loops, _rows, _surface, fit_speed
from vkworkbench.core.zbuffer.culling.tiles import PAIRS_AT_ONCE, TILE, Tiles
from vkworkbench.core.zbuffer.memory.counts import count as counted
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts
from vkworkbench.core.zbuffer.sweeps.trajectories import Kind

FLAT = Tool("endmill", 6)


def of_kind(**amounts):
    """Return the number of pairs of a tile and a trajectory by kind: kind_2=5 means five pairs of kind 2."""
    return tuple(float(amounts.get(f"kind_{kind}", 0)) for kind in range(KINDS))


# Tiles with a side of 64 pixels, then tiles with a side of 32 pixels with four times as many pairs of a tile and a
# trajectory. The tiles with a side of 16 pixels, whose pixels are cut, have twice as many pairs as the tiles of 32.
WORK = Work(
    trajectories=10, pixels=1000, first=50, pairs=(of_kind(kind_0=1e5), of_kind(kind_3=4e5)),
    cells=of_kind(kind_2=2 * 16**2 * 4e5), unconnected=0.25, records=(3, 2), bands=2, kinds=1.5,
)  # fmt: skip


def test_numbers_of_steps_of_a_simulation_match_hand_count():
    trajectories, pixels, first, blocks, tests, cells, records = WORK.amounts()
    assert (trajectories, pixels, first) == (10, 1000, 50)
    assert tests == pytest.approx(4 * (1e5 * TESTS[0] + 4e5 * TESTS[3]))
    assert cells == pytest.approx(2 * 16**2 * 4e5 * (CELLS[2] + 0.25 * SORTED))
    assert records == pytest.approx(3 * RECORDS[0] + 2 * RECORDS[1])
    # For each tile size, there is at least one batch of tests per band of the image. A smaller tile size never has
    # fewer batches.
    assert blocks == pytest.approx(1.5 * (2 + 4e5 / PAIRS_AT_ONCE + 2 * 16**2 * 4e5 / PAIRS_AT_ONCE))


def test_work_of_finer_image_moves_to_the_next_tile_size():
    """The finer image has four times as many pixels.

    The number of cells (pairs of a pixel and a trajectory) grows by the geometric mean of 2 and 4: at the last tile
    size, the number of pairs of a tile and a trajectory grows by 2, and the number of pixels grows by 4.
    """
    trajectories, pixels, first, blocks, tests, cells, records = WORK.amounts(4.0)
    assert (trajectories, pixels, first) == (10, 4000, 200)
    assert cells == pytest.approx(sqrt(2 * 4) * WORK.amounts()[5]) and records == pytest.approx(4 * WORK.amounts()[6])
    # The cost of tests grows by more than 4 from the first tile size to the second, so the growth is limited to 4.
    assert tests == pytest.approx(4 * 1e5 * TESTS[0] * (4 + 16))
    each = max(4e5 / PAIRS_AT_ONCE, 4), 16e5 / PAIRS_AT_ONCE
    assert blocks == pytest.approx(1.5 * (sum(each) + sqrt(2 * 4) * 2 * 16**2 * 4e5 / PAIRS_AT_ONCE))


def test_number_of_test_batches_is_at_least_the_number_of_bands():
    few = Work(1, 1, 1, (of_kind(kind_0=8), of_kind(kind_0=2)), of_kind(kind_0=9), 0, (1, 0), bands=3, kinds=2)
    assert few.amounts()[3] == pytest.approx(2 * (3 + 3 + 3))
    falling = Work(1, 1, 1, (of_kind(kind_0=5 * PAIRS_AT_ONCE), of_kind(kind_0=1)), of_kind(), 0, (1, 0), 0, 1)
    assert falling.amounts()[3] == pytest.approx(5 + 5)


@pytest.mark.parametrize(
    "levels, growth, finer",
    [
        ([1, 2, 16], 1, [1, 2, 16]),
        # With twice as many pixels, each number is the geometric mean of the old numbers for this tile size and for the
        # next tile size. The number for the next tile size counts as at most 4 times the number for this tile size.
        ([1, 2, 16], 2, [sqrt(2), 4, 16]),
        ([1, 4], 4, [4, 16]),
        ([1, 4], 0.25, [0.25, 1]),
        ([4, 2], 4, [4, 4]),  # Smaller tiles have at least as many pairs of a tile and a trajectory.
        ([5], 4, [20]),
        ([], 4, []),
        ([0, 4], 3, [0, 12]),
    ],
)
def test_tile_counts_of_a_finer_image_are_interpolated(levels, growth, finer):
    assert effort._shift_levels(np.array(levels, float), growth) == pytest.approx(finer)


@pytest.mark.parametrize(
    "step, growth, factor", [(2, 4, sqrt(8)), (2, 16, 8), (8, 4, 4), (0.5, 4, 2), (3, 2, 12**0.25)]
)
def test_growth_of_cut_cells_is_the_geometric_mean_of_two_models(step, growth, factor):
    """A cell is a pair of a pixel and a trajectory that cuts the pixel's ray.

    If the number of pixels grows by 4, the number of cells grows by the geometric mean of 4 and the growth of the pairs
    of a tile and a trajectory at the last tile size (at least 1).
    """
    work = Work(1, 1, 1, (of_kind(kind_3=100),), of_kind(kind_3=step * 100 * 32**2), 0, (1, 0), 1, 1)
    assert work._cell_growth(growth) == pytest.approx(factor)


def test_cut_cells_grow_like_the_pixels_without_tile_counts():
    assert Work(1, 1, 1, (), of_kind(kind_3=100), 0, (1, 0), 1, 1)._cell_growth(3.0) == 3
    assert Work(1, 1, 1, (of_kind(kind_3=9),), of_kind(), 0, (1, 0), 1, 1)._cell_growth(3.0) == 3


def test_kinds_of_tile_and_trajectory_pairs_are_numbered_0_to_15():
    """The number of the kind depends on the tool, the move (horizontal or sloped) and the view (vertical or oblique)."""
    tools = [FLAT, Tool("vbit", 6, tip_angle=pi / 2), Tool("ballend", 6), Tool("bullnose", 6, corner_radius=1)]
    found = [
        effort._kind_number(Kind(tool, level), upright)
        for tool in tools
        for level in (True, False)
        for upright in (True, False)
    ]
    assert found == list(range(KINDS)) and len(TESTS) == len(CELLS) == KINDS
    assert effort._kind_number(Kind(Tool("drill", 6), True), True) == 4


def tiles(sizes, side=8):
    """Return tiles in one row. Tile k contains `sizes[k]` trajectories, and every trajectory is in one tile."""
    first = np.append(0, np.cumsum(sizes))
    return Tiles(side, side * np.arange(len(sizes)), np.zeros(len(sizes), np.int64), first, np.arange(first[-1]))


def test_pairs_of_tile_and_trajectory_are_counted_by_kind():
    kind = np.array([5, 7, 7])
    assert effort._count_pairs(tiles([2, 1]), np.array([10.0, 2.0]), kind).tolist() == list(
        of_kind(kind_5=10, kind_7=12)
    )


def test_parent_tile_contains_the_smaller_tile():
    large = Tiles(8, np.array([8, 0, 16]), np.array([0, 8, 8]), np.arange(4), np.arange(3))
    small = Tiles(4, np.array([12, 0, 20, 8, 4]), np.array([4, 12, 8, 0, 8]), np.arange(6), np.arange(5))
    assert effort._parents(large, small).tolist() == [0, 1, 2, 0, 1]


def test_all_tiles_are_sampled_if_they_have_few_trajectories():
    some, weight = tiles([10] * 10), np.full(10, 3.0)
    assert effort._draw_tiles(some, weight, np.ones(100), 100, np.random.default_rng(1)) == (some, weight)


def test_equally_costly_tiles_are_sampled_at_regular_steps():
    """Each of 100 tiles has 10 pairs of a tile and a trajectory.

    A sample of 200 pairs consists of 20 tiles, one of every five consecutive tiles.
    """
    drawn, weight = effort._draw_tiles(
        tiles([10] * 100), np.full(100, 3.0), np.ones(1000), 200, np.random.default_rng(1)
    )
    assert weight == pytest.approx(np.full(20, 15.0)) and np.diff(drawn.first).tolist() == [10] * 20
    assert (drawn.column // 8 // 5).tolist() == list(range(20)) and drawn.side == 8 and not drawn.row.any()
    for tile, column in enumerate(drawn.column // 8):
        assert drawn.item[drawn.first[tile] : drawn.first[tile + 1]].tolist() == list(
            range(10 * column, 10 * column + 10)
        )


def test_sampled_tiles_represent_the_total_cost_of_all_tiles():
    """A tile whose cost equals the cost of all other tiles is always in the sample and keeps its weight."""
    rng = np.random.default_rng(2)
    sizes, weight = rng.integers(1, 9, 200), rng.uniform(1, 3, 200)
    cost = rng.uniform(0.1, 1, sizes.sum())
    first = np.append(0, np.cumsum(sizes))
    cost[first[77] : first[78]] *= 4000
    each = np.add.reduceat(cost, first[:-1])
    for seed in range(5):
        drawn, heavy = effort._draw_tiles(tiles(sizes), weight, cost, 60, np.random.default_rng(seed))
        tile = drawn.column // 8
        assert (heavy * each[tile]).sum() == pytest.approx((weight * each).sum())
        assert heavy[tile == 77] == pytest.approx(weight[77]) and len(tile) < 30
        assert np.diff(drawn.first).tolist() == sizes[tile].tolist()


def test_chance_of_drawing_a_tile_is_at_most_one():
    """With 3 draws, the chance of the first tile would be 3 * 8 / 12 = 2, so the chance is limited to 1.

    The other 2 draws give 2 * 2 / 4 = 1 and 2 * 1 / 4.
    """
    assert effort._chances(np.array([8.0, 2, 1, 1]), 3) == pytest.approx([1, 1, 0.5, 0.5])


def test_all_tiles_are_sampled_if_slow_tiles_have_few_pairs():
    """Nearly the whole cost is in two tiles, each with one pair of a tile and a trajectory.

    A sample of 50 pairs would need 50 tiles, and only 3 exist.
    """
    some, weight = tiles([100, 1, 1]), np.ones(3)
    cost = np.append(np.full(100, 1e-9), [1.0, 1.0])
    assert effort._draw_tiles(some, weight, cost, 50, np.random.default_rng(1)) == (some, weight)


@pytest.mark.long
def test_cost_of_crowded_tiles_is_estimated(monkeypatch):
    """Loops of adaptive clearing in an oblique view: thousands of trajectories pass each of the few tiles."""
    turn = np.linspace(0, 2 * pi, 24, endpoint=False)
    x, y = 10 + np.tile(np.arange(100) * 0.4, 4), 8 + 5 * np.repeat(np.arange(4), 100)
    loops = np.stack((x[:, None] + 2 * np.cos(turn), y[:, None] + 2 * np.sin(turn), np.full((400, 24), 3.0)), axis=2)
    path, box = toolpath(loops.reshape(-1, 3)), Stock((0, 0, 0), (60, 40, 10))
    removal = Removal(Cuts([Cut(path, FLAT)]), box, View((1, 1, -sqrt(2 / 3)), 400, 300).frame(box))
    counts = counted(removal)

    def seconds():
        return Speed().seconds(effort.work_of(removal, len(path), counts))

    drawn = []
    for seed in range(12):
        monkeypatch.setattr(effort, "_SEED", seed)
        drawn.append(seconds())
    monkeypatch.setattr(effort, "_PAIRS", 10**9)
    off = np.log(np.array(drawn) / seconds())
    assert abs(off.mean()) < 0.06 and off.std() < 0.18


@pytest.mark.parametrize("looked_at, count", [(2_000_000, 63), (120, 40), (0, 24)])
def test_sample_of_the_largest_tiles_represents_all_tiles(looked_at, count, monkeypatch):
    """The image has 9 x 7 tiles and two trajectories.

    The sample contains all 63 tiles, or 120 / (2 + 1) tiles, or the minimum of 24 tiles.
    """
    monkeypatch.setattr(effort, "_LOOKED_AT", looked_at)
    view = View((0, 0, -1), 9 * TILE - 20, 7 * TILE - 20)
    path = toolpath(np.array([(5, 5, 5), (35, 5, 5), (35, 25, 5)], float))
    removal = Removal(Cuts([Cut(path, FLAT)]), BOX, view.frame(BOX))
    found, weight, every = effort._draw_first_tiles(removal, np.random.default_rng(3))
    assert every == 63 and weight == pytest.approx(np.full(count, 63 / count))
    # The sample has one tile from each of `count` equally long runs of tiles.
    number = found.row // TILE * 9 + found.column // TILE
    assert ((np.arange(count) * 63 // count <= number) & (number <= (np.arange(count) + 1) * 63 / count)).all()
    assert not (found.column % TILE).any() and not (found.row % TILE).any() and found.side == TILE


def test_measured_speed_has_a_smaller_uncertainty():
    measured = fit_speed(np.eye(7), Speed().constants)
    assert (measured.factor, Speed().factor) == (2, 3) and measured.constants == pytest.approx(Speed().constants)
    assert measured.processes == Speed().processes == 1


def test_one_measured_time_scales_all_constants_of_the_speed():
    amounts = np.array([[5, 2e4, 300, 7, 1e4, 1e5, 2e3]])
    seconds = 3 * amounts @ Speed().constants
    assert fit_speed(amounts, seconds).constants == pytest.approx(3 * Speed().constants)


def test_contradictory_times_are_fitted_by_ridge_regression():
    """Two kinds of work with default times of 1 s took 1 s and 4 s. The median of 1 s and 4 s is 2.5 s.

    The fitted shares s of 2.5 times the default minimise (2.5 s - 1)^2 + (s - 1)^2 / 4, and (2.5 s / 4 - 1)^2 + (s -
    1)^2 / 4.
    """
    usual = Speed().constants
    amounts = np.eye(7)[[2, 5]] / usual
    found = fit_speed(amounts, np.array([1.0, 4.0])).constants / usual
    expected = np.full(7, 2.5)
    expected[2] *= (2.5 + 0.25) / (2.5**2 + 0.25)
    expected[5] *= (0.625 + 0.25) / (0.625**2 + 0.25)
    assert found == pytest.approx(expected)


def test_fitted_constants_are_at_least_a_tenth_of_the_median():
    """The times are 1 s and 1000 s, with a median of 500.5 s."""
    usual = Speed().constants
    found = fit_speed(np.eye(7)[[2, 5]] / usual, np.array([1.0, 1000.0])).constants / usual
    assert found[2] == pytest.approx(50.05) and found[0] == pytest.approx(500.5)


def test_calibration_toolpaths_are_cuts_inside_the_block():
    for made in (_rows(12), _loops(3), _surface(4)):
        assert not made.rapid.any() and len(made) == len(made.points) - 1 == made.commands > 20
        assert (made.points.min(axis=0) >= 0).all() and (made.points.max(axis=0) <= (60, 60, 17)).all()


@pytest.mark.parametrize("rise", [0.0, 1.0])
def test_cost_of_bull_nose_pixels_depends_on_the_length_of_move(rise):
    """Rays pass a long sweep mostly between its ends, and a short sweep mostly at an end.

    Only bull-nose tools in oblique views have different costs for rays between the ends and for rays at an end.
    """
    stock, bull_nose = Stock((0, 0, 0), (60, 60, 10)), Tool("bullnose", 6, corner_radius=1)

    def cells(run, tool=bull_nose, direction=(1, 1, -1)):
        points = [(x, 30, 5 + rise * (k % 2)) for k, x in enumerate(np.arange(10.0, 50, run))]
        removal = Removal(Cuts([Cut(toolpath(np.array(points)), tool)]), stock, View(direction, 40, 30).frame(stock))
        return np.array(effort.work_of(removal, len(points) - 1, counted(removal)).cells)

    for run in (2.0, 20.0):
        at_end, between = cells(run)[[13, 15]]
        assert between / (at_end + between) == pytest.approx(run / (run + pi / 2 * 3))
        assert cells(run).sum() == pytest.approx(at_end + between)
        assert np.count_nonzero(cells(run, FLAT)) == np.count_nonzero(cells(run, direction=(0, 0, -1))) == 1
    assert CELLS[15] > 2 * CELLS[13]
