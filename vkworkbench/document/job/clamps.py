# SPDX-License-Identifier: LGPL-2.1-or-later
"""The clamps of a job: objects of the document that no tool, shank or holder may touch."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import Part

from vkworkbench import freecad
from vkworkbench.core import Solid, Stock
from vkworkbench.document.job.setting import exact_box
from vkworkbench.document.job.solids import solid_of
from vkworkbench.document.job.undo_step import transaction
from vkworkbench.language import Message, Unusable

# A hidden link does not make the job depend on its clamps, so FreeCAD recomputes no operation when a clamp is moved.
_TYPE = "App::PropertyLinkListHidden"


def clamps_of(job) -> tuple:
    """Return the objects that are the clamps of a job."""
    return tuple(freecad.CLAMPS.of(job) or ()) if job is not None else ()


def set_clamps(job, clamps: Iterable) -> None:
    """Set the clamps of a job in one undo step. The clamps are saved with the job.

    Parameters
    ----------
    job : DocumentObject
    clamps : iterable of DocumentObject
        Objects with solids, such as clamps and vices. An empty list removes the clamps.

    Raises
    ------
    Unusable
        If an object has no closed solid.
    """
    clamps, name = list(clamps), freecad.CLAMPS.name
    clamp_solids(clamps)  # called before the document is changed, because it raises `Unusable` for unusable clamps
    with transaction(job.Document, "Set Clamps"):
        if not freecad.CLAMPS.is_in(job):
            job.addProperty(
                _TYPE, name, freecad.ADDED_GROUP, "Objects that no tool may touch", freecad.HIDDEN_AND_OUTPUT
            )
        setattr(job, name, clamps)


def readable_clamps(clamps: Iterable) -> tuple[dict[str, Solid], tuple[Message, ...]]:
    """Return the solids of clamps by their labels, and a remark on each clamp without a solid."""
    solids, remarks = {}, []
    for obj in clamps:
        try:
            label, solid = _solid_of(obj)
        except Unusable as error:
            remarks.append(Message("clamp-left-out", sentence=error.what))
        else:
            solids[label] = solid
    return solids, tuple(remarks)


def clamp_solids(clamps: Iterable) -> dict[str, Solid]:
    """Return the solids of clamps, by their labels. Raise `Unusable` if an object has no closed solid."""
    return dict(_solid_of(obj) for obj in clamps)


def _solid_of(obj) -> tuple[str, Solid]:
    shape = _shape_of(obj)
    if shape is None:
        raise Unusable(Message("of", label=obj.Label, sentence=Message("solid-not-closed")))
    try:
        return obj.Label, solid_of(shape, Stock(*map(np.array, exact_box(shape))))
    except Unusable as error:
        raise Unusable(Message("of", label=obj.Label, sentence=error.what)) from None


def shapes_of(clamps: Iterable) -> list:
    """Return the shapes of clamps, placed as in the document; clamps without a shape are skipped."""
    return [shape for shape in map(_shape_of, clamps) if shape is not None]


def has_solid(obj) -> bool:
    """Return whether an object has a solid, so that it can be a clamp."""
    shape = _shape_of(obj)
    return shape is not None and bool(shape.Solids)


def _shape_of(obj):
    """Return the shape of an object, or of all objects in a part, placed in the document; None without a shape."""
    shape = freecad.SHAPE.of(obj) or Part.getShape(obj)
    if not isinstance(shape, Part.Shape) or shape.isNull():
        return None
    above = obj.getGlobalPlacement().multiply(obj.Placement.inverse()) if hasattr(obj, "getGlobalPlacement") else None
    if above is None or above.isIdentity():
        return shape
    moved = shape.copy()
    moved.Placement = above.multiply(moved.Placement)
    return moved
