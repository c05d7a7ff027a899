# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the trajectories that can cut a tile in an oblique view.

Each ray of a tile is parallel to the ray through the tile's middle (the middle ray), at a distance of up to half a
tile. If the tool is enlarged by the largest distance of a ray from the middle ray, it removes from the middle ray at
least what the original tool removes from any ray of the tile. If the tool is reduced by the largest distance, it
removes from the middle ray only what the original tool removes from all rays of the tile.

Depths on different rays are measured from one horizontal plane, so that a level floor has the same depth on all rays.
If all tools are ball-end mills, which cut no flat floors, or if the view is from the side, depths are measured from a
plane perpendicular to the view.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot, sqrt

import numpy as np

from vkworkbench.core.stocks import Solid
from vkworkbench.core.tool import Tool
from vkworkbench.core.view import Frame
from vkworkbench.core.zbuffer.culling.tiles import NOISE, QUARTERS, Removals, Tiles
from vkworkbench.core.zbuffer.rays.chains import removing_intervals
from vkworkbench.core.zbuffer.rays.dexels import THINNEST, before_in_group, beginnings
from vkworkbench.core.zbuffer.sweeps.slots import ROUNDING
from vkworkbench.core.zbuffer.sweeps.trajectories import Trajectories

# Depths are measured from a horizontal plane if the cosine of the angle between the view and the vertical is larger (in
# absolute value) than this limit, and from a plane perpendicular to the view otherwise. With a smaller limit, depths
# would be measured from a horizontal plane also in views nearly from the side; the enlarged and the reduced tool would
# then differ so much from the original tool that no trajectory could be dropped. With a larger limit, a level floor
# would have different depths on the rays of a tile in more views, so fewer trajectories could be dropped.
_LEVEL = 0.3
# Length, mm, by which the reduced tool is made smaller in addition to the distance between rays. Without a margin,
# rounding would decide whether a ray that touches a surface is removed, so the reduced tool could remove too much. With
# a larger margin, fewer trajectories would be dropped.
_LESS = 1e-6


class Tilted:
    """Computes the bounds that `tiles.Bounds` describes, for an oblique view."""

    def __init__(self, trajectories: Trajectories) -> None:
        self.trajectories, self.sine, self.cosine = trajectories, trajectories.sine, trajectories.cosine
        self.frame, self.slow = trajectories.frame, np.ones(len(trajectories.index), bool)
        tools = [kind.tool for kind in trajectories.kinds]
        level = abs(self.cosine) > _LEVEL and not all(tool.rounding == tool.radius for tool in tools)
        self.growths = [_Growth(tool, level, self.sine, self.cosine) for tool in tools]
        self.chords = _TileChords(trajectories.stock, trajectories.frame, self.sine / self.cosine if level else 0.0)

    def quarters(
        self, column: np.ndarray, row: np.ndarray, tile: np.ndarray, item: np.ndarray, child: int
    ) -> Iterator[np.ndarray]:
        """See `tiles.Bounds.quarters`."""
        middle = (child - 1) / 2
        reach = middle * self.frame.pixel * (1 + NOISE)
        both = np.array([[middle], [child + middle]])
        x, y = self.frame.pixel_centres(column + both, row + both)
        places = x.take(tile, axis=1)[None], y.take(tile, axis=1)[:, None], item
        enter, leave = self.trajectories.intervals(*places, [growth.grown(reach) for growth in self.growths])
        opens = self.trajectories.intervals(*places, [growth.shrunk(reach) for growth in self.growths])
        for across, up in QUARTERS:
            near, far = self.chords.over(x[across], y[up], reach)
            first = np.maximum(enter[up, across], near.take(tile))
            last = np.minimum(leave[up, across], far.take(tile))
            met = np.flatnonzero(last - first > 0.9 * THINNEST)
            all_enter, all_leave = (depths[up, across].take(met) for depths in opens)
            yield met[_not_yet_open(tile[met], first[met], last[met], all_enter, all_leave, near, far)]

    def removals(self, tiles: Tiles, tile: np.ndarray, near: np.ndarray, far: np.ndarray) -> Removals:
        """See `tiles.Bounds.removals`."""
        column, row = tiles.pixels()
        x, y = self.frame.pixel_centres(column, row)
        pixels, item = tiles.side**2, tiles.item
        px, py = x.take(tile, axis=1)[None], y.take(tile, axis=1)[:, None]
        enter, leave = self.trajectories.intervals(px, py, item)
        # Rounding errors decide whether a ray at the boundary of a swept area is inside. For a ray of a tile, `passing`
        # decides exactly as for a ray that is cut without tiles. Tiles whose corners are all inside the swept area,
        # which are most tiles, need no decision.
        corners = self.trajectories.passing(px[:, [0, -1]], py[[0, -1]], item)
        doubtful = np.flatnonzero(~corners.all(axis=(0, 1)))
        passing = self.trajectories.passing(px[..., doubtful], py[..., doubtful], item[doubtful])
        enter[..., doubtful] = np.where(passing, enter[..., doubtful], np.inf)
        enter, leave = enter.reshape(pixels, len(item)), leave.reshape(pixels, len(item))
        hit = removing_intervals(tile, enter, leave, near, far)
        return Removals(hit, enter.ravel()[hit], leave.ravel()[hit])


