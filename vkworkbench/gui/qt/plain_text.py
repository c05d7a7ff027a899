# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts of documents and files as plain text, in every tooltip, label and box.

Qt takes a text that begins like HTML for HTML: a label such as ``<img src='file:...'>`` would load the file.
"""

from __future__ import annotations

import re
from html import escape

from vkworkbench.gui.qt.names import (
    QEvent,
    QLabel,
    QMessageBox,
    QObject,
    QPoint,
    QSizePolicy,
    QStylePainter,
    Qt,
    QToolTip,
    QWidget,
)  # fmt: skip

_BEFORE_UNIT = re.compile(r"(?<=\d) (?=(?:[^\W\d_]{1,3}|%)(?!\w))")
_UNBROKEN = "\u00a0"


def as_html(text: str) -> str:
    """Return HTML that shows a text as it is, for Qt to take as such: tooltips of models and widgets."""
    return in_paragraph(lines(text))


def lines(text: str) -> str:
    """Return a text as a part of HTML, with its line breaks."""
    return escape(text).replace("\n", "<br>")


def in_paragraph(html: str) -> str:
    """Return a part of HTML as a tooltip that keeps its spaces, and a number and its unit in one line."""
    return f"<p style='white-space: pre-wrap'>{unbroken(html)}</p>" if html else ""


def unbroken(text: str) -> str:
    """Return a text, or HTML, in which no line ends between a number and its unit."""
    return _BEFORE_UNIT.sub(_UNBROKEN, text)


def as_plain(label: QLabel) -> QLabel:
    """Make a label show every text as it is, and return it."""
    label.setTextFormat(Qt.PlainText)
    return label


class OneLine(QLabel):
    """A text as it is, in a line as wide as there is room: what is too long ends with "…", and is whole in the tooltip."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        as_plain(self).setSizePolicy(QSizePolicy.Ignored, QSizePolicy.Preferred)

    def show_text(self, text: str) -> None:
        if text != self.text():
            self.setText(text)
            self.setToolTip(as_html(text))

    def paintEvent(self, event) -> None:
        place = self.contentsRect()
        shown = self.fontMetrics().elidedText(self.text(), Qt.ElideRight, place.width())
        if shown == self.text() or self.hasSelectedText():  # what is selected Qt's own shows, without the dots
            super().paintEvent(event)
            return
        painter = QStylePainter(self)
        flags = int(Qt.AlignLeft | Qt.AlignVCenter)
        painter.drawItemText(place, flags, self.palette(), self.isEnabled(), shown, self.foregroundRole())


class WholeText(QObject):
    """Keeps a label that wraps as high as its text is in its width.

    A layout asks how high it is at least in a width of its own; where there is less, lines are cut off, or what stands
    beside is squeezed.
    """

    def __init__(self, label: QLabel) -> None:
        super().__init__(label)
        self._label = label
        label.installEventFilter(self)

    def eventFilter(self, label, event) -> bool:
        if event.type() in (QEvent.Resize, QEvent.FontChange):
            self.fit()
        return False

    def fit(self) -> None:
        """Follow another text."""
        self._label.setMinimumHeight(0)  # else a label tells no less than it had
        self._label.setMinimumHeight(max(0, self._label.heightForWidth(self._label.width())))  # -1 without a text


def show_tooltip(where: QPoint, html: str, widget: QWidget) -> None:
    """Show a part of HTML as a tooltip; what it takes from documents has gone through `lines`."""
    QToolTip.showText(where, in_paragraph(html), widget)


def tell(title: str, text: str, parent: QWidget) -> QMessageBox:
    """Tell something in a box that does not block."""
    return _box(QMessageBox.Information, title, text, parent)


def warn(title: str, text: str, parent: QWidget) -> QMessageBox:
    """Tell what went wrong in a box that does not block."""
    return _box(QMessageBox.Warning, title, text, parent)


def _box(icon, title: str, text: str, parent: QWidget) -> QMessageBox:
    box = QMessageBox(icon, title, text, QMessageBox.Ok, parent)
    box.setTextFormat(Qt.PlainText)
    box.setAttribute(Qt.WA_DeleteOnClose)
    box.setModal(False)
    box.show()
    return box
