# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strategy of an operation, told in one place: mark, Gauss map and 3D view show the same numbers."""

from __future__ import annotations

from dataclasses import dataclass

from vkworkbench import preferences
from vkworkbench.core import Problem, Recognition, Toolpath, recognize
from vkworkbench.core.gcode import looks_like_inches
from vkworkbench.core.recognition import recognize_inches, unknown
from vkworkbench.document.job.operations import is_imported
from vkworkbench.document.job.setting import read_tool


@dataclass(frozen=True)
class Source:
    """Copies of what an operation's strategy is told from, which another thread may read.

    Attributes
    ----------
    path : Path
    placement : Placement
    tool_diameter : float or None
        mm; None where no tool can be read.
    imported : bool
        Whether the toolpath may come from a file.
    tolerance : float
        mm between an arc and its chords.
    """

    path: object
    placement: object
    tool_diameter: float | None
    imported: bool
    tolerance: float


def source_of(obj) -> Source:
    """Copy what an operation's strategy is told from."""
    try:
        diameter = read_tool(obj).diameter
    except ValueError:
        diameter = None
    return Source(obj.Path, obj.Placement, diameter, is_imported(obj), preferences.read().tolerance)


def turns(toolpath: Toolpath) -> Problem | None:
    """Return that a rotary axis turns while the tool cuts, where one does: nobody knows what is cut then."""
    turning = (problem for problem in toolpath.problems if problem.what.code == "rotary-cuts")
    return next(turning, None) if len(toolpath) else None


def recognized(toolpath: Toolpath, tool_diameter: float | None, imported: bool) -> tuple[Recognition, bool]:
    """Return what a toolpath of a document does, and whether its inches were read as millimetres.

    Parameters
    ----------
    toolpath : Toolpath
        Where its operation's placement puts it.
    tool_diameter : float or None
        mm.
    imported : bool
        Whether it may come from a file: FreeCAD's importer drops G20.
    """
    turning = turns(toolpath)
    if turning:
        return unknown(toolpath, turning.remark), False
    if imported and looks_like_inches(toolpath, tool_diameter=tool_diameter, imported=True):
        return recognize_inches(toolpath, tool_diameter=tool_diameter, program=True), True
    return recognize(toolpath, tool_diameter=tool_diameter, program=imported), False
