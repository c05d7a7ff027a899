# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves that cut along the working plane, and the monotonous areas into which they are divided."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core import linearize
from vkworkbench.core.paper import monotonous_areas

FEED = 10.0
START = ("G0", {"X": 40.0, "Y": 30.0, "Z": 5.0})


def feed(*points):
    """Return moves at feed through points (x, y, z)."""
    return [("G1", {"X": 40.0 + x, "Y": 30.0 + y, "Z": z, "F": FEED}) for x, y, z in points]


def rapid(x, y, z):
    return ("G0", {"X": 40.0 + x, "Y": 30.0 + y, "Z": z})


def areas_of(*commands):
    return monotonous_areas(linearize([START, *commands]))


def sizes(areas):
    return np.diff(areas.start, append=len(areas)).tolist()


ROW = [(20, 0, -1), (20, 2, -1), (0, 2, -1)]


def test_area_ends_at_a_rapid():
    one = areas_of(*feed((0, 0, -1), *ROW, (0, 2, 5)), rapid(0, 4, 5), *feed((0, 4, -1), (20, 4, -1)))
    assert sizes(one) == [3, 1]
    assert one.index.tolist() == [1, 2, 3, 7]
    # A rapid at the cutting height also ends the area, because it cuts nothing.
    assert sizes(areas_of(*feed((0, 0, -1), *ROW), rapid(0, 4, -1), *feed((20, 4, -1)))) == [3, 1]


def test_area_ends_at_a_plunge_and_retract():
    assert sizes(areas_of(*feed((0, 0, -1), *ROW, (0, 2, -5), (0, 2, -1), (20, 2.5, -1), (20, 9, -1)))) == [3, 2]


def test_area_ends_at_another_depth_unless_path_is_straight():
    step, wall = feed((0, 0, -1), *ROW, (0, 2, -2), (0, 30, -2)), feed((0, 0, -1), *ROW, (0, 2, 3), (-20, 2, 3))
    assert sizes(areas_of(*step)) == [3, 1]
    assert sizes(areas_of(*wall)) == [4]  # The rows continue up a wall.
    assert sizes(areas_of(*feed((0, 0, -1), (20, 20, -1), (20, 20, 3), (40, 40, 3)))) == [2]
    assert sizes(areas_of(*feed((0, 0, -1), (20, 20, -1), (20, 20, 3), (40, 0, 3), (60, 0, 3)))) == [1, 2]


def test_first_plunge_is_not_an_area():
    areas = areas_of(*feed((0, 0, -1)))
    assert len(areas) == 0 and areas.holes.tolist() == [0]


@pytest.mark.parametrize("drop, cuts", [(0.0, 1), (-80.0, 1), (-120.0, 0)])
def test_slope_of_at_most_five_in_one_is_a_move_and_not_a_plunge(drop, cuts):
    # In the XY plane, the move is 20 mm long. A move with a descent of at most 100 mm is a slope, and not a plunge.
    assert len(areas_of(*feed((0, 0, 0), (12, 16, drop)))) == cuts


def test_sloped_plunge_between_level_cuts_is_left_out():
    areas = areas_of(*feed((0, 0, 0), *[(20, 0, 0), (20, 1, -6), (0, 1, -6)]))
    assert areas.index.tolist() == [1, 3]


def test_each_cut_begins_at_the_end_of_the_cut_before():
    # The first path contains moves that cut nothing, and the second path consists of cuts only.
    for path in (areas_of(*feed((0, 0, -1), *ROW)), monotonous_areas(linearize(feed((0, 0, -1), *ROW)))):
        assert path.x.tolist() == [40, 60, 60] and path.y.tolist() == [30, 30, 32] and path.z.tolist() == [-1] * 3
        assert (path.x + path.dx).tolist() == [60, 60, 40] and path.length.tolist() == [20, 2, 20]


