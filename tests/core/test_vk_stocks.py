# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cylinders and meshes on single rays, compared with values computed by hand."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest

from vkworkbench.core import Cylinder, Mesh, Stock, View
from vkworkbench.core.stocks import _distinct, is_same
from vkworkbench.language import Unusable


def cylinder():
    """Return a cylinder with z from 3 to 11, x from -4 to 6, and y from -3 to 7."""
    return Cylinder((1, 2, 3), 5, 8)


def box(lower, upper):
    """Return the twelve triangles of a box."""
    corner = np.array([[(lower, upper)[bits >> axis & 1][axis] for axis in range(3)] for bits in range(8)], float)
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return np.array([corner[[a, b, c]] for a, b, c, d in faces for a, b, c in ((a, b, c), (a, c, d))])


def test_cylinder_has_its_size_corners_and_planes():
    solid = cylinder()
    assert solid.lower.tolist() == [-4, -3, 3] and solid.upper.tolist() == [6, 7, 11]
    assert repr(solid) == "Cylinder([1.0, 2.0, 3.0], 5, 8)"
    assert (solid.normals @ solid.upper <= solid.offsets).all() and (solid.normals @ solid.lower <= solid.offsets).all()
    assert sorted(solid.offsets.tolist()) == [-3, 3, 4, 6, 7, 11]
    assert np.hypot(*(solid.corners[:, :2] - (1, 2)).T) == pytest.approx(np.full(len(solid.corners), 5))
    angles = np.sort(np.arctan2(*(solid.corners[solid.corners[:, 2] == 3, :2] - (1, 2)).T))
    assert np.diff(angles) == pytest.approx(np.full(len(angles) - 1, 2 * pi / len(angles)))
    assert (solid.corners[:, 2] == 3).sum() == (solid.corners[:, 2] == 11).sum() == len(solid.corners) // 2 >= 32


@pytest.mark.parametrize(
    "origin, direction, near, far",
    [
        ((1, 2, 20), (0, 0, -1), 9, 17),
        ((5, 5, 0), (0, 0, 1), 3, 11),  # The ray lies on the wall.
        ((-10, 2, 5), (1, 0, 0), 6, 16),
        ((-10, 5, 5), (1, 0, 0), 7, 15),  # The ray passes 3 mm beside the axis, and 8 mm of it are inside.
        ((1, 20, 3), (0, -1, 0), 13, 23),  # The ray lies in the lower face.
        ((1, 20, 11), (0, -1, 0), 13, 23),
        ((-5, 2, 9), (0.8, 0, -0.6), 1.25, 10),  # The ray enters through the wall and leaves through the lower face.
        ((-5, 2, 3), (0.8, 0, 0.6), 1.25, 40 / 3),  # The ray enters through the wall and leaves through the upper face.
        # The ray is 0.05 mm inside the wall.
        ((-10, 6.95, 5), (1, 0, 0), 11 - sqrt(25 - 4.95**2), 11 + sqrt(25 - 4.95**2)),
        ((1, 2, 7), (0.6, 0, 0.8), -5, 5),  # The ray passes through the lower and the upper face.
        ((1 - 10, 2 - 10, 7), (sqrt(0.5), sqrt(0.5), 0), 10 * sqrt(2) - 5, 10 * sqrt(2) + 5),
    ],
)
def test_rays_enter_and_leave_a_cylinder_at_known_depths(origin, direction, near, far):
    (one,), (other,) = cylinder().chords(np.array([origin], float), np.array(direction))
    assert (one, other) == pytest.approx((near, far))


@pytest.mark.parametrize(
    "origin, direction",
    [
        ((5.1, 5, 0), (0, 0, 1)), ((1, 7.1, 20), (0, 0, -1)), ((-10, 7.1, 5), (1, 0, 0)), ((-10, 2, 2.9), (1, 0, 0)),
        ((-10, 2, 11.1), (1, 0, 0)), ((-10, 8, 5), (0.8, 0, 0.6)), ((-10, 2, 5), (0.6, 0, 0.8)),
    ],
)  # fmt: skip
def test_rays_beside_a_cylinder_miss_the_cylinder(origin, direction):
    (near,), (far,) = cylinder().chords(np.array([origin], float), np.array(direction))
    assert near >= far


