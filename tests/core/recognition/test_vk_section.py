# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures of a section, for drawn toolpaths whose measures can be computed by hand."""

from __future__ import annotations

import math

import numpy as np
import programs
import pytest
from drawings import polygon

from vkworkbench.core import Strategy, linearize
from vkworkbench.core.paper import TURN, monotonous_areas
from vkworkbench.core.recognition.patterns.pieces import LOOP, ZIGZAG, cut_pieces
from vkworkbench.core.recognition.patterns.section import Section, _absorbed
from vkworkbench.core.recognition.verdict.rules import judge_section

TOOL = 6.0


def section(*strokes, tool=TOOL):
    return Section(monotonous_areas(linearize(programs.program(strokes))), tool)


def rows(count=6, length=30.0, step=3.0, x=0.0, y=0.0, z=0.0):
    """Return rows cut back and forth in one stroke."""
    ends = ((x, x + length), (x + length, x))
    return [(end, y + row * step, z) for row in range(count) for end in ends[row % 2]]


def walk(*steps, start=(70.0, -40.0)):
    """Return the points of a polyline.

    Each step is (turn, length): a change of direction in degrees, then a straight length in mm.
    """
    (x, y), heading, points = start, 0.0, [(*start, 0.0)]
    for turn, length in steps:
        heading += math.radians(turn)
        x, y = x + length * math.cos(heading), y + length * math.sin(heading)
        points.append((x, y, 0.0))
    return points


def square_spiral(turns, side_steps, grows=2.0):
    """Return a square spiral. `side_steps` returns the steps of `walk` along one side of a given length."""
    lengths = [20.0 + grows * k for k in range(4 * turns)]
    return walk(*(step for length in lengths for step in side_steps(length)))


def jogs(count, degrees, length=None):
    """Return sides for `square_spiral`. Every fourth side bends `count` times against the spiral's sense, and back."""
    side = iter(range(10**6))

    def steps(whole):
        if next(side) % 4:
            return [(90, whole)]
        piece = whole / (2 * count + 1)
        bend = piece if length is None else length
        return [(90, piece), *(one for _ in range(count) for one in ((-degrees, bend), (degrees, piece)))]

    return steps


def test_loops_of_a_section_are_rings_and_zigzags_are_rows():
    found = section(polygon(60), rows(x=50, y=-50), polygon(60, z=-1.0))
    assert found.ring_pieces.tolist() == [True, False, True]
    assert found.row_pieces.tolist() == [False, True, False]


@pytest.mark.parametrize("side, rings", [(1.0, [0]), (1.5, [0, 1])])
def test_rings_shorter_than_a_fiftieth_of_the_longest_are_leads(side, rings):
    """A fiftieth of the longest ring, 240 mm, is 4.8 mm. The two short rings are 4 and 6 mm long."""
    found = section(polygon(60), polygon(side, x=100))
    assert found.rings.index.tolist() == rings == np.flatnonzero(found.ring_pieces).tolist()
    assert not found.row_pieces.any()


def test_zigzag_that_returns_to_its_start_is_rows():
    """A contour at another depth stays a ring."""
    closed = [*rows(6, length=40.0), (-5.0, 15.0, 0.0), (-5.0, 0.0, 0.0), (0.0, 0.0, 0.0)]
    found = section(closed, polygon(60, z=-1.0))
    assert found.lattice.tolist() == [True, False] and len(found.rows) == 1
    assert found.ring_pieces.tolist() == [False, True] and found.row_pieces.tolist() == [True, False]


def test_two_rows_closed_by_their_links_are_not_a_ring():
    """Two rows may run between bosses. A contour around an island is wider than 1.6 row distances."""
    two = [(0.0, 21.0, 0.0), (30.0, 21.0, 0.0), (30.0, 25.5, 0.0), (0.0, 25.5, 0.0), (0.0, 21.0, 0.0)]
    island = [(0.0, 21.0, 0.0), (30.0, 21.0, 0.0), (30.0, 26.1, 0.0), (0.0, 26.1, 0.0), (0.0, 21.0, 0.0)]
    found = section(rows(), two)
    assert found.row_pieces.all() and not found.ring_pieces.any()
    assert judge_section(found).strategy is Strategy.ZIGZAG
    found = section(rows(), island)
    assert found.ring_pieces.sum() == 1


