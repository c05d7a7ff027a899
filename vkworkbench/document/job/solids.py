# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert a job's stock and model from FreeCAD's shapes to the solids of a simulation."""

from __future__ import annotations

import time
from collections.abc import Sequence
from math import pi

import MeshPart
import numpy as np
import Part

from vkworkbench import freecad
from vkworkbench.core import Cylinder, Mesh, Solid, Stock
from vkworkbench.document.job.setting import ShapeCache, exact_box
from vkworkbench.language import Message, Unusable

# Allowed distance between a curved face and its triangles: the larger of a length in mm, and a share of the diagonal of
# the shape's bounding box.
_MIN_DEVIATION, _DEVIATION = 0.01, 1e-4
# Largest angle between neighbouring triangles of a face, rad. Without this limit, FreeCAD's `tessellate` uses a tenth
# of the angle and needs minutes for a spline with 2,000 poles.
_BEND = 0.5
# Meshing holds the GIL. After _MESHING seconds the thread sleeps for _PAUSE seconds, so that the window can respond.
_MESHING, _PAUSE = 0.01, 0.001
# Allowed rounding error, as a share: two volumes or lengths that differ by at most this share are equal.
_ROUNDING = 1e-6
_solids = ShapeCache(8)  # a cache, because computing a shape's triangles is slow
_forms = ShapeCache(16)
_measures = ShapeCache(16)  # a cache, because the analysis of every operation compares the stock with the model
# Factor by which volumes and areas are multiplied before rounding. Without the factor, the volume of a stock with usual
# lengths could be halfway between two rounded values.
_FACTOR = 1.0037


def stock_solid(job, box: Stock) -> tuple[Solid, Message | None]:
    """Return a job's stock as a solid; if its shape cannot be used, return its `box` and a remark with the reason."""
    shape = freecad.SHAPE.of(freecad.STOCK.of(job))
    solid, reason = _solids.of(shape, lambda: _solid_or_reason(shape, box))
    return (solid, None) if reason is None else (box, Message("stock-as-box", label=job.Label, sentence=reason))


def form_of_stock(job, box: Stock) -> tuple:
    """Return the form of a job's stock for a fingerprint; empty for a box.

    The form is a name; for a solid that is not a cylinder, also the volume, the area and the centre, with five digits.
    The form does not depend on the mesh that displays the stock. `box` is the box around the stock.
    """
    shape = freecad.SHAPE.of(freecad.STOCK.of(job))
    return _forms.of(shape, lambda: _form(shape, box))


def _form(shape, box: Stock) -> tuple:
    try:
        kind = _kind(shape, box)
    except Unusable as error:
        return (error.what.code,)
    if kind is not Mesh:
        return () if kind is Stock else (kind.__name__,)
    volumes = np.array([solid.Volume for solid in shape.Solids])
    centres = np.array([tuple(solid.CenterOfMass) for solid in shape.Solids]) - box.lower
    measures = volumes.sum(), shape.Area, *np.average(centres, axis=0, weights=np.abs(volumes) + _ROUNDING)
    return ("Mesh", *(f"{_FACTOR * measure:.4e}" for measure in measures))


def measures_of(shape) -> tuple[str, ...]:
    """Return volume and area of a shape with five digits, for a fingerprint."""
    return tuple(f"{_FACTOR * measure:.4e}" for measure in _measures_of(shape))


def are_equal(one, other) -> bool:
    """Return whether two shapes are identical, or equal in box, volume and area, as a copy after an undo is."""
    return one.isSame(other) or (
        np.allclose(exact_box(one), exact_box(other)) and np.allclose(_measures_of(one), _measures_of(other))
    )


def have_equal_shapes(shapes: Sequence, others: Sequence) -> bool:
    """Return whether two sequences of shapes are equal, shape by shape."""
    return len(shapes) == len(others) and all(map(are_equal, shapes, others))


