# SPDX-License-Identifier: LGPL-2.1-or-later
"""The operations of a document, told apart by properties and TypeId.

Proxies and class names differ between FreeCAD versions, and a file from another version may have none.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

import FreeCAD

from vkworkbench import freecad


@dataclass(frozen=True)
class Operation:
    """One operation to analyse.

    Attributes
    ----------
    object : DocumentObject
        The object with the Path; in a job's group it may be a link to one, whose mark is that of the linked object.
    job : DocumentObject or None
        Its job; None for a toolpath imported without one.
    counted : bool
        Whether the job's total counts it: the total has what is posted, and nothing twice.
    active : bool
        Whether FreeCAD posts it, by its own switch or that of the operation it dresses up.
    """

    object: object
    job: object | None = field(default=None)
    counted: bool = True
    active: bool = True


def kind(obj) -> str | None:
    """Return "job", "group", "controller", "dressup", "array", "operation", or None for what has no toolpath.

    A group has the toolpaths of its members once more: before FreeCAD 0.20 a job kept its operations in one.
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
        beside = freecad.COPIES.is_in(obj) or freecad.operation_name(obj) == "Copy"  # its base is posted, too
        return "array" if beside else "dressup"
    return "operation"


def is_operation(obj) -> bool:
    """Whether it is an operation, or what stands for one: a dress-up or an array."""
    return kind(obj) in ("operation", "dressup", "array")


def names_of(obj) -> tuple[str, str]:
    """Return the internal names of an object's document and of the object, by which it is found again."""
    return obj.Document.Name, obj.Name


def has_toolpath(obj) -> bool:
    """Whether it is an object with a toolpath: an operation, a dress-up, a job."""
    return obj.isDerivedFrom(freecad.TOOLPATH)


def _links_operation(obj) -> bool:
    """Whether it is a link to an operation: in the group of a job FreeCAD posts it as one more operation."""
    return obj.isDerivedFrom(freecad.LINK) and is_operation(obj.getLinkedObject())


def is_object(what) -> bool:
    """Whether it is an object of a document; a property of a file may hold anything."""
    return hasattr(what, "isDerivedFrom") and hasattr(what, "InList")


def is_there(obj) -> bool:
    """Whether an object is still in its document: one whose deletion can be undone lives on outside, without a name."""
    try:
        return obj.Document.getObject(obj.Name) is not None
    except (ReferenceError, RuntimeError, TypeError):
        return False


def is_gone(what) -> bool:
    """Whether it is a document that was closed, or an object that was deleted, which a macro may still hold."""
    try:
        return not is_document(what) and is_object(what) and not is_there(what)
    except ReferenceError:  # FreeCAD tells nothing of it any more
        return True


def is_document(what) -> bool:
    """Whether it is a document."""
    return hasattr(what, "Objects") and hasattr(what, "getObject")


def _is_job(obj) -> bool:
    return (
        has_toolpath(obj)
        and freecad.OPERATIONS.is_in(obj)
        and (freecad.TOOLS.is_in(obj) or freecad.CONTROLLER.is_in(obj))
    )


def is_job_group(obj) -> bool:
    """Whether it is the group in which a job keeps its operations, of whatever type."""
    return freecad.GROUP.is_in(obj) and any(_is_job(user) and freecad.OPERATIONS.of(user) is obj for user in obj.InList)


def members(group) -> Iterator:
    """Yield the members of a group or of a list, those of groups among them in their place."""
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
    """Whether it only holds other objects together: a folder of the tree, a part, or a compound of toolpaths."""
    return any(map(obj.isDerivedFrom, ("App::DocumentObjectGroup", "App::Part"))) or kind(obj) == "group"


def or_active_document(what):
    """Return what somebody asked for, the active document where that is None.

    Raises
    ------
    ValueError
        Where no document is open.
    """
    if what is None:
        what = FreeCAD.ActiveDocument
    if what is None:
        raise ValueError("no document is open: open one with a job or a toolpath")
    return what


def find(what) -> list[Operation]:
    """Return the operations of a document, a job, an operation, or of several of these.

    Parameters
    ----------
    what : Document, DocumentObject, or iterable of them
        A document stands for all its jobs and the toolpaths outside them, a job (or its group of operations)
        for all that is in it, a folder for its members. Other objects have no toolpath.

    Returns
    -------
    list of Operation
        Each object once, in the order of posting, a dress-up before what it dresses up.

    Raises
    ------
    ReferenceError
        If one of them was deleted, or its document closed.
    TypeError
        If something else is given.
    """
    return list(_once(_find(what, {})).values())


