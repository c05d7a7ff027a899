# SPDX-License-Identifier: LGPL-2.1-or-later
"""Show marks as pills in the tree's Description column: the strategy on its colour, and the simulation time beside it.

A Qt delegate without state paints the pills from the data of the marks. Therefore the pills need no update after a
recompute, an undo, a renaming, a reopening or a change of preferences. Qt's style still paints the text, in the colours
of the theme, with gaps for the pills.
"""

from __future__ import annotations

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import preferences
from vkworkbench.document import upkeep
from vkworkbench.document.marks import marks
from vkworkbench.document.marks.properties import may_have_mark
from vkworkbench.document.simulation.faults import read_with_faults
from vkworkbench.gui.qt.names import (
    QApplication,
    QColor,
    QEvent,
    QFontMetrics,
    QPainter,
    QPen,
    QPointF,
    QPolygonF,
    QRectF,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    Qt,
    single_shot,
)  # fmt: skip
from vkworkbench.gui.qt.plain_text import show_tooltip
from vkworkbench.gui.tree import column
from vkworkbench.gui.tree.explanation import explanation
from vkworkbench.gui.tree.layout import PADDING, Layout, layouts

_MARGINS = 16  # px; sum of the left and right margin of the text in a cell
_REMARK_LENGTH = 40  # characters of a remark that fit in the default width of the column


class PillDelegate(QStyledItemDelegate):
    """Paints marks as pills, shows their tooltips, and lets users edit only their own words in a description."""

    def initStyleOption(self, option, index) -> None:
        super().initStyleOption(option, index)
        found = _layouts(option, index, _REMARK_LENGTH)
        if found:
            option.text = found[0].text

    def paint(self, painter, option, index) -> None:
        shown = QStyleOptionViewItem(option)
        super().initStyleOption(shown, index)
        found = _layouts(shown, index, None)
        if not found:
            super().paint(painter, option, index)
            return
        style = option.widget.style() if option.widget else QApplication.style()
        margin = style.pixelMetric(QStyle.PM_FocusFrameHMargin, None, option.widget) + 1
        area = style.subElementRect(QStyle.SE_ItemViewItemText, shown, option.widget)
        room = area.width() - 2 * margin
        if option.widget:  # of a column that is wider than the tree, only the visible part has room for the mark
            room = min(room, option.widget.viewport().width() - area.left() - 2 * margin)
        layout = next((one for one in found if one.needed <= room), found[-1])
        shown.text = layout.text
        style.drawControl(QStyle.CE_ItemViewItem, shown, painter, option.widget)
        painter.save()
        painter.setClipRect(option.rect)
        painter.setRenderHint(QPainter.Antialiasing)
        painter.setFont(shown.font)
        height = min(shown.fontMetrics.height() + 2, option.rect.height() - 1)
        top = area.center().y() + 1 - height / 2
        for piece in layout.pieces:
            where = QRectF(
                area.left() + margin + piece.left + 0.5, top, min(piece.width, room - piece.left) - 1, height
            )
            _PAINTERS[piece.kind](painter, where, piece)
        painter.restore()

    def helpEvent(self, event, view, option, index) -> bool:
        obj = _object_of(index)
        record = read_with_faults(obj) if obj is not None else None
        if event.type() != QEvent.ToolTip or record is None:
            return super().helpEvent(event, view, option, index)
        show_tooltip(event.globalPos(), explanation(record, preferences.read()), view)
        return True

    def setEditorData(self, editor, index) -> None:
        obj = _object_of(index)
        editor.setText((index.data(Qt.EditRole) or "") if obj is None else marks.words_of(obj))

    def setModelData(self, editor, model, index) -> None:
        obj = _object_of(index)
        if obj is None:
            super().setModelData(editor, model, index)
        elif editor.text() != marks.words_of(obj):
            model.setData(index, marks.with_words(obj, editor.text()), Qt.EditRole)


def _layouts(option, index, most_of_remark: int | None) -> list[Layout]:
    """Return the layouts of the mark in a cell of the tree, the most detailed first; empty without a mark."""
    if not index.data():
        return []
    found = _objects_of(index)
    record = read_with_faults(found[0]) if found else None
    if record is None or not marks.is_shown(found[0]):
        return []
    return layouts(record, marks.words_of(found[0]).strip(), preferences.read(), option.fontMetrics, most_of_remark)


def _paint_filled(painter, where: QRectF, piece) -> None:
    painter.setPen(Qt.NoPen)
    painter.setBrush(QColor(piece.color))
    painter.drawRoundedRect(where, where.height() / 3, where.height() / 3)
    painter.setPen(QColor(piece.ink))
    room = int(where.width()) - PADDING
    painter.drawText(where, Qt.AlignCenter, painter.fontMetrics().elidedText(piece.text, Qt.ElideRight, room))


