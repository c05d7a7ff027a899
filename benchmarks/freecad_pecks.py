# SPDX-License-Identifier: LGPL-2.1-or-later
"""Show that FreeCAD without the add-on uses all memory to draw one drilling cycle, because it draws every peck.

    (ulimit -v 8000000; xvfb-run -a freecad $PWD/benchmarks/freecad_pecks.py)

The script draws a hole with smaller and smaller pecks until FreeCAD ends, and prints the time and the memory of each
drawing. If a peck is so small that rounding removes it, such as 1e-20 mm, the drawing never ends. The script does not
import the add-on.
"""

import os
import resource
import sys
import time

import FreeCAD
import Path
from PySide import QtCore


def draw() -> None:
    document = FreeCAD.newDocument("Pecks")
    for exponent in (3, 5, 6, 7, 8, 20):
        begin = time.perf_counter()
        peck = 10.0**-exponent
        path = document.addObject("Path::Feature", "Hole")
        path.Path = Path.Path(
            [Path.Command("G0", {"Z": 5.0}), Path.Command("G83", {"X": 0.0, "Y": 0.0, "Z": -1.0, "R": 1.0, "Q": peck})]
        )
        megabytes = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3
        print(
            f"pecks of {peck:g} mm: {time.perf_counter() - begin:.1f} s, {megabytes:,.0f} MB",
            file=sys.__stdout__,
            flush=True,
        )
    os._exit(0)


QtCore.QTimer.singleShot(0, draw)
