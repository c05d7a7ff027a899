# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words whose meaning depends on the control, and words that resemble the words of another control or machine."""

import numpy as np
import pytest

from vkworkbench.core.gcode.dialects import at_line
from vkworkbench.core.gcode.reader import read_program
from vkworkbench.language import Unusable, render

PLAIN = "G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F60\nG1 X10 Y2\n"


def last(text):
    return tuple(read_program(PLAIN + text).toolpath().points[-1].round(6))


def said(text):
    return [render(at_line(problem)) for problem in read_program(text).problems]


@pytest.mark.parametrize("code", ["G154 P7", "G110", "G129", "G500", "G505", "G599"])
def test_work_offsets_of_haas_and_siemens_are_recognised(code):
    assert said(f"G0 {code} X1 Y2\nZ5\n{code}\nG1 Z-1 F60\nG0 Z5") == []
    assert last(f"G0 {code} X7 Y8") == (7, 8, -1)
    name = code.split(maxsplit=1)[0]
    assert said(PLAIN + code) == [
        f"Line 5: {name} is ignored. The coordinates after it are read as if it were not there."
    ]


def test_change_from_g154_p1_to_p2_of_haas_has_a_remark():
    assert said("G154 P1\n" + PLAIN + "G154 P1\nX5\nG154 P2\nX6") == [
        "Line 8: G154 is ignored. The coordinates after it are read as if it were not there."
    ]


def test_work_and_tool_offsets_of_okuma_are_recognised():
    begin = "G15 H1\nG21 G90\nG0 X0 Y0\nG56 HA Z5\nG1 Z-1 F60\nG41 DA X10 Y2\nG40\nG55 H2 Z7\nG15 H1\n"
    assert said(begin) == ["Line 6: Cutter compensation (G41) is ignored. The programmed path is used."]
    assert read_program(begin).toolpath().points[:, 2].tolist() == [5, -1, -1, 7]
    assert (
        said(begin + "G15 H2\nX5")[-1]
        == "Line 10: G15 is ignored. The coordinates after it are read as if it were not there."
    )


@pytest.mark.parametrize(
    "code", ["G450", "G451", "G601", "G602", "G603", "G641", "G642", "G643", "G644", "G645", "G43.4 H11", "G43.5 H11"]
)
def test_moves_in_lines_of_harmless_codes_are_read(code):
    assert last(f"{code} X5 Y6 Z-2") == (5, 6, -2)
    assert said(f"{PLAIN}{code} X5 Y6 Z-2") == []


def test_g700_and_g710_of_siemens_set_the_unit():
    inches, millimetres = read_program("G700 G0 X1 Y0 Z0\nG1 X2 F60"), read_program("G710 G0 X1 Y0 Z0\nG1 X2 F60")
    assert (inches.unit_told, inches.inches, millimetres.unit_told, millimetres.inches) == (True, True, True, False)
    assert inches.toolpath().points[-1, 0] == 50.8 and millimetres.toolpath().points[-1, 0] == 2
    assert inches.toolpath().feed[-1] == pytest.approx(25.4)


def test_more_work_offsets_of_fanuc_are_selected_by_g54_p():
    assert said("G54 P1\n" + PLAIN + "G54 P1\nX5\nG54 P2 G0 X6") == [
        "Line 8: G54.1 is ignored. The coordinates after it are read as if it were not there."
    ]
    assert said(PLAIN + "G54 G64 P0.01\nG90 G54 G4 P2\nX5") == []


def polar(text):
    path = read_program("O1\nG21 G90\nG0 X5 Y7 Z5\nG16\n" + text).toolpath()
    return path.points[-1].round(6).tolist(), [problem.what.code for problem in path.problems]


