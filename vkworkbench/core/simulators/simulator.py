# SPDX-License-Identifier: LGPL-2.1-or-later
"""The interface of a simulator: its entry in the table (table.py), and the arguments of its functions."""

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
        Without a tool or a stock there is no cost. In FreeCAD's legacy simulator a shank wider than the cutting edge cuts as
        well; give its diameter then.
    stock : Solid or None
    words : Words or None
        Words of the commands, in which the simulators look for commands that they handle wrongly.
    recognition : Recognition or None
    """

    toolpath: Toolpath
    tool: Tool | None = None
    stock: Solid | None = None
    words: Words | None = None
    recognition: Recognition | None = None

    @cached_property
    def motions(self) -> Motions:
        """The motions that FreeCAD's simulators make of the toolpath, computed once."""
        return motions(self.toolpath)

    @property
    def cutting(self) -> tuple[Tool, Solid]:
        """Tool and stock.

        Raises
        ------
        ValueError
            If the tool or the stock is unknown.
        """
        if self.tool is None or self.stock is None:
            raise ValueError("no cost is predicted without tool and stock")
        return self.tool, self.stock

    def without_words(self) -> Task:
        """Return the same task without the words, which take more memory than everything else."""
        bare = replace(self, words=None)
        vars(bare)["motions"] = self.motions
        return bare


@dataclass(frozen=True)
class Conditions:
    """The FreeCAD, the computer and the settings of a simulation.

    Attributes
    ----------
    version : tuple of int
        Version of FreeCAD, at least major and minor; empty without FreeCAD.
    constants : Constants
        Costs of the unit work of FreeCAD's simulators on this computer.
    speed : Speed
        Speed of this computer, for the extended z-buffer.
    view : View
        Image of the extended z-buffer.
    legacy_accuracy : float
        Edge of a cell of the legacy simulator in percent of the stock's longer side.
    opengl_quality : int
        Position of the OpenGL simulator's quality slider, 1 to 10.
    memory_budget, time_budget : float
        Memory, bytes, and time, s, that one operation may take; more gives a caution.
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
    """The cost of an operation, or of several in sequence, in one simulator.

    Attributes
    ----------
    seconds, memory_bytes : float
    factor : float
        The true time is between `seconds` divided and multiplied by this.
    """

    @property
    def seconds(self) -> float:
        """Time of the simulation and of its display, s."""

    @property
    def memory_bytes(self) -> float:
        """Memory of the simulation at its peak, bytes."""

    @property
    def factor(self) -> float:
        """Factor by which the time may be off, at least 1."""


# The codes of cautions: simulations that never end, take too much memory or time, are wrong, or are slow.
WORST_FIRST = "legacy-hangs", "memory", "long-play", "legacy-ramp", "arcs", "short-moves"


@dataclass(frozen=True)
class Caution:
    """A warning before a simulation is started.

    Attributes
    ----------
    code : str
        One of `WORST_FIRST`, or the code of a further simulator, which is sorted behind them.
    what : Message
        What happens and what to do.
    command : int or None
        Index of the first command concerned; None if the caution concerns the whole operation.
    """

    code: str
    what: Message
    command: int | None = None

    @property
    def message(self) -> str:
        """The caution and the advice in English, one or two sentences with full stops."""
        return render(self.what)

    def __str__(self) -> str:
        return self.message


@dataclass(frozen=True)
class Advice:
    """Functions and texts for a simulator's finest setting within a budget.

    Attributes
    ----------
    choose : callable
        ``choose(costs, memory_bytes=, seconds=, stepover=, labels=)`` returns the choice for operations in sequence: an
        object with the message `why` and its English `explanation`.
    numbers : callable
        Returns the numbers of a choice; all 0 if no setting is within the budget.
    form : str
        Format string for the numbers of a choice.
    column : str
        Name of its column in CSV and JSON.
    title, tooltip, sentence, none : str
        Title and tooltip of the column in the panel, the sentence below the table, which may name the ``{simulator}``, and
        the text if no setting is within the budget. Translated in the context "Vk_Results".
    """

    choose: Callable[..., Any]
    numbers: Callable[[Any], tuple[int, ...]]
    form: str
    column: str
    title: str
    tooltip: str
    sentence: str
    none: str


@dataclass(frozen=True, eq=False)
class Simulator:
    """The functions and texts of one simulator whose cost is predicted.

    Attributes
    ----------
    name : str
        Name in preferences, documents and macros. It never changes.
    since : tuple of int
        The first FreeCAD that has the simulator; empty if it does not need FreeCAD.
    predict : callable
        ``predict(task, conditions)`` returns the Cost of one operation whose tool and stock are known.
    together : callable
        ``together(costs)`` returns the Cost of several operations in sequence.
    cautions : callable or None
        ``cautions(task, cost, conditions)`` returns the Cautions for one operation; the cost may be None. None if the
        simulator has no errors of its own.
    kept : type
        The dataclass whose fields documents keep for each of its costs.
    less_memory : Message
        Advice for simulations that take too much memory.
    columns : dict of str to callable
        Columns in CSV and JSON: names, and functions that return a number from a cost.
    factor_column : str or None
        Column of the cost's factor, behind the columns of all simulators; None if `columns` has the factor.
    time_tooltip, memory_tooltip : str
        Tooltips of the columns in the panel; translated in the context "Vk_Results".
    advice : Advice or None
    preferences : tuple of str
        Names of the preferences that have no effect without the simulator.
    most_bytes : callable or None
        ``most_bytes(task, conditions)`` returns a quick upper bound of the memory of one operation. The cost is not computed
        if even the bound is within the budget.
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
    advice: Advice | None = None
    preferences: tuple[str, ...] = ()
    most_bytes: Callable[[Task, Conditions], float] | None = None

    def figures(self, cost: Cost | None) -> dict[str, Any]:
        """Return the columns with the numbers of a cost; without a cost the cells are empty."""
        return {name: None if cost is None else number(cost) for name, number in self.columns.items()}
