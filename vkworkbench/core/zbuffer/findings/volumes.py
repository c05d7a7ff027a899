# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the volumes that the operations of a job remove, and the errors of these volumes.

The rays of one image are arranged in rows. If a wall runs between two rows and parallel to them, the volume of the
whole strip between these rows is assigned to one side of the wall. Therefore the volumes are measured in several images
that are rotated against the walls and against each other. The error of the mean volume is computed from the differences
between the images.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from math import pi, sqrt

import numpy as np

from vkworkbench.core.stocks import Solid
from vkworkbench.core.zbuffer.findings.fine_rays import FineRays, half_widths
from vkworkbench.core.zbuffer.findings.removed_segments import RemovedSegments
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts
from vkworkbench.core.zbuffer.sweeps.trajectories import passes_over

# Angles between the rows of rays and the X axis, rad. No angle is close to a multiple of 45 degrees, because many walls
# run at multiples of 45 degrees.
_TURNS = tuple(pi / 180 * angle for angle in (9.0, 33.0, 57.0, 81.0))
# Number of rays in the strips along the moves of one operation, for each image. More rays give a smaller error and a
# longer measurement.
_RAYS = 60_000
# Factor between the standard error of the mean of four images and an upper bound of the error with 95 % confidence
# (Student's t with 3 degrees of freedom).
_STUDENT = 3.18
# Each move is divided into parts whose volumes are measured separately. _PART: largest length of a part, as a multiple
# of the tool's diameter. _PARTS: largest number of parts of a move. With longer parts of moves, short peaks of the
# removal rate are averaged out. With shorter parts of moves, the removal rate would depend on single rays.
_PART, _PARTS = 1.0, 100
# Lower bound of the error, as a share of the volume. The real error of a volume is never 0, because depths are rounded.
_LEAST = 5e-4


@dataclass(frozen=True, eq=False)
class Volumes:
    """Removed volumes of a job, measured in four rotated images.

    Attributes
    ----------
    each : (n,) float64
        Volume that each trajectory removes, mm^3.
    depths : (n,) float64
        Height of the tallest segment that each trajectory removes from a ray, mm.
    images : (4, cuts) float64
        Volume that each operation removes in each image, mm^3.
    parts : (n + 1,) int64
        Number of the first part of each trajectory, and number of all parts. The parts of a trajectory have equal
        lengths.
    of_parts : (parts[-1],) float64
        Volume that the tool removes while the tool moves along each part, mm^3.
    rays : (cuts,) float64
        Largest volume that each operation removes from one ray, mm^3. The largest volume on one ray is a lower bound of
        the error, because four images can agree by chance.
    """

    each: np.ndarray
    depths: np.ndarray
    images: np.ndarray
    parts: np.ndarray
    of_parts: np.ndarray
    rays: np.ndarray

    def error(self, cuts: range) -> float:
        """Return an upper bound (95 % confidence) of the error of the volume that several operations remove, mm^3."""
        together = self.images[:, cuts.start : cuts.stop].sum(axis=1)
        spread = float(together.std(ddof=1)) / sqrt(len(together))
        ray = float(self.rays[cuts.start : cuts.stop].max(initial=0.0))
        return max(_STUDENT * spread, _LEAST * float(together.mean()), ray)


def measure_volumes(
    cuts: Iterable[Cut], stock: Solid, *, seconds: float = np.inf, going_on: Callable[[], None] = lambda: None
) -> Volumes | None:
    """Measure the volumes that a job removes, for tools and stocks of any size.

    Parameters
    ----------
    cuts : iterable of Cut
        The operations in machining order.
    seconds : float
        Time limit, s.
    going_on : callable, optional
        Called many times a second. An exception raised by `going_on` ends the measurement.

    Returns
    -------
    Volumes or None
        The volumes; None if the measurement is not finished within the time limit.
    """
    numbered, end = Cuts(cuts), time.monotonic() + seconds
    each, depths = np.zeros((2, len(numbered)))
    images = np.zeros((len(_TURNS), len(numbered.cuts)))
    largest = np.zeros(len(numbered.cuts))
    parts = _parts(numbered)
    of_parts = np.zeros(parts[-1])
    for number in range(len(numbered.cuts)):
        moves, half_width, pixel = _strips(numbered, number, stock)
        for image, turn in enumerate(_TURNS if len(moves) else ()):
            rays = FineRays(numbered, stock, pixel, turn)
            for segments in rays.removed_by(moves, half_width, going_on):
                if time.monotonic() > end:
                    return None
                volumes = segments.volumes(len(numbered))
                part = _part_of(rays, segments, parts)
                of_parts += np.bincount(part, segments.far - segments.near, len(of_parts)) * pixel**2 / len(_TURNS)
                each += volumes / len(_TURNS)
                deep = segments.far - segments.near
                np.maximum.at(depths, segments.owner, deep)
                largest[number] = max(largest[number], float(deep.max(initial=0.0)) * pixel**2)
                images[image, number] += volumes.sum()
    return Volumes(each, depths, images, parts, of_parts, largest)