@pytest.mark.parametrize("beside, kept", [(0.3, True), (20.0, False)])
def test_tiny_move_beside_a_long_move_is_left_out(beside, kept):
    areas = areas_of(*feed((0, 0, -1), (beside, 0, -1), (beside, 0.015, -1), (2 * beside, 0.015, -1)))
    assert len(areas) == 2 + kept
    last = areas_of(*feed((0, 0, -1), (0.3, 0, -1), (0.3, 0.015, -1), (0.3 + beside, 0.015, -1)))
    assert len(last) == 2 + kept


def test_neighbours_of_a_move_are_its_previous_and_next_move():
    short = feed((0, 0, -1), (0.3, 0, -1), (0.6, 0.1, -1))
    for steps in (
        [(20, 0.1, -1), (20, 0.115, -1), (20.1, 0.115, -1)],
        [(0.9, 0.1, -1), (0.9, 0.115, -1), (20, 0.115, -1)],
    ):
        assert len(areas_of(*short, *feed(*steps))) == 4
        assert len(areas_of(*short, *feed(*steps, (20.6, 0.3, -1)))) == 5


@pytest.mark.parametrize("width, kept", [(0.015, False), (0.03, True)])
def test_move_of_0_03_mm_between_long_moves_has_a_direction(width, kept):
    areas = areas_of(*feed((0, 0, -1), (20, 0, -1), (20, width, -1), (40, width, -1)))
    assert len(areas) == 2 + kept


@pytest.mark.parametrize("step, moves", [(0.0008, 0), (0.0015, 3)])
def test_move_shorter_than_a_thousandth_of_a_mm_is_ignored(step, moves):
    assert len(areas_of(*feed((0, 0, -1), (step, 0, -1), (step, step, -1), (0, step, -1)))) == moves


@pytest.mark.parametrize("aside, signed", [(0.1, False), (0.3, True)])
def test_turn_clearly_below_half_a_turn_has_a_sign(aside, signed):
    # The turn differs from half a turn by 0.005 or 0.015 rad.
    areas = areas_of(*feed((0, 0, -1), (20, 0, -1), (0, aside, -1)))
    assert (len(areas.unsigned) == 0) is signed and areas.reversals.tolist() == []
    assert areas.phi[-1] == pytest.approx((np.pi if signed else 0.0) - np.arctan2(aside, 20))


def link(x, y):
    """Return a link at feed: lift, straight move, and plunge."""
    return [(0, 2, 5), (x, y, 5), (x, y, -1)]


def test_links_in_the_air_at_feed_are_left_out():
    more = [(40, 20, -1), (60, 20, -1), (60, 4, -1)]
    areas = areas_of(*feed((0, 0, -1), *ROW, *link(40, 2), *more))
    assert sizes(areas) == [3, 3] and areas.index.tolist() == [1, 2, 3, 7, 8, 9]
    # The first and last horizontal moves at 5 mm are links, too, although each has only one plunge or lift beside it.
    areas = areas_of(*feed((-30, 0, 5), (-30, 0, -1), (-10, 0, -1), (-10, 5, -1), (-10, 5, 5), (20, 5, 5)))
    assert areas.index.tolist() == [2, 3]


def test_last_link_may_end_at_program_end_height():
    """If the last link were a cut, drilling at feed would have one cutting area and would look like a profile."""
    holes = [(x, 0, z) for x in (0, 20, 40) for z in (1, -2, 1)]
    drilled = areas_of(*feed(*holes, (-30, -20, 1), (-30, -20, 20), (-30, -20, 30)))
    assert len(drilled) == 0 and len(drilled.holes) == 3
    # A feed move before a rapid lift is not a link, and a feed move with a cut after it is not the last link.
    assert sizes(areas_of(*feed(*holes, (-30, -20, 1)), rapid(-30, -20, 20))) == [1]
    assert sizes(areas_of(*feed(*holes, (-30, -20, 1), (-30, -20, 20), (0, -20, -1)))) == [1, 1]


