# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tab of *Simulate toolpaths* in tests: opened by a click, waited for, dragged in."""

from __future__ import annotations

import sys
import threading
import traceback

from PySide import QtCore

from vkworkbench.gui.simulation.tab import SimulationTab

COMMAND = "Simulate toolpaths"


def tabs(window):
    return [tab for tab in window.find(SimulationTab) if tab.isVisible()]


def shown(tab, window):
    """Wait until the job has been read and simulated at its finest; return what shows it."""
    window.wait(lambda: tab.player is not None and tab.player.simulation is not None, 120)
    finest(tab.player, window)
    return tab.player


def finest(player, window):
    """Wait until the picture is the finest that was asked for."""
    window.idle(0.4)
    window.wait(lambda: not player.is_busy and player.pictures.is_current, 300)
    window.idle(0.1)


def drag(window, widget, start, end, button=QtCore.Qt.LeftButton, steps=6):
    """Drag with real mouse events."""
    window.mouse_press(widget, start, button)
    for number in range(1, steps + 1):
        part = QtCore.QPoint(start.x() + (end.x() - start.x()) * number // steps,
                             start.y() + (end.y() - start.y()) * number // steps)  # fmt: skip
        window.mouse_move(widget, part, button)
    window.mouse_release(widget, end, button)


def working():
    """The functions that threads of their own are in, from the outermost."""
    frames = sys._current_frames()
    own = threading.get_ident()
    return [entry.name for thread, frame in frames.items() if thread != own for entry in traceback.extract_stack(frame)]
