# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of this session, stored under the inputs of the analysis, and under the names of the operations.

`RESULTS` stores results under all inputs of an analysis, unrounded: the text of the path, placement, tool, stock,
feeds, preferences and calibration. Therefore an unchanged operation is not analysed again, and a changed operation has
another key. `remember` and `latest_row` store and return the last result of each operation of an open document. The
stored results contain all numbers of the analysis; the marks in the tree contain fewer numbers.
"""

from __future__ import annotations

import hashlib
import threading
from collections import OrderedDict
from collections.abc import Hashable, Iterable

import FreeCAD
import numpy as np

from vkworkbench.report import OperationReport

# Upper limits for the number of operations whose results are stored, and for the total number of their trajectories.
# Together the results need at most about half a GB of memory.
_MAX_ROWS = 5_000
_MAX_TRAJECTORIES = 10_000_000


class ResultCache:
    """A cache of the results of operations, each stored as a row of a report.

    If the number of rows or the total number of their trajectories exceeds its limit, the rows that were not used for
    the longest time are dropped.
    """

    def __init__(self, max_rows: int = _MAX_ROWS, max_trajectories: int = _MAX_TRAJECTORIES) -> None:
        self.max_rows, self.max_trajectories = max_rows, max_trajectories
        self._rows: OrderedDict[Hashable, OperationReport] = OrderedDict()
        self._trajectories = 0
        self._lock = threading.Lock()  # several threads use the cache, because an analysis runs in its own thread

    def __len__(self) -> int:
        return len(self._rows)

    def find(self, key: Hashable | None) -> OperationReport | None:
        """Return the stored row of the results with a key; None for an unknown key and for the key None."""
        with self._lock:
            if key in self._rows:
                self._rows.move_to_end(key)
            return self._rows.get(key)

    def keep(self, key: Hashable | None, row: OperationReport) -> None:
        """Store a row under a key; do nothing if the key is None."""
        if key is None:
            return
        with self._lock:
            if key not in self._rows:
                self._trajectories += row.trajectories
                self._rows[key] = row
            while len(self._rows) > self.max_rows or self._trajectories > self.max_trajectories:
                _, dropped = self._rows.popitem(last=False)
                self._trajectories -= dropped.trajectories

    def clear(self) -> None:
        """Drop all stored results."""
        with self._lock:
            self._rows.clear()
            self._trajectories = 0


#: The results of this session.
RESULTS = ResultCache()


def key_of(text: str, *parts) -> Hashable | None:
    """Return the key for a path's text and all other inputs of an analysis; None if an input has no exact text."""
    try:
        exact = repr([_exactly(part) for part in parts])
    except TypeError:
        return None
    return hashlib.sha256(text.encode("utf-8", "surrogatepass")).digest(), exact


def _exactly(part):
    """Return plain data that is equal only for equal values. An object is replaced by its type and its attributes."""
    if part is None or isinstance(part, (bool, int, float, str)):
        return part
    if isinstance(part, np.ndarray):
        return part.shape, part.tolist()
    if isinstance(part, (tuple, list)):
        return [_exactly(one) for one in part]
    if isinstance(part, dict):
        return sorted((str(name), _exactly(value)) for name, value in part.items())
    if hasattr(part, "__dict__"):
        return type(part).__name__, _exactly(vars(part))
    raise TypeError(f"{type(part).__name__} has no exact text")


_latest: dict[str, dict[str, OperationReport]] = {}  # latest rows by the names of document and operation


class _ClosedDocuments:
    """Drops the stored results of a closed document, because another document can get the same name."""

    def slotDeletedDocument(self, document) -> None:
        _latest.pop(document.Name, None)


_closed_documents: _ClosedDocuments | None = None


def remember(rows: Iterable[OperationReport]) -> None:
    """Store the latest results of some operations; the stored results of other operations stay."""
    global _closed_documents
    if _closed_documents is None:
        _closed_documents = _ClosedDocuments()
        FreeCAD.addDocumentObserver(_closed_documents)
    for row in rows:
        _latest.setdefault(row.document, {})[row.name] = row


def latest_row(obj, fingerprint: str) -> OperationReport | None:
    """Return the latest results of an operation; None without results, or if they have another fingerprint."""
    row = _latest.get(obj.Document.Name, {}).get(obj.Name)
    return row if row is not None and row.fingerprint == fingerprint else None


def latest_rows(rows: Iterable[OperationReport]) -> dict[tuple[str, str], OperationReport]:
    """Return the latest results of all operations by the names of document and operation, updated by the given rows."""
    known = {(document, name): row for document, own in _latest.items() for name, row in own.items()}
    return {**known, **{(row.document, row.name): row for row in rows}}
