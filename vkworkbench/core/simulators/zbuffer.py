# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's extended z-buffer as one simulator among the others."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from vkworkbench.core.simulators.simulator import Conditions, Task
from vkworkbench.core.zbuffer import Estimate, estimate
from vkworkbench.core.zbuffer import most_bytes as most_bytes_of

NAME = "z-buffer"


@dataclass(frozen=True)
class ZBufferCost:
    """What one operation takes, as far as it is kept, or several one after another.

    Attributes
    ----------
    seconds, memory_bytes, factor, stock_bytes : float
        As of :class:`~vkworkbench.core.zbuffer.Estimate`.
    """

    seconds: float
    memory_bytes: float
    factor: float
    stock_bytes: float


def predict(task: Task, conditions: Conditions) -> Estimate:
    """Estimate the simulation for the image of the conditions."""
    tool, stock = task.cutting
    return estimate(
        task.toolpath, task.recognition, tool=tool, stock=stock, view=conditions.view, speed=conditions.speed
    )


def together(costs: Sequence[Estimate]) -> ZBufferCost:
    """Add up the costs of several operations; their one z-buffer holds the stock once."""
    stock = max(cost.stock_bytes for cost in costs)
    return ZBufferCost(
        sum(cost.seconds for cost in costs),
        stock + sum(cost.memory_bytes - cost.stock_bytes for cost in costs),
        max(cost.factor for cost in costs),
        stock,
    )


def most_bytes(task: Task, conditions: Conditions) -> float:
    """Bound the memory of its records, bytes, in much less time than the estimate takes."""
    tool, stock = task.cutting
    return most_bytes_of(task.toolpath, tool=tool, stock=stock, view=conditions.view)
