# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long analyses: the same numbers with and without a thread, and a cancel that leaves everything as it was."""

import concurrent.futures
import threading

import FreeCAD
import Path
import pytest

import vkworkbench
from vkworkbench.document.job import fingerprint
from vkworkbench.document.job.fingerprint import path_fingerprint, text_fingerprint, text_of


def test_one_by_one_or_at_once_is_the_same_fingerprint(example, monkeypatch):
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


def test_a_thread_finds_the_same(example):
    alone = vkworkbench.analyze(example)
    assert vkworkbench.analyze(example, cancelled=lambda: False) == alone


def test_a_thread_that_takes_long_is_waited_for_by_any_python(small, zigzag_commands, monkeypatch):
    """Before Python 3.11 concurrent.futures has its own TimeoutError."""
    from vkworkbench.document import analysis

    small.add("Zigzag", zigzag_commands)
    monkeypatch.setattr(concurrent.futures._base, "TimeoutError", type("TimeoutError", (Exception,), {}))
    asked, recognized = threading.Event(), analysis.recognize_operation
    monkeypatch.setattr(analysis, "recognize_operation", lambda *what: asked.wait() and recognized(*what))
    (row,) = vkworkbench.analyze(small.document, cancelled=asked.set).operations
    assert row.strategy == "zigzag" and row.error is None


def test_a_failure_in_the_thread_is_the_callers(example, monkeypatch):
    from vkworkbench.document import analysis

    def fail(*what, **more):
        raise RuntimeError("of the thread")

    monkeypatch.setattr(analysis, "_row", fail)
    with pytest.raises(RuntimeError, match="of the thread"):
        vkworkbench.analyze(example, cancelled=lambda: False)