def _paint_outlined(painter, where: QRectF, piece) -> None:
    painter.setPen(QPen(QColor(piece.color), 1.5, Qt.DashLine))
    painter.setBrush(Qt.NoBrush)
    painter.drawRoundedRect(where, where.height() / 3, where.height() / 3)


def _paint_warning(painter, where: QRectF, piece) -> None:
    """Paint a triangle with an exclamation mark. A font's warning sign could be missing or have its own colours."""
    side = where.height() - 3
    box = QRectF(where.center().x() - side / 2, where.center().y() - side / 2, side, side)
    painter.setPen(Qt.NoPen)
    painter.setBrush(QColor(piece.color))
    painter.drawPolygon(QPolygonF([box.bottomLeft(), box.bottomRight(), QPointF(box.center().x(), box.top())]))
    painter.setPen(QPen(QColor(piece.ink), side / 8))
    middle = box.center().x()
    painter.drawLine(QPointF(middle, box.top() + 0.38 * side), QPointF(middle, box.top() + 0.66 * side))
    painter.drawPoint(QPointF(middle, box.top() + 0.84 * side))


def _paint_error(painter, where: QRectF, piece) -> None:
    """Paint a disc with a cross."""
    side = where.height() - 3
    box = QRectF(where.center().x() - side / 2, where.center().y() - side / 2, side, side)
    painter.setPen(Qt.NoPen)
    painter.setBrush(QColor(piece.color))
    painter.drawEllipse(box)
    painter.setPen(QPen(QColor(piece.ink), side / 8))
    cross = box.adjusted(*(0.3 * side * sign for sign in (1, 1, -1, -1)))
    painter.drawLine(cross.topLeft(), cross.bottomRight())
    painter.drawLine(cross.bottomLeft(), cross.topRight())


_PAINTERS = {
    "filled": _paint_filled, "outlined": _paint_outlined, "warning": _paint_warning, "error": _paint_error,
}  # fmt: skip


def _objects_of(index) -> list:
    """Return the marked objects that have the label, description and document of a cell in the tree."""
    root = index.sibling(index.row(), 0)
    label, description = root.data(), index.data()
    above = []  # FreeCAD 0.20 has a root item "Application" above the documents
    while root.isValid():
        above.append(root.data())
        root = root.parent()
    return [
        obj
        for document in FreeCAD.listDocuments().values() if document.Label in above[-2:]
        for obj in document.getObjectsByLabel(label)
        if obj.Label2 == description and may_have_mark(obj)
    ]  # fmt: skip


def _object_of(index):
    """Return the marked object that a cell of the tree shows; None unless exactly one object fits the cell."""
    found = _objects_of(index)
    return found[0] if len(found) == 1 else None


_delegate: PillDelegate | None = None  # kept here, because Qt's views do not keep their delegates alive


def _follow_preferences() -> None:
    with column.steady_columns():
        upkeep.follow_preferences()
    show()


_changes = single_shot(_follow_preferences)  # This function runs once, after all changed preferences were written.


def _repaint() -> None:
    """Repaint the trees. The layout of a mark depends on its visible width, which changes when the tree is scrolled."""
    for view in column.trees():
        view.viewport().update()


def show() -> None:
    """Show or hide the pills in all trees, following the preferences, and repaint the trees."""
    global _delegate
    wanted = preferences.read().show_pills
    if _delegate is None:
        _delegate = PillDelegate(Gui.getMainWindow())
        preferences.observe(lambda name: _changes.start())
    for view in column.trees():
        if (view.itemDelegateForColumn(column.DESCRIPTION) is _delegate) != wanted:
            view.setItemDelegateForColumn(column.DESCRIPTION, _delegate if wanted else None)
            scrolled = view.horizontalScrollBar().valueChanged
            if wanted:
                scrolled.connect(_repaint)
            else:
                scrolled.disconnect(_repaint)
    _repaint()


def fit_column() -> None:
    """Make the Description column wide enough for the marks of all operations, also in collapsed branches."""
    document, chosen = FreeCAD.ActiveDocument, preferences.read()
    records = [read_with_faults(obj) for obj in document.Objects if may_have_mark(obj)] if document else []
    metrics = QFontMetrics(QApplication.font("QTreeView"))
    needed = [layouts(record, "", chosen, metrics, 0)[0].needed for record in records if record is not None]
    column.fit_description(max(needed, default=0) + _MARGINS)
