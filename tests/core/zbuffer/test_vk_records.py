# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dexels, traces and removed lengths of a few rays, from segments of the rays that are written down by hand."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core.zbuffer.rays import records as module
from vkworkbench.core.zbuffer.rays.records import GAP, Records, Writer, side_by_side

TRAJECTORIES = 3  # In `OWNER`, the number 3 means material that stays.
# The segments on the rays of pixels 0 to 5 are: cut, stays, cut; none; stays, gap, stays, stays; cut; cut, cut, stays;
# stays.
INDEX = [0, 3, 3, 7, 8, 11, 12]
ENTRY = [-5.0, 0.0, -4.0, 1.0, 2.0, 6.0]
FAR = [-3.0, 1.0, 5.0, -2.0, 0.0, 1.5, 4.0, 3.0, 3.0, 5.0, 9.0, 8.0]
OWNER = [0, 3, 2, 3, GAP, 3, 3, 0, 1, 2, 3, 3]
NEAR = [-5, -3, 1, -4, -2, 0, 1.5, 1, 2, 3, 5, 6]
PIXEL = [0, 0, 0, 2, 2, 2, 2, 3, 4, 4, 4, 5]


def records():
    return Records(TRAJECTORIES, np.array(INDEX, module.INDEX), np.array(ENTRY, np.float32),
                   np.array(FAR, np.float32), np.array(OWNER, np.int32))  # fmt: skip


def same(one, other):
    assert one.trajectories == other.trajectories
    for name in ("index", "entry", "far", "owner"):
        mine, others = getattr(one, name), getattr(other, name)
        assert mine.dtype == others.dtype and mine.tolist() == others.tolist(), name


def part(rays, begin, end):
    """Return the dexels and traces of the pixels from `begin` to `end`."""
    own = slice(rays.index[begin], rays.index[end])
    index = rays.index[begin : end + 1] - rays.index[begin]
    return Records(TRAJECTORIES, index, rays.entry[begin:end], rays.far[own], rays.owner[own])


def test_near_ends_and_pixels_of_segments_of_rays_are_computed():
    rays = records()
    assert rays.near().tolist() == NEAR and rays.pixel().tolist() == PIXEL
    assert rays.cut.tolist() == [True, False, True, *[False] * 4, True, True, True, False, False]
    assert rays.nbytes == 4 * (7 + 6 + 12 + 12) == 4 + module.PIXEL_BYTES * 6 + module.RECORD_BYTES * 12


@pytest.mark.parametrize("block", [1, 2, 4, 1 << 17])
def test_removed_lengths_on_rays_do_not_depend_on_batch_size(block, monkeypatch):
    monkeypatch.setattr(module, "_BLOCK", block)
    rays = records()
    assert rays.lengths.tolist() == [2 + 2, 1, 4 + 2]
    for owners, segments in (([1, 0, 1], [0, 2, 7, 9]), ([0, 1, 0], [8]), ([0, 0, 0], [])):
        segment, pixel, near = rays.segments_of(np.array(owners, bool))
        assert segment.tolist() == segments and pixel.tolist() == [PIXEL[k] for k in segments]
        assert near.tolist() == [NEAR[k] for k in segments]
    blocks = list(rays.blocks())
    at = 0
    for pixel, segment, of in blocks:
        assert (pixel, segment) == (at, INDEX[at])
        same(of, part(rays, at, at + len(of.entry)))
        at += len(of.entry)
    assert at == 6
    assert len(blocks) == {1: 5, 2: 3, 4: 3, 1 << 17: 1}[block]  # The segments of one ray stay in one batch.


def test_batches_of_rays_are_larger_for_many_trajectories(monkeypatch):
    """A batch has at least a quarter as many segments as trajectories, because it needs sums over all trajectories."""
    monkeypatch.setattr(module, "_BLOCK", 1)
    many = Records(24, *(getattr(records(), name) for name in ("index", "entry", "far", "owner")))
    assert [pixel for pixel, _, _ in many.blocks()] == [0, 2]


@pytest.mark.parametrize(
    "step, expected",
    [
        (0, [(-5, 5, 0), (-4, -2, 2), (0, 4, 2), (1, 3, 3), (2, 9, 4), (6, 8, 5)]),
        (1, [(-3, 5, 0), (-4, -2, 2), (0, 4, 2), (2, 9, 4), (6, 8, 5)]),
        (2, [(-3, 5, 0), (-4, -2, 2), (0, 4, 2), (3, 9, 4), (6, 8, 5)]),
        (3, [(-3, 1, 0), (-4, -2, 2), (0, 4, 2), (5, 9, 4), (6, 8, 5)]),
    ],
)
def test_dexels_are_segments_of_rays_that_are_not_yet_removed(step, expected):
    assert records().dexels(step).tolist() == expected


def test_each_trace_is_the_removal_of_one_trajectory():
    rays = records()
    assert rays.traces().tolist() == [(-5, -3, 0), (1, 5, 2), (1, 3, 0), (2, 3, 1), (3, 5, 2)]
    assert rays.trace_index().tolist() == [0, 2, 2, 2, 3, 5, 5]


def test_adjacent_parts_of_an_image_are_joined():
    """The image has three columns and two rows. The first part has one column, and the second part has two."""
    whole = records()
    rows = [[part(whole, 3 * row + a, 3 * row + b) for row in range(2)] for a, b in ((0, 1), (1, 3))]
    parts = []
    for one, other in rows:
        written = Writer(TRAJECTORIES, len(one.entry) + len(other.entry))
        written.append(one)
        written.append(other)
        parts.append(written.records())
    same(side_by_side(parts, 2), whole)
    assert side_by_side([whole], 2) is whole


@pytest.mark.parametrize("bands", [(0, 6), (0, 1, 2, 3, 4, 5, 6), (0, 2, 6), (0, 5, 6)])
def test_bands_of_rows_are_joined_to_one_image(bands):
    whole, written = records(), Writer(TRAJECTORIES, 6)
    for begin, end in zip(bands, bands[1:]):
        written.append(part(whole, begin, end))
    same(written.records(), whole)


def test_growing_arrays_of_segments_are_copied_only_a_few_times():
    """The arrays grow by an eighth, so appending one segment of a ray 4,096 times causes only a few copies."""
    written, band = Writer(TRAJECTORIES, 4096), part(records(), 5, 6)
    sizes = set()
    for _ in range(4096):
        written.append(band)
        sizes.add(len(written.far))
    assert len(sizes) < 80 and max(sizes) <= 4096 * 9 // 8
    assert len(written.records().far) == len(written.records().owner) == 4096
