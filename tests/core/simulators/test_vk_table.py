# SPDX-License-Identifier: LGPL-2.1-or-later
"""The code's table of simulators: every entry is complete, and a new simulator needs only one more entry."""

from __future__ import annotations

import csv
import json
from dataclasses import dataclass, fields, replace
from pathlib import Path
from xml.etree import ElementTree

import pytest

from vkworkbench import preferences
from vkworkbench.core import Stock, Tool, linearize, machining, recognize
from vkworkbench.core.gcode import Words
from vkworkbench.core.simulators import costs, kept, preflight, table
from vkworkbench.core.simulators.opengl import opengl_speeds
from vkworkbench.core.simulators.simulator import Caution, Conditions, Task
from vkworkbench.core.simulators.table import LEGACY, OPENGL, SIMULATORS, ZBUFFER, available
from vkworkbench.language import Message
from vkworkbench.report import OperationReport, Report

ROOT = Path(__file__).parents[3]
ROWS = [("G0", {"X": 5.0, "Y": 5.0, "Z": 30.0}), ("G1", {"Z": 15.0, "F": 5.0})]
ROWS += [("G1", {"X": 5.0 + 50 * (i % 4 in (0, 1)), "Y": 5.0 + 2 * ((i + 1) // 2)}) for i in range(20)]
STOCK = Stock((0, 0, 0), (60, 40, 20))


def translated(language):
    """Return the translated texts of a language by context and English text."""
    tree = ElementTree.parse(ROOT / "resources" / "translations" / f"VkWorkbench_{language}.ts").getroot()
    return {
        (context.findtext("name"), message.findtext("source")): message.findtext("translation")
        for context in tree.iter("context")
        for message in context.iter("message")
    }


def texts(simulator):
    """Yield (translation context, text) for every text that the user sees in a simulator's table entry."""
    for name in ("time_tooltip", "memory_tooltip"):
        yield "Vk_Results", getattr(simulator, name)


@pytest.mark.parametrize("language", ["de", "fr", "es-ES", "zh-CN"])
def test_every_text_of_a_simulators_entry_is_translated(language):
    known = translated(language)
    for simulator in SIMULATORS:
        for key in texts(simulator):
            assert known.get(key), (simulator.name, key)


def test_table_entries_of_simulators_have_different_columns():
    names = [simulator.name for simulator in SIMULATORS]
    columns = [name for s in SIMULATORS for name in (*s.columns, s.factor_column) if name]
    for unique in (names, columns):
        assert len(set(unique)) == len(unique)
    assert preferences.OWN not in names and SIMULATORS[0] is ZBUFFER


def test_preferences_that_a_simulator_names_exist_in_the_form():
    known = {field.name for field in fields(preferences.Preferences)}
    form = (ROOT / "resources" / "ui" / "preferences.ui").read_text(encoding="utf-8")
    for simulator in SIMULATORS:
        assert set(simulator.preferences) <= known
        for name in simulator.preferences:
            assert f'name="{name}"' in form and f'name="{name}_label"' in form


@dataclass(frozen=True)
class WireframeCost:
    """The cost of a simulator that needs a second for every trajectory."""

    seconds: float
    memory_bytes: float
    factor: float = 3.0


WIREFRAME = replace(
    LEGACY,
    name="wireframe",
    since=(1, 2),
    predict=lambda task, conditions: WireframeCost(float(len(task.toolpath)), 1e3 * len(task.motions.command)),
    together=lambda costs: WireframeCost(sum(c.seconds for c in costs), sum(c.memory_bytes for c in costs)),
    cautions=lambda task, cost, conditions: [Caution("wires", Message("leave-out"))],
    kept=WireframeCost,
    less_memory=Message("fewer-operations"),
    columns={"wireframe_seconds": lambda cost: cost.seconds},
    factor_column="wireframe_factor",
)


@pytest.fixture
def wireframe(monkeypatch):
    for module in (table, costs, kept):
        monkeypatch.setattr(module, "SIMULATORS", (*SIMULATORS, WIREFRAME))
    return WIREFRAME


def row(version):
    words = Words(ROWS)
    path = linearize(words)
    task = Task(path, Tool("endmill", 5.0), STOCK, words, recognize(path))
    conditions = Conditions(version=version, memory_budget=1.5e4)
    predicted, advice = table.predict(task, conditions)
    return OperationReport(
        document="D", name="Op", label="Rows", job="Job", counted=True, recognition=task.recognition,
        trajectories=len(path), machining=machining(path), costs=predicted, advice=advice,
        cautions=preflight(task, predicted, conditions), remarks=(), fingerprint="",
    )  # fmt: skip


def test_new_table_entry_of_a_simulator_appears_everywhere(wireframe, tmp_path):
    operation = row((1, 2))
    count = operation.trajectories
    assert operation.cost("wireframe") == (float(count), 1e3 * count) and operation.factor("wireframe") == 3.0
    codes = [(caution.code, caution.what.code) for caution in operation.cautions]
    assert ("wires", "leave-out") in codes
    assert any("wireframe" in caution.message for caution in operation.cautions if caution.code == "memory")

    budget = {"memory_bytes": 1e9, "seconds": 1e3}
    both = Report((operation, replace(operation, name="Other")), {("D", "Job"): "Job"}, budget)
    (total,) = both.totals
    assert total.cost("wireframe") == (2.0 * count, 2e3 * count)
    both.to_csv(str(tmp_path / "report.csv"))
    both.to_json(str(tmp_path / "report.json"))
    with open(tmp_path / "report.csv", newline="", encoding="utf-8") as file:
        first = next(csv.DictReader(file))
    assert float(first["wireframe_seconds"]) == count and float(first["wireframe_factor"]) == 3.0
    data = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    assert data["totals"][0]["wireframe_seconds"] == 2 * count
    as_kept = json.loads(json.dumps(kept.as_data("wireframe", total.costs["wireframe"])))
    assert kept.from_data("wireframe", as_kept) == total.costs["wireframe"]


def test_cost_prediction_needs_a_tool_and_a_stock():
    path, tool = linearize(ROWS), Tool("endmill", 5.0)
    assert Task(path, tool, STOCK).cutting == (tool, STOCK)
    for known in ((None, STOCK), (tool, None), (None, None)):
        with pytest.raises(ValueError, match="without tool and stock"):
            Task(path, *known).cutting  # noqa: B018


def test_str_of_a_caution_is_its_message():
    caution = Caution("wires", Message("leave-out"))
    assert str(caution) == caution.message != ""


def test_recommended_image_is_the_advice_for_the_zbuffer():
    operation = row((1, 1))
    assert operation.resolution is operation.advice["z-buffer"] is not None


def test_macros_read_the_costs_of_freecads_simulators_by_name():
    operation, unknown = row((1, 1)), row(())
    assert operation.legacy is operation.costs["legacy"] and operation.opengl is operation.costs["OpenGL"]
    assert (unknown.legacy, unknown.opengl) == (None, None)


def test_mistyped_simulator_name_is_refused():
    operation = row(())
    total = Report((operation,), {("D", "Job"): "Job"}, {"memory_bytes": 1e9, "seconds": 1e3}).totals[0]
    for of in (operation, total):
        assert of.cost("OpenGL") is None and of.factor("OpenGL") == 1.0
        for ask in (of.cost, of.factor):
            with pytest.raises(ValueError, match="no simulator 'opengl': choose among z-buffer, legacy, OpenGL"):
                ask("opengl")


def test_simulator_missing_in_freecad_has_no_cost(wireframe):
    operation = row((1, 1))
    assert set(operation.costs) == {"z-buffer", "legacy", "OpenGL"}
    assert operation.cost("wireframe") is None and operation.factor("wireframe") == 1.0
    assert operation.as_dict()["wireframe_seconds"] is None
    assert set(row(()).costs) == {"z-buffer"}


def test_versions_have_the_simulators_and_speeds_of_freecad():
    assert available(()) == (ZBUFFER,)
    assert available((0, 20, 2)) == available((0, 21)) == (ZBUFFER, LEGACY)
    assert available((1, 0, 0)) == available((1, 1, 3)) == (ZBUFFER, LEGACY, OPENGL)
    assert opengl_speeds((1, 0, 0)) == (1, 10, 40)
    assert opengl_speeds((1, 1, 3)) == (1, 5, 10, 25, 50)
