# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inches that are read as millimetres are noticed, and their strategies are recognised."""

from dataclasses import replace

import numpy as np
import pytest

from vkworkbench.core import Strategy, linearize, recognize
from vkworkbench.core.gcode import DOUBTFUL, INCH, in_seconds, looks_like_inches, looks_like_increments, read_program
from vkworkbench.core.recognition import recognize_inches
from vkworkbench.language import render

FEED = 10.0  # mm/s


def zigzag(width=80.0, rows=15, step=3.0, depth=-2.0, lift=8.0, feed=FEED):
    commands = [("G0", {"X": 0.0, "Y": 0.0, "Z": lift}), ("G1", {"Z": depth, "F": feed})]
    for k in range(rows):
        commands += [("G1", {"X": width * (k % 2 == 0), "Y": k * step}), ("G1", {"Y": (k + 1) * step})]
    return linearize([*commands, ("G0", {"Z": lift})])


def offsets(size=60.0, step=2.5, lift=6.0):
    commands = [("G0", {"X": step, "Y": step, "Z": lift}), ("G1", {"Z": -1.0, "F": FEED})]
    for k in range(8, 0, -1):
        a, b = k * step, size - k * step
        commands += [("G1", {"X": x, "Y": y}) for x, y in ((a, a), (b, a), (b, b), (a, b), (a, a))]
    return linearize([*commands, ("G0", {"Z": lift})])


def shrunk(path):
    return replace(path, points=path.points / INCH, feed=path.feed / INCH)


@pytest.mark.parametrize("path", [zigzag(), offsets(), zigzag(width=200.0), zigzag(lift=25.0)])
def test_only_toolpaths_too_small_for_mm_look_like_inches(path):
    assert not looks_like_inches(path)
    assert looks_like_inches(shrunk(path))
    assert looks_like_inches(shrunk(path), tool_diameter=6.0)


def test_fast_or_large_toolpath_does_not_look_like_inches():
    small = shrunk(zigzag())
    assert not looks_like_inches(replace(small, feed=np.full(len(small), 20.0)))  # The feed is 1200 inches a minute.
    # The feed is 20 inches a minute.
    assert looks_like_inches(replace(small, feed=np.full(len(small), 20.0)), imported=True)
    # The feed is 800 mm/min.
    assert not looks_like_inches(replace(small, feed=np.full(len(small), 800.0)), imported=True)
    assert not looks_like_inches(small, tool_diameter=0.3)  # Tools of 0.3 mm exist for engraving.
    assert not looks_like_inches(shrunk(zigzag(lift=200.0)))
    assert not looks_like_inches(linearize([]))
    # The toolpath is a single hole.
    assert not looks_like_inches(linearize([("G0", {"X": 1.0, "Y": 0.0, "Z": 1.0}), ("G1", {"Z": -0.1})]))


@pytest.mark.parametrize(
    "changed, imported, said",
    [
        ({}, False, True),
        ({"width": 14.5}, False, True), ({"width": 16.0}, False, False),  # Read as inches, the part would be too large.
        ({"lift": 3.0}, False, True), ({"lift": 4.0}, False, False),  # Read as inches, the lift would be too high.
        ({"feed": 4.5}, False, True), ({"feed": 5.5}, False, False),  # Read as inches, the feed would be too fast.
        ({"feed": 290.0}, True, True), ({"feed": 310.0}, True, False),  # FreeCAD's import stores mm/min as mm/s.
    ],
)  # fmt: skip
def test_limits_of_size_and_feed_decide_if_a_path_is_in_inches(changed, imported, said):
    toolpath = zigzag(**{"width": 10.0, "rows": 4, "step": 0.5, "depth": -0.5, "lift": 2.0, "feed": 1.0, **changed})
    assert looks_like_inches(toolpath, imported=imported) == said


def test_laser_and_wide_part_are_not_too_small():
    # A laser is not lifted between rows.
    assert not looks_like_inches(zigzag(width=10.0, rows=4, step=0.5, depth=0.0, lift=0.0, feed=1.0))
    small = zigzag(width=10.0, rows=4, step=0.5, depth=-0.5, lift=2.0, feed=1.0)
    assert looks_like_inches(small, tool_diameter=2.6) and not looks_like_inches(small, tool_diameter=2.4)


