# SPDX-License-Identifier: LGPL-2.1-or-later
"""Depth bounds of tiles in oblique views: tools grown and shrunk by half a tile, and depths of the stock on rays."""

from __future__ import annotations

from math import cos, hypot, pi, sin, sqrt

import numpy as np
import pytest
from zbuffer_inputs import BOX, DIRECTIONS, TOOLS, toolpath

from vkworkbench.core import Cut, Stock, Tool, View
from vkworkbench.core.zbuffer.culling.tiles import QUARTERS
from vkworkbench.core.zbuffer.culling.tilted import Tilted, _Growth, _not_yet_open, _TileChords
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts
from vkworkbench.core.zbuffer.sweeps.trajectories import Trajectories

REACH = 0.4
TOOLS = [*TOOLS, Tool("vbit", 6, tip_angle=pi / 2, tip_diameter=2), Tool("vbit", 6, tip_angle=2.6, tip_diameter=5.5)]
# Angles of view directions from the vertical: from above, from below, and nearly from the side.
VIEWS = [(angle, level) for angle in (0.5, 1.1, 2.2) for level in (True, False)] + [(1.5, False)]
SHIFTS = [(a * REACH, b * REACH) for a in (-1, -0.5, 0, 1) for b in (-1, 0.3, 1)]


def moved(shift, angle, level):
    """Return the shift of a ray in space, (x, y, z), for a shift in the image.

    The shift in space is in a horizontal plane (`level`) or in the plane of the image.
    """
    x, y = shift
    return np.array((x, y / cos(angle), 0) if level else (x, y * cos(angle), y * sin(angle)))


def surface(tool, raised):
    """Return points of a tool's lower surface and its rim."""
    r, turn = (of.ravel() for of in np.meshgrid(np.linspace(0, tool.radius, 25), np.linspace(0, 2 * pi, 37)))
    return np.column_stack((r * np.cos(turn), r * np.sin(turn), tool.height(r * (1 - 1e-12)) + raised))


def holds(tool, raised, points):
    r = np.hypot(points[:, 0], points[:, 1])
    inside = np.minimum(r, tool.radius)  # Rounding decides about points exactly on the tool's circumference.
    return (r <= tool.radius + 1e-9).all() and (tool.height(inside) + raised <= points[:, 2] + 1e-5).all()


@pytest.mark.parametrize("angle, level", VIEWS)
@pytest.mark.parametrize("tool", TOOLS, ids=str)
def test_grown_tool_contains_tool_and_shrunk_one_is_inside(tool, angle, level):
    growth = _Growth(tool, level, sin(angle), cos(angle))
    larger, smaller = growth.grown(REACH), growth.shrunk(REACH)
    for shift in SHIFTS:
        by = moved(shift, angle, level)
        assert holds(*larger, surface(tool, 0.0) + by)
        assert smaller[0] is None or holds(tool, 0.0, surface(*smaller) + by)
    # The grown tool is not wider than necessary, and the shrunk tool not narrower.
    corner = moved((REACH, REACH), angle, level)
    ball = tool.rounding == tool.radius
    aside = hypot(*corner) if ball else hypot(*corner[:2])
    assert larger[0].radius == pytest.approx(tool.radius + aside)
    left = tool.radius - aside - (0 if ball else tool.rounding)
    if left > 1e-3:
        assert smaller[0].radius == pytest.approx(left, abs=1e-5)
        # Rounding may decide whether the shrunk tool touches a surface, except for level floors seen from above.
        assert smaller[0].radius < left and (smaller[1] > 0 or (level and not tool.rounding))
    else:
        assert smaller == (None, 0.0)


@pytest.mark.parametrize("direction, level", [
    (direction, level) for direction in DIRECTIONS[2:] for level in (True, False)
    if not level or abs(direction[2]) > 0.3 * np.linalg.norm(direction)
])  # fmt: skip
def test_tile_depths_contain_stock_of_all_rays(direction, level):
    """If depths are measured from a horizontal plane, they grow with the position of a ray in the image (shear)."""
    frame = View(direction, 40, 30).frame(BOX)
    sine, cosine = hypot(*frame.direction[:2]), -frame.direction[2]
    shear = sine / cosine if level else 0.0
    chords = _TileChords(BOX, frame, shear)
    x, y = np.array([0.0, 3.0, -4.0, 1.0]), np.array([0.0, 2.0, 1.0, -5.0])
    near, far = chords.over(x, y, REACH)
    side = np.linspace(-REACH, REACH, 5)
    ends = []
    for dx in side:
        for dy in side:
            one, other = BOX.chords(frame.origins(x + dx, y + dy), frame.direction)
            ends.append((one - shear * dy, other - shear * dy))
    least, greatest = np.min(ends, axis=0)[0], np.max(ends, axis=0)[1]
    assert (near <= least + 1e-9).all() and (far >= greatest - 1e-9).all()
    # In the middle, all rays of a tile pass the same faces, so the bounds are exact.
    assert near[0] == pytest.approx(least[0]) or direction[2] == 0 or direction[:2] == (1, 1)
    assert far[0] == pytest.approx(greatest[0]) or direction[2] == 0


