# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run something inside FreeCAD, in its window or without one, and end FreeCAD with its status."""

from __future__ import annotations

import os
import sys
import traceback

import FreeCAD


def run_and_leave(main):
    """Call main() once FreeCAD runs, and end with the status that it returns; with 1 where it raises."""

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
            os._exit(status)  # FreeCAD itself would end with 0, or ask to save a document

    if FreeCAD.GuiUp:
        from PySide import QtCore

        QtCore.QTimer.singleShot(0, run)  # once FreeCAD's event loop runs
    else:
        run()
