# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD 0.20 ends after an undo, by itself: a job is made, that is undone, and something else is done.

    MALLOC_PERTURB_=255 xvfb-run -a freecad $PWD/benchmarks/freecad_undo.py

A job is made in several steps. *Create ToolBit* is the last that undo knows; that the tool controller has this tool is
in no step. So the undo takes the tool away and leaves the controller's link to it; the next step of any kind, for which
FreeCAD forgets what could be redone, frees the tool, and the next recompute follows the link. The variable fills free
memory, so that it ends at once. Run without the add-on, which this script does not import.
"""

import os

import FreeCAD

try:
    from Path.Main import Job
except ImportError:  # before 1.0
    from PathScripts import PathJob as Job

document = FreeCAD.newDocument("Undone")
document.UndoMode = 1  # as in a window
block = document.addObject("Part::Box", "Block")
document.recompute()
controller = Job.Create("Job", [block]).Tools.Group[0]
document.recompute()
print("undo:", document.UndoNames, flush=True)
document.undo()
document.openTransaction("Anything")
block.Label = "Another"
document.commitTransaction()
print("then a recompute", flush=True)
controller.touch()
document.recompute()
print("FreeCAD lives", flush=True)
os._exit(0)
