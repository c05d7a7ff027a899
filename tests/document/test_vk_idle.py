# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Work in the background, done in steps.

Without a window, `idle.work` does all steps at once. In a window it works for a short time, and continues when FreeCAD
is idle.
"""

from __future__ import annotations

from contextlib import nullcontext, suppress
from types import SimpleNamespace

import pytest

from vkworkbench.document.computer import idle


class Window:
    """An event loop that tests run by hand, and a clock that only work advances."""

    def __init__(self):
        self.waiting, self.now, self.done = [], 0.0, []

    def idle(self):
        """Call the waiting functions; functions that they add wait for the next call of `idle`."""
        for _ in range(len(self.waiting)):
            self.waiting.pop(0)()

    def steps(self, name, count, *, seconds=0.02, error=None):
        """Yield `count` times, `seconds` apart, and raise `error` at the end if one is given."""
        for step in range(count):
            self.done.append(f"{name}{step}")
            self.now += seconds
            yield
        if error is not None:
            raise error


@pytest.fixture
def window(monkeypatch):
    """Use a fake window during the test."""
    window = Window()
    monkeypatch.setattr(idle, "time", SimpleNamespace(monotonic=lambda: window.now))
    monkeypatch.setattr(idle, "_soon", None)
    idle.use(window.waiting.append)
    return window


def test_long_work_continues_when_idle(window):
    idle.work(window.steps("a", 5))
    # A slice of 30 ms ends after the second step of 20 ms.
    assert window.done == ["a0", "a1"] and len(window.waiting) == 1
    window.idle()
    assert window.done == ["a0", "a1", "a2", "a3"]
    window.idle()
    assert window.done[-1] == "a4"
    window.idle()
    assert window.waiting == []


def test_second_work_starts_after_the_first_ends(window):
    idle.work(window.steps("a", 3))
    idle.work(window.steps("b", 2))
    assert window.done == ["a0", "a1"]
    while window.waiting:
        assert len(window.waiting) == 1
        window.idle()
    assert window.done == ["a0", "a1", "a2", "b0", "b1"]


@pytest.mark.parametrize("error", [ReferenceError("gone"), ValueError("a bug")])
def test_failed_work_does_not_stop_other_work(window, error):
    idle.work(window.steps("a", 3, error=error))
    idle.work(window.steps("b", 3))
    while window.waiting:
        with suppress(ValueError):  # raised by one iterator; `idle` drops iterators that raise a ReferenceError
            window.idle()
    assert window.done == ["a0", "a1", "a2", "b0", "b1", "b2"]


def test_only_the_last_call_with_the_same_name_is_made(window):
    for name, value in (("one", 1), ("other", 2), ("one", 3)):
        idle.later(name, lambda value=value: window.done.append(value))
    assert window.done == []
    window.idle()
    assert window.done == [3, 2] and window.waiting == []
    idle.later("one", lambda: window.done.append(4))
    window.idle()
    assert window.done == [3, 2, 4]


def test_work_without_a_window_is_done_at_once():
    window = Window()
    idle.later("one", lambda: window.done.append("later"))
    idle.work(window.steps("a", 3, seconds=60.0))
    assert window.done == ["a0", "a1", "a2"]


@pytest.mark.parametrize("error", [None, ValueError("a bug")])
def test_nested_work_runs_after_outer_work_without_a_window(error):
    window = Window()

    def asking():
        idle.work(window.steps("inner ", 2))
        yield from window.steps("outer ", 2, error=error)

    with pytest.raises(ValueError, match="a bug") if error else nullcontext():
        idle.work(asking())
    assert window.done == ["outer 0", "outer 1", "inner 0", "inner 1"]