def _once(operations: Iterable[Operation]) -> dict[tuple[str, str], Operation]:
    """Return the first operation of each object, by its names."""
    found: dict[tuple[str, str], Operation] = {}
    for operation in operations:
        found.setdefault(names_of(operation.object), operation)
    return found


def _find(what, jobs: dict) -> Iterator[Operation]:
    """Find the operations; `jobs` keeps those of each job, so that a selection searches no job twice."""
    if is_gone(what):
        raise ReferenceError("what is asked for was deleted, or its document closed: take it from the document again")
    if is_document(what):
        for obj in what.Objects:
            if kind(obj) == "job":
                yield from _of_job(obj)
        for obj in what.Objects:
            if is_operation(obj):
                job = job_of(obj)
                yield from _with_bases(obj, job, counted=job is None)  # a job posts what is in its group
    elif is_object(what):
        if kind(what) == "job":
            yield from _of_job(what)
        elif is_operation(what):
            job = job_of(what)
            if job is not None and names_of(job) not in jobs:
                jobs[names_of(job)] = _once(_of_job(job))
            listed = jobs[names_of(job)].get(names_of(what)) if job is not None else None
            yield listed or next(_with_bases(what, job, counted=job is None))
        elif is_job_group(what):
            yield from _of_job(job_of(what))
        elif is_group(what):
            for obj in members(what):
                yield from _find(obj, jobs)
    elif isinstance(what, Iterable) and not isinstance(what, (str, bytes)):
        for one in what:
            yield from _find(one, jobs)
    else:
        raise TypeError(f"only a document, a job or operations have toolpaths, not {type(what).__name__}")


def _of_job(job) -> Iterator[Operation]:
    """Find what is in the group of a job, and what that is made from."""
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
        if kind(obj) == "array":  # one that dresses up has taken what it copies out of the group
            for base in _bases(obj):
                yield from _with_bases(base, job, counted=False)


def _with_bases(obj, job, counted: bool) -> Iterator[Operation]:
    active = is_active(obj)
    yield Operation(obj, job, counted and active, active)
    if kind(obj) == "dressup":
        for base in _dressed(obj):
            yield Operation(base, job, False, is_active(base))


def _bases(obj) -> list:
    """What a dress-up or an array is made from (an ordinary operation's Base lists faces of the model)."""
    base = freecad.BASE.of(obj)
    candidates = base if isinstance(base, (list, tuple)) else [base]
    return [b for b in candidates if is_object(b) and has_toolpath(b)]


def _all_bases(obj) -> Iterator:
    seen = {obj.Name}
    pending = _bases(obj)
    while pending:
        base = pending.pop(0)
        if base.Name not in seen:
            seen.add(base.Name)
            yield base
            pending += _bases(base)


def _dressed(obj) -> Iterator:
    """What is not posted because a dress-up stands for it; what an array copies is posted beside it."""
    for base in _all_bases(obj):
        yield base
        if kind(base) == "array":
            return


def posted(found: Sequence[Operation]) -> list[Operation]:
    """Return the operations of some that are posted; of what no job posts, those that are switched on."""
    return [o for o in found if o.counted] or [o for o in found if o.active]


def jobs_of(operations: Iterable[Operation]) -> dict[tuple[str, str], object]:
    """Return the jobs that operations belong to, by their names, each once."""
    return {names_of(o.job): o.job for o in operations if o.job is not None}


def fixtures_of(job) -> int:
    """Return how often a job's operations are posted: once for each fixture it lists."""
    listed = freecad.FIXTURES.of(job)
    return max(len(listed), 1) if isinstance(listed, list) else 1


def job_of(obj):
    """Return the job of an operation, also where only a dress-up of it is in the job's group."""
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
    """Return a property of an operation, or of the operation it dresses up; None where none has it."""
    for one in (obj, *_all_bases(obj)):
        value = wanted.of(one)
        if value is not None:
            return value
    return None


def takes_tool(obj) -> bool:
    """Whether an operation, or what it dresses up, is one that a tool follows, be its controller set or not."""
    return any(map(freecad.CONTROLLER.is_in, (obj, *_all_bases(obj))))


def is_active(obj, _above: tuple[str, ...] = ()) -> bool:
    """Whether FreeCAD posts the operation: neither it nor what it dresses up is switched off, of an array not all."""
    if not freecad.ACTIVE.of(obj, True):
        return False
    of_bases = [is_active(base, (*_above, obj.Name)) for base in _bases(obj) if base.Name not in _above]
    if of_bases and kind(obj) == "array":
        return any(of_bases)
    return all(of_bases)


def is_imported(obj) -> bool:
    """Whether a toolpath may come from a file: its own, or one that it dresses up or copies."""
    return any(map(freecad.is_imported, (obj, *_all_bases(obj))))
