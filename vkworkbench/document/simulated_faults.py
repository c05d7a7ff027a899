# SPDX-License-Identifier: LGPL-2.1-or-later
"""What simulations of this session showed to be wrong with operations, for as long as it is true.

An operation's faults hold for its toolpath, tool and stock, which its fingerprint tells, and for all that is cut before
it: when a toolpath of the document, or the order of the operations, changes, they are forgotten.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import FreeCAD

from vkworkbench import freecad
from vkworkbench.document.simulated_job import SimulatedOperation
from vkworkbench.language import Message
from vkworkbench.report import OperationReport

_CHANGES = freecad.names_in_fingerprint("path") | freecad.names_in_fingerprint("setting")
# By document and operation: the fingerprint that the fault is of.
_found: dict[str, dict[str, tuple[str, Message]]] = {}
_observer: _Observer | None = None


def keep_faults(faults: Mapping[SimulatedOperation, list[tuple[int, Message]]]) -> None:
    """Keep what is wrong with operations, instead of what was known of them.

    Parameters
    ----------
    faults : mapping
        Commands and what is wrong with them, by operation; empty where nothing is.
    """
    global _observer
    if _observer is None:
        _observer = _Observer()
        FreeCAD.addDocumentObserver(_observer)
    for operation, wrong in faults.items():
        known = _found.setdefault(operation.document, {})
        known.pop(operation.name, None)
        if wrong:
            command, fault = wrong[0]
            told = Message("simulated", count=len(wrong), command=command + 1, fault=fault)
            known[operation.name] = operation.fingerprint, told


def with_faults(row: OperationReport) -> OperationReport:
    """Return a row with what simulations showed to be wrong with just this toolpath, tool and stock."""
    fingerprint, told = _found.get(row.document, {}).get(row.name, ("", None))
    remarks = tuple(remark for remark in row.remarks if remark.code != "simulated")
    if told is not None and fingerprint == row.fingerprint:
        remarks += (told,)
    return row if remarks == row.remarks else replace(row, remarks=remarks)


class _Observer:
    def slotChangedObject(self, obj, name: str) -> None:
        if name in _CHANGES:
            _found.pop(obj.Document.Name, None)

    def slotDeletedObject(self, obj) -> None:
        _found.pop(obj.Document.Name, None)

    def slotDeletedDocument(self, document) -> None:
        _found.pop(document.Name, None)
