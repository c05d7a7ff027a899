# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulations of one view, each finer than the one before, in a thread of their own."""

from __future__ import annotations

import threading
import time
import traceback
from dataclasses import dataclass, replace

import FreeCAD
import numpy as np

from vkworkbench.core import View
from vkworkbench.core.zbuffer import Crash, OverBudget, crashes, removed_volumes
from vkworkbench.document.simulation import SimulatedJob, Simulation
from vkworkbench.language import Message, Unusable

# Of the image's side: the first picture is there at once, the next is good enough to look at, the last is the finest.
_SHARES = (1 / 8, 1 / 3, 1.0)
_FEWEST = 40  # pixels; a coarser picture shows nothing
# By how much a picture is made coarser that takes too much memory.
_COARSER = 0.8


@dataclass(frozen=True, eq=False)
class Refined:
    """A simulation and what it took.

    Attributes
    ----------
    simulation : Simulation
    volumes : (n,) float64
        What each trajectory removes, mm^3.
    crashes : list of Crash
    seconds : float
        Since the view was asked for.
    """

    simulation: Simulation
    volumes: np.ndarray
    crashes: list[Crash]
    seconds: float


class Worker:
    """Simulates a view again and again, finer each time.

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
    error : Message or None
        Why there is no finer picture.
    """

    def __init__(self, job: SimulatedJob, view: View, memory_budget: float) -> None:
        self.share = 0.0
        self.error: Message | None = None
        self._latest: Refined | None = None
        self._finest: tuple[float, float] | None = None  # s and bytes, as the last picture lets expect
        self._stage = time.perf_counter()
        self._given_up = threading.Event()
        self._began = time.perf_counter()
        self._thread = threading.Thread(target=self._work, args=(job, view, memory_budget), daemon=True)
        self._thread.start()

    @property
    def busy(self) -> bool:
        return self._thread.is_alive()

    def take(self) -> Refined | None:
        """Return the latest simulation that was not taken yet."""
        latest, self._latest = self._latest, None
        return latest

    def left(self) -> tuple[float | None, float]:
        """Return how long the finest picture still takes, s, and its memory, bytes; None until that can be told."""
        if self._finest is None:
            return None, 0.0
        seconds, memory = self._finest
        return max(seconds - (time.perf_counter() - self._stage), 0.1), memory

    def give_up(self) -> None:
        """End the work at the next opportunity, within some hundredths of a second."""
        self._given_up.set()

    def _work(self, job: SimulatedJob, view: View, memory_budget: float) -> None:
        try:
            for share in _SHARES:
                if share == 1:
                    self._finest_that_fits(job, view, memory_budget)
                elif share * min(view.width, view.height) >= _FEWEST:
                    self._simulate(job, view, share, memory_budget)
        except _GivenUp:
            pass
        except Unusable as error:
            self.error = error.what
        except Exception as error:  # an error of this add-on must not cost the user his window
            FreeCAD.Console.PrintLog(traceback.format_exc())
            self.error = Message("not-analysed", error=f"{type(error).__name__}: {error}")

    def _finest_that_fits(self, job: SimulatedJob, view: View, memory_budget: float) -> None:
        """Simulate the view, coarser where it takes too much memory; that is told where nothing fits."""
        share = 1.0
        while True:
            try:
                self._simulate(job, view, share, memory_budget)
                return
            except OverBudget as error:
                share *= _COARSER
                if share <= _SHARES[-2]:
                    self.error = error.what
                    return

    def _simulate(self, job: SimulatedJob, view: View, share: float, memory_budget: float) -> None:
        """Simulate an image of so large a share of the view's sides."""
        self._stage, self.share = time.perf_counter(), 0.0
        coarse = replace(view, width=max(1, round(view.width * share)), height=max(1, round(view.height * share)),
                         pixel=view.frame(job.stock).pixel / share)  # fmt: skip
        done = job.simulate(coarse, memory_budget=memory_budget, going_on=self._going_on)
        done.zbuffer.picture  # noqa: B018 - what any moment needs is made here, not in the window
        volumes, crashed = removed_volumes(done.zbuffer), crashes(done.zbuffer)
        now = time.perf_counter()
        more = 1 / share**2
        self._finest = more * (now - self._stage), more * done.zbuffer.memory_bytes
        self._latest = Refined(done, volumes, crashed, now - self._began)

    def _going_on(self, share: float) -> None:
        self.share = share
        if self._given_up.is_set():
            raise _GivenUp


class _GivenUp(Exception):
    pass
