# SPDX-License-Identifier: LGPL-2.1-or-later
"""The numbers beside a verdict and the sentence that tells them, of toolpaths that were drawn so."""

from __future__ import annotations

import programs
import pytest
from drawings import polygon

from vkworkbench.core import Strategy, linearize, recognize

TOOL = 6.0


def found_in(commands):
    return recognize(linearize(commands), tool_diameter=TOOL)


@pytest.mark.parametrize(
    ("outward", "clockwise", "milling"),
    [(True, False, "climb"), (True, True, "conventional"), (False, False, "conventional"), (False, True, "climb")],
)
def test_what_is_left_to_cut_lies_right_of_a_climbing_tool(outward, clockwise, milling):
    sides = [20 + 6 * k for k in range(8)][:: 1 if outward else -1]
    found = found_in(programs.program([polygon(side, clockwise=clockwise) for side in sides]))
    assert found.strategy is Strategy.CONTOUR_PARALLEL and found.stepover == pytest.approx(3.0)
    assert (found.sense, found.milling) == ("cw" if clockwise else "ccw", milling)
    assert (found.passes, found.closed_loops, found.depths, found.direction) == (8, 8, 1, None)
    assert "3 mm apart" in found.reason and ("counter-clockwise" in found.reason) == (not clockwise)
    assert "depths" not in found.reason


def test_where_loops_run_both_ways_there_is_no_sense_and_no_milling():
    found = found_in(programs.program([polygon(20 + 6 * k, clockwise=k % 2 == 0) for k in range(8)]))
    assert found.sense is None and found.milling is None and "clockwise" not in found.reason


def test_where_some_loops_grow_and_some_shrink_there_is_no_milling():
    """An outward nest and, as long, an inward one, all counter-clockwise."""
    sides = [20 + 6 * k for k in range(8)]
    strokes = [polygon(side) for side in sides] + [polygon(side, x=200.0) for side in sides[::-1]]
    found = found_in(programs.program(strokes))
    assert found.sense == "ccw" and found.milling is None


def test_rows_have_a_direction_and_depths():
    found = found_in(programs.zigzag(10, 50.0, 3.0, depths=(0.0, -2.0)))
    assert (found.strategy, found.passes, found.depths) == (Strategy.ZIGZAG, 20, 2)
    assert found.direction == pytest.approx(0.0) and found.stepover == pytest.approx(3.0)
    assert found.sense is None and found.milling is None and found.closed_loops == 0
    assert "3 mm apart" in found.reason and "2 depths" in found.reason


def test_one_contour_at_several_depths_tells_these_and_no_step():
    found = found_in(programs.profile(depths=(0.0, -2.0, -4.0)))
    assert (found.strategy, found.stepover, found.depths, found.closed_loops) == (Strategy.PROFILE, None, 3, 3)
    assert "3 depths" in found.reason and "apart" not in found.reason


def test_grids_have_the_rows_of_both_directions():
    across = [[(0.0, 3.0 * row, 0.0), (60.0, 3.0 * row, 0.0)] for row in range(20)]
    down = [[(4.0 * row, 0.0, 0.0), (4.0 * row, 57.0, 0.0)] for row in range(16)]
    found = found_in(programs.program(across + down))
    assert found.strategy.family.name == "ROWS" and found.passes == 36
    assert found.stepover == pytest.approx(3.0) and found.direction == pytest.approx(0.0)


def test_letters_are_strokes():
    found = found_in(programs.engraving())
    assert found.strategy is Strategy.ENGRAVING and found.direction is None and found.milling is None
    assert "strokes" in found.reason
