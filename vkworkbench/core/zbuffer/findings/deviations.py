# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the deepest gouges and the thickest leftover material of a part, and the trajectories that caused them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from vkworkbench.core.view import Frame
from vkworkbench.core.zbuffer.findings.connected import connected_cells, members
from vkworkbench.core.zbuffer.findings.seen_model import Deviations, SeenModel, around
from vkworkbench.core.zbuffer.findings.surface_distance import farthest
from vkworkbench.core.zbuffer.rays.records import GAP, first_not_below
from vkworkbench.core.zbuffer.rays.surface import STOCK
from vkworkbench.core.zbuffer.simulator.moments import ZBuffer
from vkworkbench.core.zbuffer.sweeps.cuts import Source
from vkworkbench.language import Message

# Default tolerance for deviations from the model, mm.
TOLERANCE = 0.1

# Pixels that deviate from the model are grouped by square tiles; pixels in the same tile or in neighbouring tiles
# belong to one place. `_APART` is the side of a square tile, as a share of the image's shorter side.
_APART = 0.02
# Number of tiles along the image's longer side, for grouping the pixels of a gouge. With fewer tiles, separate gouges
# close to each other are reported as one gouge. With more tiles, one gouge whose pixels have gaps is reported as
# several gouges.
_TILES = 500


@dataclass(frozen=True)
class Deviation:
    """A gouge or leftover material in one operation or one group of connected pixels, described by its worst place.

    Attributes
    ----------
    trajectory : int or None
        For leftover material, the trajectory that cut the part's surface at `place`. For a gouge by an operation, the
        first trajectory that removed material at the model's surface. The trajectory is None if the part's surface at
        `place` belongs to the uncut stock.
    source : Source or None
        Operation and command of the trajectory.
    place : (3,) tuple of float
        Point of the part's surface at which the depth is largest, mm. If no material is left on the ray, `place` is on
        the model's far side.
    depth : float
        Largest distance between the part's and the model's surface, mm; see `surface_distance.farthest`.
    area : float
        Area of the image in which the deviation along the view exceeds the tolerance, mm^2.
    last : Source or None
        For a gouge by an operation, the last command that removed material at the model's surface; otherwise None.
    """

    trajectory: int | None
    source: Source | None
    place: tuple[float, float, float]
    depth: float
    area: float
    last: Source | None = None

    @property
    def gouge_message(self) -> Message:
        """A message that describes a gouge, or the place where the stock is too small for the model."""
        if self.source is None:
            return Message("stock-lacks", depth=self.depth)
        return Message("cuts-model", depth=self.depth)


def gouges(zbuffer: ZBuffer, found: Deviations, tolerance: float) -> list[Deviation]:
    """Return every gouge, the deepest gouge first.

    A gouge is a group of connected pixels in which one operation goes deeper into the model than the tolerance plus the
    operation's allowed depth. All places at which the stock is too small for the model are returned as one deviation
    without a source.

    Parameters
    ----------
    found : Deviations
        Deviations of this `zbuffer`.
    tolerance : float
        Tolerance, mm. A depth of at most the tolerance plus `Cut.allowed_depth` is not a gouge.

    Returns
    -------
    list of Deviation
    """
    gap = _gouge_gap(found)
    pixels, maker = _find_makers(zbuffer, gap, tolerance)
    cut = _cuts_of(zbuffer, maker)
    deepest: list[Deviation] = []
    for own in np.unique(cut):
        group = np.flatnonzero(cut == own)
        if own < 0:
            deepest += _worst_place(zbuffer, gap, pixels[group], maker[group], tolerance)
            continue
        least = tolerance + zbuffer.cuts.cuts[own].allowed_depth
        group = group[gap.along[pixels[group]] > least]
        for one in _connected(zbuffer.frame, pixels[group], max(zbuffer.frame.height, zbuffer.frame.width) / _TILES):
            deepest += _gouge(zbuffer, gap, pixels[group[one]], maker[group[one]], least)
    return sorted(deepest, key=_negative_depth)


