# SPDX-License-Identifier: LGPL-2.1-or-later
"""Costs are computed only once, at their first use."""

from __future__ import annotations

import copy
import pickle
from dataclasses import replace

import pytest

from vkworkbench.core import Stock, Tool, View, linearize, recognize
from vkworkbench.core.gcode import Words
from vkworkbench.core.simulators import Conditions, Task, predict, preflight, table, together
from vkworkbench.core.simulators.on_demand import OnDemand
from vkworkbench.core.simulators.table import SIMULATORS

STOCK = Stock((0, 0, 0), (60, 40, 20))
ROWS = [("G0", {"X": 5.0, "Y": 5.0, "Z": 30.0}), ("G1", {"Z": 15.0, "F": 5.0})]
ROWS += [("G1", {"X": 5.0 + 50 * (i % 4 in (0, 1)), "Y": 5.0 + 2 * ((i + 1) // 2)}) for i in range(30)]
BUDGET = {"memory_bytes": 1e9, "seconds": 600.0}


@pytest.fixture
def asked(monkeypatch):
    """Return the names of the simulators whose cost was computed, in the order of the computations."""
    names = []

    def noting(simulator):
        def predicted(task, conditions):
            names.append(simulator.name)
            return simulator.predict(task, conditions)

        return replace(simulator, predict=predicted)

    monkeypatch.setattr(table, "SIMULATORS", tuple(map(noting, SIMULATORS)))
    return names


def task():
    words = Words(ROWS)
    path = linearize(words)
    return Task(path, Tool("endmill", 5.0), STOCK, words, recognize(path))


def test_cost_is_computed_once_at_its_first_use(asked):
    costs, advice = predict(task(), Conditions(version=(1, 1)))
    assert asked == [] and costs and advice
    first = costs["legacy"]
    assert asked == ["legacy"]
    assert costs["legacy"] is first and costs.get("legacy") is first and "legacy" in costs
    assert asked == ["legacy"]
    assert advice["z-buffer"].view is not None
    assert asked == ["legacy", "z-buffer"]
    assert costs["z-buffer"].seconds > 0 and len(asked) == 2
    assert set(costs) == {"z-buffer", "legacy", "OpenGL"} and len(asked) == 3


def test_total_computes_only_the_costs_that_are_shown(asked):
    each = [predict(task(), Conditions(version=(1, 1)))[0] for _ in range(3)]
    costs, advice = together(each, labels=["a", "b", "c"], stepover=2.0, **BUDGET)
    assert asked == []
    assert costs["OpenGL"].seconds >= sum(own["OpenGL"].seconds for own in each) > 0
    assert asked == 3 * ["OpenGL"]
    assert advice["z-buffer"].view and asked == 3 * ["OpenGL"] + 3 * ["z-buffer"]


def test_preflight_samples_no_rays_if_memory_is_in_the_budget(asked):
    whole = task()
    costs, _ = predict(whole, Conditions(version=(1, 1)))
    assert not preflight(whole, costs, Conditions(version=(1, 1)))
    assert sorted(asked) == ["OpenGL", "legacy"]
    # Only if the upper bound of the memory exceeds the budget, rays are sampled to estimate the memory.
    few = Conditions(version=(1, 1), memory_budget=costs["z-buffer"].memory_bytes + 1e4)
    assert not [
        caution for caution in preflight(whole, costs, few) if caution.what.arguments["simulator"] == "z-buffer"
    ]
    few = replace(few, memory_budget=costs["z-buffer"].memory_bytes - 1)
    assert [caution for caution in preflight(whole, costs, few) if caution.what.arguments["simulator"] == "z-buffer"]


def test_costs_do_not_depend_on_the_order_in_which_they_are_used():
    conditions = Conditions(version=(1, 1), legacy_accuracy=0.5, view=View((1, 1, -1), 200, 150))
    names = [simulator.name for simulator in SIMULATORS]
    forwards, backwards = (predict(task(), conditions) for _ in range(2))
    for costs, order in ((forwards, names), (backwards, names[::-1])):
        for name in order:
            costs[0].get(name), costs[1].get(name)
    assert forwards[0] == backwards[0]
    assert {n: a.explanation for n, a in forwards[1].items()} == {n: a.explanation for n, a in backwards[1].items()}


def test_pickled_or_copied_costs_are_computed():
    costs, _ = predict(task(), Conditions(version=(1, 1)))
    sent = pickle.loads(pickle.dumps(costs))
    assert type(sent) is dict and sent == dict(costs) == dict(copy.deepcopy(costs))


def test_names_of_computed_costs_are_listed():
    costs = OnDemand({"a": lambda: 1, "b": lambda: 2})
    assert costs.computed() == () and costs["b"] == 2 and costs.computed() == ("b",)
    assert repr(costs) == "{'a': 1, 'b': 2}"


def test_computed_cost_releases_the_function_that_computed_it():
    costs, _ = predict(task(), Conditions(version=(1, 1)))
    dict(costs)
    assert not costs._makers


def test_cost_whose_computation_fails_is_missing(caplog):
    def fail():
        raise ZeroDivisionError

    def none():
        raise KeyError("nobody knows")

    costs = OnDemand({"bad": fail, "unknown": none, "good": lambda: 1})
    assert costs.get("bad") is None and "bad" not in costs and "unknown" not in costs
    assert dict(costs) == {"good": 1} and len(costs) == 1 and costs
    assert [record.getMessage() for record in caplog.records] == ["bad could not be computed"]
    with pytest.raises(KeyError):
        costs["nothing"]
    assert not OnDemand({})
