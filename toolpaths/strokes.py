# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make toolpaths of open strokes, and contours with dress-ups of CAM programs, as G-code commands.

The functions that make toolpaths have the same form as in synthetic.py. SAMPLES lists (label, strategies that count as
right, function).
"""

from __future__ import annotations

import math

import numpy as np

from toolpaths.synthetic import Program, circle, closed, dense, depths, letters, outline
from toolpaths.words import word


def turned(points: np.ndarray, angle: float) -> np.ndarray:
    """Return points (k, 2) that are rotated about the origin, and rounded as by a post processor."""
    c, s = math.cos(angle), math.sin(angle)
    return np.round(points @ np.array([[c, s], [-s, c]]), 4)


def wall(rng: np.random.Generator, reach: float = 3.0, points: int = 60) -> tuple[np.ndarray, np.ndarray]:
    """Return an open wall (k, 2) with bends to both sides and with offsets up to `reach` mm, and its normals (k, 2)."""
    length = rng.uniform(50, 120)
    x = np.linspace(0, length, points)
    waves = rng.uniform(1.0, 1.8) * 2 * np.pi / length
    height = min(9.0, 0.7 / (waves * waves * reach))
    y, slope = height * np.sin(waves * x), height * waves * np.cos(waves * x)
    normal = np.column_stack([-slope, np.ones(points)]) / np.hypot(slope, 1)[:, None]
    return np.column_stack([x, y]), normal


def open_offsets(rng, *, both_ways=False):
    """Offsets of an open wall at equal steps, each with its own plunge."""
    p, angle = Program(rng), rng.uniform(0, 2 * np.pi)
    step, count = rng.uniform(0.8, 1.8), int(rng.integers(5, 9))
    line, normal = wall(rng, count * step)
    for z in depths(rng, 2):
        for k in range(count):
            path = turned(line + (count - k) * step * normal, angle)
            p.cut(path[::-1] if both_ways and k % 2 else path, z)
    return p.commands


def open_adaptive(rng):
    """Passes whose shape changes gradually from the open side of the stock to a wall, with leads at both ends."""
    p, angle = Program(rng), rng.uniform(0, 2 * np.pi)
    (line, _), deep = wall(rng), rng.uniform(12, 25)
    edge = np.column_stack([line[:, 0], np.full(len(line), line[:, 1].max() + deep)])
    count = math.ceil((edge - line).max() / rng.uniform(1.0, 3.0))
    t = np.linspace(0, np.pi / 2, 8)[::-1]
    for z in depths(rng, 2):
        for k in range(1, count + 1):
            share = np.clip((k - 0.15 * np.sin(line[:, 0] / 9 + k)) / count, 0, 1)[:, None]
            path = (1 - share) * edge + share * line
            r = 2.0
            lead = np.column_stack([-r * np.sin(t), r - r * np.cos(t)])  # a lead-in arc to the start of the pass
            way = np.vstack([path[0] + lead, path[1:-1], (path[-1] + lead * (-1, 1))[::-1]])
            p.cut(turned(way, angle), z)
    return p.commands


def rows_in_steps(rng, *, both_ways=True):
    """Rows, each of which is cut at all its depths before the next row begins."""
    p, angle = Program(rng), rng.uniform(0, 2 * np.pi)
    length, step, levels = rng.uniform(30, 80), rng.uniform(1.0, 3.0), int(rng.integers(2, 5))
    k = 0
    for row in range(int(rng.integers(6, 16))):
        for level in range(levels):
            ends = np.array([(0.0, row * step), (length, row * step)])
            linked = both_ways and (level > 0 or row > 0)
            p.cut(turned(ends[::-1] if both_ways and k % 2 else ends, angle), -1.5 * (level + 1), linked=linked)
            k += 1
    return p.commands


def carved_in_steps(rng, *, levels=None):
    """V-carving in several passes: each pass follows the final carving, down to a maximum depth of the pass."""
    whole, levels = letters(rng, vcarve=True), levels or int(rng.integers(2, 4))
    commands = []
    for level in range(levels):
        lowest = -1.2 * (level + 1) / levels
        for name, words in whole:
            if words.get("Z", 0.0) < 0:
                words = {**words, "Z": max(words["Z"], lowest)}
            commands.append((name, words))
    return commands


def letters_in_steps(rng):
    """Letters that are cut at one depth and again at greater depths."""
    whole = letters(rng)
    return [
        (name, {a: v - level if a == "Z" and v < 0 else v for a, v in words.items()})
        for level in (0.0, 0.4, 0.8)
        for name, words in whole
    ]


def dogbones(rng, *, levels=None):
    """A contour with a relief in each corner, which the tool cuts out and back on one line."""
    p, w, h = Program(rng), rng.uniform(15, 40), rng.uniform(10, 30)
    angle, bone = rng.uniform(0, 2 * np.pi), rng.uniform(0.5, 1.5)
    corners = np.array([(-w, -h), (w, -h), (w, h), (-w, h)])
    if rng.random() < 0.5:  # a tongue in the middle of one side
        corners = np.array(
            [(-w, -h), (w, -h), (w, h), (w / 3, h), (w / 3, h / 2), (-w / 3, h / 2), (-w / 3, h), (-w, h)]
        )
    after, before = np.roll(corners, -1, axis=0) - corners, corners - np.roll(corners, 1, axis=0)
    after, before = (v / np.linalg.norm(v, axis=1)[:, None] for v in (after, before))
    path = [(corners[0] + corners[1]) / 2]
    for k in [*range(1, len(corners)), 0]:
        path.append(corners[k])
        if before[k][0] * after[k][1] > before[k][1] * after[k][0]:
            path += [corners[k] + bone * (before[k] - after[k]) / math.sqrt(2), corners[k]]
    path = turned(np.array([*path, path[0]]), angle)
    for level in range(levels or int(rng.integers(1, 6))):
        p.cut(path, -2.0 * (level + 1))
    return p.commands


def long_pocket(rng, *, linked=False):
    """Nested offset loops in a pocket that is much longer than wide."""
    p, angle = Program(rng), rng.uniform(0, 2 * np.pi)
    half, step = rng.uniform(60, 150), rng.uniform(1.0, 2.5)
    count = int(rng.integers(3, 6))
    rounded = rng.random() < 0.5
    for z in depths(rng, 3):
        for k in range(count):
            w, r = half + k * step, (k + 0.4) * step
            if rounded:
                t = np.linspace(-np.pi / 2, np.pi / 2, 13)
                end = r * np.column_stack([np.cos(t), np.sin(t)]) + (half, 0)
                shape = np.vstack([end, -end])
            else:
                shape = np.array([(-w, -r), (w, -r), (w, r), (-w, r)])
            p.cut(turned(closed(shape), angle), z, linked=linked and k > 0)
    return p.commands


def ramps(rng, *, count=3, level=True):
    """A slot that the tool enters by ramps back and forth along the slot."""
    p, angle = Program(rng), rng.uniform(0, 2 * np.pi)
    length = rng.uniform(10, 60)
    ends = turned(np.array([(0.0, 0.0), (length, 0.0)]), angle)
    deep = rng.uniform(0.5, 2.0)
    path = [(*ends[k % 2], -deep * k) for k in range(count + 1)]
    if level:
        path.append((*ends[(count + 1) % 2], -deep * count))
    p.cut(np.array(path), 0.0)
    return p.commands


def three_ramps(rng):
    """Three slots on one line, each entered by ramps back and forth along the slot."""
    p, angle = Program(rng), rng.uniform(0, 2 * np.pi)
    length, deep = rng.uniform(10, 30), rng.uniform(0.5, 2.0)
    for k in range(3):
        a, b = turned(np.array([(1.4 * k * length, 0.0), ((1.4 * k + 1) * length, 0.0)]), angle)
        p.cut(np.array([(*a, 0.0), (*b, -deep), (*a, -2 * deep), (*b, -2 * deep)]), 0.0)
    return p.commands


def outlined_text(rng, *, levels=1):
    """Letters of an outline font: closed contours of many shapes, some inside others, and open strokes."""
    p, size, angle = Program(rng), rng.uniform(4, 15), rng.uniform(0, 2 * np.pi)
    shapes = []
    for k in range(int(rng.integers(8, 20))):
        a = np.sort(rng.uniform(0, 2 * np.pi, int(rng.integers(5, 12))))
        r = size * rng.uniform(0.25, 0.5, len(a))
        at = (1.2 * k * size, 0.0)
        shapes.append(closed(np.column_stack([r * np.cos(a), r * np.sin(a)])) + at)
        if rng.random() < 0.4:
            shapes.append(circle(*at, size * rng.uniform(0.05, 0.12), points=16)[::-1])
        if rng.random() < 0.3:
            shapes.append(rng.uniform(-size / 2, size / 2, (3, 2)) + at)
    for level in range(levels):
        for shape in shapes:
            p.cut(turned(shape, angle), -0.3 * (level + 1))
    return p.commands


def entered(rng, *, turns=10, loops=3):
    """Nested offset loops entered by a helix of many turns."""
    p, step, r = Program(rng), rng.uniform(2.0, 4.0), rng.uniform(1.5, 3.0)
    a = np.arange(0, turns * 2 * np.pi + 1e-9, np.pi / 18)
    p.cut(np.column_stack([r * np.cos(a), r * np.sin(a), -0.5 * a / (2 * np.pi)]), 0.0)
    half = r + step
    for k in range(loops):
        w = half + k * step
        square = np.array([(w, 0), (w, w), (-w, w), (-w, -w), (w, -w)])
        p.cut(closed(square), -0.5 * turns, linked=True)
    return p.commands


def over_tags(rng, *, down="plunge"):
    """A contour with tags at every depth.

    The tool is lifted over each tag and returns by a plunge, by a ramp, or by a plunge from 2 mm above the depth.
    """
    p = Program(rng)
    way = dense(closed(outline(rng)), 1.0)
    along = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(way, axis=0), axis=1)))
    heading = np.unwrap(np.arctan2(*np.diff(way, axis=0).T[::-1]))
    tag, number = rng.uniform(3, 6), int(rng.integers(2, 7))
    # Keep only tags on nearly straight stretches.
    middles = np.linspace(0, along[-1], number + 2)[1:-1] + rng.uniform(-3, 3, number)
    begin, end = (np.interp(middles + d, along[1:], heading) for d in (-tag, tag))
    middles = middles[np.abs(end - begin) < 0.5]
    ends = np.concatenate([[0.0], np.sort(np.concatenate([middles - tag / 2, middles + tag / 2])), along[-1:]])
    for z in depths(rng):
        for a, b in ends.reshape(-1, 2):
            at = np.concatenate([[a], along[(along > a) & (along < b)], [b]])
            stroke = np.column_stack([np.interp(at, along, way[:, k]) for k in (0, 1)])
            if down == "plunge" or p.last is None:
                p.cut(stroke, z)
            elif down == "ramp":
                p.cut(np.column_stack([stroke, np.maximum(z, z + 1.5 - 0.25 * (at - a))]), z)
            else:
                p.go(*p.last[:2], z + 2)
                p.go(*stroke[0], z + 2)
                p.cut(stroke, z, linked=True)
    return p.commands


SAMPLES = (
    ("open offsets", {"contour-parallel"}, open_offsets),
    ("open offsets both ways", {"contour-parallel", "zigzag"}, lambda r: open_offsets(r, both_ways=True)),
    ("open adaptive", {"adaptive"}, open_adaptive),
    ("rows in steps", {"zigzag"}, rows_in_steps),
    ("rows in steps one way", {"one-way"}, lambda r: rows_in_steps(r, both_ways=False)),
    ("v-carving in steps", {"engraving"}, carved_in_steps),
    ("letters in steps", {"engraving"}, letters_in_steps),
    ("dogbones", {"profile"}, dogbones),
    ("profile lifted over tags", {"profile"}, over_tags),
    ("profile ramped behind tags", {"profile"}, lambda r: over_tags(r, down="ramp")),
    ("profile at feed over tags", {"profile"}, lambda r: over_tags(r, down="above")),
    ("long pocket", {"contour-parallel"}, long_pocket),
    ("long pocket linked", {"contour-parallel"}, lambda r: long_pocket(r, linked=True)),
    ("slot entered by ramps", {"profile"}, ramps),
    ("slot of ramps", {"profile"}, lambda r: ramps(r, count=6, level=False)),
    ("three ramps along a line", {"profile"}, three_ramps),
    ("word", {"engraving", "profile"}, word),
    ("short word", {"engraving", "profile"}, lambda r: word(r, most=7)),
    ("text in outlines", {"engraving"}, outlined_text),
    ("text in outlines at two depths", {"engraving"}, lambda r: outlined_text(r, levels=2)),
    ("offsets entered by a helix", {"contour-parallel"}, entered),
)
