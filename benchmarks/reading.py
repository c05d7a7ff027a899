# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare the times for reading, recognising and analysing operations with the times of loops that only read commands.

    freecadcmd "$PWD/benchmarks/reading.py" [profile]

The first table shows the times to read and recognise one operation of 100,000 commands. The second table shows the
times to analyse a job of 140 operations with a million commands, for the first time and again without changes.
`profile` prints the functions that take the most time in the first analysis. Only ratios within one run are comparable,
because the times depend on the computer.
"""

import cProfile
import io
import math
import pstats
import sys
import time
from pathlib import Path

import FreeCAD
import Path as CAM

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "examples")]

from make_example import cam

import vkworkbench
from vkworkbench.core import linearize, recognize
from vkworkbench.document.job.results import RESULTS

COUNT = 100_000
RUNS = 7
OPERATIONS = 140
COMMANDS = 1_000_000
ANALYSES = 3
DEPTHS = 10
SIDE = 100.0  # side of the job's block, mm


def scan(count=COUNT, columns=250):
    """Return the commands of a zigzag over a wavy surface."""
    words = [("G0", {"Z": 30.0}), ("G0", {"X": 0.0, "Y": 0.0})]
    rows = max(1, (count - 2) / columns)
    for k in range(count - 2):
        row, place = divmod(k, columns)
        x = place if row % 2 == 0 else columns - 1 - place
        z = 15 + 3 * math.sin(0.1 * x) * math.cos(row / rows * 9) + (k * 7919 % 1000) * 1e-4
        words.append(("G1", {"X": SIDE * x / columns + 1e-4, "Y": SIDE * row / rows, "Z": z, "F": 10.0}))
    return words


def zigzag(count):
    """Return the commands of a zigzag at ten depths. The stepover is computed from the number of commands."""
    words = [("G0", {"Z": 30.0}), ("G0", {"X": 10.0, "Y": 10.0})]
    rows = max(2, count // DEPTHS // 2)
    for depth in range(DEPTHS):
        z = 18.0 - depth
        words.append(("G1", {"X": 10.0, "Y": 10.0, "Z": z, "F": 3.0}))
        for row in range(rows):
            y, far = 10 + 80.0 * row / rows, 90.0 if row % 2 == 0 else 10.0
            words += [("G1", {"X": far, "Y": y, "Z": z, "F": 10.0}), ("G1", {"X": far, "Y": y + 80.0 / rows, "Z": z})]
    return words[:count]


def offsets(count):
    """Return the commands of nested squares with rounded corners, from the outside inwards, at ten depths."""
    words = [("G0", {"Z": 30.0}), ("G0", {"X": 50.0, "Y": 10.0})]
    loops, r = max(2, count // DEPTHS // 9), 4.0
    for depth in range(DEPTHS):
        z = 18.0 - depth
        words.append(("G1", {"X": 50.0, "Y": 10.0, "Z": z, "F": 3.0}))
        for loop in range(loops):
            x = 40 - 34.0 * loop / loops
            words += [
                ("G1", {"X": 50.0, "Y": 50 - x, "Z": z, "F": 10.0}), ("G1", {"X": 50 + x - r, "Y": 50 - x, "Z": z}),
                ("G3", {"X": 50 + x, "Y": 50 - x + r, "Z": z, "I": 0.0, "J": r}),
                ("G1", {"X": 50 + x, "Y": 50 + x - r, "Z": z}),
                ("G3", {"X": 50 + x - r, "Y": 50 + x, "Z": z, "I": -r, "J": 0.0}),
                ("G1", {"X": 50 - x + r, "Y": 50 + x, "Z": z}),
                ("G3", {"X": 50 - x, "Y": 50 + x - r, "Z": z, "I": 0.0, "J": -r}),
                ("G1", {"X": 50 - x, "Y": 50 - x + r, "Z": z}),
                ("G3", {"X": 50 - x + r, "Y": 50 - x, "Z": z, "I": r, "J": 0.0}),
            ]  # fmt: skip
    return words[:count]


def adaptive(count):
    """Return the commands of rows of trochoidal loops, divided into chords, at two depths."""
    words, chords = [("G0", {"Z": 30.0}), ("G0", {"X": 6.0, "Y": 6.0})], 24
    loops = (count - 2) // chords // 2 + 1
    rows = max(1, round(math.sqrt(loops / 3)))
    for k in range(count - 2):
        loop, chord = divmod(k, chords)
        level, loop = divmod(loop, loops)
        row, place = divmod(loop, -(-loops // rows))
        angle = 2 * math.pi * chord / chords
        x, y = 6 + 88 * (place + chord / chords) * rows / loops, 6 + 88 * row / rows
        words.append(
            ("G1", {"X": x + 2 * math.cos(angle), "Y": y + 2 * math.sin(angle), "Z": 15.0 - 5 * level, "F": 20.0})
        )
    return words


def bores(count):
    """Return the commands of helices of half circles in rows of holes."""
    words, turns = [("G0", {"Z": 30.0})], 40
    holes = -(-count // (2 * turns + 4))
    side = math.ceil(math.sqrt(holes))
    for hole in range(holes):
        x, y = (10 + 80 * (k + 0.5) / side for k in divmod(hole, side))
        words += [("G0", {"Z": 30.0}), ("G0", {"X": x + 2, "Y": y}), ("G1", {"Z": 20.0, "F": 3.0})]
        for half in range(2 * turns):
            sign = 1 if half % 2 == 0 else -1
            words.append(
                (
                    "G3",
                    {
                        "X": x - 2 * sign,
                        "Y": y,
                        "Z": 20 - 18 * (half + 1) / turns / 2,
                        "I": -2.0 * sign,
                        "J": 0.0,
                        "F": 8.0,
                    },
                )
            )
    return words[:count]


def waterline(count):
    """Return the commands of wavy contours at many heights. The lower a contour is, the wider it is."""
    words, points = [("G0", {"Z": 30.0})], 180
    levels = max(1, (count - 1) // (points + 3))
    for level in range(levels):
        z = 20 - 15 * (level + 1) / levels
        contour = []
        for k in range(points + 1):
            angle = 2 * math.pi * k / points
            radius = (45 - z) * (1 + 0.1 * math.cos(5 * angle))
            contour.append((50 + radius * math.cos(angle), 50 + radius * math.sin(angle)))
        words += [("G0", {"Z": 30.0}), ("G0", dict(zip("XY", contour[0]))), ("G1", {"Z": z, "F": 3.0})]
        words += [("G1", {"X": x, "Y": y, "Z": z, "F": 10.0}) for x, y in contour[1:]]
    return words[:count]


def holes(count):
    """Return the commands of drilling cycles."""
    side = math.ceil(math.sqrt(count))
    words = [("G0", {"Z": 30.0}), ("G90", {})]
    for k in range(count - 3):
        row, column = divmod(k, side)
        x, y = 5 + 90 * column / side, 5 + 90 * row / side
        words.append(("G83" if k % 2 else "G81", {"X": x, "Y": y, "Z": 5.0, "R": 22.0, "Q": 4.0, "F": 2.0}))
    return [*words, ("G80", {})]


class Operation:
    """The proxy of an operation. An imported program has no proxy, so the proxy marks an operation made in FreeCAD."""


KINDS = (scan, zigzag, offsets, adaptive, bores, waterline, holes)
FEW = {bores: 0.1, holes: 0.1}  # factors for the number of commands of operations with bores and holes, which are short


def job():
    """Return a job with operations of all kinds. The largest operation is fifty times as long as the smallest."""
    document = FreeCAD.newDocument("Loads")
    block = document.addObject("Part::Box", "Block")
    block.Length, block.Width, block.Height = SIDE, SIDE, 20
    document.recompute()
    made = cam("Main.Job").Create("Job", [block])
    rounds = OPERATIONS // len(KINDS)
    share = [50 ** (k / (rounds - 1)) for k in range(rounds)]
    unit = COMMANDS / sum(share) / sum(FEW.get(kind, 1.0) for kind in KINDS)
    operations = []
    for size in share:
        for kind in KINDS:
            operation = document.addObject("Path::FeaturePython", kind.__name__.capitalize())
            operation.addProperty("App::PropertyLink", "ToolController", "Path")
            operation.Proxy = Operation()
            operation.ToolController = made.Tools.Group[0]
            count = max(20, round(unit * size * FEW.get(kind, 1.0)))
            operation.Path = CAM.Path([CAM.Command(name, words) for name, words in kind(count)])
            operations.append(operation)
    made.Operations.Group = operations
    document.recompute()
    return document, operations


def bare_loop(operation):
    """Read the names and parameters of all commands."""
    names, parameters = [], []
    for command in operation.Path.Commands:
        names.append(command.Name)
        parameters.append(command.Parameters)
    return names, parameters


def whole(operation):
    return recognize(linearize(operation.Path.Commands), tool_diameter=6.0)


def seconds_of(function, *arguments):
    begin = time.process_time()
    function(*arguments)
    return time.process_time() - begin


def one_operation():
    document = FreeCAD.newDocument("Reading")
    operation = document.addObject("Path::Feature", "Scan")
    operation.Path = CAM.Path([CAM.Command(name, words) for name, words in scan()])
    steps = {"names and parameters": bare_loop, "reading, linearising, recognising": whole}
    best = dict.fromkeys(steps, float("inf"))
    for _ in range(RUNS):
        for name, step in steps.items():
            best[name] = min(best[name], seconds_of(step, operation))
    print(f"\nFreeCAD {'.'.join(FreeCAD.Version()[:3])}, {COUNT:,} commands, {whole(operation).strategy}")
    told(best, "names and parameters")
    FreeCAD.closeDocument(document.Name)


def a_job():
    document, operations = job()
    commands = sum(operation.Path.Size for operation in operations)
    if "profile" in sys.argv:
        profiled(document)
    steps = {
        "Path.Commands": lambda: [operation.Path.Commands for operation in operations],
        "names and parameters": lambda: [bare_loop(operation) for operation in operations],
        "analysis": lambda: analyzed(document),
        "analysis again, nothing changed": lambda: vkworkbench.analyze(document),
        "analysis, and every column": lambda: [row.as_dict() for row in analyzed(document).operations],
    }
    best = dict.fromkeys(steps, float("inf"))
    for _ in range(ANALYSES):
        for name, step in steps.items():
            best[name] = min(best[name], seconds_of(step))
    trajectories = sum(row.trajectories for row in vkworkbench.analyze(document).operations)
    print(f"\n{len(operations)} operations, {commands:,} commands, {trajectories:,} trajectories")
    told(best, "names and parameters")


def analyzed(document):
    """Return the report of an analysis without cached results."""
    RESULTS.clear()
    return vkworkbench.analyze(document)


def told(best, unit):
    for name, seconds in best.items():
        print(f"  {name:36s} {seconds * 1e3:8.0f} ms  {seconds / best[unit]:6.2f} x")


def profiled(document):
    profile = cProfile.Profile()
    profile.runcall(vkworkbench.analyze, document)
    text = io.StringIO()
    pstats.Stats(profile, stream=text).sort_stats("tottime").print_stats(45)
    pstats.Stats(profile, stream=text).sort_stats("cumulative").print_stats(70)
    print(text.getvalue())


one_operation()
a_job()
sys.stdout.flush()
