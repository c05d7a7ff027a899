# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measures that the decision trees use, compared with values computed by hand, for drawn toolpaths."""

from __future__ import annotations

from math import hypot, log, log1p, pi, sqrt

import numpy as np
import programs
import pytest
from drawings import polygon, winding

from vkworkbench.core import linearize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.thresholds import WATERLINES
from vkworkbench.core.recognition.verdict.measures import FLAGS, measure_section

TOOL = 6.0
NO_RINGS = {
    **dict.fromkeys((*FLAGS, "hunting", "aside"), 0), "loops": 0, "windings": 0, "ring_step": -1, "roundness": 0, "rings": 0,
    "distinct": 0, "ring_depths": 0, "drift": 0, "ring_length": 0,
}  # fmt: skip
NO_ROWS = {
    "rows": 0, "rows_opposite": 0, "rows_same": 0, "zigzags": 0, "lines_of_rows": 0, "row_count": 0, "row_slender": -1,
    "row_even": -1, "row_length": -1,
}  # fmt: skip
NO_STROKES = {"strokes": 0, "bites": 0, "against": 0, "stroke_slopes": 0, "stroke_length": 0, "stroke_count": 0}


def told(commands):
    return measure_section(Section(monotonous_areas(linearize(commands)), TOOL))


def holds(found, expected):
    assert {name: (found[name], value) for name, value in expected.items() if abs(found[name] - value) > 1e-6} == {}


def test_measures_of_a_zigzag_match_hand_calculation():
    """Ten rows of 50 mm are 3 mm apart. The last row runs in the direction opposite to the first row."""
    found = told(programs.zigzag(10, 50.0, 3.0))
    length, extent, links, turns = 527, hypot(50, 27), 27, 4.5
    holds(found, {
        "wound": 0, "longest_area": 1, "around_areas": 0, "rows_areas": 1, "area_turns": log1p(0.5), "one_turn": 0,
        "closed_areas": 0, "area_v": links / length, "areas": log1p(1), "area_length": log(length / extent), "alike_areas": 0,
        "turned": log1p(turns), "turned_for_length": log1p(turns * extent / length), "net_turn": 0.5 / turns,
        "one_sense": 0.5 / turns,
    })  # fmt: skip
    holds(found, {
        "climbs": 0, "level": 1, "corners": 1, "smooth": 0, "one_way": links / length, "one_axis": (500 - links) / length,
        "two_axes": 1,
    })  # fmt: skip
    # The 18 quarter turns are 9 pairs. Each pair turns in one sense, and is an arc of half a turn.
    holds(found, {
        "half_arcs": 1, "short_arcs": 0, "long_arcs": 0, "sense_keeps": 9 / 17, "surprise": 0,
        "spread": sqrt(90) / 19 * log(50 / 3),
    })  # fmt: skip
    holds(found, {**NO_RINGS, **NO_STROKES})
    holds(found, {
        "rows": 500 / length, "rows_opposite": 450 / length, "rows_same": 0, "zigzags": 1, "lines_of_rows": log1p(10),
        "row_count": log1p(10), "row_slender": log1p(50 / 3), "row_even": 1, "row_length": 50 / extent,
    })  # fmt: skip


def test_measures_of_rings_at_two_depths_match_hand_calculation():
    """Two nested squares are cut at two depths, 1 mm apart. Each square has three quarter turns."""
    found = told(programs.program([polygon(side, z=z) for z in (0.0, -1.0) for side in (40, 34)]))
    length, extent = 2 * 4 * (40 + 34), hypot(40, 40)
    holds(found, {
        "longest_area": 40 / 148, "around_areas": 0, "rows_areas": 0, "area_turns": log1p(0.75), "one_turn": 1, "closed_areas": 1, "area_v": 0,
        "areas": log1p(4), "area_length": log(length / 4 / extent), "turned": log1p(3), "turned_for_length": log1p(3 * extent / length),
        "net_turn": 1, "one_sense": 1, "alike_areas": -log(4 * 2 * (40**2 + 34**2) / 148**2),
    })  # fmt: skip
    holds(found, {"level": 1, "corners": 1, "one_way": 0, "one_axis": 0, "two_axes": 1})
    holds(found, {"half_arcs": 0, "short_arcs": 0, "sense_keeps": 1, "surprise": 0, "spread": log(40 / 34) / 2})
    holds(found, {
        "loops": 1, "windings": 0, "roundness": pi / 4, "rings": log1p(4), "distinct": 0.5, "ring_depths": log1p(2),
        "ring_step": log1p(100 * 3 / extent), "drift": 0, "ring_length": 148 / extent, "nested": 1, "deeper": 0, "alone": 0,
        "sloped": 0, "round": 0, "crossing": 0, "evenness": 0,
    })  # fmt: skip
    holds(found, NO_STROKES)


