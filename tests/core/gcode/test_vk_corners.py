# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fanuc's words ,R and ,C: rounded and chamfered corners between two straight moves in the XY plane."""

import numpy as np
import pytest

from vkworkbench.core.gcode import read_program

BEFORE = "G21 G90 G17\nG0 X0 Y0 Z5\nG1 Z-1 F60\n"


def path(text):
    return read_program(BEFORE + text).toolpath(tolerance=1e-4)


def ends(text):
    """Return the end points of lines and of whole arcs after the plunge, X and Y with three decimals."""
    toolpath = path(text)
    keep = np.append(np.diff(toolpath.sweep) != 0, True) | (toolpath.sweep == 0)
    return (toolpath.points[1:][keep][1:, :2].round(3) + 0.0).tolist()


def ignored(text):
    """Return (letter, line number) of each ignored word."""
    return [
        (problem.what.arguments["letter"], problem.command)
        for problem in path(text).problems
        if problem.what.code == "word-not-read"
    ]


@pytest.mark.parametrize(
    "text", ["X10 ,R2\nY10", "X10,R2.\nY10", "X10 , R2\nM8\nY10", "G91 X10 ,R2\nY10", "#1=2\nX10 ,R#1\nY10",
             "G20 X.3937007874 ,R.07874015748\nY.3937007874", "G52 X5 Y5\nX5 Y-5 ,R2\nY5", "@10 ^0 ,R2\nX10 Y10"]
)  # fmt: skip
def test_rounded_corner_is_an_arc_between_shorter_lines(text):
    assert ends(text) == [[8, 0], [10, 2], [10, 10]] and not ignored(text)
    assert path(text).sweep.sum() == pytest.approx(np.pi / 2)


def test_chamfer_begins_and_ends_at_its_distance_from_the_corner():
    assert ends("X10 ,C2\nX4 Y8\nX0") == [[8, 0], [8.8, 1.6], [4, 8], [0, 8]]


def test_second_move_of_a_corner_can_have_a_corner_of_its_own():
    square = "X10 ,R2\nY10 ,C3\nX0 ,R2\nY2"
    assert ends(square) == [[8, 0], [10, 2], [10, 7], [7, 10], [2, 10], [0, 8], [0, 2]] and not ignored(square)
    relative = "G91 X10 ,R2\nY10 ,C3\nX-10 ,R2\nY-8"
    assert ends(relative) == ends(square)


def test_arc_in_an_acute_corner_touches_both_lines():
    """The radius is 1, and the corner turns by 135 degrees: the arc begins 1 / tan(22.5 degrees) before the corner."""
    cut = round(1 / np.tan(np.pi / 8), 3)
    toolpath = path("X10 ,R1\nX0 Y10")
    assert ends("X10 ,R1\nX0 Y10")[0] == [10 - cut, 0]
    assert toolpath.sweep.sum() == pytest.approx(3 * np.pi / 4)
    assert ends("X10 ,R1\nX0 Y-10")[0] == [10 - cut, 0]
    assert path("X10 ,R1\nX0 Y-10").sweep.sum() == pytest.approx(-3 * np.pi / 4)


def test_rounded_corners_follow_rotations_and_mirrors():
    assert ends("G68 X0 Y0 R90\nX10 ,R2\nY10") == [[0, 8], [-2, 10], [-10, 10]]
    assert ends("G51.1 X0\nX10 ,R2\nY10") == [[-8, 0], [-10, 2], [-10, 10]]


def test_g92_after_a_rounded_relative_move_uses_programmed_end():
    assert ends("G91 X10 ,R2\nY10\nG92 X0 Y0\nG90 X5")[-1] == [15, 10]


def test_arcs_of_rounded_corners_do_not_decide_on_arc_centres():
    toolpath = path("G1 X10 ,R2\nY10 ,R2\nX0\nY20\nG2 X5 Y25 I5 J20")
    assert [problem.what.code for problem in toolpath.problems] == ["absolute-centres"]
    assert ends("G1 X10 ,R2\nY10 ,R2\nX0\nY20\nG2 X5 Y25 I5 J20")[:3] == [[8, 0], [10, 2], [10, 8]]


@pytest.mark.parametrize("size", [",R0", ",C0"])
def test_corner_of_size_zero_stays_sharp_without_a_remark(size):
    assert ends(f"X10 {size}\nY10") == [[10, 0], [10, 10]] and not ignored(f"X10 {size}\nY10")


@pytest.mark.parametrize(
    "rest",
    [
        "X10 ,R2", "X10 ,R2\nM30", "X10 ,R11\nY30", "X10 ,R6\nY5", "X10 ,R2\nG0 Y10", "X10 ,R2\nG2 X20 Y10 R10", "X10 ,R2\nY10 Z1",
        "X10 Z-2 ,R2\nY10", "X10 ,R2\nX5", "X10 ,R2\nX10", "X10 ,R-2\nY10", "X10 ,R2\nM0\nX5 Y10", "X10 ,R2\nZ3\nY10", "X10 ,R2\nG81 Y10 Z-3 R1",
        "X10 ,R2\nT2 M6\nY10", "X10 ,R2\nG18\nY10", "G51 X0 Y0 P2\nX10 ,R2\nY10", "G93 F9 X10 ,R2\nY10", "G93 F9 X10 ,R2\nG94 F9 Y10",
        "X10 ,R2\nG93 F9 Y10", "X10 ,R2\nG28 X0\nY10", "G41.1 D2 X10 ,R2\nY10\nG40 X0",
    ],
)  # fmt: skip
def test_corners_that_cannot_be_rounded_have_a_remark(rest):
    line = 4 + rest.split(",R")[0].count("\n")
    assert ignored(rest) == [(",R", line)]
    assert ends(rest) == ends(rest.replace(" ,R-2", "").replace(" ,R2", "").replace(" ,R11", "").replace(" ,R6", ""))


def test_two_corner_words_in_one_line_have_a_remark():
    assert sorted(ignored("X10 ,R2 ,C1\nY10")) == [(",C", 4), (",R", 4)]


def test_only_a_rounded_corner_that_does_not_fit_has_a_remark():
    text = "X10 ,R2\nY10 ,R30\nX0 ,R2\nY0"
    assert ignored(text) == [(",R", 5)]
    assert ends(text) == [[8, 0], [10, 2], [10, 10], [2, 10], [0, 8], [0, 0]]
