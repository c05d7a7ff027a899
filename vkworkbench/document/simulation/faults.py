# SPDX-License-Identifier: LGPL-2.1-or-later
"""What simulations of this session showed to be wrong with operations, for as long as it is true.

An operation's faults hold for its toolpath, tool and stock, which its fingerprint tells, and for all that is cut before
it: when a toolpath of the document, or the order of the operations, changes, they are forgotten.
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
# By document and operation: the fingerprint that the fault is of.
_found: dict[str, dict[str, tuple[str, Message]]] = {}
_observer: _Observer | None = None


def keep_faults(faults: Mapping[SimulatedOperation, list[tuple[int, Message]]]) -> bool:
    """Keep what is wrong with operations, instead of what was known of them; return whether that is something else.

    Parameters
    ----------
    faults : mapping
        Commands and what is wrong with them, by operation; empty where nothing is.
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
            told = Message("simulated", count=count, command=command + 1, fault=fault)
            known[operation.name] = operation.fingerprint, told
        changed |= known.get(operation.name) != before
    return changed


def with_faults(found: _Found, document: str, name: str) -> _Found:
    """Return what is known of an operation, with what simulations showed to be wrong with just this toolpath and setting.

    Parameters
    ----------
    found : OperationReport or Record
    document, name : str
        Of the document and the operation, FreeCAD's internal ones.
    """
    fingerprint, told = _found.get(document, {}).get(name, ("", None))
    remarks = tuple(remark for remark in found.remarks if remark.code != "simulated")
    if told is not None and fingerprint == found.fingerprint:
        remarks += (told,)
    return found if remarks == found.remarks else replace(found, remarks=remarks)


def read_with_faults(obj: FreeCAD.DocumentObject) -> Record | None:
    """Return the mark of an object as it is shown: with what simulations showed; None without a mark."""
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
