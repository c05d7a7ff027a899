# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was found in each open document: what the marks keep, and all of it where it was analysed in this session."""

from __future__ import annotations

from dataclasses import dataclass

import FreeCAD

from vkworkbench import preferences
from vkworkbench.document.operations import Operation, find, fixtures_of
from vkworkbench.document.record import Record
from vkworkbench.document.simulated_faults import read_with_faults, with_faults
from vkworkbench.report import OperationReport, Report

_found: dict[str, dict[str, OperationReport]] = {}


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


class _Closing:
    """Forgets what was found in a document that is closed: another one may get its name."""

    def slotDeletedDocument(self, document) -> None:
        _found.pop(document.Name, None)


_closing: _Closing | None = None


def remember(report: Report) -> None:
    """Keep a report; operations that are not in it keep what was found before."""
    global _closing
    if _closing is None:
        _closing = _Closing()
        FreeCAD.addDocumentObserver(_closing)
    for operation in report.operations:
        _found.setdefault(operation.document, {})[operation.name] = operation


def findings(document) -> list[Finding]:
    """Return what is known of the marked operations that a document has now, in their order; none without a document."""
    found = []
    for operation in find(document) if document is not None else ():
        name, mark = operation.object.Name, read_with_faults(operation.object)
        if mark is not None:
            report = _found.get(document.Name, {}).get(name)
            same = report is not None and report.fingerprint == mark.fingerprint
            found.append(Finding(operation, mark, with_faults(report, document.Name, name) if same else None))
    return found


def report_of(found: list[Finding]) -> Report | None:
    """Return the report with all numbers of these operations; None where some have only their mark."""
    operations = tuple(finding.report for finding in found)
    if None in operations:
        return None
    jobs = {o.job.Name: o.job for o in (finding.operation for finding in found) if o.job is not None}
    keys = {(job.Document.Name, name): job for name, job in jobs.items()}
    labels, fixtures = {k: job.Label for k, job in keys.items()}, {k: fixtures_of(job) for k, job in keys.items()}
    return Report(operations, labels, preferences.read().budget, fixtures)
