# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the simulated part as a closed surface of triangles.

Each dexel is a prism whose cross-section is its pixel. The surface consists of the ends of the prisms, and of the walls
between pixels with different depths. Neighbouring faces in one plane are joined into rectangles. If a rectangle has a
corner on the boundary of a second rectangle, a corner is added there to the second rectangle, so that the surface is
closed.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from vkworkbench.core.zbuffer.rays.dexels import THINNEST
from vkworkbench.core.zbuffer.simulator.moments import ZBuffer

# Depths are rounded to multiples of this length, mm. No segment of a ray is shorter than this length. With a smaller
# length, some triangles would have almost no area.
_SAME = THINNEST
# _HEADER: number of bytes in an STL file before the number of triangles. _TRIANGLE: layout of one triangle, with
# normal, corners and an unused number.
_HEADER = 80
_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("unused", "<u2")])


@dataclass(frozen=True, eq=False)
class _Faces:
    """Rectangles that are parallel to two axes of a lattice.

    The lattice has three axes, along which the pixel columns, the pixel rows and the different depths are numbered.

    Attributes
    ----------
    axes : tuple of int
        Number of the axis perpendicular to the rectangles (normal axis), and of the two axes parallel to their sides.
    plane, side : (f,) int64
        Position of each rectangle along the normal axis, and the direction along this axis that points out of the
        solid, 1 or -1.
    u0, u1, v0, v1 : (f,) int64
        Begin and end of each rectangle along the first and along the second of its axes.
    """

    axes: tuple[int, int, int]
    plane: np.ndarray
    side: np.ndarray
    u0: np.ndarray
    u1: np.ndarray
    v0: np.ndarray
    v1: np.ndarray

    def joined(self) -> _Faces:
        """Return larger rectangles: join neighbours along their first axis, and the results along their second axis."""
        u0, u1, v0, v1, plane, side = _joined(self.u0, self.u1, self.v0, self.v1, self.plane, self.side)
        v0, v1, u0, u1, plane, side = _joined(v0, v1, u0, u1, plane, side)
        return _Faces(self.axes, plane, side, u0, u1, v0, v1)

    def corners(self) -> np.ndarray:
        """Return the corners of the rectangles as points of the lattice, (4 f, 3)."""
        normal, u, v = self.axes
        points = np.empty((4, len(self.plane), 3), np.int64)
        points[:, :, normal] = self.plane
        points[:, :, u] = self.u0, self.u1, self.u1, self.u0
        points[:, :, v] = self.v0, self.v0, self.v1, self.v1
        return points.reshape(-1, 3)


def _joined(begin: np.ndarray, end: np.ndarray, *others: np.ndarray) -> tuple[np.ndarray, ...]:
    """Join stretches from `begin` to `end` that follow each other without a gap and have equal values in `others`."""
    order = np.lexsort((begin, *others))
    begin, end, others = begin[order], end[order], tuple(column[order] for column in others)
    new = np.ones(len(begin), bool)
    new[1:] = begin[1:] != end[:-1]
    for column in others:
        new[1:] |= column[1:] != column[:-1]
    first = np.flatnonzero(new)
    last = np.append(first[1:], len(begin))[: len(first)] - 1
    return begin[first], end[last], *(column[first] for column in others)


def part_triangles(zbuffer: ZBuffer) -> np.ndarray:
    """Return the surface of the part at the moment that a z-buffer shows.

    Parameters
    ----------
    zbuffer : ZBuffer
        The simulation of the part. A view along the tool axis gives the best surface, because steps between pixels are
        drawn as walls along the view.

    Returns
    -------
    (t, 3, 3) float64
        Corners of the triangles, mm, counter-clockwise seen from outside. Each edge belongs to an even number of
        triangles. The enclosed volume differs from `zbuffer.part_volume` only because depths are rounded to 1e-4 mm.
    """
    frame, dexels = zbuffer.frame, zbuffer.dexel_records
    ends = np.concatenate((dexels["near"], dexels["far"])).astype(float)
    depths, rank = np.unique(np.rint(ends / _SAME) * _SAME, return_inverse=True)
    near, far = rank.reshape(2, -1).astype(np.int64)
    row, column = np.divmod(dexels["pixel"].astype(np.int64), frame.width)
    size = (frame.width + 1, frame.height + 1, len(depths))
    faces = [_ends(column, row, near, far), *(_walls(column, row, near, far, axis, size) for axis in (0, 1))]
    faces = [one.joined() for one in faces]
    lattice = _Lattice(np.concatenate([one.corners() for one in faces]), size)
    triangles = np.concatenate([lattice.triangles(one) for one in faces])

    def point(at: np.ndarray) -> np.ndarray:
        x, y = (at[..., 0] - frame.width / 2) * frame.pixel, (at[..., 1] - frame.height / 2) * frame.pixel
        low = np.minimum(at[..., 2].astype(np.int64), len(depths) - 1)
        high, share = np.minimum(low + 1, len(depths) - 1), at[..., 2] - low
        depth = depths[low] * (1 - share) + depths[high].astype(float) * share
        return frame.centre + x[..., None] * frame.right + y[..., None] * frame.up + depth[..., None] * frame.direction

    return point(triangles)


def _ends(column: np.ndarray, row: np.ndarray, near: np.ndarray, far: np.ndarray) -> _Faces:
    """Return the faces at the near and far ends of all dexels."""
    side = np.repeat([-1, 1], len(near))
    u, v = np.tile(column, 2), np.tile(row, 2)
    return _Faces((2, 0, 1), np.concatenate((near, far)), side, u, u + 1, v, v + 1)


