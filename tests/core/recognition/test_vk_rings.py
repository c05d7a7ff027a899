# SPDX-License-Identifier: LGPL-2.1-or-later
"""Relations between rings (nested, repeated, deeper) of drawn loops, on which the strategy depends."""

from __future__ import annotations

import math

import numpy as np
import programs
import pytest
from drawings import polygon, winding

from vkworkbench.core import linearize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.patterns.nesting import evenness
from vkworkbench.core.recognition.patterns.pieces import LOOP, STROKE, WINDING, ZIGZAG, cut_pieces
from vkworkbench.core.recognition.patterns.rings import _equal, _shapes, relate_rings

TOOL = 6.0
RELATIONS = ("nested", "deeper", "repeated", "moved", "crossing")


def rings_of(strokes, tool=TOOL):
    """Return the rings of a toolpath of strokes, which are lists of points (x, y, z)."""
    pieces = cut_pieces(monotonous_areas(linearize(programs.program(strokes))))
    return relate_rings(pieces, np.flatnonzero(np.isin(pieces.kind, (LOOP, WINDING))), tool)


def related(rings):
    """Return the names of the relations of each ring to other rings, as a list of sets."""
    return [{name for name in RELATIONS if getattr(rings, name)[i]} for i in range(len(rings))]


@pytest.mark.parametrize("sides, growing", [((40, 36, 32, 28), 0.0), ((28, 32, 36, 40), 1.0)])
def test_offsets_are_nested_a_stepover_apart(sides, growing):
    rings = rings_of([polygon(side) for side in sides])
    assert related(rings) == [{"nested"}] * len(sides)
    assert rings.step == pytest.approx(2.0) and rings.growing == growing
    assert not rings.alone.any() and not rings.opposite.any()
    assert (rings.depths, rings.distinct, rings.depth_range) == (1, len(sides), 0.0)


@pytest.mark.parametrize(("inward", "relation"), [(0.2, "repeated"), (0.3, "deeper")])
def test_large_ring_repeats_at_depth_within_a_quarter_mm(inward, relation):
    """The tolerance is 0.05 mm and two thousandths of the ring's 100 mm."""
    assert related(rings_of([polygon(100), polygon(100 - 2 * inward, z=-1.0)])) == [{relation}] * 2


@pytest.mark.parametrize(("inward", "relation"), [(0.85, "repeated"), (0.95, "deeper")])
def test_large_ring_a_quarter_reach_inside_is_another_ring(inward, relation):
    """The largest stepover of a tool of 3 mm is 3.6 mm.

    Two thousandths of the ring's 1000 mm would be 2 mm, which is too much.
    """
    assert related(rings_of([polygon(1000), polygon(1000 - 2 * inward, z=-1.0)], 3.0)) == [{relation}] * 2


@pytest.mark.parametrize("side", [60, 600])
def test_offset_distance_does_not_depend_on_part_size(side):
    """The rings are offset by a fifth of the tool's diameter.

    For the larger part, the step is only 0.2 % of the part's size.
    """
    rings = rings_of([polygon(side - 2.4 * i) for i in range(5)])
    assert related(rings) == [{"nested"}] * 5 and rings.step == pytest.approx(1.2)


@pytest.mark.parametrize("nests", [1, 2, 3])
def test_island_rings_may_interrupt_boundary_rings(nests):
    strokes = [polygon(side, x=100 * nest) for side in (40, 36, 32, 28) for nest in range(nests)]
    rings = rings_of(strokes)
    assert related(rings) == [{"nested"}] * len(strokes)
    assert rings.step == pytest.approx(2.0) and rings.growing == 0.0


def test_rings_of_four_pockets_cut_alternately_are_not_compared():
    rings = rings_of([polygon(side, x=100 * nest) for side in (40, 36, 32) for nest in range(4)])
    assert rings.alone.all() and math.isnan(rings.step) and math.isnan(rings.growing)


@pytest.mark.parametrize("apart, nested", [(6.9, True), (7.5, False)])
def test_loops_beyond_tool_width_are_two_contours(apart, nested):
    rings = rings_of([polygon(60), polygon(60 - 2 * apart)])
    assert rings.nested.tolist() == [nested, nested] and rings.alone.tolist() == [not nested] * 2


