# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is to be seen of a simulation at a moment: the part, chips on it or alone, by owners' or pixels' colours."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.rendering.palettes import CUT, colors_of, palette
from vkworkbench.core.rendering.shading import BACKGROUND, shade
from vkworkbench.core.zbuffer import ZBuffer

# What is to be noticed.
LIT = np.array((255, 170, 40), np.uint8)


@dataclass(frozen=True, eq=False)
class Scene:
    """A picture of a simulation.

    Attributes
    ----------
    depth : (height, width) float32
        mm, row 0 below; not a number where nothing is seen.
    owner : (height, width) int32
        Trajectory that made the surface, or cuts the chip, that is seen; -1 for the raw stock.
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
    """Return the picture of a simulation at its moment.

    Parameters
    ----------
    zbuffer : ZBuffer
    colors : (n + 1, 3) or (2, 3), or (height, width, 3) uint8
        By who made the surface, see `palette`; or of every pixel of the part, row 0 below.
    chips : tuple of int, optional
        Show also what the trajectories from the first to before the second of these remove, wherever it was.
    part : bool
        Whether the part is shown.
    lit : tuple of int, optional
        Trajectories whose surfaces are to be noticed, likewise.
    background : tuple of int
        Where nothing is seen.
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
