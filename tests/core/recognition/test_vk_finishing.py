# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contours that finish the walls of an area cleared by the previous or next section are part of that operation."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from vkworkbench.core import Strategy
from vkworkbench.core.recognition.programs.finishing import CutSection, within_operations

CLEARED = (0.0, 0.0, 30.0, 40.0)  # The diagonal is 50 mm.
AROUND = (-2.0, -2.0, 32.0, 42.0)
ZIGZAG, ADAPTIVE, PROFILE, OFFSETS = Strategy.ZIGZAG, Strategy.ADAPTIVE, Strategy.PROFILE, Strategy.CONTOUR_PARALLEL


def found_in(*sections, where=0.0, doubtful=None, rapids=True):
    """Return the indices of the sections that belong to the operation before the section.

    A section is (strategy, box[, depth[, passes[, stepover]]]). The links between sections are rapids or feed moves.
    """
    points, rapid, cut = [(where, where, 5.0)], [], []
    for strategy, (x, y, u, v), *more in sections:
        depth, passes, stepover = (*more, *(-1.0, None, None)[len(more) :])
        points += [(where + x, where + y, depth), (where + u, where + v, depth)]
        rapid += [rapids, False]
        last = len(rapid) - 1
        one = SimpleNamespace(
            strategy=strategy, passes=passes, stepover=stepover, spans=(SimpleNamespace(first=last, last=last),)
        )
        cut.append(CutSection(last - 1, last + 1, one))
    path = SimpleNamespace(points=np.array(points), rapid=np.array(rapid))
    begins = [section.begin for section in cut]
    doubts = set(begins) if doubtful is None else {begins[k] for k in doubtful}
    return [begins.index(at) for at in sorted(within_operations(path, cut, doubts))]


@pytest.mark.parametrize("where", [0.0, 1000.0])
@pytest.mark.parametrize("clearing", [ZIGZAG, Strategy.ONE_WAY, ADAPTIVE])
def test_finishing_contour_is_found_before_or_after_the_clearing(clearing, where):
    assert found_in((clearing, CLEARED), (PROFILE, AROUND), where=where) == [1]
    assert found_in((PROFILE, AROUND), (clearing, CLEARED), where=where) == [1]


@pytest.mark.parametrize("rapids", [True, False])
def test_link_to_the_next_section_is_not_part_of_a_contour(rapids):
    far = ADAPTIVE, (100.0, 100.0, 130.0, 140.0)
    assert found_in((ADAPTIVE, CLEARED), (PROFILE, AROUND), far, rapids=rapids) == [1]


@pytest.mark.parametrize(
    "sections",
    [
        # The contour extends beyond the area by more than a twentieth of the diagonal.
        [(ADAPTIVE, CLEARED), (PROFILE, (-3.0, -2.0, 32.0, 42.0))],
        [(ADAPTIVE, CLEARED), (PROFILE, (0.0, 0.0, 30.0, 36.0))],
        [(ADAPTIVE, CLEARED), (PROFILE, AROUND, -2.0)],
        [(OFFSETS, CLEARED, -1.0, 6), (PROFILE, AROUND)],
        [(PROFILE, CLEARED), (PROFILE, AROUND)],
        [(ZIGZAG, CLEARED), (ADAPTIVE, AROUND)],
        [(ZIGZAG, CLEARED), (Strategy.WATERLINE, AROUND)],
        [(ZIGZAG, CLEARED), (Strategy.DRILLING, CLEARED), (PROFILE, AROUND)],
        [(ADAPTIVE, CLEARED), (OFFSETS, AROUND, -1.0, 3)],
    ],
)
def test_contours_that_finish_no_cleared_area_are_own_operations(sections):
    assert found_in(*sections) == []


