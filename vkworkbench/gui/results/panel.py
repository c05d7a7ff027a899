# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results panel: a dock with a tree of jobs and operations, a filter, and details of the selected row."""

from __future__ import annotations

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import preferences
from vkworkbench.document.job import results
from vkworkbench.document.marks.properties import MARK
from vkworkbench.gui.qt import colors, docks, progress
from vkworkbench.gui.qt.colors import readable
from vkworkbench.gui.qt.language_change import LanguageChange
from vkworkbench.gui.qt.names import (
    QAction,
    QApplication,
    QColor,
    QDockWidget,
    QItemSelectionModel,
    QMenu,
    QSplitter,
    Qt,
    QTextBrowser,
    QVBoxLayout,
    QWidget,
    single_shot,
)  # fmt: skip
from vkworkbench.gui.qt.plain_text import lines, unbroken
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.results import findings
from vkworkbench.gui.results.columns import NOTES, STATE
from vkworkbench.gui.results.details import GAUSS_MAP, MEASURED, page
from vkworkbench.gui.results.export import as_text, save
from vkworkbench.gui.results.filter import Filter
from vkworkbench.gui.results.frozen_tree import FrozenTree
from vkworkbench.gui.results.measured import analyze_again, learn
from vkworkbench.gui.results.model import VALUE, ResultsModel, ResultsOrder
from vkworkbench.gui.results.rows import Row, rows_of
from vkworkbench.report import Cancelled, is_switched_off

# Maximum widths of columns, px; tooltips show texts in full that do not fit.
_MAX_WIDTH = {"operation": 260, "warnings": 420, "notes": 420}
_MIN_LINES = 3  # minimum height of tree and details, in lines of text


