# SPDX-License-Identifier: LGPL-2.1-or-later
"""The time line: operations as wide as their machining time, what is removed meanwhile, and where it crashes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

from vkworkbench.gui.plain_text import lines, show_tooltip
from vkworkbench.gui.qt import (
    QColor,
    QPainter,
    QPen,
    QPointF,
    QPolygonF,
    QRectF,
    QSize,
    QSizePolicy,
    Qt,
    QWidget,
    Signal,
)  # fmt: skip
from vkworkbench.gui.simulation.keys import KeyedWidget
from vkworkbench.gui.text import translate

_CURVE, _AIR, _BLOCKS = 34, 4, 20  # px, from top to bottom
_MARK = 5.0  # px; half a warning's width
_RED = "#d32f2f"
# By which share of the job each key moves on.
_KEYS = {
    int(Qt.Key_Left): -0.005, int(Qt.Key_Right): 0.005, int(Qt.Key_PageUp): 0.05, int(Qt.Key_PageDown): -0.05,
    int(Qt.Key_Home): -1.0, int(Qt.Key_End): 1.0,
}  # fmt: skip


@dataclass(frozen=True)
class Block:
    """An operation on the time line.

    Attributes
    ----------
    label : str
    tooltip : str
        Plain text.
    color : str
        ``"#rrggbb"``.
    begin, end : float
        s.
    """

    label: str
    tooltip: str
    color: str
    begin: float
    end: float


@dataclass(frozen=True)
class Warned:
    """A moment that the user must know.

    Attributes
    ----------
    seconds : float
    text : str
        Plain text.
    """

    seconds: float
    text: str


class TimeLine(KeyedWidget):
    """Shows a job over the machine's time; a moment is chosen with the mouse or the keys."""

    moved = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.total, self.seconds = 0.0, 0.0
        self._blocks: tuple[Block, ...] = ()
        self._warned: tuple[Warned, ...] = ()
        self._ends = self._volumes = self._air = np.empty(0)
        self._curve: tuple[int, np.ndarray, np.ndarray] | None = None
        self.keys = {key: partial(self._move_on, share) for key, share in _KEYS.items()}
        self.setMinimumHeight(_CURVE + _AIR + _BLOCKS + 8)
        self.setSizePolicy(QSizePolicy.Expanding, QSizePolicy.Fixed)
        self.setFocusPolicy(Qt.StrongFocus)
        self.setMouseTracking(True)
        self.setAccessibleName(translate("Vk_Simulate", "Time line"))

    def show_job(self, blocks: tuple[Block, ...], total: float) -> None:
        """Show the operations of a job that takes `total` s."""
        self._blocks, self.total = blocks, total
        self.update()

    def show_facts(self, ends: np.ndarray, volumes: np.ndarray, air: np.ndarray, warned: tuple[Warned, ...]) -> None:
        """Show what the trajectories remove.

        Parameters
        ----------
        ends : (n + 1,) float64
            When each has been cut, s.
        volumes : (n,) float64
            What each removes, mm^3.
        air : (n,) bool
            Which of them cut air.
        warned : tuple of Warned
        """
        self._ends, self._volumes, self._air = ends, volumes, air
        self._warned, self._curve = warned, None
        self.update()

    def show_moment(self, seconds: float) -> None:
        """Show that this is the moment, s."""
        self.seconds = seconds
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(400, _CURVE + _AIR + _BLOCKS + 8)

    def x_of(self, seconds: float) -> float:
        """Return where a moment is drawn, px."""
        return seconds / self.total * (self.width() - 1) if self.total else 0.0

    def paintEvent(self, event) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.Antialiasing)
        palette = self.palette()
        painter.fillRect(self.rect(), palette.base())
        text = palette.text().color()
        self._paint_curve(painter, text)
        top = _CURVE + _AIR
        for block in self._blocks:
            left, right = self.x_of(block.begin), self.x_of(block.end)
            place = QRectF(left, top, max(right - left, 1.0), _BLOCKS)
            painter.fillRect(place, QColor(block.color))
            painter.setPen(palette.base().color())
            painter.drawLine(place.topLeft(), place.bottomLeft())
            painter.setPen(QColor("#ffffff"))
            label = painter.fontMetrics().elidedText(block.label, Qt.ElideRight, int(place.width()) - 6)
            if len(label) > 1:
                painter.drawText(place.adjusted(3, 0, -3, 0), int(Qt.AlignVCenter | Qt.AlignLeft), label)
        painter.setPen(Qt.NoPen)
        painter.setBrush(QColor(_RED))
        for warned in self._warned:
            x = self.x_of(warned.seconds)
            painter.drawPolygon(QPolygonF([QPointF(x - _MARK, 0), QPointF(x + _MARK, 0), QPointF(x, 2 * _MARK)]))
        painter.setPen(QPen(text, 2))
        x = self.x_of(self.seconds)
        painter.drawLine(QPointF(x, 0), QPointF(x, self.height()))
        if self.hasFocus():
            painter.setPen(QPen(palette.highlight().color(), 1))
            painter.setBrush(Qt.NoBrush)
            painter.drawRect(QRectF(0.5, 0.5, self.width() - 1, self.height() - 1))

    def _paint_curve(self, painter: QPainter, text: QColor) -> None:
        """The removal rate over time, and below it where a cutting move cuts air."""
        if not len(self._volumes) or not self.total:
            return
        if self._curve is None or self._curve[0] != self.width():
            self._curve = (self.width(), *self._by_column(self.width()))
        _, rate, air = self._curve
        highest = rate.max(initial=0.0)
        fill = QColor(text)
        fill.setAlpha(110)
        if highest > 0:
            tops = _CURVE - rate / highest * (_CURVE - 4)
            corners = [
                QPointF(0, _CURVE),
                *(QPointF(x, y) for x, y in enumerate(tops.tolist())),
                QPointF(len(tops), _CURVE),
            ]
            painter.setPen(Qt.NoPen)
            painter.setBrush(fill)
            painter.drawPolygon(QPolygonF(corners))
        hatch = QColor("#e0a030")
        for x in np.flatnonzero(air > 0.02).tolist():
            hatch.setAlphaF(min(1.0, 0.25 + float(air[x])))
            painter.fillRect(QRectF(x, _CURVE, 1, _AIR), hatch)

    def _by_column(self, width: int) -> tuple[np.ndarray, np.ndarray]:
        """Volume removed, and share of the time in which a cutting move removes nothing, by columns of pixels."""
        edges = np.linspace(0, self.total, width + 1)
        removed = np.diff(np.interp(edges, self._ends, np.append(0, np.cumsum(self._volumes))))
        air = np.where(self._air, np.diff(self._ends), 0.0)
        share = np.diff(np.interp(edges, self._ends, np.append(0, np.cumsum(air)))) * width / self.total
        return removed, share

    def _choose(self, x: float) -> None:
        self.moved.emit(min(max(x / max(self.width() - 1, 1), 0.0), 1.0) * self.total)

    def _move_on(self, share: float) -> None:
        self.moved.emit(min(max(self.seconds + share * self.total, 0.0), self.total))

    def mousePressEvent(self, event) -> None:
        if event.button() == Qt.LeftButton:
            for warned in self._warned:
                if event.pos().y() <= 2 * _MARK and abs(event.pos().x() - self.x_of(warned.seconds)) <= _MARK:
                    self.moved.emit(warned.seconds)
                    return
            self._choose(event.pos().x())

    def mouseMoveEvent(self, event) -> None:
        if event.buttons() & Qt.LeftButton:
            self._choose(event.pos().x())
            return
        x = event.pos().x()
        near = [w.text for w in self._warned if abs(x - self.x_of(w.seconds)) <= _MARK]
        seconds = x / max(self.width() - 1, 1) * self.total
        near += [b.tooltip for b in self._blocks if b.begin <= seconds <= b.end][:1]
        show_tooltip(self.mapToGlobal(event.pos()), lines("\n".join(near)), self)
