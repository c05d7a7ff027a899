# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the times of functions repeatedly, until the shortest time of each function is confirmed."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Sequence

import numpy as np

# The shortest measured time of a function is confirmed if at least _TIMES measurements (itself included) are no longer
# than _EQUAL times the shortest.
_EQUAL, _TIMES = 1.05, 3

# The processor time of this process. On Windows, the processor time advances in steps of 16 ms, so the wall-clock time
# is used.
processor_clock: Callable[[], float] = time.perf_counter if os.name == "nt" else time.process_time


def steady_seconds(
    pieces: Sequence[Callable[[], object]],
    *,
    most: int,
    clock: Callable[[], float] = processor_clock,
    going_on: Callable[[], object] = lambda: None,
) -> np.ndarray:
    """Return the shortest time of each function, s, (k,) float64; at least three times are within 5 % of the shortest.

    Other processes on the computer can only make a measured time longer, so the shortest time is the best estimate.
    Three nearly equal times show that the computer was idle. The functions are called in turn, so that a short load on
    the computer spoils only one measurement of each function. `most` is the largest number of measurements of each
    function. `going_on` is called before each measurement; an exception from `going_on` ends all measurements.
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