class _TileChords:
    """Lower and upper bounds of the depths at which the rays of a tile enter and leave the stock.

    Depths are measured from a plane that is horizontal or perpendicular to the view. `shear` is the change of the
    plane's depth along the view for each mm down the image; it is 0 for a plane perpendicular to the view.
    """

    def __init__(self, stock: Solid, frame: Frame, shear: float) -> None:
        slope = stock.normals @ frame.direction
        room = stock.offsets - stock.normals @ frame.centre
        right, up = stock.normals @ frame.right, stock.normals @ frame.up
        # The depth at which a ray meets a face plane of the stock is a constant plus a gradient times the image
        # coordinates. Face planes parallel to the rays do not limit the depth.
        met = np.abs(slope) >= 1e-12
        self.entered, self.left = met & (slope < 0), met & (slope > 0)
        slope = np.where(met, slope, 1)
        self.planes = np.array([room, -right, -up]) / slope
        self.shear = shear

    def over(self, x: np.ndarray, y: np.ndarray, reach: float) -> tuple[np.ndarray, np.ndarray]:
        """Return the smallest and the largest depth of the stock in squares of the image, two arrays (t,), mm.

        The squares have their centres at (x, y), two arrays (t,), and extend `reach` mm to each side.
        """
        near, far = np.full(len(x), -np.inf), np.full(len(x), np.inf)
        for constant, gx, gy in self.planes[:, self.entered].T:
            np.maximum(near, constant - (abs(gx) + abs(gy - self.shear)) * reach + gx * x + gy * y, out=near)
        for constant, gx, gy in self.planes[:, self.left].T:
            np.minimum(far, constant + (abs(gx) + abs(gy - self.shear)) * reach + gx * x + gy * y, out=far)
        return near, far


class _Bound(Tool):
    """A tool that is larger or smaller than a given tool.

    The checks of a tool's size are left out, because an enlarged tool can be larger than any allowed tool.
    """

    def __post_init__(self) -> None:
        pass


