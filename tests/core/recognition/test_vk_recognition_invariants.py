# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strategy does not depend on the position, size, direction and number of moves of a toolpath."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import programs
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from vkworkbench.core import linearize, recognize

TOOL = 5.0
CLEAR = programs.CLEAR
angles, sizes = st.floats(-np.pi, np.pi), st.floats(0.1, 50)
steps = st.floats(0.5, 4.0)
depths = st.lists(st.integers(-9, 0), min_size=1, max_size=3, unique=True).map(lambda z: sorted(map(float, z))[::-1])

ARGUMENTS = {
    "zigzag": (st.integers(6, 30), st.floats(40, 200), steps, depths),
    "one-way": (st.integers(6, 30), st.floats(40, 200), steps, depths),
    "contour-parallel": (st.integers(3, 9), st.integers(3, 40), steps, st.floats(6, 20), depths, st.floats(0, 50)),
    "profile": (st.integers(3, 60), st.floats(15, 100), depths, st.floats(0, 0.3)),
    "waterline": (st.integers(8, 15), st.integers(8, 60), st.floats(35, 60), st.floats(0.5, 2)),
    "spiral": (st.integers(5, 12), steps, st.integers(24, 72)),
    "helix": (st.integers(4, 15), st.floats(4, 30), st.floats(0.3, 3)),
    "drilling": (st.integers(2, 6), st.integers(2, 6), st.floats(6, 30), st.sampled_from(["G81", "G82", "G83", "G73", "G85"])),
    "adaptive": (st.integers(20, 60), st.floats(5, 12), st.floats(0.5, 1.5)),
    "engraving": (st.integers(8, 16),),
}  # fmt: skip
anything = st.sampled_from(sorted(ARGUMENTS)).flatmap(
    lambda name: st.tuples(st.just(name), st.tuples(*ARGUMENTS[name]))
)


def commands_of(made):
    name, arguments = made
    return programs.SOUND[name](*arguments)


def path_of(made):
    """Return a program's toolpath and its recognition, which must find the intended strategy of the program."""
    path = linearize(commands_of(made))
    found = recognize(path, tool_diameter=TOOL)
    assert found.strategy == made[0], found.reason
    return path, found


def moved(path, points):
    return replace(path, points=np.ascontiguousarray(points))


def turned(path, angle):
    c, s = np.cos(angle), np.sin(angle)
    return moved(path, path.points @ np.array([(c, s, 0), (-s, c, 0), (0, 0, 1)]))


def backwards(path):
    return replace(path, points=path.points[::-1], rapid=path.rapid[::-1], feed=path.feed[::-1], sweep=-path.sweep[::-1],
                   plane=path.plane[::-1], cycle=path.cycle[::-1], comments=())  # fmt: skip


def split(path, parts):
    """Return the toolpath with each trajectory divided into `parts` equal parts, (n,) int."""
    of = np.repeat(np.arange(len(path)), parts)
    share = (np.arange(len(of)) - np.repeat(np.cumsum(parts) - parts, parts) + 1) / parts[of]
    points = path.points[of] + share[:, None] * (path.points[of + 1] - path.points[of])
    points[share == 1] = path.points[1:]
    return replace(path, points=np.vstack([path.points[:1], points]), rapid=path.rapid[of], command=path.command[of],
                   feed=path.feed[of], sweep=path.sweep[of] / parts[of], plane=path.plane[of], cycle=path.cycle[of],
                   comments=())  # fmt: skip


def same_level(one, other, sign=1):
    # If phi ends exactly at a whole turn, rounding decides whether phi reaches the next level.
    whole = min(abs(abs(phi) % (2 * np.pi) - np.pi) for phi in one.phi_range) > 3.14
    assert other.level == sign * one.level or whole


