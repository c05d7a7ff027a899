# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is to be seen of a simulation at a moment: the part, chips on it or alone, in the colours of a palette."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.rendering.palettes import colors_of
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
    palette: np.ndarray,
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
    palette : (n + 1, 3) or (2, 3) uint8
        Colours by who made the surface; see `palette`.
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
    if chips is None:
        depth, owner = zbuffer.picture.depth, zbuffer.picture.owner
    else:
        removed = zbuffer.chips(*chips)
        depth, owner = removed.depth, removed.owner
        if part:
            seen = zbuffer.picture
            with np.errstate(invalid="ignore"):
                behind = np.isnan(depth) | (seen.depth < depth)
            depth, owner = np.where(behind, seen.depth, depth), np.where(behind, seen.owner, owner)
    depth, owner = depth.reshape(size), owner.reshape(size)
    colors = colors_of(owner, palette)
    if lit is not None:
        colors[(owner >= lit[0]) & (owner < lit[1])] = LIT
    return Scene(depth, owner, shade(depth, zbuffer.frame.pixel, colors, background))
