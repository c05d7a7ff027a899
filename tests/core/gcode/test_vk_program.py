# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC programs are read from text and converted to the moves of a machine, in mm and mm/s."""

from contextlib import suppress
from time import process_time

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vkworkbench.core.gcode.dialects import at_line
from vkworkbench.core.gcode.reader import read_program
from vkworkbench.language import Message, Unusable, render

PLAIN = "G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F60\nG1 X10 Y2\n"
POINTS = [(0, 0, 5), (0, 0, -1), (10, 2, -1)]


def points(text):
    return np.round(read_program(text).toolpath().points, 6).tolist()


def ends(text):
    """Return {line number: last point} for each program line that moves the tool."""
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
        ":1000 G21\n: G91 X7\n:\nG90\nG0 X0 Y0 Z5\nG1 Z-1 F60\nX10 Y2\nM30",
        "N10G90G21N20\nG00X0Y0Z5\nG01Z-1F60\nX10Y2",
        "G90 (absolute) G21 ; millimetres\nG0 X0 (left (of all)) Y0 Z5\nG1 Z-1 F60 ; down\nX10 ( right ) Y2",
        "G0 X0 Y0 Z5\nF60 Z-1 G1\nY2 X10",
        "G0 X0 Y0 Z5\nG1 Z-1E+00 F6E+01\nX1.0E+01 Y20.e-01",
        "G71 G90\nG0 X0 Y0 Z5\nG1 Z-1 F60\nX10 Y2",
        "G20 G21\nG0 X0 Y0 Z5\nG1 Z-1 F60\nG91 X10 Y2",
        "G21\nG0 X0 Y0 Z5\nG4 X3.\nG28 G91 Z0\nG90\nG1 Z-1 F60\nG10 L1 P1 Z7\nG1 X10 Y2",
        "G0 X0 Y0 Z5\nG1 Z-1 F60\nM117 Pocket1 X99\nX10 Y2",
    ],
)  # fmt: skip
def test_same_program_in_other_notations_has_the_same_moves(text):
    assert points(text) == [list(p) for p in POINTS]
    assert not any("words like" in one for one in said(text))
    path = read_program(text).toolpath()
    assert path.feed.tolist() == [0.0, 1.0, 1.0][-len(path) :]


def test_inches_scale_lengths_and_feeds_only():
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
def test_arcs_of_a_program_pass_through_the_expected_point(arc, expected, inches):
    unit = 25.4 if inches else 1.0
    path = read_program(f"{'G20' if inches else 'G21'}\nG0 X0 Y0 Z0\nF100\n{arc}").toolpath(tolerance=1e-3 * unit)
    expected = np.array(expected) * unit
    assert np.abs(path.points - expected).max(axis=1).min() < 0.5 * unit
    assert path.lengths.sum() == pytest.approx(np.pi * 10 * unit, rel=1e-3)


def test_arc_tolerance_is_a_hundredth_mm_by_default():
    program = read_program("G21 G0 X0 Y0 Z0\nG2 X40 Y0 I20 J0 F100")
    usual, coarse = program.toolpath(), program.toolpath(tolerance=0.02)
    assert usual.points.tolist() == program.toolpath(tolerance=0.01).points.tolist()
    assert len(coarse) < len(usual)


def test_drilling_cycles_drill_all_holes():
    text = "G21\nG0 Z20\nG99 G83 X0 Y0 Z-10 R2 Q4 F100\nX10\nF200\nX20 Z-5\nG80\nZ30\nX0"
    path = read_program(text).toolpath()
    assert path.cycle.any()
    holes = path.points[1:][~path.rapid & (path.points[1:, 2] < -4.9)]
    assert sorted({(x, z) for x, _, z in np.round(holes, 6)}) == [(0, -10), (0, -6), (10, -10), (10, -6), (20, -5)]
    assert path.rapid[path.command >= 8].all()  # The moves after G80 are rapids.
    assert path.feed[(path.command == 6) & ~path.rapid].tolist() == pytest.approx([200 / 60] * 2)


def test_cycle_is_repeated_or_stored_without_drilling():
    repeated = read_program("G0 X0 Y0 Z5\nG91 G81 X10 Y0 Z-4 R-3 L4 F100\nG80").toolpath()
    assert sorted(set(np.round(repeated.points[repeated.points[:, 2] < 0, 0], 6))) == [10, 20, 30, 40]
    later = read_program("G0 X0 Y0 Z5\nG98 G81 Z-4 R2 F100 L0\nX10\nX20\nG80").toolpath()
    assert sorted(set(np.round(later.points[later.points[:, 2] < 0, 0], 6))) == [10, 20]


