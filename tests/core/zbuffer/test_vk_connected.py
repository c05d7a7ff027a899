# SPDX-License-Identifier: LGPL-2.1-or-later
"""Groups of connected cells, against a flood fill."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core.zbuffer.findings.connected import connected_cells, connected_pairs, members


def flooded(cells):
    """The groups of cells in the order of their first cells, found by a flood fill."""
    rest, groups = sorted(cells), []
    while rest:
        pending, group = [rest[0]], set()
        while pending:
            row, column = pending.pop()
            if (row, column) in rest and (row, column) not in group:
                group.add((row, column))
                pending += [(row + up, column + right) for up in (-1, 0, 1) for right in (-1, 0, 1)]
        groups.append(sorted(group))
        rest = [cell for cell in rest if cell not in group]
    return groups


@pytest.mark.parametrize("share", [0.1, 0.3, 0.5])
@pytest.mark.parametrize("height, width", [(1, 20), (20, 1), (12, 15)])
def test_cells_are_grouped_as_a_flood_fill_groups_them(height, width, share):
    rng = np.random.default_rng(height)
    for _ in range(5):
        row, column = np.nonzero(rng.random((height, width)) < share)
        order = rng.permutation(len(row))
        group = connected_cells(row[order] - 3, column[order] - 7)
        found = [sorted(zip(row[order[own]].tolist(), column[order[own]].tolist())) for own in members(group)]
        assert found == flooded(set(zip(row.tolist(), column.tolist())))


def test_repeated_cells_are_in_one_group():
    assert connected_cells(np.array([4, 0, 4]), np.array([4, 0, 4])).tolist() == [1, 0, 1]
    assert len(connected_cells(np.empty(0, int), np.empty(0, int))) == 0


def test_cells_connected_along_a_spiral_are_one_group():
    numbers = np.random.default_rng(2).permutation(1000)
    assert (connected_pairs(numbers[:-1], numbers[1:], 1001)[:-1] == 0).all()
    assert connected_pairs(numbers[:-1], numbers[1:], 1001)[-1] == 1000
