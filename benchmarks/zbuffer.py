# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the speed and the memory of the extended z-buffer at 800 x 600 pixels.

    python3 benchmarks/zbuffer.py [quick]

The script needs numpy only. For toolpaths of zbuffer_cases.py, from above and obliquely, the script prints the number
of dexels and trace elements, of tested pairs (a tile or pixel, and a trajectory), and the best processor time of three
runs. The script also tests every trajectory on every ray that the trajectory passes, in a smaller image if this would
take too long, and prints the ratio of this time to the time with culling. Then the script prints how the time grows
with the number of trajectories, the time to show any moment of a simulation, and, without `quick`, the cost of a
million trajectories. The times depend on the computer, and only ratios are comparable. benchmarks/zbuffer_freecad.py
compares the z-buffer with FreeCAD's PathSimulator.
"""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "benchmarks")]

from zbuffer_cases import BALL, BLOCK, CASES, FLAT, PLATE, surface, zigzag

from vkworkbench.core import View, estimate, linearize, simulate
from vkworkbench.core.zbuffer import Cut, memory_needed
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts

# Maximum number of pairs of a pixel and a trajectory in a simulation without culling. With a higher number, the
# benchmark takes minutes per toolpath.
MOST_TRIED = 50e6
# Number of rows of pixels that are cut in one batch, and side of the squares, in pixels, by which the pixels of a batch
# are sorted so that neighbours are close in memory.
ROWS_TRIED, BLOCK_SIDE = 60, 4
VIEWS = {"above": (0, 0, -1), "oblique": (1, 1, -1)}
MOMENTS = 60
GROWTH = (2_000, 8_000, 32_000)


def main() -> None:
    quick = "quick" in sys.argv[1:]
    if "million" in sys.argv[1:]:
        million()
        return
    cases(1 if quick else 3)
    growth()
    moments()
    if not quick:
        # Measured in a separate process, because this process would use memory again that it has already allocated.
        subprocess.run([sys.executable, __file__, "million"], check=True)


def processor_time(function, runs=1):
    """Return the processor time of the fastest run of a function, s, and the function's result."""
    durations = []
    for _ in range(runs):
        begin = time.process_time()
        result = function()
        durations.append(time.process_time() - begin)
    return min(durations), result


def cases(runs) -> None:
    print(f"{'':24}trajectories  traces, 10^6  pairs tested, 10^6   time, s  trying all takes")
    for name, (toolpath, tool, stock) in CASES.items():
        for seen, direction in VIEWS.items():
            solids = {"tool": tool, "stock": stock, "view": View(direction)}
            seconds, z = processor_time(lambda: simulate(toolpath, **solids, processes=1), runs)
            told = f"{name + ', ' + seen:24}{len(toolpath):12,}{z.traces / 1e6:14.2f}"
            told += f"{z.candidates / 1e6:20.1f}{seconds:10.2f}"
            view = tried_in(toolpath, tool, stock, direction)
            small = {**solids, "view": view}
            ours, _ = processor_time(lambda: simulate(toolpath, **small, processes=1), runs)
            theirs, pairs = processor_time(lambda: tried(toolpath, **small))
            size = f"{view.width} x {view.height}, {pairs / 1e6:.1f}"
            print(f"{told}{theirs / ours:12.1f} times, at {size} * 10^6 pairs", flush=True)


