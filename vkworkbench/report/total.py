# SPDX-License-Identifier: LGPL-2.1-or-later
"""Add up the operations of a job."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from vkworkbench.core import Strategy
from vkworkbench.core.simulators import SIMULATORS, ZBUFFER, Costs, together
from vkworkbench.core.zbuffer import CutFacts
from vkworkbench.language import Message
from vkworkbench.report.job_verdict import JobVerdict
from vkworkbench.report.operation import OperationReport, Setup
from vkworkbench.report.text_table import how_many, printable

_SAME = 0.1  # share of a total by which the sum of its operations may differ without a remark


@dataclass(frozen=True)
class Total(Costs):
    """The total of all posted operations of one job.

    Attributes
    ----------
    document, job, label : str
        Internal names of the document and the job, and the job's label.
    operations, trajectories : int
    length : float
        Cutting length for one work offset, mm.
    fixtures : int
        Number of work offsets of the job (G54 to G59). All operations are posted once for each work offset.
    machining_seconds : float
        Time of the moves with a known speed, the dwells and the setups, for all work offsets, s.
    machining_complete : bool
        Whether `machining_seconds` includes all moves. If False, `machining_seconds` is a lower bound.
    incomplete : bool
        Whether the cost of at least one operation is unknown, so that the costs are lower bounds.
    costs, advice : mapping
        Costs and recommended settings of the simulators, as in `Costs`, for one run of all operations. `costs` and
        `advice` are empty if no operation has a known cost.
    setup : Setup
        Time of tool changes and starts of the spindle, for all work offsets.
    simulated : CutFacts or None
        Facts of a simulation of all operations; None without a simulation.
    verdict : JobVerdict or None
        Verdict of the simulation of all operations; None without a simulation.
    """

    document: str
    job: str
    label: str
    operations: int
    trajectories: int
    length: float
    fixtures: int
    machining_seconds: float
    machining_complete: bool
    incomplete: bool
    costs: Mapping[str, Any]
    advice: Mapping[str, Any]
    setup: Setup = field(default_factory=Setup)
    simulated: CutFacts | None = None
    verdict: JobVerdict | None = None

    def __repr__(self) -> str:
        return f"<Total of {printable(self.label)}: {how_many(self.operations, 'operation')}>"

    @property
    def seconds(self) -> float:
        """Time of a simulation in the extended z-buffer, s; 0 if it is unknown."""
        cost = self.cost(ZBUFFER.name)
        return cost[0] if cost else 0

    @property
    def memory_bytes(self) -> float:
        """Memory of a simulation in the extended z-buffer, bytes; 0 if it is unknown."""
        cost = self.cost(ZBUFFER.name)
        return cost[1] if cost else 0

    def as_dict(self) -> dict[str, Any]:
        """Return the total as a dictionary of numbers and strings, in mm, s and bytes."""
        return {
            "document": self.document,
            "job": self.job,
            "label": self.label,
            "operations": self.operations,
            "trajectories": self.trajectories,
            "length": self.length,
            "fixtures": self.fixtures,
            "machining_seconds": self.machining_seconds,
            "machining_complete": self.machining_complete,
            "setup_seconds": self.setup.change,
            "seconds": self.seconds,
            "memory_bytes": self.memory_bytes,
            "incomplete": self.incomplete,
            **self.columns(),
            "simulated": self.simulated and self.simulated.as_dict(),
            "verdict": self.verdict and str(self.verdict),
            "messages": self.advice_messages(),
        }


def counted_in(operations: Iterable[OperationReport], document: str, job: str) -> list[OperationReport]:
    """Return the operations that a job's total includes."""
    return [o for o in operations if o.counted and (o.document, o.job) == (document, job)]


def total_of(
    document: str, job: str, label: str, counted: Sequence[Any], budget: dict[str, float] | None, fixtures: int = 1
) -> Total:
    """Return the total of operations that run one after another.

    Parameters
    ----------
    document, job, label : str
        As in :class:`Total`.
    counted : sequence of OperationReport or Record
        The posted operations, in their order.
    budget : dict or None
        As in :class:`Report`. Without a budget, the total contains no advice.
    fixtures : int
        Number of work offsets for which the operations are posted.
    """
    known = [o for o in counted if o.costs]
    costs: Mapping[str, Any]
    advice: Mapping[str, Any]
    if budget is None:
        each = {s: [o.costs[s.name] for o in known if s.name in o.costs] for s in SIMULATORS}
        costs, advice = {s.name: s.together(alone) for s, alone in each.items() if len(alone) == len(known) > 0}, {}
    else:
        stepover = min((o.stepover for o in known if o.stepover), default=None)
        labels = [o.label for o in known]
        costs, advice = together([o.costs for o in known], labels=labels, stepover=stepover, **budget)
    setup = fixtures * _setup_seconds(counted)
    return Total(
        document, job, label,
        operations=len(counted),
        trajectories=sum(o.trajectories for o in counted),
        length=sum(o.length for o in counted),
        fixtures=fixtures,
        machining_seconds=fixtures * sum(o.machining_seconds or 0.0 for o in counted) + setup,
        machining_complete=not any(o.left_out for o in counted),
        incomplete=any(map(has_unknown_cost, counted)),
        costs=costs,
        advice=advice,
        setup=Setup("", bool(counted) and all(o.setup.planned for o in counted), setup),
    )  # fmt: skip


def compare_setups(total: Total) -> Message | None:
    """Return why the machining time of a job is more than the sum of its operations; None if it is the sum."""
    return Message("setups-in-total", time=total.setup.change) if total.setup.change else None


def compare_with_sum(total: Costs, parts: Iterable[Costs], simulator: str) -> Message | None:
    """Return why the simulation time of a job is not the sum of its operations; None if it is the sum, or unknown."""
    cost, alone = total.cost(simulator), [part.cost(simulator) for part in parts]
    sum_of_parts = sum(one[0] for one in alone if one is not None)
    if cost is None or not sum_of_parts or abs(cost[0] - sum_of_parts) < _SAME * cost[0]:
        return None
    more = cost[0] > sum_of_parts
    return Message("more-than-sum", simulator=simulator) if more else Message("less-than-sum", simulator=simulator)


def _setup_seconds(counted: Sequence[Any]) -> float:
    """Return the time of tool changes and starts of the spindle, s. The first tool needs no tool change."""
    setups = [o.setup for o in counted if o.setup.tool]
    changes = [new for old, new in zip(setups, setups[1:]) if new.tool != old.tool]
    return sum(setup.spindle for setup in (*setups[:1], *changes)) + sum(setup.change for setup in changes)


def has_unknown_cost(operation: Any) -> bool:
    """Return whether the operation of an OperationReport or Record has moves, but no known cost."""
    return operation.trajectories > 0 and operation.strategy is not Strategy.EMPTY and not operation.costs
