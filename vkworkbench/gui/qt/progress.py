# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analyses and calibrations with a progress dialog: the window stays alive, Esc cancels."""

from __future__ import annotations

import FreeCADGui as Gui

import vkworkbench
from vkworkbench.gui.qt.names import QApplication, QEventLoop, QLabel, QProgressDialog, Qt, QWidget
from vkworkbench.gui.qt.plain_text import as_plain
from vkworkbench.gui.qt.renderer import note_renderer
from vkworkbench.gui.qt.text import translate
from vkworkbench.report import Cancelled, Report

_DELAY = 300  # ms; a shorter analysis shows no dialog
_WIDTH = 400  # px; a width that changed with every label would make FreeCAD draw the 3D view behind it anew


def analyze(what) -> Report:
    """Do what ``vkworkbench.analyze`` does, and show how far it is.

    Raises
    ------
    Cancelled
        If the user pressed Esc or the button.
    """
    note_renderer()
    progress = _Progress(translate("Vk_Analyze", "Analyze toolpaths"), Gui.getMainWindow())
    try:
        return vkworkbench.analyze(what, progress=progress.show, cancelled=progress.cancelled)
    finally:
        progress.close()


def calibrate(parent: QWidget) -> None:
    """Measure this computer as ``calibration.calibrate`` does.

    Raises
    ------
    Cancelled
        If the user pressed Esc or the button.
    OSError
        If the user data folder cannot be written.
    """
    from vkworkbench.document.computer import calibration  # loads FreeCAD's simulators

    progress = _Progress(translate("VkPreferences", "Calibrate"), parent)
    try:
        calibration.calibrate(note_renderer(again=True), going_on=progress.going_on)
    finally:
        progress.close()


def dialog_of(title: str, text: str, parent: QWidget, delay: int) -> QProgressDialog:
    """Return a dialog that keeps clicks from the window, is shown after so many ms, and that Esc cancels."""
    dialog = QProgressDialog(parent)
    dialog.setWindowTitle(title)
    dialog.setWindowModality(Qt.WindowModal)
    dialog.setMinimumDuration(delay)
    as_plain(dialog.findChild(QLabel))
    dialog.setLabelText(text)
    dialog.setCancelButtonText(translate("Vk_Analyze", "Cancel"))
    dialog.rejected.connect(dialog.cancel)  # whichever part of the dialog takes Esc
    return dialog


class _Progress:
    """A dialog that says that this computer is being measured, which comes first, then what is analysed."""

    def __init__(self, title: str, parent: QWidget) -> None:
        text = translate("Vk_Analyze", "Measuring how fast this computer simulates…")
        self._dialog = dialog_of(title, text, parent, delay=_DELAY)
        self._dialog.setMinimumWidth(_WIDTH)
        self._dialog.setMaximum(0)  # how long that takes is not known
        self._dialog.setValue(0)

    def close(self) -> None:
        self._dialog.close()
        self._dialog.deleteLater()

    def show(self, done: int, count: int, label: str) -> None:
        self._dialog.setMaximum(count)
        self._dialog.setLabelText(label)
        self._dialog.setValue(done)

    def cancelled(self) -> bool:
        # Clicks have to wait until the dialog is visible and keeps them from the window.
        waiting = QEventLoop.AllEvents if self._dialog.isVisible() else QEventLoop.ExcludeUserInputEvents
        QApplication.processEvents(waiting)
        return self._dialog.wasCanceled()

    def going_on(self) -> None:
        if self.cancelled():
            raise Cancelled("given up")
