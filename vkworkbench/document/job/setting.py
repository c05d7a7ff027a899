# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read the tool, stock, placement and feeds of an operation."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import PureWindowsPath

import numpy as np
import Part

from vkworkbench import freecad
from vkworkbench.core import COORDINATE_LIMIT, Stock, Tool, Toolpath
from vkworkbench.document.job.operations import takes_tool, through_bases
from vkworkbench.given import positive
from vkworkbench.language import Message, Unusable

# FreeCAD's names of tool shapes, in lower case, and the shapes that a simulation uses for them.
_SHAPES = {
    "endmill": "endmill", "ballend": "ballend", "ballnose": "ballend", "bullnose": "bullnose", "torus": "bullnose",
    "vbit": "vbit", "chamfer": "vbit", "engraver": "vbit", "taperedballnose": "ballend", "drill": "drill",
    "countersink": "vbit", "tap": "drill", "reamer": "endmill", "threadmill": "endmill", "slittingsaw": "endmill",
    "slotcutter": "endmill", "dovetail": "endmill", "radius": "endmill",
}  # fmt: skip
# Tool shapes that are simulated by a simpler shape. A shape that is not convex is simulated by its convex hull, and the
# taper above a ball is left out. Shapes that are not in `_SHAPES` are simulated as end mills.
_AS_END_MILL, _AS_BALL_END, _AS_DRILL = Message("as-end-mill"), Message("as-ball-end"), Message("as-drill")
_SIMPLIFIED = {
    "taperedballnose": _AS_BALL_END, "tap": _AS_DRILL, "threadmill": _AS_END_MILL, "slittingsaw": _AS_END_MILL,
    "slotcutter": _AS_END_MILL, "dovetail": _AS_END_MILL, "radius": _AS_END_MILL,
}  # fmt: skip
# Pointed tools whose CuttingEdgeHeight includes the cone; the CuttingEdgeHeight of a V-bit begins above its cone.
_WHOLE_EDGE = ("chamfer", "countersink")


class ShapeCache:
    """A cache of `size` results that were computed for the most recently used shapes.

    The cache also stores the shapes, because a new shape at the memory address of a deleted shape would otherwise get
    the result of the deleted shape.
    """

    def __init__(self, size: int) -> None:
        self._size = size
        self._found: list[tuple] = []

    def of(self, shape, find: Callable):
        """Return the cached result for a shape.

        If the result for the shape is not in the cache, ``find()`` computes it.
        """
        for at, (kept, _) in enumerate(self._found):
            if kept.isSame(shape):
                self._found.append(self._found.pop(at))
                break
        else:
            found = find()
            self._found[: 1 - self._size] = []
            self._found.append((shape, found))
        return self._found[-1][1]


_exact_boxes = ShapeCache(16)  # computing the box of a stock with many curved faces takes 0.1 s


def controller_of(operation):
    """Return the tool controller of an operation or of its dressed-up base; None without a controller."""
    controller = through_bases(operation, freecad.CONTROLLER)
    return controller if hasattr(controller, "Label") else None


def read_tool(operation) -> Tool:
    """Return the tool of an operation. Raise `Unusable` if there is no tool, or if its dimensions are impossible."""
    controller = controller_of(operation)
    if controller is None:
        raise Unusable(Message("no-tool") if takes_tool(operation) else Message("no-tool-possible"))
    bit = freecad.TOOL.of(controller)
    if bit is None:
        raise Unusable(Message("no-tool-bit", label=controller.Label))
    diameter = freecad.DIAMETER.number(bit)
    if diameter is None:
        raise Unusable(Message("no-diameter", label=controller.Label))
    try:
        return _with_bodies(_tool(bit, diameter), bit)
    except Unusable as error:
        raise Unusable(Message("of", label=controller.Label, sentence=error.what)) from None


def tool_remark(operation) -> Message | None:
    """Return a remark if the operation's tool is simulated by a simpler shape, else None."""
    controller = controller_of(operation)
    bit = freecad.TOOL.of(controller)
    name = _shape_name(bit) if bit else "endmill"
    instead = _SIMPLIFIED.get(name) if name in _SHAPES else _AS_END_MILL
    return Message("tool-simplified", label=controller.Label, instead=instead) if instead else None


def _shape_name(bit) -> str:
    """Return FreeCAD's name of a tool's shape, in lower case."""
    name = next((n for n in freecad.TOOL_SHAPE.values(bit) if isinstance(n, str) and n), "endmill")
    file = freecad.TOOL_SHAPE_FILE.of(bit)
    # FreeCAD 1.1 reports the shape "custom" if the file of the shape is not at the path that the document contains.
    if name.lower() == "custom" and isinstance(file, str):
        name = PureWindowsPath(file).stem or name
    return "".join(c for c in name.lower() if c.isalpha())


