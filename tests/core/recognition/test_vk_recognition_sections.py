# SPDX-License-Identifier: LGPL-2.1-or-later
"""What parts an operation from the next, and what does not: tool changes, titles, depths and links at feed."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import programs
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from vkworkbench.core import Strategy, linearize, recognize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.parts import _short, find_borders
from vkworkbench.core.recognition.recognition import Recognition, Span
from vkworkbench.core.recognition.unknown import unknown
from vkworkbench.language import Message

TOOL = 5.0
DEEPER = 0.7  # mm; no step of depths that a program here has

MADE = {
    "zigzag": lambda size: programs.SOUND["zigzag"](int(6 * size), 60.0, 3.0, [-1.0]),
    "one-way": lambda size: programs.SOUND["one-way"](int(6 * size), 60.0, 3.0, [-1.0]),
    "contour-parallel": lambda size: programs.SOUND["contour-parallel"](int(4 * size), 36, 3.0, 10.0, [-1.0], 0.0),
    "profile": lambda size: programs.SOUND["profile"](24, 40.0, [-1.0 - k for k in range(int(2 * size))], 0.0),
    "waterline": lambda size: programs.SOUND["waterline"](int(8 * size), 36, 60.0, 1.0),
    "spiral": lambda size: programs.SOUND["spiral"](int(6 * size), 3.0, 48),
    "helix": lambda size: programs.SOUND["helix"](int(5 * size), 15.0, 1.0),
    "drilling": lambda size: programs.SOUND["drilling"](4, int(3 * size), 20.0, "G81"),
    "adaptive": lambda size: programs.SOUND["adaptive"](int(24 * size), 8.0, 1.0),
    "engraving": lambda size: programs.SOUND["engraving"](int(8 * size)),
}
every = pytest.mark.parametrize("name", MADE)


def lifted(path, height):
    """The toolpath `height` higher."""
    return replace(path, points=path.points + (0, 0, height))


def after(first, second):
    """One toolpath after the other: up, over and down at rapid."""
    top = max(first.points[:, 2].max(), second.points[:, 2].max()) + 1.0
    a, b = first.points[-1], second.points[0]
    link = np.array([(*a[:2], top), (*b[:2], top), b])
    new = np.abs(np.diff(np.vstack([a, link]), axis=0)).max(axis=1) > 0
    moves = int(new.sum())

    def joined(name, fill, dtype):
        return np.concatenate([getattr(first, name), np.full(moves, fill, dtype), getattr(second, name)])

    return replace(
        first,
        points=np.concatenate([first.points, link[new], second.points[1:]]),
        rapid=joined("rapid", True, bool),
        command=joined("command", len(first) - 1, np.int64),
        feed=joined("feed", 0.0, float),
        sweep=joined("sweep", 0.0, float),
        plane=joined("plane", 17, np.uint8),
        cycle=joined("cycle", False, bool),
    )


@every
@settings(max_examples=5, deadline=None)
@given(times=st.integers(1, 3))
def test_the_same_operation_deeper_is_the_same_operation(name, times):
    path = linearize(MADE[name](2))
    whole = path
    for k in range(1, times + 1):
        whole = after(whole, lifted(path, -DEEPER * k))
    once, again = recognize(path, tool_diameter=TOOL), recognize(whole, tool_diameter=TOOL)
    assert once.strategy == name
    assert again.strategy == name, again.reason
    assert again.depths in (0, (times + 1) * once.depths) or name == "waterline"


@every
def test_level_moves_at_feed_instead_of_rapid(name):
    path = linearize(MADE[name](2))
    path = after(path, replace(path, points=path.points + (150.0, 90.0, 0.0)))
    level = path.rapid & (np.diff(path.points[:, 2]) == 0)
    fed = replace(path, rapid=path.rapid & ~level, feed=np.where(level, 50.0, path.feed))
    assert level.any()
    assert recognize(path, tool_diameter=TOOL).strategy == name
    assert recognize(fed, tool_diameter=TOOL).strategy == name


SAME_FAMILY = [("zigzag", "one-way"), ("contour-parallel", "profile"), ("spiral", "profile"), ("waterline", "helix")]


@pytest.mark.parametrize("pair", SAME_FAMILY)
@pytest.mark.parametrize("sizes", [(3, 2), (2, 3)])
@pytest.mark.parametrize("turned", [False, True])
def test_a_tool_change_parts_whichever_side_is_longer(pair, sizes, turned):
    one, two = pair[::-1] if turned else pair
    found = recognize(linearize([*MADE[one](sizes[0]), ("M6", {"T": 2.0}), *MADE[two](sizes[1])]), tool_diameter=TOOL)
    assert [str(s.strategy) for s in found.spans] == [one, two], found.reason
    assert found.strategy is Strategy.MIXED


@every
@pytest.mark.parametrize("border", [("M6", {"T": 2.0}), ("(the second)", {})])
@pytest.mark.parametrize("depth", [0.0, -0.3, -2.0])
def test_the_whole_says_nothing_that_all_its_sections_deny(name, border, depth):
    # Somewhere else and at another depth, cut with another tool.
    sections = [linearize(MADE[name](size)) for size in (1, 2)]
    assert all(recognize(s, tool_diameter=TOOL).strategy == name for s in sections)
    one, two = sections
    path = after(one, replace(two, points=two.points + (31.0, 17.0, depth)))
    at = len(path) - len(two)
    parted = {"tool_changes": np.array([at])} if border[0] == "M6" else {"comments": ((at, "the second"),)}
    found = recognize(replace(path, **parted), tool_diameter=TOOL)
    assert found.strategy == name, found.reason


def test_runs_of_holes_are_borders_at_their_first_and_behind_their_last():
    rest = [("G0", {"Z": 5.0})]
    rectangle = [
        ("G1", {"Z": -1.0}),
        *[("G1", {"X": x, "Y": y}) for x, y in ((30.0, 0.0), (30.0, 9.0), (0.0, 0.0))],
        *rest,
    ]
    hole = [("G1", {"Z": -9.0}), *rest]
    start = ("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0})
    away = ("G0", {"X": 50.0})
    milled_first = linearize([start, *rectangle, away, *hole, away, ("G0", {"X": 70.0}), *hole])
    # Trajectories: plunge 0, rectangle 1 to 3, up 4, over 5, hole 6, up 7, over 8, hole 9, up 10.
    assert find_borders(milled_first, monotonous_areas(milled_first)) == {4: True, 10: True}
    drilled_first = linearize([start, *hole, away, *hole, start, *rectangle])
    # Hole 0, up 1, over 2, hole 3, up 4.
    assert find_borders(drilled_first, monotonous_areas(drilled_first)) == {4: True}


def test_moves_that_are_no_cutting_are_unknown_from_the_first_to_the_last():
    path = linearize(
        [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G0", {"X": 5.0}), ("(turn)", {}), ("G0", {"Y": 5.0, "Z": 9.0})]
    )
    found = unknown(path, Message("moves-nothing"))
    assert (found.strategy, found.confidence) == (Strategy.UNKNOWN, 0.0)
    assert found.spans == (Span(0, 1, 1, 3, Strategy.UNKNOWN, 1.0),)


def contour(depths, closed=True):
    """Commands of one contour at some depths."""
    program = []
    for z in depths:
        program += [("G0", {"Z": 5.0}), ("G0", {"X": 0.0, "Y": 0.0}), ("G1", {"Z": z})]
        corners = [(60, 0), (60, 40), (0, 40), (0, 0)][: 4 if closed else 2]
        program += [("G1", {"X": float(x), "Y": float(y)}) for x, y in corners]
    return program


@pytest.mark.parametrize("closed", [True, False])
def test_what_is_cut_once_is_not_said_to_come_again(closed):
    once = recognize(linearize(contour([-1.0], closed)))
    assert once.strategy is Strategy.PROFILE
    assert "again" not in once.reason and "depths" not in once.reason and "repeated" not in once.reason
    thrice = recognize(linearize(contour([-1.0, -2.0, -3.0], closed)))
    assert thrice.strategy is Strategy.PROFILE and "at 3 depths" in thrice.reason


@pytest.mark.parametrize(
    ("loops", "passes", "short"),
    [(0, None, True), (1, 2, True), (2, 2, False), (1, 3, False), (0, 3, False), (2, None, False)],
)
def test_two_loops_or_three_passes_show_a_strategy(loops, passes, short):
    one = Recognition(Strategy.PROFILE, 0.9, Message("moves-nothing"), closed_loops=loops, passes=passes)
    assert _short(one) is short


def beside(drilled, change=()):
    """Twelve loops of a pocket, 2.5 m in all, and `drilled` by 2 holes of 15 mm beside it."""
    pocket = programs.SOUND["contour-parallel"](12, 36, 3.0, 10.0, [-1.0], 0.0)
    return [*pocket, *change, ("G0", {"X": 300.0}), *programs.SOUND["drilling"](drilled, 2, 20.0, "G81")]


@pytest.mark.parametrize("program", [False, True])
def test_a_few_holes_beside_a_pattern_leave_it_its_name_and_have_a_span(program):
    found = recognize(linearize(beside(3)), tool_diameter=TOOL, program=program)
    assert found.strategy is Strategy.CONTOUR_PARALLEL
    assert [s.strategy for s in found.spans] == [Strategy.CONTOUR_PARALLEL, Strategy.DRILLING]
    assert found.spans[1].share < 0.05
    assert found.reason.endswith("with a little drilling beside it"), found.reason
    assert found.passes == 12  # the numbers are those of the pattern


@pytest.mark.parametrize("program", [False, True])
@pytest.mark.parametrize(("drilled", "change"), [(3, [("M6", {"T": 2.0})]), (9, [])])
def test_holes_that_another_tool_drills_or_that_are_many_are_another_operation(drilled, change, program):
    found = recognize(linearize(beside(drilled, change)), tool_diameter=TOOL, program=program)
    assert found.strategy is Strategy.MIXED
    assert [s.strategy for s in found.spans] == [Strategy.CONTOUR_PARALLEL, Strategy.DRILLING]
    assert found.reason.endswith("retracts or drilling show contour-parallel, drilling: mixed")
