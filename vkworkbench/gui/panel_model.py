# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of the results panel: one row for each operation, one below for each job's total."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import FreeCAD

from vkworkbench import freecad
from vkworkbench.core import Strategy
from vkworkbench.core.simulators import Simulator, available
from vkworkbench.document import marks
from vkworkbench.document.intent import contradicted
from vkworkbench.gui.plain_text import as_html
from vkworkbench.gui.qt import QAbstractTableModel, QColor, QFont, QModelIndex, QSortFilterProxyModel, Qt
from vkworkbench.gui.sentences import said, strategy_name, user
from vkworkbench.gui.text import translate
from vkworkbench.language import ROUGH
from vkworkbench.report import OperationReport, Report, Total

VALUE = Qt.UserRole  # what a column is sorted by
_LEFT, _RIGHT = 0x81, 0x82  # with Qt.AlignVCenter; as numbers, which every PySide takes


@dataclass(frozen=True)
class Row:
    """One operation or one total, with what is read from the document as it is now.

    Attributes
    ----------
    found : OperationReport or Total
    label : str
        As it is now.
    remarks : tuple of str
        What is wrong, outdated or to be known, the worst first.
    """

    found: OperationReport | Total
    label: str
    remarks: tuple[str, ...]

    @property
    def name(self) -> str:
        """Internal name of the operation or the job."""
        return self.found.job if isinstance(self.found, Total) else self.found.name


def rows_of(report: Report) -> list[Row]:
    """Return the rows of a report on documents that are open."""
    rows: list[Row] = []
    for found in report.operations:
        obj = FreeCAD.getDocument(found.document).getObject(found.name)
        rows.append(Row(found, obj.Label, tuple(_remarks(obj, found))))
    for total in report.totals:
        text = translate("Vk_Results", "a lower bound: the cost of some operations is not known")
        rows.append(Row(total, _total_label(total), (text,) if total.incomplete else ()))
    return rows


def _total_label(total: Total) -> str:
    one = translate("Vk_Results", "{job}: {count} operation")
    more = translate("Vk_Results", "{job}: {count} operations")
    return (one if total.operations == 1 else more).format(job=total.label, count=total.operations)


def _remarks(obj, found: OperationReport):
    if marks.is_outdated(obj):
        yield translate("Vk_Results", "outdated: toolpath, tool or stock have changed since")
    yield from map(said, found.remarks)
    called = contradicted(obj, found.recognition)
    if called:
        text = translate("Vk_Results", "called {name}, but its toolpath is {strategy}")
        yield text.format(name=called, strategy=strategy_name(found.strategy))
    for caution in found.cautions:
        yield said(caution.what)
    if not found.counted and found.job is not None:
        yield translate("Vk_Results", "not in the total: a dress-up stands for it, or it is switched off")


@dataclass(frozen=True)
class Column:
    """One column: its title and explanation, how it is sorted and shown.

    Attributes
    ----------
    title, tooltip : str
    value : callable
        The number or text of a row, None where there is none.
    text : callable
        What the user reads of that value.
    factor : callable
        The true value of a row is between the value divided and multiplied by this factor.
    least : callable
        Whether the value of a row is a lower bound.
    """

    title: str
    tooltip: str
    value: Callable[[Row], object]
    text: Callable[[object], str] = str
    factor: Callable[[Row], float] = lambda row: 1.0
    least: Callable[[Row], bool] = lambda row: False


def columns(version: tuple[int, ...]) -> list[Column]:
    """Return the columns, with the simulators that a FreeCAD version has."""
    there_are = available(version)
    return [
        Column(translate("Vk_Results", "Operation"), "", lambda row: row.label),
        Column(translate("Vk_Results", "Strategy"),
               translate("Vk_Results", "The machining strategy recognized from the toolpath alone"),
               lambda row: getattr(row.found, "strategy", None), strategy_name),
        Column(translate("Vk_Results", "Sure"), translate("Vk_Results", "How sure the recognition is"),
               _confidence, _shown("share")),
        Column(translate("Vk_Results", "Trajectories"),
               translate("Vk_Results", "Number of straight moves, arcs chopped"),
               lambda row: row.found.trajectories, _shown("count")),
        Column(translate("Vk_Results", "Length"), translate("Vk_Results", "Length of the cutting moves"),
               lambda row: row.found.length, _shown("length")),
        Column(translate("Vk_Results", "Machining\ntime"),
               translate("Vk_Results", "Time on the machine at the programmed feeds; rapids where the tool "
                                       "controller says their speed"),
               _machining_seconds, _shown("time"), least=_machining_incomplete),
        *(column for simulator in there_are for column in _of_simulator(simulator)),
        *(_of_advice(simulator) for simulator in there_are if simulator.advice),
        Column(translate("Vk_Results", "Remarks"),
               translate("Vk_Results", "What is wrong with the operation, or will be with its simulation"),
               lambda row: "; ".join(row.remarks)),
    ]  # fmt: skip


