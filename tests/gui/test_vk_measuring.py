# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first analysis measures this computer: a dialog shows it, events are handled, and Esc ends the measurement."""

import time

import FreeCAD
import pytest
from PySide import QtCore

from vkworkbench import preferences
from vkworkbench.core import measure_speed
from vkworkbench.document.computer import calibration
from vkworkbench.document.job.operations import find
from vkworkbench.document.marks import marks


@pytest.fixture
def never_measured(restored_calibration):
    """No calibration before the test; the path of its file."""
    restored_calibration.unlink()
    return restored_calibration


def endless(clock=None, going_on=None):
    """Measure until Esc is pressed."""
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


def test_esc_ends_measurement_and_analysis(opened, window, never_measured, monkeypatch):
    monkeypatch.setattr(calibration, "measure_speed", endless)
    undo, labels = opened.UndoCount, []
    timer = pressing_escape(window, labels, "measuring")
    window.click("Analyze Toolpaths")
    timer.stop()
    assert set(labels) == {"Measuring how fast this computer simulates…"}
    assert "cancelled" in window.main.statusBar().currentMessage() and window.progress_dialog() is None
    assert not never_measured.exists() and opened.UndoCount == undo
    assert not any(marks.is_marked(operation.object) for operation in find(opened))


def test_measurement_handles_events_between_its_pieces(opened, window, never_measured, monkeypatch):
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
