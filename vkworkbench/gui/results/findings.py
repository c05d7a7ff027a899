# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of a document: its marks in the tree, and full reports of operations analysed in this session."""

from __future__ import annotations

from dataclasses import dataclass

from vkworkbench import preferences
from vkworkbench.document.job import results
from vkworkbench.document.job.operations import Operation, find, fixtures_of, jobs_of
from vkworkbench.document.marks.record import Record
from vkworkbench.document.simulation.faults import read_with_faults, with_faults
from vkworkbench.report import OperationReport, Report


@dataclass(frozen=True)
class Finding:
    """The results of one operation."""

    operation: Operation
    mark: Record  # the results that the mark of the operation stores
    # The same results with all numbers; None if the operation was not analysed in this session.
    report: OperationReport | None


def read_findings(document) -> list[Finding]:
    """Return the results of a document's marked operations, in the document's order; empty without a document."""
    found = []
    for operation in find(document) if document is not None else ():
        obj, mark = operation.object, read_with_faults(operation.object)
        if mark is not None:
            report = results.latest_row(obj, mark.fingerprint)
            found.append(Finding(operation, mark, report and with_faults(report, document.Name, obj.Name)))
    return found


def report_of(findings: list[Finding]) -> Report | None:
    """Return one report on these operations; None if an operation has a mark but was not analysed in this session."""
    operations = tuple(finding.report for finding in findings)
    if None in operations:
        return None
    jobs = jobs_of(finding.operation for finding in findings)
    labels = {key: job.Label for key, job in jobs.items()}
    fixtures = {key: fixtures_of(job) for key, job in jobs.items()}
    chosen = preferences.read()
    verdicts = {key: own.verdict for key, job in jobs.items() if (own := read_with_faults(job)) and own.verdict}
    return Report(operations, labels, chosen.budget, fixtures, verdicts=verdicts, simulator=chosen.simulator)