def test_rings_of_two_shapes_are_rings_if_no_rows_are_found():
    square = polygon(40)
    diamond = polygon(20 * math.sqrt(2), turned=0.0)
    found = section(square, diamond)
    assert found.lattice.all() and not found.rows and found.ring_pieces.all()
    assert not section(square, polygon(36)).lattice.any()


@pytest.mark.parametrize("degrees, lattice", [(60, False), (75, True)])
def test_spiral_turn_with_reversals_counts_as_rows(degrees, lattice):
    """Two bends aside and back turn by four times 60 degrees (2/3 of a turn), or 75 degrees (5/6)."""
    found = section(square_spiral(3, jogs(2, degrees), grows=12.0))
    assert found.rings.winding[0] and found.lattice[0] == lattice


def test_star_shaped_contour_is_a_contour():
    """The star has six points."""
    at = np.arange(13) * TURN / 12
    radius = np.where(np.arange(13) % 2, 12.0, 30.0)
    found = section(list(zip(70 + radius * np.cos(at), radius * np.sin(at), 0 * at)))
    assert found.rings.back[0] > 0.75 * TURN and not found.lattice.any()


@pytest.mark.parametrize("length, families", [(15.0, 0), (30.0, 1)])
def test_rows_with_less_than_a_tenth_of_the_length_are_links(length, families):
    """The total length of the squares is 1136 mm.

    Six rows and their links of 15 mm have 105 of 1241 mm, or 195 of 1331 mm.
    """
    squares = [polygon(side, x=200) for side in (80, 74, 68, 62)]
    assert len(section(rows(length=length), *squares).rows) == families


def test_ramp_back_and_forth_on_one_line_is_not_a_zigzag():
    """A ramp runs four times along a line of 50 mm.

    Away from the ramp, there are four rows (60 mm in total) with links (9 mm).
    """
    ramp = [(0, 0, 0), (30, 40, -1), (0, 0, -2), (30, 40, -3), (0, 0, -4)]
    found = section(ramp, rows(4, length=15.0, y=-60))
    assert found.retraced == pytest.approx(200 / 269) and found.zigzag == pytest.approx(69 / 269)


@pytest.mark.parametrize("aside, retraced", [(0.01, 1.0), (0.05, 0.0)])
def test_ramp_that_returns_on_another_line_is_not_retraced(aside, retraced):
    """The second pass begins at a distance of `aside` mm from the line of the first pass."""
    ramp = [(0, 0, 0), (30, 40, -1), (0.8 * aside, -0.6 * aside, -2), (30, 40, -3), (0, 0, -4)]
    assert section([(x + 70, y - 45, z) for x, y, z in ramp]).retraced == retraced


def kinds(stroke):
    """Return the kinds of pieces of a stroke, before and after small loops are counted as parts of the zigzag."""
    pieces = cut_pieces(monotonous_areas(linearize(programs.program([[(x + 90, y + 50, z) for x, y, z in stroke]]))))
    return pieces.kind.tolist(), _absorbed(pieces).tolist()


def box(x, y, width, height):
    """Return a closed rectangle that starts at its upper left corner."""
    return [(x, y, 0.0), (x, y - height, 0.0), (x + width, y - height, 0.0), (x + width, y, 0.0), (x, y, 0.0)]


def test_small_loop_between_rows_is_part_of_the_zigzag():
    cut, absorbed = kinds(rows(7, length=40.0) + box(42.0, 20.0, 5.0, 5.0))
    assert cut == [ZIGZAG, LOOP] and absorbed == [ZIGZAG, ZIGZAG]


@pytest.mark.parametrize("inside", [-2.0, 2.0])
def test_loop_slightly_inside_rows_is_a_contour(inside):
    """The loop lies 2 mm inside or outside rows of 40 x 18 mm. The tolerance is 15 % of the sides, 6 and 2.7 mm."""
    stroke = rows(7, length=40.0) + box(inside, 18.0 - inside, 40.0 - 2 * inside, 18.0 - 2 * inside)
    assert kinds(stroke) == ([ZIGZAG, LOOP], [ZIGZAG, LOOP])


