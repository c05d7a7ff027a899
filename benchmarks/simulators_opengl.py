# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure plays in the OpenGL simulator's own window, for benchmarks/simulators.py."""

from __future__ import annotations

import time
from functools import partial
from statistics import median

import FreeCAD
import FreeCADGui
import numpy as np
import Part
import Path
from CAMSimulator import PathSim
from measuring import RENDERER, beside, in_rounds, left_out, summary
from opengl_window import FASTER, PLAY, click
from PySide import QtCore, QtGui

from vkworkbench import freecad
from vkworkbench.core import Tool, linearize
from vkworkbench.core.simulators import Task, opengl_cost, opengl_speeds
from vkworkbench.document.computer.calibration import constants, known_speed

LONGEST = 8.0  # maximum predicted time of a play, s
PATIENCE = 60.0  # time limit of a play, s


class Frames(QtCore.QObject):
    """Records the times at which the simulator's window draws."""

    def __init__(self):
        super().__init__()
        self.times = []

    def eventFilter(self, _, event):
        if event.type() == QtCore.QEvent.UpdateRequest:
            self.times.append(time.perf_counter())
        return False


def run(samples, out):
    """Play every sample that does not take too long at the highest speed, and print the ratios of prediction to time.

    Each prediction is multiplied by the median ratio of time to prediction in the runs before it.
    """
    FreeCADGui.activateWorkbench("CAMWorkbench")  # activating the workbench loads the simulator's button icons
    speed = max(opengl_speeds(freecad.version()))
    simulator = PathSim()
    cases = []
    for label, commands, tool, stock in [*lines_and_arcs(samples[0]), *samples]:
        cost = opengl_cost(
            Task(linearize(commands), tool, stock), speeds=(speed,), constants=constants(known_speed(), RENDERER)
        )
        if 1 < cost.play_seconds[speed] < LONGEST:
            frames = -(-cost.steps // speed)
            cases.append((label, cost, partial(play, simulator, commands, tool, stock, frames)))
    durations = in_rounds([("OpenGL play", playing) for _, _, playing in cases])
    ratios, scales = [], []
    for (label, cost, _), seconds in zip(cases, durations):
        heading = f"  OpenGL  {label:40.40}{cost.draws:7} draw calls"
        if seconds is None:
            print(f"{heading}  did not play", file=out)
            continue
        unscaled = cost.play_seconds[speed]
        predicted = unscaled * median(scales or [1.0])
        print(f"{heading}  {beside(predicted, seconds)}", file=out)
        if not seconds:
            continue
        true = median(seconds)
        if scales:
            ratios.append(max(predicted / true, true / predicted))
        scales.append(true / unscaled)
    print(summary("OpenGL play, by calibration alone", [max(scale, 1 / scale) for scale in scales]), file=out)
    print(summary("OpenGL play", ratios), file=out)
    print(left_out(durations), file=out, flush=True)


def lines_and_arcs(sample):
    """Return paths of lines only and of arcs only, with a sample's tool and stock, and lines with a ball end mill."""
    _, _, tool, stock = sample
    x, y, top = stock.lower[0] + 10, stock.lower[1] + 10, stock.upper[2]
    start = ("G0", {"X": x, "Y": y, "Z": top})
    for count in (100, 200):
        rows = [("G1", {"X": x + 40 * (i % 4 in (0, 1)), "Y": y + 0.2 * i, "Z": top - 5}) for i in range(count)]
        yield f"{count} lines", [start, *rows], tool, stock
        yield f"{count} lines with a ball end", [start, *rows], Tool("ballend", tool.diameter), stock
    right = ("G3", {"X": x + 20, "Y": y, "Z": top - 5, "I": 10.0, "J": 0.0})
    left = ("G3", {"X": x, "Y": y, "Z": top - 5, "I": -10.0, "J": 0.0})
    half = [right, left] * 20
    yield "40 arcs", [start, *half], tool, stock


def play(simulator, commands, tool, stock, frames):
    """Play at the highest speed, and return the time of all frames, s; None if not all frames were played."""
    simulator.ResetSimulation()
    simulator.AddTool(profile(tool), 1, tool.diameter, 1)
    for name, words in commands:
        simulator.AddCommand(Path.Command(name, words))
    simulator.BeginSimulation(Part.makeBox(*(stock.upper - stock.lower), FreeCAD.Vector(*stock.lower)), 10)
    wait(2)
    window = next(w for w in QtGui.QGuiApplication.allWindows() if "CAMSim" in w.metaObject().className())
    for _ in opengl_speeds(freecad.version())[1:]:
        click(window, *FASTER)
        wait(0.3)
    still = picture(window)
    seen = Frames()
    window.installEventFilter(seen)
    begin = time.perf_counter()
    click(window, *PLAY)
    while len(seen.times) < frames and time.perf_counter() - begin < PATIENCE:
        wait(0.1)
    window.removeEventFilter(seen)
    played = picture(window) != still
    window.close()
    wait(0.5)
    return seen.times[frames - 1] - begin if played and len(seen.times) >= frames else None


def picture(window):
    """Return the picture of the part in the window, without the buttons."""
    screen = window.screen()
    return screen.grabWindow(0, window.x(), window.y(), window.width(), window.height() - 100).toImage()


def profile(tool):
    """Return radii and heights along the tool's outline, from the top to the tip, as FreeCAD's panel computes them."""
    corner = tool.rounding
    turns = np.linspace(0, np.pi / 2, int(corner * np.pi / 2 / 0.5) + 2 if corner else 1)
    radii = [*(tool.radius - corner * (1 - np.cos(turns))), *([0.0] if corner < tool.radius else [])]
    return [tool.radius, 30.0] + [float(v) for r in radii for v in (r, tool.height(r))]


def wait(seconds):
    """Let FreeCAD's event loop run."""
    loop = QtCore.QEventLoop()
    QtCore.QTimer.singleShot(int(1000 * seconds), loop.quit)
    getattr(loop, "exec_" if hasattr(loop, "exec_") else "exec")()
