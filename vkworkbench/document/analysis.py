# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analyse operations of a document, without changing the document."""

from __future__ import annotations

import threading
import traceback
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor, wait
from contextlib import suppress
from dataclasses import replace

import FreeCAD

from vkworkbench import freecad, preferences
from vkworkbench.core import Solid, Strategy, Tool, Toolpath, linearize, machining, stock_around
from vkworkbench.core.gcode import Words, in_seconds, used_up
from vkworkbench.core.simulators import ZBUFFER, Conditions, Cost, Task, predict, preflight, together
from vkworkbench.core.zbuffer import cuts_surely, may_cut
from vkworkbench.document.computer import calibration, garbage
from vkworkbench.document.job import results
from vkworkbench.document.job.fingerprint import AT_ONCE, fingerprint_of, path_and_setting, text_fingerprint, text_of
from vkworkbench.document.job.intent import contradicts
from vkworkbench.document.job.operations import find, fixtures_of, is_there, jobs_of, names_of, or_active_document
from vkworkbench.document.job.path_prints import PATH_PRINTS
from vkworkbench.document.job.reading import IDENTITY, SETTINGS, Reading, read
from vkworkbench.document.job.recognition import recognize_operation
from vkworkbench.document.job.results import RESULTS, key_of
from vkworkbench.document.job.setting import placed
from vkworkbench.document.job.work_offsets import WorkOffsets
from vkworkbench.document.simulation.faults import verdict_on, with_faults
from vkworkbench.language import Message, Unusable
from vkworkbench.preferences import Preferences
from vkworkbench.report import Cancelled, OperationReport, Report, extent_of, setup_of, with_travel, without_results

_WAIT = 0.02  # seconds between two calls of `cancelled`


def analyze(
    what=None,
    *,
    progress: Callable[[int, int, str], None] | None = None,
    cancelled: Callable[[], bool] | None = None,
    machine=None,
) -> Report:
    """Analyse operations of documents. `vkworkbench.analyze` explains the parameters, the result and the errors.

    Without a window, the first analysis also measures the speed of this computer, which takes one to two seconds. An
    operation that was analysed before in this session is only analysed again if the operation, the preferences or the
    calibration have changed. An operation that is deleted during the analysis has no row.

    The function `cancelled` is called before each operation, every 20 ms during an operation, and every 0.1 s while
    this computer is measured. `cancelled` may process Qt's events, if no event changes the documents.
    """

    def going_on() -> None:
        if cancelled is not None and cancelled():
            raise Cancelled("the analysis was cancelled; nothing has been changed")

    operations = find(or_active_document(what))
    chosen = preferences.read().for_machine(machine)
    jobs = jobs_of(operations)
    job_labels = {key: job.Label for key, job in jobs.items()}
    fixtures = {key: fixtures_of(job) for key, job in jobs.items()}
    posted = [[names_of(o.object) for o in find(job) if o.counted] for job in jobs.values()]
    labels = [o.object.Label for o in operations]
    speed = calibration.measured_speed(going_on)
    conditions = Conditions(
        version=freecad.version(),
        constants=calibration.constants(speed, chosen.renderer),
        speed=speed,
        view=chosen.view,
        legacy_accuracy=chosen.legacy_accuracy,
        opengl_quality=chosen.opengl_quality,
        memory_budget=chosen.memory_budget_bytes,
        time_budget=chosen.time_budget,
    )
    reports = []
    for done, operation in enumerate(operations):
        going_on()
        if progress is not None:
            progress(done, len(operations), labels[done])
        with suppress(ReferenceError):  # the operation was deleted, or its document closed, during the analysis
            if not is_there(operation.object):
                continue
            token = PATH_PRINTS.begin(operation.object)
            reading = read(operation)
            going_on()  # lets Qt handle events between the copying of the path and the copying of its commands
            row = _in_thread(lambda going_on, reading=reading: _row(reading, chosen, conditions, going_on), cancelled)
            reports.append(row)
            PATH_PRINTS.end((row.document, row.name), token, path_and_setting(row.fingerprint)[0])
    known = results.latest_rows(reports)
    wholes = [[known[key] for key in of_job if key in known] for of_job in posted]
    _in_thread(lambda going_on: _estimate_shown(reports, wholes, chosen.simulators, going_on), cancelled)
    for whole in wholes:
        reports = with_travel(reports, whole, chosen.travel)
    verdicts = {}
    for (key, job), names in zip(jobs.items(), posted):
        with suppress(ReferenceError):  # the job was deleted, or its document closed, during the analysis
            verdict = verdict_on(job, (known[name].fingerprint if name in known else "" for name in names))
            if verdict is not None:
                verdicts[key] = verdict
    return Report(tuple(reports), job_labels, chosen.budget, fixtures, verdicts=verdicts, simulator=chosen.simulator)