@pytest.mark.parametrize(
    "loop",
    [
        box(42, 22, 5, 26),
        box(-8, 22, 5, 26),
        box(-3, 30, 46, 8),
        box(-3, -3, 46, 8),
        box(7, 20, 26, 22),
        box(-2, 20, 27, 22),
    ],
    ids=["right", "left", "above", "below", "narrow", "half"],
)
def test_loop_beside_rows_is_not_a_contour(loop):
    """Each loop reaches the border of the rows on some sides, but lies too far inside on one side."""
    cut, absorbed = kinds(rows(7, length=40.0) + loop)
    assert cut == [ZIGZAG, LOOP] and absorbed == [ZIGZAG, ZIGZAG]


def test_loop_separate_from_the_strokes_of_rows_is_a_contour():
    strokes = [rows(7, length=40.0), box(42.0, 20.0, 5.0, 5.0)]
    pieces = cut_pieces(monotonous_areas(linearize(programs.program(strokes))))
    assert _absorbed(pieces).tolist() == [ZIGZAG, LOOP]


def polygon_spiral(corners):
    """Return a spiral of straight sides with six turns."""
    return [walk(*((360 / corners, (20.0 + k / corners) * 4 / corners) for k in range(6 * corners)))]


@pytest.mark.parametrize("corners, share", [(4, 1.0), (11, 1.0), (13, 0.0), (36, 0.0)])
def test_corners_of_a_spiral_turn_by_more_than_30_degrees(corners, share):
    assert section(*polygon_spiral(corners)).cornered() == share


def test_half_of_the_turning_of_rounded_squares_is_in_corners():
    """A corner of 90 degrees alternates with nine bends of 10 degrees."""
    rounded = [(10, 1.0)] * 9
    found = section(walk(*(step for k in range(12) for step in [(90, 20.0 + 2 * k), *rounded])))
    assert found.cornered() == pytest.approx(0.5, abs=0.05)


def test_section_without_spirals_has_no_corners():
    assert section(polygon(40), polygon(36)).cornered() == 0.0


@pytest.mark.parametrize(
    "degrees, length, aside", [(20, None, False), (35, None, True), (35, 0.05, False), (35, 0.2, True)]
)
def test_spiral_with_a_27_degree_bend_per_turn_steps_aside(degrees, length, aside):
    """Each turn of the spiral has one bend.

    A bend of 35 degrees (0.61 rad) on 0.05 mm is 0.03 rad mm, which is less than the limit of 0.05 rad mm.
    """
    found = section(square_spiral(5, jogs(1, degrees, length)))
    assert found.rings.winding.all() and len(found.aside) == 5
    assert found.aside[:4].tolist() == [aside] * 4 and not found.hunting.any()


def test_bend_in_small_steps_counts_as_one_bend():
    """Each of five bends has 7 degrees on 0.3 mm, so small that rounding could cause the bend.

    After five such bends, one bend of 35 degrees turns the path back.
    """

    def side(whole):
        return [(90, whole / 2), *[(-7, 0.3)] * 5, (35, whole / 2)]

    found = section(
        walk(*(step for k in range(20) for step in (side if k % 4 == 1 else lambda w: [(90, w)])(20.0 + 2 * k)))
    )
    assert found.rings.winding.all() and found.aside[:4].all() and not found.hunting.any()


@pytest.mark.parametrize("count, degrees, hunting", [(8, 6, True), (7, 6, False), (8, 9, True), (8, 12, False)])
def test_spiral_with_8_small_corrections_per_turn_is_hunting(count, degrees, hunting):
    found = section(square_spiral(5, jogs(count, degrees)))
    assert found.rings.winding.all()
    assert found.hunting[:4].tolist() == [hunting] * 4


def letter(i, x, z=0.0, size=3.0):
    """Return a closed contour with the shape number i, whose size grows by 0.5 mm with i."""
    return polygon(size + 0.5 * i, x=x, z=z, corners=3 + i % 5, ratio=1 + 0.1 * i)


