# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognise the strategy of an operation of a document, for its mark in the tree, the Gauss map and the 3D view."""

from __future__ import annotations

from dataclasses import dataclass

from vkworkbench import preferences
from vkworkbench.core import Problem, Recognition, Toolpath, recognize
from vkworkbench.core.gcode import looks_like_inches
from vkworkbench.core.recognition import recognize_inches
from vkworkbench.document.job.operations import is_imported
from vkworkbench.document.job.setting import read_tool


@dataclass(frozen=True)
class Source:
    """Copies of the properties that determine an operation's strategy. Another thread may read these copies.

    Attributes
    ----------
    path : Path
    placement : Placement
    tool_diameter : float or None
        Diameter of the tool, mm; None for an unreadable tool.
    imported : bool
        Whether the toolpath may come from a file.
    tolerance : float
        Largest distance between an arc and its chords, mm.
    """

    path: object
    placement: object
    tool_diameter: float | None
    imported: bool
    tolerance: float


def source_of(obj) -> Source:
    """Return copies of the properties that determine an operation's strategy."""
    try:
        diameter = read_tool(obj).diameter
    except ValueError:
        diameter = None
    return Source(obj.Path, obj.Placement, diameter, is_imported(obj), preferences.read().tolerance)


def rotary_cut(toolpath: Toolpath) -> Problem | None:
    """Return the problem that a rotary axis turns while the tool cuts, so the cut shape is unknown; else None."""
    turning = (problem for problem in toolpath.problems if problem.what.code == "rotary-cuts")
    return next(turning, None) if len(toolpath) else None


def recognize_operation(toolpath: Toolpath, tool_diameter: float | None, imported: bool) -> tuple[Recognition, bool]:
    """Return the strategy of an operation's toolpath, and whether FreeCAD has read its inches as millimetres.

    The toolpath is moved by the placement of its operation. `imported` is True if the toolpath possibly comes from a
    file, whose G20 (inches) FreeCAD's importer ignores.
    """
    if (
        imported
        and not toolpath.hidden_cuts
        and looks_like_inches(toolpath, tool_diameter=tool_diameter, imported=True)
    ):
        return recognize_inches(toolpath, tool_diameter=tool_diameter, program=True), True
    return recognize(toolpath, tool_diameter=tool_diameter, program=imported), False
