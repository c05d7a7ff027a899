# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulations of one view, each finer than the one before."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from vkworkbench.core import View
from vkworkbench.core.zbuffer import Crash, OverBudget, crashes, cuts_air, removed_volumes
from vkworkbench.document.simulated_job import SimulatedJob
from vkworkbench.document.simulation import Simulation, simulate_read

# Of the image's side: the first picture is there at once, the next is good enough to look at, the last is the finest.
_SHARES = (1 / 8, 1 / 3, 1.0)
_FEWEST = 40  # pixels; a coarser picture shows nothing
# By how much a picture is made coarser that takes too much memory.
_COARSER = 0.8


@dataclass(frozen=True, eq=False)
class Refined:
    """A simulation and what it told.

    Attributes
    ----------
    simulation : Simulation
    volumes : (n,) float64
        What each trajectory removes, mm^3.
    air : (n,) bool
        Which feed moves remove nothing.
    crashes : list of Crash
    seconds : float
        Since the view was asked for.
    """

    simulation: Simulation
    volumes: np.ndarray
    air: np.ndarray
    crashes: list[Crash]
    seconds: float


class Refining:
    """Simulates a view again and again, finer each time; the work of a `Background`.

    Parameters
    ----------
    job : SimulatedJob
    view : View
        The finest image.
    memory_budget : float
        Bytes.

    Attributes
    ----------
    share : float
        Of the image that is worked on, how much is done.
    """

    def __init__(self, job: SimulatedJob, view: View, memory_budget: float) -> None:
        self.job, self.view, self.memory_budget = job, view, memory_budget
        self.share = 0.0
        self._finest: tuple[float, float] | None = None  # s and bytes, as the last picture lets expect
        self._began = self._stage = time.perf_counter()

    def left(self) -> tuple[float | None, float]:
        """Return how long the finest picture still takes, s, and its memory, bytes; None until that can be told."""
        if self._finest is None:
            return None, 0.0
        seconds, memory = self._finest
        return max(seconds - (time.perf_counter() - self._stage), 0.1), memory

    def __call__(self, going_on: Callable[[], None]) -> Iterator[Refined]:
        """Yield the pictures, the coarsest first.

        Raises
        ------
        OverBudget
            Where no picture finer than the last one fits.
        """
        for share in _SHARES[:-1]:
            if share * min(self.view.width, self.view.height) >= _FEWEST:
                yield self._simulate(share, going_on)
        share = 1.0
        while True:
            try:
                yield self._simulate(share, going_on)
                return
            except OverBudget:
                share *= _COARSER
                if share <= _SHARES[-2]:
                    raise

    def _simulate(self, share: float, going_on: Callable[[], None]) -> Refined:
        """Simulate an image of so large a share of the view's sides."""
        self._stage, self.share = time.perf_counter(), 0.0

        def told(done: float) -> None:
            self.share = done
            going_on()

        view, job = self.view, self.job
        coarse = replace(view, width=max(1, round(view.width * share)), height=max(1, round(view.height * share)),
                         pixel=view.frame(job.stock).pixel / share)  # fmt: skip
        done = simulate_read(job, coarse, memory_budget=self.memory_budget, going_on=told)
        zbuffer = done.zbuffer
        zbuffer.picture  # noqa: B018 - what any moment needs is made here, not in the window
        facts = removed_volumes(zbuffer), cuts_air(zbuffer), crashes(zbuffer)
        now = time.perf_counter()
        more = 1 / share**2
        self._finest = more * (now - self._stage), more * zbuffer.memory_bytes
        return Refined(done, *facts, now - self._began)
