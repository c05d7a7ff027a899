# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers reported with a strategy (stepover, depths, passes), and the reason that contains these numbers."""

from __future__ import annotations

import numpy as np
import programs
import pytest
from drawings import polygon

from toolpaths import synthetic
from vkworkbench.core import Strategy, linearize, recognize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.verdict.evidence import gather_evidence, reason_of
from vkworkbench.core.recognition.verdict.rules import Verdict
from vkworkbench.language import Message

TOOL = 6.0


def found_in(commands):
    return recognize(linearize(commands), tool_diameter=TOOL)


@pytest.mark.parametrize(
    ("outward", "clockwise", "milling"),
    [(True, False, "climb"), (True, True, "conventional"), (False, False, "conventional"), (False, True, "climb")],
)
def test_climb_milling_has_uncut_material_on_the_right(outward, clockwise, milling):
    sides = [20 + 6 * k for k in range(8)][:: 1 if outward else -1]
    found = found_in(programs.program([polygon(side, clockwise=clockwise) for side in sides]))
    assert found.strategy is Strategy.CONTOUR_PARALLEL and found.stepover == pytest.approx(3.0)
    assert (found.sense, found.milling) == ("cw" if clockwise else "ccw", milling)
    assert (found.passes, found.closed_loops, found.depths, found.direction) == (8, 8, 1, None)
    assert "3 mm apart" in found.reason and ("counter-clockwise" in found.reason) == (not clockwise)
    assert "depths" not in found.reason


def test_loops_of_both_senses_have_no_milling_direction():
    found = found_in(programs.program([polygon(20 + 6 * k, clockwise=k % 2 == 0) for k in range(8)]))
    assert found.sense is None and found.milling is None and "clockwise" not in found.reason


def test_growing_and_shrinking_loops_have_no_milling_direction():
    """One nest of loops is cut outward, and one inward.

    Both nests have equal lengths, and all loops run counter-clockwise.
    """
    sides = [20 + 6 * k for k in range(8)]
    strokes = [polygon(side) for side in sides] + [polygon(side, x=200.0) for side in sides[::-1]]
    found = found_in(programs.program(strokes))
    assert found.sense == "ccw" and found.milling is None


def test_profile_of_two_nested_contours_has_no_stepover():
    """In a narrow slot, the walls move inward only at the lowest depth."""
    strokes = [polygon(60, z=-float(k)) for k in range(5)] + [polygon(58, z=-4.0)]
    found = found_in(programs.program(strokes))
    assert found.strategy is Strategy.PROFILE and found.stepover is None and "apart" not in found.reason
    assert found.sense == "ccw" and found.milling is None


def test_rows_report_a_direction_and_depths():
    found = found_in(programs.zigzag(10, 50.0, 3.0, depths=(0.0, -2.0)))
    assert (found.strategy, found.passes, found.depths) == (Strategy.ZIGZAG, 20, 2)
    assert found.direction == pytest.approx(0.0) and found.stepover == pytest.approx(3.0)
    assert found.sense is None and found.milling is None and found.closed_loops == 0
    assert "3 mm apart" in found.reason and "2 depths" in found.reason


@pytest.mark.parametrize(("width", "depths"), [(5.0, 3), (10.4, 3), (10.6, 0), (14.6, 0), (15.4, 6)])
def test_tagged_contour_has_depths_if_most_of_it_is_level(width, depths):
    """Squares with sides of 25 mm have two tags with slopes 2 mm wide.

    The tops of the tags, if long, count as depths.
    """
    strokes = []
    for z in (-1.0, -2.0, -3.0):
        tag = [(5.0, z), (6.0, z + 0.5), (6.0 + width, z + 0.5), (7.0 + width, z)]
        bottom, top = [(x, 0.0, h) for x, h in tag], [(x, 25.0, h) for x, h in tag[::-1]]
        strokes.append([(0, 0, z), *bottom, (25, 0, z), (25, 25, z), *top, (0, 25, z), (0, 0, z)])
    found = found_in(programs.program(strokes))
    assert found.strategy is Strategy.PROFILE and found.depths == depths


def test_contour_with_a_ramp_has_the_depth_of_its_end():
    corners = [(25, 0), (25, 25), (0, 25), (0, 0), (25, 0)]
    ramped = [(0, 0, 0.0), (10, 0, -1.0), *((x, y, -1.0) for x, y in corners)]
    assert found_in(programs.program([ramped])).depths == 1


def test_repeated_contour_has_depths_and_no_stepover():
    found = found_in(programs.profile(depths=(0.0, -2.0, -4.0)))
    assert (found.strategy, found.stepover, found.depths, found.closed_loops) == (Strategy.PROFILE, None, 3, 3)
    assert "3 depths" in found.reason and "apart" not in found.reason


def test_grid_reports_the_rows_of_both_directions():
    across = [[(0.0, 3.0 * row, 0.0), (60.0, 3.0 * row, 0.0)] for row in range(20)]
    down = [[(4.0 * row, 0.0, 0.0), (4.0 * row, 57.0, 0.0)] for row in range(16)]
    found = found_in(programs.program(across + down))
    assert found.strategy.family.name == "ROWS" and found.passes == 36
    assert found.stepover == pytest.approx(3.0) and found.direction == pytest.approx(0.0)


