# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quantities computed without rays: upper bound of the memory, whether a tool cuts, and crossings.

Crossings are counted between the toolpath and parallel lines that are one pixel apart.
"""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from zbuffer_inputs import toolpath

from toolpaths.synthetic import SAMPLES
from vkworkbench.core import Cylinder, Mesh, Stock, Tool, View, linearize, simulate
from vkworkbench.core.zbuffer import cauchy_crofton, cuts_surely, may_cut, most_bytes

TOOLS = [Tool("endmill", 5), Tool("ballend", 6), Tool("vbit", 8, tip_angle=np.pi / 2)]


@pytest.mark.long
@pytest.mark.parametrize("tool", TOOLS, ids=lambda tool: tool.shape)
@pytest.mark.parametrize("direction", [(0, 0, -1), (1, 1, -1), (0, 1, 0)])
def test_memory_of_a_simulation_is_at_most_the_upper_bound(tool, direction):
    rng = np.random.default_rng(7)
    bounds = 0
    for _, _, maker in SAMPLES[::6]:
        path = linearize(maker(rng))
        path = path.part(0, min(len(path), 100))
        if not len(path):
            continue
        lower, upper = path.points.min(axis=0) - 3, path.points.max(axis=0) + 3
        stock, view = Stock(lower, [*upper[:2], max(lower[2] + 1, 0.0)]), View(direction, 60, 45)
        held = simulate(path, tool=tool, stock=stock, view=view)
        most = most_bytes(path, tool=tool, stock=stock, view=view)
        assert held.peak.bytes() <= most
        bounds += np.isfinite(most)
        if cuts_surely(path, stock) and direction == (0, 0, -1):  # In a side view, a pixel may be larger than the cut.
            assert held.traces
    assert bounds > 5


@pytest.mark.parametrize("direction", [(0, 0, -1), (1, 1, -1), (0, 1, 0)])
def test_memory_of_round_stock_is_at_most_the_upper_bound(direction):
    path = linearize([("G1", {"X": x, "Y": y, "Z": -2.0}) for x, y in ((-12.0, 0.0), (12.0, 3.0), (0.0, -9.0))])
    stock = Cylinder((0, 0, -5), 10, 5)
    solids = {"tool": TOOLS[0], "stock": stock, "view": View(direction, 60, 45)}
    held = simulate(path, **solids)
    assert held.peak.bytes() <= most_bytes(path, **solids) < np.inf
    assert not cuts_surely(path, stock)


def test_mesh_stock_has_no_memory_bound_and_no_certain_cut():
    path = linearize([("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"Z": -2.0})])
    corners = np.array([(-9, -9, -5), (9, -9, -5), (0, 9, -5), (0, 0, 0)], float)
    mesh = Mesh(corners[np.array([(0, 1, 2), (0, 1, 3), (1, 2, 3), (2, 0, 3)])])
    assert most_bytes(path, tool=TOOLS[0], stock=mesh, view=View()) == np.inf and not cuts_surely(path, mesh)
    assert cuts_surely(path, Stock((-9, -9, -5), (9, 9, 0))) and not cuts_surely(path, Stock((1, 1, -5), (9, 9, 0)))


STOCK, PIXEL = Stock((0, 0, 0), (40, 30, 10)), View((0, 0, -1), 80, 60)  # The view has pixels of 0.5 mm.


def test_cut_is_certain_if_the_tip_moves_inside_the_stock():
    for point, surely in (((20, 15, 9.9), True), ((20, 15, 9.9995), False), ((-1, 15, 5), False), ((20, 31, 5), False),
                          ((41, 15, 5), False), ((20, -1, 5), False), ((20, 15, -5), True)):  # fmt: skip
        path = linearize([("G1", {"X": -50.0, "Y": -50.0, "Z": 50.0}), ("G1", dict(zip("XYZ", map(float, point))))])
        assert cuts_surely(path, STOCK) is surely, point


def test_move_may_cut_if_the_tool_reaches_the_stock():
    path = linearize([("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"X": 20.0}), ("G1", {"Z": 1.0})])
    tool = Tool("endmill", 10)
    for lower, upper, may in (
        ((0, 0, 0), (9, 9, 2), True), ((0, 0, 0), (9, 9, 1), False), ((0, 4.9, 0), (9, 9, 2), True), ((0, 5, 0), (9, 9, 2), False),
        ((24.9, 0, 0), (30, 9, 2), True), ((25, 0, 0), (30, 9, 2), False), ((-30, 0, 0), (-5, 9, 2), False),
    ):  # fmt: skip
        assert may_cut(path, tool, Stock(lower, upper)) is may, (lower, upper)
        assert not may_cut(linearize([]), tool, Stock(lower, upper))
        assert may or simulate(path, tool=tool, stock=Stock(lower, upper), view=View((0, 0, -1), 40, 40)).traces == 0


BLOCK = Stock((0, 0, 0), (80, 60, 20))


def path_of(points):
    return toolpath(np.array(points, float))


@pytest.mark.parametrize(
    ("theta", "projected"), [(0.0, 30), (pi / 2, 40), (np.arctan2(4, 3), 50), (np.arctan2(-3, 4), 0)]
)
def test_number_of_crossed_lines_is_the_projected_length(theta, projected):
    there_and_back = path_of([(10, 10, 5), (40, 50, 5), (10, 10, 5)])
    found = cauchy_crofton(there_and_back, stock=BLOCK, view=View(pixel=0.5), direction=theta)
    assert found == pytest.approx(2 * projected / 0.5)


def test_crossings_are_by_default_the_mean_over_all_directions():
    thetas = np.linspace(0, pi, 2000, endpoint=False)
    bent = path_of([(10, 10, 5), (40, 50, 5), (60, 20, 5)])
    one_each = [cauchy_crofton(bent, stock=BLOCK, view=View(pixel=0.5), direction=theta) for theta in thetas]
    assert np.mean(one_each) == pytest.approx(cauchy_crofton(bent, stock=BLOCK, view=View(pixel=0.5)), rel=1e-5)


def test_moves_above_the_stock_do_not_count_as_crossings():
    view = View(pixel=0.5)
    below = [(10, 10, 5), (40, 50, 5)]
    assert cauchy_crofton(path_of(below), stock=BLOCK, view=view) == pytest.approx(50 * 2 / pi / 0.5)
    # Seen from above, a plunge has no length, and therefore no crossings.
    on_top = [(70, 10, 20), (10, 10, 20), *below, (40, 50, 20), (70, 50, 20)]
    assert cauchy_crofton(path_of(on_top), stock=BLOCK, view=view) == pytest.approx(50 * 2 / pi / 0.5)
    for entered in ([(70, 10, 22), *below], [*below[::-1], (70, 10, 22)], [(70, 10, 22), *below, (40, 110, 22)]):
        length = np.hypot(*np.diff(np.array(entered)[:, :2], axis=0).T).sum()
        assert cauchy_crofton(path_of(entered), stock=BLOCK, view=view) == pytest.approx(length * 2 / pi / 0.5)


def test_line_crossings_in_a_front_view_include_heights():
    there = path_of([(10, 10, 2), (22, 50, 18)])
    assert cauchy_crofton(there, stock=BLOCK, view=View((0, 1, 0), pixel=1.0)) == pytest.approx(20 * 2 / pi)