@pytest.mark.parametrize("unit, scale", [("G21", 1), ("G20", INCH)])
@pytest.mark.parametrize(
    "text, said",
    [
        ("G0 X0 Y0 Z25000\nG1 Z-1000 F200\nX5000\nY5000\nG3 X0 Y5000 I-2500 J0", True),
        ("G0 X0 Y0 Z25000\nG1 Z-1000 F200\nX5000\nY5000.5\nX0", False),
        ("G0 X0 Y0 Z25\nG1 Z-1 F200\nX100\nY50\nX0", False),
        ("G0 X0 Y0 Z5000\nX5000\nY50\nG1 Z-1 F200\nX5001", False),
        ("G0 X0 Y0 Z25\nG99 G73 X5000 Z-30 R5 Q7 F100\nX0 Y5000", True),
        ("G0 X0 Y0 Z5000\nX5000", False),
    ],
)
def test_coordinates_without_a_point_look_like_thousandths(unit, scale, text, said):
    path = read_program(f"{unit}\n{text}").toolpath()
    assert looks_like_increments(path, inches=scale == INCH) == said
    assert np.ptp(path.points[:, 0]) / scale == pytest.approx(
        100 if "X100" in text else 5001 if "X5001" in text else 5000
    )


def test_thousandths_depend_on_the_programs_unit():
    path = read_program("G20\nG0 X0 Y0 Z1\nG1 X5001 Y7 F9").toolpath()
    assert looks_like_increments(path, inches=True) and not looks_like_increments(path, inches=False)


def test_numbers_above_5000_are_read_as_thousandths_of_a_mm():
    for length, said in ((5000, True), (4999, False)):
        path = read_program(f"G21\nG0 X0 Y0 Z5\nG1 Z-1 F9\nX{length}").toolpath()
        assert looks_like_increments(path, inches=False) == said


def test_fastest_feed_decides_if_feeds_are_mm_per_minute():
    slow, fast = zigzag(feed=240.0), zigzag(feed=600.0)
    # If the fastest feed is at least 250, feeds are read as mm/min, because 250 mm/s would be 15 m/min.
    assert in_seconds(slow) == (slow, None) and in_seconds(zigzag(feed=260.0))[1]
    entering = replace(fast, feed=np.where(np.arange(len(fast)) < 3, 100.0, 600.0))
    mended, said = in_seconds(entering)
    assert mended.feed.tolist() == [100 / 60] * 3 + [10.0] * (len(fast) - 3)
    assert said.code == "feeds-per-minute" and said.arguments["feed"] == 600.0
    assert in_seconds(linearize([]))[1] is None


@pytest.mark.parametrize("path", [zigzag(), offsets()])
def test_recognition_in_inches_equals_recognition_in_mm(path):
    true, found = recognize(path, tool_diameter=6.0), recognize_inches(shrunk(path), tool_diameter=6.0)
    assert found.strategy is true.strategy and found.strategy in (Strategy.ZIGZAG, Strategy.CONTOUR_PARALLEL)
    assert found.confidence == pytest.approx(true.confidence)
    assert found.stepover == pytest.approx(true.stepover / INCH)
    assert [(s.first, s.last) for s in found.spans] == [(s.first, s.last) for s in true.spans]
    assert found.paper.v == pytest.approx([x / INCH for x in true.paper.v])


def test_lengths_in_the_reason_have_the_unit_of_the_path():
    def steps(message):
        own = [value for name, value in message.arguments.items() if name == "step"]
        return own + [step for value in message.arguments.values() if hasattr(value, "code") for step in steps(value)]

    true, found = recognize(zigzag()), recognize_inches(shrunk(zigzag()))
    assert steps(true.why) and steps(found.why) == pytest.approx([step / INCH for step in steps(true.why)])
    assert render(found.why).split(",")[0] == render(true.why).split(",")[0]


def test_large_part_can_be_in_inches():
    part = zigzag(width=20.0, rows=12, step=1.0, depth=-0.5, lift=0.5, feed=1.0)
    assert not looks_like_inches(part) and looks_like_inches(part, small=DOUBTFUL)


def test_program_with_g20_or_g21_states_its_unit():
    for text, told, inches in (
        ("G20", True, True),
        ("G21", True, False),
        ("G71\nG20", True, False),
        ("", False, False),
    ):
        program = read_program(f"{text}\nG0 X0 Y0 Z1\nG1 X1 F10\n")
        assert (program.unit_told, program.inches) == (told, inches)
