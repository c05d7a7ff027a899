# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulate one view several times, finer each time, with findings and the expected cost of the finest."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from math import sqrt
from typing import NamedTuple

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

# Sizes of the pictures, as shares of the image's side.
_SHARES = (1 / 8, MIN_SIZE, 1.0)
_MIN_PIXELS = 40  # smaller pictures show nothing
# Share of a pixel; the smallest image around the stock has the size of the stock up to rounding.
_ROUNDING = 1e-6
# Facts from pixels up to this factor larger are good enough: the next picture has three times as many each way.
_AS_FINE = 2.0


@dataclass(frozen=True, eq=False)
class Refined:
    """A simulation in the sequence.

    Attributes
    ----------
    simulation : Simulation
    seen : SeenModel or None
        The model in the same image, if requested.
    traces : int
        Number of pieces removed from rays.
    seconds : float
        Time since the view was requested, s.
    """

    simulation: Simulation
    seen: SeenModel | None
    traces: int
    seconds: float


@dataclass(frozen=True, eq=False)
class Facts:
    """Facts on the trajectories, from an image of the whole stock.

    Attributes
    ----------
    pixel : float
        Pixel size of the image, mm.
    volumes : (n,) float64
        Removed volume of each trajectory, mm^3.
    air : (n,) bool
        Feed moves that remove nothing.
    crashes : list of Crash
    plunges : list of Plunge
        Plunges that are too fast.
    """

    pixel: float
    volumes: np.ndarray
    air: np.ndarray
    crashes: list[Crash]
    plunges: list[Plunge]

    def is_as_fine(self, pixel: float) -> bool:
        """Return whether the facts are about as precise as facts from an image with this pixel size."""
        return self.pixel <= _AS_FINE * pixel


@dataclass(frozen=True, eq=False)
class Findings:
    """The findings of a simulation.

    Attributes
    ----------
    simulation : Simulation
    facts : Facts or None
        None if a part of the stock is outside the image.
    seen : SeenModel or None
        The model in the image; None if unknown or not requested.
    judged : bool
        Whether the image was compared with the model. Coarse pictures are not.
    """

    simulation: Simulation
    facts: Facts | None
    seen: SeenModel | None
    judged: bool

    @cached_property
    def deviations(self) -> Deviations | None:
        """Deviations of the finished part from the model."""
        return self.seen and self.seen.against(self.simulation.zbuffer)


class Budgets(NamedTuple):
    """The largest memory, bytes, and the longest time, s, of a simulation."""

    memory: float
    time: float


