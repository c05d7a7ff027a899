# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt models of the results panel: a tree of jobs and operations, and a model that sorts and filters the tree."""

from __future__ import annotations

from functools import lru_cache

from vkworkbench import freecad, preferences
from vkworkbench.gui.qt.names import (
    QAbstractItemModel,
    QApplication,
    QColor,
    QFont,
    QIcon,
    QModelIndex,
    QPixmap,
    QSortFilterProxyModel,
    QStyle,
    Qt,
)  # fmt: skip
from vkworkbench.gui.qt.plain_text import as_html
from vkworkbench.gui.results.columns import NOTES, OPERATION, STRATEGY, WARNINGS, columns
from vkworkbench.gui.results.rows import Row
from vkworkbench.gui.tree.notices import Level

VALUE = Qt.UserRole  # role of the value by which a column is sorted
_LEFT, _RIGHT = 0x81, 0x82  # alignment with Qt.AlignVCenter; as numbers, because some PySide versions refuse flags
_SWATCH = 12  # side of the square in the colour of a strategy, px
_ICONS = {Level.WARNING: QStyle.SP_MessageBoxWarning, Level.ERROR: QStyle.SP_MessageBoxCritical}


class ResultsModel(QAbstractItemModel):
    """The tree of jobs and operations.

    The internal id of an index is 0 for a row at the top (a job), and 1 + the number of its job for an operation.
    """

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
        """Create the columns for the current preferences. The number of columns and their keys never change."""
        self.first, self.others = columns(freecad.version(), preferences.read().simulator)
        self.columns = [*self.first, *self.others]

    def row(self, index) -> Row:
        """Return the job or operation (`Row`) that a Qt index points to."""
        branch = index.internalId()
        return self.rows[branch - 1].rows[index.row()] if branch else self.rows[index.row()]

    def index(self, row: int, column: int, parent=QModelIndex()):  # noqa: B008 - Qt's default
        # This check is faster than Qt's `hasIndex`, which calls rowCount() and columnCount() in Python for every cell.
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
        # Screen readers cannot read the warning icon, so they get the text of the first notice.
        if role == Qt.AccessibleTextRole and column.key == OPERATION and row.is_warned:
            return f"{row.label}: {row.notices[0].text}"
        if role == Qt.TextAlignmentRole:
            value = column.value(row)
            return _LEFT if value is None or isinstance(value, str) else _RIGHT
        if role == Qt.DecorationRole and column.key == STRATEGY and row.strategy is not None:
            return _swatch(row.strategy.color)
        if role == Qt.DecorationRole and column.key == OPERATION and row.is_warned:
            return QApplication.style().standardIcon(_ICONS[row.level])
        if role == Qt.FontRole and row.is_total:
            font = QFont()
            font.setBold(True)
            return font
        return None


@lru_cache(None)
def _swatch(color: str) -> QIcon:
    """Return an icon that is a square of one colour. The colour does not change in a selected row."""
    square = QPixmap(_SWATCH, _SWATCH)
    square.fill(QColor(color))
    icon = QIcon(square)
    icon.addPixmap(square, QIcon.Selected)
    return icon


def _tooltip(row: Row, column) -> str:
    if column.key in (WARNINGS, NOTES):
        return "\n".join(row.texts(warned=column.key == WARNINGS))
    return column.remark(row) or column.text(row)


class ResultsOrder(QSortFilterProxyModel):
    """Sorts the operations of each job, with empty cells at the end, and hides rows that do not match the filter."""

    def __init__(self, parent=None) -> None:
        super().__init__(parent)
        self._text, self._strategy, self._warned = "", None, False

    def choose(self, text: str, strategy, warned: bool) -> None:
        """Show only operations whose name, strategy or warnings contain `text`, with this strategy unless it is None.

        If `warned` is True, show only operations that have warnings or are outdated.
        """
        self._text, self._strategy, self._warned = text.casefold(), strategy, warned
        self.invalidateFilter()

    def row(self, index) -> Row:
        """Return the job or operation (`Row`) that a Qt index points to."""
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
        # For a descending order Qt reverses the rows, so empty cells must come first here to be at the bottom.
        empty = (value is None) == (self.sortOrder() == Qt.AscendingOrder)
        return empty, value.casefold() if isinstance(value, str) else value if value is not None else 0
