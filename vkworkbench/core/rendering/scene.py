# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a simulation at one moment: the part, chips on the part, or chips alone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.rendering.palettes import CUT, colors_of, palette
from vkworkbench.core.rendering.shading import BACKGROUND, shade
from vkworkbench.core.zbuffer import ZBuffer

# Colour of highlighted surfaces.
LIT = np.array((255, 170, 40), np.uint8)


@dataclass(frozen=True, eq=False)
class Scene:
    """A picture of a simulation.

    Attributes
    ----------
    depth : (height, width) float32
        mm, row 0 below; NaN where the image is empty.
    owner : (height, width) int32
        Trajectory that made the visible surface, or that cuts the visible chip; -1 for the raw stock.
    image : (height, width, 3) uint8
        Row 0 at the top.
    """

    depth: np.ndarray
    owner: np.ndarray
    image: np.ndarray


def scene(
    zbuffer: ZBuffer,
    colors: np.ndarray,
    *,
    chips: tuple[int, int] | None = None,
    part: bool = True,
    lit: tuple[int, int] | None = None,
    background: tuple[int, int, int] = BACKGROUND,
) -> Scene:
    """Return the picture of a simulation at its current moment.

    Parameters
    ----------
    zbuffer : ZBuffer
    colors : (n + 1, 3) or (2, 3), or (height, width, 3) uint8
        Colours by owner, see `palette`; or the colour of every pixel of the part, row 0 below.
    chips : tuple of int, optional
        Also show the material that the trajectories chips[0] .. chips[1] - 1 remove, in front of the part.
    part : bool
        Whether the part is shown.
    lit : tuple of int, optional
        Highlight the surfaces of the trajectories lit[0] .. lit[1] - 1.
    background : tuple of int
        Colour of empty pixels.
    """
    size = zbuffer.frame.height, zbuffer.frame.width
    by_owner = colors if colors.ndim == 2 else palette(CUT)
    of_pixels = colors if colors.ndim == 3 else None
    if chips is None:
        depth, owner = zbuffer.picture.depth, zbuffer.picture.owner
        in_front = np.zeros(len(depth), bool)
    else:
        removed = zbuffer.chips(*chips)
        depth, owner, in_front = removed.depth, removed.owner, ~np.isnan(removed.depth)
        if part:
            seen = zbuffer.picture
            with np.errstate(invalid="ignore"):
                in_front &= ~(seen.depth < depth)
            depth, owner = np.where(in_front, depth, seen.depth), np.where(in_front, owner, seen.owner)
    depth, owner = depth.reshape(size), owner.reshape(size)
    shown = colors_of(owner, by_owner)
    if of_pixels is not None:
        shown = np.where(in_front.reshape(*size, 1), shown, of_pixels)
    if lit is not None:
        shown[(owner >= lit[0]) & (owner < lit[1])] = LIT
    return Scene(depth, owner, shade(depth, zbuffer.frame.pixel, shown, background))
