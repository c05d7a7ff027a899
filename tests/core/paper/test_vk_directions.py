# SPDX-License-Identifier: LGPL-2.1-or-later
"""The axis that moves have, whichever way they go along it."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core.paper.directions import axis_of


def axis(*moves):
    """Degrees of the axis of moves, each a direction in degrees and a length."""
    angle, length = np.array(moves, float).T
    angle = np.radians(angle)
    along = length * np.cos(angle)
    return np.degrees(axis_of((along * np.cos(angle)).sum(), (along * np.sin(angle)).sum(), length.sum()))


@pytest.mark.parametrize("angle", [-80, -30, 0, 20, 75])
def test_the_axis_of_one_direction_is_that_direction_either_way(angle):
    assert [axis((angle, 7)), axis((angle, 7), (angle + 180, 3))] == pytest.approx([angle, angle])


def test_the_axis_of_two_directions_lies_between_them_towards_the_longer():
    assert axis((20, 5), (60, 5)) == pytest.approx(40)
    assert axis((20, 5), (240, 5)) == pytest.approx(40)
    assert 20 < axis((20, 9), (60, 1)) < 30
