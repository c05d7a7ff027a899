# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks as pills in the tree's Description column: the strategy on its colour, the cost beside it.

A delegate makes them out of the cell's text and keeps no state, so recompute, undo, renaming and reopening
need no special care. The style still paints all text, and leaves a gap for the pill: themes know the colours of
their text best.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from html import escape

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import preferences
from vkworkbench.core import Strategy
from vkworkbench.core.simulators import ZBUFFER
from vkworkbench.document import marks
from vkworkbench.gui import tree
from vkworkbench.gui.colors import TEXT, TOTAL
from vkworkbench.gui.plain_text import show_tooltip
from vkworkbench.gui.qt import (
    QApplication,
    QColor,
    QEvent,
    QPainter,
    QPen,
    QRectF,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    Qt,
)  # fmt: skip
from vkworkbench.gui.sentences import said, strategy_name, user
from vkworkbench.gui.text import translate
from vkworkbench.language import ENGLISH, ROUGH

_PADDING = 6  # px within a pill, left and right
_SPACE = "\u00a0"  # is not stretched or cut off at a line's end
_TOTAL = re.compile(r"(\d+) operations?")
_PERCENT = re.compile(r"(\d{1,3})%")
_MEMORY = re.compile(r"(≥ )?[\d.,]+ [kMG]B")
_ABOUT = ENGLISH.about("", ROUGH)


@dataclass(frozen=True)
class Mark:
    """The text of a description, taken apart.

    Attributes
    ----------
    before, after : str
        The user's own words around the mark.
    strategy : Strategy or None
        None for the total of a job.
    pill : str
        What stands in the pill, in the user's language.
    cost : str
        Time, memory and remark.
    outdated : bool
    """

    before: str
    after: str
    strategy: Strategy | None
    pill: str
    cost: str
    outdated: bool

    @property
    def color(self) -> str:
        return self.strategy.color if self.strategy else TOTAL

    @property
    def rest(self) -> str:
        """The text behind the pill, the most important part first."""
        words = [translate("Pills", "outdated") if self.outdated else "", self.cost, self.after]
        return "  ".join(filter(None, words))


def read_mark(label2: str) -> Mark | None:
    """Take a description apart; None where there is no mark."""
    segment = marks.segment_of(label2)
    if segment is None:
        return None
    opening, closing = label2.index(segment) - 1, label2.index(segment) + len(segment) + 1
    first, *rest = segment.split(marks.SEPARATOR)
    outdated = rest[-1:] == [marks.OUTDATED]
    if outdated:
        rest.pop()
    total = _TOTAL.fullmatch(first)
    if total:
        one, more = translate("Pills", "{} operation"), translate("Pills", "{} operations")
        text = one if total.group(1) == "1" else more
        strategy, pill = None, text.format(total.group(1))
    else:
        name, _, sure = first.partition(" ")
        strategy = Strategy(name)
        percent = _PERCENT.fullmatch(sure)
        sure = user().share(int(percent.group(1)) / 100) if percent else sure
        pill = f"{strategy_name(strategy)} {sure}".rstrip()
    before, after = label2[:opening].strip(), label2[closing:].strip()
    if len(rest) > 1 and _MEMORY.fullmatch(rest[1]):
        rest[:2] = map(_as_read, rest[:2])
    return Mark(before, after, strategy, pill, marks.SEPARATOR.join(rest), outdated)


def _as_read(cost: str) -> str:
    """Return the time or memory of a mark as the user reads it."""
    before, about, number = user().separated(cost).partition(_ABOUT)
    return before + user().about(number, ROUGH) if about else before


