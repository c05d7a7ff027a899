# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find gouges that are narrower than a few pixels of an image: gouges by thin tools, and gouges in walls of the model.

Thin gouges are searched for on closely spaced rays, in strips along the moves of thin tools and along the walls of the
model.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from vkworkbench.core.stocks import Solid, spans_in
from vkworkbench.core.view import Frame
from vkworkbench.core.zbuffer.findings.connected import connected_cells, connected_pairs, members
from vkworkbench.core.zbuffer.findings.deviations import TOLERANCE, Deviation
from vkworkbench.core.zbuffer.findings.fine_rays import RAYS_ACROSS, FineRays, half_widths, parts_of
from vkworkbench.core.zbuffer.findings.removed_segments import RemovedSegments, joined
from vkworkbench.core.zbuffer.findings.seen_model import SeenModel
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts, Source
from vkworkbench.core.zbuffer.sweeps.trajectories import passes_over

# Tool diameter, pixels, from which the image shows all gouges of the tool. Thinner tools are checked on closer rays.
_SHOWN = 4.0
# Smallest distance between rays, mm.
_CLOSEST = 2.0**-8
# Distance between rays along walls, mm.
_AT_WALLS = 2.0**-4
# _DIRECTIONS: 24 unit vectors (2, 24); around each point, the model's surface is searched in these directions. _SHARES:
# radii of the circles on which the model's surface is searched to decide whether a point is in a gouge, as shares of
# the smallest depth of a gouge. The circle with the largest radius, which is searched first, excludes most points.
_DIRECTIONS = np.array([np.cos(np.arange(24) * np.pi / 12), np.sin(np.arange(24) * np.pi / 12)])
_SHARES = np.array([1.0, 0.67, 0.34])
# _WIDER: ratio of consecutive radii of the circles on which the model's surface is searched to measure the depth of a
# gouge. _ALIKE: a point replaces the deepest point found so far only if its depth is larger by this factor. _IN_STEPS:
# the points of a gouge, sorted with the deepest along the view first, are measured in batches that end at these numbers
# of points, because the first depths exclude most of the later points.
_WIDER, _ALIKE, _IN_STEPS = 1.1, 1.02, (1, 8, 64)
# Side of the grid cells by which points are grouped, as a multiple of the distance between neighbouring points. Points
# in the same cell or in neighbouring cells belong to one gouge.
_CLOSE = 4.0
# Approximate upper bounds for the number of points at which removed segments are compared with the model. _POINTS:
# number of points in one batch of removed segments. _OF_OWNER: number of points in segments of one batch that one
# trajectory removed.
_POINTS, _OF_OWNER = 20_000, 2000
# Approximate upper bound for the number of points at which the depth of one gouge is measured.
_MEASURED = 200
# Number of points that are processed in one batch when the model's surface is searched around the points.
_TOGETHER = 4096


@dataclass(frozen=True)
class ThinGouges:
    """The gouges of thin tools, and the gouges of other tools in the walls of the model.

    Attributes
    ----------
    found : tuple of Deviation
        All gouges of the thin tools, sorted by their first trajectory.
    in_walls : tuple of Deviation
        The gouges of the other tools near the walls of the model. Some of these gouges are visible in an image, too.
    cuts : tuple of int
        Numbers of the operations with thin tools. The gouges in `found` replace the gouges of these operations that
        were found in an image.
    unchecked : tuple of Source
        Moves of thin tools that were not checked within the time limit.
    walls_checked : bool
        Whether all walls of the model were checked within the time limit.
    """

    found: tuple[Deviation, ...] = ()
    in_walls: tuple[Deviation, ...] = ()
    cuts: tuple[int, ...] = ()
    unchecked: tuple[Source, ...] = ()
    walls_checked: bool = True


