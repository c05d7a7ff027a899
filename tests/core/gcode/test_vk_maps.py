# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coordinates are mirrored, scaled and rotated like Fanuc's controls and LinuxCNC do."""

import numpy as np
import pytest

from vkworkbench.core.gcode import read_program

BEFORE = "G21 G90 G17\nG0 X0 Y0 Z5\nG1 Z-1 F60\n"


def path(text):
    return read_program(BEFORE + text).toolpath()


def places(text):
    """Return the points of the toolpath after the plunge, with four decimals."""
    return (path(text).points[2:].round(4) + 0.0).tolist()


def codes(text):
    return [(problem.what.code, problem.what.arguments.get("name")) for problem in path(text).problems]


@pytest.mark.parametrize("text, ends", [
    ("G68 X0 Y0 R90\nX10\nY5\nG69\nX1 Y1", [[0, 10, -1], [-5, 10, -1], [1, 1, -1]]),
    ("G68 X10 Y0 R90\nX20 Y0\nY5", [[10, 10, -1], [5, 10, -1]]),  # A line without X keeps the last programmed X.
    ("G68 X0 Y0 R30\nX10\nG91 Y10", [[8.6603, 5, -1], [3.6603, 13.6603, -1]]),
    # If G68 has no X and Y, the centre of the rotation is the tool's position.
    ("X4 Y0\nG68 R180\nX6", [[4, 0, -1], [2, 0, -1]]),
    ("G68 X0 Y0 R-90\nX10 Y0\nX10 Y2 Z-3", [[0, -10, -1], [2, -10, -3]]),
    ("G51 X0 Y0 Z0 P2000\nX5\nG91 Y3 Z-1\nG90 G50\nX1", [[10, 0, -1], [10, 6, -3], [1, 6, -3]]),
    ("G51 X2 Y0 I0.5 J0.5\nX10 Z-2", [[6, 0, -2]]),
    ("G51.1 X0\nX5 Y3\nG91 X1\nG90 G50.1\nX2", [[-5, 3, -1], [-6, 3, -1], [2, 3, -1]]),
    ("G51.1 X10 Y0\nX5 Y3", [[15, -3, -1]]),
    ("G51.1 X0\nG68 X0 Y0 R90\nX5 Y0", [[0, -5, -1]]),  # The control mirrors first, and then rotates.
    ("G52 X100\nG68 X0 Y0 R90\nX10 Y0", [[100, 10, -1]]),
    ("G10 L2 P1 R90\nX10 Y0\nG92 X0 Y0\nX5 Y0", [[0, 10, -1], [0, 15, -1]]),
    ("G10 L2 P0 R90\nX10 Y0", [[0, 10, -1]]),
    ("G10 L2 P1 R90\nX10\nG10 L2 P1 R0\nX0 Y0", [[0, 10, -1], [0, 0, -1]]),
    ("G20 G68 X1 Y0 R90\nX2 Y0", [[25.4, 25.4, -1]]),
])  # fmt: skip
def test_lines_are_mirrored_scaled_and_rotated(text, ends):
    assert places(text) == ends
    assert codes(text) == []


@pytest.mark.parametrize("code, turns, centre, radius", [
    ("G68 X0 Y0 R90", -1, [0, 5], 5), ("G51 X0 Y0 P3", -1, [15, 0], 15), ("G51.1 X0", 1, [-5, 0], 5),
    ("G51.1 X0 Y0", -1, [-5, 0], 5), ("G10 L2 P1 R180", -1, [-5, 0], 5),
])  # fmt: skip
@pytest.mark.parametrize("arc", ["G2 X10 Y0 I5 J0", "G2 X10 Y0 R5", "G90.1 G2 X10 Y0 I5 J0", "G91 G2 X10 I5"])
def test_mirrored_scaled_and_rotated_arcs_keep_their_shape(code, turns, centre, radius, arc):
    """Mirroring along one axis reverses the sense of an arc, and mirroring along two axes does not."""
    mapped = path(f"{code}\n{arc}")
    assert mapped.sweep.sum() == pytest.approx(turns * np.pi)
    ways = mapped.points[2:, :2] - centre
    np.testing.assert_allclose(np.hypot(*ways.T), radius, atol=1e-6)
    assert mapped.problems == ()


def test_rotation_of_an_unused_work_offset_changes_nothing():
    assert places("G10 L2 P2 R90\nX10 Y0\nG10 L20 P1 X0\nX5\nG41.1 D4 G1 X35\nX60") == [
        [10, 0, -1], [15, 0, -1], [45, 2, -1], [70, 2, -1]
    ]  # fmt: skip
    assert codes("G10 L2 P2 R90\nX10 Y0") == []


def test_holes_are_rotated_and_scaled():
    text = "G68 X0 Y0 R90\nG99 G81 X10 Y0 Z-3 R2\nX20\nG80\nG69"
    assert [point for point in places(text) if point[2] == -3] == [[0, 10, -3], [0, 20, -3]]
    deep = "G51 X0 Y0 Z0 P2.\nG99 G83 X1 Y0 Z-4 R1 Q2\nG80\nG50"
    heights = [point[2] for point in places(deep)]
    # After scaling by 2, each peck is 4 mm deep, the first from the R plane.
    assert min(heights) == -8 and heights[-1] == 2 and -2 in heights


@pytest.mark.parametrize("code, name", [
    ("G68 X0 Y0", "G68"), ("G68 X0 Y0 Z0 I0 J0 K1 R30", "G68"), ("G91 G68 X0 Y0 R30", "G68"), ("G68.2 X0 Y0 Z0 I0 J30 K0", "G68.2"),
    ("G51 X0 Y0", "G51"), ("G51 X0 Y0 I1 J2", "G51"), ("G51 P0", "G51"), ("G51.1 Z0", "G51.1"), ("G91 G51.1 X0", "G51.1"),
    ("G68 X0 Y0 R30 G18", "G68"), ("G68 X0 Y0 R30\nG92 X1", "G92"), ("G51.1 X0\nG52 X1", "G52"),
    ("G10 L2 P1 R30\nG10 L20 P2 X0", "G10"), ("G10 L2 P2 R30\nG10 L20 P2 X0", "G10"),
])  # fmt: skip
def test_rotation_or_scaling_that_is_ignored_has_a_remark(code, name):
    assert codes(f"{code}\nG2 X5 Z-1 R9") == [("coordinates-not-changed", name)]
