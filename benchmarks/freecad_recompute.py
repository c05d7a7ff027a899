# SPDX-License-Identifier: LGPL-2.1-or-later
"""Show that FreeCAD 1.1 crashes in a recompute if a tool changes its size while an object in its body has an error.

    MALLOC_PERTURB_=255 freecadcmd $PWD/benchmarks/freecad_recompute.py

After the recompute, a tool bit creates its body again (Mod/CAM/Path/Tool/toolbit/models/base.py,
slotRecomputedDocument). Then Document::recompute reports the errors of all objects that it has recomputed. Some of the
recomputed objects have been deleted, so FreeCAD reads freed memory. Often FreeCAD only prints nonsense, but sometimes
it ends with SIGSEGV. MALLOC_PERTURB_ fills freed memory, so that FreeCAD crashes at once. The script does not import
the add-on.
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
print("FreeCAD did not crash", flush=True)
os._exit(0)