class Refining:
    """Simulates a view several times, finer each time; the work of a `Background`.

    Parameters
    ----------
    job : SimulatedJob
    view : View
        The finest image.
    budgets : Budgets
        Limits for the finest picture.
    speed : Speed
        Speed of this computer.
    glance : bool
        Whether to begin with a picture from above, which is the fastest.
    compare : bool
        Whether each picture, and not only the finest, is compared with the model.
    known : Facts or None
        Facts on the trajectories that are already known.

    Attributes
    ----------
    share : float
        Completed share of the present picture.
    """

    def __init__(
        self, job: SimulatedJob, view: View, budgets: Budgets, speed: Speed,
        *, glance: bool, compare: bool, known: Facts | None,
    ) -> None:  # fmt: skip
        self.job, self.view, self.speed, self.glance, self.compare = job, view, speed, glance, compare
        self.known = known
        self._after: Refining | None = None  # for the whole stock
        self.budgets = budgets
        self.share = 0.0
        self._trend: _CostTrend | None = None  # of the pictures so far
        self._largest = 1.0  # share of the image's side that the time budget allows
        self._began = self._stage = time.perf_counter()

    @property
    def now(self) -> Refining:
        """The running work: this, or afterwards the work for the whole stock."""
        return self if self._after is None else self._after

    def left(self) -> tuple[float | None, float]:
        """Return the remaining time until the finest picture, s (None if unknown), and its memory, bytes."""
        if self._trend is None:
            return None, 0.0
        seconds, memory = self._trend.expected(self._largest)
        return max(seconds - (time.perf_counter() - self._stage), 0.1), memory

    def __call__(self, going_on: Callable[[], None]) -> Iterator[Estimate | Refined | Findings]:
        """Yield the expected cost for the first view, then each picture, the coarsest first, with its findings.

        If the view shows a part of the stock only, findings from an image of the whole stock come last.

        Raises
        ------
        Unusable
            At the end, if the budgets only allow a coarser picture than the view. The message says so.
        """
        if self.glance:
            yield estimate_job(self.job.cuts, stock=self.job.stock, view=self.view, speed=self.speed)
            going_on()
        if self.glance and any(self.view.direction[:2]):
            above = (0.0, 0.0, 1.0 if self.view.direction[2] > 0 else -1.0)
            yield from self._told(View(above, *self._size(_SHARES[0])), going_on)
        for share in _SHARES[:-1]:
            if share * min(self.view.width, self.view.height) >= _MIN_PIXELS:
                yield from self._simulate(share, going_on)
                if self._largest <= share:
                    break
        share = allowed = self._largest
        while True:
            try:
                if share > _SHARES[-2] or self._trend is None:
                    yield from self._simulate(share, going_on, finest=True)
                break
            except OverBudget as refused:
                share = coarser(self.view, refused).width / self.view.width
        yield from self._whole(going_on)
        if allowed < 1:
            raise Unusable(Message("picture-in-time", allowed=self.budgets.time))

    def _whole(self, going_on: Callable[[], None]) -> Iterator[Findings]:
        """Yield findings from an image of the whole stock, unless similar ones are known. The image is not shown."""
        view = replace(self.view, pixel=None, offset=(0.0, 0.0))
        finest = view.frame(self.job.stock).pixel / max(self._largest, _SHARES[-2])
        known = self.known is not None and self.known.is_as_fine(finest)
        if known or holds(self.view.frame(self.job.stock), self.job.stock):
            return
        self._after = Refining(self.job, view, self.budgets, self.speed,
                            glance=False, compare=False, known=None)  # fmt: skip
        for done in self._after(going_on):
            if isinstance(done, Findings):
                yield done

    def _size(self, share: float) -> tuple[int, int]:
        return max(1, round(self.view.width * share)), max(1, round(self.view.height * share))

    def _simulate(
        self, share: float, going_on: Callable[[], None], finest: bool = False
    ) -> Iterator[Refined | Findings]:
        """Simulate an image whose sides are a share of the view's."""
        width, height = self._size(share)
        pixel = self.view.frame(self.job.stock).pixel / share
        view = replace(self.view, width=width, height=height, pixel=pixel)
        for done in self._told(view, going_on, finest):
            if isinstance(done, Refined):
                seconds = time.perf_counter() - self._stage
                peak = done.simulation.zbuffer.peak
                self._trend = _CostTrend(share, seconds, peak, self._trend, self.speed.processes)
                self._largest = self._trend.largest(self.budgets.time)
            yield done

    def _told(self, view: View, going_on: Callable[[], None], finest: bool = False) -> Iterator[Refined | Findings]:
        self._stage, self.share = time.perf_counter(), 0.0

        def report(done: float) -> None:
            self.share = done
            going_on()

        done = simulate_read(self.job, view, self.budgets.memory, report)
        zbuffer = done.zbuffer
        zbuffer.surface.prepare()  # computed here and not in the window's thread
        zbuffer.picture  # noqa: B018 - computed here and not in the window's thread
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
        findings = Findings(done, facts, seen, judged)
        findings.deviations  # noqa: B018 - computed here and not in the window's thread
        yield findings

    def _seen(self, done: Simulation, going_on: Callable[[], None]) -> SeenModel | None:
        model = self.job.model
        return None if model is None else SeenModel(model, done.zbuffer.frame, going_on)


def holds(frame: Frame, stock: Solid) -> bool:
    """Return whether an image contains the whole stock. Outside the image no ray finds what trajectories do."""
    corners = np.array(list(product(*zip(stock.lower, stock.upper)))) - frame.centre
    reach = np.abs(corners @ np.array([frame.right, frame.up]).T).max(axis=0)
    return bool((reach <= frame.pixel / 2 * np.array([frame.width, frame.height]) + _ROUNDING * frame.pixel).all())


class _CostTrend:
    """Time and memory as functions of the image size, from the last pictures: a fixed part and a part for each pixel.

    The times are for one process; see `core.zbuffer.shared_seconds`.

    Parameters
    ----------
    share : float
        Share of the image's side that was simulated.
    seconds : float
        Time for it, s.
    peak : Peak
        Peak memory of it.
    before : _CostTrend, optional
        The trend of a coarser picture.
    processes : int
        Number of processes that work at the same time.
    """

    def __init__(self, share: float, seconds: float, peak: Peak, before: _CostTrend | None, processes: int) -> None:
        self._processes = processes
        seconds = unshared_seconds(seconds, processes)
        self.pixels, self.seconds, self._peak = share**2, seconds, peak
        pixels, spent = (before.pixels, before.seconds) if before else (0.0, 0.0)
        self._each = max(seconds - spent, 0.0) / (self.pixels - pixels)
        self._fixed = seconds - self._each * self.pixels

    def expected(self, share: float) -> tuple[float, float]:
        """Return the expected time, s, and memory, bytes, of an image with this share."""
        seconds = shared_seconds(self._fixed + self._each * share**2, self._processes)
        return seconds, self._peak.bytes(share**2 / self.pixels)

    def largest(self, budget: float) -> float:
        """Return the largest share, at most 1, within a time budget, s; 0 if no image is within it."""
        alone = unshared_seconds(budget, self._processes)
        pixels = (alone - self._fixed) / self._each if self._each else float(alone >= self._fixed)
        return sqrt(min(max(pixels, 0.0), 1.0))
