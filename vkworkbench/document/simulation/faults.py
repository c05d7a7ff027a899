# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faults of operations that simulations of this session have found.

A fault is valid for the toolpath, tool and stock of its operation, which the fingerprint covers, and for all operations before
it. All faults of a document are dropped when a toolpath or the order of its operations changes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TypeVar

import FreeCAD

from vkworkbench import freecad
from vkworkbench.document.marks import marks
from vkworkbench.document.marks.record import Record
from vkworkbench.document.simulation.job import SimulatedOperation
from vkworkbench.language import Message
from vkworkbench.report import OperationReport

_Found = TypeVar("_Found", OperationReport, Record)
_CHANGES = freecad.names_in_fingerprint("path") | freecad.names_in_fingerprint("setting")
# By document and operation: the fingerprint of the operation, and its fault.
_found: dict[str, dict[str, tuple[str, Message]]] = {}
_observer: _Observer | None = None


def keep_faults(faults: Mapping[SimulatedOperation, list[tuple[int, Message]]]) -> bool:
    """Replace the faults of operations; return whether any has changed.

    Parameters
    ----------
    faults : mapping
        Lists of commands with their faults, by operation; an empty list if there is no fault.
    """
    global _observer
    if _observer is None:
        _observer = _Observer()
        FreeCAD.addDocumentObserver(_observer)
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


def with_faults(found: _Found, document: str, name: str) -> _Found:
    """Return the results of an operation with its fault, if its toolpath and setting are as they were simulated.

    Parameters
    ----------
    found : OperationReport or Record
    document, name : str
        Internal names of the document and the operation.
    """
    fingerprint, fault = _found.get(document, {}).get(name, ("", None))
    remarks = tuple(remark for remark in found.remarks if remark.code != "simulated")
    if fault is not None and fingerprint == found.fingerprint:
        remarks += (fault,)
    return found if remarks == found.remarks else replace(found, remarks=remarks)


def read_with_faults(obj: FreeCAD.DocumentObject) -> Record | None:
    """Return the mark of an object with its fault from a simulation; None without a mark."""
    record = marks.read(obj)
    return None if record is None else with_faults(record, obj.Document.Name, obj.Name)


class _Observer:
    def slotChangedObject(self, obj, name: str) -> None:
        if name in _CHANGES:
            _found.pop(obj.Document.Name, None)

    def slotDeletedObject(self, obj) -> None:
        _found.pop(obj.Document.Name, None)

    def slotDeletedDocument(self, document) -> None:
        _found.pop(document.Name, None)
