# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cautions before a simulation: each problem is found, and a sound program gets no caution."""

from __future__ import annotations

import importlib
import math
import re
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from vkworkbench.core import Stock, Tool, View
from vkworkbench.core.gcode import Words, linearize
from vkworkbench.core.recognition import recognize
from vkworkbench.core.simulators.constants import Constants
from vkworkbench.core.simulators.legacy import legacy_cost
from vkworkbench.core.simulators.opengl import opengl_cost, slow_frames
from vkworkbench.core.simulators.preflight import preflight
from vkworkbench.core.simulators.simulator import Caution, Conditions, Task
from vkworkbench.core.simulators.table import available, predict
from vkworkbench.core.zbuffer import estimate
from vkworkbench.language import Message, render

# A plain import would return the function `preflight`, which has the same name as its module.
PREFLIGHT = importlib.import_module("vkworkbench.core.simulators.preflight")

START = ("G0", {"X": 10.0, "Y": 0.0, "Z": 5.0})
HALF = {"X": -10.0, "Y": 0.0, "Z": 5.0, "I": -10.0, "J": 0.0}
STOCK = Stock((-50, -50, 0), (50, 50, 20))


def check(commands, version=(1, 0), *, diameter=None, memory_budget=1e9, **costs):
    words = Words(commands)
    task = Task(linearize(words), diameter and Tool("endmill", diameter), STOCK, words)
    return preflight(task, costs, Conditions(version=version, memory_budget=memory_budget))


def without(*letters):
    return {letter: value for letter, value in HALF.items() if letter not in letters}


def test_sound_arc_and_line_give_no_caution():
    commands = [START, ("G3", HALF), ("G1", {"X": 40.0, "F": 5.0})]
    assert check(commands, diameter=6.0) == ()
    assert check([], diameter=6.0) == ()


@pytest.mark.parametrize("version, hangs", [((0, 20), True), ((1, 0), True), ((1, 1), False)])
def test_arc_without_z_hangs_the_simulator_before_1_1(version, hangs):
    found = check([START, ("G3", without("Z")), ("G2", {**without("Z"), "X": 10.0, "I": 10.0})], version)
    assert bool(found) == hangs
    if hangs:
        assert found[0].code == "legacy-hangs" and found[0].command == 1
        assert "without a Z word (command 2 and 1 more)" in found[0].message
        assert ("OpenGL" in found[0].message) == (version >= (1, 0))


@pytest.mark.parametrize("version", [(0, 20), (1, 0), (1, 1)])
@pytest.mark.parametrize("arc, reason", [
    (without("Y"), "without an X or Y word"),
    ({**without("I", "J"), "R": 10.0}, "without a center"),
    ({**HALF, "X": 10.0}, "full circle"),
    ({**HALF, "X": 12.0}, "sweeps no angle"),
    ({**HALF, "X": 8.0, "I": 10.0}, "sweeps no angle"),
])  # fmt: skip
def test_arcs_that_hang_the_simulator_of_every_version(version, arc, reason):
    found = check([("(arc)", {}), START, ("G3", arc)], version)
    assert [(one.code, one.command) for one in found] == [("legacy-hangs", 2)]
    assert reason in found[0].message


def test_arc_without_sweep_below_its_start_hangs():
    start = ("G0", {"X": 0.0, "Y": 10.0, "Z": 5.0})
    (found,) = check([start, ("G3", {"X": 0.0, "Y": 12.0, "Z": 5.0, "I": 0.0, "J": -10.0})])
    assert "sweeps no angle" in found.message
    assert check([start, ("G3", {"X": -10.0, "Y": 0.0, "Z": 5.0, "I": 0.0, "J": -10.0})]) == ()


def test_arc_begins_where_the_line_before_it_ends():
    """The arc is a quarter turn around (0, 0) from the line's end (0, 10), and not from the line's start (10, 0)."""
    line = ("G1", {"X": 0.0, "Y": 10.0, "F": 5.0})
    assert check([START, line, ("G2", {"X": 10.0, "Y": 0.0, "Z": 5.0, "I": 0.0, "J": -10.0})]) == ()


def test_arc_with_a_k_word_of_0_counts_as_without_a_center():
    (found,) = check([START, ("G3", {**without("I", "J"), "K": 0.0})], (1, 1))
    assert "without a center" in found.message


def test_arcs_with_a_k_word_do_not_hang():
    assert check([START, ("G3", {**without("Z"), "K": 1.0})]) == ()


def test_long_ramp_is_cut_at_the_wrong_depth():
    commands = [("G0", {"X": 0.0, "Y": 0.0, "Z": 20.0}), ("G1", {"X": 60.0, "Z": 15.0, "F": 5.0})]
    (found,) = check(commands, diameter=8.0)
    assert found.code == "legacy-ramp" and found.command == 1
    # The ramp falls 5 mm over 60 mm with a tool of 8 mm, so it is cut 5 * (60 / 8 - 1) = 32.5 mm too deep.
    assert "32 mm too deep" in found.message or "33 mm too deep" in found.message
    # The caution names the ramp with the largest error of several ramps. The text of the caution numbers commands from
    # one.
    (found,) = check([*commands, ("G1", {"X": 0.0, "Z": 25.0})], diameter=8.0)
    assert (found.what.arguments["count"], found.what.arguments["command"], found.command) == (2, 3, 1)
    assert "too high" in found.message
    (found,) = check([commands[0], ("G1", {"X": 90.0, "Z": 20.9, "F": 5.0})], diameter=8.0)
    assert "too high" in found.message


def test_rising_rapid_is_not_a_ramp():
    assert check([("G0", {"X": 0.0, "Y": 0.0, "Z": 20.0}), ("G0", {"X": 90.0, "Z": 20.9})], diameter=8.0) == ()


