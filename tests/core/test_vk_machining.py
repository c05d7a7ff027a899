# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths and machining times, compared with values computed by hand."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vkworkbench.core import MACHINES, exact_lengths, machining, seconds_of_dwells, trajectory_seconds
from vkworkbench.core.gcode import linearize


def test_times_of_feeds_and_rapids_are_added():
    path = linearize(
        [
            ("G0", {"X": 0.0, "Y": 0.0, "Z": 30.0}),
            ("G0", {"X": 30.0, "Y": 40.0}),
            ("G0", {"Z": 25.0}),
            ("G1", {"Z": 15.0, "F": 2.0}),
            ("G1", {"X": 130.0, "F": 10.0}),
        ]
    )
    work = machining(path, horizontal_rapid=100.0, vertical_rapid=5.0, top=20.0)
    assert work.cutting_length == pytest.approx(110) and work.rapid_length == pytest.approx(55)
    assert work.cutting_seconds == pytest.approx(5 + 10) and work.rapid_seconds == pytest.approx(0.5 + 1)
    assert work.seconds == pytest.approx(16.5)
    assert work.lowest == 15 and work.depth == 5 and work.notes == ()


def test_shortest_and_median_length_of_moves_are_per_command():
    """An arc counts as one move regardless of its chords, a rapid does not count, and a cycle counts with its feeds."""
    path = linearize(
        [
            ("G0", {"X": 0.0, "Y": 0.0, "Z": 0.0}),
            ("G1", {"X": 7.0, "F": 10.0}),
            ("G0", {"Y": 0.001}),
            ("G2", {"X": 3.0, "I": -2.0, "J": 0.0}),
            ("G81", {"X": 20.0, "Z": -3.0, "R": 2.0}),
            ("G80", {}),
        ],
        tolerance=1e-3,
    )
    work = machining(path)
    assert len(path) > 20 and work.shortest == pytest.approx(5) and work.median == pytest.approx(2 * math.pi, rel=1e-5)
    rapids = machining(linearize([("G0", {"X": 0.0}), ("G0", {"X": 5.0})]))
    assert rapids.shortest is None and rapids.median is None


@pytest.mark.parametrize(
    "end, sweep", [((-10.0, 0.0), math.pi), ((0.0, -10.0), 1.5 * math.pi), ((10.0, 0.0), 2 * math.pi)]
)
def test_arcs_have_their_exact_length(end, sweep):
    """FreeCAD's Path.Length returns 14.66, 10.17 and 0 mm for these arcs."""
    path = linearize(
        [
            ("G0", {"X": 10.0, "Y": 0.0, "Z": 0.0}),
            ("G3", {"X": end[0], "Y": end[1], "I": -10.0, "J": 0.0, "F": 5.0}),
        ],
        tolerance=0.5,
    )
    assert machining(path).cutting_length == pytest.approx(10 * sweep, rel=1e-9)
    assert machining(path).cutting_seconds == pytest.approx(2 * sweep, rel=1e-9)


@pytest.mark.parametrize(
    "plane, arc, rise",
    [
        ("G17", {"X": -10.0, "Y": 0.0, "Z": -3.0, "I": -10.0, "J": 0.0}, 3.0),
        ("G18", {"X": -10.0, "Z": 0.0, "Y": 4.0, "I": -10.0, "K": 0.0}, 4.0),
    ],
)
def test_helix_has_its_exact_length_in_every_plane(plane, arc, rise):
    path = linearize([(plane, {}), ("G0", {"X": 10.0, "Y": 0.0, "Z": 0.0}), ("G3", arc)], tolerance=0.2)
    assert exact_lengths(path).sum() == pytest.approx(math.hypot(10 * math.pi, rise), rel=1e-9)


