# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find groups of connected cells of a grid, and groups of numbers that are connected through pairs."""

from __future__ import annotations

import numpy as np


def connected_cells(row: np.ndarray, column: np.ndarray) -> np.ndarray:
    """Return the group of each cell (k,), as ascending numbers from 0 in the order of the groups' first cells.

    A cell is connected with its eight neighbours. A cell may occur several times.
    """
    if not len(row):
        return np.empty(0, np.int64)
    width = int(np.ptp(column)) + 3  # empty columns at both sides, so that rows do not touch each other
    cells, cell = np.unique((row - row.min()) * width + column - column.min() + 1, return_inverse=True)
    first = np.flatnonzero(np.diff(cells, prepend=cells[0] - 2) > 1)  # of runs of neighbouring cells in a row
    length = np.diff(first, append=len(cells))
    begin, end = cells[first], cells[first + length - 1]
    # The runs in the next row that touch a run follow each other.
    touching = np.searchsorted(end, begin + width - 1)
    count = np.searchsorted(begin, end + width + 1, side="right") - touching
    run = np.repeat(np.arange(len(first)), count)
    other = np.arange(len(run)) + np.repeat(touching - np.cumsum(count) + count, count)
    group: np.ndarray = np.repeat(connected_pairs(run, other, len(first)), length)[cell.ravel()]
    return np.unique(group, return_inverse=True)[1].reshape(-1)


def connected_pairs(one: np.ndarray, other: np.ndarray, count: int) -> np.ndarray:
    """Return the lowest number that is connected with each of the numbers from 0 to `count` - 1.

    Two numbers are connected if they are a pair (`one[i]`, `other[i]`), or through a chain of pairs.
    """
    lowest = np.arange(count)
    while True:
        before, lowest = lowest, lowest.copy()
        low = np.minimum(before[one], before[other])
        for ends in (one, other):
            np.minimum.at(lowest, ends, low)
            np.minimum.at(lowest, before[ends], low)
        lowest = lowest[lowest]
        if (lowest == before).all():
            return lowest


def members(group: np.ndarray) -> list[np.ndarray]:
    """Return the positions in `group` (k,) of the members of each group, ascending, in the order of the numbers."""
    order = np.argsort(group, kind="stable")
    return np.split(order, np.flatnonzero(np.diff(group[order])) + 1) if len(group) else []
