# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the operations of a document, by the properties and the TypeId of its objects.

The proxies of objects and their class names are not used: they differ between FreeCAD versions, and can be missing in a
file that another version saved.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

import FreeCAD

from vkworkbench import freecad
from vkworkbench.language import ENGLISH, Message, Unusable


@dataclass(frozen=True)
class Operation:
    """One operation to analyse."""

    # The object with the toolpath. In a job's group the object can be a link; then the linked object has the mark.
    object: object
    # The job of the operation; None for a toolpath that was imported without a job.
    job: object | None = field(default=None)
    # Whether the job's total includes the operation. The total includes each posted operation once.
    counted: bool = True
    # Whether FreeCAD posts the operation: neither the operation nor its dressed-up base is switched off.
    active: bool = True


def kind(obj) -> str | None:
    """Return "job", "group", "controller", "dressup", "array", "operation", or None for an object without a toolpath.

    A group repeats the toolpaths of its members. Before FreeCAD 0.20 a job kept its operations in a group.
    """
    if not has_toolpath(obj):
        return None
    if _is_job(obj):
        return "job"
    if obj.isDerivedFrom(freecad.COMPOUND) or is_job_group(obj):
        return "group"
    if freecad.TOOL_NUMBER.is_in(obj) and freecad.SPINDLE_SPEED.is_in(obj):
        return "controller"
    if _bases(obj):
        # FreeCAD posts an array (or a copy) and its base, but not the base of a dress-up.
        beside = freecad.COPIES.is_in(obj) or freecad.operation_name(obj) == "Copy"
        return "array" if beside else "dressup"
    return "operation"


def is_operation(obj) -> bool:
    """Return whether an object is an operation, a dress-up or an array."""
    return kind(obj) in ("operation", "dressup", "array")


def names_of(obj) -> tuple[str, str]:
    """Return the internal names of an object's document and of the object."""
    return obj.Document.Name, obj.Name


def has_toolpath(obj) -> bool:
    """Return whether an object has a toolpath, as operations, dress-ups and jobs have."""
    return obj.isDerivedFrom(freecad.TOOLPATH)


def _links_operation(obj) -> bool:
    """Return whether an object is a link to an operation. FreeCAD posts a link in a job's group as another operation."""
    return obj.isDerivedFrom(freecad.LINK) and is_operation(obj.getLinkedObject())


def is_object(what) -> bool:
    """Return whether a value is an object of a document. A property in a file can contain a value of any type."""
    return hasattr(what, "isDerivedFrom") and hasattr(what, "InList")


def is_there(obj) -> bool:
    """Return whether an object is still in its document. After a deletion that can be undone, an object has no name."""
    try:
        return obj.Document.getObject(obj.Name) is not None
    except (ReferenceError, RuntimeError, TypeError):
        return False


def is_gone(what) -> bool:
    """Return whether a value is a closed document or a deleted object.

    A macro can still hold a closed document or a deleted object.
    """
    try:
        return not is_document(what) and is_object(what) and not is_there(what)
    except ReferenceError:  # reading any attribute of a closed document raises this error
        return True


def is_document(what) -> bool:
    """Return whether a value is a document."""
    return hasattr(what, "Objects") and hasattr(what, "getObject")


def _is_job(obj) -> bool:
    return (
        has_toolpath(obj)
        and freecad.OPERATIONS.is_in(obj)
        and (freecad.TOOLS.is_in(obj) or freecad.CONTROLLER.is_in(obj))
    )


def is_job_group(obj) -> bool:
    """Return whether an object is the group of a job's operations, whatever its type."""
    return freecad.GROUP.is_in(obj) and any(_is_job(user) and freecad.OPERATIONS.of(user) is obj for user in obj.InList)


def members(group) -> Iterator:
    """Yield the members of a group or a list. A nested group is replaced by its members."""
    seen = set()
    pending = _listed(group)
    while pending:
        obj = pending.pop(0)
        if obj.Name not in seen:
            seen.add(obj.Name)
            if is_group(obj):
                pending[:0] = _listed(obj)
            else:
                yield obj


