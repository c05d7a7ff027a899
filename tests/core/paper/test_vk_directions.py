# SPDX-License-Identifier: LGPL-2.1-or-later
"""The axis of moves does not depend on their sense."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core.paper.directions import axis_of, farthest, level_of


def axis(*moves):
    """Return the axis of moves in degrees. Each move is a direction in degrees and a length."""
    angle, length = np.array(moves, float).T
    angle = np.radians(angle)
    along = length * np.cos(angle)
    return np.degrees(axis_of((along * np.cos(angle)).sum(), (along * np.sin(angle)).sum(), length.sum()))


@pytest.mark.parametrize("angle", [-80, -30, 0, 20, 75])
def test_axis_of_one_direction_is_equal_for_both_senses(angle):
    assert [axis((angle, 7)), axis((angle, 7), (angle + 180, 3))] == pytest.approx([angle, angle])


def test_axis_lies_between_directions_weighted_by_length():
    assert axis((20, 5), (60, 5)) == pytest.approx(40)
    assert axis((20, 5), (240, 5)) == pytest.approx(40)
    assert 20 < axis((20, 9), (60, 1)) < 30


@pytest.mark.parametrize("sign", [1, -1])
def test_level_is_the_number_of_whole_turns_within_rounding(sign):
    turn = 2 * np.pi
    assert [level_of(sign * phi) for phi in (turn - 1e-5, turn - 1e-7, turn, 2.9 * turn)] == [0, sign, sign, 2 * sign]


def test_upper_bound_of_phi_wins_if_lower_is_as_far_from_zero():
    assert farthest((-3.0 - 1e-9, 3.0)) == 3.0
    assert farthest((-3.1, 3.0)) == -3.1 and farthest((-3.0, 3.1)) == 3.1
