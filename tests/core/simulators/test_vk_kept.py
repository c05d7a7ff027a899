# SPDX-License-Identifier: LGPL-2.1-or-later
"""Costs stored in documents are read back completely, and impossible data are refused."""

from __future__ import annotations

import json
from dataclasses import fields, replace

import pytest

from vkworkbench.core import Stock, Tool, linearize, recognize
from vkworkbench.core.simulators import Conditions, Constants, Task, predict
from vkworkbench.core.simulators.kept import as_data, from_data
from vkworkbench.core.simulators.zbuffer import ZBufferCost

STOCK = Stock((0, 0, 0), (60, 40, 20))
ROWS = [("G0", {"X": 5.0, "Y": 5.0, "Z": 30.0}), ("G1", {"Z": 15.0, "F": 5.0})]
ROWS += [("G1", {"X": 5.0 + 50 * (i % 4 in (0, 1)), "Y": 5.0 + 2 * ((i + 1) // 2)}) for i in range(20)]
OWN = Constants(start=0.5, draw=2e-6)  # The constants stand for the measured speed of a computer.


@pytest.fixture(scope="module")
def costs():
    path = linearize(ROWS)
    task = Task(path, Tool("endmill", 5.0), STOCK, None, recognize(path))
    return dict(predict(task, Conditions(version=(1, 1), constants=OWN))[0])


def sent(name, cost):
    """Return the data of a cost as read back from a file."""
    return json.loads(json.dumps(as_data(name, cost)))


@pytest.mark.parametrize("name", ["legacy", "OpenGL"])
def test_all_numbers_of_a_stored_cost_are_read_back(costs, name):
    back = from_data(name, sent(name, costs[name]))
    for field in fields(costs[name]):
        assert getattr(back, field.name) == getattr(costs[name], field.name), field.name
    assert (back.seconds, back.memory_bytes, back.factor) == (
        costs[name].seconds,
        costs[name].memory_bytes,
        costs[name].factor,
    )


def test_stored_z_buffer_cost_has_the_numbers_for_totals(costs):
    estimated = costs["z-buffer"]
    back = from_data("z-buffer", sent("z-buffer", estimated))
    assert back == ZBufferCost(estimated.seconds, estimated.memory_bytes, estimated.factor, estimated.stock_bytes)


def test_only_constants_other_than_the_defaults_are_stored(costs):
    assert sent("legacy", costs["legacy"])["constants"] == {"start": 0.5, "draw": 2e-6}
    usual = replace(costs["legacy"], constants=Constants())
    assert sent("legacy", usual)["constants"] == {} and from_data("legacy", sent("legacy", usual)) == usual


@pytest.mark.parametrize("wrong", [-1, -0.5, 1e300, float("inf"), float("nan"), True, "7", None, [1.0]])
def test_impossible_number_in_a_stored_cost_is_refused(costs, wrong):
    data = sent("legacy", costs["legacy"])
    with pytest.raises(ValueError, match="no measure"):
        from_data("legacy", {**data, "facets": wrong})
    with pytest.raises(ValueError, match="no measure"):
        from_data("OpenGL", {**sent("OpenGL", costs["OpenGL"]), "play_seconds": {"1": wrong}})
    with pytest.raises(ValueError, match="no measure"):
        from_data("legacy", {**data, "constants": {"start": wrong}})


def test_stored_0_is_accepted_and_missing_play_times_are_not(costs):
    assert from_data("legacy", {**sent("legacy", costs["legacy"]), "facets": 0}).facets == 0
    with pytest.raises(ValueError, match="no play_seconds"):
        from_data("OpenGL", {**sent("OpenGL", costs["OpenGL"]), "play_seconds": {}})


def test_fields_of_an_older_version_are_ignored(costs):
    data = sent("legacy", costs["legacy"])
    older = {**data, "drawn": 7.0, "constants": {**data["constants"], "ring": 59e-9}}
    assert from_data("legacy", older) == costs["legacy"]


def test_stored_cost_without_a_field_is_refused(costs):
    data = sent("legacy", costs["legacy"])
    del data["facets"]
    with pytest.raises(KeyError):
        from_data("legacy", data)
    with pytest.raises(KeyError):
        from_data("wireframe", data)
