# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's legacy simulator, timed on this computer piece by piece."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import FreeCAD
import numpy as np
import Part
from Path import Command as PathCommand
from PathSimulator import PathSim

from vkworkbench.core import Stock, linearize, steady_seconds
from vkworkbench.core.simulators import DEFAULTS, Constants, Task, legacy_work

# The calibration cuts in a warm cache; real operations take this many times longer (benchmarks/simulators.py).
_COLD_CACHE = 1.5
# How often each piece of work is timed at most.
_RUNS = 20
# The stock that the calibration cuts.
_STOCK = Stock((0, 0, 0), (100, 60, 20))
_BOX = Part.makeBox(100, 60, 20)


def measure_legacy(clock: Callable[[], float], going_on: Callable[[], object]) -> Constants:
    """Time small pieces of the legacy simulator's work, each dominated by one constant."""
    # Short moves of a tool smaller than a cell, of one a few cells wide; long moves; short moves of a wide tool.
    cuts = [_cut(0.08, 0.1, 400), _cut(0.9, 0.1, 300), _cut(8.0, 80.0, 4), _cut(12.0, 0.1, 12)]
    flat, rough = PathSim(), _rough()
    flat.BeginSimulation(_BOX, 0.12)  # a grid as large as in use: a smaller one stays in the cache
    facets = sum(mesh.CountFacets for mesh in rough.GetResultMesh())
    radius, step = 2.0, 0.1
    tool = Part.makeCylinder(radius, 20)

    pieces = [*(run for _, run in cuts), flat.GetResultMesh, rough.GetResultMesh, lambda: flat.SetToolShape(tool, step)]
    *cutting, flat_mesh, rough_mesh, shaping = steady_seconds(pieces, most=_RUNS, clock=clock, going_on=going_on)
    work = np.array([counts for counts, _ in cuts])
    call, ring, line, cap = (np.maximum(np.linalg.solve(work, cutting), 0) * _COLD_CACHE).tolist()
    cell = float(flat_mesh) / (834 * 501)
    facet = max(float(rough_mesh) - cell * 51 * 61, 0) / facets
    profile = float(shaping) / (3 * radius / step)
    return replace(
        DEFAULTS, start=as_slow_here(DEFAULTS.start, cell), call=call, ring=ring, line=line, cap=cap, cell=cell, facet=facet,
        profile=profile,
    )  # fmt: skip


def _cut(diameter: float, length: float, count: int) -> tuple[list[float], Callable[[], object]]:
    """Return moves to and fro: the numbers of calls, rings, steps along and steps around, and what cuts them."""
    resolution = 0.1
    words = [{"X": 10.0 + length * (i % 2), "Y": 30.0, "Z": 15.0} for i in range(count + 1)]
    commands = [PathCommand("G1", word) for word in words[1:]]
    sim = PathSim()
    sim.BeginSimulation(_BOX, resolution)
    sim.SetToolShape(Part.makeCylinder(diameter / 2, 20), diameter)  # a coarse profile: it is not timed here
    start = FreeCAD.Placement(FreeCAD.Vector(10, 30, 15), FreeCAD.Rotation())

    def run():
        position = start
        for command in commands:
            position = sim.ApplyCommand(position, command)

    task = Task(linearize([("G1", word) for word in words]))
    work = legacy_work(task.motions, diameter=diameter, stock=_STOCK, accuracy=resolution)
    counts = [work.calls, work.rings, work.line_steps, work.cap_steps]
    return [float(count.sum()) for count in counts], run


def _rough() -> PathSim:
    """Return a stock of 50 x 60 cells whose heights differ so that its mesh joins none of them."""
    sim = PathSim()
    sim.BeginSimulation(Part.makeBox(50, 60, 20), 1.0)
    sim.SetToolShape(Part.makeCylinder(0.55, 20), 1.0)
    place = FreeCAD.Placement(FreeCAD.Vector(0, 0, 20), FreeCAD.Rotation())
    for x in range(0, 50, 2):
        for y in range(0, 60, 2):
            place = sim.ApplyCommand(place, PathCommand("G0", {"X": x + 0.5, "Y": y + 0.5, "Z": 20.0}))
            place = sim.ApplyCommand(place, PathCommand("G1", {"Z": 3.0 + (7 * x + 3 * y) % 13}))
            place = sim.ApplyCommand(place, PathCommand("G0", {"Z": 20.0}))
    return sim


def as_slow_here(seconds: float, cell: float) -> float:
    """Scale a time from the computer of the defaults to one where a mesh takes `cell` s per cell."""
    return seconds * cell / DEFAULTS.cell
