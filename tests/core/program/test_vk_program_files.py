# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC programs in files and folders, and the report on them, without FreeCAD."""

import csv
import gzip
import inspect
import json
import lzma
import os
import pydoc
import re
import subprocess
import sys
import zipfile
from dataclasses import replace
from pathlib import Path

import pytest
from counting import memory

import vkworkbench
from vkworkbench.core import MACHINES
from vkworkbench.language import Unusable, render
from vkworkbench.preferences import Preferences
from vkworkbench.program import analysis, files, is_path
from vkworkbench.program.analysis import analyze_file
from vkworkbench.program.files import find_programs, read_bytes, text_of

ROWS = "".join(f"G1 X{40 * (k % 2)}\nY{k + 1}\n" for k in range(20))
PROGRAM = (
    "%\nO1000 (BRACKET)\n(T1 D=6. CR=0. - ZMIN=-1. - flat end mill)\nG21 G90\n(Face)\nT1 M6\n"
    f"G0 X0 Y0 Z5\nG1 Z-1 F600\n{ROWS}G0 Z5\n(Holes)\nT2 M6\nG81 X5 Y5 Z-4 R2 F100\nX15\nX25\nX35\nX45\nG80\nM30\n%\n"
)


@pytest.mark.parametrize(
    ("data", "text"),
    [
        ("Fräsen".encode(), "Fräsen"),
        ("Fräsen G1".encode("cp1252"), "Fräsen G1"),
        ("Контур".encode("cp1251"), "Контур"),
        ("Контур".encode(), "Контур"),
        ("G1 X1 (ü)".encode("utf-16"), "G1 X1 (ü)"),
        (b"\xfe\xff" + "G1 X1".encode("utf-16-be"), "G1 X1"),
        (b"\xef\xbb\xbfG1", "G1"),
        (b"\0\0\0\0%\r\nG1\r\n%\r\n\x1a", "%\r\nG1\r\n%\r\n"),
        (b"G1 X1\n" * 50 + b"\x07", "G1 X1\n" * 50 + "\x07"),  # The text ends with a stray control character.
        # The text was captured from a serial line.
        (b"\x12%\r\n\0\0\0G1 X1\0\r\n\x13\x11G1\r\n%\r\n\x14", "%\r\nG1 X1\r\nG1\r\n%\r\n"),
        (101 * b"\0" + 30 * b"\x7f" + b"G1", "G1"),
        ("G1 X1 (ü)\r\n".encode("utf-16-le"), "G1 X1 (ü)\r\n"),
        ("G1 X1 (ü)\r\n".encode("utf-16-be"), "G1 X1 (ü)\r\n"),
        ("G1 X1 (Контур)".encode("utf-16-le"), "G1 X1 (Контур)"),
        # The second half of the text has one more zero byte than the first half.
        ((300 * "G1 " + "(Ā)").encode("utf-16-le"), 300 * "G1 " + "(Ā)"),
        ("G1 X1".encode("utf-16-le") + b"\x1a", "G1 X1"),
    ],
)
def test_files_in_utf8_utf16_and_code_pages_are_read(data, text):
    assert text_of(data) == text


