# SPDX-License-Identifier: LGPL-2.1-or-later
"""The size of the legacy simulator's mesh, from coarse maps of the part's heights."""

from __future__ import annotations

import numpy as np
import pytest
from simulator_jobs import STOCK, TOOL, surface, zigzag

from vkworkbench.core import Stock, Tool
from vkworkbench.core.gcode import linearize
from vkworkbench.core.simulators.heightmap import heightmaps
from vkworkbench.core.simulators.legacy_mesh import bottom_rectangles, mesh_facets


@pytest.mark.parametrize("tool", [Tool("endmill", 8.0), Tool("ballend", 8.0), Tool("vbit", 8.0)])
def test_heights_equal_a_search_over_all_points(tool):
    path = linearize([("G1", {"X": 20.0, "Y": 15.0, "Z": 12.0}), ("G1", {"X": 70.0, "Y": 40.0, "Z": 8.0})])
    (heights,), size = heightmaps(path, tool=tool, stock=STOCK)
    along = np.linspace(0, 1, 500)[:, None]  # The points are a ninth of a mm apart, which is a ninth of a cell.
    points = path.points[0] + along * (path.points[1] - path.points[0])
    x, y = np.meshgrid(
        (np.arange(heights.shape[0]) + 0.5) * size, (np.arange(heights.shape[1]) + 0.5) * size, indexing="ij"
    )
    distance = np.hypot(x[..., None] - points[:, 0], y[..., None] - points[:, 1])
    exact = np.minimum((points[:, 2] + tool.height(distance)).min(axis=2), 20.0)
    # The tolerance allows a map shifted by half a cell, whose heights are wrong by half a cell times the tool's slope.
    inside = distance.min(axis=2) < tool.radius - size
    outside = distance.min(axis=2) > tool.radius + 1.5 * size
    assert (heights[outside] == 20.0).all()
    assert np.abs(heights - exact)[inside].max() < 1.8 * size * (1 + tool.steepness) + 0.2


def test_cells_of_the_maps_have_the_documented_size():
    path = linearize(zigzag(3))
    tall = Stock((0, 0, 0), (100, 60, 300))
    for stock, diameter, expected in ((STOCK, 6.0, 1.0), (tall, 6.0, 1.0), (STOCK, 64.0, 2.0)):
        _, size = heightmaps(path, tool=Tool("endmill", diameter), stock=stock)
        assert size == pytest.approx(expected)


def test_fine_groove_has_no_gaps():
    small = Stock((0, 0, 0), (10, 6, 2))
    groove = [("G0", {"X": 1.0, "Y": 3.05, "Z": 4.0}), ("G1", {"X": 5.0, "Z": 0.0}), ("G1", {"X": 9.0, "Z": 4.0})]
    (heights,), size = heightmaps(linearize(groove), tool=Tool("endmill", 0.6), stock=small)
    x = (np.arange(heights.shape[0]) + 0.5) * size
    along = heights[:, int(3.05 / size)]
    # Over each cell, the lowest position of the flat tool is the position at which the tool's edge is over the cell.
    exact = np.clip(np.abs(x - 5) - 0.3, 0, 2)
    assert np.abs(along - exact)[(x > 2) & (x < 8)].max() < 3 * size


def test_thin_tool_cuts_the_cells_along_the_edge_of_the_stock():
    small, border = Stock((0, 0, 0), (10, 6, 2)), ((0.05, 0.05), (9.95, 0.05), (9.95, 5.95), (0.05, 5.95), (0.05, 0.05))
    around = [("G0", {"X": 0.05, "Y": 0.05, "Z": 4.0}), *[("G1", {"X": x, "Y": y, "Z": 1.0}) for x, y in border]]
    (heights,), _ = heightmaps(linearize(around), tool=Tool("endmill", 0.1), stock=small)
    assert (heights[1:-1, 1:-1] == 2).all() and (heights == 1).sum() == 2 * (100 + 60) - 4


def test_path_outside_the_stock_leaves_twelve_triangles_of_a_box():
    path = linearize([("G1", {"X": -50.0, "Y": 500.0, "Z": -5.0}), ("G1", {"X": -900.0})])
    (heights,), size = heightmaps(path, tool=TOOL, stock=STOCK)
    assert (heights == 20.0).all() and mesh_facets(heights, size, 0.1, lower=0.0) == 12


def test_surface_makes_far_more_triangles_than_a_pocket():
    ball = Tool("ballend", 6.0)
    (pocket,), size = heightmaps(linearize(zigzag(20)), tool=TOOL, stock=STOCK)
    (dome,), dome_size = heightmaps(linearize(surface()), tool=ball, stock=STOCK)
    of_dome, of_pocket = (
        [mesh_facets(heights, edge, resolution, lower=0.0) for resolution in (0.1, 0.2)]
        for heights, edge in ((dome, dome_size), (pocket, size))
    )
    assert of_dome[0] > 10 * of_pocket[0]
    assert 3.5 < of_dome[0] / of_dome[1] <= 4
    assert 1.7 < of_pocket[0] / of_pocket[1] < 2.1


def test_half_the_size_at_half_the_cell_makes_equal_meshes():
    (dome,), size = heightmaps(linearize(surface()), tool=Tool("ballend", 6.0), stock=STOCK)
    whole, half = (mesh_facets(dome * scale, size * scale, 0.1 * scale, lower=0.0) for scale in (1, 0.5))
    assert half == pytest.approx(whole)


