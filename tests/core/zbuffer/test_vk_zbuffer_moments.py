# SPDX-License-Identifier: LGPL-2.1-or-later
"""At any moment of a simulation, part and chips together are the stock, and the visible surface is correct."""

from __future__ import annotations

import numpy as np
import pytest
from zbuffer_inputs import BOX, DIRECTIONS, PATHS, ROUND, TOOLS, toolpath

from vkworkbench.core import Tool, View
from vkworkbench.core.zbuffer.rays import surface
from vkworkbench.core.zbuffer.rays.surface import STOCK, Surface
from vkworkbench.core.zbuffer.simulator.simulate import simulate


def simulated(seed):
    rng = np.random.default_rng(seed)
    path, tool = PATHS[seed % len(PATHS)], TOOLS[rng.integers(len(TOOLS))]
    view = View(DIRECTIONS[seed % len(DIRECTIONS)], 70, 50)
    points = path(rng, 60)
    return simulate(toolpath(points), tool=tool, stock=(BOX, ROUND)[seed % 2], view=view), rng


@pytest.mark.parametrize("seed", range(len(DIRECTIONS)))
def test_part_and_chips_are_exactly_the_stock_at_every_moment(seed):
    """No ray has a gap or overlap between the dexels of a moment and the chips, not even a rounding error."""
    z, _ = simulated(seed)
    stock = z.at(0).dexel_records
    pixel = np.repeat(np.arange(len(z.records.entry)), np.diff(z.trace_index.astype(int)))
    for step in range(0, z.trajectories + 1, 7):
        now = z.at(step)
        cut = z.trace_records["trajectory"] < step
        pixels = np.concatenate((now.dexel_records["pixel"], pixel[cut]))
        near, far = (np.concatenate((now.dexel_records[e], z.trace_records[e][cut])) for e in ("near", "far"))
        order = np.lexsort((near, pixels))
        pixels, near, far = pixels[order], near[order], far[order]
        first = np.append(True, pixels[1:] != pixels[:-1])
        assert np.array_equal(near[1:][~first[1:]], far[:-1][~first[1:]])
        assert np.array_equal(pixels[first], stock["pixel"])
        assert np.array_equal(near[first], stock["near"])
        assert np.array_equal(far[np.append(first[1:], True)], stock["far"])
        assert now.traces == np.count_nonzero(cut)


@pytest.mark.parametrize("seed", range(len(DIRECTIONS)))
def test_picture_shows_the_first_dexel_of_every_ray(seed):
    z, rng = simulated(seed)
    for step in (*rng.integers(0, z.trajectories + 1, 12), *range(5), *reversed(range(5)), z.trajectories):
        now = z.at(int(step))
        depth, owner = expected(now)
        assert np.allclose(now.picture.depth, depth, rtol=0, atol=0, equal_nan=True)
        assert np.array_equal(now.picture.owner, owner)


def expected(z):
    """Return, for every ray, the depth of the first dexel and the trajectory whose trace ends at this depth."""
    pixels = len(z.records.entry)
    depth, owner = np.full(pixels, np.nan, np.float32), np.full(pixels, STOCK)
    # numpy keeps the last value assigned to a pixel. Dexels are assigned in reverse, so each pixel keeps its first
    # dexel.
    depth[z.dexel_records["pixel"][::-1]] = z.dexel_records["near"][::-1]
    pixel = np.repeat(np.arange(pixels), np.diff(z.trace_index.astype(int)))
    before = z.trace_records["far"] == depth[pixel]
    owner[pixel[before]] = z.trace_records["trajectory"][before]
    return depth, owner


@pytest.mark.parametrize("seed", range(0, len(DIRECTIONS), 2))
def test_picture_of_chips_shows_the_first_removed_material(seed):
    z, rng = simulated(seed)
    first, end = sorted(rng.integers(0, z.trajectories + 1, 2).tolist())
    chips = z.chips(first, end)
    depth, owner = np.full(70 * 50, np.nan, np.float32), np.full(70 * 50, STOCK)
    for pixel in range(70 * 50):
        own = z.trace_records[z.trace_index[pixel] : z.trace_index[pixel + 1]]
        own = own[(own["trajectory"] >= first) & (own["trajectory"] < end)]
        if len(own):
            depth[pixel], owner[pixel] = own[0]["near"], own[0]["trajectory"]
    assert np.allclose(chips.depth, depth, rtol=0, atol=0, equal_nan=True) and np.array_equal(chips.owner, owner)
    assert np.isnan(z.chips(first, first).depth).all()


def test_all_pixels_that_differ_between_two_moments_are_found():
    z, _ = simulated(3)
    for step in range(z.trajectories):
        one, two = z.at(step).picture, z.at(step + 1).picture
        differs = ~((one.depth == two.depth) | (np.isnan(one.depth) & np.isnan(two.depth)))
        assert np.isin(np.flatnonzero(differs), z.surface.changed(step, step + 1)).all()
    assert np.array_equal(z.surface.changed(9, 4), z.surface.changed(4, 9))
    assert len(z.surface.changed(5, 5)) == 0