def test_polar_coordinates_of_fanuc_are_read():
    assert polar("G1 X10 Y90 F60") == ([0, 10, 5], []) and polar("G1 X10 Y0 F60\nY180") == ([-10, 0, 5], [])
    assert polar("G52 X100\nG1 X10 Y0 F60") == ([110, 0, 5], [])
    assert polar("G99 G81 X10 Y30 Z-4 R2 F60\nY90\nG15 G80\nX3") == ([3, 10, 2], [])
    assert polar("G91 G1 X10 F60") == ([15, 7, 5], ["coordinates-not-changed"])
    assert polar("G18 G1 X10 F60") == ([10, 7, 5], ["coordinates-not-changed"])


def test_machine_positions_of_heidenhain_are_not_coordinates():
    program = read_program("%A G71\nG00 G90 X+0 Y+0 Z+50\nG01 Z-1 F100\nG00 Z-9 M91\nX+9 Y+9 M92\nX+7\nN9 %A G71")
    assert program.toolpath().points[1:].tolist() == [[0, 0, -1], [0, 0, 50], [7, 0, 50]]
    assert [problem.what.code for problem in program.problems] == ["machine-height", "machine-position"]


def test_g90_and_g91_of_heidenhain_apply_to_the_words_after_them():
    begin, end = "%A G71\nG00 G90 X+5 Y+5 Z+50\n", "\nN9 %A G71"
    mixed = read_program(begin + "G01 X+10 G91 Y+5 F100\nX+1 G90 Y+2\nG91 X+1 G90 Y+3 G91" + end)
    assert mixed.toolpath().points[1:].tolist() == [[10, 10, 50], [11, 2, 50], [12, 3, 50]] and mixed.problems == ()
    unknown = read_program("%A G71\nG00 G90 Z+50\nG01 X+10 G91 Z-60 F100" + end)
    assert [problem.what.code for problem in unknown.problems] == ["word-not-read"]


def test_call_of_another_heidenhain_program_has_a_remark():
    begin = "%A G71\nG00 G90 X+0 Y+0 Z+50\n"
    assert said(begin + "%B\nG01 X+5 F100\nN9 %A G71") == ["Line 3: A subprogram or macro call is ignored."]
    assert said(begin + "G01 X+5 F100\nN9 %A G71") == []


def test_words_of_an_unknown_code_have_a_remark():
    assert last("G777 X5 Z-9") == (10, 2, -1)
    assert said(PLAIN + "G777 Z-9 X5 F90\nX6\nG777 P1\nG777 Y5") == [
        "Line 5: The unknown code 'G777' is ignored, and the X, Z words of its line with it.",
        "Line 7: The unknown code 'G777' is ignored.",
        "Line 8: The unknown code 'G777' is ignored, and the Y words of its line with it.",
    ]


@pytest.mark.parametrize(
    "cycle", ["G13 Z-5 I10 K20 Q2 D1 F500", "G12 I10 D1 F500", "G150 P2 X0 Y0 Z-3 I2 J1 Q1 D1 F500"]
)
def test_ignored_pocket_cycles_have_a_remark(cycle):
    text = PLAIN + cycle + "\nX20"
    name = cycle.split()[0]
    assert said(text) == [f"Line 5: The cuts of a pocket or circle ({name}) are ignored."]
    assert read_program(text).toolpath().feed[-1] == read_program(PLAIN + "X20").toolpath().feed[-1]


def test_axis_words_of_a_mirror_code_are_not_targets():
    assert last("G50.1 X0. Y0.") == last("G51.1 X0.") == (10, 2, -1)
    assert said("G50.1 X0. Y0.\n" + PLAIN + "G50.1 X0.\nX5") == []
    assert said(PLAIN + "G51.1 X0.\nX5\nG50.1 X0.\nX6") == []


def test_program_does_not_call_itself_as_a_subprogram():
    called = "Line 6: A subprogram or macro call is ignored."
    for call in ("M98 P10500", "M98 P500"):
        text = "O00500\n" + PLAIN + call + "\nX5\nM30"
        assert said(text) == [called] and read_program(text).toolpath().points[-1, 0] == 5


