# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mark in words: the strategy, the time of one simulator, and what the user must know."""

from __future__ import annotations

from enum import IntEnum

from vkworkbench.core.simulators import Caution
from vkworkbench.document.marks.record import Record
from vkworkbench.language import ENGLISH, Reader, render
from vkworkbench.preferences import Preferences
from vkworkbench.report import SERIOUS, how_many, is_switched_off

OPENING, CLOSING, SEPARATOR, OUTDATED = "⟦", "⟧", " · ", "outdated"
SWITCHED_OFF = "switched off"
PLAY, WARNING = "▶", "⚠"
UNSURE = 0.8  # below that confidence a mark says how sure it is
_NEAR = 0.5  # of the budget
_LONGEST_REMARK = 120  # characters in a document; the window shows all that it has room for


class Burden(IntEnum):
    """How a simulation's time compares with the budget of the preferences."""

    FINE, NEAR, OVER = range(3)


def burden(record: Record, chosen: Preferences) -> Burden:
    """Return whether simulating it in the simulator of the preferences stays within the budget of time."""
    cost = record.cost(chosen.simulator)
    share = cost[0] / chosen.time_budget if cost else 0.0
    return Burden.OVER if share > 1 else Burden.NEAR if share > _NEAR else Burden.FINE


def is_serious(caution: Caution, chosen: Preferences) -> bool:
    """Whether that simulator hangs, or takes more than is allowed."""
    return caution.code in SERIOUS and caution.what.arguments.get("simulator") == chosen.simulator


def is_warned(record: Record, chosen: Preferences) -> bool:
    """Whether the user must know something before starting that simulator: what is a warning, in tree, tooltip and results."""
    if is_switched_off(record):  # the user did it
        return False
    known = record.remarks or record.called or any(is_serious(caution, chosen) for caution in record.cautions)
    return burden(record, chosen) is Burden.OVER or bool(known)


def time_of(record: Record, chosen: Preferences, reader: Reader = ENGLISH) -> str:
    """Return the time of that simulator in words, empty where it is not known."""
    cost = record.cost(chosen.simulator)
    if not cost:
        return ""
    time = reader.estimated_time(cost[0], record.factor(chosen.simulator))
    return f"≥ {time}" if record.incomplete else time


def text_of(record: Record, chosen: Preferences) -> str:
    """Return the text that stands between the brackets in a description, in English, the same for all its readers."""
    if record.strategy is None:
        first = how_many(record.operations, "operation")
    elif is_switched_off(record):
        first = SWITCHED_OFF
    else:
        first = record.strategy.value + (f" {record.confidence:.0%}" if is_unsure(record) else "")
    time, warning = time_of(record, chosen), f" {WARNING}" if is_warned(record, chosen) else ""
    parts = [first, *([f"{PLAY} {time}{warning}"] if time else [])]
    if record.remarks and not is_switched_off(record):
        remark = _shortened("; ".join(map(render, record.remarks)))
        parts.append(remark if time else f"{WARNING} {remark}")
    return SEPARATOR.join([*parts, *([OUTDATED] if record.outdated else [])])


def is_unsure(record: Record) -> bool:
    """Whether the strategy of a mark is an answer that is not to be relied on."""
    return record.strategy is not None and record.strategy.is_answer and record.confidence < UNSURE


def _shortened(text: str) -> str:
    text = text.replace(OPENING, "[").replace(CLOSING, "]")
    return text if len(text) <= _LONGEST_REMARK else text[: _LONGEST_REMARK - 1].rstrip() + "…"
