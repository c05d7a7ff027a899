# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make nonsense toolpaths, which machine no part: random walks, noise, rolling curves and space-filling curves.

KINDS also contains the functions in chaos.py, figures.py and random_rules.py.
"""

from __future__ import annotations

import numpy as np

from toolpaths import chaos, figures, random_rules
from toolpaths.turtle import grow

CLEAR, DEPTH, FEED = 5.0, -1.0, 10.0


def walk(rng):
    return np.cumsum(rng.normal(size=(_count(rng), 2)), axis=0)


def persistent_walk(rng):
    angle = np.cumsum(rng.normal(0, rng.uniform(0.2, 1.2), _count(rng)))
    return np.cumsum(np.column_stack([np.cos(angle), np.sin(angle)]) * rng.uniform(0.3, 1.5, (len(angle), 1)), axis=0)


def walk_on_a_grid(rng):
    n = _count(rng)
    steps = np.array([(1, 0), (0, 1), (-1, 0), (0, -1)])[rng.integers(0, 4, n)]
    return np.cumsum(steps * rng.integers(1, 4, (n, 1)), axis=0)


def walk_on_triangles(rng):
    n = _count(rng)
    angle = np.pi / 3 * rng.integers(0, 6, n)
    return np.cumsum(np.column_stack([np.cos(angle), np.sin(angle)]) * rng.integers(1, 4, (n, 1)), axis=0)


def straying_walk(rng):
    """Straight stretches with random turns between them."""
    angle = np.cumsum(rng.uniform(-np.pi, np.pi, _count(rng)))
    return np.cumsum(np.column_stack([np.cos(angle), np.sin(angle)]) * rng.exponential(1, (len(angle), 1)), axis=0)


def scribble(rng):
    """A smooth closed curve that is the sum of random waves."""
    t = np.linspace(0, 2 * np.pi, 2 * _count(rng))
    waves = np.arange(1, rng.integers(8, 40))
    size = 1 / np.sqrt(waves)
    return np.column_stack(
        [(size * rng.normal(size=len(waves)) * np.cos(np.outer(t, waves) + rng.uniform(0, 7, len(waves)))).sum(axis=1)
         for _ in range(2)]
    )  # fmt: skip


def noise(rng):
    return rng.uniform(size=(_count(rng), 2))


def normal_noise(rng):
    return rng.normal(size=(_count(rng), 2))


def chords(rng):
    angle = rng.uniform(0, 2 * np.pi, _count(rng) // 2)
    return np.column_stack([np.cos(angle), np.sin(angle)])


def shuffled_grid(rng):
    side = int(rng.integers(7, 30))
    return rng.permutation(np.stack(np.meshgrid(np.arange(side), np.arange(side)), axis=-1).reshape(-1, 2)).astype(
        float
    )


def epicycloid(rng):
    k, arm = rng.uniform(1.5, 9), rng.uniform(0.3, 1.5)
    return _rolling(rng, 1 + 1 / k, -arm / k, k + 1)


def hypocycloid(rng):
    k, arm = rng.uniform(2.2, 9), rng.uniform(0.3, 1.5)
    return _rolling(rng, 1 - 1 / k, arm / k, 1 - k)


def lissajous(rng):
    t = np.linspace(0, 2 * np.pi, 2 * _count(rng))
    return np.column_stack([np.sin(rng.integers(3, 20) * t + rng.uniform(0, 3)), np.sin(rng.integers(3, 20) * t)])


def rose(rng):
    petals = rng.integers(3, 30) / rng.integers(3, 12)
    t = np.linspace(0, 2 * np.pi * rng.integers(4, 12), 2 * _count(rng))
    radius = np.cos(petals * t) + rng.uniform(-0.4, 0.4)
    return np.column_stack([radius * np.cos(t), radius * np.sin(t)])


def three_arms(rng):
    """The path of the end of three rods that are joined end to end and rotate at different speeds."""
    t = np.linspace(0, 2 * np.pi * rng.integers(2, 8), 2 * _count(rng))
    arms, speeds = rng.uniform(0.2, 1, 3), rng.uniform(-12, 12, 3)
    return np.column_stack([turn(np.outer(t, speeds)) @ arms for turn in (np.cos, np.sin)])


def star(rng):
    """A star polygon that is traversed repeatedly with varying radii."""
    corners = _count(rng) // 4
    angle = np.arange(corners) * 2 * np.pi * rng.uniform(0.2, 0.48)
    return rng.uniform(0.7, 1, (corners, 1)) * np.column_stack([np.cos(angle), np.sin(angle)])


def hilbert(rng):
    return grow("A", {"A": "+BF-AFA-FB+", "B": "-AF+BFB+FA-"}, 90, rng.integers(3, 6), "F")


def peano(rng):
    rules = {"X": "XFYFX+F+YFXFY-F-XFYFX", "Y": "YFXFY-F-XFYFX+F+YFXFY"}
    return grow("X", rules, 90, rng.integers(2, 4), "F")


def dragon(rng):
    return grow("F", {"F": "F+G", "G": "F-G"}, 90, rng.integers(6, 11), "FG")


def gosper(rng):
    return grow("A", {"A": "A-B--B+A++AA+B-", "B": "+A-BB--B-A++A+B"}, 60, rng.integers(2, 5), "AB")


def koch(rng):
    return grow("F", {"F": "F+F-F-F+F"}, 90, rng.integers(2, 5), "F")


def moore(rng):
    return grow("LFL+F+LFL", {"L": "-RF+LFL+FR-", "R": "+LF-RFR-FL+"}, 90, rng.integers(2, 5), "F")


def meander(rng):
    """Peano's space-filling curve in the variant with bent rows."""
    rules = {"X": "FX+FX+FXFY-FY-", "Y": "+FX+FXFY-FY-FY"}
    return grow("X", rules, 90, rng.integers(3, 6), "F")


