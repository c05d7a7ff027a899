# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert a toolpath to the motions that FreeCAD's simulators compute from the same commands."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from vkworkbench.core.toolpath import Toolpath


@dataclass(frozen=True, eq=False)
class Motions:
    """The motions that FreeCAD's simulators compute from a toolpath; an arc is one motion, a drilling cycle three."""

    move: np.ndarray  # (m, 3) float64: vector from the start to the end of each motion, mm
    # sweep, radius (m,) float64: angle, rad, and radius, mm, of each arc in the XY plane; 0 for straight motions.
    sweep: np.ndarray
    radius: np.ndarray
    command: np.ndarray  # (m,) int64: index of the command from which each motion is computed

    @cached_property
    def level(self) -> np.ndarray:
        """(m,) length of each motion in the XY plane, mm; for an arc, the length of its chord."""
        return np.hypot(self.move[:, 0], self.move[:, 1])


def motions(toolpath: Toolpath) -> Motions:
    """Join the chords of each arc, and replace each drilling cycle by the three motions that both simulators make.

    Arcs in the ZX and YZ planes remain chords. The simulators read these arcs as arcs in the XY plane and draw them
    wrongly. The motions are in the order of the commands, without motions of drilling cycles whose length is 0.
    """
    n = len(toolpath)
    if n == 0:
        return Motions(np.zeros((0, 3)), np.zeros(0), np.zeros(0), np.zeros(0, np.int64))
    points, command = toolpath.points, toolpath.command
    arc = (toolpath.sweep != 0) & (toolpath.plane == 17)
    joined = (command[1:] == command[:-1]) & (arc | toolpath.cycle)[1:]
    first = np.flatnonzero(np.concatenate(([True], ~joined)))
    last = np.append(first[1:], n)

    chords = np.linalg.norm(np.diff(points[:, :2], axis=0), axis=1)
    sweep = np.add.reduceat(np.where(arc, toolpath.sweep, 0.0), first)
    width = np.add.reduceat(np.where(arc, 2 * np.abs(np.sin(toolpath.sweep / 2)), 0.0), first)
    radius = np.divide(np.add.reduceat(chords, first), width, out=np.zeros(len(first)), where=width > 0)

    # In the simulators, a drilling cycle has three motions: to the point above the hole at the retract height, straight
    # down, and straight up. Pecks are not simulated. The motion after the cycle begins at the retract height, even if
    # the cycle returns to another height.
    cycle = toolpath.cycle[first]
    lowest = np.minimum.reduceat(points[1:, 2], first)
    retract = _height_before_first_feed(toolpath, first)
    end = points[last]
    end[:, 2] = np.where(cycle, retract, end[:, 2])
    approach = np.diff(np.vstack((points[:1], end)), axis=0)
    down = np.column_stack((np.zeros((len(first), 2)), lowest - retract))
    move = np.stack((approach, down, -down), axis=1)
    exists = ~np.isclose(move, 0).all(axis=2)
    exists[~cycle, 0] = True  # a full circle is a motion, although the distance between its ends is 0
    exists[:, 1:] &= cycle[:, None]
    arcs = np.zeros((len(first), 3))
    radii = np.zeros((len(first), 3))
    arcs[:, 0], radii[:, 0] = sweep, radius
    return Motions(move[exists], arcs[exists], radii[exists], np.repeat(command[first], 3).reshape(-1, 3)[exists])


def _height_before_first_feed(toolpath: Toolpath, first: np.ndarray) -> np.ndarray:
    """Return the height, mm, at which the first feed move of each group of trajectories begins.

    A group, such as a drilling cycle, begins at the trajectory `first` and ends before the next group.
    """
    n = len(toolpath)
    index = np.where(toolpath.rapid, n, np.arange(n))
    return toolpath.points[np.minimum.reduceat(index, first), 2]
