# SPDX-License-Identifier: LGPL-2.1-or-later
"""Show that FreeCAD 0.20 crashes without the add-on, after a job was created, undone, and followed by another action.

    MALLOC_PERTURB_=255 xvfb-run -a freecad $PWD/benchmarks/freecad_undo.py

FreeCAD creates a job in several undo steps. The last recorded step is *Create ToolBit*. The link from the tool
controller to the new tool is not part of an undo step. So the undo removes the tool, but not the link to the tool. The
next action deletes the redo steps and frees the tool, and the next recompute follows the link into freed memory.
MALLOC_PERTURB_ fills freed memory, so that FreeCAD crashes at once. The script does not import the add-on.
"""

import os

import FreeCAD

try:
    from Path.Main import Job
except ImportError:  # before 1.0
    from PathScripts import PathJob as Job

document = FreeCAD.newDocument("Undone")
document.UndoMode = 1  # record undo steps, as FreeCAD does by default in a window
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
