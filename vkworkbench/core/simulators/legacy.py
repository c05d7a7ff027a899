# SPDX-License-Identifier: LGPL-2.1-or-later
"""Predict the cost of FreeCAD's legacy simulator (``PathSimulator.PathSim``).

The simulator stores the stock as a grid of heights and converts the grid to a mesh (`legacy_mesh.py`). The prediction
ignores the time to cut the grid, because cutting takes longer than one tick of the simulator's timer only for long
moves of wide tools. Long moves of wide tools add at most 5 % to the time of a fast-forward.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from vkworkbench.core.simulators.constants import DEFAULTS, Constants
from vkworkbench.core.simulators.heightmap import heightmaps
from vkworkbench.core.simulators.legacy_mesh import BOX, mesh_facets
from vkworkbench.core.simulators.simulator import Task
from vkworkbench.core.stocks import Solid
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath

NAME = "legacy"

# The simulator stores a float for the height of each cell, and a character that is used when the mesh is made.
_BYTES_PER_CELL = 5
# The size of the mesh is estimated at this number of points in time, spread over a play of the simulation.
_LOOKS = 5
# Maximum number of commands per second in play mode, at the initial position of the speed slider.
_SPEED = 50
# Largest number of times that a fast-forward repaints its progress.
_PERCENTS = 100


@dataclass(frozen=True)
class LegacyCost:
    """The cost of one operation, or of several operations in sequence, in the legacy simulator.

    Attributes
    ----------
    fast_forward_seconds, play_seconds : float
        Time from the click on the fast-forward or play button to the finished part, s.
    commands, shown : int
        Number of all commands, and number of the commands that play mode shows. Play mode does not show comments.
    resolution : float
        Edge of a cell, mm.
    cells : int
        Number of cells of the grid.
    facets : float
        Number of triangles of the last mesh.
    constants : Constants
        Times and memory sizes of the simulator's steps, with which the cost was predicted.
    """

    fast_forward_seconds: float
    play_seconds: float
    commands: int
    shown: int
    resolution: float
    cells: int
    facets: float
    constants: Constants

    @property
    def seconds(self) -> float:
        """float : the time of fast-forward, s, which is shown to the user as the time of the legacy simulator."""
        return self.fast_forward_seconds

    @property
    def factor(self) -> float:
        """float : the actual time is between the estimate divided by this factor and the estimate times this factor."""
        return self.constants.legacy_factor

    @property
    def memory_bytes(self) -> float:
        """float : memory of the grid and of the last mesh, bytes."""
        return _BYTES_PER_CELL * self.cells + self.constants.facet_bytes * self.facets


def legacy_cost(task: Task, *, accuracy: float = 0.1, constants: Constants = DEFAULTS) -> LegacyCost:
    """Estimate the cost of one operation in the legacy simulator.

    In fast-forward, every command, including comments, takes one tick of a timer. Whenever the progress increases by
    one percent, the progress bar is repainted. At the end of the fast-forward, one mesh is made and shown. Play mode
    first shows the uncut stock. For each command, play mode needs 20 ms or the time to make and show a mesh, whichever
    is longer. The number of triangles increases with the number of cuts, and decreases if the finished part is flat.

    Parameters
    ----------
    accuracy : float
        Edge of a cell in percent of the stock's longer side, 0.1 to 1; it is 1.1 minus 0.1 times the position of the
        accuracy slider.
    constants : Constants
        Times and memory sizes of the simulator's steps.
    """
    toolpath = task.toolpath
    tool, stock = task.cutting
    side = (stock.upper - stock.lower)[:2]
    resolution = float(0.01 * accuracy * side.max())
    cells = int((np.floor(side / resolution) + 1).prod())
    facets, mean_facets = _triangles(toolpath, tool, stock, resolution)
    comments = len(toolpath.comments)
    shown = toolpath.commands - comments
    # A drilling cycle makes a mesh after each of its three moves.
    meshes = shown + 2 * len(np.unique(toolpath.command[toolpath.cycle]))
    profile = constants.profile * (3 * tool.radius + float(tool.height(tool.radius))) / (0.05 * accuracy)
    shows = constants.redraw * shown + meshes * _mesh_seconds(constants, cells, mean_facets)
    return LegacyCost(
        fast_forward_seconds=_panel_seconds(constants, toolpath.commands)
        + profile
        + _mesh_seconds(constants, cells, facets),
        play_seconds=profile + _uncut_seconds(constants, cells) + max(shows, shown / _SPEED) + comments / _SPEED,
        commands=toolpath.commands,
        shown=shown,
        resolution=resolution,
        cells=cells,
        facets=facets,
        constants=constants,
    )


def _triangles(toolpath: Toolpath, tool: Tool, stock: Solid, resolution: float) -> tuple[float, float]:
    """Return the number of triangles of the last mesh, and the mean number of triangles during a play."""
    maps, size = heightmaps(toolpath, tool=tool, stock=stock, parts=_LOOKS)
    lower = float(stock.lower[2])
    looks = [BOX, *(mesh_facets(heights, size, resolution, lower=lower) for heights in maps)]
    return looks[-1], float(np.add(looks[1:], looks[:-1]).mean() / 2)


def _panel_seconds(constants: Constants, commands: int) -> float:
    """Return the time of a fast-forward without computing the tool's profile and the mesh, s."""
    return constants.start + constants.tick * commands + constants.repaint * min(commands, _PERCENTS)


def _mesh_seconds(constants: Constants, cells: int, facets: float) -> float:
    """Return the time to make one mesh and to show it, s."""
    return constants.cell * cells + (constants.facet + constants.display) * facets


def _uncut_seconds(constants: Constants, cells: int) -> float:
    """Return the time in which play makes and shows the mesh of the uncut stock, s."""
    return constants.cell * cells + constants.redraw


def legacy_together(costs: Sequence[LegacyCost]) -> LegacyCost:
    """Estimate the cost of simulating several operations one after the other in the legacy simulator.

    The simulator starts once, shows the uncut stock once and makes one last mesh. Every mesh of a play includes the
    triangles of the earlier operations.

    Parameters
    ----------
    costs : sequence of LegacyCost
        Costs of at least one operation, in the order of the operations. All costs must be predicted for the same stock
        and accuracy.
    """
    constants, facets = costs[0].constants, sum(cost.facets for cost in costs)
    cells = max(cost.cells for cost in costs)
    commands = sum(cost.commands for cost in costs)
    profiles = sum(
        cost.fast_forward_seconds
        - _panel_seconds(constants, cost.commands)
        - _mesh_seconds(constants, cost.cells, cost.facets)
        for cost in costs
    )
    before = np.cumsum([0.0] + [cost.facets for cost in costs[:-1]])
    drawn_again = sum(cost.shown * facets_before for cost, facets_before in zip(costs, before.tolist()))
    return LegacyCost(
        fast_forward_seconds=_panel_seconds(constants, commands) + profiles + _mesh_seconds(constants, cells, facets),
        play_seconds=sum(cost.play_seconds for cost in costs)
        + (constants.facet + constants.display) * drawn_again
        - (len(costs) - 1) * _uncut_seconds(constants, cells),
        commands=commands,
        shown=sum(cost.shown for cost in costs),
        resolution=max(cost.resolution for cost in costs),
        cells=cells,
        facets=facets,
        constants=constants,
    )
