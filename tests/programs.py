# SPDX-License-Identifier: LGPL-2.1-or-later
"""Valid programs of every strategy as lists of commands, for tests that rotate, mutate or repeat them."""

from __future__ import annotations

import math

FEED, CLEAR = 10.0, 10.0


def program(strokes):
    """Return the commands that cut each stroke, a list of points (x, y, z), with lifts between the strokes."""
    commands = [("(program)", {}), ("G0", {"Z": CLEAR})]
    for stroke in strokes:
        (x, y, z), *rest = stroke
        commands += [("G0", {"X": x, "Y": y}), ("G1", {"Z": z, "F": FEED})]
        commands += [("G1", {"X": x, "Y": y, "Z": z, "F": FEED}) for x, y, z in rest]
        commands.append(("G0", {"Z": CLEAR}))
    return commands


def zigzag(rows=10, length=50.0, step=3.0, depths=(0.0,)):
    """Return rows with alternating directions, each linked to the next row by a move along Y."""
    ends = [((0.0, length) if row % 2 == 0 else (length, 0.0)) for row in range(rows)]
    return program([[(x, row * step, z) for row in range(rows) for x in ends[row]] for z in depths])


def one_way(rows=10, length=50.0, step=3.0, depths=(0.0,)):
    """Return rows that are all cut in one direction, with a lift after each row."""
    return program([[(0.0, row * step, z), (length, row * step, z)] for z in depths for row in range(rows)])


def outline(sides=4, radius=30.0, z=0.0, start=0, waves=0.0, longer=0.0):
    """Return a closed polygon; its sides are wavy if `waves` is not 0, and it is `longer` mm longer along X.

    One half of the polygon is moved along X, so that the offsets of a polygon remain offsets of the longer polygon.
    """
    points = []
    for i in range(sides):
        angle = 2 * math.pi * (i + 0.1) / sides  # with an offset of 0.1 sides, no corner of the polygon is on an axis
        r = radius * (1 + waves * math.cos(3 * angle))
        points.append((r * math.cos(angle), r * math.sin(angle), z))
    if longer:
        top, bottom = max(points, key=lambda p: p[1]), min(points, key=lambda p: p[1])
        right = points[points.index(bottom) :] + points[: points.index(top) + 1]
        left = points[points.index(top) : points.index(bottom) + 1]
        points = [(x + longer / 2, y, z) for x, y, z in right] + [(x - longer / 2, y, z) for x, y, z in left]
    start %= len(points)
    return points[start:] + points[: start + 1]


def offsets(loops=6, sides=4, step=3.0, inner=4.0, depths=(0.0,), longer=0.0):
    """Return nested loops from the inside out, `step` mm apart, linked without a lift."""
    further = step / math.cos(math.pi / sides)
    return program([
        [p for i in range(loops) for p in outline(sides, inner + i * further, z=z, longer=longer)] for z in depths
    ])  # fmt: skip


def profile(sides=6, radius=30.0, depths=(0.0, -2.0, -4.0), waves=0.0):
    """Return one closed contour, equal at every depth."""
    return program([outline(sides, radius, z=z, waves=waves) for z in depths])


def waterline(levels=12, sides=24, radius=40.0, drop=1.0):
    """Return the contours of a cone with a wavy base."""
    return program([outline(sides, radius - 2 * i, z=-drop * i, waves=0.1) for i in range(levels)])


def spiral(turns=8, step=3.0, chords=48):
    """Return a spiral of Archimedes."""
    points = []
    for i in range(turns * chords + 1):
        angle = 2 * math.pi * i / chords
        r = 2.0 + step * i / chords
        points.append((r * math.cos(angle), r * math.sin(angle), 0.0))
    return program([points])


def helix(turns=8, radius=12.0, pitch=1.5):
    """Return a bore of half circles that descend, with a last turn around the bottom."""
    commands = [("G0", {"Z": CLEAR}), ("G0", {"X": radius, "Y": 0.0}), ("G1", {"Z": 0.0, "F": FEED})]
    side = 1
    for i in range(2 * turns + 2):
        z = -pitch / 2 * min(i + 1, 2 * turns)
        commands.append(("G2", {"X": -side * radius, "Y": 0.0, "Z": z, "I": -side * radius, "J": 0.0, "F": FEED}))
        side = -side
    return [*commands, ("G0", {"Z": CLEAR})]


def drilling(columns=5, rows=4, pitch=12.0, cycle="G83"):
    """Return holes drilled by a canned cycle."""
    commands = [("G0", {"Z": CLEAR}), ("G90", {}), ("G98", {})]
    words = {"Z": -15.0, "R": 2.0, "F": FEED}
    if cycle in ("G73", "G83"):
        words["Q"] = 3.0
    holes = [{"X": pitch * column, "Y": pitch * row} for row in range(rows) for column in range(columns)]
    return [*commands, *((cycle, {**hole, **words}) for hole in holes), ("G80", {}), ("G0", {"Z": CLEAR})]


def adaptive(bites=40, radius=8.0, step=1.0):
    """Return a trochoid: circles that move forward by a small step."""
    points = []
    for i in range(bites * 16):
        angle = 2 * math.pi * i / 16
        points.append((step * i / 16 + radius * math.cos(angle), radius * math.sin(angle), 0.0))
    return program([points])


def engraving(letters=14):
    """Return short strokes like engraved letters, each with a different shape."""
    strokes = []
    for i in range(letters):
        x, lean = 9.0 * i, 0.4 * i
        strokes.append([(x, 0.0, -0.2), (x + lean, 8.0, -0.2), (x + 5 - lean / 3, 3.0 + lean / 4, -0.2)])
        strokes.append([(x + 1, 2.0 + lean / 5, -0.2), (x + 5 - lean / 2, 2.0, -0.2)])
    return program(strokes)


SOUND = {
    "zigzag": zigzag, "one-way": one_way, "contour-parallel": offsets, "profile": profile, "waterline": waterline,
    "spiral": spiral, "helix": helix, "drilling": drilling, "adaptive": adaptive, "engraving": engraving,
}  # fmt: skip