def test_picture_without_cuts_shows_stock_and_background():
    z = simulate(toolpath(np.zeros((1, 3))), tool=TOOLS[0], stock=BOX, view=View(pixel=1.0, width=80, height=10))
    assert np.isnan(z.picture.depth).sum() == 40 * 10
    assert (z.picture.owner == STOCK).all()


def test_pictures_of_more_than_65536_trajectories_are_correct():
    """Slots follow 10,000 and 60,000 moves above the block. Each slot changes only its own pixels."""
    above, more = ([(x, 5.0, 20.0) for x in np.linspace(35, 5, count)] for count in (10_000, 60_000))
    points = [*above, (5.0, 5.0, 6.0), (35.0, 5.0, 6.0), *more, (5.0, 25.0, 4.0), (35.0, 25.0, 4.0)]
    z = simulate(toolpath(np.array(points)), tool=TOOLS[0], stock=BOX, view=View((0, 0, -1), 80, 60))
    one, last = 10_000, z.trajectories - 1
    row = {step: z.surface.changed(step, step + 1) // 80 for step in (one, 40_000, last)}
    assert row[one].min() >= 3 and row[one].max() <= 16 and len(row[40_000]) == 0 and row[last].min() >= 43
    assert len(row[one]) > 600 and len(row[last]) > 500
    for step in (0, one, one + 1, 40_000, last, z.trajectories):
        depth, owner = expected(z.at(step))
        assert np.allclose(z.at(step).picture.depth, depth, rtol=0, atol=0, equal_nan=True)
        assert np.array_equal(z.at(step).picture.owner, owner)


def test_picture_updates_only_changed_pixels(monkeypatch):
    """A picture after one more move looks up less than a quarter of the pixels.

    A picture at the end after a picture at the start looks up all pixels.
    """
    looked_up, seen = [], Surface._seen

    def counted(self, step, pixels):
        looked_up.append(len(pixels))
        return seen(self, step, pixels)

    monkeypatch.setattr(Surface, "_seen", counted)
    z, _ = simulated(2)
    again, everywhere = Surface(z.records), len(z.records.entry)
    for step in range(z.trajectories + 1):
        again.picture(step)
    few = [len(again.changed(step, step + 1)) for step in range(z.trajectories)]
    assert max(few) < everywhere / 4 and looked_up == [everywhere, *few]
    assert len(again._removed(0, z.trajectories)) > everywhere / 4
    again.picture(0)
    assert looked_up[-1] == everywhere


@pytest.mark.parametrize("at_once", [1, 70, 1 << 17])
def test_cut_through_the_whole_image_changes_every_pixel(at_once, monkeypatch):
    """A plunge cuts through the whole image, which lies inside the block."""
    monkeypatch.setattr(surface, "_BATCH", at_once)
    points, tool = np.array([(20, 15, 20), (20, 15, -1)], float), Tool("endmill", 100)
    z = simulate(toolpath(points), tool=tool, stock=BOX, view=View((0, 0, -1), 24, 20, pixel=1.0))
    assert z.surface.changed(0, 1).tolist() == list(range(24 * 20))
    assert (z.at(0).picture.depth == z.records.entry).all() and np.isnan(z.at(1).picture.depth).all()


@pytest.mark.parametrize("at_once", [1, 70, 3499, 3500])
def test_changed_pixels_do_not_depend_on_batch_size(at_once, monkeypatch):
    z, _ = simulated(2)
    every = [z.surface.changed(step, step + 5).tolist() for step in range(0, z.trajectories, 5)]
    monkeypatch.setattr(surface, "_BATCH", at_once)
    again = Surface(z.records)
    again.prepare()
    assert [again.changed(step, step + 5).tolist() for step in range(0, z.trajectories, 5)] == every
    assert sum(map(len, every)) > 1000


@pytest.mark.parametrize("seed", [1, 6])
def test_picture_does_not_depend_on_previous_picture(seed):
    """There is no previous picture, or the previous picture shows the moment before, or a distant moment."""
    z, _ = simulated(seed)
    for step in range(0, z.trajectories + 1, 5):
        pictures = []
        for before in ((), (max(step - 1, 0),), (z.trajectories - step,)):
            surface = Surface(z.records)
            for one in before:
                surface.picture(one)
            pictures.append(surface.picture(step))
            assert surface.picture(step) is pictures[-1] and pictures[-1].step == step
        assert all(np.allclose(one.depth, pictures[0].depth, rtol=0, atol=0, equal_nan=True) for one in pictures)
        assert all(np.array_equal(one.owner, pictures[0].owner) for one in pictures)
