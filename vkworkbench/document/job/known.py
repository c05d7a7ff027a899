# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was found in this session: an operation that is as it was is not analysed again.

What is kept is found by the text of the path and by all else that an analysis reads: placement, tool, stock, feeds,
preferences and calibration, unrounded. Nothing has to be told that something changed: what changed is not found.
"""

from __future__ import annotations

import hashlib
import threading
from collections import OrderedDict
from collections.abc import Hashable

import numpy as np

from vkworkbench.report import OperationReport

# Rows kept, and the trajectories that they hold together, in half a GB: what is computed on demand needs these.
_MOST_ROWS = 5_000
_MOST_TRAJECTORIES = 10_000_000


class Known:
    """Rows by their keys; those not asked for the longest time go when there are too many.

    Parameters
    ----------
    most_rows, most_trajectories : int
        How many rows are kept, and how many trajectories these may hold together.
    """

    def __init__(self, most_rows: int = _MOST_ROWS, most_trajectories: int = _MOST_TRAJECTORIES) -> None:
        self.most_rows, self.most_trajectories = most_rows, most_trajectories
        self._rows: OrderedDict[Hashable, OperationReport] = OrderedDict()
        self._trajectories = 0
        self._lock = threading.Lock()  # an analysis works in a thread of its own

    def __len__(self) -> int:
        return len(self._rows)

    def find(self, key: Hashable | None) -> OperationReport | None:
        """Return what was found under a key; None where nothing was, or without a key."""
        with self._lock:
            if key in self._rows:
                self._rows.move_to_end(key)
            return self._rows.get(key)

    def keep(self, key: Hashable | None, row: OperationReport) -> None:
        """Keep what was found under a key, nothing without one."""
        if key is None:
            return
        with self._lock:
            if key not in self._rows:
                self._trajectories += row.trajectories
                self._rows[key] = row
            while len(self._rows) > self.most_rows or self._trajectories > self.most_trajectories:
                _, gone = self._rows.popitem(last=False)
                self._trajectories -= gone.trajectories

    def forget(self) -> None:
        """Forget everything."""
        with self._lock:
            self._rows.clear()
            self._trajectories = 0


#: What was found in this session.
KNOWN = Known()


def key_of(text: str, *parts) -> Hashable | None:
    """Return the key of a path's text and of all else that an analysis reads; None where a part cannot be told exactly."""
    try:
        told = repr([_exactly(part) for part in parts])
    except TypeError:
        return None
    return hashlib.sha256(text.encode("utf-8", "surrogatepass")).digest(), told


def _exactly(part):
    """Return a value as texts and numbers that tell all of it: an object by its type and attributes."""
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
