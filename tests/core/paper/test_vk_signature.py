# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's own numbers, and the cases that the paper's text leaves undecided."""

import numpy as np
import pytest

from vkworkbench.core import signature

PI = np.pi


def chain(*vectors):
    """Return the vertices of a polyline given as (length, direction) pairs."""
    steps = [(length * np.cos(angle), length * np.sin(angle)) for length, angle in vectors]
    return np.vstack([np.zeros((1, 2)), np.cumsum(steps, axis=0)])


@pytest.mark.parametrize("first, second", [(0.0, PI / 2), (0.3, 1.0), (-1.0, 0.5)])
def test_phi_of_the_zigzag_in_section_3_2_equals_the_papers_phi(first, second):
    pattern = [(40, first), (2, second), (40, first + PI), (2, second)]
    result = signature(chain(*pattern, (40, first)))
    expected = [0, second - first, PI, second - first, 0]
    assert result.phi == pytest.approx(expected, abs=1e-12)
    assert result.turning == pytest.approx(np.diff(expected), abs=1e-12)
    many = signature(chain(*pattern * 200))
    assert many.phi.min() >= -1e-9 and many.phi.max() <= PI + 1e-9
    assert set(many.level.tolist()) == {0}


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("sides", [3, 4, 7, 100])
def test_closed_polygon_turns_by_two_pi(sides, sense):
    angles = sense * 2 * PI * np.arange(sides + 2) / sides
    polygon = np.column_stack([np.cos(angles), np.sin(angles)])  # The first side is repeated at the end.
    result = signature(polygon)
    assert result.phi[-1] == pytest.approx(sense * 2 * PI, abs=1e-9)
    assert result.level.tolist() == [0] * sides + [sense]
    assert (sense * result.phi[:sides] < 2 * PI).all()
    once = signature(polygon[:-1])
    assert once.closed and once.total_turning == pytest.approx(sense * 2 * PI, abs=1e-9)


@pytest.mark.parametrize("gap, closed", [(0.0005, True), (0.0015, False)])
def test_polyline_is_closed_within_a_millionth_of_its_size(gap, closed):
    square = np.array([(0, 0), (1000, 0), (1000, 500), (0, 500), (0, gap)], float)
    found = signature(square)
    assert found.closed is closed
    assert found.total_turning == pytest.approx(2 * PI if closed else 3 * PI / 2)


def test_each_nested_square_adds_one_full_turn_to_phi():
    corners = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)], float)
    spiral = np.vstack([corners * size for size in (40, 30, 20, 10)])
    result = signature(spiral)
    assert result.level.max() == 3 and result.phi[-1] > 3 * 2 * PI
    assert signature(spiral * [1, -1]).level.min() == -3


def test_theta_jumps_back_while_the_number_of_turns_rises():
    """On a square spiral from its middle, n counts the turns of phi, and theta jumps from pi to -pi."""
    spiral = [(0, 0), (1, 0), (1, 1), (-1, 1), (-1, -1), (2, -1), (2, 2), (-2, 2), (-2, -2)]
    result = signature(spiral)
    image = np.arctan2(-1, 2) / PI  # The direction of the vector (2, -1), in units of pi.
    assert result.phi / PI == pytest.approx(np.arange(8) / 2)
    assert result.level.tolist() == [0] * 4 + [1] * 4
    assert result.theta / PI == pytest.approx([0, 0.25, 0.75, -0.75, image, 0.25, 0.75, -0.75])
    assert result.theta_level / PI == pytest.approx([0, 0.25, 0.75, -0.75, image + 2, 2.25, 2.75, 1.25])


@pytest.mark.parametrize("first, extent", [(0, 2), (1, 2), (2, 2.5), (3, 2.5), (4, 2), (5, 2)])
def test_phi_range_of_an_l_shape_depends_on_its_start(first, extent):
    corners = np.array([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], float)
    result = signature(np.roll(corners, -first, axis=0)[[*range(6), 0]])
    assert np.ptp(result.phi_range) == pytest.approx(extent * PI)
    assert result.total_turning == pytest.approx(2 * PI)


def test_phi_of_a_clockwise_zigzag_makes_no_full_turn():
    result = signature(chain(*[(40, 0), (2, -PI / 2), (40, PI), (2, -PI / 2)] * 5))
    assert result.phi.min() == pytest.approx(-PI)
    assert set(result.level.tolist()) == {0}


