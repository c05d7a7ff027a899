# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results as Qt asks for them: a tree of jobs and operations, and its order and filter."""

from __future__ import annotations

from vkworkbench import freecad, preferences
from vkworkbench.gui.qt.names import (
    QAbstractItemModel,
    QApplication,
    QColor,
    QFont,
    QModelIndex,
    QSortFilterProxyModel,
    QStyle,
    Qt,
)  # fmt: skip
from vkworkbench.gui.qt.plain_text import as_html
from vkworkbench.gui.results.columns import OPERATION, STRATEGY, WARNINGS, columns
from vkworkbench.gui.results.rows import Row
from vkworkbench.gui.tree.notices import Level

VALUE = Qt.UserRole  # what a column is sorted by
_LEFT, _RIGHT = 0x81, 0x82  # with Qt.AlignVCenter; as numbers, which every PySide takes
_ICONS = {
    Level.WARNING: QStyle.SP_MessageBoxWarning,
    Level.ERROR: QStyle.SP_MessageBoxCritical,
}


class ResultsModel(QAbstractItemModel):
    """The rows of the results; an index carries 0 for a branch, else one more than the number of its branch."""

    def __init__(self, parent=None) -> None:
        super().__init__(parent)
        self.rows: list[Row] = []
        self._choose_columns()

    def show(self, rows: list[Row]) -> None:
        self.beginResetModel()
        self.rows = rows
        self._choose_columns()
        self.endResetModel()

    def _choose_columns(self) -> None:
        """Take the columns as the preferences are now; there are always as many, with the same keys."""
        self.first, self.others = columns(freecad.version(), preferences.read().simulator)
        self.columns = [*self.first, *self.others]

    def row(self, index) -> Row:
        """Return the row of an index."""
        branch = index.internalId()
        return self.rows[branch - 1].rows[index.row()] if branch else self.rows[index.row()]

    def index(self, row: int, column: int, parent=QModelIndex()):  # noqa: B008, Qt's own default
        # Qt's own `hasIndex` would ask for both counts through Python, for every cell that is measured.
        if not (0 <= row < self.rowCount(parent) and 0 <= column < len(self.columns)):
            return QModelIndex()
        return self.createIndex(row, column, parent.row() + 1 if parent.isValid() else 0)

    def parent(self, index=None):
        if index is None:
            return super().parent()
        branch = index.internalId() if index.isValid() else 0
        return self.createIndex(branch - 1, 0, 0) if branch else QModelIndex()

    def rowCount(self, parent=QModelIndex()) -> int:  # noqa: B008
        if not parent.isValid():
            return len(self.rows)
        return 0 if parent.internalId() or parent.column() else len(self.rows[parent.row()].rows)

    def columnCount(self, parent=QModelIndex()) -> int:  # noqa: B008
        return len(self.columns)

    def headerData(self, section: int, orientation, role=Qt.DisplayRole):
        if orientation != Qt.Horizontal:
            return None
        column = self.columns[section]
        return {Qt.DisplayRole: column.title, Qt.ToolTipRole: column.tooltip}.get(role)

    def data(self, index, role=Qt.DisplayRole):
        row, column = self.row(index), self.columns[index.column()]
        if role == Qt.DisplayRole:
            return column.text(row)
        if role == Qt.ToolTipRole:
            return as_html(_tooltip(row, column))
        if role == VALUE:
            return column.value(row)
        if role == Qt.TextAlignmentRole:
            value = column.value(row)
            return _LEFT if value is None or isinstance(value, str) else _RIGHT
        if role == Qt.DecorationRole and column.key == STRATEGY and row.strategy is not None:
            return QColor(row.strategy.color)
        if role == Qt.DecorationRole and column.key == OPERATION and row.is_warned:
            return QApplication.style().standardIcon(_ICONS[row.level])
        if role == Qt.FontRole and row.is_total:
            font = QFont()
            font.setBold(True)
            return font
        return None


def _tooltip(row: Row, column) -> str:
    if column.key == WARNINGS:
        return "\n".join(notice.text for notice in row.notices)
    return column.range(row) or column.text(row)


class ResultsOrder(QSortFilterProxyModel):
    """Sorts within each job, empty cells last, and leaves out what the user filters away."""

    def __init__(self, parent=None) -> None:
        super().__init__(parent)
        self._text, self._strategy, self._warned = "", None, False

    def choose(self, text: str, strategy, warned: bool) -> None:
        """Show the operations that have a text in their name, strategy or warnings, a strategy, and warnings if asked."""
        self._text, self._strategy, self._warned = text.casefold(), strategy, warned
        self.invalidateFilter()

    def row(self, index) -> Row:
        """Return the row of an index."""
        return self.sourceModel().row(self.mapToSource(index))

    def filterAcceptsRow(self, number: int, parent) -> bool:
        model = self.sourceModel()
        row = model.row(model.index(number, 0, parent))
        return self._accepts(row) or any(map(self._accepts, row.rows))

    def _accepts(self, row: Row) -> bool:
        words = " ".join([row.label, row.kind, *(notice.text for notice in row.notices)])
        return (
            self._text in words.casefold()
            and self._strategy in (None, row.strategy)
            and (not self._warned or row.outdated or row.is_warned)
        )

    def lessThan(self, left, right) -> bool:
        return self._key(left) < self._key(right)

    def _key(self, index) -> tuple:
        model = self.sourceModel()
        column = model.columns[index.column()]
        value = column.value(model.row(index))
        # Qt reverses a descending order; what has to stay below must then come first.
        empty = (value is None) == (self.sortOrder() == Qt.AscendingOrder)
        return empty, value.casefold() if isinstance(value, str) else value if value is not None else 0
