# SPDX-License-Identifier: LGPL-2.1-or-later
"""How deep trajectories reach in tiles of an image seen from above or below, and how deep they open all of a tile.

Every ray is vertical, so depth is height, and a tool opens a ray from its tip's surface upwards: it does not matter
whether one looks from above or from below.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from vkworkbench.core.solids import Tool
from vkworkbench.core.zbuffer.culling import QUARTERS, Removals, Tiles, deeper
from vkworkbench.core.zbuffer.opening import opening
from vkworkbench.core.zbuffer.sweeps import lowest
from vkworkbench.core.zbuffer.trajectories import Trajectories

# Margin of a squared distance, mm^2: what rounding may make of the tool's rim.
_RIM = 1e-9
# The same of a length along the rim, mm.
_RIM_LENGTH = 1e-4


class Upright:
    """Bounds for a vertical view; see `culling.Bounds`."""

    def __init__(self, trajectories: Trajectories) -> None:
        self.trajectories, self.frame, self.cosine = trajectories, trajectories.frame, trajectories.cosine
        (x, y, z), (mx, my, _) = trajectories.start, trajectories.move
        ux, uy, run, slope = trajectories.heading
        # The moves from their middles: position, direction, half the length, depth, and slope.
        self.columns = (x + mx / 2, y + my / 2, ux, uy, run / 2, -(z + slope * run / 2))
        self.slope = slope
        half = (trajectories.stock.upper[2] - trajectories.stock.lower[2]) / 2
        self.near, self.far = -float(half), float(half)

    def fine_enough(self, tiles: Tiles) -> bool:
        """See `culling.Bounds.fine_enough`."""
        # Of a sloped move bounds take longer than the surface of what it sweeps.
        if tiles.side > 4:
            return False
        return tiles.side <= 2 or 2 * int(np.count_nonzero(self.slope.take(tiles.item))) > len(tiles.item)

    def quarters(
        self, column: np.ndarray, row: np.ndarray, tile: np.ndarray, item: np.ndarray, child: int
    ) -> Iterator[np.ndarray]:
        """See `culling.Bounds.quarters`."""
        x, y = self.frame.pixel_centres(column + child - 0.5, row + child - 0.5)
        mx, my, ux, uy, half_run, depth = (column.take(item) for column in self.columns)
        dx, dy = x.take(tile), (self.cosine * y).take(tile)
        dx -= mx
        dy -= my
        along0, aside0 = dx * ux + dy * uy, dy * ux - dx * uy
        start = np.flatnonzero(np.diff(tile, prepend=-1))
        step, reach = child / 2 * self.frame.pixel, (child - 1) / 2 * self.frame.pixel
        extent = reach * (np.abs(ux) + np.abs(uy))
        ux *= step
        uy *= step
        kinds = list(self.trajectories.by_kind(item))
        for across, up in QUARTERS:
            right, upwards = 2 * across - 1, (2 * up - 1) * (1 if self.cosine > 0 else -1)
            along, aside = along0 + right * ux + upwards * uy, aside0 + upwards * ux - right * uy
            places = along, aside, extent, half_run, depth
            yield deeper(tile, start, *self._bounds(kinds, item, places), self.near, self.far)

    def removals(self, tiles: Tiles, tile: np.ndarray, near: np.ndarray, far: np.ndarray) -> Removals:
        """See `culling.Bounds.removals`."""
        column, row = tiles.pixels()
        x, y = self.frame.pixel_centres(column, row)
        start = np.flatnonzero(np.diff(tile, prepend=-1))
        depth = self._opened(x.take(tile, axis=1)[None], y.take(tile, axis=1)[:, None], tiles.item)
        if self.cosine > 0:
            hit = opening(depth, tile, start, near, far)
            return Removals(hit, None, depth.ravel()[hit])
        hit = opening(depth, tile, start, -far, -near)
        return Removals(hit, -depth.ravel()[hit], np.full(len(hit), np.inf))

    def _opened(self, x: np.ndarray, y: np.ndarray, item: np.ndarray) -> np.ndarray:
        """Depths (pixels of a tile, p) to which the pairs open the rays of columns x (1, side, p), rows y (side, 1, p)."""
        trajectories = self.trajectories
        start, heading = trajectories.start.take(item, axis=1), trajectories.heading.take(item, axis=1)
        depth = np.empty((len(y), x.shape[1], len(item)))
        for tool, own in trajectories.by_tool(item):
            px, py = x[..., own], y[..., own]
            height, inner = lowest(tool, start[:, own], heading[:, own], px, self.cosine * py)
            # On the rim of a sweep rounding decides: as it does for any other ray.
            rim = np.nonzero((inner >= 0) & (inner < _RIM_LENGTH))
            if len(rim[0]):
                row, column, pair = rim
                passed = trajectories.passing(px[0, column, pair], py[row, 0, pair], item[own][pair])
                height[rim] = np.where(passed, height[rim], np.nan)
            depth[..., own] = np.negative(height, out=height)
        return depth.reshape(-1, len(item))

    def _bounds(
        self, kinds: list[tuple[int, slice | np.ndarray]], item: np.ndarray, places: Sequence[np.ndarray]
    ) -> tuple[np.ndarray, np.ndarray]:
        if len(kinds) == 1:
            return self._of_kind(kinds[0][0], item, places)
        reaches, opens = np.empty((2, len(item)))
        for number, own in kinds:
            reaches[own], opens[own] = self._of_kind(number, item[own], [place[own] for place in places])
        return reaches, opens

    def _of_kind(self, number: int, item: np.ndarray, places: Sequence[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
        tool, level = self.trajectories.kinds[number]
        along, aside, extent, half_run, depth = places
        return bounds(tool, along, aside, extent, half_run, depth, None if level else self.slope.take(item))


def bounds(
    tool: Tool,
    along: np.ndarray,
    aside: np.ndarray,
    extent: np.ndarray,
    half_run: np.ndarray,
    depth: np.ndarray,
    slope: np.ndarray | None,
) -> tuple[np.ndarray, np.ndarray]:
    """Depths that moves reach at most in squares along them, and to which they open all of these at least.

    Parameters
    ----------
    tool : Tool
    along, aside : (p,) ndarray
        Middles of the squares from those of the moves, mm.
    extent, half_run : (p,) ndarray
        Half the squares' sides and half the moves' lengths, mm.
    depth : (p,) ndarray
        Of the moves' middles, mm.
    slope : (p,) ndarray or None
        Rise of the moves per mm; None where all are level.

    Returns
    -------
    reaches, opens : (p,) ndarray
        mm; -inf where a move does not meet a square, or does not cover it.
    """
    radius2 = tool.radius**2
    aside = np.abs(aside)
    beyond = np.abs(along) - half_run
    nearest2 = np.maximum(aside - extent, 0.0) ** 2 + np.maximum(beyond - extent, 0.0) ** 2
    farthest2 = (aside + extent) ** 2 + np.maximum(beyond + extent, 0.0) ** 2
    touched, covered = nearest2 <= radius2 + _RIM, farthest2 <= radius2 - _RIM
    if slope is None:
        reaches, opens = depth - profile(tool, nearest2), depth - profile(tool, farthest2)
    else:
        deepest, shallowest = _sloped(tool, along, aside, extent, half_run, slope, nearest2)
        reaches, opens = depth + deepest, depth + shallowest
    return np.where(touched, reaches, -np.inf), np.where(covered, opens, -np.inf)


def _sloped(
    tool: Tool,
    along: np.ndarray,
    aside: np.ndarray,
    extent: np.ndarray,
    half_run: np.ndarray,
    slope: np.ndarray,
    nearest2: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """Depths below the move's middle that it reaches at most and opens at least."""
    flat, corner, k = tool.radius - tool.rounding, tool.rounding, tool.steepness
    steepness = np.abs(slope)
    inner = np.maximum(aside - extent, 0)
    # Above a point of the tile the tool's axis stands at most so far before or behind it.
    half = np.sqrt(np.maximum(tool.radius**2 - inner**2, 0.0))
    first = np.maximum(-along - half_run - extent, -half)
    last = np.minimum(-along + half_run + extent, half)
    lowest = np.minimum(slope * first, slope * last) + profile(tool, nearest2)
    # The lowest place of the tool when its move has no ends: a bound too, better for long moves.
    secant = np.sqrt(1 + slope**2)
    if k == 0:
        round_part = np.maximum(inner - flat, 0)
        endless = corner - np.sqrt(np.maximum(corner**2 - round_part**2, 0.0)) * secant - steepness * flat
    else:
        endless = np.where(steepness < k, inner * np.sqrt(np.maximum(k**2 - slope**2, 0.0)) - k * tool.tip, -np.inf)
    deepest = -slope * along + steepness * extent - np.maximum(lowest, endless)

    # Above each point the tool stands where it is about lowest, as far as the move goes.
    outer = aside + extent
    if k == 0:
        rest = np.sqrt(np.maximum(corner**2 - np.maximum(outer - flat, 0.0) ** 2, 0.0))
        ahead = np.sqrt(np.maximum(flat**2 - outer**2, 0.0)) + rest * steepness / secant
    else:
        gentle = np.sqrt(np.maximum(k**2 - slope**2, 1e-12))
        ahead = np.maximum(steepness * outer / gentle, np.sqrt(np.maximum(tool.tip**2 - outer**2, 0.0)))
        ahead = np.where(steepness < k, ahead, np.inf)
        ahead = np.minimum(ahead, np.sqrt(np.maximum(tool.radius**2 - outer**2, 0.0)))
    # The edge of the tool is left out: rounding would put it outside.
    best = -np.sign(slope) * ahead * (1 - 1e-9)
    at_low = np.clip(along - extent + best, -half_run, half_run)
    at_high = np.clip(along + extent + best, -half_run, half_run)
    away = np.maximum(np.abs(at_low - along + extent), np.abs(at_high - along - extent))
    distance2 = outer**2 + away**2
    highest = np.maximum(slope * at_low, slope * at_high) + profile(tool, distance2)
    opened = np.where(distance2 <= tool.radius**2, -highest, -np.inf)
    return deepest, opened


def profile(tool: Tool, distance2: np.ndarray) -> np.ndarray | float:
    """`Tool.height` at squared distances from the axis, its value at the rim beyond the rim."""
    corner = tool.rounding
    if corner == 0 and tool.steepness == 0:
        return 0.0
    rise: np.ndarray
    if corner == tool.radius:
        rise = corner - np.sqrt(np.maximum(corner**2 - distance2, 0))
        return rise
    distance = np.sqrt(np.minimum(distance2, tool.radius**2))
    if corner == 0:
        rise = tool.steepness * np.maximum(distance - tool.tip, 0)
    else:
        beyond_flat = np.maximum(distance - (tool.radius - corner), 0.0)
        rise = corner - np.sqrt(np.maximum(corner**2 - beyond_flat**2, 0.0))
    return rise
