# SPDX-License-Identifier: LGPL-2.1-or-later
"""The interface of a simulator: its entry in the table (table.py), and what its functions are given."""

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
    """What is to be simulated: one operation.

    Attributes
    ----------
    toolpath : Toolpath
    tool : Tool or None
        No cost is predicted where the tool or the stock is None. In FreeCAD's legacy simulator a shank wider than the
        cutting edge cuts as well; give its diameter then.
    stock : Solid or None
    words : Words or None
        Of the commands; in them the simulators look for what they handle wrongly.
    recognition : Recognition or None
    """

    toolpath: Toolpath
    tool: Tool | None = None
    stock: Solid | None = None
    words: Words | None = None
    recognition: Recognition | None = None

    @cached_property
    def motions(self) -> Motions:
        """The motions that FreeCAD's simulators make of the toolpath; computed once for all of them."""
        return motions(self.toolpath)

    @property
    def cutting(self) -> tuple[Tool, Solid]:
        """Tool and stock.

        Raises
        ------
        ValueError
            If one of them is not known: then no cost is predicted.
        """
        if self.tool is None or self.stock is None:
            raise ValueError("no cost is predicted without tool and stock")
        return self.tool, self.stock

    def without_words(self) -> Task:
        """Return the same task without the words, which take more memory than all the rest."""
        bare = replace(self, words=None)
        vars(bare)["motions"] = self.motions
        return bare


@dataclass(frozen=True)
class Conditions:
    """The FreeCAD, the computer and the settings of a simulation.

    Attributes
    ----------
    version : tuple of int
        Of FreeCAD, at least major and minor; empty where there is none.
    constants : Constants
        What the work of FreeCAD's simulators costs on this computer.
    speed : Speed
        Of this computer, for the extended z-buffer.
    view : View
        Image of the extended z-buffer.
    legacy_accuracy : float
        Edge of a cell of the legacy simulator in percent of the stock's longer side.
    opengl_quality : int
        Position of the OpenGL simulator's quality slider, 1 to 10.
    memory_budget, time_budget : float
        Bytes and s that one operation may take; more gives a caution.
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
    """What a simulator takes for an operation, or for several one after another.

    Attributes
    ----------
    seconds, memory_bytes : float
    factor : float
        The true time is between `seconds` divided and multiplied by this.
    """

    @property
    def seconds(self) -> float:
        """Of computing and of showing it."""

    @property
    def memory_bytes(self) -> float:
        """At its peak."""

    @property
    def factor(self) -> float:
        """How far the time may be off."""


# The codes of cautions: what never ends, what is too much, what is wrong, what is only slow.
WORST_FIRST = "legacy-hangs", "memory", "long-play", "legacy-ramp", "arcs", "short-moves"


@dataclass(frozen=True)
class Caution:
    """Something to know before a simulation is started.

    Attributes
    ----------
    code : str
        What it is, for programs: one of `WORST_FIRST`, or one that a further simulator adds, which comes behind.
    what : Message
        What happens and what to do.
    command : int or None
        Index of the first command concerned; None where it is the operation as a whole.
    """

    code: str
    what: Message
    command: int | None = None

    @property
    def message(self) -> str:
        """What happens and what to do in English, one or two sentences with full stops."""
        return render(self.what)

    def __str__(self) -> str:
        return self.message


@dataclass(frozen=True)
class Advice:
    """How a simulator's finest setting within a budget is chosen, and how it is shown.

    Attributes
    ----------
    choose : callable
        ``choose(costs, memory_bytes=, seconds=, stepover=, labels=)`` is the choice for operations one after another,
        an object with the message `why` and its English `explanation`.
    numbers : callable
        The numbers of a choice, which `form` shows; all 0 where no setting helps.
    form : str
        The format string of these numbers.
    column : str
        Name of its column in CSV and JSON.
    title, tooltip, sentence, none : str
        Title and tooltip of its column in the panel, the sentence below the table, which may name the ``{simulator}``, and
        the text where no setting helps. Translated in the context "Vk_Results".
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
    """One simulator whose cost is predicted: all that the rest of the add-on asks of it.

    Attributes
    ----------
    name : str
        Stable: it is stored in preferences and documents, and what macros ask for.
    since : tuple of int
        The first FreeCAD that has it; empty for what does not need FreeCAD.
    predict : callable
        ``predict(task, conditions)`` is the Cost of one operation whose tool and stock are known.
    together : callable
        ``together(costs)`` is the Cost of several operations, one after another.
    cautions : callable or None
        ``cautions(task, cost, conditions)`` are the Cautions for one operation; the cost may be None.
        None where nothing goes wrong in it.
    kept : type
        The dataclass whose fields documents keep for each of its costs.
    less_memory : Message
        What helps where it takes too much memory.
    columns : dict of str to callable
        Its columns in CSV and JSON: names, and the functions that take their numbers from a cost.
    factor_column : str or None
        Column of the cost's factor, which comes after the columns of all simulators; None where `columns` has it.
    time_tooltip, memory_tooltip : str
        Tooltips of its columns in the panel; translated in the context "Vk_Results".
    advice : Advice or None
    preferences : tuple of str
        Names of the preferences that have no effect without it.
    most_bytes : callable or None
        ``most_bytes(task, conditions)`` is a quick bound of the memory of one operation: the cost is not asked for where
        even that is allowed.
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
        """Return the columns with a cost's numbers; empty cells where there is none."""
        return {name: None if cost is None else number(cost) for name, number in self.columns.items()}
