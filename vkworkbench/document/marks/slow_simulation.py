# SPDX-License-Identifier: LGPL-2.1-or-later
"""Warn of a simulation in FreeCAD that hangs or takes too long, from the marks in the tree alone."""

from __future__ import annotations

from collections.abc import Sequence

from vkworkbench.core.simulators import LEGACY, SIMULATORS, Cost
from vkworkbench.document.marks.record import Record
from vkworkbench.document.marks.text import Burden, burden, is_long_play
from vkworkbench.language import Message
from vkworkbench.preferences import Preferences
from vkworkbench.report import HANGS


def warning_at_start(simulator: str, records: Sequence[Record | None], chosen: Preferences) -> Message | None:
    """Return the warning for a simulator of FreeCAD that is started on operations.

    Return None if the simulator does not hang, and its time is within the budget or unknown. `records` are the marks of
    the operations, None for an operation without a mark. Outdated marks are ignored.
    """
    fresh = [record for record in records if record is not None and not record.outdated]
    hangs = _hangs(simulator, fresh)
    if hangs is not None:
        return hangs
    cost, bound = _together(simulator, fresh, len(records))
    if cost is None or _seconds_of_play(simulator, cost) <= chosen.time_budget:
        return None
    return Message("started-takes", simulator=simulator, bound=bound, time=_seconds_of_play(simulator, cost))


def too_long(record: Record, chosen: Preferences) -> Message | None:
    """Return a warning, with a faster way, if a mark in the tree shows a time over the budget; else None."""
    if burden(record, chosen) is not Burden.OVER:
        return _long_play(record) if is_long_play(record, chosen) else None
    seconds, _ = record.cost(chosen.simulator)
    _, bound = _together(chosen.simulator, [record], 1)
    return Message(
        "over-budget", simulator=chosen.simulator, bound=bound, time=seconds, allowed=chosen.time_budget,
        better=Message("ours-instead"),
    )  # fmt: skip


def _long_play(record: Record) -> Message:
    cost = record.costs[LEGACY.name]
    return Message("legacy-long-play", simulator=LEGACY.name, longer=cost.play_seconds, time=cost.fast_forward_seconds)


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
