# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of tools that do not cut, and sequences of moves in which they alternate with the tools."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts


@dataclass(frozen=True)
class Body:
    """A part of a tool that does not cut: an upright cylinder, unbounded upwards.

    Attributes
    ----------
    radius : float
        mm.
    bottom : float
        Height of its lower end above the tool's tip, mm.
    """

    radius: float
    bottom: float


class Moves(Cuts):
    """Straight moves of several solids in one sequence. Consecutive moves may belong to different solids.

    Parameters
    ----------
    solids : sequence of Tool
    solid : (n,) int64
        Solid of each move.
    start, end : (n, 3) float64
        Ends of each move, mm.
    """

    def __init__(self, solids: Sequence[Tool], solid: np.ndarray, start: np.ndarray, end: np.ndarray) -> None:
        nowhere = Toolpath.through(np.empty((0, 3)))
        super().__init__(Cut(nowhere, tool) for tool in solids)
        self.first[-1] = len(solid)
        self.cut, self._start, self._end = solid, start, end

    @property
    def ends(self) -> tuple[np.ndarray, np.ndarray]:
        """See `Cuts.ends`."""
        return self._start, self._end

    def blocks(self, size: int) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
        """See `Cuts.blocks`."""
        for begin in range(0, len(self), size):
            part = slice(begin, begin + size)
            yield self.cut[part], self._start[part], self._end[part]


@dataclass(frozen=True, eq=False)
class Alternation:
    """The moves of tools, and among them the moves of their bodies.

    Attributes
    ----------
    moves : Moves
    trajectory : (n,) int64
        Trajectory of the job that each move is, or is a part of.
    of_body : (n,) bool
        Whether a move is the move of a body.
    """

    moves: Moves
    trajectory: np.ndarray
    of_body: np.ndarray


def alternate(
    cuts: Cuts,
    bodies: Sequence[Body | None],
    carries: np.ndarray,
    *,
    body_first: bool,
    parts: np.ndarray | int = 1,
    lifted: bool = False,
) -> Alternation:
    """Return the moves of a job's tools, with the move of its body beside each move that carries one.

    Parameters
    ----------
    cuts : Cuts
    bodies : sequence of Body or None
        Body of each cut's tool.
    carries : (n,) bool
        Trajectories whose tool carries its body.
    body_first : bool
        Whether the body moves before the tool, or after it.
    parts : (n,) int64 or int
        Number of equal parts into which each trajectory is divided.
    lifted : bool
        Whether a body is lifted, during each part of a move, by the height by which the tool falls in this part.
    """
    parts = np.broadcast_to(parts, len(cuts))
    trajectory = np.repeat(np.arange(len(cuts)), parts)
    part = np.arange(len(trajectory)) - np.repeat(np.cumsum(parts) - parts, parts)
    begin, end = (points[trajectory] for points in cuts.ends)
    step = (end - begin) / parts[trajectory][:, None]
    start = begin + part[:, None] * step
    stop = np.where((part + 1 == parts[trajectory])[:, None], end, start + step)

    tools = [cut.tool for cut in cuts.cuts]
    solids = list(dict.fromkeys(tools + [_cylinder(body) for body in bodies if body]))
    of_tool = np.array([solids.index(tool) for tool in tools])
    of_body = np.array([solids.index(_cylinder(body)) if body else -1 for body in bodies])
    bottom = np.array([body.bottom if body else 0.0 for body in bodies])

    carried = np.flatnonzero(carries[trajectory])
    cut = cuts.cut[trajectory]
    rise = bottom[cut[carried]]
    if lifted:
        rise = rise + np.maximum(start - stop, 0)[carried, 2]
    lift = rise[:, None] * [0.0, 0.0, 1.0]
    number = np.arange(len(trajectory))
    order = np.argsort(np.concatenate((2 * number + body_first, 2 * carried + (not body_first))), kind="stable")
    moves = Moves(
        solids,
        np.concatenate((of_tool[cut], of_body[cut[carried]]))[order],
        np.concatenate((start, start[carried] + lift))[order],
        np.concatenate((stop, stop[carried] + lift))[order],
    )
    return Alternation(
        moves,
        np.concatenate((trajectory, trajectory[carried]))[order],
        (np.arange(len(order)) >= len(trajectory))[order],
    )


def _cylinder(body: Body) -> Tool:
    return Tool("endmill", 2 * body.radius)


def slimmer(tool: Tool, margin: float) -> Tool:
    """Return a tool whose radius is smaller by a margin, mm, or by half if the radius is small. It lies inside the given tool."""
    diameter = max(tool.diameter - 2 * margin, tool.diameter / 2)
    return replace(
        tool,
        diameter=diameter,
        corner_radius=min(tool.corner_radius, diameter / 2),
        tip_diameter=min(tool.tip_diameter, diameter),
    )
