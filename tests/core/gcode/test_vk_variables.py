# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variables with a known value are replaced by it; variables without a known value are reported."""

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
def test_a_variable_stands_for_its_number(down, word):
    text = f"G21\n{down}\n#2=5\n#3=60\n" + MOVES.replace("Z#1", word)
    assert said(text) == []
    assert points(text) == [[0, 0, 5], [0, 0, -3], [10, 0, -3]]
    assert read_program(text).toolpath().feed[-1] == pytest.approx(1.0)


def test_it_stands_for_the_number_that_was_set_last():
    assert points("G21\n#1=-1\n#2=5\n#3=60\n" + MOVES + "#1=-2\nG1 Z#1\n")[-1] == [10, 0, -2]
    assert points("G21\n#1=-1\n#2=5\n#3=60\n" + MOVES + "#7=#1\nG1 Z#7 X9\n")[-1] == [9, 0, -1]


@pytest.mark.parametrize("change", ["#1=[#2+3]", "#1=ROUND[#2]", "#1=#9"])
def test_what_is_calculated_is_not_read(change):
    text = f"G21\n#1=-1\n#2=5\n#3=60\n{MOVES}{change}\nG1 Z#1 X20\n"
    assert "Line 9: Words with variables or expressions are ignored." in said(text)
    assert points(text)[-1] == [20, 0, -1]


@pytest.mark.parametrize("flow", ["WHILE [#1 LT 9] DO1\nEND1", "IF [#1 EQ 0] GOTO 10", "o100 call [1]"])
def test_in_programs_with_jumps_no_number_is_sure(flow):
    text = f"G21\n#1=-1\n#2=5\n#3=60\nG0 X0 Y0 Z5\nG1 X1 Z#1\n{flow}\nX5\n"
    assert any("Words with variables or expressions" in message for message in said(text))
    assert min(point[2] for point in points(text)) == 5


def test_a_variable_that_nothing_sets_and_one_behind_another():
    assert (
        "Line 4: Words with variables or expressions are ignored."
        in said("G21\n#1=4\nG0 X0 Y0 Z5\nG1 X1 Z##1\nX5\n")[0]
    )
    assert "Line 3: Words with variables or expressions are ignored." in said("G21\nG0 X0 Y0 Z5\nG1 X1 Z#5\nX5\n")[0]
