# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define the interface of a simulator: the class of its entry in table.py, and the arguments of its functions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Protocol

from vkworkbench.core.gcode import Words
from vkworkbench.core.recognition import Recognition
from vkworkbench.core.simulators.constants import DEFAULTS, Constants
from vkworkbench.core.simulators.motions import Motions, motions
from vkworkbench.core.stocks import Solid
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.view import View
from vkworkbench.core.zbuffer import Speed
from vkworkbench.language import Message, render


@dataclass(frozen=True, eq=False)
class Task:
    """One operation to simulate.

    Attributes
    ----------
    toolpath : Toolpath
    tool : Tool or None
        The tool; if tool or stock is unknown, no cost is predicted. FreeCAD's legacy simulator also cuts with the
        shank, so for a tool whose shank is wider than the cutting edge, give the shank's diameter.
    stock : Solid or None
    words : Words or None
        Words of the operation's commands, in which the warnings search for commands that a simulator handles wrongly.
    recognition : Recognition or None
    """

    toolpath: Toolpath
    tool: Tool | None = None
    stock: Solid | None = None
    words: Words | None = None
    recognition: Recognition | None = None

    @cached_property
    def motions(self) -> Motions:
        """The motions that FreeCAD's simulators compute from the toolpath."""
        return motions(self.toolpath)

    @property
    def cutting(self) -> tuple[Tool, Solid]:
        """The tool and the stock of the operation.

        Raises
        ------
        ValueError
            If the tool or the stock is unknown.
        """
        if self.tool is None or self.stock is None:
            raise ValueError("no cost is predicted without tool and stock")
        return self.tool, self.stock

    def without_words(self) -> Task:
        """Return the task without its words, which need more memory than the rest of the task."""
        if self.words is None:
            return self
        bare = replace(self, words=None)
        vars(bare)["motions"] = self.motions
        return bare


@dataclass(frozen=True)
class Conditions:
    """The version of FreeCAD, the speed of the computer, and the settings of a simulation.

    Attributes
    ----------
    version : tuple of int
        Version of FreeCAD, with at least the major and the minor number; empty without FreeCAD.
    constants : Constants
        Times and memory sizes of the steps of FreeCAD's simulators on this computer.
    speed : Speed
        Speed of this computer, from which times in the extended z-buffer are estimated.
    view : View
        View whose image the extended z-buffer simulates.
    legacy_accuracy : float
        Edge of a cell of the legacy simulator in percent of the stock's longer side.
    opengl_quality : int
        Position of the OpenGL simulator's quality slider, 1 to 10.
    memory_budget, time_budget : float
        Limits of memory, bytes, and time, s, for one operation. Simulations above a limit get a warning.
    """

    version: tuple[int, ...] = ()
    constants: Constants = DEFAULTS
    speed: Speed = field(default_factory=Speed)
    view: View = field(default_factory=View)
    legacy_accuracy: float = 0.1
    opengl_quality: int = 10
    memory_budget: float = 1e9
    time_budget: float = 600.0


class Cost(Protocol):
    """The cost of an operation, or of several operations in sequence, in one simulator."""

    @property
    def seconds(self) -> float:
        """Time of the simulation, including its display, s."""

    @property
    def memory_bytes(self) -> float:
        """Peak memory of the simulation, bytes."""

    @property
    def factor(self) -> float:
        """Factor, at least 1: the actual time is between `seconds` / `factor` and `seconds` * `factor`."""


# Codes of warnings, the worst first: simulations that never end, need too much memory, take too long, show a wrong
# depth of ramps, or have many moves shorter than a cell.
WORST_FIRST = "legacy-hangs", "memory", "long-play", "legacy-ramp", "short-moves"


@dataclass(frozen=True)
class Caution:
    """A warning before a simulation is started.

    Attributes
    ----------
    code : str
        One of `WORST_FIRST`, or another code that a simulator defines. Warnings with other codes are sorted after the
        warnings with codes in `WORST_FIRST`.
    what : Message
        Message that describes the problem and gives advice.
    command : int or None
        Index of the first command with the problem; None if the problem concerns the whole operation.
    """

    code: str
    what: Message
    command: int | None = None

    @property
    def message(self) -> str:
        """The description of the problem and the advice in English, as one or two sentences with full stops."""
        return render(self.what)

    def __str__(self) -> str:
        return self.message


@dataclass(frozen=True, eq=False)
class Simulator:
    """The functions and texts of one simulator whose cost is predicted.

    Attributes
    ----------
    name : str
        Name of the simulator in preferences, documents and macros. The name must never change.
    since : tuple of int
        First version of FreeCAD that has the simulator; empty if the simulator does not need FreeCAD.
    predict : callable
        ``predict(task, conditions)`` returns the Cost of one operation whose tool and stock are known.
    together : callable
        ``together(costs)`` returns the Cost of several operations in sequence.
    cautions : callable or None
        ``cautions(task, cost, conditions)`` returns the warnings for one operation. The argument `cost` is None if the
        cost is unknown. The attribute is None if the simulator has no warnings except about memory.
    kept : type
        Dataclass that names the fields of a cost that FreeCAD documents store.
    less_memory : Message
        Advice on how to reduce the memory of a simulation.
    columns : dict of str to callable
        Columns in CSV and JSON. The keys of the dictionary are the names of the columns. Each function returns the
        column's value from a cost.
    factor_column : str or None
        Name of the column with the uncertainty factor of the time (`Cost.factor`), which comes after the columns of all
        simulators; None if `columns` contains the factor.
    time_tooltip, memory_tooltip : str
        Tooltips of the columns for time and memory in the panel, translated in the context "Vk_Results".
    preferences : tuple of str
        Names of the preferences that have no effect without the simulator.
    most_bytes : callable or None
        ``most_bytes(task, conditions)`` returns an upper bound of the memory for one operation, and takes little time.
        If this upper bound of the memory is within the budget, the exact cost is not computed, because no warning about
        memory is needed.
    """

    name: str
    since: tuple[int, ...]
    predict: Callable[[Task, Conditions], Cost]
    together: Callable[[Sequence[Any]], Cost]
    cautions: Callable[[Task, Any, Conditions], list[Caution]] | None
    kept: type
    less_memory: Message
    columns: dict[str, Callable[[Any], Any]]
    factor_column: str | None
    time_tooltip: str
    memory_tooltip: str
    preferences: tuple[str, ...] = ()
    most_bytes: Callable[[Task, Conditions], float] | None = None

    def figures(self, cost: Cost | None) -> dict[str, Any]:
        """Return the columns with their values from a cost; all values are None if `cost` is None."""
        return {name: None if cost is None else number(cost) for name, number in self.columns.items()}
