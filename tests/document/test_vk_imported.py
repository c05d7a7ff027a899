# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs imported by FreeCAD: the importer loses the units of lengths and feeds, and the analysis detects them."""

from __future__ import annotations

import importlib

import FreeCAD
import programs
import pytest

import vkworkbench
from vkworkbench import preferences
from vkworkbench.document.job.recognition import source_of

ROWS = "".join(f"G1 X{2 * (k % 2) + 0.1:.4f} Y{0.1 * k + 0.1:.4f}\nG1 Y{0.1 * (k + 1) + 0.1:.4f}\n" for k in range(12))
PROGRAM = f"G20\nM6 T1\nG0 X0.1 Y0.1 Z1.5\nG1 Z0.7 F20\n{ROWS}G0 Z1.5\n"
TOO_SMALL = "The toolpath looks 25.4 times too small. Inches are probably read as millimeters."


def importer():
    """Return FreeCAD's G-code importer, whose module has another name in FreeCAD 0.20 and 1.x."""
    for name in ("Path.Post.scripts.gcode_pre", "gcode_pre", "PathScripts.post.gcode_pre"):
        try:
            return importlib.import_module(name)
        except ImportError:
            continue
    pytest.fail("this FreeCAD has no importer of G-code")


def imported(small, text, folder):
    path = folder / "program.nc"
    path.write_text(text)
    before = set(small.document.Objects)
    importer().insert(str(path), small.name)
    (operation,) = [obj for obj in small.document.Objects if obj not in before and hasattr(obj, "Gcode")]
    return operation


def test_program_imported_in_inches_is_reported_and_recognised(small, tmp_path):
    FreeCAD.setActiveDocument(small.name)
    operation = imported(small, PROGRAM, tmp_path)
    (row,) = vkworkbench.analyze(operation).operations
    assert TOO_SMALL in row.error and str(row.strategy) == "zigzag"
    (file,) = vkworkbench.analyze(tmp_path / "program.nc").operations
    assert file.strategy is row.strategy and file.length == pytest.approx(25.4 * row.length)


def test_operations_imported_in_inches_are_separate_spans(small, tmp_path):
    FreeCAD.setActiveDocument(small.name)
    turn = "".join(f"G1 X{x} Y{y}\n" for x, y in ((8, 4), (8, 8), (4, 8), (4, 4)))
    contours = f"G0 X4 Y4\nG1 Z0.7 F20\n{turn}G1 Z0.6\n{turn}G0 Z1.5\n"
    operation = imported(small, PROGRAM + contours, tmp_path)
    (row,) = vkworkbench.analyze(operation).operations
    assert TOO_SMALL in row.error
    assert [str(span.strategy) for span in row.recognition.spans] == ["zigzag", "profile"]


def test_imported_inches_split_profile_and_helix_at_a_retract(small, tmp_path):
    """The two operations are separate spans (parts with one strategy), as in a program in millimetres."""
    FreeCAD.setActiveDocument(small.name)
    commands = [*programs.profile(24, 40.0, [-1.0, -2.0, -3.0]), *programs.helix(8, 15.0, 1.0)]
    lines = [
        name + "".join(f" {letter}{value if letter == 'F' else value / 25.4:.5f}" for letter, value in words.items())
        for name, words in commands
        if words
    ]
    operation = imported(small, "\n".join(["G20", "M6 T1", *lines, ""]), tmp_path)
    (row,) = vkworkbench.analyze(operation).operations
    assert TOO_SMALL in row.error
    assert [str(span.strategy) for span in row.recognition.spans] == ["profile", "helix"]


@pytest.mark.parametrize("name", ["ClearanceHeight", "Base"])
def test_operation_without_proxy_is_not_an_import(small, name):
    """
    The object has no proxy, but heights or a base, which an imported program does not have.

    So the object is not an import but an operation, and its feeds are in mm/s.
    """
    operation = small.add(
        "Fast", [("G0", {"X": 5.0, "Y": 5.0, "Z": 30.0}), ("G1", {"Z": 15.0, "F": 300.0}), ("G1", {"X": 55.0})]
    )
    assert vkworkbench.analyze(operation).operations[0].machining_seconds == pytest.approx(65 / 5)
    operation.addProperty("App::PropertyFloat" if name == "ClearanceHeight" else "App::PropertyLink", name, "Path")
    assert vkworkbench.analyze(operation).operations[0].machining_seconds == pytest.approx(65 / 300)