def _listed(group) -> list:
    members = group if isinstance(group, list) else freecad.GROUP.of(group)
    return [one for one in members if is_object(one)] if isinstance(members, list) else []


def is_group(obj) -> bool:
    """Return whether an object only groups others: a folder of the tree, a part, or a compound of toolpaths."""
    return any(map(obj.isDerivedFrom, ("App::DocumentObjectGroup", "App::Part"))) or kind(obj) == "group"


def or_active_document(what):
    """Return `what`, or the active document if it is None.

    A ValueError is raised if no document is open, and `Unusable` if FreeCAD is still reading a document, whose objects
    have no toolpaths yet.
    """
    if what is None:
        what = FreeCAD.ActiveDocument
    if what is None:
        raise ValueError("no document is open: open one with a job or a toolpath")
    for document in FreeCAD.listDocuments().values():
        if document.Restoring:
            raise Unusable(Message("document-is-read", document=document.Label))
    return what


def find(what) -> list[Operation]:
    """Return the operations of a document, a job, an operation, or a list of documents and objects.

    A document stands for all its jobs and the toolpaths outside the jobs. A job, or its group of operations, stands for
    the operations of the job. A folder stands for its members. Objects that are not listed here have no toolpath. The
    operations are in the order of posting, each once, a dress-up before its base. A ReferenceError is raised if an
    object was deleted, or a document closed.
    """
    return list(_once(_find(what, {})).values())


def _once(operations: Iterable[Operation]) -> dict[tuple[str, str], Operation]:
    """Return the first `Operation` for each object with a toolpath, by the names of document and object."""
    found: dict[tuple[str, str], Operation] = {}
    for operation in operations:
        found.setdefault(names_of(operation.object), operation)
    return found


def _find(what, jobs: dict) -> Iterator[Operation]:
    """Yield the operations of `what`. `jobs` caches the operations of each job, so that each job is searched once."""
    if is_gone(what):
        raise ReferenceError("what is asked for was deleted, or its document closed: take it from the document again")
    if is_document(what):
        yield from _of_document(what)
    elif is_object(what):
        yield from _of_object(what, jobs)
    elif isinstance(what, Iterable) and not isinstance(what, (str, bytes)):
        for one in what:
            yield from _find(one, jobs)
    else:
        raise TypeError(f"only a document, a job or operations have toolpaths, not {type(what).__name__}")


def _of_document(document) -> Iterator[Operation]:
    """Yield the operations of all jobs, then the other toolpaths."""
    for obj in document.Objects:
        if kind(obj) == "job":
            yield from _of_job(obj)
    for obj in document.Objects:
        if is_operation(obj):
            job = job_of(obj)
            # An operation that was not found above is not in the group of its job, so the job does not post it.
            yield from _with_bases(obj, job, counted=job is None)


def _of_object(obj, jobs: dict) -> Iterator[Operation]:
    """Yield the operations of a job, an operation or a group."""
    if kind(obj) == "job":
        yield from _of_job(obj)
    elif is_operation(obj):
        job = job_of(obj)
        if job is not None and names_of(job) not in jobs:
            jobs[names_of(job)] = _once(_of_job(job))
        listed = jobs[names_of(job)].get(names_of(obj)) if job is not None else None
        yield listed or next(_with_bases(obj, job, counted=job is None))
    elif is_job_group(obj):
        yield from _of_job(job_of(obj))
    elif is_group(obj):
        for member in members(obj):
            yield from _find(member, jobs)


def _of_job(job) -> Iterator[Operation]:
    """Yield the operations in the group of a job, and their bases."""
    posted = list(members(freecad.OPERATIONS.of(job)))
    # A file made without a window lists a dress-up and its base side by side.
    dressed = {base.Name for obj in posted if kind(obj) == "dressup" for base in _dressed(obj)}
    for obj in posted:
        if is_operation(obj):
            yield from _with_bases(obj, job, counted=obj.Name not in dressed)
        elif _links_operation(obj):
            active = is_active(obj)
            yield Operation(obj, job, active, active)
    for obj in posted:
        if kind(obj) == "array":  # if a dress-up has an array as base, the array's bases are no longer in the group
            for base in _bases(obj):
                yield from _with_bases(base, job, counted=False)


