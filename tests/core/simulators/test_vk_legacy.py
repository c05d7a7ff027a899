# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cost of the legacy simulator: fast-forward, play, and several operations in sequence."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from simulator_jobs import STOCK, TOOL, surface, zigzag

from vkworkbench.core import Stock, Tool
from vkworkbench.core.gcode import linearize
from vkworkbench.core.simulators.constants import Constants
from vkworkbench.core.simulators.legacy import legacy_cost, legacy_together
from vkworkbench.core.simulators.simulator import Task


def cost_of(commands, tool=TOOL, stock=STOCK, accuracy=0.1, **constants):
    return legacy_cost(Task(linearize(commands), tool, stock), accuracy=accuracy, constants=Constants(**constants))


def test_comments_take_time_in_a_play_but_show_no_mesh():
    bare, noted = cost_of(zigzag(20)), cost_of(zigzag(20) + [("(note)", {})] * 1000)
    assert noted.fast_forward_seconds - bare.fast_forward_seconds == pytest.approx(1000 * Constants().tick)
    assert noted.play_seconds - bare.play_seconds == pytest.approx(1000 / 50)


def test_fast_forward_makes_one_mesh_of_all_cells():
    usual, slow = (cost_of(zigzag(20), cell=cell) for cell in (0.0, 1e-5))
    assert slow.fast_forward_seconds - usual.fast_forward_seconds == pytest.approx(1e-5 * slow.cells)


def test_play_shows_a_mesh_of_the_stock_and_of_every_command():
    half, one = (cost_of(zigzag(40), redraw=redraw) for redraw in (0.5, 1.0))
    assert one.play_seconds - half.play_seconds == pytest.approx(0.5 * (1 + one.shown))


def test_time_for_the_tool_profile_grows_with_width_and_height():
    cone = Tool("vbit", 6.0, tip_angle=math.pi / 2)
    without, with_ = (cost_of(zigzag(2), cone, profile=seconds) for seconds in (0.0, 0.01))
    steps = (3 * 3.0 + 3.0) / (0.05 * 0.1)
    assert with_.fast_forward_seconds - without.fast_forward_seconds == pytest.approx(0.01 * steps)


def test_play_shows_the_mesh_as_it_grows():
    free = dict.fromkeys(("start", "redraw", "cell", "facet", "profile"), 0.0)

    def mean_facets(commands, tool=TOOL):
        cost = cost_of(commands, tool, display=1.0, **free)
        return cost.play_seconds / cost.shown, cost.facets

    mean, last = mean_facets(surface(), Tool("ballend", 6.0))
    assert mean == pytest.approx(0.5 * last, rel=0.2)  # The mesh grows row after row.
    deeper = [("G0", {"X": 20.0, "Y": 20.0, "Z": 25.0})]
    for z in range(19, 5, -1):
        deeper += [("G1", {"Z": float(z)}), ("G2", {"X": 50.0, "Y": 40.0, "I": 15.0, "J": 10.0})]
        deeper += [("G2", {"X": 20.0, "Y": 20.0, "I": -15.0, "J": -10.0})]
    mean, last = mean_facets(deeper)
    assert mean == pytest.approx(last, rel=0.15)  # The walls of the pocket exist after the first turn around it.
    facing = [("G0", {"X": -5.0, "Y": -5.0, "Z": 10.0})]
    facing += [("G1", {"X": 105.0 if k % 4 in (1, 2) else -5.0, "Y": 5.0 * (k // 2) - 5}) for k in range(1, 30)]
    mean, last = mean_facets(facing)
    assert last == 12 and mean > 50  # The mesh after the last move is flat.


def test_grid_has_a_thousand_cells_of_five_bytes_along_a_side():
    cost = cost_of(zigzag(3))
    assert 1000 * 600 <= cost.cells <= 1001 * 601
    assert cost.memory_bytes == pytest.approx(5 * cost.cells + 150 * cost.facets)
    # Only the proportions of a stock matter, and not its size.
    small, large = (cost_of(zigzag(2), stock=Stock((0, 0, 0), (size, size / 2, 1))) for size in (0.5, 50))
    assert small.cells == large.cells


def test_fast_forward_time_per_command_is_equal_at_any_accuracy():
    commands = zigzag(500)
    ticks = len(commands) * Constants().tick
    assert ticks < cost_of(commands, accuracy=1.0).fast_forward_seconds < ticks + 0.5
    assert ticks < cost_of(commands, accuracy=0.1).fast_forward_seconds < ticks + 1.0


def test_fast_forward_repaints_at_most_a_hundred_times():
    free = {"start": 0.0, "tick": 0.0, "cell": 0.0, "facet": 0.0, "display": 0.0, "profile": 0.0}
    repaints = [cost_of(zigzag(rows), repaint=1.0, **free).fast_forward_seconds for rows in (20, 100)]
    assert repaints == [3 + 2 * 20, 100]


def test_fast_forward_waits_until_the_last_mesh_is_shown():
    for commands in (surface(), zigzag(100)):
        quick, slow = (cost_of(commands, display=display) for display in (0.0, 1e-4))
        assert slow.fast_forward_seconds - quick.fast_forward_seconds == pytest.approx(1e-4 * slow.facets)


def test_play_is_never_faster_than_its_speed_slider():
    cost = cost_of(zigzag(50), start=0.0, redraw=0.0, cell=0.0, facet=0.0, display=0.0, profile=0.0)
    assert cost.play_seconds == pytest.approx(len(zigzag(50)) / 50)


def test_drilling_cycle_makes_three_meshes():
    free = dict.fromkeys(("facet", "display", "profile"), 0.0)
    holes = [("G81", {"X": x, "Y": 20.0, "Z": 5.0, "R": 22.0, "F": 5.0}) for x in (30.0, 60.0)]
    cost = cost_of([("G0", {"X": 20.0, "Y": 20.0, "Z": 25.0}), *holes], cell=1e-5, redraw=1.0, **free)
    # Meshes are made for the uncut stock, for the move, and for the two holes.
    assert cost.play_seconds == pytest.approx(1e-5 * cost.cells * (1 + 1 + 2 * 3) + 1.0 * (1 + 3))


def test_legacy_simulator_starts_once_for_several_operations():
    one, constants = cost_of(zigzag(40)), Constants()
    assert legacy_together([one]) == replace(
        one, fast_forward_seconds=pytest.approx(one.fast_forward_seconds), play_seconds=pytest.approx(one.play_seconds)
    )
    two = legacy_together([one, one])
    once = constants.start + constants.cell * one.cells
    assert two.fast_forward_seconds == pytest.approx(2 * one.fast_forward_seconds - once)
    assert one.memory_bytes < two.memory_bytes < 2 * one.memory_bytes


def test_meshes_in_a_play_include_cuts_of_earlier_operations():
    costs = [
        replace(cost_of(zigzag(rows)), shown=shown, facets=facets)
        for rows, shown, facets in ((4, 10, 100.0), (5, 20, 300.0), (6, 40, 700.0))
    ]
    together, constants = legacy_together(costs), costs[0].constants
    assert together.facets == 1100 and together.shown == 70
    # The uncut stock is shown once for all three operations, and not three times.
    uncut = constants.cell * costs[0].cells + constants.redraw
    alone = sum(cost.play_seconds for cost in costs) - 2 * uncut
    more = 20 * 100 + 40 * (100 + 300)
    assert together.play_seconds == pytest.approx(alone + (constants.facet + constants.display) * more)
