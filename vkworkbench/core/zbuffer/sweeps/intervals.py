# SPDX-License-Identifier: LGPL-2.1-or-later
"""Intersect rays with the volume that a tool sweeps along a straight move.

A tool is modelled as a convex solid of revolution that is unbounded upwards. The volume that the tool sweeps along a
straight move is convex, so a ray intersects the swept volume in one interval. In ray coordinates, the x axis points to
the right in the image, the y axis in the horizontal direction of the rays, and the z axis up. Every ray has the
direction (0, sine, -cosine), with the sine and cosine of the angle between the view and the vertical.

For flat and ball ends, slots.py computes the interval in closed form. For other tools, let t from 0 to 1 be the
position of the tool on its move. At each position t of the tool, the ray enters the tool at one depth and leaves it at
another. The interval of the swept volume begins at the smallest of all entry depths and ends at the largest of all exit
depths. The position t for the smallest entry or the largest exit is an end of the move, a t where the ray touches a
side face of the swept volume, or a t where the ray meets the edge between two faces. Closed forms give a few candidates
for the position t. For bull-nose mills, the candidates are found by bisection of a monotone function. The entry and the
exit are then computed at each candidate. For short moves, the ends of the move are usually the right candidates.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from vkworkbench.core.tool import Tool
from vkworkbench.core.zbuffer.sweeps.rounded import divide, rounded_chord, rounded_sides
from vkworkbench.core.zbuffer.sweeps.slots import FROM_THE_SIDE, RIM, ROUNDING, ball_slot, level_slot, sloped_slot


def lowest(
    tool: Tool, start: np.ndarray, heading: np.ndarray, x: np.ndarray, y: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the height of the swept volume's lower surface above points of the xy plane.

    Parameters
    ----------
    start : (3, k) ndarray
        Position of the tool's tip at the start of each move, mm.
    heading : (4, k) ndarray
        Direction, length and slope of each move; see :func:`headings`.
    x, y : ndarray
        Coordinates of the points, mm, in any shape that broadcasts with (k,).

    Returns
    -------
    height : ndarray
        Height z of the lower surface, mm; NaN where the tool does not pass over the point.
    inner : ndarray
        Distance from the point to the boundary of the area that the tool passes over, mm, measured along the move:
        about 0 at the boundary, negative or NaN outside. For a ball, `inner` is instead half the length of the vertical
        chord of the ball above the point.
    """
    ux, uy, run, slope = heading
    px, py = x - start[0], y - start[1]
    along, aside2 = px * ux + py * uy, py * ux - px * uy
    aside2 *= aside2
    half = tool.radius**2 - aside2
    with np.errstate(invalid="ignore"):
        np.sqrt(half, out=half)  # NaN where the tool does not pass over the point
        if tool.rounding == tool.radius:
            return _lowest_of_ball(tool.radius, start[2], run, slope, along, half)
        ahead = run - along
        # The foot is the point's perpendicular projection on the line of the move. Measured from the foot along the
        # line of the move, the tool's axis moves from -along to ahead. The tool is above the point while its axis is at
        # most `half` away from the foot.
        at = along + _lowest_position(tool, slope, aside2, half)
        np.minimum(np.maximum(at, 0, out=at), run, out=at)
        np.minimum(along, ahead, out=ahead)
        np.minimum(ahead, 0, out=ahead)
        inner = np.add(ahead, half, out=half)
        missed = ~(inner >= 0)
        if tool.rounding or tool.steepness:
            along -= at
            along *= along
            along += aside2
            at *= slope
            at += tool.profile(np.sqrt(along))
        else:
            at *= slope
    at += start[2]
    np.copyto(at, np.nan, where=missed)
    return at, inner