def test_mirror_image_has_equally_many_triangles():
    """A step is a wall if a neighbouring step, on either side, has less than half of its height."""
    heights = np.tile(np.cumsum([0.0, 0.0, 1.2, 3.0, 0.0, 0.0, 0.7, 0.7])[:, None], 6)
    there, back = (mesh_facets(one, 4.0, 0.5, lower=-1.0) for one in (heights, heights[::-1]))
    assert there == pytest.approx(back)


@pytest.mark.parametrize(
    "steps, slope",
    [
        ([0.7, 0.7], True),
        ([1.0, 0.6], True),
        ([0.6, 1.0], True),
        ([0.7], False),
        ([1.2, 0.5], False),
        ([0.5, 1.2], False),
    ],
)
def test_step_beside_another_step_is_a_slope(steps, slope):
    """Half the cell size makes four times as many triangles for a slope, and twice as many for a wall."""
    heights = np.tile(np.cumsum([0.0, 0.0, *steps, 0.0, 0.0])[:, None], 6)
    coarse, fine = (mesh_facets(heights, 4.0, resolution, lower=-1.0) - 12 for resolution in (0.4, 0.2))
    assert (fine == pytest.approx(4 * coarse)) == slope and 1.999 * coarse < fine < 4.001 * coarse


@pytest.mark.parametrize("fall", [0.1, 1.0])
def test_slope_turned_by_90_degrees_has_as_many_triangles(fall):
    heights = np.tile(fall * np.arange(40.0)[:, None], 60)
    along, across = (mesh_facets(one, 4.0, 0.5, lower=-1.0) for one in (heights, heights.T))
    assert along == pytest.approx(across)


def test_map_after_the_last_part_of_a_path_is_the_final_map():
    path = linearize(surface())
    ball = Tool("ballend", 6.0)
    (whole,), _ = heightmaps(path, tool=ball, stock=STOCK)
    parts, _ = heightmaps(path, tool=ball, stock=STOCK, parts=5)
    assert len(parts) == 5
    assert all((after <= before).all() for before, after in zip(parts, parts[1:]))
    assert np.abs(parts[-1] - whole).max() < 0.05  # Points at the border between two parts are sampled twice.


def test_map_after_a_part_of_a_path_excludes_the_next_part():
    """Four commands are divided into two parts. The second part begins with a slot across the stock."""
    there, across, back = (("G1", {axis: to}) for axis, to in (("X", 90.0), ("Y", 50.0), ("X", 10.0)))
    path = linearize([("G0", {"X": 10.0, "Y": 10.0, "Z": 10.0}), there, across, back])
    (first, both), _ = heightmaps(path, tool=TOOL, stock=STOCK, parts=2)
    (half,), _ = heightmaps(linearize([("G0", {"X": 10.0, "Y": 10.0, "Z": 10.0}), there]), tool=TOOL, stock=STOCK)
    assert np.array_equal(first, half) and (both < first).any()


def test_lower_face_of_a_round_part_has_many_triangles():
    """FreeCAD makes half a triangle per remaining cell for the lower face of a disc, and two triangles for a plate."""
    x, y = np.meshgrid(np.arange(100) - 49.5, np.arange(60) - 29.5, indexing="ij")
    disc = np.where(np.hypot(x, y) < 28, 20.0, 0.0)
    plate = np.where((np.abs(x) < 40) & (np.abs(y) < 28), 20.0, 0.0)
    cells = 100 * (disc > 0).sum()
    of_disc, of_plate = (mesh_facets(heights, 1.0, 0.1, lower=0.0) for heights in (disc, plate))
    assert 0.2 * cells < of_disc < 0.7 * cells
    assert of_plate < 3000
    thin = np.where(disc > 0, disc, 0.09)  # Material thinner than a cell counts as cut through.
    assert mesh_facets(thin, 1.0, 0.1, lower=0.0) == pytest.approx(of_disc, rel=0.01)


def bottom_of_freecad(kept):
    """Return the number of rectangles of the lower face, counted like ``TesselBot`` in FreeCAD's VolSim.cpp."""
    kept, count = kept.copy(), 0
    columns, rows = kept.shape

    def grown(x, y):
        width = height = 1
        right = left = up = True
        while right or left or up:
            right = right and x + width < columns and kept[x + width, y : y + height].all()
            width += right
            left = left and x > 0 and kept[x - 1, y : y + height].all()
            x, width = x - left, width + left
            up = up and y + height < rows and kept[x : x + width, y + height].all()
            height += up
        return x, y, width, height

    for y in range(rows):
        x = 0
        while x < columns:
            if not kept[x, y]:
                x += 1
                continue
            left, lower, width, height = grown(x, y)
            if height // width > 5:
                lower, width, height = lower + 5 * width, 1, 1
            elif width // height > 5:
                left, width, height = left + 5 * height, 1, 1
            kept[left : left + width, lower : lower + height] = False
            count += 1
    return count


def test_rectangles_of_the_lower_face_equal_freecads():
    rng = np.random.default_rng(5)
    for k in range(60):
        columns, rows = rng.integers(1, 50, 2)
        x, y = np.meshgrid(np.arange(columns), np.arange(rows), indexing="ij")
        kept = rng.random((columns, rows)) < (0.8 if k % 4 == 0 else 2)
        for _ in range(k % 5):
            kept &= np.hypot(x - rng.integers(columns), y - rng.integers(rows)) > rng.integers(1, 12)
        assert bottom_rectangles(kept) == bottom_of_freecad(kept)
