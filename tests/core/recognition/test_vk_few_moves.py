# SPDX-License-Identifier: LGPL-2.1-or-later
"""Toolpaths of few moves, whose random parameters differ from the toolpaths with which the model was trained."""

from __future__ import annotations

import numpy as np
import pytest

from toolpaths.few_moves import SAMPLES
from vkworkbench.core import linearize, recognize

SEEDS = range(1000, 1020)


@pytest.mark.long
@pytest.mark.parametrize("label, accepted, make", [pytest.param(*s, id=s[0]) for s in SAMPLES])
def test_most_toolpaths_of_few_moves_are_recognized(label, accepted, make):
    """Nine in ten toolpaths are recognised. The tool's diameter is given if the generator returns a diameter."""
    right = 0
    for seed in SEEDS:
        made = make(np.random.default_rng(seed))
        commands, tool = made if isinstance(made, tuple) else (made, None)
        right += recognize(linearize(commands), tool_diameter=tool).strategy in accepted
    assert right >= 0.9 * len(SEEDS), f"{label}: {right} of {len(SEEDS)}"


@pytest.mark.parametrize("gap", [0.3, 0.5, 2.5])
@pytest.mark.parametrize("depths", [1, 3])
def test_two_walls_of_a_slot_are_a_profile(gap, depths):
    """Each wall is cut at all depths before the other wall, with leads at both ends.

    `gap` is the distance of the walls in tool diameters.
    """
    commands = [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0})]
    for x, lead, (start, end) in ((0.0, 0.7, (0.0, 18.0)), (2.0 * gap, -0.7, (18.0, 0.0))):
        onward = 0.7 if end > start else -0.7
        for depth in range(1, depths + 1):
            commands += [("G0", {"X": x + lead, "Y": start - onward}), ("G0", {"Z": 1.0}), ("G1", {"Z": -float(depth)})]
            commands += [("G1", {"X": x, "Y": start}), ("G1", {"Y": end}), ("G1", {"X": x + lead, "Y": end + onward})]
            commands += [("G0", {"Z": 5.0})]
    assert recognize(linearize(commands), tool_diameter=2.0).strategy == "profile"
