# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the lines that the panel *Gauss Map* draws: the paths of the areas, and arcs on the unit circle."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.paper.areas import Areas
from vkworkbench.core.paper.directions import turns
from vkworkbench.core.paper.thresholds import TURNS

_ARC_STEP = np.radians(4)  # rad, largest angle of the chords that draw an arc
_NO_TURN = 1e-6  # rad; a smaller turn of the image on the unit circle is rounding and is not drawn


def outline(areas: Areas) -> np.ndarray:
    """Return all monotonous areas as one polyline, with a row of NaN after each area, (m + 2a, 2) mm."""
    at = np.concatenate([areas.end, areas.end])
    ends = _ends(areas)
    gaps = np.full(len(areas.end), np.nan)
    columns = [np.insert(v, at, np.append(end, gaps)) for v, end in zip((areas.x, areas.y), ends)]
    return np.column_stack(columns)


def links(areas: Areas) -> np.ndarray:
    """Return a straight link from each area to the next, with a row of NaN after each link, (3 (a-1), 2) mm."""
    found = np.full((3 * max(len(areas.start) - 1, 0), 2), np.nan)
    end_x, end_y = _ends(areas)
    found[0::3] = np.column_stack([end_x[:-1], end_y[:-1]])
    found[1::3] = np.column_stack([areas.x[areas.start[1:]], areas.y[areas.start[1:]]])
    return found


def _ends(areas: Areas) -> tuple[np.ndarray, np.ndarray]:
    """Return the x and the y coordinates of the end of each area, (a,) mm each."""
    last = areas.end - 1
    return areas.x[last] + areas.dx[last], areas.y[last] + areas.dy[last]


def turns_of(angle: np.ndarray) -> np.ndarray:
    """Return the turns between successive points with the angles `angle` (n,) on the unit circle, (n-1,) rad.

    Each turn is the shorter way around the circle. An exact half turn has no sense of rotation; its value is NaN.
    """
    turned = turns(angle)
    turned[np.abs(turned) > np.pi - TURNS.EXACT] = np.nan
    return turned


