# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stocks that are not bounded by planes: cylinders, and closed meshes with holes and undercuts."""

from __future__ import annotations

import gc
import weakref
from math import pi, sqrt

import numpy as np
import pytest
from zbuffer_inputs import BOX, DIRECTIONS, HOLLOW, PATHS, TOOLS, ConvexStock, ball, box, close, toolpath

from vkworkbench.core import Cylinder, Mesh, Stock, Tool, View, estimate, stocks
from vkworkbench.core.zbuffer import OverBudget, deviations, memory_needed
from vkworkbench.core.zbuffer.findings.facts import removed_volumes
from vkworkbench.core.zbuffer.memory.silhouette import seen_areas
from vkworkbench.core.zbuffer.rays.dexels import Segments, first_cuts
from vkworkbench.core.zbuffer.rays.records import GAP
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.rays.surface import STOCK
from vkworkbench.core.zbuffer.simulator.simulate import simulate
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts
from vkworkbench.language import Unusable

NOISE = 1e-5  # mm


@pytest.mark.long
@pytest.mark.parametrize("direction", DIRECTIONS)
def test_mesh_of_a_box_equals_the_box(direction):
    rng = np.random.default_rng(3)
    points = PATHS[0](rng, 30)
    for tool in TOOLS[::2]:
        solids = {"tool": tool, "view": View(direction, 45, 35)}
        mesh = simulate(toolpath(points), stock=Mesh(box(BOX.lower, BOX.upper)), **solids).records
        plain = simulate(toolpath(points), stock=BOX, **solids).records
        assert np.array_equal(mesh.index, plain.index) and np.array_equal(mesh.owner, plain.owner)
        assert close(mesh.far, plain.far, NOISE) and close(mesh.entry, plain.entry, NOISE)


@pytest.mark.parametrize("direction", DIRECTIONS)
def test_cavities_of_a_mesh_are_empty_before_any_cut(direction):
    z = simulate(toolpath(np.zeros((1, 3))), tool=TOOLS[0], stock=Mesh(HOLLOW), view=View(direction, 200, 150))
    assert z.part_volume == pytest.approx(25 * 30 * 10 - 15 * 10 * 4 + 10 * 30 * 10, rel=0.02)
    assert z.chip_volume == 0 and (z.picture.owner == STOCK).all()
    inside = z.records.far.astype(float) - z.records.near()
    assert inside.min() > 0
    if direction[:2] == (0, 0):
        assert inside[z.records.owner == GAP].sum() * z.frame.pixel**2 == pytest.approx(15 * 10 * 4, rel=0.02)
        assert z.dexels * z.frame.pixel**2 == pytest.approx(35 * 30 + 15 * 10, rel=0.02)


@pytest.mark.long
@pytest.mark.parametrize("seed", range(18))
def test_rays_through_a_mesh_are_cut_as_if_each_were_alone(seed):
    """The reference intersects each ray with each triangle separately (Moeller and Trumbore 1997)."""
    rng = np.random.default_rng(seed)
    stock = Mesh(HOLLOW if seed % 2 else np.concatenate((ball((20, 15, 5), 14), ball((20, 15, 5), 9))))
    path, tool = PATHS[rng.integers(len(PATHS))], TOOLS[rng.integers(len(TOOLS))]
    moves = toolpath(path(rng, 30))
    z = simulate(moves, tool=tool, stock=stock, view=View(DIRECTIONS[seed % len(DIRECTIONS)], 22, 18, pixel=2.03))
    frame = z.frame
    row, column = np.divmod(np.arange(22 * 18), 22)
    x, y = frame.pixel_centres(column, row)
    ray, near, far = inside(stock, frame.origins(x, y), frame.direction)
    removal = Removal(Cuts([Cut(moves, tool)]), stock, frame)
    # Each stretch of a ray inside the mesh is cut as a separate ray.
    stretch, item = (pairs.ravel() for pairs in np.indices((len(ray), len(removal.index))))
    enter, leave = removal.intervals(x[ray[stretch]], y[ray[stretch]], item)
    segments = first_cuts(near, far, stretch, removal.index[item], enter, leave)
    expected = Segments(ray[segments.ray], segments.owner, segments.near, segments.far)
    records = z.records
    kept = records.owner != GAP
    assert np.array_equal(records.pixel()[kept], expected.ray)
    assert np.array_equal(records.owner[kept], np.minimum(expected.owner, z.trajectories))
    assert close(records.near()[kept], expected.near, NOISE) and close(records.far[kept], expected.far, NOISE)


def inside(mesh, origins, direction):
    """Return rays and where each ray enters and leaves the solid, sorted by ray and depth."""
    a, b, c = (mesh.corners[mesh.triangles[:, k]] for k in range(3))
    across = np.cross(direction, c - a)
    volume = (across * (b - a)).sum(axis=1)
    volume = np.where(volume == 0, np.nan, volume)
    found = []
    for ray, origin in enumerate(origins):
        to = origin - a
        u = (to * across).sum(axis=1) / volume
        turned = np.cross(to, b - a)
        v = (turned @ direction) / volume
        depth = ((c - a) * turned).sum(axis=1) / volume
        crossed = np.sort(depth[(u >= 0) & (v >= 0) & (u + v <= 1)])
        # A ray through an edge meets two triangles at one depth.
        crossed = crossed[np.diff(crossed, prepend=-np.inf) > 1e-9]
        assert len(crossed) % 2 == 0
        found += [(ray, *pair) for pair in crossed.reshape(-1, 2) if pair[1] - pair[0] > 1e-4]
    ray, near, far = np.array(found).T
    return ray.astype(int), near, far


