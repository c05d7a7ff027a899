# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is known of the operations of a document: what the marks keep, and all of it where it was analysed in this session."""

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
    """What is known of one operation.

    Attributes
    ----------
    operation : Operation
    mark : Record
        What its mark says: what is shown.
    report : OperationReport or None
        That from which the mark was made, with all its numbers; None where the document was opened with the mark.
    """

    operation: Operation
    mark: Record
    report: OperationReport | None


def findings(document) -> list[Finding]:
    """Return what is known of the marked operations that a document has now, in their order; none without a document."""
    known = []
    for operation in find(document) if document is not None else ():
        obj, mark = operation.object, read_with_faults(operation.object)
        if mark is not None:
            report = results.latest_row(obj, mark.fingerprint)
            known.append(Finding(operation, mark, report and with_faults(report, document.Name, obj.Name)))
    return known


def report_of(known: list[Finding]) -> Report | None:
    """Return the report with all numbers of these operations; None where some have only their mark."""
    operations = tuple(finding.report for finding in known)
    if None in operations:
        return None
    jobs = jobs_of(finding.operation for finding in known)
    labels = {key: job.Label for key, job in jobs.items()}
    fixtures = {key: fixtures_of(job) for key, job in jobs.items()}
    chosen = preferences.read()
    return Report(operations, labels, chosen.budget, fixtures, simulator=chosen.simulator)