@pytest.mark.parametrize(
    "data", [b"\x7fELF\x02\0\0\0G1 X1", bytes(range(256)) * 4, b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", b"\0\1" * 99]
)
def test_binary_files_are_not_text(data):
    with pytest.raises(Unusable, match="it is not text"):
        text_of(data)


@pytest.mark.parametrize("first, told", [
    ("Document.xml", "a FreeCAD document. Analyze it in FreeCAD"), ("bracket.nc", "a zip archive. Unpack it first"),
])  # fmt: skip
def test_zip_archive_has_an_error_that_says_what_to_do(tmp_path, first, told):
    path = tmp_path / "part.FCStd"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr(first, PROGRAM)
    (row,) = vkworkbench.analyze(path).operations
    assert row.error.startswith(f"This is not an NC program, but {told}")


def test_drawing_is_not_a_program(tmp_path):
    path = tmp_path / "logo.svg"
    path.write_text('<?xml version="1.0"?>\n<svg width="10">\n<path d="M0 0L9 9"/>\n</svg>\n')
    (row,) = vkworkbench.analyze(path).operations
    assert row.error.startswith("This is not an NC program. 4 of its 4 lines do not consist of words")


def test_packed_gz_and_xz_files_are_read(tmp_path):
    for name, module in (("a.nc.gz", gzip), ("a.nc.xz", lzma)):
        path = tmp_path / name
        path.write_bytes(module.compress(b"G1 X1"))
        assert read_bytes(path) == b"G1 X1"
        path.write_bytes(b"not packed")
        with pytest.raises(Unusable, match="cannot be read"):
            read_bytes(path)


def test_packed_file_with_errors_is_refused(tmp_path):
    packed = bytearray(gzip.compress(bytes(range(256)) * 40))
    packed[40:60] = b"\xff" * 20
    (tmp_path / "a.nc.gz").write_bytes(packed)
    with pytest.raises(Unusable, match="cannot be read"):
        read_bytes(tmp_path / "a.nc.gz")


def test_file_that_is_too_large_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(files, "MOST_BYTES", 6)
    path = tmp_path / "a.nc"
    path.write_bytes(b"G1 X10")
    assert read_bytes(path) == b"G1 X10"
    path.write_bytes(b"G1 X100")
    with pytest.raises(Unusable, match="The file is larger than"):
        read_bytes(path)


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_text_with_too_many_lines_is_refused(monkeypatch, end):
    monkeypatch.setattr(files, "MOST_LINES", 3)
    assert text_of(f"X1{end}X2{end}X3{end}X4".encode()).endswith("X4")
    with pytest.raises(Unusable, match=r"^The file has more than 3 lines\.$"):
        text_of(f"X1{end}X2{end}X3{end}X4{end}".encode())


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_text_with_a_too_long_line_is_refused(monkeypatch, end):
    monkeypatch.setattr(files, "LONGEST_LINE", 10)
    assert text_of(f"X12345678{end}".encode() * 9)
    for before in range(12):
        with pytest.raises(Unusable, match="has a line of more than 10 characters"):
            text_of((f"{'X' * before}{end}" + 20 * "/" + f"{end}X1").encode())


def test_pipe_or_device_is_refused(tmp_path):
    os.mkfifo(tmp_path / "pipe.nc")
    (tmp_path / "linked.nc").symlink_to(tmp_path / "pipe.nc")
    for path in (
        tmp_path / "pipe.nc",
        tmp_path / "linked.nc",
        Path("/dev/zero"),
    ):  # reading from a pipe or /dev/zero would never end
        with pytest.raises(Unusable, match=r"^This is not a file, but a pipe or a device\.$"):
            read_bytes(path)
    for path, told in ((tmp_path, "Is a directory"), (tmp_path / "none.nc", "No such file or directory")):
        with pytest.raises(Unusable, match=told):
            read_bytes(path)


def test_linked_folders_are_searched_once(tmp_path):
    for name in ("p/a.nc", "p/q/b.nc", "far/c.nc"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("G1 X1")
    (tmp_path / "p" / "linked").symlink_to(tmp_path / "far")
    (tmp_path / "p" / "q" / "loop").symlink_to(tmp_path / "p")
    (tmp_path / "p" / "z.nc").symlink_to(tmp_path / "gone.nc")
    os.mkfifo(tmp_path / "p" / "pipe.nc")
    p = tmp_path / "p"
    found = list(find_programs([p, p / ".." / "p" / "a.nc", p / "q" / "loop" / "a.nc"], []))
    assert [str(path.relative_to(p)) for path in found] == ["a.nc", "z.nc", "linked/c.nc", "q/b.nc"]


def test_folders_nested_deeper_than_function_calls_are_searched(tmp_path):
    folder = Path(tmp_path, *150 * "d")
    folder.mkdir(parents=True)
    (folder / "a.nc").touch()
    limit = sys.getrecursionlimit()
    sys.setrecursionlimit(len(inspect.stack()) + 100)
    try:
        found = list(find_programs([tmp_path], []))
    finally:
        sys.setrecursionlimit(limit)
    assert found == [folder / "a.nc"]


def test_unreadable_folder_has_a_remark(tmp_path, monkeypatch):
    (tmp_path / "closed").mkdir()
    (tmp_path / "a.nc").write_text(PROGRAM)
    listed = os.listdir

    def refuse(path):
        if Path(path).name == "closed":
            raise PermissionError(13, "Permission denied", str(path))
        return listed(path)

    monkeypatch.setattr(os, "listdir", refuse)
    rows = vkworkbench.analyze(tmp_path).operations
    assert [Path(row.document).name for row in rows] == ["a.nc", "a.nc", "closed"]
    assert rows[-1].error.startswith("The file cannot be read: ") and not rows[-1].counted


def test_programs_are_found_in_folders_by_suffix_and_content(tmp_path):
    for name in ("b.nc", "a.NGC", "c.txt", "d.tap.xz", "sub/e.gcode", ".git/f.nc", "g.nc.txt"):
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text("G1 X1")
    found = [
        str(path.relative_to(tmp_path)) for path in find_programs([tmp_path, tmp_path / "c.txt", tmp_path / "b.nc"], [])
    ]
    assert found == ["a.NGC", "b.nc", "d.tap.xz", "sub/e.gcode", "c.txt"]
    text = tmp_path / "h.txt"
    text.write_text("%\n(part)\nG21 G90\nG0 X0 Y0\nG1 Z-1 F60\n")
    gzip.open(tmp_path / "i.nc.gz.gz", "wb").close()
    left_out = []
    assert text in list(find_programs([tmp_path], left_out))
    assert [path.name for path in left_out] == ["c.txt", "g.nc.txt", "i.nc.gz.gz"]
    lines = tmp_path / "two\nlines.nc"
    lines.write_text("G1 X1")
    assert list(find_programs([lines], [])) == [lines]


@pytest.mark.parametrize("name", ["part", "part.h", "part.txt", "part.nc.bak", "part.XYZ", "part.gz"])
def test_folder_reads_g_code_with_any_suffix(tmp_path, name):
    (tmp_path / name).write_bytes(gzip.compress(PROGRAM.encode()) if name.endswith(".gz") else PROGRAM.encode())
    report = vkworkbench.analyze(tmp_path)
    assert [row.label for row in report] == ["Face", "Holes"] and report.left_out == ()


def test_folder_names_the_files_that_it_leaves_out(tmp_path):
    (tmp_path / "a.nc").write_text(PROGRAM)
    (tmp_path / "b.gz.gz").write_bytes(gzip.compress(gzip.compress(PROGRAM.encode())))
    (tmp_path / "c.png").write_bytes(bytes(range(256)) * 9)
    (tmp_path / "d.h").write_text("int g1, x10;\n" * 9)
    (tmp_path / "e.drl").write_text("M48\nMETRIC\nT1C0.8\n%\nG90\nT1\n" + "X10Y10\n" * 9)
    (tmp_path / "f.gbr").write_text("%FSLAX24Y24*%\nG01*\n" + "X100Y100D02*\n" * 9)
    names = ["b.gz.gz", "c.png", "d.h", "e.drl", "f.gbr"]
    report = vkworkbench.analyze(tmp_path)
    assert report.left_out == tuple(str(tmp_path / name) for name in names)
    sentence = f"Left out, because they do not look like NC programs: {', '.join(report.left_out)}."
    assert str(report).splitlines()[-1] == sentence
    report.to_json(tmp_path / "results")
    assert json.loads((tmp_path / "results").read_text())["left_out"] == list(report.left_out)


def test_folder_names_at_most_20_files_that_it_leaves_out(tmp_path):
    for number in range(23):
        (tmp_path / f"{number:02}.md").touch()
    assert str(vkworkbench.analyze(tmp_path)).startswith("No operations found.\nLeft out, because")
    assert str(vkworkbench.analyze(tmp_path)).endswith("19.md, and 3 more.")


def test_argument_that_is_not_a_file_name_is_refused():
    with pytest.raises(ValueError, match="no file"):
        vkworkbench.analyze("")
    for text in ("G21\nG1 X10 F100\n", "G21\n" * 1000):
        with pytest.raises(ValueError, match="the text of a program is no file: give its path"):
            vkworkbench.analyze(text)
    with pytest.raises(ValueError, match=r"one with backslashes is written r'C:\\new\.nc'"):
        vkworkbench.analyze("C:\new.nc")  # the \n in this path is a line break, because the string is not raw
    assert is_path("a.nc") and is_path(Path("a")) and is_path(["a", Path("b")]) and is_path(("a.nc",))
    assert not is_path(None) and not is_path([]) and not is_path([object()]) and not is_path(object())


class NoFreeCAD:
    """An import hook that makes `import FreeCAD` fail, even if FreeCAD is installed."""

    @staticmethod
    def find_spec(name, *_):
        if name == "FreeCAD":
            raise ModuleNotFoundError(name=name)


@pytest.fixture
def without_freecad(monkeypatch):
    for name in ("FreeCAD", "vkworkbench.document.analysis"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    monkeypatch.setattr(sys, "meta_path", [NoFreeCAD, *sys.meta_path])


def test_report_on_no_files_is_empty(without_freecad):
    for nothing in ([], (), iter([])):
        assert vkworkbench.analyze(nothing).operations == ()


@pytest.mark.parametrize("what", [b"x", b"", 3, None, [3], ["a.nc", None]])
def test_objects_are_refused_without_freecad(without_freecad, what):
    with pytest.raises(TypeError, match=r"^without FreeCAD only NC programs .*: a file, a folder, or a list of them"):
        vkworkbench.analyze(what)
    with pytest.raises(TypeError, match=r"^without FreeCAD only NC programs are simulated: the name of a file$"):
        vkworkbench.simulate(what)


def test_help_needs_no_freecad(without_freecad):
    assert "analyze(what=None" in pydoc.plain(pydoc.render_doc(vkworkbench))
    assert {"analyze", "Report", "Cancelled"} <= set(dir(vkworkbench))


def test_report_has_one_row_for_each_operation(tmp_path):
    path = tmp_path / "bracket.nc"
    path.write_text(PROGRAM)
    asked = []
    report = vkworkbench.analyze(str(path), progress=lambda *step: asked.append(step), cancelled=lambda: False)
    assert asked == [(0, 1, "bracket.nc")]
    face, holes = report.operations
    assert (face.label, face.name, str(face.strategy)) == ("Face", "lines 2-49", "zigzag")
    assert (holes.label, holes.name, str(holes.strategy)) == ("Holes", "lines 50-57", "drilling")
    assert (face.document, face.job, face.counted) == (str(path), "bracket.nc", True)
    assert (face.spans[0].first_command, face.spans[0].last_command) == (8, 48)
    assert face.estimate.traces > 0 and face.resolution is not None and face.error is None
    assert holes.estimate is None and holes.error.startswith("The program does not contain the tool's diameter")
    assert face.length == pytest.approx(6 + 20 + 19 * 40)
    assert face.machining.seconds == pytest.approx(face.length / 10)
    assert face.machining.notes == (
        "The machining time does not include 6 mm of rapids, because a program does not contain their speed.",
    )
    (total,) = report.totals
    assert (total.operations, total.label, total.incomplete) == (2, "bracket.nc", True)
    assert "Face" in str(report) and "bracket.nc: 2 operations" in str(report)
    assert "z-buffer time" in str(report).splitlines()[0]


def test_table_has_names_of_programs_in_subfolders(tmp_path):
    (tmp_path / "old").mkdir()
    for name in ("bracket.nc", "old/bracket.nc"):
        (tmp_path / name).write_text(PROGRAM)
    header, _, *rows, _, first, second = str(vkworkbench.analyze(tmp_path)).splitlines()
    assert header.split()[:2] == ["document", "operation"]
    assert [row.split()[:2] for row in rows] == [
        [name, label] for name in ("bracket.nc", "old/bracket.nc") for label in ("Face", "Holes")
    ]
    assert (first.split()[0], second.split()[0]) == ("bracket.nc", "old/bracket.nc")


def test_one_operation_is_written_in_the_singular(tmp_path):
    path = tmp_path / "face.nc"
    path.write_text(PROGRAM.split("(Holes)", maxsplit=1)[0])
    assert "face.nc: 1 operation " in str(vkworkbench.analyze(str(path)))


def test_dwells_are_in_the_time_of_their_operation(tmp_path):
    path = tmp_path / "laser.nc"
    path.write_text("G21 G90\nF600\n(First)\nG1 X0 Y0 Z0\nX50\nG4 P600\nX0\n(Second)\nX9\n")
    first, second = vkworkbench.analyze(path).operations
    assert [(row.machining.seconds, row.machining.complete) for row in (first, second)] == [(10.6, True), (0.9, True)]
    path.write_text("G21 G90\nF600\nG1 X0 Y0 Z0\nG38.2 Z-5\nX50\n")
    assert not vkworkbench.analyze(path).operations[0].machining.complete


@pytest.mark.parametrize("p", ["9" * 400, "9" * 12, "-1"])
@pytest.mark.parametrize("line", ["G4 P{}", "G82 X9 Y9 Z-4 R2 P{}\nG80"])
def test_impossible_dwell_is_not_in_the_time(tmp_path, p, line):
    path = tmp_path / "dwell.nc"
    path.write_text(f"G21 G90 F600\nG0 X0 Y0 Z5\nG1 Z-1\nX40\n{line.format(p)}\nG1 X0\n")
    report = vkworkbench.analyze(path, machine="hobby-router")
    (row,) = report.operations
    assert row.machining.dwell_seconds == 0 and not row.machining.complete
    assert [m.arguments["what"].code for m in row.machining.left_out if "what" in m.arguments] == ["dwell-untimed"]
    assert ">= " in str(report)


def test_each_operation_with_an_unknown_dwell_has_a_remark(tmp_path):
    """A remark that is not about a dwell is reported once, for the operation in which its cause first occurs."""
    path = tmp_path / "router.nc"
    cut = "G0 Z5\nG4 S1\nG1 Z-1 F600\nX40\nX0\n"
    path.write_text(
        f"G21\nG0 X0 Y0\nG4 S2\n(First)\n{cut}G999\n(Second)\nG0 Z5\nG1 Z-2\nX9\n(Third)\n{cut}G999\nG4 S3\nG4 S4\n"
    )
    rows = vkworkbench.analyze(path).operations

    def told(messages):
        return [
            (at["what"].code, at["line"], at["count"]) for at in (m.arguments for m in messages) if "what" in at
        ]  # fmt: skip

    dwells = [[("dwell-untimed", 3, 2)], [], [("dwell-untimed", 17, 3)]]
    assert [told(row.machining.left_out) for row in rows] == dwells
    assert [sorted(told(row.remarks)) for row in rows] == [[*dwells[0], ("unknown-code", 10, 2)], *dwells[1:]]


def test_stock_of_a_program_contains_cuts_of_largest_tool(tmp_path):
    path = tmp_path / "two.nc"
    cut = "G0 X0 Y0 Z5\nG1 Z-1 F600\nX40\nG0 Z5\n"
    path.write_text(f"G21\n(T1 D=6 - end mill)\n(T2 D=20 - end mill)\nT1 M6\n{cut}T2 M6\n{cut}")
    stocks = [row.estimate.stock for row in vkworkbench.analyze(path).operations]
    assert len(stocks) == 2
    for stock in stocks:
        assert (stock.lower[0], stock.upper[0]) == (-10, 50) and (stock.lower[1], stock.upper[1]) == (-10, 10)


def test_program_in_inches_equals_the_same_part_in_mm(tmp_path):
    found = []
    for name, unit, scale in (("mm.nc", "G21", 25.4), ("inch.nc", "G20", 1.0)):
        rows = "".join(f"G1 X{scale * 2 * (k % 2)}\nY{scale * 0.1 * (k + 1)}\n" for k in range(12))
        path = tmp_path / name
        path.write_text(
            f"{unit}\n(T1 D={scale * 0.25} - end mill)\nT1 M6\nG0 X0 Y0 Z{scale}\nG1 Z{-scale} F{scale * 20}\n{rows}"
        )
        (row,) = vkworkbench.analyze(path).operations
        found.append(
            (row.strategy, round(row.length, 6), round(row.machining.seconds, 6), row.estimate.traces, row.confidence)
        )
    assert found[0] == found[1]


def test_unreadable_file_does_not_affect_other_files(tmp_path):
    (tmp_path / "a.nc").write_bytes(b"\0\1\2binary")
    (tmp_path / "b.nc").write_text(PROGRAM)
    (tmp_path / "c.nc").write_text("1 L X+10 Y+5 R0 FMAX M3\n")
    (tmp_path / "d.nc").write_text("G0 X0\nG0 X1\n")
    (tmp_path / "e.nc").write_text("G0 X0 Y0 Z5\n#1=#5061\nG1 X#1 F200\n")
    report = vkworkbench.analyze([tmp_path, tmp_path / "missing.nc"])
    errors = {Path(row.document).name: row.error for row in report.operations if not row.counted}
    assert errors == {
        "a.nc": "This is not an NC program, because it is not text.",
        "c.nc": "Line 1: The program is written for Heidenhain controls. Post it as G-code (ISO) to analyze it.",
        "e.nc": "The toolpath has no cutting move. Line 3: The program is read up to this line. "
        "The value of #5061 comes from the machine.",
        "missing.nc": "The file cannot be read: No such file or directory.",
    }
    # An unreadable file has the strategy "unknown". A file without a cut has the strategy "empty", and has an error
    # only if a line was ignored.
    strategies = {Path(row.document).name: str(row.strategy) for row in report.operations}
    assert {name for name, strategy in strategies.items() if strategy == "unknown"} == {"a.nc", "c.nc", "missing.nc"}
    assert {name for name, strategy in strategies.items() if strategy == "empty"} == {"d.nc", "e.nc"}
    missing = report.operations[-1]
    assert missing.reason == missing.error and missing.confidence == 0.0 and missing.machining_seconds is None
    assert [row.label for row in report.operations if row.counted] == ["Face", "Holes", "d.nc"]
    assert [total.label for total in report.totals] == ["b.nc", "d.nc"]


@pytest.mark.parametrize(("change", "label"), [("", "plate"), ("T3 M6\n", "T3"), ("T3 M6\n(Face)\n", "Face")])
def test_untitled_operation_is_named_by_tool_or_file(tmp_path, change, label):
    path = tmp_path / "plate.nc"
    path.write_text(f"G21\n{change}G0 X0 Y0 Z5\nG1 Z-1 F600\n{ROWS}G0 Z5\nM30\n")
    (row,) = vkworkbench.analyze(path).operations
    assert row.label == label


def test_time_of_a_program_of_rapids_is_unknown(tmp_path):
    (tmp_path / "rapids.nc").write_text("G21\nG0 X0 Y0 Z5\nG0 X50\nM30\n")
    report = vkworkbench.analyze(tmp_path)
    (row,) = report.operations
    assert row.counted and str(row.strategy) == "empty" and row.error == "The toolpath has no cutting move."
    _, _, line, _, total = str(report).splitlines()
    assert re.search(r" 0 mm +\? ", line) and re.search(r" 0 mm +\? ", total)


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("G0 X50 Z2\nG96 S200 M3\nG1 Z-20 F.2\n", "Line 2: G96 shows a program for a lathe."),
        ("G0 X0 Y0 A0 Z5\nG1 Z0 F100\nX9 A9\nX0 A18\n", "Line 3: A rotary axis turns while the tool cuts."),
        ("M104 S200\nG1 X5 Y5 E1 F600\nX9\n", "Line 1: M104 shows a program for a 3D printer."),
        ("T0101\nG0 X52 Z2\nG90 X48 Z-20 F0.2\nX44\nG0 X99\n", "Line 3: G90 shows a program for a lathe."),
    ],
)
def test_program_for_another_machine_has_no_strategy(tmp_path, text, error):
    path = tmp_path / "other.nc"
    path.write_text(text)
    (row,) = vkworkbench.analyze(path).operations
    assert str(row.strategy) == "unknown" and row.error.startswith(error) and row.reason.startswith(error)
    assert row.estimate is None and row.confidence == 0
    # The length and the time of the program are unknown, and not 0.
    line = str(vkworkbench.analyze(path)).splitlines()[2]
    assert " 0 m" not in line and line.split("%")[1].split()[1:5] == ["?"] * 4


def test_report_is_written_as_csv_and_json(tmp_path):
    (tmp_path / "a.nc").write_text(PROGRAM)
    report = vkworkbench.analyze(tmp_path)
    report.to_csv(tmp_path / "out.csv")
    report.to_json(tmp_path / "out.json")
    rows = list(csv.DictReader(open(tmp_path / "out.csv", newline="", encoding="utf-8")))
    assert [(row["label"], row["spans"]) for row in rows] == [("Face", "zigzag 8-48"), ("Holes", "drilling 52-56")]
    assert len(json.load(open(tmp_path / "out.json", encoding="utf-8"))["operations"]) == 2


def test_file_names_outside_utf8_are_accepted(tmp_path):
    name = os.fsdecode(b"fr\xe4sen.nc")
    (tmp_path / name).write_text(PROGRAM)
    report = vkworkbench.analyze(tmp_path)
    report.to_csv(tmp_path / "out.csv")
    report.to_json(tmp_path / "out.json")
    for out in ("out.csv", "out.json"):
        assert b"/fr\xe4sen.nc" in (tmp_path / out).read_bytes()
    data = json.loads((tmp_path / "out.json").read_text(encoding="utf-8", errors="surrogateescape"))
    assert [Path(row["document"]).name for row in data["operations"]] == [name, name]


def test_cancelled_analysis_raises_cancelled(tmp_path):
    (tmp_path / "a.nc").write_text(PROGRAM)
    with pytest.raises(vkworkbench.Cancelled):
        vkworkbench.analyze(tmp_path, cancelled=lambda: True)


def test_analysis_of_a_program_does_not_import_freecad(tmp_path):
    (tmp_path / "a.nc").write_text(PROGRAM)
    code = f"import sys, vkworkbench; vkworkbench.analyze({str(tmp_path)!r}); print('FreeCAD' in sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=Path(vkworkbench.__file__).parents[1]
    )
    assert (done.stdout, done.stderr) == ("False\n", "")


