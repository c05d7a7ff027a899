# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first steps of a new user, in the order of docs/guide.md, in a FreeCAD with a new home folder.

test_vk_stranger.py starts FreeCAD with the document to open and this file as arguments.
"""

from __future__ import annotations

import sys
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "gui"), str(HERE)]  # gui first, because the next import needs tests/gui/conftest.py

from conftest import CAM_WORKBENCH, Window
from inside_freecad import run_and_leave
from simulation_window import SMALL, tabs

import vkworkbench
from vkworkbench.document.marks import marks


def main() -> int:
    assert HERE.parent not in Path(vkworkbench.__file__).resolve().parents, "not the release"
    window = Window()
    window.main.show()
    window.idle(1.0)  # s; wait for the questions that FreeCAD asks at its first start
    document = FreeCAD.ActiveDocument
    # In FreeCAD 0.20, the workbench first asks about units, in a box with its own event loop.
    answering = QtCore.QTimer()
    answering.timeout.connect(window.dismiss)
    answering.start(200)
    Gui.activateWorkbench(CAM_WORKBENCH)
    window.settle()
    answering.stop()

    Gui.SendMsgToActiveView("ViewFit")
    step(window, "Analyze Toolpaths", "Vk_Analyze")
    window.wait(lambda: marks.is_marked(document.getObject("Job")), 60)
    window.settle()
    said = window.dismiss()
    assert all("Description" in text for text in said), said
    window.tree.expandAll()
    window.screenshot("stranger-1-marks")
    assert window.descriptions()["Face"].startswith("⟦zigzag")

    step(window, "Toolpath Results", "Vk_Results")
    window.wait(lambda: is_shown(window, "Toolpath Results"))

    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.getObjectsByLabel("Face")[0])
    step(window, "Gauss Map", "Vk_GaussMap")
    window.wait(lambda: is_shown(window, "Gauss Map"))
    window.settle()
    window.screenshot("stranger-2-gauss-map")

    Gui.Selection.clearSelection()
    step(window, "Show Strategies", "Vk_Strategies")
    window.settle()
    window.screenshot("stranger-3-strategies")

    window.main.setGeometry(0, 0, *SMALL)  # in a small window, the simulation is faster
    step(window, "Simulate Toolpaths", "Vk_Simulate")
    window.wait(lambda: tabs(window))
    (tab,) = tabs(window)
    window.wait(lambda: tab.player is not None and tab.player.simulation is not None)
    window.screenshot("stranger-4-simulation")
    window.wait(lambda: tab.player.view.surface_at(tab.player.view.rect().center()) is not None)
    window.press(tab, QtCore.Qt.Key_Escape)
    window.wait(lambda: not tabs(window))

    Gui.runCommand("Std_Undo")
    window.wait(lambda: not marks.is_marked(document.getObject("Job")))
    return 0


def step(window: Window, button: str, command: str) -> None:
    """Click a button of the toolbar. If the toolbar is too short for the button, run its command instead."""
    if any(is_button(found, button) and found.isVisible() for found in window.find(QtGui.QToolButton)):
        window.click(button)
    else:
        Gui.runCommand(command, 1)  # the argument 1 switches a checkable command on


def is_button(widget, text: str) -> bool:
    return widget.defaultAction() is not None and widget.defaultAction().text().replace("&", "") == text


def is_shown(window: Window, title: str) -> bool:
    docks = window.find(QtGui.QDockWidget)
    return any(dock.windowTitle().startswith(title) and dock.isVisible() for dock in docks)


run_and_leave(main)
