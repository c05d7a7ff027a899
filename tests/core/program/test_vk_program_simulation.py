# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC programs are simulated with numpy only: facts, verdict on the job, picture and solid, by macro or command."""

import subprocess
import sys
from pathlib import Path

import pytest

import vkworkbench
from vkworkbench.core import Stock, Tool
from vkworkbench.language import Unusable
from vkworkbench.program import main

ROOT = Path(__file__).resolve().parents[3]
PROGRAM = """(T1 D=6. CR=0. - flat end mill)
(T2 D=3. - ball end mill)
G21
(Pocket)
T1 M6
G0 X0 Y0 Z5
G1 Z-2 F600
G1 X40
G1 Y20
G1 X0
G1 Y0
G0 X20 Y10
G0 Z5
(Engrave)
T2 M6
G0 X5 Y5
G1 Z-1 F100
X30 Y15
G0 Z5
M30
"""
CRASH = 12  # Number of the program line with the rapid that cuts into the floor.


@pytest.fixture
def program(tmp_path):
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM)
    return path


@pytest.mark.long
def test_crash_has_the_number_of_its_program_line(program):
    done = vkworkbench.simulate(program)
    found = done.facts()
    assert [label for label, _ in found.operations] == ["Pocket", "Engrave"]
    (crash,) = found.job.crashes
    assert crash.source.command == CRASH and "1 rapid cuts into material." in str(found)
    assert found.operations[1][1].removed_volume > 0
    assert not done.at(0).zbuffer.chip_volume and done.zbuffer.chip_volume > 0


@pytest.mark.parametrize(
    "unit, sizes", [("G21", "flute length 3, shank 8 mm, stick-out=20"), ("G20", "LOC=.118, shank dia .315, OAL: .787")]
)
def test_flutes_and_shank_in_a_comment_are_checked(tmp_path, unit, sizes):
    """The flutes are 3 mm long, and the shank is wider than the flutes. The slot is 5 mm deep."""
    inch = 25.4 if unit == "G20" else 1.0
    words = [("G0", "Z", 5), ("G1", "Z", -5), ("G1", "X", 40), ("G0", "Z", 5)]
    moves = "".join(f"{code} {axis}{at / inch:.4f}\n" for code, axis, at in words)
    path = tmp_path / "slot.nc"
    path.write_text(f"(T1 D={6 / inch:.4f} end mill, {sizes})\n{unit} F10\nT1 M6\nG0 X0 Y0\n{moves}M30\n")
    found = vkworkbench.simulate(path, stock=Stock((-10, -10, -20), (50, 10, 0))).facts()
    collisions = [(one.body, one.source.command, round(one.depth, 1)) for one in found.job.collisions]
    assert collisions == [("shank", 6, 2.0), ("flutes", 7, 2.0)]


@pytest.mark.long
def test_stock_of_a_program_is_a_box_around_its_cuts(program):
    """Z0 is the upper face: the cuts are below Z0, and most rapids are above."""
    done = vkworkbench.simulate(program)
    assert done.stock.lower[:2].tolist() == [-3, -3] and done.stock.upper.tolist() == [43, 23, 0]
    assert "a box around the cuts" in str(done.facts())
    given = vkworkbench.simulate(program, stock=Stock((-10, -10, -10), (50, 30, 2)))
    assert given.stock.upper[2] == 2 and "box around" not in str(given.facts())


@pytest.mark.parametrize(
    "words, top", [("G0 X9\nG1 Z3 F9\nX20\nG0 Z9\nX0", 3), ("G0 Z-5 X9\nG1 Z-30 F9\nX20\nG0 Z-5\nX0", -30)]
)
def test_stock_box_ends_at_the_highest_cut_if_z0_is_elsewhere(tmp_path, words, top):
    path = tmp_path / "part.nc"
    path.write_text(f"G21 (zero elsewhere)\nG0 Z9 X0 Y0\n{words}\nM30\n" if top > 0 else f"G21\n{words}\nM30\n")
    assert vkworkbench.simulate(path, tool=Tool("endmill", 6)).stock.upper[2] == top


@pytest.mark.long
def test_tools_are_given_by_number_or_for_all_operations(program):
    wide = Tool("endmill", 10, cutting_edge_height=1, shank_diameter=10)
    by_number = vkworkbench.simulate(program, tool={1: wide})
    assert [cut.tool.diameter for cut in by_number.program.cuts] == [10, 3]
    assert [one.body for one in by_number.facts().job.collisions] == ["flutes"]
    assert [cut.tool.diameter for cut in vkworkbench.simulate(program, tool=wide).program.cuts] == [10, 10]


