# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the trajectories that can cut a tile in a view from above or below.

For each pair of a tile and a trajectory, two bounds are computed: the largest depth that the trajectory reaches in the
tile, and the depth to which the trajectory opens all rays of the tile. Every ray is vertical, so a depth is a height,
and a tool removes all material above the tool's lower surface. Therefore the bounds are the same for a view from above
and for a view from below.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from vkworkbench.core.tool import Tool
from vkworkbench.core.zbuffer.culling.tiles import QUARTERS, Removals, Tiles, deeper_pairs
from vkworkbench.core.zbuffer.rays.dexels import beginnings
from vkworkbench.core.zbuffer.rays.opening import opening
from vkworkbench.core.zbuffer.sweeps.intervals import lowest
from vkworkbench.core.zbuffer.sweeps.trajectories import Trajectories

# Margin for comparing a squared distance with the tool's squared radius, mm^2. With a smaller margin, a rounding error
# at the tool's outer edge (rim) could drop a trajectory that cuts the tile. With a larger margin, more trajectories
# that miss the tile would stay in the tile's list.
_RIM = 1e-9
# Distance from the boundary of a swept area, mm, below which `Trajectories.passing` decides whether a ray is inside.
# With a smaller distance, rounding errors could give different results for a ray in a tile and for the same ray cut
# alone. With a larger distance, `Trajectories.passing` would be computed for more rays.
_RIM_LENGTH = 1e-4


class Upright:
    """Computes the bounds that `tiles.Bounds` describes, for a vertical view."""

    def __init__(self, trajectories: Trajectories) -> None:
        self.trajectories, self.frame, self.cosine = trajectories, trajectories.frame, trajectories.cosine
        (x, y, z), (mx, my, _) = trajectories.start, trajectories.move
        ux, uy, run, slope = trajectories.heading
        # For each move: x and y of the move's middle, its direction in the xy plane, half its length in the xy plane,
        # and the depth of its middle.
        self.measures = (x + mx / 2, y + my / 2, ux, uy, run / 2, -(z + slope * run / 2))
        self.slope, self.slow = slope, slope != 0
        half = (trajectories.stock.upper[2] - trajectories.stock.lower[2]) / 2
        self.near, self.far = -float(half), float(half)

    def quarters(
        self, column: np.ndarray, row: np.ndarray, tile: np.ndarray, item: np.ndarray, child: int
    ) -> Iterator[np.ndarray]:
        """See `tiles.Bounds.quarters`."""
        x, y = self.frame.pixel_centres(column + child - 0.5, row + child - 0.5)
        mx, my, ux, uy, half_run, depth = (measure.take(item) for measure in self.measures)
        dx, dy = x.take(tile), (self.cosine * y).take(tile)
        dx -= mx
        dy -= my
        along0, aside0 = dx * ux + dy * uy, dy * ux - dx * uy
        start = beginnings(tile)
        step, reach = child / 2 * self.frame.pixel, (child - 1) / 2 * self.frame.pixel
        extent = reach * (np.abs(ux) + np.abs(uy))
        ux *= step
        uy *= step
        kinds = [
            (tool, own, None if level else Slopes(self.slope.take(item[own]))) for tool, level, own in self._kinds(item)
        ]
        for across, up in QUARTERS:
            right, upwards = 2 * across - 1, (2 * up - 1) * (1 if self.cosine > 0 else -1)
            along, aside = along0 + right * ux + upwards * uy, aside0 + upwards * ux - right * uy
            squares = Squares(along, aside, extent, half_run, depth)
            yield deeper_pairs(tile, start, *_bounds_by_kind(kinds, squares), self.near, self.far)

    def removals(self, tiles: Tiles, tile: np.ndarray, near: np.ndarray, far: np.ndarray) -> Removals:
        """See `tiles.Bounds.removals`."""
        column, row = tiles.pixels()
        x, y = self.frame.pixel_centres(column, row)
        start = beginnings(tile)
        depth = self._opened_depths(x.take(tile, axis=1)[None], y.take(tile, axis=1)[:, None], tiles.item)
        if self.cosine > 0:
            hit = opening(depth, tile, start, near, far)
            return Removals(hit, None, depth.ravel()[hit])
        hit = opening(depth, tile, start, -far, -near)
        pixel, pair = np.divmod(hit, len(tile))
        ray = pixel, tile[pair]
        return Removals(hit, np.maximum(-depth.ravel()[hit], near[ray]), far[ray])

    def _opened_depths(self, x: np.ndarray, y: np.ndarray, item: np.ndarray) -> np.ndarray:
        """Return the depth to which each pair's trajectory cuts each ray of the pair's tile, (pixels of a tile, p) mm.

        The pixel columns of the tiles are at `x` (1, side, p), and the pixel rows at `y` (side, 1, p), mm.
        """
        trajectories = self.trajectories
        start, heading = trajectories.start.take(item, axis=1), trajectories.heading.take(item, axis=1)
        depth = np.empty((len(y), x.shape[1], len(item)))
        for tool, own in trajectories.by_tool(item):
            px, py = x[..., own], y[..., own]
            height, inner = lowest(tool, start[:, own], heading[:, own], px, self.cosine * py)
            # Rounding errors decide whether a ray at the boundary of a swept area is inside. For a ray of a tile,
            # `passing` decides exactly as for a ray that is cut without tiles.
            at = np.flatnonzero((inner < _RIM_LENGTH) & (inner >= 0))
            if len(at):
                rim = row, column, pair = np.unravel_index(at, inner.shape)
                passed = trajectories.passing(px[0, column, pair], py[row, 0, pair], item[own][pair])
                height[rim] = np.where(passed, height[rim], np.nan)
            depth[..., own] = np.negative(height, out=height)
        return depth.reshape(-1, len(item))

    def _kinds(self, item: np.ndarray) -> Iterator[tuple[Tool, bool, slice | np.ndarray]]:
        """Group `item` by tool and by level or sloped moves; yield tool, whether level, and positions in `item`."""
        return ((*self.trajectories.kinds[number], own) for number, own in self.trajectories.by_kind(item))


