# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulate a job along the tool axis: first coarsely, then with one ray for each pixel; then check the job."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from math import ceil, sqrt
from typing import NamedTuple

import numpy as np

from vkworkbench.core import Frame, View
from vkworkbench.core.zbuffer import (
    TOLERANCE,
    Deviations,
    Estimate,
    JobFacts,
    OverBudget,
    SeenModel,
    Speed,
    best_resolution,
    cuts_air,
    deviations,
    estimate_job,
    removed_volumes,
)  # fmt: skip
from vkworkbench.document.simulation.along_axis import AlongAxis, simulate_along_axis
from vkworkbench.document.simulation.job import SimulatedJob
from vkworkbench.document.simulation.simulate import Simulation, coarser, simulate_read
from vkworkbench.language import Message, Unusable

# Direction of the rays, along the tool axis. Pictures from all directions are drawn from a simulation with these rays.
ABOVE = (0.0, 0.0, -1.0)
# Minimum vertical component of the view's unit direction, for which a detail is simulated. A flatter view shows most of
# the stock, so that a detail would not be finer than the whole.
_FLATTEST = 0.2
# _FINER: a detail is simulated only if its pixel size is at most this share of the shown simulation's pixel size.
# _MARGIN: width of the detail's margin around the visible part of the stock, in pixels of the detail.
_FINER, _MARGIN = 0.7, 3
# _COARSE: number of rays of the coarse simulation, as a share of the rays of the finest simulation.
# _FEWEST: minimum number of rays of every simulation; with fewer rays the user cannot recognise the part.
_COARSE, _FEWEST = 1 / 25, 2000


@dataclass(frozen=True, eq=False)
class Simulated:
    """A simulation along the tool axis, from which pictures are drawn."""

    simulation: Simulation
    volumes: np.ndarray  # (n,) float64: removed volume of each trajectory, mm^3
    air: np.ndarray  # (n,) bool: whether a trajectory is a feed move that removes nothing
    seen: SeenModel | None  # the model, seen from above; None without a model, and for the coarse simulation
    is_finest: bool  # whether no finer simulation follows
    seconds: float  # time since the simulation was requested, s


@dataclass(frozen=True, eq=False)
class Findings:
    """The results of the check of a job.

    The check has its own simulation along the tool axis, so that its results do not depend on the size of the window.
    """

    along_axis: AlongAxis
    facts: JobFacts  # what the check found in the operations, and its verdict on the job, at the default tolerance
    # volumes, air: as in the class `Simulated`.
    volumes: np.ndarray
    air: np.ndarray

    @cached_property
    def deviations(self) -> Deviations | None:
        """Deviations of the finished part from the model; None without a model."""
        model = self.along_axis.job.model
        return None if model is None else deviations(self.along_axis.zbuffer, model)


