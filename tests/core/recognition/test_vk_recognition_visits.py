# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs are divided by how they move: with no title, no tool change and nothing but a rapid between operations."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import programs
import pytest

from vkworkbench.core import Strategy, linearize, recognize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.borders import MEASURES
from vkworkbench.core.recognition.forest import Forest
from vkworkbench.core.recognition.visits import begun, compared, find_visits

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
    """One toolpath after the other, up to the clearance height between them."""
    commands = [*first, ("G0", {"Z": programs.CLEAR}), *second]
    path = linearize(commands)
    return replace(path, comments=(), tool_changes=np.empty(0, np.int64))


def test_most_pairs_of_operations_are_told_apart():
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
def test_an_operation_that_retracts_within_itself_is_one(name):
    # At four places of the part, as pockets of one operation are.
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


def test_visits_lie_between_retracts_to_the_top():
    path = after(DIFFERENT["profile"], DIFFERENT["helix"])
    visits = find_visits(path, monotonous_areas(path))
    top = path.points[:, 2].max()
    for last, first in zip(visits.last[:-1], visits.first[1:]):
        assert path.points[last + 1 : first + 1, 2].max() == top
    assert compared(visits).shape == (len(visits) - 1, len(MEASURES))
    assert np.isfinite(compared(visits)).all()


def test_borders_stand_before_the_way_down():
    path = after(DIFFERENT["zigzag"], DIFFERENT["drilling"])
    for at in begun(path, monotonous_areas(path)):
        assert path.points[at, 2] == path.points[:, 2].max() and path.rapid[at]


@pytest.mark.parametrize("commands", [[], [("G0", {"X": 5.0})], [("G1", {"X": 5.0, "Y": 1.0})]])
def test_next_to_nothing_has_no_borders(commands):
    path = linearize(commands)
    assert begun(path, monotonous_areas(path)) == {}


def test_nothing_is_mixed_that_has_one_name():
    path = after(DIFFERENT["zigzag"], DIFFERENT["zigzag"])
    assert recognize(path, tool_diameter=TOOL, program=True).strategy is Strategy.ZIGZAG


def test_a_forest_is_the_mean_of_its_trees():
    forest = Forest(["0<0.5 0:100 1<2 1:100 2:50,1:50", "2:100"], 3)
    shares = forest.shares(np.array([[0.0, 9.0], [1.0, 1.0], [1.0, 3.0]]))
    assert shares.tolist() == [[0.5, 0.0, 0.5], [0.0, 0.5, 0.5], [0.0, 0.25, 0.75]]


def test_only_what_may_be_a_program_is_divided():
    path = after(DIFFERENT["profile"], DIFFERENT["helix"])
    assert len(recognize(path, tool_diameter=TOOL, program=True).spans) == 2
    assert len(recognize(path, tool_diameter=TOOL).spans) == 1


def test_operations_between_two_tool_changes_are_told_apart_at_their_own_top():
    one, two, three = DIFFERENT["zigzag"], DIFFERENT["helix"], DIFFERENT["profile"]
    up = [("G0", {"Z": programs.CLEAR + 100.0})]
    path = linearize([*one, ("G0", {"Z": programs.CLEAR}), *two, *up, *three, *up, *one])
    path = replace(path, comments=(), tool_changes=np.empty(0, np.int64))
    found = recognize(path, tool_diameter=TOOL, program=True)
    assert [str(s.strategy) for s in found.spans] == ["zigzag", "helix", "profile", "zigzag"]


@pytest.mark.parametrize("name", ["zigzag", "helix", "contour-parallel"])
@pytest.mark.parametrize("last", [False, True])
def test_a_single_hole_is_an_operation_of_a_program(name, last):
    hole = programs.SOUND["drilling"](1, 1, 20.0, "G81")
    pair = (DIFFERENT[name], hole) if last else (hole, DIFFERENT[name])
    found = recognize(after(*pair), tool_diameter=TOOL, program=True)
    names = [name, "drilling"] if last else ["drilling", name]
    assert [str(s.strategy) for s in found.spans] == names


def test_two_operations_of_one_strategy_keep_their_border_in_a_mixed_program():
    pocket, rows = DIFFERENT["contour-parallel"], DIFFERENT["zigzag"]
    border, second = len(linearize(pocket)), len(linearize([*pocket, *pocket]))
    path = replace(linearize([*pocket, *pocket, *rows]), comments=(), tool_changes=np.array([border, second]))
    as_program = recognize(path, tool_diameter=TOOL, program=True)
    assert [str(s.strategy) for s in as_program.spans] == ["contour-parallel", "contour-parallel", "zigzag"]
    assert as_program.spans[1].first >= border > as_program.spans[0].last
    as_operation = recognize(path, tool_diameter=TOOL)
    assert [str(s.strategy) for s in as_operation.spans] == ["contour-parallel", "zigzag"]


def test_a_visit_reaches_as_far_as_its_last_move():
    path = linearize([
        ("G0", {"X": 5.0, "Y": 5.0, "Z": 5.0}), ("G1", {"Z": -1.0}), ("G1", {"X": 9.0}), ("G1", {"X": 20.0, "Y": -3.0}),
        ("G0", {"Z": 5.0}), ("G0", {"X": 50.0, "Y": 50.0}), ("G1", {"Z": -1.0}), ("G1", {"X": 40.0, "Y": 70.0}),
    ])  # fmt: skip
    visits = find_visits(path, monotonous_areas(path))
    assert visits.low.tolist() == [[5, -3], [40, 50]]
    assert visits.high.tolist() == [[20, 5], [50, 70]]


@pytest.mark.parametrize(("corner", "same"), [((20.0, 20.0), 1.0), ((29.0, 20.0), 0.0), ((20.0, 29.0), 0.0)])
def test_the_same_ground_has_the_same_corners(corner, same):
    def rectangle(x, y):
        corners = ((x, 0.0), (x, y), (0.0, y), (0.0, 0.0))
        return [("G0", {"X": 0.0, "Y": 0.0}), ("G1", {"Z": -1.0}), *[("G1", dict(zip("XY", at))) for at in corners]]

    path = after([("G0", {"Z": programs.CLEAR}), *rectangle(20.0, 20.0)], rectangle(*corner))
    (row,) = compared(find_visits(path, monotonous_areas(path)))
    assert row[MEASURES.index("same_ground")] == same