def levy(rng):
    return grow("F", {"F": "+F--F+"}, 45, rng.integers(7, 12), "F")


def arrowhead(rng):
    return grow("X", {"X": "YF+XF+Y", "Y": "XF-YF-X"}, 60, rng.integers(4, 8), "F")


def quadratic_island(rng):
    return grow("F-F-F-F", {"F": "F-F+F+FF-F-F+F"}, 90, rng.integers(1, 4), "F")


def sierpinski(rng):
    return grow("F--XF--F--XF", {"X": "XF+G+XF--F--XF+G+X"}, 45, rng.integers(2, 5), "FG")


def terdragon(rng):
    return grow("F", {"F": "F+F-F"}, 120, rng.integers(4, 7), "F")


def gray(rng):
    """The cells of a grid in the order of a Gray code, whose bits belong alternately to X and to Y."""
    k = np.arange(4 ** int(rng.integers(3, 6)))
    bits = ((k ^ (k >> 1))[:, None] >> np.arange(12)) & 1
    return np.column_stack([bits[:, 0::2] @ (1 << np.arange(6)), bits[:, 1::2] @ (1 << np.arange(6))]).astype(float)


def morton(rng):
    k = np.arange(4 ** int(rng.integers(3, 6)))
    bits = (k[:, None] >> np.arange(12)) & 1
    return np.column_stack([bits[:, 0::2] @ (1 << np.arange(6)), bits[:, 1::2] @ (1 << np.arange(6))]).astype(float)


def odometer(rng):
    """The cells of a grid in the order of counting in a base of 2 to 4, with digits alternately for X and for Y."""
    bases = ((3, 3), (2, 3), (3, 2), (4, 2), (2, 4), (3, 4))[int(rng.integers(6))]
    places, units = [], [1, 1]
    while units[0] * units[1] < 60 or len(places) % 2:
        axis = len(places) % 2
        places.append((axis, bases[axis], units[axis]))
        units[axis] *= bases[axis]
    number = np.arange(units[0] * units[1])[: int(rng.integers(200, 1500))]
    cells = np.zeros((len(number), 2))
    for axis, base, unit in places:
        number, digit = np.divmod(number, base)
        cells[:, axis] += digit * unit
    return cells


def wunderlich(rng):
    """Peano's space-filling serpentines, each vertical or horizontal at random (Wunderlich 1973)."""

    def fill(times):
        if not times:
            return np.zeros((1, 2))
        size, found = 3 ** (times - 1), []
        for k in range(9):
            column, row = divmod(k, 3)
            row = 2 - row if column % 2 else row
            part = fill(times - 1)
            part[:, 1] = size - 1 - part[:, 1] if column % 2 else part[:, 1]
            part[:, 0] = size - 1 - part[:, 0] if row % 2 else part[:, 0]
            found.append(part + (column * size, row * size))
        cells = np.concatenate(found)
        return cells[:, ::-1].copy() if rng.random() < 0.5 else cells

    return fill(int(rng.integers(2, 4)))


def levy_flight(rng):
    """A random walk whose steps are mostly short and rarely very long."""
    angle = rng.uniform(0, 2 * np.pi, _count(rng))
    step = rng.pareto(rng.uniform(1.2, 2.5), (len(angle), 1)) + 0.1
    return np.cumsum(step * np.column_stack([np.cos(angle), np.sin(angle)]), axis=0)


def drifting_noise(rng):
    """Noise, smoothed by a moving sum over a few points."""
    width = int(rng.integers(2, 12))
    steps = rng.normal(size=(_count(rng) + width, 2))
    return np.column_stack([np.convolve(of, np.ones(width), "valid") for of in steps.T])


