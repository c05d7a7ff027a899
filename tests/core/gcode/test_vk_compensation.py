# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutter compensation with a radius in the program: the path of the tool's centre."""

import numpy as np
import pytest

from vkworkbench.core.gcode import read_program

BEFORE = "G21 G90 G17\nG0 X0 Y0 Z5\nG1 Z-1 F60\n"


def path(text):
    return read_program(BEFORE + text).toolpath()


def ends(text):
    """Return the end points of lines and of whole arcs after the plunge, X and Y with three decimals."""
    toolpath = path(text)
    keep = np.append(np.diff(toolpath.sweep) != 0, True) | (toolpath.sweep == 0)
    return (toolpath.points[1:][keep][1:, :2].round(3) + 0.0).tolist()


def codes(text):
    return [(problem.what.code, problem.what.arguments.get("name")) for problem in path(text).problems]


SQUARE = "X30 Y0\nX60\nY40\nX20\nY10\n"


@pytest.mark.parametrize("start", [
    "G41.1 D4 G1 ", "G10 L1 P3 R2\nG41 D3 G1 ", "G10 L12 P3 R2\nG41 D3 G1 ", "G20 G41.1 D0.15748031496\nG21 G1 ",
])  # fmt: skip
def test_compensated_path_cuts_inner_corners_short(start):
    """The first move ends beside its programmed end. The last move returns to the programmed path."""
    assert ends(start + SQUARE + "G40 X0 Y0") == [[30, 2], [58, 2], [58, 38], [22, 38], [22, 10], [0, 0]]


def test_wear_is_added_to_the_radius_of_a_fanuc_offset():
    """A Fanuc control's first move and outer corners can differ from LinuxCNC's, so a remark reports them."""
    text = "G10 L12 P3 R2.5\nG10 L13 P3 R-.5\nG41 D3 G1 X30 Y0\nX60\nG40 X0 Y0"
    assert ends(text) == [[30, 2], [60, 2], [0, 0]]
    assert codes(text) == [("compensation-of-linuxcnc", "G41")]
    assert codes("G10 L12 P3 R2\nG91 G10 L12 P3 R1\nG90 G41 D3 G1 X30 Y0") == [("compensation-not-read", "G41")]
    assert codes("G10 L1 P3 R2\nG41 D3 G1 X30 Y0") == []


def test_compensated_path_rounds_outer_corners():
    text = "G42.1 D4 G1 X30 Y0\nX60\nY40\nX20\nG40\nG0 X0 Y0"
    assert ends(text) == [[30, -2], [60, -2], [62, 0], [62, 40], [60, 42], [20, 42], [0, 0]]
    corners = path(text).sweep
    assert corners.sum() == pytest.approx(np.pi)


def test_compensation_of_relative_moves_equals_absolute_moves():
    absolute = "G41.1 D4 G1 X30 Y0\nX60\nY40\nX80\nY60\nG40 X0 Y0"
    relative = "G41.1 D4 G1 X30 Y0\nG91 X30\nY40\nX20\nY20\nG40 X-80 Y-60"
    assert ends(relative) == ends(absolute)


def test_position_under_compensation_can_be_read_and_set():
    """Reading #5420 (X of the tool) in a corner must not change the moves, although the corner is shortened."""
    relative = "G41.1 D4 G1 X30 Y0\nG91 X30\n{}Y40\nX20\nY20\nG40 X-80 Y-60\nG92 X0\nG90 X7"
    assert ends(relative.format("#1=#5420\n")) == ends(relative.format(""))


@pytest.mark.parametrize("arc", ["I0 J10", "R10", "G90.1 I40 J30"])
def test_compensated_arcs_have_the_radius_of_the_tools_path(arc):
    text = f"G0 X20 Y-30\nG41.1 D4 G1 X20 Y-10\nY10\nG2 X30 Y20 I10 J0\nG1 X40\nG3 X50 Y30 {arc}\nG1 Y50"
    assert ends(text)[1:] == [[18, -10], [18, 10], [30, 22], [40, 22], [48, 30], [48, 50]]


