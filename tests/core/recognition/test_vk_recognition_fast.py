# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fast computations return the results of the straightforward computations."""

import numpy as np
import pytest

from vkworkbench.core.gcode import linearize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.patterns.entries import find_entry, without_entries
from vkworkbench.core.recognition.patterns.footprints import count_depths
from vkworkbench.core.recognition.patterns.neighbours import _percentiles
from vkworkbench.core.recognition.patterns.rows import median
from vkworkbench.core.recognition.thresholds import ROUNDING


@pytest.mark.parametrize("number", [1, 2, 3, 8, 101, 1000])
def test_fast_median_equals_the_median_of_numpy(number):
    rng = np.random.default_rng(number)
    for values in (rng.normal(size=number), rng.integers(0, 4, number).astype(float)):
        assert median(values) == np.median(values)


def test_fast_percentiles_by_row_equal_those_of_numpy():
    rng = np.random.default_rng(0)
    values, percent = rng.normal(size=(2000, 16)), (10, 50, 90)
    of = rng.random(values.shape) < rng.random((2000, 1))
    of[:, 0] = True  # Each row has at least one value.
    of[:20] = True
    expected = np.nanpercentile(np.where(of, values, np.nan), percent, axis=1)
    assert np.array_equal(_percentiles(values, of, percent), expected)


@pytest.mark.parametrize(
    ("z", "depths"),
    [
        ([], 0),
        ([-1.0], 1),
        ([-1.0, -1.0 - ROUNDING.HEIGHT / 2], 1),
        ([0.0, 2 * ROUNDING.HEIGHT, 0.0], 2),
        (
            [0.0, 0.6 * ROUNDING.HEIGHT, 1.2 * ROUNDING.HEIGHT],
            1,
        ),  # Neighbouring heights are close.
        ([-3.0, -1.0, -3.0, -2.0], 3),
    ],
)
def test_depths_are_groups_of_heights_with_gaps(z, depths):
    assert count_depths(np.array(z)) == depths


def test_path_without_heights_has_no_entries():
    square = [("G1", {"X": x, "Y": y, "Z": -1.0, "F": 5.0}) for x, y in ((0, 0), (9, 0), (9, 9), (0, 9), (0, 0))]
    level = monotonous_areas(linearize([("G0", {"X": 0.0, "Y": 0.0, "Z": -1.0}), *square]))
    assert not level.dz.any()
    assert find_entry(level) == "plunge"
    pattern, wound = without_entries(level)
    assert pattern is level
    assert wound == 0
