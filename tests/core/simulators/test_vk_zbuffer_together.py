# SPDX-License-Identifier: LGPL-2.1-or-later
"""The z-buffer's simulation cost for a job whose operations share one stock."""

from __future__ import annotations

import pickle

import pytest

from vkworkbench.core import Cut, Cylinder, Stock, Tool, View, estimate, linearize, simulate_job
from vkworkbench.core.simulators import together, zbuffer
from vkworkbench.core.simulators.zbuffer import ZBufferCost
from vkworkbench.core.zbuffer import memory_needed

STOCK, TOOL, VIEW = Stock((0, 0, 0), (60, 40, 10)), Tool("endmill", 6), View(width=400, height=300)


def slot(y):
    return linearize([("G0", {"X": 5, "Y": y, "Z": 20}), ("G1", {"Z": 5}), ("G1", {"X": 55})])


def test_job_cost_has_the_largest_stock_and_largest_uncertainty():
    one, other = ZBufferCost(10.0, 300.0, 1.5, 100.0), ZBufferCost(20.0, 250.0, 2.5, 120.0)
    assert zbuffer.together([one, other]) == ZBufferCost(30.0, 120.0 + 200.0 + 130.0, 2.5, 120.0)


def test_memory_of_a_job_counts_the_stock_once():
    paths = [slot(y) for y in (5, 15, 25, 35)]
    costs = [{"z-buffer": estimate(path, None, tool=TOOL, stock=STOCK, view=VIEW)} for path in paths]
    told, _ = together(costs, labels=list("abcd"), stepover=None, memory_bytes=1e9, seconds=600.0)
    true = simulate_job([Cut(path, TOOL) for path in paths], stock=STOCK, view=VIEW).peak.bytes()
    assert told["z-buffer"].memory_bytes == pytest.approx(true, rel=0.03)
    alone, _ = together(costs[:1], labels=["a"], stepover=None, memory_bytes=1e9, seconds=600.0)
    assert alone["z-buffer"].memory_bytes == costs[0]["z-buffer"].memory_bytes


def alone(*paths, stock=STOCK, view=VIEW):
    return [estimate(path, None, tool=TOOL, stock=stock, view=view) for path in paths]


@pytest.mark.parametrize("direction", [(0, 0, -1), (1, 1, -1)])
def test_material_of_overlapping_operations_counts_once(direction):
    view = View(direction, 400, 300)
    costs = alone(slot(15), slot(15), slot(16), view=view)
    whole = zbuffer.together(costs)
    true = simulate_job([Cut(slot(y), TOOL) for y in (15, 15, 16)], stock=STOCK, view=view)
    assert whole.memory_bytes == pytest.approx(true.peak.bytes(), rel=0.03)
    assert abs(whole.traces - true.traces) <= 3 * whole.traces_error
    assert sum(cost.traces for cost in costs) > 1.8 * true.traces
    assert whole.seconds < sum(cost.seconds for cost in costs)
    assert whole.trajectory_seconds == pytest.approx(sum(cost.trajectory_seconds for cost in costs))


def test_order_of_the_operations_changes_the_traces():
    deep, high = slot(15), linearize([("G0", {"X": 5, "Y": 15, "Z": 20}), ("G1", {"Z": 8}), ("G1", {"X": 55})])
    first, last = zbuffer.together(alone(deep, high)), zbuffer.together(alone(high, deep))
    assert first.traces < 0.7 * last.traces


def test_job_is_estimated_only_once():
    costs = alone(slot(5), slot(15))
    assert zbuffer.together(costs[:1]) is costs[0]
    assert zbuffer.together(costs) is zbuffer.together(list(costs))
    again = alone(slot(5), slot(25))
    assert zbuffer.together(again) is not zbuffer.together(costs)


def test_equal_stocks_of_operations_are_one_stock():
    costs = alone(slot(15)) + alone(slot(15), stock=Stock((0, 0, 0), (60, 40, 10)))
    assert zbuffer.together(costs).memory_bytes < 1.01 * costs[0].memory_bytes


@pytest.mark.parametrize(
    "other",
    [
        alone(slot(15), stock=Stock((0, 0, 0), (60, 40, 11))),
        alone(slot(15), stock=Cylinder((30, 20, 0), 20, 10)),
        alone(slot(15), view=View(width=200, height=150)),
        [ZBufferCost(1.0, 3e6, 2.0, 1e6)],
        [pickle.loads(pickle.dumps(alone(slot(15))[0]))],
    ],
)
def test_costs_of_different_z_buffers_are_added(other):
    costs = alone(slot(15), slot(25)) + other
    added = zbuffer.together(costs)
    assert isinstance(added, ZBufferCost) and added.seconds == sum(cost.seconds for cost in costs)
    removed = sum(cost.memory_bytes - cost.stock_bytes for cost in costs)
    assert added.memory_bytes == pytest.approx(removed + max(cost.stock_bytes for cost in costs))


def test_pickled_cost_has_no_toolpath():
    (cost,) = alone(slot(15))
    sent = pickle.loads(pickle.dumps(cost))
    assert sent == cost and sent.cuts == () and sent.stock is None and cost.cuts[0].tool is TOOL


def test_image_of_a_job_is_chosen_for_all_its_operations():
    costs = [{"z-buffer": cost} for cost in alone(*5 * [slot(15)])]
    asked = {"labels": list("abcde"), "stepover": None, "seconds": 600.0}
    advice = together(costs, **asked, memory_bytes=1e8)[1]
    one = together(costs[:1], **asked, memory_bytes=1e8)[1]["z-buffer"]
    chosen = advice["z-buffer"]
    assert chosen.view.width == pytest.approx(one.view.width, abs=2)
    needed = memory_needed([Cut(slot(15), TOOL)] * 5, stock=STOCK, view=chosen.view)
    assert needed == pytest.approx(0.98e8, rel=0.01)
    hopeless = together(costs, **{**asked, "seconds": 1e-9}, memory_bytes=1e8)[1]["z-buffer"]
    assert hopeless.view is None and " The slowest is a with " in hopeless.explanation