def _gouge(zbuffer: ZBuffer, gap: _Gap, pixels: np.ndarray, maker: np.ndarray, least: float) -> list[Deviation]:
    """Return the gouge in the connected pixels `pixels` (k,), or an empty list if its depth is at most `least`, mm."""
    source, first, last = zbuffer.cuts.source, int(maker.min()), int(maker.max())
    worst = _worst_place(zbuffer, gap, pixels, maker, least)
    return [replace(one, trajectory=first, source=source(first), last=source(last)) for one in worst]


def _connected(frame: Frame, pixels: np.ndarray, side: float) -> list[np.ndarray]:
    """Group the pixels by connected tiles; return, for each group, the positions of its pixels in `pixels`.

    `pixels` (k,) contains the indices row * width + column. `side` is the side of a tile, in pixels.
    """
    row, column = np.array(np.divmod(pixels, frame.width)) // max(1, round(side))
    return members(connected_cells(row, column))


def material_left(zbuffer: ZBuffer, found: Deviations, tolerance: float) -> list[Deviation]:
    """Return the thickest leftover material of each operation, the thickest first.

    The arguments are the same as for `gouges`.
    """
    gap = _leftover_gap(found)
    pixels, maker = _find_makers(zbuffer, gap, tolerance)
    cut = _cuts_of(zbuffer, maker)
    worst: list[Deviation] = []
    for own in np.unique(cut):
        group = np.flatnonzero(cut == own)
        worst += _worst_place(zbuffer, gap, pixels[group], maker[group], tolerance)
    return sorted(worst, key=_negative_depth)


def worst_places(
    zbuffer: ZBuffer, found: Deviations, tolerance: float, most: int = 10
) -> tuple[list[Deviation], list[Deviation]]:
    """Return the places with the deepest gouges and with the thickest leftover material, the worst place first.

    Parameters
    ----------
    found : Deviations
        Deviations of this `zbuffer`.
    tolerance : float
        Tolerance, mm. Gouges and leftover material up to the tolerance are ignored.
    most : int
        Largest number of gouges, and largest number of places with leftover material. Connected pixels are one place.

    Returns
    -------
    gouged, left : list of Deviation
    """
    gouged, left = _gouge_gap(found), _leftover_gap(found)
    return _worst_by_group(zbuffer, gouged, tolerance, most), _worst_by_group(zbuffer, left, tolerance, most)


class _Gap(NamedTuple):
    """The gap between a front surface and a rear surface of an image.

    `along` (pixels,) is the distance from the front surface `front` to the rear surface `behind` along the view, mm, at
    least 0. `model` is None if the deviation is leftover material.
    """

    front: np.ndarray
    behind: np.ndarray
    along: np.ndarray
    model: SeenModel | None


def _gouge_gap(found: Deviations) -> _Gap:
    return _Gap(found.model.surface, found.part, found.gouged, found.model)


def _leftover_gap(found: Deviations) -> _Gap:
    return _Gap(found.part, found.model.floor, found.left, None)


def _worst_by_group(zbuffer: ZBuffer, gap: _Gap, tolerance: float, most: int) -> list[Deviation]:
    """Return the worst place of each group of connected tiles, sorted with the worst place first."""
    frame, (deviating, maker) = zbuffer.frame, _find_makers(zbuffer, gap, tolerance)
    groups = _connected(frame, deviating, _APART * min(frame.height, frame.width))
    worst = [float(gap.along[deviating[group]].max()) for group in groups]
    places: list[Deviation] = []
    least = tolerance
    for number in sorted(range(len(groups)), key=lambda number: -worst[number]):
        # The groups of tiles are examined in the order of their largest distance along the view, the largest first. The
        # depth of a place is its distance in space, which is at most its distance along the view, so the remaining
        # groups cannot contain a worse place.
        if worst[number] <= least:
            break
        places += _worst_place(zbuffer, gap, deviating[groups[number]], maker[groups[number]], least)
        places = sorted(places, key=_negative_depth)[:most]
        if len(places) == most:
            least = places[-1].depth
    return places


def _negative_depth(deviation: Deviation) -> float:
    return -deviation.depth


