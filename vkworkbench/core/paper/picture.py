# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the picture of the method is drawn from: areas seen in their plane, and arcs on the Gauss map."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.paper.areas import monotonous_areas, wrap
from vkworkbench.core.paper.signature import EXACT, Signature, signature
from vkworkbench.core.toolpath import Toolpath

_ARC_STEP = np.radians(4)  # an arc is drawn with chords this wide at most
_NO_TURN = 1e-6  # rad; the image stands still


class Areas:
    """The monotonous areas of a toolpath, seen in its plane.

    Attributes
    ----------
    first, end : (a,) int
        The moves of area i are first[i] .. end[i] - 1.
    length : (a,) float
        Length of each area in the plane, mm.
    x, y : (m,) float
        Starts of the moves, mm.
    """

    def __init__(self, toolpath: Toolpath) -> None:
        moves = monotonous_areas(toolpath)
        self.x, self.y = moves.x, moves.y
        self._end_x, self._end_y = moves.x + moves.dx, moves.y + moves.dy
        self.first = moves.start
        self.end = np.append(moves.start[1:], len(moves)) if len(moves) else moves.start
        self.length = np.add.reduceat(moves.length, moves.start) if len(moves) else np.empty(0)

    def __len__(self) -> int:
        """Return the number of areas."""
        return len(self.first)

    @property
    def by_length(self) -> np.ndarray:
        """Indices of the areas, the longest first, (a,)."""
        return np.argsort(-self.length, kind="stable")

    def vertices(self, area: int) -> np.ndarray:
        """Return the polyline of one area, (n+1, 2) mm."""
        first, end = self.first[area], self.end[area]
        last = (self._end_x[end - 1], self._end_y[end - 1])
        return np.vstack([np.column_stack([self.x[first:end], self.y[first:end]]), last])

    def signature(self, area: int) -> Signature:
        """Return the signature of one area: phi starts at 0 in each."""
        return signature(self.vertices(area))

    def outline(self) -> np.ndarray:
        """Return all areas as one polyline, a row of NaN after each, (m + 2a, 2) mm."""
        at = np.concatenate([self.end, self.end])
        x = np.insert(self.x, at, np.concatenate([self._end_x[self.end - 1], np.full(len(self), np.nan)]))
        y = np.insert(self.y, at, np.concatenate([self._end_y[self.end - 1], np.full(len(self), np.nan)]))
        return np.column_stack([x, y])

    def links(self) -> np.ndarray:
        """Return how the tool gets from each area to the next, a row of NaN after each link, (3 (a-1), 2) mm."""
        links = np.full((3 * max(len(self) - 1, 0), 2), np.nan)
        links[0::3] = np.column_stack([self._end_x[self.end[:-1] - 1], self._end_y[self.end[:-1] - 1]])
        links[1::3] = np.column_stack([self.x[self.first[1:]], self.y[self.first[1:]]])
        return links


def turns_of(angle: np.ndarray) -> np.ndarray:
    """Return the turns of an image between successive angles, (n,) -> (n-1,) rad.

    Each goes the shorter way round; half a turn exactly has no sense and is NaN.
    """
    turns = wrap(np.diff(angle))
    turns[np.abs(turns) > np.pi - EXACT] = np.nan
    return turns


def image_arcs(angle: np.ndarray, radius: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Draw how an image moves on the Gauss map, by sense of rotation.

    Parameters
    ----------
    angle : (n,) array_like of float
        Where the image is, rad.
    radius : (n,) array_like of float
        At which distance from the centre to draw it: where it goes to and fro on the same arc of the unit circle,
        different radii keep the arcs apart.

    Returns
    -------
    counter_clockwise, clockwise : (p, 2) and (q, 2) float64
        Points of the arcs, a row of NaN after each arc. Half turns exactly are in neither.
    """
    angle, radius = np.asarray(angle, float), np.asarray(radius, float)
    turns = turns_of(angle)
    return tuple(_arcs(angle, radius, turns, np.flatnonzero(sense * turns > _NO_TURN)) for sense in (1, -1))


def _arcs(angle, radius, turns, chosen) -> np.ndarray:
    counts = np.ceil(np.abs(turns[chosen]) / _ARC_STEP).astype(np.int64) + 2  # points of each, and the gap
    owner = np.repeat(chosen, counts)
    ends = np.cumsum(counts)
    place = np.arange(len(owner)) - np.repeat(ends - counts, counts)
    t = place / np.repeat(counts - 2, counts)
    at = angle[owner] + t * turns[owner]
    r = radius[owner] + t * (radius[owner + 1] - radius[owner])
    points = np.column_stack([r * np.cos(at), r * np.sin(at)])
    points[ends - 1] = np.nan
    return points


def thinned(values: np.ndarray, count: int) -> np.ndarray:
    """Return indices of at most 4 * `count` of the values whose graph looks as that of all of them.

    The values are cut into `count` stretches; of each the first, least, greatest and last are kept.
    """
    n = len(values)
    if n <= 4 * count:
        return np.arange(n)
    edges = np.arange(count + 1) * n // count
    kept = [edges[:-1], edges[1:] - 1]
    # Stretches of one width, the last values repeated: argmin in one go.
    width = int(np.diff(edges).max())
    index = np.minimum(edges[:-1, None] + np.arange(width), edges[1:, None] - 1)
    block = np.asarray(values)[index]
    rows = np.arange(count)
    kept += [index[rows, block.argmin(axis=1)], index[rows, block.argmax(axis=1)]]
    return np.unique(np.concatenate(kept))


def seen(points: np.ndarray, cells: int = 2000) -> np.ndarray:
    """Return indices of the vertices of a polyline that can be told apart on a picture `cells` wide.

    Vertices in the same cell as the one before them are left out; NaN and both ends stay.
    """
    if len(points) < 10 * cells:
        return np.arange(len(points))
    lower, upper = np.nanmin(points, axis=0), np.nanmax(points, axis=0)
    size = max(float((upper - lower).max()), 1e-9)
    cell = np.floor((points - lower) * (cells / size))
    kept = np.ones(len(points), bool)
    kept[1:] = (cell[1:] != cell[:-1]).any(axis=1)  # NaN differs from everything
    kept[-1] = True
    return np.flatnonzero(kept)
