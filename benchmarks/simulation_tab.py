# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare the tab of *Simulate Toolpaths* with FreeCAD's own simulators, on the same jobs, in real windows.

    benchmarks/in_window.sh simulation_tab [0.20.2|1.0.0|1.1.3]

The shell script gives FreeCAD a separate home folder, without the user's settings. The jobs are the example job, and
two jobs of 100,000 trajectories, one divided into 20 operations, the other with a single operation. For each simulator,
a row of the table shows:

* the time from the click to the first picture and to the finest picture, with the processor times in parentheses
* the pictures per second while the time line is dragged
* the longest time for which an event waited, and in parentheses the processor time of FreeCAD during this wait; on a
  busy computer, the rest of the time was spent in other processes
* the additional memory

The lines below the row show how long FreeCAD itself blocks the window for the longest path, the expected cost of the
finest picture, the time until the job is checked, the verdict, and the pictures per second while the part is turned.
FreeCAD's simulators show the finished part only at the end of their fast-forward, or of a play at their highest speed.
The slider of the OpenGL simulator is dragged before the play, and the line above its row shows how long one move of the
mouse blocked the window. `VKWORKBENCH_PATIENCE` is the time limit for each simulator, s.
"""

from __future__ import annotations

import importlib
import os
import statistics
import sys
import tempfile
import time
import traceback
from dataclasses import replace
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui
import Path as Cam
from PySide import QtCore, QtGui

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "examples"), str(ROOT / "tests")]

from inside_freecad import run_and_leave
from make_example import make_example
from opengl_window import DRAG, FASTER, MOVE, PLAY, PRESS, RELEASE, THUMB, click, send

from vkworkbench import freecad
from vkworkbench.core.rendering import turned
from vkworkbench.document.simulation.copy import read_job
from vkworkbench.gui.simulation.command import open_tab

OUT = sys.__stdout__
PATIENCE = float(os.environ.get("VKWORKBENCH_PATIENCE", "600"))
DRAGGED, MOUSE = 4.0, 0.008  # duration of dragging, and time between two moves of the mouse, s
_SLID = 150  # distance by which the slider of the OpenGL simulator is dragged, pixels
ROW = "{:30}{:>18}{:>18}{:>12}{:>15}{:>10}"


def main() -> int:
    window = Gui.getMainWindow()
    window.setGeometry(0, 0, 1280, 1000)
    window.show()
    folder = Path(tempfile.mkdtemp())
    for name, make, simulators in JOBS:
        document = make(folder)
        job = read_job(document)
        moves = sum(len(cut.toolpath) for cut in job.cuts)
        title = f"\nFreeCAD {'.'.join(map(str, freecad.version()))}, {name}: {len(job.cuts)} operations, {moves:,} trajectories"
        print(title, file=OUT)
        print(ROW.format("", "first picture", "finest, end", "pictures/s", "waited", "memory"), file=OUT, flush=True)
        for simulator in simulators:
            try:
                print(ROW.format(*simulator(document)), file=OUT, flush=True)
            except Exception:  # if a simulator is missing or fails, the other simulators still run
                last = traceback.format_exc().strip().splitlines()[-1]
                print(f"{simulator.__doc__.splitlines()[0]:34} {last}", file=OUT, flush=True)
        FreeCAD.closeDocument(document.Name)
    return 0


def example(folder: Path):
    make_example(folder / "example.FCStd")
    return FreeCAD.ActiveDocument


def long(folder: Path):
    """Make the example's job with one large pocket, whose whole path FreeCAD returns in one call."""
    return made(folder, 1, 1, 0.036)


