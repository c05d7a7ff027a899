# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find relations between the rings of an operation. Rings are closed loops and the turns of spirals and helices."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from vkworkbench.core.paper import TURN
from vkworkbench.core.recognition.patterns.footprints import come_again, count_depths
from vkworkbench.core.recognition.patterns.nesting import Inward, Shapes, evenness, middle, next_steps, reach
from vkworkbench.core.recognition.patterns.pieces import WINDING, Pieces
from vkworkbench.core.recognition.patterns.rows import weighted_median
from vkworkbench.core.recognition.thresholds import MAJORITY, NESTS, RINGS, ROUNDING, TROCHOIDS, WATERLINES, WINDINGS


@dataclass(frozen=True)
class Rings:
    """Relations of k rings; arrays are (k,) bool unless stated otherwise.

    Attributes
    ----------
    index : (k,) int
        Index of each ring's piece.
    length : (k,) float
        Length of each ring, mm.
    nested : array
        Whether another ring at the same depth is an offset: the sides of its box are all shifted inwards, or all
        outwards, and the distance is within the reach of the tool.
    opposite : array
        Whether the next nested ring has the opposite sense of rotation.
    deeper : array
        Whether a ring of another shape is above or below the ring.
    repeated : array
        Whether the ring is repeated at another depth.
    stacked : array
        Whether the ring is repeated at another depth by one of the three rings before or after it in the order of
        cutting, as in a helix.
    moved : array
        Whether a ring of similar size is shifted and overlaps the ring, as in trochoids.
    crossing : array
        Whether a ring of another shape has the same box, like the passes of a lattice from wall to wall.
    alone : array
        Whether the ring has none of the relations nested, deeper, repeated, moved and crossing.
    winding, round, sloped : array
        Whether the ring is a turn of a winding; whether it is a circle; whether its height changes steadily along the
        ring.
    back : (k,) float
        Turning to the left and to the right that cancels out, rad; 0 for a convex ring.
    step : float
        Median distance from a ring to the next ring inside, weighted by enclosed area, mm; NaN without nested rings.
    growing : float
        Share of the pairs of nested rings whose later ring is outside; NaN without nested rings.
    equidistant : bool
        Whether the horizontal turns of spirals are evenly spaced; False for fewer than three turns.
    distinct, depths : int
        Number of different footprints of the rings, and number of depths.
    depth_range : float
        Height difference between the lowest and the highest ring, mm.
    evenness : float
        Relative spread of the rings' horizontal distances, divided by the relative spread of their vertical distances.
        On a dome, evenly spaced circles have regular horizontal distances, and waterlines have regular vertical
        distances.
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
    """Compare every ring with the next three rings in the order of cutting.

    Parameters
    ----------
    pieces : Pieces
    index : (k,) int
        Indices of the pieces that are rings.
    tool : float
        Tool diameter, mm; 0 if unknown.
    """
    shapes = _shapes(pieces, index)
    inward = Inward(shapes)
    limit = reach(inward, tool, pieces.area[index])
    found = _compare_rings(inward, limit)
    flags, inner, k = found.flags, found.inner, len(index)
    depths = count_depths(shapes.z)
    again, distinct = come_again(pieces, index) if depths > 1 else (np.zeros(k, bool), k)
    flags["stacked"] = flags["repeated"].copy()
    flags["repeated"] |= again
    # If the same few footprints are cut at most depths, the rings are contours of one part and not a waterline.
    if distinct * depths < WATERLINES.DEPTHS * k:
        flags["deeper"] &= ~again
    inside = np.isfinite(inner)
    # In the median distance between rings, weight each distance by the ring's enclosed area, because large loops show
    # the stepover best. For a turn of a winding, use the mean area of all rings, because the turn's own area is
    # approximate.
    weight = np.where(shapes.slack > 1, shapes.enclosed.mean(), shapes.enclosed)[inside] if k else shapes.enclosed
    related = flags["nested"] | flags["deeper"] | flags["repeated"] | flags["moved"] | flags["crossing"]
    return Rings(
        index=index,
        length=shapes.length,
        alone=~related,
        winding=pieces.kind[index] == WINDING,
        round=4 * np.pi * shapes.enclosed > RINGS.ROUND * shapes.length**2,
        sloped=_sloped(pieces, index),
        back=pieces.back[index],
        step=weighted_median(inner[inside], weight) if inside.any() else np.nan,
        growing=np.count_nonzero(found.shifts < 0) / len(found.shifts) if len(found.shifts) else np.nan,
        equidistant=_equal(found.turns),
        distinct=distinct,
        depths=depths,
        depth_range=float(np.ptp(shapes.z)) if k else 0.0,
        evenness=evenness(*next_steps(inward)) if depths > 2 else 0.0,
        **flags,
    )


class _Compared(NamedTuple):
    """The relations of k rings to the rings near them in the order of cutting.

    Attributes
    ----------
    flags : dict of (k,) bool
        The relations by their names in `Rings`.
    inner : (k,) float
        Distance to the next ring inside, mm; infinite if no ring is inside.
    shifts : (s,) float
        Mean shift of the box's sides from each ring to a nested ring that is cut later, mm.
    turns : (t,) float
        Distances between consecutive full horizontal turns of a winding, mm.
    """

    flags: dict[str, np.ndarray]
    inner: np.ndarray
    shifts: np.ndarray
    turns: np.ndarray


def _compare_rings(inward: Inward, limit: float) -> _Compared:
    """Compare every ring with the next three rings; `limit` is the largest distance of nested rings, mm."""
    shapes, k = inward.shapes, len(inward.shapes.z)
    flags = {name: np.zeros(k, bool) for name in ("opposite", *RELATIONS)}
    turns, shifts, inner = np.zeros(0), [np.zeros(0)], np.full(k, np.inf)
    for lag in range(1, min(NESTS.NEXT, k - 1) + 1):
        pairs = Pairs(inward, limit, lag)
        one, two = slice(None, -lag), slice(lag, None)
        relations = RELATIONS if lag > 1 else {**RELATIONS, "opposite": _is_opposite}
        for name, relation in relations.items():
            found = relation(pairs)
            flags[name][one] |= found
            flags[name][two] |= found
        nested, mean, step = pairs.nested, pairs.shift.mean, pairs.shift.step
        if lag == 1 and shapes.turn.any():
            turns = step[nested & shapes.turn[one] & shapes.turn[two]]
        shifts.append(mean[nested])
        # Keep each ring's smallest distance, because the distance to the ring after next is twice the stepover. Update
        # the two slices of `inner` one after the other, because the slices overlap.
        np.minimum(inner[one], np.where(nested & (mean > 0), step, np.inf), out=inner[one])
        np.minimum(inner[two], np.where(nested & (mean < 0), step, np.inf), out=inner[two])
        if flags["nested"].all():
            steps = inner[np.isfinite(inner)]
            if steps.max() < 2 * steps.min():  # the distances are so even that no ring is missing between two rings
                break
    return _Compared(flags, inner, np.concatenate(shifts), turns)


def _shapes(pieces: Pieces, index: np.ndarray) -> Shapes:
    sides, winding = pieces.box.T.take(index, axis=1), pieces.kind[index] == WINDING
    size = np.maximum(*(sides[2:] - sides[:2]))
    whole = np.abs(pieces.net[index]) > WINDINGS.LAST_TURN * TURN
    sides[2:] *= -1
    return Shapes(
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


class Pairs:
    """The p = k - lag pairs of a ring and the ring that is cut `lag` rings later.

    Parameters
    ----------
    inward : Inward
    limit : float
        Largest distance of rings in one nest, mm.
    lag : int
    """

    def __init__(self, inward: Inward, limit: float, lag: int) -> None:
        self.shapes, self.limit, self.lag = inward.shapes, limit, lag
        self.shift = inward[lag]

    def both(self, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the values (k,) of the first ring and of the second ring in each pair."""
        return values[: -self.lag], values[self.lag :]

    @cached_property
    def smaller(self) -> np.ndarray:
        """Size of the smaller ring, (p,) mm."""
        return np.minimum(*self.both(self.shapes.size))

    @cached_property
    def larger(self) -> np.ndarray:
        """Size of the larger ring, (p,) mm."""
        return np.maximum(*self.both(self.shapes.size))

    @cached_property
    def level(self) -> np.ndarray:
        """Whether both rings have the same mean height, (p,) bool."""
        one, two = self.both(self.shapes.z)
        return np.abs(one - two) < ROUNDING.HEIGHT

    @cached_property
    def beside(self) -> np.ndarray:
        """Whether both rings have the same depth, or at least one of them is not horizontal, (p,) bool."""
        one, two = self.both(self.shapes.flat)
        return self.level | ~one | ~two

    @cached_property
    def same_box(self) -> np.ndarray:
        """Whether both rings have equal bounding boxes, up to rounding, (p,) bool."""
        rounding = ROUNDING.RING + ROUNDING.RING_OF_SIZE * self.larger
        return np.maximum(-self.shift.low, self.shift.high) < np.minimum(
            rounding, max(ROUNDING.RING_OF_REACH * self.limit, ROUNDING.RING)
        )

    @cached_property
    def same_area(self) -> np.ndarray:
        """Whether the rings enclose the same area, (p,) bool."""
        one, two = self.both(self.shapes.enclosed)
        return np.abs(one - two) < ROUNDING.AREA * np.maximum(one, two)

    @cached_property
    def alike(self) -> np.ndarray:
        """Whether all four sides of the second ring's box are shifted by one distance, (p,) bool.

        In a lattice (rows that bounce from wall to wall), two rings are rarely shifted by one distance.
        """
        low, high, mean, _ = self.shift
        return high - low <= NESTS.EQUAL_SIDES * np.abs(mean) + ROUNDING.PLACE

    @cached_property
    def offset(self) -> np.ndarray:
        """Whether one ring is an offset of the other within the reach of the tool, at any depth, (p,) bool."""
        step, shapes = self.shift.step, self.shapes
        # At one height, a ring is an offset if all four sides of its box are shifted by the full distance, even if the
        # distance is smaller than the tolerance for large rings.
        apart = ~self.same_box | (self.level & (step > ROUNDING.RING))
        wavy, other_wavy = self.both(shapes.wavy)
        # The lengths of parallel curves differ by the distance times the turn (Steiner's formula), unless a bay of the
        # outer curve is closed in the offset.
        one, two = self.both(shapes.length)
        longer, shorter = np.maximum(one, two), np.minimum(one, two)
        parallel = (longer - shorter < NESTS.LONGER * np.abs(self.shift.mean)) | (shorter > NESTS.LENGTH_ALIKE * longer)
        slack, other_slack = self.both(shapes.slack)
        parallel |= slack + other_slack > 2  # do not compare the lengths of a winding's turns, which are open
        near = (step > NESTS.APART) & (step <= self.limit)
        return apart & near & parallel & (self.alike | ~(wavy & other_wavy))

    @cached_property
    def nested(self) -> np.ndarray:
        """Whether one ring is an offset of the other at the same depth, (p,) bool."""
        return self.offset & self.beside


