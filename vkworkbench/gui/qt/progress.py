# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analyse and calibrate with a progress dialog. The window stays responsive, and Esc cancels."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial

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
    """Call ``vkworkbench.analyze`` and show its progress. Raise `Cancelled` if the user pressed Esc or Cancel."""
    note_renderer()
    title, text = translate("Vk_Analyze", "Analyze Toolpaths"), translate("Vk_Analyze", "Reading the operations…")
    with _dialog(title, text, Gui.getMainWindow()) as dialog:
        return vkworkbench.analyze(what, progress=partial(_show, dialog), cancelled=partial(_is_cancelled, dialog))


def calibrate(parent: QWidget) -> None:
    """Call ``calibration.calibrate`` and show its progress. Raise `Cancelled` if the user pressed Esc or Cancel."""
    from vkworkbench.document.computer import calibration  # imported here, because the module loads numpy

    text = translate("Vk_Analyze", "Measuring how fast this computer simulates…")
    with _dialog(translate("VkPreferences", "Calibrate"), text, parent) as dialog:
        note_renderer(again=True)
        calibration.calibrate(partial(_go_on, dialog))


@contextmanager
def simulating(title: str, text: str) -> Iterator[Callable[[float], None]]:
    """Show the progress of a simulation; yield the function that the simulation calls with its completed share.

    `Cancelled` is raised if the user pressed Esc or Cancel.
    """
    with _dialog(title, text, Gui.getMainWindow()) as dialog:
        dialog.setMaximum(100)

        def going_on(share: float) -> None:
            dialog.setValue(min(99, int(100 * share)))  # the value 100 would close the dialog too early
            _go_on(dialog)

        yield going_on


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


@contextmanager
def _dialog(title: str, text: str, parent: QWidget) -> Iterator[QProgressDialog]:
    """Show a progress dialog during the context."""
    dialog = dialog_of(title, text, parent, delay=_DELAY)
    dialog.setMinimumWidth(_WIDTH)
    dialog.setMaximum(0)  # the dialog shows that the duration is unknown
    dialog.setValue(0)
    try:
        yield dialog
    finally:
        dialog.close()
        dialog.deleteLater()


def _show(dialog: QProgressDialog, done: int, count: int, label: str) -> None:
    dialog.setMaximum(count)
    dialog.setLabelText(label)
    dialog.setValue(done)


def _is_cancelled(dialog: QProgressDialog) -> bool:
    # The dialog does not block FreeCAD's window before it is visible: until then, leave clicks unhandled.
    QApplication.processEvents(QEventLoop.AllEvents if dialog.isVisible() else QEventLoop.ExcludeUserInputEvents)
    return dialog.wasCanceled()


def _go_on(dialog: QProgressDialog) -> None:
    if _is_cancelled(dialog):
        raise Cancelled("given up")
