# SPDX-License-Identifier: LGPL-2.1-or-later
"""The extended z-buffer, compared with areas and volumes in closed form, and with simulations of fewer moves."""

from __future__ import annotations

from math import cos, hypot, pi, radians, sin, sqrt, tan

import numpy as np
import pytest
from zbuffer_inputs import ConvexStock

from vkworkbench.core import Stock, Tool, Toolpath, View
from vkworkbench.core.zbuffer.rays.records import DEXEL, INDEX, TRACE
from vkworkbench.core.zbuffer.simulator.simulate import simulate

STOCK = Stock((0, 0, 0), (40, 30, 10))
TOOLS = [
    Tool("endmill", 6),
    Tool("ballend", 6),
    Tool("bullnose", 6, corner_radius=1),
    Tool("vbit", 6, tip_angle=pi / 2),
    Tool("drill", 6),
]
VIEWS = {
    "top": (0, 0, -1),
    "bottom": (0, 0, 1),
    "tilted": (0, 0.5, -0.866),
    "isometric": (-1, 1, -0.816),
    "side": (1, 0.3, 0),
}


def path(points, rapid=()):
    path = Toolpath.through(points)
    path.rapid[list(rapid)] = True
    path.feed[path.rapid] = 0
    return path


def cut(points, tool=TOOLS[0], stock=STOCK, direction=(0, 0, -1), width=400, height=300):
    return simulate(path(points), tool=tool, stock=stock, view=View(direction, width, height))


def area(zbuffer):
    return zbuffer.traces * zbuffer.frame.pixel**2


def test_path_without_moves_leaves_one_dexel_per_pixel():
    z = cut([], width=80, height=60)
    assert (z.dexels, z.traces) == (80 * 60, 0)
    assert z.part_volume == pytest.approx(40 * 30 * 10, rel=1e-6)
    assert z.memory_bytes == DEXEL.itemsize * 4800 + INDEX.itemsize * 4801


@pytest.mark.parametrize("tool", TOOLS, ids=lambda t: t.shape)
def test_slot_seen_from_above_has_the_area_of_a_stadium(tool):
    # At this depth, the tip of every tool cuts at its full width.
    z = cut([(10, 15, 4), (30, 15, 4)], tool)
    assert area(z) == pytest.approx(6 * 20 + pi * 9, rel=0.005)
    assert z.dexels == z.frame.width * z.frame.height


def test_only_moves_over_the_stock_have_traces():
    assert area(cut([(0, 15, 4), (40, 15, 4)])) == pytest.approx(6 * 40, rel=0.005)
    assert cut([(60, 60, 4), (80, 60, 4)]).traces == 0
    assert cut([(10, 15, 10), (30, 15, 10)]).traces == 0
    assert cut([(10, 15, 25), (30, 15, 12)]).traces == 0


def test_second_pass_over_the_same_place_cuts_nothing():
    z = cut([(10, 15, 4), (30, 15, 4), (10, 15, 4)])
    assert set(z.trace_records["trajectory"]) == {0}


def test_each_peck_of_a_hole_removes_material():
    points = [(20, 15, 12), (20, 15, 8), (20, 15, 11), (20, 15, 5), (20, 15, 11), (20, 15, 2)]
    z = cut(points)
    assert area(z) == pytest.approx(3 * 9 * pi, rel=0.01)
    assert set(z.trace_records["trajectory"]) == {0, 2, 4}


def test_a_through_hole_leaves_no_dexel_and_a_tunnel_two():
    assert cut([(20, 15, 20), (20, 15, -1)]).dexels == pytest.approx(400 * 300 - 9 * pi / 0.01, rel=1e-3)
    # In a view from the side, rays through the hole have one dexel in front of the hole and one dexel behind the hole.
    z = cut([(20, 15, 20), (20, 15, 4)], direction=(0, 1, 0))
    assert z.dexels * z.frame.pixel**2 == pytest.approx(40 * 10 + 6 * 6, rel=0.01)


