# SPDX-License-Identifier: LGPL-2.1-or-later
"""Only `freecad.py` names FreeCAD's properties and versions; the watcher watches all properties that marks need."""

import ast
from pathlib import Path
from types import SimpleNamespace

import FreeCAD
import pytest

import vkworkbench
from vkworkbench import freecad
from vkworkbench.document.job import operations, setting
from vkworkbench.document.job.fingerprint import read_setting_fingerprints

PACKAGE = Path(vkworkbench.__file__).parent
PROPERTIES = {name: entry for name, entry in vars(freecad).items() if isinstance(entry, freecad.Property)}


@pytest.mark.parametrize(
    "words, numbers",
    [
        (["0", "20", "2", "29177 +426 (Git)"], (0, 20, 2)),
        (["1", "1", "3", "", ""], (1, 1, 3)),
        (["1", "10", "0rc2", ""], (1, 10, 0)),
        (["0", "19", "24291 (Git)", "https"], (0, 19, 24291)),
        (["1", "2", "dev"], (1, 2, 0)),
    ],
)
def test_version_of_freecad_is_read_as_numbers(words, numbers, monkeypatch):
    monkeypatch.setattr(FreeCAD, "Version", lambda: words)
    assert freecad.version() == numbers


def test_newest_property_name_of_an_object_is_read():
    shape = freecad.TOOL_SHAPE
    assert shape.of(SimpleNamespace(ShapeName="endmill")) == "endmill"
    assert shape.of(SimpleNamespace(ShapeName="endmill", ShapeType="Drill")) == "Drill"
    assert list(shape.values(SimpleNamespace(ShapeName="endmill", ShapeType=None))) == ["endmill"]
    assert shape.of(SimpleNamespace()) is None and shape.of(SimpleNamespace(), "drill") == "drill"
    assert shape.is_in(SimpleNamespace(ShapeType=None)) and not shape.is_in(SimpleNamespace(Shape=1))


def test_quantity_with_a_unit_is_read_in_millimetres():
    quantity = FreeCAD.Units.Quantity("1 in")
    assert freecad.DIAMETER.number(SimpleNamespace(Diameter=quantity)) == pytest.approx(25.4)
    assert freecad.DIAMETER.number(SimpleNamespace(Diameter=5)) == 5.0
    assert freecad.DIAMETER.number(SimpleNamespace()) is None


def test_pocket_pattern_property_exists_in_freecad(example):
    pocket = example.getObjectsByLabel("Pocket zigzag")[0]
    assert freecad.POCKET_PATTERN.name in pocket.PropertiesList
    assert freecad.POCKET_PATTERN.of(pocket) == "ZigZag"
    assert freecad.operation_name(pocket) in ("Pocket", "PocketShape")


class Spy:
    """A wrapper around an object that records which properties are read."""

    def __init__(self, obj, read):
        self._obj, self._read = obj, read

    def __getattr__(self, name):
        value = getattr(self._obj, name)
        if name in self._obj.PropertiesList:
            self._read.add(name)
        return Spy(value, self._read) if hasattr(value, "PropertiesList") else value


def test_all_fingerprinted_properties_are_watched(example):
    read = set()
    for operation in operations.find(example):
        if operation.counted:
            obj, job = (Spy(one, read) for one in (operation.object, operation.job))
            spied = read_setting_fingerprints(obj, job)
            assert spied == read_setting_fingerprints(operation.object, operation.job)
    assert {"ToolController", "Tool", "Diameter", "Stock", "Shape"} <= read
    # Two properties need not be watched: Base changes together with Group, and Label is used in messages only.
    untold = {"Base", "Label"}
    assert read - untold <= freecad.names_in_fingerprint("setting")


def names_in(code):
    """Return the strings and attributes in a Python file."""
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.Constant):
            yield node.value
        elif isinstance(node, ast.Attribute):
            yield node.attr


def test_only_freecad_py_names_cam_properties():
    # Properties that FreeCAD itself defines have these names in every version, so any file may use the names.
    core = {"Path", "Placement", "Shape", "Group", "Base", "Length"}
    names = {name for entry in PROPERTIES.values() for name in entry.names} - core
    for folder in ("document", "gui"):
        for path in (PACKAGE / folder).rglob("*.py"):
            assert names.isdisjoint(names_in(path.read_text(encoding="utf-8"))), path
    assert names & set(names_in("obj.ToolController = bit\ngetattr(bit, 'Diameter')")) == {"ToolController", "Diameter"}


def test_only_freecad_py_reads_the_version():
    for path in PACKAGE.rglob("*.py"):
        if path.name != "freecad.py":
            assert "FreeCAD.Version" not in path.read_text(encoding="utf-8"), path


def test_tools_of_all_freecad_versions_are_read():
    bullnose = {"Diameter": 10.0, "Label": "T1"}
    for bit in (
        SimpleNamespace(ShapeType="Bullnose", CornerRadius=2.0, **bullnose),
        SimpleNamespace(ShapeName="bullnose", FlatRadius=3.0, **bullnose),
        SimpleNamespace(ToolType="BullNose", CornerRadius=0.0, FlatRadius=3.0, **bullnose),
    ):
        operation = SimpleNamespace(Name="Op", ToolController=SimpleNamespace(Label="TC", Tool=bit))
        tool = setting.read_tool(operation)
        assert (tool.shape, tool.corner_radius) == ("bullnose", 2.0)
