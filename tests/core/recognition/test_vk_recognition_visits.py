# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs without titles and tool changes are divided into operations by their motion."""

from __future__ import annotations

import sys
from dataclasses import replace

import numpy as np
import programs
import pytest
from drawings import winding

from vkworkbench.core import Strategy, linearize, recognize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.programs.parts import Sections, _odds_of_difference, dividing_retracts
from vkworkbench.core.recognition.programs.visits import Visits, compare_visits, find_retracts, find_visits
from vkworkbench.core.recognition.thresholds import VISITS

TOOL = 5.0

DIFFERENT = {
    "zigzag": programs.SOUND["zigzag"](14, 60.0, 3.0, [-1.0, -2.0]),
    "contour-parallel": programs.SOUND["contour-parallel"](6, 36, 3.0, 10.0, [-1.0, -2.0], 0.0),
    "profile": programs.SOUND["profile"](24, 40.0, [-1.0, -2.0, -3.0], 0.0),
    "spiral": programs.SOUND["spiral"](8, 3.0, 48),
    "helix": programs.SOUND["helix"](8, 15.0, 1.0),
    "drilling": programs.SOUND["drilling"](4, 4, 20.0, "G81"),
    "adaptive": programs.SOUND["adaptive"](40, 8.0, 1.0),
}


def after(first, second):
    """Return both toolpaths one after the other, with a retract to the clearance height between them."""
    commands = [*first, ("G0", {"Z": programs.CLEAR}), *second]
    path = linearize(commands)
    return replace(path, comments=(), tool_changes=np.empty(0, np.int64))


@pytest.mark.long
def test_most_programs_of_two_operations_are_divided():
    right = wrong = 0
    for one, first in DIFFERENT.items():
        for two, second in DIFFERENT.items():
            if one == two:
                continue
            path = after(first, second)
            found = recognize(path, tool_diameter=TOOL, program=True)
            border = len(linearize(first))
            names = [str(s.strategy) for s in found.spans]
            good = names == [one, two] and abs(found.spans[1].first - border) <= 6
            right, wrong = right + good, wrong + (not good)
    assert right >= 0.8 * (right + wrong), (right, wrong)


@pytest.mark.parametrize("name", DIFFERENT)
def test_operation_with_retracts_within_it_is_one_span(name):
    # The cuts are repeated at four places of the part, like the pockets of one operation.
    path = linearize(DIFFERENT[name])
    program = DIFFERENT[name]
    for x in (150.0, 300.0, 450.0):
        shifted = [
            (n, {k: v + x if k == "X" else v for k, v in words.items()})
            if n in ("G0", "G1", "G2", "G3", "G81")
            else (n, words)
            for n, words in DIFFERENT[name]
        ]
        program = [*program, ("G0", {"Z": programs.CLEAR}), *shifted]
    whole = linearize(program)
    assert len(whole) > 3 * len(path)
    found = recognize(replace(whole, comments=()), tool_diameter=TOOL, program=True)
    assert found.strategy == name and len(found.spans) == 1, found.reason


def test_toolpath_is_divided_at_retracts_to_the_top_height():
    path = after(DIFFERENT["profile"], DIFFERENT["helix"])
    visits = find_visits(path, monotonous_areas(path))
    top = path.points[:, 2].max()
    for last, first in zip(visits.last[:-1], visits.first[1:]):
        assert path.points[last + 1 : first + 1, 2].max() == top
    for values in compare_visits(visits).values():
        assert values.shape == (len(visits) - 1,) and np.isfinite(values).all()


def test_border_of_operations_is_at_the_top_before_a_descent():
    path = after(DIFFERENT["zigzag"], DIFFERENT["drilling"])
    for at in find_retracts(path, monotonous_areas(path)):
        assert path.points[at, 2] == path.points[:, 2].max() and path.rapid[at]


@pytest.mark.parametrize("commands", [[], [("G0", {"X": 5.0})], [("G1", {"X": 5.0, "Y": 1.0})]])
def test_paths_with_almost_no_moves_are_not_divided(commands):
    path = linearize(commands)
    assert find_retracts(path, monotonous_areas(path)) == {}


def test_descending_retracts_do_not_recurse_deeply():
    """Each retract is lower than the retract before.

    The program is divided at the highest retract first, 1,100 times.
    """
    commands = [("G0", {"X": 0.0, "Y": 0.0, "Z": 3310.0})]
    for k in range(1100):
        x, corner = 200.0 * k, 5.0
        commands += [("G0", {"X": x, "Y": 0.0}), ("G1", {"Z": -1 - 0.3 * k, "F": 50.0 + 20 * k})]
        commands += [("G1", {"X": x + corner}), ("G1", {"Y": corner}), ("G1", {"X": x}), ("G1", {"Y": 0.0})]
        commands += [("G0", {"Z": 3307.0 - 3 * k})]
    assert len(recognize(linearize(commands), program=True).spans) >= 1