class Simulating:
    """Simulates a job first coarsely, then finely, and then checks it. A `Background` calls this object in its thread.

    `rays` is the number of rays of the finest image, and `memory` and `seconds` are the budgets of the finest
    simulation, bytes and s.
    """

    def __init__(self, job: SimulatedJob, rays: int, memory: float, seconds: float, speed: Speed) -> None:
        self.job, self._rays, self._memory, self._seconds, self._speed = job, rays, memory, seconds, speed
        self.share = 0.0  # completed share of the running simulation, 0 to 1
        self.checks = False  # whether the running simulation belongs to the check
        self.expected: Estimate | None = None  # the expected cost of the finest simulation; None until it is known
        self._began = time.perf_counter()

    def __call__(self, going_on: Callable[[], None]) -> Iterator[Simulated | Findings]:
        """Yield the coarse simulation, the finest simulation, and the findings of the check.

        `Unusable` is raised after all results if the time budget allowed only a coarser image than requested.
        """
        yield self._simulate(self._view(_COARSE * self._rays), False, going_on)
        view = finest = self._view(self._rays)
        found = estimate_job(self.job.cuts, stock=self.job.stock, view=view, speed=self._speed)
        going_on()
        in_time = found.seconds <= self._seconds
        if not in_time:
            view = best_resolution([found], seconds=self._seconds).view
        self.expected = found
        done = None
        while done is None and view is not None:
            try:
                done = self._simulate(view, True, going_on)
            except OverBudget as refused:
                view = coarser(finest, refused)
        if done is not None:
            yield done
            self.checks = True
            yield self._check(self._memory - done.simulation.zbuffer.peak.bytes(), going_on)
        if not in_time:
            raise Unusable(Message("picture-in-time", allowed=self._seconds))

    def _view(self, rays: float) -> View:
        """Return a view of the whole stock from above, with about this number of rays."""
        width, depth = (self.job.stock.upper - self.job.stock.lower)[:2]
        pixel = np.sqrt(width * depth / max(rays, _FEWEST))
        return View(ABOVE, *(max(1, round(float(side / pixel))) for side in (width, depth)))

    def _simulate(self, view: View, is_finest: bool, going_on: Callable[[], None]) -> Simulated:
        done = simulate_read(self.job, view, self._memory, self._reported(going_on))
        zbuffer = done.zbuffer
        zbuffer.surface.prepare()  # compute the surface in this thread, because Qt's main thread would take long
        model = self.job.model if is_finest else None
        seen = None if model is None else SeenModel(model, zbuffer.frame, going_on)
        seconds = time.perf_counter() - self._began
        return Simulated(done, removed_volumes(zbuffer), cuts_air(zbuffer), seen, is_finest, seconds)

    def _check(self, memory: float, going_on: Callable[[], None]) -> Findings:
        found = simulate_along_axis(self.job, memory, self._reported(going_on))
        zbuffer, measured = found.zbuffer, found.measured
        volumes = removed_volumes(zbuffer) if measured is None else measured.each
        return Findings(found, found.facts(TOLERANCE, going_on), volumes, cuts_air(zbuffer, measured))

    def _reported(self, going_on: Callable[[], None]) -> Callable[[float], None]:
        self.share = 0.0

        def report(done: float) -> None:
            self.share = done
            going_on()

        return report


class Region(NamedTuple):
    """A rectangle in the XY plane, given by its lower and upper corner, (2,) mm each."""

    low: np.ndarray
    high: np.ndarray

    def contains(self, other: Region) -> bool:
        """Return whether the rectangle `other` is inside this rectangle."""
        return bool((self.low <= other.low).all() and (self.high >= other.high).all())


def seen_region(frame: Frame, job: SimulatedJob) -> Region | None:
    """Return the part of the stock that an image can show.

    Return None if the image shows no stock, or if the view is too flat for a detail.
    """
    if abs(frame.direction[2]) < _FLATTEST:
        return None
    half = np.array([frame.width, frame.height]) * frame.pixel / 2
    corners = frame.origins(*(half[:, None] * np.array([(-1, -1, 1, 1), (-1, 1, -1, 1)])))
    ends = []
    for height in (job.stock.lower[2], job.stock.upper[2]):
        along = (height - corners[:, 2]) / frame.direction[2]
        ends.append((corners + along[:, None] * frame.direction)[:, :2])
    points = np.concatenate(ends)
    low = np.maximum(points.min(axis=0), job.stock.lower[:2])
    high = np.minimum(points.max(axis=0), job.stock.upper[:2])
    return Region(low, high) if (low < high).all() else None


def region_of(frame: Frame) -> Region:
    """Return the rectangle that an image from above covers."""
    half = np.array([frame.width, frame.height]) * frame.pixel / 2
    return Region(frame.centre[:2] - half, frame.centre[:2] + half)


def detail_view(frame: Frame, job: SimulatedJob, pixel: float) -> View | None:
    """Return a view from above of the part of the stock that the image `frame` shows; None if it would not be finer.

    `pixel` is the size of the pixels of the shown simulation, mm.
    """
    seen = seen_region(frame, job)
    if seen is None:
        return None
    side = seen.high - seen.low
    finer = max(frame.pixel, sqrt(float(side.prod()) / (frame.width * frame.height)))
    if finer > _FINER * pixel:
        return None
    width, height = (ceil(length / finer) + 2 * _MARGIN for length in side.tolist())
    offset = (seen.low + seen.high - job.stock.lower[:2] - job.stock.upper[:2]) / 2
    return View(ABOVE, width, height, finer, tuple(offset.tolist()))


def simulate_detail(job: SimulatedJob, view: View, memory: float, going_on: Callable[[], None]) -> Iterator[Simulation]:
    """Yield the simulation of a detail, in the thread of a `Background`."""
    done = simulate_read(job, view, memory, lambda _: going_on())
    done.zbuffer.surface.prepare()
    yield done
