# SPDX-License-Identifier: LGPL-2.1-or-later
"""Intersections of rays with swept tools, also if the square term of the quadratic equation is 0."""

from __future__ import annotations

from math import atan, atan2, cos, pi, sin

import numpy as np
import pytest
from zbuffer_inputs import FORMS

from vkworkbench.core import Tool
from vkworkbench.core.zbuffer.sweeps import intervals as sweeps
from vkworkbench.core.zbuffer.sweeps.intervals import headings, intervals, lowest
from vkworkbench.core.zbuffer.sweeps.rounded import rounded_sides

RAYS, FAR = 1000, 30.0


def lengths(tool, moves, tilt):
    """Return the lengths of rays inside the sweeps, (RAYS,) mm. A ray steeper than the cone is limited to 2 * FAR."""
    near, far = intervals(tool, *moves, sin(tilt), cos(tilt))
    inside = np.clip(far, -FAR, FAR) - np.clip(near, -FAR, FAR)
    return np.where(inside > 0, inside, 0)


@pytest.mark.parametrize("steepness", [0.5, 1, 2])
@pytest.mark.parametrize("side", [1, -1])
def test_sweep_is_continuous_for_rays_parallel_to_a_cone(steepness, side):
    """The ray has the slope of the V-bit's cone, seen from above and from below."""
    tool = Tool("vbit", 6, tip_angle=2 * atan(1 / steepness))
    moves = np.random.default_rng(1).uniform(-4, 4, (3, 3, RAYS))
    tilt = atan2(1, side * steepness)
    exact, steeper, flatter = (lengths(tool, moves, tilt + by) for by in (0, 1e-6, -1e-6))
    assert (exact > 0).sum() > RAYS / 10
    assert (exact > np.minimum(steeper, flatter) - 1e-3).all() and (exact < np.maximum(steeper, flatter) + 1e-3).all()


def test_sweep_is_continuous_where_ray_touches_cone_rim():
    """The ray only touches the tool at the rim. Rounding may move the ray past the tool."""
    tool = Tool("drill", 8, tip_angle=2 * atan(2))
    start, move = (np.repeat([[x], [y], [z]], RAYS, axis=1) for x, y, z in ((2.0, 12.0, 10.0), (-12.0, -16.0, -12.0)))
    along = np.linspace(-3, 3, RAYS)  # Positions of several points of one ray.
    point = np.array([np.full(RAYS, 1.5), 5.75191847 + 0.6 * along, 7.83077538 - 0.8 * along])
    exact, beside = (intervals(tool, start, move, (point[0] + by, *point[1:]), 0.6, 0.8) for by in (0, 1e-7))
    assert np.abs(np.subtract(exact, beside)).max() < 1e-2


def some_moves(seed):
    """Return starts and moves (3, RAYS): one fifth each horizontal, vertical (upwards) and steep, the rest random."""
    start, move = np.random.default_rng(seed).uniform(-4, 4, (2, 3, RAYS))
    move[2, ::5] = move[:2, 1::5] = 0
    move[2, 1::5] = np.abs(move[2, 1::5])
    move[:2, 2::5] *= 0.1
    return start, move


@pytest.mark.parametrize("tool", FORMS, ids=str)
def test_lowest_height_of_a_sweep_equals_many_positions(tool):
    """The reference tries 2,000 positions of the tool on each move."""
    start, move = some_moves(3)
    x, y = np.random.default_rng(4).uniform(-8, 8, (2, RAYS))
    found, inner = lowest(tool, start, headings(move), x, y)
    place = np.linspace(0, 1, 2000)[:, None]
    away = np.hypot(*(at - begin - place * by for at, begin, by in zip((x, y), start, move)))
    expected = (tool.height(away) + start[2] + place * move[2]).min(axis=0)
    clear = np.abs(away.min(axis=0) - tool.radius) > 1e-3  # The point is far enough from the edge of the sweep.
    assert np.array_equal(np.isfinite(found)[clear], np.isfinite(expected)[clear]) and clear.sum() > 0.7 * RAYS
    hit = clear & np.isfinite(expected)
    # Between two sampled positions, the tool is lower by at most the change between the positions.
    assert (np.abs(found - expected)[hit] < 0.05).all() and np.mean(np.abs(found - expected)[hit]) < 3e-3
    assert (inner[hit] > 0).all()


