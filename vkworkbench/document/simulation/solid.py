# SPDX-License-Identifier: LGPL-2.1-or-later
"""The simulated part as a mesh of FreeCAD, and as the stock of the next job."""

from __future__ import annotations

import tempfile
from pathlib import Path

import FreeCAD
import Mesh
import numpy as np

from vkworkbench import core
from vkworkbench.core.zbuffer import write_stl
from vkworkbench.document.job.solids import move_between
from vkworkbench.document.job.undo_step import transaction
from vkworkbench.language import Message


def mesh_of(triangles: np.ndarray) -> Mesh.Mesh:
    """Return triangles (t, 3, 3), mm, as a mesh of FreeCAD."""
    if not len(triangles):
        return Mesh.Mesh()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "part.stl"  # FreeCAD makes a mesh many times faster from a file than from a list
        write_stl(path, triangles)
        return Mesh.Mesh(str(path))


def add_mesh(name: str, mesh: Mesh.Mesh) -> FreeCAD.DocumentObject:
    """Add a mesh to the document whose internal name is `name`, in one undo step, and return the new object."""
    document = FreeCAD.getDocument(name)
    with transaction(document, "Add Simulated Part as Mesh"):
        added = document.addObject("Mesh::Feature", "WhatIsLeft")
        added.Mesh = mesh
    return added


def stock_after(triangles: np.ndarray, before: tuple, after: tuple) -> tuple[core.Mesh, Message | None]:
    """Return the part that one job leaves, as the stock of another job, and a remark if the part cannot be moved.

    If both jobs have the same model at different places, as for the two sides of a part, the part is moved like the
    model. `triangles` (t, 3, 3) are the surface of the part that the first job leaves, mm; `before` and `after` are the
    shapes of the first and of the second job's model.
    """
    move = move_between(before, after)
    if move is None:
        return core.Mesh(triangles), Message("stock-not-moved")
    matrix = np.array(move.toMatrix().A).reshape(4, 4)
    return core.Mesh(np.einsum("tki,ji->tkj", triangles, matrix[:3, :3]) + matrix[:3, 3]), None
