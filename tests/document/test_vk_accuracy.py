# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare the z-buffer with FreeCAD: volumes with boolean solids, and heights with PathSimulator in each cell."""

from math import pi

import FreeCAD
import numpy as np
import Part
import pytest
from cases import first_everywhere
from FreeCAD import Vector
from Path import Command
from PathSimulator import PathSim

from vkworkbench.core import Cut, Cylinder, Mesh, Stock, Tool, View, linearize, simulate_job

STEP = 0.002  # distance between two points of PathSimulator's tool profile, mm
UP, HIGH = Vector(0, 0, 1), 40.0
BOX = Part.makeBox(40, 30, 10)
FLAT, BALL, DRILL = Tool("endmill", 6), Tool("ballend", 6), Tool("drill", 5)
BULL, CHAMFER = Tool("bullnose", 8, corner_radius=2), Tool("vbit", 8, tip_angle=pi / 2, tip_diameter=3)


def standing(tool, x, y, z):
    """Return a tool with its tip at (x, y, z) as a solid."""
    flat, corner, r = tool.radius - tool.rounding, tool.rounding, tool.radius
    if corner:
        middle = Vector(flat + corner * 0.5**0.5, 0, corner * (1 - 0.5**0.5))
        edges = [Part.Arc(Vector(flat, 0, 0), middle, Vector(r, 0, corner)).toShape()]
        corners = [(0, 0), (flat, 0)]
    else:
        edges = []
        corners = [(0, 0), (tool.tip if tool.steepness else r, 0), (r, float(tool.height(r)))]
    ends = [Vector(r, 0, float(tool.height(r))), Vector(r, 0, HIGH), Vector(0, 0, HIGH), Vector(0, 0, 0)]
    for outline in ([Vector(a, 0, b) for a, b in corners], ends):
        edges += [Part.makeLine(a, b) for a, b in zip(outline, outline[1:]) if a != b]
    solid = Part.Face(Part.Wire(Part.__sortEdges__(edges))).revolve(Vector(0, 0, 0), UP, 360)
    solid.translate(Vector(x, y, z))
    return solid


def swept(tool, start, end):
    """Return the swept volume of a level move as a solid: the tool at both ends and its extruded outline."""
    start, end = Vector(*start), Vector(*end)
    here, there = standing(tool, *start), standing(tool, *end)
    if start == end:
        return here
    way = end - start
    outline = Part.Face(here.slice(way, way.dot(start)))
    return here.fuse([outline.extrude(way), there])


CASES = {
    "slot": (BOX, FLAT, [(10, 15, 5), (30, 15, 5)]),
    "slanting slot in the plane": (BOX, FLAT, [(8, 8, 4), (31, 22, 4)]),
    "plunge": (BOX, FLAT, [(20, 15, 3)]),
    "corner": (BOX, FLAT, [(8, 8, 6), (30, 8, 6), (30, 22, 6)]),
    "ball slot": (BOX, BALL, [(10, 15, 5), (30, 15, 5)]),
    "ball plunge": (BOX, BALL, [(20, 15, 8)]),
    "bull-nose plunge": (BOX, BULL, [(20, 15, 6)]),
    "drilled hole": (BOX, DRILL, [(20, 15, 2)]),
    "chamfer": (BOX, CHAMFER, [(5, 15, 8), (35, 15, 8)]),
    "through a round stock": (Part.makeCylinder(14, 10, Vector(20, 15, 0)), FLAT, [(0, 15, 6), (40, 15, 6)]),
    "into a cavity": (BOX.cut(Part.makeBox(20, 10, 4, Vector(10, 10, 3))), FLAT, [(15, 15, 5), (25, 15, 5)]),
}


