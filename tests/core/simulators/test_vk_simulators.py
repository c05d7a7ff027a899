# SPDX-License-Identifier: LGPL-2.1-or-later
"""Costs of FreeCAD's simulators: the counts against loops written like FreeCAD's own, and what follows."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from vkworkbench.core import Stock, Tool
from vkworkbench.core.gcode import linearize
from vkworkbench.core.simulators.accuracy import best_accuracy
from vkworkbench.core.simulators.constants import DEFAULTS, Constants
from vkworkbench.core.simulators.floors import floors
from vkworkbench.core.simulators.heightmap import heightmaps
from vkworkbench.core.simulators.legacy import SLIDER, legacy_costs, legacy_together
from vkworkbench.core.simulators.legacy_mesh import bottom_rectangles, mesh_facets
from vkworkbench.core.simulators.legacy_panel import fit_fast_forward, fit_play, panel_seconds
from vkworkbench.core.simulators.legacy_work import legacy_work
from vkworkbench.core.simulators.motions import motions
from vkworkbench.core.simulators.opengl import (
    opengl_cost,
    opengl_speeds,
    opengl_together,
    opengl_work,
    outline_segments,
)
from vkworkbench.core.simulators.simulator import Conditions, Task
from vkworkbench.core.simulators.table import LEGACY, OPENGL, ZBUFFER, available

STOCK = Stock((0, 0, 0), (100, 60, 20))
TOOL = Tool("endmill", 6.0)


def zigzag(rows, depth=15.0, width=80.0, pitch=2.0):
    """Rows in alternating directions at one depth."""
    commands = [("(zigzag)", {}), ("G0", {"X": 10.0, "Y": 5.0, "Z": 25.0}), ("G1", {"Z": depth, "F": 10.0})]
    for row in range(rows):
        commands.append(("G1", {"X": 10.0 + width * ((row + 1) % 2)}))
        commands.append(("G1", {"Y": 5.0 + pitch * (row + 1)}))
    return commands


def arcs(count, radius):
    """Half circles to and fro."""
    commands = [("G0", {"X": 40.0, "Y": 30.0, "Z": 10.0})]
    for i in range(count):
        x = 40.0 + (2 * radius if i % 2 == 0 else 0.0)
        commands.append(("G2", {"X": x, "Y": 30.0, "Z": 10.0, "I": radius if i % 2 == 0 else -radius, "J": 0.0}))
    return commands


# --- motions


def test_chords_of_an_arc_are_one_motion_of_its_radius_and_sweep():
    made = motions(
        linearize(
            [
                ("G0", {"X": 10.0, "Y": 0.0, "Z": 0.0}),
                ("G3", {"X": -10.0, "Y": 0.0, "I": -10.0, "J": 0.0}),
                ("G3", {"X": 10.0, "Y": 0.0, "I": 10.0, "J": 0.0, "Z": -4.0}),
            ]
        )
    )
    assert np.allclose(made.sweep, [math.pi, math.pi])
    assert np.allclose(made.radius, [10, 10])
    assert np.allclose(made.move, [[-20, 0, 0], [20, 0, -4]])
    assert made.command.tolist() == [1, 2]


@pytest.mark.parametrize("sweep", [0.05, 0.4, 2.0, 3.5, 6.2])
@pytest.mark.parametrize("down", [0.0, 7.0])
def test_an_arc_of_any_sweep_is_a_motion_of_its_radius(sweep, down):
    """About (0, 0), from (10, 0), level or downwards."""
    end = {"X": 10 * math.cos(sweep), "Y": 10 * math.sin(sweep), "Z": -down}
    path = linearize([("G0", {"X": 10.0, "Y": 0.0, "Z": 0.0}), ("G3", {**end, "I": -10.0, "J": 0.0})])
    made = motions(path)
    assert made.radius == pytest.approx([10.0], rel=1e-3) and made.sweep == pytest.approx([sweep])
    # Straight moves are one motion each, even of one command.
    straight = motions(replace(path, sweep=np.zeros(len(path))))
    assert len(straight.move) == len(path) and not straight.radius.any()


def test_a_full_circle_is_a_motion_though_it_ends_where_it_starts():
    made = motions(linearize([("G0", {"X": 10.0, "Y": 0.0, "Z": 0.0}), ("G2", {"X": 10.0, "I": -10.0, "J": 0.0})]))
    assert made.sweep == pytest.approx([-2 * math.pi]) and made.radius == pytest.approx([10.0], rel=1e-5)


def test_an_arc_in_a_vertical_plane_stays_chords():
    path = linearize(
        [
            ("G18", {}),
            ("G0", {"X": 0.0, "Y": 0.0, "Z": 0.0}),
            ("G2", {"X": 10.0, "Z": 0.0, "I": 5.0, "K": 0.0}),
        ]
    )
    made = motions(path)
    assert len(made.sweep) == len(path) > 4 and not made.radius.any()


def test_a_peck_drilling_cycle_is_three_motions():
    made = motions(
        linearize(
            [
                ("G0", {"X": 0.0, "Y": 0.0, "Z": 20.0}),
                ("G83", {"X": 5.0, "Y": 5.0, "Z": -9.0, "R": 3.0, "Q": 1.0, "F": 2.0}),
                ("G83", {"X": 15.0, "Y": 5.0, "Z": -9.0, "R": 3.0, "Q": 1.0}),
                ("G80", {}),
            ]
        )
    )
    vertical = made.level < 1e-9
    assert np.allclose(made.move[vertical, 2], [-12, 12, -12, 12])
    assert made.command.tolist() == [1, 1, 1, 2, 2, 2]
    there = [("G0", {"X": 5.0, "Y": 5.0, "Z": 3.0}), ("G81", {"X": 5.0, "Y": 5.0, "Z": -9.0, "R": 3.0, "F": 2.0})]
    assert np.allclose(motions(linearize(there)).move, [[0, 0, -12], [0, 0, 12]])  # it is over the hole already
    # Over each hole at the retract height, where they end, too, though the cycle returns to 20 mm.
    assert np.allclose(made.move[~vertical], [[5, 5, -17], [10, 0, 0]])


def test_an_empty_toolpath_has_no_motion():
    made = motions(linearize([("(nothing)", {})]))
    assert (
        made.move.shape == (0, 3) and len(made.sweep) == len(made.radius) == len(made.command) == len(made.level) == 0
    )


def test_what_is_straight_sweeps_no_angle():
    made = motions(linearize(zigzag(3)))
    assert len(made.move) == 7 and not made.sweep.any() and not made.radius.any()


# --- legacy simulator


def volsim_steps(move, radius, resolution):
    """Count the steps of ApplyLinearTool (VolSim.cpp) by running its loops."""
    x, y, z = move[0] / resolution, move[1] / resolution, move[2]
    r = radius / resolution
    length = math.sqrt(x * x + y * y + z * z)
    lines, angle = 0, 360.0
    if length and math.hypot(x, y) / length > 1e-5:
        angle = 180.0
        for _ in range(int(r * 2 / 0.6) + 1):
            for _ in range(int(length / 0.6) + 1):
                lines += 1
    rings = caps = 0
    ring = 0.5
    while ring <= r:
        rings += 1
        turn, a = 180 * 0.6 / (math.pi * ring), 0.0
        while a < angle:
            caps += 1
            a += turn
        ring += 0.6
    return rings, lines, caps


@pytest.mark.parametrize("accuracy", [0.1, 0.3, 1.0])
@pytest.mark.parametrize("diameter", [1.0, 3.175, 12.0])
def test_counts_equal_the_loops_of_the_legacy_simulator(accuracy, diameter):
    rng = np.random.default_rng(7)
    ends = rng.uniform(0, 12, (6, 3))
    ends[4, :2] = ends[3, :2]
    path = linearize([("G1", dict(zip("XYZ", end.tolist()))) for end in ends])
    made = motions(path)
    work = legacy_work(made, diameter=diameter, stock=STOCK, accuracy=accuracy)
    counted = np.array([volsim_steps(move, diameter / 2, accuracy) for move in made.move])
    assert work.resolution == pytest.approx(accuracy) and (work.calls == 1).all()
    assert np.array_equal(work.rings, counted[:, 0])
    assert np.array_equal(work.line_steps, counted[:, 1])
    # The loop adds up an angle that may pass the end one step early or late by rounding.
    assert np.abs(work.cap_steps - counted[:, 2]).max() <= 0.002 * counted[:, 2].max() + 2


def test_grid_has_a_thousand_cells_along_the_longer_side_and_five_bytes_each():
    work = legacy_work(motions(linearize(zigzag(3))), diameter=6.0, stock=STOCK)
    assert 1000 * 600 <= work.cells <= 1001 * 601
    (cost,) = legacy_costs(Task(linearize(zigzag(3)), TOOL, STOCK))
    assert cost.memory_bytes == pytest.approx(5 * work.cells + 150 * cost.facets)


def test_an_arc_is_cut_in_as_many_moves_as_freecad_makes_of_it():
    radius, resolution = 15.0, 0.5
    work = legacy_work(motions(linearize(arcs(4, radius))), diameter=6.0, stock=STOCK, accuracy=0.5)
    expected = math.ceil(math.sqrt(radius / resolution * math.pi**2))
    assert work.calls.tolist() == [expected] * 4


def test_fast_forward_costs_a_tick_per_command_whatever_the_accuracy():
    path = linearize(zigzag(500))
    fine, coarse = legacy_costs(Task(path, TOOL, STOCK), accuracies=(0.1, 1.0))
    ticks = path.commands * Constants().tick
    assert ticks < coarse.fast_forward_seconds < ticks + 0.5
    assert ticks < fine.fast_forward_seconds < ticks + 1.0


def test_comments_take_a_tick_but_show_nothing():
    (bare,) = legacy_costs(Task(linearize(zigzag(20)), TOOL, STOCK))
    (noted,) = legacy_costs(Task(linearize(zigzag(20) + [("(note)", {})] * 1000), TOOL, STOCK))
    constants = Constants()
    assert noted.fast_forward_seconds - bare.fast_forward_seconds == pytest.approx(1000 * constants.tick)
    assert noted.play_seconds - bare.play_seconds == pytest.approx(1000 / 50)


def test_fast_forward_makes_one_mesh_of_all_cells():
    task = Task(linearize(zigzag(20)), TOOL, STOCK)
    usual, slow = (legacy_costs(task, constants=Constants(cell=cell))[0] for cell in (0.0, 1e-5))
    cells = legacy_work(task.motions, diameter=6.0, stock=STOCK).cells
    assert slow.fast_forward_seconds - usual.fast_forward_seconds == pytest.approx(1e-5 * cells)


def test_a_stock_of_half_a_millimetre_has_as_many_cells_as_one_of_its_form():
    """A millimetre is no bound of anything."""
    made = motions(linearize(zigzag(2)))
    small, large = (
        legacy_work(made, diameter=1.0, stock=Stock((0, 0, 0), (size, size / 2, 1))).cells for size in (0.5, 50)
    )
    assert small == large


def test_fast_forward_waits_for_the_last_mesh_to_be_shown():
    slow = Constants(display=1e-4)
    rough, plain = (
        legacy_costs(Task(linearize(path), TOOL, STOCK), constants=slow)[0] for path in (surface(), zigzag(500))
    )
    assert rough.facets > 10 * plain.facets
    for cost in (rough, plain):
        shown = cost.fast_forward_seconds - cost.panel_seconds - cost.mesh_seconds
        assert shown == pytest.approx(1e-4 * cost.facets, rel=0.1, abs=0.3)
    both = legacy_together([rough, plain])
    assert both.fast_forward_seconds == pytest.approx(
        rough.fast_forward_seconds + plain.fast_forward_seconds - slow.start, rel=0.01
    )


def test_play_is_never_faster_than_its_speed_slider():
    path = linearize(zigzag(50))
    fast = Constants(start=0.0, redraw=0.0, cell=0.0, facet=0.0, display=0.0, profile=0.0)
    (cost,) = legacy_costs(Task(path, TOOL, STOCK), speed=50, constants=fast)
    assert cost.play_seconds == pytest.approx(path.commands / 50)


def surface(rows=60, points=60):
    """Rows over a dome."""
    commands = [("G0", {"X": 20.0, "Y": 10.0, "Z": 25.0})]
    for row in range(rows):
        y = 10 + 40 * row / rows
        along = np.linspace(20, 80, points)[:: 1 if row % 2 == 0 else -1]
        heights = 18 - ((along - 50) ** 2 + (y - 30) ** 2) / 100
        commands += [("G1", {"X": x, "Y": y, "Z": z}) for x, z in zip(along.tolist(), heights.tolist())]
    return commands


def positions(path, tool):
    return legacy_costs(Task(path, tool, STOCK), accuracies=SLIDER)


def test_the_finest_of_several_accuracies_costs_what_it_costs_alone():
    through = linearize([("G0", {"X": 30.0, "Y": 30.0, "Z": 25.0}), ("G1", {"Z": -0.15}), *arcs(4, 12.0)])
    task = Task(through, TOOL, STOCK)
    (alone,) = legacy_costs(task, accuracies=(0.1,))
    assert legacy_costs(task, accuracies=(1.0, 0.1))[1] == alone


def test_budget_of_play_is_met_by_the_finest_position_that_meets_it():
    every = positions(linearize(surface()), Tool("ballend", 6.0))
    seconds = [cost.play_seconds for cost in every]
    assert seconds == sorted(seconds) and seconds[-1] > 1.5 * seconds[0]
    budget = 0.5 * (seconds[5] + seconds[6])
    chosen = best_accuracy([every], memory_bytes=1e9, seconds=budget)
    assert chosen.position == 6 and chosen.seconds <= budget
    assert chosen.explanation.startswith("position 6 of 10, cells of 0.5 mm, plays in ")
    assert best_accuracy([every], memory_bytes=every[2].memory_bytes, seconds=1e9).position == 3
    told = best_accuracy([every], memory_bytes=1e9, seconds=1e9, stepover=1.0).explanation
    assert told.endswith("; 0.25 mm would do for passes 1 mm apart")
    none = best_accuracy([every], memory_bytes=1e9, seconds=seconds[0] / 2)
    assert none.position is None and "use fast-forward" in none.explanation
    # Coarser does not help, and fast-forward is taken at the finest.
    assert (none.seconds, none.memory_bytes) == (every[0].play_seconds, every[0].memory_bytes)
    assert none.why.arguments["longer"] == every[0].play_seconds
    assert none.why.arguments["time"] == pytest.approx(every[-1].fast_forward_seconds)


def test_play_shows_the_uncut_stock_and_every_command():
    path = linearize(zigzag(40))
    half, one = (legacy_costs(Task(path, TOOL, STOCK), constants=Constants(redraw=redraw))[0] for redraw in (0.5, 1.0))
    assert one.play_seconds - half.play_seconds == pytest.approx(0.5 * (1 + one.shown))


def test_play_makes_a_mesh_after_each_of_the_three_moves_of_a_drilling_cycle():
    free = dict.fromkeys(("redraw", "facet", "display", "profile", "call", "ring", "line", "cap"), 0.0)
    holes = [("G81", {"X": x, "Y": 20.0, "Z": 5.0, "R": 22.0, "F": 5.0}) for x in (30.0, 60.0)]
    path = linearize([("G0", {"X": 20.0, "Y": 20.0, "Z": 25.0}), *holes])
    (cost,) = legacy_costs(Task(path, TOOL, STOCK), speed=1e9, constants=Constants(cell=1e-6, **free))
    assert cost.play_seconds == pytest.approx(1e-6 * cost.cells * (1 + 1 + 2 * 3))  # the uncut stock, a move, two holes


def test_a_profile_of_the_tool_is_as_long_as_the_tool_is_wide_and_high():
    path, cone = linearize(zigzag(2)), Tool("vbit", 6.0, tip_angle=math.pi / 2)
    without, with_ = (
        legacy_costs(Task(path, cone, STOCK), constants=Constants(profile=seconds))[0] for seconds in (0.0, 0.01)
    )
    steps = (3 * 3.0 + 3.0) / (0.05 * SLIDER[-1])
    assert with_.fast_forward_seconds - without.fast_forward_seconds == pytest.approx(0.01 * steps)


def test_every_mesh_of_a_play_has_the_triangles_of_the_operations_before():
    costs = [
        replace(positions(linearize(zigzag(rows)), TOOL)[-1], shown=shown, facets=facets, drawn=drawn)
        for rows, shown, facets, drawn in ((4, 10, 100.0, 7e3), (5, 20, 300.0, 8e3), (6, 40, 700.0, 9e3))
    ]
    together, constants = legacy_together(costs), costs[0].constants
    more = 20 * 100 + 40 * (100 + 300)
    assert together.drawn == 24e3 + more and together.facets == 1100 and together.shown == 70
    once = constants.cell * costs[0].cells + constants.redraw  # the uncut stock is shown once, not three times
    alone = sum(cost.play_seconds for cost in costs) - 2 * once
    assert together.play_seconds == pytest.approx(alone + (constants.facet + constants.display) * more)
    assert together.display_seconds == pytest.approx(constants.redraw * 70 + constants.display * together.drawn)


def test_chords_of_an_arc_are_walked_in_steps_of_six_tenths_of_a_cell():
    """A half circle of 15 mm with cells of 0.5 mm is 18 chords of 5.2 cells, nine steps each; 21 lines for 6 mm."""
    work = legacy_work(motions(linearize(arcs(1, 15.0))), diameter=6.0, stock=STOCK, accuracy=0.5)
    assert work.calls.tolist() == [18] and work.line_steps.tolist() == [18 * 9 * 21]
    tiny = [("G0", {"X": 40.0, "Y": 30.0, "Z": 10.0}), ("G2", {"X": 40.1, "Y": 30.0, "Z": 10.0, "I": 0.05, "J": 0.0})]
    assert legacy_work(motions(linearize(tiny)), diameter=6.0, stock=STOCK, accuracy=1.0).calls.tolist() == [1]


def test_each_chord_of_a_helix_descends_by_its_share():
    """By 2 mm, which count as cells: 5.6 from end to end, ten steps."""
    down = [("G0", {"X": 40.0, "Y": 30.0, "Z": 40.0}), ("G2", {"X": 70.0, "Y": 30.0, "Z": 4.0, "I": 15.0, "J": 0.0})]
    work = legacy_work(motions(linearize(down)), diameter=6.0, stock=STOCK, accuracy=0.5)
    assert work.calls.tolist() == [18] and work.line_steps.tolist() == [18 * 10 * 21]


def test_where_no_accuracy_helps_the_heaviest_operation_is_named():
    small, large = positions(linearize(zigzag(4)), TOOL), positions(linearize(surface()), TOOL)
    told = best_accuracy([small, large], memory_bytes=1e9, seconds=1.0, labels=("Floor", "Dome"))
    assert "; the heaviest is Dome with " in told.explanation
    assert told.why.arguments["heaviest"].arguments["time"] == large[0].play_seconds


def test_operations_together_start_once_and_draw_what_was_cut_before():
    one = positions(linearize(zigzag(40)), TOOL)[-1]
    two = legacy_together([one, one])
    alone = legacy_together([one])
    assert alone.fast_forward_seconds == pytest.approx(one.fast_forward_seconds) and alone.facets == one.facets
    assert one.fast_forward_seconds < two.fast_forward_seconds < 2 * one.fast_forward_seconds
    uncut = Constants().redraw + Constants().cell * one.cells
    assert two.play_seconds > 2 * one.play_seconds - uncut
    assert alone.play_seconds == pytest.approx(one.play_seconds)
    assert one.memory_bytes < two.memory_bytes < 2 * one.memory_bytes

    path = linearize(zigzag(400))
    whole = opengl_cost(Task(path, TOOL, STOCK), speeds=(10,))
    assert opengl_together([whole]) == whole
    # The same motions, half of them twice: nearly as long as all at once.
    half = opengl_cost(Task(linearize(zigzag(200)), TOOL, STOCK), speeds=(10,))
    both = opengl_together([half, half])
    assert both.play_seconds[10] == pytest.approx(whole.play_seconds[10], rel=0.03)
    assert both.frame_seconds == pytest.approx(whole.frame_seconds, rel=0.01)


def test_what_was_drawn_before_takes_nothing_as_long_as_a_picture_waits_for_the_screen():
    """Two times 100 steps; a picture of the first waits for 1 s, and grows to 1 s of drawing while the second goes on.

    Then it takes 1 s and what the second has drawn of its own 1 s, half a second in the mean, instead of 1 s.
    """
    waiting = Constants(refresh=1.0, frame=0.0)
    one = replace(
        opengl_cost(Task(linearize(zigzag(4)), TOOL, STOCK), speeds=(1, 10), constants=waiting),
        drawing_seconds=1.0, steps=100, play_seconds={1: 100.0, 10: 10.0},
    )  # fmt: skip
    both = opengl_together([one, one])
    assert both.play_seconds == pytest.approx({1: 2 * 100 + 50, 10: 2 * 10 + 5}, rel=1e-6)
    assert (both.drawing_seconds, both.steps, both.draws) == (2.0, 200, 2 * one.draws)


@pytest.mark.parametrize("tick", [1.1e-3, 15e-3])
def test_fast_forwards_tell_start_tick_and_repaint(tick):
    commands = np.array([12, 3000, 60, 800, 150, 1500, 30, 5000])
    seconds = 0.8 + tick * commands + 0.03 * np.minimum(commands, 100)
    seconds[3] *= 20  # the computer did something else
    assert fit_fast_forward(commands, seconds) == pytest.approx((0.8, tick, 0.03), rel=0.1)


@pytest.mark.parametrize("tick, found", [(1.3e-3, 1.3e-3), (0.7e-3, 1e-3)])
def test_no_tick_is_shorter_than_the_timer(tick, found):
    commands = np.array([2000, 3000, 5000, 8000, 12000])
    assert fit_fast_forward(commands, 0.3 + tick * commands)[1] == pytest.approx(found, rel=0.03)


def test_a_fast_forward_repaints_for_every_percent_and_no_more_often_than_there_are_commands():
    repaints = Constants(start=0.0, tick=0.0, repaint=1.0)
    assert [panel_seconds(repaints, commands) for commands in (40, 100, 5000)] == [40, 100, 100]


def test_a_play_that_hardly_shows_anything_moves_the_redraw_a_part_of_the_way():
    """A ridge regression of one number: in units of 0.03 s, the default weighs 0.02, and a run of 60 s 20 / 60^2."""
    shown, seconds, beyond = 100, 60.0, 1.0
    redraw, display = fit_play(
        np.array([shown]), np.array([0.0]), np.array([shown * DEFAULTS.redraw + beyond]), np.array([seconds])
    )
    unit, weight = shown * 0.03, 20 / seconds**2
    moved = unit * weight * beyond / (0.02 + unit**2 * weight)
    assert redraw == pytest.approx(DEFAULTS.redraw + 0.03 * moved) and display == pytest.approx(DEFAULTS.display)


@pytest.mark.parametrize("seconds", [[1.0, 0.9, 1.1, 0.9], [0.9, 1.2, 1.4, 1.5], [1.0, 1.0, 1.5, 1.9]])
def test_short_fast_forwards_say_nothing_of_long_ones(seconds):
    commands = np.array([20, 45, 110, 140])
    start, tick, repaint = fit_fast_forward(commands, np.array(seconds))
    assert tick == pytest.approx(DEFAULTS.tick)
    predicted = start + tick * commands + repaint * np.minimum(commands, 100)
    assert predicted == pytest.approx(np.array(seconds), rel=0.3)


@pytest.mark.parametrize("redraw, display", [(0.06, 3e-6), (0.005, 0.2e-6)])
def test_plays_tell_redraw_and_display(redraw, display):
    shown, drawn = np.array([50, 80, 30, 200, 90]), np.array([20e3, 2e6, 300e3, 900e3, 40e3])
    display_seconds = redraw * shown + display * drawn
    seconds = display_seconds + 0.5 + 1.5e-6 * drawn
    display_seconds[2] -= 1.0  # its mesh was made faster than thought
    learned = fit_play(shown, drawn, display_seconds, seconds)
    assert learned == (pytest.approx(redraw, rel=0.05), pytest.approx(display, abs=0.2e-6))
    of_one, per_triangle = fit_play(shown[:1], drawn[:1], display_seconds[:1], seconds[:1])
    assert of_one * shown[0] + per_triangle * drawn[0] == pytest.approx(display_seconds[0], rel=0.1)


def test_impossible_input_is_refused_in_words():
    made = motions(linearize(zigzag(2)))
    with pytest.raises(ValueError, match="tool diameter"):
        legacy_work(made, diameter=0.0, stock=STOCK)
    with pytest.raises(ValueError, match="accuracy"):
        legacy_work(made, diameter=6.0, stock=STOCK, accuracy=0.0)
    with pytest.raises(ValueError, match="speed"):
        legacy_costs(Task(linearize(zigzag(2)), TOOL, STOCK), speed=0)
    with pytest.raises(ValueError, match="tool diameter"):
        opengl_work(made, diameter=float("nan"))
    with pytest.raises(ValueError, match="quality"):
        opengl_cost(Task(linearize(zigzag(2)), TOOL, STOCK), quality=0)


# --- heights and mesh


@pytest.mark.parametrize("tool", [Tool("endmill", 8.0), Tool("ballend", 8.0), Tool("vbit", 8.0)])
def test_heights_equal_those_of_every_cell_against_every_point(tool):
    path = linearize([("G1", {"X": 20.0, "Y": 15.0, "Z": 12.0}), ("G1", {"X": 70.0, "Y": 40.0, "Z": 8.0})])
    (heights,), size = heightmaps(path, tool=tool, stock=STOCK)
    along = np.linspace(0, 1, 500)[:, None]  # points a ninth of a mm apart, a ninth of a cell
    points = path.points[0] + along * (path.points[1] - path.points[0])
    x, y = np.meshgrid(
        (np.arange(heights.shape[0]) + 0.5) * size, (np.arange(heights.shape[1]) + 0.5) * size, indexing="ij"
    )
    distance = np.hypot(x[..., None] - points[:, 0], y[..., None] - points[:, 1])
    exact = np.minimum((points[:, 2] + tool.height(distance)).min(axis=2), 20.0)
    # A map that is off by half a cell sideways is off by that times the tool's slope.
    inside = distance.min(axis=2) < tool.radius - size
    outside = distance.min(axis=2) > tool.radius + 1.5 * size
    assert (heights[outside] == 20.0).all()
    assert np.abs(heights - exact)[inside].max() < 1.8 * size * (1 + tool.steepness) + 0.2


def test_cells_of_the_heights_are_a_hundredth_of_the_longer_side_or_a_sixteenth_of_the_radius():
    path = linearize(zigzag(3))
    tall = Stock((0, 0, 0), (100, 60, 300))
    for stock, diameter, expected in ((STOCK, 6.0, 1.0), (tall, 6.0, 1.0), (STOCK, 64.0, 2.0)):
        _, size = heightmaps(path, tool=Tool("endmill", diameter), stock=stock)
        assert size == pytest.approx(expected)
    _, of_floor = floors(path, tool=TOOL, stock=tall, thickness=0.1)
    assert of_floor == pytest.approx(0.2)


def test_a_fine_groove_has_no_gaps_and_its_ramps_are_cut_where_they_are_within_the_stock():
    small = Stock((0, 0, 0), (10, 6, 2))
    groove = [("G0", {"X": 1.0, "Y": 3.05, "Z": 4.0}), ("G1", {"X": 5.0, "Z": 0.0}), ("G1", {"X": 9.0, "Z": 4.0})]
    (heights,), size = heightmaps(linearize(groove), tool=Tool("endmill", 0.6), stock=small)
    x = (np.arange(heights.shape[0]) + 0.5) * size
    along = heights[:, int(3.05 / size)]
    # The lowest point of the flat tool over each cell: its edge is a radius ahead of its middle.
    exact = np.clip(np.abs(x - 5) - 0.3, 0, 2)
    assert np.abs(along - exact)[(x > 2) & (x < 8)].max() < 3 * size


def test_a_needle_cuts_the_cells_along_the_border_too():
    small, border = Stock((0, 0, 0), (10, 6, 2)), ((0.05, 0.05), (9.95, 0.05), (9.95, 5.95), (0.05, 5.95), (0.05, 0.05))
    around = [("G0", {"X": 0.05, "Y": 0.05, "Z": 4.0}), *[("G1", {"X": x, "Y": y, "Z": 1.0}) for x, y in border]]
    (heights,), _ = heightmaps(linearize(around), tool=Tool("endmill", 0.1), stock=small)
    assert (heights[1:-1, 1:-1] == 2).all() and (heights == 1).sum() == 2 * (100 + 60) - 4


def test_a_path_outside_the_stock_leaves_it_a_box():
    path = linearize([("G1", {"X": -50.0, "Y": 500.0, "Z": -5.0}), ("G1", {"X": -900.0})])
    (heights,), size = heightmaps(path, tool=TOOL, stock=STOCK)
    (floor,), floor_size = floors(path, tool=TOOL, stock=STOCK, thickness=0.1)
    assert (heights == 20.0).all() and floor.all()
    assert mesh_facets(heights, size, [0.1], floor=floor, floor_size=floor_size) == 12


def test_a_surface_makes_far_more_triangles_than_a_pocket_and_four_times_as_many_at_half_the_cell():
    ball = Tool("ballend", 6.0)
    (pocket,), size = heightmaps(linearize(zigzag(20)), tool=TOOL, stock=STOCK)
    (dome,), dome_size = heightmaps(linearize(surface()), tool=ball, stock=STOCK)
    whole = {"floor": np.ones((1, 1), bool), "floor_size": 1.0}
    of_dome, of_pocket = (
        mesh_facets(heights, edge, [0.1, 0.2], **whole) for heights, edge in ((dome, dome_size), (pocket, size))
    )
    assert of_dome[0] > 10 * of_pocket[0]
    assert 3.5 < of_dome[0] / of_dome[1] <= 4
    assert 1.7 < of_pocket[0] / of_pocket[1] < 2.1


def test_half_the_size_at_half_the_cell_makes_as_many_triangles():
    (dome,), size = heightmaps(linearize(surface()), tool=Tool("ballend", 6.0), stock=STOCK)
    floor = np.ones((1, 1), bool)
    whole, half = (
        mesh_facets(dome * scale, size * scale, [0.1 * scale], floor=floor, floor_size=scale) for scale in (1, 0.5)
    )
    assert half == pytest.approx(whole)


def test_a_part_and_its_mirror_image_make_as_many_triangles():
    """A step beside one of less than half its height is a wall, whichever side the lower one is on."""
    heights = np.tile(np.cumsum([0.0, 0.0, 1.2, 3.0, 0.0, 0.0, 0.7, 0.7])[:, None], 6)
    there, back = (
        mesh_facets(one, 4.0, [0.5], floor=np.ones((1, 1), bool), floor_size=4.0) for one in (heights, heights[::-1])
    )
    assert there == pytest.approx(back)


@pytest.mark.parametrize(
    "steps, slope",
    [
        ([0.7, 0.7], True),
        ([1.0, 0.6], True),
        ([0.6, 1.0], True),
        ([0.7], False),
        ([1.2, 0.5], False),
        ([0.5, 1.2], False),
    ],
)
def test_a_step_beside_one_of_more_than_half_its_height_is_a_slope(steps, slope):
    """At half the cell a slope has four times the triangles that a box does not have, and a wall twice as many."""
    heights = np.tile(np.cumsum([0.0, 0.0, *steps, 0.0, 0.0])[:, None], 6)
    coarse, fine = mesh_facets(heights, 4.0, [0.4, 0.2], floor=np.ones((1, 1), bool), floor_size=4.0) - 12
    assert (fine == pytest.approx(4 * coarse)) == slope and 1.999 * coarse < fine < 4.001 * coarse


@pytest.mark.parametrize("fall", [0.1, 1.0])
def test_a_slope_and_the_same_turned_by_a_quarter_make_as_many_triangles(fall):
    heights = np.tile(fall * np.arange(40.0)[:, None], 60)
    along, across = (
        mesh_facets(one, 4.0, [0.5], floor=np.ones((1, 1), bool), floor_size=4.0) for one in (heights, heights.T)
    )
    assert along == pytest.approx(across)


def test_each_rectangle_of_a_lower_face_that_is_cut_through_is_two_triangles():
    heights, floor = np.full((8, 8), 20.0), np.ones((8, 8), bool)
    floor[2:4, 3:5] = floor[6, 6] = False
    (whole,), (cut,) = (
        mesh_facets(heights, 1.0, [1.0], floor=one, floor_size=1.0) for one in (np.ones((8, 8), bool), floor)
    )
    assert cut - whole == pytest.approx(2 * (bottom_rectangles(floor) - 1), rel=0.1)


def test_a_path_looked_at_in_parts_leaves_what_it_leaves_at_once():
    path = linearize(surface())
    ball = Tool("ballend", 6.0)
    (whole,), _ = heightmaps(path, tool=ball, stock=STOCK)
    parts, _ = heightmaps(path, tool=ball, stock=STOCK, parts=5)
    assert len(parts) == 5
    assert all((after <= before).all() for before, after in zip(parts, parts[1:]))
    assert np.abs(parts[-1] - whole).max() < 0.05  # the ends of the parts are sampled twice


def test_a_part_of_a_path_cuts_nothing_of_the_next_one():
    """Four commands in two parts: the second begins with a slot across the stock."""
    there, across, back = (("G1", {axis: to}) for axis, to in (("X", 90.0), ("Y", 50.0), ("X", 10.0)))
    path = linearize([("G0", {"X": 10.0, "Y": 10.0, "Z": 10.0}), there, across, back])
    (first, both), _ = heightmaps(path, tool=TOOL, stock=STOCK, parts=2)
    (half,), _ = heightmaps(linearize([("G0", {"X": 10.0, "Y": 10.0, "Z": 10.0}), there]), tool=TOOL, stock=STOCK)
    assert np.array_equal(first, half) and (both < first).any()


def from_line(x, y, begin, end):
    """How far points are from a line that ends."""
    ux, uy = end - begin
    share = ((x - begin[0]) * ux + (y - begin[1]) * uy) / max(ux**2 + uy**2, 1e-12)
    share = np.clip(share, 0, 1)
    return np.hypot(x - begin[0] - share * ux, y - begin[1] - share * uy)


@pytest.mark.parametrize("tool", [Tool("endmill", 8.0), Tool("drill", 8.0)])
def test_the_lower_face_is_cut_where_the_tool_comes_through(tool):
    def cut(x, y, z, to):
        return [("G0", {"X": x, "Y": y, "Z": 25.0}), ("G1", {"Z": z}), ("G1", to), ("G0", {"Z": 25.0})]

    begin, end = (
        np.array([[12.0, 9.0], [40.3, 30.7], [52.0, 20.0]]),
        np.array([[33.0, 24.0], [40.3, 30.7], [75.0, 20.0]]),
    )
    commands = cut(*begin[0], -1.0, {"X": 33.0, "Y": 24.0}) + cut(*begin[1], -1.0, {"Z": 5.0})
    commands += cut(*begin[2], 5.0, {"X": 75.0, "Z": 5.0})  # does not come through
    (kept,), size = floors(linearize(commands), tool=tool, stock=STOCK, thickness=0.0)
    # A drill of 118 degrees is as wide as this 1 mm above its tip.
    radius = 4.0 if tool.shape == "endmill" else np.tan(np.radians(59.0))
    x, y = (np.indices(kept.shape) + 0.5) * size
    distance = np.minimum(*(from_line(x, y, *ends) for ends in zip(begin[:2], end[:2])))
    assert not kept[distance < radius - 0.05].any()
    assert kept[distance > radius + 0.05].all()
    parts, _ = floors(linearize(commands), tool=tool, stock=STOCK, thickness=0.0, parts=3)
    assert (parts[-1] == kept).all() and kept.sum() < parts[0].sum() < kept.size


def test_cells_of_the_lower_face_are_cut_where_their_middles_are_under_the_tool():
    """A slot of 8 mm from (50, 30) to (51, 30) with cells of a fifth of a mm: the middles are at odd tenths."""
    slot = [("G0", {"X": 50.0, "Y": 30.0, "Z": 9.0}), ("G1", {"Z": -1.0}), ("G1", {"X": 51.0})]
    (kept,), size = floors(linearize(slot), tool=Tool("endmill", 8.0), stock=STOCK, thickness=0.0)
    assert size == pytest.approx(0.2) and kept.shape == (500, 300)
    x, y = (np.indices(kept.shape) + 0.5) * size
    assert np.array_equal(kept, np.hypot(x - np.clip(x, 50, 51), y - 30.0) > 4.0)
    (beside,), _ = floors(
        linearize([("G0", {"X": -2.0, "Y": 30.0, "Z": -1.0}), ("G1", {"Y": 70.0})]),
        tool=Tool("endmill", 8.0), stock=STOCK, thickness=0.0,
    )  # fmt: skip
    assert np.array_equal(~beside, np.hypot(x + 2.0, y - np.clip(y, 30, 70)) < 4.0)


@pytest.mark.parametrize("scale", [1, 200])
@pytest.mark.parametrize("seed", range(8))
def test_the_lower_face_is_cut_along_lines_in_any_direction_where_their_tip_is_below_it(seed, scale):
    """From anywhere around a block of 10 by 6 mm, or m, to anywhere, from above its lower face or below it: up to the rim."""
    rng = np.random.default_rng(seed)
    ends = scale * rng.uniform((-2, -2, -2), (12, 8, 2), (2, 3))
    begin, move = ends[0], ends[1] - ends[0]
    stock = Stock((0, 0, 0), (10 * scale, 6 * scale, 2 * scale))
    path = linearize([("G1", dict(zip("XYZ", end.tolist()))) for end in ends])
    (kept,), size = floors(path, tool=Tool("endmill", 2.0 * scale), stock=stock, thickness=0.0)
    part = np.linspace(0, 1, 100_001)
    part = part[begin[2] + part * move[2] <= 0]
    x, y = (np.indices(kept.shape) + 0.5) * size
    distance = np.full(x.shape, np.inf)
    if len(part):
        distance = from_line(x, y, *(begin[:2] + part[end] * move[:2] for end in (0, -1))) / scale
    assert not kept[distance < 0.999].any() and kept[distance > 1.001].all()


@pytest.mark.parametrize("through", [0.1, 0.3, 0.9])
def test_a_point_cuts_the_lower_face_as_wide_as_it_is_there(through):
    """A V-bit of 90 degrees is as wide on either side as its tip is below; of its 4 mm a 64th may be missing."""
    plunge = [("G0", {"X": 5.0, "Y": 3.0, "Z": 4.0}), ("G1", {"Z": -through})]
    point, stock = Tool("vbit", 8.0, tip_angle=math.pi / 2), Stock((0, 0, 0), (10, 6, 2))
    (kept,), size = floors(linearize(plunge), tool=point, stock=stock, thickness=0.0)
    x, y = (np.indices(kept.shape) + 0.5) * size
    distance = np.hypot(x - 5, y - 3)
    assert kept[distance > through].all() and not kept[distance < through - 4 / 64].any()


def test_cells_of_the_lower_face_grow_where_too_many_rows_would_be_passed():
    """10,000 moves of 8 mm across pass 80 m of rows and 2 m more for their ends: 300,000 rows of about 0.3 mm."""
    path = linearize([("G1", {"X": 20.0 + (i % 2), "Y": 30.0, "Z": -1.0}) for i in range(10_001)])
    _, size = floors(path, tool=Tool("endmill", 8.0), stock=STOCK, thickness=0.0)
    assert size == pytest.approx(10_000 * 8.0 / 300_000, rel=1e-3)


def test_a_ramp_that_comes_up_cuts_the_lower_face_until_its_tip_is_out():
    """Down at (20, 30) and up again to the side by 1 mm in 10: out at (30, 30)."""
    rows = [("G0", {"X": 20.0, "Y": 30.0, "Z": 9.0}), ("G1", {"Z": -1.0}), ("G1", {"X": 60.0, "Z": 3.0})]
    (kept,), size = floors(linearize(rows), tool=Tool("endmill", 8.0), stock=STOCK, thickness=0.0)
    x, y = (np.indices(kept.shape) + 0.5) * size
    assert np.array_equal(kept, np.hypot(x - np.clip(x, 20, 30), y - 30.0) > 4.0)


def test_on_a_ramp_the_lower_face_is_cut_from_where_the_tip_comes_through():
    ramp = [("G0", {"X": 10.0, "Y": 30.0, "Z": 10.0}), ("G1", {"X": 50.0, "Z": -10.0}), ("G1", {"X": 10.0, "Z": 10.0})]
    (kept,), size = floors(linearize(ramp), tool=Tool("endmill", 8.0), stock=STOCK, thickness=0.0)
    x, y = np.argwhere(~kept).T * size
    assert abs(x.min() - 26.0) < 2 * size and abs(x.max() - 54.0) < 2 * size and abs(np.ptp(y) - 8.0) < 2 * size


# --- what the unit of their work costs


def test_the_usual_constants_are_those_that_the_documents_state():
    """A timer of 1 ms, two refreshes of a screen of 60 Hz; right within a factor of two, and of four where it was guessed."""
    assert 1e-3 < DEFAULTS.tick < 1.2e-3 and DEFAULTS.refresh == 2 / 60
    assert (DEFAULTS.legacy_factor, DEFAULTS.opengl_factor) == (2, 4)


MILLION = 1e6


@pytest.mark.parametrize(
    "name, count, amount",
    [
        ("call", MILLION, 0.75),  # s of straight moves
        ("ring", MILLION, 0.06),  # of rings at their ends
        ("line", 1000 * MILLION, 2.2),  # and of the steps along them
        ("cap", 1000 * MILLION, 4.7),  # and around the rings
        ("cell", MILLION, 0.027),  # of a mesh by its cells
        ("facet", MILLION, 1.7),  # and by its triangles
        ("display", MILLION, 1.0),  # until they are shown
        ("profile", 300, 0.03),  # of a tool of 10 mm, every tenth of a millimetre
        ("facet_bytes", MILLION, 150e6),  # bytes of triangles
        ("start", 1, 0.32),  # s until the first command
        ("redraw", 40, 1.0),  # of commands of a play
        ("frame", 1000, 1.0),  # of pictures without a motion
        ("draw", MILLION, 1.5),  # of draw calls
        ("fill", 1, 150.0),  # draw calls that take as long as to fill the window
        ("line_bytes", MILLION, 900e6),  # bytes of straight motions
        ("arc_bytes", MILLION, 7e9),  # and of arcs
    ],
)
def test_a_constant_is_what_a_million_of_it_took_where_it_was_found(name, count, amount):
    """Written down a second time, in other units: a slip of a digit is seen, a new measurement of the same is none."""
    assert getattr(DEFAULTS, name) * count == pytest.approx(amount, rel=0.3)


# --- OpenGL simulator


def test_draw_calls_of_lines_plunges_and_arcs():
    start = [("G0", {"X": 0.0, "Y": 0.0, "Z": 10.0})]
    line = opengl_cost(Task(linearize(start + [("G1", {"X": 10.0})]), TOOL, STOCK))
    assert (line.draws, line.steps) == (18, 20)  # of half a millimetre
    assert tuple(line.play_seconds) == opengl_speeds((1, 1))
    # Ten millimetres in steps of one, and of four at the coarsest.
    rough = [opengl_cost(Task(linearize(start + [("G1", {"X": 10.0})]), TOOL, STOCK), quality=q) for q in (5, 1)]
    assert [cost.steps for cost in rough] == [10, 2]
    assert opengl_cost(Task(linearize(start + [("G1", {"Z": 1.0})]), TOOL, STOCK)).draws == 9
    # A half circle of 5 mm was counted in FreeCAD 1.0: 33 chords, 297 draw calls.
    half = opengl_cost(Task(linearize(arcs(1, 5.0)), TOOL, STOCK))
    assert (half.steps, half.draws, half.arc_draws) == (33, 297, 297)
    # Within the tool's radius an arc is drawn with the tool every 22.5 degrees.
    assert [opengl_cost(Task(linearize(arcs(1, r)), TOOL, STOCK)).draws for r in (2.0, 0.5)] == [9 * 9] * 2
    assert opengl_cost(Task(linearize(arcs(1, 2.0)), TOOL, STOCK), quality=1).draws == 9 * 3
    # Beside a smaller tool it has a chord for each quarter turn, where the quality asks for longer ones than it is wide.
    assert opengl_cost(Task(linearize(arcs(1, 2.0)), Tool("endmill", 1.0), STOCK), quality=1).draws == 9 * 4


def outline(*bases):
    """Areas of upright solids 30 mm high on convex bases, seen along Y and 30 degrees down, added."""
    total = 0.0
    for base in bases:
        x, y = np.array(base).T
        seen = np.concatenate([np.column_stack((x, y * 0.5 + z * math.sqrt(0.75))) for z in (0.0, 30.0)])
        turn = np.linspace(0, 2 * np.pi, 4000)
        x, y = seen[np.argmax(seen @ np.array((np.cos(turn), np.sin(turn))), axis=0)].T
        total += abs(np.sum(x * np.roll(y, 1) - y * np.roll(x, 1))) / 2
    return total


@pytest.mark.parametrize("angle", [0.0, 0.6, 1.5708, 2.5, 4.0])
def test_what_is_drawn_of_a_motion_is_as_large_as_it_is_seen(angle):
    along, across = np.array((np.cos(angle), np.sin(angle))), np.array((-np.sin(angle), np.cos(angle)))
    turn = np.linspace(-np.pi / 2, np.pi / 2, 200)[:, None]
    front = 3.0 * (np.cos(turn) * along + np.sin(turn) * across)
    there = dict(zip("XY", 20.0 * along))
    rows = [("G0", {"X": 0.0, "Y": 0.0, "Z": 10.0}), ("G1", there), ("G1", {"Z": 0.0})]
    with np.errstate(all="raise"):
        line, plunge = opengl_work(motions(linearize(rows)), diameter=6.0).area
    swept = [end * 20.0 * along + side * 3.0 * across for end in (0, 1) for side in (-1, 1)]
    assert line == pytest.approx(outline(swept, front), rel=0.002)
    assert plunge == pytest.approx(outline(np.concatenate((front, -front))), rel=0.002)


def test_what_is_drawn_of_an_arc_is_as_large_as_its_chords_and_its_tool():
    tool = opengl_work(motions(linearize([("G0", {"Z": 10.0}), ("G1", {"Z": 0.0})])), diameter=6.0).area[-1]
    small = opengl_work(motions(linearize(arcs(1, 2.0))), diameter=6.0)
    assert small.area[-1] == pytest.approx(9 * tool)
    # Half circles: 63 boxes and 5, each turned a little more, and the tool.
    for radius, diameter, boxes, off in ((10.0, 6.0, 63, 0.005), (0.8, 1.0, 5, 0.05)):
        rows = [("G0", {"Z": 10.0}), ("G1", {"Z": 0.0}), *arcs(1, radius)]
        work = opengl_work(motions(linearize(rows)), diameter=diameter)
        side, turns = np.array((0, np.pi * radius / boxes)), (np.arange(boxes) + 0.5) * np.pi / boxes
        base = np.column_stack((side[[0, 1, 1, 0]], np.array((-1, -1, 1, 1)) * diameter / 2))
        seen = outline(*(base @ np.array(((np.cos(t), np.sin(t)), (-np.sin(t), np.cos(t)))) for t in turns))
        assert work.steps[-1] == boxes + 1 and work.area[-1] == pytest.approx(seen + work.area[0], rel=off)


def play(path, diameter, speed, constants):
    """Play frame by frame, drawing everything done so far, as the simulator does."""
    drawn = [0.0]  # draw calls of a frame after each step, what it fills included
    made = motions(path)
    window = 1.819 * 100.0**2  # at a distance of 160 mm it is 0.7 rad high and four thirds as wide
    areas = opengl_work(made, diameter=diameter).area
    for move, sweep, radius, area in zip(made.move, made.sweep, made.radius, areas):
        filled = constants.fill * 9 * area / window
        if radius:
            step = min(max(math.asin(0.5 / radius), math.pi / 90), math.pi / 2)
            chords = int(abs(sweep) / step) + 2
            if radius <= diameter / 2:
                chords = int(abs(sweep) / (math.pi / 8)) + 1
            for _ in range(chords):
                drawn.append(drawn[-1] + 9 + filled / chords)
        else:
            drawn += [drawn[-1] + (9 if np.hypot(*move[:2]) < 1e-6 else 18) + filled] * max(
                1, int(np.linalg.norm(move) / 0.5)
            )
    return sum(max(constants.refresh, constants.frame + constants.draw * draws) for draws in drawn[speed::speed])


@pytest.mark.parametrize("speed", [1, 10, 40])
def test_playing_takes_what_its_frames_add_up_to(speed):
    software = Constants(refresh=0.02, frame=0.01, draw=25e-6)
    path = linearize(zigzag(60) + arcs(40, 5.0) + arcs(40, 2.0))
    predicted = opengl_cost(Task(path, TOOL, STOCK), speeds=(speed,), constants=software).play_seconds[speed]
    assert predicted == pytest.approx(play(path, 6.0, speed, software), rel=0.02)


def test_an_arc_is_drawn_as_far_as_it_is_done_and_how_high_the_stock_is_does_not_matter():
    """Half of it in the mean; from how far away the part is seen is said by its sides in X and Y."""
    path, only = linearize(arcs(1, 20.0)[1:]), Constants(refresh=0.0, frame=0.0)
    low, high = (
        opengl_cost(Task(path, TOOL, Stock((0, 0, 0), (100, 60, height))), speeds=(1,), constants=only)
        for height in (20, 500)
    )
    assert low == high and low.arc_draws == low.draws
    assert low.play_seconds[1] == pytest.approx(low.steps * low.drawing_seconds / 2)


def test_wide_cuts_take_longer_to_draw_than_narrow_ones_and_long_ones_than_short_ones():
    path, only = linearize(zigzag(60)), Constants(refresh=0.0, frame=0.0)
    wide, narrow = (opengl_cost(Task(path, Tool("endmill", d), STOCK), constants=only) for d in (12.0, 3.0))
    assert wide.draws == narrow.draws and wide.frame_seconds > 1.2 * narrow.frame_seconds
    short = opengl_cost(Task(linearize(zigzag(60, width=8.0)), Tool("endmill", 3.0), STOCK), constants=only)
    assert short.draws == narrow.draws and narrow.frame_seconds > 1.4 * short.frame_seconds


def test_rounded_tools_take_longer_to_draw_by_the_segments_of_their_outline():
    rounded = Tool("bullnose", 6.0, corner_radius=1.0), Tool("ballend", 6.0), Tool("ballend", 10.0)
    tools = TOOL, Tool("vbit", 6.0), *rounded
    assert [outline_segments(tool) for tool in tools] == [2, 2, 6, 11, 17]
    path, only = linearize(zigzag(60)), Constants(refresh=0.0, frame=0.0)
    flat, ball = (opengl_cost(Task(path, tool, STOCK), constants=only) for tool in (TOOL, Tool("ballend", 6.0)))
    assert ball.draws == flat.draws and ball.frame_seconds == pytest.approx(1.9 * flat.frame_seconds)


def test_playing_twice_the_path_takes_four_times_as_long_once_drawing_dominates():
    slow = Constants(refresh=0.0, frame=0.0, draw=1e-3)
    once = opengl_cost(Task(linearize(zigzag(200, pitch=0.1)), TOOL, STOCK), constants=slow).play_seconds[1]
    twice = opengl_cost(Task(linearize(zigzag(400, pitch=0.1)), TOOL, STOCK), constants=slow).play_seconds[1]
    assert twice / once == pytest.approx(4, rel=0.05)


# --- versions


def test_which_simulators_a_version_has():
    assert available(()) == (ZBUFFER,)
    assert available((0, 20, 2)) == available((0, 21)) == (ZBUFFER, LEGACY)
    assert available((1, 0, 0)) == available((1, 1, 3)) == (ZBUFFER, LEGACY, OPENGL)
    assert 1 <= Conditions().opengl_quality <= 10  # a position that its slider has
    assert opengl_speeds((1, 0, 0)) == (1, 10, 40)
    assert opengl_speeds((1, 1, 3)) == (1, 5, 10, 25, 50)


def test_cutting_out_a_round_part_breaks_the_bottom_to_pieces_and_a_square_one_does_not():
    """FreeCAD makes half a triangle per remaining cell of a disc's bottom, and two of a plate's."""
    x, y = np.meshgrid(np.arange(100) - 49.5, np.arange(60) - 29.5, indexing="ij")
    disc = np.where(np.hypot(x, y) < 28, 20.0, 0.0)
    plate = np.where((np.abs(x) < 40) & (np.abs(y) < 28), 20.0, 0.0)
    cells = 100 * (disc > 0).sum()
    of_disc, of_plate = (
        mesh_facets(heights, 1.0, [0.1], floor=heights > 0, floor_size=1.0) for heights in (disc, plate)
    )
    assert 0.2 * cells < of_disc < 0.7 * cells
    assert of_plate < 3000


def bottom_of_freecad(kept):
    """``TesselBot`` and its loop in VolSim.cpp, cell by cell; the top has been marked before."""
    kept, count = kept.copy(), 0
    columns, rows = kept.shape

    def grown(x, y):
        width = height = 1
        right = left = up = True
        while right or left or up:
            right = right and x + width < columns and kept[x + width, y : y + height].all()
            width += right
            left = left and x > 0 and kept[x - 1, y : y + height].all()
            x, width = x - left, width + left
            up = up and y + height < rows and kept[x : x + width, y + height].all()
            height += up
        return x, y, width, height

    for y in range(rows):
        x = 0
        while x < columns:
            if not kept[x, y]:
                x += 1
                continue
            left, lower, width, height = grown(x, y)
            if height // width > 5:
                lower, width, height = lower + 5 * width, 1, 1
            elif width // height > 5:
                left, width, height = left + 5 * height, 1, 1
            kept[left : left + width, lower : lower + height] = False
            count += 1
    return count


def test_pieces_of_the_lower_face_are_those_of_freecad():
    rng = np.random.default_rng(5)
    for k in range(60):
        columns, rows = rng.integers(1, 50, 2)
        x, y = np.meshgrid(np.arange(columns), np.arange(rows), indexing="ij")
        kept = rng.random((columns, rows)) < (0.8 if k % 4 == 0 else 2)
        for _ in range(k % 5):
            kept &= np.hypot(x - rng.integers(columns), y - rng.integers(rows)) > rng.integers(1, 12)
        assert bottom_rectangles(kept) == bottom_of_freecad(kept)


def test_play_shows_the_mesh_as_it_grows():
    shown = Constants(start=0.0, redraw=0.0, cell=0.0, facet=0.0, profile=0.0, display=1e-3)

    def mean_facets(commands, tool):
        (cost,) = legacy_costs(Task(linearize(commands), tool, STOCK), speed=1e9, constants=shown)
        return cost.play_seconds / cost.shown / 1e-3, cost.facets

    mean, last = mean_facets(surface(), Tool("ballend", 6.0))
    assert mean == pytest.approx(0.5 * last, rel=0.2)  # row after row
    deeper = [("G0", {"X": 20.0, "Y": 20.0, "Z": 25.0})]
    for z in range(19, 5, -1):
        deeper += [("G1", {"Z": float(z)}), ("G2", {"X": 50.0, "Y": 40.0, "I": 15.0, "J": 10.0})]
        deeper += [("G2", {"X": 20.0, "Y": 20.0, "I": -15.0, "J": -10.0})]
    mean, last = mean_facets(deeper, TOOL)
    assert mean == pytest.approx(last, rel=0.15)  # its walls are there after the first turn
    facing = [("G0", {"X": -5.0, "Y": -5.0, "Z": 10.0})]
    facing += [("G1", {"X": 105.0 if k % 4 in (1, 2) else -5.0, "Y": 5.0 * (k // 2) - 5}) for k in range(1, 30)]
    mean, last = mean_facets(facing, TOOL)
    assert last == 12 and mean > 50  # it ends flat
