# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC programs read as text: what a machine would do with them, in mm and mm/s."""

from contextlib import suppress

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vkworkbench.core.gcode.dialects import at_line
from vkworkbench.core.gcode.reader import read_program
from vkworkbench.language import Unusable, render

PLAIN = "G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F60\nG1 X10 Y2\n"
POINTS = [(0, 0, 5), (0, 0, -1), (10, 2, -1)]


def points(text):
    return np.round(read_program(text).toolpath().points, 6).tolist()


def ends(text):
    """The last point of every line that moves."""
    path = read_program(text).toolpath()
    last = np.append(np.flatnonzero(np.diff(path.command)), len(path) - 1)
    return {int(path.command[i]): tuple(np.round(path.points[i + 1], 4)) for i in last}


def said(text):
    return [render(at_line(problem)) for problem in read_program(text).problems]


@pytest.mark.parametrize(
    "text",
    [
        PLAIN,
        PLAIN.replace("\n", "\r\n"),
        PLAIN.replace("\n", "\r"),
        PLAIN.lower(),
        PLAIN.replace(" ", ""),
        "G21 G90\nG0 X 0 Y 0 Z 5.\nG 1 Z - 1 F 60\nG1 X1 0 Y+2.0",
        "%\nO1000 (PART)\nN1 G21 G90\nN2 G0 X0 Y0 Z5\nN3 G1 Z-1 F60\nN4 X10 Y2\nM30\n%\n",
        "N10G90G21N20\nG00X0Y0Z5\nG01Z-1F60\nX10Y2",
        "G90 (absolute) G21 ; millimetres\nG0 X0 (left (of all)) Y0 Z5\nG1 Z-1 F60 ; down\nX10 ( right ) Y2",
        "G0 X0 Y0 Z5\nF60 Z-1 G1\nY2 X10",
        "G0 X0 Y0 Z5\nG1 Z-1E0 F6E+1\nX1.0E+01 Y.2e1",
        "G71 G90\nG0 X0 Y0 Z5\nG1 Z-1 F60\nX10 Y2",
        "G20 G21\nG0 X0 Y0 Z5\nG1 Z-1 F60\nG91 X10 Y2",
        "G21\nG0 X0 Y0 Z5\nG4 X3.\nG28 G91 Z0\nG90\nG1 Z-1 F60\nG10 L2 P1 X7 Y7\nG1 X10 Y2\nG53 G0 Z0",
        "G0 X0 Y0 Z5\nG1 Z-1 F60\nM117 Pocket1 X99\nX10 Y2",
    ],
)  # fmt: skip
def test_the_same_program_in_other_words(text):
    assert points(text) == [list(p) for p in POINTS]
    path = read_program(text).toolpath()
    assert path.feed.tolist() == [0.0, 1.0, 1.0][-len(path) :]


def test_inches_change_lengths_and_feeds_and_nothing_else():
    path = read_program("G20\nG0 X0 Y0 Z.2\nG1 Z-.1 F10\nG2 X2 Y0 I1 J0\nG3 X0 R1\nG21\nG1 X25.4 F254").toolpath()
    assert path.points[-1] == pytest.approx((25.4, 0, -2.54))
    assert path.points[:, 1].max() == pytest.approx(25.4, abs=0.02)
    assert path.feed[1] == path.feed[-1] == pytest.approx(254 / 60)
    assert path.lengths[1:-1].sum() == pytest.approx(2 * np.pi * 25.4, rel=2e-3)


@pytest.mark.parametrize(
    ("arc", "expected"),
    [
        ("G17 G2 X20 Y0 I10 J0", (10, 10, 0)),
        ("G17 G3 X20 Y0 I10 J0", (10, -10, 0)),
        ("G17 G2 X20 Y0 R10", (10, 10, 0)),
        ("G90.1 G2 X20 Y0 I10 J0", (10, 10, 0)),
        ("G18 G2 X20 Z0 I10 K0", (10, 0, -10)),
        ("G19 G2 Y20 Z0 J10 K0", (0, 10, 10)),
    ],
)  # fmt: skip
@pytest.mark.parametrize("inches", [False, True])
def test_arcs(arc, expected, inches):
    unit = 25.4 if inches else 1.0
    path = read_program(f"{'G20' if inches else 'G21'}\nG0 X0 Y0 Z0\nF100\n{arc}").toolpath(tolerance=1e-3 * unit)
    expected = np.array(expected) * unit
    assert np.abs(path.points - expected).max(axis=1).min() < 0.5 * unit
    assert path.lengths.sum() == pytest.approx(np.pi * 10 * unit, rel=1e-3)


