# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was found last in each open document: the panel shows it."""

from __future__ import annotations

import FreeCAD

from vkworkbench import preferences
from vkworkbench.document.operations import find
from vkworkbench.report import OperationReport, Report

_found: dict[str, dict[str, OperationReport]] = {}
_jobs: dict[tuple[str, str], str] = {}
_fixtures: dict[tuple[str, str], int] = {}


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
    _jobs.update(report.jobs)
    _fixtures.update(report.fixtures)


def report_of(document) -> Report:
    """Return the latest findings on the operations that a document has now, in their order; none without a document."""
    known = _found.get(document.Name, {}) if document is not None else {}
    operations = tuple(known[o.object.Name] for o in find(document) if o.object.Name in known) if known else ()
    jobs = {(o.document, o.job): _jobs[o.document, o.job] for o in operations if o.job is not None}
    return Report(operations, jobs, preferences.read().budget, {job: _fixtures.get(job, 1) for job in jobs})