def _walls(
    column: np.ndarray, row: np.ndarray, near: np.ndarray, far: np.ndarray, axis: int, size: tuple[int, int, int]
) -> _Faces:
    """Return the walls between pixels that are neighbours along an axis of the image (0: in a row, 1: in a column)."""
    at, along = (column, row) if axis == 0 else (row, column)
    ranks, lines = size[2], size[1 - axis]
    # For each edge between two pixels and each depth, the number of dexels in the pixel after the edge is subtracted
    # from the number in the pixel before the edge. A wall is needed at all depths at which the two pixels have
    # different numbers of dexels.
    edge = np.concatenate(((at + 1) * lines + along, at * lines + along))
    count = np.repeat([1, -1], len(near))
    key = np.concatenate((edge * ranks + np.tile(near, 2), edge * ranks + np.tile(far, 2)))
    key, position = np.unique(key, return_inverse=True)
    change = np.bincount(position.ravel(), np.concatenate((count, -count)), len(key)).astype(np.int64)
    key, change = key[change != 0], change[change != 0]
    side = np.cumsum(change)[:-1]
    wall = np.flatnonzero(side)
    edge, begin = np.divmod(key[wall], ranks)
    plane, line = np.divmod(edge, lines)
    return _Faces((axis, 1 - axis, 2), plane, side[wall], line, line + 1, begin, key[wall + 1] % ranks)


class _Lattice:
    """The corners of all rectangles, sorted along each axis of the lattice.

    Parameters
    ----------
    points : (k, 3) int64
    size : tuple of int
        Number of grid lines along columns and rows, and number of different depths.
    """

    def __init__(self, points: np.ndarray, size: tuple[int, int, int]) -> None:
        self._size = size
        self._sorted = [np.unique(self._keys(points, axis)) for axis in range(3)]

    def _keys(self, points: np.ndarray, axis: int) -> np.ndarray:
        """Return an integer for each lattice point (k, 3), by which the points are sorted.

        The integers are consecutive along each line of the lattice that is parallel to the axis `axis`.
        """
        one, other = (own for own in range(3) if own != axis)
        return (points[:, one] * self._size[other] + points[:, other]) * self._size[axis] + points[:, axis]

    def triangles(self, faces: _Faces) -> np.ndarray:
        """Divide rectangles into triangles (t, 3, 3).

        The corners of the triangles are points of the lattice or centres of rectangles.
        """
        corners = faces.corners().reshape(4, -1, 3)
        normal, u, v = faces.axes
        sides = [self._side(corners[k], corners[(k + 1) % 4], (u, v)[k % 2]) for k in range(4)]
        lengths = np.array([np.bincount(face, minlength=len(faces.plane)) for face, _ in sides])
        total = lengths.sum(axis=0)
        first = np.cumsum(total) - total
        before = first + np.cumsum(lengths, axis=0) - lengths
        boundary = np.empty((int(total.sum()), 3))
        owner = np.repeat(np.arange(len(total)), total)
        for (face, points), length, begin in zip(sides, lengths, before):
            number = np.arange(len(face)) - np.repeat(np.cumsum(length) - length, length)
            boundary[begin[face] + number] = points
        following = np.arange(1, len(boundary) + 1)
        following[first + total - 1] = first

        four = total == 4
        a, b, c, d = (boundary[first[four] + k] for k in range(4))
        fan = ~four[owner]
        centres = ((corners[0] + corners[2]) / 2)[owner[fan]]
        found = np.concatenate([
            np.stack((a, b, c), axis=1),
            np.stack((a, c, d), axis=1),
            np.stack((centres, boundary[fan], boundary[following[fan]]), axis=1),
        ])  # fmt: skip
        of_face = np.concatenate((np.flatnonzero(four), np.flatnonzero(four), owner[fan]))
        # The right axis, the up axis and the direction of an image form a left-handed system, so the corners of
        # triangles that face a positive direction are reversed. For walls between rows of pixels (normal axis 1), the
        # two other axes are exchanged, so the corners of triangles that face the negative direction are reversed.
        turned = faces.side[of_face] * (-1 if normal == 1 else 1) > 0
        found[turned] = found[turned][:, ::-1]
        return found

    def _side(self, begin: np.ndarray, end: np.ndarray, axis: int) -> tuple[np.ndarray, np.ndarray]:
        """Return all lattice points on one side of each rectangle, and the rectangle to which each point belongs.

        A side begins at `begin` (f, 3), which is included, and ends at `end` (f, 3), which is not included.
        """
        keys = self._sorted[axis]
        low, high = (np.searchsorted(keys, self._keys(points, axis)) for points in (begin, end))
        count = np.abs(high - low)
        face = np.repeat(np.arange(len(begin)), count)
        number = np.arange(len(face)) - np.repeat(np.cumsum(count) - count, count)
        points = begin[face]
        points[:, axis] = keys[low[face] + np.sign(high - low)[face] * number] % self._size[axis]
        return face, points


def write_stl(path: str | os.PathLike[str], triangles: np.ndarray) -> None:
    """Write triangles (t, 3, 3) to a binary STL file, in mm.

    Raises
    ------
    OSError
        If the file cannot be written.
    """
    records = np.zeros(len(triangles), _TRIANGLE)
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    lengths = np.linalg.norm(normals, axis=1)[:, None]
    records["normal"] = normals / np.where(lengths > 0, lengths, 1)
    records["corners"] = triangles
    with Path(path).open("wb") as file:
        file.write(b"vkworkbench".ljust(_HEADER))
        file.write(np.uint32(len(records)).astype("<u4").tobytes())
        records.tofile(file)
