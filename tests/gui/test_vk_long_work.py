# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document of 500,000 commands: the window lives while it is analysed, and Esc ends that at once."""

import math
import time

import Path
import pytest
from PySide import QtCore, QtGui

OPERATIONS, COMMANDS = 5, 100_000


@pytest.fixture
def long_document(opened):
    """The example, five of its operations with 100,000 short moves each."""
    lines = ["G0 Z30", "G0 X10 Y10", "G1 Z18 F10"]
    for number in range(COMMANDS - len(lines)):
        row, step = divmod(number, 500)
        x = 10 + 0.2 * (step if row % 2 == 0 else 499 - step)
        lines.append(f"G1 X{x:.3f} Y{10 + 0.3 * row + 0.1 * math.sin(x):.4f}")
    path = Path.Path("\n".join(lines))
    changed = [obj for obj in opened.getObject("Job").Operations.Group][:OPERATIONS]
    for obj in changed:
        obj.Path = path
    assert sum(obj.Path.Size for obj in changed) == 500_000
    return opened


def dialog():
    shown = [w for w in QtGui.QApplication.topLevelWidgets()
             if isinstance(w, QtGui.QProgressDialog) and w.isVisible()]
    return shown[0] if shown else None


def clock():
    """Seconds that this process worked, all threads together: what other processes take does not count."""
    return time.process_time()


def test_esc_ends_half_a_million_commands_at_once(long_document, window):
    before = [(obj.Name, obj.Label2, tuple(obj.PropertiesList), list(obj.State)) for obj in long_document.Objects]
    undo = long_document.UndoCount
    taken, gaps, labels = [], [], set()
    for wait in (0.5, 1.1, 1.7, 2.6):  # s, in the middle of different steps
        pressed = []
        last = clock()

        def beat():
            nonlocal last
            now = clock()
            gaps.append(now - last)
            last = now
            if pressed:
                return
            shown = dialog()
            if shown is not None:
                labels.add(shown.labelText())
                if time.monotonic() > start + wait:
                    pressed.append(now)
                    window.press(shown, QtCore.Qt.Key_Escape)

        timer = QtCore.QTimer()
        timer.timeout.connect(beat)
        timer.start(10)
        start = time.monotonic()
        window.click("Analyze toolpaths")
        timer.stop()
        assert pressed, "the analysis was over before Esc"
        taken.append(clock() - pressed[0])
        assert "cancelled" in window.main.statusBar().currentMessage()
    gaps.sort()
    print(f"cancelled after {[round(t, 3) for t in taken]} s; pauses of the window: median {gaps[len(gaps) // 2]:.3f}, "
          f"longest {gaps[-1]:.3f} s")  # fmt: skip
    assert max(taken) < 0.2
    assert gaps[len(gaps) // 2] < 0.1 and gaps[-1] < 1
    assert labels and labels <= {obj.Label for obj in long_document.Objects}
    assert [(obj.Name, obj.Label2, tuple(obj.PropertiesList), list(obj.State)) for obj in long_document.Objects] == before
    assert long_document.UndoCount == undo
