# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in other processes: results, processes that died, and the choice of the Python interpreter."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from traps import environment_of_traps, lay_traps

from vkworkbench import worker
from vkworkbench.worker import Worker, WorkerDied

ROOT = Path(__file__).parents[2]


def test_worker_returns_the_result_of_each_argument():
    one = Worker(len)
    one.get_ready()
    assert [one("abc"), one([1]), one(())] == [3, 1, 0] and one.lives
    one.end()
    one.end()
    assert not one.lives
    with pytest.raises(WorkerDied):
        one("abc")


def test_worker_dies_if_its_work_raises_an_error():
    one = Worker(len)
    with pytest.raises(WorkerDied):
        one(3)
    assert not one.lives


@pytest.mark.skipif(not hasattr(signal, "SIGPIPE"), reason="Windows has no such signal")
def test_dead_worker_sends_no_signal_to_its_caller():
    """The signal SIGPIPE would end FreeCAD 1.0."""
    got = []
    before = signal.signal(signal.SIGPIPE, lambda *_: got.append(1))
    try:
        one = Worker(len)
        one.get_ready()
        one.kill()
        one._process.wait()
        with pytest.raises(WorkerDied):
            one("abc")
    finally:
        signal.signal(signal.SIGPIPE, before)
    assert not got


def test_printed_output_of_work_does_not_disturb_answers():
    one = Worker(print)
    assert one("something") is None and one("else") is None
    one.end()


def test_worker_finds_the_add_on_from_any_folder(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("PYTHONPATH", raising=False)
    one = Worker(len)
    assert one("abc") == 3
    one.end()


def test_worker_runs_no_files_of_a_hostile_folder(monkeypatch, tmp_path):
    ran = lay_traps(tmp_path / "traps")
    for name, value in environment_of_traps(tmp_path / "traps").items():
        monkeypatch.setenv(name, value)
    monkeypatch.chdir(tmp_path / "traps")
    one = Worker(len)
    assert one("abc") == 3 and ran() == []
    one.end()


@pytest.mark.skipif(sys.platform != "linux", reason="other systems do not limit the memory of a process")
def test_memory_of_a_worker_is_limited():
    one = Worker(bytes, 1e8)
    assert len(one(10_000_000)) == 10_000_000
    with pytest.raises(WorkerDied):
        one(110_000_000)
    free = Worker(bytes)
    assert len(free(110_000_000)) == 110_000_000
    free.end()


@pytest.mark.skipif(sys.platform != "linux", reason="other systems do not limit the memory of a process")
def test_memory_limit_does_not_block_matrix_products():
    """OpenBLAS would try forever to allocate its memory.

    The timer ends a process that tries forever, and the test fails.
    """
    one = Worker(np.linalg.inv, 2e7)
    timer = threading.Timer(60, one.kill)
    timer.start()
    try:
        assert np.allclose(one(2 * np.eye(300)), 0.5 * np.eye(300))
    finally:
        timer.cancel()
        one.end()


def _ends(pid):
    """Return whether a process ends within a minute. A zombie process has ended, too."""
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline:
        try:
            state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
        except OSError:
            return True
        if state == "Z":
            return True
        time.sleep(0.02)
    return False


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the state of a process is read from /proc")
@pytest.mark.parametrize("work", ["time.sleep, 10000", "max, range(10**13)"])
def test_worker_ends_when_its_parent_is_killed(work):
    """The worker also ends in the middle of its work, and if the work holds the GIL."""
    code = (
        "import threading, time; from vkworkbench.worker import Worker\n"
        "def have_done(work, argument):\n"
        "    one = Worker(work); one.get_ready(); print(one._process.pid, flush=True); one(argument)\n"
        f"have_done({work})"
    )
    with subprocess.Popen([sys.executable, "-c", code], cwd=ROOT, stdout=subprocess.PIPE, text=True) as parent:
        pid = int(parent.stdout.readline())
        time.sleep(0.2)
        assert Path(f"/proc/{pid}").exists()
        parent.kill()
    try:
        assert _ends(pid)
    except AssertionError:
        os.kill(pid, signal.SIGKILL)
        raise


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the state of a process is read from /proc")
def test_worker_ends_during_its_work_if_its_input_ends():
    """Systems that send no signal when the parent process dies need a worker that ends with its input."""
    one = Worker(time.sleep)
    one.get_ready()
    one._say(10_000)
    one._process.stdin.close()
    try:
        assert _ends(one._process.pid)
    finally:
        one._process.kill()
        one._process.wait()
        one._process.stdout.close()


@pytest.mark.skipif(os.name != "posix", reason="a shell's script stands for the other Python")
def test_worker_uses_the_numpy_of_its_parent(monkeypatch, tmp_path):
    """The Python interpreter that FreeCAD starts for a worker may not find FreeCAD's own numpy."""
    bare = tmp_path / "python"
    bare.write_text(f'#!/bin/sh\nexec "{sys.executable}" -S "$@"\n')
    bare.chmod(0o755)
    monkeypatch.setattr(worker, "interpreter", lambda: str(bare))
    one = Worker(len)
    assert one("abc") == 3
    one.end()


def test_processes_equal_available_cores(monkeypatch):
    mine = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(mine)})
    try:
        assert worker.processes() == 1
    finally:
        os.sched_setaffinity(0, mine)
    monkeypatch.delattr(os, "sched_getaffinity")  # Windows and macOS do not have sched_getaffinity.
    assert worker.processes() == os.cpu_count()


def test_python_is_found_beside_freecad_or_in_its_prefix(monkeypatch, tmp_path):
    """In FreeCAD, sys.executable is FreeCAD itself.

    FreeCAD's Python interpreter is beside FreeCAD or in a folder of sys.prefix.
    """
    assert worker.interpreter() == sys.executable
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    for executable in (str(tmp_path / "apart" / "FreeCAD"), "", None):
        monkeypatch.setattr(sys, "executable", executable)
        monkeypatch.setattr(sys, "prefix", str(tmp_path / "usr"))
        assert worker.interpreter() is None and worker.processes() == 1
    (tmp_path / "usr" / "bin" / "python3").mkdir(parents=True)  # A folder named python3 is not a Python interpreter.
    (tmp_path / "apart").mkdir()
    monkeypatch.setattr(sys, "executable", str(tmp_path / "apart" / "FreeCAD"))
    for place in (
        Path("apart", "python.exe"),
        Path("apart", version),
        Path("usr", "python.exe"),
        Path("usr/bin", version),
    ):
        (tmp_path / place).touch()
        assert worker.interpreter() == str(tmp_path / place)
    assert worker.processes() >= 1
