# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of the results panel: jobs with their totals, and the operations of each job, each row with notices."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, replace

from vkworkbench import preferences
from vkworkbench.core import Strategy
from vkworkbench.document.job.operations import cycle_seconds, find, fixtures_of
from vkworkbench.document.marks import marks
from vkworkbench.document.marks.record import Record, of_total
from vkworkbench.document.simulation.faults import read_with_faults
from vkworkbench.gui.qt.sentences import plural, sentence
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.results.findings import Finding
from vkworkbench.gui.tree.notices import Level, Notice, kind_of, notices_of
from vkworkbench.language import Message
from vkworkbench.preferences import Preferences
from vkworkbench.report import OperationReport, Total, is_switched_off, total_of

_SIMILAR = 1.5  # a note explains FreeCAD's CycleTime if it differs from the machining time by a larger factor


@dataclass(frozen=True)
class Row:
    """One operation, or the total of one job."""

    # The numbers of the row; a record from the mark if the operation was not analysed in this session.
    found: OperationReport | Record | Total
    # name, label: internal name of the operation or job, and its current label.
    name: str
    label: str
    notices: tuple[Notice, ...] = ()  # errors, warnings and notes, the most severe first
    outdated: bool = False  # whether toolpath, tool or stock have changed since the analysis
    mark: Record | None = None  # the mark of an operation; None for a total
    posted: int = 0  # number of operations that the job posts; 0 for the row of an operation
    rows: tuple[Row, ...] = ()  # the operations of a job
    is_counted: bool = True  # whether an operation counts in its job's total

    @property
    def is_total(self) -> bool:
        return isinstance(self.found, Total)

    @property
    def strategy(self) -> Strategy | None:
        return None if self.is_total else self.found.strategy

    @property
    def kind(self) -> str:
        """The name of the strategy, or "switched off"; for a job, the number of operations in its total."""
        return in_total(self) if self.is_total else kind_of(self.found)

    @property
    def machining_complete(self) -> bool:
        """Whether the machining time includes all moves.

        If the result is False, the machining time is a lower bound.
        """
        return self.found.machining_complete if self.is_total else not self.found.left_out

    @property
    def level(self) -> Level:
        return max((notice.level for notice in self.notices), default=Level.NOTE)

    def texts(self, *, warned: bool) -> list[str]:
        """Return the texts of the warnings and errors (`warned`), which have a sign in the tree, or of the notes."""
        return [notice.text for notice in self.notices if (notice.level > Level.NOTE) == warned]

    @property
    def is_warned(self) -> bool:
        """Whether the row has a warning or an error, for which its mark has a sign in the tree."""
        return self.level > Level.NOTE


def rows_of(findings: Iterable[Finding]) -> list[Row]:
    """Return a row for each job, with its operations, then a row for each operation without a job."""
    jobs, below = {}, {}
    for finding in findings:
        job = finding.operation.job
        if job is not None:
            jobs[job.Name] = job
        below.setdefault(job and job.Name, []).append(finding)
    chosen = preferences.read()
    alone = [_operation(finding, chosen) for finding in below.get(None, [])]
    return [_job(job, below[name], chosen) for name, job in jobs.items()] + alone


def _operation(finding: Finding, chosen: Preferences) -> Row:
    obj, notices = finding.operation.object, notices_of(finding.mark, chosen)
    if not finding.operation.counted and finding.operation.job is not None and not is_switched_off(finding.mark):
        dressed = translate("Vk_Results", "This operation is not included in the total, because its dress-up is.")
        inactive = translate("Vk_Results", "This operation is not included in the total, because it is switched off.")
        notices.append(Notice(Level.NOTE, dressed if finding.operation.active else inactive))
    found = finding.report or finding.mark
    counted = finding.operation.counted
    return Row(found, obj.Name, obj.Label, tuple(notices), finding.mark.outdated, finding.mark, is_counted=counted)


def _job(job, findings: list[Finding], chosen: Preferences) -> Row:
    counted = [finding for finding in findings if finding.operation.counted]
    # Advice on the settings of simulators needs full reports, because marks in the tree do not store all numbers.
    budget = None if any(finding.report is None for finding in counted) else chosen.budget
    numbers = [finding.report or finding.mark for finding in counted]
    total = total_of(job.Document.Name, job.Name, job.Label, numbers, budget, fixtures_of(job))
    posted = Counter(o.job.Name for o in find(job.Document) if o.counted and o.job is not None)[job.Name]
    if budget is None and len(counted) == posted:
        mark = marks.read_total(job)  # this mark has the costs that the last analysis computed from full reports
        total = replace(total, costs={**total.costs, **mark.costs}) if mark else total
    outdated = marks.is_outdated(job) or any(finding.mark.outdated for finding in counted)
    # Build the record of the total as for the job's mark, but without computing costs in simulators that are not shown.
    of_parts, own = of_total(replace(total, costs={}), [f.mark for f in counted], ""), read_with_faults(job)
    record = replace(of_parts, costs=total.costs, verdict=own and own.verdict)
    notices = notices_of(record, chosen)
    theirs = cycle_seconds(job)
    if len(counted) == posted and theirs and _differ(theirs, total.machining_seconds / total.fixtures):
        notices.append(Notice(Level.NOTE, sentence(Message("cycle-time", seconds=theirs))))
    if total.operations < posted:
        text = translate("Vk_Results", "This total covers the analyzed operations only.")
        notices.append(Notice(Level.NOTE, text))
    rows = tuple(_operation(finding, chosen) for finding in findings)
    return Row(total, job.Name, job.Label, tuple(notices), outdated, posted=posted, rows=rows)


def _differ(theirs: float, ours: float) -> bool:
    return not 1 / _SIMILAR < ours / theirs < _SIMILAR


def in_total(row: Row) -> str:
    """Return how many operations a job's total includes, and for how many work offsets.

    Examples: "2 of 3 operations"; "3 operations x2" for two work offsets.
    """
    count, times = row.found.operations, f" x{row.found.fixtures}" if row.found.fixtures > 1 else ""
    if count < row.posted:
        return translate("Vk_Results", "{count} of {all} operations").format(count=count, all=row.posted) + times
    one, more = translate("Vk_Results", "{count} operation"), translate("Vk_Results", "{count} operations")
    return plural(one, more, count) + times