def test_drilling_cycles():
    text = "G21\nG0 Z20\nG99 G83 X0 Y0 Z-10 R2 Q4 F100\nX10\nF200\nX20 Z-5\nG80\nZ30\nX0"
    path = read_program(text).toolpath()
    assert path.cycle.any()
    holes = path.points[1:][path.points[1:, 2] < -4.9]
    assert sorted({(x, z) for x, _, z in np.round(holes, 6)}) == [(0, -10), (0, -6), (10, -10), (10, -6), (20, -5)]
    assert path.rapid[path.command >= 8].all()  # behind G80
    assert path.feed[(path.command == 6) & ~path.rapid].tolist() == pytest.approx([200 / 60] * 2)


def test_a_cycle_repeated_and_a_cycle_kept_for_later():
    repeated = read_program("G0 X0 Y0 Z5\nG91 G81 X10 Y0 Z-4 R-3 L4 F100\nG80").toolpath()
    assert sorted(set(np.round(repeated.points[repeated.points[:, 2] < 0, 0], 6))) == [10, 20, 30, 40]
    later = read_program("G0 X0 Y0 Z5\nG98 G81 Z-4 R2 F100 L0\nX10\nX20\nG80").toolpath()
    assert sorted(set(np.round(later.points[later.points[:, 2] < 0, 0], 6))) == [10, 20]


def test_behind_g80_machines_go_on_with_rapids():
    assert points("G0 X0 Y0 Z5\nG81 X1 Y0 Z-1 R1 F60\nG80\nX5\nX9")[-2:] == [[5, 0, 5], [9, 0, 5]]
    path = read_program("G1 X0 Y0 Z5 F60\nG1 X1\nG80\nX5\nX9").toolpath()
    assert path.rapid.tolist() == [False, True, True]
    kept = points("G0 X0 Y0 Z5\nG81 Z-1 R1 F60 L0\nG80\nX5\nG81 X9 Z-2 R1")
    assert min(z for *_, z in kept) == -2


def test_a_cycle_without_repeats_drills_once():
    once = points("G0 X0 Y0 Z5\nG91 G81 X10 Y0 Z-4 R-3 F100\nG80")
    assert {x for x, _, z in once if z < 0} == {10}


def test_a_cycle_in_absolute_coordinates_is_repeated_in_no_other_place():
    text = "G0 X0 Y0 Z5\nG91\nG90\nG81 X10 Y0 Z-4 R1 L{} F100\nG80"
    assert points(text.format(3)) == points(text.format(1))


def test_fine_boring_goes_to_its_depth_and_up():
    bored = points("G0 X0 Y0 Z5\nG76 X5 Y5 Z-3 R1 Q.1 F100\nX9")
    assert [point for point in bored if point[2] < 0] == [[5, 5, -3], [9, 5, -3]] and bored[-1] == [9, 5, 5]


def test_feeds_by_time_and_by_turn():
    by_time = read_program("G0 X0 Y0 Z0\nG93\nG1 X10 F2\nG1 X40 F3\nG94\nG1 X0 F600").toolpath()
    assert by_time.feed.tolist() == pytest.approx([20 / 60, 90 / 60, 10])
    rapid = read_program("G0 X0 Y0 Z0\nG93\nG0 X10 F2\nG1 X40 F3").toolpath()
    assert rapid.feed.tolist() == pytest.approx([0, 90 / 60])
    slow = read_program("G0 X0 Y0 Z0\nG93\nG1 X10 F.5").toolpath()
    assert slow.feed.tolist() == pytest.approx([5 / 60])
    by_turn = read_program("G0 X0 Y0 Z0\nG95 S1200 M3\nG1 X10 F.1").toolpath()
    assert by_turn.feed.tolist() == pytest.approx([2])


@pytest.mark.parametrize(
    ("text", "numbers"),
    [
        ("T1 M6", [1]), ("M6 T1", [1]), ("T1\nM6", [1]), ("M06T01", [1]), ("T5 D1\nG43 H5", [5]),
        ("T1 M6\nT2\nG1 X20\nM6", [1, 2]), ("T1\nG1 X20\nT1\nG1 X30\nT2", [1, 2]),
    ],
)  # fmt: skip
def test_tool_changes(text, numbers):
    program = read_program(f"{text}\n{PLAIN}")
    assert [words["T"] for name, words in program.commands if name == "M6"] == numbers


