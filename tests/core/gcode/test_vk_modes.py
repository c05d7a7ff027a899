# SPDX-License-Identifier: LGPL-2.1-or-later
"""Modal state of programs: M70 to M73 save and restore modes, and feed rates are read in all lines."""

import pytest

from vkworkbench.core.gcode import read_program

BEGIN = "G21 G90 G98\nG0 X0 Y0 Z5\nG1 Z-1 F100\n"


def path_of(text):
    return read_program(BEGIN + text).toolpath()


def end(text):
    return path_of(text).points[-1].round(6).tolist()


def feed(text):
    return round(path_of(text).feed[-1] * 60, 6)


@pytest.mark.parametrize(
    ("inside", "move", "place"),
    [
        ("G20\nG1 X1", "G1 X2", [2, 0, -1]),
        ("G91\nG1 X1", "G1 X2", [2, 0, -1]),
        ("G18", "G2 X10 Y0 I5", [10, 0, -1]),
        ("G90.1", "G3 X10 Y0 I5 J0", [10, 0, -1]),
        ("G99", "G81 X3 Y3 Z-4 R1\nG80", [3, 3, 5]),
        ("G20 G91 G18 G90.1 G99", "G1 X7", [7, 0, -1]),
    ],
)
def test_modes_saved_by_m70_are_restored_by_m72(inside, move, place):
    if move.startswith("G81"):
        move = "G0 Z5\n" + move
    assert end(f"M70\n{inside}\nM72\n{move}") == place
    assert not path_of(f"M70\n{inside}\nM72\n{move}").problems


def test_feed_rates_saved_by_m70_are_restored():
    assert feed("M70\nF250\nM72\nG1 X2") == 100
    assert feed("M70\nG20\nG1 X1 F9\nM72\nG1 X2") == 100
    assert feed("M70\nG95\nS1000\nF.1\nM72\nG1 X2") == 100
    assert feed("M70\nG93\nG1 X9 F2\nM72\nG1 X2") == 100


def test_modes_deleted_by_m71_are_not_restored():
    assert end("M70\nG91\nM71\nM72\nG1 X2\nX2") == [4, 0, -1]
    assert end("M72\nG1 X2\nX2") == [2, 0, -1]


def test_m73_restores_modes_at_the_end_of_a_subprogram():
    called = "M98 P7\nG1 X2\nM30\nO7\n{}\nG20 G91\nG1 X1\nM99"
    assert end(called.format("M73")) == [2, 0, -1]
    assert end(called.format("M70")) == [76.2, 0, -1]


def test_work_offset_saved_by_m70_is_restored():
    assert end("G10 L20 P1 X0 Y0\nG10 L20 P2 X-100 Y0\nM70\nG55\nM72\nG1 X2") == [2, 0, -1]


@pytest.mark.parametrize(
    "line", ["G4 P1 F200", "G31 Z-2 F200", "G38.2 Z-2 F200", "G43.1 Z1 F200", "G52 X0 F200", "G53 G0 Z0 F200",
             "G92 X0 F200", "G10 L2 P2 X0 F200", "G28.1 F200"]
)  # fmt: skip
def test_feed_rate_is_read_in_lines_of_codes_without_a_move(line):
    assert feed(f"{line}\nG1 X9 Z-1") == 200


@pytest.mark.parametrize("line, x", [("G1 X5 G4 P0.5", 5), ("G4 P0.5 X5", 5), ("G4 X5", 1), ("G4 U5", 1)])
def test_axis_word_beside_a_dwell_moves_unless_it_is_the_time(line, x):
    assert end(f"G1 X1\n{line}")[0] == x


def test_duration_of_a_dwell_is_not_a_feed_rate():
    assert feed("G4 F2\nG1 X9") == 100
    assert feed("G777 X5 F90\nG1 X9") == 100


def test_probing_moves_the_tool_to_its_target():
    path = path_of("G38.2 X8 F50\nG91\nG0 Z9\nG90\nG1 X9")
    assert path.points[2:].tolist() == [[8, 0, -1], [8, 0, 8], [9, 0, 8]]
    assert path.rapid.tolist() == [False, True, True, False]
    assert [problem.what.code for problem in path.problems] == ["probing-as-rapid"]
    assert end("G31 X8\nX3") == [3, 0, -1]  # G31 applies to one line only, so the next line cuts.


def test_feed_rate_next_to_a_unit_change_has_a_remark():
    path = path_of("G20 G1 X1 F9\nX2 F9")
    assert [problem.what.code for problem in path.problems] == ["feed-in-old-unit"]
    assert path.feed[-2:].tolist() == pytest.approx([9 / 60, 9 * 25.4 / 60])
    assert not path_of("G21 G1 X1 F9").problems
    fanuc = read_program("O1000\nG21\nG0 X0 Y0 Z0\nG20 G1 X1 F9").toolpath()
    assert fanuc.feed[-1] == pytest.approx(9 * 25.4 / 60) and not fanuc.problems


@pytest.mark.parametrize("code", ["M19 R90", "M3 S100 R5", "M4 R5 P1"])
def test_r_word_of_a_spindle_code_is_not_the_r_plane_of_a_cycle(code):
    holes = f"G0 Z5\nG81 X1 Y1 Z-4 R1\n{code}\nX9\nG80"
    assert path_of(holes).points.tolist() == path_of("G0 Z5\nG81 X1 Y1 Z-4 R1\nX9\nG80").points.tolist()


def test_g70_of_siemens_does_not_scale_feed_rates():
    begin = "{}\nG0 X0 Y0 Z1\nG{} G1 X2 F254\n"
    assert read_program(begin.format("G64 G601", 70)).toolpath().feed[-1] * 60 == pytest.approx(254)
    assert read_program(begin.format("G64 G601", 700)).toolpath().feed[-1] * 60 == pytest.approx(254 * 25.4)
    assert read_program(begin.format("G64", 70)).toolpath().feed[-1] * 60 == pytest.approx(254 * 25.4)


def test_raw_freecad_paths_have_feeds_per_second():
    raw = "G0 X0.000000 Y0.000000 Z5.000000\nG1 F10.000000 X0.000000 Y0.000000 Z-1.000000\nG1 F20.000000 X9.000000\n"
    path = read_program(raw).toolpath()
    assert path.feed.tolist() == [10, 20] and path.problems[0].what.code == "feeds-per-second"
    numbered = raw.replace("\nG1", "\n N1 G1").replace("9.000000", "9.000000 (end)")
    for copied in (raw.lower(), raw.replace("\n", "\n\n"), raw.replace("\n", "\r"), numbered):
        assert read_program(copied).toolpath().feed.tolist() == [10, 20]
    for posted in (raw.replace("000000", "000"), raw.replace("F20.000000 X9.000000", "X9.000000 F20.000000")):
        assert read_program(posted).toolpath().feed[-1] == pytest.approx(20 / 60)


@pytest.mark.parametrize("code", ["G92 X1", "G52 X-1", "G10 L20 P1 X1"])
def test_unit_code_applies_to_all_codes_of_its_line(code):
    start = "G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\n"
    first, last = f"G20 {code}", f"{code} G20"
    ends = [read_program(f"{start}{line}\nG21\nX0\n").toolpath().points[-1].tolist() for line in (first, last)]
    assert ends[0] == ends[1] == [pytest.approx(-25.4), 0, -1]


def test_axis_words_of_g10_beside_g92_3_belong_to_g10():
    path = read_program("G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\nG10 L2 P2 X9 G92.3\nY3\n").toolpath()
    assert path.points[-1].tolist() == [0, 3, -1]
