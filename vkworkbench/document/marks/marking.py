# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write the results of a report as marks in the tree, and clear marks: one undo step for each document."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import nullcontext

import FreeCAD

from vkworkbench import preferences
from vkworkbench.document.job import results
from vkworkbench.document.job.fingerprint import Settings, path_and_setting, path_fingerprint
from vkworkbench.document.job.operations import (
    find,
    has_toolpath,
    is_document,
    is_group,
    is_object,
    kind,
    members,
    or_active_document,
)
from vkworkbench.document.job.undo_step import transaction
from vkworkbench.document.marks import marks
from vkworkbench.given import of_kind
from vkworkbench.report import JobVerdict, OperationReport, Report


def mark(report: Report, *, undo_step: bool = True) -> int:
    """Mark the operations of a report, and their jobs with totals and verdicts, as one undo step for each document.

    Operations that have changed since the analysis are marked as outdated. If `undo_step` is False, the user cannot
    undo the marking, and steps that the user has undone before can still be redone. The result is the number of marked
    operations. Operations that were deleted, or whose document was closed, are skipped.
    """
    of_kind("report", report, Report, "the Report that analyze returns")
    marked = 0
    by_document: dict[str, list[OperationReport]] = {}
    verdicts: dict[str, dict[str, JobVerdict]] = {}
    for (name, job), verdict in report.verdicts.items():
        verdicts.setdefault(name, {})[job] = verdict
    for operation in report.operations:
        by_document.setdefault(operation.document, []).append(operation)
    for name, operations in by_document.items():
        document = FreeCAD.listDocuments().get(name)
        if document is None or document.Uid != operations[-1].document_id:
            continue
        with transaction(document, "Analyze Toolpaths") if undo_step else nullcontext():
            marked += _mark(document, operations, verdicts.get(name, {}))
    return marked


def _mark(document, operations: list[OperationReport], verdicts: dict[str, JobVerdict]) -> int:
    chosen, settings = preferences.read(), Settings()
    results.remember(operations)
    marked = set()
    for operation in operations:
        obj = document.getObject(operation.name)
        if obj is not None and has_toolpath(obj):  # a link's mark in the tree is on the linked object
            path, setting = path_and_setting(operation.fingerprint)
            # The fingerprint of a path is empty if the path could not be read, for example for lack of memory.
            fits = setting in settings.of(obj) and (not path or path_fingerprint(obj) == path)
            marks.write(obj, operation, chosen, outdated=not fits)
            marked.add(obj.Name)
    for job in _jobs(document):
        marks.write_total(job, chosen, verdicts.get(job.Name))
    return len(marked)


def clear(what=None) -> int:
    """Remove all marks of a document, a job or operations, as one undo step for each document.

    Parameters
    ----------
    what : Document, DocumentObject, or iterable of these objects, optional
        None stands for the active document.

    Returns
    -------
    int
        Number of objects that had a mark.

    Raises
    ------
    ValueError
        If `what` is None and no document is open.
    ReferenceError
        If an object was deleted, or a document closed.
    TypeError
        If `what` is of another type.
    """
    marked: dict[str, dict] = {}
    for obj in _with_jobs(or_active_document(what)):
        if marks.is_marked(obj):
            marked.setdefault(obj.Document.Name, {})[obj.Name] = obj
    for name, objects in marked.items():
        with transaction(FreeCAD.getDocument(name), "Clear Analysis"):
            for obj in objects.values():
                marks.erase(obj)
    return sum(map(len, marked.values()))


def _jobs(document) -> list:
    return [obj for obj in document.Objects if kind(obj) == "job"]


def _with_jobs(what) -> Iterator:
    """Yield the operations of `what` and their jobs, also jobs without operations."""
    chosen = list(what) if isinstance(what, Iterable) else [what]
    operations = find(chosen)
    for one in chosen:
        if is_document(one):
            yield from (obj for obj in one.Objects if kind(obj))
        elif is_object(one) and kind(one) == "job":
            yield one
        elif is_object(one) and is_group(one):
            yield from (obj for obj in members(one) if kind(obj) == "job")
    for operation in operations:
        yield operation.object
        if operation.job is not None:
            yield operation.job