@pytest.mark.parametrize(("other", "calls_500"), [("10500", False), ("9", True)])
def test_program_that_p10500_calls_is_not_the_main_program(other, calls_500):
    text = f"O500\n{PLAIN}M99\n%\nO{other}\nG1 X77\nM99\n%\nO1\nM98 P10500\nG0 X3\nM30"
    # The main program is the first program that no other program calls. In the main program, M99 ends the reading
    # before O1. P10500 calls program 10500 if there is one, and otherwise program 500 once.
    assert ("Line 1: A subprogram or macro call is ignored." in said(text)) == calls_500
    assert read_program(text).toolpath().points[-1, 0] == (77 if calls_500 else 10)


def test_call_of_a_program_on_the_data_server_is_ignored():
    assert said(PLAIN + "M198 P1234\nX5\nM198") == ["Line 5: A subprogram or macro call is ignored."]
    kept = read_program("O1234\nG1 X99\nM99\nO1\n" + PLAIN + "M198 P1234").toolpath()
    assert kept.points[0].tolist() == [0, 0, 5]


@pytest.mark.parametrize(
    "line",
    [
        "#500=25.4 (WORKPIECE LENGTH)", "N10 #3000=1 (WORKPIECE NOT CLAMPED)", "#1=5 (POCKET1 (DEEP))", "#1=5 (MCALL)",
        "#<workpiece>=5", "G1 X#<workpiece>", "N5 IF[#<supa> EQ 1] GOTO 9", '#1=5 (X=AC(5), T="MILL")', "#1=5 ;STOPRE",
        "X[10] (SLOT1 (LEFT))",
    ],
)  # fmt: skip
def test_names_and_comments_are_not_siemens_words(line):
    assert last(line) == (10, 2, -1)


@pytest.mark.parametrize(
    "line",
    [
        "CYCLE84(10,0,2,-5)", "N20 MCALL CYCLE83(RTP,0,2,-5)", "/N20 POCKET1(5)", "N 20 HOLES2 (5)", "MCALL HOLE", "N10 ROT RPL=5",
        "N10 G0 A=DC(5)", 'CYCLE800(1,"TC1",0,57,0,0,0,90,0,0)', "N10 AMIRROR X0", "DEF REAL A", "N10 G1 X=R1",
    ],
)  # fmt: skip
def test_siemens_language_is_refused(line):
    with pytest.raises(Unusable, match="Siemens"):
        read_program(PLAIN + line)


@pytest.mark.parametrize("line", ["M109 P501", "M140", "T1 M6\nM104 S1", "G43 H1 Z9\nM190 R1", "M109 S1\nM6 T2"])
def test_codes_of_milling_machines_are_not_of_a_printer(line):
    assert read_program(PLAIN + line).other is None


@pytest.mark.parametrize("code", ["M104 S200", "M109 R200", "M140 S60", "M190 S60 (bed)", "M140\nM190 S60"])
def test_heating_codes_are_of_a_3d_printer(code):
    assert read_program(code + "\n" + PLAIN).other.code == "printing"


def test_drilling_cycles_of_fagor_are_read():
    drilled = read_program("G21 G90\nG0 X0 Y0 Z50\nG99 G81 X5 Y7 Z2 I-18 K20 F100\nY9\nG80\nG0 Z50").toolpath()
    holes = drilled.points[1:][~drilled.rapid]
    assert holes.tolist() == [[5, 7, -18], [5, 9, -18]]
    assert (drilled.points[:, 2] == 2).any()  # The tool first reaches the height above the hole.
    relative = read_program("G21\nG0 X0 Y0 Z20\nG91 G99 G82 X5 Y7 Z-18 I-6 F100\nG80").toolpath()
    assert relative.points[1:][~relative.rapid].tolist() == [[5, 7, -4]]
    assert said("G21 G90\nG0 X0 Y0 Z50\nG99 G81 X5 Y7 Z2 I-18 F100\nG80") == []
    assert said("G21 G90\nG0 X0 Y0 Z50\nG99 G81 X5 Y7 Z-18 R2 I-3 F100\nG80") == ["Line 3: I words are ignored."]


