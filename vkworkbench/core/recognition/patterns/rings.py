# SPDX-License-Identifier: LGPL-2.1-or-later
"""Relations between the rings of an operation: closed loops and turns of windings."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from vkworkbench.core.paper import TURN
from vkworkbench.core.recognition.patterns.footprints import come_again, count_depths
from vkworkbench.core.recognition.patterns.nesting import Inward, evenness, middle, reach
from vkworkbench.core.recognition.patterns.pieces import WINDING, Pieces
from vkworkbench.core.recognition.patterns.rows import weighted_median
from vkworkbench.core.recognition.thresholds import MAJORITY, NESTS, RINGS, ROUNDING, TROCHOIDS, WATERLINES, WINDINGS


@dataclass(frozen=True)
class Rings:
    """Relations of k rings; arrays are (k,) bool unless stated otherwise.

    Attributes
    ----------
    index : (k,) int
        Piece of each ring.
    length : (k,) float
        mm.
    nested : array
        Another ring of the same depth is an offset: all four sides of the box are shifted inwards, or outwards, and the distance
        is within the reach of the tool.
    opposite : array
        The next nested ring turns the other way.
    deeper : array
        A ring of another shape is above or below.
    repeated : array
        The ring is repeated at another depth.
    stacked : array
        The ring is repeated next, without another pattern between, as in a helix.
    moved : array
        A ring of similar size is shifted and overlaps: trochoids.
    crossing : array
        A ring of another shape touches the same four sides: passes of a lattice from wall to wall.
    alone : array
        The ring has none of these relations.
    winding, round, sloped : array
        A turn of a winding; a circle; a ring with a steady descent or climb.
    back : (k,) float
        Turning that cancels out, rad.
    step : float
        Distance from a ring to the next nested one (median by enclosed area), mm; NaN without nested rings.
    growing : float
        Share of outward steps; NaN without nested rings.
    equidistant : bool
        Whether the level turns of windings, at least three, are evenly spaced.
    distinct, depths : int
        Number of different footprints, and of depths.
    depth_range : float
        From the lowest to the highest ring, mm.
    evenness : float
        Spread of the steps in the plane, divided by the spread in depth. Circles on a dome are even in the plane, its waterlines
        in depth.
    """

    index: np.ndarray
    length: np.ndarray
    nested: np.ndarray
    opposite: np.ndarray
    deeper: np.ndarray
    repeated: np.ndarray
    stacked: np.ndarray
    moved: np.ndarray
    crossing: np.ndarray
    alone: np.ndarray
    winding: np.ndarray
    round: np.ndarray
    sloped: np.ndarray
    back: np.ndarray
    step: float
    growing: float
    equidistant: bool
    distinct: int
    depths: int
    depth_range: float
    evenness: float

    def __len__(self) -> int:
        """Return the number of rings."""
        return len(self.index)


def relate_rings(pieces: Pieces, index: np.ndarray, tool: float) -> Rings:
    """Compare every ring with the next three in the order of cutting: O(k).

    Parameters
    ----------
    pieces : Pieces
    index : (k,) int
        Pieces that are rings.
    tool : float
        Tool diameter, mm; 0 where unknown.
    """
    k = len(index)
    shapes = _shapes(pieces, index)
    inward = Inward(shapes.sides, shapes.enclosed, shapes.length, shapes.slack, shapes.wavy)
    limit, next_step, next_drop = reach(inward, shapes.size, shapes.z, shapes.flat, tool, pieces.area[index])
    names = ("nested", "opposite", "deeper", "repeated", "moved", "crossing")
    flags = {name: np.zeros(k, bool) for name in names}
    next_turn = np.zeros(0)
    all_steps, inner = [], np.full(k, np.inf)  # how far the next ring inside is; the next but one is two steps away
    for lag in range(1, min(NESTS.NEXT, k - 1) + 1):
        a, b = slice(None, -lag), slice(lag, None)
        found = _compare(shapes, inward, limit, lag)
        for name, flag in found.items():
            flags[name][a] |= flag
            flags[name][b] |= flag
        mean, step = inward[lag][2:]
        if lag == 1 and shapes.turn.any():
            next_turn = step[found["nested"] & shapes.turn[a] & shapes.turn[b]]
        all_steps.append(mean[found["nested"]])
        # Both views may be of the same rings: one after the other.
        np.minimum(inner[a], np.where(found["nested"] & (mean > 0), step, np.inf), out=inner[a])
        np.minimum(inner[b], np.where(found["nested"] & (mean < 0), step, np.inf), out=inner[b])
        if flags["nested"].all():
            steps_inside = inner[np.isfinite(inner)]
            if steps_inside.max() < 2 * steps_inside.min():  # no room for another ring between two
                break
    depths = count_depths(shapes.z)
    again, distinct = come_again(pieces, index) if depths > 1 else (np.zeros(k, bool), k)
    flags["stacked"] = flags["repeated"].copy()
    flags["repeated"] |= again
    # Contours of one part come again deeper in the same company; a waterline that is cut again does not.
    if distinct * depths < WATERLINES.DEPTHS * k:
        flags["deeper"] &= ~again
    inside = np.isfinite(inner)
    # Large loops show the stepover. The turns of windings count alike, because their areas are approximate.
    weight = np.where(shapes.slack > 1, shapes.enclosed.mean(), shapes.enclosed)[inside] if k else shapes.enclosed
    related = flags["nested"] | flags["deeper"] | flags["repeated"] | flags["moved"] | flags["crossing"]
    steps: np.ndarray = np.concatenate(all_steps) if all_steps else np.zeros(0)
    return Rings(
        index=index,
        length=shapes.length,
        alone=~related,
        winding=pieces.kind[index] == WINDING,
        round=4 * np.pi * shapes.enclosed > RINGS.ROUND * shapes.length**2,
        sloped=_sloped(pieces, index),
        back=pieces.back[index],
        step=weighted_median(inner[inside], weight) if inside.any() else np.nan,
        growing=np.count_nonzero(steps < 0) / len(steps) if len(steps) else np.nan,
        equidistant=_equal(next_turn),
        distinct=distinct,
        depths=depths,
        depth_range=float(np.ptp(shapes.z)) if k else 0.0,
        evenness=evenness(next_step, next_drop) if depths > 2 else 0.0,
        **flags,
    )


class _Shapes(NamedTuple):
    """The measures by which k rings are compared, (k,) each.

    Sides (4, k) and slack as in :class:`Inward`; size is the longer side; turn marks full level turns of windings, rest marks the
    rest of a winding after its last full turn.
    """

    sides: np.ndarray
    size: np.ndarray
    z: np.ndarray
    flat: np.ndarray
    enclosed: np.ndarray
    length: np.ndarray
    sense: np.ndarray
    wavy: np.ndarray
    slack: np.ndarray
    turn: np.ndarray
    rest: np.ndarray


def _shapes(pieces: Pieces, index: np.ndarray) -> _Shapes:
    sides, winding = pieces.box.T.take(index, axis=1), pieces.kind[index] == WINDING
    size = np.maximum(*(sides[2:] - sides[:2]))
    whole = np.abs(pieces.net[index]) > WINDINGS.LAST_TURN * TURN
    sides[2:] *= -1
    return _Shapes(
        sides=sides,
        size=size,
        z=pieces.z[index],
        flat=pieces.flat[index],
        enclosed=np.abs(pieces.enclosed[index]),
        length=pieces.length[index],
        sense=np.sign(pieces.net[index]),
        wavy=pieces.wavy[index] | (winding & (pieces.back[index] > WINDINGS.WAVY_TURN * TURN)),
        slack=np.where(winding, 2.0, 1.0),
        turn=winding & whole & pieces.flat[index],
        rest=winding & ~whole,
    )


def _compare(r: _Shapes, inward: Inward, limit: float, lag: int) -> dict[str, np.ndarray]:
    """Return the relations of each ring to the ring that is cut `lag` rings later, (k - lag,) bool each."""
    a, b = slice(None, -lag), slice(lag, None)
    low, high, mean, step = inward[lag]
    larger, smaller = np.maximum(r.size[a], r.size[b]), np.minimum(r.size[a], r.size[b])
    same_height = np.abs(r.z[a] - r.z[b]) < ROUNDING.HEIGHT
    # Rings on a sculptured surface have no own depth, so the distance in the plane decides.
    beside = same_height | ~r.flat[a] | ~r.flat[b]
    same_side = np.minimum(
        ROUNDING.RING + ROUNDING.RING_OF_SIZE * larger, max(ROUNDING.RING_OF_REACH * limit, ROUNDING.RING)
    )
    same_box = np.maximum(-low, high) < same_side
    same_area = np.abs(r.enclosed[a] - r.enclosed[b]) < ROUNDING.AREA * np.maximum(r.enclosed[a], r.enclosed[b])
    # At one height, a shift of all four sides by the full step is an offset, even if it is within the rounding allowed for large
    # rings.
    even = (~same_box | (same_height & (step > ROUNDING.RING))) & (step > NESTS.APART) & (step <= limit)
    # All sides of an offset move by the same distance. Passes of a lattice that wind by chance rarely do.
    alike = high - low <= NESTS.EQUAL_SIDES * np.abs(mean) + ROUNDING.PLACE
    even &= ~(r.wavy[a] & r.wavy[b]) | alike
    # Parallel curves differ in length by distance times turn (Steiner), unless bays close between them.
    longer, shorter = np.maximum(r.length[a], r.length[b]), np.minimum(r.length[a], r.length[b])
    parallel = (longer - shorter < NESTS.LONGER * np.abs(mean)) | (shorter > NESTS.LENGTH_ALIKE * longer)
    even &= parallel | (r.slack[a] + r.slack[b] > 2)  # a winding is as long as all its turns
    moved = beside & ~same_box & (low < 0) & (high > 0)
    if moved.any():
        # Trochoids overlap; ribs in a row, and loops around them, do not. A part of a turn has no place.
        centre, width = (r.sides[:2] - r.sides[2:]) / 2, _widths(r.length, r.enclosed, r.slack)
        moved &= np.hypot(*(centre[:, b] - centre[:, a])) < np.minimum(width[a], width[b])
        moved &= (np.abs(mean) < TROCHOIDS.SWAY * (high - low)) & (high - low < TROCHOIDS.STEP * smaller)
        moved &= (smaller > TROCHOIDS.SIZE * larger) & ~(r.rest[a] | r.rest[b])
    found = {
        "nested": even & beside,
        "deeper": ~same_box & ~beside & (low > -smaller),
        "repeated": same_box & same_area & ~same_height,
        "moved": moved,
        "crossing": same_height & same_box & ~same_area,
    }
    if lag == 1:
        # The loops of one pattern keep their shape; a boundary and an island between its offsets do not.
        found["opposite"] = _go_on(even & alike & (r.sense[a] != r.sense[b]), mean)
    return found


def _equal(steps: np.ndarray) -> bool:
    """Return whether the first step and most of the steps (s,), at least two, have the usual length."""
    if len(steps) < 2:
        return False
    equal = np.abs(steps / middle(steps) - 1) < WINDINGS.EQUAL
    return bool(equal[0] and np.count_nonzero(equal) > MAJORITY.SHARE * len(equal))


def _widths(length: np.ndarray, enclosed: np.ndarray, slack: np.ndarray) -> np.ndarray:
    """Return the shorter side of a rectangle with the same area and perimeter, (k,) mm, in any orientation of a ring."""
    result: np.ndarray = slack * (length / 4 - np.sqrt(np.maximum((length / 4) ** 2 - enclosed, 0)))
    return result


def _go_on(turns: np.ndarray, mean: np.ndarray) -> np.ndarray:
    """Return which turns continue to a third ring. An outline and its hole also have opposite senses."""
    onward = turns[1:] & turns[:-1] & (mean[1:] * mean[:-1] > 0)
    result = np.zeros(len(turns), bool)
    result[:-1] |= onward
    result[1:] |= onward
    return result


def _sloped(pieces: Pieces, index: np.ndarray) -> np.ndarray:
    """Return which pieces change their height steadily, with the mean height in the middle of the drop.

    A contour with a ramp over its first moves only does not.
    """
    drop = pieces.drop[index]
    if not drop.any():
        return np.zeros(len(index), bool)
    off_middle = pieces.z[index] - pieces.last_z[index] + drop / 2
    result: np.ndarray = (np.abs(drop) > ROUNDING.HEIGHT) & (np.abs(off_middle) < RINGS.STEADY * np.abs(drop))
    return result
