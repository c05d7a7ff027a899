# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure this computer's speed in a pause after the first analysis, and update the times of marks in the tree."""

from __future__ import annotations

from contextlib import suppress

import FreeCAD
import FreeCADGui as Gui

import vkworkbench
from vkworkbench.document.computer import calibration
from vkworkbench.document.job.operations import find, is_there
from vkworkbench.document.marks import marking, marks
from vkworkbench.gui.qt.names import QApplication, QCursor, QTimer
from vkworkbench.report import Cancelled

_PAUSE = 1500  # time without a motion of the mouse pointer that counts as a pause, ms


class _Measurement:
    """Waits until the user pauses, then measures. Qt handles events several times a second during the measurement."""

    def __init__(self) -> None:
        self._pointer = None
        self._measures = False
        self._pauses = QTimer(Gui.getMainWindow())
        self._pauses.setInterval(_PAUSE)
        self._pauses.timeout.connect(self._look)

    def begin(self) -> None:
        self._pauses.start()

    def _look(self) -> None:
        """Measure if the mouse pointer has not moved since the last call, and no dialog or menu is open."""
        before, self._pointer = self._pointer, QCursor.pos()
        busy = self._measures or QApplication.activeModalWidget() or QApplication.activePopupWidget()
        if busy or before != self._pointer:
            return
        self._measures = True
        try:
            with suppress(OSError):  # if the file cannot be written, estimates use the default speed of a computer
                calibration.calibrate(self._going_on)
                for document in FreeCAD.listDocuments().values():
                    with suppress(ReferenceError):  # the document was closed during the measurement
                        self._refresh(document)
            self._pauses.stop()
        except Cancelled:  # the next pause starts a new measurement
            pass
        finally:
            self._measures = False

    def _refresh(self, document) -> None:
        """Analyse the operations with valid marks in the tree again, and update the marks without an undo step."""
        valid = [o.object for o in find(document) if marks.is_marked(o.object) and not marks.is_outdated(o.object)]
        for obj in valid:
            vkworkbench.analyze(obj, cancelled=self._is_ended)  # the results are cached, so the analysis below is fast
        present = [obj for obj in valid if is_there(obj) and not marks.is_outdated(obj)]
        if present:
            marking.mark(vkworkbench.analyze(present), undo_step=False)

    def _going_on(self) -> None:
        if self._is_ended() or QCursor.pos() != self._pointer:
            raise Cancelled("the user goes on")

    @staticmethod
    def _is_ended() -> bool:
        QApplication.processEvents()
        return not Gui.getMainWindow().isVisible()


_measurement: _Measurement | None = None


def measure_once() -> None:
    """Measure the speed of this computer at the user's next pause, if it was never measured; once in a session."""
    global _measurement
    if _measurement is None and calibration.load() is None:
        _measurement = _Measurement()
        _measurement.begin()
