# SPDX-License-Identifier: LGPL-2.1-or-later
"""Warn of a simulation that hangs or takes too long, and suggest a faster one, from the marks in the tree alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from vkworkbench import freecad
from vkworkbench.core.simulators import LEGACY, SIMULATORS, Cost
from vkworkbench.document.marks.record import Record
from vkworkbench.document.marks.text import Burden, burden
from vkworkbench.language import Message
from vkworkbench.preferences import Preferences
from vkworkbench.report import HANGS

OURS = "ours"  # value of `way` for the simulation tab of this add-on


@dataclass(frozen=True)
class BetterWay:
    """A warning of a simulation that the user is about to start, with a faster way."""

    wrong: Message  # the problem of the simulation
    better: Message  # the faster way, with its time
    way: str  # the name of one of FreeCAD's simulators (the legacy simulator runs in fast-forward), or `OURS`


def better_way(simulator: str, records: Sequence[Record | None], chosen: Preferences) -> BetterWay | None:
    """Return the warning for a simulator that is started on operations.

    Return None if the simulator does not hang, and its time is within the budget or unknown.

    Parameters
    ----------
    simulator : str
        Name of one of FreeCAD's simulators.
    records : sequence of Record or None
        The marks of the operations, None for an operation without a mark. Outdated marks are ignored.
    """
    fresh = [record for record in records if record is not None and not record.outdated]
    wrong = _hangs(simulator, fresh)
    if wrong is None:
        cost, bound = _together(simulator, fresh, len(records))
        if cost is None or _seconds_of_play(simulator, cost) <= chosen.time_budget:
            return None
        wrong = Message("started-takes", simulator=simulator, bound=bound, time=_seconds_of_play(simulator, cost))
    way, better = _way(simulator, fresh, len(records), chosen)
    return BetterWay(wrong, better, way)


def too_long(record: Record, chosen: Preferences) -> Message | None:
    """Return a warning, with a faster way, if a mark in the tree shows a time over the budget; else None."""
    if burden(record, chosen) is not Burden.OVER:
        return None
    seconds, _ = record.cost(chosen.simulator)
    _, bound = _together(chosen.simulator, [record], 1)
    _, better = _way(chosen.simulator, [record], 1, chosen)
    return Message(
        "over-budget", simulator=chosen.simulator, bound=bound, time=seconds, allowed=chosen.time_budget, better=better
    )


def _hangs(simulator: str, fresh: list[Record]) -> Message | None:
    found = [
        (record, caution) for record in fresh for caution in record.cautions
        if caution.code in HANGS and caution.what.arguments["simulator"] == simulator
    ]  # fmt: skip
    if not found:
        return None
    record, caution = found[0]
    others = len({id(record) for record, _ in found}) - 1
    return Message(
        "started-hangs", simulator=simulator, command=caution.command + 1, label=record.label, reason=caution.what.arguments["reason"],
        others=Message("and-other-operations", count=others) if others else None,
    )  # fmt: skip


def _way(simulator: str, fresh: list[Record], operations: int, chosen: Preferences) -> tuple[str, Message]:
    """Return the faster way and its message: the first simulator of FreeCAD within the time budget, else `OURS`."""
    for name in sorted(freecad.own_simulators(), key=lambda name: name != simulator):
        cost, bound = _together(name, fresh, operations)
        slow = name == simulator != LEGACY.name  # only the legacy simulator has a faster mode, fast-forward
        if slow or cost is None or cost.seconds > chosen.time_budget or _hangs(name, fresh):
            continue
        if name == simulator:
            return name, Message("fast-forward-takes", bound=bound, time=cost.seconds)
        if name == LEGACY.name:
            return name, Message("legacy-takes", simulator=name, bound=bound, time=cost.seconds)
        return name, Message("opengl-takes", simulator=name, bound=bound, time=cost.seconds)
    return OURS, Message("ours-instead")


def _together(simulator: str, fresh: list[Record], operations: int) -> tuple[Cost | None, Message]:
    """Return the total cost of operations in a simulator, and a word that qualifies the cost.

    The word is the message "about", or "at least" if the costs of some operations are unknown.
    """
    (entry,) = [entry for entry in SIMULATORS if entry.name == simulator]
    costs = [record.costs[simulator] for record in fresh if simulator in record.costs]
    without_moves = sum(record.trajectories == 0 for record in fresh)
    complete = len(costs) + without_moves >= operations and not any(record.incomplete for record in fresh)
    return (entry.together(costs) if costs else None), Message("bound-about") if complete else Message("bound-least")


def _seconds_of_play(simulator: str, cost: Cost) -> float:
    """Return the time of the playback, which the button "play" starts.

    For the legacy simulator, a mark shows the shorter time of fast-forward instead.
    """
    return cost.play_seconds if simulator == LEGACY.name else cost.seconds