def _shown(kind: str) -> Callable[[object], str]:
    """Return how the user reads numbers of a kind, by the name of the reader's method."""
    return lambda value: getattr(user(), kind)(value)


def _of_simulator(simulator: Simulator) -> tuple[Column, Column]:
    """Time and memory that a simulator takes for an operation, or for all of a job together."""
    name, text = simulator.name, partial(FreeCAD.Qt.translate, "Vk_Results")

    def seconds(row: Row) -> float | None:
        cost = row.found.cost(name)
        return cost and cost[0]

    def size(row: Row) -> float | None:
        cost = row.found.cost(name)
        return cost and cost[1]

    def factor(row: Row) -> float:
        return row.found.factor(name) if simulator.lessons else 1.0  # else no run makes it surer

    return (
        Column(text(simulator.time_title), text(simulator.time_tooltip), seconds, _shown("time"), factor),
        Column(text(simulator.memory_title), text(simulator.memory_tooltip), size, _shown("memory")),
    )  # fmt: skip


def _of_advice(simulator: Simulator) -> Column:
    """The finest setting of a simulator within the budgets; numbers of 0 where there is none."""
    advice, text = simulator.advice, partial(FreeCAD.Qt.translate, "Vk_Results")

    def numbers(row: Row) -> tuple[int, ...] | None:
        chosen = row.found.advice.get(simulator.name)
        return chosen and advice.numbers(chosen)

    return Column(text(advice.title), text(advice.tooltip), numbers,
                  lambda found: advice.form.format(*found) if all(found) else text(advice.none))  # fmt: skip


def _confidence(row: Row) -> float | None:
    strategy = getattr(row.found, "strategy", Strategy.EMPTY)
    return row.found.confidence if strategy.is_answer else None


def _machining_seconds(row: Row) -> float | None:
    found = row.found
    return found.machining_seconds if isinstance(found, Total) else found.machining.seconds


def _machining_incomplete(row: Row) -> bool:
    found = row.found
    return not (found.machining_complete if isinstance(found, Total) else found.machining.complete)


class ResultsModel(QAbstractTableModel):
    """The rows of the panel as Qt asks for them."""

    def __init__(self, parent=None) -> None:
        super().__init__(parent)
        self.columns = columns(freecad.version())
        self.rows: list[Row] = []

    def show(self, rows: list[Row]) -> None:
        self.beginResetModel()
        self.rows = rows
        self.endResetModel()

    def rowCount(self, parent=QModelIndex()) -> int:  # noqa: B008, Qt's own default
        return 0 if parent.isValid() else len(self.rows)

    def columnCount(self, parent=QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(self.columns)

    def headerData(self, section: int, orientation, role=Qt.DisplayRole):
        if orientation != Qt.Horizontal:
            return None
        column = self.columns[section]
        return {Qt.DisplayRole: column.title, Qt.ToolTipRole: column.tooltip}.get(role)

    def data(self, index, role=Qt.DisplayRole):
        row, column = self.rows[index.row()], self.columns[index.column()]
        value = column.value(row)
        if role == VALUE:
            return value
        if role in (Qt.DisplayRole, Qt.ToolTipRole):
            if role == Qt.ToolTipRole and index.column() == len(self.columns) - 1:
                return as_html("\n".join(row.remarks))
            if value is None:
                return ""
            factor = column.factor(row)
            if role == Qt.DisplayRole:
                return ("≥ " if column.least(row) else "") + user().about(column.text(value), factor)
            if factor < ROUGH:
                return as_html(column.text(value))
            text = translate("Vk_Results", "Between {} and {}: not measured on this computer yet")
            return as_html(text.format(column.text(value / factor), column.text(value * factor)))
        if role == Qt.TextAlignmentRole:
            right = value is not None and not isinstance(value, str)
            return _RIGHT if right else _LEFT
        if role == Qt.DecorationRole and isinstance(value, Strategy):
            return QColor(value.color)
        if role == Qt.FontRole and isinstance(row.found, Total):
            font = QFont()
            font.setBold(True)
            return font
        return None


class ResultsOrder(QSortFilterProxyModel):
    """Sorts operations by numbers and names; totals stay below, empty cells last."""

    def lessThan(self, left, right) -> bool:
        return self._key(left) < self._key(right)

    def _key(self, index) -> tuple:
        model = self.sourceModel()
        row = model.rows[index.row()]
        value = model.columns[index.column()].value(row)
        # Qt reverses a descending order; what has to stay below must then come first.
        below = [isinstance(row.found, Total), value is None]
        if self.sortOrder() != Qt.AscendingOrder:
            below = [not flag for flag in below]
        return (*below, value.casefold() if isinstance(value, str) else value if value is not None else 0)
