# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a simulation has to do, in this image and in finer ones, and how fast this computer does it: small cases by hand."""

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
    """Amounts by kind of pair: kind_2=5 are five of kind 2."""
    return tuple(float(amounts.get(f"kind_{kind}", 0)) for kind in range(KINDS))


# Two levels of tiles of 64 and 32 pixels, four times as many pairs on the second; pixels of tiles of 16, twice as many pairs.
WORK = Work(
    trajectories=10, pixels=1000, first=50, pairs=(of_kind(kind_0=1e5), of_kind(kind_3=4e5)),
    cells=of_kind(kind_2=2 * 16**2 * 4e5), unconnected=0.25, records=(3, 2), bands=2, kinds=1.5,
)  # fmt: skip


def test_the_amounts_of_a_simulation():
    trajectories, pixels, first, blocks, tests, cells, records = WORK.amounts()
    assert (trajectories, pixels, first) == (10, 1000, 50)
    assert tests == pytest.approx(4 * (1e5 * TESTS[0] + 4e5 * TESTS[3]))
    assert cells == pytest.approx(2 * 16**2 * 4e5 * (CELLS[2] + 0.25 * SORTED))
    assert records == pytest.approx(3 * RECORDS[0] + 2 * RECORDS[1])
    # No level has fewer blocks than bands, or than the level before it.
    assert blocks == pytest.approx(1.5 * (2 + 4e5 / PAIRS_AT_ONCE + 2 * 16**2 * 4e5 / PAIRS_AT_ONCE))


def test_in_an_image_of_four_times_as_many_pixels_every_level_is_the_next():
    """And the pixels have more pairs, between twice as many, as they had of the last tiles, and four times, as they end."""
    trajectories, pixels, first, blocks, tests, cells, records = WORK.amounts(4.0)
    assert (trajectories, pixels, first) == (10, 4000, 200)
    assert cells == pytest.approx(sqrt(2 * 4) * WORK.amounts()[5]) and records == pytest.approx(4 * WORK.amounts()[6])
    # What tests take grows by more than four times from the first level to the second: by four at most.
    assert tests == pytest.approx(4 * 1e5 * TESTS[0] * (4 + 16))
    each = max(4e5 / PAIRS_AT_ONCE, 4), 16e5 / PAIRS_AT_ONCE
    assert blocks == pytest.approx(1.5 * (sum(each) + sqrt(2 * 4) * 2 * 16**2 * 4e5 / PAIRS_AT_ONCE))


def test_blocks_are_no_fewer_than_the_bands_of_the_image():
    few = Work(1, 1, 1, (of_kind(kind_0=8), of_kind(kind_0=2)), of_kind(kind_0=9), 0, (1, 0), bands=3, kinds=2)
    assert few.amounts()[3] == pytest.approx(2 * (3 + 3 + 3))
    falling = Work(1, 1, 1, (of_kind(kind_0=5 * PAIRS_AT_ONCE), of_kind(kind_0=1)), of_kind(), 0, (1, 0), 0, 1)
    assert falling.amounts()[3] == pytest.approx(5 + 5)


@pytest.mark.parametrize(
    "levels, growth, finer",
    [
        ([1, 2, 16], 1, [1, 2, 16]),
        ([1, 2, 16], 2, [sqrt(2), 4, 16]),  # half a level on; no step is by more than four
        ([1, 4], 4, [4, 16]),
        ([1, 4], 0.25, [0.25, 1]),
        ([4, 2], 4, [4, 4]),  # nor does any become less
        ([5], 4, [20]),
        ([], 4, []),
        ([0, 4], 3, [0, 12]),
    ],
)
def test_levels_of_a_finer_image_lie_between_those_that_are_known(levels, growth, finer):
    assert effort._shift_levels(np.array(levels, float), growth) == pytest.approx(finer)


@pytest.mark.parametrize(
    "step, growth, factor", [(2, 4, sqrt(8)), (2, 16, 8), (8, 4, 4), (0.5, 4, 2), (3, 2, 12**0.25)]
)
def test_pixels_have_more_pairs_between_as_many_more_as_they_had_than_the_last_tiles_and_four_times(
    step, growth, factor
):
    """Where these had no more, the mean of once and four times, for each time that the pixels are four times as many."""
    work = Work(1, 1, 1, (of_kind(kind_3=100),), of_kind(kind_3=step * 100 * 32**2), 0, (1, 0), 1, 1)
    assert work._cell_growth(growth) == pytest.approx(factor)


def test_without_any_level_pairs_grow_as_the_pixels():
    assert Work(1, 1, 1, (), of_kind(kind_3=100), 0, (1, 0), 1, 1)._cell_growth(3.0) == 3
    assert Work(1, 1, 1, (of_kind(kind_3=9),), of_kind(), 0, (1, 0), 1, 1)._cell_growth(3.0) == 3


