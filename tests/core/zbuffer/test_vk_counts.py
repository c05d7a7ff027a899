# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimates from a few hundred rays: the share of rays on which the removed intervals are not connected."""

from __future__ import annotations

import numpy as np
import pytest
from zbuffer_inputs import BOX, toolpath

from vkworkbench.core import Cut, Tool, View
from vkworkbench.core.zbuffer.memory import counts
from vkworkbench.core.zbuffer.rays import chains
from vkworkbench.core.zbuffer.rays.dexels import UNCUT, Segments
from vkworkbench.core.zbuffer.rays.records import GAP
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts


@pytest.mark.parametrize(
    ("owners", "unconnected"),
    [
        ([7], False),
        ([GAP, 2, 5, UNCUT], False),  # The ray was cut from its near end.
        ([UNCUT, 4, 1, 3, UNCUT], False),  # The gap in the material grew in both directions along the ray.
        ([2, UNCUT, 1], True),  # Material is left between two gaps.
        ([UNCUT, 1, 4, 2, UNCUT], True),  # A third cut joined two gaps.
    ],
)
def test_ray_segment_cut_later_than_both_neighbours_is_found(owners, unconnected):
    # Beside the tested ray are two rays of three segments, of which the first and the last are uncut.
    others = [UNCUT, 1, UNCUT]
    rays = np.repeat(np.arange(3), [3, len(owners), 3])
    segments = Segments(rays, np.array(others + owners + others), *np.zeros((2, len(rays))))
    assert counts._unconnected(segments, 4).tolist() == [False, unconnected, False, False]


def test_only_rays_with_unconnected_removed_intervals_are_sorted(monkeypatch):
    rng = np.random.default_rng(3)
    ray = np.sort(rng.integers(0, 200, 800))
    enter = rng.integers(-2, 20, 800).astype(float)
    sorted_ = []
    first_cuts = chains.first_cuts
    monkeypatch.setattr(chains, "first_cuts", lambda *of: sorted_.append(len(of[0])) or first_cuts(*of))
    near, far = np.zeros(200), np.full(200, 20.0)
    segments = chains.cut_rays(near, far, ray, np.arange(800), enter, enter + rng.integers(1, 9, 800))
    assert 20 < counts._unconnected(segments, 200).sum() < 180
    assert sorted_ == [counts._unconnected(segments, 200).sum()]


@pytest.mark.parametrize(("depths", "share"), [([4], 0), ([4, 4], 1), ([8, 4], 1 / 2)])
def test_share_of_unconnected_removals_on_rays_is_estimated(depths, share):
    """In a side view, the wall between two slots separates their intervals.

    Below the shallower slot, rays meet only the deeper slot.
    """
    points = [(10 + 20 * slot, y, z) for slot, z in enumerate(depths) for y in (-20, 50)]
    cuts = Cuts(
        [Cut(toolpath(np.array(points[k : k + 2], float)), Tool("endmill", 6)) for k in range(0, len(points), 2)]
    )
    removal = Removal(cuts, BOX, View((1, 0, 0), 80, 40).frame(BOX))
    assert counts.count(removal).unconnected == pytest.approx(share, abs=0.03)


@pytest.mark.parametrize(("rows", "share"), [(96, 1.0), (128, 0.5), (192, 1.0)])
def test_band_of_64_pixel_rows_with_most_dexels_is_found(rows, share):
    """Each pixel of a slot has a dexel and a trace.

    The slot lies in the first band, in both bands, or in the second band.
    """
    slot = Cut(toolpath(np.array([(-20.0, 15.0, 8.0), (60.0, 15.0, 8.0)])), Tool("endmill", 6))
    removal = Removal(Cuts([slot]), BOX, View((0, 0, -1), 4 * rows // 3, rows).frame(BOX))
    counted = counts.count(removal)
    assert counted.band == pytest.approx(2 * share * counted.touched, rel=0.1)
