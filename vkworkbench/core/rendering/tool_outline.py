# SPDX-License-Identifier: LGPL-2.1-or-later
"""The outline of the tool in an image: the convex hull of the rings of its profile."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.hull import convex_hull
from vkworkbench.core.rendering.camera import project
from vkworkbench.core.tool import Tool
from vkworkbench.core.view import Frame

_AROUND, _ALONG = 32, 7
# Drawn length of the shank, in diameters.
_LENGTH = 3.0


def tool_outline(tool: Tool, tip: np.ndarray, frame: Frame) -> np.ndarray:
    """Return the outline of a tool in the image.

    Parameters
    ----------
    tool : Tool
    tip : (3,) array_like
        Position of the tip, mm.
    frame : Frame

    Returns
    -------
    (m, 2) ndarray
        Corners of a convex polygon, column and row in pixels from the image's upper left corner.
    """
    # Includes the radii at which the profile has a corner or a flat ends.
    radii = np.union1d(tool.radius * np.sin(np.linspace(0, np.pi / 2, _ALONG)), (tool.tip, tool.radius - tool.rounding))
    heights = tool.height(radii)
    radii, heights = np.append(radii, tool.radius), np.append(heights, heights[-1] + _LENGTH * tool.diameter)
    angles = np.linspace(0, 2 * np.pi, _AROUND, endpoint=False)
    rings = np.stack(
        (
            np.multiply.outer(radii, np.cos(angles)),
            np.multiply.outer(radii, np.sin(angles)),
            np.broadcast_to(heights[:, None], (len(radii), _AROUND)),
        ),
        axis=-1,
    ).reshape(-1, 3)
    seen = project(rings + np.asarray(tip, float), frame)[:, :2]
    return np.array(convex_hull(seen.round(6).tolist()))
