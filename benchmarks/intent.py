#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure how often the remark is right that a toolpath contradicts its operation's name.

    python3 benchmarks/intent.py FILE.jsonl.gz ...

Each FILE contains operations from FreeCAD in the form that records.py describes. A label is the operation's kind,
followed by its pattern if it has one. A remark that a toolpath contradicts its operation's own name is always wrong.
Each operation also gets the name of another random operation whose accepted strategies belong to other families. The
other operation's name always contradicts the strategy, so a remark that says this is always right. The script needs
numpy only.
"""

from __future__ import annotations

import sys
import types
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE)]
sys.modules.setdefault("FreeCAD", types.ModuleType("FreeCAD"))  # an empty module: comparing names does not need FreeCAD

from records import operations

from vkworkbench.core import Strategy
from vkworkbench.core.recognition import recognize
from vkworkbench.document.job.intent import contradicts

KINDS = ("Adaptive", "Deburr", "Drilling", "Engrave", "Helix", "Profile", "Slot", "Tapping", "ThreadMilling", "Vcarve")


def called(label: str) -> str | None:
    """Return the part of a label that is compared with the toolpath: the pattern if given, otherwise the kind."""
    kind, *rest = label.replace("+", ":").split(":")
    if kind in KINDS:
        return kind
    return rest[0] if rest else None


def main(files: list[str]) -> None:
    found = []
    for r in operations(files):
        if name := called(r.label):
            families = {Strategy(s).family for s in r.accepted}
            found.append((name, families, recognize(r.path, tool_diameter=r.tool)))
    false = sum(contradicts(name, what) for name, _, what in found)
    rng = np.random.default_rng(0)
    true = swapped = 0
    for _, families, what in found:
        others = [name for name, theirs, _ in found if not theirs & families]
        if others:
            swapped += 1
            true += contradicts(str(rng.choice(others)), what)
    print(f"{false} of {len(found)} operations are said to contradict their own name: wrong")
    print(f"{true} of {swapped} that were given a name of another family are said to contradict it: right")
    print(f"precision {true / max(1, true + false):.3f}, found {true / max(1, swapped):.3f}")


if __name__ == "__main__":
    main(sys.argv[1:])
