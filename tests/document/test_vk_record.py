# SPDX-License-Identifier: LGPL-2.1-or-later
"""The data of a mark in the tree (a record): as JSON, as the total of several records, and damaged."""

from __future__ import annotations

import json
from dataclasses import replace
from types import SimpleNamespace

import pytest

from vkworkbench import freecad
from vkworkbench.core import Strategy
from vkworkbench.core.simulators import Caution
from vkworkbench.document.marks.record import Record, as_json, from_json, of_operation, of_total
from vkworkbench.language import Message, render
from vkworkbench.report import Setup

HANGS = Caution(
    "legacy-hangs", Message("legacy-hangs", simulator="legacy", reason="r", command=3, instead="i", others=None), 3
)
SHORT = Caution("short-moves", Message("opengl-long-play", simulator="OpenGL", time=700.0), None)
WHOLE = Record(
    strategy=Strategy.ZIGZAG, confidence=0.91, reason=(Message("not-nested"),), remarks=(Message("moves-nothing"),),
    cautions=(HANGS, SHORT), operations=1, fixtures=1, trajectories=120, length=512.5, machining_seconds=61.5,
    left_out=(Message("moves-nothing"),), setup=Setup("T3", True, 60.0, 3.0), stepover=2.5, called="Offset", incomplete=True, fingerprint="a:b",
    outdated=True, text="zigzag 91%",
)  # fmt: skip


@pytest.mark.parametrize(
    "changed",
    [{}, {"machining_seconds": None}, {"stepover": None}, {"called": None}, {"strategy": None}, {"cautions": ()},
     {"outdated": False}, {"off": True}, {"incomplete": False}, {"operations": 7}, {"fixtures": 3}, {"trajectories": 0, "length": 0.0, "confidence": 0.0},
     {"confidence": 1.0}, {"length": 0.9e15}],
    ids=str,
)  # fmt: skip
def test_record_is_unchanged_after_writing_and_reading(changed):
    kept = replace(WHOLE, **changed)
    assert from_json(as_json(kept)) == kept


@pytest.mark.parametrize(
    "name, value",
    [("length", -1.0), ("length", True), ("length", "9"), ("length", 1.1e15), ("confidence", 1.5), ("text", "\ud800"), ("length", float("inf")), ("machining", float("nan")),
     ("stepover", []), ("strategy", "no strategy"), ("trajectories", None), ("reason", [{"code": "of a newer version"}])],
)  # fmt: skip
def test_damaged_or_newer_data_is_not_a_mark(name, value):
    data = {**json.loads(as_json(WHOLE)), name: value}
    assert from_json(json.dumps(data)) is None


def test_record_of_one_operation_is_complete():
    """Only the costs of a job can be lower bounds, so the record of an operation is complete."""
    alone = Record(Strategy.ZIGZAG)
    assert alone.operations == 1 and not alone.incomplete and not alone.outdated
    assert (alone.trajectories, alone.length, alone.confidence, alone.machining_seconds) == (0, 0, 0, None)


def test_mark_contains_the_number_of_its_format():
    """The format number lets a later version recognise old marks."""
    assert json.loads(as_json(WHOLE))["format"] == 2


def test_reasons_are_written_in_english():
    reasons = Message("not-nested"), Message("moves-nothing")
    assert replace(WHOLE, reason=reasons).english_reason == " ".join(map(render, reasons))


class Asked(dict):
    """A dictionary of costs that records which costs were read; `computed` returns the names of the computed costs."""

    def __init__(self, costs, computed):
        super().__init__(costs)
        self.asked, self._computed = [], computed

    def computed(self):
        return self._computed

    def __getitem__(self, name):
        self.asked.append(name)
        return super().__getitem__(name)


def test_record_keeps_shown_and_computed_costs(monkeypatch):
    monkeypatch.setattr(freecad, "own_simulators", lambda: ("legacy", "missing"))
    costs = Asked({"chosen": 1, "legacy": 2, "computed": 3, "other": 4}, computed=("computed",))
    report = SimpleNamespace(
        costs=costs, recognition=SimpleNamespace(why=Message("not-nested")),
        **{name: getattr(WHOLE, name) for name in ("strategy", "confidence", "remarks", "cautions", "trajectories",
           "length", "machining_seconds", "left_out", "setup", "stepover", "called", "fingerprint")},
    )  # fmt: skip
    kept = of_operation(report, "chosen")
    assert kept.costs == {"chosen": 1, "legacy": 2, "computed": 3} and "other" not in costs.asked
    expected = replace(WHOLE, costs=kept.costs, incomplete=False, outdated=False, text="")
    assert kept == expected
    report.costs = {"legacy": 2}
    assert of_operation(report, "chosen").costs == {"legacy": 2}


def test_remarks_contain_only_serious_problems():
    assert WHOLE.english_remarks == " ".join([*map(render, WHOLE.remarks), HANGS.message])


def test_total_combines_the_records_of_operations():
    total = SimpleNamespace(
        fixtures=1,
        operations=2,
        trajectories=200,
        length=900.0,
        machining_seconds=61.5,
        incomplete=False,
        costs={},
        setup=Setup("", True, 126.0),
    )
    untimed = replace(WHOLE, label="Untimed", machining_seconds=None, cautions=(SHORT,))
    found = of_total(total, [WHOLE, untimed], "f")
    assert found.strategy is None and (found.operations, found.trajectories, found.length) == (2, 200, 900.0)
    assert found.machining_seconds == 61.5 and of_total(total, [untimed], "f").machining_seconds is None
    assert found.cautions == (HANGS,)  # the simulator that hangs on one of the operations also hangs on the job
    # A cause that two operations have in common is listed only once.
    assert found.left_out == WHOLE.left_out and found.setup == total.setup
    (remark,) = found.remarks
    assert remark.code == "cost-unknown"


def test_total_without_moves_has_no_remark_on_costs():
    total = SimpleNamespace(operations=1, fixtures=1, trajectories=0, length=0.0, machining_seconds=0.0, incomplete=False, costs={},
                            setup=Setup())  # fmt: skip
    assert of_total(total, [replace(WHOLE, trajectories=0)], "f").remarks == ()
