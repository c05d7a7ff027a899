# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document of 150,000 commands: the window handles events during its analysis, and Esc ends it at once."""

import math
import time

import Path
import pytest
from PySide import QtCore

from vkworkbench.document.job.results import RESULTS

OPERATIONS, COMMANDS = 5, 30_000


@pytest.fixture
def long_document(opened):
    """The example, five of its operations with 30,000 short moves each."""
    lines = ["G0 Z30", "G0 X10 Y10", "G1 Z18 F10"]
    for number in range(COMMANDS - len(lines)):
        row, step = divmod(number, 500)
        x = 10 + 0.2 * (step if row % 2 == 0 else 499 - step)
        lines.append(f"G1 X{x:.3f} Y{10 + 0.3 * row + 0.1 * math.sin(x):.4f}")
    changed = opened.getObject("Job").Operations.Group[:OPERATIONS]
    for number, obj in enumerate(changed):  # the paths differ, because the analysis reuses results of equal paths
        obj.Path = Path.Path("\n".join([*lines[:-1], f"G1 X{10 + number}"]))
    assert sum(obj.Path.Size for obj in changed) == OPERATIONS * COMMANDS
    return opened


class Stopwatch:
    """
    A stopwatch that other processes and threads affect little.

    The time is the smaller of wall time, which other processes lengthen, and processor time, which parallel threads
    lengthen.
    """

    def __init__(self):
        self._wall, self._process = time.monotonic(), time.process_time()

    def __call__(self):
        return min(time.monotonic() - self._wall, time.process_time() - self._process)


def cancel(window, order, number, beats):
    """
    Analyse the job, and press Esc after `beats` timer events within operation `number`.

    Return the seconds from Esc to the end, the seconds between timer events, the labels in the dialog, and whether
    another operation began after Esc.
    """
    due, pressed, gaps, labels, at_esc = [], [], [], set(), []
    last = Stopwatch()

    def beat():
        nonlocal last
        gaps.append(last())
        last = Stopwatch()
        shown = window.progress_dialog()
        if shown is None or shown.labelText() not in order:
            return  # the analysis of the first operation has not begun yet
        if pressed:
            at_esc.append(shown.labelText())
            return
        label = shown.labelText()
        labels.add(label)
        if order.index(label) >= number:
            due.append(label)
        if len(due) > beats:
            pressed.append(Stopwatch())
            at_esc.append(label)
            window.press(shown, QtCore.Qt.Key_Escape)

    timer = QtCore.QTimer()
    timer.timeout.connect(beat)
    timer.start(10)
    RESULTS.clear()
    window.click("Analyze Toolpaths")
    timer.stop()
    assert pressed, "the analysis was over before Esc"
    assert "cancelled" in window.main.statusBar().currentMessage()
    return pressed[0](), gaps, labels, len(set(at_esc)) > 1


@pytest.mark.long
def test_esc_ends_the_analysis_of_150_000_commands(long_document, window):
    before = [(obj.Name, obj.Label2, tuple(obj.PropertiesList), list(obj.State)) for obj in long_document.Objects]
    undo = long_document.UndoCount
    order = [obj.Label for obj in long_document.getObject("Job").Operations.Group]
    # Esc comes in the middle of different steps of an operation.
    tries = [cancel(window, order, *press) for press in ((1, 1), (2, 3), (3, 5), (2, 8))]
    pauses = sorted(gap for _, gaps, *_ in tries for gap in gaps)
    print(f"cancelled after {[round(seconds, 3) for seconds, *_ in tries]} s; pauses of the window: "
          f"median {pauses[len(pauses) // 2]:.3f}, longest {pauses[-1]:.3f} s")  # fmt: skip
    # Seconds depend on the computer, so the test only requires timer events within operations, and no operation after
    # Esc.
    assert not any(more for *_, more in tries)
    assert all(len(gaps) > 2 * len(shown) for _, gaps, shown, _ in tries)
    labels = set().union(*(shown for _, _, shown, _ in tries))
    assert labels and labels <= set(order)
    assert [
        (obj.Name, obj.Label2, tuple(obj.PropertiesList), list(obj.State)) for obj in long_document.Objects
    ] == before
    assert long_document.UndoCount == undo
