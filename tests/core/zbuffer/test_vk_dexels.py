# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rays cut by sequences of intervals: at each depth, the first interval with this depth removes the material."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core.zbuffer.rays.dexels import THINNEST, UNCUT, Segments, first_cuts, without_thin


@pytest.mark.parametrize("cuts", [0, 1, 2, 15])
@pytest.mark.parametrize("thickness", [0.1, 2.0, 50.0])
def test_depth_of_a_ray_is_removed_by_first_trajectory_there(cuts, thickness):
    rng = np.random.default_rng(cuts)
    near, far = np.array([3.0, 3.2, 3.0]), 3.0 + thickness * np.array([1.0, 0.9, 1.0]) + [0, 0.2, 0]
    ray, trajectory = np.sort(rng.integers(0, 3, cuts)), rng.permutation(cuts)
    enter, leave = np.sort(3.0 + thickness * rng.uniform(-0.1, 1.1, (2, cuts)), axis=0)
    found = first_cuts(near, far, ray, trajectory, enter, leave)
    assert (found.far > found.near).all()
    for of in range(3):
        for depth in near[of] + (far[of] - near[of]) * np.linspace(0.013, 0.987, 60):
            passing = (ray == of) & (enter < depth) & (depth < leave)
            (segment,) = np.flatnonzero((found.ray == of) & (found.near < depth) & (depth < found.far))
            assert found.owner[segment] == min(trajectory[passing], default=UNCUT)


def test_thin_first_segment_of_a_ray_joins_the_next_segment():
    thin = 0.5 * THINNEST
    segments = Segments(np.array([0, 0]), np.array([1, 2]), np.array([3.0, 3.0 + thin]), np.array([3.0 + thin, 4.0]))
    found = without_thin(segments, np.array([3.0]), np.array([4.0]))
    assert [of.tolist() for of in (found.ray, found.owner, found.near, found.far)] == [[0], [2], [3.0], [4.0]]


def test_dropped_thin_segments_of_rays_leave_no_gaps():
    """Some of the six segments of each ray are thin. A ray with only thin segments has no material."""
    for seed in range(20):
        rng = np.random.default_rng(seed)
        lengths = np.where(rng.random((3, 6)) < 0.5, 0.4 * THINNEST, rng.uniform(0.5, 2, (3, 6)))
        ends = np.cumsum(np.column_stack((rng.uniform(1, 9, 3), lengths)), axis=1)
        near, far = ends[:, :-1], ends[:, 1:]
        owner = rng.permutation(18).reshape(3, 6)
        segments = Segments(np.repeat(np.arange(3), 6), owner.ravel(), near.ravel(), far.ravel())
        found = without_thin(segments, ends[:, 0], ends[:, -1])
        for ray in range(3):
            own, thick = found.ray == ray, lengths[ray] > THINNEST
            assert found.owner[own].tolist() == owner[ray][thick].tolist(), seed
            if thick.any():
                filled = np.append(found.near[own], ends[ray, -1])
                assert filled[0] == ends[ray, 0] and found.far[own].tolist() == filled[1:].tolist(), seed
                middle = (near[ray] + far[ray])[thick] / 2
                assert ((found.near[own] < middle) & (middle < found.far[own])).all(), seed


def test_rays_beside_the_stock_have_no_segments():
    nothing, beside = np.array([], int), np.array([2.0, 3.0])
    assert len(first_cuts(beside, beside, nothing, nothing, beside[:0], beside[:0]).ray) == 0
