# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with a marked operation or to be known of it, as the user reads it: in the tree, its tooltip and the panel."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import IntEnum

from vkworkbench.core.simulators import Caution
from vkworkbench.document.marks.better_way import too_long
from vkworkbench.document.marks.record import Record
from vkworkbench.document.marks.text import is_serious
from vkworkbench.gui.qt.sentences import said, strategy_name
from vkworkbench.gui.qt.text import translate
from vkworkbench.preferences import Preferences
from vkworkbench.report import HANGS, OperationReport, contradiction, is_switched_off


class Level(IntEnum):
    """How much the user must know something; the icon of a notice says it."""

    NOTE = 0
    WARNING = 1
    ERROR = 2


@dataclass(frozen=True)
class Notice:
    """One sentence of it."""

    level: Level
    text: str


def notices_of(record: Record, chosen: Preferences) -> list[Notice]:
    """Return what is to be known of an operation or a job, the worst first; more than notes where the tree has a sign."""
    return sorted(_notices(record, chosen), key=lambda notice: -notice.level)


def kind_of(found: OperationReport | Record) -> str:
    """Return what an operation does: the name of its strategy, or that it is switched off."""
    return translate("Pills", "switched off") if is_switched_off(found) else strategy_name(found.strategy)


def level_of_remarks(record: Record) -> Level:
    """Return how bad the remarks are: without a tool, a stock or a toolpath nothing is known of an operation's simulation."""
    if is_switched_off(record):
        return Level.NOTE
    return Level.WARNING if record.strategy is None or record.costs else Level.ERROR


def _notices(record: Record, chosen: Preferences) -> Iterator[Notice]:
    for remark in record.remarks:
        yield Notice(level_of_remarks(record), said(remark))
    wrong = contradiction(record)
    if wrong is not None:
        yield Notice(Level.WARNING, said(wrong))
    longer = too_long(record, chosen)
    if longer is not None:
        yield Notice(Level.WARNING, said(longer))
    for caution in record.cautions:
        serious = is_serious(caution, chosen)
        if not (serious and caution.code == "long-play" and longer is not None):  # it would say the same once more
            yield Notice(_level(caution) if serious else Level.NOTE, said(caution.what))


def _level(caution: Caution) -> Level:
    return Level.ERROR if caution.code in HANGS else Level.WARNING
