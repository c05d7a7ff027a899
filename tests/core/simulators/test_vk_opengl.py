# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cost of the OpenGL simulator: its draw calls, and the duration of its frames."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from simulator_jobs import STOCK, TOOL, zigzag

from vkworkbench.core import Stock, Tool
from vkworkbench.core.gcode import linearize
from vkworkbench.core.simulators.constants import Constants
from vkworkbench.core.simulators.motions import motions
from vkworkbench.core.simulators.opengl import (
    opengl_cost,
    opengl_speeds,
    opengl_together,
    opengl_work,
    outline_segments,
)
from vkworkbench.core.simulators.simulator import Task


def arcs(count, radius):
    """Return half circles back and forth."""
    commands = [("G0", {"X": 40.0, "Y": 30.0, "Z": 10.0})]
    for i in range(count):
        x = 40.0 + (2 * radius if i % 2 == 0 else 0.0)
        commands.append(("G2", {"X": x, "Y": 30.0, "Z": 10.0, "I": radius if i % 2 == 0 else -radius, "J": 0.0}))
    return commands


def test_draw_calls_of_lines_plunges_and_arcs_are_counted():
    start = [("G0", {"X": 0.0, "Y": 0.0, "Z": 10.0})]
    line = opengl_cost(Task(linearize(start + [("G1", {"X": 10.0})]), TOOL, STOCK))
    assert (line.draws, line.steps) == (18, 20)  # The steps are 0.5 mm long.
    assert tuple(line.play_seconds) == opengl_speeds((1, 1))
    # The simulator divides a move of 10 mm into steps of 1 mm, or of 4 mm at the coarsest quality.
    rough = [opengl_cost(Task(linearize(start + [("G1", {"X": 10.0})]), TOOL, STOCK), quality=q) for q in (5, 1)]
    assert [cost.steps for cost in rough] == [10, 2]
    assert opengl_cost(Task(linearize(start + [("G1", {"Z": 1.0})]), TOOL, STOCK)).draws == 9
    # FreeCAD 1.0 draws a half circle of 5 mm with 33 chords and 297 draw calls.
    half = opengl_cost(Task(linearize(arcs(1, 5.0)), TOOL, STOCK))
    assert (half.steps, half.draws, half.arc_draws) == (33, 297, 297)
    # An arc smaller than the tool's radius is drawn as copies of the tool, one every 22.5 degrees.
    assert [opengl_cost(Task(linearize(arcs(1, r)), TOOL, STOCK)).draws for r in (2.0, 0.5)] == [9 * 9] * 2
    assert opengl_cost(Task(linearize(arcs(1, 2.0)), TOOL, STOCK), quality=1).draws == 9 * 3
    # With a smaller tool, and a quality with chords longer than the arc, the arc has a chord for each quarter turn.
    assert opengl_cost(Task(linearize(arcs(1, 2.0)), Tool("endmill", 1.0), STOCK), quality=1).draws == 9 * 4


def outline(*bases):
    """Return the sum of the visible areas of upright solids, seen along Y and 30 degrees down.

    Each solid is 30 mm high on a convex base.
    """
    total = 0.0
    for base in bases:
        x, y = np.array(base).T
        seen = np.concatenate([np.column_stack((x, y * 0.5 + z * math.sqrt(0.75))) for z in (0.0, 30.0)])
        turn = np.linspace(0, 2 * np.pi, 4000)
        x, y = seen[np.argmax(seen @ np.array((np.cos(turn), np.sin(turn))), axis=0)].T
        total += abs(np.sum(x * np.roll(y, 1) - y * np.roll(x, 1))) / 2
    return total


@pytest.mark.parametrize("angle", [0.0, 0.6, 1.5708, 2.5, 4.0])
def test_drawn_area_of_a_straight_motion_is_its_outline(angle):
    along, across = np.array((np.cos(angle), np.sin(angle))), np.array((-np.sin(angle), np.cos(angle)))
    turn = np.linspace(-np.pi / 2, np.pi / 2, 200)[:, None]
    front = 3.0 * (np.cos(turn) * along + np.sin(turn) * across)
    there = dict(zip("XY", 20.0 * along))
    rows = [("G0", {"X": 0.0, "Y": 0.0, "Z": 10.0}), ("G1", there), ("G1", {"Z": 0.0})]
    made = motions(linearize(rows))
    with np.errstate(all="raise"):
        line, plunge = opengl_work(made, diameter=6.0).area
    swept = [end * 20.0 * along + side * 3.0 * across for end in (0, 1) for side in (-1, 1)]
    assert line == pytest.approx(outline(swept, front), rel=0.002)
    assert plunge == pytest.approx(outline(np.concatenate((front, -front))), rel=0.002)


def test_drawn_area_of_an_arc_is_the_area_of_its_chords_and_tool():
    tool = opengl_work(motions(linearize([("G0", {"Z": 10.0}), ("G1", {"Z": 0.0})])), diameter=6.0).area[-1]
    small = opengl_work(motions(linearize(arcs(1, 2.0))), diameter=6.0)
    assert small.area[-1] == pytest.approx(9 * tool)
    # The half circles are drawn with 63 and 5 boxes, each rotated against the previous box, and with the tool at the
    # end.
    for radius, diameter, boxes, off in ((10.0, 6.0, 63, 0.005), (0.8, 1.0, 5, 0.05)):
        rows = [("G0", {"Z": 10.0}), ("G1", {"Z": 0.0}), *arcs(1, radius)]
        work = opengl_work(motions(linearize(rows)), diameter=diameter)
        side, turns = np.array((0, np.pi * radius / boxes)), (np.arange(boxes) + 0.5) * np.pi / boxes
        base = np.column_stack((side[[0, 1, 1, 0]], np.array((-1, -1, 1, 1)) * diameter / 2))
        seen = outline(*(base @ np.array(((np.cos(t), np.sin(t)), (-np.sin(t), np.cos(t)))) for t in turns))
        assert work.steps[-1] == boxes + 1 and work.area[-1] == pytest.approx(seen + work.area[0], rel=off)