def test_finishing_contour_of_a_small_area_is_found_by_stepover():
    # The contour lies 0.5 mm outside the area, and a twentieth of the area's diagonal is 0.25 mm.
    small, out = (0.0, 0.0, 3.0, 4.0), (-0.5, -0.5, 3.5, 4.5)
    assert found_in((ADAPTIVE, small), (PROFILE, out)) == []
    assert found_in((ADAPTIVE, small, -1.0, 9, 0.6), (PROFILE, out)) == [1]


def test_two_nested_finishing_walls_belong_to_the_clearing():
    assert found_in((ADAPTIVE, CLEARED), (OFFSETS, AROUND, -1.0, 2)) == [1]


def test_contour_within_a_stepover_around_rows_finishes_the_rows():
    out = (-3.5, -3.5, 33.5, 43.5)  # The contour lies farther outside than a twentieth of the diagonal.
    lower, upper = (0.0, 0.0, 30.0, 15.0), (0.0, 20.0, 30.0, 40.0)
    assert found_in((ZIGZAG, CLEARED, -1.0, 9, 4.0), (PROFILE, out)) == [1]
    assert found_in((ZIGZAG, CLEARED, -1.0, 9, 3.0), (PROFILE, out)) == []
    assert found_in((ZIGZAG, lower, -1.0, 9, 4.0), (ADAPTIVE, upper, -1.0, 9), (PROFILE, out)) == [1, 2]


def test_several_contours_may_finish_several_cleared_areas():
    island, wall = (10.0, 10.0, 20.0, 20.0), (-1.0, -1.0, 31.0, 41.0)
    assert found_in((ADAPTIVE, CLEARED), (PROFILE, island), (PROFILE, wall)) == [1, 2]
    assert found_in((PROFILE, wall), (PROFILE, island), (ADAPTIVE, CLEARED)) == [1, 2]
    lower, upper = (0.0, 0.0, 30.0, 15.0), (0.0, 20.0, 30.0, 40.0)
    assert found_in((ADAPTIVE, lower), (ADAPTIVE, upper), (PROFILE, island), (PROFILE, wall)) == [1, 2, 3]
    assert found_in((ADAPTIVE, lower), (ADAPTIVE, upper), (PROFILE, lower)) == []


def test_distant_or_deeper_contour_is_an_own_operation():
    out = (-20.0, -20.0, 50.0, 60.0)
    assert found_in((ADAPTIVE, CLEARED), (PROFILE, AROUND), (PROFILE, out)) == [1]
    assert found_in((PROFILE, out), (PROFILE, AROUND), (ADAPTIVE, CLEARED)) == [2]
    assert found_in((ADAPTIVE, CLEARED), (PROFILE, AROUND), (PROFILE, AROUND, -3.0)) == [1]
    assert found_in((ADAPTIVE, CLEARED), (PROFILE, AROUND), (ADAPTIVE, CLEARED, -3.0), (PROFILE, AROUND, -3.0)) == [
        1,
        3,
    ]


def test_certain_borders_between_operations_are_kept():
    sections = (ADAPTIVE, CLEARED), (PROFILE, AROUND), (PROFILE, AROUND)
    assert found_in(*sections, doubtful=[2]) == []
    assert found_in(*sections, doubtful=[1]) == [1]


def test_air_cut_between_clearing_and_contour_separates_them():
    points = np.array([(0.0, 0.0, 5.0), (0.0, 0.0, -1.0), (30.0, 40.0, -1.0), (0.0, 0.0, -1.0)])
    path = SimpleNamespace(points=points, rapid=np.array([True, False, False]))
    one, two = (
        SimpleNamespace(strategy=strategy, passes=None, stepover=None, spans=(SimpleNamespace(first=k, last=k),))
        for k, strategy in ((1, ADAPTIVE), (2, PROFILE))
    )
    assert within_operations(path, [CutSection(0, 2, one), CutSection(2, 3, two)], {2}) == {2}
    assert within_operations(path, [CutSection(0, 1, one), CutSection(2, 3, two)], {2}) == set()
