# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a height field from any direction, compared with a z-buffer simulated in this direction."""

from __future__ import annotations

from functools import lru_cache
from itertools import product
from math import cos, pi, sin

import numpy as np
import pytest
from zbuffer_inputs import HOLLOW, ball

from vkworkbench.core import Cut, Cylinder, Mesh, Stock, Tool, View, linearize, simulate_job
from vkworkbench.core.rendering import CUT, Field, palette, scene
from vkworkbench.core.zbuffer import STOCK

BLOCK = Stock((0, 0, 0), (60, 40, 12))
WIDTH, HEIGHT = 300, 200
RAPID, TOP = {"Z": 20.0}, 12.0


def cut(moves, diameter=6.0, kind="endmill", **form):
    return Cut(linearize([("G0", RAPID), *moves, ("G0", RAPID)]), Tool(kind, diameter, **form))


def ring(x, y, radius, z, parts=40):
    angles = np.linspace(0, 2 * pi, parts + 1)
    places = [{"X": x + radius * cos(angle), "Y": y + radius * sin(angle)} for angle in angles]
    return [("G0", places[0]), ("G1", {"Z": z}), *(("G1", place) for place in places), ("G0", RAPID)]


def holes(places, z):
    return [move for x, y in places for move in (("G0", {"X": x, "Y": y}), ("G1", {"Z": z}), ("G0", RAPID))]


def rows(x, y, z, step=2.0):
    moves = [("G0", {"X": x[0], "Y": y[0]}), ("G1", {"Z": z})]
    for number, across in enumerate(np.arange(y[0], y[1], step)):
        ends = x if number % 2 == 0 else x[::-1]
        moves += [("G1", {"X": end, "Y": float(across)}) for end in ends]
    return [*moves, ("G0", RAPID)]


def waves(x, y, z, step=1.0):
    moves = []
    for number, across in enumerate(np.arange(y[0], y[1], step)):
        along = np.linspace(*x, 40)[:: 1 if number % 2 == 0 else -1]
        moves += [
            ("G1", {"X": float(a), "Y": float(across), "Z": float(z + 2 * sin(a / 4) * cos(across / 5))}) for a in along
        ]
    return [*moves, ("G0", RAPID)]


POCKETS = [cut(rows((10.0, 30.0), (8.0, 30.0), 7.0)), cut(rows((14.0, 26.0), (12.0, 26.0), 3.0), 4.0)]
THROUGH = [cut(holes([(8.0, 8.0), (30.0, 20.0), (50.0, 30.0)], -1.0), 7.0), cut(rows((40.0, 62.0), (-2.0, 16.0), 6.0))]
WAVES = [cut(waves((8.0, 52.0), (6.0, 34.0), 7.0), 6.0, "ballend")]
JOBS = {
    "pockets": (BLOCK, POCKETS),
    "through holes": (BLOCK, THROUGH),
    "waves": (BLOCK, WAVES),
    "grooves": (BLOCK, [cut(ring(30.0, 20.0, 14.0, 8.0)), cut(ring(30.0, 20.0, 7.0, 5.0), 4.0)]),
    "chamfers": (BLOCK, [cut(ring(30.0, 20.0, 12.0, 9.0), 8.0, "vbit", tip_angle=pi / 2)]),
    "cut to pieces": (BLOCK, [cut(rows((20.0, 21.0), (-4.0, 44.0), -1.0)), cut(ring(45.0, 20.0, 9.0, -1.0), 3.0)]),
    "everything": (BLOCK, [*POCKETS, *THROUGH, *WAVES]),
    "upright cylinder": (Cylinder((30, 20, 0), 20, 12), [*POCKETS, *THROUGH]),
    "ball": (Mesh(ball((30, 20, 6), 6, 24) * (3, 3, 1) - (60, 40, 0)), [*POCKETS, *THROUGH]),
    "hollow": (Mesh(HOLLOW), [cut(rows((5.0, 34.0), (14.0, 22.0), 5.0)), cut(holes([(10.0, 8.0), (36.0, 5.0)], -1.0))]),
}
DIRECTIONS = [
    (0, 0, -1), (-1, 1, -1), (1, 1, -1), (1, -1, -1), (-1, -1, -1), (0, 1, 0), (1, 0, 0), (0.3, 1, -0.2), (-1, 0.1, -0.05), (0.1, 0.05, -1),
    (0, 0, 1), (-1, 1, 1), (1, -0.4, 1), (0.2, 1, 0.1), (0.1, -0.1, 1), (-1, 0, 0), (-0.5, 0.2, -1), (0.7, 1, -0.7), (1, 0, -3), (2, -3, 1.5),
]  # fmt: skip


@lru_cache(maxsize=None)
def field(name, step=None):
    """Return the height field of a simulated job, with about one cell for each pixel of the pictures."""
    stock, cuts = JOBS[name]
    done = simulate_job(cuts, stock=stock, view=View(width=WIDTH, height=HEIGHT))
    return Field(done if step is None else done.at(step))


def around(values, extreme):
    """Return the maximum or minimum of each pixel and its eight neighbours.

    `extreme` is np.maximum or np.minimum, or np.fmax or np.fmin to ignore NaN.
    """
    padded = np.pad(values, 1, mode="edge")
    height, width = values.shape
    return extreme.reduce([padded[y : y + height, x : x + width] for y, x in product(range(3), repeat=2)])


