# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cache of results: an unchanged operation is not analysed again, and a changed operation is."""

from dataclasses import replace
from types import SimpleNamespace

import FreeCAD
import Path
import pytest

import vkworkbench
from vkworkbench import preferences
from vkworkbench.core import Stock, Tool
from vkworkbench.document import analysis
from vkworkbench.document.computer import calibration
from vkworkbench.document.job import recognition as recognition_module
from vkworkbench.document.job.results import RESULTS, ResultCache, key_of


@pytest.fixture
def recognized(monkeypatch):
    """A list of the lengths (number of trajectories) of the toolpaths passed to `recognize`."""
    lengths, recognize = [], recognition_module.recognize

    def noting(toolpath, **more):
        lengths.append(len(toolpath))
        return recognize(toolpath, **more)

    monkeypatch.setattr(recognition_module, "recognize", noting)
    return lengths


def paths(zigzag_commands, count):
    """Return `count` zigzags with different numbers of commands."""
    return [zigzag_commands[: len(zigzag_commands) - k] for k in range(count)]


def test_second_analysis_reuses_the_recognition(small, zigzag_commands, recognized):
    for k, commands in enumerate(paths(zigzag_commands, 6)):
        small.add(f"Op {k}", commands)
    first = vkworkbench.analyze(small.document)
    assert len(recognized) == 6
    again = vkworkbench.analyze(small.document)
    assert len(recognized) == 6
    assert again == first and str(again) == str(first)
    assert vkworkbench.analyze(small.job, cancelled=lambda: False) == first and len(recognized) == 6


def test_cached_result_has_the_current_labels(small, zigzag_commands, recognized):
    op = small.add("Before", zigzag_commands)
    (first,) = vkworkbench.analyze(small.document).operations
    op.Label, op.Label2 = "After", "my words"
    (again,) = vkworkbench.analyze(op).operations
    assert len(recognized) == 1 and again.label == "After"
    assert replace(again, label="Before") == first
    copy = small.add("Copy", zigzag_commands)
    (of_copy,) = vkworkbench.analyze(copy).operations
    assert len(recognized) == 1 and (of_copy.name, of_copy.label) == (copy.Name, "Copy")
    assert vkworkbench.analyze(op).operations[0].name == op.Name


def changes():
    """Return functions that change an input of the analysis, so that its result cannot be reused."""

    def path(small, op, _):
        op.Path = Path.Path([*op.Path.Commands[:-1], Path.Command("G1", {"X": 12.25})])

    def comment(small, op, _):
        op.Path = Path.Path([Path.Command("(Finishing)"), *op.Path.Commands])

    def tool(small, op, _):
        small.controller.Tool.Diameter = 5.00001

    def stock(small, op, _):
        small.document.Block.Height = 20.001
        small.document.recompute()

    def placement(small, op, _):
        op.Placement.Base = FreeCAD.Vector(0, 0, 1e-4)

    def rapids(small, op, _):
        small.controller.HorizRapid = "1234 mm/min"

    def active(small, op, _):
        op.Active = False

    def no_tool(small, op, _):
        op.ToolController = None

    def chords(small, op, monkeypatch):
        preferred(monkeypatch, tolerance=0.02)

    def image(small, op, monkeypatch):
        preferred(monkeypatch, image_width=801)

    def budget(small, op, monkeypatch):
        preferred(monkeypatch, time_budget=601.0)

    def accuracy(small, op, monkeypatch):
        preferred(monkeypatch, legacy_accuracy=0.2)

    def speed(small, op, monkeypatch):
        now = calibration.measured_speed()
        monkeypatch.setattr(calibration, "measured_speed", lambda going_on: replace(now, record=2 * now.record))

    def constants(small, op, monkeypatch):
        now = calibration.constants(calibration.measured_speed())
        monkeypatch.setattr(calibration, "constants", lambda *_: replace(now, tick=2 * now.tick))

    return [path, comment, tool, stock, placement, rapids, active, no_tool, chords, image, budget, accuracy, speed,
            constants]  # fmt: skip