def test_line_numbers_without_digits_are_read():
    text = "%00000\nN T2.2\nN M6\nN G0 X0 Y0 Z5\nN G1 Z-1 F60\nN X10\n"
    assert said(text) == []
    assert read_program(text).toolpath().points[-1].tolist() == [10, 0, -1]


def test_full_width_digits_are_not_numbers():
    assert last("X\uff17") == (10, 2, -1)
    assert said(PLAIN + "X\uff17") == ["Line 5: Lines that do not consist of words like G1 X10 are ignored."]


def test_look_ahead_code_g8_is_not_a_lathe_code():
    slot = "G21 G90\n{}\nG0 X0 Y0 Z5\nG1 Z-1 F60\nG1 X10\n"
    assert read_program(slot.format("G08 P1")).other is None
    assert read_program(slot.format("G8\nG43 H1")).other is None
    assert read_program(slot.format("G8")).other.code == "lathe"


def test_checksums_in_lines_are_ignored():
    path = read_program("N1 G21 G90*35\nN2 G0 X0 Y0 Z5*99\nN3 G1 Z-1 F60 *4\nN4 G1 X10*7").toolpath()
    assert path.points[-1].tolist() == [10, 0, -1] and not path.problems


def test_decimal_commas_are_read_with_a_remark():
    assert last("G1 X10,25 Y-1,5") == (10.25, -1.5, -1) and last("Z-,5") == (10, 2, -1)
    assert said(PLAIN + "G1 X10,25") == ["Line 5: Commas in numbers are read as decimal points."]
    assert said(PLAIN + "G1 X10.,R2.") == ["Line 5: ,R words are ignored."]


def test_valid_words_in_a_line_with_unreadable_text_are_read():
    assert last("G1 X5 Y6 RAPIDO") == (5, 6, -1) and last("G1 X5 Y6 !") == (5, 6, -1)
    assert said(PLAIN + "G1 X5 !") == [
        "Line 5: Text that does not consist of words like G1 X10 is ignored. The words beside it are read."
    ]
    assert last("G1 Z-58145e87f0c3ee8848c97d.3F3") == (10, 2, -1)  # damaged: F is there twice
    assert last("G1 X1.2.3 Y6") == (10, 2, -1)  # The number X1.2.3 is not valid.


