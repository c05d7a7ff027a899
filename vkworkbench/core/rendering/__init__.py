# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw images of the simulated part, from the depths of its surface and the trajectories that cut them (owners).

The functions receive a `ZBuffer` simulated along the tool axis, and the `Frame` of a picture from any direction. The
functions return images (height, width, 3) of uint8 with row 0 at the top, the positions of points in an image, and
images as PNG files.
"""

from vkworkbench.core.rendering.camera import direction_of, project, turned
from vkworkbench.core.rendering.field import Field, Section
from vkworkbench.core.rendering.palettes import (
    CUT,
    DEEPEST,
    GOUGED,
    LEFT,
    MET,
    NO_MODEL,
    RAW,
    SCALE,
    colors_of,
    difference_colors,
    distinct_colors,
    palette,
    scale_colors,
)  # fmt: skip
from vkworkbench.core.rendering.path import draw_path
from vkworkbench.core.rendering.png import png
from vkworkbench.core.rendering.scene import CUT_OPEN, LIT, SECTION, Scene, scene
from vkworkbench.core.rendering.shading import BACKGROUND, shade
from vkworkbench.core.rendering.tool_picture import draw_tool

__all__ = [
    "BACKGROUND", "CUT", "CUT_OPEN", "DEEPEST", "GOUGED", "LEFT", "LIT", "MET", "NO_MODEL", "RAW", "SCALE", "SECTION", "Field", "Scene", "Section",
    "colors_of", "difference_colors", "direction_of", "distinct_colors", "draw_path", "draw_tool", "palette", "png", "project", "scale_colors", "scene", "shade", "turned",
]  # fmt: skip
