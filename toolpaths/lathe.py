# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make toolpaths of a lathe in X and Z, which have no milling strategy, as G-code commands.

No toolpath consists only of a facing cut, a groove or a finishing pass, because a mill can cut a slot in X and Z with
the same moves. The functions that make toolpaths have the same form as in synthetic.py. SAMPLES lists (label,
strategies that count as right, function).
"""

from __future__ import annotations

import numpy as np

FEED = 3.0  # mm/s
CLEAR = 2.0  # distance of rapids in front of the face, mm


class Turning:
    """The commands of a lathe program; the tool begins in front of the part, and X is a diameter."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.diameter, self.length = rng.uniform(15, 120), rng.uniform(10, 120)
        self.commands: list[tuple[str, dict[str, float]]] = []
        self.rapid(self.diameter + 4, CLEAR)

    def rapid(self, x: float, z: float) -> None:
        self.commands.append(("G0", {"X": round(x, 3), "Z": round(z, 3)}))

    def cut(self, x: float, z: float) -> None:
        self.commands.append(("G1", {"X": round(x, 3), "Z": round(z, 3), "F": FEED}))


def steps_of(rng, part: Turning) -> list[tuple[float, float]]:
    """Return the corners (x, z) of a finished part from front to rear, with growing diameters."""
    count = int(rng.integers(1, 6))
    x = np.sort(rng.uniform(0.2, 0.95, count)) * part.diameter
    z = -np.sort(rng.uniform(0.05, 1.0, count)) * part.length
    corners, tapered = [(float(x[0]), 0.0)], rng.random() < 0.5
    for k in range(count):
        corners.append((float(x[k]), float(z[k])))
        if k + 1 < count:
            back = (z[k + 1] - z[k]) * rng.uniform(0.1, 0.6) if tapered else 0.0
            corners.append((float(x[k + 1]), float(z[k] + back)))
    return [*corners, (part.diameter, corners[-1][1])]


def depth_at(corners, x: float) -> float:
    """Return the z coordinate at which a pass at the diameter `x` meets the finished part."""
    for (x0, z0), (x1, z1) in zip(corners, corners[1:]):
        if x0 <= x < x1:
            return z0 + (z1 - z0) * (x - x0) / (x1 - x0)
    return corners[-1][1]


def rough(rng, part: Turning, corners) -> None:
    """Cut passes along Z until they meet the finished part. Each pass ends with a short move outwards."""
    step, out = rng.uniform(0.5, 4.0), rng.choice([0.5, 1.0, 2.0])
    fed = rng.random() < 0.3
    for x in np.arange(part.diameter - step, corners[0][0], -step):
        part.rapid(x, CLEAR)
        if fed:
            part.cut(x, CLEAR - 0.5)
        z = depth_at(corners, x)
        part.cut(x, z)
        if fed or rng.random() < 0.5:
            part.cut(x + step, z)
        part.cut(x + step + out, z + out / 2)
        part.rapid(x + step + out, CLEAR)


def finish(rng, part: Turning, corners) -> None:
    """Cut along the contour of the finished part."""
    part.rapid(max(0.0, corners[0][0] - 2), CLEAR)
    for x, z in corners:
        part.cut(x, z)
    part.cut(part.diameter + 2, corners[-1][1])
    part.rapid(part.diameter + 4, CLEAR)


def face(rng, part: Turning) -> None:
    """Cut one or several passes along X to the axis."""
    for k in range(int(rng.integers(1, 6))):
        part.rapid(part.diameter + 2, CLEAR - 0.5 * k)
        part.cut(-1.0, CLEAR - 0.5 * k)
        part.rapid(-1.0, CLEAR + 1)


def roughing(rng):
    part = Turning(rng)
    rough(rng, part, steps_of(rng, part))
    return part.commands


def whole_part(rng):
    """Facing cuts, then roughing passes, then a finishing pass."""
    part = Turning(rng)
    corners = steps_of(rng, part)
    if rng.random() < 0.7:
        face(rng, part)
    rough(rng, part, corners)
    part.rapid(part.diameter + 50, 100)
    finish(rng, part, corners)
    part.rapid(part.diameter + 50, 100)
    return part.commands


SAMPLES = tuple((f"lathe: {make.__name__}", {"unknown"}, make) for make in (roughing, whole_part))