def _tool(bit, diameter: float) -> Tool:
    shape = _SHAPES.get(_shape_name(bit), "endmill")
    if shape == "bullnose":
        corner = freecad.CORNER_RADIUS.number(bit)
        if not corner:
            flat = freecad.FLAT_RADIUS.number(bit)
            corner = diameter / 2 - flat if flat is not None else 0.0
        return Tool(shape, diameter, corner_radius=corner)
    if shape == "drill":
        return Tool(shape, diameter, tip_angle=_radians(freecad.TIP_ANGLE.number(bit)))
    if shape == "vbit":
        angle, tip = freecad.CUTTING_ANGLE.number(bit), freecad.TIP_DIAMETER.number(bit)
        return Tool(shape, diameter, tip_angle=_radians(angle), tip_diameter=tip or 0.0)
    return Tool(shape, diameter)


def _with_bodies(tool: Tool, bit) -> Tool:
    """Return a tool with the sizes of its flutes, shank and holder. A size that is 0 in FreeCAD is unknown."""
    name = _shape_name(bit)
    edge = freecad.CUTTING_EDGE_HEIGHT.number(bit)
    if name not in _SHAPES or name in _SIMPLIFIED:
        # The edge height of the simulated shape is unknown, because this shape cuts where the real tool has a neck.
        edge = None
    elif edge and tool.shape == "vbit" and name not in _WHOLE_EDGE:
        edge += tool.rim
    sizes = {
        "cutting_edge_height": edge,
        "length": freecad.TOOL_LENGTH.number(bit),
        "shank_diameter": freecad.SHANK_DIAMETER.number(bit),
        "holder_diameter": freecad.HOLDER_DIAMETER.number(bit),
        "holder_length": freecad.HOLDER_LENGTH.number(bit),
    }
    return replace(tool, **{name: size for name, size in sizes.items() if size and positive(size)})


def _radians(degrees: float | None) -> float | None:
    return math.radians(degrees) if degrees else None


def read_stock(job) -> Stock:
    """Return the box around a job's stock. Raise `Unusable` if there is no job, no stock, or a stock without volume."""
    if job is None:
        raise Unusable(Message("no-job"))
    shape = freecad.SHAPE.of(freecad.STOCK.of(job))
    if not isinstance(shape, Part.Shape) or shape.isNull():
        raise Unusable(Message("no-stock", label=job.Label))
    try:
        return Stock(*exact_box(shape))
    except Unusable as error:
        raise Unusable(Message("of", label=job.Label, sentence=error.what)) from None


def exact_box(shape) -> tuple[tuple, tuple]:
    """Return the lower and the upper corner of a shape's exact bounding box, mm.

    The shape's own `BoundBox` depends on the mesh that displays the shape, and before FreeCAD 1.0 the optimal box does,
    too. Therefore the box is computed from a copy of the shape without its mesh.
    """
    return _exact_boxes.of(shape, lambda: _corners(shape.copy(False, False)))


def _corners(shape) -> tuple[tuple, tuple]:
    if not shape.BoundBox.isValid():  # a compound without shapes has no box
        raise Unusable(Message("stock-without-volume"))
    box = shape.optimalBoundingBox(False)
    return (box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax)


def rapid_feeds(operation) -> tuple[float, float]:
    """Return the horizontal and vertical rapid speed of an operation's tool controller, mm/s; 0 if unset."""
    controller = controller_of(operation)
    speeds = (rapid.number(controller) for rapid in (freecad.HORIZONTAL_RAPID, freecad.VERTICAL_RAPID))
    return tuple(speed if speed and 0 < speed < math.inf else 0.0 for speed in speeds)


def vertical_feed(operation) -> float:
    """Return the vertical feed of an operation's tool controller, mm/s; 0 if unset."""
    return freecad.VERTICAL_FEED.number(controller_of(operation)) or 0.0


def placed(toolpath: Toolpath, placement) -> Toolpath:
    """Return the toolpath moved by the operation's placement.

    `Unusable` is raised if the placement is not finite, or farther than a kilometre from the origin along an axis.
    """
    if placement is None or placement.isIdentity():
        return toolpath
    matrix = np.array(placement.toMatrix().A).reshape(4, 4)
    if not np.abs(matrix).max() <= COORDINATE_LIMIT:
        raise Unusable(Message("placement-not-finite"))
    return replace(toolpath, points=np.einsum("ni,ji->nj", toolpath.points, matrix[:3, :3]) + matrix[:3, 3])
