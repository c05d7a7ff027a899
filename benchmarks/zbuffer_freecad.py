# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare the extended z-buffer with FreeCAD's PathSimulator, which only cuts from above and records no traces.

    freecadcmd "$PWD/benchmarks/zbuffer_freecad.py"

Both simulators cut the same toolpaths with the same cell size, one after the other, in this process on one core. The
toolpaths are the cases of zbuffer_cases.py and the example job with all its tools. The script prints the processor
times, the best of three runs, and their ratio. For the view from (1, 1, -1), the image has the same number of pixels,
and the z-buffer's time is compared with FreeCAD's time for the view from above. The last lines show how long it takes
to show any moment of the example job.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from pathlib import Path

import FreeCAD
import numpy as np
import Part
from Path import Command
from PathSimulator import PathSim

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "benchmarks"), str(ROOT / "examples")]

from make_example import make_example
from measuring import shape
from zbuffer import moments_of
from zbuffer_cases import CASES

from vkworkbench.core import Cut, View, simulate_job
from vkworkbench.document.simulation.copy import read_job

RUNS = 3
# A copy of the standard output, because FreeCAD writes its progress to the original.
OUT = os.fdopen(os.dup(1), "w")
os.dup2(os.open(os.devnull, os.O_WRONLY), 1)


def main() -> None:
    print(
        "processor time, s      trajectories    cell, mm     FreeCAD   from above   ratio   (1, 1, -1)   ratio",
        file=OUT,
    )
    for name, cuts, stock in cases():
        view, oblique = View(), View((1, 1, -1))
        cell = view.frame(stock).pixel
        seconds = np.full((3, RUNS), np.nan)
        for run in range(RUNS):  # the simulators take turns, so that a slow moment of the computer affects both
            seconds[0, run] = freecads(cuts, stock, cell)
            for row, seen in ((1, view), (2, oblique)):
                begin = time.process_time()
                simulate_job(cuts, stock=stock, view=seen, processes=1)
                seconds[row, run] = time.process_time() - begin
        theirs, above, tilted = seconds.min(axis=1)
        moves = sum(len(cut.toolpath) for cut in cuts)
        print(
            f"{name:20}{moves:15,}{cell:12.3f}{theirs:12.3f}{above:13.3f}{above / theirs:8.2f}"
            f"{tilted:13.3f}{tilted / theirs:8.2f}",
            file=OUT,
            flush=True,
        )

    print("\nany moment of the example job, ms: random, steps forwards, steps backwards; once before, s", file=OUT)
    for seen, direction in (("above", (0, 0, -1)), ("oblique", (1, 1, -1))):
        done = simulate_job(cuts, stock=stock, view=View(direction))
        print(f"  {seen:10}" + "".join(f"{time:8.1f}" for time in moments_of(done)), file=OUT, flush=True)


def cases():
    """Yield the name, the cuts and the stock of each case."""
    for name, (toolpath, tool, stock) in CASES.items():
        yield name, [Cut(toolpath, tool)], stock
    with tempfile.TemporaryDirectory() as folder:
        job = read_job(make_example(Path(folder) / "example.FCStd"))
    yield "the example job", list(job.cuts), job.stock


def freecads(cuts, stock, cell):
    """Return the time that PathSimulator takes to cut, s."""
    simulator = PathSim()
    simulator.BeginSimulation(Part.makeBox(*(stock.upper - stock.lower), FreeCAD.Vector(*stock.lower)), cell)
    seconds = 0.0
    for cut in cuts:
        simulator.SetToolShape(shape(cut.tool), 0.05)
        position = FreeCAD.Placement(FreeCAD.Vector(*cut.toolpath.points[0]), FreeCAD.Rotation())
        moves = [Command("G1", dict(zip("XYZ", point))) for point in cut.toolpath.points[1:].tolist()]
        begin = time.process_time()
        for move in moves:
            position = simulator.ApplyCommand(position, move)
        seconds += time.process_time() - begin
    return seconds


main()
