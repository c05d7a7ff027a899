# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make curves, fractals and paths through grids that machine no part, for nonsense.KINDS."""

from __future__ import annotations

import numpy as np

from toolpaths.turtle import grow


def harmonograph(rng):
    """The curve of a harmonograph: along each axis, the sum of two damped oscillations."""
    t = np.linspace(0, 2 * np.pi * rng.integers(8, 40), count(rng) * 2)
    return np.column_stack([_pendulum(rng, t) + _pendulum(rng, t) for _ in range(2)])


def woven_lissajous(rng):
    """A Lissajous curve with a random ratio of its frequencies."""
    t = np.linspace(0, 2 * np.pi * rng.integers(6, 30), count(rng) * 2)
    ratio = rng.uniform(0.5, 3.0)
    return np.column_stack([np.sin(t + rng.uniform(0, 3)), np.sin(ratio * t)])


def product_of_waves(rng):
    t = np.linspace(0, 2 * np.pi, 3 * count(rng))
    a, b, c = rng.integers(2, 15, 3)
    return np.column_stack([np.sin(a * t) * np.cos(b * t), np.sin(c * t + rng.uniform(0, 3))])


def precessing_ellipse(rng):
    turns, slim = rng.integers(8, 40), rng.uniform(0.05, 0.7)
    t = np.linspace(0, 2 * np.pi * turns, int(turns) * 40)
    at = np.exp(1j * t * rng.uniform(0.02, 0.2)) * (np.cos(t) + 1j * slim * np.sin(t))
    return np.column_stack([at.real, at.imag])


def maurer_rose(rng):
    """Chords of a rose curve between points at equal steps of the angle."""
    k = np.arange(rng.integers(150, 721)) * np.radians(rng.integers(19, 121))
    radius = np.sin(rng.integers(2, 9) * k)
    return radius[:, None] * np.column_stack([np.cos(k), np.sin(k)])


def times_table(rng):
    """Chords of a circle from each of n points to the point at a multiple of the first point's angle."""
    n, times = int(rng.integers(60, 400)), rng.uniform(2, 60)
    k = np.arange(n)
    angle = np.column_stack([k, times * k]).ravel() * 2 * np.pi / n
    return np.column_stack([np.cos(angle), np.sin(angle)])


def star_polygon(rng):
    """A regular star polygon, whose sides all cross."""
    n = int(rng.integers(31, 200)) | 1
    angle = np.arange(n + 1) * 2 * np.pi * int(n * rng.uniform(0.25, 0.48)) / n
    return np.column_stack([np.cos(angle), np.sin(angle)])


