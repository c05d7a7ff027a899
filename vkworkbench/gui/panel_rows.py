# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of the results: jobs as branches with their total, operations below them, and what is to be known of each."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import IntEnum

import FreeCAD

from vkworkbench.core import Strategy
from vkworkbench.document import marks
from vkworkbench.document.intent import contradicted
from vkworkbench.document.operations import find
from vkworkbench.gui.sentences import plural, said, strategy_name
from vkworkbench.gui.text import translate
from vkworkbench.report import OperationReport, Report, Total


class Level(IntEnum):
    """How much the user must know something; the icon of a notice says it."""

    NOTE = 0
    WARNING = 1
    ERROR = 2


@dataclass(frozen=True)
class Notice:
    """What is wrong with an operation or to be known of it, as the user reads it."""

    level: Level
    text: str


@dataclass(frozen=True)
class Row:
    """One operation or one total, with what is read from the document as it is now.

    Attributes
    ----------
    found : OperationReport or Total
    label : str
        As it is now.
    notices : tuple of Notice
        The worst first.
    outdated : bool
        Whether the toolpath, the tool or the stock have changed since.
    posted : int
        How many operations the job has that are posted; 0 for an operation.
    rows : tuple of Row
        The operations of a job.
    """

    found: OperationReport | Total
    label: str
    notices: tuple[Notice, ...] = ()
    outdated: bool = False
    posted: int = 0
    rows: tuple[Row, ...] = ()

    @property
    def is_total(self) -> bool:
        return isinstance(self.found, Total)

    @property
    def name(self) -> str:
        """Internal name of the operation or the job."""
        return self.found.job if self.is_total else self.found.name

    @property
    def strategy(self) -> Strategy | None:
        return None if self.is_total else self.found.strategy

    @property
    def kind(self) -> str:
        """What it does: the name of the strategy; of a job how many operations its total has."""
        return in_total(self) if self.is_total else strategy_name(self.found.strategy)

    @property
    def machining_seconds(self) -> float | None:
        return self.found.machining_seconds if self.is_total else self.found.machining.seconds

    @property
    def machining_complete(self) -> bool:
        """Whether that is the time of all moves; else it is the least that they take."""
        return self.found.machining_complete if self.is_total else self.found.machining.complete

    @property
    def level(self) -> Level | None:
        return max((notice.level for notice in self.notices), default=None)


def rows_of(report: Report) -> list[Row]:
    """Return the jobs with their operations, then operations without a job, of a report on documents that are open."""
    below: dict[str | None, list[Row]] = {}
    for found in report.operations:
        below.setdefault(found.job, []).append(_operation(found))
    rows = [_job(total, below.get(total.job, [])) for total in report.totals]
    return rows + below.get(None, [])


def _operation(found: OperationReport) -> Row:
    obj = FreeCAD.getDocument(found.document).getObject(found.name)
    return Row(found, obj.Label, tuple(sorted(_notices(obj, found), key=lambda n: -n.level)), marks.is_outdated(obj))


def _job(total: Total, rows: list[Row]) -> Row:
    document = FreeCAD.getDocument(total.document)
    posted = Counter(o.job.Name for o in find(document) if o.counted and o.job is not None)[total.job]
    outdated = any(row.outdated for row in rows if row.found.counted)
    row = Row(total, document.getObject(total.job).Label, (), outdated, posted, tuple(rows))
    return replace(row, notices=tuple(_notices_of_total(row)))


def in_total(row: Row) -> str:
    """Return how many operations a job's total has, and of how many where it has not all."""
    count = row.found.operations
    if count < row.posted:
        return translate("Vk_Results", "{count} of {all} operations").format(count=count, all=row.posted)
    return plural(translate("Vk_Results", "{count} operation"), translate("Vk_Results", "{count} operations"), count)


def _notices_of_total(row: Row) -> Iterator[Notice]:
    if row.found.incomplete:
        yield Notice(Level.WARNING, translate("Vk_Results", "a lower bound: the cost of some operations is not known"))
    if row.found.operations < row.posted:
        text = translate("Vk_Results", "the total of what was analyzed, not of the whole job")
        yield Notice(Level.NOTE, text)


def _notices(obj, found: OperationReport) -> Iterator[Notice]:
    for remark in found.remarks:
        yield Notice(Level.WARNING if found.costs else Level.ERROR, said(remark))
    called = contradicted(obj, found.recognition)
    if called:
        text = translate("Vk_Results", "called {name}, but its toolpath is {strategy}")
        yield Notice(Level.WARNING, text.format(name=called, strategy=strategy_name(found.strategy)))
    for caution in found.cautions:
        yield Notice(Level.ERROR if caution.code == "legacy-hangs" else Level.WARNING, said(caution.what))
    if not found.counted and found.job is not None:
        text = translate("Vk_Results", "not in the total: a dress-up stands for it, or it is switched off")
        yield Notice(Level.NOTE, text)
