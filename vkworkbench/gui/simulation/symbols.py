# SPDX-License-Identifier: LGPL-2.1-or-later
"""Buttons with the symbols of a player, drawn in the colour of the theme's text: a style's own icons are for light themes."""

from __future__ import annotations

from vkworkbench.gui.qt.names import QPainter, QPen, QPointF, QPolygonF, QRectF, Qt, QToolButton, QWidget

PLAY, PAUSE = "play", "pause"
# Lines in a square from -1 to 1, those on by one, two and three; a closed one is filled. Back is their mirror image.
_CHEVRON = [(-0.3, -0.6), (0.3, 0.0), (-0.3, 0.6)]
_TRIANGLE = [(-0.6, -0.7), (0.6, 0.0), (-0.6, 0.7), (-0.6, -0.7)]
_LINES = {
    1: [_CHEVRON],
    2: [[(x - 0.3, y) for x, y in _CHEVRON], [(x + 0.35, y) for x, y in _CHEVRON]],
    3: [[(0.8 * x - 0.15, 0.8 * y) for x, y in _TRIANGLE], [(0.6, -0.6), (0.6, 0.6)]],
    PLAY: [_TRIANGLE],
    PAUSE: [[(-0.35, -0.6), (-0.35, 0.6)], [(0.35, -0.6), (0.35, 0.6)]],
}


class SymbolButton(QToolButton):
    """A button with a symbol.

    Attributes
    ----------
    symbol : int or str
        How far it steps, back where negative; `PLAY` or `PAUSE`.
    """

    def __init__(self, symbol: int | str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.symbol = symbol

    def show_symbol(self, symbol: int | str) -> None:
        """Show another symbol."""
        self.symbol = symbol
        self.update()

    def paintEvent(self, event) -> None:
        super().paintEvent(event)
        painter = QPainter(self)
        painter.setRenderHint(QPainter.Antialiasing)
        color = self.palette().buttonText().color()
        rest = QRectF(self.rect())
        side = min(rest.width(), rest.height()) / 4
        painter.setPen(QPen(color, side / 3.5, Qt.SolidLine, Qt.RoundCap, Qt.RoundJoin))
        symbol = self.symbol
        mirrored = -1 if isinstance(symbol, int) and symbol < 0 else 1
        for line in _LINES[abs(symbol) if isinstance(symbol, int) else symbol]:
            points = [QPointF(rest.center().x() + mirrored * side * x, rest.center().y() + side * y) for x, y in line]
            painter.setBrush(color if line[0] == line[-1] else Qt.NoBrush)
            if line[0] == line[-1]:
                painter.drawPolygon(QPolygonF(points))
            else:
                painter.drawPolyline(QPolygonF(points))
        painter.end()
