# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facts from the traces, for cuts with known volumes and for intentional faults."""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, sin, sqrt
from types import SimpleNamespace

import numpy as np
import pytest
from zbuffer_inputs import DIRECTIONS, facts, helix, toolpath

from vkworkbench.core import Cut, Stock, Tool, View, linearize
from vkworkbench.core.zbuffer import (
    crashes,
    cuts_air,
    engagement,
    fast_plunges,
    removal_rates,
    removed_volumes,
    simulate,
    simulate_job,
    trajectory_table,
)
from vkworkbench.core.zbuffer.findings.faults import _displaced_volume
from vkworkbench.core.zbuffer.rays import records
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts

FLAT = Tool("endmill", 6)
STOCK = Stock((0, 0, 0), (40, 30, 10))
VIEW = View((1, 1, -1), 120, 90)


def cut(points, rapid=(), direction=(0, 0, -1), width=480, height=360):
    path = toolpath(np.array(points, float))
    fast = np.zeros(len(path), bool)
    fast[list(rapid)] = True
    path = replace(path, rapid=fast, feed=np.where(fast, 0.0, 10.0))
    return simulate(path, tool=FLAT, stock=STOCK, view=View(direction, width, height))


@pytest.mark.long
@pytest.mark.parametrize("direction", DIRECTIONS)
def test_each_trajectory_removes_its_own_volume(direction):
    z = cut([(10, 15, 12), (10, 15, 6), (30, 15, 6), (10, 15, 6), (10, 15, 4)], direction=direction)
    volumes = removed_volumes(z)
    assert volumes == pytest.approx([9 * pi * 4, 20 * 6 * 4, 0, 9 * pi * 2], rel=0.03, abs=0.1)
    assert volumes.sum() == pytest.approx(z.chip_volume)


def test_removed_volumes_sum_to_the_chips():
    z = simulate(toolpath(helix(None, 300)), tool=FLAT, stock=STOCK, view=View((1, 1, -1), 200, 150))
    assert removed_volumes(z).sum() == pytest.approx(z.chip_volume)
    assert removed_volumes(z.at(5)) == pytest.approx(removed_volumes(z))


def test_removal_rates_follow_the_feed():
    z = cut([(10, 15, 6), (30, 15, 6), (30, 25, 12)], rapid=[1])
    rates = removal_rates(z)
    assert rates[0] == pytest.approx(60 * removed_volumes(z)[0] / 2)
    assert np.isnan(rates[1])


def test_air_share_counts_moves_without_removal():
    z = cut([(10, 15, 6), (30, 15, 6), (10, 15, 6), (10, 15, 40), (10, 20, 40)], rapid=[2])
    assert facts(z).job.air_length_share == pytest.approx(25 / 45)
    nothing = cut([(10, 15, 20)])
    assert facts(nothing).job.air_length_share == 0


@pytest.mark.long
@pytest.mark.parametrize("direction", DIRECTIONS)
def test_a_rapid_through_the_stock_is_found(direction):
    sound = [(10, 15, 12), (10, 15, 6), (20, 15, 6), (20, 15, 12)]
    z = cut(sound, rapid=[2], direction=direction)
    assert crashes(z) == []
    z = cut([*sound, (30, 15, 12), (30, 15, 7), (30, 25, 7)], rapid=[2, 3, 4, 5], direction=direction)
    found = crashes(z)
    assert [c.trajectory for c in found] == [4, 5]
    assert [c.source.command for c in found] == [4, 5]
    assert found[0].volume == pytest.approx(9 * pi * 3, rel=0.03)
    x, y, height = found[0].place
    assert np.hypot(x - 30, y - 15) < 3.1 and 7 <= height <= 10
    if direction == (0, 0, -1):
        assert found[0].depth == pytest.approx(3)


def test_facts_of_the_simulation_do_not_depend_on_batch_size(monkeypatch):
    path = toolpath(helix(None, 300))
    path = replace(path, rapid=np.arange(len(path)) % 7 == 0)

    def found():
        z = simulate(path, tool=FLAT, stock=STOCK, view=VIEW)
        moments = [z.at(step).picture for step in (300, 120, 0, 299)]
        return (removed_volumes(z), *engagement(z), [c.place for c in crashes(z)],
                *(part for p in moments for part in (p.depth, p.owner)))  # fmt: skip

    whole = found()
    monkeypatch.setattr(records, "_BLOCK", 1)
    z = simulate(path, tool=FLAT, stock=STOCK, view=VIEW)
    assert len(list(z.records.blocks())) > 100
    for one, other in zip(whole, found()):
        np.testing.assert_allclose(one, other, rtol=1e-12)