class _Growth:
    """The enlarged and the reduced tool that replace a tool when the bounds of a tile are computed."""

    def __init__(self, tool: Tool, level: bool, sine: float, cosine: float) -> None:
        self.tool, self.level, self.sine, self.cosine = tool, level, sine, cosine
        self.ball = tool.rounding == tool.radius
        # A bull-nose is replaced by flat-end mills, one enlarged and one reduced. Both flat-end mills are raised by
        # ROUNDING, because `sweeps` lowers the end of a flat-end mill by this length, but not the flat part of a
        # bull-nose.
        self.flat = ROUNDING if 0 < tool.rounding < tool.radius else 0.0

    def _offsets(self, reach: float) -> tuple[float, float]:
        """Return the largest distance of a tile's rays from the middle ray, horizontally and in space, mm.

        In the image, the tile extends `reach` mm from its middle to each side.
        """
        if self.level:
            aside = reach * hypot(1, 1 / self.cosine)
            return aside, aside if self.ball else 0.0
        return reach * hypot(1, self.cosine), reach * sqrt(2)

    def grown(self, reach: float) -> tuple[Tool, float]:
        """Return the enlarged tool, and the height of its tip above the tip of the original tool, mm."""
        aside, away = self._offsets(reach)
        tool = self.tool
        if self.ball:
            return _Bound("ballend", tool.diameter + 2 * away), -away
        lower = 0.0 if self.level else away * self.sine
        if self.flat:
            return _Bound("endmill", tool.diameter + 2 * aside), self.flat - lower
        return self._wider(aside), -lower

    def shrunk(self, reach: float) -> tuple[Tool | None, float]:
        """Return the reduced tool (None if its size is 0), and the height of its tip above the original tip, mm."""
        aside, away = self._offsets(reach)
        tool = self.tool
        aside, away = aside + _LESS, away + (0 if self.level and not self.ball else _LESS)
        diameter = tool.diameter - 2 * (away if self.ball else aside + tool.rounding)
        if diameter <= _LESS:
            return None, 0.0
        if self.flat:
            return _Bound("endmill", diameter), self.flat + away
        if self.ball:
            return _Bound("ballend", diameter), away
        # If the reduced cone has no flat tip, its apex is above the tip of the original cone.
        return self._wider(-aside), away + tool.steepness * max(aside - tool.tip, 0.0)

    def _wider(self, aside: float) -> Tool:
        """Return an end mill or cone whose radius and tip radius are larger by `aside`, mm."""
        tool = self.tool
        tip = max(tool.tip + aside, 0.0) if tool.steepness else 0.0
        return _Bound(tool.shape, tool.diameter + 2 * aside, tool.corner_radius, tool.tip_angle, 2 * tip)


def _not_yet_open(
    tile: np.ndarray,
    enter: np.ndarray,
    leave: np.ndarray,
    all_enter: np.ndarray,
    all_leave: np.ndarray,
    near: np.ndarray,
    far: np.ndarray,
) -> np.ndarray:
    """Return the pairs of a tile and a trajectory that can remove material which earlier trajectories left in the tile.

    Parameters
    ----------
    tile : (p,) ndarray of int
        Tile of each pair of a tile and a trajectory, ascending.
    enter, leave : (p,) ndarray
        Depths between which the pair's trajectory can cut rays of the tile, mm.
    all_enter, all_leave : (p,) ndarray
        Depths between which the pair's trajectory removes all material from all rays of the tile, mm. If ``all_enter >
        all_leave``, there are no such depths.
    near, far : (t,) ndarray
        Smallest and largest depth of the stock in each tile, mm.
    """
    if len(tile) == 0:
        return tile
    start = beginnings(tile)
    near, far = near.take(tile), far.take(tile)
    # The depths of each tile are shifted past the depths of all earlier tiles, so that one running maximum or minimum
    # over all pairs of a tile and a trajectory starts anew in each tile.
    offset = tile * (far.max() - near.min() + 1)
    holds = all_enter <= all_leave
    all_enter, all_leave = np.maximum(all_enter, near), np.minimum(all_leave, far)
    open_near, open_far = near, far
    # Each round extends the gaps at both ends of the rays by the intervals that touch a gap. The second round adds
    # intervals that touch a gap only after the first round.
    for _ in range(2):
        opens = np.where(holds & (all_enter <= open_near), all_leave, near) + offset
        open_near = before_in_group(np.maximum.accumulate(opens), start, (near + offset)[start]) - offset
        opens = np.where(holds & (all_leave >= open_far), all_enter, far) - offset
        open_far = before_in_group(np.minimum.accumulate(opens), start, (far - offset)[start]) + offset
    return np.flatnonzero((leave > open_near + NOISE) & (enter < open_far - NOISE) & (open_near < open_far))
