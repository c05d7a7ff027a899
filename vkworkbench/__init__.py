# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognise the machining strategies of FreeCAD's Path/CAM operations, and predict the cost of simulating them.

    import vkworkbench
    report = vkworkbench.analyze()     # analyses the active document, a job, or operations, and writes nothing
    report = vkworkbench.analyze("program.nc")     # analyses NC programs or a folder, also without FreeCAD
    print(report)
    vkworkbench.mark(report)           # marks the operations in FreeCAD's tree in one undo step
    vkworkbench.clear()                # removes the marks
    vkworkbench.set_clamps(job, [vice])     # sets the clamps, for which simulations report collisions
    vkworkbench.set_previous_job(second, first)     # the finished part of the first job is the stock of the second
    vkworkbench.simulate(job, view="Isometric").at(100)     # returns the part after 100 trajectories
    vkworkbench.simulate("program.nc").facts()      # finds crashes and collisions, also without FreeCAD

Importing this package is cheap, because the functions load their modules when they are first called.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Iterable
from importlib import import_module

__version__ = "0.1.0"
__all__ = ["Cancelled", "Report", "analyze", "clear", "mark", "set_clamps", "set_previous_job", "simulate"]

# Versions of numpy before 1.20 warn when NaN is compared, but this package compares NaN intentionally.
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
    """Recognise the strategies of operations or NC programs, and compute lengths, times and simulation costs.

    Parameters
    ----------
    what : Document, DocumentObject, path, or iterable of objects or paths, optional
        A document (with all its jobs and imported toolpaths), a job, or operations; or files and folders of NC
        programs. None stands for the active document.
    progress : callable, optional
        Called before each operation or file with the number of finished operations or files, the total number, and the
        label.
    cancelled : callable, optional
        Called during the analysis. If the function returns True, the analysis ends.
    machine : Machine, str or path, optional
        The machine for which machining times are planned: a `vkworkbench.core.Machine`, the name of a typical machine
        ("hobby-router", "small-mill", "machining-centre"), or a file with the settings that grbl prints (``$$``). None
        stands for the machine in the preferences.

    Returns
    -------
    Report
        One row for each operation. If an operation has a problem, its row states the problem, and all other operations
        are analysed.

    Raises
    ------
    ValueError
        If `what` is None and no document is open, if the name of a file is empty or is the text of a program, or if
        `machine` is neither a typical machine nor a file of settings.
    ReferenceError
        If an object of `what` was deleted, or its document was closed.
    TypeError
        If `what` has another type, or if `progress` or `cancelled` cannot be called. Without FreeCAD, only files and
        folders are accepted.
    Cancelled
        If `cancelled` returned True.
    """
    from vkworkbench import program
    from vkworkbench.given import of_kind

    for name, given in (("progress", progress), ("cancelled", cancelled)):
        of_kind(name, given, (Callable, type(None)), "a function")
    if isinstance(what, Iterable) and not isinstance(what, (str, bytes)):
        what = list(what)  # a generator can be read only once, but `what` is read more than once
    home = program
    if not program.is_path(what) and (what != [] or "FreeCAD" in sys.modules):
        home = _of_documents("analysis", "analyzed: a file, a folder, or a list of them")
    return home.analyze(what, progress=progress, cancelled=cancelled, machine=machine)


def simulate(what=None, **options):
    """Simulate operations or an NC program in the extended z-buffer, one operation after the other, and write nothing.

    Parameters
    ----------
    what : Document, DocumentObject, iterable of DocumentObject, or path, optional
        A document with one job, a job, or some operations of a job; or the file of an NC program. None stands for the
        active document.
    **options
        For FreeCAD's operations: ``view``, ``stock``, ``clamps``, ``memory_budget``, ``going_on``; see
        `vkworkbench.document.simulation.simulate.simulate`. Programs also accept ``tool``; see
        `vkworkbench.program.simulate`.

    Returns
    -------
    Simulation or ProgramSimulation
        The simulation after its last trajectory.

    Raises
    ------
    Unusable
        If there is nothing to simulate. The exception's message says what to do.
    OverBudget
        If the simulation would exceed the memory limit. Nothing was simulated, and the message names an image that
        fits.
    ValueError, TypeError, ReferenceError
        If an argument has an invalid value, has another type, or was deleted.
    """
    from vkworkbench import program

    if program.is_path(what):
        return program.simulate(what, **options)
    return _of_documents("simulation.simulate", "simulated: the name of a file").simulate(what, **options)


def _of_documents(module: str, otherwise: str):
    """Return a module of `vkworkbench.document`, or raise TypeError if FreeCAD is missing."""
    try:
        return import_module(f"vkworkbench.document.{module}")
    except ModuleNotFoundError as error:
        if error.name != "FreeCAD":
            raise
        raise TypeError(f"without FreeCAD only NC programs are {otherwise}") from None


def __dir__() -> list[str]:
    """Return the names of the package. Without FreeCAD, names that need FreeCAD are left out.

    ``help`` and completion load all returned names, so each of them must be loadable.
    """
    homes = _HOMES.items()
    return sorted({*globals(), *(name for name, home in homes if "FreeCAD" in sys.modules or "document" not in home)})


def __getattr__(name: str):
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)