@pytest.mark.parametrize(
    "lengths, rapid, removed, air",
    [
        # A move belongs to the stretch of 2 mm that contains its middle. The middles are at 0.5, 1.25 and 1.75 mm in
        # the first stretch, and at 2.5 and 3.5 mm in the second.
        ([1, 0.5, 0.5, 1, 1], [], [0], [3, 4]),
        ([1, 0.5, 0.5, 1, 1], [], [2], [3, 4]),
        ([1, 0.5, 0.5, 1, 1], [], [4], [0, 1, 2]),
        # The middles of the moves are at 0.25 and 1.9 mm in the first stretch, and at 3.4 mm in the second.
        ([0.5, 2.8, 0.2], [], [0], [2]),
        ([1, 1, 1], [0], [1], []),  # A rapid adds no length to a stretch.
        ([0.1, 0.1, 0.1, 0.1], [1], [0], [2, 3]),  # A rapid begins a new stretch.
        # The volume that a rapid removes is not added to the stretches before and after the rapid.
        ([0.1, 0.1, 0.1, 0.1], [1], [1], [0, 2, 3]),
    ],
)
def test_short_moves_are_air_together_with_their_neighbours(lengths, rapid, removed, air):
    """The pixels have a side of 1 mm."""
    points = np.zeros((len(lengths) + 1, 3))
    points[1:, 0] = np.cumsum(lengths)
    fast = np.isin(np.arange(len(lengths)), rapid)
    path = replace(toolpath(points), rapid=fast)
    traced = SimpleNamespace(lengths=np.isin(np.arange(len(lengths)), removed) * 0.25)
    z = SimpleNamespace(cuts=Cuts([Cut(path, FLAT)]), records=traced, frame=SimpleNamespace(pixel=1.0))
    assert np.flatnonzero(cuts_air(z)).tolist() == air
    # Each operation begins a new stretch of moves.
    two = SimpleNamespace(cuts=Cuts([Cut(path, FLAT)] * 2), frame=z.frame,
                          records=SimpleNamespace(lengths=np.append(traced.lengths, 0 * traced.lengths)))  # fmt: skip
    told = np.flatnonzero(cuts_air(two))
    assert told[told < len(lengths)].tolist() == air
    assert len(told) == len(air) + len(lengths) - len(rapid)


def test_removal_rate_of_a_cut_below_a_second_is_exact():
    z = cut([(10, 15, 6), (12, 15, 6)])
    assert removal_rates(z) == pytest.approx(60 * removed_volumes(z) / 0.2)


def test_depth_and_width_of_cut_from_above_are_measured():
    """A plunge has the width 0, a slot the tool's diameter, and a half slot the width of the material that was left."""
    points = [(10, 15, 12), (10, 15, 7), (30, 15, 7), (30, 18, 7), (10, 18, 7), (10, 18, 20), (12, 18, 20)]
    depth, width = engagement(cut(points, direction=(0, 0, -1)))
    assert depth == pytest.approx([3, 3, 3, 3, 0, 0], abs=1e-5)
    assert width[[0, 4, 5]].tolist() == [0, 0, 0] and width[1] == pytest.approx(6, rel=0.02) and width[1] <= 6
    # The half slot ends with half a disc, without the parts that the slot and the preceding quarter disc removed.
    taken = 3 * pi - 0.75 * sqrt(27)
    assert width[3] == pytest.approx(3 + (9 * pi / 2 - taken - 9 * pi / 4) / 20, rel=0.002)
    aside = engagement(cut(points, direction=(1, 0.1, -0.2)))
    # Views from the side give no depth and no width of cut.
    assert [values.tolist() for values in aside] == [[0] * 6] * 2


def test_width_of_a_shallow_short_cut_is_limited_to_the_tool():
    """The move is 0.5 mm long and 0.5 mm deep, in a stock of 2 x 2 mm."""
    path = toolpath(np.array([(1, 0.5, 1.5), (1, 1, 1.5)], float))
    z = simulate(path, tool=Tool("endmill", 1), stock=Stock((0, 0, 0), (2, 2, 2)), view=View(width=200, height=200))
    ((depth,), (width,)) = engagement(z)
    # Computed from the volume, which includes the round ends, the width would be more than 1 mm.
    assert depth == pytest.approx(0.5) and width == 1


