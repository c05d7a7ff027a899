# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write what a report found as marks, and clear marks again: one undo step for each document."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager, nullcontext

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
from vkworkbench.document.marks import marks
from vkworkbench.given import of_kind
from vkworkbench.report import OperationReport, Report


def mark(report: Report, *, undo_step: bool = True) -> int:
    """Write a report's findings on its operations and the totals on their jobs, one undo step a document.

    What has changed since the analysis is marked as outdated.

    Parameters
    ----------
    report : Report
    undo_step : bool
        Whether it is a step that the user can undo; else he can still redo what he has undone.

    Returns
    -------
    int
        How many operations were marked; one that was deleted or closed since the analysis is passed over.

    Raises
    ------
    TypeError
        If `report` is no report.
    """
    of_kind("report", report, Report, "the Report that analyze returns")
    marked = 0
    by_document: dict[str, list[OperationReport]] = {}
    for operation in report.operations:
        by_document.setdefault(operation.document, []).append(operation)
    for name, operations in by_document.items():
        document = FreeCAD.listDocuments().get(name)
        if document is None or document.Uid != operations[-1].document_id:
            continue
        with transaction(document, "Analyze toolpaths") if undo_step else nullcontext():
            marked += _mark(document, operations)
    return marked


def _mark(document, operations: list[OperationReport]) -> int:
    chosen, settings = preferences.read(), Settings()
    results.remember(operations)
    marked = set()
    for operation in operations:
        obj = document.getObject(operation.name)
        if obj is not None and has_toolpath(obj):  # a link has the mark of what it links to
            path, setting = path_and_setting(operation.fingerprint)
            # A path that could not be read, as one for which memory does not suffice, is not read here.
            fits = setting in settings.of(obj) and (not path or path_fingerprint(obj) == path)
            marks.write(obj, operation, chosen, outdated=not fits)
            marked.add(obj.Name)
    for job in _jobs(document):
        marks.write_total(job, chosen)
    return len(marked)


def clear(what=None) -> int:
    """Remove all marks of a document, a job or operations, one undo step a document; nothing else changes.

    Parameters
    ----------
    what : Document, DocumentObject, or iterable of them, optional
        The active document if None.

    Returns
    -------
    int
        How many objects lost a mark.

    Raises
    ------
    ValueError
        If `what` is None and no document is open.
    ReferenceError
        If an object of it was deleted, or its document closed.
    TypeError
        If `what` is something else.
    """
    marked: dict[str, dict] = {}
    for obj in _with_jobs(or_active_document(what)):
        if marks.is_marked(obj):
            marked.setdefault(obj.Document.Name, {})[obj.Name] = obj
    for name, objects in marked.items():
        with transaction(FreeCAD.getDocument(name), "Clear analysis"):
            for obj in objects.values():
                marks.erase(obj)
    return sum(map(len, marked.values()))


@contextmanager
def transaction(document, name: str):
    """Make changes as one undo step, undone if one fails; where a step is open already they become part of it."""
    if document.HasPendingTransaction or FreeCAD.getActiveTransaction():
        yield
        return
    document.openTransaction(name)
    try:
        yield
    except BaseException:
        FreeCAD.closeActiveTransaction(True)
        raise
    # The document's own commit would leave the step open where nothing changed or the document keeps no undo steps;
    # the user's next changes, in any document, would then be part of it.
    FreeCAD.closeActiveTransaction()


def _jobs(document) -> list:
    return [obj for obj in document.Objects if kind(obj) == "job"]


def _with_jobs(what) -> Iterator:
    """The operations that `what` stands for and their jobs, also a job without operations."""
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