def test_tool_of_inches_without_g20_is_in_inches(tmp_path, monkeypatch):
    told, recognize = [], analysis.recognize_inches
    monkeypatch.setattr(
        analysis, "recognize_inches", lambda *a, **k: told.append(k["tool_diameter"]) or recognize(*a, **k)
    )
    rings = "".join(f"G1 X{a} Y{a}\nX{4 - a}\nY{4 - a}\nX{a}\nY{a}\n" for a in (0.4, 0.1))
    path = tmp_path / "inch.nc"
    path.write_text(f"(T1 D=0.5 - end mill)\nT1 M6\nG0 X1 Y1 Z.5\nG1 Z-.1 F20\n{rings}G0 Z.5\n")
    (row,) = analyze_file(path, Preferences())
    # The rings are 0.3 inches apart, and the tool's diameter is half an inch.
    assert str(row.strategy) == "contour-parallel"
    assert told == [pytest.approx(12.7)]


def test_turning_rotary_axis_affects_only_its_operation(tmp_path):
    path = tmp_path / "indexed.nc"
    path.write_text(f"G21\nG0 X0 Y0 A0 Z5\n(Face)\nG1 Z-1 F600\n{ROWS}G0 Z5\n(Cam)\nG1 Z-1\nX9 A9\nX0 A18\nG0 Z5\n")
    assert [str(row.strategy) for row in vkworkbench.analyze(path).operations] == ["zigzag", "unknown"]


