# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tools and stocks of impossible sizes are refused, or counted without an array for all their cells."""

from __future__ import annotations

import numpy as np
import programs
import pytest
from counting import memory

from vkworkbench.core import Mesh, Stock, Tool, linearize, recognize, stock_around
from vkworkbench.core.simulators import Conditions, Task, predict, preflight
from vkworkbench.language import Unusable

STOCK = Stock((-10, -10, -20), (60, 60, 0))


@pytest.mark.long
@pytest.mark.parametrize("tool, stock", [
    (Tool("endmill", 1e6), STOCK), (Tool("ballend", 1e6), STOCK), (Tool("endmill", 1e-12), STOCK), (Tool("vbit", 1e5), STOCK),
    (Tool("endmill", 5), Stock((0, 0, -2e-5), (2e-5, 2e-5, 0))), (Tool("drill", 5), Stock((0, 0, -1e-6), (1e-6, 1e-6, 0))),
    (Tool("endmill", 5), Stock((-1e6, -1e6, -1e6), (1e6, 1e6, 0))), (Tool("endmill", 1e6), Stock((0, 0, -20), (1e-6, 60, 0))),
], ids=range(8))  # fmt: skip
@pytest.mark.parametrize("program", ["zigzag", "helix", "drilling"])
def test_prediction_for_any_size_needs_little_memory(tool, stock, program):
    path = linearize(programs.SOUND[program]())
    task, conditions = Task(path, tool, stock, None, recognize(path)), Conditions(version=(1, 0, 0))

    def predicted():
        costs, _ = predict(task, conditions)
        preflight(task, costs, conditions)
        return costs

    costs, _, peak = memory(predicted)
    assert peak < 200e6
    assert all(np.isfinite((cost.seconds, cost.memory_bytes)).all() for cost in costs.values())


@pytest.mark.parametrize("diameter", [1.0000001e6, 1e9, 1e300, float("inf"), float("nan"), 0, -1.0, 5e-324])
def test_tool_of_impossible_size_is_refused(diameter):
    with pytest.raises(Unusable, match="at most a kilometer"):
        Tool("endmill", diameter)


@pytest.mark.parametrize("angle", [5e-324, 0, -1.0, 3.2, float("nan")])
def test_tool_with_an_impossible_tip_is_refused(angle):
    with pytest.raises(Unusable, match="tip angle must be between 0 and pi"):
        Tool("vbit", 6, tip_angle=angle)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("size", [1e308, 1e13, 1.1e6])
def test_mesh_of_impossible_size_is_refused(size):
    corners = size * np.vstack((np.zeros(3), np.eye(3)))
    with pytest.raises(Unusable, match="within a kilometer"):
        Mesh(corners[np.array([[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]])])


@pytest.mark.parametrize("corner, words", [
    ((1e-7, 60, 20), "no volume"), ((60, 60, 1e-300), "no volume"), ((1e7, 60, 20), "within a kilometer"),
    ((60, 1e300, 20), "within a kilometer"), ((float("nan"), 60, 20), "within a kilometer"),
])  # fmt: skip
def test_stock_of_impossible_size_is_refused(corner, words):
    with pytest.raises(Unusable, match=words):
        Stock((0, 0, 0), corner)


@pytest.mark.parametrize("diameter", [1e6, 1.0, 1e-6])
@pytest.mark.parametrize("at", [0.0, 1e6, -1e6])
def test_box_around_cuts_stays_within_the_coordinates(diameter, at):
    path = linearize([("G0", {"X": at, "Y": at, "Z": at}), ("G1", {"X": 0.0, "F": 5.0}), ("G1", {"X": at})])
    if not len(path):
        path = linearize([("G0", {"X": at, "Y": at, "Z": at}), ("G1", {"X": 1.0, "F": 5.0})])
    stock = stock_around(path, Tool("endmill", diameter))
    assert (np.abs([stock.lower, stock.upper]) <= 1e6).all() and (stock.upper > stock.lower).all()
