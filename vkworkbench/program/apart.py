# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analyse each NC program in a separate process, so that a crash or an endless analysis affects only one file."""

from __future__ import annotations

import threading
import time
import weakref
from pathlib import Path

from vkworkbench.language import Message
from vkworkbench.preferences import Preferences
from vkworkbench.program.analysis import analyze_file, unread
from vkworkbench.report import OperationReport
from vkworkbench.worker import Worker, WorkerDied

# Memory limit for the analysis of one program, bytes. Even the analysis of the largest accepted toolpath, with 5
# million moves, needs less memory than this limit.
_MOST_MEMORY = 4e9
_of_thread = threading.local()
_workers: weakref.WeakSet[Worker] = weakref.WeakSet()


def analyze_apart(path: Path, chosen: Preferences, patience: float) -> tuple[OperationReport, ...]:
    """Analyse one NC program as `analyze_file` does, in a separate process.

    Each thread uses one process for all its programs. `patience` is the time limit of the analysis, s, without the
    start of the process. If the process died or exceeded the time limit, the result is one row whose remark states the
    reason.
    """
    begin = float("inf")
    try:
        worker = _worker()
        timer = threading.Timer(min(patience, threading.TIMEOUT_MAX), worker.kill)
        begin = time.monotonic()
        timer.start()
        try:
            rows: tuple[OperationReport, ...] = worker((path, chosen))
        finally:
            timer.cancel()
    except WorkerDied:
        late = time.monotonic() - begin >= patience
        return (unread(path, Message("too-long", time=patience) if late else Message("worker-died")),)
    if any(remark.code == "memory-short" for row in rows for remark in row.remarks):
        worker.end()  # a large program used up the memory: a new process begins with free memory
    return rows


def end_workers() -> None:
    """End the processes of all threads. The results of unfinished analyses are lost."""
    for worker in list(_workers):
        worker.end()


def _worker() -> Worker:
    """Return this thread's process, ready for work. A process that died is replaced by a new one."""
    worker = getattr(_of_thread, "worker", None)
    if worker is None or not worker.lives:
        worker = _of_thread.worker = Worker(_analyze, _MOST_MEMORY)
        _workers.add(worker)
        worker.get_ready()
    return worker


def _analyze(asked: tuple[Path, Preferences]) -> tuple[OperationReport, ...]:
    return analyze_file(*asked)
