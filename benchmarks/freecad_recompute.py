# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD 1.1 ends in a recompute, by itself: a tool whose size changes while an object of its body is an error.

    MALLOC_PERTURB_=255 freecadcmd $PWD/benchmarks/freecad_recompute.py

A tool bit makes its body anew when it hears that the recompute is over (Mod/CAM/Path/Tool/toolbit/models/base.py,
slotRecomputedDocument). Document::recompute then goes on to tell of the errors of all objects that it had recomputed,
the deleted ones among them, and reads memory that is free: often it says nonsense, sometimes FreeCAD ends with SIGSEGV.
The variable fills free memory, so that it ends at once. Run without the add-on, which this script does not import.
"""

import os

import FreeCAD
from Path.Main import Job

document = FreeCAD.newDocument("Tool")
block = document.addObject("Part::Box", "Block")
document.recompute()
tool = Job.Create("Job", [block]).Tools.Group[0].Tool
document.recompute()
for number in range(20):
    tool.Diameter = 3 + number % 5
    for plane in [obj for obj in document.Objects if obj.Name.startswith("XZ_Plane")]:
        document.removeObject(plane.Name)
    for origin in [obj for obj in document.Objects if obj.TypeId == "App::Origin"]:
        origin.touch()
    document.recompute()
    print(f"recompute {number + 1}", flush=True)
print("FreeCAD lives", flush=True)
os._exit(0)
