# SPDX-License-Identifier: LGPL-2.1-or-later
"""The number of turns of polylines, compared with turns counted by hand."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core import complexity

PI = np.pi
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)]
STAR = [(np.cos(0.8 * PI * k), np.sin(0.8 * PI * k)) for k in range(6)]


@pytest.mark.parametrize(
    ("points", "total", "net"),
    [
        (SQUARE, 2, 2),
        (SQUARE[::-1], 2, -2),
        (SQUARE[:-1], 1, 1),  # The square is open, so the path turns at two corners only.
        (STAR, 4, 4),  # The pentagram makes two full turns.
        # The turns of the zigzag to the left and to the right cancel.
        ([(0, 0), (9, 0), (9, 1), (0, 1), (0, 2), (9, 2)], 2, 0),
        # The dent adds a quarter turn to the right and a quarter turn to the left.
        ([(0, 0), (4, 0), (4, 4), (2, 4), (2, 2), (0, 2), (0, 0)], 3, 2),
        ([(0, 0), (5, 0)], 0, 0),
        (np.empty((0, 2)), 0, 0),
    ],
)
def test_turns_of_polylines_match_hand_count(points, total, net):
    found = complexity(points)
    assert found.total_turning == pytest.approx(total * PI) and found.net_turning == pytest.approx(net * PI)
    assert found.windings == pytest.approx(net / 2)


def test_complexity_does_not_depend_on_size_or_place():
    rng = np.random.default_rng(1)
    points = rng.normal(size=(50, 2))
    turned = points @ np.array([[0.6, 0.8], [-0.8, 0.6]]) * 70 + (5, -3)
    one, other = complexity(points), complexity(turned)
    assert other.total_turning == pytest.approx(one.total_turning) and one.total_turning > abs(one.net_turning)
    assert other.net_turning == pytest.approx(one.net_turning)
