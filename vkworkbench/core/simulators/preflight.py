# SPDX-License-Identifier: LGPL-2.1-or-later
"""Collect the warnings before a simulation is started: the warnings of each simulator, and of too much memory."""

from __future__ import annotations

from collections.abc import Mapping

from vkworkbench.core.simulators.simulator import WORST_FIRST, Caution, Conditions, Cost, Simulator, Task
from vkworkbench.core.simulators.table import available
from vkworkbench.language import Message


def preflight(task: Task, costs: Mapping[str, Cost], conditions: Conditions) -> tuple[Caution, ...]:
    """Return warnings of commands that a simulator handles wrongly, and of simulations with too much time or memory.

    Parameters
    ----------
    task : Task
        The operation to check. If `task.words` (the words of the operation's G-code commands) is None, the result does
        not include warnings of arcs that a simulator cannot cut. If the operation's tool is unknown, ramps are not
        checked.
    costs : mapping of str to Cost
        Predicted costs by the names of the simulators. If a cost is missing, time and memory in this simulator are not
        checked.

    Returns
    -------
    tuple of Caution
        The warnings, sorted with the worst first.
    """
    simulators = available(conditions.version)
    found = [c for s in simulators if s.cautions for c in s.cautions(task, costs.get(s.name), conditions)]
    for simulator in simulators:
        if _surely_fits(simulator, task, conditions):
            continue
        cost = costs.get(simulator.name)
        if cost is not None and cost.memory_bytes > conditions.memory_budget:
            what = Message(
                "memory", simulator=simulator.name, memory=cost.memory_bytes, allowed=conditions.memory_budget,
                instead=simulator.less_memory,
            )  # fmt: skip
            found.append(Caution("memory", what))
    rank = {code: k for k, code in enumerate(WORST_FIRST)}
    return tuple(sorted(found, key=lambda caution: rank.get(caution.code, len(rank))))


def _surely_fits(simulator: Simulator, task: Task, conditions: Conditions) -> bool:
    """Return whether an upper bound of the simulation's memory, computed quickly, is within the memory budget."""
    if simulator.most_bytes is None or not (task.tool and task.stock):
        return False
    return simulator.most_bytes(task, conditions) <= conditions.memory_budget