@pytest.mark.parametrize(
    ("text", "holes"),
    [
        ("G0 Z50\nG99 G81 X0 Y0 Z-10. R2. F100.\nG91 X10. K9\nG90 G80", {(10.0 * k, -10.0) for k in range(10)}),
        ("G0 Z5\nG91 G99 G81 X10. Y0 Z-4. R-3. L4 F100\nG80", {(10.0 * k, -2.0) for k in range(1, 5)}),
        ("G0 Z5\nG91 G99 G81 X10 Y0 Z-4 R-3 F100\nX10\nX10 R-2\nX10 Z-5\nG80", {(10, -2), (20, -2), (30, -1), (40, -2)}),
        ("G0 Z5\nG91 G99 G81 X10 Y0 Z-4 R-3 F100\nG80\nG0 Z7\nG81 X10", {(10, -2), (20, 2)}),
        ("G0 Z5\nG91 G99 G81 X10 Y0 Z-4 R-3 F100\nG0 Z7\nG81 X10", {(10, -2), (20, 2)}),
        ("G0 Z5\nG90 G99 G81 X10 Y0 Z-4 R2 F100\nX20 R1\nX30 Z-5", {(10, -4), (20, -4), (30, -5)}),
    ],
)  # fmt: skip
def test_series_of_holes_has_the_programmed_depths(text, holes):
    path = read_program(text).toolpath()
    assert {(x, z) for x, _, z in np.round(path.points[1:][~path.rapid], 6)} == holes
    assert path.problems == ()


def test_g99_returns_to_r_plane_and_g98_to_initial_height():
    assert points("G0 Z50\nG99 G81 X0 Y0 Z-10. R2. F100.\nG91 X10. K9\nG90 G80")[-1] == [90, 0, 2]
    assert points("G0 Z50\nG99 G81 X0 Y0 Z-10 R2 F100\nG80\nG98 G81 X10")[-1] == [10, 0, 2]
    assert points("G0 Z50\nG99 G81 X0 Y0 Z-10 R2 F100\nX10\nG98 X20\nG80\nG0 X100")[-2:] == [[20, 0, 50], [100, 0, 50]]
    assert points("G0 Z5\nG98 G81 X0 Y0 Z-4 R8 F100\nX10 R2\nG80")[-1] == [10, 0, 5]


@pytest.mark.parametrize("inches", [False, True])
def test_number_of_repeats_does_not_depend_on_the_unit(inches):
    program = read_program(f"{'G20' if inches else 'G21'}\nG0 X0 Y0 Z1\nG91 G81 X1 Z-2 R-.5 F9 K3\nG80")
    drilled = program.toolpath()
    assert len(np.unique(drilled.points[1:][~drilled.rapid, 0])) == 3 and drilled.problems == ()


@pytest.mark.parametrize("code", ["G73", "G83"])
def test_peck_words_of_haas_are_not_read_as_repeats(code):
    text = f"G20\nG0 X0 Y0 Z1.\nG99 {code} X1. Z-1. R.1 {{}} F8.\nX2.\nG80"
    pecked = points(text.format("Q.3"))
    for words, unread in (
        ("I.3 J.05 K.1", "JK"), ("I.3", ""), ("I.3 K1", "K"), ("Q.3 I.5 J.1 K.2", "IJK"), ("Q.3 K.2", "K"), ("Q.3 J1", "J")
    ):  # fmt: skip
        assert points(text.format(words)) == pecked, words
        assert said(text.format(words)) == [f"Line 3: {letter} words are ignored." for letter in unread]
    repeated = text.replace("X2.", "G91 X1. Z-1.1 R0 K2").format("I.3")
    assert {x for x, *_ in points(repeated)} == {0, 25.4, 50.8, 76.2}


def test_moves_after_g80_are_rapids():
    assert points("G0 X0 Y0 Z5\nG81 X1 Y0 Z-1 R1 F60\nG80\nX5\nX9")[-2:] == [[5, 0, 5], [9, 0, 5]]
    path = read_program("G1 X0 Y0 Z5 F60\nG1 X1\nG80\nX5\nX9").toolpath()
    assert path.rapid.tolist() == [False, True, True]
    kept = points("G0 X0 Y0 Z5\nG81 Z-1 R1 F60 L0\nG80\nX5\nG81 X9 Z-2 R1")
    assert min(z for *_, z in kept) == -2


def test_cycle_without_repeats_drills_once():
    once = points("G0 X0 Y0 Z5\nG91 G81 X10 Y0 Z-4 R-3 F100\nG80")
    assert {x for x, _, z in once if z < 0} == {10}


@pytest.mark.parametrize("letter", "KL")
def test_cycle_with_absolute_position_repeats_at_the_same_place(letter):
    text = f"G0 X0 Y0 Z5\nG91\nG90\nG81 X10 Y0 Z-4 R1 {letter}3 F100\nG80"
    assert [point for point in points(text) if point[2] < 0] == 3 * [[10, 0, -4]]
    assert said(text) == []


def test_fine_boring_cycle_reaches_its_depth_and_retracts():
    bored = points("G0 X0 Y0 Z5\nG76 X5 Y5 Z-3 R1 Q.1 F100\nX9")
    assert [point for point in bored if point[2] < 0] == [[5, 5, -3], [9, 5, -3]] and bored[-1] == [9, 5, 5]