def made(folder: Path, across: int = 5, along: int = 4, layer: float = 0.1):
    """Make the example's job with 100,000 moves in pockets of many depths, alternately zigzag and contour-parallel."""
    document = example(folder)
    job = next(obj for obj in document.Objects if freecad.OPERATIONS.is_in(obj) and freecad.TOOLS.is_in(obj))
    controller = job.Tools.Group[1]
    for name in [obj.Name for obj in document.Objects if operates(obj)]:
        document.removeObject(name)  # FreeCAD also removes the base operations of dress-ups
    low, high = job.Stock.Shape.BoundBox, job.Stock.Shape.BoundBox.ZMax
    width, depth, moves = low.XLength / across, low.YLength / along, 100_000 // (across * along)
    operations = []
    for number in range(across * along):
        op = document.addObject("Path::FeaturePython", f"Pocket{number + 1}")
        op.addProperty("App::PropertyLink", "ToolController", "Path").ToolController = controller
        op.addProperty("App::PropertyBool", "Active", "Path").Active = True
        corner = low.XMin + width * (number % across), low.YMin + depth * (number // across)
        op.Path = Cam.Path(
            [Cam.Command(*command) for command in pocket(number, corner, width, depth, high, layer, moves)]
        )
        operations.append(op)
    job.Operations.Group = operations
    return document


def operates(obj) -> bool:
    return freecad.PATH.is_in(obj) and (freecad.CONTROLLER.is_in(obj) or freecad.BASE.is_in(obj))


def pocket(number: int, corner, width: float, depth: float, top: float, layer: float, moves: int):
    """Return the commands of one pocket with the given number of moves, in rows or rings with a stepover of 1 mm."""
    left, right, front, back = corner[0] + 5, corner[0] + width - 5, corner[1] + 5, corner[1] + depth - 5
    commands = [("G0", {"X": left, "Y": front, "Z": top + 5}), ("G1", {"Z": top, "F": 5.0})]
    z = top
    while len(commands) < moves:
        z -= layer
        commands.append(("G1", {"Z": z, "F": 5.0}))
        if number % 2:
            for ring in range(int(min(right - left, back - front) / 2)):
                x, y = (left + ring, right - ring), (front + ring, back - ring)
                commands += [
                    ("G1", {"X": x[i], "Y": y[j], "F": 20.0}) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1), (0, 0))
                ]
        else:
            for row in range(int(back - front)):
                ends = (left, right) if row % 2 == 0 else (right, left)
                commands += [("G1", {"X": x, "Y": front + row, "F": 20.0}) for x in ends]
    return [*commands[: moves - 1], ("G0", {"Z": top + 5})]


class Watch:
    """Measures wall time and processor time since its creation, s."""

    def __init__(self) -> None:
        self._begin = time.perf_counter(), time.process_time()

    def __call__(self) -> tuple[float, float]:
        return time.perf_counter() - self._begin[0], time.process_time() - self._begin[1]


def happen() -> None:
    """Wait for FreeCAD's next events and process them, as FreeCAD's event loop does."""
    QtGui.QApplication.processEvents(QtCore.QEventLoop.WaitForMoreEvents)


class Waiting:
    """Lets FreeCAD process events, and measures the longest time in which no event was processed."""

    def __init__(self) -> None:
        self.longest = self.worked = 0.0
        self._beaten = Watch()
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._beat)
        self._timer.start(5)

    def _beat(self) -> None:
        waited, processor = self._beaten()
        self.longest, self.worked = max(self.longest, waited), max(self.worked, min(waited, processor))
        self._beaten = Watch()

    def end(self) -> str:
        """Stop the measurement.

        Return as text the longest wait for an event, and the longest processor time of FreeCAD during a wait.
        """
        self._timer.stop()
        return f"{1e3 * self.longest:.0f} ms ({1e3 * self.worked:.0f})"

    def until(self, condition) -> bool:
        end = time.perf_counter() + PATIENCE
        while not condition():
            if time.perf_counter() > end:
                return False
            happen()
        return True


def tab(document):
    """Simulate Toolpaths."""
    alone = held(document)
    waiting, memory, watch = Waiting(), resident(), Watch()
    opened = open_tab(document)
    waiting.until(lambda: opened.reading.seen is not None or seen(opened))
    first = watch()
    waiting.until(lambda: opened.player is not None)
    player = opened.player
    done = waiting.until(lambda: seen(opened) and player.drawing.simulated.is_finest and player.pictures.is_current)
    finest = watch()
    waiting.until(lambda: not player.is_busy)
    checked, longest, memory = watch(), waiting.end(), resident() - memory
    drawn, processor = drag(player), turn(player)
    print(f"    FreeCAD alone hands out the longest path, {alone}", file=OUT)
    expected = player._simulating.expected
    print(f"    expected: {expected.seconds:.1f} s, {expected.memory_bytes / 1e6:.0f} MB", file=OUT)
    print(
        f"    checked: {said(checked)}  {player.state.text()}  ({player.drawing.simulation.zbuffer.frame.pixel:.2g} mm)",
        file=OUT,
    )
    print(f"    turning: {processor}", file=OUT)
    opened.window_of().close()
    return (
        tab.__doc__[:-1],
        said(first),
        said(finest, done),
        f"{drawn:.0f}",
        longest,
        f"{memory / 1e6:.0f} MB",
    )


