# SPDX-License-Identifier: LGPL-2.1-or-later
"""The progress and the remaining time that the command line prints."""

import io
import re

import pytest

from vkworkbench.program import progress


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.fixture
def clock(monkeypatch):
    """Replace the clock of the progress display, and return a list with its time, which the test changes."""
    now = [100.0]
    monkeypatch.setattr(progress.time, "monotonic", lambda: now[0])
    return now


@pytest.fixture
def paths(tmp_path):
    for name, size in (("a", 8000), ("b", 18_000), ("c", 18_000)):
        (tmp_path / name).write_bytes(b"x" * size)
    return [tmp_path / name for name in "abc"]


def test_progress_in_a_terminal_is_one_changing_line(clock, paths):
    stream = Terminal()
    told = progress.Progress(paths, stream)
    clock[0] += 10.0
    told.add(paths[0])  # 10 kB of 50 kB are done; the sizes include a constant for each file.
    clock[0] += 0.01
    told.add(paths[1])
    assert re.findall(r"\r\x1b\[K([^\r\n]*)", stream.getvalue()) == ["1 of 3 files, 40 s left"]
    clock[0] += 10.0
    told.add(paths[2])
    told.clear()
    assert stream.getvalue().endswith("3 of 3 files, 0 s left\r\x1b[K") and "\n" not in stream.getvalue()


def test_progress_in_a_file_is_a_line_at_intervals(clock, paths):
    stream = io.StringIO()
    told = progress.Progress(paths, stream)
    for path in paths:
        clock[0] += 20.0
        told.add(path)
    told.clear()
    assert stream.getvalue() == "2 of 3 files, 27 s left\n"
    assert told.files == 3


def test_missing_file_counts_as_done(clock, tmp_path):
    told = progress.Progress([tmp_path / "gone"], io.StringIO())
    clock[0] += 60.0
    told.add(tmp_path / "gone")
    assert told.files == 1