def _estimate_shown(
    rows: list[OperationReport], wholes: list[list[OperationReport]], simulators: tuple[str, ...], going_on: Callable
) -> None:
    """Compute the costs that will be shown, so that they are not computed when a window first shows them."""
    of_jobs = [
        together([o.costs for o in whole], labels=[o.label for o in whole], stepover=None)[0] for whole in wholes
    ]
    for costs in (*(row.costs for row in rows), *of_jobs):
        for simulator in simulators:
            going_on()
            costs.get(simulator)


def _in_thread(work: Callable, cancelled: Callable[[], bool] | None):
    """Run `work` in its own thread, and call `cancelled` repeatedly until it ends; without `cancelled`, in this thread.

    `work` gets one argument: a function that raises Cancelled after the work was cancelled.
    """
    given_up = threading.Event()

    def going_on() -> None:
        if given_up.is_set():
            raise Cancelled("the analysis was cancelled; nothing has been changed")

    if cancelled is None:
        return work(going_on)
    threads = ThreadPoolExecutor(1)
    garbage.hold()
    try:
        done = threads.submit(work, going_on)
        while not wait([done], _WAIT).done:
            garbage.collect()
            if cancelled():
                given_up.set()
                going_on()
        return done.result()
    finally:
        given_up.set()  # ends the thread's work also if `cancelled` raised an error
        garbage.release()
        threads.shutdown(wait=False)


def _row(reading: Reading, chosen: Preferences, conditions: Conditions, going_on: Callable) -> OperationReport:
    """Return the report's row for one operation. The row reports an unexpected error, so other rows are computed."""
    if reading.error is not None:
        return _failed(reading, reading.error)
    try:
        return _analysed_or_known(reading, chosen, conditions, going_on)
    except Cancelled:
        raise
    except Exception as error:
        FreeCAD.Console.PrintLog(traceback.format_exc())
        return _failed(reading, error)


def _analysed_or_known(
    reading: Reading, chosen: Preferences, conditions: Conditions, going_on: Callable
) -> OperationReport:
    commands = None if reading.path.Size <= AT_ONCE else reading.path.Commands
    text = text_of(reading.path, commands)
    going_on()
    key = key_of(text, *reading.placement.toMatrix().A, *(getattr(reading, name) for name in SETTINGS), chosen.tolerance,
                 chosen.planned_machine, conditions)  # fmt: skip
    known = RESULTS.find(key)
    if known is None:
        # A million commands take half a GB, so read them only if needed.
        words = Words(used_up(commands or reading.path.Commands))
        known = _analysed(reading, words, chosen, conditions, going_on)
        RESULTS.keep(key, known)
    row = replace(
        known,
        **{name: getattr(reading, name) for name in IDENTITY},
        fingerprint=fingerprint_of(text_fingerprint(text, reading.placement), reading.setting_fingerprint),
    )
    return with_faults(row, row.document, row.name)


