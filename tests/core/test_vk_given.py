# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors for wrong arguments name the argument, the accepted values, and the given value."""

import re
from math import inf, nan

import numpy as np
import pytest

import vkworkbench
from vkworkbench.core import (
    MACHINES,
    Cut,
    Cylinder,
    Mesh,
    Stock,
    Tool,
    Toolpath,
    View,
    best_resolution,
    cauchy_crofton,
    complexity,
    estimate,
    exact_lengths,
    linearize,
    machine_of_grbl,
    machining,
    recognize,
    seconds_of_dwells,
    signature,
    simulate,
    simulate_job,
    stock_around,
    trajectory_seconds,
)
from vkworkbench.core.zbuffer import CrashCheck, estimate_job, facts, memory_needed
from vkworkbench.given import not_negative, positive
from vkworkbench.report import Report

PATH = linearize([("G0", {"X": 0, "Y": 0, "Z": 5}), ("G1", {"Z": -1, "F": 5}), ("G1", {"X": 50})])
TOOL, STOCK, VIEW = Tool("endmill", 6), Stock((-5, -5, -5), (55, 5, 0)), View(width=30, height=20)
WITH = {"tool": TOOL, "stock": STOCK, "view": VIEW}
FOUND = estimate(PATH, None, **WITH)
DONE = simulate(PATH, **WITH)
REPORT = Report((), {}, {})
MEMORY = {"memory_bytes": 1e9}


class Quantity:
    """An object that behaves as a number, like FreeCAD's quantities."""

    def __init__(self, value):
        self.value = value

    def __float__(self):
        return self.value


# Functions with an argument that must be a finite number, and not negative, by the name of this argument.
NUMBERS = {
    "memory_budget": lambda given: simulate(PATH, **WITH, memory_budget=given),
    "tolerance": lambda given: facts(DONE, CrashCheck(), tolerance=given),
    " tolerance": lambda given: linearize([], tolerance=given),
    "horizontal_rapid": lambda given: machining(PATH, horizontal_rapid=given),
    "vertical_rapid": lambda given: trajectory_seconds(PATH, vertical_rapid=given),
    "memory_bytes": lambda given: best_resolution([FOUND], memory_bytes=given),
    "seconds": lambda given: best_resolution([FOUND], memory_bytes=1e9, seconds=given),
    "stepover": lambda given: best_resolution([FOUND], memory_bytes=1e9, stepover=given),
    "pixel": lambda given: View(pixel=given),
}


@pytest.mark.parametrize("name", NUMBERS)
@pytest.mark.parametrize("given", ["much", -1, float("nan"), [1], {}, 1j, 10**400])
def test_bad_number_raises_an_error_with_its_name(name, given):
    with pytest.raises((ValueError, TypeError), match=f"^{name.strip()} must be .*, not "):
        NUMBERS[name](given)


@pytest.mark.parametrize(
    ("name", "given", "use"),
    [
        ("top", "much", lambda given: machining(PATH, top=given)),
        ("direction", float("nan"), lambda given: cauchy_crofton(PATH, stock=STOCK, view=VIEW, direction=given)),
        ("tool_diameter", [6], lambda given: recognize(PATH, tool_diameter=given)),
        ("vertical_feed", "fast", lambda given: Cut(PATH, TOOL, given)),
        ("diameter", "6 mm", lambda given: Tool("endmill", given)),
        ("corner_radius", None, lambda given: Tool("bullnose", 6, given)),
        ("tip_angle", "60°", lambda given: Tool("vbit", 6, 0, given)),
        ("radius", "wide", lambda given: Cylinder((0, 0, 0), given, 1)),
        ("height", None, lambda given: Cylinder((0, 0, 0), 1, given)),
        ("base", (1, 2), lambda given: Cylinder(given, 1, 1)),
        ("lower", 0, lambda given: Stock(given, (1, 1, 1))),
        ("upper", "abc", lambda given: Stock((0, 0, 0), given)),
        ("triangles", [[1, 2, 3]], Mesh),
        ("points", "square", Toolpath.through),
        ("points", [(0, 0, 0, 0)], Toolpath.through),
        ("points", [(0, 0, 0), (float("inf"), 0, 0)], Toolpath.through),
        ("points", [(0, 0, 0), (1e7, 0, 0)], Toolpath.through),
        ("points", [(0, 0), (1, "x")], signature),
        ("points", [{}], complexity),
        ("direction", "Top", View),
        ("offset", 3, lambda given: View(offset=given)),
        ("offset", (1, float("inf")), lambda given: View(offset=given)),
        ("width", 0.5, lambda given: View(width=given)),
        ("step", 0.5, DONE.at),
        ("step", "1", DONE.at),
        # The number -1 stands for uncut stock, and not for a trajectory.
        ("first", -1, lambda given: DONE.chips(given, 2)),
        ("end", 3, lambda given: DONE.chips(0, given)),
        ("trajectory", 1.5, DONE.cuts.source),
        ("processes", 0, lambda given: simulate(PATH, **WITH, processes=given)),
        ("processes", "two", lambda given: simulate(PATH, **WITH, processes=given)),
    ],
)
def test_bad_argument_raises_an_error_with_its_name(name, given, use):
    with pytest.raises((ValueError, TypeError), match=f"^{name} must be .*, not {re.escape(repr(given))}$"):
        use(given)


