# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tree whose first column stays visible while the other columns are scrolled, like Qt's example "Frozen Column"."""

from __future__ import annotations

from collections.abc import Callable

from vkworkbench.gui.qt.names import QAbstractItemView, QEvent, QFrame, QHeaderView, QKeySequence, Qt, QTreeView

_MIN_ROWS = 2  # the column titles are hidden if fewer rows than this are visible below them


class FrozenTree(QTreeView):
    """A tree whose first column stays visible.

    While the tree is scrolled sideways, a second tree on top of it shows the first column. `copy` is called for Ctrl+C,
    and `enter` for the Enter key or a double click.
    """

    def __init__(self, model, copy: Callable[[], None], enter: Callable[[], None]) -> None:
        super().__init__()
        self._copy, self._enter = copy, enter
        self._above = QTreeView(self)
        self._above.setObjectName("frozen")
        self._above.setFocusPolicy(Qt.NoFocus)
        self._above.setFrameShape(QFrame.NoFrame)
        # Without borders and margins, which many themes set for every tree, both trees align.
        self._above.setStyleSheet("#frozen { border: none; border-radius: 0; margin: 0; padding: 0 }")
        self._above.setHorizontalScrollBarPolicy(Qt.ScrollBarAlwaysOff)
        self._above.setVerticalScrollBarPolicy(Qt.ScrollBarAlwaysOff)
        self._above.hide()
        for view in (self, self._above):
            view.setModel(model)
            view.setUniformRowHeights(True)
            # Shorten a long label in its middle, because labels of operations often differ only at the end.
            view.setTextElideMode(Qt.ElideMiddle)
            view.setAlternatingRowColors(True)
            view.setExpandsOnDoubleClick(False)
            view.setSelectionMode(QAbstractItemView.ExtendedSelection)
            view.setVerticalScrollMode(QAbstractItemView.ScrollPerPixel)
            view.doubleClicked.connect(lambda index: self._enter())
        self._above.setSelectionModel(self.selectionModel())
        self.setHorizontalScrollMode(QAbstractItemView.ScrollPerPixel)
        self.setAllColumnsShowFocus(True)
        self.setTabKeyNavigation(False)
        for one, other in ((self, self._above), (self._above, self)):
            one.expanded.connect(other.expand)
            one.collapsed.connect(other.collapse)
            one.verticalScrollBar().valueChanged.connect(other.verticalScrollBar().setValue)
        header = self.header()
        header.setDefaultAlignment(Qt.AlignCenter)
        header.sectionResized.connect(lambda *what: self._place())
        self.horizontalScrollBar().valueChanged.connect(lambda value: self._place())
        for column in range(1, model.columnCount()):
            self._above.hideColumn(column)
        self._above.header().setDefaultAlignment(Qt.AlignCenter)
        self._above.header().setSectionResizeMode(QHeaderView.Fixed)
        self._above.header().setSectionsClickable(True)
        self._above.header().sectionClicked.connect(self._sort)

    def show_menus(self, of_titles: Callable, of_rows: Callable) -> None:
        """Show a context menu for a right click: the result of `of_titles` on a title, of `of_rows` on a row."""
        for view in (self, self._above):
            for part, place, menu in ((view.header(), view.header(), of_titles), (view, view.viewport(), of_rows)):
                part.setContextMenuPolicy(Qt.CustomContextMenu)
                part.customContextMenuRequested.connect(
                    lambda at, place=place, menu=menu: menu().exec_(place.mapToGlobal(at))
                )

    def drawRow(self, painter, option, index) -> None:
        """Paint a row without its part under the frozen column, because FreeCAD 1.1's theme makes trees transparent."""
        if not self._above.isHidden():
            painter.setClipRect(self.viewport().rect().adjusted(self.columnWidth(0), 0, 0, 0))
        super().drawRow(painter, option, index)

    def scrollTo(self, index, hint=QAbstractItemView.EnsureVisible) -> None:
        """Scroll to a row, but not sideways, so that the same columns stay visible."""
        sideways = self.horizontalScrollBar().value()
        super().scrollTo(index, hint)
        self.horizontalScrollBar().setValue(sideways)

    def event(self, event) -> bool:
        # Claim Ctrl+C, which otherwise opens FreeCAD's dialog for copying objects.
        if event.type() == QEvent.ShortcutOverride and event.matches(QKeySequence.Copy):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event) -> None:
        if event.matches(QKeySequence.Copy):
            self._copy()
        elif event.key() in (Qt.Key_Return, Qt.Key_Enter):
            self._enter()
        else:
            super().keyPressEvent(event)

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        # Hide the titles of the columns on a low screen, where they would leave no room for rows.
        around = self.header().sizeHint().height() + self.horizontalScrollBar().sizeHint().height()
        self.header().setVisible(self.height() - around >= _MIN_ROWS * self.fontMetrics().lineSpacing())
        self._place()

    def _sort(self, section: int) -> None:
        header = self.header()
        again = header.sortIndicatorSection() == section and header.sortIndicatorOrder() == Qt.AscendingOrder
        self.sortByColumn(section, Qt.DescendingOrder if again else Qt.AscendingOrder)

    def _place(self) -> None:
        scrolled = self.horizontalScrollBar().value() > 0
        if scrolled:
            width, header = self.columnWidth(0), 0 if self.header().isHidden() else self.header().height()
            self._above.setColumnWidth(0, width)
            self._above.header().setFixedHeight(header)
            seen = self.viewport().geometry()  # the visible area, without the border and padding that a theme can add
            self._above.setGeometry(seen.left(), seen.top() - header, width, header + seen.height())
            self._above.verticalScrollBar().setValue(self.verticalScrollBar().value())
        self._above.setVisible(scrolled)
