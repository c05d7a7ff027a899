# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run Python's garbage collection only in Qt's main thread while other threads work.

Python collects reference cycles in any thread that creates objects. A closed tab is a reference cycle, and destroying
a Qt object outside Qt's main thread crashes FreeCAD, because PySide's tables have no lock. Call the functions of this
module in Qt's main thread.
"""

from __future__ import annotations

import ctypes
import gc
from contextlib import suppress

_holders = 0
_was_on = False


def hold() -> None:
    """Disable automatic garbage collection until `release` was called once for each call of `hold`."""
    global _holders, _was_on
    if not _holders:
        _was_on = gc.isenabled()
        gc.disable()
    _holders += 1


def release() -> None:
    """Undo one call of `hold`; after the last, enable automatic garbage collection again."""
    global _holders
    _holders -= 1
    if not _holders and _was_on:
        gc.enable()


def collect() -> None:
    """Collect unreachable new objects if there are many new objects; old objects wait until `release`."""
    if _was_on and gc.get_count()[0] > gc.get_threshold()[0]:
        gc.collect(1)


def give_back() -> None:
    """Return free memory of this process to the system.

    The C library of Linux otherwise keeps memory that a thread has freed: hundreds of MB after some large simulations.
    """
    gc.collect()
    with suppress(OSError, AttributeError, TypeError):  # C libraries other than glibc have no malloc_trim
        ctypes.CDLL(None).malloc_trim(0)