def test_evenness_of_rings_at_equal_depth_steps_is_measured():
    """The offsets are 2, 3 and 4 mm. The 10th and 90th percentiles of these three offsets are 2.2 and 3.8 mm."""
    found = told(programs.program([polygon(side, z=-1.0 * k) for k, side in enumerate((40, 36, 30, 22))]))
    holds(
        found, {"evenness": log1p(1 + 1.6 / 3 / WATERLINES.ROUNDING), "ring_depths": log1p(4), "deeper": 1, "nested": 0}
    )


def test_measures_of_one_ring_match_hand_calculation():
    found = told(programs.program([polygon(40)]))
    holds(found, {"rings": log1p(1), "distinct": 1, "ring_length": 160 / hypot(40, 40), "drift": 0, "sense_keeps": 1})
    holds(found, {**NO_ROWS, **NO_STROKES})


def test_drift_is_1_for_circles_moving_along_a_straight_line():
    """Circles of 10 mm are cut 2 mm apart on a straight line."""
    found = told(programs.program([polygon(20, x=2.0 * k, corners=48) for k in range(12)]))
    holds(found, {"drift": 1, "rings": log1p(12), "loops": 1, "smooth": 1, "corners": 0, "distinct": 1, "long_arcs": 1})
    assert found["roundness"] == pytest.approx(1, abs=0.01)
    there = [2.0 * k for k in range(6)]
    back = told(programs.program([polygon(20, x=x, corners=48) for x in (*there, *there[::-1])]))
    assert back["drift"] == pytest.approx(0, abs=1e-9)


def test_measures_of_open_strokes_match_hand_calculation():
    """Four bent strokes have 20 mm each. The last stroke rises by 1 in 10."""
    strokes = [
        [(30.0 * k, 0.0, 0.0), (30.0 * k + 10.0, 0.0, (k == 3) * 1.0), (30.0 * k + 10.0, 10.0, (k == 3) * 2.0)]
        for k in range(4)
    ]
    found = told(programs.program(strokes))
    slanting = hypot(10, 0)
    assert slanting == 10  # Lengths are measured in the XY plane.
    holds(found, {
        "strokes": 1, "stroke_count": log1p(4), "climbs": 2 / 80, "level": 0.75, "areas": log1p(4), "alike_areas": 0,
        "closed_areas": 0, "area_v": hypot(10, 10) / 20, "one_way": hypot(40, 40) / 80, "one_axis": 0, "two_axes": 1,
        "longest_area": 0.25, "net_turn": 1, "one_sense": 1,
    })  # fmt: skip
    holds(found, NO_RINGS)
    extent = hypot(100, 0)
    holds(found, {"stroke_length": 20 / extent, "stroke_slopes": 0.25})


def test_left_and_right_turns_cancel_only_in_the_signed_measure():
    """One stroke bends to the left, and one stroke to the right."""
    found = told(programs.program([[(0, 0, 0), (10, 0, 0), (10, 10, 0)], [(50, 0, 0), (60, 0, 0), (60, -10, 0)]]))
    holds(found, {"net_turn": 1, "one_sense": 0, "sense_keeps": 0, "short_arcs": 1, "turned": log1p(0.5)})


@pytest.mark.parametrize("aside, keeps", [(20, 1), (-20, 0)])
def test_share_of_turns_in_the_sense_of_the_turn_before_is_found(aside, keeps):
    found = told(programs.program([[(0, 0, 0), (20, 0, 0), (20, 20, 0), (20 - aside, 20, 0)]]))
    holds(found, {"sense_keeps": keeps})


@pytest.mark.parametrize("gap, closed", [(1.5, 1), (1.7, 0)])
def test_area_with_a_gap_below_two_percent_is_closed(gap, closed):
    """The contour's length is about 80 mm, and two percent of it are 1.6 mm."""
    around = [(0, 0, 0), (20, 0, 0), (20, 20, 0), (0, 20, 0), (0, gap, 0)]
    assert told(programs.program([around]))["closed_areas"] == closed


def test_star_in_one_stroke_turns_more_than_once():
    """The star turns at four of its five corners by 144 degrees each, in all 1.6 turns."""
    star = [(20 * np.cos(angle), 20 * np.sin(angle), 0.0) for angle in 0.8 * np.pi * np.arange(6)]
    holds(told(programs.program([star])), {"closed_areas": 1, "one_turn": 0, "area_turns": log1p(1.6), "long_arcs": 1})


@pytest.mark.parametrize(
    "degrees, kinds",
    [(100, "short"), (112, ""), (140, ""), (148, "half"), (212, "half"), (220, ""), (265, ""), (275, "long")],
)
def test_arcs_are_classified_as_short_half_or_long_by_their_turn(degrees, kinds):
    """A stroke bends in one sense by some degrees.

    The limits in turns are: short up to 0.3, half from 0.4 to 0.6, long from 0.75.
    """
    heading = np.radians(degrees) / 4 * np.arange(5)
    points = np.cumsum(np.column_stack((np.cos(heading), np.sin(heading), 0 * heading)) * 10, axis=0)
    found = told(programs.program([[(0.0, 0.0, 0.0), *points.tolist()]]))
    holds(found, {f"{kind}_arcs": kind == kinds for kind in ("short", "half", "long")})


