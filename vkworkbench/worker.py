# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in processes of their own: Python runs one thread at a time, and a process that crashes costs its own work only."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import numpy as np

# This package's folder, and that of the numpy that is used here.
_FOLDERS = [str(Path(__file__).resolve().parents[1]), str(Path(np.__file__).resolve().parents[1])]
# Windows would open a console for each.
_NO_WINDOW: int = getattr(subprocess, "CREATE_NO_WINDOW", 0)


class WorkerDied(Exception):
    """A process could not be started, is of another Python or numpy, has died, or was ended."""


class Worker:
    """A process that does one kind of work for one argument after the other.

    It ends when this process does.

    Parameters
    ----------
    work : callable
        What it does with an argument. Work, arguments and results must be picklable.

    Raises
    ------
    WorkerDied
        Where there is no Python to start it with.
    """

    def __init__(self, work: Callable[[Any], Any]) -> None:
        python = interpreter()
        if python is None:
            raise WorkerDied
        path = os.pathsep.join([*_FOLDERS, *filter(None, [os.environ.get("PYTHONPATH")])])
        code = "from vkworkbench.worker import serve; serve()"
        try:
            self._process = subprocess.Popen(
                [python, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                env={**os.environ, "PYTHONPATH": path}, creationflags=_NO_WINDOW,
            )  # fmt: skip
        except OSError:
            raise WorkerDied from None
        self._work = work
        self._ready = False

    @property
    def lives(self) -> bool:
        """Whether the process can be asked."""
        return self._process.poll() is None

    def get_ready(self) -> None:
        """Wait until the process has started and knows its work.

        Raises
        ------
        WorkerDied
        """
        if self._ready:
            return
        if self._answer() != _versions():
            self.end()
            raise WorkerDied
        self._say(self._work)
        self._ready = True

    def __call__(self, argument: Any) -> Any:
        """Have it do its work, and wait for the result.

        Raises
        ------
        WorkerDied
        """
        self.get_ready()
        self._say(argument)
        return self._answer()

    def kill(self) -> None:
        """Make the process die: who waits for a result is told so. Any thread may do it."""
        self._process.kill()

    def end(self) -> None:
        """Make the process die, and wait until it has."""
        self._process.kill()
        self._process.wait()
        for pipe in (self._process.stdin, self._process.stdout):
            with suppress(OSError), _broken_pipes_are_errors():  # what was not said yet is, when it is closed
                pipe.close()  # type: ignore[union-attr] # both are pipes

    def _say(self, what: Any) -> None:
        try:
            with _broken_pipes_are_errors():
                pickle.dump(what, self._process.stdin, pickle.HIGHEST_PROTOCOL)  # type: ignore[arg-type]
                self._process.stdin.flush()  # type: ignore[union-attr]
        except (OSError, ValueError):  # the other end, or this one, is closed
            self.end()
            raise WorkerDied from None

    def _answer(self) -> Any:
        try:
            return pickle.load(self._process.stdout)  # type: ignore[arg-type] # of this package's own process
        # No answer, or none that this process can hold.
        except (EOFError, OSError, ValueError, MemoryError, pickle.UnpicklingError):
            self.end()
            raise WorkerDied from None


def serve() -> None:
    """Be the other process: take the work from the standard input, then arguments until it ends, and answer each."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the parent process, which then ends the input
    answers = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(2, 1)  # no other output may come between the answers

    def say(answer: Any) -> None:
        pickle.dump(answer, answers, pickle.HIGHEST_PROTOCOL)
        answers.flush()

    with suppress(EOFError, BrokenPipeError):
        say(_versions())
        work = pickle.load(sys.stdin.buffer)
        while True:
            say(work(pickle.load(sys.stdin.buffer)))


def interpreter() -> str | None:
    """Return the Python that runs what this process runs; FreeCAD, which is not one itself, has it beside it.

    Returns
    -------
    str or None
        Path of the program; None where there is none.
    """
    own = Path(sys.executable or "")
    if own.stem.startswith("python"):
        return str(own)
    names = [f"python{sys.version_info.major}.{sys.version_info.minor}", "python3", "python", "python.exe"]
    for folder in (Path(sys.prefix, "bin"), Path(sys.prefix), own.parent):
        for name in names:
            if (folder / name).is_file():
                return str(folder / name)
    return None


def processes() -> int:
    """Return how many processes can work at once: one for each core that this one may use, where others can be started."""
    if interpreter() is None:
        return 1
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


@contextmanager
def _broken_pipes_are_errors() -> Iterator[None]:
    """Let no signal end this process when it writes to one that has died: Python ignores it, FreeCAD 1.0 does not."""
    if not hasattr(signal, "pthread_sigmask"):  # on Windows there is none
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGPIPE])
    try:
        yield
    finally:
        if signal.SIGPIPE not in before and signal.SIGPIPE in signal.sigpending():
            signal.sigwait([signal.SIGPIPE])
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _versions() -> tuple[tuple[int, ...], str]:
    """Return what must be the same for results to be so: Python and numpy."""
    return tuple(sys.version_info[:3]), np.__version__
