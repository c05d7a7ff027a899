# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure memory and time for analysing documents of 1,000 to 1,000,000 commands and a program of 1,000,000 lines.

    python3 benchmarks/loads.py

The script needs freecadcmd. Each document is analysed, marked and cleared in a separate FreeCAD process. The documents
have four operations, and the largest number of commands is also tested in one operation. The script prints the peak
memory of the analysis in addition to FreeCAD and the document, and the part of this memory that FreeCAD itself needs to
return the longest path with its commands. The script also prints the time, and the ratio of this time to the time in
the row above, which has a tenth of the commands, so a ratio of 10 means linear time. The program is read without
FreeCAD.
"""

from __future__ import annotations

import json
import math
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
LOADS = [(1_000, 4), (10_000, 4), (100_000, 4), (1_000_000, 4), (1_000_000, 1)]  # commands, operations


def memory(line):
    """Return a line of the process's status, bytes. VmRSS is the present memory, VmHWM the peak since a reset."""
    status = Path("/proc/self/status").read_text()
    return 1024 * next(int(entry.split()[1]) for entry in status.splitlines() if entry.startswith(line + ":"))


def raster(count, length=100.0):
    """Return the points of a raster over a wavy surface, mm, with as many rows as points in a row."""
    rows = points = round(math.sqrt(count))
    for row in range(rows):
        y = row * length / rows
        for i in range(points):
            x = length * (i if row % 2 == 0 else points - 1 - i) / (points - 1)
            yield x, y, 10 + 3 * math.sin(0.1 * x) * math.cos(0.1 * y)


def path_of(points):
    """Return a FreeCAD path through the points."""
    import Path as CAM

    start = [CAM.Command("G0", {"Z": 30.0}), CAM.Command("G0", {"X": 0.0, "Y": 0.0})]
    return CAM.Path([*start, *(CAM.Command("G1", {"X": x, "Y": y, "Z": z, "F": 20.0}) for x, y, z in points)])


def measure(size, count, alone):
    """Analyse a new document of `size` commands in `count` operations. If `alone`, only let FreeCAD return a path."""
    import FreeCAD

    import vkworkbench

    sys.path[:0] = [str(ROOT / "examples")]
    from make_example import cam

    def document_of(commands):
        document = FreeCAD.newDocument()
        block = document.addObject("Part::Box", "Block")
        block.Length, block.Width, block.Height = 100, 100, 20
        document.recompute()
        job = cam("Main.Job").Create("Job", [block])
        path = path_of(raster(commands // count))
        operations = []
        for _ in range(count):
            op = document.addObject("Path::FeaturePython", "Op")
            op.addProperty("App::PropertyLink", "ToolController", "Path")
            op.ToolController = job.Tools.Group[0]
            op.Path = path
            operations.append(op)
        job.Operations.Group = operations
        document.recompute()
        return document

    vkworkbench.analyze(document_of(900))  # loads numpy
    document = document_of(size)
    Path("/proc/self/clear_refs").write_text("5")  # resets the process's peak memory, VmHWM
    before, start = memory("VmRSS"), time.perf_counter()
    if alone:
        path = document.Op.Path
        commands = path.Commands
        return {"commands": len(commands), "bytes": memory("VmHWM") - before}
    report = vkworkbench.analyze(document)
    seconds = time.perf_counter() - start
    vkworkbench.mark(report)
    vkworkbench.clear(document)
    extra = memory("VmHWM") - before
    commands = sum(document.getObject(o.name).Path.Size for o in report.operations)
    return {
        "commands": commands,
        "seconds": seconds,
        "bytes": extra,
        "strategy": report.operations[0].strategy.value,
    }


def measure_program(lines):
    """Analyse an NC program of the given number of lines."""
    import vkworkbench

    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "raster.nc"
        with file.open("w") as text:
            text.write("G21 G90\nT1 M6 (end mill D=6)\nG0 X0 Y0 Z30\n")
            text.writelines(f"G1 X{x:.3f} Y{y:.3f} Z{z:.3f} F1200\n" for x, y, z in raster(lines))
        Path("/proc/self/clear_refs").write_text("5")
        before, start = memory("VmRSS"), time.perf_counter()
        (row,) = vkworkbench.analyze(file).operations
    seconds = time.perf_counter() - start
    print(
        f"An NC program of {row.trajectories:,} moves: {(memory('VmHWM') - before) / 1e6:.0f} MB, {seconds:.2f} s, {row.strategy}"
    )


def run(size, count, alone):
    """Run `measure` in a separate FreeCAD process, and return its results."""
    found = subprocess.run(
        ["freecadcmd", Path(__file__).resolve()],
        env={**os.environ, "VK_LOAD": f"{size} {count} {alone:d}"},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
    )
    lines = [line for line in found.stdout.splitlines() if line.startswith("{")]
    if not lines:
        sys.exit(found.stdout + found.stderr)
    return json.loads(lines[-1])


def main():
    last = None
    print(" commands  operations  extra memory  FreeCAD alone  time       ratio to the one above")
    for size, count in LOADS:
        found, alone = run(size, count, False), run(size, count, True)
        ratio = "" if last is None else f"{found['seconds'] / last:.1f}"
        last = found["seconds"]
        row = f"{found['commands']:>9,}  {count:>10}  {found['bytes'] / 1e6:>9.0f} MB  {alone['bytes'] / 1e6:>10.0f} MB"
        print(f"{row}  {found['seconds']:>7.2f} s  {ratio:>5}  {found['strategy']}", flush=True)
    measure_program(1_000_000)


sys.path.insert(0, str(ROOT))
if "VK_LOAD" in os.environ:
    print("\n" + json.dumps(measure(*map(int, os.environ["VK_LOAD"].split()))), flush=True)
    os._exit(0)
elif __name__ == "__main__":
    main()
