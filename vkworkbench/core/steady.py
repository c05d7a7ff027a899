# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long pieces of work take, measured again and again until it is steady."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Sequence

import numpy as np

from vkworkbench.given import of_kind, whole

# A time is steady once the shortest was taken, within so much, so many times.
_EQUAL, _TIMES = 1.05, 3

# The processor's time where it is fine enough: on Windows it advances in steps of 16 ms.
processor_clock: Callable[[], float] = time.perf_counter if os.name == "nt" else time.process_time


def steady_seconds(
    pieces: Sequence[Callable[[], object]],
    *,
    most: int,
    clock: Callable[[], float] = processor_clock,
    going_on: Callable[[], object] = lambda: None,
) -> np.ndarray:
    """Time pieces of work, each until it took its shortest time, within 5 %, three times.

    What else the computer does makes a piece slower only, so the shortest time is the true one; that it comes again
    tells that it was not the least slow of slow moments. The pieces take turns: a busy moment spoils one time of each.

    Parameters
    ----------
    pieces : sequence of callable
    most : int
        How often a piece is timed at most.
    clock : callable
        Tells the time, s.
    going_on : callable
        Called before each piece, outside the times; it may raise to end the measurement.

    Returns
    -------
    (k,) float64
        The shortest time of each piece, s.

    Raises
    ------
    ValueError, TypeError
        If `most` is no whole number of at least 1, or what is to be called is nothing that can be.
    """
    most = whole("most", most, "a whole number of at least 1", lambda n: n >= 1)
    for name, given in (("clock", clock), ("going_on", going_on)):
        of_kind(name, given, Callable, "a function")
    times: list[list[float]] = [[] for _ in pieces]
    for _ in range(most):
        waiting = [place for place, taken in enumerate(times) if not _is_steady(taken)]
        if not waiting:
            break
        for place in waiting:
            going_on()
            begin = clock()
            pieces[place]()
            times[place].append(clock() - begin)
    return np.array([min(taken) for taken in times])


def _is_steady(taken: list[float]) -> bool:
    return len(taken) >= _TIMES and sorted(taken)[_TIMES - 1] <= _EQUAL * min(taken)
