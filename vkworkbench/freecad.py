# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD calls things, and since which version: nothing else in the add-on knows.

A property is known by what it means. A document keeps the names of the FreeCAD that made it, so the newest name that an
object has is read, whatever FreeCAD runs. Loads no numpy: it is needed when FreeCAD starts.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

import FreeCAD

TOOLPATH = "Path::Feature"  # the type of all that has a Path
LINK = "App::Link"  # stands for another object, and answers for its properties
COMPOUND = "Path::FeatureCompound"  # the type of what has the paths of its members once more
# The workbench for machining and its menu: since 1.0, and before.
WORKBENCHES = {"CAMWorkbench": "&CAM", "PathWorkbench": "&Path"}
TREE_DOCKS = ("Combo View", "Model", "Tree view")  # docks with the tree: in 0.20, since 1.0, and one of its own
TASK_DOCKS = ("Combo View", "Tasks")  # docks with the task view: in 0.20, since 1.0
DESCRIPTION_HIDDEN_SINCE = (1, 0)  # the tree's Description column can be hidden, and is at first
QT6_SINCE = (1, 1)
TIME_PROPERTY_SINCE = (1, 0)  # App::PropertyTime


def version() -> tuple[int, int, int]:
    """Return the version of this FreeCAD, e.g. ``(0, 20, 2)``; a part that does not begin with a number is 0."""
    return _numbers(tuple(FreeCAD.Version()[:3]))


@lru_cache
def _numbers(parts: tuple[str, ...]) -> tuple[int, ...]:
    return tuple(int(re.match(r"\d*", part).group() or 0) for part in parts)


# FreeCAD's simulators by the names of their entries in core/simulators: what the menu calls them since which version,
# the newest first, with the context of that text and the command's name.
_SIMULATORS = {
    "legacy": (
        ((1, 1), "CAM_Simulator", "Legacy CAM Simulator", "CAM_Simulator"),
        ((1, 0), "CAM_Simulator", "CAM Simulator", "CAM_Simulator"),
        ((0,), "Path_Simulator", "CAM Simulator", "Path_Simulator"),
    ),
    "OpenGL": (
        ((1, 1), "CAM_Simulator", "CAM Simulator", "CAM_SimulatorGL"),
        ((1, 0), "CAM_Simulator", "New CAM Simulator", "CAM_SimulatorGL"),
    ),
}
_LEGACY_FIRST = (1, 1)  # a preference makes the button start the legacy simulator


def simulator_title(name: str) -> str | None:
    """Return what this FreeCAD's menu calls a simulator, in the user's language; None where it has none such."""
    entry = _simulator(name)
    return FreeCAD.Qt.translate(*entry[:2]) if entry else None


def simulator_command(name: str) -> str | None:
    """Return the name of the command that starts a simulator; None where this FreeCAD has none such."""
    entry = _simulator(name)
    return entry[2] if entry else None


def own_simulators() -> tuple[str, ...]:
    """Return the names of the simulators that this FreeCAD has."""
    return tuple(name for name in _SIMULATORS if _simulator(name))


def own_simulator() -> str:
    """Return the name of the simulator that this FreeCAD's own button starts."""
    chosen = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/CAM")
    legacy = version() >= _LEGACY_FIRST and chosen.GetBool("DefaultSimulatorLegacy", False)
    return "legacy" if legacy or _simulator("OpenGL") is None else "OpenGL"


def _simulator(name: str) -> tuple[str, str, str] | None:
    known = (entry for since, *entry in _SIMULATORS.get(name, ()) if version() >= since)
    return next(known, None)


@dataclass(frozen=True)
class Property:
    """A property, known by what it means.

    Attributes
    ----------
    newest : str
        Its name today.
    since : tuple of int
        The version that gave it this name.
    before : tuple of str
        Its names in versions before, the newest first.
    fingerprint : {"path", "setting"} or None
        Of which part of a mark's fingerprint it is: a change of it may make the mark outdated.
    """

    newest: str
    since: tuple[int, ...] = (0,)
    before: tuple[str, ...] = ()
    fingerprint: str | None = None

    @property
    def names(self) -> tuple[str, ...]:
        """tuple of str : all its names, the newest first."""
        return (self.newest, *self.before)

    @property
    def name(self) -> str:
        """str : its name in this FreeCAD."""
        return self.newest if version() >= self.since else self.before[0]

    def is_in(self, obj) -> bool:
        """Whether an object has it, set or not."""
        return any(hasattr(obj, name) for name in self.names)

    def values(self, obj) -> Iterator:
        """Return what an object has under its names, the newest first, without what is not set."""
        found = (getattr(obj, name, None) for name in self.names)
        return (value for value in found if value is not None)

    def of(self, obj, default=None):
        """Return its value, a default where an object does not have it or it is not set."""
        return next(self.values(obj), default)

    def number(self, obj) -> float | None:
        """Return its value as a number in FreeCAD's own units: mm, degrees, mm/s; None where it is no number."""
        value = self.of(obj)
        if isinstance(value, bool):
            return None
        try:
            return float(getattr(value, "Value", value))
        except (TypeError, ValueError):
            return None