@pytest.mark.parametrize("code", ["G74", "G84", "G85", "G88", "G89"])
@pytest.mark.parametrize(("head", "level", "fed", "end"), [
    ("", "G98", 0.7 + 2.6, 2.0), ("", "G99", 1.4, 0.1), ("O1000\n", "G98", 1.4, 2.0), ("O1000\n", "G99", 1.4, 0.1),
])  # fmt: skip
def test_tapping_and_boring_feed_out_as_the_control_does(code, head, level, fed, end):
    """LinuxCNC feeds up to the height of G98. A Fanuc control feeds up to R, and then rises at rapid."""
    text = f"{head}G20\nT2 M6\nG0 G90 G54 X.5 Y.5 S500 M3\nG43 H2 Z2.\n{level} {code} Z-.6 R.1 F25.\nX1.5\nG80\nM30"
    path = read_program(text).toolpath()
    fed = min(fed, 1.4) if code == "G85" else fed  # For G85, LinuxCNC also feeds up only to R.
    assert path.lengths[~path.rapid].sum() == pytest.approx(2 * fed * 25.4) and path.lengths.all()
    assert path.points[-1, 2] == pytest.approx(end * 25.4) and not path.problems


def test_feeds_per_time_and_per_turn_are_converted():
    by_time = read_program("G0 X0 Y0 Z0\nG93\nG1 X10 F2\nG1 X40 F3\nG94\nG1 X0 F600").toolpath()
    assert by_time.feed.tolist() == pytest.approx([20 / 60, 90 / 60, 10])
    rapid = read_program("G0 X0 Y0 Z0\nG93\nG0 X10 F2\nG1 X40 F3").toolpath()
    assert rapid.feed.tolist() == pytest.approx([0, 90 / 60])
    slow = read_program("G0 X0 Y0 Z0\nG93\nG1 X10 F.5").toolpath()
    assert slow.feed.tolist() == pytest.approx([5 / 60])
    by_turn = read_program("G0 X0 Y0 Z0\nG95 S1200 M3\nG1 X10 F.1").toolpath()
    assert by_turn.feed.tolist() == pytest.approx([2])


def test_feed_per_turn_follows_the_spindle_speed():
    feeds = read_program("G95 F.1\nG0 X0 Y0 Z0\nS1200 M3\nG1 X10\nS2400\nX20\nG94 F600\nX30\nS100\nX40").toolpath().feed
    assert feeds.tolist() == pytest.approx([2, 4, 10, 10])
    assert read_program("G95 F.1 S1200\nG0 X0 Y0 Z0\nG1 X10\nG94 S60\nX20").toolpath().feed.tolist() == pytest.approx(
        [2, 2]
    )


def test_feed_per_turn_without_spindle_speed_is_unknown():
    """The feed of an earlier G94 move is not used instead."""
    path = read_program("G0 X0 Y0 Z0\nG1 X10 F600\nG95 F.1\nX20\nS1200 M3\nX30\nG94 F300\nX40").toolpath()
    assert path.feed.tolist() == pytest.approx([10, 0, 2, 5])
    assert [problem.what.code for problem in path.problems] == ["feed-mode-not-read"]
    assert path.command.tolist() == [2, 4, 6, 8]
    # The move before the first cut has no remark.
    told = read_program("G0 X0 Y0 Z0\nG95 F.1\nX5\nS1200\nG1 X10").toolpath()
    assert told.feed.tolist() == pytest.approx([0, 2]) and not told.problems


def test_command_numbers_of_a_program_are_line_numbers():
    """Code that finds moves by the number of their command also works for programs."""
    path = read_program("%\n\nG0 X0 Y0 Z0\n\nG1 X10 F600\n\n(end)\n").toolpath()
    assert path.command.tolist() == [5] and path.commands == 6


@pytest.mark.parametrize(
    ("text", "numbers"),
    [
        ("T1 M6", [1]), ("M6 T1", [1]), ("T1\nM6", [1]), ("M06T01", [1]), ("T5 D1\nG43 H5", [5]),
        ("T1 M6\nT2\nG1 X20\nM6", [1, 2]), ("T1\nG1 X20\nT1\nG1 X30\nT2", [1, 2]),
        ("T01T02M06\nG1 X20\nM6", [1, 2]), ("M6 T3 T4", [3]),  # The second T word only prepares the next tool.
    ],
)  # fmt: skip
def test_tool_changes_have_their_numbers(text, numbers):
    program = read_program(f"{text}\n{PLAIN}")
    assert [words["T"] for name, words in program.commands if name == "M6"] == numbers


def test_words_after_a_comment_in_parentheses_are_read():
    assert points("G0 X0 Y0 Z5\nG1 (down)Z-1 F60(now)X3 Y4") == [[0, 0, 5], [3, 4, -1]]