def _lowest_of_ball(
    radius: float, start: np.ndarray, run: np.ndarray, slope: np.ndarray, along: np.ndarray, half: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Compute `lowest` for a ball whose tip starts at the height `start`; overwrite `along` and `half`.

    The square root is NaN where the ball does not pass over the point, so the function needs no mask.
    """
    at = half * (-slope / np.sqrt(1 + slope**2))
    at += along
    np.minimum(np.maximum(at, 0, out=at), run, out=at)
    along -= at
    left = half - along
    along += half
    left *= along
    np.sqrt(left, out=left)
    at *= slope
    at -= left
    at += start + radius
    return at, left


def headings(move: np.ndarray) -> np.ndarray:
    """Return an array (4, k) for moves (3, k): x and y of the unit direction, length in the xy plane, mm, and slope.

    A vertical move gets the direction (1, 0) and the slope 0.
    """
    run = np.sqrt(move[0] ** 2 + move[1] ** 2)
    moving = run > 0
    safe_run = np.where(moving, run, 1.0)
    ux, uy = np.where(moving, move[0] / safe_run, 1.0), move[1] / safe_run
    return np.array([ux, uy, run, np.where(moving, move[2] / safe_run, 0.0)])


def _lowest_position(tool: Tool, slope: np.ndarray, aside2: np.ndarray, half: np.ndarray) -> np.ndarray:
    """Return the position, relative to the point's foot, at which the moving tool is lowest above the point, mm.

    The position v is between -half and half and minimises ``slope * v + profile(sqrt(aside2 + v * v))``.
    """
    if not slope.any():
        return np.zeros_like(slope)
    position: np.ndarray
    if tool.rounding == 0 and tool.steepness == 0:
        position = half * -np.sign(slope)
        return position
    if tool.rounding == 0:
        steeper = tool.steepness**2 - slope**2
        inner = np.abs(slope) * np.sqrt(aside2 / np.where(steeper > 0, steeper, 1))
        # If the tool is lowest above the point with its flat tip, the position is moved until the edge of the tip is
        # above the point, because the tool is lower there.
        inner = np.minimum(np.maximum(inner, np.sqrt(np.maximum(tool.tip**2 - aside2, 0))), half)
        position = -np.sign(slope) * np.where(steeper > 0, inner, half)
        return position
    position = np.zeros(half.shape)
    sloped = np.flatnonzero(slope)
    position[..., sloped] = _bisected(tool, slope[sloped], aside2[..., sloped], half[..., sloped])
    return position


def _bisected(tool: Tool, slope: np.ndarray, aside2: np.ndarray, half: np.ndarray) -> np.ndarray:
    """Compute `_lowest_position` for a bull-nose on sloped moves, by bisection."""
    low, high = -half, half
    flat = tool.radius - tool.rounding
    for _ in range(48):
        middle = (low + high) / 2
        r = np.sqrt(aside2 + middle**2)
        beyond = np.clip(r - flat, 0, tool.rounding)
        # `rising` is True where the tool's height above the point, slope * v + profile, increases with the tool's
        # position v. The positive denominator of the derivative is left out. On the flat tip the profile is constant,
        # so the height increases if the slope is positive.
        rising = beyond * middle + slope * np.maximum(r, flat) * np.sqrt(tool.rounding**2 - beyond**2) > 0
        high = np.where(rising, middle, high)
        low = np.where(rising, low, middle)
    return (low + high) / 2


def intervals(
    tool: Tool, start: np.ndarray, move: np.ndarray, ray: Sequence[np.ndarray], sine: float, cosine: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return the depths at which rays of an oblique view enter and leave the swept volume.

    Parameters
    ----------
    start, move : (3, k) ndarray
        Start point and displacement of the tool's tip, in ray coordinates, mm.
    ray : three ndarrays
        The x, y and z of one point of each ray, in ray coordinates, mm. The shapes of the three arrays broadcast with
        each other and (k,).
    sine, cosine : float
        Sine and cosine of the view's tilt from the vertical; ``sine > 0``.

    Returns
    -------
    near, far : ndarray
        Depths along each ray, mm; ``near > far``, or NaN, for a ray that misses the swept volume.
    """
    x, y, z = (along - begin for along, begin in zip(ray, start))
    corner = tool.rounding
    if corner == tool.radius:
        return ball_slot(corner, (x, y, z - corner), move, sine, cosine)
    if corner == 0 and tool.steepness == 0:
        if not move[2].any():
            return level_slot(tool.radius, (x, y, z), move, sine, cosine)
        if abs(cosine) > FROM_THE_SIDE:
            return sloped_slot(tool.radius, (x, y, z), move, sine, cosine)
    everything = np.array(np.broadcast_arrays(x, y, z, *move))
    offsets, moves = everything.reshape(2, 3, -1)
    near, far = _general(tool, offsets, moves, sine, cosine)
    return near.reshape(everything.shape[1:]), far.reshape(everything.shape[1:])


def _general(
    tool: Tool, offset: np.ndarray, move: np.ndarray, sine: float, cosine: float
) -> tuple[np.ndarray, np.ndarray]:
    """Compute `intervals` for a tool of any shape, with offsets and moves (3, k)."""
    nothing = np.full(offset.shape[1], np.inf)
    near, far = nothing, -nothing
    between = np.ones((2, len(near)), bool)
    for at, away in ((offset, move), (offset - move, -move)):
        enter, leave = _chord(tool, at, sine, cosine)
        near, far = _joined(near, far, enter, leave)
        if tool.rounding:
            # A bull-nose has no edges. The depth at which the ray enters or leaves the tool at this end of the move is
            # the final result if the tool's surface at this depth does not face the other end of the move. If this
            # surface faces the other end, a position of the tool between the ends of the move must be searched. A
            # position is also searched for every ray that only touches the tool, because there the direction of the
            # surface is a rounding error.
            touched = ~(leave - enter > ROUNDING)
            if abs(cosine) <= FROM_THE_SIDE:
                touched |= np.abs(at[2]) < ROUNDING  # a ray in the plane of the flat end only touches the tool
            for entered_or_left, depth in zip(between, (enter, leave)):
                depth = np.where(touched, 0, depth)
                entered_or_left &= touched | (_facing(tool, at, depth, away, sine, cosine) > 0)
    some: np.ndarray | slice = slice(None)
    if tool.rounding:
        rays = np.flatnonzero(between.any(axis=0))
        if abs(cosine) > FROM_THE_SIDE:
            # Skip rays that miss the slot of a flat-end mill with a slightly larger radius, which contains the
            # bull-nose; most rays miss this slot.
            enter, leave = sloped_slot(tool.radius + ROUNDING, tuple(offset[:, rays]), move[:, rays], sine, cosine)
            rays = rays[enter <= leave + ROUNDING]
        some = rays
    offset, move, first, last = offset[:, some], move[:, some], near[some], far[some]
    for t in _straight_sides(tool, offset, move, sine, cosine):
        chord = _straight_chord(tool, offset - np.clip(t, 0, 1) * move, sine, cosine)
        first, last = _joined(first, last, *chord)
    if tool.rounding:
        offset = _from_corner(tool, offset)
        for t in rounded_sides(tool, offset, move, sine, cosine):
            chord = rounded_chord(tool, offset - np.clip(t, 0, 1) * move, sine, cosine, first, last)
            first, last = _joined(first, last, *chord)
    near[some], far[some] = first, last
    return near, far


def _joined(near: np.ndarray, far: np.ndarray, enter: np.ndarray, leave: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return, for each ray, the smallest interval that contains both of its given intervals.

    Intervals with ``enter > leave`` are empty and ignored.
    """
    hit = enter <= leave + ROUNDING
    return np.where(hit, np.minimum(near, enter), near), np.where(hit, np.maximum(far, leave), far)


def _chord(tool: Tool, at: np.ndarray, sine: float, cosine: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the depths at which rays, at the offsets `at` (3, k) from the tip, enter and leave a stationary tool."""
    near, far = _straight_chord(tool, at, sine, cosine)
    if not tool.rounding:
        return near, far
    near, far = _joined(np.full(len(near), np.inf), np.full(len(far), -np.inf), near, far)
    return _joined(near, far, *rounded_chord(tool, _from_corner(tool, at), sine, cosine, near, far))


def _facing(tool: Tool, at: np.ndarray, depth: np.ndarray, move: np.ndarray, sine: float, cosine: float) -> np.ndarray:
    """Return a positive number where the bull-nose's surface at a depth of the ray faces the direction of the move."""
    x, y, z = _from_corner(tool, at)
    y, z = y + depth * sine, z - depth * cosine
    r = np.sqrt(x * x + y * y)
    outwards = divide(np.maximum(r - (tool.radius - tool.rounding), 0), r)
    return outwards * (x * move[0] + y * move[1]) + np.minimum(z, 0) * move[2]


def _from_corner(tool: Tool, offset: np.ndarray) -> np.ndarray:
    """Convert offsets from the tool's tip into offsets from the centre of the rounding."""
    return offset - np.array([[0.0], [0.0], [tool.rounding]])


def _straight_chord(tool: Tool, at: np.ndarray, sine: float, cosine: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the depths at which rays enter and leave a stationary cylinder with a flat or conical end."""
    x, y, z = at
    tangent = cosine / sine if abs(cosine) > FROM_THE_SIDE else 0.0
    half2 = tool.radius**2 - x**2
    half = np.sqrt(np.maximum(half2, 0))
    low = np.where(half2 >= -RIM, -half, np.inf)
    # The height of the ray above the lower end of the cylinder is level - tangent * y, where y is measured from the
    # tool's axis.
    level = z + tangent * y - tool.rounding + ROUNDING
    if tool.steepness > 0:
        # For the cone, the height is measured from the apex, which is below the flat tip.
        cone_low, cone_high = _cone_chord(tool.steepness, tangent, x, level + tool.steepness * tool.tip)
        low, high = np.maximum(low, cone_low), np.minimum(half, cone_high)
    else:
        high = half
    if tool.steepness == 0 or tool.tip > 0:
        if tangent > 0:
            high = np.minimum(high, level / tangent)
        elif tangent < 0:
            low = np.maximum(low, level / tangent)
        else:
            high = np.where(level >= 0, high, -np.inf)
    return (low - y) / sine, (high - y) / sine


def _cone_chord(k: float, tangent: float, x: np.ndarray, level: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the interval of y with ``k * hypot(x, y) <= level - tangent * y``."""
    steep = abs(tangent)
    square = (k - steep) * (k + steep)
    root2 = level**2 - square * x**2
    root = k * np.sqrt(np.maximum(root2, 0))
    # `down` is the distance to the cone on the side on which the ray descends, `up` the distance on the other side.
    # `down` is computed from the product of both solutions of a quadratic equation: if the ray is nearly parallel to
    # the cone, `up` is very large, and computing `down` as a difference would leave only rounding errors.
    reach = level * steep + root
    down = divide((level - k * np.abs(x)) * (level + k * np.abs(x)), reach)
    if square > 0:
        up = np.where((root2 >= 0) & (level >= 0), reach / square, -np.inf)
    else:  # the ray ascends at least as steeply as the cone, so it never leaves the cone on this side
        up = np.full_like(x, np.inf)
        below = (root - level * steep) / square if square else -np.inf
        down = np.where(level >= 0, down, below)
    return (-up, down) if tangent >= 0 else (-down, up)


def _straight_sides(tool: Tool, offset: np.ndarray, move: np.ndarray, sine: float, cosine: float) -> list[np.ndarray]:
    """Return candidates for the position t at which a ray first enters or last leaves a swept cylinder or cone."""
    x, y, z = offset
    ux, uy, uz = move
    run = np.sqrt(ux**2 + uy**2)
    safe_run = np.where(run > 0, run, 1)
    # Candidates for t (position of the tool on its move) from the two vertical side faces of the swept volume.
    reach = tool.radius * uy / safe_run
    sides = [divide(x + reach, ux), divide(x - reach, ux)]
    # Candidates for t (position of the tool on its move) from the swept edges. One swept edge is between the cylinder
    # and the flat end or cone, the other between the cone and its flat tip.
    k = tool.steepness
    tilted_move = cosine * uy + sine * uz
    square = (cosine * ux) ** 2 + tilted_move**2
    for radius, height in ((tool.radius, k * (tool.radius - tool.tip)), (tool.tip, 0.0))[: 2 if tool.tip else 1]:
        tilted = cosine * y + sine * (z - tool.rounding - height)
        middle = cosine**2 * x * ux + tilted * tilted_move
        rest = cosine**2 * (x**2 - radius**2) + tilted**2
        root = np.sqrt(np.maximum(middle**2 - square * rest, 0))
        sides += [divide(middle - root, square), divide(middle + root, square)]
    if k > 0:
        # Candidates for t (position of the tool on its move) from the two planes that touch the cone along the whole
        # move.
        cos_touch = np.clip(uz / (k * safe_run), -1, 1)
        sin_touch = np.sqrt(1 - cos_touch**2)
        tilted = cosine * y + sine * (z + k * tool.tip)
        for sign in (1, -1):
            ex = (cos_touch * ux - sign * sin_touch * uy) / safe_run
            ey = (cos_touch * uy + sign * sin_touch * ux) / safe_run
            e2 = cosine * ey + sine * k
            sides.append(divide(x * e2 - tilted * ex, ux * e2 - tilted_move * ex))
    return sides
