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
_RIM = 1e-12


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
        low, high = (walls.at(np.clip(walls.touched(sign), 0, 1), sign) / sine - depth for sign in (-1, 1))
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
    # Where the ray passes the floor of the tool standing at t: at (x - t ux, beyond - t rate) from its axis.
    tangent = sine / cosine
    beyond, rate = y + tangent * z, uy + tangent * uz
    square = np.maximum(ux**2 + rate**2, _TINY)
    middle = x * ux + beyond * rate
    root = np.sqrt(np.maximum(middle**2 - square * (x**2 + beyond**2 - radius**2), 0))
    first, last = (middle - root) / square, (middle + root) / square
    z = z + ROUNDING
    with np.errstate(invalid="ignore"):
        t = walls.touched(-1)
        # Where it would come in below the floor, it enters over the rim.
        below = walls.height(t, -1, y, z, uz, cosine / sine) < 0
        t = np.clip(np.where(below, np.minimum(np.maximum(t, first), last), t), 0, 1)
        low = walls.at(t, -1) - y
        near = np.where(z - low * cosine / sine - t * uz >= -ROUNDING, low / sine, np.nan)

        t = walls.touched(1)
        below = walls.height(t, 1, y, z, uz, cosine / sine) < 0
        t = np.clip(np.where(below, np.where(uz < 0, last, first), t), 0, 1)
        far = np.minimum((walls.at(t, 1) - y) / sine, (z - t * uz) / cosine)
    return near, far


def ball_slot(
    radius: float, offset: Sequence[np.ndarray], move: np.ndarray, sine: float, cosine: float
) -> tuple[np.ndarray, np.ndarray]:
    """Where rays pass what a ball end sweeps, `offset` from where its centre starts; see `level_slot`."""
    x, y, z = offset
    ux, uy, uz = move
    walls = _Walls(radius, x, ux, uy)
    slope = cosine / sine
    # Where the ray passes the cylinder around the path of the centre.
    length2 = np.maximum(ux**2 + uy**2 + uz**2, _TINY)
    along_ray = uy * sine - uz * cosine
    here = x * ux + y * uy + z * uz
    square = length2 - along_ray**2
    middle = length2 * (sine * y - cosine * z) - along_ray * here
    rest = length2 * (x**2 + y**2 + z**2 - radius**2) - here**2
    root = np.sqrt(np.maximum(middle**2 - square * rest, 0))
    ends = []
    with np.errstate(invalid="ignore", divide="ignore"):
        across = square > 1e-12 * length2
        for sign in (-1, 1):
            t = walls.touched(sign)
            below = walls.height(t, sign, y, z, uz, slope) < 0
            passed = np.where(across, (sign * root - middle) / square, sign * _ENDLESS)
            t = np.clip(np.where(below, (here + passed * along_ray) / length2, t), 0, 1)
            aside, ahead, above = x - t * ux, y - t * uy, z - t * uz
            half2 = radius**2 - aside**2
            wall = sign * np.sqrt(half2) - ahead
            lens2 = half2 - (cosine * ahead + sine * above) ** 2
            lens = np.sqrt(np.where(lens2 > -_RIM, np.maximum(lens2, 0), np.nan))
            lens = cosine * above - sine * ahead + sign * lens
            ends.append(np.where(above - wall * slope >= 0, wall / sine, lens))
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
        self.along = np.abs(ux) <= 1e-12 * run
        self.ux = np.where(self.along, 0.0, ux)
        # As the tool moves, its chord of the ray ends last where the tangent at its end goes along the move.
        self.reach = radius * uy / np.where(run > 0, run, 1) * np.sign(ux)

    def touched(self, sign: int) -> np.ndarray:
        """Place of the tool when the ray comes in (-1) through a wall of the move without ends, or goes out (1)."""
        touched = (self.x + sign * self.reach) / np.where(self.along, 1.0, self.ux)
        return np.where(self.along, np.where(sign * self.uy > 0, _ENDLESS, -_ENDLESS), touched)

    def at(self, t: np.ndarray, sign: int) -> np.ndarray:
        """How far along itself from the start of the move the ray passes the wall of the tool standing at `t`, mm."""
        aside = self.x - t * self.ux  # beside the tool the result is not a number
        along: np.ndarray = t * self.uy + sign * np.sqrt(self.radius**2 - aside * aside)
        return along

    def height(
        self, t: np.ndarray, sign: int, y: np.ndarray, z: np.ndarray, rise: np.ndarray, slope: float
    ) -> np.ndarray:
        """Height above the tool's tip at which a ray of (y, z) does so, that falls by `slope` mm per mm."""
        height: np.ndarray = z - (self.at(t, sign) - y) * slope - t * rise
        return height
