# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tiles of an image, the trajectories that may cut a tile, and the trajectories that can cut deeper than before."""

from __future__ import annotations

import numpy as np
import pytest
from zbuffer_inputs import BOX, toolpath

from vkworkbench.core import Cut, Tool, View
from vkworkbench.core.zbuffer.culling.tiles import (
    TILE,
    Region,
    Tiles,
    are_small,
    deeper_pairs,
    first_tiles,
    quartered,
    small_tiles,
)
from vkworkbench.core.zbuffer.culling.upright import Upright
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts
from vkworkbench.core.zbuffer.sweeps.trajectories import Trajectories

# Three tiles with two, none and three trajectories.
SOME = Tiles(8, np.array([0, 8, 16]), np.array([24, 32, 40]), np.array([0, 2, 2, 5]), np.array([3, 5, 1, 3, 4]))


def told(tiles):
    """Return the first pixel of each tile, and its trajectories."""
    assert len(tiles.first) == len(tiles.column) + 1 and tiles.first[0] == 0 and tiles.first[-1] == len(tiles.item)
    lists = [tiles.item[a:b].tolist() for a, b in zip(tiles.first, tiles.first[1:])]
    return list(zip(tiles.column.tolist(), tiles.row.tolist(), lists))


FIRST, EMPTY, LAST = (0, 24, [3, 5]), (8, 32, []), (16, 40, [1, 3, 4])


def test_selected_tiles_of_an_image_keep_their_trajectories():
    assert told(SOME) == [FIRST, EMPTY, LAST]
    assert told(SOME.selected(np.array([True, False, True]))) == [FIRST, LAST]
    assert told(SOME.selected(np.array([False, True, False]))) == [EMPTY]
    assert told(SOME.selected(np.array([False, False, False]))) == []
    assert SOME.selected(np.ones(3, bool)) is SOME
    assert told(SOME.part(0, 1)) == [FIRST] and told(SOME.part(1, 3)) == [EMPTY, LAST]
    assert SOME.part(1, 3).side == SOME.selected(np.array([True, False, True])).side == 8


@pytest.mark.parametrize(
    "pairs, blocks",
    [
        (1, [[FIRST], [EMPTY], [LAST]]),
        (2, [[FIRST, EMPTY], [LAST]]),
        (4, [[FIRST, EMPTY], [LAST]]),
        (5, [[FIRST, EMPTY, LAST]]),
    ],
)
def test_batches_have_whole_tiles_and_limited_trajectory_counts(pairs, blocks):
    assert [told(block) for block in SOME.blocks(pairs)] == blocks


def test_tiles_return_their_pixel_columns_and_rows():
    column, row = SOME.pixels()
    assert column.shape == row.shape == (8, 3)
    assert column[:, 1].tolist() == list(range(8, 16)) and row[:, 2].tolist() == list(range(40, 48))


@pytest.mark.parametrize("side, fine", [(8, [False, False, False]), (2, [True, True, True]), (4, [False, False, True])])
def test_tiles_of_four_pixels_are_not_divided_for_sloped_moves(side, fine):
    """A tile with a side of four pixels is small enough if more than half of its moves are sloped.

    In the first tile, one of two moves is sloped. In the last tile, two of three moves are sloped.
    """
    sloped = np.isin(np.arange(6), [3, 4])
    tiles = Tiles(side, SOME.column, SOME.row, SOME.first, SOME.item)
    assert are_small(tiles, sloped).tolist() == fine
    assert are_small(tiles, np.isin(np.arange(6), [3, 5])).tolist() == ([True, False, False] if side == 4 else fine)


def reached(*tiles, near=-5.0, far=5.0):
    """Return the pairs of a tile and a trajectory that are not culled.

    Each tile is a list of one (reached depth, opened depth) per trajectory: the largest depth that the trajectory cuts
    somewhere in the tile, and the depth down to which it cuts the whole tile.
    """
    tile = np.repeat(np.arange(len(tiles)), [len(own) for own in tiles])
    start = np.searchsorted(tile, np.arange(len(tiles)))
    reach, opens = (np.array([pair[k] for own in tiles for pair in own], float) for k in (0, 1))
    return deeper_pairs(tile, start, reach, opens, near, far).tolist()