def test_moves_keep_their_line_numbers():
    assert ends("(head)\n\nG21\n%\n" + PLAIN) == {7: (0, 0, -1), 8: (10, 2, -1)}
    assert ends("G1 X0 Y0 Z0 F100\n\n(x)\nX10\n/X20\nX30") == {4: (10, 0, 0), 5: (20, 0, 0), 6: (30, 0, 0)}


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ("/G1 X5", "Line 5: Lines with a block delete (/) are read like all others."),
        ("M98 P1000", "Line 5: A subprogram or macro call is ignored."),
        ("G65 P9000 X5 Y6", "Line 5: A subprogram or macro call is ignored."),
        ("G66 P9000 X5 Y6", "Line 5: A subprogram or macro call is ignored."),
        ("#1=[2+3", "Line 5: Lines with variables or expressions are ignored."),
        ("G1 Y[FOO[2]]", "Line 5: Words with variables or expressions are ignored."),
        ("O100 call [1]", "Line 5: A subprogram or macro call is ignored."),
        ("IF R1 == 5 GOTO TOP", "Line 5: Jumps, loops and calls are ignored."),
        ("G68 X0 Y0", "Line 5: G68 is ignored. The coordinates after it are read as if it were not there."),
        ("M0\nG92 X0", "Line 6: G92 is ignored. The coordinates after it are read as if it were not there."),
        ("G5 X10 Y2 P1 Q1", "Line 5: A spline (G5) is read as a line."),
        ("G999", "Line 5: The unknown code 'G999' is ignored."),
        ("WHAT IS THIS?", "Line 5: Lines that do not consist of words like G1 X10 are ignored."),
        ("M30\nG1 X10", "Line 6: Lines after M2, M17 or M30 are read as part of the same program."),
        ("M30\nO2000\nG1 X99", "Line 7: Lines after the end of the program are ignored."),
        ("M99\nG1 X99", "Line 6: Lines after the end of the program are ignored."),
        ("M99 P10\nG1 X9", "Line 5: Jumps, loops and calls are ignored."),
        ("N40 L10 P3", "Line 5: A subprogram or macro call is ignored."),
        ("L0105", "Line 5: A subprogram or macro call is ignored."),
        ("G70 I40. J0 L8", "Line 5: The holes of a pattern (G70) are ignored."),
        ("G71 I4. J0 K5. L8", "Line 5: The holes of a pattern (G71) are ignored."),
        ("G72 I4. J45 L8", "Line 5: The holes of a pattern (G72) are ignored."),
        ("G71 Z1.", "Line 5: The unknown code 'G71' is ignored."),
        ("X10 ,R15.\nY9\nX0 ,R.5", "Line 5 (first of 2): ,R words are ignored."),
        ("X10 , C12\nY9", "Line 5: ,C words are ignored."),
        ("X10 ,A30", "Line 5: ,A words are ignored."),
        ("G55 G0 X9", "Line 5: G55 is ignored. The coordinates after it are read as if it were not there."),
        ("G54\nG54 X9\nG55 X1", "Line 7: G55 is ignored. The coordinates after it are read as if it were not there."),
        ("G54.1 P2", "Line 5: G54.1 is ignored. The coordinates after it are read as if it were not there."),
        (
            "G91 G28 X0 Z0\nG90 X5\nX6",
            "Line 5: Moves to machine positions (G28) are ignored, because the program does not contain these positions.",
        ),
        (
            "G30 P2 X0\nX5",
            "Line 5: Moves to machine positions (G30) are ignored, because the program does not contain these positions.",
        ),
        (
            "G53 G0 Y0\nX5",
            "Line 5: Moves to machine positions (G53) are ignored, because the program does not contain these positions.",
        ),
    ],
)
def test_ignored_word_has_a_remark_with_its_line(line, sentence):
    text = PLAIN + line + "\n"
    assert said(text) == [sentence]
    assert points(text)[: len(POINTS)] == [list(p) for p in POINTS]
    assert all(x <= 10 for x, _, _ in points(text))


def test_work_offset_change_after_a_move_has_a_remark():
    changed = "{1}: {0} is ignored. The coordinates after it are read as if it were not there."
    assert said("G0 G17 G40 G80\nG55\n" + PLAIN + "G55\nX5") == []
    assert said("G54.1 P1\n" + PLAIN + "G54.1 P1\nX5\nG54.1 P2\nX5") == [changed.format("G54.1", "Line 8")]
    assert said("G55 P1\n" + PLAIN + "G55\nG54\nX5\nG55\nX4\nG54") == [
        changed.format("G54", "Line 7 (first of 2)")
    ]  # fmt: skip
    assert said("G0 G17 G40 G80\nG92 X0 Y0\n" + PLAIN) == []