@pytest.mark.parametrize("side", [4, 16])
@pytest.mark.parametrize("direction", [(0, 1, -1), (0, 1, -0.2)])
def test_quarters_of_a_tile_that_a_moving_ball_meets_are_kept(direction, side):
    """A ball of 12 mm moves from x = -10 to 10.

    The compared rays pass below the middle of the ball, away from the shank.
    """
    stock = Stock((-100, -100, -100), (100, 100, 100))
    frame = View(direction, 200, 180, pixel=0.5).frame(stock)
    cuts = Cuts([Cut(toolpath(np.array([(-10.0, 0, 0), (10, 0, 0)])), Tool("ballend", 12))])
    row, column = (of.ravel() for of in np.mgrid[0 : 180 - side : side, 0 : 200 - side : side])
    tile, none, child = np.arange(len(row)), np.zeros(len(row), np.int64), side // 2
    middle = 6 * frame.up[2]
    stay = list(Tilted(Trajectories(cuts, stock, frame)).quarters(column, row, tile, none, child))
    for (across, up), found in zip(QUARTERS, stay):
        half = (child - 1) / 2
        x, y = frame.pixel_centres(column + across * child + half, row + up * child + half)
        away = np.hypot(np.maximum(np.abs(x) - 10, 0), middle - y)
        below = np.flatnonzero(y < middle)
        assert np.intersect1d(found, below).tolist() == below[away[below] < 6 + sqrt(2) * half * 0.5].tolist()
        assert 0 < len(found) < len(tile) / 2


NOWHERE = (1.0, 0.0)
WHOLE, NEAR, FAR, MIDDLE = (-5.0, 5.0), (-5.0, 0.0), (2.0, 5.0), (-1.0, 1.0)


@pytest.mark.parametrize(
    "pairs, stay",
    [
        ([(NEAR, NEAR), ((-4, -1), NOWHERE)], [0]),
        ([(NEAR, NOWHERE), ((-4, -1), NOWHERE)], [0, 1]),  # The first trajectory cuts only a part of the tile.
        ([(NEAR, (-5, -2)), ((-4, -1), NOWHERE), ((-4, -2.5), NOWHERE)], [0, 1]),
        ([(FAR, FAR), ((3, 4), NOWHERE), ((1, 4), NOWHERE)], [0, 2]),
        ([(FAR, (9, 8)), ((3, 4), NOWHERE)], [0, 1]),
        # Removed depths are stored only next to an end of the rays, and not in the middle of the rays.
        ([(MIDDLE, MIDDLE), ((-0.5, 0.5), NOWHERE)], [0, 1]),
        ([(NEAR, NEAR), ((-1, 2), (-1, 2)), ((-1, 1.5), NOWHERE), ((1, 3), NOWHERE)], [0, 1, 3]),
        ([(FAR, FAR), ((-1, 3), (-1, 3)), ((0, 4), NOWHERE), ((-2, 3), NOWHERE)], [0, 1, 3]),
        ([(NEAR, NEAR), (FAR, FAR), ((-3, 1), NOWHERE), ((-3, 0), NOWHERE)], [0, 1, 2]),
        # A depth that differs only by rounding is not deeper.
        ([(NEAR, NEAR), ((-4, 0), NOWHERE), ((-4, 1e-9), NOWHERE)], [0]),
        ([(FAR, FAR), ((2, 4), NOWHERE), ((2 - 1e-9, 4), NOWHERE)], [0]),
        ([(WHOLE, WHOLE), (WHOLE, WHOLE)], [0]),
        # Depths removed in the middle of the rays are not stored, even if later depths connect them to an end.
        ([(MIDDLE, MIDDLE), (NEAR, NEAR), ((0, 0.9), NOWHERE)], [0, 1, 2]),
        ([], []),
    ],
)
def test_trajectory_that_cuts_remaining_depths_of_a_tile_is_kept(pairs, stay):
    def told(*tiles):
        tile = np.repeat(np.arange(len(tiles)), [len(own) for own in tiles])
        columns = np.array([(*passed, *opened) for own in tiles for passed, opened in own], float).reshape(-1, 4).T
        ends = np.full(len(tiles), -5.0), np.full(len(tiles), 5.0)
        return _not_yet_open(tile, *columns, *ends).tolist()

    assert told(pairs) == stay
    # Material that is removed in one tile is still there in the next tile.
    assert told([(WHOLE, WHOLE)], [(NEAR, NOWHERE), (FAR, NOWHERE), (NEAR, NOWHERE)]) == [0, 1, 2, 3]
    again = [len(pairs) + k for k in stay]
    assert told(pairs, pairs) == stay + again
    assert len(told(pairs, pairs, pairs)) == 3 * len(stay)
