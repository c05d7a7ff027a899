# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distances between nested squares, and the largest distance between neighbouring rings of one pocket."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core.recognition.patterns.nesting import Inward, Shapes, evenness, middle, next_steps, reach


def shapes(sides, area, length, slack=1.0, z=None):
    count = len(area)
    yes, no = np.ones(count, bool), np.zeros(count, bool)
    return Shapes(
        sides=sides,
        size=-(sides[0] + sides[2]),
        z=np.zeros(count) if z is None else np.array(z),
        flat=yes,
        enclosed=area,
        length=length,
        sense=np.ones(count),
        wavy=no,
        slack=np.full(count, slack),
        turn=no,
        rest=no,
    )


def inward(*sides, aside=0.0, enclosed=None, **drawn):
    """Return squares with a common centre, or with centres that move by `aside` along X from square to square."""
    half, x = np.array(sides) / 2, aside * np.arange(len(sides))
    borders = np.array([x - half, -half, -(x + half), -half])
    area = np.array(sides) ** 2.0 if enclosed is None else np.array(enclosed)
    return Inward(shapes(borders, area, 4.0 * np.array(sides), **drawn))


def distance(*sides, lag=1, **drawn):
    return inward(*sides, **drawn)[lag][3].tolist()


def test_nested_squares_are_half_the_side_difference_apart():
    low, high, mean, step = inward(20.0, 16.0, 10.0)[1]
    assert low.tolist() == high.tolist() == mean.tolist() == step.tolist() == [2, 3]
    assert distance(20.0, 16.0, 10.0, lag=2) == [5]
    low, high, mean, step = inward(10.0, 16.0)[1]  # The later square is the outer square.
    assert (low[0], high[0], mean[0], step[0]) == (-3, -3, -3, 3)


def test_ring_that_is_not_inside_is_not_an_offset():
    assert distance(20.0, 20.0, aside=1.0) == [0]
    assert distance(20.0, 16.0, aside=3.0) == [0]
    # The side with the smallest distance determines the distance of the squares.
    assert distance(20.0, 16.0, aside=0.5) == [1.5]


def open_pocket(*steps, low=(), wide=60.0, tall=40.0, slack=1.0):
    """Return rectangles `steps` mm inside the first one, except on the lower side and on the sides `low` (0 to 3)."""
    steps = np.array(steps)
    sides = np.array([steps, 0 * steps, steps - wide, steps - tall])
    sides[list(low)] = sides[list(low), :1]
    width, height = -(sides[0] + sides[2]), -(sides[1] + sides[3])
    return Inward(shapes(sides, width * height, 2 * (width + height), slack))


def test_offsets_may_share_the_open_side_of_a_pocket():
    assert open_pocket(0.0, 3.0, 6.0)[1][3] == pytest.approx([3, 3])
    assert open_pocket(0.0, 3.0, 6.0)[2][3] == pytest.approx([6])
    assert open_pocket(6.0, 3.0, 0.0)[1][3] == pytest.approx([3, 3])
    # The pocket is in a corner of the part, so two sides of the rings coincide.
    assert open_pocket(0.0, 3.0, 6.0, low=[0])[1][3] == pytest.approx([3, 3])
    # One ring continues at the end of another ring.
    assert open_pocket(0.0, 3.0, 6.0, low=[0, 2])[1][3].tolist() == [0, 0]


def test_ring_sharing_a_side_is_an_offset_if_other_sides_move():
    assert distance(20.0, 16.0, aside=2.0) == [0]
    # Turns of a winding can end anywhere, so a shared side does not show an open pocket.
    assert open_pocket(0.0, 3.0, slack=2.0)[1][3].tolist() == [0]


def square_inside(step, **drawn):
    """Return the distance of a square 2 mm inside a square of 20 mm.

    Islands or openings reduce the area of the inner ring to the area of a square `step` mm inside.
    """
    return distance(20.0, 16.0, enclosed=[400.0, 400 - step * (80 + 64) / 2], **drawn)


@pytest.mark.parametrize("step, found", [(4.2, 0), (4.02, 2), (1.34, 1.34), (1.327, 1.327), (1.3, 0)])
def test_offset_sides_move_by_half_to_one_and_a_half_distances(step, found):
    """All sides move by 2 mm, and the area changes as for a distance of `step`.

    Offsets are accepted from half to one and a half times the distance, which is 4 mm and 1.33 mm for the sides' 2 mm.
    Differences of 0.02 mm count as rounding.
    """
    assert square_inside(step) == pytest.approx([found])


@pytest.mark.parametrize("step, found", [(7.9, 2), (8.2, 0), (0.7, 0.7), (0.6, 0)])
def test_ring_of_equal_area_may_be_twice_as_far(step, found):
    assert square_inside(step, slack=2.0) == pytest.approx([found])


