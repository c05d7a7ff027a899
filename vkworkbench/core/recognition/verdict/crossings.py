# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scan lines across a toolpath: how its passes lie beside one another, be they closed, open, straight or bent."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from vkworkbench.core.paper import Areas, directions
from vkworkbench.core.recognition.thresholds import ROUNDING, SCAN

NAMES = (
    "step", "keep", "opposite", "monotonous", "alternating", "even", "count", "signed", "tight", "run", "next", "other",
    "cover",
)  # fmt: skip
#: Where the lines lie, from the middle outward, as shares of the width that is crossed.
FROM_THE_MIDDLE = 0.5 + np.array([side * (k + 0.5) / SCAN.LINES for k in range(SCAN.LINES // 2) for side in (-1, 1)])


class Sample(NamedTuple):
    """Moves that stand for all, (k,) each.

    Attributes
    ----------
    chosen : array
        Which moves.
    dx, dy, length : array
        The moves and their lengths, mm.
    double_x, double_y, four_x, four_y : array
        The moves with two times and with four times their angle, mm.
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
        """Return these moves, chosen (k,) int."""
        dx, dy, length = moves.dx[chosen], moves.dy[chosen], moves.length[chosen]
        double_x, double_y = (dx - dy) * (dx + dy) / length, 2 * dx * dy / length
        four_x, four_y = (double_x - double_y) * (double_x + double_y) / length, 2 * double_x * double_y / length
        return cls(chosen, dx, dy, length, double_x, double_y, four_x, four_y)


class Crossings(NamedTuple):
    """Where scan lines cross moves, (k,) each, line after line in the order of cutting.

    Attributes
    ----------
    line : array
        Number of the line, ascending.
    place, z : array
        Place along the line, and height, mm.
    slope : array
        Sine of the angle between move and line, positive to one side of it.
    alpha : array
        Direction of the move, rad.
    """

    line: np.ndarray
    place: np.ndarray
    z: np.ndarray
    slope: np.ndarray
    alpha: np.ndarray


def scan(moves: Areas, sample: Sample, extent: float) -> dict[str, float]:
    """Cross the moves with straight lines and measure what lies between neighbouring crossings.

    The lines run across the direction that the moves prefer. On every line the crossings are put in order, once at each
    depth for itself ("level") and once seen from above ("plan"). Two neighbours that are parallel are passes side by
    side; of those at the usual distance it is told whether they run the same way, and in which order they were cut.
    Turning, mirroring, moving, scaling or reversing a toolpath changes none of it.

    Parameters
    ----------
    moves : Areas
        At least one move.
    sample : Sample
    extent : float
        Diagonal of their bounding box, mm.

    Returns
    -------
    dict
        "crossings": logarithm of how many a line has. And NAMES with "level_" and "plan_" before them, each -1 where
        nothing tells it. "step": logarithm of the usual distance over the extent. "keep", "alternating": share of three
        usual neighbours that all run the same way, and to and fro. "opposite": share of usual neighbours that run to and
        fro. "monotonous": share of three that were cut in their order. "even": share of the passes side by side that
        are at the usual distance. "count": logarithm of how many of these a line has. "signed": how much of the
        crossings goes to one side. "tight": median deviation from the usual distance. "run": usual neighbours with
        another beside them. "next": cut one after the other. "other": neighbours that are not parallel. "cover": share
        of the line between usual neighbours.
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
    """Return the direction, a unit vector, at a right angle to the one that the moves prefer.

    The mean of four times their angle tells that direction but for quarter turns.
    """
    angle = float(directions(sample.four_x.sum(), sample.four_y.sum())) / 4
    u, v = np.cos(angle), np.sin(angle)
    if np.abs(sample.dx * u + sample.dy * v).sum() > np.abs(sample.dy * u - sample.dx * v).sum():
        u, v = -v, u
    return u, v


def _cross(moves: Areas, sample: Sample) -> Crossings:
    """Cross the moves with evenly spaced lines, where most of the cutting is."""
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
    # From the middle, in pairs, so many lines that the crossings are enough, as the sample promises.
    promised = ((one < lines[:, None]) != (other < lines[:, None])).sum(axis=1) * (len(begin) / len(one))
    wanted = max(2, int(np.count_nonzero(np.cumsum(promised)[1::2] <= SCAN.ENOUGH)) * 2)
    found = []
    for line in lines[:wanted]:
        on = np.flatnonzero((begin < line) != (end < line))
        spare = max(0, len(on) - SCAN.ENOUGH // 2)
        found.append(on[spare // 2 : len(on) - (spare + 1) // 2])  # what was cut in the middle of the time
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
    """Measure the neighbours on all lines, those at one depth or all of them."""
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
    # The usual distance is where most distances are, to a fifth.
    logarithm = np.log(aside[beside])
    bins = np.rint(logarithm / SCAN.BIN).astype(np.int64)
    bins -= bins.min()
    count = np.append(np.bincount(bins), 0)
    around = np.concatenate([count[-1:], count, count[:1]])
    most = int(np.argmax(2 * count + around[:-2] + around[2:]))
    usual = float(np.exp(_median(logarithm[np.abs(bins - most) <= 1])))
    even = beside & (np.abs(aside / usual - 1) < SCAN.EVEN)
    number = np.count_nonzero(even)  # some: the usual one lies between them
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
        "tight": _median(np.abs(aside[even] / usual - 1)),
        "run": threes / number,
        "next": np.count_nonzero(np.abs(later[even]) == 1) / number,
        "cover": float(gap[even].sum() / gap[same].sum()),
    })  # fmt: skip
    return told


def _median(values: np.ndarray) -> float:
    """Return the median of (k,) numbers, k > 0; numpy's own takes longer to begin than these take in all."""
    half = len(values) // 2
    if len(values) % 2:
        return float(np.partition(values, half)[half])
    parted = np.partition(values, (half - 1, half))
    return float((parted[half - 1] + parted[half]) / 2)
