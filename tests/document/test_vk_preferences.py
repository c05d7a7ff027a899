# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every preference has the effect that its description promises."""

import json
from dataclasses import fields

import FreeCAD
import pytest

import vkworkbench
from vkworkbench import freecad, preferences
from vkworkbench.core.simulators import DEFAULTS, LEGACY, OPENGL, ZBUFFER
from vkworkbench.document import upkeep
from vkworkbench.document.marks import marks
from vkworkbench.language import ENGLISH
from vkworkbench.preferences import OWN, Preferences

ARC = [("G0", {"X": 20, "Y": 10, "Z": 25}), ("G1", {"Z": 18, "F": 5}), ("G2", {"X": 40, "Y": 10, "I": 10, "J": 0})]


@pytest.fixture(autouse=True)
def fresh():
    """Reset the preferences to their defaults before each test, and restore them afterwards."""
    group = FreeCAD.ParamGet(preferences.GROUP)
    before = preferences.read()
    group.Clear()
    yield
    group.Clear()
    preferences.write(**vars(before))


@pytest.fixture
def arc(small):
    return small.add("Arc", ARC)


def analyzed(obj):
    (operation,) = vkworkbench.analyze(obj).operations
    return operation


def test_preferences_are_stored_under_freecads_names():
    assert preferences.read() == Preferences()
    preferences.write(image_width=1234, tolerance=0.02, analyze_after_recompute=True, mark_simulator=LEGACY.name)
    group = FreeCAD.ParamGet(preferences.GROUP)
    assert group.GetInt("ImageWidth") == 1234 and group.GetFloat("Tolerance") == 0.02
    assert group.GetBool("AnalyzeAfterRecompute") and group.GetString("MarkSimulator") == LEGACY.name
    read = preferences.read()
    assert (read.image_width, read.tolerance, read.mark_simulator) == (1234, 0.02, LEGACY.name)
    assert read.image_height == Preferences().image_height


def test_default_preferences_match_the_documents():
    """
    The defaults are the paper's image size, the memory budget of docs/cost.md and a time budget of ten minutes.

    By default, the simulators of FreeCAD have their best accuracy.
    """
    chosen = Preferences()
    assert (chosen.image_width, chosen.image_height) == (800, 600)
    assert (chosen.legacy_accuracy, chosen.opengl_quality) == (0.1, 10)
    assert chosen.budget == {"memory_bytes": 1000e6, "seconds": 600}
    assert (chosen.tolerance, chosen.analyze_after_recompute) == (0.01, False)
    assert chosen.show_pills and chosen.warn_of_simulators


LIMITS = {
    "legacy_accuracy": (0.1, 1.0), "opengl_quality": (1, 10),  # limits of the sliders in FreeCAD's simulators
    "time_budget": (0.1, 1e6), "memory_budget": (1.0, 1e6), "image_width": (1, 10_000), "image_height": (1, 10_000),
    "tolerance": (1e-4, 1.0), "holder_diameter": (0.0, 1e4), "holder_length": (0.0, 1e4),
    "travel_x": (0.0, 1e6), "travel_y": (0.0, 1e6), "travel_z": (0.0, 1e6),
}  # fmt: skip


@pytest.mark.parametrize("name", LIMITS)
def test_number_outside_its_limits_is_replaced_by_the_default(name):
    for limit, onward in zip(LIMITS[name], (-1, 1)):
        beyond = limit + onward if isinstance(limit, int) else limit * 1.01**onward
        for value, read in ((limit, limit), (beyond, getattr(Preferences(), name))):
            preferences.write(**{name: value})
            assert getattr(preferences.read(), name) == read


def test_invalid_preferences_are_replaced_by_defaults():
    preferences.write(image_width=0, tolerance=-1.0, view_direction="Sideways", legacy_accuracy=float("nan"))
    assert preferences.read() == Preferences()