def held(document) -> str:
    """Return as text how long FreeCAD blocks the window to return the longest path."""
    longest = max((obj for obj in document.Objects if operates(obj)), key=lambda obj: obj.Path.Size)
    watch = Watch()
    path = longest.Path
    copied = watch()[0]
    commands = path.Commands
    return (
        f"{len(commands):,} commands: a copy {1e3 * copied:.0f} ms, its commands {1e3 * (watch()[0] - copied):.0f} ms"
    )


def seen(opened) -> bool:
    """Return whether a picture of the whole job is visible."""
    return opened.player is not None and opened.player.simulation is not None


def turn(player) -> str:
    """Turn the part for some seconds. Return as text the pictures per second and the processor time of one picture."""
    view = player.view
    shown, show = [], view.show_scene
    view.show_scene = lambda *scene: (shown.append(1), show(*scene))
    begin = time.perf_counter()
    while (spent := time.perf_counter() - begin) < DRAGGED:
        view._direction = turned((-1, 1, -1), 6 * spent / DRAGGED, 0.3 * spent / DRAGGED)
        view.changed.emit()
        QtGui.QApplication.processEvents()
        time.sleep(MOUSE)
    view.show_scene = show
    frame = replace(view.view, width=1000, height=650, pixel=None)
    times = []
    for number in range(20):
        direction = turned((-1, 1, -1), 0.3 * number, 0.05 * number - 0.5)
        picture = player.drawing.picture(
            player.moment, replace(frame, direction=direction).frame(view.stock), (0, 0, 0)
        )
        watch = Watch()
        picture.draw()
        times.append(watch()[1])
    return f"{len(shown) / DRAGGED:.0f} pictures/s; {1e3 * statistics.median(times):.0f} ms of processor time a picture of 1000 x 650"


def drag(player) -> float:
    """Drag the time line forwards and backwards, and return the pictures per second."""
    line, drawn = player.time_line, []
    show = player.view.show_scene
    player.view.show_scene = lambda *scene: (drawn.append(1), show(*scene))
    begin = time.perf_counter()
    while (spent := time.perf_counter() - begin) < DRAGGED:
        share = abs(1 - 2 * spent / DRAGGED)
        where = QtCore.QPointF(share * (line.width() - 1), line.height() - 8)
        event = QtGui.QMouseEvent(
            QtCore.QEvent.MouseMove, where, QtCore.QPointF(line.mapToGlobal(where.toPoint())), QtCore.Qt.NoButton,
            QtCore.Qt.LeftButton, QtCore.Qt.NoModifier,
        )  # fmt: skip
        QtGui.QApplication.sendEvent(line, event)
        QtGui.QApplication.processEvents()
        time.sleep(MOUSE)
    player.view.show_scene = show
    return len(drawn) / DRAGGED


def legacy(document):
    """FreeCAD's legacy simulator."""
    old = freecad.version() < (1, 0, 0)
    module = importlib.import_module("PathScripts.PathSimulatorGui" if old else "Path.Main.Gui.Simulator")
    Gui.Selection.clearSelection()
    panel = module.PathSimulation()
    waiting, memory, watch = Waiting(), resident(), Watch()
    panel.Activate()
    Gui.updateGui()
    first = watch()
    ended: list = []
    end = panel.EndSimulation
    panel.EndSimulation = lambda: (end(), ended.append(1))
    panel.SimFF()
    done = waiting.until(lambda: bool(ended))
    finest, longest, memory = watch(), waiting.end(), resident() - memory
    panel.SimStop()
    Gui.Control.closeDialog()
    return (
        legacy.__doc__[:-1],
        f"{said(first)} raw",
        said(finest, done),
        "-",
        longest,
        f"{memory / 1e6:.0f} MB",
    )


