# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a job takes in the z-buffer: one stock for all its operations."""

from __future__ import annotations

import pytest

from vkworkbench.core import Cut, Stock, Tool, View, estimate, linearize, simulate_job
from vkworkbench.core.simulators import together, zbuffer
from vkworkbench.core.simulators.zbuffer import ZBufferCost

STOCK, TOOL, VIEW = Stock((0, 0, 0), (60, 40, 10)), Tool("endmill", 6), View(width=400, height=300)


def slot(y):
    return linearize([("G0", {"X": 5, "Y": y, "Z": 20}), ("G1", {"Z": 5}), ("G1", {"X": 55})])


def test_the_largest_stock_and_the_least_sure_time_count():
    one, other = ZBufferCost(10.0, 300.0, 1.5, 100.0), ZBufferCost(20.0, 250.0, 2.5, 120.0)
    assert zbuffer.together([one, other]) == ZBufferCost(30.0, 120.0 + 200.0 + 130.0, 2.5, 120.0)


def test_the_memory_of_a_job_counts_the_stock_once():
    paths = [slot(y) for y in (5, 15, 25, 35)]
    costs = [{"z-buffer": estimate(path, None, tool=TOOL, stock=STOCK, view=VIEW)} for path in paths]
    told, _ = together(costs, labels=list("abcd"), stepover=None, memory_bytes=1e9, seconds=600.0)
    true = simulate_job([Cut(path, TOOL) for path in paths], stock=STOCK, view=VIEW).memory_bytes
    assert told["z-buffer"].memory_bytes == pytest.approx(true, rel=0.03)
    alone, _ = together(costs[:1], labels=["a"], stepover=None, memory_bytes=1e9, seconds=600.0)
    assert alone["z-buffer"].memory_bytes == costs[0]["z-buffer"].memory_bytes