def test_kinds_of_pairs():
    """By the tool, by whether it stays on its level, and by the view."""
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
    """Tiles in a row with so many trajectories each, of which none is in two."""
    first = np.append(0, np.cumsum(sizes))
    return Tiles(side, side * np.arange(len(sizes)), np.zeros(len(sizes), np.int64), first, np.arange(first[-1]))


def test_pairs_count_by_kind_as_often_as_their_tile_stands_for():
    kind = np.array([5, 7, 7])
    assert effort._count_pairs(tiles([2, 1]), np.array([10.0, 2.0]), kind).tolist() == list(of_kind(kind_5=10, kind_7=12))


def test_a_smaller_tile_is_in_the_one_around_it():
    large = Tiles(8, np.array([8, 0, 16]), np.array([0, 8, 8]), np.arange(4), np.arange(3))
    small = Tiles(4, np.array([12, 0, 20, 8, 4]), np.array([4, 12, 8, 0, 8]), np.arange(6), np.arange(5))
    assert effort._parents(large, small).tolist() == [0, 1, 2, 0, 1]


def test_of_few_pairs_all_are_taken():
    some, weight = tiles([10] * 10), np.full(10, 3.0)
    assert effort._draw_tiles(some, weight, np.ones(100), 100, np.random.default_rng(1)) == (some, weight)


