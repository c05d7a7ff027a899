# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare the measured volumes of jobs with exact volumes.

    python3 benchmarks/zbuffer_volumes.py [JOBS [SEED]]     # 40 jobs by default

Each job has two operations with tools of 0.1 to 20 mm in a sheet or a block of 20 to 600 mm. The operations cut rows,
contours, slots, ramps, holes or circles, with flat, conical or ball-shaped ends, and some of them move beyond the edges
of the stock. The exact volume is the integral, over the height, of the area that all tools have cut at this height. At
each height, a straight move cuts all points within a radius of a segment. To compute the area of the union of these
figures, lengths are integrated over parallel lines. On each line, the union is a union of intervals. The computation of
the exact volume shares no code with the simulator. For operations and for whole jobs, the script prints the share of
volumes within the stated error. The script also prints the largest and the mean deviation, and the largest stated
error, in percent of the exact volume.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT)]

from vkworkbench.core import Cut, Stock, Tool, Toolpath
from vkworkbench.core.zbuffer import measure_volumes

JOBS, SEED = 40, 47
# Number of points at which an integrand is evaluated in each interval. An integral over lines (area) or heights
# (volume) is divided at breaks into intervals, which are integrated separately.
NODES = 6
# Number of equal parts into which a range of heights is divided. Cut figures can grow with the height, and can begin to
# touch each other at any height, so each range of heights is divided.
PARTS = 5
# Minimum number of intervals of integration per radius of a figure, and the number of intervals per radius that is
# divided among all figures.
# With enough breaks, the crossings of a figure with other figures and with the edges of the stock lie in short
# intervals.
BREAKS, BREAKS_TOGETHER = 4, 200


def main(jobs: int = JOBS, seed: int = SEED) -> None:
    check_exact_volume()
    rng, found = np.random.default_rng(seed), []
    for number in range(jobs):
        sheet = number % 2 == 0
        cuts, stock = random_job(rng, sheet)
        measured = measure_volumes(cuts, stock)
        before = 0.0
        for k in range(len(cuts)):
            after = exact_volume(cuts[: k + 1], stock)
            row = after - before, measured.images[:, k].mean(), measured.error(range(k, k + 1))
            # If the second operation cuts only where the first has cut, there is no volume to compare.
            if row[0] > 1e-6 * after:
                found.append(("operations", sheet, *row))
            before = after
        found.append(("jobs", sheet, before, measured.each.sum(), measured.error(range(len(cuts)))))
    print(
        f"{'':22}{'number':>7}{'within the error':>18}{'deviation, largest':>20}{'mean':>8}{'error, largest':>16}   %"
    )
    for name in ("operations", "jobs"):
        for sheets in (True, False):
            exact, told, error = np.array([row[2:] for row in found if row[:2] == (name, sheets)]).T
            off = told / exact - 1
            print(
                f"{name + (', sheets' if sheets else ', blocks'):22}{len(off):7}{100 * np.mean(np.abs(told - exact) <= error):18.0f}"
                f"{100 * np.abs(off).max():20.2f}{100 * off.mean():8.3f}{100 * (error / exact).max():16.2f}"
            )
    told = np.array([abs(row[3] - row[2]) <= row[4] for row in found])
    print(f"\n{told.sum()} of {len(told)} volumes are within their error: {100 * told.mean():.0f} %")


def random_job(rng, sheet):
    """Return two random cuts and their stock."""
    size = np.exp(rng.uniform(np.log(20), np.log(600), 3))
    size[2] = rng.uniform(1, 5) if sheet else rng.uniform(10, 50)
    cuts = []
    for _ in range(2):
        diameter = np.exp(rng.uniform(np.log(0.1), np.log(min(20, size[:2].min() / 4))))
        kind = ("rows", "contour", "slots", "ramps", "holes", "circles")[rng.integers(6)]
        shape = "endmill" if kind == "ramps" else ("endmill", "endmill", "vbit", "ballend")[rng.integers(4)]
        tool = (
            Tool(shape, diameter, tip_angle=np.pi / 2, tip_diameter=diameter / 5)
            if shape == "vbit"
            else Tool(shape, diameter)
        )
        depth = min(rng.uniform(0.2, 1.5) * diameter, 0.9 * size[2])
        cuts.append(Cut(moves(rng, kind, size, diameter, depth), tool))
    return cuts, Stock((0, 0, 0), size)


