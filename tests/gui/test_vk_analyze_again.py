# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preference to analyse after each recompute: the analysis waits until FreeCAD is idle, and Esc cancels it."""

import time

import Path
import pytest
from PySide import QtCore, QtGui

from vkworkbench import preferences
from vkworkbench.document.computer import idle
from vkworkbench.document.marks import marks
from vkworkbench.report import Cancelled


@pytest.fixture
def again(marked):
    """The marked example, with analysis after each recompute switched on during the test."""
    before = preferences.read().analyze_after_recompute
    preferences.write(analyze_after_recompute=True)
    yield marked
    preferences.write(analyze_after_recompute=before)


def is_idle():
    return not (idle._works or idle._calls)


def imported(document):
    """Return an operation without a proxy, as an imported program, so that a recompute keeps its path."""
    op = document.addObject("Path::Feature", "Given")
    op.Path = Path.Path("G0 X0 Y0 Z30\nG1 Z15 F100\nG1 X50\nG1 Y3\nG1 X0")
    document.recompute()
    return op


def change(op, commands):
    lines = [f"G1 X{20 + number % 50} Y{number * 0.001:.3f}" for number in range(commands)]
    op.Path = Path.Path("\n".join(["G0 X0 Y0 Z30", "G1 Z15 F100", *lines]))


@pytest.mark.parametrize("commands", [20, pytest.param(80_000, marks=pytest.mark.long)])
def test_mark_outdated_by_a_recompute_is_analysed_again(again, window, commands):
    import vkworkbench

    op = imported(again)
    vkworkbench.mark(vkworkbench.analyze(op))
    steps, before = list(again.UndoNames), marks.read(op).trajectories
    change(op, commands)
    again.recompute()
    window.wait(lambda: is_idle() and marks.read(op).trajectories != before)
    assert marks.read(op).trajectories == commands + 1 and not marks.is_outdated(op)
    assert list(again.UndoNames) == steps


def test_esc_leaves_the_mark_outdated(again, window, monkeypatch):
    import vkworkbench

    op = imported(again)
    vkworkbench.mark(vkworkbench.analyze(op))
    analyzed = []

    def endless(what, *, progress, cancelled):
        analyzed.append([obj.Name for obj in what])
        progress(0, 1, "Given")
        end = time.monotonic() + 60
        while time.monotonic() < end:
            if cancelled():
                raise Cancelled("given up")
            time.sleep(0.01)

    def press():
        for dialog in window.find(QtGui.QProgressDialog):
            if dialog.isVisible():
                window.press(dialog, QtCore.Qt.Key_Escape)

    monkeypatch.setattr(vkworkbench, "analyze", endless)
    timer = QtCore.QTimer()
    timer.timeout.connect(press)
    timer.start(100)
    change(op, 10)
    again.recompute()
    assert not analyzed  # no analysis starts during the recompute
    window.wait(lambda: analyzed and is_idle())
    timer.stop()
    assert analyzed == [["Given"]] and marks.is_outdated(op)
