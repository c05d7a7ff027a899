# SPDX-License-Identifier: LGPL-2.1-or-later
"""Select the cutting moves that have a direction, measure them, and split them into areas (paper, section 2.1)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from vkworkbench.core.paper.directions import directions, extremes, turns
from vkworkbench.core.paper.plane import plane_of_toolpath
from vkworkbench.core.paper.thresholds import MOVES, TURNS
from vkworkbench.core.toolpath import Toolpath


@dataclass
class Moves:
    """The `m` cutting moves that have a direction in the working plane, split into `a` monotonous areas."""

    index: np.ndarray  # (m,) int: index of each move's trajectory
    # x, y, z (m,) float: start of the move in the plane, and height of its end along the plane's normal, mm.
    x: np.ndarray
    y: np.ndarray
    z: np.ndarray
    # dx, dy, dz, length (m,) float: components of the move, and its length in the plane, mm.
    dx: np.ndarray
    dy: np.ndarray
    dz: np.ndarray
    length: np.ndarray
    alpha: np.ndarray  # (m,) float: direction, rad
    # (m,) float: turn at the start of the move, rad in [-pi, pi]; 0 at the start of an area. For a half turn without a
    # sign, only the difference from half a turn is stored.
    turning: np.ndarray
    # (m,) float: sum of the turns since the start of the area (the cumulative angular function), rad. The sum does not
    # include half turns without a sign.
    phi: np.ndarray
    start: np.ndarray  # (a,) int: first move of each area
    # unsigned, reversals (u,) and (r,) int: moves that begin with half a turn within rounding (TURNS.UNSIGNED), and
    # with exactly half a turn (TURNS.EXACT).
    unsigned: np.ndarray
    reversals: np.ndarray
    holes: np.ndarray  # (h,) int: index of the last trajectory of each drilled hole

    def __len__(self) -> int:
        """Return the number of moves."""
        return len(self.index)

    @cached_property
    def phi_extremes(self) -> tuple[np.ndarray, np.ndarray]:
        """Lowest and highest phi of each area, (a,) rad each."""
        return extremes(self.phi, self.start)

    @cached_property
    def phi_extent(self) -> np.ndarray:
        """Difference between the highest and the lowest phi of each area, (a,) rad."""
        low, high = self.phi_extremes
        return high - low


def cutting_moves(toolpath: Toolpath, first: int, end: int) -> Moves:
    """Measure the cutting moves among the trajectories `first` to `end` - 1, and split them into monotonous areas."""
    steps = _Steps(toolpath, first, end)
    dx, dy, dz, length = steps.dx, steps.dy, steps.dz, steps.length
    planar = length > MOVES.STILL
    if dz.any():
        planar &= np.abs(dz) <= MOVES.STEEP * length
    if steps.rapid.any():
        planar &= ~steps.rapid
    _drop_noise(planar, length)
    index, start = _without_air(steps, planar, *_split(steps, planar))
    holes = index[:0]
    if len(index) < len(dx):
        holes = _holes(steps, planar)
        dx, dy, dz, length, x, y, z = (v[index] for v in (dx, dy, dz, length, steps.x, steps.y, steps.z[1:]))
    else:
        x, y, z = steps.x[:-1], steps.y[:-1], steps.z[1:]
    alpha = directions(dx, dy)
    turning, phi, unsigned, reversals = turned(alpha, start)
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
        phi=phi,
        start=start,
        unsigned=unsigned,
        reversals=reversals,
        holes=holes + first,
    )


class _Steps:
    """The trajectories `first` to `end` - 1 of a toolpath in the working plane: points (n+1,), steps and lengths (n,)."""

    def __init__(self, toolpath: Toolpath, first: int, end: int) -> None:
        self.points, self.rapid = toolpath.points[first : end + 1], toolpath.rapid[first:end]
        x, y, z = (self.points[:, axis].copy() for axis in plane_of_toolpath(self.points, self.rapid))
        self.x, self.y, self.z = x, y, z
        self.dx, self.dy, self.dz = (v[1:] - v[:-1] for v in (x, y, z))
        self.length = np.sqrt(self.dx * self.dx + self.dy * self.dy)

    def goes_on(self, one: np.ndarray, two: np.ndarray) -> np.ndarray:
        """Return whether trajectories `two` (k,) have nearly the direction of trajectories `one` (k,), (k,) bool."""
        dx, dy, length = self.dx, self.dy, self.length
        return dx[two] * dx[one] + dy[two] * dy[one] > MOVES.ONWARD * length[two] * length[one]


def turned(alpha: np.ndarray, start: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return the turns between moves with the directions `alpha` (m,) rad, and their sum phi in every area.

    Parameters
    ----------
    start : (a,) int
        First move of each area.

    Returns
    -------
    turning, phi, unsigned, reversals : ndarray
        See :class:`Moves`.
    """
    turning = np.zeros(len(alpha))
    turning[1:] = turns(alpha)
    turning[start] = 0.0
    # A half turn has no sign, so `unsigned` contains its index, and phi includes only its difference from pi.
    turned_by = np.abs(turning)
    unsigned = np.flatnonzero(turned_by > np.pi - TURNS.UNSIGNED)
    reversals = unsigned[turned_by[unsigned] > np.pi - TURNS.EXACT]
    turning[unsigned] -= np.copysign(np.pi, turning[unsigned])
    phi = np.cumsum(turning)
    if len(start) > 1:
        phi -= np.repeat(phi[start], np.diff(start, append=len(phi)))
    return turning, phi, unsigned, reversals


