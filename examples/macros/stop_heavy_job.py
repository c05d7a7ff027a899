# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find jobs whose simulation would hang, take too long or need too much memory."""

from __future__ import annotations

import FreeCAD

import vkworkbench

SECONDS = 600.0
BYTES = 2e9


def too_heavy(document, seconds=SECONDS, memory_bytes=BYTES):
    """Return one sentence for each simulation that hangs, exceeds a limit, or has an unknown cost."""
    report = vkworkbench.analyze(document)
    found = [
        f"{operation.label}: {caution.message}"
        for operation in report.operations
        for caution in operation.cautions
        if caution.code == "legacy-hangs"
    ]
    for total in report.totals:
        if total.incomplete:
            found.append(f"{total.label}: the cost of some of its operations is unknown")
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
