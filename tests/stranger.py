# SPDX-License-Identifier: LGPL-2.1-or-later
"""A stranger's first steps, in the order of docs/guide.md, in a FreeCAD that was never started before.

test_vk_stranger.py starts it, with the document that is open as FreeCAD's first argument.
"""

from __future__ import annotations

import sys
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "gui"), str(HERE)]  # the window's conftest first

from conftest import Window
from inside_freecad import run_and_leave
from simulation_window import shown, tabs

import vkworkbench
from vkworkbench import freecad
from vkworkbench.document.marks import marks


def main() -> int:
    assert HERE.parent not in Path(vkworkbench.__file__).resolve().parents, "not the release"
    window = Window()
    window.main.show()
    window.idle(3.0)  # what FreeCAD asks or shows at its first start
    document = FreeCAD.ActiveDocument
    # In 0.20 the workbench first asks about units, in a box of its own loop.
    QtCore.QTimer.singleShot(2000, window.dismiss)
    Gui.activateWorkbench("PathWorkbench" if freecad.version() < (1, 0, 0) else "CAMWorkbench")
    window.idle(3.0)

    Gui.SendMsgToActiveView("ViewFit")
    step(window, "Analyze Toolpaths", "Vk_Analyze")
    window.wait(lambda: marks.is_marked(document.getObject("Job")), 60)
    window.idle(1.0)
    said = window.dismiss()
    assert all("Description" in text for text in said), said
    window.tree.expandAll()
    window.screenshot("stranger-1-marks")
    assert window.descriptions()["Face"].startswith("⟦zigzag")

    assert is_shown(window, "Toolpath Results")

    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(document.getObjectsByLabel("Face")[0])
    step(window, "Gauss Map", "Vk_GaussMap")
    window.wait(lambda: is_shown(window, "Gauss Map"))
    window.idle(2.0)
    window.screenshot("stranger-2-gauss-map")

    Gui.Selection.clearSelection()
    step(window, "Show Strategies", "Vk_Strategies")
    window.idle(2.0)
    window.screenshot("stranger-3-strategies")

    step(window, "Simulate Toolpaths", "Vk_Simulate")
    window.wait(lambda: tabs(window))
    (tab,) = tabs(window)
    player = shown(tab, window)
    window.screenshot("stranger-4-simulation")
    assert player.view.owner_at(player.view.rect().center()) is not None
    window.press(tab, QtCore.Qt.Key_Escape)
    window.wait(lambda: not tabs(window))

    Gui.runCommand("Std_Undo")
    window.wait(lambda: not marks.is_marked(document.getObject("Job")))
    return 0


def step(window: Window, button: str, command: str) -> None:
    """Click a button of the toolbar; where the toolbar has no room for it, take the command from the menu."""
    if any(is_button(found, button) and found.isVisible() for found in window.find(QtGui.QToolButton)):
        window.click(button)
    else:
        Gui.runCommand(command, 1)  # switches on


def is_button(widget, text: str) -> bool:
    return widget.defaultAction() is not None and widget.defaultAction().text().replace("&", "") == text


def is_shown(window: Window, title: str) -> bool:
    docks = window.find(QtGui.QDockWidget)
    return any(dock.windowTitle().startswith(title) and dock.isVisible() for dock in docks)


run_and_leave(main)
