# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document of 500,000 commands: the window lives while it is analysed, and Esc ends that at once."""

import math
import time

import FreeCADGui as Gui
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


class Stopwatch:
    """Seconds as on a computer where nothing else runs.

    Less than the time on the wall, in which other processes work too, and than the time of this process, which counts
    its threads one by one although they work side by side.
    """

    def __init__(self):
        self._wall, self._process = time.monotonic(), time.process_time()

    def __call__(self):
        return min(time.monotonic() - self._wall, time.process_time() - self._process)


def drawing():
    """What FreeCAD takes for one picture of its 3D view, which nothing can end: without a graphics card 0.1 s."""
    watch = Stopwatch()
    Gui.activeView().redraw()
    QtGui.QApplication.processEvents()
    return watch()


def test_esc_ends_half_a_million_commands_at_once(long_document, window):
    before = [(obj.Name, obj.Label2, tuple(obj.PropertiesList), list(obj.State)) for obj in long_document.Objects]
    undo = long_document.UndoCount
    picture = min(drawing() for _ in range(3))
    taken, gaps, labels = [], [], set()
    for wait in (0.5, 1.1, 1.7, 2.6):  # s, in the middle of different steps
        pressed = []
        last = Stopwatch()

        def beat():
            nonlocal last
            gaps.append(last())
            last = Stopwatch()
            if pressed:
                return
            shown = dialog()
            if shown is not None:
                labels.add(shown.labelText())
                if time.monotonic() > start + wait:
                    pressed.append(Stopwatch())
                    window.press(shown, QtCore.Qt.Key_Escape)

        timer = QtCore.QTimer()
        timer.timeout.connect(beat)
        timer.start(10)
        start = time.monotonic()
        window.click("Analyze toolpaths")
        timer.stop()
        assert pressed, "the analysis was over before Esc"
        taken.append(pressed[0]())
        assert "cancelled" in window.main.statusBar().currentMessage()
    gaps.sort()
    print(f"cancelled after {[round(t, 3) for t in taken]} s; pauses of the window: median {gaps[len(gaps) // 2]:.3f}, "
          f"longest {gaps[-1]:.3f} s; one picture of the 3D view {picture:.3f} s")  # fmt: skip
    assert sorted(taken)[-2] < 0.2 and max(taken) < 0.2 + picture
    assert gaps[len(gaps) // 2] < 0.1 and gaps[-1] < 1
    assert labels and labels <= {obj.Label for obj in long_document.Objects}
    assert [(obj.Name, obj.Label2, tuple(obj.PropertiesList), list(obj.State)) for obj in long_document.Objects] == before
    assert long_document.UndoCount == undo