@pytest.mark.parametrize("code", ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"])
def test_work_offset_has_no_remark_before_the_first_move(code):
    other = "G55" if code == "G54" else "G54"
    assert said(code + "\n" + PLAIN + code) == []
    assert said(other + "\n" + PLAIN + code) == [
        f"Line 6: {code} is ignored. The coordinates after it are read as if it were not there."
    ]


def test_percent_sign_after_a_move_ends_the_program():
    for end in ("%", "N30%", "N30 %"):
        assert points(f"%\nG0 X0 Y0 Z5\n{end}\nG1 X9 F60") == [[0, 0, 5]]
        assert read_program(f"{PLAIN}M30\n{end}\n").problems == read_program(f"{PLAIN}M30\n%\n").problems
    # In this program, %1 is a program name, and not an end.
    assert points("G0 X0 Y0 Z5\n%1\nG1 X9 F60") == [[0, 0, 5], [9, 0, 5]]


@pytest.mark.parametrize("line", ["G28 G91 Z0\nG90", "G91 G28 Z0.\nG90", "G53 G0 Z0", "G0 G53 Z-3.", "G30 Z0"])
def test_tool_rises_to_machine_height_over_the_part(line):
    """The machine's height is unknown, so the program's highest Z is used.

    Without the retract, the next rapid would cut.
    """
    path = read_program(f"{PLAIN}{line}\nG0 X40 Y0\nG1 Z-1\nX50\n").toolpath()
    at = np.flatnonzero(path.points[:, 0] == 10)[0]
    assert path.points[at : at + 3].tolist() == [[10, 2, -1], [10, 2, 5], [40, 0, 5]] and path.rapid[at : at + 2].all()
    assert [problem.what.code for problem in path.problems] == ["machine-height"]


def test_machine_positions_at_start_or_end_have_no_remark():
    assert said("G91 G28 Z0\nG90\n" + PLAIN + "G28 Z0\nM5\nG53 G0 Z0\nG28\nM30") == []


@pytest.mark.parametrize("code", ["G28", "G30"])
def test_g28_without_axes_has_the_remark_of_g28_with_an_axis(code):
    text = f"{PLAIN}{code}\nG0 X40 Y0\nG1 Z-1\nX50\n"
    assert said(text) == [
        f"Line 5: Moves to machine positions ({code}) are ignored, because the program does not contain these positions."
    ]
    assert [10, 2, 5] in points(text)


def test_block_delete_after_a_line_number_is_read():
    text = "N1 G21 G90\nN2 G0 X0 Y0 Z5\nN3 /G1 Z-1 F60\n/N4 G1 X10\nN5 /2 Y2\n/3 N6 X4"
    assert points(text)[1:] == [[0, 0, -1], [10, 0, -1], [10, 2, -1], [4, 2, -1]]
    assert said(text) == ["Line 3 (first of 4): Lines with a block delete (/) are read like all others."]


def test_siemens_words_equal_standard_words():
    contour = "G0 X0 Y0 Z0\nG1 X30 F100\nG2 X30 Y20 {}10\nG3 X30 Y0 {}-15\nG1 {} {}"
    siemens, other = (
        read_program(contour.format("CR=", "CR = ", "X=-7.5", "Y=.5")),
        read_program(contour.format("R", "R", "X-7.5", "Y.5")),
    )
    assert siemens.toolpath().points.tolist() == other.toolpath().points.tolist()
    assert siemens.problems == other.problems == ()


def test_move_with_corner_words_of_fanuc_is_read():
    assert points(PLAIN + "X10. ,R5.\nY9. ,C2.") == [list(p) for p in POINTS] + [[10, 9, -1]]


def test_tool_length_in_g43_axis_words_moves_nothing():
    assert points(PLAIN + "G43.1 Z-2.5\nX5") == [list(p) for p in POINTS] + [[5, 2, -1]]
    assert points(PLAIN + "G43.1 H1 Z7")[-1] == [10, 2, 7]


@pytest.mark.parametrize("line", ["G70 I40. J0 L8", "G71 I4. J0 K5. L8", "G72 I4. J45 L8", "G71 Z1."])
def test_hole_pattern_codes_g70_and_g71_do_not_set_the_unit(line):
    program = read_program("G0 X0 Y0 Z5\nG81 Z-1 R1 F60 L0\n" + line + "\nX10\nG80\n")
    assert not program.unit_told and program.toolpath().points.max() == 10


@pytest.mark.parametrize("call", ["M198 P1000", "G66 P1000 A1", "N5 g66p1000"])
def test_uncalled_subprogram_before_the_main_program_is_skipped(call):
    subprogram = "O1000 (HOLE)\nG91 G20 G55 G1 X99 F9\n/M99\nX99\n(P1000)\n{}\n"
    for end in ("M99", "M99 P7", ""):
        text = "%\n" + subprogram.format(end) + "%\nO0001\n" + PLAIN + call + "\nX5\nM30\n%\n"
        assert points(text) == [list(p) for p in POINTS] + [[5, 2, -1]]
        assert said(text) == ["Line 2 (first of 2): A subprogram or macro call is ignored."]


def test_main_program_ends_at_m99():
    text = "O1000 (M98 P1000)\n" + PLAIN + "M99\nO2\nG1 X99\nM30"
    assert points(text) == [list(p) for p in POINTS]
    assert said(text) == ["Line 8: Lines after the end of the program are ignored."]


def test_block_called_by_m97_after_the_program_end_is_read():
    text = PLAIN + "M97 P1000 L3\nX5\nM97 P2000\nM30\n(HOLE)\nN1000 G91\nG1 X9 F9\nG90 M99\nN2000 X99\nM99"
    assert points(text) == [list(p) for p in POINTS] + [[x, 2, -1] for x in (19, 28, 37, 5, 99)]
    assert said(text) == []
    assert said(text + "\nN3000 X3\nM99") == ["Line 15: Lines after the end of the program are ignored."]


HEIDENHAIN = (
    "%PART G71 *\nN10 G30 G17 X+0 Y+0 Z-20 *\nN20 G31 G90 X+99 Y+99 Z+0 *\nN30 G99 T1 L+0 R+4 *\nN40 T1 G17 S5000 *\n"
    "N50 G00 G40 G90 X+0 Y+50 Z+5 *\nN60 G01 Z-1 F60 *\n{}\nN90 G00 Z+5 M2 *\nN99999999 %PART G71 *\n"
)


def test_heidenhain_iso_program_is_read():
    text = HEIDENHAIN.format("N70 X+50 M99 *")
    assert points(text) == [[0, 50, 5], [0, 50, -1], [50, 50, -1], [50, 50, 5]] and said(text) == []
    # The asterisk at the end of a block is not part of the number.
    assert points(text.replace(" *", "*")) == points(text)
    program = read_program(text)
    assert program.unit_told and not program.inches
    inches = read_program(text.replace("G71", "G70"))
    assert inches.inches and inches.toolpath().points[-1].tolist() == [1270, 1270, 127]


@pytest.mark.parametrize(
    "arc",
    [
        "I+50 J+50 *\nG02 X+100 *",
        "G02 I+50 J+50 X+100 *",
        "I+50 *\nJ+50 *\nG01 X+0 *\nG02 X+100 Y+50 *",
        "G02 X+100 R+50 *",
    ],
)
def test_heidenhain_arc_centres_are_modal_coordinates(arc):
    path = read_program(HEIDENHAIN.format(arc + "\nG02 X+0 R+80 *")).toolpath()
    assert path.sweep.sum() == pytest.approx(-np.pi - 2 * np.arcsin(50 / 80)) and path.problems == ()
    assert path.points[:, 1].max() == pytest.approx(100, abs=0.1)


def test_ignored_heidenhain_words_have_a_remark():
    for line, sentence in (
        ("N70 G54 *", "Line 8: The unknown code 'G54' is ignored."), ("N70 G11 R+5 H+0 *", "Line 8: The unknown code 'G11' is ignored."),
        ("N70 G73 G90 H+20 *", "Line 8: The unknown code 'G73' is ignored."),
        ("N70 G91 I+5 *", "Line 8: I words are ignored."),
    ):  # fmt: skip
        text = HEIDENHAIN.format(line + "\nG90 X+0 *")
        assert said(text) == [sentence] and len(points(text)) == 3
    path = read_program(HEIDENHAIN.format("I+50 J+50 *\nG91 I+5 *\nG90 G02 X+100 *")).toolpath()
    assert [problem.what.code for problem in path.problems] == ["word-not-read", "arc-as-line"]


def test_move_in_the_line_of_m30_has_no_remark():
    assert said(PLAIN + "G0 Z5 M30") == []


def test_m99_with_block_delete_does_not_end_the_program():
    text = PLAIN + "/M99\nX5\nM99 P10\nX6"
    assert points(text)[-2:] == [[5, 2, -1], [6, 2, -1]]
    assert said(text)[1:] == ["Line 5 (first of 2): Jumps, loops and calls are ignored."]


def test_subprogram_definition_is_not_executed():
    text = "O<hole> sub\nG1 X99 Y#1\nO<hole> endsub\n" + PLAIN
    assert points(text) == [list(p) for p in POINTS] and said(text) == []


def test_equal_problems_are_one_problem_with_a_count():
    assert said(PLAIN + "#1=[[1]\n#2=FOO[1]\n") == [
        "Line 5 (first of 2): Lines with variables or expressions are ignored."
    ]


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("0 BEGIN PGM PART MM\n1 BLK FORM 0.1 Z X+0\n2 TOOL CALL 1 Z S2000\n3 L X+10 Y+5 R0 FMAX\n", "Line 1: The program is written for Heidenhain controls"),
        ("N10 G0 X0 Y0\nN20 CYCLE84(10,0,2,-5)\n", "Line 2: The program is written for Siemens controls"),
        ("G0 X0\nG1 X=R1 Y20\n", "Line 2: The program is written for Siemens controls"),
        ("G0 X0\nN20 R10=5\n", "Line 2: The program is written for Siemens controls"),
        ("G0 X0\nX9 CHF = 2\n", "Line 2: The program is written for Siemens controls"),
        ("G0 X0\nG1 AP=30 RP=20\n", "Line 2: The program is written for Siemens controls"),
        ("DEF REAL DEPTH\nG0 X0\n", "Line 1: The program is written for Siemens controls"),
        ("solid cube\nfacet normal 0 0 1\nouter loop\n", "This is not an NC program. 3 of its 3 lines do not consist of words"),
        ("Dear Sir,\nplease find enclosed\nthe drawing\n", "This is not an NC program."),
        ("", "This is not an NC program. None of its lines moves a tool."),
        ("G21\nG90\nM30\n", "This is not an NC program. None of its lines moves a tool."),
        ("#1=[2+3]\nG65 P9000\n", "None of the moves can be read. Line"),
        ("#1=[2+3]\nG1 X#5221 Y[#1*2] F200\n", "None of the moves can be read. Line 2"),
        ("O1 sub\nG1 X5 F200\nO1 endsub\n", "None of the moves can be read. Line 1"),
    ],
)  # fmt: skip
def test_text_that_is_not_a_milling_program_is_refused(text, sentence):
    with pytest.raises(Unusable, match=r"^[A-Z].*\.$") as error:
        read_program(text)
    assert sentence in str(error.value)


