# SPDX-License-Identifier: LGPL-2.1-or-later
"""G52, G92 and G10 shift the coordinates of the following moves, for example for several parts in a fixture."""

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


def test_g52_shifts_the_named_coordinates_only():
    text = "G52 X100 Y-50 Z1\nG1 Z-1\nX5\nY5\nG52 X200\nX5\nG52 X0 Y0 Z0\nX0 Y0"
    assert points(text) == [
        (0, 0, 5), (0, 0, 0), (105, 0, 0), (105, -45, 0), (205, -45, 0), (0, 0, 0),
    ]  # fmt: skip
    assert said(text) == []


def test_g52_uses_current_units_and_not_relative_moves():
    assert points("G20 G55 G52 X1\nG91 G1 X1\nX1\nG90 X0") == [(0, 0, 5), (25.4, 0, 5), (50.8, 0, 5), (25.4, 0, 5)]


@pytest.mark.parametrize("code", ["G2 X10 Y0 I5 J0", "G90.1 G2 X10 Y0 I5 J0", "G2 X10 Y0 R5"])
def test_arcs_shifted_by_g52_keep_their_shape(code):
    there = np.array(points(f"G1 X0 Y0 Z-1\n{code}")[1:])
    shifted = np.array(points(f"G52 X100 Z2\nG1 X0 Y0 Z-1\n{code}")[1:])
    assert len(there) > 10
    np.testing.assert_allclose(shifted - there, np.tile([100, 0, 2], (len(there), 1)), atol=1e-6)


def test_g52_shifts_holes_and_retract_height():
    holes = [point for point in points("G52 X100 Z2\nG98 G81 X0 Y0 Z-3 R1\nX10\nG80") if point[2] < 5]
    assert holes == [(100, 0, 3), (100, 0, -1), (110, 0, 3), (110, 0, -1)]


def test_g52_without_axes_is_ignored_with_a_remark():
    assert said("G1 X1\nG52\nX2") == [
        "Line 5: G52 is ignored. The coordinates after it are read as if it were not there."
    ]


SQUARE = "G1 X9\nY9\nX0\nY0\n"


def test_g92_shifts_the_coordinates():
    copies = points(f"{SQUARE}G0 X20\nG92 X0 Y0\n{SQUARE}G0 Y20\nG92 Y0\n{SQUARE}G92.1\nG0 X1 Y1")
    assert (29, 9, 5) in copies and (29, 29, 5) in copies and copies[-1] == (1, 1, 5)
    assert said(f"{SQUARE}G0 X20\nG92 X0 Y0\n{SQUARE}") == []


def test_g92_with_the_current_position_changes_nothing():
    assert points("G92 X0 Y0 Z5\nG1 X3") == points("G1 X3") and said("G92 X0 Y0 Z5\nG1 X3") == []


def test_g92_shift_is_suspended_and_resumed():
    assert points("G1 X20\nG92 X0\nG92.2\nX1\nG92.3\nX1")[-2:] == [(1, 0, 5), (21, 0, 5)]
    assert points("G1 X20\nG92 X0\nG92.2\nG92 Y0\nG92.3\nX1")[-1] == (1, 0, 5)
    assert points("G52 X50\nG1 X1\nG92.1\nX1")[-1] == (1, 0, 5)  # LinuxCNC has one common shift for G52 and G92.


def test_g52_shifts_absolute_arc_centres_under_g91():
    plain = points("G1 X0 Y0\nG90.1 G91\nG3 X10 Y0 I5 J0")
    shifted = points("G52 X100\nG1 X0 Y0\nG90.1 G91\nG3 X10 Y0 I5 J0")
    np.testing.assert_allclose(np.array(shifted[-9:]) - plain[-9:], np.tile([100, 0, 0], (9, 1)), atol=1e-6)


