# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulate jobs with one intentional fault each, and sound jobs, and count the faults that are found.

    python3 benchmarks/zbuffer_faults.py
    freecadcmd "$PWD/benchmarks/zbuffer_faults.py"      # also print the facts on the example job

A block is faced by rows at random distances, to the height of its model. Each fault has a random place and a random depth or feed.
For each kind of fault the benchmark prints the number of jobs, the number of jobs in which the fault is found with the right operation
and command, and the number of jobs in which another fault is found.
"""

from __future__ import annotations

import os
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "benchmarks"), str(ROOT / "examples")]

from zbuffer_cases import toolpath

from vkworkbench.core import Cut, Stock, Tool, View
from vkworkbench.core.zbuffer import facts, simulate_job

JOBS = 40
STOCK, MODEL, TOP = Stock((-1, -1, 0), (41, 31, 10)), Stock((0, 0, 0), (40, 30, 8)), 8.0
TOOL, VIEW = Tool("endmill", 6), View(width=420, height=320)
FEED, PLUNGE = 10.0, 2.0  # mm/s
# A copy of the standard output, because FreeCAD writes its progress to the original.
OUT = os.fdopen(os.dup(1), "w")


def cut(points, rapid=(), plunge=PLUNGE) -> Cut:
    """Return the moves through points, with the feed `plunge` for moves downwards."""
    path = toolpath(np.array(points, float))
    fast = np.isin(np.arange(len(path)), rapid)
    falls = np.diff(path.points[:, 2]) < 0
    return Cut(replace(path, rapid=fast, feed=np.where(fast, 0.0, np.where(falls, plunge, FEED))), TOOL, PLUNGE)


def facing(rng, height=TOP, without=None) -> Cut:
    """Return rows that face the whole block."""
    rows = np.delete(np.linspace(0, 30, rng.integers(7, 12)), [] if without is None else without)
    points = [(x, y, height) for k, y in enumerate(rows) for x in ((-5, 45) if k % 2 == 0 else (45, -5))]
    return cut([(-5, rows[0], 12), *points, (*points[-1][:2], 12)], rapid=[len(points)])


def slot(rng, height, rapid=(), plunge=PLUNGE) -> Cut:
    """Return a plunge at a random place, a slot along X, and a retract by a rapid."""
    x, y = rng.uniform((5, 5), (15, 25))
    return cut([(x, y, 12), (x, y, height), (x + rng.uniform(5, 20), y, height), (x, y, 12)], [*rapid, 2], plunge)


def jobs(rng):
    """Yield the name of each fault, the cuts of its job, and the operation and command that cause it."""
    yield "sound", [facing(rng)], None
    yield "crashes", [slot(rng, rng.uniform(8.2, 9.6), rapid=[1]), facing(rng)], (0, 1)
    yield "fast_plunges", [slot(rng, rng.uniform(8.0, 9.5), plunge=PLUNGE * rng.uniform(1.2, 4)), facing(rng)], (0, 0)
    yield "gouges", [facing(rng), slot(rng, rng.uniform(5, 7.8))], (1, None)
    yield "left", [facing(rng, TOP + rng.uniform(0.15, 1))], (0, None)
    yield "left", [facing(rng, without=[2, 3])], None
    yield "air", [facing(rng), facing(rng)], (1, None)


def found_faults(found) -> dict[str, list[tuple[int, int | None]]]:
    """Return the faults by name, with the operation and command of each fault; None without an operation."""
    faults = {
        name: [None if one.source is None else (one.source.cut, one.source.command) for one in getattr(found.job, name)]
        for name in ("crashes", "fast_plunges", "gouges", "left")
    }
    # Every job cuts some air, because the tool turns beside the block.
    faults["air"] = [(k, None) for k, one in enumerate(found.cuts) if one.air_length_share > 0.5]
    return {name: places for name, places in faults.items() if places}


def main() -> None:
    rng = np.random.default_rng(15)
    rows = {}
    for _ in range(JOBS):
        for name, cuts, made_by in jobs(rng):
            found = found_faults(facts(simulate_job(cuts, stock=STOCK, view=VIEW), model=MODEL))
            places = found.pop(name, [])
            right = not places if name == "sound" else any(_same(place, made_by) for place in places)
            row = rows.setdefault(name, np.zeros(3, int))
            row += [1, right, bool(found)]
    print(f"{'':14}{'jobs':>6}{'found':>6}{'else':>6}", file=OUT)
    for name, row in rows.items():
        print(f"{name:14}" + "".join(f"{n:6}" for n in row), file=OUT, flush=True)


def _same(place, made_by) -> bool:
    return made_by is None or (place is not None and place[0] == made_by[0] and made_by[1] in (None, place[1]))


def example() -> None:
    from make_example import make_example

    import vkworkbench

    with tempfile.TemporaryDirectory() as folder:
        found = vkworkbench.simulate(make_example(Path(folder) / "example.FCStd")).facts()
    print(f"\nthe example job\n{found}", file=OUT, flush=True)
    print(f"left on {sum(one.area for one in found.job.left):.0f} mm2, in {len(found.job.left)} places", file=OUT)


if __name__ == "__main__" or "FreeCAD" in sys.modules:
    main()
    if "FreeCAD" in sys.modules:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        example()
        OUT.flush()
