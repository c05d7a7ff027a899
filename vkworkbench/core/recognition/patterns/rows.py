# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find rows: long parallel passes side by side, whose direction alternates or stays the same."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from vkworkbench.core.paper import Areas, axis_of
from vkworkbench.core.recognition.thresholds import MAJORITY, NEGLIGIBLE, NESTS, ROUNDING, ROWS

_ROUNDING = 1e-9  # rad; an axis that differs from pi by less than this value is set to 0
_EQUAL = 1e-12  # share of the pitch; smaller differences between the distances of rows are rounding errors of float64


@dataclass(frozen=True)
class Rows:
    """A family of parallel passes along one axis.

    Attributes
    ----------
    axis : float
        Direction of the rows, rad in [0, pi).
    length : float
        Length of all passes, mm.
    typical : float
        Median length of the passes, weighted by length, mm.
    count : int
        Number of rows.
    lines : int
        Number of different lines on which the passes lie, counted for up to a thousand passes.
    once : float
        Length of the passes, except those that follow the previous pass's line again, such as at another depth, mm.
    opposite, same : float
        Length of the passes whose neighbouring pass runs in the opposite direction, and in the same direction, mm.
    step : float
        Median distance between consecutive rows, weighted by length, mm.
    pitch : float
        Median distance between neighbouring rows, whatever the order of cutting, mm.
    period : float
        Distance after which the lines repeat, mm. A lattice (rows that bounce off the boundary) has two sets of lines
        in each pocket. In a lattice, lines of one set are one stepover apart, and the distance between the sets is
        arbitrary. The period of a lattice is the stepover. The period of evenly spaced rows is the pitch.
    even : float
        Share of the steps that are close to the usual step.
    steep : bool
        Whether most neighbouring passes differ more in height than in position across the axis, like passes down a
        wall.
    lies : (p, 3) float
        Sample of passes: position across the axis, and beginning and end along the axis, ascending, mm.
    moves : (k,) int
        Indices of the moves of all passes.
    """

    axis: float
    length: float
    once: float
    typical: float
    count: int
    lines: int
    opposite: float
    same: float
    step: float
    pitch: float
    period: float
    even: float
    steep: bool
    lies: np.ndarray
    moves: np.ndarray


def find_rows(moves: Areas, chosen: np.ndarray) -> list[Rows]:
    """Find up to two families of parallel rows among the chosen moves.

    The moves of parallel rows have only two directions, which are opposite to each other. If opposite directions count
    as one, the axis of the rows is the most frequent direction, weighted by length. Grids and crossed rasters have a
    second family of rows.

    Parameters
    ----------
    moves : Areas
    chosen : (k,) int
        Moves to search, ascending.
    """
    found: list[Rows] = []
    total = (moves.length if len(chosen) == len(moves) else moves.length.take(chosen)).sum()
    while len(chosen):
        family = _densest(moves, chosen)
        if family is None:
            break
        found.append(family)
        total -= moves.length.take(family.moves).sum()
        # Stop before a second family of rows if only a few moves are left, which are links.
        if len(found) == 2 or total < NEGLIGIBLE.FAMILY * found[0].length:
            break
        left = np.zeros(len(moves), bool)
        left[chosen] = True
        left[family.moves] = False
        chosen = np.flatnonzero(left)
    if len(found) == 2 and found[1].length < NEGLIGIBLE.FAMILY * found[0].length:
        found.pop()
    return found


def weighted_median(values: np.ndarray, weights: np.ndarray) -> float:
    """Return the weighted median, computed from a regular sample if there are many values.

    Parameters
    ----------
    values, weights : (k,) float
        At least one value.
    """
    every = len(values) // ROWS.SAMPLE + 1
    values, weights = values[::every], weights[::every]
    order = np.argsort(values)
    reached = np.cumsum(weights[order])
    return float(values[order[np.searchsorted(reached, reached[-1] / 2)]])


def median(values: np.ndarray) -> float:
    """Return the median of k > 0 numbers, (k,). np.median is slower, because it spends most of its time on checks."""
    half = len(values) // 2
    if len(values) % 2:
        return float(np.partition(values, half)[half])
    parted = np.partition(values, (half - 1, half))
    return float((parted[half - 1] + parted[half]) / 2)