def test_program_imported_in_millimetres_has_no_remark(small, tmp_path):
    FreeCAD.setActiveDocument(small.name)
    lines = ROWS.replace("G1 X2.1000", "G1 X50.1000").replace("Y0.", "Y").replace("Y1.", "Y1")
    operation = imported(small, f"G21\nM6 T1\nG0 X0.1 Y0.1 Z30\nG1 Z15 F600\n{lines}G0 Z30\n", tmp_path)
    (row,) = vkworkbench.analyze(operation).operations
    assert TOO_SMALL not in (row.error or "")


def test_very_small_freecad_operation_has_no_remark(small, zigzag_commands):
    """An operation with a proxy was not imported, even if it is very small."""
    shrunk = [(name, {axis: v / 25.4 for axis, v in words.items()}) for name, words in zigzag_commands]
    operation = small.add("Tiny", shrunk)
    assert TOO_SMALL in vkworkbench.analyze(operation).operations[0].error
    operation.Proxy = object()
    assert TOO_SMALL not in (vkworkbench.analyze(operation).operations[0].error or "")


MINUTES = "are read as mm/min"


def test_feeds_of_an_imported_program_are_read_as_mm_per_min(small, tmp_path):
    FreeCAD.setActiveDocument(small.name)
    lines = "".join(f"G1 X{55 if k % 2 == 0 else 5} F1200\nG1 Y{5 + 3 * k}\n" for k in range(10))
    operation = imported(small, f"G21\nM6 T1\nG0 X5 Y5 Z30\nG1 Z15 F300\n{lines}G0 Z30\n", tmp_path)
    (row,) = vkworkbench.analyze(operation).operations
    (file,) = vkworkbench.analyze(tmp_path / "program.nc").operations
    assert MINUTES in row.error and "1,200 mm/s" in row.error
    assert row.machining.cutting_seconds == pytest.approx(file.machining.cutting_seconds)
    operation.Proxy = None
    assert MINUTES in vkworkbench.analyze(operation).operations[0].error


def test_feeds_of_a_freecad_operation_are_read_as_mm_per_second(small, zigzag_commands):
    """FreeCAD's feeds are in mm/s, even if the operation lost its proxy in another version of FreeCAD."""
    (row,) = vkworkbench.analyze(small.add("Zigzag", zigzag_commands)).operations
    assert row.machining.cutting_seconds == pytest.approx(56) and MINUTES not in (row.error or "")
    fast = small.add("Fast", [(name, {**words, "F": 300.0}) for name, words in zigzag_commands])
    fast.Proxy = object()
    assert MINUTES not in (vkworkbench.analyze(fast).operations[0].error or "")


def test_toolpath_with_rotary_axis_is_not_called_too_small(small):
    """The A word is an angle, so the toolpath is neither recognised nor reported as too small."""
    turning = [("G0", {"X": 0.1, "Y": 0.1, "Z": 1.0}), ("G1", {"X": 1.0, "F": 5.0}), ("G1", {"X": 0.2, "A": 90.0})]
    (row,) = vkworkbench.analyze(small.add("Turning", turning)).operations
    assert row.strategy == "unknown" and "rotary" in row.error and TOO_SMALL not in row.error


def test_recognition_gets_a_copy_of_the_path(small, zigzag_commands):
    op, without = small.add("Rows", zigzag_commands), small.add("No tool", zigzag_commands, controller=None)
    op.Placement.Base = FreeCAD.Vector(1, 2, 3)
    source = source_of(op)
    assert source.path.Size == len(zigzag_commands) and source.placement.Base == FreeCAD.Vector(1, 2, 3)
    assert (source.tool_diameter, source.imported, source.tolerance) == (5.0, True, preferences.read().tolerance)
    assert source_of(without).tool_diameter is None
    op.Path = type(op.Path)()
    assert source.path.Size == len(zigzag_commands)
