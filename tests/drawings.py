# SPDX-License-Identifier: LGPL-2.1-or-later
"""Strokes for tests: lists of points (x, y, z), which programs.program cuts."""

from __future__ import annotations

import math

import numpy as np


def polygon(side, *, x=0.0, y=0.0, z=0.0, corners=4, turned=0.25, clockwise=False, ratio=1.0, climbs=0.0):
    """Return a closed polygon around (70 + x, y - 40), far from the origin, at which no drawing should begin.

    With four corners, the polygon is a rectangle of `side` by `side * ratio` mm, otherwise its width is `side`. Every
    second corner is higher by `climbs` mm.
    """
    r = side / math.sqrt(2) if corners == 4 else side / 2
    angles = [2 * math.pi * (i / corners + turned / 2) for i in range(corners + 1)]
    points = [
        (70 + x + r * math.cos(a), y - 40 + ratio * r * math.sin(a), z + climbs * (i % 2)) for i, a in enumerate(angles)
    ]
    return points[::-1] if clockwise else points


def arc(x=0.0, y=0.0, z=0.0, *, radius=10.0, turns=0.4, clockwise=False, drop=0.0):
    """Return an arc around (50 + x, y) in chords, which descends by `drop`."""
    sense = -1 if clockwise else 1
    angles = np.linspace(0, 2 * math.pi * turns, 25) * sense
    return [(50 + x + radius * math.cos(a), y + radius * math.sin(a), z - drop * i / 24) for i, a in enumerate(angles)]


def winding(first, last, turns, *, z=0.0, drop=0.0):
    """Return a spiral from one radius to another, or a helix if the radii are equal and the height drops."""
    angles = np.linspace(0, 2 * math.pi * turns, int(36 * turns) + 1)
    share = angles / angles[-1]
    radius = first + (last - first) * share
    return list(zip(70 + radius * np.cos(angles), -40 + radius * np.sin(angles), z - drop * share))