def dot(a: np.ndarray, b: np.ndarray) -> float:
    """Return the dot product of two arrays (k,) without BLAS, which would start other threads and wait for them."""
    return float(np.einsum("i,i->", a, b))


class Steps(NamedTuple):
    """Relations between k consecutive passes.

    Attributes
    ----------
    shorter : (k-1,) float
        Length of the shorter of two consecutive passes, mm.
    aside, neighbour : (k-1,) bool
        Whether two consecutive passes are on different lines; whether, in addition, their distance is at most about
        `usual`.
    usual : float
        Usual distance between consecutive passes (median weighted by length), mm.
    even : float
        Share of the steps that are close to the usual step.
    line : float
        Largest distance between passes on one line, mm.
    """

    shorter: np.ndarray
    aside: np.ndarray
    neighbour: np.ndarray
    usual: float
    even: float
    line: float


def steps_between(place: np.ndarray, length: np.ndarray) -> Steps | None:
    """Compare consecutive passes, given by their positions across the axis and their lengths, (k,) mm each.

    Return None if all passes are on one line.
    """
    step, shorter = np.diff(place), np.minimum(length[1:], length[:-1])
    lateral = np.abs(step)
    line = ROWS.FINEST if _is_fine(step, lateral) else ROUNDING.PLACE
    aside = lateral > line
    if not aside.any():
        return None
    usual = weighted_median(lateral[aside], shorter[aside])
    neighbour = aside & (lateral <= ROWS.MAX_DISTANCE * usual + ROWS.FINEST)
    even = float(shorter[neighbour & (lateral >= ROWS.MIN_DISTANCE * usual - ROWS.FINEST)].sum() / shorter[aside].sum())
    if line < ROUNDING.PLACE:  # use the mean, because rounding changes only single distances
        usual = float(lateral[neighbour].mean())
    return Steps(shorter, aside, neighbour, usual, even, min(line, usual / 2))


def _is_fine(step: np.ndarray, lateral: np.ndarray) -> bool:
    """Return whether most steps as small as rounding errors go to one side, so that they are fine rows."""
    small = step[(lateral > ROWS.FINEST) & (lateral <= ROUNDING.PLACE)]
    if len(small) < max(ROWS.MANY, MAJORITY.SHARE * np.count_nonzero(lateral > ROWS.FINEST)):
        return False
    return bool(((small[1:] > 0) == (small[:-1] > 0)).mean() > ROWS.EVEN)


def _in_half_turn(axis: float) -> float:
    """Return an axis as an angle in [0, pi), rad."""
    axis %= np.pi
    return 0.0 if np.pi - axis < _ROUNDING else axis


class _Passes(NamedTuple):
    """The p passes along an axis.

    Attributes
    ----------
    first, last : (p,) int
        First and last move of each pass.
    length : (p,) float
        Length of each pass, mm.
    forward : (p,) bool
        Whether the pass runs along the axis, and not against it.
    area : (p,) int
        Monotonous area in which the pass begins.
    place, height : (p,) float
        Position across the axis, and mean height, mm.
    typical : float
        Median length of the passes, weighted by length, mm.
    """

    first: np.ndarray
    last: np.ndarray
    length: np.ndarray
    forward: np.ndarray
    area: np.ndarray
    place: np.ndarray
    height: np.ndarray
    typical: float