def tried(toolpath, tool, stock, view) -> int:
    """Cut all rays of an image without culling; return the number of pairs of a ray and a trajectory that passes it."""
    frame = view.frame(stock)
    removal, pairs = Removal(Cuts([Cut(toolpath, tool)]), stock, frame), 0
    for bottom in range(0, frame.height, ROWS_TRIED):
        row, column = np.mgrid[bottom : min(bottom + ROWS_TRIED, frame.height), 0 : frame.width].reshape(2, -1)
        neighbours = np.lexsort((column // BLOCK_SIDE, row // BLOCK_SIDE))
        _, passes = removal.cut(*frame.pixel_centres(column[neighbours], row[neighbours]))
        pairs += int(passes.sum())
    return pairs


def tried_in(toolpath, tool, stock, direction) -> View:
    """Return the view with the largest image for which a simulation without culling is fast enough."""
    views = [View(direction, width, width * 3 // 4) for width in (800, 400, 200)]
    passes = (estimate(toolpath, None, tool=tool, stock=stock, view=view).candidates for view in views)
    return next((view for view, pairs in zip(views, passes) if pairs < MOST_TRIED), views[-1])


def growth() -> None:
    """Print the exponents with which time, pairs and traces grow with the number of trajectories.

    All toolpaths of a case cut the same plate or block. With more trajectories, the rows are closer, so the removed
    material is about the same.
    """
    print("\ntime ~ trajectories ^ exponent, and pairs tested:")
    for name, path, tool, stock in (
        ("zigzag", zigzag, FLAT, PLATE),
        ("surface", lambda n: surface(100, n // 100), BALL, BLOCK),
    ):
        rows = []
        for count in GROWTH:
            toolpath = path(count)
            seconds, z = processor_time(lambda: simulate(toolpath, tool=tool, stock=stock, view=View(), processes=1), 2)
            rows.append((len(toolpath), seconds, z.candidates, z.traces))
        sizes, seconds, pairs, traces = np.log(np.array(rows, float)).T
        slopes = [np.polyfit(sizes, values, 1)[0] for values in (seconds, pairs, traces)]
        print(f"  {name:10} time {slopes[0]:.2f}, pairs {slopes[1]:.2f}, traces {slopes[2]:.2f}", flush=True)


def moments() -> None:
    print("\nany moment, ms, median of random ones, and of steps forwards and backwards by one:")
    for name, view in (("Z, zigzag", "above"), ("surface", "above"), ("adaptive", "oblique"), ("helices", "above")):
        toolpath, tool, stock = CASES[name]
        *told, first = moments_of(simulate(toolpath, tool=tool, stock=stock, view=View(VIEWS[view])))
        times = "".join(f"{ms:8.1f}" for ms in told)
        print(f"  {name + ', ' + view:22}{times}   once before: {first:.2f} s", flush=True)


def moments_of(z) -> tuple[float, float, float, float]:
    """Return the median times to show random moments, single steps forwards and single steps backwards, ms.

    The last number is the additional time of the first picture, s.
    """
    rng = np.random.default_rng(0)
    first, _ = processor_time(lambda: (z.picture, z.surface.changed(0, 1)))
    middle = z.trajectories // 2
    moments = (
        rng.integers(0, z.trajectories, MOMENTS).tolist(),
        range(middle, middle + MOMENTS),
        range(middle, middle - MOMENTS, -1),
    )
    medians = (1e3 * float(np.median([processor_time(lambda: z.at(k).picture)[0] for k in ks])) for ks in moments)
    return (*medians, first)


def million() -> None:
    toolpath = surface(1000, 1000)
    reading = reading_time(toolpath)
    view = View()
    needed = memory_needed([Cut(toolpath, BALL)], stock=BLOCK, view=view)
    Path("/proc/self/clear_refs").write_text("5")  # resets the process's peak memory, VmHWM
    before = memory("VmRSS")
    seconds, z = processor_time(lambda: simulate(toolpath, tool=BALL, stock=BLOCK, view=view, processes=1))
    peak = memory("VmHWM") - before
    print(
        f"\n{len(toolpath):,} trajectories: {z.traces / 1e6:.1f} * 10^6 traces in {seconds:.1f} s, "
        f"{seconds / reading:.1f} times reading them\n  peak {peak / 1e9:.2f} GB, "
        f"said before {needed / 1e9:.2f} GB ({needed / peak:.2f} times), "
        f"held {z.memory_bytes / 1e9:.2f} GB"
    )


def reading_time(toolpath) -> float:
    """Return the time to make a toolpath from its commands, s."""
    commands = [("G1", dict(zip("XYZ", point), F=10.0)) for point in toolpath.points.tolist()]
    return processor_time(lambda: linearize(commands))[0]


def memory(line) -> int:
    """Return a line of the process's status, bytes. VmRSS is the present memory, VmHWM the peak since a reset."""
    status = Path("/proc/self/status").read_text()
    return 1024 * next(int(entry.split()[1]) for entry in status.splitlines() if entry.startswith(line + ":"))


if __name__ == "__main__":
    main()