@pytest.mark.parametrize("direction", [(0, 0, -1), (0, 0, 1)])
def test_second_cut_through_the_stock_removes_nothing(direction):
    """A tool as wide as the stock first cuts through the stock, and then moves deeper below it."""
    z = cut([(20, 15, 20), (20, 15, -1), (20, 15, 20), (20, 15, -2)], Tool("endmill", 60), direction=direction)
    assert (z.dexels, z.traces) == (0, 400 * 300) and z.chip_volume == pytest.approx(40 * 30 * 10)
    assert set(z.trace_records["trajectory"]) == {0}


@pytest.mark.parametrize("direction", [(0, 0, -1), (0, 0, 1)])
@pytest.mark.parametrize(("deepest", "left"), [(-1, 0), (1, 5)])
def test_thin_stock_is_cut_through_once(deepest, left, direction):
    """The wedge is 10 mm high at x = 0, and 2 mm at x = 40.

    The first cut goes through the wedge where x > 20, and the second cut where x > `left`.
    """
    wedge = ConvexStock([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0.2, 0, -1)], [40, 0, 30, 0, 10, 0])
    points = [(20, 15, 20), (20, 15, 4), (20, 15, 20), (20, 15, deepest)]
    z = cut(points, Tool("endmill", 60), wedge, direction)
    assert (z.dexels, z.traces) == (10 * left * 300, 1.5 * 400 * 300)
    stays = left * left * 0.2 / 2 * 30
    assert z.part_volume == pytest.approx(stays, rel=1e-4) and z.chip_volume == pytest.approx(40 * 30 * 6 - stays)
    second = z.trace_records[z.trace_records["trajectory"] == 2]
    assert (second["far"] - second["near"]).sum() * z.frame.pixel**2 == pytest.approx(20 * 30 * 2 - stays, rel=1e-4)


def test_zigzag_of_a_flat_mill_cuts_every_pixel_once():
    rows = [(x, 5 + 4 * k, 6) for k in range(6) for x in ((5, 35) if k % 2 == 0 else (35, 5))]
    # The last rows go along both ends, so no scallops remain, and the area is a rectangle with rounded corners.
    rows += [(5, 5, 6), (35, 5, 6), (35, 25, 6)]
    assert area(cut(rows)) == pytest.approx(36 * 26 - (4 - pi) * 9, rel=0.005)


@pytest.mark.parametrize("tilt", [20, 45, 70])
def test_a_plunge_seen_obliquely_is_a_cylinder(tilt):
    z = cut([(20, 15, 12), (20, 15, 4)], direction=(0, sin(radians(tilt)), -cos(radians(tilt))))
    seen = pi * 9 * cos(radians(tilt)) + 6 * 6 * sin(radians(tilt))
    assert area(z) == pytest.approx(seen, rel=0.01)


@pytest.mark.parametrize("heading", [0, 40, 90])
def test_oblique_area_of_a_slot_is_its_floor_and_its_wall(heading):
    tilt, length = radians(35), 12
    along = np.array([cos(radians(heading)), sin(radians(heading)), 0]) * length / 2
    middle = np.array([20, 15, 5])
    z = cut([middle - along, middle + along], direction=(0, sin(tilt), -cos(tilt)))
    wall = 5 * (6 + length * abs(cos(radians(heading))))
    assert area(z) == pytest.approx((6 * length + 9 * pi) * cos(tilt) + wall * sin(tilt), rel=0.01)


def hole_volume(tool, depth):
    """Return the volume of a hole drilled to `depth`, mm^3: the cylinder minus the material below the tip."""
    r, c, k = tool.radius, tool.rounding, tool.steepness
    flat = r - c
    # Pappus: the corner's spandrel has the area (1 - pi/4) c^2. The spandrel's centroid is c (1 - (10 - 3 pi) / (12 - 3
    # pi)) from the flat's edge.
    spandrel = (1 - pi / 4) * c**2
    centroid = flat + c * (1 - (10 - 3 * pi) / (12 - 3 * pi))
    return pi * r**2 * depth - 2 * pi * centroid * spandrel - 2 / 3 * pi * k * r**3


@pytest.mark.long
@pytest.mark.parametrize("tool", TOOLS, ids=lambda t: t.shape)
@pytest.mark.parametrize("view", VIEWS)
def test_hole_volume_is_measured_in_every_view(tool, view):
    z = cut([(20, 15, 12), (20, 15, 3)], tool, direction=VIEWS[view], width=280, height=210)
    assert z.chip_volume == pytest.approx(hole_volume(tool, 7), rel=0.01)
    assert z.part_volume + z.chip_volume == pytest.approx(z.at(0).part_volume, rel=1e-5)


