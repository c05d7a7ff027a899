# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's own rule, on polylines with simple angles."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core import Strategy, linearize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.paper.literal import paper_verdict

SQUARE = [(0, 0), (30, 0), (30, 30), (0, 30)]


def verdict(points, sense=1):
    commands = [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"Z": -1.0, "F": 5.0})]
    commands += [("G1", {"X": float(x), "Y": float(sense * y)}) for x, y in points[1:]]
    return paper_verdict(monotonous_areas(linearize(commands)))


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize(
    ("corners", "strategy"),
    [(4, Strategy.ZIGZAG), (5, Strategy.UNKNOWN), (6, Strategy.UNKNOWN), (7, Strategy.CONTOUR_PARALLEL)],
)
def test_limits_of_phi_in_the_papers_rule_are_pi_and_two_pi(corners, strategy, sense):
    """The path follows the sides of a square, with a quarter turn at each corner except the first and the last."""
    points = [SQUARE[k % 4] for k in range(corners)]
    found = verdict(points, sense)
    assert found.strategy is strategy
    assert sorted(map(abs, found.phi_range)) == pytest.approx([0, (corners - 2) * np.pi / 2])


def test_v_of_a_closed_contour_is_zero():
    found = verdict([*SQUARE, SQUARE[0]])
    assert found.v == pytest.approx((0, 0)) and found.image == (0, 0)
    assert verdict(SQUARE[:3]).v == (30, 30) and verdict(SQUARE[:3]).image == pytest.approx((0.5**0.5, 0.5**0.5))


def test_v_of_nearly_closed_contour_has_no_direction():
    turned = [(3.3 + 0.8 * x - 0.6 * y, 0.7 + 0.6 * x + 0.8 * y) for x, y in [*SQUARE, SQUARE[0]]]
    commands = [("G0", {"X": turned[0][0], "Y": turned[0][1], "Z": 5.0}), ("G1", {"Z": -1.0, "F": 5.0})]
    commands += [("G1", {"X": x, "Y": y}) for x, y in turned[1:]]
    found = paper_verdict(monotonous_areas(linearize(commands)))
    assert found.v != (0, 0) and found.v == pytest.approx((0, 0), abs=1e-12)
    assert found.image == (0, 0)


def test_direction_of_v_k_along_a_contour_turns_in_one_sense():
    assert (verdict(SQUARE).sense, verdict(SQUARE, -1).sense) == ("ccw", "cw")
    assert verdict([(0, 0), (10, 0), (20, 0)]).sense is None  # The direction of V_k does not change.
    assert verdict([(0, 0), (30, 0), (30, 2), (0, 2), (0, 4), (30, 4)]).sense is None  # V_k turns back and forth.


def test_direction_of_v_k_turns_only_for_outward_loops():
    """Loops that are cut inward are contour-parallel, but their V_k moves back and forth like in a zigzag."""
    loops = [[(s * x, s * y) for x, y in [(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)]] for s in (40, 36, 32)]
    for order, goes_around, sense in ((loops, False, None), (loops[::-1], True, "ccw")):
        points = [(x - order[0][0][0], y - order[0][0][1]) for loop in order for x, y in loop]
        found = verdict(points)
        assert found.strategy is Strategy.CONTOUR_PARALLEL and found.sense == sense
        swept = np.ptp(found.theta_range)
        assert swept > 2 * np.pi if goes_around else swept == pytest.approx(np.pi / 2)


def test_theta_range_begins_with_the_first_direction():
    """V_k first points up, and then turns to the left or right."""
    assert np.degrees(verdict([(0, 0), (0, 30), (-30, 30)]).theta_range) == pytest.approx((90, 135))
    assert verdict([(0, 0), (0, 30), (-30, 30)]).sense == "ccw"  # V_k turns by an eighth of a full turn.
    assert verdict([(0, 0), (0, 30), (30, 30)]).sense == "cw"


def test_v_k_that_swings_back_has_no_sense_of_rotation():
    found = verdict([(0, 0), (30, 0), (60, 6), (100, 5)])
    assert found.sense is None and max(found.theta_range) == pytest.approx(np.arctan2(6, 60))


@pytest.mark.parametrize("share, sense", [(0.008, "ccw"), (0.015, None)])
def test_v_k_that_turns_back_by_1_percent_has_no_rotation_sense(share, sense):
    """The direction of V_k turns by two radians in total. A `share` of the turns of V_k goes back."""
    back = 2 * share / (1 - 2 * share)  # In total, the directions turn by 2 + 2 * back, in rad.
    angles = [0.5, 1.0, 1.5, 1.5 - back, 2.0, 2.5]
    found = verdict([(0, 0), *((20 * np.cos(angle), 20 * np.sin(angle)) for angle in angles)])
    assert found.sense == sense
