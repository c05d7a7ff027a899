# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves that fill the plane with rows are not machining."""

import numpy as np
import pytest

from toolpaths import nonsense
from vkworkbench.core import Strategy
from vkworkbench.core.gcode import linearize
from vkworkbench.core.recognition import recognize


@pytest.mark.parametrize("seed", range(5))
def test_wunderlich_curve_moves_from_cell_to_neighbouring_cell(seed):
    cells = nonsense.wunderlich(np.random.default_rng(seed))
    side = int(np.sqrt(len(cells)))
    assert side in (9, 27)
    assert len(np.unique(cells, axis=0)) == side**2
    assert cells.min() == 0 and cells.max() == side - 1
    assert (np.abs(np.diff(cells, axis=0)).sum(axis=1) == 1).all()


@pytest.mark.parametrize("seed", range(5))
def test_odometer_curve_visits_each_cell_once(seed):
    cells = nonsense.odometer(np.random.default_rng(seed))
    assert len(np.unique(cells, axis=0)) == len(cells) >= 60


@pytest.mark.parametrize("kind", [nonsense.wunderlich, nonsense.odometer, nonsense.morton])
def test_plane_filling_curves_have_the_strategy_unknown(kind):
    paths = [linearize(nonsense.commands(kind, np.random.default_rng([seed, 7]))) for seed in range(10)]
    unknown = sum(recognize(path).strategy is Strategy.UNKNOWN for path in paths)
    assert unknown >= 9
