# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an analysis found: plain data, printed as a table, saved as CSV or JSON."""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from vkworkbench.core.simulators import ZBUFFER
from vkworkbench.core.zbuffer import CutFacts
from vkworkbench.given import check_file_name, of_kind
from vkworkbench.report.operation import OperationReport, cells_of
from vkworkbench.report.simulation_facts import SimulationFacts
from vkworkbench.report.table import table_of
from vkworkbench.report.text_table import how_many
from vkworkbench.report.total import Total, counted_in, total_of

_NO_UTF8 = "surrogateescape"  # the name of a file may hold bytes that are none


class Cancelled(Exception):
    """The analysis was cancelled; nothing has been changed."""


@dataclass(frozen=True)
class Report:
    """All operations analysed, in the order of their jobs: going through it gives them one by one.

    Attributes
    ----------
    operations : tuple of OperationReport
    jobs : dict
        Label of each job by (document name, job name).
    budget : dict
        Of memory and time, as `best_resolution` takes it.
    fixtures : dict
        How often each job's operations are posted, where that is known, likewise.
    simulated : dict
        What a simulation told of each job as a whole, where there was one, likewise.
    simulator : str
        Whose time and memory the table shows, as of :meth:`Costs.cost`: where there are marks, that of the marks.
    """

    operations: tuple[OperationReport, ...]
    jobs: dict[tuple[str, str], str]
    budget: dict[str, float]
    fixtures: dict[tuple[str, str], int] = field(default_factory=dict)
    simulated: dict[tuple[str, str], CutFacts] = field(default_factory=dict)
    simulator: str = ZBUFFER.name

    def with_facts(self, facts: SimulationFacts) -> Report:
        """Return the report with what a simulation told of its operations, and of the job if all of it was simulated.

        Of what has another toolpath, tool or stock now than it had in the simulation nothing is told.

        Parameters
        ----------
        facts : SimulationFacts
            ``vkworkbench.simulate(job).facts()``.

        Raises
        ------
        TypeError
            If `facts` is something else, as the simulation itself is.
        """
        of_kind("facts", facts, SimulationFacts, "what a simulation's facts() returns")
        told = {
            (*names, fingerprint): of_one
            for names, fingerprint, (_, of_one) in zip(facts.names, facts.fingerprints, facts.operations)
        }
        operations = tuple(
            replace(o, simulated=told.get((o.document, o.name, o.fingerprint), o.simulated)) for o in self.operations
        )
        jobs = {}
        for key in self.jobs:
            cutting = [o for o in counted_in(self.operations, *key) if o.trajectories]
            if {(o.document, o.name, o.fingerprint) for o in cutting} == set(told):
                jobs[key] = facts.job
        return replace(self, operations=operations, simulated={**self.simulated, **jobs})

    @property
    def totals(self) -> tuple[Total, ...]:
        """One total for each job, nothing counted twice."""
        return tuple(self._total(*key, label) for key, label in self.jobs.items())

    def _total(self, document: str, job: str, label: str) -> Total:
        counted = counted_in(self.operations, document, job)
        total = total_of(document, job, label, counted, self.budget, self.fixtures.get((document, job), 1))
        return replace(total, simulated=self.simulated.get((document, job)))

    def __repr__(self) -> str:
        """Return what stands in a console where somebody asks for the report itself: printed it is the table."""
        return f"<Report of {how_many(len(self), 'operation')}>"

    def __iter__(self) -> Iterator[OperationReport]:
        return iter(self.operations)

    def __len__(self) -> int:
        return len(self.operations)

    def __str__(self) -> str:
        if not self.operations:
            return "No operations found."
        return table_of(self.operations, self.totals, self.simulator)

    def to_csv(self, path: str | os.PathLike[str]) -> None:
        """Write one line for each operation, with a header, in mm, s, rad and bytes; see `cells_of`."""
        check_file_name(path)
        rows = [cells_of(operation) for operation in self.operations]
        names = list(rows[0]) if rows else ["document", "name", "label", "strategy"]
        with open(path, "w", newline="", encoding="utf-8", errors=_NO_UTF8) as file:
            writer = csv.DictWriter(file, names, quoting=csv.QUOTE_NONNUMERIC)
            writer.writeheader()
            writer.writerows(rows)

    def to_json(self, path: str | os.PathLike[str]) -> None:
        """Write the operations and the totals of their jobs, in mm, s, rad and bytes."""
        check_file_name(path)
        data = {
            "operations": [o.as_dict() for o in self.operations],
            "totals": [t.as_dict() for t in self.totals],
        }
        with open(path, "w", encoding="utf-8", errors=_NO_UTF8) as file:
            json.dump(data, file, indent=1, ensure_ascii=False)