def test_trajectory_table_has_a_row_for_each_trajectory():
    slow, other = Tool("endmill", 6), Tool("endmill", 4)
    first = replace(toolpath(np.array([(10, 10, 6), (30, 10, 6), (30, 10, 20)], float)), command=np.array([3, 7]))
    second = toolpath(np.array([(10, 20, 8), (30, 20, 8)], float))
    first = replace(first, rapid=np.array([False, True]), feed=np.array([10.0, 0.0]))
    z = simulate_job([Cut(first, slow), Cut(second, other)], stock=STOCK, view=View())
    table = trajectory_table(z)
    assert {name: table[name].tolist() for name in ("cut", "command", "rapid", "length", "seconds", "air")} == {
        "cut": [0, 0, 1], "command": [3, 7, 0], "rapid": [False, True, False], "length": [20, 14, 20],
        "seconds": [2, 0, 2], "air": [False, False, False],
    }  # fmt: skip
    assert table["tool_diameter"].tolist() == [6, 6, 4] and table["depth"] == pytest.approx([4, 0, 2], abs=1e-5)
    assert table["removed_volume"] == pytest.approx([4 * (120 + 9 * pi), 0, 2 * (80 + 4 * pi)], rel=0.02)
    assert table["rate"][[0, 2]] == pytest.approx(30 * table["removed_volume"][[0, 2]]) and np.isnan(table["rate"][1])
    assert table["width"].tolist() == [6, 0, 4]


def test_place_of_a_crash_is_its_deepest_place():
    """A rapid cuts 5 mm deep through a block, after half of the block was cut down by 2 mm."""
    rows = [(x, y, 8) for k, y in enumerate(range(0, 31, 5)) for x in ((-5, 17) if k % 2 == 0 else (17, -5))]
    points = [*rows, (rows[-1][0], 30, 20), (-5, 15, 20), (-5, 15, 5), (45, 15, 5)]
    (crash,) = crashes(cut(points, rapid=[len(points) - 2]))
    assert crash.depth == pytest.approx(5) and crash.place[0] > 20 and crash.place[2] == pytest.approx(7.5)


@pytest.mark.parametrize("tool", [FLAT, Tool("bullnose", 6, corner_radius=1)], ids=str)
def test_rapid_down_into_round_slot_may_cut_the_chord_error(tool):
    """Between two chord ends of the circle, the tool's side cuts up to 0.01 mm of the wall, which is not a crash."""
    circle = [
        ("G0", {"X": 10, "Y": 0, "Z": 5}),
        ("G1", {"Z": -2, "F": 10}),
        ("G3", {"I": -10, "J": 0}),
        ("G0", {"Z": 5}),
    ]
    x, y = 10 * cos(2.4), 10 * sin(2.4)
    stock, view = Stock((-15, -15, -5), (15, 15, 0)), View((0, 0, -1), 150, 150, pixel=0.025, offset=(1.3 * x, 1.3 * y))

    def crashed(x, y, z):
        path = linearize([*circle, ("G0", {"X": x, "Y": y}), ("G0", {"Z": z}), ("G0", {"Z": 5})])
        return [crash.trajectory for crash in crashes(simulate(path, tool=tool, stock=stock, view=view))]

    assert crashed(x, y, -1.9) == []
    down = len(linearize(circle)) + 1
    assert crashed(x, y, -2.005) == crashed(1.005 * x, 1.005 * y, -1.9) == [down]


GROOVING = {
    "ball": Tool("ballend", 6),
    "bull nose": Tool("bullnose", 6, corner_radius=2.9),
    "v": Tool("vbit", 6, tip_angle=pi / 3),
    "chamfer": Tool("vbit", 6, tip_angle=pi / 2, tip_diameter=0.5),
}


# Each tool and each view is tested with both tolerances of the chords.
@pytest.mark.long
@pytest.mark.parametrize(
    "name, direction, tolerance",
    [
        (name, direction, (0.01, 0.1)[(number + oblique) % 2])
        for number, name in enumerate(GROOVING)
        for oblique, direction in enumerate([(0, 0, -1), (1, 1, -1)])
    ],
)
def test_rapid_along_round_groove_is_not_a_crash(name, direction, tolerance):
    """The rapid starts between two chord ends of the circle, and cuts only the chord error of the arcs."""
    tool = GROOVING[name]

    def arc(radius, height, start, chords):
        x, y = radius * cos(start), radius * sin(start)
        down = [("G0", {"X": x, "Y": y}), ("G1", {"Z": height, "F": 10})]
        path = linearize([("G0", {"Z": 5}), *down, ("G3", {"I": -x, "J": -y})], tolerance=tolerance)
        return path.part(0, 2 + chords)

    groove, stock = arc(10, -2, 0.0, 4), Stock((-15, -15, -5), (15, 15, 0))
    place = np.array([10 * cos(0.2), 10 * sin(0.2), 1.5])  # The point is relative to the middle of the stock.
    axes = View(direction).frame(stock)
    view = View(direction, 200, 150, pixel=0.05, offset=(place @ axes.right, place @ axes.up))

    def crashes_along(radius, height):
        rapid = arc(radius, height, 0.05, 3)
        rapid = replace(rapid, rapid=np.ones(len(rapid), bool))
        return len(crashes(simulate_job([Cut(groove, tool), Cut(rapid, tool)], stock=stock, view=view)))

    assert crashes_along(10, -2) == 0
    aside = 4 * tolerance
    assert min(crashes_along(10 + aside, -2), crashes_along(10 - aside, -2), crashes_along(10, -2 - aside)) > 0