def comb(wide, deep):
    """Return the contour of a comb of 150 x 40 mm. Gaps are `wide` and `deep`, and teeth are as wide as gaps."""
    points = [(150, 40), (0, 40), (0, 0)]
    for gap in np.arange(wide, 150 - wide, 2 * wide):
        points += [(gap, 0), (gap, deep), (gap + wide, deep), (gap + wide, 0)]
    return [(x, y, 0.0) for x, y in [*points, (150, 0), (150, 40)]]


@pytest.mark.parametrize(("wide", "deep", "nested"), [(2, 0.2, True), (4, 5, True), (2, 12, False)])
def test_frame_around_comb_is_offset_if_equally_long(wide, deep, nested):
    """An offset closes gaps of up to twice its distance, but a contour three times as long is not an offset."""
    frame = [(-2, -2, 0.0), (152, -2, 0.0), (152, 42, 0.0), (-2, 42, 0.0), (-2, -2, 0.0)]
    assert rings_of([frame, comb(wide, deep)]).nested.tolist() == [nested] * 2


def test_ring_around_island_is_not_an_offset():
    assert not rings_of([polygon(40), polygon(36, x=2)]).nested.any()


def box(left, bottom, right, top):
    """Return a rectangle whose sides lie inside the sides of a square of 40 mm by the given distances, mm."""
    x, y, u, v = 50 + left, -60 + bottom, 90 - right, -20 - top
    return [(x, y, 0), (u, y, 0), (u, v, 0), (x, v, 0), (x, y, 0)]


def test_rings_with_three_common_sides_are_not_nested():
    for pair in ([box(3, 0, 0, 0), polygon(40)], [polygon(40), box(3, 0, 0, 0)]):
        assert related(rings_of(pair)) == [set()] * 2


@pytest.mark.parametrize("left, nested", [(0.9, False), (1.1, True)])
def test_each_side_of_an_offset_moves_by_at_least_half_the_step(left, nested):
    """The left side moves by 0.9 or 1.1 mm, the other sides by 2.4 mm.

    The mean distance of the four sides is 2.03 or 2.08 mm.
    """
    assert rings_of([polygon(40), box(left, 2.4, 2.4, 2.4)]).nested.tolist() == [nested] * 2


def squares(*steps, first=300.0):
    """Return nested squares; `steps` are the distances from each square to the next, mm."""
    return [polygon(first - 2 * inside) for inside in np.cumsum([0.0, *steps])]


@pytest.mark.parametrize("steps", [[10] * 5, [10, 10, 10, 19, 19, 19]])
@pytest.mark.parametrize("tool, nested", [(6.0, False), (0.0, True)])
def test_even_steps_are_a_pocket_without_a_tool(steps, tool, nested):
    """The steps are larger than the largest stepover of a tool of 6 mm, and less than twice the usual step."""
    assert rings_of(squares(*steps), tool).nested.tolist() == [nested] * (len(steps) + 1)


def test_contour_at_several_depths_is_one_ring():
    rings = rings_of([polygon(40, z=z) for z in (0, -2, -4)])
    assert related(rings) == [{"repeated"}] * 3 and rings.stacked.all()
    assert (rings.depths, rings.distinct, rings.depth_range) == (3, 1, 4.0)


def test_rings_of_a_pocket_at_two_depths_are_not_stacked():
    rings = rings_of([polygon(side, z=z) for z in (0, -2) for side in (48, 44, 40, 36, 32)])
    assert related(rings) == [{"nested", "repeated"}] * 10
    assert not rings.stacked.any()
    assert (rings.depths, rings.distinct, rings.depth_range, rings.evenness) == (2, 5, 2.0, 0.0)


def test_contours_are_repeated_even_if_one_has_no_repeat():
    rings = rings_of(
        [polygon(20, x=x, z=z) for z in (0, -2) for x in (0, 100, 200, 300, 400, 500)] + [polygon(20, x=900)]
    )
    assert related(rings)[:12] == [{"repeated"}] * 12 and related(rings)[12] == set()


def test_contours_that_grow_with_depth_have_the_relation_deeper():
    rings = rings_of([polygon(20 + 4 * i, z=-float(i)) for i in range(6)])
    assert related(rings) == [{"deeper"}] * 6
    assert (rings.depths, rings.distinct, rings.depth_range) == (6, 6, 5.0)
    assert math.isnan(rings.step)


