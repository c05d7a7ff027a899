# SPDX-License-Identifier: LGPL-2.1-or-later
"""Canned cycles are converted to the moves that a control makes."""

import numpy as np

from vkworkbench.core.gcode import linearize, read_program, split_sections


def points(text):
    return read_program(text).toolpath().points.round(6).tolist()


def codes(text):
    return [problem.what.code for problem in read_program(text).toolpath().problems]


def test_move_to_machine_home_after_a_cycle_does_not_descend():
    text = "G21 G90\nG0 X0 Y0\nG81 X10 Y0 Z-5 R2 F100\nG80\n{}\nG0 X5"
    for home in ("G28 Z0", "G30 Z0", "G53 G0 Z0", "G91 G28 Z0\nG90"):
        assert points(text.format(home))[-2:] == [[10, 0, 2], [5, 0, 2]]


def test_move_to_machine_home_rises_to_the_r_plane_of_a_cycle():
    commands = [("G0", {"X": 0, "Y": 0, "Z": 1}), ("G81", {"X": 5, "Z": -5, "R": 8, "F": 2}), ("G80", {}),
                ("G0", {"Z": 1}), ("G28", {"Z": 0}), ("G0", {"X": 9})]  # fmt: skip
    assert linearize(commands).points[-1].tolist() == [9, 0, 8]


def test_deep_hole_cycle_returns_by_rapid_to_just_above_the_peck():
    path = read_program("G21 G90\nG0 X0 Y0 Z5\nG99 G83 X1 Y1 Z-5 R2 Q3 F100\nG80").toolpath()
    returns = path.points[1:, 2][path.rapid][2:]
    assert returns.round(3).tolist() == [2, -0.746, 2, -3.746, 2]


def test_sign_of_a_peck_depth_is_ignored():
    text = "G21 G90\nG0 X0 Y0 Z5\nG99 G83 X1 Y1 Z-5 R2 Q{} F100\nG80"
    assert points(text.format("-3")) == points(text.format("3")) != points(text.format("9"))


def test_peck_depth_of_a_tap_has_a_remark():
    assert codes("G21 G90 S100\nG0 X0 Y0 Z5\nG84 X1 Z-5 R2 Q3 F100\nG80") == ["word-not-read"]


def test_chip_breaking_cycle_continues_at_feed_after_retract():
    path = read_program("G21 G90\nG0 X0 Y0 Z5\nG99 G73 X1 Y1 Z-5 R2 Q3 F100\nG80").toolpath()
    assert np.column_stack([path.points[1:, 2], path.rapid])[2:].round(3).tolist() == [
        [-1, 0], [-0.746, 1], [-4, 0], [-3.746, 1], [-5, 0], [2, 1]
    ]  # fmt: skip


def test_tiny_peck_depth_has_a_remark():
    text = "G21 G90\nG0 X0 Y0 Z5\nG83 X1 Y1 Z-5 R2 Q{} F100\nG80"
    assert codes(text.format(0.00000001)) == ["tiny-pecks"]
    assert codes(text.format(1)) == []


def titles(text):
    return [section.title for section in split_sections(read_program(text))]


def test_retract_at_feed_is_not_a_hole():
    cut = "G21 G90\nG0 X0 Y0 Z5\n(first)\nG1 Z-1 F100\nG1 X9\n{}\nG0 X0\n(second)\nG1 Z-2\nG1 X9\n"
    assert titles(cut.format("(note on the lift)\nG1 Z5")) == ["first", "second"]


def test_relative_plunges_in_steps_are_one_plunge():
    assert titles("G21 G90\nG0 X0 Y0 Z1\nG91\nG1 Z-3 F100\n(slot)\nG1 Z-2\nG1 X9\nG90\nG0 Z5\n") == ["slot"]


def test_higher_r_plane_is_reached_before_the_hole():
    text = "G21 G90 G99\nG0 X0 Y0 Z5\nG81 X1 Y0 Z-1 R1 F100\nX2 R3\nG80"
    assert points(text)[3:] == [[1, 0, -1], [1, 0, 1], [2, 0, 3], [2, 0, -1], [2, 0, 3]]


def test_tool_rises_first_to_an_r_plane_above_the_start():
    text = "G21 G90 G99\nG0 X0 Y0 Z0\nG81 X1 Y0 Z-1 R1 F100\nX2 R3\nG80"
    assert points(text)[1:] == [
        [0, 0, 1], [1, 0, 1], [1, 0, -1], [1, 0, 1], [1, 0, 3], [2, 0, 3], [2, 0, -1], [2, 0, 3]
    ]  # fmt: skip


def test_cycle_with_relative_angle_repeats_holes_on_a_circle():
    text = "G21 G90\nG0 X10 Y0 Z5\nG91 G99 G81 ^90 Z-2 R-1 L3 F100\nG80"
    holes = [point[:2] for point in points(text) if point[2] == 2]
    assert holes == [[0, 10], [-10, 0], [0, -10]]


def test_r_plane_above_the_series_start_is_reached_before_a_hole():
    """LinuxCNC compares R with the height at the start of the series, also after a hole with a higher R."""
    series = points("G21 G90\nG0 X0 Y0 Z0\nG81 X5 Z-5 R4 F100\nX9 R2\nG80")
    assert series[1:] == [[0, 0, 4], [5, 0, 4], [5, 0, -5], [5, 0, 4], [5, 0, 2], [9, 0, 2], [9, 0, -5], [9, 0, 2]]


def test_g52_shift_along_the_hole_also_moves_the_r_plane():
    text = "G21 G90 G99\nG0 X20 Y0 Z0\nG52 X10 Z5\nG19 G81 Y1 X-4 R2 F100\nG80"
    assert points(text)[1:] == [[20, 1, 0], [12, 1, 0], [6, 1, 0], [12, 1, 0]]


def test_shift_at_the_bottom_of_g76_has_a_remark():
    text = "O1\nG21 G90\nG0 X0 Y0 Z5\nG76 X5 Y5 Z-5 R2 Q.5 P100 F100\nX9\nG80"
    assert codes(text) == ["word-not-read"] and points(text)[-2:] == [[9, 5, -5], [9, 5, 5]]


def test_k_word_of_pecks_in_one_place_is_not_read_as_repeats():
    """On Haas controls, K is a depth. On Fanuc controls, K would drill the same hole again."""
    text = "O1\nG21 G90\nG0 X0 Y0 Z5\nG73 X5 Y0 Z-5 R2 Q9 {} F100\nG80"
    once = points(text.format(""))
    assert points(text.format("K6")) == once and codes(text.format("K6")) == ["word-not-read"]
    assert points(text.format("L2"))[: len(once)] == once and len(points(text.format("L2"))) > len(once)
    assert len(points(text.format("G91 K2"))) > len(once) and points(text.format("K0")) == [[0, 0, 5]]
