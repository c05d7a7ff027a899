# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the colours of surfaces mean, in as many lines as the width takes."""

from __future__ import annotations

from vkworkbench.gui.qt.names import QColor, QPainter, QRectF, QSize, QSizePolicy, Qt, QWidget
from vkworkbench.gui.qt.plain_text import as_html

_GAP = 12  # px between two entries
_BESIDE = 4  # px between a colour and its name
_MOST = 12  # entries with a name


class Legend(QWidget):
    """Colours with their names; a name that is longer than the line is shortened, and whole in the tooltip.

    Attributes
    ----------
    entries : tuple of (str, str)
        Colours and what they stand for; those of a scale have no names but at its ends, and stand close together, in
        the line of the name that ends them.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.entries: tuple[tuple[str, str], ...] = ()
        self.setSizePolicy(QSizePolicy.Ignored, QSizePolicy.Fixed)
        self._fit()

    def show_entries(self, entries: tuple[tuple[str, str], ...]) -> None:
        """Show what colours mean."""
        if entries != self.entries:
            self.entries = entries
            self.setToolTip(as_html("\n".join(name for _, name in entries if name)))
            self._fit()
            self.update()

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        self._fit()

    def changeEvent(self, event) -> None:
        super().changeEvent(event)
        self._fit()

    def paintEvent(self, event) -> None:
        painter = QPainter(self)
        for color, place, name in self._places():
            side = self._side
            painter.fillRect(QRectF(place.left(), place.center().y() - side / 2, side, side), QColor(color))
            painter.setPen(self.palette().windowText().color())
            flags = int(Qt.AlignVCenter | Qt.AlignLeft | Qt.TextDontClip)
            painter.drawText(place.adjusted(side + _BESIDE, 0, 0, 0), flags, name)

    def sizeHint(self) -> QSize:
        return QSize(100, self.height())

    @property
    def _line(self) -> int:
        return self.fontMetrics().height() + 2

    @property
    def _side(self) -> int:
        return round(0.7 * self.fontMetrics().height())

    def _fit(self) -> None:
        """Take the height of all lines."""
        lines = max((place.bottom() for _, place, _ in self._places()), default=0)
        self.setFixedHeight(max(round(lines), self._line))  # one line before there are any, too

    def _places(self) -> list[tuple[str, QRectF, str]]:
        """Each colour with its place and the name that fits."""
        metrics, side = self.fontMetrics(), self._side
        height, width = self._line, max(self.width(), 4 * side)
        places, nameless, x, y, named = [], 0, 0.0, 0.0, 0
        for color, name in self.entries:
            named += bool(name)
            if named > _MOST:
                break
            before = nameless * side
            shown = metrics.elidedText(name, Qt.ElideRight, width - before - side - _BESIDE)
            wide = side + (_BESIDE + metrics.horizontalAdvance(shown) if shown else 0)
            if x > before and x + wide > width:
                for _, place, _ in places[len(places) - nameless :]:  # with their name to the next line
                    place.translate(before - x, height)
                x, y = before, y + height
            places.append((color, QRectF(x, y, wide, height), shown))
            x += wide + (_GAP if name else 0)
            nameless = 0 if name else nameless + 1
        return places