def _analysed(
    reading: Reading, words: Words, chosen: Preferences, conditions: Conditions, going_on: Callable
) -> OperationReport:
    tool, stock = reading.tool, reading.stock
    remarks = list(reading.remarks)
    try:
        toolpath = placed(linearize(words, tolerance=chosen.tolerance), reading.placement)
        offset = WorkOffsets().remark(words, toolpath)
    except Unusable as error:
        return _unknown(reading, error.what)
    going_on()
    found, inches = recognize_operation(toolpath, tool and tool.diameter, reading.imported)
    if inches:
        remarks.append(Message("inches-as-millimetres"))
    cuts = found.strategy is not Strategy.EMPTY
    if not cuts:  # report why there are no cuts, instead of the remarks on tool and stock
        remarks = _why_empty(reading, toolpath)
    elif tool and not stock:
        remarks.append(Message("box-of-cuts"))
        stock = stock_around(toolpath, tool)
    remarks += [problem.remark for problem in toolpath.problems if not problem.of_time]
    remarks += [offset] if offset else []
    task = Task(toolpath, tool, stock, words, found)
    costs, advice = {}, {}
    if tool and stock and cuts:
        costs, advice = predict(task, conditions)
        remarks += _misfits(toolpath, tool, stock, costs, finished=reading.stock_is_model)
    going_on()
    if reading.imported:
        toolpath, minutes = in_seconds(toolpath)
        remarks += [minutes] if minutes else []
    horizontal, vertical = reading.rapid_feeds
    return OperationReport(
        **{name: getattr(reading, name) for name in IDENTITY},
        recognition=found,
        trajectories=len(toolpath),
        machining=machining(toolpath, horizontal_rapid=horizontal, vertical_rapid=vertical,
                            controller=reading.has_controller, top=reading.stock and reading.stock.upper[2],
                            machine=chosen.planned_machine),
        costs=costs,
        advice=advice,
        cautions=preflight(task, costs, conditions),
        remarks=tuple(remarks),
        fingerprint=fingerprint_of("", reading.setting_fingerprint),
        called=reading.intent if contradicts(reading.intent, found) else None,
        extent=extent_of(toolpath),
        setup=setup_of(reading.tool_name, chosen.planned_machine),
    )  # fmt: skip


def _why_empty(reading: Reading, toolpath: Toolpath) -> list[Message]:
    """Return why an operation does not cut; an empty list for stops, comments and fixtures, which never cut."""
    silent = toolpath.commands <= len(toolpath.comments)
    if not reading.takes_tool and toolpath.commands and not len(toolpath):
        return []
    if not silent:
        return [Message("no-cutting-move")]
    return [Message("no-toolpath") if reading.active else Message("inactive")]


def _misfits(
    toolpath: Toolpath, tool: Tool, stock: Solid, costs: Mapping[str, Cost], *, finished: bool
) -> list[Message]:
    """Return remarks if tool or stock do not fit the toolpath. `finished`: whether the stock equals the model."""
    too_wide = tool.diameter > max(stock.upper[0] - stock.lower[0], stock.upper[1] - stock.lower[1])
    at_it = cuts_surely(toolpath, stock) or (too_wide and may_cut(toolpath, tool, stock))
    # The number of traces in the z-buffer is read last, because reading this number computes an estimate.
    if not at_it and costs[ZBUFFER.name].traces == 0:
        return [Message("stock-is-model") if finished else Message("not-touching")]
    return [Message("tool-wider-than-stock")] if too_wide else []


def _failed(reading: Reading, error: Exception) -> OperationReport:
    """Return the report's row for an operation whose analysis failed."""
    return _unknown(reading, Message("not-analysed", error=f"{type(error).__name__}: {error}"))


def _unknown(reading: Reading, why: Message) -> OperationReport:
    """Return the report's row for an operation without results, with the reason."""
    fingerprint = fingerprint_of("", reading.setting_fingerprint)
    return without_results(why, fingerprint=fingerprint, **{name: getattr(reading, name) for name in IDENTITY})
