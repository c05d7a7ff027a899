# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stubs for the part of FreeCAD that the document layer needs to analyse and mark a job, in any Python.

    python3.8 tests/stubbed_freecad.py      # in a Python that no FreeCAD here has; needs numpy

Imports the whole package except the window, analyses a job with an operation of every strategy, marks the job, changes
a path and clears the marks. tests/core/test_vk_python.py runs this script in its own Python.
"""

from __future__ import annotations

import importlib
import pkgutil
import sys
import tempfile
from pathlib import Path
from types import ModuleType, SimpleNamespace
from unittest.mock import MagicMock

sys.path[:0] = [str(Path(__file__).parents[1]), str(Path(__file__).parent)]
import programs


class Parameters:
    """A preference group in which every preference has its default value."""

    def __getattr__(self, name):
        return lambda parameter, default=None: default


class Placement:
    Base, Rotation = (0.0, 0.0, 0.0), SimpleNamespace(Q=(0.0, 0.0, 0.0, 1.0))

    def isIdentity(self):
        return True

    def toMatrix(self):
        return SimpleNamespace(A=[float(i % 5 == 0) for i in range(16)])


class Command:
    def __init__(self, name, words):
        self.Name, self.Parameters = name, words

    def toGCode(self):
        return " ".join([self.Name, *(f"{letter}{value:.6f}" for letter, value in self.Parameters.items())])


class Toolpath:
    def __init__(self, commands):
        self.Commands, self.Size = commands, len(commands)

    def toGCode(self):
        return "".join(command.toGCode() + "\n" for command in self.Commands)


class Document:
    Name, Uid = "Stub", "of the stub"
    Restoring = Importing = Transacting = HasPendingTransaction = False

    def __init__(self):
        self.Objects = []

    def getObject(self, name):
        return next((obj for obj in self.Objects if obj.Name == name), None)

    def openTransaction(self, name):
        pass


class Object:
    Label2, ExpressionEngine, Placement, Proxy = "", (), Placement(), object()

    def __init__(self, document, name, type_name="Path::Feature", **properties):
        self.Name = self.Label = name
        self.Document, self.InList = document, []
        self._type, self._added = type_name, {}
        vars(self).update(properties)
        document.Objects.append(self)

    def isDerivedFrom(self, type_name):
        return type_name == self._type

    @property
    def PropertiesList(self):
        return list(self._added)

    def addProperty(self, type_id, name, group, doc, attributes):
        self._added[name] = type_id, group
        setattr(self, name, "" if type_id == "App::PropertyString" else 0.0)

    def removeProperty(self, name):
        delattr(self, name)
        return bool(self._added.pop(name))

    def getGroupOfProperty(self, name):
        return self._added[name][1]

    def getTypeIdOfProperty(self, name):
        return self._added[name][0]

    def getPropertyStatus(self, name):
        return []

    def getTypeOfProperty(self, name):
        return ["ReadOnly", "Output", "Hidden"]


def stub(document, folder):
    """Replace FreeCAD's modules by stubs."""
    freecad, part = ModuleType("FreeCAD"), ModuleType("Part")
    freecad.Version, freecad.GuiUp = lambda: ["0", "21", "2"], 0
    freecad.Qt = SimpleNamespace(QT_TRANSLATE_NOOP=lambda context, text: text)
    freecad.ParamGet, freecad.getUserAppDataDir = lambda group: Parameters(), lambda: folder
    freecad.listDocuments, freecad.ActiveDocument = lambda: {document.Name: document}, document
    freecad.getDocument = {document.Name: document}.__getitem__
    freecad.getActiveTransaction = lambda: None
    freecad.Console = freecad.closeActiveTransaction = freecad.addDocumentObserver = MagicMock()
    part.Shape, part.Plane, part.Cylinder = (type(name, (), {}) for name in ("Shape", "Plane", "Cylinder"))
    part.makeBox = MagicMock()
    sys.modules.update(FreeCAD=freecad, Part=part)
    sys.modules.update(dict.fromkeys(("Mesh", "MeshPart", "Path", "PathSimulator"), MagicMock()))


def a_job(document):
    """Return the operations of a job, one operation per strategy."""
    bit = Object(document, "Bit", "App::FeaturePython", Diameter=5.0, ShapeName="endmill")
    controller = Object(
        document, "Controller", ToolNumber=1, SpindleSpeed=1.0, Tool=bit, HorizRapid=50.0, VertRapid=50.0
    )
    operations = [
        Object(document, name.title(), Path=Toolpath([Command(*one) for one in make()]), ToolController=controller, Active=True)
        for name, make in programs.SOUND.items()
    ]  # fmt: skip
    group = Object(document, "Operations", "App::DocumentObjectGroup", Group=operations)
    job = Object(document, "Job", Operations=group, Tools=group, Stock=None, Fixtures=["G54"])
    group.InList = [job]
    for operation in operations:
        operation.InList = [group]
    return operations


def main():
    document = Document()
    with tempfile.TemporaryDirectory() as folder:
        stub(document, folder)
        import vkworkbench

        names = [found.name for found in pkgutil.walk_packages(vkworkbench.__path__, "vkworkbench.")]
        names = [name for name in names if not name.startswith("vkworkbench.gui") and not name.endswith("__main__")]
        for name in names:
            importlib.import_module(name)
        from vkworkbench.core.simulators import DEFAULTS, Conditions
        from vkworkbench.document.computer import calibration
        from vkworkbench.document.job import path_prints
        from vkworkbench.document.marks import marks, watcher

        calibration.constants = lambda speed, renderer: DEFAULTS
        calibration.measured_speed = lambda going_on: Conditions(version=(0, 21)).speed
        operations = a_job(document)
        report = vkworkbench.analyze(document, cancelled=lambda: False)
        print(report)
        report.to_csv(Path(folder) / "report.csv")
        report.to_json(Path(folder) / "report.json")
        assert not any("Please report" in (row.error or "") for row in report.operations)
        assert vkworkbench.mark(report) == len(operations)
        assert not any(map(marks.is_outdated, operations))
        operations[0].Path = Toolpath(operations[0].Path.Commands[:-2])
        path_prints.PATH_PRINTS.slotChangedObject(operations[0], "Path")
        watcher.check(document)
        assert [marks.is_outdated(obj) for obj in operations] == [True] + [False] * (len(operations) - 1)
        assert vkworkbench.clear(document) == len(operations) + 1
        assert not any(obj.Label2 or obj.PropertiesList for obj in document.Objects)
    print(f"Python {sys.version.split()[0]}: {len(names)} modules, {len(operations)} operations analysed and marked")


if __name__ == "__main__":
    main()
