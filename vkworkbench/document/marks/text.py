# SPDX-License-Identifier: LGPL-2.1-or-later
"""The text of a mark in the tree: the strategy, the time on the machine, the time of one simulator, and warnings."""

from __future__ import annotations

from enum import IntEnum

from vkworkbench.core.simulators import LEGACY, Caution
from vkworkbench.document.marks.record import Record
from vkworkbench.language import ENGLISH, Reader, render
from vkworkbench.preferences import Preferences
from vkworkbench.report import SERIOUS, how_many, is_switched_off

OPENING, CLOSING, SEPARATOR, OUTDATED = "⟦", "⟧", " · ", "outdated"
SWITCHED_OFF = "switched off"
SIMULATION, WARNING = "sim", "⚠"
UNSURE = 0.8  # a mark shows only confidences below this value
_NEAR = 0.5  # share of the time budget above which a simulation time is NEAR the budget
_LONGEST_REMARK = 120  # maximum number of characters of the remarks in a description


class Burden(IntEnum):
    """Whether the time of a simulation is well within, near or over the time budget of the preferences."""

    FINE, NEAR, OVER = range(3)


def burden(record: Record, chosen: Preferences) -> Burden:
    """Compare the time in the simulator of the preferences with the time budget; an unknown time counts as FINE."""
    cost = record.cost(chosen.simulator)
    share = cost[0] / chosen.time_budget if cost else 0.0
    return Burden.OVER if share > 1 else Burden.NEAR if share > _NEAR else Burden.FINE


def is_long_play(record: Record, chosen: Preferences) -> bool:
    """Return whether playing a whole job in the legacy simulator of the preferences takes longer than the budget.

    The mark shows the shorter time of fast-forward. Operations have a caution about a long play instead.
    """
    cost = record.costs.get(LEGACY.name)
    if record.strategy is not None or chosen.simulator != LEGACY.name or cost is None:
        return False
    return bool(cost.play_seconds > chosen.time_budget)


def is_serious(caution: Caution, chosen: Preferences) -> bool:
    """Return whether a caution says that the simulator of the preferences hangs or needs more than the budgets."""
    return caution.code in SERIOUS and caution.what.arguments.get("simulator") == chosen.simulator


def is_warned(record: Record, chosen: Preferences) -> bool:
    """Return whether tree, tooltip and results show a warning for the simulator of the preferences."""
    if is_switched_off(record):  # an operation that the user switched off needs no warning
        return False
    if record.verdict is not None and not record.verdict.is_sound:
        return True
    known = record.remarks or record.called or any(is_serious(caution, chosen) for caution in record.cautions)
    return burden(record, chosen) is Burden.OVER or is_long_play(record, chosen) or bool(known)


def time_of(record: Record, chosen: Preferences, reader: Reader = ENGLISH) -> str:
    """Return the time in the simulator of the preferences as text; empty if the time is unknown."""
    cost = record.cost(chosen.simulator)
    if not cost:
        return ""
    factor = record.factor(chosen.simulator)
    return f"≥ {reader.time(cost[0], factor)}" if record.incomplete else reader.estimated_time(cost[0], factor)


def machine_time_of(record: Record, reader: Reader = ENGLISH) -> str:
    """Return the time on the machine as text; empty if it is unknown or the operation is switched off."""
    if not record.machining_seconds or is_switched_off(record):
        return ""
    time = reader.clock(record.machining_seconds)
    return f"≥ {time}" if record.left_out else time


def text_of(record: Record, chosen: Preferences) -> str:
    """Return the mark's text for the description, without brackets. The text is English for all users."""
    if record.strategy is None:
        first = how_many(record.operations, "operation") + (f" x{record.fixtures}" if record.fixtures > 1 else "")
    elif is_switched_off(record):
        first = SWITCHED_OFF
    else:
        first = record.strategy.value + (f" {record.confidence:.0%}" if is_unsure(record) else "")
    machine, time = machine_time_of(record), time_of(record, chosen)
    warning = f" {WARNING}" if is_warned(record, chosen) else ""
    parts = [first, *filter(None, [machine]), *([f"{SIMULATION} {time}{warning}"] if time else [])]
    if record.remarks and not is_switched_off(record):
        remark = _shortened(" ".join(map(render, record.remarks)))
        parts.append(remark if time else f"{WARNING} {remark}")
    return SEPARATOR.join([*parts, *([OUTDATED] if record.outdated else [])])


def is_unsure(record: Record) -> bool:
    """Return whether a mark in the tree names a strategy with a low confidence."""
    return record.strategy is not None and record.strategy.is_answer and record.confidence < UNSURE


def _shortened(text: str) -> str:
    text = text.replace(OPENING, "[").replace(CLOSING, "]")
    return text if len(text) <= _LONGEST_REMARK else text[: _LONGEST_REMARK - 1].rstrip() + "…"