def preferred(monkeypatch, **values):
    chosen = replace(preferences.read(), **values)
    monkeypatch.setattr(analysis, "preferences", SimpleNamespace(read=lambda: chosen))


@pytest.mark.parametrize("change", changes(), ids=lambda change: change.__name__)
def test_changed_operation_is_analysed_again(small, zigzag_commands, recognized, monkeypatch, change):
    op = small.add("Zigzag", zigzag_commands)
    vkworkbench.analyze(small.document)
    vkworkbench.analyze(small.document)
    assert len(recognized) == 1
    change(small, op, monkeypatch)
    changed = vkworkbench.analyze(small.document)
    assert len(recognized) == 2
    RESULTS.clear()
    assert vkworkbench.analyze(small.document) == changed and len(recognized) == 3


def test_result_is_reused_after_undoing_a_change(small, zigzag_commands, recognized):
    op = small.add("Zigzag", zigzag_commands)
    first = vkworkbench.analyze(small.document)
    before = op.Path
    op.Path = Path.Path(before.Commands[:-3])
    assert vkworkbench.analyze(small.document) != first
    op.Path = before
    assert vkworkbench.analyze(small.document) == first and len(recognized) == 2


def test_result_with_an_error_is_not_cached(small, zigzag_commands, monkeypatch):
    small.add("Zigzag", zigzag_commands)

    def fail(*what, **more):
        raise ZeroDivisionError("a bug")

    with monkeypatch.context() as broken:
        broken.setattr(recognition_module, "recognize", fail)
        assert "Please report" in vkworkbench.analyze(small.document).operations[0].error
    assert vkworkbench.analyze(small.document).operations[0].error is None


def test_result_of_a_long_path_is_cached(small, zigzag_commands, recognized, monkeypatch):
    monkeypatch.setattr(analysis, "AT_ONCE", 5)
    small.add("Zigzag", zigzag_commands)
    assert vkworkbench.analyze(small.document) == vkworkbench.analyze(small.document) and len(recognized) == 1


def test_result_cache_is_bounded():
    known = ResultCache(max_rows=3, max_trajectories=100)
    rows = [SimpleNamespace(trajectories=10, number=k) for k in range(6)]
    for k, row in enumerate(rows):
        known.keep(("key", k), row)
        known.find(("key", 0))
    assert len(known) == 3 and known.find(("key", 0)) is rows[0] and known.find(("key", 1)) is None
    known.keep(("large", 1), SimpleNamespace(trajectories=85))
    assert known.find(("large", 1)) and len(known) == 2
    known.keep(("too large", 1), SimpleNamespace(trajectories=101))
    assert known.find(("too large", 1)) is None and len(known) == 0
    known.keep(None, rows[0])
    assert known.find(None) is None and len(known) == 0


def test_clearing_the_cache_frees_its_space():
    known, row = ResultCache(max_trajectories=100), SimpleNamespace(trajectories=100)
    for _ in range(2):
        known.keep("key", row)
        assert known.find("key") is row
        known.clear()
        assert len(known) == 0


def test_cache_key_differs_for_each_different_input():
    def keys(*parts):
        return key_of("G1 X1", *parts)

    assert keys(Tool("endmill", 5.0), Stock((0, 0, 0), (1, 1, 1))) == keys(
        Tool("endmill", 5.0), Stock((0, 0, 0), (1, 1, 1))
    )
    different = [keys(), keys(Tool("endmill", 5.0)), keys(Tool("endmill", 5.0 + 1e-15 * 5)), keys(Tool("ballend", 5.0)),
                 keys(Stock((0, 0, 0), (1, 1, 1))), keys(Stock((0, 0, 0), (1, 1, 1 + 1e-12))), key_of("G1 X2")]  # fmt: skip
    assert len(set(different)) == len(different) and None not in different
    assert keys(object()) is None and keys([1, object()]) is None