def test_unread_loop_affects_only_its_operation(tmp_path):
    """A loop that depends on the machine (#5061, a probe result) hides cuts. The operation before the loop is recognised."""
    loop = "o101 while [#5061 LT 9]\nG1 X9\nG1 X0\no101 endwhile\n"
    path = tmp_path / "loop.nc"
    path.write_text(
        f"(T1 D=6 - end mill)\nG21\nT1 M6\nG0 X0 Y0 Z5\n(Face)\nG1 Z-1 F600\n{ROWS}G0 Z5\n(Slots)\nG1 Z-1\n{loop}X9 Y9\nX0\nG0 Z5\n"
    )
    face, slots = vkworkbench.analyze(path).operations
    assert (str(face.strategy), str(slots.strategy), slots.confidence) == ("zigzag", "unknown", 0.0)
    assert slots.reason.startswith("Line ") and slots.costs


def test_only_program_without_titles_is_divided_by_motion(tmp_path):
    rings = "".join(
        f"G1 X{100 + s} Y{100 + s}\nX{140 - s}\nY{140 - s}\nX{100 + s}\nY{100 + s}\n" for s in range(0, 18, 2)
    )
    both = f"G0 X0 Y0 Z5\nG1 Z-1 F600\n{ROWS}G0 Z5\nG0 X100 Y100\nG1 Z-1\n{rings}G0 Z5\n"
    path = tmp_path / "both.nc"
    path.write_text(f"(T1 D=6 - end mill)\nG21\nT1 M6\n{both}")
    (row,) = vkworkbench.analyze(path).operations
    assert str(row.strategy) == "mixed"
    path.write_text(f"(T1 D=6 - end mill)\nG21\nT1 M6\n(Adaptive1)\n{both}")
    (row,) = vkworkbench.analyze(path).operations
    assert row.recognition.why.code != "sections"
    path.write_text(f"(T1 D=6 - end mill)\nG21\nT1 M6\n(One)\n{both}(Two)\n{both}")
    assert "mixed" not in [str(row.strategy) for row in vkworkbench.analyze(path).operations]


