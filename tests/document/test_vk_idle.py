# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work that may wait: at once without a window, in a window a moment of it and the rest when FreeCAD is idle."""

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
        """Call the waiting functions; functions added meanwhile wait for the next call."""
        for _ in range(len(self.waiting)):
            self.waiting.pop(0)()

    def steps(self, name, count, *, seconds=0.02, error=None):
        """Return work in `count` steps, which may end in an error."""
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
    assert window.done == ["a0", "a1"] and len(window.waiting) == 1  # 20 ms each
    window.idle()
    assert window.done == ["a0", "a1", "a2", "a3"]
    window.idle()
    assert window.done[-1] == "a4"
    window.idle()
    assert window.waiting == []


def test_one_work_comes_after_the_other(window):
    idle.work(window.steps("a", 3))
    idle.work(window.steps("b", 2))
    assert window.done == ["a0", "a1"]
    while window.waiting:
        assert len(window.waiting) == 1
        window.idle()
    assert window.done == ["a0", "a1", "a2", "b0", "b1"]


@pytest.mark.parametrize("error", [ReferenceError("gone"), ValueError("a bug")])
def test_a_work_that_fails_ends_no_other(window, error):
    idle.work(window.steps("a", 3, error=error))
    idle.work(window.steps("b", 3))
    while window.waiting:
        with suppress(ValueError):  # a closed document is not an error
            window.idle()
    assert window.done == ["a0", "a1", "a2", "b0", "b1", "b2"]


def test_calls_of_one_name_are_one_call_of_the_last(window):
    for name, value in (("one", 1), ("other", 2), ("one", 3)):
        idle.later(name, lambda value=value: window.done.append(value))
    assert window.done == []
    window.idle()
    assert window.done == [3, 2] and window.waiting == []
    idle.later("one", lambda: window.done.append(4))
    window.idle()
    assert window.done == [3, 2, 4]


def test_without_a_window_all_is_done_at_once_and_nothing_later():
    window = Window()
    idle.later("one", lambda: window.done.append("later"))
    idle.work(window.steps("a", 3, seconds=60.0))
    assert window.done == ["a0", "a1", "a2"]


@pytest.mark.parametrize("error", [None, ValueError("a bug")])
def test_nested_work_runs_afterwards_without_a_window(error):
    window = Window()

    def asking():
        idle.work(window.steps("inner ", 2))
        yield from window.steps("outer ", 2, error=error)

    with pytest.raises(ValueError, match="a bug") if error else nullcontext():
        idle.work(asking())
    assert window.done == ["outer 0", "outer 1", "inner 0", "inner 1"]
