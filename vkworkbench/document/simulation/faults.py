# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faults of operations, and verdicts on jobs, that simulations of this session have found.

A fault is valid as long as the toolpath, tool and stock of its operation, and all earlier operations, stay the same.
The faults and verdicts of a document are dropped when a toolpath, a setting or the order of its operations changes.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import TypeVar

import FreeCAD

from vkworkbench import freecad
from vkworkbench.core.zbuffer import Verdict
from vkworkbench.document.marks import marks
from vkworkbench.document.marks.record import Record
from vkworkbench.document.simulation.job import SimulatedJob, SimulatedOperation
from vkworkbench.language import Message
from vkworkbench.report import JobVerdict, OperationReport

_Found = TypeVar("_Found", OperationReport, Record)
_CHANGES = freecad.names_in_fingerprint("path") | freecad.names_in_fingerprint("setting")
# Faults by the names of document and operation. Each fault has the fingerprint of its operation.
_found: dict[str, dict[str, tuple[str, Message]]] = {}
# Verdicts by the names of document and job.
_verdicts: dict[str, dict[str, JobVerdict]] = {}
_observer: _Observer | None = None


def keep_faults(faults: Mapping[SimulatedOperation, list[tuple[int, Message]]]) -> bool:
    """Replace the stored faults of operations; return whether a stored fault has changed.

    Each operation has a list of its faults, each with the number of its command; the list is empty if there is no
    fault.
    """
    _observe()
    changed = False
    for operation, wrong in faults.items():
        known = _found.setdefault(operation.document, {})
        before = known.pop(operation.name, None)
        if wrong:
            command, fault = wrong[0]
            count = len({command for command, _ in wrong})
            remark = Message("simulated", count=count, command=command + 1, fault=fault)
            known[operation.name] = operation.fingerprint, remark
        changed |= known.get(operation.name) != before
    return changed


def keep_verdict(job: SimulatedJob, verdict: Verdict) -> bool:
    """Store the verdict on a job that was simulated as a whole; return whether the stored verdict has changed."""
    if not job.valid_for:
        return False
    _observe()
    known = _verdicts.setdefault(job.operations[0].document, {})
    before, what = known.get(job.name), verdict.message([operation.label for operation in job.operations])
    known[job.name] = JobVerdict(what, job.valid_for)
    return known[job.name] != before


def verdict_on(job, fingerprints: Iterable[str]) -> JobVerdict | None:
    """Return the verdict on a job from a simulation of this session, or else from its mark; None if neither is valid.

    `fingerprints` are the fingerprints of the job's operations.
    """
    return _verdicts.get(job.Document.Name, {}).get(job.Name) or marks.verdict_of(job, fingerprints)


def with_faults(found: _Found, document: str, name: str) -> _Found:
    """Return the results of an operation, with its fault if toolpath and setting are unchanged since the simulation."""
    fingerprint, fault = _found.get(document, {}).get(name, ("", None))
    remarks = tuple(remark for remark in found.remarks if remark.code != "simulated")
    if fault is not None and fingerprint == found.fingerprint:
        remarks += (fault,)
    return found if remarks == found.remarks else replace(found, remarks=remarks)


def read_with_faults(obj: FreeCAD.DocumentObject) -> Record | None:
    """Return an object's mark in the tree, with a simulation's fault or verdict; None without a mark."""
    record = marks.read(obj)
    if record is None:
        return None
    verdict = _verdicts.get(obj.Document.Name, {}).get(obj.Name)
    return with_faults(replace(record, verdict=verdict) if verdict else record, obj.Document.Name, obj.Name)


def _observe() -> None:
    global _observer
    if _observer is None:
        _observer = _Observer()
        FreeCAD.addDocumentObserver(_observer)


def _drop(document: str) -> None:
    _found.pop(document, None)
    _verdicts.pop(document, None)


class _Observer:
    def slotChangedObject(self, obj, name: str) -> None:
        if name in _CHANGES:
            _drop(obj.Document.Name)

    def slotDeletedObject(self, obj) -> None:
        _drop(obj.Document.Name)

    def slotDeletedDocument(self, document) -> None:
        _drop(document.Name)
