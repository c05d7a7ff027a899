# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's events, let happen by tests and benchmarks in a window."""

import time

from PySide import QtGui

_REST = 0.01  # s; without a rest the window would take a processor, and Python's lock, from the awaited work


def happen():
    """Handle the events that are there, then rest a little."""
    QtGui.QApplication.processEvents()
    time.sleep(_REST)
