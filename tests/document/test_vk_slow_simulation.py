# SPDX-License-Identifier: LGPL-2.1-or-later
"""Warnings of slow simulations, computed from the marks in the tree."""

from dataclasses import replace

import pytest

from vkworkbench import freecad
from vkworkbench.core import Stock, Strategy, Tool, linearize
from vkworkbench.core.simulators import Caution, Task, legacy_cost, opengl_cost
from vkworkbench.document.marks.record import Record
from vkworkbench.document.marks.slow_simulation import too_long, warning_at_start
from vkworkbench.document.marks.text import is_warned, text_of
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


def test_no_warning_is_given_within_the_budget():
    for simulator in freecad.own_simulators():
        assert warning_at_start(simulator, [record(), record()], BUDGET) is None
        assert warning_at_start(simulator, [], BUDGET) is None
        assert warning_at_start(simulator, [None, record(opengl=1e5, play=1e5, outdated=True)], BUDGET) is None


def test_warning_tells_the_time_of_playing():
    """The mark in the tree shows the shorter time of fast-forward."""
    slow = record(play=6120.0, forward=34.0, opengl=7200.0)
    for simulator, time in (("legacy", "about 2 h"), ("OpenGL", "about 2 h")):
        assert render(warning_at_start(simulator, [slow], BUDGET)) == (
            f"Playing this simulation takes {time} in the {simulator} simulator."
        )


def test_hanging_operation_is_named():
    found = warning_at_start("legacy", [record(), hanging("Thread001"), hanging("Thread002")], BUDGET)
    assert "command 13 of Thread001 (also in another operation) is an arc that is a full circle" in render(found)
    assert warning_at_start("OpenGL", [hanging("Thread001")], BUDGET) is None


@pytest.mark.parametrize("other", [None, record("Old", outdated=True), replace(record(), costs={})])
def test_unknown_costs_make_the_time_a_lower_bound(other):
    found = warning_at_start("legacy", [record(play=6120.0), other], BUDGET)
    assert render(found) == "Playing this simulation takes at least 2 h in the legacy simulator."


def test_one_incomplete_time_makes_total_a_lower_bound():
    known, in_part = record(play=6120.0), record(incomplete=True)
    for records in ([known, in_part], [in_part, known]):
        assert "at least" in render(warning_at_start("legacy", records, BUDGET))
    assert "at least" not in render(warning_at_start("legacy", [known, known], BUDGET))


def test_times_of_operations_are_added_for_the_warning():
    each = record(opengl=400.0)
    assert warning_at_start("OpenGL", [each], BUDGET) is None
    assert warning_at_start("OpenGL", [each, each], BUDGET) is not None


@pytest.mark.parametrize("simulator, times", [("legacy", {"forward": 601.0}), ("OpenGL", {"opengl": 601.0})])
def test_mark_over_the_budget_offers_the_simulation_tab(simulator, times):
    chosen = replace(BUDGET, mark_simulator=simulator)
    over = record(**times)
    assert too_long(record(), chosen) is None
    assert render(too_long(over, chosen)) == (
        f"The {simulator} simulator takes about 10.02 min, which is over your 10.00 min limit. "
        "Simulate Toolpaths shows the finished part at once, coarse at first."
    )
    least = render(too_long(replace(over, incomplete=True), chosen))
    assert "takes at least 10.02 min" in least and "about" not in least


def test_job_with_a_long_play_has_a_warning():
    """An operation has a caution about a long play, which its mark stores."""
    chosen = replace(BUDGET, mark_simulator="legacy")
    job = replace(record(play=6120.0, forward=34.0), strategy=None)
    assert is_warned(job, chosen) and text_of(job, chosen).endswith(" ⚠")
    assert render(too_long(job, chosen)) == (
        "Playing takes about 2 h in the legacy simulator. Use fast-forward, which takes about 30 s."
    )
    quick, opengl = replace(record(), strategy=None), replace(BUDGET, mark_simulator="OpenGL")
    assert not is_warned(quick, chosen) and too_long(quick, chosen) is None
    assert not is_warned(job, opengl) and too_long(job, opengl) is None


def test_operation_without_moves_keeps_the_total_complete():
    empty = Record(Strategy.EMPTY, remarks=(Message("no-toolpath"),))
    assert "about 2 h" in render(warning_at_start("legacy", [record(play=6120.0), empty], BUDGET))