def _with_bases(obj, job, counted: bool) -> Iterator[Operation]:
    active = is_active(obj)
    yield Operation(obj, job, counted and active, active)
    if kind(obj) == "dressup":
        for base in _dressed(obj):
            yield Operation(base, job, False, is_active(base))


def _bases(obj) -> list:
    """Return the bases of a dress-up or an array; empty for an ordinary operation, whose Base lists model faces."""
    base = freecad.BASE.of(obj)
    candidates = base if isinstance(base, (list, tuple)) else [base]
    return [b for b in candidates if is_object(b) and has_toolpath(b)]


def all_bases(obj) -> Iterator:
    """Yield the bases of a dress-up or array, the bases of these bases, and so on; each object once."""
    seen = {obj.Name}
    pending = _bases(obj)
    while pending:
        base = pending.pop(0)
        if base.Name not in seen:
            seen.add(base.Name)
            yield base
            pending += _bases(base)


def _dressed(obj) -> Iterator:
    """Yield the bases that are not posted because a dress-up replaces them. The bases of an array are posted."""
    for base in all_bases(obj):
        yield base
        if kind(base) == "array":
            return


def posted(found: Sequence[Operation]) -> list[Operation]:
    """Return the operations that are posted; if no operation is posted by a job, the active operations."""
    return [o for o in found if o.counted] or [o for o in found if o.active]


def jobs_of(operations: Iterable[Operation]) -> dict[tuple[str, str], object]:
    """Return the jobs of operations, each once, by the names of document and job."""
    return {names_of(o.job): o.job for o in operations if o.job is not None}


def fixtures_of(job) -> int:
    """Return how often a job's operations are posted: once for each work offset (FreeCAD: fixture) of the job."""
    listed = freecad.FIXTURES.of(job)
    return max(len(listed), 1) if isinstance(listed, list) else 1


def cycle_seconds(job) -> int | None:
    """Return the machining time that FreeCAD has stored in a job, s; None if there is no readable time."""
    text = freecad.CYCLE_TIME.of(job)
    return ENGLISH.seconds_of(text) if isinstance(text, str) else None


def job_of(obj):
    """Return the job of an operation, also if only a dress-up of the operation is in the job's group."""
    seen = set()
    pending = [obj]
    while pending:
        one = pending.pop(0)
        if one.Name in seen:
            continue
        seen.add(one.Name)
        for user in one.InList:
            if kind(user) == "job":
                return user
            if is_group(user) or kind(user) in ("dressup", "array"):
                pending.append(user)
    return None


def through_bases(obj, wanted: freecad.Property):
    """Return a property of an operation or of its dressed-up base; None if both do not have the property."""
    for one in (obj, *all_bases(obj)):
        value = wanted.of(one)
        if value is not None:
            return value
    return None


def takes_tool(obj) -> bool:
    """Return whether an operation or its base needs a tool, even if its tool controller is not set."""
    return any(map(freecad.CONTROLLER.is_in, (obj, *all_bases(obj))))


def is_active(obj, _above: tuple[str, ...] = ()) -> bool:
    """Return whether an operation is switched on, and its bases too; for an array, one base is enough."""
    if not freecad.ACTIVE.of(obj, True):
        return False
    of_bases = [is_active(base, (*_above, obj.Name)) for base in _bases(obj) if base.Name not in _above]
    if of_bases and kind(obj) == "array":
        return any(of_bases)
    return all(of_bases)


def is_imported(obj) -> bool:
    """Return whether the toolpath of an object or of one of its bases possibly comes from a file."""
    return any(map(freecad.is_imported, (obj, *all_bases(obj))))