@pytest.mark.parametrize("away", ["G28 X0", "G53 G0 X0", "M0", "M6 T2", "G38.2 X5 F50", "G28"])
def test_g92_at_an_unknown_position_is_ignored(away):
    text = f"G1 X20\n{away}\nG92 X0\nG1 X3"
    assert points(text)[-1][0] == 3
    assert any("G92 is ignored" in sentence for sentence in said(text))


def test_g92_after_a_cycle_uses_the_position_after_the_cycle():
    assert points("G99 G81 X1 Y1 Z-4 R2 F100\nG80\nG92 Z0\nG1 Z1")[-1] == (1, 1, 3)
    assert points("G98 G91 G81 X1 Y1 Z-4 R-2 F100\nX1\nG80 G90\nG92 X0 Z0\nG1 X1 Z1")[-1] == (3, 1, 6)


def test_work_offsets_of_g10_l2_are_read():
    begin = "G10 L2 P1 X100 Y100 Z0\nG10 L2 P2 X150 Y100 Z0\nG54\n"
    path = read_program(begin + "G0 X0 Y0 Z5\nG1 X1 F60\nG55\nX1 Y1\nG54\nX1").toolpath()
    assert path.points[1:].tolist() == [[1, 0, 5], [51, 1, 5], [1, 1, 5]] and not path.problems


def test_work_offsets_of_g10_l20_are_read():
    text = "G1 X20 Y10\nG10 L20 P2 X0 Y0 Z5\nG55\nX3 Y4\nG54\nX1"
    assert points(text)[-2:] == [(23, 14, 5), (1, 14, 5)] and said(text) == []


def test_g10_p0_is_the_current_work_offset_except_on_fanuc():
    assert points("G55\nG10 L20 P0 X5\nX6")[-1] == (1, 0, 5)
    assert points("G10 L2 P0 X5\nG1 X6")[-1] == (11, 0, 5) and "read as 0" in said("G10 L2 P0 X5\nG1 X6")[0]
    fanuc = read_program("O1000\nG21\nG0 X0 Y0 Z5\nG10 L20 P0 X5\nG10 L2 P0 X5\nG1 X6 F60")
    assert fanuc.toolpath().points[-1].tolist() == [6, 0, 5]
    assert [(problem.what.code, problem.count) for problem in fanuc.problems] == [("coordinates-not-changed", 2)]


def test_rotation_of_a_work_offset_is_read():
    assert points("G10 L2 P1 R30\nG1 X10")[-1] == (8.660254, 5, 5)
    rotated = read_program("G10 L2 P1 R30\nG21\nG0 X0 Y0 Z5\nG1 X10 F60")
    assert rotated.toolpath().points[-1].round(6).tolist() == [8.660254, 5, 5] and rotated.problems == ()


def test_polar_coordinates_of_linuxcnc_are_read():
    assert points("G1 @10 ^90")[-1] == (0, 10, 5) and points("G1 X3 Y4\n@10")[-1] == (6, 8, 5)
    assert points("G52 X100\nG1 @10 ^0")[-1] == (110, 0, 5)
    assert points("G1 X10\nG91 ^90")[-1] == (0, 10, 5)


def test_splines_end_at_their_target():
    spline = np.array(points("G5 I0 J3 P0 Q3 X1 Y1\nG1 Y9"))
    assert len(spline) > 20 and tuple(spline[-2]) == (1, 1, 5)
    assert np.abs(spline - (0.5, 2.75, 5)).max(axis=1).min() < 0.05
    middle = np.array(points("G5.1 X10 Y0 I5 J10"))
    assert abs(middle[:, 1].max() - 5) < 0.01  # A parabola rises to half the height of its control point.


def test_thread_feed_is_pitch_times_speed():
    path = read_program("G21 G90\nS500 M3\nG0 X1 Y1 Z5\nF60\nG33.1 Z-10 K0.8\nG1 X9").toolpath()
    assert path.points[1:].tolist() == [[1, 1, -10], [1, 1, 5], [9, 1, 5]]
    assert (path.feed * 60).round(6).tolist() == [400, 400, 60]
