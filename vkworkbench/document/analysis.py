# SPDX-License-Identifier: LGPL-2.1-or-later
"""From operations of a document to a report; reads, and writes nothing."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress

import FreeCAD

from vkworkbench import preferences
from vkworkbench.core import Strategy, estimate, linearize, machining, recognize
from vkworkbench.core.legacy import legacy_costs
from vkworkbench.core.opengl import opengl_cost
from vkworkbench.core.preflight import preflight
from vkworkbench.core.resolution import best_resolution
from vkworkbench.core.simulators import Constants, Simulator, available_simulators, opengl_speeds
from vkworkbench.document import calibration
from vkworkbench.document.fingerprint import fingerprint
from vkworkbench.document.operations import Operation, find
from vkworkbench.document.setting import placed, rapid_feeds, read_stock, read_tool
from vkworkbench.preferences import Preferences
from vkworkbench.report import OperationReport, Report


class Cancelled(Exception):
    """The analysis was cancelled; nothing has been changed."""


def analyze(
    what=None,
    *,
    progress: Callable[[int, int, str], None] | None = None,
    cancelled: Callable[[], bool] | None = None,
) -> Report:
    """Analyse operations: strategy, lengths and what simulating them costs. Writes nothing.

    Parameters
    ----------
    what : Document, DocumentObject, or iterable of them, optional
        A document (all its jobs and imported toolpaths), a job, or operations; the active document if None.
    progress : callable, optional
        Called before each operation with how many are done, how many there are, and its label.
    cancelled : callable, optional
        Asked before each operation; True ends the analysis.

    Returns
    -------
    Report
        One row for each operation; what is wrong with one is in its row and stops no other. An operation
        that is deleted during the analysis has no row.

    Raises
    ------
    ValueError
        If `what` is None and no document is open.
    TypeError
        If `what` is something else.
    Cancelled
        If `cancelled` returned True.
    """
    if what is None:
        what = FreeCAD.ActiveDocument
        if what is None:
            raise ValueError("no document is open: open one with a job or a toolpath")
    operations = find(what)
    chosen = preferences.read()
    constants = calibration.constants(chosen.renderer)
    jobs = {(o.job.Document.Name, o.job.Name): o.job.Label for o in operations if o.job is not None}
    labels = [o.object.Label for o in operations]
    reports = []
    for done, operation in enumerate(operations):
        if cancelled is not None and cancelled():
            raise Cancelled("the analysis was cancelled; nothing has been changed")
        if progress is not None:
            progress(done, len(operations), labels[done])
        with suppress(ReferenceError):  # deleted meanwhile, or its document closed
            reports.append(_analyze(operation, chosen, constants))
    return Report(tuple(reports), jobs)


def _analyze(operation: Operation, chosen: Preferences, constants: Constants) -> OperationReport:
    obj, job = operation.object, operation.job
    errors: list[str] = []
    tool = _or_words(errors, read_tool, obj)
    stock = _or_words(errors, read_stock, job)
    commands = obj.Path.Commands
    try:
        toolpath = placed(linearize(commands, tolerance=chosen.tolerance), obj.Placement)
    except ValueError as error:
        errors.append(str(error))
        toolpath = linearize([])
    found = recognize(toolpath, tool_diameter=tool and tool.diameter)
    if found.strategy is Strategy.EMPTY and not toolpath.commands <= len(toolpath.comments):
        errors.append("no cutting move in its toolpath")
    elif found.strategy is Strategy.EMPTY:
        # Without a toolpath a missing tool or stock is not what is wrong.
        errors = [_why_empty(operation)]
    errors += [str(problem) for problem in toolpath.problems]
    cost = legacy = opengl = resolution = None
    version = tuple(int(number) for number in FreeCAD.Version()[:2])
    if tool and stock and found.strategy is not Strategy.EMPTY:
        cost = estimate(toolpath, found, tool=tool, stock=stock, view=chosen.view)
        resolution = best_resolution([cost], memory_bytes=chosen.memory_budget_bytes, seconds=chosen.time_budget,
                                     stepover=found.stepover)  # fmt: skip
        (legacy,) = legacy_costs(
            toolpath, tool=tool, stock=stock, accuracies=(chosen.legacy_accuracy,), constants=constants
        )
        if Simulator.OPENGL in available_simulators(version):
            opengl = opengl_cost(
                toolpath, diameter=tool.diameter, speeds=opengl_speeds(version), quality=chosen.opengl_quality,
                constants=constants,
            )  # fmt: skip
    horizontal, vertical = rapid_feeds(obj)
    return OperationReport(
        document=obj.Document.Name,
        name=obj.Name,
        label=obj.Label,
        job=job.Name if job is not None else None,
        counted=operation.counted,
        recognition=found,
        trajectories=len(toolpath),
        machining=machining(toolpath, horizontal_rapid=horizontal, vertical_rapid=vertical),
        estimate=cost,
        legacy=legacy,
        opengl=opengl,
        resolution=resolution,
        cautions=preflight(commands, toolpath, version=version, diameter=tool and tool.diameter, legacy=legacy,
                           opengl=opengl, memory_budget=chosen.memory_budget_bytes,
                           time_budget=chosen.time_budget),
        error="; ".join(errors) or None,
        fingerprint=fingerprint(obj, job),
    )  # fmt: skip


def _or_words(errors: list[str], read: Callable, source):
    """Return what `read` reads from `source`, or None with the reason among the errors."""
    try:
        return read(source)
    except ValueError as error:
        errors.append(str(error))
        return None


def _why_empty(operation: Operation) -> str:
    if not operation.active:
        return "inactive: switch it on and recompute it"
    return "no toolpath: recompute the operation and see FreeCAD's report view"
