# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run functions in separate processes, because of Python's GIL, and because a crash then ends only one process."""

from __future__ import annotations

import ctypes
import os
import pickle
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from queue import SimpleQueue
from typing import Any

import numpy as np

# The worker process imports only the standard library, this package and numpy. The worker process imports nothing from
# the current folder, PYTHONPATH, the user's site-packages, .pth files or sitecustomize. The folders of this package and
# of numpy are at the end of sys.path, so that their files replace no module of the standard library.
_ISOLATED = ["-I", "-S"]
_START = "import sys; sys.path += sys.argv[1:]; from vkworkbench.worker import serve; serve()"
_FOLDERS = [str(Path(__file__).resolve().parents[1]), str(Path(np.__file__).resolve().parents[1])]
_PR_SET_PDEATHSIG = 1  # Linux's option for the signal that a process gets when its parent ends (prctl.h).
# Number of rows of a matrix that is large enough for OpenBLAS to reserve its memory when the matrix is multiplied.
_OF_BLAS = 128
# Flag for new processes, without which Windows opens a console window for each process.
_NO_WINDOW: int = getattr(subprocess, "CREATE_NO_WINDOW", 0)


class WorkerDied(Exception):
    """A worker process could not be started, has another version of Python or numpy, has died, or was killed."""


class Worker:
    """A worker process, which calls one function with one argument after the other.

    The function `work`, its arguments and its results must be picklable. If the function needs more memory than
    `most_memory` bytes, a `MemoryError` is raised in the function; this limit is effective only on Linux. The worker
    process ends when the process that started it ends or is killed, even during a call of the function. The worker
    process also ends when the thread that has started it ends (on Linux only). `WorkerDied` is raised if no Python
    interpreter was found for the worker process.
    """

    def __init__(self, work: Callable[[Any], Any], most_memory: float | None = None) -> None:
        python = interpreter()
        if python is None:
            raise WorkerDied
        try:
            self._process = subprocess.Popen(
                # `cwd` is not the user's current folder, because Windows loads libraries from the current folder.
                [python, *_ISOLATED, "-c", _START, *_FOLDERS], cwd=_FOLDERS[0],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, creationflags=_NO_WINDOW,
            )  # fmt: skip
        except OSError:
            raise WorkerDied from None
        self._work, self._most_memory = work, most_memory
        self._ready = False

    @property
    def lives(self) -> bool:
        """Whether the worker process is running."""
        return self._process.poll() is None

    def get_ready(self) -> None:
        """Wait until the worker process has started, and send the function to it.

        `WorkerDied` is raised if the process has died.
        """
        if self._ready:
            return
        if self._answer() != _versions():
            self.end()
            raise WorkerDied
        self._say((self._most_memory, self._work))
        self._ready = True

    def __call__(self, argument: Any) -> Any:
        """Call the function with an argument in the worker process, and wait for the result.

        `WorkerDied` is raised if the process has died.
        """
        self.get_ready()
        self._say(argument)
        return self._answer()

    def kill(self) -> None:
        """Kill the worker process. A waiting `__call__` then raises `WorkerDied`. Any thread may call this method."""
        with suppress(ProcessLookupError):  # Python before 3.9 raises this error if the worker process has just ended
            self._process.kill()

    def end(self) -> None:
        """Kill the worker process, and wait until it has ended."""
        self.kill()
        self._process.wait()
        for pipe in (self._process.stdin, self._process.stdout):
            # Closing writes a buffered message, which fails if the process has ended.
            with suppress(OSError), _broken_pipes_are_errors():
                pipe.close()  # type: ignore[union-attr] # both are pipes

    def _say(self, what: Any) -> None:
        try:
            with _broken_pipes_are_errors():
                pickle.dump(what, self._process.stdin, pickle.HIGHEST_PROTOCOL)  # type: ignore[arg-type]
                self._process.stdin.flush()  # type: ignore[union-attr]
        except (OSError, ValueError):  # This process or the worker process has closed the pipe.
            self.end()
            raise WorkerDied from None

    def _answer(self) -> Any:
        try:
            return pickle.load(self._process.stdout)  # type: ignore[arg-type] # of this package's own process
        # The worker process sent no answer, or too little memory is free for the answer.
        except (EOFError, OSError, ValueError, MemoryError, pickle.UnpicklingError):
            self.end()
            raise WorkerDied from None


def serve() -> None:
    """Run in the worker process: read the function from the standard input, then read and answer the arguments."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # The parent process handles Ctrl-C, and then closes the input.
    with suppress(OSError, AttributeError, TypeError):  # The function prctl exists only on Linux.
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    answers = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(2, 1)  # redirect everything that `work` prints, because it must not mix with the answers of this process
    received: SimpleQueue[Any] = SimpleQueue()
    threading.Thread(target=_receive, args=(received,), daemon=True).start()

    def say(answer: Any) -> None:
        pickle.dump(answer, answers, pickle.HIGHEST_PROTOCOL)
        answers.flush()

    with suppress(BrokenPipeError):
        say(_versions())
        most_memory, work = received.get()  # receiving `work` imports its modules, before their memory is limited
        _limit_memory(most_memory)
        while True:
            say(work(received.get()))


def _receive(received: SimpleQueue[Any]) -> None:
    """Read the standard input. When the input ends, the parent process has ended: end this process, even at work."""
    try:
        while True:
            received.put(pickle.load(sys.stdin.buffer))
    finally:
        os._exit(0)


def _limit_memory(most: float | None) -> None:
    """Limit the memory that this process allocates from now on to `most` bytes."""
    if most is not None and sys.platform == "linux":
        import resource  # the module `resource` does not exist on Windows

        # OpenBLAS allocates up to 128 MB at its first matrix product, and tries forever if the limit does not allow it.
        np.ones((_OF_BLAS, _OF_BLAS)) @ np.ones((_OF_BLAS, _OF_BLAS))
        # Memory pages of data and stack, without addresses that are only reserved.
        pages = int(Path("/proc/self/statm").read_text().split()[5])
        limit = pages * resource.getpagesize() + int(most)
        with suppress(ValueError, OSError):  # a lower limit that the user has set stays
            resource.setrlimit(resource.RLIMIT_DATA, (limit, limit))


def interpreter() -> str | None:
    """Return the path of the Python interpreter for new processes, or None if none was found.

    FreeCAD is not an interpreter, but its folders contain one.
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
    """Return the number of processes for parallel work: the number of usable cores, or 1 if none can be started."""
    if interpreter() is None:
        return 1
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


@contextmanager
def _broken_pipes_are_errors() -> Iterator[None]:
    """Block SIGPIPE, the signal for writing to a dead process, which would end FreeCAD 1.0.

    Python alone ignores SIGPIPE.
    """
    if not hasattr(signal, "pthread_sigmask"):  # Windows has no SIGPIPE
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
    """Return the versions of Python and numpy, which must be equal in both processes to give equal results."""
    return tuple(sys.version_info[:3]), np.__version__
