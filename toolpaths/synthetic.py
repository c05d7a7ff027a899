# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make synthetic toolpaths for every strategy, similar to toolpaths of several CAM programs, as G-code commands.

Each function that makes a toolpath has a random generator as its argument, and returns a list of (name, parameters)
pairs in FreeCAD's units. SAMPLES lists (label, strategies that count as right, function).
"""

from __future__ import annotations

import math

import numpy as np

SAFE = 5.0  # height of rapids above the stock, mm
FEED = 10.0  # mm/s


class Program:
    """The commands of a program, with the usual links between consecutive cuts."""

    def __init__(self, rng: np.random.Generator, *, rapids: bool = True) -> None:
        self.rng = rng
        self.rapids = rapids
        self.commands: list[tuple[str, dict[str, float]]] = [("G0", {"Z": SAFE})]
        self.last: tuple[float, float, float] | None = None

    def go(self, x: float, y: float, z: float) -> None:
        """Cut straight to a point."""
        self.commands.append(("G1", {"X": x, "Y": y, "Z": z, "F": FEED}))
        self.last = (x, y, z)

    def enter(self, x: float, y: float, z: float) -> None:
        """Lift the tool, move it above a point, and plunge."""
        name = "G0" if self.rapids else "G1"
        if self.last is not None:
            self.commands.append((name, {"Z": SAFE}))
        self.commands.append((name, {"X": x, "Y": y}))
        self.commands.append(("G1", {"Z": z, "F": FEED / 3}))
        self.last = (x, y, z)

    def cut(self, points, z: float, *, linked: bool = False) -> None:
        """Cut along points (k, 2) or (k, 3). The tool enters by a plunge, or by a link from the previous cut."""
        points = np.asarray(points, float)
        heights = points[:, 2] if points.shape[1] == 3 else np.full(len(points), z)
        first = (points[0, 0], points[0, 1], heights[0])
        if linked and self.last is not None:
            self.go(*first)
        else:
            self.enter(*first)
        rest = zip(*points[1:, :2].T.tolist(), heights[1:].tolist())
        self.commands += [("G1", {"X": x, "Y": y, "Z": height, "F": FEED}) for x, y, height in rest]
        self.last = (*points[-1, :2].tolist(), float(heights[-1]))

    def arc(self, x: float, y: float, i: float, j: float, *, ccw: bool, z: float | None = None) -> None:
        """Cut an arc in XY. The centre (i, j) is relative to the current point."""
        name = "G3" if ccw else "G2"
        z = self.last[2] if z is None else z
        self.commands.append((name, {"X": x, "Y": y, "Z": z, "I": i, "J": j, "F": FEED}))
        self.last = (x, y, z)

    def drill(self, x: float, y: float, z: float, *, pecks: int = 1) -> None:
        """Drill without a canned cycle."""
        self.enter(x, y, z / pecks)
        for peck in range(2, pecks + 1):
            self.commands.append(("G0", {"Z": 1.0}))
            self.commands.append(("G1", {"Z": z * peck / pecks, "F": FEED / 3}))
        self.commands.append(("G0" if self.rapids else "G1", {"Z": SAFE}))


# Outlines of parts


def outline(rng: np.random.Generator) -> np.ndarray:
    """Return a random star-shaped outline (k, 2), counter-clockwise, 30 to 90 mm wide."""
    corners = int(rng.integers(3, 9))
    kind = rng.integers(0, 3)
    radius = rng.uniform(18, 45)
    if kind == 0:  # polygon
        angles = np.sort(np.arange(corners) + rng.uniform(-0.3, 0.3, corners)) * 2 * np.pi / corners
        radii = radius * rng.uniform(0.8, 1.0, corners)
    elif kind == 1:  # smooth outline
        angles = np.arange(120) * 2 * np.pi / 120
        radii = radius * (
            1 + 0.15 * np.cos(2 * angles + rng.uniform(0, 6)) + 0.1 * np.cos(3 * angles + rng.uniform(0, 6))
        )
    else:  # rectangle
        w, h = radius, radius * rng.uniform(0.35, 1.0)
        return np.array([(-w, -h), (w, -h), (w, h), (-w, h)]) + rng.uniform(-50, 50, 2)
    return np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]) + rng.uniform(-50, 50, 2)


def inward(shape: np.ndarray, distance: float) -> np.ndarray | None:
    """Return the mitred inward offset of a counter-clockwise outline; None if the outline is too small for it."""
    before, after = np.roll(shape, 1, axis=0), np.roll(shape, -1, axis=0)
    d0, d1 = shape - before, after - shape
    d0 /= np.linalg.norm(d0, axis=1)[:, None]
    d1 /= np.linalg.norm(d1, axis=1)[:, None]
    n0, n1 = np.column_stack([-d0[:, 1], d0[:, 0]]), np.column_stack([-d1[:, 1], d1[:, 0]])
    bisector = n0 + n1
    bisector /= (bisector * n0).sum(axis=1)[:, None]
    moved = shape + distance * bisector
    edges = np.roll(moved, -1, axis=0) - moved
    if ((edges * d1).sum(axis=1) <= 0).any():
        return None
    return moved


def offsets(shape: np.ndarray, step: float) -> list[np.ndarray]:
    """Return the outline and all its inward offsets."""
    found = [shape]
    while (following := inward(found[-1], step)) is not None and len(found) < 60:
        found.append(following)
    return found


def closed(shape: np.ndarray, start: int = 0) -> np.ndarray:
    """Return the closed outline, which starts and ends at one of its vertices."""
    rolled = np.roll(shape, -start, axis=0)
    return np.vstack([rolled, rolled[:1]])


def scan_lines(shape: np.ndarray, angle: float, step: float) -> list[np.ndarray]:
    """Return the parts of parallel lines inside a shape: for every line an array (parts, 2, 2)."""
    c, s = math.cos(angle), math.sin(angle)
    turned = shape @ np.array([[c, -s], [s, c]])
    a, b = turned, np.roll(turned, -1, axis=0)
    rows = []
    low, high = turned[:, 1].min(), turned[:, 1].max()
    for y in np.arange(low + step / 2, high, step):
        crossing = (a[:, 1] <= y) != (b[:, 1] <= y)
        x = np.sort(a[crossing, 0] + (y - a[crossing, 1]) / (b - a)[crossing, 1] * (b - a)[crossing, 0])
        parts = np.array([[(x0, y), (x1, y)] for x0, x1 in zip(x[::2], x[1::2])]).reshape(-1, 2, 2)
        rows.append(parts @ np.array([[c, s], [-s, c]]))
    return [r for r in rows if len(r)]


def depths(rng: np.random.Generator, most: int = 5) -> list[float]:
    """Return the depths of the cuts."""
    return [-(k + 1) * 2.0 for k in range(int(rng.integers(1, most + 1)))]


# Toolpaths of each strategy


def zigzag(rng, *, lifted=False, rapids=True, angle=None, with_contour=False, rough=0.0):
    """Rows back and forth, linked along the boundary or by lifts."""
    p, shape = Program(rng, rapids=rapids), outline(rng)
    angle = rng.uniform(0, np.pi) if angle is None else angle
    rows = scan_lines(shape, angle, rng.uniform(1.0, 4.0))
    for z in depths(rng):
        if with_contour:
            p.cut(closed(shape), z)
        linked = False
        for k, row in enumerate(rows):
            for part in row[:: 1 if k % 2 == 0 else -1]:
                part = part if k % 2 == 0 else part[::-1]
                p.cut(part + rng.normal(0, rough, (2, 2)), z, linked=linked and not lifted and len(row) == 1)
                linked = True
    return p.commands


def one_way(rng, *, rapids=True):
    """Rows all in one direction with lifted returns."""
    p, shape = Program(rng, rapids=rapids), outline(rng)
    rows = scan_lines(shape, rng.uniform(0, np.pi), rng.uniform(1.0, 4.0))
    for z in depths(rng, 3):
        for row in rows:
            for part in row:
                p.cut(part, z)
    return p.commands


def surface(x, y, seed):
    """Return the height of a smooth sculptured surface, mm."""
    return 3 * np.sin(x / 13 + seed) * np.cos(y / 17 - seed) - 6


def raster(rng, *, both_ways=True, walls=False):
    """Parallel finishing of a 3D surface, with densely sampled rows."""
    p = Program(rng)
    w, h, step, seed = rng.uniform(30, 80), rng.uniform(20, 60), rng.uniform(0.5, 2), rng.uniform(0, 6)
    x = np.linspace(0, w, int(rng.integers(40, 120)))
    angle = rng.uniform(0, np.pi)
    c, s = math.cos(angle), math.sin(angle)
    for k, y in enumerate(np.arange(0, h, step)):
        z = surface(x, y, seed)
        if walls:
            z = np.where(np.abs(x - w / 2) < w / 5, -1.0, -8.0)
        row = np.column_stack([c * x - s * y, s * x + c * y, z])
        p.cut(row[::-1] if both_ways and k % 2 else row, 0, linked=both_ways and k > 0)
    return p.commands


def nested(rng, *, linked="lift", outward=False, ccw=True, rapids=True):
    """Nested offset loops, entered by a plunge, by a step, or by a link that begins before the loop closes (smooth)."""
    p = Program(rng, rapids=rapids)
    step = rng.uniform(1.2, 4.0)
    for _ in range(20):
        rings = offsets(outline(rng), step)
        if len(rings) >= 3:
            break
    if outward:
        rings = rings[::-1]
    start = int(rng.integers(0, len(rings[0])))
    for z in depths(rng, 4):
        for k, ring in enumerate(rings):
            path = closed(ring, start)
            if linked == "smooth":  # begin the loop in the middle of a side
                path = np.vstack([(path[0] + path[1]) / 2, path[1:-1], path[:1], (path[0] + path[1]) / 2])
            path = path if ccw else path[::-1]
            if linked == "smooth":
                # Leave the loop before its end, as with high-speed links.
                path = dense(path, 0.7)
                path = path[: max(4, len(path) - int(1.5 * step / 0.7))]
            p.cut(path, z, linked=linked != "lift" and k > 0)
    return p.commands


def island(rng):
    """Nested offset loops of a boundary and of an island, cut alternately and with opposite senses."""
    p = Program(rng)
    step = rng.uniform(1.5, 3.0)
    outer = offsets(np.array([(-40, -30), (40, -30), (40, 30), (-40, 30)]) * rng.uniform(0.8, 1.3), step)[:5]
    for z in depths(rng, 4):
        for k in range(5):
            p.cut(closed(outer[k]), z)
            p.cut(circle(0, 0, 6 + k * step)[::-1], z)
    return p.commands


def dense(path: np.ndarray, length: float) -> np.ndarray:
    """Return the path resampled at equal steps, mm."""
    out = [path[:1]]
    for a, b in zip(path[:-1], path[1:]):
        n = max(1, int(np.linalg.norm(b - a) / length))
        out.append(a + (b - a) * (np.arange(1, n + 1) / n)[:, None])
    return np.vstack(out)


def circle(x: float, y: float, r: float, start: float = 0.0, points: int = 72) -> np.ndarray:
    """Return a closed counter-clockwise circle (points + 1, 2)."""
    a = start + np.arange(points + 1) * 2 * np.pi / points
    return np.column_stack([x + r * np.cos(a), y + r * np.sin(a)])


def profile(rng, *, lead=False, ramp=False, tabs=False, contours=1, opened=False):
    """Contours that are repeated at several depths, with leads, ramps or tabs."""
    p = Program(rng)
    shapes = [outline(rng) + (k * 120, 0) for k in range(contours)]
    levels = depths(rng, 6)
    for shape in shapes:
        path = closed(shape)
        if opened:
            path = path[: max(3, 2 * len(path) // 3)]
        for z in levels:
            if ramp:
                way = dense(path, 2.0)
                steps = np.linalg.norm(np.diff(way, axis=0), axis=1)
                down = np.minimum(np.concatenate([[0], np.cumsum(steps)]) / 40.0, 1.0)
                n = int(np.searchsorted(down, 1.0)) + 1
                p.cut(np.column_stack([way, z + 2 * (1 - down)]), z, linked=z != levels[0])
                p.cut(way[:n], z, linked=True)
                continue
            if lead:
                direction = (path[1] - path[0]) / np.linalg.norm(path[1] - path[0])
                normal = np.array([direction[1], -direction[0]])
                centre = path[0] + 4 * normal
                first = centre - 4 * direction
                p.enter(*first, z)
                p.arc(*path[0], *(centre - first), ccw=False)
                for point in path[1:]:
                    p.go(*point, z)
                out = centre + 4 * direction
                p.arc(*out, *(centre - path[-1]), ccw=False)
                continue
            if tabs and z == levels[-1]:
                way = dense(path, 1.0)
                lifted = (np.arange(len(way)) // max(8, len(way) // 8)) % 2 == 1
                lifted &= np.arange(len(way)) % max(8, len(way) // 8) < 5
                p.cut(np.column_stack([way, np.where(lifted, z + 1.5, z)]), z)
                continue
            p.cut(path, z)
    return p.commands


def waterline(rng, *, opened=False):
    """Horizontal contours of a hill, whose shape changes with the depth."""
    p = Program(rng)
    a = np.arange(100) * 2 * np.pi / 100
    wobble = 1 + 0.2 * np.cos(2 * a + rng.uniform(0, 6)) + 0.1 * np.cos(3 * a)
    levels = int(rng.integers(6, 20))
    power = rng.uniform(0.5, 1.6)
    for k in range(levels):
        r = 5 + 35 * ((k + 1) / levels) ** power
        shape = np.column_stack([r * wobble * np.cos(a), r * np.sin(a)])
        path = closed(shape) if not opened else shape[5:80]
        p.cut(path, -1.0 * (k + 1))
    return p.commands


def spiral(rng, *, surface_too=False, inwards=False):
    """An Archimedean spiral, flat or on a surface."""
    p = Program(rng)
    step, count = rng.uniform(0.5, 4), int(rng.integers(4, 25))
    a = np.arange(0, count * 2 * np.pi, 0.12)
    r = 0.5 + step * a / (2 * np.pi)
    path = np.column_stack([r * np.cos(a), r * np.sin(a)])
    if surface_too:
        path = np.column_stack([path, surface(path[:, 0], path[:, 1], 1.0)])
    p.cut(path[::-1] if inwards else path, -1.0)
    return p.commands


def clipped(rng, *, both_ways=False, drifting=False):
    """Arcs of circles or of a spiral around a point beside the part, which end at the boundary of the part."""
    p = Program(rng)
    half, step = rng.uniform(20, 40), rng.uniform(1.0, 3.0)
    away = half * rng.uniform(1.2, 2.0)  # from the centre of the circles to the centre of the part
    a = rng.uniform(-0.4, 0.4) + np.linspace(-np.pi, np.pi, 400)
    for k in range(int((away - half) / step) + 1, int((away + half) / step)):
        r = k * step + (a / (2 * np.pi) * step if drifting else 0.0)
        path = np.column_stack([r * np.cos(a) - away, r * np.sin(a)])
        path = path[(np.abs(path) < half).all(axis=1)]
        if len(path) > 3:
            p.cut(path[::-1] if both_ways and k % 2 else path, -1.0)
    return p.commands


def square_spiral(rng):
    """A spiral with straight sides, each of which is one step farther inside than the previous parallel side."""
    p = Program(rng)
    step = rng.uniform(1, 4)
    west, south, east, north = (
        -rng.uniform(25, 45),
        -rng.uniform(20, 30),
        rng.uniform(25, 45),
        rng.uniform(20, 30),
    )
    points = [(west, south)]
    while east - west > 2 * step and north - south > 2 * step:
        points += [(east, south), (east, north), (west, north), (west, south + step)]
        west, south, east, north = west + step, south + step, east - step, north - step
    p.cut(points, -1.0)
    return p.commands


def helix(rng, *, arcs=True, holes=1, thread=False):
    """Descending helices with a constant radius: bores, which end with a horizontal full circle, or threads."""
    p = Program(rng)
    for k in range(holes):
        x, y, r = 40 * k, rng.uniform(-20, 20), rng.uniform(1.5, 12)
        pitch, count = rng.uniform(0.4, 2.0), int(rng.integers(4, 15))
        p.enter(x + r, y, 0.0)
        if arcs:
            for turn in range(count):
                p.arc(x - r, y, -r, 0, ccw=True, z=-pitch * (turn + 0.5))
                p.arc(x + r, y, r, 0, ccw=True, z=-pitch * (turn + 1))
        else:
            a = np.arange(1, 36 * count + 1) * 2 * np.pi / 36
            for angle, z in zip(a, -pitch * a / (2 * np.pi)):
                p.go(x + r * math.cos(angle), y + r * math.sin(angle), z)
        if not thread:
            p.arc(x - r, y, -r, 0, ccw=True)
            p.arc(x + r, y, r, 0, ccw=True)
    return p.commands


def trochoid(rng):
    """A trochoidal slot: loops that advance along a line or an arc."""
    p = Program(rng)
    r, step, length = rng.uniform(2, 6), rng.uniform(0.4, 1.5), rng.uniform(30, 80)
    a = np.arange(0, length / step * 2 * np.pi, 0.2)
    along = step * a / (2 * np.pi)
    bend = rng.uniform(-0.01, 0.01)
    path = np.column_stack([along + r * np.cos(a), bend * along**2 + r * np.sin(a)])
    for z in depths(rng, 2):
        p.cut(path, z)
    return p.commands


def trochoid_of_chords(rng):
    """A slot cut by coarse circles that advance along a line."""
    p, sides = Program(rng), int(rng.integers(12, 40))
    r, step = rng.uniform(4, 13), rng.uniform(0.4, 1.6)
    a = np.arange(int(rng.integers(18, 70)) * sides) * 2 * np.pi / sides
    p.cut(np.column_stack([step * a / (2 * np.pi) + r * np.cos(a), r * np.sin(a)]), -2.0)
    return p.commands


def winding(rng, *, corrects=False):
    """A finely sampled inward winding, with rounded coordinates, or with corrections as in adaptive clearing."""
    p, step, digits = Program(rng), rng.uniform(0.8, 2.5), int(rng.integers(2, 4))
    a = np.arange(0, rng.uniform(7, 12) * 2 * np.pi, rng.uniform(0.003, 0.012))
    waves = rng.integers(15, 110)
    r = rng.uniform(25, 60) - step * a / (2 * np.pi)
    if corrects:
        r += rng.uniform(2.5, 4.5) / waves * np.sin(waves * a)
    p.cut(np.round(np.column_stack([r * np.cos(a), r * np.sin(a)]), digits), -1.0)
    return p.commands


def entered_pocket(rng, *, even=False):
    """A round pocket, which is cleared from its centre outwards after a helical entry, with equal or growing steps.

    With growing steps, the engagement is constant.
    """
    p, side = Program(rng), np.pi / 18
    entry, step, turns = rng.uniform(1.5, 4), rng.uniform(0.5, 2), rng.integers(3, 40)
    a, b = np.arange(0, turns * 2 * np.pi, side), np.arange(0, rng.uniform(7, 15) * 2 * np.pi, side)
    p.cut(np.column_stack([entry * np.cos(a), entry * np.sin(a), -0.5 * a / (2 * np.pi)]), 0.0)
    wound = b / (2 * np.pi)
    if not even:
        wound -= 0.8 * (1 - np.exp(-wound / 2.5))  # the steps grow up to the stepover, as in FreeCAD
    r = entry + step * wound
    p.cut(np.column_stack([r * np.cos(b), r * np.sin(b)]), p.last[2], linked=True)
    return p.commands


def adaptive(rng, *, lift=0.3, rapid_back=True, arcs=False):
    """A helical entry, a spiral out to the walls, and then bites (bent, overlapping strokes) into the corners."""
    p = Program(rng, rapids=rapid_back)
    w, h, step = rng.uniform(35, 60), rng.uniform(14, 26), rng.uniform(0.5, 2.0)
    z, entry = -rng.uniform(3, 8), 2.5
    a = np.arange(0, 8 * np.pi, 0.25)
    p.cut(np.column_stack([entry * np.cos(a), entry * np.sin(a), z * a / a[-1]]), z)
    b = np.arange(0, (h - entry) / step * 2 * np.pi, 0.15)
    r = entry + step * b / (2 * np.pi)
    p.cut(np.column_stack([r * np.cos(b), r * np.sin(b)]), z, linked=True)
    for side in (1, -1):
        reach = h
        while reach < w:
            reach += step
            half = math.acos(max(-1.0, min(1.0, h / math.hypot(h, reach)))) if reach > h else 0.1
            radius = math.hypot(h, reach - h * 0.3)
            half = math.asin(min(1.0, h / radius))
            t = np.linspace(-half, half, 40)
            bite = np.column_stack([(reach - radius) + radius * np.cos(t), radius * np.sin(t)]) * (side, side)
            hook = bite[-1] + 1.2 * np.column_stack([np.cos(t[:15] / half * 1.3) - 1, np.sin(t[:15] / half * 1.3)]) * (
                side,
                side,
            )
            start = bite[0]
            p.commands.append(("G0" if rapid_back else "G1", {"Z": z + lift}))
            p.commands.append(("G0" if rapid_back else "G1", {"X": start[0], "Y": start[1]}))
            p.commands.append(("G1", {"Z": z, "F": FEED}))
            p.last = (start[0], start[1], z)
            if arcs:
                p.arc(*bite[-1], *(np.array([(reach - radius) * side, 0.0]) - start), ccw=True)
            else:
                for point in bite[1:]:
                    p.go(*point, z)
            for point in hook[1:]:
                p.go(*point, z)
    return p.commands


def bites_in_a_row(rng, *, back="sloped", arcs=False, spiral_first=True, bends=False):
    """Bites (bent, overlapping strokes) along a channel. The returns are slightly lifted, horizontal, or rapids.

    Adaptive clearing without lifts consists of arcs from wall to wall, with a small arc at both ends of each arc.
    """
    p = Program(rng)
    half, step, z = rng.uniform(5, 15), rng.uniform(0.3, 1.5), -rng.uniform(2, 8)
    length, lift = rng.uniform(30, 70), 0.2
    if spiral_first:
        a = np.arange(0, 6 * np.pi, 0.25)
        p.cut(np.column_stack([2 * np.cos(a) - half, 2 * np.sin(a), z * a / a[-1]]), z)
        b = np.arange(0, (half - 2) / step * 2 * np.pi, 0.2)
        r = 2 + step * b / (2 * np.pi)
        p.cut(np.column_stack([r * np.cos(b) - half, r * np.sin(b)]), z, linked=True)
    for x in np.arange(0, length, step):
        t = np.linspace(-1.1, 1.1, 24)
        bulge = half / np.sin(1.1)
        bite = np.column_stack([bulge * (np.cos(t) - np.cos(1.1)), bulge * np.sin(t)])
        t = np.linspace(0, 2.2, 10)
        out = bite[-1] + 0.8 * np.column_stack(
            [np.cos(1.1 + np.pi / 2 + t - np.pi / 2) - np.cos(1.1), np.sin(1.1 + t) - np.sin(1.1)]
        )
        way = np.vstack([bite, out[1:]])
        turn = 0.5 * x / length if bends else 0.0
        c, s = math.cos(turn), math.sin(turn)
        way = way @ np.array([[c, s], [-s, c]]) + (x, 5 * np.sin(x / 20) if bends else 0.0)
        if back == "rapid":
            p.commands += [
                ("G0", {"Z": z + lift}),
                ("G0", {"X": way[0, 0], "Y": way[0, 1]}),
                ("G1", {"Z": z}),
            ]
            p.last = (way[0, 0], way[0, 1], z)
        elif p.last is not None and back == "sloped":
            x0, y0, _ = p.last
            p.go(x0 + (way[0, 0] - x0) * 0.1, y0 + (way[0, 1] - y0) * 0.1, z + lift)
            p.go(x0 + (way[0, 0] - x0) * 0.9, y0 + (way[0, 1] - y0) * 0.9, z + lift)
            p.go(way[0, 0], way[0, 1], z)
        elif p.last is not None:
            p.go(way[0, 0], way[0, 1], z)
        else:
            p.enter(way[0, 0], way[0, 1], z)
        if arcs:
            mid = len(bite) - 1
            chord, bow = way[mid] - way[0], way[mid // 2] - (way[0] + way[mid]) / 2
            h = np.linalg.norm(bow)
            radius = (h * h + (np.linalg.norm(chord) / 2) ** 2) / (2 * h)
            centre = way[mid // 2] - bow / h * radius
            p.arc(*way[mid], *(centre - way[0]), ccw=True)
            way = way[mid:]
        for q in way[1:]:
            p.go(*q, z)
    return p.commands


def trochoid_of_arcs(rng):
    """A slot that is cut by half circles, with straight returns between them."""
    p = Program(rng)
    r, step, length, turn = (
        rng.uniform(2, 8),
        rng.uniform(0.3, 1.5),
        rng.uniform(25, 80),
        rng.uniform(0, np.pi),
    )
    along, across = np.array([math.cos(turn), math.sin(turn)]), np.array([-math.sin(turn), math.cos(turn)])
    for z in depths(rng, 3):
        first = -r * across
        p.enter(*first, z)
        for x in np.arange(0, length, step):
            start, end = x * along - r * across, x * along + r * across
            p.go(*start, z)
            p.arc(*end, *(r * across), ccw=True)
    return p.commands


def isolation(rng):
    """Isolation milling of a circuit board: only many small contours at one depth."""
    p = Program(rng)
    for _ in range(int(rng.integers(15, 60))):
        x, y = rng.uniform(0, 60, 2)
        r, w = rng.uniform(0.6, 1.5), rng.uniform(0, 12)
        a = np.concatenate([np.linspace(-np.pi / 2, np.pi / 2, 9), np.linspace(np.pi / 2, 3 * np.pi / 2, 9)])
        pad = np.column_stack([x + r * np.cos(a) + np.where(np.arange(18) < 9, w, 0), y + r * np.sin(a)])
        p.cut(closed(pad), -0.1)
    return p.commands


def board(rng):
    """A circuit board in one program: contours at one depth, then holes, then the board's outline at several depths."""
    holes = drilling(rng, pecks=1)
    while sum(name == "G1" for name, _ in holes) < 6:
        holes = drilling(rng, pecks=1)
    return isolation(rng) + holes[1:] + profile(rng)[1:]