def _is_opposite(pairs: Pairs) -> np.ndarray:
    """Return whether the next ring is an offset cut in the opposite sense, in a series of at least three such rings.

    An offset needs a series of three rings, because two rings can be an outline and its hole, which also have opposite
    senses. The opposite rings of one pattern have the same shape. A boundary and an island between its offsets have
    different shapes.
    """
    one, two = pairs.both(pairs.shapes.sense)
    turns, mean = pairs.offset & pairs.alike & (one != two), pairs.shift.mean
    onward = turns[1:] & turns[:-1] & (mean[1:] * mean[:-1] > 0)
    result = np.zeros(len(turns), bool)
    result[:-1] |= onward
    result[1:] |= onward
    return result


def _is_moved(pairs: Pairs) -> np.ndarray:
    """Return whether a ring of similar size is shifted and overlaps, as in trochoids.

    Ribs side by side, and the loops around the ribs, do not overlap, and are not trochoids. The rest of a winding after
    its last full turn is ignored, because the box of an incomplete turn does not show its position.
    """
    (low, high, mean, _), shapes = pairs.shift, pairs.shapes
    moved: np.ndarray = pairs.beside & ~pairs.same_box & (low < 0) & (high > 0)
    if moved.any():
        (x, other_x), (y, other_y) = map(pairs.both, (shapes.sides[:2] - shapes.sides[2:]) / 2)
        width = _widths(shapes.length, shapes.enclosed, shapes.slack)
        moved &= np.hypot(other_x - x, other_y - y) < np.minimum(*pairs.both(width))
        moved &= (np.abs(mean) < TROCHOIDS.SWAY * (high - low)) & (high - low < TROCHOIDS.STEP * pairs.smaller)
        moved &= (pairs.smaller > TROCHOIDS.SIZE * pairs.larger) & ~np.logical_or(*pairs.both(shapes.rest))
    return moved


