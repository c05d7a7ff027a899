# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work offsets, such as G55, that the commands of a job select; a document does not contain their positions."""

from __future__ import annotations

import numpy as np

from vkworkbench import freecad
from vkworkbench.core import Toolpath
from vkworkbench.core.gcode import OFFSETS, Words
from vkworkbench.language import Message

_OFFSETS = tuple(OFFSETS)


class WorkOffsets:
    """Follows the active work offset from one operation of a job to the next.

    The first work offset of the job (FreeCAD: fixture) is active before its operations.
    """

    def __init__(self, job=None) -> None:
        listed = freecad.FIXTURES.of(job)
        self._now = str(listed[0]) if isinstance(listed, list) and listed else None
        self._first: str | None = (
            None  # the offset at the first move, to whose origin all coordinates are assumed to refer
        )

    def remark(self, words: Words, toolpath: Toolpath) -> Message | None:
        """Read the next operation; return a remark if it moves at another work offset than the very first move."""
        rows = np.flatnonzero(np.isin(words.codes, _OFFSETS)).tolist()
        names = [self._now, *(words.names[row] for row in rows)]
        begins = np.searchsorted(toolpath.command, [0, *rows, len(words)]).tolist()
        self._now = names[-1]
        for row, name, begin, end in zip([None, *rows], names, begins, begins[1:]):
            if begin == end:
                continue
            self._first = self._first or name or "G54"
            if (name or "G54") != self._first:
                ignored = Message("coordinates-not-changed", name=name)
                return ignored if row is None else Message("in-commands", sentence=ignored, count=1, command=row + 1)
        return None
