# SPDX-License-Identifier: LGPL-2.1-or-later
"""The warning before a slow simulation, computed from the marks in the tree, and the faster simulator that it names."""

from dataclasses import replace

import pytest

from vkworkbench import freecad
from vkworkbench.core import Stock, Strategy, Tool, linearize
from vkworkbench.core.simulators import Caution, Task, legacy_cost, opengl_cost
from vkworkbench.document.marks.better_way import OURS, better_way, too_long
from vkworkbench.document.marks.record import Record
from vkworkbench.language import Message, render
from vkworkbench.preferences import Preferences

BUDGET = Preferences(time_budget=600.0)
TASK = Task(linearize([("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"X": 40.0, "F": 10.0})]),
            Tool("endmill", 6.0), Stock((-5, -5, 0), (50, 50, 20)))  # fmt: skip


@pytest.fixture(autouse=True)
def both(monkeypatch):
    """Make every version of FreeCAD report both simulators: legacy and OpenGL."""
    monkeypatch.setattr(freecad, "own_simulators", lambda: ("legacy", "OpenGL"))


def record(label="Pocket", *, forward=5.0, play=60.0, opengl=60.0, **rest):
    """Return the record of a mark in the tree with the given simulation times, s."""
    legacy = legacy_cost(TASK)
    drawn = opengl_cost(TASK)
    longer = opengl / drawn.seconds
    costs = {
        "legacy": replace(legacy, fast_forward_seconds=forward, play_seconds=play),
        "OpenGL": replace(drawn, play_seconds={s: longer * t for s, t in drawn.play_seconds.items()}),
    }
    return Record(Strategy.ZIGZAG, trajectories=2, costs=costs, label=label, **rest)


def hanging(label, simulator="legacy", **rest):
    what = Message("legacy-hangs", simulator=simulator, reason=Message("arc-full-circle"), command=12,
                   instead=Message("leave-out"), others=None)  # fmt: skip
    return record(label, cautions=(Caution("legacy-hangs", what, 12),), **rest)


def said(found):
    return f"{render(found.wrong)} {render(found.better)}"


def test_no_faster_simulator_is_offered_within_the_budget():
    for simulator in freecad.own_simulators():
        assert better_way(simulator, [record(), record()], BUDGET) is None
        assert better_way(simulator, [], BUDGET) is None
        assert better_way(simulator, [None, record(opengl=1e5, play=1e5, outdated=True)], BUDGET) is None


def test_fast_forward_is_offered_for_a_long_play():
    found = better_way("legacy", [record(play=6120.0, forward=34.0)], BUDGET)
    assert found.way == "legacy"
    assert (
        said(found) == "Playing this simulation takes about 2 h in the legacy simulator. Fast-forward takes about 30 s."
    )


def test_legacy_simulator_is_offered_for_slow_opengl():
    found = better_way("OpenGL", [record(opengl=6120.0, play=6120.0, forward=34.0)], BUDGET)
    assert found.way == "legacy"
    assert said(found) == (
        "Playing this simulation takes about 2 h in the OpenGL simulator. Fast-forward in the legacy simulator takes about 30 s."
    )


def test_hanging_operation_is_named_with_an_alternative():
    found = better_way("legacy", [record(), hanging("Thread001"), hanging("Thread002")], BUDGET)
    assert found.way == "OpenGL"
    assert "command 13 of Thread001 (also in another operation) is an arc that is a full circle" in said(found)
    assert better_way("OpenGL", [hanging("Thread001")], BUDGET) is None


def test_zbuffer_is_offered_if_both_simulators_fail():
    assert better_way("OpenGL", [record(opengl=1e4, forward=1e4, play=1e5)], BUDGET).way == OURS
    assert better_way("OpenGL", [hanging("Thread001", opengl=1e4)], BUDGET).way == OURS
    assert better_way("legacy", [hanging("Thread001", opengl=1e4)], BUDGET).way == OURS
    assert better_way("legacy", [record(play=1e4, forward=1e4, opengl=1e4)], BUDGET).way == OURS


def test_faster_way_without_opengl_simulator_is_available(monkeypatch):
    monkeypatch.setattr(freecad, "own_simulators", lambda: ("legacy",))
    assert better_way("legacy", [hanging("Thread001")], BUDGET).way == OURS
    assert better_way("legacy", [record(play=1e4)], BUDGET).way == "legacy"


@pytest.mark.parametrize("other", [None, record("Old", outdated=True), replace(record(), costs={})])
def test_unknown_costs_make_the_time_a_lower_bound(other):
    found = better_way("legacy", [record(play=6120.0, forward=34.0), other], BUDGET)
    assert (
        said(found)
        == "Playing this simulation takes at least 2 h in the legacy simulator. Fast-forward takes at least 30 s."
    )


def test_one_incomplete_time_makes_total_a_lower_bound():
    known, in_part = record(play=6120.0, forward=34.0), record(incomplete=True)
    for records in ([known, in_part], [in_part, known]):
        assert "at least" in said(better_way("legacy", records, BUDGET))
    assert "at least" not in said(better_way("legacy", [known, known], BUDGET))


def test_times_of_operations_are_added_for_the_warning():
    each = record(opengl=400.0, forward=1.0)
    assert better_way("OpenGL", [each], BUDGET) is None
    assert better_way("OpenGL", [each, each], BUDGET) is not None


@pytest.mark.parametrize("simulator, times", [("legacy", {"forward": 601.0}), ("OpenGL", {"opengl": 601.0})])
def test_mark_over_the_budget_names_the_offered_simulator(simulator, times):
    chosen = replace(BUDGET, mark_simulator=simulator)
    over = record(**times)
    offered = better_way(simulator, [record(**{"play": 1e4, **times})], chosen)
    assert too_long(record(), chosen) is None
    assert render(too_long(over, chosen)) == (
        f"The {simulator} simulator takes about 10.02 min, which is over your 10.00 min limit. {render(offered.better)}"
    )
    least = render(too_long(replace(over, incomplete=True), chosen))
    assert "takes at least 10.02 min" in least and "about" not in least


def test_operation_without_moves_keeps_the_total_complete():
    empty = Record(Strategy.EMPTY, remarks=(Message("no-toolpath"),))
    assert "about 2 h" in said(better_way("legacy", [record(play=6120.0), empty], BUDGET))
