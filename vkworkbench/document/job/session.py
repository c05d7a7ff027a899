# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was found of the operations of the open documents in this session, with all its numbers; marks keep less."""

from __future__ import annotations

from collections.abc import Iterable

import FreeCAD

from vkworkbench.report import OperationReport

_found: dict[str, dict[str, OperationReport]] = {}


class _Closing:
    """Forgets what was found in a document that is closed: another one may get its name."""

    def slotDeletedDocument(self, document) -> None:
        _found.pop(document.Name, None)


_closing: _Closing | None = None


def remember(rows: Iterable[OperationReport]) -> None:
    """Keep what was found of some operations; the others keep what was found before."""
    global _closing
    if _closing is None:
        _closing = _Closing()
        FreeCAD.addDocumentObserver(_closing)
    for row in rows:
        _found.setdefault(row.document, {})[row.name] = row


def row_of(obj, fingerprint: str) -> OperationReport | None:
    """Return what was found of an operation when it had this fingerprint; None where nothing was."""
    row = _found.get(obj.Document.Name, {}).get(obj.Name)
    return row if row is not None and row.fingerprint == fingerprint else None


def rows_with(rows: Iterable[OperationReport]) -> dict[tuple[str, str], OperationReport]:
    """Return all that was found by the names of document and operation, these rows in the place of what was before."""
    known = {(document, name): row for document, own in _found.items() for name, row in own.items()}
    return {**known, **{(row.document, row.name): row for row in rows}}