# Each tool and each view is tested with both tolerances of the chords.
@pytest.mark.long
@pytest.mark.parametrize("plane, axis, centre", [("G18", "X", "I"), ("G19", "Y", "J")])
@pytest.mark.parametrize(
    "tool, direction, tolerance",
    [
        (FLAT, (0, 0, -1), 0.01),
        (FLAT, (-1, 1, -1), 0.05),
        (Tool("ballend", 6), (0, 0, -1), 0.05),
        (Tool("ballend", 6), (-1, 1, -1), 0.01),
    ],
    ids=str,
)
def test_rapid_down_into_a_trough_may_cut_the_chord_error(tool, plane, axis, centre, direction, tolerance):
    """The rapid goes down to an arc in a vertical plane, at its lowest point or flank, between two chord ends."""
    arc = ("G2" if plane == "G18" else "G3", {axis: 9, "Z": 0, centre: 9, "K": 0})
    trough = [("G0", {axis: -9, "Z": 5}), ("G1", {"Z": 0, "F": 10}), (plane, {}), arc, ("G0", {"Z": 5})]
    down, stock = len(linearize(trough, tolerance=tolerance)) + 1, Stock((-15, -15, -15), (15, 15, 0))

    def crashed(angle, deeper):
        at = {axis: 9 * sin(angle)}, {"Z": -9 * cos(angle) - deeper}
        path = linearize([*trough, *(("G0", words) for words in (*at, {"Z": 5}))], tolerance=tolerance)
        return [
            one.trajectory for one in crashes(simulate(path, tool=tool, stock=stock, view=View(direction, 160, 160)))
        ]

    for angle in (0.0, 0.1, 1.1):
        assert crashed(angle, 0.0) == []
        assert crashed(angle, 0.5) == [down]
    assert crashed(0.0, 4 * tolerance) == [down]


def test_rapid_that_leaves_a_wall_downwards_is_a_crash():
    """The rapid shaves an allowed 0.018 mm off a wall 8 mm high, and ends 1 mm below the floor, in a crash."""
    slot = [(-5, 15, 20), (-5, 15, 2), (35, 15, 2), (5, 15, 2), (5, 15.018, 2), (34, 15.018, 1)]
    path = replace(toolpath(np.array(slot, float)), rapid=np.arange(5) == 4)
    view = View((0, 0, -1), 100, 100, pixel=0.01, offset=(14, 3))
    (crash,) = crashes(simulate(path, tool=FLAT, stock=STOCK, view=view))
    assert crash.depth == pytest.approx(1, abs=0.05)


def test_rapid_that_scratches_the_top_is_a_crash():
    (crash,) = crashes(cut([(-5, 15, 9.995), (45, 15, 9.995)], rapid=[0]))
    assert crash.depth == pytest.approx(0.005, abs=1e-5)


VIEW_OF_PLUNGES = View(width=400, height=300)


def plunges(points, feed=6.0, allowed=2.0, tool=FLAT, stock=STOCK, view=VIEW_OF_PLUNGES):
    path = toolpath(np.array(points, float))
    path = replace(path, feed=np.full(len(path), feed))
    return [one.trajectory for one in fast_plunges(simulate_job([Cut(path, tool, allowed)], stock=stock, view=view))]


def test_plunges_above_the_vertical_feed_are_found():
    down = [(20, 15, 12), (20, 15, 8)]
    assert plunges(down) == plunges(down, feed=2.03) == plunges(down, feed=0.6, allowed=0.5) == [0]
    # The feed exceeds the limit only by the rounding of feeds in FreeCAD.
    assert plunges(down, feed=2.01) == plunges(down, feed=1.0) == []
    assert plunges(down, allowed=0) == []  # A vertical feed of 0 means that the limit is unknown.
    assert plunges(down[::-1]) == []  # Moves up are not plunges.
    # A move with a slope of 6 in 1 is a plunge, and a move with a slope of 4 in 1 is a ramp.
    assert plunges([(20, 15, 12), (20.9, 15, 6.6)]) == [0] and plunges([(20, 15, 12), (21.5, 15, 6)]) == []
    # The first plunge has 61 % of the tool over the block, the second 39 %.
    assert plunges([(0.5, 15, 12), (0.5, 15, 7)]) == [0] and plunges([(-0.5, 15, 12), (-0.5, 15, 7)]) == []


