# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run pytest inside FreeCAD and leave with its exit status: freecadcmd tests/in_freecad.py, or freecad for the GUI.

FreeCAD passes no arguments on: pytest's are in the environment variable PYTEST_ADDOPTS.
"""

from __future__ import annotations

import os
import sys

import FreeCAD

sys.modules_at_start = frozenset(sys.modules)  # a test looks at what FreeCAD's start has loaded


def run():
    # In a window these are FreeCAD's report view, which nobody sees here.
    sys.stdout, sys.stderr = sys.__stdout__, sys.__stderr__
    status = 1
    try:
        import pytest

        status = int(pytest.main([]))
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)  # FreeCAD itself would end with 0, or ask to save a document


if FreeCAD.GuiUp:
    from PySide import QtCore

    QtCore.QTimer.singleShot(0, run)  # once FreeCAD's event loop runs
else:
    run()