@pytest.mark.parametrize(
    ("line", "end", "remarks"),
    [
        ("#<a>=5\nG1 X[#<a> * 2]", 10, []), ("o1 repeat [2]\nG91 G1 X5\no1 endrepeat", 10, []), ("G1 @10 ^0", 10, []),
        ("S100 M3\nG33 X5 K1", 5, ["thread-at-pitch"]), ("G10 L20 P1 X-5\nG1 X1", 6, []), ("M70\nG20\nM72\nG1 X2", 2, []),
        ("G5.2 X10 Y0 P1", 0, ["unknown-code-with-words"]), ("G41 D1\nG1 X9", 9, ["compensation-not-read"]),
        ("G38.2 X9", 9, ["probing-as-rapid"]), ("g1x5 ; grbl", 5, []), ("G12 I5", 0, ["pocket-not-read"]),
        ("$J=G91 X10\nG1 X1", 1, ["line-with-variables"]), ("G1 X1\nG16\nX10", 10, ["coordinates-not-changed"]),
        ("G51 X2 Y2\nG1 X9", 9, ["coordinates-not-changed"]), ("M98 P1 L2\nM30\nO1\nG91 G1 X5\nM99", 10, []),
        ("G65 P1 A5\nM30\nO1\nG1 X#1\nM99", 5, []), ("#1=0\nWHILE [#1 LT 3] DO1\n#1=#1+1\nG1 X#1\nEND1", 3, []),
        ("IF [1 EQ 1] GOTO 5\nG1 X99\nN5 G1 X3", 3, []), ("G1 X10 ,R2", 10, ["word-not-read"]), ("G1 X10 ,C2", 10, ["word-not-read"]),
        ("G68 X0 Y0 R180\nG1 X10", -10, []), ("G16\nG1 X10 Y180", -10, []), ("G51 X0 Y0 P2000\nG1 X10", 20, []), ("G51.1 X0\nG1 X10", -10, []), ("G52 X5\nG1 X5", 10, []),
        ("G54.1 P3\nG1 X5", 5, ["coordinates-not-changed"]), ("M97 P5\nM30\nN5 G1 X5\nM99", 5, []), ("G13 I5 D1", 0, ["pocket-not-read"]),
        ("G47 P0 X5 Y0 J5", 0, ["unknown-code-with-words"]), ("G150 P1 X5 Y0 Z-5", 0, ["unknown-code-with-words"]),
        ("G70 I10 J0 L4", 0, ["hole-pattern-not-read"]), ("G154 P2\nG1 X1", 1, ["coordinates-not-changed"]),
        ("G200 Q200=2\nG1 X5", 5, ["line-with-variables"]), ("G2 X10 Y0 CR=5", 10, []), ("G1 X=10", 10, []), ("G642\nG1 X1", 1, []),
        ("G505\nG1 X1", 1, ["coordinates-not-changed"]), ("L10 P3", 0, ["subprogram-not-read"]), ('MSG("x")\nG1 X1', 1, []),
        ("G15 H2\nG1 X3", 3, ["coordinates-not-changed"]), ("CALL O9\nG1 X1", 1, ["words-not-read"]), ("VC1=5\nG1 X1", 1, ["line-with-variables"]),
    ],
)  # fmt: skip
def test_table_of_dialects_in_the_guide_is_correct(line, end, remarks):
    path = read_program(f"G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\n{line}\n").toolpath()
    assert path.points[-1][0] == pytest.approx(end, abs=1e-9)
    assert sorted(problem.what.code for problem in path.problems) == remarks


@pytest.mark.parametrize(
    "line", ["L X+10 Y+5 R0 FMAX", "G0 A=DC(10)", "ROT RPL=5", "CYCLE84(5,0,1,-5)", "MCALL CYCLE81(5)", "R1=5", "G1 AP=30 RP=5", "G1 X9 CHF=2"]
)  # fmt: skip
def test_control_languages_named_in_the_guide_are_refused(line):
    with pytest.raises(Unusable, match=r"The program is written for (Heidenhain|Siemens) controls"):
        read_program(f"G21 G90\nG0 X0 Y0 Z5\n{line}\n")


@pytest.mark.parametrize(
    ("line", "end", "remarks"),
    [
        ("M17\nX20", (20, 2, -1), ["goes-on"]),  # the end of a Siemens subprogram
        ("M98 P1\nM30\nO1\nX20\nM17\nX30", (20, 2, -1), ["after-end"]),
        ("G8 X20 Y5", (10, 2, -1), ["unknown-code-with-words"]),  # Fagor: a tangential arc
        ("G8 G1 X20 Y5", (20, 5, -1), []),
        ("G11", (10, 2, -1), ["unknown-code"]),  # Fagor: a mirror
        ("G11 X10 Y10 P90", (10, 2, -1), ["unknown-code-with-words"]),  # Okuma: a shift and a rotation
        ("G0 X10\nG63 Z-5 F300", (10, 2, -1), ["unknown-code-with-words"]),  # Siemens: a tap at feed
        ("G63\nG1 X20", (20, 2, -1), []),
        ("G59 P7\nX1\nG59 P8", (1, 2, -1), ["coordinates-not-changed"] * 2),  # Mach3
        ("Z20 G71", (10, 2, -1), ["unknown-code"]),  # Okuma: the return level
        ('N5 MSG ("X50")', (10, 2, -1), []),
    ],
)
def test_codes_of_other_dialects_are_read_or_reported(line, end, remarks):
    program = read_program(PLAIN + line)
    assert tuple(program.toolpath().points[-1]) == end
    assert sorted(problem.what.code for problem in program.problems for _ in range(problem.count)) == remarks