def opengl(document):
    """FreeCAD's OpenGL simulator."""
    module = importlib.import_module("Path.Main.Gui.SimulatorGL")

    from vkworkbench.core.simulators import opengl_speeds

    Gui.activateWorkbench("CAMWorkbench")  # activating the workbench loads the simulator's button icons
    panel = module.CAMSimulation()
    waiting, memory, watch = Waiting(), resident(), Watch()
    panel.Activate()
    panel.SimPlay()
    shown: list = []
    waiting.until(lambda: bool(simulator_windows()))
    (window,) = simulator_windows()
    waiting.until(window.isExposed)
    first = watch()
    frames = Frames(shown)
    window.installEventFilter(frames)
    slid = slide(window, shown)
    shown.clear()
    dragged = [after - before for after, before in zip(watch(), first)]
    for _ in opengl_speeds(freecad.version())[1:]:
        click(window, *FASTER)
        rest(0.3)
    click(window, *PLAY)
    last = still = None
    finest = watch()
    while finest[0] < PATIENCE and not (still and shown):
        changed = watch()
        rest(3.0)
        picture = grabbed(window)
        still, last = picture == last, picture
        finest = finest if still else changed
    longest, memory = waiting.end(), resident() - memory
    finest = finest[0] - dragged[0], finest[1] - dragged[1]
    played = len(shown) / (finest[0] - first[0])
    print(f"    the slider dragged: {slid}; {played:.0f} pictures/s in play", file=OUT)
    window.removeEventFilter(frames)
    window.close()
    Gui.Control.closeDialog()
    return (
        opengl.__doc__[:-1], f"{said(first)} raw", said(finest, bool(still)), "see above", longest, f"{memory / 1e6:.0f} MB",
    )  # fmt: skip


def slide(window, shown: list) -> str:
    """Drag the slider to the right. Return the pictures per second, and how long one mouse move blocked the window."""
    before, held, (left, below) = grabbed(window), [], THUMB
    send(window, left, below, MOVE)
    send(window, left, below, PRESS)
    begin = time.perf_counter()
    while (spent := time.perf_counter() - begin) < DRAGGED:
        watch = Watch()
        send(window, left + int(_SLID * spent / DRAGGED), below, DRAG)
        QtGui.QApplication.processEvents()
        held.append(watch()[0])
        time.sleep(MOUSE)
    moved = "" if grabbed(window) != before else " (the part did not change)"
    send(window, left + _SLID, below, RELEASE)
    longest, median = 1e3 * max(held), 1e3 * statistics.median(held)
    return f"{len(shown) / spent:.1f} pictures/s, a move held the window for {median:.0f} ms, at most {longest:.0f} ms{moved}"


class Frames(QtCore.QObject):
    """Counts the pictures that a window draws."""

    def __init__(self, shown: list) -> None:
        super().__init__()
        self.shown = shown

    def eventFilter(self, _, event) -> bool:
        if event.type() == QtCore.QEvent.UpdateRequest:
            self.shown.append(1)
        return False


def simulator_windows() -> list:
    windows = QtGui.QGuiApplication.allWindows()
    return [w for w in windows if w.isVisible() and "CAMSim" in w.metaObject().className()]


def grabbed(window):
    """Return the picture of the part in the window, without the buttons."""
    return window.screen().grabWindow(0, window.x(), window.y(), window.width(), window.height() - 100).toImage()


def rest(duration: float) -> None:
    end = time.perf_counter() + duration
    while time.perf_counter() < end:
        happen()


def said(spent: tuple[float, float], done: bool = True) -> str:
    return f"{'' if done else '> '}{spent[0]:.1f} s ({spent[1]:.1f})"


def resident() -> int:
    """Return the memory of this process, bytes."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


JOBS = (
    ("the example job", example, (tab, legacy, opengl)),
    ("20 operations, 100,000 moves", made, (tab, legacy, opengl)),
    ("1 operation, 100,000 moves", long, (tab,)),
)
run_and_leave(main)