def test_advised_image_size_fits_time_limit_and_finest_passes(tmp_path):
    fine, coarse = (f"({title})\nG0 X0 Y0\nG1 Z-1 F600\n{rows}G0 Z5\n" for title, rows in (
        ("Fine", ROWS), ("Coarse", "".join(f"G1 X{40 * (k % 2)}\nY{3 * k + 3}\n" for k in range(12)))
    ))  # fmt: skip
    path = tmp_path / "a.nc"
    path.write_text(f"(T1 D=6 - end mill)\nG21\nT1 M6\nG0 X0 Y0 Z5\n{coarse}{fine}")
    report = vkworkbench.analyze(path)
    assert [row.stepover for row in report.operations] == [3, 1]
    assert report.totals[0].advice["z-buffer"].why.arguments["passes"].arguments["step"] == 1
    row = analyze_file(path, replace(Preferences(), time_budget=1e6))[0]
    assert row.advice["z-buffer"].why.arguments["limit"].code == "limit-memory"
    row = analyze_file(path, replace(Preferences(), time_budget=0.11))[0]
    assert row.advice["z-buffer"].why.arguments["limit"].code == "limit-time"


@pytest.mark.parametrize(("place", "said"), [("Y{}000", True), ("Y{}000.5", False)])
def test_coordinates_in_thousandths_without_a_point_are_noticed(tmp_path, place, said):
    rows = "".join(f"G1 X{40000 * (k % 2)}\n{place.format(k + 1)}\n" for k in range(20))
    path = tmp_path / "increments.nc"
    path.write_text(f"G21\n(T1 D=6 - end mill)\nT1 M6\nG0 X0 Y0 Z5000\nG1 Z-1000 F600\n{rows}G0 Z5000\n")
    (row,) = vkworkbench.analyze(path).operations
    asked = "The toolpath spans meters in whole numbers. Thousandths without a decimal point are probably read as whole units."
    assert (asked in (row.error or "")) is said
    assert row.length > 20 * 20_000