def move_between(before: Sequence, after: Sequence):
    """Return the placement that moves the model `before` onto the model `after`.

    Return None if the models differ, or do not consist of one shape each.
    """
    if len(before) != 1 or len(after) != 1:
        return None
    move = after[0].Placement.multiply(before[0].Placement.inverse())
    moved = before[0].copy()
    moved.Placement = move.multiply(moved.Placement)
    return move if are_equal(moved, after[0]) else None


def _measures_of(shape) -> tuple[float, float]:
    return _measures.of(shape, lambda: (shape.Volume, shape.Area))


def stock_is_model(job) -> bool:
    """Return whether a job's stock equals its model, so that nothing is left to cut."""
    stock, model = freecad.SHAPE.of(freecad.STOCK.of(job)), shapes_of_model(job)
    return len(model) == 1 and are_equal(stock, model[0])


def shapes_of_model(job) -> list:
    """Return the shapes of a job's model. Sketches and wires have no faces and do not belong to the model."""
    group = freecad.GROUP.of(freecad.MODEL.of(job)) or []
    return [shape for shape in map(freecad.SHAPE.of, group) if shape is not None and not shape.isNull() and shape.Faces]


def model_shapes(job) -> tuple:
    """Return copies of the shapes of a job's model, which another thread may read."""
    return tuple(shape.copy(True, False) for shape in shapes_of_model(job))


def model_solid(shapes: tuple) -> Mesh | None:
    """Return the shapes as one solid; None without shapes, or if a shape is not closed."""
    try:
        return _mesh(shapes) if shapes else None
    except Unusable:
        return None


def _solid_or_reason(shape, box: Stock) -> tuple[Solid, None] | tuple[None, Message]:
    try:
        return solid_of(shape, box), None
    except Unusable as error:
        return None, error.what


def solid_of(shape, box: Stock) -> Solid:
    """Return a shape as a box, an upright cylinder, or triangles. Raise `Unusable` if the shape is not closed."""
    kind = _kind(shape, box)
    if kind is Stock:
        return box
    size = box.upper - box.lower
    if kind is Cylinder:
        return Cylinder(((box.lower + box.upper) / 2 - [0, 0, size[2] / 2]), float(size[:2].mean()) / 2, float(size[2]))
    return _mesh([shape])


def _kind(shape, box: Stock) -> type:
    """Return the class of solid that represents a shape."""
    if not shape.Solids:
        raise Unusable(Message("solid-not-closed"))
    size = box.upper - box.lower
    if _equal(shape.Volume, float(size.prod())):
        return Stock
    if _is_cylinder(shape) and _equal(shape.Volume, pi / 4 * float(size.prod())) and _equal(*size[:2]):
        return Cylinder
    return Mesh


def _equal(one: float, other: float) -> bool:
    return abs(one - other) <= _ROUNDING * abs(other)


def _is_cylinder(shape) -> bool:
    """Return whether all faces are planes, except for one upright cylinder."""
    curved = [face.Surface for face in shape.Faces if not isinstance(face.Surface, Part.Plane)]
    return len(curved) == 1 and isinstance(curved[0], Part.Cylinder) and abs(abs(curved[0].Axis.z) - 1) < _ROUNDING


def _mesh(shapes: Sequence) -> Mesh:
    triangles = []
    for shape in shapes:
        lower, upper = map(np.array, exact_box(shape))
        deviation = max(_MIN_DEVIATION, _DEVIATION * float(np.linalg.norm(upper - lower)))
        own = shape.copy(True, False)  # meshing the shape itself would change the mesh that displays it
        begun = time.monotonic()
        for face in own.Faces:  # one face in each call, because a call holds the GIL
            MeshPart.meshFromShape(face, LinearDeflection=deviation, AngularDeflection=_BEND)
            if time.monotonic() - begun > _MESHING:
                time.sleep(_PAUSE)
                begun = time.monotonic()
        points, corners = own.tessellate(deviation)  # this call only collects the meshes that the faces already have
        triangles.append(np.array([tuple(point) for point in points])[np.array(corners, int).reshape(-1, 3)])
    return Mesh(np.concatenate(triangles))