NO = -np.inf


@pytest.mark.parametrize(
    "pairs, stay",
    [
        ([(1, 0), (2, 0)], [0, 1]),
        ([(1, 1), (1, 1)], [0]),
        ([(1, 0), (0.5, NO)], [0, 1]),
        ([(1, 0), (-0.5, NO), (0, NO), (0.1, NO)], [0, 3]),
        # Later trajectories are compared with the depth 2, down to which the whole tile is already cut.
        ([(3, 2), (4, 1), (1.5, NO), (2.5, NO)], [0, 1, 3]),
        ([(-5, NO), (-4, NO)], [1]),  # A depth above the start of the rays counts as not reached.
        ([(9, 9), (20, 9)], [0]),  # Below the rays, no material is left.
        ([(1, 0), (1e-9, NO), (1e-7, NO)], [0, 2]),  # A depth that differs only by rounding is not deeper.
    ],
)
def test_trajectory_shallower_than_opened_tile_depth_is_culled(pairs, stay):
    assert reached(pairs) == stay


def test_depth_opened_in_one_tile_does_not_cull_in_another_tile():
    assert reached([(4, 4), (3, NO)], [(-4, -4), (-4.5, NO)], [(-4, NO)]) == [0, 2, 4]
    # The whole first tile is cut to the bottom of the stock, and the second tile is not cut.
    assert reached([(5, 5)], [(-4.9, NO), (-4.5, NO)]) == [0, 1, 2]


FLAT = Tool("endmill", 6)


def of_slots(*heights, width=400, height=300):
    """Slots along X through the middle of the block, seen from above in pixels of 0.1 mm."""
    points = [(x, 15.0, z) for z in heights for x in (-10.0, 50.0)]
    cuts = Cuts([Cut(toolpath(np.array(points)), FLAT)])
    return Trajectories(cuts, BOX, View((0, 0, -1), width, height).frame(BOX))


def test_largest_tiles_list_the_trajectories_that_pass_them():
    """The slot is 6 mm wide, from row 120 to row 180, so it passes the tiles with rows 64 to 127 and 128 to 191."""
    trajectories = of_slots(6.0)
    left, bottom = np.meshgrid(np.arange(0, 400, TILE), np.arange(0, 300, TILE))
    tiles = first_tiles(trajectories, TILE, left.ravel(), bottom.ravel())
    assert tiles.side == TILE
    assert {row for _, row, items in told(tiles) if items} == {64, 128}
    assert all((items == [0]) == (row in (64, 128)) for _, row, items in told(tiles))


@pytest.mark.parametrize("along_x", [True, False])
def test_slot_that_ends_before_a_pixel_centre_is_not_in_its_tile(along_x):
    """The slot is cut from 6.4 mm to 12.4 mm. Pixel 63 has its centre at 6.35 mm, and pixel 128 at 12.85 mm."""
    ends = [(-10, 9.4, 6), (50, 9.4, 6)] if along_x else [(9.4, -10, 6), (9.4, 50, 6)]
    trajectories = Trajectories(Cuts([Cut(toolpath(np.array(ends, float)), FLAT)]), BOX, of_slots(6.0).frame)
    first, other = np.array([0, 64, 128]), np.full(3, 128)
    tiles = first_tiles(trajectories, TILE, *((other, first) if along_x else (first, other)))
    assert [items for *_, items in told(tiles)] == [[], [0], []]


@pytest.mark.parametrize("along_x", [True, False])
def test_tile_extends_from_first_to_last_pixel_centre(along_x):
    """A slot from 6.3 mm to 12.81 mm passes pixel 63 (centre 6.35 mm) and nearly reaches pixel 128 (centre 12.85 mm)."""
    tool, y = Tool("endmill", 6.51), 9.555
    ends = [(-10, y, 6), (50, y, 6)] if along_x else [(y, -10, 6), (y, 50, 6)]
    trajectories = Trajectories(Cuts([Cut(toolpath(np.array(ends, float)), tool)]), BOX, of_slots(6.0).frame)
    first, other = np.array([0, 64, 128]), np.full(3, 128)
    tiles = first_tiles(trajectories, TILE, *((other, first) if along_x else (first, other)))
    assert [items for *_, items in told(tiles)] == [[0], [0], []]


