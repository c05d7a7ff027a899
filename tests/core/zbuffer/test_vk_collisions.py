# SPDX-License-Identifier: LGPL-2.1-or-later
"""Collisions of shanks, holders and clamps, cuts deeper than the flutes, and tools that are too short."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from vkworkbench.core import Cut, Cylinder, Stock, Tool, Toolpath
from vkworkbench.core.zbuffer import Cuts, holder_collisions
from vkworkbench.language import render

BLOCK = Stock((0, 0, 0), (60, 40, 40))
MILL = Tool("endmill", 3, cutting_edge_height=8, length=20, shank_diameter=6)


def through(*points):
    """Return the moves through points, without moves of zero length."""
    new = [points[0], *(point for before, point in zip(points, points[1:]) if point != before)]
    return Toolpath.through(new)


def pocket(depths, margin=1.5, step=1.5):
    """Return the moves that clear a pocket from (10, 10) to (50, 30) at several depths."""
    points = []
    for z in depths:
        rows = np.arange(10 + margin, 30 - margin + 1e-9, step).tolist()
        points.append((10 + margin, rows[0], 45))
        for k, y in enumerate(rows):
            ends = [10 + margin, 50 - margin]
            points += [(x, y, z) for x in (ends if k % 2 == 0 else ends[::-1])]
        points.append((*points[-1][:2], 45))
    return through(*points)


def slot(depth):
    return through((-10, 20, 45), (-10, 20, 40 - depth), (70, 20, 40 - depth), (70, 20, 45))


def collisions(*cuts, stock=BLOCK, clamps=None):
    return holder_collisions(Cuts(Cut(*cut) for cut in cuts), stock, clamps=clamps)


def told(*cuts, **where):
    """Return the collisions as {(body, cut): (first command, last command, depth)}."""
    found = collisions(*cuts, **where).found
    return {
        (one.body, one.source.cut): (one.source.command, one.last.command, pytest.approx(one.depth, abs=0.05))
        for one in found
    }


@pytest.mark.long
def test_short_tool_in_deep_pocket_is_found():
    """Cut a pocket 30 mm deep: below 8 mm the shank hits the wall, and below 20 mm the holder hits the stock."""
    moves = pocket(range(38, 8, -2))
    assert told((moves, MILL)) == {("shank", 0): (104, 387, 22.0), ("length", 0): (260, 387, 10.0)}
    shank, short = collisions((moves, MILL)).found
    # The collision is in the wall beside the first plunge that is too deep.
    assert abs(shank.place[2] - 39) < 0.02 and shank.place[1] < 10
    assert "shank collides with material 22 mm high" in render(shank.what)
    assert "20 mm long" in render(short.what) and "10 mm higher" in render(short.what)


def test_tool_with_long_flutes_has_no_collision():
    moves = pocket(range(38, 8, -2))
    assert told((moves, replace(MILL, cutting_edge_height=30, length=60))) == {}
    assert told((moves, replace(MILL, length=30))).keys() == {("shank", 0)}


@pytest.mark.parametrize("thicker, command", [(0.0, None), (0.05, 104), (1.0, 104)])
def test_shank_thicker_than_flutes_rubs_at_the_wall(thicker, command):
    """The flutes have already cut the wall, at several depths.

    The first plunge deeper than 8 mm is the first collision.
    """
    found = told((pocket(range(38, 8, -2)), replace(MILL, shank_diameter=3 + thicker, length=60)))
    assert found == ({("shank", 0): (command, 387, 22.0)} if command else {})


@pytest.mark.parametrize("thicker, collides", [(0.0, False), (0.05, True)])
def test_shank_thicker_than_flutes_rubs_in_a_slot(thicker, collides):
    """A slot of 60 mm along a row of pixels is cut in steps of 7 mm in depth with flutes of 8 mm."""
    tool = Tool("endmill", 6, cutting_edge_height=8, shank_diameter=6 + thicker)
    found = told((slot(7), tool), (slot(14), tool))
    assert found == ({("shank", 1): (1, 1, 6.0)} if collides else {})


@pytest.mark.long
@pytest.mark.parametrize("shank", [4.0, 6.0, None])
def test_slot_deeper_than_flutes_is_found(shank):
    tool = Tool("endmill", 6, cutting_edge_height=8, shank_diameter=shank)
    assert told((slot(8), tool)) == {}
    assert told((slot(8.01), tool)) == {}
    assert told((slot(20), tool)) == {("flutes", 0): (1, 1, 12.0)}
    assert told((slot(8), tool), (slot(16), tool)) == {}
    assert told((slot(8), tool), (slot(17), tool)) == {("flutes", 1): (1, 1, 1.0)}


def test_plunge_with_flutes_below_is_not_too_deep():
    """The flutes remove the material before the shank comes, in one move or in many."""
    tool = Tool("endmill", 6, cutting_edge_height=8, length=60, shank_diameter=6)
    assert told((through((20, 20, 45), (20, 20, 5), (20, 20, 45)), tool)) == {}
    assert told((through((20, 20, 45), (20, 20, 30), (20, 20, 5), (20, 20, 45)), tool)) == {}


def test_shank_wider_than_flutes_collides_in_a_plunge():
    moves = through((20, 20, 45), (20, 20, 33), (20, 20, 30), (20, 20, 45))
    assert told((moves, MILL)) == {("shank", 0): (1, 1, 2.0)}


@pytest.mark.long
def test_shank_hits_a_ridge_before_the_flutes():
    """The tool removes the ridge in the same move, but the shank reaches the ridge before the flutes."""
    wide = Tool("endmill", 10, cutting_edge_height=50, length=80, shank_diameter=10)
    beside = through((-10, 12, 20), (75, 12, 20), (75, 28, 20), (-10, 28, 20))
    along = through((-10, 20, 25), (75, 20, 25))
    tool = Tool("endmill", 6, cutting_edge_height=8, length=60, shank_diameter=8)
    assert told((beside, wide), (along, tool)) == {("flutes", 1): (0, 0, 7.0), ("shank", 1): (0, 0, 7.0)}


@pytest.mark.long
def test_holder_of_given_size_is_checked():
    moves = pocket(range(38, 8, -2))
    tool = replace(MILL, shank_diameter=3, length=25, holder_diameter=20)
    assert told((moves, tool)) == {("holder", 0): (312, 387, 5.0)}
    assert told((moves, replace(tool, length=30.5))) == {}
    assert collisions((moves, tool)).holders == (True,) and collisions((moves, MILL)).holders == (False,)


@pytest.mark.long
def test_material_above_the_holder_is_not_hit():
    """The wall begins above the upper end of the holder, like a roof under which the tool moves."""
    tool = Tool("endmill", 6, cutting_edge_height=10, length=15, holder_diameter=20, holder_length=4)
    free = through((-20, 20, 0), (-9, 20, 0))
    assert told((free, tool)) == {("holder", 0): (0, 0, 25.0)}
    assert told((free, tool), stock=Stock((0, 0, 20), (60, 40, 40))) == {}


def test_shank_that_only_touches_material_does_not_collide():
    """A shank moves exactly along a wall, and a shank moves exactly on the upper face of the stock."""
    wide = Tool("endmill", 6, cutting_edge_height=50, shank_diameter=6)
    tool = Tool("endmill", 3, cutting_edge_height=8, length=60, shank_diameter=6)
    assert told((slot(20), wide), (slot(20), tool)) == {}
    assert told((slot(8), replace(tool, shank_diameter=30))) == {}


def test_v_bit_cuts_with_its_whole_cone():
    tool = Tool("vbit", 10, tip_angle=np.pi / 2, cutting_edge_height=1, shank_diameter=10)
    assert told((slot(4.9), tool)) == {}
    assert told((slot(7), tool)) == {("flutes", 0): (1, 1, 2.0)}


def test_tools_with_unknown_sizes_are_reported_as_unchecked():
    found = collisions((slot(30), Tool("endmill", 6)))
    assert found.found == () and (found.shanks, found.holders, found.clamps) == ((False,), (False,), 0)
    assert "no tool has a cutting edge height" in render(found.attachments(["A"]))
    some = collisions((slot(5), MILL), (slot(5), Tool("endmill", 6)), clamps={"one": Stock((0, 0, -9), (9, 9, -1))})
    assert some.shanks == (True, False)
    assert render(some.attachments(["A", "B"])) == (
        "The shanks of B were not checked, because the tools have no cutting edge height or no shank diameter. "
        "No holder is given. 1 clamp was checked."
    )


@pytest.mark.long
def test_tool_or_holder_in_a_clamp_is_a_collision():
    clamps = {"left": Stock((-30, 0, 0), (0, 40, 42)), "screw": Cylinder((30, 60, 0), 10, 80)}
    tool = Tool("endmill", 6, cutting_edge_height=8, length=30, shank_diameter=6)
    assert told((slot(5), tool), clamps=clamps) == {("tool", 0): (0, 1, 7.0)}
    (one,) = collisions((slot(5), tool), clamps=clamps).found
    assert one.clamp == "left" and "clamp left" in render(one.what)
    holder = replace(tool, holder_diameter=70)
    (hit,) = collisions((slot(5), holder), clamps={"screw": clamps["screw"]}).found
    assert (hit.body, hit.clamp, hit.source.command) == ("holder", "screw", 1)
    over = through((-10, 20, 42), (70, 20, 42))
    assert told((over, tool), clamps=clamps) == {}


def test_clamp_is_hit_by_every_operation():
    """Two operations along the same path: the first operation must not hide the collision of the second operation."""
    tool, clamps = Tool("endmill", 6), {"left": Stock((-30, 0, 0), (0, 40, 42))}
    hit = (0, 1, 7.0)
    assert told((slot(5), tool), (slot(5), tool), clamps=clamps) == {("tool", 0): hit, ("tool", 1): hit}


def reference(moves, tool, body_radius, bottom, before):
    """Return the depth of the collision of each move, computed on a height map in small steps."""
    columns, rows = np.arange(0.1, 30, 0.2), np.arange(0.1, 20, 0.2)
    heights, depths = np.full((len(rows), len(columns)), 12.0), np.zeros(len(moves))
    reach = max(body_radius, tool.radius)
    for k, (start, end) in enumerate(zip(moves.points, moves.points[1:])):
        steps = int(np.ceil(np.linalg.norm(end - start) / 0.03))
        for share in np.linspace(0, 1, steps + 1):
            px, py, pz = start + share * (end - start)
            near = np.ix_(np.abs(rows - py) <= reach, np.abs(columns - px) <= reach)
            height = heights[near]
            away = np.hypot(columns[near[1]] - px, rows[near[0]] - py)
            hit = (away <= body_radius) & (height > pz + bottom)
            if not before:  # The flutes have removed the material inside their radius.
                hit &= away > tool.radius
            depths[k] = max(depths[k], (height[hit] - pz - bottom).max(initial=0.0))
            height[hit] = pz + bottom
            inside = away <= tool.radius
            height[inside] = np.minimum(height[inside], pz)
            heights[near] = height
    return depths


@pytest.mark.long
@pytest.mark.parametrize("body", ["flutes", "shank"])
@pytest.mark.parametrize("seed", range(3))
def test_collisions_agree_with_a_height_map_cut_in_small_steps(body, seed):
    rng = np.random.default_rng(seed)
    points = rng.uniform((0, 0, 3), (30, 20, 11), (9, 3))
    points[::3, 2] = points[1::3, 2]  # Every third move is horizontal.
    moves, tool = Toolpath.through(points), Tool("endmill", 4, cutting_edge_height=3, shank_diameter=7)
    radius, bottom = (1.98, 3.02) if body == "flutes" else (3.48, 3.02)
    depths = reference(moves, tool, radius, bottom, before=body == "flutes")
    found = [one for one in collisions((moves, tool), stock=Stock((0, 0, 0), (30, 20, 12))).found if one.body == body]
    first = found[0].source.command if found else len(moves)
    assert first == len(moves) or depths[first] > 0
    assert (depths[:first] < 0.6).all()
