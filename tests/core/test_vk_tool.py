# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shapes of tools, compared with values computed by hand."""

from __future__ import annotations

from math import inf, pi, sqrt, tan

import numpy as np
import pytest

from vkworkbench.core import COORDINATE_LIMIT, Tool
from vkworkbench.language import Unusable


@pytest.mark.parametrize(
    "tool, heights",
    [
        (Tool("endmill", 10), {0: 0, 3: 0, 5: 0, 5.001: inf}),
        (Tool("endmill", 10, corner_radius=2), {4.9: 0}),  # Only a bull-nose has a corner radius.
        (Tool("ballend", 10), {0: 0, 3: 1, 4: 2, 5: 5, 5.1: inf}),
        (Tool("bullnose", 20, corner_radius=5), {0: 0, 5: 0, 8: 1, 9: 2, 10: 5, 10.1: inf}),
        (Tool("bullnose", 20), {9.9: 0}),
        (Tool("vbit", 10), {0: 0, 1: sqrt(3), 5: 5 * sqrt(3)}),  # The default tip angle is 60 degrees.
        (Tool("vbit", 10, tip_angle=pi / 2), {3: 3, 5: 5, 5.1: inf}),
        (Tool("vbit", 10, tip_angle=pi / 2, tip_diameter=4), {1: 0, 2: 0, 3: 1, 5: 3}),
        (Tool("vbit", 10, tip_angle=pi), {4: 0}),
        (Tool("drill", 10), {0: 0, 2: 2 / tan(59 * pi / 180)}),
        (Tool("drill", 10, tip_angle=pi / 2), {2: 2}),
    ],
)
def test_lower_surface_of_a_tool_has_known_heights(tool, heights):
    told = tool.height(np.array(list(heights)))
    assert told == pytest.approx(list(heights.values()), abs=1e-9)
    assert float(tool.height(3)) == pytest.approx(float(tool.height([3.0])[0]))


def test_profile_of_a_tool_is_constant_beyond_its_rim():
    for shape, rim in (
        ("endmill", 0),
        ("ballend", 5),
        ("bullnose", 2),
        ("vbit", 5 * sqrt(3)),
        ("drill", 5 / tan(59 * pi / 180)),
    ):
        tool = Tool(shape, 10, corner_radius=2)
        assert tool.profile(np.array([5, 5 + 1e-9, 7])) == pytest.approx([rim] * 3)
    rng = np.random.default_rng(1)
    # The diameters and corner radii are random, so that rounding errors of all kinds occur.
    for diameter, share in rng.uniform((0.1, 0), (30, 0.5), (200, 2)):
        tool = Tool("bullnose", diameter, diameter * share)
        assert tool.profile(np.array([diameter])) == pytest.approx([tool.rounding])


def test_tool_has_rounding_and_steepness():
    for shape, rounding, steepness in (("endmill", 0, 0), ("ballend", 5, 0), ("bullnose", 2, 0), ("vbit", 0, sqrt(3)),
                                       ("drill", 0, 1 / tan(59 * pi / 180))):  # fmt: skip
        tool = Tool(shape, 10, corner_radius=2, tip_diameter=3)
        assert (tool.radius, tool.rounding, tool.steepness) == pytest.approx((5, rounding, steepness))
        assert tool.tip == (1.5 if steepness else 0)


@pytest.mark.parametrize(
    "arguments, code",
    [
        (("endmill", 0), "tool-diameter"),
        (("endmill", -1), "tool-diameter"),
        (("endmill", float("nan")), "tool-diameter"),
        (("endmill", 1.001 * COORDINATE_LIMIT), "tool-diameter"),
        (("bullnose", 6, 3.001), "corner-radius"),
        (("bullnose", 6, -0.001), "corner-radius"),
        (("vbit", 6, 0, 0.0), "tip-angle"),
        (("vbit", 6, 0, 3.15), "tip-angle"),
        (("vbit", 6, 0, 1.0, 6.001), "tip-diameter"),
        (("vbit", 6, 0, 1.0, -0.001), "tip-diameter"),
    ],
)
def test_impossible_tools_raise_an_error(arguments, code):
    with pytest.raises(Unusable) as refused:
        Tool(*arguments)
    assert refused.value.what.code == code


def test_tools_at_the_allowed_limits_are_accepted():
    for arguments in (("endmill", COORDINATE_LIMIT), ("bullnose", 6, 3), ("bullnose", 6, 0), ("endmill", 6, 99), ("vbit", 6, 0, pi),
                      ("vbit", 6, 0, 1.0, 6), ("endmill", 1e-6)):  # fmt: skip
        assert Tool(*arguments).diameter == arguments[1]
    with pytest.raises(ValueError, match="unknown tool shape 'saw'"):
        Tool("saw", 6)
