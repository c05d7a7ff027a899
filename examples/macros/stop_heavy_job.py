# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stop before a simulation that is too heavy: say which job takes too long or too much memory, in which simulator."""

from __future__ import annotations

import FreeCAD

import vkworkbench

SECONDS = 600.0
BYTES = 2e9


def too_heavy(document, seconds=SECONDS, memory_bytes=BYTES):
    """What of a document's jobs takes more than that: a sentence for each job and simulator."""
    found = []
    for total in vkworkbench.analyze(document).totals:
        for simulator, cost in total.costs.items():
            if cost.seconds > seconds or cost.memory_bytes > memory_bytes:
                found.append(f"{total.label}, {simulator}: {cost.seconds:.0f} s, {cost.memory_bytes / 1e6:.0f} MB")
    return found


if __name__ == "__main__":
    heavy = too_heavy(FreeCAD.ActiveDocument)
    for sentence in heavy:
        FreeCAD.Console.PrintError(f"Too heavy: {sentence}\n")
    if not heavy:
        FreeCAD.Console.PrintMessage("Every job can be simulated\n")