def reached(*sides, tool=0.0, z=None, areas=None):
    """Return the largest distance between nested rings, and the steps and drops in height from ring to ring."""
    rings = inward(*sides, z=z)
    area = np.arange(len(sides)) if areas is None else np.array(areas)
    return reach(rings, tool, area), *next_steps(rings)


def test_nested_rings_are_within_the_reach_of_a_known_tool():
    limit, steps, drops = reached(40.0, 36.0, 32.0, tool=3.0)
    assert limit == pytest.approx(3.6) and steps.tolist() == [2, 2] and drops.tolist() == [0, 0]
    assert reached(40.0, 39.99, tool=3.0)[0] == pytest.approx(3.6)  # The two rings count as one ring.


def test_nested_rings_of_an_unknown_tool_are_within_two_steps():
    assert reached(40.0, 36.0, 32.0)[0] == pytest.approx(4)
    # With only two rings, rings up to a twentieth of the larger ring's size apart are nested.
    assert reached(40.0, 38.0)[0] == pytest.approx(2)
    assert reached(40.0, 36.0)[0] == pytest.approx(2)
    # The repeat of a ring does not count as a step between rings.
    assert reached(40.0, 40.0, 38.0, 36.0)[0] == pytest.approx(2)


def test_reach_of_an_unknown_tool_is_computed_from_similar_steps():
    """Fewer than half of the steps (2, 2, 5, 6, 7 mm) are similar, so rings are at most a twentieth of 70 mm apart."""
    limit, steps, _ = reached(70.0, 66.0, 62.0, 52.0, 40.0, 26.0)
    assert steps.tolist() == [2, 2, 5, 6, 7] and limit == pytest.approx(3.5)


def test_steps_between_rings_within_thirty_percent_are_similar():
    """Two steps are 2 mm and four are 2.5 mm.

    The largest distance between rings is twice the usual step, which is more than a twentieth of 60 mm.
    """
    sides = 60.0 - 2 * np.cumsum([0, 2, 2, 2.5, 2.5, 2.5, 2.5])
    assert reached(*sides)[0] == pytest.approx(4)


def test_usual_step_between_rings_is_the_lower_quartile():
    """Two steps are 2 mm and six are 2.5 mm, so the third of the eight sorted steps is 2.5 mm."""
    sides = 60.0 - 2 * np.cumsum([0, 2, 2, *[2.5] * 6])
    assert reached(*sides)[0] == pytest.approx(5)


def test_rings_beyond_the_reach_of_a_thin_tool_are_engraved():
    """The rings are like the circles of a target, 2 mm apart."""
    assert reached(*(40.0 - 4 * np.arange(6)), tool=1.0)[0] == pytest.approx(1.2)


def test_two_contours_at_every_depth_are_not_a_pocket():
    """The two contours of a washer are 10 mm apart, which is not a stepover."""
    limit, steps, drops = reached(40.0, 20.0, 40.0, 20.0, z=[0, 0, -1, -1])
    assert limit == pytest.approx(2) and steps.tolist() == [10, 10, 10] and drops.tolist() == [0, 1, 0]


def test_two_rings_linked_at_their_depth_are_a_pocket():
    """A link between the two contours of a washer would cut into the part."""
    assert reached(40.0, 20.0, 40.0, 20.0, z=[0, 0, -1, -1], areas=[0, 0, 1, 1])[0] == pytest.approx(20)
    # The rings are linked on a ramp, not at their depth.
    assert reached(40.0, 20.0, 40.0, 20.0, z=[0, 0, -1, -1], areas=[0, 1, 1, 2])[0] == pytest.approx(2)
    # Only two of the five rings are linked at their depth.
    few = reached(40.0, 20.0, 40.0, 20.0, 40.0, z=[0, 0, -1, -1, -2], areas=[0, 0, 1, 2, 3])
    assert few[0] == pytest.approx(2)
    assert reached(40.0, 20.0, tool=3.0, areas=[0, 0])[0] == pytest.approx(3.6)


def test_evenness_compares_spreads_of_steps_in_plane_and_depth():
    """From the 10th to the 90th percentile, the values 0 to 10 spread by 8 around 5. A spread of 0.01 is rounding."""
    even, spread = np.full(11, 2.0), np.arange(11.0)
    assert evenness(even, spread) == pytest.approx(0.01 / 1.61)
    assert evenness(spread, even) == pytest.approx(1.61 / 0.01)
    assert evenness(spread, spread) == pytest.approx(1)
    assert evenness(spread, 0 * even) == evenness(even[:2], spread[:2]) == 0


def test_middle_of_values_is_the_median_or_the_lower_quartile():
    assert middle(np.array([5.0, 1.0, 3.0])) == 3
    assert middle(np.array([7.0, 1.0, 5.0, 3.0, 2.0, 8.0, 6.0, 4.0]), 4) == 3