def test_no_ray_passes_between_two_triangles():
    """The rays pass through corners and along edges, because the corners lie on the grid of the pixels."""
    corners = np.stack(np.meshgrid(np.arange(9.0), np.arange(9.0), indexing="ij"), axis=-1).reshape(81, 2)
    height = np.random.default_rng(0).uniform(3, 6, 81)
    top, ground = (np.column_stack((corners, z)) for z in (height, np.zeros(81)))
    a = np.add.outer(9 * np.arange(8), np.arange(8)).ravel()
    squares = np.concatenate([np.stack((a, a + 9, a + 1), 1), np.stack((a + 9, a + 10, a + 1), 1)])
    rim = np.concatenate((np.arange(9), np.arange(17, 81, 9), np.arange(79, 71, -1), np.arange(63, 0, -9)))
    after = np.roll(rim, -1)
    walls = np.concatenate(
        (np.stack((ground[rim], ground[after], top[rim]), 1), np.stack((ground[after], top[after], top[rim]), 1))
    )
    mesh = Mesh(np.concatenate((top[squares], ground[squares], walls)))
    for direction in DIRECTIONS:
        frame = View(direction, 128, 128, pixel=0.125).frame(mesh)
        x, y = frame.pixel_centres(*np.divmod(np.arange(128 * 128), 128))
        for shift in (0.0, 0.0625):
            spans = mesh.spans(frame, x + shift, y + shift)
            assert (spans.far >= spans.near).all() and (spans.gaps.leave >= spans.gaps.enter).all()
            volume = (spans.far - spans.near).sum() - (spans.gaps.leave - spans.gaps.enter).sum()
            assert volume * 0.125**2 == pytest.approx(prism_volume(corners, height, squares), rel=0.02)


@pytest.mark.long
def test_mesh_triangles_are_sorted_once_per_image(monkeypatch):
    """Sorting is expensive, so triangles are sorted once for the silhouette, once for the part and once for the model."""
    seen = []

    class Counted(stocks._SeenMesh):
        def __init__(self, mesh, frame):
            super().__init__(mesh, frame)
            seen.append(weakref.ref(self))

    monkeypatch.setattr(stocks, "_SeenMesh", Counted)
    mesh = Mesh(HOLLOW)
    moves, view = toolpath(PATHS[0](np.random.default_rng(3), 30)), View(width=90, height=90)
    z = simulate(moves, tool=TOOLS[0], stock=mesh, view=view, processes=1)
    found = deviations(z, mesh)
    gc.collect()
    assert [own() for own in seen] == [None] * 3 and found.model.frame is z.frame


def prism_volume(corners, height, triangles):
    (ax, ay), (bx, by), (cx, cy) = (corners[triangles[:, k]].T for k in range(3))
    areas = np.abs((bx - ax) * (cy - ay) - (cx - ax) * (by - ay)) / 2
    return (areas * height[triangles].mean(axis=1)).sum()


@pytest.fixture(scope="module")
def prism():
    """Return a prism that approximates a cylinder, 28 mm in diameter and 9 mm high."""
    return ConvexStock.cylinder((20, 15, 1), 14, 9, sides=90)


@pytest.mark.long
@pytest.mark.parametrize("direction", DIRECTIONS)
def test_cylinder_equals_a_prism_with_many_sides(direction, prism):
    exact = Cylinder((20, 15, 1), 14, 9)
    points = PATHS[0](np.random.default_rng(1), 20)
    view = View(direction, 96, 72, pixel=0.5)
    one, two = (simulate(toolpath(points), tool=TOOLS[0], stock=stock, view=view) for stock in (exact, prism))
    assert one.at(0).part_volume == pytest.approx(pi * 14**2 * 9, rel=0.01)
    assert one.part_volume == pytest.approx(two.part_volume, rel=0.002)
    assert removed_volumes(one) == pytest.approx(removed_volumes(two), rel=0.01, abs=2)


@pytest.mark.long
@pytest.mark.parametrize("direction", DIRECTIONS)
@pytest.mark.parametrize("stock", [Cylinder((20, 15, 1), 14, 9), Mesh(HOLLOW)], ids=["cylinder", "hollow"])
def test_estimate_includes_the_stock(stock, direction):
    points = PATHS[1](np.random.default_rng(2), 40)
    solids = {"tool": Tool("endmill", 4), "stock": stock, "view": View(direction, 120, 90)}
    told, true = estimate(toolpath(points), None, **solids), simulate(toolpath(points), **solids)
    assert abs(told.traces - true.traces) < 3 * told.traces_error + 0.01 * true.traces
    assert told.dexels == pytest.approx(true.dexels, rel=0.1)


