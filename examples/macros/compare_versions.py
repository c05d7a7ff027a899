# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare two versions of a job, open as two documents: which operations are new, missing or different.

Run this macro with both documents open; the document with the new version must be active.
"""

from __future__ import annotations

import FreeCAD

import vkworkbench

SAME = 0.001  # two lengths or times count as equal up to this relative difference


def compare(old, new):
    """Return one sentence for each difference between two documents.

    An operation is compared with the operation that has the same label.
    """
    before, after = ({o.label: o for o in vkworkbench.analyze(document).operations} for document in (old, new))
    found = [f"{label}: is missing" for label in before if label not in after]
    found += [f"{label}: is new, {o.strategy}" for label, o in after.items() if label not in before]
    for label in before:
        if label in after:
            found += [f"{label}: {difference}" for difference in differences(before[label], after[label])]
    return found


def differences(one, other):
    """Yield the differences between two versions of an operation."""
    if one.strategy is not other.strategy:
        yield f"{one.strategy} became {other.strategy}"
    for name, unit in (("length", "mm"), ("machining_seconds", "s")):
        a, b = getattr(one, name) or 0.0, getattr(other, name) or 0.0
        if abs(b - a) > SAME * max(a, b):
            yield f"{name.replace('_seconds', ' time')} {a:.1f} {unit} became {b:.1f} {unit}"


def old_and_new():
    """Return the two open documents; the active document is the new version."""
    return sorted(FreeCAD.listDocuments().values(), key=lambda document: document.Name == FreeCAD.ActiveDocument.Name)


if __name__ == "__main__":
    if len(FreeCAD.listDocuments()) != 2:
        FreeCAD.Console.PrintError("Open the two versions of the job, and no other document\n")
    else:
        old, new = old_and_new()
        FreeCAD.Console.PrintMessage(f"From {old.Label} to {new.Label}:\n")
        for line in compare(old, new) or ["no difference"]:
            FreeCAD.Console.PrintMessage(f"{line}\n")
