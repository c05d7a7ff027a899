# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words that a machine understands but the reader ignores have a remark, in commands and in programs."""

from __future__ import annotations

import pytest

from vkworkbench.core import linearize, machining
from vkworkbench.core.gcode import read_program
from vkworkbench.language import Unusable

START = [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"Z": -1.0, "F": 10.0})]
HOLE = {"X": 1.0, "Y": 2.0, "Z": -3.0, "R": 1.0, "F": 2.0}


def told(commands):
    """Return code, arguments, first command and count of each problem in a program that begins with START."""
    problems = linearize([*START, *commands]).problems
    return [(p.what.code, *p.what.arguments.values(), p.command, p.count) for p in problems]


@pytest.mark.parametrize("commands, problems", [
    ([("G1", {"A": 360.0})], [("rotary-cuts", "A", 2, 1)]),
    ([("G1", {"A": 0.0, "X": 5.0}), ("G1", {"A": 0.0, "X": 9.0})], []),
    ([("G0", {"B": 90.0}), ("G1", {"B": 90.0, "X": 9.0})], [("rotary-not-read", "B", 2, 1)]),
    ([("G0", {"C": 90.0}), ("G1", {"C": 80.0}), ("G1", {"C": 70.0})], [("rotary-cuts", "C", 3, 2), ("rotary-not-read", "C", 2, 1)]),
    ([("G1", {"A": float("nan")})], [("rotary-cuts", "A", 2, 1)]),
    ([("G1", {"U": 1.0, "X": 3.0}), ("G1", {"U": 2.0})], [("word-not-read", "U", 2, 2)]),
    ([("G1", {"V": 1.0, "W": 3.0, "E": 1.0})], [("word-not-read", letter, 2, 1) for letter in "EVW"]),
    ([("G81", {**HOLE, "L": 3.0}), ("G81", {**HOLE, "L": 1.0})], [("repeats-not-read", "L", 2, 1)]),
    ([("G81", {**HOLE, "K": 2.0})], [("repeats-not-read", "K", 2, 1)]),
    ([("G2", {"X": 4.0, "Y": 0.0, "I": 2.0, "J": 0.0, "K": 3.0, "P": 1.0})], []),
    ([("G2", {"X": 4.0, "Y": 0.0, "I": 2.0, "J": 0.0, "P": 2.0})], []),
    ([("G3", {"X": 4.0, "Y": 0.0, "I": 2.0, "J": 0.0, "P": 2.5})], [("turns-not-read", 2, 1)]),
    ([("G82", {**HOLE, "P": 0.5}), ("G4", {"P": 2.0}), ("G4", {"X": 2.0})], []),
    ([("G4", {"P": -2.0}), ("G4", {"S": 2.0}), ("G4", {})], [("dwell-untimed", 2, 3)]),
    ([("G20", {}), ("G1", {"X": 1.0})], [("inches-not-read", 2, 1)]),
    ([("G21", {}), ("G40", {}), ("G94", {}), ("M3", {"S": 500.0}), ("T1", {}), ("G43", {"H": 1.0})], []),
    ([("G42", {"D": 1.0}), ("G41.1", {})], [("compensation-not-read", "G41.1", 3, 1), ("compensation-not-read", "G42", 2, 1)]),
    ([("G41", {"D": 1.0}), ("G42.1", {})], [("compensation-not-read", "G41", 2, 1), ("compensation-not-read", "G42.1", 3, 1)]),
    ([("G93", {}), ("G95", {})], [("feed-mode-not-read", "G93", 2, 1), ("feed-mode-not-read", "G95", 3, 1)]),
    ([("M98", {"P": 100.0}), ("m098", {}), ("M97", {"P": 5.0}), ("M198", {"P": 5.0})], [("subprogram-not-read", 2, 4)]),
    ([("G1", {"X": 5.0, "R": 2.0}), ("G0", {"Y": 5.0, "I": 1.0})], [("word-not-read", "I", 3, 1), ("word-not-read", "R", 2, 1)]),
    ([("G1", {"X": 5.0, "F": -3.0}), ("G1", {"X": 6.0, "F": 0.0})], [("unusable-feed", 2, 1)]),
    ([("M30", {})], []),
    ([("G1", {"X": 1.0}), ("M02", {}), ("M5", {}), ("G1", {"X": 2.0}), ("M30", {}), ("G0", {"X": 3.0})], [("goes-on", 5, 2)]),
])  # fmt: skip
def test_ignored_words_of_commands_have_a_remark(commands, problems):
    assert told(commands) == problems


def test_inverse_time_feeds_are_not_speeds():
    path = linearize([*START, ("G93", {}), ("G1", {"X": 10.0, "F": 2.0}), ("G94", {}), ("G1", {"X": 20.0, "F": 5.0})])
    assert path.feed.tolist() == [10.0, 0.0, 5.0]
    assert [note.code for note in machining(path).left_out] == ["cutting-untimed"]


def test_machining_time_without_a_known_dwell_has_a_note():
    assert [note.codes for note in machining(linearize([*START, ("G4", {"S": 1.0})])).left_out] == [
        ("in-commands", "dwell-untimed")
    ]


