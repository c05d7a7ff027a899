# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long analyses return the same results with and without a thread."""

import concurrent.futures
import threading

import FreeCAD
import Path
import pytest

import vkworkbench
from vkworkbench.document.job import fingerprint
from vkworkbench.document.job.fingerprint import path_fingerprint, text_fingerprint, text_of


def test_fingerprint_in_batches_equals_fingerprint_at_once(example, monkeypatch):
    def one_by_one(obj):
        with monkeypatch.context() as long:
            long.setattr(fingerprint, "AT_ONCE", 0)
            return text_fingerprint(text_of(obj.Path), obj.Placement)

    for obj in example.Objects:
        if obj.isDerivedFrom("Path::Feature"):
            assert one_by_one(obj) == path_fingerprint(obj), obj.Label
    bare = example.addObject("Path::Feature", "Bare")
    bare.Path = Path.Path("(first)\nG0 X-0.0000001 Y0\nG1 X1 F5\n(G1 X2)\nM5")
    assert one_by_one(bare) == path_fingerprint(bare)
    bare.Placement.Base = FreeCAD.Vector(1, 0, 0)
    assert one_by_one(bare) == path_fingerprint(bare)


def test_analysis_in_a_thread_gives_the_same_report(example):
    alone = vkworkbench.analyze(example)
    assert vkworkbench.analyze(example, cancelled=lambda: False) == alone


def test_slow_thread_is_awaited_in_all_python_versions(small, zigzag_commands, monkeypatch):
    """Before Python 3.11, the TimeoutError of concurrent.futures is not Python's TimeoutError."""
    from vkworkbench.document import analysis

    small.add("Zigzag", zigzag_commands)
    monkeypatch.setattr(concurrent.futures._base, "TimeoutError", type("TimeoutError", (Exception,), {}))
    asked, recognized = threading.Event(), analysis.recognize_operation
    monkeypatch.setattr(analysis, "recognize_operation", lambda *what: asked.wait() and recognized(*what))
    (row,) = vkworkbench.analyze(small.document, cancelled=asked.set).operations
    assert row.strategy == "zigzag" and row.error is None


def test_error_in_the_thread_is_raised_in_the_caller(example, monkeypatch):
    from vkworkbench.document import analysis

    def fail(*what, **more):
        raise RuntimeError("of the thread")

    monkeypatch.setattr(analysis, "_row", fail)
    with pytest.raises(RuntimeError, match="of the thread"):
        vkworkbench.analyze(example, cancelled=lambda: False)
