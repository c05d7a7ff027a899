# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors, warnings and notes on a marked operation, shown in the tree, in tooltips and in the results panel."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import IntEnum

from vkworkbench.core.simulators import OPENGL, Caution, slow_frames
from vkworkbench.document.marks.record import Record
from vkworkbench.document.marks.slow_simulation import too_long
from vkworkbench.document.marks.text import is_serious
from vkworkbench.gui.qt.sentences import sentence, strategy_name
from vkworkbench.gui.qt.text import translate
from vkworkbench.language import Message
from vkworkbench.preferences import Preferences
from vkworkbench.report import HANGS, OperationReport, contradiction, is_switched_off

# Codes of remarks on problems that do not prevent an estimate of the simulation's cost. The remarks with these codes
# are warnings even if the cost is unknown for another reason.
_WITH_COSTS = frozenset({
    "beyond-travel", "coordinates-not-changed", "feeds-per-minute", "in-commands", "inches-as-millimetres", "no-job", "no-stock",
    "stock-as-box", "tool-simplified",
})  # fmt: skip


class Level(IntEnum):
    """Severity of a notice, shown by its icon."""

    NOTE = 0
    WARNING = 1
    ERROR = 2


@dataclass(frozen=True)
class Notice:
    """An error, a warning or a note: a sentence with its severity."""

    level: Level
    text: str


def notices_of(record: Record, chosen: Preferences) -> list[Notice]:
    """Return the notices of an operation or a job, the most severe first.

    For a warning or an error, the mark in the tree has a sign.
    """
    return sorted(_notices(record, chosen), key=lambda notice: -notice.level)


def kind_of(found: OperationReport | Record) -> str:
    """Return the name of an operation's strategy, or "switched off"."""
    return translate("Pills", "switched off") if is_switched_off(found) else strategy_name(found.strategy)


def level_of(remark: Message, record: Record) -> Level:
    """Return the severity of a remark: an error if the cost of the operation's simulation is unknown because of it."""
    if is_switched_off(record):
        return Level.NOTE
    harmless = record.strategy is None or record.costs or remark.code in _WITH_COSTS
    return Level.WARNING if harmless else Level.ERROR


def _notices(record: Record, chosen: Preferences) -> Iterator[Notice]:
    if record.verdict is not None:
        yield Notice(Level.NOTE if record.verdict.is_sound else Level.WARNING, sentence(record.verdict.message))
    for remark in record.remarks:
        yield Notice(level_of(remark, record), sentence(remark))
    wrong = contradiction(record)
    if wrong is not None:
        yield Notice(Level.WARNING, sentence(wrong))
    longer = too_long(record, chosen)
    if longer is not None:
        yield Notice(Level.WARNING, sentence(longer))
    if record.strategy is None and chosen.simulator == OPENGL.name and OPENGL.name in record.costs:
        slow = slow_frames(record.costs[OPENGL.name])
        if slow is not None:
            yield Notice(Level.NOTE, sentence(slow))
    for caution in record.cautions:
        serious = is_serious(caution, chosen)
        # The notice `longer` already says what the caution about a long playback would repeat.
        if not (serious and caution.code == "long-play" and longer is not None):
            yield Notice(_level(caution) if serious else Level.NOTE, sentence(caution.what))


def _level(caution: Caution) -> Level:
    return Level.ERROR if caution.code in HANGS else Level.WARNING