def test_exact_reversals_are_listed_and_do_not_add_turns():
    rows = np.array([(100.0 * (k % 2), 0.0) for k in range(6213)])
    result = signature(rows)
    assert len(result.reversals) == 6211
    assert np.ptp(result.phi) == pytest.approx(PI) and not result.level.any()


@pytest.mark.parametrize("sense", [1, -1])
def test_exact_reversal_brings_phi_back_toward_zero(sense):
    """After a quarter turn and a straight move, the path returns on the same line.

    Phi changes by half a turn, from a quarter turn in one sense to a quarter turn in the other sense.
    """
    there_and_back = np.array([(0, 0), (10, 0), (10, 10), (10, 20), (10, 10), (10, 0)], float)
    assert signature(there_and_back * [1, sense]).phi / PI == pytest.approx(sense * np.array([0, 0.5, 0.5, -0.5, -0.5]))


def test_trajectories_without_length_do_not_turn():
    points = np.array([(0, 0), (0, 0), (1, 0), (1, 0), (1, -0.0), (1, 1), (1, 1)], float)
    result = signature(points)
    assert result.alpha == pytest.approx([0, 0, 0, 0, PI / 2, PI / 2])
    assert result.phi[-1] == pytest.approx(PI / 2)
    assert not signature(np.zeros((5, 2))).phi.any()
    late = signature(np.array([(0, 0), (0, 0), (0, 0), (0, 1), (-1, 1), (-1, 1), (-1, 0)], float))
    assert late.alpha == pytest.approx([PI / 2, PI / 2, PI / 2, PI, PI, -PI / 2])


@pytest.mark.parametrize("aside, carried", [((3e-10, 4e-10), True), ((0.0, 1e-8), False), ((1e-8, 0.0), False)])
def test_v_k_of_length_zero_has_the_direction_of_the_previous(aside, carried):
    """A length of V_k below a millionth of a micrometre counts as zero."""
    x, y = aside
    theta = signature(np.array([(0, 0), (-3, 0), (-3, -3), (x, y), (5, 0)], float)).theta
    before, back = -3 * PI / 4, np.arctan2(y, x)
    assert theta == pytest.approx([PI, before, before if carried else back, 0], abs=1e-12)


def test_v_k_is_the_sum_of_the_first_trajectories():
    points = np.random.default_rng(1).normal(size=(50, 2))
    result = signature(points)
    assert result.length == pytest.approx(np.hypot(*(points[1:] - points[0]).T))
    assert result.length * np.cos(result.theta) == pytest.approx(points[1:, 0] - points[0, 0])
    assert result.theta_level == pytest.approx(result.theta + 2 * PI * result.level)
    of_v, of_v_k = result.gauss_map()
    assert np.hypot(*of_v.T) == pytest.approx(np.ones(49)) and np.hypot(*of_v_k.T) == pytest.approx(np.ones(49))


def test_signature_has_one_value_per_trajectory():
    result = signature(np.random.default_rng(2).normal(size=(9, 3)))
    assert [len(a) for a in (result.alpha, result.turning, result.phi, result.level, result.theta)] == [8, 7, 8, 8, 8]
    for points in (np.empty((0, 2)), np.zeros((1, 3))):
        empty = signature(points)
        assert len(empty) == 0 and empty.phi.shape == (0,) and empty.turning.shape == (0,) and empty.total_turning == 0
        assert not empty.closed


@pytest.mark.parametrize("axes", [(2, 0), (1, 2)])
def test_motion_in_a_vertical_plane_turns_in_that_plane(axes):
    square = np.array([(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)], float)
    points = np.zeros((5, 3))
    points[:, axes] = square
    assert signature(points).total_turning == pytest.approx(2 * PI)


NO_NUMBERS = ([(np.nan, 0)], [(0, 0), (np.nan, 1)], [(0, 0), (np.inf, 1)], [(0, 0, np.nan), (1, 0, 0), (1, 1, 0)])


@pytest.mark.parametrize("points", [[1, 2, 3], np.zeros((4, 4)), *NO_NUMBERS])
def test_points_that_are_not_finite_are_refused(points):
    with pytest.raises(ValueError, match="points"):
        signature(points)
