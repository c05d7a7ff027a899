# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contours that are lifted over holding tags are joined to closed contours."""

from __future__ import annotations

import math

import numpy as np
import programs
import pytest

from vkworkbench.core import Strategy, linearize, recognize
from vkworkbench.core.paper import TURN, monotonous_areas
from vkworkbench.core.recognition.patterns.tags import _goes_on, joined_over_tags

CORNERS = [(0.0, 0.0), (120.0, 0.0), (120.0, 80.0), (0.0, 80.0)]
TAG = 6.0


def parts_of_sides(z=-3.0, tags=2, begin=0.0):
    """Return the strokes around a rectangle, lifted over tags. The first stroke starts `begin` mm after a corner."""
    strokes, stroke = [], [(begin, 0.0, z)]
    for (x, y), (u, v) in zip(CORNERS, CORNERS[1:] + CORNERS[:1]):
        length = math.dist((x, y), (u, v))
        along = (u - x) / length, (v - y) / length
        for k in range(tags):
            middle = length * (k + 1) / (tags + 1)
            before, behind = ((x + a * along[0], y + a * along[1], z) for a in (middle - TAG / 2, middle + TAG / 2))
            strokes.append([*stroke, before])
            stroke = [behind]
        stroke.append((u, v, z))
    return [*strokes, stroke + [(begin, 0.0, z)] * (begin > 0)]


def areas(strokes):
    return monotonous_areas(linearize(programs.program(strokes)))


def joined(strokes):
    return joined_over_tags(areas(strokes))[0]


@pytest.mark.parametrize("tags", [1, 2, 3])
@pytest.mark.parametrize("begin", [0.0, 20.0])
def test_strokes_between_tags_are_one_closed_contour(tags, begin):
    parts = parts_of_sides(tags=tags, begin=begin)
    assert len(areas(parts).start) == 4 * tags + 1
    around = joined(parts)
    assert len(around.start) == 1 and around.closed.all() and len(around) == len(areas(parts))
    assert around.area_length == pytest.approx([400.0])
    # If the contour begins at a corner, phi does not include the turn from the last side to the first side.
    assert around.phi[-1] == pytest.approx(TURN if begin else TURN * 3 / 4)
    assert around.phi.max() - around.phi.min() == pytest.approx(around.phi[-1])


def test_tagged_contour_may_begin_and_end_at_a_tag():
    parts = parts_of_sides()
    parts = [*parts[1:-1], [*parts[-1], *parts[0][1:]]]
    around = joined(parts)
    assert len(around.start) == 1 and around.closed.all() and around.area_length == pytest.approx([400.0])


def test_two_strokes_between_two_tags_are_a_contour():
    right, left = [(63, 0), (120, 0), (120, 80), (63, 80)], [(57, 80), (0, 80), (0, 0), (57, 0)]
    around = joined([[(x, y, -3.0) for x, y in part] for part in (right, left)])
    assert len(around.start) == 1 and around.closed.all() and around.area_length == pytest.approx([400.0])


