# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an operation is simulated with: its tool, its stock and its placement, read from the document."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import PureWindowsPath

import numpy as np
import Part

from vkworkbench import freecad
from vkworkbench.core import COORDINATE_LIMIT, Stock, Tool, Toolpath
from vkworkbench.document.job.of_shapes import OfShapes
from vkworkbench.document.job.operations import through_bases
from vkworkbench.language import Message, Unusable

# FreeCAD's names of tool shapes, in small letters only, and the shapes that stand for them in a simulation.
_SHAPES = {
    "endmill": "endmill", "ballend": "ballend", "ballnose": "ballend", "bullnose": "bullnose", "torus": "bullnose",
    "vbit": "vbit", "chamfer": "vbit", "engraver": "vbit", "taperedballnose": "ballend", "drill": "drill",
    "countersink": "vbit", "tap": "drill", "reamer": "endmill", "threadmill": "endmill", "slittingsaw": "endmill",
    "slotcutter": "endmill", "dovetail": "endmill", "radius": "endmill",
}  # fmt: skip
# Those of them that these only stand for, as an end mill does for all others: what is not convex is simulated by its hull, a
# taper above a ball is left out.
_AS_END_MILL, _AS_BALL_END, _AS_DRILL = Message("as-end-mill"), Message("as-ball-end"), Message("as-drill")
_SIMPLIFIED = {
    "taperedballnose": _AS_BALL_END, "tap": _AS_DRILL, "threadmill": _AS_END_MILL, "slittingsaw": _AS_END_MILL,
    "slotcutter": _AS_END_MILL, "dovetail": _AS_END_MILL, "radius": _AS_END_MILL,
}  # fmt: skip

_exact_boxes = OfShapes(16)  # of the stocks read last: one with many curved faces takes 0.1 s


def controller_of(operation):
    """Return the tool controller of an operation, or of what it dresses up; None without one."""
    controller = through_bases(operation, freecad.CONTROLLER)
    return controller if hasattr(controller, "Label") else None


def read_tool(operation) -> Tool:
    """Return the tool of an operation, of whatever FreeCAD version.

    Raises
    ------
    Unusable
        Where there is no tool or its measures are impossible.
    """
    controller = controller_of(operation)
    if controller is None:
        raise Unusable(Message("no-tool"))
    bit = freecad.TOOL.of(controller)
    if bit is None:
        raise Unusable(Message("no-tool-bit", label=controller.Label))
    diameter = freecad.DIAMETER.number(bit)
    if diameter is None:
        raise Unusable(Message("no-diameter", label=controller.Label))
    try:
        return _tool(bit, diameter)
    except Unusable as error:
        raise Unusable(Message("of", label=controller.Label, sentence=error.what)) from None


def tool_remark(operation) -> Message | None:
    """Return what of its tool is not simulated; None where all of it is, and where it has none."""
    controller = controller_of(operation)
    bit = freecad.TOOL.of(controller)
    name = _shape_name(bit) if bit else "endmill"
    instead = _SIMPLIFIED.get(name) if name in _SHAPES else _AS_END_MILL
    return Message("tool-simplified", label=controller.Label, instead=instead) if instead else None


def _shape_name(bit) -> str:
    """Return FreeCAD's name of a tool's shape, in small letters only."""
    name = next((n for n in freecad.TOOL_SHAPE.values(bit) if isinstance(n, str) and n), "endmill")
    file = freecad.TOOL_SHAPE_FILE.of(bit)
    # So 1.1 calls what it does not find where the computer had it that made the document, e.g. in C:\Program Files.
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


def _radians(degrees: float | None) -> float | None:
    return math.radians(degrees) if degrees else None


def read_stock(job) -> Stock:
    """Return the box around a job's stock.

    Raises
    ------
    Unusable
        Where there is no job, no stock, or a stock without volume.
    """
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

    The shape's own `BoundBox` depends on the mesh by which a window displays it, and so does its optimal box before
    FreeCAD 1.0: a copy without the mesh has none.
    """
    return _exact_boxes.of(shape, lambda: _corners(shape.copy(False, False)))


def _corners(shape) -> tuple[tuple, tuple]:
    if not shape.BoundBox.isValid():  # an empty compound
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

    Raises
    ------
    Unusable
        Where the placement is no numbers, or beyond a kilometre.
    """
    if placement is None or placement.isIdentity():
        return toolpath
    matrix = np.array(placement.toMatrix().A).reshape(4, 4)
    if not np.abs(matrix).max() <= COORDINATE_LIMIT:
        raise Unusable(Message("placement-not-finite"))
    return replace(toolpath, points=np.einsum("ni,ji->nj", toolpath.points, matrix[:3, :3]) + matrix[:3, 3])
