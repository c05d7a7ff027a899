# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paint the three plots of one area: toolpath, Gauss map and angular functions.

The parts that depend on the chosen trajectory k are painted over the parts that do not depend on k, which the widget
stores as an image. Texts on the plots are the paper's symbols and the names of strategies.
"""

from __future__ import annotations

import math

import numpy as np

from vkworkbench.core import Family, Strategy
from vkworkbench.core.paper import image_arcs, level_of, thinned, turns_of
from vkworkbench.gui.gauss.plot import Plot, ticks
from vkworkbench.gui.gauss.reading import Polyline, Reading
from vkworkbench.gui.gauss.theme import Theme
from vkworkbench.gui.qt.colors import readable
from vkworkbench.gui.qt.names import QColor, QFontMetrics, QPainter, QPen, QPointF, QPolygonF, QRectF, Qt
from vkworkbench.gui.qt.sentences import strategy_name, user

TRAIL = 1000  # number of trajectories before trajectory k that are highlighted and drawn on the Gauss map
_COLUMNS = 1000  # number of parts of a curve, in each of which `thinned` keeps at most four points
_MARKERS = 500
_WIDE = 1.8  # minimum ratio of width to height for three plots in one row
_MIN_PLOT = 90  # minimum height of a plot, px
_GROWTH = 0.5  # difference between the radii of the first and the last arc on the Gauss map, which form a spiral
_GAP = 10  # px between two plots
_FULL = 2 * np.pi
_ROUNDING = 1e-6  # rounding error of an angle, rad
_EDGE = 0.04  # margin in a plot, as a share of its data's size


class GaussFigure:
    """The three plots of one monotonous area, in any size."""

    def __init__(self, reading: Reading, area: int) -> None:
        self.reading, self.area = reading, area
        self.signature = signature = reading.areas.signature(area)
        self.vertices = signature.vertices
        self._own = Polyline(self.vertices)
        self.k = len(signature) - 1
        self.phi, self.level = signature.phi, signature.level
        # In a closed path, append the turn from the last move to the first move.
        if signature.total_turning != signature.phi[-1]:
            self.phi = np.append(self.phi, signature.total_turning)
            self.level = np.append(self.level, level_of(signature.total_turning))
        corner, opposite = (find(reading.outline.points, axis=0) for find in (np.nanmin, np.nanmax))
        edge = _EDGE * max(float((opposite - corner).max()), 1e-3)
        self.path = Plot(corner - edge, opposite + edge, equal=True)
        self.circle = Plot((-1.6, -1.6), (1.6, 1.6), equal=True)
        low, high = min(self.phi.min(), signature.theta_level.min()), max(self.phi.max(), signature.theta_level.max())
        low, high = min(low, self.limits[0] - 0.15 * _FULL), max(high, self.limits[1] + 0.15 * _FULL)
        edge = _EDGE * (high - low)
        self.graph = Plot((1, low - edge), (max(len(self.phi), 2), high + edge), equal=False)

    def plot_at(self, at: QPointF) -> Plot | None:
        """Return the zoomable plot at a pixel, or None."""
        return next((plot for plot in (self.path, self.graph) if plot.place.contains(at)), None)

    @staticmethod
    def min_height(text: QFontMetrics) -> int:
        """Return the minimum height of three plots in one row, px."""
        return 4 * text.height() + 10 + _MIN_PLOT

    def lay_out(self, width: float, height: float, text: QFontMetrics, top: float = 0.0) -> None:
        """Arrange the plots side by side, or, in a narrow widget, the graph below the other two plots."""
        self._width = width
        line = text.height()
        left, right, below = 62.0, 8.0, line + 6.0
        above = 2 * line + 4.0  # height of the two lines of text above the graph, px
        height -= top
        if width > _WIDE * height or height < 2 * self.min_height(text):
            each = (width - 2 * _GAP) / 3.5
            tall = height - below - _GAP - line
            self.path.place = QRectF(left, top + line, each - left, tall)
            self.circle.place = QRectF(each + _GAP, top, each, height)
            tall = height - above - below - line
            self.graph.place = QRectF(2 * (each + _GAP) + left, top + above, 1.5 * each - left - right, tall)
        else:
            half = height / 2
            self.path.place = QRectF(left, top + _GAP, width / 2 - left, half - below - _GAP - line)
            self.circle.place = QRectF(width / 2 + _GAP, top, width / 2 - _GAP, half)
            self.graph.place = QRectF(left, top + half + above, width - left - right, half - above - below - line)

    # The following methods paint the parts that do not depend on the chosen trajectory k.

    def paint_still(self, painter: QPainter, theme: Theme) -> None:
        painter.setRenderHint(QPainter.Antialiasing)
        self._paint_path(painter, theme)
        self._paint_circle(painter, theme)
        self._paint_graph(painter, theme)

    def _paint_path(self, painter: QPainter, theme: Theme) -> None:
        plot = self.path
        plot.clip(painter)
        self._paint_polyline(painter, self.reading.outline, _pen(theme.faint, 0.8))
        self._paint_polyline(painter, self.reading.links, _pen(theme.faint, 0.8, Qt.DotLine))
        self._paint_polyline(painter, self._own, _pen(theme.text, 1.1))
        painter.setPen(Qt.NoPen)
        painter.setBrush(QColor(theme.text))
        plot.dots(painter, self.vertices[:1], 3)
        lower, upper = plot.window
        factor, unit = user().length_unit(max(float((upper - lower).max()), 1e-3))

        def name(value: float) -> str:
            return user().number(round(value / factor, 9)).replace("-", "−")

        x_ticks = ticks(lower[0], upper[0], 3, name, factor)
        plot.frame(painter, x_ticks, ticks(lower[1], upper[1], 5, name, factor), QColor(theme.text))
        line = QFontMetrics(painter.font()).height()
        where = QRectF(plot.place.left(), plot.place.bottom() + line + 2, plot.place.width(), line)
        painter.drawText(where, int(Qt.AlignHCenter), unit)

    def _paint_polyline(self, painter: QPainter, line: Polyline, pen: QPen) -> None:
        seen = line.seen(*self.path.window, self.path.share)
        painter.setPen(pen)
        self.path.segments(painter, line.points[seen], line.points[seen + 1])

    def _paint_circle(self, painter: QPainter, theme: Theme) -> None:
        plot = self.circle
        plot.clip(painter)
        painter.setPen(_pen(theme.faint, 0.6))
        plot.segments(painter, np.array([(-1.6, 0), (0, -1.6)]), np.array([(1.6, 0), (0, 1.6)]))
        painter.setPen(_pen(theme.text, 1.2))
        round_ = np.linspace(0, _FULL, 181)
        plot.polyline(painter, np.column_stack(_polar(1.0, round_)))
        painter.setClipping(False)

    def _paint_graph(self, painter: QPainter, theme: Theme) -> None:
        plot, signature = self.graph, self.signature
        self._paint_bounds(painter, theme)
        for values, pen, steps in (
            (_FULL * self.level, _pen(theme.faint, 2.5), True),
            (signature.theta_level, _pen(theme.v, 1.0), False),
            (self.phi, _pen(theme.counter_clockwise, 1.6), False),
        ):
            k = self._seen(values)
            points = np.column_stack([k + 1, values[k]])
            if steps:
                points = np.repeat(points, 2, axis=0)
                points = np.column_stack([points[1:, 0], points[:-1, 1]])
            painter.setPen(pen)
            plot.polyline(painter, points)
        painter.setPen(_pen(theme.text, 1.2))
        arrivals = signature.reversals + 1
        if len(arrivals) > _MARKERS:
            arrivals = arrivals[np.linspace(0, len(arrivals) - 1, _MARKERS).astype(int)]
        plot.crosses(painter, np.column_stack([arrivals + 1, signature.phi[arrivals]]), 3)
        lower, upper = plot.window
        text = QFontMetrics(painter.font())
        rows = max(2, int(plot.place.height() / (1.8 * text.height())))
        in_turns = ticks(lower[1], upper[1], min(rows, 9), _in_turns, _FULL, whole=upper[1] - lower[1] > 2 * _FULL)
        many = max(2, int(plot.place.width() / 90))
        steps = ticks(lower[0], upper[0], many, lambda k: user().count(round(k)), whole=True)
        plot.frame(painter, steps, in_turns, QColor(theme.text))
        place, line = plot.place, text.height()
        painter.drawText(
            QRectF(place.left(), place.bottom() + line + 2, place.width(), line), int(Qt.AlignHCenter), "k"
        )
        self._paint_names(painter, theme)

    def _seen(self, values: np.ndarray) -> np.ndarray:
        """Return the indices of the values to draw in the visible range of the graph, (m,)."""
        lower, upper = self.graph.window
        first = int(np.clip(math.floor(lower[0]) - 2, 0, len(values) - 1))
        last = int(np.clip(math.ceil(upper[0]) + 1, first + 1, len(values)))
        return first + thinned(values[first:last], _COLUMNS)

    def _paint_bounds(self, painter: QPainter, theme: Theme) -> None:
        """Draw the limits of phi as dashed lines, highlighted if phi meets the paper's condition for the strategy."""
        plot = self.graph
        plot.clip(painter)
        painter.setPen(
            _pen(self._strong(theme), 2.2, Qt.DashLine) if self.bound else _pen(theme.faint, 1.0, Qt.DashLine)
        )
        x = plot.window[0][0], plot.window[1][0]
        for limit in self.limits:
            ends = plot.pixels([(x[0], limit), (x[1], limit)])
            painter.drawLine(QPointF(*ends[0]), QPointF(*ends[1]))

    def _strong(self, theme: Theme) -> str:
        """Return the colour of highlighted limits of phi: the colour of the strategy, made readable."""
        return readable(QColor(self._strategy.color), QColor(theme.back))

    @property
    def _strategy(self) -> Strategy:
        return self.reading.recognition.strategy

    @property
    def limits(self) -> tuple[float, float]:
        """Lower and upper limit of phi, rad: one turn below and above 0, for rows below and above the middle of phi.

        The first move of a zigzag can have any direction, so the middle of the zigzag's phi differs from 0.
        """
        rows = self._strategy.family is Family.ROWS
        middle = float(self.phi.min() + self.phi.max()) / 2 if rows else 0.0
        return middle - _FULL, middle + _FULL

    @property
    def bound(self) -> str:
        """The condition on phi from which the paper's rule concludes this strategy; empty if phi does not meet it."""
        low, high = self.limits
        inside = low + _ROUNDING < self.phi.min() and self.phi.max() < high - _ROUNDING
        name = strategy_name(self._strategy)
        if self._strategy.family is Family.ROWS and inside:
            level_0 = np.abs(self.phi).max() < _FULL - _ROUNDING
            return f"n = 0: {name}" if level_0 else f"(max φ − min φ)/2π < 2: {name}"
        if self._strategy.family is Family.AROUND and not inside:
            return f"|n| ≥ 1: {name}"
        return ""

    def _paint_names(self, painter: QPainter, theme: Theme) -> None:
        """Write the names of the curves and the condition on phi above the graph; long texts begin farther left."""
        text = QFontMetrics(painter.font())
        entries = [("n", theme.faint), ("θ/2π + n", theme.v), ("φ/2π", theme.counter_clockwise)]
        if len(self.signature.reversals):
            entries.append(("× Δφ = ±π", theme.text))
        bound, gap = self.bound, 22
        widths = [text.horizontalAdvance(name) for name, _ in entries]
        left, y = self.graph.place.left(), self.graph.place.top() - text.height() - 4
        x = min(left, self._width - sum(widths) - gap * (len(widths) - 1))
        for (name, color), width in zip(entries, widths):
            painter.setPen(QColor(color))
            painter.drawText(QPointF(x, y + text.ascent()), name)
            x += width + gap
        painter.setPen(QColor(self._strong(theme)))
        painter.drawText(QPointF(min(left, self._width - text.horizontalAdvance(bound)), y - text.descent()), bound)

    # The following methods paint the parts that depend on the chosen trajectory k.

    def paint_moving(self, painter: QPainter, theme: Theme) -> None:
        painter.setRenderHint(QPainter.Antialiasing)
        self._paint_trail(painter, theme)
        self._paint_images(painter, theme)
        self._paint_now(painter, theme)
        painter.setClipping(False)

    def _paint_trail(self, painter: QPainter, theme: Theme) -> None:
        plot, k = self.path, self.k
        plot.clip(painter)
        since = max(0, k + 1 - TRAIL)
        painter.setPen(_pen(theme.counter_clockwise, 1.8))
        plot.polyline(painter, self.vertices[since : k + 2])
        tail, tip = plot.pixels(self.vertices[[0, k + 1]])
        painter.setPen(_pen(theme.v, 2))
        painter.drawLine(QPointF(*tail), QPointF(*tip))
        way = tip - tail
        length = float(np.hypot(*way))
        if length > 1:
            along, across = way / length * 10, np.array([-way[1], way[0]]) / length * 4
            painter.setBrush(QColor(theme.v))
            corners = (tip, tip - along + across, tip - along - across)
            painter.drawPolygon(QPolygonF([QPointF(*corner) for corner in corners]))
        _name(painter, tip + (6, -6), "V", "k", theme.v)

    def _paint_images(self, painter: QPainter, theme: Theme) -> None:
        plot, k, signature = self.circle, self.k, self.signature
        plot.clip(painter)
        since = max(0, k + 1 - TRAIL)
        window = slice(since, k + 1)
        grown = _GROWTH * (np.arange(since, k + 1) - since) / min(len(signature), TRAIL)
        for angle, radius in ((signature.alpha[window], 1.06 + grown), (signature.theta[window], 0.94 - grown)):
            for color, points in zip((theme.counter_clockwise, theme.clockwise), image_arcs(angle, radius)):
                painter.setPen(_pen(color, 1.4))
                if len(points):
                    plot.polyline(painter, points)
        angle = signature.alpha[window]
        halves = np.flatnonzero(np.isnan(turns_of(angle))) + 1
        painter.setPen(_pen(theme.text, 1.2))
        plot.crosses(painter, np.column_stack(_polar(1.06 + grown[halves], angle[halves])), 3)
        of_v, of_sum = (signature.alpha[k], theme.text, "v", -0.22), (signature.theta[k], theme.v, "V", 0.22)
        for at, color, letter, aside in (of_v, of_sum):
            image = np.array([_polar(1.0, at)])
            painter.setPen(_pen(color, 1.6))
            plot.segments(painter, np.zeros((1, 2)), image)
            painter.setBrush(QColor(color))
            plot.dots(painter, image, 3.5)
            # Shift the letters, so that the letters of two equal directions do not overlap.
            _name(painter, plot.pixels([_polar(0.8, at + aside)])[0], letter, "k", color)

    def _paint_now(self, painter: QPainter, theme: Theme) -> None:
        plot, k = self.graph, self.k
        plot.clip(painter)
        lower, upper = plot.window
        painter.setPen(_pen(theme.text, 1))
        plot.segments(painter, np.array([(k + 1, lower[1])]), np.array([(k + 1, upper[1])]))
        painter.setPen(Qt.NoPen)
        for values, color in ((self.signature.phi, theme.counter_clockwise), (self.signature.theta_level, theme.v)):
            painter.setBrush(QColor(color))
            plot.dots(painter, np.array([(k + 1, values[k])]), 3.5)


def _pen(color: str, width: float, style=Qt.SolidLine) -> QPen:
    return QPen(QColor(color), width, style)


def _name(painter: QPainter, at: np.ndarray, letter: str, index: str, color: str) -> None:
    """Write a letter with a small index."""
    painter.setPen(QColor(color))
    text = QFontMetrics(painter.font())
    painter.drawText(QPointF(*at), letter)
    painter.save()
    font = painter.font()
    if font.pointSizeF() > 0:
        font.setPointSizeF(0.75 * font.pointSizeF())
    painter.setFont(font)
    painter.drawText(QPointF(at[0] + text.boundingRect(letter).width() + 2, at[1] + 3), index)
    painter.restore()


def _polar(radius, angle) -> tuple:
    return radius * np.cos(angle), radius * np.sin(angle)


def _in_turns(value: float) -> str:
    return user().number(round(value / _FULL, 6)).replace("-", "−")
