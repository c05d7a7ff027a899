# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the longest time for which an event waits in FreeCAD's window while the add-on processes 500,000 commands.

    benchmarks/in_window.sh pauses [0.20.2|1.0.0|1.1.3]

One document has five operations of 100,000 commands each, and another document has one operation of 500,000 commands.
For each document, the script prints how long FreeCAD itself blocks the window to return one path, its commands and its
text, and to open, recompute and draw the document. Then the script prints the longest time between two events during
each action of a user. Each time is the best of three rounds, because a pause caused by the add-on occurs in every
round. The computer must be idle.
"""

from __future__ import annotations

import itertools
import math
import sys
import tempfile
import time
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui
import Path as Cam
from PySide import QtCore

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "examples"), str(ROOT / "tests")]

import events
from inside_freecad import run_and_leave
from make_example import cam

from vkworkbench import freecad
from vkworkbench.document.computer import idle
from vkworkbench.document.job.results import RESULTS
from vkworkbench.document.marks import marks
from vkworkbench.gui.gauss import command as gauss_map_command
from vkworkbench.gui.qt import docks
from vkworkbench.gui.strategies import view as strategy_view

OUT = sys.__stdout__
COMMANDS = 500_000
ROUNDS = 3
PATIENCE = 120  # time limit of an action, s


class Stopwatch:
    """A clock for the time that an idle computer would take, s: the smaller of wall time and processor time.

    The processor time does not include other processes. The wall time counts parallel threads only once.
    """

    def __init__(self) -> None:
        self._wall, self._process = time.perf_counter(), time.process_time()

    def __call__(self) -> float:
        return min(time.perf_counter() - self._wall, time.process_time() - self._process)


class Events:
    """Measures the longest time between two events during an action."""

    def __init__(self) -> None:
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._beat)
        self.longest = 0.0

    def _beat(self) -> None:
        self.longest, self._last = max(self.longest, self._last()), Stopwatch()

    def during(self, do, is_over) -> float:
        """Start an action, wait until it is over, and return the longest time between two events, s."""
        rest()
        self.longest, self._last = 0.0, Stopwatch()
        self._timer.start(1)
        do()
        wait(is_over)
        rest()
        self._timer.stop()
        return self.longest


def main() -> int:
    print(f"FreeCAD {'.'.join(map(str, freecad.version()))}, {COMMANDS:,} commands", file=OUT)
    window = Gui.getMainWindow()
    window.setGeometry(0, 0, 1280, 1000)
    window.show()
    Gui.activateWorkbench("VkWorkbench")
    for operations in (5, 1):
        measure(operations)
    return 0


def measure(count: int) -> None:
    """Print the pauses of one document."""
    document, operations = made(count)
    path = operations[0].Path
    print(f"\n{count} operations of {path.Size:,} commands", file=OUT)
    freecads_own = {
        "a path": lambda: operations[0].Path,
        "its commands": lambda: path.Commands,
        "its text": path.toGCode,
        "another path": lambda: change(operations[0]),
        "a picture of the 3D view": Gui.updateGui,
    }
    for name, call in freecads_own.items():
        say(f"FreeCAD alone: {name}", min(alone(call) for _ in range(ROUNDS)))
    other = FreeCAD.newDocument("Other")
    FreeCAD.setActiveDocument(document.Name)

    def activate(which):
        FreeCAD.setActiveDocument(which.Name)

    def analyze():
        Gui.Selection.clearSelection()
        Gui.runCommand("Vk_Analyze")

    def strategies(checked):
        activate(document)
        Gui.runCommand("Vk_Strategies", checked)

    def is_marked():
        return is_idle() and all(map(marks.is_marked, operations))

    def select():
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(operations[0])

    # Each entry has three functions: the preparation, the measured action, and the condition for the end of the action.
    done = {
        "a changed path is recomputed, no marks": (
            lambda: change(operations[0]), document.recompute, lambda: True),
        "Analyze Toolpaths": (RESULTS.clear, analyze, is_marked),
        "Analyze Toolpaths, nothing changed": (lambda: None, analyze, is_marked),
        "a changed path is recomputed, marked": (
            lambda: change(operations[0]), document.recompute, lambda: is_idle() and marks.is_outdated(operations[0])),
        "switching to the marked document": (lambda: activate(other), lambda: activate(document), is_idle),
        "Show Strategies": (lambda: strategies(0), lambda: strategies(1), lambda: not strategy_view.is_drawing()),
        "a changed path, strategies shown": (
            lambda: change(operations[0]), document.recompute, lambda: is_idle() and not strategy_view.is_drawing()),
        "Gauss map": (hide_gauss_map, lambda: (gauss_map_command.show(), select()), gauss_map_is_there),
    }  # fmt: skip
    for name, (before, do, is_over) in done.items():
        pauses = []
        for _ in range(ROUNDS):
            before()
            pauses.append(EVENTS.during(do, is_over))
        say(name, min(pauses))
    strategies(0)
    saved = str(Path(tempfile.mkdtemp()) / "long.FCStd")
    document.saveAs(saved)
    FreeCAD.closeDocument(document.Name)
    rest()
    say("FreeCAD opens the file", EVENTS.during(lambda: FreeCAD.openDocument(saved), is_idle))
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)


def made(count: int):
    """Return a document with a job whose operations are rows over a wavy surface, all different."""
    document = FreeCAD.newDocument("Long")
    block = document.addObject("Part::Box", "Block")
    block.Length, block.Width, block.Height = 100, 100, 20
    document.recompute()
    job = cam("Main.Job").Create("Job", [block])
    operations = []
    for number in range(count):
        op = document.addObject("Path::FeaturePython", f"Rows{number + 1}")
        op.addProperty("App::PropertyLink", "ToolController", "Path").ToolController = job.Tools.Group[0]
        op.Path = rows(COMMANDS // count, number)
        operations.append(op)
    job.Operations.Group = operations
    document.recompute()
    return document, operations


def rows(commands: int, number: int):
    lines = ["G0 Z30", "G0 X0 Y0", "G1 Z18 F10"]
    for i in range(commands - 4):
        row, step = divmod(i, 500)
        x = 0.2 * (step if row % 2 == 0 else 499 - step)
        lines.append(f"G1 X{x:.3f} Y{90 * 500 * row / commands + 0.1 * math.sin(x):.4f}")
    return Cam.Path("\n".join([*lines, f"G1 X{10 + number}"]))


CHANGES = itertools.count(1)


def change(op) -> None:
    """Change the path of an operation by adding a command at the end."""
    path = op.Path
    path.addCommands(Cam.Command(f"G1 X{next(CHANGES) / 1000}"))
    op.Path = path


def alone(call) -> float:
    """Return how long a call of FreeCAD's own functions takes, s."""
    watch = Stopwatch()
    call()
    return watch()


EVENTS = Events()


def is_idle() -> bool:
    return not (idle._works or idle._calls)


def hide_gauss_map() -> None:
    Gui.Selection.clearSelection()
    dock = docks.find(docks.GAUSS_MAP)
    if dock is not None:
        dock._say_nothing()
        dock.hide()


def gauss_map_is_there() -> bool:
    dock = docks.find(docks.GAUSS_MAP)
    return dock is not None and dock.canvas.isVisible() and dock.canvas.figure is not None


def wait(condition) -> None:
    end = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > end:
            raise TimeoutError(f"not over after {PATIENCE} s")
        events.happen()


def rest(duration: float = 0.5) -> None:
    """Let FreeCAD process its pending events."""
    end = time.monotonic() + duration
    wait(lambda: time.monotonic() > end)


def say(what: str, seconds: float) -> None:
    print(f"{what:45} {1e3 * seconds:7.0f} ms", file=OUT, flush=True)


run_and_leave(main)
