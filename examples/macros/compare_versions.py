# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare two versions of a job, open as two documents: which operations came, went or do something else now.

Run it as a macro with two documents open: the one that was opened first is the old version.
"""

from __future__ import annotations

import FreeCAD

import vkworkbench

SAME = 0.001  # a share of the length or of the time


def compare(old, new):
    """The differences of two documents' operations, a sentence each; operations are told apart by their labels."""
    before, after = ({o.label: o for o in vkworkbench.analyze(document).operations} for document in (old, new))
    found = [f"{label}: is gone" for label in before if label not in after]
    found += [f"{label}: is new, {o.strategy}" for label, o in after.items() if label not in before]
    for label in before:
        if label in after:
            found += [f"{label}: {difference}" for difference in differences(before[label], after[label])]
    return found


def differences(one, other):
    """How an operation differs from what it was."""
    if one.strategy is not other.strategy:
        yield f"{one.strategy} became {other.strategy}"
    for name, unit in (("length", "mm"), ("machining_seconds", "s")):
        a, b = getattr(one, name) or 0.0, getattr(other, name) or 0.0
        if abs(b - a) > SAME * max(a, b):
            yield f"{name.replace('_seconds', ' time')} {a:.1f} {unit} became {b:.1f} {unit}"


if __name__ == "__main__":
    documents = list(FreeCAD.listDocuments().values())
    if len(documents) != 2:
        FreeCAD.Console.PrintError("Open the two versions of the job, and no other document\n")
    else:
        for line in compare(*documents) or ["no difference"]:
            FreeCAD.Console.PrintMessage(f"{line}\n")