def image_arcs(angle: np.ndarray, radius: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the arcs on the unit circle along which a Gaussian image moves, separately for each sense of rotation.

    Parameters
    ----------
    angle : (n,) array_like of float
        Angles of the successive Gaussian images, which are points of the unit circle, rad.
    radius : (n,) array_like of float
        Radius at which each Gaussian image is drawn, as a distance from the centre. If the Gaussian images move back
        and forth on the same arc of the unit circle, different radii separate the drawn arcs.

    Returns
    -------
    counter_clockwise, clockwise : (p, 2) and (q, 2) float64
        Points of the arcs, with a row of NaN after each arc. Exact half turns are left out.
    """
    angle, radius = np.asarray(angle, float), np.asarray(radius, float)
    turned = turns_of(angle)
    to_the_left, to_the_right = np.flatnonzero(turned > _NO_TURN), np.flatnonzero(-turned > _NO_TURN)
    return _arcs(angle, radius, turned, to_the_left), _arcs(angle, radius, turned, to_the_right)


def _arcs(angle: np.ndarray, radius: np.ndarray, turned: np.ndarray, chosen: np.ndarray) -> np.ndarray:
    # Each arc has one point more than chords, and a row of NaN.
    counts = np.ceil(np.abs(turned[chosen]) / _ARC_STEP).astype(np.int64) + 2
    owner = np.repeat(chosen, counts)
    ends = np.cumsum(counts)
    place = np.arange(len(owner)) - np.repeat(ends - counts, counts)
    t = place / np.repeat(counts - 2, counts)
    at = angle[owner] + t * turned[owner]
    r = radius[owner] + t * (radius[owner + 1] - radius[owner])
    points = np.column_stack([r * np.cos(at), r * np.sin(at)])
    points[ends - 1] = np.nan
    return points


def thinned(values: np.ndarray, count: int) -> np.ndarray:
    """Return the indices of at most 4 * `count` values whose graph looks like the graph of all values.

    The values are divided into `count` stretches. The first, the least, the greatest and the last value in each stretch
    are kept.
    """
    n = len(values)
    if n <= 4 * count:
        return np.arange(n)
    edges = np.arange(count + 1) * n // count
    kept = [edges[:-1], edges[1:] - 1]
    # The last index of each stretch is repeated until all stretches are equally long, so that one call of argmin
    # handles all stretches.
    width = int(np.diff(edges).max())
    index = np.minimum(edges[:-1, None] + np.arange(width), edges[1:, None] - 1)
    block = np.asarray(values)[index]
    rows = np.arange(count)
    kept += [index[rows, block.argmin(axis=1)], index[rows, block.argmax(axis=1)]]
    return np.unique(np.concatenate(kept))


def overlapping(points: np.ndarray, lower: np.ndarray, upper: np.ndarray) -> np.ndarray:
    """Return the segments of a polyline whose bounding boxes overlap a window, (m,) int64.

    Segment i joins points i and i + 1.

    Parameters
    ----------
    points : (n+1, 2) float
        Points of the polyline; a row of NaN separates two lines.
    lower, upper : (2,) float
        Corners of the window.
    """
    a, b = points[:-1], points[1:]
    inside = (np.minimum(a, b) <= upper) & (np.maximum(a, b) >= lower)  # the comparison is False if a coordinate is NaN
    return np.flatnonzero(inside.all(axis=1))


def distinct(points: np.ndarray, segments: np.ndarray, *, cells: int, most: int) -> np.ndarray:
    """Leave out each segment of a polyline that a picture would draw at the place of an earlier segment.

    The picture is divided into cells. A segment that joins the same two cells as an earlier segment is left out, so
    that thousands of parallel passes on a few hundred pixels are drawn with at most a few hundred segments.

    Parameters
    ----------
    points : (n+1, 2) or (n+1, 3) float
    segments : (s,) int64
        Segments to choose from; segment i joins points i and i + 1, which are not NaN.
    cells : int
        Width of the picture in cells, at most 1000 in the plane and 200 in space. This width is halved as long as more
        than `most` segments remain.
    most : int
        Largest number of segments to return. If `segments` contains no more than `most` segments, all segments are
        returned.

    Returns
    -------
    (m,) int64
        The kept segments, ascending.
    """
    if len(segments) <= most:
        return segments
    a, b = points[segments], points[segments + 1]
    lower = np.minimum(a.min(axis=0), b.min(axis=0))
    size = max(float((np.maximum(a.max(axis=0), b.max(axis=0)) - lower).max()), 1e-9)
    axes = points.shape[1]
    while True:
        weights = (cells + 1) ** np.arange(axes)
        # A matrix product would be slow on a busy computer, because its threads wait for each other.
        first, second = ((((p - lower) * (cells / size)).astype(np.int64) * weights).sum(axis=1) for p in (a, b))
        pair = np.minimum(first, second) * (cells + 1) ** axes + np.maximum(first, second)  # below 2**63
        kept = np.unique(pair, return_index=True)[1]
        if len(kept) <= most or cells <= 2:
            return segments[np.sort(kept)[:most]]
        cells //= 2


def proof(areas: Areas, first: int, last: int, *, around: bool) -> int:
    """Return the index of the monotonous area that the panel shows as the reason for an operation's strategy.

    Parameters
    ----------
    areas : Areas
        At least one area.
    first, last : int
        First and last trajectory (inclusive) of the part of the operation that follows the strategy.
    around : bool
        Whether the strategy consists of loops. For a strategy of loops, the area with the largest absolute phi is
        returned; among areas with equal phi, the longest. For strategies without loops, the longest area is returned.
    """
    begin = areas.index[areas.start]
    inside = np.flatnonzero((begin >= first) & (begin <= last))
    chosen = inside if len(inside) else np.arange(len(areas.start))
    if around:
        reached = np.abs(areas.phi_ranges[chosen]).max(axis=1)
        chosen = chosen[reached >= reached.max() - TURNS.EXACT]
    return int(chosen[np.argmax(areas.area_length[chosen])])
