# SPDX-License-Identifier: LGPL-2.1-or-later
"""Python's garbage, which the window's thread alone collects while other threads work.

Python collects cycles in whatever thread makes objects. A closed tab is such a cycle, and what is of Qt must not be
destroyed beside the window: PySide's tables have no lock, and FreeCAD ends. These functions are called in the window's
thread.
"""

from __future__ import annotations

import ctypes
import gc
from contextlib import suppress

_holders = 0
_was_on = False


def hold() -> None:
    """Collect nothing by itself from now on, until as many calls of `release`."""
    global _holders, _was_on
    if not _holders:
        _was_on = gc.isenabled()
        gc.disable()
    _holders += 1


def release() -> None:
    """Collect by itself again."""
    global _holders
    _holders -= 1
    if not _holders and _was_on:
        gc.enable()


def collect() -> None:
    """Collect what is young, if it is time; what is old, which takes longer, waits for the end."""
    if _was_on and gc.get_count()[0] > gc.get_threshold()[0]:
        gc.collect(1)


def give_back() -> None:
    """Give the system the memory that is free in this process.

    What a thread has freed, Linux's C library keeps for other threads: ten simulations of 100,000 moves, closed one after the
    other, kept 750 MB, two thirds of which were free.
    """
    gc.collect()
    with suppress(OSError, AttributeError, TypeError):  # another C library
        ctypes.CDLL(None).malloc_trim(0)
