# SPDX-License-Identifier: LGPL-2.1-or-later
"""Toolpaths with tools and stocks for timing the z-buffer."""

from __future__ import annotations

import numpy as np

from vkworkbench.core import Stock, Tool, Toolpath

FLAT, BALL = Tool("endmill", 5), Tool("ballend", 6)
PLATE, BLOCK = Stock((0, 0, 0), (80, 80, 10)), Stock((0, 0, 0), (100, 80, 20))


def toolpath(points: np.ndarray) -> Toolpath:
    """Return the moves through points (n+1, 3), without moves of length 0."""
    return Toolpath.through(points[np.append(True, (np.diff(points, axis=0) != 0).any(axis=1))])


def zigzag(trajectories: int) -> Toolpath:
    """Return rows over 80 x 80 mm, 4 mm deep, cut back and forth."""
    y = np.repeat(np.linspace(0, 80, trajectories // 2), 2)
    x = np.tile([0.0, 80.0, 80.0, 0.0], len(y))[: len(y)]
    return toolpath(np.column_stack((x, y, np.full(len(y), 6.0))))


def offsets(trajectories: int) -> Toolpath:
    """Return nested squares, the largest first."""
    inset = np.repeat(40 * np.arange(trajectories // 4) / (trajectories // 4), 4)
    far = 80 - inset
    right, up = (np.tile(corner, trajectories // 4) for corner in ([0, 1, 1, 0], [0, 0, 1, 1]))
    return toolpath(np.column_stack((np.where(right, far, inset), np.where(up, far, inset), np.full(len(inset), 6.0))))


def surface(rows: int, chords: int) -> Toolpath:
    """Return rows over a wavy surface, cut back and forth."""
    x, y = np.linspace(0, 100, chords), np.linspace(0, 80, rows)
    x = np.concatenate([x[:: 1 if k % 2 == 0 else -1] for k in range(rows)])
    y = np.repeat(y, chords)
    return toolpath(np.column_stack((x, y, 15 + 3 * np.sin(x / 12) * np.cos(y / 15))))


def adaptive(trajectories: int) -> Toolpath:
    """Return small loops of 40 chords that advance along rows."""
    chords, rows = 40, 20
    angle = np.linspace(0, 2 * np.pi, chords, endpoint=False)
    each = trajectories // chords // rows
    points = []
    for row in range(rows):
        for x in np.linspace(5, 75, each)[:: 1 if row % 2 == 0 else -1]:
            y = 4 + 3.6 * row
            loop = np.column_stack((x + 1.5 * np.cos(angle), y + 1.5 * np.sin(angle), np.full(chords, 5.0)))
            points.append(loop)
    return toolpath(np.concatenate(points))


def helices(trajectories: int) -> Toolpath:
    """Return twenty-five holes, each cut by a helix of ten turns."""
    points = []
    angle = np.linspace(0, 20 * np.pi, trajectories // 25)
    depth = np.linspace(10.5, 2, len(angle))
    for x in np.arange(10, 80, 15):
        for y in np.arange(10, 80, 15):
            helix = np.column_stack((x + 3 * np.cos(angle), y + 3 * np.sin(angle), depth))
            points += [[helix[0] + [0, 0, 5]], helix, [helix[-1] + [0, 0, 13]]]
    return toolpath(np.concatenate(points))


def stock_of(*toolpaths: Toolpath) -> Stock:
    """Return a block around and below everything that the toolpaths cut."""
    cutting = np.concatenate([path.points[1:][~path.rapid] for path in toolpaths])
    lower, upper = cutting.min(axis=0) - 5, cutting.max(axis=0) + 5
    lower[2] -= 1
    upper[2] = max(0.0, lower[2] + 5)
    return Stock(lower, upper)


CASES = {
    "Z, zigzag": (zigzag(17_000), FLAT, PLATE),
    "offsets": (offsets(17_000), FLAT, PLATE),
    "the paper's": (surface(89, 192), BALL, BLOCK),
    "surface": (surface(250, 200), BALL, BLOCK),
    "adaptive": (adaptive(17_000), FLAT, PLATE),
    "helices": (helices(5_000), FLAT, PLATE),
}
