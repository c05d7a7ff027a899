# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the traces tell, on cuts whose volumes are known and on faults made on purpose."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from zbuffer_reference.paths import DIRECTIONS, helix, toolpath

from vkworkbench.core import Stock, Tool, View
from vkworkbench.core.zbuffer import (
    air_share,
    crashes,
    engagement,
    records,
    removal_rates,
    removed_volumes,
    simulate,
)

FLAT = Tool("endmill", 6)
STOCK = Stock((0, 0, 0), (40, 30, 10))
VIEW = View((1, 1, -1), 120, 90)


def cut(points, rapid=(), direction=(0, 0, -1)):
    path = toolpath(np.array(points, float))
    fast = np.zeros(len(path), bool)
    fast[list(rapid)] = True
    path = replace(path, rapid=fast, feed=np.where(fast, 0.0, 10.0))
    return simulate(path, tool=FLAT, stock=STOCK, view=View(direction))


@pytest.mark.parametrize("direction", DIRECTIONS)
def test_each_trajectory_removes_its_own(direction):
    z = cut([(10, 15, 12), (10, 15, 6), (30, 15, 6), (10, 15, 6), (10, 15, 4)], direction=direction)
    volumes = removed_volumes(z)
    assert volumes == pytest.approx([9 * pi * 4, 20 * 6 * 4, 0, 9 * pi * 2], rel=0.03, abs=0.1)
    assert volumes.sum() == pytest.approx(z.chip_volume)


def test_volumes_are_those_of_all_chips():
    z = simulate(toolpath(helix(None, 300)), tool=FLAT, stock=STOCK, view=View((1, 1, -1), 200, 150))
    assert removed_volumes(z).sum() == pytest.approx(z.chip_volume)
    assert removed_volumes(z.at(5)) == pytest.approx(removed_volumes(z))


def test_rates_follow_the_feed():
    z = cut([(10, 15, 6), (30, 15, 6), (30, 25, 12)], rapid=[1])
    rates = removal_rates(z)
    assert rates[0] == pytest.approx(60 * removed_volumes(z)[0] / 2)
    assert np.isnan(rates[1])


def test_air_is_what_removes_nothing():
    z = cut([(10, 15, 6), (30, 15, 6), (10, 15, 6), (10, 15, 40), (10, 20, 40)], rapid=[2])
    assert air_share(z) == pytest.approx(25 / 45)
    nothing = cut([(10, 15, 20)])
    assert air_share(nothing) == 0


@pytest.mark.parametrize("direction", DIRECTIONS)
def test_a_rapid_through_the_stock_is_found(direction):
    sound = [(10, 15, 12), (10, 15, 6), (20, 15, 6), (20, 15, 12)]
    z = cut(sound, rapid=[2], direction=direction)
    assert crashes(z) == []
    z = cut([*sound, (30, 15, 12), (30, 15, 7), (30, 25, 7)], rapid=[2, 3, 4, 5], direction=direction)
    found = crashes(z)
    assert [c.trajectory for c in found] == [4, 5]
    assert [c.source.command for c in found] == [4, 5]
    assert found[0].volume == pytest.approx(9 * pi * 3, rel=0.03)
    x, y, height = found[0].place
    assert np.hypot(x - 30, y - 15) < 3.1 and 7 <= height <= 10
    if direction == (0, 0, -1):
        assert found[0].depth == pytest.approx(3)


def test_what_is_worked_out_block_by_block_is_as_of_the_whole(monkeypatch):
    path = toolpath(helix(None, 300))
    path = replace(path, rapid=np.arange(len(path)) % 7 == 0)

    def found():
        z = simulate(path, tool=FLAT, stock=STOCK, view=VIEW)
        moments = [z.at(step).picture for step in (300, 120, 0, 299)]
        return (removed_volumes(z), *engagement(z), [c.place for c in crashes(z)],
                *(part for p in moments for part in (p.depth, p.owner)))  # fmt: skip

    whole = found()
    monkeypatch.setattr(records, "_BLOCK", 1)
    z = simulate(path, tool=FLAT, stock=STOCK, view=VIEW)
    assert len(list(z.records.blocks())) > 100
    for one, other in zip(whole, found()):
        np.testing.assert_allclose(one, other, rtol=1e-12)
