# SPDX-License-Identifier: LGPL-2.1-or-later
"""The signature (phi, turns, level) of a polyline that is moved, rotated, mirrored, reversed or refined."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from vkworkbench.core import linearize, signature

PI, TURN = np.pi, 2 * np.pi
CLOSE = {"abs": 1e-6}

# Directions are whole degrees, and lengths are far above rounding errors, so exact reversals remain exact.
vectors = st.lists(st.tuples(st.floats(0.1, 100), st.integers(0, 359)), min_size=2, max_size=40)


def polyline(vectors):
    steps = [(length * np.cos(np.radians(a)), length * np.sin(np.radians(a))) for length, a in vectors]
    return np.vstack([np.zeros((1, 2)), np.cumsum(steps, axis=0)])


def without_reversals(points):
    """Return the signature of a polyline without turns of half a turn, whose sign would be undecided."""
    result = signature(points)
    assume(np.abs(np.abs(result.turning) - PI).min() > 1e-3)
    return result


def turned(points, angle):
    c, s = np.cos(angle), np.sin(angle)
    return points @ np.array([(c, s), (-s, c)])


def same_angle(a, b):
    return np.abs(np.exp(1j * np.asarray(a)) - np.exp(1j * np.asarray(b))).max(initial=0.0) < 1e-6


@pytest.mark.long
@given(vectors, st.floats(-PI, PI), st.floats(0.01, 100), st.tuples(st.floats(-1e3, 1e3), st.floats(-1e3, 1e3)))
def test_moving_rotating_and_scaling_keep_phi(vectors, angle, scale, shift):
    points = polyline(vectors)
    before, after = without_reversals(points), signature(scale * turned(points, angle) + shift)
    assert after.phi == pytest.approx(before.phi, **CLOSE)
    assert same_angle(after.alpha, before.alpha + angle)
    assert after.length == pytest.approx(scale * before.length, rel=1e-6, abs=1e-6 * scale)
    assume(before.length.min() > 1e-3)
    assert same_angle(after.theta, before.theta + angle)


@given(vectors)
def test_mirroring_negates_phi_and_level(vectors):
    points = polyline(vectors)
    before, after = without_reversals(points), signature(points * [1, -1])
    assert after.phi == pytest.approx(-before.phi, **CLOSE)
    assert (after.level == -before.level).all()


@given(vectors)
def test_reversing_a_polyline_negates_and_reverses_its_turns(vectors):
    points = polyline(vectors)
    before, after = without_reversals(points), signature(points[::-1])
    assert after.turning == pytest.approx(-before.turning[::-1], **CLOSE)
    assert after.phi[-1] == pytest.approx(-before.phi[-1], **CLOSE)
    assert same_angle(after.alpha, before.alpha[::-1] + PI)


@given(vectors, st.integers(2, 5))
def test_collinear_points_add_no_turn(vectors, parts):
    points = polyline(vectors)
    before = without_reversals(points)
    share = np.arange(1, parts + 1) / parts
    refined = points[:-1, None] + share[None, :, None] * np.diff(points, axis=0)[:, None]
    after = signature(np.vstack([points[:1], refined.reshape(-1, 2)]))
    assert after.phi[::parts] == pytest.approx(before.phi, **CLOSE)
    assert np.ptp(after.phi.reshape(-1, parts), axis=1) == pytest.approx(np.zeros(len(vectors)), **CLOSE)


@given(vectors, st.data())
def test_repeated_points_add_no_turn(vectors, data):
    points = polyline(vectors)
    before = without_reversals(points)
    times = data.draw(st.lists(st.integers(1, 3), min_size=len(points), max_size=len(points)))
    after = signature(np.repeat(points, times, axis=0))
    assert after.phi[-1] == pytest.approx(before.phi[-1], **CLOSE)
    assert np.abs(after.phi).max() == pytest.approx(np.abs(before.phi).max(), **CLOSE)


@given(vectors)
def test_phi_equals_alpha_up_to_whole_turns(vectors):
    result = signature(polyline(vectors))  # Alpha is the direction of a move, between -pi and pi.
    assert same_angle(result.phi, result.alpha - result.alpha[0])
    assert np.abs(result.turning).max() <= PI + 1e-9
    assert (np.abs(result.level * TURN) <= np.abs(result.phi) + 1e-5).all()


@given(st.integers(3, 60), st.integers(0, 59), st.floats(0.1, 100))
def test_closed_contour_turns_once_from_any_start(sides, start, size):
    angles = TURN * np.arange(sides) / sides
    radius = size * (1 + 0.5 * np.cos(3 * angles))
    corners = np.column_stack([radius * np.cos(angles), radius * np.sin(angles)])
    contour = np.roll(corners, start % sides, axis=0)
    assert signature(np.vstack([contour, contour[:1]])).total_turning == pytest.approx(TURN, **CLOSE)


@given(vectors)
def test_rounding_to_six_decimals_keeps_phi(vectors):
    points = polyline(vectors)
    before, after = without_reversals(points), signature(np.round(points, 6))
    assert after.phi == pytest.approx(before.phi, abs=1e-3)


@settings(max_examples=50)
@given(st.floats(0.5, 200), st.floats(-PI, PI), st.floats(0.05, TURN - 0.05), st.sampled_from(["G2", "G3"]),
       st.floats(1e-4, 0.5))  # fmt: skip
def test_arc_turns_by_its_sweep_at_any_tolerance(radius, start, sweep, name, tolerance):
    sign = -1 if name == "G2" else 1
    end = start + sign * sweep
    tangent = np.array([-np.sin(start), np.cos(start)]) * sign
    leave = np.array([-np.sin(end), np.cos(end)]) * sign
    at_start = radius * np.array([np.cos(start), np.sin(start)])
    at_end = radius * np.array([np.cos(end), np.sin(end)])
    before, after = at_start - tangent, at_end + leave
    path = linearize([
        ("G0", {"X": before[0], "Y": before[1], "Z": 0.0}),
        ("G1", {"X": at_start[0], "Y": at_start[1]}),
        (name, {"X": at_end[0], "Y": at_end[1], "I": -at_start[0], "J": -at_start[1]}),
        ("G1", {"X": after[0], "Y": after[1]}),
    ], tolerance=tolerance)  # fmt: skip
    assert path.sweep.sum() == pytest.approx(sign * sweep, **CLOSE)
    assert signature(path.points).phi[-1] == pytest.approx(sign * sweep, abs=1e-5)
