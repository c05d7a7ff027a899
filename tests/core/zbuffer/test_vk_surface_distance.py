# SPDX-License-Identifier: LGPL-2.1-or-later
"""The largest distance between two surfaces of an image, compared with the distances of all pairs of pixels."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core.zbuffer.findings import surface_distance
from vkworkbench.core.zbuffer.findings.surface_distance import _circles, farthest


def every_pair(front, behind, pixel):
    """Return the distance between the surfaces at every pixel, computed from all pairs of pixels."""
    row, column = np.indices(front.shape).reshape(2, -1)
    across = pixel * np.hypot(row[:, None] - row, column[:, None] - column)
    front, behind = front.ravel(), behind.ravel()
    to_front = np.hypot(across, np.maximum(behind[:, None] - front, 0)).min(axis=1)
    to_behind = np.hypot(across, np.maximum(behind - front[:, None], 0)).min(axis=1)
    return np.maximum(to_front, to_behind)


def smooth(rng, height, width):
    values = rng.normal(size=(height, width)) * 4
    for _ in range(4):
        values = (values + sum(np.roll(values, by, axis) for axis in (0, 1) for by in (-1, 1))) / 5
    return values


def terraces(rng, height, width):
    values = np.zeros((height, width))
    for row, column in zip(rng.integers(0, height, 6), rng.integers(0, width, 6)):
        values[row : row + rng.integers(2, 25), column : column + rng.integers(2, 25)] = rng.uniform(-5, 5)
    return values


def spikes(rng, height, width):
    return np.where(rng.random((height, width)) < 0.05, rng.uniform(0, 5, (height, width)), 0)


def plane(rng, height, width):
    return np.add.outer(np.arange(height) * rng.uniform(-1, 1), np.arange(width) * rng.uniform(-1, 1))


@pytest.mark.long
@pytest.mark.parametrize("surface", [smooth, terraces, spikes, plane])
@pytest.mark.parametrize("seed", range(8))
def test_farthest_pixel_of_random_surfaces_is_found(surface, seed):
    rng = np.random.default_rng(seed)
    size, pixel = rng.integers(12, 34, 2), float(rng.choice([0.05, 0.2, 0.5]))
    front, behind = (surface(rng, *size).astype(np.float32) for _ in range(2))
    behind += 2
    pixels = np.flatnonzero((behind > front).ravel())
    wanted = every_pair(front, behind, pixel)
    at, distance = farthest(front, behind, pixels, pixel, 0.0)
    assert distance == pytest.approx(wanted[at], rel=1e-5)
    assert distance == pytest.approx(wanted[pixels].max(), rel=0.02, abs=pixel)
    # If only some pixels are selected, the result is the selected pixel that is farthest from the other surface.
    some = pixels[wanted[pixels] < 0.7 * distance]
    if len(some):
        assert farthest(front, behind, some, pixel, 0.0)[1] == pytest.approx(wanted[some].max(), rel=0.02, abs=pixel)
    assert farthest(front, behind, pixels, pixel, 1.0001 * wanted[pixels].max()) is None


@pytest.mark.long
@pytest.mark.parametrize("size", [40, 200])
def test_distant_surface_is_found_with_few_distances(size, monkeypatch):
    """A high disc lies inside a larger one. The nearest surface is at an edge of a disc, hundreds of pixels away."""
    row, column = np.indices((size, size)) / size - 0.5
    away = np.hypot(row, column)
    front, behind = (np.where(away < radius, 0, 90).astype(np.float32) for radius in (0.45, 0.15))
    looked = []
    distances = surface_distance._distances
    monkeypatch.setattr(surface_distance, "_distances", lambda *of: looked.append(len(of[2])) or distances(*of))
    pixels = np.flatnonzero((behind > front).ravel())
    assert farthest(front, behind, pixels, 1 / size, 0.01)[1] == pytest.approx(0.3, rel=0.02, abs=1 / size)
    assert sum(looked) < 0.2 * len(pixels)


def test_returned_distance_belongs_to_the_returned_pixel():
    """Next to high steps, distances are multiples of the pixel size.

    Rounding must not make equal distances differ.
    """
    for seed in range(40):
        rng = np.random.default_rng(seed)
        size, pixel = rng.integers(8, 16, 2), 0.05
        front = np.where(rng.random(size) < 0.1, 9, 0).astype(np.float32)
        behind = np.where(rng.random(size) < 0.1, 0, 9).astype(np.float32)
        at, distance = farthest(front, behind, np.flatnonzero((behind > front).ravel()), pixel, 0.0)
        assert distance == pytest.approx(every_pair(front, behind, pixel)[at], rel=1e-5), seed


def test_missing_front_surface_counts_as_space_before_it():
    """A plate lies 20 mm above another plate, and ends 3 pixels beside the searched pixel."""
    front, behind = np.zeros((30, 40), np.float32), np.full((30, 40), 20, np.float32)
    front[:, 25:] = np.inf
    pixel = 12 * 40 + 22
    # No part of the rear surface is nearer to the pixel.
    assert farthest(front, behind, np.array([pixel]), 0.5, 0.1) == (pixel, 20)
    behind[:, 26:] = 0
    assert farthest(front, behind, np.array([pixel]), 0.5, 0.1) == (pixel, 2)


def test_distance_to_farthest_image_corner_is_found():
    front, behind = np.zeros((30, 40), np.float32), np.full((30, 40), 90, np.float32)
    front[-1, -1] = 90
    behind[-1, -1] = 0
    assert farthest(front, behind, np.array([0]), 1.0, 0.1) == (0, pytest.approx(np.hypot(29, 39)))


def test_farthest_pixel_is_found_if_all_distances_are_small():
    """A wall 9 mm high is displaced by one pixel (0.05 mm), and a hole is 0.3 mm deep."""
    front, behind = (np.where(np.arange(40) < edge, 0, 9) * np.ones((30, 1)) for edge in (31, 30))
    behind[10, 5] = 0.3
    front, behind = front.astype(np.float32), behind.astype(np.float32)
    pixels = np.flatnonzero((behind > front).ravel())
    assert farthest(front, behind, pixels, 0.05, 0.01) == (10 * 40 + 5, pytest.approx(0.3))


def test_distances_below_the_limit_have_no_farthest_pixel():
    flat = np.zeros((3, 4), np.float32)
    assert farthest(flat, flat + 1, np.array([], int), 0.1, 0.1) is None
    assert farthest(flat, flat + 1, np.arange(12), 0.1, 1.0) is None


def test_search_for_near_surfaces_begins_on_doubling_circles():
    """Circles save time but do not change the found distance, so this test checks the positions on the circles."""
    steps = np.concatenate(_circles(100, 8, 2.0))
    assert np.abs(np.hypot(*steps.T) - np.repeat([1, 2, 4, 8, 16, 32, 64], 8)).max() < 0.75
    far = steps[-8:]
    assert np.degrees(np.arctan2(*far.T)) % 360 == pytest.approx(45.0 * np.arange(8), abs=1.0)
