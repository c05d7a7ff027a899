# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run pytest inside FreeCAD and leave with its exit status: freecadcmd tests/in_freecad.py, or freecad for the GUI.

FreeCAD passes no arguments on: pytest's are in the environment variable PYTEST_ADDOPTS.
"""

from __future__ import annotations

import sys

sys.modules_at_start = frozenset(sys.modules)  # a test looks at what FreeCAD's start has loaded

from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from inside_freecad import run_and_leave


def run():
    import pytest

    return pytest.main([])


run_and_leave(run)