@given(st.floats(0.1, 50), st.floats(0.05, 6.2), st.floats(-5, 5))
def test_length_of_any_arc_does_not_depend_on_its_chords(radius, sweep, rise):
    arc = (
        "G3",
        {"X": radius * math.cos(sweep), "Y": radius * math.sin(sweep), "Z": rise, "I": -radius, "J": 0.0},
    )
    path = linearize([("G0", {"X": radius, "Y": 0.0, "Z": 0.0}), arc], tolerance=0.05)
    assert exact_lengths(path).sum() == pytest.approx(math.hypot(radius * sweep, rise), rel=1e-6)


def test_rapids_of_unknown_speed_have_a_note():
    commands = [
        ("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}),
        ("G0", {"X": 100.0}),
        ("G0", {"Z": 1.0}),
        ("G1", {"Z": 0.0, "F": 1.0}),
    ]
    both = machining(linearize(commands))
    assert both.rapid_seconds is None and both.seconds == pytest.approx(1)
    assert both.notes == (
        "The machining time does not include 104 mm of rapids, because the tool controller's HorizRapid and VertRapid are 0.",
    )
    one = machining(linearize(commands), horizontal_rapid=50.0)
    assert one.rapid_seconds == pytest.approx(2)
    assert one.notes == (
        "The machining time does not include 4 mm of rapids, because the tool controller's VertRapid is 0.",
    )
    # A toolpath without vertical rapids does not need VertRapid.
    level = machining(linearize([*commands[:2], ("G1", {"Z": 0.0, "F": 1.0})]))
    assert level.notes == (
        "The machining time does not include 100 mm of rapids, because the tool controller's HorizRapid is 0.",
    )
    none = machining(linearize(commands), controller=False)
    assert none.rapid_seconds is None
    assert none.notes == (
        "The machining time does not include 104 mm of rapids, because the operation has no tool controller. Choose your machine in the preferences, page Machine.",
    )


def test_time_of_a_slow_rapid_is_counted():
    path = linearize([("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G0", {"X": 10.0})])
    assert machining(path, horizontal_rapid=0.5).rapid_seconds == pytest.approx(20)
    # FreeCAD accepts any speed. A rapid at 5e-324 mm/s would take an infinite time.
    assert machining(path, horizontal_rapid=5e-324) == machining(path, horizontal_rapid=0.0)


def test_time_of_a_move_of_unknown_speed_is_nan():
    commands = [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G0", {"X": 10.0}), ("G0", {"Z": 0.0}), ("G1", {"X": 20.0})]
    path = linearize([*commands, ("G1", {"X": 30.0, "F": 2.0})])
    assert trajectory_seconds(path) == pytest.approx([math.nan, math.nan, math.nan, 5.0], nan_ok=True)
    assert trajectory_seconds(path, horizontal_rapid=10.0, vertical_rapid=5.0)[:2] == pytest.approx([1.0, 1.0])


def test_slow_feed_counts_and_missing_feed_has_no_time():
    path = linearize([("G0", {"X": 0.0, "Y": 0.0, "Z": 0.0}), ("G1", {"X": 30.0}), ("G1", {"X": 80.0, "F": 0.5})])
    assert trajectory_seconds(path)[-2:] == pytest.approx([math.nan, 100.0], nan_ok=True)
    assert machining(path).cutting_seconds == pytest.approx(100.0)


def test_moves_without_a_feed_have_a_note():
    commands = [("G0", {"X": 0.0, "Y": 0.0, "Z": 0.0}), ("G1", {"X": 30.0}), ("G1", {"X": 80.0, "F": 5.0})]
    some = machining(linearize(commands))
    assert some.cutting_seconds == pytest.approx(10)
    assert some.notes == ("The machining time does not include 30 mm of cutting in 1 move without a feed rate.",)
    none = machining(linearize(commands[:2]))
    assert none.cutting_seconds is None and none.seconds is None and none.cutting_length == 30


def test_toolpath_without_cuts_has_no_depth():
    for commands in ([], [("(empty)", {})], [("G0", {"X": 0.0, "Y": 0.0, "Z": 0.0}), ("G0", {"X": 5.0})]):
        work = machining(linearize(commands), top=3.0)
        assert work.cutting_length == 0 and work.lowest is None and work.depth is None


def test_bad_rapid_speeds_are_refused():
    for speed in (-1.0, float("nan"), float("inf")):
        with pytest.raises(ValueError, match="horizontal_rapid must be a rapid speed"):
            machining(linearize([]), horizontal_rapid=speed)


def test_exact_lengths_of_lines_equal_their_chords():
    rng = np.random.default_rng(1)
    path = linearize([("G1", dict(zip("XYZ", row.tolist()))) for row in rng.normal(size=(50, 3))])
    assert np.allclose(exact_lengths(path), path.lengths)


def test_lowest_point_ignores_rapids_below_cuts():
    """The tool enters the stock by a rapid and leaves it at feed. A later rapid, lower than all cuts, is ignored."""
    rising = [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G0", {"Z": -2.0}), ("G1", {"X": 9.0, "Z": 1.0, "F": 5.0})]
    work = machining(linearize([*rising, ("G0", {"Z": 9.0}), ("G0", {"X": 50.0}), ("G0", {"Z": -7.0})]), top=1.0)
    assert (work.lowest, work.depth) == (-2, 3)
    again = machining(linearize([*rising, ("G1", {"X": 0.0}), ("G1", {"Z": 4.0})]), top=1.0)
    assert (again.lowest, again.depth) == (-2, 3)
    assert machining(linearize(rising), top=-2.5).depth == 0  # All cuts are above the top of the stock.


def test_dwells_of_commands_and_cycles_add_time():
    hole = ("G82", {"X": 9.0, "Z": -1.0, "R": 1.0, "F": 5.0, "P": 0.5})
    path = linearize([("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), hole, hole, ("G4", {"P": 2.0}), ("G4", {"P": 750.0})])
    assert path.dwells.tolist() == [[1, 0.5], [2, 0.5], [3, 2], [4, 0.75]] and not path.problems
    found, without = (machining(one, horizontal_rapid=50.0) for one in (path, replace(path, dwells=path.dwells[:0])))
    assert found.dwell_seconds == 3.75 and found.seconds == pytest.approx(without.seconds + 3.75)
    slow = replace(MACHINES["small-mill"], factor=2.0)
    assert machining(path, machine=slow).dwell_seconds == 7.5


def test_unread_timed_commands_make_time_a_lower_bound():
    start, cut = ("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"X": 50.0, "F": 10.0})
    for command, code in (
        (("G1", {"X": 60.0, "A": 90.0}), "rotary-cuts"), (("G0", {"A": 45.0}), "rotary-not-read"),
        (("G38.2", {"Z": -4.0, "F": 1.0}), "probing-untimed"), (("G4", {"S": 2.0}), "dwell-untimed"),
    ):  # fmt: skip
        found = machining(linearize([start, cut, command]), horizontal_rapid=50.0, vertical_rapid=50.0)
        assert [told.arguments["sentence"].code for told in found.left_out] == [code] and not found.complete
    assert machining(linearize([start, cut, ("G999", {})]), horizontal_rapid=50.0, vertical_rapid=50.0).complete


def test_dwells_belong_to_the_next_move_or_to_their_hole():
    lines = [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G4", {"P": 2.0}), ("G1", {"Z": -1.0, "F": 5.0}), ("G4", {"P": 1.0}),
             ("G0", {"Z": 5.0}), ("G82", {"X": 9.0, "Z": -1.0, "R": 2.0, "P": 0.5, "F": 5.0}), ("G4", {"P": 4.0})]  # fmt: skip
    path = linearize(lines)
    found = seconds_of_dwells(path)
    assert found.sum() == machining(path).dwell_seconds == 7.5
    assert found[:2].tolist() == [2.0, 1.0] and found[-1] == 4.5
    assert seconds_of_dwells(path, machine=replace(MACHINES["small-mill"], factor=2.0)).sum() == 15.0
    assert seconds_of_dwells(linearize(lines[1:2])).tolist() == []