@given(anything, angles, st.tuples(st.floats(-1e3, 1e3), st.floats(-1e3, 1e3), st.floats(-50, 50)))
def test_rotated_and_moved_toolpath_keeps_its_strategy(made, angle, shift):
    path, found = path_of(made)
    again = recognize(moved(path, turned(path, angle).points + shift), tool_diameter=TOOL)
    assert again.strategy == found.strategy
    assert again.confidence == pytest.approx(found.confidence, abs=0.05)
    same_level(found, again)
    assert again.sense == found.sense
    if found.direction is not None and again.direction is not None:
        assert abs(np.sin(again.direction - found.direction - angle)) < 1e-3
    if found.stepover is not None and made[0] in ("zigzag", "one-way"):
        assert again.stepover == pytest.approx(found.stepover, rel=1e-3)


@given(anything, sizes)
def test_toolpath_scaled_with_its_tool_keeps_its_strategy(made, scale):
    path, found = path_of(made)
    # Tolerances are absolute lengths, so the strategy may change if a part becomes as small as the tolerances.
    assume(scale >= 1 or (scale * path.lengths[~path.rapid]).min() > 0.2)
    again = recognize(moved(path, scale * path.points), tool_diameter=scale * TOOL)
    assert again.strategy == found.strategy
    same_level(found, again)
    if found.stepover is not None:
        assert again.stepover == pytest.approx(scale * found.stepover, rel=1e-3)


@given(anything)
def test_reversed_toolpath_keeps_strategy_and_negates_phi(made):
    path, found = path_of(made)
    again = recognize(backwards(path), tool_diameter=TOOL)
    assert again.strategy == found.strategy
    if made[0] in ("contour-parallel", "profile", "waterline", "spiral", "helix"):
        assert {found.sense, again.sense} == {"ccw", "cw"}
        same_level(found, again, -1)


@pytest.mark.long
@given(anything, angles)
def test_mirrored_toolpath_keeps_strategy_and_negates_phi(made, angle):
    path, found = path_of(made)
    path = turned(path, angle)
    again = recognize(replace(path, points=path.points * (1, -1, 1), sweep=-path.sweep), tool_diameter=TOOL)
    assert again.strategy == found.strategy
    same_level(found, again, -1)
    if found.sense is not None:
        assert {found.sense, again.sense} == {"ccw", "cw"}


@pytest.mark.long
@given(anything, st.data())
def test_toolpath_of_divided_moves_keeps_its_strategy(made, data):
    path, found = path_of(made)
    few = data.draw(st.lists(st.integers(1, 5), min_size=1, max_size=20))
    again = recognize(split(path, np.resize(few, len(path))), tool_diameter=TOOL)
    assert again.strategy == found.strategy
    same_level(found, again)
    if found.strategy != "adaptive":  # Some bites overlap only just enough to be recognised as bites.
        assert again.passes == found.passes


@pytest.mark.long
@given(anything)
def test_toolpath_rounded_to_six_decimals_keeps_its_strategy(made):
    _, found = path_of(made)
    rounded = [
        (code, {letter: round(value, 6) for letter, value in words.items()}) for code, words in commands_of(made)
    ]
    again = recognize(linearize(rounded), tool_diameter=TOOL)
    assert (again.strategy, again.passes) == (found.strategy, found.passes)


def programs_of_arcs(turns, radius, pitch):
    """Return a pocket of circles and a bore, both made of arcs."""
    circles = []
    for i in range(turns):
        r = radius + 3.0 * i
        circles += [("G1", {"X": r, "Y": 0.0, "Z": 0.0, "F": 5.0})]
        circles += [
            ("G3", {"X": -r, "Y": 0.0, "I": -r, "J": 0.0}),
            ("G3", {"X": r, "Y": 0.0, "I": r, "J": 0.0}),
        ]
    start = [("G0", {"Z": CLEAR}), ("G0", {"X": radius, "Y": 0.0})]
    return {"contour-parallel": start + circles, "helix": programs.helix(turns, radius, pitch)}