def knight(rng):
    """Random moves of a knight on a chessboard."""
    steps = np.array([(1, 2), (2, 1), (2, -1), (1, -2), (-1, -2), (-2, -1), (-2, 1), (-1, 2)])
    return np.cumsum(steps[rng.integers(0, 8, _count(rng))], axis=0).astype(float)


def tour(rng):
    """Random points, each followed by the nearest point that was not visited before."""
    points = rng.uniform(size=(int(rng.integers(60, 400)), 2))
    left, at, order = np.ones(len(points), bool), 0, []
    for _ in points:
        order.append(at)
        left[at] = False
        at = int(np.argmin(np.where(left, np.hypot(*(points - points[at]).T), np.inf)))
    return points[order]


def attractor(rng):
    """A trajectory of the chaotic Lorenz system, projected along one axis."""
    at, found = rng.normal(size=3) + (0, 0, 25), []
    for _ in range(4 * _count(rng)):
        x, y, z = at
        at = at + 0.008 * np.array([10 * (y - x), x * (28 - z) - y, x * y - 8 / 3 * z])
        found.append(at)
    return np.array(found)[:, rng.permutation(3)[:2]]


def sunflower(rng):
    """Points placed like the seeds of a sunflower, from the centre outwards."""
    k = np.arange(_count(rng) // 2)
    angle = k * np.pi * (3 - np.sqrt(5)) * rng.uniform(0.8, 1.2)
    return np.sqrt(k)[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])


def spirolateral(rng):
    """Steps with equal turns between them. The length of the steps grows up to a limit, and then starts again."""
    most, times = int(rng.integers(3, 12)), int(rng.integers(6, 30))
    angle = np.arange(most * times) * np.radians(rng.choice([36, 45, 60, 72, 80, 90, 108, 120, 144]))
    step = np.tile(np.arange(1, most + 1), times)[:, None]
    return np.cumsum(step * np.column_stack([np.cos(angle), np.sin(angle)]), axis=0)


RANDOM = (
    *chaos.RANDOM,
    walk,
    persistent_walk,
    walk_on_a_grid,
    walk_on_triangles,
    straying_walk,
    noise,
    normal_noise,
    chords,
    shuffled_grid,
    levy_flight,
    drifting_noise,
    knight,
)
KINDS = (
    *RANDOM, scribble, epicycloid, hypocycloid, lissajous, rose, three_arms, star, hilbert, moore, peano, meander,
    dragon, levy, gosper, arrowhead, koch, quadratic_island, morton, sierpinski, terdragon, gray, tour, attractor,
    sunflower, spirolateral, wunderlich, odometer, *chaos.OTHER, *figures.KINDS, *random_rules.KINDS,
)  # fmt: skip


def commands(kind, rng) -> list[tuple[str, dict]]:
    """Return the commands that cut one of KINDS, scaled to 20 to 300 mm.

    In one of four toolpaths, the depth varies. Toolpaths of the kinds in RANDOM can contain lifts at random places.
    """
    points = kind(rng)
    points = points - points.min(axis=0)
    points = points / max(points.max(), 1e-9) * np.exp(rng.uniform(np.log(20), np.log(300)))
    if rng.random() < 0.5:
        angle = rng.uniform(0, np.pi)
        points = points @ np.array([(np.cos(angle), -np.sin(angle)), (np.sin(angle), np.cos(angle))])
    lifts = rng.random(len(points)) < (rng.uniform(0.02, 0.4) if kind in RANDOM and rng.random() < 0.4 else 0.0)
    depth = _depths(len(points), rng)
    program: list[tuple[str, dict]] = []
    for (x, y), z, lifted in zip(points, depth, lifts):
        if lifted or not program:
            program += [("G0", {"Z": CLEAR}), ("G0", {"X": x, "Y": y}), ("G1", {"Z": z, "F": FEED})]
        else:
            program.append(("G1", {"X": x, "Y": y, "Z": z, "F": FEED}))
    return [*program, ("G0", {"Z": CLEAR})]


def _depths(count, rng):
    """Return depths, mm: mostly one depth, otherwise noise, a random walk or a steady descent."""
    height = rng.uniform(1, 20)
    stray = (rng.uniform(size=count), np.abs(np.cumsum(rng.normal(size=count))), np.arange(count) + 1.0)
    which = rng.integers(0, 12)
    return DEPTH - (height * stray[which] / stray[which].max() if which < len(stray) else np.zeros(count))


def _count(rng) -> int:
    return int(rng.integers(60, 1500))


def _rolling(rng, radius, arm, turns):
    t = np.linspace(0, 2 * np.pi * rng.integers(5, 40), 2 * _count(rng))
    return np.column_stack([radius * np.cos(t) + arm * np.cos(turns * t), radius * np.sin(t) + arm * np.sin(turns * t)])