def agreement(name, view, step=None):
    """Return the shares of pixels equal to the exact z-buffer: background, operation away from edges, and depth."""
    stock, cuts = JOBS[name]
    exact = simulate_job(cuts, stock=stock, view=view)
    exact = exact if step is None else exact.at(step)
    depth, owner = (part.reshape(view.height, view.width) for part in (exact.picture.depth, exact.picture.owner))
    drawn = scene(field(name, step), view.frame(stock), palette(CUT))
    seen = ~np.isnan(depth)
    both = seen & ~np.isnan(drawn.depth)
    by_cut = np.append(exact.cuts.cut, -1)
    operation, drawn_operation = by_cut[owner], by_cut[drawn.owner]
    inside = both & (around(operation, np.minimum) == around(operation, np.maximum)) & (around(~seen, np.maximum) == 0)
    slope = around(depth, np.fmax) - around(depth, np.fmin)
    return (
        (seen == ~np.isnan(drawn.depth)).mean(),
        (operation == drawn_operation)[inside].mean(),
        (np.abs(drawn.depth - depth) <= slope + field(name).frame.pixel)[both].mean(),
    )


# Each job is drawn from one direction, and in the long tests also from four other directions. Two successive jobs share
# no direction, so each direction is used with two or three jobs.
CASES = [
    pytest.param(name, DIRECTIONS[(7 * number + turn) % 20], marks=() if turn == 4 else pytest.mark.long)
    for number, name in enumerate(JOBS)
    for turn in range(0, 20, 4)
]


@pytest.mark.parametrize(("name", "direction"), CASES)
def test_picture_agrees_with_the_exact_z_buffer(name, direction):
    outline, operation, depth = agreement(name, View(direction, WIDTH, HEIGHT))
    assert outline > 0.995 and operation > 0.99 and depth > 0.98


@pytest.mark.long
@pytest.mark.parametrize("name", ["everything", "hollow"])
def test_zoomed_and_panned_pictures_agree_with_the_z_buffer(name):
    for direction, offset in (((-1, 1, -1), (8.0, -3.0)), ((0.4, 1, -0.6), (-12.0, 4.0)), ((1, 1, 1), (5.0, 5.0))):
        stock, _ = JOBS[name]
        pixel = View(direction, WIDTH, HEIGHT).frame(stock).pixel
        outline, operation, depth = agreement(name, View(direction, WIDTH, HEIGHT, pixel / 3, offset))
        assert outline > 0.98 and operation > 0.97 and depth > 0.97  # A cell is three pixels wide.
        outline, operation, depth = agreement(name, View(direction, WIDTH, HEIGHT, 2 * pixel, offset))
        assert outline > 0.995 and operation > 0.98 and depth > 0.98


@pytest.mark.long
@pytest.mark.parametrize("share", [0.0, 0.3, 0.6])
def test_pictures_of_earlier_moments_agree_with_the_z_buffer(share):
    step = int(share * sum(len(cut.toolpath) for cut in JOBS["everything"][1]))
    outline, operation, depth = agreement("everything", View((-1, 1, -1), WIDTH, HEIGHT), step)
    assert outline > 0.995 and operation > 0.99 and depth > 0.98


def test_picture_beside_the_part_is_empty():
    for direction in DIRECTIONS:
        frame = View(direction, 60, 40, 0.1, (500.0, 300.0)).frame(BLOCK)
        drawn = scene(field("pockets"), frame, palette(CUT), background=(1, 2, 3))
        assert np.isnan(drawn.depth).all() and (drawn.image == (1, 2, 3)).all() and (drawn.owner == STOCK).all()


def test_part_that_is_machined_away_is_empty():
    stock = Stock((0, 0, 0), (10, 10, 5))
    done = simulate_job([cut(rows((0.0, 10.0), (0.0, 11.0), -1.0))], stock=stock, view=View(width=50, height=50))
    for direction in DIRECTIONS:
        drawn = scene(Field(done), View(direction, 60, 40).frame(stock), palette(CUT))
        assert np.isnan(drawn.depth).all()


@pytest.mark.parametrize("angle", np.linspace(0, pi, 7, endpoint=False).tolist())
def test_brightness_of_a_wall_is_uniform(angle):
    """A straight wall in any direction has one brightness."""
    across, along = np.array([cos(angle), sin(angle)]), np.array([-sin(angle), cos(angle)])
    # The material on one side of a line through the middle of the block is removed.
    path = [(30, 20) + across * (3 + 2.5 * number) + along * (80 if number % 2 else -80) for number in range(26)]
    ends = [point for start in path for point in (start, start - 2 * along * ((start - (30, 20)) @ along))]
    moves = [("G1", {"X": float(x), "Y": float(y), "Z": 2.0}) for x, y in ends]
    done = simulate_job(
        [cut([("G0", {**moves[0][1], "Z": 20.0}), *moves])], stock=BLOCK, view=View(width=300, height=200)
    )
    direction = (*-across, -0.3)
    drawn = scene(Field(done), View(direction, WIDTH, HEIGHT).frame(BLOCK), palette((200, 200, 200)))
    middle = drawn.image[HEIGHT // 2 - 3 : HEIGHT // 2 + 3, WIDTH // 2 - 40 : WIDTH // 2 + 40, 0].astype(int)
    assert np.ptp(middle) <= 12
