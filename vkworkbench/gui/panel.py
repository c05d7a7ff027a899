# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results panel: a dock with the table of operations, the findings on the selected one in words, exports."""

from __future__ import annotations

from html import escape
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui

from vkworkbench.core import Machining
from vkworkbench.core.simulators import SIMULATORS
from vkworkbench.gui import docks, latest
from vkworkbench.gui.panel_model import VALUE, ResultsModel, ResultsOrder, Row, rows_of
from vkworkbench.gui.plain_text import warn
from vkworkbench.gui.qt import (
    QAbstractItemView,
    QApplication,
    QDockWidget,
    QFileDialog,
    QHBoxLayout,
    QHeaderView,
    QItemSelectionModel,
    QLabel,
    QPushButton,
    Qt,
    QTableView,
    QTimer,
    QVBoxLayout,
    QWidget,
)  # fmt: skip
from vkworkbench.gui.sentences import said, strategy_name, user
from vkworkbench.gui.text import translate
from vkworkbench.report import Total, plain_text

_WIDEST_LABEL = 260  # px; the tooltip shows the end of a longer one


class ResultsDock(QDockWidget):
    """Shows what was found in the active document; a selection in its table is one in FreeCAD, and the reverse."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(translate("Vk_Results", "Toolpath results"), parent)
        self.setObjectName(docks.RESULTS)
        self._report = latest.report_of(None)
        self._following = False  # whether the table is being moved by FreeCAD's selection
        self._stale = self._timer(self.refresh)
        self._selected = self._timer(self._follow)

        self.model = ResultsModel(self)
        self.order = ResultsOrder(self)
        self.order.setSourceModel(self.model)
        self.order.setSortRole(VALUE)
        self.table = QTableView()
        self.table.setModel(self.order)
        self.table.setSortingEnabled(True)
        self.table.sortByColumn(-1, Qt.AscendingOrder)  # as posted, until the user sorts
        self.table.setSelectionBehavior(QAbstractItemView.SelectRows)
        self.table.setAlternatingRowColors(True)
        self.table.setWordWrap(False)
        self.table.verticalHeader().hide()
        self.table.verticalHeader().setSectionResizeMode(QHeaderView.Fixed)
        self.table.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 6)
        self.table.selectionModel().selectionChanged.connect(self._select)
        self.table.doubleClicked.connect(lambda index: Gui.SendMsgToActiveView("ViewSelection"))

        self.details = QLabel()
        self.details.setWordWrap(True)
        self.details.setTextInteractionFlags(Qt.TextSelectableByMouse)
        self.csv = self._button(translate("Vk_Results", "Export CSV…"), lambda: self._export("csv"),
                                translate("Vk_Results", "Saves all numbers as a table for a spreadsheet."))  # fmt: skip
        self.json = self._button(translate("Vk_Results", "Export JSON…"), lambda: self._export("json"),
                                 translate("Vk_Results", "Saves all numbers for a program."))  # fmt: skip
        self.copy = self._button(translate("Vk_Results", "Copy to clipboard"), self._copy,
                                 translate("Vk_Results", "Copies the table as it stands here."))  # fmt: skip

        body = QWidget()
        column = QVBoxLayout(body)
        column.addWidget(self.table, 1)
        below = QHBoxLayout()
        below.addWidget(self.details, 1)
        buttons = QVBoxLayout()
        for button in (self.csv, self.json, self.copy):
            buttons.addWidget(button)
        buttons.addStretch()
        below.addLayout(buttons)
        column.addLayout(below)
        self.setWidget(body)

        Gui.Selection.addObserver(self)
        FreeCAD.addDocumentObserver(self)
        self.visibilityChanged.connect(lambda visible: self._stale.start(0))
        self.refresh()

    def _timer(self, work) -> QTimer:
        """Return a timer that does the work once for many changes, as soon as FreeCAD is done with them."""
        timer = QTimer(self)
        timer.setSingleShot(True)
        timer.timeout.connect(work)
        return timer

    @staticmethod
    def _button(text: str, work, tooltip: str) -> QPushButton:
        button = QPushButton(text)
        button.setToolTip(tooltip)
        button.clicked.connect(work)
        return button

    # FreeCAD calls these when the selection changes.

    def addSelection(self, *what) -> None:
        self._selected.start(0)

    def setSelection(self, *what) -> None:
        self._selected.start(0)

    def removeSelection(self, *what) -> None:
        self._selected.start(0)

    def clearSelection(self, *what) -> None:
        self._selected.start(0)

    # FreeCAD calls these when documents change.

    def slotChangedObject(self, obj, name: str) -> None:
        if name in ("Label", "Label2", "Group"):
            self._stale.start(0)

    def slotDeletedObject(self, obj) -> None:
        self._stale.start(0)

    def slotActivateDocument(self, document) -> None:
        self._stale.start(0)

    def slotDeletedDocument(self, document) -> None:
        latest.forget(document.Name)
        self._stale.start(0)

    def refresh(self) -> None:
        """Show what is known of the active document now."""
        if not self.isVisible():
            return
        document = FreeCAD.ActiveDocument
        self._report = latest.report_of(document)
        self._following = True
        self.model.show(rows_of(self._report))
        self._following = False
        header = self.table.horizontalHeader()
        header.setStretchLastSection(False)
        self.table.resizeColumnsToContents()
        self.table.setColumnWidth(0, min(self.table.columnWidth(0), _WIDEST_LABEL))
        # Where the table has no room to spare, stretching would make the last column narrower.
        header.setStretchLastSection(header.length() < self.table.viewport().width())
        for button in (self.csv, self.json, self.copy):
            button.setEnabled(bool(self._report.operations))
        self._follow()

    def _follow(self) -> None:
        """Select the rows of what is selected in FreeCAD."""
        if not self.isVisible():
            return
        names = {obj.Name for obj in Gui.Selection.getSelection()}
        self._following = True
        self.table.clearSelection()
        for number in range(self.order.rowCount()):
            if self._row(number).name in names:
                index = self.order.index(number, 0)
                rows = QItemSelectionModel.Select | QItemSelectionModel.Rows
                self.table.selectionModel().select(index, rows)
                self.table.scrollTo(index)
        self._following = False
        self._explain()

    def _select(self) -> None:
        """Select in FreeCAD what is selected in the table, and show it in the tree."""
        if self._following:
            return
        document = FreeCAD.ActiveDocument.Name
        Gui.Selection.clearSelection()
        for row in self._selected_rows():
            Gui.Selection.addSelection(document, row.name)
        Gui.runCommand("Std_TreeSelection")
        self._explain()

    def _row(self, number: int) -> Row:
        return self.model.rows[self.order.mapToSource(self.order.index(number, 0)).row()]

    def _selected_rows(self) -> list[Row]:
        return [self._row(index.row()) for index in self.table.selectionModel().selectedRows()]

    def _explain(self) -> None:
        """Say in words what was found of the selected operation."""
        rows = self._selected_rows()
        if not self.model.rows:
            text = translate("Vk_Results", "Nothing is analyzed yet in this document: click Analyze toolpaths.")
        elif len(rows) != 1:
            text = translate("Vk_Results", "Select an operation to read why it has its strategy.")
        else:
            text = _in_words(rows[0])
        self.details.setText(text)

    def _export(self, ending: str) -> None:
        document = FreeCAD.ActiveDocument
        folder = Path(document.FileName).parent if document.FileName else Path.home()
        title, filter_ = {
            "csv": (translate("Vk_Results", "Export CSV"), "CSV (*.csv)"),
            "json": (translate("Vk_Results", "Export JSON"), "JSON (*.json)"),
        }[ending]
        path, _ = QFileDialog.getSaveFileName(self, title, str(folder / f"{document.Name}.{ending}"), filter_)
        if not path:
            return
        if not Path(path).suffix:
            path += f".{ending}"
        try:
            self._report.to_csv(path) if ending == "csv" else self._report.to_json(path)
        except OSError as error:
            warn(title, str(error), self)

    def _copy(self) -> None:
        """Copy the table as tabulated text, in the order and with the units that are shown."""
        columns = self.model.columns
        lines = [[column.title.replace("\n", " ") for column in columns]]
        lines += [
            [
                " ".join(plain_text(self.order.index(row, column).data()).split())
                for column in range(len(columns))
            ]
            for row in range(self.order.rowCount())
        ]
        QApplication.clipboard().setText("\n".join("\t".join(line) for line in lines) + "\n")


def _in_words(row: Row) -> str:
    found = row.found
    lines = []
    if isinstance(found, Total):
        lines.append(f"<b>{escape(row.label)}</b>")
    else:
        strategy, reason = strategy_name(found.strategy), said(found.recognition.why)
        lines.append(f"<b>{escape(row.label)}, {escape(strategy)}</b>: {escape(reason)}")
        lines.append(escape(_machining_in_words(found.machining)))
    for simulator in SIMULATORS:
        chosen = found.advice.get(simulator.name)
        if chosen is not None:
            text = FreeCAD.Qt.translate("Vk_Results", simulator.advice.sentence)
            lines.append(escape(text.format(said(chosen.why))))
    lines += [f"• {escape(remark)}" for remark in row.remarks]
    return "<br>".join(lines)


def _machining_in_words(machining: Machining) -> str:
    length = user().length
    cut, rapid = length(machining.cutting_length), length(machining.rapid_length)
    text = translate("Vk_Results", "Machining: {cut} of cutting, {rapid} of rapids").format(cut=cut, rapid=rapid)
    if machining.depth is not None:
        text += translate("Vk_Results", ", {depth} deep").format(depth=length(machining.depth))
    return "; ".join([text, *map(said, machining.left_out)])