@pytest.mark.long
@given(st.integers(4, 9), st.floats(4, 30), st.floats(0.3, 3), st.floats(1e-3, 0.2))
def test_strategy_does_not_depend_on_arc_tolerance(turns, radius, pitch, tolerance):
    for name, commands in programs_of_arcs(turns, radius, pitch).items():
        found = [recognize(linearize(commands, tolerance=t), tool_diameter=TOOL) for t in (0.01, tolerance)]
        assert [f.strategy.value for f in found] == [name, name]
        assert found[0].passes == found[1].passes
        same_level(*found)


@given(st.integers(3, 60), st.integers(0, 59), st.floats(15, 100), st.floats(0, 0.3), depths)
def test_strategy_does_not_depend_on_start_of_a_contour(sides, start, radius, waves, depths):
    found = []
    for s in (0, start % sides):
        strokes = [programs.outline(sides, radius, z=z, waves=waves, start=s) for z in depths]
        found.append(recognize(linearize(programs.program(strokes)), tool_diameter=TOOL))
    one, other = found
    assert (one.strategy.value, one.sense, one.closed_loops) == ("profile", "ccw", len(depths))
    assert (other.strategy, other.sense, other.closed_loops) == (one.strategy, one.sense, one.closed_loops)
    same_level(one, other)


@given(st.integers(4, 9), st.integers(3, 40), st.integers(0, 39), steps)
def test_strategy_does_not_depend_on_start_of_nested_contours(loops, sides, start, step):
    found = []
    for s in (0, start % sides):
        rings = [programs.outline(sides, 8 + i * step, start=s) for i in range(loops)]
        found.append(recognize(linearize(programs.program(rings)), tool_diameter=TOOL))
    assert [(f.strategy.value, f.sense, f.passes) for f in found] == [("contour-parallel", "ccw", loops)] * 2


@pytest.mark.long
@pytest.mark.parametrize("short", [0.013, 0.0157, 0.0176, 0.0195, 0.024])
@given(st.integers(3, 9), st.integers(3, 12), angles)
@settings(max_examples=25)
def test_loops_that_close_with_a_tiny_move_are_offsets(short, loops, sides, angle):
    path = turned(linearize(programs.offsets(loops, sides, inner=8.0, longer=short)), angle)
    for way, sign in ((path, 1), (backwards(path), -1)):
        found = recognize(way, tool_diameter=TOOL)
        assert found.strategy.value == "contour-parallel" and np.sign(found.level) == sign, found.reason
        assert 0.75 * loops <= found.closed_loops <= loops


@given(anything)
@settings(max_examples=25)
def test_strategy_does_not_depend_on_a_known_tool(made):
    path, found = path_of(made)
    # If the tool is unknown, three loops may also be three separate contours.
    if found.strategy != "contour-parallel" or found.passes > 3:
        assert recognize(path).strategy == found.strategy


@pytest.mark.parametrize("name", programs.SOUND)
def test_impossible_tool_diameter_counts_as_unknown(name):
    path = linearize(programs.SOUND[name]())
    without = recognize(path)
    for impossible in (0.0, -1.0, float("nan"), float("inf")):
        assert recognize(path, tool_diameter=impossible) == without


@given(anything)
@settings(max_examples=25)
def test_commands_before_and_after_the_cuts_do_not_matter(made):
    commands = commands_of(made)
    found = recognize(linearize(commands), tool_diameter=TOOL)
    around = [("(Created by hand)", {}), ("G21", {}), ("G90", {}), ("M3", {"S": 5000.0}), ("G0", {"X": -77.0, "Y": 55.0, "Z": CLEAR}),
              *commands, ("G0", {"X": 0.0, "Y": 0.0}), ("M5", {}), ("M30", {})]  # fmt: skip
    again = recognize(linearize(around), tool_diameter=TOOL)
    assert (again.strategy, again.passes, again.sense) == (found.strategy, found.passes, found.sense)
