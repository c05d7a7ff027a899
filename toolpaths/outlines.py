# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make toolpaths around closed outlines, as G-code commands: profiles with many corners, and pairs of offsets.

The profiles resemble nonsense toolpaths because of their many corners. The functions that make toolpaths have the same
form as in synthetic.py. SAMPLES lists (label, strategies that count as right, function).
"""

from __future__ import annotations

import numpy as np

from toolpaths.synthetic import Program, closed, depths, inward, outline


def around(angle: np.ndarray, radius: np.ndarray | float) -> np.ndarray:
    """Return points (k, 2) at angles and distances from the origin."""
    return np.transpose(radius * np.array([np.cos(angle), np.sin(angle)]))


def gear(rng: np.random.Generator) -> np.ndarray:
    """Return the outline of a gear, (k, 2)."""
    teeth = int(rng.integers(8, 70))
    edges = np.sort(
        np.concatenate([np.arange(teeth) + share for share in (0, rng.uniform(0, 0.2), 0.5, rng.uniform(0.5, 0.7))])
    )
    return around(2 * np.pi * edges / teeth, np.resize([1.0, 1.0, *[rng.uniform(0.75, 0.95)] * 2], 4 * teeth))


def star(rng: np.random.Generator) -> np.ndarray:
    """Return the outline of a star, (k, 2)."""
    points = int(rng.integers(5, 24))
    return around(np.pi * np.arange(2 * points) / points, np.resize([1.0, rng.uniform(0.4, 0.8)], 2 * points))


def star_polygon(rng: np.random.Generator) -> np.ndarray:
    """Return a star polygon, whose sides cross, (k, 2)."""
    points = int(rng.choice([5, 7, 9, 11, 13]))
    return around(2 * np.pi * int(rng.integers(2, (points + 1) // 2)) * np.arange(points) / points, 1.0)


def polygon(rng: np.random.Generator) -> np.ndarray:
    """Return a regular polygon, (k, 2)."""
    corners = int(rng.integers(3, 30))
    return around(2 * np.pi * np.arange(corners) / corners, 1.0)


def snowflake(rng: np.random.Generator) -> np.ndarray:
    """Return a Koch snowflake, a polygon with a corner added to the middle third of each side, repeatedly, (k, 2)."""
    corners = np.exp(-2j * np.pi * np.arange(sides := int(rng.integers(3, 6))) / sides)
    out = rng.choice([-1, 1]) * np.pi / 3
    for _ in range(int(rng.integers(1, 4))):
        third = (np.roll(corners, -1) - corners) / 3
        tip = corners + third + third * np.exp(1j * out)
        corners = np.ravel(np.column_stack([corners, corners + third, tip, corners + 2 * third]))
    return np.column_stack([corners.real, corners.imag])


def wavy(rng: np.random.Generator) -> np.ndarray:
    """Return a smooth outline with lobes, (k, 2)."""
    angle = np.linspace(0, 2 * np.pi, int(rng.integers(60, 400)), endpoint=False)
    lobes = rng.integers(2, 16, 2)
    return around(angle, 1 + rng.uniform(0.05, 0.25, 2) @ np.cos(np.outer(lobes, angle) + rng.uniform(0, 6, (2, 1))))


def walls(rng: np.random.Generator) -> np.ndarray:
    """Return an outline with sides along X and Y only, like a skyline or a finger joint, (k, 2)."""
    count = int(rng.integers(4, 40))
    heights = np.repeat(np.where(np.arange(count) % 2, rng.uniform(0.1, 0.9, count), 1.0), 2)
    x = np.repeat(np.linspace(-1, 1, count + 1), 2)[1:-1]
    return np.vstack([np.column_stack([x, heights]), [(1, -rng.uniform(0.2, 1)), (-1, -0.5)]])


def cut(rng: np.random.Generator, make) -> list[tuple[str, dict[str, float]]]:
    """Return a program that cuts an outline, 20 to 160 mm wide, at one or several depths."""
    p = Program(rng)
    shape = make(rng) * rng.uniform(10, 80)
    angle = rng.uniform(0, 2 * np.pi)
    shape = shape @ np.array([(np.cos(angle), np.sin(angle)), (-np.sin(angle), np.cos(angle))]) + rng.uniform(
        -50, 50, 2
    )
    way = closed(shape[:: rng.choice([-1, 1])], int(rng.integers(len(shape))))
    for z in depths(rng) if rng.random() < 0.5 else (-1.0,):
        p.cut(way, z, linked=bool(rng.random() < 0.5))
    p.commands.append(("G0", {"Z": 5.0}))
    return p.commands


def two_offsets(rng: np.random.Generator) -> list[tuple[str, dict[str, float]]]:
    """Return a program that cuts an outline and its inner offset, which can be a pocket if the tool is unknown."""
    p = Program(rng)
    while (inner := inward(shape := outline(rng), rng.uniform(0.5, 4.0))) is None:
        pass
    loops = [closed(shape), closed(inner)][:: rng.choice([-1, 1])]
    for z in depths(rng, 3):
        for loop in loops:
            p.cut(loop, z)
    p.commands.append(("G0", {"Z": 5.0}))
    return p.commands


KINDS = (gear, star, star_polygon, polygon, snowflake, wavy, walls)
SAMPLES = [(f"outline: {make.__name__}", {"profile"}, lambda rng, make=make: cut(rng, make)) for make in KINDS]
SAMPLES.append(("two offsets", {"contour-parallel"}, two_offsets))