def test_g11_after_the_data_of_a_fanuc_program_has_no_remark():
    assert said("O1\n" + PLAIN + "G11") == []


def heidenhain(text):
    """Return the end points of lines and of whole arcs, X, Y and Z, the sum of the sweeps in turns, and the remarks."""
    program = read_program(f"%A G71\nG00 G90 X+10 Y+0 Z+5 *\nG01 F100 *\n{text}\nN9 %A G71")
    path = program.toolpath()
    keep = np.append(np.diff(path.sweep) != 0, True) | (path.sweep == 0)
    ends = (path.points[1:][keep].round(6) + 0.0).tolist()
    return ends, round(path.sweep.sum() / 2 / np.pi, 6), [problem.what.code for problem in path.problems]


def test_polar_coordinates_of_heidenhain_are_read():
    assert heidenhain("I+0 J+0 *\nG11 H+90 *\nG11 R+20 H+0 *") == ([[0, 10, 5], [20, 0, 5]], 0, [])
    assert heidenhain("G11 I+10 J+10 G91 R-5 H+180 *\nX+1 *") == ([[10, 15, 5], [11, 15, 5]], 0, [])
    assert heidenhain("I+0 J+0 *\nG13 H+90 *\nG12 H+0 Z+1 *\nG10 Z+9 H+0 *") == (
        [[0, 10, 5], [10, 0, 1], [10, 0, 9]],
        0,
        [],
    )
    assert heidenhain("I+0 J+0 *\nG13 G91 H+1080 Z-6 *\nG13 H+450 *") == ([[10, 0, -1], [0, 10, -1]], 3 + 1.25, [])


def test_datum_shift_of_heidenhain_moves_coordinates_and_poles():
    text = "G54 X+100 *\nX+0 *\nI+5 J+0 *\nG02 X+10 *\nG11 R+1 H+90 *\nG54 G91 X+1 *\nG90 X+0 Y+0 *\nG54 X+0 *\nX+0 *"
    assert heidenhain(text) == ([[100, 0, 5], [110, 0, 5], [105, 1, 5], [101, 0, 5], [0, 0, 5]], -0.5, [])


def test_corners_of_heidenhain_are_read():
    assert heidenhain("X+20 *\nN5 G25 R2 *\nY+9 *\nG24 R+1 *\nX+0 *") == (
        [[18, 0, 5], [20, 2, 5], [20, 8, 5], [19, 9, 5], [0, 9, 5]], 0.25, [],
    )  # fmt: skip
    assert heidenhain("X+20 *\n\n;note\nG25 R2 *\nY+9 *") == ([[18, 0, 5], [20, 2, 5], [20, 9, 5]], 0.25, [])
    for unread in ("X+20 *\nG25 R99 *\nY+9 *", "X+20 *\nG98 L1 *\nM8 *\nG25 R2 *\nY+9 *"):
        assert heidenhain(unread)[2] == ["word-not-read"]


def test_labels_of_heidenhain_are_called():
    repeated = "G98 L1 *\nG91 X+10 *\nN5 L1,2 *\nG90 Y+1 *"
    assert heidenhain(repeated) == ([[20, 0, 5], [30, 0, 5], [40, 0, 5], [40, 1, 5]], 0, [])
    called = "L7 *\nN3 L7,0 *\nZ+9 M2 *\nN6 G98 L7 *\nG91 X+1 M99 *\nG90 Y+2 *\nG98 L0 *"
    assert heidenhain(called) == ([[11, 0, 5], [11, 2, 5], [12, 2, 5], [12, 2, 9]], 0, [])


