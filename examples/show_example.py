# SPDX-License-Identifier: LGPL-2.1-or-later
"""Build, analyse and mark the example job in a FreeCAD window, and save a picture of the tree; used by run.sh.

The script writes example.FCStd, report.txt, marked.FCStd and tree.png to the folder in the environment variable
VKWORKBENCH_OUTPUT. If VKWORKBENCH_LEAVE is set, the script then ends FreeCAD.
"""

from __future__ import annotations

import os
import sys
import traceback
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui
from PySide.QtCore import QPoint, Qt, QTimer
from PySide.QtGui import QPixmap

import vkworkbench
from vkworkbench.gui.tree import column as tree
from vkworkbench.gui.tree import pills

sys.path.insert(0, str(Path(__file__).parent))
from make_example import add_surprises, make_example

OUTPUT = Path(os.environ["VKWORKBENCH_OUTPUT"])
LEAVE = "VKWORKBENCH_LEAVE" in os.environ
TREE_SETTLES = 1000  # waiting time, ms, because FreeCAD updates its tree some time after the document


def guarded(step):
    """Run `step` when FreeCAD's event loop is idle; an error ends FreeCAD instead of only being printed."""

    def run():
        try:
            step()
        except Exception:
            traceback.print_exc(file=sys.__stderr__)
            sys.__stderr__.flush()
            os._exit(1)

    return run


def analyze():
    Gui.activateWorkbench("VkWorkbench")
    doc = make_example(OUTPUT / "example.FCStd")
    add_surprises(doc)
    doc.save()
    report = vkworkbench.analyze(doc)
    (OUTPUT / "report.txt").write_text(f"{report}\n", encoding="utf-8")
    FreeCAD.Console.PrintMessage(f"{report}\n")
    vkworkbench.mark(report)
    doc.saveAs(str(OUTPUT / "marked.FCStd"))
    Gui.SendMsgToActiveView("ViewFit")
    tree.show_description()
    QTimer.singleShot(TREE_SETTLES, guarded(expand_tree))


def expand_tree():
    """Open the job and its operations in the tree."""
    job = FreeCAD.ActiveDocument.getObject("Job")
    (view,) = [view for view in tree.trees() if view.isVisible()]
    shown = {FreeCAD.ActiveDocument.Label, job.Label, job.Operations.Label}

    def expand(parent):
        for row in range(view.model().rowCount(parent)):
            index = view.model().index(row, 0, parent)
            if index.data() in shown or not parent.isValid():
                view.expand(index)
                expand(index)

    expand(view.rootIndex())
    view.setMinimumSize(600, 450)  # pixels; large enough to show all marks in the picture
    QTimer.singleShot(TREE_SETTLES, guarded(lambda: take_picture(view)))


def take_picture(view):
    pills.fit_column()
    picture = QPixmap(view.size())
    picture.fill(Qt.white)  # FreeCAD 1.1 draws the tree without a background
    view.render(picture, QPoint())
    picture.save(str(OUTPUT / "tree.png"))
    if LEAVE:
        os._exit(0)


QTimer.singleShot(0, guarded(analyze))
