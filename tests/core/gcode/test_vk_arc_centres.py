# SPDX-License-Identifier: LGPL-2.1-or-later
"""The centre words of arcs are read as offsets or as positions."""

from vkworkbench.core.gcode import read_program

PLAIN = "G21 G90\nG0 X30 Y20 Z5\nG1 Z-1 F100\n"


def told(text):
    path = read_program(PLAIN + text).toolpath()
    return path, [problem.what.code for problem in path.problems]


def test_one_arc_with_absolute_centre_outweighs_full_circles():
    path, said = told("G2 X30 Y20 I5 J0\nG1 X31\nG2 X31 Y20 I6 J0\nG1 X30\nG3 X20 Y30 I20 J20\n")
    assert said == ["absolute-centres"]
    assert abs(path.points[-1] - (20, 30, -1)).max() < 1e-9


def test_arcs_with_a_radius_do_not_decide_how_centres_are_read():
    _, said = told("G2 X20 Y20 R9\nG2 X30 Y20 R9\nG2 X20 Y20 R9\nG2 X30 Y20 R9\nG3 X20 Y30 I20 J20\n")
    assert said == ["absolute-centres"]


def test_full_circles_whose_centres_are_ambiguous_have_a_remark():
    assert told("G2 X30 Y20 I-5 J-3\n")[1] == ["circles-alone"]
    assert told("G2 I-5\n")[1] == []  # A centre given as coordinates would need both I and J.
    assert told("G2 X30 Y20 I-5 J0 Z-2\nG2 X30 Y20 I-5 J0 Z-3\n")[1] == []  # Descending full circles are a helix.
    assert told("G91.1\nG2 X30 Y20 I-5 J-3\n")[1] == []
    # The centre words I and J of the second arc fit only as offsets.
    assert told("G2 X30 Y20 I-5 J-3\nG2 X20 Y30 I-10 J0\n")[1] == []
