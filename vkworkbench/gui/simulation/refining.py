# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulations of one view, each finer than the one before: what the finest will cost, and what they tell."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from math import sqrt

import numpy as np

from vkworkbench.core import Frame, Solid, View
from vkworkbench.core.zbuffer import (
    Crash,
    Deviations,
    Estimate,
    OverBudget,
    Peak,
    Plunge,
    SeenModel,
    Speed,
    crashes,
    cuts_air,
    estimate_job,
    fast_plunges,
    removed_volumes,
    shared_seconds,
    unshared_seconds,
)
from vkworkbench.document.simulation.job import SimulatedJob
from vkworkbench.document.simulation.simulate import MIN_SIZE, Simulation, coarser, simulate_read
from vkworkbench.language import Message, Unusable

# Of the image's side: the first picture is there at once, the last is the finest.
_SHARES = (1 / 8, MIN_SIZE, 1.0)
_FEWEST = 40  # pixels; a coarser picture shows nothing
# Of a pixel; the image that just holds the stock is as large as it but for that.
_ROUNDING = 1e-6
# Pixels up to so many times as large tell as much: the next picture has thrice as many each way.
_AS_FINE = 2.0


@dataclass(frozen=True, eq=False)
class Refined:
    """A simulation.

    Attributes
    ----------
    simulation : Simulation
    seen : SeenModel or None
        What the part is to be, in the same image, where that was asked for.
    traces : int
        How many pieces it removed from its rays.
    seconds : float
        Since the view was asked for.
    """

    simulation: Simulation
    seen: SeenModel | None
    traces: int
    seconds: float


@dataclass(frozen=True, eq=False)
class Facts:
    """What an image of the whole stock tells of the trajectories.

    Attributes
    ----------
    pixel : float
        Of that image, mm.
    volumes : (n,) float64
        What each removes, mm^3.
    air : (n,) bool
        Which feed moves remove nothing.
    crashes : list of Crash
    plunges : list of Plunge
        Those that are too fast.
    """

    pixel: float
    volumes: np.ndarray
    air: np.ndarray
    crashes: list[Crash]
    plunges: list[Plunge]

    def is_as_fine(self, pixel: float) -> bool:
        """Whether it tells about as much as an image of such pixels does, from whatever side."""
        return self.pixel <= _AS_FINE * pixel


@dataclass(frozen=True, eq=False)
class Told:
    """What a simulation tells.

    Attributes
    ----------
    simulation : Simulation
    facts : Facts or None
        None where some of the stock lies beside the image.
    seen : SeenModel or None
        What the part is to be; None where it is not known, or was not asked for.
    judged : bool
        Whether gouges are known, too: a coarse picture does not look at the model.
    """

    simulation: Simulation
    facts: Facts | None
    seen: SeenModel | None
    judged: bool

    @cached_property
    def deviations(self) -> Deviations | None:
        """Those of the finished part."""
        return self.seen and self.seen.against(self.simulation.zbuffer)


