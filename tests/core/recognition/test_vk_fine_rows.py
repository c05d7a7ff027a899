# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows much closer than the tool's diameter are rows. A pass that is repeated in the same place is not a row."""

from __future__ import annotations

import numpy as np
import programs
import pytest

from toolpaths.fine_rows import SHAPES, WAYS, fine_rows
from vkworkbench.core import linearize, recognize

CONTOURS = {
    "line": [(0, 0), (60, 0)],
    "corner": [(0, 0), (60, 0), (60, 40)],
    "bay": [(0, 40), (0, 0), (60, 0), (60, 40)],
}


@pytest.mark.long
@pytest.mark.parametrize("seed", range(40))
def test_fine_rows_keep_strategy_and_stepover(seed):
    rows = fine_rows(np.random.default_rng(seed), WAYS[seed % len(WAYS)], SHAPES[seed // len(WAYS) % len(SHAPES)])
    found = recognize(linearize(rows.commands), tool_diameter=rows.tool)
    assert found.strategy == rows.strategy
    assert found.stepover == pytest.approx(rows.stepover, rel=0.05)
    assert found.confidence > 0.8


def test_zigzag_of_the_paper_has_a_high_confidence():
    """The paper's zigzag has 17,000 trajectories in rows 0.0094 mm apart, for a tool of 6 mm."""
    found = recognize(linearize(programs.zigzag(8500, 80.0, 0.0094)), tool_diameter=6.0)
    assert (found.strategy, found.passes) == ("zigzag", 8500)
    assert found.stepover == pytest.approx(0.0094)
    assert found.confidence > 0.9


def repeated(contour, count, shift, deeper):
    """Return the commands of a repeated contour, each time shifted sideways and deeper, mm."""
    commands = []
    for k in range(count):
        points = np.array(contour, float) + shift(k)
        commands += [("G0", {"Z": 5.0}), ("G0", dict(zip("XY", points[0]))), ("G1", {"Z": -1.0 - deeper * k})]
        commands += [("G1", dict(zip("XY", point))) for point in points[1:]]
    return commands


@pytest.mark.parametrize("contour", CONTOURS)
@pytest.mark.parametrize("deeper", [0.0, 0.5])
def test_repeated_contour_is_not_rows(contour, deeper):
    """Rounding moves the passes by up to 0.002 mm in any direction."""
    noise = np.random.default_rng(3).uniform(-0.002, 0.002, 40)
    found = recognize(linearize(repeated(CONTOURS[contour], 40, noise.__getitem__, deeper)), tool_diameter=6.0)
    assert found.strategy == "profile"


@pytest.mark.parametrize("shift", [0.01, 0.05])
def test_passes_down_a_slanted_wall_are_not_rows(shift):
    """Each pass moves farther down than sideways."""
    commands = repeated(CONTOURS["line"], 40, lambda k: np.array([0.0, shift * k]), 0.5)
    assert recognize(linearize(commands), tool_diameter=6.0).strategy in ("profile", "waterline")
