# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading an operation from FreeCAD and recognising it, against the bare loop that only reads.

    freecadcmd "$PWD/benchmarks/reading.py"

Ratios within this run are what counts; the times are this computer's.
"""

import sys
import time
from pathlib import Path

import FreeCAD
import Path as CAM

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from vkworkbench.core import linearize, recognize  # noqa: E402

COUNT = 100_000
RUNS = 7


def scan():
    """Commands of a zigzag over a wavy surface, 250 moves a row."""
    commands = [CAM.Command("G0", {"Z": 30.0}), CAM.Command("G0", {"X": 0.0, "Y": 0.0})]
    for k in range(COUNT - 2):
        row, place = divmod(k, 250)
        x = place if row % 2 == 0 else 249 - place
        words = {"X": 0.4 * x + 1e-4, "Y": 0.5 * row, "Z": 5 + (k * 7919 % 1000) * 1e-4, "F": 10.0}
        commands.append(CAM.Command("G1", words))
    return CAM.Path(commands)



def bare_loop(operation):
    names, parameters = [], []
    for command in operation.Path.Commands:
        names.append(command.Name)
        parameters.append(command.Parameters)
    return names, parameters


def whole(operation):
    return recognize(linearize(operation.Path.Commands), tool_diameter=6.0)


def main():
    document = FreeCAD.newDocument("Reading")
    operation = document.addObject("Path::Feature", "Scan")
    operation.Path = scan()
    steps = {"bare loop": bare_loop, "reading, linearising, recognising": whole}
    best = dict.fromkeys(steps, float("inf"))
    for _ in range(RUNS):
        for name, step in steps.items():
            begin = time.perf_counter()
            step(operation)
            best[name] = min(best[name], time.perf_counter() - begin)
    print(f"\nFreeCAD {'.'.join(FreeCAD.Version()[:3])}, {COUNT:,} commands, {whole(operation).strategy}")
    for name, seconds in best.items():
        print(f"  {name:36s} {seconds * 1e3:6.0f} ms  {seconds / best['bare loop']:5.2f} x")
    sys.stdout.flush()


main()