@pytest.mark.parametrize("line, problem", [
    ("G0 A90", ("rotary-not-read", "A")), ("G1 X1 U2", ("word-not-read", "U")), ("G1 E5", ("word-not-read", "E")),
    ("G43 H1\nG1 X4", ("length-before-height",)), ("G4 S2", ("dwell-untimed",)), ("G4", ("dwell-untimed",)),
    ("G38.2 Z-9 F50", ("probing-as-rapid",)), ("G31 Z-9 F50", ("probing-as-rapid",)),
    ("G41 D1", ("compensation-not-read", "G41")), ("M98 P100", ("subprogram-not-read",)), ("M97 P5", ("subprogram-not-read",)),
    ("G1 X1 Y2 X3", ("word-twice", "X")), ("G1 X1 F100 F200", ("word-twice", "F")), ("G0 G1 X3", ("two-motions",)),
    ("G90 X3 G91 Y1 G90", ("two-motions",)), ("G2 X1 I1 J0 L3", ("word-not-read", "L")),
    ("G10 L2 P1 X5", ("origin-assumed", "G10")), ("G10 L20 P0 X0\nG10 L20 P33 X0", ("coordinates-not-changed", "G10")),
    ("G7.1 C20", ("coordinates-not-changed", "G7.1")), ("G7", ("unknown-code", "'G7'")),
    ("G76 P1 Z-2 Q1", ("unknown-code-with-words", "Z", "'G76'")),
    ("$H", ("machine-position", "G28")), ("(RPT N1,N2)N3", ("subprogram-not-read",)), ("G81 R2 Z-2 I-20\nG80 G0", ("word-not-read", "I")), ("G15 H1", ("coordinates-not-changed", "G15")),
])  # fmt: skip
def test_ignored_words_of_programs_have_a_remark(line, problem):
    program = read_program(f"G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\n{line}\nX10 Y3")
    assert [(p.what.code, *p.what.arguments.values()) for p in program.problems] == [problem]
    assert program.problems[0].command == 4 + line.startswith(("G43", "G10 L20"))


@pytest.mark.parametrize(
    "line",
    [
        "G1 X1 A0",
        "G43 H1 Z-1",
        "G40",
        "M3 S500",
        "G2 X4 Y0 I2 P1",
        "G94",
        "G10 L1 P1 Z5",
        "M97",
        "G76 Y1 Z-2 R1\nG80 G0",
        "$X",
        "POPEN\nDPRNT[TIME*(HHMMSS):*#3021[60]]\nPCLOS",
        "N10 POPEN\nN20 DPRNT[X#100[33]]\nN30 PCLOS",
        "G15 G43 H2 Z-1",
        "$$\n$G\n?",
        "M68 E0 Q100",
        "M203 X200 Y200 Z5 E25",
        "M204 P500 T1000",
        "M2000 W1 P100",
        "G1 X5 M67 E2 Q25\n" * 12,
        "G90 G54 G0 X1",
        "G80 G0 X1",
        "G0 Z5\nG81 X1 Z-2 R1\nG80",
        "G0 Z5\nG81 X1 Z-2 R1\nG80\nG1 X2\nG0 X3\nG81 Z-2 R1\nG80",
        "G8",
    ],
)
def test_words_without_effect_on_the_path_have_no_remark(line):
    program = read_program(f"G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\n{line}\nX10 Y3")
    assert program.problems == () and program.other is None
    assert program.toolpath().points.max() <= 10 and not program.comments


@pytest.mark.parametrize("line", ["G1 X50 Y20 M203", "X50 Y20 M1000", "M206 G1 X50 Y20"])
def test_custom_m_codes_keep_the_move_of_their_line(line):
    path = read_program(f"G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\n{line}\nX10 Y3").toolpath()
    assert [50, 20, -1] in path.points.tolist()


def test_rotary_and_lathe_programs_are_noticed():
    assert read_program("G0 X0 Y0 Z5\nG1 Z-1 F100\nG1 A360\nA0").rotary == (3, 4)
    other = read_program("G0 X20 Z5\nG1 X10 F100\nW-5\nU2 W-1").other
    assert other.code == "lathe" and other.arguments["name"] == "U, W"


def test_program_with_rotary_moves_only_is_refused():
    with pytest.raises(Unusable, match=r"Moves of a rotary axis \(A\) are ignored"):
        read_program("G1 A5\nG1 A9")


@pytest.mark.parametrize("lines, seconds", [
    ("G4 P2", [2]), ("G04 X1.5", [1.5]), ("G4 U3", [3]), ("G4 F4", [4]), ("G4 P500", [0.5]), ("G4 P2\nG4 P3", [2, 3]),
    ("G82 X1 Z-2 R1 P0.5\nX2\nX3\nG80", [0.5, 0.5, 0.5]), ("G82 X1 Z-2 R1 P0.5\nG81 X2 Z-2 R1\nG80", [0.5]),
    ("G91\nG82 X1 Z-2 R1 L3 P0.5\nG80", [0.5, 0.5, 0.5]),
])  # fmt: skip
def test_dwells_of_programs_are_read_in_seconds(lines, seconds):
    path = read_program(f"G21 G90\nG0 X0 Y0 Z5\nG1 Z0 F100\n{lines}\nG0 Z5\n").toolpath()
    assert path.dwells[:, 1].tolist() == seconds and path.dwells[:, 0].min() == 4 + lines.startswith("G91")


def test_words_that_freecad_stores_in_a_comment_are_named():
    """FreeCAD stores the line ``G1 X45 F10 (finish)`` of a Custom operation as a comment with the parameter X."""
    path = linearize([("G0", {"X": 0.0, "Z": 5.0}), ("(10finish)", {"X": 45.0}), ("(plain)", {}), ("G1", {"Z": -1.0})])
    assert [(p.what.code, p.what.arguments["letter"], p.command) for p in path.problems] == [("word-not-read", "X", 1)]


def test_rapids_after_g80_have_a_remark_after_g1():
    program = read_program("G21 G90\nG0 X0 Y0 Z5\nG1 Z2 F100\nG81 X1 Z-2 R1\nG80\nX10 Y3\nX11\nG81 Z-2 R1\nG80\nX12")
    assert program.toolpath().rapid[-1]
    assert [(problem.what.code, problem.command, problem.count) for problem in program.problems] == [
        ("rapid-after-cancel", 6, 1)
    ]