class Slopes:
    """The slopes of moves, and quantities computed from these slopes.

    Attributes
    ----------
    slope, steepness, secant : (p,) ndarray
        Signed rise, absolute rise, and length in space, each per mm of the move's length in the xy plane.
    lean : (p,) ndarray
        Position along the move, relative to a point on the move's line, at which a ball of radius 1 is lowest above the
        point.
    """

    def __init__(self, slope: np.ndarray) -> None:
        self.slope, self.steepness = slope, np.abs(slope)
        self.secant = np.sqrt(1 + slope * slope)
        self.lean = -slope / self.secant


class Squares(NamedTuple):
    """Pairs of a square of the image and a move, with the square's position relative to the move.

    Attributes
    ----------
    along, aside : (p,) ndarray
        Position of the square's middle relative to the move's middle, along and perpendicular to the move, mm.
    extent : (p,) ndarray
        Half the side, mm, of the smallest square that contains the given square and has sides parallel to the move.
    half_run : (p,) ndarray
        Half the length of the move in the xy plane, mm.
    depth : (p,) ndarray
        Depth of the middle of the move, mm.
    """

    along: np.ndarray
    aside: np.ndarray
    extent: np.ndarray
    half_run: np.ndarray
    depth: np.ndarray


def _bounds_by_kind(
    kinds: Sequence[tuple[Tool, slice | np.ndarray, Slopes | None]], squares: Squares
) -> tuple[np.ndarray, np.ndarray]:
    """Compute `bounds` separately for each tool, and separately for its level moves and its sloped moves."""
    if len(kinds) == 1:
        tool, _, slopes = kinds[0]
        return bounds(tool, slopes, squares)
    reaches, opens = np.empty((2, len(squares.along)))
    for tool, own, slopes in kinds:
        reaches[own], opens[own] = bounds(tool, slopes, Squares(*(column[own] for column in squares)))
    return reaches, opens