def test_a_comment_ends_at_its_parenthesis():
    assert points("G0 X0 Y0 Z5\nG1 (down)Z-1 F60(now)X3 Y4") == [[0, 0, 5], [3, 4, -1]]


def test_commands_keep_their_lines():
    assert ends("(head)\n\nG21\n%\n" + PLAIN) == {7: (0, 0, -1), 8: (10, 2, -1)}
    assert ends("G1 X0 Y0 Z0 F100\n\n(x)\nX10\n/X20\nX30") == {4: (10, 0, 0), 5: (20, 0, 0), 6: (30, 0, 0)}


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ("/G1 X5", "lines with a block delete (/) are read like the others (line 5)"),
        ("#1=5", "variables and expressions are not read: the words with them are left out (line 5)"),
        ("G1 X#1 Y[2+#<d>]", "variables and expressions are not read: the words with them are left out (line 5)"),
        ("M98 P1000", "a subprogram or macro call is not read (line 5)"),
        ("G65 P9000 X5 Y6", "a subprogram or macro call is not read (line 5)"),
        ("G66 P9000 X5 Y6", "a subprogram or macro call is not read (line 5)"),
        ("O100 call [1]", "jumps, loops and calls are not followed (line 5)"),
        ("WHILE [#1 LT 5] DO1", "jumps, loops and calls are not followed (line 5)"),
        ("G68 X0 Y0 R45", "coordinates that G68 changes are read as if it were not there (line 5)"),
        ("G92 X0", "coordinates that G92 changes are read as if it were not there (line 5)"),
        ("G5 X10 Y2 I1 J1 P1 Q1", "a spline (G5) is read as a line (line 5)"),
        ("G999", "the unknown code 'G999' is ignored (line 5)"),
        ("WHAT IS THIS?", "lines that are not made of words like G1 X10 are left out (line 5)"),
        ("M30\nG1 X10", "what follows M2 or M30 is read as the same program (line 6)"),
        ("M30\nO2000\nG1 X99", "what follows the program's end is not read (line 7)"),
        ("M99\nG1 X99", "what follows the program's end is not read (line 6)"),
    ],
)
def test_what_is_not_read_is_said_with_its_line(line, sentence):
    text = PLAIN + line + "\n"
    assert said(text) == [sentence]
    assert points(text)[: len(POINTS)] == [list(p) for p in POINTS]
    assert all(x <= 10 for x, _, _ in points(text))


def test_a_subprogram_is_not_cut_where_it_is_defined():
    text = "O<hole> sub\nG1 X99 Y#1\nO<hole> endsub\n" + PLAIN
    assert points(text) == [list(p) for p in POINTS]
    assert said(text) == ["a subprogram or macro call is not read (2 times, first in line 1)"]


def test_problems_count():
    assert said(PLAIN + "#1=1\n#2=2\n") == [
        "variables and expressions are not read: the words with them are left out (2 times, first in line 5)"
    ]


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("0 BEGIN PGM PART MM\n1 BLK FORM 0.1 Z X+0\n2 TOOL CALL 1 Z S2000\n3 L X+10 Y+5 R0 FMAX\n", "Heidenhain controls (line 1)"),
        ("N10 G0 X0 Y0\nN20 CYCLE81(10,0,2,-5)\n", "Siemens controls (line 2)"),
        ("G0 X0\nG1 X=IC(5) F100\n", "Siemens controls (line 2)"),
        ("DEF REAL DEPTH\nG0 X0\n", "Siemens controls (line 1)"),
        ("solid cube\nfacet normal 0 0 1\nouter loop\n", "not an NC program: 3 of its 3 lines are not made of words"),
        ("Dear Sir,\nplease find enclosed\nthe drawing\n", "not an NC program"),
        ("", "not an NC program: no line of it moves a tool"),
        ("G21\nG90\nM30\n", "not an NC program: no line of it moves a tool"),
        ("#1=5\nG65 P9000\n", "none of its moves can be read: variables and expressions"),
        ("#1=5\nG1 X#1 Y[#1*2] F200\n", "none of its moves can be read: variables and expressions"),
    ],
)  # fmt: skip
def test_no_milling_program(text, sentence):
    with pytest.raises(Unusable, match=r"^[a-z]") as error:
        read_program(text)
    assert sentence in str(error.value)