@pytest.mark.parametrize("chords", [12, 90])
def test_circle_over_tags_is_one_contour(chords):
    """Each of the three holding tags spans 17 degrees of the circle."""
    ends = [(k * 120.0 + 17, (k + 1) * 120.0) for k in range(3)]
    arcs = [
        [(30 * math.cos(a), 30 * math.sin(a), -2.0) for a in np.radians(np.linspace(*end, chords // 3 + 1))]
        for end in ends
    ]
    around = joined(arcs)
    assert len(around.start) == 1 and around.closed.all()
    assert recognize(linearize(programs.program(arcs))).strategy is Strategy.PROFILE


def test_strokes_over_tags_belong_to_the_contour():
    """Estlcam cuts across each tag in a separate stroke, and plunges after the tag."""
    parts = parts_of_sides(tags=1)
    strokes = []
    for stroke, following in zip(parts, [*parts[1:], None]):
        strokes.append(stroke)
        if following:
            strokes.append([(*stroke[-1][:2], 0.0), (*following[0][:2], 0.0)])
    around = joined(strokes)
    assert len(around.start) == 1 and around.closed.all() and around.area_length == pytest.approx([400.0])


def test_tagged_contour_is_repeated_at_each_depth():
    strokes = [stroke for z in (-1.0, -2.0, -3.0) for stroke in parts_of_sides(z)]
    for tool in (None, 6.0):
        found = recognize(linearize(programs.program(strokes)), tool_diameter=tool)
        assert (found.strategy, found.depths) == (Strategy.PROFILE, 3), found.reason


@pytest.mark.parametrize("to_and_fro", [False, True])
@pytest.mark.parametrize("tool", [None, 6.0])
def test_strokes_between_tags_form_a_contour_at_each_depth(to_and_fro, tool):
    """Programs for circuit boards cut a stroke between two bridges at all depths before they cut the next stroke."""
    depths = (-1.0, -2.0, -3.0)
    turns = [parts_of_sides(z, tags=1) for z in depths]
    strokes = [part[::-1] if to_and_fro and k % 2 else part for stroke in zip(*turns) for k, part in enumerate(stroke)]
    row = [(0.0, 200.0, -3.0), (50.0, 200.0, -3.0)]
    moves, around = areas([*strokes, row]), joined([*strokes, row])
    by_depth = joined([*(part for turn in turns for part in turn), row])
    for name in ("x", "y", "z", "dx", "dy", "dz", "phi", "start"):
        assert getattr(around, name) == pytest.approx(getattr(by_depth, name)), name
    assert np.array_equal(around.index, moves.index)
    found = recognize(linearize(programs.program(strokes)), tool_diameter=tool)
    assert (found.strategy, found.depths) == (Strategy.PROFILE, 3), found.reason
    assert "over 3 loops at 3 depths, cut in strokes, as between holding tags" in found.reason


def test_unequal_strokes_and_deep_rows_are_not_a_contour():
    sides = parts_of_sides(tags=1)
    deeper = [[(x, y, z - 1.0) for x, y, z in part] for part in sides]
    assert unchanged([part for k, two in enumerate(zip(sides, deeper)) for part in two[: 1 + k % 2]])
    deepest = [[(x, y, z - 2.0) for x, y, z in part] for part in sides]
    assert unchanged([part for k, all_ in enumerate(zip(sides, deeper, deepest)) for part in all_[: 2 + k % 2]])
    rows = [[(0.0, 3.0 * y, z), (40.0, 3.0 * y, z)] for y in range(8) for z in (-1.0, -2.0)]
    assert unchanged(rows) and unchanged([row[::-1] if k % 2 else row for k, row in enumerate(rows)])


@pytest.mark.parametrize("tags", [1, 2, 3])
@pytest.mark.parametrize("tool", [None, 6.0])
def test_tagged_contour_is_a_profile(tags, tool):
    found = recognize(linearize(programs.program(parts_of_sides(tags=tags))), tool_diameter=tool)
    assert found.strategy is Strategy.PROFILE and found.confidence > 0.9, found.reason
    assert "over one loop, cut in strokes, as between holding tags: profile" in found.reason


def unchanged(strokes):
    moves = areas(strokes)
    found, share = joined_over_tags(moves)
    assert (share == 0.0) == (found is moves)
    return found is moves


def test_rows_interrupted_by_an_island_are_not_a_contour():
    rows = [[(a, 3.0 * y, 0.0), (b, 3.0 * y, 0.0)] for y in range(8) for a, b in ((0.0, 40.0), (60.0, 100.0))]
    assert unchanged(rows)
    assert unchanged([stroke[::-1] if k // 2 % 2 else stroke for k, stroke in enumerate(rows)])


def test_strokes_back_and_forth_on_a_line_are_not_a_contour():
    """The ends of the strokes meet, but at half-turns, and rounding decides about their sign."""
    for angle in np.linspace(0, 3, 7):
        end = 40 * math.cos(angle), 40 * math.sin(angle)
        there = [(0.0, 0.0, -1.0), (*end, -1.0)]
        assert unchanged([there, there[::-1]]) and unchanged([there, there[::-1], there, there[::-1]])


def test_move_as_short_as_a_rounding_gap_in_a_contour_is_kept():
    """The short move is as long as the gap between its end and the start of the next stroke."""
    sides = [[(0.0, 0.0, -1.0), (40.0, 0.0, -1.0)], [(40.0, 30.0, -1.0), (0.0, 30.0, -1.0), (0.0, 0.0, -1.0)]]
    short, up = [(40.0, 0.0, -1.0), (40.0, 0.015, -1.0)], [(40.0, 0.0, -1.0), (40.0, 30.0, -1.0)]
    around = joined([sides[0], short, up, sides[1]])
    assert len(around.start) == 1 and around.length.min() == pytest.approx(0.015)


def test_strokes_that_do_not_continue_are_not_a_contour():
    assert not unchanged(parts_of_sides())
    assert unchanged(parts_of_sides()[::-1])
    assert unchanged(parts_of_sides()[:-1])
    aside = [[(x, y + 5.0 * (k % 2), z) for x, y, z in part] for k, part in enumerate(parts_of_sides())]
    assert unchanged(aside)
    corners = [[(x + 40 * a, y + 40 * b, 0.0) for a, b in ((0, 0.1), (0, 0), (0.1, 0))] for x, y in ((0, 0),)]
    assert unchanged(corners)


def test_closed_contours_are_not_joined():
    """Two contours share a corner, and each contour is already closed."""
    one = [(0.0, 0.0, 0.0), (30.0, 0.0, 0.0), (30.0, 30.0, 0.0), (0.0, 30.0, 0.0), (0.0, 0.0, 0.0)]
    assert unchanged([one, [(-x, -y, z) for x, y, z in one]]) and unchanged([one])


def test_reason_depends_on_the_length_of_strokes_between_tags():
    hole = [(300.0, 0.0, -3.0), (330.0, 0.0, -3.0), (330.0, 30.0, -3.0), (300.0, 30.0, -3.0), (300.0, 0.0, -3.0)]
    parts = parts_of_sides()
    length = 400.0 - 8 * TAG
    assert joined_over_tags(areas([*parts, hole]))[1] == pytest.approx(length / (length + 120))
    for holes, seen in ((1, "cut in strokes, as between holding tags"), (4, "no nested offsets")):
        others = [[(x + 40.0 * k, y, z) for x, y, z in hole] for k in range(holes)]
        found = recognize(linearize(programs.program([*parts, *others])), tool_diameter=6.0)
        assert found.strategy is Strategy.PROFILE and seen in found.reason, found.reason


@pytest.mark.parametrize(
    ("one", "two", "onward"),
    [
        ([(0, 0), (40, 0)], [(46, 0), (90, 0)], True),
        ([(0, 0), (40, 0)], [(40, 0), (40, 50)], True),  # The second stroke turns a corner at the end of the first.
        ([(0, 0), (40, 0)], [(46, 2.5), (90, 2.5)], True),  # The tag is on a bend.
        ([(0, 0), (40, 0)], [(46, 3.5), (90, 3.5)], False),
        ([(0, -40), (40, 0)], [(46, 0), (90, 0)], False),  # Only the second stroke has the direction of the gap.
        ([(0, 0), (40, 0)], [(46, 0), (90, 40)], False),  # Only the first stroke has the direction of the gap.
        ([(0, 0), (40, 0)], [(34, 0), (90, 0)], False),  # The second stroke starts before the end of the first.
        ([(0, 0), (40, 0)], [(40, 0), (0, 0)], False),
        ([(0, 0), (40, 0)], [(40.01, 0), (0, 0.001)], False),  # The direction reverses, apart from a rounding error.
        ([(0, 0), (40, 0)], [(79, 0), (89, 0)], True),  # The gap is shorter than the longer stroke.
        ([(0, 0), (10, 0)], [(49, 0), (89, 0)], True),
        ([(0, 0), (40, 0)], [(81, 0), (91, 0)], False),
    ],
)
def test_stroke_continues_another_in_its_direction(one, two, onward):
    moves = areas([[(x + 5.0, y + 5.0, 0.0) for x, y in stroke] for stroke in (one, two)])
    assert len(moves.start) == 2
    assert _goes_on(moves, np.array([0]), np.array([1])).tolist() == [onward]


def test_contours_beside_a_contour_with_tags_are_unchanged():
    hole = [(300.0, 0.0, -3.0), (330.0, 0.0, -3.0), (330.0, 30.0, -3.0), (300.0, 30.0, -3.0), (300.0, 0.0, -3.0)]
    row = [(0.0, 200.0, -3.0), (50.0, 200.0, -3.0)]
    for strokes, starts in (
        ([hole, *parts_of_sides(), row], [0, 4, 16]),
        # The strokes at two depths are joined to one path of two turns.
        ([row, *parts_of_sides(), *parts_of_sides(z=-4.0), hole], [0, 1, 25]),
    ):
        moves = areas(strokes)
        around = joined_over_tags(moves)[0]
        assert around.start.tolist() == starts and len(around) == len(moves)
        for k in np.flatnonzero(np.isin(moves.area_length, (120.0, 50.0))):
            at = slice(moves.start[k], moves.end[k])
            assert np.array_equal(around.dx[at], moves.dx[at]) and np.array_equal(around.phi[at], moves.phi[at])
