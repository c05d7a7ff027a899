# SPDX-License-Identifier: LGPL-2.1-or-later
"""How deep trajectories reach in tiles of an image seen from above or below, and how deep they open all of a tile.

Every ray is vertical, so depth is height, and a tool opens a ray from its tip's surface upwards: it does not matter
whether one looks from above or from below.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from vkworkbench.core.tool import Tool
from vkworkbench.core.zbuffer.culling.tiles import QUARTERS, Removals, Tiles, deeper_pairs
from vkworkbench.core.zbuffer.rays.dexels import beginnings
from vkworkbench.core.zbuffer.rays.opening import opening
from vkworkbench.core.zbuffer.sweeps.intervals import lowest
from vkworkbench.core.zbuffer.sweeps.trajectories import Trajectories

# Margin of a squared distance, mm^2: what rounding may make of the tool's rim.
_RIM = 1e-9
# The same of a length along the rim, mm.
_RIM_LENGTH = 1e-4


class Upright:
    """Bounds for a vertical view; see `tiles.Bounds`."""

    def __init__(self, trajectories: Trajectories) -> None:
        self.trajectories, self.frame, self.cosine = trajectories, trajectories.frame, trajectories.cosine
        (x, y, z), (mx, my, _) = trajectories.start, trajectories.move
        ux, uy, run, slope = trajectories.heading
        # The moves from their middles: position, direction, half the length, depth, and slope.
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
            places = along, aside, extent, half_run, depth
            yield deeper_pairs(tile, start, *_of_kinds(kinds, places), self.near, self.far)

    def removals(self, tiles: Tiles, tile: np.ndarray, near: np.ndarray, far: np.ndarray) -> Removals:
        """See `tiles.Bounds.removals`."""
        column, row = tiles.pixels()
        x, y = self.frame.pixel_centres(column, row)
        start = beginnings(tile)
        depth = self._opened(x.take(tile, axis=1)[None], y.take(tile, axis=1)[:, None], tiles.item)
        if self.cosine > 0:
            hit = opening(depth, tile, start, near, far)
            return Removals(hit, None, depth.ravel()[hit])
        hit = opening(depth, tile, start, -far, -near)
        pixel, pair = np.divmod(hit, len(tile))
        ray = pixel, tile[pair]
        return Removals(hit, np.maximum(-depth.ravel()[hit], near[ray]), far[ray])

    def _opened(self, x: np.ndarray, y: np.ndarray, item: np.ndarray) -> np.ndarray:
        """Depths (pixels of a tile, p) to which the pairs open the rays of columns x (1, side, p), rows y (side, 1, p)."""
        trajectories = self.trajectories
        start, heading = trajectories.start.take(item, axis=1), trajectories.heading.take(item, axis=1)
        depth = np.empty((len(y), x.shape[1], len(item)))
        for tool, own in trajectories.by_tool(item):
            px, py = x[..., own], y[..., own]
            height, inner = lowest(tool, start[:, own], heading[:, own], px, self.cosine * py)
            # On the rim of a sweep rounding decides: as it does for any other ray.
            at = np.flatnonzero((inner < _RIM_LENGTH) & (inner >= 0))
            if len(at):
                rim = row, column, pair = np.unravel_index(at, inner.shape)
                passed = trajectories.passing(px[0, column, pair], py[row, 0, pair], item[own][pair])
                height[rim] = np.where(passed, height[rim], np.nan)
            depth[..., own] = np.negative(height, out=height)
        return depth.reshape(-1, len(item))

    def _kinds(self, item: np.ndarray) -> Iterator[tuple[Tool, bool, slice | np.ndarray]]:
        """Tools, whether their moves are level, and which of the items are theirs."""
        return ((*self.trajectories.kinds[number], own) for number, own in self.trajectories.by_kind(item))


class Slopes:
    """Rise of moves per mm, (p,), and what follows from it.

    Attributes
    ----------
    slope, steepness, secant : (p,) ndarray
        The rise with its sign and without; mm of the move per mm in the plane.
    lean : (p,) ndarray
        How far from its axis a ball is lowest above its path, and on which side, in radii.
    """

    def __init__(self, slope: np.ndarray) -> None:
        self.slope, self.steepness = slope, np.abs(slope)
        self.secant = np.sqrt(1 + slope * slope)
        self.lean = -slope / self.secant


def _of_kinds(
    kinds: Sequence[tuple[Tool, slice | np.ndarray, Slopes | None]], places: Sequence[np.ndarray]
) -> tuple[np.ndarray, np.ndarray]:
    """`bounds` of pairs of several kinds."""
    if len(kinds) == 1:
        tool, _, slopes = kinds[0]
        return bounds(tool, slopes, *places)
    reaches, opens = np.empty((2, len(places[0])))
    for tool, own, slopes in kinds:
        reaches[own], opens[own] = bounds(tool, slopes, *(place[own] for place in places))
    return reaches, opens


def bounds(
    tool: Tool,
    slopes: Slopes | None,
    along: np.ndarray,
    aside: np.ndarray,
    extent: np.ndarray,
    half_run: np.ndarray,
    depth: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """Depths that moves reach at most in squares along them, and to which they open all of these at least.

    Parameters
    ----------
    tool : Tool
    slopes : Slopes or None
        None where all moves are level.
    along, aside : (p,) ndarray
        Middles of the squares from those of the moves, mm.
    extent, half_run : (p,) ndarray
        Half the squares' sides and half the moves' lengths, mm.
    depth : (p,) ndarray
        Of the moves' middles, mm.

    Returns
    -------
    reaches, opens : (p,) ndarray
        mm; -inf or not a number where a move does not meet a square, or does not cover it.
    """
    aside = np.abs(aside)
    if tool.rounding == tool.radius:
        return _bounds_of_ball(tool.radius, slopes, along, aside, extent, half_run, depth)
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
        reaches = _deepest(tool, along, extent, half_run, slopes, inner, inner2, nearest2)
        opens = _opened(tool, along, extent, half_run, slopes, outer, outer2)
        reaches += depth
        opens += depth
    np.copyto(reaches, -np.inf, where=nearest2 > radius2 + _RIM)
    np.copyto(opens, -np.inf, where=farthest2 > radius2 - _RIM)
    return reaches, opens


def _bounds_of_ball(
    radius: float,
    slopes: Slopes | None,
    along: np.ndarray,
    aside: np.ndarray,
    extent: np.ndarray,
    half_run: np.ndarray,
    depth: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """`bounds` of a ball: at places of its axis as in `sweeps.lowest`, in a square and at the corners of its outer side.

    What a ball sweeps is convex, so it is lowest in the square at most where it would be on a move longer by the square,
    at its inner side, and highest at a corner. Where it misses, roots are not numbers.
    """
    inner, outer = np.maximum(aside - extent, 0.0), aside + extent
    inner2 = np.subtract(radius**2 + _RIM, np.multiply(inner, inner, out=inner), out=inner)
    outer2 = np.subtract(radius**2 - _RIM, np.multiply(outer, outer, out=outer), out=outer)
    depth = depth - radius

    def depths(chord2: np.ndarray, begin: np.ndarray, end: np.ndarray) -> np.ndarray:
        """Of the tool with this half chord, squared, its axis from begin to end; both are overwritten."""
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


def _deepest(
    tool: Tool,
    along: np.ndarray,
    extent: np.ndarray,
    half_run: np.ndarray,
    slopes: Slopes,
    inner: np.ndarray,
    inner2: np.ndarray,
    nearest2: np.ndarray,
) -> np.ndarray:
    """Depths below the moves' middles that sloped ones reach at most, their tools `inner` aside at least."""
    flat, corner, k = tool.radius - tool.rounding, tool.rounding, tool.steepness
    slope = slopes.slope
    # From the lower end of the square, from which heights count below, the tool's axis is at most its half chord away, and
    # no farther than the end of the move.
    half = _root(tool.radius**2 - inner2)
    reach = half_run - extent
    first = np.maximum(-along - reach, -half)
    last = np.minimum(reach - along, half)
    first *= slope
    last *= slope
    lowest = np.minimum(first, last, out=first)
    lowest += _profile(tool, nearest2)
    # The lowest place of the tool when its move has no ends: a bound too, better for long moves.
    if k == 0:
        endless = corner - _root(corner**2 - np.maximum(inner - flat, 0) ** 2) * slopes.secant
        endless -= slopes.steepness * flat
    else:
        endless = np.where(slopes.steepness < k, inner * _root(k**2 - slope**2) - k * tool.tip, -np.inf)
    deepest: np.ndarray = slopes.steepness * extent
    deepest -= slope * along
    deepest -= np.maximum(lowest, endless, out=lowest)
    return deepest