def test_fast_plunges_of_small_tools_are_found():
    """The tool cuts 0.2 mm2, 1 mm deep."""
    small = {"tool": Tool("endmill", 0.5), "stock": Stock((0, 0, 0), (2, 2, 2)), "view": View(width=200, height=200)}
    assert plunges([(1, 1, 3), (1, 1, 1)], **small) == [0]


# Volumes up to 1, 2 and 5 mm above the tip, computed by hand.
VOLUMES = [
    (FLAT, [9 * pi, 18 * pi, 45 * pi]),
    (Tool("ballend", 6), [pi * (3 - 1 / 3), pi * 4 * (3 - 2 / 3), 18 * pi + 18 * pi]),
    (Tool("vbit", 6, tip_angle=pi / 2), [pi / 3, pi * 8 / 3, 9 * pi + 18 * pi]),
    (Tool("vbit", 6, tip_angle=pi / 2, tip_diameter=2), [pi * 7 / 3, pi * 26 / 3, pi * (26 / 3 + 27)]),
    (Tool("drill", 6, tip_angle=2 * pi / 3), [pi, 9 * pi * (2 - 2 / sqrt(3)), 9 * pi * (5 - 2 / sqrt(3))]),
    # The rounded corner is a quarter of a ring (Pappus).
    (Tool("bullnose", 6, 1), [4 * pi + 2 * pi * (2 + 4 / (3 * pi)) * pi / 4 + more for more in (0, 9 * pi, 36 * pi)]),
]  # fmt: skip
NAMES = ["flat", "ball", "v", "chamfer", "drill", "bull nose"]


@pytest.mark.parametrize("tool, volumes", VOLUMES, ids=NAMES)
def test_displaced_volume_of_each_tool_is_exact(tool, volumes):
    assert _displaced_volume(tool, np.array([0.0, 1.0, 2.0, 5.0])) == pytest.approx([0, *volumes], rel=2e-3)


@pytest.mark.long
@pytest.mark.parametrize("tool", [tool for tool, _ in VOLUMES], ids=NAMES)
@pytest.mark.parametrize("direction", [(0, 0, -1), (0, 0, 1), (0, 1, -1), (0, 1, 0)])
@pytest.mark.parametrize("depth", [1, 2, 5])
def test_fast_plunges_are_found_for_all_tools_and_depths(tool, direction, depth):
    """The tool plunges into full material, into its own hole, and where about half of its area is uncut."""
    block = {"stock": Stock((0, 0, 0), (10, 8, 10)), "view": View(direction, 100, 140, pixel=0.1)}
    bottom = 10 - depth
    assert plunges([(5, 4, 12), (5, 4, bottom)] * 2, tool=tool, **block) == [0]
    for aside, told in ((0.2, [0]), (-0.2, [])):
        assert plunges([(aside, 4, 12), (aside, 4, bottom)], tool=tool, **block) == told


def test_steep_plunge_beside_a_deep_hole_is_found():
    """From the bottom of a hole, a steep move also cuts a sliver of the wall that is far higher than the move."""
    hole = [(20, 15, 12), (20, 15, 2)]
    assert plunges([*hole, (20.15, 15, 1)]) == [0, 1]


def test_cone_plunging_beside_an_edge_is_not_in_full_material():
    """The cone is 3 mm below the top and 2 mm beside the edge, like at the start of a chamfer."""
    assert plunges([(-2, 15, 12), (-2, 15, 7)], tool=Tool("vbit", 6, tip_angle=pi / 2)) == []


def test_each_plunge_is_judged_by_its_own_tool():
    """An end mill has less than half of its area over the stock.

    A cone displaces a smaller volume, but the whole cone is over the stock.
    """
    points = np.array([(-0.4, 15, 12), (-0.4, 15, 7)], float)
    path = replace(toolpath(points), feed=np.full(1, 6.0))
    beside = replace(toolpath(points + (20, 0, 0)), feed=np.full(1, 6.0))
    cuts = [Cut(path, FLAT, 2.0), Cut(beside, Tool("vbit", 6), 2.0)]
    assert [one.source.cut for one in fast_plunges(simulate_job(cuts, stock=STOCK, view=View()))] == [1]