def play(path, diameter, speed, constants):
    """Return the duration of a play in which each frame draws all cuts so far, like FreeCAD's simulator."""
    drawn = [0.0]  # Cost of a frame after each step, in draw calls; it includes the time to fill the drawn area.
    made = motions(path)
    # At a distance of 160 mm, the window shows an angle of 0.7 rad vertically, and its width is four thirds of its
    # height.
    window = 1.819 * 100.0**2
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
def test_play_takes_the_sum_of_its_frames(speed):
    software = Constants(refresh=0.02, frame=0.01, draw=25e-6)
    path = linearize(zigzag(60) + arcs(40, 5.0) + arcs(40, 2.0))
    predicted = opengl_cost(Task(path, TOOL, STOCK), speeds=(speed,), constants=software).play_seconds[speed]
    assert predicted == pytest.approx(play(path, 6.0, speed, software), rel=0.02)


def test_unfinished_arc_is_drawn_up_to_the_current_step():
    """On average, half of the arc is drawn.

    The distance of the camera is computed from the sides of the stock in X and Y.
    """
    path, only = linearize(arcs(1, 20.0)[1:]), Constants(refresh=0.0, frame=0.0)
    low, high = (
        opengl_cost(Task(path, TOOL, Stock((0, 0, 0), (100, 60, height))), speeds=(1,), constants=only)
        for height in (20, 500)
    )
    assert low == high and low.arc_draws == low.draws
    assert low.play_seconds[1] == pytest.approx(low.steps * low.drawing_seconds / 2)


def test_wide_and_long_cuts_take_longer_to_draw():
    path, only = linearize(zigzag(60)), Constants(refresh=0.0, frame=0.0)
    wide, narrow = (opengl_cost(Task(path, Tool("endmill", d), STOCK), constants=only) for d in (12.0, 3.0))
    assert wide.draws == narrow.draws and wide.frame_seconds > 1.2 * narrow.frame_seconds
    short = opengl_cost(Task(linearize(zigzag(60, width=8.0)), Tool("endmill", 3.0), STOCK), constants=only)
    assert short.draws == narrow.draws and narrow.frame_seconds > 1.4 * short.frame_seconds


def test_rounded_tools_take_longer_to_draw():
    rounded = Tool("bullnose", 6.0, corner_radius=1.0), Tool("ballend", 6.0), Tool("ballend", 10.0)
    tools = TOOL, Tool("vbit", 6.0), *rounded
    assert [outline_segments(tool) for tool in tools] == [2, 2, 6, 11, 17]
    path, only = linearize(zigzag(60)), Constants(refresh=0.0, frame=0.0)
    flat, ball = (opengl_cost(Task(path, tool, STOCK), constants=only) for tool in (TOOL, Tool("ballend", 6.0)))
    assert ball.draws == flat.draws and ball.frame_seconds == pytest.approx(1.9 * flat.frame_seconds)


def test_play_time_grows_with_the_square_of_the_motions():
    slow = Constants(refresh=0.0, frame=0.0, draw=1e-3)
    once = opengl_cost(Task(linearize(zigzag(200, pitch=0.1)), TOOL, STOCK), constants=slow).play_seconds[1]
    twice = opengl_cost(Task(linearize(zigzag(400, pitch=0.1)), TOOL, STOCK), constants=slow).play_seconds[1]
    assert twice / once == pytest.approx(4, rel=0.05)


def test_drawing_earlier_cuts_takes_no_time_while_frames_wait():
    """Two operations have 100 steps each.

    In the first operation, each frame waits 1 s for the screen, and drawing takes up to 1 s.
    A frame of the second operation takes 1.5 s on average: 1 s for the first operation, and half of its own 1 s.
    """
    waiting = Constants(refresh=1.0, frame=0.0)
    one = replace(
        opengl_cost(Task(linearize(zigzag(4)), TOOL, STOCK), speeds=(1, 10), constants=waiting),
        drawing_seconds=1.0, steps=100, play_seconds={1: 100.0, 10: 10.0},
    )  # fmt: skip
    both = opengl_together([one, one])
    assert both.play_seconds == pytest.approx({1: 2 * 100 + 50, 10: 2 * 10 + 5}, rel=1e-6)
    assert (both.drawing_seconds, both.steps, both.draws) == (2.0, 200, 2 * one.draws)


def test_two_halves_played_in_sequence_take_as_long_as_the_whole():
    whole = opengl_cost(Task(linearize(zigzag(400)), TOOL, STOCK), speeds=(10,))
    assert opengl_together([whole]) == whole
    half = opengl_cost(Task(linearize(zigzag(200)), TOOL, STOCK), speeds=(10,))
    both = opengl_together([half, half])
    assert both.play_seconds[10] == pytest.approx(whole.play_seconds[10], rel=0.03)
    assert both.frame_seconds == pytest.approx(whole.frame_seconds, rel=0.01)
