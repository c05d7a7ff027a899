# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of the strategies differ for all people."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from vkworkbench.core import Strategy

COLORS = {strategy.value: strategy.color for strategy in Strategy if strategy is not Strategy.EMPTY}
# Matrix from linear sRGB to CIE XYZ, with the white of sRGB.
XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
WHITE = XYZ.sum(axis=1)
# Matrices from linear sRGB to the colours seen by a person without green cones (Vienot, Brettel and Mollon 1999;
# Machado, Oliveira and Fernandes 2009).
SIGHTS = {
    "everybody": np.eye(3),
    "deuteranope, Vienot": np.array([[0.29275, 0.70725, 0.0], [0.29275, 0.70725, 0.0], [-0.02234, 0.02234, 1.0]]),
    "deuteranope, Machado": np.array([
        [0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881],
    ]),
}  # fmt: skip
LEAST = {
    "everybody": 20.0,
    "deuteranope, Vienot": 10.0,
    "deuteranope, Machado": 10.0,
}  # minimum differences of the strategies' colours in CIELAB (CIE 1976)


def linear(color):
    shares = np.array([int(color[first : first + 2], 16) for first in (1, 3, 5)]) / 255
    return np.where(shares <= 0.04045, shares / 12.92, ((shares + 0.055) / 1.055) ** 2.4)


def lab(rgb):
    """Return the position of a linear sRGB colour in CIELAB."""
    x, y, z = np.cbrt(np.clip(XYZ @ rgb / WHITE, 0.008856, None))
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


@pytest.mark.parametrize("sight", SIGHTS)
def test_colors_of_strategies_differ_for_all_people(sight):
    seen = {name: lab(np.clip(SIGHTS[sight] @ linear(color), 0, 1)) for name, color in COLORS.items()}
    close = [(one, other) for one, other in combinations(seen, 2)
             if np.linalg.norm(seen[one] - seen[other]) < LEAST[sight]]  # fmt: skip
    assert close == []


@pytest.mark.parametrize("name", COLORS)
def test_white_text_on_a_strategy_color_is_readable(name):
    luminance = XYZ[1] @ linear(COLORS[name])
    assert 1.05 / (luminance + 0.05) >= 4.5