def _parts(cuts: Cuts) -> np.ndarray:
    """Return the number of each trajectory's first part, and the number of all parts, (n + 1,) int64."""
    start, end = cuts.ends
    diameter = np.array([cut.tool.diameter for cut in cuts.cuts])[cuts.cut]
    count = np.ceil(np.hypot(*(end - start)[:, :2].T) / (_PART * diameter))
    return np.append(0, np.cumsum(np.clip(count, 1, _PARTS))).astype(np.int64)


def _part_of(rays: FineRays, segments: RemovedSegments, parts: np.ndarray) -> np.ndarray:
    """Return, for each segment of a ray, the part of the move during which the tool's front removes it, (k,) int64."""
    trajectories = rays.trajectories
    item = np.searchsorted(trajectories.index, segments.owner)
    (x, y, _), (ux, uy, run, _) = trajectories.start[:, item], trajectories.heading[:, item]
    along, aside = (segments.x - x) * ux + (segments.y - y) * uy, (segments.y - y) * ux - (segments.x - x) * uy
    along -= np.sqrt(np.maximum(trajectories.radius[item] ** 2 - aside**2, 0.0))
    count = parts[segments.owner + 1] - parts[segments.owner]
    number = np.floor(along / np.where(run > 0, run, 1.0) * count).astype(np.int64)
    return parts[segments.owner] + np.clip(number, 0, count - 1)


def _strips(cuts: Cuts, number: int, stock: Solid) -> tuple[np.ndarray, np.ndarray, float]:
    """Return an operation's moves that can meet the stock, the half widths of their strips, and the rays' distance.

    A strip is the part of the image along a move in which rays are cut. Half widths and distance are in mm.
    """
    own = slice(int(cuts.first[number]), int(cuts.first[number + 1]))
    start, end = (ends[own] for ends in cuts.ends)
    tool = cuts.cuts[number].tool
    depth = stock.upper[2] - np.minimum(start[:, 2], end[:, 2])
    met = passes_over(start, end, tool.radius, stock) & (depth > 0)
    moves, half_width = np.flatnonzero(met), half_widths(tool, depth[met])
    run = np.hypot(*(end - start)[met, :2].T) * _shares_inside(start[met, :2], end[met, :2], half_width[:, None], stock)
    area = float(((run + 2 * half_width) * 2 * half_width).sum())
    block = float(np.prod((stock.upper - stock.lower)[:2]))
    return moves + own.start, half_width, sqrt(max(min(area, block), 1e-6) / _RAYS)


def _shares_inside(start: np.ndarray, end: np.ndarray, margin: np.ndarray, stock: Solid) -> np.ndarray:
    """Return the share of the length of each move, seen from above, that is inside the stock's bounding box, (k,).

    The box is enlarged by a margin (k, 1), mm.
    """
    move = end - start
    moving = np.where(move == 0, 1.0, move)
    to_lower = np.where(move == 0, -np.inf, (stock.lower[:2] - margin - start) / moving)
    to_upper = np.where(move == 0, np.inf, (stock.upper[:2] + margin - start) / moving)
    first, last = np.minimum(to_lower, to_upper).max(axis=1), np.maximum(to_lower, to_upper).min(axis=1)
    return np.maximum(np.minimum(last, 1.0) - np.maximum(first, 0.0), 0.0)
