# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run pytest inside FreeCAD and exit with its status: freecadcmd tests/in_freecad.py, or freecad for a window.

FreeCAD does not pass arguments to scripts, so pytest's arguments are in the environment variable PYTEST_ADDOPTS.
"""

from __future__ import annotations

import copy
import sys

sys.modules_at_start = frozenset(sys.modules)  # tests/gui/test_vk_start.py checks which modules FreeCAD's start loads

from pathlib import Path

import FreeCAD

sys.path.insert(0, str(Path(__file__).parent))
from inside_freecad import run_and_leave


def load_cam():
    """Load the CAM workbench while the Python stack is short, because each of its commands inspects all frames."""
    import FreeCADGui as Gui

    Gui.activateWorkbench("CAMWorkbench" if "CAMWorkbench" in Gui.listWorkbenches() else "PathWorkbench")
    Gui.activateWorkbench("NoneWorkbench")


def keep_tool_shapes():
    """Read each tool shape once. FreeCAD 1.1 would open the shape's file for each tool of each opened document."""
    try:
        from Path.Tool.shape import ToolBitShape
    except ImportError:  # FreeCAD 0.20 and 1.0 have no module Path.Tool.shape
        return
    read, kept = ToolBitShape.from_bytes, {}

    def from_bytes(data, name, dependencies, serializer):
        if (name, data) not in kept:
            kept[name, data] = read(data, name, dependencies, serializer)
        shape = copy.copy(kept[name, data])
        for changeable in ("_params", "_defaults", "_param_types"):
            setattr(shape, changeable, dict(getattr(shape, changeable)))
        return shape

    ToolBitShape.from_bytes = staticmethod(from_bytes)


def run():
    import pytest

    if FreeCAD.GuiUp:
        load_cam()
    keep_tool_shapes()
    return pytest.main([])


run_and_leave(run)
