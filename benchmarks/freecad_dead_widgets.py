# SPDX-License-Identifier: LGPL-2.1-or-later
"""Count the widgets that FreeCAD deletes without informing PySide.

    xvfb-run -a freecad $PWD/benchmarks/freecad_dead_widgets.py

The script opens and closes the preferences and the panel of the simulator. Then the script prints the number of deleted
widgets that PySide considers alive, and how often the simulator could not be opened. If Qt creates another object at
the address of a deleted widget, PySide confuses the object with the widget, and FreeCAD may crash. The script does not
import the add-on.
"""

import gc
import os
import sys
import tempfile
import time
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui
from PySide import QtCore, QtGui

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "examples"))
from make_example import make_example

shiboken = sys.modules.get("shiboken6") or sys.modules["shiboken2"]
OLD = FreeCAD.Version()[0] == "0"


def dead() -> int:
    """Return the number of widgets that PySide considers alive but that Qt has deleted."""
    alive = {shiboken.getCppPointer(widget)[0] for widget in QtGui.QApplication.allWidgets()}
    return sum(
        shiboken.isValid(thing) and shiboken.getCppPointer(thing)[0] not in alive
        for thing in gc.get_objects()
        if isinstance(thing, QtGui.QWidget)
    )


def preferences() -> bool:
    def close() -> None:
        dialog = QtGui.QApplication.activeModalWidget()
        if dialog is None:
            QtCore.QTimer.singleShot(50, close)
        else:
            dialog.reject()

    QtCore.QTimer.singleShot(50, close)
    Gui.runCommand("Std_DlgPreferences")
    return True


def simulator() -> bool:
    Gui.runCommand("Path_Simulator" if OLD else "CAM_Simulator")
    idle(0.5)
    opened = bool(Gui.Control.activeDialog())
    Gui.Control.closeDialog()
    idle(0.3)
    return opened


def idle(seconds: float) -> None:
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtGui.QApplication.processEvents()
        time.sleep(0.005)


def count() -> None:
    with tempfile.TemporaryDirectory() as folder:
        make_example(Path(folder) / "example.FCStd")
    Gui.activateWorkbench("PathWorkbench" if OLD else "CAMWorkbench")
    for name, open_and_close, times in (("the preferences", preferences, 5), ("the simulator's panel", simulator, 60)):
        before = dead()
        opened = sum(open_and_close() for _ in range(times))
        print(
            f"{name}: opened {opened} of {times} times and closed, {dead() - before} dead widgets",
            file=sys.__stdout__,
            flush=True,
        )
    os._exit(0)


QtCore.QTimer.singleShot(2000, count)