@pytest.mark.parametrize(("unit", "said"), [("", True), ("G20\n", False), ("G21\n", False)])
def test_inches_without_g20_are_noticed(tmp_path, unit, said):
    rows = "".join(f"G1 X{3 * (k % 2)}\nY{0.1 * (k + 1):.1f}\n" for k in range(20))
    path = tmp_path / "inch.nc"
    path.write_text(f"{unit}(T1 D=0.25 - end mill)\nT1 M6\nG0 X0 Y0 Z.5\nG1 Z-.1 F20\n{rows}G0 Z.5\n")
    (row,) = vkworkbench.analyze(path).operations
    assert str(row.strategy) == "zigzag"
    assert (row.error == "The toolpath looks 25.4 times too small. Inches are probably read as millimeters.") is said


@pytest.mark.parametrize("tool", ["T1 1/4 END MILL", "T1 6.35mm END MILL"])
def test_result_in_inches_is_equal_for_tool_sizes_in_any_unit(tmp_path, tool):
    rows = "".join(f"G1 X{3 * (k % 2)}\nY{0.1 * (k + 1):.1f}\n" for k in range(20))
    found = []
    for comment in (tool, "T1 0.25 END MILL"):
        path = tmp_path / "inch.nc"
        path.write_text(f"({comment})\nT1 M6\nG0 X0 Y0 Z.5\nG1 Z-.1 F20\n{rows}G0 Z.5\n")
        (row,) = vkworkbench.analyze(path).operations
        found.append((row.strategy, row.confidence, round(row.costs["z-buffer"].dexels)))
    assert found[0] == found[1]