def test_small_tiles_cover_a_sloped_and_a_level_slot():
    """A level slot lies 3 mm from the left edge, and a sloped slot 3 mm from the right edge.

    The tiles of the level slot and of the sloped slot are divided down to different sizes.
    """
    level, sloped = [(3, -10, 6), (3, 40, 6)], [(37, -10, 3), (37, 40, 9)]
    points = np.array([*level, (37, 40, 20), (37, -10, 20), *sloped], float)
    trajectories = Trajectories(Cuts([Cut(toolpath(points), FLAT)]), BOX, of_slots(6.0).frame)
    cut = np.zeros((300, 400), bool)
    for tiles, _ in small_tiles(trajectories, Upright(trajectories), Region(0, 400, 128, 192)):
        column, row = tiles.pixels()
        cut[np.minimum(row[:, None], 299), np.minimum(column[None], 399)] = True
    assert cut[128:192, :60].all() and cut[128:192, 340:].all() and not cut[:, 64:336].any()


@pytest.mark.parametrize("slots", [1, 20])
def test_each_trajectory_is_tested_once_per_tile_of_every_size(slots):
    """Each slot is deeper than the slot before, and covers 64 x 64 pixels. The 20 slots need more tests than one batch has.

    Each slot is tested with the four quarters of 1, 4, 16, 64 and 256 tiles, and then with 64 by 64 pixels.
    """
    heights = 9.5 - 0.4 * np.arange(slots)
    points = [(x, 15.0, z) for k, z in enumerate(heights) for x in ((-30.0, 70.0) if k % 2 == 0 else (70.0, -30.0))]
    cuts = Cuts([Cut(toolpath(np.array(points)), Tool("endmill", 30))])
    trajectories = Trajectories(cuts, BOX, of_slots(6.0).frame)
    found = list(small_tiles(trajectories, Upright(trajectories), Region(128, 192, 128, 192)))
    assert len(found) == (1 if slots == 1 else 2)
    assert sum(tested for _, tested in found) == slots * (4 * (1 + 4 + 16 + 64 + 256) + 64 * 64)
    assert sum(len(tiles.item) * tiles.side**2 for tiles, _ in found) == slots * 64 * 64


def test_uncut_or_invisible_quarters_of_tiles_are_dropped():
    """The last tile of a row begins at column 384, and 16 of its 64 columns are in the image."""
    trajectories = of_slots(6.0)
    tiles = first_tiles(trajectories, TILE, np.array([320, 384]), np.array([64, 64]))
    found = quartered(trajectories, Upright(trajectories), tiles)
    assert found.side == 32
    # No trajectory cuts below row 96 of the pixels.
    assert sorted(told(found)) == [(320, 96, [0]), (352, 96, [0]), (384, 96, [0])]


@pytest.mark.long
@pytest.mark.parametrize("heights, cut", [((6.0, 8.0), [0]), ((8.0, 6.0), [0, 2])])
def test_trajectory_above_an_already_cut_slot_is_culled(heights, cut):
    """Trajectories 0 and 2 are slots, and trajectory 1 is the link.

    The second slot removes material only if it is deeper than the first slot.
    """
    trajectories = of_slots(*heights)
    found, tested = [], 0
    for tiles, own in small_tiles(trajectories, Upright(trajectories), Region(0, 400, 128, 192)):
        found += told(tiles)
        tested += own
    inside = {item for column, row, items in found if 64 < column < 320 and row < 170 for item in items}
    assert inside == set(cut) or inside == {*cut, 1}
    assert len(found) == len({(column, row) for column, row, _ in found}) and tested > len(found)
    assert all(row < 184 for _, row, _ in found)
