# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analyse and calibrate with a progress dialog. The window stays responsive, and Esc cancels."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

import FreeCADGui as Gui

import vkworkbench
from vkworkbench.gui.qt.names import QApplication, QEventLoop, QLabel, QProgressDialog, Qt, QWidget
from vkworkbench.gui.qt.plain_text import as_plain
from vkworkbench.gui.qt.renderer import note_renderer
from vkworkbench.gui.qt.text import translate
from vkworkbench.report import Cancelled, Report

_DELAY = 300  # ms; a shorter analysis does not show a dialog
_WIDTH = 400  # px; if the width changed with every label, FreeCAD would redraw the 3D view behind the dialog


def analyze(what) -> Report:
    """Call ``vkworkbench.analyze`` and show its progress.

    Raises
    ------
    Cancelled
        If the user pressed Esc or Cancel.
    """
    note_renderer()
    title, text = translate("Vk_Analyze", "Analyze Toolpaths"), translate("Vk_Analyze", "Reading the operations…")
    progress = _Progress(title, text, Gui.getMainWindow())
    try:
        return vkworkbench.analyze(what, progress=progress.show, cancelled=progress.cancelled)
    finally:
        progress.close()


def calibrate(parent: QWidget) -> None:
    """Call ``calibration.calibrate`` and show its progress.

    Raises
    ------
    Cancelled
        If the user pressed Esc or Cancel.
    OSError
        If the user data folder cannot be written.
    """
    from vkworkbench.document.computer import calibration  # imported here, because the module loads numpy

    text = translate("Vk_Analyze", "Measuring how fast this computer simulates…")
    progress = _Progress(translate("VkPreferences", "Calibrate"), text, parent)
    try:
        note_renderer(again=True)
        calibration.calibrate(progress.going_on)
    finally:
        progress.close()


@contextmanager
def simulating(title: str, text: str) -> Iterator[Callable[[float], None]]:
    """Show the progress of a simulation; yield the function that the simulation calls with its completed share.

    Raises
    ------
    Cancelled
        If the user pressed Esc or Cancel.
    """
    dialog = dialog_of(title, text, Gui.getMainWindow(), delay=_DELAY)
    dialog.setMaximum(100)

    def going_on(share: float) -> None:
        dialog.setValue(min(99, int(100 * share)))  # the value 100 would close the dialog too early
        QApplication.processEvents(QEventLoop.AllEvents if dialog.isVisible() else QEventLoop.ExcludeUserInputEvents)
        if dialog.wasCanceled():
            raise Cancelled("the simulation was cancelled; nothing has been changed")

    try:
        yield going_on
    finally:
        dialog.close()
        dialog.deleteLater()


def dialog_of(title: str, text: str, parent: QWidget, delay: int) -> QProgressDialog:
    """Return a modal progress dialog that appears after `delay` ms. The key Esc cancels the dialog."""
    dialog = QProgressDialog(parent)
    dialog.setWindowTitle(title)
    dialog.setWindowModality(Qt.WindowModal)
    dialog.setMinimumDuration(delay)
    as_plain(dialog.findChild(QLabel))
    dialog.setLabelText(text)
    dialog.setCancelButtonText(translate("Vk_Analyze", "Cancel"))
    dialog.rejected.connect(dialog.cancel)  # makes the Esc key cancel the dialog, whichever widget has the focus
    return dialog


class _Progress:
    """A dialog that shows a text, and later the label of the operation that is being analysed."""

    def __init__(self, title: str, text: str, parent: QWidget) -> None:
        self._dialog = dialog_of(title, text, parent, delay=_DELAY)
        self._dialog.setMinimumWidth(_WIDTH)
        self._dialog.setMaximum(0)  # the dialog shows that the duration is unknown
        self._dialog.setValue(0)

    def close(self) -> None:
        self._dialog.close()
        self._dialog.deleteLater()

    def show(self, done: int, count: int, label: str) -> None:
        self._dialog.setMaximum(count)
        self._dialog.setLabelText(label)
        self._dialog.setValue(done)

    def cancelled(self) -> bool:
        # The dialog does not block FreeCAD's window before it is visible: until then, leave clicks unhandled.
        waiting = QEventLoop.AllEvents if self._dialog.isVisible() else QEventLoop.ExcludeUserInputEvents
        QApplication.processEvents(waiting)
        return self._dialog.wasCanceled()

    def going_on(self) -> None:
        if self.cancelled():
            raise Cancelled("given up")
