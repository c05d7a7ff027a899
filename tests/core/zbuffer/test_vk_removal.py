# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scattered rays: each is cut as if it were alone, however many there are and however few are worked on at once."""

from __future__ import annotations

import numpy as np
import pytest
from zbuffer_reference.paths import BOX, PATHS, TOOLS, toolpath

from vkworkbench.core import Cut, Tool, View
from vkworkbench.core.zbuffer import removal as module
from vkworkbench.core.zbuffer.cuts import Cuts
from vkworkbench.core.zbuffer.dexels import UNCUT
from vkworkbench.core.zbuffer.removal import GROUP, Removal


def random_removal(seed, direction):
    rng = np.random.default_rng(seed)
    cuts = [
        Cut(toolpath(PATHS[(seed + k) % len(PATHS)](rng, 30)), TOOLS[(3 * seed + k) % len(TOOLS)]) for k in range(2)
    ]
    return Removal(Cuts(cuts), BOX, View(direction, 80, 60).frame(BOX)), rng


def told(pieces, ray):
    own = pieces.ray == ray
    return [values[own].tolist() for values in (pieces.owner, pieces.near, pieces.far)]


def alike(told):
    """But for the last bits, which depend on how many rays are worked on at once."""
    owner, *ends = told
    return [owner, *map(pytest.approx, ends)]


@pytest.mark.parametrize("direction", [(0, 0, -1), (0, 0, 1), (1, 1, -1), (1, 0.5, -0.3)])
@pytest.mark.parametrize("count", [1, GROUP, 5 * GROUP + 3])
def test_a_ray_is_cut_as_if_it_were_alone(count, direction, monkeypatch):
    """A third of them beside the stock; with room for a few pairs as with room for all."""
    removal, rng = random_removal(count, direction)
    x, y = rng.uniform(-30, 30, (2, count))
    together, passes = removal.cut(x, y)
    assert (np.diff(together.ray) >= 0).all()
    alone = [removal.cut(x[k : k + 1], y[k : k + 1]) for k in range(count)]
    for k, (pieces, own) in enumerate(alone):
        assert told(together, k) == alike(told(pieces, 0)) and passes[k] == own[0]
    monkeypatch.setattr(module, "_PAIRS_HELD", 3 * GROUP)
    monkeypatch.setattr(module, "_PAIRS_AT_ONCE", 2 * GROUP)
    few, again = removal.cut(x, y)
    assert [told(few, k) for k in range(count)] == [alike(told(together, k)) for k in range(count)]
    assert again.tolist() == passes.tolist()


@pytest.fixture
def slots():
    """Slots of 6 mm along X at y = 5 and 25, cut at two heights each; image coordinates count from the block's middle."""
    points = [(5, 5, 8), (35, 5, 8), (35, 5, 20), (5, 5, 20), (5, 5, 4), (35, 5, 4)]
    points += [(35, 5, 20), (5, 25, 20), (5, 25, 6), (35, 25, 6)]
    path = toolpath(np.array(points, float))
    return Removal(Cuts([Cut(path, Tool("endmill", 6))]), BOX, View((0, 0, -1), 80, 60).frame(BOX))


def test_a_ray_is_examined_with_what_passes_it_and_one_beside_the_stock_with_nothing(slots):
    x, y = np.array([0.0, 0.0, 0.0, 30.0]), np.array([-10.0, 0.0, 10.0, 0.0])
    pieces, passes = slots.cut(x, y)
    # By the move at each height; the plunges at the ends are beside it.
    assert passes.tolist() == [2, 0, 1, 0]
    assert told(pieces, 0) == [[0, 4, UNCUT], pytest.approx([-5, -3, 1]), pytest.approx([-3, 1, 5])]
    assert told(pieces, 1) == [[UNCUT], [-5], [5]]
    assert told(pieces, 2) == [[8, UNCUT], pytest.approx([-5, -1]), pytest.approx([-1, 5])]
    assert told(pieces, 3) == [[], [], []]


@pytest.mark.parametrize("at", range(GROUP))
def test_a_ray_is_cut_though_no_neighbour_is(slots, at):
    passes = slots.cut(np.zeros(GROUP), np.where(np.arange(GROUP) == at, -10.0, 0.0))[1]
    assert np.flatnonzero(passes).tolist() == [at]


def test_of_seventy_thousand_rays_each_is_cut_as_it_is_among_fewer(slots):
    x, y = np.random.default_rng(7).uniform((-19, -14), (19, 14), (70_000, 2)).T
    pieces, passes = slots.cut(x, y)
    first, second = (slots.cut(x[some], y[some]) for some in (slice(40_000), slice(40_000, None)))
    assert passes.tolist() == [*first[1], *second[1]]
    assert pieces.owner.tolist() == [*first[0].owner, *second[0].owner]
    assert pieces.near == pytest.approx(np.concatenate((first[0].near, second[0].near)))


def test_only_selected_trajectories_cut():
    removal, rng = random_removal(4, (0, 1, -1))
    x, y = rng.uniform(-15, 15, (2, 40))
    some = np.arange(0, len(removal.index), 2)
    pieces, passes = removal.cut(x, y, some)
    assert set(pieces.owner.tolist()) <= {*removal.index[some].tolist(), UNCUT}
    assert (passes <= removal.cut(x, y)[1]).all() and 0 < passes.sum() < removal.cut(x, y)[1].sum()
    nothing, none = removal.cut(x, y, np.empty(0, np.int64))
    assert not none.any() and set(nothing.owner.tolist()) == {UNCUT}
