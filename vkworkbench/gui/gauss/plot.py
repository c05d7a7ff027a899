# SPDX-License-Identifier: LGPL-2.1-or-later
"""One plot with axes, whose visible range of the data can be zoomed and moved."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from vkworkbench.gui.qt.names import QFontMetrics, QLineF, QPainter, QPen, QPointF, QRectF, Qt

_NICE = (1, 2, 5, 10)
_MIN_SHARE, _MAX_SHARE = 1e-6, 4.0  # lower and upper bound of the visible share of the data


class Plot:
    """A plot that shows a rectangular range (the window) of the data."""

    def __init__(self, lower, upper, *, equal: bool) -> None:
        self.place = QRectF()  # rectangle of the plot in the widget, px, without the labels of the axes
        self._equal = equal
        self._home = np.array([lower, upper], float)
        self.home()

    def home(self) -> None:
        """Show all data."""
        self.lower, self.upper = self._home.copy()

    @property
    def share(self) -> float:
        """Visible share of the data: the larger of the shares along the two axes."""
        return float(((self.upper - self.lower) / (self._home[1] - self._home[0])).max())

    @property
    def window(self) -> tuple[np.ndarray, np.ndarray]:
        """Lower and upper corner of the visible range.

        With equal units on both axes, the plot shows along one axis more than the range from `lower` to `upper`.
        """
        size = self.upper - self.lower
        if not self._equal or self.place.isEmpty():
            return self.lower, self.upper
        pixels = np.array([self.place.width(), self.place.height()])
        seen = pixels * (size / pixels).max()
        middle = (self.lower + self.upper) / 2
        return middle - seen / 2, middle + seen / 2

    def pixels(self, points: np.ndarray) -> np.ndarray:
        """Return the positions of data points (n, 2) in the widget, (n, 2) px."""
        lower, upper = self.window
        corner = np.array([self.place.left(), self.place.bottom()])
        extent = np.array([self.place.width(), -self.place.height()])
        return corner + (np.asarray(points, float) - lower) / (upper - lower) * extent

    def data(self, at: QPointF) -> np.ndarray:
        """Return the data point at a pixel, (2,)."""
        lower, upper = self.window
        right, up = at.x() - self.place.left(), self.place.bottom() - at.y()
        return lower + (upper - lower) * (right / self.place.width(), up / self.place.height())

    def zoom(self, factor: float, at: QPointF) -> None:
        """Show `factor` times as much data. The data point at the pixel `at` keeps its place."""
        lower, upper = self.window
        factor = min(max(factor, _MIN_SHARE / self.share), _MAX_SHARE / self.share)
        fixed = self.data(at)
        self.lower, self.upper = fixed + (lower - fixed) * factor, fixed + (upper - fixed) * factor

    def move(self, begin: QPointF, end: QPointF) -> None:
        """Move the data point at one pixel to another pixel."""
        by = self.data(begin) - self.data(end)
        self.lower, self.upper = self.lower + by, self.upper + by

    # Drawing.

    def polyline(self, painter: QPainter, points: np.ndarray) -> None:
        """Draw a polyline (n, 2), interrupted at NaN."""
        self.segments(painter, points[:-1], points[1:])

    def segments(self, painter: QPainter, a: np.ndarray, b: np.ndarray) -> None:
        """Draw segments from the points `a` to the points `b`, both (n, 2)."""
        lines = np.column_stack([self.pixels(a), self.pixels(b)])
        lines = lines[np.isfinite(lines).all(axis=1)]
        # Qt's renderers are slow or wrong for coordinates far outside the window.
        lines = np.clip(lines, -1e4, 1e4).tolist()
        if lines:
            painter.drawLines([QLineF(*line) for line in lines])

    def dots(self, painter: QPainter, points: np.ndarray, radius: float) -> None:
        """Draw a filled circle at each point (n, 2); `radius` in px."""
        for x, y in self.pixels(points).tolist():
            painter.drawEllipse(QPointF(x, y), radius, radius)

    def crosses(self, painter: QPainter, points: np.ndarray, size: float) -> None:
        """Draw a cross at each point (n, 2), `size` px to each side."""
        for x, y in self.pixels(points).tolist():
            painter.drawLine(QPointF(x - size, y - size), QPointF(x + size, y + size))
            painter.drawLine(QPointF(x - size, y + size), QPointF(x + size, y - size))

    def clip(self, painter: QPainter) -> None:
        """Limit painting to the plot's rectangle."""
        painter.setClipRect(self.place)

    def frame(self, painter: QPainter, x_ticks: list, y_ticks: list, color) -> None:
        """Draw the border, and ticks with labels: (value, text) below and on the left."""
        painter.setClipping(False)
        painter.setPen(QPen(color, 1))
        painter.setBrush(Qt.NoBrush)
        painter.drawRect(self.place)
        text = QFontMetrics(painter.font())
        height, lower = text.height(), self.window[0]
        for value, name in x_ticks:
            x = float(self.pixels([(value, lower[1])])[0, 0])
            painter.drawLine(QPointF(x, self.place.bottom()), QPointF(x, self.place.bottom() + 3))
            box = QRectF(x - 60, self.place.bottom() + 4, 120, height)
            painter.drawText(box, int(Qt.AlignHCenter | Qt.AlignTop), name)
        x = self.place.left()
        for value, name in y_ticks:
            y = float(self.pixels([(lower[0], value)])[0, 1])
            painter.drawLine(QPointF(x, y), QPointF(x - 3, y))
            painter.drawText(QRectF(x - 66, y - height / 2, 60, height), int(Qt.AlignRight | Qt.AlignVCenter), name)


def ticks(
    low: float, high: float, count: int, name: Callable[[float], str], unit: float = 1.0, whole: bool = False
) -> list[tuple[float, str]]:
    """Return about `count` round values between `low` and `high`, each with the text that `name` returns for it.

    The values are round multiples of `unit`; if `whole` is True, integer multiples.
    """
    rough = (high - low) / unit / max(count, 1)
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(nice * power for nice in _NICE if nice * power >= rough * 0.999)
    step = max(step, 1.0) if whole else step
    first, last = math.ceil(low / unit / step - 1e-9), math.floor(high / unit / step + 1e-9)
    return [(i * step * unit, name(i * step * unit)) for i in range(first, last + 1)]
