# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variables with a known value are replaced by the value. Variables without a known value have a remark."""

import pytest

from vkworkbench.core.gcode.dialects import at_line
from vkworkbench.core.gcode.reader import read_program
from vkworkbench.language import render

MOVES = "G0 X0 Y0 Z#2\nG1 Z#1 F#3\nX10\n"


def said(text):
    return [render(at_line(problem)) for problem in read_program(text).problems]


def points(text):
    return read_program(text).toolpath().points.tolist()


@pytest.mark.parametrize(
    ("down", "word"),
    [
        ("#1=-3", "Z#1"),
        ("#1 = 3.", "Z-#1"),
        ("#1=-3", "Z[#1]"),
        ("#<_deep> = -3 (depth)", "Z #<_DEEP>"),
        ("N5 #1=-3", "Z+#1"),
    ],
)
def test_variable_is_replaced_by_its_value(down, word):
    text = f"G21\n{down}\n#2=5\n#3=60\n" + MOVES.replace("Z#1", word)
    assert said(text) == []
    assert points(text) == [[0, 0, 5], [0, 0, -3], [10, 0, -3]]
    assert read_program(text).toolpath().feed[-1] == pytest.approx(1.0)


def test_variable_has_the_value_that_was_assigned_last():
    assert points("G21\n#1=-1\n#2=5\n#3=60\n" + MOVES + "#1=-2\nG1 Z#1\n")[-1] == [10, 0, -2]
    assert points("G21\n#1=-1\n#2=5\n#3=60\n" + MOVES + "#7=#1\nG1 Z#7 X9\n")[-1] == [9, 0, -1]


@pytest.mark.parametrize(("change", "z"), [("#1=[#2-7]", -2), ("#1=ROUND[-#2/2]", -3), ("#1=-#2", -5)])
def test_expression_with_variables_is_calculated(change, z):
    text = f"G21\n#1=-1\n#2=5\n#3=60\n{MOVES}{change}\nG1 Z#1 X20\n"
    assert said(text) == [] and points(text)[-1] == [20, 0, z]


UNSET = "A variable is read that the program has not set. It is read as 0, on a Fanuc control as empty."


def test_unset_variable_is_0_or_empty_on_a_fanuc_control():
    before = "G21\n#1=4\nG0 X0 Y0 Z5\n"
    for line, end in (
        ("G1 X1 Z##1", [1, 0, 0]),
        ("G1 X2 Z#5", [2, 0, 0]),
        ("N7 G1 X2 Z#5 (#0=#0)\nGOTO 9\nN9", [2, 0, 5]),
    ):
        assert points(f"{before}{line}\n")[-1] == end
        assert said(f"{before}{line}\n") == [f"Line 4: {UNSET}"]


def test_variable_with_an_unreadable_assignment_has_no_value():
    text = "G21\n#1=4\nG0 X0 Y0 Z5\n#1=[3\nG1 X2\nX#1\nX9\n"
    assert points(text)[-1] == [2, 0, 5]
    assert said(text)[1].startswith(
        "Line 6: The program is read up to this line. The value of #1 is assigned in a line"
    )