def test_slopes_plunges_helices_and_lifts_are_not_ramps():
    points = np.linspace(0, 40, 81)
    surface = [("G1", {"X": x, "Z": 15 + math.sin(x / 5), "F": 5.0}) for x in points.tolist()]
    assert check([("G0", {"X": 0.0, "Y": 0.0, "Z": 20.0})] + surface, diameter=8.0) == ()
    assert check([START, ("G1", {"Z": -5.0}), ("G3", {**HALF, "Z": -8.0})], diameter=8.0) == ()
    assert check([START, ("G0", {"X": 90.0, "Z": 25.0})], diameter=8.0) == ()


def zigzag(rows):
    return [START] + [("G1", {"X": 10.0 + 20 * (i % 4 in (0, 1)), "Y": 0.001 * i, "F": 5.0}) for i in range(rows)]


def test_long_play_has_a_caution_that_names_a_faster_way():
    commands = zigzag(20000)
    path = linearize(commands)
    legacy = legacy_cost(Task(path, Tool("endmill", 6.0), STOCK))
    opengl = opengl_cost(Task(path, Tool("endmill", 6.0), STOCK), constants=Constants(refresh=0.035, draw=25e-6))
    found = [one for one in check(commands, (1, 1), legacy=legacy, OpenGL=opengl) if one.code == "long-play"]
    # The times are 25 ms for each of 20,001 commands, and 27 ns for each of a million cells of the mesh, plus
    # triangles.
    assert len(found) == 2
    assert re.search(
        r"about 20 min in the legacy simulator\. Use fast-forward, which takes about [23]0 s\.", found[0].message
    )
    only_legacy = check(commands, (0, 20), legacy=legacy, OpenGL=opengl)
    assert [one.code for one in only_legacy if one.code == "long-play"] == ["long-play"]


def test_arcs_that_dominate_slow_frames_are_named():
    arcs = [START] + [("G3", HALF), ("G3", {"X": 10.0, "Y": 0.0, "Z": 5.0, "I": 10.0, "J": 0.0})] * 1000
    few, many = (opengl_cost(Task(linearize(path), Tool("endmill", 6.0), STOCK)) for path in (arcs[:5], arcs))
    assert re.search(r"slows to about 0\.\d frames per second at the end of this job", render(slow_frames(many)))
    assert slow_frames(few) is None and check(arcs[:5], OpenGL=few) == ()


def test_thousands_of_short_moves_give_a_caution():
    commands = [START] + [("G1", {"X": 10.0 + 0.01 * i, "F": 5.0}) for i in range(1, 3000)]
    path = linearize(commands)
    legacy = legacy_cost(Task(path, Tool("endmill", 6.0), STOCK))
    (found,) = check(commands, legacy=legacy)
    assert found.code == "short-moves" and found.message.startswith(
        "2,999 moves are shorter than a cell of the legacy simulator (0.1 mm)"
    )
    assert len(check(commands[:2002], legacy=legacy)) == 1 and check(commands[:2001], legacy=legacy) == ()


@pytest.mark.parametrize("memory, too_much", [(0.9e9, False), (1.1e9, True)])
def test_default_memory_budget_is_a_gigabyte(memory, too_much):
    cost = SimpleNamespace(memory_bytes=memory, play_seconds=1.0, resolution=0.1)
    found = preflight(Task(linearize([])), {"legacy": cost}, Conditions(version=(1, 0)))
    assert [one.code for one in found] == ["memory"] * too_much
    assert all("1.1 GB" in str(one) and "1 GB" in str(one) for one in found)


def test_default_cell_is_a_thousandth_of_the_longer_side():
    """FreeCAD's accuracy slider has the same default. A stock of 100 x 60 mm has 1001 x 601 corners."""
    task = Task(
        linearize([START, ("G1", {"X": 20.0, "F": 5.0})]), Tool("endmill", 6.0), Stock((0, 0, 0), (100, 60, 20))
    )
    assert predict(task, Conditions(version=(1, 0)))[0]["legacy"].cells == 1001 * 601


def test_memory_beyond_the_budget_gives_a_caution():
    commands = zigzag(100)
    path = linearize(commands)
    tool = Tool("endmill", 6.0)
    legacy = legacy_cost(Task(path, tool, STOCK))
    costs = {
        "z-buffer": estimate(path, recognize(path), tool=tool, stock=STOCK, view=View(width=80, height=60)),
        "legacy": legacy,
        "OpenGL": opengl_cost(Task(path, Tool("endmill", 6.0), STOCK)),
    }
    found = check(commands, **costs, memory_budget=1e4)
    assert [(one.code, one.message.split()[1]) for one in found] == [
        ("memory", "Simulate"),
        ("memory", "legacy"),
        ("memory", "OpenGL"),
    ]
    assert check(commands, **costs, memory_budget=1e8) == ()


def test_worst_caution_is_first(monkeypatch):
    """The order of the cautions does not depend on their simulators."""
    told = [Caution(code, Message("no-moves")) for code in ("short-moves", "legacy-ramp", "long-play", "legacy-hangs")]
    simulators = [
        replace(s, cautions=lambda *_, own=own: own) for s, own in zip(available((1, 1)), (told[:2], told[2:]))
    ]
    simulators[1] = replace(simulators[1], most_bytes=None)
    monkeypatch.setattr(PREFLIGHT, "available", lambda _: simulators)
    costs = {simulators[1].name: SimpleNamespace(memory_bytes=2e9)}
    found = preflight(Task(linearize([])), costs, Conditions(version=(1, 1), memory_budget=1e9))
    assert [caution.code for caution in found] == ["legacy-hangs", "memory", "long-play", "legacy-ramp", "short-moves"]
