# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define bodies (the non-cutting parts of tools), and build sequences in which tools and bodies move alternately."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts


@dataclass(frozen=True)
class Body:
    """A non-cutting part of a tool, modelled as an upright cylinder that is unbounded upwards.

    Attributes
    ----------
    radius : float
        Radius of the cylinder, mm.
    bottom : float
        Height of the cylinder's lower end above the tool's tip, mm.
    """

    radius: float
    bottom: float


class Moves(Cuts):
    """Straight moves of several solids in one sequence. Consecutive moves can belong to different solids.

    Parameters
    ----------
    solids : sequence of Tool
    solid : (n,) int64
        Index in `solids` of the solid that makes each move.
    start, end : (n, 3) float64
        Start and end point of each move, mm.
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
    """The moves of tools and of their bodies (non-cutting parts), in one sequence.

    Attributes
    ----------
    moves : Moves
        The sequence of moves.
    trajectory : (n,) int64
        Number of the job's trajectory from which each move was made.
    of_body : (n,) bool
        True if a body makes the move, False if a tool makes it.
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
    """Return the moves of a job's tools; where `carries` is True, the body moves before or after its tool.

    Parameters
    ----------
    cuts : Cuts
        The operations of the job.
    bodies : sequence of Body or None
        Body (non-cutting part) of the tool of each operation; None if the tool has no body.
    carries : (n,) bool
        Whether the body moves along with the tool on each trajectory.
    body_first : bool
        True if the body moves before the tool, False if it moves after the tool.
    parts : (n,) int64 or int
        Number of equal parts into which each trajectory is divided.
    lifted : bool
        Whether the body is raised during each part of a move by the height that the tool descends in this part.
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
    """Return the tool with its radius reduced by a margin, mm, but at most by half."""
    diameter = max(tool.diameter - 2 * margin, tool.diameter / 2)
    return replace(
        tool,
        diameter=diameter,
        corner_radius=min(tool.corner_radius, diameter / 2),
        tip_diameter=min(tool.tip_diameter, diameter),
    )
