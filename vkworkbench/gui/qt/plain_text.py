# SPDX-License-Identifier: LGPL-2.1-or-later
"""Show texts from documents and files as plain text, in every tooltip, label, message box and status bar.

By default, Qt interprets a text that looks like HTML: a label such as ``<img src='file:...'>`` would load the file.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from html import escape

import FreeCADGui as Gui

from vkworkbench.gui.qt.names import (
    QEvent,
    QInputDialog,
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
_LABEL = 40  # maximum number of characters of a label within a sentence
_SHOWN = 10_000  # ms for which the status bar shows a message


def as_html(text: str) -> str:
    """Return HTML that shows a text literally, for tooltips."""
    return in_paragraph(lines(text))


def shortened(label: str) -> str:
    """Return a label; the middle of a long label is replaced by "…", so that the text beside the label is visible."""
    return label if len(label) <= _LABEL else f"{label[: _LABEL // 2]}…{label[-_LABEL // 2 :]}"


def lines(text: str) -> str:
    """Return a text as HTML without a paragraph, with its line breaks."""
    return escape(text).replace("\n", "<br>")


def in_paragraph(html: str) -> str:
    """Return HTML as a paragraph that keeps spaces, and keeps a number and its unit in one line."""
    return f"<p style='white-space: pre-wrap'>{unbroken(html)}</p>" if html else ""


def unbroken(text: str) -> str:
    """Return a text or HTML with unbreakable spaces between numbers and units."""
    return _BEFORE_UNIT.sub(_UNBROKEN, text)


def as_plain(label: QLabel) -> QLabel:
    """Make a label show its text literally, and return the label."""
    label.setTextFormat(Qt.PlainText)
    return label


class OneLine(QLabel):
    """A label of one line that shows its text literally. The tooltip shows a text that is shortened with "…"."""

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
        if shown == self.text() or self.hasSelectedText():  # let Qt paint the whole text if a part of it is selected
            super().paintEvent(event)
            return
        painter = QStylePainter(self)
        flags = int(Qt.AlignLeft | Qt.AlignVCenter)
        painter.drawItemText(place, flags, self.palette(), self.isEnabled(), shown, self.foregroundRole())


class WholeText(QObject):
    """Keeps a label with wrapped text high enough for the text.

    A Qt layout computes the minimum height for another width than the label's real width, so that a narrow label would
    hide the last lines of its text.
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
        """Adapt the label's height to its text and width."""
        self._label.setMinimumHeight(0)  # otherwise heightForWidth() would return at least the previous minimum
        # For a label without a text, heightForWidth() returns -1.
        self._label.setMinimumHeight(max(0, self._label.heightForWidth(self._label.width())))


def show_tooltip(where: QPoint, html: str, widget: QWidget) -> None:
    """Show HTML as a tooltip. A text from a document must be converted by `lines` before it is a part of the HTML."""
    QToolTip.showText(where, in_paragraph(html), widget)


def inform(title: str, text: str, parent: QWidget) -> QMessageBox:
    """Show a message in a box that does not block."""
    return _box(QMessageBox.Information, title, text, parent)


def choose(
    title: str, text: str, choices: list[str], take: Callable[[int], object], parent: QWidget, present: int = 0
) -> None:
    """Ask for one of several different texts in a box that does not block, and call `take` with its position."""
    dialog = QInputDialog(parent)
    dialog.setAttribute(Qt.WA_DeleteOnClose)
    dialog.setWindowTitle(title)
    dialog.setLabelText(text)
    dialog.setComboBoxItems(choices)
    dialog.setTextValue(choices[present])
    as_plain(dialog.findChild(QLabel))
    dialog.textValueSelected.connect(lambda chosen: take(choices.index(chosen)))
    dialog.open()


def show_status(text: str) -> None:
    """Show a message in the status bar of FreeCAD's window for some seconds."""
    Gui.getMainWindow().statusBar().showMessage(text, _SHOWN)


def warn(title: str, text: str, parent: QWidget) -> QMessageBox:
    """Show a warning in a box that does not block."""
    return _box(QMessageBox.Warning, title, text, parent)


def offer(title: str, text: str, button: str, action: Callable[[], object], parent: QWidget) -> QMessageBox:
    """Show a message in a box that does not block, with a button that calls `action`."""
    box = inform(title, text, parent)
    box.addButton(button, QMessageBox.ActionRole).clicked.connect(lambda *_: action())
    return box


def _box(icon, title: str, text: str, parent: QWidget) -> QMessageBox:
    box = QMessageBox(icon, title, text, QMessageBox.Ok, parent)
    box.setTextFormat(Qt.PlainText)
    box.setAttribute(Qt.WA_DeleteOnClose)
    box.setModal(False)
    box.show()
    return box
