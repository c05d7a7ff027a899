# SPDX-License-Identifier: LGPL-2.1-or-later
"""The extent of moves in an image, the moves that can meet the stock, and their rays."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from counting import memory
from zbuffer_inputs import BOX, DIRECTIONS, toolpath

from vkworkbench.core import Cut, Tool, View
from vkworkbench.core.zbuffer.memory import sampling
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.sweeps import trajectories
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts
from vkworkbench.core.zbuffer.sweeps.trajectories import Kind, Trajectories

FLAT, BALL = Tool("endmill", 6), Tool("ballend", 4)  # The block has 40 x 30 x 10 mm.
ABOVE, BELOW = (0, 0, -1), (0, 0, 1)


def ready(*cuts, direction=ABOVE):
    paths = [Cut(toolpath(np.array(points, float)), tool) for tool, points in cuts]
    return Trajectories(Cuts(paths), BOX, View(direction, 80, 60).frame(BOX))


@pytest.mark.parametrize(
    "move, meets",
    [
        ([(-5, 15, 5), (-2.9, 15, 5)], True), ([(-5, 15, 5), (-3.1, 15, 5)], False),
        ([(45, 15, 5), (42.9, 15, 5)], True), ([(43.1, 15, 5), (45, 15, 5)], False),
        ([(20, -5, 5), (20, -2.9, 5)], True), ([(20, -3.1, 5), (20, -5, 5)], False),
        ([(20, 32.9, 5), (20, 40, 5)], True), ([(20, 33.1, 5), (20, 40, 5)], False),
        ([(20, 15, 20), (25, 15, 9.9)], True), ([(20, 15, 20), (25, 15, 10.1)], False),
        ([(20, 15, -20), (25, 15, -10)], True),  # The tool has no upper end.
    ],
)  # fmt: skip
def test_moves_beside_or_above_stock_are_left_out(move, meets):
    away = [(100, 100, 5), (101, 100, 5)]
    assert ready((FLAT, away), (FLAT, move)).index.tolist() == ([1] if meets else [])


def test_moves_have_their_tools_and_kinds():
    """A vertical move, up or down, is stored as a move of zero length at its lower end."""
    some = ready(
        (BALL, [(5, 5, 5), (15, 5, 5), (15, 5, 3), (15, 5, 8), (5, 5, 6)]), (FLAT, [(5, 20, 7), (9, 23, 7)]),
        (BALL, [(30, 20, 2), (30, 20, 1)]),
    )  # fmt: skip
    level, sloped, flat = Kind(BALL, True), Kind(BALL, False), Kind(FLAT, True)
    assert [some.kinds[k] for k in some.kind] == [level, level, level, sloped, flat, level]
    assert [some.tools[k] for k in some.tool] == [BALL, BALL, BALL, BALL, FLAT, BALL]
    assert some.radius.tolist() == [2, 2, 2, 2, 3, 2]
    assert some.start.T.tolist() == [
        [-15, -10, 0],
        [-5, -10, -2],
        [-5, -10, -2],
        [-5, -10, 3],
        [-15, 5, 2],
        [10, 5, -4],
    ]
    assert some.move.T.tolist() == [[10, 0, 0], [0, 0, 0], [0, 0, 0], [-10, 0, -2], [4, 3, 0], [0, 0, 0]]
    assert some.heading.T.tolist() == [[1, 0, 10, 0], [1, 0, 0, 0], [1, 0, 0, 0], [-1, 0, 10, -0.2], [0.8, 0.6, 5, 0],
                                       [1, 0, 0, 0]]  # fmt: skip

    def divided(parts, items):
        everything = np.arange(len(items))
        return [(name, everything[own].tolist()) for name, own in parts]

    items = np.array([3, 4, 0, 5])
    by_kind = {some.kinds[k]: own for k, own in divided(some.by_kind(items), items)}
    assert by_kind == {sloped: [0], flat: [1], level: [2, 3]}
    assert dict(divided(some.by_tool(items), items)) == {BALL: [0, 2, 3], FLAT: [1]}
    assert dict(divided(some.by_tool(items[[0, 2]]), items[[0, 2]])) == {BALL: [0, 1]}


MOVES = [((5, 5, 4), (30, 20, 4)), ((30, 5, 3), (10, 12, 3)), ((20, 15, 6), (20, 15, 2)), ((8, 25, 2), (8, 9, 2)),
         ((5, 5, 8), (30, 20, 2)), ((30, 5, 1), (10, 25, 7)), ((8, 25, 3), (8, 9, 9))]  # fmt: skip
LEVEL = 4


def swept(move, frame):
    """Return points in image coordinates: on the edge of a moving flat end, and above them at the block's top."""
    angle = np.linspace(0, 2 * pi, 361)
    rim = 3 * np.column_stack((np.cos(angle), np.sin(angle), 0 * angle))
    start, end = np.array(move, float)
    if (start[:2] == end[:2]).all():
        start = end = min(start, end, key=lambda at: at[2])
    below = (start + np.linspace(0, 1, 3)[:, None, None] * (end - start) + rim).reshape(-1, 3)
    points = np.concatenate((below, [(x, y, 10) for x, y, _ in below]))
    return (points - frame.centre) @ np.array([frame.right, frame.up]).T