def drilling(rng, *, cycle=None, pecks=1, rapids=True):
    """Holes that are drilled by canned cycles or by plunges."""
    p = Program(rng, rapids=rapids)
    points = rng.uniform(0, 80, (int(rng.integers(2, 30)), 2))
    z = -rng.uniform(1, 12)
    for k, (x, y) in enumerate(points):
        if cycle:
            words = {"X": x, "Y": y, "Z": z, "R": 1.0, "F": FEED, "Q": 1.0}
            p.commands.append((cycle, words if k == 0 else {"X": x, "Y": y}))
        else:
            p.drill(x, y, z, pecks=pecks)
    return p.commands


def letters(rng, *, vcarve=False):
    """Strokes of made-up letters along a line of text."""
    p = Program(rng)
    size = rng.uniform(4, 15)
    for k in range(int(rng.integers(8, 30))):
        for _ in range(int(rng.integers(1, 4))):
            corner = rng.uniform(0, size, (int(rng.integers(2, 5)), 2)) + (k * 1.3 * size, 0)
            if rng.random() < 0.4:
                a = np.linspace(0, rng.uniform(1, 5), 25) * rng.choice([-1, 1])
                corner = corner[0] + size / 3 * np.column_stack([np.cos(a), np.sin(a)])
            z = np.full(len(corner), -0.5)
            if vcarve:
                corner = dense(corner, 0.8)
                z = -0.2 - np.abs(np.sin(np.arange(len(corner)) / 4))
            p.cut(np.column_stack([corner, z]), -0.5)
    return p.commands