def test_text_is_a_program_if_half_of_its_lines_are_words():
    assert len(read_program("what\nG0 X0 Y0 Z0\nG1 X5 F60").toolpath()) == 1
    with pytest.raises(Unusable, match="do not consist of words"):
        read_program("what\nis\nthis\nG0 X0 Y0 Z0\nG1 X5 F60")
    assert len(read_program("what\nis\nG0 X0 Y0 Z0\nG1 X5 F60\nG1 X6").toolpath()) == 2


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("G18\nG0 X50 Z2\nG1 Z-20 F.2", "Line 1: G18 shows a program for a lathe."),
        ("G0 X50 Z2\nG71 P10 Q20 U.5 W.1\nN10 G1 X20\nN20 Z-30", "Line 2: G71 shows a program for a lathe."),
        ("G0 X50 Z2\nG72 P10 Q20 U.5 W.1\nN10 G1 X20\nN20 Z-30", "Line 2: G72 shows a program for a lathe."),
        ("G0 X50 Z2\nG76 P10 Q20\nG1 Z-30", "Line 2: G76 shows a program for a lathe."),
        ("G7\nG0 X50 Z2\nG1 Z-20 F.2", "Line 1: G7 shows a program for a lathe."),
        ("G0 X50 Z2\nG8\nG1 Z-20 F.2", "Line 2: G8 shows a program for a lathe."),
        ("G0 X50 Z2\nG96 S200 M3\nG1 Z-20 F.2", "Line 2: G96 shows a program for a lathe."),
        ("G21\nT0202\nG0 X50 Z2\nG1 Z-20 F100", "Line 2: T0202 shows a program for a lathe."),
        ("G21 G97\nG0 X52 Z2\nG90 X48 Z-20 F0.2\nX44", "Line 3: G90 shows a program for a lathe."),
        ("G20\nG0 X2 Z.1\nG90 X1.8 Z-1 F.008\nX1.6", "Line 3: G90 shows a program for a lathe."),
        ("G0 X52 Z2 G99\nG1 X48\nF0.2\nZ-20", "Line 1: G99 shows a program for a lathe."),
        ("G18 T1 M6\nG0 X50 Z2\nG1 Z-20 F.2", "Line 1: G18 shows a program for a lathe."),
        (
            "G99 G18\nG50 S4000\nG0 X50 Y0 Z2\nG96 S200 M3\nG1 Z-20 F.2\nG91 Y0",
            "Line 4: G96 shows a program for a lathe.",
        ),
        ("G0 X50 Z1\nG1 Z0 F.1\nG3 X52 Z-1 I0 K-1", "Line 3: K shows a program for a lathe."),
        ("G0 X50 Z1\nG1 Z0 F.1\nG3 X52 Z-1 R1", "Line 3: R shows a program for a lathe."),
        ("M104 S200\nG1 X5 Y5 Z.2 F600\nG1 X9 E1", "Line 1: M104 shows a program for a 3D printer."),
        (
            "G1 X0 Z0 F600\n" + "".join(f"X{i} E{i}\n" for i in range(1, 12)),
            "Line 2: E shows a program for a 3D printer.",
        ),
        ("G1 X0 Y0 U0 V0 F100\nG1 X10 Y1 U10 V2", "Line 1: U, V shows a program for a wire cutter."),
    ],
)
def test_program_for_another_machine_has_a_message(text, sentence):
    assert render(read_program(text).other).startswith(sentence)