def test_compensated_line_and_arc_end_at_their_intersection():
    """The circle of radius 18 around (40, 0) meets the line y = 2, and then the line x = 42."""
    text = "G41.1 D4 G1 X20 Y0\nX60\nG3 X40 Y20 I-20 J0\nG1 X40 Y0"
    along = round(np.sqrt(18**2 - 2**2), 3)
    assert ends(text) == [[20, 2], pytest.approx([40 + along, 2]), [42, along], [42, 0]]


def test_compensated_rapids_have_no_arcs_around_outer_corners():
    toolpath = path("G42.1 D4 G1 X30 Y0\nX60\nG0 Y40\nG40 G0 X0 Y0")
    assert not toolpath.sweep.any() and toolpath.rapid.tolist()[-3:] == [True, True, True]


def test_compensated_path_keeps_its_height_changes():
    toolpath = path("G41.1 D4 G1 X30 Y0\nX60 Z-2\nZ-3\nX60 Y0 Z-4\nY40")
    assert toolpath.points[-4:].round(3).tolist() == [[58, 2, -2], [58, 2, -3], [58, 2, -4], [58, 40, -4]]


@pytest.mark.parametrize("text, name", [
    ("G41 D1 G1 X30 Y0\nX60", "G41"),  # The radius for D1 is stored in the control, and not in the program.
    ("G42.1 G1 X30 Y0", "G42.1"),
    ("G41.1 D4 G2 X30 Y0 I15 J0", "G41.1"),  # The first move is an arc.
    ("G41.1 D4 G1 X1 Y0\nX60", "G41.1"),  # The first move is shorter than the radius.
    ("G18 G41.1 D4 G1 X30 Z0", "G41.1"),
    ("G93 G41.1 D4 G1 X30 Y0 F2", "G41.1"),
    ("G68 X0 Y0 R30\nG41.1 D4 G1 X30 Y0", "G41.1"),
    ("G41.1 D4 G1 X30 Y0\nX60\nG3 X60 Y2 I0 J1", "G41.1"),  # The radius of the arc is smaller than the tool's radius.
    ("G41.1 D20 G1 X30 Y0\nX60\nY5\nX30", "G41.1"),  # The slot is narrower than the tool.
    ("G41.1 D4 G1 X30 Y0\nX60\nG81 X70 Y0 Z-3 R2\nG80", "G41.1"),
    ("M0\nG41.1 D4 G1 X30 Y0", "G41.1"),  # The operator may have moved the tool during M0.
])  # fmt: skip
def test_compensation_that_is_not_followed_has_a_remark(text, name):
    assert codes(text) == [("compensation-not-read", name)]


def test_programmed_path_is_kept_if_compensation_cannot_continue():
    text = "G41.1 D20 G1 X30 Y0\nX60\nY5\nX30\nX0 Y40"
    assert ends(text)[-3:] == [[60, 5], [30, 5], [0, 40]]
    assert ends("G41.1 D4 G1 X30 Y0\nX60\nG3 X60 Y2 I0 J1\nG1 X0")[-3:] == [[60, 0], [60, 2], [0, 2]]


def test_compensation_of_radius_zero_keeps_the_path():
    assert ends("G41.1 D0 G1 X30 Y0\nX60\nY40") == [[30, 0], [60, 0], [60, 40]]
    assert codes("G41.1 D0 G1 X30 Y0\nX60\nY40") == []


@pytest.mark.parametrize("degrees", [178, 180, 182])
def test_compensation_ends_where_an_arc_reverses_the_direction(degrees):
    """LinuxCNC treats some such reversals as inner corners, and others as outer corners."""
    way = np.exp(1j * np.radians(degrees))
    centre, end = 8j * way, 8j * way + 8 * way
    arc = f"G3 X{end.real:.5f} Y{end.imag:.5f} I{centre.real:.5f} J{centre.imag:.5f}"
    assert ("compensation-not-read", "G41.1") in codes(f"G41.1 D3 G1 X5 Y0\nX30\nG91 {arc}\nG90 G40 X0 Y0")
