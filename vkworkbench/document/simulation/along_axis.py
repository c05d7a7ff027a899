# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulate a job along its tool axis, for all results that are reported, such as gouges and collisions.

The reported results do not depend on the view in which the user sees the part.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from vkworkbench import preferences
from vkworkbench.core import ZBuffer, simulate_job
from vkworkbench.core.zbuffer import (
    Collisions,
    CrashCheck,
    JobFacts,
    OverBudget,
    SeenModel,
    Volumes,
    axis_view,
    check_crashes,
    facts,
    holder_collisions,
    measure_volumes,
    thin_gouges,
)
from vkworkbench.document.computer.calibration import known_speed
from vkworkbench.document.simulation.job import SimulatedJob


@dataclass(frozen=True, eq=False)
class AlongAxis:
    """A job simulated along its tool axis, with its crashes and collisions."""

    job: SimulatedJob
    zbuffer: ZBuffer  # the z-buffer after the last trajectory
    checked: CrashCheck
    collisions: Collisions
    measured: Volumes | None  # the removed volumes; None if measuring them would exceed the time budget
    seen: SeenModel | None  # the model, seen along the tool axis; None without a model

    def facts(self, tolerance: float, going_on: Callable[[], None] = lambda: None) -> JobFacts:
        """Return what the simulation found in the operations, and the verdict on the job; see `core.zbuffer.facts`.

        `going_on` is called many times a second during most of the work. If `going_on` raises an exception, the work
        ends.
        """
        thin, seen = None, self.seen
        if seen is not None:
            seconds = preferences.read().time_budget / 4
            thin = thin_gouges(
                self.job.cuts, self.job.stock, seen, tolerance=tolerance, seconds=seconds, going_on=going_on
            )
        found = facts(
            self.zbuffer, self.checked, self.measured, thin, model=seen, tolerance=tolerance, collisions=self.collisions
        )
        return replace(found, verdict=replace(found.verdict, unread=self.job.unread))


def simulate_along_axis(
    job: SimulatedJob, memory_budget: float, going_on: Callable[[float], None] = lambda _: None
) -> AlongAxis:
    """Simulate a job along its tool axis, as finely as is useful and as the budgets allow, and check its rapids.

    The time budget comes from the preferences. `going_on` is called many times a second with the completed share of the
    simulation, 0 to 1. If `going_on` raises an exception, the simulation ends. `OverBudget` is raised if the memory,
    bytes, is too small even for an image of one pixel.
    """
    end = time.monotonic() + preferences.read().time_budget
    zbuffer = zbuffer_along_axis(job, memory_budget, going_on)

    def left() -> dict[str, Any]:
        return {"seconds": max(end - time.monotonic(), 0.0), "going_on": lambda: going_on(1.0)}

    checked = check_crashes(job.cuts, job.stock, **left())
    collisions = holder_collisions(zbuffer.cuts, job.stock, clamps=job.clamps, going_on=lambda: going_on(1.0))
    measured = measure_volumes(job.cuts, job.stock, **left())
    seen = None if job.model is None else SeenModel(job.model, zbuffer.frame, lambda: going_on(1.0))
    return AlongAxis(job, zbuffer, checked, collisions, measured, seen)


def zbuffer_along_axis(job: SimulatedJob, memory_budget: float, going_on: Callable[[float], None]) -> ZBuffer:
    """Simulate a job along its tool axis, as finely as is useful, in half of the time budget.

    The arguments are those of `simulate_along_axis`.
    """
    seconds = preferences.read().time_budget
    view = axis_view(job.cuts, job.stock, memory_bytes=memory_budget, seconds=seconds / 2, speed=known_speed())
    while True:
        try:
            return simulate_job(job.cuts, stock=job.stock, view=view, memory_budget=memory_budget, going_on=going_on)
        except OverBudget as refused:
            if refused.size is None:
                raise
            view = view.of_size(*refused.size)
