# SPDX-License-Identifier: LGPL-2.1-or-later
"""Approximate the splines of LinuxCNC (G5, G5.1) by chords."""

from __future__ import annotations

from math import ceil, sqrt
from typing import List

import numpy as np

from vkworkbench.core.gcode.moves.codes import SPLINES

_CUBIC, _QUADRATIC = SPLINES
_WORDS = {_CUBIC: frozenset("IJPQ"), _QUADRATIC: frozenset("IJ")}
_TOLERANCE = 0.002  # mm, largest distance between a spline and its chords
_MOST_CHORDS = 1000
Point = List[float]


def is_complete(code: int, words: dict[str, float]) -> bool:
    """Return whether a line contains all words for the control points of its spline, and an X or Y word."""
    return _WORDS[code] <= words.keys() and not {"X", "Y"}.isdisjoint(words)


def chords(code: int, words: dict[str, float], start: Point, end: Point) -> np.ndarray:
    """Return the end points of the chords of a spline, (n, k) mm.

    Parameters
    ----------
    code : int
        50 for G5 (cubic) or 51 for G5.1 (quadratic).
    words : dict
        I and J are the vector from the start to the first control point, mm. P and Q of G5 are the vector from the end
        to the second control point, mm.
    start, end : list of float
        The end points of the spline, mm. The first two axes are X and Y; other axes move at constant speed.
    """
    first, last = np.array(start), np.array(end)
    leave, arrive = np.zeros(len(start)), np.zeros(len(start))
    leave[:2] = words["I"], words["J"]
    if code == _QUADRATIC:
        control = first + leave
        controls = [first, first + 2 / 3 * (control - first), last + 2 / 3 * (control - last), last]
    else:
        arrive[:2] = words["P"], words["Q"]
        controls = [first, first + leave, last + arrive, last]
    controls[1][2:] = (2 * first[2:] + last[2:]) / 3
    controls[2][2:] = (first[2:] + 2 * last[2:]) / 3
    bend = max(float(np.abs(controls[i] - 2 * controls[i + 1] + controls[i + 2]).sum()) for i in (0, 1))
    count = min(max(ceil(sqrt(6 * bend / (8 * _TOLERANCE))), 1), _MOST_CHORDS)
    t = np.arange(1, count + 1)[:, None] / count
    weights = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3)
    return sum(weight * point for weight, point in zip(weights, controls))
