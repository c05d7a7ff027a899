# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's events, let happen by tests and benchmarks in a window."""

import time

from PySide import QtGui

_REST = 0.01  # s; to look again and again would take one processor, and Python's lock, from what is waited for


def happen():
    """Handle the events that are there, then rest a little."""
    QtGui.QApplication.processEvents()
    time.sleep(_REST)
