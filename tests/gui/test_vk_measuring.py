# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first analysis ever measures this computer: the window lives meanwhile, says so, and Esc ends it."""

import time

import FreeCAD
import pytest
from PySide import QtCore, QtGui

from vkworkbench import preferences
from vkworkbench.core import measure_speed
from vkworkbench.document.computer import calibration
from vkworkbench.document.job.operations import find
from vkworkbench.document.marks import marks


@pytest.fixture
def never_measured():
    """No calibration before the test, and the one of before after it."""
    path = calibration._path()
    before = path.read_bytes() if path.exists() else None
    path.unlink(missing_ok=True)
    yield path
    path.unlink(missing_ok=True)
    if before is not None:
        path.write_bytes(before)


def dialog():
    shown = [w for w in QtGui.QApplication.topLevelWidgets() if isinstance(w, QtGui.QProgressDialog) and w.isVisible()]
    return shown[0] if shown else None


def endless(clock=None, going_on=None):
    """A computer that cannot be measured."""
    end = time.monotonic() + 60
    while time.monotonic() < end:
        going_on()
        time.sleep(0.01)
    pytest.fail("nobody ended it")


def pressing_escape(window, labels, name=None):
    """Press Esc whenever a dialog is seen, and note what it says; the timer that does it."""

    def look():
        shown = dialog()
        if shown is not None:
            labels.append(shown.labelText())
            if name:
                window.screenshot(name)
            window.press(shown, QtCore.Qt.Key_Escape)

    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(100)
    return timer


def test_esc_ends_the_measurement_and_with_it_the_analysis(opened, window, never_measured, monkeypatch):
    monkeypatch.setattr(calibration, "measure_speed", endless)
    undo, labels = opened.UndoCount, []
    timer = pressing_escape(window, labels, "measuring")
    window.click("Analyze Toolpaths")
    timer.stop()
    assert set(labels) == {"Measuring how fast this computer simulates…"}
    assert "cancelled" in window.main.statusBar().currentMessage() and dialog() is None
    assert not never_measured.exists() and opened.UndoCount == undo
    assert not any(marks.is_marked(operation.object) for operation in find(opened))


def test_other_events_come_between_the_pieces(opened, window, never_measured, monkeypatch):
    beats, pieces = [0], []

    def watched(clock, going_on):
        def noted():
            going_on()
            pieces.append(beats[0])

        return measure_speed(clock, noted)

    def beat():
        beats[0] += 1

    monkeypatch.setattr(calibration, "measure_speed", watched)
    timer = QtCore.QTimer()
    timer.timeout.connect(beat)
    timer.start(0)
    window.analyze(opened)
    timer.stop()
    assert len(pieces) >= 18 and all(before < after for before, after in zip(pieces, pieces[1:]))
    assert calibration.load(preferences.read().renderer) is not None
    assert all(marks.is_marked(operation.object) for operation in find(opened))


def test_esc_ends_the_calibration_of_the_preferences(window, never_measured, monkeypatch):
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