@pytest.mark.parametrize(
    ("what", "use"),
    [
        ("a toolpath", exact_lengths),
        ("a toolpath", trajectory_seconds),
        ("a toolpath", lambda given: stock_around(given, TOOL)),
        ("a toolpath", lambda given: cauchy_crofton(given, stock=STOCK, view=VIEW)),
        ("a tool", lambda given: stock_around(PATH, given)),
        ("a job", lambda given: simulate_job(given, stock=STOCK, view=VIEW)),
        ("each of a job", lambda given: estimate_job([given], stock=STOCK, view=VIEW)),
        *(
            (name, lambda given, use=use, name=name: use(**{"stock": STOCK, "view": VIEW, name: given}))
            for name in ("stock", "view")
            for use in (
                lambda **given: simulate(PATH, tool=TOOL, **given),
                lambda **given: estimate(PATH, None, tool=TOOL, **given),
                lambda **given: memory_needed([Cut(PATH, TOOL)], **given),
                lambda **given: cauchy_crofton(PATH, **given),
            )
        ),
        ("going_on", lambda given: simulate(PATH, **WITH, going_on=given)),
        ("recognition", lambda given: estimate(PATH, given, **WITH)),
        ("speed", lambda given: estimate(PATH, None, **WITH, speed=given)),
        ("estimates", lambda given: best_resolution(given, **MEMORY)),
        ("an estimate", lambda given: best_resolution([given], **MEMORY)),
        ("an estimate", lambda given: best_resolution([FOUND], **MEMORY, whole=given)),
        ("progress", lambda given: vkworkbench.analyze("no.nc", progress=given)),
        ("cancelled", lambda given: vkworkbench.analyze("no.nc", cancelled=given)),
        ("a toolpath", seconds_of_dwells),
        ("machine", lambda given: seconds_of_dwells(PATH, machine=given)),
        ("settings", lambda given: machine_of_grbl(given, MACHINES["hobby-router"])),
        ("otherwise", lambda given: machine_of_grbl("$110=1", given)),
        ("each tool", lambda given: vkworkbench.simulate("no.nc", tool={1: given})),
        ("clamps", lambda given: vkworkbench.simulate("no.nc", clamps=given)),
        ("each clamp", lambda given: vkworkbench.simulate("no.nc", clamps={"vice": given})),
        ("the name of a clamp", lambda given: vkworkbench.simulate("no.nc", clamps={given: STOCK})),
        ("path", REPORT.to_csv),
        ("path", REPORT.to_json),
        ("facts", REPORT.with_facts),
    ],
)
def test_argument_of_wrong_type_raises_a_type_error(what, use):
    with pytest.raises(TypeError, match=f"^{what} is .*, not int$"):
        use(6)


def test_number_like_values_are_accepted():
    assert linearize([], tolerance="0.1").commands == 0
    assert View(pixel=Quantity(0.5)).pixel == 0.5 and View(offset=np.array([1, 2])).offset == (1.0, 2.0)
    assert best_resolution([FOUND], memory_bytes=Quantity(1e8)).memory_bytes <= 1e8
    assert simulate(PATH, **WITH, memory_budget=float("inf"), processes=np.int64(1)).at(np.int64(1)).step == 1
    assert facts(DONE, CrashCheck(), tolerance=Quantity(0.0)).job.removed_volume > 0


@pytest.mark.parametrize(
    ("value", "is_positive", "is_not_negative"),
    [
        (-inf, False, False), (-5e-324, False, False), (-0.0, False, True), (0, False, True),
        (5e-324, True, True), (0.5, True, True), (1, True, True), (1.7e308, True, True), (inf, False, False), (nan, False, False),
    ],
)  # fmt: skip
def test_positive_and_not_negative_numbers_are_finite(value, is_positive, is_not_negative):
    assert (positive(value), not_negative(value)) == (is_positive, is_not_negative)


def test_long_argument_is_shortened_in_the_error():
    with pytest.raises(ValueError, match=r"not \[0, 1, 2, 3, 4, 5, \.\.\.\]$"):
        Stock(list(range(10**5)), (1, 1, 1))
