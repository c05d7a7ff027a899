# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each operation's toolpath in the colour of its strategy, as the marks have it; one undo takes it back."""

from __future__ import annotations

import FreeCAD

import vkworkbench


def rgb(color):
    """The shares of red, green and blue of a colour such as "#0072d8"."""
    return tuple(int(color[at : at + 2], 16) / 255 for at in (1, 3, 5))


def color_by_strategy(document):
    """Colour the operations' lines; return the colour of each by the operation's name."""
    report = vkworkbench.analyze(document)
    colors = {o.name: rgb(o.strategy.color) for o in report.operations if o.strategy.is_answer}
    document.openTransaction("Color by strategy")
    for name, color in colors.items():
        view = document.getObject(name).ViewObject
        if view is not None:  # without a window there is none
            view.NormalColor = color
    document.commitTransaction()
    return colors


if __name__ == "__main__":
    if FreeCAD.ActiveDocument is None:
        FreeCAD.Console.PrintError("Open a document with a job first\n")
    else:
        color_by_strategy(FreeCAD.ActiveDocument)
