# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panels of FreeCAD's simulators, and the operations chosen in them. This module does not import numpy."""

from __future__ import annotations

import FreeCAD

from vkworkbench import freecad
from vkworkbench.document.job.operations import is_active
from vkworkbench.gui.qt import widgets
from vkworkbench.gui.qt.names import QComboBox, QDialogButtonBox, QListWidget, QSlider, Qt, QToolButton, QWidget

_PARTS = {
    "comboJobs": QComboBox,
    "listOperations": QListWidget,
    "sliderAccuracy": QSlider,
    "toolButtonPlay": QToolButton,
}


def panels() -> list[QWidget]:
    """Return the open panels of FreeCAD's simulators whose widgets can be used. All have the same Qt name.

    FreeCAD 1.x keeps closed panels, and PySide can confuse widgets of the next panel with deleted widgets at the same
    address. If FreeCAD found a deleted widget in a panel, FreeCAD would report a failed command, so the result does not
    contain panels with deleted widgets.
    """
    return [
        panel
        for panel in widgets.find(QWidget, "TaskPathSimulator")
        if not panel.isWindow() and all(panel.findChild(kind, name) is not None for name, kind in _PARTS.items())
    ]


def simulator_of(panel: QWidget) -> str:
    """Return the name of a panel's simulator: only the panel of the legacy simulator has a fast-forward button."""
    return "OpenGL" if panel.findChild(QToolButton, "toolButtonFF") is None else "legacy"


def chosen_in(panel: QWidget) -> tuple[object, list]:
    """Return the job and the ticked operations in a simulator's panel.

    If the panel's list and the job have different numbers of operations, no operations are returned.
    """
    jobs = FreeCAD.ActiveDocument.findObjects("Path::FeaturePython", "Job.*")
    job = jobs[panel.findChild(QComboBox, "comboJobs").currentIndex()]
    operations = [obj for obj in freecad.OPERATIONS.of(job).OutList if is_active(obj)]
    listed = panel.findChild(QListWidget, "listOperations")
    if len(operations) != listed.count():
        return job, []
    return job, [obj for row, obj in enumerate(operations) if listed.item(row).checkState() == Qt.Checked]


def close() -> None:
    """Close a simulator's panel by its own button, which also removes the simulator's objects from the document."""
    docks = [dock for dock in widgets.docks() if dock.objectName() in freecad.TASK_DOCKS]
    for buttons in widgets.find(QDialogButtonBox):
        if any(dock.isAncestorOf(buttons) for dock in docks):
            (buttons.button(QDialogButtonBox.Cancel) or buttons.button(QDialogButtonBox.Close)).click()
            return
