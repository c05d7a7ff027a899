# SPDX-License-Identifier: LGPL-2.1-or-later
"""Provide the functions for the entry of the paper's extended z-buffer in the table of simulators."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from vkworkbench.core.simulators.simulator import Conditions, Task
from vkworkbench.core.stocks import Solid, is_same
from vkworkbench.core.view import View
from vkworkbench.core.zbuffer import Cut, Estimate, Resolution, Speed, best_resolution, estimate, estimate_job
from vkworkbench.core.zbuffer import most_bytes as most_bytes_of

NAME = "z-buffer"
# Number of jobs whose estimates are cached. Without the cache, the total of a job would be estimated every time it is
# shown.
_JOBS = 8


@dataclass(frozen=True)
class ZBufferCost:
    """The values of an estimate that an operation's mark in the tree stores, or their sums over several estimates."""

    # seconds, memory_bytes, factor, stock_bytes: see the attributes with the same names in
    # :class:`~vkworkbench.core.zbuffer.Estimate`.
    seconds: float
    memory_bytes: float
    factor: float
    stock_bytes: float


def predict(task: Task, conditions: Conditions) -> Estimate:
    """Estimate the cost of simulating one operation in the z-buffer, with the image of `conditions.view`."""
    tool, stock = task.cutting
    return estimate(
        task.toolpath, task.recognition, tool=tool, stock=stock, view=conditions.view, speed=conditions.speed
    )


def together(costs: Sequence[Estimate | ZBufferCost]) -> Estimate | ZBufferCost:
    """Estimate the cost of several operations in one z-buffer, in which each operation cuts the remaining stock.

    If the cost of an operation is known only from its mark in the tree, or if the operations have different stocks or
    images, the costs are added instead. The sum includes the stock once, but material that two operations cut is
    counted twice.
    """
    if len(costs) == 1:
        return costs[0]
    estimates = [cost for cost in costs if isinstance(cost, Estimate)]
    common = _common(estimates) if len(estimates) == len(costs) else None
    if common is not None:
        return _of_job(tuple(cut for cost in estimates for cut in cost.cuts), *common)
    stock = max(cost.stock_bytes for cost in costs)
    return ZBufferCost(
        sum(cost.seconds for cost in costs),
        stock + sum(cost.memory_bytes - cost.stock_bytes for cost in costs),
        max(cost.factor for cost in costs),
        stock,
    )


def _common(estimates: Sequence[Estimate]) -> tuple[Solid, View, Speed] | None:
    """Return the stock, the view and the computer's speed of all estimates; None if one of the three differs."""
    (view, speed), *more = {(one.view, one.speed) for one in estimates}
    stock, *others = (one.stock for one in estimates)
    if more or stock is None or not all(other is not None and is_same(stock, other) for other in others):
        return None
    return stock, view, speed


@lru_cache(_JOBS)
def _of_job(cuts: tuple[Cut, ...], stock: Solid, view: View, speed: Speed) -> Estimate:
    return estimate_job(cuts, stock=stock, view=view, speed=speed)


def finest_image(costs: Sequence[Estimate], **asked: Any) -> Resolution:
    """Choose the image with the smallest pixels within a budget for operations in sequence; see `best_resolution`."""
    whole = together(costs)
    return best_resolution(costs, whole=whole if isinstance(whole, Estimate) else None, **asked)


def most_bytes(task: Task, conditions: Conditions) -> float:
    """Return an upper bound of an operation's memory, bytes.

    The upper bound of the memory takes much less time to compute than an estimate.
    """
    tool, stock = task.cutting
    return most_bytes_of(task.toolpath, tool=tool, stock=stock, view=conditions.view)
