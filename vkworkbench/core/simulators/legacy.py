# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD's legacy simulator (``PathSimulator.PathSim``) will cost, from exact counts of the work it does.

It holds the stock as a grid of heights, cuts the grid move by move (`legacy_work.py`) and turns it into a mesh
(`legacy_mesh.py`), from its panel (`legacy_panel.py`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from vkworkbench.core.simulators.constants import DEFAULTS, Constants
from vkworkbench.core.simulators.floors import floors
from vkworkbench.core.simulators.heightmap import heightmaps
from vkworkbench.core.simulators.legacy_mesh import BOX, mesh_facets
from vkworkbench.core.simulators.legacy_panel import panel_seconds
from vkworkbench.core.simulators.legacy_work import legacy_work
from vkworkbench.core.simulators.simulator import Conditions, Task
from vkworkbench.core.stocks import Solid
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath

NAME = "legacy"

# A float for the height and a character for the mesh.
_BYTES_PER_CELL = 5
# Motions of a command at most: those of a drilling cycle.
_MOST_MOTIONS = 3
# Moments of a play at which the size of the mesh is estimated.
_LOOKS = 5
# What the positions 1 to 10 of the accuracy slider stand for, percent of the stock's longer side.
SLIDER = tuple(round(1.1 - 0.1 * position, 1) for position in range(1, 11))


@dataclass(frozen=True)
class LegacyCost:
    """What the legacy simulator takes for one operation.

    Attributes
    ----------
    fast_forward_seconds, play_seconds : float
        From pressing the button to the finished part.
    commands, shown : int
        Commands, and those of them that play shows, which are all but comments.
    drawn : float
        Triangles of all meshes that play shows.
    memory_bytes : float
        Grid and mesh at the end.
    accuracy, resolution : float
        Edge of a cell in percent of the stock's longer side, and in mm.
    cells : int
        Cells of the grid.
    facets : float
        Triangles of the mesh at the end.
    moves : int
        Straight moves it cuts one by one, chords of arcs included.
    cut_seconds, mesh_seconds : float
        Time to cut them all, and to make the last mesh.
    constants : Constants
        The unit costs that the prediction used.
    speed : float
        Commands that play shows in a second at most.
    positions : tuple of LegacyCost
        The same at each position of the accuracy slider, 1 to 10; empty where it was not computed.
    """

    fast_forward_seconds: float
    play_seconds: float
    commands: int
    shown: int
    drawn: float
    memory_bytes: float
    accuracy: float
    resolution: float
    cells: int
    facets: float
    moves: int
    cut_seconds: float
    mesh_seconds: float
    constants: Constants
    speed: float
    positions: tuple[LegacyCost, ...] = field(default=(), metadata={"kept": False})  # the cost is that at one of them

    @property
    def seconds(self) -> float:
        """float : the time shown for this simulator, that of fast-forward, s."""
        return self.fast_forward_seconds

    @property
    def factor(self) -> float:
        """float : the true time is between the estimated one divided and multiplied by this."""
        return self.constants.legacy_factor

    @property
    def panel_seconds(self) -> float:
        """float : what fast-forward takes beyond cutting, tool profile and mesh, s."""
        return panel_seconds(self.constants, self.commands)

    @property
    def last_mesh_seconds(self) -> float:
        """float : what fast-forward takes to make the last mesh and to show it, s."""
        return self.mesh_seconds + self.constants.display * self.facets

    @property
    def display_seconds(self) -> float:
        """float : what play takes to show the commands and their meshes, s."""
        return self.constants.redraw * self.shown + self.constants.display * self.drawn


def predict(task: Task, conditions: Conditions) -> LegacyCost:
    """Estimate the simulator at the accuracy of the conditions, and at every position of its accuracy slider."""
    accuracies = conditions.legacy_accuracy, *SLIDER
    cost, *positions = legacy_costs(task, accuracies=accuracies, constants=conditions.constants)
    return replace(cost, positions=tuple(positions))


def legacy_costs(
    task: Task,
    *,
    accuracies: tuple[float, ...] = (0.1,),
    speed: float = 50.0,
    constants: Constants = DEFAULTS,
) -> tuple[LegacyCost, ...]:
    """Estimate the legacy simulator for one operation at several accuracies.

    In fast-forward every command, comments too, takes one tick of a timer, every new percent of the progress a
    repaint, and one mesh is made and shown at the end. Play shows the uncut stock first. Then a command takes 1/`speed`
    s, or the time to make and show a mesh if that is longer. The mesh grows with the cuts, or shrinks if it ends flat.

    Parameters
    ----------
    task : Task
    accuracies : tuple of float
        Edges of a cell in percent of the stock's longer side; the slider has 1.1 - 0.1 times its position,
        and starts at its finest, 0.1.
    speed : float
        Commands per second of the speed slider.
    constants : Constants
        Costs of the unit work.

    Returns
    -------
    tuple of LegacyCost
        One for each accuracy.

    Raises
    ------
    ValueError
        If the stock has no extent or an accuracy or the speed is not positive.
    """
    if not speed > 0:
        raise ValueError(f"the speed must be positive, not {speed} commands per second")
    toolpath, made = task.toolpath, task.motions
    tool, stock = task.cutting
    shown = toolpath.commands - len(toolpath.comments)
    # A drilling cycle makes a mesh after each of its three moves.
    meshes = shown + 2 * len(np.unique(toolpath.command[toolpath.cycle]))
    works = [legacy_work(made, diameter=tool.diameter, stock=stock, accuracy=accuracy) for accuracy in accuracies]
    triangles, growth = _triangles(toolpath, tool, stock, [work.resolution for work in works])
    costs = []
    for accuracy, work, facets in zip(accuracies, works, triangles.tolist()):
        cut = (constants.call * work.calls + constants.ring * work.rings
               + constants.line * work.line_steps + constants.cap * work.cap_steps)  # fmt: skip
        mesh = constants.cell * work.cells + constants.facet * facets
        drawn = meshes * facets * growth
        profile = constants.profile * (3 * tool.radius + float(tool.height(tool.radius))) / (0.05 * accuracy)
        slower = 0.0
        if _MOST_MOTIONS * cut.max(initial=0.0) > constants.tick:
            each = np.bincount(made.command, cut, minlength=toolpath.commands)
            slower = float(np.maximum(each - constants.tick, 0).sum())
        cut_seconds = float(cut.sum())
        shows = (constants.redraw * shown + constants.cell * work.cells * meshes
                 + (constants.facet + constants.display) * drawn + cut_seconds)  # fmt: skip
        costs.append(LegacyCost(
            fast_forward_seconds=panel_seconds(constants, toolpath.commands) + profile + slower + mesh
            + constants.display * facets,
            play_seconds=profile + _uncut_seconds(constants, work.cells) + max(shows, shown / speed)
            + len(toolpath.comments) / speed,
            commands=toolpath.commands,
            shown=shown,
            drawn=drawn,
            memory_bytes=_BYTES_PER_CELL * work.cells + constants.facet_bytes * facets,
            accuracy=accuracy,
            resolution=work.resolution,
            cells=work.cells,
            facets=facets,
            moves=int(work.calls.sum()),
            cut_seconds=cut_seconds,
            mesh_seconds=mesh,
            constants=constants,
            speed=speed,
        ))  # fmt: skip
    return tuple(costs)


def _triangles(toolpath: Toolpath, tool: Tool, stock: Solid, resolutions: list[float]) -> tuple[np.ndarray, float]:
    """Return the triangles of the last mesh at each resolution, and their mean over the play as a share of the last."""
    finest = min(resolutions)
    maps, size = heightmaps(toolpath, tool=tool, stock=stock, parts=_LOOKS)
    kept, floor_size = floors(toolpath, tool=tool, stock=stock, thickness=finest, parts=_LOOKS)
    *before, last = (
        mesh_facets(heights, size, used, floor=floor, floor_size=floor_size)
        for heights, floor, used in zip(maps, kept, [[finest]] * (_LOOKS - 1) + [resolutions])
    )
    looks = np.array([BOX, *np.concatenate(before), last[np.argmin(resolutions)]])
    return last, float((looks[1:] + looks[:-1]).mean() / 2 / looks[-1])


def _uncut_seconds(constants: Constants, cells: int) -> float:
    """What play takes to make the mesh of the uncut stock and to show it."""
    return constants.cell * cells + constants.redraw


def legacy_together(costs: Sequence[LegacyCost]) -> LegacyCost:
    """Estimate the legacy simulator for several operations, run one after another at one accuracy.

    It starts once, shows the uncut stock once and makes one last mesh; every mesh that play makes also has the
    triangles of the operations before.

    Parameters
    ----------
    costs : sequence of LegacyCost
        Of the operations, in their order, at least one; all for one stock and one accuracy.

    Returns
    -------
    LegacyCost
    """
    constants, facets = costs[0].constants, sum(cost.facets for cost in costs)
    cells = max(cost.cells for cost in costs)
    mesh = constants.cell * cells + constants.facet * facets
    each = sum(cost.fast_forward_seconds - cost.panel_seconds - cost.last_mesh_seconds for cost in costs)
    commands = sum(cost.commands for cost in costs)
    before = np.cumsum([0.0] + [cost.facets for cost in costs[:-1]])
    more = [cost.shown * kept for cost, kept in zip(costs, before.tolist())]
    return LegacyCost(
        fast_forward_seconds=panel_seconds(constants, commands) + each + mesh + constants.display * facets,
        play_seconds=sum(cost.play_seconds for cost in costs)
        + (constants.facet + constants.display) * sum(more)
        - (len(costs) - 1) * _uncut_seconds(constants, cells),
        commands=commands,
        shown=sum(cost.shown for cost in costs),
        drawn=sum(cost.drawn for cost in costs) + sum(more),
        memory_bytes=_BYTES_PER_CELL * cells + constants.facet_bytes * facets,
        accuracy=costs[0].accuracy,
        resolution=max(cost.resolution for cost in costs),
        cells=cells,
        facets=facets,
        moves=sum(cost.moves for cost in costs),
        cut_seconds=sum(cost.cut_seconds for cost in costs),
        mesh_seconds=mesh,
        constants=constants,
        speed=costs[0].speed,
    )