def test_a_text_is_a_program_while_half_of_its_lines_are_words():
    assert len(read_program("what\nG0 X0 Y0 Z0\nG1 X5 F60").toolpath()) == 1
    with pytest.raises(Unusable, match="not made of words"):
        read_program("what\nis\nthis\nG0 X0 Y0 Z0\nG1 X5 F60")
    assert len(read_program("what\nis\nG0 X0 Y0 Z0\nG1 X5 F60\nG1 X6").toolpath()) == 2


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("G18\nG0 X50 Z2\nG1 Z-20 F.2", "a program for a lathe (G18, line 1)"),
        ("G0 X50 Z2\nG71 P10 Q20 U.5 W.1\nN10 G1 X20\nN20 Z-30", "a program for a lathe (G71, line 2)"),
        ("G0 X50 Z2\nG72 P10 Q20 U.5 W.1\nN10 G1 X20\nN20 Z-30", "a program for a lathe (G72, line 2)"),
        ("G0 X50 Z2\nG76 P10 Q20\nG1 Z-30", "a program for a lathe (G76, line 2)"),
        ("G7\nG0 X50 Z2\nG1 Z-20 F.2", "a program for a lathe (G7, line 1)"),
        ("G0 X50 Z2\nG8\nG1 Z-20 F.2", "a program for a lathe (G8, line 2)"),
        ("G0 X50 Z2\nG96 S200 M3\nG1 Z-20 F.2", "a program for a lathe (G96, line 2)"),
        ("M104 S200\nG1 X5 Y5 Z.2 F600\nG1 X9 E1", "a program for a 3D printer (M104, line 1)"),
        ("G1 X0 Z0 F600\n" + "".join(f"X{i} E{i}\n" for i in range(1, 12)), "a program for a 3D printer (E, line 2)"),
        ("G1 X0 Y0 U0 V0 F100\nG1 X10 Y1 U10 V2", "a program for a wire cutter (U, V, line 1)"),
    ],
)
def test_other_machines_say_so(text, sentence):
    assert render(read_program(text).other).startswith(sentence)


@pytest.mark.parametrize("line", ["G18 G2 X5 Z0 R10", "G96 S100", "G8 P1", "G76 X5 Y5 Z-3 R1 Q.1", "E5 (a slip)"])
def test_a_milling_program_is_none_of_them(line):
    assert read_program(PLAIN + line).other is None


@pytest.mark.parametrize("line", ["G61 P1", "G64 P.01 Q.01", "G9 X5", "".join(f"X{i} A{i}\n" for i in range(1, 13))])
def test_nor_is_one_that_does_not_move_in_y(line):
    assert read_program("G0 X0 Z5\nG1 Z-1 F60\nX10\n" + line).other is None


def test_a_rotary_axis_that_cuts():
    assert read_program("G0 X0 Y0 Z5 A0\nG1 Z-1 F100\nX10 A0\nX20 A5\nX30 A10").rotary == (4, 5)
    assert read_program("G0 X0 Y0 Z5 A0\nG1 X10 Z-1 F100\nG0 Z5\nG0 A90\nG1 Z-1\nX20").rotary == ()


@given(st.text(alphabet="GXYZIJKRFMTSNOPQLDHABCUVE0123456789.+-()[]#=/;%<> \n\r\t", max_size=200))
def test_any_text_is_read_or_refused_with_words(text):
    try:
        path = read_program(PLAIN + text).toolpath()
    except ValueError as error:
        assert str(error)
    else:
        assert np.isfinite(path.points).all() and np.isfinite(path.feed).all()


@given(st.binary(max_size=200))
def test_any_bytes_as_well(data):
    try:
        read_program(data.decode("latin-1"))
    except ValueError as error:
        assert str(error)


@pytest.mark.parametrize(
    "word", ["G-1E999", "G1E999", "T-1E999", "T1E999 M6", "G91 G81 X1 Z-1 R1 L1E999", "L-1E999", "X1E999", "S-1E999"]
)
def test_numbers_beyond_all_bounds(word):
    assert np.isfinite(read_program(f"{PLAIN}{word}\nX5\n").toolpath().points).all()


def test_long_lines_take_no_long_time():
    for line in (
        "X1E5" * 5000,
        "(" * 50_000,
        "1" * 50_000,
        "O[" * 20_000,
        "X[" * 20_000,
        "N1" + " " * 50_000 + "!",
        "/" * 50_000,
    ):
        with suppress(ValueError):
            read_program(PLAIN + line)
