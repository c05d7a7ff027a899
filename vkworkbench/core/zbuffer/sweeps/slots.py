# SPDX-License-Identifier: LGPL-2.1-or-later
"""Intersect rays of an oblique view with the slots that flat-end and ball-end mills cut along a straight move.

Coordinates are the ray coordinates of intervals.py. The position t of the tool runs from 0 to 1 on its move. The depth
at which a ray enters the tool is a convex function of t, and the depth at which the ray leaves the tool is a concave
function of t. If the move were endless, closed forms would give the t at which the ray enters and leaves through the
two upright walls and the bottom of the slot. Clipping this position t of the tool to the range from 0 to 1 gives the
position for the first entry or the last exit. Therefore each end of the interval needs only one position of the tool.

The shapes of the arrays broadcast with each other. For a grid of rays, x can be an array with one row, and y and z can
be arrays with one column.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

# Length by which the flat end of a tool is lowered, mm, so that rounding does not decide whether a ray in the plane of
# the flat end meets the tool. Two depths on a ray that differ by less than this length count as equal, because a ray
# that only touches an edge of the swept volume enters and leaves the volume at depths that differ only by rounding. A
# smaller length would turn rounding errors into missed rays, and a larger length would make the floors of slots
# noticeably too low.
ROUNDING = 1e-7
# Rays are treated as horizontal if the absolute cosine of the angle between the view and the vertical is at most this
# value. A horizontal ray does not cross the floor of a slot. With a smaller limit, dividing by the cosine would magnify
# rounding errors. With a larger limit, sloped rays would be treated as if they did not cross the floor.
FROM_THE_SIDE = 1e-9
# Smallest denominator that is allowed; it prevents a division by 0.
_TINY = 1e-300
# Finite number that stands for an infinitely distant position on a move, because infinity times 0 is NaN.
_ENDLESS = 1e30
# Largest rounding error of the squared half chord of a ray that meets a tool at its outer edge (rim), mm^2. With a
# smaller value, rays at the outer edge would miss the tool. With a larger value, rays that pass beside the tool would
# meet it.
RIM = 1e-12


def level_slot(
    radius: float, offset: Sequence[np.ndarray], move: np.ndarray, sine: float, cosine: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return the depths at which rays enter and leave the slots that a flat end mills along level moves.

    Parameters
    ----------
    radius : float
        Radius of the tool, mm.
    offset : three ndarrays
        The x, y and z of one point of each ray, relative to the start of the tool's tip, mm.
    move : (3, k) ndarray
        Displacement of the tool's tip, mm.
    sine, cosine : float
        Sine and cosine of the view's tilt from the vertical.

    Returns
    -------
    near, far : ndarray
        Depths along each ray, mm; ``near > far``, or NaN, for a ray that misses the slot.
    """
    x, y, z = offset
    ux, uy, _ = move
    walls = _Walls(radius, x, ux, uy)
    depth = y / sine
    with np.errstate(invalid="ignore"):
        low, high = (walls.at(_on_move(walls.touched(sign)), sign) / sine - depth for sign in (-1, 1))
    height = z + ROUNDING
    if cosine > FROM_THE_SIDE:
        high = np.minimum(high, height / cosine, out=high)
    elif cosine < -FROM_THE_SIDE:
        low = np.maximum(low, height / cosine, out=low)
    else:
        high = np.where(height >= 0, high, -np.inf)
    return low, high


def sloped_slot(
    radius: float, offset: Sequence[np.ndarray], move: np.ndarray, sine: float, cosine: float
) -> tuple[np.ndarray, np.ndarray]:
    """Compute the same depths as `level_slot` for moves of any slope; the rays must not be horizontal."""
    x, y, z = offset
    ux, uy, uz = move
    if cosine < 0:  # compute with the reversed ray, whose cosine is positive
        near, far = sloped_slot(radius, (x, -y, z), np.array([ux, -uy, uz]), sine, -cosine)
        return -far, -near
    walls = _Walls(radius, x, ux, uy)
    ux = walls.ux
    # If the tool is at position t, the ray meets the plane of the tool's flat end at the point (x - t ux, beyond - t
    # rate), measured from the tool's axis.
    tangent, slope = sine / cosine, cosine / sine
    # Rise of the slot's floor relative to the ray over the whole move. For a move along the ray, the exact rise is 0
    # and the computed rise is a rounding error, so all formulas below use this one value.
    rise = slope * uy + uz
    beyond, rate = y + tangent * z, tangent * rise
    square = np.maximum(ux**2 + rate**2, _TINY)
    middle = x * (ux / square) + beyond * (rate / square)
    root = x * rate - beyond * ux
    root *= root
    np.sqrt(np.maximum(np.subtract(square * radius**2, root, out=root), 0, out=root), out=root)
    root /= square
    z = z + ROUNDING
    height = z + y * slope
    with np.errstate(invalid="ignore"):
        t = walls.touched(-1)
        # If the ray would meet the wall below the tool's flat end, it enters through the flat end instead, and t is
        # where the ray meets the edge of the flat end.
        below = height < walls.chord_end(t, -1) * slope + t * rise
        over = np.maximum(middle - root, t)
        t = _on_move(np.where(below, np.minimum(over, middle + root, out=over), t))
        low = walls.at(t, -1)
        low -= y
        t *= uz
        t += low * slope
        low /= sine
        np.copyto(low, np.nan, where=~(t <= z + ROUNDING))

        t = walls.touched(1)
        below = height < walls.chord_end(t, 1) * slope + t * rise
        root *= np.where(uz < 0, 1, -1)
        root += middle
        t = _on_move(np.where(below, root, t))
        high = walls.at(t, 1)
        high -= y
        high /= sine
        t *= uz
        np.minimum(high, np.divide(np.subtract(z, t, out=t), cosine, out=t), out=high)
    return low, high