def _find_makers(zbuffer: ZBuffer, gap: _Gap, tolerance: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the deviating pixels, ascending, and the trajectory that caused each deviation.

    The trajectory is `STOCK` if no trajectory caused the deviation.

    Leftover material is attributed to the trajectory that cut the visible surface. A gouge is attributed to the
    trajectory that removed the material at the model's surface, because the visible surface, which is deeper, can have
    been cut by another trajectory.
    """
    pixels, model = np.flatnonzero(gap.along > tolerance), gap.model
    if model is None:
        return pixels, zbuffer.picture.owner[pixels]
    # The removing trajectory is searched for slightly below the model's surface. The additional depth is the tolerance,
    # because removals within the tolerance are allowed. The additional depth is at most a pixel, because near an edge
    # the model can be thin along the ray.
    depth = model.near.ravel()[pixels] + min(tolerance, zbuffer.frame.pixel)
    maker = _find_removers(zbuffer, pixels, depth, model.behind.ravel()[pixels])
    cut = _cuts_of(zbuffer, maker)

    def extreme_cut_around(extreme: np.ufunc, neutral: int) -> np.ndarray:
        image = np.full(model.near.shape, neutral)
        image.ravel()[pixels] = cut
        return around(image, extreme).ravel()[pixels]

    # At an edge or a wall of the model, a pixel's ray can miss the model, so that the gouge would be attributed to a
    # wrong operation (cut). Therefore a pixel is used only if the gouges of all its deviating neighbours are attributed
    # to the same operation.
    sure = extreme_cut_around(np.minimum, len(zbuffer.cuts.cuts)) == extreme_cut_around(np.maximum, -1)
    return pixels[sure], maker[sure]


def _find_removers(zbuffer: ZBuffer, pixels: np.ndarray, depth: np.ndarray, behind: np.ndarray) -> np.ndarray:
    """Return the trajectory that removed the first material at or below `depth` (k,) on each pixel's ray.

    The result is `STOCK` if no trajectory removed material there, or if the stock has no material between `depth` and
    `behind` (k,).
    """
    records = zbuffer.records
    end = records.index[pixels + 1].astype(np.int64)
    segment = first_not_below(records.far, records.index[pixels].astype(np.int64), end, depth)
    found = np.flatnonzero(segment < end)
    segment, end, depth, behind = segment[found], end[found], depth[found], behind[found]
    # A gap in the stock contains no material; the next material begins at the far end of the gap.
    gap = records.owner[segment] == GAP
    begin = np.where(gap, records.far[segment], np.maximum(depth, records.entry[pixels[found]]))
    lacking = (begin > depth) & (begin >= behind)
    segment = np.minimum(segment + gap, end - 1)
    removers = np.full(len(pixels), STOCK, np.int32)
    removers[found] = np.where(lacking, STOCK, records.owner[segment])
    removers[removers >= zbuffer.step] = STOCK
    return removers


def _cuts_of(zbuffer: ZBuffer, owner: np.ndarray) -> np.ndarray:
    """Return the number of each trajectory's operation (cut); -1 for `STOCK`."""
    cut = np.full(len(owner), -1)
    made = owner != STOCK
    cut[made] = zbuffer.cuts.cut[owner[made]]
    return cut


def _worst_place(
    zbuffer: ZBuffer, gap: _Gap, pixels: np.ndarray, maker: np.ndarray, tolerance: float
) -> list[Deviation]:
    """Return the worst place among the pixels `pixels` (k,), or an empty list if it is within the tolerance.

    `maker` (k,) is the trajectory that caused the deviation at each pixel.
    """
    frame = zbuffer.frame
    found = farthest(gap.front, gap.behind, pixels, frame.pixel, tolerance)
    if found is None:
        return []
    pixel, depth = found
    row, column = np.divmod([pixel], frame.width)
    part = gap.front if gap.model is None else gap.behind
    (place,) = frame.points(column, row, part.ravel()[[pixel]].astype(float)).tolist()
    own = int(maker[np.searchsorted(pixels, pixel)])
    trajectory = None if own == STOCK else own
    source = None if trajectory is None else zbuffer.cuts.source(trajectory)
    return [Deviation(trajectory, source, tuple(place), depth, len(pixels) * frame.pixel**2)]
