# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run pytest inside FreeCAD and exit with its status: freecadcmd tests/in_freecad.py, or freecad for a window.

FreeCAD does not pass arguments to scripts, so pytest's arguments are in the environment variable PYTEST_ADDOPTS.
"""

from __future__ import annotations

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


def run():
    import pytest

    if FreeCAD.GuiUp:
        load_cam()
    return pytest.main([])


run_and_leave(run)