def test_rounding_difference_in_height_is_a_level_move():
    level, up = ready((FLAT, [(5, 5, 0.1 + 0.2), (15, 5, 0.3), (25, 5, 0.3 + 2e-9)])).kind.tolist()
    assert level != up and ready((FLAT, [(5, 5, 0.1 + 0.2), (15, 5, 0.3)])).kinds == (Kind(FLAT, True),)


@pytest.mark.parametrize("direction", DIRECTIONS)
@pytest.mark.parametrize("number", range(len(MOVES)))
def test_boxes_and_strips_in_the_image_contain_swept_volumes(number, direction):
    some = ready((FLAT, MOVES[number]), direction=direction)
    x, y = swept(MOVES[number], some.frame).T
    ((left, right, bottom, top), (nx, ny, low, high)) = some.box[:, 0], some.strip[:, 0]
    across = nx * x + ny * y
    assert np.hypot(nx, ny) == pytest.approx(1)
    told = np.array([left, bottom, low, -right, -top, -high])
    there = np.array([x.min(), y.min(), across.min(), -x.max(), -y.max(), -across.max()])
    assert (told <= there + 1e-3).all()
    if number < LEVEL:
        assert told == pytest.approx(there, abs=1e-3)
    else:
        assert told[[0, 3]] == pytest.approx(there[[0, 3]], abs=1e-3)
        assert (told > there - 8).all()  # The error of the compared height is less than the height of the move.


def test_box_of_a_part_of_a_move_contains_only_this_part():
    some = ready((FLAT, MOVES[0]))
    parts = some.boxes(np.array([0, 0]), np.array([0.0, 0.2]), np.array([1.0, 0.6]))
    # The part of the move is from (-10, -7) to (0, -1).
    assert parts.T.tolist() == [some.box[:, 0].tolist(), [-13, 3, -10, 2]]


@pytest.mark.parametrize("direction", DIRECTIONS)
def test_moves_that_meet_a_rectangle_of_the_image_are_found(direction):
    rng = np.random.default_rng(4)
    some = ready(*((FLAT, move) for move in MOVES), direction=direction)
    left, bottom = rng.uniform(-30, 30, (2, 40))
    wide, high = rng.uniform(0.1, 6, (2, 40))
    rectangle, item = some.meeting(left, left + wide, bottom, bottom + high)
    expected = []
    for r in range(40):
        for k in range(len(MOVES)):
            nx, ny, low, up = some.strip[:, k]
            corners = [nx * x + ny * y for x in (left[r], left[r] + wide[r]) for y in (bottom[r], bottom[r] + high[r])]
            box = some.box[:, k]
            beside = (
                box[0] > left[r] + wide[r] or box[1] < left[r] or box[2] > bottom[r] + high[r] or box[3] < bottom[r]
            )
            if not beside and max(corners) >= low and min(corners) <= up:
                expected.append((r, k))
    assert list(zip(rectangle.tolist(), item.tolist())) == expected
    x, y, item = rng.uniform(-25, 25, 900), rng.uniform(-20, 20, 900), rng.integers(0, len(MOVES), 900)
    (a, b, c, d), (nx, ny, low, up) = some.box[:, item], some.strip[:, item]
    inside = (a <= x) & (x <= b) & (c <= y) & (y <= d) & (low <= nx * x + ny * y) & (nx * x + ny * y <= up)
    assert some.passing(x, y, item).tolist() == inside.tolist() and 20 < inside.sum() < 880