def written(shapes, copies=0, depths=1, size=3.0):
    """Return a section of `shapes` different contours, followed by copies of the first `copies` contours."""
    text = [*range(shapes), *range(copies)]
    return section(*(letter(i, 12.0 * k, -1.0 * d, size) for d in range(depths) for k, i in enumerate(text)))


@pytest.mark.parametrize(
    "text, letters",
    [
        ({"shapes": 8}, True),
        ({"shapes": 7}, False),
        ({"shapes": 8, "copies": 3}, True),  # 8 different shapes in 11 contours are more than 67 %.
        ({"shapes": 8, "copies": 4}, False),  # 8 different shapes in 12 contours are less than 67 %.
        ({"shapes": 8, "depths": 3}, True),
        ({"shapes": 8, "depths": 4}, False),
        ({"shapes": 8, "size": 14.0}, False),  # Contours of 16 mm are too large for letters on about 100 mm.
        ({"shapes": 8, "size": 7.0}, True),
    ],
    ids=str,
)
def test_letters_are_small_contours_of_many_shapes(text, letters):
    assert written(**text).letters() is letters


def test_letters_with_equal_boxes_differ_by_their_lengths():
    """The notches in squares of 10 mm differ by 0.45 mm in depth, so the mean sides differ by 0.225 mm."""

    def notched(k):
        x, depth = 100.0 * k, 0.45 * k
        ways = ((0, 0), (10, 0), (10, 10), (6, 10), (6, 10 - depth), (4, 10 - depth), (4, 10), (0, 10), (0, 0))
        return [(x + a, b, 0.0) for a, b in ways]

    assert section(*map(notched, range(1, 9))).letters()


FAR = polygon(40, x=300)


def deeper(stroke, by=1.0):
    return [(x, y, z - by) for x, y, z in stroke]


@pytest.mark.parametrize(
    "strokes, share",
    [
        ([polygon(60), rows(x=50, y=-50)], 1.0),
        ([rows(x=50, y=-50), polygon(60)], 1.0),
        ([FAR, polygon(60), rows(x=50, y=-50), FAR], 1.0),
        ([FAR, FAR, rows(x=50, y=-50), polygon(60)], 1.0),
        ([polygon(60, z=-1.0), rows(x=50, y=-50, z=-1.0)], 1.0),
        ([polygon(60, z=-1.0), rows(x=50, y=-50)], 0.0),
        ([polygon(60), FAR, FAR, rows(x=50, y=-50)], 1.0),
        ([polygon(60), rows(x=50, y=-50), *(polygon(61 + k, x=300 + 80 * k) for k in range(7))], 1.0),
        ([polygon(60), rows(x=50, y=-50), *(polygon(61 + k, x=300 + 80 * k) for k in range(8))], 0.0),
        ([polygon(60), rows(x=50, y=-50), *(polygon(20, x=300 + 80 * k) for k in range(8))], 1.0),
        ([*(polygon(20, x=300 + 80 * k, z=z) for k in range(5) for z in (0.0, -2.0)),
          polygon(60, z=-1.0), rows(x=50, y=-50, z=-1.0)], 1.0),
        ([polygon(30), rows(7, step=5.0, x=55, y=-55)], 1.0),
        ([polygon(60), rows(x=80, y=-50)], 0.0),
        ([polygon(60), rows(x=20, y=-50)], 0.0),
        ([polygon(60), rows(x=50, y=-20)], 0.0),
        ([polygon(60), rows(x=50, y=-80)], 0.0),
        ([polygon(60), rows(x=50, y=-50), rows(4, length=24.0, step=3.0, x=120)], 195 / (195 + 105)),
        ([rows()], 0.0),
        ([polygon(60)], 0.0),
    ],
    ids=["after", "before", "between, inside the first", "between, inside the second", "as deep", "deeper", "not last", "the eighth", "the ninth", "the largest of nine",
         "five at other depths", "along it and to it", "right", "left", "above", "below", "some", "no ring", "no rows"],
)  # fmt: skip
def test_rows_are_enclosed_by_one_of_the_largest_rings(strokes, share):
    assert section(*strokes).bordered()[0] == pytest.approx(share)


