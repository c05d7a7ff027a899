# SPDX-License-Identifier: LGPL-2.1-or-later
"""Subprograms in the same file as their calls are expanded, other subprograms have a remark, and recursion ends."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core.gcode.comments.sections import split_sections
from vkworkbench.core.gcode.dialects import at_line
from vkworkbench.core.gcode.flow import flow
from vkworkbench.core.gcode.reader import read_program
from vkworkbench.language import render

BEFORE = "G21 G90\nG0 X0 Y0 Z0\nF60\n"
STEP = "G91 G1 Z-1\nG90\nX10\nY10\nX0\nY0\n"
SQUARE = [(10, 0), (10, 10), (0, 10), (0, 0)]


def path_of(text):
    return read_program(text).toolpath()


def points(text):
    return [tuple(point) for point in np.round(path_of(text).points, 6).tolist()]


def said(text):
    return [render(at_line(problem)) for problem in read_program(text).problems]


@pytest.mark.parametrize(
    "text",
    [
        f"O1\n{BEFORE}M97 P1000 L3\nM30\n(STEP)\nN1000 {STEP}M99\n",  # Haas
        f"{BEFORE}M97 P10 L5\nM97 P1000 (STEP)\nm97p1000l2\nM30\nN10 M99\nN1000 {STEP}M99\n%\n",
        f"O1\n{BEFORE}M98 Q1000 L3\nM30\n(STEP)\nN1000 {STEP}M99\n",  # Fanuc
        f"O1\n{BEFORE}N20 M98 P2000 Q20 L3\nM30\nO2000\nG20\nN20 {STEP}M99\n",
        f"%\nO1\n{BEFORE}M98 P2000 L3\nM30\nO2000 (STEP)\n{STEP}M99\n%",
        f"%\nO1\n{BEFORE}M98 P32000\nM30\n%\nO2000\n{STEP}M99\n%",
        f"O2000\n{STEP}M99\nO1\n{BEFORE}M98 P0032000\nM30",
        f"O1\n{BEFORE}/M98 P2000\nM98 P3000\nM30\nO2000\n{STEP}M99\nO3000\nM98 P2000\n(TWICE)\nM98 P2000\nM99",
    ],
)
def test_subprogram_runs_at_its_call(text):
    assert points(text) == [(0, 0, 0)] + [(x, y, z) for z in (-1, -2, -3) for x, y in [(0, 0), *SQUARE]]
    assert [one for one in said(text) if "block delete" not in one] == []


@pytest.mark.parametrize("end", ["O3000\nX99\nM99", "/M99\nM99 P7\nX99"])
def test_subprogram_ends_at_its_return_or_the_next_subprogram(end):
    text = f"O1\n{BEFORE}M98 P2000\nG1 X5\nM30\nO2000\n{STEP}{end}"
    assert points(text)[-2:] == [(0, 0, -1), (5, 0, -1)]
    assert said(text)[-1] == f"Line {16 + end.startswith('/')}: Lines after the end of the program are ignored."


def test_subprogram_called_zero_times_does_not_run():
    assert points(f"O1\n{BEFORE}M98 P2000 L0\nX1\nM30\nO2000\n{STEP}M99") == [(0, 0, 0), (1, 0, 0)]


def test_moves_of_a_subprogram_have_the_line_number_of_its_call():
    text = f"O1\n{BEFORE}M98 P2000\nG1 X5\nM98 P2000\nM30\nO2000 (STEP)\n{STEP}#1=[#2\nM99"
    assert sorted(set(path_of(text).command.tolist())) == [5, 6, 7]
    assert said(text) == ["Line 5 (first of 2): Lines with variables or expressions are ignored."]


def test_programs_are_divided_into_operations_in_subprograms():
    tools = f"N100 T1 M6 (D10 ENDMILL)\n{STEP}M99\nN200 T2 M6 (DRILL)\n{STEP}M99"
    text = f"O1\n{BEFORE}M97 P100\nM97 P200 L2\nM30\n{tools}"
    sections = split_sections(read_program(text))
    assert {(one.first, one.number, one.tool and one.tool.diameter) for one in sections[-3:]} == {
        (2, 1, 10),
        (6, 2, None),
    }


@pytest.mark.parametrize(
    "call",
    [
        "M98 P3000",
        "M98 P2000 Q10",
        "M98 P3000 Q10",
        "M98 Q10",
        "M98",
        "M97 P2000",
        "M198 P2000",
        "G65 P3000 A1",
        "M98 P1",
        "M97 P12345678901",
    ],
)
def test_call_of_an_unreadable_or_missing_program_has_a_remark(call):
    text = f"O1\n{BEFORE}G1 X1\n{call}\nX5\nM30\nO2000\nG91\nM99"
    assert points(text)[-1] == (5, 0, 0)
    assert said(text) == ["Line 6: A subprogram or macro call is ignored."]


@pytest.mark.parametrize(
    ("before", "beside", "titles"),
    [("", "", ["Facing"]), ("", "; (faces)", ["faces"]), ("(Top)\n", "", ["Top"]), ("G1 X9\n(Top)\n", "", ["", "Top"])],
)
def test_titles_in_subprograms_do_not_divide_the_program(before, beside, titles):
    lines = "N10 ; (Facing)\nG91; (in steps)\nG0 Z-1 ; (down)\nG90\nG1; (cuts)\nX50\n(over)\nY5\nX0\nM99"
    text = f"O1\n{BEFORE}{before}M97 P10 L2 {beside}\nG0 X0\nM97 P10\nM30\n{lines}"
    assert [section.title for section in split_sections(read_program(text))] == titles


def test_reading_of_a_recursive_subprogram_ends():
    itself = f"O1\n{BEFORE}M98 P2000\nX7\nM30\nO2000\nG1 X5\nM98 P{{}}\nM98 P{{}}\nX6\nM99\nO3000\nX3\nM98 P2000\nM99"
    for other in (2000, 3000):
        text = itself.format(other, other)
        assert points(text)[-2:] == [(6, 0, 0), (7, 0, 0)] and points(text).count((6, 0, 0)) == 1
        assert said(text)[0] == "Line 5 (first of 2): A subprogram or macro call is ignored."
    within = f"{BEFORE}M97 P10\nX7\nM30\nN10 G1 X5\nM97 P10\nX6\nM99"
    assert points(within)[-3:] == [(5, 0, 0), (6, 0, 0), (7, 0, 0)]
    assert said(within) == ["Line 4: A subprogram or macro call is ignored."]


LIMIT = "Line {}: The program is read up to this line. Loops, jumps and calls would run more than {} lines, which is the limit."


def test_reading_ends_if_calls_exceed_the_limit_of_lines(monkeypatch):
    monkeypatch.setattr(flow, "MOST_LINES", 1000)
    chain = "".join(f"O{k}\nG1 X{k}\nM98 P{k + 1} L10\nM99\n" for k in range(100, 109)) + "O109\nG1 Y9\nM99"
    text = f"O1\n{BEFORE}M98 P100 L10\nX7\nM30\n{chain}"
    assert points(text)[-1][1] == 9 and said(text) == [LIMIT.format(5, "1,000")]


@pytest.mark.parametrize("call", ["M98 P100 L99999999", "G65 P100 L1000001", "M97 P5 L99999999"])
def test_call_with_too_many_lines_is_not_started(call):
    text = f"O1\n{BEFORE}{call}\nG1 X7\nM30\nN5 M99\nO100\nM99"
    assert points(text) == [(0, 0, 0)] and said(text)[0] == LIMIT.format(5, "1,000,000")