def test_shown_simulators_are_those_of_marks_and_columns():
    preferences.write(mark_simulator=ZBUFFER.name)
    assert preferences.read().simulators == (ZBUFFER.name,)
    preferences.write(result_columns=f"confidence,{LEGACY.name} time,{LEGACY.name} memory,{ZBUFFER.name} time")
    assert preferences.read().simulators == (ZBUFFER.name, LEGACY.name)


def test_every_preference_is_documented():
    for preference in fields(Preferences):
        assert preference.name in Preferences.__doc__


def test_smaller_tolerance_gives_more_trajectories(arc):
    few = analyzed(arc).trajectories
    preferences.write(tolerance=1e-4)
    assert analyzed(arc).trajectories > 2 * few


def test_image_size_and_view_change_the_estimate(arc):
    coarse = analyzed(arc).estimate
    preferences.write(image_width=1600, image_height=1200)
    fine = analyzed(arc).estimate
    assert fine.dexels == pytest.approx(4 * coarse.dexels, rel=0.02)
    preferences.write(view_direction="Front")
    assert analyzed(arc).estimate.view.direction == (0, 1, 0)


def test_legacy_accuracy_changes_the_cells(arc):
    fine = analyzed(arc).legacy
    preferences.write(legacy_accuracy=1.0)
    coarse = analyzed(arc).legacy
    assert coarse.resolution == pytest.approx(10 * fine.resolution) and fine.cells > 50 * coarse.cells


@pytest.mark.skipif(freecad.version() < (1, 0), reason="0.20 has no OpenGL simulator")
def test_opengl_quality_changes_the_draws(arc):
    best = analyzed(arc).opengl
    preferences.write(opengl_quality=1)
    assert analyzed(arc).opengl.draws < best.draws


def test_small_budgets_of_time_and_memory_give_cautions(arc):
    assert not [c for c in analyzed(arc).cautions if c.code in ("memory", "long-play")]
    pixels = analyzed(arc).resolution.view.width
    preferences.write(memory_budget=1.0, time_budget=0.1)
    found = analyzed(arc)
    assert {"memory", "long-play"} <= {caution.code for caution in found.cautions}
    assert found.resolution.view is None or found.resolution.view.width < pixels


def test_renderer_preference_selects_the_constants(arc, monkeypatch):
    from vkworkbench.document.computer import calibration

    asked = []

    def constants(_speed, renderer):
        asked.append(renderer)
        return DEFAULTS

    monkeypatch.setattr(calibration, "constants", constants)
    preferences.write(renderer="llvmpipe")
    analyzed(arc)
    assert asked == ["llvmpipe"]


@pytest.mark.parametrize("simulator", [ZBUFFER.name, LEGACY.name, OPENGL.name])
def test_mark_shows_the_cost_of_the_chosen_simulator(arc, small, simulator):
    preferences.write(mark_simulator=simulator)
    if simulator == OPENGL.name and freecad.version() < (1, 0):
        simulator = LEGACY.name  # FreeCAD 0.20 has no OpenGL simulator, so the mark shows the legacy simulator
    report = vkworkbench.analyze(arc)
    vkworkbench.mark(report)
    (found,), (total,) = report.operations, report.totals
    for obj, one in ((arc, found), (small.job, total)):
        assert marks.read(obj).cost(simulator) == one.cost(simulator)
        assert f"sim {ENGLISH.estimated_time(one.cost(simulator)[0], one.factor(simulator))}" in obj.Label2