def test_operation_without_tool_is_left_out_and_named(tmp_path):
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM.replace("(T2 D=3. - ball end mill)\n", ""))
    done = vkworkbench.simulate(path)
    assert done.program.labels == ("Pocket",)
    assert "Engrave from line 13 on is not simulated" in str(done.facts())
    path.write_text("G21\nG0 Z5\nG1 X40 Z-2 F600\n")
    with pytest.raises(Unusable, match="its tool is unknown"):
        vkworkbench.simulate(path)
    assert vkworkbench.simulate(path, tool=Tool("endmill", 6)).facts().job.removed_volume > 0


def test_program_in_inches_is_simulated_in_its_true_size(tmp_path):
    path = tmp_path / "part.nc"
    path.write_text("(T1 1/4 ENDMILL DIA 0.25)\nT1 M6\nG0 X0 Y0 Z0.2\nG1 Z-0.05 F10\nX1.5\nY0.75\nX0\nY0\nG0 Z0.2\n")
    done = vkworkbench.simulate(path)
    assert done.program.cuts[0].tool.diameter == pytest.approx(6.35)
    assert done.stock.upper[0] - done.stock.lower[0] == pytest.approx(1.5 * 25.4 + 6.35)
    assert "looks like inches" in str(done.facts())


@pytest.mark.long
def test_picture_and_solid_are_saved(program, tmp_path):
    done = vkworkbench.simulate(program, view="Isometric")
    done.save_png(tmp_path / "part.png")
    done.save_stl(tmp_path / "part.stl")
    assert (tmp_path / "part.png").read_bytes().startswith(b"\x89PNG") and (tmp_path / "part.stl").stat().st_size > 1000
    with pytest.raises(ValueError, match="direction 'Sideways'"):
        vkworkbench.simulate(program, view="Sideways")
    with pytest.raises(TypeError, match="tool is a Tool"):
        vkworkbench.simulate(program, tool=6)


def run(*arguments):
    return subprocess.run(
        [sys.executable, "-m", "vkworkbench", *map(str, arguments)],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip


def test_simulate_command_prints_facts_and_saves_files(program, tmp_path):
    done = run(
        program,
        "--simulate",
        "--stock",
        "-10,-10,-10,50,30,0",
        "--png",
        tmp_path / "a.png",
        "--stl",
        tmp_path / "a.stl",
    )
    assert done.returncode == 0 and not done.stderr
    assert f"Pocket, line {CRASH}: A rapid move removes" in done.stdout and "Engrave" in done.stdout
    assert (tmp_path / "a.png").exists() and (tmp_path / "a.stl").exists()


@pytest.mark.parametrize(
    "options, why",
    [
        (["--png", "a.png"], "--png needs --simulate"),
        (["--simulate", "--png", "a.jpg"], "must end with .png"),
        (["--simulate", "--csv", "a.csv"], "leave out --csv"),
        (["--simulate", "--stock", "1,2,3"], "it takes six numbers of mm"),
        (["--simulate", "--stl", "/nowhere/a.stl"], "cannot write /nowhere/a.stl"),
    ],
)
def test_impossible_options_of_the_simulation_are_refused(program, options, why, capsys):
    try:
        assert main([str(program), *options]) == 2
    except SystemExit as end:
        assert end.code == 2
    assert why in capsys.readouterr().err


@pytest.mark.long
@pytest.mark.parametrize(
    "text, stock, told",
    [
        ("G0 X0 Y0 Z5\nG0 X10\n", None, "The toolpath has no cutting move."),
        ("G1 X40 Z-2 F600\n", "100,100,-9,200,200,0", "no tool meets the stock. Check the stock and its position."),
        ("G1 X40 Z-2 F600\n", None, "Not everything could be checked: No stock is given."),
    ],
)
def test_simulate_command_says_what_it_cannot_check(tmp_path, capsys, text, stock, told):
    path = tmp_path / "part.nc"
    path.write_text("(T1 D=6. CR=0. - flat end mill)\nG21\nT1 M6\nG0 X0 Y0 Z5\n" + text)
    main([str(path), "--simulate", *([f"--stock={stock}"] if stock else [])])
    out = capsys.readouterr().out
    assert told in out and ("error, cm3" in out) is ("G1" in text)


def test_missing_program_has_an_error_message(tmp_path, capsys):
    assert main([str(tmp_path / "none.nc"), "--simulate"]) == 1
    assert "The file cannot be read: No such file or directory." in capsys.readouterr().out


def test_program_without_tool_is_not_simulated(tmp_path, capsys):
    (tmp_path / "a.nc").write_text("G21\nG0 Z5\nG1 X40 Z-2 F600\n")
    assert main([str(tmp_path / "a.nc"), "--simulate"]) == 1
    assert "its tool is unknown" in capsys.readouterr().out
