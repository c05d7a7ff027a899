# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fingerprints of operations are equal if the analysis would return equal results, and different otherwise."""

from __future__ import annotations

import hashlib

import FreeCAD
import pytest

from vkworkbench.core import Stock, Tool
from vkworkbench.document.job import fingerprint
from vkworkbench.document.job.fingerprint import (
    Settings,
    finding_path_fingerprint,
    fingerprint_of,
    path_and_setting,
    path_fingerprint,
    read_setting_fingerprints,
    setting_fingerprint,
    text_fingerprint,
    text_of,
)
from vkworkbench.document.job.path_prints import PATH_PRINTS

NOWHERE = FreeCAD.Placement()
TEXT = "G0 X0.000000 Y1.000000\nG1 X5.000000\n"


def placed(x=0.0, angle=0.0):
    return FreeCAD.Placement(FreeCAD.Vector(x, 2, 3), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), angle))


@pytest.mark.parametrize(
    "text", [TEXT.replace("X0.0", "X-0.0"), "(a title)\n" + TEXT, TEXT.replace("\nG1", "\n(a title)\nG1")]
)
def test_comments_and_minus_zero_keep_the_fingerprint(text):
    assert text != TEXT and text_fingerprint(text, NOWHERE) == text_fingerprint(TEXT, NOWHERE)


@pytest.mark.parametrize(
    "text",
    [
        TEXT.replace("Y1.0", "Y1.1"),
        TEXT.replace("X5.000000", "X5.000001"),
        TEXT.replace("Y1", "Y-1"),
        "G0 (X)\n" + TEXT,
        "",
    ],
)
def test_any_other_letter_of_the_gcode_changes_the_fingerprint(text):
    assert text_fingerprint(text, NOWHERE) != text_fingerprint(TEXT, NOWHERE)


def test_placement_is_rounded_to_6_decimals_in_the_fingerprint():
    here = text_fingerprint(TEXT, placed())
    assert here != text_fingerprint(TEXT, NOWHERE)
    assert here == text_fingerprint(TEXT, placed(1e-7)) and here != text_fingerprint(TEXT, placed(1e-5))
    assert here != text_fingerprint(TEXT, placed(angle=0.01))


def test_fingerprint_combines_path_and_setting_in_16_letters():
    path, setting = text_fingerprint(TEXT, NOWHERE), setting_fingerprint(None, None)
    assert len(path) == len(setting) == 16
    assert path_and_setting(fingerprint_of(path, setting)) == (path, setting)
    assert path_and_setting(fingerprint_of("", setting)) == ("", setting)
    assert path_and_setting("") == ("", "")


TOOL, BOX = {"shape": "bullnose", "diameter": 6.0, "corner_radius": 1.0}, ((0.0, 0.0, 0.0), (50.0, 40.0, 20.0))


def of(form=(), lower=BOX[0], upper=BOX[1], **changed):
    return setting_fingerprint(Tool(**{**TOOL, **changed}), Stock(lower, upper), form)


@pytest.mark.parametrize(
    "changed",
    [{"diameter": 6.0002}, {"corner_radius": 1.0002}, {"lower": (0.01, 0.0, 0.0)}, {"upper": (50.0, 40.01, 20.0)},
     {"upper": (50.0, 40.0, 20.01)}, {"form": ("cylinder",)}],
    ids=str,
)  # fmt: skip
def test_another_tool_or_stock_changes_the_fingerprint(changed):
    assert of(**changed) != of()


@pytest.mark.parametrize(
    "changed",
    [{"diameter": 6.00001}, {"corner_radius": 1.00001}, {"lower": (1e-5, -1e-5, 0.0)}, {"upper": (50.00001, 40.0, 20.0)},
     {"upper": (50.002, 40.0, 20.0)}, {"lower": (0.0, -0.001, 0.0)}],
    ids=str,
)  # fmt: skip
def test_rounding_in_files_keeps_the_fingerprint(changed):
    assert of(**changed) == of()


