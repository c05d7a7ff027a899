# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves at unknown heights, after moves to machine positions or tool length offsets, have a remark."""

import pytest

from vkworkbench.core.gcode import read_program

CUT = "G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X9\n"


def codes(text):
    return [problem.what.code for problem in read_program(text).problems]


@pytest.mark.parametrize("home", ["G28 Z0", "G91 G28 Z0\nG90", "G30 Z0", "G53 G0 Z0", "G53 Z-5"])
@pytest.mark.parametrize("move", ["G0 X5", "G1 X5 Y5 Z-1"])
def test_move_after_a_machine_height_has_a_remark(home, move):
    assert codes(f"{CUT}{home}\n{move}") == ["machine-height"]


@pytest.mark.parametrize("stop", ["M6 T2", "T2", "M0"])
def test_machine_height_before_a_tool_change_has_no_remark(stop):
    assert "machine-height" not in codes(f"{CUT}G91 G28 Z0\nG90\n{stop}\nG0 X5\nG0 Z5\nG1 Z-1")


def test_machine_height_at_the_program_end_has_no_remark():
    assert codes(f"{CUT}G28 Z0\nM30") == []


@pytest.mark.parametrize("change", ["G43 H1", "G43.1 Z2", "G43 H1\nG43 H2 Z5\nG43 H1", "G43 H1 Z5\nG49"])
@pytest.mark.parametrize("move", ["G0 X5", "G1 X5", "G91 G1 Z-2\nG90"])
def test_move_after_another_tool_length_has_a_remark(change, move):
    assert codes(f"{CUT}{change}\n{move}\nG0 Z5") == ["length-before-height"]


@pytest.mark.parametrize("change", ["G49", "G43 H0", "G43 H1 Z5\nG43 H1", "G43 H1 Z5\nG0 X3"])
def test_move_with_the_same_tool_length_has_no_remark(change):
    assert codes(f"{CUT}{change}\nG1 X5") == []


def test_rapid_to_the_first_height_of_a_tool_has_no_remark():
    assert codes(f"{CUT}M6 T2\nG43 H2\nG0 X5\nG0 Z5\nG1 Z-1") == []
    assert codes(f"{CUT}M6 T2\nG43 H2\nG1 X5") == ["length-before-height"]