def stars_on_stars(rng):
    """Small star polygons of random sizes at random places, linked by cutting moves."""
    found = []
    for _ in range(int(rng.integers(8, 40))):
        points = int(rng.choice([5, 7, 9, 11]))
        angle = np.arange(points + 1) * 2 * np.pi * (points // 2) / points + rng.uniform(0, 7)
        found.append(rng.uniform(0, 5, 2) + rng.uniform(0.3, 2) * np.column_stack([np.cos(angle), np.sin(angle)]))
    return np.concatenate(found)


def overlapping_circles(rng):
    """Circles of random sizes at random places, linked by cutting moves; each circle begins at a random angle."""
    found, t = [], np.linspace(0, 2 * np.pi, 37)
    for _ in range(int(rng.integers(10, 60))):
        angle = rng.choice([-1, 1]) * t + rng.uniform(0, 7)
        found.append(rng.uniform(0, 4, 2) + rng.uniform(0.2, 2) * np.column_stack([np.cos(angle), np.sin(angle)]))
    return np.concatenate(found)


def overlapping_polygons(rng):
    """Polygons of random shapes at random places, linked by cutting moves."""
    found = []
    for _ in range(int(rng.integers(12, 80))):
        corners = np.sort(rng.uniform(0, 2 * np.pi, int(rng.integers(3, 8))))
        around = rng.uniform(0.3, 1.5) * np.column_stack([np.cos(corners), np.sin(corners)])
        found.append(rng.uniform(0, 4, 2) + np.vstack([around, around[:1]]))
    return np.concatenate(found)


def flower_of_arcs(rng):
    """Arcs of random radii and angles, joined without corners, each bent to the left or to the right at random."""
    at, heading, found = 0j, 1 + 0j, []
    for _ in range(int(rng.integers(20, 120))):
        side, radius = rng.choice([-1, 1]), rng.uniform(0.3, 2)
        angle = np.linspace(0, rng.uniform(0.3, 1.8) * np.pi, 12)[1:]
        centre = at + 1j * side * radius * heading
        arc = centre + (at - centre) * np.exp(1j * side * angle)
        found.append(arc)
        at, heading = arc[-1], heading * np.exp(1j * side * angle[-1])
    at = np.concatenate(found)
    return np.column_stack([at.real, at.imag])


def recaman(rng):
    """Half circles between successive numbers of Recaman's sequence on a line."""
    seen, at, found = {0}, 0, []
    for k in range(1, int(rng.integers(25, 90))):
        to = at - k if at - k > 0 and at - k not in seen else at + k
        angle = np.linspace(np.pi, 0, 16) * (1 if k % 2 else -1)
        found.append((at + to) / 2 + (to - at) / 2 * np.exp(1j * angle))
        seen.add(to)
        at = to
    at = np.concatenate(found)
    return np.column_stack([at.real, at.imag])


def random_growth(rng):
    """The path of a Lindenmayer system with a random rule."""
    rule = "F" + "".join(rng.choice(["+F", "-F", "++F", "--F", "F"], int(rng.integers(2, 6))))
    return grow(
        "F", {"F": rule}, int(rng.choice([45, 60, 72, 90, 120])), int(np.log(900) / np.log(rule.count("F"))), "F"
    )


def two_random_growths(rng):
    """The path of a Lindenmayer system of two letters with random rules."""
    rules = {
        letter: "".join(rng.permutation(list("FFG+-" + "".join(rng.choice(["+", "-", "F"], 2))))) for letter in "FG"
    }
    return grow("F", rules, int(rng.choice([60, 90, 120])), 5, "FG")[:3000]


def twin_dragon(rng):
    return grow("FX+FX+", {"X": "X+YF", "Y": "FX-Y"}, 90, rng.integers(6, 11), "F")


def cesaro(rng):
    return grow("F", {"F": "F+F--F+F"}, int(rng.integers(60, 89)), rng.integers(3, 6), "F")


def minkowski(rng):
    return grow("F", {"F": "F+F-F-FF+F+F-F"}, 90, rng.integers(2, 4), "F")


def gasket(rng):
    return grow("F-G-G", {"F": "F-G+F+G-F", "G": "GG"}, 120, rng.integers(3, 6), "FG")


def crystal(rng):
    return grow("F+F+F+F", {"F": "FF+F++F+F"}, 90, rng.integers(2, 5), "F")


def pentaplexity(rng):
    return grow("F++F++F++F++F", {"F": "F++F++F+++++F-F++F"}, 36, rng.integers(1, 4), "F")


def rings_of_l(rng):
    return grow("F+F+F+F", {"F": "FF+F+F+F+F+F-F"}, 90, rng.integers(1, 4), "F")


def recursive_squares(rng):
    """Squares with smaller squares around their corners. A smaller square is drawn when its corner is reached."""
    found: list[complex] = []
    shrink = rng.uniform(0.35, 0.55)

    def draw(at, size, left):
        for corner in (-1 - 1j, 1 - 1j, 1 + 1j, -1 + 1j, -1 - 1j):
            found.append(at + size * corner)
            if left:
                draw(at + size * corner, size * shrink, left - 1)

    draw(0, 1.0, int(rng.integers(2, 4)))
    return np.column_stack([np.real(found), np.imag(found)])


def mixed_order(rng):
    """The cells of a grid in counting order, where each digit of the number has a random base and a random axis."""
    cells, sizes = np.zeros((1, 2)), [1, 1]
    while len(cells) < 150:
        axis, base = int(rng.integers(2)), int(rng.integers(2, 5))
        step = np.zeros((base, 1, 2))
        step[:, 0, axis] = np.arange(base) * sizes[axis]
        cells = (cells + step).reshape(-1, 2)
        sizes[axis] *= base
    return cells[:1500]


def bent_order(rng):
    """The cells of a grid in counting order by blocks, where every other block is traversed backwards."""
    cells, size = np.zeros((1, 2)), 1
    while len(cells) < 200:
        base = int(rng.integers(2, 4))
        order = [(i, j) for i in range(base) for j in range(base)]
        blocks = [cells[:: 1 if k % 2 else -1] + np.array(order[k]) * size for k in range(base * base)]
        cells, size = np.concatenate(blocks), size * base
    return cells[:1500]


def cross_order(rng):
    """The quadrants of a square in a random order, and the quadrants of each quadrant in the same order."""
    order = np.array([(0, 0), (1, 1), (0, 1), (1, 0)])[rng.permutation(4)]
    cells = np.zeros((1, 2))
    for k in range(int(rng.integers(3, 6))):
        cells = (cells + (order * 2**k)[:, None]).reshape(-1, 2)
    return cells


def bit_reversal(rng):
    """The rows of a grid in bit-reversed order, with the points of each row in bit-reversed order."""
    bits = int(rng.integers(3, 6))
    k = np.arange(2**bits)
    back = ((k[:, None] >> np.arange(bits)) & 1) @ (1 << np.arange(bits)[::-1])
    return np.stack(np.meshgrid(back, back), axis=-1).reshape(-1, 2).astype(float)


def low_discrepancy(rng):
    """The points of Halton's low-discrepancy sequence in their order."""
    k = np.arange(1, count(rng) // 2)

    def inverse(base):
        left, at, weight = k.copy(), np.zeros(len(k)), 1.0
        while left.any():
            weight /= base
            left, digit = np.divmod(left, base)
            at += digit * weight
        return at

    first, second = rng.choice([2, 3, 5, 7, 11], 2, replace=False)
    return np.column_stack([inverse(first), inverse(second)])


def text_as_coordinates(rng):
    """The character codes of a random text, where two consecutive letters give the coordinates of a point."""
    words = ["".join(rng.choice(list("aeinrstlomdu"), int(rng.integers(2, 9)))) for _ in range(count(rng) // 6)]
    codes = np.frombuffer(" ".join(words).encode(), np.uint8).astype(float)
    return codes[: len(codes) // 2 * 2].reshape(-1, 2) - 32


def _pendulum(rng, t):
    return (
        rng.uniform(0.3, 1) * np.sin(rng.uniform(0.8, 3.2) * t + rng.uniform(0, 7)) * np.exp(-rng.uniform(0, 0.02) * t)
    )


def count(rng) -> int:
    """Return a random number of points."""
    return int(rng.integers(60, 1500))


KINDS = (
    harmonograph, woven_lissajous, product_of_waves, precessing_ellipse, maurer_rose, times_table, star_polygon,
    stars_on_stars, overlapping_circles, overlapping_polygons, flower_of_arcs, recaman, random_growth,
    two_random_growths, twin_dragon, cesaro, minkowski, gasket, crystal, pentaplexity, rings_of_l, recursive_squares,
    mixed_order, bent_order, cross_order, bit_reversal, low_discrepancy, text_as_coordinates,
)  # fmt: skip
