# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes of FreeCAD as the solids of a simulation: a job's stock, and the model that it is to become."""

from __future__ import annotations

import time
from collections.abc import Sequence
from math import pi

import MeshPart
import numpy as np
import Part

from vkworkbench import freecad
from vkworkbench.core import Cylinder, Mesh, Solid, Stock
from vkworkbench.document.job.of_shapes import OfShapes
from vkworkbench.document.job.setting import exact_box
from vkworkbench.language import Message, Unusable

# A curved face lies so far from its triangles, mm: at least, and as a share of the shape's diagonal.
_FINEST, _SHARE = 0.01, 1e-4
# rad between neighbouring triangles of a face. `tessellate` takes a tenth of it, and minutes for a spline of 2,000 poles.
_BEND = 0.5
_AT_ONCE, _TURN = 0.01, 0.001  # s of meshing, and s in which other threads, the window's first of all, get their turn
# Shapes are what they seem up to this share of their volume.
_ALIKE = 1e-6
_solids = OfShapes(8)  # of the shapes read last: triangles take their time
_forms = OfShapes(16)
_measures = OfShapes(16)  # every operation of a job asks whether its stock is the model
_FACTOR = 1.0037  # volumes of measures in mm or inches are then not on a border between two roundings


def stock_solid(job, box: Stock) -> tuple[Solid, Message | None]:
    """Return a job's stock as it is, or its box and what prevents that.

    Parameters
    ----------
    job : DocumentObject
    box : Stock
        The box around it, which it has.
    """
    shape = freecad.SHAPE.of(freecad.STOCK.of(job))
    solid, reason = _solids.of(shape, lambda: _solid_or_reason(shape, box))
    return (solid, None) if reason is None else (box, Message("stock-as-box", label=job.Label, sentence=reason))


def form_of_stock(job, box: Stock) -> tuple:
    """Return what the box of a job's stock does not tell, whatever mesh displays it: nothing of a box.

    Parameters
    ----------
    job : DocumentObject
    box : Stock
        The box around its stock, which it has.

    Returns
    -------
    tuple
        A fingerprint's part: a name, volume, area and centre, to five digits.
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
    measures = volumes.sum(), shape.Area, *np.average(centres, axis=0, weights=np.abs(volumes) + _ALIKE)
    return ("Mesh", *(f"{_FACTOR * measure:.4e}" for measure in measures))


def alike(one, other) -> bool:
    """Whether shapes are the same, or as large in the same place, as an undo brings a copy back."""
    return one.isSame(other) or (
        np.allclose(exact_box(one), exact_box(other)) and np.allclose(_measures_of(one), _measures_of(other))
    )


def _measures_of(shape) -> tuple[float, float]:
    return _measures.of(shape, lambda: (shape.Volume, shape.Area))


def stock_is_model(job) -> bool:
    """Whether a job's stock is the model that it is to become: nothing is left to cut."""
    stock, model = freecad.SHAPE.of(freecad.STOCK.of(job)), shapes_of_model(job)
    return len(model) == 1 and alike(stock, model[0])


def shapes_of_model(job) -> list:
    """Return the shapes of a job's model, as the document has them; sketches and wires have no faces and are none of it."""
    group = freecad.GROUP.of(freecad.MODEL.of(job)) or []
    return [shape for shape in map(freecad.SHAPE.of, group) if shape is not None and not shape.isNull() and shape.Faces]


def model_shapes(job) -> tuple:
    """Return copies of the shapes of a job's model, which another thread may read."""
    return tuple(shape.copy(True, False) for shape in shapes_of_model(job))


def model_solid(shapes: tuple) -> Mesh | None:
    """Return shapes as one solid; None where there are none, or where they are not closed."""
    try:
        return _mesh(shapes) if shapes else None
    except Unusable:
        return None


def _solid_or_reason(shape, box: Stock) -> tuple[Solid, None] | tuple[None, Message]:
    try:
        return _solid(shape, box), None
    except Unusable as error:
        return None, error.what


def _solid(shape, box: Stock) -> Solid:
    kind = _kind(shape, box)
    if kind is Stock:
        return box
    size = box.upper - box.lower
    if kind is Cylinder:
        return Cylinder(((box.lower + box.upper) / 2 - [0, 0, size[2] / 2]), float(size[:2].mean()) / 2, float(size[2]))
    return _mesh([shape])


def _kind(shape, box: Stock) -> type:
    """Return as what a shape is simulated."""
    if not shape.Solids:
        raise Unusable(Message("solid-not-closed"))
    size = box.upper - box.lower
    if _alike(shape.Volume, float(size.prod())):
        return Stock
    if _is_cylinder(shape) and _alike(shape.Volume, pi / 4 * float(size.prod())) and _alike(*size[:2]):
        return Cylinder
    return Mesh


def _alike(one: float, other: float) -> bool:
    return abs(one - other) <= _ALIKE * abs(other)


def _is_cylinder(shape) -> bool:
    """Whether all faces are planes but one, which is an upright cylinder."""
    curved = [face.Surface for face in shape.Faces if not isinstance(face.Surface, Part.Plane)]
    return len(curved) == 1 and isinstance(curved[0], Part.Cylinder) and abs(abs(curved[0].Axis.z) - 1) < _ALIKE


def _mesh(shapes: Sequence) -> Mesh:
    triangles = []
    for shape in shapes:
        lower, upper = map(np.array, exact_box(shape))
        deviation = max(_FINEST, _SHARE * float(np.linalg.norm(upper - lower)))
        own = shape.copy(True, False)  # the mesh by which a window displays the shape stays as it is
        begun = time.monotonic()
        for face in own.Faces:  # nothing else happens meanwhile: a face is sooner done than the shape
            MeshPart.meshFromShape(face, LinearDeflection=deviation, AngularDeflection=_BEND)
            if time.monotonic() - begun > _AT_ONCE:
                time.sleep(_TURN)
                begun = time.monotonic()
        points, corners = own.tessellate(deviation)  # the meshes that its faces have now
        triangles.append(np.array([tuple(point) for point in points])[np.array(corners, int).reshape(-1, 3)])
    return Mesh(np.concatenate(triangles))