def test_letters_are_reported_as_strokes():
    found = found_in(programs.engraving())
    assert found.strategy is Strategy.ENGRAVING and found.direction is None and found.milling is None
    assert "strokes" in found.reason


def section(*strokes):
    return Section(monotonous_areas(linearize(programs.program(strokes))), TOOL)


def said(strategy, count=1, **more):
    return Verdict(strategy, count, Message("nested"), **more)


def rows(count=10, length=48.0, step=3.0, x=46.0, y=-54.0, z=0.0):
    """Return rows in both directions, in one stroke."""
    ends = ((x, x + length), (x + length, x))
    return [(end, y + row * step, z) for row in range(count) for end in ends[row % 2]]


def test_numbers_of_rows_do_not_include_the_contour_around():
    both = section(rows(), polygon(54))
    e = gather_evidence(both, said(Strategy.ZIGZAG))
    assert (e.passes, e.stepover, e.direction, e.sense) == (10, 3, 0, None)
    # Engraving is not a strategy of rows or loops, but the direction of rows in the toolpath is reported.
    e = gather_evidence(both, said(Strategy.ENGRAVING))
    assert (e.passes, e.stepover, e.direction, e.sense) == (10, 3, 0, None)
    e = gather_evidence(both, said(Strategy.PROFILE))
    assert (e.passes, e.stepover, e.direction, e.sense) == (1, None, None, "ccw")
    e = gather_evidence(section(polygon(54)), said(Strategy.ENGRAVING))
    assert (e.passes, e.stepover, e.direction, e.sense) == (1, None, None, "ccw")


def test_stepover_is_row_distance_or_grid_period():
    """Every other row is cut first: the tool moves 6 mm from row to row, and neighbouring lines are 3 mm apart."""
    order = [*range(0, 20, 2), *range(1, 20, 2)]
    across = [[(0, 3.0 * k, 0), (60, 3.0 * k, 0)] for k in order]
    down = [[(3.0 * k, 0, 0), (3.0 * k, 57, 0)] for k in order]
    one, two = (gather_evidence(section(*strokes), said(Strategy.ONE_WAY)) for strokes in (across, across + down))
    assert (one.passes, two.passes) == (20, 40)
    assert (one.stepover, two.stepover) == pytest.approx((6, 3))


