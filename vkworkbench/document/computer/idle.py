# SPDX-License-Identifier: LGPL-2.1-or-later
"""Do work while FreeCAD is idle: in short slices with a window, at once without a window."""

from __future__ import annotations

import math
import time
from collections import deque
from collections.abc import Callable, Iterator

_SLICE = 0.03  # seconds of work before Qt handles other events

_soon: Callable[[Callable[[], None]], None] | None = None
_works: deque[Iterator] = deque()
_calls: dict[str, Callable[[], None]] = {}


def use(soon: Callable[[Callable[[], None]], None]) -> None:
    """Run work in short slices instead of at once; `soon` is a function that lets Qt's event loop call its argument."""
    global _soon
    _soon = soon


def work(steps: Iterator) -> None:
    """Run an iterator: the first steps now if no other iterator waits, all further steps when FreeCAD is idle.

    An iterator that raises ReferenceError, because a document or object was deleted, is dropped.
    """
    _works.append(steps)
    if len(_works) == 1:
        _go_on()


def later(name: str, call: Callable[[], None]) -> None:
    """Call a function when FreeCAD is idle; without a window, do nothing.

    A later call of `later` with the same name replaces the function.
    """
    if _soon is not None:
        if name not in _calls:
            _soon(lambda: _calls.pop(name)())  # noqa: PLW0108 - looks the call up when it runs
        _calls[name] = call


def _go_on() -> None:
    until = math.inf if _soon is None else time.monotonic() + _SLICE
    try:
        while _works and time.monotonic() < until:
            _step()
    finally:
        if _works:  # iterators still wait, because the time slice is over or a step failed
            _go_on() if _soon is None else _soon(_go_on)


def _step() -> None:
    try:
        next(_works[0])
    except (StopIteration, ReferenceError):
        _works.popleft()
    except BaseException:
        _works.popleft()
        raise
