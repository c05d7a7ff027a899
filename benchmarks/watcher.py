# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the watcher of the marks adds to a recompute of a job of 200 operations, all of them marked.

    freecadcmd benchmarks/watcher.py

Recomputes with and without the watcher take turns in one run. Printed are the shortest and the median of each, in
processor time, their ratio, and the share of the recompute that the watcher's own functions took, which noise does not
hide. Exits with 1 where that share is not below 1 %.
"""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path
from statistics import median

import FreeCAD

ROOT = Path(__file__).resolve().parents[1] if "__file__" in globals() else Path.cwd()
sys.path[:0] = [str(ROOT), str(ROOT / "examples")]
from make_example import cam

import vkworkbench
from vkworkbench.document import watcher

OPERATIONS, TURNS = 200, 3


class Timed(watcher.Watcher):
    """The watcher with a clock."""

    seconds = 0.0


def timed(name):
    original = getattr(watcher.Watcher, name)

    def slot(self, *args):
        start = time.process_time()
        original(self, *args)
        Timed.seconds += time.process_time() - start

    return slot


for name in [name for name in vars(watcher.Watcher) if name.startswith("slot")]:
    setattr(Timed, name, timed(name))


def job_document():
    """A job of FreeCAD's own profile operations on a block, each with its own offset."""
    document = FreeCAD.newDocument()
    block = document.addObject("Part::Box", "Block")
    block.Length, block.Width, block.Height = 100, 80, 20
    document.recompute()
    job = cam("Main.Job").Create("Job", [block])
    for number in range(OPERATIONS):
        op = cam("Op.Profile").Create("Profile")
        op.ToolController = job.Tools.Group[0]
        op.setExpression("OffsetExtra", None)
        op.OffsetExtra = 0.01 * number
    document.recompute()
    return document, job


def recompute(document, job):
    for op in job.Operations.Group:
        op.touch()
    start = time.process_time()
    count = document.recompute()
    seconds = time.process_time() - start
    assert count >= OPERATIONS
    return seconds


def main():
    document, job = job_document()
    report = vkworkbench.analyze(document)
    vkworkbench.mark(report)
    FreeCAD.removeDocumentObserver(watcher._watcher)  # the one of mark
    observer = Timed()
    recompute(document, job)
    without, with_watcher = [], []
    for _ in range(TURNS):
        without.append(recompute(document, job))
        FreeCAD.addDocumentObserver(observer)
        with_watcher.append(recompute(document, job))
        FreeCAD.removeDocumentObserver(observer)
    print(f"\nFreeCAD {'.'.join(FreeCAD.Version()[:2])}, recompute of {OPERATIONS} profiles, {TURNS} turns, shortest and median:")
    print(f"without the watcher  {min(without):7.3f} s  {median(without):7.3f} s")
    print(f"with the watcher     {min(with_watcher):7.3f} s  {median(with_watcher):7.3f} s")
    print(f"ratio                {min(with_watcher) / min(without):7.4f}    {median(with_watcher) / median(without):7.4f}")
    share = Timed.seconds / (sum(with_watcher) - Timed.seconds)
    print(f"the watcher's own functions: {1e3 * Timed.seconds / TURNS:.1f} ms a recompute, {share:.2%} of it")
    return 0 if share < 0.01 else 1


status = 1
try:
    status = main()
finally:
    sys.stdout.flush()
    os._exit(status)
