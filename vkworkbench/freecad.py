# SPDX-License-Identifier: LGPL-2.1-or-later
"""The names of FreeCAD's properties, commands and docks in each version.

All other modules read the names from this module.

A document contains the property names of the FreeCAD version that saved it. Therefore a property is read under the
newest of its names that the object has, in every FreeCAD version. This module does not load numpy, because it is loaded
when FreeCAD starts.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

import FreeCAD

TOOLPATH = "Path::Feature"  # Type of all objects with a toolpath.
LINK = "App::Link"  # Type of links, which have the properties of the linked object.
COMPOUND = "Path::FeatureCompound"  # Type of compounds, whose path consists of the paths of their members.
# The workbench for machining and its menu, since FreeCAD 1.0 and before.
WORKBENCHES = {"CAMWorkbench": "&CAM", "PathWorkbench": "&Path"}
TREE_DOCKS = ("Combo View", "Model", "Tree view")  # Docks with the tree: in 0.20, since 1.0, and the separate dock.
TASK_DOCKS = ("Combo View", "Tasks")  # Docks that show the task view: in 0.20, and since 1.0.
DESCRIPTION_HIDDEN_SINCE = (1, 0)  # First version that hides the tree's Description column by default.
QT6_SINCE = (1, 1)  # First version that uses Qt 6.
TIME_PROPERTY_SINCE = (1, 0)  # First version with App::PropertyTime.


def version() -> tuple[int, int, int]:
    """Return the version of this FreeCAD, such as ``(0, 20, 2)``.

    A part of the version that does not begin with a number is returned as 0.
    """
    return _numbers(tuple(FreeCAD.Version()[:3]))


@lru_cache
def _numbers(parts: tuple[str, ...]) -> tuple[int, ...]:
    return tuple(int(re.match(r"\d*", part).group() or 0) for part in parts)


# FreeCAD's simulators, by the names of their entries in core/simulators. Each simulator has a list, the newest entry
# first. An entry contains the first version of FreeCAD for which the entry is valid, the translation context of the
# menu text, the menu text, and the name of the command.
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
_LEGACY_FIRST = (1, 1)  # first version with a preference that makes FreeCAD's button start the legacy simulator


def simulator_title(name: str) -> str | None:
    """Return the menu text of a simulator in the user's language; None if this FreeCAD lacks the simulator."""
    entry = _simulator(name)
    return FreeCAD.Qt.translate(*entry[:2]) if entry else None


def simulator_command(name: str) -> str | None:
    """Return the name of the command that starts a simulator; None if this FreeCAD lacks the simulator."""
    entry = _simulator(name)
    return entry[2] if entry else None


def own_simulators() -> tuple[str, ...]:
    """Return the names of the simulators that this FreeCAD has."""
    return tuple(name for name in _SIMULATORS if _simulator(name))


def own_simulator() -> str:
    """Return the name of the simulator that FreeCAD's button starts."""
    chosen = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/CAM")
    legacy = version() >= _LEGACY_FIRST and chosen.GetBool("DefaultSimulatorLegacy", False)
    return "legacy" if legacy or _simulator("OpenGL") is None else "OpenGL"


def _simulator(name: str) -> tuple[str, str, str] | None:
    known = (entry for since, *entry in _SIMULATORS.get(name, ()) if version() >= since)
    return next(known, None)


@dataclass(frozen=True)
class Property:
    """A property of objects in FreeCAD documents, with its names in all versions."""

    newest: str  # name in the newest version
    since: tuple[int, ...] = (0,)  # first version with this name
    before: tuple[str, ...] = ()  # names in earlier versions, the newest first
    # {"path", "setting"} or None: part of the fingerprint of a mark in the tree; this part contains the property. If
    # the property changes, the mark is possibly outdated. The value is None if no fingerprint contains the property.
    fingerprint: str | None = None

    @property
    def names(self) -> tuple[str, ...]:
        """tuple of str : the names in all versions, the newest first."""
        return (self.newest, *self.before)

    @property
    def name(self) -> str:
        """str : the name in this FreeCAD."""
        return self.newest if version() >= self.since else self.before[0]

    def is_in(self, obj) -> bool:
        """Return whether an object has the property, even if the property is not set."""
        return any(hasattr(obj, name) for name in self.names)

    def values(self, obj) -> Iterator:
        """Yield the set values of an object under all names, the newest name first."""
        found = (getattr(obj, name, None) for name in self.names)
        return (value for value in found if value is not None)

    def of(self, obj, default=None):
        """Return the property's value in an object, or a default if the property is missing or not set."""
        return next(self.values(obj), default)

    def number(self, obj) -> float | None:
        """Return the property's value as a number in FreeCAD's units (mm, degrees, mm/s); None for other values."""
        value = self.of(obj)
        if isinstance(value, bool):
            return None
        try:
            return float(getattr(value, "Value", value))
        except (TypeError, ValueError):
            return None