def comb(rng):
    """A profile around a comb. The profile goes back and forth in equal steps like a zigzag, but it is closed."""
    p, tool = Program(rng), rng.uniform(0.5, 2)
    tooth, gap, height = rng.uniform(2, 8), 2.5 * tool + rng.uniform(0.5, 6), rng.uniform(12, 40)
    left = np.arange(rng.integers(4, 16)) * (tooth + gap)
    sides = np.column_stack([left - tool, left + tooth + tool]).ravel()
    teeth = np.column_stack([np.repeat(sides, 2), np.resize([0.0, height, height, 0.0], 2 * len(sides))])
    shape = np.vstack([[sides[0], -10.0], teeth, [sides[-1], -10.0]])
    for z in depths(rng, 3):
        p.cut(closed(shape), z)
    return p.commands


def star(rng, *, drawn=False):
    """The outline of a star, or a star that is drawn from corner to corner in a single stroke and crosses itself."""
    p, corners, radius = Program(rng), int(rng.integers(5, 17)), rng.uniform(10, 40)
    if drawn:
        strides = [k for k in range(2, (corners + 1) // 2) if math.gcd(k, corners) == 1]
        corners, strides = (corners, strides) if strides else (5, [2])
        angle = np.arange(corners) * 2 * np.pi * int(rng.choice(strides)) / corners
        radii = np.full(corners, radius)
    else:
        angle = np.arange(2 * corners) * np.pi / corners
        radii = radius * np.resize([1.0, rng.uniform(0.35, 0.8)], 2 * corners)
    angle = angle + rng.uniform(0, 2 * np.pi)
    for z in depths(rng, 3):
        p.cut(closed(radii[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])), z)
    return p.commands


def plain_letters(rng):
    """Letters of straight strokes, all upright."""
    p, size = Program(rng), rng.uniform(4, 15)
    lean, letters, height = rng.uniform(0, 0.1), int(rng.integers(6, 24)), rng.uniform(0.2, 0.6, 24) * size
    for z in depths(rng, 2):
        for k, y in enumerate(height[:letters]):
            x = 1.3 * size * k
            p.cut([(x, 0), (x + lean * k, size), (x + 0.6 * size - lean * k / 3, y)], z)
            p.cut([(x + 0.1 * size, y / 2), (x + 0.6 * size - lean * k / 2, y / 2)], z)
    return p.commands


def pocket_then_profile(rng):
    """A facing zigzag, then a contour around it, in one program."""
    return zigzag(rng) + [("(contour)", {})] + profile(rng)


def program(rng):
    """Three operations with three tools: a zigzag, holes and contours."""
    change = [("M6", {"T": 2.0})]
    return zigzag(rng) + change + drilling(rng, cycle="G83") + change + profile(rng, contours=2)


SAMPLES = (
    ("zigzag linked", {"zigzag"}, zigzag),
    ("zigzag lifted", {"zigzag"}, lambda r: zigzag(r, lifted=True)),
    ("zigzag without rapids", {"zigzag"}, lambda r: zigzag(r, lifted=True, rapids=False)),
    ("zigzag rounded", {"zigzag"}, lambda r: zigzag(r, rough=0.002)),
    ("zigzag and contour", {"mixed", "zigzag"}, lambda r: zigzag(r, with_contour=True)),
    ("one-way", {"one-way"}, one_way),
    ("one-way without rapids", {"one-way"}, lambda r: one_way(r, rapids=False)),
    ("raster both ways", {"zigzag"}, raster),
    ("raster over walls", {"zigzag"}, lambda r: raster(r, walls=True)),
    ("raster one way", {"one-way"}, lambda r: raster(r, both_ways=False)),
    ("raster one way over walls", {"one-way"}, lambda r: raster(r, both_ways=False, walls=True)),
    ("offsets lifted", {"contour-parallel"}, nested),
    ("offsets without rapids", {"contour-parallel"}, lambda r: nested(r, rapids=False)),
    ("offsets linked", {"contour-parallel"}, lambda r: nested(r, linked="step")),
    (
        "offsets linked outward cw",
        {"contour-parallel"},
        lambda r: nested(r, linked="step", outward=True, ccw=False),
    ),
    ("offsets linked smoothly", {"contour-parallel"}, lambda r: nested(r, linked="smooth")),
    ("offsets around an island", {"contour-parallel"}, island),
    ("profile", {"profile"}, profile),
    ("profile with leads", {"profile"}, lambda r: profile(r, lead=True)),
    ("profile with ramps", {"profile"}, lambda r: profile(r, ramp=True)),
    ("profile with tabs", {"profile"}, lambda r: profile(r, tabs=True)),
    ("profiles", {"profile"}, lambda r: profile(r, contours=4)),
    ("profile open", {"profile"}, lambda r: profile(r, opened=True)),
    ("profile of a comb", {"profile"}, comb),
    ("profile of a star", {"profile"}, star),
    ("star drawn in one stroke", {"profile"}, lambda r: star(r, drawn=True)),
    ("waterline", {"waterline"}, waterline),
    ("waterline open", {"waterline"}, lambda r: waterline(r, opened=True)),
    ("spiral", {"spiral"}, spiral),
    ("spiral finely sampled", {"spiral"}, winding),
    ("spiral inwards", {"spiral"}, lambda r: spiral(r, inwards=True)),
    ("spiral on a surface", {"spiral"}, lambda r: spiral(r, surface_too=True)),
    ("circles clipped", {"contour-parallel"}, clipped),
    ("circles clipped both ways", {"zigzag"}, lambda r: clipped(r, both_ways=True)),
    ("spiral clipped", {"spiral"}, lambda r: clipped(r, drifting=True)),
    ("spiral with corners", {"spiral", "contour-parallel"}, square_spiral),
    ("helix", {"helix"}, helix),
    ("helix in chords", {"helix"}, lambda r: helix(r, arcs=False)),
    ("helices", {"helix"}, lambda r: helix(r, holes=5)),
    ("thread", {"helix"}, lambda r: helix(r, thread=True)),
    ("trochoid", {"adaptive"}, trochoid),
    ("trochoid of chords", {"adaptive"}, trochoid_of_chords),
    ("winding that corrects itself", {"adaptive"}, lambda r: winding(r, corrects=True)),
    ("pocket entered by a helix", {"adaptive", "spiral"}, entered_pocket),  # "spiral" is right if no tool is known
    ("spiral entered by a helix", {"spiral"}, lambda rng: entered_pocket(rng, even=True)),
    ("adaptive", {"adaptive"}, adaptive),
    ("adaptive without rapids", {"adaptive"}, lambda r: adaptive(r, rapid_back=False)),
    ("adaptive not lifted", {"adaptive"}, lambda r: adaptive(r, lift=0.0, rapid_back=False)),
    ("adaptive in arcs", {"adaptive"}, lambda r: adaptive(r, arcs=True)),
    ("bites, sloped way back", {"adaptive"}, bites_in_a_row),
    ("bites, level way back", {"adaptive"}, lambda r: bites_in_a_row(r, back="level")),
    ("bites, rapid way back", {"adaptive"}, lambda r: bites_in_a_row(r, back="rapid", spiral_first=False)),
    ("bites of arcs, bending", {"adaptive"}, lambda r: bites_in_a_row(r, arcs=True, bends=True)),
    ("bites only", {"adaptive"}, lambda r: bites_in_a_row(r, spiral_first=False, bends=True)),
    ("trochoid of arcs", {"adaptive"}, trochoid_of_arcs),
    ("drilling", {"drilling"}, drilling),
    ("drilling in pecks", {"drilling"}, lambda r: drilling(r, pecks=4)),
    ("drilling cycles", {"drilling"}, lambda r: drilling(r, cycle="G81")),
    ("drilling without rapids", {"drilling"}, lambda r: drilling(r, rapids=False)),
    ("letters", {"engraving"}, letters),
    ("letters of straight strokes", {"engraving"}, plain_letters),
    ("v-carving", {"engraving"}, lambda r: letters(r, vcarve=True)),
    ("isolation", {"profile", "engraving"}, isolation),
    ("circuit board", {"mixed"}, board),
    ("zigzag, then profile", {"mixed"}, pocket_then_profile),
    ("program of three tools", {"mixed"}, program),
)