def test_impossible_cylinders_raise_an_error():
    for arguments, code in (
        (((0, 0, 0), 0, 1), "stock-without-volume"), (((0, 0, 0), 1, 0), "stock-without-volume"),
        (((0, 0, 0), -1, 1), "stock-without-volume"), (((0, 0, 0), 1, -1), "stock-without-volume"),
        (((0, 0, np.inf), 1, 1), "stock-not-finite"), (((0, 0, 0), np.inf, 1), "stock-not-finite"),
        (((0, 0, 0), 1, np.nan), "stock-not-finite"), (((0, 0, 0), 1.001e6, 1), "stock-not-finite"),
    ):  # fmt: skip
        with pytest.raises(Unusable) as refused:
            Cylinder(*arguments)
        assert refused.value.what.code == code
    assert Cylinder((0, 0, 0), 0.5, 0.25).upper.tolist() == [0.5, 0.5, 0.25]
    one = box((0, 0, 0), (2, 3, 4))
    one[3, 1, 2] = np.nan
    with pytest.raises(Unusable) as refused:
        Mesh(one)
    assert refused.value.what.code == "stock-not-finite"


# A block of 6 x 6 x 6 mm with a cavity of 2 x 2 x 2 mm in its middle, and a second block above a gap.
HOLLOW = np.concatenate((box((0, 0, 0), (6, 6, 6)), box((2, 2, 2), (4, 4, 4)), box((1, 1, 8), (5, 5, 9))))


def spans(mesh, direction, *rays, pixel=1.0):
    frame = View(direction, 10, 10, pixel=pixel).frame(mesh)
    x, y = np.array(rays, float).T
    return frame, mesh.spans(frame, x, y)


def test_rays_from_above_through_cavities_have_gaps():
    """Seen from above, the image's middle is (3, 3), and depths are measured from z = 4.5."""
    frame, found = spans(Mesh(HOLLOW), (0, 0, -1), (0.1, 0.2), (-2.5, 0), (-1.5, 1.2), (3.1, 0), (0.3, -3.2))
    assert found.near == pytest.approx([-4.5, -1.5, -4.5, 0, 0]) and found.far == pytest.approx([4.5, 4.5, 4.5, 0, 0])
    assert found.gaps.ray.tolist() == [0, 0, 2]
    assert found.gaps.enter == pytest.approx([-3.5, 0.5, -3.5]) and found.gaps.leave == pytest.approx([-1.5, 2.5, -1.5])
    assert frame.centre.tolist() == [3, 3, 4.5]
    _, found = spans(Mesh(HOLLOW), (0, 0, -1), (4, 0), (0.1, 0.2), (4, 1), (-2.5, 0))  # The first ray misses the mesh.
    assert found.near == pytest.approx([0, -4.5, 0, -1.5]) and found.gaps.ray.tolist() == [1, 1]


def test_rays_from_the_side_through_cavities_have_gaps():
    """The view is along y, with x to the right and z upwards.

    Rays pass the cavity, the floor below it, the gap between the blocks, and the space above.
    """
    _, found = spans(Mesh(HOLLOW), (0, 1, 0), (0.5, -1.5), (0.5, -3.5), (0.5, 2.5), (-1.5, 4), (-2.5, 4), (-2.5, 0))
    assert found.near == pytest.approx([-3, -3, 0, -2, 0, -3]) and found.far == pytest.approx([3, 3, 0, 2, 0, 3])
    assert found.gaps.ray.tolist() == [0]
    assert (found.gaps.enter.tolist(), found.gaps.leave.tolist()) == ([-1], [1])


