# SPDX-License-Identifier: LGPL-2.1-or-later
"""The columns of the results panel: seven default columns, and further columns that the user can choose."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import FreeCAD

from vkworkbench.core.simulators import ZBUFFER, Simulator, available
from vkworkbench.gui.qt.sentences import is_chinese, plain_sentence, sentence, user
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.results.rows import Row
from vkworkbench.language import ROUGH
from vkworkbench.report import compare_setups, compare_with_sum

OPERATION, STRATEGY, WARNINGS, NOTES = "operation", "strategy", "warnings", "notes"
STATE, LENGTH, REASON = "state", "length", "reason"


@dataclass(frozen=True)
class Column:
    """One column of the results panel."""

    key: str  # name of the column in the preferences
    title: str
    tooltip: str
    value: Callable[[Row], object]  # returns the value of a row: a number, a text, or None
    shown: Callable[[object], str] = str  # returns the text that the column shows for a value
    # For a column with estimated times: returns the uncertainty of a row's time as a factor. The measured time is
    # expected to be between time / factor and time * factor.
    factor: Callable[[Row], float] | None = None
    least: Callable[[Row], bool] = lambda row: False  # returns whether the value of a row is a lower bound
    note: Callable[[Row], str] = lambda row: ""  # returns a sentence that explains the value of a row, or an empty text

    @property
    def name(self) -> str:
        """The column's title in one line.

        A line break becomes a space, except after a hyphen and between Chinese letters.
        """
        first, _, second = self.title.replace("-\n", "").partition("\n")
        together = not second or (is_chinese(first[-1:]) and is_chinese(second[:1]))
        return first + second if together else f"{first} {second}"

    def text(self, row: Row) -> str:
        """Return the text of a row in this column; empty if the row has no value."""
        value = self.value(row)
        if value is None:
            return ""
        least = self.least(row)
        if not self.factor:
            text = self.shown(value)
        elif least:
            text = user().time(value, self.factor(row))
        else:
            text = user().estimated_time(value, self.factor(row))
        return f"≥ {text}" if least else text

    def remark(self, row: Row) -> str:
        """Return the range of a roughly estimated time and the note on the row's value as text; empty without both."""
        value, factor = self.value(row), self.factor(row) if self.factor else 1.0
        if value is None:
            return ""
        between = ""
        if factor >= ROUGH:
            low, high = user().time(value / factor, factor), user().time(value * factor, factor)
            between = user().between(low, high)
        return "\n".join(filter(None, [between, self.note(row)]))


def columns(version: tuple[int, ...], marked: str) -> tuple[list[Column], list[Column]]:
    """Return the default columns, and the further columns that the user can choose.

    The version of FreeCAD determines the available simulators. `marked` is the name of the simulator whose time the
    marks in the tree show.
    """
    simulators = available(version)
    time = translate("Vk_Results", "Time in the {simulator}, as the marks show it.")
    first = [
        Column(OPERATION, translate("Vk_Results", "Operation"), "", lambda row: row.label),
        Column(STRATEGY, translate("Vk_Results", "Strategy"),
               translate("Vk_Results", "The machining strategy, recognized from the toolpath alone."),
               lambda row: row.kind),
        Column("machining_time", translate("Vk_Results", "Machining\nTime"),
               translate("Vk_Results", "Time on the machine of the preferences. Without a machine: at constant feeds, and "
                                       "with rapids if the tool controller has rapid speeds."),
               lambda row: row.found.machining_seconds or None, _as("clock"), least=lambda row: not row.machining_complete,
               note=_of_machining),
        Column("simulation_time", translate("Vk_Results", "Simulation\nTime"),
               time.format(simulator=user().simulator(marked)),
               partial(_seconds, marked), factor=partial(_factor, marked), least=_is_bound, note=partial(_beside_sum, marked)),
        Column(STATE, translate("Vk_Results", "State"),
               translate("Vk_Results", "A result is outdated if the toolpath, the tool or the stock has changed since. "
                                       "Analyze the operation again."),
               lambda row: translate("Vk_Results", "outdated") if row.outdated else None),
        Column(WARNINGS, translate("Vk_Results", "Warnings"),
               translate("Vk_Results", "Problems of the operation, and what goes wrong when you simulate it."),
               lambda row: " ".join(row.texts(warned=True)) or None),
        Column(NOTES, translate("Vk_Results", "Notes"),
               translate("Vk_Results", "Remarks that need no action, such as problems of a simulator that the marks do not show."),
               lambda row: " ".join(row.texts(warned=False)) or None),
    ]  # fmt: skip
    longest = translate(
        "Vk_Results",
        "Longest time that the {simulator} is expected to take. It is the estimate, "
        "multiplied by the factor to within which estimates are right.",
    )
    others = [
        Column(REASON, translate("Vk_Results", "In Plain Words"),
               translate("Vk_Results", "The toolpath in one sentence: the reason for the strategy."), _reason),
        Column("longest", translate("Vk_Results", "Simulation Time\nat Most"), longest.format(simulator=user().simulator(marked)),
               partial(_longest, marked), lambda seconds: user().time(seconds, ROUGH)),
        Column("sure", translate("Vk_Results", "Confidence"), translate("Vk_Results", "The confidence of the recognition."),
               _confidence, _as("share")),
        Column("moves", translate("Vk_Results", "Moves"),
               translate("Vk_Results", "Number of straight moves. An arc counts as several."),
               lambda row: row.found.trajectories, _as("count")),
        Column(LENGTH, translate("Vk_Results", "Length"), translate("Vk_Results", "Length of the cutting moves."),
               lambda row: row.found.length, _as("length")),
        *(column for simulator in simulators for column in _of_simulator(simulator)),
        Column(f"{ZBUFFER.name} advice", translate("Vk_Results", "Recommended\nImage"),
               translate("Vk_Results", "The finest image of Simulate Toolpaths within your limits of time and memory."),
               _image_size, _as_image_size),
    ]  # fmt: skip
    return first, others