@pytest.mark.parametrize(
    ("tool", "said"), [("T1 DIA-0.5000  1/2 ENDMILL", True), ("T1 DIA-0.5 - OP 3/4", False), ("T1 1/2 ENDMILL", False)]
)
def test_program_with_inch_tools_is_in_inches(tmp_path, tool, said):
    path = tmp_path / "inch.nc"
    path.write_text(f"({tool})\nT1 M6\nG0 X0 Y0 Z3\nG1 Z-.1 F20\nX36\nY4\nX0\nY0\nG0 Z3\n")
    (row,) = vkworkbench.analyze(path).operations
    assert (row.error == "The toolpath looks 25.4 times too small. Inches are probably read as millimeters.") is said
    doubtful = "The program has no unit (G20, G21) and is read in millimeters. It can also be in inches."
    assert (doubtful in (row.error or "")) is not said


def test_machine_plans_rapids_tool_changes_and_accelerations(tmp_path):
    path, settings = tmp_path / "two.nc", tmp_path / "grbl.txt"
    cut = "G0 X0 Y0 Z5\nG1 Z-1 F600\nX40\nG0 Z5\n"
    path.write_text(f"G21\nT1 M6\n{cut}T2 M6\n{cut}")
    settings.write_text("$110=3000\n$111=3000\n$112=600\n$120=250\n$121=250\n$122=100\n$11=0.01\n")
    named, pasted, mill = (vkworkbench.analyze(path, machine=one) for one in (
        "hobby-router", settings, replace(MACHINES["hobby-router"], factor=2.0)))  # fmt: skip
    assert all(row.machining.complete for row in named) and named.totals[0].setup.change == 3 + 123
    assert [row.machining_seconds for row in pasted] == pytest.approx([row.machining_seconds for row in named])
    assert mill.totals[0].machining_seconds == pytest.approx(2 * named.totals[0].machining_seconds)
    constant = vkworkbench.analyze(path).operations
    assert all(0 < a.machining_seconds < b.machining_seconds and a.left_out for a, b in zip(constant, named))


