# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handle FreeCAD's events in tests and benchmarks with a window."""

import time

from PySide import QtGui

_REST = 0.01  # s; without a rest, the window would take a processor, and the GIL, from the awaited work


def happen():
    """Handle the pending events, then rest a little."""
    QtGui.QApplication.processEvents()
    time.sleep(_REST)
