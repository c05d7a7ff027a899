# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make rows with stepovers from 0.5 % to 10 % of the tool's diameter, as in reliefs and fine finishing."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from toolpaths.synthetic import Program

WAYS = ("zigzag", "one-way", "linked", "relief", "one-way relief")
SHAPES = ("rectangle", "triangle", "disc")
DECIMALS = 4  # decimals of coordinates; with three, rounding would change a stepover of 0.001 mm to 0 or 0.002 mm


@dataclass(frozen=True)
class FineRows:
    """A raster with the tool's diameter and the stepover, mm, and the raster's strategy."""

    commands: list[tuple[str, dict[str, float]]]
    tool: float
    stepover: float
    strategy: str


def fine_rows(rng: np.random.Generator, way: str, shape: str) -> FineRows:
    """Return a raster in one of the WAYS that fills one of the SHAPES, along x, along y or along a slanted line."""
    tool, share = (math.exp(rng.uniform(math.log(low), math.log(high))) for low, high in ((0.2, 20), (0.005, 0.1)))
    step, angle = round(share * tool, DECIMALS), float(rng.choice([0.0, math.pi / 2, rng.uniform(0, math.pi)]))
    count, length = int(rng.integers(30, 400)), float(rng.uniform(4, 20)) * tool
    p, alternates = Program(rng, rapids=bool(rng.random() < 0.7)), not way.startswith("one-way")
    turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    points = max(2, int(rng.integers(20, 60)) if "relief" in way else 2)
    for row in range(count):
        low, high = _ends(shape, (row + 0.5) / count)
        x = length * np.linspace(low, high, points)
        if alternates and row % 2:
            x = x[::-1]
        y = np.full(points, step * row)
        z = 0.05 * tool * np.cos(x / tool) * np.cos(y / tool) - tool if "relief" in way else np.full(points, -tool / 10)
        flat = (turn @ np.array([x, y])).T
        p.cut(np.column_stack([flat, z]).round(DECIMALS), 0.0, linked=way in ("zigzag", "relief") and row > 0)
        if way == "linked" and row + 1 < count:  # a link along the boundary in a few moves
            ahead = length * _ends(shape, (row + 1.5) / count)[(row + 1) % 2]
            link = np.array([np.linspace(x[-1], ahead, 3), np.linspace(y[-1], y[-1] + step, 3)])
            for place in (turn @ link).T.round(DECIMALS)[1:].tolist():
                p.go(*place, z[-1])
    return FineRows(p.commands, tool, step, "zigzag" if alternates else "one-way")


def _ends(shape: str, share: float) -> tuple[float, float]:
    """Return where a row begins and ends, as shares of the longest row; `share` is the position across the shape."""
    if shape == "rectangle":
        return 0.0, 1.0
    if shape == "triangle":
        return 0.3 * share, 1.0 - 0.6 * share
    half = math.sqrt(0.25 - (share - 0.5) ** 2)
    return 0.5 - half, 0.5 + half
