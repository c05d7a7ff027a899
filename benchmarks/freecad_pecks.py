# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's window takes all memory for one command, by itself: it draws each peck of a drilling cycle, without a bound.

    (ulimit -v 8000000; xvfb-run -a freecad $PWD/benchmarks/freecad_pecks.py)

Printed are the seconds and the memory that the drawing of a hole took with ever smaller pecks, until FreeCAD ends. A
peck that is lost in rounding, such as 1e-20 mm, is drawn for ever. Run without the add-on, which this script does not import.
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
