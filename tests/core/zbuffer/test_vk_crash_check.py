# SPDX-License-Identifier: LGPL-2.1-or-later
"""Crash checks of rapids and fast plunges use rays fine enough for each tool, for a stock of any size."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from zbuffer_inputs import toolpath

from vkworkbench.core import Cut, Cylinder, Stock, Tool, View, linearize
from vkworkbench.core.zbuffer import axis_view, check_crashes, crashes, simulate_job

BLOCK, PLATE = Stock((0, 0, 0), (100, 80, 20)), Stock((0, 0, 0), (600, 400, 20))
FLAT = Tool("endmill", 6)


def path(points, rapid=(), feed=10.0):
    moves = toolpath(np.array(points, float))
    fast = np.isin(np.arange(len(moves)), rapid)
    return replace(moves, rapid=fast, feed=np.where(fast, 0.0, feed))


def plunges(places, depth=3.0, kind="rapid", feed=10.0):
    """Vertical moves into the plate, 3 mm deep, and retracts."""
    points = [point for x, y in places for point in ((x, y, 25), (x, y, 20 - depth), (x, y, 25))]
    moves = len(points) - 1
    down = list(range(0, moves, 3))
    return path(points, [k for k in range(moves) if kind == "rapid" or k not in down], feed)


TWELVE = [(60.1 + 37.3 * k, 150.0) for k in range(12)]


@pytest.mark.parametrize("diameter", [0.1, 0.5, 20])
def test_rapid_plunges_of_every_tool_are_crashes(diameter):
    found = check_crashes([Cut(plunges(TWELVE), Tool("endmill", diameter))], PLATE)
    assert [crash.source.command for crash in found.crashes] == list(range(0, 36, 3)) and found.unchecked == ()
    assert found.pixel <= diameter / 8
    assert [crash.volume for crash in found.crashes] == pytest.approx([np.pi * diameter**2 / 4 * 3] * 12, rel=0.1)
    assert found.crashes[0].place[:2] == pytest.approx(TWELVE[0], abs=diameter) and found.crashes[0].depth == 3


@pytest.mark.parametrize(
    "tool", [Tool("vbit", 6), Tool("ballend", 6), Tool("drill", 6), Tool("bullnose", 6, corner_radius=1)]
)
def test_rapid_plunges_of_pointed_tools_are_crashes(tool):
    shallow = check_crashes([Cut(plunges(TWELVE, depth=0.1), tool)], PLATE)
    assert len(shallow.crashes) == 12


def test_fast_plunges_of_thin_tools_are_found():
    check = [
        check_crashes([Cut(plunges(TWELVE, kind="feed", feed=feed), Tool("endmill", 0.5), 2.0)], PLATE)
        for feed in (2, 6)
    ]
    assert [len(found.fast_plunges) for found in check] == [0, 12] and check[1].crashes == ()
    assert [plunge.source.command for plunge in check[1].fast_plunges] == list(range(0, 36, 3))


@pytest.mark.parametrize("aside, crashed", [(0.0, False), (0.015, False), (0.1, True), (0.3, True)])
def test_rapid_that_more_than_touches_a_slot_wall_is_a_crash(aside, crashed):
    """A rapid returns through a slot with a sideways shift.

    Rays a sixteenth of the tool apart miss the thin shaving of the wall.
    """
    slot = [(-5, 20, 25), (-5, 20, 10), (105, 20, 10), (105, 20 + aside, 10), (-5, 20 + aside, 10), (-5, 20, 25)]
    found = check_crashes([Cut(path(slot, [0, 3, 4]), FLAT)], BLOCK)
    assert [crash.source.command for crash in found.crashes] == [3] * crashed
    assert (
        bool(crashes(simulate_job([Cut(path(slot, [0, 3, 4]), FLAT)], stock=BLOCK, view=View(width=100, height=80))))
        <= crashed
    )


@pytest.mark.parametrize(
    "tool",
    [
        Tool("endmill", 0.1),
        Tool("endmill", 20),
        Tool("ballend", 0.3),
        Tool("ballend", 20),
        Tool("bullnose", 5, corner_radius=1),
        Tool("vbit", 0.3),
        Tool("vbit", 6, tip_angle=np.radians(40)),
        Tool("drill", 1),
    ],
    ids=str,
)
@pytest.mark.parametrize("depth", [0.0, 0.01])
def test_rapid_that_grazes_the_top_is_a_crash(tool, depth):
    """A rapid exactly at the height of the top is not a crash. A rapid 0.01 mm lower is a crash."""
    found = check_crashes([Cut(path([(10, 30, 25), (10, 30, 20 - depth), (60, 45, 20 - depth)], [0, 1]), tool)], BLOCK)
    assert [crash.source.command for crash in found.crashes] == [0, 1] * (depth > 0)


def test_vertical_arcs_hide_grazes_only_on_their_floors():
    """A trough is cut by an arc in the plane XZ. Then rapids graze the floor of the trough, and the top of the block.

    The chords of the arc leave material on the floor of the trough, but not on the top of the block.
    """
    trough = [
        ("G0", {"X": 20, "Y": 20, "Z": 25}),
        ("G1", {"Z": 20, "F": 9}),
        ("G18", {}),
        ("G2", {"X": 32, "I": 6, "K": 0}),
    ]
    down = [("G0", {"Z": 25}), ("G0", {"X": 26}), ("G0", {"Z": 14}), ("G0", {"Z": 25})]
    graze = [("G0", {"X": 70, "Y": 60}), ("G0", {"Z": 19.99}), ("G0", {"X": 10, "Y": 45})]
    found = check_crashes([Cut(linearize([*trough, *down, *graze]), Tool("ballend", 6))], BLOCK)
    first = len(trough) + len(down) + 1
    assert [crash.source.command for crash in found.crashes] == [first, first + 1]


def test_rapids_in_a_cleared_pocket_are_not_crashes():
    """Sixty rapids on the cleared floor of a pocket are not crashes.

    If the end of one rapid is lowered by 0.1 mm, there are crashes.
    """
    rng = np.random.default_rng(4)
    rows = [(x, y, 15) for k, y in enumerate(np.arange(10, 70, 4.0)) for x in ((10, 90) if k % 2 == 0 else (90, 10))]
    links = [(*point, 15.0) for point in rng.uniform((14, 14), (86, 62), (60, 2))]
    first = len(rows) + 1  # number of the first rapid
    points = [(10, 10, 25), *rows, (50, 66, 15), *links]
    rapid = range(first, len(points) - 1)
    found = check_crashes([Cut(path(points, rapid), FLAT)], BLOCK)
    assert found.crashes == () and found.unchecked == () and found.pixel == 0.5
    points[first + 31] = (*points[first + 31][:2], 14.9)
    found = check_crashes([Cut(path(points, rapid), FLAT)], BLOCK)
    assert [crash.source.command for crash in found.crashes] == [first + 30, first + 31]


def test_first_move_is_checked_even_if_it_is_a_retract():
    """The tool may start an operation anywhere, so a retract that is its first move is checked."""
    drilled = path([(50, 40, 25), (50, 40, 5), (50, 40, 25)], [1])
    assert check_crashes([Cut(drilled, FLAT)], BLOCK).pixel == 0
    assert len(check_crashes([Cut(path([(50, 40, 5), (50, 40, 25)], [0]), FLAT)], BLOCK).crashes) == 1


def test_rapid_beside_round_stock_is_not_a_crash():
    stock = Cylinder((50, 40, 0), 30, 20)
    beside, inside = plunges([(85, 40)]), plunges([(78, 40)])
    assert check_crashes([Cut(beside, FLAT)], stock).crashes == ()
    assert len(check_crashes([Cut(inside, FLAT)], stock).crashes) == 1


def test_moves_that_exceed_the_time_limit_are_unchecked():
    cut = Cut(plunges(TWELVE), Tool("endmill", 0.5))
    found = check_crashes([cut], PLATE, seconds=0)
    assert found.crashes == () and [source.command for source in found.unchecked] == list(range(0, 36, 3))


@pytest.mark.parametrize("memory, pixel", [(-1.0, None), (30e6, None), (1e9, 0.05)])
def test_view_along_the_tool_axis_is_fine_and_within_its_budget(memory, pixel):
    """For a block of 100 x 80 mm and a tool of 6 mm, pixels of half the tolerance are fine enough."""
    view = axis_view([Cut(plunges([(50, 40)]), FLAT)], BLOCK, memory_bytes=memory, seconds=60)
    assert view.direction == (0, 0, -1)
    if pixel is not None:
        assert (view.pixel, view.width, view.height) == (pixel, 2000, 1600)
    else:
        assert view.frame(BLOCK).pixel > 0.1 and (memory > 0 or view.width == 1)


def test_crash_check_can_be_cancelled():
    def stop():
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        check_crashes([Cut(plunges(TWELVE), FLAT)], PLATE, going_on=stop)


def test_moves_beside_or_above_the_stock_meet_no_material():
    above = path([(0, 0, 21), (100, 80, 21), (-20, 80, 5)], [0])
    assert not check_crashes([Cut(above, FLAT)], Stock((0, 0, 0), (60, 40, 4))).met
    assert check_crashes([Cut(plunges(TWELVE), FLAT)], PLATE).met
    assert check_crashes([], PLATE) == check_crashes([Cut(path(np.empty((0, 3))), FLAT)], PLATE)