def test_evenness_is_measured_from_three_depths_on():
    rings = rings_of([polygon(20 + 4 * i, z=-float(min(i, 2))) for i in range(4)])
    assert rings.depths == 3 and 0 < rings.evenness < 0.1


@pytest.mark.parametrize("side, relation", [(200, "repeated"), (20, "deeper")])
def test_tolerance_of_repeated_rings_grows_with_their_size(side, relation):
    assert related(rings_of([polygon(side), polygon(side - 0.6, z=-2)])) == [{relation}] * 2


def test_deeper_contour_in_another_place_has_no_relation():
    assert rings_of([polygon(20), polygon(24, x=300, z=-2)]).alone.all()
    # The deeper contour overlaps the upper contour only at a corner, and is not a wall of the same part.
    assert rings_of([polygon(20), polygon(20, x=15, z=-2)]).deeper.all()
    assert rings_of([polygon(20), polygon(20, x=25, z=-2)]).alone.all()


@pytest.mark.parametrize(
    "step, size, moves", [(0.25, 1.0, True), (9.0, 1.0, True), (6.0, 1.1, True), (11.0, 1.0, False), (1.0, 0.5, False)]
)
def test_overlapping_circles_of_one_size_are_moved_rings(step, size, moves):
    rings = rings_of([polygon(16 * size**i, x=step * i, corners=24) for i in range(6)])
    assert rings.moved.tolist() == [moves] * 6
    assert moves or not rings.repeated.any()


def test_overlapping_circles_at_other_depths_are_not_moved_rings():
    assert not rings_of([polygon(16, x=2.0 * i, z=-2.0 * i, corners=24) for i in range(6)]).moved.any()


def test_loops_around_separate_ribs_are_not_moved_rings():
    # Loops side by side do not overlap if they are narrower than the step between them.
    for apart, moves in ((4.5, False), (3.5, True)):
        rings = rings_of([polygon(4, x=apart * i, ratio=10) for i in range(6)])
        assert rings.moved.tolist() == [moves] * 6


@pytest.mark.parametrize("width, moves", [(4, False), (8, True)])
def test_slot_beside_circle_is_not_a_trochoid(width, moves):
    """The circle is 16 mm wide, and the middle of the slot lies 7 mm beside the circle's middle."""
    rings = rings_of([polygon(16, corners=24), polygon(width, x=7, ratio=16 / width)])
    assert rings.moved.tolist() == [moves] * 2


@pytest.mark.parametrize("z, relation", [(0.0, {"crossing"}), (-2.0, set())])
def test_ring_of_another_shape_in_the_same_box_is_crossing(z, relation):
    diamond = [(90.0, -40.0, z), (70.0, -20.0, z), (50.0, -40.0, z), (70.0, -60.0, z), (90.0, -40.0, z)]
    assert related(rings_of([polygon(40), diamond])) == [relation] * 2


@pytest.mark.parametrize("cut, relation", [(11.0, set()), (13.0, {"crossing"})])
def test_slightly_smaller_ring_in_the_same_box_is_not_crossing(cut, relation):
    """The smaller ring lacks a corner of 3.8 % or 5.3 % of the area of 40 x 40 mm."""
    without = [(50, -60, 0), (90 - cut, -60, 0), (90, -60 + cut, 0), (90, -20, 0), (50, -20, 0), (50, -60, 0)]
    assert related(rings_of([polygon(40), without])) == [relation] * 2


@pytest.mark.parametrize(
    "senses, opposite",
    [("+-+-+", True), ("+++++", False), ("+-", False), ("++--", False), ("+-+++-", [True] * 3 + [False] * 3)],
)
def test_nested_offsets_with_alternating_sense_are_opposite(senses, opposite):
    rings = rings_of([polygon(40 - 4 * i, clockwise=sense == "-") for i, sense in enumerate(senses)])
    assert rings.opposite.tolist() == ([opposite] * len(senses) if isinstance(opposite, bool) else opposite)
    assert rings.nested.all()


def test_opposite_rings_are_found_if_they_grow_and_then_shrink():
    rings = rings_of([polygon(side, clockwise=i % 2 == 0) for i, side in enumerate((30, 34, 38, 35, 31))])
    assert rings.opposite.all()