@pytest.mark.parametrize("direction", first_everywhere([((0, 0, -1),), ((1, 1, -1),)]))
@pytest.mark.parametrize("name", CASES)
def test_volumes_equal_boolean_solids(name, direction):
    shape, tool, points = CASES[name]
    stock = Stock((0, 0, 0), (40, 30, 10))
    if name == "through a round stock":
        stock = Cylinder((20, 15, 0), 14, 10)
    elif name == "into a cavity":
        corners, triangles = shape.tessellate(0.1)
        stock = Mesh(np.array([tuple(corner) for corner in corners])[np.array(triangles)])
    commands = [("G0", dict(zip("XYZ", (*points[0][:2], HIGH)))), *(("G1", dict(zip("XYZ", p))) for p in points)]
    z = simulate_job([Cut(linearize(commands), tool)], stock=stock, view=View(direction, 400, 300))
    first, *others = (swept(tool, a, b) for a, b in zip(points, points[1:] or points))
    removed = shape.common(first.fuse(others) if others else first)
    # One ray stands for the whole pixel: where a wall crosses a pixel, the error is up to half a pixel.
    assert abs(z.chip_volume - removed.Volume) < z.frame.pixel / 2 * removed.Area
    assert abs(z.part_volume - (shape.Volume - removed.Volume)) < z.frame.pixel / 2 * (shape.Area + removed.Area)
    assert z.chip_volume == pytest.approx(removed.Volume, rel=0.02)


def heights(simulator, stock, cell):
    """Return the height of every cell of a PathSimulator, (rows, columns), from the level triangles of its meshes."""
    size = np.rint((stock.upper - stock.lower) / cell).astype(int)
    found = np.full((size[1], size[0]), np.nan)
    for mesh in simulator.GetResultMesh():
        for facet in mesh.Facets:
            points = np.array(facet.Points)
            if np.ptp(points[:, 2]) < 1e-6 and points[0, 2] > 1e-6:
                at = np.rint((points - stock.lower) / cell).astype(int)
                (left, bottom, _), (right, top, _) = at.min(axis=0), at.max(axis=0)
                found[bottom:top, left:right] = points[0, 2]
    return found


ROWS = [(x, 4 + 3.0 * k, 6) for k in range(8) for x in ((4, 36) if k % 2 == 0 else (36, 4))]
FLAT_PATHS = {
    "zigzag": ROWS,
    "loops": [(x, y, 7 - k) for k in range(3) for x, y in ((6, 6), (34, 6), (34, 24), (6, 24), (6, 6))],
    "holes": [p for x in (8, 20, 32) for y in (8, 20) for p in ((x, y, 12), (x, y, 3), (x, y, 12))],
}


@pytest.mark.parametrize("name", FLAT_PATHS)
def test_heights_equal_pathsimulator(name):
    """
    The tool is flat, and its moves are level or vertical, so PathSimulator is exact.

    Cells next to walls are not compared, because PathSimulator builds its round tool from square cells.
    """
    stock, cell = Stock((0, 0, 0), (40, 30, 10)), 0.1
    points = [(*FLAT_PATHS[name][0][:2], 12), *FLAT_PATHS[name]]
    simulator = PathSim()
    simulator.BeginSimulation(BOX, cell)
    simulator.SetToolShape(Part.makeCylinder(FLAT.radius, 30), STEP)
    position = FreeCAD.Placement(Vector(*points[0]), FreeCAD.Rotation())
    for point in points[1:]:
        position = simulator.ApplyCommand(position, Command("G1", dict(zip("XYZ", point))))
    theirs = heights(simulator, stock, cell)
    toolpath = linearize([("G1", dict(zip("XYZ", map(float, point)))) for point in points])
    z = simulate_job([Cut(toolpath, FLAT)], stock=stock, view=View((0, 0, -1), 400, 300))
    ours = (5 - z.picture.depth).reshape(300, 400)
    assert theirs.shape == ours.shape
    around = [np.roll(ours, (a, b), (0, 1)) for a in (-2, 0, 2) for b in (-2, 0, 2)]
    level = (np.ptp(around, axis=0) < 1e-6) & ~np.isnan(theirs)
    assert level.mean() > 0.7
    assert np.abs(ours - theirs)[level].max() < STEP + 1e-3
