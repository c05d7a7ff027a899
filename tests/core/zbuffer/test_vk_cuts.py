# SPDX-License-Identifier: LGPL-2.1-or-later
"""The trajectories of several toolpaths: the operation and command of each trajectory, and its duration."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from zbuffer_inputs import toolpath

from vkworkbench.core import Cut, Tool, linearize, machining
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts, Source

ONE = toolpath(np.array([(0, 0, 0), (3, 4, 0), (3, 4, 12)], float))
NONE = toolpath(np.zeros((1, 3)))
OTHER = toolpath(np.array([(5, 0, 0), (5, 6, 0), (5, 6, 8), (7, 6, 8)], float))
OTHER = replace(
    OTHER, rapid=np.array([True, False, False]), feed=np.array([0.0, 4.0, 0.0]), command=np.array([2, 5, 5])
)
TOOL = Tool("endmill", 6)
CUTS = Cuts(Cut(path, TOOL) for path in (ONE, NONE, OTHER))


def test_trajectories_of_all_operations_are_numbered_together():
    assert len(CUTS) == 5 and CUTS.first.tolist() == [0, 2, 2, 5]
    assert CUTS.cut.tolist() == [0, 0, 2, 2, 2] and CUTS.command.tolist() == [0, 1, 2, 5, 5]
    assert [CUTS.source(k) for k in range(5)] == [
        Source(0, 0, 0), Source(0, 1, 1), Source(2, 0, 2), Source(2, 1, 5), Source(2, 2, 5),
    ]  # fmt: skip
    assert CUTS.rapid.tolist() == [False, False, True, False, False]
    start, end = CUTS.ends
    assert start.tolist() == [[0, 0, 0], [3, 4, 0], [5, 0, 0], [5, 6, 0], [5, 6, 8]]
    assert end.tolist() == [[3, 4, 0], [3, 4, 12], [5, 6, 0], [5, 6, 8], [7, 6, 8]]


def test_move_with_feed_has_a_time():
    """Moves of 5 and 12 mm at 10 mm/s, a rapid, 8 mm at 4 mm/s, and 2 mm without a known feed."""
    assert CUTS.lengths.tolist() == [5, 12, 6, 8, 2]
    assert CUTS.feed.tolist() == [10, 10, 0, 4, 0]
    assert CUTS.seconds == pytest.approx([0.5, 1.2, 0, 2, 0])
    slow = replace(ONE, feed=np.array([0.5, 0.25]))
    assert Cuts([Cut(slow, TOOL)]).seconds == pytest.approx([10, 48])


def test_lengths_and_times_follow_arcs_and_not_chords():
    """Arcs are as long as in the report: two turns with a radius of 1 mm, each 0.5 mm deep."""
    turn = ("G2", {"X": 1, "Y": 0, "Z": -0.5, "I": -1, "J": 0, "F": 5})
    bore = linearize([("G0", {"X": 1, "Y": 0, "Z": 0}), turn, ("G2", {**turn[1], "Z": -1.0})], tolerance=0.05)
    cuts = Cuts([Cut(bore, TOOL)])
    assert cuts.lengths.sum() == pytest.approx(2 * np.hypot(2 * np.pi, 0.5))
    assert cuts.seconds.sum() == pytest.approx(machining(bore).cutting_seconds)
    assert bore.lengths.sum() < 0.995 * cuts.lengths.sum()


@pytest.mark.parametrize("number", [-1, 5, 6])
def test_unknown_trajectory_raises_index_error(number):
    with pytest.raises(IndexError, match=f"0 to 4, not {number}"):
        CUTS.source(number)


@pytest.mark.parametrize("number", [1.5, None, "1"])
def test_trajectory_number_must_be_a_whole_number(number):
    with pytest.raises(TypeError, match=f"trajectory must be a whole number, not {number!r}"):
        CUTS.source(number)


def test_cuts_without_operations_have_no_trajectories():
    nothing = Cuts([])
    assert len(nothing) == 0 and nothing.cut.tolist() == nothing.seconds.tolist() == []
    assert [of.shape for of in nothing.ends] == [(0, 3), (0, 3)]
    assert Cut(ONE, TOOL).vertical_feed == 0