@pytest.mark.parametrize("line", ["G18 G2 X5 Z0 R10", "G96 S100", "G8 P1", "G76 X5 Y5 Z-3 R1 Q.1", "E5 (a slip)"])
def test_milling_program_is_not_another_machines_program(line):
    assert read_program(PLAIN + line).other is None


@pytest.mark.parametrize(
    "line",
    [
        "G61 P1",
        "G64 P.01 Q.01",
        "G9 X5",
        "".join(f"X{i} A{i}\n" for i in range(1, 13)),
        "G43 H1 Z9\nG18 G2 X20 Z-1 R5",
        "T101 M6",
        "T1 M6\nT105",
        "G99 G81 Z-1 R1 F1.5\nG80",
        "G90 X48 Z-20 F20",
        "G90 G1 X4 Z-2 F.2",
        "G99\nG0 X9 F.2",
        "G99\nG98 G1 X9 F.2",
        "G95 G99 G1 X9 F.2",
        "G90 X4 F.2",
        "Y0\nG18 G2 X20 Z-1 R5",
        "Y0\nG3 I5 Z-3 K1",
        "G3 I5 Z-3",
    ],
)
def test_program_without_y_moves_is_not_a_lathe_program(line):
    assert read_program("G0 X0 Z5\nG1 Z-1 F60\nX10\n" + line).other is None


def test_rotary_axis_that_moves_while_cutting_is_found():
    assert read_program("G0 X0 Y0 Z5 A0\nG1 Z-1 F100\nX10 A0\nX20 A5\nX30 A10").rotary == (4, 5)
    assert read_program("G0 X0 Y0 Z5 A0\nG1 X10 Z-1 F100\nG0 Z5\nG0 A90\nG1 Z-1\nX20").rotary == ()


