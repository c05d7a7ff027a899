# SPDX-License-Identifier: LGPL-2.1-or-later
"""Monotonous areas: the stretches of a toolpath in which one strategy can hold (paper, section 2.1)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.toolpath import Toolpath

TURN = 2 * np.pi
STILL = 1e-3  # mm; a shorter move in the plane has no direction worth the name
NOISE = 0.02  # mm; a move this short beside one 20 times longer is rounding and its direction is noise
STEEP = 5.0  # rise over run; steeper is a plunge or a lift
EXACT = 1e-6  # rad; a turn this close to pi is an exact reversal
UNSIGNED = 0.01  # rad; a turn this close to pi has no sign that rounding to 0.001 mm could not turn


@dataclass
class Moves:
    """The m cutting moves that have a direction in the working plane, split into areas.

    Attributes
    ----------
    index : (m,) int
        Trajectory of each move.
    x, y, z : (m,) float
        Start in the plane and height of the end along its normal, mm.
    dx, dy, dz, length : (m,) float
        The move and its length in the plane, mm.
    alpha : (m,) float
        Direction, rad.
    turning : (m,) float
        Turn at the start of the move, rad in [-pi, pi]; 0 at the start of an area and at a reversal.
    phi : (m,) float
        Cumulative angular function, rad; it runs on from area to area, so only differences inside one count.
    start : (a,) int
        First move of each area.
    holes : (h,) int
        Last trajectory of each drilled hole.
    reversals : int
        Number of exact reversals.
    vertical : float
        Length of the cutting moves along the normal that are in no area (plunges, drilling), mm.
    """

    index: np.ndarray
    x: np.ndarray
    y: np.ndarray
    z: np.ndarray
    dx: np.ndarray
    dy: np.ndarray
    dz: np.ndarray
    length: np.ndarray
    alpha: np.ndarray
    turning: np.ndarray
    phi: np.ndarray
    start: np.ndarray
    holes: np.ndarray
    reversals: int
    vertical: float

    def __len__(self) -> int:
        """Return the number of moves."""
        return len(self.index)


def axis_of(along_x, along_y, length):
    """Return the axis of moves, rad in [-pi/2, pi/2]: the direction of their sum at twice their angle.

    Parameters
    ----------
    along_x, along_y : float or array
        Sum of cos^2 and of cos sin of the directions, weighted by length, mm.
    length : float or array
        Sum of the lengths, mm.
    """
    return 0.5 * np.arctan2(2 * along_y, 2 * along_x - length)


def wrap(angle: np.ndarray) -> np.ndarray:
    """Wrap angles in rad to [-pi, pi]."""
    return angle - TURN * np.rint(angle * (1 / TURN))


def monotonous_areas(toolpath: Toolpath, first: int = 0, last: int | None = None) -> Moves:
    """Split the cutting moves into monotonous areas.

    Parameters
    ----------
    toolpath : Toolpath
    first, last : int
        Range of trajectories to look at, last inclusive; all where not given.

    Returns
    -------
    Moves
        With m = 0 where nothing cuts along the plane.
    """
    end = len(toolpath) if last is None else last + 1
    points, rapid = toolpath.points[first : end + 1], toolpath.rapid[first:end]
    # One block for all measures, and in place wherever that is possible: with this many moves the cost is
    # memory, not arithmetic. Many arrays that come and go make the system map the same pages again and again.
    block = np.empty((10, len(points)))
    for row, axis in zip(block, _seen_along_the_normal(points, rapid)):
        row[:] = points[:, axis]
    x, y, z = block[:3]
    dx, dy, dz = np.subtract(block[:3, 1:], block[:3, :-1], out=block[3:6, :-1])
    length = np.multiply(dx, dx, out=block[6, :-1])
    length += dy * dy
    np.sqrt(length, out=length)
    planar = length > STILL
    if dz.any():
        planar &= np.abs(dz) <= STEEP * length
    if rapid.any():
        planar &= ~rapid
    _drop_noise(planar, length)
    index, start = _split(planar, rapid, z, dx, dy, dz, length)
    index, start = _without_air(planar, index, start, rapid, z, dx, dy, dz, length)
    holes, vertical = index[:0], 0.0
    if len(index) < len(dx):
        holes = _holes(points, rapid, dz, length, planar)
        vertical = float(np.abs(dz[~rapid]).sum() - np.abs(dz[index]).sum())
        dx, dy, dz, length, x, y, z = (v[index] for v in (dx, dy, dz, length, x, y, z[1:]))
    else:
        x, y, z = x[:-1], y[:-1], z[1:]
    alpha, turning, phi = block[7:, : len(index)]
    np.arctan2(dy, dx, out=alpha)
    np.subtract(alpha[1:], alpha[:-1], out=turning[1:])
    turning[start] = 0.0
    whole = turning * (1 / TURN)
    np.rint(whole, out=whole)
    whole *= TURN
    turning -= whole
    # A turn of pi has no sign (design.md): it is an event of its own and phi does not move.
    straight_back = np.flatnonzero(np.abs(turning, out=whole) > np.pi - UNSIGNED)
    reversals = int((whole[straight_back] > np.pi - EXACT).sum())
    turning[straight_back] = 0.0
    return Moves(
        index=index + first if first else index,
        x=x,
        y=y,
        z=z,
        dx=dx,
        dy=dy,
        dz=dz,
        length=length,
        alpha=alpha,
        turning=turning,
        phi=np.cumsum(turning, out=phi),
        start=start,
        holes=holes + first,
        reversals=reversals,
        vertical=vertical,
    )


def _seen_along_the_normal(points: np.ndarray, rapid: np.ndarray) -> list[int]:
    """Return the two coordinate axes of the plane the motion lies in and the one of the height above it.

    XY but for a path that never leaves a vertical plane and slopes in it (contouring in G18): there every row
    would fall on one line. A slot cut at several depths by level passes and vertical plunges stays in XY.
    """
    every = len(rapid) // 50 + 1
    few = np.flatnonzero(~rapid[::every]) * every
    for axes in ([2, 0, 1], [1, 2, 0]):
        u, v, aside = (points[:, axis] for axis in axes)
        if not len(few) or np.ptp(aside[few]) > STILL:
            continue
        cutting = np.flatnonzero(~rapid)
        if np.ptp(aside[cutting]) > STILL or np.ptp(aside[cutting + 1]) > STILL:
            continue
        du, dv = np.abs(u[cutting + 1] - u[cutting]), np.abs(v[cutting + 1] - v[cutting])
        if ((du > 0.05 * dv) & (dv > 0.05 * du)).sum() >= 2:
            return axes
    return [0, 1, 2]


def _drop_noise(planar: np.ndarray, length: np.ndarray) -> None:
    """Unmark lone moves of a few micrometres beside long ones: they are rounding, their direction is
    noise."""
    short = np.flatnonzero(planar & (length < NOISE))
    if not len(short):
        return
    before = length[np.maximum(short - 1, 0)]
    after = length[np.minimum(short + 1, len(length) - 1)]
    planar[short[length[short] < 0.05 * np.maximum(before, after)]] = False


def _split(planar, rapid, z, dx, dy, dz, length) -> tuple[np.ndarray, np.ndarray]:
    """Return the trajectories of the planar moves and the first move of each area.

    Areas end at rapids, plunges and lifts. A height change between two moves of one direction is a wall the
    tool climbs in the middle of a pass (3D rasters), not the end of the pass.
    """
    index = np.flatnonzero(planar)
    if len(index) == len(planar):
        return index, np.zeros(min(len(index), 1), np.int64)
    gap = np.flatnonzero(index[1:] - index[:-1] > 1) + 1
    if len(gap):
        rapids = np.concatenate([[0], np.cumsum(rapid)])
        after, before = index[gap], index[gap - 1]
        lifted = rapids[after] > rapids[before]
        steep = np.concatenate([[0], np.cumsum(np.where(planar | rapid, 0.0, np.abs(dz)))])
        height = np.abs(z[after] - z[before + 1])
        drilled = steep[after] - steep[before] > height + STILL  # down and up again
        onward = dx[after] * dx[before] + dy[after] * dy[before] > 0.98 * length[after] * length[before]
        gap = gap[lifted | drilled | ((height > STILL) & ~onward)]
    return index, np.concatenate([[0], gap]) if len(index) else gap


def _without_air(planar, index, start, rapid, z, dx, dy, dz, length) -> tuple[np.ndarray, np.ndarray]:
    """Leave out the links in the air of programs that lift, go over and plunge at feed instead of rapid.

    Such a link is straight and level, begins by a lift and ends by a plunge; at the ends of a program one of
    the two is enough.
    """
    if not len(start) or len(index) == len(planar):
        return index, start
    last = np.append(start[1:], len(index)) - 1
    a, b = index[start], index[last]
    level = np.abs(z[b + 1] - z[a]) < STILL
    straight = dx[a] * dx[b] + dy[a] * dy[b] > 0.999 * length[a] * length[b]
    steep = np.where(length > STILL, 0.0, dz)  # rapid or at feed
    rises, falls = np.append(0.0, steep)[a] > STILL, np.append(steep, 0.0)[b + 1] < -STILL
    lifted, plunges = rises | (a == 0), falls | (b == len(dz) - 1)
    air = level & straight & lifted & plunges
    if len(start) > 1:
        # A plateau between walls is no link: it goes on in the direction of the lower pass beside it.
        before, after = b[:-1], a[1:]
        onward = dx[after] * dx[before] + dy[after] * dy[before] > 0.98 * length[after] * length[before]
        air[1:] &= ~(onward & (z[before + 1] < z[after] - STILL))
        air[:-1] &= ~(onward & (z[after] < z[before + 1] - STILL))
    air &= rises | falls
    if not air.any():
        return index, start
    keep = ~np.repeat(air, last + 1 - start)
    planar[index[~keep]] = False
    size = (last + 1 - start)[~air]
    return index[keep], np.concatenate([[0], np.cumsum(size)[:-1]]) if len(size) else size


def _holes(points, rapid, dz, length, planar) -> np.ndarray:
    """Return the last trajectory of every plunge between two rapids that cuts nothing else: drilled holes.

    Pecks into one hole count once. Walls and lead-ins stand beside moves along the plane and are no holes.
    """
    down = np.flatnonzero(~rapid & (length <= STILL) & (dz < -STILL))
    if not len(down):
        return down
    block = np.cumsum(rapid)
    milled = np.zeros(int(block[-1]) + 1, bool)
    milled[block[planar]] = True
    down = down[~milled[block[down]]]
    x, y = points[down + 1, 0], points[down + 1, 1]
    left = (np.abs(x[1:] - x[:-1]) > STILL) | (np.abs(y[1:] - y[:-1]) > STILL)
    return down[np.append(left, True)] if len(down) else down
