# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tell the machining strategy and the simulation cost of FreeCAD's Path/CAM operations from their toolpaths.

    import vkworkbench
    report = vkworkbench.analyze()     # the active document, a job, or operations; writes nothing
    report = vkworkbench.analyze("program.nc")     # an NC program, several, or a folder; needs no FreeCAD
    print(report)
    vkworkbench.mark(report)           # into the tree, one undo step
    vkworkbench.clear()
    vkworkbench.simulate(job, view="Isometric").at(100)     # the part after 100 trajectories

Importing this package is cheap; what the functions need is loaded when they are first called.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable
from importlib import import_module

__version__ = "0.1.0"
__all__ = ["Cancelled", "Report", "analyze", "clear", "mark", "simulate"]

_HOMES = {
    "Cancelled": "vkworkbench.report",
    "mark": "vkworkbench.document.upkeep",
    "clear": "vkworkbench.document.marks.marking",
    "Report": "vkworkbench.report",
    "simulate": "vkworkbench.document.simulation.simulate",
}


def analyze(what=None, *, progress=None, cancelled=None):
    """Analyse operations of FreeCAD, or NC programs: strategy, lengths and what simulating them costs.

    Parameters
    ----------
    what : Document, DocumentObject, path, or iterable of them, optional
        A document (all its jobs and imported toolpaths), a job, or operations; the active document if None. Or files
        of NC programs, and folders of them.
    progress : callable, optional
        Called before each operation or file with how many are done, how many there are, and its label.
    cancelled : callable, optional
        Asked while it goes on; True ends the analysis.

    Returns
    -------
    Report
        One row for each operation; what is wrong with one is in its row and stops no other.

    Raises
    ------
    ValueError
        If `what` is None and no document is open, or if a file's name is empty, or a program's text.
    ReferenceError
        If an object of it was deleted, or its document closed.
    TypeError
        If `what` is something else; without FreeCAD files and folders are all there is. Or if `progress` or `cancelled` is
        nothing that can be called.
    Cancelled
        If `cancelled` returned True.
    """
    from vkworkbench import program
    from vkworkbench.given import of_kind

    for name, given in (("progress", progress), ("cancelled", cancelled)):
        of_kind(name, given, (Callable, type(None)), "a function")
    if isinstance(what, Iterable) and not isinstance(what, (str, bytes)):
        what = list(what)  # a generator can be looked at once
    home = program
    if not program.is_path(what):
        try:
            home = import_module("vkworkbench.document.analysis")
        except ModuleNotFoundError as error:
            if error.name != "FreeCAD":
                raise
            if what != []:
                raise TypeError(
                    "without FreeCAD only NC programs are analyzed: a file, a folder, or a list of them"
                ) from None
    return home.analyze(what, progress=progress, cancelled=cancelled)


def __dir__() -> list[str]:
    """Return what there is, without FreeCAD what needs none: ``help`` and completion load all that is named here."""
    homes = _HOMES.items()
    return sorted({*globals(), *(name for name, home in homes if "FreeCAD" in sys.modules or "document" not in home)})


def __getattr__(name: str):
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)