def thin_gouges(
    cuts: Iterable[Cut],
    stock: Solid,
    seen: SeenModel,
    *,
    tolerance: float = TOLERANCE,
    seconds: float = np.inf,
    going_on: Callable[[], None] = lambda: None,
) -> ThinGouges:
    """Find the gouges of tools thinner than a few pixels, and the gouges of all other tools along the model's walls.

    Parameters
    ----------
    cuts : iterable of Cut
        The operations in machining order.
    seen : SeenModel
        The model in an image along the tool axis. The image along the tool axis shows the gouges that are not thin.
    tolerance : float
        Tolerance, mm. A depth of at most the tolerance plus `Cut.allowed_depth` is not a gouge.
    seconds : float
        Time limit, s.
    going_on : callable, optional
        Called many times a second. An exception raised by `going_on` ends the search.
    """
    numbered, end, pixel = Cuts(cuts), time.monotonic() + seconds, seen.frame.pixel
    thin = tuple(
        number
        for number, cut in enumerate(numbered.cuts)
        if cut.tool.diameter < _SHOWN * pixel and np.isfinite(cut.allowed_depth)
    )
    found: list[Deviation] = []
    unchecked: list[Source] = []
    for number in thin:
        least = tolerance + numbered.cuts[number].allowed_depth
        moves, half_width = _deep_moves(numbered, number, seen.model, least)
        sizes = 2.0 ** np.floor(np.log2(np.maximum(2 * half_width / RAYS_ACROSS, _CLOSEST)))
        search = None
        for size in np.unique(sizes).tolist():
            own = np.flatnonzero(sizes == size)
            rays = FineRays(numbered, stock, size)
            # `search` collects the points for all distances between rays, because the images with these distances have
            # the same axes and centre.
            search = search or _Search(seen.model, rays.trajectories.frame, least, going_on)
            for part in parts_of(numbered.lengths[moves[own]] / half_width[own]):
                if time.monotonic() > end:
                    unchecked += [numbered.source(int(move)) for move in moves[own[part]]]
                else:
                    for segments in rays.removed_by(moves[own[part]], half_width[own[part]], going_on):
                        search.add(segments)
        if search:
            found += search.gouges(numbered)
    in_walls, complete = _gouges_in_walls(numbered, stock, seen, tolerance, thin, end, going_on)
    return ThinGouges(tuple(sorted(found, key=_first)), tuple(in_walls), thin, tuple(unchecked), complete)


def _first(gouge: Deviation) -> int:
    return gouge.trajectory or 0


def _gouges_in_walls(
    cuts: Cuts,
    stock: Solid,
    seen: SeenModel,
    tolerance: float,
    thin: tuple[int, ...],
    end: float,
    going_on: Callable[[], None],
) -> tuple[list[Deviation], bool]:
    """Return the gouges near the model's walls, and whether all walls were checked before the time `end`.

    If the pixels of the image are nearly as small as the distance between the rays, walls are not checked, because the
    image already shows the gouges.
    """
    others = [number for number, cut in enumerate(cuts.cuts) if number not in thin and np.isfinite(cut.allowed_depth)]
    if seen.frame.pixel < 1.5 * _AT_WALLS or not others:
        return [], True
    rays, complete = FineRays(cuts, stock, _AT_WALLS), True
    searches = {
        number: _Search(seen.model, rays.trajectories.frame, tolerance + cuts.cuts[number].allowed_depth, going_on)
        for number in others
    }
    chosen = np.isin(cuts.cut, others)
    for segments in rays.removed_near(seen.walls(tolerance), seen.frame, chosen, going_on):
        of_cut = cuts.cut[segments.owner]
        for number in np.unique(of_cut).tolist():
            searches[number].add(segments.selected(of_cut == number))
        if time.monotonic() > end:
            complete = False
            break
    return [gouge for search in searches.values() for gouge in search.gouges(cuts)], complete


