# SPDX-License-Identifier: LGPL-2.1-or-later
"""The extended z-buffer against a second implementation that shares nothing with it but the tool's profile.

Points along the rays are held against the tool at many positions of every move, in the order of the sequence:
the first trajectory that contains a point owns it. Points within a small distance of a swept surface decide
nothing.
"""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from zbuffer_reference.convex import ConvexStock

from vkworkbench.core import Stock, Tool, Toolpath, View
from vkworkbench.core.zbuffer.dexels import UNCUT
from vkworkbench.core.zbuffer.simulate import simulate

CLEARANCE = 0.03
TOOLS = [
    Tool("endmill", 6),
    Tool("ballend", 6),
    Tool("bullnose", 6, corner_radius=1),
    Tool("bullnose", 6, corner_radius=2.5),
    Tool("vbit", 6, tip_angle=pi / 2),
    Tool("vbit", 4, tip_angle=0.6),
    Tool("drill", 5),
    Tool("vbit", 6, tip_angle=pi / 2, tip_diameter=2),
    Tool("vbit", 5, tip_angle=0.7, tip_diameter=0.4),
    Tool("vbit", 6, tip_angle=2.6, tip_diameter=5.5),
]
DIRECTIONS = [(0, 0, -1), (0, 0, 1), (0, 1, -1), (1, 0.5, -0.3), (-0.4, 1, 0), (0.1, 0.1, -1), (1, -2, 1.5)]
BOX = Stock((0, 0, 0), (20, 16, 8))
ROUND = ConvexStock.cylinder((10, 8, 0), radius=9, height=8, sides=24)


def random_moves(kind, rng, n=6):
    """Points of a path that is horizontal, three-dimensional, vertical here and there, or finely stepped."""
    points = np.column_stack((rng.uniform(2, 18, n + 1), rng.uniform(2, 14, n + 1), rng.uniform(1, 7, n + 1)))
    if kind == "level":
        points[:, 2] = np.repeat(rng.uniform(2, 6, n), 2)[: n + 1]
    if kind == "plunges":
        points[1::2, :2] = points[:-1:2, :2]
    if kind == "helix":
        angle = np.linspace(0, 4, n + 1)
        points = np.column_stack((10 + 4 * np.cos(angle), 8 + 4 * np.sin(angle), np.linspace(7, 3, n + 1)))
    return points


def owners(points, tool, at):
    """Trajectory that removes each point (p, 3) first, `UNCUT` if none does, -1 if too close to tell."""
    owner = np.full(len(at), UNCUT)
    reach = tool.radius + 2 * CLEARANCE
    for i in reversed(range(len(points) - 1)):
        t = np.linspace(0, 1, 700)[:, None, None]
        tip = points[i] + t * (points[i + 1] - points[i])
        ends = points[i : i + 2, :2]
        near = ((at[:, :2] > ends.min(axis=0) - reach) & (at[:, :2] < ends.max(axis=0) + reach)).all(axis=1)
        x, y, z = at[near].T
        r = np.hypot(x - tip[..., 0], y - tip[..., 1])
        z = z - tip[..., 2]
        inside = (z >= tool.height(r + CLEARANCE) + CLEARANCE).any(axis=0)
        outside = (z < tool.height(np.maximum(r - CLEARANCE, 0)) - CLEARANCE).all(axis=0)
        owner[near] = np.where(inside, i, np.where(outside, owner[near], -1))
    return owner


@pytest.mark.long
@pytest.mark.parametrize("tool", TOOLS, ids=str)
@pytest.mark.parametrize("kind", ["level", "free", "plunges", "helix"])
def test_every_point_has_the_same_owner(tool, kind):
    rng = np.random.default_rng([len(kind), TOOLS.index(tool)])
    # Every other direction: each meets each kind of move with half of the tools.
    for direction in DIRECTIONS[(len(kind) + TOOLS.index(tool)) % 2 :: 2]:
        stock = (BOX, ROUND)[rng.integers(2)]
        points = random_moves(kind, rng)
        toolpath = Toolpath.through(points)
        z = simulate(toolpath, tool=tool, stock=stock, view=View(direction, 8, 6))
        at, found = sampled(z)
        expected = owners(points, tool, at)
        told = expected >= 0
        assert told.mean() > 0.5
        assert (found[told] == expected[told]).all()


def sampled(z):
    """Points along all rays of a z-buffer and who owns them there."""
    frame = z.frame
    pixel = np.repeat(np.arange(frame.width * frame.height), np.diff(z.trace_index.astype(int)))
    pixel = np.concatenate((z.dexel_records["pixel"], pixel)).astype(int)
    near, far = (np.concatenate((z.dexel_records[e], z.trace_records[e])) for e in ("near", "far"))
    owner = np.concatenate((np.full(z.dexels, UNCUT), z.trace_records["trajectory"]))
    # Three points in each piece: thin pieces count as much as thick ones.
    share = np.array([0.1, 0.5, 0.9])
    depth = (near[:, None] + (far - near)[:, None] * share).ravel()
    row, column = np.divmod(np.repeat(pixel, 3), frame.width)
    at = frame.origins(*frame.pixel_centres(column, row)) + depth[:, None] * frame.direction
    return at, np.repeat(owner, 3)