@pytest.mark.long
@pytest.mark.parametrize("tool", TOOLS, ids=lambda t: t.shape)
@pytest.mark.parametrize("move", [(20, 10, 0), (18, -8, 3), (-15, 4, -5), (0.5, 0.2, -5)], ids=str)
def test_volume_of_a_move_does_not_depend_on_the_view(tool, move):
    middle = np.array([20, 15, 5])
    points = [middle - np.array(move) / 2, middle + np.array(move) / 2]
    volumes = [cut(points, tool, direction=d, width=280, height=210).chip_volume for d in VIEWS.values()]
    assert volumes == pytest.approx([volumes[0]] * len(volumes), rel=0.01)


@pytest.mark.parametrize("view", VIEWS)
def test_volumes_of_chips_and_part_add_up_to_the_stock(view):
    z = cut(winding(40), Tool("ballend", 4), direction=VIEWS[view], width=120, height=90)
    whole = z.at(0).part_volume
    assert whole == pytest.approx(12000, rel=0.02)
    for step in (0, 1, 17, 40):
        now = z.at(step)
        assert now.part_volume + now.chip_volume == pytest.approx(whole, rel=1e-5)


@pytest.mark.parametrize("view", VIEWS)
def test_earlier_moment_equals_simulation_of_its_moves(view):
    points = winding(40)
    z = cut(points, direction=VIEWS[view], width=120, height=90)
    for step in (0, 1, 13, 29):
        then = cut(points[: step + 1], direction=VIEWS[view], width=120, height=90)
        assert (z.at(step).dexels, z.at(step).traces) == (then.dexels, then.traces)
        assert z.at(step).part_volume == pytest.approx(then.part_volume, rel=1e-6)
    assert z.at(13).at(40).dexels == z.dexels


def winding(n):
    """Return a path of random moves in and around the stock."""
    rng = np.random.default_rng(7)
    return np.column_stack((rng.uniform(0, 40, n + 1), rng.uniform(0, 30, n + 1), rng.uniform(3, 12, n + 1)))


def test_moments_outside_the_simulation_are_refused():
    z = cut([(10, 15, 4), (30, 15, 4)], width=40, height=30)
    for step in (-1, 2):
        with pytest.raises(ValueError, match=f"step must be a whole number, 0 to 1, not {step}"):
            z.at(step)
    # The number of trajectories already cut is a whole number.
    with pytest.raises(TypeError, match=r"step must be a whole number, 0 to 1, not 0\.5"):
        z.at(0.5)


def test_rapids_cut_the_stock():
    z = simulate(path([(10, 15, 4), (30, 15, 4)], rapid=[0]), tool=TOOLS[0], stock=STOCK, view=View())
    assert z.traces > 0


def test_dexels_and_traces_are_sorted_and_fill_their_rays():
    z = cut(winding(30), direction=VIEWS["isometric"], width=60, height=45)
    assert (DEXEL.itemsize, TRACE.itemsize, INDEX.itemsize) == (12, 12, 4)
    assert (np.diff(z.dexel_records["pixel"].astype(int)) >= 0).all()
    assert z.trace_index[-1] == len(z.trace_records)
    for pixel in range(0, 60 * 45, 97):
        own = z.trace_records[z.trace_index[pixel] : z.trace_index[pixel + 1]]
        dexels = z.dexel_records[z.dexel_records["pixel"] == pixel]
        near = np.sort(np.concatenate((own["near"], dexels["near"])))
        far = np.sort(np.concatenate((own["far"], dexels["far"])))
        # Dexels and traces fill the intersection of the ray with the stock without gap or overlap.
        assert near[1:] == pytest.approx(far[:-1])


def test_volume_of_a_cylindrical_stock_is_exact():
    stock = ConvexStock.cylinder((0, 0, 0), radius=20, height=10)
    z = simulate(path([(0, 0, 12), (0, 0, 4)]), tool=TOOLS[0], stock=stock, view=View(width=400, height=300))
    assert z.at(0).part_volume == pytest.approx(pi * 400 * 10, rel=0.005)
    assert z.chip_volume == pytest.approx(pi * 9 * 6, rel=0.01)