def _deep_moves(cuts: Cuts, number: int, model: Solid, least: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the moves of an operation that can gouge the model, and half the width of the strip along each move, mm.

    A returned move goes deeper than `least`, mm, below the model's top.
    """
    own = slice(int(cuts.first[number]), int(cuts.first[number + 1]))
    start, end = (ends[own] for ends in cuts.ends)
    tool = cuts.cuts[number].tool
    depth = model.upper[2] - np.minimum(start[:, 2], end[:, 2])
    deep = passes_over(start, end, tool.radius, model) & (depth > least)
    return np.flatnonzero(deep) + own.start, half_widths(tool, depth[deep])


class _Search:
    """Collects the points at which an operation removes material more than `least`, mm, below the model's surface."""

    def __init__(self, model: Solid, frame: Frame, least: float, going_on: Callable[[], None]) -> None:
        self._least, self._model, self._going_on = least, spans_in(model, frame), going_on
        self._found: list[tuple[RemovedSegments, np.ndarray, np.ndarray]] = []

    def add(self, segments: RemovedSegments) -> None:
        """Find the removed segments that are too deep in the model, and store these segments."""
        spans = self._model(segments.x, segments.y)
        inside = (spans.far > spans.near) & (segments.near < spans.far) & (segments.far > spans.near)
        along = np.minimum(segments.far, spans.far) - spans.near
        deep = np.flatnonzero(inside & (along > self._least))
        deep, every = _thinned(deep, segments.owner)
        gouged = self._distances(segments, deep, along[deep], self._least * _SHARES, self._least) > self._least
        if gouged.any():
            chosen = deep[gouged]
            self._found.append((segments.selected(chosen), along[chosen], every[gouged] * segments.frame.pixel**2))

    def gouges(self, cuts: Cuts) -> list[Deviation]:
        """Return the gouges to which the stored points belong.

        Two stored points belong to one gouge if they were made by consecutive trajectories or are close to each other.
        """
        if not self._found:
            return []
        parts, along, area = zip(*self._found)
        segments, along, area = joined(parts), np.concatenate(along), np.concatenate(area)
        order = np.argsort(segments.owner, kind="stable")
        stretch = np.empty(len(order), np.int64)
        stretch[order] = np.cumsum(np.diff(segments.owner[order], prepend=segments.owner[order[0]]) > 1)
        # A stretch is a sequence of consecutive trajectories with stored points. Stretches are one gouge if their
        # points lie in connected cells.
        side = _CLOSE * np.sqrt(area.max())
        cells = connected_cells(*(np.floor(place / side).astype(np.int64) for place in (segments.y, segments.x)))
        stretches = int(stretch.max()) + 1
        gouge = connected_pairs(stretch, stretches + cells, stretches + len(cells))[stretch]
        return [self._gouge(cuts, segments, group, along, float(area[group].sum())) for group in members(gouge)]

    def _gouge(
        self, cuts: Cuts, segments: RemovedSegments, group: np.ndarray, along: np.ndarray, area: float
    ) -> Deviation:
        some = group[:: 1 + len(group) // _MEASURED]
        some = some[np.argsort(-along[some], kind="stable")]
        steps = int(np.ceil(np.log(along[some[0]] / self._least) / np.log(_WIDER))) + 1
        radii, worst, depth = self._least * _WIDER ** np.arange(steps), some[:1], 0.0
        for own in np.split(some, _IN_STEPS):
            floor = _ALIKE * depth
            distances = self._distances(segments, own, along[own], radii, floor)
            if distances.max(initial=0.0) > floor:
                worst, depth = own[[distances.argmax()]], float(distances.max())
        first, last = int(segments.owner[group].min()), int(segments.owner[group].max())
        (place,) = segments.points(worst, segments.far[worst]).tolist()
        return Deviation(first, cuts.source(first), tuple(place), depth, area, cuts.source(last))

    def _distances(
        self, segments: RemovedSegments, some: np.ndarray, along: np.ndarray, radii: np.ndarray, floor: float
    ) -> np.ndarray:
        """Return the distance of each segment's lower end from the space outside the model's surface, (k,) mm.

        The model's surface is searched on circles with the radii `radii`, mm, around each segment. If the exact
        distance is at most `floor`, mm, the returned value is only known to be at most `floor`.
        """
        least, depth = along.copy(), segments.far[some]
        for radius in radii.tolist():
            # A circle whose radius exceeds the distance found so far cannot reduce this distance.
            (searched,) = np.nonzero(least > max(radius, floor))
            for begin in range(0, len(searched), _TOGETHER):
                self._going_on()
                own = searched[begin : begin + _TOGETHER]
                x, y = (
                    np.add.outer(radius * direction, place[some[own]]).ravel()
                    for direction, place in zip(_DIRECTIONS, (segments.x, segments.y))
                )
                spans = self._model(x, y)
                surface = np.where(spans.far > spans.near, spans.near, np.inf).reshape(-1, len(own)).max(axis=0)
                least[own] = np.minimum(least[own], np.hypot(radius, np.maximum(depth[own] - surface, 0.0)))
        return least


def _thinned(deep: np.ndarray, owner: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Select some of the segments `deep` (k,), and return how many segments each selected segment represents.

    Every n-th segment of each trajectory is selected, so that the time for a large gouge is limited.
    """
    every = 1 + len(deep) // _POINTS
    deep = deep[::every]
    _, own, count = np.unique(owner[deep], return_inverse=True, return_counts=True)
    order, rank = np.argsort(own, kind="stable"), np.empty(len(deep), np.int64)
    rank[order] = np.arange(len(deep)) - np.repeat(np.cumsum(count) - count, count)
    of_owner = (1 + count // _OF_OWNER)[own]
    kept = rank % of_owner == 0
    return deep[kept], every * of_owner[kept]