def moves(rng, kind, size, diameter, depth) -> Toolpath:
    """Return the moves of an operation: some polylines, each of which the tool approaches from above."""
    top, z, pieces = size[2], size[2] - depth, []
    middle = rng.uniform(0.2, 0.8, 2) * size[:2]
    turn = rng.choice([0.0, np.pi / 2, rng.uniform(0, np.pi)])
    along, across = np.array([np.cos(turn), np.sin(turn)]), np.array([-np.sin(turn), np.cos(turn)])
    length = rng.uniform(1, 30) * diameter
    if kind == "rows":
        step = rng.uniform(0.3, 1.1) * diameter
        rows = range(int(rng.integers(3, 15)))
        ends = [
            middle + k * step * across + side * length / 2 * along
            for k in rows
            for side in ((-1, 1) if k % 2 else (1, -1))
        ]
        pieces = [[(*point, z) for point in ends]]
    elif kind == "contour":
        corners = [
            middle + a * length * along + b * length / 2 * across for a, b in ((0, 0), (1, 0), (1, 1), (0, 1), (0, 0))
        ]
        pieces = [[(*point, top - share * depth) for point in corners] for share in (0.5, 1.0)]
    elif kind in ("slots", "ramps"):
        for _ in range(int(rng.integers(1, 8))):
            start = rng.uniform(-0.05, 1.05, 2) * size[:2]
            low = top - rng.uniform(0, 1) * depth if kind == "ramps" else z
            pieces.append([(*start, low), (*(start + length * along), z)])
            along = np.array([along[1], -along[0]]) if rng.random() < 0.3 else along
    elif kind == "holes":
        pieces = [[(*(rng.random(2) * size[:2]), z)] for _ in range(int(rng.integers(1, 10)))]
    else:
        angle = np.linspace(0, 2 * np.pi, 41)
        pieces = [[(*(middle + length / 4 * np.array([np.cos(a), np.sin(a)])), z) for a in angle]]
    points = [point for piece in pieces for point in ((*piece[0][:2], top + 5), *piece, (*piece[-1][:2], top + 5))]
    points = [points[0], *(point for before, point in zip(points, points[1:]) if point != before)]
    path = Toolpath.through(np.array(points, float))
    return replace(path, rapid=np.minimum(path.points[:-1, 2], path.points[1:, 2]) > top)


def exact_volume(cuts, stock) -> float:
    """Return the volume that cuts remove from a box that begins at (0, 0, 0), mm^3."""
    segments = [
        (cut.tool, start, end)
        for cut in cuts
        for start, end in zip(cut.toolpath.points, cut.toolpath.points[1:])
        if min(start[2], end[2]) < stock.upper[2]
    ]
    breaks = {0.0, float(stock.upper[2])}
    for tool, start, end in segments:
        breaks |= {float(start[2]), float(end[2]), float(min(start[2], end[2]) + height_of_tip(tool))}
    breaks = [z for z in sorted(breaks) if 0 <= z <= stock.upper[2]]
    volume = 0.0
    for low, high in zip(breaks, breaks[1:]):
        active = [one for one in segments if min(one[1][2], one[2][2]) < high]
        if high - low < 1e-9 or not active:
            continue
        slopes = any(start[2] != end[2] and (start[:2] != end[:2]).any() for _, start, end in active)
        tips = any(tool.shape != "endmill" for tool, _, _ in active)
        if not slopes and not tips:
            volume += (high - low) * area_of(figures(active, (low + high) / 2), *stock.upper[:2])
            continue
        parts = np.linspace(low, high, 1 + PARTS)
        for z, weight in zip(*nodes(parts[:-1], parts[1:], NODES)):
            volume += float(weight) * area_of(figures(active, float(z)), *stock.upper[:2])
    return volume


def height_of_tip(tool) -> float:
    """Return the height above the tip at which a tool reaches its full radius, mm."""
    return {"vbit": (tool.diameter - tool.tip_diameter) / 2, "ballend": tool.diameter / 2}.get(tool.shape, 0.0)


def radius_at(tool, height) -> float:
    """Return the radius of a tool at a height above its tip, mm."""
    if height >= height_of_tip(tool):
        return tool.diameter / 2
    if tool.shape == "vbit":  # 90 degrees
        return tool.tip_diameter / 2 + height
    return float(np.sqrt(height * (tool.diameter - height)))


def figures(segments, z) -> np.ndarray:
    """Return the figures that moves cut at a height, (k, 5): both ends (x, y) of a segment, and a radius around it."""
    found = []
    for tool, start, end in segments:
        low, high = (start, end) if start[2] <= end[2] else (end, start)
        if low[2] >= z:
            continue
        # The tool is treated as infinitely long, so only the part of a move below the height z cuts here. In this
        # benchmark, only tools with flat ends have sloping moves.
        share = min(1.0, (z - low[2]) / (high[2] - low[2])) if high[2] > low[2] else 1.0
        if tool.shape != "endmill" and high[2] > low[2]:
            share = 0.0  # a vertical move cuts the same area as its lower end
        until = low + share * (high - low)
        found.append((*low[:2], *until[:2], radius_at(tool, z - low[2])))
    return np.unique(np.array(found).reshape(-1, 5), axis=0)


