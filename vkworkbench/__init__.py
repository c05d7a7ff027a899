# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tell the machining strategy and the simulation cost of FreeCAD's Path/CAM operations from their toolpaths.

    import vkworkbench
    report = vkworkbench.analyze()     # the active document, a job, or operations; writes nothing
    print(report)
    vkworkbench.mark(report)           # into the tree, one undo step
    vkworkbench.clear()

Importing this package is cheap; what the functions need is loaded when they are first called.
"""

from __future__ import annotations

from importlib import import_module

__version__ = "0.1.0"
__all__ = ["Cancelled", "Report", "analyze", "clear", "mark"]

_HOMES = {
    "analyze": "vkworkbench.document.analysis",
    "Cancelled": "vkworkbench.document.analysis",
    "mark": "vkworkbench.document.upkeep",
    "clear": "vkworkbench.document.marking",
    "Report": "vkworkbench.report",
}


def __getattr__(name: str):
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)
