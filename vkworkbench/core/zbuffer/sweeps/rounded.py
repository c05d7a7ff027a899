# SPDX-License-Identifier: LGPL-2.1-or-later
"""Intersect rays with rounded discs, which are the tips of bull-nose mills.

A disc is stationary or moves along a straight line. The coordinates are the ray coordinates of intervals.py, but
heights are measured from the centre of the corner rounding.
"""

from __future__ import annotations

import numpy as np

from vkworkbench.core.tool import Tool
from vkworkbench.core.zbuffer.sweeps.slots import FROM_THE_SIDE, RIM, ROUNDING

# Distance between the ray's point and the disc's surface, mm, at which Newton's method stops. With a smaller distance,
# rounding errors would prevent the method from stopping; with a larger distance, the depths would be less exact.
_CLOSE = 1e-10


def _ball_chord(tool: Tool, at: np.ndarray, sine: float, cosine: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the depths at which rays enter and leave the ball that encloses the rounded disc."""
    x, y, z = at
    middle = cosine * z - sine * y
    half2 = tool.radius**2 - x**2 - (cosine * y + sine * z) ** 2
    half = np.sqrt(np.maximum(half2, 0))
    return np.where(half2 >= 0, middle - half, np.inf), middle + half


def _box_chord(tool: Tool, at: np.ndarray, sine: float, cosine: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the depths at which rays enter and leave the upright cylinder that encloses the rounded disc."""
    x, y, z = at
    half2 = tool.radius**2 - x**2
    half = np.sqrt(np.maximum(half2, 0))
    near, far = np.where(half2 >= -RIM, (-half - y) / sine, np.inf), (half - y) / sine
    if abs(cosine) > FROM_THE_SIDE:
        face = np.copysign(tool.rounding, cosine)
        return np.maximum(near, (z - face) / cosine), np.minimum(far, (z + face) / cosine)
    return np.where(np.abs(z) <= tool.rounding, near, np.inf), far


def rounded_chord(
    tool: Tool, at: np.ndarray, sine: float, cosine: float, known_near: np.ndarray, known_far: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the depths at which rays enter and leave a stationary rounded disc.

    The distance between a point of the ray and the disc is a convex function of the point's depth. Therefore Newton's
    method converges monotonically when it starts where the ray enters and leaves the ball around the rounded disc. The
    function computes an entry only if the entry can be before `known_near`, and an exit only if the exit can be deeper
    than `known_far`.
    """
    first, last = _box_chord(tool, at, sine, cosine)
    near, far = _ball_chord(tool, at, sine, cosine)
    met = (first <= last + ROUNDING) & (near <= far)
    for ahead, depths, bound, wanted in ((1.0, near, first, first < known_near), (-1.0, far, last, last > known_far)):
        depths[~wanted] = bound[~wanted]
        active = np.flatnonzero(met & wanted)
        for _ in range(40):
            x, y, z = at[:, active]
            s = depths[active]
            y, z = y + s * sine, z - s * cosine
            r = np.sqrt(x * x + y * y)  # np.hypot would take several times as long
            beyond = np.maximum(r - (tool.radius - tool.rounding), 0)
            distance = np.sqrt(beyond * beyond + z * z)
            fall = -ahead * (sine * y * divide(beyond, r) - cosine * z)
            outside = distance > tool.rounding + _CLOSE
            # A ray misses the disc if the current point of the ray is outside the disc and the distance from the disc
            # does not decrease along the ray.
            met[active[outside & (fall <= 0)]] = False
            moving = outside & (fall > 0)
            if not moving.any():
                break
            active = active[moving]
            depths[active] += (ahead * (distance - tool.rounding) * distance)[moving] / fall[moving]
    return np.where(met, near, np.inf), far


def rounded_sides(tool: Tool, offset: np.ndarray, move: np.ndarray, sine: float, cosine: float) -> list[np.ndarray]:
    """Return the positions t, from 0 to 1 on the move, at which rays enter or leave the side of a swept rounded disc.

    In a projection along the move, the disc has an oval contour and the ray is a straight line. Consider the point of
    the contour that has a given normal: while the normal turns by pi, the point moves across the line in one direction.
    Therefore bisection over the normal finds the point where the line crosses the contour.
    """
    ux, uy, uz = move
    run = np.hypot(ux, uy)
    length = np.sqrt(run**2 + uz**2)
    safe_run, safe_length = np.where(run > 0, run, 1), np.where(length > 0, length, 1)
    sin_m, cos_m = uz / safe_length, run / safe_length
    ex, ey = np.where(run > 0, ux / safe_run, 1.0), uy / safe_run
    flat, corner = tool.radius - tool.rounding, tool.rounding
    x, y, z = offset

    # The projection along the move has two axes perpendicular to the move: the axis of `across` is horizontal, and the
    # axis of `above` points upwards.
    across, above = y * ex - x * ey, z * cos_m - (x * ex + y * ey) * sin_m
    ray_across, ray_above = sine * ex, -cosine * cos_m - sine * ey * sin_m
    speed = np.hypot(ray_across, ray_above)
    # Unit normal (na, nb) of the ray's line in the projection, and the distance of the line from the disc's centre.
    na, nb = np.where(speed > 0, -divide(ray_above, speed), 1.0), divide(ray_across, speed)
    line = across * na + above * nb

    def contact(c: np.ndarray, s: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the contour point with the outward normal (c, s): its coordinates across, above and along the move."""
        share = divide(flat, np.sqrt(c**2 + (s * sin_m) ** 2))
        return (share + corner) * c, (share * sin_m**2 + corner) * s, -share * s * sin_m * cos_m

    sides = []
    for turn in (1.0, -1.0):
        c0, s0, c1, s1 = na, nb, -na, -nb
        c, s = -turn * nb, turn * na
        for _ in range(14):
            a, b, _along = contact(c, s)
            beyond = a * na + b * nb > line
            c0, s0 = np.where(beyond, c, c0), np.where(beyond, s, s0)
            c1, s1 = np.where(beyond, c1, c), np.where(beyond, s1, s)
            c, s = c0 + c1, s0 + s1
            norm = np.sqrt(c**2 + s**2)
            c, s = c / norm, s / norm
        # Interpolate linearly: the contour is nearly straight between the two normals that the bisection found.
        first, last = contact(c0, s0), contact(c1, s1)
        height0 = first[0] * na + first[1] * nb
        height1 = last[0] * na + last[1] * nb
        share = np.clip(divide(height0 - line, height0 - height1), 0, 1)
        a, b, along = (p + share * (q - p) for p, q in zip(first, last))
        s = divide((a - across) * ray_across + (b - above) * ray_above, speed**2)
        here = (x * ex + (y + s * sine) * ey) * cos_m + (z - s * cosine) * sin_m
        sides.append(divide(here - along, length))
    return sides


def divide(a: np.ndarray | float, b: np.ndarray) -> np.ndarray:
    """Return a / b, or 0 if b is 0."""
    zero = b == 0
    return np.where(zero, 0.0, a / np.where(zero, 1.0, b))