class ResultsDock(QDockWidget):
    """Shows the results of the active document. Selecting a row selects its object in FreeCAD, and vice versa."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName(docks.RESULTS)
        self._findings: list[findings.Finding] = []
        self._following = False  # whether this class, not the user, changes the rows and selection
        self._opened: set[str] = set()  # targets of the links in the details that the user has opened, such as "Why?"
        self._stale = single_shot(self.refresh, self)
        self._selected = single_shot(self._follow, self)
        self._build()
        self._language = LanguageChange(self._translate, self)

        Gui.Selection.addObserver(self)
        FreeCAD.addDocumentObserver(self)
        preferences.observe(lambda name: self._stale.start())
        self.visibilityChanged.connect(lambda visible: self._stale.start())

    def _build(self) -> None:
        """Make the contents of the dock, in FreeCAD's language."""
        self.setWindowTitle(translate("Vk_Results", "Toolpath Results"))
        self.model = ResultsModel(self)
        self.order = ResultsOrder(self)
        self.order.setSourceModel(self.model)
        self.order.setSortRole(VALUE)
        self.tree = FrozenTree(self.order, copy=self._copy, enter=self._look_at)
        self.tree.setSortingEnabled(True)
        self.tree.sortByColumn(-1, Qt.AscendingOrder)  # keep the order of posting until the user sorts by a column
        self.tree.selectionModel().selectionChanged.connect(self._select)
        self.tree.show_menus(of_titles=lambda: self.columns, of_rows=lambda: self.row_menu)
        self.tree.setAccessibleName(translate("Vk_Results", "Jobs and Operations"))

        self.details = QTextBrowser()
        self.details.setOpenLinks(False)
        self.details.setAccessibleName(translate("Vk_Results", "Details of the Selected Operation"))
        self.details.anchorClicked.connect(lambda url: self._open(url.toString()))
        self.csv = self._action(translate("Vk_Results", "Export &CSV…"), lambda: self._export("csv"))
        self.json = self._action(translate("Vk_Results", "Export &JSON…"), lambda: self._export("json"))
        self.copy = self._action(translate("Vk_Results", "C&opy to Clipboard"), self._copy)
        self._choices: list[QAction] = []  # actions that show or hide the columns, except the first column
        self.columns = self._columns_menu()
        self._show_columns()
        self.export = QMenu(translate("Vk_Results", "E&xport"), self)
        self.export.addActions([self.csv, self.json, self.copy])

        self.row_menu = self._menu_of_rows()

        self.filter = Filter([self.columns, self.export])
        self.filter.changed = self._filter
        self._parts = QSplitter(Qt.Horizontal)
        self._parts.addWidget(self.tree)
        self._parts.addWidget(self.details)
        # With Qt's default minimum height, FreeCAD's window would not fit on a low screen. The minimum is set here and
        # not on the tree and the details, because themes reset the minimum heights of these two widgets.
        self._parts.setMinimumHeight(_MIN_LINES * self.tree.fontMetrics().height())
        self._parts.setStretchFactor(0, 3)
        self._parts.setStretchFactor(1, 2)
        body = QWidget()
        column = QVBoxLayout(body)
        column.setContentsMargins(4, 2, 4, 2)
        column.addWidget(self.filter)
        column.addWidget(self._parts, 1)
        self.setWidget(body)
        self.setFocusProxy(self.tree)

    def _translate(self) -> None:
        """Make the contents of the dock again, in FreeCAD's new language."""
        before = self.widget(), self.order, self.model
        self._build()
        for old in before:
            old.deleteLater()
        self.refresh_soon()

    def _action(self, text: str, work) -> QAction:
        action = QAction(text, self)
        action.triggered.connect(lambda checked=False: work())
        return action

    def _menu_of_rows(self) -> QMenu:
        """Return the context menu of the tree's rows.

        The commands in the menu act on FreeCAD's selection, which contains the objects of the selected rows.
        """
        menu = QMenu(self)
        for name in ("Vk_Analyze", "Vk_Clear", "Vk_GaussMap", "Vk_Simulate"):
            menu.addActions(Gui.Command.get(name).getAction())
        menu.addSeparator()
        menu.addAction(self.copy)
        return menu

    def _columns_menu(self) -> QMenu:
        """Return the menu in which the user chooses the columns and restores the order of posting."""
        menu = QMenu(translate("Vk_Results", "Col&umns"), self)
        chosen = preferences.read().result_columns.split(",")
        for column in self.model.columns[1:]:
            action = menu.addAction(column.name)
            action.setCheckable(True)
            action.setToolTip(column.tooltip)
            action.setChecked((column in self.model.first) != (column.key in chosen))
            action.toggled.connect(lambda on: self._keep_columns())
            self._choices.append(action)
        menu.addSeparator()
        as_posted = menu.addAction(translate("Vk_Results", "Sort as &Posted"))
        as_posted.triggered.connect(lambda checked=False: self.tree.sortByColumn(-1, Qt.AscendingOrder))
        return menu

    def _keep_columns(self) -> None:
        self._show_columns()
        choices = zip(self.model.columns[1:], self._choices)
        changed = [column.key for column, action in choices if (column in self.model.first) != action.isChecked()]
        preferences.write(result_columns=",".join(changed))

    def _show_columns(self) -> None:
        """Show the chosen columns. The columns "State" and "Notes" are shown only if a row has a text in them."""
        rows = [row for job in self.model.rows for row in (job, *job.rows)]
        for number, action in enumerate(self._choices, 1):
            column = self.model.columns[number]
            needed = column.key not in (STATE, NOTES) or any(map(column.value, rows))
            self.tree.setColumnHidden(number, not (action.isChecked() and needed))
        self._fit_columns()

    def _fit_columns(self) -> None:
        for number, column in enumerate(self.model.columns):
            if self.tree.isColumnHidden(number):  # computing a hidden column's simulation costs could take long
                continue
            self.tree.resizeColumnToContents(number)
            self.tree.setColumnWidth(number, min(self.tree.columnWidth(number), _MAX_WIDTH.get(column.key, 1000)))

    def resizeEvent(self, event) -> None:
        """Put the details below the tree if the dock is higher than wide."""
        self._parts.setOrientation(Qt.Horizontal if self.width() > self.height() else Qt.Vertical)
        super().resizeEvent(event)

    # FreeCAD calls the following methods when its selection changes.

    def addSelection(self, *what) -> None:
        self._selected.start()

    setSelection = removeSelection = clearSelection = addSelection

    # FreeCAD calls the following methods when documents change.

    def slotChangedObject(self, obj, name: str) -> None:
        if name in ("Label", "Label2", "Group", MARK):
            self._stale.start()

    def slotActivateDocument(self, document) -> None:
        self._stale.start()

    slotDeletedObject = slotDeletedDocument = slotActivateDocument

    def refresh_soon(self) -> None:
        """Show the results of the active document after Qt's pending events."""
        self._stale.start()

    def refresh(self) -> None:
        """Show the results of the active document now."""
        if not self.isVisible():
            return
        self._findings = findings.read_findings(FreeCAD.ActiveDocument)
        closed = {row.name for index, row in self._indexes() if row.rows and not self.tree.isExpanded(index)}
        self._following = True
        self.model.show(rows_of(self._findings))
        self.tree.expandAll()
        for index, row in self._indexes():
            self.tree.setExpanded(index, row.name not in closed)
        self._following = False
        operations = (row for _, row in self._indexes() if not row.is_total and not is_switched_off(row.found))
        self.filter.offer({row.strategy for row in operations})
        self._show_columns()
        for action in (self.csv, self.json, self.copy):
            action.setEnabled(bool(self._findings))
        self._follow()

    def _filter(self) -> None:
        self._following = True
        self.order.choose(self.filter.text, self.filter.strategy, self.filter.warned)
        self.tree.expandAll()
        self._following = False
        self._follow()

    def _indexes(self, parent=None):
        """Yield each row that matches the filter, with its index, from top to bottom."""
        above = () if parent is None else (parent,)
        for number in range(self.order.rowCount(*above)):
            index = self.order.index(number, 0, *above)
            yield index, self.order.row(index)
            if parent is None:
                yield from self._indexes(index)

    def _follow(self) -> None:
        """Select the rows of the objects that are selected in FreeCAD."""
        if not self.isVisible():
            return
        names = {obj.Name for obj in Gui.Selection.getSelection()}
        chosen = [index for index, row in self._indexes() if row.name in names]
        model = self.tree.selectionModel()
        self._following = True
        if len(chosen) != len(model.selectedRows()) or not all(map(model.isSelected, chosen)):
            model.clearSelection()
            for index in chosen:
                model.select(index, QItemSelectionModel.Select | QItemSelectionModel.Rows)
        if chosen and not model.isSelected(model.currentIndex()):
            model.setCurrentIndex(chosen[0], QItemSelectionModel.NoUpdate)
            self.tree.scrollTo(chosen[0])
        self._following = False
        self._explain()

    def _select(self) -> None:
        """Select the objects of the selected rows in FreeCAD, and show them in FreeCAD's tree."""
        if self._following:
            return
        document = FreeCAD.ActiveDocument.Name
        Gui.Selection.clearSelection()
        for row in self._selected_rows():
            Gui.Selection.addSelection(document, row.name)
        Gui.runCommand("Std_TreeSelection")
        self._explain()

    def _look_at(self) -> None:
        Gui.SendMsgToActiveView("ViewSelection")

    def _selected_rows(self) -> list[Row]:
        return [self.order.row(index) for index in self.tree.selectionModel().selectedRows()]

    def _explain(self) -> None:
        """Show the details of the selected row; of several selected rows, the details of their totals."""
        rows = self._selected_rows()
        first, others = self.model.first, self.model.others
        if FreeCAD.ActiveDocument is None:
            text = lines(translate("Vk_Analyze", "No document is open. Open one with a job or a toolpath first."))
        elif not self.model.rows:
            text = lines(translate("Vk_Results", "Nothing is analyzed in this document yet. Click Analyze Toolpaths."))
        elif not self.order.rowCount():
            text = lines(translate("Vk_Results", "No operation matches the filter."))
        elif not rows:
            text = lines(translate("Vk_Results", "Select an operation to read what it does and why."))
        elif len(rows) == 1:
            text = page(rows[0], first, others, self._opened)
        else:
            text = "".join(page(row, first, others, self._opened) for row in self._together(rows))
        # Adapt the colour of links to the background as painted, because a theme's style sheet does not change the
        # palette.
        viewport = self.details.viewport()
        behind = viewport.grab(viewport.rect().adjusted(1, 1, 2 - viewport.width(), 2 - viewport.height()))
        color = readable(QColor(colors.LINK), behind.toImage().pixelColor(0, 0))
        self.details.document().setDefaultStyleSheet(f"a {{ color: {color} }}")
        self.details.setHtml(unbroken(text))

    def _together(self, rows: list[Row]) -> list[Row]:
        """Return one total of the selected rows for each job to which rows belong; the total's label says so."""
        names = {row.name for row in rows if not row.is_total}
        chosen = [finding for finding in self._findings if finding.operation.object.Name in names]
        text = translate("Vk_Results", "Selection in {job}")
        return [
            Row(row.found, row.name, text.format(job=row.label), posted=row.posted)
            for row in rows_of(chosen) if row.is_total
        ]  # fmt: skip

    def _open(self, link: str) -> None:
        if link == GAUSS_MAP:
            from vkworkbench.gui.gauss import command as gauss_map_command

            gauss_map_command.show()
            return
        if link == MEASURED:
            rows = self._selected_rows()
            (row,) = rows if len(rows) == 1 else self._together(rows)[:1]
            if learn(row, self):
                analyze_again(FreeCAD.ActiveDocument)
            return
        self._opened ^= {link}
        where = self.details.verticalScrollBar().value()
        self._explain()
        self.details.verticalScrollBar().setValue(where)

    def _export(self, ending: str) -> None:
        """Save all numbers of the results to a file.

        If an operation has a mark in the tree but was not analysed in this session, analyse the document first.
        """
        report = findings.report_of(self._findings)
        if report is None:
            try:
                report = progress.analyze(FreeCAD.ActiveDocument)
            except Cancelled:
                return
            results.remember(report.operations)
            self.refresh()
        save(report, FreeCAD.ActiveDocument, ending, self)

    def _copy(self) -> None:
        """Copy the visible columns of the selected rows to the clipboard; without a selection, of all rows."""
        selected = {row.name for row in self._selected_rows()}
        rows = [row for _, row in self._indexes() if not selected or row.name in selected]
        header = self.tree.header()
        shown = sorted(
            (n for n in range(len(self.model.columns)) if not header.isSectionHidden(n)), key=header.visualIndex
        )
        QApplication.clipboard().setText(as_text([self.model.columns[n] for n in shown], rows))