def test_changed_preference_updates_marks_without_an_analysis(arc, small, monkeypatch):
    upkeep.watch()
    preferences.write(mark_simulator=ZBUFFER.name)
    report = vkworkbench.analyze(small.document)
    vkworkbench.mark(report)
    (found,) = report.operations
    fresh = [obj.Label2 for obj in (arc, small.job)]
    count, touched = small.document.UndoCount, list(arc.State)
    monkeypatch.setattr("vkworkbench.document.analysis.analyze", None)
    for simulator in (LEGACY.name, OWN, ZBUFFER.name):
        preferences.write(mark_simulator=simulator)
        shown = preferences.read().simulator
        assert f"sim {ENGLISH.estimated_time(found.cost(shown)[0], found.factor(shown))}" in arc.Label2
    assert [obj.Label2 for obj in (arc, small.job)] == fresh
    preferences.write(mark_simulator=LEGACY.name, time_budget=0.1)
    assert "⚠" in arc.Label2 and "⚠" in small.job.Label2
    preferences.write(mark_simulator=ZBUFFER.name, time_budget=600.0)
    assert [obj.Label2 for obj in (arc, small.job)] == fresh
    assert (small.document.UndoCount, list(arc.State)) == (count, touched)


def test_marks_are_updated_after_a_relevant_preference_changes(monkeypatch):
    observers, told, followed = [], [], []
    monkeypatch.setattr(upkeep, "_upkeep", None)
    monkeypatch.setattr(upkeep.FreeCAD, "addDocumentObserver", observers.append)
    monkeypatch.setattr(preferences, "observe", told.append)
    monkeypatch.setattr(upkeep, "follow_preferences", lambda: followed.append(True))
    upkeep.watch()
    upkeep.watch()
    assert len(observers) == len(told) == 1
    told[0]("tolerance")  # a changed tolerance does not change the text of any mark
    assert not followed
    told[0]("time_budget")
    assert followed


def test_totals_of_different_simulators_are_not_added(arc, small):
    other = small.add("Other", ARC)
    preferences.write(mark_simulator=ZBUFFER.name)
    vkworkbench.mark(vkworkbench.analyze(small.document))
    assert marks.read(small.job).cost(LEGACY.name)
    data = json.loads(other.VkWorkbenchMark)
    del data["costs"][LEGACY.name]
    other.VkWorkbenchMark = json.dumps(data)
    preferences.write(mark_simulator=LEGACY.name)
    vkworkbench.mark(vkworkbench.analyze(arc))
    assert not marks.read(small.job).cost(LEGACY.name) and "sim" not in small.job.Label2


@pytest.mark.parametrize("wanted", [False, True])
def test_analysis_after_recompute_depends_on_the_preference(example, wanted):
    preferences.write(analyze_after_recompute=wanted)
    drill = example.getObjectsByLabel("Drill holes")[0]
    unmarked = example.getObjectsByLabel("Bore")[0]
    vkworkbench.mark(vkworkbench.analyze(drill))
    upkeep.watch()
    example.UndoMode = 1
    before, steps = marks.read(drill).fingerprint, example.UndoCount
    drill.setExpression("FinalDepth", None)
    drill.FinalDepth = drill.FinalDepth.Value + 1
    example.recompute()
    assert marks.is_outdated(drill) != wanted
    assert (marks.read(drill).fingerprint != before) == wanted
    assert not marks.is_marked(unmarked)
    assert "Touched" not in drill.State and example.UndoCount == steps  # the change of a preference adds no undo step


def test_travel_of_the_machine_is_compared_with_the_whole_job(small):
    """Each of the two operations fits into the travel, but both together do not; the first operation has the remark."""
    small.add("Left", [("G0", {"X": 0, "Y": 0, "Z": 25}), ("G1", {"X": 20, "Z": 18, "F": 5})])
    small.add("Right", [("G0", {"X": 50, "Y": 5, "Z": 25}), ("G1", {"X": 60, "Z": 18, "F": 5})])

    def told(what):
        return [[remark.arguments for remark in row.remarks if remark.code == "beyond-travel"]
                for row in vkworkbench.analyze(what).operations]  # fmt: skip

    assert told(small.document) == [[], []]
    preferences.write(travel_x=59.0, travel_z=7.0)
    expected = {"axis": "X", "needed": 60.0, "travel": 59.0}
    assert told(small.document) == [[expected], []]
    preferences.write(travel_x=60.0)
    assert told(small.document) == [[], []]
