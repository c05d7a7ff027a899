# SPDX-License-Identifier: LGPL-2.1-or-later
"""Provide the image of a simulation, whose regions are cut in this process or in other processes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from vkworkbench.core.stocks import Solid
from vkworkbench.core.view import Frame
from vkworkbench.core.zbuffer.culling.tiles import TILE, Region, Tiles, small_tiles
from vkworkbench.core.zbuffer.culling.tilted import Tilted
from vkworkbench.core.zbuffer.culling.upright import Upright
from vkworkbench.core.zbuffer.rays.records import Records
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.simulator.regions import cut_region
from vkworkbench.core.zbuffer.sweeps.cuts import Cuts


class CutImage:
    """An image that is cut region by region. The image can be pickled and sent to another process.

    Parameters
    ----------
    cuts : Cuts
    stock : Solid
    frame : Frame
        Axes, centre and pixel of the image.

    Attributes
    ----------
    removal : Removal
        The trajectories, prepared for the rays of the image.
    bands : list of Region
        Regions of at most `TILE` rows of pixels that cover the whole image, the lowest region first.
    """

    def __init__(self, cuts: Cuts, stock: Solid, frame: Frame) -> None:
        self._arguments = cuts, stock, frame
        self._uncut = len(cuts)
        self.removal = Removal(cuts, stock, frame)
        self._bounds = Upright(self.removal) if self.removal.sine == 0 else Tilted(self.removal)
        bottoms = range(0, frame.height, TILE)
        self.bands = [Region(0, frame.width, bottom, min(bottom + TILE, frame.height)) for bottom in bottoms]

    def __reduce__(self) -> tuple[Any, ...]:
        return CutImage, self._arguments

    def __call__(self, region: Region, going_on: Callable[[], None] = lambda: None) -> tuple[Records, int]:
        """Cut a region; return its segments of rays, and how often a trajectory was tested against a tile or a pixel.

        `going_on` is called many times a second. An exception raised by `going_on` stops the cutting.
        """
        blocks = _interrupted(small_tiles(self.removal, self._bounds, region), going_on)
        return cut_region(self.removal, self._bounds, blocks, self._uncut, region)


def _interrupted(blocks: Iterator[tuple[Tiles, int]], going_on: Callable[[], None]) -> Iterator[tuple[Tiles, int]]:
    for block in blocks:
        going_on()
        yield block
