# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw each toolpath in the colour of its strategy. One undo restores the toolpaths' old colours."""

from __future__ import annotations

import FreeCAD

import vkworkbench


def rgb(color):
    """Return red, green and blue, 0 to 1, of a colour such as "#0072d8"."""
    return tuple(int(color[at : at + 2], 16) / 255 for at in (1, 3, 5))


def color_by_strategy(document):
    """Colour the toolpaths; return {name of the operation: colour}."""
    report = vkworkbench.analyze(document)
    colors = {o.name: rgb(o.strategy.color) for o in report.operations if o.strategy.is_answer}
    document.openTransaction("Color by strategy")
    for name, color in colors.items():
        view = document.getObject(name).ViewObject
        if view is not None:  # None without a window
            view.NormalColor = color
    document.commitTransaction()
    return colors


if __name__ == "__main__":
    if FreeCAD.ActiveDocument is None:
        FreeCAD.Console.PrintError("Open a document with a job first\n")
    else:
        color_by_strategy(FreeCAD.ActiveDocument)