@pytest.mark.parametrize("side, moves", [(11, True), (10, False)])
def test_moved_ring_has_a_size_similar_to_the_ring_before(side, moves):
    assert rings_of([polygon(16, corners=24), polygon(side, x=5, corners=24)]).moved.tolist() == [moves] * 2


def test_rings_on_a_surface_are_nested_at_any_height():
    assert rings_of([polygon(40 - 4 * i, z=-float(i), climbs=0.5) for i in range(4)]).nested.all()
    assert not rings_of([polygon(40 - 4 * i, z=-float(i)) for i in range(4)]).nested.any()


@pytest.mark.parametrize("corners, is_round", [(4, False), (6, False), (8, True), (48, True)])
def test_rings_with_eight_or_more_corners_are_round(corners, is_round):
    assert rings_of([polygon(30, corners=corners)]).round.tolist() == [is_round]


def test_ring_that_descends_all_the_way_around_is_sloped():
    around = polygon(30, corners=36)
    steady = [(x, y, -2.0 * i / 36) for i, (x, y, _) in enumerate(around)]
    over_half, at_first = (
        [(x, y, max(-drop * i, -2.0)) for i, (x, y, _) in enumerate(around)] for drop in (2 / 18, 0.5)
    )
    rings = [rings_of([points]).sloped.tolist() for points in (around, steady, over_half, at_first)]
    assert rings == [[False], [True], [False], [False]]


@pytest.mark.parametrize("order", [(0, 1, 2, 3), (3, 2, 1, 0), (0, 3, 1, 2), (1, 0, 3, 2)])
def test_stepover_does_not_depend_on_ring_order(order):
    sides = 44.0, 40.0, 36.0, 32.0
    assert rings_of([polygon(sides[i]) for i in order]).step == pytest.approx(2.0)


def test_stepover_of_interleaved_island_offsets_is_measured():
    """Rings of a nest are 2.4 mm apart, but in FreeCAD 1.0's order most successive rings are 3.6 mm apart."""

    def rectangle(x, y, u, v):
        return [(x, y, 0.0), (u, y, 0.0), (u, v, 0.0), (x, v, 0.0), (x, y, 0.0)]

    boxes = [
        (75.4, 19.4, 106.6, 42.6),
        (80.61, 20.61, 101.39, 41.39),
        (73.0, 17.0, 109.0, 45.0),
        (83.0, 23.0, 99.0, 39.0),
    ]
    assert rings_of([rectangle(*box) for box in boxes]).step == pytest.approx(2.4, abs=0.02)


def test_turns_of_a_helix_are_stacked_windings():
    rings = rings_of([[(12 * math.cos(a), 12 * math.sin(a), -0.2 * a) for a in np.arange(0, 40, 0.2)]])
    inner = slice(0, -1)  # The last turn is possibly incomplete.
    assert rings.winding.all() and rings.sloped[inner].all() and rings.stacked[inner].all() and len(rings) >= 6
    assert rings.depth_range == pytest.approx(0.2 * 2 * math.pi * (len(rings) - 1), rel=0.1)


def test_turns_of_a_spiral_are_nested_windings():
    rings = rings_of([[(0.5 * a * math.cos(a), 0.5 * a * math.sin(a), 0.0) for a in np.arange(3, 50, 0.2)]])
    assert rings.winding.all() and rings.nested[:-1].all() and not rings.sloped.any()  # The last turn is incomplete.
    assert rings.step == pytest.approx(math.pi, rel=0.15) and rings.growing == 1.0


@pytest.mark.parametrize(
    ("steps", "equal"),
    [
        ([], False),
        ([2.0], False),
        ([2.0, 2.0], True),
        ([1.92, 2.0], True),
        ([1.88, 2.0], False),
        (
            [1.6, 2.0, 2.0, 2.0],
            False,
        ),  # With constant engagement, the first step is shorter.
        ([2.0, 2.0, 2.0, 0.4], True),  # The last step may end at the wall.
        ([2.0, 2.0, 1.6, 2.4], False),  # Only half of the steps are equal.
        ([2.2, 2.0, 2.0], False),
    ],
)
def test_spiral_with_equal_steps_has_an_equal_first_step(steps, equal):
    assert _equal(np.array(steps)) is equal


def shapes_of(*strokes):
    pieces = cut_pieces(monotonous_areas(linearize(programs.program(strokes))))
    return _shapes(pieces, np.arange(len(pieces)))