def bounds(tool: Tool, slopes: Slopes | None, squares: Squares) -> tuple[np.ndarray, np.ndarray]:
    """Return an upper and a lower bound of the depths to which moves cut squares of the image.

    `reaches` is an upper bound of the depth that a move reaches in the square. `opens` is a lower bound of the depth to
    which the move cuts every ray of the square.

    Parameters
    ----------
    slopes : Slopes or None
        None if all moves are level.
    squares : Squares
        One square and one move for each pair.

    Returns
    -------
    reaches, opens : (p,) ndarray
        The bounds, mm. `reaches` is -inf or NaN if the move does not meet the square; `opens` is -inf or NaN if the
        tool does not pass over the whole square.
    """
    if tool.rounding == tool.radius:
        return _bounds_of_ball(tool.radius, slopes, squares)
    along, aside, extent, half_run, depth = squares
    aside = np.abs(aside)
    radius2 = tool.radius**2
    beyond = np.abs(along) - half_run
    inner = np.maximum(aside - extent, 0.0)
    outer = aside + extent
    inner2, outer2 = inner * inner, outer * outer
    nearest2 = np.maximum(beyond - extent, 0.0)
    nearest2 *= nearest2
    nearest2 += inner2
    beyond += extent
    farthest2 = np.maximum(beyond, 0.0, out=beyond)
    farthest2 *= farthest2
    farthest2 += outer2
    if slopes is None:
        reaches, opens = depth - _profile(tool, nearest2), depth - _profile(tool, farthest2)
    else:
        reaches = _deepest_reach(tool, slopes, squares, inner, inner2, nearest2)
        opens = _least_opening(tool, slopes, squares, outer, outer2)
        reaches += depth
        opens += depth
    np.copyto(reaches, -np.inf, where=nearest2 > radius2 + _RIM)
    np.copyto(opens, -np.inf, where=farthest2 > radius2 - _RIM)
    return reaches, opens


def _bounds_of_ball(radius: float, slopes: Slopes | None, squares: Squares) -> tuple[np.ndarray, np.ndarray]:
    """Compute `bounds` for a ball-end mill.

    The swept volume of a ball is convex. Therefore, within the square, the lower surface of the volume is highest at a
    corner of the square's outer side, which is the side farther from the line of the move. A lower bound of the
    surface's height is its height at the opposite (inner) side, computed for a move that is longer by the size of the
    square. The bounds are NaN where the ball misses the square.
    """
    along, aside, extent, half_run, depth = squares
    aside = np.abs(aside)
    inner, outer = np.maximum(aside - extent, 0.0), aside + extent
    inner2 = np.subtract(radius**2 + _RIM, np.multiply(inner, inner, out=inner), out=inner)
    outer2 = np.subtract(radius**2 - _RIM, np.multiply(outer, outer, out=outer), out=outer)
    depth = depth - radius

    def depths(chord2: np.ndarray, begin: np.ndarray, end: np.ndarray) -> np.ndarray:
        """Return depths of the swept ball's surface; `chord2` is the squared half length of the ball's chord.

        The chord is parallel to the move. The ball's axis is between `begin` and `end` along the move; the function
        overwrites `begin` and `end`.
        """
        if slopes is None:
            at = np.maximum(begin, 0, out=begin)
        else:
            at = np.sqrt(chord2)
            at *= slopes.lean
            np.maximum(at, begin, out=at)
        np.minimum(at, end, out=at)
        left: np.ndarray = np.multiply(at, at, out=end)
        np.sqrt(np.subtract(chord2, left, out=left), out=left)
        if slopes is not None:
            at *= slopes.slope
            left -= at
        return left

    with np.errstate(invalid="ignore"):
        reach = half_run + extent
        low, high = along - extent, along + extent
        reaches = depths(inner2, -along - reach, reach - along)
        opens_low, opens_high = (
            depths(outer2, -half_run - low, half_run - low),
            depths(outer2, -half_run - high, half_run - high),
        )
        if slopes is not None:
            rise = slopes.slope * along
            reaches -= rise
            reaches += slopes.steepness * extent
            opens_low -= slopes.slope * low
            opens_high -= slopes.slope * high
        opens = np.minimum(opens_low, opens_high, out=opens_low)
        reaches += depth
        opens += depth
    return reaches, opens