def _densest(moves: Areas, chosen: np.ndarray) -> Rows | None:
    """Return the rows along the most frequent direction; None if no move has this direction."""
    axis, along, aligned, length = _main_axis(moves, chosen)
    if not len(aligned):
        return None
    on = chosen.take(aligned)
    passes = _cut_passes(moves, on, (along > 0).take(aligned), length.take(aligned), axis)
    lies = _sampled_lines(moves, passes, axis)
    axis = _in_half_turn(axis)
    total, steps = float(passes.length.sum()), steps_between(passes.place, passes.length)
    if steps is None:
        once = passes.length[0]
        return Rows(axis, total, once, passes.typical, 1, 1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, False, lies, on)
    turned = passes.forward[1:] != passes.forward[:-1]
    # Two passes in the same direction in one area, without a lift, are parts of one stroke and not rows. For example, a
    # contour that was sampled on a grid looks like a staircase.
    onward = steps.neighbour & ~turned & (passes.area[1:] != passes.area[:-1])
    steep = np.abs(np.diff(passes.height)) > np.abs(np.diff(passes.place))
    place = np.sort(passes.place[: ROWS.SAMPLE])
    gaps = np.diff(place[np.append(True, np.diff(place) > steps.line)])
    pitch = median(gaps) if len(gaps) else steps.usual
    return Rows(
        axis=axis,
        length=total,
        once=float(passes.length[0] + passes.length[1:][steps.aside].sum()),
        typical=passes.typical,
        count=1 + int(steps.aside.sum()),
        lines=1 + len(gaps),
        opposite=float(steps.shorter[steps.neighbour & turned].sum()),
        same=float(steps.shorter[onward].sum()),
        step=steps.usual,
        pitch=pitch,
        period=_period(gaps, pitch, steps.line),
        even=steps.even,
        steep=bool(steep[steps.neighbour].mean() > MAJORITY.SHARE),
        lies=lies,
        moves=on,
    )


def _cut_passes(moves: Areas, on: np.ndarray, forward: np.ndarray, length: np.ndarray, axis: float) -> _Passes:
    """Cut aligned moves into passes, without short links along the boundary that happen to be parallel to the axis.

    Parameters
    ----------
    moves : Areas
    on : (k,) int
        Moves that are parallel to the axis, ascending.
    forward, length : (k,) bool and float
        Whether each move runs along the axis, and not against it; length of each move, mm.
    axis : float
        rad.
    """
    several = len(moves.start) > 1
    area = np.searchsorted(moves.start, on, side="right") if several else np.zeros(len(on), np.int64)
    # A pass ends where the next move runs in the opposite direction. A pass continues over links and lifts on its line,
    # so that a row interrupted by islands is one row.
    new = forward[1:] != forward[:-1]
    apart = on[1:] - on[:-1] > 1
    if several:
        apart |= area[1:] > area[:-1]
    apart = np.flatnonzero(apart & ~new)
    new[apart] = _leaves_line(moves, on[apart], on[apart + 1], forward[apart], axis)
    begin = np.flatnonzero(np.concatenate([[True], new]))
    passed = np.add.reduceat(length, begin)
    typical = weighted_median(passed, passed)
    long = passed > NEGLIGIBLE.PASS * typical
    first, last = on[begin[long]], on[np.append(begin[1:], len(on))[long] - 1]
    height = moves.z[first]
    if moves.climbs:
        height = np.add.reduceat(moves.z[on] * length, begin)[long] / passed[long]
    # Use the midpoint of each pass, because links along a slanting boundary can rotate the axis slightly.
    middle_x = (moves.x[first] + moves.x[last] + moves.dx[last]) / 2
    middle_y = (moves.y[first] + moves.y[last] + moves.dy[last]) / 2
    place = middle_y * np.cos(axis) - middle_x * np.sin(axis)
    begin = begin[long]
    return _Passes(first, last, passed[long], forward[begin], area[begin], place, height, typical)


def _leaves_line(moves: Areas, before: np.ndarray, after: np.ndarray, forward: np.ndarray, axis: float) -> np.ndarray:
    """Return whether the moves `after` (k,) lie on other lines than the moves `before` (k,), parallel to an axis."""
    u, v = np.cos(axis), np.sin(axis)
    gap_x = moves.x[after] - moves.x[before] - moves.dx[before]
    gap_y = moves.y[after] - moves.y[before] - moves.dy[before]
    back = (gap_x * u + gap_y * v > 0) != forward
    return np.abs(gap_y * u - gap_x * v) > np.where(back, ROWS.FINEST, ROUNDING.PLACE)