@pytest.mark.parametrize(("turns", "rests"), [(3.0, 0), (3.5, 1), (3.7, 1), (3.8, 0)])
def test_incomplete_last_turn_of_a_spiral_is_not_a_turn(turns, rests):
    found = shapes_of(winding(5, 25, turns))
    assert np.count_nonzero(found.rest) == rests and not (found.rest & found.turn).any()
    assert np.count_nonzero(found.turn) >= 3
    assert not shapes_of(winding(9, 9, turns, drop=6)).turn.any()  # Turns that descend are not listed.


def test_incomplete_turn_of_a_spiral_is_not_a_moved_ring():
    rings = rings_of([winding(2, 9, 3.5)])
    assert not rings.moved.any() and rings.equidistant


def test_loop_around_a_comb_is_wavy_and_a_square_is_not():
    comb = [(x, y, 0.0) for k in range(12) for x, y in ((6 * k, 2), (6 * k + 3, 2), (6 * k + 3, 40), (6 * k + 6, 40))]
    wavy = [(0, 0, 0), *comb, (90, 40, 0), (90, 0, 0), (0, 0, 0)]
    assert shapes_of(wavy, polygon(40)).wavy.tolist() == [True, False]


def toothed(inside, left=0.0):
    """Return an offset of a comb with eight teeth, `inside` mm inside the comb, and `left` mm more on the left side."""
    low, high, width = 20.0 - inside, 60.0 - inside, 10.0 - inside
    teeth = [
        (20 * k + x, y)
        for k in range(7, -1, -1)
        for x, y in ((width, low), (width, high), (inside, high), (inside, low))
    ]
    teeth[-2:] = [(inside + left, high), (inside + left, inside)]
    around = [(inside + left, inside), (150 - inside, inside), *teeth[1:]]
    return [(x, y, 0) for x, y in around]


@pytest.mark.parametrize(("left", "nested"), [(0.0, True), (0.21, True), (0.3, False)])
def test_sides_of_a_wavy_ring_move_equally_within_ten_percent(left, nested):
    assert shapes_of(toothed(0.0), toothed(2.0, left)).wavy.all()
    assert rings_of([toothed(0.0), toothed(2.0, left)]).nested.tolist() == [nested] * 2


def test_section_without_loops_has_no_rings():
    rings = rings_of([[(0, 0, 0), (50, 0, 0)]])
    assert len(rings) == 0 and (rings.depths, rings.distinct, rings.depth_range, rings.evenness) == (0, 0, 0.0, 0.0)


@pytest.mark.parametrize("even_in_plane", [True, False])
def test_evenness_is_small_for_equal_steps_in_the_plane(even_in_plane):
    at = np.linspace(0.1, 0.9, 12)
    radii = 40 * at if even_in_plane else 40 * np.sqrt(1 - (1 - at) ** 2)
    rings = rings_of([polygon(2 * r, z=math.sqrt(1600 - r * r) - 40, corners=48) for r in radii])
    assert (rings.evenness < 0.5) == even_in_plane and rings.evenness > 0


def test_evenness_is_ratio_of_spreads_in_plane_and_in_depth():
    even, uneven = np.full(9, 2.0), np.linspace(1.0, 5.0, 9)
    assert evenness(even, uneven) < 0.1 and evenness(uneven, even) > 10
    assert evenness(even, 3 * even) == pytest.approx(1.0)
    assert evenness(even, np.zeros(9)) == evenness(even[:2], uneven[:2]) == 0.0
    # The 10th and the 90th percentile of the steps differ by 3.2 mm, and their median is 3 mm.
    assert evenness(uneven, even) == pytest.approx((3.2 / 3 + 0.01) / 0.01)


@pytest.mark.parametrize(("back", "kind"), [(True, ZIGZAG), (False, STROKE)])
def test_piece_going_back_and_forth_is_a_zigzag(back, kind):
    program = [("G0", {"X": 0.0, "Y": 0.0, "Z": -1.0})]
    for row in range(8):
        there = 40.0 * (row % 2 == 0) if back else 40.0 * (row + 1)
        program += [("G1", {"X": there}), ("G1", {"Y": 2.0 * (row + 1)})]
    pieces = cut_pieces(monotonous_areas(linearize(program)))
    assert pieces.kind.tolist() == [kind]
