# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure how passes of any shape lie side by side, with scan lines across the toolpath."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from vkworkbench.core.paper import Areas, directions
from vkworkbench.core.recognition.patterns.rows import median
from vkworkbench.core.recognition.thresholds import ROUNDING, SCAN

NAMES = (
    "step", "keep", "opposite", "monotonous", "alternating", "even", "count", "signed", "tight", "run", "next", "other",
    "cover",
)  # fmt: skip
#: Positions of the scan lines, from the middle outwards, as shares of the width of the scanned moves.
FROM_THE_MIDDLE = 0.5 + np.array([side * (k + 0.5) / SCAN.LINES for k in range(SCAN.LINES // 2) for side in (-1, 1)])


class Sample(NamedTuple):
    """A sample of the moves, (k,) each.

    Attributes
    ----------
    chosen : array
        Indices of the moves.
    dx, dy, length : array
        Components and lengths of the moves, mm.
    double_x, double_y, four_x, four_y : array
        Components of a move with the same length, but with twice or four times the angle to the x axis, mm.
    """

    chosen: np.ndarray
    dx: np.ndarray
    dy: np.ndarray
    length: np.ndarray
    double_x: np.ndarray
    double_y: np.ndarray
    four_x: np.ndarray
    four_y: np.ndarray

    @classmethod
    def of(cls, moves: Areas, chosen: np.ndarray) -> Sample:
        """Return the sample of the moves with the indices `chosen`, (k,) int."""
        dx, dy, length = moves.dx[chosen], moves.dy[chosen], moves.length[chosen]
        double_x, double_y = (dx - dy) * (dx + dy) / length, 2 * dx * dy / length
        four_x, four_y = (double_x - double_y) * (double_x + double_y) / length, 2 * double_x * double_y / length
        return cls(chosen, dx, dy, length, double_x, double_y, four_x, four_y)


class Crossings(NamedTuple):
    """The k crossings of scan lines with moves, (k,) each, sorted by line and then by the order of cutting.

    Attributes
    ----------
    line : array
        Number of the scan line, ascending.
    place, z : array
        Position along the line, and height, mm.
    slope : array
        Sine of the angle between move and line, signed by the side to which the move crosses.
    alpha : array
        Direction of the move, rad.
    """

    line: np.ndarray
    place: np.ndarray
    z: np.ndarray
    slope: np.ndarray
    alpha: np.ndarray


def measure_crossings(moves: Areas, sample: Sample, extent: float) -> dict[str, float]:
    """Cross the moves with scan lines, and measure the distances, senses and order of neighbouring crossings.

    The scan lines are perpendicular to the preferred direction of the moves. The crossings on each line are sorted by
    position, separately for each depth ("level") and for all depths together ("plan"). Two neighbouring crossings with
    parallel moves are passes side by side. Passes at the usual distance are compared by their sense and by their order
    of cutting. No measure changes if the toolpath is rotated, mirrored, moved, scaled or reversed.

    Parameters
    ----------
    moves : Areas
        At least one move.
    sample : Sample
    extent : float
        Diagonal of the moves' bounding box, mm.

    Returns
    -------
    dict
        "crossings" is the logarithm of the number of crossings per line. Every other name is a prefix ("level_" or
        "plan_") and one of NAMES. A measure is -1 if there are no crossings from which to compute it. A pair is two
        passes side by side at the usual distance. A triple is two pairs of passes with a common pass.

        * step: logarithm of the usual distance divided by the extent
        * even: share of the passes side by side that are pairs
        * tight: median deviation of the pairs from the usual distance, as a share of the usual distance
        * count: logarithm of the number of pairs on a line
        * cover: share of the line that lies between pairs
        * opposite: share of the pairs with opposite senses
        * next: share of the pairs whose passes are consecutive in the order of cutting
        * run: ratio of the number of triples to the number of pairs
        * keep, alternating: share of the triples with one sense, and share with alternating senses
        * monotonous: share of the triples that are cut in the order of their positions
        * signed: excess of crossings to one side, as a share of the crossings
        * other: share of the neighbours that are not parallel
    """
    crossed = _cross(moves, sample)
    number = len(crossed.line)
    level = _neighbours(crossed, extent, by_depth=True)
    one_depth = number == 0 or np.ptp(crossed.z) < SCAN.DEPTH
    plan = level if one_depth else _neighbours(crossed, extent, by_depth=False)
    return {
        "crossings": float(np.log1p(number / (crossed.line[-1] + 1))) if number else 0.0,
        **{f"level_{name}": level.get(name, -1.0) for name in NAMES},
        **{f"plan_{name}": plan.get(name, -1.0) for name in NAMES},
    }


def _across(sample: Sample) -> tuple[float, float]:
    """Return a unit vector that is perpendicular to the preferred direction of the moves.

    The mean of four times the angles gives two candidates for the preferred direction, a quarter turn apart. The
    preferred direction is the candidate to which the moves are more parallel, weighted by length.
    """
    angle = float(directions(sample.four_x.sum(), sample.four_y.sum())) / 4
    u, v = np.cos(angle), np.sin(angle)
    if np.abs(sample.dx * u + sample.dy * v).sum() > np.abs(sample.dy * u - sample.dx * v).sum():
        u, v = -v, u
    return u, v


def _cross(moves: Areas, sample: Sample) -> Crossings:
    """Return the crossings of the moves with evenly spaced lines over the width that holds most of the cutting."""
    u, v = _across(sample)
    begin = moves.y * u
    begin -= moves.x * v
    end = moves.dy * u
    end -= moves.dx * v
    end += begin
    one, other = begin[sample.chosen], end[sample.chosen]
    height = (one + other) / 2
    order = np.argsort(height)
    reached = np.cumsum(sample.length[order])
    low, high = height[order[np.searchsorted(reached, (SCAN.EDGE * reached[-1], (1 - SCAN.EDGE) * reached[-1]))]]
    lines = low + (high - low) * FROM_THE_MIDDLE
    # Use scan lines from the middle outwards, two at a time, until the sample shows that there will be enough
    # crossings.
    promised = ((one < lines[:, None]) != (other < lines[:, None])).sum(axis=1) * (len(begin) / len(one))
    wanted = max(2, int(np.count_nonzero(np.cumsum(promised)[1::2] <= SCAN.ENOUGH)) * 2)
    found = []
    for line in lines[:wanted]:
        on = np.flatnonzero((begin < line) != (end < line))
        spare = max(0, len(on) - SCAN.ENOUGH // 2)
        # If a scan line has too many crossings, keep the crossings in the middle of the cutting order.
        found.append(on[spare // 2 : len(on) - (spare + 1) // 2])
    on, line = np.concatenate(found), np.repeat(np.arange(wanted), [len(moves) for moves in found])
    step, length = end[on] - begin[on], moves.length[on]
    steep = np.abs(step) > SCAN.GRAZING * length
    on, line, slope = on[steep], line[steep], (step / length)[steep]
    part = (lines[line] - begin[on]) / step[steep]
    return Crossings(
        line=line,
        place=(moves.x[on] + part * moves.dx[on]) * u + (moves.y[on] + part * moves.dy[on]) * v,
        z=moves.z[on] - moves.dz[on] * (1 - part),
        slope=slope,
        alpha=moves.alpha[on],
    )


def _neighbours(crossed: Crossings, extent: float, by_depth: bool) -> dict[str, float]:
    """Measure the neighbouring crossings on all lines, separately for each depth or for all depths together."""
    line, place, z, slope, alpha = crossed
    if len(line) < 2:
        return {}
    group = line
    if by_depth:
        depth = np.rint((z - z.min()) / SCAN.DEPTH)
        group = line * (depth.max() + 1) + depth
    order = np.argsort(group * (2 * np.ptp(place) + ROUNDING.PLACE) + place)
    line, group, place, slope, alpha = (values[order] for values in (line, group, place, slope, alpha))
    sides = np.bincount(line, weights=np.sign(slope))
    told = {"signed": float(np.abs(sides).sum() / len(line))}
    gap = place[1:] - place[:-1]
    aside = gap * (np.abs(slope[1:]) + np.abs(slope[:-1])) / 2
    same = group[1:] == group[:-1]
    apart = same & (aside > ROUNDING.PLACE)
    beside = apart & (np.abs(np.sin(alpha[1:] - alpha[:-1])) < SCAN.PARALLEL)
    passes = np.count_nonzero(beside)
    told["other"] = 1 - passes / max(1, int(np.count_nonzero(apart)))
    if not passes:
        return told
    # The usual distance is the median of the distances between passes in the most frequent class and in the two classes
    # beside it.
    logarithm = np.log(aside[beside])
    bins = np.rint(logarithm / SCAN.BIN).astype(np.int64)
    bins -= bins.min()
    count = np.append(np.bincount(bins), 0)
    around = np.concatenate([count[-1:], count, count[:1]])
    most = int(np.argmax(2 * count + around[:-2] + around[2:]))
    usual = float(np.exp(median(logarithm[np.abs(bins - most) <= 1])))
    even = beside & (np.abs(aside / usual - 1) < SCAN.EVEN)
    number = np.count_nonzero(even)  # the count is at least 1, because some distances are close to their median
    opposite = slope[1:] * slope[:-1] < 0
    later = order[1:] - order[:-1]
    three = even[1:] & even[:-1]
    threes = int(np.count_nonzero(three))
    some = max(1, threes)
    told.update({
        "step": float(np.log(usual / extent)),
        "keep": np.count_nonzero(three & ~opposite[1:] & ~opposite[:-1]) / some,
        "alternating": np.count_nonzero(three & opposite[1:] & opposite[:-1]) / some,
        "monotonous": np.count_nonzero(three & (later[1:] * later[:-1] > 0)) / some,
        "opposite": np.count_nonzero(even & opposite) / number,
        "even": number / passes,
        "count": float(np.log1p(number / np.count_nonzero(np.bincount(line)))),
        "tight": median(np.abs(aside[even] / usual - 1)),
        "run": threes / number,
        "next": np.count_nonzero(np.abs(later[even]) == 1) / number,
        "cover": float(gap[even].sum() / gap[same].sum()),
    })  # fmt: skip
    return told
