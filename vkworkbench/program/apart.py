# SPDX-License-Identifier: LGPL-2.1-or-later
"""One program analysed in a process of its own: one that crashes or never ends costs its own file only."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sys
import threading
import time
import weakref
from contextlib import suppress
from pathlib import Path

from vkworkbench.language import Message
from vkworkbench.preferences import Preferences
from vkworkbench.program.analysis import analyze_file, unread
from vkworkbench.report import OperationReport

_HOME = str(Path(__file__).resolve().parents[2])
_of_thread = threading.local()
_workers: weakref.WeakSet[_Worker] = weakref.WeakSet()


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
    worker = getattr(_of_thread, "worker", None)
    if worker is None or not worker.lives:
        worker = _of_thread.worker = _Worker()
    return worker.analyze(path, chosen, patience)


def end_workers() -> None:
    """End the processes of all threads; what they work on is lost."""
    for worker in list(_workers):
        worker.end()


class _Worker:
    """A process that analyses one program after the other."""

    def __init__(self) -> None:
        path = os.pathsep.join(filter(None, [_HOME, os.environ.get("PYTHONPATH")]))
        code = "from vkworkbench.program.apart import serve; serve()"
        self._process = subprocess.Popen(
            [sys.executable, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
            env={**os.environ, "PYTHONPATH": path},
        )  # fmt: skip
        self._started = False
        _workers.add(self)

    @property
    def lives(self) -> bool:
        return self._process.poll() is None

    def analyze(self, path: Path, chosen: Preferences, patience: float) -> tuple[OperationReport, ...]:
        timer = threading.Timer(patience, self._process.kill)
        begin = float("inf")
        try:
            if not self._started:
                self._started = pickle.load(self._process.stdout)
            begin = time.monotonic()
            timer.start()
            pickle.dump((path, chosen), self._process.stdin)
            self._process.stdin.flush()
            return pickle.load(self._process.stdout)
        except (EOFError, OSError, pickle.UnpicklingError):
            self.end()
            late = time.monotonic() - begin >= patience
            return (unread(path, Message("too-long", time=patience) if late else Message("worker-died")),)
        finally:
            timer.cancel()

    def end(self) -> None:
        self._process.kill()
        self._process.wait()
        for pipe in (self._process.stdin, self._process.stdout):
            with suppress(OSError):
                pipe.close()


def serve() -> None:
    """Analyse the programs that come on the standard input, until it ends; the rows go to the standard output."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the parent process, which then ends the input
    answers = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(2, 1)  # no other output may come between the answers
    pickle.dump(True, answers)  # ready: the first program's time does not include the start
    answers.flush()
    while True:
        try:
            path, chosen = pickle.load(sys.stdin.buffer)
        except EOFError:
            return
        pickle.dump(analyze_file(path, chosen), answers)
        answers.flush()
