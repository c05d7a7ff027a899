# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the time of pieces of work repeatedly, until the shortest time is confirmed."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Sequence

import numpy as np

# A time is steady once _TIMES measurements are at most _EQUAL times the shortest measurement.
_EQUAL, _TIMES = 1.05, 3

# The processor time of this process. On Windows, this time advances in steps of 16 ms, so the wall-clock time is used.
processor_clock: Callable[[], float] = time.perf_counter if os.name == "nt" else time.process_time


def steady_seconds(
    pieces: Sequence[Callable[[], object]],
    *,
    most: int,
    clock: Callable[[], float] = processor_clock,
    going_on: Callable[[], object] = lambda: None,
) -> np.ndarray:
    """Return the shortest time of each piece of work, s, (k,) float64: three measurements are within 5 % of it.

    Other work of the computer can only slow a piece of work down, so the shortest time is the best estimate. Three
    nearly equal times show that the computer was idle. The pieces are timed in turn, so that a busy moment spoils only
    one measurement of each piece.

    Parameters
    ----------
    pieces : sequence of callable
        Each piece is called without arguments.
    most : int
        Largest number of measurements of a piece.
    going_on : callable
        Called before each piece of work; its time does not count. An exception from this call ends the measurement.
    """
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