#: Relations between the two rings of a pair, with the names of the attributes of `Rings`. Each function takes a `Pairs`
#: object and returns a bool array (p,), one value for each pair of rings.
RELATIONS: dict[str, Callable[[Pairs], np.ndarray]] = {
    "nested": lambda pairs: pairs.nested,
    "deeper": lambda pairs: ~pairs.same_box & ~pairs.beside & (pairs.shift.low > -pairs.smaller),
    "repeated": lambda pairs: pairs.same_box & pairs.same_area & ~pairs.level,
    "moved": _is_moved,
    "crossing": lambda pairs: pairs.level & pairs.same_box & ~pairs.same_area,
}


def _equal(steps: np.ndarray) -> bool:
    """Return whether the first distance between turns, and most of the distances (s,), equal the median.

    Return False for fewer than two distances.
    """
    if len(steps) < 2:
        return False
    equal = np.abs(steps / middle(steps) - 1) < WINDINGS.EQUAL
    return bool(equal[0] and np.count_nonzero(equal) > MAJORITY.SHARE * len(equal))


def _widths(length: np.ndarray, enclosed: np.ndarray, slack: np.ndarray) -> np.ndarray:
    """Return the shorter side of the rectangle with each ring's area and perimeter, (k,) mm, for any orientation."""
    return slack * (length / 4 - np.sqrt(np.maximum((length / 4) ** 2 - enclosed, 0)))


def _sloped(pieces: Pieces, index: np.ndarray) -> np.ndarray:
    """Return which pieces change their height steadily, so that their mean height is halfway between their ends.

    A contour with a ramp in only its first moves does not change its height steadily.
    """
    drop = pieces.drop[index]
    if not drop.any():
        return np.zeros(len(index), bool)
    off_middle = pieces.z[index] - pieces.last_z[index] + drop / 2
    return (np.abs(drop) > ROUNDING.HEIGHT) & (np.abs(off_middle) < RINGS.STEADY * np.abs(drop))
