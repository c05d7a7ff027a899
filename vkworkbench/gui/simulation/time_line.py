# SPDX-License-Identifier: LGPL-2.1-or-later
"""The time line: operations, removal rate, air cuts and faults over the machining time of a job."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from vkworkbench.gui.qt.colors import paper
from vkworkbench.gui.qt.names import (
    QApplication,
    QColor,
    QPainter,
    QPalette,
    QPen,
    QPoint,
    QPointF,
    QPolygonF,
    QRectF,
    QSize,
    QSizePolicy,
    Qt,
    QWidget,
    Signal,
)  # fmt: skip
from vkworkbench.gui.qt.plain_text import lines, show_tooltip
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.simulation.widgets import KeyedWidget

# Heights of the curve, the air cuts, the operations and the margin, px, from top to bottom. A low widget has a lower
# curve.
_CURVE, _AIR, _BLOCKS, _BELOW = 34, 4, 20, 8
_MIN_CURVE = 12  # minimum height of the curve, px
_MARK = 5.0  # half the width of a warning triangle, px
_APART = 5  # px; lines are drawn between the trajectories if their mean width on the time line is larger than this
_ZOOM = 1.4  # zoom factor for each notch of the mouse wheel
_MAX_WARNINGS = 10  # upper limit for the number of warnings in a tooltip
_MIN_SPAN = 1e-6  # smallest time range to which the user can zoom, as a share of the job's time
# Step of each key, as a share of the job's time.
_KEYS = {
    int(Qt.Key_Left): -0.005, int(Qt.Key_Right): 0.005, int(Qt.Key_PageUp): 0.05, int(Qt.Key_PageDown): -0.05,
    int(Qt.Key_Home): -1.0, int(Qt.Key_End): 1.0,
}  # fmt: skip


@dataclass(frozen=True)
class Block:
    """An operation on the time line."""

    label: str
    tooltip: str  # plain text
    color: str  # ``"#rrggbb"``
    # begin, end: times, s.
    begin: float
    end: float


@dataclass(frozen=True)
class Warned:
    """A warning on the time line."""

    seconds: float  # machining time at which the fault happens
    text: Callable[[], str]  # returns the text of the warning, made on request because few of many warnings are read
    color: str  # ``"#rrggbb"``


class TimeLine(KeyedWidget):
    """Shows a job, or a part of it, over its machining time. The user chooses a moment with the mouse or with keys."""

    moved = Signal(float)  # the user dragged to a moment, or chose it with a key, s
    clicked = Signal(float)  # the user clicked on a moment without dragging, s

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.total, self.seconds = 0.0, 0.0
        self._begin, self._end = 0.0, 0.0  # the visible time range, s
        self._pressed: QPoint | None = None
        self._blocks: tuple[Block, ...] = ()
        self._warned: tuple[Warned, ...] = ()
        self._ends = self._volumes = self._air = np.empty(0)
        self._curve: tuple[QSize, QPolygonF, np.ndarray] | None = (
            None  # cache: the widget's size, the area below the curve, and each pixel column's share of air cuts
        )
        self.keys = {key: partial(self._move_on, share) for key, share in _KEYS.items()}
        self.setMinimumHeight(_MIN_CURVE + _AIR + _BLOCKS + _BELOW)
        self.setSizePolicy(QSizePolicy.Expanding, QSizePolicy.Maximum)
        self.setFocusPolicy(Qt.StrongFocus)
        self.setBackgroundRole(QPalette.Base)  # with this role, a theme's style sheet sets the background
        self.setMouseTracking(True)
        self.setAccessibleName(translate("Vk_Simulate", "Time Line"))

    def show_job(self, blocks: tuple[Block, ...], total: float) -> None:
        """Show the operations of a job that takes `total` s."""
        self._blocks = blocks
        if total != self.total:
            self.total, self._begin, self._end = total, 0.0, total
        self.update()

    def show_facts(self, ends: np.ndarray, volumes: np.ndarray, air: np.ndarray, warned: tuple[Warned, ...]) -> None:
        """Show the removal rate, the air cuts and the warnings.

        ``ends[k]`` is the time after k trajectories, s. `volumes` (n,) are the removed volumes of the trajectories,
        mm^3, and `air` (n,) is True for trajectories that cut air only.
        """
        self._ends, self._volumes, self._air = ends, volumes, air
        self._warned, self._curve = warned, None
        self.update()

    def show_moment(self, seconds: float) -> None:
        """Show the line at the shown moment, s."""
        self.seconds = seconds
        if not self._begin <= seconds <= self._end:
            self._see(seconds - self._span / 2, self._span)
        self.update()

    @property
    def _span(self) -> float:
        return self._end - self._begin

    def _see(self, begin: float, span: float) -> None:
        """Show a time range, s, shifted and shortened so that it lies within the job's time."""
        span = min(span, self.total)
        self._begin = min(max(begin, 0.0), self.total - span)
        self._end = self._begin + span
        self._curve = None
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(400, _CURVE + _AIR + _BLOCKS + _BELOW)

    @property
    def _curve_height(self) -> int:
        return self.height() - _AIR - _BLOCKS - _BELOW

    def x_of(self, seconds: float) -> float:
        """Return the x position, px, of a moment on the time line."""
        return (seconds - self._begin) / self._span * (self.width() - 1) if self._span else 0.0

    def seconds_at(self, x: float) -> float:
        """Return the moment at an x position, px."""
        share = min(max(x / max(self.width() - 1, 1), 0.0), 1.0)
        return min(self._begin + share * self._span, self.total)

    def paintEvent(self, event) -> None:
        painter = QPainter(self)
        try:
            self._paint(painter)
        finally:
            painter.end()  # without this call, the traceback of an error keeps the painter alive

    def _paint(self, painter: QPainter) -> None:
        painter.setRenderHint(QPainter.Antialiasing)
        palette = self.palette()
        behind = paper(palette)
        painter.fillRect(self.rect(), behind)
        text = palette.text().color()
        self._paint_curve(painter, text)
        top = self._curve_height + _AIR
        for block in self._blocks:
            left, right = max(self.x_of(block.begin), 0.0), min(self.x_of(block.end), float(self.width()))
            if right < 0 or left > self.width():
                continue
            place = QRectF(left, top, max(right - left, 1.0), _BLOCKS)
            painter.fillRect(place, QColor(block.color))
            painter.setPen(behind)
            painter.drawLine(place.topLeft(), place.bottomLeft())
            painter.setPen(QColor("#ffffff"))
            label = painter.fontMetrics().elidedText(block.label, Qt.ElideRight, int(place.width()) - 6)
            if len(label) > 1:
                painter.drawText(place.adjusted(3, 0, -3, 0), int(Qt.AlignVCenter | Qt.AlignLeft), label)
        painter.setPen(Qt.NoPen)
        # Warnings of one colour at the same pixel are drawn once.
        for x, color in dict.fromkeys((round(self.x_of(warned.seconds)), warned.color) for warned in self._warned):
            painter.setBrush(QColor(color))
            painter.drawPolygon(QPolygonF([QPointF(x - _MARK, 0), QPointF(x + _MARK, 0), QPointF(x, 2 * _MARK)]))
        painter.setPen(QPen(text, 2))
        x = self.x_of(self.seconds)
        painter.drawLine(QPointF(x, 0), QPointF(x, self.height()))
        if self.hasFocus():
            painter.setPen(QPen(palette.highlight().color(), 1))
            painter.setBrush(Qt.NoBrush)
            painter.drawRect(QRectF(0.5, 0.5, self.width() - 1, self.height() - 1))

    def _paint_curve(self, painter: QPainter, text: QColor) -> None:
        """Paint the curve of the removal rate, and below it the air cuts."""
        if not len(self._volumes) or not self.total:
            return
        height = self._curve_height
        if self._curve is None or self._curve[0] != self.size():
            rate, air = self._by_column(self.width())
            self._curve = self.size(), _area(rate, height), air
        _, curve, air = self._curve
        fill = QColor(text)
        fill.setAlpha(110)
        painter.setPen(Qt.NoPen)
        painter.setBrush(fill)
        painter.drawPolygon(curve)
        hatch = QColor("#e0a030")
        first, last = np.searchsorted(self._ends, (self._begin, self._end))
        if last - first < self.width() / _APART:
            painter.setPen(QPen(text, 1))
            for end in self._ends[first:last].tolist():
                painter.drawLine(QPointF(self.x_of(end), height), QPointF(self.x_of(end), height + _AIR))
            painter.setPen(Qt.NoPen)
        for x in np.flatnonzero(air > 0.02).tolist():
            hatch.setAlphaF(min(1.0, 0.25 + float(air[x])))
            painter.fillRect(QRectF(x, height, 1, _AIR), hatch)

    def _by_column(self, width: int) -> tuple[np.ndarray, np.ndarray]:
        """Return the removed volume and the share of time spent on air cuts, for each column of pixels."""
        edges = np.linspace(self._begin, self._end, width + 1)
        removed = np.diff(np.interp(edges, self._ends, np.append(0, np.cumsum(self._volumes))))
        air = np.where(self._air, np.diff(self._ends), 0.0)
        share = np.diff(np.interp(edges, self._ends, np.append(0, np.cumsum(air)))) * width / self._span
        return removed, share

    def _move_on(self, share: float) -> None:
        self.moved.emit(min(max(self.seconds + share * self.total, 0.0), self.total))

    def mousePressEvent(self, event) -> None:
        if event.button() != Qt.LeftButton:
            return
        x, y = event.pos().x(), event.pos().y()
        near = [w.seconds for w in self._warned if y <= 2 * _MARK and abs(x - self.x_of(w.seconds)) <= _MARK]
        self._pressed = None if near else event.pos()
        self.moved.emit(near[0] if near else self.seconds_at(x))

    def mouseMoveEvent(self, event) -> None:
        x = event.pos().x()
        if event.buttons() & Qt.LeftButton:
            if self._pressed is None or abs(x - self._pressed.x()) >= QApplication.startDragDistance():
                self._pressed = None
                self.moved.emit(self.seconds_at(x))
            return
        seconds = self.seconds_at(x)
        near = [w for w in self._warned if abs(x - self.x_of(w.seconds)) <= _MARK][:_MAX_WARNINGS]
        near = [w.text() for w in near]
        near += [b.tooltip for b in self._blocks if b.begin <= seconds <= b.end][:1]
        if event.pos().y() < self._curve_height + _AIR:
            near.append(translate("Vk_Simulate", "Gray: removal rate. Orange: cuts air. Triangles: warnings."))
        show_tooltip(self.mapToGlobal(event.pos()), lines("\n".join(near)), self)

    def mouseReleaseEvent(self, event) -> None:
        if event.button() == Qt.LeftButton and self._pressed is not None:
            self.clicked.emit(self.seconds_at(self._pressed.x()))
            self._pressed = None

    def wheelEvent(self, event) -> None:
        """Zoom around the moment under the mouse pointer."""
        at = self.seconds_at(event.position().x())
        span = max(self._span * _ZOOM ** (-event.angleDelta().y() / 120), self.total * _MIN_SPAN)
        self._see(at - (at - self._begin) / self._span * span if self._span else 0.0, span)


def _area(rate: np.ndarray, height: int) -> QPolygonF:
    """Return the area below the curve of the removal rate; `rate` has one value for each column of pixels."""
    tops = height - rate / max(rate.max(initial=0.0), 1e-300) * (height - 4)
    sides = QPointF(0, height), QPointF(len(tops), height)
    return QPolygonF([sides[0], *(QPointF(x, y) for x, y in enumerate(tops.tolist())), sides[1]])
