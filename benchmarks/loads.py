# SPDX-License-Identifier: LGPL-2.1-or-later
"""Memory and time of analysing documents of 1,000 to 1,000,000 commands.

    python3 benchmarks/loads.py

It needs freecadcmd. Each size is analysed, marked and cleared in a FreeCAD of its own. Prints the peak of the memory
that the analysis takes beyond that of FreeCAD and the document, the time, and the ratio of each time to that of a
tenth of the commands: 10 is linear.
"""

from __future__ import annotations

import json
import math
import os
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SIZES = [1_000, 10_000, 100_000, 1_000_000]
OPERATIONS = 4


def memory(line):
    """A line of the process's status in bytes: VmRSS is what it takes, VmHWM the peak since the last reset."""
    status = Path("/proc/self/status").read_text()
    return 1024 * next(int(entry.split()[1]) for entry in status.splitlines() if entry.startswith(line + ":"))


def raster(commands, length=100.0):
    """Path of a raster over a wavy surface with as many rows as points in a row."""
    import Path as CAM

    rows = points = round(math.sqrt(commands))
    commands = [CAM.Command("G0", {"Z": 30.0}), CAM.Command("G0", {"X": 0.0, "Y": 0.0})]
    for row in range(rows):
        y = row * length / rows
        for i in range(points):
            x = length * (i if row % 2 == 0 else points - 1 - i) / (points - 1)
            z = 10 + 3 * math.sin(0.1 * x) * math.cos(0.1 * y)
            commands.append(CAM.Command("G1", {"X": x, "Y": y, "Z": z, "F": 20.0}))
    return CAM.Path(commands)


def measure(size):
    """Analyse a new document of so many commands in a few operations."""
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
        path = raster(commands // OPERATIONS)
        operations = []
        for _ in range(OPERATIONS):
            op = document.addObject("Path::FeaturePython", "Op")
            op.addProperty("App::PropertyLink", "ToolController", "Path")
            op.ToolController = job.Tools.Group[0]
            op.Path = path
            operations.append(op)
        job.Operations.Group = operations
        document.recompute()
        return document

    vkworkbench.analyze(document_of(1000))  # loads numpy
    document = document_of(size)
    Path("/proc/self/clear_refs").write_text("5")  # resets the peak
    before, start = memory("VmRSS"), time.perf_counter()
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


def main():
    last = None
    print("commands     extra memory   time      ratio to the decade before")
    for size in SIZES:
        environment = {**os.environ, "VK_LOAD": str(size)}
        run = subprocess.run(
            ["freecadcmd", Path(__file__).resolve()],
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
        )
        lines = [line for line in run.stdout.splitlines() if line.startswith("{")]
        if not lines:
            sys.exit(run.stdout + run.stderr)
        found = json.loads(lines[-1])
        ratio = "" if last is None else f"{found['seconds'] / last:.1f}"
        last = found["seconds"]
        row = f"{found['commands']:>9,}    {found['bytes'] / 1e6:>8.0f} MB  {found['seconds']:>7.2f} s"
        print(f"{row}   {ratio:>5}  {found['strategy']}")


sys.path.insert(0, str(ROOT))
if "VK_LOAD" in os.environ:
    print("\n" + json.dumps(measure(int(os.environ["VK_LOAD"]))), flush=True)
    os._exit(0)
elif __name__ == "__main__":
    main()