def area_of(found, width, height) -> float:
    """Return the area of a union of figures within a rectangle that begins at (0, 0), mm^2."""
    if len(found) == 0:
        return 0.0
    ax, ay, bx, by, radius = found.T
    length = np.hypot(bx - ax, by - ay)
    ux, uy = np.where(length > 0, (bx - ax, by - ay), ((1.0,), (0.0,))) / np.where(length > 0, length, 1.0)
    each = max(BREAKS, BREAKS_TOGETHER // len(found))
    breaks = [np.array([0.0, height]), ay - radius, ay + radius, by - radius, by + radius]
    for low, high, r in zip(np.minimum(ay, by) - radius, np.maximum(ay, by) + radius, radius):
        breaks.append(np.linspace(low, high, 2 + int(each * (high - low) / r)))
    breaks = np.unique(np.clip(np.concatenate(breaks), 0, height))
    lines, weights = nodes(breaks[:-1], breaks[1:], NODES)
    total, some = 0.0, 1 + 1_000_000 // len(found)
    for first in range(0, len(lines), some):
        y, weight = lines[first : first + some, None], weights[first : first + some]
        begin, end = np.full((2, len(y), len(found)), np.nan)
        for cx, cy in ((ax, ay), (bx, by)):
            half = np.sqrt(np.where(np.abs(y - cy) <= radius, radius**2 - (y - cy) ** 2, np.nan))
            begin, end = np.fmin(begin, cx - half), np.fmax(end, cx + half)
        # The rectangle between the discs at both ends of the segment: from 0 to the length along the segment, and up to
        # the radius perpendicular to the segment.
        nearer, farther = slab(ux, (y - ay) * uy, 0.0, length)
        left, right = slab(-uy, (y - ay) * ux, -radius, radius)
        left, right = ax + np.maximum(left, nearer), ax + np.minimum(right, farther)
        met = left < right
        begin, end = np.fmin(begin, np.where(met, left, np.nan)), np.fmax(end, np.where(met, right, np.nan))
        begin, end = (np.clip(np.where(np.isnan(x), 0, x), 0, width) for x in (begin, end))
        order = np.argsort(begin, axis=1)
        begin, end = np.take_along_axis(begin, order, 1), np.take_along_axis(end, order, 1)
        covered = np.maximum.accumulate(end, axis=1)
        begin[:, 1:] = np.maximum(begin[:, 1:], covered[:, :-1])
        total += float(weight @ np.maximum(end - begin, 0).sum(axis=1))
    return total


def slab(slope, offset, low, high):
    """Return the first and last x with ``low <= slope * x + offset <= high``; the first is greater if there is no x."""
    level = np.abs(slope) < 1e-12
    safe = np.where(level, 1.0, slope)
    one, other = (low - offset) / safe, (high - offset) / safe
    inside = (offset >= low) & (offset <= high)
    first = np.where(level, np.where(inside, -np.inf, np.inf), np.minimum(one, other))
    return first, np.where(level, np.where(inside, np.inf, -np.inf), np.maximum(one, other))


def nodes(low, high, count):
    """Return nodes and weights for integration (Gauss quadrature) from `low` to `high` (k,).

    The integrands can have vertical tangents at both ends.
    """
    t, weight = np.polynomial.legendre.leggauss(count)
    half = (high - low)[:, None] / 2
    points = low[:, None] + half + half * np.sin(np.pi / 2 * t)  # Gauss quadrature after the substitution by a sine
    return points.ravel(), (weight * half * np.pi / 2 * np.cos(np.pi / 2 * t)).ravel()


def check_exact_volume() -> None:
    """Print the error of the exact volume for a slot with a ball end, and for two crossing slots with a flat end."""
    stock = Stock((0, 0, 0), (100, 80, 10))

    def cut(shape, *points):
        return Cut(Toolpath.through(np.array(points, float)), Tool(shape, 4.0))

    ball = exact_volume([cut("ballend", (20, 30, 15), (20, 30, 7), (60, 50, 7))], stock)
    run = np.hypot(40, 20)
    # Half a cylinder, a slot above the cylinder, and the two round ends.
    exact = run * (2 * np.pi + 4) + 2 * np.pi / 3 * 8 + np.pi * 4
    crossing = [cut("endmill", (20, 30, 7), (60, 30, 7)), cut("endmill", (40, 10, 7), (40, 50, 7))]
    crossed = 3 * (2 * (40 * 4 + 4 * np.pi) - 16)
    print(
        f"relative error of the exact volume of a slot and of a crossing: {ball / exact - 1:.1e}, "
        f"{exact_volume(crossing, stock) / crossed - 1:.1e}"
    )


if __name__ == "__main__":
    main(*map(int, sys.argv[1:3]))
