# SPDX-License-Identifier: LGPL-2.1-or-later
"""One program analysed in a process of its own: one that crashes or never ends costs its own file only."""

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

_of_thread = threading.local()
_workers: weakref.WeakSet[Worker] = weakref.WeakSet()


def analyze_apart(path: Path, chosen: Preferences, patience: float) -> tuple[OperationReport, ...]:
    """Analyse one program in another process, as `analyze_file`; each thread keeps its process for the next.

    Parameters
    ----------
    path : Path
    chosen : Preferences
    patience : float
        Time for the analysis, s, after which it is given up; starting a process is not counted.

    Returns
    -------
    tuple of OperationReport
        Where the process died or was given up, one row that says so.
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
    return rows


def end_workers() -> None:
    """End the processes of all threads; what they work on is lost."""
    for worker in list(_workers):
        worker.end()


def _worker() -> Worker:
    """Return this thread's process, ready, a new one where it died."""
    worker = getattr(_of_thread, "worker", None)
    if worker is None or not worker.lives:
        worker = _of_thread.worker = Worker(_analyze)
        _workers.add(worker)
        worker.get_ready()
    return worker


def _analyze(asked: tuple[Path, Preferences]) -> tuple[OperationReport, ...]:
    return analyze_file(*asked)