def test_raised_rows_between_a_lift_and_a_plunge_are_not_a_link():
    """The rows are on a terrace that the tool reaches by a lift at feed and leaves by a plunge.

    If Z grows downward, the rows look the same.
    """
    rows = [(x, y, 1) for y in range(2, 12, 2) for x in ((0, 20) if y % 4 else (20, 0))]
    assert sizes(areas_of(*feed((0, 0, -1), (0, 2, -1), *rows, (20, 10, -1), (20, 30, -1)))) == [1, 9, 1]
    # Successive moves along one line count as one link.
    straight = [(x, 2, 5) for x in range(0, 45, 5)]
    assert sizes(areas_of(*feed((0, 0, -1), (0, 2, -1), *straight, (40, 2, -1), (40, 30, -1)))) == [1, 1]


@pytest.mark.parametrize(("height", "air"), [(20, True), (19, False)])
def test_fast_feed_at_the_top_beside_a_rapid_is_a_link(height, air):
    """In Fusion's free version, posts write rapids as feeds. A feed below the top height may cut."""
    cut = feed((0, 0, -1), *ROW)
    above = [rapid(0, 2, 20), rapid(20, 2, 20), rapid(20, 2, height)][: 2 if air else 3]
    down = [rapid(40, 2, 5), *feed((40, 2, -1), (40, 20, -1))]
    assert sizes(areas_of(*cut, *above, *feed((40, 2, height)), *down)) == ([3, 1] if air else [3, 1, 1])
    up = [rapid(0, 2, height), *feed((20, 2, height)), rapid(40, 2, height), rapid(40, 2, 20)]
    assert sizes(areas_of(*cut, *up)) == ([3] if air else [3, 1])
    lifted = [*cut, *feed((0, 2, 20)), rapid(20, 2, 20), *feed((40, 2, 20))]
    if air:  # A move is a link, too, if the lift before it is at feed.
        assert sizes(areas_of(*lifted, *down)) == [3, 1]
        first = [rapid(0, 0, 20), *feed((20, 0, 20)), rapid(20, 0, -1), *feed((40, 0, -1))]
        assert sizes(areas_of(*first)) == [1]
    # A feed move at the top without a lift or plunge beside it counts as a cut, like a stroke of a plotter.
    flat = [rapid(0, 2, 20), rapid(20, 2, 20), *feed((40, 2, 20)), rapid(60, 2, 20), rapid(60, 2, 5)]
    assert sizes(areas_of(*cut, *flat)) == [3, 1]


def test_moves_around_corners_or_slopes_are_not_links():
    bent = [(0, 2, 5), (20, 20, 5), (40, 2, 5), (40, 2, -1)]
    assert sizes(areas_of(*feed((0, 0, -1), *ROW, *bent, (60, 2, -1)))) == [3, 2, 1]
    sloped = [(0, 2, 5), (40, 2, 8), (40, 2, -1)]
    assert sizes(areas_of(*feed((0, 0, -1), *ROW, *sloped, (60, 9, -1)))) == [3, 1, 1]
    low = [(0, 2, -3), (40, 2, -3), (40, 2, -1)]  # The tool moves down, along a groove, and up.
    assert sizes(areas_of(*feed((0, 0, -1), *ROW, *low, (40, 30, -1), (60, 30, -1)))) == [3, 1, 2]


def test_first_stroke_of_laser_without_lift_is_an_area():
    strokes = [("G1", {"X": 60.0, "F": FEED}), ("G0", {"X": 80.0}), ("G1", {"X": 90.0, "F": FEED}), ("G0", {"X": 0.0})]
    assert sizes(areas_of(*strokes)) == [1, 1]


