# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare an operation's type with its recognised strategy: only another family of strategies is a contradiction."""

from __future__ import annotations

import csv

import programs
import pytest

import vkworkbench
from vkworkbench.core import Strategy, linearize, recognize
from vkworkbench.core.recognition import Recognition, Span
from vkworkbench.document.job.intent import contradicts
from vkworkbench.document.marks import marks
from vkworkbench.language import Message

FITS = [("helix", "Adaptive"), ("spiral", "Adaptive"), ("profile", "Offset"), ("contour-parallel", "Profile"), ("one-way", "ZigZag"),
        ("engraving", "Profile"), ("zigzag", "ZigZagOffset"), ("drilling", "Tapping"), ("zigzag", None), ("zigzag", "Slot"),
        ("profile", "Slot"), ("zigzag", "Engrave"), ("profile", "ZigZag"), ("engraving", "Line")]  # fmt: skip
CONTRADICTS = [("zigzag", "Offset"), ("contour-parallel", "ZigZag"), ("zigzag", "Profile"), ("drilling", "Helix"), ("helix", "Drilling"),
               ("one-way", "Adaptive"), ("drilling", "Slot"), ("drilling", "Engrave")]  # fmt: skip


def done(strategy):
    found = recognize(linearize(programs.SOUND[strategy]()), tool_diameter=5.0)
    assert found.strategy == strategy
    return found


@pytest.mark.parametrize("strategy, name", FITS)
def test_operation_type_of_the_same_family_does_not_contradict(strategy, name):
    assert not contradicts(name, done(strategy))


@pytest.mark.parametrize("strategy, name", CONTRADICTS)
def test_type_in_another_family_contradicts_the_strategy(strategy, name):
    assert contradicts(name, done(strategy))


def test_single_loop_does_not_contradict_a_zigzag_operation():
    assert not contradicts("ZigZag", recognize(linearize(programs.profile(depths=(0.0,)))))


def told(strategy, confidence=0.8, passes=3, spans=()):
    spans = tuple(Span(k, k, k, k, one, 1 / len(spans)) for k, one in enumerate(spans))
    return Recognition(strategy, confidence, Message("moves-nothing"), spans, passes=passes)


ROWS, ROWS_ONE_WAY, AROUND, MIXED = Strategy.ZIGZAG, Strategy.ONE_WAY, Strategy.PROFILE, Strategy.MIXED


@pytest.mark.parametrize(
    "name, found, expected",
    [
        ("Offset", told(ROWS), True),
        ("Offset", told(ROWS, confidence=0.79), False),
        ("Offset", told(ROWS, passes=2), False),
        ("Drilling", told(AROUND, passes=1), True),
        ("Offset", told(ROWS, passes=None), True),
        ("Offset", told(Strategy.UNKNOWN), False),
        ("Offset", told(Strategy.EMPTY, 1.0), False),
        ("Slot", told(ROWS), False),
        (None, told(ROWS), False),
        ("Offset", told(MIXED, spans=[ROWS, ROWS_ONE_WAY]), True),
        ("Offset", told(MIXED, spans=[ROWS, AROUND]), False),
        ("Grid", told(MIXED, spans=[ROWS, AROUND]), False),
        ("Grid", told(MIXED, spans=[AROUND, Strategy.DRILLING]), True),
    ],
)
def test_contradiction_needs_confidence_and_another_family(name, found, expected):
    assert contradicts(name, found) is expected


def test_pattern_of_a_slot_does_not_contradict_a_profile(small):
    """The CutPattern of FreeCAD's Slot only says how a single line is cut, so it contradicts no strategy."""
    slot = small.add("Slot", programs.profile())
    slot.addProperty("App::PropertyString", "CutPattern", "Path").CutPattern = "ZigZag"
    slot.Proxy = type("ObjectSlot", (), {"__module__": "Path.Op.Slot"})()
    (row,) = vkworkbench.analyze(slot).operations
    assert row.strategy is Strategy.PROFILE and row.called is None


@pytest.mark.parametrize(
    "algorithm, pattern, called",
    [
        ("Experimental", "ZigZag", None),
        ("Experimental", "None", "Waterline"),
        ("Experimental", "Offset", "Waterline"),
        ("OCL Dropcutter", "ZigZag", "Waterline"),
    ],
)
def test_zigzag_fits_a_waterline_operation_with_a_pattern(small, zigzag_commands, algorithm, pattern, called):
    """
    FreeCAD's Waterline operation clears each depth with a pattern only if it uses the experimental algorithm.

    Therefore a zigzag contradicts a Waterline operation without the experimental algorithm.
    """
    waterline = small.add("Waterline", zigzag_commands)
    for name, value in (("Algorithm", algorithm), ("CutPattern", pattern)):
        waterline.addProperty("App::PropertyString", name, "Path")
        setattr(waterline, name, value)
    waterline.Proxy = type("ObjectWaterline", (), {"__module__": "Path.Op.Waterline"})()
    (row,) = vkworkbench.analyze(waterline).operations
    assert (row.strategy, row.called) == ("zigzag", called)


@pytest.mark.parametrize("count", [1, 2, 3])
def test_contours_contradict_drilling_at_any_number_of_passes(small, count):
    drilling = small.add("Drilling", programs.profile(depths=tuple(-2.0 * k for k in range(count))))
    drilling.Proxy = type("ObjectDrilling", (), {"__module__": "Path.Op.Drilling"})()
    (row,) = vkworkbench.analyze(drilling).operations
    assert (row.strategy, row.called) == ("profile", "Drilling")


def test_type_of_a_dress_up_is_not_taken_from_its_base(small, zigzag_commands):
    base, dressup = small.add("Base", programs.helix()), small.add("Dress-up", zigzag_commands)
    for op, pattern in ((base, "ZigZag"), (dressup, "Offset")):
        op.addProperty("App::PropertyString", "OffsetPattern", "Path").OffsetPattern = pattern
    dressup.addProperty("App::PropertyLink", "Base", "Path").Base = base
    report = vkworkbench.analyze(small.document)
    assert {row.label: row.called for row in report.operations} == {"Base": "ZigZag", "Dress-up": None}
    vkworkbench.mark(report)
    assert marks.read(base).called == "ZigZag" and marks.read(dressup).called is None


def test_results_file_contains_contradictions(small, zigzag_commands, tmp_path):
    """The CSV file names the type of operation that the strategy contradicts, as the mark and the panel do."""
    op = small.add("2D Pocket3", zigzag_commands)
    op.addProperty("App::PropertyString", "OffsetPattern", "Path").OffsetPattern = "Offset"
    report = vkworkbench.analyze(small.document)
    report.to_csv(tmp_path / "job.csv")
    with open(tmp_path / "job.csv", newline="", encoding="utf-8") as file:
        (row,) = csv.DictReader(file)
    assert (row["label"], row["strategy"], row["called"]) == ("2D Pocket3", "zigzag", "Offset")
    op.OffsetPattern = "ZigZag"  # the next analysis uses the new pattern although the path was not recomputed
    (again,) = vkworkbench.analyze(small.document).operations
    assert again.called is None
