# SPDX-License-Identifier: LGPL-2.1-or-later
"""The places where a simulated part has most too much, or too little, against its model, and what made them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from vkworkbench.core.zbuffer.findings.seen_model import Deviations, SeenModel, around
from vkworkbench.core.zbuffer.findings.surface_distance import farthest
from vkworkbench.core.zbuffer.rays.records import GAP, first_not_below
from vkworkbench.core.zbuffer.rays.surface import STOCK
from vkworkbench.core.zbuffer.simulator.moments import ZBuffer
from vkworkbench.core.zbuffer.sweeps.cuts import Source

# What is no difference to the model, mm, until somebody says otherwise.
TOLERANCE = 0.1

# Of the image's shorter side: worst places closer to each other hang together.
_APART = 0.02


@dataclass(frozen=True)
class Deviation:
    """A place where the part is gouged, or where material is left: the worst one of a cut, or of what hangs together.

    Attributes
    ----------
    trajectory : int or None
        What made the surface where material is left; what removed the material at the model's surface where it is gouged.
        None for the stock's own.
    source : Source or None
        Its cut and command.
    place : (3,) tuple of float
        On the part's surface, mm; at the end of the model where all of the part is gone.
    depth : float
        How deep it is, or how much is left, mm: the distance of the part's surface and the model's, see `surface_distance.farthest`.
    area : float
        Of the image in which the same cut, or what hangs together, exceeds the tolerance along the view, mm^2.
    """

    trajectory: int | None
    source: Source | None
    place: tuple[float, float, float]
    depth: float
    area: float


def gouges(zbuffer: ZBuffer, found: Deviations, tolerance: float) -> list[Deviation]:
    """Return the worst gouge of each cut, the deepest first.

    Parameters
    ----------
    zbuffer : ZBuffer
        What `found` is of.
    found : Deviations
    tolerance : float
        What is no gouge yet, mm.
    """
    return _worst(zbuffer, _gouged(found), tolerance)


def material_left(zbuffer: ZBuffer, found: Deviations, tolerance: float) -> list[Deviation]:
    """Return where each cut leaves most above the model, the most first; the arguments are those of `gouges`."""
    return _worst(zbuffer, _left(found), tolerance)


def worst_places(
    zbuffer: ZBuffer, found: Deviations, tolerance: float, most: int = 10
) -> tuple[list[Deviation], list[Deviation]]:
    """Return the places where most is gouged and those where most is left, the worst first; what hangs together is one.

    Parameters
    ----------
    zbuffer : ZBuffer
        What `found` is of.
    found : Deviations
    tolerance : float
        What is no deviation yet, mm.
    most : int
        How many of either kind are returned at most.
    """
    return _apart(zbuffer, _gouged(found), tolerance, most), _apart(zbuffer, _left(found), tolerance, most)


class _Gap(NamedTuple):
    """Between two surfaces, of which one lies `along` (pixels,) behind the other; the model is that of what is gouged."""

    front: np.ndarray
    behind: np.ndarray
    along: np.ndarray
    model: SeenModel | None


def _gouged(found: Deviations) -> _Gap:
    return _Gap(found.model.surface, found.part, found.gouged, found.model)


def _left(found: Deviations) -> _Gap:
    return _Gap(found.part, found.model.floor, found.left, None)


def _apart(zbuffer: ZBuffer, gap: _Gap, tolerance: float, most: int) -> list[Deviation]:
    """The worst places of what hangs together."""
    frame, (deviating, maker) = zbuffer.frame, _makers(zbuffer, gap, tolerance)
    side = max(1, round(_APART * min(frame.height, frame.width)))
    row, column = np.divmod(deviating, frame.width)
    columns = -(-frame.width // side)
    tile = row // side * columns + column // side
    worst = np.zeros((-(-frame.height // side), columns), np.float32)
    np.maximum.at(worst.ravel(), tile, gap.along[deviating])
    by_tile = np.argsort(tile, kind="stable")
    ends = np.searchsorted(tile[by_tile], np.arange(worst.size + 1))
    places: list[Deviation] = []
    least = tolerance
    # Along the view nothing is nearer than in space.
    while worst.max(initial=0) > least:
        tiles = _take(worst, *divmod(int(worst.argmax()), columns))
        its = np.sort(np.concatenate([by_tile[ends[one] : ends[one + 1]] for one in tiles]))
        places += _place(zbuffer, gap, deviating[its], maker[its], least)
        places = sorted(places, key=_depth)[:most]
        if len(places) == most:
            least = places[-1].depth
    return places


def _take(worst: np.ndarray, row: int, column: int) -> list[int]:
    """Clear all tiles that hang together with one; return their numbers."""
    pending, taken = [(row, column)], []
    worst[row, column] = 0
    while pending:
        row, column = pending.pop()
        taken.append(row * worst.shape[1] + column)
        top, left = max(row - 1, 0), max(column - 1, 0)
        beside = np.argwhere(worst[top : row + 2, left : column + 2] > 0) + (top, left)
        worst[beside[:, 0], beside[:, 1]] = 0
        pending += map(tuple, beside.tolist())
    return taken


def _worst(zbuffer: ZBuffer, gap: _Gap, tolerance: float) -> list[Deviation]:
    """The worst place of each cut."""
    pixels, maker = _makers(zbuffer, gap, tolerance)
    cut = _cuts(zbuffer, maker)
    worst: list[Deviation] = []
    for own in np.unique(cut):
        its = np.flatnonzero(cut == own)
        worst += _place(zbuffer, gap, pixels[its], maker[its], tolerance)
    return sorted(worst, key=_depth)


def _depth(one: Deviation) -> float:
    return -one.depth


def _makers(zbuffer: ZBuffer, gap: _Gap, tolerance: float) -> tuple[np.ndarray, np.ndarray]:
    """Pixels that deviate, ascending, and by which trajectory, `STOCK` where by none.

    Material left is theirs whose surface is seen. Through what was cut away by mistake one sees what others cut rightly: a
    gouge is theirs who removed the material at the model's surface.
    """
    pixels, model = np.flatnonzero(gap.along > tolerance), gap.model
    if model is None:
        return pixels, zbuffer.picture.owner[pixels]
    # Within the tolerance nobody is guilty; farther behind its surface than a pixel the model may be over, at a rim.
    depth = model.near.ravel()[pixels] + min(tolerance, zbuffer.frame.pixel)
    maker = _removers(zbuffer, pixels, depth, model.behind.ravel()[pixels])
    cut = _cuts(zbuffer, maker)

    def said_around(extreme: np.ufunc, nobody: int) -> np.ndarray:
        image = np.full(model.near.shape, nobody)
        image.ravel()[pixels] = cut
        return around(image, extreme).ravel()[pixels]

    # At a rim or a wall a pixel may see past the model: those around it must say the same.
    sure = said_around(np.minimum, len(zbuffer.cuts.cuts)) == said_around(np.maximum, -1)
    return pixels[sure], maker[sure]


def _removers(zbuffer: ZBuffer, pixels: np.ndarray, depth: np.ndarray, behind: np.ndarray) -> np.ndarray:
    """What removed the material at depths (k,) of the rays of pixels (k,), or first behind it; `STOCK` where none did.

    Where there was none before depths (k,) `behind`, the stock lacks it, whatever is cut behind these.
    """
    records = zbuffer.records
    end = records.index[pixels + 1].astype(np.int64)
    piece = first_not_below(records.far, records.index[pixels].astype(np.int64), end, depth)
    found = np.flatnonzero(piece < end)
    piece, end, depth, behind = piece[found], end[found], depth[found], behind[found]
    # In a gap of the stock nothing was; what is missing there begins behind it.
    gap = records.owner[piece] == GAP
    begin = np.where(gap, records.far[piece], np.maximum(depth, records.entry[pixels[found]]))
    lacking = (begin > depth) & (begin >= behind)
    piece = np.minimum(piece + gap, end - 1)
    removers = np.full(len(pixels), STOCK, np.int32)
    removers[found] = np.where(lacking, STOCK, records.owner[piece])
    removers[removers >= zbuffer.step] = STOCK
    return removers


def _cuts(zbuffer: ZBuffer, owner: np.ndarray) -> np.ndarray:
    """Whose the trajectories are; -1 for `STOCK`."""
    cut = np.full(len(owner), -1)
    made = owner != STOCK
    cut[made] = zbuffer.cuts.cut[owner[made]]
    return cut


def _place(zbuffer: ZBuffer, gap: _Gap, pixels: np.ndarray, maker: np.ndarray, tolerance: float) -> list[Deviation]:
    """The worst place of pixels (k,) and what made each, if it exceeds the tolerance."""
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
