# SPDX-License-Identifier: LGPL-2.1-or-later
"""An analysis with a progress dialog: the window stays alive, Esc cancels."""

from __future__ import annotations

import FreeCADGui as Gui

import vkworkbench
from vkworkbench.gui.plain_text import as_plain
from vkworkbench.gui.qt import QApplication, QEventLoop, QLabel, QProgressDialog, Qt
from vkworkbench.gui.renderer import note_renderer
from vkworkbench.gui.text import translate
from vkworkbench.report import Report

_DELAY = 300  # ms; a shorter analysis shows no dialog
_WIDTH = 400  # px; a width that changed with every label would make FreeCAD draw the 3D view behind it anew


def analyze(what) -> Report:
    """Do what ``vkworkbench.analyze`` does, and show how far it is.

    Raises
    ------
    Cancelled
        If the user pressed Esc or the button.
    """
    dialog = QProgressDialog(Gui.getMainWindow())
    dialog.setWindowTitle(translate("Vk_Analyze", "Analyze toolpaths"))
    dialog.setWindowModality(Qt.WindowModal)
    dialog.setMinimumDuration(_DELAY)
    dialog.setMinimumWidth(_WIDTH)
    as_plain(dialog.findChild(QLabel))
    dialog.rejected.connect(dialog.cancel)  # Esc, whichever part of the dialog takes it

    def progress(done: int, count: int, label: str) -> None:
        dialog.setMaximum(count)
        dialog.setLabelText(label)
        dialog.setValue(done)

    def cancelled() -> bool:
        # Clicks have to wait until the dialog is visible and keeps them from the window.
        waiting = QEventLoop.AllEvents if dialog.isVisible() else QEventLoop.ExcludeUserInputEvents
        QApplication.processEvents(waiting)
        return dialog.wasCanceled()

    note_renderer()
    try:
        return vkworkbench.analyze(what, progress=progress, cancelled=cancelled)
    finally:
        dialog.close()
        dialog.deleteLater()
