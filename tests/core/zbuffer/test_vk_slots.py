# SPDX-License-Identifier: LGPL-2.1-or-later
"""The closed form of a slot, compared with the tool at many positions along its move."""

from __future__ import annotations

import numpy as np
import pytest
from zbuffer_inputs import close

from vkworkbench.core.zbuffer.sweeps.slots import ball_slot, level_slot, sloped_slot

RADIUS, PLACES, RAYS = 3.0, 1001, 60
# Moves across the ray, along the ray, down, up, short, long, and vertically down.
LEVEL = [(9.0, 0.0, 0.0), (0.0, -9.0, 0.0), (5.0, 7.0, 0.0), (-6.0, 2.0, 0.0), (0.4, 0.3, 0.0)]
SLOPED = [(9.0, 0.0, 2.0), (0.0, 9.0, -4.0), (0.0, -9.0, -4.0), (5.0, 7.0, -6.0), (-6.0, 2.0, 3.0), (2.0, -1.0, 12.0)]
UPRIGHT = [(0.0, 0.0, -8.0), (0.0, 0.0, 8.0)]
TILTS = [0.4, 1.2]
FROM_BELOW, FROM_THE_SIDE = [2.2], [np.pi / 2]


def rays(move, seed):
    """Return points of rays around a move, relative to the start of the move."""
    lower, upper = np.minimum(move, 0) - 1.3 * RADIUS, np.maximum(move, 0) + 1.3 * RADIUS
    return np.random.default_rng(seed).uniform(lower[:, None], upper[:, None], (3, RAYS))


def standing(x, y, z, t, move, sine, cosine):
    """Return where rays enter and leave the tool's cylinder above its end face, for each position of the tool."""
    half = np.sqrt(RADIUS**2 - (x - t * move[0]) ** 2)  # The result is NaN for rays beside the tool.
    near, far = (-half - (y - t * move[1])) / sine, (half - (y - t * move[1])) / sine
    foot = z - t * move[2] + 1e-7
    if abs(cosine) < 1e-9:
        return near, np.where(foot >= 0, far, np.nan)
    if cosine > 0:
        far = np.minimum(far, foot / cosine)
    else:
        near = np.maximum(near, foot / cosine)
    return near, np.where(near <= far, far, np.nan)


def in_ball(x, y, z, t, move, sine, cosine):
    """Return where rays enter and leave the tool's ball, for each position of the tool."""
    at = [place - t * step for place, step in zip((x, y, z), move)]
    middle = -(at[1] * sine - at[2] * cosine)
    half = np.sqrt(RADIUS**2 - sum(one**2 for one in at) + middle**2)
    return middle - half, middle + half


def check(slot, parts, move, tilt):
    """Compare where rays enter and leave a slot with the extremes over many positions of the tool."""
    move, sine, cosine = np.array(move), np.sin(tilt), np.cos(tilt)
    x, y, z = rays(move, seed=int(100 * tilt))
    with np.errstate(invalid="ignore"):
        near, far = slot(RADIUS, (x, y, z), np.repeat(move[:, None], RAYS, axis=1), sine, cosine)
        t = np.linspace(0, 1, PLACES)[:, None]
        ends = [part(x, y, z, t, move, sine, cosine) for part in parts]
    entry = np.fmin.reduce([np.where(np.isnan(out), np.inf, into) for into, out in ends]).min(axis=0)
    leave = np.fmax.reduce([np.where(np.isnan(out), -np.inf, out) for _, out in ends]).max(axis=0)
    met = entry < leave
    hit = far - near > 0
    assert hit[met & (leave - entry > 1e-3)].all()
    assert met[hit & (far - near > 0.3)].all()  # A thinner part of the slot may lie between two positions.
    both = met & hit
    assert both.sum() > 10
    shares = [share for share in (sine, abs(cosine)) if share > 1e-9]
    between = np.linalg.norm(move) / (PLACES - 1) / min(shares)
    for short in (entry[both] - near[both], far[both] - leave[both]):
        assert short.min() > -1e-6
        assert short.max() < 0.3  # At some positions, only the edge of the tool's end face touches the ray.
        assert np.mean(short < between) > 0.9


@pytest.mark.parametrize("tilt", TILTS + FROM_BELOW + FROM_THE_SIDE)
@pytest.mark.parametrize("move", LEVEL, ids=str)
def test_flat_end_slot_of_level_move_equals_many_positions(move, tilt):
    check(level_slot, [standing], move, tilt)


@pytest.mark.parametrize("tilt", FROM_THE_SIDE)
def test_ray_on_the_floor_of_a_slot_is_inside_the_slot(tilt):
    z = np.array([0.0, 1e-12, -1e-12])
    move = np.repeat([[10.0], [4.0], [0.0]], 3, axis=1)
    near, far = level_slot(RADIUS, (np.full(3, 5.0), np.zeros(3), z), move, np.sin(tilt), np.cos(tilt))
    assert far - near == pytest.approx(np.full(3, far[1] - near[1])) and far[1] - near[1] > RADIUS


