# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tab of *Simulate toolpaths* beside FreeCAD's own simulators, on the same jobs, in real windows.

    benchmarks/simulation_tab.sh [0.20.2|1.0.0|1.1.3]

which gives FreeCAD a home of its own, without the user's settings. The example job, and one of 20 operations and 100,000
trajectories that is made here. Printed are, from the click: when the first picture is there, when the finest; the
processor time until both, in parentheses; pictures a second while the time line is dragged; the longest time for which an
event had to wait; and the memory that came on top. What is said of the finest picture before it is begun stands below.
FreeCAD's simulators show a finished part only at the end of their fast-forward, or of a play at their fastest; they have
no time line to drag. `VKWORKBENCH_PATIENCE` is how long each may take, s.
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
ROW = "{:30}{:>18}{:>18}{:>12}{:>11}{:>10}"


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
        print(ROW.format("", "first picture", "finest, end", "pictures/s", "waited", "memory"), file=OUT, flush=True)
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
    for name in [obj.Name for obj in document.Objects if operates(obj)]:
        document.removeObject(name)  # the bases of dressups, too
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


def operates(obj) -> bool:
    return freecad.PATH.is_in(obj) and (freecad.CONTROLLER.is_in(obj) or freecad.BASE.is_in(obj))


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


class Watch:
    """Time on the wall and of the processor since it was made, s."""

    def __init__(self) -> None:
        self._begin = time.perf_counter(), time.process_time()

    def __call__(self) -> tuple[float, float]:
        return time.perf_counter() - self._begin[0], time.process_time() - self._begin[1]


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

    def end(self) -> float:
        """Return the longest time, s, and look no more."""
        self._timer.stop()
        return self.longest

    def until(self, condition) -> bool:
        end = time.perf_counter() + PATIENCE
        while not condition():
            if time.perf_counter() > end:
                return False
            QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 10)
        return True


def tab(document):
    """Simulate toolpaths."""
    waiting, memory, watch = Waiting(), resident(), Watch()
    opened = open_tab(document)
    waiting.until(lambda: opened.reading.seen is not None or seen(opened))
    first = watch()
    waiting.until(lambda: opened.player is not None)
    player = opened.player
    told: list[str] = []
    show = player.state.show_expected
    player.state.show_expected = lambda cost: (show(cost), told.append(player.state.text()))
    done = waiting.until(
        lambda: seen(opened) and not player.is_busy and not player._stale and not player.view._rest.isActive()
    )
    finest, longest, memory = watch(), waiting.end(), resident() - memory
    drawn = drag(player)
    print(f"    before: {told[0].strip()};  after: {player.state.text()}", file=OUT)
    opened.window_of().close()
    return (
        tab.__doc__[:-1],
        said(first),
        said(finest, done),
        f"{drawn:.0f}",
        f"{1e3 * longest:.0f} ms",
        f"{memory / 1e6:.0f} MB",
    )


def seen(opened) -> bool:
    """Whether there is a picture of the whole job."""
    return opened.player is not None and opened.player.simulation is not None


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
        f"{1e3 * longest:.0f} ms",
        f"{memory / 1e6:.0f} MB",
    )


def opengl(document):
    """FreeCAD's OpenGL simulator."""
    module = importlib.import_module("Path.Main.Gui.SimulatorGL")
    from opengl_window import FASTER, PLAY, click

    from vkworkbench.core.simulators import opengl_speeds

    Gui.activateWorkbench("CAMWorkbench")  # which loads the pictures of the simulator's buttons
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
    window.removeEventFilter(frames)
    window.close()
    Gui.Control.closeDialog()
    return (
        opengl.__doc__[:-1], f"{said(first)} raw", said(finest, bool(still)), f"{len(shown) / (finest[0] - first[0]):.0f} in play",
        f"{1e3 * longest:.0f} ms", f"{memory / 1e6:.0f} MB",
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


def said(spent: tuple[float, float], done: bool = True) -> str:
    return f"{'' if done else '> '}{spent[0]:.1f} s ({spent[1]:.1f})"


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
        os._exit(0)  # with documents that no one saves FreeCAD would ask


QtCore.QTimer.singleShot(0, run)