@pytest.mark.parametrize("machine", ["lathe", "", "two.nc"])
def test_unknown_machine_is_refused(tmp_path, machine):
    (tmp_path / "two.nc").write_text(PROGRAM)
    with pytest.raises(ValueError, match=r"hobby-router|grbl|\$110"):
        vkworkbench.analyze(tmp_path / "two.nc", machine=str(tmp_path / machine) if machine else machine)
    with pytest.raises(TypeError, match="machine"):
        vkworkbench.analyze(tmp_path / "two.nc", machine=5)


@pytest.mark.parametrize("times", [999_999_999, 1_000_001])
def test_reading_a_call_with_a_million_repeats_ends_at_once(tmp_path, times):
    (tmp_path / "a.nc").write_text(f"G0 X0 Y0 Z0\nM98 P1 L{times}\nM30\nO1\nG1 X1 F100\nM99\n")
    (row,) = vkworkbench.analyze(tmp_path).operations
    assert any("would run more than 1,000,000 lines" in render(remark) for remark in row.remarks)


@pytest.mark.long
@pytest.mark.parametrize("start, repeated", [("", "/"), ("", "("), ("", "X1"), ("G1 X", "1"), ("", "X[")])
def test_memory_for_programs_with_long_lines_is_limited(tmp_path, start, repeated):
    line = start + 100_000 * repeated
    (tmp_path / "a.nc.gz").write_bytes(gzip.compress(f"{line}\n".encode() * 2))
    report, _, peak = memory(lambda: vkworkbench.analyze(tmp_path))
    assert not report.operations[0].trajectories and peak < 500 * len(line)
