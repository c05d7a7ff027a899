# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make random and chaotic paths, and toolpaths with shuffled moves, for nonsense.KINDS."""

from __future__ import annotations

import numpy as np

from toolpaths.figures import count


def brownian_loop(rng):
    """A random walk that ends where it began."""
    at = np.cumsum(rng.normal(size=(count(rng), 2)), axis=0)
    return at - np.linspace(0, 1, len(at))[:, None] * at[-1]


def several_loops(rng):
    """Several Brownian loops around the same point, cut one after the other."""
    found = []
    for _ in range(int(rng.integers(3, 15))):
        at = np.cumsum(rng.normal(size=(int(rng.integers(30, 200)), 2)), axis=0)
        found.append(at - np.linspace(0, 1, len(at))[:, None] * at[-1])
    return np.concatenate(found)


def smooth_walk(rng):
    """A walk whose curvature changes slowly."""
    bend = np.convolve(rng.normal(size=count(rng) + 30), np.ones(30) / 30, "valid")
    angle = np.cumsum(bend * rng.uniform(1, 4))
    return np.cumsum(np.column_stack([np.cos(angle), np.sin(angle)]), axis=0)


def spline(rng):
    """A smooth curve through random points."""
    knots = rng.uniform(size=(int(rng.integers(10, 80)), 2))
    t = np.linspace(1, len(knots) - 2.001, len(knots) * 12)
    k, u = np.divmod(t, 1)
    k, u = k.astype(int), u[:, None]
    a, b, c, d = (knots[k + j] for j in (-1, 0, 1, 2))
    return b + u * (c - a) / 2 + u**2 * (a - 2.5 * b + 2 * c - d / 2) + u**3 * (1.5 * (b - c) + (d - a) / 2)


def self_avoiding_walk(rng):
    """Several random walks on a grid, each from the end of the previous walk. A walk never visits a point twice."""
    found, steps = [], [(1, 0), (0, 1), (-1, 0), (0, -1)]
    at = (0, 0)
    for _ in range(int(rng.integers(3, 12))):
        seen = {at}
        for _ in range(300):
            free = [to for to in ((at[0] + x, at[1] + y) for x, y in steps) if to not in seen]
            if not free:
                break
            at = free[int(rng.integers(len(free)))]
            seen.add(at)
            found.append(at)
    return np.array(found, float)


def maze(rng):
    """The path through all cells of a random maze, with the returns from its dead ends."""
    side, at, seen, found = int(rng.integers(6, 18)), (0, 0), {(0, 0)}, [(0, 0)]
    stack = [at]
    while stack:
        x, y = stack[-1]
        free = [to for to in ((x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1))
                if to not in seen and 0 <= to[0] < side and 0 <= to[1] < side]  # fmt: skip
        if free:
            stack.append(free[int(rng.integers(len(free)))])
            seen.add(stack[-1])
        else:
            stack.pop()
        if stack:
            found.append(stack[-1])
    return np.array(found, float)


def ant(rng):
    """The path of Langton's ant, which turns right on white cells of a grid and left on black cells."""
    black, at, heading, found = set(), 0j, 1 + 0j, []
    for _ in range(int(rng.integers(200, 2500))):
        heading *= 1j if at in black else -1j
        black ^= {at}
        at += heading
        found.append(at)
    return np.column_stack([np.real(found), np.imag(found)])


