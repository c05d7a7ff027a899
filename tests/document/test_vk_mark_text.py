# SPDX-License-Identifier: LGPL-2.1-or-later
"""The text of a mark in the tree: times, warnings, and remarks without the brackets of a mark."""

from __future__ import annotations

from dataclasses import replace

import pytest

from vkworkbench.core import Stock, Strategy, Tool, linearize
from vkworkbench.core.simulators import Caution, Task, legacy_cost
from vkworkbench.document.marks.record import Record
from vkworkbench.document.marks.text import Burden, _shortened, burden, is_unsure, is_warned, text_of, time_of
from vkworkbench.language import Message, render
from vkworkbench.preferences import Preferences

CHOSEN = Preferences(mark_simulator="legacy", time_budget=600.0)
PATH = linearize([("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"X": 40.0, "F": 10.0})])
COST = legacy_cost(Task(PATH, Tool("endmill", 6.0), Stock((-5, -5, 0), (50, 50, 20))))
NOTHING = Message("moves-nothing")


def record(seconds=5.0, **rest):
    """Return the record of a mark with a simulation time of `seconds`; None: without a time."""
    costs = {} if seconds is None else {"legacy": replace(COST, fast_forward_seconds=seconds)}
    return Record(**{"strategy": Strategy.ZIGZAG, "confidence": 0.9, "trajectories": 2, "costs": costs, **rest})


def hangs(simulator):
    what = Message("legacy-hangs", simulator=simulator, reason="r", command=3, instead="i", others=None)
    return Caution("legacy-hangs", what, 3)


@pytest.mark.parametrize(
    "seconds, expected",
    [(None, Burden.FINE), (299.0, Burden.FINE), (301.0, Burden.NEAR), (600.0, Burden.NEAR), (601.0, Burden.OVER)],
)
def test_time_is_near_the_budget_from_half_of_the_budget(seconds, expected):
    assert burden(record(seconds), CHOSEN) is expected
    assert is_warned(record(seconds), CHOSEN) is (expected is Burden.OVER)


@pytest.mark.parametrize(
    "rest, warned",
    [
        ({}, False),
        ({"remarks": (NOTHING,)}, True),
        ({"called": "ZigZag"}, True),  # FreeCAD's type ZigZag contradicts the recognised strategy
        ({"cautions": (hangs("legacy"),)}, True),
        ({"cautions": (hangs("OpenGL"),)}, False),  # the preferences choose the legacy simulator, not OpenGL
        ({"cautions": (hangs("OpenGL"), hangs("legacy"))}, True),
        # A caution about short moves is not serious.
        ({"cautions": (Caution("short-moves", hangs("legacy").what, None),)}, False),
    ],
    ids=["nothing", "remark", "called", "hangs", "the other hangs", "both hang", "not serious"],
)
def test_mark_warns_of_serious_cautions_and_remarks(rest, warned):
    assert is_warned(record(**rest), CHOSEN) is warned
    assert ("⚠" in text_of(record(**rest), CHOSEN)) is warned


def test_incomplete_time_is_shown_as_lower_bound():
    assert time_of(record(5.0), CHOSEN) != "" and "≥" not in time_of(record(5.0), CHOSEN)
    assert (time_of(record(5.0), CHOSEN), time_of(record(5.0, incomplete=True), CHOSEN)) == ("about 5 s", "≥ 5 s")
    assert time_of(record(None), CHOSEN) == "" == time_of(record(None, incomplete=True), CHOSEN)


TIME = f"sim {time_of(record(), CHOSEN)}"
REMARK = render(NOTHING)


@pytest.mark.parametrize(
    "rest, text",
    [
        ({}, f"zigzag · {TIME}"),
        ({"confidence": 0.8}, f"zigzag · {TIME}"),
        ({"confidence": 0.79}, f"zigzag 79% · {TIME}"),
        ({"strategy": Strategy.UNKNOWN, "confidence": 0.0}, f"unknown · {TIME}"),
        ({"strategy": None, "operations": 1}, f"1 operation · {TIME}"),
        ({"strategy": None, "operations": 2}, f"2 operations · {TIME}"),
        ({"seconds": None}, "zigzag"),
        ({"machining_seconds": 78.0}, f"zigzag · 1:18 · {TIME}"),
        ({"machining_seconds": 78.0, "left_out": (NOTHING,)}, f"zigzag · ≥ 1:18 · {TIME}"),
        ({"machining_seconds": 78.0, "seconds": None}, "zigzag · 1:18"),
        ({"strategy": None, "operations": 2, "machining_seconds": 3904.0}, f"2 operations · 1:05:04 · {TIME}"),
        ({"remarks": (NOTHING,)}, f"zigzag · {TIME} ⚠ · {REMARK}"),
        ({"remarks": (NOTHING, NOTHING)}, f"zigzag · {TIME} ⚠ · {REMARK} {REMARK}"),
        ({"remarks": (NOTHING,), "seconds": None}, f"zigzag · ⚠ {REMARK}"),
        ({"outdated": True}, f"zigzag · {TIME} · outdated"),
        ({"outdated": True, "seconds": None}, "zigzag · outdated"),
    ],
    ids=str,
)
def test_mark_text_contains_strategy_times_and_warnings(rest, text):
    assert text_of(record(**rest), CHOSEN) == text


@pytest.mark.parametrize(
    "strategy, confidence, unsure",
    [(Strategy.ZIGZAG, 0.79, True), (Strategy.ZIGZAG, 0.8, False), (Strategy.UNKNOWN, 0.1, False), (None, 0.1, False)],
)
def test_only_a_recognised_strategy_can_be_unsure(strategy, confidence, unsure):
    assert is_unsure(record(strategy=strategy, confidence=confidence)) is unsure


def test_long_remark_is_cut_and_its_brackets_are_replaced():
    assert _shortened("x" * 120) == "x" * 120
    assert _shortened("x" * 121) == "x" * 119 + "…"
    assert _shortened("x" * 110 + " " * 20 + "y") == "x" * 110 + "…"
    assert _shortened("⟦a⟧") == "[a]"