class PillDelegate(QStyledItemDelegate):
    """Paints marks as pills, explains them, and lets the user edit only his own words."""

    def initStyleOption(self, option, index) -> None:
        super().initStyleOption(option, index)
        mark = read_mark(option.text)
        if mark is not None:
            gap = _outlined(mark, option.fontMetrics) if mark.outdated else _gap(mark, option.fontMetrics)
            option.text = f"{_lead(mark)}{gap} {mark.rest}"

    def paint(self, painter, option, index) -> None:
        super().paint(painter, option, index)
        mark = read_mark(index.data() or "")
        if mark is None:
            return
        shown = QStyleOptionViewItem(option)
        self.initStyleOption(shown, index)
        metrics = shown.fontMetrics
        style = option.widget.style() if option.widget else QApplication.style()
        area = style.subElementRect(QStyle.SE_ItemViewItemText, shown, option.widget)
        margin = style.pixelMetric(QStyle.PM_FocusFrameHMargin, None, option.widget) + 1
        gap = _outlined(mark, metrics) if mark.outdated else _gap(mark, metrics)
        left = area.left() + margin + metrics.horizontalAdvance(_lead(mark))
        height = min(metrics.height() + 2, option.rect.height() - 1)
        top = area.center().y() + 1 - height / 2
        pill = QRectF(left + 0.5, top, metrics.horizontalAdvance(gap) - 1, height)
        painter.save()
        painter.setClipRect(option.rect)
        painter.setRenderHint(QPainter.Antialiasing)
        if mark.outdated:
            painter.setPen(QPen(QColor(mark.color), 1.5, Qt.DashLine))
            painter.drawRoundedRect(pill, height / 3, height / 3)
        else:
            painter.setPen(Qt.NoPen)
            painter.setBrush(QColor(mark.color))
            painter.drawRoundedRect(pill, height / 3, height / 3)
            painter.setPen(QColor(TEXT))
            painter.setFont(shown.font)
            painter.drawText(pill, Qt.AlignCenter, mark.pill)
        painter.restore()

    def helpEvent(self, event, view, option, index) -> bool:
        mark = read_mark(index.data() or "")
        if event.type() != QEvent.ToolTip or mark is None:
            return super().helpEvent(event, view, option, index)
        show_tooltip(event.globalPos(), explanation(mark, _object_of(index)), view)
        return True

    def setEditorData(self, editor, index) -> None:
        editor.setText(marks.words_of(index.data(Qt.EditRole) or ""))

    def setModelData(self, editor, model, index) -> None:
        label2 = index.data(Qt.EditRole) or ""
        if editor.text() != marks.words_of(label2):
            model.setData(index, marks.with_words(label2, editor.text()), Qt.EditRole)


def _lead(mark: Mark) -> str:
    return f"{mark.before} " if mark.before else ""


def _gap(mark: Mark, metrics) -> str:
    """Spaces as wide as the pill."""
    width = metrics.horizontalAdvance(mark.pill) + 2 * _PADDING
    return _SPACE * math.ceil(width / metrics.horizontalAdvance(_SPACE))


def _outlined(mark: Mark, metrics) -> str:
    """Return the pill's text with room for its outline: such a pill is not filled, so its text has the usual colour."""
    padding = _SPACE * math.ceil(_PADDING / metrics.horizontalAdvance(_SPACE))
    return f"{padding}{mark.pill}{padding}"


def explanation(mark: Mark, obj) -> str:
    """Return what a mark means, as HTML; without details where its object is not known."""
    lines = [f"<b>{escape(mark.pill)}</b>"]
    if obj is None:
        lines.append(escape(mark.cost))
    else:
        lines += [escape(said(reason)) for reason in marks.reason_of(obj)]
        lines.append(translate("Pills", "{trajectories} trajectories, {length} cutting").format(
            trajectories=user().count(obj.ToolpathTrajectories), length=user().length(obj.ToolpathLength)
        ))  # fmt: skip
        if obj.ToolpathMemory:
            whose = getattr(obj, "ToolpathSimulator", ZBUFFER.name)
            text = translate("Pills", "Simulating it takes {time} and {memory} ({simulator})")
            lines.append(text.format(
                time=_time(obj), memory=user().memory(obj.ToolpathMemory), simulator=whose
            ))  # fmt: skip
        lines += [f"<b>{escape(said(remark))}</b>" for remark in marks.remarks_of(obj)]
    if mark.outdated:
        text = translate("Pills", "Outdated: toolpath, tool or stock have changed since. Analyze it again.")
        lines.append(f"<i>{escape(text)}</i>")
    return "<br>".join(lines)


def _time(obj) -> str:
    """Return the time in an object's mark; as a range where it is only a rough estimate."""
    seconds, factor = obj.ToolpathSeconds, obj.ToolpathFactor
    time = user().time
    return time(seconds) if factor < ROUGH else user().between(time(seconds / factor), time(seconds * factor))


def _object_of(index):
    """Return the marked object of a cell of the tree, by the labels of object and document; None unless one fits."""
    root = index.sibling(index.row(), 0)
    label, description = root.data(), index.data()
    above = []  # in 0.20 documents stand below "Application", later at the top
    while root.isValid():
        above.append(root.data())
        root = root.parent()
    found = [
        obj
        for document in FreeCAD.listDocuments().values() if document.Label in above[-2:]
        for obj in document.getObjectsByLabel(label)
        if obj.Label2 == description and hasattr(obj, "ToolpathFingerprint")
    ]  # fmt: skip
    return found[0] if len(found) == 1 else None


_delegate: PillDelegate | None = None  # views do not keep their delegates alive


def show() -> None:
    """Show pills in all trees, or no longer if the user does not want them; called again it does nothing."""
    global _delegate
    wanted = preferences.read().show_pills
    if _delegate is None:
        if not wanted:
            return
        _delegate = PillDelegate(Gui.getMainWindow())
    for view in tree.trees():
        shown = view.itemDelegateForColumn(tree.DESCRIPTION) is _delegate
        if shown != wanted:
            view.setItemDelegateForColumn(tree.DESCRIPTION, _delegate if wanted else None)
            view.viewport().update()
