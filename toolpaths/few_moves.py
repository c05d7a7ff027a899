# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make toolpaths of few moves, whose strategy is hard to recognise, as G-code commands.

The functions have the same form as in synthetic.py, except that a function can also return the tool's diameter, mm,
with the commands. SAMPLES lists (label, strategies that count as right, maker).
"""

from __future__ import annotations

import numpy as np

from toolpaths.outlines import around
from toolpaths.strokes import turned
from toolpaths.synthetic import Program, circle, closed, depths, outline


def walls_of_a_slot(rng):
    """Two opposite walls, closer or farther apart than the tool is wide; one is cut at all depths, then the other."""
    p, angle, tool = Program(rng), rng.uniform(0, 2 * np.pi), rng.uniform(1, 12)
    width, length = tool * np.exp(rng.uniform(-2.3, 1.0)), tool * rng.uniform(3, 20)
    lead, opposite = rng.choice([0.0, rng.uniform(0.1, 0.5)]) * tool, rng.random() < 0.7
    levels = -rng.uniform(0.3, 2.0) * np.arange(1, rng.integers(2, 7))
    for side in (0, 1):
        wall = np.array([(0.0, side * width), (length, side * width)])
        if lead:  # the tool enters from the middle of the slot and leaves towards the middle
            inward = lead if side == 0 else -lead
            wall = np.vstack([wall[0] + (-lead, inward), wall, wall[1] + (lead, inward)])
        for z in levels:
            p.cut(turned(wall[::-1] if side and opposite else wall, angle), z)
    return p.commands, tool


def round_pocket(rng):
    """Round pockets, each cleared by a winding of one to three turns that ends with a full circle."""
    p, tool = Program(rng), rng.uniform(2, 12)
    step, turns = tool * rng.uniform(0.2, 0.8), rng.uniform(1.0, 3.0)
    radius, sense = step * turns, rng.choice([-1, 1])
    a = np.append(np.arange(0, turns * 2 * np.pi, np.pi / 24), turns * 2 * np.pi)
    wall = circle(0.0, 0.0, radius, a[-1], points=48)
    way = np.vstack([around(a, radius * a / a[-1]), wall[1:]])
    if rng.random() < 0.6:  # an arc back towards the centre
        way = np.vstack([way, around(a[-1] + np.linspace(0, np.pi / 2, 7)[1:], radius * np.linspace(1, 0.5, 7)[1:])])
    angle, levels = rng.uniform(0, 2 * np.pi), depths(rng)
    for place in rng.uniform(-150, 150, (int(rng.integers(1, 5)), 2)):
        for z in levels:
            p.cut(turned(way * (1, sense), angle) + place.round(3), z)
    return p.commands, tool


def half_circles(rng):
    """A round pocket cleared by three to five half circles, each wider than the one before, and a full circle."""
    p, tool = Program(rng), rng.uniform(2, 12)
    step, count, angle = tool * rng.uniform(0.2, 0.5), int(rng.integers(3, 6)), rng.uniform(0, 2 * np.pi)
    way, end = [np.zeros((1, 2))], 0.0
    for k in range(count):
        side = 1 if k % 2 == 0 else -1
        reach = side * step * (k + 1)
        t = np.linspace(0, np.pi, 25)[1:]
        centre, radius = (end + reach) / 2, (end - reach) / 2
        way.append(np.column_stack([centre + radius * np.cos(t), radius * np.sin(t)]))
        end = reach
    t = np.linspace(0, 2 * np.pi, 49)[1:] + (np.pi if end < 0 else 0.0)
    way.append(around(t, abs(end)))
    path = turned(np.vstack(way), angle)
    for z in depths(rng):
        p.cut(path, z)
    return p.commands, tool


def short_thread(rng):
    """A thread of one to three turns, cut up or down, with arcs from the centre to the wall and back."""
    p, radius, pitch = Program(rng), rng.uniform(0.5, 15), rng.uniform(0.3, 2.5)
    sense, climb, turns = rng.choice([-1, 1]), rng.choice([-1, 1]), rng.uniform(1.0, 3.0)
    start = rng.uniform(0, 2 * np.pi)
    half = np.linspace(0, np.pi, 13)
    lead = radius / 2 * (1 - np.exp(-1j * half))
    a = np.append(np.arange(0, turns * 2 * np.pi, np.pi / 18), turns * 2 * np.pi)
    level = -pitch * turns if climb > 0 else -1.0
    turn = radius * np.exp(1j * a)
    way, z = turn, level + climb * pitch * a / (2 * np.pi)
    if rng.random() < 0.8:
        way = np.concatenate([lead[:-1], turn, (lead.conj() * np.exp(1j * a[-1]))[::-1][1:]])
        z = np.concatenate([np.full(12, z[0]), z, np.full(12, z[-1])])
    way = way * np.exp(1j * start)
    p.cut(np.column_stack([way.real, sense * way.imag, z]), level)
    return p.commands, float(radius * rng.uniform(0.5, 1.6))


def letters_with_counters(rng):
    """Outlined letters of which many have inner loops, such as A, B and O, at one or two depths."""
    p, size, angle = Program(rng), rng.uniform(3, 20), rng.uniform(0, 2 * np.pi)
    shapes, inner = [], rng.uniform(0.4, 0.9)
    for k in range(int(rng.integers(6, 24))):
        corners = int(rng.integers(4, 12)) if rng.random() < 0.6 else 24
        a = np.sort(rng.uniform(0, 2 * np.pi, corners)) if corners < 12 else np.arange(24) * np.pi / 12
        shape = around(a, size * rng.uniform(0.3, 0.5, corners) if corners < 12 else 0.45 * size)
        shape, at = shape * (rng.uniform(0.5, 0.9), 1.0), (1.1 * k * size, 0.0)
        shapes.append(closed(shape) + at)
        if rng.random() < inner:
            loop = closed(shape[::-1] * rng.uniform(0.4, 0.85))
            shapes += [loop * (1, 0.45) + at + (0, y) for y in (-0.2 * size, 0.2 * size)] if k % 4 == 0 else [loop + at]
    for z in depths(rng, 2):
        for shape in shapes:
            p.cut(turned(shape, angle), 0.3 * z)
    return p.commands


def drawing_with_double_lines(rng):
    """A drawing of several figures, some of which are drawn with two lines close to each other."""
    p, angle = Program(rng), rng.uniform(0, 2 * np.pi)
    shapes = []
    for place in rng.uniform(-60, 60, (int(rng.integers(3, 12)), 2)):
        shape = outline(rng)
        shape = (shape - shape.mean(axis=0)) * rng.uniform(0.03, 0.8)
        shapes.append(closed(shape) + place)
        if rng.random() < 0.4:
            shapes.append(closed(shape * rng.uniform(0.7, 0.96)) + place)
    for corners in rng.integers(2, 8, int(rng.integers(0, 6))).tolist():
        shapes += [rng.uniform(-60, 60, 2) + np.cumsum(rng.normal(0, 6, (corners, 2)), axis=0)]
    for shape in shapes:
        p.cut(turned(shape, angle), -0.3)
    return p.commands


def marks(rng):
    """Short straight strokes: ticks around a circle, ticks along a ruler, or crosses on a grid."""
    p, which, angle = Program(rng), int(rng.integers(3)), rng.uniform(0, 2 * np.pi)
    length, count = rng.uniform(1, 15), int(rng.integers(6, 40))
    if which == 0:
        radius = length * rng.uniform(0.5, 6) + (np.arange(count) % 5 == 0) * length * rng.choice([0.0, -0.3])
        a = 2 * np.pi * np.arange(count) / count
        strokes = np.stack([around(a, radius), around(a, radius + length)], axis=1)
    elif which == 1:
        x = np.arange(count) * length * rng.uniform(0.3, 3)
        height = length * np.where(np.arange(count) % 10 == 0, 2.0, np.where(np.arange(count) % 5 == 0, 1.5, 1.0))
        strokes = np.stack([np.column_stack([x, 0 * x]), np.column_stack([x, height])], axis=1)
    else:
        side, far = int(rng.integers(2, 5)), length * rng.uniform(3, 12)
        places = far * np.stack(np.meshgrid(np.arange(side), np.arange(side)), axis=-1).reshape(-1, 1, 2)
        cross = length / 2 * np.array([[(-1, 0), (1, 0)], [(0, -1), (0, 1)]])
        strokes = (places[:, None] + cross).reshape(-1, 2, 2)
    order = rng.permutation(len(strokes)) if rng.random() < 0.2 else np.arange(len(strokes))
    for k in order:
        p.cut(turned(strokes[k], angle), -0.3)
    return p.commands


def plain_drawing(rng):
    """A drawing of few straight lines: a net of polygons, stairs, or a line with some corners."""
    p, which, size = Program(rng), int(rng.integers(3)), rng.uniform(5, 80)
    angle, shapes = rng.choice([0.0, rng.uniform(0, 2 * np.pi)]), []
    if which == 0:
        sides, at, heading = int(rng.integers(3, 7)), 0j, 0.0
        apothem = 1 / np.tan(np.pi / sides)
        for _ in range(int(rng.integers(2, 12))):  # each polygon shares a side with the one before
            corners = at + np.exp(1j * (heading + np.pi * (2 * np.arange(sides) + 1) / sides)) / np.sin(np.pi / sides)
            shapes.append(closed(size / 4 * np.column_stack([corners.real, corners.imag])))
            heading += 2 * np.pi * int(rng.integers(sides)) / sides
            at += 2 * apothem * np.exp(1j * heading)
            heading += np.pi
    elif which == 1:
        steps = rng.uniform(0.3, 1.0, (int(rng.integers(2, 9)), 2)) * size
        corners = np.cumsum(np.vstack([(0, 0), *[[(x, 0), (0, y)] for x, y in steps]]), axis=0)
        shapes.append(corners)
    else:
        for _ in range(int(rng.integers(1, 4))):
            turns = rng.choice([np.pi / 2, np.pi / 4, 1.0]) * rng.integers(-2, 3, int(rng.integers(2, 10)))
            heading = np.exp(1j * np.cumsum(turns)) * size * rng.uniform(0.1, 1.0, len(turns))
            way = np.cumsum(np.append(0, heading)) + complex(*rng.uniform(0, 2 * size, 2))
            shapes.append(np.column_stack([way.real, way.imag]))
    levels = depths(rng) if rng.random() < 0.3 else (-1.0,)
    for shape in shapes:
        for z in levels:
            p.cut(turned(shape, angle), z)
    return p.commands


SAMPLES = (
    ("two walls of a slot", {"profile"}, walls_of_a_slot),
    ("round pocket of few turns", {"spiral"}, round_pocket),
    ("round pocket of half circles", {"contour-parallel", "spiral"}, half_circles),
    ("thread of few turns", {"helix"}, short_thread),
    ("letters with inner loops", {"engraving"}, letters_with_counters),
    ("drawing with double lines", {"engraving", "profile"}, drawing_with_double_lines),
    ("marks", {"engraving"}, marks),
    ("drawing of few lines", {"engraving", "profile"}, plain_drawing),
)