ISLAND = polygon(10, x=-5, y=-2)


@pytest.mark.parametrize(
    "strokes, share",
    [
        ([ISLAND, rows(x=50, y=-50)], 1.0),
        ([rows(x=50, y=-50), FAR, ISLAND], 40 / 200),
        ([deeper(ISLAND), rows(x=50, y=-50)], 0.0),
        ([deeper(ISLAND), deeper(rows(x=50, y=-50))], 1.0),
        ([polygon(10, x=-5, y=-10), rows(x=50, y=-50)], 0.0),
        ([ISLAND, polygon(8, x=-5, y=-2), rows(x=50, y=-50)], 0.0),
        ([ISLAND], 0.0),
        ([rows()], 0.0),
    ],
    ids=["amid", "some", "deeper", "as deep", "across their edge", "offsets", "no rows", "no ring"],
)
def test_single_rings_in_the_middle_of_rows_go_around_islands(strokes, share):
    assert section(*strokes).bordered()[1] == pytest.approx(share)


crooked = [(x, -40 + math.sin(1.3 * i), 0.0) for i, x in enumerate(np.linspace(44, 96, 14))]
there_and_back = crooked + [(x, y + 1, z) for x, y, z in crooked[::-1]]
RING = polygon(60, ratio=0.2)


@pytest.mark.parametrize(
    "strokes, clears",
    [
        ([RING, there_and_back], True),
        ([there_and_back, RING], True),
        ([FAR, RING, there_and_back, FAR], True),
        ([FAR, FAR, there_and_back, RING], True),
        ([deeper(RING), deeper(there_and_back)], True),
        ([RING, deeper(there_and_back)], False),
        ([RING, FAR, FAR, there_and_back], False),
        ([there_and_back, FAR, RING], False),
        ([RING, crooked], False),
        ([RING, [(x + 6, y, z) for x, y, z in there_and_back]], False),
        ([RING], False),
    ],
    ids=["after", "before", "between, inside the first", "between, inside the second", "as deep", "deeper", "not last", "not next", "one way",
         "over the edge", "no stroke"],
)  # fmt: skip
def test_stroke_back_and_forth_clears_the_adjacent_ring(strokes, clears):
    found = section(*strokes)
    length = sum(math.dist(a, b) for a, b in zip(there_and_back, there_and_back[1:]))
    assert found.filled() == pytest.approx(length / found.length if clears else 0.0)


@pytest.mark.parametrize("tool, clears", [(6.0, True), (3.0, False), (0.0, True)])
def test_stroke_clears_a_ring_only_within_the_largest_stepover(tool, clears):
    """The stroke ends 4 mm before the sides of the closed loop. The largest stepover of a tool of 3 mm is 3.6 mm."""
    assert bool(section(RING, there_and_back, tool=tool).filled()) is clears


def test_stroke_around_a_ring_is_its_repeat():
    """The stroke is another contour that does not quite close."""
    again = [*polygon(58, ratio=0.19)[:-1], (99.0, -36.0, 0.0)]
    assert section(RING, again).filled() == 0.0


def test_shares_of_rings_and_strokes_are_of_the_whole_length():
    """The rings have 160 and 80 mm, and the stroke has 60 mm."""
    found = section(polygon(40), polygon(20, x=200), [(0, 0, 0), (30, 0, 0), (30, 30, 0)])
    assert found.share(np.array([True, False])) == pytest.approx(160 / 300)
    assert found.part(np.array([True])) == pytest.approx(60 / 300)


def test_entry_helix_is_not_part_of_the_pattern():
    helix = [(70 + 4 * math.cos(a), -40 + 4 * math.sin(a), -a / TURN) for a in np.linspace(0, 3 * TURN, 73)]
    squares = [polygon(side, z=-3.0) for side in (20, 24, 28)]
    found = section(helix + squares[0], *squares[1:])
    assert 0 < found.wound < 0.5 and len(found.moves) < len(found.areas)