def _of_machining(row: Row) -> str:
    """Return the note on a machining time: what the time includes."""
    if not row.found.setup.planned:
        return translate("Vk_Results", "At constant feed. Choose your machine in the preferences, page Machine.")
    note = compare_setups(row.found) if row.is_total else None
    return sentence(note) if note else ""


def _beside_sum(simulator: str, row: Row) -> str:
    """Return why a job's simulation time is not the sum of its operations' times; empty if the reason is not needed."""
    note = compare_with_sum(row.found, (one.found for one in row.rows if one.is_counted), simulator)
    return sentence(note) if note else ""


def _as(kind: str) -> Callable[[object], str]:
    """Return a function that formats a number for the user by the method `kind` of `Reader`."""
    return lambda value: getattr(user(), kind)(value)  # noqa: PLW0108 - the user at the time of the call


def _seconds(simulator: str, row: Row) -> float | None:
    cost = row.found.cost(simulator)
    return cost and cost[0]


def _longest(simulator: str, row: Row) -> float | None:
    cost = row.found.cost(simulator)
    return None if cost is None or _is_bound(row) else cost[0] * row.found.factor(simulator)


def _bytes(simulator: str, row: Row) -> float | None:
    cost = row.found.cost(simulator)
    return cost and cost[1]


def _factor(simulator: str, row: Row) -> float:
    return row.found.factor(simulator)


def _is_bound(row: Row) -> bool:
    return row.is_total and row.found.incomplete


def _of_simulator(simulator: Simulator) -> tuple[Column, Column]:
    """Return the columns with time and memory of a simulator, for an operation or a whole job."""
    name, text = simulator.name, partial(FreeCAD.Qt.translate, "Vk_Results")
    # This add-on's own simulator has no menu entry among FreeCAD's simulators, so its column has the command's name.
    called = translate("Vk_Simulate", "Simulate Toolpaths") if simulator is ZBUFFER else user().simulator(name)
    time, memory = translate("Vk_Results", "{simulator}\nTime"), translate("Vk_Results", "{simulator}\nMemory")
    return (
        Column(f"{name} time", time.format(simulator=called), text(simulator.time_tooltip),
               partial(_seconds, name), factor=partial(_factor, name), least=_is_bound),
        Column(f"{name} memory", memory.format(simulator=called), text(simulator.memory_tooltip),
               partial(_bytes, name), _as("memory")),
    )  # fmt: skip


def _image_size(row: Row) -> tuple[int, int] | None:
    """Return width and height of the recommended image, pixels; 0 if no image is within the budget."""
    chosen = row.found.resolution
    if chosen is None:
        return None
    return (chosen.view.width, chosen.view.height) if chosen.view else (0, 0)


def _as_image_size(size: tuple[int, int]) -> str:
    return "{} × {}".format(*map(user().count, size)) if all(size) else translate("Vk_Results", "none")


def _reason(row: Row) -> str | None:
    return None if row.is_total else " ".join(map(plain_sentence, row.mark.reason)) or None


def _confidence(row: Row) -> float | None:
    return row.found.confidence if row.strategy is not None and row.strategy.is_answer else None
