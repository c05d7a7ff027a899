# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where tilted rays pass the slots that flat and ball ends mill along a straight move.

In the ray coordinates of sweeps.py. Where a ray enters the tool is a convex function of the tool's place t on its move,
and where it leaves it a concave one. So its first entry lies where it enters the slot of a move without ends, or else
at the end of the move that is nearest to that; and so does its last exit. A slot without ends has two upright walls and
a bottom, and the t of each of them is known in closed form: each end of the interval takes one place of the tool.

Arrays have shapes that go together: in a grid of rays x may have one row of them, y and z one column.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

# Rays go on by this much below a flat floor, mm: on the floor itself rounding would decide. Ends that are closer than
# this are one: an edge of the swept volume is met in a single point.
ROUNDING = 1e-7
# Views less steep than this cosine pass no floor.
FROM_THE_SIDE = 1e-9
# Stands for 0 where something is divided by it.
_TINY = 1e-300
# Stands for a depth or a place without end.
_ENDLESS = 1e30
# What rounding may make of a squared half chord on the rim, mm^2.
RIM = 1e-12


def level_slot(
    radius: float, offset: Sequence[np.ndarray], move: np.ndarray, sine: float, cosine: float
) -> tuple[np.ndarray, np.ndarray]:
    """Where rays pass what a flat end sweeps along level moves: between its wall and above its floor.

    Parameters
    ----------
    radius : float
        Of the tool, mm.
    offset : three ndarrays
        A point of each ray, from where the tip starts, mm.
    move : (3, k) ndarray
        mm.
    sine, cosine : float
        Of the view's tilt from the vertical.

    Returns
    -------
    near, far : ndarray
        Depths along the ray, mm; ``near > far``, or not a number, where it misses.
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
    """Where rays pass what a flat end sweeps along any moves, in a view that is not from the side; see `level_slot`."""
    x, y, z = offset
    ux, uy, uz = move
    if cosine < 0:  # the same ray from its other end
        near, far = sloped_slot(radius, (x, -y, z), np.array([ux, -uy, uz]), sine, -cosine)
        return -far, -near
    walls = _Walls(radius, x, ux, uy)
    ux = walls.ux
    # Where the ray passes the floor of the tool standing at t: at (x - t ux, beyond - t rate) from its axis.
    tangent, slope = sine / cosine, cosine / sine
    # How the floor rises against the ray: for a move along the ray mere rounding, which has to be the same everywhere.
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
        # Where it would come in below the floor, it enters over the rim.
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
    """Where rays pass what a ball end sweeps, `offset` from where its centre starts; see `level_slot`."""
    x, y, z = offset
    ux, uy, uz = move
    walls = _Walls(radius, x, ux, uy)
    slope = cosine / sine
    rise = slope * uy + uz
    # Along the ray, and upwards across it.
    forward, upward = sine * y - cosine * z, cosine * y + sine * z
    along_ray, across_ray = sine * uy - cosine * uz, cosine * uy + sine * uz
    length2 = np.maximum(ux**2 + uy**2 + uz**2, _TINY)
    square = length2 - along_ray**2
    across = square > 1e-12 * length2
    inverse = np.where(across, 1 / np.where(across, square, 1), 0.0)
    # Where the ray comes nearest to the path of the centre, and from there to where it passes the cylinder around it.
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
    """Where rays pass the upright walls of a slot, seen from above.

    Parameters
    ----------
    radius : float
        mm.
    x : ndarray
        Where the ray lies across itself, from the start of the move, mm.
    ux, uy : (k,) ndarray
        The move across the ray and along it, mm.
    """

    def __init__(self, radius: float, x: np.ndarray, ux: np.ndarray, uy: np.ndarray) -> None:
        self.radius, self.x, self.uy = radius, x, uy
        run = np.sqrt(ux**2 + uy**2)
        # Along the ray; rounding may leave it something else.
        along = np.abs(ux) <= 1e-12 * run
        self.ux = np.where(along, 0.0, ux)
        self.inverse = np.where(along, 0.0, 1 / np.where(along, 1.0, ux))
        # As the tool moves, its chord of the ray ends last where the tangent at its end goes along the move.
        reach = radius * uy / np.where(run > 0, run, 1) * np.abs(self.inverse)
        self.reach = np.where(along, np.copysign(_ENDLESS, uy), reach)

    def touched(self, sign: int) -> np.ndarray:
        """Place of the tool when the ray comes in (-1) through a wall of the move without ends, or goes out (1)."""
        touched: np.ndarray = self.x * self.inverse + sign * self.reach
        return touched

    def chord_end(self, t: np.ndarray, sign: int) -> np.ndarray:
        """How far from the tool's axis along itself the ray passes its wall at the places `touched`, mm.

        These are never beside the tool: far from a move along the ray rounding would say so.
        """
        return _signed_root(np.maximum(self._half2(t), 0), sign)

    def at(self, t: np.ndarray, sign: int) -> np.ndarray:
        """How far along itself from the start of the move the ray passes the wall of the tool standing at `t`, mm."""
        half = _signed_root(self._half2(t), sign)  # beside the tool not a number
        half += t * self.uy
        return half

    def _half2(self, t: np.ndarray) -> np.ndarray:
        half = t * self.ux
        np.subtract(self.x, half, out=half)
        half *= half
        result: np.ndarray = np.subtract(self.radius**2 + RIM, half, out=half)
        return result


def _signed_root(square: np.ndarray, sign: int) -> np.ndarray:
    """The square root with that sign, in place."""
    root: np.ndarray = np.sqrt(square, out=square)
    root *= sign
    return root


def _on_move(t: np.ndarray) -> np.ndarray:
    """The nearest places between the ends of the move, in place."""
    np.maximum(t, 0, out=t)
    np.minimum(t, 1, out=t)
    return t
