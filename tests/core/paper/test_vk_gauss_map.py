# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines of the Gauss map, which is the picture of the paper's method."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vkworkbench.core.gcode import linearize
from vkworkbench.core.paper.areas import monotonous_areas
from vkworkbench.core.paper.picture import distinct, image_arcs, links, outline, overlapping, proof, thinned, turns_of


def spiral_in(loops):
    """Return linked square loops, each 2 mm inside the preceding loop."""
    commands = [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"Z": 0.0})]
    for inset in range(0, 2 * loops, 2):
        a, b = float(inset), 40.0 - inset
        commands += [("G1", {"X": b}), ("G1", {"Y": b}), ("G1", {"X": a}), ("G1", {"Y": a + 2.0})]
    return commands


def test_rapids_separate_areas_of_the_gauss_map():
    first = spiral_in(3)
    second = [("G0", {"Z": 5.0}), ("G0", {"X": 100.0, "Y": 0.0}), ("G1", {"Z": 0.0}), ("G1", {"X": 105.0})]
    areas = monotonous_areas(linearize(second + first))
    assert len(areas.start) == 2
    longest = areas.by_length[0]
    assert longest == 1 and areas.area_length[longest] > areas.area_length[0] == 5.0
    signature = areas.signature(longest)
    assert len(signature.vertices) == 13
    assert signature.phi[0] == 0 and signature.level[-1] == 2 and signature.phi[-1] == pytest.approx(5.5 * np.pi)
    polyline = outline(areas)
    assert np.isnan(polyline[2]).all() and np.isnan(polyline[-1]).all() and len(polyline) == 2 + 1 + 13 + 1
    assert links(areas)[:2].tolist() == [[105.0, 0.0], [0.0, 0.0]]


def test_path_without_cuts_has_no_area_in_the_gauss_map():
    assert len(monotonous_areas(linearize([("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"Z": 0.0})])).start) == 0
    assert len(monotonous_areas(linearize([])).start) == 0


def test_arcs_of_the_gauss_image_are_divided_by_sense():
    # The direction turns from +X to +Y, back to +X, and then by half a turn, which has no sense.
    counter_clockwise, clockwise = image_arcs([0, np.pi / 2, 0, np.pi], [1.0, 1.2, 1.4, 1.6])
    assert np.isnan(counter_clockwise[-1]).all() and np.isnan(clockwise[-1]).all()
    assert counter_clockwise[0] == pytest.approx([1, 0]) and counter_clockwise[-2] == pytest.approx([0, 1.2])
    assert clockwise[0] == pytest.approx([0, 1.2]) and clockwise[-2] == pytest.approx([1.4, 0])
    # The arc stays between both radii, and its chords are short.
    radius = np.hypot(*counter_clockwise[:-1].T)
    assert (np.diff(radius) > 0).all() and (np.hypot(*np.diff(counter_clockwise[:-1], axis=0).T) < 0.1).all()
    assert np.isnan(turns_of(np.array([0, np.pi]))).all()


def test_constant_gauss_image_has_no_arcs():
    assert [len(arcs) for arcs in image_arcs([1.0, 1.0, 1.0], [1, 1, 1])] == [0, 0]
    assert [len(arcs) for arcs in image_arcs([1.0], [1])] == [0, 0]
    assert [len(arcs) for arcs in image_arcs([], [])] == [0, 0]


@given(st.lists(st.floats(-1e6, 1e6), max_size=400), st.integers(1, 30))
def test_thinned_curve_of_phi_keeps_every_peak(values, count):
    values = np.array(values)
    kept = thinned(values, count)
    assert len(kept) <= max(4 * count, 0) and (np.diff(kept) > 0).all()
    if len(values):
        assert kept[0] == 0 and kept[-1] == len(values) - 1
        for edge in range(count):  # The minimum and the maximum of each of `count` stretches of the values are kept.
            stretch = values[edge * len(values) // count : (edge + 1) * len(values) // count]
            if len(stretch):
                assert {stretch.min(), stretch.max()} <= set(values[kept])


def test_thinned_curve_of_phi_keeps_the_ends_of_every_stretch():
    stretch = np.zeros(100)
    stretch[[20, 70]] = -1.0, 1.0  # The first and the last value of the stretch are not peaks.
    kept = thinned(np.tile(stretch, 10), 10)
    assert kept.tolist() == [start + at for start in range(0, 1000, 100) for at in (0, 20, 70, 99)]


def test_thinned_curve_of_phi_keeps_two_minima_close_together():
    assert {2, 5} <= set(thinned(np.array([0, 0, -1, 0, 0, -2, 0, 0, 0, 0, 0]), 2).tolist())


def test_rows_closer_than_pixels_are_drawn_once():
    rows = np.arange(100_000)
    points = np.column_stack([np.where(rows % 2, 100.0, 0.0), rows * 1e-3])
    points[500] = np.nan
    everything = overlapping(points, np.full(2, -np.inf), np.full(2, np.inf))
    assert not {499, 500} & set(everything.tolist()) and len(everything) == 99_997
    kept = distinct(points, everything, cells=200, most=5000)
    assert len(kept) <= 1000 and (np.diff(kept) > 0).all()
    # For every segment, a segment at most one cell away is drawn.
    cell = 100.0 / 200
    a, b = points[kept], points[kept + 1]
    for i in (1, 777, 50_001, 99_997):
        ends = np.sort(points[i : i + 2], axis=0)
        assert (np.abs(np.sort([a, b], axis=0) - ends[:, None]).max(axis=(0, 2)) <= cell).any()


def test_number_of_drawn_segments_of_long_polylines_is_limited():
    points = np.random.default_rng(0).uniform(size=(3001, 3))
    everything = np.arange(3000)
    assert distinct(points, everything, cells=200, most=3000).tolist() == list(range(3000))
    assert 0 < len(distinct(points, everything, cells=200, most=500)) <= 500


def test_only_points_near_the_window_are_drawn():
    points = np.array([(0, 0), (10, 10), (20, 0), (30, 0), (np.nan, np.nan), (12, -5), (12, 50)])
    assert overlapping(points, np.array([11, 5]), np.array([13, 12])).tolist() == [1, 5]


def test_area_with_the_largest_phi_is_shown_for_nested_loops():
    rows = [("G0", {"Z": 5.0, "X": 0.0, "Y": 60.0}), ("G1", {"Z": 0.0})]
    for row in range(20):
        rows += [("G1", {"X": 500.0 * (row % 2 == 0)}), ("G1", {"Y": 62.0 + 2 * row})]
    toolpath = linearize([*spiral_in(5), ("G0", {"Z": 5.0}), *rows])
    areas = monotonous_areas(toolpath)
    assert len(areas.start) == 2 and areas.area_length[1] > areas.area_length[0]
    last = len(toolpath) - 1
    assert proof(areas, 0, last, around=True) == 0 and proof(areas, 0, last, around=False) == 1
    assert proof(areas, int(areas.index[areas.start[1]]), last, around=True) == 1
    of_each = [areas.signature(i).phi_range for i in range(2)]
    assert areas.phi_ranges.tolist() == [list(pair) for pair in of_each]
    assert areas.phi_range == (min(low for low, _ in of_each), max(high for _, high in of_each))
