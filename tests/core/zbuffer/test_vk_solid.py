# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part as a closed surface of triangles with the part's volume, as an STL file, and as stock of the next job."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core import Cut, Cylinder, Mesh, Stock, Tool, Toolpath, View, simulate, simulate_job
from vkworkbench.core.zbuffer import part_triangles, write_stl

BLOCK = Stock((0, 0, 0), (40, 30, 10))
DOWN, UP = (0, 0, -1), (0, 0, 1)


def moves(seed, level=False):
    points = np.random.default_rng(seed).uniform((0, 0, 2), (40, 30, 12), (20, 3))
    if level:
        points[:, 2] = np.repeat(points[::4, 2], 4)
    return Toolpath.through(points)


def volume(triangles):
    return float((triangles[:, 0] * np.cross(triangles[:, 1], triangles[:, 2])).sum()) / 6


def unpaired_edges(triangles):
    """Return the number of directed edges that do not occur as often as the opposite edge."""
    _, corner = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)
    corner = corner.reshape(-1, 3).astype(np.int64)
    begin, end = corner.ravel(), corner[:, [1, 2, 0]].ravel()
    _, edge = np.unique(np.minimum(begin, end) * (corner.max() + 1) + np.maximum(begin, end), return_inverse=True)
    return int(np.count_nonzero(np.bincount(edge.ravel(), np.where(begin < end, 1, -1))))


CASES = [
    (moves(1, level=True), Tool("endmill", 6), BLOCK, DOWN),
    (moves(2), Tool("ballend", 6), BLOCK, DOWN),
    (moves(3), Tool("endmill", 6), BLOCK, UP),
    (moves(4), Tool("ballend", 6), BLOCK, (1, 1, -1)),  # A ray may have several dexels.
    (moves(5), Tool("endmill", 6), Cylinder((20, 15, 0), 12, 10), (0, 1, 0)),
]


@pytest.mark.parametrize("case", range(len(CASES)))
def test_surface_is_closed_and_has_the_volume_of_the_part(case):
    path, tool, stock, direction = CASES[case]
    done = simulate(path, tool=tool, stock=stock, view=View(direction, 80, 60))
    for moment in (done, done.at(len(path) // 2), done.at(0)):
        triangles = part_triangles(moment)
        assert unpaired_edges(triangles) == 0
        assert volume(triangles) == pytest.approx(moment.part_volume, rel=1e-5)


def test_uncut_block_has_twelve_triangles():
    done = simulate(moves(1), tool=Tool("endmill", 6), stock=BLOCK, view=View(DOWN, 80, 60))
    assert len(part_triangles(done.at(0))) == 12


def test_removed_part_has_no_triangles():
    over = Toolpath.through([(-10, 15, -1), (50, 15, -1)])
    done = simulate(over, tool=Tool("endmill", 60), stock=BLOCK, view=View(DOWN, 40, 30))
    assert part_triangles(done).shape == (0, 3, 3)


def test_stl_file_has_the_same_corners(tmp_path):
    path, tool, stock, direction = CASES[0]
    triangles = part_triangles(simulate(path, tool=tool, stock=stock, view=View(direction, 80, 60)))
    write_stl(tmp_path / "part.stl", triangles)
    data = (tmp_path / "part.stl").read_bytes()
    assert len(data) == 84 + 50 * len(triangles) and int.from_bytes(data[80:84], "little") == len(triangles)
    kind = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("unused", "<u2")])
    read = np.frombuffer(data, kind, offset=84)
    assert (read["corners"] == triangles.astype(np.float32)).all() and unpaired_edges(read["corners"]) == 0
    outwards = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    assert ((read["normal"] * outwards).sum(axis=1) > 0).all()


def test_next_job_begins_with_the_remaining_part():
    """The second job has the remaining part as stock. Both jobs leave the same part as one job with both cuts."""
    view, first, second = (
        View(DOWN, 80, 60, pixel=0.5),
        Cut(moves(1), Tool("endmill", 6)),
        Cut(moves(2), Tool("ballend", 6)),
    )
    left = simulate_job([first], stock=BLOCK, view=view)
    after = simulate_job([second], stock=Mesh(part_triangles(left)), view=view)
    assert after.part_volume == pytest.approx(
        simulate_job([first, second], stock=BLOCK, view=view).part_volume, rel=1e-6
    )


def test_solid_of_equal_heights_has_no_sliver_triangles():
    """Rounding to single precision does not make steps.

    A bore in the part that is turned over has the same floor as the stock.
    """
    left = simulate(moves(1), tool=Tool("endmill", 6), stock=BLOCK, view=View(DOWN, 80, 60))
    stock = Mesh(part_triangles(left) * [1, -1, -1] + [0, 30.01, 10.003])
    triangles = part_triangles(simulate(moves(2), tool=Tool("endmill", 6), stock=stock, view=View(DOWN, 80, 60)))
    heights = np.unique(triangles[:, :, 2].round(12))
    assert np.diff(heights).min() > 2e-5


def test_part_that_is_turned_over_keeps_its_volume():
    left = simulate(moves(1), tool=Tool("endmill", 6), stock=BLOCK, view=View(DOWN, 80, 60))
    turned = Mesh(part_triangles(left) * [1, -1, -1] + [0, 30, 10])
    for size in ((80, 60), (77, 51)):  # The second view has rays close to walls.
        uncut = simulate(moves(1), tool=Tool("endmill", 6), stock=turned, view=View(DOWN, *size)).at(0)
        assert uncut.part_volume == pytest.approx(left.part_volume, rel=0.01)