def _deepest_reach(
    tool: Tool, slopes: Slopes, squares: Squares, inner: np.ndarray, inner2: np.ndarray, nearest2: np.ndarray
) -> np.ndarray:
    """Return the largest depth below the middle of each sloped move that its tool can reach in the square, mm.

    Parameters
    ----------
    inner, inner2 : (p,) ndarray
        Smallest distance from the square to the line of the move, mm, and the squared distance, mm^2.
    nearest2 : (p,) ndarray
        Squared smallest distance from the square to the move, mm^2.
    """
    along, _, extent, half_run, _ = squares
    flat, corner = tool.radius - tool.rounding, tool.rounding
    slope = slopes.slope
    # The move's line has a different height at each end of the square. The code below measures heights from the smaller
    # of the two heights of the move's line. While the tool is above the square, its axis is on the move, and at most
    # half a chord of the tool away from the square.
    half = _root(tool.radius**2 - inner2)
    reach = half_run - extent
    first = np.maximum(-along - reach, -half)
    last = np.minimum(reach - along, half)
    first *= slope
    last *= slope
    lowest = np.minimum(first, last, out=first)
    lowest += _profile(tool, nearest2)
    # A second bound is the lowest height of the tool above the square on an endless move; for a long move, this bound
    # is closer to the exact height.
    if tool.steepness == 0:
        endless = corner - _root(corner**2 - np.maximum(inner - flat, 0) ** 2) * slopes.secant
        endless -= slopes.steepness * flat
    else:
        endless = inner * _root(tool.steepness**2 - slope**2) - tool.steepness * tool.tip
        endless = np.where(slopes.steepness < tool.steepness, endless, -np.inf)
    deepest: np.ndarray = slopes.steepness * extent
    deepest -= slope * along
    deepest -= np.maximum(lowest, endless, out=lowest)
    return deepest


def _least_opening(tool: Tool, slopes: Slopes, squares: Squares, outer: np.ndarray, outer2: np.ndarray) -> np.ndarray:
    """Return the depth below the middle of each sloped move to which the move cuts all rays of its square, mm.

    The result is valid only if the tool passes over the whole square. `outer` (p,) is the largest distance from the
    square to the line of the move, mm, and `outer2` (p,) is the squared distance, mm^2.
    """
    along, _, extent, half_run, _ = squares
    flat, corner = tool.radius - tool.rounding, tool.rounding
    slope, steepness = slopes.slope, slopes.steepness
    # For each end of the square along the move, the tool is placed near the position on the move at which the tool is
    # lowest above this end. Every position gives a valid bound; the position at which the tool is lowest gives the best
    # bound.
    if tool.steepness == 0:
        ahead = _root(corner**2 - np.maximum(outer - flat, 0.0) ** 2)
        ahead *= steepness
        ahead /= slopes.secant
        ahead += _root(flat**2 - outer2)
    else:
        gentle = np.sqrt(np.maximum(tool.steepness**2 - slope**2, 1e-12))
        ahead = np.maximum(steepness * outer / gentle, _root(tool.tip**2 - outer2))
        ahead = np.where(steepness < tool.steepness, ahead, np.inf)
        ahead = np.minimum(ahead, _root(tool.radius**2 - outer2))
    # Shorten `ahead`, the distance along the move from the point to the tool's axis, slightly, so that rounding errors
    # do not put the point outside the tool.
    ahead *= 1 - 1e-9
    best = np.copysign(ahead, -slope, out=ahead)
    low, high = along - extent, along + extent
    at_low = np.minimum(np.maximum(low + best, -half_run), half_run)
    at_high = np.minimum(np.maximum(high + best, -half_run), half_run)
    away = np.maximum(np.abs(np.subtract(at_low, low, out=low)), np.abs(np.subtract(at_high, high, out=high)))
    distance2 = np.multiply(away, away, out=away)
    distance2 += outer2
    at_low *= slope
    at_high *= slope
    highest = np.maximum(at_low, at_high, out=at_low)
    highest += _profile(tool, distance2)
    return np.negative(highest, out=highest)


def _root(square: np.ndarray) -> np.ndarray:
    """Replace values by their square roots, and negative values by 0, in place; return the array."""
    return np.sqrt(np.maximum(square, 0.0, out=square), out=square)


def _profile(tool: Tool, distance2: np.ndarray) -> np.ndarray | float:
    """Return `Tool.profile` at squared distances from the axis, or the number 0 for a flat end."""
    return tool.profile(np.sqrt(distance2)) if tool.rounding or tool.steepness else 0.0
