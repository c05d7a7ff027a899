#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the accuracy of the recognition, the calibration of its confidence, and its time.

    python3 benchmarks/recognition.py [FILE.jsonl.gz ...] [--programs PROGRAMS.jsonl.gz] [--sources | --speed]

FILE contains operations, and PROGRAMS contains whole programs with their sections. records.py describes the form of
both kinds of files. Toolpaths that differ by less than a micrometre count once. Operations of FILE are also joined in
pairs, and toolpaths/nonsense.py makes nonsense paths. The shipped trees may have been learned from FILE. Therefore
--sources prints the accuracy on sources that were left out of the learning, which needs scikit-learn (see
learn_model.py) and some minutes. --speed measures only the time. Without files, the toolpaths of toolpaths/synthetic.py
and strokes.py are used. Without --sources, the script needs numpy only.
"""

from __future__ import annotations

import argparse
import collections
import sys
import time
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE)]

import whole_programs
from records import made, operations
from reliability import how_sure, two_class

from vkworkbench.core import Toolpath
from vkworkbench.core.recognition import recognize

WITHOUT_STEPOVER = {"adaptive", "waterline", "helix"}  # strategies whose property StepOver is not a distance of passes


def accuracy(files: list[str]) -> None:
    """Print which strategies are confused, the shares of right verdicts, and the reliability of the confidence."""
    by_label = collections.defaultdict(lambda: [0, 0])
    confusion: collections.Counter = collections.Counter()
    answers, two, moves, seconds = [], [0, 0], 0, 0.0
    steps = [0, 0]
    for r in operations(files) if files else made():
        began = time.perf_counter()
        found = recognize(r.path, tool_diameter=r.tool)
        seconds += time.perf_counter() - began
        moves += len(r.path)
        got = str(found.strategy)
        right = got in r.accepted
        by_label[r.label][0] += right
        by_label[r.label][1] += 1
        confusion[r.strategy, got if not right else r.strategy] += 1
        answers.append((found.confidence, right))
        if r.stepover and found.stepover and not r.accepted & WITHOUT_STEPOVER:
            steps[0] += abs(found.stepover - r.stepover) <= 0.05 * r.stepover
            steps[1] += 1
        of_class = two_class(r.strategy, r.accepted, got)
        two[0] += bool(of_class)
        two[1] += of_class is not None
    _print_labels(by_label)
    _print_confusion(confusion)
    _print_reliability(answers)
    right = sum(r for _, r in answers)
    mean = np.mean([a / b for a, b in by_label.values()])
    print(
        f"\n{len(answers)} distinct toolpaths: right {right / len(answers):.3f}, "
        f"mean over labels {mean:.3f}, two-class {two[0]}/{two[1]} = {two[0] / max(1, two[1]):.4f}"
    )
    if steps[1]:
        print(f"stepover within 5 % of what FreeCAD was told: {steps[0]}/{steps[1]}")
    print(f"{seconds / max(1, moves) * 1e6:.2f} us per trajectory over {moves} trajectories")


def _print_labels(by_label) -> None:
    print("right by label (only where something is wrong)")
    for label, (right, count) in sorted(by_label.items()):
        if right < count:
            print(f"  {label:36s} {right:4d} of {count}")


def _print_confusion(confusion) -> None:
    names = sorted({name for pair in confusion for name in pair})
    print("\nconfusion: rows are the true strategies, columns the answers; an accepted answer counts as the true one")
    print(" " * 18 + " ".join(f"{name[:7]:>7s}" for name in names))
    for true in names:
        row = [confusion[true, got] for got in names]
        if sum(row):
            print(f"{true:18s}" + " ".join(f"{n or '.':>7}" for n in row))


def _print_reliability(answers) -> None:
    print("\nreliability: how often verdicts of one confidence are right")
    answers = np.array(answers, float)
    print(f"  expected {how_sure(*answers.T)}")
    edges = np.array([0.0, 0.65, 0.75, 0.85, 0.95, 1.0001])
    for low, high in zip(edges[:-1], edges[1:]):
        some = answers[(answers[:, 0] >= low) & (answers[:, 0] < high)]
        if len(some):
            print(
                f"  confidence {low:.2f} to {min(high, 1):.2f}: {len(some):5d} verdicts, "
                f"mean confidence {some[:, 0].mean():.2f}, right {some[:, 1].mean():.2f}"
            )


# Speed


def path_through(points: np.ndarray) -> Toolpath:
    """Return a toolpath whose cutting moves connect the points (n+1, 2)."""
    return Toolpath.through(np.column_stack([points, np.zeros(len(points))]))


def zigzag(n: int) -> Toolpath:
    """Return a raster of n trajectories with ten moves per row."""
    k = np.arange(n + 1)
    row, at = np.divmod(k, 11)
    return path_through(np.column_stack([np.where(row % 2 == 0, at, 10 - at) * 8.0, row * 1.0]))


def linked_offsets(n: int) -> Toolpath:
    """Return n trajectories of closed loops of 36 sides, each linked to the next by a step outward."""
    k = np.arange(n + 1)
    loop, at = np.divmod(k, 37)
    angle, radius = at * 2 * np.pi / 36, 5 + loop * 1.0
    return path_through(np.column_stack([radius * np.cos(angle), radius * np.sin(angle)]))


def linked_squares(n: int) -> Toolpath:
    """Return n trajectories of squares, each linked to the next by a step outward."""
    k = np.arange(n + 1)
    loop, at = np.divmod(k, 5)
    half = 5 + loop * 1.0
    return path_through(
        np.column_stack([half * np.array([-1, 1, 1, -1, -1])[at], half * np.array([-1, -1, 1, 1, -1])[at]])
    )


def obvious(points: np.ndarray) -> np.ndarray:
    """Return phi, the sum of the turns, by plain numpy steps: differences, arctan2, wrap, cumulative sum."""
    steps = np.diff(points[:, :2], axis=0)
    alpha = np.arctan2(steps[:, 1], steps[:, 0])
    return np.cumsum((np.diff(alpha) + np.pi) % (2 * np.pi) - np.pi)


def times(path: Toolpath) -> np.ndarray:
    """Return the processor times of `recognize` and of plain numpy steps for phi, measured alternately, (k, 2) s.

    A computer's speed changes from second to second, so only successive times can be compared.
    """
    pairs, began = [], time.perf_counter()
    while len(pairs) < 5 or (len(pairs) < 200 and time.perf_counter() - began < 4):
        marks = [time.thread_time()]
        for function, argument in ((recognize, path), (obvious, path.points)):
            function(argument)
            marks.append(time.thread_time())
        pairs.append(np.diff(marks))
    return np.array(pairs)


def speed() -> None:
    """Print the time of `recognize` divided by the time of plain numpy steps, for paths of growing length."""
    print(
        f"speed with numpy {np.__version__}: time of recognize / time of the obvious pipeline (median), "
        "and time per trajectory / that at 17,000"
    )
    for make in (zigzag, linked_offsets, linked_squares):
        base = None
        for n in (17_000, 100_000, 1_000_000):
            path = make(n)
            spent = times(path)
            each = spent[:, 0].min() / n
            base = base or each
            print(
                f"  {make.__name__:15s} {n:9d} trajectories: {np.median(spent[:, 0] / spent[:, 1]):5.1f}   "
                f"{each / base:4.2f}   ({recognize(path).strategy})"
            )


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("files", nargs="*")
    parser.add_argument("--programs")
    parser.add_argument(
        "--sources", action="store_true", help="learn and judge with a tenth of the sources left out in turn"
    )
    parser.add_argument("--speed", action="store_true", help="print the cost alone")
    options = parser.parse_args()
    if options.speed:
        speed()
        sys.exit()
    if options.sources:
        import sources  # this module needs scikit-learn

        sources.report_sources(options.files, options.programs)
        sys.exit()
    accuracy(options.files)
    if options.programs:
        whole_programs.report_programs(options.programs)
    if options.files:
        whole_programs.report_joined(list(operations(options.files)))
    whole_programs.report_nonsense()
    print()
    speed()
