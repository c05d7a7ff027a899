# SPDX-License-Identifier: LGPL-2.1-or-later
"""Expressions, O-words and Fanuc's macros are executed as a control executes them, within reported limits."""

from __future__ import annotations

import pytest

from vkworkbench.core import recognize
from vkworkbench.core.gcode.dialects import at_line
from vkworkbench.core.gcode.flow import flow
from vkworkbench.core.gcode.reader import read_program
from vkworkbench.language import render

HEAD = "G21 G90\nG0 X0 Y0 Z0\nG1 F60\n"
END = "The program is read up to this line. "


def said(text):
    return [render(at_line(problem)) for problem in read_program(text).problems]


def ends(text):
    """Return the points after the first, to four decimals."""
    return [tuple(round(value, 4) for value in point) for point in read_program(text).toolpath().points.tolist()[1:]]


def xs(text):
    """Return the X of each point after the first."""
    return [x for x, _, _ in ends(text)]


# The expected values are from LinuxCNC's interpreter.
@pytest.mark.parametrize(("expression", "value"), [
    ("[1+2*3]", 7), ("[[1+2]*3]", 9), ("[2**3**2]", 64), ("[2+3*4**2]", 50), ("[-2**2]", 4), ("[10-3-2]", 5), ("[2/4/2]", 0.25),
    ("[7 MOD 4]", 3), ("[-7 MOD 4]", 1), ("[7 MOD -4]", 3), ("[7.5 mod 2]", 1.5), ("[2**-1]", 0.5), ("[-8**3]", -512),
    ("[1 EQ 1.00005]", 1), ("[1 NE 1.00005]", 0), ("[1 EQ 1.0002]", 0), ("[1 GE 1.00001]", 0), ("[2 GT 1]", 1), ("[1 LT 1]", 0),
    ("[1 LE 1]", 1), ("[3 AND 2]", 1), ("[3 AND 0]", 0), ("[0 XOR 5]", 1), ("[1 OR 0 AND 0]", 0), ("[1 LT 2 AND 3 LT 4]", 1),
    ("[1 + 2 GT 2]", 1), ("ATAN[1]/[-1]", 135), ("[ATAN[1]/[1]*3]", 135), ("FIX[-2.5]", -3), ("FUP[-2.5]", -2), ("ROUND[-2.5]", -3),
    ("ROUND[2.5]", 3), ("abs[-5]", 5), ("-SIN[30]", -0.5), ("COS[60]", 0.5), ("TAN[45]", 1), ("ASIN[1]", 90), ("ACOS[0.5]", 60),
    ("SQRT[16]", 4), ("EXP[0]", 1), ("LN[1]", 0), ("[3 - -2]", 5), ("[--5]", 5), ("-[3]", -3), ("[.5]", 0.5), ("[1 2.5]", 12.5),
    ("[round[3]MOD 2]", 1), ("#01", 4), ("##1", 6), ("-#1", -4), ("-[#1]", -4), ("#[1+3]", 6), ("#<a b>", 8), ("#<_G>", 9),
    ("EXISTS[#<ab>]", 1), ("EXISTS[#<none>]", 0), ("[#<ab>/#1]", 2),
])  # fmt: skip
def test_value_of_an_expression_equals_linuxcncs(expression, value):
    text = f"#1=4 #4=6\n#<ab>=8\n#<_g>=9\n{HEAD}G1 X99\nG1 X{expression}\n"
    assert ends(text)[-1][0] == pytest.approx(value, abs=1e-4) and said(text) == []


def test_assignments_take_effect_after_their_line():
    assert ends(f"#1=1 #2=2\n{HEAD}#1=#2 #2=#1\nG1 X#1 Y#2\n#1=7 G1 X#1\nX#1\n") == [(2, 1, 0), (7, 1, 0)]
    assert ends(f"{HEAD}#1=5 #1=6\n#1=2 ##1=9\nX#1\nX#6") == [(2, 0, 0), (9, 0, 0)]