def billiard(rng):
    """Straight chords of a circle, each of which begins at the end of the previous chord, at random angles."""
    at, angle, found = rng.uniform(-0.5, 0.5) + 0j, rng.uniform(0, 7), []
    for _ in range(count(rng) // 4):
        way = np.exp(1j * angle)
        along = (at * np.conj(way)).real
        at = at + way * (-along + np.sqrt(max(0.0, along**2 - abs(at) ** 2 + 1)))
        found.append(at)
        angle = np.angle(-at) + rng.uniform(-1.4, 1.4)
    return np.column_stack([np.real(found), np.imag(found)])


def swinging(rng):
    """The path of the lower end of a double pendulum."""
    a, b, va, vb = rng.uniform(-3, 3), rng.uniform(-3, 3), 0.0, 0.0
    found, h = [], 0.02
    for _ in range(2 * count(rng)):
        d = a - b
        low = 3 - np.cos(2 * d)
        pull = 9.8 * (-3 * np.sin(a) - np.sin(a - 2 * b)) - 2 * np.sin(d) * (vb * vb + va * va * np.cos(d))
        push = 2 * np.sin(d) * (2 * va * va + 2 * 9.8 * np.cos(a) + vb * vb * np.cos(d))
        va, vb = va + h * pull / low, vb + h * push / low
        a, b = a + h * va, b + h * vb
        found.append((np.sin(a) + np.sin(b), -np.cos(a) - np.cos(b)))
    return np.array(found)


def iterated_map(rng):
    """The points of De Jong's chaotic map, in the order in which the map computes them."""
    a, b, c, d = rng.uniform(-2.5, 2.5, 4)
    x, y, found = 0.1, 0.1, []
    for _ in range(count(rng) // 2):
        x, y = np.sin(a * y) - np.cos(b * x) + rng.normal(0, 0.05), np.sin(c * x) - np.cos(d * y)
        found.append((x, y))
    return np.array(found)


def sorted_noise(rng):
    """Random points, sorted by one coordinate."""
    points = rng.uniform(size=(count(rng) // 2, 2))
    return points[np.argsort(points[:, 0])]


def noise_around(rng):
    """Random points, sorted by angle."""
    points = rng.normal(size=(count(rng) // 2, 2))
    return points[np.argsort(np.arctan2(*points.T))]


def noise_outward(rng):
    """Random points, sorted by their distance from the origin."""
    points = rng.normal(size=(count(rng) // 2, 2))
    return points[np.argsort(np.hypot(*points.T))]


def clusters(rng):
    """Random points around several centres, one centre after the other."""
    centres = rng.uniform(0, 10, (int(rng.integers(4, 20)), 2))
    return np.concatenate([c + rng.normal(0, rng.uniform(0.2, 1.5), (int(rng.integers(10, 60)), 2)) for c in centres])


def binary_coordinates(rng):
    """Points whose coordinates are chosen at random from three to six values."""
    values = rng.uniform(0, 10, int(rng.integers(3, 7)))
    return rng.choice(values, (count(rng) // 2, 2))


def digits(rng):
    """Steps of equal length; before each step the direction turns by a random multiple of 36 degrees."""
    angle = np.cumsum(rng.integers(0, 10, count(rng))) * 2 * np.pi / 10
    return np.cumsum(np.column_stack([np.cos(angle), np.sin(angle)]), axis=0)


def shuffled_moves(rng):
    """The moves of rows or of offset squares, joined end to end in random order."""
    steps = np.diff(_toolpath(rng), axis=0)
    return np.cumsum(rng.permutation(steps), axis=0)


def shuffled_points(rng):
    """The points of rows or of offset squares, in random order."""
    return rng.permutation(_toolpath(rng))


def shuffled_stretches(rng):
    """Stretches of rows or of offset squares, joined end to end in random order; some are rotated by quarter turns."""
    parts = np.array_split(np.diff(_toolpath(rng), axis=0), int(rng.integers(8, 40)))
    turns = [np.array([(c, -s), (s, c)]) for c, s in ((1, 0), (0, 1), (-1, 0), (0, -1))]
    return np.cumsum(np.concatenate([parts[k] @ turns[rng.integers(4)] for k in rng.permutation(len(parts))]), axis=0)


def shaken(rng):
    """The points of rows or of offset squares, displaced at random by more than the distance between the rows."""
    points = _toolpath(rng, fine=True)
    return points + rng.normal(0, rng.uniform(1.5, 4), points.shape)


def mutated_walk(rng):
    """A closed random walk that is repeated several times, each time with random changes."""
    steps = rng.normal(size=(int(rng.integers(15, 80)), 2))
    steps -= steps.mean(axis=0)
    times = int(rng.integers(4, 14))
    return np.cumsum(np.concatenate([steps + rng.normal(0, 0.5, steps.shape) for _ in range(times)]), axis=0)


def swarm(rng):
    """A smooth path towards goals at random places, one goal after the other."""
    goals, at, speed, found = rng.uniform(0, 10, (int(rng.integers(8, 60)), 2)), np.zeros(2), np.zeros(2), []
    for goal in goals:
        for _ in range(int(rng.integers(5, 30))):
            speed = 0.92 * speed + 0.08 * (goal - at)
            at = at + 0.4 * speed
            found.append(at)
    return np.array(found)


def crossing_strokes(rng):
    """Long straight strokes across the part in random directions, linked by cutting moves."""
    angle = rng.uniform(0, 2 * np.pi, (int(rng.integers(25, 150)), 1))
    across = np.concatenate([np.cos(angle), np.sin(angle)], axis=1)
    middle = rng.uniform(-0.6, 0.6, (len(angle), 2))
    return np.stack([middle - across, middle + across], axis=1).reshape(-1, 2)


def hatches_at_random(rng):
    """Short hatches like a plotter's, at random places and in random directions, linked by cutting moves."""
    found = []
    for _ in range(int(rng.integers(10, 60))):
        k = np.arange(int(rng.integers(2, 6)))
        rows = np.column_stack([np.where((k + 1) // 2 % 2, 1.0, 0.0), k * rng.uniform(0.1, 0.4)])
        angle = rng.uniform(0, 7)
        turn = np.array([(np.cos(angle), -np.sin(angle)), (np.sin(angle), np.cos(angle))])
        found.append(rng.uniform(0, 8, 2) + rng.uniform(0.5, 3) * rows @ turn)
    return np.concatenate(found)


def _toolpath(rng, fine=False):
    """Return rows or linked offset squares 1 mm apart, with points along their sides."""
    n = int(rng.integers(8, 25))
    if rng.random() < 0.5:
        k = np.arange(2 * n)
        corners = np.column_stack([np.where((k + 1) // 2 % 2, n, 0), k // 2]).astype(float)
    else:
        square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)]) / 2
        corners = np.concatenate([square * size for size in range(1, n)])
    between = np.linspace(0, 1, 6 if fine else int(rng.integers(2, 5)))[1:, None]
    return np.concatenate([corners[:1], *(a + between * (b - a) for a, b in zip(corners, corners[1:]))])


#: Kinds of nonsense toolpaths that may contain lifts. All other kinds in this file must not contain lifts, because
#: smooth curves and strokes with lifts are an engraving.
RANDOM = (
    brownian_loop, self_avoiding_walk, ant, billiard, iterated_map, sorted_noise, noise_around, noise_outward, clusters,
    binary_coordinates, digits, shuffled_moves, shuffled_points, shuffled_stretches, shaken, mutated_walk,
)  # fmt: skip
OTHER = (maze, swinging, several_loops, smooth_walk, spline, swarm, crossing_strokes, hatches_at_random)