def test_plateau_between_walls_is_cut_and_not_a_link():
    raster = [(0, 0, -1), (20, 0, -1), (20, 0, 4), (40, 0, 4), (40, 0, -1), (60, 0, -1)]
    assert sizes(areas_of(*feed(*raster))) == [3]
    turned = [(0, 0, -1), (20, 0, -1), (20, 0, 4), (20, 20, 4), (20, 20, -1), (40, 20, -1)]
    assert sizes(areas_of(*feed(*turned))) == [1, 1]  # The raised move is a link, because it does not continue a pass.
    aslant = [(0, 0, -1), (20, 0, -1), (20, 0, 4), (40, 20, 4), (40, 20, -1), (60, 20, -1)]
    assert sizes(areas_of(*feed(*aslant))) == [1, 1]
    lifted = [*feed((0, 0, -1), (20, 0, -1)), rapid(20, 0, 4), *feed((40, 0, 4)), rapid(40, 0, -1), *feed((60, 0, -1))]
    # A raised move is a cut if it continues the direction of the pass before it or of the pass after it.
    into = [*feed((0, 0, -1), (0, 20, -1), (0, 20, 4), (20, 20, 4)), rapid(20, 20, -1), *feed((40, 20, -1))]
    assert sizes(areas_of(*into)) == [1, 1, 1]
    out = [*feed((0, 0, -1), (20, 0, -1)), rapid(20, 0, 4), *feed((40, 0, 4), (40, 0, -1), (40, 20, -1))]
    assert sizes(areas_of(*out)) == [1, 1, 1]
    before = [rapid(0, 40, 5), *feed((0, 40, -1), (0, 60, -1), (20, 60, -1)), rapid(20, 60, 5), rapid(0, 0, 5)]
    assert sizes(areas_of(*before, *lifted)) == [2, 1, 1, 1]
    # Between two rapids at the top, a feed move in any direction is a link, because a post-processor wrote a rapid as a
    # feed.
    linked = [*feed((0, 0, -1), (20, 0, -1)), rapid(20, 0, 9), *feed((40, 0, 9)), rapid(40, 0, -1), *feed((60, 0, -1))]
    assert sizes(areas_of(*linked)) == [1, 1]


def test_plunge_without_milling_at_its_place_is_a_hole():
    peck = [*feed((0, 0, -3)), rapid(0, 0, 1), rapid(0, 0, -3), *feed((0, 0, -6)), rapid(0, 0, 5)]
    assert areas_of(*peck).holes.tolist() == [3]  # Several pecks in one hole are one hole.
    second = [
        rapid(10, 0, 5),
        *feed((10, 0, -6)),
        rapid(10, 0, 5),
        rapid(10, 8, 5),
        *feed((10, 8, -6)),
        rapid(10, 8, 5),
    ]
    assert areas_of(*peck, *second).holes.tolist() == [3, 6, 9]
    pecks = [rapid(10, 0, 5), *feed((10, 0, -3)), rapid(10, 0, 1), *feed((10, 0, -6)), rapid(10, 0, 5)]
    assert areas_of(*peck, *pecks).holes.tolist() == [3, 8]
    milled = [rapid(10, 0, 5), *feed((10, 0, -6), (30, 0, -6)), rapid(30, 0, 5)]
    assert areas_of(*peck, *milled).holes.tolist() == [3]


def test_plunge_without_drilling_is_not_a_hole():
    down = [rapid(10, 0, 5), rapid(10, 0, 0), rapid(10, 0, 5)]  # The tool goes down and up at rapid.
    up = [rapid(10, 0, -6), *feed((10, 0, 5))]  # The tool leaves a hole at feed, like in boring cycles.
    still = [rapid(10, 0, 5), *feed((10, 0, 4.9995)), rapid(20, 0, 5)]  # The plunge is less than a thousandth of a mm.
    aside = [rapid(10, 0, 5), *feed((11, 0, -6)), rapid(11, 0, 5)]
    for moves in (down, up, still, aside):
        assert areas_of(*moves).holes.tolist() == []


def test_areas_of_a_part_keep_the_programs_trajectory_numbers():
    hole = [rapid(60, 0, 5), *feed((60, 0, -6)), rapid(60, 0, 5)]
    path = linearize([START, *feed((0, 0, -1), *ROW, (0, 9, -1), (0, 9, 5)), *hole])
    behind = monotonous_areas(path, first=2)
    assert behind.index.tolist() == [2, 3, 4] and behind.holes.tolist() == [7]
    assert monotonous_areas(path, first=2, last=3).index.tolist() == [2, 3]
