# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure fast-forward and play in the legacy simulator's own panel, for benchmarks/simulators.py."""

from __future__ import annotations

import importlib
import time
from functools import partial
from statistics import median
from types import SimpleNamespace

import FreeCAD
import FreeCADGui
import Part
import Path
from measuring import RENDERER, beside, in_rounds, left_out, shape, summary
from PySide import QtCore

from vkworkbench import freecad
from vkworkbench.core import Stock, Tool, linearize
from vkworkbench.core.gcode import Words
from vkworkbench.core.simulators import Conditions, Task, legacy_cost, preflight
from vkworkbench.document.computer.calibration import constants, known_speed

LONGEST = {"fast-forward": 7000, "play": 100}  # maximum number of commands


def run(samples, out):
    """Simulate every sample, and print the ratios of predicted to measured times."""
    panel = open_panel()
    calibrated = constants(known_speed(), RENDERER)
    cases, runs = [], []
    for label, commands, tool, stock in [*odd_arcs(), *samples]:
        path = linearize(commands)
        for kind, longest in LONGEST.items():
            if len(commands) <= longest:
                patience = 10 + 5 * seconds_of(cost_of(path, tool, stock, calibrated), kind)
                cases.append((kind, label, commands, path, tool, stock))
                runs.append((kind, partial(simulate, panel, kind, commands, tool, stock, patience)))
    durations = in_rounds(runs)
    ratios = {kind: [] for kind in LONGEST}
    for (kind, label, commands, path, tool, stock), seconds in zip(cases, durations):
        heading = f"  {kind:13}{label:40.40}{len(commands):6} commands"
        cautions = preflight(Task(path, words=Words(commands)), {}, Conditions(version=freecad.version()))
        hangs = [caution for caution in cautions if caution.code == "legacy-hangs"]
        if seconds is None:
            print(f"{heading}  hangs, {'announced' if hangs else 'NOT announced'}", file=out)
            continue
        predicted = seconds_of(cost_of(path, tool, stock, calibrated), kind)
        vain = "  a hang announced in vain" if hangs else ""
        print(f"{heading}  {beside(predicted, seconds)}{vain}", file=out)
        if seconds:
            true = median(seconds)
            ratios[kind].append(max(predicted / true, true / predicted))
    for kind, values in ratios.items():
        print(summary(kind, values), file=out)
    print(left_out(durations), file=out, flush=True)


def cost_of(path, tool, stock, known):
    """Return the predicted cost of a path; `known` are the measured constants of this computer."""
    return legacy_cost(Task(path, tool, stock), constants=known)


def seconds_of(cost, kind):
    """Return the predicted time of one kind of simulation, s."""
    return cost.play_seconds if kind == "play" else cost.fast_forward_seconds


def odd_arcs():
    """Return arcs on which the panel hangs according to preflight, and one arc on which it does not hang."""
    start = ("G0", {"X": 10.0, "Y": 0.0, "Z": 5.0})
    half = {"X": -10.0, "Y": 0.0, "Z": 5.0, "I": -10.0, "J": 0.0}
    tool, stock = Tool("endmill", 6.0), Stock((-30, -30, 0), (30, 30, 10))
    for label, words in (
        ("an arc", half),
        ("an arc without Z", {k: v for k, v in half.items() if k != "Z"}),
        ("an arc without Y", {k: v for k, v in half.items() if k != "Y"}),
        ("an arc without centre", {k: v for k, v in half.items() if k not in "IJ"} | {"R": 10.0}),
        ("a full circle", half | {"X": 10.0}),
        ("a full circle of odd coordinates", half | {"X": 10.1, "I": -10.1}),
    ):
        first = ("G0", start[1] | {"X": words["X"]}) if "circle" in label else start
        yield label, [first, ("G3", words)], tool, stock


def open_panel():
    """Open the legacy simulator's panel for the open job, with one operation, which `simulate` replaces."""
    old = freecad.version() < (1, 0, 0)
    module = importlib.import_module("PathScripts.PathSimulatorGui" if old else "Path.Main.Gui.Simulator")
    for other in FreeCAD.ActiveDocument.Objects:  # hidden, so that the view is fitted to the simulated part only
        other.Visibility = False
    panel = module.PathSimulation()
    panel.Activate()
    listed = panel.taskForm.form.listOperations
    while listed.count() > 1:
        listed.takeItem(1)
    return panel


def simulate(panel, kind, commands, tool, stock, patience):
    """Simulate commands in place of the panel's operation. Return the time, s; None if the simulation did not end."""
    operation = SimpleNamespace(
        Path=Path.Path([Path.Command(name, words) for name, words in commands]),
        ToolController=SimpleNamespace(Tool=SimpleNamespace(Shape=shape(tool), Name="tool")),
        Name="operation",
    )
    box = Part.makeBox(*(stock.upper - stock.lower), FreeCAD.Vector(*stock.lower))
    panel.operations = [operation]
    panel.job = SimpleNamespace(Stock=SimpleNamespace(Shape=box))
    panel.SetupSimulation()
    panel.resetSimulation = True  # reset the panel to the state after opening it
    FreeCADGui.SendMsgToActiveView("ViewFit")
    FreeCADGui.updateGui()

    loop = QtCore.QEventLoop()
    finished = []
    end = type(panel).EndSimulation

    def ended():
        end(panel)
        finished.append(True)
        loop.quit()

    panel.EndSimulation = ended
    QtCore.QTimer.singleShot(int(1000 * patience), loop.quit)
    begin = time.perf_counter()
    (panel.SimFF if kind == "fast-forward" else panel.SimPlay)()
    getattr(loop, "exec_" if hasattr(loop, "exec_") else "exec")()
    FreeCADGui.updateGui()
    seconds = time.perf_counter() - begin
    done = bool(finished)
    panel.SimStop()
    return seconds if done else None