LINUXCNC = {
    "if": ("o1 if [0]\nX1\no1 elseif [1]\nX2\no1 elseif [1]\nX3\no1 else\nX4\no1 endif\nX5", [2, 5]),
    "else": ("o1 if [0]\nX1\no1 else\nX4\no1 endif\nX5", [4, 5]),
    "no branch": ("o1 if [0]\nX1\no1 endif\nX5", [5]),
    "while": ("#1=0\no1 while [#1 LT 3]\n#1=[#1+1]\nX#1\no1 endwhile\nX9", [1, 2, 3, 9]),
    "do": ("#1=0\no1 do\n#1=[#1+1]\nX#1\no1 while [#1 LT 3]\nX9", [1, 2, 3, 9]),
    "repeat": ("G91\no1 repeat [2]\no2 repeat [2.4]\nX1\no2 endrepeat\nX10\no1 endrepeat", [1, 2, 12, 13, 14, 24]),
    "break": ("#1=0\no1 while [1]\n#1=[#1+1]\nX#1\no2 if [#1 GE 2]\no1 break\no2 endif\no1 endwhile\nX9", [1, 2, 9]),
    "continue": ("#1=0\no1 while [#1 LT 3]\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\nX#1\no1 endwhile", [1, 3]),
    "continue in do": ("#1=0\no1 do\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\nX#1\no1 while [#1 LT 3]", [1, 3]),
    "break of a repeat": ("G91\no1 repeat [5]\nX1\no1 break\no1 endrepeat\nX5", [1, 6]),
    "arguments": ("#1=7\no1 sub\nX[#1+#2+#3]\n#1=5\no1 endsub\no1 call [#1+1] [2]\nX#1", [10, 7]),
    "named": ("o<Hole> sub\n#<a>=3 #<_b>=4\nX#<a>\no<hole> endsub\no<HOLE> call\nX#<_b>", [3, 4]),
    "return": ("o1 sub\nX1\no2 if [#1 GT 2]\no1 return [#1*2]\no2 endif\nX2\no1 endsub [9]\no1 call [5]\nX#<_value>\no1 call [0]\nX#<_value>", [1, 10, 1, 2, 9]),
    "recursion": ("o1 sub\nX#1\no2 if [#1 GT 0]\no1 call [#1-1]\no2 endif\nX[#1+0.5]\no1 endsub\no1 call [2]", [2, 1, 0, 0.5, 1.5, 2.5]),
    "defined later": ("o1 call\nX9\nM2\no1 sub\nX5\no1 endsub", [5, 9]),
    "computed": ("o7 sub\nX7\no7 endsub\n#1=7\no#1 call\nX1\no[#1] call", [7, 1, 7]),
    "loop in a subprogram": ("o1 sub\n#2=0\no3 while [#2 LT 5]\n#2=[#2+1]\nX#2\no4 if [#2 EQ 2]\no1 return\no4 endif\no3 endwhile\no1 endsub\no1 call\no1 call", [1, 2, 1, 2]),
    "same numbers": ("G91\no1 sub\no5 repeat [2]\nX1\no5 endrepeat\no1 endsub\no5 repeat [2]\no1 call\no5 endrepeat", [1, 2, 3, 4]),
    "end in a condition": ("X1\no1 if [1]\nM2\no1 endif\n", [1]),
}  # fmt: skip


@pytest.mark.parametrize("case", LINUXCNC)
def test_o_words_are_executed_as_linuxcnc_executes_them(case):
    text, expected = LINUXCNC[case]
    assert xs(f"{HEAD}{text}\n") == expected and said(f"{HEAD}{text}\n") == []


