# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time the parts of FreeCAD's legacy simulator on this computer."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import FreeCAD
import Part
from Path import Command as PathCommand
from PathSimulator import PathSim

from vkworkbench.core import steady_seconds
from vkworkbench.core.simulators import DEFAULTS, Constants

# Maximum number of measurements of each time.
_RUNS = 20


def measure_legacy(clock: Callable[[], float], going_on: Callable[[], object]) -> Constants:
    """Time the meshes and the tool profile of the legacy simulator. One constant dominates each time."""
    flat, rough = PathSim(), _rough()
    flat.BeginSimulation(Part.makeBox(100, 60, 20), 0.12)  # as large as in practice; a small grid fits in the cache
    facets = sum(mesh.CountFacets for mesh in rough.GetResultMesh())
    radius, step = 2.0, 0.1
    tool = Part.makeCylinder(radius, 20)

    pieces = [flat.GetResultMesh, rough.GetResultMesh, lambda: flat.SetToolShape(tool, step)]
    flat_mesh, rough_mesh, shaping = steady_seconds(pieces, most=_RUNS, clock=clock, going_on=going_on).tolist()
    cell = flat_mesh / (834 * 501)
    facet = max(rough_mesh - cell * 51 * 61, 0) / facets
    profile = shaping / (3 * radius / step)
    return replace(DEFAULTS, start=as_slow_here(DEFAULTS.start, cell), cell=cell, facet=facet, profile=profile)


def _rough() -> PathSim:
    """Return a stock of 50 x 60 cells whose heights differ so much that its mesh does not join any cells."""
    sim = PathSim()
    sim.BeginSimulation(Part.makeBox(50, 60, 20), 1.0)
    sim.SetToolShape(Part.makeCylinder(0.55, 20), 1.0)
    place = FreeCAD.Placement(FreeCAD.Vector(0, 0, 20), FreeCAD.Rotation())
    for x in range(0, 50, 2):
        for y in range(0, 60, 2):
            place = sim.ApplyCommand(place, PathCommand("G0", {"X": x + 0.5, "Y": y + 0.5, "Z": 20.0}))
            place = sim.ApplyCommand(place, PathCommand("G1", {"Z": 3.0 + (7 * x + 3 * y) % 13}))
            place = sim.ApplyCommand(place, PathCommand("G0", {"Z": 20.0}))
    return sim


def as_slow_here(seconds: float, cell: float) -> float:
    """Scale a time of the default computer to a computer on which a mesh takes `cell` seconds per cell."""
    return seconds * cell / DEFAULTS.cell
