# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tab of *Simulate toolpaths* beside FreeCAD's own simulators, on the same jobs, in real windows.

    xvfb-run -a freecad $PWD/benchmarks/simulation_tab.py

The example job, and one of 20 operations and 100,000 trajectories that is made here. Printed are, from the click: when
the first picture is there, when the finest, the processor time until then, pictures a second while the time line is
dragged, the longest time for which an event had to wait, and the memory that came on top. FreeCAD's simulators show a
finished part only at the end of their fast-forward, or of a play at their fastest; they have no time line to drag.
`VKWORKBENCH_PATIENCE` is how long each may take, s.
"""

from __future__ import annotations

import importlib
import os
import sys
import tempfile
import time
import traceback
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui
import Path as Cam
from PySide import QtCore, QtGui

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "examples"), str(ROOT / "tests")]

from make_example import make_example

from vkworkbench import freecad
from vkworkbench.document.simulated_job import read_job
from vkworkbench.gui.simulation.command import open_tab

OUT = sys.__stdout__
PATIENCE = float(os.environ.get("VKWORKBENCH_PATIENCE", "600"))
DRAGGED = 4.0  # s
ROW = "{:34}{:>14}{:>14}{:>12}{:>12}{:>12}{:>10}"


def main() -> None:
    window = Gui.getMainWindow()
    window.setGeometry(0, 0, 1280, 1000)
    window.show()
    folder = Path(tempfile.mkdtemp())
    for name, make in (("the example job", example), ("20 operations, 100,000 moves", made)):
        document = make(folder)
        job = read_job(document)
        moves = sum(len(cut.toolpath) for cut in job.cuts)
        title = f"\nFreeCAD {'.'.join(map(str, freecad.version()))}, {name}: {len(job.cuts)} operations, {moves:,} trajectories"
        print(title, file=OUT)
        print(ROW.format("", "first picture", "finest, end", "processor", "pictures/s", "waited", "memory"), file=OUT)
        for simulator in (tab, legacy, opengl):
            try:
                print(ROW.format(*simulator(document)), file=OUT, flush=True)
            except Exception:  # a FreeCAD without it, or one that fails: the others go on
                last = traceback.format_exc().strip().splitlines()[-1]
                print(f"{simulator.__doc__.splitlines()[0]:34} {last}", file=OUT, flush=True)
        FreeCAD.closeDocument(document.Name)


def example(folder: Path):
    make_example(folder / "example.FCStd")
    return FreeCAD.ActiveDocument


def made(folder: Path):
    """The example's job with 20 pockets of many thin layers, zigzag and contour-parallel in turn."""
    document = example(folder)
    job = next(obj for obj in document.Objects if freecad.OPERATIONS.is_in(obj) and freecad.TOOLS.is_in(obj))
    controller = job.Tools.Group[1]
    for operation in freecad.OPERATIONS.of(job).Group:
        document.removeObject(operation.Name)
    low, high = job.Stock.Shape.BoundBox, job.Stock.Shape.BoundBox.ZMax
    width, depth = low.XLength / 5, low.YLength / 4
    operations = []
    for number in range(20):
        op = document.addObject("Path::FeaturePython", f"Pocket{number + 1}")
        op.addProperty("App::PropertyLink", "ToolController", "Path").ToolController = controller
        op.addProperty("App::PropertyBool", "Active", "Path").Active = True
        corner = low.XMin + width * (number % 5), low.YMin + depth * (number // 5)
        op.Path = Cam.Path([Cam.Command(*command) for command in pocket(number, corner, width, depth, high)])
        operations.append(op)
    job.Operations.Group = operations
    return document


def pocket(number: int, corner, width: float, depth: float, top: float, moves: int = 5000):
    """Commands of one pocket: layers of 0.1 mm, rows or rings 1 mm apart."""
    left, right, front, back = corner[0] + 5, corner[0] + width - 5, corner[1] + 5, corner[1] + depth - 5
    commands = [("G0", {"X": left, "Y": front, "Z": top + 5}), ("G1", {"Z": top, "F": 5.0})]
    z = top
    while len(commands) < moves:
        z -= 0.1
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


class Waiting:
    """Lets FreeCAD's events happen, and notes the longest time in which none could."""

    def __init__(self) -> None:
        self.longest, self._last = 0.0, time.perf_counter()
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._beat)
        self._timer.start(5)

    def _beat(self) -> None:
        now = time.perf_counter()
        self.longest, self._last = max(self.longest, now - self._last), now

    def until(self, condition) -> bool:
        end = time.perf_counter() + PATIENCE
        while not condition():
            if time.perf_counter() > end:
                return False
            QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 10)
        return True