def areas(mesh, view):
    return seen_areas(mesh, view.frame(mesh), np.random.default_rng(1))


def test_area_of_a_mesh_in_the_image_is_exact():
    """A block shows one side, or three sides if the view is towards a corner.

    The areas of two blocks, one behind the other, are added, and rays have a gap between the blocks.
    """
    block = Mesh(box((0, 0, 0), (2, 3, 4)))
    for direction, area in (((0, 0, -1), 6), ((0, 1, 0), 8), ((1, 0, 0), 12), ((1, 1, -1), (6 + 8 + 12) / sqrt(3))):
        assert areas(block, View(direction)) == pytest.approx((area, 0), rel=0.005)
    two = Mesh(np.concatenate((box((0, 0, 0), (2, 3, 4)), box((0, 0, 5), (2, 3, 6)))))
    assert areas(two, View((0, 0, -1))) == pytest.approx((12, 6)) and areas(two, View((0, 1, 0))) == pytest.approx(
        (10, 0), rel=0.02
    )
    # The image shows a part of the block, the block at a small size, or no block.
    assert areas(block, View((0, 0, -1), 10, 20, pixel=0.05)) == pytest.approx((0.5, 0))
    assert areas(block, View((0, 0, -1), 10, 10, pixel=0.1, offset=(1, 1.5))) == pytest.approx((0.25, 0))
    assert areas(block, View((0, 0, -1), 100, 100, pixel=10)) == pytest.approx((6, 0))
    assert areas(block, View((0, 0, -1), 10, 10, pixel=0.1, offset=(5, 0))) == (0, 0)


# A hundred ribs, 0.5 mm thick, with gaps of 0.5 mm.
COMB = Mesh(np.concatenate([box((0, y + 0.25, 0), (60, y + 0.75, 20)) for y in range(100)]))


@pytest.mark.parametrize(
    "direction, segments", [((0, 1, 0), 199), ((0, 0, -1), 0.5), ((1, 0, 0), 0.5)], ids=["along", "above", "aside"]
)
def test_memory_of_a_mesh_with_gaps_is_estimated(direction, segments):
    """A ray along Y passes a hundred ribs and the gaps between them.

    A ray in another direction passes one rib or none.
    """
    moves = toolpath(np.array([(10, 20, 12), (50, 20, 12)], float))
    solids = {"tool": TOOLS[0], "stock": COMB, "view": View(direction, 128, 128, pixel=0.78125)}
    told, true = estimate(moves, None, **solids), simulate(moves, **solids)
    area = 60 * 20 if direction == (0, 1, 0) else 100 * (60 if direction == (0, 0, -1) else 20)
    assert told.peak.stock + 128 * 128 == pytest.approx(segments * area / 0.78125**2 + 128 * 128, rel=0.03)
    assert told.peak.records + 128 * 128 == pytest.approx(true.peak.records + 128 * 128, rel=0.05)


@pytest.mark.long
def test_mesh_whose_gaps_need_too_much_memory_is_refused():
    """During the simulation, gaps need up to twice the memory of the gaps that are stored at the end."""
    solids = {"tool": TOOLS[0], "view": View((0, 1, 0), 150, 100)}
    moves, block = toolpath(np.array([(10, 20, 12), (50, 20, 12)], float)), Stock(COMB.lower, COMB.upper)
    held, of_block = (
        simulate(moves, stock=stock, memory_budget=1e10, **solids).memory_bytes for stock in (COMB, block)
    )
    least = memory_needed([Cut(moves, TOOLS[0])], stock=block, view=solids["view"])
    gaps = held - of_block
    assert gaps > 10e6
    with pytest.raises(OverBudget) as refused:
        simulate(moves, stock=COMB, memory_budget=least + gaps, **solids)
    assert least + gaps < refused.value.needed < least + 2 * gaps


def test_partial_view_of_mesh_needs_no_more_memory_than_box():
    moves = toolpath(np.array([(10, 15, 8), (30, 15, 8)], float))
    for view in (View(pixel=0.002), View((1, 1, -1), pixel=0.002, offset=(3, 2)), View((0, 1, 0))):
        mesh, plain = (
            memory_needed([Cut(moves, TOOLS[0])], stock=stock, view=view)
            for stock in (Mesh(box(BOX.lower, BOX.upper)), BOX)
        )
        assert mesh == pytest.approx(plain, rel=0.01)


def test_open_surface_is_refused_as_stock():
    for triangles, code in (
        (HOLLOW[1:], "solid-not-closed"),
        (HOLLOW * [1, 1, np.nan], "stock-not-finite"),
        (np.zeros((4, 3, 3)), "stock-without-volume"),
    ):
        with pytest.raises(Unusable) as refused:
            Mesh(triangles)
        assert refused.value.what.code == code
    for radius, height in ((0, 5), (5, -1)):
        with pytest.raises(Unusable):
            Cylinder((0, 0, 0), radius, height)
    with pytest.raises(Unusable):
        Cylinder((0, 0, np.inf), 1, 1)
