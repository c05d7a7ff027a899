# SPDX-License-Identifier: LGPL-2.1-or-later
"""G52 shifts the coordinates of the following moves, for example for several parts in a fixture."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core.gcode.dialects import at_line
from vkworkbench.core.gcode.reader import read_program
from vkworkbench.language import render

BEFORE = "G21 G90 G17\nG0 X0 Y0 Z5\nF60\n"


def points(text):
    path = read_program(BEFORE + text).toolpath()
    return [tuple(point) for point in (np.round(path.points, 6) + 0.0).tolist()]


def said(text):
    return [render(at_line(problem)) for problem in read_program(BEFORE + text).problems]


def test_shift_moves_named_coordinates_only():
    text = "G52 X100 Y-50 Z1\nG1 Z-1\nX5\nY5\nG52 X200\nX5\nG52 X0 Y0 Z0\nX0 Y0"
    assert points(text) == [
        (0, 0, 5), (0, 0, 0), (105, 0, 0), (105, -45, 0), (205, -45, 0), (0, 0, 0),
    ]  # fmt: skip
    assert said(text) == []


def test_shift_uses_current_units_and_not_relative_moves():
    assert points("G20 G55 G52 X1\nG91 G1 X1\nX1\nG90 X0") == [(0, 0, 5), (25.4, 0, 5), (50.8, 0, 5), (25.4, 0, 5)]


@pytest.mark.parametrize("code", ["G2 X10 Y0 I5 J0", "G90.1 G2 X10 Y0 I5 J0", "G2 X10 Y0 R5"])
def test_arcs_keep_their_shape(code):
    there = np.array(points(f"G1 X0 Y0 Z-1\n{code}")[1:])
    shifted = np.array(points(f"G52 X100 Z2\nG1 X0 Y0 Z-1\n{code}")[1:])
    assert len(there) > 10
    np.testing.assert_allclose(shifted - there, np.tile([100, 0, 2], (len(there), 1)), atol=1e-6)


def test_local_shift_moves_holes_and_retract_level():
    holes = [point for point in points("G52 X100 Z2\nG98 G81 X0 Y0 Z-3 R1\nX10\nG80") if point[2] < 5]
    assert holes == [(100, 0, 3), (100, 0, -1), (110, 0, 3), (110, 0, -1)]


def test_without_axes_it_is_another_code():
    assert said("G1 X1\nG52\nX2") == [
        "Line 5: G52 is ignored. The coordinates after it are read as if it were not there."
    ]
