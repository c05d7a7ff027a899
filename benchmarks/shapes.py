# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of make_operations.py: plates with pockets of many outlines, and sculptured blocks. Needs FreeCAD.

SHAPES maps a name to a function that returns a solid, mm, whose lower side is at z = 0.
"""

from __future__ import annotations

import math

import Part
from FreeCAD import Vector

HEIGHT = 20.0  # height of every plate, mm


def polar(radius, degrees, center=(0, 0)):
    """Return the point (x, y) at an angle and a radius around a centre."""
    angle = math.radians(degrees)
    return center[0] + radius * math.cos(angle), center[1] + radius * math.sin(angle)


def polygon(*points):
    """Return a flat face with the given corners (x, y)."""
    corners = [Vector(x, y, 0) for x, y in points]
    return Part.Face(Part.makePolygon([*corners, corners[0]]))


def rectangle(x, y, length, width):
    return polygon((x, y), (x + length, y), (x + length, y + width), (x, y + width))


def disk(x, y, radius):
    return Part.Face(Part.Wire(Part.makeCircle(radius, Vector(x, y, 0))))


def smooth(*points):
    """Return a flat face bounded by one closed curve through the given points (x, y)."""
    curve = Part.BSplineCurve()
    curve.interpolate([Vector(x, y, 0) for x, y in points], PeriodicFlag=True)
    return Part.Face(Part.Wire(curve.toShape()))


def turned(face, degrees, center):
    face.rotate(Vector(*center, 0), Vector(0, 0, 1), degrees)
    return face


def cut(plate, *pockets):
    """Return a plate with pockets. Each pocket is a pair of its outline, as a face, and the height of its floor."""
    solid = plate.extrude(Vector(0, 0, HEIGHT))
    for face, floor in pockets:
        face.translate(Vector(0, 0, floor))
        solid = solid.cut(face.extrude(Vector(0, 0, HEIGHT)))
    return solid.removeSplitter().Solids[0]


def tee():
    pocket = polygon((15, 55), (15, 75), (95, 75), (95, 55), (65, 55), (65, 12), (45, 12), (45, 55))
    return cut(rectangle(0, 0, 110, 85), (pocket, 9))


def aitch():
    bar = rectangle(30, 32, 50, 14)
    pocket = bar.fuse(rectangle(14, 10, 22, 58)).fuse(rectangle(74, 10, 22, 58)).removeSplitter().Faces[0]
    return cut(rectangle(0, 0, 110, 78), (pocket, 12))


def cross():
    pocket = rectangle(15, 41, 70, 18).fuse(rectangle(41, 15, 18, 70)).removeSplitter().Faces[0]
    return cut(disk(50, 50, 48), (turned(pocket, 23, (50, 50)), 8))


def keyhole():
    pocket = disk(35, 40, 22).fuse(rectangle(45, 33, 65, 14)).removeSplitter().Faces[0]
    return cut(rectangle(0, 0, 125, 80), (pocket, 11))


def crescent():
    pocket = disk(50, 50, 38).cut(disk(66, 56, 26)).Faces[0]
    return cut(rectangle(0, 0, 100, 100), (pocket, 10))


def hexagon():
    plate = polygon(*(polar(55, 60 * k + 10, (60, 60)) for k in range(6)))
    return cut(plate, (polygon(*(polar(36, 60 * k, (60, 60)) for k in range(6))), 7))


def arrow():
    pocket = polygon((12, 38), (70, 38), (70, 15), (118, 50), (70, 85), (70, 62), (12, 62))
    return cut(polygon((0, 25), (60, 25), (60, 0), (135, 50), (60, 100), (60, 75), (0, 75)), (pocket, 13))


def trapezoid():
    return cut(polygon((0, 0), (120, 0), (95, 70), (25, 70)), (polygon((16, 10), (104, 10), (84, 60), (36, 60)), 6))


def wavy():
    lobes = [polar(34 + 5 * math.cos(math.radians(6 * 9 * k)), 9 * k, (50, 50)) for k in range(40)]
    return cut(rectangle(0, 0, 100, 100), (smooth(*lobes), 10))


def islands():
    pocket = rectangle(10, 10, 110, 70).cut(disk(40, 45, 11)).cut(polygon((70, 30), (98, 34), (80, 62))).Faces[0]
    return cut(rectangle(0, 0, 130, 90), (pocket, 12))


def ring():
    return cut(disk(50, 50, 49), (disk(50, 50, 40).cut(disk(50, 50, 17)).Faces[0], 9))


def neck():
    pocket = disk(32, 40, 22).fuse(rectangle(40, 33, 50, 14)).fuse(rectangle(86, 15, 40, 50))
    return cut(rectangle(0, 0, 140, 80), (pocket.removeSplitter().Faces[0], 10))


def thin():
    return cut(rectangle(0, 0, 160, 34), (rectangle(10, 10, 140, 14), 12))


def oblique():
    pocket = turned(polygon((20, 25), (90, 25), (110, 65), (40, 65)), 33, (65, 45))
    return cut(rectangle(0, -10, 130, 110), (pocket, 11))


def details():
    """Return a large pocket whose walls have small notches and bumps."""
    pocket = rectangle(12, 12, 176, 116)
    for k in range(5):
        pocket = pocket.fuse(disk(30 + 35 * k, 128, 7)).cut(rectangle(25 + 33 * k, 12, 5, 6))
    return cut(rectangle(0, 0, 200, 145), (pocket.removeSplitter().Faces[0], 14))


def depths():
    """Return several pockets of different depths."""
    return cut(
        rectangle(0, 0, 150, 100), (rectangle(10, 10, 40, 30), 5), (disk(80, 30, 19), 8),
        (rectangle(108, 10, 32, 80), 11), (polygon((12, 60), (60, 52), (50, 92)), 14),
        (turned(rectangle(66, 60, 34, 24), 15, (83, 72)), 16),
    )  # fmt: skip


def bolts():
    """Return a flange with a bore and two bolt circles."""
    holes = [(disk(*polar(40, 45 * k + 11, (60, 60)), 3.5), 0) for k in range(8)]
    holes += [(disk(*polar(29, 72 * k, (60, 60)), 2), 6) for k in range(5)]
    return cut(disk(60, 60, 55), (disk(60, 60, 20), 0), *holes)


def ribs():
    """Return a pocket with ribs on its floor, and a step beside the pocket."""
    pocket = rectangle(10, 10, 90, 70)
    for k in range(4):
        pocket = pocket.cut(rectangle(20, 20 + 14 * k, 55, 4))
    return cut(rectangle(0, 0, 140, 90), (pocket.Faces[0], 8), (rectangle(115, -1, 30, 92), 12))


def block(surface):
    """Return the block under a surface, for x from 0 to 70 and y from 0 to 50 mm."""
    return surface.toShape().extrude(Vector(0, 0, -100)).common(Part.makeBox(70, 50, 100)).Solids[0]


def field(height):
    """Return a smooth surface through the heights height(x, y). The surface is slightly larger than the block."""
    grid = [[Vector(x, y, height(x, y)) for y in range(-5, 56, 5)] for x in range(-5, 76, 5)]
    surface = Part.BSplineSurface()
    surface.interpolate(grid)
    return surface


def saddle():
    return block(field(lambda x, y: 18 + (x - 35) ** 2 / 120 - (y - 25) ** 2 / 90))


def ripple():
    return block(field(lambda x, y: 15 + 3 * math.cos(math.hypot(x - 30, y - 20) / 5)))


def ball():
    """Return a hemisphere on a plate."""
    half = Part.makeSphere(17, Vector(35, 25, 10), Vector(0, 0, 1), 0, 90)
    return Part.makeBox(70, 50, 10).fuse(half).removeSplitter()


def twisted():
    """Return the block under a ruled surface between two lines with different slopes."""
    lines = [Part.makeLine(Vector(-5, y, a), Vector(75, y, b)) for y, a, b in ((-5, 24, 10), (55, 9, 26))]
    return block(Part.makeRuledSurface(*lines).Surface)


SHAPES = {
    shape.__name__: shape
    for shape in (tee, aitch, cross, keyhole, crescent, hexagon, arrow, trapezoid, wavy, islands, ring, neck, thin,
                  oblique, details, depths, bolts, ribs, saddle, ripple, ball, twisted)
}  # fmt: skip
