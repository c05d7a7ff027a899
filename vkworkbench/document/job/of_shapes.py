# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was found of FreeCAD's shapes, for those asked for last: finding it again would take its time."""

from __future__ import annotations

from collections.abc import Callable


class OfShapes:
    """One result for each shape.

    The shapes are kept, too: else another one could come to lie where one that is gone lay in memory, and would be
    taken for it.

    Parameters
    ----------
    most : int
        How many are kept.
    """

    def __init__(self, most: int) -> None:
        self._most = most
        self._found: list[tuple] = []

    def of(self, shape, find: Callable):
        """Return the result for a shape; `find` finds it the first time."""
        for at, (kept, _) in enumerate(self._found):
            if kept.isSame(shape):
                self._found.append(self._found.pop(at))
                break
        else:
            found = find()
            self._found[: 1 - self._most] = []
            self._found.append((shape, found))
        return self._found[-1][1]
