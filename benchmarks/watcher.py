# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the time that the watcher of the marks adds to a recompute of a job with 200 marked operations.

    freecadcmd $PWD/benchmarks/watcher.py

Recomputes with and without the watcher take turns in one run. The script prints the shortest and the median time of a
recompute with and without the watcher, and their ratio. The script also prints the share of the recompute's time that
the watcher's own functions take, which noise does not affect. The exit status is 1 if this share is not below 1 %.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path
from statistics import median

import FreeCAD

ROOT = Path(__file__).resolve().parents[1] if "__file__" in globals() else Path.cwd()
sys.path[:0] = [str(ROOT), str(ROOT / "examples"), str(ROOT / "tests")]
from inside_freecad import run_and_leave
from make_example import HEIGHT, LENGTH, WIDTH, cam, faces, operation, plate

import vkworkbench
from vkworkbench import freecad
from vkworkbench.document import upkeep
from vkworkbench.document.marks import watcher

OPERATIONS, TURNS = 200, 3


class Timed(watcher.Watcher):
    """The watcher of the marks, with a clock for the watcher's own functions."""

    seconds, calls = 0.0, 0


def timed(name):
    original = getattr(watcher.Watcher, name)

    def slot(self, *args):
        start = time.perf_counter()
        original(self, *args)
        Timed.seconds += time.perf_counter() - start
        Timed.calls += 1

    return slot


for name in [name for name in vars(watcher.Watcher) if name.startswith("slot")]:
    setattr(Timed, name, timed(name))


def job_document():
    """Return a job with FreeCAD's operations on the example's plate: faces, pockets of both patterns, and profiles."""
    document = FreeCAD.newDocument()
    model = document.addObject("Part::Feature", "Plate")
    model.Shape = shape = plate()
    job = cam("Main.Job").Create("Job", [model])
    document.recompute()
    controller = job.Tools.Group[0]
    top = faces(shape, "Plane", (0, 0, HEIGHT), (LENGTH, WIDTH, HEIGHT))[:1]
    pocket = faces(shape, "Plane", (18, 14, 12), (62, 48, 12))
    pattern = freecad.POCKET_PATTERN.name
    kinds = [
        ("MillFace", top, {pattern: "ZigZag"}),
        ("PocketShape", pocket, {pattern: "ZigZag"}),
        ("PocketShape", pocket, {pattern: "Offset"}),
        ("Profile", (), {}),
    ]
    for number in range(OPERATIONS):
        kind, base, properties = kinds[number % len(kinds)]
        operation(job, kind, f"{kind} {number}", controller, base, **properties)
    return document, job


def recompute(document, job):
    for op in job.Operations.Group:
        op.touch()
    start = time.perf_counter()
    count = document.recompute()
    seconds = time.perf_counter() - start
    assert count >= OPERATIONS
    return seconds


def main():
    document, job = job_document()
    report = vkworkbench.analyze(document)
    vkworkbench.mark(report)
    FreeCAD.removeDocumentObserver(upkeep._upkeep)  # the watcher that `vkworkbench.mark` has added
    observer = Timed()
    recompute(document, job)
    without, with_watcher, shares = [], [], []
    for turn in range(2 * TURNS):
        # In each four turns, the second and the third have the watcher, so that a drift of the computer's speed affects
        # the times with and without the watcher equally.
        if turn % 4 in (1, 2):
            FreeCAD.addDocumentObserver(observer)
            Timed.seconds, Timed.calls = 0.0, 0
            with_watcher.append(recompute(document, job))
            shares.append(Timed.seconds / (with_watcher[-1] - Timed.seconds))
            FreeCAD.removeDocumentObserver(observer)
        else:
            without.append(recompute(document, job))
    print(
        f"\nFreeCAD {'.'.join(FreeCAD.Version()[:2])}, recompute of {OPERATIONS} operations, {TURNS} turns, shortest and median:"
    )
    print(f"without the watcher  {min(without):7.3f} s  {median(without):7.3f} s")
    print(f"with the watcher     {min(with_watcher):7.3f} s  {median(with_watcher):7.3f} s")
    print(
        f"ratio                {min(with_watcher) / min(without):7.4f}    {median(with_watcher) / median(without):7.4f}"
    )
    print(
        f"the watcher's own functions, share of the recompute: {min(shares):.2%}, {median(shares):.2%}; FreeCAD calls them {Timed.calls} times"
    )
    return 0 if median(shares) < 0.01 else 1


run_and_leave(main)
