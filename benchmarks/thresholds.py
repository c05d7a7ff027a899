#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the effect of every threshold of the recognition: how many recognised strategies change with its value.

    python3 benchmarks/thresholds.py [--rules] [NAME ...] [FILE.jsonl.gz ...]

Each threshold is divided by 1,000, halved, doubled and multiplied by 1,000. Shares, cosines and angles are also halved
and doubled, but then set to the ends of their range. The toolpaths come from toolpaths/synthetic.py, strokes.py and the
files (in the form that records.py describes). NAME, such as ROWS or ROWS.MAX_DISTANCE, selects thresholds. The script
needs numpy only.

For each new value, the script prints the number of verdicts that change, the number of right verdicts that become wrong
(-), and the number of wrong verdicts that become right (+). The number after ~ counts verdicts with the same strategy,
but with another measured number or confidence. If thresholds were selected by name, the script also prints the kinds of
toolpaths with another verdict. With --rules, only the rules decide, as described in the comments at the thresholds.
Without --rules, the comments do not apply, because the learned trees outvote many of the errors that the comments
describe.
"""

from __future__ import annotations

import collections
import inspect
import re
import sys
import time
from dataclasses import fields
from pathlib import Path
from typing import ClassVar

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE)]

from records import made, operations

from vkworkbench.core.paper import thresholds as of_paper
from vkworkbench.core.recognition import thresholds as of_recognition

HOMES = (of_paper, of_recognition)
#: Functions of the recognition whose results are reused as long as they do not depend on the changed threshold.
STEPS = (
    ("recognize", "monotonous_areas"), ("parts", "monotonous_areas"), ("operation", "paper_verdict"),
    ("recognize", "find_retracts"), ("operation", "Section"),
    ("section", "cut_pieces"), ("section", "relate_rings"), ("section", "relate_strokes"), ("section", "find_rows"),
)  # fmt: skip


class Watched:
    """Replaces one class of thresholds in every module that reads the class."""

    readers: ClassVar[
        list[set]
    ] = []  # one set for each call in progress, the innermost call last: the thresholds that the call has read
    moved: ClassVar[dict] = {}  # changed values of thresholds

    def __init__(self, subject: type) -> None:
        self.subject = subject

    def __getattr__(self, name: str):
        threshold = self.subject.__name__, name
        for reads in self.readers[-1:]:
            reads.add(threshold)
        return self.moved.get(threshold, getattr(self.subject, name))


class Remembered:
    """A function with a cache. The function is called again only if a threshold that it has read was changed."""

    def __init__(self, function) -> None:
        self.function = function
        self.known: dict = {}

    def __call__(self, *arguments, **options):
        same = tuple(a.tobytes() if isinstance(a, np.ndarray) else a if isinstance(a, (int, float)) else id(a)
                     for a in (*arguments, *options.values()))  # fmt: skip
        if same in self.known and not self.known[same][1] & Watched.moved.keys():
            result, reads, _ = self.known[same]
        else:
            Watched.readers.append(set())
            try:
                result = self.function(*arguments, **options)
                for name in ("loops", "phi_range"):  # attributes that are computed at their first use
                    getattr(result, name, None)
            finally:
                reads = Watched.readers.pop()
            if not Watched.moved:
                # The arguments are stored because `same` has their addresses, which must not be used again.
                self.known[same] = result, reads, (arguments, options)
        if Watched.readers:
            Watched.readers[-1] |= reads
        return result


def subjects() -> dict[type, dict[str, str]]:
    """Return the unit of every threshold by class and name, as stated in the threshold's comment."""
    found = {}
    for home in HOMES:
        for _, subject in inspect.getmembers(home, inspect.isclass):
            text = inspect.getsource(subject)
            declared = re.findall(r"#: ([^.\n]+)\..*\n(?:\s*#: .*\n)*\s*(\w+) = ", text)
            found[subject] = {name: unit for unit, name in declared}
    return found


def watch(found) -> None:
    """Replace the classes of thresholds by `Watched` objects, and the functions in STEPS by functions with a cache."""
    watchers = {subject: Watched(subject) for subject in found}
    for name, module in list(sys.modules.items()):
        if name.startswith("vkworkbench.core.") and module not in HOMES:
            for own, value in list(vars(module).items()):
                if inspect.isclass(value) and value in watchers:
                    setattr(module, own, watchers[value])
    for module, name in STEPS:
        module = sys.modules[f"vkworkbench.core.recognition.{module}"]
        setattr(module, name, Remembered(getattr(module, name)))