# Properties of operations and of other objects with a toolpath.
PATH = Property("Path", fingerprint="path")
PLACEMENT = Property("Placement", fingerprint="path")
BASE = Property("Base")
COPIES = Property("Copies")
CLEARANCE_HEIGHT = Property("ClearanceHeight")  # a property of all FreeCAD operations that machine a shape
ACTIVE = Property("Active", fingerprint="setting")
CONTROLLER = Property("ToolController", fingerprint="setting")
POCKET_PATTERN = Property("ClearingPattern", since=(1, 1), before=("OffsetPattern",))
SURFACE_PATTERN = Property("CutPattern")
ALGORITHM = Property("Algorithm")  # Algorithm of a waterline operation.
# Properties of a job and of its stock.
OPERATIONS = Property("Operations")
TOOLS = Property("Tools")
GROUP = Property("Group", fingerprint="setting")
# Work offsets, G54 to G59. All operations are posted once for each work offset.
FIXTURES = Property("Fixtures", fingerprint="setting")
CYCLE_TIME = Property("CycleTime")
STOCK = Property("Stock", fingerprint="setting")
MODEL = Property("Model")
ADDED_GROUP = "Toolpath analysis"  # Group of the properties that this add-on adds.
HIDDEN_AND_OUTPUT = 4 | 8  # Attributes of an added property whose change does not recompute the object.
# Property for the objects that hold the workpiece (clamps). This add-on adds the property to a job.
CLAMPS = Property("ToolpathClamps", fingerprint="setting")
# Property for the previous job, whose finished part is the stock of this job. FreeCAD has no such property; this add-on
# adds it to a job.
PREVIOUS_JOB = Property("ToolpathPreviousJob", fingerprint="setting")
SHAPE = Property("Shape", fingerprint="setting")
# Properties of a tool controller.
TOOL = Property("Tool", fingerprint="setting")
TOOL_NUMBER = Property("ToolNumber")
SPINDLE_SPEED = Property("SpindleSpeed")
HORIZONTAL_RAPID = Property("HorizRapid", fingerprint="setting")
VERTICAL_RAPID = Property("VertRapid", fingerprint="setting")
VERTICAL_FEED = Property("VertFeed")
GCODE = Property("Gcode")  # Lines of a file that FreeCAD imported as a custom operation.
# Properties for the depths of an operation, and for the width and depth of a deburred edge.
START_DEPTH = Property("StartDepth")
FINAL_DEPTH = Property("FinalDepth")
DEBURRED_WIDTH = Property("Width")
EXTRA_DEPTH = Property("ExtraDepth")
# Properties of a tool. In FreeCAD 0.20, tools that are not tool bits have the property "ToolType".
TOOL_SHAPE = Property("ShapeType", since=(1, 1), before=("ShapeName", "ToolType"), fingerprint="setting")
TOOL_SHAPE_FILE = Property("ShapeID", since=(1, 1), before=("BitShape",), fingerprint="setting")
DIAMETER = Property("Diameter", fingerprint="setting")
CORNER_RADIUS = Property("CornerRadius", fingerprint="setting")  # Since 1.1.
FLAT_RADIUS = Property("FlatRadius", fingerprint="setting")  # Before 1.1: radius of a bull nose's flat part.
TIP_ANGLE = Property("TipAngle", fingerprint="setting")
CUTTING_ANGLE = Property("CuttingEdgeAngle", fingerprint="setting")
TIP_DIAMETER = Property("TipDiameter", fingerprint="setting")  # Flat end of a V-bit or chamfer mill.
CUTTING_EDGE_HEIGHT = Property("CuttingEdgeHeight", fingerprint="setting")  # A V-bit's edge above its cone.
TOOL_LENGTH = Property("Length", fingerprint="setting")
SHANK_DIAMETER = Property("ShankDiameter", fingerprint="setting")
# FreeCAD's tool bits have no holder. Users may add properties for the diameter and length of a holder to a tool bit.
HOLDER_DIAMETER = Property("HolderDiameter", fingerprint="setting")
HOLDER_LENGTH = Property("HolderLength", fingerprint="setting")

_PROPERTIES = tuple(entry for entry in globals().values() if isinstance(entry, Property))


def names_in_fingerprint(part: str) -> frozenset[str]:
    """Return the names of the properties in one part of the fingerprint of a mark in the tree: "path" or "setting"."""
    return frozenset(name for entry in _PROPERTIES if entry.fingerprint == part for name in entry.names)


def is_imported(obj) -> bool:
    """Return whether an object's toolpath possibly comes from a file.

    An object whose toolpath comes from a file is a custom operation, or has no proxy. But an operation or a dress-up
    that another FreeCAD version saved can have no proxy either; its properties show that its toolpath does not come
    from a file.
    """
    if GCODE.is_in(obj):
        return True
    return getattr(obj, "Proxy", None) is None and not (CLEARANCE_HEIGHT.is_in(obj) or BASE.is_in(obj))


def operation_name(obj) -> str:
    """Return FreeCAD's name for the type of an operation, such as ``"Profile"``, from the module of its proxy.

    If another FreeCAD version saved the document, the proxy may be missing. Without a proxy, the returned text is not
    the name of an operation.
    """
    name = type(getattr(obj, "Proxy", None)).__module__.rpartition(".")[2]
    return name[len("Path") :] if name.startswith("Path") else name