def test_rays_through_slopes_have_known_depths():
    """Depths in a pyramid of 4 x 4 x 2 mm follow from the distance of a ray to the pyramid's axis."""
    ground = np.array([(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0)], float)
    top = np.array([2, 2, 2], float)
    sides = [(ground[k], ground[(k + 1) % 4], top) for k in range(4)]
    pyramid = Mesh(np.array([*sides, ground[[0, 1, 2]], ground[[0, 2, 3]]]))
    _, found = spans(pyramid, (0, 0, -1), (0.5, 0.25), (-1.5, 0.25), (0.25, -1.75), (0.0, 0.0), (2.25, 0))
    assert found.near == pytest.approx([-0.5, 0.5, 0.75, -1, 0]) and found.far == pytest.approx([1, 1, 1, 1, 0])
    _, found = spans(pyramid, (1, 0, 0), (0.1, 0.5), (0.1, -0.5), (0.9, 0.5))
    assert found.far == pytest.approx([0.5, 1.5, 0]) and found.near == pytest.approx([-0.5, -1.5, 0])
    assert len(found.gaps.ray) == 0


def test_spans_of_no_rays_are_empty():
    mesh = Mesh(HOLLOW)
    found = mesh.spans(View().frame(mesh), np.empty(0), np.empty(0))
    assert len(found.near) == len(found.far) == len(found.gaps.ray) == len(found.gaps.enter) == 0


def test_corners_of_a_mesh_within_rounding_are_joined():
    shaken = box((0, 0, 0), (2, 3, 4)) + np.random.default_rng(1).uniform(-2e-7, 2e-7, (12, 3, 3))
    mesh = Mesh(shaken)
    assert len(mesh.corners) == 8 and len(mesh.triangles) == 12
    assert mesh.lower == pytest.approx([0, 0, 0], abs=1e-6) and mesh.upper == pytest.approx([2, 3, 4], abs=1e-6)
    assert sorted(mesh.offsets) == pytest.approx([0, 0, 0, 2, 3, 4], abs=1e-6)
    assert (mesh.normals @ (1, 1, 1) < mesh.offsets + 1e-6).all() and (mesh.normals @ (-1, 4, 5) > mesh.offsets).any()
    inside = mesh.normals @ np.array([[1, 0.1, 0.1], [1, 2.9, 3.9]]).T
    assert (inside < mesh.offsets[:, None]).all()
    assert sorted(Mesh(box((1, 2, 3), (2, 4, 6))).offsets) == pytest.approx([-3, -2, -1, 2, 4, 6])
    apart = box((0, 0, 0), (2, 3, 4))
    apart[0, 0] += 1e-5
    with pytest.raises(Unusable) as refused:
        Mesh(apart)
    assert refused.value.what.code == "solid-not-closed"


@pytest.mark.parametrize("same", [(0, 0, 5), (0, 5, 5), (0, 5, 0)])
def test_triangles_without_area_are_dropped(same):
    """In a triangle without area, two corners are equal."""
    block = box((0, 0, 0), (2, 3, 4)).reshape(-1, 3)
    flat = block[np.array([same])]
    assert len(Mesh(np.concatenate((block.reshape(-1, 3, 3), flat))).triangles) == 12
    with pytest.raises(Unusable) as refused:
        Mesh(flat)
    assert refused.value.what.code == "stock-without-volume"


def test_solids_are_equal_only_if_all_numbers_are_exactly_equal():
    for make in (lambda d: Stock((0, 0, 0), (1, 2, 3 + d)), lambda d: Cylinder((0, 0, 0), 1, 3 + d),
                 lambda d: Mesh(box((0, 0, 0), (1, 2, 3 + d)))):  # fmt: skip
        one = make(0)
        assert is_same(one, one) and is_same(one, make(0)) and not is_same(one, make(1e-15 * 2))
    assert not is_same(Stock((0, 0, 0), (1, 1, 1)), Mesh(box((0, 0, 0), (1, 1, 1))))
    assert not is_same(Mesh(box((0, 0, 0), (1, 1, 1))), Stock((0, 0, 0), (1, 1, 1)))


@pytest.mark.parametrize("count", [0, 1, 500])
def test_distinct_rows_of_an_array_equal_those_of_numpy(count):
    rows = np.random.default_rng(3).integers(-2, 3, (count, 3))
    first, number = _distinct(rows)
    if count == 0:  # The function np.unique of numpy 1.17 fails for an empty array.
        assert first.tolist() == number.tolist() == []
        return
    _, its_first, its_number = np.unique(rows, axis=0, return_index=True, return_inverse=True)
    assert first.tolist() == its_first.tolist() and number.tolist() == its_number.ravel().tolist()