def _opened(
    tool: Tool,
    along: np.ndarray,
    extent: np.ndarray,
    half_run: np.ndarray,
    slopes: Slopes,
    outer: np.ndarray,
    outer2: np.ndarray,
) -> np.ndarray:
    """Depths below the moves' middles that sloped ones open all of a square, `outer` aside at most, if they cover it."""
    flat, corner, k = tool.radius - tool.rounding, tool.rounding, tool.steepness
    slope, steepness = slopes.slope, slopes.steepness
    # Above each point the tool stands where it is about lowest, as far as the move goes.
    if k == 0:
        ahead = _root(corner**2 - np.maximum(outer - flat, 0.0) ** 2)
        ahead *= steepness
        ahead /= slopes.secant
        ahead += _root(flat**2 - outer2)
    else:
        gentle = np.sqrt(np.maximum(k**2 - slope**2, 1e-12))
        ahead = np.maximum(steepness * outer / gentle, _root(tool.tip**2 - outer2))
        ahead = np.where(steepness < k, ahead, np.inf)
        ahead = np.minimum(ahead, _root(tool.radius**2 - outer2))
    # The edge of the tool is left out: rounding would put it outside.
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
    opened: np.ndarray = np.negative(highest, out=highest)
    return opened


def _root(square: np.ndarray) -> np.ndarray:
    """The square root in place, 0 of what is less."""
    root: np.ndarray = np.sqrt(np.maximum(square, 0.0, out=square), out=square)
    return root


def _profile(tool: Tool, distance2: np.ndarray) -> np.ndarray | float:
    """`Tool.profile` at squared distances from the axis; of a flat end it takes no time."""
    return tool.profile(np.sqrt(distance2)) if tool.rounding or tool.steepness else 0.0
