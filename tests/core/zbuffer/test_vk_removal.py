# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rays at any positions: the cuts of a ray do not depend on the other rays or on the number of rays in a group."""

from __future__ import annotations

import numpy as np
import pytest
from zbuffer_inputs import BOX, PATHS, TOOLS, toolpath

from vkworkbench.core import Cut, Tool, View
from vkworkbench.core.zbuffer.rays import removal as module
from vkworkbench.core.zbuffer.rays.dexels import UNCUT
from vkworkbench.core.zbuffer.rays.removal import GROUP, Removal
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts


def random_removal(seed, direction):
    rng = np.random.default_rng(seed)
    cuts = [
        Cut(toolpath(PATHS[(seed + k) % len(PATHS)](rng, 30)), TOOLS[(3 * seed + k) % len(TOOLS)]) for k in range(2)
    ]
    return Removal(Cuts(cuts), BOX, View(direction, 80, 60).frame(BOX)), rng


def told(segments, ray):
    own = segments.ray == ray
    return [values[own].tolist() for values in (segments.owner, segments.near, segments.far)]


def alike(told):
    """Return an approximate copy, because the last bits of the depths depend on the number of rays in a batch."""
    owner, *ends = told
    return [owner, *map(pytest.approx, ends)]


@pytest.mark.parametrize("direction", [(0, 0, -1), (0, 0, 1), (1, 1, -1), (1, 0.5, -0.3)])
@pytest.mark.parametrize("count", [1, GROUP, 5 * GROUP + 3])
def test_ray_in_a_batch_is_cut_like_a_single_ray(count, direction, monkeypatch):
    """A third of the rays miss the stock. The cuts of the rays do not depend on the number of rays in a batch."""
    removal, rng = random_removal(count, direction)
    x, y = rng.uniform(-30, 30, (2, count))
    together, passes = removal.cut(x, y)
    assert (np.diff(together.ray) >= 0).all()
    alone = [removal.cut(x[k : k + 1], y[k : k + 1]) for k in range(count)]
    for k, (segments, own) in enumerate(alone):
        assert told(together, k) == alike(told(segments, 0)) and passes[k] == own[0]
    monkeypatch.setattr(module, "_PAIRS_HELD", 3 * GROUP)
    monkeypatch.setattr(module, "_PAIRS_AT_ONCE", 2 * GROUP)
    few, again = removal.cut(x, y)
    assert [told(few, k) for k in range(count)] == [alike(told(together, k)) for k in range(count)]
    assert again.tolist() == passes.tolist()


@pytest.fixture
def slots():
    """Return slots along X at y = 5 (two heights) and y = 25.

    The origin of the image coordinates is the block's middle.
    """
    points = [(5, 5, 8), (35, 5, 8), (35, 5, 20), (5, 5, 20), (5, 5, 4), (35, 5, 4)]
    points += [(35, 5, 20), (5, 25, 20), (5, 25, 6), (35, 25, 6)]
    path = toolpath(np.array(points, float))
    return Removal(Cuts([Cut(path, Tool("endmill", 6))]), BOX, View((0, 0, -1), 80, 60).frame(BOX))


def test_ray_is_tested_with_passing_trajectories_only(slots):
    x, y = np.array([0.0, 0.0, 0.0, 30.0]), np.array([-10.0, 0.0, 10.0, 0.0])
    segments, passes = slots.cut(x, y)
    # Each ray in a slot is passed by one move at each height of the slot. The plunges at the ends of the slots are too
    # far away from the rays to cut them.
    assert passes.tolist() == [2, 0, 1, 0]
    assert told(segments, 0) == [[0, 4, UNCUT], pytest.approx([-5, -3, 1]), pytest.approx([-3, 1, 5])]
    assert told(segments, 1) == [[UNCUT], [-5], [5]]
    assert told(segments, 2) == [[8, UNCUT], pytest.approx([-5, -1]), pytest.approx([-1, 5])]
    assert told(segments, 3) == [[], [], []]


def test_single_ray_of_a_group_is_cut(slots):
    for at in range(GROUP):
        passes = slots.cut(np.zeros(GROUP), np.where(np.arange(GROUP) == at, -10.0, 0.0))[1]
        assert np.flatnonzero(passes).tolist() == [at]


@pytest.mark.parametrize(
    ("allowed", "parts"),
    [
        (3, [(0, 16, [0, 0]), (16, 64, [0, 0, 1]), (64, 67, [0, 0])]),
        # A group with more pairs than the limit is processed alone.
        (1, [(0, 16, [0, 0]), (16, 32, [0, 0]), (32, 64, [0]), (64, 67, [0, 0])]),
        (100, [(0, 67, [0, 0, 1, 1, 2, 4, 4])]),
    ],
)
def test_groups_of_rays_are_joined_up_to_a_limit_of_pairs(slots, allowed, parts, monkeypatch):
    """Two, two, one and no trajectories pass the full groups of rays, and two pass the last group of three rays."""
    y = np.repeat([-10.0, -10, 10, 0, -10], GROUP)[: 4 * GROUP + 3]
    monkeypatch.setattr(module, "_PAIRS_HELD", allowed * GROUP)
    found = [(first, last, group.tolist()) for first, last, group, _ in slots._meetings(np.zeros(len(y)), y)]
    assert found == parts


def test_pairs_of_ray_and_trajectory_are_processed_in_batches(slots, monkeypatch):
    sizes, passing = [], slots.passing
    monkeypatch.setattr(slots, "passing", lambda x, y, item: sizes.append(x.size) or passing(x, y, item))
    monkeypatch.setattr(module, "_PAIRS_AT_ONCE", 2 * GROUP)
    assert slots.cut(np.zeros(5 * GROUP), np.full(5 * GROUP, -10.0))[1].tolist() == [2] * 5 * GROUP
    assert sizes == [2 * GROUP] * 5