def test_width_of_v_bit_slot_follows_from_depth_and_angle():
    tool = Tool("vbit", 6, tip_angle=radians(60))
    z = cut([(10, 10, 8), (30, 20, 8)], tool)
    half_width = 2 * tan(radians(30))
    assert area(z) == pytest.approx(2 * half_width * hypot(20, 10) + pi * half_width**2, rel=0.01)


def test_width_of_shallow_ball_slot_is_the_chord():
    z = cut([(10, 10, 9), (30, 20, 9)], Tool("ballend", 6))
    half_width = sqrt(3**2 - 2**2)
    assert area(z) == pytest.approx(2 * half_width * hypot(20, 10) + pi * half_width**2, rel=0.01)


@pytest.mark.parametrize("rise", [4, -4])
def test_depth_above_sloped_bull_nose_path_is_exact(rise):
    """The rounded corner cuts the middle ray deepest while the tool's axis is more than 2 mm away."""
    z = cut([(-5, 15, 4 - rise), (45, 15, 4 + rise)], TOOLS[2], width=401, height=301)
    slope = abs(rise) / 25
    # The flat end face has a radius of 2 mm, and the rounded corner has a radius of 1 mm.
    expected = 4 - 2 * slope + 1 - hypot(1, slope)
    assert z.frame.origins(*z.frame.pixel_centres(np.array([200]), np.array([150])))[0].tolist() == [20, 15, 5]
    assert 5 - z.picture.depth.reshape(301, 401)[149:152, 200] == pytest.approx(expected, abs=1e-2)


@pytest.mark.parametrize("down", [-1, 1])
@pytest.mark.parametrize("tilt", [3e-8, 3e-6])
def test_view_vertical_up_to_rounding_is_vertical(tilt, down):
    points = [(5, 5, 12), (33.2, 17.3, 4), (30, 20, 9), (3, 21, -2), (28, 4, 3)]
    ours, exact = (cut(points, TOOLS[4], direction=(x, x / 3, down), width=80, height=60).records for x in (tilt, 0))
    for column in ("index", "entry", "far", "owner"):
        assert np.array_equal(getattr(ours, column), getattr(exact, column))


@pytest.mark.parametrize(
    "arguments, words",
    [
        (("endmil", 6), "unknown tool shape"),
        (("endmill", 0), "positive number"),
        (("endmill", float("nan")), "positive number"),
        (("endmill", -3), "positive number"),
        (("bullnose", 6, 3.5), "corner radius"),
        (("vbit", 6, 0, 0.0), "tip angle"),
    ],
)
def test_impossible_tools_are_refused_with_a_reason(arguments, words):
    with pytest.raises(ValueError, match=words):
        Tool(*arguments)


def test_impossible_stocks_and_views_are_refused_with_a_reason():
    with pytest.raises(ValueError, match="no volume"):
        Stock((0, 0, 0), (10, 10, 0))
    with pytest.raises(ValueError, match="numbers within a kilometer"):
        Stock((0, 0, 0), (10, float("inf"), 5))
    with pytest.raises(ValueError, match="not all zero"):
        View((0, 0, 0))
    with pytest.raises(ValueError, match="at least 1"):
        View(width=0)
    with pytest.raises(ValueError, match="positive number"):
        View(pixel=0.0)


@pytest.mark.parametrize("direction", VIEWS.values())
@pytest.mark.parametrize("shape", ["vbit", "drill"])
def test_tip_of_180_degrees_equals_a_flat_end(direction, shape):
    """If rounding kept a cone, the tool would cut too little where rays touch the cone."""
    points = [(5, 5, 12), (5, 5, 6), (30, 20, 6), (35, 10, 4), (10, 25, 4)]
    solids = {"stock": STOCK, "view": View(direction, 60, 45)}
    tip, flat = (
        simulate(path(points), tool=tool, **solids).records
        for tool in (Tool(shape, 6, tip_angle=pi, tip_diameter=2), Tool("endmill", 6))
    )
    assert all(
        np.array_equal(*pair) for pair in ((tip.index, flat.index), (tip.owner, flat.owner), (tip.far, flat.far))
    )
