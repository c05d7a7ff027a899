# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where rays pass through the volume a tool sweeps along a straight move.

A tool (a convex solid of revolution, unbounded upwards) moved along a straight line sweeps a convex volume,
so a ray meets it in one interval. Everything here is in ray coordinates: x to the right of the image, y the
horizontal direction the rays go, z up; a ray at (x, y, z) runs along (0, sine, -cosine) of the view's tilt.

The interval's ends are extremes over the move's parameter t of the tool's own interval at the position t. The
extremes lie at an end of the move, or where the ray touches a side face of the swept volume, or on the edge
between two faces; these few t are known in closed form (bull-nose: by bisection of a monotone function) and
the tool's interval is taken at each of them.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from zbuffer_reference.rounded import ball_chord, ball_sides, divide, rounded_chord, rounded_sides

from vkworkbench.core import Tool

# Ends closer than this, mm, are one: an edge of the swept volume is met in a single point, give or take
# rounding.
_ROUNDING = 1e-7


def lowest(tool: Tool, start: np.ndarray, move: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Height of the lower surface of the swept volume above points of the plane.

    Parameters
    ----------
    tool : Tool
    start, move : (3, k) ndarray
        Where the tip starts and how it moves, mm; vertical moves upwards only.
    x, y : (k,) ndarray
        The points.

    Returns
    -------
    (k,) ndarray
        Height z, mm; infinite where the tool does not pass.
    """
    run = np.sqrt(move[0] ** 2 + move[1] ** 2)
    moving = run > 0
    safe_run = np.where(moving, run, 1.0)
    ux, uy = np.where(moving, move[0] / safe_run, 1.0), move[1] / safe_run
    slope = np.where(moving, move[2] / safe_run, 0.0)
    px, py = x - start[0], y - start[1]
    along = px * ux + py * uy
    aside2 = (py * ux - px * uy) ** 2
    half2 = tool.radius**2 - aside2
    half = np.sqrt(np.maximum(half2, 0))
    # Range of the tool axis along the move, relative to the foot of the point.
    first = np.maximum(-along, -half)
    last = np.minimum(run - along, half)
    position = np.minimum(np.maximum(_lowest_position(tool, slope, aside2, half, first, last), first), last)
    height = start[2] + slope * (along + position) + _profile(tool, np.sqrt(aside2 + position**2))
    return np.where((half2 >= 0) & (first <= last), height, np.inf)


def _profile(tool: Tool, r: np.ndarray) -> np.ndarray:
    """Tool.height without its end at the rim, where rounding would make points of the rim infinite."""
    corner = tool.rounding
    if corner == 0:
        return tool.steepness * r
    beyond_flat = np.clip(r - (tool.radius - corner), 0, corner)
    return corner - np.sqrt(corner**2 - beyond_flat**2)


def _lowest_position(
    tool: Tool, slope: np.ndarray, aside2: np.ndarray, half: np.ndarray, first: np.ndarray, last: np.ndarray
) -> np.ndarray:
    """Where on the move the tool is lowest above a point: the minimum of slope * v + profile(r(v))."""
    if not slope.any():
        return np.zeros_like(slope)
    if tool.rounding == tool.radius:
        return -slope * half / np.sqrt(1 + slope**2)
    if tool.rounding == 0:
        steeper = tool.steepness**2 - slope**2
        inner = -slope * np.sqrt(aside2 / np.where(steeper > 0, steeper, 1))
        return np.where(steeper > 0, inner, np.where(slope > 0, first, last))
    low, high = first.copy(), last.copy()
    flat = tool.radius - tool.rounding
    for _ in range(48):
        middle = (low + high) / 2
        r = np.sqrt(aside2 + middle**2)
        beyond = np.clip(r - flat, 0, tool.rounding)
        # d/dv of the profile, multiplied by its positive denominator.
        rising = beyond * middle + slope * r * np.sqrt(tool.rounding**2 - beyond**2) > 0
        high = np.where(rising, middle, high)
        low = np.where(rising, low, middle)
    return (low + high) / 2


def intervals(
    tool: Tool, start: np.ndarray, move: np.ndarray, ray: np.ndarray, sine: float, cosine: float
) -> tuple[np.ndarray, np.ndarray]:
    """Where tilted rays enter and leave the swept volume.

    Parameters
    ----------
    tool : Tool
    start, move : (3, k) ndarray
        Where the tip starts and how it moves, in ray coordinates, mm.
    ray : (3, k) ndarray
        A point of each ray, in ray coordinates.
    sine, cosine : float
        Of the view's tilt from the vertical; ``sine > 0``.

    Returns
    -------
    near, far : (k,) ndarray
        Depths along the ray, mm; ``near > far`` where it misses.
    """
    offset = ray - start
    ends = [np.zeros(offset.shape[1]), np.ones(offset.shape[1])]
    corner = tool.rounding
    near, far = _extremes(
        ends + _straight_sides(tool, corner, offset, move, sine, cosine),
        offset,
        move,
        lambda at: _straight_chord(tool, corner, at, sine, cosine),
    )
    if corner > 0:
        raised = offset - np.array([[0.0], [0.0], [corner]])
        if corner == tool.radius:
            sides = ball_sides(tool, raised, move, sine, cosine)
            chord = ball_chord
        else:
            sides = rounded_sides(tool, raised, move, sine, cosine)
            chord = rounded_chord
        near2, far2 = _extremes(ends + sides, raised, move, lambda at: chord(tool, at, sine, cosine))
        near, far = np.minimum(near, near2), np.maximum(far, far2)
    return near, far


def _extremes(
    parameters: list[np.ndarray],
    offset: np.ndarray,
    move: np.ndarray,
    chord: Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]],
) -> tuple[np.ndarray, np.ndarray]:
    """First entry and last exit of the tool standing at the given parameters of its move."""
    near = np.full(offset.shape[1], np.inf)
    far = -near
    for t in parameters:
        enter, leave = chord(offset - np.clip(t, 0, 1) * move)
        hit = enter <= leave + _ROUNDING
        np.minimum(near, enter, out=near, where=hit)
        np.maximum(far, leave, out=far, where=hit)
    return near, far


def _straight_chord(
    tool: Tool, base: float, at: np.ndarray, sine: float, cosine: float
) -> tuple[np.ndarray, np.ndarray]:
    """Depths at which a ray passes a standing cylinder that starts at height `base` or ends in a cone."""
    x, y, z = at
    tangent = cosine / sine if abs(cosine) > 1e-9 else 0.0
    half = np.sqrt(np.maximum(tool.radius**2 - x**2, 0))
    low = np.where(np.abs(x) <= tool.radius, -half, np.inf)
    # Along the ray height = level - tangent * y, y measured from the tool's axis.
    level = z + tangent * y - base + _ROUNDING
    if tool.steepness > 0:
        cone_low, cone_high = _cone_chord(tool.steepness, tangent, x, level)
        low, high = np.maximum(low, cone_low), np.minimum(half, cone_high)
    elif tangent > 0:
        high = np.minimum(half, level / tangent)
    elif tangent < 0:
        low, high = np.maximum(low, level / tangent), half
    else:
        high = np.where(level >= 0, half, -np.inf)
    return (low - y) / sine, (high - y) / sine


def _cone_chord(k: float, tangent: float, x: np.ndarray, level: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Interval of y with ``k * hypot(x, y) <= level - tangent * y``."""
    # a y^2 + 2 b y + c = 0, solved without a difference of what is about equal.
    a, b, c = (k - abs(tangent)) * (k + abs(tangent)) or 1e-300, level * tangent, k**2 * x**2 - level**2
    q = -b - np.copysign(k * np.sqrt(np.maximum(level**2 - a * x**2, 0)), b)
    with np.errstate(divide="ignore", invalid="ignore"):
        ends = q / a, np.where(q != 0, c / q, 0.0)
    low, high = np.minimum(*ends), np.maximum(*ends)
    if a > 0:
        inside = (level**2 >= a * x**2) & (level >= 0)
        return np.where(inside, low, np.inf), high
    # The ray is steeper than the cone: it stays inside once inside, on the side where it goes up.
    endless = np.full_like(x, np.inf)
    return (-endless, low) if tangent > 0 else (high, endless)


def _straight_sides(
    tool: Tool, base: float, offset: np.ndarray, move: np.ndarray, sine: float, cosine: float
) -> list[np.ndarray]:
    """Parameters at which a ray may enter or leave a swept cylinder or cone between the move's ends."""
    x, y, z = offset
    ux, uy, uz = move
    run = np.hypot(ux, uy)
    safe_run = np.where(run > 0, run, 1)
    # The two vertical side faces.
    reach = tool.radius * uy / safe_run
    sides = [divide(x + reach, ux), divide(x - reach, ux)]
    # The swept rim, where cylinder and bottom (or cone) meet.
    tilted = cosine * y + sine * (z - base - tool.steepness * tool.radius)
    tilted_move = cosine * uy + sine * uz
    square = (cosine * ux) ** 2 + tilted_move**2
    middle = cosine**2 * x * ux + tilted * tilted_move
    rest = cosine**2 * (x**2 - tool.radius**2) + tilted**2
    root = np.sqrt(np.maximum(middle**2 - square * rest, 0))
    sides += [divide(middle - root, square), divide(middle + root, square)]
    if tool.steepness > 0:
        # The two planes that touch the cone all along the move.
        k = tool.steepness
        cos_touch = np.clip(uz / (k * safe_run), -1, 1)
        sin_touch = np.sqrt(1 - cos_touch**2)
        tilted = cosine * y + sine * z
        for sign in (1, -1):
            ex = (cos_touch * ux - sign * sin_touch * uy) / safe_run
            ey = (cos_touch * uy + sign * sin_touch * ux) / safe_run
            e2 = cosine * ey + sine * k
            sides.append(divide(x * e2 - tilted * ex, ux * e2 - tilted_move * ex))
    return sides