def test_corner_at_half_a_hundredth_is_rounded_the_same_way():
    """Many corners are multiples of 0.005 mm (half of a size), which must not be halfway between two rounded values."""
    for corner in (0.005, 0.125, 12.345, 3.175):
        assert of(upper=(60.0 + corner - 1e-9, 40.0, 20.0)) == of(upper=(60.0 + corner + 1e-9, 40.0, 20.0))


def test_fingerprint_is_the_same_in_every_version():
    """A fingerprint is the first 16 digits of the SHA-1 of the rounded values, with -0 written as 0."""

    def digits(text):
        return hashlib.sha1(text.encode()).hexdigest()[:16]

    assert text_fingerprint(TEXT, NOWHERE) == digits(TEXT)
    assert text_fingerprint(TEXT, placed()) == digits(TEXT + "[0.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0]")
    setting = "[('bullnose', 6.0, 1.0, None), [0.0, 1.23, 1.24, 50.0, 40.0, 20.0]]"
    assert of(lower=(-0.003, 1.2345, 1.2347)) == digits(setting)


def test_unreadable_setting_has_its_own_fingerprint():
    tool, stock = Tool(**TOOL), Stock(*BOX)
    settings = [(tool, stock), (tool, None), (None, stock), (None, None)]
    assert len({setting_fingerprint(*one) for one in settings}) == 4
    assert setting_fingerprint(tool, None, ("a form",)) == setting_fingerprint(tool, None)


def test_rapid_speeds_change_the_fingerprint_if_set():
    tool, stock = Tool(**TOOL), Stock(*BOX)
    assert setting_fingerprint(tool, stock, (), (0.0, 0.0)) == setting_fingerprint(tool, stock)
    speeds = [(0.0, 0.0), (50.0, 0.0), (0.0, 50.0), (50.0, 50.01)]
    assert len({setting_fingerprint(tool, stock, (), both) for both in speeds}) == 4
    assert setting_fingerprint(tool, stock, (), (100 / 3, 9.0)) == setting_fingerprint(tool, stock, (), (33.33334, 9.0))


def test_tip_of_a_tool_changes_the_fingerprint():
    pointed = Tool("vbit", 6.0, tip_angle=1.0)
    settings = [pointed, Tool("vbit", 6.0, tip_angle=1.0002), Tool("vbit", 6.0, tip_angle=1.0, tip_diameter=1.0),
                Tool("vbit", 6.0, tip_angle=1.0, tip_diameter=1.001), Tool("drill", 6.0, tip_angle=1.0)]  # fmt: skip
    assert len({setting_fingerprint(tool, None) for tool in settings}) == 5
    assert setting_fingerprint(Tool("vbit", 6.0, tip_angle=1.00001), None) == setting_fingerprint(pointed, None)
    blunt = [Tool("vbit", 6.0, tip_angle=1.0, tip_diameter=diameter) for diameter in (1.0, 1.00003)]
    assert len({setting_fingerprint(tool, None) for tool in blunt}) == 1


@pytest.mark.parametrize("at_once", [50_000, 10])
def test_fingerprint_of_a_path_equals_fingerprint_of_its_text(small, zigzag_commands, monkeypatch, at_once):
    monkeypatch.setattr(fingerprint, "AT_ONCE", at_once)
    op = small.add("One", zigzag_commands)
    text = op.Path.toGCode()
    assert text_of(op.Path) == text_of(op.Path, list(op.Path.Commands)) == text
    assert path_fingerprint(op) == text_fingerprint(text, op.Placement)


def test_reopened_document_accepts_a_mark_without_stock(small, zigzag_commands):
    """In a reopened document, marks without a stock stay valid, because FreeCAD adds a stock on opening."""
    op = small.add("One", zigzag_commands)
    whole, of_tool = read_setting_fingerprints(op, small.job)
    assert whole != of_tool
    assert Settings().of(op) == (whole,) and Settings(opened=True).of(op) == (whole, of_tool)


def test_fingerprint_from_an_analysis_is_not_computed_again(small, zigzag_commands):
    op = small.add("One", zigzag_commands)
    steps = finding_path_fingerprint(op)
    next(steps)
    next(steps)
    PATH_PRINTS.end((small.name, op.Name), PATH_PRINTS.begin(op), "found")
    assert next(steps, "over") == "over" and PATH_PRINTS.of(op) == "found"