def tab(document):
    """Simulate toolpaths."""
    waiting, memory = Waiting(), resident()
    begin, cpu = time.perf_counter(), time.process_time()
    opened = open_tab(document)
    waiting.until(lambda: opened.player is not None and opened.player.view._scene is not None)
    first = f"{time.perf_counter() - begin:.2f} s", f"{time.process_time() - cpu:.2f} s"
    player = opened.player
    done = waiting.until(lambda: not player.is_busy and not player._stale and not player.view._rest.isActive())
    finest, cpu = time.perf_counter() - begin, time.process_time() - cpu
    longest, memory = waiting.longest, resident() - memory
    drawn = drag(player)
    opened.window_of().close()
    return (
        f"{tab.__doc__} (first: {first[1]})", first[0], seconds(finest, done), f"{cpu:.1f} s", f"{drawn:.0f}",
        f"{1e3 * longest:.0f} ms", f"{memory / 1e6:.0f} MB",
    )  # fmt: skip


def drag(player) -> float:
    """Drag the time line there and back; return the pictures a second."""
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
    player.view.show_scene = show
    return len(drawn) / DRAGGED


def legacy(document):
    """FreeCAD's legacy simulator."""
    old = freecad.version() < (1, 0, 0)
    module = importlib.import_module("PathScripts.PathSimulatorGui" if old else "Path.Main.Gui.Simulator")
    Gui.Selection.clearSelection()
    panel = module.PathSimulation()
    waiting, memory = Waiting(), resident()
    begin, cpu = time.perf_counter(), time.process_time()
    panel.Activate()
    Gui.updateGui()
    first = time.perf_counter() - begin
    ended: list = []
    end = panel.EndSimulation
    panel.EndSimulation = lambda: (end(), ended.append(1))
    panel.SimFF()
    done = waiting.until(lambda: bool(ended))
    finest, cpu = time.perf_counter() - begin, time.process_time() - cpu
    memory = resident() - memory
    panel.SimStop()
    Gui.Control.closeDialog()
    return (
        legacy.__doc__, f"{first:.2f} s, raw", seconds(finest, done), f"{cpu:.1f} s", "-",
        f"{1e3 * waiting.longest:.0f} ms", f"{memory / 1e6:.0f} MB",
    )  # fmt: skip


def opengl(document):
    """FreeCAD's OpenGL simulator."""
    module = importlib.import_module("Path.Main.Gui.SimulatorGL")
    from opengl_window import FASTER, PLAY, click

    from vkworkbench.core.simulators import opengl_speeds

    Gui.activateWorkbench("CAMWorkbench")  # which loads the pictures of the simulator's buttons
    panel = module.CAMSimulation()
    waiting, memory = Waiting(), resident()
    begin, cpu = time.perf_counter(), time.process_time()
    panel.Activate()
    panel.SimPlay()
    shown: list = []
    waiting.until(lambda: bool(simulator_windows()))
    (window,) = simulator_windows()
    waiting.until(window.isExposed)
    first = time.perf_counter() - begin
    frames = Frames(shown)
    window.installEventFilter(frames)
    for _ in opengl_speeds(freecad.version())[1:]:
        click(window, *FASTER)
        rest(0.3)
    click(window, *PLAY)
    last = still = None
    while time.perf_counter() - begin < PATIENCE:
        rest(3.0)
        count, picture = len(shown), grabbed(window)
        still, last = picture == last, picture
        if still and count:
            break
    finest, cpu = time.perf_counter() - begin - 6, time.process_time() - cpu
    memory = resident() - memory
    window.removeEventFilter(frames)
    window.close()
    Gui.Control.closeDialog()
    return (
        opengl.__doc__, f"{first:.2f} s, raw", seconds(finest, bool(still)), f"{cpu:.1f} s",
        f"{len(shown) / (finest - first):.0f} in play", f"{1e3 * waiting.longest:.0f} ms", f"{memory / 1e6:.0f} MB",
    )  # fmt: skip


class Frames(QtCore.QObject):
    """Counts what a window draws."""

    def __init__(self, shown: list) -> None:
        super().__init__()
        self.shown = shown

    def eventFilter(self, _, event) -> bool:
        if event.type() == QtCore.QEvent.UpdateRequest:
            self.shown.append(1)
        return False


def simulator_windows() -> list:
    return [w for w in QtGui.QGuiApplication.allWindows() if "CAMSim" in w.metaObject().className()]


def grabbed(window):
    """The part's picture in the window, without the buttons."""
    return window.screen().grabWindow(0, window.x(), window.y(), window.width(), window.height() - 100).toImage()


def rest(duration: float) -> None:
    end = time.perf_counter() + duration
    while time.perf_counter() < end:
        QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 10)


def seconds(value: float, done: bool) -> str:
    return f"{value:.1f} s" if done else f"> {value:.0f} s"


def resident() -> int:
    """Memory of this process, bytes."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def run() -> None:
    try:
        main()
    except Exception:
        traceback.print_exc(file=OUT)
    finally:
        OUT.flush()
        os._exit(0)


QtCore.QTimer.singleShot(0, run)
