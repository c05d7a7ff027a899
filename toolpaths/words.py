# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make words in a single-stroke font, as used for engraving."""

from __future__ import annotations

import math

import numpy as np

from toolpaths.synthetic import Program, depths

# The strokes of each letter, separated by commas. Each pair of digits is a point x, y on a grid of 4 by 6.
FONT = {
    "A": "00 26 40,12 32", "B": "00 06 36 45 44 33 03,33 42 41 30 00", "C": "45 36 16 05 01 10 30 41",
    "D": "00 06 26 44 42 20 00", "E": "46 06 00 40,03 33", "F": "46 06 00,03 33", "G": "45 36 16 05 01 10 30 41 43 23",
    "H": "06 00,46 40,03 43", "I": "26 20", "J": "46 41 30 10 01", "K": "06 00,46 03 40", "L": "06 00 40",
    "M": "00 06 23 46 40", "N": "00 06 40 46", "O": "10 01 05 16 36 45 41 30 10", "P": "00 06 36 45 44 33 03",
    "Q": "10 01 05 16 36 45 41 30 10,22 40", "R": "00 06 36 45 44 33 03,23 40", "S": "45 36 16 05 04 13 33 42 41 30 10 01",
    "T": "06 46,26 20", "U": "06 01 10 30 41 46", "V": "06 20 46", "W": "06 10 24 30 46", "X": "06 40,46 00",
    "Y": "06 23 46,23 20", "Z": "06 46 00 40", "1": "05 26 20", "2": "05 16 36 45 44 00 40", "3": "06 46 23 33 42 41 30 10 01",
    "4": "30 36 02 42", "7": "06 46 10", "8": "13 04 05 16 36 45 44 33 13 02 01 10 30 41 42 33",
}  # fmt: skip
ROUND = frozenset("BCDGJOPQRSU238")


def rounded(path: np.ndarray) -> np.ndarray:
    """Return the path with its corners cut twice (Chaikin)."""
    for _ in range(2):
        a, b = path[:-1], path[1:]
        between = np.stack([0.75 * a + 0.25 * b, 0.25 * a + 0.75 * b], axis=1).reshape(-1, 2)
        path = np.vstack([path[:1], between[1:-1], path[-1:]])
    return path


def word(rng, *, most=13):
    """A word of random letters along a line in a random direction, at one or two depths.

    The letters are upright or slanted, and round or angular.
    """
    p = Program(rng)
    size = np.exp(rng.uniform(np.log(0.4), np.log(8)))
    angle = rng.choice([0.0, rng.uniform(0, 2 * np.pi)])
    wide, slant, pitch = rng.uniform(0.6, 1.2), rng.choice([0.0, rng.uniform(0, 0.3)]), rng.uniform(4.8, 6.5)
    is_round, backwards = rng.random() < 0.5, rng.random(40) < rng.choice([0.0, 0.4])
    letters = rng.choice(list(FONT), int(rng.integers(3, most))).tolist()
    for z in depths(rng, 2):
        for at, letter in enumerate(letters):
            for k, stroke in enumerate(FONT[letter].split(",")):
                path = np.array([(int(x), int(y)) for x, y in stroke.split()], float)
                if is_round and letter in ROUND:
                    path = rounded(path)
                if backwards[(7 * at + k) % len(backwards)]:
                    path = path[::-1]
                x, y = wide * (path[:, 0] + pitch * at) + slant * path[:, 1], path[:, 1]
                c, s = math.cos(angle), math.sin(angle)
                p.cut(size * np.column_stack([c * x - s * y, s * x + c * y]), 0.2 * z)
    return p.commands