def test_points_on_the_rim_belong_to_the_sweep():
    """Points beside, before and behind a move of 10 mm lie on the rim (3 mm), or a millionth of a mm outside."""
    x, y = np.array([5.0, 5.0, -3.0, 13.0, 5.0, -3 - 1e-6]), np.array([3.0, -3.0, 0.0, 0.0, 3 + 1e-6, 0.0])
    start, heading = np.zeros((3, 6)), np.repeat([[1.0], [0.0], [10.0], [0.0]], 6, axis=1)
    for tool in (tool for tool in FORMS if tool.radius == 3):
        height, _ = lowest(tool, start, heading, x, y)
        assert height[:4] == pytest.approx([tool.height(3.0)] * 4), tool
        assert np.isnan(height[4:]).all(), tool


@pytest.mark.parametrize("tilt", [0.3, 1.2, pi / 2, 2.0, 2.9])
@pytest.mark.parametrize("tool", FORMS, ids=str)
def test_ray_is_inside_sweep_above_its_lower_surface(tool, tilt):
    """At 60 depths of each oblique ray, its interval is compared with the lower surface of the sweep."""
    start, move = some_moves(5)
    at = np.random.default_rng(6).uniform(-4, 4, (3, RAYS))
    near, far = intervals(tool, start, move, at, sin(tilt), cos(tilt))
    depth = np.linspace(-12, 12, 60)[:, None]
    x, y, z = at[0] + 0 * depth, at[1] + depth * sin(tilt), at[2] - depth * cos(tilt)
    within = (near < depth) & (depth < far)
    expected = z > lowest(tool, start, headings(move), x, y)[0]
    close = np.minimum(np.abs(depth - near), np.abs(depth - far)) < 1e-3
    assert np.array_equal(within | close, expected | close) and 0.02 < expected.mean() < 0.9


BULL_NOSE = Tool("bullnose", 6, corner_radius=1)


@pytest.mark.parametrize("tilt", [0.7, pi / 2, 2.5])
def test_rays_through_short_bull_nose_moves_need_only_the_ends(tilt, monkeypatch):
    """Most rays enter and leave the sweep at an end of the move, so the slow search between the ends is left out."""
    searched = []

    def counted(tool, offset, *others):
        searched.append(offset.shape[1])
        return rounded_sides(tool, offset, *others)

    monkeypatch.setattr(sweeps, "rounded_sides", counted)
    moves = np.random.default_rng(2).uniform(-2, 2, (3, 3, RAYS))
    moves[1] *= 0.05
    found = lengths(BULL_NOSE, moves, tilt)
    assert (found > 0).sum() > 0.4 * RAYS and sum(searched) < 0.6 * RAYS
    # Two half moves cover the same intervals as the whole move.
    halves = [(moves[0] + part * moves[1], moves[1] / 2, moves[2]) for part in (0, 0.5)]
    near, far = zip(*(intervals(BULL_NOSE, *half, sin(tilt), cos(tilt)) for half in halves))
    missed = [~(one <= other) for one, other in zip(near, far)]
    near, far = np.where(missed, np.inf, near).min(axis=0), np.where(missed, -np.inf, far).max(axis=0)
    whole = np.array(intervals(BULL_NOSE, *moves, sin(tilt), cos(tilt)))
    both = (whole[0] <= whole[1]) & (near <= far)
    assert np.abs(whole[:, both] - (near[both], far[both])).max() < 1e-4


def test_sweep_is_continuous_where_ray_touches_bull_nose():
    """At every position of the move, the ray touches the tool in one point."""
    start, move = np.zeros((3, 5)), np.repeat([[0.0], [20.0], [5.0]], 5, axis=1)
    height = np.linspace(1.5, 5.5, 5)
    exact, beside = (
        intervals(BULL_NOSE, start, move, (np.full(5, x), np.zeros(5), height), 1.0, 0.0) for x in (3.0, 3.0 - 1e-7)
    )
    assert np.abs(np.subtract(exact, beside)).max() < 0.02 and (np.subtract(*exact[::-1]) > 1).all()
