# SPDX-License-Identifier: LGPL-2.1-or-later
"""Intersections of tilted rays with the slots that flat and ball ends mill along a straight move.

Coordinates are the ray coordinates of intervals.py. The depth at which a ray enters the tool is a convex function of the tool's
position t on its move, and the depth at which it leaves the tool is a concave one. Therefore the first entry is where the ray
enters the slot of an endless move, or else at the end of the move nearest to that position; likewise the last exit. An endless
slot has two upright walls and a bottom, and the position t for each is known in closed form, so that each end of the interval
needs one position of the tool.

Array shapes broadcast: in a grid of rays, x may have one row, y and z one column.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

# Rays are extended by this length below a flat floor, mm; otherwise rounding would decide for rays on the floor. Ends that are
# closer than this length are equal, because a ray meets an edge of the swept volume in a single point.
ROUNDING = 1e-7
# Rays with a smaller cosine are horizontal and meet no floor.
FROM_THE_SIDE = 1e-9
# Replaces 0 in denominators.
_TINY = 1e-300
# Replaces an infinite depth or position.
_ENDLESS = 1e30
# Largest rounding error of a squared half chord on the rim, mm^2.
RIM = 1e-12


def level_slot(
    radius: float, offset: Sequence[np.ndarray], move: np.ndarray, sine: float, cosine: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return the depths at which rays enter and leave the slot of a flat end along level moves.

    Parameters
    ----------
    radius : float
        Radius of the tool, mm.
    offset : three ndarrays
        A point of each ray, relative to the start of the tip, mm.
    move : (3, k) ndarray
        Move of the tip, mm.
    sine, cosine : float
        Sine and cosine of the view's tilt from the vertical.

    Returns
    -------
    near, far : ndarray
        Depths along the ray, mm; ``near > far``, or NaN, for a ray that misses.
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
    """Like `level_slot`, for moves of any slope and rays that are not horizontal."""
    x, y, z = offset
    ux, uy, uz = move
    if cosine < 0:  # reverse the ray
        near, far = sloped_slot(radius, (x, -y, z), np.array([ux, -uy, uz]), sine, -cosine)
        return -far, -near
    walls = _Walls(radius, x, ux, uy)
    ux = walls.ux
    # The ray meets the floor of the tool at position t at (x - t ux, beyond - t rate) from the tool's axis.
    tangent, slope = sine / cosine, cosine / sine
    # Rise of the floor relative to the ray. For a move along the ray it is a rounding error, which must be the same everywhere.
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
        # A ray that would enter the wall below the floor enters over the rim.
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
    """Like `level_slot`, for a ball end. `offset` is relative to the start of the ball's centre."""
    x, y, z = offset
    ux, uy, uz = move
    walls = _Walls(radius, x, ux, uy)
    slope = cosine / sine
    rise = slope * uy + uz
    # Components along the ray, and upwards across it.
    forward, upward = sine * y - cosine * z, cosine * y + sine * z
    along_ray, across_ray = sine * uy - cosine * uz, cosine * uy + sine * uz
    length2 = np.maximum(ux**2 + uy**2 + uz**2, _TINY)
    square = length2 - along_ray**2
    across = square > 1e-12 * length2
    inverse = np.where(across, 1 / np.where(across, square, 1), 0.0)
    # The position nearest to the ray, and the distance from it to the positions at which the ray meets the swept cylinder.
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
    """Intersections of rays with the upright walls of a slot, seen from above.

    Parameters
    ----------
    radius : float
        Radius of the tool, mm.
    x : ndarray
        Position of the ray across its direction, relative to the start of the move, mm.
    ux, uy : (k,) ndarray
        Components of the move across and along the ray, mm.
    """

    def __init__(self, radius: float, x: np.ndarray, ux: np.ndarray, uy: np.ndarray) -> None:
        self.radius, self.x, self.uy = radius, x, uy
        run = np.sqrt(ux**2 + uy**2)
        # Moves along the ray, up to rounding.
        along = np.abs(ux) <= 1e-12 * run
        self.ux = np.where(along, 0.0, ux)
        self.inverse = np.where(along, 0.0, 1 / np.where(along, 1.0, ux))
        # The chord of the moving tool reaches farthest where the tangent at its end is parallel to the move.
        reach = radius * uy / np.where(run > 0, run, 1) * np.abs(self.inverse)
        self.reach = np.where(along, np.copysign(_ENDLESS, uy), reach)

    def touched(self, sign: int) -> np.ndarray:
        """Return the tool's position at which the ray enters (-1) or leaves (1) through a wall of the endless move."""
        touched: np.ndarray = self.x * self.inverse + sign * self.reach
        return touched

    def chord_end(self, t: np.ndarray, sign: int) -> np.ndarray:
        """Return the distance along the ray from the tool's axis to the wall at the positions `touched`, mm.

        The ray always meets the tool at these positions; negative squares are rounding errors.
        """
        return _signed_root(np.maximum(self._half2(t), 0), sign)

    def at(self, t: np.ndarray, sign: int) -> np.ndarray:
        """Return the distance along the ray from the start of the move to the wall of the tool at `t`, mm; NaN beside the tool."""
        half = _signed_root(self._half2(t), sign)
        half += t * self.uy
        return half

    def _half2(self, t: np.ndarray) -> np.ndarray:
        half = t * self.ux
        np.subtract(self.x, half, out=half)
        half *= half
        result: np.ndarray = np.subtract(self.radius**2 + RIM, half, out=half)
        return result


def _signed_root(square: np.ndarray, sign: int) -> np.ndarray:
    """Return the square root with a sign, in place."""
    root: np.ndarray = np.sqrt(square, out=square)
    root *= sign
    return root


def _on_move(t: np.ndarray) -> np.ndarray:
    """Clip positions to the ends of the move, in place."""
    np.maximum(t, 0, out=t)
    np.minimum(t, 1, out=t)
    return t
