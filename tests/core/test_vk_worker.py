# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in other processes: results, processes that died, and the choice of the Python."""

from __future__ import annotations

import os
import signal
import sys
from pathlib import Path

import pytest

from vkworkbench import worker
from vkworkbench.worker import Worker, WorkerDied


def test_a_worker_works_for_one_argument_after_the_other():
    one = Worker(len)
    one.get_ready()
    assert [one("abc"), one([1]), one(())] == [3, 1, 0] and one.lives
    one.end()
    one.end()
    assert not one.lives
    with pytest.raises(WorkerDied):
        one("abc")


def test_a_worker_whose_work_fails_dies():
    one = Worker(len)
    with pytest.raises(WorkerDied):
        one(3)
    assert not one.lives


@pytest.mark.skipif(not hasattr(signal, "SIGPIPE"), reason="Windows has no such signal")
def test_dead_worker_sends_no_signal_to_its_caller():
    """FreeCAD 1.0 would end by it."""
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


def test_a_worker_finds_the_add_on_from_any_folder(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("PYTHONPATH", raising=False)
    one = Worker(len)
    assert one("abc") == 3
    one.end()


@pytest.mark.skipif(os.name != "posix", reason="a shell's script stands for the other Python")
def test_a_worker_finds_the_numpy_that_is_used_here(monkeypatch, tmp_path):
    """As in a FreeCAD that brings its own: to its Python alone it may be unknown."""
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
    monkeypatch.delattr(os, "sched_getaffinity")  # as on Windows and macOS
    assert worker.processes() == os.cpu_count()


def test_the_python_of_a_program_that_is_not_python(monkeypatch, tmp_path):
    """In FreeCAD, sys.executable is FreeCAD itself. Its Python lies beside FreeCAD or in the folders of sys.prefix."""
    assert worker.interpreter() == sys.executable
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    for executable in (str(tmp_path / "apart" / "FreeCAD"), "", None):
        monkeypatch.setattr(sys, "executable", executable)
        monkeypatch.setattr(sys, "prefix", str(tmp_path / "usr"))
        assert worker.interpreter() is None and worker.processes() == 1
    (tmp_path / "usr" / "bin" / "python3").mkdir(parents=True)  # a folder is not a program
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