def test_intervals_of_rays_from_above_and_below_are_exact():
    """Slots are cut at z = 7 and z = 3; depth 0 is z = 5.

    If the tools are replaced, the ray misses the new tool, or the new tool is 0.5 mm higher.
    """
    cuts = (FLAT, [(5, 10, 7), (35, 10, 7)]), (BALL, [(5, 20, 3), (35, 20, 3)])
    x, y, item = np.array([0.0, 0.0, 0.0, 0.0]), np.array([-5.0, 5.0, -5.0, -1.9]), np.array([0, 1, 1, 0])
    for direction, sign in ((ABOVE, 1), (BELOW, -1)):
        some = ready(*cuts, direction=direction)

        def told(tools=None, some=some, sign=sign):
            near, far = some.intervals(x, sign * y, item, tools)
            opened, open_end = (far, near) if sign > 0 else (near, far)
            missed = ~(near <= far)
            assert (open_end[~missed] == -sign * np.inf).all()
            return [None if gone else depth for depth, gone in zip((sign * opened).tolist(), missed)]

        assert told() == [-2, 2, None, None]
        number = {some.kinds[k].tool: k for k in range(2)}
        other = [None, None]
        other[number[FLAT]], other[number[BALL]] = (Tool("endmill", 8), 0.5), (None, 0.0)
        assert told(other) == [-2.5, None, None, -2.5]


def test_intervals_on_rays_do_not_depend_on_batch_size(monkeypatch):
    some = ready(*((tool, move) for tool in (FLAT, BALL) for move in MOVES), direction=(1, 1, -1))
    rng = np.random.default_rng(5)
    x, y, item = rng.uniform(-20, 20, (3, 500)), rng.uniform(-15, 15, 500), rng.integers(0, 14, 500)
    whole = some.intervals(x, y, item)
    monkeypatch.setattr(trajectories, "AT_ONCE", 64)
    for one, other in zip(whole, some.intervals(x, y, item)):
        np.testing.assert_allclose(one, other, rtol=1e-12)
    assert (whole[0] < whole[1]).sum() > 100


@pytest.mark.parametrize("direction", [ABOVE, (1, 1, -1)])
def test_prepared_trajectories_do_not_depend_on_batch_size(direction, monkeypatch):
    """Some cuts have no trajectories, and all trajectories of some cuts miss the stock."""
    rng = np.random.default_rng(6)
    away, nothing = np.array([(100.0, 100, 5), (101, 100, 5)]), np.empty((0, 3))
    paths = [
        nothing,
        rng.uniform((-9, -9, 2), (49, 39, 12), (40, 3)),
        away,
        nothing,
        rng.uniform(3, 9, (30, 3)),
        nothing,
    ]
    cuts = Cuts([Cut(toolpath(points), tool) for points, tool in zip(paths, (FLAT, BALL) * 3)])
    rectangles = rng.uniform(-20, 20, (2, 7))
    rectangles = (rectangles[0], rectangles[0] + 4, rectangles[1], rectangles[1] + 3)

    def prepared():
        some = Removal(cuts, BOX, View(direction, 80, 60).frame(BOX))
        measured = (some.index, some.radius, some.start, some.move, some.heading, some.box, some.strip, some.kind)
        return *measured, *some.meeting(*rectangles), *vars(sampling.sample(some, np.random.default_rng(7))).values()

    whole = prepared()
    assert 40 < len(whole[0]) < len(cuts) - 1 and len(whole[-1]) > 100
    monkeypatch.setattr(trajectories, "AT_ONCE", 3)
    monkeypatch.setattr(sampling, "AT_ONCE", 4)
    monkeypatch.setattr(trajectories, "_PAIRS_HELD", 150)
    for one, other in zip(whole, prepared()):
        np.testing.assert_allclose(one, other, rtol=1e-12, atol=1e-12)


def test_preparing_trajectories_needs_little_memory():
    """An analysis prepares the trajectories of a whole job, so temporary arrays must stay small beside the result."""
    points = np.random.default_rng(8).uniform((0, 0, 2), (40, 30, 9), (200_001, 3))
    cuts = Cuts([Cut(toolpath(points), FLAT)])
    frame = View(ABOVE, 80, 60).frame(BOX)
    assert len(cuts.cut) == 200_000
    some, held, peak = memory(lambda: Trajectories(cuts, BOX, frame))
    assert len(some.index) == 200_000 and peak < 1.25 * held
