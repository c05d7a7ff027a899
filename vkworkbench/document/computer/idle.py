# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work that may wait until FreeCAD is idle: in a window it is done piece by piece, without one at once."""

from __future__ import annotations

import math
import time
from collections import deque
from collections.abc import Callable, Iterator

_AT_ONCE = 0.03  # s of work, then other events come

_soon: Callable[[Callable[[], None]], None] | None = None
_works: deque[Iterator] = deque()
_calls: dict[str, Callable[[], None]] = {}


def use(soon: Callable[[Callable[[], None]], None]) -> None:
    """Work in a window from now on; `soon` has a function called by the window's event loop."""
    global _soon
    _soon = soon


def work(steps: Iterator) -> None:
    """Do what an iterator does: at once what takes a moment, the rest when FreeCAD is idle, one after the other.

    It ends where it meets a document or an object that is gone.
    """
    _works.append(steps)
    if len(_works) == 1:
        _go_on()


def later(name: str, call: Callable[[], None]) -> None:
    """Call a function when FreeCAD is idle, once for all calls of that name until then; never without a window."""
    if _soon is not None:
        if name not in _calls:
            _soon(lambda: _calls.pop(name)())  # noqa: PLW0108 - what is waiting then, not now
        _calls[name] = call


def _go_on() -> None:
    until = math.inf if _soon is None else time.monotonic() + _AT_ONCE
    try:
        while _works and time.monotonic() < until:
            _step()
    finally:
        if _works:  # the moment is over; or one has failed, which ends no other
            _go_on() if _soon is None else _soon(_go_on)


def _step() -> None:
    try:
        next(_works[0])
    except (StopIteration, ReferenceError):
        _works.popleft()
    except BaseException:
        _works.popleft()
        raise
