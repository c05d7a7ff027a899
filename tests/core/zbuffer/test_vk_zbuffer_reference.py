# SPDX-License-Identifier: LGPL-2.1-or-later
"""The z-buffer by culling against the same by trying every trajectory on every ray, to the last record.

The reference (tests/zbuffer_reference) is the simulator that the package had before: it tests every trajectory on every
ray whose neighbourhood it passes.
"""

from __future__ import annotations

import numpy as np
import pytest
from zbuffer_reference.paths import BOX, DIRECTIONS, PATHS, ROUND, TOOLS, surface, toolpath, zigzag
from zbuffer_reference.simulate import simulate as reference

from vkworkbench.core import View
from vkworkbench.core.zbuffer.chains import cut_rays
from vkworkbench.core.zbuffer.dexels import first_cuts
from vkworkbench.core.zbuffer.simulate import simulate

# Depths are noise below this, mm: a float32 next to 0 tells more than the arithmetic does.
NOISE = 1e-7


def same(one, two):
    """Whether two arrays of records are equal, but for noise in depths."""
    assert len(one) == len(two)
    for name in one.dtype.names:
        if one.dtype[name].kind == "u":
            assert np.array_equal(one[name], two[name]), name
        else:
            differs = one[name] != two[name]
            one_, two_ = one[name][differs], two[name][differs]
            # What differs in its eleventh digit may be rounded to neighbouring numbers.
            neighbours = np.nextafter(one_, two_) == two_
            assert (neighbours | (np.abs(one_.astype(float) - two_) <= NOISE)).all(), name


@pytest.mark.long
@pytest.mark.parametrize("path", PATHS, ids=lambda p: p.__name__)
@pytest.mark.parametrize("tool", TOOLS, ids=str)
def test_the_same_dexels_and_traces(path, tool):
    which = PATHS.index(path), TOOLS.index(tool)
    rng = np.random.default_rng(which)
    # Every third direction: each meets each path with a third of the tools, and each tool on a third of the paths.
    for direction in DIRECTIONS[sum(which) % 3 :: 3]:
        points = path(rng, int(rng.choice([4, 30, 100])))
        width, height = (int(v) for v in rng.integers(1, (80, 60)))
        view = View(direction, width, height, pixel=(None, 0.3)[rng.integers(2)])
        solids = {"tool": tool, "stock": (BOX, ROUND)[rng.integers(2)], "view": view}
        new, old = simulate(toolpath(points), **solids), reference(toolpath(points), **solids)
        same(new.dexel_records, old.dexel_records)
        same(new.trace_records, old.trace_records)
        assert np.array_equal(new.trace_index, old.trace_index)
        step = int(rng.integers(len(points)))
        same(new.at(step).dexel_records, old.at(step).dexel_records)


@pytest.mark.long
def test_many_trajectories_over_every_pixel():
    """Thousands of passes over each tile, where most of them have to be dropped."""
    rng = np.random.default_rng(0)
    for points, tool, direction in (
        (zigzag(rng, 3000), TOOLS[0], (0, 0, -1)),
        (zigzag(rng, 600), TOOLS[0], (1, 1, -1)),
        (surface(rng, 3000), TOOLS[2], (0, 0, -1)),
        (np.concatenate([zigzag(rng, 400)[:, [1, 0, 2]] for _ in range(4)]), TOOLS[3], (0, 0, -1)),
    ):
        solids = {"tool": tool, "stock": BOX, "view": View(direction, 100, 80)}
        new, old = simulate(toolpath(points), **solids), reference(toolpath(points), **solids)
        same(new.trace_records, old.trace_records)
        same(new.dexel_records, old.dexel_records)


def test_no_more_work_for_passes_that_cut_nothing():
    points = zigzag(np.random.default_rng(1), 200)
    once, often = (
        simulate(toolpath(np.tile(points, (k, 1))), tool=TOOLS[0], stock=BOX, view=View(width=200, height=150))
        for k in (1, 50)
    )
    # They are tested with the largest tiles and dropped there.
    assert once.traces == often.traces
    assert often.candidates < 12 * once.candidates


def test_rays_with_one_gap_are_cut_as_the_general_way_does():
    rng = np.random.default_rng(5)
    rays, each = 300, 6
    near, far = np.full(rays, -3.0), rng.uniform(2, 9, rays)
    ray = np.repeat(np.arange(rays), each)
    middle = rng.choice([0.0, 1.0, 2.0], len(ray))
    length = rng.choice([1e-5, 5e-5, 0.7, 2.0, 4.0], len(ray))
    enter, leave = middle - length * rng.random(len(ray)), middle + length
    trajectory = np.tile(np.arange(each), rays)
    quick = cut_rays(near, far, ray, trajectory, enter, leave)
    general = first_cuts(near, far, ray, trajectory, enter, leave)
    for name in ("ray", "owner"):
        assert np.array_equal(getattr(quick, name), getattr(general, name)), name
    for name in ("near", "far"):
        assert getattr(quick, name) == pytest.approx(getattr(general, name), abs=NOISE)