def ball_slot(
    radius: float, offset: Sequence[np.ndarray], move: np.ndarray, sine: float, cosine: float
) -> tuple[np.ndarray, np.ndarray]:
    """Compute the same depths as `level_slot` for a ball end.

    `offset` is relative to the centre of the ball at the start of the move.
    """
    x, y, z = offset
    ux, uy, uz = move
    walls = _Walls(radius, x, ux, uy)
    slope = cosine / sine
    rise = slope * uy + uz
    # Components of the offset and of the move: parallel to the ray, and perpendicular to the ray (upwards).
    forward, upward = sine * y - cosine * z, cosine * y + sine * z
    along_ray, across_ray = sine * uy - cosine * uz, cosine * uy + sine * uz
    length2 = np.maximum(ux**2 + uy**2 + uz**2, _TINY)
    square = length2 - along_ray**2
    across = square > 1e-12 * length2
    inverse = np.where(across, 1 / np.where(across, square, 1), 0.0)
    # `nearest` is the position t at which the ball's centre is nearest to the ray. `passed` is the difference in t
    # between `nearest` and the positions at which the ray enters and leaves the cylinder that the ball sweeps.
    nearest = x * (ux * inverse) + upward * (across_ray * inverse)
    root = np.sqrt(inverse)
    apart = x * (across_ray * root) - upward * (ux * root)
    apart *= apart
    passed = np.sqrt(np.maximum(np.subtract(radius**2, apart, out=apart), 0, out=apart), out=apart)
    passed *= np.where(across, along_ray * root / np.sqrt(length2), np.sign(along_ray) * _ENDLESS)
    ends = []
    with np.errstate(invalid="ignore"):
        for sign in (-1, 1):
            t = walls.touched(sign)
            below = z + y * slope < walls.chord_end(t, sign) * slope + t * rise
            t = _on_move(np.where(below, nearest + sign * passed, t))
            half2 = x - t * ux
            half2 *= half2
            np.subtract(radius**2, half2, out=half2)
            wall = np.sqrt(half2)
            wall *= sign
            wall -= y
            wall += t * uy
            lens = upward - t * across_ray
            lens *= lens
            half2 -= lens
            np.maximum(half2, 0, out=lens)
            np.copyto(lens, np.nan, where=half2 <= -RIM)
            np.sqrt(lens, out=lens)
            lens *= sign
            lens -= forward
            lens += t * along_ray
            t *= uz
            standing = z - t >= wall * slope
            wall /= sine
            ends.append(np.where(standing, wall, lens))
    return ends[0], ends[1]


class _Walls:
    """Intersections of rays with the upright walls of a slot, computed in the horizontal plane.

    Parameters
    ----------
    radius : float
        Radius of the tool, mm.
    x : ndarray
        Horizontal distance between the ray and the start of the move, positive if the ray is to the right, mm.
    ux, uy : (k,) ndarray
        Horizontal components of the tool's displacement: `ux` perpendicular to the ray, `uy` along the ray, mm.
    """

    def __init__(self, radius: float, x: np.ndarray, ux: np.ndarray, uy: np.ndarray) -> None:
        self.radius, self.x, self.uy = radius, x, uy
        run = np.sqrt(ux**2 + uy**2)
        # True for moves whose horizontal direction is, up to rounding, the direction of the ray.
        along = np.abs(ux) <= 1e-12 * run
        self.ux = np.where(along, 0.0, ux)
        self.inverse = np.where(along, 0.0, 1 / np.where(along, 1.0, ux))
        # The ray crosses the tool's circle in a chord. The ray crosses a wall of the endless slot at the t where the
        # circle's tangent at an end of the chord is parallel to the move.
        reach = radius * uy / np.where(run > 0, run, 1) * np.abs(self.inverse)
        self.reach = np.where(along, np.copysign(_ENDLESS, uy), reach)

    def touched(self, sign: int) -> np.ndarray:
        """Return the tool position t at which a ray enters (sign -1) or leaves (sign 1) a wall of the endless slot."""
        return self.x * self.inverse + sign * self.reach

    def chord_end(self, t: np.ndarray, sign: int) -> np.ndarray:
        """Return the horizontal distance along the ray from the tool's axis to the wall at the positions `touched`, mm.

        The ray always meets the tool at the positions `touched`, so negative values of the squared half chord are
        rounding errors.
        """
        return _signed_root(np.maximum(self._half2(t), 0), sign)

    def at(self, t: np.ndarray, sign: int) -> np.ndarray:
        """Return the horizontal distance from the start of the move to the wall of a tool at the position `t`, mm.

        The distance is measured along the ray. The distance is NaN if the ray passes beside the tool.
        """
        half = _signed_root(self._half2(t), sign)
        half += t * self.uy
        return half

    def _half2(self, t: np.ndarray) -> np.ndarray:
        half = t * self.ux
        np.subtract(self.x, half, out=half)
        half *= half
        return np.subtract(self.radius**2 + RIM, half, out=half)


def _signed_root(square: np.ndarray, sign: int) -> np.ndarray:
    """Replace each value in place by its square root times `sign`; return the array."""
    root: np.ndarray = np.sqrt(square, out=square)
    root *= sign
    return root


def _on_move(t: np.ndarray) -> np.ndarray:
    """Clip positions on the move to the range from 0 to 1, in place; return the array."""
    np.maximum(t, 0, out=t)
    np.minimum(t, 1, out=t)
    return t
