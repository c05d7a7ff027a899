# SPDX-License-Identifier: LGPL-2.1-or-later
"""The extended z-buffer from above against FreeCAD's PathSimulator, which writes no traces.

    freecadcmd "$PWD/benchmarks/zbuffer_freecad.py"

Both cut the same toolpath at the same size of cell, one after the other, in this process, on one core. Printed is the
processor time, of five runs the best, and the ratio.
"""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path

import FreeCAD
import Part
from Path import Command
from PathSimulator import PathSim

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "benchmarks")]

from measuring import shape
from zbuffer_cases import CASES

from vkworkbench.core import View, simulate

RUNS = 5
# FreeCAD writes its progress to the standard output.
OUT = os.fdopen(os.dup(1), "w")
os.dup2(os.open(os.devnull, os.O_WRONLY), 1)


def main() -> None:
    print("processor time, s      trajectories    cell, mm     FreeCAD   z-buffer   ratio", file=OUT)
    for name, (toolpath, tool, stock) in CASES.items():
        view = View()
        cell = view.frame(stock).pixel
        theirs, ours = [], []
        for _ in range(RUNS):  # in turns, so that a slow moment spoils neither alone
            theirs.append(freecads(toolpath, tool, stock, cell))
            begin = time.process_time()
            simulate(toolpath, tool=tool, stock=stock, view=view)
            ours.append(time.process_time() - begin)
        print(
            f"{name:20}{len(toolpath):15,}{cell:12.3f}{min(theirs):12.3f}{min(ours):11.3f}"
            f"{min(ours) / min(theirs):8.2f}",
            file=OUT,
            flush=True,
        )


def freecads(toolpath, tool, stock, cell):
    """Seconds that PathSimulator takes to cut."""
    simulator = PathSim()
    simulator.BeginSimulation(Part.makeBox(*(stock.upper - stock.lower), FreeCAD.Vector(*stock.lower)), cell)
    simulator.SetToolShape(shape(tool), 0.05)
    position = FreeCAD.Placement(FreeCAD.Vector(*toolpath.points[0]), FreeCAD.Rotation())
    moves = [Command("G1", dict(zip("XYZ", point))) for point in toolpath.points[1:].tolist()]
    begin = time.process_time()
    for move in moves:
        position = simulator.ApplyCommand(position, move)
    return time.process_time() - begin


main()