@pytest.mark.parametrize("call", ["L1,3", "L1", "G98 L1 *\nX+10 *\nL1", "G98 L1 *\nL1 *\nG98 L0"])
def test_label_of_heidenhain_that_cannot_be_called_has_a_remark(call):
    ends, _, remarks = heidenhain(f"X+20 *\n{call} *\nX+30 *")
    assert ends[-1] == [30, 0, 5] and remarks == ["subprogram-not-read"]


def test_e_word_after_a_coordinate_is_not_an_exponent():
    assert last("G1X10E5") == (10, 2, -1) and last("G1 X1.5E-01 Y30000000E-7") == (0.15, 3, -1)


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("X=IC(5) Y = AC( 1 )", (15, 1, -1)), ("G91 X=AC(0) Y5", (0, 7, -1)), ("G91\nX=AC(0) Y=IC(1)", (0, 3, -1)), ("G20\nX=IC(1)", (35.4, 2, -1)),
        ("TRANS X100 Y=50\nX1 Y1", (101, 51, -1)), ("TRANS X100\nATRANS X5 Z1\nX0 Z0", (105, 2, 1)), ("TRANS X100\nN5 TRANS\nX1", (1, 2, -1)),
        ("G0 SUPA Z500 D0", (10, 2, 5)), ('T="MILL 5"\nM6\nCYCLE832(0.1,1)\nCYCLE800()\nCYCLE800(1,"TC1",0,57,0,0.0,0,,0,0,0,0,0,-1)\nWORKPIECE(,"",,"BOX",1)\nX5', (5, 2, -1)),
    ],
)  # fmt: skip
def test_words_of_siemens_are_read(text, end):
    assert last(text) == end and said(PLAIN + text) == []


def test_arcs_of_siemens_are_read():
    path = read_program(
        PLAIN + "G3 X0 Y2 I=AC(5) J=AC(2)\nG2 X10 Z-3 I5 J=IC(0) TURN=2\n/ G3 X10 Y2 I-5 J0 TURN=1"
    ).toolpath()
    assert path.points[-1].tolist() == [10, 2, -3] and path.sweep.sum() == pytest.approx((1 - 5 + 4) * np.pi)
    assert [problem.what.code for problem in path.problems] == ["block-delete"]


def test_corners_of_siemens_are_read():
    rounded, cut = (read_program(PLAIN + f"X20 Y2 {word}\nY20").toolpath() for word in ("RND=2", "CHR=2"))
    assert rounded.sweep.sum() == pytest.approx(np.pi / 2) and not rounded.problems
    assert cut.points[-3:].tolist() == [[18, 2, -1], [20, 4, -1], [20, 20, -1]] and not cut.problems


def test_incremental_siemens_word_needs_a_known_position():
    with pytest.raises(Unusable, match="Siemens"):
        read_program("G21 G90\nG0 X=IC(5) Y0 Z5\nG1 Z-1 F60")


def test_drilling_cycles_of_siemens_are_read():
    """The tool descends at rapid to the clearance (2) above the reference plane (0), and rises to 20."""
    single = read_program(PLAIN + "G0 Z50\nCYCLE81(20,0,2,-10)\n/N5 CYCLE82 (20,,2,,5,0.5)\nX11").toolpath()
    assert single.points[4:, 2].tolist() == [2, -10, 20, 2, -5, 20, 20] and single.rapid[-1]
    assert [problem.what.code for problem in single.problems] == ["block-delete"]
    modal = read_program(PLAIN + "G0 Z20\nMCALL CYCLE83(20,0,2,-10,,-5)\nX20\nG91 X5\nM8\nMCALL\nX5").toolpath()
    assert modal.points[4:].tolist() == [
        [x, 2, z] for x, heights in ((20, (20, 2, -10, 20)), (25, (20, 2, -10, 20)), (30, (20,))) for z in heights
    ]
    assert [problem.what.code for problem in modal.problems] == ["pecks-not-read"]
