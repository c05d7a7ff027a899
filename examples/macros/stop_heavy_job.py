# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stop before a simulation that is too heavy: say which job takes too long or too much memory, in which simulator, and what hangs."""

from __future__ import annotations

import FreeCAD

import vkworkbench

SECONDS = 600.0
BYTES = 2e9


def too_heavy(document, seconds=SECONDS, memory_bytes=BYTES):
    """What of a document takes more than that, hangs, or nobody knows: a sentence for each."""
    report = vkworkbench.analyze(document)
    found = [
        f"{operation.label}: {caution.message}"
        for operation in report.operations
        for caution in operation.cautions
        if caution.code == "legacy-hangs"
    ]
    for total in report.totals:
        if total.incomplete:
            found.append(f"{total.label}: what some of its operations take is not known")
        for simulator, cost in total.costs.items():
            if cost.seconds > seconds or cost.memory_bytes > memory_bytes:
                found.append(f"{total.label}, {simulator}: {cost.seconds:.0f} s, {cost.memory_bytes / 1e6:.0f} MB")
    return found


if __name__ == "__main__":
    if FreeCAD.ActiveDocument is None:
        FreeCAD.Console.PrintError("Open a document with a job first\n")
    else:
        heavy = too_heavy(FreeCAD.ActiveDocument)
        for sentence in heavy:
            FreeCAD.Console.PrintError(f"Stop: {sentence}\n")
        if not heavy:
            FreeCAD.Console.PrintMessage("Nothing here is too heavy to simulate\n")