@given(st.text(alphabet="GXYZIJKRFMTSNOPQLDHABCUVE0123456789.+-()[]#=/;%<> \n\r\t", max_size=200))
def test_random_text_is_read_or_refused_with_a_message(text):
    try:
        path = read_program(PLAIN + text).toolpath()
    except ValueError as error:
        assert str(error)
    else:
        assert np.isfinite(path.points).all() and np.isfinite(path.feed).all()


@given(st.binary(max_size=200))
def test_random_bytes_are_read_or_refused_with_a_message(data):
    try:
        read_program(data.decode("latin-1"))
    except ValueError as error:
        assert str(error)


@pytest.mark.parametrize(
    "word", ["G-1E999", "G1E999", "T-1E999", "T1E999 M6", "G91 G81 X1 Z-1 R1 L1E999", "L-1E999", "X1E999", "S-1E999"]
)
def test_numbers_out_of_range_give_finite_paths(word):
    assert np.isfinite(read_program(f"{PLAIN}{word}\nX5\n").toolpath().points).all()


@pytest.mark.parametrize("line", ["X1E5", "(", "1", "O[", "X[", "N1 {}!", "/"])
def test_reading_time_is_linear_in_line_length(line):
    def seconds(length):
        taken = []
        long = line.format(" " * length) if "{}" in line else line * (length // len(line))
        for _ in range(3):
            begin = process_time()
            with suppress(ValueError):
                read_program(PLAIN + long)
            taken.append(process_time() - begin)
        return min(taken)

    assert seconds(40_000) < 3 * 8 * seconds(5_000)


# Start, end and centre of two rounded corners of a square around (200, 200).
CORNERS = [((220, 210), (210, 220), (210, 210)), ((190, 220), (180, 210), (190, 210))]


def rounded(absolute, said=""):
    """Return the toolpath of rounded corners whose centres are coordinates or offsets.

    `said` is a comment that can state whether centres are coordinates or offsets.
    """
    lines = [f"G90 {said}", "G0 X220 Y200 Z0", "F600"]
    for (x, y), (to_x, to_y), (i, j) in CORNERS:
        lines += [f"G1 X{x} Y{y}", f"G3 X{to_x} Y{to_y} " + (f"I{i} J{j}" if absolute else f"I{i - x} J{j - y}")]
    return read_program("\n".join(lines)).toolpath()


def test_absolute_arc_centres_are_read_with_a_remark():
    offsets, coordinates = rounded(absolute=False), rounded(absolute=True)
    assert np.allclose(offsets.points, coordinates.points) and not offsets.problems
    (problem,) = coordinates.problems
    assert (problem.what, problem.command) == (Message("absolute-centres"), 5)


@pytest.mark.parametrize(("absolute", "said"), [(True, "G91.1"), (False, "G90.1")])
def test_g90_1_and_g91_1_decide_how_arc_centres_are_read(absolute, said):
    assert [problem.what.code for problem in rounded(absolute, said).problems] == ["arc-of-changing-radius"]
    assert not rounded(not absolute, said).problems


def test_one_wrong_arc_does_not_make_centres_coordinates():
    good = "G2 X20 Y0 I10 J0\nG2 X0 Y0 I-10 J0\n"
    path = read_program(f"G0 X0 Y0 Z0\nF600\n{good}G2 X10 Y10 I10 J0\nG0 X0 Y0\n{good}").toolpath()
    assert not path.problems
    path = read_program(f"G0 X0 Y0 Z0\nF600\n{good}G2 X7 Y3 I7 J1\nG0 X0 Y0\n{good}").toolpath()
    assert [problem.what.code for problem in path.problems] == ["arc-of-changing-radius"]


@pytest.mark.parametrize("code", ["G8", "G92.1", "G92.2", "G92.3", "G96 S100", "G43.1 H1", "G49"])
def test_move_beside_a_code_without_axis_words_is_read(code):
    assert points(PLAIN + f"G1 X5 Y4 {code}")[-1] == [5, 4, -1]


@pytest.mark.parametrize("code", ["G28.1", "G30.1"])
def test_axis_words_beside_g28_1_are_named_in_a_remark(code):
    """Mach3 homes the axes, and LinuxCNC moves the tool to the axis words."""
    assert said(PLAIN + f"G1 X5 Y4 {code}") == [
        f"Line 5: The unknown code '{code}' is ignored, and the X, Y words of its line with it."
    ]


def test_g43_1_with_a_length_moves_only_beside_a_motion_code():
    assert points(PLAIN + "G43.1 Z2\nX5 Z-1")[-1] == [5, 2, -1]
    assert points(PLAIN + "G1 X5 G43.1 Z2")[-1] == [5, 2, 2]


def test_axis_words_of_g92_1_have_a_remark_in_fanuc_programs():
    path = read_program("O1000\n" + PLAIN + "G92.1 X0 Y0\nX5").toolpath()
    assert [problem.what.code for problem in path.problems] == ["coordinates-not-changed"]
    assert path.points[-1].tolist() == [5, 2, -1]


def test_turning_cycle_in_a_program_for_a_mill_has_a_remark():
    path = read_program(PLAIN + "Y9\nG71 P10 Q20 U1\nX5").toolpath()
    assert [problem.what.code for problem in path.problems] == ["unknown-code"]