def _drop_noise(planar: np.ndarray, length: np.ndarray) -> None:
    """Exclude very short moves beside long moves, because rounding made them, and their directions are random."""
    short = np.flatnonzero(planar & (length < MOVES.NOISE))
    if not len(short):
        return
    before = length[np.maximum(short - 1, 0)]
    after = length[np.minimum(short + 1, len(length) - 1)]
    planar[short[length[short] < MOVES.NOISE_BESIDE * np.maximum(before, after)]] = False


def _split(steps: _Steps, planar: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the trajectories of the planar moves and the first move of each area.

    Areas end at rapids, plunges and lifts. A height change between two moves in the same direction does not end an
    area, because in 3D rasters the tool climbs walls in the middle of a pass.
    """
    index = np.flatnonzero(planar)
    if len(index) == len(planar):
        return index, np.zeros(min(len(index), 1), np.int64)
    gap = np.flatnonzero(index[1:] - index[:-1] > 1) + 1
    if len(gap):
        rapids = np.concatenate([[0], np.cumsum(steps.rapid)])
        after, before = index[gap], index[gap - 1]
        lifted = rapids[after] > rapids[before]
        steep = np.concatenate([[0], np.cumsum(np.where(planar | steps.rapid, 0.0, np.abs(steps.dz)))])
        height = np.abs(steps.z[after] - steps.z[before + 1])
        # Whether the tool drills a hole between two moves: it plunges and lifts by more than their height difference.
        drilled = steep[after] - steep[before] > height + MOVES.STILL
        gap = gap[lifted | drilled | ((height > MOVES.STILL) & ~steps.goes_on(before, after))]
    return index, np.concatenate([[0], gap]) if len(index) else gap


def _without_air(
    steps: _Steps, planar: np.ndarray, index: np.ndarray, start: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Remove links in the air from programs in which the tool lifts, traverses and plunges at feed instead of at rapid.

    A link in the air is a straight and horizontal move between a lift and a plunge. At the start of a program, a link
    needs no lift before it. At the end of a program, or before a final lift at feed, a link needs no plunge after it.
    Directly before or after a rapid at the top height, a link needs only the lift or only the plunge, because some post
    processors write some of the rapids as fast feeds.
    """
    if not len(start) or len(index) == len(planar):
        return index, start
    z, dz, length, rapid = steps.z, steps.dz, steps.length, steps.rapid
    last = np.append(start[1:], len(index)) - 1
    a, b = index[start], index[last]
    horizontal = np.abs(z[b + 1] - z[a]) < MOVES.STILL
    steep = np.where(length > MOVES.STILL, 0.0, dz)  # moves straight up or down, rapid or at feed
    rises, falls = np.append(0.0, steep)[a] > MOVES.STILL, np.append(steep, 0.0)[b + 1] < -MOVES.STILL
    top = z[a] >= z.max() - MOVES.STILL
    end = len(dz)
    while end and steep[end - 1] > MOVES.STILL and not rapid[end - 1]:
        end -= 1
    lifted = rises | (a == 0) | (top & rapid[a - 1])
    plunges = falls | (b == end - 1) | (top & rapid[np.minimum(b + 1, len(rapid) - 1)])
    air = horizontal & steps.goes_on(b, a) & lifted & plunges
    # A horizontal part of a pass between two walls of the part is not a link in the air. A horizontal part of a pass
    # has the direction of a lower move of the pass directly before or after it.
    before, after = b[:-1], a[1:]
    onward = steps.goes_on(before, after)
    # A move at the top height between two rapids is not a part of a pass, whatever its direction: a post processor
    # wrote a rapid as a feed.
    fast = top & (a > 0) & rapid[a - 1] & rapid[np.minimum(b + 1, len(rapid) - 1)]
    air[1:] &= fast[1:] | ~(onward & (z[before + 1] < z[after] - MOVES.STILL))
    air[:-1] &= fast[:-1] | ~(onward & (z[after] < z[before + 1] - MOVES.STILL))
    air &= rises | falls
    several = np.flatnonzero(air & (last > start))
    # A link is straight in all its moves. The first and last move of a link alone do not show this, because an area of
    # several rows can also begin and end with moves in the same direction.
    if len(several):
        ways = np.column_stack([a[several], b[several] + 1]).ravel()
        x, y, way = (np.add.reduceat(v, ways[ways < len(v)])[::2] for v in (steps.dx, steps.dy, length))
        air[several] = np.hypot(x, y) > MOVES.ONWARD * way
    if not air.any():
        return index, start
    keep = ~np.repeat(air, last + 1 - start)
    planar[index[~keep]] = False
    size = (last + 1 - start)[~air]
    return index[keep], np.concatenate([[0], np.cumsum(size)[:-1]]) if len(size) else size


def _holes(steps: _Steps, planar: np.ndarray) -> np.ndarray:
    """Return the last trajectory of every drilled hole: a plunge between two rapids without a move along the plane.

    Several pecks at one point count as one hole. Plunges beside moves along the plane are walls and lead-ins, not
    holes.
    """
    down = np.flatnonzero(~steps.rapid & (steps.length <= MOVES.STILL) & (steps.dz < -MOVES.STILL))
    if not len(down):
        return down
    block = np.cumsum(steps.rapid)
    milled = np.zeros(int(block[-1]) + 1, bool)
    milled[block[planar]] = True
    down = down[~milled[block[down]]]
    x, y = steps.points[down + 1, 0], steps.points[down + 1, 1]
    left = (np.abs(x[1:] - x[:-1]) > MOVES.STILL) | (np.abs(y[1:] - y[:-1]) > MOVES.STILL)
    return down[np.append(left, True)] if len(down) else down
