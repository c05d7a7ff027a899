# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognise the machining strategies of FreeCAD's Path/CAM operations, and estimate their simulation cost.

    import vkworkbench
    report = vkworkbench.analyze()     # the active document, a job, or operations; writes nothing
    report = vkworkbench.analyze("program.nc")     # one or more NC programs, or a folder; works without FreeCAD
    print(report)
    vkworkbench.mark(report)           # marks the tree in one undo step
    vkworkbench.clear()
    vkworkbench.set_clamps(job, [vice])     # what no tool may touch, for the simulation
    vkworkbench.set_previous_job(second, first)     # the simulation begins with what the first job leaves
    vkworkbench.simulate(job, view="Isometric").at(100)     # the part after 100 trajectories
    vkworkbench.simulate("program.nc").facts()      # crashes and collisions of an NC program; works without FreeCAD

Importing this package is cheap, because the functions load their modules when they are first called.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Iterable
from importlib import import_module

__version__ = "0.1.0"
__all__ = ["Cancelled", "Report", "analyze", "clear", "mark", "set_clamps", "set_previous_job", "simulate"]

# numpy before 1.20 warns when NaN is compared; newer versions do not.
warnings.filterwarnings("ignore", "invalid value encountered in (less|greater)", RuntimeWarning, r"vkworkbench\.")

_HOMES = {
    "Cancelled": "vkworkbench.report",
    "mark": "vkworkbench.document.upkeep",
    "clear": "vkworkbench.document.marks.marking",
    "Report": "vkworkbench.report",
    "set_clamps": "vkworkbench.document.job.clamps",
    "set_previous_job": "vkworkbench.document.job.previous",
}


def analyze(what=None, *, progress=None, cancelled=None, machine=None):
    """Recognise the strategies of operations or NC programs, and estimate lengths, times and simulation costs.

    Parameters
    ----------
    what : Document, DocumentObject, path, or iterable of them, optional
        A document (all its jobs and imported toolpaths), a job, or operations; the active document if None. Or files
        and folders of NC programs.
    progress : callable, optional
        Called before each operation or file with the number of finished ones, the number of all, and the label.
    cancelled : callable, optional
        Called during the analysis. If it returns True, the analysis ends.
    machine : Machine, str or path, optional
        Plans the machining times: a `vkworkbench.core.Machine`, the name of a typical machine ("hobby-router", "small-mill",
        "machining-centre"), or a file with the settings that grbl prints (``$$``). None: the machine of the preferences.

    Returns
    -------
    Report
        One row for each operation. A problem of an operation is in its row, and does not stop the others.

    Raises
    ------
    ValueError
        If `what` is None and no document is open, or if the name of a file is empty or the text of a program.
        Or if `machine` is neither a typical machine nor a file of settings.
    ReferenceError
        If an object of `what` was deleted, or its document was closed.
    TypeError
        If `what` has another type. Without FreeCAD, only files and folders are accepted. Or if `progress` or `cancelled`
        cannot be called.
    Cancelled
        If `cancelled` returned True.
    """
    from vkworkbench import program
    from vkworkbench.given import of_kind

    for name, given in (("progress", progress), ("cancelled", cancelled)):
        of_kind(name, given, (Callable, type(None)), "a function")
    if isinstance(what, Iterable) and not isinstance(what, (str, bytes)):
        what = list(what)  # a generator can be read only once
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
    return home.analyze(what, progress=progress, cancelled=cancelled, machine=machine)


def simulate(what=None, **options):
    """Simulate operations or an NC program in the extended z-buffer, one operation after the other. Writes nothing.

    Parameters
    ----------
    what : Document, DocumentObject, iterable of these objects, or path, optional
        A document with one job, a job, or some of its operations; the active document if None. Or the file of an NC program.
    **options
        For FreeCAD's operations: ``view``, ``stock``, ``clamps``, ``memory_budget``, ``going_on``; see
        `vkworkbench.document.simulation.simulate.simulate`. For a program also ``tool``; see `vkworkbench.program.simulate`.

    Returns
    -------
    Simulation or ProgramSimulation
        The simulation at its last moment.

    Raises
    ------
    Unusable
        If there is nothing to simulate. The message says what to do.
    OverBudget
        If the simulation would need more memory. Nothing was simulated; the message names an image that fits.
    ValueError, TypeError, ReferenceError
        If an argument is impossible, has another type, or was deleted.
    """
    from vkworkbench import program

    if program.is_path(what):
        return program.simulate(what, **options)
    return import_module("vkworkbench.document.simulation.simulate").simulate(what, **options)


def __dir__() -> list[str]:
    """Return the names of the package. ``help`` and completion load all of them, so names that need FreeCAD are left out without it."""
    homes = _HOMES.items()
    return sorted({*globals(), *(name for name, home in homes if "FreeCAD" in sys.modules or "document" not in home)})


def __getattr__(name: str):
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)