# The expected values are computed by hand.
FANUC = {
    "goto": ("X1\nGOTO 20\nX2\nN20 X3\nM30", "", [1, 3]),
    "goto back": ("#1=0\nN5 #1=#1+1\nX#1\nIF[#1 LT 3]GOTO 5\nX9\nM30", "", [1, 2, 3, 9]),
    "goto a variable": ("#1=30\nGOTO#1\nX2\nN30 X3\nM30", "", [3]),
    "then": ("#1=4\nIF [#1 EQ 4] THEN #2=7\nIF [#1 NE 4] THEN #2=8\nX#2\nM30", "", [7]),
    "while": ("#1=1\nWHILE [#1 LE 3] DO 1\nX[#1*10]\n#1=#1+1\nEND 1\nX9\nM30", "", [10, 20, 30, 9]),
    "nested": ("#1=0\nWHILE[#1LT2]DO1\n#2=0\nWHILE[#2LT2]DO2\nX[#1*10+#2]\n#2=#2+1\nEND2\n#1=#1+1\nEND1\nM30", "", [1, 10, 11]),
    "same number again": ("#1=0\nWHILE[#1LT2]DO1\n#1=#1+1\nX#1\nEND1\nWHILE[#1LT4]DO1\n#1=#1+1\nX#1\nEND1\nM30", "", [1, 2, 3, 4]),
    "out of a loop": ("#1=0\nWHILE[#1LT9]DO1\n#1=#1+1\nX#1\nIF[#1EQ2]GOTO9\nEND1\nX50\nN9 X60\nM30", "", [1, 2, 60]),
    "endless loop that is left": ("#1=0\nDO1\n#1=#1+1\nX#1\nIF[#1EQ3]GOTO9\nEND1\nN9 X60\nM30", "", [1, 2, 3, 60]),
    "macro": ("G65 P9000 A1 B2.5 C-3\nX9\nM30", "O9000\nX#1\nX#2\nX#3\nM99", [1, 2.5, -3, 9]),
    "letters": ("G65 P9000 D7 E8 F9 H11 I4 J5 K6 M13 Q17 R18\nM30", "O9000\nX[#7+#8]\nX[#9+#11]\nX#4\nX#5\nX#6\nX[#13+#17+#18]\nM99", [15, 20, 4, 5, 6, 48]),
    "last letters": ("G65 P9000 S19 T20 U21 V22 W23 X24 Y25 Z26\nM30", "O9000\nX[#19+#20]\nX[#21+#22]\nX[#23+#24]\nX[#25+#26]\nM99", [39, 43, 47, 51]),
    "sets of I, J and K": ("G65 P9000 A1 I4 J5 K6 I7 K9 J11\nM30", "O9000\nX#4\nX#5\nX#6\nX#7\nX#9\nX#11\nM99", [4, 5, 6, 7, 9, 11]),
    "repeated": ("G91 G65 P9000 L3 A2\nX9\nM30", "O9000\nX#1\n#1=5\nM99", [2, 4, 6, 15]),
    "own variables": ("#1=7\n#100=1\nG65 P9000 A3\nX#1\nX#100\nM30", "O9000\nX#1\n#1=4\n#100=8\nM99", [3, 7, 8]),
    "variables of M98": ("#1=7\nM98 P9000\nX#1\nM30", "O9000\nX#1\n#1=4\nM99", [7, 4]),
    "empty": ("#1=0\nG65 P9000 B5\nM30", "O9000\nX1\nX#1 Z-#1 Y#2\nIF[#1EQ#0]GOTO5\nX2\nN5 X3\nIF[#3NE#0]THEN #2=8\nX#2\nM99", [1, 1, 3, 5]),
    "empty is 0 in sums": ("G65 P9000\nM30", "O9000\nX[#1+2]\n#5=#0\nX#5\nX[#5*3+1]\nM99", [2, 1]),
    "rounded": ("X1\nX[FIX[-1.5]]\nX[FUP[-1.5]]\nX[FIX[1.5]+FUP[1.2]]\nX[ROUND[3.5]]\n(GOTO)N1 IF[0]GOTO1\nM30", "", [1, -1, -2, 3, 4]),
    "bits": ("IF[0]GOTO1\nN1 X[12 AND 10]\nX[12 OR 3]\nX[12 XOR 10]\nX[1+6 AND 2]\nM30", "", [8, 15, 6, 3]),
    "conditions": ("#1=2\nIF[[#1GT1]AND[#1LT3]]GOTO5\nX1\nN5 X5\nIF[#1GT1 AND #1LT2]GOTO9\nX6\nN9 X9\nM30", "", [5, 6, 9]),
    "circle of holes": ("#1=0\nWHILE[#1LT360]DO1\nX[10*COS[#1]]Y[10*SIN[#1]]\n#1=#1+90\nEND1\nM30", "", [10, 0, -10, 0]),
    "arc tangent": ("IF[0]GOTO1\nN1 X[ATAN[1]/[1]]\nX[ATAN[1]*2]\nX[ATAN[1,-1]]\nX[POW[2,3]]\nX[SQR[9]]\nM30", "", [45, 90, 135, 8, 3]),
}  # fmt: skip


