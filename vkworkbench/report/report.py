# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of an analysis as plain data, which can be printed as a table and saved as CSV or JSON."""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from vkworkbench.core.simulators import ZBUFFER
from vkworkbench.core.zbuffer import CutFacts
from vkworkbench.given import check_file_name, of_kind
from vkworkbench.report.job_verdict import JobVerdict
from vkworkbench.report.operation import OperationReport, cells_of
from vkworkbench.report.simulation_facts import SimulationFacts
from vkworkbench.report.spreadsheet import as_cell
from vkworkbench.report.table import table_of
from vkworkbench.report.text_table import files_left_out, how_many
from vkworkbench.report.total import Total, counted_in, total_of

_NO_UTF8 = "surrogateescape"  # with this error handler, file names that are not UTF-8 are written with unchanged bytes


class Cancelled(Exception):
    """The analysis was cancelled, and has changed nothing."""


@dataclass(frozen=True)
class Report:
    """All analysed operations, in the order of their jobs. Iterating over the report yields the operations.

    Attributes
    ----------
    operations : tuple of OperationReport
    jobs : dict
        Label of each job, by (document name, job name).
    budget : dict
        Limits of memory and time, as arguments of `best_resolution`.
    fixtures : dict
        Number of work offsets for which the operations of a job are posted, by (document name, job name). Jobs with an
        unknown number of work offsets are missing.
    simulated : dict
        Facts of a simulation of the whole job, by (document name, job name). Jobs without a simulation have no entry in
        the dictionary.
    verdicts : dict
        The `JobVerdict` of a simulation of the whole job, by (document name, job name). Jobs without a verdict are
        missing.
    simulator : str
        Name of the simulator whose time and memory the table shows. The marks in the tree show the time of this
        simulator.
    left_out : tuple of str
        Files in folders that were not analysed, because they do not look like NC programs.
    """

    operations: tuple[OperationReport, ...]
    jobs: dict[tuple[str, str], str]
    budget: dict[str, float]
    fixtures: dict[tuple[str, str], int] = field(default_factory=dict)
    simulated: dict[tuple[str, str], CutFacts] = field(default_factory=dict)
    verdicts: dict[tuple[str, str], JobVerdict] = field(default_factory=dict)
    simulator: str = ZBUFFER.name
    left_out: tuple[str, ...] = ()

    def with_facts(self, facts: SimulationFacts) -> Report:
        """Return the report with the facts of a simulation.

        An operation gets facts only if its toolpath, tool and stock equal the simulated toolpath, tool and stock. A job
        gets facts and a verdict only if all its operations were simulated, except for operations that `facts` lists as
        left out.

        Parameters
        ----------
        facts : SimulationFacts
            ``vkworkbench.simulate(job).facts()``.

        Raises
        ------
        TypeError
            If `facts` has another type, for example if `facts` is the simulation itself.
        """
        of_kind("facts", facts, SimulationFacts, "what a simulation's facts() returns")
        known = {
            (*names, fingerprint): cut_facts
            for names, fingerprint, (_, cut_facts) in zip(facts.names, facts.fingerprints, facts.operations)
        }
        operations = tuple(
            replace(o, simulated=known.get((o.document, o.name, o.fingerprint), o.simulated)) for o in self.operations
        )
        jobs, verdicts = {}, {}
        for key in self.jobs:
            cutting = [o for o in counted_in(self.operations, *key) if o.trajectories]
            simulated = [o for o in cutting if (o.document, o.name) not in facts.left_out]
            if {(o.document, o.name, o.fingerprint) for o in simulated} == set(known):
                jobs[key] = facts.job
                verdicts[key] = JobVerdict(facts.sentence, facts.valid_for)
        return replace(
            self, operations=operations, simulated={**self.simulated, **jobs}, verdicts={**self.verdicts, **verdicts}
        )

    @property
    def totals(self) -> tuple[Total, ...]:
        """The total of each job."""
        return tuple(self._total(*key, label) for key, label in self.jobs.items())

    def _total(self, document: str, job: str, label: str) -> Total:
        counted = counted_in(self.operations, document, job)
        total = total_of(document, job, label, counted, self.budget, self.fixtures.get((document, job), 1))
        key = document, job
        return replace(total, simulated=self.simulated.get(key), verdict=self.verdicts.get(key))

    def _verdict_on_job_of(self, operation: OperationReport) -> str | None:
        verdict = self.verdicts.get((operation.document, operation.job or ""))
        return None if verdict is None else as_cell(str(verdict))

    def __repr__(self) -> str:
        """Return one line for consoles. `print` prints the whole table."""
        return f"<Report of {how_many(len(self), 'operation')}>"

    def __iter__(self) -> Iterator[OperationReport]:
        return iter(self.operations)

    def __len__(self) -> int:
        return len(self.operations)

    def __str__(self) -> str:
        table = table_of(self.operations, self.totals, self.simulator) if self.operations else "No operations found."
        return f"{table}\n{files_left_out(self.left_out)}" if self.left_out else table

    def to_csv(self, path: str | os.PathLike[str]) -> None:
        """Write a CSV file with a header and one line for each operation, in mm, s, rad and bytes; see `cells_of`.

        The column ``verdict`` contains the verdict of a simulation on the operation's job.
        """
        check_file_name(path)
        rows = [{**cells_of(one), "verdict": self._verdict_on_job_of(one)} for one in self.operations]
        names = list(rows[0]) if rows else ["document", "name", "label", "strategy"]
        with open(path, "w", newline="", encoding="utf-8", errors=_NO_UTF8) as file:
            writer = csv.DictWriter(file, names, quoting=csv.QUOTE_NONNUMERIC)
            writer.writeheader()
            writer.writerows(rows)

    def to_json(self, path: str | os.PathLike[str]) -> None:
        """Write a JSON file with the operations and the totals of their jobs, in mm, s, rad and bytes."""
        check_file_name(path)
        data = {
            "operations": [o.as_dict() for o in self.operations],
            "totals": [t.as_dict() for t in self.totals],
            "left_out": list(self.left_out),
        }
        with open(path, "w", encoding="utf-8", errors=_NO_UTF8) as file:
            json.dump(data, file, indent=1, ensure_ascii=False)
