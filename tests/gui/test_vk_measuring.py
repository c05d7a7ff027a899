# SPDX-License-Identifier: LGPL-2.1-or-later
"""The computer is measured when the user pauses after the first analysis, or by *Calibrate*, which Esc ends."""

import time
from itertools import count

import FreeCAD
import pytest
from PySide import QtCore, QtGui

from vkworkbench import preferences
from vkworkbench.core import measure_speed
from vkworkbench.core.zbuffer import Speed
from vkworkbench.document.computer import calibration
from vkworkbench.document.job.operations import find
from vkworkbench.document.marks import marks
from vkworkbench.gui import measuring


@pytest.fixture
def never_measured(restored_calibration):
    """Delete the calibration file before the test; return its path."""
    restored_calibration.unlink()
    return restored_calibration


def endless(going_on):
    """Replace the measurement by a loop that only Esc ends."""
    end = time.monotonic() + 60
    while time.monotonic() < end:
        going_on()
        time.sleep(0.01)
    pytest.fail("Esc did not end the measurement")


def pressing_escape(window, labels, name=None):
    """Return a timer that presses Esc in each progress dialog and adds the dialog's text to `labels`."""

    def look():
        shown = window.progress_dialog()
        if shown is not None:
            labels.append(shown.labelText())
            if name:
                window.screenshot(name)
            window.press(shown, QtCore.Qt.Key_Escape)

    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(100)
    return timer


@pytest.fixture
def first_session(never_measured, monkeypatch):
    """A session that has not measured the computer yet, and measures after a pause of 50 ms."""
    monkeypatch.setattr(measuring, "_measurement", None)
    monkeypatch.setattr(measuring, "_PAUSE", 50)
    yield
    measuring._measurement._pauses.stop()


@pytest.mark.usefixtures("default_preferences")
def test_marks_are_updated_after_the_measurement(opened, window, first_session, monkeypatch):
    monkeypatch.setattr(calibration, "measure_speed", lambda going_on: Speed(factor=2.0, record=1e-6, cell=1e-4))
    preferences.write(mark_simulator="z-buffer")
    monkeypatch.setattr(measuring, "_PAUSE", 10**6)
    window.analyze(opened)
    before, steps = marks.read(opened.Job), opened.UndoCount
    assert calibration.load() is None and "about" in before.text
    measuring._measurement._pauses.setInterval(10)
    window.wait(lambda: marks.read(opened.Job).costs != before.costs)
    assert marks.read(opened.Job).cost("z-buffer")[0] > 5 * before.cost("z-buffer")[0]
    assert calibration.load() is not None and opened.UndoCount == steps
    opened.undo()
    assert not any(marks.is_marked(operation.object) for operation in find(opened))
    opened.redo()
    assert marks.read(opened.Job).cost("z-buffer")[0] > 5 * before.cost("z-buffer")[0]


@pytest.mark.long
def test_measurement_restarts_after_a_move_of_the_pointer(opened, window, first_session, monkeypatch):
    beats, pieces, tries = [0], [], []

    def watched(going_on):
        def noted():
            going_on()
            pieces.append(beats[0])
            if len(tries) == 1:
                QtGui.QCursor.setPos(QtGui.QCursor.pos() - QtCore.QPoint(5, 5))

        tries.append(going_on)
        ticks = count(step=0.25)  # equal times of all repetitions end the measurement after the fewest repetitions
        return measure_speed(clock=lambda: next(ticks), going_on=noted)

    def beat():
        beats[0] += 1

    monkeypatch.setattr(calibration, "measure_speed", watched)
    timer = QtCore.QTimer()
    timer.timeout.connect(beat)
    timer.start(0)
    window.analyze(opened)
    window.wait(lambda: calibration.load() is not None)
    timer.stop()
    assert len(tries) == 2 and len(pieces) >= 18 and all(before < after for before, after in zip(pieces, pieces[1:]))
    window.wait(lambda: not measuring._measurement._measures)


def test_esc_ends_the_calibration_in_the_preferences(window, never_measured, monkeypatch):
    from vkworkbench.gui.preferences_page import PreferencesPage

    monkeypatch.setattr(calibration, "measure_speed", endless)
    page, labels = PreferencesPage(), []
    page.loadSettings()
    page.form.show()
    before = page.form.calibrated.text()
    timer = pressing_escape(window, labels)
    window.click_on(page.form.calibrate)
    timer.stop()
    page.form.hide()
    assert labels and page.form.calibrated.text() == before and not never_measured.exists()
    assert not window.boxes() and FreeCAD.ActiveDocument is None
