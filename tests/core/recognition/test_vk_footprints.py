# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces with the same footprint (bounding box and length), and the depths at which they are cut."""

from __future__ import annotations

import numpy as np
import programs
import pytest
from drawings import polygon

from vkworkbench.core import linearize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.recognition.patterns.footprints import come_again, count_depths, footprints, number_depths
from vkworkbench.core.recognition.patterns.pieces import cut_pieces

SQUARE = {"side": 20.0}
OTHERS = [
    {"side": 20.0, "x": 7.0}, {"side": 20.0, "y": 7.0}, {"side": 30.0, "x": 5.0, "y": 5.0},
    {"side": 20.0, "ratio": 0.5}, {"side": 21.0, "x": 0.5},
]  # fmt: skip


def pieces_of(*strokes):
    return cut_pieces(monotonous_areas(linearize(programs.program(strokes))))


def every(pieces):
    return np.arange(len(pieces))


@pytest.mark.parametrize("other", OTHERS, ids=str)
def test_moved_or_larger_piece_has_another_footprint(other):
    pieces = pieces_of(polygon(**SQUARE), polygon(**other), polygon(**SQUARE, z=-1.0))
    group, count = footprints(pieces, every(pieces))
    assert count == 2 and group[0] == group[2] != group[1]
    again, count = come_again(pieces, every(pieces))
    assert count == 2 and again.tolist() == [True, False, True]


def test_longer_path_in_the_same_box_has_another_footprint():
    """Both paths have the same bounding box, and one path is longer because it also crosses the box."""
    x, y, _ = np.min(polygon(**SQUARE), axis=0)
    wave = [(x, y, 0), (x + 20, y, 0), (x + 20, y + 10, 0), (x, y + 10, 0), (x, y + 20, 0), (x + 20, y + 20, 0)]
    pieces = pieces_of(wave, [*wave[:1], (x + 20, y, 0), (x + 20, y + 20, 0)])
    assert footprints(pieces, every(pieces))[1] == 2


def test_rounding_does_not_change_a_footprint():
    pieces = pieces_of(polygon(**SQUARE), polygon(side=20.0, x=0.004, y=-0.003), polygon(side=20.004))
    assert footprints(pieces, every(pieces))[1] == 1


def test_piece_shifted_by_0_11_mm_has_another_footprint():
    pieces = pieces_of(*(polygon(**SQUARE, x=0.11 * k) for k in range(10)))
    assert footprints(pieces, every(pieces))[1] == 10


def test_equal_pieces_at_one_depth_are_not_repeats_at_depth():
    pieces = pieces_of(polygon(**SQUARE), polygon(**SQUARE, z=0.01), polygon(**SQUARE, x=100.0))
    again, count = come_again(pieces, every(pieces))
    assert not again.any() and count == 2
    again, count = come_again(pieces, np.zeros(0, np.int64))
    assert again.dtype == bool and len(again) == count == 0


def test_different_heights_of_pieces_are_counted_as_depths():
    heights = [np.array(z) for z in ([], [3.0], [3.0, 3.01], [-1.0, 0.0, -1.01, -2.0])]
    assert [count_depths(z) for z in heights] == [0, 1, 1, 3]
    assert [number_depths(z).tolist() for z in heights] == [[], [0], [0, 0], [1, 2, 1, 0]]