@pytest.mark.parametrize("case", FANUC)
def test_macros_are_executed_as_fanuc_controls_execute_them(case):
    main, macro, expected = FANUC[case]
    text = f"O1\n{HEAD}{main}\n{macro}\n"
    assert xs(text) == expected and said(text) == []


@pytest.mark.parametrize(("line", "why"), [
    ("X#5061", "The value of #5061 comes from the machine."), ("#1=#5221\nX[#1+1]", "The value of #5221 comes from the machine."),
    ("X#<_feed>", "The value of #<_feed> comes from the machine."), ("G28 X0\nX#<_x>", "The value of #<_x> comes from the machine."), ("X#<depth>", "A control stops here, because #<depth> has no value."),
    ("o1 if [#5070 EQ 1]\nX5\no1 endif", "The value of #5070 comes from the machine."),
    ("#1=[1/0]", "A control stops here, because an expression has no result, such as a division by zero."),
    ("X[-8**[1/3]]", "A control stops here, because an expression has no result, such as a division by zero."),
    ("X SQRT[-1]", "A control stops here, because an expression has no result, such as a division by zero."),
    ("#1=[10**200*10**200]", "A control stops here, because an expression has no result, such as a division by zero."),
    ("X#-1", "A control stops here, because it has no variable #-1."), ("#1.5=2", "A control stops here, because it has no variable #1.5."),
    ("#999999999=1", "A control stops here, because it has no variable #1e+09."),
    ("GOTO 77", "The program jumps to the block N77, which does not exist."),
    ("o1 while [1]\nX5", "The end of this loop, condition or subprogram is missing."),
    ("WHILE[#1 LT 5]DO1\nX5", "The end of this loop, condition or subprogram is missing."),
    ("o1 if [1", "This jump, loop or call cannot be read."), ("o1 while #1\no1 endwhile", "This jump, loop or call cannot be read."),
    ("IF[1 EQ 1]GOTO5\nX5\nN5 #3000=1", "The program stops here with an alarm (#3000)."),
    ("GOTO 5\nN5 #1=#500\nX#1", "The value of #500 comes from the machine."),
    ("o1 sub\no1 call\no1 endsub\no1 call", "Calls are nested deeper than 10 levels, which is the limit."),
    ("o1 while [1]\no1 endwhile", "The program jumps back from here without end."),
    ("N5 X5\nGOTO 5", "The program jumps back from here without end."),
])  # fmt: skip
def test_reading_ends_if_a_program_cannot_be_followed(line, why):
    """The moves before the line that cannot be followed are kept, and the moves after the line are not read."""
    text = f"{HEAD}X3\n{line}\nX99\nM2\n"
    assert ends(text)[0] == (3, 0, 0) and 99 not in xs(text)
    assert said(text)[-1].endswith(f": {END}{why}")


def test_variables_with_the_tools_position_are_evaluated():
    linuxcnc = HEAD + "G52 X10\nG20 X1\nY[#5420+#<_y>]\no1 while [#<_x> LT 3]\nG91 X1\nG90\no1 endwhile\nG21 X#5420"
    assert ends(linuxcnc) == [(35.4, 0, 0), (35.4, 25.4, 0), (60.8, 25.4, 0), (86.2, 25.4, 0), (13, 25.4, 0)]
    assert said(linuxcnc) == []
    fanuc = f"O1\n{HEAD}X3\nY[#5041+#5001]\nM30"
    assert ends(fanuc)[-1] == (3, 6, 0) and said(fanuc) == []


