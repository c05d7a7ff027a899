# SPDX-License-Identifier: LGPL-2.1-or-later
"""The time that pieces of work take, measured repeatedly until it is steady."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Sequence

import numpy as np

from vkworkbench.given import of_kind, whole

# A time is steady once _TIMES measurements are at most _EQUAL times the shortest one.
_EQUAL, _TIMES = 1.05, 3

# The processor's time, except on Windows, where it advances in steps of 16 ms.
processor_clock: Callable[[], float] = time.perf_counter if os.name == "nt" else time.process_time


def steady_seconds(
    pieces: Sequence[Callable[[], object]],
    *,
    most: int,
    clock: Callable[[], float] = processor_clock,
    going_on: Callable[[], object] = lambda: None,
) -> np.ndarray:
    """Time each piece of work until its shortest time was repeated, within 5 %, three times in all.

    Other work of the computer can only slow a piece down, so the shortest time is the best estimate. Its repetition
    shows that the computer was idle. The pieces take turns, so that a busy moment spoils only one time of each piece.

    Parameters
    ----------
    pieces : sequence of callable
    most : int
        Largest number of measurements of a piece.
    clock : callable
        Returns the time, s.
    going_on : callable
        Called before each piece, outside the times; it may raise to end the measurement.

    Returns
    -------
    (k,) float64
        The shortest time of each piece, s.

    Raises
    ------
    ValueError, TypeError
        If `most` is not a whole number of at least 1, or `clock` or `going_on` is not callable.
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
