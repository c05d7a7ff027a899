# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines of the Gauss map: arcs are drawn with chords, and segments that look alike are drawn once."""

from __future__ import annotations

import numpy as np
import programs
import pytest

from vkworkbench.core import linearize
from vkworkbench.core.paper import monotonous_areas
from vkworkbench.core.paper.picture import distinct, image_arcs, links, outline, proof


def test_links_in_the_picture_join_the_ends_of_strokes():
    strokes = [[(0.0, 0.0, -1.0), (30.0, 10.0, -1.0)], [(5.0, 50.0, -1.0), (5.0, 60.0, -1.0), (45.0, 40.0, -1.0)]]
    areas = monotonous_areas(linearize(programs.program(strokes)))
    gap = (np.nan, np.nan)
    first, second = ([point[:2] for point in stroke] for stroke in strokes)
    np.testing.assert_array_equal(outline(areas), [*first, gap, *second, gap])
    np.testing.assert_array_equal(links(areas), [first[-1], second[0], gap])


def test_arc_of_gauss_image_has_chords_of_at_most_four_degrees():
    """An arc of ten degrees has three chords, between both radii. Half a turn has no sense, and is not drawn."""
    angle = np.radians([20, 30, 28, 208])
    left, right = image_arcs(angle, np.array([1.0, 0.7, 0.9, 0.9]))
    assert np.degrees(np.arctan2(left[:4, 1], left[:4, 0])) == pytest.approx([20, 20 + 10 / 3, 20 + 20 / 3, 30])
    assert np.hypot(*left[:4].T) == pytest.approx([1, 0.9, 0.8, 0.7])
    assert len(left) == 5 and np.isnan(left[4]).all()
    assert np.degrees(np.arctan2(right[:2, 1], right[:2, 0])) == pytest.approx([30, 28])
    assert np.hypot(*right[:2].T) == pytest.approx([0.7, 0.9]) and len(right) == 3


def test_longest_of_the_loops_with_equal_phi_is_shown():
    angle = np.linspace(0, 2 * np.pi, 60)

    def circle(radius, x):
        return [
            (*point, 0.0) for point in np.column_stack([x + radius * np.cos(angle), radius * np.sin(angle)]).tolist()
        ]

    areas = monotonous_areas(linearize(programs.program([circle(5.0, 0.0), circle(20.0, 50.0), circle(8.0, 100.0)])))
    areas.phi_ranges[:, 1] += [5e-7, 0.0, 5e-7]
    assert proof(areas, 0, len(areas), around=True) == 1


def rows(count, apart, at):
    """Return rows of 10 mm from (at, at), `apart` from each other. Every other segment is a row."""
    points = [(x, k * apart) for k in range(count) for x in ((0, 10) if k % 2 == 0 else (10, 0))]
    return np.array(points, float) + at, 2 * np.arange(count)


@pytest.mark.parametrize("at", [0.0, 300.0, -300.0])
def test_first_of_the_rows_that_share_a_cell_is_drawn(at):
    """Ninety rows lie in ten cells of 1 mm, or in five cells of 2 mm if the limit is six drawn rows."""
    points, segments = rows(90, 0.11, at)
    for most, cell in ((20, 1), (6, 2)):
        cells = (np.arange(90) * 0.11 / cell).astype(int)
        expected = segments[np.unique(cells, return_index=True)[1]]
        assert distinct(points, segments, cells=10, most=most).tolist() == expected.tolist()
    assert distinct(points, segments, cells=10, most=90) is segments


def test_number_of_drawn_strokes_is_limited():
    points, segments = rows(4, 3.0, 0.0)
    assert distinct(points, segments, cells=10, most=1).tolist() == [0]
    standing = np.column_stack((points, np.zeros(len(points))))
    assert (
        distinct(standing, segments, cells=10, most=3).tolist() == distinct(points, segments, cells=10, most=3).tolist()
    )


def test_rays_to_both_sides_of_a_common_start_are_distinct():
    """A star is drawn in cells of 1 mm. Rays that end left and right of the centre are drawn separately."""
    ends = [(-10, -10), (-0.4, 0), (0.4, 0), (10, 10), (10, 10)]
    points = np.array([point for end in ends for point in ((0.0, 0.0), end)], float)
    assert distinct(points, 2 * np.arange(5), cells=20, most=4).tolist() == [0, 2, 4, 6]


def test_fan_is_drawn_with_one_ray_per_cell():
    """Ninety rays of 10 mm spread by up to 9.8 mm at their ends, on cells of 1 mm."""
    points, segments = np.zeros((180, 2)), 2 * np.arange(90)
    points[1::2] = np.column_stack((np.full(90, 10.0), np.arange(90) * 0.11))
    first = segments[np.unique((np.arange(90) * 0.11).astype(int), return_index=True)[1]]
    assert distinct(points, segments, cells=10, most=20).tolist() == first.tolist()
    assert len(distinct(points[::-1], segments, cells=10, most=20)) == len(first) == 10


def test_segments_between_different_cells_are_distinct():
    places = [(x, y) for x in range(5) for y in range(5)]
    pairs = [pair for k, one in enumerate(places) for pair in ((one, other) for other in places[k + 1 :])]
    points = np.array([point for pair in pairs + pairs for point in pair], float)
    found = distinct(points, 2 * np.arange(2 * len(pairs)), cells=4, most=len(pairs))
    assert found.tolist() == (2 * np.arange(len(pairs))).tolist()


def test_path_of_at_most_one_area_has_no_links():
    for strokes in ([], [[(0, 0, 0), (9, 0, 0)]]):
        assert links(monotonous_areas(linearize(programs.program(strokes)))).shape == (0, 2)