def test_most_probable_borders_between_operations_are_kept(monkeypatch):
    path = after(DIFFERENT["zigzag"], [*DIFFERENT["helix"], ("G0", {"Z": programs.CLEAR}), *DIFFERENT["profile"]])
    moves = monotonous_areas(path)
    every = find_retracts(path, moves)
    monkeypatch.setattr(VISITS, "MOST", 1)
    (kept,) = find_retracts(path, moves).values()
    assert kept == max(every.values()) > min(every.values())


def test_program_with_many_certain_borders_is_not_searched(monkeypatch):
    """A search for further borders of operations would take long, and would not change the result."""
    commands = [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0})]
    for k in range(120):
        x, y = 30.0 * (k % 12), 25.0 * (k // 12)
        commands += [("G81", {"X": x, "Y": y, "Z": -5.0, "R": 2.0, "F": 3.0}), ("G80", {})]
        commands += [("G0", {"X": x + 5, "Y": y}), ("G1", {"Z": -1.0, "F": 5.0})]
        commands += [("G1", {"X": x + 5 + dx, "Y": y + dy}) for dx, dy in ((10, 0), (10, 10), (0, 10), (0, 0))]
        commands += [("G0", {"Z": 5.0})]
    looked_at = []
    monkeypatch.setattr(
        sys.modules["vkworkbench.core.recognition.programs.recognize"], "find_retracts", looked_at.append
    )
    assert len(recognize(linearize(commands), tool_diameter=3.0, program=True).spans) == 1 and not looked_at


def test_program_of_two_zigzags_is_a_zigzag_and_not_mixed():
    path = after(DIFFERENT["zigzag"], DIFFERENT["zigzag"])
    assert recognize(path, tool_diameter=TOOL, program=True).strategy is Strategy.ZIGZAG


def test_operations_are_divided_only_in_programs():
    path = after(DIFFERENT["profile"], DIFFERENT["helix"])
    assert len(recognize(path, tool_diameter=TOOL, program=True).spans) == 2
    assert len(recognize(path, tool_diameter=TOOL).spans) == 1


@pytest.mark.parametrize("depths", [[-1.0, -2.0], [-2.0]], ids=["several retracts between them", "one retract"])
def test_stretches_between_high_retracts_divide_at_their_top(depths):
    one, two, three = programs.SOUND["zigzag"](14, 60.0, 3.0, depths), DIFFERENT["helix"], DIFFERENT["profile"]
    up = [("G0", {"Z": programs.CLEAR + 100.0})]
    path = linearize([*one, ("G0", {"Z": programs.CLEAR}), *two, *up, *three, *up, *one])
    path = replace(path, comments=(), tool_changes=np.empty(0, np.int64))
    found = recognize(path, tool_diameter=TOOL, program=True)
    assert [str(s.strategy) for s in found.spans] == ["zigzag", "helix", "profile", "zigzag"]


@pytest.mark.parametrize("name", ["zigzag", "helix", "contour-parallel"])
@pytest.mark.parametrize("last", [False, True])
def test_single_hole_is_an_operation_of_a_program(name, last):
    hole = programs.SOUND["drilling"](1, 1, 20.0, "G81")
    pair = (DIFFERENT[name], hole) if last else (hole, DIFFERENT[name])
    found = recognize(after(*pair), tool_diameter=TOOL, program=True)
    names = [name, "drilling"] if last else ["drilling", name]
    assert [str(s.strategy) for s in found.spans] == names


def test_border_between_equal_strategies_stays_in_mixed_program():
    pocket, rows = DIFFERENT["contour-parallel"], DIFFERENT["zigzag"]
    border, second = len(linearize(pocket)), len(linearize([*pocket, *pocket]))
    path = replace(linearize([*pocket, *pocket, *rows]), comments=(), tool_changes=np.array([border, second]))
    as_program = recognize(path, tool_diameter=TOOL, program=True)
    assert [str(s.strategy) for s in as_program.spans] == ["contour-parallel", "contour-parallel", "zigzag"]
    assert as_program.spans[1].first >= border > as_program.spans[0].last
    as_operation = recognize(path, tool_diameter=TOOL)
    assert [str(s.strategy) for s in as_operation.spans] == ["contour-parallel", "zigzag"]


def test_box_of_cuts_between_retracts_includes_the_last_move():
    path = linearize([
        ("G0", {"X": 5.0, "Y": 5.0, "Z": 5.0}), ("G1", {"Z": -1.0}), ("G1", {"X": 9.0}), ("G1", {"X": 20.0, "Y": -3.0}),
        ("G0", {"Z": 5.0}), ("G0", {"X": 50.0, "Y": 50.0}), ("G1", {"Z": -1.0}), ("G1", {"X": 40.0, "Y": 70.0}),
    ])  # fmt: skip
    visits = find_visits(path, monotonous_areas(path))
    assert visits.low.tolist() == [[5, -3], [40, 50]]
    assert visits.high.tolist() == [[20, 5], [50, 70]]


@pytest.mark.parametrize(("corner", "same"), [((20.0, 20.0), 1.0), ((29.0, 20.0), 0.0), ((20.0, 29.0), 0.0)])
def test_equal_boxes_before_and_after_a_retract_are_one_area(corner, same):
    def rectangle(x, y):
        corners = ((x, 0.0), (x, y), (0.0, y), (0.0, 0.0))
        return [("G0", {"X": 0.0, "Y": 0.0}), ("G1", {"Z": -1.0}), *[("G1", dict(zip("XY", at))) for at in corners]]

    path = after([("G0", {"Z": programs.CLEAR}), *rectangle(20.0, 20.0)], rectangle(*corner))
    assert compare_visits(find_visits(path, monotonous_areas(path)))["same_ground"] == same


@pytest.mark.parametrize(("gap", "closed"), [(2.8, 1), (3.2, 0)])
def test_path_with_a_gap_below_three_percent_counts_as_closed(gap, closed):
    around = [(0, 0, 0), (25, 0, 0), (25, 25, 0), (0, 25, 0), (0, gap, 0)]
    path = linearize(programs.program([around, [(x + 100, y, z) for x, y, z in around]]))
    assert find_visits(path, monotonous_areas(path)).closed.tolist() == [closed] * 2


def two_visits(**changed):
    """Return two visits (trajectories between two retracts to the top) that differ in every measure."""
    told = {
        "first": [0, 10], "last": [8, 20], "blocks": [2, 6], "low": [[0, 0], [10, 0]], "high": [[30, 40], [50, 40]],
        "bottom": [-2, -5], "top": [0, -1], "begin": [0, -3], "length": [100, 50], "feed": [10, 5], "fastest": [20, 20],
        "turn": [1, 3], "chord": [0.1, 0.5], "closed": [0.9, 0.2], "axis": [1, 0.5j],
    }  # fmt: skip
    return Visits(**{name: np.array(changed.get(name, values), complex if name == "axis" else float)
                     for name, values in told.items()})  # fmt: skip


def backwards(visits):
    return Visits(*(values[::-1] for values in vars(visits).values()))


def test_measures_of_two_stretches_between_retracts_are_exact():
    told = {name: values.item() for name, values in compare_visits(two_visits()).items()}
    series = {name: told.pop(name) for name in [*told] if name.startswith("series_")}
    assert series == {name: told[name[len("series_") :]] for name in series}
    small = 0.05
    shared, one, other = (20 + small) * (40 + small), (30 + small) * (40 + small), (40 + small) * (40 + small)
    expected = {
        "feed": 0.5, "same_feed": 1, "same_ground": 0, "overlap": shared / (one + other - shared), "inside": shared / one,
        "same_bottom": 0, "higher_bottom": 0, "deeper": -3 / 5, "same_top": 0, "same_begin": 0, "higher_begin": 0,
        "size": np.log(np.hypot(40, 40) / 50), "length": np.log((100 + small) / (50 + small)),
        "block_length": np.log((50 + small) / (50 / 6 + small)), "block_count": np.log(3), "fewer_blocks": np.log(2),
        "more_blocks": np.log(6), "turn": np.log(3.1 / 1.1), "chord": 0.4, "closed": 0.7, "axis": np.hypot(1, 0.5),
        "visits": np.log(2), "again": 0, "again_above": 0,
    }  # fmt: skip
    assert told == pytest.approx(expected)
    # If the two visits are swapped, only the measures that compare their heights change.
    expected.update({"higher_bottom": 1, "higher_begin": 1, "deeper": 3 / 5})
    # `again` is the common area of both visits as a share of the area that is cut after the retract.
    expected.update({"again": shared / one, "again_above": shared / one})
    found = compare_visits(backwards(two_visits()))
    assert {name: found[name].item() for name in expected} == pytest.approx(expected)


@pytest.mark.parametrize(
    ("name", "values", "measure"),
    [
        ("bottom", [-5, -5.01], "same_bottom"), ("top", [0, 0.01], "same_top"), ("begin", [0, -0.01], "same_begin"),
        ("fastest", [20, 20.1], "same_feed"),
    ],
)  # fmt: skip
def test_heights_and_feeds_of_cuts_are_equal_within_rounding(name, values, measure):
    assert compare_visits(two_visits(**{name: values}))[measure] == 1
    # Heights differ by 0.03 mm, or feeds by 1.5 %.
    apart = [values[0], values[0] + 3 * (values[1] - values[0])]
    assert compare_visits(two_visits(**{name: apart}))[measure] == 0


@pytest.mark.parametrize(
    ("low", "high", "same"),
    [
        ([[10, 10], [10, 10]], [[30, 40], [30, 40]], 1),
        ([[10, 10], [12, 10]], [[30, 40], [30, 40]], 0),
        ([[10, 10], [10, 10]], [[30, 40], [30, 42]], 0),
        # The corners of equal boxes differ by at most a hundredth of the diagonal plus 0.1 mm, in total 0.46 mm.
        ([[10, 10], [10.4, 10]], [[30, 40], [30, 40]], 1),
        ([[10, 10], [10.5, 10]], [[30, 40], [30, 40]], 0),
    ],
)
def test_boxes_that_differ_by_a_hundredth_are_the_same_area(low, high, same):
    told = compare_visits(two_visits(low=low, high=high))
    assert told["same_ground"] == same


def test_main_axes_around_a_retract_are_compared_by_their_angle():
    """An axis is stored as a direction at twice its angle.

    The axis is compared with an equal axis, with half its length, and with an axis at a right angle.
    """
    for other, differ in ((1, 0), (0.5, 0.5), (-1, 2)):
        assert compare_visits(two_visits(axis=[1, other]))["axis"] == pytest.approx(differ)


def test_cuts_in_separate_places_have_no_common_area():
    told = compare_visits(two_visits(low=[[0, 0], [40, 50]], high=[[30, 40], [50, 60]]))
    assert told["overlap"] == told["inside"] == told["same_ground"] == 0
    told = compare_visits(two_visits(low=[[0, 0], [0, 0]], high=[[0, 0], [0, 0]]))
    # All holes before and after the retract are in one place.
    assert told["overlap"] == told["inside"] == told["same_ground"] == 1 and told["size"] == 0


def test_area_cut_again_after_at_most_eight_retracts_is_found():
    """After ten squares of 10 mm side by side, half of a square is cut again, at the same depth, higher or lower."""
    low = np.array([[20.0 * k, 0.0] for k in range(10)])
    for back, place in ((1, 9), (8, 2), (9, 1)):
        for z, again, above in ((-1.0, 1, 0), (-0.5, 1, 1), (-2.0, 0, 0)):
            corner = low[place] + (5.0, 0.0)
            visits = Visits(*(np.repeat(values[:1], 11, axis=0) for values in vars(two_visits()).values()))
            visits = replace(
                visits,
                low=np.vstack([low, corner]),
                high=np.vstack([low, corner]) + 10.0,
                bottom=np.append(np.full(10, -1.0), z),
            )
            found = compare_visits(visits)
            half = (5.05 * 10.05) / 10.05**2 * (back <= 8)  # Cuts that end nine retracts earlier are not compared.
            last = found["again"][-1], found["again_above"][-1]
            assert last == pytest.approx((again * half, above * half)), (back, z)
            assert not found["again"][:-1].any() and not found["again_above"][:-1].any()


def in_turns(count, *drawn):
    """Return the toolpath of `count` strokes, and the trajectories at which all strokes but the first begin.

    The strokes alternate between the shapes in `drawn`. Each stroke lies 200 mm farther in X.
    """
    strokes = [[(x + 200.0 * k, y, z) for x, y, z in drawn[k % len(drawn)]] for k in range(count)]
    path = linearize(programs.program(strokes))
    return path, (np.flatnonzero(path.rapid[:-1] & ~path.rapid[1:])).tolist()


ROWS = [(x, 3.0 * row, 0.0) for row in range(10) for x in ((0.0, 50.0) if row % 2 else (50.0, 0.0))]
SPIRAL = winding(2, 26, 8)


@pytest.mark.parametrize("count", [2, 3, 4, 5])
def test_alternating_strategies_are_one_operation(count):
    path, begins = in_turns(count, ROWS, SPIRAL)
    assert dividing_retracts(Sections(path, TOOL), [], dict.fromkeys(begins, 0.2)) == (begins if count < 4 else [])


def test_doubtful_retract_divides_if_likely_or_strategies_differ():
    path, (at,) = in_turns(2, ROWS, SPIRAL)
    one, two = Sections(path, TOOL).between([at])
    for odds, parts in ((0.58, []), (0.62, [at])):
        by_votes = odds / _odds_of_difference(one.found, two.found)
        assert dividing_retracts(Sections(path, TOOL), [], {at: by_votes / (1 + by_votes)}) == parts
    path, (at,) = in_turns(2, ROWS)
    assert [dividing_retracts(Sections(path, TOOL), [], {at: share}) for share in (0.28, 0.32)] == [[], [at]]


def test_ramp_down_from_the_retract_height_is_not_a_retract():
    """The first visit begins with a ramp from the retract height.

    A lift of 3 mm after the ramp does not end the visit.
    """
    path = linearize([
        ("G0", {"X": 0.0, "Y": 0.0, "Z": 9.0}), ("G1", {"X": 30.0, "Z": -1.0, "F": 10.0}), ("G0", {"Z": 2.0}),
        ("G0", {"X": 40.0}), ("G1", {"Z": -1.0, "F": 10.0}), ("G1", {"X": 60.0, "F": 10.0}), ("G0", {"Z": 9.0}),
        ("G0", {"X": 80.0}), ("G1", {"Z": -1.0, "F": 10.0}), ("G1", {"X": 90.0, "F": 10.0}), ("G0", {"Z": 9.0}),
    ])  # fmt: skip
    assert find_visits(path, monotonous_areas(path)).blocks.tolist() == [2, 1]


def test_series_measure_is_the_mean_over_neighbouring_retracts():
    tops = [0, 0, 5, 9, 9]  # The first two heights of the toolpath are equal, and the last two heights are equal.
    visits = Visits(*(np.repeat(values[:1], 5, axis=0) for values in vars(two_visits()).values()))
    found = compare_visits(replace(visits, top=np.array(tops, float)))
    assert found["same_top"].tolist() == [1, 0, 0, 1]
    assert found["series_same_top"].tolist() == [0, 0.5, 0.5, 0]


def test_measures_of_cuts_between_two_retracts_are_exact():
    """Before the retract, the tool cuts a square and a deeper, faster line; after it, a line back and a hole."""

    def lines(*points, z, feed):
        yield "G1", {"Z": z, "F": feed}
        yield from (("G1", {"X": x, "Y": y, "F": feed}) for x, y in points)

    path = linearize([
        ("G0", {"X": 0.0, "Y": 0.0, "Z": 9.0}), *lines((10, 0), (10, 10), (0, 10), (0, 0), z=-1.0, feed=10.0),
        ("G0", {"Z": 2.0}), ("G0", {"X": 20.0}), *lines((20, 30), z=-2.0, feed=20.0),
        ("G0", {"Z": 2.0}), ("G0", {"Z": 9.0}), ("G0", {"X": 60.0, "Y": 5.0}), *lines((40, 5), z=-3.0, feed=10.0),
        ("G0", {"Z": 2.0}), ("G0", {"X": 70.0}), ("G81", {"Z": -6.0, "R": 2.0, "F": 5.0}),
    ])  # fmt: skip
    visits = find_visits(path, monotonous_areas(path))
    assert len(visits) == 2 and visits.blocks.tolist() == [2, 2]
    assert visits.low.tolist() == [[0, 0], [40, 5]] and visits.high.tolist() == [[20, 30], [70, 5]]
    assert visits.bottom.tolist() == [-2, -6] and visits.top.tolist() == [-1, -3] and visits.begin.tolist() == [-1, -3]
    assert visits.length == pytest.approx([70, 20]) and visits.fastest.tolist() == [20, 10]
    assert visits.feed == pytest.approx([(40 * 10 + 30 * 20) / 70, 10])
    assert visits.turn == pytest.approx([0.75 / 2, 0]) and visits.chord == pytest.approx([30 / 70, 1])
    assert visits.closed == pytest.approx([40 / 70, 0]) and visits.axis == pytest.approx([-30 / 70, 1])
    assert path.command[visits.first].tolist() == [2, 14] and path.command[visits.last].tolist() == [9, 17]


def test_mixed_program_has_a_confidence_like_its_operations():
    path = after(DIFFERENT["zigzag"], DIFFERENT["helix"])
    found = recognize(path, tool_diameter=TOOL, program=True)
    parts = [recognize(linearize(DIFFERENT[name]), tool_diameter=TOOL).confidence for name in ("zigzag", "helix")]
    assert found.strategy is Strategy.MIXED and min(parts) - 0.1 < found.confidence <= max(parts) + 1e-9