class Refining:
    """Simulates a view again and again, finer each time; the work of a `Background`.

    Parameters
    ----------
    job : SimulatedJob
    view : View
        The finest image.
    memory_budget, time_budget : float
        Bytes and s that the finest picture may take.
    speed : Speed
        Of this computer, for the cost of the finest picture.
    glance : bool
        Whether to begin from straight above, which is the quickest, for something to be seen.
    compare : bool
        Whether each picture comes with what the part is to be, not only the finest.
    known : Facts or None
        What is known of the trajectories.

    Attributes
    ----------
    share : float
        Of the image that is worked on, how much is done.
    """

    def __init__(
        self, job: SimulatedJob, view: View, memory_budget: float, time_budget: float, speed: Speed,
        *, glance: bool, compare: bool, known: Facts | None,
    ) -> None:  # fmt: skip
        self.job, self.view, self.speed, self.glance, self.compare = job, view, speed, glance, compare
        self.known = known
        self._after: Refining | None = None  # that of the whole stock
        self.memory_budget, self.time_budget = memory_budget, time_budget
        self.share = 0.0
        self._course: _Course | None = None  # of the pictures until now
        self._largest = 1.0  # share of the image's side that the time budget allows
        self._began = self._stage = time.perf_counter()

    @property
    def now(self) -> Refining:
        """What is being done: this, or afterwards that of the whole stock."""
        return self if self._after is None else self._after

    def left(self) -> tuple[float | None, float]:
        """Return how long the finest picture still takes, s, and its memory, bytes; None until that can be told."""
        if self._course is None:
            return None, 0.0
        seconds, memory = self._course.expected(self._largest)
        return max(seconds - (time.perf_counter() - self._stage), 0.1), memory

    def __call__(self, going_on: Callable[[], None]) -> Iterator[Estimate | Refined | Told]:
        """Yield what the finest picture will cost, where nothing is seen, the pictures, the coarsest first, and what each tells.

        Where they show a part of the stock, and no such picture of all of it was simulated, what that tells comes last.

        Raises
        ------
        Unusable
            Where the finest picture that the budgets allow is coarser than the view: its message says so.
        """
        if self.glance:  # where there is a picture, the first coarse one is there sooner
            yield estimate_job(self.job.cuts, stock=self.job.stock, view=self.view, speed=self.speed)
            going_on()
        if self.glance and any(self.view.direction[:2]):
            above = (0.0, 0.0, 1.0 if self.view.direction[2] > 0 else -1.0)
            yield from self._told(View(above, *self._size(_SHARES[0])), going_on)
        for share in _SHARES[:-1]:
            if share * min(self.view.width, self.view.height) >= _FEWEST:
                yield from self._simulate(share, going_on)
                if self._largest <= share:
                    break
        share = allowed = self._largest
        while True:
            try:
                if share > _SHARES[-2] or self._course is None:
                    yield from self._simulate(share, going_on, finest=True)
                break
            except OverBudget as refused:
                share = coarser(self.view, refused).width / self.view.width
        yield from self._whole(going_on)
        if allowed < 1:
            raise Unusable(Message("picture-in-time", allowed=self.time_budget))

    def _whole(self, going_on: Callable[[], None]) -> Iterator[Told]:
        """Tell what only an image of the whole stock tells, unless one of about these pixels has: nobody sees it."""
        view = replace(self.view, pixel=None, offset=(0.0, 0.0))
        finest = view.frame(self.job.stock).pixel / max(self._largest, _SHARES[-2])
        known = self.known is not None and self.known.is_as_fine(finest)
        if known or holds(self.view.frame(self.job.stock), self.job.stock):
            return
        self._after = Refining(self.job, view, self.memory_budget, self.time_budget, self.speed,
                            glance=False, compare=False, known=None)  # fmt: skip
        for done in self._after(going_on):
            if isinstance(done, Told):
                yield done

    def _size(self, share: float) -> tuple[int, int]:
        return max(1, round(self.view.width * share)), max(1, round(self.view.height * share))

    def _simulate(self, share: float, going_on: Callable[[], None], finest: bool = False) -> Iterator[Refined | Told]:
        """Simulate an image of so large a share of the view's sides."""
        width, height = self._size(share)
        pixel = self.view.frame(self.job.stock).pixel / share
        view = replace(self.view, width=width, height=height, pixel=pixel)
        for done in self._told(view, going_on, finest):
            if isinstance(done, Refined):
                seconds = time.perf_counter() - self._stage
                peak = done.simulation.zbuffer.peak
                self._course = _Course(share, seconds, peak, self._course, self.speed.processes)
                self._largest = self._course.largest(self.time_budget)
            yield done

    def _told(self, view: View, going_on: Callable[[], None], finest: bool = False) -> Iterator[Refined | Told]:
        self._stage, self.share = time.perf_counter(), 0.0

        def told(done: float) -> None:
            self.share = done
            going_on()

        done = simulate_read(self.job, view, self.memory_budget, told)
        zbuffer = done.zbuffer
        zbuffer.surface.prepare()  # here, not in the window
        zbuffer.picture  # noqa: B018 - likewise
        seen = self._seen(done, going_on) if self.compare else None
        yield Refined(done, seen, zbuffer.traces, time.perf_counter() - self._began)
        facts = None
        if holds(zbuffer.frame, self.job.stock):
            found = []
            for tell in (removed_volumes, cuts_air, crashes, fast_plunges):
                found.append(tell(zbuffer))
                going_on()
            facts = Facts(zbuffer.frame.pixel, *found)
        if finest and seen is None:
            seen = self._seen(done, going_on)
        judged = finest or seen is not None or not self.job.model_shapes
        told_all = Told(done, facts, seen, judged)
        told_all.deviations  # noqa: B018 - likewise
        yield told_all

    def _seen(self, done: Simulation, going_on: Callable[[], None]) -> SeenModel | None:
        model = self.job.model
        return None if model is None else SeenModel(model, done.zbuffer.frame, going_on)


def holds(frame: Frame, stock: Solid) -> bool:
    """Return whether an image holds the whole stock: what trajectories do beside it, no ray tells."""
    corners = np.array(list(product(*zip(stock.lower, stock.upper)))) - frame.centre
    reach = np.abs(corners @ np.array([frame.right, frame.up]).T).max(axis=0)
    return bool((reach <= frame.pixel / 2 * np.array([frame.width, frame.height]) + _ROUNDING * frame.pixel).all())


class _Course:
    """How time and memory grow with the image, from the last pictures: a part for each pixel, and a part for all.

    The times grow so that one process would take; see `core.zbuffer.shared_seconds`.

    Parameters
    ----------
    share : float
        Of the image's side that was simulated.
    seconds : float
        How long that took, s.
    peak : Peak
        What decided the memory that it took.
    before : _Course, optional
        That of a coarser picture.
    processes : int
        How many cut at once.
    """

    def __init__(self, share: float, seconds: float, peak: Peak, before: _Course | None, processes: int) -> None:
        self._processes = processes
        seconds = unshared_seconds(seconds, processes)
        self.pixels, self.seconds, self._peak = share**2, seconds, peak
        pixels, spent = (before.pixels, before.seconds) if before else (0.0, 0.0)
        self._each = max(seconds - spent, 0.0) / (self.pixels - pixels)
        self._fixed = seconds - self._each * self.pixels

    def expected(self, share: float) -> tuple[float, float]:
        """Return what an image of such a share takes, s and bytes."""
        seconds = shared_seconds(self._fixed + self._each * share**2, self._processes)
        return seconds, self._peak.bytes(share**2 / self.pixels)

    def largest(self, budget: float) -> float:
        """Return the largest share that takes no longer, s; at most 1, and 0 where there is none."""
        alone = unshared_seconds(budget, self._processes)
        pixels = (alone - self._fixed) / self._each if self._each else float(alone >= self._fixed)
        return sqrt(min(max(pixels, 0.0), 1.0))
