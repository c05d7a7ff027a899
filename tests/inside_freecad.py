# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run a function inside FreeCAD, with or without its window, and end FreeCAD with the function's status."""

from __future__ import annotations

import os
import sys
import traceback

import FreeCAD


def run_and_leave(main):
    """Call main() when FreeCAD runs. End with the returned status, or with 1 if main() raises an exception."""

    def run():
        # In FreeCAD's window, sys.stdout and sys.stderr write to the report view, which is not visible during tests.
        sys.stdout, sys.stderr = sys.__stdout__, sys.__stderr__
        status = 1
        try:
            status = int(main())
        except BaseException:
            traceback.print_exc()
        finally:
            sys.stdout.flush()
            sys.stderr.flush()
            os._exit(status)  # FreeCAD itself would exit with 0, or ask to save a document

    if FreeCAD.GuiUp:
        from PySide import QtCore

        QtCore.QTimer.singleShot(0, run)  # The function runs when FreeCAD's event loop has started.
    else:
        run()
