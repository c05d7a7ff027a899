# SPDX-License-Identifier: LGPL-2.1-or-later
"""Group the connected cells of a grid, and put numbers that are connected through pairs into groups."""

from __future__ import annotations

import numpy as np


def connected_cells(row: np.ndarray, column: np.ndarray) -> np.ndarray:
    """Return the number of each cell's group, (k,). The groups are numbered from 0 in the order of their first cells.

    A cell is connected with its eight neighbours. The same cell can occur several times in `row` and `column`.
    """
    if not len(row):
        return np.empty(0, np.int64)
    width = int(np.ptp(column)) + 3  # empty columns separate the end of a row from the start of the next row
    cells, cell = np.unique((row - row.min()) * width + column - column.min() + 1, return_inverse=True)
    first = np.flatnonzero(np.diff(cells, prepend=cells[0] - 2) > 1)  # first cell of each run of cells in a row
    length = np.diff(first, append=len(cells))
    begin, end = cells[first], cells[first + length - 1]
    # All runs of cells in the next row that touch one run have consecutive numbers.
    touching = np.searchsorted(end, begin + width - 1)
    count = np.searchsorted(begin, end + width + 1, side="right") - touching
    run = np.repeat(np.arange(len(first)), count)
    other = np.arange(len(run)) + np.repeat(touching - np.cumsum(count) + count, count)
    group: np.ndarray = np.repeat(connected_pairs(run, other, len(first)), length)[cell.ravel()]
    return np.unique(group, return_inverse=True)[1].reshape(-1)


def connected_pairs(one: np.ndarray, other: np.ndarray, count: int) -> np.ndarray:
    """Return, for each number from 0 to `count` - 1, the lowest number that is connected with it.

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
    """Return, for each group number in ascending order, the positions in `group` (k,) at which it occurs, ascending."""
    order = np.argsort(group, kind="stable")
    return np.split(order, np.flatnonzero(np.diff(group[order])) + 1) if len(group) else []
