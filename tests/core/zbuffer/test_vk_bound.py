# SPDX-License-Identifier: LGPL-2.1-or-later
"""The quick bound of the memory is one, and what surely cuts does."""

from __future__ import annotations

import numpy as np
import pytest

from toolpaths.synthetic import SAMPLES
from vkworkbench.core import Stock, Tool, View, linearize, simulate
from vkworkbench.core.solids import ConvexStock
from vkworkbench.core.zbuffer import cuts_surely, may_cut, most_bytes

TOOLS = [Tool("endmill", 5), Tool("ballend", 6), Tool("vbit", 8, tip_angle=np.pi / 2)]


@pytest.mark.parametrize("tool", TOOLS, ids=lambda tool: tool.shape)
@pytest.mark.parametrize("direction", [(0, 0, -1), (1, 1, -1), (0, 1, 0)])
def test_no_simulation_holds_more_than_the_bound(tool, direction):
    rng = np.random.default_rng(7)
    bounds = 0
    for _, _, maker in SAMPLES[::6]:
        path = linearize(maker(rng))
        path = path.part(0, min(len(path), 400))
        if not len(path):
            continue
        lower, upper = path.points.min(axis=0) - 3, path.points.max(axis=0) + 3
        stock, view = Stock(lower, [*upper[:2], max(lower[2] + 1, 0.0)]), View(direction, 60, 45)
        held = simulate(path, tool=tool, stock=stock, view=view)
        bound = most_bytes(path, tool=tool, stock=stock, view=view)
        assert held.memory_bytes <= bound
        bounds += np.isfinite(bound)
        if cuts_surely(path, stock) and direction == (0, 0, -1):  # from the side a pixel may be higher than the cut
            assert held.traces
    assert bounds > 5


def test_other_solids_have_no_bound_and_nothing_is_sure_of_them():
    path = linearize([("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"Z": -2.0})])
    cylinder = ConvexStock.cylinder(np.array([0.0, 0.0, -5.0]), 10.0, 5.0)
    assert np.isfinite(most_bytes(path, tool=TOOLS[0], stock=cylinder, view=View())) and not cuts_surely(path, cylinder)
    assert most_bytes(path, tool=TOOLS[0], stock=Holed(), view=View()) == np.inf
    assert cuts_surely(path, Stock((-9, -9, -5), (9, 9, 0))) and not cuts_surely(path, Stock((1, 1, -5), (9, 9, 0)))


class Holed:
    """A solid that no planes bound."""


def test_what_may_cut():
    path = linearize([("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"X": 20.0}), ("G1", {"Z": 1.0})])
    tool = Tool("endmill", 10)
    for lower, upper, may in (
        ((0, 0, 0), (9, 9, 2), True), ((0, 0, 0), (9, 9, 1), False), ((0, 4.9, 0), (9, 9, 2), True), ((0, 5, 0), (9, 9, 2), False),
        ((24.9, 0, 0), (30, 9, 2), True), ((25, 0, 0), (30, 9, 2), False), ((-30, 0, 0), (-5, 9, 2), False),
    ):  # fmt: skip
        assert may_cut(path, tool, Stock(lower, upper)) is may, (lower, upper)
        assert may or simulate(path, tool=tool, stock=Stock(lower, upper), view=View((0, 0, -1), 40, 40)).traces == 0