@pytest.mark.parametrize("turn, keeps", [(1.5e-4, 1), (0.7e-4, 0)])
def test_turn_below_a_ten_thousandth_counts_as_straight(turn, keeps):
    heading = turn * np.arange(5)
    points = np.cumsum(np.column_stack((np.cos(heading), np.sin(heading), 0 * heading)) * 1000, axis=0)
    holds(told(programs.program([[(0.0, 0.0, 0.0), *points.tolist()]])), {"sense_keeps": keeps})


@pytest.mark.parametrize("other, surprise", [(14.5, 0), (15.5, log(2))])
def test_turns_in_one_class_of_fifteen_degrees_count_as_equal(other, surprise):
    heading = np.radians(np.cumsum([0, 14, other, 14, other]))
    points = np.cumsum(np.column_stack((np.cos(heading), np.sin(heading), 0 * heading)) * 10, axis=0)
    holds(told(programs.program([[(0.0, 0.0, 0.0), *points.tolist()]])), {"surprise": surprise})


def test_surprise_is_the_entropy_of_the_turning_angles():
    """Turns by 1.7 rad and by 0.6 rad are equally frequent."""
    stroke, heading = [(0.0, 0.0)], 0.0
    for k in range(17):
        x, y = stroke[-1]
        stroke.append((x + 10 * np.cos(heading), y + 10 * np.sin(heading)))
        heading += (1.7, 0.6, -1.7, -0.6)[k % 4]
    found = told(programs.program([[(x, y, 0.0) for x, y in stroke]]))
    assert found["surprise"] == pytest.approx(log(2)) and found["spread"] == pytest.approx(0, abs=1e-6)
    assert found["sense_keeps"] == pytest.approx(8 / 15)


def test_turns_are_sampled_from_the_middle_strokes():
    """Bent strokes of three moves turn left and right alternately.

    The moves of the first and the last 150 strokes are longer.
    """
    strokes = []
    for k in range(150 + 667 + 150):
        long, side = 10.0 if 150 <= k < 150 + 667 else 20.0, 1 - 2 * (k % 2)
        strokes.append([(0, 0, 0), (long, 0, 0), (long, side * long, 0), (0, side * long, 0)])
    found = told(programs.program(strokes))
    holds(found, {"spread": 0, "sense_keeps": 1})


@pytest.mark.parametrize(("corners", "smooth"), [(23, 0), (25, 1)])
def test_turns_by_less_than_fifteen_degrees_are_smooth(corners, smooth):
    holds(told(programs.program([polygon(20, corners=corners)])), {"smooth": smooth, "corners": 0})


def test_measures_of_straight_strokes_have_no_turns():
    found = told(programs.program([[(0, 0, 0), (10, 0, 0)], [(0, 20, 0), (20, 20, 0)]]))
    holds(found, {
        "half_arcs": 0, "short_arcs": 0, "long_arcs": 0, "sense_keeps": 0, "surprise": 0, "spread": log(2) / 2, "turned": log1p(0.02 / (2 * pi)),
        "corners": 0, "smooth": 0,
    })  # fmt: skip


@pytest.mark.parametrize("rows", [(3.0, 3.0), (3.0, 5.0)])
def test_measures_of_a_grid_combine_the_rows_along_both_axes(rows):
    """Measures that are sums include the rows along both axes; proportions describe only the axis with longer rows."""
    step, other = rows
    across = [[(0.0, step * k, 0.0), (60.0, step * k, 0.0)] for k in range(12)]
    down = [[(other * k, 0.0, 0.0), (other * k, 33.0, 0.0)] for k in range(12)]
    found = told(programs.program(across + down))
    length = 12 * (60 + 33)
    holds(found, {
        "rows": 1, "rows_same": (11 * 60 + 11 * 33) / length, "rows_opposite": 0, "row_count": log1p(24), "lines_of_rows": log1p(12),
        "row_slender": log1p(60 / step), "row_even": 1,
    })  # fmt: skip


@pytest.mark.parametrize(("turns", "around"), [(0.9, 0), (1.5, 1)])
def test_path_of_more_than_one_full_turn_counts_as_winding(turns, around):
    spiral, straight = winding(30.0, 12.0, turns), [(200.0, 0.0, 0.0), (250.0, 0.0, 0.0)]
    length = sum(hypot(b[0] - a[0], b[1] - a[1]) for a, b in zip(spiral, spiral[1:]))
    holds(told(programs.program([spiral, straight])), {"around_areas": around * length / (length + 50)})


def test_share_of_spirals_is_their_length_over_the_total_length():
    spiral = winding(30.0, 12.0, 3)
    rows = [(200.0 + x, 3.0 * row, 0.0) for row in range(6) for x in ((0.0, 40.0), (40.0, 0.0))[row % 2]]
    around, straight = (sum(hypot(b[0] - a[0], b[1] - a[1]) for a, b in zip(of, of[1:])) for of in (spiral, rows))
    found = told(programs.program([spiral, rows]))
    holds(found, {"windings": around / (around + straight), "loops": 0, "rows": 240 / (around + straight)})
