# SPDX-License-Identifier: LGPL-2.1-or-later
"""The widget with the three plots of the Gauss map panel.

The mouse wheel zooms a plot, dragging pans, and a double click shows all data again.
"""

from __future__ import annotations

from vkworkbench.gui.gauss.figure import GaussFigure
from vkworkbench.gui.gauss.theme import theme_on
from vkworkbench.gui.qt.names import (
    QColor,
    QFontMetrics,
    QImage,
    QPainter,
    QPixmap,
    QPointF,
    QRectF,
    Qt,
    QWidget,
    svg_generator,
)  # fmt: skip

_NOTCH = 120  # turn of a wheel by one notch, in eighths of a degree
_STEP = 0.8  # after zooming in by one notch, this share of the visible range stays visible
_SCALE = 2  # resolution of a saved image, as a multiple of the screen's resolution


class GaussCanvas(QWidget):
    """Paints the three plots. The parts that do not depend on the chosen trajectory k are painted only once."""

    def __init__(self) -> None:
        super().__init__()
        self.figure: GaussFigure | None = None
        self.theme = theme_on(QColor("white"))
        self._still: QPixmap | None = None
        self._dragged = None
        self._from = QPointF()

    def set_background(self, color: QColor) -> None:
        """Use colours that are readable on this background."""
        theme = theme_on(color)
        if theme != self.theme:
            self.theme = theme
            self._repaint()

    def show_figure(self, figure: GaussFigure) -> None:
        self.figure = figure
        self._repaint()

    def step(self, k: int) -> None:
        """Show the state after trajectory `k`, counted from 0."""
        self.figure.k = k
        self.update()

    def save(self, path: str, title: str) -> None:
        """Save the plots as shown, with a title, in the format of the path's suffix. Raise OSError if this fails."""
        line = 1.6 * QFontMetrics(self.font()).height()
        width, height = self.width(), int(self.height() + line)
        if path.lower().endswith(".svg"):
            target = svg_generator(path, width, height, title)
        else:
            target = QImage(_SCALE * width, _SCALE * height, QImage.Format_RGB32)
            target.setDevicePixelRatio(_SCALE)
        painter = QPainter()
        if not painter.begin(target):
            raise OSError(f"{path} cannot be written")
        painter.setFont(self.font())
        painter.fillRect(QRectF(0, 0, width, height), QColor(self.theme.back))
        painter.setPen(QColor(self.theme.text))
        painter.drawText(QRectF(8, 0, width - 16, line), int(Qt.AlignVCenter), title)
        self.figure.lay_out(width, height, QFontMetrics(self.font()), top=line)
        self.figure.paint_still(painter, self.theme)
        self.figure.paint_moving(painter, self.theme)
        painter.end()
        self._repaint()
        if isinstance(target, QImage) and not target.save(path):
            raise OSError(f"{path} cannot be written")

    def _repaint(self) -> None:
        self._still = None
        self.update()

    def paintEvent(self, event) -> None:
        if self.figure is None:
            return
        if self._still is None:
            ratio = self.devicePixelRatioF()
            self._still = QPixmap(round(self.width() * ratio), round(self.height() * ratio))
            self._still.setDevicePixelRatio(ratio)
            self._still.fill(QColor(self.theme.back))
            self.figure.lay_out(self.width(), self.height(), QFontMetrics(self.font()))
            painter = QPainter(self._still)
            painter.setFont(self.font())
            self.figure.paint_still(painter, self.theme)
            painter.end()
        painter = QPainter(self)
        painter.drawPixmap(0, 0, self._still)
        painter.setFont(self.font())
        self.figure.paint_moving(painter, self.theme)
        painter.end()

    def resizeEvent(self, event) -> None:
        self._repaint()

    def wheelEvent(self, event) -> None:
        at = QPointF(event.position()) if hasattr(event, "position") else QPointF(event.pos())
        plot = self.figure and self.figure.plot_at(at)
        if plot:
            plot.zoom(_STEP ** (event.angleDelta().y() / _NOTCH), at)
            self._repaint()
        event.accept()

    def mousePressEvent(self, event) -> None:
        if event.button() == Qt.LeftButton and self.figure:
            self._from = QPointF(event.pos())
            self._dragged = self.figure.plot_at(self._from)

    def mouseMoveEvent(self, event) -> None:
        if self._dragged:
            at = QPointF(event.pos())
            self._dragged.move(self._from, at)
            self._from = at
            self._repaint()

    def mouseReleaseEvent(self, event) -> None:
        self._dragged = None

    def mouseDoubleClickEvent(self, event) -> None:
        plot = self.figure and self.figure.plot_at(QPointF(event.pos()))
        if plot:
            plot.home()
            self._repaint()