def _sampled_lines(moves: Areas, passes: _Passes, axis: float) -> np.ndarray:
    """Return a sample of the passes, with the columns that `Rows.lies` describes, (p, 3) mm."""
    some = slice(None, None, len(passes.first) // ROWS.CROSSING + 1)
    first, reach = passes.first[some], np.where(passes.forward, passes.length, -passes.length)[some]
    x, y = moves.x[first], moves.y[first]
    end_x, end_y = x + reach * np.cos(axis), y + reach * np.sin(axis)
    u, v = np.cos(_in_half_turn(axis)), np.sin(_in_half_turn(axis))
    return np.column_stack([y * u - x * v, *np.sort([x * u + y * v, end_x * u + end_y * v], axis=0)])


def _period(gaps: np.ndarray, pitch: float, line: float) -> float:
    """Return the distance after which most lines repeat, mm; return the pitch if most lines do not repeat.

    The rows of a lattice (rows that bounce from wall to wall) are two interleaved sets of evenly spaced lines in each
    pocket. In a lattice, the distance between the two sets of lines is arbitrary. Only the distance between the lines
    of one set repeats, and this distance is the period.

    Parameters
    ----------
    gaps : (g,) float
        Distances between neighbouring lines, in order, mm.
    pitch, line : float
        Median distance between neighbouring lines, and largest distance between passes on one line, mm.
    """
    if len(gaps) < 2 or np.ptp(gaps) < _EQUAL * pitch:
        return pitch
    place = np.append(0.0, np.cumsum(gaps))
    lags = range(1, min(ROWS.MAX_PERIOD, len(gaps)) + 1)
    distance = np.concatenate([place[lag:] - place[:-lag] for lag in lags])
    distance = distance[distance < ROWS.FARTHEST * pitch]  # ignore distances between rows in different pockets
    width = max(line, ROWS.SAME_GAP * pitch)
    cell = np.rint(distance / width).astype(np.int64)
    count = np.bincount(cell, minlength=2)
    count[:-1] += count[1:]  # add the next cell, because equal distances can be rounded to two neighbouring cells
    # Count, for each distance, the lines that are at least this distance before the last line, so that another line can
    # be at this distance from them.
    with_room = np.searchsorted(place, place[-1] - width * np.arange(-1, len(count) - 1))
    share = np.where(2 * with_room >= len(place), count / np.maximum(with_room, 1), 0.0)
    # The product of number and share favours frequent distances over distances that occur for few lines, by chance.
    score = count * share
    # Choose the shortest of the frequent distances, because multiples of the period are as frequent as the period.
    nearest = int(np.argmax(score > ROWS.PITCH_FREQUENCY * score.max()))
    if share[nearest] <= MAJORITY.SHARE:
        return pitch
    return median(distance[(cell == nearest) | (cell == nearest + 1)])


def _main_axis(moves: Areas, chosen: np.ndarray) -> tuple[float, np.ndarray, np.ndarray, np.ndarray]:
    """Find the axis to which the chosen moves with the largest total length are parallel.

    Returns
    -------
    axis : float
        rad.
    along : (k,) float
        Distance that each chosen move covers along the axis, mm.
    aligned : (a,) int
        Chosen moves that are parallel to the axis.
    length : (k,) float
        Lengths of the chosen moves, mm.
    """
    dx, dy, length = moves.dx, moves.dy, moves.length
    if len(chosen) < len(moves):
        dx, dy, length = dx[chosen], dy[chosen], length[chosen]
    cos, total = dx / length, float(length.sum())
    axis = axis_of(dot(cos, dx), dot(cos, dy), total)
    along, aligned = _aligned(dx, dy, length, axis)
    kept = length.take(aligned).sum() / total
    if kept < ROWS.ONE_AXIS:
        # If the rows have several axes, the mean direction lies between the axes. Use the most frequent class of
        # directions and the two classes beside it.
        bins = np.rint(moves.alpha[chosen] * (ROWS.DIRECTIONS / np.pi)).astype(np.int64) % ROWS.DIRECTIONS
        weight = np.bincount(bins, weights=length, minlength=ROWS.DIRECTIONS)
        around = np.roll(weight, 1) + np.roll(weight, -1)
        peak = int(np.argmax(weight + 0.5 * around))
        near = (np.arange(ROWS.DIRECTIONS) - peak + 1) % ROWS.DIRECTIONS <= 2
        aligned = np.flatnonzero(near[bins])
    if kept < ROWS.ALL_ALIGNED:
        # Compute the axis again without the links, because links along a slanting boundary rotate the mean direction.
        cos = cos.take(aligned)
        axis = axis_of(dot(cos, dx.take(aligned)), dot(cos, dy.take(aligned)), float(length.take(aligned).sum()))
        along, aligned = _aligned(dx, dy, length, axis)
    return axis, along, aligned, length


def _aligned(dx: np.ndarray, dy: np.ndarray, length: np.ndarray, axis: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the distances that moves cover along an axis, mm, and the indices of the moves parallel to the axis."""
    along = dx * np.cos(axis)
    along += dy * np.sin(axis)
    return along, np.flatnonzero(np.abs(along) >= np.cos(ROWS.ALIGNED) * length)


def filling(families: list[Rows], tool: float, *, length: float, contour: bool) -> list[Rows]:
    """Return the families of rows that cover an area, like the rows in a pocket.

    Parameters
    ----------
    families : list of Rows
        Families from `find_rows`.
    tool : float
        Tool diameter, mm; 0 if unknown.
    length : float
        Length of all searched moves, mm.
    contour : bool
        Whether most of the searched moves are closed loops, which can be contours.
    """
    good = [family for family in families if _fills(family, tool) and not (contour and _walls(family))]
    if good or len(families) < 2 or (tool and max(family.period for family in families) > NESTS.REACH * tool):
        return good
    # The passes of a lattice (rows that bounce from wall to wall) are not cut in the order of their positions, so that
    # consecutive rows are not neighbours. Two families of many long rows nevertheless cover the area if they have
    # nearly the whole length and cross each other. The sides of contours do not cross one another.
    if sum(family.length for family in families) > ROWS.GRID * length and _cross(*families):
        if all(
            family.count >= MAJORITY.REPETITIONS and family.typical > ROWS.MIN_LENGTH * family.pitch
            for family in families
        ):
            return families
    return []


def _cross(one: Rows, other: Rows) -> bool:
    """Return whether most passes of one family cross a pass of the other family between the ends of both passes."""
    turned = other.axis - one.axis
    c, s = np.cos(turned), np.sin(turned)
    # For each pair of passes, one from each family: the positions along both passes at which the passes' lines cross.
    here = (one.lies[:, 0, None] * c - other.lies[:, 0]) / s
    there = (one.lies[:, 0, None] - other.lies[:, 0] * c) / s
    inside = [
        (at > lies[..., 1] + ROWS.END * (lies[..., 2] - lies[..., 1]))
        & (at < lies[..., 2] - ROWS.END * (lies[..., 2] - lies[..., 1]))
        for at, lies in ((here, one.lies[:, None]), (there, other.lies))
    ]
    return bool((inside[0] & inside[1]).any(axis=1).mean() > MAJORITY.SHARE)


def _fills(family: Rows, tool: float) -> bool:
    """Return whether passes are rows: long passes with short steps between neighbours (paper, section 2.1)."""
    # In a comb-shaped area with teeth two rows wide, the rows are short, but there are many rows at even distances.
    longer = ROWS.MIN_LENGTH_IF_MANY if family.lines >= ROWS.MANY and family.even > ROWS.EVEN else ROWS.MIN_LENGTH
    if family.opposite + family.same <= ROWS.WITH_NEIGHBOUR * family.once or family.typical <= longer * family.step:
        return False
    if family.step < max(ROWS.RETRACED * tool, ROUNDING.PLACE) and (family.lines < ROWS.MANY or family.steep):
        return False  # the passes repeat one line, or follow one another down a wall
    reach = NESTS.REACH * tool
    if tool and family.step > reach and (family.period > reach or family.step > ROWS.LEFT_BETWEEN * family.period):
        return False
    regular = family.count > 2 and family.even > MAJORITY.SHARE
    return regular or (family.count == 2 and family.step <= tool)


def _walls(family: Rows) -> bool:
    """Return whether the passes along a closed contour are the sides of a comb-shaped part's teeth, and not rows.

    Teeth and the gaps between teeth have different widths, so that the period of the lines is longer than the distance
    between neighbouring lines.
    """
    return family.period > ROWS.WALLS * family.pitch