def test_of_tiles_that_are_alike_so_many_are_drawn_as_have_the_pairs_and_stand_for_the_others():
    """20 of 100 with 10 pairs each, one of every five that follow each other, for 200 pairs."""
    drawn, weight = effort._draw_tiles(tiles([10] * 100), np.full(100, 3.0), np.ones(1000), 200, np.random.default_rng(1))
    assert weight == pytest.approx(np.full(20, 15.0)) and np.diff(drawn.first).tolist() == [10] * 20
    assert (drawn.column // 8 // 5).tolist() == list(range(20)) and drawn.side == 8 and not drawn.row.any()
    for tile, column in enumerate(drawn.column // 8):
        assert drawn.item[drawn.first[tile] : drawn.first[tile + 1]].tolist() == list(
            range(10 * column, 10 * column + 10)
        )


def test_tiles_are_drawn_as_likely_as_they_take_long_and_their_cost_stays():
    """A tile whose pairs take as long as all others together is drawn, and stands for itself alone."""
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


def test_what_would_be_drawn_more_than_once_is_certain_and_leaves_the_others_their_chances():
    """Of 3 draws the first tile would have 3 * 8 / 12, the second of the other 2 draws 2 * 2 / 4, and the rest half a one."""
    assert effort._chances(np.array([8.0, 2, 1, 1]), 3) == pytest.approx([1, 1, 0.5, 0.5])


def test_tiles_whose_long_ones_take_little_are_all_taken():
    """Of those that take long 50 have 50 pairs: more than there are."""
    some, weight = tiles([100, 1, 1]), np.ones(3)
    cost = np.append(np.full(100, 1e-9), [1.0, 1.0])
    assert effort._draw_tiles(some, weight, cost, 50, np.random.default_rng(1)) == (some, weight)


@pytest.mark.long
def test_where_trajectories_crowd_enough_tiles_are_looked_at(monkeypatch):
    """Loops as of adaptive clearing, obliquely: thousands pass each of a few tiles, and one or two drawn were off by 1.7."""
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
def test_of_many_first_tiles_some_are_looked_at_and_stand_for_all(looked_at, count, monkeypatch):
    """Of 9 by 7 with two trajectories, one more than which counts: all, or 120 / 3 of them, and at least 24."""
    monkeypatch.setattr(effort, "_LOOKED_AT", looked_at)
    view = View((0, 0, -1), 9 * TILE - 20, 7 * TILE - 20)
    path = toolpath(np.array([(5, 5, 5), (35, 5, 5), (35, 25, 5)], float))
    removal = Removal(Cuts([Cut(path, FLAT)]), BOX, view.frame(BOX))
    found, weight, every = effort._draw_first_tiles(removal, np.random.default_rng(3))
    assert every == 63 and weight == pytest.approx(np.full(count, 63 / count))
    number = found.row // TILE * 9 + found.column // TILE  # one of each so many that follow each other
    assert ((np.arange(count) * 63 // count <= number) & (number <= (np.arange(count) + 1) * 63 / count)).all()
    assert not (found.column % TILE).any() and not (found.row % TILE).any() and found.side == TILE


# The speed of this computer


@pytest.mark.parametrize(
    "name, count, seconds",
    [
        ("trajectory", 1e6, 0.4),
        ("pixel", 1e6, 0.07),
        ("meeting", 1e9, 5.5),
        ("block", 1e3, 0.41),
        ("test", 1e6, 0.6),
        ("cell", 1e6, 1.5),
        ("record", 1e6, 0.037),
    ],
)
def test_a_usual_time_is_what_so_many_took(name, count, seconds):
    """Written down a second time, in other units: a slip of a digit is seen, a new measurement of the same is none."""
    assert getattr(Speed(), name) * count == pytest.approx(seconds, rel=0.3)


def test_where_this_computer_was_measured_times_are_right_within_two_and_elsewhere_within_three():
    measured = fit_speed(np.eye(7), Speed().constants)
    assert (measured.factor, Speed().factor) == (2, 3) and measured.constants == pytest.approx(Speed().constants)
    assert measured.processes == Speed().processes == 1


def test_one_time_tells_that_all_takes_as_many_times_longer():
    amounts = np.array([[5, 2e4, 300, 7, 1e4, 1e5, 2e3]])
    seconds = 3 * amounts @ Speed().constants
    assert fit_speed(amounts, seconds).constants == pytest.approx(3 * Speed().constants)


def test_times_that_disagree_are_met_as_far_as_the_usual_proportions_allow():
    """One unit's worth of two kinds of work alone, of a usual second each, took 1 s and 4 s: 2.5 s in the middle.

    The shares s of 2.5 times the usual constant make (2.5 s - 1)^2 + (s - 1)^2 / 4 least, and (2.5 s / 4 - 1)^2 + (s - 1)^2 / 4.
    """
    usual = Speed().constants
    amounts = np.eye(7)[[2, 5]] / usual
    found = fit_speed(amounts, np.array([1.0, 4.0])).constants / usual
    expected = np.full(7, 2.5)
    expected[2] *= (2.5 + 0.25) / (2.5**2 + 0.25)
    expected[5] *= (0.625 + 0.25) / (0.625**2 + 0.25)
    assert found == pytest.approx(expected)


def test_no_constant_becomes_less_than_a_tenth_of_the_usual():
    """A second and a thousand: 500.5 in the middle."""
    usual = Speed().constants
    found = fit_speed(np.eye(7)[[2, 5]] / usual, np.array([1.0, 1000.0])).constants / usual
    assert found[2] == pytest.approx(50.05) and found[0] == pytest.approx(500.5)


def test_the_paths_that_are_timed_go_over_all_of_the_block():
    """Of 60 by 60 by 20 mm: rows to and fro 8 mm from its sides, circles around its middle, and rows over waves."""
    rows = _rows(12).points
    assert np.diff(rows[:, :2], axis=0)[:4].tolist() == [[44, 0], [0, 4], [-44, 0], [0, 4]]
    assert rows[:, :2].min(axis=0).tolist() == [8, 8] and rows[:, :2].max(axis=0).tolist() == [52, 52]
    assert np.ptp(rows[:, 2]) == 0 and 0 < rows[0, 2] < 20
    loops = _loops(3).points
    radius = np.hypot(loops[:, 0] - 30, loops[:, 1] - 30)
    around, count = np.unique(radius.round(6), return_counts=True)
    assert around.tolist() == [6, 14, 22] and count.tolist() == [73] * 3 and (np.diff(radius) < 1e-6).all()
    assert np.hypot(*np.diff(loops[:73, :2], axis=0).T) == pytest.approx(2 * 22 * np.sin(pi / 72))
    surface = _surface(4).points
    assert surface.min(axis=0)[:2].tolist() == [0, 0] and surface.max(axis=0)[:2].tolist() == [60, 60]
    assert np.unique(surface[:, 1]).tolist() == [0, 20, 40, 60]
    rows_of_waves = np.diff(surface[:, 0].reshape(4, 31), axis=1)
    assert rows_of_waves == pytest.approx(np.outer((-1.0) ** np.arange(4), np.full(30, 2.0)))
    # Waves of 3 mm, 57 mm long: the first row rises from 13 mm to its crest after a quarter of that.
    assert (
        surface[0, 2] == 13 and surface[:31, 2].argmax() == 7 and surface[:31, 2].max() == pytest.approx(16, abs=0.01)
    )
    assert 9 < surface[:, 2].min() < 11 and surface[:, 2].max() < 16
    for made in (_rows(12), _loops(3), _surface(4)):
        assert not made.rapid.any() and len(made) == len(made.points) - 1 == made.commands


@pytest.mark.parametrize("rise", [0.0, 1.0])
def test_rays_pass_a_long_sweep_of_a_bull_nose_between_its_ends_and_a_short_one_at_an_end(rise):
    """There it takes three times as long; of a flat end's, and from above, it does not matter."""
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