def test_reading_a_program_ends_only_if_a_value_is_needed():
    text = f"O1\n{HEAD}#100=#4003\nIF[#5405 GE 9]THEN #3000=1\nX3\nS#4119 M3\nX4\nG#100 X5\nX6"
    assert xs(text) == [3, 4]
    assert said(text) == ["Line 8: S words are ignored.", f"Line 10: {END}The value of #4003 comes from the machine."]


def test_reading_ends_where_an_unknown_result_is_needed():
    text = f"o1 sub\nX[#2]\no1 endsub [#5063]\n{HEAD}o1 call [#5061] [3]\n#<top>=[#<_value>+2]\nX4\nX#<top>\nX5"
    assert xs(text) == [3, 4] and said(text) == [f"Line 10: {END}The value of #5063 comes from the machine."]


def test_e_word_after_a_variable_is_not_an_exponent():
    assert xs(f"#1=7\n{HEAD}X#1 E5\nX[1E1]") == [7, 10]


BOUNDED = [
    ("MOST_LINES", "G91\no1 while [#1 LT 9999]\n#1=[#1+1]\nX1\no1 endwhile", "Loops, jumps and calls would run more than 100 lines"),
    ("MOST_LINES", "G91\no1 repeat [1000]\nX1\no1 endrepeat", "Loops, jumps and calls would run more than 100 lines"),
    ("MOST_IDLE_LINES", "o1 while [1]\n#1=[#1+1]\no1 endwhile", "A loop runs more than 100 lines without a move"),
    ("MOST_STEPS", f"#1=[{'+'.join('1' * 90)}]", "The expressions take more than 100 steps to calculate"),
    ("MOST_COMMANDS", "G91\no1 repeat [200]\nG81 X1 Z-1 R1 L50\no1 endrepeat", "Loops, jumps and calls would make more than 100 moves"),
]  # fmt: skip


@pytest.mark.parametrize(("bound", "loop", "why"), BOUNDED)
def test_reached_limit_of_a_loop_is_reported(monkeypatch, bound, loop, why):
    monkeypatch.setattr(flow, bound, 100)
    text = f"#1=0\n{HEAD}X3\n{loop}\nY99"
    assert said(text)[-1].endswith(f"{END}{why}, which is the limit.") and (99 not in {y for _, y, _ in ends(text)})


@pytest.mark.parametrize("value", ["[" * 500 + "1" + "]" * 500, "#" * 500 + "1", "1" * 990, "1" + "+1" * 600])
def test_oversized_expression_is_not_read(value):
    text = f"{HEAD}#1={value}\nX5\nX#1\nX6"
    assert xs(text) == [5]
    assert said(text)[-1] == f"Line 6: {END}The value of #1 is assigned in a line that cannot be read."


LOOP = "#1=0\no1 while [#1 LT 5]\nG1 X100\nY[#1*5]\nX0\n(ROW)\n#1=[#1+1]\no1 endwhile\nG0 Z5\nM2\n"


def test_moves_of_a_loop_have_line_numbers_of_the_loop():
    """Moves of the first run have their own line numbers, and moves of further runs the line that jumps back."""
    program = read_program(HEAD + LOOP)
    assert program.toolpath().command.tolist() == [6, 8] + [11] * 12 + [12]
    assert [text for _, _, text in program.comments] == ["ROW"]


def test_rows_cut_in_a_loop_are_a_zigzag():
    path = read_program("G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F200\n" + LOOP).toolpath()
    found = recognize(path, tool_diameter=6.0)
    assert (found.strategy, found.passes, found.stepover) == ("zigzag", 5, pytest.approx(5.0))


def test_calls_in_a_loop_belong_to_the_line_of_the_call():
    text = (
        f"o1 sub\nX#1\nX0\no1 endsub\n{HEAD}o1 call [1]\n#5=0\no2 while [#5 LT 2]\no1 call [2]\n#5=[#5+1]\no2 endwhile"
    )
    assert read_program(text).toolpath().command.tolist() == [8, 8, 11, 11, 13, 13]
