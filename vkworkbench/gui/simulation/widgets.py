# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small widgets of the tab: keys, symbol buttons, the legend, and the line that shows the state of the simulation."""

from __future__ import annotations

import traceback
from collections.abc import Callable

import FreeCAD

from vkworkbench.core.zbuffer import PENDING
from vkworkbench.gui.qt.names import (
    QColor,
    QEvent,
    QPainter,
    QPen,
    QPointF,
    QPolygonF,
    QRectF,
    QSize,
    QSizePolicy,
    Qt,
    QToolButton,
    QWidget,
)
from vkworkbench.gui.qt.plain_text import OneLine, as_html
from vkworkbench.gui.qt.sentences import sentence, user
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.simulation.simulating import Simulated, Simulating
from vkworkbench.language import Message, Unusable


class KeyedWidget(QWidget):
    """A widget with its own keyboard shortcuts.

    A shortcut works if the widget, or a child that ignores the key, has the keyboard focus.
    """

    keys: dict[int, Callable[[], object]]  # the function that each key calls

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.keys = {}

    def event(self, event) -> bool:
        if event.type() == QEvent.ShortcutOverride and event.key() in self.keys:
            event.accept()  # without this call, FreeCAD runs its own shortcut for the key
            return True
        return super().event(event)

    def keyPressEvent(self, event) -> None:
        if event.key() in self.keys:
            self.keys[event.key()]()
        else:
            super().keyPressEvent(event)


PLAY, PAUSE = "play", "pause"
# Lines of the symbols for three kinds of steps, for play and for pause, in a square from -1 to 1. Closed lines are
# filled. The symbols for steps back are mirror images of the symbols for steps forward.
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
    """A button with a symbol in the text colour of the theme. The icons of Qt's styles suit only light themes.

    The symbol is a kind of step (1, 2, 3; negative for a step back), `PLAY` or `PAUSE`.
    """

    def __init__(self, symbol: int | str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.symbol = symbol

    def show_symbol(self, symbol: int | str) -> None:
        """Show another symbol on the button."""
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


_GAP = 12  # px between two entries of the legend
_BESIDE = 4  # px between a colour and its name
_MAX_NAMES = 12


class Legend(QWidget):
    """Colours with their names, in as many lines as needed. Long names are shortened; the tooltip shows them in full.

    Consecutive colours without a name belong to a scale and are drawn without gaps in one line, with the next colour
    that has a name.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.entries: tuple[tuple[str, str], ...] = ()
        self.setSizePolicy(QSizePolicy.Ignored, QSizePolicy.Fixed)
        self._fit()

    def show_entries(self, entries: tuple[tuple[str, str], ...]) -> None:
        """Show other entries in the legend."""
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
        """Set the height of the legend to the height of its lines."""
        lines = max((place.bottom() for _, place, _ in self._places()), default=0)
        self.setFixedHeight(max(round(lines), self._line))  # the legend is at least as high as one line

    def _places(self) -> list[tuple[str, QRectF, str]]:
        """Return each colour with the rectangle of its entry and its name, shortened to the width of the legend."""
        metrics, side = self.fontMetrics(), self._side
        height, width = self._line, max(self.width(), 4 * side)
        places, nameless, x, y, named = [], 0, 0.0, 0.0, 0
        for color, name in self.entries:
            named += bool(name)
            if named > _MAX_NAMES:
                break
            before = nameless * side
            shown = metrics.elidedText(name, Qt.ElideRight, width - before - side - _BESIDE)
            wide = side + (_BESIDE + metrics.horizontalAdvance(shown) if shown else 0)
            if x > before and x + wide > width:
                for _, place, _ in places[
                    len(places) - nameless :
                ]:  # move the colours of a scale to the next line together
                    place.translate(before - x, height)
                x, y = before, y + height
            places.append((color, QRectF(x, y, wide, height), shown))
            x += wide + (_GAP if name else 0)
            nameless = 0 if name else nameless + 1
        return places


class StateLine(OneLine):
    """A line that shows the verdict on the job and the progress of the simulation.

    The tooltip of the line shows also the size and the cost of the simulation.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._verdict, self._cost = sentence(PENDING.message(())), ""

    def show_progress(self, simulating: Simulating) -> None:
        """Show the progress in the line, and the expected cost of the finest simulation in the tooltip or the line."""
        working, cost = translate("Vk_Simulate", "Simulating… {}"), ""
        if simulating.checks:
            working = translate("Vk_Simulate", "Checking… {}")
        elif simulating.expected is not None:
            cost = translate("Vk_Simulate", "The finest picture takes about {} and {}.").format(
                user().time(simulating.expected.seconds), user().memory(simulating.expected.memory_bytes)
            )
        self._say(working.format(user().share(simulating.share)), cost)

    def show_simulated(self, done: Simulated) -> None:
        """Store the size and the cost of a simulation, which the tooltip shows together with the next text."""
        zbuffer = done.simulation.zbuffer
        self._cost = translate("Vk_Simulate", "{} × {} pixels of {}, {} traces, {}, simulated in {}").format(
            user().count(zbuffer.frame.width), user().count(zbuffer.frame.height),
            user().measure(zbuffer.frame.pixel, 2), user().count(zbuffer.traces), user().memory(zbuffer.peak.bytes()),
            user().time(done.seconds),
        )  # fmt: skip

    def show_verdict(self, verdict: Message) -> None:
        """Set the verdict on the job, with which all following texts begin."""
        self._verdict = sentence(verdict)

    def show_end(self, remarks: tuple[Message, ...], error: Exception | None) -> None:
        """Show the remarks on the simulation, and the error that ended it, if any."""
        self._say(*map(sentence, remarks), *([error_text(error)] if error else []))

    def show_error(self, error: Exception) -> None:
        """Show the text of an error after the verdict."""
        self._say(error_text(error))

    def _say(self, *texts: str) -> None:
        text = "   ".join(filter(None, (self._verdict, *texts)))
        self.show_text(text)
        self.setToolTip(as_html("\n".join(filter(None, (text, self._cost)))))


def error_text(error: Exception) -> str:
    """Return the text of an error for the user. Log the traceback of an unexpected error."""
    if isinstance(error, Unusable):
        return sentence(error.what)
    FreeCAD.Console.PrintLog("".join(traceback.format_exception(type(error), error, error.__traceback__)))
    return sentence(Message("not-analysed", error=f"{type(error).__name__}: {error}"))
