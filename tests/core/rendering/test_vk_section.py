# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections of the part, and the path of the tool over the picture."""

from __future__ import annotations

import numpy as np
import pytest

from vkworkbench.core import Cut, Stock, Tool, View, linearize, simulate_job
from vkworkbench.core.rendering import CUT, CUT_OPEN, Field, Section, draw_path, palette, scene

BLOCK = Stock((0, 0, 0), (60, 40, 12))
SLOT = [("G0", {"X": 30, "Y": -5, "Z": 20}), ("G1", {"Z": 5}), ("G1", {"Y": 45}), ("G0", {"Z": 20})]


@pytest.fixture(scope="module")
def slot():
    """Return a simulated block with a slot along Y, 6 mm wide and 7 mm deep."""
    return simulate_job([Cut(linearize(SLOT), Tool("endmill", 6))], stock=BLOCK, view=View(width=600, height=400))


def drawn(zbuffer, direction, section=None):
    frame = View(direction, 300, 200).frame(BLOCK)
    return scene(Field(zbuffer, section=section), frame, palette(CUT)), frame


def test_section_shows_the_profile_of_a_slot(slot):
    """Seen along Y, the face of a section in Y has the area of the part's profile."""
    shown, frame = drawn(slot, (0, -1, 0), Section(1, 20.0, True))
    face = shown.owner == CUT_OPEN
    assert face.sum() * frame.pixel**2 == pytest.approx(60 * 12 - 6 * 7, rel=0.02)
    depth = shown.depth[face]
    # The cut face is in the middle of the block.
    assert np.ptp(depth) < 0.2 and depth.mean() == pytest.approx(0.0, abs=0.1)


@pytest.mark.parametrize("hides_above", [True, False])
def test_horizontal_section_fills_the_cut_material(slot, hides_above):
    direction = (0, 0, -1 if hides_above else 1)
    for height, area in ((8.0, 54 * 40), (3.0, 60 * 40)):
        shown, frame = drawn(slot, direction, Section(2, height, hides_above))
        face = shown.owner == CUT_OPEN
        assert face.sum() * frame.pixel**2 == pytest.approx(area, rel=0.03)
        points = frame.points(*np.nonzero(face)[::-1], shown.depth[face])
        assert np.abs(points[:, 2] - height).max() < 1e-3


def test_section_plane_beyond_the_part_keeps_the_picture(slot):
    whole, _ = drawn(slot, (-1, 1, -1))
    for section in (Section(0, 70.0, True), Section(1, -5.0, False), Section(2, 15.0, True)):
        shown, _ = drawn(slot, (-1, 1, -1), section)
        assert (shown.pixels == whole.pixels).all()


def test_path_is_drawn_as_a_line_without_gaps(slot):
    _, frame = drawn(slot, (0, 0, -1))
    pixels = np.zeros((frame.height, frame.width), np.uint32)
    draw_path(pixels, np.array([(-1000.0, 10.0, 0.0), (1000.0, 30.0, 0.0)]), frame, (1, 2, 3))
    row, column = np.nonzero(pixels)
    assert set(pixels[row, column].tolist()) == {0xFF010203}
    # The path also covers the first and the last column of the picture.
    assert sorted(set(column.tolist())) == list(range(frame.width))
    assert len(column) < 1.1 * frame.width


def test_path_beside_the_picture_is_not_drawn(slot):
    _, frame = drawn(slot, (0, 0, -1))
    for points in (np.zeros((0, 3)), np.zeros((1, 3)), np.array([(500.0, 500, 0), (500, 900, 0), (900, 900, 0)])):
        pixels = np.zeros((frame.height, frame.width), np.uint32)
        draw_path(pixels, points, frame, (255, 255, 255))
        assert not pixels.any()