@pytest.mark.parametrize(("downward", "stepover"), [(70.0, 3.0), (50.0, 0.6)])
def test_grid_has_a_stepover_if_one_direction_is_in_rows(downward, stepover):
    """Along X, the lines come in pairs: two lines in every 3 mm.

    Along Y, no line is cut directly after its neighbour.
    """
    across = [(0.0, 60.0)[:: -1 if k % 2 else 1] for k in range(40)]
    across = [
        [(x, 3.0 * (k // 2) + 0.6 * (k % 2), 0), (u, 3.0 * (k // 2) + 0.6 * (k % 2), 0)]
        for k, (x, u) in enumerate(across)
    ]
    down = [[(3.0 * (7 * k % 20), 0, 0), (3.0 * (7 * k % 20), downward, 0)] for k in range(20)]
    found = section(*across, *down)
    assert (len(found.families), len(found.rows)) == (2, 1)
    assert gather_evidence(found, said(Strategy.ZIGZAG)).stepover == pytest.approx(stepover)


def test_stepover_from_the_rules_is_used_if_none_is_measured():
    strokes = section(*([(60.0 * k, 0, 0), (60.0 * k + 30, 9.0 * k, 0)] for k in range(4)))
    e = gather_evidence(strokes, said(Strategy.CONTOUR_PARALLEL, 7, step=2.5))
    assert (e.passes, e.stepover) == (7, 2.5)
    e = gather_evidence(section(rows()), said(Strategy.ZIGZAG, 7, step=2.5))
    assert (e.passes, e.stepover) == (10, 3)


@pytest.mark.parametrize("length, depths", [(4.0, 1), (6.0, 2)])
def test_tiny_line_beside_a_contour_does_not_count_as_a_depth(length, depths):
    """The line of 4 or 6 mm lies beside a contour of 240 mm."""
    found = section(polygon(60), [(200, 0, -1), (200 + length, 0, -1)])
    assert gather_evidence(found, said(Strategy.PROFILE)).depths == depths


SHORT = [[(60.0 * k, 0, 0), (60.0 * k + 9, 0, 0)] for k in range(4)]
BENT = [[(60.0 * k, 0, 0), (60.0 * k + 9, 0, 0), (60.0 * k + 9, 9.0 + k, 0)] for k in range(4)]


@pytest.mark.parametrize(
    "strokes, strategy, code, count",
    [
        ([[(0, 3.0 * k, 0), (50, 3.0 * k, 0)] for k in range(9)], Strategy.ONE_WAY, "rows-at-0", 9),
        ([rows()], Strategy.ZIGZAG, "rows", 10),
        ([polygon(40), polygon(36)], Strategy.CONTOUR_PARALLEL, "loops", 2),
        ([polygon(40), polygon(36, clockwise=True)], Strategy.ZIGZAG, "loops", 2),
        ([polygon(40), polygon(36)], Strategy.ENGRAVING, "between", None),
        (SHORT, Strategy.ENGRAVING, "strokes-at-0", 4),
        (BENT, Strategy.ENGRAVING, "strokes", 4),
        (BENT, Strategy.PROFILE, "strokes", 4),
        (BENT, Strategy.MIXED, "between", None),
    ],
    ids=lambda value: str(value) if isinstance(value, (str, Strategy)) else "",
)
def test_reason_contains_the_number_of_rows_loops_or_strokes(strokes, strategy, code, count):
    found = section(*strokes)
    verdict = said(strategy)
    message = reason_of(found, verdict, gather_evidence(found, verdict))
    assert (message.code, message.arguments.get("count")) == (code, count)
    assert message.arguments["strategy"] == strategy


@pytest.mark.parametrize(("heights", "depths"), [((-1.0,), 1), ((-1.0, -3.0), 2), ((-1.0, -3.0, -5.0), 3)])
def test_rows_with_ramps_between_depths_have_all_depths(heights, depths):
    """From the last row of a depth, the tool ramps down along that row, and cuts the rows again in reverse order."""
    stroke, up = [], True
    for z in heights:
        around = [(x, 3.0 * row, z) for row in range(10) for x in ((0, 50) if row % 2 == 0 else (50, 0))]
        stroke += around if up else around[::-1]
        up = not up
    assert found_in(programs.program([stroke])).depths == depths


def thread(first, pitch, lead=True):
    """Return the commands of a thread of five turns between two level leads."""
    commands = [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G0", {"Z": first})]
    commands += [("G1", {"X": 4.0, "F": 5.0})]
    commands += [("G3", {"X": 4.0, "Y": 0.0, "Z": first + pitch * (k + 1), "I": -4.0, "J": 0.0}) for k in range(5)]
    return [*commands, ("G1", {"X": 0.0}), ("G0", {"Z": 5.0})]


@pytest.mark.parametrize("first, pitch, seen", [(0.0, -1.25, "descending"), (-10.0, 1.25, "climbing")])
def test_thread_has_a_direction_and_leads_add_no_depths(first, pitch, seen):
    found = recognize(linearize(thread(first, pitch)), tool_diameter=6.0)
    assert (found.strategy, found.depths) == ("helix", 0)
    assert f"over 5 loops, {seen} at a constant radius" in found.reason


def loops(*boxes):
    """Return the commands of rectangles (x, y, width, height), each after a plunge."""
    commands = [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0})]
    for x, y, w, h in boxes:
        commands += [("G0", {"Z": 5.0}), ("G0", {"X": x, "Y": y}), ("G1", {"Z": -1.0, "F": 5.0})]
        commands += [("G1", {"X": a, "Y": b}) for a, b in ((x + w, y), (x + w, y + h), (x, y + h), (x, y))]
    return commands


def test_reason_contains_the_share_of_nested_loops():
    """Two loops are nested. The three loops beside the nested loops are longer and far apart."""
    found = recognize(
        linearize(loops((0, 0, 40, 40), (3, 3, 34, 34), *((100 * k, 0, 60, 50) for k in (1, 2, 3)))), tool_diameter=6.0
    )
    assert found.strategy == "profile"
    assert found.why.arguments["seen"].code == "partly-nested"
    apart = recognize(linearize(loops((0, 0, 40, 40), (100, 0, 60, 50))), tool_diameter=6.0)
    assert apart.why.arguments["seen"].code == "not-nested"


def test_toolpath_without_descent_has_no_entry():
    level = [(name, {key: value for key, value in p.items() if key != "Z"}) for name, p in loops((0, 0, 40, 40))]
    assert recognize(linearize(level)).entry is None
    assert recognize(linearize(loops((0, 0, 40, 40)))).entry == "plunge"


def test_contour_after_adaptive_clearing_is_its_finishing_pass():
    """The contour goes around the cleared area, at its depth.

    A small loop in the middle of the area finishes nothing.
    """
    commands = synthetic.adaptive(np.random.default_rng(2))
    low, high = (side(linearize(commands).points, axis=0) for side in (np.min, np.max))

    def ending_with(width, height):
        x, y = (low[:2] + high[:2] - (width, height)) / 2
        loop = [("G0", {"Z": 5.0}), ("G0", {"X": x, "Y": y}), ("G1", {"Z": low[2]})]
        loop += [("G1", {"X": x + a, "Y": y + b}) for a, b in ((width, 0), (width, height), (0, height), (0, 0))]
        return recognize(linearize(commands + loop), tool_diameter=TOOL)

    around, small = ending_with(*(high - low)[:2]), ending_with(*(high - low)[:2] / 3)
    assert around.strategy == small.strategy == "adaptive"
    assert around.finishing and "A closed contour finishes the walls." in around.reason
    assert not small.finishing
