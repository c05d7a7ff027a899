# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make nonsense toolpaths by random rules. Each function returns points (k, 2) of a random curve of its kind."""

from __future__ import annotations

import numpy as np

from toolpaths.turtle import grow


def _random_word(rng: np.random.Generator, forward: int) -> str:
    """Return a rule with `forward` steps, and with a turn to the left, to the right or no turn before each step."""
    turns = rng.choice(["", "+", "-", "++", "--"], forward, p=[0.2, 0.3, 0.3, 0.1, 0.1])
    return "".join(f"{turn}F" for turn in turns) + str(rng.choice(["", "+", "-"]))


def _grown(rng: np.random.Generator, start: str, angle: float) -> np.ndarray:
    """Return a curve whose steps are replaced by a random rule, until it has some hundreds of steps."""
    forward = int(rng.integers(3, 9))
    times = int(np.log(rng.uniform(100, 1500) / start.count("F")) / np.log(forward))
    return grow(start, {"F": _random_word(rng, forward)}, angle, max(times, 2), "F")


def right_angled_replacements(rng):
    return _grown(rng, "F", 90)


def slanted_replacements(rng):
    return _grown(rng, "F", float(rng.choice([45, 60, 72, 120])))


def shuffled_bits(rng):
    """The cells of a grid, ordered by the bits of their coordinates in a random order of the bits."""
    bits = int(rng.integers(6, 11))
    number = np.arange(2**bits)
    if rng.random() < 0.4:
        number ^= number >> 1  # converts the numbers to a Gray code
    of = (number[:, None] >> rng.permutation(bits)) & 1
    half = bits // 2
    return np.column_stack([of[:, :half] @ (1 << np.arange(half)), of[:, half:] @ (1 << np.arange(bits - half))]) * 1.0


def sorted_cells(rng):
    """The cells of a grid, or random points, sorted by the value of a sum of three plane waves."""
    side = int(rng.integers(8, 35))
    cells = np.stack(np.meshgrid(np.arange(side), np.arange(side)), axis=-1).reshape(-1, 2) * 1.0
    if rng.random() < 0.5:
        cells = rng.uniform(0, side, cells.shape)
    waves = rng.normal(0, rng.uniform(0.1, 1.0), (3, 2))
    key = np.cos(cells @ waves.T + rng.uniform(0, 6, 3)) @ rng.normal(size=3)
    return cells[np.argsort(key)]


def rotors(rng):
    """The sum of several arms that rotate at different whole speeds, so that the curve closes."""
    count = int(rng.integers(2, 6))
    speed = rng.choice(np.delete(np.arange(-25, 26), 25), count, replace=False)
    arm = rng.uniform(0.2, 1.0, count) / np.abs(speed) ** rng.uniform(0, 1)
    t = np.linspace(0, 2 * np.pi, int(rng.integers(300, 2500)))
    way = np.exp(1j * (np.outer(t, speed) + rng.uniform(0, 6, count))) @ arm
    return np.column_stack([way.real, rng.uniform(0.3, 1.0) * way.imag])


def linked_circles(rng):
    """Circles, half circles or other arcs of random sizes. Each arc begins where the arc before it ends."""
    found, at = [], 0j
    share = rng.choice([0.25, 0.5, 1.0, 1.5])
    for _ in range(int(rng.integers(12, 60))):
        radius, start = rng.exponential(1.0) + 0.1, rng.uniform(0, 2 * np.pi)
        t = start + rng.choice([-1, 1]) * np.linspace(0, 2 * np.pi * share, 24)
        arc = at + radius * (np.exp(1j * t) - np.exp(1j * start))
        found.append(arc)
        at = arc[-1]
    way = np.concatenate(found)
    return np.column_stack([way.real, way.imag])


def shifted_copies(rng):
    """A short random figure, repeated with the same turn and the same change of size each time."""
    figure = np.cumsum(rng.normal(size=(int(rng.integers(3, 12)), 2)) @ (1, 1j))
    turn = np.exp(1j * rng.uniform(0.2, 3.0)) * rng.choice([1.0, rng.uniform(0.97, 1.03)])
    count = int(rng.integers(20, 120))
    way = np.concatenate([figure * turn**k for k in range(count)])
    return np.column_stack([way.real, way.imag])


KINDS = (
    right_angled_replacements, slanted_replacements, shuffled_bits, sorted_cells, rotors, linked_circles, shifted_copies,
)  # fmt: skip