# What has a toolpath, and what it is made from.
PATH = Property("Path", fingerprint="path")
PLACEMENT = Property("Placement", fingerprint="path")
BASE = Property("Base")
COPIES = Property("Copies")
CLEARANCE_HEIGHT = Property("ClearanceHeight")  # every operation of FreeCAD's that follows a shape has one
ACTIVE = Property("Active", fingerprint="setting")
CONTROLLER = Property("ToolController", fingerprint="setting")
POCKET_PATTERN = Property("ClearingPattern", since=(1, 1), before=("OffsetPattern",))
SURFACE_PATTERN = Property("CutPattern")
# A job and its stock.
OPERATIONS = Property("Operations")
TOOLS = Property("Tools")
GROUP = Property("Group", fingerprint="setting")
# Work offsets, G54 to G59; all operations are posted once for each.
FIXTURES = Property("Fixtures", fingerprint="setting")
STOCK = Property("Stock", fingerprint="setting")
MODEL = Property("Model")
SHAPE = Property("Shape", fingerprint="setting")
# A tool controller.
TOOL = Property("Tool", fingerprint="setting")
TOOL_NUMBER = Property("ToolNumber")
SPINDLE_SPEED = Property("SpindleSpeed")
HORIZONTAL_RAPID = Property("HorizRapid", fingerprint="setting")
VERTICAL_RAPID = Property("VertRapid", fingerprint="setting")
VERTICAL_FEED = Property("VertFeed")
GCODE = Property("Gcode")  # the lines of a file that FreeCAD imported as a custom operation
# A tool; the last name of its shape is that of 0.20's tools without a tool bit.
TOOL_SHAPE = Property("ShapeType", since=(1, 1), before=("ShapeName", "ToolType"), fingerprint="setting")
TOOL_SHAPE_FILE = Property("ShapeID", since=(1, 1), before=("BitShape",), fingerprint="setting")
DIAMETER = Property("Diameter", fingerprint="setting")
CORNER_RADIUS = Property("CornerRadius", fingerprint="setting")  # since 1.1
FLAT_RADIUS = Property("FlatRadius", fingerprint="setting")  # before 1.1: radius of a bull nose's flat part
TIP_ANGLE = Property("TipAngle", fingerprint="setting")
CUTTING_ANGLE = Property("CuttingEdgeAngle", fingerprint="setting")
TIP_DIAMETER = Property("TipDiameter", fingerprint="setting")  # of a V-bit's or chamfer mill's flat end

_PROPERTIES = tuple(entry for entry in globals().values() if isinstance(entry, Property))


def names_in_fingerprint(part: str) -> frozenset[str]:
    """Return the names of the properties on which a part of a mark's fingerprint, "path" or "setting", depends."""
    return frozenset(name for entry in _PROPERTIES if entry.fingerprint == part for name in entry.names)


def is_imported(obj) -> bool:
    """Whether a toolpath may come from a file: a custom operation, or an object that no operation of FreeCAD's makes.

    What another version has made has no proxy, but the properties of an operation, or of what dresses one up.
    """
    if GCODE.is_in(obj):
        return True
    return getattr(obj, "Proxy", None) is None and not (CLEARANCE_HEIGHT.is_in(obj) or BASE.is_in(obj))


def operation_name(obj) -> str:
    """Return FreeCAD's name of an operation's kind, e.g. ``"Profile"``: the module of its proxy, alike in all versions.

    In a document of another version the proxy may be missing; the name is then not that of an operation.
    """
    name = type(getattr(obj, "Proxy", None)).__module__.rpartition(".")[2]
    return name[len("Path") :] if name.startswith("Path") else name