@pytest.mark.parametrize("tilt", TILTS + FROM_BELOW)
@pytest.mark.parametrize("move", LEVEL + SLOPED + UPRIGHT, ids=str)
def test_slot_of_a_flat_end_equals_the_tool_at_many_positions(move, tilt):
    check(sloped_slot, [standing], move, tilt)


@pytest.mark.parametrize("tilt", TILTS + FROM_BELOW + FROM_THE_SIDE)
@pytest.mark.parametrize("move", LEVEL + SLOPED + UPRIGHT, ids=str)
def test_ball_end_slot_equals_many_positions(move, tilt):
    check(ball_slot, [standing, in_ball], move, tilt)


@pytest.mark.parametrize("slot, fall", [(ball_slot, 0.0), (ball_slot, -30.0), (sloped_slot, -30.0)])
@pytest.mark.parametrize("tilt", TILTS)
def test_move_nearly_along_a_ray_is_cut_like_a_parallel_move(slot, fall, tilt):
    """In an isometric view, many moves at 45 degrees are nearly parallel to the rays.

    The large tool is an upper bound for the tools over a tile.
    """
    rng, radius, run = np.random.default_rng(7), 40.0, 187.2
    rays = rng.uniform([[-36], [-30], [0]], [[36], [run + 30], [40]], (3, 4000))
    every = np.ones(rays.shape[1])

    def cut(across):
        return slot(radius, rays, np.array([across * every, run * every, fall * every]), np.sin(tilt), np.cos(tilt))

    near, far = cut(0.0)
    assert (far - near > 0).any()
    for across in (7.1e-7, -7.1e-7, 3e-9):
        enter, leave = cut(across)
        hit = far - near > 1e-3
        assert close(enter[hit], near[hit], 1e-4) and close(leave[hit], far[hit], 1e-4), across


@pytest.mark.parametrize("radius, aside", [(3.0, 3.625), (1.0, 1.25), (2.0, 2.25), (3.0, 3.3)])
def test_slot_is_continuous_where_ray_touches_the_rim(radius, aside):
    """At one position of the tool, the ray only touches the tool. Rounding may move the ray past the tool."""
    there, back = np.array([1.0, 0.0, 2.0])[:, None], np.array([-1.0, 0.0, -2.0])[:, None]
    # At this share of the move, the ray touches the edge of the tool's end face.
    share = (aside - radius) + np.array([0.0, 1e-6, -1e-6])
    x, y = np.full(3, aside), np.zeros(3)
    for sine, cosine in ((0.6, 0.8), (0.6, -0.8)):
        # At this share of the move, the ray touches the side of the tool at the height of its end face.
        z = 2 * share - 1e-9
        one = sloped_slot(radius, (x, y, z), np.repeat(there, 3, axis=1), sine, cosine)
        other = sloped_slot(radius, (x - 1, y, z - 2), np.repeat(back, 3, axis=1), sine, cosine)
        for ends in (*one, *other):
            assert np.isfinite(ends).all() and np.ptp(ends) < 1e-2


@pytest.mark.parametrize("tilt", TILTS + FROM_BELOW)
@pytest.mark.parametrize("length", [-9.0, 0.5, 20.0])
@pytest.mark.parametrize("slot", [ball_slot, sloped_slot])
def test_move_along_the_ray_is_cut_from_end_to_end(slot, length, tilt):
    """Rounding must not shorten the cut.

    The cut begins where the ray enters the tool at one end of the move, and ends where the ray leaves
    the tool at the other end.
    """
    sine, cosine = np.sin(tilt), np.cos(tilt)
    x, y, z = np.random.default_rng(5).uniform([[-2.9], [-20], [-5]], [[2.9], [20], [25]], (3, 500))
    near, far = slot(RADIUS, (x, y, z), np.zeros((3, len(x))), sine, cosine)
    near, far = near + min(length, 0), far + max(length, 0)
    hit = far - near > abs(length) + 0.01
    assert hit.sum() > 100
    for rounding in ((0.0, 0.0, 0.0), (-3e-13, 0.0, 2e-14), (2e-16, -1e-16, 1e-16), (5e-11, 3e-15, 0.0)):
        move = length * (np.array([0.0, sine, -cosine]) + rounding)
        enter, leave = slot(RADIUS, (x, y, z), np.repeat(move[:, None], len(x), axis=1), sine, cosine)
        assert close(enter[hit], near[hit], 1e-6) and close(leave[hit], far[hit], 1e-6), rounding
