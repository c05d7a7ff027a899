# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bites of adaptive clearing are open strokes that bend in the usual sense and overlap the previous or next stroke."""

from __future__ import annotations

import math

import numpy as np
import programs
import pytest
from drawings import arc

from vkworkbench.core import linearize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.patterns.pieces import STROKE, cut_pieces
from vkworkbench.core.recognition.patterns.strokes import relate_strokes


def wavy(x):
    """Return an arc with the net bend of a bite, which turns back by more than half a turn on its way."""
    points, heading = [(50.0 + x, 0.0, 0.0)], 0.0
    for bend in [0.5, 0.5, 0.5, -0.5, -0.5, -0.5, -0.5, 0.5, 0.5, 0.5, 0.5] + [0.2] * 12:
        heading += bend
        points.append((points[-1][0] + 2 * math.cos(heading), points[-1][1] + 2 * math.sin(heading), 0.0))
    return points


def strokes_of(strokes):
    pieces = cut_pieces(monotonous_areas(linearize(programs.program(strokes))))
    assert (pieces.kind == STROKE).all() and len(pieces) == len(strokes)
    return relate_strokes(pieces, np.arange(len(pieces)))


def bites(*strokes):
    found = strokes_of(strokes)
    return "".join("b" if bite else "a" if against else "-" for bite, against in zip(found.bite, found.against))


def test_arcs_that_overlap_the_next_arc_are_bites():
    assert bites(arc(0), arc(2), arc(4), arc(6)) == "bbbb"
    assert bites(arc(0, 0), arc(0, 2), arc(0, 4)) == "bbb"


def test_arc_far_from_its_neighbours_is_not_a_bite():
    assert bites(arc(0), arc(2), arc(100), arc(200), arc(202)) == "bb-bb"
    # Arcs that are close along X only, or along Y only, do not overlap.
    assert bites(arc(0, 0), arc(0, 100), arc(100, 100)) == "---"
    assert bites(arc(0, 0), arc(0, 2), arc(0, -100), arc(-100, -100)) == "bb--"


def test_arcs_at_another_depth_do_not_overlap():
    assert bites(arc(0), arc(2, z=-2.0), arc(4, z=-4.0)) == "---"
    assert bites(arc(0), arc(2), arc(4, z=-2.0)) == "bb-"


def test_stroke_that_bends_less_than_a_quarter_is_not_a_bite():
    assert bites(arc(0, turns=0.2), arc(2, turns=0.2)) == "--"
    assert bites(arc(0), arc(1, turns=0.2), arc(2)) == "b-b"  # A short arc does not separate bites.
    assert bites([(0, 0, 0), (20, 0, 0)], [(0, 1, 0), (20, 1, 0)]) == "--"


def test_arc_bent_in_the_other_sense_counts_against_bites():
    assert bites(arc(0), arc(2), arc(4), arc(100, clockwise=True)) == "bbba"
    assert bites(arc(0, clockwise=True), arc(2, clockwise=True), arc(4, clockwise=True), arc(6)) == "bbba"


def test_longer_strokes_decide_the_sense_of_bites():
    assert (
        bites(arc(0, radius=40), arc(2, radius=40), *(arc(30 + i, radius=4, clockwise=True) for i in range(5)))
        == "bbaaaaa"
    )


def led_out(x):
    """Return an arc that leaves the wall on a bend of 40 degrees in the other direction."""
    points = arc(x)
    heading = math.atan2(points[-1][1] - points[-2][1], points[-1][0] - points[-2][0])
    for _ in range(4):
        heading -= math.radians(10)
        points.append((points[-1][0] + math.cos(heading), points[-1][1] + math.sin(heading), 0.0))
    return points


def test_stroke_that_turns_back_is_not_a_bite():
    assert bites(led_out(0.0), led_out(1.0)) == "bb"
    assert bites(wavy(0.0), wavy(1.0)) == "--"


def test_slopes_depths_and_distinct_strokes_are_counted():
    found = strokes_of([arc(0), arc(0, z=-2.0), arc(50, z=-2.0), arc(100, drop=1.0)])
    assert found.sloped.tolist() == [False, False, False, True]
    assert (found.distinct, found.depths) == (3, 2)  # The depths of sloped strokes are left out.
    assert found.typical == pytest.approx(0.4 * 2 * math.pi * 10, rel=0.01)


def test_typical_stroke_length_weights_strokes_by_length():
    found = strokes_of([*(arc(30.0 * i, radius=1) for i in range(5)), arc(0, 200, radius=10), arc(0, 300, radius=10)])
    assert found.typical == pytest.approx(0.4 * 2 * math.pi * 10, rel=0.01)


def test_section_without_strokes_has_no_bites():
    found = relate_strokes(cut_pieces(monotonous_areas(linearize(programs.program([arc(0)])))), np.zeros(0, np.int64))
    assert (len(found), found.distinct, found.depths, found.typical) == (0, 0, 0, 0.0)
    assert len(found.bite) == len(found.against) == len(found.sloped) == 0