def moves(value, unit: str) -> list:
    """Return four changed values of a threshold."""
    if unit.startswith(("share", "cosine", "support", "confidence", "isoperimetric")):
        return [0.0, value / 2, min(2 * value, 1.0), 1.0]
    if unit == "rad":
        return [0.0, value / 2, min(2 * value, np.pi), np.pi]
    if isinstance(value, int):
        return [max(1, round(value * factor)) for factor in (1e-3, 0.5, 2, 1e3)]
    return [value * factor for factor in (1e-3, 0.5, 2, 1e3)]


def answer(path, diameter) -> tuple:
    """Return the strategy, and all other results of a recognition."""
    try:
        found = sys.modules["vkworkbench.core.recognition.programs.recognize"].recognize(path, tool_diameter=diameter)
    except Exception as error:  # at the end of its range, a threshold may cause an error in the recognition
        return f"error: {error!r}", ()
    return str(found.strategy), tuple(repr(getattr(found, f.name)) for f in fields(found) if f.name != "paper")


def main(names: list[str], files: list[str]) -> None:
    began = time.perf_counter()
    np.seterr(all="ignore")
    units = subjects()
    watch(units)
    paths = [(r.path, r.tool, r.accepted, r.label) for r in (*made(), *operations(files))]
    base, reads = [], []
    for path, diameter, *_ in paths:
        Watched.readers.append(set())
        base.append(answer(path, diameter))
        reads.append(Watched.readers.pop())
    right = [told in accepted for (told, _), (_, _, accepted, _) in zip(base, paths)]
    print(f"{len(paths)} toolpaths, {sum(right)} verdicts right\n")
    heads = "".join(f"{head:24s}" for head in ("a thousandth or 0", "half", "double", "a thousand or the end"))
    print(f"{'':28s}{'value':>8s}  {'read by':>7s}  {heads}unit")
    count, silent = 0, []
    for subject, of_subject in units.items():
        for name, unit in of_subject.items():
            threshold, value = (subject.__name__, name), getattr(subject, name)
            if names and not {subject.__name__, f"{subject.__name__}.{name}"} & set(names):
                continue
            concerned = [k for k, r in enumerate(reads) if threshold in r]
            columns, kinds, changed = [], [], 0
            count += 1
            for moved in moves(value, unit):
                Watched.moved = {threshold: moved}
                now = {k: answer(*paths[k][:2]) for k in concerned}
                Watched.moved = {}
                other = [k for k in concerned if now[k][0] != base[k][0]]
                worse = sum(right[k] and now[k][0] not in paths[k][2] for k in other)
                better = sum(not right[k] and now[k][0] in paths[k][2] for k in other)
                numbers = sum(now[k] != base[k] for k in concerned) - len(other)
                columns.append(f"{len(other)} -{worse} +{better} ~{numbers}" if other or numbers else ".")
                changed += len(other)
                flips = collections.Counter((paths[k][3], base[k][0], now[k][0]) for k in other)
                kinds += [f"    {moved:.4g}: {n} {label}, {a} -> {b}" for (label, a, b), n in flips.most_common(6)]
            if not changed:
                silent.append(".".join(threshold))
            told = "".join(f"{column:24s}" for column in columns)
            print(f"{'.'.join(threshold):28s}{value:8.4g}  {len(concerned):7d}  {told}{unit}", flush=True)
            if names and kinds:
                print("\n".join(kinds))
    print(f"\n{count} thresholds; without changing a verdict anywhere: {', '.join(silent) or 'none'}")
    print(f"{time.perf_counter() - began:.0f} s")


if __name__ == "__main__":
    if "--rules" in sys.argv:
        sys.modules["vkworkbench.core.recognition.verdict.decide"].elect = lambda nonsense, votes, rules: (rules, 1.0)
    chosen = [a for a in sys.argv[1:] if "jsonl" not in a and a != "--rules"]
    main(chosen, [a for a in sys.argv[1:] if "jsonl" in a])
